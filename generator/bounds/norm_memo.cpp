#include "bounds/norm_memo.hpp"

#include <bit>

#include "program/hash_word.hpp"

namespace treeline::bounds {
namespace {

/// Entries of the matrix without their angle, on which no norm depends. Of each its place, which of
/// its coefficients are not 0, and these.
std::vector<std::uint64_t> key_of(const TrigMatrix& A) {
  std::vector<std::uint64_t> key;
  key.reserve(1 + 4 * A.entries.size());
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
  return key;
}

}  // namespace

std::size_t NormMemo::Hash::operator()(const Key& key) const {
  std::uint64_t hash = key.size();
  for (const std::uint64_t part : key) hash = hash_word(hash, part);
  return static_cast<std::size_t>(hash);
}

const NormMemo::Norms& NormMemo::of(const TrigMatrix& A) {
  const auto [at, is_new] = found_.try_emplace(key_of(A));
  if (is_new) {
    at->second.columns = column_norms(A);
    at->second.scaled = operator_norm(A, at->second.columns);
  }
  return at->second;
}

}  // namespace treeline::bounds
