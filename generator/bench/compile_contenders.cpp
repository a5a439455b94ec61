#include <cmath>
#include <utility>

#include "bench/contender.hpp"
#include "emission/write_files.hpp"
#include "timing/call_arguments.hpp"
#include "timing/load_build.hpp"

namespace treeline {
namespace {

struct Loaded {
  TimedBuild build;
  std::vector<CallArguments> arguments;  ///< by function
};

Contender contender_of(const std::shared_ptr<const Loaded>& loaded, const Variant& variant,
                       std::size_t i) {
  Contender contender{variant, {}, {}};
  contender.call = [loaded, i](const State& state) {
    return loaded->build.library.call(i, with_double_sines(state)).entries;
  };
  const CompiledEntry entry = loaded->build.library.raw_entry(i);
  contender.pass.calls = loaded->arguments[i].calls();
  contender.pass.pass = [loaded, entry, i] {
    const CallArguments& arguments = loaded->arguments[i];
    for (std::size_t call = 0; call < arguments.calls(); ++call) {
      entry(arguments.in(call), arguments.out());
    }
  };
  return contender;
}

}  // namespace

std::optional<std::vector<Contender>> compile_contenders(const VariantBuild& build,
                                                         const std::vector<State>& timed,
                                                         const std::filesystem::path& work,
                                                         std::string* command,
                                                         Diagnostics& diagnostics) {
  const std::filesystem::path sources = work / "sources";
  if (!write_files(sources, build.files, diagnostics)) return std::nullopt;
  auto made = load_build(sources, build.scene, build.functions, {build.flags}, work / "objects",
                         diagnostics);
  if (!made) return std::nullopt;
  if (command != nullptr) *command = made->compilation.command;
  auto loaded = std::make_shared<Loaded>(Loaded{std::move(*made), {}});
  std::vector<State> states;
  for (const State& state : timed) states.push_back(with_double_sines(state));
  for (const GeneratedFunction& function : build.functions) {
    loaded->arguments.emplace_back(function, states, build.scene.real);
  }
  std::vector<Contender> contenders;
  for (std::size_t i = 0; i < build.variants.size(); ++i) {
    contenders.push_back(contender_of(loaded, build.variants[i], i));
  }
  return contenders;
}

State with_double_sines(State state) {
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    state.sin_q[i] = std::sin(state.q[i]);
    state.cos_q[i] = std::cos(state.q[i]);
  }
  return state;
}

}  // namespace treeline
