#include "description/mjcf/mjcf_compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "description/rotation.hpp"

namespace treeline {
namespace {

Eigen::Vector3d vector_from(const std::vector<double>& values, std::size_t from = 0) {
  return Eigen::Vector3d::Map(values.data() + from);
}

/// Lower-case axes turn with the body, upper-case ones stay.
Eigen::Matrix3d rotation_from_euler(const std::vector<double>& angles, const MjcfElement& element,
                                    const MjcfCompiler& compiler) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const char letter = compiler.eulerseq[i];
    const auto axis = std::string_view("xyzXYZ").find(letter);
    if (axis == std::string_view::npos) {
      element.error(fmt::format("eulerseq=\"{}\" has another letter than x, y, z, X, Y, Z",
                                compiler.eulerseq),
                    "mend eulerseq of <compiler>");
      return R;
    }
    std::array<double, 3> rpy{};
    rpy[axis % 3] = angles[i] * compiler.angle;
    const Eigen::Matrix3d turn = rotation_from_rpy<double>(rpy);
    R = axis < 3 ? Eigen::Matrix3d(R * turn) : Eigen::Matrix3d(turn * R);
  }
  return R;
}

Eigen::Matrix3d rotation_from_xyaxes(const std::vector<double>& axes) {
  Eigen::Matrix3d R;
  R.col(0) = vector_from(axes).normalized();
  const Eigen::Vector3d y = vector_from(axes, 3);
  R.col(1) = (y - R.col(0).dot(y) * R.col(0)).normalized();
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

Eigen::Matrix3d read_orientation(const MjcfElement& element, const MjcfCompiler& compiler) {
  if (const auto q = element.numbers("quat", 4, 4); !q.empty()) return rotation_from_wxyz(q.data());
  if (const auto a = element.numbers("axisangle", 4, 4); !a.empty()) {
    return Eigen::AngleAxisd(a[3] * compiler.angle, vector_from(a).normalized()).toRotationMatrix();
  }
  if (const auto e = element.numbers("euler", 3, 3); !e.empty()) {
    return rotation_from_euler(e, element, compiler);
  }
  if (const auto xy = element.numbers("xyaxes", 6, 6); !xy.empty()) return rotation_from_xyaxes(xy);
  if (const auto z = element.numbers("zaxis", 3, 3); !z.empty())
    return rotation_from_z_to(vector_from(z));
  return Eigen::Matrix3d::Identity();
}

bool read_flag(const MjcfElement& element, const char* attribute, bool otherwise) {
  const auto given = element.find(attribute);
  if (!given) return otherwise;
  if (*given != "true" && *given != "false") {
    element.error(fmt::format("{}=\"{}\" is not true or false", attribute, *given), "mend it");
  }
  return *given == "true";
}

}  // namespace

void read_compiler(const MjcfElement& element, MjcfCompiler& compiler) {
  if (element.has("coordinate") && !element.is("coordinate", "local")) {
    element.error(fmt::format("coordinate=\"{}\" is not read", element.text("coordinate")),
                  "MuJoCo 2.3 still reads it: load the model there and save it by mj_saveLastXML");
  }
  if (element.has("angle")) {
    compiler.angle = element.is("angle", "radian") ? 1 : MjcfCompiler{}.angle;
  }
  compiler.eulerseq = element.text("eulerseq", compiler.eulerseq.c_str());
  if (compiler.eulerseq.size() != 3) {
    element.error("eulerseq is not three letters", "write as eulerseq=\"xyz\"");
    compiler.eulerseq = "xyz";
  }
  compiler.autolimits = read_flag(element, "autolimits", compiler.autolimits);
  compiler.inertiafromgeom = element.text("inertiafromgeom", compiler.inertiafromgeom.c_str());
  if (const auto range = element.numbers("inertiagrouprange", 2, 2); !range.empty()) {
    compiler.first_group = static_cast<int>(range[0]);
    compiler.last_group = static_cast<int>(range[1]);
  }
  compiler.boundmass = element.number("boundmass", compiler.boundmass);
  compiler.boundinertia = element.number("boundinertia", compiler.boundinertia);
  compiler.settotalmass = element.number("settotalmass", compiler.settotalmass);
  compiler.balanceinertia = read_flag(element, "balanceinertia", compiler.balanceinertia);
  compiler.strippath = read_flag(element, "strippath", compiler.strippath);
  compiler.meshdir = element.text("assetdir", compiler.meshdir.c_str());
  compiler.meshdir = element.text("meshdir", compiler.meshdir.c_str());
}

Eigen::Isometry3d read_mjcf_pose(const MjcfElement& element, const MjcfCompiler& compiler) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (const auto p = element.numbers("pos", 3, 3); !p.empty()) pose.translation() = vector_from(p);
  pose.linear() = read_orientation(element, compiler);
  if (!pose.linear().allFinite()) {
    element.error("its orientation has an axis of length zero", "give axes a direction");
    pose.linear().setIdentity();
  }
  return pose;
}

Eigen::Matrix3d rotation_from_wxyz(const double* quaternion) {
  const Eigen::Quaterniond q(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  return q.norm() > 0 ? q.normalized().toRotationMatrix() : Eigen::Matrix3d::Identity();
}

Eigen::Matrix3d rotation_from_z_to(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d to = direction.normalized();
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ().cross(to);
  const double sine = axis.norm();
  const Eigen::Vector3d about = sine > 0 ? Eigen::Vector3d(axis / sine) : Eigen::Vector3d::UnitX();
  return Eigen::AngleAxisd(std::atan2(sine, to.z()), about).toRotationMatrix();
}

bool is_limited(const MjcfElement& element, const char* limited, const std::vector<double>& range,
                const MjcfCompiler& compiler) {
  const std::string said = element.text(limited, "auto");
  if (range.size() != 2) return false;
  return said == "true" || (said == "auto" && compiler.autolimits && range[0] < range[1]);
}

}  // namespace treeline
