#include <cmath>
#include <cstddef>

#include "interpreter/center_of_mass.hpp"
#include "interpreter/joint_parts.hpp"
#include "oracle/term_sizes.hpp"

// Sizes of what is about momentum and the centre of mass, of the motion of points, and of the
// derivatives of both.

namespace treeline {
namespace {

using interpreter::kWorld;

/// Number of the first bodies of which each carries all others, up to the first with a mass.
int bodies_before_matter(const interpreter::Model<double>& model) {
  int last = kWorld;
  while (true) {
    int next = kWorld;
    for (int i = 0; i < model.size(); ++i) {
      if (model.body(i).parent != last) continue;
      if (next != kWorld) return last + 1;
      next = i;
    }
    if (next == kWorld) return last + 1;
    last = next;
    if (model.body(last).mass != 0) return last + 1;
  }
}

/// |I| about the body's centre of mass.
double turning_inertia(const interpreter::Body<double>& body) {
  const auto C = interpreter::cross_matrix(body.com);
  return (body.inertia + body.mass * C * C).norm();
}

}  // namespace

/// Distances of the bodies' centres of mass from that of all, m: paths from the first body with a
/// mass that carries all others, since where that is does not matter.
std::vector<double> TermSizes::arms() const {
  const auto& model = subject_.model;
  const int before = bodies_before_matter(model);
  std::vector<double> arms;
  double moment = 0;
  for (int i = 0; i < model.size(); ++i) {
    double path = model.body(i).com.norm();
    for (int j = i; j >= before; j = model.body(j).parent) {
      path += lengths_[static_cast<std::size_t>(j)];
    }
    arms.push_back(path);
    moment += model.body(i).mass * path;
  }
  for (double& arm : arms) arm += moment / interpreter::total_mass(model);
  return arms;
}

Eigen::MatrixXd TermSizes::centroidal_momentum_matrix() const {
  const auto& model = subject_.model;
  const std::vector<double> arm = arms();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6, model.nv);
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    for (const Column& column : columns(i, body.com.norm())) {
      const double P = body.mass * column.lever;
      A.col(column.v).head<3>().array() += P;
      A.col(column.v).tail<3>().array() +=
          arm[static_cast<std::size_t>(i)] * P + turning_inertia(body) * column.turn;
    }
  }
  return A;
}

Eigen::VectorXd TermSizes::centroidal_momentum(const std::vector<double>& qd) const {
  Eigen::VectorXd speeds(static_cast<Eigen::Index>(qd.size()));
  for (std::size_t i = 0; i < qd.size(); ++i) {
    speeds(static_cast<Eigen::Index>(i)) = std::abs(qd[i]);
  }
  return centroidal_momentum_matrix() * speeds;
}

Eigen::VectorXd TermSizes::centroidal_bias(const std::vector<double>& qd) const {
  const auto& model = subject_.model;
  const std::vector<double> none(qd.size(), 0);
  const std::vector<double> arm = arms();
  Eigen::VectorXd bias = Eigen::VectorXd::Zero(6);
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    const Motion of = motion(columns(i, body.com.norm()), qd, none);
    const double f = body.mass * of.a;
    bias.head<3>().array() += f;
    bias.tail<3>().array() +=
        arm[static_cast<std::size_t>(i)] * f + turning_inertia(body) * (of.alpha + of.w * of.w);
  }
  return bias;
}

Eigen::VectorXd TermSizes::subtrees() const {
  const auto& model = subject_.model;
  std::vector<double> masses;
  std::vector<double> lengths;
  for (int root = 0; root < model.size(); ++root) {
    if (model.body(root).kind == interpreter::JointKind::fixed) continue;
    double mass = 0;
    double moment = 0;
    for (int i = root; i < model.size(); ++i) {
      int ancestor = i;
      while (ancestor > root) ancestor = model.body(ancestor).parent;
      if (ancestor != root) continue;
      mass += model.body(i).mass;
      moment += model.body(i).mass * (path_to(i) + model.body(i).com.norm());
    }
    masses.push_back(mass);
    lengths.insert(lengths.end(), 3, mass == 0 ? path_to(root) : moment / mass);
  }
  masses.insert(masses.end(), lengths.begin(), lengths.end());
  return Eigen::Map<Eigen::VectorXd>(masses.data(), static_cast<Eigen::Index>(masses.size()));
}

Eigen::VectorXd TermSizes::point_velocities(const std::vector<double>& qd) const {
  const std::vector<double> none(qd.size(), 0);
  Eigen::VectorXd sizes(6 * static_cast<Eigen::Index>(subject_.points.size()));
  Eigen::Index row = 0;
  for (const auto& point : subject_.points) {
    const Motion of = motion_of(point, qd, none);
    sizes.segment<3>(row).setConstant(of.v);
    sizes.segment<3>(row + 3).setConstant(of.w);
    row += 6;
  }
  return sizes;
}

Eigen::VectorXd TermSizes::point_accelerations(const std::vector<double>& qd,
                                               const std::vector<double>& qdd) const {
  Eigen::VectorXd sizes(6 * static_cast<Eigen::Index>(subject_.points.size()));
  Eigen::Index row = 0;
  for (const auto& point : subject_.points) {
    const Motion of = motion_of(point, qd, qdd);
    sizes.segment<3>(row).setConstant(of.a);
    sizes.segment<3>(row + 3).setConstant(of.alpha);
    row += 6;
  }
  return sizes;
}

/// A displacement turns a velocity, and moves what has it to where others prevail.
TermSizes::Pair TermSizes::velocity_change(const Motion& of, const Column& by) {
  return {of.w * by.lever + of.v * by.turn, of.w * by.turn};
}

TermSizes::Pair TermSizes::acceleration_change(const Motion& of, const Column& by) {
  return {(of.alpha + of.w * of.w) * by.lever + of.a * by.turn, of.alpha * by.turn};
}

template <class Change>
Eigen::MatrixXd TermSizes::point_columns(const std::vector<double>& qd,
                                         const std::vector<double>& qdd, Change change) const {
  Eigen::MatrixXd sizes = Eigen::MatrixXd::Zero(
      6 * static_cast<Eigen::Index>(subject_.points.size()), subject_.model.nv);
  Eigen::Index row = 0;
  for (const auto& point : subject_.points) {
    const Columns own = columns(point.body, point.p.norm());
    const Motion of = motion(own, qd, qdd);
    for (const Column& column : own) {
      const Pair size = change(of, column);
      sizes.col(column.v).segment<3>(row).array() += size.linear;
      sizes.col(column.v).segment<3>(row + 3).array() += size.angular;
    }
    row += 6;
  }
  return sizes;
}

Eigen::MatrixXd TermSizes::point_jacobian() const {
  const std::vector<double> none(static_cast<std::size_t>(subject_.model.nv), 0);
  return point_columns(none, none, [](const Motion&, const Column& by) {
    return Pair{by.lever, by.turn};
  });
}

Eigen::MatrixXd TermSizes::point_velocities_by_displacement(const std::vector<double>& qd) const {
  const std::vector<double> none(qd.size(), 0);
  return point_columns(qd, none, velocity_change);
}

Eigen::MatrixXd TermSizes::point_accelerations_by_displacement(
    const std::vector<double>& qd, const std::vector<double>& qdd) const {
  return point_columns(qd, qdd, acceleration_change);
}

Eigen::MatrixXd TermSizes::point_accelerations_by_velocity(const std::vector<double>& qd) const {
  return 2 * point_velocities_by_displacement(qd);
}

template <class Change>
Eigen::MatrixXd TermSizes::centroidal_columns(const std::vector<double>& qd,
                                              const std::vector<double>& qdd, Change change) const {
  const auto& model = subject_.model;
  const std::vector<double> arm = arms();
  Eigen::MatrixXd sizes = Eigen::MatrixXd::Zero(6, model.nv);
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    const Columns own = columns(i, body.com.norm());
    const Motion of = motion(own, qd, qdd);
    for (const Column& column : own) {
      const Pair size = change(of, column);
      const double f = body.mass * size.linear;
      sizes.col(column.v).head<3>().array() += f;
      sizes.col(column.v).tail<3>().array() +=
          arm[static_cast<std::size_t>(i)] * f + 2 * turning_inertia(body) * size.angular;
    }
  }
  return sizes;
}

Eigen::MatrixXd TermSizes::centroidal_momentum_by_displacement(
    const std::vector<double>& qd) const {
  const std::vector<double> none(qd.size(), 0);
  Eigen::MatrixXd sizes = centroidal_columns(qd, none, velocity_change);
  const double momentum = centroidal_momentum(qd)(0);
  sizes.bottomRows<3>() += 2 * momentum * center_of_mass_jacobian();
  return sizes;
}

Eigen::MatrixXd TermSizes::centroidal_rate_by_displacement(const std::vector<double>& qd,
                                                           const std::vector<double>& qdd) const {
  const auto& model = subject_.model;
  Eigen::MatrixXd sizes = centroidal_columns(qd, qdd, acceleration_change);
  double force = 0;
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    force += body.mass * motion(columns(i, body.com.norm()), qd, qdd).a;
  }
  sizes.bottomRows<3>() += 2 * force * center_of_mass_jacobian();
  return sizes;
}

Eigen::MatrixXd TermSizes::centroidal_rate_by_velocity(const std::vector<double>& qd) const {
  const std::vector<double> none(qd.size(), 0);
  return 2 * centroidal_columns(qd, none, velocity_change);
}

Eigen::MatrixXd TermSizes::kinetic_energy_by_displacement(const std::vector<double>& qd) const {
  const auto& model = subject_.model;
  const std::vector<double> none(qd.size(), 0);
  Eigen::MatrixXd sizes = Eigen::MatrixXd::Zero(1, model.nv);
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    const Columns own = columns(i, body.com.norm());
    const Motion of = motion(own, qd, none);
    for (const Column& column : own) {
      const Pair size = velocity_change(of, column);
      sizes(0, column.v) +=
          body.mass * of.v * size.linear + turning_inertia(body) * of.w * size.angular;
    }
  }
  return sizes;
}

}  // namespace treeline
