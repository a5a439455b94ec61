#pragma once

#include <string>
#include <vector>

#include "emission/controller_unit.hpp"
#include "emission/emission_context.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// A value of a unit of FMI. Values stand in the order of their references.
struct FmuVariable {
  std::string name;
  std::string attributes;  ///< causality, variability, initial
  std::string meaning;
  std::string unit;
  std::string start = {};         ///< empty: computed
  std::size_t derivative_of = 0;  ///< number of a state, from 1; 0: of none
};

// Attributes of what a unit gives, as lists of unknowns know them.
inline constexpr const char* kFmuState =
    R"(causality="output" variability="continuous" initial="exact")";
inline constexpr const char* kFmuResult =
    R"(causality="output" variability="continuous" initial="calculated")";
inline constexpr const char* kFmuStepped =
    R"(causality="output" variability="discrete" initial="calculated")";

/// The longest step of the integration inside a unit, s.
inline constexpr const char* kFmuStep = "0.001";

/// Values of the robot that `forward_dynamics`, of that program, moves: q, qd, inputs, `step`,
/// dq/dt, qdd.
std::vector<FmuVariable> list_fmu_variables(const EmissionContext& context, const Program& program);

/// Values of a controller, and the members of its structs that they are, as entries of a table in
/// C.
struct FmuController {
  std::vector<FmuVariable> inputs, outputs;
  std::string input_members, output_members;
};
FmuController list_fmu_controller(const EmissionContext& context, const ControllerUnit& unit);

}  // namespace treeline
