#include <algorithm>
#include <utility>
#include <vector>

#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

/// The arguments of several functions, each once, joints before what is constant.
std::vector<Argument> list_once(const std::vector<Argument>& arguments) {
  std::vector<Argument> once;
  for (const Quantity quantity : {Quantity::q, Quantity::qd}) {
    for (const Argument& argument : arguments) {
      if (argument.name != symbol_of(quantity)) continue;
      once.push_back(argument);
      break;
    }
  }
  for (const Argument& argument : arguments) {
    if (std::none_of(once.begin(), once.end(),
                     [&](const Argument& listed) { return listed.name == argument.name; })) {
      once.push_back(argument);
    }
  }
  return once;
}

}  // namespace

Program trace_together(const Mechanism& mechanism, std::span<const Function> functions, int lanes) {
  Program program;
  program.graph = Graph::for_trace(lanes);
  const Graph::Scope scope(program.graph);
  Trace trace = begin_trace(mechanism);
  std::vector<TracedInputs> inputs;
  for (const Function function : functions) {
    inputs.emplace_back(mechanism, function, program);
    apply_inputs(mechanism, inputs.back(), trace.tree);
  }
  program.arguments = list_once(program.arguments);
  trace.in = inputs.front();
  find_transforms(trace);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    trace.in = inputs[i];
    trace.in.drop(Quantity::f_ext);
    const Route route = robot_routes({functions[i], mechanism, mechanism, trace.tree}).front();
    for (Result& result : route.body(trace)) program.results.push_back(std::move(result));
  }
  return program;
}

Program trace_against_forces(const Mechanism& mechanism, int lanes) {
  Program program;
  program.graph = Graph::for_trace(lanes);
  const Graph::Scope scope(program.graph);
  Trace trace = begin_trace(mechanism);
  trace.tree.gravity = {};
  const TracedInputs inputs(mechanism, Function::inverse_dynamics, program);
  std::erase_if(program.arguments, [](const Argument& argument) {
    return argument.name != symbol_of(Quantity::q) && argument.name != symbol_of(Quantity::f_ext);
  });
  trace.in = inputs;
  find_transforms(trace);
  std::vector<Wrench<Expression>> wrenches = trace.applied();
  for (Wrench<Expression>& wrench : wrenches) wrench = Wrench<Expression>{} - wrench;
  program.results = {vector_result("tau", trace.with_unit("joint forces", Quantity::tau),
                                   inward_forces(trace.tree, trace.X, std::move(wrenches)))};
  return program;
}

}  // namespace treeline
