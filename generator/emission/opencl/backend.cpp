#include <fmt/format.h>

#include "emission/c/print_files.hpp"
#include "emission/emitted_text.hpp"
#include "emission/opencl/print_files.hpp"
#include "emission/opencl/templates.hpp"

namespace treeline::opencl {
namespace {

/// NAME.cl, which includes what a program of all kernels needs.
std::vector<GeneratedFile> print_program(const Contents& contents) {
  const EmissionContext& context = contents.context;
  std::string includes;
  for (const Source& source : list_sources(contents)) {
    includes += fmt::format("#include \"{}\"\n", source.file);
  }
  includes.pop_back();
  return {{context.name + ".cl", fill_template(templates::kProgram, {{"robot", context.robot},
                                                                     {"name", context.name},
                                                                     {"includes", includes}})}};
}

constexpr AddOn kAddOns[] = {{always, print_program}, kIdentityRow, kSinesRow};

}  // namespace

Backend make_backend() {
  Backend backend = c::make_backend();
  backend.name = backend.standard = "OpenCL C";
  backend.source = ".cl";
  backend.cmake = backend.feature = backend.flag = "";
  backend.constant = "__constant";
  backend.words.insert({{"int32_t", "int"}, {"uint32_t", "uint"}, {"uint64_t", "ulong"}});
  backend.known = {"#include <"};
  backend.joins_loops = false;
  backend.places = {};
  backend.refuse = refuse;
  backend.print_source = print_source;
  backend.print_contract = print_contract;
  backend.add_ons = kAddOns;
  return backend;
}

}  // namespace treeline::opencl
