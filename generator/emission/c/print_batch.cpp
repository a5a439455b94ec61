#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "emission/c/print_files.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/list_source_holes.hpp"
#include "emission/print_body.hpp"

namespace treeline::c {
namespace {

/// Vectors as wide as the states are many need GCC or Clang.
bool has_vectors(const EmissionContext& context) {
  return context.asks_for_lanes && context.lanes > 1;
}

std::string head_of(const EmissionContext& context, const Program& program, const char* suffix) {
  const std::string list =
      join_arguments(program, [&](const Argument& argument, const char* qualifier) {
        return print_array(context, qualifier, argument.name + suffix,
                           argument.rows * argument.cols * context.batch);
      });
  return fmt::format("void {}_batch_{}({})", context.name, program.name, list);
}

std::set<std::string> find_taken(const EmissionContext& context, const Program& program) {
  std::set<std::string> taken = {context.name};
  for (const char* own : {"states", "row", "sin_cos", "sin_cos_of", "sin_cos_states"}) {
    taken.insert(fmt::format("{}_{}", context.name, own));
  }
  for (const std::string& prefix : {std::string("batch_"), std::string("state_of_")}) {
    taken.insert(fmt::format("{}_{}{}", context.name, prefix, program.name));
  }
  for (const Argument& argument : program.arguments) taken.insert(argument.name + "_rows");
  for (const Result& result : program.results) taken.insert(result.argument.name + "_rows");
  return find_taken_names(program, taken);
}

/// The arguments as arrays of vectors, and the statements of the scalar function with them.
std::string print_in_vectors(const EmissionContext& context, const Program& program) {
  std::string text;
  for (const Argument& argument : program.arguments) {
    if (!reads(program, argument)) continue;
    text += fmt::format("  const {0}_row* const {1} = (const {0}_row*){1}_rows;\n", context.name,
                        argument.name);
  }
  for (const Result& result : program.results) {
    text += fmt::format("  {0}_row* const {1} = ({0}_row*){1}_rows;\n", context.name,
                        result.argument.name);
  }
  return text + print_body(program, make_states_syntax(context), find_taken(context, program));
}

/// A function of one state, which a loop calls.
std::string print_state_function(const EmissionContext& context, const Program& program) {
  std::string list;
  const auto append = [&](const Argument& argument, const char* qualifier) {
    list += (list.empty() ? "" : ", ") +
            print_array(context, qualifier, argument.name, argument.rows * argument.cols);
  };
  for (const Argument& argument : program.arguments) {
    if (reads(program, argument)) append(argument, "const ");
  }
  for (const Result& result : program.results) append(result.argument, "");
  const std::string head =
      fmt::format("static void {}_state_of_{}({}) {{", context.name, program.name, list);
  return wrap_line(head, 0) +
         print_body(program, make_syntax(context), find_taken(context, program)) + "}\n\n";
}

std::string print_loop(const EmissionContext& context, const Program& program) {
  const std::string states = name_in_capitals(context) + "_STATES";
  const OneState one =
      print_one_state(context, program, {"{}_rows[(i * " + states + ") + k]", "int"}, Passed::read);
  return fmt::format(
      "  for (int k = 0; k < {}; ++k) {{\n{}{}{}{}  }}\n", states, one.arrays, one.before,
      wrap_line(fmt::format("{}_state_of_{}({});", context.name, program.name, one.arguments), 4),
      one.behind);
}

std::string print_batch_source(const EmissionContext& context, const Program& program) {
  const bool vectors = has_vectors(context);
  std::string includes;
  if (vectors) includes = "#include \"states.h\"\n";
  if (!vectors && uses_trigonometry(program)) includes = "#include \"sin_cos.h\"\n";
  auto holes = list_source_holes(context, program, head_of(context, program, "_rows"));
  holes.insert(
      {{"states", std::to_string(context.batch)},
       {"includes", includes},
       {"before", vectors ? "" : print_state_function(context, program)},
       {"unread", print_unread(program, "_rows")},
       {"body", vectors ? print_in_vectors(context, program) : print_loop(context, program)}});
  return fill_template(templates::kBatchFunction, holes);
}

/// The header that the sources include where they have vectors.
GeneratedFile print_states_header(const EmissionContext& context, bool sines) {
  const int size = number_bytes(context);
  const std::string of_states =
      fill_template(templates::kSinCosStates, {{"name", context.name},
                                               {"real", number_type(context)},
                                               {"states", std::to_string(context.batch)}});
  return {"states.h",
          fill_template(templates::kStates, {{"name", context.name},
                                             {"real", number_type(context)},
                                             {"size", std::to_string(size)},
                                             {"bytes", std::to_string(size * context.batch)},
                                             {"sin_cos", sines ? "#include \"sin_cos.h\"\n\n" : ""},
                                             {"of_states", sines ? of_states : ""}})};
}

GeneratedFile print_batch_header(const EmissionContext& context,
                                 std::span<const Program> programs) {
  std::string declarations;
  for (const Program& program : programs) {
    declarations += comment("///", describe_method(program) +
                                       describe_rounding(context, "batch_" + program.name)) +
                    wrap_line(head_of(context, program, "") + ";", 0);
  }
  declarations.pop_back();
  return {context.name + "_batch.h",
          fill_template(templates::kBatch,
                        {{"robot", context.robot},
                         {"name", context.name},
                         {"NAME", name_in_capitals(context)},
                         {"states", std::to_string(context.batch)},
                         {"note", has_vectors(context)
                                      ? " At -O0 GCC may copy states by memcpy where the target\n"
                                        "// has no floating-point unit."
                                      : ""},
                         {"declarations", declarations}})};
}

}  // namespace

std::vector<GeneratedFile> print_batch(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const auto& programs = contents.batch;
  std::vector<GeneratedFile> files = {print_batch_header(context, programs)};
  for (const Program& program : programs) {
    files.push_back({"batch_" + program.name + ".c", print_batch_source(context, program)});
  }
  if (has_vectors(context)) {
    const bool sines = std::any_of(programs.begin(), programs.end(), uses_trigonometry);
    files.push_back(print_states_header(context, sines));
  }
  return files;
}

}  // namespace treeline::c
