#include <gtest/gtest.h>

#include <cmath>

#include "emission/costs.hpp"

// Before the header whose operations it counts, because names in templates are looked up where they
// are defined.
namespace {

/// A number that counts the operations on it.
struct Counted {
  double value = 0;
  static inline int additions = 0, products = 0, quotients = 0, roots = 0;

  constexpr Counted() = default;
  constexpr explicit Counted(double x) : value(x) {}
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }
  Counted& operator/=(const Counted& b) { return *this = *this / b; }
  friend Counted operator+(Counted a, Counted b) { return ++additions, Counted(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return ++additions, Counted(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return ++products, Counted(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return ++quotients, Counted(a.value / b.value); }
  friend Counted operator-(Counted a) { return Counted(-a.value); }
  friend Counted square_root(Counted x) { return ++roots, Counted(std::sqrt(x.value)); }
  friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
  friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
};

}  // namespace

#include "core/damped_solve.hpp"

template <>
struct treeline::core::Format<Counted> {
  static constexpr double kEpsilon = 0x1p-52;
};

// The cost of damped_control_torque in the header, compared with the code from which it is made.
// Would catch: a count that was not updated together with the solver.

namespace treeline::tests {
namespace {

template <int rows, int nv>
void expect_counted() {
  Counted A[rows * rows], J[rows * nv], bias[rows], qdd_0[nv], xdd[rows], mass_limits[rows],
      tau[nv];
  for (int i = 0; i < rows; ++i) {
    A[i * rows + i] = Counted(1e-3 * (i + 1));
    mass_limits[i] = Counted(2);  // relaxes every direction: the longest path
    for (int j = 0; j < i; ++j) A[i * rows + j] = A[j * rows + i] = Counted(1e-4);
  }
  Counted::additions = Counted::products = Counted::quotients = Counted::roots = 0;
  core::add_damped_task_torque<rows, nv>(A, J, bias, qdd_0, xdd, mass_limits, tau);
  const DampedCost cost = cost_of_damped_solve(rows, nv, false);
  EXPECT_EQ(cost.count.add, Counted::additions);
  EXPECT_EQ(cost.count.mul, Counted::products);
  EXPECT_EQ(cost.count.div, Counted::quotients);
  EXPECT_EQ(cost.square_roots, Counted::roots);
}

TEST(DampedCost, IsThatOfTheSolver) {
  expect_counted<1, 3>();
  expect_counted<3, 6>();
  expect_counted<6, 6>();
  expect_counted<6, 9>();
}

}  // namespace
}  // namespace treeline::tests
