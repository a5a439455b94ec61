// Would catch: suggestions that miss a slip of the keyboard or offer something unrelated.
#include "description/suggest_name.hpp"

#include <gtest/gtest.h>

namespace treeline {
namespace {

TEST(EditDistance, CountsSlips) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("lambda", "lambda"), 0U);
  EXPECT_EQ(edit_distance("lamda", "lambda"), 1U);
  EXPECT_EQ(edit_distance("lmabda", "lambda"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(SuggestName, OffersTheNearest) {
  const std::vector<std::string> known = {"gravity", "functions", "locked"};
  EXPECT_EQ(suggest_name("gravty", known), "did you mean \"gravity\"?");
  EXPECT_EQ(suggest_name("functoins", known), "did you mean \"functions\"?");
  EXPECT_EQ(suggest_name("zzzzzz", known, "the keys are"),
            "the keys are gravity, functions, locked");
  EXPECT_EQ(suggest_name("x", {}), "");
  EXPECT_EQ(suggest_name("x", std::vector<std::string>(100, "something")), "");
}

}  // namespace
}  // namespace treeline
