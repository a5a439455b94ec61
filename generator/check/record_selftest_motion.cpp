#include <algorithm>
#include <cmath>
#include <utility>

#include "check/add_selftest.hpp"
#include "check/step_dynamics.hpp"
#include "check/step_library.hpp"
#include "compilation/temporary_folder.hpp"
#include "core/mode.hpp"
#include "emission/controller_unit.hpp"
#include "emission/write_files.hpp"

namespace treeline {
namespace {

using core::MessageKind;
using Motion = SelftestFacts::Motion;

/// Speed of the joints, rad/s or m/s, and how far goals are away, rad or m.
constexpr double kMotionSpeed = 0.1;
constexpr double kMotionGoal = 0x1p-5;

/// The largest multiple of a step that does not exceed a number of either sign.
double cut_to(double step, double number) {
  return std::trunc(number / step) * step;
}

double round_to(Real real, double number) {
  return real == Real::float32 ? static_cast<double>(static_cast<float>(number)) : number;
}

std::vector<double> read_config(const StepLibrary& library, const char* name) {
  const StepMember& member = *library.find(StepPart::config, name);
  const StepNumbers config = library.default_config();
  const auto from = config.begin() + static_cast<std::ptrdiff_t>(member.at);
  return {from, from + static_cast<std::ptrdiff_t>(member.count)};
}

/// The joints near the middle of their ranges. Sums and products that the motion is made of are
/// exact in float too, so that no contraction changes them.
void place_joints(const StepLibrary& library, Real real, Motion& motion) {
  const auto lower = read_config(library, "lower"), upper = read_config(library, "upper");
  const auto speed = read_config(library, "speed");
  const double period = read_config(library, "period").front();
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const double low = std::max(lower[i], -2.0), high = std::min(upper[i], 2.0);
    const double side = i % 2 == 0 ? 1 : -1;
    const double reach = std::max(high - low, 0.0) / 8;
    const double middle = low < high ? (low + high) / 2 : std::clamp(0.0, lower[i], upper[i]);
    motion.q.push_back(cut_to(0x1p-10, middle + (side * reach)));
    motion.way.push_back(cut_to(0x1p-17, side * std::min(kMotionSpeed, speed[i] / 8) * period));
    motion.goal.push_back(kMotionGoal < reach ? -side * kMotionGoal : 0);
  }
  motion.rate = round_to(real, 1 / period);
}

/// Names and kinds of the commands that the controller's laws know.
std::vector<std::pair<std::string, MessageKind>> list_commands(const ControllerUnit& unit) {
  std::vector<std::pair<std::string, MessageKind>> commands = {
      {"START", MessageKind::start}, {"MOVE_JOINTS", MessageKind::set_posture}};
  if (unit.task_torque) commands.emplace_back("MOVE_POINT", MessageKind::move_point);
  if (unit.settings.force) commands.emplace_back("PRESS", MessageKind::press);
  if (unit.behaves()) commands.emplace_back("BEHAVE", MessageKind::behave);
  commands.emplace_back("COMPLY", MessageKind::comply);
  commands.emplace_back("LEAD_JOINTS", MessageKind::lead_posture);
  commands.emplace_back("STOP", MessageKind::stop);
  return commands;
}

/// Members of the input that stay: what the robot carries, and where commands lead a point.
void add_inputs(const StepLibrary& library, const StepDynamics& dynamics, Motion& motion) {
  State state = dynamics.draw(0);
  const auto add = [&](const std::string& member, const std::vector<double>& numbers) {
    const bool is_there = library.find(StepPart::input, member) != nullptr && !numbers.empty();
    if (is_there) motion.inputs.push_back({member, {numbers}});
  };
  for (const auto& [quantity, numbers] : state.others) {
    std::vector<double> few = numbers;
    if (quantity != Quantity::tool_orientation) {
      std::transform(few.begin(), few.end(), few.begin(), shorten);
    }
    add(symbol_of(quantity), few);
  }
  if (library.find(StepPart::input, "command.position") != nullptr) {
    state.q = motion.q;
    const std::vector<double> poses = dynamics.poses(state);
    add("command.position", {shorten(poses[0]), shorten(poses[1]), shorten(poses[2])});
    add("command.rotation", {1, 0, 0, 0, 1, 0, 0, 0, 1});
  }
  add("command.direction", {0, 0, -1});
}

/// Runs the steps as the emitted source does.
class MotionRun {
 public:
  MotionRun(const StepLibrary& library, Real real, Motion& motion)
      : library_(library),
        real_(real),
        motion_(motion),
        config_(library.default_config()),
        input_(library.zeros(StepPart::input)),
        output_(library.zeros(StepPart::output)),
        state_(library.zeros(StepPart::state)) {
    for (const auto& each : motion.inputs) {
      for (std::size_t i = 0; i < each.by_state.front().size(); ++i) {
        set(each.name, each.by_state.front()[i], i);
      }
    }
    if (library.find(StepPart::input, "command.force") != nullptr) {
      set("command.force", Motion::kForce);
    }
    set("command.duration", Motion::kDuration);
  }

  void run(int command, MessageKind kind) {
    set("command.kind", static_cast<double>(kind));
    set("command.sequence", command + 1);
    for (int tick = 0; tick < Motion::kTicks; ++tick) {
      for (std::size_t i = 0; i < motion_.q.size(); ++i) {
        set("q", motion_.q[i] + ((command * Motion::kTicks) + tick) * motion_.way[i], i);
        set("qd", round_to(real_, motion_.way[i] * motion_.rate), i);
        set("command.goal", motion_.q[i] + motion_.goal[i], i);
      }
      library_.step(config_, state_, input_, output_);
    }
    std::vector<double>& tau = motion_.tau.emplace_back();
    for (std::size_t i = 0; i < motion_.q.size(); ++i) tau.push_back(read("tau", i));
    motion_.modes.push_back(static_cast<int>(read("mode")));
    motion_.faults.push_back(static_cast<std::uint32_t>(read("faults")));
  }

 private:
  void set(const std::string& member, double value, std::size_t i = 0) {
    input_[library_.find(StepPart::input, member)->at + i] = static_cast<long double>(value);
  }
  [[nodiscard]] double read(const std::string& member, std::size_t i = 0) const {
    return static_cast<double>(output_[library_.find(StepPart::output, member)->at + i]);
  }

  const StepLibrary& library_;
  Real real_;
  Motion& motion_;
  StepNumbers config_, input_, output_, state_;
};

}  // namespace

std::optional<Motion> record_selftest_motion(const Robot& robot, const Scene& scene,
                                             const Generation& generation,
                                             Diagnostics& diagnostics) {
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  const std::filesystem::path sources = work->path() / scene.name;
  if (!write_files(sources, generation.files, diagnostics)) return std::nullopt;
  const auto library = compile_step(scene, generation, 0, sources, work->path(), diagnostics);
  if (!library) return std::nullopt;
  const StepDynamics dynamics(robot, scene, generation, 1);
  Motion motion;
  place_joints(*library, scene.real, motion);
  add_inputs(*library, dynamics, motion);
  MotionRun run(*library, scene.real, motion);
  int command = 0;
  for (const auto& [name, kind] : list_commands(*generation.controller)) {
    motion.kinds.push_back(name);
    run.run(command++, kind);
  }
  return motion;
}

}  // namespace treeline
