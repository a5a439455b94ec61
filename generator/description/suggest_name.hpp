#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace treeline {

/// Insertions, deletions, replacements and swaps of neighbours that turn one text into the other
/// (optimal string alignment).
std::size_t edit_distance(std::string_view left, std::string_view right);

/// `did you mean "..."?` with the known name nearest to `name`, or, when none is near, the known
/// names themselves if they are few, after `otherwise`; empty when there is nothing to say.
std::string suggest_name(std::string_view name, const std::vector<std::string>& known,
                         std::string_view otherwise = "known are");

}  // namespace treeline
