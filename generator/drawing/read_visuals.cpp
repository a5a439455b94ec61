#include "drawing/read_visuals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "description/parse_xml.hpp"
#include "description/read_number.hpp"
#include "description/rotation.hpp"

namespace treeline {
namespace {

using tinyxml2::XMLElement;

constexpr Color kGrey = {0.7, 0.7, 0.7};
constexpr const char* kShapesWithSizes =
    "Write a box, cylinder, capsule, sphere or mesh with positive sizes.";

std::string text_of(const XMLElement& element, const char* attribute) {
  const char* text = element.Attribute(attribute);
  return text == nullptr ? "" : text;
}

/// `count` numbers of an attribute; nothing where there are others.
std::optional<std::vector<double>> numbers_of(const XMLElement& element, const char* attribute,
                                              std::size_t count) {
  auto numbers = read_numbers(text_of(element, attribute));
  if (!numbers || numbers->size() != count) return std::nullopt;
  return numbers;
}

Eigen::Isometry3d read_pose(const XMLElement* origin) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (origin == nullptr) return pose;
  if (const auto xyz = numbers_of(*origin, "xyz", 3)) {
    pose.translation() = Eigen::Vector3d::Map(xyz->data());
  }
  if (const auto rpy = numbers_of(*origin, "rpy", 3)) {
    pose.linear() = rotation_from_rpy<double>({(*rpy)[0], (*rpy)[1], (*rpy)[2]});
  }
  return pose;
}

std::optional<Color> read_color(const XMLElement* material) {
  const XMLElement* color = material == nullptr ? nullptr : material->FirstChildElement("color");
  if (color == nullptr) return std::nullopt;
  const auto rgba = numbers_of(*color, "rgba", 4);
  if (!rgba) return std::nullopt;
  return Color{(*rgba)[0], (*rgba)[1], (*rgba)[2]};
}

/// Sets kind and size. False if there is no shape that has a size; what collides may be a point, a
/// sphere of radius 0.
bool read_shape(const XMLElement& shape, bool collides, Visual& visual) {
  const std::string name = shape.Name();
  const auto length = [&](const char* attribute) {
    const auto number = numbers_of(shape, attribute, 1);
    return number && number->front() > 0 ? number->front() : 0;
  };
  if (name == "mesh") {
    const auto scale = numbers_of(shape, "scale", 3);
    visual.size = scale ? Eigen::Vector3d(scale->data()) : Eigen::Vector3d::Ones();
    visual.file = text_of(shape, "filename");
    return true;
  }
  if (name == "box") {
    const auto size = numbers_of(shape, "size", 3);
    visual.kind = VisualKind::box;
    if (size) visual.size = Eigen::Vector3d::Map(size->data());
    return size.has_value() && visual.size.minCoeff() >= 0;
  }
  visual.size = {length("radius"), length("length"), 0};
  visual.kind = name == "sphere" ? VisualKind::sphere : VisualKind::cylinder;
  const bool is_long = name == "cylinder" || name == "capsule";
  if (collides && name == "sphere" && read_number(text_of(shape, "radius")) == 0) return true;
  return visual.size[0] > 0 && (name == "sphere" || (is_long && visual.size[1] > 0));
}

/// Adds what the geometry of a visual or a collision shows: a shape, of a capsule three. False if
/// there is no shape that has a size.
bool add_shapes(const XMLElement& element, bool collides, Visual visual,
                std::vector<Visual>& visuals) {
  const XMLElement* geometry = element.FirstChildElement("geometry");
  const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
  visual.pose = read_pose(element.FirstChildElement("origin"));
  if (shape == nullptr || !read_shape(*shape, collides, visual)) return false;
  visuals.push_back(visual);
  if (std::string(shape->Name()) != "capsule") return true;
  const double half = 0.5 * visual.size[1];
  visual.kind = VisualKind::sphere;
  for (const double along : {half, -2 * half}) {
    visual.pose.translate(along * Eigen::Vector3d::UnitZ());
    visuals.push_back(visual);
  }
  return true;
}

/// Colours that are given once for the robot, by name.
std::map<std::string, Color> read_materials(const XMLElement& robot) {
  std::map<std::string, Color> colors;
  for (const XMLElement* material = robot.FirstChildElement("material"); material != nullptr;
       material = material->NextSiblingElement("material")) {
    if (const auto color = read_color(material)) colors[text_of(*material, "name")] = *color;
  }
  return colors;
}

Color color_of(const XMLElement& visual, const std::map<std::string, Color>& materials) {
  const XMLElement* material = visual.FirstChildElement("material");
  if (material == nullptr) return kGrey;
  if (const auto own = read_color(material)) return *own;
  const auto named = materials.find(text_of(*material, "name"));
  return named == materials.end() ? kGrey : named->second;
}

/// The visuals of a link, without those that have no size.
std::vector<Visual> visuals_of(const XMLElement& link, const std::string& file,
                               const std::map<std::string, Color>& materials,
                               Diagnostics& diagnostics) {
  std::vector<Visual> visuals;
  for (const XMLElement* element = link.FirstChildElement("visual"); element != nullptr;
       element = element->NextSiblingElement("visual")) {
    Visual visual;
    visual.link = text_of(link, "name");
    visual.color = color_of(*element, materials);
    if (!add_shapes(*element, false, visual, visuals)) {
      diagnostics.add({Severity::warning, file, element->GetLineNum(),
                       fmt::format("robot/link[{}]/visual", visual.link),
                       "is not drawn: no shape with a size", kShapesWithSizes});
    }
  }
  return visuals;
}

/// The shapes by which a link collides, without those that have no size.
std::vector<Visual> collisions_of(const XMLElement& link, const std::string& file,
                                  Diagnostics& diagnostics) {
  std::vector<Visual> shapes;
  for (const XMLElement* element = link.FirstChildElement("collision"); element != nullptr;
       element = element->NextSiblingElement("collision")) {
    Visual shape;
    shape.link = text_of(link, "name");
    shape.color = kGrey;
    if (!add_shapes(*element, true, shape, shapes)) {
      diagnostics.add({Severity::warning, file, element->GetLineNum(),
                       fmt::format("robot/link[{}]/collision", shape.link),
                       "touches nothing: no shape with a size", kShapesWithSizes});
    }
  }
  return shapes;
}

/// Adds the shapes that stand in for meshes, in the colour in which the link is seen.
void add_stand_ins(const XMLElement& link, std::vector<Visual>& visuals) {
  const Color color = visuals.front().color;
  Diagnostics not_shown;
  for (Visual& shape : collisions_of(link, "", not_shown)) {
    if (shape.kind == VisualKind::mesh || shape.size.isZero()) continue;
    shape.color = color;
    shape.stands_in = true;
    visuals.push_back(std::move(shape));
  }
}

}  // namespace

std::vector<Visual> read_visuals(const std::string& urdf, const std::string& file,
                                 Diagnostics& diagnostics) {
  tinyxml2::XMLDocument document;
  const XMLElement* robot = parse_urdf_xml(urdf, file, document, diagnostics);
  if (robot == nullptr) return {};
  const auto materials = read_materials(*robot);
  std::vector<Visual> visuals;
  for (const XMLElement* link = robot->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    std::vector<Visual> own = visuals_of(*link, file, materials, diagnostics);
    const bool meshes = std::all_of(own.begin(), own.end(), [](const Visual& visual) {
      return visual.kind == VisualKind::mesh;
    });
    if (!own.empty() && meshes) add_stand_ins(*link, own);
    visuals.insert(visuals.end(), own.begin(), own.end());
  }
  return visuals;
}

std::vector<Visual> read_collisions(const std::string& urdf, const std::string& file,
                                    Diagnostics& diagnostics) {
  tinyxml2::XMLDocument document;
  const XMLElement* robot = parse_urdf_xml(urdf, file, document, diagnostics);
  std::vector<Visual> shapes;
  const XMLElement* link = robot == nullptr ? nullptr : robot->FirstChildElement("link");
  for (; link != nullptr; link = link->NextSiblingElement("link")) {
    const auto own = collisions_of(*link, file, diagnostics);
    shapes.insert(shapes.end(), own.begin(), own.end());
  }
  return shapes;
}

}  // namespace treeline
