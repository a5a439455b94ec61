// `treeline keys`. Would catch: a key that is asked for by name and not told of, others that are
// told of beside it, and an unknown one that is passed over.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program_test.hpp"

namespace treeline {
namespace {

using KeysTest = test::ProgramTest;

TEST_F(KeysTest, TellsOfThoseThatAreNamed) {
  const auto outcome = run("keys lanes base");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("base: `fixed` or `floating`\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nlanes: 1\n"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("gravity"), std::string::npos) << outcome.out;
}

TEST_F(KeysTest, ListsThemForPrograms) {
  const auto outcome = run("keys --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto keys = nlohmann::json::parse(outcome.out);
  EXPECT_GE(keys.size(), 30U);
  EXPECT_EQ(keys[0]["name"], "name");
  EXPECT_TRUE(keys[0]["page"].is_null());
}

TEST_F(KeysTest, NamesTheNearestOfAnUnknownOne) {
  const auto outcome = run("keys gravty");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("gravity"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline
