#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "choice/choose_functions.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emit.hpp"
#include "emission/list_sources.hpp"
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

/// Everything that `treeline generate` makes, in memory.
struct Generation : ChosenFunctions {
  Scene scene = {};  ///< in which the functions were chosen
  /// The step of the controller; only if the scene asks for one.
  std::shared_ptr<const ControllerUnit> controller = {};
  /// The controller's step and laws in the profile `plain`, for references.
  std::vector<GeneratedFile> laws = {};
  std::shared_ptr<const EmissionContext> context = {};  ///< of the files
  /// What the contract says for all functions, without marks of comments.
  std::string conventions = {};
  std::vector<GeneratedFile> files = {};
  std::vector<Source> sources = {};  ///< the files that are to be compiled
};

/// Emits all files of functions that were chosen in this scene. Returns nothing if `diagnostics`
/// received an error.
std::optional<Generation> emit_chosen(const Robot& robot, const Scene& scene,
                                      const Provenance& provenance, ChosenFunctions chosen,
                                      const TellFunction& tell, Diagnostics& diagnostics);

/// Chooses by cost and emits. The functions are not tried: `generate_tried` does that for users.
std::optional<Generation> generate_code(const Robot& robot, const Scene& scene,
                                        const Provenance& provenance, Diagnostics& diagnostics,
                                        const Choices& choices = {}, const TellFunction& tell = {});

/// Chooses the functions for a scene whose language has them, see `choose_functions`. Returns
/// nothing if `diagnostics` received an error.
std::optional<ChosenFunctions> choose_for_language(const Robot& robot, const Scene& scene,
                                                   const Choices& choices, const TellFunction& tell,
                                                   Diagnostics& diagnostics);

/// The files as a command line names them where it runs beside them, with a blank before each.
std::string list_files(const Provenance& provenance);

/// Command-line options by which the same code is generated again, with a blank before each. The
/// choices are those that the folder's own manifest records, wherever they came from.
std::string describe_options(const Provenance& provenance, const Generation& generation);

/// Emits the files of a single function, for compiling and trying it. A batch function comes with
/// the program as a plain function. The files do not mention their origin.
std::vector<GeneratedFile> emit_to_try(const Robot& robot, const Scene& scene,
                                       const Mechanism& mechanism,
                                       const GeneratedFunction& function, Diagnostics& diagnostics);

/// Emits the files once more, with NAME_selftest.
void emit_with_selftest(std::shared_ptr<const SelftestFacts> facts, Generation& generation);

}  // namespace treeline
