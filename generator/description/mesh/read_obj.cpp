#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "description/mesh/mesh.hpp"
#include "description/read_number.hpp"

namespace treeline {
namespace {

using Words = std::vector<std::string_view>;

std::optional<Eigen::Vector3d> read_position(const Words& words) {
  if (words.size() < 4) return std::nullopt;
  Eigen::Vector3d position;
  for (int i = 0; i < 3; ++i) {
    const auto number = read_number(words[static_cast<std::size_t>(i) + 1]);
    if (!number) return std::nullopt;
    position[i] = *number;
  }
  return position;
}

/// The vertex that a word such as `3/1/2` or `-1` names.
const Eigen::Vector3d* find_vertex(std::string_view word,
                                   const std::vector<Eigen::Vector3d>& vertices) {
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  const bool ended = end == word.data() + word.size() || *end == '/';
  const auto count = static_cast<std::int64_t>(vertices.size());
  if (index < 0) index += count + 1;
  if (error != std::errc() || !ended || index < 1 || index > count) return nullptr;
  return &vertices[static_cast<std::size_t>(index) - 1];
}

/// Adds the triangles of a face: of four corners along the shorter diagonal, else from the first
/// one.
bool add_fan(const Words& words, const std::vector<Eigen::Vector3d>& vertices,
             std::vector<Triangle>& triangles) {
  std::vector<Eigen::Vector3d> corners;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const Eigen::Vector3d* const vertex = find_vertex(words[i], vertices);
    if (vertex == nullptr) return false;
    corners.push_back(*vertex);
  }
  if (corners.size() == 4 && (corners[3] - corners[1]).norm() < (corners[2] - corners[0]).norm()) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    triangles.push_back({{corners[0], corners[i - 1], corners[i]}, {}});
  }
  return corners.size() >= 3;
}

}  // namespace

std::string read_obj(std::string_view bytes, std::vector<Triangle>& triangles) {
  std::vector<Eigen::Vector3d> vertices;
  int number = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const Words words = split_words(bytes.substr(at, end - at));
    at = end + 1;
    ++number;
    if (words.empty()) continue;
    if (words[0] == "v") {
      const auto position = read_position(words);
      if (!position) return fmt::format("line {}: a vertex is not three numbers", number);
      vertices.push_back(*position);
    } else if (words[0] == "f" && !add_fan(words, vertices, triangles)) {
      return fmt::format("line {}: a face is not three or more vertices of those above", number);
    }
  }
  return {};
}

}  // namespace treeline
