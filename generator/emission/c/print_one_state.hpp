#pragma once

#include <string>
#include <string_view>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// Statements around a call for one of many states, whose numbers stand in rows of them.
struct OneState {
  std::string arrays;     ///< declarations of the state's arguments and results
  std::string before;     ///< copies of what is read to these
  std::string behind;     ///< copies of results to the rows
  std::string arguments;  ///< of the call
};

/// Which arguments a call has: all, or those alone that the function reads.
enum class Passed { all, read };

/// The rows of many states.
struct Rows {
  std::string element;  ///< element i of an argument, a format of its name: `{}_rows[(i * 8) + k]`
  std::string_view counter;  ///< type of i
};

/// Prints what stands around a call of the program's function for the state k in rows: a call on
/// arrays of its own, since functions of one state take neighbouring elements.
OneState print_one_state(const EmissionContext& context, const Program& program, const Rows& rows,
                         Passed passed);

}  // namespace treeline::c
