#include "bench/bench_truths.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "interpreter/joint_parts.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

/// Largest condition number of a matrix to solve with; see `FunctionReference::singular`.
constexpr double kLargestInFloat = 0x1p17;

std::vector<StateReference> find_truths(const Robot& robot, Scene scene, Real real,
                                        const std::vector<GeneratedFunction>& functions,
                                        const BenchOptions& options) {
  Generation generation;
  generation.mechanism = reduced_mechanism(robot, scene);
  generation.functions = functions;
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

}  // namespace

BenchTruths::BenchTruths(const Robot& robot, const Scene& scene,
                         const std::vector<GeneratedFunction>& functions,
                         const BenchOptions& options)
    : in_float_(find_truths(robot, scene, Real::float32, functions, options)) {
  const std::vector<std::size_t> quaternions = find_quaternions(robot, scene);
  has_quaternions_ = !quaternions.empty();
  if (!has_quaternions_) return;
  in_double_ = find_truths(robot, scene, Real::float64, functions, options);
  std::copy_if(in_double_.begin(), in_double_.end(), std::back_inserter(of_unit_length_),
               [&](const StateReference& reference) {
                 return have_unit_length(reference.state, quaternions);
               });
}

const std::vector<StateReference>& BenchTruths::of(const Variant& variant) const {
  if (!has_quaternions_ || variant.real == Real::float32) return in_float_;
  return variant.group == VariantGroup::peer ? of_unit_length_ : in_double_;
}

bool is_comparable(const FunctionReference& truth) {
  return !truth.singular && truth.condition < kLargestInFloat;
}

}  // namespace treeline
