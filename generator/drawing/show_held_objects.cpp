#include "drawing/show_held_objects.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "description/rotation.hpp"

namespace treeline {
namespace {

using tinyxml2::XMLElement;

void set_origin(XMLElement& element, const Pose& pose) {
  const auto& xyz = pose.xyz;
  const auto& rpy = pose.rpy;
  XMLElement* const origin = element.InsertNewChildElement("origin");
  origin->SetAttribute("xyz", fmt::format("{} {} {}", xyz[0], xyz[1], xyz[2]).c_str());
  origin->SetAttribute("rpy", fmt::format("{} {} {}", rpy[0], rpy[1], rpy[2]).c_str());
}

/// The pose `inner`, which is in the frame `outer`, in the frame that `outer` is in.
Pose composed(const Pose& outer, const Pose& inner) {
  const Eigen::Matrix3d R = rotation_from_rpy<double>(outer.rpy);
  const Eigen::Vector3d p =
      Eigen::Vector3d(outer.xyz.data()) + R * Eigen::Vector3d(inner.xyz.data());
  const Eigen::Matrix3d both = R * rotation_from_rpy<double>(inner.rpy);
  return {{p.x(), p.y(), p.z()}, rpy_from_rotation(both)};
}

void add_visual(const SceneShape& shape, XMLElement& link) {
  XMLElement* const visual = link.InsertNewChildElement("visual");
  set_origin(*visual, shape.origin);
  XMLElement* const geometry = visual->InsertNewChildElement("geometry");
  if (shape.radius > 0) {
    geometry->InsertNewChildElement("sphere")->SetAttribute("radius", shape.radius);
  } else {
    const auto& [x, y, z] = shape.size;
    geometry->InsertNewChildElement("box")->SetAttribute("size",
                                                         fmt::format("{} {} {}", x, y, z).c_str());
  }
  XMLElement* const material = visual->InsertNewChildElement("material");
  material->SetAttribute("name", "held");
  material->InsertNewChildElement("color")->SetAttribute("rgba", "0.79 0.66 0.46 1");
}

}  // namespace

std::string show_held_objects(const std::string& urdf_text, const Scene& scene,
                              const std::vector<std::vector<SceneShape>>& shapes) {
  tinyxml2::XMLDocument document;
  const bool well = document.Parse(urdf_text.c_str(), urdf_text.size()) == tinyxml2::XML_SUCCESS;
  XMLElement* const robot = well ? document.RootElement() : nullptr;
  if (robot == nullptr) return urdf_text;
  for (std::size_t i = 0; i < scene.objects.size() && i < shapes.size(); ++i) {
    const SceneGrasp& grasp = scene.objects[i].grasps.front();
    const auto& points = scene.operational_points;
    const auto hand = std::find_if(points.begin(), points.end(), [&](const ScenePoint& point) {
      return point.name == grasp.point;
    });
    if (shapes[i].empty() || hand == points.end()) continue;
    const std::string name = scene.objects[i].name + ", held";
    XMLElement* const link = robot->InsertNewChildElement("link");
    link->SetAttribute("name", name.c_str());
    for (const SceneShape& shape : shapes[i]) add_visual(shape, *link);
    XMLElement* const joint = robot->InsertNewChildElement("joint");
    joint->SetAttribute("name", name.c_str());
    joint->SetAttribute("type", "fixed");
    joint->InsertNewChildElement("parent")->SetAttribute("link", hand->link.c_str());
    joint->InsertNewChildElement("child")->SetAttribute("link", name.c_str());
    set_origin(*joint, composed(hand->origin, grasp.origin));
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace treeline
