#include "emission/misra/refuse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "emission/c/print_files.hpp"

namespace treeline::c {

void refuse(const EmissionContext& context, Diagnostics& diagnostics) {
  misra::refuse(context, diagnostics);
  refuse_hidden_header(context, diagnostics);
}

void refuse_hidden_header(const EmissionContext& context, Diagnostics& diagnostics) {
  if (hides_header(context.name)) {
    diagnostics.add({Severity::error, "", 0, "name",
                     fmt::format("the header {0}.h would hide C's own <{0}.h>", context.name),
                     "Choose another name in the scene (key `name`) or with --name."});
  }
}

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
