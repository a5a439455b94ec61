#include "oracle/graph_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace treeline {
namespace {

/// Nodes that `program` takes the sine or cosine of, but for inputs.
std::vector<std::uint32_t> find_computed_angles(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  std::vector<std::uint32_t> angles;
  for (const Node& node : nodes) {
    const bool trigonometric = is_trigonometric(node.op);
    if (trigonometric && nodes[node.a].op != Op::input) angles.push_back(node.a);
  }
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  return angles;
}

}  // namespace

GraphRun::GraphRun(const Program& program)
    : program_(&program), places_(locate_inputs(program)), angles_(find_computed_angles(program)) {}

template <class T>
std::vector<T> GraphRun::node_values(const State& state) const {
  const auto arguments = arguments_of(*program_, state);
  std::vector<T> inputs;
  for (const InputPlace& place : places_) {
    inputs.push_back(static_cast<T>(arguments.at(place.argument)->at(place.element)));
  }
  std::vector<T> values;
  values.reserve(program_->graph.nodes().size());
  for (const Node& node : program_->graph.nodes()) {
    values.push_back(evaluate_node(node, values, inputs));
  }
  return values;
}

template <class T>
std::vector<double> GraphRun::results_in(const State& state) const {
  const std::vector<T> values = node_values<T>(state);
  std::vector<double> results;
  for (const Result& result : program_->results) {
    for (const Expression& value : result.values) {
      const T entry = values[value.node()];
      results.push_back(static_cast<double>(value.negative() ? -entry : entry));
    }
  }
  return results;
}

std::vector<double> GraphRun::results(const State& state, Real real) const {
  return real == Real::float32 ? results_in<float>(state) : results_in<double>(state);
}

double GraphRun::computed_angles(const State& state) const {
  if (angles_.empty()) return 0;
  const std::vector<double> values = node_values<double>(state);
  double sum = 0;
  for (const std::uint32_t angle : angles_) sum += std::abs(values[angle]);
  return sum;
}

std::vector<const std::vector<double>*> arguments_of(const Program& program, const State& state) {
  std::vector<const std::vector<double>*> arguments;
  for (const Argument& argument : program.arguments) {
    const auto quantity = find_quantity(argument.name);
    if (!quantity) throw std::logic_error("no state has an argument " + argument.name);
    arguments.push_back(&values_of(state, *quantity));
  }
  return arguments;
}

}  // namespace treeline
