// What the pages list. Would catch: a key of scenes or a function that was added and that no page
// explains, and a function that only the interpreter judges.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "description/read_keys.hpp"
#include "description/scene_key_texts.hpp"
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

/// Options of a help text beside or below which nothing is said.
std::vector<std::string> options_without_text(const std::string& help) {
  constexpr std::size_t kTextColumn = 30;
  std::vector<std::string> lines, found;
  std::istringstream stream(help);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  lines.emplace_back();
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (!lines[i].starts_with("  -")) continue;
    const bool beside = lines[i].size() > kTextColumn && lines[i][kTextColumn - 1] == ' ';
    const bool below = lines[i + 1].find_first_not_of(' ') == kTextColumn;
    if (!beside && !below) found.push_back(lines[i]);
  }
  return found;
}

// Help is what docs/reference/commands.md shows. Would catch: an option without a text.
TEST_F(PagesTest, EveryOptionSaysWhatItDoes) {
  EXPECT_EQ(options_without_text("  -a,--all TEXT\n  --silent                    Say nothing\n"),
            std::vector<std::string>{"  -a,--all TEXT"});
  const std::string help = run("--help").out;
  const std::set<std::string> commands =
      find_all(help.substr(help.find("Subcommands:")), "\n  ([a-z-]+) ");
  ASSERT_GE(commands.size(), 10U) << help;
  for (const std::string& command : commands) {
    const std::string text = run("help " + command).out;
    EXPECT_GE(find_all(text, "\n  (?:-[a-z],)?(--[a-z-]+)").size(), 2U) << command;
    EXPECT_EQ(options_without_text(text), std::vector<std::string>{}) << command;
  }
}

}  // namespace
}  // namespace treeline
