#pragma once

#include <string>

#include "description/noise.hpp"
#include "mechanism/digits50_matrices.hpp"

namespace treeline {

/// Largest difference between numbers of a mechanism that are taken as equal. It covers residue of
/// cancellation in 50 digits and what files cannot express, see `kResolution`. This is the only
/// criterion for whether frames are rotated by quarter turns, axes are parallel or intersect, or
/// bodies are balanced.
struct Resolution {
  Digits50 angle = 1e-30;  ///< rad
  Digits50 length = 0;     ///< m
};

/// Largest changes that `resolved` has made.
struct Change {
  Digits50 angle = 0;   ///< rad
  Digits50 length = 0;  ///< m
  Digits50 share = 0;   ///< relative to a body's moments
};

/// Returns the pose with the structure that it has within `resolution`, exactly. Entries of R
/// within this limit become 0, axes that agree within it become equal, and R is then orthogonal to
/// 50 digits. If several entries could vanish, but not together, the smallest does. Entries of p
/// become 0 if they are at most `resolution.length`, or residue compared with the largest entry.
/// Resolving a second time changes nothing. `change` receives the largest changes.
Digits50Pose resolved(const Digits50Pose& pose, const Resolution& resolution,
                      Change* change = nullptr);

struct Inertia;

/// Returns the inertia with small first moments and products set to 0. Small means at most
/// `resolution.angle` times the largest value that a body with these moments can have, h_x^2 = m
/// Sigma_xx and Sigma_xy^2 = Sigma_xx Sigma_yy, or residue. Moments stay.
Inertia resolved(const Inertia& inertia, const Resolution& resolution, Change* change = nullptr);

/// Returns the angle (rad), or 0 if it is within the resolution.
Digits50 resolved(const Digits50& angle, const Resolution& resolution);

/// Records changes that are larger than the residue of 50 digits.
void add_decisions(const Change& change, const std::string& element, const std::string& file,
                   NoiseDecisions& decisions);

}  // namespace treeline
