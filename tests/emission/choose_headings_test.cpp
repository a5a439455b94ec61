#include <gtest/gtest.h>

#include <random>

#include "emission/body_steps.hpp"

namespace treeline {
namespace {

using Titles = std::vector<std::set<SectionTitle>>;

void append(Titles& titles, int count, const std::set<SectionTitle>& own) {
  titles.insert(titles.end(), static_cast<std::size_t>(count), own);
}

const SectionTitle kElbow = {4, "elbow", "inertia"};
const SectionTitle kWrist = {5, "wrist", "inertia"};

// Would catch: headings over statements of other links, and over less than they promise.
TEST(ChooseHeadings, OneForEachLongRun) {
  Titles titles;
  append(titles, 9, {kElbow});
  append(titles, 7, {kWrist});
  EXPECT_EQ(choose_headings(titles),
            (std::vector<Heading>{{0, "link 4 (elbow), inertia"}, {9, "link 5 (wrist), inertia"}}));
}

TEST(ChooseHeadings, OneForAllWhereLinksAlternate) {
  Titles titles;
  for (int i = 0; i < 4; ++i) {
    append(titles, 1, {kElbow});
    append(titles, 2, {kWrist});
  }
  EXPECT_EQ(choose_headings(titles),
            (std::vector<Heading>{{0, "links 4 (elbow) and 5 (wrist), inertia"}}));
}

TEST(ChooseHeadings, NamesLinksThatAreComputedAtOnce) {
  Titles titles;
  append(titles, 6, {{12, "left", "pose"}, {19, "right", "pose"}, {20, "hand", "pose"}});
  append(titles, 6, {{12, "left", "force"}, {13, "tip", "force"}, {14, "nail", "force"}});
  EXPECT_EQ(choose_headings(titles),
            (std::vector<Heading>{{0, "links 12, 19 and 20, pose"}, {6, "links 12 to 14, force"}}));
}

TEST(ChooseHeadings, NoneForFewStatementsNorForUntitledOnes) {
  Titles titles;
  append(titles, 4, {kElbow});
  EXPECT_TRUE(choose_headings(titles).empty());
  titles.clear();
  append(titles, 3, {});
  append(titles, 5, {kElbow});
  EXPECT_EQ(choose_headings(titles), (std::vector<Heading>{{3, "link 4 (elbow), inertia"}}));
}

// Would catch: any statement below a heading that does not name its link, and short sections, for
// any order of statements.
TEST(ChooseHeadings, EveryStatementStandsBelowItsOwn) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Titles titles;
    const std::size_t count = 5 + random() % 200;
    int link = 1;
    for (std::size_t i = 0; i < count; ++i) {
      if (random() % 4 == 0) link = 1 + static_cast<int>(random() % 40);
      titles.push_back({{link, "l" + std::to_string(link), "inertia"}});
    }
    const std::vector<Heading> headings = choose_headings(titles);
    ASSERT_FALSE(headings.empty());
    EXPECT_EQ(headings.front().first, 0u);
    for (std::size_t h = 0; h < headings.size(); ++h) {
      const std::size_t end = h + 1 < headings.size() ? headings[h + 1].first : count;
      EXPECT_GE(end - headings[h].first, kFewestUnderHeading);
      std::set<SectionTitle> below;
      for (std::size_t i = headings[h].first; i < end; ++i) below.merge(Titles(titles)[i]);
      const Titles alone(kFewestUnderHeading, below);
      EXPECT_EQ(headings[h].text, choose_headings(alone).front().text);
    }
  }
}

}  // namespace
}  // namespace treeline
