#include "emission/print_manifest.hpp"

#include <gtest/gtest.h>

#include "emission/sample.hpp"

// Would catch: a manifest that is not JSON, that does not read back its own list of files, or
// digests of other bytes.
namespace treeline {
namespace {

TEST(PrintManifest, ListsWhatItWasGiven) {
  const auto programs = test::sample_programs();
  const Source small{"a.cpp", Source::Of::function, {true, true}};
  const std::string manifest = print_manifest(test::sample_context("arm", false), programs,
                                              {{"b.hpp", ""}, {"a.cpp", "abc"}}, {small});
  EXPECT_EQ(read_manifest_files(manifest),
            (std::vector<std::string>{"a.cpp", "b.hpp", "manifest.json"}));
  for (
      const char* part :
      {R"("robot": "Two links \"2R\"")",
       R"("chosen": {"route": "textbook", "method": "by the textbook", "flops": 40, "cost": 47})",
       R"("rejected": [{"route": "recursion", "method": "by recursion", "flops": 55, "cost": 63}])",
       R"("file": "arm.yaml")",
       R"({"file": "a.cpp", "flags": "-Os", "gcc_flags": "-fno-live-range-shrinkage)",
       // FIPS 180-4, example 1: the digest of "abc".
       R"({"file": "a.cpp", "sha256": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"})"}) {
    EXPECT_NE(manifest.find(part), std::string::npos) << part;
  }
}

TEST(ReadManifestFiles, NothingFromOtherText) {
  EXPECT_TRUE(read_manifest_files("").empty());
  EXPECT_TRUE(read_manifest_files("{\"files\": 3}").empty());
  EXPECT_TRUE(read_manifest_files("{\n  \"files\": [\n").empty());
}

TEST(QuoteJson, EscapesWhatJsonReserves) {
  EXPECT_EQ(quote_json("a\"b\\c\n"), R"("a\"b\\c\u000a")");
}

}  // namespace
}  // namespace treeline
