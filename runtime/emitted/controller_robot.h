#pragma once
// What the headers of a controller take as known. The generator declares it for a
// robot; core/emitted_braking.hpp does for what brakes any robot.
//
// - TlConfig, TlCommand, TlInput, TlOutput, TlState, TlMailbox: structs of
//   NAME_controller.h, and its enumerators
// - TlMeasured: the robot's state as a step finds it: coordinates and velocities,
// each
//   joint's sine and cosine once, poses and velocities [v; w] of the points in world
//   axes, the torque that holds the robot at rest, and which joints are not measured
// - TL_JOINTS, TL_POINTS, TL_ROWS: sizes; TL_TASK, TL_FORCE: 1 with such laws, else 0
// - TlJointsIn, TlJointsOut: numbers of the joints as an argument, TlRowsIn,
// TlRowsOut
//   those of the task's rows, TlForcesIn those of forces and moments on the points
// - TL_TURNS: of each joint, whether it turns without end; TL_CONTROLS, TL_OWN_AXES:
// of
//   each point, which of x y z rx ry rz are rows of the task, and in whose axes
// - TL_BEHAVES: 1 with behaviours, of which there are TL_BEHAVIOURS; TL_SHARES: of
// each
//   point its place among the TL_SHARE_COUNT whose tasks come and go, or -1
// - TL_DEFAULTS: the configuration that stands in for one that is not sound
// - tl_inputs_are_numbers, tl_adopt, tl_measure, tl_joint_torque, tl_task_torque,
//   tl_push_torque: the robot's own functions
// - tl_square_root, tl_sin_cos_of
// - TL_REAL(1.5): a number of type real; TL_AS_REAL, TL_AS_INDEX: conversions
