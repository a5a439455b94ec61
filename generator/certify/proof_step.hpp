#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// A number as Gappa writes it (`17b-53`, `0x1.4p+3`), and about what it is.
struct GappaNumber {
  std::string text = "0";
  double value = 0;
};

/// The expression is never negative and at most `bound`.
struct StepGoal {
  std::string expression;
  GappaNumber bound;
};

/// One step of a proof: a formula that Gappa proves by itself. Variables are real numbers:
///   X7    exact value of node 7 of the expression graph, without any rounding
///   x7    its computed value
///   e7    its error, x7 - X7
///   r7    what the rounding of its own operation adds
///   v0, t0, w, l  values that belong to this step alone
/// A step knows of other nodes only what its hypotheses say: assumptions about inputs, sines and
/// cosines, and the goals of earlier steps.
struct ProofStep {
  std::string meaning;                   ///< for readers, a line
  std::vector<std::string> definitions;  ///< `x7 = rnd(y7)`
  std::vector<std::string> hypotheses;
  std::vector<StepGoal> goals;
  /// `primary -> secondary`: both are equal for all values of their variables.
  std::vector<std::string> rewritings;
};

/// Number type in which the code computes.
enum class Precision { binary32, binary64 };

/// The step as a script for Gappa. With `asks`, bounds of goals are left for Gappa to find.
std::string print_step(const ProofStep& step, Precision precision, bool asks);

/// Writes each step as a script for Gappa: FOLDER/FUNCTION/step_0001.g, and so on. Older scripts
/// of that name are removed. Returns false and reports an error if that fails.
bool write_proofs(const std::filesystem::path& folder, const std::string& function,
                  const std::vector<ProofStep>& steps, Precision precision,
                  Diagnostics& diagnostics);

}  // namespace treeline
