#include "recursion/describe_choice.hpp"

#include <fmt/format.h>

namespace treeline {

std::string axes_name(int link, const Tree<Expression>& tree) {
  return fmt::format("the axes of link {} ({})", link + 1,
                     tree.links[static_cast<std::size_t>(link)].name);
}

const char* name_of(LambdaRoute route) {
  switch (route) {
    case LambdaRoute::unit_forces:
      return "unit forces propagated inward (PV-OSIM)";
    case LambdaRoute::factors_inward:
      return "M = L^T D L, J carried inward";
    case LambdaRoute::factors_world:
      return "M = L^T D L, J from poses";
    case LambdaRoute::branching:
      return "force propagation with branching (Chang table 5.3)";
    case LambdaRoute::extended_propagators:
      return "extended force propagators (EFPA)";
    case LambdaRoute::inertia_propagation:
      return "inertia propagation (Chang table 5.1)";
  }
  return "";
}

std::string describe(const LambdaChoice& choice, const Tree<Expression>& tree) {
  const TaskBasis& basis = choice.basis;
  const std::string axes = basis.axes_link >= 0 ? axes_name(basis.axes_link, tree)
                           : basis.in_link_axes ? "link axes"
                                                : "the axes asked for";
  return fmt::format("{}, in {} at {}", name_of(choice.route), axes,
                     basis.at_link_origin ? "link origins" : "the points");
}

}  // namespace treeline
