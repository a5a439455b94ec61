#include "emission/print_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "emission/comment.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_body.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"
#include "emission/wrap_line.hpp"
#include "passes/count_operations.hpp"
#include "passes/rebuild.hpp"

namespace treeline {
namespace {

std::string parameter(const Argument& argument, const char* qualifier, const std::string& name) {
  return fmt::format("{}Real (&{})[{}]", qualifier, name, argument.rows * argument.cols);
}

/// The definition's head: restrict-qualified, and without names for arguments that the function
/// does not read.
std::string print_head(const Program& program) {
  std::string list;
  for (const Argument& argument : program.arguments) {
    list += (list.empty() ? "" : ", ") + parameter(argument, "const ",
                                                   reads(program, argument)
                                                       ? "TREELINE_RESTRICT " + argument.name
                                                       : "/*" + argument.name + "*/");
  }
  for (const Result& result : program.results) {
    list += (list.empty() ? "" : ", ") +
            parameter(result.argument, "", "TREELINE_RESTRICT " + result.argument.name);
  }
  return fmt::format("void {}({}) noexcept", program.name, list);
}

std::string print_includes(const Program& program) {
  std::string includes = uses_lanes(program) ? "#include \"lanes.hpp\"\n" : "";
  includes += uses_trigonometry(program) ? "#include \"sin_cos.hpp\"\n" : "";
  if (!includes.empty()) {
    includes.pop_back();
  }
  return includes;
}

std::string print_lanes_type(const Program& program) {
  return uses_lanes(program) ? "template <int count>\nusing Lanes = detail::Pack<Real, count>;\n"
                             : "";
}

}  // namespace

std::string print_declaration(const Program& program) {
  std::string list;
  for (const Argument& argument : program.arguments) {
    list += (list.empty() ? "" : ", ") + parameter(argument, "const ", argument.name);
  }
  for (const Result& result : program.results) {
    list += (list.empty() ? "" : ", ") + parameter(result.argument, "", result.argument.name);
  }
  return wrap_line(fmt::format("void {}({}) noexcept;", program.name, list), 0);
}

std::string print_source(const EmissionContext& context, const Program& program) {
  return fill_template(
      templates::kFunction,
      {{"head", describe_source(program)},
       {"cost", describe_cost(program)},
       {"name", context.name},
       {"optimize", print_optimize(program)},
       {"includes", print_includes(program)},
       {"lanes", print_lanes_type(program)},
       {"section", print_section_macro(context)},
       {"signature", print_section(context) + wrap_line(print_head(program) + " {", 0)},
       {"body",
        print_body(program, context.single_precision, find_taken_names(context, program))}});
}

bool is_long(const Program& program) {
  constexpr int kLong = 12000;
  return count_operations(program).flops() > kLong;
}

std::string print_optimize(const Program& program) {
  // Of a chain of 60 joints g++ 12 compiles Lambda^-1 (25000 operations) in 200 s with these passes
  // and in 17 s without, M (27000) in 48 and 28 s, to 5 % more code.
  return is_long(program) ? std::string() : std::string(templates::kOptimize);
}

bool reads(const Program& program, const Argument& argument) {
  return std::any_of(
      program.graph.inputs().begin(), program.graph.inputs().end(),
      [&](const std::string& input) { return input.starts_with(argument.name + "["); });
}

std::set<std::string> find_taken_names(const EmissionContext& context, const Program& program) {
  std::set<std::string> taken = {"Real",         "Lanes",       "detail",
                                 "kCoordinates", "kVelocities", "kTaskRows"};
  taken.insert(context.name);
  taken.insert(program.name);
  for (const char* array : {"angles", "sines", "cosines"}) {
    taken.insert(array);
    for (int i = 2; i < 100; ++i) {
      taken.insert(array + std::to_string(i));
    }
  }
  for (const Argument& argument : program.arguments) {
    taken.insert(argument.name);
  }
  for (const Result& result : program.results) {
    taken.insert(result.argument.name);
  }
  return taken;
}

bool uses_lanes(const Program& program) {
  return !program.packs.empty();
}

bool uses_trigonometry(const Program& program) {
  return count_operations(program).sin_cos > 0;
}

std::string describe_cost(const Program& program) {
  const OperationCount count = count_operations(program);
  std::string text = fmt::format("{} flops (add {}, mul {}, div {})", count.flops(), count.add,
                                 count.mul, count.div);
  if (count.sin_cos > 0) {
    text += fmt::format(", sine and cosine of {} angle{}", count.sin_cos,
                        count.sin_cos == 1 ? "" : "s");
  }
  return text;
}

int count_live_values(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  std::vector<std::size_t> last_use(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int operands = operation(nodes[i].op).operands;
    if (operands >= 1) {
      last_use[nodes[i].a] = i;
    }
    if (operands == 2) {
      last_use[nodes[i].b] = i;
    }
  }
  std::vector<int> dying(nodes.size(), 0);
  int live = 0;
  int most = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (operation(nodes[i].op).operands > 0 && last_use[i] > i) {
      ++live;
      ++dying[last_use[i]];
    }
    most = std::max(most, live);
    live -= dying[i];
  }
  return most;
}

}  // namespace treeline
