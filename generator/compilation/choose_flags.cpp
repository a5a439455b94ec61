#include <cstdlib>

#include "compilation/compile_folder.hpp"
#include "compilation/run_commands.hpp"
#include "emission/backend.hpp"

namespace treeline {
namespace {

/// The flags of the function's source in the emitted project. A composed function in C++ is a
/// header: it is compiled with the sources of whoever includes it.
OwnFlags own_flags_of(const GeneratedFunction& generated, const CompileOptions& options) {
  if (is_composed(generated)) {
    return {options.optimize == Optimize::size &&
            !backend_of(options.language).composes_in_headers};
  }
  return choose_own_flags(options.optimize, generated.program);
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
  const OwnFlags own = own_flags_of(generated, options);
  const bool passes = options.flags.find(kExtraPasses) != std::string::npos;
  const std::string flags =
      options.flags + (own.is_long && passes ? std::string(" ") + kNoExtraPasses : "");
  if (own.is_small) return {flags + " " + kSmallCodeFlag, false, true};
  if (own.is_long && !options.long_flags.empty()) return {options.long_flags, true, false};
  return {own.is_huge && optimises(flags) ? flags + " " + kHugeFlag : flags, false, false};
}

std::string environment_value(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr || split_words(value).empty() ? "" : value;
}

}  // namespace treeline
