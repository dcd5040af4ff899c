// Does what a program prints depend on the order in which its threads run?
#pragma once

#include "app/run/execute.h"

namespace raylab::app {

// `runs`: of one program, each with its order; the first two have the same one. A finding for the
// first line that another order changes; nothing where already two equal runs differ, as programs
// that print times do, or numbers differ by no more than sums of floats in another order.
std::vector<simt::Finding> order_dependence(const std::vector<Execution>& runs,
                                            const std::string& source);

} // namespace raylab::app
