#include "draw_strip.hpp"

#include <fmt/format.h>
#include <urdf_model/model.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "solid_faces.hpp"

namespace treeline::pictures {
namespace {

constexpr double kScale = 150.0;   // pixels per metre
constexpr double kWidth = 230.0;   // of one picture
constexpr double kHeight = 312.0;  // of the strip
constexpr double kGround = 250.0;  // y of the world's origin, from above
constexpr double kLeft = 118.0;    // x of the world's origin, from the left of its picture

/// Parallel projection of the world.
class Camera {
 public:
  Camera(double azimuth, double elevation)
      : towards_(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                 std::sin(elevation)),
        right_(-std::sin(azimuth), std::cos(azimuth), 0.0),
        up_(towards_.cross(right_)) {}

  bool sees(const Eigen::Vector3d& normal) const { return normal.dot(towards_) > 0.0; }
  double nearness(const Eigen::Vector3d& point) const { return point.dot(towards_); }
  double x(const Eigen::Vector3d& point) const { return kLeft + kScale * point.dot(right_); }
  double y(const Eigen::Vector3d& point) const { return kGround - kScale * point.dot(up_); }

  /// Colour of a surface in light from above the camera's left.
  std::string shade(const Color& color, const Eigen::Vector3d& normal) const {
    const Eigen::Vector3d light = (towards_ + 0.9 * up_ - 0.5 * right_).normalized();
    const double share = 0.5 + 0.5 * std::max(0.0, normal.dot(light));
    const auto part = [&](std::size_t i) {
      return static_cast<int>(std::lround(255.0 * share * color[i]));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
  }
  std::string lit(const Color& color) const { return shade(color, (towards_ + up_).normalized()); }

 private:
  Eigen::Vector3d towards_, right_, up_;
};

/// Something to draw. The nearest item is drawn last.
struct Item {
  double nearness = 0.0;
  std::string svg;
};

std::string corners_of(const Camera& camera, const std::vector<Eigen::Vector3d>& points) {
  std::string text;
  for (const Eigen::Vector3d& point : points) {
    text +=
        fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", camera.x(point), camera.y(point));
  }
  return text;
}

std::string draw(const Camera& camera, const Solids& solids) {
  std::vector<Item> items;
  for (const Face& face : solids.faces) {
    if (!camera.sees(face.normal)) continue;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : face.corners) middle += corner;
    const std::string color = camera.shade(face.color, face.normal);
    items.push_back({camera.nearness(middle / static_cast<double>(face.corners.size())),
                     fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n",
                                 corners_of(camera, face.corners), color, color)});
  }
  for (const Ball& ball : solids.balls) {
    items.push_back({camera.nearness(ball.center) + 0.5 * ball.radius,
                     fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n",
                                 camera.x(ball.center), camera.y(ball.center), kScale * ball.radius,
                                 camera.lit(ball.color))});
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.nearness < b.nearness; });
  std::string text;
  for (const Item& item : items) text += item.svg;
  return text;
}

Eigen::Isometry3d pose_of(const urdf::Pose& pose) {
  Eigen::Isometry3d made = Eigen::Isometry3d::Identity();
  made.translate(Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z));
  made.rotate(
      Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z));
  return made;
}

/// Motion of a joint's child relative to the joint's frame at coordinate `q`.
Eigen::Isometry3d motion_of(const urdf::Joint& joint, double q) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  Eigen::Isometry3d made = Eigen::Isometry3d::Identity();
  if (joint.type == urdf::Joint::PRISMATIC) made.translate(q * axis);
  if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS) {
    made.rotate(Eigen::AngleAxisd(q, axis.normalized()));
  }
  return made;
}

Color color_of(const urdf::Visual& visual) {
  if (!visual.material) return {0.7, 0.7, 0.7};
  const urdf::Color& color = visual.material->color;
  return {color.r, color.g, color.b};
}

/// Adds the shapes of `link`, whose pose is `pose`, and of all links beyond it, at row `row`.
void add_links(const urdf::Link& link, const Eigen::Isometry3d& pose, const Motion& motion,
               std::size_t row, Solids& solids) {
  for (const auto& visual : link.visual_array) {
    add_solid(*visual->geometry, pose * pose_of(visual->origin), color_of(*visual), solids);
  }
  for (const auto& joint : link.child_joints) {
    const auto column = motion.find("q_" + joint->name);
    const double q = column == motion.end() ? 0.0 : column->second[row];
    const auto child =
        std::find_if(link.child_links.begin(), link.child_links.end(),
                     [&](const auto& one) { return one->name == joint->child_link_name; });
    add_links(**child,
              pose * pose_of(joint->parent_to_joint_origin_transform) * motion_of(*joint, q),
              motion, row, solids);
  }
}

std::string draw_floor(const Camera& camera) {
  const std::vector<Eigen::Vector3d> corners = {
      {-0.4, -0.5, 0}, {0.7, -0.5, 0}, {0.7, 0.45, 0}, {-0.4, 0.45, 0}};
  return fmt::format("<polygon points=\"{}\" fill=\"#ecebe6\"/>\n", corners_of(camera, corners));
}

/// Draws the path of the point up to `row`, and the point itself.
std::string draw_path(const Camera& camera, const Motion& motion,
                      const std::vector<std::string>& columns, std::size_t row) {
  if (columns.empty()) return "";
  constexpr std::size_t kStride = 50;
  std::vector<Eigen::Vector3d> points;
  const auto at = [&](std::size_t k) {
    return Eigen::Vector3d(motion.at(columns[0])[k], motion.at(columns[1])[k],
                           motion.at(columns[2])[k]);
  };
  for (std::size_t k = 0; k < row; k += kStride) points.push_back(at(k));
  points.push_back(at(row));
  return fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"#c2410c\" stroke-width=\"1.5\" "
      "stroke-dasharray=\"3,2\"/>\n<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" "
      "fill=\"#c2410c\"/>\n",
      corners_of(camera, points), camera.x(points.back()), camera.y(points.back()));
}

/// Whether all columns that are read exist.
bool has_columns(const Motion& motion, const StripSettings& settings, std::string& error) {
  std::vector<std::string> needed = settings.path;
  needed.emplace_back("time");
  for (const std::string& name : needed) {
    if (!motion.contains(name)) error = fmt::format("the motion has no column \"{}\"", name);
  }
  return error.empty();
}

}  // namespace

std::string draw_strip(const urdf::ModelInterface& robot, const Motion& motion,
                       const StripSettings& settings, std::string& error) {
  if (!has_columns(motion, settings, error)) return "";
  const Camera camera(settings.azimuth, settings.elevation);
  const std::vector<double>& time = motion.at("time");
  const double width = kWidth * static_cast<double>(settings.times.size());
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"14\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, kHeight);
  for (std::size_t k = 0; k < settings.times.size(); ++k) {
    const auto found = std::lower_bound(time.begin(), time.end(), settings.times[k] - 1e-9);
    const auto row = static_cast<std::size_t>(
        std::min(found - time.begin(), static_cast<std::ptrdiff_t>(time.size()) - 1));
    Solids solids;
    add_links(*robot.getRoot(), Eigen::Isometry3d::Identity(), motion, row, solids);
    text += fmt::format("<g transform=\"translate({:.0f},0)\" stroke-width=\"0.5\">\n",
                        kWidth * static_cast<double>(k));
    text += draw_floor(camera) + draw(camera, solids);
    text += draw_path(camera, motion, settings.path, row);
    text +=
        fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{:g} s</text>\n</g>\n",
                    0.5 * kWidth, kHeight - 8.0, settings.times[k]);
  }
  return text + "</svg>\n";
}

}  // namespace treeline::pictures
