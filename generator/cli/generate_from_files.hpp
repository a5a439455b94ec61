#pragma once

#include <optional>

#include "cli/read_inputs.hpp"
#include "trial/generate_tried.hpp"

namespace treeline {

/// Robot, scene and what was generated from them.
struct GeneratedInputs {
  RobotAndScene inputs;  ///< the scene is that of the generation
  Generation generation;
  std::vector<FailedTrial> failed;  ///< functions beyond their bounds by every algorithm
};

/// Origin that generated code states.
Provenance provenance_of(const InputOptions& options, const RobotAndScene& inputs);

/// Reads the files of a command line and generates in memory, by the choices in `options.choices`
/// where that names a file. Faults are in `diagnostics`.
std::optional<GeneratedInputs> generate_from_files(const InputOptions& options, Failing failing,
                                                   Diagnostics& diagnostics);

/// Generates from inputs that have been read, by these choices.
std::optional<GeneratedInputs> generate_from_inputs(const InputOptions& options,
                                                    RobotAndScene inputs, const Choices& choices,
                                                    Failing failing, Diagnostics& diagnostics);

/// Warns at once, before anything is written or compiled, of much code (`warn_of_size`), of motors
/// that need a longer `speed_rise` than asked for, and of rows of a controller's points that
/// cannot be moved.
void warn_beforehand(const InputOptions& options, const GeneratedInputs& made);

}  // namespace treeline
