#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace treeline {

/// Insertions, deletions, replacements and swaps of neighbours that turn one text into the other
/// (optimal string alignment).
std::size_t edit_distance(std::string_view left, std::string_view right);

/// `did you mean "..."?` with the known name that differs from `name` by a slip or two, capitals
/// aside, or else with those of which one contains the other, as `elbow` and `elbow_joint`; empty
/// when none is near.
std::string find_near_name(std::string_view name, const std::vector<std::string>& known);

/// The names between commas, broken into lines; of many, the first and how many more there are.
std::string list_names(const std::vector<std::string>& names);

/// The near name, or, when none is near, all that are known, after `otherwise`; empty when nothing
/// is known.
std::string suggest_name(std::string_view name, const std::vector<std::string>& known,
                         std::string_view otherwise = "known are");

/// What to do about a word that is none of the choices: the near one, or what is called so
/// elsewhere, and all choices.
std::string suggest_choice(std::string_view given, const std::vector<std::string>& choices);

/// Lists at most `most` names and counts the others: "a, b and 3 more".
std::string list_first(const std::vector<std::string>& names, std::size_t most);

}  // namespace treeline
