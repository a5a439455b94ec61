#include <fmt/format.h>

#include <algorithm>

#include "emission/backend.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

using Places = std::map<Source::Of, int>;

std::vector<Source> put_in_places(std::vector<Source> sources, const Places& places) {
  const auto place_of = [&](const Source& source) {
    const auto place = places.find(source.of);
    return place == places.end() ? 0 : place->second;
  };
  std::stable_sort(sources.begin(), sources.end(),
                   [&](const Source& a, const Source& b) { return place_of(a) < place_of(b); });
  return sources;
}

/// The joined source is made by CMake.
std::string path_of(const Source& source) {
  return (source.of == Source::Of::joined ? "${CMAKE_CURRENT_BINARY_DIR}/" : "") + source.file;
}

/// Lines of CMake that make a source of others; none where no source is joined.
std::string print_joining(const std::vector<Source>& sources) {
  std::string items, path;
  for (const Source& source : sources) {
    if (source.is_joined) items += "\n    " + source.file;
    if (source.of == Source::Of::joined) path = path_of(source);
  }
  if (path.empty()) return {};
  return fmt::format(
      "# The functions that loop over links, as one source: so they share the loops.\n"
      "set(joined \"\")\nforeach(source IN ITEMS{0})\n"
      "  string(APPEND joined \"#include \\\"${{CMAKE_CURRENT_SOURCE_DIR}}/${{source}}\\\"\\n\")\n"
      "endforeach()\n"
      "file(GENERATE OUTPUT \"{1}\" CONTENT \"${{joined}}\")\n"
      "set_source_files_properties(\"{1}\" PROPERTIES GENERATED TRUE)\n",
      items, path);
}

/// Lines of CMake that add options to the sources with that flag. Empty where none has it.
std::string print_options(const std::vector<Source>& sources, bool OwnFlags::*flag,
                          const char* options) {
  std::string list;
  for (const Source& source : sources) {
    if (source.flags.*flag) list += fmt::format("    {}\n", path_of(source));
  }
  if (list.empty()) return {};
  return fmt::format("  set_property(SOURCE\n{}    APPEND PROPERTY COMPILE_OPTIONS {})\n", list,
                     options);
}

/// What only GCC and compilers with its options understand.
std::string print_for_gcc(const EmissionContext& context, const char* why,
                          const std::string& options) {
  if (options.empty()) return {};
  return fmt::format("# {}\nif(CMAKE_{}_COMPILER_ID MATCHES \"GNU|Clang|IntelLLVM\")\n{}endif()\n",
                     why, backend_of(context.language).cmake, options);
}

std::string print_own_flags(const EmissionContext& context, const std::vector<Source>& sources) {
  // Of a chain of 60 joints g++ 12 compiles Lambda^-1 (25000 operations) in 200 s with the extra
  // passes and in 17 s without, M (27000) in 48 and 28 s, to 5 % more code.
  const std::vector<Source> last = put_in_places(sources, {{Source::Of::dynamics, 1}});
  return fmt::format(
             "if(CMAKE_{0}_COMPILER_ID STREQUAL \"GNU\")\n"
             "  # Fewer spills and copies in long straight-line code; no arithmetic changes.\n"
             "  target_compile_options({1} PRIVATE\n"
             "    \"$<$<IN_LIST:$<CONFIG>,{2}>:-flive-range-shrinkage>\"\n"
             "    \"$<$<IN_LIST:$<CONFIG>,{2}>:-frename-registers>\")\n{3}"
             "endif()\n",
             backend_of(context.language).cmake, context.name, "Release;RelWithDebInfo;MinSizeRel",
             print_options(last, &OwnFlags::is_long, kNoExtraPasses)) +
         print_for_gcc(
             context,
             "`optimize` of the scene: small code, whatever level the project compiles with.",
             print_options(sources, &OwnFlags::is_small, kSmallCodeFlag)) +
         print_for_gcc(context,
                       "Too long for a higher level, whatever level the project compiles with.",
                       print_options(last, &OwnFlags::is_huge, kHugeFlag));
}

}  // namespace

std::string print_project(const EmissionContext& context, const std::vector<Source>& sources) {
  const Backend& backend = backend_of(context.language);
  std::string list;
  for (const Source& source : put_in_places(sources, backend.places)) {
    if (!source.is_joined) list += path_of(source) + "\n";
  }
  return fill_template(
      templates::kCMakeLists,
      {{"robot", context.robot},
       {"name", context.name},
       {"language", std::string(backend.cmake)},
       {"feature", std::string(backend.feature)},
       {"joined", print_joining(sources)},
       {"sources", list},
       {"contraction", contraction_default(context)},
       {"target_flags", print_target_flags(context) + print_own_flags(context, sources)}});
}

}  // namespace treeline
