#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "functions/quantity.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Base parameters are combinations of numbers that are drawn in their stead: ten of each body,
/// then rotors and coefficients of friction, from 0 to these sizes.
struct BaseDomain {
  std::vector<SceneInertia> bodies;
  std::vector<double> drives;
  std::vector<std::vector<std::pair<std::size_t, double>>> rows;  ///< coefficients of those numbers
};

/// Domain of a rounding bound: the largest magnitude of each input of the emitted functions, by
/// argument. Sines and cosines that are inputs themselves lie on the unit circle, see
/// `lie_on_circle`.
struct Domain {
  std::map<std::string, std::vector<double>, std::less<>> sizes;
  /// Largest magnitude of every entry, by argument, for arguments whose length depends on the
  /// function.
  std::map<std::string, double, std::less<>> each;
  /// Place of each quaternion: the argument, and the index of the first of its four entries.
  /// Quaternions have length 1.
  std::vector<std::pair<Quantity, std::size_t>> quaternions;

  BaseDomain base;  ///< empty unless base parameters are an argument

  /// Largest magnitude of an input, given by its name in the graph (`qd[3]`). Nothing if no range
  /// is stated.
  [[nodiscard]] std::optional<double> find(std::string_view input) const;
  /// Whether these values of an argument lie in the domain. False if no range is stated.
  [[nodiscard]] bool contains(std::string_view argument, const std::vector<double>& values) const;
};

/// Makes the domain from the position, velocity and effort limits of the URDF; where it states
/// none, from the ranges of `kQuantities`. Entries of quaternions are at most 1.
Domain make_domain(const Robot& robot, const Scene& scene, const Mechanism& mechanism);

/// Mass, first moment and rotational inertia of matter within reach of the origin, of each body.
std::vector<double> inertia_sizes(const std::vector<SceneInertia>& bodies);

/// Describes the domain of these arguments: `|q| <= 2.8 3.1 ..., |qd| <= 10`, with a single number
/// if all entries have the same limit. If sines and cosines are arguments, the text says that they
/// lie on the unit circle; if inertial parameters are, that they are those of bodies.
std::string describe(const Domain& domain, const std::vector<std::string>& arguments);

}  // namespace treeline
