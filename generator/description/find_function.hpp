#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// All that a scene may ask for.
std::vector<Function> every_function();

/// The function of that name, see `function_name`; nothing when there is none.
std::optional<Function> find_function(std::string_view name);

/// What to do about a name that is no function's: the one that other libraries call so, a near
/// name, or all there are; for `all`, how a scene gets all.
std::string suggest_function(std::string_view name);

}  // namespace treeline
