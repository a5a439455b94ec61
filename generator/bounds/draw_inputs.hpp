#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bounds/domain.hpp"
#include "bounds/draw_body.hpp"
#include "bounds/propagate_errors.hpp"
#include "bounds/rng.hpp"

namespace treeline::bounds {

/// The inputs of a graph as points of a domain. Quaternions have length 1. Sines and cosines that
/// are inputs belong to one angle each. Inertial parameters are those of bodies.
class InputSpace {
 public:
  /// One number for each entry of the domain.
  using Point = std::vector<double>;

  InputSpace(const Graph& graph, const Domain& domain);

  /// Name of an input for which the domain has no range. Nothing can be drawn then.
  [[nodiscard]] const std::optional<std::string>& missing() const { return missing_; }

  /// Draws a point: coordinates anywhere in their range, everything else at its limits, where
  /// errors are largest.
  Point draw(Rng& rng) const;
  /// Changes up to three entries of a point: draws them anew or moves them by any fraction of their
  /// range.
  Point change(Point point, Rng& rng) const;
  /// Writes this point to `inputs` as their state number `s`.
  void put(const Point& point, std::size_t s, std::vector<States>& inputs) const;

 private:
  enum class Reading { plain, sine, cosine };
  struct Input {
    std::size_t entry = 0;
    Reading reading = Reading::plain;
  };
  struct Entry {
    std::string name;
    double size = 0;
    bool coordinate = false;
    bool positive = false;  ///< a step of time, a share, a rotor, a coefficient of friction
  };
  /// Entries of ten inertial parameters that are inputs.
  struct Body {
    std::array<std::size_t, kInertialParameters> entries{};
    BodyRange range;
  };
  /// A base parameter, and the coefficients of the entries that it combines.
  struct Base {
    std::size_t entry = 0;
    std::vector<std::pair<std::size_t, double>> terms;
  };
  void find_bodies(Quantity quantity, const Graph& graph, const Domain& domain);
  void find_base(const Graph& graph, const Domain& domain);
  void put_bodies(Point& values) const;
  std::size_t entry_of(const std::string& name, const Domain& domain);
  double draw_entry(const Entry& entry, Rng& rng) const;

  std::vector<Entry> entries_;
  std::vector<Input> inputs_;
  std::vector<std::vector<std::size_t>> quaternions_;  ///< indices of their entries that are inputs
  std::vector<Body> bodies_;
  std::vector<Base> bases_;
  std::optional<std::string> missing_;
};

}  // namespace treeline::bounds
