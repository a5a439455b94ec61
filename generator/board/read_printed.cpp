#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "board/run_board.hpp"

namespace treeline {
namespace {

constexpr std::string_view kMark = "treeline ";
constexpr std::string_view kBegin = "begin ";
constexpr std::string_view kEnd = "end ";

/// The bytes that digits stand for; nothing where there is something else among them.
std::optional<std::string> read_digits(std::string_view digits) {
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    unsigned byte = 0;
    const char* const from = digits.data() + i;
    const char* const end = from + std::min<std::size_t>(2, digits.size() - i);
    const auto read = std::from_chars(from, end, byte, 16);
    if (read.ptr != from + 2) return std::nullopt;
    bytes += static_cast<char>(byte);
  }
  return bytes;
}

}  // namespace

std::uint32_t sum_bytes(std::string_view bytes) {
  std::uint32_t sum = 2166136261U;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 16777619U;
  return sum;
}

PrintedBytes read_printed(std::string_view text, std::string_view id) {
  PrintedBytes printed;
  bool begun = false;
  for (std::size_t at = text.find(kMark); at != text.npos; at = text.find(kMark, at)) {
    at += kMark.size();
    const std::size_t end_of_line = text.find_first_of("\r\n", at);
    if (end_of_line == text.npos) break;
    const std::string_view rest = text.substr(at, end_of_line - at);
    if (rest.starts_with(kBegin)) {  // of the board's last start, if it was started again
      if (rest.substr(kBegin.size()) != id) {
        return {"", "the results are those of another program than this one"};
      }
      begun = true;
      printed.bytes.clear();
    } else if (begun && rest.starts_with(kEnd)) {
      const std::string end =
          fmt::format("{}{:08x} {:08x}", kEnd, printed.bytes.size(), sum_bytes(printed.bytes));
      if (rest == end) return printed;
      return {"", fmt::format("results were lost on the way: {} bytes came, and the program says "
                              "`{}`, not `{}`",
                              printed.bytes.size(), rest, end)};
    } else if (const auto bytes = read_digits(rest); begun && bytes) {
      printed.bytes += *bytes;
    } else if (begun) {
      return {"", fmt::format("after {} bytes the results are garbled: `{}`", printed.bytes.size(),
                              rest.substr(0, 40))};
    }
  }
  return {"", begun ? fmt::format("the results are cut off after {} bytes", printed.bytes.size())
                    : std::string("no results are printed")};
}

}  // namespace treeline
