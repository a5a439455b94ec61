#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/add_on.hpp"
#include "emission/syntax.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// How a language writes integers that have names.
struct ConstantSyntax {
  std::string_view opening;        ///< before the first
  std::string_view line;           ///< as a format of name and value
  std::string_view between, last;  ///< behind each but the last, and behind that
  std::string_view closing;
};

/// Parts that a language gives to emission. A new language is a folder beside `cpp/` and `c/` that
/// defines such a value, and a line in `languages/backend_of.cpp`.
struct Backend {
  std::string_view name;                ///< as messages call it: `C++`
  std::string_view standard;            ///< `C++17`
  std::string_view header;              ///< how the names of its headers end: `.hpp`
  std::string_view source;              ///< `.cpp`
  std::string_view cmake;               ///< as CMake calls it: `CXX`
  std::string_view feature;             ///< of CMake, which asks for the standard: `cxx_std_17`
  std::string_view flag;                ///< of compilers, the same: `-std=c++17`
  bool has_namespaces = false;          ///< else names have the robot's in front
  std::string_view scope;               ///< between the robot's name and its names: `::`
  std::string_view details;             ///< before names that its functions use: `detail::`
  bool has_references = false;          ///< to arrays; else arguments are pointers
  std::string_view cast;                ///< to a type, as a format: `static_cast<{}>`
  std::string_view constant = "const";  ///< before a constant at file scope
  ConstantSyntax constants;
  /// Whether what calls other functions, as damped control, is code of a header.
  bool composes_in_headers = false;
  /// Words of runtime/emitted as the language has them (see `Adaptation`).
  std::map<std::string, std::string> words;
  /// How lines of runtime/emitted begin that it does without.
  std::vector<std::string_view> known;
  /// Whether functions that loop share the loops only as one source.
  bool joins_loops = false;
  /// Places of sources in the project; of all others 0.
  std::map<Source::Of, int> places;

  /// Whether the driver of a device compiles it, when a program runs: no compiler of the host knows
  /// it, so there is no project and no package.
  [[nodiscard]] bool is_compiled_by_driver() const { return flag.empty(); }

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
  /// All that a folder may have beside these.
  std::span<const AddOn> add_ons;
};

const Backend& backend_of(Language language);

/// Names of files in the context's language: `square_root.hpp`, `gravity.cpp`.
std::string header_name(const EmissionContext& context, const std::string& stem);
std::string source_name(Language language, const std::string& stem);

}  // namespace treeline
