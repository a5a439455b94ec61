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
  /// m. sphere: radius; capsule, cylinder: radius and length along z, a capsule's without its
  /// caps; box: edges; half_space: none, matter is where z < 0.
  Vector3 size = Vector3::Zero();
  int body = interpreter::kWorld;
  Matrix3 R = Matrix3::Identity();  ///< in the body's frame
  Vector3 p = Vector3::Zero();
};

/// Two shapes overlap, at one point.
struct Touch {
  int shape = 0;  ///< indices of shapes
  int other = 0;
  int body = 0;  ///< that carries `shape`
  int other_body = interpreter::kWorld;
  Vector3 position = Vector3::Zero();  ///< half-way into the overlap, world
  Vector3 normal = Vector3::UnitZ();   ///< out of `other`, world
  double depth = 0;                    ///< m
};

/// Which shapes touch, by FCL. Shapes of one robot do not touch each other: a pair counts when its
/// bodies hang on different roots, an object on its own floating joint and the world being such.
class CollisionScene {
 public:
  CollisionScene(const Model& model, std::vector<Shape> shapes);
  ~CollisionScene();
  CollisionScene(CollisionScene&&) noexcept;
  CollisionScene& operator=(CollisionScene&&) noexcept;

  [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }
  /// In the order of the shapes. FCL gives a pair one point, of a box on a plane one corner's.
  [[nodiscard]] std::vector<Touch> touches(const Model& model, const Vector& q) const;

 private:
  struct Geometry;
  std::vector<Shape> shapes_;
  std::vector<std::pair<int, int>> pairs_;
  std::unique_ptr<Geometry> geometry_;
};

}  // namespace treeline::simulation
