// Would catch: suggestions that miss a typing error or offer an unrelated name.
#include "text/suggest_name.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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
  EXPECT_EQ(suggest_name("Gravity", known), "did you mean \"gravity\"?");
  EXPECT_EQ(suggest_name("cortex-m4", {"cortex-m0", "cortex-m4f"}), "did you mean \"cortex-m4f\"?");
  EXPECT_EQ(suggest_name("x", {}), "");
}

// Would catch: `elbow` that does not find `elbow_joint`, and parts so short that all names contain
// them.
TEST(SuggestName, OffersWhatContainsOrIsContained) {
  EXPECT_EQ(suggest_name("elbow", {"shoulder_joint", "elbow_joint"}),
            "did you mean \"elbow_joint\"?");
  EXPECT_EQ(suggest_name("tool", {"left_tool0", "right_tool0", "base"}),
            "did you mean \"left_tool0\" or \"right_tool0\"?");
  EXPECT_EQ(suggest_name("gravity_vector", {"mass_matrix", "gravity"}),
            "did you mean \"gravity\"?");
  EXPECT_EQ(suggest_name("3", {"2", "4", "8", "16"}, "the choices are"),
            "the choices are 2, 4, 8, 16");
  EXPECT_EQ(suggest_name("li", {"link_a", "link_b"}, "its links are"),
            "its links are link_a, link_b");
}

// Would catch: who asks for Python as a language and is not told of packages, and a hint where
// nothing of the kind is a choice.
TEST(SuggestName, KnowsWhatIsCalledElsewhere) {
  EXPECT_EQ(suggest_choice("Python", {"c++", "c"}),
            "did you mean `generate --package python`? the choices are c++, c");
  EXPECT_EQ(suggest_choice("cpp", {"c++", "c"}), "did you mean \"c++\"? the choices are c++, c");
  EXPECT_EQ(suggest_choice("flot", {"float", "double"}),
            "did you mean \"float\"? the choices are float, double");
  EXPECT_EQ(suggest_choice("python", {"plain", "misra"}), "the choices are plain, misra");
}

// Would catch: a robot with a thousand joints that fills the screen, and a list that does not
// mention the other names.
TEST(SuggestName, CutsLongLists) {
  std::vector<std::string> known;
  for (int i = 0; i < 1000; ++i) known.push_back("finger_" + std::to_string(i));
  const std::string list = suggest_name("zzzzzzzzzzzzzzzz", known, "its joints are");
  EXPECT_EQ(list.rfind("its joints are finger_0, finger_1,", 0), 0U) << list;
  EXPECT_NE(list.find("finger_59, and 940 more"), std::string::npos) << list;
  for (std::size_t at = 0, end = 0; at < list.size(); at = end + 1) {
    end = std::min(list.find('\n', at), list.size());
    EXPECT_LE(end - at, 110U) << list.substr(at, end - at);
  }
}

}  // namespace
}  // namespace treeline
