#include "emission/keep_called.hpp"

#include <gtest/gtest.h>

// Would catch: a function or type that is left out though something that stays names it, one that
// stays since its name begins another's or is a member's, and an include of a header that is no
// more.

namespace treeline {
namespace {

LoopDeclaration function(const std::string& name, const std::string& body) {
  return {name, true, "/// Calls.\nvoid " + name + "(int i) {\n  " + body + "\n}\n"};
}

TEST(KeepCalled, KeepsWhatIsCalledAndItsTypes) {
  std::vector<LoopHeader> headers = {
      {"a.h",
       "// a\n",
       {{"pair", false, "struct pair {\n  int turn_back;\n};\n"}, function("turn", "pair p;")}},
      {"b.h", "// b\n#include \"a.h\"\n", {function("turn_back", ";"), function("slide", ";")}},
      {"c.h", "// c\n#include \"b.h\"\n", {function("move", "turn(i);"), function("rest", ";")}}};
  keep_called("move(1);", headers);
  ASSERT_EQ(headers.size(), 2U);
  EXPECT_EQ(headers[0].items.size(), 2U);
  EXPECT_EQ(headers[1].name, "c.h");
  EXPECT_EQ(headers[1].opening, "// c\n#include \"a.h\"\n");
  ASSERT_EQ(headers[1].items.size(), 1U);
  EXPECT_NE(headers[1].items[0].text.find("void move("), std::string::npos);
}

TEST(KeepCalled, KeepsNothingThatOnlyItselfCalls) {
  std::vector<LoopHeader> headers = {{"a.h", "", {function("turn", "turn(i);")}}};
  keep_called("turned(1); return_turn(2);", headers);
  EXPECT_TRUE(headers.empty());
}

}  // namespace
}  // namespace treeline
