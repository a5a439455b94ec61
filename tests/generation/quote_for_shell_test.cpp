#include "generation/quote_for_shell.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <string>

namespace treeline {
namespace {

/// The first argument that bash passes to a program.
std::string read_by_bash(const std::string& word) {
  const std::string script = "printf %s " + word;
  std::string quoted = "'";
  for (const char c : script) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  std::FILE* pipe = popen(("bash -c " + quoted + "'").c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  pclose(pipe);
  return text;
}

TEST(QuoteForShell, LeavesPlainNamesAlone) {
  EXPECT_EQ(quote_for_shell("robot_1.urdf"), "robot_1.urdf");
  EXPECT_EQ(quote_for_shell("a b.urdf"), "'a b.urdf'");
  EXPECT_EQ(quote_for_shell("it's"), "'it'\\''s'");
  EXPECT_EQ(quote_for_shell("$(rm -r x).urdf"), "'$(rm -r x).urdf'");
  EXPECT_EQ(quote_for_shell("a\rb"), "$'a\\015b'");
  EXPECT_EQ(quote_for_shell("-o.urdf"), "./-o.urdf");
  EXPECT_EQ(quote_for_shell(""), "''");
}

// Would catch: a name that runs as a command when the line in the header is pasted.
TEST(QuoteForShell, IsReadBackByTheShell) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  for (int i = 0; i < 40; ++i) {
    std::string name = "n";
    for (int k = 0; k < 12; ++k) name += static_cast<char>(random() % 255 + 1);
    const std::string word = quote_for_shell(name);
    EXPECT_EQ(read_by_bash(word), name) << "seed " << kSeed << ", name " << i << ": " << word;
    for (const char c : word) EXPECT_TRUE(c >= ' ' || c < 0) << word;
  }
}

}  // namespace
}  // namespace treeline
