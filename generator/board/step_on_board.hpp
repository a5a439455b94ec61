#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "board/board_report.hpp"
#include "board/cross_compile.hpp"
#include "check/check.hpp"
#include "check/step_library.hpp"

namespace treeline {

/// Steps of a controller on the host: what each was given and left.
struct StepTape {
  std::string bytes;  ///< for the board: numbers in double
  std::size_t config_size = 0, input_size = 0, output_size = 0, state_size = 0;
  std::size_t mode_at = 0;           ///< of the output
  std::vector<StepNumbers> results;  ///< output, then state, of each step
  std::vector<bool> counted;         ///< steps whose instructions are counted
};

/// Results and measurements of the steps on the board.
struct StepCalls {
  std::uint64_t stack_seen = 0;
  std::vector<std::uint64_t> instructions;   ///< 0 where they are not counted
  std::vector<std::uint64_t> cycles;         ///< of all steps; 0 where none are counted
  std::vector<std::vector<double>> results;  ///< as those of the tape
};

/// Compiles the controller for the host without contraction, and runs it over motions as `check`
/// does. Errors: it does not compile.
std::optional<StepTape> record_steps(const Robot& robot, const Scene& scene,
                                     const Generation& generation, const CheckOptions& options,
                                     const std::filesystem::path& sources,
                                     const std::filesystem::path& work, Diagnostics& diagnostics);

/// Parts of the board's program for the steps of a tape: before its namespace, and in it.
std::string print_step_head(const std::string& name, const std::filesystem::path& tape_file);
std::string print_step_part(const std::string& name, const StepTape& tape);

/// Compares the board's steps with the host's to the bit, and finds the instructions by mode.
void judge_steps(const StepTape& tape, const StepCalls& calls, BoardFunction& step);

}  // namespace treeline
