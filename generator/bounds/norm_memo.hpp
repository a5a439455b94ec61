#pragma once

#include <map>
#include <vector>

#include "bounds/operator_norm.hpp"

namespace treeline::bounds {

/// Norms of matrices that recur: a joint turns many vectors, all in the same way.
class NormMemo {
 public:
  struct Norms {
    std::vector<double> columns;  ///< see `column_norms`
    double scaled = 0;            ///< see `operator_norm`, with the columns divided by these
  };

  const Norms& of(const TrigMatrix& A);

 private:
  std::map<std::vector<double>, Norms> found_;  ///< by all that the norms depend on
};

}  // namespace treeline::bounds
