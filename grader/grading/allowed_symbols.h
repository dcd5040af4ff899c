// Which names a submission may define and use beside those that the solution has: rules over
// mangled names (Itanium C++ ABI: _ZN6raylab5lab02... is raylab::lab02::...).
#pragma once

#include <string>
#include <string_view>

namespace raylab::grading {

// Whether the entity, or the one that a vtable, guard or type information belongs to, is in the
// namespace with this mangled beginning: "7testing", "6raylab4task".
bool is_of(std::string_view name, std::string_view scope);

bool may_define(std::string_view name, const std::string& lab_number);        // strongly
bool may_define_weakly(std::string_view name, const std::string& lab_number); // inline, templates
bool may_use(std::string_view name);

} // namespace raylab::grading
