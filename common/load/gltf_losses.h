// What a file has and raylab does not read: one warning that lists it all.
#pragma once

#include <map>
#include <string>

namespace raylab {

class GltfLosses {
  public:
    // What is lost, in the plural ("normal maps"), and where ("material"): once for each call.
    void add(const std::string& what, const std::string& where) { ++count_[{what, where}]; }

    // "m.glb: read without normal maps (3 materials), cameras (1 node)"; empty if nothing is lost.
    std::string sentence(const std::string& name) const;

  private:
    std::map<std::pair<std::string, std::string>, int> count_;
};

} // namespace raylab
