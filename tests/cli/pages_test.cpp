// What the pages list. Would catch: a key of scenes, a function or an option that was added and
// that no page explains, or that a page calls by another name.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "description/scene_keys.hpp"
#include "functions/function.hpp"
#include "program_test.hpp"

namespace treeline {
namespace {

using test::read_file;

const std::string kSources = TREELINE_SOURCES;

using PagesTest = test::ProgramTest;

std::string generator_page() {
  return read_file(kSources + "/generator/README.md");
}

TEST_F(PagesTest, EveryKeyOfScenesHasARow) {
  const std::string page = generator_page();
  for (const SceneKey& key : scene_keys()) {
    EXPECT_NE(page.find("\n| `" + std::string(key.name) + "` |"), std::string::npos) << key.name;
  }
}

TEST_F(PagesTest, EveryFunctionIsListed) {
  const std::string page = generator_page();
  const std::size_t section = page.find("\n## The functions\n");
  ASSERT_NE(section, std::string::npos);
  const std::string list = page.substr(section, page.find("\n## ", section + 1) - section);
  for (const FunctionInfo& row : kFunctions) {
    EXPECT_NE(list.find("`" + std::string(row.name) + "`"), std::string::npos) << row.name;
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

TEST_F(PagesTest, EveryOptionIsExplained) {
  const std::string pages = read_file(kSources + "/README.md") + generator_page() +
                            read_file(kSources + "/runtime/drive/README.md") +
                            read_file(kSources + "/tests/bench/README.md");
  const std::string help = run("--help").out;
  const std::set<std::string> commands =
      find_all(help.substr(help.find("Subcommands:")), "\n  ([a-z-]+) ");
  ASSERT_GE(commands.size(), 10U) << help;
  for (const std::string& command : commands) {
    const auto options = find_all(run("help " + command).out, "\n  (?:-[a-z],)?(--[a-z-]+)");
    ASSERT_GE(options.size(), 2U) << command;
    for (const std::string& option : options) {
      if (option == "--help") continue;
      EXPECT_TRUE(std::regex_search(pages, std::regex(option + "(?![a-z-])")))
          << "treeline " << command << " " << option;
    }
  }
}

}  // namespace
}  // namespace treeline
