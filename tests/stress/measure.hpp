#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oracle/draw_state.hpp"
#include "robots.hpp"

namespace treeline::stress {

/// Loss of one algorithm in one state, or the largest over several states.
struct Loss {
  Function function = Function::gravity;
  std::string algorithm;
  double error = 0;      ///< ulp of the result's scale; infinite where something is not finite
  double condition = 1;  ///< of the matrix solved with, 1 for none
  /// error / condition in the worst state: the loss that an algorithm adds to that of the problem.
  /// 0 if the condition number leaves no digit.
  double ratio = 0;
};

/// Every algorithm of some functions for one robot: the generator's routes as canonicalized
/// expression graphs, evaluated in double, and the interpreter in double. The reference has 50
/// digits.
class Bench {
 public:
  /// `graphs`: whether the generator's routes are included.
  Bench(const Case& of, std::vector<Function> functions, bool graphs = true);
  ~Bench();
  Bench(Bench&&) noexcept;

  /// Draws state `index` within +-pi at ordinary velocities.
  [[nodiscard]] State draw(int index) const;
  [[nodiscard]] std::vector<Loss> measure(const State& state) const;
  /// The largest losses over `states` states, each changed by `change`.
  [[nodiscard]] std::vector<Loss> measure(int states,
                                          const std::function<void(State&)>& change = {}) const;
  /// Whether the force of `core::damped_solve` is finite and torques stay below the stated bound.
  [[nodiscard]] bool damped_torque_is_bounded(const State& state) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Decimal digits that an error in ulp leaves, from 0 to 16.
double digits_left(double error_in_ulp);

}  // namespace treeline::stress
