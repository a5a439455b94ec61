#pragma once

#include <string_view>

namespace treeline {

/// Whether C++ or a header of C that a program may include before emitted code has this name
/// already: keywords, `std`, `main`, macros (`EOF`, `errno`, `M_PI`) and what stands at global
/// scope (functions of <math.h>, <stdio.h>, <unistd.h>).
bool is_taken_name(std::string_view name);

}  // namespace treeline
