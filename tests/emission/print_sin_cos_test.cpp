#include <gtest/gtest.h>

#include <regex>

#include "emission/print_files.hpp"
#include "emission/sample.hpp"

// Would catch: a step that is left out, or there twice, and a name of the source that no robot has.
namespace treeline {
namespace {

int count(const std::string& text, const std::string& part) {
  int times = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++times;
  return times;
}

void expect_own_names(const std::string& text) {
  std::smatch found;
  EXPECT_FALSE(std::regex_search(text, found, std::regex("\\b(TL_|tl_|Tl[A-Z]|emitted/)\\w*")))
      << found.str();
}

constexpr const char* kInDouble = "kS1 = -0x1.5555555555548p-3;";
constexpr const char* kInFloat = "kS1 = 0x1.555544p-3F;";

TEST(PrintSinCos, HasTheStepsOfItsNumberOnce) {
  for (const Language language : {Language::c, Language::cpp}) {
    for (const bool single : {false, true}) {
      EmissionContext context = test::sample_context("arm", single, language);
      context.misra = language == Language::cpp;
      const std::string text = print_sin_cos(context).text;
      expect_own_names(text);
      EXPECT_EQ(count(text, kInDouble), single ? 0 : 1);
      EXPECT_EQ(count(text, kInFloat), single ? 1 : 0);
      EXPECT_EQ(count(text, "union arm_number number;"), context.misra ? 0 : 2);
    }
  }
}

// Would catch: lanes for who must not have them, or has them in the language, and steps that are
// described again.
TEST(PrintSinCos, HasGroupsInPlainCWhereThereMayBeLanes) {
  for (const Language language : {Language::c, Language::opencl}) {
    for (const int lanes : {1, 4}) {
      for (const bool misra : {false, true}) {
        EmissionContext context = test::sample_context("arm", false, language);
        context.lanes = lanes;
        context.misra = misra;
        const std::string text = print_sin_cos(context).text;
        expect_own_names(text);
        const bool grouped = language == Language::c && lanes > 1 && !misra;
        EXPECT_EQ(count(text, kInDouble), grouped ? 3 : 1);
        EXPECT_EQ(count(text, "vector_size"), grouped ? 6 : 0);
        EXPECT_EQ(count(text, "Minimax"), 1);
      }
    }
  }
}

TEST(PrintSinCos, HasBothNumbersInLanes) {
  const std::string text = print_sines_in_lanes();
  expect_own_names(text);
  EXPECT_EQ(count(text, kInDouble), 1);
  EXPECT_EQ(count(text, kInFloat), 1);
  EXPECT_EQ(count(text, "void within_range("), 1);
}

}  // namespace
}  // namespace treeline
