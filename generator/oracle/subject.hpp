#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "description/active_rows.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "interpreter/closed_chain.hpp"
#include "interpreter/damped_torque.hpp"
#include "interpreter/digits50.hpp"
#include "interpreter/loops.hpp"
#include "interpreter/model.hpp"
#include "interpreter/points.hpp"
#include "interpreter/regressor.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// A body whose inertial parameters are an argument, and the matter that it may have: kg, within m
/// of the link's origin.
struct SubjectInertia {
  int body = 0;
  double mass = 0, reach = 0;
};

/// An operational point or a contact whose origin is an argument, with components up to `reach`, m.
struct SubjectTool {
  std::size_t point = 0;
  double reach = 0;
  bool orientation = false;  ///< axes of the tool are an argument, too
};

/// A base parameter: the parameter that it is named after and what it combines.
struct SubjectBase {
  interpreter::UnitParameter named;
  std::vector<std::pair<interpreter::UnitParameter, Digits50>> terms;
  std::vector<std::pair<std::size_t, double>> numbers;  ///< indices, factors: see `BaseDomain`
};

/// Parts of the subject that arguments change, see `SceneInputs`.
struct SubjectInputs {
  std::vector<SubjectInertia> payloads, parameters;
  std::vector<SubjectTool> tools, contacts;
  std::vector<SubjectInertia> base_bodies;  ///< each with what is fixed to it
  std::vector<double> base_drives;          ///< sizes of rotors and coefficients of friction
  std::vector<SubjectBase> base;
  ActiveRows active;                      ///< rows of the constraints that come and go
  std::vector<std::size_t> active_tasks;  ///< operational points whose tasks come and go
};

/// Robot and scene in the interpreter's types.
template <class Scalar>
struct Subject {
  interpreter::Model<Scalar> model;
  interpreter::Points<Scalar> points;    ///< operational points
  interpreter::Points<Scalar> external;  ///< where external forces act
  interpreter::Points<Scalar> contacts;
  interpreter::Points<Scalar> constraints;  ///< whose rows are held
  interpreter::Loops<Scalar> loops;         ///< whose rows are held too
  std::vector<int> passive;                 ///< velocities without a motor
  interpreter::ClosedChain<Scalar> chain;   ///< with the objects that the robot holds
  interpreter::Damping<Scalar> damping;     ///< empty if the scene asks for no damping
  SubjectInputs inputs;                     ///< payloads are bodies of their own, without mass
  std::vector<interpreter::UnitParameter> regressor;  ///< the columns that the scene asks for

  [[nodiscard]] bool holds_rows() const { return !constraints.empty() || !loops.empty(); }
};

/// `mechanism`, if it is there already, is that of the robot in the scene.
template <class Scalar>
Subject<Scalar> make_subject(const Robot& robot, const Scene& scene,
                             const Mechanism* mechanism = nullptr);
extern template Subject<double> make_subject(const Robot&, const Scene&, const Mechanism*);
extern template Subject<Digits50> make_subject(const Robot&, const Scene&, const Mechanism*);

/// Converts every number to another type, rounding it once.
template <class To>
Subject<To> cast(const Subject<Digits50>& subject);
extern template Subject<float> cast(const Subject<Digits50>&);
extern template Subject<double> cast(const Subject<Digits50>&);

}  // namespace treeline
