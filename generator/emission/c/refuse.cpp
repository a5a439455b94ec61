#include "emission/c/refuse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "emission/misra/refuse.hpp"

namespace treeline::c {
namespace {

/// Headers of C up to C23, without `.h`: a folder with one of their names would hide it.
constexpr std::array<std::string_view, 31> kHeaders = {
    "assert", "complex", "ctype",     "errno",  "fenv",   "float",    "inttypes", "iso646",
    "limits", "locale",  "math",      "setjmp", "signal", "stdalign", "stdarg",   "stdatomic",
    "stdbit", "stdbool", "stdckdint", "stddef", "stdint", "stdio",    "stdlib",   "stdnoreturn",
    "string", "tgmath",  "threads",   "time",   "uchar",  "wchar",    "wctype"};

}  // namespace

void refuse(const EmissionContext& context, Diagnostics& diagnostics) {
  misra::refuse(context, diagnostics);
  if (context.batch > 0) {
    diagnostics.add({Severity::error, "", 0, "batch",
                     "functions of several states in one call cannot be had in C yet",
                     "Leave `batch` out, or generate C++ (`language: c++`)."});
  }
  if (context.controlled) {
    diagnostics.add({Severity::error, "", 0, "controller",
                     "a controller is compiled from C++17 (runtime/core), which C cannot include",
                     "Generate C++ (`language: c++`): NAME_controller.h is a header for C as well, "
                     "so that C links and calls NAME_step."});
  }
  if (std::find(kHeaders.begin(), kHeaders.end(), context.name) != kHeaders.end()) {
    diagnostics.add({Severity::error, "", 0, "name",
                     fmt::format("the header {0}.h would hide C's own <{0}.h>", context.name),
                     "Choose another name in the scene (key `name`) or with --name."});
  }
}

}  // namespace treeline::c
