#pragma once

#include <cmath>

#include "core/command_laws.hpp"
#include "core/ldlt.hpp"
#include "core/posture_laws.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::servo {

/// Springs that hold a posture, one stiffness for all joints, and what keeps joints off their
/// limits.
struct SpringSettings {
  double stiffness = 60.0;     ///< N m/rad or N/m
  double damping_ratio = 1.0;  ///< of each spring with its joint's own inertia
  double margin = 0.2;         ///< from a limit, where it begins to push, rad or m
  double strength = 200.0;     ///< of the push at the limit, N m or N
  double period = 0.001;       ///< of the control, s
};

/// The posture of joint springs: qdd_0 = M^-1 (k (q_advised - q) - D qd + push), where the push is
/// that of `core::add_limit_avoidance`. The springs have a potential, whose minimum among the
/// postures that the task permits has the least sum of squares of joint displacements: no joint
/// needs a stiffness of its own. Joints of little inertia would make the springs stiff at any
/// period, so they are taken at the end of the period (implicit Euler):
///   (M + h D + h^2 k) qdd_0 = k (q_advised - q - h qd) - D qd + push.
/// F has `mass_matrix`. Only for robots whose joints have one degree of freedom.
template <class F>
class SpringPosture {
 public:
  static constexpr int nv = F::kVelocities;

  /// `lower` and `upper` are the joints' limits, rad or m.
  SpringPosture(const SpringSettings& settings, const double (&lower)[nv],
                const double (&upper)[nv]) noexcept
      : settings_(settings) {
    for (int i = 0; i < nv; ++i) {
      lower_[i] = lower[i];
      upper_[i] = upper[i];
    }
  }

  /// Computes qdd_0; 0 if M cannot be factored.
  void advise(const StateOf<F>& state, const double (&advised)[nv],
              double (&qdd_0)[nv]) const noexcept {
    const double k = settings_.stiffness;
    const double h = settings_.period;
    double M[nv * nv];
    F::mass_matrix(state.q, M);
    for (int i = 0; i < nv; ++i) {
      const double damper = 2.0 * settings_.damping_ratio * std::sqrt(k * M[i * nv + i]);
      qdd_0[i] = k * (advised[i] - state.q[i] - h * state.qd[i]) - damper * state.qd[i];
      M[i * nv + i] += h * damper + h * h * k;
    }
    core::add_limit_avoidance(lower_, upper_, settings_.margin, settings_.strength, 0.0, state.q,
                              state.qd, qdd_0);
    const bool regular = core::ldlt_factor<nv>(M);
    core::ldlt_solve<nv>(M, qdd_0);
    for (int i = 0; i < nv; ++i) {
      qdd_0[i] = regular ? qdd_0[i] : 0.0;
    }
  }

 private:
  SpringSettings settings_;
  double lower_[nv];
  double upper_[nv];
};

}  // namespace treeline::servo
