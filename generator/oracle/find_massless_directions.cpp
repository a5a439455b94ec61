#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "bounds/rng.hpp"
#include "interpreter/instances.hpp"
#include "interpreter/joint_parts.hpp"
#include "oracle/entries.hpp"
#include "oracle/leave_out_singular.hpp"
#include "oracle/model_from_robot.hpp"
#include "oracle/subject.hpp"
#include "oracle/symmetric_matrices.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {
namespace {

using interpreter::Digits50;

constexpr std::uint64_t kSeed = 1;
constexpr int kPoses = 2;
constexpr double kMassless = 0x1p-46;
/// Entries of a direction below this share of its largest are rounding errors.
constexpr double kRounding = 1e-6;
/// An entry may lead a direction if it has at least this share of the largest entry.
constexpr double kLeads = 0.1;
constexpr std::size_t kMostLinks = 3;

std::vector<double> draw_pose(const interpreter::Model<double>& model, Rng& rng) {
  std::vector<double> q;
  for (int i = 0; i < model.nq; ++i) q.push_back(rng.within(1));
  for (const auto& body : model.bodies) {
    const int first = interpreter::quaternion_of(body);
    if (first < 0) continue;
    double* const quaternion = &q[static_cast<std::size_t>(first)];
    const double norm = std::sqrt(std::inner_product(quaternion, quaternion + 4, quaternion, 0.0));
    std::transform(quaternion, quaternion + 4, quaternion, [&](double x) { return x / norm; });
  }
  return q;
}

/// The null space of M at one pose q. The columns are velocities divided by `scale`.
struct NullSpace {
  std::vector<double> q;
  Eigen::VectorXd scale;
  Eigen::MatrixXd columns;
};

NullSpace find_null_space(const Subject<Digits50>& exact, const Subject<double>& subject,
                          std::vector<double> q) {
  const Eigen::MatrixXd M =
      interpreter::mass_matrix<Digits50>(exact.model, vector_of<Digits50>(q))
          .unaryExpr([](const Digits50& x) { return static_cast<double>(x); });
  NullSpace space;
  space.scale = TermSizes(subject, q).mass_matrix().diagonal().unaryExpr([](double size) {
    return size > 0 ? 1 / std::sqrt(size) : 1;
  });
  const Eigen::MatrixXd scaled = space.scale.asDiagonal() * M * space.scale.asDiagonal();
  const SymmetricDecomposition eigen = decompose_symmetric(scaled);
  std::vector<Eigen::Index> zeros;
  for (Eigen::Index i = 0; i < M.rows(); ++i) {
    if (std::abs(eigen.values(i)) <= kMassless) zeros.push_back(i);
  }
  space.columns = eigen.vectors(Eigen::all, zeros);
  space.q = std::move(q);
  return space;
}

/// Whether M, computed in double, is so well conditioned that it need not be computed in 50 digits.
bool is_far_from_singular(const Subject<double>& subject, const std::vector<double>& q) {
  constexpr double kFar = 0x1p-6 / kMassless;
  const Eigen::MatrixXd M = interpreter::mass_matrix<double>(subject.model, vector_of<double>(q));
  return scaled_condition(M, TermSizes(subject, q).mass_matrix().diagonal()) < kFar;
}

/// Brings the columns to reduced form without changing their span: each has an entry of one in a
/// row in which the others are zero. Returns these rows. `order` lists the rows by preference.
std::vector<Eigen::Index> reduce(Eigen::MatrixXd& columns, const std::vector<Eigen::Index>& order) {
  std::vector<Eigen::Index> leads;
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    const auto rest = columns.rightCols(columns.cols() - c).cwiseAbs();
    const double largest = rest.maxCoeff();
    const auto lead = *std::find_if(order.begin(), order.end(), [&](Eigen::Index row) {
      return rest.row(row).maxCoeff() >= kLeads * largest;
    });
    Eigen::Index at = 0;
    rest.row(lead).maxCoeff(&at);
    columns.col(c).swap(columns.col(c + at));
    columns.col(c) /= columns(lead, c);
    for (Eigen::Index other = 0; other < columns.cols(); ++other) {
      if (other != c) columns.col(other) -= columns(lead, other) * columns.col(c);
    }
    leads.push_back(lead);
  }
  return leads;
}

/// Returns for each velocity the body whose joint it belongs to.
std::vector<int> find_owners(const interpreter::Model<double>& model) {
  std::vector<int> owners(static_cast<std::size_t>(model.nv));
  for (int i = 0; i < model.size(); ++i) {
    if (model.body(i).mimics) continue;
    const int count = interpreter::velocity_count(model.body(i).kind);
    for (int d = 0; d < count; ++d) owners[static_cast<std::size_t>(model.body(i).v + d)] = i;
  }
  return owners;
}

std::string describe_axis(const Eigen::Vector3d& direction) {
  constexpr std::array kNames = {"x", "y", "z"};
  const Eigen::Vector3d unit = direction.normalized();
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (std::abs(std::abs(unit(i)) - 1) < kRounding) return kNames[static_cast<std::size_t>(i)];
  }
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", unit(0), unit(1), unit(2));
}

/// Describes a motion of the base. `twist` is in the base's own axes, linear over angular.
std::string describe_base(const Eigen::VectorXd& twist) {
  const Eigen::Vector3d turn = twist.tail<3>();
  if (turn.norm() > kRounding * twist.norm()) {
    return "rotation of the base about " + describe_axis(turn);
  }
  return "translation of the base along " + describe_axis(twist.head<3>());
}

class Describer {
 public:
  Describer(const Robot& robot, const Scene& scene, const interpreter::Model<double>& model)
      : model_(model), owners_(find_owners(model)), floats_(scene.base == Base::floating) {
    for (const Joint& joint : robot.joints) {
      joints_[robot.links[static_cast<std::size_t>(joint.child)].name] = joint.name;
    }
  }

  std::vector<MasslessDirections> describe(NullSpace space) const {
    const std::vector<Eigen::Index> leads = reduce(space.columns, preferred_rows());
    std::map<int, Eigen::MatrixXd> groups;  // directions, by the body whose joint leads
    for (std::size_t c = 0; c < leads.size(); ++c) {
      Eigen::VectorXd direction = space.columns.col(static_cast<Eigen::Index>(c));
      const double largest = direction.cwiseAbs().maxCoeff();
      direction =
          direction.unaryExpr([&](double x) { return std::abs(x) > kRounding * largest ? x : 0; });
      Eigen::MatrixXd& group = groups[owners_[static_cast<std::size_t>(leads[c])]];
      group.conservativeResize(direction.size(), group.cols() + 1);
      group.rightCols<1>() = space.scale.asDiagonal() * direction;
    }
    std::vector<MasslessDirections> described;
    for (const auto& [lead, group] : groups) described.push_back(describe(lead, group, space.q));
    return described;
  }

 private:
  [[nodiscard]] bool is_base(int body) const { return floats_ && body == 0; }
  [[nodiscard]] std::string joint_of(int body) const { return joints_.at(model_.body(body).name); }

  /// Rows in order of preference: outer joints first, the base last. A joint can be locked, a base
  /// hardly.
  [[nodiscard]] std::vector<Eigen::Index> preferred_rows() const {
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(model_.nv));
    std::iota(rows.rbegin(), rows.rend(), 0);
    return rows;
  }

  MasslessDirections describe(int lead, const Eigen::MatrixXd& group,
                              const std::vector<double>& q) const {
    MasslessDirections made;
    made.moves_base = floats_ && !group.topRows(6).isZero(0);
    if (!is_base(lead)) {
      made.joint = joint_of(lead);
      made.one_degree = interpreter::velocity_count(model_.body(lead).kind) == 1;
      made.what = fmt::format("joint \"{}\"", made.joint);
    }
    const std::vector<std::string> others = others_of(lead, group);
    if (!others.empty() && !made.what.empty()) made.what += " against ";
    made.what += fmt::format("{}", fmt::join(others, " and "));
    made.links = links_moved(group, q);
    return made;
  }

  /// Describes what else moves in these directions, or what the base does if it leads.
  std::vector<std::string> others_of(int lead, const Eigen::MatrixXd& group) const {
    std::vector<std::string> others;
    if (floats_ && !group.topRows(6).isZero(0)) {
      if (group.cols() > 3) {
        others.emplace_back("the floating base");
      } else {
        for (Eigen::Index c = 0; c < group.cols(); ++c) {
          if (!group.col(c).head<6>().isZero(0)) {
            others.push_back(describe_base(group.col(c).head<6>()));
          }
        }
      }
    }
    for (int body = 0; body < model_.size(); ++body) {
      if (body == lead || is_base(body) || model_.body(body).mimics) continue;
      const int count = interpreter::velocity_count(model_.body(body).kind);
      if (count == 0 || group.middleRows(model_.body(body).v, count).isZero(0)) continue;
      others.push_back(fmt::format("joint \"{}\"", joint_of(body)));
    }
    return others;
  }

  std::vector<std::string> links_moved(const Eigen::MatrixXd& group,
                                       const std::vector<double>& q) const {
    const Eigen::VectorXd at = vector_of<double>(q);
    std::vector<double> speeds(static_cast<std::size_t>(model_.size()), 0);
    for (Eigen::Index c = 0; c < group.cols(); ++c) {
      const auto k = interpreter::kinematics<double>(model_, at, group.col(c));
      for (int i = 0; i < model_.size(); ++i) {
        speeds[static_cast<std::size_t>(i)] += k.v[i].norm();
      }
    }
    const double fastest = *std::max_element(speeds.begin(), speeds.end());
    std::vector<std::string> links;
    for (int i = 0; i < model_.size(); ++i) {
      const bool moves = speeds[static_cast<std::size_t>(i)] > kRounding * fastest;
      if (moves && links.size() < kMostLinks &&
          model_.body(i).kind != interpreter::JointKind::fixed) {
        links.push_back(model_.body(i).name);
      }
    }
    return links;
  }

  const interpreter::Model<double>& model_;
  std::vector<int> owners_;
  bool floats_;
  std::map<std::string, std::string> joints_;  ///< joint names, by the link that they carry
};

}  // namespace

std::vector<MasslessDirections> find_massless_directions(const Robot& robot, const Scene& scene) {
  Subject<Digits50> exact;
  exact.model = model_from_robot<Digits50>(robot, scene);
  Subject<double> subject;
  subject.model = interpreter::cast<double>(exact.model);
  if (subject.model.nv == 0) return {};
  Rng rng(kSeed);
  std::optional<NullSpace> least;
  for (int i = 0; i < kPoses; ++i) {
    NullSpace space = find_null_space(exact, subject, draw_pose(subject.model, rng));
    if (space.columns.cols() == 0) return {};
    if (!least || space.columns.cols() < least->columns.cols()) least = std::move(space);
  }
  return Describer(robot, scene, subject.model).describe(std::move(*least));
}

std::vector<MasslessDirections> find_massless_at_zero(const Robot& robot, const Scene& scene) {
  Subject<double> subject;
  subject.model = model_from_robot<double>(robot, scene);
  if (subject.model.nv == 0) return {};
  std::vector<double> q(static_cast<std::size_t>(subject.model.nq), 0);
  for (const auto& body : subject.model.bodies) {
    const int first = interpreter::quaternion_of(body);
    if (first >= 0) q[static_cast<std::size_t>(first) + 3] = 1;
  }
  if (is_far_from_singular(subject, q)) return {};
  Subject<Digits50> exact;
  exact.model = model_from_robot<Digits50>(robot, scene);
  NullSpace space = find_null_space(exact, subject, std::move(q));
  if (space.columns.cols() == 0) return {};
  return Describer(robot, scene, subject.model).describe(std::move(space));
}

}  // namespace treeline
