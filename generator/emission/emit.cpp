#include "emission/emit.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "emission/backend/backend.hpp"
#include "emission/check_emission.hpp"
#include "emission/comment.hpp"
#include "emission/guard_headers.hpp"
#include "emission/list_sources.hpp"
#include "emission/print_controller.hpp"
#include "emission/print_identity.hpp"
#include "emission/print_manifest.hpp"
#include "emission/print_prefetch.hpp"
#include "emission/print_selftest.hpp"

namespace treeline {
namespace {

void append(std::vector<GeneratedFile> more, std::vector<GeneratedFile>& files) {
  std::move(more.begin(), more.end(), std::back_inserter(files));
}

}  // namespace

std::vector<GeneratedFile> emit(const EmissionContext& context, std::span<const Program> programs,
                                Diagnostics& diagnostics, std::span<const Program> batch) {
  const Backend& backend = backend_of(context.language);
  Diagnostics own;
  check_emission(context, list_sources(context, programs), own);
  for (const Diagnostic& diagnostic : own.list()) {
    diagnostics.add(diagnostic);
  }
  if (own.has_errors()) {
    return {};
  }
  const std::string header(backend.header);
  std::vector<GeneratedFile> files = {
      {context.name + header, backend.print_contract(context, programs)},
      {context.name + "_joints" + header, backend.print_joints(context)},
      {"CMakeLists.txt", backend.print_project(context, programs, batch)}};
  for (const Program& program : programs) {
    files.push_back(
        {program.name + std::string(backend.source), backend.print_source(context, program)});
  }
  append(backend.print_more(context, programs, batch), files);
  if (context.controller) append(print_controller(context, *context.controller), files);
  append(print_prefetch(context, programs, batch), files);
  append(print_selftest(context, programs), files);
  for (GeneratedFile& file : files) file.text = harmless(file.text);
  append(backend.print_runtime(context, programs, batch), files);
  guard_headers(context.name, files);
  files.push_back(print_identity(context, files));
  files.push_back({kManifestName, print_manifest(context, programs, files)});
  std::sort(files.begin(), files.end(),
            [](const GeneratedFile& a, const GeneratedFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace treeline
