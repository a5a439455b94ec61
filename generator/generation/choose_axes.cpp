#include "generation/choose_axes.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/find_limbs.hpp"
#include "passes/count_operations.hpp"
#include "recursion/trace_function.hpp"

namespace treeline {
namespace {

using Links = std::vector<int>;

MovingLink& link_at(Mechanism& mechanism, int index) {
  return mechanism.links[static_cast<std::size_t>(index)];
}

/// Links that decide together, each in one of them: those of alike limbs, and the others alone.
std::vector<Links> corresponding_links(const Mechanism& mechanism) {
  std::vector<Links> together;
  std::vector<bool> listed(mechanism.links.size(), false);
  for (const LimbFamily& family : find_limbs(mechanism, std::numeric_limits<int>::max())) {
    for (std::size_t j = 0; j < family.limbs.front().size(); ++j) {
      Links& links = together.emplace_back();
      for (const std::vector<int>& limb : family.limbs) {
        links.push_back(limb[j]);
        listed[static_cast<std::size_t>(limb[j])] = true;
      }
    }
  }
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (!listed[i]) together.push_back({static_cast<int>(i)});
  }
  return together;
}

/// Counts operations of a function's routes as traced, but for those far from the cheapest.
class Counter {
 public:
  Counter(const Mechanism& mechanism, Function function)
      : mechanism_(mechanism), function_(function) {
    constexpr double kFar = 1.5;
    const std::vector<Program> programs = trace_function(mechanism, function);
    std::vector<double> counts;
    for (const Program& program : programs) counts.push_back(count_operations(program).flops());
    const double least = *std::min_element(counts.begin(), counts.end());
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (counts[i] <= kFar * least) routes_.push_back(programs[i].source);
    }
  }

  /// Of the cheapest, as the mechanism is now.
  [[nodiscard]] int flops() const {
    int least = std::numeric_limits<int>::max();
    for (const std::string& route : routes_) {
      const Program program = trace_route(mechanism_, function_, route);
      least = std::min(least, count_operations(program).flops());
    }
    return least;
  }

 private:
  const Mechanism& mechanism_;
  Function function_;
  std::vector<std::string> routes_;
};

/// Changes one choice of all `links` at once.
void flip(Mechanism& mechanism, const Links& links, bool MovingLink::*choice) {
  for (const int i : links) {
    bool& chosen = link_at(mechanism, i).*choice;
    chosen = !chosen;
  }
}

bool takes_rates(Function function) {
  return function == Function::inverse_dynamics || function == Function::nonlinear_effects ||
         function == Function::bias_acceleration || function == Function::forward_dynamics ||
         function == Function::contact_motion || function == Function::object_state;
}

}  // namespace

std::vector<Function> axes_deciders(Function function) {
  switch (function) {
    case Function::forward_dynamics:
    case Function::lambda_inverse:
    case Function::lambda:
    case Function::control_torque:
      return {Function::forward_dynamics};
    case Function::forward_kinematics:
    case Function::jacobian:
    case Function::bias_acceleration:
    case Function::inverse_dynamics:
    case Function::gravity:
    case Function::nonlinear_effects:
    case Function::mass_matrix:
    case Function::contact_motion:
    case Function::object_state:
    case Function::center_of_mass:
    case Function::center_of_mass_jacobian:
      return {function};
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
      return {Function::forward_dynamics};
    case Function::inverse_dynamics_derivatives:
    case Function::forward_dynamics_derivatives:  // deep trees gain more by the second
      return {Function::forward_dynamics, Function::mass_matrix};
    default:
      return {};
  }
}

int count_cheapest(const Mechanism& mechanism, Function function) {
  int least = std::numeric_limits<int>::max();
  for (const Program& program : trace_function(mechanism, function)) {
    least = std::min(least, count_operations(program).flops());
  }
  return least;
}

void choose_axes(Mechanism& mechanism, Function decider) {
  constexpr std::size_t kMostSweeps = 2;  // a third found nothing on any robot at hand
  std::vector<bool MovingLink::*> choices{&MovingLink::turns_late};
  if (takes_rates(decider)) choices.push_back(&MovingLink::carries_column);
  const std::vector<Links> together = corresponding_links(mechanism);
  const Counter counter(mechanism, decider);
  std::vector<std::pair<const Links*, bool MovingLink::*>> flips;
  for (const Links& links : together) {
    if (link_at(mechanism, links.front()).kind == JointKind::floating) continue;
    for (bool MovingLink::*choice : choices) flips.emplace_back(&links, choice);
  }
  int flops = counter.flops();
  std::size_t in_vain = 0;  // flips since the last that paid, each another
  for (std::size_t n = 0; n < kMostSweeps * flips.size() && in_vain < flips.size(); ++n) {
    const auto& [links, choice] = flips[n % flips.size()];
    flip(mechanism, *links, choice);
    const int changed = counter.flops();
    if (changed < flops) {
      flops = changed;
      in_vain = 1;  // flipping it back is known not to pay
    } else {
      flip(mechanism, *links, choice);
      ++in_vain;
    }
  }
}

}  // namespace treeline
