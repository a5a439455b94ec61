#include <algorithm>
#include <cmath>
#include <cstring>

#include "board/run_board.hpp"
#include "board/templates.hpp"
#include "check/judges.hpp"
#include "check/step_dynamics.hpp"
#include "check/step_library.hpp"
#include "check/step_motion.hpp"
#include "core/mode.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/emitted_text.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// Motions that are run on a board, and steps between two that are counted though nothing happens.
constexpr int kMotions = 2;
constexpr int kCountStride = 25;

void append_doubles(const StepNumbers& numbers, std::string& bytes) {
  for (const long double number : numbers) {
    const auto value = static_cast<double>(number);
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    bytes.append(raw, sizeof(value));
  }
}

void record_motion(const StepLibrary& library, StepMotion motion, StepTape& tape) {
  run_steps(library, motion, [&](const MadeStep& made) {
    const bool counted = made.stands_out || made.index % kCountStride == 0;
    tape.counted.push_back(counted);
    append_doubles({made.index == 0 ? 1.0L : 0.0L, counted ? 1.0L : 0.0L}, tape.bytes);
    append_doubles(motion.config(), tape.bytes);
    append_doubles(motion.input(), tape.bytes);
    StepNumbers result = made.result.output;
    result.insert(result.end(), made.result.state.begin(), made.result.state.end());
    tape.results.push_back(std::move(result));
  });
}

bool are_same_steps(const StepNumbers& host, const std::vector<double>& board) {
  return std::equal(host.begin(), host.end(), board.begin(), board.end(),
                    [](long double a, double b) { return same_bits(static_cast<double>(a), b); });
}

}  // namespace

std::optional<StepTape> record_steps(const Robot& robot, const Scene& scene,
                                     const Generation& generation, const CheckOptions& options,
                                     const fs::path& sources, const fs::path& work,
                                     Diagnostics& diagnostics) {
  const auto library =
      compile_step(scene, generation, options.compile.jobs, sources, work, diagnostics);
  if (!library) return std::nullopt;
  const StepDynamics dynamics(robot, scene, generation, options.references.seed);
  StepTape tape;
  tape.config_size = library->zeros(StepPart::config).size();
  tape.input_size = library->zeros(StepPart::input).size();
  tape.output_size = library->zeros(StepPart::output).size();
  tape.state_size = library->zeros(StepPart::state).size();
  tape.mode_at = library->find(StepPart::output, "mode")->at;
  for (int motion = 0; motion < kMotions; ++motion) {
    record_motion(*library, {*library, dynamics, motion, options.references.seed}, tape);
  }
  return tape;
}

std::string print_step_head(const std::string& name, const fs::path& tape_file) {
  return fill_template(board_templates::kStepHead,
                       {{"name", name}, {"tape_file", tape_file.string()}});
}

std::string print_step_part(const std::string& name, const StepTape& tape) {
  return fill_template(board_templates::kStep, {{"name", name},
                                                {"steps", std::to_string(tape.results.size())},
                                                {"config_size", std::to_string(tape.config_size)},
                                                {"input_size", std::to_string(tape.input_size)},
                                                {"output_size", std::to_string(tape.output_size)},
                                                {"state_size", std::to_string(tape.state_size)}});
}

void judge_steps(const StepTape& tape, const StepCalls& calls, BoardFunction& step) {
  step.states = static_cast<int>(tape.results.size());
  step.stack_seen = calls.stack_seen;
  step.modes.resize(4);
  step.least = UINT64_MAX;
  for (std::size_t i = 0; i < tape.results.size(); ++i) {
    if (!are_same_steps(tape.results[i], calls.results[i]) && step.bits_differ++ == 0) {
      step.first_bits_differ = static_cast<int>(i);
    }
    if (!tape.counted[i]) continue;
    const std::uint64_t count = calls.instructions[i];
    step.least = std::min(step.least, count);
    step.most = std::max(step.most, count);
    const auto mode = static_cast<std::size_t>(tape.results[i][tape.mode_at]);
    BoardFunction::Mode& of_mode = step.modes[std::min<std::size_t>(mode, 3)];
    of_mode.least = of_mode.steps == 0 ? count : std::min(of_mode.least, count);
    of_mode.most = std::max(of_mode.most, count);
    ++of_mode.steps;
  }
  step.cycles *= static_cast<double>(step.most);
  const auto [least, most] = std::minmax_element(calls.cycles.begin(), calls.cycles.end());
  step.least_cycles = *least;
  step.most_cycles = *most;
}

}  // namespace treeline
