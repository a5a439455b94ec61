#include "emission/comment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "emission/emit.hpp"
#include "emission/sample.hpp"

namespace treeline {
namespace {

// Would catch: a compiler that takes the rest of a comment for code (a carriage return ends a line
// for some compilers), or the next line of code for a comment.
TEST(Harmless, LeavesNoWayOutOfAComment) {
  EXPECT_EQ(harmless("// a\r#error b\nint c;\n"), "// a\\x0d#error b\nint c;\n");
  EXPECT_EQ(harmless("// a\\\nint b;\n"), "// a\\x5c\nint b;\n");
  EXPECT_EQ(harmless("// a\\ \t\nint b;\n"), "// a\\x5c \t\nint b;\n");
  EXPECT_EQ(harmless("\\\n"), "\\x5c\n");
  EXPECT_EQ(harmless("// \xE2\x80\xAE x\n"), "// \\u202e x\n");
  EXPECT_EQ(harmless("// a?\?/\nint b;\n"), "// a?\\x3f/\nint b;\n");
  EXPECT_EQ(harmless("\n\n// a\\b\n\tc\n"), "\n\n// a\\b\n\tc\n");
}

// Would catch: strict C99 that ends a string, or another one than was written, at a name with
// `?\?`.
TEST(Harmless, LeavesNoTrigraphs) {
  EXPECT_EQ(harmless("\"arm?\?/\""), "\"arm?\\x3f/\"");
  EXPECT_EQ(harmless("?\?\?=?\?-"), "?\?\\x3f=?\\x3f-");
  EXPECT_EQ(harmless("really?\? yes ?\?"), "really?\? yes ?\?");
}

// Would catch: a place in an emitted file at which a name is inserted without being made safe.
TEST(Harmless, HoldsForEveryEmittedFile) {
  EmissionContext context = test::sample_context("arm", false);
  const std::string odd = "x\r#error pwn\x1b\xE2\x80\xAE\\";
  context.robot = odd;
  context.command = odd;
  for (auto& input : context.inputs) input.file = odd;
  for (auto& joint : context.joints) joint.name = odd;
  context.notes.push_back(odd);
  Diagnostics diagnostics;
  for (const GeneratedFile& file : emit(context, test::sample_programs(), diagnostics)) {
    const auto is_odd = [](char c) { return (c >= 0 && c < ' ' && c != '\n') || c == 0x7F; };
    EXPECT_FALSE(std::any_of(file.text.begin(), file.text.end(), is_odd)) << file.name;
    EXPECT_EQ(file.text.find("\xE2\x80\xAE"), std::string::npos) << file.name;
    if (file.name == "lanes.hpp" || file.name == "sin_cos.hpp")
      continue;  // macros of several lines
    EXPECT_EQ(file.text.find("\\\n"), std::string::npos) << file.name;
  }
}

}  // namespace
}  // namespace treeline
