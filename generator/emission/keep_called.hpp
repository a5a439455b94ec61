#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace treeline {

/// A type or function of the loops over links, in C++ or C.
struct LoopDeclaration {
  std::string name;
  bool is_function = false;
  std::string text;  ///< with its comment
};

/// A header of loops over links.
struct LoopHeader {
  std::string name;                    ///< as others include it: `link_rows.h`
  std::string opening;                 ///< what it says of itself and includes
  std::vector<LoopDeclaration> items;  ///< its types and functions
};

/// Leaves out the types and functions that neither `callers` nor what stays names, and headers of
/// which nothing is left: what these include, others include in their place.
void keep_called(std::string_view callers, std::vector<LoopHeader>& headers);

}  // namespace treeline
