#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/variant.hpp"
#include "choice/run_routes.hpp"
#include "description/robot.hpp"

namespace treeline {

/// Plans builds of all variants of generated code for a robot in a scene, each with one difference:
/// first the code that the scene asks for, then that in C and that of eight states a call, other
/// lanes and the other Real, each other route, full inertias, other accuracies, sines given or from
/// the C library, no contraction. `flags` are those of the compiler; -ffp-contract=off is appended
/// for builds without contraction. Only variants of `groups` are planned; empty: all. A variant
/// whose source equals that of an earlier one is left out and named in `Variant::repeats`.
std::optional<std::vector<VariantBuild>> plan_builds(const Robot& robot, const Scene& scene,
                                                     const std::string& flags,
                                                     const std::vector<VariantGroup>& groups,
                                                     Diagnostics& diagnostics);

/// Whether `groups` ask for a kind of variants, as they do for all where they are empty.
bool is_wanted(VariantGroup group, const std::vector<VariantGroup>& groups);

/// Plans only the first of these builds, the code that the scene asks for.
std::optional<VariantBuild> plan_emitted(const Robot& robot, const Scene& scene,
                                         const std::string& flags, Diagnostics& diagnostics);

/// Generates the function by each of its routes from the same mechanism, none of them pruned, in
/// the coordinates that are cheapest for the route. The first one is emitted; routes that can only
/// be chosen by their name come last.
std::vector<GeneratedFunction> generate_routes(const Mechanism& mechanism, Function function,
                                               RouteOptions options);

}  // namespace treeline
