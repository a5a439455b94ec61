#pragma once

#include <memory>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline::tests {

/// M of a robot in a scene, in 50 digits.
class ExactMassMatrix {
 public:
  ExactMassMatrix(const Robot& robot, const Scene& scene);
  ~ExactMassMatrix();

  /// Whether M has no inverse at q: a pivot of its factorization is only a rounding error of 50
  /// digits.
  [[nodiscard]] bool is_singular(const std::vector<double>& q) const;

 private:
  struct Model;
  std::unique_ptr<const Model> model_;
};

}  // namespace treeline::tests
