#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "board/cross_compile.hpp"
#include "board/step_on_board.hpp"
#include "oracle/draw_state.hpp"

namespace treeline {

/// Calls of one function on a board, at one state after another.
struct BoardCalls {
  std::uint64_t stack_seen = 0;              ///< bytes that the first call wrote to
  std::vector<std::uint64_t> instructions;   ///< of a call, by state
  std::vector<std::vector<double>> results;  ///< by state
};

/// Everything that a program has written.
struct BoardRun {
  std::vector<BoardCalls> functions;
  StepCalls steps;  ///< of a controller, if there is one
};

/// Writes the sources of the program that calls the functions at the states, and the states, to
/// `work`. Returns false and reports an error if that fails.
bool write_harness(const std::vector<GeneratedFunction>& functions,
                   const std::vector<State>& states, const Scene& scene, const Target& target,
                   const StepTape* tape, const std::string& step_entry,
                   const std::filesystem::path& work, Diagnostics& diagnostics);

/// Runs the linked program and reads what it has written. Errors: QEMU fails, the program stops
/// with a fault or does not end, its clock does not count instructions.
std::optional<BoardRun> run_board(const std::filesystem::path& program,
                                  const std::vector<GeneratedFunction>& functions,
                                  std::size_t states, Real real, const StepTape* tape,
                                  const Tools& tools, const std::filesystem::path& work,
                                  Diagnostics& diagnostics);

}  // namespace treeline
