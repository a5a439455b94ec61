#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "bounds/operator_norm.hpp"

namespace treeline::bounds {

/// Remembers norms of matrices. The same matrices recur because a joint turns many vectors in the
/// same way.
class NormMemo {
 public:
  struct Norms {
    std::vector<double> columns;  ///< see `column_norms`
    double scaled = 0;            ///< see `operator_norm`, with these columns as scale
  };

  const Norms& of(const TrigMatrix& A);

 private:
  using Key = std::vector<std::uint64_t>;  ///< everything that the norms depend on
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  std::unordered_map<Key, Norms, Hash> found_;
};

}  // namespace treeline::bounds
