#include "certify/ask_gappa.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "compilation/run_commands.hpp"

namespace treeline {
namespace {

/// Upper ends of the ranges that Gappa prints under "Results:", in their order.
std::vector<GappaNumber> read_results(const std::string& output) {
  std::vector<GappaNumber> found;
  std::istringstream lines(output);
  bool is_result = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Results:")) {
      is_result = true;
      continue;
    }
    const std::size_t range = line.rfind(" in [");
    if (!is_result || !line.starts_with("  ") || range == std::string::npos) continue;
    // "0, 17b-53 {1.9e-15, 2^(-49)}]", where the part in braces may be missing on either side
    const std::string ends = line.substr(range + 5);
    const std::size_t comma = ends.find(", ");
    const std::size_t brace = ends.find("}, ");
    const bool first_has_brace = brace != std::string::npos && ends.find('{') < comma;
    const std::string upper = ends.substr(first_has_brace ? brace + 3 : comma + 2);
    found.push_back(read_gappa_number(upper.substr(0, upper.find_first_of(" ]"))));
  }
  return found;
}

/// Whether Gappa warns of more than |x| = sqrt(x x), which it cannot see: of another equation that
/// is none of polynomials, or of a variable without a range.
bool warns(const std::string& output) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t root = line.find("| and sqrt(");
    const bool is_root = line.starts_with("Warning: |") && root != std::string::npos;
    if (line.starts_with("Warning:") && !is_root) return true;
  }
  return false;
}

}  // namespace

GappaNumber read_gappa_number(const std::string& text) {
  const std::size_t power = text.starts_with("0x") ? std::string::npos : text.find('b');
  double value = std::strtod(text.c_str(), nullptr);
  if (power != std::string::npos) {
    value = std::ldexp(std::strtod(text.substr(0, power).c_str(), nullptr),
                       std::atoi(text.c_str() + power + 1));
  }
  return {text, value};
}

GappaNumber exact_number(double value) {
  return value == 0 ? GappaNumber{} : GappaNumber{fmt::format("{:a}", value), value};
}

std::optional<std::string> Gappa::run(const std::string& script,
                                      const std::vector<std::string>& options) const {
  const std::filesystem::path file = folder_ / "step.g";
  std::ofstream(file) << script;
  Command command{"gappa"};
  command.insert(command.end(), options.begin(), options.end());
  command.push_back(file.string());
  const CommandOutcome outcome = run_commands({command}, 1, folder_).front();
  if (!outcome.started || outcome.exit_code != 0 || warns(outcome.output)) return std::nullopt;
  return outcome.output;
}

bool Gappa::solve(ProofStep& step) const {
  const auto output = run(print_step(step, precision_, true), {});
  if (!output) return false;
  const std::vector<GappaNumber> bounds = read_results(*output);
  if (bounds.size() != step.goals.size()) return false;
  for (std::size_t i = 0; i < bounds.size(); ++i) step.goals[i].bound = bounds[i];
  return proves(step);
}

bool Gappa::proves(const ProofStep& step) const {
  return run(print_step(step, precision_, false), {}).has_value();
}

std::optional<std::string> Gappa::prove_for_coq(const ProofStep& step) const {
  auto output = run(print_step(step, precision_, false), {"-Bcoq", "-Wno-hint-difference"});
  if (!output) return std::nullopt;
  const std::size_t start = output->find("Require Import");
  const std::size_t end = output->find("End Generated_by_Gappa.");
  if (start == std::string::npos || end == std::string::npos) return std::nullopt;
  return output->substr(start, end + 24 - start);
}

std::optional<std::string> find_gappa(const std::filesystem::path& folder,
                                      Diagnostics& diagnostics) {
  const CommandOutcome outcome = run_commands({{"gappa", "--version"}}, 1, folder).front();
  if (outcome.started && outcome.exit_code == 0) {
    return outcome.output.substr(0, outcome.output.find('\n'));
  }
  diagnostics.add({Severity::error, "", 0, "gappa",
                   "there is no such program, which finds and checks the proofs",
                   "Install it (Debian: apt-get install gappa)."});
  return std::nullopt;
}

}  // namespace treeline
