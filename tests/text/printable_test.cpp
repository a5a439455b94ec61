// Would catch: characters from a file's names that reach a terminal and have an effect there.
#include "text/printable.hpp"

#include <gtest/gtest.h>

#include "text/diagnostic.hpp"

namespace treeline {
namespace {

TEST(Printable, WritesOutWhatNobodySees) {
  EXPECT_EQ(printable("plain J\xC3\xA4ger \xE5\x85\xB3 \xF0\x9F\x90\xB5"),
            "plain J\xC3\xA4ger \xE5\x85\xB3 \xF0\x9F\x90\xB5");
  EXPECT_EQ(printable("a\rb\nc\td"), "a\\x0db\\x0ac\\x09d");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\x1b[31m\x7f"), "\\x1b[31m\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            "\\x9b2J");  // a control of one character
  EXPECT_EQ(printable("a\xE2\x80\xAE"
                      "b\xE2\x81\xA6"),
            "a\\u202eb\\u2066");                    // marks of direction
  EXPECT_EQ(printable("\xE2\x80\xA8"), "\\u2028");  // separates lines
  EXPECT_EQ(printable("\xFF\xC3"), "\\xff\\xc3");   // no UTF-8
}

TEST(Printable, KeepsLinesWhereAskedTo) {
  EXPECT_EQ(printable_lines("a\n\tb\r"), "a\n\tb\\x0d");
}

TEST(Printable, KeepsJsonJson) {
  EXPECT_EQ(printable_json("{\"a\": \"\xE2\x80\xAE\x7f\"}\n"), "{\"a\": \"\\u202e\\u007f\"}\n");
  EXPECT_EQ(printable_json("\"\xFF\""), "\"\\\\xff\"");
}

// Would catch: a name that imitates a message, or colours the terminal.
TEST(DiagnosticText, CannotBeForged) {
  const Diagnostic diagnostic{Severity::error,       "a\rb.urdf",          3,
                              "robot/link[\x1b[2J]", "odd\nerror: forged", "do\x07 this"};
  EXPECT_EQ(to_string(diagnostic),
            "a\\x0db.urdf:3: error: robot/link[\\x1b[2J]: odd\n  error: forged\n  do\\x07 this");
}

}  // namespace
}  // namespace treeline
