#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// Whether `name` can be a name in emitted C++: ASCII letters, digits and underscores, no leading
/// digit or underscore, no double underscore (reserved), and none that `is_taken_name`.
bool is_identifier(std::string_view name);

/// The identifier nearest to a name from a file: other ASCII characters become an underscore,
/// characters beyond ASCII become `u` and their code point in hexadecimal, so that names in any
/// script stay distinct; runs of underscores shrink to one; a leading digit is preceded by `n`; a
/// keyword is followed by an underscore. Never empty. Different names may meet in one identifier.
std::string identifier_from(std::string_view name);

/// ASCII letters in capitals, the rest as it is.
std::string in_capitals(std::string name);

/// Whether emitted code may have this name as a whole: its namespace, its header NAME.hpp and its
/// target in CMake. Excludes targets that every build has (`all`, `test`) and headers that may lie
/// beside NAME.hpp (`lanes`).
bool is_package_name(std::string_view name);
std::string package_name_from(std::string_view name);

/// Whether C++ or a header of C that a program may include before emitted code has this name
/// already: keywords, `std`, `main`, macros (`EOF`, `errno`, `M_PI`) and what stands at global
/// scope (functions of <math.h>, <stdio.h>, <unistd.h>).
bool is_taken_name(std::string_view name);

}  // namespace treeline
