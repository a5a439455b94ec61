#include <fmt/format.h>

#include <sstream>

#include "certify/ask_gappa.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"

namespace treeline {
namespace {

constexpr const char* kHead =
    "(* Proofs of rounding bounds, found by Gappa. *)\n"
    "Require Import Reals Gappa.Gappa_library.\n"
    "Lemma take_sign_out : forall p e,\n"
    "  float2R (Float2 (Zneg p) e) = (- float2R (Float2 (Zpos p) e))%R.\n"
    "Proof.\n"
    "  intros p e. unfold float2R, Defs.F2R. simpl.\n"
    "  change (IZR (Zneg p)) with (- IZR (Zpos p))%R. ring.\n"
    "Qed.\n"
    "Ltac prove_equation :=\n"
    "  unfold Float1; rewrite ?take_sign_out;\n"
    "  first [ ring | field | exact (eq_sym (sqrt_Rsqr_abs _)) ].\n\n";

/// The module of a step, from Gappa's proof: hypotheses about equations become lemmas.
std::string print_module(const std::string& proof, std::size_t number) {
  std::string text = fmt::format("Module Step{}.\n", number);
  std::istringstream lines(proof);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Require Import")) continue;
    if (line.starts_with("Hypothesis a")) {
      line = "Lemma" + line.substr(10) + "\nProof. prove_equation. Qed.";
    }
    text += line + "\n";
  }
  return text + fmt::format("End Step{}.\n\n", number);
}

}  // namespace

std::optional<std::string> find_coq(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  if (!write_work_file(folder / "find.v", kHead, diagnostics)) return std::nullopt;
  const auto version = run_commands({{"coqc", "--version"}}, 1, folder).front();
  if (version.started && accepts(folder / "find.v", folder)) {
    return version.output.substr(0, version.output.find('\n'));
  }
  diagnostics.add({Severity::error, "", 0, "coqc",
                   version.started ? "Coq does not find the library of Gappa"
                                   : "there is no such program, which --coq needs",
                   "Install it (Debian: apt-get install coq libcoq-gappa)."});
  return std::nullopt;
}

std::optional<std::string> print_coq(const Gappa& gappa, const std::vector<ProofStep>& steps) {
  std::string text = kHead;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto proof = gappa.prove_for_coq(steps[i]);
    if (!proof) return std::nullopt;
    text += fmt::format("(* {} *)\n", steps[i].meaning) + print_module(*proof, i + 1);
  }
  return text;
}

bool accepts(const std::filesystem::path& file, const std::filesystem::path& work) {
  const auto outcome = run_commands({{"coqc", "-q", file.string()}}, 1, work).front();
  return outcome.started && outcome.exit_code == 0;
}

}  // namespace treeline
