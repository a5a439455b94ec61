// What the pages list. Would catch: a key of scenes or a function that was added and that no page
// explains, and a function that only the interpreter judges.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "description/scene_key_texts.hpp"
#include "description/scene_keys.hpp"
#include "functions/function.hpp"
#include "program_test.hpp"

namespace treeline {
namespace {

using test::read_file;

const std::string kSources = TREELINE_SOURCES;

using PagesTest = test::ProgramTest;

TEST_F(PagesTest, EveryKeyOfScenesHasOneText) {
  std::multiset<std::string> keys, texts;
  for (const SceneKey& key : scene_keys()) keys.insert(key.name);
  for (const SceneKeyText& text : kSceneKeyTexts) texts.insert(text.name);
  EXPECT_EQ(keys, texts);
}

TEST_F(PagesTest, EveryTextOfAKeyNamesAPage) {
  for (const SceneKeyText& text : kSceneKeyTexts) {
    if (text.page == nullptr) continue;
    const std::string page(text.page);
    EXPECT_TRUE(std::filesystem::exists(kSources + "/docs/" + page.substr(0, page.find('#'))))
        << text.name << " " << page;
  }
}

TEST_F(PagesTest, EveryFunctionIsListed) {
  const std::string page = read_file(kSources + "/docs/reference/functions.md");
  for (const FunctionInfo& row : kFunctions) {
    EXPECT_NE(page.find("\n### " + std::string(row.name) + "\n"), std::string::npos) << row.name;
  }
}

/// All matches of the first group of `pattern`.
std::set<std::string> find_all(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match) {
    found.insert((*match)[1]);
  }
  return found;
}

/// Cells of a row of a table that begins with `first`; empty: there is none.
std::vector<std::string> cells_of(const std::string& page, const std::string& first) {
  const std::size_t row = page.find("\n| " + first + " | ");
  if (row == std::string::npos) return {};
  std::istringstream line(page.substr(row + 3, page.find('\n', row + 1) - row - 3));
  std::vector<std::string> cells;
  for (std::string cell; std::getline(line, cell, '|');) cells.push_back(cell);
  return cells;
}

// Would catch: a function that only the interpreter judges, and a test that has gone. `judges`
// compares what the table says of programs with what they were asked.
TEST_F(PagesTest, EveryFunctionHasTwoJudges) {
  const std::string page = read_file(kSources + "/tests/README.md");
  for (const FunctionInfo& row : kFunctions) {
    const std::vector<std::string> cells = cells_of(page, "`" + std::string(row.name) + "`");
    ASSERT_EQ(cells.size(), 3U) << row.name;
    const std::set<std::string> programs = find_all(cells[1], "(Pinocchio|Drake|MuJoCo)");
    const std::set<std::string> tests = find_all(cells[2], "`([^`]+)`");
    EXPECT_GE(programs.size() + tests.size(), 2U) << row.name;
    for (const std::string& test : tests) {
      EXPECT_TRUE(std::filesystem::exists(kSources + "/tests/" + test)) << test;
    }
  }
}

}  // namespace
}  // namespace treeline
