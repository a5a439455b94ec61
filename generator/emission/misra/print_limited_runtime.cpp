#include "emission/misra/print_limited_runtime.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "emission/c/print_limited.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/describe_limited.hpp"
#include "emission/fill_template.hpp"
#include "emission/misra/templates.hpp"
#include "emission/misra/translate_to_cpp.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::misra {
namespace {

/// What is behind the includes within the robot's namespace for what callers have no use for.
std::string enclose(const std::string& header, const std::string& name) {
  const std::size_t last = header.rfind("\n#include ");
  const std::size_t end = header.find('\n', last + 1);
  if (last == header.npos || end == header.npos)
    throw std::logic_error("a header without includes");
  return fmt::format(
      "{0}\n\nnamespace {1} {{\nnamespace detail {{\n{2}\n}}  // namespace detail\n}}  // "
      "namespace "
      "{1}\n",
      header.substr(0, end), name, header.substr(end + 1));
}

std::string print_layout(const EmissionContext& context) {
  return wrap_line(fmt::format("inline constexpr @_support_layout @_layout = {{{}}};",
                               print_support_layout(*context.limits, cpp::make_syntax(context))),
                   0);
}

}  // namespace

std::vector<GeneratedFile> print_limited_runtime(const EmissionContext& context) {
  auto holes = c::list_limit_holes(context, "@", "@@");
  holes["contract"] = context.name + "_limited.hpp";
  holes["types_header"] = "torque_limits.hpp";
  holes["layout"] = print_layout(context);
  std::vector<GeneratedFile> files = c::print_limit_headers(holes);
  files.push_back({"torque_limits", c::print_limit_types(holes)});
  translate_to_cpp(files);
  GeneratedFile& types = files.back();
  for (GeneratedFile& file : files) {
    if (&file != &types) file.text = enclose(file.text, context.name);
    file.name += ".hpp";
  }
  types.text =
      fill_template(templates::kTorqueLimits, {{"name", context.name}, {"types", types.text}});
  return files;
}

}  // namespace treeline::misra
