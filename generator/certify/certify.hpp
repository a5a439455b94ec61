#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/proof_step.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

struct CertifyOptions {
  double within = 2;             ///< proven bounds may be this many times those that are stated
  double seconds = 300;          ///< for each function
  bool coq = false;              ///< let Coq check every step
  std::filesystem::path folder;  ///< for scripts and proofs; empty: they are not kept
  std::function<void(const std::string&)> tell;  ///< receives the function at work; may be empty
};

/// The largest error in a result, in its unit.
struct CertifiedResult {
  std::string name;
  double proven = 0;  ///< by Gappa
  double stated = 0;  ///< in the header of the generated code
  [[nodiscard]] double ratio() const { return stated > 0 ? proven / stated : 1; }
};

struct CertifiedFunction {
  std::string name;
  std::string skipped;  ///< why no proof was tried; empty: one was
  std::string failed;   ///< why a proof ended; empty: it did not
  std::vector<CertifiedResult> results;
  std::size_t steps = 0;
  double seconds = 0;
  double coq_seconds = 0;
  bool checked_by_coq = false;

  [[nodiscard]] bool passed(double within) const;
};

struct Certificate {
  std::string name, gappa, coq;  ///< scene, versions of the programs
  std::string digest;            ///< of the files that the generator makes, see `digest_of_files`
  std::string domain;            ///< ranges of inputs
  bool single_precision = false;
  double within = 2;
  std::vector<CertifiedFunction> functions;

  /// Whether no tried proof failed or is worse than asked for, and at least one was tried.
  [[nodiscard]] bool passed() const;
};

/// Proves the rounding bounds of all functions without a division, by steps that Gappa proves (see
/// StepBounds), for code without contraction. Returns nothing if a program is missing or the
/// folder cannot be written; `diagnostics` says why.
std::optional<Certificate> certify(const Scene& scene, const Generation& generation,
                                   const CertifyOptions& options, Diagnostics& diagnostics);

std::string print_text(const Certificate& certificate);
std::string print_json(const Certificate& certificate);

}  // namespace treeline
