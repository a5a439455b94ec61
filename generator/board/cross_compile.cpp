#include "board/cross_compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <initializer_list>
#include <sstream>
#include <utility>

#include "compilation/print_step_entry.hpp"
#include "emission/backend.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// Flags for every firmware's compiler. -fno-pie is for compilers that belong to an operating
/// system.
constexpr const char* kFreestanding =
    "-std=c++17 -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics "
    "-fno-asynchronous-unwind-tables -fno-pie";
constexpr const char* kFreestandingC =
    "-std=c99 -ffreestanding -fno-asynchronous-unwind-tables -fno-pie";

void append_words(Command& command, const std::string& words) {
  for (std::string& word : split_words(words)) command.push_back(std::move(word));
}

bool board_succeeded(const CommandOutcome& outcome, const fs::path& file, const char* fault,
                     Diagnostics& diagnostics) {
  if (outcome.started && outcome.exit_code == 0) return true;
  constexpr std::size_t kMost = 1500;
  const bool cut = outcome.output.size() > kMost;
  diagnostics.add(
      {Severity::error, file, 0, "",
       fmt::format("{}\n  {}{}", fault, outcome.output.substr(0, kMost), cut ? "\n  ..." : ""),
       "Look at the flags; when the folder is an old one, generate it again."});
  return false;
}

/// Sources to compile, each with its language and flags.
struct Sources {
  std::vector<fs::path> files;
  std::vector<Language> languages;
  std::vector<std::string> stems, flags;
  void add(const fs::path& folder, const std::string& stem, Language language, std::string with) {
    add(folder / (stem + std::string(backend_of(language).source)), language, std::move(with));
  }
  void add(const fs::path& file, Language language, std::string with) {
    files.push_back(fs::absolute(file));
    languages.push_back(language);
    stems.push_back(file.stem().string());
    flags.push_back(std::move(with));
  }
};

/// Compiler and flags for a language and a target.
std::string compiler_for(Language language, const Target& target, const Tools& tools) {
  const bool c = language == Language::c;
  return fmt::format("{} {} {}", c ? tools.c_compiler : tools.compiler,
                     c ? kFreestandingC : kFreestanding, target.flags);
}

Sources list_sources(const fs::path& folder, const std::vector<GeneratedFunction>& functions,
                     const CompileOptions& options, const BoardOptions& board,
                     const fs::path& work) {
  Sources sources;
  for (const GeneratedFunction& generated : functions) {
    const bool in_header =
        is_composed(generated) && backend_of(options.language).composes_in_headers;
    sources.add(in_header ? work : folder, source_stem(generated), options.language,
                choose_flags(generated, options).flags + " -fstack-usage -fcallgraph-info=su");
  }
  for (const std::string& stem : options.stems) {
    sources.add(folder, stem, options.language,
                options.flags + " -fstack-usage -fcallgraph-info=su");
  }
  for (const char* stem : {kMainStem, kEmptyStem, kStartStem}) {
    sources.add(work, stem, Language::cpp, "-O2");
  }
  const fs::path step = work / (std::string(kStepStem) + ".cpp");
  if (fs::exists(step)) sources.add(step, Language::cpp, "-O2");
  if (!board.port.empty()) {
    sources.add(board.port, board.port.extension() == ".c" ? Language::c : Language::cpp, "-O2");
  }
  return sources;
}

bool is_number(std::string_view word) {
  const bool is_hex = word.starts_with("0x");
  if (is_hex) word.remove_prefix(2);
  return !word.empty() &&
         word.find_first_not_of(is_hex ? "0123456789abcdefABCDEF" : "0123456789") == word.npos;
}

/// Options for the linker about memory: of the target's board, or of one's own.
std::optional<Command> place_memory(const Target& target, const BoardOptions& board,
                                    Diagnostics& diagnostics) {
  if (board.memory.empty()) return split_words(target.board.linker);
  std::vector<std::string> numbers;
  std::istringstream words(board.memory);
  for (std::string word; std::getline(words, word, ',');) numbers.push_back(word);
  if (numbers.size() != 3 || !std::all_of(numbers.begin(), numbers.end(), is_number)) {
    diagnostics.add({Severity::error, "", 0, "--memory",
                     fmt::format("`{}` are not three numbers with commas between", board.memory),
                     "Write where code begins, where data begins and how many bytes it has, such "
                     "as 0x08000000,0x20000000,0x20000."});
    return std::nullopt;
  }
  return Command{"--defsym=code_begin=" + numbers[0], "--defsym=data_begin=" + numbers[1],
                 "--defsym=data_size=" + numbers[2]};
}

}  // namespace

std::optional<BoardObjects> cross_compile(const fs::path& sources,
                                          const std::vector<GeneratedFunction>& functions,
                                          const Target& target, const Tools& tools,
                                          const CompileOptions& options, const BoardOptions& board,
                                          const fs::path& work, Diagnostics& diagnostics) {
  const auto start = std::chrono::steady_clock::now();
  const Sources list = list_sources(sources, functions, options, board, work);
  std::vector<Command> commands;
  for (std::size_t i = 0; i < list.files.size(); ++i) {
    Command command;
    append_words(command, compiler_for(list.languages[i], target, tools) + " " + list.flags[i]);
    command.insert(command.end(), {"-I", fs::absolute(sources), "-I", work, "-c", list.files[i],
                                   "-o", work / (list.stems[i] + ".o")});
    commands.push_back(std::move(command));
  }
  const auto outcomes = run_commands(commands, count_cores(options.jobs), work, options.progress);
  bool all = true;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    all = board_succeeded(outcomes[i], list.files[i], "does not compile", diagnostics) && all;
  }
  if (!all) return std::nullopt;
  BoardObjects objects;
  objects.folder = work;
  objects.language = options.language;
  for (std::size_t i = 0; i < list.stems.size(); ++i) {
    (i < functions.size() + options.stems.size() ? objects.stems : objects.harness)
        .push_back(list.stems[i]);
  }
  const std::string compiler = compiler_for(options.language, target, tools) + " ";
  objects.command = compiler + options.flags;
  for (const GeneratedFunction& generated : functions) {
    objects.flags.push_back(choose_flags(generated, options));
    const FunctionFlags& chosen = objects.flags.back();
    if (chosen.is_long) objects.long_command = compiler + chosen.flags;
    if (chosen.is_small) objects.small_command = compiler + chosen.flags;
  }
  objects.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return objects;
}

std::optional<fs::path> link_program(const BoardObjects& objects, const Target& target,
                                     const Tools& tools, const BoardOptions& board,
                                     Diagnostics& diagnostics) {
  const auto places = place_memory(target, board, diagnostics);
  if (!places) return std::nullopt;
  const fs::path program = objects.folder / "board.elf";
  Command command{tools.compiler};
  append_words(command, target.flags);
  for (const char* word : {"-nostdlib", "-static", "-no-pie", "-Wl,--build-id=none", "-T"}) {
    command.emplace_back(word);
  }
  command.push_back(objects.folder / kLinkerScript);
  for (const std::string& place : *places) command.push_back("-Wl," + place);
  for (const auto* stems : {&objects.harness, &objects.stems}) {
    for (const std::string& stem : *stems) command.push_back(objects.folder / (stem + ".o"));
  }
  command.insert(command.end(), {"-lgcc", "-o", program});
  if (!board_succeeded(run_commands({command}, 1, objects.folder).front(), program, "does not link",
                       diagnostics)) {
    return std::nullopt;
  }
  return program;
}

}  // namespace treeline
