// Would catch: an estimate in which quotients cost what sums do, or in which constants between
// functions count as instructions.
#include <gtest/gtest.h>

#include "board/measure_objects.hpp"

namespace treeline {
namespace {

TEST(CountInstructions, KnowsKindsOfThreeArchitectures) {
  const auto kind = [](const char* mnemonic, const char* operands) {
    return kind_of_instruction(mnemonic, operands);
  };
  EXPECT_EQ(kind("vmul.f32", "s1, s2, s3"), InstructionKind::arithmetic);
  EXPECT_EQ(kind("vfma.f64", "d1, d2, d3"), InstructionKind::fused);
  EXPECT_EQ(kind("vdiv.f32", "s1, s2, s3"), InstructionKind::divide_float);
  EXPECT_EQ(kind("vsqrt.f64", "d1, d2"), InstructionKind::divide_double);
  EXPECT_EQ(kind("vldr", "s0, [r1, #4]"), InstructionKind::memory);
  EXPECT_EQ(kind("ldr.w", "r0, [sp, #4]"), InstructionKind::memory);
  EXPECT_EQ(kind("beq.n", "12"), InstructionKind::branch);
  EXPECT_EQ(kind("bics", "r0, r1"), InstructionKind::other);
  EXPECT_EQ(kind("bls.n", "12"), InstructionKind::branch);
  EXPECT_EQ(kind("fadd.s", "fa0,fa1,fa2"), InstructionKind::arithmetic);
  EXPECT_EQ(kind("fmadd.d", "fa0,fa1,fa2,fa3"), InstructionKind::fused);
  EXPECT_EQ(kind("fdiv.d", "fa0,fa1,fa2"), InstructionKind::divide_double);
  EXPECT_EQ(kind("flw", "fa0,4(a0)"), InstructionKind::memory);
  EXPECT_EQ(kind("fmul", "v0.2d, v1.2d, v2.2d"), InstructionKind::arithmetic);
  EXPECT_EQ(kind("fdiv", "d0, d1, d2"), InstructionKind::divide_double);
  EXPECT_EQ(kind("fdiv", "s0, s1, s2"), InstructionKind::divide_float);
  EXPECT_EQ(kind("vmov.f32", "s0, s1"), InstructionKind::other);
}

TEST(CountInstructions, CountsRegisters) {
  EXPECT_EQ(count_registers("r0, [r1]"), 1);
  EXPECT_EQ(count_registers("{r4, r5, lr}"), 3);
  EXPECT_EQ(count_registers("{s16-s31}"), 16);
  EXPECT_EQ(count_registers("sp!, {r4-r11, lr}"), 9);
}

TEST(CountInstructions, WeighsAListing) {
  CycleCosts costs;
  costs.memory = 2;
  costs.divide_float = 14;
  const char* const listing =
      "f.o:     file format elf32-littlearm\n\n00000000 <f>:\n"
      "   0:\tedd0 0a00 \tvldr\ts0, [r0]\n"
      "   4:\tee80 0a20 \tvdiv.f32\ts0, s0, s1\n"
      "   8:\tee30 0a20 \tvadd.f32\ts0, s0, s1\n"
      "   c:\t4770      \tbx\tlr\n"
      "  10:\t3f800000 \t.word\t0x3f800000\n";
  EXPECT_DOUBLE_EQ(mean_cycles(listing, costs), (2 + 14 + 1 + 1) / 4.0);
  EXPECT_DOUBLE_EQ(mean_cycles("", costs), 1);
}

}  // namespace
}  // namespace treeline
