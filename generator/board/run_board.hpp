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
  std::vector<std::uint64_t> cycles;         ///< of a call, by state; 0 where none are counted
  std::vector<std::vector<double>> results;  ///< by state
};

/// Call of NAME_selftest on a board.
struct SelftestCall {
  std::uint64_t stack_seen = 0, instructions = 0, cycles = 0;
  std::uint64_t result = 0;  ///< what it returns
};

/// Everything that a program has printed.
struct BoardRun {
  bool counts_instructions = true;  ///< whether as many were counted as a known loop takes
  std::vector<BoardCalls> functions;
  StepCalls steps;        ///< of a controller, if there is one
  SelftestCall selftest;  ///< if there is one
};

/// What a program for a board calls, and with what.
struct BoardCase {
  std::string name;  ///< of the scene
  Language language = Language::cpp;
  Real real = Real::float64;
  const std::vector<GeneratedFunction>& functions;
  std::vector<State> states;
  const StepTape* tape = nullptr;  ///< of a controller; null: it has none
  std::string step_entry;          ///< source for that
  bool selftest = false;
};

/// Writes the sources of the program, and the states, to `work`. Returns what the program prints to
/// tell it from others. Errors: a file cannot be written.
std::optional<std::string> write_harness(const BoardCase& board_case, const Target& target,
                                         const std::filesystem::path& work,
                                         Diagnostics& diagnostics);

/// Lets the linked program run and reads what it prints. `simulated`: it must count instructions.
/// Errors: it prints not all of it, or what another program does; it stops with a fault or does not
/// end; in a simulator its clock does not count instructions.
std::optional<BoardRun> run_board(const std::filesystem::path& program, const std::string& id,
                                  const BoardCase& board_case, const Tools& tools, bool simulated,
                                  const std::filesystem::path& work, Diagnostics& diagnostics);

}  // namespace treeline
