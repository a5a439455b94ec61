#include "bounds/node_bounds.hpp"

namespace treeline::bounds {

double NodeBounds::local_error(const ExpandedOperation& expanded) const {
  const Node& n = graph.nodes()[expanded.node];
  double error = computed(expanded.node);
  if (n.op == Op::mul) {  // by a sine or cosine, which has an error itself
    const bool first = polynomials[n.a].has_value();
    error += bounds[first ? n.a : n.b]->error * computed(first ? n.b : n.a);
  }
  return expanded.weight * error;
}

}  // namespace treeline::bounds
