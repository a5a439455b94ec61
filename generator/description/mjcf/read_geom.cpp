#include "description/mjcf/read_geom.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace treeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGiveInertial =
    "give the body an <inertial>, as MuJoCo prints when it saves "
    "the model with <compiler saveinertial=\"true\"/>";

/// How many sizes a kind of geom has; 0 for those that have no volume here.
std::size_t count_sizes(const std::string& type) {
  if (type == "sphere") return 1;
  if (type == "capsule" || type == "cylinder") return 2;
  return type == "box" || type == "ellipsoid" ? 3 : 0;
}

Solid with(double volume, double xx, double yy, double zz) {
  return {volume, Eigen::Vector3d::Zero(), volume * Eigen::Vector3d(xx, yy, zz).asDiagonal()};
}

/// Adds what has the same centre.
void join(const Solid& other, Solid& solid) {
  solid.volume += other.volume;
  solid.inertia += other.inertia;
}

Solid solid_of(const std::string& type, const Eigen::Vector3d& size) {
  constexpr double kPi = std::numbers::pi;
  const double a = size[0], b = size[1], c = size[2];
  if (type == "sphere") {
    const double moment = 0.4 * a * a;
    return with(4.0 / 3 * kPi * a * a * a, moment, moment, moment);
  }
  if (type == "box") {
    return with(8 * a * b * c, (b * b + c * c) / 3, (a * a + c * c) / 3, (a * a + b * b) / 3);
  }
  if (type == "ellipsoid") {
    return with(4.0 / 3 * kPi * a * b * c, (b * b + c * c) / 5, (a * a + c * c) / 5,
                (a * a + b * b) / 5);
  }
  Solid solid = with(2 * kPi * a * a * b, a * a / 4 + b * b / 3, a * a / 4 + b * b / 3, a * a / 2);
  if (type == "cylinder") return solid;
  const double end = 0.4 * a * a + b * b + 0.75 * a * b;  // of half a ball, b away from the middle
  join(with(4.0 / 3 * kPi * a * a * a, end, end, 0.4 * a * a), solid);
  return solid;
}

/// The surface as a solid, whose area is the volume.
Solid shell_of(const std::string& type, const Eigen::Vector3d& size) {
  constexpr double kPi = std::numbers::pi;
  const double a = size[0], b = size[1], c = size[2];
  const double ball = 2.0 / 3 * a * a;
  if (type == "sphere") return with(4 * kPi * a * a, ball, ball, ball);
  if (type == "box") {
    const double area = b * c + a * c + a * b;  // of one face each, a quarter
    const double xx = a * a * (area + 2 * b * c) / (3 * area);
    const double yy = b * b * (area + 2 * a * c) / (3 * area);
    const double zz = c * c * (area + 2 * a * b) / (3 * area);
    return with(8 * area, yy + zz, xx + zz, xx + yy);
  }
  Solid tube = with(4 * kPi * a * b, a * a / 2 + b * b / 3, a * a / 2 + b * b / 3, a * a);
  const double half_ball = ball + b * b + a * b, disc = a * a / 4 + b * b;  // b from the middle
  join(type == "capsule" ? with(4 * kPi * a * a, half_ball, half_ball, ball)
                         : with(2 * kPi * a * a, disc, disc, a * a / 2),
       tube);
  return tube;
}

std::string size_text(const Eigen::Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

}  // namespace

void read_mjcf_asset(const MjcfElement& element, const MjcfCompiler& compiler, MjcfAssets& assets) {
  if (element.name() == "material" && element.has("rgba")) {
    assets.colors[element.text("name")] = element.text("rgba");
  }
  if (element.name() != "mesh") return;
  MjcfMesh mesh;
  fs::path file = element.text("file");
  if (compiler.strippath) file = file.filename();
  if (!file.empty()) mesh.file = (fs::path(compiler.meshdir) / file).lexically_normal().string();
  if (const auto scale = element.numbers("scale", 3, 3); !scale.empty()) {
    mesh.scale = Eigen::Vector3d::Map(scale.data());
  }
  if (const auto p = element.numbers("refpos", 3, 3); !p.empty()) {
    mesh.reference.translation() = Eigen::Vector3d::Map(p.data());
  }
  if (const auto q = element.numbers("refquat", 4, 4); !q.empty()) {
    mesh.reference.linear() = rotation_from_wxyz(q.data());
  }
  mesh.inertia = element.text("inertia", "legacy");
  assets.meshes[element.text("name", file.stem().c_str())] = std::move(mesh);
}

void MjcfMass::add(const MjcfMass& other) {
  const double sum = mass + other.mass;
  if (sum > 0) {
    const Eigen::Vector3d apart = other.center - center;
    inertia += other.inertia +
               mass * other.mass / sum *
                   (apart.squaredNorm() * Eigen::Matrix3d::Identity() - apart * apart.transpose());
    center = (mass * center + other.mass * other.center) / sum;
  }
  mass = sum;
}

MjcfGeom::MjcfGeom(const MjcfElement& element, const Eigen::Isometry3d& frame,
                   const MjcfCompiler& compiler, const MjcfAssets& assets, bool weighs)
    : element_(element), compiler_(compiler), assets_(assets), weighs_(weighs) {
  type_ = element.text("type", "sphere");
  pose_ = frame * read_mjcf_pose(element, compiler);
  if (const auto name = element.find("mesh")) {
    const auto found = assets.meshes.find(*name);
    if (found != assets.meshes.end()) mesh_ = &found->second;
    if (mesh_ == nullptr) element.error(fmt::format("there is no mesh \"{}\"", *name), "mend it");
  }
  read_sizes(frame);
}

void MjcfGeom::read_sizes(const Eigen::Isometry3d& frame) {
  const std::size_t count = count_sizes(type_);
  if (count == 0 || mesh_ != nullptr) return;
  const auto fromto = element_.numbers("fromto", 6, 6);
  const auto sizes = element_.numbers("size", 1, 3);
  if (!fromto.empty()) {
    const Eigen::Vector3d from = Eigen::Vector3d::Map(fromto.data());
    const Eigen::Vector3d to = Eigen::Vector3d::Map(fromto.data() + 3);
    Eigen::Isometry3d along = Eigen::Isometry3d::Identity();
    along.translation() = (from + to) / 2;
    along.linear() = rotation_from_z_to(from - to);
    pose_ = frame * along;
    size_[static_cast<int>(count) - 1] = (to - from).norm() / 2;
  }
  const std::size_t needed = fromto.empty() ? count : count - 1;
  if (sizes.empty() && needed > 0) {
    element_.error(fmt::format("a {} without size", type_), "give its radius, half lengths");
    return;
  }
  for (std::size_t i = 0; i < sizes.size() && i < needed; ++i) {
    size_[static_cast<int>(i)] = sizes[i];
  }
  // A box or ellipsoid between two points may have one size for its breadth.
  if (!fromto.empty() && count == 3 && sizes.size() == 1) size_[1] = sizes[0];
  if (size_.head(static_cast<int>(count)).minCoeff() <= 0) {
    element_.error(fmt::format("a {} has {} positive sizes", type_, count), "mend size");
  }
}

MjcfMass MjcfGeom::mass() const {
  const double group = element_.number("group", 0);
  if (group < compiler_.first_group || group > compiler_.last_group) return {};
  const bool weighs =
      element_.has("mass") ? element_.number("mass", 0) > 0 : element_.number("density", 1000) > 0;
  if (!weighs || type_ == "plane" || type_ == "hfield") return {};
  const auto found = solid();
  if (!found || !(found->volume > 0)) return {};
  MjcfMass result;
  result.mass = element_.number("mass", element_.number("density", 1000) * found->volume);
  result.center = pose_ * found->center;
  result.inertia =
      result.mass / found->volume * pose_.linear() * found->inertia * pose_.linear().transpose();
  return result;
}

void MjcfGeom::refuse(const std::string& fault) const {
  if (weighs_) {
    element_.error(fault, kGiveInertial);
  } else {
    element_.note(fault + ", and need not be: nothing moves the body", "");
  }
}

std::optional<Solid> MjcfGeom::solid() const {
  const bool is_shell = element_.is("shellinertia", "true");
  if (mesh_ != nullptr && type_ == "mesh") {
    return solid_of_mesh(is_shell ? "shell" : mesh_->inertia);
  }
  if (is_shell && type_ == "ellipsoid") {
    refuse("the inertia of the surface of an ellipsoid is not computed");
  } else if (mesh_ != nullptr || count_sizes(type_) == 0) {
    refuse(fmt::format("the inertia of a {}{} is not computed", type_,
                       mesh_ != nullptr ? " that is fitted to a mesh" : ""));
  } else {
    return is_shell ? shell_of(type_, size_) : solid_of(type_, size_);
  }
  return std::nullopt;
}

std::optional<Solid> MjcfGeom::solid_of_mesh(const std::string& inertia) const {
  const bool counted = inertia == "legacy" || inertia == "exact" || inertia == "shell";
  if (mesh_->file.empty() || !counted) {
    refuse(mesh_->file.empty()
               ? "the inertia of a mesh that is not in a file is not computed"
               : fmt::format("inertia=\"{}\" of its mesh is not computed", inertia));
    return std::nullopt;
  }
  const fs::path folder = fs::path(element_.reading().path()).parent_path();
  Mesh mesh = read_mesh((folder / mesh_->file).string());
  if (!mesh.problem.empty()) {
    refuse(fmt::format("the mesh {} cannot be read: {}", mesh_->file, mesh.problem));
    return std::nullopt;
  }
  const Eigen::Affine3d scaled(Eigen::Scaling(mesh_->scale) * mesh_->reference.inverse());
  for (Triangle& triangle : mesh.triangles) triangle = moved(triangle, scaled);
  if (inertia == "shell") return solid_on(mesh.triangles);
  return solid_within(mesh.triangles, inertia == "legacy");
}

std::vector<FlatShape> MjcfGeom::shapes() const {
  FlatShape shape;
  shape.pose = pose_;
  shape.kind = type_;
  if (mesh_ != nullptr) {
    if (type_ != "mesh" || mesh_->file.empty()) return {};
    Eigen::Isometry3d in_mesh = mesh_->reference.inverse();
    const bool even = (mesh_->scale.array() == mesh_->scale[0]).all();
    if (!even && !in_mesh.linear().isIdentity()) return {};  // URDF scales in the file's axes
    in_mesh.translation() = mesh_->scale.cwiseProduct(in_mesh.translation());
    shape.pose = pose_ * in_mesh;
    shape.size_name = "filename";
    shape.size = mesh_->file;
    shape.more_name = "scale";
    shape.more = size_text(mesh_->scale);
  } else if (type_ == "box") {
    shape.size_name = "size";
    shape.size = size_text(2 * size_);
  } else if (type_ == "sphere" || type_ == "cylinder" || type_ == "capsule") {
    shape.size_name = "radius";
    shape.size = fmt::format("{}", size_[0]);
  } else {
    return {};  // planes, and ellipsoids, which URDF does not have
  }
  if (type_ != "cylinder" && type_ != "capsule") return {shape};
  std::vector<FlatShape> parts;
  for (const double end : {size_[1], -size_[1]}) {
    if (type_ == "cylinder") break;
    parts.push_back(shape);
    parts.back().kind = "sphere";
    parts.back().pose.translate(Eigen::Vector3d(0, 0, end));
  }
  shape.kind = "cylinder";
  shape.more_name = "length";
  shape.more = fmt::format("{}", 2 * size_[1]);
  parts.push_back(shape);
  return parts;
}

void MjcfGeom::add_shapes(std::vector<FlatShape>& shapes) const {
  constexpr double kLastShown = 2;  ///< group that MuJoCo draws unless asked to
  const auto material = assets_.colors.find(element_.text("material"));
  const std::string by_material = material == assets_.colors.end() ? "" : material->second;
  const bool shown = element_.number("group", 0) <= kLastShown;
  const bool collides = element_.number("contype", 1) > 0 || element_.number("conaffinity", 1) > 0;
  for (FlatShape shape : this->shapes()) {
    shape.color = element_.text("rgba", by_material.c_str());
    if (shown) shapes.push_back(shape);
    shape.color.clear();
    shape.collides = true;
    if (collides) shapes.push_back(shape);
  }
}

}  // namespace treeline
