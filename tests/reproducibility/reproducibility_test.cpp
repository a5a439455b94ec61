// Would catch: arithmetic in emitted code, its lanes or its sines that a compiler may order or
// round differently; a pragma or attribute that changes bits; and contraction with too large an
// effect. Covers a few functions of the PUMA, the UR10e's damped law with its loops, and large
// functions of the humanoid; `cmake --build BUILD -t report_reproducibility` tries all functions of
// four robots.
#include <gtest/gtest.h>

#include "reproducibility/reproduce.hpp"

namespace treeline::tests {
namespace {

const std::vector<Function> kFunctions = {Function::inverse_dynamics, Function::bias_acceleration,
                                          Function::lambda_inverse, Function::control_torque};
/// For the humanoid: functions with lanes across arms and legs, and the longest code.
const std::vector<Function> kLargeFunctions = {Function::inverse_dynamics, Function::mass_matrix,
                                               Function::forward_dynamics,
                                               Function::control_torque};
constexpr int kStates = 40;

Original load(Real real) {
  return load_original(TREELINE_ROBOTS_DIR, "puma560", kStates, kFunctions, real);
}

class Reproducibility : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!has_compiler(GetParam())) GTEST_SKIP() << GetParam() << " is not here";
  }
};

INSTANTIATE_TEST_SUITE_P(Compilers, Reproducibility, testing::Values("g++", "clang++"),
                         [](const auto& of) { return of.param.substr(0, of.param.size() - 2); });

TEST_P(Reproducibility, SameBitsWithoutContraction) {
  const Original original = load(Real::float64);
  for (const std::string& flags :
       {std::string("-O0 -ffp-contract=off"), "-O3 " + separate_for_machine(GetParam())}) {
    for (const Difference& row : compare_with_graph(original, {GetParam(), flags})) {
      EXPECT_EQ(row.bits_differ, 0) << row.function << ' ' << flags;
      EXPECT_EQ(row.states, kStates);
    }
  }
}

void expect_same_bits(const Original& original, const Build& build) {
  for (const Difference& row : compare_with_graph(original, build)) {
    EXPECT_EQ(row.bits_differ, 0) << row.function << ' ' << build.flags;
  }
}

// Loops over eigenvalues and square roots are not a graph: the bits are those of the headers
// compiled into this test.
TEST_P(Reproducibility, DampedLawHasTheSameBits) {
  const Original original =
      load_original(TREELINE_ROBOTS_DIR, "ur10e", kStates,
                    {kDampedFunctions.begin(), kDampedFunctions.end()}, Real::float64);
  ASSERT_EQ(original.references.front().functions.size(), kDampedFunctions.size() + 1);
  for (const char* level : {"-O0", "-O1", "-O2", "-O3"}) {
    expect_same_bits(original, {GetParam(), std::string(level) + " -ffp-contract=off"});
  }
  expect_same_bits(original, {GetParam(), "-O3 " + separate_for_machine(GetParam())});
}

TEST_P(Reproducibility, LargeCodeHasTheSameBits) {
  const Original original =
      load_original(TREELINE_ROBOTS_DIR, "humanoid24", 4, kLargeFunctions, Real::float64);
  for (const char* level : {"-O0", "-O2"}) {
    expect_same_bits(original, {GetParam(), std::string(level) + " -ffp-contract=off"});
  }
}

TEST_P(Reproducibility, ContractionStaysWithinTheBoundOfCheck) {
  const Build build{GetParam(), "-O2 -march=native -ffp-contract=fast"};
  for (const Difference& row : compare_with_graph(load(Real::float64), build)) {
    EXPECT_TRUE(row.bounded()) << row.function << ": " << row.worst << " ulp";
  }
}

TEST_P(Reproducibility, FloatStaysWithinTheBoundOfCheckFromDouble) {
  const Build build{GetParam(), "-O1 -ffp-contract=off"};
  for (const Difference& row :
       compare_with_double(load(Real::float32), load(Real::float64), build)) {
    EXPECT_TRUE(row.bounded()) << row.function << ": " << row.worst << " ulp";
    EXPECT_GT(row.worst, 0) << "compared with itself?";
  }
}

}  // namespace
}  // namespace treeline::tests
