#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/adapt.hpp"
#include "program/program.hpp"
#include "program/section_title.hpp"

namespace treeline {

/// Fewer statements get no heading of their own.
inline constexpr std::size_t kFewestUnderHeading = 5;

/// A heading, and the first of the statements below it.
struct Heading {
  std::size_t first = 0;
  std::string text;
  friend bool operator==(const Heading&, const Heading&) = default;
};

/// Divides statements among headings, each of which names all that stands below it. Where
/// statements of several links alternate, one heading names them all: `links 4 to 6, composite
/// inertia`. `titles[i]` says what statement i belongs to: several titles where it computes values
/// of several limbs at once, none where nothing is known. There is no heading for fewer than
/// `kFewestUnderHeading` statements, nor for those without titles at the beginning.
std::vector<Heading> choose_headings(const std::vector<std::set<SectionTitle>>& titles);

/// A legal name for a local variable: other characters than letters and digits become single
/// underscores; what C++ or its headers have already gets a suffix. Never empty.
std::string make_identifier(std::string_view text);

/// Finds a unique name for each constant in `Program::constants`; these become `taken`.
std::map<std::uint32_t, std::string> name_constants(const Program& program,
                                                    std::set<std::string>& taken);

/// Finds for every `wanted` node the identifier of its value, unique and none of `reserved`; empty
/// for the others. A value is named by what it is: as the trace named it (`f4_x`), as sine or
/// cosine of a sum of angles (`s23`), or after its place in a result (`M_0_3`). Other values have
/// neutral names, `t17`. A pack of lanes has one name, at its first node: `f8_15_x`.
std::vector<std::string> choose_names(const Program& program, std::vector<bool> wanted,
                                      std::set<std::string> reserved);

/// Whether the value of each node is given a statement and a name. The others, used once and
/// unnamed, are written inside the expression that uses them, as long as that stays readable;
/// constants and inputs are written where they are used.
std::vector<bool> select_statements(const Program& program);

/// Finds names of nodes that are the sine or cosine of a sum of joint angles, as roboticists write
/// them: `s23` for s2 c3 + c2 s3, `minus_c23`, `s2_minus_3`. Links with numbers of two digits are
/// kept apart: `c9_plus_10`. Empty for all other nodes, and for sines of one angle.
std::vector<std::string> find_angle_sums(const Program& program);

/// An integer that has a name in emitted code.
struct Constant {
  const char* name;  ///< in capitals and without the robot's: `UNKNOWNS`
  int value;
  const char* comment;  ///< may be empty
};

/// Enumerators in C, constants in C++.
std::string print_constants(const Adaptation& own, std::span<const Constant> constants);

/// A table: `declared[n] = {entries};`, with what stands before the name in `declared`. Arrays have
/// at least one entry: 0, which nothing reads.
std::string print_table(const std::string& declared, std::vector<std::string> entries,
                        std::size_t indentation);

/// A header of sizes, where `header` has TL_CONSTANTS in their place and TL_CONTRACT for the name
/// of the robot's header.
std::string print_sizes(const std::string& robot, const Adaptation& own, std::string_view header,
                        std::span<const Constant> sizes);

}  // namespace treeline
