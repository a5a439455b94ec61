#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"
#include "emission/list_sources.hpp"
#include "emission/print_files.hpp"

namespace treeline {

/// Files that a folder has beside those of its functions, where the scene asks for them or others
/// include them. A language has a table of such rows (`Backend::add_ons`).
struct AddOn {
  bool (*wants)(const Contents& contents);
  /// Null where what is printed depends on all other files.
  std::vector<GeneratedFile> (*print)(const Contents& contents);
  const char* source = nullptr;  ///< stem of the file to compile, if one is
  bool computes = false;         ///< the source is small code where the scene asks for that
  Source::Of of = Source::Of::add_on;
  /// Headers that name nothing from elsewhere: their macros keep the backslashes at ends of lines.
  bool is_runtime = false;
};

// What rows of every language ask.
bool always(const Contents& contents);
bool wants_damping(const Contents& contents);
bool wants_limits(const Contents& contents);
bool wants_batch(const Contents& contents);
bool wants_batch_limits(const Contents& contents);
bool wants_controller(const Contents& contents);
bool wants_ground(const Contents& contents);
bool wants_selftest(const Contents& contents);
bool wants_loops(const Contents& contents);
bool wants_lanes(const Contents& contents);
/// Whether anything computes in vectors that compilers know.
bool wants_registers(const Contents& contents);
/// Whether anything that is no function of straight lines computes: it takes roots and sines.
bool wants_laws(const Contents& contents);

/// Whether anything takes sines by pointers.
bool wants_sines(const Contents& contents);

/// The files of several printers, one behind the other.
std::vector<GeneratedFile> join_files(std::initializer_list<std::vector<GeneratedFile>> lists);

/// Headers of the runtime that others include.
std::vector<GeneratedFile> print_registers(const Contents& contents);
std::vector<GeneratedFile> print_square_root_of(const Contents& contents);
std::vector<GeneratedFile> print_sines_by_pointers(const Contents& contents);

// Rows of every language.
inline constexpr AddOn kControllerRow{wants_controller, print_controller, kControllerStem, true,
                                      Source::Of::step};
inline constexpr AddOn kGroundRow{wants_ground, print_ground, kGroundStem, true};
inline constexpr AddOn kSelftestRow{wants_selftest, print_selftest, kSelftestStem};
inline constexpr AddOn kIdentityRow{always, nullptr, kIdentityStem};
inline constexpr AddOn kLoopsRow{wants_loops, print_loops};
inline constexpr AddOn kEndingsRow{
    .wants = wants_endings, .print = print_ending_headers, .is_runtime = true};
inline constexpr AddOn kRegistersRow{
    .wants = wants_registers, .print = print_registers, .is_runtime = true};
inline constexpr AddOn kSquareRootRow{
    .wants = wants_laws, .print = print_square_root_of, .is_runtime = true};

// A row of languages without references to arrays.
inline constexpr AddOn kSinesRow{
    .wants = wants_sines, .print = print_sines_by_pointers, .is_runtime = true};

}  // namespace treeline
