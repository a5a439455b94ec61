#include "choice/evaluate_damped.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

// Before the header that uses it, because names in templates are looked up where they are defined.
namespace treeline::core {

/// What the runtime has for float and double only.
inline long double square_root(long double x) noexcept {
  return std::sqrt(x);
}

}  // namespace treeline::core

#include "core/damped_solve.hpp"

// Compiled without contraction: these are the bits that emitted code is held to.

namespace treeline {

namespace core {

template <>
struct Format<long double> {
  static constexpr long double kEpsilon = std::numeric_limits<long double>::epsilon();
};

}  // namespace core

namespace {

constexpr std::size_t kMostRows = 36;

template <int rows, class T>
T solve(const DampedInputsIn<T>& in, std::vector<T>& F) {
  T A[rows * rows];
  T mass_limits[rows];
  T x[rows];
  std::copy_n(in.Lambda_inverse.begin(), rows * rows, A);
  std::copy_n(in.mass_limits.begin(), rows, mass_limits);
  std::copy_n(F.begin(), rows, x);
  const T least_eigenvalue = core::damped_solve(A, mass_limits, x);
  std::copy_n(x, rows, F.begin());
  return least_eigenvalue;
}

/// `core::damped_solve` of as many rows as there are.
template <class T, std::size_t... N>
T solve_any(const DampedInputsIn<T>& in, std::vector<T>& F, std::index_sequence<N...>) {
  using Solve = T (*)(const DampedInputsIn<T>&, std::vector<T>&);
  constexpr Solve kSolves[] = {&solve<static_cast<int>(N) + 1, T>...};
  return kSolves[F.size() - 1](in, F);
}

template <class To>
std::vector<To> to(const std::vector<double>& entries) {
  std::vector<To> rounded;
  for (const double entry : entries) rounded.push_back(static_cast<To>(entry));
  return rounded;
}

}  // namespace

/// `core::add_damped_task_torque`, sizes known as it runs.
template <class T>
std::vector<T> evaluate_damped_in(DampedInputsIn<T> in) {
  const std::size_t rows = in.mass_limits.size();
  const std::size_t nv = in.tau.size();
  if (rows > kMostRows) return {};
  std::vector<T> F(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    F[row] = in.xdd_cmd[row] - in.bias[row];
    for (std::size_t i = 0; i < nv; ++i) F[row] -= in.J[row * nv + i] * in.qdd_0[i];
  }
  const T least_eigenvalue = solve_any(in, F, std::make_index_sequence<kMostRows>());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < nv; ++i) in.tau[i] += in.J[row * nv + i] * F[row];
  }
  in.tau.push_back(least_eigenvalue);
  return in.tau;
}

template std::vector<float> evaluate_damped_in(DampedInputsIn<float>);
template std::vector<double> evaluate_damped_in(DampedInputsIn<double>);
template std::vector<long double> evaluate_damped_in(DampedInputsIn<long double>);

std::vector<double> evaluate_damped(Real real, const DampedInputs& inputs) {
  if (real == Real::float64) return evaluate_damped_in(inputs);
  const auto entries = evaluate_damped_in<float>(
      {to<float>(inputs.Lambda_inverse), to<float>(inputs.J), to<float>(inputs.bias),
       to<float>(inputs.tau), to<float>(inputs.qdd_0), to<float>(inputs.xdd_cmd),
       to<float>(inputs.mass_limits)});
  return {entries.begin(), entries.end()};
}

}  // namespace treeline
