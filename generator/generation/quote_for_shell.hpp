#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// A path as one word of a command line that sh and its kin read: as it is where nothing in it is
/// special, else in quotes; with characters that nobody sees as $'\015', which bash and zsh read. A
/// leading dash, which would be an option, gets `./` before it.
std::string quote_for_shell(std::string_view path);

}  // namespace treeline
