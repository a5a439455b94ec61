#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generation/generate_code.hpp"
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

/// A step, seen from outside.
struct SeenStep {
  const StepLibrary& library;
  const StepNumbers& config;  ///< that is sound
  const StepNumbers& before;  ///< the state that the step was given
  const StepNumbers& input;
  const StepNumbers& output;
  bool reset = false;  ///< whether a reset was commanded
  double unit = 0;     ///< ulp of one

  /// Number `i` of a member of that name.
  [[nodiscard]] long double number(StepPart part, const char* member, std::size_t i = 0) const;
  [[nodiscard]] std::uint32_t bits(StepPart part, const char* member) const;
};

/// Rule that the step breaks and no law may break; empty if none.
std::string find_broken_rule(const SeenStep& seen);

/// Compiles the controller among a folder's sources for this machine without contraction, in
/// `work`, and loads it. `jobs`: cores, 0 for all. Errors: it does not compile.
std::optional<StepLibrary> compile_step(const Scene& scene, const Generation& generation, int jobs,
                                        const std::filesystem::path& sources,
                                        const std::filesystem::path& work,
                                        Diagnostics& diagnostics);

}  // namespace treeline
