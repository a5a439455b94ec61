#pragma once
// What solve_columns.h and common_frame.h take as known. For a robot the generator
// writes this header; who includes it otherwise defines the names before, as
// core/emitted_endings.hpp does.
//
// - real: the type of numbers
// - TL_INLINE: what stands before a function
// - TL_RESTRICT: what says that a pointer is no other
// - TL_NONE: a pointer to nothing
// - TL_ZERO, TL_ONE: numbers
// - TL_VELOCITIES: n, rows of every matrix
// - TL_PLACES: n and as many more as make a multiple of eight
// - TL_PATH: the longest path of solve_columns.h, with its own freedom, in eights
// - TL_FLOATS: whether the base floats, 1 or 0
