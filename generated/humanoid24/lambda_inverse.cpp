// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in lanes.
// 6533 flops (add 2756, mul 3745, div 32), sine and cosine of 24 angles
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
void lambda_inverse(const Real (&TREELINE_RESTRICT q)[24],
    Real (&TREELINE_RESTRICT Lambda_inv)[144]) noexcept {
  const Real angles[24] = {q[12], q[10], q[8], q[7], q[6], q[5], q[4], q[3], q[2], q[1], q[0], q[9],
      q[11], q[21], q[23], q[22], q[20], q[18], q[19], q[17], q[16], q[15], q[14], q[13]};
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
  const Real c3 = cosines[8];
  const Real c2 = cosines[9];
  const Real c1 = cosines[10];
  const Real s2 = sines[9];
  const Real s1 = sines[10];
  const Real s3 = sines[8];
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
  const Real s19 = sines[17];
  const Real c19 = cosines[17];
  const Real s20 = sines[18];
  const Real c20 = cosines[18];
  const Real s18 = sines[19];
  const Real c18 = cosines[19];
  const Real s17 = sines[20];
  const Real c17 = cosines[20];
  const Real c16 = cosines[21];
  const Real s16 = sines[21];
  const Real s15 = sines[22];
  const Real c15 = cosines[22];
  const Real c14 = cosines[23];
  const Real s14 = sines[23];

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p11_lanes = 2.0 * detail::make_pack<Real>(c11, c18);

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D12_p3_lanes = detail::make_pack<Real>((-0.0007660844555829042),
      (-0.0007660844555829042)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.0002628975791811551, (-0.0002628975791811551)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p12_lanes = detail::make_pack<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.001742099791326752, 0.001742099791326752) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p14_lanes = detail::make_pack<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.27310176737964387), (-0.27310176737964387)) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> inverse_D12_p4_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D10_p16_lanes = detail::make_pack<Real>(c13, c20) * inverse_D10_p12_lanes;
  const Lanes<2> inverse_D10_p17_lanes = detail::make_pack<Real>(s13, s20) * inverse_D10_p12_lanes;
  const Lanes<2> inverse_D10_p18_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(s13, s20) - 0.01626499875 *
      detail::make_pack<Real>(c13, c20) - 0.0006000000000000001;
  const Lanes<2> inverse_D10_p19_lanes = detail::make_pack<Real>(s13, s20) * inverse_D10_p14_lanes;
  const Lanes<2> inverse_D11_p2_lanes = detail::make_pack<Real>((-0.00013384878959057754),
      0.00013384878959057754) + detail::make_pack<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D10_p21_lanes = 0.0006340258712020409 + inverse_D10_p16_lanes;
  const Lanes<2> inverse_D10_p22_lanes = inverse_D10_p17_lanes -
      detail::make_pack<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p1_lanes = 2.0 * detail::make_pack<Real>(c10, c17);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (inverse_D12_p4_lanes -
      detail::make_pack<Real>((-0.0010519177038056625), (-0.0010519177038056625)));
  const Lanes<2> inverse_D11_p4_lanes = inverse_D11_p2_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p28_lanes = inverse_D10_p21_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p29_lanes = inverse_D10_p18_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p30_lanes = inverse_D10_p22_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p35_lanes = inverse_D10_p18_lanes * inverse_D10_p28_lanes;
  const Lanes<2> inverse_D10_p36_lanes = inverse_D10_p18_lanes * inverse_D10_p29_lanes;
  const Lanes<2> inverse_D10_p39_lanes = inverse_D10_p18_lanes * inverse_D10_p30_lanes;
  const Lanes<2> inverse_D11_p6_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes -
      inverse_D11_p2_lanes * inverse_D11_p4_lanes;
  const Lanes<2> inverse_D10_p40_lanes = detail::make_pack<Real>((-0.00033044389597753786),
      0.00033044389597753786) + inverse_D10_p17_lanes + inverse_D11_p2_lanes *
      inverse_D10_p28_lanes;
  const Lanes<2> inverse_D10_p41_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(c13, c20) + 0.01626499875 *
      detail::make_pack<Real>(s13, s20) - inverse_D11_p2_lanes * inverse_D10_p29_lanes;
  const Lanes<2> inverse_D10_p42_lanes = inverse_D10_p16_lanes -
      detail::make_pack<Real>(0.002376125662528793, 0.002376125662528793) - inverse_D11_p2_lanes *
      inverse_D10_p30_lanes;
  const Lanes<2> inverse_D10_p43_lanes = detail::make_pack<Real>(0.008744893195371809,
      0.008744893195371809) + inverse_D10_p19_lanes + inverse_D10_p21_lanes * inverse_D10_p28_lanes;
  const Lanes<2> inverse_D10_p45_lanes = detail::make_pack<Real>(c13, c20) * inverse_D10_p14_lanes -
      detail::make_pack<Real>((-0.04964593582762564), 0.04964593582762564) - inverse_D10_p21_lanes *
      inverse_D10_p30_lanes;
  const Lanes<2> inverse_D10_p46_lanes = inverse_D10_p19_lanes - 0.2818466605750157 -
      inverse_D10_p22_lanes * inverse_D10_p30_lanes;
  const Lanes<2> inverse_D11_p8_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p6_lanes);
  const Lanes<2> inverse_D10_p56_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p40_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p41_lanes;
  const Lanes<2> inverse_D10_p57_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p42_lanes;
  const Lanes<2> inverse_D10_p59_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p42_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> inverse_D10_p60_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p39_lanes +
      detail::make_pack<Real>(s12, s19) * inverse_D10_p45_lanes;
  const Lanes<2> inverse_D11_p9_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p8_lanes;
  const Lanes<2> inverse_D10_p61_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p56_lanes;
  const Lanes<2> inverse_D10_p64_lanes = detail::make_pack<Real>(c12, c19) *
      (2.0 * inverse_D10_p35_lanes) - detail::make_pack<Real>(s12, s19) *
      (inverse_D10_p43_lanes - inverse_D10_p36_lanes);
  const Lanes<2> inverse_D10_p65_lanes = 0.269 * inverse_D10_p46_lanes - inverse_D10_p59_lanes;
  const Lanes<2> inverse_D10_p66_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p56_lanes;
  const Lanes<2> inverse_D10_p67_lanes = 0.269 * inverse_D10_p60_lanes;
  const Lanes<2> inverse_D8_p1_lanes = 6e-04 - inverse_D10_p57_lanes;
  const Lanes<2> inverse_D10_p70_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p64_lanes;
  const Lanes<2> inverse_D10_p72_lanes = inverse_D10_p66_lanes + inverse_D10_p67_lanes;
  const Lanes<2> inverse_D8_p4_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      inverse_D10_p61_lanes;
  const Lanes<2> inverse_D8_p6_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p39_lanes -
      detail::make_pack<Real>(c12, c19) * inverse_D10_p45_lanes;
  const Lanes<2> inverse_D8_p7_lanes = inverse_D10_p66_lanes - inverse_D10_p40_lanes;
  const Lanes<2> inverse_D10_p74_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p8_lanes + 0.269 * inverse_D10_p57_lanes);
  const Lanes<2> inverse_D10_p75_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      inverse_D10_p61_lanes;
  const Lanes<2> inverse_D10_p76_lanes = inverse_D10_p70_lanes - inverse_D10_p36_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p6_lanes + inverse_D11_p9_lanes));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p10_lanes = inverse_D10_p35_lanes - detail::make_pack<Real>(c12, c19) *
      inverse_D10_p64_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p83_lanes = inverse_D10_p74_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p84_lanes = inverse_D10_p75_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p16_lanes = inverse_D8_p4_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p17_lanes = inverse_D8_p1_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p18_lanes = inverse_D8_p7_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p88_lanes = 0.000131 - inverse_D11_p9_lanes + 0.269 *
      (inverse_D10_p65_lanes - inverse_D10_p59_lanes) - inverse_D10_p74_lanes *
      inverse_D10_p83_lanes;
  const Lanes<2> inverse_D10_p89_lanes = 0.0001098 + 0.07236100000000001 * inverse_D10_p76_lanes -
      inverse_D10_p75_lanes * inverse_D10_p84_lanes;
  const Lanes<2> inverse_D10_p90_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      inverse_D10_p72_lanes - inverse_D10_p74_lanes * inverse_D10_p84_lanes;
  const Lanes<2> inverse_D8_p32_lanes = inverse_D10_p74_lanes * inverse_D8_p16_lanes -
      inverse_D10_p72_lanes;
  const Lanes<2> inverse_D8_p33_lanes = inverse_D10_p67_lanes - inverse_D10_p75_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p34_lanes = inverse_D10_p75_lanes * inverse_D8_p16_lanes - 0.269 *
      inverse_D10_p76_lanes;
  const Lanes<2> inverse_D8_p35_lanes = inverse_D10_p65_lanes - inverse_D10_p74_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p36_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      (0.269 * inverse_D8_p6_lanes - (inverse_D10_p61_lanes - inverse_D10_p41_lanes)) -
      inverse_D10_p74_lanes * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p37_lanes = 0.269 * inverse_D8_p10_lanes - 6e-04 -
      inverse_D10_p75_lanes * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p38_lanes = inverse_D10_p76_lanes - inverse_D8_p4_lanes *
      inverse_D8_p16_lanes;
  const Lanes<2> inverse_D8_p39_lanes = inverse_D10_p46_lanes - inverse_D8_p1_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p40_lanes = inverse_D8_p4_lanes * inverse_D8_p17_lanes -
      inverse_D10_p60_lanes;
  const Lanes<2> inverse_D8_p41_lanes = inverse_D8_p4_lanes * inverse_D8_p18_lanes -
      inverse_D8_p10_lanes;
  const Lanes<2> inverse_D8_p42_lanes = inverse_D8_p6_lanes - inverse_D8_p1_lanes *
      inverse_D8_p18_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p59_lanes = 2.0 * detail::make_pack<Real>(s9, s16);

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p94_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p88_lanes - inverse_D10_p89_lanes) + inverse_D10_p11_lanes *
      inverse_D10_p90_lanes;
  const Lanes<2> inverse_D8_p63_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p32_lanes - inverse_D8_p33_lanes) + detail::make_pack<Real>(c11, c18) *
      (inverse_D8_p34_lanes + inverse_D8_p35_lanes);
  const Lanes<2> inverse_D8_p65_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * inverse_D8_p36_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p37_lanes);
  const Lanes<2> inverse_D8_p66_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p38_lanes - inverse_D8_p39_lanes) + inverse_D10_p11_lanes * inverse_D8_p40_lanes;
  const Lanes<2> inverse_D10_p95_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p94_lanes;
  const Lanes<2> inverse_D8_p67_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p68_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p69_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p66_lanes;
  const Lanes<2> inverse_D8_p72_lanes = inverse_D8_p33_lanes + inverse_D8_p68_lanes;
  const Lanes<2> inverse_D10_p97_lanes = 0.060888541114265754 +
      (inverse_D10_p89_lanes + inverse_D10_p95_lanes);
  const Lanes<2> inverse_D9_p5_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p94_lanes -
      inverse_D10_p90_lanes);
  const Lanes<2> inverse_D8_p78_lanes = inverse_D8_p67_lanes - inverse_D8_p35_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p97_lanes;
  const Lanes<2> inverse_D9_p7_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p97_lanes;
  const Lanes<2> inverse_D9_p9_lanes = inverse_D9_p5_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p11_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p97_lanes;
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
      (inverse_D10_p88_lanes - inverse_D10_p95_lanes) - inverse_D9_p5_lanes * inverse_D9_p9_lanes;
  const Lanes<2> inverse_D8_p95_lanes = inverse_D8_p32_lanes - inverse_D8_p68_lanes -
      inverse_D9_p5_lanes * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p96_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p36_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p37_lanes + inverse_D9_p5_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p97_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p98_lanes = 0.28049749700000004 +
      (inverse_D8_p67_lanes - inverse_D8_p34_lanes) - inverse_D9_p5_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p99_lanes = inverse_D8_p38_lanes - inverse_D8_p69_lanes -
      inverse_D8_p78_lanes * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p100_lanes = inverse_D10_p43_lanes + inverse_D10_p70_lanes +
      inverse_D8_p7_lanes * inverse_D8_p18_lanes + inverse_D8_p65_lanes * inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p101_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p41_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p42_lanes + inverse_D8_p78_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p102_lanes = inverse_D8_p39_lanes + inverse_D8_p69_lanes -
      inverse_D8_p72_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p104_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p66_lanes -
      inverse_D8_p40_lanes - inverse_D8_p78_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p105_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p41_lanes +
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
  const Lanes<2> inverse_D8_p124_lanes = inverse_D9_p1_lanes * inverse_D8_p101_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D8_p99_lanes + inverse_D8_p100_lanes);
  const Lanes<2> inverse_D8_p125_lanes = inverse_D8_p120_lanes + 0.282 * inverse_D8_p102_lanes;
  const Lanes<2> inverse_D9_p19_lanes = detail::make_pack<Real>(s10, s17) * inverse_D9_p18_lanes;
  const Lanes<2> inverse_D8_p127_lanes = 0.282 * inverse_D8_p121_lanes;
  const Lanes<2> inverse_D8_p128_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p122_lanes;
  const Lanes<2> inverse_D8_p129_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p122_lanes;
  const Lanes<2> inverse_D8_p130_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p124_lanes;
  const Lanes<2> inverse_D8_p134_lanes = inverse_D8_p96_lanes - inverse_D8_p128_lanes;
  const Lanes<2> inverse_D6_p13_lanes = inverse_D8_p86_lanes + inverse_D8_p129_lanes;
  const Lanes<2> inverse_D8_p137_lanes = inverse_D8_p99_lanes + inverse_D8_p130_lanes;
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
  const Lanes<2> inverse_D6_p59_lanes = inverse_D8_p140_lanes + inverse_D8_p143_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p61_lanes = inverse_D8_p127_lanes + inverse_D8_p145_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p63_lanes = inverse_D8_p125_lanes - inverse_D8_p143_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p65_lanes = inverse_D8_p145_lanes * inverse_D6_p31_lanes - 0.282 *
      inverse_D8_p137_lanes;
  const Lanes<2> inverse_D6_p67_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * inverse_D6_p7_lanes - (inverse_D8_p84_lanes - inverse_D8_p128_lanes)) +
      inverse_D8_p143_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p69_lanes = 0.0022500062 + 0.282 * inverse_D6_p15_lanes +
      inverse_D8_p145_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p71_lanes = inverse_D8_p137_lanes - inverse_D6_p19_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p73_lanes = inverse_D8_p102_lanes - inverse_D6_p5_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p75_lanes = inverse_D8_p121_lanes + inverse_D6_p19_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p77_lanes = inverse_D6_p15_lanes + inverse_D6_p19_lanes *
      inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p79_lanes = inverse_D6_p7_lanes + inverse_D6_p5_lanes *
      inverse_D6_p35_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p115_lanes = 2.0 * detail::make_pack<Real>(s7, s14);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p160_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D8_p154_lanes - inverse_D8_p155_lanes) - inverse_D8_p59_lanes *
      inverse_D8_p156_lanes;
  const Lanes<2> inverse_D6_p123_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p59_lanes + inverse_D6_p61_lanes) - detail::make_pack<Real>(s9, s16) *
      (inverse_D6_p65_lanes + inverse_D6_p63_lanes);
  const Lanes<2> inverse_D6_p127_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * inverse_D6_p67_lanes -
      detail::make_pack<Real>(s9, s16) * inverse_D6_p69_lanes);
  const Lanes<2> inverse_D6_p129_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p71_lanes - inverse_D6_p73_lanes) - inverse_D8_p59_lanes * inverse_D6_p75_lanes;
  const Lanes<2> inverse_D8_p161_lanes = detail::make_pack<Real>(c9, c16) * inverse_D8_p160_lanes;
  const Lanes<2> inverse_D6_p133_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p123_lanes;
  const Lanes<2> inverse_D6_p135_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p123_lanes;
  const Lanes<2> inverse_D6_p137_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p129_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p1_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p145_lanes = inverse_D6_p135_lanes - inverse_D6_p61_lanes;

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
      (inverse_D6_p133_lanes + inverse_D6_p63_lanes);

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
  const Lanes<2> inverse_D6_p161_lanes = inverse_D6_p127_lanes * inverse_D8_lanes;
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
      (detail::make_pack<Real>(s9, s16) * inverse_D6_p67_lanes + detail::make_pack<Real>(c9, c16) *
      inverse_D6_p69_lanes);
  const Lanes<2> inverse_D6_p185_lanes = inverse_D6_p59_lanes - inverse_D6_p135_lanes -
      inverse_D7_p5_lanes * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p187_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p37 = inverse_D21_p3_lanes[1] + inverse_D21_p3_lanes[0];

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p189_lanes = inverse_D6_p133_lanes + inverse_D6_p65_lanes -
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
  const Lanes<2> inverse_D6_p205_lanes = inverse_D6_p71_lanes - inverse_D6_p137_lanes -
      inverse_D6_p155_lanes * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p207_lanes = inverse_D8_p100_lanes + inverse_D8_p130_lanes +
      inverse_D6_p13_lanes * inverse_D6_p35_lanes + inverse_D6_p127_lanes * inverse_D6_p161_lanes;

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
  const Lanes<2> inverse_D6_p218_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p77_lanes -
      detail::make_pack<Real>(c9, c16) * inverse_D6_p79_lanes + inverse_D6_p127_lanes *
      inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p220_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p211_lanes;

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
  const Lanes<2> inverse_D6_p245_lanes = inverse_D7_p1_lanes * inverse_D6_p218_lanes -
      detail::make_pack<Real>(s8, s15) * (inverse_D6_p207_lanes + inverse_D6_p205_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p247 = inverse_D6_p160 * inverse_D6_p197;
  const Real inverse_D21_p47 = s22 * (inverse_D21_p44 - inverse_D21_p45) + inverse_D21_p41 *
      inverse_D21_p46;
  const Real inverse_D6_p250 = s22 * (inverse_D6_p209 + inverse_D6_p204) + c22 *
      (inverse_D6_p215 - inverse_D6_p210);
  const Real inverse_D6_p251 = c22 * inverse_D6_p224 - s22 * inverse_D6_p225;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p254_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p245_lanes;
  const Lanes<2> inverse_D6_p256_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p77_lanes +
      detail::make_pack<Real>(s9, s16) * inverse_D6_p79_lanes + inverse_D6_p127_lanes *
      inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p48 = s22 * inverse_D21_p47;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p258_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p129_lanes +
      inverse_D6_p75_lanes - inverse_D6_p155_lanes * inverse_D6_p165_lanes;

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
  const Lanes<2> inverse_D6_p340_lanes = inverse_D6_p73_lanes + inverse_D6_p137_lanes -
      inverse_D6_p145_lanes * inverse_D6_p165_lanes - inverse_D6_p241_lanes * inverse_D6_p294_lanes;
  const Lanes<2> inverse_D6_p342_lanes = inverse_D6_p207_lanes + inverse_D6_p254_lanes +
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
      inverse_D6_p218_lanes - inverse_D6_p243_lanes * inverse_D6_p299_lanes;
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
      (inverse_D6_p340_lanes + inverse_D6_p342_lanes) - inverse_D6_p115_lanes *
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
      (inverse_D6_p370_lanes - inverse_D6_p389_lanes) + inverse_D6_p115_lanes *
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
  const Real inverse_D4_p1 = inverse_D6_p287 - inverse_D6_p204;

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
  const Real inverse_D4_p2 = c22 * inverse_D6_p247 - s22 * inverse_D6_p260;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p36_lanes = inverse_D6_p417_lanes - inverse_D6_p342_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D4_p3 = inverse_D6_p236 - c22 * inverse_D6_p272;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p455_lanes = inverse_D6_p438_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p434_lanes + 0.226 *
      inverse_D6_p399_lanes);
  const Lanes<2> inverse_D5_p38_lanes = inverse_D5_p11_lanes - inverse_D6_p346_lanes -
      (inverse_D5_p22_lanes + inverse_D5_p16_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p4 = inverse_D4_p1 * inverse_D21;
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

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p55 = c21 * (inverse_D5_p24 - inverse_D5_p34) - s21 *
      (inverse_D5_p27 + inverse_D5_p35);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p56 = inverse_D5_p46_lanes[1] + inverse_D5_p46_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p57 = inverse_D6_p298 + inverse_D6_p279 * inverse_D5_p13;
  const Real inverse_D4_p5 = inverse_D6_p305 * inverse_D4_p4 -
      (inverse_D6_p262 + inverse_D6_p210 + 0.394 * inverse_D4_p2);
  const Real inverse_D5_p60 = c21 * inverse_D5_p55;
  const Real inverse_D4_p6 = inverse_D6_p297 * inverse_D4_p4 -
      (0.0045000000000000005 + 0.394 * inverse_D4_p3);
  const Real inverse_D5_p61 = s21 * inverse_D5_p55;

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
  const Real inverse_D4_p7 = inverse_D5_p61 + inverse_D5_p35 - 6.1665928899999995 - inverse_D6_p454;
  const Real inverse_D4_p8 = c21 * inverse_D4_p5 - s21 * inverse_D4_p6 + inverse_D6_p455_lanes[1] +
      inverse_D6_p455_lanes[0];

  // link 6 (chest3), articulated inertia
  const Real inverse_D4_p9 = inverse_D5_p14_lanes[1] + inverse_D5_p14_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p10 = inverse_D6_p279 * inverse_D4_p4 - inverse_D4_p3;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D4_p11_lanes = inverse_D5_p22_lanes - inverse_D5_p20_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p462;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p70 = 0.0187369177636143 + inverse_D5_p50_lanes[1] -
      inverse_D6_p393_lanes[1] + inverse_D5_p25_lanes[1] + inverse_D5_p50_lanes[0] -
      inverse_D6_p393_lanes[0] + inverse_D5_p25_lanes[0] + 0.226 * inverse_D5_p56;

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p13 = inverse_D4_p2 - inverse_D5_p5 * inverse_D4_p4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D4_p14 = 2.0 * c5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p71 = inverse_D5_p67 * inverse_D6;
  const Real inverse_D5_p72 = inverse_D5_p62 * inverse_D6;
  const Real inverse_D5_p73 = inverse_D5_p70 * inverse_D6;
  const Real inverse_D4_p15 = inverse_D4_p8 * inverse_D6;
  const Real inverse_D4_p16 = inverse_D4_p7 * inverse_D6;
  const Real inverse_D5_p74 = inverse_D5_p53_lanes[1] + inverse_D5_p53_lanes[0] - inverse_D5_p70 *
      inverse_D5_p71;
  const Real inverse_D5_p75 = 0.40056549999999996 - inverse_D6_p288_lanes[1] - inverse_D6_p452 +
      inverse_D5_p63_lanes[1] + inverse_D6_p370_lanes[0] + inverse_D5_p63_lanes[0] -
      inverse_D5_p70 * inverse_D5_p73;
  const Real inverse_D5_p76 = inverse_D5_p52 + inverse_D5_p68 + inverse_D5_p65 - inverse_D5_p67 *
      inverse_D5_p71;
  const Real inverse_D4_p17 = inverse_D4_p11_lanes[1] + inverse_D4_p11_lanes[0] + inverse_D5_p70 *
      inverse_D4_p15;
  const Real inverse_D4_p18 = inverse_D5_p24 - inverse_D5_p60 + inverse_D5_p16_lanes[1] +
      inverse_D5_p16_lanes[0] - inverse_D5_p62 * inverse_D4_p16;
  const Real inverse_D4_p19 = (-0.18) * inverse_D5_p9_lanes[1] - inverse_D5_p56 + 0.18 *
      inverse_D5_p9_lanes[0] - inverse_D5_p70 * inverse_D4_p16;
  const Real inverse_D4_p20 = inverse_D4_p9 - c21 * inverse_D4_p10 + s21 * inverse_D4_p13 +
      inverse_D4_p8 * inverse_D5_p71;
  const Real inverse_D4_p21 = s21 * inverse_D5_p66 + inverse_D5_p57 + inverse_D5_p9_lanes[1] +
      inverse_D5_p9_lanes[0] - inverse_D4_p7 * inverse_D5_p71;
  const Real inverse_D5_p77 = 6.1665928899999995 + inverse_D5_p61 + inverse_D5_p27 -
      inverse_D5_p62 * inverse_D5_p71 + 0.226 * inverse_D5_p65;
  const Real inverse_D5_p78 = 1.66923963592404 + inverse_D6_p427 - inverse_D6_p457 -
      inverse_D5_p62 * inverse_D5_p72 + 0.051076 * inverse_D5_p65;
  const Real inverse_D4_p22 = inverse_D6_p434_lanes[1] -
      (inverse_D6_p226 + inverse_D6_p284 + inverse_D4_p1 * inverse_D4_p4) +
      inverse_D6_p434_lanes[0] - inverse_D4_p8 * inverse_D4_p15;
  const Real inverse_D5_p79 = (-0.04068) * inverse_D5_p36_lanes[1] + 0.04068 *
      inverse_D5_p36_lanes[0] - inverse_D5_p70 * inverse_D5_p72 + 0.226 *
      (inverse_D5_p40_lanes[1] + inverse_D5_p40_lanes[0]);
  const Real inverse_D4_p23 = inverse_D5_p62 * inverse_D4_p15 -
      (s21 * inverse_D4_p5 + c21 * inverse_D4_p6) + 0.226 * inverse_D4_p9;
  const Real inverse_D4_p24 = inverse_D5_p49 - inverse_D5_p68 + inverse_D6_p415_lanes[1] +
      inverse_D6_p415_lanes[0] - inverse_D4_p7 * inverse_D4_p16;
  const Real inverse_D4_p25 = inverse_D6_p399_lanes[1] -
      (s21 * inverse_D4_p10 + c21 * inverse_D4_p13) + inverse_D6_p399_lanes[0] + inverse_D4_p8 *
      inverse_D4_p16;
  const Real inverse_D4_p26 = s6 * inverse_D4_p20 + c6 * inverse_D4_p21;
  const Real inverse_D5_p80 = s6 * inverse_D5_p74 + c6 * inverse_D5_p77;
  const Real inverse_D4_p27 = c6 * inverse_D5_p74 - s6 * inverse_D5_p77;
  const Real inverse_D4_p28 = 0.072 * inverse_D4_p26;
  const Real inverse_D3_p1 = c6 * inverse_D4_p20 - s6 * inverse_D4_p21;
  const Real inverse_D5_p81 = inverse_D5_p80 + 0.072 * inverse_D5_p76;
  const Real inverse_D5_p82 = s6 * (inverse_D5_p75 - inverse_D5_p78) + inverse_D5_p69 *
      inverse_D5_p79;
  const Real inverse_D4_p29 = s6 * (inverse_D4_p17 - inverse_D4_p18) + c6 *
      (inverse_D4_p23 + inverse_D4_p19);
  const Real inverse_D4_p30 = s6 * (inverse_D4_p22 - inverse_D4_p24) + inverse_D5_p69 *
      inverse_D4_p25;
  const Real inverse_D5_p83 = s6 * inverse_D5_p82;
  const Real inverse_D3_p2 = 2.2194301519999997 + inverse_D5_p81;
  const Real inverse_D4_p31 = s6 * inverse_D4_p29;
  const Real inverse_D4_p32 = s6 * inverse_D4_p30;
  const Real inverse_D4_p33 = c6 * inverse_D4_p29;
  const Real inverse_D4_p34 = inverse_D4_p24 + inverse_D4_p32;
  const Real inverse_D4_p35 = inverse_D4_p33 - inverse_D4_p23;
  const Real inverse_D3_p3 = c6 * inverse_D4_p30 - inverse_D4_p25;
  const Real inverse_D4_p36 = c6 * inverse_D5_p82 - inverse_D5_p79 + 0.072 * inverse_D4_p27;
  const Real inverse_D4_p37 = inverse_D4_p18 + inverse_D4_p31 + inverse_D4_p28;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p4 = 2.0 * c4;

  // link 6 (chest3), articulated inertia
  const Real inverse_D4_p38 = 0.072 * inverse_D4_p37;
  const Real inverse_D3_p5 = 0.069699984375 + (inverse_D4_p33 - inverse_D4_p19 + 0.072 *
      inverse_D3_p1);

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p78 + inverse_D5_p83 + 0.072 * (inverse_D5_p80 + inverse_D5_p81)));
  const Real inverse_D4_p39 = inverse_D4_p38 * inverse_D5;
  const Real inverse_D4_p40 = inverse_D4_p36 * inverse_D5;
  const Real inverse_D3_p6 = inverse_D3_p2 * inverse_D5;
  const Real inverse_D3_p7 = inverse_D3_p5 * inverse_D5;
  const Real inverse_D3_p8 = inverse_D4_p37 * inverse_D5;
  const Real inverse_D4_p41 = 0.15637308509675518 + 0.005183999999999999 * inverse_D4_p34 -
      inverse_D4_p38 * inverse_D4_p39;
  const Real inverse_D4_p42 = 0.04675382692737882 + (inverse_D5_p75 - inverse_D5_p83) -
      inverse_D4_p36 * inverse_D4_p40;
  const Real inverse_D4_p43 = 0.005678398088837119 - 0.072 * inverse_D4_p35 + inverse_D4_p38 *
      inverse_D4_p40;
  const Real inverse_D3_p9 = inverse_D4_p38 * inverse_D3_p6 - inverse_D4_p28;
  const Real inverse_D3_p10 = inverse_D4_p17 - inverse_D4_p31 - inverse_D4_p36 * inverse_D3_p7;
  const Real inverse_D3_p11 = inverse_D4_p27 - inverse_D4_p36 * inverse_D3_p6;
  const Real inverse_D3_p12 = inverse_D4_p38 * inverse_D3_p7 - 0.072 * inverse_D3_p3;
  const Real inverse_D3_p13 = inverse_D4_p38 * inverse_D3_p8 -
      (2.2194301519999997 + 0.072 * inverse_D4_p34);
  const Real inverse_D3_p14 = inverse_D4_p35 - 0.069699984375 - inverse_D4_p36 * inverse_D3_p8;
  const Real inverse_D3_p15 = inverse_D4_p22 - inverse_D4_p32 - inverse_D3_p5 * inverse_D3_p7;
  const Real inverse_D3_p16 = inverse_D5_p76 - inverse_D3_p2 * inverse_D3_p6;
  const Real inverse_D3_p17 = inverse_D3_p1 - inverse_D3_p2 * inverse_D3_p7;
  const Real inverse_D3_p18 = inverse_D4_p34 - inverse_D4_p37 * inverse_D3_p8;
  const Real inverse_D3_p19 = inverse_D3_p3 - inverse_D3_p5 * inverse_D3_p8;
  const Real inverse_D3_p20 = inverse_D4_p26 - inverse_D3_p2 * inverse_D3_p8;
  const Real inverse_D3_p21 = s5 * inverse_D3_p13 + c5 * inverse_D3_p14;
  const Real inverse_D3_p22 = s5 * inverse_D3_p14 - c5 * inverse_D3_p13;
  const Real inverse_D4_p44 = s5 * (inverse_D4_p41 - inverse_D4_p42) + inverse_D4_p14 *
      inverse_D4_p43;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p1_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p2_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_1_p1 = s5 * s4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p23 = s5 * (inverse_D3_p9 - inverse_D3_p10) + c5 *
      (inverse_D3_p11 + inverse_D3_p12);

  // link 5 (chest2), pose
  const Real Lambda_inv_0_1_p2 = c5 * s4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p24 = s5 * (inverse_D3_p16 - inverse_D3_p15) + inverse_D4_p14 *
      inverse_D3_p17;
  const Real inverse_D3_p25 = inverse_D3_p22 + 0.21799999999999997 * inverse_D3_p18;
  const Real inverse_D4_p45 = s5 * inverse_D4_p44;
  const Real inverse_D3_p26 = s5 * inverse_D3_p19 - c5 * inverse_D3_p20;
  const Real inverse_D3_p27 = c5 * inverse_D3_p23;
  const Real inverse_D3_p28 = s5 * inverse_D3_p23;
  const Real inverse_D2_p1 = 0.0300000063 + inverse_D3_p21;
  const Real inverse_D2_p2 = s5 * inverse_D3_p20 + c5 * inverse_D3_p19;
  const Real inverse_D3_p29 = s5 * inverse_D3_p24;
  const Real inverse_D3_p30 = 0.21799999999999997 * inverse_D3_p26;
  const Real inverse_D3_p31 = inverse_D3_p27 - inverse_D3_p12;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_1_p5 = s6 * c4 - c6 * Lambda_inv_0_1_p1;
  const Real Lambda_inv_0_1_p6 = s6 * Lambda_inv_0_1_p1 + c6 * c4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p32 = inverse_D3_p16 - inverse_D3_p29;
  const Real inverse_D2_p3 = inverse_D3_p10 + inverse_D3_p28;

  // link 2 (thigh), pose
  const Real Lambda_inv_0_2_p1 = c2 * c1 - s2 * s1;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p33 = 0.21799999999999997 * inverse_D3_p31;
  const Real inverse_D2_p4 = c5 * inverse_D3_p24 - inverse_D3_p17;

  // link 2 (thigh), pose
  const Real Lambda_inv_0_2_p2 = s2 * c1 + c2 * s1;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p42 + inverse_D4_p45));

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p34 = 0.005880002159562879 +
      (0.21799999999999997 * inverse_D3_p21 - (c5 * inverse_D4_p44 - inverse_D4_p43));
  const Real inverse_D3_p35 = inverse_D3_p9 - inverse_D3_p28 + inverse_D3_p30;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_1_p11_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_1_p5 -
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_1_p2;
  const Lanes<2> Lambda_inv_0_1_p12_lanes = detail::make_pack<Real>(s7, s14) * Lambda_inv_0_1_p5 +
      detail::make_pack<Real>(c7, c14) * Lambda_inv_0_1_p2;

  // link 3 (hip), pose
  const Real Lambda_inv_0_2_p3 = s3 * Lambda_inv_0_2_p1 + c3 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p4 = c3 * Lambda_inv_0_2_p1 - s3 * Lambda_inv_0_2_p2;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_2_p5 = c4 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_3_p1 = c4 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_2_p6 = s4 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_3_p2 = s4 * Lambda_inv_0_2_p4;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_1_p16_lanes = detail::make_pack<Real>(c8, c15) * Lambda_inv_0_1_p6 -
      detail::make_pack<Real>(s8, s15) * Lambda_inv_0_1_p11_lanes;
  const Lanes<2> Lambda_inv_0_1_p17_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_1_p11_lanes + detail::make_pack<Real>(s8, s15) * Lambda_inv_0_1_p6;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p36 = inverse_D3_p34 * inverse_D4;
  const Real inverse_D3_p37 = inverse_D3_p33 * inverse_D4;
  const Real inverse_D2_p5 = inverse_D3_p31 * inverse_D4;
  const Real inverse_D2_p6 = inverse_D2_p1 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p3 * inverse_D4;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_2_p7 = s5 * Lambda_inv_0_2_p5 - c5 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_3_p3 = s5 * Lambda_inv_0_3_p1 + c5 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p8 = c5 * Lambda_inv_0_2_p5 + s5 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_3_p4 = c5 * Lambda_inv_0_3_p1 - s5 * Lambda_inv_0_2_p3;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_1_p22_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_inv_0_1_p16_lanes + detail::make_pack<Real>(c9, c16) * Lambda_inv_0_1_p12_lanes;
  const Lanes<2> Lambda_inv_0_1_p24_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_1_p16_lanes - detail::make_pack<Real>(s9, s16) * Lambda_inv_0_1_p12_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p38 = 0.01227760324629517 + 0.04752399999999999 * inverse_D3_p32 -
      inverse_D3_p33 * inverse_D3_p37;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_2_p11 = c6 * Lambda_inv_0_2_p7 + s6 * Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_3_p7 = c6 * Lambda_inv_0_3_p3 + s6 * Lambda_inv_0_3_p2;
  const Real Lambda_inv_0_2_p12 = s6 * Lambda_inv_0_2_p7 - c6 * Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_3_p8 = s6 * Lambda_inv_0_3_p3 - c6 * Lambda_inv_0_3_p2;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_inv_0_1_p27_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_1_p22_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_1_p17_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_7_p25 = c17 * Lambda_inv_0_1_p17_lanes[1] - s17 *
      Lambda_inv_0_1_p22_lanes[1];

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p39 = 0.0478915 + (inverse_D4_p41 - inverse_D4_p45 + 0.21799999999999997 *
      (inverse_D3_p22 + inverse_D3_p25)) - inverse_D3_p34 * inverse_D3_p36 - inverse_D3_p38;
  const Real inverse_D2_p8 = inverse_D3_p34 * inverse_D2_p6 - inverse_D3_p25;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_2_p17_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_2_p11 +
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_2_p8;
  const Lanes<2> Lambda_inv_0_3_p13_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_3_p7 +
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_3_p4;
  const Lanes<2> Lambda_inv_0_2_p18_lanes = detail::make_pack<Real>(s7, s14) * Lambda_inv_0_2_p11 -
      detail::make_pack<Real>(c7, c14) * Lambda_inv_0_2_p8;
  const Lanes<2> Lambda_inv_0_3_p14_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_3_p4 -
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_3_p7;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_1_p30_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_1_p27_lanes + detail::make_pack<Real>(s11, s18) * Lambda_inv_0_1_p24_lanes;
  const Lanes<2> Lambda_inv_0_1_p31_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_1_p24_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_1_p27_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_2_p22_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_2_p17_lanes + detail::make_pack<Real>(c8, c15) * Lambda_inv_0_2_p12;
  const Lanes<2> Lambda_inv_0_3_p18_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_3_p13_lanes + detail::make_pack<Real>(c8, c15) * Lambda_inv_0_3_p8;
  const Lanes<2> Lambda_inv_0_2_p23_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_2_p17_lanes - detail::make_pack<Real>(s8, s15) * Lambda_inv_0_2_p12;
  const Lanes<2> Lambda_inv_0_3_p19_lanes = detail::make_pack<Real>(s8, s15) * Lambda_inv_0_3_p8 -
      detail::make_pack<Real>(c8, c15) * Lambda_inv_0_3_p13_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p9 = inverse_D3_p32 - inverse_D3_p31 * inverse_D2_p5;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_7_p33 = c19 * Lambda_inv_0_1_p30_lanes[1] + s19 * Lambda_inv_0_7_p25;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p40 = inverse_D3_p38 + s4 *
      (s4 * inverse_D3_p39 + inverse_D3_p4 * (0.21799999999999997 * inverse_D3_p35 +
      inverse_D3_p34 * inverse_D3_p37));
  const Real inverse_D2_p10 = s4 * (inverse_D3_p35 + inverse_D3_p34 * inverse_D2_p5 +
      (inverse_D3_p30 + inverse_D3_p33 * inverse_D2_p6)) + c4 *
      (0.21799999999999997 * inverse_D3_p32 - inverse_D3_p33 * inverse_D2_p5 + inverse_D2_p8);
  const Real inverse_D2_p11 = s4 * (0.21799999999999997 * inverse_D2_p2 -
      (inverse_D3_p27 - inverse_D3_p11) - inverse_D3_p34 * inverse_D2_p7) + c4 *
      (0.0300000063 - 0.21799999999999997 * inverse_D2_p4 + inverse_D3_p33 * inverse_D2_p7);

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_2_p29_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_2_p18_lanes - detail::make_pack<Real>(s9, s16) * Lambda_inv_0_2_p22_lanes;
  const Lanes<2> Lambda_inv_0_3_p22_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_inv_0_3_p18_lanes + detail::make_pack<Real>(c9, c16) * Lambda_inv_0_3_p14_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p40);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p12 = 0.02999999505 + inverse_D2_p11;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_2_p31_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_2_p22_lanes + detail::make_pack<Real>(s9, s16) * Lambda_inv_0_2_p18_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p13 = s4 * (inverse_D2_p9 -
      (inverse_D3_p18 - inverse_D2_p1 * inverse_D2_p6)) - inverse_D3_p4 *
      (inverse_D3_p26 + inverse_D3_p31 * inverse_D2_p6);

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_inv_0_2_p35_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_2_p29_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_2_p23_lanes;
  const Lanes<8> Lambda_inv_0_3_p24_lanes = c10 *
      detail::make_pack<Real>(Lambda_inv_0_3_p19_lanes[0], Lambda_inv_0_1_p17_lanes[0],
      Lambda_inv_0_2_p23_lanes[0], Lambda_inv_0_3_p19_lanes[0], Lambda_inv_0_3_p19_lanes[0],
      Lambda_inv_0_3_p19_lanes[0], Lambda_inv_0_3_p19_lanes[0], Lambda_inv_0_3_p19_lanes[0]) - s10 *
      detail::make_pack<Real>(Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_1_p22_lanes[0],
      Lambda_inv_0_2_p29_lanes[0], Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_3_p22_lanes[0],
      Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_3_p22_lanes[0]);

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_8_p24 = c17 * Lambda_inv_0_2_p23_lanes[1] - s17 *
      Lambda_inv_0_2_p29_lanes[1];

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p14 = 8.419374554 + (c4 * inverse_D2_p10 - inverse_D2_p8);

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_inv_0_0_p7_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_3_p22_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_3_p19_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_0_p8_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_3_p18_lanes - detail::make_pack<Real>(s9, s16) * Lambda_inv_0_3_p14_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_2_p40_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_2_p35_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_2_p31_lanes;
  const Lanes<2> Lambda_inv_0_2_p41_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_inv_0_2_p35_lanes + detail::make_pack<Real>(c11, c18) * Lambda_inv_0_2_p31_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_inv_0_1_p39_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_inv_0_3_p24_lanes[1], Lambda_inv_0_7_p25) -
      detail::make_pack<Real>(s12, s19) * Lambda_inv_0_1_p30_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p12 * inverse_D3;
  const Real inverse_D2_p16 = inverse_D2_p14 * inverse_D3;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p27 = c17 * Lambda_inv_0_3_p19_lanes[1] - s17 *
      Lambda_inv_0_3_p22_lanes[1];

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_0_p13_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_0_p7_lanes + detail::make_pack<Real>(s11, s18) * Lambda_inv_0_0_p8_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_inv_0_2_p44_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_inv_0_3_p24_lanes[2], Lambda_inv_0_8_p24) -
      detail::make_pack<Real>(s12, s19) * Lambda_inv_0_2_p40_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_0_p14_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_0_p8_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_0_p7_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_1_p42_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_1_p31_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_1_p39_lanes;
  const Lanes<2> Lambda_inv_0_1_p43_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_1_p39_lanes + detail::make_pack<Real>(s13, s20) * Lambda_inv_0_1_p31_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = inverse_D2_p14 * inverse_D2_p15 -
      (c4 * (inverse_D3_p31 * inverse_D2_p7 - inverse_D2_p4) - s4 *
      (inverse_D2_p1 * inverse_D2_p7 - inverse_D2_p2));
  const Real inverse_D2_p18 = inverse_D2_p9 - s4 * inverse_D2_p13 - inverse_D2_p14 * inverse_D2_p16;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_1_p44_lanes = 0.009919078854932248 * Lambda_inv_0_1_p42_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p42 = 0.49024375482668536 * Lambda_inv_0_1_p42_lanes[1];

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p19 = inverse_D3_p15 + inverse_D3_p29 - inverse_D2_p3 * inverse_D2_p7 -
      inverse_D2_p12 * inverse_D2_p15;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_inv_0_0_p18_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_inv_0_3_p24_lanes[0], Lambda_inv_0_6_p27) -
      detail::make_pack<Real>(s12, s19) * Lambda_inv_0_0_p13_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_2_p46_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_inv_0_2_p44_lanes + detail::make_pack<Real>(c13, c20) * Lambda_inv_0_2_p41_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_inv_0_3_p28_lanes = c12 *
      detail::make_pack<Real>(Lambda_inv_0_0_p13_lanes[0], Lambda_inv_0_1_p30_lanes[0],
      Lambda_inv_0_2_p40_lanes[0], Lambda_inv_0_0_p13_lanes[0], Lambda_inv_0_0_p13_lanes[0],
      Lambda_inv_0_0_p13_lanes[0], Lambda_inv_0_0_p13_lanes[0], Lambda_inv_0_0_p13_lanes[0]) + s12 *
      Lambda_inv_0_3_p24_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_5_p6_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_2_p44_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_2_p41_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p43 = -(0.086 * Lambda_inv_0_7_p33) - (-0.004018575007348824) *
      Lambda_inv_0_1_p42_lanes[1];

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_1_p46_lanes = Lambda_inv_0_1_p43_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_inv_0_1_p42_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_inv_0_0_p20_lanes = 0.086 * Lambda_inv_0_3_p28_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_2_p49_lanes = -Lambda_inv_0_2_p46_lanes;
  const Lanes<8> Lambda_inv_0_3_p31_lanes = (-3.0523172236718206) *
      detail::make_pack<Real>(Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[0],
      Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[1],
      Lambda_inv_0_3_p28_lanes[2], Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[0]);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_0_p21_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_0_p14_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_0_p18_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_2_p50_lanes = -(0.086 * Lambda_inv_0_2_p46_lanes);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_3_p32_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_0_p18_lanes + detail::make_pack<Real>(s13, s20) * Lambda_inv_0_0_p14_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_2_p51_lanes = 0.11533812622014242 * Lambda_inv_0_2_p50_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p45 = s20 * Lambda_inv_0_1_p44_lanes[1] + c20 * Lambda_inv_0_7_p43;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_0_p23_lanes = 0.009919078854932248 * Lambda_inv_0_0_p21_lanes;
  const Lanes<8> Lambda_inv_0_3_p34_lanes = detail::make_pack<Real>(Lambda_inv_0_3_p32_lanes[0],
      Lambda_inv_0_3_p32_lanes[0], Lambda_inv_0_3_p32_lanes[0], Lambda_inv_0_3_p32_lanes[0],
      Lambda_inv_0_1_p43_lanes[0], Lambda_inv_0_5_p6_lanes[0], Lambda_inv_0_3_p32_lanes[0],
      Lambda_inv_0_3_p32_lanes[0]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[0],
      Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[1],
      Lambda_inv_0_3_p28_lanes[2], Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[0]);
  const Lanes<8> Lambda_inv_0_0_p25_lanes = detail::make_pack<Real>(0.49024375482668536,
      0.49024375482668536, 0.49024375482668536, 17.32841575379867, 17.32841575379867,
      17.32841575379867, 0.49024375482668536, 0.49024375482668536) *
      detail::make_pack<Real>(Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_1_p42_lanes[0],
      Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[1],
      Lambda_inv_0_3_p28_lanes[2], Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0]);

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p41 = 0.49024375482668536 * Lambda_inv_0_0_p21_lanes[1];

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_2_p55_lanes = Lambda_inv_0_5_p6_lanes +
      detail::make_pack<Real>((-3.0523172236718206), 3.0523172236718206) * Lambda_inv_0_2_p50_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p42 = c19 * Lambda_inv_0_0_p13_lanes[1] + s19 * Lambda_inv_0_6_p27;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_2_p56_lanes = Lambda_inv_0_2_p49_lanes - 17.32841575379867 *
      Lambda_inv_0_2_p50_lanes;
  const Lanes<8> Lambda_inv_0_0_p26_lanes = detail::make_pack<Real>(-Lambda_inv_0_0_p20_lanes[0],
      -Lambda_inv_0_0_p20_lanes[1], -Lambda_inv_0_0_p20_lanes[2], Lambda_inv_0_0_p21_lanes[0],
      Lambda_inv_0_1_p42_lanes[0], Lambda_inv_0_2_p49_lanes[0], -Lambda_inv_0_0_p20_lanes[0],
      -Lambda_inv_0_0_p20_lanes[0]) - detail::make_pack<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_pack<Real>(Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_1_p42_lanes[0],
      Lambda_inv_0_2_p50_lanes[0], Lambda_inv_0_3_p28_lanes[0], Lambda_inv_0_3_p28_lanes[1],
      Lambda_inv_0_3_p28_lanes[2], Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0]);
  const Lanes<2> Lambda_inv_0_0_p28_lanes = Lambda_inv_0_3_p32_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_inv_0_0_p21_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p46 = c20 * Lambda_inv_0_1_p46_lanes[1] + s20 * Lambda_inv_0_7_p42 -
      inverse_D10_p28_lanes[1] * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p47 = Lambda_inv_0_7_p33 - inverse_D10_p29_lanes[1] *
      Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p48 = c20 * Lambda_inv_0_1_p44_lanes[1] - s20 * Lambda_inv_0_7_p43 -
      inverse_D11_p4_lanes[1] * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p49 = s20 * Lambda_inv_0_1_p46_lanes[1] - c20 * Lambda_inv_0_7_p42 -
      inverse_D10_p30_lanes[1] * Lambda_inv_0_7_p45;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = s3 * (inverse_D2_p18 - inverse_D2_p19) + c3 * (2.0 * inverse_D2_p17);

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p44 = -(0.086 * Lambda_inv_0_6_p42) - (-0.004018575007348824) *
      Lambda_inv_0_0_p21_lanes[1];

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_2_p62_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_2_p55_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_2_p56_lanes;
  const Lanes<8> Lambda_inv_0_0_p32_lanes = s13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p23_lanes[0], Lambda_inv_0_1_p44_lanes[0],
      Lambda_inv_0_2_p51_lanes[0], Lambda_inv_0_3_p34_lanes[3], Lambda_inv_0_3_p34_lanes[4],
      Lambda_inv_0_3_p34_lanes[5], Lambda_inv_0_0_p23_lanes[0], Lambda_inv_0_0_p23_lanes[0]) + c13 *
      Lambda_inv_0_0_p26_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = s3 * inverse_D2_p20;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p33_lanes = c13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p28_lanes[0], Lambda_inv_0_1_p46_lanes[0],
      Lambda_inv_0_0_p28_lanes[0], Lambda_inv_0_3_p31_lanes[3], Lambda_inv_0_3_p31_lanes[4],
      Lambda_inv_0_3_p31_lanes[5], Lambda_inv_0_0_p28_lanes[0], Lambda_inv_0_0_p28_lanes[0]) + s13 *
      Lambda_inv_0_0_p25_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p50 = s19 * Lambda_inv_0_7_p46 - c19 * Lambda_inv_0_7_p47;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p51 = -(c19 * Lambda_inv_0_7_p48);

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p45 = s20 * Lambda_inv_0_0_p23_lanes[1] + c20 * Lambda_inv_0_6_p44;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p22 = inverse_D2_p18 - inverse_D2_p21;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p36_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p33_lanes[0],
      Lambda_inv_0_0_p33_lanes[1], Lambda_inv_0_2_p62_lanes[0], Lambda_inv_0_0_p33_lanes[0],
      Lambda_inv_0_0_p33_lanes[0], Lambda_inv_0_0_p33_lanes[0], Lambda_inv_0_0_p33_lanes[0],
      Lambda_inv_0_0_p33_lanes[0]) - inverse_D10_p28_lanes[0] * Lambda_inv_0_0_p32_lanes;
  const Lanes<8> Lambda_inv_0_0_p37_lanes = Lambda_inv_0_3_p28_lanes - inverse_D10_p29_lanes[0] *
      Lambda_inv_0_0_p32_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p52 = 0.269 * Lambda_inv_0_7_p49 - s19 * Lambda_inv_0_7_p48 -
      inverse_D10_p83_lanes[1] * Lambda_inv_0_7_p51;
  const Real Lambda_inv_0_7_p53 = -Lambda_inv_0_7_p50 + inverse_D8_p16_lanes[1] *
      Lambda_inv_0_7_p51;
  const Real Lambda_inv_0_7_p54 = Lambda_inv_0_7_p49 - inverse_D8_p17_lanes[1] * Lambda_inv_0_7_p51;
  const Real Lambda_inv_0_7_p55 = 0.269 * Lambda_inv_0_7_p50 - inverse_D10_p84_lanes[1] *
      Lambda_inv_0_7_p51;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p46 = c20 * Lambda_inv_0_0_p28_lanes[1] + s20 * Lambda_inv_0_6_p41 -
      inverse_D10_p28_lanes[1] * Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p47 = Lambda_inv_0_6_p42 - inverse_D10_p29_lanes[1] *
      Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p48 = c20 * Lambda_inv_0_0_p23_lanes[1] - s20 * Lambda_inv_0_6_p44 -
      inverse_D11_p4_lanes[1] * Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p49 = s20 * Lambda_inv_0_0_p28_lanes[1] - c20 * Lambda_inv_0_6_p41 -
      inverse_D10_p30_lanes[1] * Lambda_inv_0_6_p45;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p58 = s18 * Lambda_inv_0_7_p52 + c18 * Lambda_inv_0_7_p55;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_3_p50_lanes = inverse_D10_p29_lanes[0] * Lambda_inv_0_0_p32_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p47_lanes = s13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p28_lanes[0], Lambda_inv_0_1_p46_lanes[0],
      Lambda_inv_0_0_p28_lanes[0], Lambda_inv_0_3_p31_lanes[3], Lambda_inv_0_3_p31_lanes[4],
      Lambda_inv_0_3_p31_lanes[5], Lambda_inv_0_0_p28_lanes[0], Lambda_inv_0_0_p28_lanes[0]) - c13 *
      Lambda_inv_0_0_p25_lanes;
  const Lanes<2> Lambda_inv_0_2_p75_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_inv_0_2_p55_lanes + detail::make_pack<Real>(c13, c20) * Lambda_inv_0_2_p56_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p48_lanes = c13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p23_lanes[0], Lambda_inv_0_1_p44_lanes[0],
      Lambda_inv_0_2_p51_lanes[0], Lambda_inv_0_3_p34_lanes[3], Lambda_inv_0_3_p34_lanes[4],
      Lambda_inv_0_3_p34_lanes[5], Lambda_inv_0_0_p23_lanes[0], Lambda_inv_0_0_p23_lanes[0]) - s13 *
      Lambda_inv_0_0_p26_lanes - inverse_D11_p4_lanes[0] * Lambda_inv_0_0_p32_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p52 = s19 * Lambda_inv_0_6_p46 - c19 * Lambda_inv_0_6_p47;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p53 = -(c19 * Lambda_inv_0_6_p48);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_3_p55_lanes = Lambda_inv_0_0_p33_lanes - inverse_D10_p28_lanes[0] *
      Lambda_inv_0_0_p32_lanes;
  const Lanes<8> Lambda_inv_0_0_p51_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p47_lanes[0],
      Lambda_inv_0_0_p47_lanes[1], Lambda_inv_0_2_p75_lanes[0], Lambda_inv_0_0_p47_lanes[3],
      Lambda_inv_0_0_p47_lanes[4], Lambda_inv_0_0_p47_lanes[5], Lambda_inv_0_0_p47_lanes[0],
      Lambda_inv_0_0_p47_lanes[0]) - inverse_D10_p30_lanes[0] * Lambda_inv_0_0_p32_lanes;
  const Lanes<8> Lambda_inv_0_0_p54_lanes = s12 * Lambda_inv_0_0_p36_lanes - c12 *
      Lambda_inv_0_0_p37_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p55 = 0.269 * Lambda_inv_0_6_p49 - s19 * Lambda_inv_0_6_p48 -
      inverse_D10_p83_lanes[1] * Lambda_inv_0_6_p53;
  const Real Lambda_inv_0_6_p56 = -Lambda_inv_0_6_p52 + inverse_D8_p16_lanes[1] *
      Lambda_inv_0_6_p53;
  const Real Lambda_inv_0_6_p57 = Lambda_inv_0_6_p49 - inverse_D8_p17_lanes[1] * Lambda_inv_0_6_p53;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p57_lanes = -(c12 * Lambda_inv_0_0_p48_lanes);

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p58 = 0.269 * Lambda_inv_0_6_p52 - inverse_D10_p84_lanes[1] *
      Lambda_inv_0_6_p53;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_3_p68_lanes = c12 * Lambda_inv_0_3_p50_lanes + s12 *
      Lambda_inv_0_3_p55_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p64_lanes = Lambda_inv_0_0_p51_lanes - inverse_D8_p17_lanes[0] *
      Lambda_inv_0_0_p57_lanes;
  const Lanes<2> Lambda_inv_0_1_p88_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_inv_0_0_p37_lanes[1], Lambda_inv_0_7_p47) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_inv_0_0_p36_lanes[1],
      Lambda_inv_0_7_p46));

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_3_p72_lanes = s12 * Lambda_inv_0_3_p50_lanes - c12 *
      Lambda_inv_0_3_p55_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_0_0_p65_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_inv_0_0_p37_lanes[0], Lambda_inv_0_6_p47) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_inv_0_0_p36_lanes[0],
      Lambda_inv_0_6_p46));

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_11_p1 = c19 * Lambda_inv_0_2_p40_lanes[1] + s19 * Lambda_inv_0_8_p24;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p67_lanes = 0.269 * Lambda_inv_0_0_p51_lanes - s12 *
      Lambda_inv_0_0_p48_lanes - inverse_D10_p83_lanes[0] * Lambda_inv_0_0_p57_lanes;
  const Lanes<8> Lambda_inv_0_0_p69_lanes = -detail::make_pack<Real>(Lambda_inv_0_0_p54_lanes[0],
      Lambda_inv_0_0_p54_lanes[1], Lambda_inv_0_0_p54_lanes[2], Lambda_inv_0_3_p68_lanes[3],
      Lambda_inv_0_3_p68_lanes[4], Lambda_inv_0_3_p68_lanes[5], Lambda_inv_0_0_p54_lanes[0],
      Lambda_inv_0_0_p54_lanes[0]) + inverse_D8_p16_lanes[0] * Lambda_inv_0_0_p57_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p61 = inverse_D9_p7_lanes[1] * Lambda_inv_0_7_p58;
  const Real Lambda_inv_0_7_p62 = c18 * Lambda_inv_0_7_p52 - s18 * Lambda_inv_0_7_p55 -
      inverse_D9_p9_lanes[1] * Lambda_inv_0_7_p58;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p60 = s18 * Lambda_inv_0_6_p55 + c18 * Lambda_inv_0_6_p58;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p73_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[1],
      Lambda_inv_0_0_p54_lanes[2], Lambda_inv_0_3_p68_lanes[3], Lambda_inv_0_3_p68_lanes[4],
      Lambda_inv_0_3_p68_lanes[5], Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[0]) -
      inverse_D10_p84_lanes[0] * Lambda_inv_0_0_p57_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p61 = inverse_D9_p7_lanes[1] * Lambda_inv_0_6_p60;
  const Real Lambda_inv_0_7_p63 = c18 * Lambda_inv_0_7_p53 - s18 * Lambda_inv_0_7_p54 -
      inverse_D8_p80_lanes[1] * Lambda_inv_0_7_p58;
  const Real Lambda_inv_0_7_p64 = -(Lambda_inv_0_1_p88_lanes[1] - inverse_D8_p18_lanes[1] *
      Lambda_inv_0_7_p51) - inverse_D8_p81_lanes[1] * Lambda_inv_0_7_p58;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_9_p3_lanes = detail::make_pack<Real>(Lambda_inv_0_3_p32_lanes[1],
      Lambda_inv_0_3_p32_lanes[1], Lambda_inv_0_1_p43_lanes[1], Lambda_inv_0_5_p6_lanes[1],
      Lambda_inv_0_3_p32_lanes[1], Lambda_inv_0_3_p32_lanes[1], Lambda_inv_0_3_p32_lanes[1],
      Lambda_inv_0_3_p32_lanes[1]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_inv_0_6_p42, Lambda_inv_0_6_p42, Lambda_inv_0_7_p33,
      Lambda_inv_0_11_p1, Lambda_inv_0_6_p42, Lambda_inv_0_6_p42, Lambda_inv_0_6_p42,
      Lambda_inv_0_6_p42);
  const Lanes<8> Lambda_inv_0_8_p53_lanes = detail::make_pack<Real>(-(0.086 * Lambda_inv_0_11_p1),
      Lambda_inv_0_0_p21_lanes[1], Lambda_inv_0_1_p42_lanes[1], Lambda_inv_0_2_p49_lanes[1],
      -(0.086 * Lambda_inv_0_11_p1), -(0.086 * Lambda_inv_0_11_p1), -(0.086 * Lambda_inv_0_11_p1),
      -(0.086 * Lambda_inv_0_11_p1)) - (-0.04672761636452121) *
      detail::make_pack<Real>(Lambda_inv_0_2_p50_lanes[1], Lambda_inv_0_6_p42, Lambda_inv_0_7_p33,
      Lambda_inv_0_11_p1, Lambda_inv_0_2_p50_lanes[1], Lambda_inv_0_2_p50_lanes[1],
      Lambda_inv_0_2_p50_lanes[1], Lambda_inv_0_2_p50_lanes[1]);

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p62 = c18 * Lambda_inv_0_6_p55 - s18 * Lambda_inv_0_6_p58 -
      inverse_D9_p9_lanes[1] * Lambda_inv_0_6_p60;
  const Real Lambda_inv_0_6_p63 = c18 * Lambda_inv_0_6_p56 - s18 * Lambda_inv_0_6_p57 -
      inverse_D8_p80_lanes[1] * Lambda_inv_0_6_p60;
  const Real Lambda_inv_0_6_p64 = -(Lambda_inv_0_0_p65_lanes[1] - inverse_D8_p18_lanes[1] *
      Lambda_inv_0_6_p53) - inverse_D8_p81_lanes[1] * Lambda_inv_0_6_p60;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p81_lanes = s11 * Lambda_inv_0_0_p67_lanes + c11 *
      Lambda_inv_0_0_p73_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p65 = s18 * Lambda_inv_0_7_p53 + c18 * Lambda_inv_0_7_p54 -
      inverse_D8_p82_lanes[1] * Lambda_inv_0_7_p58;
  const Real Lambda_inv_0_6_p65 = s18 * Lambda_inv_0_6_p56 + c18 * Lambda_inv_0_6_p57 -
      inverse_D8_p82_lanes[1] * Lambda_inv_0_6_p60;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_8_p56_lanes = s20 *
      detail::make_pack<Real>(Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_9_p3_lanes[1],
      Lambda_inv_0_9_p3_lanes[2], Lambda_inv_0_9_p3_lanes[3], Lambda_inv_0_2_p51_lanes[1],
      Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1]) + c20 *
      Lambda_inv_0_8_p53_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p86_lanes = inverse_D9_p7_lanes[0] * Lambda_inv_0_0_p81_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p66 = c17 * Lambda_inv_0_7_p61 - s17 * Lambda_inv_0_7_p62;
  const Real Lambda_inv_0_7_p67 = s17 * Lambda_inv_0_7_p64 - c17 * Lambda_inv_0_7_p63;
  const Real Lambda_inv_0_6_p66 = c17 * Lambda_inv_0_6_p61 - s17 * Lambda_inv_0_6_p62;
  const Real Lambda_inv_0_6_p67 = s17 * Lambda_inv_0_6_p64 - c17 * Lambda_inv_0_6_p63;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p88_lanes = c11 * Lambda_inv_0_0_p67_lanes - s11 *
      Lambda_inv_0_0_p73_lanes - inverse_D9_p9_lanes[0] * Lambda_inv_0_0_p81_lanes;
  const Lanes<8> Lambda_inv_0_0_p89_lanes = c11 * Lambda_inv_0_0_p69_lanes - s11 *
      Lambda_inv_0_0_p64_lanes - inverse_D8_p80_lanes[0] * Lambda_inv_0_0_p81_lanes;
  const Lanes<8> Lambda_inv_0_0_p92_lanes = s11 * Lambda_inv_0_0_p69_lanes + c11 *
      Lambda_inv_0_0_p64_lanes - inverse_D8_p82_lanes[0] * Lambda_inv_0_0_p81_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_8_p57 = Lambda_inv_0_2_p62_lanes[1] - inverse_D10_p28_lanes[1] *
      Lambda_inv_0_8_p56_lanes[0];
  const Real Lambda_inv_0_8_p58 = Lambda_inv_0_11_p1 - inverse_D10_p29_lanes[1] *
      Lambda_inv_0_8_p56_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p68 = c17 * Lambda_inv_0_7_p62 + s17 * Lambda_inv_0_7_p61 + 0.282 *
      Lambda_inv_0_7_p65 - inverse_D8_p149_lanes[1] * Lambda_inv_0_7_p66;
  const Real Lambda_inv_0_7_p69 = 0.282 * Lambda_inv_0_7_p67 - inverse_D8_p150_lanes[1] *
      Lambda_inv_0_7_p66;
  const Real Lambda_inv_0_6_p68 = 0.282 * Lambda_inv_0_6_p67 - inverse_D8_p150_lanes[1] *
      Lambda_inv_0_6_p66;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p97_lanes = c10 * Lambda_inv_0_0_p86_lanes - s10 *
      Lambda_inv_0_0_p88_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p69 = c17 * Lambda_inv_0_6_p62 + s17 * Lambda_inv_0_6_p61 + 0.282 *
      Lambda_inv_0_6_p65 - inverse_D8_p149_lanes[1] * Lambda_inv_0_6_p66;
  const Real Lambda_inv_0_7_p70 = -Lambda_inv_0_7_p67 + inverse_D6_p31_lanes[1] *
      Lambda_inv_0_7_p66;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p99_lanes = inverse_D8_p149_lanes[0] * Lambda_inv_0_0_p97_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p71 = c16 * Lambda_inv_0_7_p68 - s16 * Lambda_inv_0_7_p69;
  const Real Lambda_inv_0_7_p72 = Lambda_inv_0_7_p65 - inverse_D6_p33_lanes[1] * Lambda_inv_0_7_p66;
  const Real Lambda_inv_0_6_p70 = -Lambda_inv_0_6_p67 + inverse_D6_p31_lanes[1] *
      Lambda_inv_0_6_p66;
  const Real Lambda_inv_0_6_p71 = Lambda_inv_0_6_p65 - inverse_D6_p33_lanes[1] * Lambda_inv_0_6_p66;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_0_2_p133_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_inv_0_0_p37_lanes[2], Lambda_inv_0_8_p58) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_inv_0_0_p36_lanes[2],
      Lambda_inv_0_8_p57));

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p106_lanes = c10 * Lambda_inv_0_0_p88_lanes + s10 *
      Lambda_inv_0_0_p86_lanes + 0.282 * Lambda_inv_0_0_p92_lanes - Lambda_inv_0_0_p99_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p72 = c16 * Lambda_inv_0_6_p69 - s16 * Lambda_inv_0_6_p68;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p107_lanes = Lambda_inv_0_0_p92_lanes - inverse_D6_p33_lanes[0] *
      Lambda_inv_0_0_p97_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p109_lanes = -(detail::make_pack<Real>(Lambda_inv_0_0_p65_lanes[0],
      Lambda_inv_0_1_p88_lanes[0], Lambda_inv_0_2_p133_lanes[0], Lambda_inv_0_3_p72_lanes[3],
      Lambda_inv_0_3_p72_lanes[4], Lambda_inv_0_3_p72_lanes[5], Lambda_inv_0_0_p65_lanes[0],
      Lambda_inv_0_0_p65_lanes[0]) - inverse_D8_p18_lanes[0] * Lambda_inv_0_0_p57_lanes) -
      inverse_D8_p81_lanes[0] * Lambda_inv_0_0_p81_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p73 = Lambda_inv_0_0_p2_lanes[1] * Lambda_inv_0_7_p71;
  const Real Lambda_inv_0_6_p73 = Lambda_inv_0_0_p2_lanes[1] * Lambda_inv_0_6_p72;
  const Real Lambda_inv_0_7_p74 = s16 * Lambda_inv_0_7_p68 + c16 * Lambda_inv_0_7_p69 -
      inverse_D7_p8_lanes[1] * Lambda_inv_0_7_p71;
  const Real Lambda_inv_0_6_p74 = s16 * Lambda_inv_0_6_p69 + c16 * Lambda_inv_0_6_p68 -
      inverse_D7_p8_lanes[1] * Lambda_inv_0_6_p72;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p116_lanes = s10 * Lambda_inv_0_0_p109_lanes - c10 *
      Lambda_inv_0_0_p89_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p75 = -(-(s17 * Lambda_inv_0_7_p63 + c17 * Lambda_inv_0_7_p64) +
      inverse_D6_p35_lanes[1] * Lambda_inv_0_7_p66) + inverse_D6_p161_lanes[1] * Lambda_inv_0_7_p71;
  const Real Lambda_inv_0_7_p76 = s16 * Lambda_inv_0_7_p70 + c16 * Lambda_inv_0_7_p72 -
      inverse_D6_p163_lanes[1] * Lambda_inv_0_7_p71;
  const Real Lambda_inv_0_6_p75 = s16 * Lambda_inv_0_6_p70 + c16 * Lambda_inv_0_6_p71 -
      inverse_D6_p163_lanes[1] * Lambda_inv_0_6_p72;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p121_lanes = -Lambda_inv_0_0_p116_lanes + inverse_D6_p31_lanes[0] *
      Lambda_inv_0_0_p97_lanes;
  const Lanes<8> Lambda_inv_0_0_p123_lanes = -(s10 * Lambda_inv_0_0_p89_lanes + c10 *
      Lambda_inv_0_0_p109_lanes) + inverse_D6_p35_lanes[0] * Lambda_inv_0_0_p97_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p76 = -(-(s17 * Lambda_inv_0_6_p63 + c17 * Lambda_inv_0_6_p64) +
      inverse_D6_p35_lanes[1] * Lambda_inv_0_6_p66) + inverse_D6_p161_lanes[1] * Lambda_inv_0_6_p72;
  const Real Lambda_inv_0_7_p77 = s15 * Lambda_inv_0_7_p73 + c15 * Lambda_inv_0_7_p74;
  const Real Lambda_inv_0_6_p77 = s15 * Lambda_inv_0_6_p73 + c15 * Lambda_inv_0_6_p74;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p127_lanes = 0.282 * Lambda_inv_0_0_p116_lanes -
      inverse_D8_p150_lanes[0] * Lambda_inv_0_0_p97_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = 24.5839218 + 0.422 * inverse_D2_p22;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p132_lanes = c9 * Lambda_inv_0_0_p106_lanes - s9 *
      Lambda_inv_0_0_p127_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * inverse_D2_p22);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p135_lanes = Lambda_inv_0_0_p2_lanes[0] * Lambda_inv_0_0_p132_lanes;
  const Lanes<8> Lambda_inv_0_0_p139_lanes = s9 * Lambda_inv_0_0_p106_lanes + c9 *
      Lambda_inv_0_0_p127_lanes - inverse_D7_p8_lanes[0] * Lambda_inv_0_0_p132_lanes;
  const Lanes<8> Lambda_inv_0_0_p141_lanes = -Lambda_inv_0_0_p123_lanes + inverse_D6_p161_lanes[0] *
      Lambda_inv_0_0_p132_lanes;
  const Lanes<8> Lambda_inv_0_0_p142_lanes = s9 * Lambda_inv_0_0_p121_lanes + c9 *
      Lambda_inv_0_0_p107_lanes - inverse_D6_p163_lanes[0] * Lambda_inv_0_0_p132_lanes;
  const Lanes<8> Lambda_inv_0_0_p143_lanes = c9 * Lambda_inv_0_0_p121_lanes - s9 *
      Lambda_inv_0_0_p107_lanes - inverse_D6_p165_lanes[0] * Lambda_inv_0_0_p132_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p2 = c3 * inverse_D2_p20 - inverse_D2_p17;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p3 = inverse_D1_p1 * inverse_D2;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p151_lanes = s8 * Lambda_inv_0_0_p135_lanes + c8 *
      Lambda_inv_0_0_p139_lanes;
  const Lanes<8> Lambda_inv_0_0_p152_lanes = c8 * Lambda_inv_0_0_p141_lanes - s8 *
      Lambda_inv_0_0_p142_lanes;
  const Lanes<8> Lambda_inv_0_0_p153_lanes = c8 * Lambda_inv_0_0_p135_lanes - s8 *
      Lambda_inv_0_0_p139_lanes;
  const Lanes<8> Lambda_inv_0_0_p154_lanes = s8 * Lambda_inv_0_0_p141_lanes + c8 *
      Lambda_inv_0_0_p142_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p159_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1_lanes[0],
      Lambda_inv_0_0_p1_lanes[0], Lambda_inv_0_0_p1_lanes[0], Lambda_inv_0_0_p1_lanes[0],
      Lambda_inv_0_0_p1_lanes[0], Lambda_inv_0_0_p1_lanes[0], Lambda_inv_0_0_p1_lanes[1],
      Lambda_inv_0_0_p1_lanes[1]) * detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[0],
      Lambda_inv_0_0_p151_lanes[1], Lambda_inv_0_0_p151_lanes[2], Lambda_inv_0_0_p151_lanes[3],
      Lambda_inv_0_0_p151_lanes[4], Lambda_inv_0_0_p151_lanes[5], Lambda_inv_0_6_p77,
      Lambda_inv_0_7_p77);

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p4 = 0.031999971599999996 + 0.422 * inverse_D1_p2;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p160_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p143_lanes[0],
      Lambda_inv_0_0_p143_lanes[1], Lambda_inv_0_0_p143_lanes[2], Lambda_inv_0_0_p143_lanes[3],
      Lambda_inv_0_0_p143_lanes[4], Lambda_inv_0_0_p143_lanes[5], c16 * Lambda_inv_0_6_p70 - s16 *
      Lambda_inv_0_6_p71 - inverse_D6_p165_lanes[1] * Lambda_inv_0_6_p72, c16 * Lambda_inv_0_7_p70 -
      s16 * Lambda_inv_0_7_p72 - inverse_D6_p165_lanes[1] * Lambda_inv_0_7_p71) -
      detail::make_pack<Real>(inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[1], inverse_D6_p294_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[0], Lambda_inv_0_0_p151_lanes[1],
      Lambda_inv_0_0_p151_lanes[2], Lambda_inv_0_0_p151_lanes[3], Lambda_inv_0_0_p151_lanes[4],
      Lambda_inv_0_0_p151_lanes[5], Lambda_inv_0_6_p77, Lambda_inv_0_7_p77);
  const Lanes<8> Lambda_inv_0_0_p161_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p152_lanes[0],
      Lambda_inv_0_0_p152_lanes[1], Lambda_inv_0_0_p152_lanes[2], Lambda_inv_0_0_p152_lanes[3],
      Lambda_inv_0_0_p152_lanes[4], Lambda_inv_0_0_p152_lanes[5], c15 * Lambda_inv_0_6_p76 - s15 *
      Lambda_inv_0_6_p75, c15 * Lambda_inv_0_7_p75 - s15 * Lambda_inv_0_7_p76) -
      detail::make_pack<Real>(inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[1], inverse_D6_p292_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[0], Lambda_inv_0_0_p151_lanes[1],
      Lambda_inv_0_0_p151_lanes[2], Lambda_inv_0_0_p151_lanes[3], Lambda_inv_0_0_p151_lanes[4],
      Lambda_inv_0_0_p151_lanes[5], Lambda_inv_0_6_p77, Lambda_inv_0_7_p77);
  const Lanes<8> Lambda_inv_0_0_p162_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p153_lanes[0],
      Lambda_inv_0_0_p153_lanes[1], Lambda_inv_0_0_p153_lanes[2], Lambda_inv_0_0_p153_lanes[3],
      Lambda_inv_0_0_p153_lanes[4], Lambda_inv_0_0_p153_lanes[5], c15 * Lambda_inv_0_6_p73 - s15 *
      Lambda_inv_0_6_p74, c15 * Lambda_inv_0_7_p73 - s15 * Lambda_inv_0_7_p74) -
      detail::make_pack<Real>(inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[1], inverse_D6_p332_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[0], Lambda_inv_0_0_p151_lanes[1],
      Lambda_inv_0_0_p151_lanes[2], Lambda_inv_0_0_p151_lanes[3], Lambda_inv_0_0_p151_lanes[4],
      Lambda_inv_0_0_p151_lanes[5], Lambda_inv_0_6_p77, Lambda_inv_0_7_p77);
  const Lanes<8> Lambda_inv_0_0_p163_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p154_lanes[0],
      Lambda_inv_0_0_p154_lanes[1], Lambda_inv_0_0_p154_lanes[2], Lambda_inv_0_0_p154_lanes[3],
      Lambda_inv_0_0_p154_lanes[4], Lambda_inv_0_0_p154_lanes[5], s15 * Lambda_inv_0_6_p76 + c15 *
      Lambda_inv_0_6_p75, s15 * Lambda_inv_0_7_p75 + c15 * Lambda_inv_0_7_p76) -
      detail::make_pack<Real>(inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[1], inverse_D6_p299_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[0], Lambda_inv_0_0_p151_lanes[1],
      Lambda_inv_0_0_p151_lanes[2], Lambda_inv_0_0_p151_lanes[3], Lambda_inv_0_0_p151_lanes[4],
      Lambda_inv_0_0_p151_lanes[5], Lambda_inv_0_6_p77, Lambda_inv_0_7_p77);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p5 = inverse_D1_p4 * inverse_D2;
  const Real inverse_D1_p6 = inverse_D2_p22 - inverse_D1_p1 * inverse_D1_p3;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p173_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_inv_0_0_p160_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_inv_0_0_p161_lanes;
  const Lanes<8> Lambda_inv_0_0_p175_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p160_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_inv_0_0_p161_lanes;
  const Lanes<8> Lambda_inv_0_0_p177_lanes = Lambda_inv_0_0_p151_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p178_lanes = Lambda_inv_0_0_p132_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p179_lanes = Lambda_inv_0_0_p97_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p180_lanes = Lambda_inv_0_0_p81_lanes * inverse_D10_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p182_lanes = Lambda_inv_0_0_p57_lanes * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p185_lanes = Lambda_inv_0_0_p32_lanes * inverse_D12_lanes[0];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p186_lanes = 0.086 * Lambda_inv_0_0_p21_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p187_lanes = detail::make_pack<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_pack<Real>(Lambda_inv_0_0_p21_lanes[0],
      Lambda_inv_0_1_p42_lanes[0], Lambda_inv_0_2_p50_lanes[0], Lambda_inv_0_3_p28_lanes[0],
      Lambda_inv_0_3_p28_lanes[1], Lambda_inv_0_3_p28_lanes[2], Lambda_inv_0_0_p21_lanes[0],
      Lambda_inv_0_0_p21_lanes[0]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p189_lanes = Lambda_inv_0_0_p180_lanes *
      Lambda_inv_0_0_p81_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p192_lanes = 0.226 * Lambda_inv_0_0_p163_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_inv_0_0_p173_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p198_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p159_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_inv_0_0_p162_lanes + Lambda_inv_0_0_p192_lanes);

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_9_p13_lanes = 3.0523172236718206 *
      detail::make_pack<Real>(Lambda_inv_0_6_p42, Lambda_inv_0_6_p42, Lambda_inv_0_7_p33,
      Lambda_inv_0_11_p1, Lambda_inv_0_6_p42, Lambda_inv_0_6_p42, Lambda_inv_0_6_p42,
      Lambda_inv_0_6_p42);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p199_lanes = inverse_D5_p73 * Lambda_inv_0_0_p198_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_9_p14_lanes = 17.32841575379867 *
      detail::make_pack<Real>(Lambda_inv_0_6_p42, Lambda_inv_0_6_p42, Lambda_inv_0_7_p33,
      Lambda_inv_0_11_p1, Lambda_inv_0_6_p42, Lambda_inv_0_6_p42, Lambda_inv_0_6_p42,
      Lambda_inv_0_6_p42);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p7 = s2 * (inverse_D1_p6 - (inverse_D2_p19 + inverse_D2_p21 -
      inverse_D1_p4 * inverse_D1_p5)) + c2 * (2.0 * (inverse_D1_p2 - inverse_D1_p1 *
      inverse_D1_p5));

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p112 = Lambda_inv_0_0_p198_lanes[7] * inverse_D6;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_8_p68_lanes = c20 *
      detail::make_pack<Real>(Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_9_p3_lanes[1],
      Lambda_inv_0_9_p3_lanes[2], Lambda_inv_0_9_p3_lanes[3], Lambda_inv_0_2_p51_lanes[1],
      Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1]) - s20 *
      Lambda_inv_0_8_p53_lanes - inverse_D11_p4_lanes[1] * Lambda_inv_0_8_p56_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p112 = Lambda_inv_0_0_p198_lanes[6] * inverse_D6;
  const Lanes<8> Lambda_inv_0_0_p205_lanes = Lambda_inv_0_0_p198_lanes * inverse_D6;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_9_p16_lanes = inverse_D10_p29_lanes[1] * Lambda_inv_0_8_p56_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p206_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_inv_0_0_p175_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_inv_0_0_p159_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_inv_0_0_p162_lanes) -
      Lambda_inv_0_0_p199_lanes;
  const Lanes<8> Lambda_inv_0_0_p207_lanes = 0.226 * Lambda_inv_0_0_p175_lanes - inverse_D5_p72 *
      Lambda_inv_0_0_p198_lanes;
  const Lanes<8> Lambda_inv_0_0_p208_lanes = Lambda_inv_0_0_p175_lanes - inverse_D5_p71 *
      Lambda_inv_0_0_p198_lanes;
  const Lanes<8> Lambda_inv_0_0_p210_lanes = Lambda_inv_0_0_p173_lanes + inverse_D4_p15 *
      Lambda_inv_0_0_p198_lanes;
  const Lanes<8> Lambda_inv_0_0_p211_lanes = Lambda_inv_0_0_p163_lanes - inverse_D4_p16 *
      Lambda_inv_0_0_p198_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_9_p26_lanes = s20 * Lambda_inv_0_9_p13_lanes - c20 *
      Lambda_inv_0_9_p14_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_8_p71 = s19 * Lambda_inv_0_8_p57 - c19 * Lambda_inv_0_8_p58;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p72_lanes = -(c19 * Lambda_inv_0_8_p68_lanes);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_9_p32_lanes = c20 * Lambda_inv_0_9_p13_lanes + s20 *
      Lambda_inv_0_9_p14_lanes - inverse_D10_p28_lanes[1] * Lambda_inv_0_8_p56_lanes;
  const Lanes<8> Lambda_inv_0_8_p77_lanes = detail::make_pack<Real>(Lambda_inv_0_2_p75_lanes[1],
      Lambda_inv_0_9_p26_lanes[1], Lambda_inv_0_9_p26_lanes[2], Lambda_inv_0_9_p26_lanes[3],
      Lambda_inv_0_2_p75_lanes[1], Lambda_inv_0_2_p75_lanes[1], Lambda_inv_0_2_p75_lanes[1],
      Lambda_inv_0_2_p75_lanes[1]) - inverse_D10_p30_lanes[1] * Lambda_inv_0_8_p56_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p223_lanes = Lambda_inv_0_0_p187_lanes *
      Lambda_inv_0_0_p186_lanes[0] + Lambda_inv_0_0_p185_lanes * Lambda_inv_0_0_p32_lanes[0] +
      Lambda_inv_0_0_p182_lanes * Lambda_inv_0_0_p57_lanes[0] + Lambda_inv_0_0_p189_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p79_lanes = Lambda_inv_0_8_p77_lanes - inverse_D8_p17_lanes[1] *
      Lambda_inv_0_8_p72_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p225_lanes = s6 * Lambda_inv_0_0_p206_lanes + c6 *
      Lambda_inv_0_0_p207_lanes + 0.072 * Lambda_inv_0_0_p208_lanes;
  const Lanes<8> Lambda_inv_0_0_p226_lanes = s6 * Lambda_inv_0_0_p210_lanes + c6 *
      Lambda_inv_0_0_p211_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_9_p42_lanes = c19 * Lambda_inv_0_9_p16_lanes + s19 *
      Lambda_inv_0_9_p32_lanes;
  const Lanes<8> Lambda_inv_0_9_p44_lanes = s19 * Lambda_inv_0_9_p16_lanes - c19 *
      Lambda_inv_0_9_p32_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p236_lanes = Lambda_inv_0_0_p225_lanes * inverse_D5;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p85_lanes = 0.269 * Lambda_inv_0_8_p77_lanes - s19 *
      Lambda_inv_0_8_p68_lanes - inverse_D10_p83_lanes[1] * Lambda_inv_0_8_p72_lanes;
  const Lanes<8> Lambda_inv_0_8_p87_lanes = -detail::make_pack<Real>(Lambda_inv_0_8_p71,
      Lambda_inv_0_9_p42_lanes[1], Lambda_inv_0_9_p42_lanes[2], Lambda_inv_0_9_p42_lanes[3],
      Lambda_inv_0_8_p71, Lambda_inv_0_8_p71, Lambda_inv_0_8_p71, Lambda_inv_0_8_p71) +
      inverse_D8_p16_lanes[1] * Lambda_inv_0_8_p72_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p238_lanes = -(0.072 * Lambda_inv_0_0_p226_lanes) + inverse_D4_p39 *
      Lambda_inv_0_0_p225_lanes;
  const Lanes<8> Lambda_inv_0_0_p239_lanes = c6 * Lambda_inv_0_0_p206_lanes - s6 *
      Lambda_inv_0_0_p207_lanes - inverse_D4_p40 * Lambda_inv_0_0_p225_lanes;
  const Lanes<8> Lambda_inv_0_0_p240_lanes = c6 * Lambda_inv_0_0_p210_lanes - s6 *
      Lambda_inv_0_0_p211_lanes - inverse_D3_p7 * Lambda_inv_0_0_p225_lanes;
  const Lanes<8> Lambda_inv_0_0_p241_lanes = Lambda_inv_0_0_p208_lanes - inverse_D3_p6 *
      Lambda_inv_0_0_p225_lanes;

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p6 - s2 * inverse_D1_p7));

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p93_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_inv_0_8_p71, Lambda_inv_0_9_p42_lanes[1],
      Lambda_inv_0_9_p42_lanes[2], Lambda_inv_0_9_p42_lanes[3], Lambda_inv_0_8_p71,
      Lambda_inv_0_8_p71, Lambda_inv_0_8_p71, Lambda_inv_0_8_p71) - inverse_D10_p84_lanes[1] *
      Lambda_inv_0_8_p72_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p244_lanes = Lambda_inv_0_0_p226_lanes - inverse_D3_p8 *
      Lambda_inv_0_0_p225_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p251_lanes = Lambda_inv_0_0_p223_lanes + Lambda_inv_0_0_p179_lanes *
      Lambda_inv_0_0_p97_lanes[0] + Lambda_inv_0_0_p178_lanes * Lambda_inv_0_0_p132_lanes[0] +
      Lambda_inv_0_0_p177_lanes * Lambda_inv_0_0_p151_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p255_lanes = s5 * Lambda_inv_0_0_p240_lanes - c5 *
      Lambda_inv_0_0_p241_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p257_lanes = Lambda_inv_0_0_p251_lanes + Lambda_inv_0_0_p205_lanes *
      Lambda_inv_0_0_p198_lanes[0];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p99_lanes = s18 * Lambda_inv_0_8_p85_lanes + c18 *
      Lambda_inv_0_8_p93_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p259_lanes = -(s5 * Lambda_inv_0_0_p238_lanes + c5 *
      Lambda_inv_0_0_p239_lanes);
  const Lanes<8> Lambda_inv_0_0_p269_lanes = Lambda_inv_0_0_p259_lanes * inverse_D4;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p104_lanes = inverse_D9_p7_lanes[1] * Lambda_inv_0_8_p99_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p270_lanes = -(s5 * Lambda_inv_0_0_p239_lanes - c5 *
      Lambda_inv_0_0_p238_lanes + 0.21799999999999997 * Lambda_inv_0_0_p244_lanes);
  const Lanes<8> Lambda_inv_0_0_p277_lanes = -(s5 * Lambda_inv_0_0_p241_lanes + c5 *
      Lambda_inv_0_0_p240_lanes) - inverse_D2_p7 * Lambda_inv_0_0_p259_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p106_lanes = c18 * Lambda_inv_0_8_p85_lanes - s18 *
      Lambda_inv_0_8_p93_lanes - inverse_D9_p9_lanes[1] * Lambda_inv_0_8_p99_lanes;
  const Lanes<8> Lambda_inv_0_8_p107_lanes = -(detail::make_pack<Real>(Lambda_inv_0_2_p133_lanes[1],
      Lambda_inv_0_9_p44_lanes[1], Lambda_inv_0_9_p44_lanes[2], Lambda_inv_0_9_p44_lanes[3],
      Lambda_inv_0_2_p133_lanes[1], Lambda_inv_0_2_p133_lanes[1], Lambda_inv_0_2_p133_lanes[1],
      Lambda_inv_0_2_p133_lanes[1]) - inverse_D8_p18_lanes[1] * Lambda_inv_0_8_p72_lanes) -
      inverse_D8_p81_lanes[1] * Lambda_inv_0_8_p99_lanes;
  const Lanes<8> Lambda_inv_0_8_p108_lanes = c18 * Lambda_inv_0_8_p87_lanes - s18 *
      Lambda_inv_0_8_p79_lanes - inverse_D8_p80_lanes[1] * Lambda_inv_0_8_p99_lanes;
  const Lanes<8> Lambda_inv_0_8_p111_lanes = s18 * Lambda_inv_0_8_p87_lanes + c18 *
      Lambda_inv_0_8_p79_lanes - inverse_D8_p82_lanes[1] * Lambda_inv_0_8_p99_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p280_lanes = c4 * (-(0.21799999999999997 *
      Lambda_inv_0_0_p255_lanes) + inverse_D3_p37 * Lambda_inv_0_0_p259_lanes);
  const Lanes<8> Lambda_inv_0_0_p282_lanes = s4 * (Lambda_inv_0_0_p244_lanes + inverse_D2_p6 *
      Lambda_inv_0_0_p259_lanes);
  const Lanes<8> Lambda_inv_0_0_p285_lanes = s4 * (Lambda_inv_0_0_p270_lanes - inverse_D3_p36 *
      Lambda_inv_0_0_p259_lanes) + Lambda_inv_0_0_p280_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p119_lanes = c17 * Lambda_inv_0_8_p104_lanes - s17 *
      Lambda_inv_0_8_p106_lanes;
  const Lanes<8> Lambda_inv_0_8_p120_lanes = s17 * Lambda_inv_0_8_p107_lanes - c17 *
      Lambda_inv_0_8_p108_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p287_lanes = inverse_D2_p16 * Lambda_inv_0_0_p285_lanes;
  const Lanes<8> Lambda_inv_0_0_p289_lanes = Lambda_inv_0_0_p285_lanes * inverse_D3;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p123_lanes = inverse_D8_p149_lanes[1] * Lambda_inv_0_8_p119_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p290_lanes = c4 * (-Lambda_inv_0_0_p255_lanes + inverse_D2_p5 *
      Lambda_inv_0_0_p259_lanes) - Lambda_inv_0_0_p282_lanes - Lambda_inv_0_0_p287_lanes;
  const Lanes<8> Lambda_inv_0_0_p291_lanes = -Lambda_inv_0_0_p277_lanes + inverse_D2_p15 *
      Lambda_inv_0_0_p285_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p132_lanes = c17 * Lambda_inv_0_8_p106_lanes + s17 *
      Lambda_inv_0_8_p104_lanes + 0.282 * Lambda_inv_0_8_p111_lanes - Lambda_inv_0_8_p123_lanes;
  const Lanes<8> Lambda_inv_0_8_p133_lanes = 0.282 * Lambda_inv_0_8_p120_lanes -
      inverse_D8_p150_lanes[1] * Lambda_inv_0_8_p119_lanes;
  const Lanes<8> Lambda_inv_0_8_p134_lanes = -Lambda_inv_0_8_p120_lanes + inverse_D6_p31_lanes[1] *
      Lambda_inv_0_8_p119_lanes;
  const Lanes<8> Lambda_inv_0_8_p135_lanes = Lambda_inv_0_8_p111_lanes - inverse_D6_p33_lanes[1] *
      Lambda_inv_0_8_p119_lanes;
  const Lanes<8> Lambda_inv_0_8_p136_lanes = -(s17 * Lambda_inv_0_8_p108_lanes + c17 *
      Lambda_inv_0_8_p107_lanes) + inverse_D6_p35_lanes[1] * Lambda_inv_0_8_p119_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p297_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p257_lanes[0],
      Lambda_inv_0_0_p257_lanes[1], Lambda_inv_0_0_p257_lanes[2], Lambda_inv_0_0_p257_lanes[3],
      Lambda_inv_0_0_p257_lanes[4], Lambda_inv_0_0_p257_lanes[5], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[0], Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[0]) +
      Lambda_inv_0_0_p236_lanes * Lambda_inv_0_0_p225_lanes[0] + Lambda_inv_0_0_p269_lanes *
      Lambda_inv_0_0_p259_lanes[0] + Lambda_inv_0_0_p289_lanes * Lambda_inv_0_0_p285_lanes[0];
  const Lanes<8> Lambda_inv_0_0_p298_lanes = c3 * Lambda_inv_0_0_p290_lanes - s3 *
      Lambda_inv_0_0_p291_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p146_lanes = c16 * Lambda_inv_0_8_p132_lanes - s16 *
      Lambda_inv_0_8_p133_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p300_lanes = 0.422 * Lambda_inv_0_0_p298_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_8_p151_lanes = Lambda_inv_0_0_p2_lanes[1] * Lambda_inv_0_8_p146_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_0_p303_lanes = Lambda_inv_0_0_p300_lanes * inverse_D2;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_8_p155_lanes = s16 * Lambda_inv_0_8_p132_lanes + c16 *
      Lambda_inv_0_8_p133_lanes - inverse_D7_p8_lanes[1] * Lambda_inv_0_8_p146_lanes;
  const Lanes<8> Lambda_inv_0_8_p157_lanes = -Lambda_inv_0_8_p136_lanes + inverse_D6_p161_lanes[1] *
      Lambda_inv_0_8_p146_lanes;
  const Lanes<8> Lambda_inv_0_8_p158_lanes = s16 * Lambda_inv_0_8_p134_lanes + c16 *
      Lambda_inv_0_8_p135_lanes - inverse_D6_p163_lanes[1] * Lambda_inv_0_8_p146_lanes;
  const Lanes<8> Lambda_inv_0_8_p167_lanes = s15 * Lambda_inv_0_8_p151_lanes + c15 *
      Lambda_inv_0_8_p155_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_0_p308_lanes = s2 * (s3 * Lambda_inv_0_0_p290_lanes + c3 *
      Lambda_inv_0_0_p291_lanes - inverse_D1_p5 * Lambda_inv_0_0_p300_lanes);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p172_lanes = inverse_D6_p294_lanes[1] * Lambda_inv_0_8_p167_lanes;
  const Lanes<8> Lambda_inv_0_8_p175_lanes = Lambda_inv_0_0_p1_lanes[1] * Lambda_inv_0_8_p167_lanes;
  const Lanes<8> Lambda_inv_0_8_p176_lanes = c15 * Lambda_inv_0_8_p157_lanes - s15 *
      Lambda_inv_0_8_p158_lanes - inverse_D6_p292_lanes[1] * Lambda_inv_0_8_p167_lanes;
  const Lanes<8> Lambda_inv_0_8_p177_lanes = c16 * Lambda_inv_0_8_p134_lanes - s16 *
      Lambda_inv_0_8_p135_lanes - inverse_D6_p165_lanes[1] * Lambda_inv_0_8_p146_lanes -
      Lambda_inv_0_8_p172_lanes;
  const Lanes<8> Lambda_inv_0_8_p178_lanes = s15 * Lambda_inv_0_8_p157_lanes + c15 *
      Lambda_inv_0_8_p158_lanes - inverse_D6_p299_lanes[1] * Lambda_inv_0_8_p167_lanes;
  const Lanes<8> Lambda_inv_0_8_p179_lanes = c15 * Lambda_inv_0_8_p151_lanes - s15 *
      Lambda_inv_0_8_p155_lanes - inverse_D6_p332_lanes[1] * Lambda_inv_0_8_p167_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_0_p311_lanes = 0.434 *
      (c2 * (Lambda_inv_0_0_p298_lanes - inverse_D1_p3 * Lambda_inv_0_0_p300_lanes) -
      Lambda_inv_0_0_p308_lanes);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_1_1_p6_lanes = Lambda_inv_0_0_p180_lanes * Lambda_inv_0_0_p81_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p189_lanes = s14 * Lambda_inv_0_8_p177_lanes + c14 *
      Lambda_inv_0_8_p176_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_inv_1_1_p9_lanes = 0.086 * Lambda_inv_0_1_p42_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p191_lanes = c14 * Lambda_inv_0_8_p177_lanes - s14 *
      Lambda_inv_0_8_p176_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_0_p312_lanes = Lambda_inv_0_0_p311_lanes * inverse_D1;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p196_lanes = 0.226 * Lambda_inv_0_8_p178_lanes + (-0.18) *
      Lambda_inv_0_8_p189_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_0_lanes = Lambda_inv_0_0_p297_lanes + Lambda_inv_0_0_p303_lanes *
      Lambda_inv_0_0_p300_lanes[0] + Lambda_inv_0_0_p312_lanes * Lambda_inv_0_0_p311_lanes[0];
  Lambda_inv[0] = Lambda_inv_0_0_lanes[0];
  Lambda_inv[1] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[12] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[2] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[24] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[3] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[36] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[4] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[48] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[5] = Lambda_inv_0_0_lanes[5];
  Lambda_inv[60] = Lambda_inv_0_0_lanes[5];
  Lambda_inv[6] = Lambda_inv_0_0_lanes[6];
  Lambda_inv[72] = Lambda_inv_0_0_lanes[6];
  Lambda_inv[7] = Lambda_inv_0_0_lanes[7];
  Lambda_inv[84] = Lambda_inv_0_0_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p199_lanes = -(c14 * Lambda_inv_0_8_p175_lanes + s14 *
      Lambda_inv_0_8_p179_lanes + Lambda_inv_0_8_p196_lanes);
  const Lanes<8> Lambda_inv_0_8_p200_lanes = inverse_D5_p73 * Lambda_inv_0_8_p199_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_1_1_p17_lanes = Lambda_inv_0_0_p187_lanes * Lambda_inv_1_1_p9_lanes[0] +
      Lambda_inv_0_0_p185_lanes * Lambda_inv_0_0_p32_lanes[1] + Lambda_inv_0_0_p182_lanes *
      Lambda_inv_0_0_p57_lanes[1] + Lambda_inv_1_1_p6_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p205_lanes = Lambda_inv_0_8_p199_lanes * inverse_D6;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_2_2_p6_lanes = Lambda_inv_0_0_p180_lanes * Lambda_inv_0_0_p81_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p206_lanes = (-0.18) * Lambda_inv_0_8_p191_lanes -
      (s14 * Lambda_inv_0_8_p175_lanes - c14 * Lambda_inv_0_8_p179_lanes) -
      Lambda_inv_0_8_p200_lanes;
  const Lanes<8> Lambda_inv_0_8_p207_lanes = 0.226 * Lambda_inv_0_8_p191_lanes - inverse_D5_p72 *
      Lambda_inv_0_8_p199_lanes;
  const Lanes<8> Lambda_inv_0_8_p208_lanes = Lambda_inv_0_8_p191_lanes - inverse_D5_p71 *
      Lambda_inv_0_8_p199_lanes;
  const Lanes<8> Lambda_inv_0_8_p209_lanes = Lambda_inv_0_8_p189_lanes + inverse_D4_p15 *
      Lambda_inv_0_8_p199_lanes;
  const Lanes<8> Lambda_inv_0_8_p210_lanes = Lambda_inv_0_8_p178_lanes - inverse_D4_p16 *
      Lambda_inv_0_8_p199_lanes;
  const Lanes<8> Lambda_inv_0_8_p222_lanes = s6 * Lambda_inv_0_8_p209_lanes + c6 *
      Lambda_inv_0_8_p210_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_3_3_p6_lanes = Lambda_inv_0_0_p180_lanes * Lambda_inv_0_0_p81_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p225_lanes = s6 * Lambda_inv_0_8_p206_lanes + c6 *
      Lambda_inv_0_8_p207_lanes + 0.072 * Lambda_inv_0_8_p208_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_2_2_p15_lanes = Lambda_inv_0_0_p187_lanes *
      Lambda_inv_0_2_p50_lanes[0] + Lambda_inv_0_0_p185_lanes * Lambda_inv_0_0_p32_lanes[2] +
      Lambda_inv_0_0_p182_lanes * Lambda_inv_0_0_p57_lanes[2] + Lambda_inv_2_2_p6_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_1_1_p20_lanes = Lambda_inv_1_1_p17_lanes + Lambda_inv_0_0_p179_lanes *
      Lambda_inv_0_0_p97_lanes[1] + Lambda_inv_0_0_p178_lanes * Lambda_inv_0_0_p132_lanes[1] +
      Lambda_inv_0_0_p177_lanes * Lambda_inv_0_0_p151_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p232_lanes = Lambda_inv_0_8_p225_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_1_1_p21_lanes = Lambda_inv_1_1_p20_lanes + Lambda_inv_0_0_p205_lanes *
      Lambda_inv_0_0_p198_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p234_lanes = -(0.072 * Lambda_inv_0_8_p222_lanes) + inverse_D4_p39 *
      Lambda_inv_0_8_p225_lanes;
  const Lanes<8> Lambda_inv_0_8_p235_lanes = c6 * Lambda_inv_0_8_p206_lanes - s6 *
      Lambda_inv_0_8_p207_lanes - inverse_D4_p40 * Lambda_inv_0_8_p225_lanes;
  const Lanes<8> Lambda_inv_0_8_p236_lanes = c6 * Lambda_inv_0_8_p209_lanes - s6 *
      Lambda_inv_0_8_p210_lanes - inverse_D3_p7 * Lambda_inv_0_8_p225_lanes;
  const Lanes<8> Lambda_inv_0_8_p237_lanes = Lambda_inv_0_8_p208_lanes - inverse_D3_p6 *
      Lambda_inv_0_8_p225_lanes;
  const Lanes<8> Lambda_inv_0_8_p238_lanes = Lambda_inv_0_8_p222_lanes - inverse_D3_p8 *
      Lambda_inv_0_8_p225_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_6_8_p1_lanes = Lambda_inv_0_8_p167_lanes * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_6_8_p2_lanes = Lambda_inv_0_8_p146_lanes * inverse_D8_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_6_8_p3_lanes = Lambda_inv_0_8_p56_lanes * inverse_D12_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_6_8_p4_lanes = Lambda_inv_0_8_p72_lanes * inverse_D11_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p5_lanes = Lambda_inv_0_8_p99_lanes * inverse_D10_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p6_lanes = Lambda_inv_0_8_p119_lanes * inverse_D9_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_3_3_p16_lanes = Lambda_inv_0_0_p187_lanes *
      Lambda_inv_0_3_p28_lanes[0] + Lambda_inv_0_0_p185_lanes * Lambda_inv_0_0_p32_lanes[3] +
      Lambda_inv_0_0_p182_lanes * Lambda_inv_0_0_p57_lanes[3] + Lambda_inv_3_3_p6_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_inv_4_5_p2_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p178_lanes[5],
      Lambda_inv_6_8_p2_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p132_lanes[4],
      Lambda_inv_0_8_p146_lanes[2]);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p250_lanes = s5 * Lambda_inv_0_8_p236_lanes - c5 *
      Lambda_inv_0_8_p237_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_inv_4_4_p2_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p178_lanes[4],
      Lambda_inv_6_8_p2_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p132_lanes[4],
      Lambda_inv_0_8_p146_lanes[2]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_inv_4_5_p3_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p177_lanes[5],
      Lambda_inv_6_8_p1_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[4],
      Lambda_inv_0_8_p167_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p3_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p177_lanes[4],
      Lambda_inv_6_8_p1_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[4],
      Lambda_inv_0_8_p167_lanes[2]);
  const Lanes<8> Lambda_inv_2_2_p19_lanes = Lambda_inv_2_2_p15_lanes + Lambda_inv_0_0_p179_lanes *
      Lambda_inv_0_0_p97_lanes[2] + Lambda_inv_0_0_p178_lanes * Lambda_inv_0_0_p132_lanes[2] +
      Lambda_inv_0_0_p177_lanes * Lambda_inv_0_0_p151_lanes[2];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_inv_4_5_p4_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p185_lanes[5],
      Lambda_inv_6_8_p3_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p32_lanes[4],
      Lambda_inv_0_8_p56_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p4_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p185_lanes[4],
      Lambda_inv_6_8_p3_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p32_lanes[4],
      Lambda_inv_0_8_p56_lanes[2]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_4_5_p5_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p182_lanes[5],
      Lambda_inv_6_8_p4_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p57_lanes[4],
      Lambda_inv_0_8_p72_lanes[2]);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p253_lanes = -(s5 * Lambda_inv_0_8_p234_lanes + c5 *
      Lambda_inv_0_8_p235_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_4_4_p5_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p182_lanes[4],
      Lambda_inv_6_8_p4_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p57_lanes[4],
      Lambda_inv_0_8_p72_lanes[2]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_4_5_p6_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p180_lanes[5],
      Lambda_inv_6_8_p5_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p81_lanes[4],
      Lambda_inv_0_8_p99_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p6_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p180_lanes[4],
      Lambda_inv_6_8_p5_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p81_lanes[4],
      Lambda_inv_0_8_p99_lanes[2]);

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_inv_4_5_p7_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p179_lanes[5],
      Lambda_inv_6_8_p6_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p97_lanes[4],
      Lambda_inv_0_8_p119_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p7_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p179_lanes[4],
      Lambda_inv_6_8_p6_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p97_lanes[4],
      Lambda_inv_0_8_p119_lanes[2]);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p263_lanes = Lambda_inv_0_8_p253_lanes * inverse_D4;
  const Lanes<8> Lambda_inv_0_8_p264_lanes = -(s5 * Lambda_inv_0_8_p235_lanes - c5 *
      Lambda_inv_0_8_p234_lanes + 0.21799999999999997 * Lambda_inv_0_8_p238_lanes);
  const Lanes<8> Lambda_inv_0_8_p270_lanes = -(s5 * Lambda_inv_0_8_p237_lanes + c5 *
      Lambda_inv_0_8_p236_lanes) - inverse_D2_p7 * Lambda_inv_0_8_p253_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_6_8_p7_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_inv_0_2_p50_lanes[1], Lambda_inv_0_6_p42, Lambda_inv_0_7_p33,
      Lambda_inv_0_11_p1, Lambda_inv_0_2_p50_lanes[1], Lambda_inv_0_2_p50_lanes[1],
      Lambda_inv_0_2_p50_lanes[1], Lambda_inv_0_2_p50_lanes[1]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_5_5_p3_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p180_lanes[5],
      Lambda_inv_6_8_p5_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p81_lanes[5],
      Lambda_inv_0_8_p99_lanes[3]);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p272_lanes = c4 * (-(0.21799999999999997 *
      Lambda_inv_0_8_p250_lanes) + inverse_D3_p37 * Lambda_inv_0_8_p253_lanes);
  const Lanes<8> Lambda_inv_0_8_p274_lanes = s4 * (Lambda_inv_0_8_p238_lanes + inverse_D2_p6 *
      Lambda_inv_0_8_p253_lanes);
  const Lanes<8> Lambda_inv_0_8_p276_lanes = s4 * (Lambda_inv_0_8_p264_lanes - inverse_D3_p36 *
      Lambda_inv_0_8_p253_lanes) + Lambda_inv_0_8_p272_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_3_3_p19_lanes = Lambda_inv_3_3_p16_lanes + Lambda_inv_0_0_p179_lanes *
      Lambda_inv_0_0_p97_lanes[3] + Lambda_inv_0_0_p178_lanes * Lambda_inv_0_0_p132_lanes[3] +
      Lambda_inv_0_0_p177_lanes * Lambda_inv_0_0_p151_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_7_p1 = Lambda_inv_0_7_p77 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_7_p2 = Lambda_inv_0_7_p71 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_7_p3 = Lambda_inv_0_7_p66 * inverse_D9_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p278_lanes = inverse_D2_p16 * Lambda_inv_0_8_p276_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_7_p4 = Lambda_inv_0_7_p58 * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_6_7_p5 = Lambda_inv_0_7_p51 * inverse_D11_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_4_4_p13_lanes = Lambda_inv_0_0_p187_lanes *
      Lambda_inv_0_3_p28_lanes[1] + detail::make_pack<Real>(Lambda_inv_4_4_p4_lanes[0],
      Lambda_inv_4_4_p4_lanes[0], Lambda_inv_4_4_p4_lanes[0], Lambda_inv_4_4_p4_lanes[0],
      Lambda_inv_4_4_p4_lanes[0], Lambda_inv_4_5_p4_lanes[0], Lambda_inv_4_4_p4_lanes[0],
      Lambda_inv_4_4_p4_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p5_lanes[0],
      Lambda_inv_4_4_p5_lanes[0], Lambda_inv_4_4_p5_lanes[0], Lambda_inv_4_4_p5_lanes[0],
      Lambda_inv_4_4_p5_lanes[0], Lambda_inv_4_5_p5_lanes[0], Lambda_inv_4_4_p5_lanes[0],
      Lambda_inv_4_4_p5_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p6_lanes[0],
      Lambda_inv_4_4_p6_lanes[0], Lambda_inv_4_4_p6_lanes[0], Lambda_inv_4_4_p6_lanes[0],
      Lambda_inv_4_4_p6_lanes[0], Lambda_inv_4_5_p6_lanes[0], Lambda_inv_4_4_p6_lanes[0],
      Lambda_inv_4_4_p6_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_5_p7_lanes[0], Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p2_lanes[0],
      Lambda_inv_4_4_p2_lanes[0], Lambda_inv_4_4_p2_lanes[0], Lambda_inv_4_4_p2_lanes[0],
      Lambda_inv_4_4_p2_lanes[0], Lambda_inv_4_5_p2_lanes[0], Lambda_inv_4_4_p2_lanes[0],
      Lambda_inv_4_4_p2_lanes[0]);

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_6_7_p6 = Lambda_inv_0_7_p45 * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_6_7_p7 = 91.62274020012977 * Lambda_inv_0_1_p42_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p280_lanes = c4 * (-Lambda_inv_0_8_p250_lanes + inverse_D2_p5 *
      Lambda_inv_0_8_p253_lanes) - Lambda_inv_0_8_p274_lanes - Lambda_inv_0_8_p278_lanes;
  const Lanes<8> Lambda_inv_0_8_p281_lanes = -Lambda_inv_0_8_p270_lanes + inverse_D2_p15 *
      Lambda_inv_0_8_p276_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_5_5_p11_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p187_lanes[5],
      Lambda_inv_6_8_p7_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_3_p28_lanes[2],
      Lambda_inv_0_11_p1) + detail::make_pack<Real>(Lambda_inv_0_0_p185_lanes[5],
      Lambda_inv_6_8_p3_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p32_lanes[5],
      Lambda_inv_0_8_p56_lanes[3]) + detail::make_pack<Real>(Lambda_inv_0_0_p182_lanes[5],
      Lambda_inv_6_8_p4_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p57_lanes[5],
      Lambda_inv_0_8_p72_lanes[3]) + Lambda_inv_5_5_p3_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_2_2_p20_lanes = Lambda_inv_2_2_p19_lanes + Lambda_inv_0_0_p205_lanes *
      Lambda_inv_0_0_p198_lanes[2];
  const Lanes<8> Lambda_inv_3_3_p20_lanes = Lambda_inv_3_3_p19_lanes + Lambda_inv_0_0_p205_lanes *
      Lambda_inv_0_0_p198_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p286_lanes = c3 * Lambda_inv_0_8_p280_lanes - s3 *
      Lambda_inv_0_8_p281_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p12_lanes = Lambda_inv_6_8_p5_lanes * Lambda_inv_0_6_p60;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p288_lanes = 0.422 * Lambda_inv_0_8_p286_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_4_4_p15_lanes = Lambda_inv_4_4_p13_lanes +
      detail::make_pack<Real>(Lambda_inv_4_4_p3_lanes[0], Lambda_inv_4_4_p3_lanes[0],
      Lambda_inv_4_4_p3_lanes[0], Lambda_inv_4_4_p3_lanes[0], Lambda_inv_4_4_p3_lanes[0],
      Lambda_inv_4_5_p3_lanes[0], Lambda_inv_4_4_p3_lanes[0], Lambda_inv_4_4_p3_lanes[0]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p205_lanes[4] * Lambda_inv_0_0_p198_lanes[4],
      Lambda_inv_0_0_p205_lanes[4] * Lambda_inv_0_0_p198_lanes[4], Lambda_inv_0_0_p205_lanes[4] *
      Lambda_inv_0_0_p198_lanes[4], Lambda_inv_0_0_p205_lanes[4] * Lambda_inv_0_0_p198_lanes[4],
      Lambda_inv_0_0_p205_lanes[4] * Lambda_inv_0_0_p198_lanes[4], Lambda_inv_0_0_p205_lanes[5] *
      Lambda_inv_0_0_p198_lanes[4], Lambda_inv_0_0_p205_lanes[4] * Lambda_inv_0_0_p198_lanes[4],
      Lambda_inv_0_0_p205_lanes[4] * Lambda_inv_0_0_p198_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p289_lanes = Lambda_inv_0_8_p276_lanes * inverse_D3;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_inv_5_5_p14_lanes = Lambda_inv_5_5_p11_lanes +
      detail::make_pack<Real>(Lambda_inv_0_0_p179_lanes[5], Lambda_inv_6_8_p6_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p97_lanes[5], Lambda_inv_0_8_p119_lanes[3]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p178_lanes[5], Lambda_inv_6_8_p2_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p132_lanes[5], Lambda_inv_0_8_p146_lanes[3]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p177_lanes[5], Lambda_inv_6_8_p1_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p151_lanes[5], Lambda_inv_0_8_p167_lanes[3]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p20_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_0_p186_lanes[1] +
      Lambda_inv_6_8_p3_lanes * Lambda_inv_0_6_p45 + Lambda_inv_6_8_p4_lanes * Lambda_inv_0_6_p53 +
      Lambda_inv_6_8_p12_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_6_6_p7_lanes = detail::make_pack<Real>(91.62274020012977 *
      Lambda_inv_0_0_p21_lanes[1], 91.62274020012977 * Lambda_inv_0_0_p21_lanes[1],
      91.62274020012977 * Lambda_inv_0_0_p21_lanes[1], 91.62274020012977 *
      Lambda_inv_0_0_p21_lanes[1], 91.62274020012977 * Lambda_inv_0_0_p21_lanes[1],
      91.62274020012977 * Lambda_inv_0_0_p21_lanes[1], 91.62274020012977 *
      Lambda_inv_0_0_p21_lanes[1], Lambda_inv_6_7_p7) * Lambda_inv_0_0_p186_lanes[1] +
      detail::make_pack<Real>(Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45,
      Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 *
      inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 * inverse_D12_lanes[1] *
      Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45,
      Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 *
      inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_6_7_p6 * Lambda_inv_0_6_p45) +
      detail::make_pack<Real>(Lambda_inv_0_6_p53 * inverse_D11_lanes[1] * Lambda_inv_0_6_p53,
      Lambda_inv_0_6_p53 * inverse_D11_lanes[1] * Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 *
      inverse_D11_lanes[1] * Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 * inverse_D11_lanes[1] *
      Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 * inverse_D11_lanes[1] * Lambda_inv_0_6_p53,
      Lambda_inv_0_6_p53 * inverse_D11_lanes[1] * Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 *
      inverse_D11_lanes[1] * Lambda_inv_0_6_p53, Lambda_inv_6_7_p5 * Lambda_inv_0_6_p53) +
      detail::make_pack<Real>(Lambda_inv_0_6_p60 * inverse_D10_lanes[1] * Lambda_inv_0_6_p60,
      Lambda_inv_0_6_p60 * inverse_D10_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 *
      inverse_D10_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 * inverse_D10_lanes[1] *
      Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 * inverse_D10_lanes[1] * Lambda_inv_0_6_p60,
      Lambda_inv_0_6_p60 * inverse_D10_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 *
      inverse_D10_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_6_7_p4 * Lambda_inv_0_6_p60) +
      detail::make_pack<Real>(Lambda_inv_0_6_p66 * inverse_D9_lanes[1] * Lambda_inv_0_6_p66,
      Lambda_inv_0_6_p66 * inverse_D9_lanes[1] * Lambda_inv_0_6_p66, Lambda_inv_0_6_p66 *
      inverse_D9_lanes[1] * Lambda_inv_0_6_p66, Lambda_inv_0_6_p66 * inverse_D9_lanes[1] *
      Lambda_inv_0_6_p66, Lambda_inv_0_6_p66 * inverse_D9_lanes[1] * Lambda_inv_0_6_p66,
      Lambda_inv_0_6_p66 * inverse_D9_lanes[1] * Lambda_inv_0_6_p66, Lambda_inv_0_6_p66 *
      inverse_D9_lanes[1] * Lambda_inv_0_6_p66, Lambda_inv_6_7_p3 * Lambda_inv_0_6_p66) +
      detail::make_pack<Real>(Lambda_inv_0_6_p72 * inverse_D8_lanes[1] * Lambda_inv_0_6_p72,
      Lambda_inv_0_6_p72 * inverse_D8_lanes[1] * Lambda_inv_0_6_p72, Lambda_inv_0_6_p72 *
      inverse_D8_lanes[1] * Lambda_inv_0_6_p72, Lambda_inv_0_6_p72 * inverse_D8_lanes[1] *
      Lambda_inv_0_6_p72, Lambda_inv_0_6_p72 * inverse_D8_lanes[1] * Lambda_inv_0_6_p72,
      Lambda_inv_0_6_p72 * inverse_D8_lanes[1] * Lambda_inv_0_6_p72, Lambda_inv_0_6_p72 *
      inverse_D8_lanes[1] * Lambda_inv_0_6_p72, Lambda_inv_6_7_p2 * Lambda_inv_0_6_p72);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_7_8_p4_lanes = Lambda_inv_6_8_p5_lanes * Lambda_inv_0_7_p58;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_8_p297_lanes = s2 * (s3 * Lambda_inv_0_8_p280_lanes + c3 *
      Lambda_inv_0_8_p281_lanes - inverse_D1_p5 * Lambda_inv_0_8_p288_lanes);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_8_8_p6_lanes = Lambda_inv_6_8_p5_lanes * Lambda_inv_0_8_p99_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_7_7_p2 = Lambda_inv_6_7_p7 * Lambda_inv_1_1_p9_lanes[1] +
      Lambda_inv_6_7_p6 * Lambda_inv_0_7_p45 + Lambda_inv_6_7_p5 * Lambda_inv_0_7_p51 +
      Lambda_inv_6_7_p4 * Lambda_inv_0_7_p58 + Lambda_inv_6_7_p3 * Lambda_inv_0_7_p66;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_6_8_p23_lanes = Lambda_inv_6_8_p20_lanes + Lambda_inv_6_8_p6_lanes *
      Lambda_inv_0_6_p66 + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_6_p72 + Lambda_inv_6_8_p1_lanes *
      Lambda_inv_0_6_p77;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_8_p299_lanes = Lambda_inv_0_8_p288_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p300_lanes = Lambda_inv_0_8_p289_lanes *
      Lambda_inv_0_0_p285_lanes[0];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_7_8_p13_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_1_1_p9_lanes[1] +
      Lambda_inv_6_8_p3_lanes * Lambda_inv_0_7_p45 + Lambda_inv_6_8_p4_lanes * Lambda_inv_0_7_p51 +
      Lambda_inv_7_8_p4_lanes;
  const Lanes<8> Lambda_inv_9_9_p6_lanes = Lambda_inv_6_8_p5_lanes * Lambda_inv_0_8_p99_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_8_p301_lanes = 0.434 *
      (c2 * (Lambda_inv_0_8_p286_lanes - inverse_D1_p3 * Lambda_inv_0_8_p288_lanes) -
      Lambda_inv_0_8_p297_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_1_8_p5_lanes = Lambda_inv_0_8_p289_lanes * Lambda_inv_0_0_p285_lanes[1];
  const Lanes<8> Lambda_inv_2_8_p5_lanes = Lambda_inv_0_8_p289_lanes * Lambda_inv_0_0_p285_lanes[2];
  const Lanes<8> Lambda_inv_3_8_p5_lanes = Lambda_inv_0_8_p289_lanes * Lambda_inv_0_0_p285_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_8_8_p13_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_2_p50_lanes[1] +
      Lambda_inv_6_8_p3_lanes * Lambda_inv_0_8_p56_lanes[0] + Lambda_inv_6_8_p4_lanes *
      Lambda_inv_0_8_p72_lanes[0] + Lambda_inv_8_8_p6_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_4_8_p5_lanes = Lambda_inv_0_8_p289_lanes * Lambda_inv_0_0_p285_lanes[4];
  const Lanes<8> Lambda_inv_5_8_p5_lanes = Lambda_inv_0_8_p289_lanes * Lambda_inv_0_0_p285_lanes[5];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_7_8_p16_lanes = Lambda_inv_7_8_p13_lanes + Lambda_inv_6_8_p6_lanes *
      Lambda_inv_0_7_p66 + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_7_p71 + Lambda_inv_6_8_p1_lanes *
      Lambda_inv_0_7_p77;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_7_7_p3 = Lambda_inv_7_7_p2 + Lambda_inv_6_7_p2 * Lambda_inv_0_7_p71 +
      Lambda_inv_6_7_p1 * Lambda_inv_0_7_p77 + Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[7] +
      Lambda_inv_0_0_p236_lanes[7] * Lambda_inv_0_0_p225_lanes[7];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_9_9_p14_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_6_p42 +
      Lambda_inv_6_8_p3_lanes * Lambda_inv_0_8_p56_lanes[1] + Lambda_inv_6_8_p4_lanes *
      Lambda_inv_0_8_p72_lanes[1] + Lambda_inv_9_9_p6_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_8_8_p17_lanes = Lambda_inv_8_8_p13_lanes + Lambda_inv_6_8_p6_lanes *
      Lambda_inv_0_8_p119_lanes[0] + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_8_p146_lanes[0] +
      Lambda_inv_6_8_p1_lanes * Lambda_inv_0_8_p167_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_6_8_p27_lanes = Lambda_inv_6_8_p23_lanes + Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[6] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[6] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[6];
  const Lanes<8> Lambda_inv_7_8_p20_lanes = Lambda_inv_7_8_p16_lanes + Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[7] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[7] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_8_p303_lanes = Lambda_inv_0_8_p301_lanes * inverse_D1;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_9_9_p17_lanes = Lambda_inv_9_9_p14_lanes + Lambda_inv_6_8_p6_lanes *
      Lambda_inv_0_8_p119_lanes[1] + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_8_p146_lanes[1] +
      Lambda_inv_6_8_p1_lanes * Lambda_inv_0_8_p167_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_10_10_p18_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_7_p33 +
      detail::make_pack<Real>(Lambda_inv_4_4_p4_lanes[1], Lambda_inv_4_4_p4_lanes[1],
      Lambda_inv_4_4_p4_lanes[1], Lambda_inv_4_5_p4_lanes[1], Lambda_inv_4_4_p4_lanes[1],
      Lambda_inv_4_4_p4_lanes[1], Lambda_inv_4_4_p4_lanes[1], Lambda_inv_4_4_p4_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1],
      Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_5_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1],
      Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_4_p6_lanes[1],
      Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_5_p6_lanes[1], Lambda_inv_4_4_p6_lanes[1],
      Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_4_p6_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1],
      Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_5_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1],
      Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p2_lanes[1], Lambda_inv_4_4_p2_lanes[1],
      Lambda_inv_4_4_p2_lanes[1], Lambda_inv_4_5_p2_lanes[1], Lambda_inv_4_4_p2_lanes[1],
      Lambda_inv_4_4_p2_lanes[1], Lambda_inv_4_4_p2_lanes[1], Lambda_inv_4_4_p2_lanes[1]);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_8_8_p20_lanes = Lambda_inv_8_8_p17_lanes + Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_8_p199_lanes[0] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_8_p225_lanes[0] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_8_p253_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p305_lanes = Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[0] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[0] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[0] + Lambda_inv_0_8_p300_lanes;
  const Lanes<8> Lambda_inv_1_1_p24_lanes = detail::make_pack<Real>(Lambda_inv_1_1_p21_lanes[1],
      Lambda_inv_1_1_p21_lanes[1], Lambda_inv_1_1_p21_lanes[2], Lambda_inv_1_1_p21_lanes[3],
      Lambda_inv_1_1_p21_lanes[4], Lambda_inv_1_1_p21_lanes[5], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[1], Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[1]) +
      Lambda_inv_0_0_p236_lanes * Lambda_inv_0_0_p225_lanes[1] + Lambda_inv_0_0_p269_lanes *
      Lambda_inv_0_0_p259_lanes[1] + Lambda_inv_0_0_p289_lanes * Lambda_inv_0_0_p285_lanes[1];
  const Lanes<8> Lambda_inv_1_8_p8_lanes = Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[1] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[1] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[1] + Lambda_inv_1_8_p5_lanes;
  const Lanes<8> Lambda_inv_2_2_p23_lanes = detail::make_pack<Real>(Lambda_inv_2_2_p20_lanes[2],
      Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[3],
      Lambda_inv_2_2_p20_lanes[4], Lambda_inv_2_2_p20_lanes[5], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[2], Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[2]) +
      Lambda_inv_0_0_p236_lanes * Lambda_inv_0_0_p225_lanes[2] + Lambda_inv_0_0_p269_lanes *
      Lambda_inv_0_0_p259_lanes[2] + Lambda_inv_0_0_p289_lanes * Lambda_inv_0_0_p285_lanes[2];
  const Lanes<8> Lambda_inv_2_8_p8_lanes = Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[2] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[2] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[2] + Lambda_inv_2_8_p5_lanes;
  const Lanes<8> Lambda_inv_3_3_p23_lanes = detail::make_pack<Real>(Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[4], Lambda_inv_3_3_p20_lanes[5], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[3], Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[3]) +
      Lambda_inv_0_0_p236_lanes * Lambda_inv_0_0_p225_lanes[3] + Lambda_inv_0_0_p269_lanes *
      Lambda_inv_0_0_p259_lanes[3] + Lambda_inv_0_0_p289_lanes * Lambda_inv_0_0_p285_lanes[3];
  const Lanes<8> Lambda_inv_3_8_p8_lanes = Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[3] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[3] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[3] + Lambda_inv_3_8_p5_lanes;
  const Lanes<8> Lambda_inv_4_4_p21_lanes = detail::make_pack<Real>(Lambda_inv_4_4_p15_lanes[4],
      Lambda_inv_4_4_p15_lanes[4], Lambda_inv_4_4_p15_lanes[4], Lambda_inv_4_4_p15_lanes[4],
      Lambda_inv_4_4_p15_lanes[4], Lambda_inv_4_4_p15_lanes[5], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[4], Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[4]) +
      Lambda_inv_0_0_p236_lanes * Lambda_inv_0_0_p225_lanes[4] + Lambda_inv_0_0_p269_lanes *
      Lambda_inv_0_0_p259_lanes[4] + Lambda_inv_0_0_p289_lanes * Lambda_inv_0_0_p285_lanes[4];
  const Lanes<8> Lambda_inv_4_8_p8_lanes = Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[4] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[4] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[4] + Lambda_inv_4_8_p5_lanes;
  const Lanes<8> Lambda_inv_5_5_p20_lanes = detail::make_pack<Real>(Lambda_inv_5_5_p14_lanes[0] +
      Lambda_inv_0_0_p205_lanes[5] * Lambda_inv_0_0_p198_lanes[5], Lambda_inv_5_5_p14_lanes[0] +
      Lambda_inv_0_0_p205_lanes[5] * Lambda_inv_0_0_p198_lanes[5], Lambda_inv_5_5_p14_lanes[0] +
      Lambda_inv_0_0_p205_lanes[5] * Lambda_inv_0_0_p198_lanes[5], Lambda_inv_5_5_p14_lanes[0] +
      Lambda_inv_0_0_p205_lanes[5] * Lambda_inv_0_0_p198_lanes[5], Lambda_inv_5_5_p14_lanes[0] +
      Lambda_inv_0_0_p205_lanes[5] * Lambda_inv_0_0_p198_lanes[5], Lambda_inv_5_5_p14_lanes[0] +
      Lambda_inv_0_0_p205_lanes[5] * Lambda_inv_0_0_p198_lanes[5], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[5], Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[5]) +
      Lambda_inv_0_0_p236_lanes * Lambda_inv_0_0_p225_lanes[5] + Lambda_inv_0_0_p269_lanes *
      Lambda_inv_0_0_p259_lanes[5] + Lambda_inv_0_0_p289_lanes * Lambda_inv_0_0_p285_lanes[5];
  const Lanes<8> Lambda_inv_5_8_p8_lanes = Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_0_p198_lanes[5] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_0_p225_lanes[5] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_0_p259_lanes[5] + Lambda_inv_5_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_9_9_p21_lanes = Lambda_inv_9_9_p17_lanes + Lambda_inv_0_8_p205_lanes *
      Lambda_inv_0_8_p199_lanes[1] + Lambda_inv_0_8_p232_lanes * Lambda_inv_0_8_p225_lanes[1] +
      Lambda_inv_0_8_p263_lanes * Lambda_inv_0_8_p253_lanes[1];

  // link 3 (hip), force propagation
  const Real Lambda_inv_11_11_p15 = Lambda_inv_5_5_p14_lanes[1] + Lambda_inv_0_8_p205_lanes[3] *
      Lambda_inv_0_8_p199_lanes[3] + Lambda_inv_0_8_p232_lanes[3] * Lambda_inv_0_8_p225_lanes[3] +
      Lambda_inv_0_8_p263_lanes[3] * Lambda_inv_0_8_p253_lanes[3] + Lambda_inv_0_8_p289_lanes[3] *
      Lambda_inv_0_8_p276_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_6_6_p13_lanes = Lambda_inv_6_6_p7_lanes +
      detail::make_pack<Real>(Lambda_inv_0_6_p77 * inverse_D7_lanes[1] * Lambda_inv_0_6_p77,
      Lambda_inv_0_6_p77 * inverse_D7_lanes[1] * Lambda_inv_0_6_p77, Lambda_inv_0_6_p77 *
      inverse_D7_lanes[1] * Lambda_inv_0_6_p77, Lambda_inv_0_6_p77 * inverse_D7_lanes[1] *
      Lambda_inv_0_6_p77, Lambda_inv_0_6_p77 * inverse_D7_lanes[1] * Lambda_inv_0_6_p77,
      Lambda_inv_0_6_p77 * inverse_D7_lanes[1] * Lambda_inv_0_6_p77, Lambda_inv_0_6_p77 *
      inverse_D7_lanes[1] * Lambda_inv_0_6_p77, Lambda_inv_6_7_p1 * Lambda_inv_0_6_p77) +
      detail::make_pack<Real>(Lambda_inv_0_6_p112 * Lambda_inv_0_0_p198_lanes[6],
      Lambda_inv_0_6_p112 * Lambda_inv_0_0_p198_lanes[6], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[6], Lambda_inv_0_6_p112 * Lambda_inv_0_0_p198_lanes[6],
      Lambda_inv_0_6_p112 * Lambda_inv_0_0_p198_lanes[6], Lambda_inv_0_6_p112 *
      Lambda_inv_0_0_p198_lanes[6], Lambda_inv_0_6_p112 * Lambda_inv_0_0_p198_lanes[6],
      Lambda_inv_0_7_p112 * Lambda_inv_0_0_p198_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p236_lanes[6] * Lambda_inv_0_0_p225_lanes[6],
      Lambda_inv_0_0_p236_lanes[6] * Lambda_inv_0_0_p225_lanes[6], Lambda_inv_0_0_p236_lanes[6] *
      Lambda_inv_0_0_p225_lanes[6], Lambda_inv_0_0_p236_lanes[6] * Lambda_inv_0_0_p225_lanes[6],
      Lambda_inv_0_0_p236_lanes[6] * Lambda_inv_0_0_p225_lanes[6], Lambda_inv_0_0_p236_lanes[6] *
      Lambda_inv_0_0_p225_lanes[6], Lambda_inv_0_0_p236_lanes[6] * Lambda_inv_0_0_p225_lanes[6],
      Lambda_inv_0_0_p236_lanes[7] * Lambda_inv_0_0_p225_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p269_lanes[6] * Lambda_inv_0_0_p259_lanes[6],
      Lambda_inv_0_0_p269_lanes[6] * Lambda_inv_0_0_p259_lanes[6], Lambda_inv_0_0_p269_lanes[6] *
      Lambda_inv_0_0_p259_lanes[6], Lambda_inv_0_0_p269_lanes[6] * Lambda_inv_0_0_p259_lanes[6],
      Lambda_inv_0_0_p269_lanes[6] * Lambda_inv_0_0_p259_lanes[6], Lambda_inv_0_0_p269_lanes[6] *
      Lambda_inv_0_0_p259_lanes[6], Lambda_inv_0_0_p269_lanes[6] * Lambda_inv_0_0_p259_lanes[6],
      Lambda_inv_0_0_p269_lanes[7] * Lambda_inv_0_0_p259_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p289_lanes[6] * Lambda_inv_0_0_p285_lanes[6],
      Lambda_inv_0_0_p289_lanes[6] * Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p289_lanes[6] *
      Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p289_lanes[6] * Lambda_inv_0_0_p285_lanes[6],
      Lambda_inv_0_0_p289_lanes[6] * Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p289_lanes[6] *
      Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p289_lanes[6] * Lambda_inv_0_0_p285_lanes[6],
      Lambda_inv_0_0_p289_lanes[7] * Lambda_inv_0_0_p285_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p303_lanes[6] * Lambda_inv_0_0_p300_lanes[6],
      Lambda_inv_0_0_p303_lanes[6] * Lambda_inv_0_0_p300_lanes[6], Lambda_inv_0_0_p303_lanes[6] *
      Lambda_inv_0_0_p300_lanes[6], Lambda_inv_0_0_p303_lanes[6] * Lambda_inv_0_0_p300_lanes[6],
      Lambda_inv_0_0_p303_lanes[6] * Lambda_inv_0_0_p300_lanes[6], Lambda_inv_0_0_p303_lanes[6] *
      Lambda_inv_0_0_p300_lanes[6], Lambda_inv_0_0_p303_lanes[6] * Lambda_inv_0_0_p300_lanes[6],
      Lambda_inv_0_0_p303_lanes[7] * Lambda_inv_0_0_p300_lanes[6]);
  const Lanes<8> Lambda_inv_10_10_p24_lanes = Lambda_inv_10_10_p18_lanes +
      detail::make_pack<Real>(Lambda_inv_4_4_p3_lanes[1], Lambda_inv_4_4_p3_lanes[1],
      Lambda_inv_4_4_p3_lanes[1], Lambda_inv_4_5_p3_lanes[1], Lambda_inv_4_4_p3_lanes[1],
      Lambda_inv_4_4_p3_lanes[1], Lambda_inv_4_4_p3_lanes[1], Lambda_inv_4_4_p3_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p205_lanes[2] * Lambda_inv_0_8_p199_lanes[2],
      Lambda_inv_0_8_p205_lanes[2] * Lambda_inv_0_8_p199_lanes[2], Lambda_inv_0_8_p205_lanes[2] *
      Lambda_inv_0_8_p199_lanes[2], Lambda_inv_0_8_p205_lanes[3] * Lambda_inv_0_8_p199_lanes[2],
      Lambda_inv_0_8_p205_lanes[2] * Lambda_inv_0_8_p199_lanes[2], Lambda_inv_0_8_p205_lanes[2] *
      Lambda_inv_0_8_p199_lanes[2], Lambda_inv_0_8_p205_lanes[2] * Lambda_inv_0_8_p199_lanes[2],
      Lambda_inv_0_8_p205_lanes[2] * Lambda_inv_0_8_p199_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p232_lanes[2] * Lambda_inv_0_8_p225_lanes[2],
      Lambda_inv_0_8_p232_lanes[2] * Lambda_inv_0_8_p225_lanes[2], Lambda_inv_0_8_p232_lanes[2] *
      Lambda_inv_0_8_p225_lanes[2], Lambda_inv_0_8_p232_lanes[3] * Lambda_inv_0_8_p225_lanes[2],
      Lambda_inv_0_8_p232_lanes[2] * Lambda_inv_0_8_p225_lanes[2], Lambda_inv_0_8_p232_lanes[2] *
      Lambda_inv_0_8_p225_lanes[2], Lambda_inv_0_8_p232_lanes[2] * Lambda_inv_0_8_p225_lanes[2],
      Lambda_inv_0_8_p232_lanes[2] * Lambda_inv_0_8_p225_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p263_lanes[2] * Lambda_inv_0_8_p253_lanes[2],
      Lambda_inv_0_8_p263_lanes[2] * Lambda_inv_0_8_p253_lanes[2], Lambda_inv_0_8_p263_lanes[2] *
      Lambda_inv_0_8_p253_lanes[2], Lambda_inv_0_8_p263_lanes[3] * Lambda_inv_0_8_p253_lanes[2],
      Lambda_inv_0_8_p263_lanes[2] * Lambda_inv_0_8_p253_lanes[2], Lambda_inv_0_8_p263_lanes[2] *
      Lambda_inv_0_8_p253_lanes[2], Lambda_inv_0_8_p263_lanes[2] * Lambda_inv_0_8_p253_lanes[2],
      Lambda_inv_0_8_p263_lanes[2] * Lambda_inv_0_8_p253_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p289_lanes[2] * Lambda_inv_0_8_p276_lanes[2],
      Lambda_inv_0_8_p289_lanes[2] * Lambda_inv_0_8_p276_lanes[2], Lambda_inv_0_8_p289_lanes[2] *
      Lambda_inv_0_8_p276_lanes[2], Lambda_inv_0_8_p289_lanes[3] * Lambda_inv_0_8_p276_lanes[2],
      Lambda_inv_0_8_p289_lanes[2] * Lambda_inv_0_8_p276_lanes[2], Lambda_inv_0_8_p289_lanes[2] *
      Lambda_inv_0_8_p276_lanes[2], Lambda_inv_0_8_p289_lanes[2] * Lambda_inv_0_8_p276_lanes[2],
      Lambda_inv_0_8_p289_lanes[2] * Lambda_inv_0_8_p276_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p299_lanes[2] * Lambda_inv_0_8_p288_lanes[2],
      Lambda_inv_0_8_p299_lanes[2] * Lambda_inv_0_8_p288_lanes[2], Lambda_inv_0_8_p299_lanes[2] *
      Lambda_inv_0_8_p288_lanes[2], Lambda_inv_0_8_p299_lanes[3] * Lambda_inv_0_8_p288_lanes[2],
      Lambda_inv_0_8_p299_lanes[2] * Lambda_inv_0_8_p288_lanes[2], Lambda_inv_0_8_p299_lanes[2] *
      Lambda_inv_0_8_p288_lanes[2], Lambda_inv_0_8_p299_lanes[2] * Lambda_inv_0_8_p288_lanes[2],
      Lambda_inv_0_8_p299_lanes[2] * Lambda_inv_0_8_p288_lanes[2]);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_8_lanes = Lambda_inv_0_8_p305_lanes + Lambda_inv_0_8_p299_lanes *
      Lambda_inv_0_0_p300_lanes[0] + Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[0];
  Lambda_inv[8] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[96] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[9] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[108] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[10] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[120] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[11] = Lambda_inv_0_8_lanes[3];
  Lambda_inv[132] = Lambda_inv_0_8_lanes[3];
  const Lanes<8> Lambda_inv_1_1_lanes = Lambda_inv_1_1_p24_lanes + Lambda_inv_0_0_p303_lanes *
      Lambda_inv_0_0_p300_lanes[1] + Lambda_inv_0_0_p312_lanes * Lambda_inv_0_0_p311_lanes[1];
  Lambda_inv[13] = Lambda_inv_1_1_lanes[1];
  Lambda_inv[14] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[25] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[15] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[37] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[16] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[49] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[17] = Lambda_inv_1_1_lanes[5];
  Lambda_inv[61] = Lambda_inv_1_1_lanes[5];
  Lambda_inv[18] = Lambda_inv_1_1_lanes[6];
  Lambda_inv[73] = Lambda_inv_1_1_lanes[6];
  Lambda_inv[19] = Lambda_inv_1_1_lanes[7];
  Lambda_inv[85] = Lambda_inv_1_1_lanes[7];
  const Lanes<8> Lambda_inv_1_8_lanes = Lambda_inv_1_8_p8_lanes + Lambda_inv_0_8_p299_lanes *
      Lambda_inv_0_0_p300_lanes[1] + Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[1];
  Lambda_inv[20] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[97] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[21] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[109] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[22] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[121] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[23] = Lambda_inv_1_8_lanes[3];
  Lambda_inv[133] = Lambda_inv_1_8_lanes[3];
  const Lanes<8> Lambda_inv_2_2_lanes = Lambda_inv_2_2_p23_lanes + Lambda_inv_0_0_p303_lanes *
      Lambda_inv_0_0_p300_lanes[2] + Lambda_inv_0_0_p312_lanes * Lambda_inv_0_0_p311_lanes[2];
  Lambda_inv[26] = Lambda_inv_2_2_lanes[2];
  Lambda_inv[27] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[38] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[28] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[50] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[29] = Lambda_inv_2_2_lanes[5];
  Lambda_inv[62] = Lambda_inv_2_2_lanes[5];
  Lambda_inv[30] = Lambda_inv_2_2_lanes[6];
  Lambda_inv[74] = Lambda_inv_2_2_lanes[6];
  Lambda_inv[31] = Lambda_inv_2_2_lanes[7];
  Lambda_inv[86] = Lambda_inv_2_2_lanes[7];
  const Lanes<8> Lambda_inv_2_8_lanes = Lambda_inv_2_8_p8_lanes + Lambda_inv_0_8_p299_lanes *
      Lambda_inv_0_0_p300_lanes[2] + Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[2];
  Lambda_inv[32] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[98] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[33] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[110] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[34] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[122] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[35] = Lambda_inv_2_8_lanes[3];
  Lambda_inv[134] = Lambda_inv_2_8_lanes[3];
  const Lanes<8> Lambda_inv_3_3_lanes = Lambda_inv_3_3_p23_lanes + Lambda_inv_0_0_p303_lanes *
      Lambda_inv_0_0_p300_lanes[3] + Lambda_inv_0_0_p312_lanes * Lambda_inv_0_0_p311_lanes[3];
  Lambda_inv[39] = Lambda_inv_3_3_lanes[3];
  Lambda_inv[40] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[51] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[41] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[63] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[42] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[75] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[43] = Lambda_inv_3_3_lanes[7];
  Lambda_inv[87] = Lambda_inv_3_3_lanes[7];
  const Lanes<8> Lambda_inv_3_8_lanes = Lambda_inv_3_8_p8_lanes + Lambda_inv_0_8_p299_lanes *
      Lambda_inv_0_0_p300_lanes[3] + Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[3];
  Lambda_inv[44] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[99] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[45] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[111] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[46] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[123] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[47] = Lambda_inv_3_8_lanes[3];
  Lambda_inv[135] = Lambda_inv_3_8_lanes[3];
  const Lanes<8> Lambda_inv_4_4_lanes = Lambda_inv_4_4_p21_lanes + Lambda_inv_0_0_p303_lanes *
      Lambda_inv_0_0_p300_lanes[4] + Lambda_inv_0_0_p312_lanes * Lambda_inv_0_0_p311_lanes[4];
  Lambda_inv[52] = Lambda_inv_4_4_lanes[4];
  Lambda_inv[53] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[64] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[54] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[76] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[55] = Lambda_inv_4_4_lanes[7];
  Lambda_inv[88] = Lambda_inv_4_4_lanes[7];
  const Lanes<8> Lambda_inv_4_8_lanes = Lambda_inv_4_8_p8_lanes + Lambda_inv_0_8_p299_lanes *
      Lambda_inv_0_0_p300_lanes[4] + Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[4];
  Lambda_inv[56] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[100] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[57] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[112] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[58] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[124] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[59] = Lambda_inv_4_8_lanes[3];
  Lambda_inv[136] = Lambda_inv_4_8_lanes[3];
  const Lanes<8> Lambda_inv_5_5_lanes = Lambda_inv_5_5_p20_lanes + Lambda_inv_0_0_p303_lanes *
      Lambda_inv_0_0_p300_lanes[5] + Lambda_inv_0_0_p312_lanes * Lambda_inv_0_0_p311_lanes[5];
  Lambda_inv[65] = Lambda_inv_5_5_lanes[5];
  Lambda_inv[66] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[77] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[67] = Lambda_inv_5_5_lanes[7];
  Lambda_inv[89] = Lambda_inv_5_5_lanes[7];
  const Lanes<8> Lambda_inv_5_8_lanes = Lambda_inv_5_8_p8_lanes + Lambda_inv_0_8_p299_lanes *
      Lambda_inv_0_0_p300_lanes[5] + Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[5];
  Lambda_inv[68] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[101] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[69] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[113] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[70] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[125] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[71] = Lambda_inv_5_8_lanes[3];
  Lambda_inv[137] = Lambda_inv_5_8_lanes[3];
  const Lanes<8> Lambda_inv_6_6_lanes = Lambda_inv_6_6_p13_lanes +
      detail::make_pack<Real>(Lambda_inv_0_0_p312_lanes[6] * Lambda_inv_0_0_p311_lanes[6],
      Lambda_inv_0_0_p312_lanes[6] * Lambda_inv_0_0_p311_lanes[6], Lambda_inv_0_0_p312_lanes[6] *
      Lambda_inv_0_0_p311_lanes[6], Lambda_inv_0_0_p312_lanes[6] * Lambda_inv_0_0_p311_lanes[6],
      Lambda_inv_0_0_p312_lanes[6] * Lambda_inv_0_0_p311_lanes[6], Lambda_inv_0_0_p312_lanes[6] *
      Lambda_inv_0_0_p311_lanes[6], Lambda_inv_0_0_p312_lanes[6] * Lambda_inv_0_0_p311_lanes[6],
      Lambda_inv_0_0_p312_lanes[7] * Lambda_inv_0_0_p311_lanes[6]);
  Lambda_inv[78] = Lambda_inv_6_6_lanes[6];
  Lambda_inv[79] = Lambda_inv_6_6_lanes[7];
  Lambda_inv[90] = Lambda_inv_6_6_lanes[7];
  const Lanes<8> Lambda_inv_6_8_lanes = Lambda_inv_6_8_p27_lanes + Lambda_inv_0_8_p289_lanes *
      Lambda_inv_0_0_p285_lanes[6] + Lambda_inv_0_8_p299_lanes * Lambda_inv_0_0_p300_lanes[6] +
      Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[6];
  Lambda_inv[80] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[102] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[81] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[114] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[82] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[126] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[83] = Lambda_inv_6_8_lanes[3];
  Lambda_inv[138] = Lambda_inv_6_8_lanes[3];
  Lambda_inv[91] = Lambda_inv_7_7_p3 + Lambda_inv_0_0_p269_lanes[7] * Lambda_inv_0_0_p259_lanes[7] +
      Lambda_inv_0_0_p289_lanes[7] * Lambda_inv_0_0_p285_lanes[7] + Lambda_inv_0_0_p303_lanes[7] *
      Lambda_inv_0_0_p300_lanes[7] + Lambda_inv_0_0_p312_lanes[7] * Lambda_inv_0_0_p311_lanes[7];
  const Lanes<8> Lambda_inv_7_8_lanes = Lambda_inv_7_8_p20_lanes + Lambda_inv_0_8_p289_lanes *
      Lambda_inv_0_0_p285_lanes[7] + Lambda_inv_0_8_p299_lanes * Lambda_inv_0_0_p300_lanes[7] +
      Lambda_inv_0_8_p303_lanes * Lambda_inv_0_0_p311_lanes[7];
  Lambda_inv[92] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[103] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[93] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[115] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[94] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[127] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[95] = Lambda_inv_7_8_lanes[3];
  Lambda_inv[139] = Lambda_inv_7_8_lanes[3];
  const Lanes<8> Lambda_inv_8_8_lanes = Lambda_inv_8_8_p20_lanes + Lambda_inv_0_8_p289_lanes *
      Lambda_inv_0_8_p276_lanes[0] + Lambda_inv_0_8_p299_lanes * Lambda_inv_0_8_p288_lanes[0] +
      Lambda_inv_0_8_p303_lanes * Lambda_inv_0_8_p301_lanes[0];
  Lambda_inv[104] = Lambda_inv_8_8_lanes[0];
  Lambda_inv[105] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[116] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[106] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[128] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[107] = Lambda_inv_8_8_lanes[3];
  Lambda_inv[140] = Lambda_inv_8_8_lanes[3];
  const Lanes<8> Lambda_inv_9_9_lanes = Lambda_inv_9_9_p21_lanes + Lambda_inv_0_8_p289_lanes *
      Lambda_inv_0_8_p276_lanes[1] + Lambda_inv_0_8_p299_lanes * Lambda_inv_0_8_p288_lanes[1] +
      Lambda_inv_0_8_p303_lanes * Lambda_inv_0_8_p301_lanes[1];
  Lambda_inv[117] = Lambda_inv_9_9_lanes[1];
  Lambda_inv[118] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[129] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[119] = Lambda_inv_9_9_lanes[3];
  Lambda_inv[141] = Lambda_inv_9_9_lanes[3];
  const Lanes<8> Lambda_inv_10_10_lanes = Lambda_inv_10_10_p24_lanes +
      detail::make_pack<Real>(Lambda_inv_0_8_p303_lanes[2] * Lambda_inv_0_8_p301_lanes[2],
      Lambda_inv_0_8_p303_lanes[2] * Lambda_inv_0_8_p301_lanes[2], Lambda_inv_0_8_p303_lanes[2] *
      Lambda_inv_0_8_p301_lanes[2], Lambda_inv_0_8_p303_lanes[3] * Lambda_inv_0_8_p301_lanes[2],
      Lambda_inv_0_8_p303_lanes[2] * Lambda_inv_0_8_p301_lanes[2], Lambda_inv_0_8_p303_lanes[2] *
      Lambda_inv_0_8_p301_lanes[2], Lambda_inv_0_8_p303_lanes[2] * Lambda_inv_0_8_p301_lanes[2],
      Lambda_inv_0_8_p303_lanes[2] * Lambda_inv_0_8_p301_lanes[2]);
  Lambda_inv[130] = Lambda_inv_10_10_lanes[2];
  Lambda_inv[131] = Lambda_inv_10_10_lanes[3];
  Lambda_inv[142] = Lambda_inv_10_10_lanes[3];
  Lambda_inv[143] = Lambda_inv_11_11_p15 + Lambda_inv_0_8_p299_lanes[3] *
      Lambda_inv_0_8_p288_lanes[3] + Lambda_inv_0_8_p303_lanes[3] * Lambda_inv_0_8_p301_lanes[3];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
