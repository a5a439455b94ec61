// What is static in emitted headers, for the tests to call: NAME is the sample's, REAL its number.
#define TREELINE_PORTABLE_SQUARE_ROOT
#include "damped_solve.h"

#define JOIN_NAMES(name, function) name##_##function
#define JOIN(name, function) JOIN_NAMES(name, function)

REAL JOIN(NAME, call_portable_root)(REAL x);
REAL JOIN(NAME, call_portable_root)(REAL x) {
  return JOIN(NAME, portable_square_root)(x);
}

REAL JOIN(NAME, call_damped_solve)(const REAL* A, const REAL* mass_limits, REAL* x);
REAL JOIN(NAME, call_damped_solve)(const REAL* A, const REAL* mass_limits, REAL* x) {
  return JOIN(NAME, damped_solve)(A, mass_limits, x);
}
