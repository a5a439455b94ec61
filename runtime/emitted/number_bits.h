#pragma once
// The bits of a number in C; C++ has other means, see core/sin_cos.hpp.

/// A number and the bits that it is made of.
union TlNumber {
  real value;
  TlBits bits;
};

TL_INLINE void tl_to_bits(const real* value, TlBits* bits) {
  union TlNumber number;
  number.value = *value;
  *bits = number.bits;
}

TL_INLINE void tl_from_bits(const TlBits* bits, real* value) {
  union TlNumber number;
  number.bits = *bits;
  *value = number.value;
}
