#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>

#include "recursion/tree/lift_tree.hpp"

namespace treeline {
namespace {

class Namer {
 public:
  void add(const DoubleDouble& number, const std::string& name) {
    const double size = std::abs(number.value);
    const std::string own = (number.value < 0 ? "minus_" : "") + name;
    const auto [place, is_new] = names_.try_emplace(size, own);
    if (!is_new && place->second != own) ambiguous_.insert(size);
  }

  void add(const Vector3<DoubleDouble>& v, const std::string& name) {
    add(v.x, name + "_x");
    add(v.y, name + "_y");
    add(v.z, name + "_z");
  }

  void add(const Symmetric3<DoubleDouble>& A, const std::string& name) {
    add(A.xx, name + "_xx");
    add(A.xy, name + "_xy");
    add(A.xz, name + "_xz");
    add(A.yy, name + "_yy");
    add(A.yz, name + "_yz");
    add(A.zz, name + "_zz");
  }

  /// All names but those of 0 and 1, which stand for themselves, and of sizes with several names.
  [[nodiscard]] ConstantNames take() {
    for (const double size : ambiguous_) names_.erase(size);
    names_.erase(0.0);
    names_.erase(1.0);
    return std::move(names_);
  }

 private:
  ConstantNames names_;
  std::set<double> ambiguous_;
};

void add_link(const TreeLink<DoubleDouble>& link, std::size_t number, Namer& namer) {
  const std::string before = link.parent < 0 ? "base" : fmt::format("link{}", link.parent + 1);
  namer.add(link.p, fmt::format("{}_to_{}", before, number));
  namer.add(link.inertia.mass, fmt::format("mass_{}", number));
  namer.add(link.inertia.h, fmt::format("h_{}", number));
  namer.add(link.inertia.J, fmt::format("J_{}", number));
  namer.add(link.drive.inertia, fmt::format("rotor_{}", number));
  namer.add(link.drive.damping, fmt::format("damping_{}", number));
  namer.add(link.drive.friction, fmt::format("friction_{}", number));
  namer.add(link.drive.stiffness, fmt::format("stiffness_{}", number));
}

}  // namespace

ConstantNames name_constants(const Tree<DoubleDouble>& tree) {
  Namer namer;
  namer.add(tree.gravity, "gravity");
  for (std::size_t i = 0; i < tree.links.size(); ++i) add_link(tree.links[i], i + 1, namer);
  for (const TreePoint<DoubleDouble>& point : tree.operational_points) {
    namer.add(point.p, fmt::format("link{}_to_{}", point.link + 1, point.name));
  }
  return namer.take();
}

}  // namespace treeline
