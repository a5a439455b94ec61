#include "bench/bench_truths.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "choice/for_each_index.hpp"
#include "interpreter/joint_parts.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/hold_state.hpp"
#include "oracle/model_from_robot.hpp"
#include "oracle/reference_maker.hpp"

namespace treeline {
namespace {

/// Largest condition number of a matrix to solve with; see `FunctionReference::singular`.
constexpr double kLargestInFloat = 0x1p17;

/// Drawn states, by how many are wanted, of which Newton's method must close one.
constexpr int kMostDrawn = 64;

Generation generation_of(const Robot& robot, const Scene& scene,
                         const std::vector<GeneratedFunction>& functions) {
  Generation generation;
  generation.mechanism = reduced_mechanism(robot, scene);
  generation.functions = functions;
  return generation;
}

std::vector<StateReference> find_truths(const Robot& robot, Scene scene, Real real,
                                        const std::vector<GeneratedFunction>& functions,
                                        const BenchOptions& options) {
  const Generation generation = generation_of(robot, scene, functions);
  scene.real = real;
  ReferenceOptions how;
  how.states = options.states;
  how.seed = options.seed;
  how.only = StateClass::random;
  if (options.progress) {
    how.progress = [&](int done, int total) { options.progress("states", done, total); };
  }
  return make_references(robot, scene, generation, how);
}

/// Returns the index in q of the first entry of each quaternion.
std::vector<std::size_t> find_quaternions(const Robot& robot, const Scene& scene) {
  std::vector<std::size_t> firsts;
  for (const auto& body : model_from_robot<double>(robot, scene).bodies) {
    const int first = interpreter::quaternion_of(body);
    if (first >= 0) firsts.push_back(static_cast<std::size_t>(first));
  }
  return firsts;
}

/// Whether all quaternions have unit length up to the rounding of double.
bool have_unit_length(const State& state, const std::vector<std::size_t>& quaternions) {
  return std::all_of(quaternions.begin(), quaternions.end(), [&](std::size_t first) {
    double square = 0;
    for (std::size_t i = first; i < first + 4; ++i) square += state.q[i] * state.q[i];
    return std::abs(square - 1) < 0x1p-48;
  });
}

/// Draws states that keep the constraints, with quaternions of unit length, so that peers and
/// generated code have the same.
std::vector<State> draw_held_states(const StateSpace& space,
                                    const std::vector<std::size_t>& quaternions, int count) {
  std::vector<State> states;
  for (int i = 0; i < kMostDrawn * count && static_cast<int>(states.size()) < count; ++i) {
    if (class_of_state(i) != StateClass::random) continue;
    State state = draw_state(space, i);
    if (!hold_state(space, state) || !have_unit_length(state, quaternions)) continue;
    states.push_back(std::move(state));
  }
  return states;
}

/// The truths in double at states that keep the constraints.
std::vector<StateReference> find_held_truths(const Robot& robot, Scene scene,
                                             const std::vector<GeneratedFunction>& functions,
                                             const BenchOptions& options) {
  const Generation generation = generation_of(robot, scene, functions);
  scene.real = Real::float64;
  const std::vector<State> states = draw_held_states(
      make_state_space(robot, scene, generation.mechanism, functions, options.seed),
      find_quaternions(robot, scene), options.states);
  const ReferenceMaker maker(robot, scene, generation, options.seed);
  std::vector<StateReference> made(states.size());
  for_each_index(made.size(), [&](std::size_t i) { made[i] = maker.make(states[i]); });
  return made;
}

}  // namespace

BenchTruths::BenchTruths(const Robot& robot, const Scene& scene,
                         const std::vector<GeneratedFunction>& functions,
                         const BenchOptions& options)
    : in_float_(find_truths(robot, scene, Real::float32, functions, options)) {
  const std::vector<std::size_t> quaternions = find_quaternions(robot, scene);
  has_quaternions_ = !quaternions.empty();
  holds_rows_ = scene.holds_rows();
  if (!has_quaternions_ && !holds_rows_) return;
  in_double_ = holds_rows_ ? find_held_truths(robot, scene, functions, options)
                           : find_truths(robot, scene, Real::float64, functions, options);
  std::copy_if(in_double_.begin(), in_double_.end(), std::back_inserter(of_unit_length_),
               [&](const StateReference& reference) {
                 return have_unit_length(reference.state, quaternions);
               });
}

const std::vector<StateReference>& BenchTruths::of(const Variant& variant) const {
  if (in_double_.empty() || variant.real == Real::float32) return in_float_;
  return variant.group == VariantGroup::peer ? of_unit_length_ : in_double_;
}

bool is_comparable(const FunctionReference& truth) {
  return !truth.singular && truth.condition < kLargestInFloat;
}

}  // namespace treeline
