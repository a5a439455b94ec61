// measure_meshes [--most N] FILE...: a line for each mesh: triangles, volume, area and bounding
// box, after it was reduced to N triangles; or its problem. For meshes_test.py.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "description/mesh/mesh.hpp"
#include "drawing/simplify_triangles.hpp"

namespace {

void measure(const char* path, std::size_t most) {
  treeline::Mesh mesh = treeline::read_mesh(path);
  if (!mesh.problem.empty()) {
    std::printf("%s\n", mesh.problem.c_str());
    return;
  }
  std::vector<std::size_t> tags(mesh.triangles.size(), 0);
  treeline::simplify_triangles(mesh.triangles, tags, most);
  double volume = 0;
  double area = 0;
  Eigen::AlignedBox3d box;
  for (const treeline::Triangle& triangle : mesh.triangles) {
    const auto& [a, b, c] = triangle.corners;
    volume += a.dot(b.cross(c)) / 6;
    area += 0.5 * (b - a).cross(c - a).norm();
    for (const Eigen::Vector3d& corner : triangle.corners) box.extend(corner);
  }
  std::printf("%zu %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", mesh.triangles.size(),
              volume, area, box.min().x(), box.min().y(), box.min().z(), box.max().x(),
              box.max().y(), box.max().z());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t most = static_cast<std::size_t>(-1);
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--most") {
      most = std::strtoul(argv[++i], nullptr, 10);
    } else {
      measure(argv[i], most);
    }
  }
}
