#include "text/printable.hpp"

#include <fmt/format.h>

#include <array>

namespace treeline {
namespace {

bool is_control(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0);
}

/// Characters that cannot be seen and change how others are shown: marks of direction, breaks of
/// lines and paragraphs, the byte order mark.
bool is_hidden_mark(std::uint32_t c) {
  return c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
}

/// Replaces what `keeps` does not keep and nobody should see as it is: code points by what `escape`
/// makes of them, bytes that are no UTF-8 by `\xff` behind `mark`.
template <class Keeps, class Escape>
std::string escape_hidden(std::string_view text, const Keeps& keeps, const Escape& escape,
                          const char* mark) {
  std::string shown;
  while (!text.empty()) {
    const CodePoint point = decode_utf8(text);
    const bool hidden = is_control(point.value) || is_hidden_mark(point.value);
    if (point.length == 0) {
      shown += fmt::format("{}x{:02x}", mark, static_cast<unsigned char>(text.front()));
    } else if (hidden && !keeps(text.front())) {
      shown += escape(point.value);
    } else {
      shown += text.substr(0, point.length);
    }
    text.remove_prefix(point.length == 0 ? 1 : point.length);
  }
  return shown;
}

std::string escape_for_reader(std::uint32_t c) {
  return c < 0x100 ? fmt::format("\\x{:02x}", c) : fmt::format("\\u{:04x}", c);
}

std::string escape_for_json(std::uint32_t c) {
  return fmt::format("\\u{:04x}", c);
}

}  // namespace

std::string printable(std::string_view text) {
  return escape_hidden(
      text, [](char) { return false; }, escape_for_reader, "\\");
}

std::string printable_lines(std::string_view text) {
  const auto keeps = [](char c) { return c == '\n' || c == '\t'; };
  return escape_hidden(text, keeps, escape_for_reader, "\\");
}

std::string printable_json(std::string_view json) {
  const auto keeps = [](char c) { return c == '\n' || c == '\t' || c == '\r'; };
  return escape_hidden(json, keeps, escape_for_json, "\\\\");
}

CodePoint decode_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  std::uint32_t value = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    value = value << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < kSmallest[length] || value > 0x10FFFF || surrogate) return {};
  return {value, length};
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const CodePoint point = decode_utf8(text);
    if (point.length == 0) return false;
    text.remove_prefix(point.length);
  }
  return true;
}

}  // namespace treeline
