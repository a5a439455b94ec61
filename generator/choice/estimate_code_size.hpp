#pragma once

#include "description/scene.hpp"
#include "program/link_loops.hpp"

namespace treeline {

/// Bytes that a function of so many operations takes as straight lines by `-Os`, an estimate.
double bytes_of_lines(const Scene& scene, int flops);

/// Parts of the loops over a table of links, and of the table, that functions need.
class LoopNeeds {
 public:
  void add(Function function, const LinkLoops& loops);

  /// Bytes of all of these by `-Os`, an estimate.
  double bytes(const Scene& scene) const;

 private:
  bool moves_ = false;  ///< motions and wrenches of links
  bool has_inertias_ = false;
  bool has_rows_ = false;
  bool accelerates_ = false;  ///< passes of `forward_dynamics` beside these
  bool controls_ = false;     ///< forces along rows
  int inputs_ = 0;            ///< arguments that change the table
  double numbers_ = 0;        ///< of the table
};

}  // namespace treeline
