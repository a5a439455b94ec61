#pragma once
// As many registers as hold eight numbers, vectors where the machine has them. Every
// number is one IEEE operation, so vectors change no bit. Who includes this header
// defines `real`, TL_REAL_BYTES and TL_INLINE before.

#if defined(TREELINE_REGISTER_BYTES)  // as who includes this header says
#elif defined(__GNUC__) && defined(__AVX512F__)
#define TREELINE_REGISTER_BYTES 64
#elif defined(__GNUC__) && defined(__AVX__)
#define TREELINE_REGISTER_BYTES 32
#elif defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
#define TREELINE_REGISTER_BYTES 16
#else
#define TREELINE_REGISTER_BYTES 0
#endif

// Loops over registers are written out, so that each register is a variable of its
// own. Clang does so unasked.
#if defined(__GNUC__) && !defined(__clang__)
#define TREELINE_WRITTEN_OUT _Pragma("GCC unroll 16")
#else
#define TREELINE_WRITTEN_OUT
#endif
#if defined(__GNUC__)
#define TREELINE_IN_PLACE __attribute__((always_inline))
#else
#define TREELINE_IN_PLACE
#endif

// Arrays that are read in registers begin where a line of the cache does.
#if defined(__GNUC__)
#define TREELINE_ALIGNED __attribute__((aligned(64)))
#else
#define TREELINE_ALIGNED
#endif

/// Numbers in a register, at most eight, and registers of eight numbers.
#if TREELINE_REGISTER_BYTES == 0
enum { TL_WIDTH = 1, TL_REGISTERS = 8 };
typedef real TlRegister;
#else
enum {
  TL_HELD = TREELINE_REGISTER_BYTES / TL_REAL_BYTES,
  TL_WIDTH = (TL_HELD < 8) ? TL_HELD : 8,
  TL_REGISTERS = 8 / TL_WIDTH
};
typedef real TlRegister __attribute__((vector_size(TL_WIDTH * TL_REAL_BYTES)));
#endif

/// The numbers at `row`, of any alignment.
TL_INLINE TREELINE_IN_PLACE TlRegister tl_load(const real* row) {
#if TREELINE_REGISTER_BYTES > 0
  TlRegister numbers;
  __builtin_memcpy(&numbers, row, sizeof(numbers));
  return numbers;
#else
  return *row;
#endif
}

TL_INLINE TREELINE_IN_PLACE void tl_store(TlRegister numbers, real* row) {
#if TREELINE_REGISTER_BYTES > 0
  __builtin_memcpy(row, &numbers, sizeof(numbers));
#else
  *row = numbers;
#endif
}
