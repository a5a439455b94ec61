// Writes a humanoid of 75 joints with hands of 20 joints, on a floating base: write_humanoid75
// URDF. It is asymmetric, so that nothing cancels, and the same on every machine.
#include <array>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <string>

namespace {

using Vector = std::array<double, 3>;

class Humanoid {
 public:
  explicit Humanoid(std::ostream& out) : out_(out) {
    out_.setf(std::ios::fixed);
    out_.precision(6);
    out_ << "<robot name=\"humanoid75\">\n";
    link("pelvis", 10);
    const std::string chest = chain("torso", "pelvis", {0, 0, 0.1}, {0, 0, 0.12}, "zxy", 8);
    head(chest);
    for (const int side : {1, -1}) limbs(chest, side);
    out_ << "</robot>\n";
  }

 private:
  /// Uniform in [low, high), by Lehmer's generator.
  double random(double low, double high) {
    seed_ = seed_ * 48271 % 2147483647;
    return low + (high - low) * static_cast<double>(seed_) / 2147483647.0;
  }

  void link(const std::string& name, double mass) {
    const Vector m{mass * random(0.004, 0.01), mass * random(0.004, 0.01),
                   mass * random(0.004, 0.01)};
    const Vector com{random(-0.02, 0.02), random(-0.02, 0.02), random(-0.1, 0.1)};
    out_ << "<link name=\"" << name << "\"><inertial><origin xyz=\"" << com[0] << ' ' << com[1]
         << ' ' << com[2] << "\"/><mass value=\"" << mass << "\"/><inertia ixx=\""
         << m[0] + m[1] / 2 << "\" iyy=\"" << m[1] + m[2] / 2 << "\" izz=\"" << m[2] + m[0] / 2
         << "\" ixy=\"" << m[0] / 50 << "\" ixz=\"" << m[1] / 50 << "\" iyz=\"" << m[2] / 100
         << "\"/></inertial></link>\n";
  }

  void joint(const std::string& parent, const std::string& child, const Vector& at, char axis) {
    out_ << "<joint name=\"" << child << "_joint\" type=\"revolute\"><parent link=\"" << parent
         << "\"/><child link=\"" << child << "\"/><origin xyz=\"" << at[0] << ' ' << at[1] << ' '
         << at[2] << "\"/><axis xyz=\"" << (axis == 'x') << ' ' << (axis == 'y') << ' '
         << (axis == 'z') << "\"/><limit lower=\"-2\" upper=\"2\" effort=\"50\" velocity=\"5\"/>"
         << "</joint>\n";
  }

  /// Adds a joint for each of `axes`; the first one is at `first` on `parent`. Returns the last
  /// link.
  std::string chain(const std::string& name, std::string parent, const Vector& first,
                    const Vector& step, const std::string& axes, double mass) {
    for (std::size_t i = 0; i < axes.size(); ++i, mass *= 0.9) {
      const std::string child = name + std::to_string(i + 1);
      link(child, mass);
      joint(parent, child, i == 0 ? first : step, axes[i]);
      parent = child;
    }
    return parent;
  }

  void head(const std::string& chest) {
    const std::string skull = chain("neck", chest, {0, 0, 0.3}, {0, 0, 0.06}, "zyx", 1.5);
    chain("eye_l", skull, {0.08, 0.03, 0.1}, {}, "z", 0.05);
    chain("eye_r", skull, {0.08, -0.03, 0.1}, {}, "z", 0.05);
    chain("jaw", skull, {0.05, 0, 0}, {}, "y", 0.3);
  }

  void limbs(const std::string& chest, int side) {
    const std::string s = side > 0 ? "l" : "r";
    const std::string hand =
        chain("arm_" + s, chest, {0, 0.2 * side, 0.25}, {0, 0, -0.1}, "yxzyzyx", 2);
    for (int i = 0; i < 5; ++i) {
      chain("finger_" + s + std::to_string(i) + '_', hand, {0.02 * (i - 2), 0, -0.08},
            {0, 0, -0.03}, "xyyy", 0.05);
    }
    chain("leg_" + s, "pelvis", {0, 0.1 * side, -0.05}, {0, 0, -0.15}, "zxyyyx", 4);
  }

  std::ostream& out_;
  std::uint64_t seed_ = 75;
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: write_humanoid75 URDF\n";
    return 2;
  }
  std::ofstream file(arguments[1]);
  Humanoid{file};
  return file.flush() ? 0 : 1;
}
