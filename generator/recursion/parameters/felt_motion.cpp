#include "recursion/parameters/felt_motion.hpp"

#include <array>

namespace treeline {
namespace {

constexpr int kInertiaNumbers = 10;
/// Numbers 4..9 are these entries of the second moment.
constexpr std::array<std::array<int, 2>, 6> kMoments = {
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

using NumberMatrix = Digits50Rows;

Digits50Vector3 unit_vector(int axis) {
  Digits50Vector3 unit = Digits50Vector3::Zero();
  unit(axis) = 1;
  return unit;
}

Digits50Matrix3 cross_matrix(const Digits50Vector3& a) {
  Digits50Matrix3 A = Digits50Matrix3::Zero();
  A(2, 1) = a(0);
  A(0, 2) = a(1);
  A(1, 0) = a(2);
  return A - Digits50Matrix3(A.transpose());
}

Digits50Vector3 crossed(const Digits50Vector3& a, const Digits50Vector3& b) {
  return cross_matrix(a) * b;
}

/// The matrix that does to columns of numbers what `change` does to inertias.
template <class Change>
NumberMatrix matrix_of(const Change& change) {
  NumberMatrix matrix = NumberMatrix::Zero(kBodyNumbers, kBodyNumbers);
  for (int k = 0; k < kInertiaNumbers; ++k) {
    matrix.col(k) = numbers_of(change(unit_inertia(k))).transpose();
  }
  return matrix;
}

/// Velocity of a frame's origin and angular velocity, in the frame's axes.
struct Digits50Twist {
  Digits50Vector3 v = Digits50Vector3::Zero(), w = Digits50Vector3::Zero();
};

Digits50Row row_of(const Digits50Twist& twist) {
  Digits50Row row(6);
  row << twist.v.transpose(), twist.w.transpose();
  return row;
}
Digits50Twist twist_of(const Digits50Row& row) {
  return {row.head(3).transpose(), row.tail(3).transpose()};
}

/// One freedom of a joint: its axis in the link's frame.
struct Freedom {
  Digits50Twist axis;

  Freedom(const JointStep& step, int k) {
    (step.is_angular(k) ? axis.w : axis.v) = unit_vector(step.axis(k));
  }

  /// Generator of what the coordinate does to numbers.
  [[nodiscard]] NumberMatrix generator() const {
    const Digits50Matrix3 turn = cross_matrix(axis.w);
    return matrix_of([&](const Inertia& inertia) {
      Inertia rate;
      rate.h = turn * inertia.h + axis.v * inertia.mass;
      rate.Sigma = turn * inertia.Sigma - inertia.Sigma * turn + inertia.h * axis.v.transpose() +
                   axis.v * inertia.h.transpose();
      return rate;
    });
  }
  /// Effect of the coordinate on a velocity of the link before, seen from the link.
  [[nodiscard]] Digits50Twist rate(const Digits50Twist& twist) const {
    return {crossed(twist.v, axis.w) + crossed(twist.w, axis.v), crossed(twist.w, axis.w)};
  }
};

/// The kinetic energy that two motions have together, a^T I b, as a row.
Digits50Row kinetic_row(const Digits50Twist& a, const Digits50Twist& b) {
  Digits50Row row = Digits50Row::Zero(kBodyNumbers);
  row(0) = a.v.dot(b.v);
  row.segment(1, 3) = (crossed(a.v, b.w) + crossed(b.v, a.w)).transpose();
  const Digits50 trace = a.w.dot(b.w);
  for (std::size_t k = 0; k < kMoments.size(); ++k) {
    const auto [i, j] = kMoments[k];
    const Digits50 product = a.w(i) * b.w(j);
    row(4 + static_cast<Eigen::Index>(k)) =
        i == j ? Digits50(trace - product) : Digits50(-product - a.w(j) * b.w(i));
  }
  return row;
}

/// All that is known of how a link moves.
struct Reach {
  explicit Reach(const Digits50& tolerance)
      : twists(tolerance), felt(tolerance), moving(tolerance) {}

  RowSpace twists;                   ///< all its velocities
  RowSpace felt;                     ///< kinetic energies, and differences of potential energy
  std::vector<Digits50Row> weights;  ///< potential energy with all coordinates at zero
  RowSpace moving;                   ///< what the steps of the joint so far have made felt
};

/// Reach of the base: at rest, with a potential energy for each possible direction of gravity.
Reach reach_of_base(const Mechanism& mechanism, const Digits50& tolerance) {
  Reach base(tolerance);
  std::vector<Digits50Vector3> directions;
  if (mechanism.inputs.gravity) {
    for (int axis = 0; axis < 3; ++axis) directions.push_back(unit_vector(axis));
  } else {
    const auto& g = mechanism.gravity;
    const Digits50Vector3 gravity{Digits50(g[0]), Digits50(g[1]), Digits50(g[2])};
    const Digits50 size = sqrt(Digits50(gravity.squaredNorm()));
    if (size > 0) directions.emplace_back(gravity / size);
  }
  for (const Digits50Vector3& direction : directions) {
    Digits50Row weight = Digits50Row::Zero(kBodyNumbers);
    weight.segment(1, 3) = -direction.transpose();
    base.weights.push_back(weight);
  }
  return base;
}

/// Expresses the motion of a link at a frame that is fixed to it. The rotor is left out.
Reach seen_from(const Digits50Pose& placement, const Reach& link, bool continues,
                const Digits50& tolerance) {
  const NumberMatrix back =
      matrix_of([&](const Inertia& inertia) { return transformed(inertia, placement); });
  const Digits50Matrix3 Rt = placement.R.transpose();
  Reach seen(tolerance);
  for (const Digits50Row& row : link.twists.basis()) {
    const Digits50Twist twist = twist_of(row);
    seen.twists.add(row_of({Rt * (twist.v + crossed(twist.w, placement.p)), Rt * twist.w}));
  }
  for (const Digits50Row& row : link.felt.basis()) seen.felt.add(row * back);
  for (const Digits50Row& row : link.weights) seen.weights.emplace_back(row * back);
  if (!continues) return seen;
  for (const Digits50Row& row : link.moving.basis()) seen.moving.add(row * back);
  return seen;
}

void make_felt(const Digits50Row& row, Reach& reach) {
  reach.moving.add(row);
  reach.felt.add(row);
}

/// Lets the link move by one more freedom.
void release(const Freedom& freedom, bool has_rotor, Reach& reach) {
  const NumberMatrix generator = freedom.generator();
  for (const Digits50Row& weight : reach.weights) make_felt(weight * generator, reach);
  for (std::size_t k = 0; k < reach.felt.basis().size(); ++k) {  // it grows
    make_felt(Digits50Row(reach.felt.basis()[k] * generator), reach);
  }
  for (std::size_t k = 0; k < reach.twists.basis().size(); ++k) {
    const Digits50Twist twist = twist_of(reach.twists.basis()[k]);
    reach.twists.add(row_of(freedom.rate(twist)));
    make_felt(kinetic_row(twist, freedom.axis), reach);
  }
  Digits50Row own = kinetic_row(freedom.axis, freedom.axis);
  if (has_rotor) own(kRotorNumber) = 1;
  make_felt(own, reach);
  reach.twists.add(row_of(freedom.axis));
}

Digits50Rows stacked(const std::vector<Digits50Row>& rows) {
  Digits50Rows matrix(static_cast<Eigen::Index>(rows.size()), kBodyNumbers);
  for (std::size_t i = 0; i < rows.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = rows[i];
  return matrix;
}

/// Goes outward, and keeps what each link needs for those behind it.
class Outward {
 public:
  Outward(const Mechanism& mechanism, const FeltUnits& units, const std::set<std::size_t>& rotors)
      : mechanism_(mechanism),
        units_(units),
        rotors_(rotors),
        base_(reach_of_base(mechanism, units.tolerance)) {
    frame_of_link_.assign(mechanism.links.size(), -1);
    for (std::size_t f = 0; f < mechanism.link_frames.size(); ++f) {
      frame_of_link_[static_cast<std::size_t>(mechanism.link_frames[f].link)] = static_cast<int>(f);
    }
  }

  std::vector<FeltMotion> run() {
    std::vector<FeltMotion> motions(mechanism_.link_frames.size());
    for (std::size_t i = 0; i < mechanism_.links.size(); ++i) {
      steps_.push_back(step_to(i));
      if (frame_of_link_[i] < 0) continue;
      const Step& step = steps_.back();
      motions[static_cast<std::size_t>(frame_of_link_[i])] = {step.parent, step.placement,
                                                              stacked(step.reach.moving.basis())};
    }
    return motions;
  }

 private:
  struct Step {
    Reach reach;
    int parent = -1;         ///< the last link of the file before this step
    Digits50Pose placement;  ///< in that link
  };

  [[nodiscard]] Step step_to(std::size_t index) const {
    const MovingLink& link = mechanism_.links[index];
    const Digits50Pose placement = in_units(link.placement, units_);
    const auto parent = static_cast<std::size_t>(link.parent);
    const bool on_base = link.parent < 0;
    const bool continues = !on_base && frame_of_link_[parent] < 0;
    Step step{
        seen_from(placement, on_base ? base_ : steps_[parent].reach, continues, units_.tolerance),
        -1, placement};
    if (continues) {
      step.parent = steps_[parent].parent;
      step.placement = steps_[parent].placement * placement;
    } else if (!on_base) {
      step.parent = frame_of_link_[parent];
    }
    for (int k = 0; k < link.velocities(); ++k) {
      release(Freedom(link, k), rotors_.contains(index), step.reach);
    }
    return step;
  }

  const Mechanism& mechanism_;
  FeltUnits units_;
  const std::set<std::size_t>& rotors_;
  Reach base_;
  std::vector<int> frame_of_link_;  ///< -1: a step within a joint
  std::vector<Step> steps_;
};

}  // namespace

FeltUnits felt_units(const Mechanism& mechanism) {
  constexpr int kResolutions = 16;  // of several joints together
  FeltUnits units;
  Digits50 longest = 0;
  const auto look_at = [&](const Digits50Vector3& p) {
    const Digits50 length = sqrt(Digits50(p.squaredNorm()));
    if (length > longest) longest = length;
  };
  for (const MovingLink& link : mechanism.links) look_at(link.placement.p);
  for (const MechanismPoint& frame : mechanism.link_frames) look_at(frame.pose.p);
  if (longest > 0) units.length = longest;
  const Digits50 least("1e-30");
  units.tolerance = kResolutions * mechanism.resolution.angle;
  if (units.tolerance < least) units.tolerance = least;
  return units;
}

std::vector<FeltMotion> felt_motions(const Mechanism& mechanism, const FeltUnits& units,
                                     const std::set<std::size_t>& rotors) {
  return Outward(mechanism, units, rotors).run();
}

Inertia unit_inertia(int k) {
  Inertia inertia;
  if (k == 0) inertia.mass = 1;
  if (k > 0 && k < 4) inertia.h(k - 1) = 1;
  if (k > 3) {
    const auto [i, j] = kMoments[static_cast<std::size_t>(k - 4)];
    inertia.Sigma(i, j) = inertia.Sigma(j, i) = 1;
  }
  return inertia;
}

Digits50Row numbers_of(const Inertia& inertia) {
  Digits50Row numbers = Digits50Row::Zero(kBodyNumbers);
  numbers(0) = inertia.mass;
  numbers.segment(1, 3) = inertia.h.transpose();
  for (std::size_t k = 0; k < kMoments.size(); ++k) {
    numbers(4 + static_cast<Eigen::Index>(k)) = inertia.Sigma(kMoments[k][0], kMoments[k][1]);
  }
  return numbers;
}

Digits50Pose in_units(const Digits50Pose& pose, const FeltUnits& units) {
  return {pose.R, pose.p / units.length};
}

}  // namespace treeline
