#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "description/scene.hpp"
#include "emission/backend/syntax.hpp"
#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Parts that a language gives to emission. A new language is a folder beside `cpp/` and `c/` that
/// defines such a value, and a line in `backend_of`.
struct Backend {
  std::string_view name;    ///< as messages call it: `C++`
  std::string_view header;  ///< how the names of its headers end: `.hpp`
  std::string_view source;  ///< `.cpp`

  /// Reports what is asked for and cannot be had in this language.
  void (*refuse)(const EmissionContext& context, Diagnostics& diagnostics);
  /// Names that functions must not have, since the generated code uses them.
  std::set<std::string> (*reserved)(const EmissionContext& context);

  /// How the bodies of plain functions are written.
  Syntax (*syntax)(const EmissionContext& context);
  /// The source file that defines the program's function.
  std::string (*print_source)(const EmissionContext& context, const Program& program);
  /// The declaration of the program's function, without its contract.
  std::string (*print_declaration)(const EmissionContext& context, const Program& program);
  /// The header NAME: where the code comes from, the order and units of joints and points, and the
  /// declaration of each function below its contract.
  std::string (*print_contract)(const EmissionContext& context, std::span<const Program> programs);
  /// The header NAME_joints: names and limits of coordinates, velocities and task rows as arrays.
  std::string (*print_joints)(const EmissionContext& context);
  /// CMakeLists.txt, which builds the folder as part of another project.
  std::string (*print_project)(const EmissionContext& context, std::span<const Program> programs,
                               std::span<const Program> batch);
  /// Further files: those that the scene asks for, and others that the language has.
  std::vector<GeneratedFile> (*print_more)(const EmissionContext& context,
                                           std::span<const Program> programs,
                                           std::span<const Program> batch);
  /// Headers of the runtime that the sources include.
  std::vector<GeneratedFile> (*print_runtime)(const EmissionContext& context,
                                              std::span<const Program> programs,
                                              std::span<const Program> batch);
};

const Backend& backend_of(Language language);

}  // namespace treeline
