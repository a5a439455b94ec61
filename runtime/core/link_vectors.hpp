#pragma once
// Vectors, rotations about coordinate axes, wrenches and twists of the links of a table. C++17,
// freestanding.

// Where code is to be small, compilers make calls of what they could repeat, and numbers go through
// memory: a twentieth of the bytes less, for two thirds more instructions.
#if defined(__GNUC__)
#define TREELINE_LINK_INLINE inline __attribute__((always_inline))
#else
#define TREELINE_LINK_INLINE inline
#endif

// What several functions of a robot call is not inlined into each, nor made for each anew: a linker
// keeps one.
#if defined(__clang__)
#define TREELINE_LINK_SHARED __attribute__((noinline))
#elif defined(__GNUC__)
#define TREELINE_LINK_SHARED __attribute__((noinline, noclone))
#else
#define TREELINE_LINK_SHARED
#endif

namespace treeline::core::loops {

/// Cosine and sine of a rotation about one coordinate axis.
template <class Real>
struct Turn {
  Real c;
  Real s;
};

/// A wrench [f; n], or a twist [v; w], at a link's origin, in its axes.
template <class Real>
struct Spatial {
  Real linear[3];
  Real angular[3];
};

// Arrays and structs are filled and copied by their numbers: of initializers and assignments
// compilers make calls of memset and memcpy.
template <class Real>
void clear(Real (&v)[3]) noexcept {
  for (int k = 0; k < 3; ++k) {
    v[k] = Real(0.0);
  }
}

template <class Real>
TREELINE_LINK_INLINE void turn_plane(const Turn<Real>& r, Real& x, Real& y) noexcept {
  const Real old = x;
  x = (r.c * old) - (r.s * y);
  y = (r.s * old) + (r.c * y);
}
template <class Real>
TREELINE_LINK_INLINE void turn_plane_back(const Turn<Real>& r, Real& x, Real& y) noexcept {
  const Real old = x;
  x = (r.c * old) + (r.s * y);
  y = (r.c * y) - (r.s * old);
}

template <class Real>
TREELINE_LINK_INLINE Real dot(const Real (&a)[3], const Real (&b)[3]) noexcept {
  return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

/// product = a x b
template <class Real>
TREELINE_LINK_INLINE void find_cross(const Real (&a)[3], const Real (&b)[3],
                                     Real (&product)[3]) noexcept {
  product[0] = (a[1] * b[2]) - (a[2] * b[1]);
  product[1] = (a[2] * b[0]) - (a[0] * b[2]);
  product[2] = (a[0] * b[1]) - (a[1] * b[0]);
}

/// sum += a x b
template <class Real>
TREELINE_LINK_INLINE void add_cross(const Real (&a)[3], const Real (&b)[3],
                                    Real (&sum)[3]) noexcept {
  sum[0] = sum[0] + ((a[1] * b[2]) - (a[2] * b[1]));
  sum[1] = sum[1] + ((a[2] * b[0]) - (a[0] * b[2]));
  sum[2] = sum[2] + ((a[0] * b[1]) - (a[1] * b[0]));
}

template <class Real>
TREELINE_LINK_INLINE void add(const Spatial<Real>& more, Spatial<Real>& sum) noexcept {
  sum.linear[0] = sum.linear[0] + more.linear[0];
  sum.linear[1] = sum.linear[1] + more.linear[1];
  sum.linear[2] = sum.linear[2] + more.linear[2];
  sum.angular[0] = sum.angular[0] + more.angular[0];
  sum.angular[1] = sum.angular[1] + more.angular[1];
  sum.angular[2] = sum.angular[2] + more.angular[2];
}

/// sum += factor more
template <class Real>
TREELINE_LINK_INLINE void add_scaled(const Spatial<Real>& more, const Real& factor,
                                     Spatial<Real>& sum) noexcept {
  sum.linear[0] = sum.linear[0] + (more.linear[0] * factor);
  sum.linear[1] = sum.linear[1] + (more.linear[1] * factor);
  sum.linear[2] = sum.linear[2] + (more.linear[2] * factor);
  sum.angular[0] = sum.angular[0] + (more.angular[0] * factor);
  sum.angular[1] = sum.angular[1] + (more.angular[1] * factor);
  sum.angular[2] = sum.angular[2] + (more.angular[2] * factor);
}

/// scaled = factor spatial
template <class Real>
TREELINE_LINK_INLINE void scale_spatial(const Real& factor, const Spatial<Real>& spatial,
                                        Spatial<Real>& scaled) noexcept {
  scaled.linear[0] = spatial.linear[0] * factor;
  scaled.linear[1] = spatial.linear[1] * factor;
  scaled.linear[2] = spatial.linear[2] * factor;
  scaled.angular[0] = spatial.angular[0] * factor;
  scaled.angular[1] = spatial.angular[1] * factor;
  scaled.angular[2] = spatial.angular[2] * factor;
}

template <class Real>
TREELINE_LINK_INLINE void copy_spatial(const Spatial<Real>& from, Spatial<Real>& to) noexcept {
  to.linear[0] = from.linear[0];
  to.linear[1] = from.linear[1];
  to.linear[2] = from.linear[2];
  to.angular[0] = from.angular[0];
  to.angular[1] = from.angular[1];
  to.angular[2] = from.angular[2];
}

template <class Real>
void clear_spatial(Spatial<Real>& spatial) noexcept {
  clear(spatial.linear);
  clear(spatial.angular);
}

}  // namespace treeline::core::loops
