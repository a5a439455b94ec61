#include <fmt/format.h>
#include <sys/mman.h>

#include <cmath>
#include <utility>

#include "bench/contender.hpp"
#include "emission/write_files.hpp"
#include "timing/call_arguments.hpp"
#include "timing/load_build.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

struct Loaded {
  TimedBuild build;
  std::vector<GeneratedLibrary> elsewhere;  ///< the same library at other addresses
  std::vector<CallArguments> arguments;     ///< by function
};

/// Moves the addresses at which the next library is loaded by some pages, which stay unused.
void skip_pages(std::size_t pages) {
  constexpr std::size_t kPage = 4096;
  (void)mmap(nullptr, pages * kPage, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}

/// Loads the library again, from a copy, since the loader knows a file by its name.
bool load_elsewhere(const VariantBuild& build, int place, Loaded& loaded,
                    Diagnostics& diagnostics) {
  const fs::path& original = loaded.build.compilation.library;
  const fs::path copy = original.parent_path() / fmt::format("place_{}.so", place);
  std::error_code failed;
  fs::copy_file(original, copy, fs::copy_options::overwrite_existing, failed);
  skip_pages(static_cast<std::size_t>(7 * place + 1));
  auto library = GeneratedLibrary::load(copy, build.functions, build.scene.real, diagnostics);
  if (!library) return false;
  loaded.elsewhere.push_back(std::move(*library));
  return true;
}

/// One pass over the states, of which a call takes `states`.
TimedPass pass_of(const std::shared_ptr<const Loaded>& loaded, CompiledEntry entry, std::size_t i,
                  int states) {
  const auto pass = [loaded, entry, i] {
    const CallArguments& arguments = loaded->arguments[i];
    for (std::size_t call = 0; call < arguments.calls(); ++call) {
      entry(arguments.in(call), arguments.out());
    }
  };
  return {pass, loaded->arguments[i].calls() * static_cast<std::size_t>(states)};
}

Contender contender_of(const std::shared_ptr<const Loaded>& loaded,
                       const GeneratedFunction& function, const Variant& variant, std::size_t i) {
  Contender contender{variant, {}, {}};
  contender.call = [loaded, i](const State& state) {
    return loaded->build.library.call(i, with_double_sines(state)).entries;
  };
  contender.passes.push_back(
      pass_of(loaded, loaded->build.library.raw_entry(i), i, variant.states));
  for (const GeneratedLibrary& library : loaded->elsewhere) {
    contender.passes.push_back(pass_of(loaded, library.raw_entry(i), i, variant.states));
  }
  const auto& compiled = loaded->build.compilation.functions;
  const auto at = compiled.find(source_stem(function));
  if (at != compiled.end()) contender.compiled = at->second;
  return contender;
}

}  // namespace

std::optional<std::vector<Contender>> compile_contenders(const VariantBuild& build,
                                                         const std::vector<State>& timed,
                                                         const std::filesystem::path& work,
                                                         int places, std::string* command,
                                                         Diagnostics& diagnostics) {
  const std::filesystem::path sources = work / "sources";
  if (!write_files(sources, build.files, diagnostics)) return std::nullopt;
  auto made = load_build(sources, build.scene, build.functions, {build.flags}, work / "objects",
                         diagnostics);
  if (!made) return std::nullopt;
  if (command != nullptr) *command = made->compilation.command;
  auto loaded = std::make_shared<Loaded>(Loaded{std::move(*made), {}, {}});
  for (int place = 1; place < places; ++place) {
    if (!load_elsewhere(build, place, *loaded, diagnostics)) return std::nullopt;
  }
  std::vector<State> states;
  for (const State& state : timed) states.push_back(with_double_sines(state));
  for (const GeneratedFunction& function : build.functions) {
    loaded->arguments.emplace_back(function, states, build.scene.real);
  }
  std::vector<Contender> contenders;
  for (std::size_t i = 0; i < build.variants.size(); ++i) {
    contenders.push_back(contender_of(loaded, build.functions[i], build.variants[i], i));
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
