#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// Whether `name` can be a name in emitted C++: ASCII letters, digits and underscores, no leading
/// digit or underscore, no double underscore (reserved), no C++ keyword and no name that every
/// program already has at global scope (`std`, `main`, functions of <math.h> and <unistd.h>).
bool is_identifier(std::string_view name);

/// The identifier nearest to a name from a file: other ASCII characters become an underscore,
/// characters beyond ASCII become `u` and their code point in hexadecimal, so that names in any
/// script stay distinct; runs of underscores shrink to one; a leading digit is preceded by `n`; a
/// keyword is followed by an underscore. Never empty. Different names may meet in one identifier.
std::string identifier_from(std::string_view name);

/// Whether the bytes are well-formed UTF-8 (no overlong forms, no surrogates).
bool is_utf8(std::string_view text);

}  // namespace treeline
