#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "emission/compare_files.hpp"
#include "oracle/bound.hpp"
#include "target/target.hpp"

namespace treeline {

/// Measurements of one function on a target, and the verdict on its results.
struct BoardFunction {
  std::string name;
  bool is_long = false;    ///< compiled with fewer passes, see BoardReport::long_command
  bool is_small = false;   ///< compiled to small code, see BoardReport::small_command
  int text_bytes = 0;      ///< of the function with its sines and cosines
  int constant_bytes = 0;  ///< beside the text; constants within it count as text
  int static_bytes = 0;    ///< of variables, of which there must be none
  /// Bytes of stack by the compiler's figures, along the deepest path of the call graph. Absent if
  /// the compiler gives no bound.
  std::optional<int> stack_bytes;
  /// Bytes of stack that a call was seen to write to, with those of the compiler's library.
  std::uint64_t stack_seen = 0;
  std::vector<std::string> arithmetic;  ///< functions of the compiler's library that it calls
  std::vector<std::string> strays;      ///< any other symbol that it needs: there must be none
  std::uint64_t least = 0, most = 0;    ///< instructions of a call, over all states
  double cycles = 0;                    ///< estimate of the longest call by `Target::cycles`
  /// Cycles that the processor counted in a call, over all states. 0: it counts none.
  std::uint64_t least_cycles = 0, most_cycles = 0;

  /// Instructions of a controller's steps that ended in a mode.
  struct Mode {
    int steps = 0;  ///< that were counted
    std::uint64_t least = 0, most = 0;
  };
  std::vector<Mode> modes = {};  ///< in the order of `core::Mode`; empty: no controller's step

  int returned = 0;  ///< of the self-test: 0, or the number of a function
  int states = 0;
  int bits_differ = 0;  ///< states whose results are not the host's to the bit
  std::optional<int> first_bits_differ;
  int beyond_bound = 0;  ///< with contraction: states whose error exceeds the bound
  double worst = 0;      ///< with contraction: largest error, ulp of the scale

  [[nodiscard]] bool takes_constant_time() const { return least == most; }
  /// Whether the results are right. If the compiler may contract, bits may differ.
  [[nodiscard]] bool passed(bool contracted) const {
    return strays.empty() && static_bytes == 0 && beyond_bound == 0 &&
           (contracted || bits_differ == 0);
  }
};

/// Result of `treeline check --target`.
struct BoardReport {
  std::string name, robot;
  std::string digest;  ///< of the files that the generator makes, see `digest_of_files`
  const Target* target = nullptr;
  bool single_precision = false;
  bool contracted = false;  ///< flags let the compiler fuse products and sums
  int states = 0, first_state = 0;
  std::uint64_t seed = 1;
  std::string compiler;             ///< version
  std::string command;              ///< compiler and flags
  std::string long_command;         ///< for long functions; empty: there is none
  std::string small_command;        ///< for those that `optimize` makes small; empty: there is none
  std::string runner;               ///< QEMU and its options, or what was given in its place
  bool counts_instructions = true;  ///< a simulator does, boards may not
  bool counts_cycles = false;       ///< boards may do, QEMU does not
  double compile_seconds = 0, run_seconds = 0;
  std::string folder;                 ///< that was compiled; empty: code generated now
  std::vector<FileDifference> stale;  ///< how the folder differs from the code generated now
  std::vector<BoardFunction> functions;
  std::vector<std::string> not_run;  ///< functions for several states, which are for large machines

  [[nodiscard]] bool passed() const;
};

/// Prints a table, a line for each fault, and the verdict.
std::string print_text(const BoardReport& report);
std::string print_json(const BoardReport& report);

}  // namespace treeline
