#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "generation/generate_code.hpp"
#include "oracle/draw_state.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Result of one call of a compiled function.
struct CallResult {
  std::vector<double> entries;  ///< of all outputs, one after the other
  bool wrote_out_of_bounds = false;
};

/// A compiled function that takes pointers to its arguments and to its results, arrays of its Real.
using CompiledEntry = void (*)(const void* const* in, void* const* out);

/// Generated code that is compiled and loaded into this process.
class GeneratedLibrary {
 public:
  /// Loads the library that `compile_folder` has made. Errors: those of the loader; Real has
  /// another size than `real`.
  static std::optional<GeneratedLibrary> load(const std::filesystem::path& path,
                                              const std::vector<GeneratedFunction>& functions,
                                              Real real, Diagnostics& diagnostics);

  /// Calls function `i` at a state. Inputs and outputs lie between NaN, and outputs are NaN before
  /// the call. So an entry that is not written, or is computed from beyond an input, is NaN.
  [[nodiscard]] CallResult call(std::size_t i, const State& state) const;

  /// Function `i` on arrays in its own layout, [size][kStates] for a batch. Valid as long as this
  /// object lives.
  [[nodiscard]] CompiledEntry raw_entry(std::size_t i) const { return functions_[i].raw; }

  /// Calls an entry that is no function's, such as that of limited torques, with the arguments of
  /// function `i` and results of these sizes.
  [[nodiscard]] CallResult call_entry(CompiledEntry entry, std::size_t i, const State& state,
                                      const std::vector<std::size_t>& sizes) const;
  /// The entry of a name; null if there is none.
  [[nodiscard]] CompiledEntry find_entry(const std::string& name) const;
  /// What NAME_selftest returns; -1 if there is none.
  [[nodiscard]] int run_selftest() const;

 private:
  struct LoadedFunction {
    Program program;
    CompiledEntry entry;  ///< takes one state
    CompiledEntry raw;    ///< takes all states of a batch; the same as `entry` for a plain function
  };
  struct Closer {
    void operator()(void* handle) const;
  };

  template <class T>
  [[nodiscard]] CallResult call_in(CompiledEntry entry, const Program& program, const State& state,
                                   const std::vector<std::size_t>& sizes) const;

  std::unique_ptr<void, Closer> handle_;
  std::vector<LoadedFunction> functions_;
  Real real_ = Real::float64;
};

}  // namespace treeline
