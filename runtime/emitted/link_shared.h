#pragma once
// What compilers never inline.

// What several functions of a robot call is not inlined into each, nor made for each
// anew: a linker keeps one.
#if defined(__clang__)
#define TREELINE_LINK_SHARED __attribute__((noinline))
#elif defined(__GNUC__)
#define TREELINE_LINK_SHARED __attribute__((noinline, noclone))
#else
#define TREELINE_LINK_SHARED
#endif
