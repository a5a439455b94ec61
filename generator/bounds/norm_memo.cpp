#include "bounds/norm_memo.hpp"

namespace treeline::bounds {
namespace {

/// Entries of the matrix without their angle, on which no norm depends.
std::vector<double> key_of(const TrigMatrix& A) {
  std::vector<double> key;
  key.reserve(2 + 7 * A.entries.size());
  key.push_back(static_cast<double>(A.rows));
  key.push_back(static_cast<double>(A.columns));
  for (const MatrixEntry& entry : A.entries) {
    key.push_back(static_cast<double>(entry.row));
    key.push_back(static_cast<double>(entry.column));
    key.insert(key.end(), entry.value.c.begin(), entry.value.c.end());
  }
  return key;
}

}  // namespace

const NormMemo::Norms& NormMemo::of(const TrigMatrix& A) {
  const auto [at, is_new] = found_.try_emplace(key_of(A));
  if (is_new) {
    at->second.columns = column_norms(A);
    at->second.scaled = operator_norm(A, at->second.columns);
  }
  return at->second;
}

}  // namespace treeline::bounds
