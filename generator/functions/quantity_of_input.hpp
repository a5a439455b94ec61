#pragma once

#include <optional>
#include <string_view>

#include "functions/quantity.hpp"

namespace treeline {

/// The quantity that an input of a graph is an entry of, as `qd` for `qd[3]`; nothing for an input
/// that is none.
constexpr std::optional<Quantity> quantity_of_input(std::string_view input) {
  const std::size_t bracket = input.find('[');
  if (bracket == std::string_view::npos) return std::nullopt;
  return find_quantity(input.substr(0, bracket));
}

}  // namespace treeline
