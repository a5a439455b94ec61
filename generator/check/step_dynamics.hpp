#pragma once

#include <vector>

#include "check/step_library.hpp"
#include "interpreter/digits50.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// The dynamics of a controller's robot by the interpreter, for the reference's step and for the
/// robot that it moves.
class StepDynamics {
 public:
  /// `generation`, which has a controller, must outlive this object.
  StepDynamics(const Robot& robot, const Scene& scene, const Generation& generation,
               std::uint64_t seed);

  /// A state within ordinary limits, with every argument that the controller's functions take.
  [[nodiscard]] State draw(int index) const;
  /// Accelerations of the robot under joint forces.
  [[nodiscard]] std::vector<double> accelerate(State state) const;
  /// Positions (3 a point), then rotations (9 a point) of the operational points.
  [[nodiscard]] std::vector<double> poses(const State& state) const;
  [[nodiscard]] double unit() const { return unit_; }

  /// Computes by 50 digits from now on, or by numbers of the emitted code's type.
  void compute_in_fifty(bool fifty) { fifty_ = fifty; }
  /// Callback for `StepLibrary::connect`; `with` is this object.
  static void compute(void* with, int index, const long double* const* in, long double* const* out);

 private:
  [[nodiscard]] std::vector<long double> interpret_result(const Program& program,
                                                          const std::string& result,
                                                          const State& state) const;
  [[nodiscard]] std::vector<long double> run(Function function, const TaskLaw* law,
                                             const State& state) const;
  [[nodiscard]] std::vector<long double> push(const State& state) const;

  const Generation& generation_;
  std::vector<GeneratedFunction> functions_;  ///< the controller's, for the states' arguments
  Subject<Digits50> exact_, pushed_;          ///< the robot; with all rows of points, in world axes
  Subject<float> single_;
  StateSpace space_;
  double unit_;
  bool fifty_ = true;
};

}  // namespace treeline
