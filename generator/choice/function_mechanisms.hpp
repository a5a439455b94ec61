#pragma once

#include <map>
#include <memory>
#include <utility>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// A robot in a scene, reduced separately for each function. Link frames are placed around the
/// points that the function depends on, so that nothing else in the scene can change its code. Axes
/// are chosen for each function, see `choose_axes`.
class FunctionMechanisms {
 public:
  /// `robot` and `scene` must outlive this object.
  FunctionMechanisms(const Robot& robot, const Scene& scene,
                     Inertias inertias = Inertias::regrouped);

  const Mechanism& of(Function function);
  /// The mechanism with everything in the scene and without chosen axes.
  const Mechanism& whole();

 private:
  [[nodiscard]] Mechanism with_base_parameters(Mechanism mechanism) const;
  [[nodiscard]] Scene seen_by(unsigned needs) const;
  const Mechanism& reduced(unsigned needs);
  /// The mechanism with the links' frames of the URDF.
  const Mechanism& in_frames_of_files(unsigned needs);
  /// The reduced mechanism with axes chosen by the frame cost function `frame_cost`.
  const Mechanism& with_axes_of(unsigned needs, Function frame_cost);

  const Robot& robot_;
  const Scene& scene_;
  Inertias inertias_;
  unsigned in_scene_ = 0;
  std::shared_ptr<BaseParameterMemo> base_parameters_;  ///< of the whole scene, if it needs them
  std::map<unsigned, Mechanism> by_needs_, in_frames_of_files_;
  std::map<std::pair<unsigned, Function>, Mechanism> by_frame_cost_;
  std::map<std::pair<unsigned, Function>, const Mechanism*> cheapest_;  // of several frame costs
};

}  // namespace treeline
