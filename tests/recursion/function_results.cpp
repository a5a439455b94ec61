#include "recursion/function_results.hpp"

#include <Eigen/SVD>
#include <limits>

#include "oracle/model_from_robot.hpp"

namespace treeline::tests {
namespace {

template <class Scalar>
interpreter::Vector<Scalar> vector(const std::vector<Scalar>& values) {
  return Eigen::Map<const interpreter::Vector<Scalar>>(values.data(),
                                                       static_cast<Eigen::Index>(values.size()));
}

}  // namespace

template <class Scalar>
Oracle<Scalar>::Oracle(const Robot& robot, const Scene& scene)
    : model_(model_from_robot<Scalar>(robot, scene)),
      points_(points_from_scene(model_, scene.operational_points)),
      forces_(points_from_scene(model_, scene.external_forces)) {}

template <class Scalar>
Inputs<Scalar> Oracle<Scalar>::random_inputs(Rng& rng, double size) const {
  const auto drawn = [&](int count) { return listed(random_entries<Scalar>(rng, count, size)); };
  return {listed(random_position(rng, model_, size)),
          drawn(model_.nv),
          drawn(model_.nv),
          drawn(model_.nv),
          drawn(task_rows()),
          drawn(6 * static_cast<int>(forces_.size()))};
}

template <class Scalar>
interpreter::Matrix<Scalar> Oracle<Scalar>::mass_matrix(const Inputs<Scalar>& in) const {
  return interpreter::mass_matrix<Scalar>(model_, vector(in.q));
}

template <class Scalar>
interpreter::Matrix<Scalar> Oracle<Scalar>::lambda_inverse(const Inputs<Scalar>& in) const {
  return interpreter::lambda_inverse<Scalar>(model_, points_, vector(in.q));
}

template <class Scalar>
Results<Scalar> Oracle<Scalar>::results(Function function, const Inputs<Scalar>& in) const {
  namespace ip = interpreter;
  const auto q = vector(in.q), qd = vector(in.qd), qdd = vector(in.qdd), f = vector(in.f_ext);
  switch (function) {
    case Function::forward_kinematics:
      return poses(in);
    case Function::jacobian:
      return {listed(ip::jacobian<Scalar>(model_, points_, q))};
    case Function::bias_acceleration:
      return {listed(ip::bias_acceleration<Scalar>(model_, points_, q, qd))};
    case Function::inverse_dynamics:
      return {listed(ip::inverse_dynamics<Scalar>(model_, q, qd, qdd, forces_, f))};
    case Function::gravity:
      return {listed(ip::gravity<Scalar>(model_, q))};
    case Function::nonlinear_effects:
      return {listed(ip::nonlinear_effects<Scalar>(model_, q, qd))};
    case Function::mass_matrix:
      return {listed(mass_matrix(in))};
    case Function::coriolis_matrix:
      return {listed(ip::coriolis_matrix<Scalar>(model_, q, qd))};
    case Function::kinetic_energy:
      return {{ip::kinetic_energy<Scalar>(model_, q, qd)}};
    case Function::potential_energy:
      return {{ip::potential_energy<Scalar>(model_, q)}};
    case Function::forward_dynamics:
      return {listed(ip::forward_dynamics<Scalar>(model_, q, qd, vector(in.tau), forces_, f))};
    case Function::lambda_inverse:
      return {listed(lambda_inverse(in))};
    case Function::lambda:
      return {listed(ip::lambda<Scalar>(model_, points_, q))};
    case Function::control_torque:
      return {listed(
          ip::control_torque<Scalar>(model_, points_, q, qd, qdd, vector(in.xdd_cmd), forces_, f))};
    default:  // those of objects, contacts, posture and derivatives have tests of their own
      break;
  }
  return {};
}

template <class Scalar>
Results<Scalar> Oracle<Scalar>::poses(const Inputs<Scalar>& in) const {
  Results<Scalar> results(2);
  for (const auto& pose : interpreter::forward_kinematics<Scalar>(model_, points_, vector(in.q))) {
    for (const Scalar& x : listed(pose.position)) results[0].push_back(x);
    for (const Scalar& x : listed(pose.rotation)) results[1].push_back(x);
  }
  return results;
}

template class Oracle<Digits50>;

double condition(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return 1;
  const Eigen::VectorXd s = A.jacobiSvd().singularValues();
  const double smallest = s(s.size() - 1);
  return smallest > 0 ? s(0) / smallest : std::numeric_limits<double>::infinity();
}

template <class Scalar>
Yardstick yardstick(const Oracle<Scalar>& oracle, const Inputs<Scalar>& in) {
  const auto M = oracle.mass_matrix(in);
  Yardstick result;
  result.force = static_cast<double>(M.cwiseAbs().maxCoeff());
  result.condition_M = condition(M);
  if (oracle.has_points()) result.condition_task = condition(oracle.lambda_inverse(in));
  return result;
}
template Yardstick yardstick(const Oracle<Digits50>&, const Inputs<Digits50>&);

}  // namespace treeline::tests
