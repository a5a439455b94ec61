#include "emission/c/lift_steps.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "emission/cpp/templates.hpp"

// Would catch: a step of sine and cosine that is no longer found or understood, so that C gets
// something else than what C++ computes.
namespace treeline {
namespace {

const std::string kHeader(cpp::templates::kSinCos);

std::string changed(const std::string& from, const std::string& to) {
  std::string header = kHeader;
  const std::size_t at = header.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? header : header.replace(at, from.size(), to);
}

TEST(LiftSteps, TurnsEveryStepIntoC) {
  const auto in_double = c::lift_steps(kHeader, "arm", false);
  EXPECT_NE(in_double.at("subtract_quarters").find("const double kPart1 = 0x1.921fb5p+0;\n"),
            std::string::npos);
  EXPECT_NE(in_double.at("nearest_quarter").find("arm_to_bits(&shifted, &quarter);\n"),
            std::string::npos);
  EXPECT_NE(in_double.at("constants").find("const uint64_t kOne = (uint64_t)1023 << 52;\n"),
            std::string::npos);
  EXPECT_EQ(in_double.at("constants").find("kEpsilon"), std::string::npos);
  const auto in_float = c::lift_steps(kHeader, "arm", true);
  EXPECT_NE(in_float.at("sin_cos_remainder").find("const float kS1 = 0x1.555544p-3F;\n"),
            std::string::npos);
  EXPECT_EQ(in_float.at("constants").find("uint64_t"), std::string::npos);
}

// Would catch: parentheses that change what is added first.
TEST(LiftSteps, PutsProductsOfSumsInParentheses) {
  const auto in_double = c::lift_steps(kHeader, "arm", false);
  EXPECT_NE(in_double.at("subtract_quarters")
                .find("const double rough = (x - (turns * kPart1)) - (turns * kPart2);\n"),
            std::string::npos);
  EXPECT_NE(in_double.at("sin_cos_remainder")
                .find("sine = r - (((z * ((tail * 0.5) - (v * s))) - tail) - (v * kS1));\n"),
            std::string::npos);
}

TEST(LiftSteps, FollowsTheHeader) {
  const std::string other = changed("kS1 = -0x1.5555555555548p-3", "kS1 = -0x1.5555555555550p-3");
  EXPECT_NE(c::lift_steps(other, "arm", false).at("sin_cos_remainder"),
            c::lift_steps(kHeader, "arm", false).at("sin_cos_remainder"));
}

TEST(LiftSteps, RefusesWhatItDoesNotUnderstand) {
  const std::string lost = changed("void subtract_quarters(", "void take_quarters(");
  EXPECT_THROW(c::lift_steps(lost, "arm", false), std::logic_error);
  const std::string beyond = changed("const Value z = r * r;", "const auto z = steps::square(r);");
  EXPECT_THROW(c::lift_steps(beyond, "arm", false), std::logic_error);
}

}  // namespace
}  // namespace treeline
