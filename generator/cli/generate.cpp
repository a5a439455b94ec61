#include "cli/generate.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/exit_code.hpp"
#include "cli/generate_from_files.hpp"
#include "cli/print_summary.hpp"
#include "emission/compare_files.hpp"
#include "emission/write_files.hpp"
#include "program/print.hpp"

namespace treeline {
namespace {

struct GenerateOptions {
  InputOptions inputs;
  std::string output;
  std::string dump;  ///< `text`, `dot` or empty
  bool compare = false, json = false, verbose = false;
};

void dump_programs(const Generation& generation, const std::string& format) {
  for (const GeneratedFunction& generated : generation.functions) {
    fmt::print("{}",
               format == "dot" ? print_dot(generated.program) : print_text(generated.program));
  }
}

void print_log(const Generation& generation) {
  for (const GeneratedFunction& generated : generation.functions) {
    for (const PassReport& report : generated.passes) {
      fmt::print(stderr, "{}\n", to_string(generated.program.name, report));
    }
  }
}

int deliver(const GenerateOptions& options, const Generation& generation,
            Diagnostics& diagnostics) {
  if (!options.dump.empty()) {
    dump_programs(generation, options.dump);
    return kOk;
  }
  const auto differences = compare_files(options.output, generation.files);
  if (!options.compare && !write_files(options.output, generation.files, diagnostics)) {
    return kBadInput;
  }
  const Summary summary{generation.functions, differences, options.output, options.compare,
                        options.verbose};
  fmt::print("{}", options.json ? print_json(summary) : print_text(summary));
  return options.compare && !differences.empty() ? kMismatch : kOk;
}

int run(const GenerateOptions& options) {
  Diagnostics diagnostics;
  const auto made = generate_from_files(options.inputs, diagnostics);
  int exit_code = kBadInput;
  if (made) {
    if (options.verbose) {
      print_log(made->generation);
    }
    exit_code = deliver(options, made->generation, diagnostics);
  }
  print_diagnostics(diagnostics);
  return exit_code;
}

}  // namespace

void add_generate(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", "Write a robot's dynamics as C++");
  command->add_option("urdf", options->inputs.urdf, "Robot, URDF")->required();
  command->add_option("scene", options->inputs.scene, "What to generate for it, YAML")->required();
  auto* output = command->add_option("-o,--output", options->output, "Folder to write");
  command->add_option("--name", options->inputs.name,
                      "Namespace and header, instead of the scene's");
  command->add_option("--real", options->inputs.real, "Number type, instead of the scene's")
      ->check(CLI::IsMember({"float", "double"}));
  command
      ->add_option("--functions", options->inputs.functions,
                   "Functions, separated by commas, instead of the scene's")
      ->delimiter(',');
  command->add_option("--choices", options->inputs.choices,
                      "Algorithms and lanes as this manifest.json records them, not by cost");
  auto* compare = command->add_flag("--compare", options->compare,
                                    "Write nothing; list files that are not up to date, exit 3");
  command->add_flag("--json", options->json, "Summary as JSON");
  command->add_flag("-v,--verbose", options->verbose, "What each pass did, which algorithms lost");
  auto* dump =
      command->add_option("--dump", options->dump, "Print the expression graphs and write nothing")
          ->check(CLI::IsMember({"text", "dot"}));
  compare->excludes(dump);
  command->footer(
      "Examples:\n"
      "  treeline generate puma560.urdf scene.yaml --output generated/puma560\n"
      "  treeline generate puma560.urdf scene.yaml --output generated/puma560 --compare\n"
      "  treeline generate puma560.urdf scene.yaml --output puma560 --choices "
      "puma560/manifest.json\n"
      "  treeline generate arm.urdf scene.yaml --functions gravity --dump dot | dot -Tsvg");
  command->callback([options, output, dump, &exit_code] {
    if (output->empty() && dump->empty()) {
      throw CLI::RequiredError("--output");
    }
    exit_code = run(*options);
  });
}

}  // namespace treeline
