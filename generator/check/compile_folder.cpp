#include "check/compile_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>
#include <string_view>
#include <utility>

#include "check/print_entry.hpp"
#include "check/run_commands.hpp"
#include "emission/print_source.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kNoSpace = "No space left on device";  // passed on by every compiler
constexpr const char* kEntryStem = "treeline_check_entry";

Command compile_command(const Command& compiler, const std::string& flags, const fs::path& include,
                        const fs::path& source, const fs::path& object) {
  Command command = compiler;
  const auto append = [&](std::initializer_list<std::string> words) {
    command.insert(command.end(), words);
  };
  append({"-std=c++17"});
  for (const std::string& flag : split_words(flags)) command.push_back(flag);
  append({"-fPIC", "-fstack-usage", "-I", include, "-c", source, "-o", object});
  return command;
}

std::string first_lines(const std::string& text) {
  constexpr int kLines = 12;
  std::istringstream stream(text);
  std::string lines;
  std::string line;
  for (int i = 0; i < kLines && std::getline(stream, line); ++i) lines += "\n  " + line;
  return lines + (std::getline(stream, line) ? "\n  ..." : "");
}

bool succeeded(const CommandOutcome& outcome, const fs::path& file, const std::string& fault,
               Diagnostics& diagnostics) {
  if (outcome.started && outcome.exit_code == 0) return true;
  diagnostics.add({Severity::error, file, 0, "", fault + first_lines(outcome.output),
                   outcome.output.find(kNoSpace) != std::string::npos
                       ? "Free some space there, or set TMPDIR to a folder with more."
                       : "Look at the flags; when the folder is an old one, generate it again."});
  return false;
}

bool has_long_flags(const GeneratedFunction& generated, const CompileOptions& options) {
  return !options.long_flags.empty() && is_long(generated.program);
}

const std::string& flags_of(const GeneratedFunction& generated, const CompileOptions& options) {
  return has_long_flags(generated, options) ? options.long_flags : options.flags;
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
  const auto add = [&](const std::string& stem, const fs::path& source, const std::string& flags) {
    objects.stems.push_back(stem);
    sources.push_back(source);
    commands.push_back(
        compile_command(compiler, flags, fs::absolute(folder), source, work / (stem + ".o")));
  };
  for (const GeneratedFunction& generated : functions) {
    const fs::path& place = is_composed(generated) ? work : folder;
    add(source_stem(generated), fs::absolute(place / (source_stem(generated) + ".cpp")),
        flags_of(generated, options));
  }
  add(kEntryStem, work / (std::string(kEntryStem) + ".cpp"), options.flags);
  objects.outcomes = run_largest_first(commands, sources, options, work);
  bool all = true;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    all = succeeded(objects.outcomes[i], sources[i], "does not compile", diagnostics) && all;
  }
  if (!all) return std::nullopt;
  return objects;
}

bool write_source(const fs::path& path, const std::string& text, Diagnostics& diagnostics) {
  std::ofstream stream(path);
  stream << text;
  stream.close();
  if (stream) return true;
  diagnostics.add({Severity::error, path, 0, "", "cannot be written to its end",
                   "free some space there, or set TMPDIR to a folder with more"});
  return false;
}

/// Writes the sources of the entries, which call the functions. A composed function has no source
/// other than its entry.
bool write_entries(const std::string& name, const std::vector<GeneratedFunction>& functions,
                   const fs::path& work, Diagnostics& diagnostics) {
  bool written = write_source(work / (std::string(kEntryStem) + ".cpp"),
                              print_entry(name, functions), diagnostics);
  for (const GeneratedFunction& generated : functions) {
    if (!is_composed(generated)) continue;
    written = write_source(work / (source_stem(generated) + ".cpp"),
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
  return succeeded(run_commands({command}, 1, work).front(), made.library, "does not link",
                   diagnostics);
}

void measure_functions(const Objects& objects, const fs::path& work, Compilation& made) {
  std::vector<Command> commands;
  for (const std::string& stem : objects.stems) {
    commands.push_back({"nm", "-S", "--defined-only", work / (stem + ".o")});
  }
  const auto sizes = run_commands(commands, 1, work);
  for (std::size_t i = 0; i < objects.stems.size(); ++i) {
    const std::string& stem = objects.stems[i];
    made.peak_kib = std::max(made.peak_kib, objects.outcomes[i].peak_kib);
    if (stem == kEntryStem) continue;
    CompiledFunction& function = made.functions[stem];
    function.seconds = objects.outcomes[i].seconds;
    if (sizes[i].exit_code == 0) function.code_bytes = add_code_bytes(sizes[i].output);
    function.stack_bytes = add_stack_bytes(read_file(work / (stem + ".su")));
  }
}

}  // namespace

std::optional<Command> find_compiler(const std::string& asked_for, const fs::path& work,
                                     Diagnostics& diagnostics) {
  const char* const chosen = std::getenv("CXX");
  std::vector<Command> candidates = {{"c++"}, {"g++"}};
  if (!asked_for.empty()) {
    candidates = {split_words(asked_for)};
  } else if (chosen != nullptr && !split_words(chosen).empty()) {
    candidates = {split_words(chosen)};
  }
  CommandOutcome outcome;
  for (const Command& candidate : candidates) {
    Command asked = candidate;
    asked.emplace_back("--version");
    outcome = run_commands({asked}, 1, work).front();
    if (outcome.started && outcome.exit_code == 0) return candidate;
  }
  const std::string why = outcome.started
                              ? "it fails when asked for its version" + first_lines(outcome.output)
                              : fmt::format("there is no program {}", candidates.back().front());
  diagnostics.add({Severity::error, "", 0, fmt::format("{}", fmt::join(candidates.front(), " ")),
                   !asked_for.empty()  ? "this compiler cannot be run: " + why
                   : chosen != nullptr ? "this compiler, which $CXX names, cannot be run: " + why
                                       : "no C++ compiler was found",
                   "Install one (Debian: g++), or name one in the environment variable CXX."});
  return std::nullopt;
}

std::optional<Compilation> compile_folder(const fs::path& folder, const std::string& name,
                                          const std::vector<GeneratedFunction>& functions,
                                          const CompileOptions& options, const fs::path& work,
                                          Diagnostics& diagnostics) {
  const auto compiler = find_compiler(options.compiler, work, diagnostics);
  if (!compiler) return std::nullopt;
  if (!write_entries(name, functions, work, diagnostics)) return std::nullopt;
  const auto start = Clock::now();
  const auto objects = compile_objects(*compiler, folder, functions, options, work, diagnostics);
  if (!objects) return std::nullopt;
  Compilation made;
  made.library = work / "libtreeline_check.so";
  made.command = fmt::format("{} -std=c++17 {}", fmt::join(*compiler, " "), options.flags);
  if (!link_library(*compiler, *objects, work, options, made, diagnostics)) return std::nullopt;
  made.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  measure_functions(*objects, work, made);
  for (const GeneratedFunction& generated : functions) {
    if (!has_long_flags(generated, options)) continue;
    made.functions[source_stem(generated)].is_long = true;
    made.long_command =
        fmt::format("{} -std=c++17 {}", fmt::join(*compiler, " "), options.long_flags);
  }
  return made;
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
