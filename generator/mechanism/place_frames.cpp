#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/build_steps.hpp"

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

/// Cost of a link's inertia. The second moment of a prismatic link moves to its parent.
int inertia_cost(const MovingLink& link, const Inertia& inertia) {
  const int first = 10 * nonzeros(inertia.h);
  if (link.kind == JointKind::prismatic) {
    return first;
  }
  const auto& Sigma = inertia.Sigma;
  return first + 5 * (Sigma(0, 1) != 0 ? 1 : 0) + 6 * (Sigma(0, 2) != 0 ? 1 : 0) +
         6 * (Sigma(1, 2) != 0 ? 1 : 0);
}

/// Decomposes R = Rz(a) Rx(alpha) Rz(b) and returns a. Returns false if alpha is a multiple of pi.
bool left_turn(const Digits50Matrix3& R, Digits50& a) {
  if (is_parallel(R)) {
    return false;
  }
  a = atan2(R(0, 2), Digits50(-R(1, 2)));
  return true;
}

/// A link with everything that depends on its frame.
struct Neighbourhood {
  MovingLink link;
  std::vector<MovingLink> children;
  std::vector<Digits50Pose> points;
  Resolution resolution;
  Digits50 farthest = 0;     ///< largest distance of the frame from its place in the file, m
  Digits50Pose files_frame;  ///< pose of the file's frame in the present frame

  [[nodiscard]] int cost() const {
    int sum = link_cost(link) + inertia_cost(link, link.inertia);
    for (const MovingLink& child : children) {
      sum += link_cost(child);
    }
    for (const Digits50Pose& point : points) {
      sum += pose_cost(point);
    }
    return sum;
  }

  [[nodiscard]] Neighbourhood placed_by(const Digits50Pose& placement,
                                        Change* change = nullptr) const {
    const Digits50Pose back = inverse(placement);
    Neighbourhood result = *this;
    result.link.placement = resolved(link.placement * placement, resolution, change);
    result.link.inertia = resolved(transformed(link.inertia, back), resolution, change);
    absorb_turn(result.link, resolution, change);
    for (MovingLink& child : result.children) {
      child.placement = resolved(back * child.placement, resolution, change);
      absorb_turn(child, resolution, change);
    }
    for (Digits50Pose& point : result.points) {
      point = resolved(back * point, resolution, change);
    }
    result.files_frame = back * files_frame;
    return result;
  }

  /// The cost of `placed_by`, or any cost that is not below `limit` if that is not. What costs the
  /// most time comes last.
  [[nodiscard]] int cost_below(int limit, const Digits50Pose& placement) const {
    const Digits50Pose back = inverse(placement);
    int sum = absorbed_cost(link, resolved(link.placement * placement, resolution), resolution);
    for (const MovingLink& child : children) {
      if (sum >= limit) return sum;
      sum += absorbed_cost(child, resolved(back * child.placement, resolution), resolution);
    }
    for (const Digits50Pose& point : points) {
      if (sum >= limit) return sum;
      sum += pose_cost(resolved(back * point, resolution));
    }
    if (sum >= limit) return sum;
    return sum + inertia_cost(link, resolved(transformed(link.inertia, back), resolution));
  }

  [[nodiscard]] bool is_near(const Digits50Vector3& shift) const {
    const Digits50Vector3 moved = shift - files_frame.p;
    return moved.dot(moved) <= farthest * farthest;
  }
};

std::vector<Digits50> turn_candidates(const Neighbourhood& around) {
  std::vector<Digits50> turns{0, -right_turn(around.link.placement.R)};
  const auto towards = [&turns](const Digits50Vector3& v) {
    if (v(0) != 0 || v(1) != 0) {
      turns.push_back(atan2(v(1), v(0)));
    }
  };
  for (const MovingLink& child : around.children) {
    Digits50 turn;
    if (left_turn(child.placement.R, turn)) {
      turns.push_back(turn);
    }
    towards(child.placement.p);
  }
  for (const Digits50Pose& point : around.points) {
    towards(point.p);
  }
  towards(around.link.inertia.h);
  const Digits50Matrix3& Sigma = around.link.inertia.Sigma;
  if (Sigma(0, 1) != 0) {
    turns.push_back(atan2(Digits50(2 * Sigma(0, 1)), Digits50(Sigma(0, 0) - Sigma(1, 1))) / 2);
  }
  return turns;
}

/// Position on z of the common normal with the child's axis. The formula uses the sine, which keeps
/// its digits if axes are nearly parallel.
Digits50 foot_of_common_normal(const Digits50Pose& child) {
  const auto& axis = child.R.col(2);
  const Digits50 square = axis(0) * axis(0) + axis(1) * axis(1);
  return child.p(2) - axis(2) * (axis(0) * child.p(0) + axis(1) * child.p(1)) / square;
}

std::vector<Digits50Vector3> slide_candidates(const Neighbourhood& around) {
  std::vector<Digits50> along{0,
                              -(around.link.placement.R.transpose() * around.link.placement.p)(2)};
  if (!is_parallel(around.link.placement.R)) {
    along.push_back(foot_of_common_normal(inverse(around.link.placement)));
  }
  for (const MovingLink& child : around.children) {
    along.push_back(child.placement.p(2));
    if (!is_parallel(child.placement.R)) {
      along.push_back(foot_of_common_normal(child.placement));
    }
  }
  for (const Digits50Pose& point : around.points) {
    along.push_back(point.p(2));
  }
  const Inertia& inertia = around.link.inertia;
  for (int i = 0; i < 2; ++i) {
    if (inertia.h(i) != 0) {
      along.push_back(inertia.Sigma(i, 2) / inertia.h(i));
    }
  }
  std::vector<Digits50Vector3> slides;
  for (const Digits50& distance : along) {
    slides.emplace_back(Digits50Vector3(0, 0, distance));
  }
  return slides;
}

/// Candidates for the origin of a prismatic link, which may be anywhere.
std::vector<Digits50Vector3> shift_candidates(const Neighbourhood& around) {
  std::vector<Digits50Vector3> shifts{Digits50Vector3::Zero()};
  shifts.emplace_back(-(around.link.placement.R.transpose() * around.link.placement.p));
  for (const MovingLink& child : around.children) {
    shifts.push_back(child.placement.p);
  }
  for (const Digits50Pose& point : around.points) {
    shifts.push_back(point.p);
  }
  if (around.link.inertia.mass != 0) {
    shifts.emplace_back(around.link.inertia.h / around.link.inertia.mass);
  }
  return shifts;
}

/// Candidates for the origin of the link's frame, without repetition and not too far away.
std::vector<Digits50Vector3> origin_candidates(const Neighbourhood& around) {
  const std::vector<Digits50Vector3> all = around.link.kind == JointKind::prismatic
                                               ? shift_candidates(around)
                                               : slide_candidates(around);
  std::vector<Digits50Vector3> near;
  for (const Digits50Vector3& shift : all) {
    if (around.is_near(shift) && std::find(near.begin(), near.end(), shift) == near.end()) {
      near.push_back(shift);
    }
  }
  return near;
}

Digits50Pose best_placement(const Neighbourhood& around) {
  Digits50Pose best;
  int best_cost = around.cost_below(std::numeric_limits<int>::max(), {});
  const std::vector<Digits50Vector3> shifts = origin_candidates(around);
  std::vector<Digits50> tried;
  for (const Digits50& turn : turn_candidates(around)) {
    if (std::find(tried.begin(), tried.end(), turn) != tried.end()) continue;
    tried.push_back(turn);
    const Digits50Matrix3 R = rotation_z(turn);
    for (const Digits50Vector3& shift : shifts) {
      const int cost = around.cost_below(best_cost, {R, shift});
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
Digits50 size_of(const Neighbourhood& around) {
  const auto square = [](const Digits50Vector3& p) { return Digits50(p.dot(p)); };
  Digits50 most =
      std::max(square(around.link.placement.p), Digits50(around.link.radius * around.link.radius));
  for (const MovingLink& child : around.children) most = std::max(most, square(child.placement.p));
  for (const Digits50Pose& point : around.points) most = std::max(most, square(point.p));
  return sqrt(most);
}

class FramePlacer {
 public:
  explicit FramePlacer(Mechanism& mechanism) : mechanism_(mechanism) {
    for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
      farthest_.push_back(kFarthestSizes * size_of(neighbourhood(mechanism, static_cast<int>(i))));
    }
    files_frames_.resize(mechanism.links.size());
    is_optimal_.resize(mechanism.links.size(), false);
  }

  /// Moves the frame of link `index` to the best candidate. Returns whether the cost decreased.
  bool place_link(int index) {
    const auto i = static_cast<std::size_t>(index);
    if (is_optimal_[i]) return false;
    is_optimal_[i] = true;
    Neighbourhood around = neighbourhood(mechanism_, index);
    around.farthest = farthest_[i];
    around.files_frame = files_frames_[i];
    const Digits50Pose placement = best_placement(around);
    Change change;
    const Neighbourhood best = around.placed_by(placement, &change);
    if (best.cost() >= around.cost()) return false;
    add_decisions(change, fmt::format("link[{}]", around.link.name), mechanism_.file,
                  mechanism_.noise);
    take(index, best, placement);
    files_frames_[i] = best.files_frame;
    reopen(index);
    return true;
  }

 private:
  void take(int index, const Neighbourhood& best, const Digits50Pose& placement) {
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

  /// Placing the link may now pay, as may placing those next to it.
  void reopen(int index) {
    is_optimal_[static_cast<std::size_t>(index)] = false;
    for (std::size_t i = 0; i < is_optimal_.size(); ++i) {
      const bool is_child = mechanism_.links[i].parent == index;
      const bool is_parent =
          mechanism_.links[static_cast<std::size_t>(index)].parent == static_cast<int>(i);
      if (is_child || is_parent) is_optimal_[i] = false;
    }
  }

  Mechanism& mechanism_;
  std::vector<Digits50> farthest_;
  std::vector<Digits50Pose> files_frames_;
  std::vector<bool> is_optimal_;  ///< the best candidate is known not to pay
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
