#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "compilation/compile_folder.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "description/sdf/read_sdf.hpp"
#include "drive/page.hpp"
#include "target/target.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"
#include "text/align_columns.hpp"

namespace treeline {
namespace {

/// Something that a part of Treeline uses.
struct Need {
  std::string name;
  std::string used_by;
  std::string remedy;      ///< where it is missing
  Command question;        ///< which it answers by its version; empty: asked otherwise
  std::string found = {};  ///< its version; empty: missing
};

/// A program that says its version, by the name that a variable of the environment has for it.
Need program(const std::string& name, const std::string& used_by, const std::string& package,
             const char* variable = "") {
  const std::string own = *variable == '\0' ? "" : environment_value(variable);
  Command question = own.empty() ? Command{name} : split_words(own);
  const std::string asked = own.empty() ? name : fmt::format("{} (${})", own, variable);
  question.emplace_back("--version");
  return {asked, used_by, "apt-get install " + package, question};
}

/// Compilers and simulators of the processors, each once, with the processors that need it.
void add_targets(std::vector<Need>& needs) {
  const auto add = [&needs](const std::string& name, const Target& target, const char* package) {
    const auto same = std::find_if(needs.begin(), needs.end(),
                                   [&](const Need& need) { return need.name == name; });
    if (same != needs.end()) {
      same->used_by += fmt::format(", {}", target.name);
    } else {
      needs.push_back(program(name, fmt::format("check --target {}", target.name), package));
    }
  };
  for (const Target& target : all_targets()) {
    if (*target.prefix == '\0' || target.board.kind == BoardKind::none) continue;
    add(std::string(target.prefix) + "g++", target, target.package);
    add(target.board.simulator, target, target.board.package);
  }
}

std::vector<Need> list_needs() {
  std::vector<Need> needs = {
      program("c++", "check, bench, drive, generate --tune", "g++", "CXX"),
      program("cc", "the same of C, import treeline, generate --package python", "gcc", "CC"),
      program("cmake", "treeline_generate, generated folders, --package fmu and fmu3", "cmake"),
      program("python3", "import treeline", "python3"),
      {"Python.h",
       "import treeline, --package python",
       "apt-get install python3-dev",
       {"python3", "-c",
        "import os, sysconfig as s; p = s.get_path('include') + '/Python.h'\n"
        "open(p); print(p)"}},
      {"NumPy",
       "import treeline",
       "apt-get install python3-numpy",
       {"python3", "-c", "import numpy; print(numpy.__version__)"}},
      program("cargo", "generate --package rust", "cargo"),
      program("wasm-ld", "generate --package wasm", "clang lld"),
      program("gappa", "certify", "gappa"),
      program("coqc", "certify --coq", "coq libcoq-gappa")};
  add_targets(needs);
  return needs;
}

/// What is no program: the page, SDF, and folders with meshes.
void add_parts(std::vector<Need>& needs) {
  Diagnostics unread;
  const char* const model = "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>";
  needs.push_back({"libsdformat",
                   "robots that are SDF",
                   "install libsdformat-dev, and build again",
                   {},
                   read_sdf(model, "-", unread) ? "loaded" : ""});
  needs.push_back({"page",
                   "drive in a browser",
                   "install nodejs and npm, and build again",
                   {},
                   drive::carried_page().html.empty() ? "" : "carried by this program"});
  needs.push_back({"$AMENT_PREFIX_PATH",
                   "meshes at package://, in draw and drive",
                   "source your workspace, or give --package NAME=DIR",
                   {},
                   environment_value("AMENT_PREFIX_PATH")});
}

void ask_all(std::vector<Need>& needs, const std::filesystem::path& work) {
  std::vector<Command> questions;
  for (const Need& need : needs) questions.push_back(need.question);
  const auto answers = run_commands(questions, count_cores(0), work);
  for (std::size_t i = 0; i < needs.size(); ++i) {
    if (!answers[i].started || answers[i].exit_code != 0) continue;
    needs[i].found = answers[i].output.substr(0, answers[i].output.find('\n'));
  }
}

int run(bool as_json) {
  Diagnostics diagnostics;
  const auto work = make_temporary_folder(diagnostics);
  print_diagnostics(diagnostics);
  if (work == nullptr) return kBadInput;
  std::vector<Need> needs = list_needs();
  ask_all(needs, work->path());
  add_parts(needs);
  std::vector<std::vector<std::string>> rows;
  auto list = nlohmann::ordered_json::array();
  for (const Need& need : needs) {
    const bool found = !need.found.empty();
    rows.push_back({need.name, found ? need.found : "missing: " + need.remedy, need.used_by});
    list.push_back({{"name", need.name},
                    {"found", found},
                    {"version", need.found},
                    {"used_by", need.used_by},
                    {"remedy", need.remedy}});
  }
  if (as_json) return write_output(list.dump(2) + "\n", OutputForm::json, kOk);
  const auto table = align_columns({{"what"}, {"found"}, {"used by"}}, rows, page_columns());
  return write_output(table, OutputForm::text, kOk);
}

}  // namespace

void add_doctor(CLI::App& app, int& exit_code) {
  auto as_json = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("doctor", "Tell what of this machine is there or missing, and for what");
  command->add_flag("--json", *as_json, "The list as JSON");
  command->footer("generate, inspect, simulate and draw need none of it.");
  command->callback([as_json, &exit_code] { exit_code = run(*as_json); });
}

}  // namespace treeline
