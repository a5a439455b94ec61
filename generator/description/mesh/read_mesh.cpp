#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "description/mesh/mesh.hpp"
#include "description/read_number.hpp"

namespace treeline {
namespace {

constexpr std::uintmax_t kLargestMesh = std::uintmax_t{256} << 20U;  // bytes
constexpr const char* kExportAgain = "Export it again, as STL for instance.";

std::string lower_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_in_range(const Triangle& triangle) {
  return std::all_of(triangle.corners.begin(), triangle.corners.end(), [](const auto& corner) {
    return corner.allFinite() && corner.cwiseAbs().maxCoeff() <= kLargestNumber;
  });
}

Mesh refuse_mesh(std::string problem, std::string remedy) {
  return {{}, std::move(problem), std::move(remedy)};
}

}  // namespace

Triangle moved(const Triangle& triangle, const Eigen::Affine3d& pose) {
  Triangle other = triangle;
  for (Eigen::Vector3d& corner : other.corners) corner = pose * corner;
  if (pose.linear().determinant() < 0) std::swap(other.corners[1], other.corners[2]);
  return other;
}

Mesh read_mesh(const std::string& path) {
  const std::string ending = lower_ending(path);
  const auto read = ending == ".stl"   ? read_stl
                    : ending == ".obj" ? read_obj
                    : ending == ".dae" ? read_collada
                                       : nullptr;
  if (read == nullptr) {
    return refuse_mesh(fmt::format("pictures have no meshes of the format {}", ending),
                       "Convert it to STL, OBJ or DAE; `treeline drive` shows it as it is.");
  }
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return refuse_mesh("there is no such file",
                       "Check the path; a relative one starts at the folder "
                       "of the robot's file.");
  }
  if (std::filesystem::file_size(path, error) > kLargestMesh && !error) {
    return refuse_mesh("it has more than 256 MiB", "Reduce its triangles.");
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return refuse_mesh("it cannot be read", "Check the permissions and the disk.");
  Mesh mesh;
  mesh.problem = read(bytes, mesh.triangles);
  if (mesh.problem.empty() && mesh.triangles.empty()) mesh.problem = "it has no triangles";
  if (mesh.problem.empty() && !std::ranges::all_of(mesh.triangles, is_in_range)) {
    mesh.problem = "a coordinate is no number, or beyond 1e30";
  }
  if (mesh.problem.empty()) return mesh;
  return refuse_mesh(std::move(mesh.problem), kExportAgain);
}

}  // namespace treeline
