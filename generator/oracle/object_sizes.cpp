#include <Eigen/LU>
#include <array>
#include <limits>

#include "functions/function_table.hpp"
#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/group_sizes.hpp"
#include "oracle/interpret.hpp"
#include "oracle/symmetric_matrices.hpp"

namespace treeline {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Subject<double> seen_at_objects(const Subject<double>& subject) {
  Subject<double> seen = subject;
  seen.points = interpreter::object_points(subject.chain, 0);
  return seen;
}

MatrixXd inverse_magnitudes(const MatrixXd& A) {
  return inverse_of_symmetric(A).cwiseAbs();
}

/// Six rows: three of one size, then three of another.
VectorXd six(double linear, double angular) {
  VectorXd rows(6);
  rows << linear, linear, linear, angular, angular, angular;
  return rows;
}

}  // namespace

ObjectSizes::ObjectSizes(const Subject<double>& subject, const State& state,
                         const MatrixXd& M_inverse)
    : subject_(subject),
      state_(state),
      M_inverse_(M_inverse),
      seen_(seen_at_objects(subject)),
      terms_(seen_, state.q),
      J_(terms_.jacobian()),
      C_(interpreter::connectivity(subject.chain, 0)),
      bias_(terms_.bias(state.qd)) {
  condition_ = std::numeric_limits<double>::infinity();
  if (!M_inverse.allFinite()) return;
  Lambda_inverse_ =
      interpreter::lambda_inverse<double>(subject.model, seen_.points, vector_of<double>(state.q));
  condition_ = scaled_condition(Lambda_inverse_, (J_ * M_inverse * J_.transpose()).diagonal());
  Lambda_ = inverse_magnitudes(Lambda_inverse_);
}

/// Properties of the solve with Lambda^-1, or with Lambda^-1 + C Lambda_obj^-1 C^T if objects move
/// freely, with relaxed rows.
std::optional<LawSizes> ObjectSizes::relaxed(Function function,
                                             const interpreter::TaskLaw<double>& law) const {
  if (Lambda_inverse_.size() == 0) return std::nullopt;
  MatrixXd A = Lambda_inverse_;
  MatrixXd terms = J_ * M_inverse_ * J_.transpose();
  if (function == Function::object_forward_dynamics) {
    const MatrixXd by_objects = C_ * mobility() * C_.transpose();
    A += by_objects;
    terms += by_objects.cwiseAbs();
  }
  return find_law_sizes(seen_, vector_of<double>(state_.q), A, terms, law);
}

std::vector<double> ObjectSizes::sizes(Function function,
                                       const std::optional<LawSizes>& relaxed) const {
  struct Row {
    Function function;
    std::vector<double> (*sizes)(const ObjectSizes& of, const std::optional<LawSizes>& relaxed);
  };
  static constexpr auto kRows = std::to_array<Row>({
      {Function::object_state,
       [](const ObjectSizes& of, const auto&) { return of.object_state(); }},
      {Function::object_control_torque,
       [](const ObjectSizes& of, const auto& law) {
         return of.control_torque(law ? law->Lambda : of.Lambda_);
       }},
      {Function::object_forward_dynamics,
       [](const ObjectSizes& of, const auto& law) {
         return law ? of.forward_dynamics(*law) : of.forward_dynamics();
       }},
  });
  static_assert(covers<is_about<FunctionGroup::objects>>(kRows));
  return find_row(kRows, function)->sizes(*this, relaxed);
}

/// Sizes of poses, velocities and drifts. A drift has the sizes of both hands' poses and
/// velocities.
std::vector<double> ObjectSizes::object_state() const {
  const VectorXd poses = terms_.poses();
  const VectorXd velocities = J_ * magnitudes(state_.qd);
  const auto hands = static_cast<Eigen::Index>(seen_.points.size());
  std::vector<double> entries, rotation, velocity, drift, drift_rate;
  Eigen::Index hand = 0;
  for (const auto& object : subject_.chain.objects) {
    const Eigen::Index first = hand;
    append(poses.segment(3 * first, 3), entries);
    append(poses.segment(3 * hands + 9 * first, 9), rotation);
    append(velocities.segment(6 * first, 6), velocity);
    for (std::size_t i = 1; i < object.grasps.size(); ++i) {
      const Eigen::Index other = first + static_cast<Eigen::Index>(i);
      append(poses.segment(3 * first, 3) + poses.segment(3 * other, 3), drift);
      append(VectorXd::Constant(3, 2), drift);
      append(velocities.segment(6 * first, 6) + velocities.segment(6 * other, 6), drift_rate);
    }
    hand += static_cast<Eigen::Index>(object.grasps.size());
  }
  for (const auto* part : {&rotation, &velocity, &drift, &drift_rate}) {
    entries.insert(entries.end(), part->begin(), part->end());
  }
  return entries;
}

/// Sizes m (|a| + |g| + |c| (|alpha| + |w|^2)) and |I| (|alpha| + |w|^2) + m |c| (|a| + |g|).
VectorXd ObjectSizes::object_force(std::size_t object, const VectorXd& accelerations) const {
  const auto& body = subject_.chain.objects[object];
  Eigen::Index hand = 0;
  for (std::size_t k = 0; k < object; ++k) {
    hand += static_cast<Eigen::Index>(subject_.chain.objects[k].grasps.size());
  }
  const double w = (J_ * magnitudes(state_.qd)).segment(6 * hand + 3, 3).norm();
  const double a = accelerations.head(3).norm() + subject_.model.gravity.norm();
  const double alpha = accelerations.tail(3).norm() + w * w;
  const double arm = body.com.norm();
  const double inertia = body.inertia.norm() + body.mass * arm * arm;
  return six(body.mass * (a + arm * alpha), inertia * alpha + body.mass * arm * a);
}

VectorXd ObjectSizes::spread(std::size_t object, const VectorXd& force,
                             const VectorXd& internal) const {
  const MatrixXd W = interpreter::grasp_description(subject_.chain.objects[object]);
  VectorXd wanted(W.rows());
  wanted << force, internal;
  return W.fullPivLu().inverse().cwiseAbs() * wanted;
}

VectorXd ObjectSizes::moved(std::size_t object, VectorXd forces) const {
  const auto& grasps = subject_.chain.objects[object].grasps;
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const auto at = 6 * static_cast<Eigen::Index>(i);
    const double f = forces.segment(at, 3).norm();
    const double n = forces.segment(at + 3, 3).norm();
    forces.segment(at, 6) = six(f, n + grasps[i].p.norm() * f);
  }
  return forces;
}

/// Sizes of inverse dynamics at qdd_0, plus |J|^T (|Lambda| (|xdd| + |Jd qd| + |J| |qdd_0|) +
/// |f_t|).
std::vector<double> ObjectSizes::control_torque(const MatrixXd& Lambda) const {
  const VectorXd xdd = magnitudes(values_of(state_, Quantity::xdd_object));
  const VectorXd internal = magnitudes(values_of(state_, Quantity::internal));
  VectorXd f = Lambda * (C_ * xdd + bias_ + J_ * magnitudes(state_.qdd));
  Eigen::Index row = 0, used = 0;
  for (std::size_t k = 0; k < subject_.chain.objects.size(); ++k) {
    const int hands = static_cast<int>(subject_.chain.objects[k].grasps.size());
    const int count = interpreter::internal_force_count(hands);
    const VectorXd force = object_force(k, xdd.segment(6 * static_cast<Eigen::Index>(k), 6));
    f.segment(row, 6 * hands) += moved(k, spread(k, force, internal.segment(used, count)));
    row += 6 * hands;
    used += count;
  }
  return entries_of(terms_.forces(state_.qd, state_.qdd, {}) + J_.transpose() * f);
}

/// Sizes of the terms of Chang table 7.2, line by line, with Lambda_e.
std::vector<double> ObjectSizes::forward_dynamics() const {
  const VectorXd qdd_o = open_chain();
  const VectorXd xdd_o = open_accelerations(qdd_o);
  const auto& objects = subject_.chain.objects;
  const interpreter::PerRobot<double> q{vector_of<double>(state_.q)};
  const interpreter::PerRobot<double> qd{vector_of<double>(state_.qd)};
  const auto held = interpreter::held_poses<double>(subject_.chain, q, qd);
  const MatrixXd Lambda = interpreter::lambda<double>(subject_.model, seen_.points, q.front());
  MatrixXd sum = C_.transpose() * Lambda * C_;
  VectorXd F = C_.transpose() * (Lambda_ * xdd_o);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const auto at = 6 * static_cast<Eigen::Index>(k);
    sum.block(at, at, 6, 6) += interpreter::object_inertia(objects[k], held[k].front().R);
    F.segment(at, 6) += object_force(k, VectorXd::Zero(6));
  }
  const VectorXd xdd = inverse_magnitudes(sum) * F;
  return motion(qdd_o, xdd, Lambda_ * (xdd_o + C_ * xdd));
}

/// Sizes for one system of equations for the hands' forces: first the free motion of the objects,
/// then these forces.
std::vector<double> ObjectSizes::forward_dynamics(const LawSizes& law) const {
  const VectorXd qdd_o = open_chain();
  const MatrixXd of_objects = mobility().cwiseAbs();
  VectorXd free(of_objects.rows());
  for (std::size_t k = 0; k < subject_.chain.objects.size(); ++k) {
    const auto at = 6 * static_cast<Eigen::Index>(k);
    free.segment(at, 6) = of_objects.block(at, at, 6, 6) * object_force(k, VectorXd::Zero(6));
  }
  const VectorXd f = law.Lambda * (open_accelerations(qdd_o) + C_ * free);
  return motion(qdd_o, free + of_objects * (C_.transpose() * f), f);
}

VectorXd ObjectSizes::open_chain() const {
  const std::vector<double> none(state_.qd.size(), 0);
  return M_inverse_ * (magnitudes(state_.tau) + terms_.forces(state_.qd, none, {}));
}

VectorXd ObjectSizes::open_accelerations(const VectorXd& qdd) const {
  const VectorXd gains = magnitudes(values_of(state_, Quantity::stabilisation));
  const VectorXd poses = terms_.poses();
  VectorXd xdd = bias_ + J_ * qdd + 2 * gains(0) * (J_ * magnitudes(state_.qd));
  for (Eigen::Index hand = 0; hand < xdd.size() / 6; ++hand) {
    xdd.segment(6 * hand, 6) += 2 * gains(1) * six(poses.segment(3 * hand, 3).norm(), 1);
  }
  return xdd;
}

MatrixXd ObjectSizes::mobility() const {
  const auto& objects = subject_.chain.objects;
  const interpreter::PerRobot<double> q{vector_of<double>(state_.q)};
  const interpreter::PerRobot<double> qd{vector_of<double>(state_.qd)};
  const auto held = interpreter::held_poses<double>(subject_.chain, q, qd);
  MatrixXd inverse = MatrixXd::Zero(C_.cols(), C_.cols());
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const auto at = 6 * static_cast<Eigen::Index>(k);
    const MatrixXd Lambda = interpreter::object_inertia(objects[k], held[k].front().R);
    inverse.block(at, at, 6, 6) = inverse_of_symmetric(Lambda);
  }
  return inverse;
}

std::vector<double> ObjectSizes::motion(const VectorXd& qdd, const VectorXd& xdd,
                                        const VectorXd& f) const {
  std::vector<double> entries = entries_of(qdd + M_inverse_ * (J_.transpose() * f));
  append(xdd, entries);
  std::vector<double> internal;
  Eigen::Index row = 0;
  const auto& objects = subject_.chain.objects;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const int hands = static_cast<int>(objects[k].grasps.size());
    const VectorXd at_hands = moved(k, f.segment(row, 6 * hands));
    append(at_hands, entries);
    const MatrixXd W = interpreter::grasp_description(objects[k]);
    append(W.bottomRows(interpreter::internal_force_count(hands)).cwiseAbs() * at_hands, internal);
    row += 6 * hands;
  }
  entries.insert(entries.end(), internal.begin(), internal.end());
  return entries;
}

}  // namespace treeline
