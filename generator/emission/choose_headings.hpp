#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

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

}  // namespace treeline
