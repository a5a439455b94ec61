#include "finite/search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compilation/temporary_folder.hpp"
#include "description/read_scene.hpp"
#include "emission/write_files.hpp"
#include "finite/exact_mass_matrix.hpp"
#include "finite/extreme_states.hpp"
#include "generation/generate_code.hpp"
#include "inspect/propose_scene.hpp"
#include "oracle/leave_out_singular.hpp"
#include "oracle/reference.hpp"
#include "timing/load_build.hpp"

namespace treeline::tests {
namespace {

constexpr int kSingularPoses = 8;

/// Memory for a function's arguments and results in its Real, filled again for each call.
template <class T>
class Call {
 public:
  Call(const Program& program, CompiledEntry entry) : program_(program), entry_(entry) {
    for (const Argument& argument : program.arguments) {
      in_.emplace_back(static_cast<std::size_t>(argument.rows * argument.cols));
    }
    for (const Result& result : program.results) out_.emplace_back(result.values.size());
    for (auto& each : in_) in_pointers_.push_back(each.data());
    for (auto& each : out_) out_pointers_.push_back(each.data());
  }

  /// Whether every result at the state is finite.
  bool is_finite_at(const State& state) {
    const auto arguments = arguments_of(program_, state);
    for (std::size_t a = 0; a < in_.size(); ++a) {
      for (std::size_t i = 0; i < in_[a].size(); ++i)
        in_[a][i] = static_cast<T>((*arguments[a])[i]);
    }
    entry_(in_pointers_.data(), out_pointers_.data());
    return std::all_of(out_.begin(), out_.end(), [](const std::vector<T>& entries) {
      return std::all_of(entries.begin(), entries.end(), [](T x) { return std::isfinite(x); });
    });
  }

 private:
  const Program& program_;
  CompiledEntry entry_;
  std::vector<std::vector<T>> in_, out_;
  std::vector<const void*> in_pointers_;
  std::vector<void*> out_pointers_;
};

class Search {
 public:
  Search(const Robot& robot, const Scene& scene, const Generation& generation,
         const std::vector<GeneratedFunction>& functions, const GeneratedLibrary& library,
         const FiniteOptions& options)
      : functions_(functions),
        library_(library),
        options_(options),
        mass_matrix_(robot, scene),
        space_(make_state_space(robot, scene, generation.mechanism, functions_, options.seed)) {}

  template <class T>
  FiniteReport run() {
    const ExtremeStates states(space_, options_.length,
                               find_singular_poses(space_, kSingularPoses));
    std::vector<Call<T>> calls;
    for (std::size_t i = 0; i < functions_.size(); ++i) {
      calls.emplace_back(functions_[i].program, library_.raw_entry(i));
      report_.functions.push_back(source_stem(functions_[i]));
    }
    for (std::int64_t k = 0; k < options_.states; ++k) {
      const State state = states.draw(options_.first + k);
      for (std::size_t i = 0; i < calls.size(); ++i) {
        if (!calls[i].is_finite_at(state)) note(i, state);
      }
    }
    report_.states = options_.states;
    return std::move(report_);
  }

 private:
  void note(std::size_t i, const State& state) {
    if (solve_of(functions_[i].function) != Solve::none && mass_matrix_.is_singular(state.q)) {
      ++report_.without_value;
      return;
    }
    const std::string& name = report_.functions[i];
    const auto same = [&](const NotFinite& each) { return each.function == name; };
    auto found = std::find_if(report_.found.begin(), report_.found.end(), same);
    if (found == report_.found.end()) found = report_.found.insert(found, {name, 0, state});
    ++found->times;
  }

  const std::vector<GeneratedFunction>& functions_;
  const GeneratedLibrary& library_;
  const FiniteOptions& options_;
  ExactMassMatrix mass_matrix_;
  StateSpace space_;
  FiniteReport report_;
};

}  // namespace

std::optional<FiniteReport> search_not_finite(const Robot& robot, const Scene& scene,
                                              const FiniteOptions& options,
                                              Diagnostics& diagnostics) {
  const auto generation =
      generate_code(robot, scene, {"robot.urdf", "", "scene.yaml", ""}, diagnostics);
  const auto work = make_temporary_folder(diagnostics);
  if (!generation || !work) return std::nullopt;
  const auto sources = work->path() / scene.name;
  if (!write_files(sources, generation->files, diagnostics)) return std::nullopt;
  std::vector<GeneratedFunction> functions = all_callable(*generation);
  std::erase_if(functions, [](const GeneratedFunction& each) { return each.batch > 0; });
  CompileOptions compile;
  compile.flags = options.flags;
  const auto build =
      load_build(sources, scene, functions, compile, work->path() / "build", diagnostics);
  if (!build) return std::nullopt;
  Search search(robot, scene, *generation, functions, build->library, options);
  return scene.real == Real::float32 ? search.run<float>() : search.run<double>();
}

std::optional<Scene> proposed_scene(const Robot& robot, Base base, Diagnostics& diagnostics) {
  const SceneProposal proposal = propose_scene(robot, base);
  auto scene =
      parse_scene(print_scene(robot, proposal, "robot.urdf", {}), "scene.yaml", robot, diagnostics);
  if (scene) leave_out_singular(robot, *scene, "", diagnostics);
  return scene;
}

std::string print_inputs(const State& state) {
  std::map<std::string, std::vector<double>> inputs;
  for (const auto& [quantity, entries] : state.others) inputs[symbol_of(quantity)] = entries;
  inputs["q"] = state.q;
  inputs["qd"] = state.qd;
  inputs["qdd"] = state.qdd;
  inputs["tau"] = state.tau;
  inputs["xdd_cmd"] = state.xdd_cmd;
  inputs["f_ext"] = state.f_ext;
  std::string text;
  for (const auto& [name, entries] : inputs) {
    if (!entries.empty()) text += fmt::format("{} = {}; ", name, fmt::join(entries, " "));
  }
  return text;
}

}  // namespace treeline::tests
