
#include <algorithm>

#include "emission/core_headers.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/descriptions.hpp"
#include "emission/misra/refuse.hpp"
#include "emission/print_files.hpp"

namespace treeline::cpp {
namespace {

std::set<std::string> reserved_names(const EmissionContext& context) {
  return {context.name,       "detail",         "eigen", "calls", "index_of",
          "coordinate_index", "velocity_index", "Real",  "std"};
}

bool wants_own_lanes(const Contents& contents) {
  return wants_batch(contents) || wants_lanes(contents);
}

bool wants_own_sines(const Contents& contents) {
  const bool in_laws = contents.context.misra
                           ? wants_damping(contents) || wants_controller(contents)
                           : wants_laws(contents) || wants_batch(contents);
  return in_laws || wants_loops(contents) ||
         std::any_of(contents.programs.begin(), contents.programs.end(), uses_trigonometry);
}

std::vector<GeneratedFile> print_lanes(const Contents& contents) {
  return {{"lanes.hpp", print_core_header(contents.context, core_headers::kLanes)}};
}

std::vector<GeneratedFile> print_sines(const Contents& contents) {
  const EmissionContext& context = contents.context;
  if (context.misra) return {print_sin_cos(context)};
  return {{"sin_cos.hpp", print_core_header(context, print_sines_in_lanes())}};
}

std::vector<GeneratedFile> print_damped_law(const Contents& contents) {
  const EmissionContext& context = contents.context;
  return join_files({{{context.name + "_damped.hpp", print_damped(context, contents.programs)}},
                     print_damped_headers(context)});
}

std::vector<GeneratedFile> print_limited_law(const Contents& contents) {
  const EmissionContext& context = contents.context;
  return join_files({{{context.name + "_limited.hpp", print_limited(context, contents.programs)}},
                     print_limit_headers(context)});
}

/// Other ways to call the functions, which need a library.
std::vector<GeneratedFile> print_other_calls(const Contents& contents) {
  const EmissionContext& context = contents.context;
  return {{context.name + "_calls.hpp", print_calls(context, contents.programs)},
          {context.name + "_eigen.hpp", print_eigen(context, contents.programs)}};
}

constexpr AddOn kAddOns[] = {
    kControllerRow,
    kGroundRow,
    {wants_damping, print_damped_law},
    {wants_limits, print_limited_law},
    {wants_batch_limits,
     [](const Contents& each) {
       return std::vector<GeneratedFile>{{each.context.name + "_batch_limited.hpp",
                                          print_batch_limited(each.context, each.batch)}};
     }},
    kSelftestRow,
    kIdentityRow,
    {wants_batch, print_batch},
    kLoopsRow,
    {[](const Contents& each) { return !each.context.misra; }, print_other_calls},
    {.wants = wants_own_lanes, .print = print_lanes, .is_runtime = true},
    {.wants = wants_own_sines, .print = print_sines, .is_runtime = true},
    kEndingsRow,
    kRegistersRow,
    kSquareRootRow};

}  // namespace

Backend make_backend() {
  Backend backend{};
  backend.name = "C++";
  backend.standard = "C++17";
  backend.header = ".hpp";
  backend.source = ".cpp";
  backend.cmake = "CXX";
  backend.feature = "cxx_std_17";
  backend.flag = "-std=c++17";
  backend.has_namespaces = true;
  backend.scope = "::";
  backend.details = "detail::";
  backend.has_references = true;
  backend.cast = "static_cast<{}>";
  backend.constants = {"", "inline constexpr int32_t {} = {}", ";", ";", ""};
  backend.composes_in_headers = true;
  // Where the compiler may choose, as it may in C, large functions are called and not repeated.
  backend.words = {{"TL_FUNCTION", "[[gnu::noinline]] inline"},
                   {"TL_SAFE_FUNCTION", "inline"},
                   {"TL_INLINE", "inline"},
                   {"TL_TABLE", "inline constexpr"},
                   {"TL_NONE", "nullptr"},
                   {"TL_RESTRICT", "__restrict"},
                   {"TL_ATOMICS", "atomic"},
                   {"TL_FENCE", "std::atomic_thread_fence(std::memory_order_seq_cst)"}};
  backend.known = {"typedef struct Tl", "#include <stdbool.h>\n"};
  backend.places = {{Source::Of::dynamics, 1}, {Source::Of::step, 2}};
  backend.refuse = misra::refuse;
  backend.reserved = reserved_names;
  backend.syntax = make_syntax;
  backend.print_source = print_source;
  backend.print_declaration = [](const EmissionContext&, const Program& program) {
    return print_declaration(program);
  };
  backend.print_contract = print_contract;
  backend.print_joints = print_joints;
  backend.add_ons = kAddOns;
  return backend;
}

}  // namespace treeline::cpp
