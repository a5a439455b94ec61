#include <fmt/format.h>

#include <set>

#include "emission/comment.hpp"
#include "emission/core_headers.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/list_source_holes.hpp"
#include "emission/print_body.hpp"

namespace treeline::cpp {
namespace {

std::string row_parameter(const Argument& argument, const char* qualifier,
                          const std::string& name) {
  return fmt::format("{}Real (&{})[{}][kStates]", qualifier, name, argument.rows * argument.cols);
}

/// `void NAME(...) noexcept`, with what `print` makes of each argument.
template <class Print>
std::string print_signature(const Program& program, Print print) {
  return fmt::format("void {}({}) noexcept", program.name, join_arguments(program, print));
}

std::string print_batch_head(const Program& program) {
  return print_signature(program, [&](const Argument& argument, const char* qualifier) {
    const bool named = *qualifier == '\0' || reads(program, argument);
    return row_parameter(argument, qualifier,
                         named ? fmt::format("TREELINE_RESTRICT {}_rows", argument.name)
                               : fmt::format("/*{}*/", argument.name));
  });
}

/// Declarations that make the scalar function's statements read and write rows.
std::string print_rows(const Program& program) {
  std::string rows;
  const auto append = [&](const char* direction, const std::string& name) {
    rows +=
        fmt::format("  const detail::States{0}<Real, kStates> {1}{{{1}_rows}};\n", direction, name);
  };
  for (const Argument& argument : program.arguments) {
    if (reads(program, argument)) append("In", argument.name);
  }
  for (const Result& result : program.results) append("Out", result.argument.name);
  rows.pop_back();
  return rows;
}

std::set<std::string> find_taken_in_batch(const EmissionContext& context, const Program& program) {
  std::set<std::string> taken = find_taken(context, program);
  taken.insert({"States", "kStates", "batch"});
  for (const Argument& argument : program.arguments) taken.insert(argument.name + "_rows");
  for (const Result& result : program.results) taken.insert(result.argument.name + "_rows");
  return taken;
}

std::string print_batch_header(const EmissionContext& context, std::span<const Program> programs) {
  std::string declarations;
  for (const Program& program : programs) {
    const std::string declaration =
        print_signature(program, [](const Argument& argument, const char* qualifier) {
          return row_parameter(argument, qualifier, argument.name);
        });
    declarations += comment("///", describe_method(program) +
                                       describe_rounding(context, "batch_" + program.name)) +
                    wrap_line(declaration + ";", 0);
  }
  declarations.pop_back();
  return fill_template(templates::kBatch, {{"robot", context.robot},
                                           {"name", context.name},
                                           {"states", std::to_string(context.batch)},
                                           {"declarations", declarations}});
}

std::string print_batch_source(const EmissionContext& context, const Program& program) {
  auto holes = list_source_holes(context, program, print_batch_head(program));
  holes.insert({{"states", std::to_string(context.batch)},
                {"rows", print_rows(program)},
                {"body", print_body(program, make_states_syntax(context),
                                    find_taken_in_batch(context, program))}});
  return fill_template(templates::kBatchFunction, holes);
}

}  // namespace

std::vector<GeneratedFile> print_batch(const Contents& contents) {
  const EmissionContext& context = contents.context;
  std::vector<GeneratedFile> files = {
      {context.name + "_batch.hpp", print_batch_header(context, contents.batch)},
      {"load_lanes.hpp", print_core_header(context, core_headers::kLoadLanes)},
      {"states.hpp", print_core_header(context, core_headers::kStates)}};
  for (const Program& program : contents.batch) {
    files.push_back({"batch_" + program.name + ".cpp", print_batch_source(context, program)});
  }
  return files;
}

}  // namespace treeline::cpp
