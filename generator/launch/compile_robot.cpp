#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

#include "compilation/compile_folder.hpp"
#include "compilation/keep_library.hpp"
#include "compilation/run_commands.hpp"
#include "emission/descriptions.hpp"
#include "emission/emission_context.hpp"
#include "emission/ground_unit.hpp"
#include "emission/print_files.hpp"
#include "launch/print_robot.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

struct PartSource {
  fs::path path;
  fs::path object;
  bool is_long = false;
  bool is_loop = false;
};

std::vector<PartSource> list_sources(const std::vector<CompiledPart>& parts, const fs::path& work) {
  std::vector<PartSource> sources = {{work / "robot.cpp", work / "robot.o", false, true}};
  for (const CompiledPart& part : parts) {
    const auto add = [&](const std::string& stem, bool is_long) {
      sources.push_back({work / part.name / (stem + ".cpp"), work / (part.name + "_" + stem + ".o"),
                         is_long, false});
    };
    for (const GeneratedFunction& generated : part.generation->functions) {
      add(source_stem(generated), is_long(generated.program));
    }
    const GroundUnit* const ground = part.generation->context->ground.get();
    if (ground == nullptr) continue;
    add(kGroundStem, false);
    for (const Program* const program : ground->programs()) add(program->name, is_long(*program));
  }
  // The largest first, so that none is left at the end for a single core.
  std::stable_sort(sources.begin(), sources.end(), [](const PartSource& a, const PartSource& b) {
    return fs::file_size(a.path) > fs::file_size(b.path);
  });
  return sources;
}

Command compile_command(const Command& compiler, const std::vector<CompiledPart>& parts,
                        const fs::path& work, const PartSource& source) {
  Command command = compiler;
  const auto add = [&command](std::initializer_list<std::string> words) {
    command.insert(command.end(), words);
  };
  add({source.is_loop ? "-std=c++20" : "-std=c++17", source.is_long ? "-O1" : "-O2",
       "-ffp-contract=off", "-fPIC"});
  if (source.is_loop) add({"-I", work / "runtime"});
  for (const CompiledPart& part : parts) add({"-I", work / part.name});
  add({"-c", source.path, "-o", source.object});
  return command;
}

bool all_succeeded(const std::vector<CommandOutcome>& outcomes,
                   const std::vector<PartSource>& sources, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].started && outcomes[i].exit_code == 0) continue;
    diagnostics.add({Severity::error, sources[i].path.filename(), 0, "",
                     "does not compile" + first_lines(outcomes[i].output),
                     "Look whether the folder of temporary files (TMPDIR) has space left, and "
                     "whether $CXX is a compiler for C++20."});
    return false;
  }
  return true;
}

Command link_command(const Command& compiler, const std::vector<PartSource>& sources,
                     const fs::path& work, const fs::path& library) {
  const fs::path exported = work / "exported.map";
  std::ofstream(exported) << "{ global: treeline_drive_library; local: *; };\n";
  Command command = compiler;
  command.insert(command.end(),
                 {"-shared", "-Wl,--version-script=" + exported.string(), "-o", library.string()});
  for (const PartSource& source : sources) command.push_back(source.object);
  return command;
}

bool link(const Command& command, const fs::path& work, const fs::path& library,
          Diagnostics& diagnostics) {
  const CommandOutcome outcome = run_commands({command}, 1, work).front();
  if (outcome.started && outcome.exit_code == 0) return true;
  diagnostics.add({Severity::error, library.filename(), 0, "",
                   "does not link" + first_lines(outcome.output),
                   "Look whether the folder of temporary files (TMPDIR) has space left."});
  return false;
}

}  // namespace

fs::path compile_robot(const std::vector<CompiledPart>& parts, const fs::path& work,
                       const std::function<void(int, int)>& progress, Diagnostics& diagnostics) {
  const auto compiler = find_compiler(CompileOptions{}, work, diagnostics);
  if (!compiler) return {};
  const std::vector<PartSource> sources = list_sources(parts, work);
  std::vector<Command> commands;
  for (const PartSource& source : sources) {
    commands.push_back(compile_command(*compiler, parts, work, source));
  }
  const fs::path library = work / "librobot.so";
  const Command linking = link_command(*compiler, sources, work, library);
  fs::path kept = folder_of_kept_libraries();
  if (auto reason = reason_to_distrust(kept)) {
    diagnostics.add(std::move(*reason));
    kept.clear();
  }
  std::string name;
  if (!kept.empty()) {
    name = identify_library(*compiler, commands, linking, work);
    if (take_kept_library(kept, name, library)) return library;
  }
  const auto outcomes = run_commands(commands, count_cores(0), work, progress);
  if (!all_succeeded(outcomes, sources, diagnostics)) return {};
  if (!link(linking, work, library, diagnostics)) return {};
  if (!kept.empty()) keep_library(library, kept, name);
  return library;
}

}  // namespace treeline
