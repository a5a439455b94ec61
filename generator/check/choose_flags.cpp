#include "check/choose_flags.hpp"

#include "emission/describe_program.hpp"
#include "emission/print_optimize.hpp"

namespace treeline {
namespace {

/// As `print_small_code` lists sources. A composed function in C++ is a header, which is compiled
/// with the sources of whoever includes it.
bool is_small(const GeneratedFunction& generated, const CompileOptions& options) {
  if (is_composed(generated)) {
    return options.optimize == Optimize::size && options.language == Language::c;
  }
  if (generated.batch > 0) return options.optimize == Optimize::size;
  return compiles_to_small_code(options.optimize, options.target, generated.program);
}

}  // namespace

FunctionFlags choose_flags(const GeneratedFunction& generated, const CompileOptions& options) {
  if (is_small(generated, options)) {
    return {options.flags + " " + kSmallCodeFlag, false, true};
  }
  const bool has_flags = !options.long_flags.empty() && is_long(generated.program);
  return {has_flags ? options.long_flags : options.flags, has_flags, false};
}

}  // namespace treeline
