#include "recursion/routes/list_row_sums.hpp"

#include <cstdint>
#include <vector>

namespace treeline {

void list_row_sums(const std::function<int(int k, int i)>& place, Ending& ending) {
  std::vector<std::int16_t> ends[2];
  std::vector<std::int16_t> entries[2];
  const auto add = [&](int side, int row, int factor) {
    if (factor < 0) return;
    entries[side].push_back(static_cast<std::int16_t>(row));
    entries[side].push_back(static_cast<std::int16_t>(factor));
  };
  for (int row = 0; row < ending.velocities; ++row) {
    for (int k = ending.velocities; k-- > row + 1;) add(0, k, place(k, row));
    for (int i = 0; i < row; ++i) add(1, i, place(row, i));
    for (const int side : {0, 1}) {
      ends[side].push_back(static_cast<std::int16_t>(entries[side].size() / 2));
    }
  }
  ending.tables.push_back({"above_ends", ends[0]});
  ending.tables.push_back({"above", entries[0]});
  ending.tables.push_back({"below_ends", ends[1]});
  ending.tables.push_back({"below", entries[1]});
}

}  // namespace treeline
