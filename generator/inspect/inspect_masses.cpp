#include <cmath>
#include <limits>

#include "inspect/inspect_robot.hpp"
#include "interpreter/instances.hpp"
#include "interpreter/joint_parts.hpp"
#include "oracle/model_from_robot.hpp"
#include "oracle/symmetric_matrices.hpp"

namespace treeline {
namespace {

using interpreter::Matrix;
using interpreter::Model;
using interpreter::Vector;

Vector<double> neutral_pose(const Model<double>& model) {
  Vector<double> q = Vector<double>::Zero(model.nq);
  for (const auto& body : model.bodies) {
    // The scalar part of a quaternion is its last entry.
    const int quaternion = interpreter::quaternion_of(body);
    if (quaternion >= 0) q[quaternion + 3] = 1;
  }
  return q;
}

/// The value; 0 if it does not exceed the rounding errors of so many terms of that size.
double beyond_rounding(double value, Eigen::Index terms, double size) {
  const double rounding =
      std::numeric_limits<double>::epsilon() * static_cast<double>(terms) * size;
  return std::abs(value) > rounding ? value : 0;
}

double least_of(const Eigen::VectorXd& ascending) {
  return beyond_rounding(ascending[0], ascending.size(), ascending[ascending.size() - 1]);
}

/// Ratio of the largest to the smallest eigenvalue; infinite if there is none above 0.
double condition(const Eigen::VectorXd& ascending) {
  const double least = least_of(ascending);
  return least > 0 ? ascending[ascending.size() - 1] / least
                   : std::numeric_limits<double>::infinity();
}

MassMatrixReport inspect_mass_matrix(const Matrix<double>& M) {
  MassMatrixReport report;
  const Eigen::VectorXd diagonal = M.diagonal();
  report.diagonal.assign(diagonal.data(), diagonal.data() + diagonal.size());
  const Eigen::VectorXd values = eigenvalues_of_symmetric(M);
  report.least = least_of(values);
  report.largest = values[values.size() - 1];
  report.condition = condition(values);
  report.scaled_condition = std::numeric_limits<double>::infinity();
  if (diagonal.minCoeff() > 0) {
    const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
    report.scaled_condition =
        condition(eigenvalues_of_symmetric(scale.asDiagonal() * M * scale.asDiagonal()));
  }
  return report;
}

}  // namespace

void inspect_masses(const Robot& robot, const Scene& scene, Report& report) {
  const auto model = model_from_robot<double>(robot, scene);
  const Vector<double> q = neutral_pose(model);
  interpreter::Points<double> centres;
  for (int i = 0; i < model.size(); ++i) {
    interpreter::OperationalPoint<double> centre;
    centre.body = i;
    centre.p = model.body(i).com;
    centres.push_back(centre);
  }
  const auto poses = interpreter::forward_kinematics<double>(model, centres, q);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double size = 0;
  for (int i = 0; i < model.size(); ++i) {
    const Eigen::Vector3d part = model.body(i).mass * poses[static_cast<std::size_t>(i)].position;
    moment += part;
    size += part.norm();
  }
  for (double& entry : moment) entry = beyond_rounding(entry, model.size(), size);
  if (report.mass > 0) Eigen::Map<Eigen::Vector3d>(report.com.data()) = moment / report.mass;
  if (model.nv > 0) {
    report.mass_matrix = inspect_mass_matrix(interpreter::mass_matrix<double>(model, q));
  }
}

}  // namespace treeline
