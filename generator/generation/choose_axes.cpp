#include "generation/choose_axes.hpp"

#include <algorithm>
#include <limits>
#include <string>
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

/// The cheapest route of a function, as traced.
std::string cheapest_route(const Mechanism& mechanism, Function function) {
  std::string cheapest;
  int least = std::numeric_limits<int>::max();
  for (const Program& program : trace_function(mechanism, function)) {
    const int flops = count_operations(program).flops();
    if (flops >= least) continue;
    least = flops;
    cheapest = program.source;
  }
  return cheapest;
}

/// Changes one choice of all `links` at once.
void flip(Mechanism& mechanism, const Links& links, bool MovingLink::*choice) {
  for (const int i : links) {
    bool& chosen = link_at(mechanism, i).*choice;
    chosen = !chosen;
  }
}

bool takes_rates(Function function) {
  return function == Function::inverse_dynamics || function == Function::nonlinear_effects ||
         function == Function::bias_acceleration || function == Function::forward_dynamics;
}

}  // namespace

std::optional<Function> axes_decider(Function function) {
  switch (function) {
    case Function::forward_dynamics:
    case Function::lambda_inverse:
    case Function::lambda:
    case Function::control_torque:
      return Function::forward_dynamics;
    case Function::forward_kinematics:
    case Function::jacobian:
    case Function::bias_acceleration:
    case Function::inverse_dynamics:
    case Function::gravity:
    case Function::nonlinear_effects:
    case Function::mass_matrix:
      return function;
    default:
      return std::nullopt;
  }
}

void choose_axes(Mechanism& mechanism, Function decider) {
  constexpr int kMostSweeps = 2;  // a third found nothing on any robot at hand
  std::vector<bool MovingLink::*> choices{&MovingLink::turns_late};
  if (takes_rates(decider)) choices.push_back(&MovingLink::carries_column);
  const std::vector<Links> together = corresponding_links(mechanism);
  // Axes hardly matter to which route is the cheapest.
  const std::string route = cheapest_route(mechanism, decider);
  const auto count_flops = [&] {
    return count_operations(trace_route(mechanism, decider, route)).flops();
  };
  int flops = count_flops();
  bool cheaper = true;
  for (int sweep = 0; cheaper && sweep < kMostSweeps; ++sweep) {
    cheaper = false;
    for (const Links& links : together) {
      if (link_at(mechanism, links.front()).kind == JointKind::floating) continue;
      for (bool MovingLink::*choice : choices) {
        flip(mechanism, links, choice);
        const int changed = count_flops();
        if (changed < flops) {
          flops = changed;
          cheaper = true;
        } else {
          flip(mechanism, links, choice);
        }
      }
    }
  }
}

}  // namespace treeline
