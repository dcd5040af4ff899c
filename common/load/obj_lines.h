// The words of an OBJ or MTL file, statement by statement.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

struct ObjWord {
    std::string_view text;
    int line = 0, column = 0; // both counted from 1
};

// Cuts a text into statements. A statement is a line, ended by LF, CR or both; where the last
// character of a line is a backslash, the next line belongs to it too. Text after # is a comment. A
// byte order mark is skipped.
class ObjLines {
  public:
    explicit ObjLines(std::string_view text);

    // The words of the next statement that has any; none at the end of the text. Valid as long as
    // the text is.
    const std::vector<ObjWord>& next();

    // The last statement's text from its second word on, blanks included: names may have them.
    // Only of its first line.
    std::string_view rest() const { return rest_; }

  private:
    void split(std::string_view line);

    std::string_view text_, rest_;
    std::vector<ObjWord> words_;
    int line_ = 0;
};

} // namespace raylab
