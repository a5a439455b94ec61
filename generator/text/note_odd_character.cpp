#include <fmt/format.h>

#include <array>

#include "text/printable.hpp"

namespace treeline {
namespace {

/// Characters that word processors, web pages and keyboards put in place of those of ASCII.
struct Named {
  std::uint32_t first, last;
  const char* name;
  bool is_blank = false;
};

constexpr std::array kNamed = {
    Named{' ', ' ', "a space", true},
    Named{0xA0, 0xA0, "a no-break space", true},
    Named{0xAD, 0xAD, "a soft hyphen", true},
    Named{0xB0, 0xB0, "a degree sign"},
    Named{0x2000, 0x200A, "a space of fixed width", true},
    Named{0x200B, 0x200D, "a mark of no width", true},
    Named{0x2010, 0x2011, "a hyphen"},
    Named{0x2012, 0x2015, "a dash"},
    Named{0x2018, 0x201F, "a typographic quote"},
    Named{0x202F, 0x202F, "a narrow no-break space", true},
    Named{0x2060, 0x2060, "a word joiner", true},
    Named{0x2212, 0x2212, "a minus sign that is not that of the keyboard"},
    Named{0x3000, 0x3000, "a space of full width", true},
    Named{0xFEFF, 0xFEFF, "a byte order mark", true},
    Named{0xFF01, 0xFF5E, "a character of full width"},
};

const Named* find_named(std::uint32_t value) {
  for (const Named& each : kNamed) {
    if (value >= each.first && value <= each.last) return &each;
  }
  return nullptr;
}

std::string name_of(std::uint32_t value) {
  const Named* named = find_named(value);
  return fmt::format("U+{:04X}{}{}", value, named == nullptr ? "" : ", ",
                     named == nullptr ? "" : named->name);
}

}  // namespace

std::string note_odd_character(std::string_view text) {
  while (!text.empty()) {
    const CodePoint point = decode_utf8(text);
    if (point.length == 0) {
      return fmt::format(": it has byte 0x{:02X}, which is not UTF-8",
                         static_cast<unsigned char>(text.front()));
    }
    if (point.value >= 0x80) return ": it has " + name_of(point.value);
    text.remove_prefix(point.length);
  }
  return {};
}

std::string name_outer_blank(std::string_view text) {
  CodePoint first, last;
  for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(last.length)) {
    last = decode_utf8(rest);
    if (last.length == 0) return {};
    if (first.length == 0) first = last;
  }
  for (const CodePoint& point : {first, last}) {
    const Named* named = find_named(point.value);
    if (point.length > 0 && named != nullptr && named->is_blank) return name_of(point.value);
  }
  return {};
}

}  // namespace treeline
