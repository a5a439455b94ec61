#include <boost/math/constants/constants.hpp>
#include <vector>

#include "mechanism/build_mechanism.hpp"

// A link's frame may be turned about its joint axis and slid along it (a prismatic link's anywhere)
// without changing q: the seat commutes with the joint's motion. A turn that is left over at the
// end of a revolute link's own seat may also join the angle, at the cost of one addition.
// Coordinate descent over candidates that null a constant, weighted by the operations the constant
// costs in the recursions.

namespace treeline {
namespace {

const Exact kQuarterTurn = boost::math::constants::half_pi<Exact>();

bool is_trivial(const Exact& entry) {
  return entry == 0 || entry == 1 || entry == -1;
}

/// Operations to turn one vector by a constant rotation.
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

// Vectors turned and products taken per joint in RNEA and in the articulated recursions together.
constexpr int kRotationWeight = 8;
constexpr int kPositionWeight = 12;

int pose_cost(const ExactPose& pose) {
  return kRotationWeight * rotation_cost(pose.R) + kPositionWeight * nonzeros(pose.p);
}

int link_cost(const MovingLink& link) {
  const int offset = link.kind == JointKind::revolute && link.offset != 0 ? 1 : 0;
  // Nothing turns at a fixed base but gravity, which is constant.
  return link.parent < 0 ? offset + nonzeros(link.seat.p) : offset + pose_cost(link.seat);
}

/// The second moment of a prismatic link goes to its parent.
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
  return angle - kQuarterTurn * round(angle / kQuarterTurn);
}

bool is_parallel(const ExactMatrix3& R) {
  return R(0, 2) == 0 && R(1, 2) == 0;
}

/// R = Rz(a) Rx(alpha) Rz(b): a where alpha is no multiple of pi, else false.
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

/// Lets a revolute link's angle take the right-hand turn of its seat if that is cheaper.
void absorb_turn(MovingLink& link) {
  if (link.kind != JointKind::revolute) {
    return;
  }
  const ExactMatrix3& R = link.seat.R;
  const bool is_quarter =
      is_parallel(R) ? R(0, 0) == 0 || R(1, 0) == 0 : R(2, 0) == 0 || R(2, 1) == 0;
  if (is_quarter) {
    return;
  }
  const Exact turn = folded_to_quarter(right_turn(R));
  MovingLink absorbed = link;
  absorbed.seat = snapped(link.seat * ExactPose{rotation_z(-turn), ExactVector3::Zero()});
  absorbed.offset = snapped(Exact(link.offset + turn), Exact(1));
  if (link_cost(absorbed) < link_cost(link)) {
    link = absorbed;
  }
}

/// One link with everything that its frame touches.
struct Neighbourhood {
  MovingLink link;
  std::vector<MovingLink> children;
  std::vector<ExactPose> points;
  ExactPose old_frame;  ///< in the frame that the link has now

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

  [[nodiscard]] Neighbourhood reseated(const ExactPose& seat) const {
    const ExactPose back = inverse(seat);
    Neighbourhood result = *this;
    result.link.seat = snapped(link.seat * seat);
    result.link.inertia = snapped(transformed(link.inertia, back));
    absorb_turn(result.link);
    for (MovingLink& child : result.children) {
      child.seat = snapped(back * child.seat);
      absorb_turn(child);
    }
    for (ExactPose& point : result.points) {
      point = snapped(back * point);
    }
    result.old_frame = back * old_frame;
    return result;
  }
};

std::vector<Exact> turn_candidates(const Neighbourhood& around) {
  std::vector<Exact> turns{0, -right_turn(around.link.seat.R)};
  const auto towards = [&turns](const ExactVector3& v) {
    if (v(0) != 0 || v(1) != 0) {
      turns.push_back(atan2(v(1), v(0)));
    }
  };
  for (const MovingLink& child : around.children) {
    Exact turn;
    if (left_turn(child.seat.R, turn)) {
      turns.push_back(turn);
    }
    towards(child.seat.p);
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

/// Where on z the common normal with the child's axis stands.
Exact foot_of_common_normal(const ExactPose& child) {
  const Exact c = child.R(2, 2);
  const Exact along = child.R.col(2).dot(child.p);
  return (child.p(2) - c * along) / (1 - c * c);
}

std::vector<ExactVector3> slide_candidates(const Neighbourhood& around) {
  std::vector<Exact> along{0, -(around.link.seat.R.transpose() * around.link.seat.p)(2)};
  if (!is_parallel(around.link.seat.R)) {
    along.push_back(foot_of_common_normal(inverse(around.link.seat)));
  }
  for (const MovingLink& child : around.children) {
    along.push_back(child.seat.p(2));
    if (!is_parallel(child.seat.R)) {
      along.push_back(foot_of_common_normal(child.seat));
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

/// The origin of a prismatic link may be anywhere.
std::vector<ExactVector3> shift_candidates(const Neighbourhood& around) {
  std::vector<ExactVector3> shifts{ExactVector3::Zero()};
  shifts.emplace_back(-(around.link.seat.R.transpose() * around.link.seat.p));
  for (const MovingLink& child : around.children) {
    shifts.push_back(child.seat.p);
  }
  for (const ExactPose& point : around.points) {
    shifts.push_back(point.p);
  }
  if (around.link.inertia.mass != 0) {
    shifts.emplace_back(around.link.inertia.h / around.link.inertia.mass);
  }
  return shifts;
}

Neighbourhood best_seated(const Neighbourhood& around) {
  Neighbourhood best = around.reseated({});
  int best_cost = best.cost();
  const std::vector<ExactVector3> shifts = around.link.kind == JointKind::prismatic
                                               ? shift_candidates(around)
                                               : slide_candidates(around);
  for (const Exact& turn : turn_candidates(around)) {
    const ExactMatrix3 R = rotation_z(turn);
    for (const ExactVector3& shift : shifts) {
      const Neighbourhood seated = around.reseated({R, shift});
      const int cost = seated.cost();
      if (cost < best_cost) {
        best = seated;
        best_cost = cost;
      }
    }
  }
  return best;
}

/// Visits what hangs on link `index`: children first, then points, always in the same order.
template <class OnChild, class OnPoint>
void for_each_around(Mechanism& mechanism, int index, OnChild on_child, OnPoint on_point) {
  for (MovingLink& link : mechanism.links) {
    if (link.parent == index) {
      on_child(link);
    }
  }
  for (auto* points :
       {&mechanism.operational_points, &mechanism.external_forces, &mechanism.contacts}) {
    for (MechanismPoint& point : *points) {
      if (point.link == index) {
        on_point(point);
      }
    }
  }
}

/// Returns whether it became cheaper.
bool seat_link(Mechanism& mechanism, int index) {
  Neighbourhood around{mechanism.links[static_cast<std::size_t>(index)], {}, {}, {}};
  for_each_around(
      mechanism, index, [&](const MovingLink& child) { around.children.push_back(child); },
      [&](const MechanismPoint& point) { around.points.push_back(point.pose); });
  const int cost = around.cost();
  const Neighbourhood best = best_seated(around);
  if (best.cost() >= cost) {
    return false;
  }
  mechanism.links[static_cast<std::size_t>(index)] = best.link;
  std::size_t child = 0;
  std::size_t point = 0;
  for_each_around(
      mechanism, index, [&](MovingLink& moved) { moved = best.children[child++]; },
      [&](MechanismPoint& moved) { moved.pose = best.points[point++]; });
  for (MechanismPoint& frame : mechanism.link_frames) {  // for whoever asks: they weigh nothing
    if (frame.link == index) {
      frame.pose = snapped(best.old_frame * frame.pose);
    }
  }
  return true;
}

}  // namespace

void seat_frames(Mechanism& mechanism) {
  constexpr int kMostSweeps = 10;  // each sweep only lowers an integer cost; few are ever needed
  const int count = static_cast<int>(mechanism.links.size());
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool cheaper = false;
    for (int i = 0; i < count; ++i) {
      if (mechanism.links[static_cast<std::size_t>(i)].kind != JointKind::floating) {
        cheaper = seat_link(mechanism, i) || cheaper;
      }
    }
    if (!cheaper) {
      break;
    }
  }
}

}  // namespace treeline
