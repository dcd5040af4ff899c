// Materials as Mitsuba's BSDFs.
#pragma once

#include "app/export_mitsuba.h"

#include <set>

namespace raylab::app::mitsuba {

// The name by which other elements refer to the material.
std::string id(const Scene& scene, int material);

class Materials {
  public:
    // bsdf() adds the textures that it uses to `files`.
    Materials(const Scene& scene, std::vector<ExportedFile>& files)
        : scene_(scene), files_(files) {}

    // The element that defines the material. Throws UsageError if Mitsuba has no such material.
    std::string bsdf(int material);

  private:
    std::string reflectance(const Material& material, const char* name);

    const Scene& scene_;
    std::vector<ExportedFile>& files_;
    std::set<int> written_textures_;
};

} // namespace raylab::app::mitsuba
