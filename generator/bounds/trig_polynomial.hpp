#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "program/program.hpp"

namespace treeline::bounds {

/// Names an angle: the node whose sine and cosine are taken, or an input's. Zero: none.
using Angle = std::uint32_t;

/// c[0] + c[1] cos + c[2] sin + c[3] cos 2 + c[4] sin 2 of one angle; of none where it is constant.
struct TrigPolynomial {
  Angle angle = 0;
  std::array<double, 5> c{};

  [[nodiscard]] bool is_constant() const { return angle == 0; }
  /// At an angle whose cosine and sine are these.
  [[nodiscard]] double at(double cosine, double sine) const {
    return c[0] + c[1] * cosine + c[2] * sine + c[3] * (cosine * cosine - sine * sine) +
           c[4] * 2 * sine * cosine;
  }
  /// No magnitude of it is larger.
  [[nodiscard]] double magnitude() const;
};

TrigPolynomial constant(double value);
TrigPolynomial operator-(TrigPolynomial p);
/// Nothing where two angles meet, or a product would be of third degree.
std::optional<TrigPolynomial> add(const TrigPolynomial& a, const TrigPolynomial& b);
std::optional<TrigPolynomial> multiply(const TrigPolynomial& a, const TrigPolynomial& b);

/// Of each node its polynomial where it is one of at most second degree in one angle: sines and
/// cosines, constants, and what is made of them. Inputs `sin_q[i]` and `cos_q[i]` count as sine and
/// cosine of one angle.
std::vector<std::optional<TrigPolynomial>> find_polynomials(const Graph& graph);

}  // namespace treeline::bounds
