#include "oracle/term_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "description/noise.hpp"
#include "interpreter/center_of_mass.hpp"
#include "interpreter/joint_parts.hpp"

namespace treeline {
namespace {

using interpreter::kWorld;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Distance by which the joint's own translation moves its link, m.
double displacement(const interpreter::Body<double>& body, const std::vector<double>& q) {
  const auto size = [&](int i) {
    return std::abs(body.multiplier * q[at(body.q + i)] + body.offset);
  };
  double sum = 0;
  for (int i = 0; i < interpreter::translation_count(body.kind); ++i) sum += size(i);
  return sum;
}

double displacement_of_spring(const interpreter::Body<double>& body, const std::vector<double>& q) {
  return std::abs(body.multiplier * q[at(body.q)]) + std::abs(body.offset) + std::abs(body.rest);
}

/// Norm of the rotational inertia about the centre of mass.
double central_inertia(const interpreter::Body<double>& body) {
  const auto C = interpreter::cross_matrix(body.com);
  return (body.inertia + body.mass * C * C).norm();
}

struct RotorSize {
  int v;  ///< index of the velocity with which it turns
  double armature;
};

/// The rotor at a body's joint, if there is one, as its coordinate feels it.
std::vector<RotorSize> rotor(const interpreter::Body<double>& body) {
  if (body.armature == 0) return {};
  return {{body.v, body.multiplier * body.multiplier * body.armature}};
}

/// Forces of friction and a spring on a joint's coordinate, a derivative, and the spring's energy.
struct JointSizes {
  double friction = 0, spring = 0, friction_slope = 0, energy = 0;
};

JointSizes joint_sizes(const interpreter::Body<double>& body, const std::vector<double>& q,
                       const std::vector<double>& qd) {
  if (interpreter::velocity_count(body.kind) != 1) return {};
  const double m = std::abs(body.multiplier);
  const double rate = m * std::abs(qd[at(body.v)]);
  const double stretch = displacement_of_spring(body, q);
  return {m * (body.damping * rate + body.friction * std::min(1.0, rate / body.slip_speed)),
          m * body.stiffness * stretch, m * m * (body.damping + body.friction / body.slip_speed),
          body.stiffness * stretch * stretch / 2};
}

}  // namespace

TermSizes::TermSizes(const Subject<double>& subject, const std::vector<double>& q)
    : subject_(subject), q_(q) {
  for (const auto& body : subject.model.bodies) {
    lengths_.push_back(body.p_parent_joint.norm() + displacement(body, q));
    longest_ = std::max({longest_, body.p_parent_joint.norm(), body.com.norm()});
  }
}

/// Length of the path from the world to the body's origin, m.
double TermSizes::path_to(int body) const {
  double path = 0;
  for (int i = body; i != kWorld; i = subject_.model.body(i).parent) path += lengths_[at(i)];
  return path;
}

/// Lever arms are summed up from the point inward. As a difference of two paths from the world a
/// small one would be lost, and its size would be zero.
TermSizes::Columns TermSizes::columns(int body, double distance) const {
  constexpr double kNoise = 64 * kResolution;  // noise of several joints
  Columns result;
  double way = distance;
  for (int j = body; j != kWorld; j = subject_.model.body(j).parent) {
    const auto& joint = subject_.model.body(j);
    const double factor = std::abs(joint.multiplier);
    const bool is_noise = way > 0 && way <= kNoise * longest_;
    const double lever = is_noise ? longest_ : way;
    const int slides = interpreter::translation_count(joint.kind);
    for (int i = 0; i < interpreter::velocity_count(joint.kind); ++i) {
      result.push_back({joint.v + i, factor * (i < slides ? 1 : lever), i < slides ? 0 : factor});
    }
    way += lengths_[at(j)];
  }
  return result;
}

TermSizes::Motion TermSizes::motion(const Columns& columns, const std::vector<double>& qd,
                                    const std::vector<double>& qdd) const {
  Motion sum;
  for (const Column& column : columns) {
    const double rate = std::abs(qd[at(column.v)]);
    const double growth = std::abs(qdd[at(column.v)]);
    sum.v += column.lever * rate;
    sum.w += column.turn * rate;
    sum.a += column.lever * growth;
    sum.alpha += column.turn * growth;
  }
  sum.a += 2 * sum.w * sum.v;
  sum.alpha += sum.w * sum.w;
  return sum;
}

/// Of the centre of mass the means over the bodies; nothing of it turns.
TermSizes::Motion TermSizes::motion_of(const interpreter::OperationalPoint<double>& point,
                                       const std::vector<double>& qd,
                                       const std::vector<double>& qdd) const {
  if (!point.center_of_mass) return motion(columns(point.body, point.p.norm()), qd, qdd);
  const auto& model = subject_.model;
  Motion mean;
  for (int i = 0; i < model.size(); ++i) {
    const double share = model.body(i).mass / interpreter::total_mass(model);
    const Motion of = motion(columns(i, model.body(i).com.norm()), qd, qdd);
    mean.v += share * of.v;
    mean.a += share * of.a;
  }
  return mean;
}

Eigen::MatrixXd TermSizes::mass_matrix() const {
  const auto& model = subject_.model;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(model.nv, model.nv);
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    const double inertia = central_inertia(body);
    const Columns own = columns(i, body.com.norm());
    for (const Column& a : own) {
      for (const Column& b : own) {
        M(a.v, b.v) += body.mass * a.lever * b.lever + inertia * a.turn * b.turn;
      }
    }
    for (const auto& [v, armature] : rotor(body)) M(v, v) += armature;
  }
  return M;
}

Eigen::VectorXd TermSizes::forces(const std::vector<double>& qd, const std::vector<double>& qdd,
                                  const std::vector<double>& f_ext) const {
  const auto& model = subject_.model;
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
  const auto add = [&](const Columns& own, double force, double moment) {
    for (const Column& column : own) {
      tau(column.v) += column.lever * force + column.turn * moment;
    }
  };
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    const Columns own = columns(i, body.com.norm());
    const Motion of = motion(own, qd, qdd);
    add(own, body.mass * (of.a + model.gravity.norm()),
        central_inertia(body) * (of.alpha + of.w * of.w));
    for (const auto& [v, armature] : rotor(body)) tau(v) += armature * std::abs(qdd[at(v)]);
    const JointSizes joint = joint_sizes(body, q_, qd);
    if (joint.friction + joint.spring > 0) tau(body.v) += joint.friction + joint.spring;
  }
  for (std::size_t e = 0; 6 * e < f_ext.size(); ++e) {
    const auto& point = subject_.external[e];
    const double* f = &f_ext[6 * e];
    add(columns(point.body, point.p.norm()), std::hypot(f[0], f[1], f[2]),
        std::hypot(f[3], f[4], f[5]));
  }
  return tau;
}

Eigen::MatrixXd TermSizes::forces_by_displacement(const std::vector<double>& qd,
                                                  const std::vector<double>& qdd,
                                                  const std::vector<double>& f_ext) const {
  const auto& model = subject_.model;
  Eigen::MatrixXd sizes = Eigen::MatrixXd::Zero(model.nv, model.nv);
  const auto add = [&](const Columns& own, double force, double moment, double field) {
    for (const Column& i : own) {
      for (const Column& j : own) {
        sizes(i.v, j.v) += force * (i.lever * j.turn + i.turn * j.lever) +
                           moment * i.turn * j.turn + field * i.lever * j.lever;
      }
    }
  };
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    const Columns own = columns(i, body.com.norm());
    const Motion of = motion(own, qd, qdd);
    const double turning = of.alpha + of.w * of.w;
    add(own, body.mass * (of.a + model.gravity.norm()), central_inertia(body) * turning,
        body.mass * turning);
    if (body.stiffness > 0) {
      sizes(body.v, body.v) += body.multiplier * body.multiplier * body.stiffness;
    }
  }
  for (std::size_t e = 0; 6 * e < f_ext.size(); ++e) {
    const auto& point = subject_.external[e];
    const double* f = &f_ext[6 * e];
    add(columns(point.body, point.p.norm()), std::hypot(f[0], f[1], f[2]),
        std::hypot(f[3], f[4], f[5]), 0);
  }
  return sizes;
}

Eigen::MatrixXd TermSizes::forces_by_velocity(const std::vector<double>& qd) const {
  const auto& model = subject_.model;
  const std::vector<double> none(qd.size(), 0);
  Eigen::MatrixXd sizes = Eigen::MatrixXd::Zero(model.nv, model.nv);
  for (int b = 0; b < model.size(); ++b) {
    const auto& body = model.body(b);
    const double inertia = central_inertia(body);
    const Columns own = columns(b, body.com.norm());
    const Motion of = motion(own, qd, none);
    for (const Column& i : own) {
      for (const Column& j : own) {
        sizes(i.v, j.v) += 2 * (i.lever * body.mass * (of.w * j.lever + of.v * j.turn) +
                                i.turn * inertia * of.w * j.turn);
      }
    }
  }
  return sizes;
}

Eigen::VectorXd TermSizes::friction_slopes() const {
  const auto& model = subject_.model;
  const std::vector<double> none(at(model.nv), 0);
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(model.nv);
  for (const auto& body : model.bodies) {
    const double slope = joint_sizes(body, q_, none).friction_slope;
    if (slope > 0) sizes(body.v) += slope;
  }
  return sizes;
}

double TermSizes::kinetic_energy(const std::vector<double>& qd) const {
  const auto& model = subject_.model;
  const std::vector<double> none(qd.size(), 0);
  double twice = 0;
  for (int i = 0; i < model.size(); ++i) {
    const auto& body = model.body(i);
    const Motion of = motion(columns(i, body.com.norm()), qd, none);
    twice += body.mass * of.v * of.v + central_inertia(body) * of.w * of.w;
    for (const auto& [v, armature] : rotor(body)) twice += armature * qd[at(v)] * qd[at(v)];
  }
  return twice / 2;
}

double TermSizes::potential_energy() const {
  const std::vector<double> none(at(subject_.model.nv), 0);
  double energy = subject_.model.gravity.norm() * first_moment();
  for (const auto& body : subject_.model.bodies) energy += joint_sizes(body, q_, none).energy;
  return energy;
}

Eigen::MatrixXd TermSizes::jacobian() const {
  Eigen::MatrixXd J =
      Eigen::MatrixXd::Zero(interpreter::row_count(subject_.points), subject_.model.nv);
  int row = 0;
  for (const auto& point : subject_.points) {
    if (point.center_of_mass) {
      const auto count = std::count(point.rows.begin(), point.rows.end(), true);
      J.middleRows(row, count) = center_of_mass_jacobian().topRows(count);
      row += static_cast<int>(count);
      continue;
    }
    const Columns own = columns(point.body, point.p.norm());
    for (std::size_t i = 0; i < 6; ++i) {
      if (!point.rows[i]) continue;
      for (const Column& column : own) J(row, column.v) += i < 3 ? column.lever : column.turn;
      ++row;
    }
  }
  return J;
}

Eigen::VectorXd TermSizes::bias(const std::vector<double>& qd) const {
  const std::vector<double> none(qd.size(), 0);
  Eigen::VectorXd rows(interpreter::row_count(subject_.points));
  int row = 0;
  for (const auto& point : subject_.points) {
    const Motion of = motion_of(point, qd, none);
    const bool turns = point.axes == interpreter::PointAxes::local;
    const double linear = of.a + (turns ? of.w * of.v : 0);
    for (std::size_t i = 0; i < 6; ++i) {
      if (point.rows[i]) rows(row++) = i < 3 ? linear : of.alpha;
    }
  }
  return rows;
}

Eigen::VectorXd TermSizes::poses() const {
  const auto count = static_cast<Eigen::Index>(subject_.points.size());
  Eigen::VectorXd sizes = Eigen::VectorXd::Ones(12 * count);
  for (Eigen::Index e = 0; e < count; ++e) {
    const auto& point = subject_.points[static_cast<std::size_t>(e)];
    sizes.segment<3>(3 * e).setConstant(
        point.center_of_mass ? center_of_mass()(0) : path_to(point.body) + point.p.norm());
  }
  return sizes;
}

/// The masses times the lengths of the paths to their centres.
double TermSizes::first_moment() const {
  const auto& model = subject_.model;
  double moment = 0;
  for (int i = 0; i < model.size(); ++i) {
    moment += model.body(i).mass * (path_to(i) + model.body(i).com.norm());
  }
  return moment;
}

Eigen::VectorXd TermSizes::center_of_mass() const {
  return Eigen::VectorXd::Constant(3, first_moment() / interpreter::total_mass(subject_.model));
}

Eigen::MatrixXd TermSizes::center_of_mass_jacobian() const {
  const auto& model = subject_.model;
  Eigen::RowVectorXd moments = Eigen::RowVectorXd::Zero(model.nv);
  for (int i = 0; i < model.size(); ++i) {
    for (const Column& column : columns(i, model.body(i).com.norm())) {
      moments(column.v) += model.body(i).mass * column.lever;
    }
  }
  return (moments / interpreter::total_mass(model)).replicate(3, 1);
}

}  // namespace treeline
