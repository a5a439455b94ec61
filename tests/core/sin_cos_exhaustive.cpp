// Tries every float with |x| <= 4000 (or up to the argument): 2.3e9 angles, some three minutes per
// core. Not a test of the suite; run it after changes of sin_cos.hpp. Prints the largest error and
// where it occurs.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include "core/sin_cos.hpp"
#include "ulp.hpp"

namespace {

std::uint32_t bits_of(float x) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof(x));
  return bits;
}

float float_from_bits(std::uint32_t bits) {
  float x = 0.0F;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}

}  // namespace

int main(int argc, char** argv) {
  const float largest = argc > 1 ? std::strtof(argv[1], nullptr) : 4000.0F;
  double worst = 0.0;
  float worst_at = 0.0F;
  for (std::uint32_t bits = 0; bits <= bits_of(largest); ++bits) {
    for (const std::uint32_t sign : {0U, 0x80000000U}) {
      const float x = float_from_bits(bits | sign);
      float s = 0.0F;
      float c = 0.0F;
      treeline::core::sin_cos(x, s, c);
      const double angle = static_cast<double>(x);
      const double error = std::fmax(treeline::test::ulps(s, std::sin(angle)),
                                     treeline::test::ulps(c, std::cos(angle)));
      if (!(error <= worst)) {
        worst = error;
        worst_at = x;
      }
    }
  }
  std::printf("float, |x| <= %g: at most %.4f ulp, at %a\n", static_cast<double>(largest), worst,
              static_cast<double>(worst_at));
  return worst < 0.8 ? 0 : 1;
}
