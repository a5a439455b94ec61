// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_LANES_HPP
#define TREELINE_UR10E_LANES_HPP
// Several numbers that are computed together, with one instruction where the machine has one that
// wide. GCC and Clang have such vectors built in, but take wider ones than the machine's apart
// badly; so wide lanes are two halves until a half fits. Other compilers get plain numbers. Every
// lane is one IEEE operation, so lanes change no bit.

namespace ur10e::detail {

#if defined(__GNUC__)
#define TREELINE_LANES_INLINE inline __attribute__((always_inline))
#else
#define TREELINE_LANES_INLINE inline
#endif

#if defined(__GNUC__) && defined(__AVX512F__)
inline constexpr int kVectorBytes = 64;
#elif defined(__GNUC__) && defined(__AVX__)
inline constexpr int kVectorBytes = 32;
#elif defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
inline constexpr int kVectorBytes = 16;
#else
inline constexpr int kVectorBytes = 0;
#endif

/// Lanes wider than the machine's registers: two halves.
template <class Real, int count, bool fits = (count * int{sizeof(Real)} <= kVectorBytes)>
struct Lanes {
  Lanes<Real, count / 2> low, high;

  TREELINE_LANES_INLINE static Lanes spread(Real value) noexcept {
    return {Lanes<Real, count / 2>::spread(value), Lanes<Real, count / 2>::spread(value)};
  }
  TREELINE_LANES_INLINE Real operator[](int i) const noexcept {
    return i < count / 2 ? low[i] : high[i - count / 2];
  }
};

/// One number, where the machine has no vectors.
template <class Real>
struct Lanes<Real, 1, false> {
  Real value;
  TREELINE_LANES_INLINE static Lanes spread(Real all) noexcept { return {all}; }
  TREELINE_LANES_INLINE Real operator[](int) const noexcept { return value; }
};

#if defined(__GNUC__)
/// Lanes that a register of the machine holds.
template <class Real, int count>
struct Lanes<Real, count, true> {
  typedef Real Vector __attribute__((vector_size(count * sizeof(Real))));
  Vector vector;
  TREELINE_LANES_INLINE static Lanes spread(Real value) noexcept {
    return {value - Vector{}};  // of all ways to write it the one that keeps the sign of zero
  }
  TREELINE_LANES_INLINE Real operator[](int i) const noexcept { return vector[i]; }
};
#endif

#define TREELINE_LANES_OPERATOR(symbol)                                                  \
  template <class Real, int count>                                                       \
  TREELINE_LANES_INLINE Lanes<Real, count, false> operator symbol(                       \
      const Lanes<Real, count, false>& a, const Lanes<Real, count, false>& b) noexcept { \
    return {a.low symbol b.low, a.high symbol b.high};                                   \
  }                                                                                      \
  template <class Real>                                                                  \
  TREELINE_LANES_INLINE Lanes<Real, 1, false> operator symbol(                           \
      const Lanes<Real, 1, false>& a, const Lanes<Real, 1, false>& b) noexcept {         \
    return {a.value symbol b.value};                                                     \
  }                                                                                      \
  template <class Real, int count>                                                       \
  TREELINE_LANES_INLINE Lanes<Real, count, true> operator symbol(                        \
      const Lanes<Real, count, true>& a, const Lanes<Real, count, true>& b) noexcept {   \
    return {a.vector symbol b.vector};                                                   \
  }                                                                                      \
  template <class Real, int count, bool fits>                                            \
  TREELINE_LANES_INLINE Lanes<Real, count, fits> operator symbol(                        \
      const Lanes<Real, count, fits>& a, Real b) noexcept {                              \
    return a symbol Lanes<Real, count, fits>::spread(b);                                 \
  }                                                                                      \
  template <class Real, int count, bool fits>                                            \
  TREELINE_LANES_INLINE Lanes<Real, count, fits> operator symbol(                        \
      Real a, const Lanes<Real, count, fits>& b) noexcept {                              \
    return Lanes<Real, count, fits>::spread(a) symbol b;                                 \
  }
TREELINE_LANES_OPERATOR(+)
TREELINE_LANES_OPERATOR(-)
TREELINE_LANES_OPERATOR(*)
TREELINE_LANES_OPERATOR(/)
#undef TREELINE_LANES_OPERATOR

template <class Real, int count, bool fits>
TREELINE_LANES_INLINE Lanes<Real, count, fits> operator-(
    const Lanes<Real, count, fits>& a) noexcept {
  if constexpr (fits) {
    return {-a.vector};
  } else if constexpr (count == 1) {
    return {-a.value};
  } else {
    return {-a.low, -a.high};
  }
}

/// Lanes of two, four or eight numbers.
template <class Real>
TREELINE_LANES_INLINE Lanes<Real, 2> make_lanes(Real a, Real b) noexcept {
  if constexpr (int{2 * sizeof(Real)} <= kVectorBytes) {
    const typename Lanes<Real, 2>::Vector vector = {a, b};
    return {vector};
  } else {
    return {{a}, {b}};
  }
}
template <class Real>
TREELINE_LANES_INLINE Lanes<Real, 4> make_lanes(Real a, Real b, Real c, Real d) noexcept {
  if constexpr (int{4 * sizeof(Real)} <= kVectorBytes) {
    const typename Lanes<Real, 4>::Vector vector = {a, b, c, d};
    return {vector};
  } else {
    return {make_lanes(a, b), make_lanes(c, d)};
  }
}
template <class Real>
TREELINE_LANES_INLINE Lanes<Real, 8> make_lanes(Real a, Real b, Real c, Real d, Real e, Real f,
                                                Real g, Real h) noexcept {
  if constexpr (int{8 * sizeof(Real)} <= kVectorBytes) {
    const typename Lanes<Real, 8>::Vector vector = {a, b, c, d, e, f, g, h};
    return {vector};
  } else {
    return {make_lanes(a, b, c, d), make_lanes(e, f, g, h)};
  }
}

/// Lanes as straight-line code declares them by the thousand: where a register holds them they are
/// the compiler's own vector, not a structure around one. GCC gives up taking structures apart in
/// long functions; their dead stores then keep products from becoming fused multiply-adds.
template <class Real, int count, bool fits = (count * int{sizeof(Real)} <= kVectorBytes)>
struct PackOf {
  using Type = Lanes<Real, count>;
};
#if defined(__GNUC__)
template <class Real, int count>
struct PackOf<Real, count, true> {
  using Type = typename Lanes<Real, count>::Vector;
};
#endif
template <class Real, int count>
using Pack = typename PackOf<Real, count>::Type;

template <class Real, class... Rest>
TREELINE_LANES_INLINE Pack<Real, 1 + int{sizeof...(Rest)}> make_pack(Real first,
                                                                     Rest... rest) noexcept {
  constexpr int kCount = 1 + int{sizeof...(Rest)};
  if constexpr (kCount * int{sizeof(Real)} <= kVectorBytes) {
    return Pack<Real, kCount>{first, rest...};
  } else {
    return make_lanes<Real>(first, rest...);
  }
}

#undef TREELINE_LANES_INLINE

}  // namespace ur10e::detail

#endif  // TREELINE_UR10E_LANES_HPP
