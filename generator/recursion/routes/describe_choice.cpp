#include "recursion/routes/describe_choice.hpp"

#include <fmt/format.h>

namespace treeline {

std::string axes_name(int link, const Tree<Expression>& tree) {
  return fmt::format("the axes of link {} ({})", link + 1,
                     tree.links[static_cast<std::size_t>(link)].name);
}

std::string axes_key(int link) {
  return fmt::format("link-{}", link + 1);
}

RouteId route_id(LambdaRoute route) {
  switch (route) {
    case LambdaRoute::unit_forces:
      return {"pv-osim", "unit forces propagated inward (PV-OSIM)"};
    case LambdaRoute::factors_inward:
      return {"ltdl-inward", "M = L^T D L, J carried inward"};
    case LambdaRoute::factors_world:
      return {"ltdl-poses", "M = L^T D L, J from poses"};
    case LambdaRoute::branching:
      return {"branching", "force propagation with branching (Chang table 5.3)"};
    case LambdaRoute::inertia_propagation:
      return {"inertia-propagation", "inertia propagation (Chang table 5.1)"};
  }
  return {};
}

RouteId route_id(const LambdaChoice& choice, const Tree<Expression>& tree) {
  const TaskBasis& basis = choice.basis;
  const bool turned = basis.axes_link >= 0;
  RouteId id = route_id(choice.route);
  id.coordinates = (turned               ? axes_key(basis.axes_link)
                    : basis.in_link_axes ? "own"
                                         : "asked") +
                   std::string(basis.at_link_origin ? "/origins" : "/points");
  id.coordinates_words = fmt::format("in {} at {}",
                                     turned               ? axes_name(basis.axes_link, tree)
                                     : basis.in_link_axes ? "link axes"
                                                          : "the axes asked for",
                                     basis.at_link_origin ? "link origins" : "the points");
  return id;
}

RouteId on_top_of(const RouteId& lambda_inverse, const std::string& key, const std::string& words) {
  RouteId id = lambda_inverse;
  id.algorithm = key + "/" + id.algorithm;
  id.algorithm_words = words + "; Lambda^-1: " + id.algorithm_words;
  return id;
}

}  // namespace treeline
