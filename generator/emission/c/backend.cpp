
#include "emission/c/print_files.hpp"
#include "emission/print_files.hpp"

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

std::vector<GeneratedFile> print_damped_law(const Contents& contents) {
  return join_files({print_damped(contents), print_damped_headers(contents.context)});
}

std::vector<GeneratedFile> print_limited_law(const Contents& contents) {
  return join_files({print_limited(contents), print_limit_headers(contents.context)});
}

constexpr AddOn kAddOns[] = {
    kControllerRow,
    kGroundRow,
    {wants_damping, print_damped_law, "damped_control_torque", true},
    {wants_limits, print_limited_law, "limited_control_torque", true},
    {wants_batch_limits, print_batch_limited, "batch_limited_control_torque", true},
    kSelftestRow,
    kIdentityRow,
    {wants_batch, print_batch},
    kLoopsRow,
    {.wants = wants_lanes, .print = print_lane_types, .is_runtime = true},
    kSinesRow,
    kEndingsRow,
    kRegistersRow,
    kSquareRootRow};

}  // namespace

Backend make_backend() {
  Backend backend{};
  backend.name = "C";
  backend.standard = "C99";
  backend.header = ".h";
  backend.source = ".c";
  backend.cmake = "C";
  backend.feature = "c_std_99";
  backend.flag = "-std=c99";
  backend.scope = "_";
  backend.cast = "({})";
  backend.constants = {"enum {\n", "  {} = {}", ",", "", "};\n"};
  backend.words = {{"TL_FUNCTION", "static"},
                   {"TL_SAFE_FUNCTION", "static"},
                   {"TL_INLINE", "static inline"},
                   {"TL_TABLE", "static const"},
                   {"TL_NONE", "NULL"},
                   {"TL_RESTRICT", "restrict"},
                   {"TL_ATOMICS", "stdatomic.h"},
                   {"TL_FENCE", "atomic_thread_fence(memory_order_seq_cst)"}};
  backend.joins_loops = true;
  backend.places = {{Source::Of::joined, -2}, {Source::Of::step, -1}};
  backend.refuse = refuse;
  backend.reserved = reserved_suffixes;
  backend.syntax = make_syntax;
  backend.print_source = print_source;
  backend.print_declaration = print_declaration;
  backend.print_contract = print_contract;
  backend.print_joints = print_joints;
  backend.add_ons = kAddOns;
  return backend;
}

}  // namespace treeline::c
