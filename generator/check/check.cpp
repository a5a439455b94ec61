#include "check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "check/judges.hpp"
#include "compilation/generated_library.hpp"
#include "compilation/print_entry.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/backend.hpp"
#include "emission/ground_unit.hpp"
#include "emission/print_files.hpp"
#include "emission/write_files.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// GCC's SLP vectorizer makes fused vector operations (vfmsubadd) even if contraction is off.
constexpr const char* kExactFlags = " -ffp-contract=off -fno-tree-slp-vectorize";

/// The code of a folder, compiled with the given flags, and once more without contraction if those
/// flags may contract products and sums.
struct Libraries {
  Compilation compilation;
  std::string exact_command;
  std::optional<GeneratedLibrary> accurate, separate;
  [[nodiscard]] const GeneratedLibrary& exact() const { return separate ? *separate : *accurate; }
};

/// Whether these flags may fuse products and sums. They cannot only if the last flag about
/// contraction turns it off and no flag selects a special machine.
bool contracts(const std::string& flags) {
  const std::vector<std::string> words = split_words(flags);
  return asks_contraction(flags) || std::any_of(words.begin(), words.end(), [](const auto& word) {
           return word.starts_with("-m");
         });
}

std::optional<GeneratedLibrary> compile_and_load(const fs::path& sources, const Scene& scene,
                                                 const Generation& generation,
                                                 const CompileOptions& options,
                                                 const fs::path& work, Compilation& compilation,
                                                 Diagnostics& diagnostics) {
  fs::create_directory(work);
  const std::vector<GeneratedFunction> functions = all_callable(generation);
  auto made = compile_folder(sources, scene.name, functions, options, work, diagnostics);
  if (!made) return std::nullopt;
  compilation = std::move(*made);
  return GeneratedLibrary::load(compilation.library, functions, scene.real, diagnostics);
}

std::optional<Libraries> build_libraries(const fs::path& sources, const Scene& scene,
                                         const Generation& generation, CompileOptions options,
                                         const fs::path& work, Diagnostics& diagnostics) {
  options.language = scene.language;
  options.optimize = scene.optimize;
  Libraries libraries;
  libraries.accurate = compile_and_load(sources, scene, generation, options, work / "accurate",
                                        libraries.compilation, diagnostics);
  if (!libraries.accurate) return std::nullopt;
  libraries.exact_command = libraries.compilation.command;
  if (!contracts(options.flags)) return libraries;
  CompileOptions exact = options;
  exact.flags += kExactFlags;
  if (!exact.long_flags.empty()) exact.long_flags += kExactFlags;
  Compilation compilation;
  libraries.separate =
      compile_and_load(sources, scene, generation, exact, work / "exact", compilation, diagnostics);
  if (!libraries.separate) return std::nullopt;
  libraries.exact_command = compilation.command;
  return libraries;
}

void add_compilation(const Compilation& compilation, FunctionReport& report) {
  const CompiledFunction& compiled = compilation.functions.at(report.name);
  report.code_bytes = compiled.code_bytes;
  report.stack_bytes = compiled.stack_bytes;
  report.compile_seconds = compiled.seconds;
  report.is_long = compiled.is_long;
  report.is_small = compiled.is_small;
}

std::vector<State> collect_named_states(const std::vector<FunctionReport>& functions,
                                        const std::vector<StateReference>& references) {
  std::set<int> named;
  for (const FunctionReport& function : functions) {
    if (function.has_errors()) named.insert({function.worst.state, function.nearest.state});
    if (function.first_bits_differ) named.insert(*function.first_bits_differ);
  }
  std::vector<State> states;
  for (const StateReference& reference : references) {
    if (named.contains(reference.state.index)) states.push_back(reference.state);
  }
  return states;
}

CheckReport begin_report(const Scene& scene, const CheckOptions& options,
                         const Libraries& libraries) {
  CheckReport report;
  report.name = scene.name;
  report.single_precision = scene.real == Real::float32;
  report.states = options.references.states;
  report.first_state = options.references.first;
  report.seed = options.references.seed;
  report.compile_command = libraries.compilation.command;
  report.exact_command = libraries.exact_command;
  report.long_command = libraries.compilation.long_command;
  report.small_command = libraries.compilation.small_command;
  report.compile_seconds = libraries.compilation.seconds;
  report.compile_peak_kib = libraries.compilation.peak_kib;
  report.folder = options.folder.string();
  return report;
}

CheckReport judge(const Scene& scene, const Generation& generation,
                  const std::vector<StateReference>& references, const CheckOptions& options,
                  const Libraries& libraries) {
  CheckReport report = begin_report(scene, options, libraries);
  report.digest = digest_of_files(generation.files);
  if (!options.folder.empty()) report.stale = compare_files(options.folder, generation.files);
  report.domain = describe_domain(generation);
  const std::vector<GeneratedFunction> functions = all_callable(generation);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    report.functions.push_back(judge_function(i, functions[i], references, scene.real,
                                              generation.domain, *libraries.accurate,
                                              libraries.exact()));
    add_compilation(libraries.compilation, report.functions.back());
  }
  report.named_states = collect_named_states(report.functions, references);
  return report;
}

/// The self-test of a folder, and an entry to it that others see.
void add_selftest_sources(const std::string& name, CompileOptions& compile) {
  compile.stems.emplace_back(kSelftestStem);
  const std::string entry = entry_symbol(kSelftestStem);
  compile.more.push_back({entry, fmt::format("#include \"{0}_selftest.h\"\n#ifdef __cplusplus\n"
                                             "extern \"C\"\n#endif\nint {1}(void);\n"
                                             "int {1}(void) {{\n  return {0}_selftest();\n}}\n",
                                             name, entry)});
}

/// The step on the ground is compiled, so that a folder which does not compile does not pass.
void add_ground_sources(const Scene& scene, const Generation& generation, CompileOptions& compile,
                        Diagnostics& diagnostics) {
  if (!scene.ground_step) return;
  compile.stems.emplace_back(kGroundStem);
  for (const Program* const program : generation.context->ground->programs()) {
    compile.stems.push_back(program->name);
  }
  diagnostics.add({Severity::note, scene.file, 0, "ground/step",
                   scene.name + "_ground_step is compiled, and compared with nothing",
                   "`simulate` makes the same steps without code."});
}

}  // namespace

bool CheckReport::passed() const {
  return stale.empty() && (!limits || limits->passed()) &&
         (!batch_limits || batch_limits->passed()) && (!step || step->passed()) &&
         selftest.value_or(0) == 0 &&
         std::all_of(functions.begin(), functions.end(),
                     [](const FunctionReport& function) { return function.passed(); });
}

std::optional<CheckReport> check(const Scene& scene, const Generation& generation,
                                 const std::vector<StateReference>& references,
                                 const CheckOptions& options, Diagnostics& diagnostics) {
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  const auto sources = find_sources(scene, generation, options, work->path(), diagnostics);
  if (!sources) return std::nullopt;
  const auto libraries =
      build_libraries(*sources, scene, generation, options.compile, work->path(), diagnostics);
  if (!libraries) return std::nullopt;
  return judge(scene, generation, references, options, *libraries);
}

std::optional<CheckReport> check(const Robot& robot, const Scene& scene,
                                 const Generation& generation, const CheckOptions& options,
                                 Diagnostics& diagnostics) {
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  const auto sources = find_sources(scene, generation, options, work->path(), diagnostics);
  if (!sources) return std::nullopt;
  CompileOptions compile = options.compile;
  compile.more = limited_sources(scene, generation);
  compile = with_controller(scene, generation, std::move(compile));
  if (scene.selftest > 0) add_selftest_sources(scene.name, compile);
  add_ground_sources(scene, generation, compile, diagnostics);
  const auto libraries =
      build_libraries(*sources, scene, generation, compile, work->path(), diagnostics);
  if (!libraries) return std::nullopt;
  const auto start = std::chrono::steady_clock::now();
  const auto references = make_references(robot, scene, generation, options.references);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  CheckReport report = judge(scene, generation, references, options, *libraries);
  judge_equations(robot, scene, generation, references, options.references.threads, report);
  if (scene.has_limits()) {
    const auto judge_one = [&](bool batch) {
      LimitsReport limits = judge_limits(robot, scene, generation, references, *libraries->accurate,
                                         batch, options.references.threads);
      limits.compiled = libraries->compilation.functions.at(limits.name);
      return limits;
    };
    report.limits = judge_one(false);
    if (!generation.batch.empty()) report.batch_limits = judge_one(true);
  }
  if (generation.controller) {
    report.step = judge_step(robot, scene, generation, options, libraries->compilation,
                             work->path(), diagnostics);
    if (!report.step) return std::nullopt;
  }
  if (scene.selftest > 0) report.selftest = libraries->exact().run_selftest();
  report.robot = robot.name;
  report.reference_seconds = taken.count();
  return report;
}

}  // namespace treeline
