#include <algorithm>

#include "bench/bench_report.hpp"

namespace treeline {

void mark_front(std::vector<BenchRow>& rows) {
  for (BenchRow& row : rows) {
    row.on_front =
        row.variant.whole && std::none_of(rows.begin(), rows.end(), [&](const BenchRow& other) {
          if (!other.variant.whole) return false;
          const bool as_good = other.timing.nanoseconds <= row.timing.nanoseconds &&
                               other.norm.worst <= row.norm.worst;
          const bool better = other.timing.nanoseconds < row.timing.nanoseconds ||
                              other.norm.worst < row.norm.worst;
          return as_good && better;
        });
  }
}

}  // namespace treeline
