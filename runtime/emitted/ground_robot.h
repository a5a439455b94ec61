#pragma once
// What the headers of the step on the ground take as known; emitted code has a header
// of this name with it.
//
// - real, TL_INLINE, TL_FUNCTION, TL_ZERO, TL_HALF, TL_ONE, TL_TWO: as elsewhere
// - TL_GROUND_COORDINATES, TL_GROUND_VELOCITIES
// - TL_GROUND_TURNS: joints with a quaternion, in TL_GROUND_QUATERNIONS: of each its
//   first coordinate, its first velocity, and 1 if it moves freely, 0 if it is a ball
// - TL_GROUND_GROUPS: links with shapes, or several that are fixed to each other. Of
//   each TL_GROUND_TIPS: its last velocity; TL_GROUND_SHAPES_OF: where its shapes
//   begin, and at last where all end; TL_GROUND_BALLS: centre and radius of a ball
//   about all of it
// - TL_GROUND_POINTS_OF: where each shape's points begin, and at last where all end;
//   TL_GROUND_RADII: of a ball about each point, or of a rim; TL_GROUND_AXES: of the
//   rim, and zeros where it is a ball; TL_GROUND_LEVELS: across it; TL_GROUND_POINTS,
//   in the axes of the group
// - TL_GROUND_MOST_POINTS: the most that one group has, rims counted four times
// - TL_GROUND_FACTOR_AT: where the row of each velocity begins in the factor of the
//   mass matrix, and at last where all end; TL_GROUND_BEFORE: beside each entry the
//   velocity that it belongs to, those that carry the row's one from the root outward
// - TL_GROUND_SHARED: of each two groups, how many velocities move both
// - TlGroundPose, tl_find_dynamics, tl_find_heights, tl_find_energy,
//   tl_find_flight: functions of the robot
// - TlGround, TlGroundMemory, TlGroundReport: see the contract
// - tl_square_root, tl_sin_cos_of
