#include "interpreter/golden.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <map>
#include <sstream>

#include "interpreter/instances.hpp"

// Every function of the interpreter, in double and in 50 digits, compared with figures that another
// library computed in long double for seven robots. Would catch: misunderstandings of URDF, frames
// or conventions, which invariants cannot reveal.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

/// Largest error of each function, relative to the result's scale.
using Errors = std::map<std::string, double>;

template <class T>
Vector<T> to(const DoubleVector& x) {
  return x.template cast<T>();
}

/// Largest error. `least_scale` is for results that are zero up to the rounding of terms of that
/// size.
template <class Derived, class Expected>
double error(const Eigen::MatrixBase<Derived>& actual, const Eigen::MatrixBase<Expected>& expected,
             double least_scale) {
  EXPECT_EQ(actual.rows(), expected.rows());
  EXPECT_EQ(actual.cols(), expected.cols());
  using T = typename Derived::Scalar;
  const DoubleMatrix difference = (actual - expected.template cast<T>()).unaryExpr([](const T& x) {
    return static_cast<double>(x);
  });
  return difference.cwiseAbs().maxCoeff() / std::max(least_scale, expected.cwiseAbs().maxCoeff());
}

double condition(const DoubleMatrix& A) {
  const Eigen::VectorXd s = A.jacobiSvd().singularValues();
  return s(0) / s(s.size() - 1);
}

template <class T>
class GoldenComparison {
 public:
  explicit GoldenComparison(const GoldenRobot& golden)
      : model_(model_from_robot<T>(golden.robot, golden.scene)),
        world_(points_from_scene(model_, golden.scene.operational_points)),
        local_(world_) {
    for (auto& e : local_) e.axes = PointAxes::local;
  }

  /// Adds the errors in one state.
  void add(const GoldenState& s) {
    q_ = to<T>(s.q);
    qd_ = to<T>(s.qd);
    add_dynamics(s);
    add_kinematics(s);
    add_operational_space(s);
  }

  [[nodiscard]] const Errors& errors() const { return errors_; }

 private:
  void note(const std::string& function, double value) {
    double& worst = errors_[function];
    if (!(value <= worst)) worst = value;
  }

  void add_dynamics(const GoldenState& s) {
    const double force = s.M.cwiseAbs().maxCoeff();
    const Vector<T> qdd = to<T>(s.qdd);
    note("inverse_dynamics", error(inverse_dynamics<T>(model_, q_, qd_, qdd), s.rnea, force));
    note("gravity", error(interpreter::gravity<T>(model_, q_), s.gravity, force));
    note("nonlinear_effects",
         error(nonlinear_effects<T>(model_, q_, qd_), s.nonlinear_effects, force));
    note("mass_matrix", error(mass_matrix<T>(model_, q_), s.M, 0));
    const Vector<T> found = forward_dynamics<T>(model_, q_, qd_, to<T>(s.tau));
    note("forward_dynamics", error(found, s.aba, 1));
  }

  void add_kinematics(const GoldenState& s) {
    const auto poses = forward_kinematics<T>(model_, world_, q_);
    const Matrix<T> J_world = jacobian<T>(model_, world_, q_);
    const Matrix<T> J_local = jacobian<T>(model_, local_, q_);
    const Vector<T> bias_world = bias_acceleration<T>(model_, world_, q_, qd_);
    const Vector<T> bias_local = bias_acceleration<T>(model_, local_, q_, qd_);
    for (std::size_t e = 0; e < poses.size(); ++e) {
      const int row = 6 * static_cast<int>(e);
      const GoldenPoint& point = s.points[e];
      note("forward_kinematics", error(poses[e].position, point.position, 1));
      note("forward_kinematics", error(poses[e].rotation, point.rotation, 1));
      note("jacobian", error(J_world.middleRows(row, 6), point.J_world, 1));
      note("jacobian", error(J_local.middleRows(row, 6), point.J_local, 1));
      note("bias_acceleration", error(bias_world.segment(row, 6), point.bias_world, 1));
      note("bias_acceleration", error(bias_local.segment(row, 6), rate_in_own_axes(point, s), 1));
    }
  }

  /// Rate of the velocities along the point's own axes: the library has the conventional
  /// acceleration along them, which is more by w x v.
  static DoubleVector rate_in_own_axes(const GoldenPoint& point, const GoldenState& s) {
    const DoubleVector velocity = point.J_local * s.qd;
    DoubleVector rate = point.bias_local;
    rate.head<3>() -=
        Eigen::Vector3d(velocity.tail<3>()).cross(Eigen::Vector3d(velocity.head<3>()));
    return rate;
  }

  void add_operational_space(const GoldenState& s) {
    note("lambda_inverse", error(lambda_inverse<T>(model_, world_, q_), s.Lambda_inverse_world, 0));
    note("lambda_inverse", error(lambda_inverse<T>(model_, local_, q_), s.Lambda_inverse_local, 0));
    if (s.control_torque.size() == 0) return;
    const double slack = solve_slack(s.Lambda_inverse_world);
    note("lambda", error(lambda<T>(model_, world_, q_), s.Lambda_world, 0) / slack);
    note("lambda", error(lambda<T>(model_, local_, q_), s.Lambda_local, 0) /
                       solve_slack(s.Lambda_inverse_local));
    note("control_torque",
         error(control_torque<T>(model_, world_, q_, qd_, to<T>(s.qdd), to<T>(s.xdd)),
               s.control_torque, 1) /
             slack);
  }

  /// Factor on the tolerance for solves with Lambda^-1, which amplify errors by the condition
  /// number: in double the solve's rounding of some 1e-15; in 50 digits the rounding to double of
  /// the rotations behind the figures, of which a small part affects the solve.
  static double solve_slack(const DoubleMatrix& Lambda_inverse) {
    const double slack = std::is_same_v<T, double> ? 1e-3 : 1e-5;
    return std::max(10.0, slack * condition(Lambda_inverse));
  }

  Model<T> model_;
  Points<T> world_, local_;
  Vector<T> q_, qd_;
  Errors errors_;
};

class Golden : public testing::TestWithParam<const char*> {
 protected:
  template <class T>
  static void expect_agreement(double tolerance) {
    const GoldenRobot golden = read_golden(GetParam());
    ASSERT_GE(golden.states.size(), 20U);
    GoldenComparison<T> comparison(golden);
    for (const GoldenState& state : golden.states) comparison.add(state);
    for (const auto& [function, worst] : comparison.errors()) {
      EXPECT_LE(worst, tolerance) << function;
      std::ostringstream text;
      text << worst;
      RecordProperty(function, text.str());
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, Golden,
                         testing::Values("puma560", "samm", "humanoid24", "ur5", "panda", "anymal",
                                         "solo12"),
                         [](const testing::TestParamInfo<const char*>& tested) {
                           return std::string(tested.param);
                         });

TEST_P(Golden, Double) {
  expect_agreement<double>(1e-12);
}

// The figures are doubles, computed from rotations that were rounded to double.
TEST_P(Golden, FiftyDigits) {
  expect_agreement<Digits50>(1e-14);
}

}  // namespace
}  // namespace treeline::tests
