#pragma once

#include "interpreter/joint_parts.hpp"
#include "interpreter/model.hpp"
#include "random_mechanism.hpp"

namespace treeline::tests {

/// Entries in [-size, size), exact doubles in any `Scalar`.
template <class Scalar>
interpreter::Vector<Scalar> random_entries(Rng& rng, int count, double size) {
  interpreter::Vector<Scalar> x(count);
  for (int i = 0; i < count; ++i) x(i) = Scalar(rng.uniform(-size, size));
  return x;
}

/// Displacements and angles in [-size, size), and quaternions of unit length in the precision of
/// `Scalar`, in any direction.
template <class Scalar>
interpreter::Vector<Scalar> random_position(Rng& rng, const interpreter::Model<Scalar>& model,
                                            double size = 3) {
  using std::sqrt;
  interpreter::Vector<Scalar> q = random_entries<Scalar>(rng, model.nq, size);
  for (const auto& body : model.bodies) {
    const int first = interpreter::quaternion_of(body);
    if (first < 0) continue;
    auto quaternion = q.template segment<4>(first);
    quaternion /= Scalar(sqrt(quaternion.squaredNorm()));
  }
  return q;
}

}  // namespace treeline::tests
