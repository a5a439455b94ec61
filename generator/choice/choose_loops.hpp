#pragma once

#include <span>
#include <vector>

#include "choice/generated_function.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/link_loops.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Makes a function that was generated as straight lines one that loops over a table of links, if
/// it has this form and its code is estimated to be smaller so; with `always` whether it is or not,
/// and without this form an error. Its program is as traced, see `trace_loops`. `mechanism` is the
/// whole scene's, the same for all functions, which share its table; loops take no more operations
/// for that.
void choose_loops(const Mechanism& mechanism, const Scene& scene, bool always,
                  GeneratedFunction& generated, Diagnostics& diagnostics);

/// A function of a program that calls several, as straight lines.
struct LoopCandidate {
  Function function;
  const Program* lines;
  int flops;  ///< that the lines take in the program
};

/// The functions as loops over one table of links, which reads given sines; empty where the code is
/// estimated to be smaller as straight lines, or where one of them has no such form.
std::vector<Program> choose_loops_together(const Mechanism& mechanism, const Scene& scene,
                                           std::span<const LoopCandidate> candidates);

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
