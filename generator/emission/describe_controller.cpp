#include "emission/describe_controller.hpp"

#include <algorithm>

#include "emission/controller_unit.hpp"
#include "emission/count_stack.hpp"

namespace treeline {

std::vector<std::string> list_controller_sources(const ControllerUnit& unit) {
  std::vector<std::string> sources = {"controller.cpp"};
  for (const Program* const program : unit.programs()) sources.push_back(program->name + ".cpp");
  return sources;
}

std::size_t count_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number) {
  constexpr std::size_t kOfAJoint = 12;  // measured, sines, gravity, references, accelerations
  constexpr std::size_t kOfAPoint = 18;  // pose and velocity
  constexpr std::size_t kOfTheLaw = 80;  // motion of the point at work, its errors
  std::size_t values = 0;
  for (const Program* const program : unit.programs()) {
    values = std::max(values, count_stack_values(*program, misra));
  }
  values += kOfAJoint * unit.joints.size();
  if (!unit.points.empty()) values += (kOfAPoint * unit.points.size()) + kOfTheLaw;
  return values * static_cast<std::size_t>(bytes_of_number);
}

}  // namespace treeline
