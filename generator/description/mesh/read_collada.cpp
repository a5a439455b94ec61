#include <fmt/format.h>
#include <tinyxml2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <map>
#include <numbers>

#include "description/mesh/mesh.hpp"
#include "description/read_number.hpp"

namespace treeline {
namespace {

using tinyxml2::XMLElement;

/// Value of an attribute; empty if the element or the attribute is missing.
std::string attribute_of(const XMLElement* element, const char* name) {
  const char* const text = element == nullptr ? nullptr : element->Attribute(name);
  return text == nullptr ? "" : text;
}

std::string_view content_of(const XMLElement* element) {
  const char* const text = element == nullptr ? nullptr : element->GetText();
  return text == nullptr ? "" : text;
}

/// The element at the end of a path of first children.
const XMLElement* descend(const XMLElement* element, std::initializer_list<const char*> path) {
  for (const char* const name : path) {
    if (element != nullptr) element = element->FirstChildElement(name);
  }
  return element;
}

/// The first element of a name below another, wherever it stands.
const XMLElement* first_below(const XMLElement& element, std::string_view name) {
  for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (child->Name() == name) return child;
    if (const XMLElement* const found = first_below(*child, name)) return found;
  }
  return nullptr;
}

/// Whole numbers of a text; nothing when there is something else.
std::optional<std::vector<std::size_t>> read_indices(std::string_view text) {
  std::vector<std::size_t> indices;
  for (const std::string_view word : split_words(text)) {
    const char* const end = word.data() + word.size();
    if (std::from_chars(word.data(), end, indices.emplace_back()).ptr != end) return std::nullopt;
  }
  return indices;
}

/// The step that an element of a node adds to its pose; nothing for one that is no such step.
std::optional<Eigen::Affine3d> read_step(const XMLElement& element) {
  const std::string_view name = element.Name();
  const std::size_t size = name == "matrix"                         ? 16
                           : name == "rotate"                       ? 4
                           : name == "translate" || name == "scale" ? 3
                                                                    : 0;
  const auto v = treeline::read_numbers(content_of(&element));
  if (size == 0 || !v || v->size() != size) return std::nullopt;
  const Eigen::Vector3d first = Eigen::Vector3d::Map(v->data());
  Eigen::Affine3d step = Eigen::Affine3d::Identity();
  if (size == 16) {
    step.matrix().topRows<3>() = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>::Map(v->data());
  } else if (size == 4) {
    step.rotate(Eigen::AngleAxisd((*v)[3] * std::numbers::pi / 180, first.normalized()));
  } else if (name == "scale") {
    step.scale(first);
  } else {
    step.translate(first);
  }
  return step;
}

class ColladaReading {
 public:
  ColladaReading(const XMLElement& root, std::vector<Triangle>& triangles)
      : root_(root), triangles_(triangles) {}

  std::string read() {
    list_ids(root_);
    const XMLElement* scene =
        find(attribute_of(descend(&root_, {"scene", "instance_visual_scene"}), "url"));
    if (scene == nullptr) scene = descend(&root_, {"library_visual_scenes", "visual_scene"});
    if (scene == nullptr) return "it has no visual scene";
    const auto meter = read_number(attribute_of(descend(&root_, {"asset", "unit"}), "meter"));
    visit(*scene, Eigen::Affine3d(Eigen::Scaling(meter.value_or(1))), 0);
    return problem_;
  }

 private:
  void list_ids(const XMLElement& element) {
    if (const std::string id = attribute_of(&element, "id"); !id.empty()) ids_[id] = &element;
    for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
      list_ids(*child);
    }
  }

  /// The element that an address such as `#name` names.
  [[nodiscard]] const XMLElement* find(const std::string& address) const {
    const auto found = ids_.find(address.substr(address.starts_with('#') ? 1 : 0));
    return found == ids_.end() ? nullptr : found->second;
  }

  /// Likewise, but a part of the mesh first: some programs give each mesh the same names.
  [[nodiscard]] const XMLElement* find_in(const XMLElement& mesh,
                                          const std::string& address) const {
    for (auto* part = mesh.FirstChildElement(); part; part = part->NextSiblingElement()) {
      if ('#' + attribute_of(part, "id") == address) return part;
    }
    return find(address);
  }

  bool fail(const XMLElement& element, std::string_view fault) {
    if (problem_.empty()) problem_ = fmt::format("line {}: {}", element.GetLineNum(), fault);
    return false;
  }

  /// A scene or a node, with all that it carries.
  void visit(const XMLElement& node, Eigen::Affine3d pose, int depth) {
    constexpr int kDeepestNode = 32;
    constexpr int kMostNodes = 100'000;
    constexpr std::size_t kMostTriangles = 5'000'000;
    if (depth > kDeepestNode || ++nodes_ > kMostNodes || triangles_.size() > kMostTriangles) {
      fail(node, "nodes stand for one another without end");
    }
    for (auto* part = node.FirstChildElement(); part; part = part->NextSiblingElement()) {
      if (!problem_.empty()) return;
      const std::string_view name = part->Name();
      const XMLElement* const named = find(attribute_of(part, "url"));
      if (const auto step = read_step(*part)) pose = pose * *step;
      if (name == "node") visit(*part, pose, depth + 1);
      if (!name.starts_with("instance_") || name == "instance_camera" || name == "instance_light") {
        continue;
      }
      if (named == nullptr || name == "instance_controller") {
        fail(*part, fmt::format("<{}> names nothing that can be drawn", name));
      } else if (name == "instance_node") {
        visit(*named, pose, depth + 1);
      } else if (name == "instance_geometry") {
        add_geometry(*named, pose, *part);
      }
    }
  }

  void add_geometry(const XMLElement& geometry, const Eigen::Affine3d& pose,
                    const XMLElement& instance) {
    const XMLElement* const mesh = geometry.FirstChildElement("mesh");
    const XMLElement* part = mesh == nullptr ? nullptr : mesh->FirstChildElement();
    for (; part != nullptr && problem_.empty(); part = part->NextSiblingElement()) {
      const std::string_view name = part->Name();
      if (name == "triangles" || name == "polylist" || name == "polygons") {
        add_polygons(*mesh, *part, pose, color_of(instance, attribute_of(part, "material")));
      } else if (name == "tristrips" || name == "trifans") {
        fail(*part, fmt::format("<{}> is not read", name));
      }
    }
  }

  /// Diffuse colour of a material, which the instance binds to a symbol.
  [[nodiscard]] std::optional<Color> color_of(const XMLElement& instance,
                                              const std::string& symbol) const {
    const XMLElement* bound = descend(&instance, {"bind_material", "technique_common"});
    bound = descend(bound, {"instance_material"});
    while (bound != nullptr && attribute_of(bound, "symbol") != symbol) {
      bound = bound->NextSiblingElement("instance_material");
    }
    const XMLElement* const material = find(attribute_of(bound, "target"));
    const XMLElement* const effect =
        find(attribute_of(descend(material, {"instance_effect"}), "url"));
    const XMLElement* const diffuse = effect == nullptr ? nullptr : first_below(*effect, "diffuse");
    const auto rgba = treeline::read_numbers(content_of(descend(diffuse, {"color"})));
    if (!rgba || rgba->size() < 3) return std::nullopt;
    return Color{(*rgba)[0], (*rgba)[1], (*rgba)[2]};
  }

  /// Positions that the input VERTEX of polygons names.
  std::optional<std::vector<Eigen::Vector3d>> read_positions(const XMLElement& mesh,
                                                             const XMLElement& input) {
    const XMLElement* const vertices = find_in(mesh, attribute_of(&input, "source"));
    const XMLElement* named = descend(vertices, {"input"});
    while (named != nullptr && attribute_of(named, "semantic") != "POSITION") {
      named = named->NextSiblingElement("input");
    }
    const XMLElement* const source = find_in(mesh, attribute_of(named, "source"));
    const auto numbers = treeline::read_numbers(content_of(descend(source, {"float_array"})));
    const auto stride =
        read_indices(attribute_of(descend(source, {"technique_common", "accessor"}), "stride"));
    const std::size_t step = stride && stride->size() == 1 ? stride->front() : 3;
    if (!numbers || step < 3) return std::nullopt;
    std::vector<Eigen::Vector3d> positions;
    for (std::size_t at = 0; at + 3 <= numbers->size(); at += step) {
      positions.emplace_back(Eigen::Vector3d::Map(numbers->data() + at));
    }
    return positions;
  }

  bool add_polygons(const XMLElement& mesh, const XMLElement& part, const Eigen::Affine3d& pose,
                    const std::optional<Color>& color) {
    std::size_t stride = 1;
    std::size_t offset = 0;
    std::optional<std::vector<Eigen::Vector3d>> positions;
    for (auto* in = part.FirstChildElement("input"); in; in = in->NextSiblingElement("input")) {
      const unsigned here = std::min(in->UnsignedAttribute("offset"), 64U);
      stride = std::max<std::size_t>(stride, here + 1);
      if (attribute_of(in, "semantic") != "VERTEX") continue;
      offset = here;
      positions = read_positions(mesh, *in);
    }
    const auto counts = read_indices(content_of(part.FirstChildElement("vcount")));
    if (!positions || !counts) return fail(part, "the vertices cannot be read");
    for (auto* p = part.FirstChildElement("p"); p; p = p->NextSiblingElement("p")) {
      const auto indices = read_indices(content_of(p));
      if (!indices) return fail(*p, "an index is no whole number");
      std::vector<Eigen::Vector3d> corners;
      for (std::size_t at = offset; at < indices->size(); at += stride) {
        if ((*indices)[at] >= positions->size()) return fail(*p, "a vertex is not there");
        corners.push_back((*positions)[(*indices)[at]]);
      }
      const std::size_t before = triangles_.size();
      if (!add_fans(part.Name(), *counts, corners)) return fail(*p, "it is cut short");
      for (std::size_t i = before; i < triangles_.size(); ++i) {
        triangles_[i] = moved(triangles_[i], pose);
        triangles_[i].color = color;
      }
    }
    return true;
  }

  /// Cuts corners into polygons, and these into triangles: by the counts of a polylist, else in
  /// threes, or as one.
  bool add_fans(std::string_view kind, std::vector<std::size_t> counts,
                const std::vector<Eigen::Vector3d>& corners) {
    if (kind == "triangles") counts.assign((corners.size() + 2) / 3, 3);
    if (kind == "polygons") counts.assign(1, corners.size());
    std::size_t first = 0;
    for (const std::size_t count : counts) {
      if (count > corners.size() - first) return false;
      for (std::size_t i = first + 2; i < first + count; ++i) {
        triangles_.push_back({{corners[first], corners[i - 1], corners[i]}, {}});
      }
      first += count;
    }
    return first == corners.size();
  }

  const XMLElement& root_;
  std::vector<Triangle>& triangles_;
  std::map<std::string, const XMLElement*> ids_;
  std::string problem_;
  int nodes_ = 0;
};

}  // namespace

std::string read_collada(std::string_view bytes, std::vector<Triangle>& triangles) {
  tinyxml2::XMLDocument document;
  document.Parse(bytes.data(), bytes.size());
  if (document.Error()) {
    return fmt::format("line {}: it is not well-formed XML", document.ErrorLineNum());
  }
  const XMLElement* const root = document.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "COLLADA") return "it is no COLLADA";
  return ColladaReading(*root, triangles).read();
}

}  // namespace treeline
