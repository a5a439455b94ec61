#pragma once
// The bits of several numbers side by side: vectors as GCC and Clang have them.

typedef real TlAngle __attribute__((vector_size(TL_LANES * TL_REAL_BYTES)));
typedef TlBits TlAngleBits __attribute__((vector_size(TL_LANES * TL_REAL_BYTES)));
/// Numbers side by side in an array, wherever that lies.
typedef real TlRow __attribute__((
    vector_size(TL_LANES * TL_REAL_BYTES), aligned(TL_REAL_BYTES), may_alias));

TL_INLINE void tl_to_bits(const TlAngle* value, TlAngleBits* bits) {
  *bits = (TlAngleBits)*value;
}

TL_INLINE void tl_from_bits(const TlAngleBits* bits, TlAngle* value) {
  *value = (TlAngle)*bits;
}
