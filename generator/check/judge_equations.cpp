#include <algorithm>

#include "check/judges.hpp"
#include "choice/for_each_index.hpp"
#include "oracle/equations.hpp"
#include "oracle/subject_at.hpp"

namespace treeline {
namespace {

void note(double residual, int state, std::optional<EquationReport>& report) {
  if (!report) report.emplace();
  ++report->states;
  if (residual > report->worst || report->states == 1) {
    report->worst = residual;
    report->state = state;
  }
}

}  // namespace

void judge_equations(const Robot& robot, const Scene& scene, const Generation& generation,
                     const std::vector<StateReference>& references, int threads,
                     CheckReport& report) {
  const auto exact = make_subject<Digits50>(robot, scene, &generation.mechanism);
  const std::size_t states = std::min<std::size_t>(references.size(), kStatesOfEveryClass);
  std::vector<std::vector<double>> residuals(states,
                                             std::vector<double>(generation.functions.size(), -1));
  const auto judge_state = [&](std::size_t s) {
    const State& state = references[s].state;
    const SubjectAt subject(exact, state);
    for (std::size_t i = 0; i < generation.functions.size(); ++i) {
      if (references[s].functions[i].singular) continue;
      const auto residual = equation_residual(generation.functions[i].function, *subject, state);
      if (residual) residuals[s][i] = *residual;
    }
  };
  for_each_index(states, judge_state, threads);
  for (std::size_t i = 0; i < generation.functions.size(); ++i) {
    for (std::size_t s = 0; s < states; ++s) {
      if (residuals[s][i] < 0) continue;
      note(residuals[s][i], references[s].state.index, report.functions[i].equation);
    }
    if (!report.functions[i].equation) continue;
    report.functions[i].equation->says = find_equation(generation.functions[i].function)->text;
  }
}

}  // namespace treeline
