#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bounds/bound_rounding.hpp"
#include "description/diagnostic.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emit.hpp"
#include "generation/choices.hpp"
#include "mechanism/mechanism.hpp"
#include "passes/choose.hpp"
#include "passes/run_passes.hpp"
#include "program/program.hpp"

namespace treeline {

/// Where the inputs came from, for contract and digests. Names without directories; no scene:
/// empty.
struct Provenance {
  std::string urdf_name, urdf_text;
  std::string scene_name, scene_text;
  std::string options = {};  ///< of the command line that overrule the scene: " --real float"
};

/// One emitted function: the route that was chosen, what the others cost, what the passes did.
struct GeneratedFunction {
  Function function{};
  Program program;  ///< in the order of emission
  Cost chosen;
  std::vector<Cost> rejected;
  std::vector<PassReport> passes;
  int other_lanes = 0;     ///< lanes of the route, where they are chosen to be not the scene's
  int batch = 0;           ///< states a call; 0: the plain function of one state
  RoundingBound rounding;  ///< on `Generation::domain`
};

/// A candidate of `run_routes` as what would be emitted, but for its order.
GeneratedFunction generated_from(Function function, Program candidate);

/// What the function's source file is called, without `.cpp`; of a batch where `batch` is not 0.
std::string source_stem(Function function, int batch);
std::string source_stem(const GeneratedFunction& generated);

/// Whether the function is `damped_control_torque`: a header without a source, calling others.
bool is_composed(const GeneratedFunction& generated);

/// Everything `treeline generate` makes, in memory.
struct Generation {
  Domain domain;        ///< on which bounds of rounding errors hold
  Mechanism mechanism;  ///< with everything in the scene; see `FunctionMechanisms`
  std::vector<GeneratedFunction> functions;
  std::vector<GeneratedFunction>
      batch;  ///< the same for `Scene::batch` states, if it asks for them
  std::optional<GeneratedFunction> damped;  ///< see `compose_damped`; if the scene asks for it
  std::vector<GeneratedFile> files;
};

/// Is told which function is being generated: `lambda (10 of 11)`.
using TellFunction = std::function<void(const std::string& function)>;

/// Robot and scene to files: reduce the mechanism, trace every route of every function asked for,
/// choose, run the passes, emit. `choices` overrule the choice by cost. Nothing is returned when
/// `diagnostics` got an error.
std::optional<Generation> generate_code(const Robot& robot, const Scene& scene,
                                        const Provenance& provenance, Diagnostics& diagnostics,
                                        const Choices& choices = {}, const TellFunction& tell = {});

/// The files of one function alone, to compile and try it; of a batch with the program as a plain
/// function beside it. They say nothing of where they came from.
std::vector<GeneratedFile> emit_to_try(const Robot& robot, const Scene& scene,
                                       const Mechanism& mechanism,
                                       const GeneratedFunction& function, Diagnostics& diagnostics);

/// The ranges of inputs, in words, in which what is known of rounding errors holds; empty where
/// nothing is.
std::string describe_domain(const Generation& generation);

/// The plain functions, then those for batches in the same order.
std::vector<GeneratedFunction> all_functions(const Generation& generation);

/// These and what is composed of them: all that can be called.
std::vector<GeneratedFunction> all_callable(const Generation& generation);

/// The route to one function that is cheapest after the passes. `lanes`, `sin_cos`: see `Scene`.
GeneratedFunction generate_function(const Mechanism& mechanism, Function function, int lanes,
                                    Sines sin_cos = Sines::computed);

/// The route of that key, or of those words, as a candidate of `run_routes` at so many lanes;
/// nothing when there is none.
std::optional<GeneratedFunction> generate_chosen(const Mechanism& mechanism, Function function,
                                                 const std::string& route, int lanes,
                                                 Sines sin_cos = Sines::computed);

}  // namespace treeline
