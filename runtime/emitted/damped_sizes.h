#pragma once
// What damped_solve.h and the headers that it includes take as known. For a robot the
// generator writes this header; who includes them otherwise defines the names before,
// as core/emitted_damped.hpp does for sizes of a template.
//
// - real: the type of numbers
// - TL_INLINE: what stands before a function
// - TL_ZERO, TL_HALF, TL_ONE, TL_TWO: numbers
// - TL_TASK_ROWS: rows of the task, and of every matrix; TL_VELOCITIES
// - TL_SWEEPS: sweeps of QL, as many as any matrix of this size takes
// - TL_ROTATIONS: numbers that describe all their rotations, at least one
// - TL_LOST_SQUARE: squares below this have lost digits
// - TL_NEGLIGIBLE: what is nothing beside 1, four units of rounding
// - TL_UNRESOLVED: what is rounding beside 1 in an eigenvalue, 64 units
