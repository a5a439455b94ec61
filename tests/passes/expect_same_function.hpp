#pragma once

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "program/evaluate.hpp"

namespace treeline::test {

/// Expects that both programs give the same results at one state, in 50 digits. A rewriting that is
/// right in real arithmetic agrees in about 45 of them, a wrong one in none.
inline void expect_same_function(const Program& expected, const Program& actual) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  std::vector<std::vector<Wide>> arguments;
  int i = 0;
  for (const Argument& argument : expected.arguments) {
    std::vector<Wide>& elements = arguments.emplace_back();
    for (int k = 0; k < argument.rows * argument.cols; ++k) {
      elements.push_back(Wide(7 * ++i % 11 - 5) / 4);
    }
  }
  const auto wanted = evaluate(expected, arguments);
  const auto got = evaluate(actual, arguments);
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t r = 0; r < wanted.size(); ++r) {
    ASSERT_EQ(got[r].size(), wanted[r].size());
    for (std::size_t k = 0; k < wanted[r].size(); ++k) {
      const Wide scale = 1 + abs(wanted[r][k]);
      EXPECT_LT(abs(got[r][k] - wanted[r][k]) / scale, Wide(1e-15)) << r << " " << k;
    }
  }
}

}  // namespace treeline::test
