#include "drawing/draw_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/robot_solids.hpp"
#include "report/svg.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

constexpr double kWidth = 240;    // of one picture, pixels
constexpr double kHeight = 280;   // of the strip above the captions, at most
constexpr double kCaptions = 28;  // height of the captions
constexpr double kMargin = 10;    // around the robot
constexpr double kLongest = 0.3;  // edge of a face, of the robot's size
constexpr int kMostCuts = 6;      // of a face, each in halves

constexpr const char* kStyle =
    "<style>.paper{fill:#fff}.ground{fill:#ecebe6}text{fill:#1c1c1c}"
    "@media(prefers-color-scheme:dark){.paper{fill:#16181d}.ground{fill:#2a2d33}"
    "text{fill:#e6e6e6}}</style>\n";

/// Parallel projection of the world onto a picture.
class Camera {
 public:
  explicit Camera(const View& view)
      : towards_(std::cos(view.elevation) * std::cos(view.azimuth),
                 std::cos(view.elevation) * std::sin(view.azimuth), std::sin(view.elevation)),
        right_(-std::sin(view.azimuth), std::cos(view.azimuth), 0),
        up_(towards_.cross(right_)) {}

  [[nodiscard]] bool sees(const Eigen::Vector3d& normal) const { return normal.dot(towards_) > 0; }
  [[nodiscard]] double nearness(const Eigen::Vector3d& point) const { return point.dot(towards_); }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double x(const Eigen::Vector3d& point) const {
    return left_ + scale_ * point.dot(right_);
  }
  [[nodiscard]] double y(const Eigen::Vector3d& point) const {
    return top_ - scale_ * point.dot(up_);
  }

  /// Makes a ball part of what has to be in the picture.
  void include(const Eigen::Vector3d& point, double radius) {
    const Eigen::Vector2d middle(point.dot(right_), point.dot(up_));
    seen_.extend(Eigen::Vector2d(middle.array() - radius));
    seen_.extend(Eigen::Vector2d(middle.array() + radius));
  }
  /// Chooses scale and place so that all that was included fits.
  void fit() {
    constexpr double kLeast = 1e-6;  // m, of a robot that is a point
    const Eigen::Vector2d extent = seen_.sizes().cwiseMax(kLeast);
    scale_ = std::min((kWidth - 2 * kMargin) / extent.x(), (kHeight - 2 * kMargin) / extent.y());
    height_ = std::round(scale_ * extent.y() + 2 * kMargin);
    left_ = 0.5 * kWidth - scale_ * seen_.center().x();
    top_ = 0.5 * height_ + scale_ * seen_.center().y();
  }
  /// Height of the picture without its caption, pixels.
  [[nodiscard]] double height() const { return height_; }

  /// Colour of a surface in light from above the camera's left.
  [[nodiscard]] std::string shade(const Color& color, const Eigen::Vector3d& normal) const {
    const Eigen::Vector3d light = (towards_ + 0.9 * up_ - 0.5 * right_).normalized();
    const double share = 0.5 + 0.5 * std::max(0.0, normal.dot(light));
    const auto part = [&](std::size_t i) {
      return static_cast<int>(std::lround(255 * share * std::clamp(color[i], 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
  }
  [[nodiscard]] std::string lit(const Color& color) const {
    return shade(color, (towards_ + up_).normalized());
  }

 private:
  Eigen::Vector3d towards_, right_, up_;
  Eigen::AlignedBox2d seen_;
  double scale_ = 1, left_ = 0, top_ = 0, height_ = kHeight;
};

std::string print_points(const Camera& camera, const std::vector<Eigen::Vector3d>& points) {
  std::string text;
  for (const Eigen::Vector3d& point : points) {
    text +=
        fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", camera.x(point), camera.y(point));
  }
  return text;
}

/// Cuts a face of four corners across its longer edges until none is longer than `limit` (m), for
/// the middle of a long face says little about which of its parts is near. A face is in at most
/// 2^`cuts` pieces. Those without four corners stay whole.
void cut_face(const Face& face, double limit, int cuts, std::vector<Face>& pieces) {
  const auto edge = [&](std::size_t i) {
    return (face.corners[(i + 1) % 4] - face.corners[i]).norm();
  };
  if (cuts == 0 || face.corners.size() != 4 ||
      std::max({edge(0), edge(1), edge(2), edge(3)}) <= limit) {
    pieces.push_back(face);
    return;
  }
  const std::size_t first = std::max(edge(0), edge(2)) >= std::max(edge(1), edge(3)) ? 0 : 1;
  const auto corner = [&](std::size_t i) { return face.corners[(first + i) % 4]; };
  const Eigen::Vector3d near = 0.5 * (corner(0) + corner(1));
  const Eigen::Vector3d far = 0.5 * (corner(2) + corner(3));
  cut_face({{corner(0), near, far, corner(3)}, face.normal, face.color}, limit, cuts - 1, pieces);
  cut_face({{near, corner(1), corner(2), far}, face.normal, face.color}, limit, cuts - 1, pieces);
}

/// Something to draw. The nearest is drawn last.
struct Item {
  double nearness = 0;
  std::string svg;
};

Item draw_face(const Camera& camera, const Face& face) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : face.corners) middle += corner;
  const std::string color = camera.shade(face.color, face.normal);
  return {camera.nearness(middle / static_cast<double>(face.corners.size())),
          fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n",
                      print_points(camera, face.corners), color, color)};
}

std::string draw_solids(const Camera& camera, const Solids& solids, double longest) {
  std::vector<Face> seen;
  for (const Face& face : solids.faces) {
    if (camera.sees(face.normal)) cut_face(face, longest, kMostCuts, seen);
  }
  std::vector<Item> items;
  for (const Face& face : seen) items.push_back(draw_face(camera, face));
  for (const Ball& ball : solids.balls) {
    items.push_back({camera.nearness(ball.center) + 0.5 * ball.radius,
                     fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n",
                                 camera.x(ball.center), camera.y(ball.center),
                                 camera.scale() * ball.radius, camera.lit(ball.color))});
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.nearness < b.nearness; });
  std::string text;
  for (const Item& item : items) text += item.svg;
  return text;
}

/// Calls `visit(point, radius)` for the corners of all faces, with radius 0, and all balls.
template <class Visit>
void for_each_extreme(const std::vector<Solids>& all, const Visit& visit) {
  for (const Solids& solids : all) {
    for (const Face& face : solids.faces) {
      for (const Eigen::Vector3d& corner : face.corners) visit(corner, 0.0);
    }
    for (const Ball& ball : solids.balls) visit(ball.center, ball.radius);
  }
}

/// A patch of the ground, z = 0, below everything.
std::vector<Eigen::Vector3d> find_floor(const std::vector<Solids>& all) {
  Eigen::AlignedBox3d box;
  for_each_extreme(all, [&](const Eigen::Vector3d& point, double) { box.extend(point); });
  constexpr double kBelow = 0.02;  // of its size a robot may reach below the ground it stands on
  if (box.isEmpty() || box.min().z() < -kBelow * box.sizes().maxCoeff()) return {};
  const double margin = 0.1 * box.sizes().maxCoeff();
  const double left = box.min().x() - margin;
  const double right = box.max().x() + margin;
  const double front = box.min().y() - margin;
  const double back = box.max().y() + margin;
  return {{left, front, 0}, {right, front, 0}, {right, back, 0}, {left, back, 0}};
}

std::string draw_floor(const Camera& camera, const std::vector<Eigen::Vector3d>& floor) {
  if (floor.empty()) return "";
  return fmt::format("<polygon class=\"ground\" points=\"{}\"/>\n", print_points(camera, floor));
}

std::string draw_path(const Camera& camera, const std::vector<Eigen::Vector3d>& path) {
  if (path.empty()) return "";
  return fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"#c2410c\" stroke-width=\"1.5\" "
      "stroke-dasharray=\"3,2\"/>\n<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" "
      "fill=\"#c2410c\"/>\n",
      print_points(camera, path), camera.x(path.back()), camera.y(path.back()));
}

/// The floor may reach beyond the picture, what stands on it may not.
Camera fit_camera(const View& view, const std::vector<Solids>& all,
                  const std::vector<Moment>& moments) {
  Camera camera(view);
  for_each_extreme(
      all, [&](const Eigen::Vector3d& point, double radius) { camera.include(point, radius); });
  for (const Moment& moment : moments) {
    for (const Eigen::Vector3d& point : moment.path) camera.include(point, 0);
  }
  camera.fit();
  return camera;
}

std::string print_caption(const Camera& camera, const std::string& caption) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{}</text>\n",
                     0.5 * kWidth, camera.height() + 0.6 * kCaptions,
                     report::escape_xml(printable(caption)));
}

}  // namespace

std::string draw_robot(const Robot& robot, const LinkPlacer& placer,
                       const std::vector<Visual>& visuals, const std::vector<Moment>& moments,
                       const View& view, const Solids& standing) {
  std::vector<Solids> all;
  double size = 0;
  for (const Moment& moment : moments) {
    const auto links = placer.place(moment.q);
    if (size == 0) size = size_of(links);
    all.push_back(robot_solids(robot, visuals, links, size));
    for (const Solids* other : {&moment.held, &standing}) add_solids(*other, all.back());
  }
  const std::vector<Eigen::Vector3d> floor = find_floor(all);
  const Camera camera = fit_camera(view, all, moments);
  const double height = camera.height() + kCaptions;
  std::string text = report::open_svg(kWidth * static_cast<double>(moments.size()), height,
                                      "font-family=\"sans-serif\" font-size=\"14\"") +
                     kStyle + "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n";
  for (std::size_t i = 0; i < moments.size(); ++i) {
    text +=
        fmt::format("<svg x=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" stroke-width=\"0.5\">\n",
                    kWidth * static_cast<double>(i), kWidth, height);
    text += draw_floor(camera, floor) + draw_solids(camera, all[i], kLongest * size) +
            draw_path(camera, moments[i].path) + print_caption(camera, moments[i].caption) +
            "</svg>\n";
  }
  return text + "</svg>\n";
}

}  // namespace treeline
