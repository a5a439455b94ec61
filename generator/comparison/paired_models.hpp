#pragma once

#include <string>
#include <vector>

#include "bounds/dice.hpp"
#include "comparison/match_robots.hpp"
#include "description/scene.hpp"
#include "interpreter/instances.hpp"

namespace treeline {

/// A velocity that both models have.
struct SharedVelocity {
  int first = 0, second = 0;  ///< entries of qd
  std::string joint;          ///< of the first robot; "base" of one that floats
  bool turns = false;         ///< N m, else N
};

/// States of two robots in which joints that both have stand alike and the others rest at 0.
struct PairedState {
  interpreter::Vector<double> first, second;
};

/// Two robots as the interpreter has them, and what of their motion is the same.
class PairedModels {
 public:
  PairedModels(const Robot& first, const Robot& second, const RobotMatch& match, Base base);

  [[nodiscard]] const interpreter::Model<double>& first() const { return first_; }
  [[nodiscard]] const interpreter::Model<double>& second() const { return second_; }
  [[nodiscard]] const std::vector<SharedVelocity>& velocities() const { return velocities_; }

  /// Positions within the limits of the first robot, a turn or a metre where there are none.
  [[nodiscard]] PairedState draw_position(Dice& dice) const;
  /// Velocities, accelerations or whatever else has nv entries, within -1 and 1.
  [[nodiscard]] PairedState draw_velocity(Dice& dice) const;

 private:
  /// Two bodies whose joints are the same.
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

/// Index of the body of that name.
int body_named(const interpreter::Model<double>& model, const std::string& link);

}  // namespace treeline
