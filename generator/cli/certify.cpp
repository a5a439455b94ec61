#include "certify/certify.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "check/add_selftest.hpp"
#include "cli/commands.hpp"
#include "cli/generate_from_files.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/progress_line.hpp"
#include "terminal/write_output.hpp"

namespace treeline {
namespace {

constexpr const char* kHowToReadCertificate =
    "Each function without a division is bounded once more, by steps so small that Gappa proves\n"
    "every one of them. The bounds hold for the inputs printed, taken as exact, against exact\n"
    "arithmetic, for code compiled with -ffp-contract=off. Assumed: computed sines and cosines\n"
    "are within one ulp of 1 (2^-53, of float 2^-24) of those of the angle, which lie on the unit\n"
    "circle.\n"
    "  proven      the largest error that any entry of the result can have, by Gappa\n"
    "  stated      what the header of the generated code states, by generator/bounds\n"
    "  ratio       proven / stated; below 1 the proof is sharper than the header\n"
    "Exit: 0 proven, 1 bad input or a missing program, 3 a proof failed or took too long, a ratio\n"
    "is above --within, or no function has a proof to try.\n\n"
    "Examples:\n"
    "  treeline certify puma560.urdf scene.yaml\n"
    "  treeline certify puma560.urdf scene.yaml --functions gravity,mass_matrix\n"
    "  treeline certify puma560.urdf scene.yaml --functions gravity --coq --output proofs";

struct CertifyCommand {
  InputOptions inputs;
  CertifyOptions certify;
  std::string folder;
  bool json = false;
};

std::optional<Certificate> make_certificate(const CertifyCommand& command,
                                            Diagnostics& diagnostics) {
  auto made = generate_from_files(command.inputs, Failing::kept, diagnostics);
  if (!made) return std::nullopt;
  if (!add_selftest(made->inputs.robot, made->inputs.scene, made->generation, diagnostics)) {
    return std::nullopt;
  }
  return certify(made->inputs.scene, made->generation, command.certify, diagnostics);
}

int run(CertifyCommand command) {
  Diagnostics diagnostics;
  LateProgress progress;
  command.certify.folder = command.folder;
  command.certify.tell = [&progress](const std::string& function) {
    progress.show("  proving " + function);
  };
  const auto certificate = make_certificate(command, diagnostics);
  print_diagnostics(diagnostics, command.inputs.warnings);
  if (!certificate) return kBadInput;
  const ExitCode exit_code = certificate->passed() ? kOk : kMismatch;
  return command.json ? write_output(print_json(*certificate), OutputForm::json, exit_code)
                      : write_output(print_text(*certificate), OutputForm::text, exit_code);
}

}  // namespace

void add_certify(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CertifyCommand>();
  CLI::App* command =
      app.add_subcommand("certify", "Let Gappa and Coq prove bounds of rounding errors");
  add_input_options(*command, options->inputs);
  command->add_option("--choices", options->inputs.choices,
                      "Algorithms and lanes as this manifest.json records them, not by cost");
  command
      ->add_option("-o,--output", options->folder,
                   "Folder for the scripts of all steps, and for the proofs of --coq")
      ->check(no_equals_sign());
  command
      ->add_option("--within", options->certify.within,
                   "How many times the stated bounds the proven ones may be")
      ->capture_default_str()
      ->check(between(0, 1e6));
  command
      ->add_option("--seconds", options->certify.seconds, "Time for each function, without Coq's")
      ->capture_default_str()
      ->check(between(0, 1e6));
  command->add_flag("--coq", options->certify.coq, "Let Coq check each step, too");
  command->add_flag("--json", options->json, "Everything as JSON");
  command->footer(kHowToReadCertificate);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
