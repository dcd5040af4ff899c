// The kernel of task 2.6 alone, where it is seen whether a count was added to by an atomic
// operation.
#pragma once

namespace raylab::lab02 {

// How many counts and shadow rays the kernel has changed in another way, for so many paths that all
// end in bounce 0.
int changed_without_atomics(int paths);

} // namespace raylab::lab02
