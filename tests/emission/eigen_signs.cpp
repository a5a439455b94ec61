// Compiled under -Wsign-conversion: see CMakeLists.txt. Every kind of object that a wrapper takes.
#include "sample_double_eigen.hpp"

void call_with_objects();
void call_with_objects() {
  namespace eigen = sample_double::eigen;
  eigen::Vector<3> q = eigen::Vector<3>::Zero();
  const Eigen::VectorXd unread = Eigen::VectorXd::Zero(2);
  Eigen::Matrix<double, 4, 3> out;  // column after column: copied
  Eigen::VectorXd second;
  eigen::corner_cases(q, unread, q.head<2>() * 2.0, out, second);
}
