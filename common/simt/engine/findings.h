// Where the engine writes down what it finds, and what it did: see common/simt/finding.h.
#pragma once

#include "common/simt/finding.h"

#include <cstdint>

namespace raylab::simt {

// Writes the finding, with the machine's mode unless it has one, to the file named by
// RAYLAB_FINDINGS; does nothing without one. Any thread may call.
void record(Finding finding);
void record(const AccessCost& cost);

// Whether anybody reads findings.
bool records_findings();

// The finding that a report of the engine is about ("f.cu:8: error: ..."; see report.h).
Finding finding_of_report(const std::string& report);

// Counted for the summary.
void count_launch(std::uint64_t threads);
void count_allocation(std::uint64_t bytes);

// Writes the summary, for ends of the program that nobody else would notice.
void write_summary();

} // namespace raylab::simt
