#include "inspect/recognise_robot.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "description/scene_queries.hpp"
#include "inspect/body_shapes.hpp"
#include "inspect/end_names.hpp"

namespace treeline {
namespace {

constexpr double kAlike = 0.1;          ///< of the reach: tolerance of symmetry
constexpr double kHanging = 0.4;        ///< of the reach: how far a leg reaches down at least
constexpr double kFingerReach = 0.25;   ///< m, of the longest finger
constexpr int kJointsOfAFinger = 5;     ///< at most
constexpr int kJointsBeforeAWheel = 2;  ///< at most: a fork that steers, and the wheel

/// Finds limbs and what they are for.
class Recognition : private BodyShapes {
 public:
  explicit Recognition(const BodyShapes& shapes) : BodyShapes{shapes} {
    const auto gravity = robot.hints.gravity.value_or(std::array{0.0, 0.0, -1.0});
    const Eigen::Vector3d down(gravity[0], gravity[1], gravity[2]);
    if (down.norm() > 0) up_ = -down.normalized();
    prefix_ = prefix_of_all(robot, tree);
    base_ = find_base();
    held_ = base_ == 0 && is_ground(link(robot.root).name);
    find_hands();
  }

  [[nodiscard]] int base() const { return base_; }
  [[nodiscard]] const std::string& prefix() const { return prefix_; }

  [[nodiscard]] std::vector<Limb> find_limbs() const {
    std::vector<Limb> limbs;
    for (auto b = static_cast<std::size_t>(base_) + 1; b < tree.bodies.size(); ++b) {
      const bool is_end = hands_[b] || tree.bodies[b].children.empty();
      if (!beyond_hands_[b] && is_end && is_on(static_cast<int>(b), base_)) {
        limbs.push_back(limb_of(static_cast<int>(b)));
      }
    }
    for (Limb& limb : limbs) limb.role = role_of(limb);
    doubt_names(limbs);
    find_legs(limbs);
    find_fingers(limbs);
    for (Limb& limb : limbs) limb.is_side_branch = is_side_branch(limb, limbs);
    mark_half_legs(limbs);
    return limbs;
  }

 private:
  [[nodiscard]] int depth(int b) const { return depths_[static_cast<std::size_t>(b)]; }

  /// The body that floats in the world if most of the others hang from it, or the root's.
  [[nodiscard]] int find_base() const {
    const auto& first = tree.bodies.front().children;
    for (const int b : first) {
      std::size_t carried = 0;
      for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
        carried += is_on(static_cast<int>(i), b) ? 1 : 0;
      }
      const bool floats = joint_of(b).type == JointType::floating;
      if (floats && 2 * carried > tree.bodies.size()) return b;
    }
    if (first.size() != 1) return 0;
    const JointType type = joint_of(first[0]).type;
    return info_of(type).has_one_freedom() || type == JointType::ball ? 0 : first[0];
  }

  /// A hand carries two or more short branches, at the end of an arm that is longer than they are.
  void find_hands() {
    const std::size_t number = tree.bodies.size();
    hands_.assign(number, false);
    beyond_hands_.assign(number, false);
    depths_.assign(number, 0);
    on_leg_.assign(number, false);
    std::vector<double> lengths(number, 0);  // from the first joint on the way from the root
    for (std::size_t i = 1; i < number; ++i) {
      const int b = static_cast<int>(i);
      const auto before = static_cast<std::size_t>(body(b).parent);
      depths_[i] = b == base_ ? 0 : depths_[before] + 1;
      on_leg_[i] = first_word(b) == LimbRole::leg || (on_leg_[before] && !is_above_legs(b));
      lengths[i] = body(b).parent <= base_
                       ? 0
                       : lengths[before] + (origin(b) - origin(body(b).parent)).norm();
      beyond_hands_[i] = beyond_hands_[before] || hands_[before];
      if (body(b).children.size() < 2 || depth(b) < kJointsOfAnArm || beyond_hands_[i] ||
          first_word(b) == LimbRole::watching) {
        continue;
      }
      if (on_leg_[i]) {
        hands_[i] = carries_jaws(b);
        continue;
      }
      double fingers = 0;
      bool named = true;
      for (const int child : body(b).children) {
        fingers = std::max(fingers, reach_of(child));
        named = named && first_word(child) == LimbRole::finger;
      }
      hands_[i] =
          named || (fingers < kFingerReach && fingers < 0.5 * lengths[i] && !carries_a_hand(b));
    }
  }

  /// The role that a name tells beyond what all names begin with.
  [[nodiscard]] LimbRole word(const std::string& name) const {
    return limb_word(name.starts_with(prefix_) ? name.substr(prefix_.size()) : name);
  }
  [[nodiscard]] LimbRole first_word(int b) const { return word(link(body(b).links.front()).name); }

  /// Whether fingers and nothing else hang from a body, each a joint.
  [[nodiscard]] bool carries_jaws(int b) const {
    const auto& children = body(b).children;
    const auto is_leaf = [this](int child) { return body(child).children.empty(); };
    return std::all_of(children.begin(), children.end(), is_leaf) &&
           std::count_if(children.begin(), children.end(),
                         [this](int child) { return first_word(child) == LimbRole::finger; }) >= 2;
  }

  /// Whether a body's name is one of an arm or a trunk, which may stand on legs.
  [[nodiscard]] bool is_above_legs(int b) const {
    const LimbRole word = first_word(b);
    return word == LimbRole::arm || word == LimbRole::trunk;
  }

  /// Whether the next body is the hand by its name, and no finger beside it. A gripper beside
  /// another child is often a jaw.
  [[nodiscard]] bool carries_a_hand(int b) const {
    bool hand = false;
    for (const int child : body(b).children) {
      if (first_word(child) == LimbRole::finger) return false;
      hand = hand || is_hand(link(body(child).links.front()).name);
    }
    return hand;
  }

  /// Whether a limb that comes from a body goes on through the one before: what else hangs there is
  /// a single joint, such as a spring or a cover.
  [[nodiscard]] bool goes_on_through(int before, int from) const {
    const auto& children = body(before).children;
    if (children.size() == 1) return true;
    return !body(from).children.empty() &&
           std::all_of(children.begin(), children.end(),
                       [&](int child) { return child == from || body(child).children.empty(); });
  }

  [[nodiscard]] Limb limb_of(int last) const {
    Limb limb;
    limb.last = limb.first = last;
    limb.carries_fingers = hands_[static_cast<std::size_t>(last)];
    limb.joints = 1;
    for (int a = body(last).parent; a > base_ && goes_on_through(a, limb.first);
         a = body(a).parent) {
      limb.first = a;
      ++limb.joints;
    }
    for (int b = last; b >= limb.first; b = body(b).parent) {
      limb.masses += places(b).size() > body(b).links.size() ? 1 : 0;
    }
    limb.start = origin(limb.first);
    limb.axis = axis(limb.first);
    limb.tip = limb.start;
    for (const Eigen::Vector3d& place : places(last)) {
      if ((place - limb.start).norm() > (limb.tip - limb.start).norm()) limb.tip = place;
    }
    limb.reach = (limb.tip - limb.start).norm();
    return limb;
  }

  /// Whether a body turns without end about an axis through its centre of mass.
  [[nodiscard]] bool spins(int b) const {
    const Joint& joint = joint_of(b);
    const bool endless =
        joint.type == JointType::continuous ||
        (joint.type == JointType::revolute &&
         (!joint.limits || joint.limits->upper.value() - joint.limits->lower.value() > 25));
    if (!endless || !body(b).children.empty()) return false;
    double off = 0;
    for (const Eigen::Vector3d& place : places(b)) {
      off = std::max(off, (place - origin(b)).cross(axis(b)).norm());
    }
    return off < 0.01;
  }

  /// Whether another leaf spins about a parallel axis, beside this one.
  [[nodiscard]] bool has_companion(int b) const {
    for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
      const int other = static_cast<int>(i);
      if (other != b && depth(other) == depth(b) && spins(other) &&
          axis(other).cross(axis(b)).norm() < kAlike && (origin(other) - origin(b)).norm() > 0.03) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] LimbRole role_of(const Limb& limb) const {
    const LimbRole named = named_role(limb);
    const bool low = depth(limb.last) <= kJointsBeforeAWheel;
    if (named == LimbRole::unknown && low && spins(limb.last) && has_companion(limb.last)) {
      const double upright = std::abs(axis(limb.last).dot(up_));
      if (upright < kAlike) return LimbRole::wheel;
      if (upright > 1 - kAlike) return LimbRole::propeller;
    }
    return named;
  }

  /// The role that most names of the limb's links and joints tell; the end's name counts most.
  [[nodiscard]] LimbRole named_role(const Limb& limb) const {
    std::map<LimbRole, int> votes;
    for (int b = limb.last;; b = body(b).parent) {
      ++votes[word(joint_of(b).name)];
      for (const int l : body(b).links) votes[word(link(l).name)] += b == limb.last ? 2 : 1;
      if (b == limb.first) break;
    }
    votes.erase(LimbRole::unknown);
    if (limb.joints == 1 && is_sensor(link(body(limb.last).links.front()).name)) {
      return LimbRole::watching;
    }
    // A wheel at the end of a leg is its foot; a camera on an arm does not make it a head.
    const auto named = [&](LimbRole role) { return votes.contains(role) ? votes.at(role) : 0; };
    const bool is_finger =
        limb.reach < kFingerReach && named(LimbRole::finger) > named(LimbRole::arm);
    const bool long_enough = limb.joints >= kJointsOfAnArm && !is_finger;
    if (limb.carries_fingers) votes.erase(LimbRole::finger);
    if (long_enough && (votes.contains(LimbRole::leg) || votes.contains(LimbRole::arm))) {
      votes.erase(LimbRole::wheel);
      votes.erase(LimbRole::watching);
      votes.erase(LimbRole::finger);
      votes.erase(LimbRole::trunk);
    }
    const auto best =
        std::max_element(votes.begin(), votes.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return best == votes.end() ? LimbRole::unknown : best->first;
  }

  /// No robot has a finger of the length of an arm or an arm as short as a finger, nor two necks of
  /// three joints.
  void doubt_names(std::vector<Limb>& limbs) const {
    const auto is_neck = [](const Limb& limb) {
      return limb.role == LimbRole::watching && limb.joints >= kJointsOfAnArm;
    };
    const bool many = std::count_if(limbs.begin(), limbs.end(), is_neck) > 1;
    for (Limb& limb : limbs) {
      const bool too_long = limb.role == LimbRole::finger && limb.reach > 2 * kFingerReach;
      if (too_long || (many && is_neck(limb))) limb.role = LimbRole::unknown;
      const bool of_gripper = limb.role == LimbRole::arm && limb.joints < kJointsOfAnArm &&
                              body(limb.first).parent == base_ && limb.reach < kFingerReach &&
                              limbs.size() > 1;
      if (of_gripper) limb.role = LimbRole::finger;
    }
  }

  /// Two limbs from one body that are alike: their tips differ along one horizontal direction.
  [[nodiscard]] bool are_a_pair(const Limb& a, const Limb& b) const {
    const double tolerance = kAlike * std::max(a.reach, b.reach);
    const Eigen::Vector3d apart = b.tip - a.tip;
    return are_alike(a, b) && std::abs(apart.dot(up_)) < tolerance && apart.norm() > tolerance;
  }

  /// Legs are pairs that hang from the root to the lowest place. A name that says otherwise wins.
  void find_legs(std::vector<Limb>& limbs) const {
    double lowest = 0;
    for (const Limb& limb : limbs) lowest = std::min(lowest, limb.tip.dot(up_));
    std::vector<Limb*> legs;
    for (Limb& limb : limbs) {
      const bool paired = std::any_of(limbs.begin(), limbs.end(), [&](const Limb& other) {
        return &other != &limb && are_a_pair(limb, other);
      });
      const bool hangs = (limb.start - limb.tip).dot(up_) > kHanging * limb.reach &&
                         limb.tip.dot(up_) < lowest + 0.2 * limb.reach;
      const int carrier = body(limb.first).parent;
      const bool on_hip = carrier == base_ || first_word(carrier) == LimbRole::leg;
      if (limb.role == LimbRole::unknown && limb.joints >= 2 && on_hip && paired && hangs &&
          !held_) {
        legs.push_back(&limb);
      }
    }
    const bool is_hand = std::any_of(limbs.begin(), limbs.end(), [this](const Limb& limb) {
      return limb.role == LimbRole::finger && body(limb.first).parent == base_;
    });
    if (legs.size() % 2 != 0 || is_hand) return;
    for (Limb* const leg : legs) leg->role = LimbRole::leg;
  }

  /// Fingers are three or more short limbs on one body that something holds, short ones with a tip
  /// or a pad, all that are short of a hand, and two that slide and are all that there is.
  void find_fingers(std::vector<Limb>& limbs) const {
    const auto is_tip = [this](int l) { return end_name(link(l).name).kind == EndKind::tip; };
    std::map<int, int> numbers;  // by the body that carries them
    for (const Limb& limb : limbs) {
      const bool counts = limb.role == LimbRole::finger || (is_short(limb) && limb.joints >= 2);
      numbers[body(limb.first).parent] += counts ? 1 : 0;
    }
    const bool floats = base_ > 0 || default_base(robot) == Base::floating;
    const bool slide = limbs.size() == 2 && are_alike(limbs[0], limbs[1]) && slides(limbs[0]);
    for (Limb& limb : limbs) {
      const auto& links = body(limb.last).links;
      const bool among = limb.joints >= 2 && numbers[body(limb.first).parent] >= 3 && !floats;
      const bool tips =
          limb.joints <= kJointsOfAFinger && std::any_of(links.begin(), links.end(), is_tip);
      const bool of_hand = end_name(prefix_).kind == EndKind::hand;
      if (is_short(limb) && (slide || among || tips || of_hand)) limb.role = LimbRole::finger;
    }
  }
  [[nodiscard]] bool is_short(const Limb& limb) const {
    return limb.role == LimbRole::unknown && limb.reach < kFingerReach && !limb.carries_fingers;
  }
  [[nodiscard]] bool slides(const Limb& limb) const {
    return limb.joints == 1 && joint_of(limb.first).type == JointType::prismatic;
  }

  /// Two limbs of one size from one body.
  [[nodiscard]] bool are_alike(const Limb& a, const Limb& b) const {
    return body(a.first).parent == body(b.first).parent && a.joints == b.joints &&
           std::abs(a.reach - b.reach) <= kAlike * std::max(a.reach, b.reach);
  }

  /// Whether a limb is a joint or two beside the rest of another of its kind that ends in a better
  /// name or goes on for longer, such as a gear, or a rod that moves the foot.
  [[nodiscard]] bool is_side_branch(const Limb& limb, const std::vector<Limb>& limbs) const {
    const auto goodness = [this](const Limb& of) {
      const auto kind = end_name(link(body(of.last).links.front()).name).kind;
      return std::tuple(-static_cast<int>(kind), depth(of.last), -of.last);
    };
    return std::any_of(limbs.begin(), limbs.end(), [&](const Limb& other) {
      if (other.role != limb.role || are_alike(limb, other)) return false;
      int from = limb.last;
      while (!is_on(other.last, from)) from = body(from).parent;
      return from > base_ && depth(limb.last) - depth(from) <= 2 &&
             goodness(limb) < goodness(other);
    });
  }

  Eigen::Vector3d up_ = Eigen::Vector3d::UnitZ();
  std::string prefix_;  ///< see `prefix_of_all`
  int base_ = 0;
  bool held_ = false;                                ///< the root is the world
  std::vector<bool> hands_, beyond_hands_, on_leg_;  ///< by body
  std::vector<int> depths_;                          ///< joints from the base to a body
};

}  // namespace

RecognisedRobot recognise_robot(const Robot& robot, const BodyTree& tree) {
  const Recognition recognition(BodyShapes{robot, tree});
  RecognisedRobot found;
  found.base = recognition.base();
  found.prefix = recognition.prefix();
  found.limbs = recognition.find_limbs();
  const Body& base = tree.bodies[static_cast<std::size_t>(found.base)];
  name_kind(robot, base, found);
  return found;
}

}  // namespace treeline
