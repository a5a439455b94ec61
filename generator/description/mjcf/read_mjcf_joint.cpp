#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "description/mjcf/read_bodies.hpp"

namespace treeline {
namespace {

using Eigen::Isometry3d;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The first number of an attribute that may have several; a warning where those matter.
double first_of(const MjcfElement& element, const char* attribute) {
  const auto values = element.numbers(attribute, 1, 3);
  if (std::any_of(values.begin() + (values.empty() ? 0 : 1), values.end(),
                  [](double each) { return each != 0; })) {
    element.warn(fmt::format("of {} only the first number is read", attribute), "");
  }
  return values.empty() ? 0 : values.front();
}

FlatAxis read_axis_of(const MjcfElement& element, const Eigen::Isometry3d& frame, double unit,
                      const MjcfCompiler& compiler) {
  FlatAxis axis;
  const auto direction = element.numbers("axis", 3, 3);
  axis.direction = direction.empty() ? Eigen::Vector3d::UnitZ()
                                     : Eigen::Vector3d(Eigen::Vector3d::Map(direction.data()));
  if (axis.direction.norm() == 0) {
    element.error("its axis has no direction", "give axis=\"0 0 1\" for z");
    axis.direction = Eigen::Vector3d::UnitZ();
  }
  axis.direction = frame.linear() * axis.direction.normalized();
  const auto range = element.numbers("range", 2, 2);
  const bool limited = is_limited(element, "limited", range, compiler);
  axis.lower = limited ? range[0] * unit : -kNoLimit;
  axis.upper = limited ? range[1] * unit : kNoLimit;
  axis.effort = bound_of(element, "actuatorfrcrange", "actuatorfrclimited", compiler);
  axis.velocity = kNoLimit;
  axis.damping = first_of(element, "damping");
  axis.friction = element.number("frictionloss", 0);
  axis.armature = element.number("armature", 0);
  return axis;
}

void set_moments(const Eigen::Matrix3d& I, FlatInertial& inertial) {
  inertial.ixx = I(0, 0), inertial.ixy = I(0, 1), inertial.ixz = I(0, 2);
  inertial.iyy = I(1, 1), inertial.iyz = I(1, 2), inertial.izz = I(2, 2);
}

}  // namespace

void warn_of_forces(const MjcfElement& element, bool has_axis) {
  if (element.has("springdamper")) {
    element.warn("springdamper is not read", "give stiffness and damping instead");
  }
  if (has_axis) return;
  for (const char* name : {"armature", "damping", "frictionloss", "stiffness"}) {
    if (first_of(element, name) == 0) continue;
    element.warn(fmt::format("{} of a joint that turns about three axes is not read", name), "");
  }
}

MjcfJoint read_mjcf_joint(const MjcfElement& element, const Eigen::Isometry3d& frame,
                          const MjcfCompiler& compiler) {
  MjcfJoint read;
  read.place = Isometry3d::Identity();
  read.moved_back = Isometry3d::Identity();
  const std::string type = element.name() == "freejoint" ? "free" : element.text("type", "hinge");
  const bool has_axis = type == "hinge" || type == "slide";
  if (!has_axis && type != "ball" && type != "free") {
    element.error(fmt::format("\"{}\" is not a type of joint", type),
                  "the types are hinge, slide, ball and free");
  }
  warn_of_forces(element, has_axis);
  read.joint.type = type == "free" ? "floating" : type;
  if (type == "free") return read;
  if (const auto p = element.numbers("pos", 3, 3); !p.empty()) {
    read.place.translation() = Eigen::Vector3d::Map(p.data());
  }
  read.place.translation() = frame * read.place.translation();
  if (!has_axis) return read;
  const double unit = type == "hinge" ? compiler.angle : 1;
  read.joint.type = type == "hinge" ? "revolute" : "prismatic";
  const FlatAxis axis = read_axis_of(element, frame, unit, compiler);
  read.joint.axes.push_back(axis);
  read.ref = element.number("ref", 0) * unit;
  if (type == "hinge") {
    read.moved_back.linear() = Eigen::AngleAxisd(-read.ref, axis.direction).toRotationMatrix();
  } else {
    read.moved_back.translation() = -read.ref * axis.direction;
  }
  if (const double stiffness = first_of(element, "stiffness"); stiffness > 0) {
    read.spring = SpringHint{stiffness, element.number("springref", 0) * unit};
  }
  return read;
}

FlatInertial read_inertial(const MjcfElement& element, const MjcfCompiler& compiler) {
  FlatInertial inertial;
  inertial.pose = read_mjcf_pose(element, compiler);
  inertial.mass = element.number("mass", 0);
  const auto full = element.numbers("fullinertia", 6, 6);
  const auto diagonal = element.numbers("diaginertia", 3, 3);
  if (!full.empty()) {
    Eigen::Matrix3d I;
    I << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5], full[2];
    set_moments(I, inertial);
  } else if (!diagonal.empty()) {
    set_moments(Eigen::Matrix3d(Eigen::Vector3d::Map(diagonal.data()).asDiagonal()), inertial);
  }
  return inertial;
}

std::optional<FlatInertial> inertial_of(const MjcfMass& mass) {
  if (!(mass.mass > 0)) return std::nullopt;
  FlatInertial inertial;
  inertial.mass = mass.mass;
  inertial.pose = Isometry3d::Identity();
  inertial.pose.translation() = mass.center;
  const double rounding = 1e-15 * mass.inertia.trace();
  set_moments(mass.inertia.unaryExpr([&](double x) { return std::abs(x) < rounding ? 0 : x; }),
              inertial);
  return inertial;
}

void bound_inertial(const MjcfElement& body, const MjcfCompiler& compiler,
                    std::optional<FlatInertial>& bounded) {
  const bool from_below = compiler.boundmass > 0 || compiler.boundinertia > 0;
  if (!from_below && !(bounded && compiler.balanceinertia)) return;
  if (!bounded) {
    // MuJoCo takes the body's pose in its parent for that of the inertia, which nothing states.
    bounded.emplace();
    bounded->pose = read_mjcf_pose(body, compiler);
  }
  FlatInertial& inertial = *bounded;
  Eigen::Matrix3d I;
  I << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy, inertial.iyz,
      inertial.ixz, inertial.iyz, inertial.izz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> own(I);
  Eigen::Vector3d moments = own.eigenvalues().cwiseMax(compiler.boundinertia);  // the least first
  if (compiler.balanceinertia && moments[0] + moments[1] < moments[2]) {
    moments.setConstant(moments.mean());
  }
  const double mass = std::max(inertial.mass, compiler.boundmass);
  if (mass == inertial.mass && moments == own.eigenvalues()) return;
  body.note("its inertia is changed as <compiler> says of bounds and balance", "");
  inertial.mass = mass;
  const Eigen::Matrix3d J =
      own.eigenvectors() * moments.asDiagonal() * own.eigenvectors().transpose();
  set_moments(J, inertial);
}

void scale_inertial(double factor, FlatInertial& inertial) {
  for (double* const each : {&inertial.mass, &inertial.ixx, &inertial.ixy, &inertial.ixz,
                             &inertial.iyy, &inertial.iyz, &inertial.izz}) {
    *each *= factor;
  }
}

}  // namespace treeline
