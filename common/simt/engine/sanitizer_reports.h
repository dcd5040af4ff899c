// What the sanitizers say, as findings: they call back before they write a report of their own.
// Nothing in an ordinary build.
#pragma once

namespace raylab::simt {

// To be called by host code between launches: records the races that were reported meanwhile. A
// callback cannot, for the sanitizer holds its locks then.
void record_races();

// For the callback of UndefinedBehaviorSanitizer.
void record_undefined_behaviour();

} // namespace raylab::simt
