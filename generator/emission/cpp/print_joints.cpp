#include <fmt/format.h>

#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"

namespace treeline::cpp {

std::string print_joints(const EmissionContext& context) {
  JointArrays arrays = describe_joints(context, make_syntax(context), "kUnlimited");
  arrays.holes["task_rows"] =
      arrays.task_rows == 0
          ? ""
          : fmt::format(
                "\n/// Of each task row: its point, and along or about which axis it is.\n"
                "inline constexpr const char* kTaskRowNames[{}] = {{\n    {}}};",
                arrays.task_rows, arrays.task_row_names);
  arrays.holes["lookup"] = context.misra ? std::string() : std::string(templates::kLookup) + "\n";
  return fill_template(templates::kJoints, arrays.holes);
}

}  // namespace treeline::cpp
