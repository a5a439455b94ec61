// Compares double sine and cosine with MPFR: sin_cos_samples [count [seed]], 1e8 samples by
// default, which takes some minutes. A third each is drawn over |x| <= 4, over |x| <= 1e5, and near
// multiples of pi/2 up to 1e5, where the remainder is small. Not a test of the suite, which draws
// fewer; run it after changes of sin_cos.hpp. Prints the largest error and where it occurs.
#include <mpfr.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "core/sin_cos.hpp"

namespace {

/// 200 bits: near a multiple of pi/2 some 60 bits cancel, and 53 + 60 + 20 are needed.
constexpr mpfr_prec_t kBits = 200;

class Truth {
 public:
  Truth() { mpfr_inits2(kBits, angle_, sine_, cosine_, nullptr); }
  ~Truth() { mpfr_clears(angle_, sine_, cosine_, nullptr); }
  Truth(const Truth&) = delete;
  Truth& operator=(const Truth&) = delete;

  /// The larger of both errors in units of the last place of the exact value.
  double error(double x) {
    double s = 0;
    double c = 0;
    treeline::core::sin_cos(x, s, c);
    mpfr_set_d(angle_, x, MPFR_RNDN);
    mpfr_sin_cos(sine_, cosine_, angle_, MPFR_RNDN);
    return std::fmax(ulps(s, sine_), ulps(c, cosine_));
  }

 private:
  static double ulps(double value, mpfr_t exact) {
    if (mpfr_zero_p(exact) != 0) return value == 0 ? 0 : INFINITY;
    const double unit = std::ldexp(1.0, static_cast<int>(mpfr_get_exp(exact)) - 53);
    mpfr_sub_d(exact, exact, value, MPFR_RNDN);
    return std::fabs(mpfr_get_d(exact, MPFR_RNDN)) / unit;
  }

  mpfr_t angle_, sine_, cosine_;
};

struct Worst {
  const char* where;
  double error = 0;
  double angle = 0;

  void take(double found, double x) {
    if (!(found <= error)) {
      error = found;
      angle = x;
    }
  }
};

}  // namespace

int main(int argc, char** argv) {
  const double count = argc > 1 ? std::atof(argv[1]) : 1e8;
  std::mt19937_64 random(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  std::uniform_real_distribution<double> joint(-4, 4);
  std::uniform_real_distribution<double> wide(-1e5, 1e5);
  std::uniform_int_distribution<int> quarter(-63661, 63661);
  std::uniform_real_distribution<double> exponent(-45, -1);
  Truth truth;
  Worst worst[] = {{"|x| <= 4"}, {"|x| <= 1e5"}, {"next to n pi/2"}};
  for (double i = 0; i < count; i += 3) {
    const double offset = std::copysign(std::exp2(exponent(random)), joint(random));
    const double angles[] = {joint(random), wide(random),
                             quarter(random) * 1.5707963267948966 + offset};
    for (int k = 0; k < 3; ++k) worst[k].take(truth.error(angles[k]), angles[k]);
  }
  bool holds = true;
  for (const Worst& w : worst) {
    std::printf("double, %-15s at most %.4f ulp, at %a\n", w.where, w.error, w.angle);
    holds = holds && w.error < 0.8;
  }
  return holds ? 0 : 1;
}
