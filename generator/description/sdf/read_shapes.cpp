#include <fmt/format.h>

#include <sdf/Box.hh>
#include <sdf/Collision.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Geometry.hh>
#include <sdf/Material.hh>
#include <sdf/Mesh.hh>
#include <sdf/Sphere.hh>
#include <sdf/Visual.hh>
#include <string_view>
#include <utility>

#include "description/sdf/flatten_model.hpp"

namespace treeline {
namespace {

std::string three(const ignition::math::Vector3d& v) {
  return fmt::format("{} {} {}", v.X(), v.Y(), v.Z());
}

std::string mesh_path(const std::string& uri) {
  constexpr std::string_view kModel = "model://";
  return uri.starts_with(kModel) ? "package://" + uri.substr(kModel.size()) : uri;
}

/// False for a kind that URDF does not have.
bool read_geometry(const sdf::Geometry& geometry, FlatShape& shape) {
  if (const auto* box = geometry.BoxShape()) {
    shape.kind = "box";
    shape.size_name = "size";
    shape.size = three(box->Size());
  } else if (const auto* cylinder = geometry.CylinderShape()) {
    shape.kind = "cylinder";
    shape.size_name = "radius";
    shape.size = fmt::format("{}", cylinder->Radius());
    shape.more_name = "length";
    shape.more = fmt::format("{}", cylinder->Length());
  } else if (const auto* sphere = geometry.SphereShape()) {
    shape.kind = "sphere";
    shape.size_name = "radius";
    shape.size = fmt::format("{}", sphere->Radius());
  } else if (const auto* mesh = geometry.MeshShape()) {
    shape.kind = "mesh";
    shape.size_name = "filename";
    shape.size = mesh_path(mesh->Uri());
    shape.more_name = "scale";
    shape.more = three(mesh->Scale());
  } else {
    return false;
  }
  return true;
}

/// The shape of a visual or a collision; nothing where there is none to show.
template <class Element>
void add_shape(const Element& element, FlatShape shape, std::vector<FlatShape>& shapes) {
  ignition::math::Pose3d pose;
  if (element.Geom() == nullptr || !element.SemanticPose().Resolve(pose).empty()) return;
  if (!read_geometry(*element.Geom(), shape)) return;
  shape.pose = to_isometry(pose);
  shapes.push_back(std::move(shape));
}

}  // namespace

std::vector<FlatShape> read_shapes(const sdf::Link& link) {
  std::vector<FlatShape> shapes;
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    const sdf::Visual& visual = *link.VisualByIndex(i);
    FlatShape shape;
    if (visual.Material() != nullptr) {
      const auto color = visual.Material()->Diffuse();
      shape.color = fmt::format("{} {} {} {}", color.R(), color.G(), color.B(), color.A());
    }
    add_shape(visual, shape, shapes);
  }
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    FlatShape shape;
    shape.collides = true;
    add_shape(*link.CollisionByIndex(i), shape, shapes);
  }
  return shapes;
}

}  // namespace treeline
