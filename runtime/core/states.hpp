#pragma once
// Functions of several states at once: arrays hold element i of all states in a row, and each
// number of the scalar code becomes lanes, one a state. No lane sees another.

#include "core/load_lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

#if defined(__GNUC__)
#define TREELINE_STATES_INLINE inline __attribute__((always_inline))
#else
#define TREELINE_STATES_INLINE inline
#endif

/// Rows of numbers as packs: by way of lanes, which compilers see through.
template <class Real, int count>
TREELINE_STATES_INLINE Pack<Real, count> load_pack(const Real* row) noexcept {
  if constexpr (count * int{sizeof(Real)} <= kVectorBytes) {
    Lanes<Real, count> lanes;
    load_lanes(row, lanes);
    return lanes.vector;
  } else {
    Lanes<Real, count> lanes;
    load_lanes(row, lanes);
    return lanes;
  }
}
template <class Real, int count>
TREELINE_STATES_INLINE void store_pack(const Pack<Real, count>& pack, Real* row) noexcept {
  if constexpr (count * int{sizeof(Real)} <= kVectorBytes) {
    store_lanes(Lanes<Real, count>{pack}, row);
  } else {
    store_lanes(pack, row);
  }
}

/// Copies numbers into an object of its own, one by one: of a copy of the whole some
/// compilers make a call of memcpy.
template <class Real, int count, bool fits>
TREELINE_STATES_INLINE Lanes<Real, count, fits> copy_of(
    const Lanes<Real, count, fits>& lanes) noexcept {
  if constexpr (fits) {
    return {lanes.vector};
  } else if constexpr (count == 1) {
    return {lanes.value};
  } else {
    return {copy_of(lanes.low), copy_of(lanes.high)};
  }
}
template <class Vector>
TREELINE_STATES_INLINE const Vector& copy_of(const Vector& vector) noexcept {
  return vector;
}

/// An input argument: `argument[i]` is element i of all states.
template <class Real, int count>
struct StatesIn {
  const Real (*rows)[count];
  TREELINE_STATES_INLINE Pack<Real, count> operator[](int i) const noexcept {
    return load_pack<Real, count>(rows[i]);
  }
};

/// An output argument: `argument[i] = pack`, or one number for all states.
template <class Real, int count>
struct StatesOut {
  struct Row {
    Real* row;
    TREELINE_STATES_INLINE void operator=(const Pack<Real, count>& pack) const noexcept {
      store_pack<Real, count>(pack, row);
    }
    TREELINE_STATES_INLINE void operator=(Real all) const noexcept {
      store_lanes(Lanes<Real, count>::spread(all), row);
    }
  };
  Real (*rows)[count];
  TREELINE_STATES_INLINE Row operator[](int i) const noexcept { return {rows[i]}; }
};

/// Sine and cosine of lanes, in registers as wide as the machine has them.
template <class Real, int count, bool fits>
TREELINE_STATES_INLINE void sin_cos(const Lanes<Real, count, fits>& x,
                                    Lanes<Real, count, fits>& sine,
                                    Lanes<Real, count, fits>& cosine) noexcept {
  if constexpr (!fits && count == 1) {
    sin_cos(x.value, sine.value, cosine.value);
  } else if constexpr (!fits) {
    sin_cos(x.low, sine.low, cosine.low);
    sin_cos(x.high, sine.high, cosine.high);
  } else {
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
    sin_cos_steps<VectorLanes<Real, count>>(x.vector, sine.vector, cosine.vector);
#endif
  }
}

/// Sines and cosines of `size` angles of each state. A loop: the steps of one angle of all states
/// are enough to keep the machine busy, and inlining them all would fill its instruction cache.
template <class Real, int count, int size>
inline void sin_cos_states(const Pack<Real, count> (&x)[size], Pack<Real, count> (&sine)[size],
                           Pack<Real, count> (&cosine)[size]) noexcept {
#if defined(__clang__)
#pragma clang loop unroll(disable)
#elif defined(__GNUC__)
#pragma GCC unroll 1
#endif
  for (int i = 0; i < size; ++i) {
    if constexpr (count * int{sizeof(Real)} <= kVectorBytes) {
      Lanes<Real, count> s;
      Lanes<Real, count> c;
      sin_cos(Lanes<Real, count>{x[i]}, s, c);
      sine[i] = s.vector;
      cosine[i] = c.vector;
    } else {
      sin_cos(x[i], sine[i], cosine[i]);
    }
  }
}

#undef TREELINE_STATES_INLINE

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
