#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bounds/bound_rounding.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emit.hpp"
#include "emission/list_sources.hpp"
#include "generation/choices.hpp"
#include "generation/run_routes.hpp"
#include "mechanism/mechanism.hpp"
#include "passes/choose.hpp"
#include "passes/run_passes.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Origin of the inputs, for contract and digests. Names have no directories, but those of robots
/// that the scene lists, which are relative to it. Without a scene its name is empty, and where the
/// scene lists robots that of the URDF.
struct Provenance {
  std::string urdf_name, urdf_text;
  std::string scene_name, scene_text;
  std::string options = {};  ///< command-line options that override the scene: " --real float"
  struct File {
    std::string name, text;
  };
  std::vector<File> robots = {};  ///< URDFs of the robots that the scene lists, each once
};

/// The files in the order in which the contract names them: URDF and scene, or the scene and the
/// URDFs that it lists. A scene that is not there has no name.
std::vector<Provenance::File> list_inputs(const Provenance& provenance);

/// One emitted function: the chosen route, the cost of the others, and the effect of the passes.
struct GeneratedFunction {
  Function function{};
  Program program;  ///< in the order of emission
  Cost chosen;
  std::vector<Cost> rejected;
  std::vector<PassReport> passes;
  int other_lanes = 0;     ///< number of lanes if it is chosen to differ from the scene's
  int batch = 0;           ///< states per call; 0: a plain function of one state
  RoundingBound rounding;  ///< within `Generation::domain`
};

/// Converts a candidate of `run_routes` to an emitted function, except for the order of its
/// operations.
GeneratedFunction generated_from(Function function, Program candidate,
                                 const OperationCosts& costs = {});

/// Name of the function's source file without `.cpp`; of the batch function if `batch` is not 0.
std::string source_stem(Function function, int batch);
std::string source_stem(const GeneratedFunction& generated);

/// Whether the function is `damped_control_torque`, a header without a source file that calls other
/// functions.
bool is_composed(const GeneratedFunction& generated);

/// Number of results that the function writes to its arguments: a composed one returns the last.
std::size_t count_written(const GeneratedFunction& generated);

/// Everything that `treeline generate` makes, in memory.
struct Generation {
  Domain domain;        ///< domain of the rounding bounds
  Mechanism mechanism;  ///< with everything in the scene; see `FunctionMechanisms`
  std::vector<GeneratedFunction> functions;
  std::vector<GeneratedFunction>
      batch;  ///< functions for `Scene::batch` states, if the scene asks for them
  std::optional<GeneratedFunction> damped;  ///< see `compose_damped`; only if the scene asks for it
  std::shared_ptr<const ControllerUnit> controller;  ///< only if the scene asks for one
  std::vector<GeneratedFile> laws;  ///< its step and laws in the profile `plain`, for references
  std::shared_ptr<const EmissionContext> context;  ///< of the files
  std::string conventions;  ///< what the contract says for all functions, without marks of comments
  std::vector<GeneratedFile> files;
  std::vector<Source> sources;  ///< those of the files that are to be compiled
};

/// Receives the function that is being generated: `lambda (10 of 11)`.
using TellFunction = std::function<void(const std::string& function)>;

/// Generates all files for a robot in a scene: reduces the mechanism, traces every route of every
/// requested function, chooses, runs the passes, and emits. `choices` override the choice by cost.
/// Returns nothing if `diagnostics` received an error.
std::optional<Generation> generate_code(const Robot& robot, const Scene& scene,
                                        const Provenance& provenance, Diagnostics& diagnostics,
                                        const Choices& choices = {}, const TellFunction& tell = {});

/// Emits the files of a single function, for compiling and trying it. A batch function comes with
/// the program as a plain function. The files do not mention their origin.
std::vector<GeneratedFile> emit_to_try(const Robot& robot, const Scene& scene,
                                       const Mechanism& mechanism,
                                       const GeneratedFunction& function, Diagnostics& diagnostics);

/// Emits the files once more, with NAME_selftest.
void emit_with_selftest(std::shared_ptr<const SelftestFacts> facts, Generation& generation);

/// The programs of functions, in their order.
std::vector<Program> programs_of(const std::vector<GeneratedFunction>& functions);

/// Describes the ranges of inputs within which the rounding bounds hold; empty if there are no
/// bounds.
std::string describe_domain(const Generation& generation);

/// Lists the plain functions, then the batch functions in the same order.
std::vector<GeneratedFunction> all_functions(const Generation& generation);

/// Lists all functions that can be called: plain, batch, and composed ones.
std::vector<GeneratedFunction> all_callable(const Generation& generation);

/// Generates one function by the route that is cheapest after the passes.
GeneratedFunction generate_function(const Mechanism& mechanism, Function function,
                                    const RouteOptions& options);

/// Generates one function by the route of that key (or of those words, which earlier manifests
/// keep), like a candidate of `run_routes`. Returns nothing if there is no such route.
std::optional<GeneratedFunction> generate_chosen(const Mechanism& mechanism, Function function,
                                                 const std::string& route, RouteOptions options);

}  // namespace treeline
