#include "bounds/draw_body.hpp"

#include <cmath>
#include <cstddef>

namespace treeline::bounds {
namespace {

using Triple = std::array<double, 3>;

/// L L^T / 6 of a triangular matrix with these entries: its trace is at most 1.
std::array<Triple, 3> spread(const std::array<double, kInertialParameters>& choice) {
  const std::array<Triple, 3> L = {
      {{choice[4], 0, 0}, {choice[5], choice[7], 0}, {choice[6], choice[8], choice[9]}}};
  std::array<Triple, 3> product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += L[i][k] * L[j][k] / 6;
    }
  }
  return product;
}

}  // namespace

std::array<double, kInertialParameters> body_of(
    const BodyRange& range, const std::array<double, kInertialParameters>& choice) {
  const double least = range.whole ? kLeastShare : 0;
  const double m = range.mass * (least + (1 - least) * std::abs(choice[0]));
  const double core = least * least * range.reach * range.reach;  // second moment of a unit mass
  const double square = range.reach * range.reach - 3 * core;
  Triple c{};
  double rest = square;
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = choice[i + 1] * std::sqrt(square / 3);
    rest -= c[i] * c[i];
  }
  if (rest < 0) rest = 0;  // by rounding
  const std::array<Triple, 3> shape = spread(choice);
  std::array<Triple, 3> Sigma{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Sigma[i][j] = m * (c[i] * c[j] + rest * shape[i][j] + (i == j ? core : 0));
    }
  }
  return {m,
          m * c[0],
          m * c[1],
          m * c[2],
          Sigma[1][1] + Sigma[2][2],
          -Sigma[0][1],
          Sigma[0][0] + Sigma[2][2],
          -Sigma[0][2],
          -Sigma[1][2],
          Sigma[0][0] + Sigma[1][1]};
}

}  // namespace treeline::bounds
