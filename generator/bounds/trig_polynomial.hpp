#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "program/program.hpp"

namespace treeline::bounds {

/// Identifies an angle by the node whose sine and cosine are taken, or by an input `sin_q[i]`. 0
/// means none.
using Angle = std::uint32_t;

/// c[0] + c[1] cos x + c[2] sin x + c[3] cos 2x + c[4] sin 2x of one angle x. Constants have no
/// angle.
struct TrigPolynomial {
  Angle angle = 0;
  std::array<double, 5> c{};

  [[nodiscard]] bool is_constant() const { return angle == 0; }
  /// Value at the angle with this cosine and sine.
  [[nodiscard]] double at(double cosine, double sine) const {
    return c[0] + c[1] * cosine + c[2] * sine + c[3] * (cosine * cosine - sine * sine) +
           c[4] * 2 * sine * cosine;
  }
  /// Upper bound of the magnitude over all angles.
  [[nodiscard]] double magnitude() const;
};

TrigPolynomial constant(double value);
TrigPolynomial operator-(TrigPolynomial p);
/// Sum and product of two polynomials. Nothing if their angles differ, or if a product is of more
/// than second degree.
std::optional<TrigPolynomial> add(const TrigPolynomial& a, const TrigPolynomial& b);
std::optional<TrigPolynomial> multiply(const TrigPolynomial& a, const TrigPolynomial& b);

/// Finds for each node its polynomial of at most second degree in one angle, if it has one: sines,
/// cosines, constants, and their sums and products. Inputs `sin_q[i]` and `cos_q[i]` count as sine
/// and cosine of one angle.
std::vector<std::optional<TrigPolynomial>> find_polynomials(const Graph& graph);

}  // namespace treeline::bounds
