#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "core/sin_cos.hpp"
#include "program/program.hpp"

namespace treeline {

/// Place of an input of the graph among the arguments of its program.
struct InputPlace {
  std::size_t argument = 0;
  std::size_t element = 0;
};

/// Returns the place of each of `program.graph.inputs()`, read from their names
/// `argument[element]`. Throws std::logic_error if a name has another form or is not an element of
/// an argument.
std::vector<InputPlace> locate_inputs(const Program& program);

namespace detail {

template <class Scalar>
inline constexpr bool kIsEmitted = std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double>;

/// Sine of `x` (rad). For float and double as emitted code computes it, for other types by the
/// type's own function.
template <class Scalar>
Scalar sine(const Scalar& x) {
  if constexpr (kIsEmitted<Scalar>) {
    Scalar s = 0;
    Scalar c = 0;
    core::sin_cos(x, s, c);
    return s;
  } else {
    using std::sin;
    return sin(x);
  }
}

template <class Scalar>
Scalar cosine(const Scalar& x) {
  if constexpr (kIsEmitted<Scalar>) {
    Scalar s = 0;
    Scalar c = 0;
    core::sin_cos(x, s, c);
    return c;
  } else {
    using std::cos;
    return cos(x);
  }
}

}  // namespace detail

/// Value of one node, given the values of all earlier nodes. Constants are rounded to Scalar, as in
/// emitted code.
template <class Scalar>
Scalar evaluate_node(const Node& node, const std::vector<Scalar>& values,
                     const std::vector<Scalar>& inputs) {
  switch (node.op) {
    case Op::constant:
      return static_cast<Scalar>(node.value);
    case Op::input:
      return inputs[node.a];
    case Op::add:
      return values[node.a] + values[node.b];
    case Op::sub:
      return values[node.a] - values[node.b];
    case Op::mul:
      return values[node.a] * values[node.b];
    case Op::div:
      return values[node.a] / values[node.b];
    case Op::neg:
      return -values[node.a];
    case Op::sin:
      return detail::sine(values[node.a]);
    case Op::cos:
      return detail::cosine(values[node.a]);
  }
  throw std::logic_error("an operation without a rule to evaluate it");
}

/// Evaluates the nodes in order and returns the program's results, in their order, each row-major.
/// `arguments` has one vector for each of `program.arguments`, with rows * cols elements. Emitted
/// code performs the same operations in the same way, so for Scalar = Real the two agree to the bit
/// if the compiler does not contract products and sums.
template <class Scalar>
std::vector<std::vector<Scalar>> evaluate(const Program& program,
                                          const std::vector<std::vector<Scalar>>& arguments) {
  std::vector<Scalar> inputs;
  for (const InputPlace& place : locate_inputs(program)) {
    inputs.push_back(arguments.at(place.argument).at(place.element));
  }
  std::vector<Scalar> values;
  values.reserve(program.graph.nodes().size());
  for (const Node& node : program.graph.nodes()) {
    values.push_back(evaluate_node(node, values, inputs));
  }
  std::vector<std::vector<Scalar>> results;
  for (const Result& result : program.results) {
    std::vector<Scalar>& elements = results.emplace_back();
    for (const Expression& value : result.values) {
      elements.push_back(value.negative() ? Scalar(-values[value.node()]) : values[value.node()]);
    }
  }
  return results;
}

// Compiled once, in the library, and optimised there whatever the flags of those who call them.
extern template float evaluate_node(const Node&, const std::vector<float>&,
                                    const std::vector<float>&);
extern template double evaluate_node(const Node&, const std::vector<double>&,
                                     const std::vector<double>&);
extern template std::vector<std::vector<float>> evaluate(const Program&,
                                                         const std::vector<std::vector<float>>&);
extern template std::vector<std::vector<double>> evaluate(const Program&,
                                                          const std::vector<std::vector<double>>&);
extern template std::vector<std::vector<long double>> evaluate(
    const Program&, const std::vector<std::vector<long double>>&);

}  // namespace treeline
