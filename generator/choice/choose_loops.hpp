#pragma once

#include <span>
#include <vector>

#include "choice/generated_function.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
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

}  // namespace treeline
