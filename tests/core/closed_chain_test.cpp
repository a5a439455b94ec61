// The closed chain of several robots' generated code, compared with the interpreter's Chang chapter
// 7 and the equations that define it. Would catch: a wrong sign, wrong axes or reference point, and
// a linkage that differs from the interpreter's.
#include "core/closed_chain.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "interpreter/virtual_linkage.hpp"

namespace treeline::test {
namespace {

namespace ip = interpreter;
using Vector = Eigen::VectorXd;

// A few dozen operations on numbers of size one: 1e-13 is some hundred ulp.
constexpr double kTolerance = 1e-13;

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double number() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  Eigen::Vector3d vector() { return {number(), number(), number()}; }
  Eigen::Matrix3d rotation() {
    return Eigen::AngleAxisd(3 * number(), vector().normalized()).toRotationMatrix();
  }

 private:
  std::mt19937 engine_;
};

ip::GraspedObject<double> draw_object(Draw& draw) {
  ip::GraspedObject<double> object;
  object.mass = 2 + draw.number();
  object.com = draw.vector();
  const Eigen::Matrix3d A = draw.rotation();
  object.inertia = A * Eigen::Vector3d(0.3, 0.5, 0.6).asDiagonal() * A.transpose();
  for (int i = 0; i < 2; ++i) {
    ip::Grasp<double> grasp;
    grasp.R = draw.rotation();
    grasp.p = draw.vector();
    object.grasps.push_back(grasp);
  }
  return object;
}

core::GraspedObject<double> core_object(const ip::GraspedObject<double>& from) {
  core::GraspedObject<double> object;
  object.mass = from.mass;
  for (int i = 0; i < 3; ++i) {
    object.center[i] = from.com(i);
    for (int j = 0; j < 3; ++j) {
      object.inertia[3 * i + j] = from.inertia(i, j);
    }
  }
  return object;
}

template <int N>
void fill(const Eigen::MatrixXd& from, double (&to)[N]) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = from;
  std::copy(rows.data(), rows.data() + N, to);
}

TEST(ClosedChain, ObjectWrenchIsTheInterpreters) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    Draw draw(seed);
    const auto object = draw_object(draw);
    ip::HeldPose<double> held;
    held.R = draw.rotation();
    held.v << draw.vector(), 3 * draw.vector();
    const ip::Vector3<double> gravity = 9 * draw.vector();
    ip::Vector6<double> xdd;
    xdd << draw.vector(), draw.vector();
    const auto bias = ip::object_bias<double>(object, held, gravity);
    const Vector expected = ip::object_inertia(object, held.R) * xdd + bias.mu + bias.p;
    double R[9], w[3], a[6], g[3], wrench[6];
    fill(held.R, R);
    fill(held.v.tail<3>(), w);
    fill(xdd, a);
    fill(gravity, g);
    core::object_wrench(core_object(object), R, w, a, g, wrench);
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(wrench[i], expected(i), kTolerance * expected.norm()) << "seed " << seed;
    }
  }
}

TEST(ClosedChain, SplitsOverTwoGraspsAsTheInterpreterAndReadsBack) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    Draw draw(seed);
    const auto object = draw_object(draw);
    Eigen::Vector3d r[2];
    double points[2][3];
    for (int i = 0; i < 2; ++i) {
      const auto& grasp = object.grasps[static_cast<std::size_t>(i)];
      r[i] = -(grasp.R.transpose() * grasp.p);
      fill(r[i], points[i]);
    }
    core::TwoGrasps<double> linkage;
    ASSERT_TRUE(core::make_two_grasps(points[0], points[1], linkage));
    double resultant[6], internal[6], forces[2][6], back[6];
    ip::Vector6<double> F, t;
    F << draw.vector(), draw.vector();
    t << draw.vector(), draw.vector();
    fill(F, resultant);
    fill(t, internal);
    core::split_over_grasps(linkage, resultant, internal, forces);
    const Vector expected = ip::split_over_grasps<double>(object, F, t);
    const double scale = kTolerance * (1 + expected.norm()) / std::min(1.0, (r[0] - r[1]).norm());
    for (int hand = 0; hand < 2; ++hand) {
      const Eigen::Vector3d f = expected.segment<3>(6 * hand);
      const Eigen::Vector3d moment = expected.segment<3>(6 * hand + 3) + r[hand].cross(f);
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(forces[hand][i], f(i), scale) << "seed " << seed;
        EXPECT_NEAR(forces[hand][3 + i], moment(i), scale) << "seed " << seed;
      }
    }
    core::read_internal_forces(linkage, forces, back);
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(back[i], internal[i], 10 * scale) << "seed " << seed;
    }
  }
}

TEST(ClosedChain, RefusesGraspsAtOnePlace) {
  const double point[3] = {0.1, 0.2, 0.3};
  core::TwoGrasps<double> linkage;
  EXPECT_FALSE(core::make_two_grasps(point, point, linkage));
}

// f_i = Lambda_i (xdd_i - xdd), and their sum is the force that the object needs.
TEST(ClosedChain, GraspForcesMoveTheObject) {
  Draw draw(7);
  const auto spd = [&] {
    Eigen::Matrix<double, 6, 6> A;
    for (int i = 0; i < 36; ++i) {
      A(i) = draw.number();
    }
    return Eigen::MatrixXd(A * A.transpose() + Eigen::Matrix<double, 6, 6>::Identity());
  };
  double object[36], bias[6], Lambda[3][36], xdd_free[3][6], xdd[6], forces[3][6];
  fill(spd(), object);
  for (double& x : bias) {
    x = draw.number();
  }
  for (int robot = 0; robot < 3; ++robot) {
    fill(spd(), Lambda[robot]);
    for (double& x : xdd_free[robot]) {
      x = draw.number();
    }
  }
  ASSERT_TRUE(core::grasp_forces<3>(object, bias, Lambda, xdd_free, xdd, forces));
  for (int i = 0; i < 6; ++i) {
    double asked = bias[i], given = 0;
    for (int j = 0; j < 6; ++j) {
      asked += object[6 * i + j] * xdd[j];
    }
    for (int robot = 0; robot < 3; ++robot) {
      given += forces[robot][i];
    }
    EXPECT_NEAR(given, asked, 1e-12);
  }
}

}  // namespace
}  // namespace treeline::test
