#include "compilation/print_opencl_entry.hpp"

#include "compilation/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/join_arguments.hpp"
#include "emission/opencl/build_options.hpp"

namespace treeline {

std::string print_opencl_entry(const std::filesystem::path& folder, const std::string& name,
                               const std::vector<GeneratedFunction>& functions) {
  std::string entries;
  for (const GeneratedFunction& generated : functions) {
    const Program& program = generated.program;
    entries += fill_template(
        compilation_templates::kOpenclFunction,
        {{"name", name},
         {"function", program.name},
         {"sizes", join_arguments(program,
                                  [](const Argument& argument, const char*) {
                                    return std::to_string(argument.rows * argument.cols);
                                  })},
         {"inputs", std::to_string(program.arguments.size())}});
  }
  return fill_template(compilation_templates::kOpenclEntry,
                       {{"name", name},
                        {"options", opencl::kBuildOptions},
                        {"options_of_float", opencl::kBuildOptionsOfFloat},
                        {"folder", folder.string()},
                        {"functions", entries}});
}

}  // namespace treeline
