#include "text/suggest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace treeline {
namespace {

constexpr std::size_t kMostNamed = 60;
constexpr std::size_t kColumns = 90;
constexpr std::size_t kMostContaining = 3;
constexpr std::size_t kShortestPart = 3;
// Beyond this length a name is no slip of the keyboard, and the table grows with the square.
constexpr std::size_t kLongest = 256;

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// The slips that a name of this length may have. One letter is as near to any other.
std::size_t most_slips(std::size_t length) {
  return length < 2 ? 0 : std::max<std::size_t>(1, length / 3);
}

const std::string* find_slip(const std::string& name, const std::vector<std::string>& known) {
  const std::string* nearest = nullptr;
  std::size_t shortest = most_slips(name.size()) + 1;
  for (const std::string& candidate : known) {
    if (std::max(name.size(), candidate.size()) > kLongest) continue;
    const std::string lower = lower_case(candidate);
    const std::size_t distance = edit_distance(name, lower);
    // Of two that are as near, the one that begins with what was written: `m4f` for `m4`, not `m0`.
    const bool goes_on = nearest != nullptr && distance == shortest && lower.starts_with(name) &&
                         !lower_case(*nearest).starts_with(name);
    if (distance < shortest || goes_on) {
      shortest = distance;
      nearest = &candidate;
    }
  }
  return nearest;
}

bool contains(std::string_view whole, std::string_view part) {
  return part.size() >= kShortestPart && whole.find(part) != std::string_view::npos;
}

/// Finds the known names that contain the name; if there are none, the longest that it contains.
std::vector<std::string> find_containing(const std::string& name,
                                         const std::vector<std::string>& known) {
  std::vector<std::string> containing;
  std::vector<std::string> contained;
  for (const std::string& candidate : known) {
    if (contains(lower_case(candidate), name)) containing.push_back(candidate);
    const bool longer = contained.empty() || candidate.size() > contained.back().size();
    if (longer && contains(name, lower_case(candidate))) contained = {candidate};
  }
  return containing.empty() ? contained : containing;
}

struct CalledElsewhere {
  std::string_view word;    ///< what people write
  std::string_view choice;  ///< one of the choices where that is meant
  std::string_view meant;   ///< what to write
};

constexpr CalledElsewhere kCalledElsewhere[] = {{"cpp", "c++", "\"c++\""},
                                                {"cxx", "c++", "\"c++\""},
                                                {"c99", "c++", "\"c\""},
                                                {"python", "c++", "`generate --package python`"},
                                                {"rust", "c++", "`generate --package rust`"},
                                                {"float32", "float", "\"float\""},
                                                {"single", "float", "\"float\""},
                                                {"float64", "double", "\"double\""}};

}  // namespace

std::size_t edit_distance(std::string_view left, std::string_view right) {
  std::vector<std::size_t> before(right.size() + 1), last(right.size() + 1), row(right.size() + 1);
  for (std::size_t j = 0; j <= right.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= left.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (left[i - 1] == right[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped =
          i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[right.size()];
}

std::string find_near_name(std::string_view name, const std::vector<std::string>& known) {
  const std::string asked = lower_case(name);
  if (const std::string* slip = find_slip(asked, known)) {
    return fmt::format("did you mean \"{}\"?", *slip);
  }
  const std::vector<std::string> near = find_containing(asked, known);
  if (near.empty() || near.size() > kMostContaining) return {};
  return fmt::format("did you mean \"{}\"?", fmt::join(near, "\" or \""));
}

std::string list_names(const std::vector<std::string>& names) {
  const std::size_t listed = std::min(names.size(), kMostNamed);
  std::string text;
  std::size_t line = 0;
  for (std::size_t i = 0; i < listed; ++i) {
    const std::string word = names[i] + (i + 1 < names.size() ? "," : "");
    const bool breaks = line > 0 && line + 1 + word.size() > kColumns;
    if (i > 0) text += breaks ? '\n' : ' ';
    line = breaks ? word.size() : line + 1 + word.size();
    text += word;
  }
  if (listed < names.size()) text += fmt::format(" and {} more", names.size() - listed);
  return text;
}

std::string suggest_name(std::string_view name, const std::vector<std::string>& known,
                         std::string_view otherwise) {
  if (known.empty()) return {};
  const std::string near = find_near_name(name, known);
  return near.empty() ? fmt::format("{} {}", otherwise, list_names(known)) : near;
}

std::string suggest_choice(std::string_view given, const std::vector<std::string>& choices) {
  std::string near = find_near_name(given, choices);
  for (const auto& [word, choice, meant] : kCalledElsewhere) {
    const bool asked = std::find(choices.begin(), choices.end(), choice) != choices.end();
    if (asked && lower_case(given) == word) near = fmt::format("did you mean {}?", meant);
  }
  return fmt::format("{}{}the choices are {}", near, near.empty() ? "" : " ", list_names(choices));
}

std::string list_first(const std::vector<std::string>& names, std::size_t most) {
  const auto shown = static_cast<std::ptrdiff_t>(std::min(names.size(), most));
  std::string text = fmt::format("{}", fmt::join(names.begin(), names.begin() + shown, ", "));
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

}  // namespace treeline
