// Would catch: results of a board that are taken though bytes are missing, changed or another
// program's, and lines of a serial line or a debugger that are taken for results.
#include <gtest/gtest.h>

#include "board/run_board.hpp"

namespace treeline::tests {
namespace {

// The checksum is FNV-1a of the bytes 01 02 ff, computed in Python.
constexpr const char* kWhole =
    "OpenOCD 0.12\r\ntreeline begin 0123\r\ntreeline 01\r\n[info] halted\r\ntreeline 02ff\r\n"
    "treeline end 00000003 42cf182f\r\nbye\r\n";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kWhole;
  return text.replace(text.find(from), from.size(), to);
}

TEST(ReadPrinted, FindsBytesAmongOtherLines) {
  const PrintedBytes printed = read_printed(kWhole, "0123");
  EXPECT_EQ(printed.fault, "");
  EXPECT_EQ(printed.bytes, "\x01\x02\xff");
}

TEST(ReadPrinted, TakesTheLastStart) {
  const PrintedBytes printed =
      read_printed("treeline begin 0123\ntreeline 77\n" + std::string(kWhole), "0123");
  EXPECT_EQ(printed.bytes, "\x01\x02\xff");
}

TEST(ReadPrinted, TellsWhatIsWrong) {
  EXPECT_EQ(read_printed("", "0123").fault, "no results are printed");
  EXPECT_EQ(read_printed("Hard fault\n", "0123").fault, "no results are printed");
  EXPECT_EQ(read_printed(kWhole, "0124").fault,
            "the results are those of another program than this one");
  EXPECT_EQ(read_printed(with("treeline end 00000003 42cf182f\r\n", ""), "0123").fault,
            "the results are cut off after 3 bytes");
  EXPECT_EQ(read_printed(with("treeline 01\r\n", ""), "0123").fault.find("results were lost"), 0U);
  EXPECT_EQ(read_printed(with("02ff", "03ff"), "0123").fault.find("results were lost"), 0U);
  EXPECT_EQ(read_printed(with("02ff", "02f?"), "0123").fault,
            "after 1 bytes the results are garbled: `02f?`");
  EXPECT_EQ(read_printed(with("02ff", "02f"), "0123").fault,
            "after 1 bytes the results are garbled: `02f`");
}

}  // namespace
}  // namespace treeline::tests
