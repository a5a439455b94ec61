#pragma once

#include "simulation/state.hpp"

namespace treeline::simulation {

/// The most touches of a blow.
inline constexpr int kMostTouches = 64;

/// Overlap of two shapes, as a single point; or a joint at its stop, whose `normal` is x or -x of
/// an axis of its own, for coordinates that grow or fall on the way out.
struct Touch {
  int shape = 0;  ///< index of a shape
  int other = 0;
  int body = 0;  ///< body that carries `shape`
  int other_body = interpreter::kWorld;
  Vector3 position = Vector3::Zero();  ///< middle of the overlap, world axes
  Vector3 normal = Vector3::UnitZ();   ///< pointing out of `other`, world axes
  double depth = 0;                    ///< m; negative where they do not touch yet
  int joint = -1;      ///< velocity of a joint at its stop; such a touch is of no body
  int point = 0;       ///< which of the shape's, where it has several
  double allowed = 0;  ///< m/s: a blow may leave so much approach; none where they overlap
  Vector3 start = Vector3::Zero();  ///< N s, a guess of the impulse on `body`
};

}  // namespace treeline::simulation
