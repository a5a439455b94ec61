#include "description/suggest_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace treeline {
namespace {

constexpr std::size_t kFew = 12;
// Beyond this length a name is no slip of the keyboard, and the table grows with the square.
constexpr std::size_t kLongest = 256;

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

std::string suggest_name(std::string_view name, const std::vector<std::string>& known,
                         std::string_view otherwise) {
  const std::string* nearest = nullptr;
  std::size_t shortest = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : known) {
    if (std::max(name.size(), candidate.size()) > kLongest) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < shortest) {
      shortest = distance;
      nearest = &candidate;
    }
  }
  if (nearest != nullptr) return fmt::format("did you mean \"{}\"?", *nearest);
  if (known.empty() || known.size() > kFew) return {};
  return fmt::format("{} {}", otherwise, fmt::join(known, ", "));
}

}  // namespace treeline
