#pragma once

#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "bounds/search_rounding.hpp"
#include "functions/function.hpp"
#include "program/program.hpp"

namespace treeline {

/// Bound of the rounding errors of emitted code anywhere in a domain, against exact arithmetic on
/// the same inputs and the same printed constants. Every operation counts, and sines and cosines
/// count with at most 1.0 ulp. Products and sums may be contracted or not, so the bound holds for
/// all compilers and all flags except -ffast-math. Bounds are absolute, in SI units.
struct RoundingBound {
  enum class Kind {
    none,      ///< no bound; `missing` says why
    proven,    ///< no input is worse
    searched,  ///< first order; `kSearchMargin` times the worst that a search met
    typical,   ///< first order, in 50, 90 and 99 of 100 states; singularities have no bound
  };
  Kind kind = Kind::none;
  std::string missing = "it was not computed";
  std::vector<double> size, error;               ///< proven: of all entries of all results
  std::vector<bounds::FoundError> worst;         ///< searched: for each result
  std::vector<bounds::TypicalErrors> at_states;  ///< typical: for each result

  [[nodiscard]] bool is_proven() const { return kind == Kind::proven; }
  [[nodiscard]] bool is_first_order() const {
    return kind == Kind::searched || kind == Kind::typical;
  }
};

/// Ratio of the stated bound to the worst error that a search met. Searches with a hundred times
/// the effort found at most 2.5 times as much.
inline constexpr double kSearchMargin = 4;

/// Bounds the rounding errors of a program. The bound is proven if the program has no division;
/// otherwise it is searched, or typical if `solve` may be singular in the domain. `unit` is 2^-53
/// for double, 2^-24 for float.
RoundingBound bound_rounding(const Program& program, const Domain& domain, double unit,
                             Solve solve);

/// Describes the bound of each result, `2.9e-12 in tau (tau[0]; 21 ulp of 1.3e+03, the most that
/// tau can be)`, or says why there is none.
std::string describe(const RoundingBound& bound, const Program& program, double unit);

}  // namespace treeline
