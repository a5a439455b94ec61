#include "compilation/compile_folder.hpp"
#include "compilation/templates.hpp"
#include "emission/emitted_text.hpp"
#include "emission/opencl/print_files.hpp"

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
