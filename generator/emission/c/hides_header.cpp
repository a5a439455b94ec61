#include "emission/c/hides_header.hpp"

#include <algorithm>
#include <array>

namespace treeline::c {
namespace {

/// Headers of C up to C23, without `.h`.
constexpr std::array<std::string_view, 31> kHeaders = {
    "assert", "complex", "ctype",     "errno",  "fenv",   "float",    "inttypes", "iso646",
    "limits", "locale",  "math",      "setjmp", "signal", "stdalign", "stdarg",   "stdatomic",
    "stdbit", "stdbool", "stdckdint", "stddef", "stdint", "stdio",    "stdlib",   "stdnoreturn",
    "string", "tgmath",  "threads",   "time",   "uchar",  "wchar",    "wctype"};

}  // namespace

bool hides_header(std::string_view name) {
  return std::find(kHeaders.begin(), kHeaders.end(), name) != kHeaders.end();
}

}  // namespace treeline::c
