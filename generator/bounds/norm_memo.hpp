#pragma once

#include <cstdint>
#include <vector>

#include "bounds/operator_norm.hpp"
#include "bounds/word_memo.hpp"

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
  WordMemo<Norms> found_;
  std::vector<std::uint64_t> key_;  ///< everything that the norms asked for depend on
};

}  // namespace treeline::bounds
