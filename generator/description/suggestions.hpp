#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace treeline {

/// Suggestion for a name that is no function's: the function that other libraries call so, a near
/// name, or all there are; for `all`, how a scene gets all.
std::string suggest_function(std::string_view name);

/// Suggestion for a key that no scene has, where `known` are those of its place: the key that says
/// what other programs call so, a near name, or all known ones.
std::string suggest_key(std::string_view key, const std::vector<std::string>& known);

}  // namespace treeline
