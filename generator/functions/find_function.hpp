#pragma once

#include <optional>
#include <string_view>

#include "functions/function.hpp"

namespace treeline {

/// The function of that name that a scene may ask for; nothing when there is none.
std::optional<Function> find_function(std::string_view name);

}  // namespace treeline
