// The arm has six joints: compilers say so.
#include "puma560.h"

int main(void) {
  double q[5] = {0};
  double g[6];
  puma560_gravity(q, g);
  return g[1] > 0 ? 0 : 1;
}
