#include "emission/emit.hpp"

#include <algorithm>
#include <utility>

#include "emission/backend.hpp"
#include "emission/check_emission.hpp"
#include "emission/comment.hpp"
#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"
#include "emission/print_manifest.hpp"

namespace treeline {

std::vector<GeneratedFile> emit(const EmissionContext& context, std::span<const Program> programs,
                                Diagnostics& diagnostics, std::span<const Program> batch) {
  const Backend& backend = backend_of(context.language);
  const Contents contents(context, programs, batch);
  Diagnostics own;
  check_emission(context, contents.all, own);
  for (const Diagnostic& diagnostic : own.list()) {
    diagnostics.add(diagnostic);
  }
  if (own.has_errors()) {
    return {};
  }
  const std::string header(backend.header);
  const std::vector<Source> sources = list_sources(contents);
  std::vector<GeneratedFile> files;
  const auto add = [&](const std::string& name, const std::string& text) {
    files.push_back({name, harmless(text)});
  };
  add(context.name + header, backend.print_contract(context, programs));
  add(context.name + "_joints" + header, backend.print_joints(context));
  if (!backend.is_compiled_by_driver()) add("CMakeLists.txt", print_project(context, sources));
  for (const Program& program : programs) {
    add(source_name(context.language, program.name), backend.print_source(context, program));
  }
  for (const AddOn& add_on : backend.add_ons) {
    if (add_on.print == nullptr || !add_on.wants(contents)) continue;
    for (GeneratedFile& file : add_on.print(contents)) {
      if (!add_on.is_runtime) file.text = harmless(file.text);
      files.push_back(std::move(file));
    }
  }
  guard_headers(context.name, files);
  for (GeneratedFile& file : files) state_licence(file);
  files.push_back(print_identity(context, files));
  state_licence(files.back());
  files.push_back({kManifestName, print_manifest(context, programs, files, sources)});
  std::sort(files.begin(), files.end(),
            [](const GeneratedFile& a, const GeneratedFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace treeline
