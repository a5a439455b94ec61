#include <fmt/format.h>

#include <system_error>

#include "certify/proof_step.hpp"
#include "compilation/temporary_folder.hpp"

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

namespace fs = std::filesystem;

bool write_proofs(const fs::path& folder, const std::string& function,
                  const std::vector<ProofStep>& steps, Precision precision,
                  Diagnostics& diagnostics) {
  const fs::path own = folder / function;
  std::error_code none;  // a folder that is not there has no old steps
  for (const auto& entry : fs::directory_iterator(own, none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("step_") && entry.path().extension() == ".g") fs::remove(entry.path());
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const fs::path file = own / fmt::format("step_{:04}.g", i + 1);
    if (!write_work_file(file, print_step(steps[i], precision, false), diagnostics)) return false;
  }
  return true;
}

}  // namespace treeline
