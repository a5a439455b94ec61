#include "run_on_boards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "board/cross_compile.hpp"
#include "board/run_board.hpp"
#include "board/templates.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDialect = "-std=c++17 -O2 -ffp-contract=off -Wall -Wextra";
constexpr const char* kFreestanding =
    "-ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics "
    "-fno-asynchronous-unwind-tables -fno-pie";

void append_words(Command& command, const std::string& words) {
  for (std::string& word : split_words(words)) command.push_back(std::move(word));
}

std::vector<fs::path> list_sources(const FirmwareSources& sources) {
  std::vector<fs::path> files = {sources.own / "firmware.cpp"};
  for (const char* stem : {"controller", "controller_kinematics", "controller_joint_torque",
                           "controller_task_torque", "forward_kinematics", "forward_dynamics"}) {
    files.push_back(sources.generated / (std::string(stem) + ".cpp"));
  }
  return files;
}

/// Options that every source takes; results go to `work`.
Command make_command(const std::string& compiler, const FirmwareSources& sources,
                     const fs::path& work) {
  Command command{compiler};
  append_words(command, kDialect);
  command.push_back(fmt::format("-DSTATES_FILE=\"{}\"", (work / "states.bin").string()));
  command.push_back(fmt::format("-DCOUNTS_FILE=\"{}\"", (work / "counts.bin").string()));
  for (const fs::path& folder : {sources.generated, sources.runtime, sources.own, work}) {
    command.push_back("-I" + folder.string());
  }
  return command;
}

bool succeeded(const CommandOutcome& outcome, const std::string& what, Diagnostics& diagnostics) {
  if (outcome.started && outcome.exit_code == 0) return true;
  diagnostics.add({Severity::error, "", 0, what, "it fails:\n" + outcome.output,
                   "Look at the compiler and at QEMU; .ci/packages names what they need."});
  return false;
}

std::optional<FirmwareRun> read_run(const fs::path& work, Diagnostics& diagnostics) {
  FirmwareRun run;
  run.states = read_file(work / "states.bin");
  const std::string counts = read_file(work / "counts.bin");
  constexpr std::size_t kWords = kTicks + 1;
  if (run.states.size() != kTicks * sizeof(Record) || counts.size() != 4 * kWords) {
    diagnostics.add({Severity::error, "", 0, "firmware", "it has streamed less than it should",
                     "Run it by itself in QEMU."});
    return std::nullopt;
  }
  std::vector<std::uint32_t> words(kWords);
  std::memcpy(words.data(), counts.data(), counts.size());
  run.servo_bytes = words.front();
  run.least = 0xfffff;
  for (std::size_t i = 1; i < words.size(); ++i) {
    run.least = std::min(run.least, words[i] & 0xfffff);
    run.most = std::max(run.most, words[i] & 0xfffff);
    run.stack = std::max(run.stack, words[i] >> 20);
  }
  return run;
}

bool write_board(const Target& target, const fs::path& work, Diagnostics& diagnostics) {
  return write_work_file(work / "board.hpp", std::string(board_templates::kBoard), diagnostics) &&
         write_work_file(work / kLinkerScript, std::string(board_templates::kLinkerScript),
                         diagnostics) &&
         write_work_file(work / (std::string(kStartStem) + ".cpp"), print_start(target.board),
                         diagnostics);
}

/// The objects of the firmware in `work`.
std::optional<BoardObjects> compile(const Target& target, const Tools& tools,
                                    const FirmwareSources& sources, const fs::path& work,
                                    Diagnostics& diagnostics) {
  std::vector<fs::path> files = list_sources(sources);
  files.push_back(work / (std::string(kStartStem) + ".cpp"));
  BoardObjects objects;
  objects.folder = work;
  std::vector<Command> commands;
  for (const fs::path& file : files) {
    Command command = make_command(tools.compiler, sources, work);
    append_words(command, fmt::format("{} {}", kFreestanding, target.flags));
    const std::string stem = file.stem().string();
    command.insert(command.end(), {"-c", file.string(), "-o", (work / (stem + ".o")).string()});
    commands.push_back(std::move(command));
    objects.harness.push_back(stem);
  }
  bool all = true;
  const auto outcomes = run_commands(commands, count_cores(0), work);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    all = succeeded(outcomes[i], files[i].string(), diagnostics) && all;
  }
  if (!all) return std::nullopt;
  return objects;
}

}  // namespace

std::optional<FirmwareRun> run_on_board(const std::string& name, const FirmwareSources& sources,
                                        Diagnostics& diagnostics) {
  const auto folder = make_temporary_folder(diagnostics);
  const Target* const target = find_target(name);
  if (!folder || target == nullptr) return std::nullopt;
  const fs::path& work = folder->path();
  const auto tools = find_tools(*target, {}, work, diagnostics);
  if (!tools || !write_board(*target, work, diagnostics)) return std::nullopt;
  const auto objects = compile(*target, *tools, sources, work, diagnostics);
  if (!objects) return std::nullopt;
  const auto program = link_program(*objects, *target, *tools, {}, diagnostics);
  if (!program) return std::nullopt;
  Command command{"timeout", "300"};
  command.insert(command.end(), tools->runner.begin(), tools->runner.end());
  command.push_back(program->string());
  if (!succeeded(run_commands({command}, 1, work).front(), command[2], diagnostics)) {
    return std::nullopt;
  }
  return read_run(work, diagnostics);
}

std::optional<FirmwareRun> run_on_host(const std::string& compiler, const FirmwareSources& sources,
                                       Diagnostics& diagnostics) {
  const auto folder = make_temporary_folder(diagnostics);
  if (!folder) return std::nullopt;
  const fs::path& work = folder->path();
  if (!write_work_file(work / "board.hpp", std::string(board_templates::kBoard), diagnostics)) {
    return std::nullopt;
  }
  // Vectors that g++ forms by itself change no bits where nothing is fused.
  Command command = make_command(compiler, sources, work);
  for (const fs::path& file : list_sources(sources)) command.push_back(file.string());
  const std::string program = (work / "host").string();
  command.insert(command.end(), {(sources.own / "host.cpp").string(), "-o", program});
  if (!succeeded(run_commands({command}, 1, work).front(), compiler, diagnostics) ||
      !succeeded(run_commands({{program}}, 1, work).front(), program, diagnostics)) {
    return std::nullopt;
  }
  return read_run(work, diagnostics);
}

std::vector<Record> read_records(const FirmwareRun& run) {
  std::vector<Record> records(run.states.size() / sizeof(Record));
  std::memcpy(records.data(), run.states.data(), records.size() * sizeof(Record));
  return records;
}

}  // namespace treeline
