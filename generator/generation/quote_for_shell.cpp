#include "generation/quote_for_shell.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/printable.hpp"

namespace treeline {
namespace {

bool is_plain(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  return letter || std::string_view("/._-+=:,@%").find(c) != std::string_view::npos;
}

/// $'...': the only quotes in which a carriage return can be seen.
std::string with_escapes(std::string_view path) {
  std::string quoted = "$'";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\'' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (byte < 0x20 || byte >= 0x7F) {
      quoted += fmt::format("\\{:03o}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

}  // namespace

std::string quote_for_shell(std::string_view path) {
  const std::string safe = (path.starts_with('-') ? "./" : "") + std::string(path);
  if (!safe.empty() && std::all_of(safe.begin(), safe.end(), is_plain)) return safe;
  if (printable(safe) != safe) return with_escapes(safe);
  std::string quoted = "'";
  for (const char c : safe) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace treeline
