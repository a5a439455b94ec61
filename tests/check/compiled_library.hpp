#pragma once

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "check/judges.hpp"
#include "compilation/generated_library.hpp"
#include "compilation/print_entry.hpp"
#include "fixture.hpp"
#include "generation/describe_limits.hpp"
#include "oracle/reference.hpp"

namespace treeline::tests {

/// The code of a scene with limits, compiled in a folder of its own and loaded.
class CompiledLibrary {
 public:
  explicit CompiledLibrary(const Subjects& subjects) : subjects_(subjects) {
    Diagnostics diagnostics;
    const auto code = temporary_.path() / "code", work = temporary_.path() / "work";
    write_folder(code, subjects.generation);
    std::filesystem::create_directory(work);
    CompileOptions options = quick_options().compile;
    options.more = limited_sources(subjects.scene, subjects.generation);
    const auto functions = all_callable(subjects.generation);
    const auto made =
        compile_folder(code, subjects.scene.name, functions, options, work, diagnostics);
    if (made) {
      library_ = GeneratedLibrary::load(made->library, functions, subjects.scene.real, diagnostics);
    }
    if (!library_) throw std::runtime_error(to_string(diagnostics.list().front()));
  }

  [[nodiscard]] const GeneratedLibrary& get() const { return *library_; }

  [[nodiscard]] StateSpace states() const {
    return make_state_space(subjects_.robot, subjects_.scene, subjects_.generation.mechanism,
                            all_callable(subjects_.generation), 1);
  }

  /// Results of the unlimited law, of one state or of a batch.
  [[nodiscard]] std::vector<double> supported(const State& state, bool batch = false) const {
    return library_->call(find_supported(batch), state).entries;
  }
  /// tau, f, lost, (limited, status, slack) and sides of limited_control_torque.
  [[nodiscard]] std::vector<double> limited(const State& state, bool batch = false) const {
    const LimitFacts facts =
        describe_limits(subjects_.robot, subjects_.scene, subjects_.generation.mechanism,
                        subjects_.generation.functions);
    const std::size_t nv = facts.torque.size();
    const std::size_t sides = nv - facts.passive.size() + facts.cones.size() + 1;
    return library_
        ->call_entry(library_->find_entry(limited_stem(batch)), find_supported(batch), state,
                     {nv, facts.force_weights.size(), facts.task_weights.size(), 3, sides})
        .entries;
  }

 private:
  [[nodiscard]] std::size_t find_supported(bool batch) const {
    const auto functions = all_callable(subjects_.generation);
    std::size_t i = 0;
    while (functions[i].function != Function::supported_control_torque ||
           (functions[i].batch > 0) != batch) {
      ++i;
    }
    return i;
  }

  const Subjects& subjects_;
  TemporaryFolder temporary_;
  std::optional<GeneratedLibrary> library_;
};

}  // namespace treeline::tests
