#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "comparison/difference.hpp"

namespace treeline {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Index of each item's partner in the other robot; -1 if it has none.
struct Partners {
  std::vector<int> of_first, of_second;

  template <class Item>
  Partners(const std::vector<Item>& first, const std::vector<Item>& second)
      : of_first(first.size(), -1), of_second(second.size(), -1) {
    std::map<std::string, int> names;
    for (std::size_t i = 0; i < second.size(); ++i) names[second[i].name] = static_cast<int>(i);
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto found = names.find(first[i].name);
      if (found != names.end()) join(static_cast<int>(i), found->second);
    }
  }

  void join(int a, int b) {
    of_first[index(a)] = b;
    of_second[index(b)] = a;
  }
  /// Joins two items if neither has a partner. Returns whether it did.
  bool join_if_free(int a, int b) {
    if (of_first[index(a)] >= 0 || of_second[index(b)] >= 0) return false;
    join(a, b);
    return true;
  }
};

double distance(const Pose& a, const Pose& b) {
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    square += std::pow(a.xyz[i] - b.xyz[i], 2) + std::pow(a.rpy[i] - b.rpy[i], 2);
  }
  return square;
}

/// Lists the pairs in the order of the first robot, and the items of both robots without a partner.
void list(const Partners& partners, std::vector<Match>& both, std::vector<int>& only_in_first,
          std::vector<int>& only_in_second) {
  for (std::size_t i = 0; i < partners.of_first.size(); ++i) {
    const int first = static_cast<int>(i);
    if (partners.of_first[i] >= 0) {
      both.push_back({first, partners.of_first[i]});
    } else {
      only_in_first.push_back(first);
    }
  }
  for (std::size_t i = 0; i < partners.of_second.size(); ++i) {
    if (partners.of_second[i] < 0) only_in_second.push_back(static_cast<int>(i));
  }
}

class Matching {
 public:
  Matching(const Robot& first, const Robot& second)
      : first_(first),
        second_(second),
        links_(first.links, second.links),
        joints_(first.joints, second.joints) {
    links_.join_if_free(first.root, second.root);
    while (join_ends() || join_nearest()) {
    }
  }

  [[nodiscard]] RobotMatch result() const {
    RobotMatch match;
    list(links_, match.links, match.links_only_in_first, match.links_only_in_second);
    list(joints_, match.joints, match.joints_only_in_first, match.joints_only_in_second);
    return match;
  }

 private:
  [[nodiscard]] int joint_to(const Robot& robot, int child) const {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      if (robot.joints[j].child == child) return static_cast<int>(j);
    }
    return -1;
  }

  /// Joins the children of joints that are in both robots, and the joints between links that are in
  /// both.
  bool join_ends() {
    bool joined = false;
    for (std::size_t j = 0; j < first_.joints.size(); ++j) {
      const Joint& joint = first_.joints[j];
      const int partner = joints_.of_first[j];
      if (partner >= 0) {
        joined |= links_.join_if_free(joint.child, second_.joints[index(partner)].child);
        continue;
      }
      const int child = links_.of_first[index(joint.child)];
      const int other = child < 0 ? -1 : joint_to(second_, child);
      const bool same_parent =
          other >= 0 && links_.of_first[index(joint.parent)] == second_.joints[index(other)].parent;
      if (same_parent) joined |= joints_.join_if_free(static_cast<int>(j), other);
    }
    return joined;
  }

  /// Joins one pair of joints without partners, of the same type, that leave a link in both robots:
  /// the pair whose origins are nearest to each other.
  bool join_nearest() {
    double nearest = std::numeric_limits<double>::infinity();
    Match best;
    for (std::size_t j = 0; j < first_.joints.size(); ++j) {
      const Joint& a = first_.joints[j];
      const int parent = links_.of_first[index(a.parent)];
      if (joints_.of_first[j] >= 0 || parent < 0 || links_.of_first[index(a.child)] >= 0) continue;
      for (std::size_t k = 0; k < second_.joints.size(); ++k) {
        const Joint& b = second_.joints[k];
        const bool free = joints_.of_second[k] < 0 && links_.of_second[index(b.child)] < 0;
        if (!free || b.parent != parent || b.type != a.type) continue;
        if (distance(a.origin, b.origin) >= nearest) continue;
        nearest = distance(a.origin, b.origin);
        best = {static_cast<int>(j), static_cast<int>(k)};
      }
    }
    return best.first >= 0 && joints_.join_if_free(best.first, best.second);
  }

  const Robot& first_;
  const Robot& second_;
  Partners links_, joints_;
};

}  // namespace

RobotMatch match_robots(const Robot& first, const Robot& second) {
  return Matching(first, second).result();
}

}  // namespace treeline
