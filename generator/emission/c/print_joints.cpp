#include <fmt/format.h>

#include "emission/c/print_files.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"

namespace treeline::c {

std::string print_joints(const EmissionContext& context) {
  const std::string capitals = name_in_capitals(context);
  const Syntax syntax = make_syntax(context);
  const std::string largest = syntax.literal(largest_number(context.single_precision));
  const std::string name = capitals + "_UNLIMITED";
  // Without macros each array has the number itself: C takes no named constant there.
  JointArrays arrays = describe_joints(context, syntax, context.misra ? largest : name);
  arrays.holes.erase("unlimited");
  arrays.holes["define_unlimited"] =
      context.misra
          ? fmt::format("static const {} {}_unlimited = {};", syntax.number, context.name, largest)
          : fmt::format("#define {} {}", name, largest);
  arrays.holes["task_rows"] =
      arrays.task_rows == 0
          ? ""
          : fmt::format(
                "\n/// Of each task row: its point, and along or about which axis it is.\n"
                "static const char* const {}_task_row_names[{}] = {{\n    {}}};",
                context.name, arrays.task_rows, arrays.task_row_names);
  return fill_template(templates::kJoints, arrays.holes);
}

}  // namespace treeline::c
