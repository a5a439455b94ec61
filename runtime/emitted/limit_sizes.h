#pragma once
// What limited_torque.h and the headers that it includes take as known. For a robot
// the generator writes this header; who includes them otherwise defines the names
// before, as core/emitted_limits.hpp does for sizes of a template.
//
//     real, TL_REAL_BYTES               the type of numbers and its bytes
//     TL_INLINE, TL_FUNCTION            what stands before small functions, and
//     before large ones TL_ZERO, TL_ONE, TL_TEN           numbers TL_VELOCITIES,
//     TL_PASSIVE ... sizes: see emission/limit_sizes.hpp TL_SOLVED ..., TL_LOWER ...
//     what became of a program, and sides of its rows TL_DEPENDENT ... tolerances and
//     weights of the method
