#include "agreement.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "packs.hpp"

namespace treeline::bench {
namespace {

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
  std::map<Function, std::vector<std::vector<double>>> first;
  for (const Subject& subject : subjects) {
    for (const auto& [function, routine] : subject.routines) {
      std::vector<std::vector<double>> outputs;
      const auto width = static_cast<std::size_t>(routine.states);
      for (std::size_t i = 0; i + width <= states.size(); i += width) {
        const std::span<const State> taken{states.data() + i, width};
        std::ranges::move(evaluate(routine, function, robot, taken), std::back_inserter(outputs));
      }
      const auto& ours = first.try_emplace(function, outputs).first->second;
      Difference entry{subject.implementation, function, 0};
      for (std::size_t i = 0; i < outputs.size(); ++i) {
        entry.worst = std::fmax(entry.worst, difference(ours[i], outputs[i]));
      }
      result.push_back(entry);
    }
  }
  return result;
}

}  // namespace treeline::bench
