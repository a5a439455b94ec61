#pragma once

#include <map>
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
  std::map<std::vector<double>, Norms> found_;  ///< by everything that the norms depend on
};

}  // namespace treeline::bounds
