// Figures as text: for tables and for CSV (RFC 4180).
#pragma once

#include "grader/bench/statistics.h"

#include <optional>
#include <string>

namespace raylab::bench {

// fmt's format of a double; "-" if it is not finite.
std::string figure(double value, const char* format);

// "3.1 [2.9, 3.4]": the median over its interval, an end of which may be open; "-": not known.
std::string with_interval(const Measured& m, int digits = 4);
std::string ratio_text(const std::optional<Measured>& ratio);

// A field of CSV, quoted if need be, with its quotes doubled. Unknown figures are empty fields.
std::string csv_text(const std::string& text);
std::string csv_number(double value);

// Three fields: median, low, high.
std::string csv_measured(const Measured& m);
std::string csv_measured(const std::optional<Measured>& m);
std::string header_of(const char* name); // of such three, and a comma behind them

} // namespace raylab::bench
