// Sines and cosines of several angles in C, for the tests to call: NAME is the sample's, REAL its
// number.
#include "sin_cos.h"

#define JOIN_NAMES(name, function) name##_##function
#define JOIN(name, function) JOIN_NAMES(name, function)

void JOIN(NAME, call_sin_cos)(int32_t count, const REAL* x, REAL* sine, REAL* cosine);
void JOIN(NAME, call_sin_cos)(int32_t count, const REAL* x, REAL* sine, REAL* cosine) {
  JOIN(NAME, sin_cos)(count, x, sine, cosine);
}
