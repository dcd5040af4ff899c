// A place for operations that are member functions, and not macros as in collectives.h: the file
// and line of the call stand for it, so two calls on one line are one place.
#pragma once

#include "common/simt/site.h"
#include "common/simt/where.h"

namespace raylab::simt {

// Always the same object for the same operation and place.
const Site& site_of(const char* operation, const Where& where);

} // namespace raylab::simt
