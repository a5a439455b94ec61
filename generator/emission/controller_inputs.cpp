#include "emission/controller_inputs.hpp"

#include <algorithm>
#include <map>

namespace treeline {

std::string variable_of(const std::string& argument) {
  static const std::map<std::string, std::string> kVariables = {
      {"q", "at->q"},
      {"sin_q", "at->sin_q"},
      {"cos_q", "at->cos_q"},
      {"qd", "at->qd"},
      {"qdd", "qdd"},
      {"qdd_0", "qdd_0"},
      {"tau", "tau"},
      {"xdd_cmd", "xdd_cmd"},
      {"position", "at->position"},
      {"g", "at->gravity"},
      {"rotation", "at->rotation"},
      {"velocity", "at->velocity"},
      {"active_tasks", "state->active_tasks"}};
  const auto found = kVariables.find(argument);
  return found == kVariables.end() ? std::string() : found->second;
}

bool is_led(const std::string& argument) {
  return argument == "gravity" || argument == "payload" || argument == "parameters" ||
         argument == "base_parameters";
}

std::vector<Argument> list_inputs(const ControllerUnit& unit) {
  std::vector<Argument> inputs;
  for (const Program* const program : unit.programs()) {
    if (unit.push_torque && program == &*unit.push_torque) continue;
    for (const Argument& argument : program->arguments) {
      const bool known = !variable_of(argument.name).empty() ||
                         std::any_of(inputs.begin(), inputs.end(), [&](const Argument& listed) {
                           return listed.name == argument.name;
                         });
      if (!known) inputs.push_back(argument);
    }
  }
  return inputs;
}

}  // namespace treeline
