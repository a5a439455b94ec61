#include <fmt/format.h>

#include <map>

#include "core/emitted_limits.hpp"
#include "emission/backend.hpp"
#include "emission/c/print_files.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/print_target.hpp"

namespace treeline::c {
namespace {

using Holes = std::map<std::string, std::string>;

}  // namespace

Holes list_limit_holes(const EmissionContext& context) {
  const LimitFacts& facts = *context.limits;
  const int held = core::one_or(static_cast<int>(facts.force_weights.size()));
  const int tasks = core::one_or(context.task_rows);
  return {{"name", context.name},
          {"NAME", name_in_capitals(context)},
          {"robot", context.robot},
          {"real", number_type(context)},
          {"held", std::to_string(held)},
          {"tasks", std::to_string(tasks)},
          {"cones", std::to_string(core::one_or(static_cast<int>(facts.cones.size())))},
          {"held_entries", std::to_string(held * context.velocities)},
          {"task_entries", std::to_string(tasks * context.velocities)}};
}

namespace {

/// Form of the function: for one state, or for `states` states whose rows follow each other.
struct Form {
  const char* prefix;
  int states;
};
constexpr Form kOneState = {"", 1};

Form form_of_batch(const EmissionContext& context) {
  return {"batch_", context.batch};
}

std::string print_head(const EmissionContext& context, const Program& supported, Form form) {
  std::string list;
  const auto append = [&](const char* qualifier, const std::string& name, int size) {
    list += print_array(context, qualifier, name, size * form.states) + ", ";
  };
  for (const Argument& argument : supported.arguments) {
    append("const ", argument.name, argument.rows * argument.cols);
  }
  append("", "tau", context.velocities);
  if (holds_rows(context)) append("", "f", static_cast<int>(context.limits->force_weights.size()));
  return fmt::format(
      "void {0}_{1}limited_control_torque({2}{0}_limited_torque* limited, "
      "const {0}_torque_limits* limits)",
      context.name, form.prefix, list);
}

std::string print_call(const EmissionContext& context, const Program& program, Form form,
                       const std::string& results) {
  std::string list;
  for (const Argument& argument : program.arguments) list += argument.name + ", ";
  return fmt::format("{}_{}{}({}{});", context.name, form.prefix, program.name, list, results);
}

std::string print_zeros(const EmissionContext& context, const char* array, int size) {
  return fmt::format("for (int i = 0; i < {}; ++i) {{\n  {}[i] = {};\n}}\n", size, array,
                     number_literal(context, "0.0"));
}

std::string print_matrices(const EmissionContext& context, std::span<const Program> programs,
                           Form form) {
  std::string text;
  for (const LimitedCall& call : list_limited_calls(context, programs)) {
    text += print_call(context, *call.program, form, call.result) + "\n";
  }
  const int columns = context.velocities * form.states;
  if (!holds_rows(context)) text += print_zeros(context, "J_s", columns);
  if (context.task_rows == 0) text += print_zeros(context, "J_t", columns);
  return text;
}

GeneratedFile print_batch_limited_header(const EmissionContext& context,
                                         std::span<const Program> batch) {
  const std::string signature =
      print_head(context, find_supported(batch), form_of_batch(context)) + ";";
  return {context.name + "_batch_limited.h",
          fill_template(templates::kBatchLimited,
                        {{"robot", context.robot},
                         {"name", context.name},
                         {"states", std::to_string(context.batch)},
                         {"cost", comment("///", describe_batch_limited_cost(context, batch))},
                         {"signature", wrap_line(signature, 0)}})};
}

std::string print_layout(const EmissionContext& context) {
  return wrap_line(
      fmt::format("static const {0}_support_layout {0}_layout = {{{1}}};", context.name,
                  print_support_layout(*context.limits, make_syntax(context))),
      0);
}

/// Fills the holes in the source of limited control, for one state or for several. `no_forces`
/// declares the forces of a robot that holds no rows.
Holes list_source_holes(const EmissionContext& context, std::span<const Program> programs,
                        Form form, const std::string& no_forces) {
  const Program& supported = find_supported(programs);
  const bool holds = holds_rows(context);
  Holes holes = list_limit_holes(context);
  holes["section"] = print_section_macro(context);
  holes["layout"] = print_layout(context);
  holes["signature"] =
      print_section(context) + wrap_line(print_head(context, supported, form) + " {", 0);
  holes["supported"] =
      (holds ? "" : no_forces) + print_call(context, supported, form, holds ? "tau, f" : "tau");
  holes["matrices"] = print_matrices(context, programs, form);
  const std::string scope = context.name + "_";
  add_share_holes(context, supported,
                  {scope, scope + "support_layout", scope + "layout", false, form.states > 1},
                  holes);
  return holes;
}

std::string print_default_limits(const EmissionContext& context) {
  const Syntax syntax = make_syntax(context);
  const std::string zero = syntax.literal(0);
  const std::string no_cones = fmt::format("{{0, 0, {{{0}, {0}, {0}, {0}, {0}, {0}}}, {0}}}", zero);
  return wrap_line(
      fmt::format("const {0}_torque_limits {0}_default_limits = {{{1}}};", context.name,
                  print_torque_limits(*context.limits, syntax, syntax.literal(1e30), no_cones)),
      0);
}

GeneratedFile print_limited_header(const EmissionContext& context,
                                   std::span<const Program> programs) {
  Holes holes = list_limit_holes(context);
  holes["types"] = print_limit_types(context);
  holes["notes"] = comment("///", describe_cones(*context.limits));
  holes["cost"] = comment("///", describe_limited_cost(context, programs));
  holes["method"] = header_name(context, "limited_torque");
  holes["signature"] = wrap_line(print_head(context, find_supported(programs), kOneState) + ";", 0);
  return {context.name + "_limited.h", fill_holes(templates::kLimited, holes)};
}

}  // namespace

std::vector<GeneratedFile> print_limited(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const auto& programs = contents.programs;
  const std::string no_forces =
      fmt::format("{} f[1] = {{{}}};\n", number_type(context), number_literal(context, "0.0"));
  Holes holes = list_source_holes(context, programs, kOneState, no_forces);
  holes["limits"] = print_default_limits(context);
  return {print_limited_header(context, programs),
          {"limited_control_torque.c", fill_holes(templates::kLimitedSource, holes)}};
}

std::vector<GeneratedFile> print_batch_limited(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const auto& batch = contents.batch;
  const Form form = form_of_batch(context);
  const std::string no_forces = fmt::format("{} f[{}];\n", number_type(context), form.states) +
                                print_zeros(context, "f", form.states);
  const Holes holes = list_source_holes(context, batch, form, no_forces);
  return {print_batch_limited_header(context, batch),
          {"batch_limited_control_torque.c", fill_holes(templates::kBatchLimitedSource, holes)}};
}

}  // namespace treeline::c
