#pragma once

#include <memory>
#include <string>
#include <vector>

#include "simulation/state.hpp"

namespace treeline::simulation {

enum class ShapeKind { sphere, capsule, cylinder, box, half_space };

/// A convex body fixed to a link or to the world.
struct Shape {
  std::string name;
  ShapeKind kind = ShapeKind::sphere;
  /// Size in m. Sphere: radius. Capsule and cylinder: radius, and length along z, for a capsule
  /// without its caps. Box: edges. Half space: none; matter is where z < 0.
  Vector3 size = Vector3::Zero();
  int body = interpreter::kWorld;
  Matrix3 R = Matrix3::Identity();  ///< in the body's frame
  Vector3 p = Vector3::Zero();
};

/// Overlap of two shapes, as a single point; or a joint at its stop, whose `normal` is x or -x of
/// an axis of its own, for coordinates that grow or fall on the way out.
struct Touch {
  int shape = 0;  ///< index of a shape
  int other = 0;
  int body = 0;  ///< body that carries `shape`
  int other_body = interpreter::kWorld;
  Vector3 position = Vector3::Zero();  ///< middle of the overlap, world axes
  Vector3 normal = Vector3::UnitZ();   ///< pointing out of `other`, world axes
  double depth = 0;                    ///< m; negative where they do not touch yet
  int joint = -1;      ///< velocity of a joint at its stop; such a touch is of no body
  int point = 0;       ///< which of the shape's, where it has several
  double allowed = 0;  ///< m/s: a blow may leave so much approach; none where they overlap
  Vector3 start = Vector3::Zero();  ///< N s, a guess of the impulse on `body`
};

/// Finds the shapes that touch, using FCL. Only pairs of shapes on different roots count, so shapes
/// of one robot do not touch each other. An object on its own floating joint is a root, and so is
/// the world.
class CollisionScene {
 public:
  CollisionScene(const Model& model, std::vector<Shape> shapes);
  ~CollisionScene();
  CollisionScene(CollisionScene&&) noexcept;
  CollisionScene& operator=(CollisionScene&&) noexcept;

  [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }
  /// Touches at coordinates `q`, in the order of the shapes. FCL returns one point per pair; for a
  /// box on a plane this is one of the corners.
  [[nodiscard]] std::vector<Touch> touches(const Model& model, const Vector& q) const;

 private:
  struct Geometry;
  std::vector<Shape> shapes_;
  std::vector<std::pair<int, int>> pairs_;
  std::unique_ptr<Geometry> geometry_;
};

}  // namespace treeline::simulation
