#pragma once

#include "program/ending.hpp"

namespace treeline {

/// The function whose straight lines end with this call: its graph is that of the lines and the
/// operations of the routine as they are written, which emitted code executes.
Program end_lines(Ending ending);

/// `change` of the straight lines of a program, which are all of it if nothing follows.
template <class Change>
Program change_lines(Program program, const Change& change) {
  if (!program.ending) return change(std::move(program));
  Ending ending = *program.ending;
  ending.lines = change(std::move(ending.lines));
  return end_lines(std::move(ending));
}

}  // namespace treeline
