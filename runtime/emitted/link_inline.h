#pragma once
// What compilers inline wherever it is called.

// Where code is to be small, compilers make calls of what they could repeat, and
// numbers go through memory: a twentieth of the bytes less, for two thirds more
// instructions.
#if defined(__GNUC__)
#define TREELINE_LINK_INLINE inline __attribute__((always_inline))
#else
#define TREELINE_LINK_INLINE inline
#endif
