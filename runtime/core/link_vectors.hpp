#pragma once
// Vectors, rotations about coordinate axes, wrenches and twists of the links of a table. C++17,
// freestanding.

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
inline void turn_plane(const Turn<Real>& r, Real& x, Real& y) noexcept {
  const Real old = x;
  x = (r.c * old) - (r.s * y);
  y = (r.s * old) + (r.c * y);
}
template <class Real>
inline void turn_plane_back(const Turn<Real>& r, Real& x, Real& y) noexcept {
  const Real old = x;
  x = (r.c * old) + (r.s * y);
  y = (r.c * y) - (r.s * old);
}

template <class Real>
Real dot(const Real (&a)[3], const Real (&b)[3]) noexcept {
  return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

/// sum += a x b
template <class Real>
void add_cross(const Real (&a)[3], const Real (&b)[3], Real (&sum)[3]) noexcept {
  sum[0] = sum[0] + ((a[1] * b[2]) - (a[2] * b[1]));
  sum[1] = sum[1] + ((a[2] * b[0]) - (a[0] * b[2]));
  sum[2] = sum[2] + ((a[0] * b[1]) - (a[1] * b[0]));
}

template <class Real>
void add(const Spatial<Real>& more, Spatial<Real>& sum) noexcept {
  for (int k = 0; k < 3; ++k) {
    sum.linear[k] = sum.linear[k] + more.linear[k];
    sum.angular[k] = sum.angular[k] + more.angular[k];
  }
}

template <class Real>
void clear_spatial(Spatial<Real>& spatial) noexcept {
  clear(spatial.linear);
  clear(spatial.angular);
}

}  // namespace treeline::core::loops
