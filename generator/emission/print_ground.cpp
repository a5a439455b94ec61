#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "core/emitted_limits.hpp"
#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/body_steps.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"
#include "passes/count_operations.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

/// What stands for places in the arguments of the robot's functions.
void add_ground_arrays(const EmissionContext& context, Adaptation& own) {
  const bool references = backend_of(context.language).has_references;
  for (const char* word : {"Coordinate", "Velocity", "Height"}) {
    const std::string passed = references ? fmt::format("{}Array&", word) : own.words["real"] + "*";
    const std::string plural =
        std::string_view(word) == "Velocity" ? "Velocities" : std::string(word) + "s";
    own.words["Tl" + plural + "In"] = "const " + passed;
    own.words["Tl" + plural + "Out"] = passed;
  }
}

/// Numbers of the contact solver: to twelve digits up to eight contacts, to eight with more, as
/// those of the simulation.
void add_solver_numbers(const EmissionContext& context, Adaptation& own) {
  const bool single = context.single_precision;
  add_literals(context,
               {{"TL_HALF", "0.5"},
                {"TL_TWO", "2.0"},
                {"TL_ROUNDING", single ? "0x1p-23" : "0x1p-52"},
                {"TL_CONTACT_TOLERANCE", single ? "1e-5" : "1e-12"},
                {"TL_TOLERANCE_OF_MANY", single ? "1e-5" : "1e-8"},
                {"TL_CONTACT_SHIFT", single ? "1e-5" : "1e-12"},
                {"TL_LARGEST_FRICTION", single ? "1e3" : "1e6"}},
               own);
  own.words["TL_FEW_CONTACTS"] = "8";
}

Adaptation adapt_ground(const EmissionContext& context) {
  Adaptation own = make_adaptation(context, context.name + "_ground.h");
  for (const char* type : {"Ground", "GroundMemory", "GroundReport"}) {
    own.words[fmt::format("Tl{}", type)] = fmt::format("{}_{}", context.name, in_snake_case(type));
  }
  own.words["TL_INLINE"] = "static inline";
  own.words["TL_FUNCTION"] = "static";
  own.words["TL_AS_REAL"] =
      fmt::format(fmt::runtime(backend_of(context.language).cast), own.words["real"]);
  add_ground_arrays(context, own);
  add_solver_numbers(context, own);
  return own;
}

/// The call of a function, whose results are members of `into`.
std::string print_ground_call(const EmissionContext& context, const Program& program,
                              const std::string& into = {}) {
  const std::string list = join_arguments(program, [&](const Argument& argument, const char* kind) {
    return (*kind == '\0' ? into : "") + argument.name;
  });
  return print_own_call(context, program, list);
}

/// C++ has references to arrays, and sines by references.
std::string print_ground_arrays(const EmissionContext& context) {
  if (!backend_of(context.language).has_references) return {};
  return "using CoordinateArray = real[TL_GROUND_COORDINATES];\n"
         "using VelocityArray = real[TL_GROUND_VELOCITIES];\n"
         "using HeightArray = real[4 * TL_GROUND_GROUPS];\n\n"
         "TL_INLINE void tl_sin_cos_of(real x, real* sine, real* cosine) {\n"
         "  sin_cos(x, *sine, *cosine);\n}\n";
}

std::string print_ground_robot(const EmissionContext& context, const GroundUnit& unit,
                               const Adaptation& own) {
  return adapt(fill_template(templates::kGroundOfRobot,
                             {{"name", context.name},
                              {"constants", print_ground_sizes(unit, own)},
                              {"tables", print_ground_tables(context, unit)},
                              {"arrays", print_ground_arrays(context)},
                              {"dynamics", print_ground_call(context, unit.dynamics, "at->")},
                              {"heights", print_ground_call(context, unit.heights)},
                              {"energy", print_ground_call(context, unit.energy)},
                              {"flight", print_ground_call(context, unit.flight)}}),
               own);
}

std::string print_ground_source(const EmissionContext& context, const GroundUnit& unit,
                                const Adaptation& own) {
  const bool scoped = backend_of(context.language).has_namespaces;
  const Syntax syntax = backend_of(context.language).syntax(context);
  return adapt_words(
      fill_template(templates::kGroundSource, {{"name", context.name},
                                               {"real", number_type(context)},
                                               {"in", scoped ? context.name + "::detail::" : ""},
                                               {"friction", syntax.literal(unit.friction)},
                                               {"coordinates", std::to_string(unit.coordinates)},
                                               {"velocities", std::to_string(unit.before.size())},
                                               {"section", print_section_macro(context)},
                                               {"code_section", print_section(context)}}),
      own);
}

std::string list_ground_shapes(const GroundUnit& unit) {
  std::vector<std::string> names;
  for (const GroundUnit::Group& group : unit.groups) names.push_back(printable(group.links));
  return fmt::format("What has shapes: {}.", fmt::join(names, "; "));
}

/// Numbers on the stack: the solver's two matrices, that of all contacts, and what the velocities
/// take part in.
int count_ground_stack(const GroundUnit& unit) {
  constexpr int kOfAContact = 60;
  const int contacts = count_ground_contacts(unit);
  const int rows = core::in_eights(3 * contacts);
  const int velocities = static_cast<int>(unit.before.size());
  return 2 * rows * rows + 9 * contacts * contacts + contacts * (6 * velocities + kOfAContact) +
         velocities * velocities;
}

std::string describe_ground_cost(const EmissionContext& context, const GroundUnit& unit) {
  std::string text;
  for (const Program* const program : unit.programs()) {
    text += fmt::format("{}{} {} flops", text.empty() ? "" : ", ", program->name,
                        count_operations(*program).flops());
  }
  return fmt::format(
      "Cost: {}. In flight the first two are called; near the ground all, the last "
      "three to six times, and the contact solver. Stack, an estimate: {} KB.",
      text, count_ground_stack(unit) * number_bytes(context) / 1000);
}

std::string list_ground_files(const EmissionContext& context, const GroundUnit& unit) {
  const Backend& backend = backend_of(context.language);
  std::vector<std::string> sources = {kGroundStem + std::string(backend.source)};
  for (const Program* const program : unit.programs()) {
    sources.push_back(program->name + std::string(backend.source));
  }
  return fmt::format("Files to compile, as {}: {}. No other source of this folder is needed.",
                     backend.standard, fmt::join(sources, ", "));
}

std::string print_ground_header(const EmissionContext& context, const GroundUnit& unit) {
  const int contacts = count_ground_contacts(unit);
  return fill_template(templates::kGroundHeader,
                       {{"robot", in_comment(printable(context.robot))},
                        {"name", context.name},
                        {"real", number_type(context)},
                        {"contacts", std::to_string(contacts)},
                        {"impulses", std::to_string(3 * contacts)},
                        {"touches", std::to_string(6 * contacts)},
                        {"coordinates", std::to_string(unit.coordinates)},
                        {"velocities", std::to_string(unit.before.size())},
                        {"shapes", in_comment(list_ground_shapes(unit))},
                        {"cost", in_comment(describe_ground_cost(context, unit))},
                        {"files", in_comment(list_ground_files(context, unit))}});
}

std::string print_contact_sizes(const EmissionContext& context, int contacts,
                                const Adaptation& own) {
  const Constant sizes[] = {
      {"CONTACTS", contacts, "the most"},
      {"CONTACT_ROWS", core::in_eights(3 * contacts), "three times that, in eights"}};
  return print_sizes(context.name, own,
                     "#pragma once\n// Sizes of the contact solver.\n\n#include "
                     "<stdint.h>\n\nTL_CONSTANTS",
                     sizes);
}

/// Headers of runtime/emitted that the step includes.
constexpr std::pair<const char*, std::string_view const*> kGroundHeaders[] = {
    {"contact_interior", &templates::kContactInterior},
    {"contact_newton", &templates::kContactNewton},
    {"contact_solver", &templates::kContactSolver},
    {"contact_sweep", &templates::kContactSweep},
    {"contact_work", &templates::kContactWork},
    {"ground_blow", &templates::kGroundBlow},
    {"ground_motion", &templates::kGroundMotion},
    {"ground_points", &templates::kGroundPoints},
    {"ground_paths", &templates::kGroundPaths},
    {"ground_step", &templates::kGroundStep}};

}  // namespace

int count_ground_contacts(const GroundUnit& unit) {
  constexpr int kOfAGroup = 4;
  constexpr int kOfAll = 16;
  return std::min(kOfAGroup * static_cast<int>(unit.groups.size()), kOfAll);
}

std::vector<GeneratedFile> print_ground(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const GroundUnit& unit = *context.ground;
  const Adaptation own = adapt_ground(context);
  const Backend& backend = backend_of(context.language);
  const std::string header(backend.header);
  std::vector<GeneratedFile> files = {
      {context.name + "_ground.h", print_ground_header(context, unit)},
      {kGroundStem + std::string(backend.source), print_ground_source(context, unit, own)},
      {"ground_functions" + header,
       print_own_functions(context, unit.programs(), kGroundStem, "the step on the ground")},
      {"ground_robot" + header, print_ground_robot(context, unit, own)},
      {"contact_sizes" + header, print_contact_sizes(context, count_ground_contacts(unit), own)}};
  for (const auto& [name, text] : kGroundHeaders)
    files.push_back({name + header, adapt(*text, own)});
  for (const Program* const program : unit.programs()) {
    files.push_back({program->name + std::string(backend.source),
                     print_own_source(context, *program, kGroundStem)});
  }
  return files;
}

}  // namespace treeline
