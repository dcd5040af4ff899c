// What programs that were not written for raylab need beyond rewrite.h, and what is refused to
// them.
#pragma once

#include <string>
#include <string_view>

namespace raylab::simt {

// Why the CPU machine does not have what this header declares ("cublas_v2.h"), or nothing.
// `has_thrust`: thrust is installed.
std::string refused_header(std::string_view header, bool has_thrust);

// Whether the text of an asm statement is PTX, and not an instruction of the host's processor.
bool is_ptx(std::string_view text);

} // namespace raylab::simt
