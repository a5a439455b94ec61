#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "description/inertias.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr double kRoundingOfFigures = 1e-4;
constexpr double kRoundingOfMoments =
    1e-14;  // m^2: moments of a body of so small a radius are rounding errors
constexpr double kRoundingOfSolver = 0x1p-49;  // of the largest entry; below, a moment is 0
constexpr std::size_t kMostNamed = 5;

double largest_entry(const Inertial& inertial) {
  return std::max({std::abs(inertial.ixx), std::abs(inertial.ixy), std::abs(inertial.ixz),
                   std::abs(inertial.iyy), std::abs(inertial.iyz), std::abs(inertial.izz)});
}

}  // namespace

std::array<double, 3> principal_moments(const Inertial& inertial) {
  // Scaled, so that the solver neither overflows nor underflows.
  const double scale = largest_entry(inertial);
  if (scale <= kRoundingOfMoments * inertial.mass) return {0, 0, 0};
  Eigen::Matrix3d matrix;
  matrix << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,        //
      inertial.ixz, inertial.iyz, inertial.izz;
  matrix /= scale;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix, Eigen::EigenvaluesOnly);
  std::array<double, 3> moments{};
  for (int i = 0; i < 3; ++i) {
    const double moment = solver.eigenvalues()[i];
    moments[static_cast<std::size_t>(i)] =
        std::abs(moment) > kRoundingOfSolver ? moment * scale : 0;
  }
  return moments;
}

std::optional<std::string> find_unphysical(const Inertial& inertial) {
  const auto [least, middle, largest] = principal_moments(inertial);
  const double scale = std::max(std::abs(least), std::abs(largest));
  if (scale == 0) return std::nullopt;
  if (least < -kRoundingOfFigures * scale) {
    return fmt::format(
        "the inertia is indefinite: principal moments {:.6g}, {:.6g}, {:.6g} kg m^2, worst {:.6g}",
        least, middle, largest, least);
  }
  if (largest - (least + middle) > kRoundingOfFigures * scale) {
    return fmt::format(
        "no body has this inertia: of the principal moments {:.6g}, {:.6g}, {:.6g} kg m^2 the "
        "largest exceeds the sum of the others by {:.3g} %",
        least, middle, largest, 100 * (largest - (least + middle)) / largest);
  }
  if (inertial.mass == 0) {
    return fmt::format(
        "the mass is 0 but the moments of inertia are not: principal moments {:.6g}, "
        "{:.6g}, {:.6g} kg m^2",
        least, middle, largest);
  }
  return std::nullopt;
}

void check_inertias(const Robot& robot, const std::vector<UrdfElement>& elements) {
  std::optional<std::string> fault;  // of the first
  std::size_t first = 0;
  std::vector<std::string> others;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const auto& inertial = robot.links[i].inertial;
    auto found = inertial ? find_unphysical(*inertial) : std::nullopt;
    if (!found) continue;
    if (fault) {
      others.push_back(fmt::format("\"{}\"", robot.links[i].name));
    } else {
      fault = std::move(found);
      first = i;
    }
  }
  if (!fault) return;
  if (!others.empty()) *fault += "; so it is with " + list_first(others, kMostNamed);
  const auto* xml = elements[first].xml().FirstChildElement("inertial");
  elements[first].as_child(*xml).warn(
      *fault,
      "check the units (kg m^2, about the centre of mass) and the signs of the products; "
      "the numbers are used as they are");
}

}  // namespace treeline
