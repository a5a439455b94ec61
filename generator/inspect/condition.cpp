#include "inspect/condition.hpp"

#include "oracle/condition.hpp"

namespace treeline {

double unit_condition(const Eigen::MatrixXd& A) {
  return scaled_condition(A, A.diagonal());
}

}  // namespace treeline
