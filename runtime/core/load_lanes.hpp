#pragma once
// Lanes from a row of numbers, into one, and sums of them.

#include "core/lanes.hpp"

namespace treeline::core {

#if defined(__GNUC__)
#define TREELINE_LOAD_INLINE inline __attribute__((always_inline))
#else
#define TREELINE_LOAD_INLINE inline
#endif

/// The row of numbers at `row` as lanes; any alignment will do. Register by register: larger pieces
/// compilers copy by a call.
template <class Real, int count, bool fits>
TREELINE_LOAD_INLINE void load_lanes(const Real* row, Lanes<Real, count, fits>& lanes) noexcept {
  if constexpr (fits) {
#if defined(__GNUC__)
    typedef decltype(lanes.vector) Anywhere __attribute__((aligned(alignof(Real)), may_alias));
    lanes.vector = *reinterpret_cast<const Anywhere*>(row);
#endif
  } else if constexpr (count == 1) {
    lanes.value = *row;
  } else {
    load_lanes(row, lanes.low);
    load_lanes(row + count / 2, lanes.high);
  }
}
template <class Real, int count, bool fits>
TREELINE_LOAD_INLINE void store_lanes(const Lanes<Real, count, fits>& lanes, Real* row) noexcept {
  if constexpr (fits) {
#if defined(__GNUC__)
    typedef decltype(lanes.vector) Anywhere __attribute__((aligned(alignof(Real)), may_alias));
    *reinterpret_cast<Anywhere*>(row) = lanes.vector;
#endif
  } else if constexpr (count == 1) {
    *row = lanes.value;
  } else {
    store_lanes(lanes.low, row);
    store_lanes(lanes.high, row + count / 2);
  }
}

/// Adds to lanes, and takes away from them, register by register: as an assignment of the whole
/// some compilers call memcpy.
template <class Real, int count, bool fits>
TREELINE_LOAD_INLINE void add_lanes(const Lanes<Real, count, fits>& more,
                                    Lanes<Real, count, fits>& sum) noexcept {
  if constexpr (fits) {
    sum.vector += more.vector;
  } else if constexpr (count == 1) {
    sum.value += more.value;
  } else {
    add_lanes(more.low, sum.low);
    add_lanes(more.high, sum.high);
  }
}
template <class Real, int count, bool fits>
TREELINE_LOAD_INLINE void subtract_lanes(const Lanes<Real, count, fits>& less,
                                         Lanes<Real, count, fits>& left) noexcept {
  if constexpr (fits) {
    left.vector -= less.vector;
  } else if constexpr (count == 1) {
    left.value -= less.value;
  } else {
    subtract_lanes(less.low, left.low);
    subtract_lanes(less.high, left.high);
  }
}

#undef TREELINE_LOAD_INLINE

}  // namespace treeline::core
