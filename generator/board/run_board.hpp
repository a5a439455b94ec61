#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "board/board_report.hpp"
#include "board/cross_compile.hpp"
#include "check/check.hpp"
#include "check/step_library.hpp"
#include "generation/generate_code.hpp"
#include "oracle/draw_state.hpp"
#include "target/target.hpp"

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

/// Bytes that a program on a board has printed, as main.cpp.in tells, or why they are not all
/// there.
struct PrintedBytes {
  std::string bytes;
  std::string fault;  ///< empty: none
};

/// Reads them out of all that was printed; lines of others are passed over. `id` is the program's.
PrintedBytes read_printed(std::string_view text, std::string_view id);

/// Checksum of bytes, as the program computes it: FNV-1a.
std::uint32_t sum_bytes(std::string_view bytes);

/// Place of one argument among the numbers of a state.
struct StatePlace {
  std::string name;
  int size = 0;
  int at = 0;
};

/// Arguments that the functions take, each once, one behind another.
std::vector<StatePlace> place_arguments(const std::vector<GeneratedFunction>& functions);

/// What the program has beside the functions.
struct HarnessFiles {
  std::string states;                          ///< file with them
  std::string id;                              ///< by which its output is told from that of others
  int count = 0;                               ///< of states
  bool selftest = false;                       ///< whether it calls NAME_selftest
  std::string step_head = {}, step_part = {};  ///< of a controller's steps; empty: it has none
};

/// Header that declares the functions to call, and their namesakes that do nothing.
std::string print_functions_header(const std::string& name,
                                   const std::vector<GeneratedFunction>& functions);
/// Header in C that declares the functions to call, and their namesakes that do nothing.
std::string print_c_functions_header(const std::string& name,
                                     const std::vector<GeneratedFunction>& functions, Real real);
/// Source of the functions that do nothing.
std::string print_empty_functions(const std::vector<GeneratedFunction>& functions);
/// Source of a function that is composed of others in a header.
std::string print_composed_function(const std::string& name, const GeneratedFunction& generated);
/// Source of the program.
std::string print_main(const std::string& name, const std::vector<GeneratedFunction>& functions,
                       const HarnessFiles& files);
/// Source of what starts it on the target's board.
std::string print_start(const Board& board);

/// Number of numbers that a function writes.
int count_outputs(const GeneratedFunction& generated);

}  // namespace treeline
