#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

#include "core/damped_solve.hpp"
#include "emission/sample.hpp"
#include "program/evaluate.hpp"

namespace treeline::test {

template <class Real, std::size_t size>
void expect_same_bits(const Real (&actual)[size], const std::vector<Real>& expected) {
  ASSERT_EQ(size, expected.size());
  for (std::size_t i = 0; i < size; ++i) {
    EXPECT_EQ(std::memcmp(&actual[i], &expected[i], sizeof(Real)), 0)
        << i << ": " << actual[i] << " instead of " << expected[i];
  }
}

template <class Real, std::size_t size>
std::vector<Real> fill(Real (&array)[size], std::mt19937& random) {
  std::uniform_real_distribution<Real> uniform(-4, 4);
  for (Real& element : array) {
    element = uniform(random);
  }
  return {array, array + size};
}

inline constexpr int kStates = 200;
inline constexpr unsigned kSeed = 11;

template <class Real, class Function>
void compare_two_link_arm(Function inverse_dynamics) {
  const Program program = sample_programs()[0];
  std::mt19937 random(kSeed);
  for (int i = 0; i < kStates; ++i) {
    Real q[2];
    Real qd[2];
    Real qdd[2];
    Real tau[2];
    const std::vector<std::vector<Real>> arguments = {fill(q, random), fill(qd, random),
                                                      fill(qdd, random)};
    inverse_dynamics(q, qd, qdd, tau);
    expect_same_bits(tau, evaluate(program, arguments)[0]);
  }
}

template <class Real, class Function>
void compare_corner_cases(Function corner_cases) {
  const Program program = sample_programs()[1];
  std::mt19937 random(kSeed);
  for (int i = 0; i < kStates; ++i) {
    Real q[3];
    Real unread[2];
    Real delta[2];
    Real out[12];
    Real second[1];
    const std::vector<std::vector<Real>> arguments = {fill(q, random), fill(unread, random),
                                                      fill(delta, random)};
    corner_cases(q, unread, delta, out, second);
    const auto results = evaluate(program, arguments);
    expect_same_bits(out, results[0]);
    expect_same_bits(second, results[1]);
  }
}

/// Tasks of two rows from well moved to singular, where one row or both yield.
template <class Real, class Function>
void compare_damped_solves(Function solve) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<Real> uniform(-4, 4);
  for (int i = 0; i < 20000; ++i) {
    const Real a = uniform(random), b = uniform(random), c = i % 3 == 0 ? 0 : uniform(random);
    const Real A[4] = {a * a, a * b, a * b, b * b + c * c};
    const Real mass_limits[2] = {Real(0.1) + a * a, 3};
    Real expected[2] = {uniform(random), uniform(random)};
    Real actual[2] = {expected[0], expected[1]};
    const Real least_eigenvalue = core::damped_solve(A, mass_limits, expected);
    const Real least_in_c = solve(A, mass_limits, actual);
    ASSERT_EQ(std::memcmp(&least_eigenvalue, &least_in_c, sizeof least_eigenvalue), 0) << i;
    ASSERT_EQ(std::memcmp(expected, actual, sizeof actual), 0) << i;
  }
}

}  // namespace treeline::test
