#pragma once

#include <map>
#include <utility>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// A robot in a scene, reduced for each function apart: link frames are seated around the points
/// that the function is about, so that nothing else in the scene can change its code; axes are
/// chosen for each function, see `choose_axes`.
class FunctionMechanisms {
 public:
  /// Both must outlive this.
  FunctionMechanisms(const Robot& robot, const Scene& scene,
                     Inertias inertias = Inertias::regrouped);

  const Mechanism& of(Function function);
  /// With everything that is in the scene, no axes chosen.
  const Mechanism& whole();

 private:
  const Mechanism& reduced(unsigned needs);
  /// The same with axes chosen by `decider`.
  const Mechanism& decided(unsigned needs, Function decider);

  const Robot& robot_;
  const Scene& scene_;
  Inertias inertias_;
  unsigned in_scene_ = 0;
  std::map<unsigned, Mechanism> by_needs_;
  std::map<std::pair<unsigned, Function>, Mechanism> by_decider_;
  std::map<std::pair<unsigned, Function>, const Mechanism*> cheapest_;  // of several deciders
};

}  // namespace treeline
