#include "simulation/collide.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include "interpreter/instances.hpp"

namespace treeline::simulation {
namespace {

using FclGeometry = std::shared_ptr<fcl::CollisionGeometryd>;

FclGeometry geometry_of(const Shape& shape) {
  const Vector3& s = shape.size;
  switch (shape.kind) {
    case ShapeKind::sphere:
      return std::make_shared<fcl::Sphered>(s.x());
    case ShapeKind::capsule:
      return std::make_shared<fcl::Capsuled>(s.x(), s.y());
    case ShapeKind::cylinder:
      return std::make_shared<fcl::Cylinderd>(s.x(), s.y());
    case ShapeKind::box:
      return std::make_shared<fcl::Boxd>(s);
    case ShapeKind::half_space:
      break;
  }
  return std::make_shared<fcl::Halfspaced>(fcl::Vector3d::UnitZ(), 0.0);
}

int root_of(const Model& model, int body) {
  while (body != interpreter::kWorld && model.body(body).parent != interpreter::kWorld) {
    body = model.body(body).parent;
  }
  return body;
}

}  // namespace

struct CollisionScene::Geometry {
  std::vector<FclGeometry> of_shapes;
};

CollisionScene::CollisionScene(const Model& model, std::vector<Shape> shapes)
    : shapes_(std::move(shapes)), geometry_(std::make_unique<Geometry>()) {
  const int count = static_cast<int>(shapes_.size());
  for (int i = 0; i < count; ++i) {
    const Shape& shape = shapes_[static_cast<std::size_t>(i)];
    geometry_->of_shapes.push_back(geometry_of(shape));
    for (int j = 0; j < count; ++j) {
      const Shape& other = shapes_[static_cast<std::size_t>(j)];
      const int root = root_of(model, shape.body);
      const int other_root = root_of(model, other.body);
      // The shape whose root has the higher index is `shape`, so the world is always `other`.
      if (root > other_root) pairs_.emplace_back(i, j);
    }
  }
}

CollisionScene::~CollisionScene() = default;
CollisionScene::CollisionScene(CollisionScene&&) noexcept = default;
CollisionScene& CollisionScene::operator=(CollisionScene&&) noexcept = default;

std::vector<Touch> CollisionScene::touches(const Model& model, const Vector& q) const {
  const auto k = interpreter::kinematics<double>(model, q, Vector::Zero(model.nv));
  std::vector<fcl::CollisionObjectd> objects;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Shape& shape = shapes_[i];
    const Matrix3& R = k.R_world[shape.body];
    objects.emplace_back(geometry_->of_shapes[i], R * shape.R, k.p_world[shape.body] + R * shape.p);
  }
  std::vector<Touch> touches;
  for (const auto& [shape, other] : pairs_) {
    const auto a = static_cast<std::size_t>(shape);
    const auto b = static_cast<std::size_t>(other);
    const fcl::CollisionRequestd request(1, true);
    fcl::CollisionResultd result;
    fcl::collide(&objects[b], &objects[a], request, result);
    if (!result.isCollision()) continue;
    const fcl::Contactd& contact = result.getContact(0);  // its normal points from the first shape
                                                          // outward
    touches.push_back({shape, other, shapes_[a].body, shapes_[b].body, contact.pos, contact.normal,
                       contact.penetration_depth});
  }
  return touches;
}

}  // namespace treeline::simulation
