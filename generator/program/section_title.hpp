#pragma once

#include <compare>
#include <string>

namespace treeline {

/// Tells what a part of a function computes: a step of its algorithm, at one link.
struct SectionTitle {
  int link = 0;           ///< counted from 1; 0: no link
  std::string link_name;  ///< from the URDF
  std::string step;       ///< `composite inertia`; empty where the part has no title

  friend auto operator<=>(const SectionTitle&, const SectionTitle&) = default;
};

/// `link 4 (elbow), composite inertia`.
std::string print(const SectionTitle& title);

}  // namespace treeline
