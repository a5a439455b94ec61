#pragma once

#include <cstdint>
#include <vector>

namespace treeline {

// What the headers take as known. They leave out what a robot does not need; here they have all.
#define TL_INLINE
#define TL_FOLDED
#define TL_SHARED
#define TL_NONE nullptr
#define TL_REAL(number) real(number)
#define TL_SLIDING true
#define TL_DRIVEN true
#define TL_RUBBING true
#define TL_OWN_SINES TL_COUPLED
#define TL_BALLS true
#define TL_PUSHED true
#define TL_LOADED true
#define TL_SORTED true
#define TL_STEPPED true
#define TL_GROUNDED true
#define TL_FREED true
#define TL_TURNING true

// Vectors stand here where emitted code has arrays, which indices of any sign may index.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"

/// The loops over a table of links, `runtime/emitted/link_*.h`, in any kind of number and for any
/// robot.
template <class Number>
struct EmittedLinks {
  using real = Number;
  const real TL_ZERO = real(0.0);
  const real TL_ONE = real(1.0);
  const bool TL_FLOATS;       ///< the first link is a floating base
  const bool TL_COUPLED;      ///< joints share coordinates
  const bool TL_GIVEN_SINES;  ///< sines and cosines of coordinates are arguments

#include "emitted/link_types.h"

  struct TlLinkPoses {
    std::vector<TlLinkPose> joints;
    std::vector<TlLinkRotation> rotations;
    const real* sin_q = nullptr;
    const real* cos_q = nullptr;
  };
  struct TlMotionWork {
    TlLinkPoses poses;
    std::vector<TlSpatial> wrenches;
    std::vector<TlLinkMotion> motions;
  };
  struct TlMatrixWork {
    std::vector<TlLinkFrame> frames;
    std::vector<TlLinkBody> bodies;
    std::vector<real> f_x, f_y, f_z, n_x, n_y, n_z;
  };
  struct TlFactorWork {
    std::vector<TlLinkInertia> inertias;
    std::vector<TlLinkProjection> projections;
    TlMatrixWork matrix;
    std::vector<real> base;
  };
  struct TlRowWork {
    std::vector<TlLinkAxes> link_axes;
    std::vector<TlLinkMotion> point_motions;
    std::vector<TlSpatial> forces;
    std::vector<std::int16_t> links;
    std::vector<real> errors, Lambda_inv, inverse_borders;
  };

  void tl_sin_cos_of(const real& x, real* sine, real* cosine) {
    sin_cos(x, *sine, *cosine);
  }

#include "emitted/link_articulation.h"
#include "emitted/link_factored.h"
#include "emitted/link_factors.h"
#include "emitted/link_friction.h"
#include "emitted/link_functions.h"
#include "emitted/link_inertia.h"
#include "emitted/link_inputs.h"
#include "emitted/link_joints.h"
#include "emitted/link_matrix.h"
#include "emitted/link_motion.h"
#include "emitted/link_points.h"
#include "emitted/link_pose.h"
#include "emitted/link_rows.h"
#include "emitted/link_vectors.h"
};

#pragma GCC diagnostic pop

#undef TL_INLINE
#undef TL_FOLDED
#undef TL_SHARED
#undef TL_NONE
#undef TL_REAL
#undef TL_SLIDING
#undef TL_DRIVEN
#undef TL_RUBBING
#undef TL_OWN_SINES
#undef TL_BALLS
#undef TL_PUSHED
#undef TL_LOADED
#undef TL_SORTED
#undef TL_STEPPED
#undef TL_GROUNDED
#undef TL_FREED
#undef TL_TURNING

}  // namespace treeline
