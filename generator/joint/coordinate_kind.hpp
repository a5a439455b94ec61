#pragma once

namespace treeline {

/// Kind of an entry of q. Quaternions are x, y, z, w and have length 1.
enum class CoordinateKind { angle, displacement, quaternion_xyz, quaternion_w };

}  // namespace treeline
