#include "emission/cpp/backend.hpp"

#include <utility>

#include "emission/controller_unit.hpp"
#include "emission/cpp/print_batch.hpp"
#include "emission/cpp/print_c_calls.hpp"
#include "emission/cpp/print_calls.hpp"
#include "emission/cpp/print_contract.hpp"
#include "emission/cpp/print_damped.hpp"
#include "emission/cpp/print_eigen.hpp"
#include "emission/cpp/print_joints.hpp"
#include "emission/cpp/print_limited.hpp"
#include "emission/cpp/print_loops.hpp"
#include "emission/cpp/print_runtime.hpp"
#include "emission/cpp/print_source.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/list_sources.hpp"
#include "emission/misra/refuse.hpp"
#include "emission/print_identity.hpp"
#include "emission/print_optimize.hpp"
#include "emission/print_selftest.hpp"
#include "emission/print_target.hpp"

namespace treeline::cpp {
namespace {

std::set<std::string> reserved_names(const EmissionContext& context) {
  return {context.name,       "detail",         "eigen", "calls", "index_of",
          "coordinate_index", "velocity_index", "Real",  "std"};
}

std::string print_project(const EmissionContext& context, std::span<const Program> programs,
                          std::span<const Program> batch) {
  std::string sources;
  for (const Program& program : programs) {
    sources += program.name + ".cpp\n";
  }
  for (const Program& program : batch) {
    sources += "batch_" + program.name + ".cpp\n";
  }
  if (context.prefetch) sources += "prefetch.cpp\n";
  if (context.selftest) sources += std::string(kSelftestStem) + ".cpp\n";
  sources += std::string(kIdentityStem) + ".cpp\n";
  if (has_c_calls(context)) sources += "c_calls.cpp\n";
  if (context.controller) {
    for (const Program* const program : context.controller->programs()) {
      sources += program->name + ".cpp\n";
    }
    sources += "controller.cpp\n";
  }
  return fill_template(
      templates::kCMakeLists,
      {{"robot", context.robot},
       {"name", context.name},
       {"contraction", contraction_default(context)},
       {"target_flags", print_target_flags(context) + print_extra_passes(context, programs, batch) +
                            print_small_code(context, programs, batch) +
                            print_huge_code(context, programs, batch)},
       {"sources", sources}});
}

/// Other ways to call, functions of several states at once, damped and limited control.
std::vector<GeneratedFile> print_more(const EmissionContext& context,
                                      std::span<const Program> programs,
                                      std::span<const Program> batch) {
  std::vector<GeneratedFile> files;
  if (!context.effective_mass_limits.empty()) {
    files.push_back({context.name + "_damped.hpp", print_damped(context, programs)});
  }
  if (context.limits) {
    files.push_back({context.name + "_limited.hpp", print_limited(context, programs)});
  }
  if (has_loops(context, programs)) {
    for (GeneratedFile& file : print_loops(context, list_sources(context, programs))) {
      files.push_back(std::move(file));
    }
  }
  if (context.misra) return files;  // no library, no vectors
  files.insert(files.end(), {{context.name + "_calls.hpp", print_calls(context, programs)},
                             {context.name + "_eigen.hpp", print_eigen(context, programs)}});
  for (GeneratedFile& file : print_c_calls(context, programs, batch))
    files.push_back(std::move(file));
  if (!batch.empty()) {
    files.push_back({context.name + "_batch.hpp", print_batch_header(context, batch)});
  }
  for (const Program& program : batch) {
    files.push_back({"batch_" + program.name + ".cpp", print_batch_source(context, program)});
  }
  if (context.limits && !batch.empty()) {
    files.push_back({context.name + "_batch_limited.hpp", print_batch_limited(context, batch)});
  }
  return files;
}

}  // namespace

Backend make_backend() {
  Backend backend{};
  backend.name = "C++";
  backend.header = ".hpp";
  backend.source = ".cpp";
  backend.refuse = misra::refuse;
  backend.reserved = reserved_names;
  backend.syntax = make_syntax;
  backend.print_source = print_source;
  backend.print_declaration = [](const EmissionContext&, const Program& program) {
    return print_declaration(program);
  };
  backend.print_contract = print_contract;
  backend.print_joints = print_joints;
  backend.print_project = print_project;
  backend.print_more = print_more;
  backend.print_runtime = print_runtime;
  return backend;
}

}  // namespace treeline::cpp
