// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in lanes.
// 7979 flops (add 3436, mul 4499, div 44), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "humanoid24.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT Lambda)[144]) noexcept {
  const Real angles[24] = {q[12], q[10], q[8], q[7], q[6], q[5], q[4], q[3], q[1], q[2], q[0], q[9],
      q[11], q[21], q[23], q[22], q[20], q[16], q[19], q[18], q[17], q[15], q[14], q[13]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c13 = cosines[0];
  const Real c11 = cosines[1];
  const Real c9 = cosines[2];
  const Real s8 = sines[3];
  const Real c7 = cosines[4];
  const Real c6 = cosines[5];
  const Real s5 = sines[6];
  const Real c4 = cosines[7];
  const Real c2 = cosines[8];
  const Real c3 = cosines[9];
  const Real s2 = sines[8];
  const Real s3 = sines[9];
  const Real c1 = cosines[10];
  const Real s1 = sines[10];
  const Real c5 = cosines[6];
  const Real s6 = sines[5];
  const Real s4 = sines[7];
  const Real s7 = sines[4];
  const Real c8 = cosines[3];
  const Real s9 = sines[2];
  const Real s11 = sines[1];
  const Real c10 = cosines[11];
  const Real s10 = sines[11];
  const Real s13 = sines[0];
  const Real c12 = cosines[12];
  const Real s12 = sines[12];
  const Real s22 = sines[13];
  const Real c22 = cosines[13];
  const Real c24 = cosines[14];
  const Real c23 = cosines[15];
  const Real s24 = sines[14];
  const Real s23 = sines[15];
  const Real c21 = cosines[16];
  const Real s21 = sines[16];
  const Real s17 = sines[17];
  const Real c20 = cosines[18];
  const Real s20 = sines[18];
  const Real s19 = sines[19];
  const Real c19 = cosines[19];
  const Real s18 = sines[20];
  const Real c18 = cosines[20];
  const Real c17 = cosines[17];
  const Real c16 = cosines[21];
  const Real s16 = sines[21];
  const Real s15 = sines[22];
  const Real c15 = cosines[22];
  const Real c14 = cosines[23];
  const Real s14 = sines[23];

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p7_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> inverse_D12_p5_lanes = 0.000108260010923775 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p6_lanes = 0.0007556474228594393 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.000252780114665025), 0.000252780114665025) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D11_p3_lanes = 0.000108260010923775 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> inverse_D10_p8_lanes = 0.01626499875 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p9_lanes = 0.01626499875 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(s13, s20);

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D12_p7_lanes = 1065.380700001509 * inverse_D12_p5_lanes;
  const Lanes<2> inverse_D12_p8_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p6_lanes;
  const Lanes<2> inverse_D11_p5_lanes = 1065.380700001509 * inverse_D11_p3_lanes;
  const Lanes<2> inverse_D10_p10_lanes = 1065.380700001509 * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p11_lanes = 1065.380700001509 * inverse_D10_p9_lanes;
  const Lanes<2> inverse_D10_p12_lanes = 0.0006000000000000001 + inverse_D10_p9_lanes;
  const Lanes<2> inverse_D10_p15_lanes = inverse_D12_p5_lanes * inverse_D10_p11_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p1_lanes = 2.0 * detail::make_pack<Real>(c10, c17);

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D10_p20_lanes = 0.0025100003499999995 - inverse_D12_p5_lanes *
      inverse_D10_p10_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (0.001053967177886718 - inverse_D12_p8_lanes -
      inverse_D12_p5_lanes * inverse_D12_p7_lanes);

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D11_p12_lanes = detail::make_pack<Real>((-2.4000000000000003e-06),
      2.4000000000000003e-06) - (detail::make_pack<Real>(c13, c20) * inverse_D12_p6_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) +
      inverse_D11_p3_lanes * inverse_D12_p7_lanes);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D11_p13_lanes = inverse_D11_p12_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p22_lanes = inverse_D10_p20_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p23_lanes = inverse_D10_p12_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p24_lanes = inverse_D10_p15_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p29_lanes = inverse_D10_p12_lanes * inverse_D10_p22_lanes;
  const Lanes<2> inverse_D10_p30_lanes = inverse_D10_p12_lanes * inverse_D10_p23_lanes;
  const Lanes<2> inverse_D10_p33_lanes = inverse_D10_p12_lanes * inverse_D10_p24_lanes;
  const Lanes<2> inverse_D11_p15_lanes = 0.00028671975502727877 + inverse_D12_p8_lanes -
      inverse_D11_p3_lanes * inverse_D11_p5_lanes - inverse_D11_p12_lanes * inverse_D11_p13_lanes;
  const Lanes<2> inverse_D10_p34_lanes = inverse_D11_p3_lanes * inverse_D10_p10_lanes +
      inverse_D11_p12_lanes * inverse_D10_p22_lanes;
  const Lanes<2> inverse_D10_p35_lanes = inverse_D10_p8_lanes + inverse_D11_p12_lanes *
      inverse_D10_p23_lanes;
  const Lanes<2> inverse_D10_p36_lanes = inverse_D11_p3_lanes * inverse_D10_p11_lanes -
      0.0025100003499999995 - inverse_D11_p12_lanes * inverse_D10_p24_lanes;
  const Lanes<2> inverse_D10_p37_lanes = inverse_D10_p8_lanes * inverse_D10_p10_lanes +
      inverse_D10_p20_lanes * inverse_D10_p22_lanes;
  const Lanes<2> inverse_D10_p39_lanes = inverse_D10_p8_lanes * inverse_D10_p11_lanes -
      inverse_D10_p20_lanes * inverse_D10_p24_lanes;
  const Lanes<2> inverse_D10_p40_lanes = inverse_D10_p9_lanes * inverse_D10_p11_lanes +
      inverse_D10_p15_lanes * inverse_D10_p24_lanes;
  const Lanes<2> inverse_D11_p17_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p15_lanes);
  const Lanes<2> inverse_D10_p50_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p34_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p35_lanes;
  const Lanes<2> inverse_D10_p51_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p36_lanes;
  const Lanes<2> inverse_D10_p53_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p36_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> inverse_D10_p54_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p39_lanes -
      detail::make_pack<Real>(c12, c19) * inverse_D10_p33_lanes;
  const Lanes<2> inverse_D11_p18_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p17_lanes;
  const Lanes<2> inverse_D10_p55_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p50_lanes;
  const Lanes<2> inverse_D10_p58_lanes = detail::make_pack<Real>(s12, s19) *
      (inverse_D10_p37_lanes - inverse_D10_p30_lanes) + detail::make_pack<Real>(c12, c19) *
      (2.0 * inverse_D10_p29_lanes);
  const Lanes<2> inverse_D10_p59_lanes = inverse_D10_p53_lanes + 0.269 * inverse_D10_p40_lanes;
  const Lanes<2> inverse_D10_p60_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p50_lanes;
  const Lanes<2> inverse_D10_p61_lanes = 0.269 * inverse_D10_p54_lanes;
  const Lanes<2> inverse_D8_p1_lanes = 6e-04 - inverse_D10_p51_lanes;
  const Lanes<2> inverse_D10_p64_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p58_lanes;
  const Lanes<2> inverse_D10_p66_lanes = inverse_D10_p60_lanes + inverse_D10_p61_lanes;
  const Lanes<2> inverse_D8_p4_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      inverse_D10_p55_lanes;
  const Lanes<2> inverse_D8_p6_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p33_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p39_lanes;
  const Lanes<2> inverse_D8_p7_lanes = inverse_D10_p60_lanes - inverse_D10_p34_lanes;
  const Lanes<2> inverse_D10_p68_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p17_lanes + 0.269 * inverse_D10_p51_lanes);
  const Lanes<2> inverse_D10_p69_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      inverse_D10_p55_lanes;
  const Lanes<2> inverse_D10_p70_lanes = inverse_D10_p30_lanes + inverse_D10_p64_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p15_lanes + inverse_D11_p18_lanes));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p10_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p58_lanes -
      inverse_D10_p29_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p77_lanes = inverse_D10_p68_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p78_lanes = inverse_D10_p69_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p16_lanes = inverse_D8_p4_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p17_lanes = inverse_D8_p1_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p18_lanes = inverse_D8_p7_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p82_lanes = 0.000131 - inverse_D11_p18_lanes - 0.269 *
      (inverse_D10_p53_lanes + inverse_D10_p59_lanes) - inverse_D10_p68_lanes *
      inverse_D10_p77_lanes;
  const Lanes<2> inverse_D10_p83_lanes = 0.0001098 - 0.07236100000000001 * inverse_D10_p70_lanes -
      inverse_D10_p69_lanes * inverse_D10_p78_lanes;
  const Lanes<2> inverse_D10_p84_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      inverse_D10_p66_lanes - inverse_D10_p68_lanes * inverse_D10_p78_lanes;
  const Lanes<2> inverse_D8_p32_lanes = inverse_D10_p68_lanes * inverse_D8_p16_lanes -
      inverse_D10_p66_lanes;
  const Lanes<2> inverse_D8_p33_lanes = inverse_D10_p61_lanes - inverse_D10_p69_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p34_lanes = 0.269 * inverse_D10_p70_lanes + inverse_D10_p69_lanes *
      inverse_D8_p16_lanes;
  const Lanes<2> inverse_D8_p35_lanes = inverse_D10_p59_lanes + inverse_D10_p68_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p36_lanes = detail::make_pack<Real>(0.001, (-0.001)) -
      (inverse_D10_p55_lanes - inverse_D10_p35_lanes + 0.269 * inverse_D8_p6_lanes) -
      inverse_D10_p68_lanes * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p37_lanes = 0.269 * inverse_D8_p10_lanes - 6e-04 -
      inverse_D10_p69_lanes * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p38_lanes = inverse_D10_p70_lanes + inverse_D8_p4_lanes *
      inverse_D8_p16_lanes;
  const Lanes<2> inverse_D8_p39_lanes = inverse_D10_p40_lanes + inverse_D8_p1_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p40_lanes = inverse_D8_p4_lanes * inverse_D8_p17_lanes -
      inverse_D10_p54_lanes;
  const Lanes<2> inverse_D8_p41_lanes = inverse_D8_p4_lanes * inverse_D8_p18_lanes -
      inverse_D8_p10_lanes;
  const Lanes<2> inverse_D8_p42_lanes = inverse_D8_p6_lanes + inverse_D8_p1_lanes *
      inverse_D8_p18_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p59_lanes = 2.0 * detail::make_pack<Real>(s9, s16);

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p88_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p82_lanes - inverse_D10_p83_lanes) + inverse_D10_p7_lanes *
      inverse_D10_p84_lanes;
  const Lanes<2> inverse_D8_p63_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p32_lanes - inverse_D8_p33_lanes) + detail::make_pack<Real>(c11, c18) *
      (inverse_D8_p34_lanes - inverse_D8_p35_lanes);
  const Lanes<2> inverse_D8_p65_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * inverse_D8_p36_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p37_lanes);
  const Lanes<2> inverse_D8_p66_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p39_lanes - inverse_D8_p38_lanes) + inverse_D10_p7_lanes * inverse_D8_p40_lanes;
  const Lanes<2> inverse_D10_p89_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p88_lanes;
  const Lanes<2> inverse_D8_p67_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p68_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p69_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p66_lanes;
  const Lanes<2> inverse_D8_p72_lanes = inverse_D8_p33_lanes + inverse_D8_p68_lanes;
  const Lanes<2> inverse_D10_p91_lanes = 0.060888541114265754 +
      (inverse_D10_p83_lanes + inverse_D10_p89_lanes);
  const Lanes<2> inverse_D9_p5_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p88_lanes -
      inverse_D10_p84_lanes);
  const Lanes<2> inverse_D8_p78_lanes = inverse_D8_p67_lanes + inverse_D8_p35_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p91_lanes;
  const Lanes<2> inverse_D9_p7_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p91_lanes;
  const Lanes<2> inverse_D9_p9_lanes = inverse_D9_p5_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p11_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p91_lanes;
  const Lanes<2> inverse_D8_p80_lanes = inverse_D8_p78_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p81_lanes = inverse_D8_p65_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p82_lanes = inverse_D8_p72_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p13_lanes = 0.0001499998887063 + inverse_D9_p5_lanes *
      inverse_D9_p7_lanes;
  const Lanes<2> inverse_D8_p84_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p86_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p81_lanes;
  const Lanes<2> inverse_D9_p15_lanes = 0.06060754126741261 +
      (inverse_D10_p82_lanes - inverse_D10_p89_lanes) - inverse_D9_p5_lanes * inverse_D9_p9_lanes;
  const Lanes<2> inverse_D8_p95_lanes = inverse_D8_p32_lanes - inverse_D8_p68_lanes -
      inverse_D9_p5_lanes * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p96_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p36_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p37_lanes + inverse_D9_p5_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p97_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p98_lanes = 0.28049749700000004 +
      (inverse_D8_p67_lanes - inverse_D8_p34_lanes) - inverse_D9_p5_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p99_lanes = inverse_D8_p38_lanes + inverse_D8_p69_lanes +
      inverse_D8_p78_lanes * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p100_lanes = inverse_D10_p64_lanes - inverse_D10_p37_lanes -
      inverse_D8_p7_lanes * inverse_D8_p18_lanes - inverse_D8_p65_lanes * inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p101_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p41_lanes +
      detail::make_pack<Real>(s11, s18) * inverse_D8_p42_lanes + inverse_D8_p78_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p102_lanes = inverse_D8_p69_lanes - inverse_D8_p39_lanes -
      inverse_D8_p72_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p104_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p66_lanes -
      inverse_D8_p40_lanes - inverse_D8_p78_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p105_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p41_lanes -
      detail::make_pack<Real>(c11, c18) * inverse_D8_p42_lanes + inverse_D8_p65_lanes *
      inverse_D8_p82_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p1_lanes = 2.0 * detail::make_pack<Real>(c8, c15);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p118_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p97_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p98_lanes;
  const Lanes<2> inverse_D8_p120_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p98_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p97_lanes;
  const Lanes<2> inverse_D9_p18_lanes = inverse_D9_p1_lanes * inverse_D9_p13_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D9_p15_lanes - inverse_D9_p11_lanes);
  const Lanes<2> inverse_D8_p121_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p104_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p105_lanes;
  const Lanes<2> inverse_D8_p122_lanes = detail::make_pack<Real>(c10, c17) *
      (inverse_D8_p84_lanes + inverse_D8_p96_lanes) - detail::make_pack<Real>(s10, s17) *
      (inverse_D8_p95_lanes + inverse_D8_p86_lanes);
  const Lanes<2> inverse_D6_p5_lanes = inverse_D8_p118_lanes - 0.0022500062;
  const Lanes<2> inverse_D6_p7_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p105_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p104_lanes;
  const Lanes<2> inverse_D8_p124_lanes = detail::make_pack<Real>(s10, s17) *
      (inverse_D8_p99_lanes + inverse_D8_p100_lanes) + inverse_D9_p1_lanes * inverse_D8_p101_lanes;
  const Lanes<2> inverse_D8_p125_lanes = inverse_D8_p120_lanes + 0.282 * inverse_D8_p102_lanes;
  const Lanes<2> inverse_D9_p19_lanes = detail::make_pack<Real>(s10, s17) * inverse_D9_p18_lanes;
  const Lanes<2> inverse_D8_p127_lanes = 0.282 * inverse_D8_p121_lanes;
  const Lanes<2> inverse_D8_p128_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p122_lanes;
  const Lanes<2> inverse_D8_p129_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p122_lanes;
  const Lanes<2> inverse_D8_p130_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p124_lanes;
  const Lanes<2> inverse_D8_p134_lanes = inverse_D8_p96_lanes - inverse_D8_p128_lanes;
  const Lanes<2> inverse_D6_p13_lanes = inverse_D8_p86_lanes + inverse_D8_p129_lanes;
  const Lanes<2> inverse_D8_p137_lanes = inverse_D8_p130_lanes - inverse_D8_p99_lanes;
  const Lanes<2> inverse_D6_p15_lanes = inverse_D8_p101_lanes - detail::make_pack<Real>(c10, c17) *
      inverse_D8_p124_lanes;
  const Lanes<2> inverse_D8_p140_lanes = inverse_D8_p95_lanes + inverse_D8_p129_lanes +
      inverse_D8_p127_lanes;
  const Lanes<2> inverse_D6_p19_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      inverse_D8_p134_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (inverse_D9_p11_lanes - inverse_D9_p19_lanes));

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p143_lanes = 0.282 * inverse_D8_p118_lanes -
      (inverse_D9_p13_lanes - detail::make_pack<Real>(c10, c17) * inverse_D9_p18_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D8_p145_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * inverse_D8_p134_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p149_lanes = inverse_D8_p143_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D8_p150_lanes = inverse_D8_p145_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D6_p31_lanes = inverse_D6_p19_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D6_p33_lanes = inverse_D6_p5_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D6_p35_lanes = inverse_D6_p13_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D8_p151_lanes = inverse_D8_p143_lanes * inverse_D8_p149_lanes;
  const Lanes<2> inverse_D8_p154_lanes = 0.0019585440854647937 +
      (inverse_D9_p15_lanes + inverse_D9_p19_lanes + 0.282 *
      (inverse_D8_p120_lanes + inverse_D8_p125_lanes)) - inverse_D8_p151_lanes;
  const Lanes<2> inverse_D8_p155_lanes = 0.0008177492704690715 + 0.07952399999999998 *
      inverse_D8_p137_lanes - inverse_D8_p145_lanes * inverse_D8_p150_lanes;
  const Lanes<2> inverse_D8_p156_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * inverse_D8_p140_lanes - inverse_D8_p143_lanes *
      inverse_D8_p150_lanes;
  const Lanes<2> inverse_D6_p61_lanes = inverse_D8_p140_lanes + inverse_D8_p143_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p63_lanes = inverse_D8_p127_lanes + inverse_D8_p145_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p65_lanes = inverse_D8_p125_lanes - inverse_D8_p143_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p67_lanes = inverse_D8_p145_lanes * inverse_D6_p31_lanes - 0.282 *
      inverse_D8_p137_lanes;
  const Lanes<2> inverse_D6_p69_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * inverse_D6_p7_lanes - (inverse_D8_p84_lanes - inverse_D8_p128_lanes)) +
      inverse_D8_p143_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p71_lanes = 0.0022500062 + 0.282 * inverse_D6_p15_lanes +
      inverse_D8_p145_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p73_lanes = inverse_D8_p137_lanes - inverse_D6_p19_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p75_lanes = inverse_D8_p102_lanes - inverse_D6_p5_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p77_lanes = inverse_D8_p121_lanes + inverse_D6_p19_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p81_lanes = inverse_D6_p15_lanes + inverse_D6_p19_lanes *
      inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p109_lanes = inverse_D6_p7_lanes + inverse_D6_p5_lanes *
      inverse_D6_p35_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p111_lanes = 2.0 * detail::make_pack<Real>(s7, s14);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p160_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D8_p154_lanes - inverse_D8_p155_lanes) - inverse_D8_p59_lanes *
      inverse_D8_p156_lanes;
  const Lanes<2> inverse_D6_p123_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p61_lanes + inverse_D6_p63_lanes) - detail::make_pack<Real>(s9, s16) *
      (inverse_D6_p67_lanes + inverse_D6_p65_lanes);
  const Lanes<2> inverse_D6_p125_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * inverse_D6_p69_lanes -
      detail::make_pack<Real>(s9, s16) * inverse_D6_p71_lanes);
  const Lanes<2> inverse_D6_p127_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p73_lanes - inverse_D6_p75_lanes) - inverse_D8_p59_lanes * inverse_D6_p77_lanes;
  const Lanes<2> inverse_D8_p161_lanes = detail::make_pack<Real>(c9, c16) * inverse_D8_p160_lanes;
  const Lanes<2> inverse_D6_p129_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p123_lanes;
  const Lanes<2> inverse_D6_p131_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p123_lanes;
  const Lanes<2> inverse_D6_p137_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p127_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p1_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p145_lanes = inverse_D6_p131_lanes - inverse_D6_p63_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Real inverse_D22_p3 = c24 + c23;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p163_lanes = 0.18125194219699997 +
      (inverse_D8_p155_lanes + inverse_D8_p161_lanes);
  const Lanes<2> inverse_D7_p5_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * inverse_D8_p160_lanes + inverse_D8_p156_lanes);

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p3_lanes = detail::make_pack<Real>(c23, c24) * inverse_D21_p1_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p155_lanes = 0.7139200499999999 +
      (inverse_D6_p129_lanes + inverse_D6_p65_lanes);

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p5 = s24 + s23;
  const Lanes<2> inverse_D22_p4_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p163_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p8_lanes = detail::make_pack<Real>(s23, s24) * inverse_D21_p1_lanes;
  const Lanes<2> inverse_D21_p10_lanes = inverse_D21_p3_lanes - 0.0007770270270270272;
  const Lanes<2> inverse_D21_p12_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);
  const Real inverse_D22_p6 = inverse_D22_p4_lanes[1] + inverse_D22_p4_lanes[0];
  const Real inverse_D21_p14 = inverse_D21_p8_lanes[1] + inverse_D21_p8_lanes[0];
  const Lanes<2> inverse_D21_p15_lanes = detail::make_pack<Real>(0.032, (-0.032)) *
      inverse_D21_p10_lanes;
  const Real inverse_D6_p159 = 0.431222972972973 + inverse_D21_p3_lanes[1] +
      inverse_D21_p10_lanes[0];
  const Lanes<2> inverse_D21_p17_lanes = 0.006756756756756757 * detail::make_pack<Real>(s23, s24);
  const Real inverse_D6_p160 = 0.072575 + 0.00025 * inverse_D22_p3;
  const Real inverse_D21_p19 = inverse_D21_p12_lanes[0] + 2.375e-05 * inverse_D21_p5 +
      inverse_D21_p12_lanes[1];
  const Lanes<2> inverse_D21_p20_lanes = detail::make_pack<Real>(c23, c24) * inverse_D21_p17_lanes;
  const Lanes<2> inverse_D21_p22_lanes = detail::make_pack<Real>(s23, s24) * inverse_D21_p17_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p6 + 4.75e-05 * inverse_D22_p3);

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p24 = inverse_D21_p15_lanes[1] + inverse_D21_p15_lanes[0] - 0.095 *
      inverse_D21_p14;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p8_lanes = inverse_D7_p5_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p9_lanes = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p163_lanes;
  const Lanes<2> inverse_D6_p161_lanes = inverse_D6_p125_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D6_p163_lanes = inverse_D6_p155_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D6_p165_lanes = inverse_D6_p145_lanes * inverse_D8_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p29_lanes = 0.095 * inverse_D21_p20_lanes +
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D21_p22_lanes;
  const Lanes<2> inverse_D21_p31_lanes = inverse_D21_p22_lanes - 0.006756756756756757;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p171_lanes = 0.00010499999999999999 * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p173_lanes = 0.00010499999999999999 * inverse_D6_p161_lanes;
  const Lanes<2> inverse_D7_p12_lanes = 0.18113119219699997 +
      (inverse_D8_p154_lanes - inverse_D8_p161_lanes) - inverse_D7_p5_lanes * inverse_D7_p8_lanes;
  const Lanes<2> inverse_D7_p13_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + 0.00010499999999999999 * inverse_D7_p8_lanes;
  const Lanes<2> inverse_D6_p183_lanes = inverse_D7_p5_lanes * inverse_D6_p161_lanes -
      (detail::make_pack<Real>(s9, s16) * inverse_D6_p69_lanes + detail::make_pack<Real>(c9, c16) *
      inverse_D6_p71_lanes);
  const Lanes<2> inverse_D6_p185_lanes = inverse_D6_p61_lanes - inverse_D6_p131_lanes -
      inverse_D7_p5_lanes * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p187_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p37 = inverse_D21_p3_lanes[1] + inverse_D21_p3_lanes[0];

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p189_lanes = inverse_D6_p129_lanes + inverse_D6_p67_lanes -
      0.7139200499999999 - inverse_D7_p5_lanes * inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p38 = inverse_D21_p24 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p39_lanes = 0.095 * inverse_D21_p31_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D21_p20_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p41 = 2.0 * c22;
  const Real inverse_D6_p191 = inverse_D6_p159 * inverse_D22;
  const Real inverse_D6_p192 = inverse_D6_p160 * inverse_D22;
  const Real inverse_D21_p42 = inverse_D21_p39_lanes[1] + inverse_D21_p39_lanes[0];
  const Real inverse_D6_p197 = inverse_D21_p14 * inverse_D22;
  const Real inverse_D21_p43 = 0.05450270000000001 + inverse_D22_p6 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - inverse_D21_p19 * inverse_D21_p19 * inverse_D22;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p17_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D7_p9_lanes - inverse_D7_p12_lanes) + inverse_D7_p1_lanes * inverse_D7_p13_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p204 = inverse_D21_p24 * inverse_D6_p192;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p205_lanes = inverse_D6_p73_lanes - inverse_D6_p137_lanes -
      inverse_D6_p155_lanes * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p207_lanes = inverse_D8_p100_lanes - inverse_D8_p130_lanes -
      inverse_D6_p13_lanes * inverse_D6_p35_lanes - inverse_D6_p125_lanes * inverse_D6_p161_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p44 = inverse_D21_p43 - 0.00017071621621621625;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p18_lanes = detail::make_pack<Real>(s8, s15) * inverse_D7_p17_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p209 = inverse_D21_p19 * inverse_D6_p191 - inverse_D21_p14;
  const Real inverse_D6_p210 = inverse_D21_p29_lanes[1] + inverse_D21_p29_lanes[0] +
      inverse_D21_p24 * inverse_D6_p191;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p211_lanes = detail::make_pack<Real>(c8, c15) *
      (inverse_D6_p183_lanes + inverse_D6_p171_lanes) - detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p173_lanes + inverse_D6_p185_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D21_p45 = 0.009438624999999999 - (-0.032) * inverse_D21_p29_lanes[1] - 0.032 *
      inverse_D21_p29_lanes[0] - inverse_D21_p24 * inverse_D21_p38 + 0.095 * inverse_D21_p42;
  const Real inverse_D21_p46 = 0.0074 - (-0.032) * inverse_D21_p8_lanes[1] - 0.032 *
      inverse_D21_p8_lanes[0] + inverse_D21_p19 * inverse_D21_p38 - 0.095 * inverse_D21_p37;
  const Real inverse_D6_p215 = inverse_D21_p19 * inverse_D6_p192 - 0.00025 * inverse_D21_p5;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p220_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p211_lanes;
  const Lanes<2> inverse_D6_p222_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p81_lanes -
      detail::make_pack<Real>(c9, c16) * inverse_D6_p109_lanes + inverse_D6_p125_lanes *
      inverse_D6_p163_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p224 = 0.072575 + inverse_D21_p42 + inverse_D21_p24 * inverse_D6_p197;
  const Real inverse_D6_p225 = inverse_D21_p37 - 0.43200000000000005 + inverse_D21_p19 *
      inverse_D6_p197;
  const Real inverse_D6_p226 = inverse_D6_p160 * inverse_D6_p192;
  const Real inverse_D6_p227 = inverse_D21_p22_lanes[1] + inverse_D21_p22_lanes[0] +
      inverse_D6_p159 * inverse_D6_p191;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p20_lanes = 0.000448 + (inverse_D7_p12_lanes + inverse_D7_p18_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p236 = inverse_D6_p159 * inverse_D6_p192;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D7_lanes = 1.0 / inverse_D7_p20_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p241_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * inverse_D6_p187_lanes + detail::make_pack<Real>(c8, c15) *
      inverse_D6_p189_lanes);
  const Lanes<2> inverse_D6_p243_lanes = 0.0017499999999999998 +
      (inverse_D6_p220_lanes - inverse_D6_p171_lanes);
  const Lanes<2> inverse_D6_p245_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p207_lanes - inverse_D6_p205_lanes) + inverse_D7_p1_lanes * inverse_D6_p222_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p247 = inverse_D6_p160 * inverse_D6_p197;
  const Real inverse_D21_p47 = s22 * (inverse_D21_p44 - inverse_D21_p45) + inverse_D21_p41 *
      inverse_D21_p46;
  const Real inverse_D6_p250 = s22 * (inverse_D6_p209 + inverse_D6_p204) + c22 *
      (inverse_D6_p215 - inverse_D6_p210);
  const Real inverse_D6_p251 = c22 * inverse_D6_p224 - s22 * inverse_D6_p225;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p254_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p245_lanes;
  const Lanes<2> inverse_D6_p256_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p81_lanes +
      detail::make_pack<Real>(s9, s16) * inverse_D6_p109_lanes + inverse_D6_p125_lanes *
      inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p48 = s22 * inverse_D21_p47;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p258_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p127_lanes +
      inverse_D6_p77_lanes - inverse_D6_p155_lanes * inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p260 = inverse_D21_p20_lanes[1] + inverse_D21_p20_lanes[0] -
      inverse_D6_p159 * inverse_D6_p197;
  const Real inverse_D6_p261 = inverse_D21_p31_lanes[1] + inverse_D21_p31_lanes[0] -
      inverse_D21_p14 * inverse_D6_p197;
  const Real inverse_D6_p262 = c22 * inverse_D6_p250;
  const Real inverse_D6_p263 = c22 * inverse_D6_p225 + s22 * inverse_D6_p224;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p264_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p211_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p272 = inverse_D21_p41 * inverse_D6_p236 - s22 *
      (inverse_D6_p226 - inverse_D6_p227);
  const Real inverse_D6_p279 = inverse_D6_p262 - inverse_D6_p215;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p280_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p17_lanes -
      inverse_D7_p13_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p284 = s22 * inverse_D6_p272;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p285_lanes = inverse_D6_p185_lanes + inverse_D6_p264_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p287 = s22 * inverse_D6_p250;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p288_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p20_lanes;
  const Lanes<2> inverse_D6_p292_lanes = inverse_D6_p243_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p294_lanes = inverse_D6_p241_lanes * inverse_D7_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p296 = inverse_D6_p263 - 0.394 * inverse_D6_p261;
  const Real inverse_D6_p297 = 0.394 * inverse_D6_p279;
  const Real inverse_D6_p298 = c22 * inverse_D6_p260 + s22 * inverse_D6_p247;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p299_lanes = inverse_D6_p285_lanes * inverse_D7_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p45 + inverse_D21_p48));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p305 = 0.0016155 + (c22 * inverse_D21_p47 - inverse_D21_p46 + 0.394 *
      inverse_D6_p251);
  const Real inverse_D6_p306 = inverse_D6_p284 - inverse_D6_p227;
  const Real inverse_D6_p323 = 0.394 * inverse_D6_p298;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p324_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p294_lanes;
  const Lanes<2> inverse_D6_p326_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p292_lanes;
  const Lanes<2> inverse_D6_p332_lanes = inverse_D6_p280_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p340_lanes = inverse_D6_p75_lanes + inverse_D6_p137_lanes -
      inverse_D6_p145_lanes * inverse_D6_p165_lanes - inverse_D6_p241_lanes * inverse_D6_p294_lanes;
  const Lanes<2> inverse_D6_p342_lanes = inverse_D6_p207_lanes - inverse_D6_p254_lanes -
      inverse_D6_p243_lanes * inverse_D6_p292_lanes;
  const Lanes<2> inverse_D6_p344_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p256_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p258_lanes - inverse_D6_p241_lanes *
      inverse_D6_p292_lanes;
  const Lanes<2> inverse_D6_p346_lanes = inverse_D6_p173_lanes + inverse_D6_p264_lanes +
      inverse_D6_p280_lanes * inverse_D6_p292_lanes;
  const Lanes<2> inverse_D6_p348_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p187_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p189_lanes - inverse_D6_p280_lanes *
      inverse_D6_p294_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p350 = inverse_D6_p209 - inverse_D6_p287 - inverse_D6_p323;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p351 = 2.0 * s21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p352_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p256_lanes +
      detail::make_pack<Real>(c8, c15) * inverse_D6_p258_lanes - inverse_D6_p241_lanes *
      inverse_D6_p299_lanes;
  const Lanes<2> inverse_D6_p354_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p245_lanes -
      inverse_D6_p222_lanes - inverse_D6_p243_lanes * inverse_D6_p299_lanes;
  const Lanes<2> inverse_D6_p370_lanes = 0.0001505 - inverse_D6_p288_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p386 = inverse_D6_p297 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p389_lanes = 0.0002975 + (inverse_D7_p9_lanes - inverse_D7_p18_lanes) -
      inverse_D6_p280_lanes * inverse_D6_p332_lanes;
  const Lanes<2> inverse_D6_p393_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p332_lanes;
  const Lanes<2> inverse_D6_p399_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p352_lanes +
      detail::make_pack<Real>(c7, c14) * inverse_D6_p354_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D5_p5 = 0.0045000000000000005 + inverse_D6_p251;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p401_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p340_lanes - inverse_D6_p342_lanes) - inverse_D6_p111_lanes *
      inverse_D6_p344_lanes;
  const Lanes<2> inverse_D6_p405_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p299_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p6 = inverse_D6_p279 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p407_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p346_lanes - inverse_D6_p324_lanes) - detail::make_pack<Real>(s7, s14) *
      (inverse_D6_p348_lanes - inverse_D6_p326_lanes);
  const Lanes<2> inverse_D6_p413_lanes = inverse_D6_p220_lanes - inverse_D6_p183_lanes -
      0.0017499999999999998 - inverse_D6_p280_lanes * inverse_D6_p299_lanes;
  const Lanes<2> inverse_D6_p415_lanes = inverse_D6_p205_lanes + inverse_D6_p254_lanes -
      inverse_D6_p285_lanes * inverse_D6_p299_lanes;
  const Lanes<2> inverse_D6_p417_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p401_lanes;
  const Lanes<2> inverse_D6_p423_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p407_lanes;
  const Lanes<2> inverse_D5_p9_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p352_lanes -
      detail::make_pack<Real>(s7, s14) * inverse_D6_p354_lanes;
  const Lanes<2> inverse_D5_p11_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p407_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p427 = 0.005513625 + (inverse_D21_p44 - inverse_D21_p48 - 0.394 *
      (inverse_D6_p263 + inverse_D6_p296)) - inverse_D6_p305 * (inverse_D6_p305 * inverse_D21);
  const Real inverse_D6_p428 = 0.000703125 + 0.155236 * inverse_D6_p306 - inverse_D6_p297 *
      inverse_D6_p386;
  const Real inverse_D6_p429 = 0.394 * inverse_D6_p350 - inverse_D6_p305 * inverse_D6_p386;
  const Real inverse_D5_p13 = inverse_D5_p5 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p434_lanes = inverse_D6_p340_lanes - inverse_D6_p417_lanes;
  const Lanes<2> inverse_D6_p436_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p370_lanes - inverse_D6_p389_lanes) + inverse_D6_p111_lanes *
      inverse_D6_p393_lanes;
  const Lanes<2> inverse_D5_p14_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p401_lanes +
      inverse_D6_p344_lanes;
  const Lanes<2> inverse_D5_p16_lanes = 0.226 * inverse_D5_p9_lanes;
  const Lanes<2> inverse_D6_p438_lanes = inverse_D6_p326_lanes - inverse_D6_p423_lanes;
  const Lanes<2> inverse_D6_p440_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p405_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p413_lanes;
  const Lanes<2> inverse_D5_p20_lanes = inverse_D6_p324_lanes + inverse_D5_p11_lanes;
  const Lanes<2> inverse_D6_p444_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p436_lanes;
  const Lanes<2> inverse_D5_p22_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      inverse_D5_p14_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p24 = inverse_D6_p350 - inverse_D6_p305 * inverse_D5_p6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p25_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p436_lanes;
  const Lanes<2> inverse_D6_p448_lanes = inverse_D6_p440_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p399_lanes + 0.226 *
      inverse_D6_p415_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p27 = 0.394 * inverse_D6_p306 - inverse_D6_p297 * inverse_D5_p6;

  // link 22 (head), articulated inertia
  const Real inverse_D3_p1 = inverse_D6_p287 - inverse_D6_p204;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p452 = inverse_D6_p444_lanes[1] + inverse_D6_p444_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p453 = c21 * (inverse_D6_p427 - inverse_D6_p428) - inverse_D6_p351 *
      inverse_D6_p429;
  const Real inverse_D5_p34 = inverse_D6_p323 + inverse_D6_p297 * inverse_D5_p13;
  const Real inverse_D5_p35 = inverse_D6_p296 + inverse_D6_p305 * inverse_D5_p13;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p454 = inverse_D6_p448_lanes[1] + inverse_D6_p448_lanes[0];

  // link 22 (head), articulated inertia
  const Real inverse_D3_p2 = c22 * inverse_D6_p247 - s22 * inverse_D6_p260;
  const Real inverse_D3_p3 = inverse_D6_p236 - c22 * inverse_D6_p272;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p36_lanes = inverse_D6_p342_lanes + inverse_D6_p417_lanes;
  const Lanes<2> inverse_D6_p455_lanes = inverse_D6_p438_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p434_lanes + 0.226 *
      inverse_D6_p399_lanes);
  const Lanes<2> inverse_D5_p38_lanes = inverse_D5_p11_lanes - inverse_D6_p346_lanes -
      (inverse_D5_p22_lanes + inverse_D5_p16_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p4 = inverse_D3_p1 * inverse_D21;
  const Real inverse_D6_p457 = c21 * inverse_D6_p453;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p40_lanes = inverse_D6_p423_lanes + inverse_D6_p348_lanes;
  const Lanes<2> inverse_D5_p46_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p405_lanes -
      detail::make_pack<Real>(c7, c14) * inverse_D6_p413_lanes;
  const Real inverse_D5_p48 = inverse_D5_p38_lanes[1] + inverse_D5_p38_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p49 = inverse_D6_p306 - inverse_D6_p279 * inverse_D5_p6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p460_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D6_p438_lanes + inverse_D6_p455_lanes);
  const Lanes<2> inverse_D5_p50_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p38_lanes + inverse_D5_p20_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p52 = inverse_D6_p261 - inverse_D5_p5 * inverse_D5_p13;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p53_lanes = inverse_D5_p40_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p36_lanes;
  const Real inverse_D5_p55 = inverse_D5_p46_lanes[1] + inverse_D5_p46_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p56 = c21 * (inverse_D5_p24 - inverse_D5_p34) - s21 *
      (inverse_D5_p27 + inverse_D5_p35);
  const Real inverse_D5_p57 = inverse_D6_p298 + inverse_D6_p279 * inverse_D5_p13;
  const Real inverse_D5_p60 = c21 * inverse_D5_p56;
  const Real inverse_D3_p5 = inverse_D6_p305 * inverse_D3_p4 -
      (inverse_D6_p262 + inverse_D6_p210 + 0.394 * inverse_D3_p2);
  const Real inverse_D5_p61 = s21 * inverse_D5_p56;
  const Real inverse_D3_p6 = inverse_D6_p297 * inverse_D3_p4 -
      (0.0045000000000000005 + 0.394 * inverse_D3_p3);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p62 = s21 * inverse_D6_p453 + inverse_D6_p429 + 0.226 * inverse_D5_p48;
  const Lanes<2> inverse_D5_p63_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p40_lanes + inverse_D5_p53_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p65 = inverse_D5_p36_lanes[1] + inverse_D5_p36_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p66 = c21 * (inverse_D5_p49 - inverse_D5_p52) - inverse_D6_p351 *
      inverse_D5_p57;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p67 = inverse_D5_p34 + inverse_D5_p60 + inverse_D5_p48;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p68 = c21 * inverse_D5_p66;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p69 = 2.0 * c6;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p462 = 2.06965463592404 + inverse_D6_p428 + inverse_D6_p457 +
      inverse_D6_p389_lanes[1] + inverse_D6_p452 + inverse_D6_p460_lanes[1] +
      inverse_D6_p389_lanes[0] + inverse_D6_p460_lanes[0] + 0.226 *
      (inverse_D6_p440_lanes[1] + inverse_D6_p454 + inverse_D6_p440_lanes[0]);
  const Real inverse_D3_p7 = inverse_D5_p61 + inverse_D5_p35 - 6.1665928899999995 - inverse_D6_p454;

  // link 6 (chest3), articulated inertia
  const Real inverse_D3_p8 = inverse_D5_p14_lanes[1] + inverse_D5_p14_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p9 = inverse_D6_p279 * inverse_D3_p4 - inverse_D3_p3;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D3_p10 = c21 * inverse_D3_p5 - s21 * inverse_D3_p6 + inverse_D6_p455_lanes[1] +
      inverse_D6_p455_lanes[0];
  const Lanes<2> inverse_D3_p11_lanes = inverse_D5_p22_lanes - inverse_D5_p20_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p462;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p70 = 0.0187369177636143 + inverse_D5_p50_lanes[1] -
      inverse_D6_p393_lanes[1] + inverse_D5_p25_lanes[1] + inverse_D5_p50_lanes[0] -
      inverse_D6_p393_lanes[0] + inverse_D5_p25_lanes[0] + 0.226 * inverse_D5_p55;

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p13 = inverse_D3_p2 - inverse_D5_p5 * inverse_D3_p4;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p71 = inverse_D5_p67 * inverse_D6;
  const Real inverse_D5_p72 = inverse_D5_p62 * inverse_D6;
  const Real inverse_D5_p73 = inverse_D5_p70 * inverse_D6;
  const Real inverse_D3_p14 = inverse_D3_p10 * inverse_D6;
  const Real inverse_D3_p15 = inverse_D3_p7 * inverse_D6;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p16 = 2.0 * c5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p74 = inverse_D5_p53_lanes[1] + inverse_D5_p53_lanes[0] - inverse_D5_p70 *
      inverse_D5_p71;
  const Real inverse_D5_p75 = 0.40056549999999996 - inverse_D6_p288_lanes[1] - inverse_D6_p452 +
      inverse_D5_p63_lanes[1] + inverse_D6_p370_lanes[0] + inverse_D5_p63_lanes[0] -
      inverse_D5_p70 * inverse_D5_p73;
  const Real inverse_D5_p76 = inverse_D5_p52 + inverse_D5_p68 + inverse_D5_p65 - inverse_D5_p67 *
      inverse_D5_p71;
  const Real inverse_D3_p17 = inverse_D3_p11_lanes[1] + inverse_D3_p11_lanes[0] + inverse_D5_p70 *
      inverse_D3_p14;
  const Real inverse_D3_p18 = inverse_D5_p24 - inverse_D5_p60 + inverse_D5_p16_lanes[1] +
      inverse_D5_p16_lanes[0] - inverse_D5_p62 * inverse_D3_p15;
  const Real inverse_D3_p19 = (-0.18) * inverse_D5_p9_lanes[1] - inverse_D5_p55 + 0.18 *
      inverse_D5_p9_lanes[0] - inverse_D5_p70 * inverse_D3_p15;
  const Real inverse_D3_p20 = inverse_D3_p8 - c21 * inverse_D3_p9 + s21 * inverse_D3_p13 +
      inverse_D3_p10 * inverse_D5_p71;
  const Real inverse_D3_p21 = s21 * inverse_D5_p66 + inverse_D5_p57 + inverse_D5_p9_lanes[1] +
      inverse_D5_p9_lanes[0] - inverse_D3_p7 * inverse_D5_p71;
  const Real inverse_D5_p77 = 6.1665928899999995 + inverse_D5_p61 + inverse_D5_p27 -
      inverse_D5_p62 * inverse_D5_p71 + 0.226 * inverse_D5_p65;
  const Real inverse_D5_p78 = 1.66923963592404 + inverse_D6_p427 - inverse_D6_p457 -
      inverse_D5_p62 * inverse_D5_p72 + 0.051076 * inverse_D5_p65;
  const Real inverse_D3_p22 = inverse_D6_p434_lanes[1] -
      (inverse_D6_p226 + inverse_D6_p284 + inverse_D3_p1 * inverse_D3_p4) +
      inverse_D6_p434_lanes[0] - inverse_D3_p10 * inverse_D3_p14;
  const Real inverse_D5_p79 = (-0.04068) * inverse_D5_p36_lanes[1] + 0.04068 *
      inverse_D5_p36_lanes[0] - inverse_D5_p70 * inverse_D5_p72 + 0.226 *
      (inverse_D5_p40_lanes[1] + inverse_D5_p40_lanes[0]);
  const Real inverse_D3_p23 = inverse_D5_p62 * inverse_D3_p14 -
      (s21 * inverse_D3_p5 + c21 * inverse_D3_p6) + 0.226 * inverse_D3_p8;
  const Real inverse_D3_p24 = inverse_D5_p49 - inverse_D5_p68 + inverse_D6_p415_lanes[1] +
      inverse_D6_p415_lanes[0] - inverse_D3_p7 * inverse_D3_p15;
  const Real inverse_D3_p25 = inverse_D6_p399_lanes[1] -
      (s21 * inverse_D3_p9 + c21 * inverse_D3_p13) + inverse_D6_p399_lanes[0] + inverse_D3_p10 *
      inverse_D3_p15;
  const Real inverse_D3_p26 = c6 * inverse_D3_p20 - s6 * inverse_D3_p21;
  const Real inverse_D5_p80 = s6 * inverse_D5_p74 + c6 * inverse_D5_p77;
  const Real inverse_D4_p1 = s6 * inverse_D3_p20 + c6 * inverse_D3_p21;
  const Real inverse_D4_p2 = c6 * inverse_D5_p74 - s6 * inverse_D5_p77;
  const Real inverse_D5_p81 = inverse_D5_p80 + 0.072 * inverse_D5_p76;
  const Real inverse_D5_p82 = s6 * (inverse_D5_p75 - inverse_D5_p78) + inverse_D5_p69 *
      inverse_D5_p79;
  const Real inverse_D4_p3 = 0.072 * inverse_D4_p1;
  const Real inverse_D3_p27 = s6 * (inverse_D3_p17 - inverse_D3_p18) + c6 *
      (inverse_D3_p23 + inverse_D3_p19);
  const Real inverse_D3_p28 = s6 * (inverse_D3_p22 - inverse_D3_p24) + inverse_D5_p69 *
      inverse_D3_p25;
  const Real inverse_D5_p83 = s6 * inverse_D5_p82;
  const Real inverse_D3_p29 = 2.2194301519999997 + inverse_D5_p81;
  const Real inverse_D3_p30 = c6 * inverse_D3_p27;
  const Real inverse_D4_p4 = s6 * inverse_D3_p27;
  const Real inverse_D3_p31 = s6 * inverse_D3_p28;
  const Real inverse_D3_p32 = c6 * inverse_D3_p28 - inverse_D3_p25;
  const Real inverse_D4_p5 = inverse_D3_p24 + inverse_D3_p31;
  const Real inverse_D4_p6 = inverse_D3_p30 - inverse_D3_p23;
  const Real inverse_D4_p7 = c6 * inverse_D5_p82 - inverse_D5_p79 + 0.072 * inverse_D4_p2;
  const Real inverse_D4_p8 = inverse_D3_p18 + inverse_D4_p4 + inverse_D4_p3;
  const Real inverse_D3_p33 = 0.069699984375 + (inverse_D3_p30 - inverse_D3_p19 + 0.072 *
      inverse_D3_p26);
  const Real inverse_D4_p9 = 0.072 * inverse_D4_p8;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p78 + inverse_D5_p83 + 0.072 * (inverse_D5_p80 + inverse_D5_p81)));
  const Real inverse_D3_p34 = inverse_D3_p29 * inverse_D5;
  const Real inverse_D3_p35 = inverse_D3_p33 * inverse_D5;
  const Real inverse_D3_p36 = inverse_D4_p8 * inverse_D5;
  const Real inverse_D4_p10 = inverse_D4_p9 * inverse_D5;
  const Real inverse_D4_p11 = inverse_D4_p7 * inverse_D5;
  const Real inverse_D3_p37 = inverse_D3_p22 - inverse_D3_p31 - inverse_D3_p33 * inverse_D3_p35;
  const Real inverse_D3_p38 = inverse_D5_p76 - inverse_D3_p29 * inverse_D3_p34;
  const Real inverse_D3_p39 = inverse_D3_p26 - inverse_D3_p29 * inverse_D3_p35;
  const Real inverse_D3_p40 = inverse_D4_p9 * inverse_D3_p34 - inverse_D4_p3;
  const Real Lambda_11_11_p1 = s2 * c3 + c2 * s3;
  const Real inverse_D3_p41 = inverse_D3_p17 - inverse_D4_p4 - inverse_D4_p7 * inverse_D3_p35;
  const Real inverse_D3_p42 = inverse_D4_p2 - inverse_D4_p7 * inverse_D3_p34;
  const Real inverse_D3_p43 = inverse_D4_p9 * inverse_D3_p35 - 0.072 * inverse_D3_p32;
  const Real inverse_D3_p44 = inverse_D3_p32 - inverse_D3_p33 * inverse_D3_p36;
  const Real inverse_D3_p45 = inverse_D4_p1 - inverse_D3_p29 * inverse_D3_p36;
  const Real inverse_D4_p12 = 0.15637308509675518 + 0.005183999999999999 * inverse_D4_p5 -
      inverse_D4_p9 * inverse_D4_p10;
  const Real Lambda_11_11_p2 = c2 * c3 - s2 * s3;
  const Real inverse_D4_p13 = 0.04675382692737882 + (inverse_D5_p75 - inverse_D5_p83) -
      inverse_D4_p7 * inverse_D4_p11;
  const Real inverse_D4_p14 = 0.005678398088837119 - 0.072 * inverse_D4_p6 + inverse_D4_p9 *
      inverse_D4_p11;
  const Real inverse_D3_p46 = inverse_D4_p6 - 0.069699984375 - inverse_D4_p7 * inverse_D3_p36;
  const Real inverse_D3_p47 = inverse_D4_p9 * inverse_D3_p36 -
      (2.2194301519999997 + 0.072 * inverse_D4_p5);
  const Real inverse_D3_p48 = s5 * (inverse_D3_p38 - inverse_D3_p37) + inverse_D3_p16 *
      inverse_D3_p39;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_11_11_p3_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 3 (hip), pose
  const Real Lambda_11_11_p5 = Lambda_11_11_p1 * c1 + Lambda_11_11_p2 * s1;
  const Real inverse_D2_p1 = 0.422 * c2;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p49 = s5 * (inverse_D3_p40 - inverse_D3_p41) + c5 *
      (inverse_D3_p42 + inverse_D3_p43);
  const Real inverse_D2_p2 = 0.422 * s2;

  // link 3 (hip), pose
  const Real Lambda_11_11_p6 = Lambda_11_11_p2 * c1 - Lambda_11_11_p1 * s1;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p50 = s5 * inverse_D3_p48;
  const Real inverse_D4_p15 = s5 * (inverse_D4_p12 - inverse_D4_p13) + inverse_D3_p16 *
      inverse_D4_p14;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p7 = c4 * Lambda_11_11_p5;
  const Real Lambda_11_11_p8 = s4 * Lambda_11_11_p5;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p51 = s5 * inverse_D3_p49;
  const Real inverse_D3_p52 = s5 * inverse_D3_p46 - c5 * inverse_D3_p47;
  const Real inverse_D3_p53 = c5 * inverse_D3_p49;
  const Real inverse_D4_p16 = s5 * inverse_D4_p15;
  const Real inverse_D3_p54 = inverse_D3_p38 - inverse_D3_p50;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p9 = s5 * s4;
  const Real Lambda_11_11_p10 = s5 * Lambda_11_11_p7 - c5 * Lambda_11_11_p6;
  const Real Lambda_11_11_p11 = c5 * s4;
  const Real Lambda_11_11_p12 = s5 * Lambda_11_11_p6 + c5 * Lambda_11_11_p7;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p13 + inverse_D4_p16));

  // link 6 (chest3), pose
  const Real Lambda_11_11_p21 = s6 * c4 - c6 * Lambda_11_11_p9;
  const Real Lambda_11_11_p22 = s6 * Lambda_11_11_p9 + c6 * c4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p55 = c4 * (2.0 * (s5 * inverse_D3_p44 - c5 * inverse_D3_p45)) - s4 *
      (inverse_D3_p54 - (inverse_D4_p5 - inverse_D4_p8 * inverse_D3_p36));
  const Real inverse_D3_p56 = s4 * (s5 * inverse_D3_p47 + c5 * inverse_D3_p46) - c4 *
      (inverse_D3_p53 - inverse_D3_p43);
  const Real inverse_D2_p3 = s4 * (s5 * inverse_D3_p45 + c5 * inverse_D3_p44) - c4 *
      (c5 * inverse_D3_p48 - inverse_D3_p39);
  const Real inverse_D2_p4 = inverse_D3_p41 + inverse_D3_p51;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p23 = c6 * Lambda_11_11_p10 + s6 * Lambda_11_11_p8;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p24 = c4 * Lambda_11_11_p6;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p25 = c6 * Lambda_11_11_p8 - s6 * Lambda_11_11_p10;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p30 = s4 * Lambda_11_11_p6;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p43_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p21 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p11;
  const Lanes<2> Lambda_11_11_p45_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p21 +
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p11;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p57 = inverse_D3_p54 + s4 * inverse_D3_p55;
  const Real inverse_D3_p58 = inverse_D3_p52 - c4 *
      (c4 * inverse_D3_p52 - s4 * (inverse_D3_p40 - inverse_D3_p51));
  const Real inverse_D2_p5 = 0.0300000063 * s4 + inverse_D3_p56;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p47_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p23 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p12;
  const Lanes<2> Lambda_11_11_p49_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p23 -
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p12;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p51 = s5 * Lambda_11_11_p24 + c5 * Lambda_11_11_p5;
  const Real Lambda_11_11_p52 = c5 * Lambda_11_11_p24 - s5 * Lambda_11_11_p5;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p59 = 0.21799999999999997 * inverse_D3_p56 +
      (0.005880002159562879 - (c5 * inverse_D4_p15 - inverse_D4_p14)) * s4;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p65_lanes = detail::make_pack<Real>(c8, c15) * Lambda_11_11_p22 -
      detail::make_pack<Real>(s8, s15) * Lambda_11_11_p43_lanes;
  const Lanes<2> Lambda_11_11_p67_lanes = 0.086 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> Lambda_11_11_p69_lanes = 0.086 * detail::make_pack<Real>(s13, s20);

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p60 = inverse_D3_p59 * inverse_D4;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p71_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p43_lanes + detail::make_pack<Real>(s8, s15) * Lambda_11_11_p22;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p61 = inverse_D3_p58 + 0.21799999999999997 * inverse_D3_p57;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p6 = inverse_D2_p4 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p5 * inverse_D4;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p73_lanes = detail::make_pack<Real>(c8, c15) * Lambda_11_11_p25 -
      detail::make_pack<Real>(s8, s15) * Lambda_11_11_p47_lanes;
  const Lanes<2> Lambda_11_11_p75_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p47_lanes + detail::make_pack<Real>(s8, s15) * Lambda_11_11_p25;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p77 = c6 * Lambda_11_11_p51 + s6 * Lambda_11_11_p30;
  const Real Lambda_11_11_p78 = s6 * Lambda_11_11_p51 - c6 * Lambda_11_11_p30;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p87 = s16 * Lambda_11_11_p65_lanes[1] + c16 * Lambda_11_11_p45_lanes[1];
  const Real Lambda_11_11_p88 = c16 * Lambda_11_11_p65_lanes[1] - s16 * Lambda_11_11_p45_lanes[1];
  const Real Lambda_11_11_p89 = s16 * Lambda_11_11_p73_lanes[1] + c16 * Lambda_11_11_p49_lanes[1];
  const Real Lambda_11_11_p90 = c16 * Lambda_11_11_p73_lanes[1] - s16 * Lambda_11_11_p49_lanes[1];

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p91_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p77 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p52;
  const Lanes<2> Lambda_11_11_p93_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p52 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p77;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p8 = 0.0300000063 * c4 + (0.21799999999999997 * inverse_D2_p3 - s4 *
      (inverse_D3_p53 - inverse_D3_p42)) - inverse_D3_p59 * inverse_D2_p6;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p99 = c17 * Lambda_11_11_p87 + s17 * Lambda_11_11_p71_lanes[1];

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p9 = 0.02999999505 + inverse_D2_p8;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p100 = c17 * Lambda_11_11_p71_lanes[1] - s17 * Lambda_11_11_p87;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p10 = 8.419374554 + (inverse_D3_p61 - inverse_D3_p59 * inverse_D2_p7);

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p101 = c17 * Lambda_11_11_p89 + s17 * Lambda_11_11_p75_lanes[1];
  const Real Lambda_11_11_p102 = c17 * Lambda_11_11_p75_lanes[1] - s17 * Lambda_11_11_p89;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p103_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_11_11_p91_lanes + detail::make_pack<Real>(c8, c15) * Lambda_11_11_p78;
  const Lanes<2> Lambda_11_11_p105_lanes = detail::make_pack<Real>(s8, s15) * Lambda_11_11_p78 -
      detail::make_pack<Real>(c8, c15) * Lambda_11_11_p91_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p62 = 1.7947593951550056 + 0.21799999999999997 *
      (inverse_D3_p58 + inverse_D3_p61) - inverse_D3_p59 * inverse_D3_p60 +
      (0.03561389675370483 + (inverse_D4_p12 - inverse_D4_p16)) * s4 * s4;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p107 = c18 * Lambda_11_11_p99 + s18 * Lambda_11_11_p88;
  const Real Lambda_11_11_p108 = c18 * Lambda_11_11_p88 - s18 * Lambda_11_11_p99;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / inverse_D3_p62;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p109 = c18 * Lambda_11_11_p101 + s18 * Lambda_11_11_p90;
  const Real Lambda_11_11_p110 = c18 * Lambda_11_11_p90 - s18 * Lambda_11_11_p101;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p111 = s16 * Lambda_11_11_p103_lanes[1] + c16 * Lambda_11_11_p93_lanes[1];
  const Real Lambda_11_11_p112 = c16 * Lambda_11_11_p103_lanes[1] - s16 * Lambda_11_11_p93_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p113 = c19 * Lambda_11_11_p100 - s19 * Lambda_11_11_p107;
  const Real Lambda_11_11_p114 = c19 * Lambda_11_11_p107 + s19 * Lambda_11_11_p100;
  const Real Lambda_11_11_p115 = c19 * Lambda_11_11_p102 - s19 * Lambda_11_11_p109;
  const Real Lambda_11_11_p116 = c19 * Lambda_11_11_p109 + s19 * Lambda_11_11_p102;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p117 = c17 * Lambda_11_11_p111 + s17 * Lambda_11_11_p105_lanes[1];
  const Real Lambda_11_11_p118 = c17 * Lambda_11_11_p105_lanes[1] - s17 * Lambda_11_11_p111;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p11 = inverse_D2_p9 * inverse_D3;
  const Real inverse_D2_p12 = inverse_D2_p10 * inverse_D3;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_11_11_p119_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 1 (calf), articulated inertia
  const Real Lambda_11_11_p121 = Lambda_11_11_p67_lanes[1] * Lambda_11_11_p110 -
      Lambda_11_11_p69_lanes[1] * Lambda_11_11_p115;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p122 = c18 * Lambda_11_11_p117 + s18 * Lambda_11_11_p112;
  const Real Lambda_11_11_p123 = c18 * Lambda_11_11_p112 - s18 * Lambda_11_11_p117;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p13 = inverse_D2_p10 * inverse_D2_p11 -
      (inverse_D2_p3 - inverse_D2_p5 * inverse_D2_p6);
  const Real inverse_D2_p14 = inverse_D3_p57 - inverse_D2_p5 * inverse_D2_p7 - inverse_D2_p10 *
      inverse_D2_p12;
  const Real inverse_D2_p15 = inverse_D3_p37 + inverse_D3_p50 - inverse_D2_p4 * inverse_D2_p6 -
      inverse_D2_p9 * inverse_D2_p11;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p124 = c19 * Lambda_11_11_p118 - s19 * Lambda_11_11_p122;
  const Real Lambda_11_11_p125 = c19 * Lambda_11_11_p122 + s19 * Lambda_11_11_p118;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p134_lanes = inverse_D10_p10_lanes[1] *
      detail::make_pack<Real>(Lambda_11_11_p125, Lambda_11_11_p125, Lambda_11_11_p114,
      Lambda_11_11_p116, Lambda_11_11_p125, Lambda_11_11_p125, Lambda_11_11_p125,
      Lambda_11_11_p125);
  const Lanes<8> Lambda_11_11_p140_lanes = detail::make_pack<Real>(-(Lambda_11_11_p67_lanes[1] *
      Lambda_11_11_p116), Lambda_11_11_p123, Lambda_11_11_p108, Lambda_11_11_p110,
      -(Lambda_11_11_p67_lanes[1] * Lambda_11_11_p116),
      -(Lambda_11_11_p67_lanes[1] * Lambda_11_11_p116),
      -(Lambda_11_11_p67_lanes[1] * Lambda_11_11_p116),
      -(Lambda_11_11_p67_lanes[1] * Lambda_11_11_p116)) + inverse_D12_p7_lanes[1] *
      detail::make_pack<Real>(Lambda_11_11_p121, Lambda_11_11_p125, Lambda_11_11_p114,
      Lambda_11_11_p116, Lambda_11_11_p121, Lambda_11_11_p121, Lambda_11_11_p121,
      Lambda_11_11_p121);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p148_lanes = -(inverse_D10_p11_lanes[1] *
      detail::make_pack<Real>(Lambda_11_11_p125, Lambda_11_11_p125, Lambda_11_11_p114,
      Lambda_11_11_p116, Lambda_11_11_p125, Lambda_11_11_p125, Lambda_11_11_p125,
      Lambda_11_11_p125));

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p16 = Lambda_11_11_p1 * (inverse_D2_p14 - inverse_D2_p15) +
      Lambda_11_11_p2 * (2.0 * inverse_D2_p13);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p159_lanes = inverse_D10_p23_lanes[1] * Lambda_11_11_p140_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = Lambda_11_11_p1 * inverse_D2_p16;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p166_lanes = detail::make_pack<Real>(Lambda_11_11_p115 +
      inverse_D10_p10_lanes[1] * Lambda_11_11_p121, Lambda_11_11_p134_lanes[1],
      Lambda_11_11_p134_lanes[2], Lambda_11_11_p134_lanes[3], Lambda_11_11_p115 +
      inverse_D10_p10_lanes[1] * Lambda_11_11_p121, Lambda_11_11_p115 + inverse_D10_p10_lanes[1] *
      Lambda_11_11_p121, Lambda_11_11_p115 + inverse_D10_p10_lanes[1] * Lambda_11_11_p121,
      Lambda_11_11_p115 + inverse_D10_p10_lanes[1] * Lambda_11_11_p121) - inverse_D10_p22_lanes[1] *
      Lambda_11_11_p140_lanes;
  const Real Lambda_11_11_p170 = Lambda_11_11_p116 + inverse_D10_p23_lanes[1] *
      Lambda_11_11_p140_lanes[0];
  const Lanes<8> Lambda_11_11_p171_lanes = detail::make_pack<Real>(Lambda_11_11_p69_lanes[1] *
      Lambda_11_11_p116, Lambda_11_11_p124, Lambda_11_11_p113, Lambda_11_11_p115,
      Lambda_11_11_p69_lanes[1] * Lambda_11_11_p116, Lambda_11_11_p69_lanes[1] * Lambda_11_11_p116,
      Lambda_11_11_p69_lanes[1] * Lambda_11_11_p116, Lambda_11_11_p69_lanes[1] *
      Lambda_11_11_p116) + inverse_D11_p5_lanes[1] * detail::make_pack<Real>(Lambda_11_11_p121,
      Lambda_11_11_p125, Lambda_11_11_p114, Lambda_11_11_p116, Lambda_11_11_p121, Lambda_11_11_p121,
      Lambda_11_11_p121, Lambda_11_11_p121) - inverse_D11_p13_lanes[1] * Lambda_11_11_p140_lanes;
  const Lanes<8> Lambda_11_11_p175_lanes = detail::make_pack<Real>(Lambda_11_11_p110 -
      inverse_D10_p11_lanes[1] * Lambda_11_11_p121, Lambda_11_11_p148_lanes[1],
      Lambda_11_11_p148_lanes[2], Lambda_11_11_p148_lanes[3], Lambda_11_11_p110 -
      inverse_D10_p11_lanes[1] * Lambda_11_11_p121, Lambda_11_11_p110 - inverse_D10_p11_lanes[1] *
      Lambda_11_11_p121, Lambda_11_11_p110 - inverse_D10_p11_lanes[1] * Lambda_11_11_p121,
      Lambda_11_11_p110 - inverse_D10_p11_lanes[1] * Lambda_11_11_p121) - inverse_D10_p24_lanes[1] *
      Lambda_11_11_p140_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p18 = Lambda_11_11_p2 * inverse_D2_p16 - inverse_D2_p13;
  const Real inverse_D2_p19 = inverse_D2_p14 - inverse_D2_p17;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p207_lanes = s19 * Lambda_11_11_p166_lanes - c19 *
      detail::make_pack<Real>(Lambda_11_11_p170, Lambda_11_11_p159_lanes[1],
      Lambda_11_11_p159_lanes[2], Lambda_11_11_p159_lanes[3], Lambda_11_11_p170, Lambda_11_11_p170,
      Lambda_11_11_p170, Lambda_11_11_p170);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p211_lanes = -(c19 * Lambda_11_11_p171_lanes);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = inverse_D2_p1 * inverse_D2_p19 + inverse_D2_p2 * inverse_D2_p18;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p251_lanes = 0.269 * Lambda_11_11_p175_lanes - s19 *
      Lambda_11_11_p171_lanes - inverse_D10_p77_lanes[1] * Lambda_11_11_p211_lanes;
  const Lanes<8> Lambda_11_11_p255_lanes = -Lambda_11_11_p207_lanes + inverse_D8_p16_lanes[1] *
      Lambda_11_11_p211_lanes;
  const Lanes<8> Lambda_11_11_p263_lanes = Lambda_11_11_p175_lanes - inverse_D8_p17_lanes[1] *
      Lambda_11_11_p211_lanes;
  const Lanes<8> Lambda_11_11_p267_lanes = -(s19 * detail::make_pack<Real>(Lambda_11_11_p170,
      Lambda_11_11_p159_lanes[1], Lambda_11_11_p159_lanes[2], Lambda_11_11_p159_lanes[3],
      Lambda_11_11_p170, Lambda_11_11_p170, Lambda_11_11_p170, Lambda_11_11_p170) + c19 *
      Lambda_11_11_p166_lanes) - inverse_D8_p18_lanes[1] * Lambda_11_11_p211_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = inverse_D2_p20 - (0.031999971599999996 * s2 - 24.5839218 * c2);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p271_lanes = 0.269 * Lambda_11_11_p207_lanes -
      inverse_D10_p78_lanes[1] * Lambda_11_11_p211_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = 9.885744550888212 + (inverse_D2_p2 *
      (inverse_D2_p1 * inverse_D2_p18 + inverse_D2_p2 * (inverse_D2_p15 + inverse_D2_p17)) +
      inverse_D2_p1 * inverse_D2_p20);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p319_lanes = s18 * Lambda_11_11_p251_lanes + c18 *
      Lambda_11_11_p271_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / inverse_D2_p21;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p339_lanes = inverse_D9_p7_lanes[1] * Lambda_11_11_p319_lanes;
  const Lanes<8> Lambda_11_11_p347_lanes = c18 * Lambda_11_11_p251_lanes - s18 *
      Lambda_11_11_p271_lanes - inverse_D9_p9_lanes[1] * Lambda_11_11_p319_lanes;
  const Lanes<8> Lambda_11_11_p351_lanes = -Lambda_11_11_p267_lanes - inverse_D8_p81_lanes[1] *
      Lambda_11_11_p319_lanes;
  const Lanes<8> Lambda_11_11_p355_lanes = c18 * Lambda_11_11_p255_lanes - s18 *
      Lambda_11_11_p263_lanes - inverse_D8_p80_lanes[1] * Lambda_11_11_p319_lanes;
  const Lanes<8> Lambda_11_11_p367_lanes = s18 * Lambda_11_11_p255_lanes + c18 *
      Lambda_11_11_p263_lanes - inverse_D8_p82_lanes[1] * Lambda_11_11_p319_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p399_lanes = c17 * Lambda_11_11_p339_lanes - s17 *
      Lambda_11_11_p347_lanes;
  const Lanes<8> Lambda_11_11_p403_lanes = s17 * Lambda_11_11_p351_lanes - c17 *
      Lambda_11_11_p355_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p415_lanes = inverse_D8_p149_lanes[1] * Lambda_11_11_p399_lanes;
  const Lanes<8> Lambda_11_11_p451_lanes = c17 * Lambda_11_11_p347_lanes + s17 *
      Lambda_11_11_p339_lanes + 0.282 * Lambda_11_11_p367_lanes - Lambda_11_11_p415_lanes;
  const Lanes<8> Lambda_11_11_p455_lanes = 0.282 * Lambda_11_11_p403_lanes -
      inverse_D8_p150_lanes[1] * Lambda_11_11_p399_lanes;
  const Lanes<8> Lambda_11_11_p459_lanes = -Lambda_11_11_p403_lanes + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p399_lanes;
  const Lanes<8> Lambda_11_11_p463_lanes = Lambda_11_11_p367_lanes - inverse_D6_p33_lanes[1] *
      Lambda_11_11_p399_lanes;
  const Lanes<8> Lambda_11_11_p467_lanes = -(s17 * Lambda_11_11_p355_lanes + c17 *
      Lambda_11_11_p351_lanes) + inverse_D6_p35_lanes[1] * Lambda_11_11_p399_lanes;
  const Lanes<8> Lambda_11_11_p507_lanes = c16 * Lambda_11_11_p451_lanes - s16 *
      Lambda_11_11_p455_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p527_lanes = Lambda_11_11_p119_lanes[1] * Lambda_11_11_p507_lanes;
  const Lanes<8> Lambda_11_11_p543_lanes = s16 * Lambda_11_11_p451_lanes + c16 *
      Lambda_11_11_p455_lanes - inverse_D7_p8_lanes[1] * Lambda_11_11_p507_lanes;
  const Lanes<8> Lambda_11_11_p551_lanes = s16 * Lambda_11_11_p459_lanes + c16 *
      Lambda_11_11_p463_lanes - inverse_D6_p163_lanes[1] * Lambda_11_11_p507_lanes;
  const Lanes<8> Lambda_11_11_p555_lanes = -Lambda_11_11_p467_lanes + inverse_D6_p161_lanes[1] *
      Lambda_11_11_p507_lanes;

  // link 1 (calf), articulated inertia
  const Real Lambda_11_11_p591 = Lambda_11_11_p67_lanes[1] * Lambda_11_11_p108 -
      Lambda_11_11_p69_lanes[1] * Lambda_11_11_p113;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p592_lanes = s15 * Lambda_11_11_p527_lanes + c15 *
      Lambda_11_11_p543_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p608_lanes = inverse_D6_p294_lanes[1] * Lambda_11_11_p592_lanes;

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D2_p19 - inverse_D1_p1 * inverse_D1_p2));

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p624_lanes = Lambda_11_11_p3_lanes[1] * Lambda_11_11_p592_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p628 = -(Lambda_11_11_p67_lanes[1] * Lambda_11_11_p114) +
      inverse_D12_p7_lanes[1] * Lambda_11_11_p591;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p629_lanes = c16 * Lambda_11_11_p459_lanes - s16 *
      Lambda_11_11_p463_lanes - inverse_D6_p165_lanes[1] * Lambda_11_11_p507_lanes -
      Lambda_11_11_p608_lanes;
  const Lanes<8> Lambda_11_11_p633_lanes = c15 * Lambda_11_11_p555_lanes - s15 *
      Lambda_11_11_p551_lanes - inverse_D6_p292_lanes[1] * Lambda_11_11_p592_lanes;
  const Lanes<8> Lambda_11_11_p637_lanes = c15 * Lambda_11_11_p527_lanes - s15 *
      Lambda_11_11_p543_lanes - inverse_D6_p332_lanes[1] * Lambda_11_11_p592_lanes;
  const Lanes<8> Lambda_11_11_p641_lanes = s15 * Lambda_11_11_p555_lanes + c15 *
      Lambda_11_11_p551_lanes - inverse_D6_p299_lanes[1] * Lambda_11_11_p592_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p681 = Lambda_11_11_p113 + inverse_D10_p10_lanes[1] * Lambda_11_11_p591 -
      inverse_D10_p22_lanes[1] * Lambda_11_11_p628;
  const Real Lambda_11_11_p682 = Lambda_11_11_p114 + inverse_D10_p23_lanes[1] * Lambda_11_11_p628;
  const Real Lambda_11_11_p683 = Lambda_11_11_p69_lanes[1] * Lambda_11_11_p114 +
      inverse_D11_p5_lanes[1] * Lambda_11_11_p591 - inverse_D11_p13_lanes[1] * Lambda_11_11_p628;
  const Real Lambda_11_11_p684 = Lambda_11_11_p108 - inverse_D10_p11_lanes[1] * Lambda_11_11_p591 -
      inverse_D10_p24_lanes[1] * Lambda_11_11_p628;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p685_lanes = s14 * Lambda_11_11_p629_lanes + c14 *
      Lambda_11_11_p633_lanes;
  const Lanes<8> Lambda_11_11_p693_lanes = c14 * Lambda_11_11_p629_lanes - s14 *
      Lambda_11_11_p633_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p705 = s19 * Lambda_11_11_p681 - c19 * Lambda_11_11_p682;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p706 = -(c19 * Lambda_11_11_p683);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p707_lanes = 0.226 * Lambda_11_11_p641_lanes + (-0.18) *
      Lambda_11_11_p685_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p719 = 0.269 * Lambda_11_11_p684 - s19 * Lambda_11_11_p683 -
      inverse_D10_p77_lanes[1] * Lambda_11_11_p706;
  const Real Lambda_11_11_p720 = -Lambda_11_11_p705 + inverse_D8_p16_lanes[1] * Lambda_11_11_p706;
  const Real Lambda_11_11_p721 = Lambda_11_11_p684 - inverse_D8_p17_lanes[1] * Lambda_11_11_p706;
  const Real Lambda_11_11_p730 = 0.269 * Lambda_11_11_p705 - inverse_D10_p78_lanes[1] *
      Lambda_11_11_p706;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p731_lanes = -(c14 * Lambda_11_11_p624_lanes + s14 *
      Lambda_11_11_p637_lanes + Lambda_11_11_p707_lanes);
  const Lanes<8> Lambda_11_11_p735_lanes = inverse_D5_p73 * Lambda_11_11_p731_lanes;

  // link 1 (calf), articulated inertia
  const Real Lambda_11_11_p755 = Lambda_11_11_p67_lanes[1] * Lambda_11_11_p123 -
      Lambda_11_11_p69_lanes[1] * Lambda_11_11_p124;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p756_lanes = (-0.18) * Lambda_11_11_p693_lanes -
      (s14 * Lambda_11_11_p624_lanes - c14 * Lambda_11_11_p637_lanes) - Lambda_11_11_p735_lanes;
  const Lanes<8> Lambda_11_11_p760_lanes = 0.226 * Lambda_11_11_p693_lanes - inverse_D5_p72 *
      Lambda_11_11_p731_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p764 = s18 * Lambda_11_11_p719 + c18 * Lambda_11_11_p730;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p765_lanes = Lambda_11_11_p693_lanes - inverse_D5_p71 *
      Lambda_11_11_p731_lanes;
  const Lanes<8> Lambda_11_11_p769_lanes = Lambda_11_11_p685_lanes + inverse_D3_p14 *
      Lambda_11_11_p731_lanes;
  const Lanes<8> Lambda_11_11_p773_lanes = Lambda_11_11_p641_lanes - inverse_D3_p15 *
      Lambda_11_11_p731_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p777 = inverse_D9_p7_lanes[1] * Lambda_11_11_p764;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p806 = -(Lambda_11_11_p67_lanes[1] * Lambda_11_11_p125) +
      inverse_D12_p7_lanes[1] * Lambda_11_11_p755;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p807 = c18 * Lambda_11_11_p719 - s18 * Lambda_11_11_p730 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p764;
  const Real Lambda_11_11_p808 = c18 * Lambda_11_11_p720 - s18 * Lambda_11_11_p721 -
      inverse_D8_p80_lanes[1] * Lambda_11_11_p764;
  const Real Lambda_11_11_p809 = -(-(s19 * Lambda_11_11_p682 + c19 * Lambda_11_11_p681) -
      inverse_D8_p18_lanes[1] * Lambda_11_11_p706) - inverse_D8_p81_lanes[1] * Lambda_11_11_p764;
  const Real Lambda_11_11_p810 = s18 * Lambda_11_11_p720 + c18 * Lambda_11_11_p721 -
      inverse_D8_p82_lanes[1] * Lambda_11_11_p764;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p819_lanes = s6 * Lambda_11_11_p756_lanes + c6 *
      Lambda_11_11_p760_lanes + 0.072 * Lambda_11_11_p765_lanes;
  const Lanes<8> Lambda_11_11_p831_lanes = s6 * Lambda_11_11_p769_lanes + c6 *
      Lambda_11_11_p773_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p835 = Lambda_11_11_p124 + inverse_D10_p10_lanes[1] * Lambda_11_11_p755 -
      inverse_D10_p22_lanes[1] * Lambda_11_11_p806;
  const Real Lambda_11_11_p836 = Lambda_11_11_p125 + inverse_D10_p23_lanes[1] * Lambda_11_11_p806;
  const Real Lambda_11_11_p837 = Lambda_11_11_p69_lanes[1] * Lambda_11_11_p125 +
      inverse_D11_p5_lanes[1] * Lambda_11_11_p755 - inverse_D11_p13_lanes[1] * Lambda_11_11_p806;
  const Real Lambda_11_11_p838 = Lambda_11_11_p123 - inverse_D10_p11_lanes[1] * Lambda_11_11_p755 -
      inverse_D10_p24_lanes[1] * Lambda_11_11_p806;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p839 = c17 * Lambda_11_11_p777 - s17 * Lambda_11_11_p807;
  const Real Lambda_11_11_p840 = s17 * Lambda_11_11_p809 - c17 * Lambda_11_11_p808;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p861_lanes = c6 * Lambda_11_11_p769_lanes - s6 *
      Lambda_11_11_p773_lanes - inverse_D3_p35 * Lambda_11_11_p819_lanes;
  const Lanes<8> Lambda_11_11_p865_lanes = Lambda_11_11_p765_lanes - inverse_D3_p34 *
      Lambda_11_11_p819_lanes;
  const Lanes<8> Lambda_11_11_p881_lanes = -(0.072 * Lambda_11_11_p831_lanes) + inverse_D4_p10 *
      Lambda_11_11_p819_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p885 = s19 * Lambda_11_11_p835 - c19 * Lambda_11_11_p836;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p892 = -(c19 * Lambda_11_11_p837);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p905 = c17 * Lambda_11_11_p807 + s17 * Lambda_11_11_p777 + 0.282 *
      Lambda_11_11_p810 - inverse_D8_p149_lanes[1] * Lambda_11_11_p839;

  // link 9 (left_upperarm), pose
  const Lanes<8> Lambda_11_11_p906_lanes = s9 * detail::make_pack<Real>(Lambda_11_11_p103_lanes[0],
      Lambda_11_11_p65_lanes[0], Lambda_11_11_p73_lanes[0], Lambda_11_11_p103_lanes[0],
      Lambda_11_11_p103_lanes[0], Lambda_11_11_p103_lanes[0], Lambda_11_11_p103_lanes[0],
      Lambda_11_11_p103_lanes[0]) + c9 * detail::make_pack<Real>(Lambda_11_11_p93_lanes[0],
      Lambda_11_11_p45_lanes[0], Lambda_11_11_p49_lanes[0], Lambda_11_11_p93_lanes[0],
      Lambda_11_11_p93_lanes[0], Lambda_11_11_p93_lanes[0], Lambda_11_11_p93_lanes[0],
      Lambda_11_11_p93_lanes[0]);

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p909 = 0.269 * Lambda_11_11_p838 - s19 * Lambda_11_11_p837 -
      inverse_D10_p77_lanes[1] * Lambda_11_11_p892;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p910 = 0.282 * Lambda_11_11_p840 - inverse_D8_p150_lanes[1] *
      Lambda_11_11_p839;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p919_lanes = c6 * Lambda_11_11_p756_lanes - s6 *
      Lambda_11_11_p760_lanes - inverse_D4_p11 * Lambda_11_11_p819_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<8> Lambda_11_11_p931_lanes = c9 * detail::make_pack<Real>(Lambda_11_11_p103_lanes[0],
      Lambda_11_11_p65_lanes[0], Lambda_11_11_p73_lanes[0], Lambda_11_11_p103_lanes[0],
      Lambda_11_11_p103_lanes[0], Lambda_11_11_p103_lanes[0], Lambda_11_11_p103_lanes[0],
      Lambda_11_11_p103_lanes[0]) - s9 * detail::make_pack<Real>(Lambda_11_11_p93_lanes[0],
      Lambda_11_11_p45_lanes[0], Lambda_11_11_p49_lanes[0], Lambda_11_11_p93_lanes[0],
      Lambda_11_11_p93_lanes[0], Lambda_11_11_p93_lanes[0], Lambda_11_11_p93_lanes[0],
      Lambda_11_11_p93_lanes[0]);

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p934 = -Lambda_11_11_p885 + inverse_D8_p16_lanes[1] * Lambda_11_11_p892;
  const Real Lambda_11_11_p935 = Lambda_11_11_p838 - inverse_D8_p17_lanes[1] * Lambda_11_11_p892;
  const Real Lambda_11_11_p942 = 0.269 * Lambda_11_11_p885 - inverse_D10_p78_lanes[1] *
      Lambda_11_11_p892;

  // link 10 (left_lowerarm), pose
  const Lanes<8> Lambda_11_11_p949_lanes = c10 * Lambda_11_11_p906_lanes + s10 *
      detail::make_pack<Real>(Lambda_11_11_p105_lanes[0], Lambda_11_11_p71_lanes[0],
      Lambda_11_11_p75_lanes[0], Lambda_11_11_p105_lanes[0], Lambda_11_11_p105_lanes[0],
      Lambda_11_11_p105_lanes[0], Lambda_11_11_p105_lanes[0], Lambda_11_11_p105_lanes[0]);
  const Lanes<8> Lambda_11_11_p952_lanes = c10 * detail::make_pack<Real>(Lambda_11_11_p105_lanes[0],
      Lambda_11_11_p71_lanes[0], Lambda_11_11_p75_lanes[0], Lambda_11_11_p105_lanes[0],
      Lambda_11_11_p105_lanes[0], Lambda_11_11_p105_lanes[0], Lambda_11_11_p105_lanes[0],
      Lambda_11_11_p105_lanes[0]) - s10 * Lambda_11_11_p906_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p959 = c16 * Lambda_11_11_p905 - s16 * Lambda_11_11_p910;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p964_lanes = s4 * (Lambda_11_11_p831_lanes - inverse_D3_p36 *
      Lambda_11_11_p819_lanes);

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p996 = s18 * Lambda_11_11_p909 + c18 * Lambda_11_11_p942;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p997 = Lambda_11_11_p119_lanes[1] * Lambda_11_11_p959;

  // link 11 (left_wrist1), pose
  const Lanes<8> Lambda_11_11_p1014_lanes = c11 * Lambda_11_11_p949_lanes + s11 *
      Lambda_11_11_p931_lanes;
  const Lanes<8> Lambda_11_11_p1017_lanes = c11 * Lambda_11_11_p931_lanes - s11 *
      Lambda_11_11_p949_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1020 = inverse_D9_p7_lanes[1] * Lambda_11_11_p996;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1021 = s16 * Lambda_11_11_p905 + c16 * Lambda_11_11_p910 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p959;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1022_lanes = c4 * (s5 * Lambda_11_11_p861_lanes - c5 *
      Lambda_11_11_p865_lanes) + Lambda_11_11_p964_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1030_lanes = -(s5 * Lambda_11_11_p881_lanes + c5 *
      Lambda_11_11_p919_lanes);

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1051 = c18 * Lambda_11_11_p909 - s18 * Lambda_11_11_p942 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p996;
  const Real Lambda_11_11_p1052 = c18 * Lambda_11_11_p934 - s18 * Lambda_11_11_p935 -
      inverse_D8_p80_lanes[1] * Lambda_11_11_p996;
  const Real Lambda_11_11_p1057 = -(-(s19 * Lambda_11_11_p836 + c19 * Lambda_11_11_p835) -
      inverse_D8_p18_lanes[1] * Lambda_11_11_p892) - inverse_D8_p81_lanes[1] * Lambda_11_11_p996;
  const Real Lambda_11_11_p1058 = s18 * Lambda_11_11_p934 + c18 * Lambda_11_11_p935 -
      inverse_D8_p82_lanes[1] * Lambda_11_11_p996;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_11_11_p1071_lanes = c12 * Lambda_11_11_p952_lanes - s12 *
      Lambda_11_11_p1014_lanes;
  const Lanes<8> Lambda_11_11_p1074_lanes = c12 * Lambda_11_11_p1014_lanes + s12 *
      Lambda_11_11_p952_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1077 = s15 * Lambda_11_11_p997 + c15 * Lambda_11_11_p1021;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1082_lanes = -(s5 * Lambda_11_11_p865_lanes + c5 *
      Lambda_11_11_p861_lanes) - inverse_D2_p6 * Lambda_11_11_p1030_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_11_11_p1092_lanes = Lambda_11_11_p69_lanes[0] * Lambda_11_11_p1074_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1095 = c17 * Lambda_11_11_p1020 - s17 * Lambda_11_11_p1051;
  const Real Lambda_11_11_p1096 = s17 * Lambda_11_11_p1057 - c17 * Lambda_11_11_p1052;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1097_lanes = s4 * (s5 * Lambda_11_11_p919_lanes - c5 *
      Lambda_11_11_p881_lanes) + 0.21799999999999997 * Lambda_11_11_p1022_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_11_11_p1105_lanes = Lambda_11_11_p67_lanes[0] * Lambda_11_11_p1017_lanes -
      Lambda_11_11_p69_lanes[0] * Lambda_11_11_p1071_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p1108_lanes = -(Lambda_11_11_p67_lanes[0] * Lambda_11_11_p1074_lanes);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1115_lanes = -Lambda_11_11_p1097_lanes - inverse_D3_p60 *
      Lambda_11_11_p1030_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1137 = c17 * Lambda_11_11_p1051 + s17 * Lambda_11_11_p1020 + 0.282 *
      Lambda_11_11_p1058 - inverse_D8_p149_lanes[1] * Lambda_11_11_p1095;
  const Real Lambda_11_11_p1138 = 0.282 * Lambda_11_11_p1096 - inverse_D8_p150_lanes[1] *
      Lambda_11_11_p1095;
  const Real Lambda_11_11_p1147 = -Lambda_11_11_p840 + inverse_D6_p31_lanes[1] * Lambda_11_11_p839;
  const Real Lambda_11_11_p1148 = Lambda_11_11_p810 - inverse_D6_p33_lanes[1] * Lambda_11_11_p839;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p1149_lanes = detail::make_pack<Real>(Lambda_11_11_p1108_lanes[0],
      Lambda_11_11_p1108_lanes[1], Lambda_11_11_p1108_lanes[2], Lambda_11_11_p1017_lanes[0],
      Lambda_11_11_p1017_lanes[1], Lambda_11_11_p1017_lanes[2], Lambda_11_11_p1108_lanes[0],
      Lambda_11_11_p1108_lanes[0]) + inverse_D12_p7_lanes[0] *
      detail::make_pack<Real>(Lambda_11_11_p1105_lanes[0], Lambda_11_11_p1105_lanes[1],
      Lambda_11_11_p1105_lanes[2], Lambda_11_11_p1074_lanes[0], Lambda_11_11_p1074_lanes[1],
      Lambda_11_11_p1074_lanes[2], Lambda_11_11_p1105_lanes[0], Lambda_11_11_p1105_lanes[0]);
  const Lanes<8> Lambda_11_11_p1155_lanes = Lambda_11_11_p1071_lanes + inverse_D10_p10_lanes[0] *
      Lambda_11_11_p1105_lanes;
  const Lanes<8> Lambda_11_11_p1164_lanes = Lambda_11_11_p1017_lanes - inverse_D10_p11_lanes[0] *
      Lambda_11_11_p1105_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1167 = -Lambda_11_11_p1096 + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p1095;
  const Real Lambda_11_11_p1168 = Lambda_11_11_p1058 - inverse_D6_p33_lanes[1] * Lambda_11_11_p1095;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1184_lanes = inverse_D10_p23_lanes[0] * Lambda_11_11_p1149_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1193 = c16 * Lambda_11_11_p1137 - s16 * Lambda_11_11_p1138;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1194_lanes = detail::make_pack<Real>(Lambda_11_11_p1155_lanes[0],
      Lambda_11_11_p1155_lanes[1], Lambda_11_11_p1155_lanes[2], inverse_D10_p10_lanes[0] *
      Lambda_11_11_p1074_lanes[0], inverse_D10_p10_lanes[0] * Lambda_11_11_p1074_lanes[1],
      inverse_D10_p10_lanes[0] * Lambda_11_11_p1074_lanes[2], Lambda_11_11_p1155_lanes[0],
      Lambda_11_11_p1155_lanes[0]) - inverse_D10_p22_lanes[0] * Lambda_11_11_p1149_lanes;
  const Lanes<8> Lambda_11_11_p1200_lanes = Lambda_11_11_p1074_lanes + inverse_D10_p23_lanes[0] *
      Lambda_11_11_p1149_lanes;
  const Lanes<8> Lambda_11_11_p1203_lanes = detail::make_pack<Real>(Lambda_11_11_p1092_lanes[0],
      Lambda_11_11_p1092_lanes[1], Lambda_11_11_p1092_lanes[2], Lambda_11_11_p1071_lanes[0],
      Lambda_11_11_p1071_lanes[1], Lambda_11_11_p1071_lanes[2], Lambda_11_11_p1092_lanes[0],
      Lambda_11_11_p1092_lanes[0]) + inverse_D11_p5_lanes[0] *
      detail::make_pack<Real>(Lambda_11_11_p1105_lanes[0], Lambda_11_11_p1105_lanes[1],
      Lambda_11_11_p1105_lanes[2], Lambda_11_11_p1074_lanes[0], Lambda_11_11_p1074_lanes[1],
      Lambda_11_11_p1074_lanes[2], Lambda_11_11_p1105_lanes[0], Lambda_11_11_p1105_lanes[0]) -
      inverse_D11_p13_lanes[0] * Lambda_11_11_p1149_lanes;
  const Lanes<8> Lambda_11_11_p1209_lanes = detail::make_pack<Real>(Lambda_11_11_p1164_lanes[0],
      Lambda_11_11_p1164_lanes[1], Lambda_11_11_p1164_lanes[2],
      -(inverse_D10_p11_lanes[0] * Lambda_11_11_p1074_lanes[0]),
      -(inverse_D10_p11_lanes[0] * Lambda_11_11_p1074_lanes[1]),
      -(inverse_D10_p11_lanes[0] * Lambda_11_11_p1074_lanes[2]), Lambda_11_11_p1164_lanes[0],
      Lambda_11_11_p1164_lanes[0]) - inverse_D10_p24_lanes[0] * Lambda_11_11_p1149_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1215 = Lambda_11_11_p119_lanes[1] * Lambda_11_11_p1193;
  const Real Lambda_11_11_p1258 = s16 * Lambda_11_11_p1137 + c16 * Lambda_11_11_p1138 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p1193;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1259_lanes = s12 * Lambda_11_11_p1194_lanes - c12 *
      detail::make_pack<Real>(Lambda_11_11_p1200_lanes[0], Lambda_11_11_p1200_lanes[1],
      Lambda_11_11_p1200_lanes[2], Lambda_11_11_p1184_lanes[3], Lambda_11_11_p1184_lanes[4],
      Lambda_11_11_p1184_lanes[5], Lambda_11_11_p1200_lanes[0], Lambda_11_11_p1200_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1265_lanes = -(c12 * Lambda_11_11_p1203_lanes);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1313 = s16 * Lambda_11_11_p1147 + c16 * Lambda_11_11_p1148 -
      inverse_D6_p163_lanes[1] * Lambda_11_11_p959;
  const Real Lambda_11_11_p1314 = -(-(s17 * Lambda_11_11_p808 + c17 * Lambda_11_11_p809) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p839) + inverse_D6_p161_lanes[1] * Lambda_11_11_p959;
  const Real Lambda_11_11_p1327 = s16 * Lambda_11_11_p1167 + c16 * Lambda_11_11_p1168 -
      inverse_D6_p163_lanes[1] * Lambda_11_11_p1193;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1328_lanes = 0.269 * Lambda_11_11_p1209_lanes - s12 *
      Lambda_11_11_p1203_lanes - inverse_D10_p77_lanes[0] * Lambda_11_11_p1265_lanes;
  const Lanes<8> Lambda_11_11_p1334_lanes = -Lambda_11_11_p1259_lanes + inverse_D8_p16_lanes[0] *
      Lambda_11_11_p1265_lanes;
  const Lanes<8> Lambda_11_11_p1346_lanes = Lambda_11_11_p1209_lanes - inverse_D8_p17_lanes[0] *
      Lambda_11_11_p1265_lanes;
  const Lanes<8> Lambda_11_11_p1352_lanes = -(s12 *
      detail::make_pack<Real>(Lambda_11_11_p1200_lanes[0], Lambda_11_11_p1200_lanes[1],
      Lambda_11_11_p1200_lanes[2], Lambda_11_11_p1184_lanes[3], Lambda_11_11_p1184_lanes[4],
      Lambda_11_11_p1184_lanes[5], Lambda_11_11_p1200_lanes[0], Lambda_11_11_p1200_lanes[0]) + c12 *
      Lambda_11_11_p1194_lanes) - inverse_D8_p18_lanes[0] * Lambda_11_11_p1265_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1358 = -(-(s17 * Lambda_11_11_p1052 + c17 * Lambda_11_11_p1057) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p1095) + inverse_D6_p161_lanes[1] * Lambda_11_11_p1193;
  const Real Lambda_11_11_p1359 = s15 * Lambda_11_11_p1215 + c15 * Lambda_11_11_p1258;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1360_lanes = 0.269 * Lambda_11_11_p1259_lanes -
      inverse_D10_p78_lanes[0] * Lambda_11_11_p1265_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1420_lanes = -Lambda_11_11_p1022_lanes - inverse_D2_p7 *
      Lambda_11_11_p1030_lanes - inverse_D2_p12 * Lambda_11_11_p1115_lanes;
  const Lanes<8> Lambda_11_11_p1436_lanes = -Lambda_11_11_p1082_lanes + inverse_D2_p11 *
      Lambda_11_11_p1115_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1440_lanes = s11 * Lambda_11_11_p1328_lanes + c11 *
      Lambda_11_11_p1360_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1486_lanes = inverse_D9_p7_lanes[0] * Lambda_11_11_p1440_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1502_lanes = Lambda_11_11_p2 * Lambda_11_11_p1420_lanes -
      Lambda_11_11_p1 * Lambda_11_11_p1436_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1506_lanes = c11 * Lambda_11_11_p1328_lanes - s11 *
      Lambda_11_11_p1360_lanes - inverse_D9_p9_lanes[0] * Lambda_11_11_p1440_lanes;
  const Lanes<8> Lambda_11_11_p1512_lanes = -Lambda_11_11_p1352_lanes - inverse_D8_p81_lanes[0] *
      Lambda_11_11_p1440_lanes;
  const Lanes<8> Lambda_11_11_p1518_lanes = c11 * Lambda_11_11_p1334_lanes - s11 *
      Lambda_11_11_p1346_lanes - inverse_D8_p80_lanes[0] * Lambda_11_11_p1440_lanes;
  const Lanes<8> Lambda_11_11_p1536_lanes = s11 * Lambda_11_11_p1334_lanes + c11 *
      Lambda_11_11_p1346_lanes - inverse_D8_p82_lanes[0] * Lambda_11_11_p1440_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1592_lanes = inverse_D2_p2 *
      (Lambda_11_11_p1 * Lambda_11_11_p1420_lanes + Lambda_11_11_p2 * Lambda_11_11_p1436_lanes) +
      inverse_D2_p1 * Lambda_11_11_p1502_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1596_lanes = c10 * Lambda_11_11_p1486_lanes - s10 *
      Lambda_11_11_p1506_lanes;
  const Lanes<8> Lambda_11_11_p1602_lanes = s10 * Lambda_11_11_p1512_lanes - c10 *
      Lambda_11_11_p1518_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1624_lanes = inverse_D8_p149_lanes[0] * Lambda_11_11_p1596_lanes;
  const Lanes<8> Lambda_11_11_p1682_lanes = c10 * Lambda_11_11_p1506_lanes + s10 *
      Lambda_11_11_p1486_lanes + 0.282 * Lambda_11_11_p1536_lanes - Lambda_11_11_p1624_lanes;
  const Lanes<8> Lambda_11_11_p1688_lanes = 0.282 * Lambda_11_11_p1602_lanes -
      inverse_D8_p150_lanes[0] * Lambda_11_11_p1596_lanes;
  const Lanes<8> Lambda_11_11_p1694_lanes = -Lambda_11_11_p1602_lanes + inverse_D6_p31_lanes[0] *
      Lambda_11_11_p1596_lanes;
  const Lanes<8> Lambda_11_11_p1700_lanes = Lambda_11_11_p1536_lanes - inverse_D6_p33_lanes[0] *
      Lambda_11_11_p1596_lanes;
  const Lanes<8> Lambda_11_11_p1706_lanes = -(s10 * Lambda_11_11_p1518_lanes + c10 *
      Lambda_11_11_p1512_lanes) + inverse_D6_p35_lanes[0] * Lambda_11_11_p1596_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p1712_lanes = 0.434 *
      (Lambda_11_11_p1502_lanes - inverse_D1_p2 * Lambda_11_11_p1592_lanes);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p1770_lanes = Lambda_11_11_p1712_lanes * inverse_D1;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1774_lanes = c9 * Lambda_11_11_p1682_lanes - s9 *
      Lambda_11_11_p1688_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p1804_lanes = Lambda_11_11_p119_lanes[0] * Lambda_11_11_p1774_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p1828_lanes = Lambda_11_11_p1592_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1832_lanes = Lambda_11_11_p1115_lanes * inverse_D3;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p1836_lanes = s9 * Lambda_11_11_p1682_lanes + c9 *
      Lambda_11_11_p1688_lanes - inverse_D7_p8_lanes[0] * Lambda_11_11_p1774_lanes;
  const Lanes<8> Lambda_11_11_p1848_lanes = s9 * Lambda_11_11_p1694_lanes + c9 *
      Lambda_11_11_p1700_lanes - inverse_D6_p163_lanes[0] * Lambda_11_11_p1774_lanes;
  const Lanes<8> Lambda_11_11_p1854_lanes = -Lambda_11_11_p1706_lanes + inverse_D6_p161_lanes[0] *
      Lambda_11_11_p1774_lanes;
  const Lanes<8> Lambda_11_11_p1860_lanes = c9 * Lambda_11_11_p1694_lanes - s9 *
      Lambda_11_11_p1700_lanes - inverse_D6_p165_lanes[0] * Lambda_11_11_p1774_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1872_lanes = Lambda_11_11_p819_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1876_lanes = Lambda_11_11_p731_lanes * inverse_D6;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1880_lanes = Lambda_11_11_p1030_lanes * inverse_D4;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p1920_lanes = s8 * Lambda_11_11_p1804_lanes + c8 *
      Lambda_11_11_p1836_lanes;
  const Lanes<8> Lambda_11_11_p1926_lanes = c8 * Lambda_11_11_p1854_lanes - s8 *
      Lambda_11_11_p1848_lanes;
  const Lanes<8> Lambda_11_11_p1932_lanes = s8 * Lambda_11_11_p1854_lanes + c8 *
      Lambda_11_11_p1848_lanes;
  const Lanes<8> Lambda_11_11_p1938_lanes = c8 * Lambda_11_11_p1804_lanes - s8 *
      Lambda_11_11_p1836_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1976_lanes = detail::make_pack<Real>(Lambda_11_11_p3_lanes[0],
      Lambda_11_11_p3_lanes[0], Lambda_11_11_p3_lanes[0], Lambda_11_11_p3_lanes[0],
      Lambda_11_11_p3_lanes[0], Lambda_11_11_p3_lanes[0], Lambda_11_11_p3_lanes[1],
      Lambda_11_11_p3_lanes[1]) * detail::make_pack<Real>(Lambda_11_11_p1920_lanes[0],
      Lambda_11_11_p1920_lanes[1], Lambda_11_11_p1920_lanes[2], Lambda_11_11_p1920_lanes[3],
      Lambda_11_11_p1920_lanes[4], Lambda_11_11_p1920_lanes[5], Lambda_11_11_p1359,
      Lambda_11_11_p1077);
  const Lanes<8> Lambda_11_11_p1984_lanes = detail::make_pack<Real>(Lambda_11_11_p1860_lanes[0],
      Lambda_11_11_p1860_lanes[1], Lambda_11_11_p1860_lanes[2], Lambda_11_11_p1860_lanes[3],
      Lambda_11_11_p1860_lanes[4], Lambda_11_11_p1860_lanes[5], c16 * Lambda_11_11_p1167 - s16 *
      Lambda_11_11_p1168 - inverse_D6_p165_lanes[1] * Lambda_11_11_p1193, c16 * Lambda_11_11_p1147 -
      s16 * Lambda_11_11_p1148 - inverse_D6_p165_lanes[1] * Lambda_11_11_p959) -
      detail::make_pack<Real>(inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[1], inverse_D6_p294_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p1920_lanes[0], Lambda_11_11_p1920_lanes[1],
      Lambda_11_11_p1920_lanes[2], Lambda_11_11_p1920_lanes[3], Lambda_11_11_p1920_lanes[4],
      Lambda_11_11_p1920_lanes[5], Lambda_11_11_p1359, Lambda_11_11_p1077);
  const Lanes<8> Lambda_11_11_p1992_lanes = detail::make_pack<Real>(Lambda_11_11_p1926_lanes[0],
      Lambda_11_11_p1926_lanes[1], Lambda_11_11_p1926_lanes[2], Lambda_11_11_p1926_lanes[3],
      Lambda_11_11_p1926_lanes[4], Lambda_11_11_p1926_lanes[5], c15 * Lambda_11_11_p1358 - s15 *
      Lambda_11_11_p1327, c15 * Lambda_11_11_p1314 - s15 * Lambda_11_11_p1313) -
      detail::make_pack<Real>(inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[1], inverse_D6_p292_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p1920_lanes[0], Lambda_11_11_p1920_lanes[1],
      Lambda_11_11_p1920_lanes[2], Lambda_11_11_p1920_lanes[3], Lambda_11_11_p1920_lanes[4],
      Lambda_11_11_p1920_lanes[5], Lambda_11_11_p1359, Lambda_11_11_p1077);
  const Lanes<8> Lambda_11_11_p2000_lanes = detail::make_pack<Real>(Lambda_11_11_p1932_lanes[0],
      Lambda_11_11_p1932_lanes[1], Lambda_11_11_p1932_lanes[2], Lambda_11_11_p1932_lanes[3],
      Lambda_11_11_p1932_lanes[4], Lambda_11_11_p1932_lanes[5], s15 * Lambda_11_11_p1358 + c15 *
      Lambda_11_11_p1327, s15 * Lambda_11_11_p1314 + c15 * Lambda_11_11_p1313) -
      detail::make_pack<Real>(inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[1], inverse_D6_p299_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p1920_lanes[0], Lambda_11_11_p1920_lanes[1],
      Lambda_11_11_p1920_lanes[2], Lambda_11_11_p1920_lanes[3], Lambda_11_11_p1920_lanes[4],
      Lambda_11_11_p1920_lanes[5], Lambda_11_11_p1359, Lambda_11_11_p1077);
  const Lanes<8> Lambda_11_11_p2008_lanes = detail::make_pack<Real>(Lambda_11_11_p1938_lanes[0],
      Lambda_11_11_p1938_lanes[1], Lambda_11_11_p1938_lanes[2], Lambda_11_11_p1938_lanes[3],
      Lambda_11_11_p1938_lanes[4], Lambda_11_11_p1938_lanes[5], c15 * Lambda_11_11_p1215 - s15 *
      Lambda_11_11_p1258, c15 * Lambda_11_11_p997 - s15 * Lambda_11_11_p1021) -
      detail::make_pack<Real>(inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[1], inverse_D6_p332_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p1920_lanes[0], Lambda_11_11_p1920_lanes[1],
      Lambda_11_11_p1920_lanes[2], Lambda_11_11_p1920_lanes[3], Lambda_11_11_p1920_lanes[4],
      Lambda_11_11_p1920_lanes[5], Lambda_11_11_p1359, Lambda_11_11_p1077);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p2032_lanes = Lambda_11_11_p1774_lanes * inverse_D8_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2038_lanes = Lambda_11_11_p1920_lanes * inverse_D7_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p2044_lanes = Lambda_11_11_p1596_lanes * inverse_D9_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2106_lanes = Lambda_11_11_p1149_lanes * inverse_D12_lanes[0];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p2112_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_11_11_p1105_lanes[0], Lambda_11_11_p1105_lanes[1],
      Lambda_11_11_p1105_lanes[2], Lambda_11_11_p1074_lanes[0], Lambda_11_11_p1074_lanes[1],
      Lambda_11_11_p1074_lanes[2], Lambda_11_11_p1105_lanes[0], Lambda_11_11_p1105_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p2118_lanes = Lambda_11_11_p1265_lanes * inverse_D11_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2124_lanes = Lambda_11_11_p1440_lanes * inverse_D10_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2148_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_11_11_p1984_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_11_11_p1992_lanes;
  const Lanes<8> Lambda_11_11_p2164_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p1984_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p1992_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2198_lanes = Lambda_11_11_p2124_lanes * Lambda_11_11_p1440_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2234_lanes = 0.226 * Lambda_11_11_p2000_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_11_11_p2148_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2264_lanes = Lambda_11_11_p2112_lanes * Lambda_11_11_p1105_lanes[0] +
      Lambda_11_11_p2106_lanes * Lambda_11_11_p1149_lanes[0] + Lambda_11_11_p2118_lanes *
      Lambda_11_11_p1265_lanes[0] + Lambda_11_11_p2198_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2270_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p1976_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p2008_lanes + Lambda_11_11_p2234_lanes);
  const Lanes<8> Lambda_11_11_p2278_lanes = inverse_D5_p73 * Lambda_11_11_p2270_lanes;
  const Lanes<8> Lambda_11_11_p2318_lanes = Lambda_11_11_p2270_lanes * inverse_D6;
  const Real Lambda_11_11_p2324 = Lambda_11_11_p2270_lanes[7] * inverse_D6;
  const Real Lambda_11_11_p2325 = Lambda_11_11_p2270_lanes[6] * inverse_D6;
  const Lanes<8> Lambda_11_11_p2340_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_11_11_p2164_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_11_11_p1976_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_11_11_p2008_lanes) -
      Lambda_11_11_p2278_lanes;
  const Lanes<8> Lambda_11_11_p2348_lanes = 0.226 * Lambda_11_11_p2164_lanes - inverse_D5_p72 *
      Lambda_11_11_p2270_lanes;
  const Lanes<8> Lambda_11_11_p2356_lanes = Lambda_11_11_p2164_lanes - inverse_D5_p71 *
      Lambda_11_11_p2270_lanes;
  const Lanes<8> Lambda_11_11_p2364_lanes = Lambda_11_11_p2148_lanes + inverse_D3_p14 *
      Lambda_11_11_p2270_lanes;
  const Lanes<8> Lambda_11_11_p2372_lanes = Lambda_11_11_p2000_lanes - inverse_D3_p15 *
      Lambda_11_11_p2270_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2479_lanes = Lambda_11_11_p2264_lanes + Lambda_11_11_p2044_lanes *
      Lambda_11_11_p1596_lanes[0] + Lambda_11_11_p2032_lanes * Lambda_11_11_p1774_lanes[0] +
      Lambda_11_11_p2038_lanes * Lambda_11_11_p1920_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2485_lanes = Lambda_11_11_p2124_lanes * Lambda_11_11_p1440_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2531_lanes = s6 * Lambda_11_11_p2364_lanes + c6 *
      Lambda_11_11_p2372_lanes;
  const Lanes<8> Lambda_11_11_p2539_lanes = Lambda_11_11_p2479_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p2270_lanes[0];
  const Lanes<8> Lambda_11_11_p2562_lanes = s6 * Lambda_11_11_p2340_lanes + c6 *
      Lambda_11_11_p2348_lanes + 0.072 * Lambda_11_11_p2356_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2578_lanes = Lambda_11_11_p2112_lanes * Lambda_11_11_p1105_lanes[1] +
      Lambda_11_11_p2106_lanes * Lambda_11_11_p1149_lanes[1] + Lambda_11_11_p2118_lanes *
      Lambda_11_11_p1265_lanes[1] + Lambda_11_11_p2485_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2623_lanes = Lambda_11_11_p2562_lanes * inverse_D5;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2668_lanes = Lambda_11_11_p2124_lanes * Lambda_11_11_p1440_lanes[2];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2680_lanes = c6 * Lambda_11_11_p2364_lanes - s6 *
      Lambda_11_11_p2372_lanes - inverse_D3_p35 * Lambda_11_11_p2562_lanes;
  const Lanes<8> Lambda_11_11_p2688_lanes = Lambda_11_11_p2356_lanes - inverse_D3_p34 *
      Lambda_11_11_p2562_lanes;
  const Lanes<8> Lambda_11_11_p2696_lanes = c6 * Lambda_11_11_p2340_lanes - s6 *
      Lambda_11_11_p2348_lanes - inverse_D4_p11 * Lambda_11_11_p2562_lanes;
  const Lanes<8> Lambda_11_11_p2704_lanes = -(0.072 * Lambda_11_11_p2531_lanes) + inverse_D4_p10 *
      Lambda_11_11_p2562_lanes;
  const Lanes<8> Lambda_11_11_p2782_lanes = s4 * (Lambda_11_11_p2531_lanes - inverse_D3_p36 *
      Lambda_11_11_p2562_lanes);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2830_lanes = Lambda_11_11_p2578_lanes + Lambda_11_11_p2044_lanes *
      Lambda_11_11_p1596_lanes[1] + Lambda_11_11_p2032_lanes * Lambda_11_11_p1774_lanes[1] +
      Lambda_11_11_p2038_lanes * Lambda_11_11_p1920_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2883_lanes = Lambda_11_11_p2830_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p2270_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2920_lanes = -(s5 * Lambda_11_11_p2704_lanes + c5 *
      Lambda_11_11_p2696_lanes);
  const Lanes<8> Lambda_11_11_p2952_lanes = Lambda_11_11_p2920_lanes * inverse_D4;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2975_lanes = Lambda_11_11_p2112_lanes * Lambda_11_11_p1105_lanes[2] +
      Lambda_11_11_p2106_lanes * Lambda_11_11_p1149_lanes[2] + Lambda_11_11_p2118_lanes *
      Lambda_11_11_p1265_lanes[2] + Lambda_11_11_p2668_lanes;
  const Lanes<8> Lambda_11_11_p2988_lanes = Lambda_11_11_p2124_lanes * Lambda_11_11_p1440_lanes[3];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2997_lanes = c4 * (s5 * Lambda_11_11_p2680_lanes - c5 *
      Lambda_11_11_p2688_lanes) + Lambda_11_11_p2782_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3016_lanes = -(s5 * Lambda_11_11_p2688_lanes + c5 *
      Lambda_11_11_p2680_lanes) - inverse_D2_p6 * Lambda_11_11_p2920_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p3140_lanes = s4 * (s5 * Lambda_11_11_p2696_lanes - c5 *
      Lambda_11_11_p2704_lanes) + 0.21799999999999997 * Lambda_11_11_p2997_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3148_lanes = Lambda_11_11_p2975_lanes + Lambda_11_11_p2044_lanes *
      Lambda_11_11_p1596_lanes[2] + Lambda_11_11_p2032_lanes * Lambda_11_11_p1774_lanes[2] +
      Lambda_11_11_p2038_lanes * Lambda_11_11_p1920_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3179_lanes = -Lambda_11_11_p3140_lanes - inverse_D3_p60 *
      Lambda_11_11_p2920_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3187_lanes = Lambda_11_11_p3148_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p2270_lanes[2];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3191_lanes = Lambda_11_11_p2112_lanes * Lambda_11_11_p1074_lanes[0] +
      Lambda_11_11_p2106_lanes * Lambda_11_11_p1149_lanes[3] + Lambda_11_11_p2118_lanes *
      Lambda_11_11_p1265_lanes[3] + Lambda_11_11_p2988_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3214_lanes = Lambda_11_11_p3179_lanes * inverse_D3;
  const Lanes<8> Lambda_11_11_p3245_lanes = -Lambda_11_11_p2997_lanes - inverse_D2_p7 *
      Lambda_11_11_p2920_lanes - inverse_D2_p12 * Lambda_11_11_p3179_lanes;
  const Lanes<8> Lambda_11_11_p3253_lanes = -Lambda_11_11_p3016_lanes + inverse_D2_p11 *
      Lambda_11_11_p3179_lanes;
  const Lanes<8> Lambda_11_11_p3324_lanes = detail::make_pack<Real>(Lambda_11_11_p2539_lanes[0],
      Lambda_11_11_p2539_lanes[1], Lambda_11_11_p2539_lanes[2], Lambda_11_11_p2539_lanes[3],
      Lambda_11_11_p2539_lanes[4], Lambda_11_11_p2539_lanes[5], Lambda_11_11_p2325 *
      Lambda_11_11_p2270_lanes[0], Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[0]) +
      Lambda_11_11_p2623_lanes * Lambda_11_11_p2562_lanes[0] + Lambda_11_11_p2952_lanes *
      Lambda_11_11_p2920_lanes[0] + Lambda_11_11_p3214_lanes * Lambda_11_11_p3179_lanes[0];
  const Lanes<8> Lambda_11_11_p3332_lanes = detail::make_pack<Real>(Lambda_11_11_p2883_lanes[1],
      Lambda_11_11_p2883_lanes[1], Lambda_11_11_p2883_lanes[2], Lambda_11_11_p2883_lanes[3],
      Lambda_11_11_p2883_lanes[4], Lambda_11_11_p2883_lanes[5], Lambda_11_11_p2325 *
      Lambda_11_11_p2270_lanes[1], Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[1]) +
      Lambda_11_11_p2623_lanes * Lambda_11_11_p2562_lanes[1] + Lambda_11_11_p2952_lanes *
      Lambda_11_11_p2920_lanes[1] + Lambda_11_11_p3214_lanes * Lambda_11_11_p3179_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3339_lanes = Lambda_11_11_p3191_lanes + Lambda_11_11_p2044_lanes *
      Lambda_11_11_p1596_lanes[3] + Lambda_11_11_p2032_lanes * Lambda_11_11_p1774_lanes[3] +
      Lambda_11_11_p2038_lanes * Lambda_11_11_p1920_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3342_lanes = detail::make_pack<Real>(Lambda_11_11_p3187_lanes[2],
      Lambda_11_11_p3187_lanes[2], Lambda_11_11_p3187_lanes[2], Lambda_11_11_p3187_lanes[3],
      Lambda_11_11_p3187_lanes[4], Lambda_11_11_p3187_lanes[5], Lambda_11_11_p2325 *
      Lambda_11_11_p2270_lanes[2], Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[2]) +
      Lambda_11_11_p2623_lanes * Lambda_11_11_p2562_lanes[2] + Lambda_11_11_p2952_lanes *
      Lambda_11_11_p2920_lanes[2] + Lambda_11_11_p3214_lanes * Lambda_11_11_p3179_lanes[2];
  const Lanes<8> Lambda_11_11_p3354_lanes = Lambda_11_11_p1832_lanes * Lambda_11_11_p3179_lanes[0];
  const Lanes<8> Lambda_11_11_p3358_lanes = Lambda_11_11_p1832_lanes * Lambda_11_11_p3179_lanes[1];
  const Lanes<8> Lambda_11_11_p3370_lanes = Lambda_11_11_p2 * Lambda_11_11_p3245_lanes -
      Lambda_11_11_p1 * Lambda_11_11_p3253_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3378_lanes = Lambda_11_11_p3339_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p2270_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3381_lanes = Lambda_11_11_p1832_lanes * Lambda_11_11_p3179_lanes[2];
  const Lanes<8> Lambda_11_11_p3387_lanes = Lambda_11_11_p1832_lanes * Lambda_11_11_p3179_lanes[3];
  const Lanes<8> Lambda_11_11_p3391_lanes = Lambda_11_11_p1832_lanes * Lambda_11_11_p3179_lanes[4];
  const Lanes<8> Lambda_11_11_p3411_lanes = Lambda_11_11_p1832_lanes * Lambda_11_11_p3179_lanes[5];
  const Lanes<8> Lambda_11_11_p3436_lanes = Lambda_11_11_p1876_lanes * Lambda_11_11_p2270_lanes[0] +
      Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[0] + Lambda_11_11_p1880_lanes *
      Lambda_11_11_p2920_lanes[0] + Lambda_11_11_p3354_lanes;
  const Lanes<8> Lambda_11_11_p3442_lanes = Lambda_11_11_p1876_lanes * Lambda_11_11_p2270_lanes[1] +
      Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[1] + Lambda_11_11_p1880_lanes *
      Lambda_11_11_p2920_lanes[1] + Lambda_11_11_p3358_lanes;
  const Lanes<8> Lambda_11_11_p3446_lanes = Lambda_11_11_p1876_lanes * Lambda_11_11_p2270_lanes[2] +
      Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[2] + Lambda_11_11_p1880_lanes *
      Lambda_11_11_p2920_lanes[2] + Lambda_11_11_p3381_lanes;
  const Lanes<8> Lambda_11_11_p3450_lanes = Lambda_11_11_p1876_lanes * Lambda_11_11_p2270_lanes[3] +
      Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[3] + Lambda_11_11_p1880_lanes *
      Lambda_11_11_p2920_lanes[3] + Lambda_11_11_p3387_lanes;
  const Lanes<8> Lambda_11_11_p3454_lanes = Lambda_11_11_p1876_lanes * Lambda_11_11_p2270_lanes[4] +
      Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[4] + Lambda_11_11_p1880_lanes *
      Lambda_11_11_p2920_lanes[4] + Lambda_11_11_p3391_lanes;
  const Lanes<8> Lambda_11_11_p3467_lanes = inverse_D2_p2 *
      (Lambda_11_11_p1 * Lambda_11_11_p3245_lanes + Lambda_11_11_p2 * Lambda_11_11_p3253_lanes) +
      inverse_D2_p1 * Lambda_11_11_p3370_lanes;
  const Lanes<8> Lambda_11_11_p3477_lanes = detail::make_pack<Real>(Lambda_11_11_p3378_lanes[3],
      Lambda_11_11_p3378_lanes[3], Lambda_11_11_p3378_lanes[3], Lambda_11_11_p3378_lanes[3],
      Lambda_11_11_p3378_lanes[4], Lambda_11_11_p3378_lanes[5], Lambda_11_11_p2325 *
      Lambda_11_11_p2270_lanes[3], Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[3]) +
      Lambda_11_11_p2623_lanes * Lambda_11_11_p2562_lanes[3] + Lambda_11_11_p2952_lanes *
      Lambda_11_11_p2920_lanes[3] + Lambda_11_11_p3214_lanes * Lambda_11_11_p3179_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3500_lanes = Lambda_11_11_p3467_lanes * inverse_D2;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p3508_lanes = Lambda_11_11_p2112_lanes * Lambda_11_11_p1074_lanes[1] +
      detail::make_pack<Real>(Lambda_11_11_p2106_lanes[4] * Lambda_11_11_p1149_lanes[4],
      Lambda_11_11_p2106_lanes[4] * Lambda_11_11_p1149_lanes[4], Lambda_11_11_p2106_lanes[4] *
      Lambda_11_11_p1149_lanes[4], Lambda_11_11_p2106_lanes[4] * Lambda_11_11_p1149_lanes[4],
      Lambda_11_11_p2106_lanes[4] * Lambda_11_11_p1149_lanes[4], Lambda_11_11_p2106_lanes[5] *
      Lambda_11_11_p1149_lanes[4], Lambda_11_11_p2106_lanes[4] * Lambda_11_11_p1149_lanes[4],
      Lambda_11_11_p2106_lanes[4] * Lambda_11_11_p1149_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2118_lanes[4] * Lambda_11_11_p1265_lanes[4],
      Lambda_11_11_p2118_lanes[4] * Lambda_11_11_p1265_lanes[4], Lambda_11_11_p2118_lanes[4] *
      Lambda_11_11_p1265_lanes[4], Lambda_11_11_p2118_lanes[4] * Lambda_11_11_p1265_lanes[4],
      Lambda_11_11_p2118_lanes[4] * Lambda_11_11_p1265_lanes[4], Lambda_11_11_p2118_lanes[5] *
      Lambda_11_11_p1265_lanes[4], Lambda_11_11_p2118_lanes[4] * Lambda_11_11_p1265_lanes[4],
      Lambda_11_11_p2118_lanes[4] * Lambda_11_11_p1265_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2124_lanes[4] * Lambda_11_11_p1440_lanes[4],
      Lambda_11_11_p2124_lanes[4] * Lambda_11_11_p1440_lanes[4], Lambda_11_11_p2124_lanes[4] *
      Lambda_11_11_p1440_lanes[4], Lambda_11_11_p2124_lanes[4] * Lambda_11_11_p1440_lanes[4],
      Lambda_11_11_p2124_lanes[4] * Lambda_11_11_p1440_lanes[4], Lambda_11_11_p2124_lanes[5] *
      Lambda_11_11_p1440_lanes[4], Lambda_11_11_p2124_lanes[4] * Lambda_11_11_p1440_lanes[4],
      Lambda_11_11_p2124_lanes[4] * Lambda_11_11_p1440_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2044_lanes[4] * Lambda_11_11_p1596_lanes[4],
      Lambda_11_11_p2044_lanes[4] * Lambda_11_11_p1596_lanes[4], Lambda_11_11_p2044_lanes[4] *
      Lambda_11_11_p1596_lanes[4], Lambda_11_11_p2044_lanes[4] * Lambda_11_11_p1596_lanes[4],
      Lambda_11_11_p2044_lanes[4] * Lambda_11_11_p1596_lanes[4], Lambda_11_11_p2044_lanes[5] *
      Lambda_11_11_p1596_lanes[4], Lambda_11_11_p2044_lanes[4] * Lambda_11_11_p1596_lanes[4],
      Lambda_11_11_p2044_lanes[4] * Lambda_11_11_p1596_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2032_lanes[4] * Lambda_11_11_p1774_lanes[4],
      Lambda_11_11_p2032_lanes[4] * Lambda_11_11_p1774_lanes[4], Lambda_11_11_p2032_lanes[4] *
      Lambda_11_11_p1774_lanes[4], Lambda_11_11_p2032_lanes[4] * Lambda_11_11_p1774_lanes[4],
      Lambda_11_11_p2032_lanes[4] * Lambda_11_11_p1774_lanes[4], Lambda_11_11_p2032_lanes[5] *
      Lambda_11_11_p1774_lanes[4], Lambda_11_11_p2032_lanes[4] * Lambda_11_11_p1774_lanes[4],
      Lambda_11_11_p2032_lanes[4] * Lambda_11_11_p1774_lanes[4]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3510_lanes = Lambda_11_11_p592_lanes * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p3517_lanes = Lambda_11_11_p507_lanes * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p3521_lanes = Lambda_11_11_p399_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3525_lanes = Lambda_11_11_p319_lanes * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p3535_lanes = Lambda_11_11_p211_lanes * inverse_D11_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p3539_lanes = Lambda_11_11_p140_lanes * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p3581_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_11_11_p121, Lambda_11_11_p125, Lambda_11_11_p114,
      Lambda_11_11_p116, Lambda_11_11_p121, Lambda_11_11_p121, Lambda_11_11_p121,
      Lambda_11_11_p121);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3591_lanes = Lambda_11_11_p3508_lanes +
      detail::make_pack<Real>(Lambda_11_11_p2038_lanes[4] * Lambda_11_11_p1920_lanes[4],
      Lambda_11_11_p2038_lanes[4] * Lambda_11_11_p1920_lanes[4], Lambda_11_11_p2038_lanes[4] *
      Lambda_11_11_p1920_lanes[4], Lambda_11_11_p2038_lanes[4] * Lambda_11_11_p1920_lanes[4],
      Lambda_11_11_p2038_lanes[4] * Lambda_11_11_p1920_lanes[4], Lambda_11_11_p2038_lanes[5] *
      Lambda_11_11_p1920_lanes[4], Lambda_11_11_p2038_lanes[4] * Lambda_11_11_p1920_lanes[4],
      Lambda_11_11_p2038_lanes[4] * Lambda_11_11_p1920_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2318_lanes[4] * Lambda_11_11_p2270_lanes[4],
      Lambda_11_11_p2318_lanes[4] * Lambda_11_11_p2270_lanes[4], Lambda_11_11_p2318_lanes[4] *
      Lambda_11_11_p2270_lanes[4], Lambda_11_11_p2318_lanes[4] * Lambda_11_11_p2270_lanes[4],
      Lambda_11_11_p2318_lanes[4] * Lambda_11_11_p2270_lanes[4], Lambda_11_11_p2318_lanes[5] *
      Lambda_11_11_p2270_lanes[4], Lambda_11_11_p2318_lanes[4] * Lambda_11_11_p2270_lanes[4],
      Lambda_11_11_p2318_lanes[4] * Lambda_11_11_p2270_lanes[4]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p3593_lanes = detail::make_pack<Real>(Lambda_11_11_p2124_lanes[5],
      Lambda_11_11_p3525_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1440_lanes[5],
      Lambda_11_11_p319_lanes[3]);

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3599_lanes = 0.434 *
      (Lambda_11_11_p3370_lanes - inverse_D1_p2 * Lambda_11_11_p3467_lanes);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3670_lanes = Lambda_11_11_p3599_lanes * inverse_D1;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3724_lanes = Lambda_11_11_p3525_lanes * Lambda_11_11_p996;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3764_lanes = detail::make_pack<Real>(Lambda_11_11_p3591_lanes[4],
      Lambda_11_11_p3591_lanes[4], Lambda_11_11_p3591_lanes[4], Lambda_11_11_p3591_lanes[4],
      Lambda_11_11_p3591_lanes[4], Lambda_11_11_p3591_lanes[5], Lambda_11_11_p2325 *
      Lambda_11_11_p2270_lanes[4], Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[4]) +
      Lambda_11_11_p2623_lanes * Lambda_11_11_p2562_lanes[4] + Lambda_11_11_p2952_lanes *
      Lambda_11_11_p2920_lanes[4] + Lambda_11_11_p3214_lanes * Lambda_11_11_p3179_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3775_lanes = Lambda_11_11_p3436_lanes + Lambda_11_11_p1828_lanes *
      Lambda_11_11_p3467_lanes[0] + Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[0];
  const Lanes<8> Lambda_11_11_p3807_lanes = Lambda_11_11_p3324_lanes + Lambda_11_11_p3500_lanes *
      Lambda_11_11_p3467_lanes[0] + Lambda_11_11_p3670_lanes * Lambda_11_11_p3599_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p3833_lanes = detail::make_pack<Real>(Lambda_11_11_p2112_lanes[5],
      Lambda_11_11_p3581_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1074_lanes[2],
      Lambda_11_11_p116) + detail::make_pack<Real>(Lambda_11_11_p2106_lanes[5],
      Lambda_11_11_p3539_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1149_lanes[5],
      Lambda_11_11_p140_lanes[3]) + detail::make_pack<Real>(Lambda_11_11_p2118_lanes[5],
      Lambda_11_11_p3535_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1265_lanes[5],
      Lambda_11_11_p211_lanes[3]) + Lambda_11_11_p3593_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3839 = 1.0 / Lambda_11_11_p3807_lanes[0];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3858_lanes = Lambda_11_11_p3581_lanes * Lambda_11_11_p755 +
      Lambda_11_11_p3539_lanes * Lambda_11_11_p806 + Lambda_11_11_p3535_lanes * Lambda_11_11_p892 +
      Lambda_11_11_p3724_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3862_lanes = Lambda_11_11_p1876_lanes * Lambda_11_11_p2270_lanes[5] +
      Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[5] + Lambda_11_11_p1880_lanes *
      Lambda_11_11_p2920_lanes[5] + Lambda_11_11_p3411_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_11_11_p3892_lanes = Lambda_11_11_p3833_lanes +
      detail::make_pack<Real>(Lambda_11_11_p2044_lanes[5], Lambda_11_11_p3521_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p1596_lanes[5], Lambda_11_11_p399_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p2032_lanes[5], Lambda_11_11_p3517_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p1774_lanes[5], Lambda_11_11_p507_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p2038_lanes[5], Lambda_11_11_p3510_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p1920_lanes[5], Lambda_11_11_p592_lanes[3]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3906_lanes = Lambda_11_11_p3858_lanes + Lambda_11_11_p3521_lanes *
      Lambda_11_11_p1095 + Lambda_11_11_p3517_lanes * Lambda_11_11_p1193 +
      Lambda_11_11_p3510_lanes * Lambda_11_11_p1359;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3910_lanes = Lambda_11_11_p3807_lanes * Lambda_11_11_p3839;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p3920 = 1065.380700001509 * Lambda_11_11_p755 * Lambda_11_11_p755 +
      Lambda_11_11_p806 * inverse_D12_lanes[1] * Lambda_11_11_p806 + Lambda_11_11_p892 *
      inverse_D11_lanes[1] * Lambda_11_11_p892;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3921_lanes = Lambda_11_11_p3775_lanes * Lambda_11_11_p3839;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p3925 = Lambda_11_11_p1077 * inverse_D7_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p3933 = Lambda_11_11_p839 * inverse_D9_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p3934 = Lambda_11_11_p959 * inverse_D8_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p3957 = 1065.380700001509 * Lambda_11_11_p591;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p3958 = Lambda_11_11_p628 * inverse_D12_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p3962 = Lambda_11_11_p706 * inverse_D11_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3963_lanes = detail::make_pack<Real>(Lambda_11_11_p3892_lanes[0] +
      Lambda_11_11_p2318_lanes[5] * Lambda_11_11_p2270_lanes[5], Lambda_11_11_p3892_lanes[0] +
      Lambda_11_11_p2318_lanes[5] * Lambda_11_11_p2270_lanes[5], Lambda_11_11_p3892_lanes[0] +
      Lambda_11_11_p2318_lanes[5] * Lambda_11_11_p2270_lanes[5], Lambda_11_11_p3892_lanes[0] +
      Lambda_11_11_p2318_lanes[5] * Lambda_11_11_p2270_lanes[5], Lambda_11_11_p3892_lanes[0] +
      Lambda_11_11_p2318_lanes[5] * Lambda_11_11_p2270_lanes[5], Lambda_11_11_p3892_lanes[0] +
      Lambda_11_11_p2318_lanes[5] * Lambda_11_11_p2270_lanes[5], Lambda_11_11_p2325 *
      Lambda_11_11_p2270_lanes[5], Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[5]) +
      Lambda_11_11_p2623_lanes * Lambda_11_11_p2562_lanes[5] + Lambda_11_11_p2952_lanes *
      Lambda_11_11_p2920_lanes[5] + Lambda_11_11_p3214_lanes * Lambda_11_11_p3179_lanes[5];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p3966 = Lambda_11_11_p764 * inverse_D10_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3975_lanes = Lambda_11_11_p3332_lanes + Lambda_11_11_p3500_lanes *
      Lambda_11_11_p3467_lanes[1] + Lambda_11_11_p3670_lanes * Lambda_11_11_p3599_lanes[1] -
      Lambda_11_11_p3910_lanes * Lambda_11_11_p3807_lanes[1];
  const Lanes<8> Lambda_11_11_p3982_lanes = Lambda_11_11_p3342_lanes + Lambda_11_11_p3500_lanes *
      Lambda_11_11_p3467_lanes[2] + Lambda_11_11_p3670_lanes * Lambda_11_11_p3599_lanes[2] -
      Lambda_11_11_p3910_lanes * Lambda_11_11_p3807_lanes[2];
  const Lanes<8> Lambda_11_11_p3988_lanes = Lambda_11_11_p3477_lanes + Lambda_11_11_p3500_lanes *
      Lambda_11_11_p3467_lanes[3] + Lambda_11_11_p3670_lanes * Lambda_11_11_p3599_lanes[3] -
      Lambda_11_11_p3910_lanes * Lambda_11_11_p3807_lanes[3];
  const Lanes<8> Lambda_11_11_p3993_lanes = Lambda_11_11_p3764_lanes + Lambda_11_11_p3500_lanes *
      Lambda_11_11_p3467_lanes[4] + Lambda_11_11_p3670_lanes * Lambda_11_11_p3599_lanes[4] -
      Lambda_11_11_p3910_lanes * Lambda_11_11_p3807_lanes[4];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p4000 = Lambda_11_11_p3920 + Lambda_11_11_p996 * inverse_D10_lanes[1] *
      Lambda_11_11_p996 + Lambda_11_11_p1095 * inverse_D9_lanes[1] * Lambda_11_11_p1095 +
      Lambda_11_11_p1193 * inverse_D8_lanes[1] * Lambda_11_11_p1193;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4001_lanes = Lambda_11_11_p3442_lanes + Lambda_11_11_p1828_lanes *
      Lambda_11_11_p3467_lanes[1] + Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[1] -
      Lambda_11_11_p3921_lanes * Lambda_11_11_p3807_lanes[1];
  const Real Lambda_11_11_p4005 = 1.0 / Lambda_11_11_p3975_lanes[1];
  const Lanes<8> Lambda_11_11_p4006_lanes = Lambda_11_11_p3446_lanes + Lambda_11_11_p1828_lanes *
      Lambda_11_11_p3467_lanes[2] + Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[2] -
      Lambda_11_11_p3921_lanes * Lambda_11_11_p3807_lanes[2];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4045_lanes = Lambda_11_11_p3525_lanes * Lambda_11_11_p764;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4053_lanes = Lambda_11_11_p3963_lanes + Lambda_11_11_p3500_lanes *
      Lambda_11_11_p3467_lanes[5] + Lambda_11_11_p3670_lanes * Lambda_11_11_p3599_lanes[5] -
      Lambda_11_11_p3910_lanes * Lambda_11_11_p3807_lanes[5];
  const Lanes<8> Lambda_11_11_p4064_lanes = Lambda_11_11_p3450_lanes + Lambda_11_11_p1828_lanes *
      Lambda_11_11_p3467_lanes[3] + Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[3] -
      Lambda_11_11_p3921_lanes * Lambda_11_11_p3807_lanes[3];
  const Lanes<8> Lambda_11_11_p4068_lanes = Lambda_11_11_p3454_lanes + Lambda_11_11_p1828_lanes *
      Lambda_11_11_p3467_lanes[4] + Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[4] -
      Lambda_11_11_p3921_lanes * Lambda_11_11_p3807_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4072_lanes = Lambda_11_11_p3906_lanes + Lambda_11_11_p1876_lanes *
      Lambda_11_11_p2270_lanes[6] + Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[6] +
      Lambda_11_11_p1880_lanes * Lambda_11_11_p2920_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4080_lanes = Lambda_11_11_p3862_lanes + Lambda_11_11_p1828_lanes *
      Lambda_11_11_p3467_lanes[5] + Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[5] -
      Lambda_11_11_p3921_lanes * Lambda_11_11_p3807_lanes[5];

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p4116 = Lambda_11_11_p4000 + Lambda_11_11_p1359 * inverse_D7_lanes[1] *
      Lambda_11_11_p1359 + Lambda_11_11_p2325 * Lambda_11_11_p2270_lanes[6] +
      Lambda_11_11_p2623_lanes[6] * Lambda_11_11_p2562_lanes[6] + Lambda_11_11_p2952_lanes[6] *
      Lambda_11_11_p2920_lanes[6];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4117 = Lambda_11_11_p3957 * Lambda_11_11_p755 + Lambda_11_11_p3958 *
      Lambda_11_11_p806 + Lambda_11_11_p3962 * Lambda_11_11_p892 + Lambda_11_11_p3966 *
      Lambda_11_11_p996 + Lambda_11_11_p3933 * Lambda_11_11_p1095;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4126_lanes = Lambda_11_11_p3975_lanes * Lambda_11_11_p4005;
  const Lanes<8> Lambda_11_11_p4132_lanes = Lambda_11_11_p4001_lanes * Lambda_11_11_p4005;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4136_lanes = Lambda_11_11_p3581_lanes * Lambda_11_11_p591 +
      Lambda_11_11_p3539_lanes * Lambda_11_11_p628 + Lambda_11_11_p3535_lanes * Lambda_11_11_p706 +
      Lambda_11_11_p4045_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4174_lanes = Lambda_11_11_p3982_lanes - Lambda_11_11_p4126_lanes *
      Lambda_11_11_p3975_lanes[2];
  const Real Lambda_11_11_p4192 = Lambda_11_11_p4116 + Lambda_11_11_p3214_lanes[6] *
      Lambda_11_11_p3179_lanes[6] + Lambda_11_11_p3500_lanes[6] * Lambda_11_11_p3467_lanes[6] +
      Lambda_11_11_p3670_lanes[6] * Lambda_11_11_p3599_lanes[6] - Lambda_11_11_p3910_lanes[6] *
      Lambda_11_11_p3807_lanes[6];
  const Lanes<8> Lambda_11_11_p4197_lanes = Lambda_11_11_p4006_lanes - Lambda_11_11_p4132_lanes *
      Lambda_11_11_p3975_lanes[2];
  const Real Lambda_11_11_p4205 = 1.0 / Lambda_11_11_p4174_lanes[2];
  const Lanes<8> Lambda_11_11_p4214_lanes = Lambda_11_11_p4072_lanes + Lambda_11_11_p1832_lanes *
      Lambda_11_11_p3179_lanes[6] + Lambda_11_11_p1828_lanes * Lambda_11_11_p3467_lanes[6] +
      Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[6];

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4218 = Lambda_11_11_p4117 + Lambda_11_11_p3934 * Lambda_11_11_p1193 +
      Lambda_11_11_p3925 * Lambda_11_11_p1359 + Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[6] +
      Lambda_11_11_p2623_lanes[7] * Lambda_11_11_p2562_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4223_lanes = Lambda_11_11_p4136_lanes + Lambda_11_11_p3521_lanes *
      Lambda_11_11_p839 + Lambda_11_11_p3517_lanes * Lambda_11_11_p959 + Lambda_11_11_p3510_lanes *
      Lambda_11_11_p1077;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4243_lanes = Lambda_11_11_p3525_lanes * Lambda_11_11_p319_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4295 = Lambda_11_11_p3957 * Lambda_11_11_p591 + Lambda_11_11_p3958 *
      Lambda_11_11_p628 + Lambda_11_11_p3962 * Lambda_11_11_p706 + Lambda_11_11_p3966 *
      Lambda_11_11_p764 + Lambda_11_11_p3933 * Lambda_11_11_p839;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4320_lanes = Lambda_11_11_p4223_lanes + Lambda_11_11_p1876_lanes *
      Lambda_11_11_p2270_lanes[7] + Lambda_11_11_p1872_lanes * Lambda_11_11_p2562_lanes[7] +
      Lambda_11_11_p1880_lanes * Lambda_11_11_p2920_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4324_lanes = Lambda_11_11_p4174_lanes * Lambda_11_11_p4205;
  const Lanes<8> Lambda_11_11_p4329_lanes = Lambda_11_11_p4197_lanes * Lambda_11_11_p4205;
  const Real Lambda_11_11_p4333 = Lambda_11_11_p4218 + Lambda_11_11_p2952_lanes[7] *
      Lambda_11_11_p2920_lanes[6] + Lambda_11_11_p3214_lanes[7] * Lambda_11_11_p3179_lanes[6] +
      Lambda_11_11_p3500_lanes[7] * Lambda_11_11_p3467_lanes[6] + Lambda_11_11_p3670_lanes[7] *
      Lambda_11_11_p3599_lanes[6];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4334_lanes = Lambda_11_11_p3581_lanes * Lambda_11_11_p121 +
      Lambda_11_11_p3539_lanes * Lambda_11_11_p140_lanes[0] + Lambda_11_11_p3535_lanes *
      Lambda_11_11_p211_lanes[0] + Lambda_11_11_p4243_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4372 = Lambda_11_11_p4295 + Lambda_11_11_p3934 * Lambda_11_11_p959 +
      Lambda_11_11_p3925 * Lambda_11_11_p1077 + Lambda_11_11_p2324 * Lambda_11_11_p2270_lanes[7] +
      Lambda_11_11_p2623_lanes[7] * Lambda_11_11_p2562_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4390_lanes = Lambda_11_11_p3988_lanes - Lambda_11_11_p4126_lanes *
      Lambda_11_11_p3975_lanes[3] - Lambda_11_11_p4324_lanes * Lambda_11_11_p4174_lanes[3];
  const Lanes<8> Lambda_11_11_p4402_lanes = Lambda_11_11_p4064_lanes - Lambda_11_11_p4132_lanes *
      Lambda_11_11_p3975_lanes[3] - Lambda_11_11_p4329_lanes * Lambda_11_11_p4174_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4422_lanes = Lambda_11_11_p3525_lanes * Lambda_11_11_p319_lanes[1];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4425 = 1.0 / Lambda_11_11_p4390_lanes[3];
  const Lanes<8> Lambda_11_11_p4429_lanes = Lambda_11_11_p4214_lanes - Lambda_11_11_p3921_lanes *
      Lambda_11_11_p3807_lanes[6] - Lambda_11_11_p4132_lanes * Lambda_11_11_p3975_lanes[6] -
      Lambda_11_11_p4329_lanes * Lambda_11_11_p4174_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4436_lanes = Lambda_11_11_p4334_lanes + Lambda_11_11_p3521_lanes *
      Lambda_11_11_p399_lanes[0] + Lambda_11_11_p3517_lanes * Lambda_11_11_p507_lanes[0] +
      Lambda_11_11_p3510_lanes * Lambda_11_11_p592_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4447_lanes = Lambda_11_11_p4320_lanes + Lambda_11_11_p1832_lanes *
      Lambda_11_11_p3179_lanes[7] + Lambda_11_11_p1828_lanes * Lambda_11_11_p3467_lanes[7] +
      Lambda_11_11_p1770_lanes * Lambda_11_11_p3599_lanes[7];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4490_lanes = Lambda_11_11_p3581_lanes * Lambda_11_11_p125 +
      Lambda_11_11_p3539_lanes * Lambda_11_11_p140_lanes[1] + Lambda_11_11_p3535_lanes *
      Lambda_11_11_p211_lanes[1] + Lambda_11_11_p4422_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4493 = Lambda_11_11_p4372 + Lambda_11_11_p2952_lanes[7] *
      Lambda_11_11_p2920_lanes[7] + Lambda_11_11_p3214_lanes[7] * Lambda_11_11_p3179_lanes[7] +
      Lambda_11_11_p3500_lanes[7] * Lambda_11_11_p3467_lanes[7] + Lambda_11_11_p3670_lanes[7] *
      Lambda_11_11_p3599_lanes[7];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p4498_lanes = Lambda_11_11_p3581_lanes * Lambda_11_11_p114;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4507_lanes = Lambda_11_11_p4436_lanes + Lambda_11_11_p1876_lanes *
      Lambda_11_11_p731_lanes[0] + Lambda_11_11_p1872_lanes * Lambda_11_11_p819_lanes[0] +
      Lambda_11_11_p1880_lanes * Lambda_11_11_p1030_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4511_lanes = Lambda_11_11_p4447_lanes - Lambda_11_11_p3921_lanes *
      Lambda_11_11_p3807_lanes[7] - Lambda_11_11_p4132_lanes * Lambda_11_11_p3975_lanes[7] -
      Lambda_11_11_p4329_lanes * Lambda_11_11_p4174_lanes[7];
  const Lanes<8> Lambda_11_11_p4518_lanes = Lambda_11_11_p4390_lanes * Lambda_11_11_p4425;
  const Lanes<8> Lambda_11_11_p4522_lanes = Lambda_11_11_p4402_lanes * Lambda_11_11_p4425;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4530_lanes = Lambda_11_11_p4490_lanes + Lambda_11_11_p3521_lanes *
      Lambda_11_11_p399_lanes[1] + Lambda_11_11_p3517_lanes * Lambda_11_11_p507_lanes[1] +
      Lambda_11_11_p3510_lanes * Lambda_11_11_p592_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4560_lanes = Lambda_11_11_p4507_lanes + Lambda_11_11_p1832_lanes *
      Lambda_11_11_p1115_lanes[0] + Lambda_11_11_p1828_lanes * Lambda_11_11_p1592_lanes[0] +
      Lambda_11_11_p1770_lanes * Lambda_11_11_p1712_lanes[0];
  const Lanes<8> Lambda_11_11_p4571_lanes = Lambda_11_11_p3993_lanes - Lambda_11_11_p4126_lanes *
      Lambda_11_11_p3975_lanes[4] - Lambda_11_11_p4324_lanes * Lambda_11_11_p4174_lanes[4] -
      Lambda_11_11_p4518_lanes * Lambda_11_11_p4390_lanes[4];
  const Lanes<8> Lambda_11_11_p4575_lanes = Lambda_11_11_p4053_lanes - Lambda_11_11_p4126_lanes *
      Lambda_11_11_p3975_lanes[5] - Lambda_11_11_p4324_lanes * Lambda_11_11_p4174_lanes[5] -
      Lambda_11_11_p4518_lanes * Lambda_11_11_p4390_lanes[5];
  const Lanes<8> Lambda_11_11_p4578_lanes = Lambda_11_11_p4068_lanes - Lambda_11_11_p4132_lanes *
      Lambda_11_11_p3975_lanes[4] - Lambda_11_11_p4329_lanes * Lambda_11_11_p4174_lanes[4] -
      Lambda_11_11_p4522_lanes * Lambda_11_11_p4390_lanes[4];
  const Real Lambda_11_11_p4582 = Lambda_11_11_p4333 - Lambda_11_11_p3910_lanes[7] *
      Lambda_11_11_p3807_lanes[6] - Lambda_11_11_p4126_lanes[7] * Lambda_11_11_p3975_lanes[6] -
      Lambda_11_11_p4324_lanes[7] * Lambda_11_11_p4174_lanes[6] - Lambda_11_11_p4518_lanes[7] *
      Lambda_11_11_p4390_lanes[6];
  const Lanes<8> Lambda_11_11_p4583_lanes = Lambda_11_11_p4080_lanes - Lambda_11_11_p4132_lanes *
      Lambda_11_11_p3975_lanes[5] - Lambda_11_11_p4329_lanes * Lambda_11_11_p4174_lanes[5] -
      Lambda_11_11_p4522_lanes * Lambda_11_11_p4390_lanes[5];
  const Real Lambda_11_11_p4587 = Lambda_11_11_p4493 - Lambda_11_11_p3910_lanes[7] *
      Lambda_11_11_p3807_lanes[7] - Lambda_11_11_p4126_lanes[7] * Lambda_11_11_p3975_lanes[7] -
      Lambda_11_11_p4324_lanes[7] * Lambda_11_11_p4174_lanes[7] - Lambda_11_11_p4518_lanes[7] *
      Lambda_11_11_p4390_lanes[7];
  const Real Lambda_11_11_p4600 = 1.0 / Lambda_11_11_p4571_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4611_lanes = Lambda_11_11_p4530_lanes + Lambda_11_11_p1876_lanes *
      Lambda_11_11_p731_lanes[1] + Lambda_11_11_p1872_lanes * Lambda_11_11_p819_lanes[1] +
      Lambda_11_11_p1880_lanes * Lambda_11_11_p1030_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4614 = Lambda_11_11_p4498_lanes[3] + Lambda_11_11_p3539_lanes[3] *
      Lambda_11_11_p140_lanes[2] + Lambda_11_11_p3535_lanes[3] * Lambda_11_11_p211_lanes[2] +
      Lambda_11_11_p3525_lanes[3] * Lambda_11_11_p319_lanes[2] + Lambda_11_11_p3521_lanes[3] *
      Lambda_11_11_p399_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4615_lanes = Lambda_11_11_p4560_lanes - Lambda_11_11_p3921_lanes *
      Lambda_11_11_p3775_lanes[0] - Lambda_11_11_p4132_lanes * Lambda_11_11_p4001_lanes[0] -
      Lambda_11_11_p4329_lanes * Lambda_11_11_p4197_lanes[0];
  const Real Lambda_0_0_p1 = Lambda_11_11_p4126_lanes[2] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3910_lanes[2];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4629 = Lambda_11_11_p4498_lanes[2] + Lambda_11_11_p3539_lanes[2] *
      Lambda_11_11_p140_lanes[2] + Lambda_11_11_p3535_lanes[2] * Lambda_11_11_p211_lanes[2] +
      Lambda_11_11_p3525_lanes[2] * Lambda_11_11_p319_lanes[2] + Lambda_11_11_p3521_lanes[2] *
      Lambda_11_11_p399_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4630_lanes = Lambda_11_11_p4611_lanes + Lambda_11_11_p1832_lanes *
      Lambda_11_11_p1115_lanes[1] + Lambda_11_11_p1828_lanes * Lambda_11_11_p1592_lanes[1] +
      Lambda_11_11_p1770_lanes * Lambda_11_11_p1712_lanes[1];
  const Lanes<8> Lambda_11_11_p4633_lanes = Lambda_11_11_p4571_lanes * Lambda_11_11_p4600;
  const Lanes<8> Lambda_11_11_p4636_lanes = Lambda_11_11_p4578_lanes * Lambda_11_11_p4600;
  const Real Lambda_0_0_p2 = Lambda_11_11_p4126_lanes[3] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3910_lanes[3] - Lambda_11_11_p4324_lanes[3] * Lambda_0_0_p1;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4643 = Lambda_11_11_p4614 + Lambda_11_11_p3517_lanes[3] *
      Lambda_11_11_p507_lanes[2] + Lambda_11_11_p3510_lanes[3] * Lambda_11_11_p592_lanes[2] +
      Lambda_11_11_p1876_lanes[3] * Lambda_11_11_p731_lanes[2] + Lambda_11_11_p1872_lanes[3] *
      Lambda_11_11_p819_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4669_lanes = Lambda_11_11_p4575_lanes - Lambda_11_11_p4633_lanes *
      Lambda_11_11_p4571_lanes[5];
  const Real Lambda_11_11_p4672 = Lambda_11_11_p4192 - Lambda_11_11_p4126_lanes[6] *
      Lambda_11_11_p3975_lanes[6] - Lambda_11_11_p4324_lanes[6] * Lambda_11_11_p4174_lanes[6] -
      Lambda_11_11_p4518_lanes[6] * Lambda_11_11_p4390_lanes[6] - Lambda_11_11_p4633_lanes[6] *
      Lambda_11_11_p4571_lanes[6];
  const Lanes<8> Lambda_11_11_p4673_lanes = Lambda_11_11_p4583_lanes - Lambda_11_11_p4636_lanes *
      Lambda_11_11_p4571_lanes[5];
  const Lanes<8> Lambda_11_11_p4689_lanes = Lambda_11_11_p4630_lanes - Lambda_11_11_p3921_lanes *
      Lambda_11_11_p3775_lanes[1] - Lambda_11_11_p4132_lanes * Lambda_11_11_p4001_lanes[1] -
      Lambda_11_11_p4329_lanes * Lambda_11_11_p4197_lanes[1];
  const Real Lambda_11_11_p4692 = 1.0 / Lambda_11_11_p4669_lanes[5];
  const Real Lambda_0_0_p3 = Lambda_11_11_p4126_lanes[4] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3910_lanes[4] - Lambda_11_11_p4324_lanes[4] * Lambda_0_0_p1 -
      Lambda_11_11_p4518_lanes[4] * Lambda_0_0_p2;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4693 = Lambda_11_11_p4629 + Lambda_11_11_p3517_lanes[2] *
      Lambda_11_11_p507_lanes[2] + Lambda_11_11_p3510_lanes[2] * Lambda_11_11_p592_lanes[2] +
      Lambda_11_11_p1876_lanes[2] * Lambda_11_11_p731_lanes[2] + Lambda_11_11_p1872_lanes[2] *
      Lambda_11_11_p819_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4700 = Lambda_11_11_p4643 + Lambda_11_11_p1880_lanes[3] *
      Lambda_11_11_p1030_lanes[2] + Lambda_11_11_p1832_lanes[3] * Lambda_11_11_p1115_lanes[2] +
      Lambda_11_11_p1828_lanes[3] * Lambda_11_11_p1592_lanes[2] + Lambda_11_11_p1770_lanes[3] *
      Lambda_11_11_p1712_lanes[2];
  const Real Lambda_0_0_p4 = Lambda_11_11_p4126_lanes[5] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3910_lanes[5] - Lambda_11_11_p4324_lanes[5] * Lambda_0_0_p1 -
      Lambda_11_11_p4518_lanes[5] * Lambda_0_0_p2 - Lambda_11_11_p4633_lanes[5] * Lambda_0_0_p3;
  const Real Lambda_0_0_p5 = Lambda_11_11_p4126_lanes[6] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3910_lanes[6] - Lambda_11_11_p4324_lanes[6] * Lambda_0_0_p1 -
      Lambda_11_11_p4518_lanes[6] * Lambda_0_0_p2 - Lambda_11_11_p4633_lanes[6] * Lambda_0_0_p3;
  const Real Lambda_0_0_p6 = Lambda_11_11_p4126_lanes[7] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3910_lanes[7] - Lambda_11_11_p4324_lanes[7] * Lambda_0_0_p1 -
      Lambda_11_11_p4518_lanes[7] * Lambda_0_0_p2 - Lambda_11_11_p4633_lanes[7] * Lambda_0_0_p3;
  const Real Lambda_11_11_p4701 = Lambda_11_11_p4669_lanes[6] * Lambda_11_11_p4692;
  const Real Lambda_11_11_p4702 = Lambda_11_11_p4669_lanes[7] * Lambda_11_11_p4692;
  const Lanes<8> Lambda_11_11_p4703_lanes = Lambda_11_11_p4673_lanes * Lambda_11_11_p4692;
  const Real Lambda_11_11_p4707 = Lambda_11_11_p4693 + Lambda_11_11_p1880_lanes[2] *
      Lambda_11_11_p1030_lanes[2] + Lambda_11_11_p1832_lanes[2] * Lambda_11_11_p1115_lanes[2] +
      Lambda_11_11_p1828_lanes[2] * Lambda_11_11_p1592_lanes[2] + Lambda_11_11_p1770_lanes[2] *
      Lambda_11_11_p1712_lanes[2];
  const Real Lambda_11_11_p4723 = Lambda_11_11_p4700 - Lambda_11_11_p3921_lanes[3] *
      Lambda_11_11_p3775_lanes[2] - Lambda_11_11_p4132_lanes[3] * Lambda_11_11_p4001_lanes[2] -
      Lambda_11_11_p4329_lanes[3] * Lambda_11_11_p4197_lanes[2] - Lambda_11_11_p4522_lanes[3] *
      Lambda_11_11_p4402_lanes[2];
  const Real Lambda_11_11_p4724 = Lambda_11_11_p4582 - Lambda_11_11_p4633_lanes[7] *
      Lambda_11_11_p4571_lanes[6] - Lambda_11_11_p4702 * Lambda_11_11_p4669_lanes[6];
  const Lanes<8> Lambda_11_11_p4725_lanes = Lambda_11_11_p4429_lanes - Lambda_11_11_p4522_lanes *
      Lambda_11_11_p4390_lanes[6] - Lambda_11_11_p4636_lanes * Lambda_11_11_p4571_lanes[6] -
      Lambda_11_11_p4703_lanes * Lambda_11_11_p4669_lanes[6];
  const Lanes<8> Lambda_11_11_p4729_lanes = Lambda_11_11_p4511_lanes - Lambda_11_11_p4522_lanes *
      Lambda_11_11_p4390_lanes[7] - Lambda_11_11_p4636_lanes * Lambda_11_11_p4571_lanes[7] -
      Lambda_11_11_p4703_lanes * Lambda_11_11_p4669_lanes[7];
  const Lanes<8> Lambda_11_11_p4733_lanes = Lambda_11_11_p4615_lanes - Lambda_11_11_p4522_lanes *
      Lambda_11_11_p4402_lanes[0] - Lambda_11_11_p4636_lanes * Lambda_11_11_p4578_lanes[0] -
      Lambda_11_11_p4703_lanes * Lambda_11_11_p4673_lanes[0];
  const Lanes<8> Lambda_11_11_p4737_lanes = Lambda_11_11_p4689_lanes - Lambda_11_11_p4522_lanes *
      Lambda_11_11_p4402_lanes[1] - Lambda_11_11_p4636_lanes * Lambda_11_11_p4578_lanes[1] -
      Lambda_11_11_p4703_lanes * Lambda_11_11_p4673_lanes[1];
  const Real Lambda_0_11_p1 = Lambda_11_11_p4132_lanes[0] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3921_lanes[0] - Lambda_11_11_p4329_lanes[0] * Lambda_0_0_p1 -
      Lambda_11_11_p4522_lanes[0] * Lambda_0_0_p2 - Lambda_11_11_p4636_lanes[0] * Lambda_0_0_p3;
  const Real Lambda_11_11_p4740 = 1.0 / (Lambda_11_11_p4672 - Lambda_11_11_p4701 *
      Lambda_11_11_p4669_lanes[6]);
  const Real Lambda_0_0_p7 = Lambda_0_0_p5 - Lambda_11_11_p4701 * Lambda_0_0_p4;
  const Real Lambda_0_0_p8 = Lambda_11_11_p3910_lanes[1] * Lambda_11_11_p4005;
  const Real Lambda_0_11_p2 = Lambda_11_11_p4132_lanes[1] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3921_lanes[1] - Lambda_11_11_p4329_lanes[1] * Lambda_0_0_p1 -
      Lambda_11_11_p4522_lanes[1] * Lambda_0_0_p2 - Lambda_11_11_p4636_lanes[1] * Lambda_0_0_p3;
  const Real Lambda_0_0_p9 = Lambda_0_0_p1 * Lambda_11_11_p4205;
  const Real Lambda_0_0_p10 = Lambda_0_0_p2 * Lambda_11_11_p4425;
  const Real Lambda_11_11_p4741 = Lambda_11_11_p4707 - Lambda_11_11_p3921_lanes[2] *
      Lambda_11_11_p3775_lanes[2] - Lambda_11_11_p4132_lanes[2] * Lambda_11_11_p4001_lanes[2] -
      Lambda_11_11_p4329_lanes[2] * Lambda_11_11_p4197_lanes[2] - Lambda_11_11_p4522_lanes[2] *
      Lambda_11_11_p4402_lanes[2];
  const Real Lambda_0_11_p3 = Lambda_11_11_p4132_lanes[2] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3921_lanes[2] - Lambda_11_11_p4329_lanes[2] * Lambda_0_0_p1 -
      Lambda_11_11_p4522_lanes[2] * Lambda_0_0_p2 - Lambda_11_11_p4636_lanes[2] * Lambda_0_0_p3;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p4742 = Lambda_11_11_p3892_lanes[1] + Lambda_11_11_p1876_lanes[3] *
      Lambda_11_11_p731_lanes[3] + Lambda_11_11_p1872_lanes[3] * Lambda_11_11_p819_lanes[3] +
      Lambda_11_11_p1880_lanes[3] * Lambda_11_11_p1030_lanes[3] + Lambda_11_11_p1832_lanes[3] *
      Lambda_11_11_p1115_lanes[3];

  // link 1 (calf), force propagation
  const Real Lambda_0_0_p11 = Lambda_0_0_p3 * Lambda_11_11_p4600;
  const Real Lambda_0_0_p12 = Lambda_0_0_p4 * Lambda_11_11_p4692;
  const Real Lambda_1_11_p1 = Lambda_11_11_p4324_lanes[3] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4126_lanes[3];
  const Real Lambda_0_11_p4 = Lambda_11_11_p4132_lanes[3] * Lambda_11_11_p3910_lanes[1] -
      Lambda_11_11_p3921_lanes[3] - Lambda_11_11_p4329_lanes[3] * Lambda_0_0_p1 -
      Lambda_11_11_p4522_lanes[3] * Lambda_0_0_p2 - Lambda_11_11_p4636_lanes[3] * Lambda_0_0_p3;
  const Real Lambda_11_11_p4743 = Lambda_11_11_p4724 * Lambda_11_11_p4740;
  const Lanes<8> Lambda_11_11_p4744_lanes = Lambda_11_11_p4725_lanes * Lambda_11_11_p4740;
  const Real Lambda_0_0_p13 = Lambda_0_0_p7 * Lambda_11_11_p4740;
  const Real Lambda_1_11_p2 = Lambda_11_11_p4324_lanes[4] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4126_lanes[4] - Lambda_11_11_p4518_lanes[4] * Lambda_1_11_p1;
  const Real Lambda_11_11_p4759 = Lambda_11_11_p4742 + Lambda_11_11_p1828_lanes[3] *
      Lambda_11_11_p1592_lanes[3] + Lambda_11_11_p1770_lanes[3] * Lambda_11_11_p1712_lanes[3] -
      Lambda_11_11_p3921_lanes[3] * Lambda_11_11_p3775_lanes[3] - Lambda_11_11_p4132_lanes[3] *
      Lambda_11_11_p4001_lanes[3];
  const Lanes<8> Lambda_11_11_p4760_lanes = Lambda_11_11_p4729_lanes - Lambda_11_11_p4744_lanes *
      Lambda_11_11_p4724;
  const Real Lambda_1_11_p3 = Lambda_11_11_p4324_lanes[5] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4126_lanes[5] - Lambda_11_11_p4518_lanes[5] * Lambda_1_11_p1 -
      Lambda_11_11_p4633_lanes[5] * Lambda_1_11_p2;
  const Real Lambda_11_11_p4771 = 1.0 / (Lambda_11_11_p4587 - Lambda_11_11_p4633_lanes[7] *
      Lambda_11_11_p4571_lanes[7] - Lambda_11_11_p4702 * Lambda_11_11_p4669_lanes[7] -
      Lambda_11_11_p4743 * Lambda_11_11_p4724);
  const Real Lambda_0_0_p14 = Lambda_0_0_p6 - Lambda_11_11_p4702 * Lambda_0_0_p4 -
      Lambda_11_11_p4743 * Lambda_0_0_p7;
  const Real Lambda_1_11_p4 = Lambda_11_11_p4324_lanes[6] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4126_lanes[6] - Lambda_11_11_p4518_lanes[6] * Lambda_1_11_p1 -
      Lambda_11_11_p4633_lanes[6] * Lambda_1_11_p2 - Lambda_11_11_p4701 * Lambda_1_11_p3;
  const Real Lambda_1_11_p5 = Lambda_11_11_p4324_lanes[7] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4126_lanes[7] - Lambda_11_11_p4518_lanes[7] * Lambda_1_11_p1 -
      Lambda_11_11_p4633_lanes[7] * Lambda_1_11_p2 - Lambda_11_11_p4702 * Lambda_1_11_p3;
  const Real Lambda_1_11_p6 = Lambda_11_11_p4329_lanes[0] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4132_lanes[0] - Lambda_11_11_p4522_lanes[0] * Lambda_1_11_p1 -
      Lambda_11_11_p4636_lanes[0] * Lambda_1_11_p2 - Lambda_11_11_p4703_lanes[0] * Lambda_1_11_p3;
  const Real Lambda_11_11_p4772 = Lambda_11_11_p4759 - Lambda_11_11_p4329_lanes[3] *
      Lambda_11_11_p4197_lanes[3] - Lambda_11_11_p4522_lanes[3] * Lambda_11_11_p4402_lanes[3] -
      Lambda_11_11_p4636_lanes[3] * Lambda_11_11_p4578_lanes[3] - Lambda_11_11_p4703_lanes[3] *
      Lambda_11_11_p4673_lanes[3];
  const Real Lambda_0_1_p1 = Lambda_1_11_p1 * Lambda_11_11_p4425;
  const Real Lambda_1_11_p7 = Lambda_11_11_p4329_lanes[1] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4132_lanes[1] - Lambda_11_11_p4522_lanes[1] * Lambda_1_11_p1 -
      Lambda_11_11_p4636_lanes[1] * Lambda_1_11_p2 - Lambda_11_11_p4703_lanes[1] * Lambda_1_11_p3;
  const Real Lambda_0_1_p2 = Lambda_11_11_p4126_lanes[2] * Lambda_11_11_p4205;
  const Real Lambda_0_1_p3 = Lambda_1_11_p2 * Lambda_11_11_p4600;
  const Real Lambda_0_1_p4 = Lambda_1_11_p3 * Lambda_11_11_p4692;
  const Real Lambda_1_11_p8 = Lambda_1_11_p5 - Lambda_11_11_p4743 * Lambda_1_11_p4;
  const Lanes<8> Lambda_11_11_p4773_lanes = Lambda_11_11_p4760_lanes * Lambda_11_11_p4771;
  const Real Lambda_1_11_p9 = Lambda_11_11_p4329_lanes[2] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4132_lanes[2] - Lambda_11_11_p4522_lanes[2] * Lambda_1_11_p1 -
      Lambda_11_11_p4636_lanes[2] * Lambda_1_11_p2 - Lambda_11_11_p4703_lanes[2] * Lambda_1_11_p3;
  const Real Lambda_0_1_p5 = Lambda_1_11_p4 * Lambda_11_11_p4740;
  const Real Lambda_0_0_p15 = Lambda_11_11_p3839 + Lambda_0_0_p8 * Lambda_11_11_p3910_lanes[1] +
      Lambda_0_0_p9 * Lambda_0_0_p1 + Lambda_0_0_p10 * Lambda_0_0_p2 + Lambda_0_0_p11 *
      Lambda_0_0_p3;
  const Real Lambda_2_11_p1 = Lambda_11_11_p4518_lanes[4] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4324_lanes[4];
  const Real Lambda_0_0_p16 = Lambda_0_0_p14 * Lambda_11_11_p4771;
  const Lanes<8> Lambda_11_11_p4784_lanes = Lambda_11_11_p4733_lanes - Lambda_11_11_p4744_lanes *
      Lambda_11_11_p4725_lanes[0] - Lambda_11_11_p4773_lanes * Lambda_11_11_p4760_lanes[0];
  const Real Lambda_11_11_p4791 = Lambda_11_11_p4741 - Lambda_11_11_p4636_lanes[2] *
      Lambda_11_11_p4578_lanes[2] - Lambda_11_11_p4703_lanes[2] * Lambda_11_11_p4673_lanes[2] -
      Lambda_11_11_p4744_lanes[2] * Lambda_11_11_p4725_lanes[2] - Lambda_11_11_p4773_lanes[2] *
      Lambda_11_11_p4760_lanes[2];
  const Real Lambda_11_11_p4792 = Lambda_11_11_p4723 - Lambda_11_11_p4636_lanes[3] *
      Lambda_11_11_p4578_lanes[2] - Lambda_11_11_p4703_lanes[3] * Lambda_11_11_p4673_lanes[2] -
      Lambda_11_11_p4744_lanes[3] * Lambda_11_11_p4725_lanes[2] - Lambda_11_11_p4773_lanes[3] *
      Lambda_11_11_p4760_lanes[2];
  const Real Lambda_2_11_p2 = Lambda_11_11_p4518_lanes[5] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4324_lanes[5] - Lambda_11_11_p4633_lanes[5] * Lambda_2_11_p1;
  const Real Lambda_11_11_p4793 = 1.0 / Lambda_11_11_p4784_lanes[0];
  const Real Lambda_0_11_p5 = Lambda_0_11_p1 - Lambda_11_11_p4703_lanes[0] * Lambda_0_0_p4 -
      Lambda_11_11_p4744_lanes[0] * Lambda_0_0_p7 - Lambda_11_11_p4773_lanes[0] * Lambda_0_0_p14;
  const Real Lambda_1_11_p10 = Lambda_1_11_p6 - Lambda_11_11_p4744_lanes[0] * Lambda_1_11_p4 -
      Lambda_11_11_p4773_lanes[0] * Lambda_1_11_p8;
  const Real Lambda_1_11_p11 = Lambda_11_11_p4329_lanes[3] * Lambda_11_11_p4126_lanes[2] -
      Lambda_11_11_p4132_lanes[3] - Lambda_11_11_p4522_lanes[3] * Lambda_1_11_p1 -
      Lambda_11_11_p4636_lanes[3] * Lambda_1_11_p2 - Lambda_11_11_p4703_lanes[3] * Lambda_1_11_p3;
  const Real Lambda_2_11_p3 = Lambda_11_11_p4518_lanes[6] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4324_lanes[6] - Lambda_11_11_p4633_lanes[6] * Lambda_2_11_p1 -
      Lambda_11_11_p4701 * Lambda_2_11_p2;
  const Real Lambda_0_1_p6 = Lambda_1_11_p8 * Lambda_11_11_p4771;
  const Real Lambda_0_2_p1 = Lambda_11_11_p4324_lanes[3] * Lambda_11_11_p4425;
  const Real Lambda_0_2_p2 = Lambda_2_11_p1 * Lambda_11_11_p4600;
  const Real Lambda_0_2_p3 = Lambda_2_11_p2 * Lambda_11_11_p4692;
  const Real Lambda_0_2_p4 = Lambda_2_11_p3 * Lambda_11_11_p4740;
  const Lanes<8> Lambda_11_11_p4794_lanes = Lambda_11_11_p4784_lanes * Lambda_11_11_p4793;
  const Real Lambda_2_11_p4 = Lambda_11_11_p4518_lanes[7] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4324_lanes[7] - Lambda_11_11_p4633_lanes[7] * Lambda_2_11_p1 -
      Lambda_11_11_p4702 * Lambda_2_11_p2 - Lambda_11_11_p4743 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_11_11_p4522_lanes[0] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4329_lanes[0] - Lambda_11_11_p4636_lanes[0] * Lambda_2_11_p1 -
      Lambda_11_11_p4703_lanes[0] * Lambda_2_11_p2 - Lambda_11_11_p4744_lanes[0] * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_11_11_p4522_lanes[1] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4329_lanes[1] - Lambda_11_11_p4636_lanes[1] * Lambda_2_11_p1 -
      Lambda_11_11_p4703_lanes[1] * Lambda_2_11_p2 - Lambda_11_11_p4744_lanes[1] * Lambda_2_11_p3;
  const Real Lambda_2_11_p7 = Lambda_11_11_p4522_lanes[2] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4329_lanes[2] - Lambda_11_11_p4636_lanes[2] * Lambda_2_11_p1 -
      Lambda_11_11_p4703_lanes[2] * Lambda_2_11_p2 - Lambda_11_11_p4744_lanes[2] * Lambda_2_11_p3;
  const Real Lambda_3_11_p1 = Lambda_11_11_p4633_lanes[5] * Lambda_11_11_p4518_lanes[4] -
      Lambda_11_11_p4518_lanes[5];
  const Lanes<8> Lambda_11_11_p4800_lanes = Lambda_11_11_p4737_lanes - Lambda_11_11_p4744_lanes *
      Lambda_11_11_p4725_lanes[1] - Lambda_11_11_p4773_lanes * Lambda_11_11_p4760_lanes[1] -
      Lambda_11_11_p4794_lanes * Lambda_11_11_p4784_lanes[1];
  const Real Lambda_2_11_p8 = Lambda_2_11_p5 - Lambda_11_11_p4773_lanes[0] * Lambda_2_11_p4;
  const Real Lambda_0_11_p6 = Lambda_0_11_p2 - Lambda_11_11_p4703_lanes[1] * Lambda_0_0_p4 -
      Lambda_11_11_p4744_lanes[1] * Lambda_0_0_p7 - Lambda_11_11_p4773_lanes[1] * Lambda_0_0_p14 -
      Lambda_11_11_p4794_lanes[1] * Lambda_0_11_p5;
  const Real Lambda_1_11_p12 = Lambda_1_11_p7 - Lambda_11_11_p4744_lanes[1] * Lambda_1_11_p4 -
      Lambda_11_11_p4773_lanes[1] * Lambda_1_11_p8 - Lambda_11_11_p4794_lanes[1] * Lambda_1_11_p10;
  const Real Lambda_11_11_p4803 = 1.0 / Lambda_11_11_p4800_lanes[1];
  const Real Lambda_3_11_p2 = Lambda_11_11_p4633_lanes[6] * Lambda_11_11_p4518_lanes[4] -
      Lambda_11_11_p4518_lanes[6] - Lambda_11_11_p4701 * Lambda_3_11_p1;
  const Real Lambda_2_11_p9 = Lambda_11_11_p4522_lanes[3] * Lambda_11_11_p4324_lanes[3] -
      Lambda_11_11_p4329_lanes[3] - Lambda_11_11_p4636_lanes[3] * Lambda_2_11_p1 -
      Lambda_11_11_p4703_lanes[3] * Lambda_2_11_p2 - Lambda_11_11_p4744_lanes[3] * Lambda_2_11_p3;
  const Real Lambda_2_11_p10 = Lambda_2_11_p6 - Lambda_11_11_p4773_lanes[1] * Lambda_2_11_p4 -
      Lambda_11_11_p4794_lanes[1] * Lambda_2_11_p8;
  const Real Lambda_0_3_p1 = Lambda_3_11_p2 * Lambda_11_11_p4740;
  const Real Lambda_0_11_p7 = Lambda_0_11_p3 - Lambda_11_11_p4703_lanes[2] * Lambda_0_0_p4 -
      Lambda_11_11_p4744_lanes[2] * Lambda_0_0_p7 - Lambda_11_11_p4773_lanes[2] * Lambda_0_0_p14 -
      Lambda_11_11_p4794_lanes[2] * Lambda_0_11_p5;
  const Real Lambda_0_3_p2 = Lambda_3_11_p1 * Lambda_11_11_p4692;
  const Real Lambda_0_3_p3 = Lambda_11_11_p4518_lanes[4] * Lambda_11_11_p4600;
  const Real Lambda_3_11_p3 = Lambda_11_11_p4633_lanes[7] * Lambda_11_11_p4518_lanes[4] -
      Lambda_11_11_p4518_lanes[7] - Lambda_11_11_p4702 * Lambda_3_11_p1 - Lambda_11_11_p4743 *
      Lambda_3_11_p2;
  const Real Lambda_0_2_p5 = Lambda_2_11_p4 * Lambda_11_11_p4771;
  const Real Lambda_0_3_p4 = Lambda_3_11_p3 * Lambda_11_11_p4771;
  const Real Lambda_11_11_p4804 = Lambda_11_11_p4800_lanes[2] * Lambda_11_11_p4803;
  const Real Lambda_4_11_p1 = Lambda_11_11_p4701 * Lambda_11_11_p4633_lanes[5] -
      Lambda_11_11_p4633_lanes[6];
  const Real Lambda_11_11_p4805 = Lambda_11_11_p4800_lanes[3] * Lambda_11_11_p4803;
  const Real Lambda_3_11_p4 = Lambda_11_11_p4636_lanes[0] * Lambda_11_11_p4518_lanes[4] -
      Lambda_11_11_p4522_lanes[0] - Lambda_11_11_p4703_lanes[0] * Lambda_3_11_p1 -
      Lambda_11_11_p4744_lanes[0] * Lambda_3_11_p2 - Lambda_11_11_p4773_lanes[0] * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_11_11_p4636_lanes[1] * Lambda_11_11_p4518_lanes[4] -
      Lambda_11_11_p4522_lanes[1] - Lambda_11_11_p4703_lanes[1] * Lambda_3_11_p1 -
      Lambda_11_11_p4744_lanes[1] * Lambda_3_11_p2 - Lambda_11_11_p4773_lanes[1] * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_11_11_p4636_lanes[2] * Lambda_11_11_p4518_lanes[4] -
      Lambda_11_11_p4522_lanes[2] - Lambda_11_11_p4703_lanes[2] * Lambda_3_11_p1 -
      Lambda_11_11_p4744_lanes[2] * Lambda_3_11_p2 - Lambda_11_11_p4773_lanes[2] * Lambda_3_11_p3;
  const Real Lambda_3_11_p7 = Lambda_11_11_p4636_lanes[3] * Lambda_11_11_p4518_lanes[4] -
      Lambda_11_11_p4522_lanes[3] - Lambda_11_11_p4703_lanes[3] * Lambda_3_11_p1 -
      Lambda_11_11_p4744_lanes[3] * Lambda_3_11_p2 - Lambda_11_11_p4773_lanes[3] * Lambda_3_11_p3;
  const Real Lambda_4_11_p2 = Lambda_11_11_p4702 * Lambda_11_11_p4633_lanes[5] -
      Lambda_11_11_p4633_lanes[7] - Lambda_11_11_p4743 * Lambda_4_11_p1;
  const Real Lambda_11_11_p4806 = Lambda_11_11_p4792 - Lambda_11_11_p4794_lanes[3] *
      Lambda_11_11_p4784_lanes[2] - Lambda_11_11_p4805 * Lambda_11_11_p4800_lanes[2];
  const Real Lambda_11_11_p4807 = Lambda_11_11_p4772 - Lambda_11_11_p4744_lanes[3] *
      Lambda_11_11_p4725_lanes[3] - Lambda_11_11_p4773_lanes[3] * Lambda_11_11_p4760_lanes[3] -
      Lambda_11_11_p4794_lanes[3] * Lambda_11_11_p4784_lanes[3] - Lambda_11_11_p4805 *
      Lambda_11_11_p4800_lanes[3];
  const Real Lambda_0_4_p1 = Lambda_11_11_p4633_lanes[5] * Lambda_11_11_p4692;
  const Real Lambda_3_11_p8 = Lambda_3_11_p5 - Lambda_11_11_p4794_lanes[1] * Lambda_3_11_p4;
  const Real Lambda_11_11_p4808 = 1.0 / (Lambda_11_11_p4791 - Lambda_11_11_p4794_lanes[2] *
      Lambda_11_11_p4784_lanes[2] - Lambda_11_11_p4804 * Lambda_11_11_p4800_lanes[2]);
  const Real Lambda_0_4_p2 = Lambda_4_11_p1 * Lambda_11_11_p4740;
  const Real Lambda_0_4_p3 = Lambda_4_11_p2 * Lambda_11_11_p4771;
  const Real Lambda_0_11_p8 = Lambda_0_11_p7 - Lambda_11_11_p4804 * Lambda_0_11_p6;
  const Real Lambda_4_11_p3 = Lambda_11_11_p4703_lanes[0] * Lambda_11_11_p4633_lanes[5] -
      Lambda_11_11_p4636_lanes[0] - Lambda_11_11_p4744_lanes[0] * Lambda_4_11_p1 -
      Lambda_11_11_p4773_lanes[0] * Lambda_4_11_p2;
  const Real Lambda_1_11_p13 = Lambda_1_11_p9 - Lambda_11_11_p4744_lanes[2] * Lambda_1_11_p4 -
      Lambda_11_11_p4773_lanes[2] * Lambda_1_11_p8 - Lambda_11_11_p4794_lanes[2] * Lambda_1_11_p10 -
      Lambda_11_11_p4804 * Lambda_1_11_p12;
  const Real Lambda_5_11_p1 = Lambda_11_11_p4743 * Lambda_11_11_p4701 - Lambda_11_11_p4702;
  const Real Lambda_0_1_p7 = Lambda_0_1_p1 * Lambda_0_0_p2 -
      (Lambda_0_0_p8 + Lambda_0_1_p2 * Lambda_0_0_p1) + Lambda_0_1_p3 * Lambda_0_0_p3 +
      Lambda_0_1_p4 * Lambda_0_0_p4;
  const Real Lambda_2_11_p11 = Lambda_2_11_p7 - Lambda_11_11_p4773_lanes[2] * Lambda_2_11_p4 -
      Lambda_11_11_p4794_lanes[2] * Lambda_2_11_p8 - Lambda_11_11_p4804 * Lambda_2_11_p10;
  const Real Lambda_3_11_p9 = Lambda_3_11_p6 - Lambda_11_11_p4794_lanes[2] * Lambda_3_11_p4 -
      Lambda_11_11_p4804 * Lambda_3_11_p8;
  const Real Lambda_4_11_p4 = Lambda_11_11_p4703_lanes[1] * Lambda_11_11_p4633_lanes[5] -
      Lambda_11_11_p4636_lanes[1] - Lambda_11_11_p4744_lanes[1] * Lambda_4_11_p1 -
      Lambda_11_11_p4773_lanes[1] * Lambda_4_11_p2 - Lambda_11_11_p4794_lanes[1] * Lambda_4_11_p3;
  const Real Lambda_4_11_p5 = Lambda_11_11_p4703_lanes[2] * Lambda_11_11_p4633_lanes[5] -
      Lambda_11_11_p4636_lanes[2] - Lambda_11_11_p4744_lanes[2] * Lambda_4_11_p1 -
      Lambda_11_11_p4773_lanes[2] * Lambda_4_11_p2 - Lambda_11_11_p4794_lanes[2] * Lambda_4_11_p3;
  const Real Lambda_0_5_p1 = Lambda_11_11_p4701 * Lambda_11_11_p4740;
  const Real Lambda_5_11_p2 = Lambda_11_11_p4744_lanes[0] * Lambda_11_11_p4701 -
      Lambda_11_11_p4703_lanes[0] - Lambda_11_11_p4773_lanes[0] * Lambda_5_11_p1;
  const Real Lambda_0_5_p2 = Lambda_5_11_p1 * Lambda_11_11_p4771;
  const Real Lambda_0_11_p9 = Lambda_0_11_p4 - Lambda_11_11_p4703_lanes[3] * Lambda_0_0_p4 -
      Lambda_11_11_p4744_lanes[3] * Lambda_0_0_p7 - Lambda_11_11_p4773_lanes[3] * Lambda_0_0_p14 -
      Lambda_11_11_p4794_lanes[3] * Lambda_0_11_p5;
  const Real Lambda_0_0_p17 = Lambda_0_11_p5 * Lambda_11_11_p4793;
  const Real Lambda_11_11_p4809 = Lambda_11_11_p4806 * Lambda_11_11_p4808;
  const Real Lambda_0_1_p8 = Lambda_1_11_p10 * Lambda_11_11_p4793;
  const Real Lambda_6_11_p1 = Lambda_11_11_p4773_lanes[0] * Lambda_11_11_p4743 -
      Lambda_11_11_p4744_lanes[0];
  const Real Lambda_0_2_p6 = Lambda_2_11_p8 * Lambda_11_11_p4793;
  const Real Lambda_4_11_p6 = Lambda_4_11_p5 - Lambda_11_11_p4804 * Lambda_4_11_p4;
  const Real Lambda_0_3_p5 = Lambda_3_11_p4 * Lambda_11_11_p4793;
  const Real Lambda_5_11_p3 = Lambda_11_11_p4744_lanes[1] * Lambda_11_11_p4701 -
      Lambda_11_11_p4703_lanes[1] - Lambda_11_11_p4773_lanes[1] * Lambda_5_11_p1 -
      Lambda_11_11_p4794_lanes[1] * Lambda_5_11_p2;
  const Real Lambda_4_11_p7 = Lambda_11_11_p4703_lanes[3] * Lambda_11_11_p4633_lanes[5] -
      Lambda_11_11_p4636_lanes[3] - Lambda_11_11_p4744_lanes[3] * Lambda_4_11_p1 -
      Lambda_11_11_p4773_lanes[3] * Lambda_4_11_p2 - Lambda_11_11_p4794_lanes[3] * Lambda_4_11_p3;
  const Real Lambda_0_6_p1 = Lambda_11_11_p4743 * Lambda_11_11_p4771;
  const Real Lambda_0_4_p4 = Lambda_4_11_p3 * Lambda_11_11_p4793;
  const Real Lambda_0_5_p3 = Lambda_5_11_p2 * Lambda_11_11_p4793;
  const Real Lambda_0_6_p2 = Lambda_6_11_p1 * Lambda_11_11_p4793;
  const Real Lambda_6_11_p2 = Lambda_11_11_p4773_lanes[1] * Lambda_11_11_p4743 -
      Lambda_11_11_p4744_lanes[1] - Lambda_11_11_p4794_lanes[1] * Lambda_6_11_p1;
  const Real Lambda_11_11 = 1.0 / (Lambda_11_11_p4807 - Lambda_11_11_p4809 * Lambda_11_11_p4806);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_7_11_p1 = Lambda_11_11_p4794_lanes[1] * Lambda_11_11_p4773_lanes[0] -
      Lambda_11_11_p4773_lanes[1];
  const Real Lambda_5_11_p4 = Lambda_11_11_p4744_lanes[2] * Lambda_11_11_p4701 -
      Lambda_11_11_p4703_lanes[2] - Lambda_11_11_p4773_lanes[2] * Lambda_5_11_p1 -
      Lambda_11_11_p4794_lanes[2] * Lambda_5_11_p2 - Lambda_11_11_p4804 * Lambda_5_11_p3;
  const Real Lambda_0_7_p1 = Lambda_11_11_p4773_lanes[0] * Lambda_11_11_p4793;
  const Real Lambda_0_2_p7 = Lambda_0_0_p9 - Lambda_0_2_p1 * Lambda_0_0_p2 + Lambda_0_2_p2 *
      Lambda_0_0_p3 + Lambda_0_2_p3 * Lambda_0_0_p4 + Lambda_0_2_p4 * Lambda_0_0_p7;
  const Real Lambda_6_11_p3 = Lambda_11_11_p4773_lanes[2] * Lambda_11_11_p4743 -
      Lambda_11_11_p4744_lanes[2] - Lambda_11_11_p4794_lanes[2] * Lambda_6_11_p1 -
      Lambda_11_11_p4804 * Lambda_6_11_p2;
  const Real Lambda_8_11_p1 = Lambda_11_11_p4804 * Lambda_11_11_p4794_lanes[1] -
      Lambda_11_11_p4794_lanes[2];
  const Real Lambda_7_11_p2 = Lambda_11_11_p4794_lanes[2] * Lambda_11_11_p4773_lanes[0] -
      Lambda_11_11_p4773_lanes[2] - Lambda_11_11_p4804 * Lambda_7_11_p1;
  const Real Lambda_0_0_p18 = Lambda_0_11_p6 * Lambda_11_11_p4803;
  const Real Lambda_1_11_p14 = Lambda_1_11_p11 - Lambda_11_11_p4744_lanes[3] * Lambda_1_11_p4 -
      Lambda_11_11_p4773_lanes[3] * Lambda_1_11_p8 - Lambda_11_11_p4794_lanes[3] * Lambda_1_11_p10 -
      Lambda_11_11_p4805 * Lambda_1_11_p12;
  const Real Lambda_0_1_p9 = Lambda_1_11_p12 * Lambda_11_11_p4803;
  const Real Lambda_0_2_p8 = Lambda_2_11_p10 * Lambda_11_11_p4803;
  const Real Lambda_0_3_p6 = Lambda_3_11_p8 * Lambda_11_11_p4803;
  const Real Lambda_0_4_p5 = Lambda_4_11_p4 * Lambda_11_11_p4803;
  const Real Lambda_5_11_p5 = Lambda_11_11_p4744_lanes[3] * Lambda_11_11_p4701 -
      Lambda_11_11_p4703_lanes[3] - Lambda_11_11_p4773_lanes[3] * Lambda_5_11_p1 -
      Lambda_11_11_p4794_lanes[3] * Lambda_5_11_p2 - Lambda_11_11_p4805 * Lambda_5_11_p3;
  const Real Lambda_0_5_p4 = Lambda_5_11_p3 * Lambda_11_11_p4803;
  const Real Lambda_0_6_p3 = Lambda_6_11_p2 * Lambda_11_11_p4803;
  const Real Lambda_0_7_p2 = Lambda_7_11_p1 * Lambda_11_11_p4803;
  const Real Lambda_0_8_p1 = Lambda_11_11_p4794_lanes[1] * Lambda_11_11_p4803;
  const Real Lambda_0_3_p7 = Lambda_0_0_p10 - Lambda_0_3_p3 * Lambda_0_0_p3 + Lambda_0_3_p2 *
      Lambda_0_0_p4 + Lambda_0_3_p1 * Lambda_0_0_p7 + Lambda_0_3_p4 * Lambda_0_0_p14;
  const Real Lambda_0_11_p10 = Lambda_0_11_p9 - Lambda_11_11_p4805 * Lambda_0_11_p6 -
      Lambda_11_11_p4809 * Lambda_0_11_p8;
  const Real Lambda_0_0_p19 = Lambda_0_11_p8 * Lambda_11_11_p4808;
  const Real Lambda_1_11_p15 = Lambda_1_11_p14 - Lambda_11_11_p4809 * Lambda_1_11_p13;
  const Real Lambda_0_1_p10 = Lambda_1_11_p13 * Lambda_11_11_p4808;
  const Real Lambda_2_11_p12 = Lambda_2_11_p9 - Lambda_11_11_p4773_lanes[3] * Lambda_2_11_p4 -
      Lambda_11_11_p4794_lanes[3] * Lambda_2_11_p8 - Lambda_11_11_p4805 * Lambda_2_11_p10 -
      Lambda_11_11_p4809 * Lambda_2_11_p11;
  const Real Lambda_1_1_p1 = Lambda_11_11_p4005 + Lambda_0_1_p2 * Lambda_11_11_p4126_lanes[2] +
      Lambda_0_1_p1 * Lambda_1_11_p1 + Lambda_0_1_p3 * Lambda_1_11_p2 + Lambda_0_1_p4 *
      Lambda_1_11_p3;
  const Real Lambda_0_2_p9 = Lambda_2_11_p11 * Lambda_11_11_p4808;
  const Real Lambda_3_11_p10 = Lambda_3_11_p7 - Lambda_11_11_p4794_lanes[3] * Lambda_3_11_p4 -
      Lambda_11_11_p4805 * Lambda_3_11_p8 - Lambda_11_11_p4809 * Lambda_3_11_p9;
  const Real Lambda_0_3_p8 = Lambda_3_11_p9 * Lambda_11_11_p4808;
  const Real Lambda_4_11_p8 = Lambda_4_11_p7 - Lambda_11_11_p4805 * Lambda_4_11_p4 -
      Lambda_11_11_p4809 * Lambda_4_11_p6;
  const Real Lambda_0_4_p6 = Lambda_4_11_p6 * Lambda_11_11_p4808;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_11_11_p4809 * Lambda_5_11_p4;
  const Real Lambda_0_5_p5 = Lambda_5_11_p4 * Lambda_11_11_p4808;
  const Real Lambda_6_11_p4 = Lambda_11_11_p4773_lanes[3] * Lambda_11_11_p4743 -
      Lambda_11_11_p4744_lanes[3] - Lambda_11_11_p4794_lanes[3] * Lambda_6_11_p1 -
      Lambda_11_11_p4805 * Lambda_6_11_p2 - Lambda_11_11_p4809 * Lambda_6_11_p3;
  const Real Lambda_0_6_p4 = Lambda_6_11_p3 * Lambda_11_11_p4808;
  const Real Lambda_7_11_p3 = Lambda_11_11_p4794_lanes[3] * Lambda_11_11_p4773_lanes[0] -
      Lambda_11_11_p4773_lanes[3] - Lambda_11_11_p4805 * Lambda_7_11_p1 - Lambda_11_11_p4809 *
      Lambda_7_11_p2;
  const Real Lambda_1_2_p1 = Lambda_0_2_p2 * Lambda_1_11_p2 -
      (Lambda_0_1_p2 + Lambda_0_2_p1 * Lambda_1_11_p1) + Lambda_0_2_p3 * Lambda_1_11_p3 +
      Lambda_0_2_p4 * Lambda_1_11_p4;
  const Real Lambda_0_7_p3 = Lambda_7_11_p2 * Lambda_11_11_p4808;
  const Real Lambda_8_11_p2 = Lambda_11_11_p4805 * Lambda_11_11_p4794_lanes[1] -
      Lambda_11_11_p4794_lanes[3] - Lambda_11_11_p4809 * Lambda_8_11_p1;
  const Real Lambda_0_8_p2 = Lambda_8_11_p1 * Lambda_11_11_p4808;
  const Real Lambda_9_11_p1 = Lambda_11_11_p4809 * Lambda_11_11_p4804 - Lambda_11_11_p4805;
  const Real Lambda_0_9_p1 = Lambda_11_11_p4804 * Lambda_11_11_p4808;
  const Real Lambda_1_3_p1 = Lambda_0_1_p1 - Lambda_0_3_p3 * Lambda_1_11_p2 + Lambda_0_3_p2 *
      Lambda_1_11_p3 + Lambda_0_3_p1 * Lambda_1_11_p4 + Lambda_0_3_p4 * Lambda_1_11_p8;
  const Real Lambda_0_0_p20 = Lambda_0_0_p15 + Lambda_0_0_p12 * Lambda_0_0_p4 + Lambda_0_0_p13 *
      Lambda_0_0_p7 + Lambda_0_0_p16 * Lambda_0_0_p14 + Lambda_0_0_p17 * Lambda_0_11_p5;
  const Real Lambda_0_4_p7 = Lambda_0_0_p11 - Lambda_0_4_p1 * Lambda_0_0_p4 + Lambda_0_4_p2 *
      Lambda_0_0_p7 + Lambda_0_4_p3 * Lambda_0_0_p14 + Lambda_0_4_p4 * Lambda_0_11_p5;
  const Real Lambda_1_4_p1 = Lambda_0_1_p3 - Lambda_0_4_p1 * Lambda_1_11_p3 + Lambda_0_4_p2 *
      Lambda_1_11_p4 + Lambda_0_4_p3 * Lambda_1_11_p8 + Lambda_0_4_p4 * Lambda_1_11_p10;
  const Real Lambda_0_11 = Lambda_0_11_p10 * Lambda_11_11;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_1_11 = Lambda_1_11_p15 * Lambda_11_11;
  Lambda[23] = Lambda_1_11;
  Lambda[133] = Lambda_1_11;
  const Real Lambda_2_11 = Lambda_2_11_p12 * Lambda_11_11;
  Lambda[35] = Lambda_2_11;
  Lambda[134] = Lambda_2_11;
  const Real Lambda_3_11 = Lambda_3_11_p10 * Lambda_11_11;
  Lambda[47] = Lambda_3_11;
  Lambda[135] = Lambda_3_11;
  const Real Lambda_4_11 = Lambda_4_11_p8 * Lambda_11_11;
  Lambda[59] = Lambda_4_11;
  Lambda[136] = Lambda_4_11;
  const Real Lambda_5_11 = Lambda_5_11_p6 * Lambda_11_11;
  Lambda[71] = Lambda_5_11;
  Lambda[137] = Lambda_5_11;
  const Real Lambda_6_11 = Lambda_6_11_p4 * Lambda_11_11;
  Lambda[83] = Lambda_6_11;
  Lambda[138] = Lambda_6_11;
  const Real Lambda_7_11 = Lambda_7_11_p3 * Lambda_11_11;
  Lambda[95] = Lambda_7_11;
  Lambda[139] = Lambda_7_11;
  const Real Lambda_8_11 = Lambda_8_11_p2 * Lambda_11_11;
  Lambda[107] = Lambda_8_11;
  Lambda[140] = Lambda_8_11;
  const Real Lambda_9_11 = Lambda_9_11_p1 * Lambda_11_11;
  Lambda[119] = Lambda_9_11;
  Lambda[141] = Lambda_9_11;
  const Real Lambda_2_2_p1 = Lambda_11_11_p4205 + Lambda_0_2_p1 * Lambda_11_11_p4324_lanes[3] +
      Lambda_0_2_p2 * Lambda_2_11_p1 + Lambda_0_2_p3 * Lambda_2_11_p2 + Lambda_0_2_p4 *
      Lambda_2_11_p3;
  const Real Lambda_10_11 = Lambda_11_11_p4809 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real Lambda_2_3_p1 = Lambda_0_3_p2 * Lambda_2_11_p2 -
      (Lambda_0_2_p1 + Lambda_0_3_p3 * Lambda_2_11_p1) + Lambda_0_3_p1 * Lambda_2_11_p3 +
      Lambda_0_3_p4 * Lambda_2_11_p4;
  const Real Lambda_2_4_p1 = Lambda_0_2_p2 - Lambda_0_4_p1 * Lambda_2_11_p2 + Lambda_0_4_p2 *
      Lambda_2_11_p3 + Lambda_0_4_p3 * Lambda_2_11_p4 + Lambda_0_4_p4 * Lambda_2_11_p8;
  const Real Lambda_0_1_p11 = Lambda_0_1_p7 + Lambda_0_1_p5 * Lambda_0_0_p7 + Lambda_0_1_p6 *
      Lambda_0_0_p14 + Lambda_0_1_p8 * Lambda_0_11_p5 + Lambda_0_1_p9 * Lambda_0_11_p6;
  const Real Lambda_0_5_p6 = Lambda_0_0_p12 - Lambda_0_5_p1 * Lambda_0_0_p7 + Lambda_0_5_p2 *
      Lambda_0_0_p14 + Lambda_0_5_p3 * Lambda_0_11_p5 + Lambda_0_5_p4 * Lambda_0_11_p6;
  const Real Lambda_3_3_p1 = Lambda_11_11_p4425 + Lambda_0_3_p3 * Lambda_11_11_p4518_lanes[4] +
      Lambda_0_3_p2 * Lambda_3_11_p1 + Lambda_0_3_p1 * Lambda_3_11_p2 + Lambda_0_3_p4 *
      Lambda_3_11_p3;
  const Real Lambda_1_1_p2 = Lambda_1_1_p1 + Lambda_0_1_p5 * Lambda_1_11_p4 + Lambda_0_1_p6 *
      Lambda_1_11_p8 + Lambda_0_1_p8 * Lambda_1_11_p10 + Lambda_0_1_p9 * Lambda_1_11_p12;
  const Real Lambda_1_5_p1 = Lambda_0_1_p4 - Lambda_0_5_p1 * Lambda_1_11_p4 + Lambda_0_5_p2 *
      Lambda_1_11_p8 + Lambda_0_5_p3 * Lambda_1_11_p10 + Lambda_0_5_p4 * Lambda_1_11_p12;
  const Real Lambda_3_4_p1 = Lambda_0_4_p2 * Lambda_3_11_p2 -
      (Lambda_0_3_p3 + Lambda_0_4_p1 * Lambda_3_11_p1) + Lambda_0_4_p3 * Lambda_3_11_p3 +
      Lambda_0_4_p4 * Lambda_3_11_p4;
  const Real Lambda_2_5_p1 = Lambda_0_2_p3 - Lambda_0_5_p1 * Lambda_2_11_p3 + Lambda_0_5_p2 *
      Lambda_2_11_p4 + Lambda_0_5_p3 * Lambda_2_11_p8 + Lambda_0_5_p4 * Lambda_2_11_p10;
  const Real Lambda_3_5_p1 = Lambda_0_3_p2 - Lambda_0_5_p1 * Lambda_3_11_p2 + Lambda_0_5_p2 *
      Lambda_3_11_p3 + Lambda_0_5_p3 * Lambda_3_11_p4 + Lambda_0_5_p4 * Lambda_3_11_p8;
  const Real Lambda_4_4_p1 = Lambda_11_11_p4600 + Lambda_0_4_p1 * Lambda_11_11_p4633_lanes[5] +
      Lambda_0_4_p2 * Lambda_4_11_p1 + Lambda_0_4_p3 * Lambda_4_11_p2 + Lambda_0_4_p4 *
      Lambda_4_11_p3;
  const Real Lambda_4_5_p1 = Lambda_0_5_p2 * Lambda_4_11_p2 -
      (Lambda_0_4_p1 + Lambda_0_5_p1 * Lambda_4_11_p1) + Lambda_0_5_p3 * Lambda_4_11_p3 +
      Lambda_0_5_p4 * Lambda_4_11_p4;
  const Real Lambda_5_5_p1 = Lambda_11_11_p4692 + Lambda_0_5_p1 * Lambda_11_11_p4701 +
      Lambda_0_5_p2 * Lambda_5_11_p1 + Lambda_0_5_p3 * Lambda_5_11_p2 + Lambda_0_5_p4 *
      Lambda_5_11_p3;
  const Real Lambda_0_2_p10 = Lambda_0_2_p7 + Lambda_0_2_p5 * Lambda_0_0_p14 + Lambda_0_2_p6 *
      Lambda_0_11_p5 + Lambda_0_2_p8 * Lambda_0_11_p6 + Lambda_0_2_p9 * Lambda_0_11_p8;
  const Real Lambda_0_6_p5 = Lambda_0_0_p13 - Lambda_0_6_p1 * Lambda_0_0_p14 + Lambda_0_6_p2 *
      Lambda_0_11_p5 + Lambda_0_6_p3 * Lambda_0_11_p6 + Lambda_0_6_p4 * Lambda_0_11_p8;
  const Real Lambda_1_2_p2 = Lambda_1_2_p1 + Lambda_0_2_p5 * Lambda_1_11_p8 + Lambda_0_2_p6 *
      Lambda_1_11_p10 + Lambda_0_2_p8 * Lambda_1_11_p12 + Lambda_0_2_p9 * Lambda_1_11_p13;
  const Real Lambda_1_6_p1 = Lambda_0_1_p5 - Lambda_0_6_p1 * Lambda_1_11_p8 + Lambda_0_6_p2 *
      Lambda_1_11_p10 + Lambda_0_6_p3 * Lambda_1_11_p12 + Lambda_0_6_p4 * Lambda_1_11_p13;
  const Real Lambda_2_2_p2 = Lambda_2_2_p1 + Lambda_0_2_p5 * Lambda_2_11_p4 + Lambda_0_2_p6 *
      Lambda_2_11_p8 + Lambda_0_2_p8 * Lambda_2_11_p10 + Lambda_0_2_p9 * Lambda_2_11_p11;
  const Real Lambda_2_6_p1 = Lambda_0_2_p4 - Lambda_0_6_p1 * Lambda_2_11_p4 + Lambda_0_6_p2 *
      Lambda_2_11_p8 + Lambda_0_6_p3 * Lambda_2_11_p10 + Lambda_0_6_p4 * Lambda_2_11_p11;
  const Real Lambda_3_6_p1 = Lambda_0_3_p1 - Lambda_0_6_p1 * Lambda_3_11_p3 + Lambda_0_6_p2 *
      Lambda_3_11_p4 + Lambda_0_6_p3 * Lambda_3_11_p8 + Lambda_0_6_p4 * Lambda_3_11_p9;
  const Real Lambda_4_6_p1 = Lambda_0_4_p2 - Lambda_0_6_p1 * Lambda_4_11_p2 + Lambda_0_6_p2 *
      Lambda_4_11_p3 + Lambda_0_6_p3 * Lambda_4_11_p4 + Lambda_0_6_p4 * Lambda_4_11_p6;
  const Real Lambda_5_6_p1 = Lambda_0_6_p2 * Lambda_5_11_p2 -
      (Lambda_0_5_p1 + Lambda_0_6_p1 * Lambda_5_11_p1) + Lambda_0_6_p3 * Lambda_5_11_p3 +
      Lambda_0_6_p4 * Lambda_5_11_p4;
  const Real Lambda_6_6_p1 = Lambda_11_11_p4740 + Lambda_0_6_p1 * Lambda_11_11_p4743 +
      Lambda_0_6_p2 * Lambda_6_11_p1 + Lambda_0_6_p3 * Lambda_6_11_p2 + Lambda_0_6_p4 *
      Lambda_6_11_p3;
  Lambda[0] = Lambda_0_0_p20 + Lambda_0_0_p18 * Lambda_0_11_p6 + Lambda_0_0_p19 * Lambda_0_11_p8 +
      Lambda_0_11 * Lambda_0_11_p10;
  const Real Lambda_0_1 = Lambda_0_1_p11 + Lambda_0_1_p10 * Lambda_0_11_p8 + Lambda_1_11 *
      Lambda_0_11_p10;
  Lambda[1] = Lambda_0_1;
  Lambda[12] = Lambda_0_1;
  const Real Lambda_0_2 = Lambda_0_2_p10 + Lambda_2_11 * Lambda_0_11_p10;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_0_3 = Lambda_0_3_p7 + Lambda_0_3_p5 * Lambda_0_11_p5 + Lambda_0_3_p6 *
      Lambda_0_11_p6 + Lambda_0_3_p8 * Lambda_0_11_p8 + Lambda_3_11 * Lambda_0_11_p10;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_0_4 = Lambda_0_4_p7 + Lambda_0_4_p5 * Lambda_0_11_p6 + Lambda_0_4_p6 *
      Lambda_0_11_p8 + Lambda_4_11 * Lambda_0_11_p10;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_0_5 = Lambda_0_5_p6 + Lambda_0_5_p5 * Lambda_0_11_p8 + Lambda_5_11 *
      Lambda_0_11_p10;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_0_6 = Lambda_0_6_p5 + Lambda_6_11 * Lambda_0_11_p10;
  Lambda[6] = Lambda_0_6;
  Lambda[72] = Lambda_0_6;
  const Real Lambda_0_7 = Lambda_0_0_p16 - Lambda_0_7_p1 * Lambda_0_11_p5 + Lambda_0_7_p2 *
      Lambda_0_11_p6 + Lambda_0_7_p3 * Lambda_0_11_p8 + Lambda_7_11 * Lambda_0_11_p10;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_0_8 = Lambda_0_0_p17 - Lambda_0_8_p1 * Lambda_0_11_p6 + Lambda_0_8_p2 *
      Lambda_0_11_p8 + Lambda_8_11 * Lambda_0_11_p10;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_0_9 = Lambda_0_0_p18 - Lambda_0_9_p1 * Lambda_0_11_p8 + Lambda_9_11 *
      Lambda_0_11_p10;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_0_10 = Lambda_0_0_p19 - Lambda_10_11 * Lambda_0_11_p10;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  Lambda[13] = Lambda_1_1_p2 + Lambda_0_1_p10 * Lambda_1_11_p13 + Lambda_1_11 * Lambda_1_11_p15;
  const Real Lambda_1_2 = Lambda_1_2_p2 + Lambda_2_11 * Lambda_1_11_p15;
  Lambda[14] = Lambda_1_2;
  Lambda[25] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_1_3_p1 + Lambda_0_3_p5 * Lambda_1_11_p10 + Lambda_0_3_p6 *
      Lambda_1_11_p12 + Lambda_0_3_p8 * Lambda_1_11_p13 + Lambda_3_11 * Lambda_1_11_p15;
  Lambda[15] = Lambda_1_3;
  Lambda[37] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_1_4_p1 + Lambda_0_4_p5 * Lambda_1_11_p12 + Lambda_0_4_p6 *
      Lambda_1_11_p13 + Lambda_4_11 * Lambda_1_11_p15;
  Lambda[16] = Lambda_1_4;
  Lambda[49] = Lambda_1_4;
  const Real Lambda_1_5 = Lambda_1_5_p1 + Lambda_0_5_p5 * Lambda_1_11_p13 + Lambda_5_11 *
      Lambda_1_11_p15;
  Lambda[17] = Lambda_1_5;
  Lambda[61] = Lambda_1_5;
  const Real Lambda_1_6 = Lambda_1_6_p1 + Lambda_6_11 * Lambda_1_11_p15;
  Lambda[18] = Lambda_1_6;
  Lambda[73] = Lambda_1_6;
  const Real Lambda_1_7 = Lambda_0_1_p6 - Lambda_0_7_p1 * Lambda_1_11_p10 + Lambda_0_7_p2 *
      Lambda_1_11_p12 + Lambda_0_7_p3 * Lambda_1_11_p13 + Lambda_7_11 * Lambda_1_11_p15;
  Lambda[19] = Lambda_1_7;
  Lambda[85] = Lambda_1_7;
  const Real Lambda_1_8 = Lambda_0_1_p8 - Lambda_0_8_p1 * Lambda_1_11_p12 + Lambda_0_8_p2 *
      Lambda_1_11_p13 + Lambda_8_11 * Lambda_1_11_p15;
  Lambda[20] = Lambda_1_8;
  Lambda[97] = Lambda_1_8;
  const Real Lambda_1_9 = Lambda_0_1_p9 - Lambda_0_9_p1 * Lambda_1_11_p13 + Lambda_9_11 *
      Lambda_1_11_p15;
  Lambda[21] = Lambda_1_9;
  Lambda[109] = Lambda_1_9;
  const Real Lambda_1_10 = Lambda_0_1_p10 - Lambda_10_11 * Lambda_1_11_p15;
  Lambda[22] = Lambda_1_10;
  Lambda[121] = Lambda_1_10;
  Lambda[26] = Lambda_2_2_p2 + Lambda_2_11 * Lambda_2_11_p12;
  const Real Lambda_2_3 = Lambda_2_3_p1 + Lambda_0_3_p5 * Lambda_2_11_p8 + Lambda_0_3_p6 *
      Lambda_2_11_p10 + Lambda_0_3_p8 * Lambda_2_11_p11 + Lambda_3_11 * Lambda_2_11_p12;
  Lambda[27] = Lambda_2_3;
  Lambda[38] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_2_4_p1 + Lambda_0_4_p5 * Lambda_2_11_p10 + Lambda_0_4_p6 *
      Lambda_2_11_p11 + Lambda_4_11 * Lambda_2_11_p12;
  Lambda[28] = Lambda_2_4;
  Lambda[50] = Lambda_2_4;
  const Real Lambda_2_5 = Lambda_2_5_p1 + Lambda_0_5_p5 * Lambda_2_11_p11 + Lambda_5_11 *
      Lambda_2_11_p12;
  Lambda[29] = Lambda_2_5;
  Lambda[62] = Lambda_2_5;
  const Real Lambda_2_6 = Lambda_2_6_p1 + Lambda_6_11 * Lambda_2_11_p12;
  Lambda[30] = Lambda_2_6;
  Lambda[74] = Lambda_2_6;
  const Real Lambda_2_7 = Lambda_0_2_p5 - Lambda_0_7_p1 * Lambda_2_11_p8 + Lambda_0_7_p2 *
      Lambda_2_11_p10 + Lambda_0_7_p3 * Lambda_2_11_p11 + Lambda_7_11 * Lambda_2_11_p12;
  Lambda[31] = Lambda_2_7;
  Lambda[86] = Lambda_2_7;
  const Real Lambda_2_8 = Lambda_0_2_p6 - Lambda_0_8_p1 * Lambda_2_11_p10 + Lambda_0_8_p2 *
      Lambda_2_11_p11 + Lambda_8_11 * Lambda_2_11_p12;
  Lambda[32] = Lambda_2_8;
  Lambda[98] = Lambda_2_8;
  const Real Lambda_2_9 = Lambda_0_2_p8 - Lambda_0_9_p1 * Lambda_2_11_p11 + Lambda_9_11 *
      Lambda_2_11_p12;
  Lambda[33] = Lambda_2_9;
  Lambda[110] = Lambda_2_9;
  const Real Lambda_2_10 = Lambda_0_2_p9 - Lambda_10_11 * Lambda_2_11_p12;
  Lambda[34] = Lambda_2_10;
  Lambda[122] = Lambda_2_10;
  Lambda[39] = Lambda_3_3_p1 + Lambda_0_3_p5 * Lambda_3_11_p4 + Lambda_0_3_p6 * Lambda_3_11_p8 +
      Lambda_0_3_p8 * Lambda_3_11_p9 + Lambda_3_11 * Lambda_3_11_p10;
  const Real Lambda_3_4 = Lambda_3_4_p1 + Lambda_0_4_p5 * Lambda_3_11_p8 + Lambda_0_4_p6 *
      Lambda_3_11_p9 + Lambda_4_11 * Lambda_3_11_p10;
  Lambda[40] = Lambda_3_4;
  Lambda[51] = Lambda_3_4;
  const Real Lambda_3_5 = Lambda_3_5_p1 + Lambda_0_5_p5 * Lambda_3_11_p9 + Lambda_5_11 *
      Lambda_3_11_p10;
  Lambda[41] = Lambda_3_5;
  Lambda[63] = Lambda_3_5;
  const Real Lambda_3_6 = Lambda_3_6_p1 + Lambda_6_11 * Lambda_3_11_p10;
  Lambda[42] = Lambda_3_6;
  Lambda[75] = Lambda_3_6;
  const Real Lambda_3_7 = Lambda_0_3_p4 - Lambda_0_7_p1 * Lambda_3_11_p4 + Lambda_0_7_p2 *
      Lambda_3_11_p8 + Lambda_0_7_p3 * Lambda_3_11_p9 + Lambda_7_11 * Lambda_3_11_p10;
  Lambda[43] = Lambda_3_7;
  Lambda[87] = Lambda_3_7;
  const Real Lambda_3_8 = Lambda_0_3_p5 - Lambda_0_8_p1 * Lambda_3_11_p8 + Lambda_0_8_p2 *
      Lambda_3_11_p9 + Lambda_8_11 * Lambda_3_11_p10;
  Lambda[44] = Lambda_3_8;
  Lambda[99] = Lambda_3_8;
  const Real Lambda_3_9 = Lambda_0_3_p6 - Lambda_0_9_p1 * Lambda_3_11_p9 + Lambda_9_11 *
      Lambda_3_11_p10;
  Lambda[45] = Lambda_3_9;
  Lambda[111] = Lambda_3_9;
  const Real Lambda_3_10 = Lambda_0_3_p8 - Lambda_10_11 * Lambda_3_11_p10;
  Lambda[46] = Lambda_3_10;
  Lambda[123] = Lambda_3_10;
  Lambda[52] = Lambda_4_4_p1 + Lambda_0_4_p5 * Lambda_4_11_p4 + Lambda_0_4_p6 * Lambda_4_11_p6 +
      Lambda_4_11 * Lambda_4_11_p8;
  const Real Lambda_4_5 = Lambda_4_5_p1 + Lambda_0_5_p5 * Lambda_4_11_p6 + Lambda_5_11 *
      Lambda_4_11_p8;
  Lambda[53] = Lambda_4_5;
  Lambda[64] = Lambda_4_5;
  const Real Lambda_4_6 = Lambda_4_6_p1 + Lambda_6_11 * Lambda_4_11_p8;
  Lambda[54] = Lambda_4_6;
  Lambda[76] = Lambda_4_6;
  const Real Lambda_4_7 = Lambda_0_4_p3 - Lambda_0_7_p1 * Lambda_4_11_p3 + Lambda_0_7_p2 *
      Lambda_4_11_p4 + Lambda_0_7_p3 * Lambda_4_11_p6 + Lambda_7_11 * Lambda_4_11_p8;
  Lambda[55] = Lambda_4_7;
  Lambda[88] = Lambda_4_7;
  const Real Lambda_4_8 = Lambda_0_4_p4 - Lambda_0_8_p1 * Lambda_4_11_p4 + Lambda_0_8_p2 *
      Lambda_4_11_p6 + Lambda_8_11 * Lambda_4_11_p8;
  Lambda[56] = Lambda_4_8;
  Lambda[100] = Lambda_4_8;
  const Real Lambda_4_9 = Lambda_0_4_p5 - Lambda_0_9_p1 * Lambda_4_11_p6 + Lambda_9_11 *
      Lambda_4_11_p8;
  Lambda[57] = Lambda_4_9;
  Lambda[112] = Lambda_4_9;
  const Real Lambda_4_10 = Lambda_0_4_p6 - Lambda_10_11 * Lambda_4_11_p8;
  Lambda[58] = Lambda_4_10;
  Lambda[124] = Lambda_4_10;
  Lambda[65] = Lambda_5_5_p1 + Lambda_0_5_p5 * Lambda_5_11_p4 + Lambda_5_11 * Lambda_5_11_p6;
  const Real Lambda_5_6 = Lambda_5_6_p1 + Lambda_6_11 * Lambda_5_11_p6;
  Lambda[66] = Lambda_5_6;
  Lambda[77] = Lambda_5_6;
  const Real Lambda_5_7 = Lambda_0_5_p2 - Lambda_0_7_p1 * Lambda_5_11_p2 + Lambda_0_7_p2 *
      Lambda_5_11_p3 + Lambda_0_7_p3 * Lambda_5_11_p4 + Lambda_7_11 * Lambda_5_11_p6;
  Lambda[67] = Lambda_5_7;
  Lambda[89] = Lambda_5_7;
  const Real Lambda_5_8 = Lambda_0_5_p3 - Lambda_0_8_p1 * Lambda_5_11_p3 + Lambda_0_8_p2 *
      Lambda_5_11_p4 + Lambda_8_11 * Lambda_5_11_p6;
  Lambda[68] = Lambda_5_8;
  Lambda[101] = Lambda_5_8;
  const Real Lambda_5_9 = Lambda_0_5_p4 - Lambda_0_9_p1 * Lambda_5_11_p4 + Lambda_9_11 *
      Lambda_5_11_p6;
  Lambda[69] = Lambda_5_9;
  Lambda[113] = Lambda_5_9;
  const Real Lambda_5_10 = Lambda_0_5_p5 - Lambda_10_11 * Lambda_5_11_p6;
  Lambda[70] = Lambda_5_10;
  Lambda[125] = Lambda_5_10;
  Lambda[78] = Lambda_6_6_p1 + Lambda_6_11 * Lambda_6_11_p4;
  const Real Lambda_6_7 = Lambda_0_7_p2 * Lambda_6_11_p2 -
      (Lambda_0_6_p1 + Lambda_0_7_p1 * Lambda_6_11_p1) + Lambda_0_7_p3 * Lambda_6_11_p3 +
      Lambda_7_11 * Lambda_6_11_p4;
  Lambda[79] = Lambda_6_7;
  Lambda[90] = Lambda_6_7;
  const Real Lambda_6_8 = Lambda_0_6_p2 - Lambda_0_8_p1 * Lambda_6_11_p2 + Lambda_0_8_p2 *
      Lambda_6_11_p3 + Lambda_8_11 * Lambda_6_11_p4;
  Lambda[80] = Lambda_6_8;
  Lambda[102] = Lambda_6_8;
  const Real Lambda_6_9 = Lambda_0_6_p3 - Lambda_0_9_p1 * Lambda_6_11_p3 + Lambda_9_11 *
      Lambda_6_11_p4;
  Lambda[81] = Lambda_6_9;
  Lambda[114] = Lambda_6_9;
  const Real Lambda_6_10 = Lambda_0_6_p4 - Lambda_10_11 * Lambda_6_11_p4;
  Lambda[82] = Lambda_6_10;
  Lambda[126] = Lambda_6_10;
  Lambda[91] = Lambda_11_11_p4771 + Lambda_0_7_p1 * Lambda_11_11_p4773_lanes[0] + Lambda_0_7_p2 *
      Lambda_7_11_p1 + Lambda_0_7_p3 * Lambda_7_11_p2 + Lambda_7_11 * Lambda_7_11_p3;
  const Real Lambda_7_8 = Lambda_0_8_p2 * Lambda_7_11_p2 -
      (Lambda_0_7_p1 + Lambda_0_8_p1 * Lambda_7_11_p1) + Lambda_8_11 * Lambda_7_11_p3;
  Lambda[92] = Lambda_7_8;
  Lambda[103] = Lambda_7_8;
  const Real Lambda_7_9 = Lambda_0_7_p2 - Lambda_0_9_p1 * Lambda_7_11_p2 + Lambda_9_11 *
      Lambda_7_11_p3;
  Lambda[93] = Lambda_7_9;
  Lambda[115] = Lambda_7_9;
  const Real Lambda_7_10 = Lambda_0_7_p3 - Lambda_10_11 * Lambda_7_11_p3;
  Lambda[94] = Lambda_7_10;
  Lambda[127] = Lambda_7_10;
  Lambda[104] = Lambda_11_11_p4793 + Lambda_0_8_p1 * Lambda_11_11_p4794_lanes[1] + Lambda_0_8_p2 *
      Lambda_8_11_p1 + Lambda_8_11 * Lambda_8_11_p2;
  const Real Lambda_8_9 = Lambda_9_11 * Lambda_8_11_p2 -
      (Lambda_0_8_p1 + Lambda_0_9_p1 * Lambda_8_11_p1);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p2 - Lambda_10_11 * Lambda_8_11_p2;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = Lambda_11_11_p4803 + Lambda_0_9_p1 * Lambda_11_11_p4804 + Lambda_9_11 *
      Lambda_9_11_p1;
  const Real Lambda_9_10 = Lambda_0_9_p1 + Lambda_10_11 * Lambda_9_11_p1;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_11_11_p4808 + Lambda_10_11 * Lambda_11_11_p4809;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
