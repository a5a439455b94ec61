#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace treeline::c {

/// A header of loops over links, in C.
struct LoopHeader {
  std::string name;                ///< `link_rows.h`
  std::string opening;             ///< what it says of itself and includes
  std::vector<std::string> items;  ///< its types and functions
};

/// Leaves out the types and functions that neither `callers` nor what stays names, and headers of
/// which nothing is left: what these include, others include in their place.
void keep_called(std::string_view callers, std::vector<LoopHeader>& headers);

}  // namespace treeline::c
