#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "mechanism/build_mechanism.hpp"

// A link's frame may be turned about its joint axis and slid along it (a prismatic link's frame may
// be anywhere) without changing q, because the placement commutes with the joint's motion. A
// rotation about z at the end of a revolute link's own placement may also be added to the angle, at
// the cost of one addition. The search is a coordinate descent over candidates that make a constant
// vanish, weighted by the operations that the constant costs in the recursions. Rotations are
// orthogonal and cost no digits. Long slides do, so origins must stay near the link.

namespace treeline {
namespace {

/// A frame may move from its place in the file by at most this multiple of the link's size. Then
/// lengths that cancel again lose at most two bits compared with the file's.
constexpr int kFarthestSizes = 4;

bool is_trivial(const Exact& entry) {
  return entry == 0 || entry == 1 || entry == -1;
}

/// Number of operations to rotate a vector by a constant rotation.
int rotation_cost(const ExactMatrix3& R) {
  int multiplications = 0;
  int terms = 0;
  for (int i = 0; i < 9; ++i) {
    const Exact& entry = R(i / 3, i % 3);
    multiplications += is_trivial(entry) ? 0 : 1;
    terms += entry == 0 ? 0 : 1;
  }
  return multiplications + terms - 3;
}

int nonzeros(const ExactVector3& v) {
  return (v(0) != 0 ? 1 : 0) + (v(1) != 0 ? 1 : 0) + (v(2) != 0 ? 1 : 0);
}

// Number of vectors rotated and products taken per joint, in RNEA and the articulated-body
// recursions together.
constexpr int kRotationWeight = 8;
constexpr int kPositionWeight = 12;

int pose_cost(const ExactPose& pose) {
  return kRotationWeight * rotation_cost(pose.R) + kPositionWeight * nonzeros(pose.p);
}

int link_cost(const MovingLink& link) {
  const int offset = link.turns_by_angle() && link.offset != 0 ? 1 : 0;
  // On a fixed base, nothing but gravity needs to be rotated, and gravity is constant.
  return link.parent < 0 ? offset + nonzeros(link.placement.p) : offset + pose_cost(link.placement);
}

/// Cost of a link's inertia. The second moment of a prismatic link moves to its parent.
int inertia_cost(const MovingLink& link) {
  const int first = 10 * nonzeros(link.inertia.h);
  if (link.kind == JointKind::prismatic) {
    return first;
  }
  const auto& Sigma = link.inertia.Sigma;
  return first + 5 * (Sigma(0, 1) != 0 ? 1 : 0) + 6 * (Sigma(0, 2) != 0 ? 1 : 0) +
         6 * (Sigma(1, 2) != 0 ? 1 : 0);
}

Exact folded_to_quarter(const Exact& angle) {
  return angle - half_pi() * round(angle / half_pi());
}

bool is_parallel(const ExactMatrix3& R) {
  return R(0, 2) == 0 && R(1, 2) == 0;
}

/// Decomposes R = Rz(a) Rx(alpha) Rz(b) and returns a. Returns false if alpha is a multiple of pi.
bool left_turn(const ExactMatrix3& R, Exact& a) {
  if (is_parallel(R)) {
    return false;
  }
  a = atan2(R(0, 2), Exact(-R(1, 2)));
  return true;
}
Exact right_turn(const ExactMatrix3& R) {
  if (R(2, 0) == 0 && R(2, 1) == 0) {
    return atan2(R(1, 0), R(0, 0));
  }
  return atan2(R(2, 0), R(2, 1));
}

/// Moves the rotation about z at the end of a revolute link's placement to the joint angle, if that
/// is cheaper.
void absorb_turn(MovingLink& link, const Resolution& resolution, Change* change) {
  if (!link.turns_by_angle()) {
    return;
  }
  const ExactMatrix3& R = link.placement.R;
  const bool is_quarter =
      is_parallel(R) ? R(0, 0) == 0 || R(1, 0) == 0 : R(2, 0) == 0 || R(2, 1) == 0;
  if (is_quarter) {
    return;
  }
  const Exact turn = folded_to_quarter(right_turn(R));
  MovingLink absorbed = link;
  Change by_turn;
  absorbed.placement = resolved(link.placement * ExactPose{rotation_z(-turn), ExactVector3::Zero()},
                                resolution, change ? &by_turn : nullptr);
  absorbed.offset = resolved(Exact(link.offset + turn), resolution);
  if (link_cost(absorbed) < link_cost(link)) {
    link = absorbed;
    if (change) change->angle = std::max(change->angle, by_turn.angle);
  }
}

/// A link with everything that depends on its frame.
struct Neighbourhood {
  MovingLink link;
  std::vector<MovingLink> children;
  std::vector<ExactPose> points;
  Resolution resolution;
  Exact farthest = 0;     ///< largest distance of the frame from its place in the file, m
  ExactPose files_frame;  ///< pose of the file's frame in the present frame

  [[nodiscard]] int cost() const {
    int sum = link_cost(link) + inertia_cost(link);
    for (const MovingLink& child : children) {
      sum += link_cost(child);
    }
    for (const ExactPose& point : points) {
      sum += pose_cost(point);
    }
    return sum;
  }

  [[nodiscard]] Neighbourhood placed_by(const ExactPose& placement,
                                        Change* change = nullptr) const {
    const ExactPose back = inverse(placement);
    Neighbourhood result = *this;
    result.link.placement = resolved(link.placement * placement, resolution, change);
    result.link.inertia = resolved(transformed(link.inertia, back), resolution, change);
    absorb_turn(result.link, resolution, change);
    for (MovingLink& child : result.children) {
      child.placement = resolved(back * child.placement, resolution, change);
      absorb_turn(child, resolution, change);
    }
    for (ExactPose& point : result.points) {
      point = resolved(back * point, resolution, change);
    }
    result.files_frame = back * files_frame;
    return result;
  }

  [[nodiscard]] bool is_near(const ExactVector3& shift) const {
    const ExactVector3 moved = shift - files_frame.p;
    return moved.dot(moved) <= farthest * farthest;
  }
};

std::vector<Exact> turn_candidates(const Neighbourhood& around) {
  std::vector<Exact> turns{0, -right_turn(around.link.placement.R)};
  const auto towards = [&turns](const ExactVector3& v) {
    if (v(0) != 0 || v(1) != 0) {
      turns.push_back(atan2(v(1), v(0)));
    }
  };
  for (const MovingLink& child : around.children) {
    Exact turn;
    if (left_turn(child.placement.R, turn)) {
      turns.push_back(turn);
    }
    towards(child.placement.p);
  }
  for (const ExactPose& point : around.points) {
    towards(point.p);
  }
  towards(around.link.inertia.h);
  const ExactMatrix3& Sigma = around.link.inertia.Sigma;
  if (Sigma(0, 1) != 0) {
    turns.push_back(atan2(Exact(2 * Sigma(0, 1)), Exact(Sigma(0, 0) - Sigma(1, 1))) / 2);
  }
  return turns;
}

/// Position on z of the common normal with the child's axis. The formula uses the sine, which keeps
/// its digits if axes are nearly parallel.
Exact foot_of_common_normal(const ExactPose& child) {
  const auto& axis = child.R.col(2);
  const Exact square = axis(0) * axis(0) + axis(1) * axis(1);
  return child.p(2) - axis(2) * (axis(0) * child.p(0) + axis(1) * child.p(1)) / square;
}

std::vector<ExactVector3> slide_candidates(const Neighbourhood& around) {
  std::vector<Exact> along{0, -(around.link.placement.R.transpose() * around.link.placement.p)(2)};
  if (!is_parallel(around.link.placement.R)) {
    along.push_back(foot_of_common_normal(inverse(around.link.placement)));
  }
  for (const MovingLink& child : around.children) {
    along.push_back(child.placement.p(2));
    if (!is_parallel(child.placement.R)) {
      along.push_back(foot_of_common_normal(child.placement));
    }
  }
  for (const ExactPose& point : around.points) {
    along.push_back(point.p(2));
  }
  const Inertia& inertia = around.link.inertia;
  for (int i = 0; i < 2; ++i) {
    if (inertia.h(i) != 0) {
      along.push_back(inertia.Sigma(i, 2) / inertia.h(i));
    }
  }
  std::vector<ExactVector3> slides;
  for (const Exact& distance : along) {
    slides.emplace_back(ExactVector3(0, 0, distance));
  }
  return slides;
}

/// Candidates for the origin of a prismatic link, which may be anywhere.
std::vector<ExactVector3> shift_candidates(const Neighbourhood& around) {
  std::vector<ExactVector3> shifts{ExactVector3::Zero()};
  shifts.emplace_back(-(around.link.placement.R.transpose() * around.link.placement.p));
  for (const MovingLink& child : around.children) {
    shifts.push_back(child.placement.p);
  }
  for (const ExactPose& point : around.points) {
    shifts.push_back(point.p);
  }
  if (around.link.inertia.mass != 0) {
    shifts.emplace_back(around.link.inertia.h / around.link.inertia.mass);
  }
  return shifts;
}

/// Candidates for the origin of the link's frame, without repetition and not too far away.
std::vector<ExactVector3> origin_candidates(const Neighbourhood& around) {
  const std::vector<ExactVector3> all = around.link.kind == JointKind::prismatic
                                            ? shift_candidates(around)
                                            : slide_candidates(around);
  std::vector<ExactVector3> near;
  for (const ExactVector3& shift : all) {
    if (around.is_near(shift) && std::find(near.begin(), near.end(), shift) == near.end()) {
      near.push_back(shift);
    }
  }
  return near;
}

ExactPose best_placement(const Neighbourhood& around) {
  ExactPose best;
  int best_cost = around.placed_by({}).cost();
  const std::vector<ExactVector3> shifts = origin_candidates(around);
  std::vector<Exact> tried;
  for (const Exact& turn : turn_candidates(around)) {
    if (std::find(tried.begin(), tried.end(), turn) != tried.end()) continue;
    tried.push_back(turn);
    const ExactMatrix3 R = rotation_z(turn);
    for (const ExactVector3& shift : shifts) {
      const int cost = around.placed_by({R, shift}).cost();
      if (cost < best_cost) {
        best = {R, shift};
        best_cost = cost;
      }
    }
  }
  return best;
}

/// Visits what is attached to link `index`: children first, then points, always in the same order.
template <class OnChild, class OnPoint>
void for_each_around(Mechanism& mechanism, int index, OnChild on_child, OnPoint on_point) {
  for (MovingLink& link : mechanism.links) {
    if (link.parent == index) {
      on_child(link);
    }
  }
  for (auto* points : {&mechanism.operational_points, &mechanism.external_forces,
                       &mechanism.contacts, &mechanism.constraints}) {
    for (MechanismPoint& point : *points) {
      if (point.link == index) {
        on_point(point);
      }
    }
  }
  const auto visit = [&](MechanismPoint& frame) {
    if (frame.link == index) on_point(frame);
  };
  for (MechanismLoop& loop : mechanism.loops) {
    visit(loop.first);
    visit(loop.second);
  }
  for (MechanismInertia& payload : mechanism.inputs.payloads) visit(payload.frame);
  for (MechanismInertia& own : mechanism.inputs.parameters) visit(own.frame);
  for (MechanismInertia& own : mechanism.inputs.base) visit(own.frame);
  for (MechanismTool& tool : mechanism.inputs.tools) visit(tool.frame);
  for (MechanismTool& contact : mechanism.inputs.contacts) visit(contact.frame);
}

Neighbourhood neighbourhood(Mechanism& mechanism, int index) {
  Neighbourhood around;
  around.link = mechanism.links[static_cast<std::size_t>(index)];
  around.resolution = mechanism.resolution;
  for_each_around(
      mechanism, index, [&](const MovingLink& child) { around.children.push_back(child); },
      [&](const MechanismPoint& point) { around.points.push_back(point.pose); });
  return around;
}

/// Distance from the frame's origin of what belongs to a link.
Exact size_of(const Neighbourhood& around) {
  const auto square = [](const ExactVector3& p) { return Exact(p.dot(p)); };
  Exact most =
      std::max(square(around.link.placement.p), Exact(around.link.radius * around.link.radius));
  for (const MovingLink& child : around.children) most = std::max(most, square(child.placement.p));
  for (const ExactPose& point : around.points) most = std::max(most, square(point.p));
  return sqrt(most);
}

class FramePlacer {
 public:
  explicit FramePlacer(Mechanism& mechanism) : mechanism_(mechanism) {
    for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
      farthest_.push_back(kFarthestSizes * size_of(neighbourhood(mechanism, static_cast<int>(i))));
    }
    files_frames_.resize(mechanism.links.size());
  }

  /// Moves the frame of link `index` to the best candidate. Returns whether the cost decreased.
  bool place_link(int index) {
    const auto i = static_cast<std::size_t>(index);
    Neighbourhood around = neighbourhood(mechanism_, index);
    around.farthest = farthest_[i];
    around.files_frame = files_frames_[i];
    const ExactPose placement = best_placement(around);
    Change change;
    const Neighbourhood best = around.placed_by(placement, &change);
    if (best.cost() >= around.cost()) return false;
    add_decisions(change, fmt::format("link[{}]", around.link.name), mechanism_.file,
                  mechanism_.noise);
    take(index, best, placement);
    files_frames_[i] = best.files_frame;
    return true;
  }

 private:
  void take(int index, const Neighbourhood& best, const ExactPose& placement) {
    mechanism_.links[static_cast<std::size_t>(index)] = best.link;
    std::size_t child = 0;
    std::size_t point = 0;
    for_each_around(
        mechanism_, index, [&](MovingLink& moved) { moved = best.children[child++]; },
        [&](MechanismPoint& moved) { moved.pose = best.points[point++]; });
    for (auto* frames : {&mechanism_.link_frames, &mechanism_.payload_frames}) {  // at no cost
      for (MechanismPoint& frame : *frames) {
        if (frame.link != index) continue;
        frame.pose = resolved(inverse(placement) * frame.pose, mechanism_.resolution);
      }
    }
  }

  Mechanism& mechanism_;
  std::vector<Exact> farthest_;
  std::vector<ExactPose> files_frames_;
};

}  // namespace

void place_frames(Mechanism& mechanism) {
  constexpr int kMostSweeps = 10;  // each sweep lowers an integer cost; few are needed
  const int count = static_cast<int>(mechanism.links.size());
  FramePlacer placer(mechanism);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool cheaper = false;
    for (int i = 0; i < count; ++i) {
      if (mechanism.links[static_cast<std::size_t>(i)].has_one_coordinate()) {
        cheaper = placer.place_link(i) || cheaper;
      }
    }
    if (!cheaper) {
      break;
    }
  }
}

}  // namespace treeline
