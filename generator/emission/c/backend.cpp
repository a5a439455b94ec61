#include "emission/c/backend.hpp"

#include <utility>

#include "emission/c/print_batch.hpp"
#include "emission/c/print_contract.hpp"
#include "emission/c/print_damped.hpp"
#include "emission/c/print_joints.hpp"
#include "emission/c/print_limited.hpp"
#include "emission/c/print_loops.hpp"
#include "emission/c/print_project.hpp"
#include "emission/c/print_runtime.hpp"
#include "emission/c/print_source.hpp"
#include "emission/c/refuse.hpp"
#include "emission/c/syntax.hpp"
#include "emission/list_sources.hpp"

namespace treeline::c {
namespace {

/// Names that the headers declare with the same prefix as functions.
std::set<std::string> reserved_suffixes(const EmissionContext& /*context*/) {
  return {"real",
          "sin_cos",
          "coordinate_joints",
          "coordinate_meanings",
          "home",
          "lower_limits",
          "upper_limits",
          "velocity_joints",
          "velocity_names",
          "velocity_limits",
          "effort_limits",
          "task_row_names",
          "id",
          "has_constants_of_double"};
}

/// Functions of several states at once, damped and limited control, tables of links.
std::vector<GeneratedFile> print_more(const EmissionContext& context,
                                      std::span<const Program> programs,
                                      std::span<const Program> batch) {
  std::vector<GeneratedFile> files;
  if (!context.effective_mass_limits.empty()) files = print_damped(context, programs);
  if (context.limits) {
    for (GeneratedFile& file : print_limited(context, programs)) files.push_back(std::move(file));
  }
  for (GeneratedFile& file : print_batch(context, batch)) files.push_back(std::move(file));
  if (context.limits && !batch.empty()) {
    for (GeneratedFile& file : print_batch_limited(context, batch)) {
      files.push_back(std::move(file));
    }
  }
  for (GeneratedFile& file : print_loops(context, list_sources(context, programs)))
    files.push_back(std::move(file));
  return files;
}

}  // namespace

Backend make_backend() {
  Backend backend{};
  backend.name = "C";
  backend.header = ".h";
  backend.source = ".c";
  backend.refuse = refuse;
  backend.reserved = reserved_suffixes;
  backend.syntax = make_syntax;
  backend.print_source = print_source;
  backend.print_declaration = print_declaration;
  backend.print_contract = print_contract;
  backend.print_joints = print_joints;
  backend.print_project = print_project;
  backend.print_more = print_more;
  backend.print_runtime = print_runtime;
  return backend;
}

}  // namespace treeline::c
