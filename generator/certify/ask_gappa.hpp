#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "certify/proof_step.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Runs the program `gappa`.
class Gappa {
 public:
  /// Scripts are written to `folder`.
  Gappa(std::filesystem::path folder, Precision precision)
      : folder_(std::move(folder)), precision_(precision) {}

  /// Lets Gappa find the least bounds of the goals that it can prove and writes them to the step;
  /// then lets it prove the step with these numbers. Returns false if it cannot.
  [[nodiscard]] bool solve(ProofStep& step) const;
  /// Whether Gappa proves the step with the bounds that its goals state.
  [[nodiscard]] bool proves(const ProofStep& step) const;
  /// The proof of the step for Coq. Nothing if there is none.
  [[nodiscard]] std::optional<std::string> prove_for_coq(const ProofStep& step) const;
  [[nodiscard]] Precision precision() const { return precision_; }

 private:
  [[nodiscard]] std::optional<std::string> run(const std::string& script,
                                               const std::vector<std::string>& options) const;

  std::filesystem::path folder_;
  Precision precision_;
};

/// First line that `gappa --version` prints. Without the program an error that names its package.
std::optional<std::string> find_gappa(const std::filesystem::path& folder,
                                      Diagnostics& diagnostics);

/// The number `12345b-67`, `17` or `0x1.8p+3`.
GappaNumber read_gappa_number(const std::string& text);

/// The number with this value, exactly.
GappaNumber exact_number(double value);

/// Version of Coq. Without the program or the libraries of Gappa, an error that names the packages.
std::optional<std::string> find_coq(const std::filesystem::path& folder, Diagnostics& diagnostics);

/// One file for Coq with a module for each step. Gappa leaves the equations of rewritings to be
/// proven; here each of them has a proof. Nothing if Gappa has no proof of a step.
std::optional<std::string> print_coq(const Gappa& gappa, const std::vector<ProofStep>& steps);

/// Whether Coq accepts the file.
bool accepts(const std::filesystem::path& file, const std::filesystem::path& work);

}  // namespace treeline
