#include "recursion/trace_posture.hpp"

#include "recursion/center_of_mass.hpp"
#include "recursion/late_turns.hpp"
#include "recursion/trace_parts.hpp"

namespace treeline {
std::vector<Program> trace_posture_function(const Mechanism& mechanism, Function function,
                                            int lanes) {
  std::vector<Program> programs(1);
  Program& program = programs.front();
  program.name = function_name(function);
  program.equation = info_of(function).equation;
  program.route = {"composite-moments", "first moments of the composite bodies"};
  program.graph = Graph::for_trace(lanes);
  const Graph::Scope scope(program.graph);
  const TracedInputs inputs(mechanism, function, program);
  auto tree = constant_tree<Expression>(mechanism);
  apply_inputs(mechanism, inputs, tree);
  auto X = joint_transforms<Expression>(tree, inputs[Quantity::q]);
  turn_late(tree, X);
  if (function == Function::center_of_mass) {
    const Vector3<Expression> center = center_of_mass(tree, X);
    program.results = {
        {{"com", 3, 1, "centre of mass in the world, m"}, {center.x, center.y, center.z}}};
    return programs;
  }
  program.results = {{{"J_com", 3, mechanism.nv(), "Jacobian of the centre of mass, world axes"},
                      center_of_mass_jacobian(tree, X).values()}};
  return programs;
}

}  // namespace treeline
