#pragma once

#include <vector>

#include "check/generated_library.hpp"
#include "check/report.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Calls function `i` of the library at all states and holds its results to the references: its
/// errors to the bound, from `accurate`; its bits to the graph's, from `exact`, which was compiled
/// without contraction of products and sums (the same library where no flag asks for any). In
/// states of `domain` no error may exceed `generated.rounding`.
FunctionReport judge_function(std::size_t i, const GeneratedFunction& generated,
                              const std::vector<StateReference>& references, Real real,
                              const Domain& domain, const GeneratedLibrary& accurate,
                              const GeneratedLibrary& exact);

/// The value below which the given share of the values lies; the values' order is changed.
double quantile(std::vector<double>& values, double share);

}  // namespace treeline
