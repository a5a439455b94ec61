#include <gtest/gtest.h>

#include <stdexcept>

#include "emission/emitted_text.hpp"

// Would catch: a gap left in generated code, a value that is not used, and broken indentation.
namespace treeline {
namespace {

TEST(FillTemplate, FillsHolesInLines) {
  EXPECT_EQ(fill_template("a {{x}} b {{y}}{{x}}\n", {{"x", "1"}, {"y", "2"}}), "a 1 b 21\n");
  EXPECT_EQ(fill_template("{{x}} {{x}}\n", {{"x", "1"}}), "1 1\n");
}

TEST(FillTemplate, IndentsBlocks) {
  EXPECT_EQ(fill_template("{\n  {{body}}\n}\n", {{"body", "a\n\nb\n"}}), "{\n  a\n\n  b\n}\n");
}

TEST(FillTemplate, EmptyBlockTakesItsLine) {
  EXPECT_EQ(fill_template("a\n{{x}}\nb\n", {{"x", ""}}), "a\nb\n");
}

TEST(FillTemplate, LeavesValuesAlone) {
  EXPECT_EQ(fill_template("[{{x}}]\n", {{"x", "{{y}}"}}), "[{{y}}]\n");
  EXPECT_EQ(fill_template("{{x}}\n", {{"x", "<&>\"'{{"}}), "<&>\"'{{\n");
}

TEST(FillTemplate, IsStrict) {
  EXPECT_THROW(fill_template("{{x}}\n", {}), std::logic_error);
  EXPECT_THROW(fill_template("a\n", {{"x", ""}}), std::logic_error);
  EXPECT_THROW(fill_template("a {{x\n", {{"x", ""}}), std::logic_error);
  EXPECT_THROW(fill_template("{{ x }}\n", {{"x", ""}}), std::logic_error);
}

}  // namespace
}  // namespace treeline
