#include "compilation/choose_flags.hpp"

#include "compilation/run_commands.hpp"
#include "emission/describe_program.hpp"
#include "emission/print_optimize.hpp"

namespace treeline {
namespace {

/// Whether the function compiles to small code, as in `print_small_code`. A composed function in
/// C++ is a header: it is compiled with the sources of whoever includes it.
bool is_small(const GeneratedFunction& generated, const CompileOptions& options) {
  if (is_composed(generated)) {
    return options.optimize == Optimize::size && options.language == Language::c;
  }
  if (generated.batch > 0) {
    return options.optimize == Optimize::size && !is_huge(generated.program);
  }
  return compiles_to_small_code(options.optimize, options.target, generated.program);
}

/// Whether the last level that the flags name is not -O0, which is the default.
bool optimises(const std::string& flags) {
  bool on = false;
  for (const std::string& flag : split_words(flags)) {
    if (flag.starts_with("-O")) on = flag != "-O0";
  }
  return on;
}

}  // namespace

std::string add_extra_passes(const std::string& flags) {
  return optimises(flags) ? flags + " " + kExtraPasses : flags;
}

FunctionFlags choose_flags(const GeneratedFunction& generated, const CompileOptions& options) {
  const bool long_one = is_long(generated.program);
  const bool passes = options.flags.find(kExtraPasses) != std::string::npos;
  const std::string flags =
      options.flags + (long_one && passes ? std::string(" ") + kNoExtraPasses : "");
  if (is_small(generated, options)) return {flags + " " + kSmallCodeFlag, false, true};
  const bool huge = is_huge(generated.program) && optimises(flags);
  const bool has_flags = !options.long_flags.empty() && long_one;
  if (has_flags) return {options.long_flags, true, false};
  return {huge ? flags + " " + kHugeFlag : flags, false, false};
}

}  // namespace treeline
