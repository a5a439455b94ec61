#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bounds/rng.hpp"
#include "check/step_dynamics.hpp"
#include "check/step_library.hpp"
#include "core/mode.hpp"

namespace treeline {

/// A motion under the emitted controller: commands of every kind, sound and not, switches of modes,
/// and near its end one thing that goes wrong. The robot moves by the interpreter's dynamics.
class StepMotion {
 public:
  /// Number of different mishaps. Motion `index` has the mishap `index` modulo this number.
  static constexpr int kMishaps = 6;
  static constexpr int kSteps = 500;

  StepMotion(const StepLibrary& library, const StepDynamics& dynamics, int index,
             std::uint64_t seed);

  /// Prepares configuration and input of the next step.
  void prepare();
  /// Moves the robot by a step under the torque of this output.
  void move(const StepNumbers& output);

  [[nodiscard]] const StepNumbers& config() const { return config_; }
  [[nodiscard]] const StepNumbers& input() const { return input_; }
  /// Whether this step has a command, or anything else that is worth a look.
  [[nodiscard]] bool is_special() const { return special_; }
  [[nodiscard]] bool has_reset() const { return reset_; }

 private:
  void set(const std::string& member, const std::vector<long double>& values);
  void command(int kind, double duration = 0);
  void move_joints(double size, double duration,
                   core::MessageKind kind = core::MessageKind::set_posture);
  void move_point(double size, double duration);
  void press();
  void behave(bool first);
  void observe();
  void comply();
  void command_nonsense(int which);
  void go_wrong(int since);
  void follow_script();
  [[nodiscard]] std::vector<double> start_pose(Rng& rng) const;

  const StepLibrary& library_;
  const StepDynamics& dynamics_;
  static constexpr int kObserves = 3;  ///< of the mishaps: velocities are not measured
  int mishap_;
  Rng rng_;
  State robot_;
  std::vector<long double> lower_, upper_, speed_;
  double period_;
  StepNumbers default_config_, config_, input_;
  int tick_ = -1;
  long double sequence_ = 0;
  bool special_ = false, reset_ = false;
};

/// A step of a motion that was made.
struct MadeStep {
  int index = 0;              ///< in the motion
  const StepNumbers& before;  ///< the state that it was given
  const StepResult& result;
  bool stands_out = false;  ///< a command, another mode, or anything else that is worth a look
};

/// Makes all steps of a motion, and shows each before the robot moves on.
void run_steps(const StepLibrary& library, StepMotion& motion,
               const std::function<void(const MadeStep&)>& show);

}  // namespace treeline
