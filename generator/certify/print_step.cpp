#include <fmt/format.h>

#include "certify/proof_step.hpp"

namespace treeline {

std::string print_step(const ProofStep& step, Precision precision, bool asks) {
  std::string text = fmt::format("# {}\n@rnd = float<{}, ne>;\n", step.meaning,
                                 precision == Precision::binary64 ? "ieee_64" : "ieee_32");
  for (const std::string& definition : step.definitions) text += definition + ";\n";
  text += "{ " + fmt::format("{}", fmt::join(step.hypotheses, " /\\\n  "));
  if (!step.hypotheses.empty()) text += "\n  -> ";
  bool first = true;
  for (const StepGoal& goal : step.goals) {
    text += fmt::format("{}{} in {}", first ? "" : " /\\\n  ", goal.expression,
                        asks ? "?" : fmt::format("[0,{}]", goal.bound.text));
    first = false;
  }
  text += " }\n";
  for (const std::string& rewriting : step.rewritings) text += rewriting + ";\n";
  return text;
}

}  // namespace treeline
