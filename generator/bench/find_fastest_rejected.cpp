#include "bench/bench_report.hpp"

namespace treeline {

std::optional<FastestRejected> find_fastest_rejected(const BenchFunction& function) {
  FastestRejected fastest;
  for (const BenchRow& row : function.rows) {
    if (row.variant.group != VariantGroup::route) continue;
    if (fastest.row == nullptr || row.timing.ratio < fastest.row->timing.ratio) fastest.row = &row;
  }
  if (fastest.row == nullptr) return std::nullopt;
  const Timing& timing = fastest.row->timing;
  fastest.is_faster = timing.ratio + 2 * timing.noise < 1 - kFasterRoute;
  return fastest;
}

}  // namespace treeline
