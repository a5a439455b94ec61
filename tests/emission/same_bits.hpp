#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

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

}  // namespace treeline::test
