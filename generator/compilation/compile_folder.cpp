#include "compilation/compile_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>
#include <string_view>
#include <utility>

#include "compilation/print_entry.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/backend.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kNoSpace = "No space left on device";  // passed on by every compiler
constexpr const char* kEntryStem = "treeline_check_entry";

Command compile_command(const Command& compiler, Language language, const std::string& flags,
                        const fs::path& include, const fs::path& source, const fs::path& object) {
  Command command = compiler;
  const auto append = [&](std::initializer_list<std::string> words) {
    command.insert(command.end(), words);
  };
  append({std::string(backend_of(language).flag)});
  for (const std::string& flag : split_words(flags)) command.push_back(flag);
  append({"-fPIC", "-fstack-usage", "-I", include, "-c", source, "-o", object});
  return command;
}

/// The language of the entries: a program of the host hands functions to a driver.
Language language_of_entries(Language language) {
  return backend_of(language).is_compiled_by_driver() ? Language::cpp : language;
}

/// What to do about what a compiler said.
std::string_view remedy_for(const std::string& output) {
  constexpr std::pair<std::string_view, std::string_view> kRemedies[] = {
      {kNoSpace, "Free some space there, or set TMPDIR to a folder with more."},
      {"CL/cl.h", "Install the headers of OpenCL (Debian: ocl-icd-opencl-dev)."},
      {"-lOpenCL", "Install the loader of OpenCL (Debian: ocl-icd-opencl-dev)."}};
  for (const auto& [said, remedy] : kRemedies) {
    if (output.find(said) != std::string::npos) return remedy;
  }
  return "Look at the flags; when the folder is an old one, generate it again.";
}

bool succeeded(const CommandOutcome& outcome, const fs::path& file, const std::string& fault,
               Diagnostics& diagnostics) {
  if (outcome.started && outcome.exit_code == 0) return true;
  diagnostics.add({Severity::error, file, 0, "", fault + first_lines(outcome.output),
                   std::string(remedy_for(outcome.output))});
  return false;
}

/// Runs the commands and returns their outcomes in the order of the commands. The largest sources
/// start first, so that none is left at the end for a single core.
std::vector<CommandOutcome> run_largest_first(const std::vector<Command>& commands,
                                              const std::vector<fs::path>& sources,
                                              const CompileOptions& options, const fs::path& work) {
  const auto size_of = [&](std::size_t i) {
    std::error_code none;
    const auto size = fs::file_size(sources[i], none);
    return none ? 0 : size;
  };
  std::vector<std::size_t> order(commands.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size_of(a) > size_of(b); });
  std::vector<Command> sorted;
  for (const std::size_t i : order) sorted.push_back(commands[i]);
  std::vector<CommandOutcome> ran =
      run_commands(sorted, count_cores(options.jobs), work, options.progress);
  std::vector<CommandOutcome> outcomes(commands.size());
  for (std::size_t i = 0; i < order.size(); ++i) outcomes[order[i]] = std::move(ran[i]);
  return outcomes;
}

/// Object files of all functions and of the entries.
struct Objects {
  std::vector<std::string> stems;  ///< functions in their order, then the entries
  std::vector<CommandOutcome> outcomes;
};

std::optional<Objects> compile_objects(const Command& compiler, const fs::path& folder,
                                       const std::vector<GeneratedFunction>& functions,
                                       const CompileOptions& options, const fs::path& work,
                                       Diagnostics& diagnostics) {
  Objects objects;
  std::vector<Command> commands;
  std::vector<fs::path> sources;
  const Language language = language_of_entries(options.language);
  const auto add = [&](const std::string& stem, const fs::path& source, const std::string& flags) {
    objects.stems.push_back(stem);
    sources.push_back(source);
    commands.push_back(compile_command(compiler, language, flags, fs::absolute(folder), source,
                                       work / (stem + ".o")));
  };
  for (const GeneratedFunction& generated : functions) {
    if (backend_of(options.language).is_compiled_by_driver()) break;
    const bool in_header = is_composed(generated) && backend_of(language).composes_in_headers;
    const fs::path& place = in_header ? work : folder;
    const std::string stem = source_stem(generated);
    add(stem, fs::absolute(place / source_name(language, stem)),
        choose_flags(generated, options).flags);
  }
  for (const std::string& stem : options.stems) {
    add(stem, fs::absolute(folder / source_name(language, stem)), options.flags);
  }
  for (const WorkSource& more : options.more) {
    add(more.stem, work / source_name(language, more.stem), options.flags);
  }
  add(kEntryStem, work / source_name(language, kEntryStem), options.flags);
  objects.outcomes = run_largest_first(commands, sources, options, work);
  bool all = true;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    all = succeeded(objects.outcomes[i], sources[i], "does not compile", diagnostics) && all;
  }
  if (!all) return std::nullopt;
  return objects;
}

/// Writes the sources of the entries, which call the functions. A composed function has no source
/// other than its entry.
bool write_entries(const fs::path& folder, const std::string& name,
                   const std::vector<GeneratedFunction>& functions, Language language,
                   const fs::path& work, Diagnostics& diagnostics) {
  const fs::path entry = work / source_name(language_of_entries(language), kEntryStem);
  if (language == Language::c) {
    return write_work_file(entry, print_c_entry(name, functions), diagnostics);
  }
  if (backend_of(language).is_compiled_by_driver()) {
    return write_work_file(entry, print_opencl_entry(fs::absolute(folder), name, functions),
                           diagnostics);
  }
  bool written = write_work_file(entry, print_entry(name, functions), diagnostics);
  for (const GeneratedFunction& generated : functions) {
    if (!is_composed(generated)) continue;
    written = write_work_file(work / (source_stem(generated) + ".cpp"),
                              print_composed_entry(name, generated), diagnostics) &&
              written;
  }
  return written;
}

bool link_library(const Command& compiler, const Objects& objects, const fs::path& work,
                  const CompileOptions& options, Compilation& made, Diagnostics& diagnostics) {
  Command command = compiler;
  for (const std::string& flag : split_words(options.flags)) command.push_back(flag);
  // A library must not export inline definitions from headers: they may be shared in the whole
  // process, and this is not its only library.
  const fs::path exported = work / "exported.map";
  std::ofstream(exported) << "{ global: "
                          << "treeline_check_*; local: *; };\n";
  command.insert(command.end(),
                 {"-shared", "-Wl,--version-script=" + exported.string(), "-o", made.library});
  for (const std::string& stem : objects.stems) command.push_back(work / (stem + ".o"));
  if (backend_of(options.language).is_compiled_by_driver()) command.emplace_back("-lOpenCL");
  return succeeded(run_commands({command}, 1, work).front(), made.library, "does not link",
                   diagnostics);
}

/// Symbols that `nm` lists of each object file; it names the file before its symbols.
std::map<std::string, std::string> list_symbols(const Objects& objects, const fs::path& work) {
  Command command{"nm", "-S", "--defined-only"};
  std::map<std::string, std::string> stem_of;  // of the line before its symbols
  for (const std::string& stem : objects.stems) {
    command.push_back(work / (stem + ".o"));
    stem_of.emplace(command.back() + ":", stem);
  }
  const auto listed = run_commands({command}, 1, work).front();
  std::map<std::string, std::string> symbols;
  if (listed.exit_code != 0) return symbols;
  std::istringstream lines(listed.output);
  std::string line;
  std::string* of_file = &symbols[objects.stems.front()];
  while (std::getline(lines, line)) {
    const auto named = stem_of.find(line);
    if (named != stem_of.end()) of_file = &symbols[named->second];
    *of_file += line + "\n";
  }
  return symbols;
}

void measure_functions(const Objects& objects, const fs::path& work, Compilation& made) {
  const auto symbols = list_symbols(objects, work);
  for (std::size_t i = 0; i < objects.stems.size(); ++i) {
    const std::string& stem = objects.stems[i];
    made.peak_kib = std::max(made.peak_kib, objects.outcomes[i].peak_kib);
    if (stem == kEntryStem) continue;
    CompiledFunction& function = made.functions[stem];
    function.seconds = objects.outcomes[i].seconds;
    if (const auto found = symbols.find(stem); found != symbols.end()) {
      function.code_bytes = add_code_bytes(found->second);
    }
    function.stack_bytes = add_stack_bytes(read_file(work / (stem + ".su")));
  }
}

/// The compilers to try, and the environment variable that names the first; empty: none does.
struct CompilerSearch {
  std::vector<Command> candidates;
  std::string variable;
};

CompilerSearch search_for(const CompileOptions& options) {
  if (!options.compiler.empty()) return {{split_words(options.compiler)}, ""};
  const std::string cxx = environment_value("CXX");
  if (language_of_entries(options.language) == Language::cpp) {
    if (!cxx.empty()) return {{split_words(cxx)}, "$CXX"};
    return {{{"c++"}, {"g++"}}, ""};
  }
  const std::string cc = environment_value("CC");
  if (!cc.empty()) return {{split_words(cc)}, "$CC"};
  const std::string beside = c_compiler_beside(cxx);
  if (!beside.empty()) return {{split_words(beside)}, "the name in $CXX"};
  return {{{"cc"}, {"gcc"}}, ""};
}

/// A compiler that starts, and what it says of its version.
struct FoundCompiler {
  Command command;
  std::string version;

  /// GCC names its publisher, whatever the compiler is called and runs through.
  [[nodiscard]] bool is_gcc() const {
    return version.find("Free Software Foundation") != std::string::npos;
  }
};

std::optional<FoundCompiler> try_compilers(const CompileOptions& options, const fs::path& work,
                                           Diagnostics& diagnostics) {
  const CompilerSearch search = search_for(options);
  CommandOutcome outcome;
  for (const Command& candidate : search.candidates) {
    Command asked = candidate;
    asked.emplace_back("--version");
    outcome = run_commands({asked}, 1, work).front();
    if (outcome.started && outcome.exit_code == 0) return {{candidate, outcome.output}};
  }
  const bool c = options.language == Language::c;
  const std::string why =
      outcome.started ? "it fails when asked for its version" + first_lines(outcome.output)
                      : fmt::format("there is no program {}", search.candidates.back().front());
  diagnostics.add(
      {Severity::error, "", 0, fmt::format("{}", fmt::join(search.candidates.front(), " ")),
       !options.compiler.empty() ? "this compiler cannot be run: " + why
       : !search.variable.empty()
           ? fmt::format("this compiler, which {} names, cannot be run: {}", search.variable, why)
           : fmt::format("no {} compiler was found",
                         backend_of(language_of_entries(options.language)).name),
       fmt::format("Install one (Debian: {}), or name one in the environment variable {}.",
                   c ? "gcc" : "g++", c ? "CC" : "CXX")});
  return std::nullopt;
}

}  // namespace

std::string c_compiler_beside(const std::string& cpp_compiler) {
  for (const auto& [cpp, c] : {std::pair{"clang++", "clang"}, {"g++", "gcc"}, {"c++", "cc"}}) {
    const std::size_t at = cpp_compiler.rfind(cpp);
    if (at == std::string::npos) continue;
    return std::string(cpp_compiler).replace(at, std::string_view(cpp).size(), c);
  }
  return {};
}

std::optional<Command> find_compiler(const CompileOptions& options, const fs::path& work,
                                     Diagnostics& diagnostics) {
  const auto found = try_compilers(options, work, diagnostics);
  return found ? std::optional(found->command) : std::nullopt;
}

std::optional<Compilation> compile_folder(const fs::path& folder, const std::string& name,
                                          const std::vector<GeneratedFunction>& functions,
                                          CompileOptions options, const fs::path& work,
                                          Diagnostics& diagnostics) {
  const auto found = try_compilers(options, work, diagnostics);
  if (!found) return std::nullopt;
  const Command& compiler = found->command;
  if (found->is_gcc()) options.flags = add_extra_passes(options.flags);
  if (!write_entries(folder, name, functions, options.language, work, diagnostics)) {
    return std::nullopt;
  }
  for (const WorkSource& more : options.more) {
    const fs::path file = work / source_name(language_of_entries(options.language), more.stem);
    if (!write_work_file(file, more.text, diagnostics)) return std::nullopt;
  }
  const auto start = Clock::now();
  const auto objects = compile_objects(compiler, folder, functions, options, work, diagnostics);
  if (!objects) return std::nullopt;
  Compilation made;
  made.library = work / "libtreeline_check.so";
  const std::string command = fmt::format("{} {}", fmt::join(compiler, " "),
                                          backend_of(language_of_entries(options.language)).flag);
  made.command = fmt::format(
      "{}{} {}",
      backend_of(options.language).is_compiled_by_driver() ? "an OpenCL driver behind " : "",
      command, options.flags);
  if (!link_library(compiler, *objects, work, options, made, diagnostics)) return std::nullopt;
  made.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  measure_functions(*objects, work, made);
  for (const GeneratedFunction& generated : functions) {
    const FunctionFlags chosen = choose_flags(generated, options);
    CompiledFunction& compiled = made.functions[source_stem(generated)];
    compiled.is_long = chosen.is_long;
    compiled.is_small = chosen.is_small;
    const std::string by = fmt::format("{} {}", command, chosen.flags);
    if (chosen.is_long) made.long_command = by;
    if (chosen.is_small) made.small_command = by;
  }
  return made;
}

std::optional<int> measure_constants(const Compilation& compilation, const std::string& stem) {
  const fs::path work = compilation.library.parent_path();
  const auto sections = run_commands({{"size", "-A", work / (stem + ".o")}}, 1, work).front();
  return sections.exit_code == 0 ? add_constant_bytes(sections.output) : std::nullopt;
}

std::optional<int> add_code_bytes(const std::string& nm_output) {
  std::istringstream lines(nm_output);
  std::string line;
  std::optional<int> bytes;
  while (std::getline(lines, line)) {
    const auto words = split_words(line);  // address, size, type, name
    constexpr std::string_view kText = "tTwW";
    if (words.size() != 4 || words[2].size() != 1 ||
        kText.find(words[2][0]) == std::string_view::npos) {
      continue;
    }
    bytes = bytes.value_or(0) + static_cast<int>(std::strtol(words[1].c_str(), nullptr, 16));
  }
  return bytes;
}

std::optional<int> add_constant_bytes(const std::string& size_output) {
  std::istringstream lines(size_output);
  std::string line;
  std::optional<int> bytes;
  while (std::getline(lines, line)) {
    const auto words = split_words(line);  // section, size, address
    if (words.size() != 3) continue;
    bytes = bytes.value_or(0);
    if (words[0].starts_with(".rodata") || words[0].starts_with(".data.rel.ro")) {
      *bytes += std::atoi(words[1].c_str());
    }
  }
  return bytes;
}

std::optional<int> add_stack_bytes(const std::string& stack_usage) {
  std::istringstream lines(stack_usage);
  std::string line;
  std::optional<int> bytes;
  while (std::getline(lines, line)) {  // place and name, tab, bytes, tab, kind
    const auto tab = line.find('\t');
    if (tab == std::string::npos) continue;
    bytes = bytes.value_or(0) + std::atoi(line.c_str() + tab + 1);
  }
  return bytes;
}

}  // namespace treeline
