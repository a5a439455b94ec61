#include "description/mjcf/mesh_solid.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>
#include <string_view>

#include "description/read_number.hpp"

namespace treeline {
namespace {

constexpr std::size_t kHead = 84;  ///< bytes of a binary STL before its triangles
constexpr std::size_t kFace = 50;  ///< bytes of one

std::optional<Triangles> read_binary_stl(const std::string& bytes) {
  if (bytes.size() < kHead) return std::nullopt;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHead - sizeof count, sizeof count);
  if (bytes.size() != kHead + kFace * std::size_t{count}) return std::nullopt;
  Triangles triangles(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers{};  // the normal, then the corners
    std::memcpy(numbers.data(), bytes.data() + kHead + kFace * i, sizeof numbers);
    for (std::size_t k = 0; k < 3; ++k) {
      triangles[i][k] = Eigen::Vector3f::Map(numbers.data() + 3 * (k + 1)).cast<double>();
    }
  }
  return triangles;
}

std::optional<Eigen::Vector3d> read_vertex(std::string_view numbers) {
  const auto values = treeline::read_numbers(numbers);
  if (!values || values->size() < 3) return std::nullopt;
  return Eigen::Vector3d::Map(values->data());
}

/// Index of a corner `7/1/2` of a face of OBJ, counted from 0; -1 where it is none.
std::ptrdiff_t read_index(std::string_view word, std::size_t corners) {
  const auto number = read_number(word.substr(0, word.find('/')));
  if (!number || *number != std::floor(*number)) return -1;
  const auto count = static_cast<double>(corners);
  const double index = *number < 0 ? count + *number : *number - 1;
  return index >= 0 && index < count ? static_cast<std::ptrdiff_t>(index) : -1;
}

class TextMesh {
 public:
  std::optional<Triangles> read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const auto words = split_words(line);
      if (!words.empty() && !read_line(words, line)) return std::nullopt;
    }
    if (loose_.size() % 3 != 0) return std::nullopt;
    for (std::size_t i = 0; i < loose_.size(); i += 3) {
      triangles_.push_back({loose_[i], loose_[i + 1], loose_[i + 2]});
    }
    return triangles_;
  }

 private:
  bool read_line(const std::vector<std::string_view>& words, std::string_view line) {
    const bool of_stl = words.front() == "vertex";
    if (of_stl || words.front() == "v") {
      const auto first = static_cast<std::size_t>(words.front().data() - line.data());
      const auto corner = read_vertex(line.substr(first + words.front().size()));
      if (corner) (of_stl ? loose_ : corners_).push_back(*corner);
      return corner.has_value();
    }
    return words.front() != "f" || add_face(words);
  }

  bool add_face(const std::vector<std::string_view>& words) {
    std::vector<Eigen::Vector3d> face;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::ptrdiff_t index = read_index(words[i], corners_.size());
      if (index < 0) return false;
      face.push_back(corners_[static_cast<std::size_t>(index)]);
    }
    for (std::size_t i = 2; i < face.size(); ++i) {
      triangles_.push_back({face[0], face[i - 1], face[i]});
    }
    return face.size() >= 3;
  }

  std::vector<Eigen::Vector3d> loose_, corners_;  ///< of STL, three each; of OBJ
  Triangles triangles_;
};

/// The centre of the surface's area.
Eigen::Vector3d center_of_surface(const Triangles& surface) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (const auto& [a, b, c] : surface) {
    const double part = (b - a).cross(c - a).norm() / 2;
    sum += part * (a + b + c) / 3;
    area += part;
  }
  return area > 0 ? Eigen::Vector3d(sum / area) : sum;
}

/// The tetrahedron of a triangle with a fourth corner: corners are relative to that.
struct Tetrahedron {
  Eigen::Vector3d a, b, c;
  double volume;
};

Tetrahedron tetrahedron(const std::array<Eigen::Vector3d, 3>& triangle,
                        const Eigen::Vector3d& fourth, bool overlapping) {
  const Eigen::Vector3d a = triangle[0] - fourth, b = triangle[1] - fourth,
                        c = triangle[2] - fourth;
  const double volume = a.cross(b).dot(c) / 6;
  return {a, b, c, overlapping ? std::abs(volume) : volume};
}

Eigen::Vector3d center_of(const Triangles& surface, bool overlapping) {
  const Eigen::Vector3d from = center_of_surface(surface);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double volume = 0;
  for (const auto& triangle : surface) {
    const Tetrahedron part = tetrahedron(triangle, from, overlapping);
    moment += part.volume / 4 * (part.a + part.b + part.c);
    volume += part.volume;
  }
  return from + moment / volume;
}

}  // namespace

std::optional<Triangles> read_triangles(const std::string& bytes) {
  auto triangles = read_binary_stl(bytes);
  if (!triangles) triangles = TextMesh().read(bytes);
  if (!triangles || triangles->empty()) return std::nullopt;
  return triangles;
}

/// Second moments of a tetrahedron of volume V with corners a, b, c and 0 are
/// V / 20 (aa' + bb' + cc' + ss'), where s = a + b + c.
Solid solid_within(const Triangles& surface, bool overlapping) {
  Solid solid;
  solid.center = center_of(surface, overlapping);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const auto& triangle : surface) {
    const auto [a, b, c, volume] = tetrahedron(triangle, solid.center, overlapping);
    const Eigen::Vector3d sum = a + b + c;
    solid.volume += volume;
    second += volume / 20 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  solid.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  return solid;
}

}  // namespace treeline
