#include "emission/print_target.hpp"

#include <fmt/format.h>

#include "emission/comment.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

constexpr const char* kSectionNote =
    "TREELINE_CODE_SECTION, where it is defined as an attribute, stands before each function and\n"
    "places it, for instance __attribute__((section(\".itcm\"))). Sines and cosines are inline: "
    "the\n"
    "linker finds them in .text.*sin_cos*.\n";

/// The target if it is a particular processor, else null.
const Target* particular_target(const EmissionContext& context) {
  const Target* const target = find_target(context.target);
  return target != nullptr && is_particular(*target) ? target : nullptr;
}

}  // namespace

std::string describe_target(const EmissionContext& context) {
  const Target* const target = particular_target(context);
  if (target == nullptr) return {};
  const std::string measure =
      target->board.kind == BoardKind::none
          ? std::string()
          : fmt::format(
                " `treeline check` with --target {} runs the functions in QEMU and measures code, "
                "stack and instructions.",
                target->name);
  const std::string made = wrap_text(fmt::format("Made for {}: {}. Flags: {}.{}", target->name,
                                                 target->about, target->flags, measure),
                                     95);
  return fmt::format("\n{}\n{}", made, context.misra ? "" : kSectionNote);
}

std::string print_section_macro(const EmissionContext& context) {
  if (particular_target(context) == nullptr || context.misra) return {};
  return "\n#if !defined(TREELINE_CODE_SECTION)\n"
         "#define TREELINE_CODE_SECTION  // an attribute, to place the code in memory\n"
         "#endif\n";
}

std::string print_section(const EmissionContext& context) {
  return particular_target(context) == nullptr || context.misra ? "" : "TREELINE_CODE_SECTION\n";
}

std::string print_target_flags(const EmissionContext& context) {
  const Target* const target = particular_target(context);
  if (target == nullptr) return {};
  const bool cross = *target->prefix != '\0';
  return fmt::format(
      "# OFF: whatever else the project compiles for, this machine for instance.\n"
      "option(TREELINE_TARGET_FLAGS\n  \"Compile for {0}: {1}\"\n  {2})\n"
      "if(TREELINE_TARGET_FLAGS)\n"
      "  target_compile_options({3} PRIVATE {1})\n"
      "endif()\n",
      target->name, target->flags, cross ? "${CMAKE_CROSSCOMPILING}" : "ON", context.name);
}

std::string print_target_lines(const EmissionContext& context) {
  const Target* const target = particular_target(context);
  if (target == nullptr) return {};
  return fmt::format(
      "  \"target\": \"{}\",\n  \"target_flags\": \"{}\",\n  \"cross_compiled\": {},\n"
      "  \"contraction\": {},\n",
      target->name, target->flags, *target->prefix != '\0', target->contracts);
}

const char* contraction_default(const EmissionContext& context) {
  const Target* const target = particular_target(context);
  return target == nullptr || target->contracts ? "ON" : "OFF";
}

}  // namespace treeline
