#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// One of the numbers on which joint forces depend linearly.
struct ModelParameter {
  enum class Kind {
    inertial,  ///< one of the ten inertial parameters of a link
    payload,   ///< one of the ten inertial parameters of a body added to a link
    rotor,     ///< inertia of the motor's rotor at a joint, kg m^2 or kg
    viscous,   ///< viscous friction of a joint, N m s or N s/m
    coulomb  ///< Coulomb friction of a joint, N m or N, which a smooth sign of its speed multiplies
  };
  Kind kind = Kind::inertial;
  std::string owner;       ///< link or joint
  std::size_t frame = 0;   ///< of a body's: index into `Mechanism::link_frames`, `payload_frames`
  int entry = 0;           ///< of a body's: which of the ten, see `kInertialNames`
  int v = 0;               ///< of a joint's: its velocity, or that of the joint that it follows
  bool slides = false;     ///< of a joint's: whether it does
  Digits50 factor = 1;     ///< of a joint's: how many times its velocity feels the parameter
  Digits50 sharpness = 0;  ///< of Coulomb friction: reciprocal of the velocity's width

  [[nodiscard]] bool is_of_body() const { return kind == Kind::inertial || kind == Kind::payload; }
  /// The width of Coulomb friction of the joint itself, rad/s or m/s.
  [[nodiscard]] double width() const { return static_cast<double>(Digits50(factor / sharpness)); }
};

/// The ten inertial parameters of a link, in the order of arguments (`InertialParameters`).
inline constexpr std::array<const char*, kInertialParameters> kInertialNames = {
    "m", "mc_x", "mc_y", "mc_z", "Ixx", "Ixy", "Iyy", "Ixz", "Iyz", "Izz"};

/// `forearm Ixx`, `payload of hand m`, `elbow rotor`, `elbow viscous`, `elbow coulomb`.
std::string name_of(const ModelParameter& parameter);

/// `kg m^2`.
const char* unit_of(const ModelParameter& parameter);

/// The column of Coulomb friction: `s(qd / 0.01)`, of a joint that follows another `2 s(2 qd /
/// 0.01)`.
std::string sign_of(const ModelParameter& parameter);

/// The parameters of all links that move against their parents, or of those that are asked for, in
/// the frames of the URDF: what is fixed to a link is part of it. Then those of payloads, and of
/// joints of one freedom that move, also of those that follow others, in the order of the links. Of
/// a joint with the position m q + o, q feels m^2 times the rotor and viscous friction, and |m|
/// times Coulomb friction, whose width is w / |m|.
std::vector<ModelParameter> list_model_parameters(const Mechanism& mechanism,
                                                  const SceneRegressor& asked);

/// The link that the joint which has a rotor or friction moves.
std::size_t link_of(const ModelParameter& parameter, const Mechanism& mechanism);

/// The parameters whose columns the regressors of the mechanism have, all or base ones as
/// `Mechanism::regressor` says.
std::vector<ModelParameter> regressor_columns(const Mechanism& mechanism);

}  // namespace treeline
