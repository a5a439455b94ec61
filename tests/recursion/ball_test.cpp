#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "interpreter/joint_model.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "random_state.hpp"
#include "recursion/methods/coriolis_matrix.hpp"
#include "recursion/methods/forward_dynamics.hpp"
#include "recursion/methods/inverse_dynamics_derivatives.hpp"
#include "recursion/methods/kinetic_energy.hpp"
#include "recursion/methods/potential_energy.hpp"

// Ball joints by what physics says of them; the other files of this folder compare them with the
// interpreter, among joints of all types. Would catch: axes of a joint that turn at a wrong rate,
// velocities in other axes than the link's, a pose in which the joint is singular, an order of the
// quaternion that differs from the floating joint's, and a quaternion that is not made a unit one.

namespace treeline::tests {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using VectorOfDouble = interpreter::Vector<double>;
using MatrixOfDouble = interpreter::Matrix<double>;

std::vector<double> listed_values(const VectorOfDouble& x) {
  return {x.data(), x.data() + x.size()};
}
VectorOfDouble vector_from(const std::vector<double>& x) {
  return VectorOfDouble::Map(x.data(), static_cast<Eigen::Index>(x.size()));
}
MatrixOfDouble matrix_from(const DenseMatrix<double>& A) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(A.values().data(), static_cast<Eigen::Index>(A.rows()),
                                static_cast<Eigen::Index>(A.cols()));
}

Tree<double> tree_from(const RandomMechanism& made) {
  return tree_of<double>(reduced_mechanism(made.robot, made.scene));
}

/// The recursions of a robot in a state.
struct AtState {
  AtState(Tree<double> of, const VectorOfDouble& q)
      : tree(std::move(of)), X(joint_transforms<double>(tree, listed_values(q))) {}
  AtState(const RandomMechanism& made, const VectorOfDouble& q) : AtState(tree_from(made), q) {}

  [[nodiscard]] VectorOfDouble forces(const VectorOfDouble& qd, const VectorOfDouble& qdd) const {
    const auto rates = listed_values(qd), growths = listed_values(qdd);
    return vector_from(inverse_dynamics<double>(tree, X, {rates, growths}, {}));
  }
  [[nodiscard]] MatrixOfDouble mass() const { return matrix_from(mass_matrix(tree, X)); }
  [[nodiscard]] MatrixOfDouble coriolis(const VectorOfDouble& qd) const {
    return matrix_from(coriolis_matrix<double>(tree, X, listed_values(qd)));
  }
  [[nodiscard]] VectorOfDouble accelerations(const VectorOfDouble& qd,
                                             const VectorOfDouble& tau) const {
    const VectorOfDouble net = tau - forces(qd, VectorOfDouble::Zero(qd.size()));
    return vector_from(solve_articulated(tree, X, articulate(tree, X), listed_values(net)));
  }
  [[nodiscard]] double energy(const VectorOfDouble& qd) const {
    return kinetic_energy<double>(tree, X, listed_values(qd)) + potential_energy(tree, X);
  }

  Tree<double> tree;
  std::vector<JointTransform<double>> X;
};

RandomMechanism tree_with_balls(std::uint64_t seed, bool floating_base) {
  RandomOptions options{
      .joints = 4, .branching = 0.3, .mix = {2, 0, 1, 1, 0, 0, 6}, .floating_base = floating_base};
  return random_mechanism(seed, options);
}

// The steps of a ball joint and the six freedoms of a floating one are different code.
class BallTwins : public testing::TestWithParam<std::uint64_t> {
 protected:
  BallTwins() : ball_(tree_with_balls(GetParam(), GetParam() % 3 == 0)), floating_(ball_) {
    for (Joint& joint : floating_.robot.joints) {
      if (joint.type == JointType::ball) joint.type = JointType::floating;
    }
    Rng rng(GetParam() + 3);
    const auto model = model_from_robot<double>(ball_.robot, ball_.scene);
    const auto twin = model_from_robot<double>(floating_.robot, floating_.scene);
    q_ = random_position(rng, model);
    qd_ = random_entries<double>(rng, model.nv, 3);
    qdd_ = random_entries<double>(rng, model.nv, 5);
    q_twin_ = VectorOfDouble::Zero(twin.nq);
    for (int i = 0; i < model.size(); ++i) {
      const auto& a = model.body(i);
      const auto& b = twin.body(i);
      const int nq = interpreter::position_count(a.kind), nv = interpreter::velocity_count(a.kind);
      const int skipped = interpreter::velocity_count(b.kind) - nv;
      q_twin_.segment(b.q + skipped, nq) = q_.segment(a.q, nq);
      for (int k = 0; k < nv; ++k) places_.push_back(b.v + skipped + k);
    }
    count_ = twin.nv;
  }

  /// Velocities of the twin whose floating joints do not slide.
  [[nodiscard]] VectorOfDouble held(const VectorOfDouble& own) const {
    VectorOfDouble all = VectorOfDouble::Zero(count_);
    all(places_) = own;
    return all;
  }
  [[nodiscard]] MatrixOfDouble rotations(const MatrixOfDouble& of_twin) const {
    return of_twin(places_, places_);
  }

  RandomMechanism ball_, floating_;
  VectorOfDouble q_, qd_, qdd_, q_twin_;
  std::vector<int> places_;  ///< of each velocity in the twin's
  int count_ = 0;
};

TEST_P(BallTwins, MoveAsFloatingJointsThatDoNotSlide) {
  const AtState ball(ball_, q_), twin(floating_, q_twin_);
  const auto expect_equal = [](const char* what, const MatrixOfDouble& actual,
                               const MatrixOfDouble& expected) {
    const double size = 1 + expected.cwiseAbs().maxCoeff();
    EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-12 * size) << what;
  };
  expect_equal("tau", ball.forces(qd_, qdd_), twin.forces(held(qd_), held(qdd_))(places_));
  expect_equal("M", ball.mass(), rotations(twin.mass()));
  expect_equal("C", ball.coriolis(qd_), rotations(twin.coriolis(held(qd_))));
  const auto derivatives = [](const AtState& run, const VectorOfDouble& qd,
                              const VectorOfDouble& qdd) {
    const auto rates = listed_values(qd), growths = listed_values(qdd);
    return inverse_dynamics_derivatives<double>(run.tree, run.X, {rates, growths}, {});
  };
  const auto own = derivatives(ball, qd_, qdd_);
  const auto other = derivatives(twin, held(qd_), held(qdd_));
  expect_equal("dtau/dq", matrix_from(own.dq), rotations(matrix_from(other.dq)));
  expect_equal("dtau/dqd", matrix_from(own.dqd), rotations(matrix_from(other.dqd)));
}

TEST_P(BallTwins, HavePositiveDefiniteMasses) {
  const MatrixOfDouble mass = AtState(ball_, q_).mass();
  EXPECT_EQ(mass, mass.transpose());
  const VectorOfDouble eigenvalues =
      Eigen::SelfAdjointEigenSolver<MatrixOfDouble>(mass).eigenvalues();
  EXPECT_GT(eigenvalues.minCoeff(), 1e-9 * eigenvalues.maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Trees, BallTwins, testing::Range<std::uint64_t>(1, 19));

/// A body on a ball joint at the origin of the world.
RandomMechanism pendulum(const Inertial& inertial) {
  RandomMechanism made;
  made.robot.name = "pendulum";
  made.robot.links = {{"base", std::nullopt, 0}, {"bob", inertial, 0}};
  made.robot.root = 0;
  Joint joint;
  joint.name = "point";
  joint.type = JointType::ball;
  joint.parent = 0;
  joint.child = 1;
  made.robot.joints = {joint};
  made.scene.noise = 0;
  return made;
}

Inertial lopsided() {
  Inertial inertial;
  inertial.mass = 1.5;
  inertial.origin.xyz = {0.1, -0.2, 0.4};
  inertial.ixx = 0.05;
  inertial.iyy = 0.07;
  inertial.izz = 0.04;
  inertial.ixy = 0.01;
  inertial.iyz = -0.005;
  return inertial;
}

Matrix3d inertia_at_centre(const Inertial& from) {
  Matrix3d J;
  J << from.ixx, from.ixy, from.ixz, from.ixy, from.iyy, from.iyz, from.ixz, from.iyz, from.izz;
  const Vector3d c(from.origin.xyz[0], from.origin.xyz[1], from.origin.xyz[2]);
  return J + from.mass * (c.dot(c) * Matrix3d::Identity() - c * c.transpose());
}

/// Rotations at which three angles about fixed axes would be singular, and others.
std::vector<Eigen::Quaterniond> rotations() {
  const double r = std::sqrt(0.5);
  return {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0},        {0, 0, 0, 1},
          {r, r, 0, 0}, {r, 0, r, 0}, {r, 0, -r, 0},       {r, 0, 0, r},
          {0, r, r, 0}, {r, 0, r, 0}, {0.5, -0.5, .5, .5}, {0.1, 0.7, -0.5, 0.5}};
}

// Euler's equations of a heavy body about a fixed point: tau = J wd + w x J w - c x m R^T g.
TEST(BallPendulum, FollowsEulersEquationsInEveryPose) {
  const Inertial bob = lopsided();
  const RandomMechanism made = pendulum(bob);
  const Matrix3d J = inertia_at_centre(bob);
  const Vector3d c(bob.origin.xyz[0], bob.origin.xyz[1], bob.origin.xyz[2]);
  const Vector3d w(0.7, -1.3, 2.1), wd(-3, 0.4, 1.9), g(0, 0, -9.81);
  for (const Eigen::Quaterniond& turn : rotations()) {
    for (const double length : {1.0, 3.0, 1e-3}) {
      const VectorOfDouble q = turn.normalized().coeffs() * length;
      const AtState run(made, q);
      EXPECT_LT((run.mass() - J).cwiseAbs().maxCoeff(), 1e-15);  // the axes are the body's own
      const Vector3d weight = bob.mass * (turn.normalized().toRotationMatrix().transpose() * g);
      const Vector3d expected = J * wd + w.cross(J * w) - c.cross(weight);
      EXPECT_LT((run.forces(w, wd) - expected).norm(), 1e-14 * expected.norm());
      EXPECT_LT((run.accelerations(w, expected) - wd).norm(), 1e-13 * wd.norm());
    }
  }
}

TEST(BallPendulum, DoesNotTurnByTheQuaternionZero) {
  const RandomMechanism made = pendulum(lopsided());
  const AtState none(made, VectorOfDouble::Zero(4)), one(made, Eigen::Vector4d(0, 0, 0, 1));
  EXPECT_EQ(none.forces(VectorOfDouble::Zero(3), VectorOfDouble::Zero(3)),
            one.forces(VectorOfDouble::Zero(3), VectorOfDouble::Zero(3)));
}

/// One step of the classical Runge-Kutta method of motion without forces.
void advance(const Tree<double>& tree, const interpreter::Model<double>& model, double h,
             VectorOfDouble& q, VectorOfDouble& qd) {
  const auto rate = [&](const VectorOfDouble& at, const VectorOfDouble& speed) {
    const VectorOfDouble slope = interpreter::position_derivative<double>(model, at, speed);
    return std::pair<VectorOfDouble, VectorOfDouble>{
        slope, AtState(tree, at).accelerations(speed, VectorOfDouble::Zero(model.nv))};
  };
  const auto [a, A] = rate(q, qd);
  const auto [b, B] = rate(q + h / 2 * a, qd + h / 2 * A);
  const auto [c, C] = rate(q + h / 2 * b, qd + h / 2 * B);
  const auto [d, D] = rate(q + h * c, qd + h * C);
  q += h / 6 * (a + 2 * b + 2 * c + d);
  qd += h / 6 * (A + 2 * B + 2 * C + D);
}

// The first swings through all poses, the others are chains and trees of balls and other joints.
TEST(BallPendulum, KeepsItsEnergy) {
  std::vector<RandomMechanism> robots{pendulum(lopsided())};
  for (const std::uint64_t seed : {2U, 5U}) robots.push_back(tree_with_balls(seed, false));
  for (const RandomMechanism& made : robots) {
    const auto model = model_from_robot<double>(made.robot, made.scene);
    Rng rng(9);
    VectorOfDouble q = random_position(rng, model), qd = random_entries<double>(rng, model.nv, 2);
    const Tree<double> tree = tree_from(made);
    const double before = AtState(tree, q).energy(qd);
    for (int step = 0; step < 1000; ++step) advance(tree, model, 2e-4, q, qd);
    // The method's error, of order h^4, is some 1e-11 of the energies that change.
    EXPECT_NEAR(AtState(tree, q).energy(qd), before, 1e-7 * (1 + std::abs(before)));
  }
}

}  // namespace
}  // namespace treeline::tests
