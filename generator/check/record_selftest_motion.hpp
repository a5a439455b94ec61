#pragma once

#include <optional>

#include "emission/selftest_facts.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

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
