#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "drawing/scene_solids.hpp"

namespace treeline {
namespace {

constexpr int kMostCuts = 6;  // of a face, each in halves

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

/// Something to paint: convex corners, or a disc. The nearest is painted last.
struct Item {
  double nearness = 0;
  std::string color;
  std::vector<Eigen::Vector2i> corners;  ///< in the picture, clockwise; of a disc: around it
  std::string svg;                       ///< data of a path, or attributes of a circle
  bool disc = false;
};

/// Whether corners go round clockwise in the picture.
bool is_clockwise(const std::vector<Eigen::Vector2i>& corners) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2i& next = corners[(i + 1) % corners.size()];
    area += std::int64_t{corners[i].x()} * next.y() - std::int64_t{corners[i].y()} * next.x();
  }
  return area > 0;
}

/// All faces go round in one direction: where two of one path overlap, none may be a hole.
Item face_item(const Camera& camera, const Face& face) {
  Item item;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : face.corners) {
    middle += corner / static_cast<double>(face.corners.size());
    item.corners.push_back(camera.place(corner));
  }
  if (!is_clockwise(item.corners)) std::ranges::reverse(item.corners);
  item.nearness = camera.nearness(middle);
  item.color = camera.shade(face.color, face.normal);
  item.svg = print_line(item.corners) + "z";
  return item;
}

Item ball_item(const Camera& camera, const Ball& ball) {
  const Eigen::Vector2i at = camera.place(ball.center);
  const int r = camera.length(ball.radius);
  Item item;
  item.nearness = camera.nearness(ball.center) + 0.5 * ball.radius;
  item.color = camera.lit(ball.color);
  for (const auto& [x, y] : {std::pair{-r, -r}, {r, -r}, {r, r}, {-r, r}}) {
    item.corners.emplace_back(at.x() + x, at.y() + y);
  }
  item.svg = fmt::format("cx=\"{}\" cy=\"{}\" r=\"{}\"", at.x(), at.y(), r);
  item.disc = true;
  return item;
}

/// From the farthest to the nearest.
std::vector<Item> sorted_items(const Camera& camera, const Solids& solids, double longest) {
  std::vector<Face> seen;
  for (const Face& face : solids.faces) {
    if (camera.sees(face.normal)) cut_face(face, longest, kMostCuts, seen);
  }
  std::vector<Item> items;
  for (const Face& face : seen) items.push_back(face_item(camera, face));
  for (const Ball& ball : solids.balls) items.push_back(ball_item(camera, ball));
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.nearness < b.nearness; });
  return items;
}

/// Whether an edge of `a` has all of `b` on its outer side. Corners go round clockwise.
bool is_apart(const std::vector<Eigen::Vector2i>& a, const std::vector<Eigen::Vector2i>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2i edge = a[(i + 1) % a.size()] - a[i];
    const auto is_outside = [&](const Eigen::Vector2i& point) {
      const Eigen::Vector2i to = point - a[i];
      return std::int64_t{edge.x()} * to.y() <= std::int64_t{edge.y()} * to.x();
    };
    if (!edge.isZero() && std::ranges::all_of(b, is_outside)) return true;
  }
  return false;
}

bool overlap(const Item& a, const Item& b) {
  return !is_apart(a.corners, b.corners) && !is_apart(b.corners, a.corners);
}

/// Items of one colour, which become one element.
using Group = std::vector<const Item*>;

/// Puts items together where what is painted between them overlaps neither.
std::vector<Group> group_items(const std::vector<Item>& items) {
  constexpr int kFarthest = 100;  // items to look back
  std::vector<Group> groups;
  for (const Item& item : items) {
    Group* joined = nullptr;
    int looked_at = 0;
    for (auto group = groups.rbegin(); group != groups.rend() && !item.disc; ++group) {
      if (group->front()->color == item.color && !group->front()->disc) joined = &*group;
      const bool hides =
          std::ranges::any_of(*group, [&](auto* other) { return overlap(*other, item); });
      looked_at += static_cast<int>(group->size());
      if (joined != nullptr || hides || looked_at > kFarthest) break;
    }
    if (joined != nullptr) {
      joined->push_back(&item);
    } else {
      groups.push_back({&item});
    }
  }
  return groups;
}

}  // namespace

std::string print_line(const std::vector<Eigen::Vector2i>& points) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2i step = i == 0 ? points[0] : Eigen::Vector2i(points[i] - points[i - 1]);
    if (i > 0 && step.isZero()) continue;
    const bool begins = text.find('l') == std::string::npos;
    text += i == 0 ? "M" : begins ? "l" : step.x() < 0 ? "" : " ";
    text += fmt::format("{}{}{}", step.x(), step.y() < 0 ? "" : " ", step.y());
  }
  return text;
}

std::string print_solids(const Camera& camera, const Solids& solids, double longest) {
  const std::vector<Item> items = sorted_items(camera, solids, longest);
  std::string text;
  for (const Group& group : group_items(items)) {
    const Item& first = *group.front();
    if (first.disc) {
      text += fmt::format("<circle color=\"{}\" {}/>\n", first.color, first.svg);
      continue;
    }
    text += fmt::format("<path color=\"{}\" d=\"", first.color);
    for (const Item* item : group) text += item->svg;
    text += "\"/>\n";
  }
  return text;
}

}  // namespace treeline
