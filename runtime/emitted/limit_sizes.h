#pragma once
// What limited_torque.h and the headers that it includes take as known. For a robot
// the generator writes this header; who includes them otherwise defines the names
// before, as core/emitted_limits.hpp does for sizes of a template.
//
// - real, TL_REAL_BYTES: the type of numbers, and its bytes
// - TL_INLINE, TL_FUNCTION: what stands before small and before large functions
// - TL_ZERO, TL_ONE, TL_TEN: numbers
// - TL_VELOCITIES, TL_PASSIVE and other sizes, see emission/limit_sizes.hpp
// - TL_SOLVED and others: what became of a program
// - TL_LOWER and others: sides of a row
// - TL_DEPENDENT and others: tolerances and weights of the method
