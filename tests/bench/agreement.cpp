#include "agreement.hpp"

#include <cmath>
#include <limits>

namespace treeline::bench {
namespace {

std::vector<double> evaluate(const Routine& routine, Function function, const State& state,
                             int size) {
  std::vector<double> output(static_cast<std::size_t>(size));
  std::vector<const double*> inputs;
  for (const auto* input : inputs_of(function, state)) inputs.push_back(input->data());
  routine(inputs.data(), output.data());
  return output;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) {
      return std::numeric_limits<double>::infinity();
    }
    largest = std::fmax(largest, std::fabs(a[i]));
    worst = std::fmax(worst, std::fabs(a[i] - b[i]));
  }
  return worst / std::fmax(largest, std::numeric_limits<double>::min());
}

}  // namespace

std::vector<Difference> differences(const Case& robot, const std::vector<Subject>& subjects,
                                    const std::vector<State>& states) {
  std::vector<Difference> result;
  for (const Subject& subject : subjects) {
    for (const auto& [function, routine] : subject.routines) {
      Difference entry{subject.implementation, function, 0};
      const int size = output_size(function, robot);
      for (const State& state : states) {
        const auto ours = evaluate(subjects[0].routines.at(function), function, state, size);
        const auto theirs = evaluate(routine, function, state, size);
        entry.worst = std::fmax(entry.worst, difference(ours, theirs));
      }
      result.push_back(entry);
    }
  }
  return result;
}

}  // namespace treeline::bench
