// Would catch: a crash, an exception that escapes, a refusal without a message, and a constant that
// is not finite, for any input that was interesting to the fuzzer or once broke the program; and
// for some hundred new inputs, drawn as the fuzzer draws them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "mutate_text.hpp"
#include "try_drive.hpp"
#include "try_input.hpp"

namespace treeline::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
  const char* name;
  const char* corpus;  ///< folder of the inputs
  int new_inputs;
  std::string (*attempt)(const std::string&);
  std::string (*mutate)(std::string, Random&);
};

void PrintTo(const Target& target, std::ostream* out) {
  *out << target.name;
}

std::string mutate_either(std::string text, Random& random) {
  return mutate_both(text, random);
}

const std::vector<Target> kTargets = {{"urdf", "urdf", 300, try_urdf, mutate_urdf},
                                      {"scene", "scene", 300, try_scene, mutate_scene},
                                      {"drive", "drive", 300, try_drive, mutate_drive},
                                      {"both", "both", 300, try_both, mutate_either},
                                      {"generate", "both", 60, try_generate, mutate_either}};

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> files_of(const char* folder, const char* target) {
  std::vector<fs::path> files;
  const fs::path path = fs::path(TREELINE_FUZZ_DIR) / folder / target;
  if (!fs::exists(path)) return files;
  for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Replay : public testing::TestWithParam<Target> {};

TEST_P(Replay, Corpus) {
  const auto files = files_of("corpus", GetParam().corpus);
  ASSERT_FALSE(files.empty()) << "the corpus is missing";
  for (const fs::path& file : files) EXPECT_EQ(GetParam().attempt(read_file(file)), "") << file;
}

TEST_P(Replay, WhatOnceBroke) {
  for (const fs::path& file : files_of("crashes", GetParam().name)) {
    EXPECT_EQ(GetParam().attempt(read_file(file)), "") << file;
  }
}

TEST_P(Replay, NewInputs) {
  constexpr unsigned kSeed = 20261122;
  const auto files = files_of("corpus", GetParam().corpus);
  ASSERT_FALSE(files.empty()) << "the corpus is missing";
  Random random(kSeed);
  for (int i = 0; i < GetParam().new_inputs; ++i) {
    std::string text = read_file(files[random() % files.size()]);
    for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
      text = GetParam().mutate(std::move(text), random);
    }
    EXPECT_EQ(GetParam().attempt(text), "") << "input " << i << " of seed " << kSeed << ":\n"
                                            << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Replay, testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace treeline::fuzz
