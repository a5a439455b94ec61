#include <algorithm>
#include <utility>
#include <vector>

#include "bench/contender.hpp"
#include "oracle/interpret.hpp"
#include "oracle/subject_at.hpp"

namespace treeline {
namespace {

/// Number of states to time. A few suffice because the interpreter is slow.
constexpr std::size_t kTimed = 8;

template <class Scalar>
void append_contenders(const Subject<interpreter::Digits50>& exact, const Scene& scene,
                       const std::vector<State>& timed, const char* name,
                       std::vector<Contender>& contenders) {
  const auto subject = std::make_shared<const Subject<Scalar>>(cast<Scalar>(exact));
  // Subjects are made here because a pass must time the interpreter alone.
  std::vector<std::pair<SubjectAt<Scalar>, State>> few;
  for (std::size_t i = 0; i < std::min(kTimed, timed.size()); ++i) {
    few.emplace_back(SubjectAt(*subject, timed[i]), timed[i]);
  }
  const Real real = sizeof(Scalar) == sizeof(float) ? Real::float32 : Real::float64;
  for (const Function function : scene.functions) {
    Contender contender{{function, VariantGroup::interpreter, name, real}, {}, {}};
    contender.call = [subject, function](const State& state) {
      const std::vector<Scalar> entries =
          interpret<Scalar>(function, *SubjectAt(*subject, state), state);
      return std::vector<double>(entries.begin(), entries.end());
    };
    const auto pass = [subject, function, few] {
      for (const auto& [at_state, state] : few) interpret<Scalar>(function, *at_state, state);
    };
    contender.passes.push_back({pass, few.size()});
    contenders.push_back(std::move(contender));
  }
}

}  // namespace

std::vector<Contender> interpreter_contenders(const Robot& robot, const Scene& scene,
                                              const std::vector<State>& timed) {
  const auto exact = make_subject<interpreter::Digits50>(robot, scene);
  std::vector<Contender> contenders;
  append_contenders<double>(exact, scene, timed, "interpreter, double", contenders);
  append_contenders<float>(exact, scene, timed, "interpreter, float", contenders);
  return contenders;
}

}  // namespace treeline
