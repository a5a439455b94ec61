#include "drawing/draw_robot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/scene_solids.hpp"
#include "report/svg.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

constexpr double kCaptions = 28;  // height of the captions, pixels
constexpr double kLongest = 0.3;  // edge of a face, of the robot's size

/// Colours are attributes, for renderers that know little CSS. Some of them look `currentColor` up
/// where it is written and not where it is inherited: so the first rule repeats what the group has.
constexpr const char* kStyle =
    "[color]{fill:currentColor;stroke:currentColor}"
    "@media(prefers-color-scheme:dark){.paper{fill:#16181d}.ground{fill:#2a2d33}"
    "text{fill:#e6e6e6}}";

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

/// The floor may reach beyond the picture, what stands on it may not.
void include_all(const std::vector<Solids>& all, const std::vector<Moment>& moments,
                 Camera& camera) {
  for_each_extreme(
      all, [&](const Eigen::Vector3d& point, double radius) { camera.include(point, radius); });
  for (const Moment& moment : moments) {
    for (const auto& path : moment.paths) {
      for (const Eigen::Vector3d& point : path) camera.include(point, 0);
    }
  }
}

/// Pictures of one size and scale, of all moments.
class Pictures {
 public:
  Pictures(const Robot& robot, const LinkPlacer& placer, const std::vector<Visual>& visuals,
           const std::vector<Moment>& moments, const View& view, const Solids& standing)
      : moments_(moments),
        width_(view.width),
        solids_(all_solids(robot, placer, visuals, standing)),
        floor_(find_floor(solids_)),
        camera_(view) {
    if (view.close_up.empty()) {
      include_all(solids_, moments, camera_);
    } else {
      include_link(robot, placer, view.close_up);
    }
    camera_.fit();
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return camera_.height() + kCaptions; }

  [[nodiscard]] std::string open(double width, const std::string& style,
                                 const std::string& title) const {
    const std::string shown = title.empty() ? "" : fmt::format("<title>{}</title>\n", title);
    return report::open_svg(width, height(), "font-family=\"sans-serif\" font-size=\"14\"") +
           shown + "<style>" + kStyle + style +
           "</style>\n<rect class=\"paper\" fill=\"#fff\" width=\"100%\" height=\"100%\"/>\n";
  }

  [[nodiscard]] std::string floor() const {
    if (floor_.empty()) return "";
    return scaled(
        fmt::format("<path class=\"ground\" fill=\"#ecebe6\" stroke=\"none\" d=\"{}z\"/>\n",
                    print_line(camera_.place(floor_))));
  }

  /// The picture of a moment, beside those before it, on this floor.
  [[nodiscard]] std::string frame(std::size_t i, const std::string& floor) const {
    return fmt::format("<svg x=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\">\n",
                       width_ * static_cast<double>(i), width_, height()) +
           floor + at(i) + "</svg>\n";
  }

 private:
  void include_link(const Robot& robot, const LinkPlacer& placer, const std::string& name) {
    constexpr double kRadius = 0.15;  // of the robot's size
    for (const Moment& moment : moments_) {
      const auto links = placer.place(moment.q);
      for (std::size_t i = 0; i < links.size(); ++i) {
        if (robot.links[i].name == name) {
          camera_.include(links[i].translation(), kRadius * size_);
        }
      }
    }
  }

  std::vector<Solids> all_solids(const Robot& robot, const LinkPlacer& placer,
                                 const std::vector<Visual>& visuals, const Solids& standing) {
    std::vector<Solids> all;
    for (const Moment& moment : moments_) {
      const auto links = placer.place(moment.q);
      if (size_ == 0) size_ = size_of(links);
      all.push_back(robot_solids(robot, visuals, links, size_));
      for (const Solids* other : {&moment.held, &standing}) add_solids(*other, all.back());
    }
    return all;
  }

  [[nodiscard]] std::string at(std::size_t i) const {
    std::string text = print_solids(camera_, solids_[i], kLongest * size_);
    for (const auto& path : moments_[i].paths) {
      const Eigen::Vector2i end = camera_.place(path.back());
      text += fmt::format(
          "<path fill=\"none\" stroke=\"#c2410c\" stroke-width=\"7\" stroke-dasharray=\"15,10\" "
          "d=\"{}\"/>\n<circle fill=\"#c2410c\" stroke=\"none\" cx=\"{}\" cy=\"{}\" r=\"15\"/>\n",
          print_line(camera_.place(path)), end.x(), end.y());
    }
    return scaled(text) + fmt::format(
                              "<text fill=\"#1c1c1c\" x=\"{:.0f}\" y=\"{:.0f}\" "
                              "text-anchor=\"middle\">{}</text>\n",
                              0.5 * width_, camera_.height() + 0.6 * kCaptions,
                              report::escape_xml(printable(moments_[i].caption)));
  }

  static std::string scaled(const std::string& text) {
    return fmt::format(
        "<g transform=\"scale({:g})\" fill=\"currentColor\" stroke=\"currentColor\" "
        "stroke-width=\"2.5\">\n{}</g>\n",
        1 / Camera::kUnits, text);
  }

  const std::vector<Moment>& moments_;
  double width_;
  double size_ = 0;  ///< of the robot at the first moment, m
  std::vector<Solids> solids_;
  std::vector<Eigen::Vector3d> floor_;
  Camera camera_;
};

}  // namespace

std::string draw_robot(const Robot& robot, const LinkPlacer& placer,
                       const std::vector<Visual>& visuals, const std::vector<Moment>& moments,
                       const View& view, const Solids& standing) {
  const Pictures pictures(robot, placer, visuals, moments, view, standing);
  std::string text = pictures.open(pictures.width() * static_cast<double>(moments.size()), "", "");
  for (std::size_t i = 0; i < moments.size(); ++i) text += pictures.frame(i, pictures.floor());
  return text + "</svg>\n";
}

double duration_of(const Film& film, std::size_t moments) {
  return static_cast<double>(moments - 1) / film.rate + film.pause;
}

std::string animate_robot(const Robot& robot, const LinkPlacer& placer,
                          const std::vector<Visual>& visuals, const std::vector<Moment>& moments,
                          const View& view, const Film& film, const Solids& standing) {
  const Pictures pictures(robot, placer, visuals, moments, view, standing);
  const std::size_t steps = moments.size() - 1;
  const double duration = duration_of(film, moments.size());
  const std::string style = fmt::format(
      ".film{{animation:film {:.4g}s steps({}) infinite}}"
      "@keyframes film{{{:.4f}%,to{{transform:translateX({:.0f}px)}}}}"
      "@media(prefers-reduced-motion:reduce){{.film{{animation:none}}}}",
      duration, std::max<std::size_t>(steps, 1), 100 * (1 - film.pause / duration),
      -pictures.width() * static_cast<double>(steps));
  std::string text =
      pictures.open(pictures.width(), style,
                    fmt::format("{}: {:.3g} s, {:g} frames a second, over and over",
                                report::escape_xml(printable(robot.name)), duration, film.rate)) +
      pictures.floor() + "<g class=\"film\">\n";
  for (std::size_t i = 0; i < moments.size(); ++i) text += pictures.frame(i, "");
  return text + "</g>\n</svg>\n";
}

}  // namespace treeline
