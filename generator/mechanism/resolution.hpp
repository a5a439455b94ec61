#pragma once

#include <string>

#include "description/noise.hpp"
#include "mechanism/exact.hpp"

namespace treeline {

/// What two numbers of a mechanism may differ by and still be the same: residue of cancellation in
/// 50 digits, and what files cannot mean, see `kResolution`. Everything that asks whether frames
/// are turned by quarter turns, axes are parallel or meet, or bodies are balanced asks it here.
struct Resolution {
  Exact angle = 1e-30;  ///< rad
  Exact length = 0;     ///< m
};

/// By how much `resolved` changed something, at most.
struct Change {
  Exact angle = 0;   ///< rad
  Exact length = 0;  ///< m
  Exact share = 0;   ///< of a body's moments
};

/// The pose with the structure that it has within `resolution`, exactly: entries of R that are no
/// larger are 0, whole axes that are no farther from each other agree, and R is orthogonal to 50
/// digits for it. Where several entries could vanish, but not together, the least does. Entries of
/// p that are no larger than `resolution.length`, or residue beside the largest, are 0. What is
/// resolved stays as it is.
ExactPose resolved(const ExactPose& pose, const Resolution& resolution, Change* change = nullptr);

struct Inertia;

/// The inertia without first moments and products that are no larger than `resolution.angle` beside
/// what a body with its moments could have at most, h_x^2 = m Sigma_xx and Sigma_xy^2 = Sigma_xx
/// Sigma_yy, or that are residue. Moments stay.
Inertia resolved(const Inertia& inertia, const Resolution& resolution, Change* change = nullptr);

/// The angle, or 0 where that is the same.
Exact resolved(const Exact& angle, const Resolution& resolution);

/// Writes down what changed by more than 50 digits' residue.
void add_decisions(const Change& change, const std::string& element, const std::string& file,
                   NoiseDecisions& decisions);

}  // namespace treeline
