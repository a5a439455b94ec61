#pragma once
// limited_torque.hpp for several states: arrays hold element i of all states in a row.

#include "core/limited_torque.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

namespace steps {

template <int size, int states, class Real>
inline void take_state(const Real (&rows)[size][states], int state, Real (&one)[size]) noexcept {
  for (int i = 0; i < size; ++i) one[i] = rows[i][state];
}
template <int size, int states, class Real>
inline void put_state(const Real (&one)[size], int state, Real (&rows)[size][states]) noexcept {
  for (int i = 0; i < size; ++i) rows[i][state] = one[i];
}

}  // namespace steps

/// `limit_torque` of each state. `matrices(M, J_s, J_t)` writes the matrices of all states, and is
/// called once, if a limit is exceeded in any. The programs are solved one after the other: how
/// many steps each takes is a matter of its state.
template <class Real, class Sizes, int states, class Matrices>
inline void limit_torques(const SupportLayout<Real, Sizes>& layout,
                          const TorqueLimits<Real, Sizes>& limits, const Matrices& matrices,
                          Real (&tau)[Sizes::kVelocities][states],
                          Real (&f)[one_or(Sizes::kHeld)][states],
                          LimitedTorque<Real, Sizes> (&results)[states]) noexcept {
  constexpr int V = Sizes::kVelocities;
  alignas(64) Real M[V * V][states];
  alignas(64) Real J_s[one_or(Sizes::kHeld) * V][states];
  alignas(64) Real J_t[one_or(Sizes::kTask) * V][states];
  bool known = false;
  for (int k = 0; k < states; ++k) {
    Real tau_k[V];
    Real f_k[one_or(Sizes::kHeld)];
    steps::take_state(tau, k, tau_k);
    steps::take_state(f, k, f_k);
    const auto matrices_of_state = [&](auto& M_k, auto& J_s_k, auto& J_t_k) noexcept {
      if (!known) matrices(M, J_s, J_t);
      known = true;
      steps::take_state(M, k, M_k);
      if constexpr (Sizes::kHeld > 0) steps::take_state(J_s, k, J_s_k);
      if constexpr (Sizes::kTask > 0) steps::take_state(J_t, k, J_t_k);
    };
    limit_torque(layout, limits, matrices_of_state, tau_k, f_k, results[k]);
    steps::put_state(tau_k, k, tau);
    steps::put_state(f_k, k, f);
  }
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
