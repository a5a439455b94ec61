#include "oracle/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "choice/for_each_index.hpp"
#include "oracle/reference_maker.hpp"

namespace treeline {
namespace {

/// Whether a state has a member for the quantity.
bool is_member(Quantity quantity) {
  switch (info_of(quantity).space) {
    case IndexSpace::positions:
    case IndexSpace::velocities:
    case IndexSpace::task_rows:
    case IndexSpace::external_forces:
      return true;
    case IndexSpace::contacts:
    case IndexSpace::objects:
    case IndexSpace::linkages:
    case IndexSpace::grasp_gains:
    case IndexSpace::gravity:
    case IndexSpace::payloads:
    case IndexSpace::parameters:
    case IndexSpace::base_parameters:
    case IndexSpace::tools:
    case IndexSpace::orientations:
    case IndexSpace::contact_places:
    case IndexSpace::active_groups:
    case IndexSpace::active_tasks:
    case IndexSpace::held_rows:
    case IndexSpace::anchored_rows:
    case IndexSpace::step:
      break;
  }
  return false;
}

/// Arguments of functions about contacts, objects and constraints, which are drawn without regard
/// to their meaning, and arguments that change the robot.
std::map<Quantity, int> other_arguments(const std::vector<GeneratedFunction>& functions) {
  std::map<Quantity, int> sizes;
  for (const GeneratedFunction& generated : functions) {
    for (const Argument& argument : generated.program.arguments) {
      const auto quantity = find_quantity(argument.name);
      if (!quantity || is_member(*quantity)) continue;
      sizes[*quantity] = std::max(sizes[*quantity], argument.rows * argument.cols);
    }
  }
  return sizes;
}

std::vector<int> state_indices(const ReferenceOptions& options) {
  std::vector<int> indices;
  for (int i = options.first; static_cast<int>(indices.size()) < options.states; ++i) {
    if (!options.only || class_of_state(i) == *options.only) indices.push_back(i);
  }
  return indices;
}

}  // namespace

StateSpace make_state_space(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                            const std::vector<GeneratedFunction>& functions, std::uint64_t seed) {
  return {make_subject<double>(robot, scene, &mechanism), mechanism.coordinates, seed,
          scene.real == Real::float32, other_arguments(functions)};
}

std::vector<StateReference> make_references(const Robot& robot, const Scene& scene,
                                            const ChosenFunctions& chosen,
                                            const ReferenceOptions& options) {
  const ReferenceMaker maker(robot, scene, chosen, options.seed);
  std::vector<StateReference> made(static_cast<std::size_t>(options.states));
  const std::vector<int> indices = state_indices(options);
  int done = 0;
  std::mutex telling;
  const auto make_state = [&](std::size_t i) {
    made[i] = maker.make(indices[i]);
    const std::lock_guard lock(telling);
    ++done;
    if (options.progress) options.progress(done, options.states);
  };
  for_each_index(made.size(), make_state, options.threads);
  return made;
}

double unit_of(Real real) {
  return real == Real::float32 ? 0x1p-23 : 0x1p-52;
}

bool are_finite(const std::vector<double>& entries) {
  return std::all_of(entries.begin(), entries.end(), [](double x) { return std::isfinite(x); });
}

double error_in_ulp(const std::vector<double>& actual, const FunctionReference& reference,
                    double unit) {
  double worst = 0;
  for (std::size_t i = 0; i < reference.high.size(); ++i) {
    const double difference = (reference.high[i] - actual[i]) + reference.low[i];
    if (difference == 0) continue;
    const double error = std::abs(difference) / (unit * reference.size[i]);
    if (!(error <= std::numeric_limits<double>::max())) {
      return std::numeric_limits<double>::infinity();
    }
    worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace treeline
