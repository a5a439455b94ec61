#include "bounds/propagate_errors.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "bounds/exact_operation.hpp"

namespace treeline::bounds {
namespace {

template <Op op>
using Tag = std::integral_constant<Op, op>;

/// Calls `visit` with the operation as a type, so that the loop over the states has no branch.
template <class Visit>
void with_operation(Op op, Visit&& visit) {
  switch (op) {
    case Op::input:
      return;
    case Op::constant:
      return visit(Tag<Op::constant>());
    case Op::add:
      return visit(Tag<Op::add>());
    case Op::sub:
      return visit(Tag<Op::sub>());
    case Op::mul:
      return visit(Tag<Op::mul>());
    case Op::div:
      return visit(Tag<Op::div>());
    case Op::neg:
      return visit(Tag<Op::neg>());
    case Op::sin:
      return visit(Tag<Op::sin>());
    case Op::cos:
      return visit(Tag<Op::cos>());
  }
}

template <class Visit>
void each_state(Visit&& visit) {
  for (std::size_t s = 0; s < kStatesAtOnce; ++s) visit(s);
}

/// Applies an operation. For constants the result is `value`.
template <Op op>
double apply(double a, double b, double value) {
  if constexpr (op == Op::constant) return value;
  if constexpr (op == Op::add) return a + b;
  if constexpr (op == Op::sub) return a - b;
  if constexpr (op == Op::mul) return a * b;
  if constexpr (op == Op::div) return a / b;
  if constexpr (op == Op::neg) return -a;
  if constexpr (op == Op::sin) return std::sin(a);
  if constexpr (op == Op::cos) return std::cos(a);
}

/// Derivatives of an operation with respect to its operands.
struct Slopes {
  double a, b;
};
template <Op op>
Slopes slopes(double a, double b, double value) {
  if constexpr (op == Op::constant) return {0, 0};
  if constexpr (op == Op::add) return {1, 1};
  if constexpr (op == Op::sub) return {1, -1};
  if constexpr (op == Op::mul) return {b, a};
  if constexpr (op == Op::div) return {1 / b, -value / b};
  if constexpr (op == Op::neg) return {-1, 0};
  if constexpr (op == Op::sin) return {std::cos(a), 0};
  if constexpr (op == Op::cos) return {-std::sin(a), 0};
}

/// Upper bound of the error that rounding adds to a value, in rounding units. A sine is off by at
/// most 1.0 ulp (core/sin_cos.hpp). Products and quotients may underflow.
template <Op op>
double rounding(double value, double underflow) {
  const double size = std::abs(value);
  if constexpr (op == Op::sin || op == Op::cos) return std::min(1.0, 2 * size);
  if constexpr (op == Op::mul || op == Op::div) return size + underflow;
  return size;
}

bool rounds(const std::vector<Node>& nodes, const Node& node, double unit) {
  if (node.op == Op::constant) return unit > 0x1p-53 && !is_float(node.value);
  if (node.op == Op::input || node.op == Op::neg) return false;
  return node.op != Op::mul || !(is_power_of_two(nodes[node.a]) || is_power_of_two(nodes[node.b]));
}

/// Index of the left operand. Node 0, the constant zero, if there is none.
std::uint32_t left(const Node& node) {
  return operation(node.op).operands > 0 ? node.a : 0;
}
std::uint32_t right(const Node& node) {
  return operation(node.op).operands > 1 ? node.b : 0;
}

/// SplitMix64: gives a sign for each state from one number per node.
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

}  // namespace

ErrorPropagation::ErrorPropagation(const Graph& graph, double unit)
    : graph_(graph),
      underflow_((unit > 0x1p-53 ? 0x1p-149 : 0x1p-1074) / unit),
      values_(graph.nodes().size()),
      derivatives_(graph.nodes().size()),
      samples_(graph.nodes().size()) {
  for (const Node& node : graph.nodes()) rounds_.push_back(rounds(graph.nodes(), node, unit));
  for (std::size_t i = 0; i < graph.nodes().size(); ++i) {
    if (graph.nodes()[i].op == Op::constant) values_[i].fill(graph.nodes()[i].value);
  }
}

void ErrorPropagation::evaluate(const std::vector<States>& inputs) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Node& node = graph_.nodes()[i];
    if (node.op == Op::input) values_[i] = inputs[node.a];
    with_operation(node.op, [&](auto tag) {
      const States &a = values_[left(node)], &b = values_[right(node)];
      States& value = values_[i];
      each_state([&](std::size_t s) { value[s] = apply<tag()>(a[s], b[s], value[s]); });
    });
  }
}

/// Lists in `cone_` the nodes that the node depends on, users before their operands.
void ErrorPropagation::find_cone(std::uint32_t node) {
  if (!cone_.empty() && cone_.front().node == node) return;
  cone_.clear();
  std::vector<std::uint8_t> inside(std::size_t{node} + 1, 0);
  const auto enter = [&](std::uint32_t operand) {
    const bool matters = operation(graph_.nodes()[operand].op).operands > 0 || rounds_[operand];
    if (!matters) return Flow::none;
    return std::exchange(inside[operand], std::uint8_t{1}) == 0 ? Flow::set : Flow::add;
  };
  inside[node] = 1;
  for (std::uint32_t i = node; i > 0; --i) {
    if (inside[i] == 0) continue;
    const Node& at = graph_.nodes()[i];
    const int operands = operation(at.op).operands;
    const Flow a = operands > 0 ? enter(at.a) : Flow::none;
    cone_.push_back({i, a, operands > 1 ? enter(at.b) : Flow::none});
  }
}

const States& ErrorPropagation::bound(std::uint32_t node) {
  find_cone(node);
  derivatives_[node].fill(1);
  bound_ = {};
  for (const Visit& visit : cone_) visit_backwards(visit);
  return bound_;
}

/// Adds the node's rounding to the bound, and its derivative to those of its operands.
void ErrorPropagation::visit_backwards(const Visit& visit) {
  const Node& at = graph_.nodes()[visit.node];
  const States g = derivatives_[visit.node];
  States &ga = derivatives_[left(at)], &gb = derivatives_[right(at)];
  if (g == States{}) {
    if (visit.a == Flow::set) ga.fill(0);
    if (visit.b == Flow::set) gb.fill(0);
    return;
  }
  with_operation(at.op, [&](auto tag) {
    const States &a = values_[left(at)], &b = values_[right(at)], &value = values_[visit.node];
    if (rounds_[visit.node]) {
      each_state([&](std::size_t s) {
        bound_[s] += std::abs(g[s]) * rounding<tag()>(value[s], underflow_);
      });
    }
    const auto send = [](Flow flow, States& to, auto&& by) {
      if (flow == Flow::set) each_state([&](std::size_t s) { to[s] = by(s); });
      if (flow == Flow::add) each_state([&](std::size_t s) { to[s] += by(s); });
    };
    // One operand after the other, because both may be the same node.
    send(visit.a, ga, [&](std::size_t s) { return g[s] * slopes<tag()>(a[s], b[s], value[s]).a; });
    send(visit.b, gb, [&](std::size_t s) { return g[s] * slopes<tag()>(a[s], b[s], value[s]).b; });
  });
}

void ErrorPropagation::sample(std::uint64_t seed) {
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Node& node = graph_.nodes()[i];
    with_operation(node.op, [&](auto tag) {
      const States &a = values_[left(node)], &b = values_[right(node)], &value = values_[i];
      const States &ea = samples_[left(node)], &eb = samples_[right(node)];
      const std::uint64_t signs = mix(seed + i * 0x9E3779B97F4A7C15U);
      const double weight = rounds_[i] ? 1 : 0;
      each_state([&](std::size_t s) {
        const Slopes slope = slopes<tag()>(a[s], b[s], value[s]);
        const double sign = (signs >> s & 1U) != 0 ? weight : -weight;
        samples_[i][s] =
            ea[s] * slope.a + eb[s] * slope.b + sign * rounding<tag()>(value[s], underflow_);
      });
    });
  }
}

}  // namespace treeline::bounds
