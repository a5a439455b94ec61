#pragma once

#include <span>
#include <string_view>

namespace treeline {

/// Bytes of code by `-Os`, for the choice between straight lines and loops over a table of links:
/// fitted to five functions of PUMA 560, iiwa14 and humanoid24 by g++ 12 with the flags of each
/// target. Straight lines of the arms, where the choice is close, come within 8 % of it, on x86-64
/// within 21 %, since there some are in lanes. Loops of all three robots come within 4 %, where
/// operations are emulated within 12 %.
struct CodeSizes {
  double operation = 0;  ///< of each operation in straight lines
  double start = 0;      ///< of a function of straight lines before: sines and cosines among them
  double loops = 0;      ///< of loops, relative to those in float on a Cortex-M4F
};

/// Time of operations in units of one sum's, for the choice among algorithms. Of generic code,
/// unless a target's are named.
///
/// A division occupies the divider for about four cycles on current cores, in each of which two
/// sums start; an angle costs about as much as its share of a polynomial that four lanes evaluate
/// together. A cycle in which a chain waits is two sums' time, but other operations fill it, see
/// `cost`. Of 308 timed candidates for 62 functions (chains and trees of 7 to 45 joints, ur10e,
/// PUMA, samm, humanoid24; 1 and 8 lanes; g++ 12 -O3 -march=native, Zen 5) the one that is picked
/// takes 1 % longer than the fastest on average, 6 % at most. It took 5 % longer, and up to 47 %,
/// when the chain was added to the operations, and 10 % and 60 % by the number of operations alone.
struct OperationCosts {
  double product = 1;
  double quotient = 8;
  double angle = 12;   ///< sine and cosine of one angle
  double waiting = 2;  ///< of each cycle of the longest chain
  int lanes = 4;       ///< numbers of a register: doubles of AVX2, the widest to be relied on
  const char* source = "fitted to timed code on x86-64";  ///< of these numbers
};

/// Formats of numbers that a processor computes with by instructions. All others are emulated.
enum class FloatUnit { none, single_only, single_and_double };

/// How a program starts and talks to its host on a board.
enum class BoardKind { none, cortex_m, riscv, aarch64 };

/// A board that QEMU imitates.
struct Board {
  BoardKind kind = BoardKind::none;
  const char* simulator = "";  ///< program of QEMU
  const char* machine = "";    ///< options of QEMU that name board and processor
  const char* package = "";    ///< of Debian, holds the program
  const char* linker = "";     ///< options for the linker: emulation, where code and data go
  /// Frequency of the clock that the program reads, MHz. One instruction takes 1 ns there.
  int clock_mhz = 0;
};

/// Cycles of one instruction of each kind, for estimates.
struct CycleCosts {
  double other = 1;       ///< integers, moves, comparisons
  double memory = 1;      ///< loads and stores of one register
  double branch = 1;      ///< calls and jumps
  double arithmetic = 1;  ///< sum, difference or product of floating-point numbers
  double fused = 1;       ///< product and sum in one instruction
  double divide_float = 1, divide_double = 1;  ///< quotients and square roots
  const char* source = "";                     ///< of these numbers
};

/// A processor that code can be generated for.
struct Target {
  const char* name;     ///< as scenes and `--target` write it
  const char* about;    ///< one phrase for readers
  const char* prefix;   ///< of the names of GCC's programs for it; empty: those of this machine
  const char* package;  ///< of Debian, holds that compiler
  const char* flags;    ///< that select the processor
  FloatUnit unit;
  /// Bytes of the vector registers that emitted lanes use (see runtime/core/lanes.hpp); 0: none.
  int vector_bytes = 0;
  /// Whether the emitted CMakeLists.txt leaves it to the compiler to fuse products and sums. Not on
  /// microcontrollers, so that they give the bits of every other machine.
  bool contracts = true;
  Board board = {};
  CycleCosts cycles = {};
  OperationCosts float_costs = {}, double_costs = {};
  CodeSizes float_sizes = {}, double_sizes = {};
};

/// All targets; the first is `generic`, for any processor.
std::span<const Target> all_targets();

/// Returns the target of this name, or null.
const Target* find_target(std::string_view name);

/// Whether the target is a particular processor.
bool is_particular(const Target& target);

/// Returns the number of lanes that suit the target for numbers of so many bytes: 1, 2, 4 or 8.
int choose_lanes(const Target& target, int bytes_of_real);

/// Returns what operations on numbers of so many bytes cost on the target.
const OperationCosts& operation_costs(const Target& target, int bytes_of_real);

/// Returns how large code of numbers of so many bytes becomes on the target.
const CodeSizes& code_sizes(const Target& target, int bytes_of_real);

/// Whether the target computes with numbers of so many bytes by calls of a library.
bool emulates(const Target& target, int bytes_of_real);

}  // namespace treeline
