#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bounds/dice.hpp"
#include "bounds/domain.hpp"
#include "bounds/propagate_errors.hpp"

namespace treeline::bounds {

/// The inputs of a graph as points of a domain: quaternions have length 1, sines and cosines that
/// are inputs are those of one angle.
class InputSpace {
 public:
  /// Entry by entry of the domain.
  using Point = std::vector<double>;

  InputSpace(const Graph& graph, const Domain& domain);

  /// An input for which the domain has no range; nothing can be drawn then.
  [[nodiscard]] const std::optional<std::string>& missing() const { return missing_; }

  /// Coordinates anywhere, all else at its limits: there errors are largest.
  Point draw(Dice& dice) const;
  /// The same but for up to three entries, drawn anew or moved by any fraction of their range.
  Point change(Point point, Dice& dice) const;
  /// Writes the inputs of state `s` at this point.
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
  };
  std::size_t entry_of(const std::string& name, const Domain& domain);
  double draw_entry(const Entry& entry, Dice& dice) const;

  std::vector<Entry> entries_;
  std::vector<Input> inputs_;
  std::vector<std::vector<std::size_t>> quaternions_;  ///< their entries, those that are inputs
  std::optional<std::string> missing_;
};

}  // namespace treeline::bounds
