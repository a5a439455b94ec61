#pragma once
// What contact_solver.h and the headers that it includes take as known; who includes
// them defines the names before, as core/contact_solver.hpp does for sizes of a
// template.
//
// - real: the type of numbers
// - TL_INLINE, TL_FUNCTION: what stands before small and before large functions
// - TL_ZERO, TL_HALF, TL_ONE, TL_TWO, TL_TEN: numbers
// - TL_CONTACTS: the most contacts; TL_CONTACT_ROWS: three times that, in eights
// - TL_ROUNDING: the unit of rounding, 2^-52 in double
// - TL_CONTACT_TOLERANCE: of speeds, beside the largest before; TL_TOLERANCE_OF_MANY:
//   the same of more contacts than TL_FEW_CONTACTS
// - TL_CONTACT_SHIFT: what stabilises matrices that have no inverse
// - TL_LARGEST_FRICTION: more than that is taken for that
// - tl_square_root
