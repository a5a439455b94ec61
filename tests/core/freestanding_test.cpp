// The core headers in one translation unit of C++17 with nothing hosted included: compiled with
// -ffreestanding -fno-exceptions -fno-rtti and instantiated in float. Would catch a header that
// needs the library, C++20, or a feature firmware lacks.
#include "core/command_laws.hpp"
#include "core/ldlt.hpp"
#include "core/orientation.hpp"
#include "core/sin_cos.hpp"
#include "core/spline.hpp"

namespace treeline::test {

float use_everything(float x) noexcept;

float use_everything(float x) noexcept {
  float sine[3];
  float cosine[3];
  const float angles[3] = {x, 2.0F * x, 3.0F * x};
  core::sin_cos(angles, sine, cosine);
  float A[4] = {2.0F, 0.0F, sine[0], 2.0F};
  float b[2] = {cosine[0], cosine[1]};
  const bool positive = core::ldlt_factor<2>(A);
  core::ldlt_solve(A, b);
  const auto segment = core::rest_to_rest(angles, sine, 1.0F);
  float R[9];
  float R_wanted[9];
  core::rotation_from_vector(angles, R);
  core::rotation_from_vector(segment.at(x).position, R_wanted);
  float error[6];
  core::pose_error(angles, R, sine, R_wanted, error);
  float acceleration[6];
  const core::Gains<float> gains{100.0F, 20.0F};
  core::saturated_goal_law(gains, error, error, 1.0F, 1.0F, acceleration);
  float tracked[6];
  core::tracking_law(gains, error, acceleration, error, error, tracked);
  return b[0] + tracked[3] + (positive ? 1.0F : 0.0F);
}

}  // namespace treeline::test
