#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// Passes of GCC that save spills and copies in straight-line code, 2 to 6 % of its bytes. Without
/// optimisation, and for long functions, they take minutes.
inline constexpr const char* kExtraPasses = "-flive-range-shrinkage -frename-registers";
inline constexpr const char* kNoExtraPasses = "-fno-live-range-shrinkage -fno-rename-registers";

/// Lines of CMake that have GCC make the extra passes where it optimises, but for long functions
/// (`is_long`).
std::string print_extra_passes(const EmissionContext& context, std::span<const Program> programs,
                               std::span<const Program> batch);

/// GCC's and Clang's option for functions that are too long for higher levels (`is_huge`).
inline constexpr const char* kHugeFlag = "-O1";

/// Lines of CMake that compile such functions by it. Empty where there are none.
std::string print_huge_code(const EmissionContext& context, std::span<const Program> programs,
                            std::span<const Program> batch);

/// GCC's and Clang's option for small code.
inline constexpr const char* kSmallCodeFlag = "-Os";

/// Whether the emitted CMakeLists.txt compiles a function to small code, as `optimize` of the scene
/// asks: `size` all; `balanced` those of which `Program::small_code` says so, and where it says
/// nothing those whose code is modelled to be larger than the first-level cache of the target, so
/// that loading it takes longer than running it; never what is too long for this (`is_huge`).
bool compiles_to_small_code(Optimize optimize, std::string_view target, const Program& program);

/// The sources that are compiled to small code: of these functions, of those for several states,
/// and of a controller.
std::vector<std::string> list_small_sources(const EmissionContext& context,
                                            std::span<const Program> programs,
                                            std::span<const Program> batch);

/// Lines of CMake that compile these functions, those for several states, and those of a controller
/// to small code. Empty where there are none.
std::string print_small_code(const EmissionContext& context, std::span<const Program> programs,
                             std::span<const Program> batch);

}  // namespace treeline
