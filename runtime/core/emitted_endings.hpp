#pragma once
// The headers of runtime/emitted that functions call behind their straight lines, as members of a
// class of any number type and size. C++17, freestanding.

#include <stdint.h>

#include "core/in_eights.hpp"

namespace treeline::core {

#define TL_INLINE
#define TL_RESTRICT __restrict
#define TL_REAL(x) real(x)
#define TL_NONE nullptr
#define TREELINE_REGISTER_BYTES 0  // each number by itself

/// Everything of runtime/emitted/acceleration_derivatives.h and what it includes, for so many
/// velocities and rows of factors so long.
template <class Number>
struct EmittedEndings {
  using real = Number;
  const real TL_ZERO = real(0.0);
  const real TL_ONE = real(1.0);
  const int32_t TL_VELOCITIES;
  const int32_t TL_PLACES = in_eights(TL_VELOCITIES);
  const int32_t TL_PATH;
  const bool TL_FLOATS;

  EmittedEndings(int32_t velocities, int32_t path, bool floats)
      : TL_VELOCITIES(velocities), TL_PATH(path), TL_FLOATS(floats) {}

#include "emitted/acceleration_derivatives.h"
};

#undef TL_INLINE
#undef TL_RESTRICT
#undef TL_REAL
#undef TL_NONE
#undef TREELINE_REGISTER_BYTES
#undef TREELINE_WRITTEN_OUT
#undef TREELINE_IN_PLACE
#undef TREELINE_ALIGNED

}  // namespace treeline::core
