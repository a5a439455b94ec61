#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include "bounds/rng.hpp"
#include "inspect/report.hpp"
#include "interpreter/joint_parts.hpp"
#include "interpreter/model.hpp"

namespace treeline {

/// Draws states within the limits, the same ones in every run. A joint without limits turns within
/// one turn or slides within 1 m to either side. Joints of several coordinates stay at 0.
class DrawnStates {
 public:
  DrawnStates(const interpreter::Model<double>& model, const Report& report)
      : neutral_(interpreter::Vector<double>::Zero(model.nq)) {
    for (const auto& body : model.bodies) {
      const int quaternion = interpreter::quaternion_of(body);
      if (quaternion >= 0) neutral_[quaternion + 3] = 1;
    }
    for (const JointReport& joint : report.joints) {
      if (joint.nq == 1 && joint.follows.empty()) joints_.push_back(&joint);
    }
  }

  /// The joints of one coordinate that follow no other.
  [[nodiscard]] const std::vector<const JointReport*>& joints() const { return joints_; }

  /// How far a joint without limits is moved from 0, rad or m.
  static double reach(const JointReport& joint) {
    return joint.unit == "rad" ? std::numbers::pi : 1;
  }
  static double lower(const JointReport& joint) { return std::max(joint.lower, -reach(joint)); }
  static double upper(const JointReport& joint) { return std::min(joint.upper, reach(joint)); }

  interpreter::Vector<double> draw() {
    interpreter::Vector<double> q = neutral_;
    for (const JointReport* joint : joints_) {
      q[joint->q] = rng_.within(lower(*joint), upper(*joint));
    }
    return q;
  }

 private:
  static constexpr std::uint64_t kSeed = 1;

  interpreter::Vector<double> neutral_;
  std::vector<const JointReport*> joints_;
  Rng rng_{kSeed};
};

}  // namespace treeline
