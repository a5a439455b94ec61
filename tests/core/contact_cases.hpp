#pragma once
// Problems of contacts for tests and for other programs: random matrices, robots on legs, bodies
// in contact, with masses apart by up to 1e6 and contacts that depend on each other.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "core/contact_solver.hpp"

namespace treeline::test {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;
using Eigen::Vector3d;

struct ContactProblem {
  Matrix A;
  Vector v;
  std::vector<core::ContactLaw<double>> laws;
};

/// What moves at the contacts. `matrix`: J of full rank; `redundant`: J of six to thirty freedoms;
/// `graded`: the same with freedoms apart by 1e3, so inertias by 1e6; `legs`: a body on four legs
/// of three joints, contacts on the feet; `bodies`: up to four bodies in contact with each other
/// and the ground, masses apart by up to 1e6.
enum class ContactKind { matrix, redundant, graded, legs, bodies };

inline constexpr ContactKind kContactKinds[] = {ContactKind::matrix, ContactKind::redundant,
                                                ContactKind::graded, ContactKind::legs,
                                                ContactKind::bodies};

inline Vector3d normal_of(const core::ContactLaw<double>& law) {
  return Vector3d::Map(law.normal);
}

class ContactDraw {
 public:
  explicit ContactDraw(std::uint64_t seed) : engine_(seed) {}

  double number() { return uniform_(engine_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  Matrix matrix(int rows, int columns) {
    return Matrix::NullaryExpr(rows, columns, [this] { return number(); });
  }
  Vector3d vector() { return matrix(3, 1); }

  /// Contacts of a kind that do not bounce, at random friction of 0.3 to 1.
  ContactProblem problem(ContactKind kind, int count) {
    ContactProblem problem;
    const Matrix J = jacobian(kind, count);
    Vector qd = matrix(static_cast<int>(J.cols()), 1);
    const bool falls = kind == ContactKind::legs || kind == ContactKind::bodies;
    for (Eigen::Index i = 2; falls && i < J.cols(); i += 6) qd[i] -= 1;
    problem.A = J * J.transpose();
    problem.v = J * qd;
    for (int i = 0; i < count; ++i) {
      core::ContactLaw<double> law;
      const double lean = kind == ContactKind::legs ? 0 : kind == ContactKind::bodies ? 0.3 : 1e3;
      const Vector3d n = (Vector3d::UnitZ() + lean * vector()).normalized();
      Vector3d::Map(law.normal) = n;
      constexpr double kFrictions[] = {0.3, 0.7, 1};
      law.friction = kFrictions[below(3)];
      problem.laws.push_back(law);
    }
    return problem;
  }

 private:
  Matrix jacobian(ContactKind kind, int count) {
    switch (kind) {
      case ContactKind::matrix:
        return matrix(3 * count, 3 * count + 4);
      case ContactKind::redundant:
        return matrix(3 * count, 6 + below(25));
      case ContactKind::graded: {
        Matrix J = matrix(3 * count, 6 + below(25));
        for (Eigen::Index i = 0; i < J.cols(); ++i) J.col(i) *= std::pow(10, 1.5 * number());
        return J;
      }
      case ContactKind::legs:
        return legs(count);
      case ContactKind::bodies:
        return bodies(count);
    }
    return {};
  }

  /// Velocity of a point of a body by its twist.
  static Eigen::Matrix<double, 3, 6> twist(const Vector3d& r) {
    Eigen::Matrix<double, 3, 6> T;
    T << Eigen::Matrix3d::Identity(),
        -(Eigen::Matrix3d() << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0).finished();
    return T;
  }

  Matrix legs(int count) {
    Matrix J = Matrix::Zero(3 * count, 18);
    for (int i = 0; i < count; ++i) {
      const Vector3d r(0.5 * number(), 0.3 * number(), -0.5 + 0.05 * number());
      J.block<3, 6>(3 * i, 0) = twist(r);
      J.block<3, 3>(3 * i, 3) *= 3;  // 1 / sqrt(inertia)
      J.block<3, 3>(3 * i, 6 + 3 * (i % 4)) = 3 * matrix(3, 3);
    }
    return J;
  }

  Matrix bodies(int count) {
    const int bodies = 1 + below(4);
    std::vector<double> masses;
    for (int i = 0; i < bodies; ++i) masses.push_back(std::pow(10, 3 * number()));
    Matrix J = Matrix::Zero(3 * count, 6 * bodies);
    for (int i = 0; i < count; ++i) {
      const int one = below(bodies), other = below(bodies + 1);  // as many as there are: the ground
      const auto touch = [&](int body, double sign) {
        const double per_mass = sign / std::sqrt(masses[static_cast<std::size_t>(body)]);
        auto own = J.block<3, 6>(3 * i, 6 * body);
        own = per_mass * twist(0.5 * vector());
        own.rightCols<3>() *= 2.5;
      };
      touch(one, 1);
      if (other != one && other < bodies) touch(other, -1);
    }
    return J;
  }

  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

}  // namespace treeline::test
