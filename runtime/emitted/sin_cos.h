#pragma once
// Gives `tl_to_bits(&x, &bits)` and `tl_from_bits(&bits, &x)`: the bits of a number,
// an integer of type TlBits, and back.
