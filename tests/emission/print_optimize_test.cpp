#include "emission/print_optimize.hpp"

#include <gtest/gtest.h>

#include "emission/sample.hpp"

// Would catch: flags that the scene did not ask for, on functions that have nothing to gain, and
// names of files that CMake does not have.
namespace treeline {
namespace {

std::string print(Optimize optimize, Language language, const std::string& target = "generic") {
  EmissionContext context = test::sample_context("arm", false, language);
  context.optimize = optimize;
  context.target = target;
  return print_small_code(context, test::safe_programs(), {});
}

TEST(PrintSmallCode, ListsWhatTheSceneAsksFor) {
  EXPECT_EQ(print(Optimize::speed, Language::c), "");
  const std::string all = print(Optimize::size, Language::c);
  EXPECT_NE(all.find("    inverse_dynamics.c\n"), std::string::npos) << all;
  EXPECT_NE(all.find("    long_chain.c\n"), std::string::npos) << all;
  EXPECT_NE(all.find("CMAKE_C_COMPILER_ID"), std::string::npos) << all;
}

TEST(PrintSmallCode, BalancedTakesWhatIsLargerThanACache) {
  // Of 8160 operations: 73 KB by the model, 41 KB on microcontrollers.
  for (const char* target : {"generic", "cortex-m7"}) {
    const std::string some = print(Optimize::balanced, Language::cpp, target);
    EXPECT_NE(some.find("    long_chain.cpp\n"), std::string::npos) << some;
    EXPECT_EQ(some.find("inverse_dynamics"), std::string::npos) << some;
    EXPECT_NE(some.find("CMAKE_CXX_COMPILER_ID"), std::string::npos) << some;
  }
}

}  // namespace
}  // namespace treeline
