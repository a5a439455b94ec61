#pragma once

#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "bounds/search_rounding.hpp"
#include "functions/function.hpp"
#include "program/program.hpp"

namespace treeline {

/// What the rounding errors of the emitted code are at most anywhere in a domain, against exact
/// arithmetic on the same inputs and the same constants, as printed. Sines and cosines of at most
/// 1.0 ulp and every operation count; products and sums may be contracted or not, so that it holds
/// for all compilers and flags but -ffast-math. Absolute, SI units.
struct RoundingBound {
  enum class Kind {
    none,      ///< `missing` says why
    proven,    ///< there is no worse input
    searched,  ///< of first order, `kSearchMargin` times the worst that a search met
    typical,   ///< of first order, at 50, 90 and 99 of 100 states: singularities have no bound
  };
  Kind kind = Kind::none;
  std::string missing = "it was not computed";
  std::vector<double> size, error;               ///< proven: of all results' entries, in order
  std::vector<bounds::FoundError> worst;         ///< searched: of each result
  std::vector<bounds::TypicalErrors> at_states;  ///< typical: of each result

  [[nodiscard]] bool is_proven() const { return kind == Kind::proven; }
  [[nodiscard]] bool is_first_order() const {
    return kind == Kind::searched || kind == Kind::typical;
  }
};

/// How much more than a search met is stated: searches of a hundred times the effort found at most
/// 2.5 times as much.
inline constexpr double kSearchMargin = 4;

/// Proven where nothing is divided; else searched, or typical when `solve` may be singular in the
/// domain. `unit` is 2^-53 for double, 2^-24 for float.
RoundingBound bound_rounding(const Program& program, const Domain& domain, double unit,
                             Solve solve);

/// `2.9e-12 in tau (tau[0]; 21 ulp of 1.3e+03, the most that tau can be)` for each result, or why
/// there is no bound.
std::string describe(const RoundingBound& bound, const Program& program, double unit);

}  // namespace treeline
