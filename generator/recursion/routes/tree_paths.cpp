#include "recursion/routes/tree_paths.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "core/in_eights.hpp"

namespace treeline {
namespace {

using Places = std::vector<std::int16_t>;

/// Lists of ranges, and where each list ends.
struct Ranges {
  Places ends, ranges;

  /// Adds the ranges of those rows that are marked.
  void add(const std::vector<bool>& rows) {
    for (std::size_t i = 0; i <= rows.size(); ++i) {
      const bool before = i > 0 && rows[i - 1];
      const bool here = i < rows.size() && rows[i];
      if (before != here) ranges.push_back(static_cast<std::int16_t>(i));
    }
    ends.push_back(static_cast<std::int16_t>(ranges.size() / 2));
  }
};

}  // namespace

TreePaths::TreePaths(int velocities, const std::function<bool(int k, int i)>& relates)
    : parents_(static_cast<std::size_t>(velocities), -1) {
  for (int k = 0; k < velocities; ++k) {
    int i = k - 1;
    while (i >= 0 && !relates(k, i)) --i;
    parents_[static_cast<std::size_t>(k)] = i;
  }
  // What a freedom carries has to be behind it without gaps. Where joints of several branches are
  // coupled, each freedom is taken to carry all that follow: factors are 0 where it does not.
  if (!is_contiguous()) std::iota(parents_.begin(), parents_.end(), -1);
}

std::vector<int> TreePaths::path_of(int freedom) const {
  std::vector<int> path;
  for (int i = freedom; (i = parents_[static_cast<std::size_t>(i)]) >= 0;) path.push_back(i);
  std::reverse(path.begin(), path.end());
  return path;
}

int TreePaths::row_length() const {
  std::size_t longest = 0;
  for (int k = 0; k < static_cast<int>(parents_.size()); ++k) {
    longest = std::max(longest, path_of(k).size() + 1);
  }
  return core::in_eights(static_cast<int>(longest));
}

bool TreePaths::is_contiguous() const {
  for (int k = 1; k < static_cast<int>(parents_.size()); ++k) {
    int at = k - 1;
    while (at > parents_[static_cast<std::size_t>(k)]) at = parents_[static_cast<std::size_t>(at)];
    if (at != parents_[static_cast<std::size_t>(k)]) return false;
  }
  return true;
}

int TreePaths::beyond(int freedom) const {
  const int end = static_cast<int>(parents_.size());
  int k = freedom + 1;
  while (k < end && parents_[static_cast<std::size_t>(k)] >= freedom) ++k;
  return k;
}

void TreePaths::append_to(std::vector<Table>& tables,
                          const std::function<bool(int i, int j)>& has_entry) const {
  const int n = static_cast<int>(parents_.size());
  Places behind, depths;
  Ranges strips;
  for (int i = 0; i < n; ++i) {
    depths.push_back(static_cast<std::int16_t>(path_of(i).size()));
    behind.push_back(static_cast<std::int16_t>(beyond(i)));
  }
  for (int column = 0; column < n; column += 8) {
    std::vector<bool> rows(parents_.size());
    for (int i = n; i-- > 0;) {
      const auto row = static_cast<std::size_t>(i);
      for (int j = column; j < std::min(column + 8, n); ++j) {
        rows[row] = rows[row] || i == j || has_entry(i, j);
      }
      if (rows[row] && parents_[row] >= 0) rows[static_cast<std::size_t>(parents_[row])] = true;
    }
    strips.add(rows);
  }
  tables.push_back({"beyond", behind});
  tables.push_back({"depths", depths});
  tables.push_back({"strip_ends", strips.ends});
  tables.push_back({"strips", strips.ranges});
}

void TreePaths::append_paths_to(std::vector<Table>& tables) const {
  Ranges paths;
  for (int i = 0; i < static_cast<int>(parents_.size()); ++i) {
    std::vector<bool> rows(parents_.size());
    for (const int row : path_of(i)) rows[static_cast<std::size_t>(row)] = true;
    paths.add(rows);
  }
  if (paths.ranges.empty()) paths.ranges = {0, 0};  // arrays have at least one
  tables.push_back({"path_ends", paths.ends});
  tables.push_back({"paths", paths.ranges});
}

}  // namespace treeline
