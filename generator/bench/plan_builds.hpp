#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/variant.hpp"
#include "description/robot.hpp"

namespace treeline {

/// Everything that generated code of a robot in a scene can differ in, one thing at a time: first
/// the code that the scene asks for, then other lanes and the other Real, each other route, full
/// inertias, other accuracies, sines given or of the C library, no contraction. `flags` are the
/// compiler's; those that contract nothing get -ffp-contract=off behind them. A variant whose
/// source is that of an earlier one is not there, but named in `Variant::repeats`.
std::optional<std::vector<VariantBuild>> plan_builds(const Robot& robot, const Scene& scene,
                                                     const std::string& flags,
                                                     Diagnostics& diagnostics);

/// The first of these builds alone.
std::optional<VariantBuild> plan_emitted(const Robot& robot, const Scene& scene,
                                         const std::string& flags, Diagnostics& diagnostics);

/// The function in the same mechanism by each of its routes, in the coordinates that cost least
/// there; the cheapest first, which is the one that is emitted.
std::vector<GeneratedFunction> generate_routes(const Mechanism& mechanism, Function function,
                                               int lanes, Sines sin_cos);

}  // namespace treeline
