#pragma once
// What the headers of sines and cosines take as known. The generator joins them to
// one file for a robot; core/sin_cos.hpp defines the names for one number and for
// several.
//
// - real: the type of numbers; TlBits: an integer of its size
// - TlAngle, TlAngleBits: the same, or vectors of them
// - tl_to_bits(&x, &bits), tl_from_bits(&bits, &x): the bits of a number, and back
// - TL_INLINE: what stands before a function
// - TL_FRACTION_BITS, TL_SIGN_AT, TL_BIAS: the format of numbers
// - TL_LARGEST_EXPONENT: angles beyond two to this count as 0
// - TL_ROUNDING_SHIFT: 1.5 times the least number that has no fraction
// - TL_TWO_OVER_PI, TL_ONE and others: numbers
