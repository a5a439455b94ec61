#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// The largest magnitude that a bound allows each input of the emitted functions, by argument.
/// Sines and cosines that are inputs themselves lie on the unit circle, see `lie_on_circle`.
struct Domain {
  std::map<std::string, std::vector<double>, std::less<>> sizes;
  /// The same for every entry of arguments whose length is the function's own matter.
  std::map<std::string, double, std::less<>> each;
  /// Where in q the four entries of a quaternion, which has length 1, begin.
  std::vector<std::size_t> quaternions;

  /// Of an input as the graph names it: `qd[3]`. Nothing where no range is stated.
  [[nodiscard]] std::optional<double> find(std::string_view input) const;
  /// Whether these values of an argument are in the domain; not where no range is stated.
  [[nodiscard]] bool contains(std::string_view argument, const std::vector<double>& values) const;
};

/// Joint limits, velocity and effort limits of the URDF; where it is silent, the ranges of
/// `kQuantities`. Entries of quaternions are at most 1.
Domain make_domain(const Robot& robot, const Scene& scene, const Mechanism& mechanism);

/// `|q| <= 2.8 3.1 ..., |qd| <= 10`: of these arguments; one number where all are the same; and
/// that sines and cosines, where they are arguments, lie on the unit circle.
std::string describe(const Domain& domain, const std::vector<std::string>& arguments);

}  // namespace treeline
