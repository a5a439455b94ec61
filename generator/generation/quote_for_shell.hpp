#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// Quotes a path as one word of a command line for sh and similar shells. A path without special
/// characters stays as it is. Invisible characters become $'\015', which bash and zsh understand. A
/// leading dash, which would start an option, gets `./` before it.
std::string quote_for_shell(std::string_view path);

}  // namespace treeline
