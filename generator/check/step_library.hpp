#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// Numbers of a controller's struct, a member behind the other. Whole numbers, floats and doubles
/// are exact in it.
using StepNumbers = std::vector<long double>;

/// Result of a step.
struct StepResult {
  StepNumbers state, output;
};

/// Structs that a step takes.
enum class StepPart { config, state, input, output };
inline constexpr std::array kStepParts = {StepPart::config, StepPart::state, StepPart::input,
                                          StepPart::output};

/// A member of a struct and its place among the numbers. Those of a command within the input are
/// called `command.kind` and so on.
struct StepMember {
  std::string name;
  std::size_t at = 0, count = 1;
  bool is_whole = false;  ///< an integer
};

/// A compiled controller, emitted or a reference, with the entries of `print_step_entry`.
class StepLibrary {
 public:
  /// Computes function `index` of `ControllerUnit::programs` for a reference.
  using Compute = void (*)(void* with, int index, const long double* const* in,
                           long double* const* out);

  /// Errors: the library cannot be loaded, or has no such entries.
  static std::optional<StepLibrary> load(const std::filesystem::path& path,
                                         Diagnostics& diagnostics);

  [[nodiscard]] const std::vector<StepMember>& members(StepPart part) const {
    return members_[static_cast<std::size_t>(part)];
  }
  /// The member of that name; null if there is none.
  [[nodiscard]] const StepMember* find(StepPart part, const std::string& name) const;
  /// Zeros for all members.
  [[nodiscard]] StepNumbers zeros(StepPart part) const;
  [[nodiscard]] StepNumbers default_config() const;
  /// One step, which changes the state and writes the output.
  void step(const StepNumbers& config, StepNumbers& state, const StepNumbers& input,
            StepNumbers& output) const;
  /// Tells a reference who computes its dynamics.
  void connect(Compute compute, void* with) const;

 private:
  struct Closer {
    void operator()(void* handle) const;
  };
  /// Functions of `print_step_entry`.
  struct Entries {
    int (*list)(int part, const char** names, int* counts);
    void (*write_defaults)(long double* config);
    void (*step)(const long double* config, long double* state, const long double* input,
                 long double* output);
    void (*connect)(Compute compute, void* with);  ///< null in emitted code
  };
  std::unique_ptr<void, Closer> handle_;
  Entries entries_{};
  std::array<std::vector<StepMember>, kStepParts.size()> members_;
};

}  // namespace treeline
