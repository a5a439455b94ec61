#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "core/sin_cos.hpp"
#include "emission/same_bits.hpp"

extern "C" {
void sample_c_double_call_sin_cos(int32_t count, const double* x, double* sine, double* cosine);
void sample_c_float_call_sin_cos(int32_t count, const float* x, float* sine, float* cosine);
}

// Would catch: an angle of a group that is left out, taken for another or written behind the last,
// a swap or sign in lanes that is another than that of one number, and products fused in one alone.
namespace treeline {
namespace {

constexpr int kMost = 41;  // groups of eight and four, whatever is left over

template <class Real, class Function>
void compare_sines(Function sin_cos_of) {
  std::mt19937 random(test::kSeed);
  std::uniform_real_distribution<Real> exponent(-30, 21);
  for (int count = 1; count <= kMost; ++count) {
    for (int round = 0; round < 50; ++round) {
      std::vector<Real> angles(static_cast<std::size_t>(count));
      for (Real& each : angles) each = std::exp2(exponent(random)) * (random() % 2 == 0 ? 1 : -1);
      std::vector<Real> sines(angles.size() + 1, 7);
      std::vector<Real> cosines = sines;
      sin_cos_of(count, angles.data(), sines.data(), cosines.data());
      for (std::size_t i = 0; i < angles.size(); ++i) {
        Real sine;
        Real cosine;
        core::sin_cos(angles[i], sine, cosine);
        ASSERT_EQ(sines[i], sine) << count << " angles, at " << i << ": " << angles[i];
        ASSERT_EQ(cosines[i], cosine) << count << " angles, at " << i << ": " << angles[i];
      }
      ASSERT_EQ(sines.back(), 7) << count;
      ASSERT_EQ(cosines.back(), 7) << count;
    }
  }
}

TEST(EmittedSines, GroupsHaveTheBitsOfOneAngle) {
  compare_sines<double>(sample_c_double_call_sin_cos);
  compare_sines<float>(sample_c_float_call_sin_cos);
}

}  // namespace
}  // namespace treeline
