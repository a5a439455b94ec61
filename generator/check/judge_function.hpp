#pragma once

#include <vector>

#include "check/report.hpp"
#include "compilation/generated_library.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Calls function `i` of the libraries at all states and compares its results with the references.
/// Errors of `accurate` are compared with the bound. Bits of `exact`, which was compiled without
/// contraction of products and sums, are compared with those of the graph. (Both are the same
/// library if no flag asks for contraction.) In states within `domain` no error may exceed
/// `generated.rounding`.
FunctionReport judge_function(std::size_t i, const GeneratedFunction& generated,
                              const std::vector<StateReference>& references, Real real,
                              const Domain& domain, const GeneratedLibrary& accurate,
                              const GeneratedLibrary& exact);

/// Whether the numbers are equal including their signs, or both are NaN.
bool same_bits(double a, double b);

/// Whether results are those of the function's graph to the bit. Of loops over links, and of a
/// solve for columns, zeros may have another sign, since they add zeros that the graph leaves out,
/// and where the function is singular there may be NaN in place of numbers.
bool are_bits_of_graph(const GeneratedFunction& generated, const std::vector<double>& results,
                       const FunctionReference& reference);

/// Value below which the given share of the values lies. Changes the order of the values.
double quantile(std::vector<double>& values, double share);

}  // namespace treeline
