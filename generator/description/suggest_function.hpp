#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// Suggestion for a name that is no function's: the function that other libraries call so, a near
/// name, or all there are; for `all`, how a scene gets all.
std::string suggest_function(std::string_view name);

}  // namespace treeline
