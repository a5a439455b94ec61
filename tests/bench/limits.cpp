// Compiled with -march=native, unlike sources that use Eigen.
#include "limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace treeline::bench {
namespace {

#if defined(__x86_64__) && defined(__FMA__)

double seconds_of(void (*stream)()) {
  const auto start = std::chrono::steady_clock::now();
  stream();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

constexpr int kChainCycles = 3 * 20 * 1000;

void dependent_chain() {
  unsigned long x = 3;
  for (int i = 0; i < 1000; ++i) asm volatile(".rept 20\n imul %0, %0\n .endr\n" : "+r"(x));
}

/// Amount of `work` that the stream does per cycle.
double rate(void (*stream)(), double work) {
  std::array<double, 201> rates{};
  for (double& each : rates) {
    const double chain = std::min(seconds_of(dependent_chain), seconds_of(dependent_chain));
    each = work * chain / (kChainCycles * seconds_of(stream));
  }
  std::sort(rates.begin(), rates.end());
  return rates[rates.size() / 2];
}

#define TREELINE_CLOBBERS                                                                  \
  "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10", \
      "xmm11", "xmm12", "xmm13", "xmm14", "xmm15"
// Twelve chains, more than any core can have in flight.
#define TREELINE_TWELVE(a, b, r)                                                                   \
  a " %%" r "15, %%" r "14, %%" r "0\n" b " %%" r "15, %%" r "14, %%" r "1\n" a " %%" r "15, %%" r \
    "14, %%" r "2\n" b " %%" r "15, %%" r "14, %%" r "3\n" a " %%" r "15, %%" r "14, %%" r "4\n" b \
    " %%" r "15, %%" r "14, %%" r "5\n" a " %%" r "15, %%" r "14, %%" r "6\n" b " %%" r "15, %%" r \
    "14, %%" r "7\n" a " %%" r "15, %%" r "14, %%" r "8\n" b " %%" r "15, %%" r "14, %%" r "9\n" a \
    " %%" r "15, %%" r "14, %%" r "10\n" b " %%" r "15, %%" r "14, %%" r "11\n"
#define TREELINE_STREAM(a, b, r)                                                        \
  asm volatile("vxorps %%xmm14, %%xmm14, %%xmm14\n vmovaps %%xmm14, %%xmm15\n" ::       \
                   : "xmm14", "xmm15");                                                 \
  for (int i = 0; i < 1000; ++i) {                                                      \
    asm volatile(".rept 4\n" TREELINE_TWELVE(a, b, r) ".endr\n" ::: TREELINE_CLOBBERS); \
  }
constexpr double kInstructions = 4 * 12 * 1000;

void products_and_sums() {
  TREELINE_STREAM("vmulsd", "vaddsd", "xmm")
}
void scalar_fused() {
  TREELINE_STREAM("vfmadd231sd", "vfmadd231sd", "xmm")
}
#if defined(__AVX512F__)
constexpr int kLanes = 8;
void packed_fused() {
  TREELINE_STREAM("vfmadd231pd", "vfmadd231pd", "zmm")
}
#else
constexpr int kLanes = 4;
void packed_fused() {
  TREELINE_STREAM("vfmadd231pd", "vfmadd231pd", "ymm")
}
#endif

// An instruction of eight bytes without effect.
#define TREELINE_CODE(count) \
  asm volatile(".balign 64\n .rept " #count "\n .byte 0x0f, 0x1f, 0x84, 0, 0, 0, 0, 0\n .endr\n");

void near_code() {
  for (int i = 0; i < 100; ++i) TREELINE_CODE(3072)
}
void far_code() {
  for (int i = 0; i < 20; ++i) TREELINE_CODE(16384)
}

double measured_gigahertz() {
  double best = 1;
  for (int i = 0; i < 200; ++i) best = std::min(best, seconds_of(dependent_chain));
  return kChainCycles / best * 1e-9;
}

#endif

}  // namespace

Limits measure_limits() {
  Limits limits;
#if defined(__x86_64__) && defined(__FMA__)
  limits.gigahertz = measured_gigahertz();
  limits.mul_add = rate(products_and_sums, kInstructions);
  limits.scalar_fma = rate(scalar_fused, 2 * kInstructions);
  limits.packed_fma = rate(packed_fused, 2 * kLanes * kInstructions);
  limits.lanes = kLanes;
  limits.near_code = rate(near_code, 100 * 3072 * 8);
  limits.far_code = rate(far_code, 20 * 16384 * 8);
#endif
  return limits;
}

std::string Limits::text() const {
  if (gigahertz <= 0) return "limits of this core: not measured";
  return fmt::format(
      "one core: {:.2f} GHz; flops a cycle: scalar mul and add {:.1f}, scalar fma {:.1f}, fma of "
      "{} "
      "lanes {:.1f}; bytes of straight-line code a cycle: {:.0f} (24 KiB), {:.0f} (128 KiB)",
      gigahertz, mul_add, scalar_fma, lanes, packed_fma, near_code, far_code);
}

}  // namespace treeline::bench
