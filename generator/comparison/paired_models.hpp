#pragma once

#include <string>
#include <vector>

#include "bounds/rng.hpp"
#include "comparison/difference.hpp"
#include "description/scene.hpp"
#include "interpreter/instances.hpp"

namespace treeline {

/// A velocity that both models have.
struct SharedVelocity {
  int first = 0, second = 0;  ///< indices in qd of each model
  std::string joint;          ///< of the first robot; "base" for a floating base
  bool turns = false;         ///< rotation, with forces in N m; else translation, in N
};

/// States of two robots in which shared joints agree and all others are at 0.
struct PairedState {
  interpreter::Vector<double> first, second;
};

/// Models of two robots in the interpreter, and the joints and velocities that they share.
class PairedModels {
 public:
  PairedModels(const Robot& first, const Robot& second, const RobotMatch& match, Base base);

  [[nodiscard]] const interpreter::Model<double>& first() const { return first_; }
  [[nodiscard]] const interpreter::Model<double>& second() const { return second_; }
  [[nodiscard]] const std::vector<SharedVelocity>& velocities() const { return velocities_; }

  /// Draws positions within the limits of the first robot, or within a turn or 1 m if there are
  /// none.
  [[nodiscard]] PairedState draw_position(Rng& rng) const;
  /// Draws a vector of velocities, accelerations or anything else with nv entries, between -1 and
  /// 1.
  [[nodiscard]] PairedState draw_velocity(Rng& rng) const;

 private:
  /// Two bodies whose joints correspond.
  struct Pair {
    int first, second;
    double lower, upper;
  };
  void add_velocities(const Pair& pair, const std::string& joint);
  void place_second(const Pair& pair, const interpreter::Vector<double>& q,
                    interpreter::Vector<double>& q_second) const;

  interpreter::Model<double> first_, second_;
  std::vector<Pair> pairs_;
  std::vector<SharedVelocity> velocities_;
};

/// Index of the body with this name.
int body_named(const interpreter::Model<double>& model, const std::string& link);

}  // namespace treeline
