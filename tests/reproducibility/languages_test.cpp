// Would catch: C that computes something else than C++: a step of sine and cosine, a lane, the root
// or a loop of damped control; a function that is missing; an element beyond an array. A few robots
// and functions; `cmake --build BUILD -t report_languages` compares all functions of all robots.
#include <gtest/gtest.h>

#include "reproducibility/compare_languages.hpp"

namespace treeline::tests {
namespace {

const std::string kRobots = TREELINE_ROBOTS_DIR;
const std::string kData = TREELINE_DATA_DIR;
const Compilers kGcc{"g++", "gcc"};
const Compilers kClang{"clang++", "clang"};
const std::string kScenes = TREELINE_TESTS_DIR;
constexpr int kStates = 400;

void expect_same_bits(const std::vector<LanguageRow>& rows, std::size_t at_least) {
  EXPECT_GE(rows.size(), at_least);
  for (const LanguageRow& row : rows) {
    EXPECT_EQ(row.bits_differ, 0) << row.robot << ' ' << row.function << ' ' << row.compilers;
    EXPECT_GT(row.states, 0);
  }
}

std::vector<LanguageRow> compare(const std::string& robot, const std::string& scene, Real real,
                                 int lanes, const Compilers& compilers,
                                 const std::vector<Function>& functions = {}) {
  const std::string folder = kRobots + "/" + robot + "/";
  return compare_languages_of(folder + robot + ".urdf", folder + scene, functions, real, lanes,
                              compilers, kStates);
}

TEST(Languages, PumaHasTheSameBits) {
  for (const Real real : {Real::float64, Real::float32}) {
    expect_same_bits(compare("puma560", "scene.yaml", real, 1, kGcc), 11);
    expect_same_bits(compare("puma560", "scene.yaml", real, 1, kClang), 11);
  }
}

// Its scene asks for damped control: roots, rotations and a factorisation in loops.
TEST(Languages, DampedControlHasTheSameBits) {
  const std::vector<Function> called{kDampedFunctions.begin(), kDampedFunctions.end()};
  for (const Real real : {Real::float64, Real::float32}) {
    expect_same_bits(compare("ur10e", "scene.yaml", real, 1, kGcc, called), 5);
    expect_same_bits(compare("ur10e", "scene.yaml", real, 1, kClang, called), 5);
  }
}

void compare_limited(const std::string& robot, const std::string& scene, Real real,
                     const Compilers& compilers, Profile profile = Profile::plain) {
  const auto rows = compare_languages_of(kRobots + "/" + robot + "/" + robot + ".urdf", scene,
                                         {Function::supported_control_torque, Function::mass_matrix,
                                          Function::constraint_jacobian, Function::jacobian},
                                         real, 1, compilers, kStates, {profile, 0, "-O1"});
  expect_same_bits(rows, 5);
  EXPECT_EQ(rows.front().function, "limited_control_torque");
}

// At -O1, which compiles their thousands of lines in two thirds of the time of -O2, to the same
// bits. A hand on a wall; then two feet and two hands on a base without motors: the quadratic
// program.
TEST(Languages, LimitedControlHasTheSameBits) {
  const std::string wall = kScenes + "/consumers/misra_limits.yaml";
  compare_limited("ur10e", wall, Real::float64, kGcc);
  compare_limited("ur10e", wall, Real::float32, kGcc);
  compare_limited("ur10e", wall, Real::float64, kClang);
  compare_limited("humanoid24", kScenes + "/experiments/humanoid24_limits.yaml", Real::float64,
                  kGcc);
}

// Loops of C as C++ has them, with a root of its own.
TEST(Languages, SafeLimitedControlHasTheSameBits) {
  const std::string wall = kScenes + "/consumers/misra_limits.yaml";
  compare_limited("ur10e", wall, Real::float64, kClang, Profile::misra);
  compare_limited("ur10e", wall, Real::float32, kGcc, Profile::misra);
  compare_limited("humanoid24", kScenes + "/experiments/humanoid24_limits.yaml", Real::float64,
                  kGcc, Profile::misra);
}

// In vectors and in loops, of more states than a vector of the machine holds. `call` checks another
// state each time. Would catch: a row at another place, one state's sine for all, a constant.
TEST(Languages, BatchesHaveTheSameBits) {
  const std::string puma = kRobots + "/puma560/";
  for (const auto& [lanes, compilers] : {std::pair{1, kGcc}, {8, kGcc}, {8, kClang}}) {
    const auto rows =
        compare_languages_of(puma + "puma560.urdf", puma + "scene.yaml",
                             {Function::gravity, Function::mass_matrix, Function::control_torque},
                             Real::float64, lanes, compilers, kStates, {Profile::plain, 8});
    expect_same_bits(rows, 6);
    EXPECT_EQ(rows.back().function.substr(0, 6), "batch_");
  }
  expect_same_bits(
      compare_languages_of(puma + "puma560.urdf", puma + "scene.yaml", {Function::inverse_dynamics},
                           Real::float32, 4, kGcc, kStates, {Profile::plain, 4}),
      2);
}

// Its limbs are alike and share lanes. Without __SSE2__ there are no vectors, as on a machine that
// has none: plain numbers.
TEST(Languages, LanesHaveTheSameBits) {
  const std::vector<Function> functions{Function::inverse_dynamics, Function::mass_matrix,
                                        Function::forward_kinematics};
  expect_same_bits(compare("humanoid24", "scene.yaml", Real::float64, 8, kGcc, functions), 3);
  expect_same_bits(compare("humanoid24", "scene.yaml", Real::float32, 4, kClang, functions), 3);
  const std::string humanoid = kRobots + "/humanoid24/";
  expect_same_bits(
      compare_languages_of(humanoid + "humanoid24.urdf", humanoid + "scene.yaml", functions,
                           Real::float64, 8, kGcc, kStates, {Profile::plain, 0, "-O2 -U__SSE2__"}),
      3);
}

TEST(Languages, FloatingBasesHaveTheSameBits) {
  for (const char* robot : {"golden/solo12", "published/ur5"}) {
    for (const Compilers& compilers : {kGcc, kClang}) {
      expect_same_bits(compare_languages_of(kData + "/" + robot + ".urdf", "", {}, Real::float64, 1,
                                            compilers, kStates),
                       4);
    }
  }
}

}  // namespace
}  // namespace treeline::tests
