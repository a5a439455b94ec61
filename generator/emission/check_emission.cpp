#include "emission/check_emission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>

#include "emission/backend.hpp"
#include "passes/rebuild.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

void report(Diagnostics& diagnostics, std::string element, std::string fault, std::string remedy) {
  diagnostics.add(
      {Severity::error, "", 0, std::move(element), std::move(fault), std::move(remedy)});
}

void check_name(const std::string& name, const std::string& element, const Backend& backend,
                Diagnostics& diagnostics) {
  if (!is_identifier(name)) {
    report(diagnostics, element, fmt::format("`{}` cannot be a name in {}", name, backend.name),
           "Choose one of letters, digits and single underscores that is no keyword.");
  }
}

void check_argument(const Argument& argument, const std::string& function, const Backend& backend,
                    std::set<std::string>& names, Diagnostics& diagnostics) {
  const std::string element = function + "/" + argument.name;
  check_name(argument.name, element, backend, diagnostics);
  if (argument.rows <= 0 || argument.cols <= 0) {
    report(diagnostics, element, "the argument has no elements",
           "A robot without moving joints or a scene without rows has no such function.");
  }
  if (!names.insert(argument.name).second) {
    report(diagnostics, element, "two arguments have this name", "Rename one of them.");
  }
}

void check_nodes(const Program& program, bool single_precision, Diagnostics& diagnostics) {
  const std::vector<Node>& nodes = program.graph.nodes();
  const Marks live = find_live(program);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (live[i] && nodes[i].op == Op::div && nodes[i].b == 0) {
      report(diagnostics, program.name, "the function divides by zero whatever its input",
             "Give the links behind each joint some mass and inertia about its axis; rows that no "
             "joint moves need `singular: smooth`.");
      return;
    }
    const bool finite = single_precision ? std::isfinite(static_cast<float>(nodes[i].value))
                                         : std::isfinite(nodes[i].value);
    if (live[i] && nodes[i].op == Op::constant && !finite) {
      report(diagnostics, program.name, "a constant of the function is not finite",
             "Look for extreme masses or lengths in the robot's description.");
      return;
    }
  }
}

}  // namespace

void check_emission(const EmissionContext& context, std::span<const Program> programs,
                    Diagnostics& diagnostics) {
  const Backend& backend = backend_of(context.language);
  check_name(context.name, "name", backend, diagnostics);
  backend.refuse(context, diagnostics);
  std::set<std::string> functions = backend.reserved(context);
  for (const Program& program : programs) {
    check_name(program.name, program.name, backend, diagnostics);
    if (!functions.insert(program.name).second) {
      report(diagnostics, program.name, "this name is taken in the generated code",
             "Rename the robot in the scene (key `name`).");
    }
    std::set<std::string> arguments;
    for (const Argument& argument : program.arguments) {
      check_argument(argument, program.name, backend, arguments, diagnostics);
    }
    for (const Result& result : program.results) {
      check_argument(result.argument, program.name, backend, arguments, diagnostics);
    }
    check_nodes(program, context.single_precision, diagnostics);
  }
}

}  // namespace treeline
