#include "check/evaluate_damped.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/damped_solve.hpp"

// Compiled without contraction: these are the bits that emitted code is held to.

namespace treeline {
namespace {

constexpr std::size_t kMostRows = 36;

template <class T>
struct Rounded {
  std::vector<T> Lambda_inverse, J, bias, tau, qdd_0, xdd_cmd, heaviest;

  explicit Rounded(const DampedInputs& from)
      : Lambda_inverse(to(from.Lambda_inverse)),
        J(to(from.J)),
        bias(to(from.bias)),
        tau(to(from.tau)),
        qdd_0(to(from.qdd_0)),
        xdd_cmd(to(from.xdd_cmd)),
        heaviest(to(from.heaviest)) {}

  static std::vector<T> to(const std::vector<double>& entries) {
    std::vector<T> rounded;
    for (const double entry : entries) rounded.push_back(static_cast<T>(entry));
    return rounded;
  }
};

template <int rows, class T>
T solve(const Rounded<T>& in, std::vector<T>& F) {
  T A[rows * rows];
  T heaviest[rows];
  T x[rows];
  std::copy(in.Lambda_inverse.begin(), in.Lambda_inverse.end(), A);
  std::copy(in.heaviest.begin(), in.heaviest.end(), heaviest);
  std::copy(F.begin(), F.end(), x);
  const T ease = core::damped_solve(A, heaviest, x);
  std::copy(x, x + rows, F.begin());
  return ease;
}

/// `core::damped_solve` of as many rows as there are.
template <class T, std::size_t... N>
T solve_any(const Rounded<T>& in, std::vector<T>& F, std::index_sequence<N...>) {
  using Solve = T (*)(const Rounded<T>&, std::vector<T>&);
  constexpr Solve kSolves[] = {&solve<static_cast<int>(N) + 1, T>...};
  return kSolves[F.size() - 1](in, F);
}

/// `core::add_damped_task_torque`, sizes known as it runs.
template <class T>
std::vector<double> evaluate_in(const DampedInputs& inputs) {
  Rounded<T> in(inputs);
  const std::size_t rows = in.heaviest.size();
  const std::size_t nv = in.tau.size();
  if (rows > kMostRows) return {};
  std::vector<T> F(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    F[row] = in.xdd_cmd[row] - in.bias[row];
    for (std::size_t i = 0; i < nv; ++i) F[row] -= in.J[row * nv + i] * in.qdd_0[i];
  }
  const T ease = solve_any(in, F, std::make_index_sequence<kMostRows>());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < nv; ++i) in.tau[i] += in.J[row * nv + i] * F[row];
  }
  std::vector<double> entries(in.tau.begin(), in.tau.end());
  entries.push_back(ease);
  return entries;
}

}  // namespace

std::vector<double> evaluate_damped(Real real, const DampedInputs& inputs) {
  return real == Real::float32 ? evaluate_in<float>(inputs) : evaluate_in<double>(inputs);
}

}  // namespace treeline
