#include <gtest/gtest.h>

#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"
#include "emission/sample.hpp"

// Would catch: a digest that does not change with every file, or that changes with the order of
// the list or with what has the digest itself in it; an array of another size than its text.
namespace treeline {
namespace {

const std::vector<GeneratedFile> kFiles = {{"b.hpp", "b"}, {"a.cpp", "a"}};

TEST(DigestOfFiles, IsThatOfSha256sumsLines) {
  const std::string list = digest("a") + "  a.cpp\n" + digest("b") + "  b.hpp\n";
  EXPECT_EQ(digest_of_files(kFiles), digest(list));
  EXPECT_EQ(
      digest_of_files({{"a.cpp", "a"}, {"b.hpp", "b"}, {"manifest.json", "x"}, {"id.c", "y"}}),
      digest(list));
  EXPECT_NE(digest_of_files({{"b.hpp", "b"}, {"a.cpp", "c"}}), digest(list));
  EXPECT_NE(digest_of_files({{"b.hpp", "b"}, {"c.cpp", "a"}}), digest(list));
}

TEST(PrintIdentity, DefinesTheWholeText) {
  for (const Language language : {Language::cpp, Language::c}) {
    const EmissionContext context = test::sample_context("arm", false, language);
    GeneratedFile file = print_identity(context, kFiles);
    EXPECT_EQ(file.name, language == Language::c ? "id.c" : "id.cpp");
    const std::string between = "\"\n    \"";  // of the two parts of the text
    file.text.erase(file.text.find(between), between.size());
    const std::size_t open = file.text.find('"', file.text.find("arm_id["));
    const std::size_t close = file.text.find('"', open + 1);
    EXPECT_EQ(close - open, size_of_identity(context));
    EXPECT_NE(file.text.find("arm_id[" + std::to_string(size_of_identity(context)) + "]"),
              std::string::npos);
    EXPECT_NE(file.text.find(digest_of_files(kFiles)), std::string::npos);
  }
}

}  // namespace
}  // namespace treeline
