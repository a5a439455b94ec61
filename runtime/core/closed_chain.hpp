#pragma once
// One object in the hands of N robots, each with generated code of its own (Chang 7.2.2): the
// object's dynamics, the virtual linkage that splits its force over the hands, and the forces of
// the closed chain. C++17, freestanding, fixed size. A robot's generated functions have the
// object's origin as operational point and as place of an external force, all rows in world axes.

#include "core/ldlt.hpp"
#include "core/orientation.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// A rigid body in its own frame.
template <class Real>
struct GraspedObject {
  Real mass = Real(0);
  Real center[3] = {};   ///< of mass
  Real inertia[9] = {};  ///< about the centre of mass, object's axes, row-major, symmetric
};

namespace steps {

/// R v, or R^T v.
template <class Real>
constexpr void rotate(const Real (&R)[9], const Real (&v)[3], Real (&turned)[3],
                      bool back = false) noexcept {
  for (int i = 0; i < 3; ++i) {
    turned[i] = Real(0);
    for (int j = 0; j < 3; ++j) {
      turned[i] += (back ? R[3 * j + i] : R[3 * i + j]) * v[j];
    }
  }
}

/// The unit vector along `v`, of which the length is returned.
template <class Real>
inline Real unit_of(const Real (&v)[3], Real (&unit)[3]) noexcept {
  const Real length = square_root(squared_norm(v));
  for (int i = 0; i < 3; ++i) {
    unit[i] = v[i] / length;
  }
  return length;
}

}  // namespace steps

/// Lambda_obj at the object's origin in world axes, row-major; `R` turns its axes into the world's.
template <class Real>
inline void object_inertia(const GraspedObject<Real>& object, const Real (&R)[9],
                           Real (&Lambda)[36]) noexcept {
  Real c[3];
  steps::rotate(R, object.center, c);
  const Real m = object.mass;
  const Real square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Real turned = Real(0);
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) {
          turned += R[3 * i + k] * object.inertia[3 * k + l] * R[3 * j + l];
        }
      }
      Lambda[6 * i + j] = i == j ? m : Real(0);
      Lambda[6 * (3 + i) + 3 + j] = turned + m * ((i == j ? square : Real(0)) - c[i] * c[j]);
    }
  }
  // m [c]x below the diagonal, its transpose above.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Real entry = i == j ? Real(0) : j == (i + 1) % 3 ? -m * c[3 - i - j] : m * c[3 - i - j];
      Lambda[6 * (3 + i) + j] = entry;
      Lambda[6 * j + 3 + i] = entry;
    }
  }
}

/// Lambda_obj xdd + mu_obj + p_obj at the object's origin, world axes: the force and moment of all
/// hands that give the origin the conventional acceleration xdd[0..2] and the body the angular
/// acceleration xdd[3..5].
template <class Real>
inline void object_wrench(const GraspedObject<Real>& object, const Real (&R)[9],
                          const Real (&angular_velocity)[3], const Real (&xdd)[6],
                          const Real (&gravity)[3], Real (&wrench)[6]) noexcept {
  Real Lambda[36];
  object_inertia(object, R, Lambda);
  Real felt[6];
  for (int i = 0; i < 6; ++i) {
    felt[i] = xdd[i] - (i < 3 ? gravity[i % 3] : Real(0));
  }
  Real c[3];
  Real w_c[3];
  Real w_w_c[3];
  steps::rotate(R, object.center, c);
  steps::cross(angular_velocity, c, w_c);
  steps::cross(angular_velocity, w_c, w_w_c);
  Real spin[3];
  for (int i = 0; i < 3; ++i) {
    spin[i] = Real(0);
    for (int j = 0; j < 3; ++j) {
      spin[i] += Lambda[6 * (3 + i) + 3 + j] * angular_velocity[j];
    }
  }
  Real gyroscopic[3];
  steps::cross(angular_velocity, spin, gyroscopic);
  for (int i = 0; i < 6; ++i) {
    wrench[i] = i < 3 ? object.mass * w_w_c[i % 3] : gyroscopic[i % 3];
    for (int j = 0; j < 6; ++j) {
      wrench[i] += Lambda[6 * i + j] * felt[j];
    }
  }
}

/// The virtual linkage of two grasps (Williams & Khatib 1993), in the object's axes: x from grasp 1
/// to grasp 2, y = up x x with up the object's z axis (its x axis where |x_z| > 0.9), z = x x y.
/// Internal forces are [tension; torsion (m_2 - m_1).x / 2; m_1.y; m_1.z; m_2.y; m_2.z]; tension
/// stretches the object, a squeeze is negative.
template <class Real>
struct TwoGrasps {
  Real points[2][3] = {};  ///< in the object's frame
  Real axes[3][3] = {};    ///< x, y, z of the linkage
  Real length = Real(0);
};

/// False, and a linkage without meaning, when the grasps are at one place.
template <class Real>
inline bool make_two_grasps(const Real (&first)[3], const Real (&second)[3],
                            TwoGrasps<Real>& linkage) noexcept {
  for (int i = 0; i < 3; ++i) {
    linkage.points[0][i] = first[i];
    linkage.points[1][i] = second[i];
  }
  const Real apart[3] = {second[0] - first[0], second[1] - first[1], second[2] - first[2]};
  linkage.length = steps::unit_of(apart, linkage.axes[0]);
  if (!(linkage.length > Real(0))) {
    return false;
  }
  const Real z = linkage.axes[0][2];
  const bool along_z = z > Real(0.9) || z < Real(-0.9);
  Real up[3];
  up[0] = along_z ? Real(1) : Real(0);
  up[1] = Real(0);
  up[2] = along_z ? Real(0) : Real(1);
  Real y[3];
  steps::cross(up, linkage.axes[0], y);
  steps::unit_of(y, linkage.axes[1]);
  steps::cross(linkage.axes[0], linkage.axes[1], linkage.axes[2]);
  return true;
}

/// W^-1: forces and moments of both hands ON the object at its origin, object's axes, from the
/// resultant there and the internal forces. Moments about the origin: add nothing to use them at an
/// operational point there.
template <class Real>
inline void split_over_grasps(const TwoGrasps<Real>& linkage, const Real (&resultant)[6],
                              const Real (&internal)[6], Real (&forces)[2][6]) noexcept {
  const Real(&x)[3] = linkage.axes[0];
  Real middle[3];
  Real force[3];
  for (int i = 0; i < 3; ++i) {
    middle[i] = Real(0.5) * (linkage.points[0][i] + linkage.points[1][i]);
    force[i] = resultant[i];
  }
  Real moment[3];
  steps::cross(middle, force, moment);
  Real twist = Real(0);
  for (int i = 0; i < 3; ++i) {
    moment[i] = resultant[3 + i] - moment[i];
    twist += moment[i] * x[i];
  }
  // What the hands' own moments leave across the line is borne by a couple of forces.
  Real bend[2][3];
  Real across[3];
  for (int i = 0; i < 3; ++i) {
    bend[0][i] = internal[2] * linkage.axes[1][i] + internal[3] * linkage.axes[2][i];
    bend[1][i] = internal[4] * linkage.axes[1][i] + internal[5] * linkage.axes[2][i];
    across[i] = moment[i] - twist * x[i] - bend[0][i] - bend[1][i];
  }
  Real couple[3];
  steps::cross(across, x, couple);
  for (int hand = 0; hand < 2; ++hand) {
    const Real side = hand == 0 ? Real(-1) : Real(1);
    Real f[3];
    Real arm_moment[3];
    for (int i = 0; i < 3; ++i) {
      f[i] = Real(0.5) * force[i] + side * (couple[i] / linkage.length + internal[0] * x[i]);
    }
    steps::cross(linkage.points[hand], f, arm_moment);
    for (int i = 0; i < 3; ++i) {
      forces[hand][i] = f[i];
      forces[hand][3 + i] =
          arm_moment[i] + bend[hand][i] + (Real(0.5) * twist + side * internal[1]) * x[i];
    }
  }
}

/// The lower rows of W: internal forces from forces and moments at the object's origin, object's
/// axes.
template <class Real>
inline void read_internal_forces(const TwoGrasps<Real>& linkage, const Real (&forces)[2][6],
                                 Real (&internal)[6]) noexcept {
  const auto dot = [](const Real(&a)[3], const Real(&b)[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  Real along[2];
  Real about[2];
  for (int hand = 0; hand < 2; ++hand) {
    Real f[3] = {forces[hand][0], forces[hand][1], forces[hand][2]};
    Real moment[3];
    steps::cross(linkage.points[hand], f, moment);
    for (int i = 0; i < 3; ++i) {
      moment[i] = forces[hand][3 + i] - moment[i];
    }
    along[hand] = dot(f, linkage.axes[0]);
    about[hand] = dot(moment, linkage.axes[0]);
    internal[2 + 2 * hand] = dot(moment, linkage.axes[1]);
    internal[3 + 2 * hand] = dot(moment, linkage.axes[2]);
  }
  internal[0] = Real(0.5) * (along[1] - along[0]);
  internal[1] = Real(0.5) * (about[1] - about[0]);
}

/// The forces of N hands of as many robots on one object (Chang table 7.2 over eq. 7.9):
/// xdd = (Lambda_obj + sum Lambda_i)^-1 (sum Lambda_i xdd_i - bias), f_i = Lambda_i (xdd_i - xdd).
/// `Lambda[i]` is robot i's inertia at the object's origin, `xdd_free[i]` the acceleration there
/// that it would have without the object (less what stabilisation asks for), `bias` the object's
/// wrench at xdd = 0; all in world axes. f_i acts ON the object. False when the augmented inertia
/// is not positive definite.
template <int N, class Real>
inline bool grasp_forces(const Real (&object_Lambda)[36], const Real (&bias)[6],
                         const Real (&Lambda)[N][36], const Real (&xdd_free)[N][6], Real (&xdd)[6],
                         Real (&forces)[N][6]) noexcept {
  Real sum[36];
  for (int i = 0; i < 36; ++i) {
    sum[i] = object_Lambda[i];
    for (int robot = 0; robot < N; ++robot) {
      sum[i] += Lambda[robot][i];
    }
  }
  for (int i = 0; i < 6; ++i) {
    xdd[i] = -bias[i];
    for (int robot = 0; robot < N; ++robot) {
      for (int j = 0; j < 6; ++j) {
        xdd[i] += Lambda[robot][6 * i + j] * xdd_free[robot][j];
      }
    }
  }
  const bool positive = ldlt_factor<6>(sum);
  ldlt_solve<6>(sum, xdd);
  for (int robot = 0; robot < N; ++robot) {
    for (int i = 0; i < 6; ++i) {
      forces[robot][i] = Real(0);
      for (int j = 0; j < 6; ++j) {
        forces[robot][i] += Lambda[robot][6 * i + j] * (xdd_free[robot][j] - xdd[j]);
      }
    }
  }
  return positive;
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
