// The headers of runtime/emitted for limits as they stand, in C, for sizes of one test.
#include "emitted_limits.h"

#include <stdbool.h>
#include <stdint.h>

#define TL_INLINE static inline
#define TL_FUNCTION static
#define TL_SHARES 1
#define TL_ZERO 0.0
#define TL_ONE 1.0
#define TL_TEN 10.0
#define TL_DEPENDENT 0x1p-44
#define TL_CENTER_SHARE 0x1p-7
#define TL_LEAST_CONE 0x1p-36
#define TL_ROW_TOLERANCE 0x1p-43
#define TL_LOOSEST_TOLERANCE 0x1p-30
#define TL_CONTRADICTION 0x1p-37
#define TL_RANK_TOLERANCE (4.6e6 * 0x1p-52)
#define TL_HIERARCHY 1000.0
#define TL_NO_LIMIT 1e30
#define TL_SLACK_PENALTY 1e10

typedef double real;

enum {
  TL_REAL_BYTES = 8,
  TL_STATES = 1,
  TL_VELOCITIES = 9,
  TL_PASSIVE = 3,
  TL_HELD_ROWS = 4,
  TL_TASK_ROWS = 3,
  TL_CONES = 4,
  TL_FREEDOMS = 7,
  TL_MOTORS = 6,
  TL_UNKNOWNS = 8,
  TL_LIMIT_ROWS = 10,
  TL_ALL_ROWS = 18,
  TL_PASSIVE_ENTRIES = 3,
  TL_HELD_ENTRIES = 4,
  TL_TASK_ENTRIES = 3,
  TL_CONE_ENTRIES = 4,
  TL_BASIS_COLS = 8,
  TL_TASK_AT = 7,
  TL_MASS_AT = 10,
  TL_MASS_END = 24,
  TL_FORCES_AT = 24,
  TL_COLS = 32,
  TL_TABLE_ENTRIES = 13 * 32,
  TL_TASK_COLS = 25,
  TL_FORCE_ENTRIES = 32,
  TL_CARRIED_ENTRIES = 24,
  TL_MOST_ROWS = 13,
  TL_MOST_ITERATIONS = 72
};
enum { TL_SOLVED, TL_CONFLICTING, TL_LIMIT, TL_NOT_CONVEX };
enum { TL_LOWER = -1, TL_FREE, TL_UPPER, TL_SET_ASIDE };

// Of square_root.h, which reads the bits of numbers.
#define TL_ROOT_INSTRUCTION TL_ROOT_OF_DOUBLE
typedef uint64_t TlBits;
enum { TL_FRACTION_BITS = 52, TL_SIGN_AT = 63, TL_BIAS = 1023 };

#include "emitted/number_bits.h"
//
#include "emitted/limited_states.h"

void limit_torque_in_c(const void* layout, const void* limits, const double* M, const double* J_s,
                       const double* J_t, double* tau, double* f, void* result) {
  if (tl_is_within(layout, limits, tau, f)) {
    tl_report_unlimited(result);
  } else {
    tl_limit_torque(layout, limits, M, J_s, J_t, tau, f, result);
  }
}
