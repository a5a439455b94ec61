#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "choice/choices.hpp"
#include "choice/function_mechanisms.hpp"
#include "choice/generated_function.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The functions of a scene, each by the algorithm that was chosen for it.
struct ChosenFunctions {
  Domain domain;        ///< domain of the rounding bounds
  Mechanism mechanism;  ///< with everything in the scene; see `FunctionMechanisms`
  std::vector<GeneratedFunction> functions;
  std::vector<GeneratedFunction>
      batch;  ///< functions for `Scene::batch` states, if the scene asks for them
  std::optional<GeneratedFunction> damped;  ///< see `compose_damped`; only if the scene asks for it
  Choices choices;                          ///< choices that were made in advance
};

/// Receives the function that is being generated: `lambda (10 of 11)`.
using TellFunction = std::function<void(const std::string& function)>;

/// Traces every route of every function that the scene asks for, chooses, and runs the passes.
/// `mechanisms` are those of the robot in the scene. `choices` override the choice by cost. Nothing
/// if `diagnostics` received an error: a route that is chosen is none of this robot's.
std::optional<ChosenFunctions> choose_functions(const Robot& robot, const Scene& scene,
                                                FunctionMechanisms& mechanisms,
                                                const Choices& choices, const TellFunction& tell,
                                                Diagnostics& diagnostics);

/// Reduces the mechanism first, then chooses likewise.
std::optional<ChosenFunctions> choose_functions(const Robot& robot, const Scene& scene,
                                                const Choices& choices, Diagnostics& diagnostics);

/// Half an ulp of one.
double rounding_unit(Real real);

/// The programs of functions, in their order.
std::vector<Program> programs_of(const std::vector<GeneratedFunction>& functions);

/// Describes the ranges of inputs within which the rounding bounds hold; empty if there are no
/// bounds.
std::string describe_domain(const ChosenFunctions& chosen);

/// Lists the plain functions, then the batch functions in the same order.
std::vector<GeneratedFunction> all_functions(const ChosenFunctions& chosen);

/// Lists all functions that can be called: plain, batch, and composed ones.
std::vector<GeneratedFunction> all_callable(const ChosenFunctions& chosen);

}  // namespace treeline
