#include "bounds/norm_memo.hpp"

#include <bit>
#include <utility>

namespace treeline::bounds {
namespace {

/// Entries of the matrix without their angle, on which no norm depends. Of each its place, which of
/// its coefficients are not 0, and these.
void describe(const TrigMatrix& A, std::vector<std::uint64_t>& key) {
  key.clear();
  key.push_back(std::uint64_t{A.rows} << 32 | A.columns);
  for (const MatrixEntry& entry : A.entries) {
    const std::size_t head = key.size();
    key.push_back(std::uint64_t{entry.row} << 36 | std::uint64_t{entry.column} << 8);
    for (std::size_t i = 0; i < entry.value.c.size(); ++i) {
      if (entry.value.c[i] == 0) continue;
      key[head] |= std::uint64_t{1} << i;
      key.push_back(std::bit_cast<std::uint64_t>(entry.value.c[i]));
    }
  }
}

}  // namespace

const NormMemo::Norms& NormMemo::of(const TrigMatrix& A) {
  describe(A, key_);
  if (const Norms* const found = found_.find(key_)) return *found;
  Norms norms{column_norms(A), 0};
  norms.scaled = operator_norm(A, norms.columns);
  return found_.add(key_, std::move(norms));
}

}  // namespace treeline::bounds
