#pragma once

#include <optional>

#include "emission/selftest_facts.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Adds NAME_selftest to the files, if the scene asks for it. Functions are called in states drawn
/// within limits, the same on every machine. What is expected are the bits of the expression graph,
/// which `check` holds compiled code to; they must be within the bounds of `check` of the
/// interpreter in 50 digits. The controller's step is compiled and run here. Errors: too few states
/// are within their bounds; the step does not compile.
bool add_selftest(const Robot& robot, const Scene& scene, Generation& generation,
                  Diagnostics& diagnostics);

/// A number of 20 bits next to this one, which is exact in Real and survives other last digits of
/// a machine's mathematical library.
double shorten(double number);

/// Compiles the controller for this machine without contraction and runs it over a short motion: a
/// few steps under each command that its laws know, on joints that move at steady velocities.
/// Errors: it does not compile.
std::optional<SelftestFacts::Motion> record_selftest_motion(const Robot& robot, const Scene& scene,
                                                            const Generation& generation,
                                                            Diagnostics& diagnostics);

}  // namespace treeline
