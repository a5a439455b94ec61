#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// NAME_prefetch and prefetch, header and source in the context's language: functions that load the
/// code of each of the programs' functions into caches, for one state and for `batch`, and the
/// dynamics of the controller.
std::vector<GeneratedFile> print_prefetch(const Contents& contents);

/// NAME_prefetch.h, for C.
GeneratedFile print_prefetch_for_c(const Contents& contents);

/// Code that is loaded by one call.
struct LoadedCode {
  std::string name;                    ///< `gravity`, `batch_gravity`; `step` of the controller
  std::vector<std::string> functions;  ///< by their sources; each has a section of its own
  std::size_t stack = 0;               ///< bytes that a call is estimated to use
};

/// Lists the code that can be loaded.
std::vector<LoadedCode> list_loaded(const Contents& contents);

/// Stem of the source of a controller's step, whose code can be loaded too.
inline constexpr const char* kControllerStem = "controller";

/// Section of a function: its own, or `whole`, which includes what it calls of its source.
enum class Attributes { own, whole };

/// Start of the source of a function whose code can be loaded: the macro that gives it a section of
/// its own. Empty unless the scene asks for it.
std::string print_prefetch_macro(const EmissionContext& context, const std::string& function,
                                 Attributes attributes = Attributes::own);

/// Line that puts the function below it into its own section; empty unless the scene asks for it.
std::string print_prefetch_section(const EmissionContext& context);

}  // namespace treeline
