#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/generated_file.hpp"
#include "program/program.hpp"

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

/// Code that uses the loops: bodies of the functions that loop, and the robot's tables.
std::string join_callers(std::span<const Program> programs,
                         const std::function<std::string(const Program&)>& print_body,
                         const std::vector<GeneratedFile>& tables);

/// Leaves out the types and functions that neither `callers` nor what stays names, and headers of
/// which nothing is left: what these include, others include in their place.
void keep_called(std::string_view callers, std::vector<LoopHeader>& headers);

}  // namespace treeline
