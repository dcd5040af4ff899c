// Tail probabilities of the three distributions the judge decides with.
#pragma once

namespace raylab {

// P(|T| >= |t|) of Student's t with `dof` > 0 degrees of freedom (need not be whole; infinity is
// the normal distribution). Relative error below 1e-12 also far out in the tail.
double student_t_two_sided(double t, double dof);

// The t with student_t_two_sided(t, dof) = p.
double student_t_quantile(double p, double dof);

// P(F >= f) of Fisher's F with 2 and `dof` > 0 degrees of freedom: (1 + 2 f / dof)^(-dof / 2).
double f2_tail(double f, double dof);

} // namespace raylab
