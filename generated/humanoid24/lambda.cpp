// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in lanes.
// 8261 flops (add 3548, mul 4669, div 44), sine and cosine of 24 angles
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
  const Real inverse_D3_p23 = s5 * (inverse_D3_p9 - inverse_D3_p10) + c5 *
      (inverse_D3_p11 + inverse_D3_p12);
  const Real inverse_D3_p24 = s5 * (inverse_D3_p16 - inverse_D3_p15) + inverse_D4_p14 *
      inverse_D3_p17;
  const Real inverse_D3_p25 = inverse_D3_p22 + 0.21799999999999997 * inverse_D3_p18;
  const Real inverse_D2_p1 = 0.0300000063 + inverse_D3_p21;
  const Real inverse_D4_p45 = s5 * inverse_D4_p44;
  const Real inverse_D3_p26 = s5 * inverse_D3_p19 - c5 * inverse_D3_p20;
  const Real inverse_D2_p2 = s5 * inverse_D3_p20 + c5 * inverse_D3_p19;

  // link 2 (thigh), pose
  const Real Lambda_11_11_p1 = c2 * c1 - s2 * s1;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p27 = c5 * inverse_D3_p23;
  const Real inverse_D3_p28 = s5 * inverse_D3_p23;

  // link 2 (thigh), pose
  const Real Lambda_11_11_p2 = s2 * c1 + c2 * s1;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p29 = s5 * inverse_D3_p24;
  const Real inverse_D3_p30 = 0.21799999999999997 * inverse_D3_p26;
  const Real inverse_D3_p31 = inverse_D3_p27 - inverse_D3_p12;
  const Real inverse_D3_p32 = inverse_D3_p16 - inverse_D3_p29;
  const Real inverse_D2_p3 = inverse_D3_p10 + inverse_D3_p28;
  const Real inverse_D2_p4 = c5 * inverse_D3_p24 - inverse_D3_p17;
  const Real inverse_D3_p33 = 0.21799999999999997 * inverse_D3_p31;

  // link 3 (hip), pose
  const Real Lambda_11_11_p3 = s3 * Lambda_11_11_p1 + c3 * Lambda_11_11_p2;
  const Real Lambda_11_11_p4 = c3 * Lambda_11_11_p1 - s3 * Lambda_11_11_p2;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p42 + inverse_D4_p45));

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p34 = 0.005880002159562879 +
      (0.21799999999999997 * inverse_D3_p21 - (c5 * inverse_D4_p44 - inverse_D4_p43));
  const Real inverse_D3_p35 = inverse_D3_p9 - inverse_D3_p28 + inverse_D3_p30;

  // link 4 (chest1), pose
  const Real Lambda_11_11_p5 = c4 * Lambda_11_11_p3;
  const Real Lambda_11_11_p6 = s4 * Lambda_11_11_p3;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p7 = s5 * s4;
  const Real Lambda_11_11_p8 = c5 * s4;
  const Real Lambda_11_11_p9 = s5 * Lambda_11_11_p5 - c5 * Lambda_11_11_p4;
  const Real Lambda_11_11_p10 = c5 * Lambda_11_11_p5 + s5 * Lambda_11_11_p4;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p11 = s6 * c4 - c6 * Lambda_11_11_p7;
  const Real Lambda_11_11_p14 = s6 * Lambda_11_11_p7 + c6 * c4;

  // link 4 (chest1), pose
  const Real Lambda_11_11_p15 = c4 * Lambda_11_11_p4;
  const Real Lambda_11_11_p20 = s4 * Lambda_11_11_p4;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p36 = inverse_D3_p34 * inverse_D4;
  const Real inverse_D3_p37 = inverse_D3_p33 * inverse_D4;
  const Real inverse_D2_p5 = inverse_D3_p31 * inverse_D4;
  const Real inverse_D2_p6 = inverse_D2_p1 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p3 * inverse_D4;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p29 = c6 * Lambda_11_11_p9 + s6 * Lambda_11_11_p6;
  const Real Lambda_11_11_p30 = s6 * Lambda_11_11_p9 - c6 * Lambda_11_11_p6;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p31_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p11 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p8;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p33 = s5 * Lambda_11_11_p15 + c5 * Lambda_11_11_p3;
  const Real Lambda_11_11_p34 = c5 * Lambda_11_11_p15 - s5 * Lambda_11_11_p3;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p35_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p11 +
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p8;
  const Lanes<2> Lambda_11_11_p57_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p29 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p10;
  const Lanes<2> Lambda_11_11_p59_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p29 -
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p10;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p61_lanes = detail::make_pack<Real>(c8, c15) * Lambda_11_11_p14 -
      detail::make_pack<Real>(s8, s15) * Lambda_11_11_p31_lanes;
  const Lanes<2> Lambda_11_11_p63_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p31_lanes + detail::make_pack<Real>(s8, s15) * Lambda_11_11_p14;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p38 = 0.01227760324629517 + 0.04752399999999999 * inverse_D3_p32 -
      inverse_D3_p33 * inverse_D3_p37;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p67 = c6 * Lambda_11_11_p33 + s6 * Lambda_11_11_p20;
  const Real Lambda_11_11_p68 = s6 * Lambda_11_11_p33 - c6 * Lambda_11_11_p20;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p39 = 0.0478915 + (inverse_D4_p41 - inverse_D4_p45 + 0.21799999999999997 *
      (inverse_D3_p22 + inverse_D3_p25)) - inverse_D3_p34 * inverse_D3_p36 - inverse_D3_p38;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p91_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_11_11_p57_lanes + detail::make_pack<Real>(c8, c15) * Lambda_11_11_p30;
  const Lanes<2> Lambda_11_11_p93_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p57_lanes - detail::make_pack<Real>(s8, s15) * Lambda_11_11_p30;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p8 = inverse_D3_p34 * inverse_D2_p6 - inverse_D3_p25;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_11_11_p95_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_11_11_p61_lanes + detail::make_pack<Real>(c9, c16) * Lambda_11_11_p35_lanes;
  const Lanes<2> Lambda_11_11_p97_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p61_lanes - detail::make_pack<Real>(s9, s16) * Lambda_11_11_p35_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p99_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p67 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p34;
  const Lanes<2> Lambda_11_11_p101_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p34 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p67;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_11_11_p123_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p59_lanes - detail::make_pack<Real>(s9, s16) * Lambda_11_11_p91_lanes;
  const Lanes<2> Lambda_11_11_p125_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p91_lanes + detail::make_pack<Real>(s9, s16) * Lambda_11_11_p59_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_11_11_p127_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_11_11_p95_lanes + detail::make_pack<Real>(s10, s17) * Lambda_11_11_p63_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p129 = c17 * Lambda_11_11_p63_lanes[1] - s17 * Lambda_11_11_p95_lanes[1];

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p9 = inverse_D3_p32 - inverse_D3_p31 * inverse_D2_p5;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p130_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_11_11_p99_lanes + detail::make_pack<Real>(c8, c15) * Lambda_11_11_p68;
  const Lanes<2> Lambda_11_11_p132_lanes = detail::make_pack<Real>(s8, s15) * Lambda_11_11_p68 -
      detail::make_pack<Real>(c8, c15) * Lambda_11_11_p99_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p40 = inverse_D3_p38 + s4 *
      (s4 * inverse_D3_p39 + inverse_D3_p4 * (0.21799999999999997 * inverse_D3_p35 +
      inverse_D3_p34 * inverse_D3_p37));

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_11_11_p153_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_11_11_p123_lanes + detail::make_pack<Real>(s10, s17) * Lambda_11_11_p93_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p155 = c17 * Lambda_11_11_p93_lanes[1] - s17 * Lambda_11_11_p123_lanes[1];

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p156_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p127_lanes + detail::make_pack<Real>(s11, s18) * Lambda_11_11_p97_lanes;
  const Lanes<2> Lambda_11_11_p158_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p97_lanes - detail::make_pack<Real>(s11, s18) * Lambda_11_11_p127_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p10 = s4 * (inverse_D3_p35 + inverse_D3_p34 * inverse_D2_p5 +
      (inverse_D3_p30 + inverse_D3_p33 * inverse_D2_p6)) + c4 *
      (0.21799999999999997 * inverse_D3_p32 - inverse_D3_p33 * inverse_D2_p5 + inverse_D2_p8);

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_11_11_p160_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_11_11_p130_lanes + detail::make_pack<Real>(c9, c16) * Lambda_11_11_p101_lanes;
  const Lanes<2> Lambda_11_11_p162_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p130_lanes - detail::make_pack<Real>(s9, s16) * Lambda_11_11_p101_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p40);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p11 = s4 * (0.21799999999999997 * inverse_D2_p2 -
      (inverse_D3_p27 - inverse_D3_p11) - inverse_D3_p34 * inverse_D2_p7) + c4 *
      (0.0300000063 - 0.21799999999999997 * inverse_D2_p4 + inverse_D3_p33 * inverse_D2_p7);

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p183_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p153_lanes - detail::make_pack<Real>(s11, s18) * Lambda_11_11_p125_lanes;
  const Lanes<2> Lambda_11_11_p185_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_11_11_p153_lanes + detail::make_pack<Real>(c11, c18) * Lambda_11_11_p125_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p187 = c19 * Lambda_11_11_p156_lanes[1] + s19 * Lambda_11_11_p129;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_11_11_p188_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_11_11_p160_lanes + detail::make_pack<Real>(s10, s17) * Lambda_11_11_p132_lanes;
  const Lanes<8> Lambda_11_11_p190_lanes = c10 * detail::make_pack<Real>(Lambda_11_11_p132_lanes[0],
      Lambda_11_11_p63_lanes[0], Lambda_11_11_p93_lanes[0], Lambda_11_11_p132_lanes[0],
      Lambda_11_11_p132_lanes[0], Lambda_11_11_p132_lanes[0], Lambda_11_11_p132_lanes[0],
      Lambda_11_11_p132_lanes[0]) - s10 * detail::make_pack<Real>(Lambda_11_11_p160_lanes[0],
      Lambda_11_11_p95_lanes[0], Lambda_11_11_p123_lanes[0], Lambda_11_11_p160_lanes[0],
      Lambda_11_11_p160_lanes[0], Lambda_11_11_p160_lanes[0], Lambda_11_11_p160_lanes[0],
      Lambda_11_11_p160_lanes[0]);

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p193 = c17 * Lambda_11_11_p132_lanes[1] - s17 *
      Lambda_11_11_p160_lanes[1];

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p12 = 0.02999999505 + inverse_D2_p11;
  const Real inverse_D2_p13 = s4 * (inverse_D2_p9 -
      (inverse_D3_p18 - inverse_D2_p1 * inverse_D2_p6)) - inverse_D3_p4 *
      (inverse_D3_p26 + inverse_D3_p31 * inverse_D2_p6);

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p210 = c19 * Lambda_11_11_p183_lanes[1] + s19 * Lambda_11_11_p155;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p14 = 8.419374554 + (c4 * inverse_D2_p10 - inverse_D2_p8);

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p211_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p188_lanes + detail::make_pack<Real>(s11, s18) * Lambda_11_11_p162_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_11_11_p213_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_11_11_p190_lanes[2], Lambda_11_11_p155) -
      detail::make_pack<Real>(s12, s19) * Lambda_11_11_p183_lanes;
  const Lanes<2> Lambda_11_11_p215_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_11_11_p190_lanes[1], Lambda_11_11_p129) -
      detail::make_pack<Real>(s12, s19) * Lambda_11_11_p156_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p217_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p162_lanes - detail::make_pack<Real>(s11, s18) * Lambda_11_11_p188_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p12 * inverse_D3;
  const Real inverse_D2_p16 = inverse_D2_p14 * inverse_D3;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_11_11_p239_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_11_11_p190_lanes[0], Lambda_11_11_p193) -
      detail::make_pack<Real>(s12, s19) * Lambda_11_11_p211_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p241_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_11_11_p213_lanes + detail::make_pack<Real>(c13, c20) * Lambda_11_11_p185_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p243 = c19 * Lambda_11_11_p211_lanes[1] + s19 * Lambda_11_11_p193;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p244_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p158_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p215_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_11_11_p246_lanes = c12 * detail::make_pack<Real>(Lambda_11_11_p211_lanes[0],
      Lambda_11_11_p156_lanes[0], Lambda_11_11_p183_lanes[0], Lambda_11_11_p211_lanes[0],
      Lambda_11_11_p211_lanes[0], Lambda_11_11_p211_lanes[0], Lambda_11_11_p211_lanes[0],
      Lambda_11_11_p211_lanes[0]) + s12 * Lambda_11_11_p190_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p249_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p213_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p185_lanes;
  const Lanes<2> Lambda_11_11_p251_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p215_lanes + detail::make_pack<Real>(s13, s20) * Lambda_11_11_p158_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p259_lanes = 0.009919078854932248 * Lambda_11_11_p244_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_11_11_p264_lanes = 0.086 * Lambda_11_11_p246_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p267_lanes = -Lambda_11_11_p241_lanes;
  const Lanes<8> Lambda_11_11_p271_lanes = (-3.0523172236718206) *
      detail::make_pack<Real>(Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[0],
      Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[1],
      Lambda_11_11_p246_lanes[2], Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[0]);

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p277_lanes = 3.0523172236718206 *
      detail::make_pack<Real>(Lambda_11_11_p243, Lambda_11_11_p243, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p243, Lambda_11_11_p243, Lambda_11_11_p243,
      Lambda_11_11_p243);
  const Lanes<8> Lambda_11_11_p280_lanes = 17.32841575379867 *
      detail::make_pack<Real>(Lambda_11_11_p243, Lambda_11_11_p243, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p243, Lambda_11_11_p243, Lambda_11_11_p243,
      Lambda_11_11_p243);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = inverse_D2_p14 * inverse_D2_p15 -
      (c4 * (inverse_D3_p31 * inverse_D2_p7 - inverse_D2_p4) - s4 *
      (inverse_D2_p1 * inverse_D2_p7 - inverse_D2_p2));
  const Real inverse_D2_p18 = inverse_D2_p9 - s4 * inverse_D2_p13 - inverse_D2_p14 * inverse_D2_p16;
  const Real inverse_D2_p19 = inverse_D3_p15 + inverse_D3_p29 - inverse_D2_p3 * inverse_D2_p7 -
      inverse_D2_p12 * inverse_D2_p15;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p283_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p217_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p239_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p285_lanes = -(0.086 * Lambda_11_11_p241_lanes);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p287_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p239_lanes + detail::make_pack<Real>(s13, s20) * Lambda_11_11_p217_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p289_lanes = 0.11533812622014242 * Lambda_11_11_p285_lanes;
  const Lanes<2> Lambda_11_11_p295_lanes = Lambda_11_11_p251_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_11_11_p244_lanes;
  const Lanes<2> Lambda_11_11_p313_lanes = 0.009919078854932248 * Lambda_11_11_p283_lanes;
  const Lanes<8> Lambda_11_11_p315_lanes = detail::make_pack<Real>(Lambda_11_11_p287_lanes[0],
      Lambda_11_11_p287_lanes[0], Lambda_11_11_p287_lanes[0], Lambda_11_11_p287_lanes[0],
      Lambda_11_11_p251_lanes[0], Lambda_11_11_p249_lanes[0], Lambda_11_11_p287_lanes[0],
      Lambda_11_11_p287_lanes[0]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[0],
      Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[1],
      Lambda_11_11_p246_lanes[2], Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[0]);
  const Lanes<8> Lambda_11_11_p320_lanes = detail::make_pack<Real>(0.49024375482668536,
      0.49024375482668536, 0.49024375482668536, 17.32841575379867, 17.32841575379867,
      17.32841575379867, 0.49024375482668536, 0.49024375482668536) *
      detail::make_pack<Real>(Lambda_11_11_p283_lanes[0], Lambda_11_11_p244_lanes[0],
      Lambda_11_11_p283_lanes[0], Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[1],
      Lambda_11_11_p246_lanes[2], Lambda_11_11_p283_lanes[0], Lambda_11_11_p283_lanes[0]);
  const Lanes<2> Lambda_11_11_p325_lanes = Lambda_11_11_p249_lanes +
      detail::make_pack<Real>((-3.0523172236718206), 3.0523172236718206) * Lambda_11_11_p285_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p327_lanes = detail::make_pack<Real>(Lambda_11_11_p287_lanes[1],
      Lambda_11_11_p287_lanes[1], Lambda_11_11_p251_lanes[1], Lambda_11_11_p249_lanes[1],
      Lambda_11_11_p287_lanes[1], Lambda_11_11_p287_lanes[1], Lambda_11_11_p287_lanes[1],
      Lambda_11_11_p287_lanes[1]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_11_11_p243, Lambda_11_11_p243, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p243, Lambda_11_11_p243, Lambda_11_11_p243,
      Lambda_11_11_p243);

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p333_lanes = Lambda_11_11_p267_lanes - 17.32841575379867 *
      Lambda_11_11_p285_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p335_lanes = detail::make_pack<Real>(-(0.086 * Lambda_11_11_p210),
      Lambda_11_11_p283_lanes[1], Lambda_11_11_p244_lanes[1], Lambda_11_11_p267_lanes[1],
      -(0.086 * Lambda_11_11_p210), -(0.086 * Lambda_11_11_p210), -(0.086 * Lambda_11_11_p210),
      -(0.086 * Lambda_11_11_p210)) - (-0.04672761636452121) *
      detail::make_pack<Real>(Lambda_11_11_p285_lanes[1], Lambda_11_11_p243, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p285_lanes[1], Lambda_11_11_p285_lanes[1],
      Lambda_11_11_p285_lanes[1], Lambda_11_11_p285_lanes[1]);

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p345_lanes = detail::make_pack<Real>(-Lambda_11_11_p264_lanes[0],
      -Lambda_11_11_p264_lanes[1], -Lambda_11_11_p264_lanes[2], Lambda_11_11_p283_lanes[0],
      Lambda_11_11_p244_lanes[0], Lambda_11_11_p267_lanes[0], -Lambda_11_11_p264_lanes[0],
      -Lambda_11_11_p264_lanes[0]) - detail::make_pack<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_pack<Real>(Lambda_11_11_p283_lanes[0], Lambda_11_11_p244_lanes[0],
      Lambda_11_11_p285_lanes[0], Lambda_11_11_p246_lanes[0], Lambda_11_11_p246_lanes[1],
      Lambda_11_11_p246_lanes[2], Lambda_11_11_p283_lanes[0], Lambda_11_11_p283_lanes[0]);
  const Lanes<2> Lambda_11_11_p357_lanes = Lambda_11_11_p287_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_11_11_p283_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = s3 * (inverse_D2_p18 - inverse_D2_p19) + c3 * (2.0 * inverse_D2_p17);

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p399_lanes = s20 * Lambda_11_11_p277_lanes - c20 *
      Lambda_11_11_p280_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_11_11_p402_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p404_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p325_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p333_lanes;
  const Lanes<2> Lambda_11_11_p406_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_11_11_p325_lanes + detail::make_pack<Real>(c13, c20) * Lambda_11_11_p333_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p408_lanes = s20 * detail::make_pack<Real>(Lambda_11_11_p289_lanes[1],
      Lambda_11_11_p327_lanes[1], Lambda_11_11_p327_lanes[2], Lambda_11_11_p327_lanes[3],
      Lambda_11_11_p289_lanes[1], Lambda_11_11_p289_lanes[1], Lambda_11_11_p289_lanes[1],
      Lambda_11_11_p289_lanes[1]) + c20 * Lambda_11_11_p335_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = s3 * inverse_D2_p20;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p416_lanes = s13 * detail::make_pack<Real>(Lambda_11_11_p313_lanes[0],
      Lambda_11_11_p259_lanes[0], Lambda_11_11_p289_lanes[0], Lambda_11_11_p315_lanes[3],
      Lambda_11_11_p315_lanes[4], Lambda_11_11_p315_lanes[5], Lambda_11_11_p313_lanes[0],
      Lambda_11_11_p313_lanes[0]) + c13 * Lambda_11_11_p345_lanes;
  const Lanes<8> Lambda_11_11_p422_lanes = c13 * detail::make_pack<Real>(Lambda_11_11_p357_lanes[0],
      Lambda_11_11_p295_lanes[0], Lambda_11_11_p357_lanes[0], Lambda_11_11_p271_lanes[3],
      Lambda_11_11_p271_lanes[4], Lambda_11_11_p271_lanes[5], Lambda_11_11_p357_lanes[0],
      Lambda_11_11_p357_lanes[0]) + s13 * Lambda_11_11_p320_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p22 = inverse_D2_p18 - inverse_D2_p21;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p440_lanes = inverse_D10_p29_lanes[1] * Lambda_11_11_p408_lanes;
  const Real Lambda_11_11_p447 = Lambda_11_11_p404_lanes[1] - inverse_D10_p28_lanes[1] *
      Lambda_11_11_p408_lanes[0];
  const Real Lambda_11_11_p448 = Lambda_11_11_p210 - inverse_D10_p29_lanes[1] *
      Lambda_11_11_p408_lanes[0];
  const Lanes<8> Lambda_11_11_p449_lanes = c20 * Lambda_11_11_p277_lanes + s20 *
      Lambda_11_11_p280_lanes - inverse_D10_p28_lanes[1] * Lambda_11_11_p408_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p452_lanes = detail::make_pack<Real>(Lambda_11_11_p422_lanes[0],
      Lambda_11_11_p422_lanes[1], Lambda_11_11_p404_lanes[0], Lambda_11_11_p422_lanes[0],
      Lambda_11_11_p422_lanes[0], Lambda_11_11_p422_lanes[0], Lambda_11_11_p422_lanes[0],
      Lambda_11_11_p422_lanes[0]) - inverse_D10_p28_lanes[0] * Lambda_11_11_p416_lanes;
  const Lanes<8> Lambda_11_11_p455_lanes = Lambda_11_11_p246_lanes - inverse_D10_p29_lanes[0] *
      Lambda_11_11_p416_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p458_lanes = c20 * detail::make_pack<Real>(Lambda_11_11_p289_lanes[1],
      Lambda_11_11_p327_lanes[1], Lambda_11_11_p327_lanes[2], Lambda_11_11_p327_lanes[3],
      Lambda_11_11_p289_lanes[1], Lambda_11_11_p289_lanes[1], Lambda_11_11_p289_lanes[1],
      Lambda_11_11_p289_lanes[1]) - s20 * Lambda_11_11_p335_lanes - inverse_D11_p4_lanes[1] *
      Lambda_11_11_p408_lanes;
  const Lanes<8> Lambda_11_11_p465_lanes = detail::make_pack<Real>(Lambda_11_11_p406_lanes[1],
      Lambda_11_11_p399_lanes[1], Lambda_11_11_p399_lanes[2], Lambda_11_11_p399_lanes[3],
      Lambda_11_11_p406_lanes[1], Lambda_11_11_p406_lanes[1], Lambda_11_11_p406_lanes[1],
      Lambda_11_11_p406_lanes[1]) - inverse_D10_p30_lanes[1] * Lambda_11_11_p408_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_11_11_p475_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = 24.5839218 + 0.422 * inverse_D2_p22;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * inverse_D2_p22);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p496_lanes = c19 * Lambda_11_11_p440_lanes + s19 *
      Lambda_11_11_p449_lanes;
  const Real Lambda_11_11_p499 = s19 * Lambda_11_11_p447 - c19 * Lambda_11_11_p448;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p502_lanes = -(c19 * Lambda_11_11_p458_lanes);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p530_lanes = s19 * Lambda_11_11_p440_lanes - c19 *
      Lambda_11_11_p449_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_11_11_p541_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_11_11_p455_lanes[2], Lambda_11_11_p448) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_11_11_p452_lanes[2],
      Lambda_11_11_p447));

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p543_lanes = 0.269 * Lambda_11_11_p465_lanes - s19 *
      Lambda_11_11_p458_lanes - inverse_D10_p83_lanes[1] * Lambda_11_11_p502_lanes;
  const Lanes<8> Lambda_11_11_p547_lanes = -detail::make_pack<Real>(Lambda_11_11_p499,
      Lambda_11_11_p496_lanes[1], Lambda_11_11_p496_lanes[2], Lambda_11_11_p496_lanes[3],
      Lambda_11_11_p499, Lambda_11_11_p499, Lambda_11_11_p499, Lambda_11_11_p499) +
      inverse_D8_p16_lanes[1] * Lambda_11_11_p502_lanes;
  const Lanes<8> Lambda_11_11_p551_lanes = Lambda_11_11_p465_lanes - inverse_D8_p17_lanes[1] *
      Lambda_11_11_p502_lanes;
  const Lanes<8> Lambda_11_11_p559_lanes = 0.269 * detail::make_pack<Real>(Lambda_11_11_p499,
      Lambda_11_11_p496_lanes[1], Lambda_11_11_p496_lanes[2], Lambda_11_11_p496_lanes[3],
      Lambda_11_11_p499, Lambda_11_11_p499, Lambda_11_11_p499, Lambda_11_11_p499) -
      inverse_D10_p84_lanes[1] * Lambda_11_11_p502_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p607_lanes = s18 * Lambda_11_11_p543_lanes + c18 *
      Lambda_11_11_p559_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p627_lanes = inverse_D9_p7_lanes[1] * Lambda_11_11_p607_lanes;
  const Lanes<8> Lambda_11_11_p635_lanes = c18 * Lambda_11_11_p543_lanes - s18 *
      Lambda_11_11_p559_lanes - inverse_D9_p9_lanes[1] * Lambda_11_11_p607_lanes;
  const Lanes<8> Lambda_11_11_p639_lanes = -(detail::make_pack<Real>(Lambda_11_11_p541_lanes[1],
      Lambda_11_11_p530_lanes[1], Lambda_11_11_p530_lanes[2], Lambda_11_11_p530_lanes[3],
      Lambda_11_11_p541_lanes[1], Lambda_11_11_p541_lanes[1], Lambda_11_11_p541_lanes[1],
      Lambda_11_11_p541_lanes[1]) - inverse_D8_p18_lanes[1] * Lambda_11_11_p502_lanes) -
      inverse_D8_p81_lanes[1] * Lambda_11_11_p607_lanes;
  const Lanes<8> Lambda_11_11_p643_lanes = c18 * Lambda_11_11_p547_lanes - s18 *
      Lambda_11_11_p551_lanes - inverse_D8_p80_lanes[1] * Lambda_11_11_p607_lanes;
  const Lanes<8> Lambda_11_11_p655_lanes = s18 * Lambda_11_11_p547_lanes + c18 *
      Lambda_11_11_p551_lanes - inverse_D8_p82_lanes[1] * Lambda_11_11_p607_lanes;
  const Lanes<8> Lambda_11_11_p687_lanes = c17 * Lambda_11_11_p627_lanes - s17 *
      Lambda_11_11_p635_lanes;
  const Lanes<8> Lambda_11_11_p691_lanes = s17 * Lambda_11_11_p639_lanes - c17 *
      Lambda_11_11_p643_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p703_lanes = inverse_D8_p149_lanes[1] * Lambda_11_11_p687_lanes;
  const Lanes<8> Lambda_11_11_p739_lanes = c17 * Lambda_11_11_p635_lanes + s17 *
      Lambda_11_11_p627_lanes + 0.282 * Lambda_11_11_p655_lanes - Lambda_11_11_p703_lanes;
  const Lanes<8> Lambda_11_11_p743_lanes = 0.282 * Lambda_11_11_p691_lanes -
      inverse_D8_p150_lanes[1] * Lambda_11_11_p687_lanes;
  const Lanes<8> Lambda_11_11_p747_lanes = -Lambda_11_11_p691_lanes + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p687_lanes;
  const Lanes<8> Lambda_11_11_p751_lanes = Lambda_11_11_p655_lanes - inverse_D6_p33_lanes[1] *
      Lambda_11_11_p687_lanes;
  const Lanes<8> Lambda_11_11_p755_lanes = -(s17 * Lambda_11_11_p643_lanes + c17 *
      Lambda_11_11_p639_lanes) + inverse_D6_p35_lanes[1] * Lambda_11_11_p687_lanes;
  const Lanes<8> Lambda_11_11_p795_lanes = c16 * Lambda_11_11_p739_lanes - s16 *
      Lambda_11_11_p743_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p815_lanes = Lambda_11_11_p402_lanes[1] * Lambda_11_11_p795_lanes;
  const Lanes<8> Lambda_11_11_p831_lanes = s16 * Lambda_11_11_p739_lanes + c16 *
      Lambda_11_11_p743_lanes - inverse_D7_p8_lanes[1] * Lambda_11_11_p795_lanes;
  const Lanes<8> Lambda_11_11_p839_lanes = -Lambda_11_11_p755_lanes + inverse_D6_p161_lanes[1] *
      Lambda_11_11_p795_lanes;
  const Lanes<8> Lambda_11_11_p843_lanes = s16 * Lambda_11_11_p747_lanes + c16 *
      Lambda_11_11_p751_lanes - inverse_D6_p163_lanes[1] * Lambda_11_11_p795_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p3 = c3 * inverse_D2_p20 - inverse_D2_p17;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p879_lanes = s15 * Lambda_11_11_p815_lanes + c15 *
      Lambda_11_11_p831_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p4 = inverse_D2_p22 - inverse_D1_p1 * inverse_D1_p2;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p899_lanes = inverse_D6_p294_lanes[1] * Lambda_11_11_p879_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p5 = 0.031999971599999996 + 0.422 * inverse_D1_p3;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p911_lanes = Lambda_11_11_p475_lanes[1] * Lambda_11_11_p879_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p6 = inverse_D1_p5 * inverse_D2;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p915_lanes = c15 * Lambda_11_11_p839_lanes - s15 *
      Lambda_11_11_p843_lanes - inverse_D6_p292_lanes[1] * Lambda_11_11_p879_lanes;
  const Lanes<8> Lambda_11_11_p919_lanes = c16 * Lambda_11_11_p747_lanes - s16 *
      Lambda_11_11_p751_lanes - inverse_D6_p165_lanes[1] * Lambda_11_11_p795_lanes -
      Lambda_11_11_p899_lanes;
  const Lanes<8> Lambda_11_11_p923_lanes = s15 * Lambda_11_11_p839_lanes + c15 *
      Lambda_11_11_p843_lanes - inverse_D6_p299_lanes[1] * Lambda_11_11_p879_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p927 = 0.49024375482668536 * Lambda_11_11_p244_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p928_lanes = c15 * Lambda_11_11_p815_lanes - s15 *
      Lambda_11_11_p831_lanes - inverse_D6_p332_lanes[1] * Lambda_11_11_p879_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p968 = -(0.086 * Lambda_11_11_p187) - (-0.004018575007348824) *
      Lambda_11_11_p244_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p969_lanes = s14 * Lambda_11_11_p919_lanes + c14 *
      Lambda_11_11_p915_lanes;
  const Lanes<8> Lambda_11_11_p981_lanes = c14 * Lambda_11_11_p919_lanes - s14 *
      Lambda_11_11_p915_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p989 = s20 * Lambda_11_11_p259_lanes[1] + c20 * Lambda_11_11_p968;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p994_lanes = 0.226 * Lambda_11_11_p923_lanes + (-0.18) *
      Lambda_11_11_p969_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p7 = s2 * (inverse_D1_p4 - (inverse_D2_p19 + inverse_D2_p21 -
      inverse_D1_p5 * inverse_D1_p6)) + c2 * (2.0 * (inverse_D1_p3 - inverse_D1_p1 *
      inverse_D1_p6));

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1010 = c20 * Lambda_11_11_p295_lanes[1] + s20 * Lambda_11_11_p927 -
      inverse_D10_p28_lanes[1] * Lambda_11_11_p989;
  const Real Lambda_11_11_p1011 = Lambda_11_11_p187 - inverse_D10_p29_lanes[1] * Lambda_11_11_p989;
  const Real Lambda_11_11_p1012 = c20 * Lambda_11_11_p259_lanes[1] - s20 * Lambda_11_11_p968 -
      inverse_D11_p4_lanes[1] * Lambda_11_11_p989;
  const Real Lambda_11_11_p1013 = s20 * Lambda_11_11_p295_lanes[1] - c20 * Lambda_11_11_p927 -
      inverse_D10_p30_lanes[1] * Lambda_11_11_p989;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1014_lanes = -(c14 * Lambda_11_11_p911_lanes + s14 *
      Lambda_11_11_p928_lanes + Lambda_11_11_p994_lanes);
  const Lanes<8> Lambda_11_11_p1018_lanes = inverse_D5_p73 * Lambda_11_11_p1014_lanes;
  const Lanes<8> Lambda_11_11_p1038_lanes = (-0.18) * Lambda_11_11_p981_lanes -
      (s14 * Lambda_11_11_p911_lanes - c14 * Lambda_11_11_p928_lanes) - Lambda_11_11_p1018_lanes;
  const Lanes<8> Lambda_11_11_p1042_lanes = 0.226 * Lambda_11_11_p981_lanes - inverse_D5_p72 *
      Lambda_11_11_p1014_lanes;
  const Lanes<8> Lambda_11_11_p1046_lanes = Lambda_11_11_p981_lanes - inverse_D5_p71 *
      Lambda_11_11_p1014_lanes;
  const Lanes<8> Lambda_11_11_p1050_lanes = Lambda_11_11_p969_lanes + inverse_D4_p15 *
      Lambda_11_11_p1014_lanes;
  const Lanes<8> Lambda_11_11_p1054_lanes = Lambda_11_11_p923_lanes - inverse_D4_p16 *
      Lambda_11_11_p1014_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1058 = s19 * Lambda_11_11_p1010 - c19 * Lambda_11_11_p1011;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1059 = -(c19 * Lambda_11_11_p1012);
  const Real Lambda_11_11_p1084 = 0.269 * Lambda_11_11_p1013 - s19 * Lambda_11_11_p1012 -
      inverse_D10_p83_lanes[1] * Lambda_11_11_p1059;
  const Real Lambda_11_11_p1085 = -Lambda_11_11_p1058 + inverse_D8_p16_lanes[1] *
      Lambda_11_11_p1059;
  const Real Lambda_11_11_p1094 = Lambda_11_11_p1013 - inverse_D8_p17_lanes[1] * Lambda_11_11_p1059;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1105 = 0.49024375482668536 * Lambda_11_11_p283_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1110 = 0.269 * Lambda_11_11_p1058 - inverse_D10_p84_lanes[1] *
      Lambda_11_11_p1059;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_11_11_p1111_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_11_11_p455_lanes[1], Lambda_11_11_p1011) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_11_11_p452_lanes[1],
      Lambda_11_11_p1010));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p4 - s2 * inverse_D1_p7));

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1113 = -(0.086 * Lambda_11_11_p243) - (-0.004018575007348824) *
      Lambda_11_11_p283_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1114_lanes = s6 * Lambda_11_11_p1038_lanes + c6 *
      Lambda_11_11_p1042_lanes + 0.072 * Lambda_11_11_p1046_lanes;
  const Lanes<8> Lambda_11_11_p1118_lanes = s6 * Lambda_11_11_p1050_lanes + c6 *
      Lambda_11_11_p1054_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1130 = s18 * Lambda_11_11_p1084 + c18 * Lambda_11_11_p1110;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1155 = inverse_D9_p7_lanes[1] * Lambda_11_11_p1130;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1156 = s20 * Lambda_11_11_p313_lanes[1] + c20 * Lambda_11_11_p1113;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1161_lanes = -(0.072 * Lambda_11_11_p1118_lanes) + inverse_D4_p39 *
      Lambda_11_11_p1114_lanes;
  const Lanes<8> Lambda_11_11_p1165_lanes = c6 * Lambda_11_11_p1038_lanes - s6 *
      Lambda_11_11_p1042_lanes - inverse_D4_p40 * Lambda_11_11_p1114_lanes;
  const Lanes<8> Lambda_11_11_p1169_lanes = c6 * Lambda_11_11_p1050_lanes - s6 *
      Lambda_11_11_p1054_lanes - inverse_D3_p7 * Lambda_11_11_p1114_lanes;
  const Lanes<8> Lambda_11_11_p1173_lanes = Lambda_11_11_p1046_lanes - inverse_D3_p6 *
      Lambda_11_11_p1114_lanes;
  const Lanes<8> Lambda_11_11_p1177_lanes = Lambda_11_11_p1118_lanes - inverse_D3_p8 *
      Lambda_11_11_p1114_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1181 = c18 * Lambda_11_11_p1084 - s18 * Lambda_11_11_p1110 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p1130;
  const Real Lambda_11_11_p1182 = c18 * Lambda_11_11_p1085 - s18 * Lambda_11_11_p1094 -
      inverse_D8_p80_lanes[1] * Lambda_11_11_p1130;
  const Real Lambda_11_11_p1183 = -(Lambda_11_11_p1111_lanes[1] - inverse_D8_p18_lanes[1] *
      Lambda_11_11_p1059) - inverse_D8_p81_lanes[1] * Lambda_11_11_p1130;
  const Real Lambda_11_11_p1184 = s18 * Lambda_11_11_p1085 + c18 * Lambda_11_11_p1094 -
      inverse_D8_p82_lanes[1] * Lambda_11_11_p1130;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1209 = c20 * Lambda_11_11_p357_lanes[1] + s20 * Lambda_11_11_p1105 -
      inverse_D10_p28_lanes[1] * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1210 = Lambda_11_11_p243 - inverse_D10_p29_lanes[1] * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1211 = c20 * Lambda_11_11_p313_lanes[1] - s20 * Lambda_11_11_p1113 -
      inverse_D11_p4_lanes[1] * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1212 = s20 * Lambda_11_11_p357_lanes[1] - c20 * Lambda_11_11_p1105 -
      inverse_D10_p30_lanes[1] * Lambda_11_11_p1156;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1229_lanes = s5 * Lambda_11_11_p1169_lanes - c5 *
      Lambda_11_11_p1173_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1233 = c17 * Lambda_11_11_p1155 - s17 * Lambda_11_11_p1181;
  const Real Lambda_11_11_p1234 = s17 * Lambda_11_11_p1183 - c17 * Lambda_11_11_p1182;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1239_lanes = -(s5 * Lambda_11_11_p1161_lanes + c5 *
      Lambda_11_11_p1165_lanes);

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1263 = s19 * Lambda_11_11_p1209 - c19 * Lambda_11_11_p1210;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1270 = -(c19 * Lambda_11_11_p1211);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1295_lanes = inverse_D10_p29_lanes[0] * Lambda_11_11_p416_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1301 = 0.269 * Lambda_11_11_p1212 - s19 * Lambda_11_11_p1211 -
      inverse_D10_p83_lanes[1] * Lambda_11_11_p1270;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p1302_lanes = s13 *
      detail::make_pack<Real>(Lambda_11_11_p357_lanes[0], Lambda_11_11_p295_lanes[0],
      Lambda_11_11_p357_lanes[0], Lambda_11_11_p271_lanes[3], Lambda_11_11_p271_lanes[4],
      Lambda_11_11_p271_lanes[5], Lambda_11_11_p357_lanes[0], Lambda_11_11_p357_lanes[0]) - c13 *
      Lambda_11_11_p320_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_11_11_p1313_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_11_11_p455_lanes[0], Lambda_11_11_p1210) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_11_11_p452_lanes[0],
      Lambda_11_11_p1209));

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1315_lanes = c13 *
      detail::make_pack<Real>(Lambda_11_11_p313_lanes[0], Lambda_11_11_p259_lanes[0],
      Lambda_11_11_p289_lanes[0], Lambda_11_11_p315_lanes[3], Lambda_11_11_p315_lanes[4],
      Lambda_11_11_p315_lanes[5], Lambda_11_11_p313_lanes[0], Lambda_11_11_p313_lanes[0]) - s13 *
      Lambda_11_11_p345_lanes - inverse_D11_p4_lanes[0] * Lambda_11_11_p416_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1321 = -Lambda_11_11_p1263 + inverse_D8_p16_lanes[1] *
      Lambda_11_11_p1270;
  const Real Lambda_11_11_p1322 = Lambda_11_11_p1212 - inverse_D8_p17_lanes[1] * Lambda_11_11_p1270;
  const Real Lambda_11_11_p1326 = 0.269 * Lambda_11_11_p1263 - inverse_D10_p84_lanes[1] *
      Lambda_11_11_p1270;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1327_lanes = Lambda_11_11_p422_lanes - inverse_D10_p28_lanes[0] *
      Lambda_11_11_p416_lanes;
  const Lanes<8> Lambda_11_11_p1330_lanes = detail::make_pack<Real>(Lambda_11_11_p1302_lanes[0],
      Lambda_11_11_p1302_lanes[1], Lambda_11_11_p406_lanes[0], Lambda_11_11_p1302_lanes[3],
      Lambda_11_11_p1302_lanes[4], Lambda_11_11_p1302_lanes[5], Lambda_11_11_p1302_lanes[0],
      Lambda_11_11_p1302_lanes[0]) - inverse_D10_p30_lanes[0] * Lambda_11_11_p416_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1336 = c17 * Lambda_11_11_p1181 + s17 * Lambda_11_11_p1155 + 0.282 *
      Lambda_11_11_p1184 - inverse_D8_p149_lanes[1] * Lambda_11_11_p1233;
  const Real Lambda_11_11_p1337 = 0.282 * Lambda_11_11_p1234 - inverse_D8_p150_lanes[1] *
      Lambda_11_11_p1233;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1350_lanes = s12 * Lambda_11_11_p452_lanes - c12 *
      Lambda_11_11_p455_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1366_lanes = -(c12 * Lambda_11_11_p1315_lanes);

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1402 = s18 * Lambda_11_11_p1301 + c18 * Lambda_11_11_p1326;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1409_lanes = c12 * Lambda_11_11_p1295_lanes + s12 *
      Lambda_11_11_p1327_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1418 = c16 * Lambda_11_11_p1336 - s16 * Lambda_11_11_p1337;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1423_lanes = Lambda_11_11_p1330_lanes - inverse_D8_p17_lanes[0] *
      Lambda_11_11_p1366_lanes;
  const Lanes<8> Lambda_11_11_p1435_lanes = 0.269 * Lambda_11_11_p1330_lanes - s12 *
      Lambda_11_11_p1315_lanes - inverse_D10_p83_lanes[0] * Lambda_11_11_p1366_lanes;
  const Lanes<8> Lambda_11_11_p1447_lanes = -detail::make_pack<Real>(Lambda_11_11_p1350_lanes[0],
      Lambda_11_11_p1350_lanes[1], Lambda_11_11_p1350_lanes[2], Lambda_11_11_p1409_lanes[3],
      Lambda_11_11_p1409_lanes[4], Lambda_11_11_p1409_lanes[5], Lambda_11_11_p1350_lanes[0],
      Lambda_11_11_p1350_lanes[0]) + inverse_D8_p16_lanes[0] * Lambda_11_11_p1366_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1453_lanes = s12 * Lambda_11_11_p1295_lanes - c12 *
      Lambda_11_11_p1327_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1456 = inverse_D9_p7_lanes[1] * Lambda_11_11_p1402;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1457 = Lambda_11_11_p402_lanes[1] * Lambda_11_11_p1418;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1470_lanes = -(s5 * Lambda_11_11_p1165_lanes - c5 *
      Lambda_11_11_p1161_lanes + 0.21799999999999997 * Lambda_11_11_p1177_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1510_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_11_11_p1350_lanes[0], Lambda_11_11_p1350_lanes[1],
      Lambda_11_11_p1350_lanes[2], Lambda_11_11_p1409_lanes[3], Lambda_11_11_p1409_lanes[4],
      Lambda_11_11_p1409_lanes[5], Lambda_11_11_p1350_lanes[0], Lambda_11_11_p1350_lanes[0]) -
      inverse_D10_p84_lanes[0] * Lambda_11_11_p1366_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1522 = c18 * Lambda_11_11_p1301 - s18 * Lambda_11_11_p1326 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p1402;
  const Real Lambda_11_11_p1523 = c18 * Lambda_11_11_p1321 - s18 * Lambda_11_11_p1322 -
      inverse_D8_p80_lanes[1] * Lambda_11_11_p1402;
  const Real Lambda_11_11_p1524 = -(Lambda_11_11_p1313_lanes[1] - inverse_D8_p18_lanes[1] *
      Lambda_11_11_p1270) - inverse_D8_p81_lanes[1] * Lambda_11_11_p1402;
  const Real Lambda_11_11_p1525 = s18 * Lambda_11_11_p1321 + c18 * Lambda_11_11_p1322 -
      inverse_D8_p82_lanes[1] * Lambda_11_11_p1402;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1526 = s16 * Lambda_11_11_p1336 + c16 * Lambda_11_11_p1337 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p1418;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1557 = -Lambda_11_11_p1234 + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p1233;
  const Real Lambda_11_11_p1558 = Lambda_11_11_p1184 - inverse_D6_p33_lanes[1] * Lambda_11_11_p1233;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1563_lanes = s11 * Lambda_11_11_p1435_lanes + c11 *
      Lambda_11_11_p1510_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1583 = c17 * Lambda_11_11_p1456 - s17 * Lambda_11_11_p1522;
  const Real Lambda_11_11_p1584 = s17 * Lambda_11_11_p1524 - c17 * Lambda_11_11_p1523;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1585_lanes = c4 * (-(0.21799999999999997 *
      Lambda_11_11_p1229_lanes) + inverse_D3_p37 * Lambda_11_11_p1239_lanes);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1607_lanes = inverse_D9_p7_lanes[0] * Lambda_11_11_p1563_lanes;
  const Lanes<8> Lambda_11_11_p1619_lanes = c11 * Lambda_11_11_p1435_lanes - s11 *
      Lambda_11_11_p1510_lanes - inverse_D9_p9_lanes[0] * Lambda_11_11_p1563_lanes;
  const Lanes<8> Lambda_11_11_p1625_lanes = -(detail::make_pack<Real>(Lambda_11_11_p1313_lanes[0],
      Lambda_11_11_p1111_lanes[0], Lambda_11_11_p541_lanes[0], Lambda_11_11_p1453_lanes[3],
      Lambda_11_11_p1453_lanes[4], Lambda_11_11_p1453_lanes[5], Lambda_11_11_p1313_lanes[0],
      Lambda_11_11_p1313_lanes[0]) - inverse_D8_p18_lanes[0] * Lambda_11_11_p1366_lanes) -
      inverse_D8_p81_lanes[0] * Lambda_11_11_p1563_lanes;
  const Lanes<8> Lambda_11_11_p1631_lanes = c11 * Lambda_11_11_p1447_lanes - s11 *
      Lambda_11_11_p1423_lanes - inverse_D8_p80_lanes[0] * Lambda_11_11_p1563_lanes;
  const Lanes<8> Lambda_11_11_p1649_lanes = s11 * Lambda_11_11_p1447_lanes + c11 *
      Lambda_11_11_p1423_lanes - inverse_D8_p82_lanes[0] * Lambda_11_11_p1563_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1655 = c17 * Lambda_11_11_p1522 + s17 * Lambda_11_11_p1456 + 0.282 *
      Lambda_11_11_p1525 - inverse_D8_p149_lanes[1] * Lambda_11_11_p1583;
  const Real Lambda_11_11_p1656 = 0.282 * Lambda_11_11_p1584 - inverse_D8_p150_lanes[1] *
      Lambda_11_11_p1583;
  const Real Lambda_11_11_p1657 = -Lambda_11_11_p1584 + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p1583;
  const Real Lambda_11_11_p1658 = Lambda_11_11_p1525 - inverse_D6_p33_lanes[1] * Lambda_11_11_p1583;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1701_lanes = c10 * Lambda_11_11_p1607_lanes - s10 *
      Lambda_11_11_p1619_lanes;
  const Lanes<8> Lambda_11_11_p1707_lanes = s10 * Lambda_11_11_p1625_lanes - c10 *
      Lambda_11_11_p1631_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1719 = c16 * Lambda_11_11_p1655 - s16 * Lambda_11_11_p1656;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1720 = s15 * Lambda_11_11_p1457 + c15 * Lambda_11_11_p1526;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1727_lanes = inverse_D8_p149_lanes[0] * Lambda_11_11_p1701_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1775 = Lambda_11_11_p402_lanes[1] * Lambda_11_11_p1719;
  const Real Lambda_11_11_p1782 = -(-(s17 * Lambda_11_11_p1182 + c17 * Lambda_11_11_p1183) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p1233) + inverse_D6_p161_lanes[1] * Lambda_11_11_p1418;
  const Real Lambda_11_11_p1783 = s16 * Lambda_11_11_p1557 + c16 * Lambda_11_11_p1558 -
      inverse_D6_p163_lanes[1] * Lambda_11_11_p1418;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1784_lanes = c10 * Lambda_11_11_p1619_lanes + s10 *
      Lambda_11_11_p1607_lanes + 0.282 * Lambda_11_11_p1649_lanes - Lambda_11_11_p1727_lanes;
  const Lanes<8> Lambda_11_11_p1790_lanes = 0.282 * Lambda_11_11_p1707_lanes -
      inverse_D8_p150_lanes[0] * Lambda_11_11_p1701_lanes;
  const Lanes<8> Lambda_11_11_p1796_lanes = -Lambda_11_11_p1707_lanes + inverse_D6_p31_lanes[0] *
      Lambda_11_11_p1701_lanes;
  const Lanes<8> Lambda_11_11_p1802_lanes = Lambda_11_11_p1649_lanes - inverse_D6_p33_lanes[0] *
      Lambda_11_11_p1701_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1808 = s16 * Lambda_11_11_p1655 + c16 * Lambda_11_11_p1656 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p1719;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1809_lanes = -(s10 * Lambda_11_11_p1631_lanes + c10 *
      Lambda_11_11_p1625_lanes) + inverse_D6_p35_lanes[0] * Lambda_11_11_p1701_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1815 = s16 * Lambda_11_11_p1657 + c16 * Lambda_11_11_p1658 -
      inverse_D6_p163_lanes[1] * Lambda_11_11_p1719;
  const Real Lambda_11_11_p1816 = -(-(s17 * Lambda_11_11_p1523 + c17 * Lambda_11_11_p1524) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p1583) + inverse_D6_p161_lanes[1] * Lambda_11_11_p1719;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1871_lanes = c9 * Lambda_11_11_p1784_lanes - s9 *
      Lambda_11_11_p1790_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1889 = s15 * Lambda_11_11_p1775 + c15 * Lambda_11_11_p1808;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p1910_lanes = Lambda_11_11_p402_lanes[0] * Lambda_11_11_p1871_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1942_lanes = s4 * (Lambda_11_11_p1470_lanes - inverse_D3_p36 *
      Lambda_11_11_p1239_lanes) + Lambda_11_11_p1585_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p1954_lanes = s9 * Lambda_11_11_p1784_lanes + c9 *
      Lambda_11_11_p1790_lanes - inverse_D7_p8_lanes[0] * Lambda_11_11_p1871_lanes;
  const Lanes<8> Lambda_11_11_p1966_lanes = -Lambda_11_11_p1809_lanes + inverse_D6_p161_lanes[0] *
      Lambda_11_11_p1871_lanes;
  const Lanes<8> Lambda_11_11_p1972_lanes = s9 * Lambda_11_11_p1796_lanes + c9 *
      Lambda_11_11_p1802_lanes - inverse_D6_p163_lanes[0] * Lambda_11_11_p1871_lanes;
  const Lanes<8> Lambda_11_11_p1978_lanes = c9 * Lambda_11_11_p1796_lanes - s9 *
      Lambda_11_11_p1802_lanes - inverse_D6_p165_lanes[0] * Lambda_11_11_p1871_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1990_lanes = s4 * (Lambda_11_11_p1177_lanes + inverse_D2_p6 *
      Lambda_11_11_p1239_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1994_lanes = inverse_D2_p16 * Lambda_11_11_p1942_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2050_lanes = -(s5 * Lambda_11_11_p1173_lanes + c5 *
      Lambda_11_11_p1169_lanes) - inverse_D2_p7 * Lambda_11_11_p1239_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p2054_lanes = s8 * Lambda_11_11_p1910_lanes + c8 *
      Lambda_11_11_p1954_lanes;
  const Lanes<8> Lambda_11_11_p2060_lanes = c8 * Lambda_11_11_p1966_lanes - s8 *
      Lambda_11_11_p1972_lanes;
  const Lanes<8> Lambda_11_11_p2066_lanes = c8 * Lambda_11_11_p1910_lanes - s8 *
      Lambda_11_11_p1954_lanes;
  const Lanes<8> Lambda_11_11_p2072_lanes = s8 * Lambda_11_11_p1966_lanes + c8 *
      Lambda_11_11_p1972_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2078_lanes = c4 * (-Lambda_11_11_p1229_lanes + inverse_D2_p5 *
      Lambda_11_11_p1239_lanes) - Lambda_11_11_p1990_lanes - Lambda_11_11_p1994_lanes;
  const Lanes<8> Lambda_11_11_p2086_lanes = -Lambda_11_11_p2050_lanes + inverse_D2_p15 *
      Lambda_11_11_p1942_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2122_lanes = detail::make_pack<Real>(Lambda_11_11_p475_lanes[0],
      Lambda_11_11_p475_lanes[0], Lambda_11_11_p475_lanes[0], Lambda_11_11_p475_lanes[0],
      Lambda_11_11_p475_lanes[0], Lambda_11_11_p475_lanes[0], Lambda_11_11_p475_lanes[1],
      Lambda_11_11_p475_lanes[1]) * detail::make_pack<Real>(Lambda_11_11_p2054_lanes[0],
      Lambda_11_11_p2054_lanes[1], Lambda_11_11_p2054_lanes[2], Lambda_11_11_p2054_lanes[3],
      Lambda_11_11_p2054_lanes[4], Lambda_11_11_p2054_lanes[5], Lambda_11_11_p1889,
      Lambda_11_11_p1720);
  const Lanes<8> Lambda_11_11_p2146_lanes = detail::make_pack<Real>(Lambda_11_11_p1978_lanes[0],
      Lambda_11_11_p1978_lanes[1], Lambda_11_11_p1978_lanes[2], Lambda_11_11_p1978_lanes[3],
      Lambda_11_11_p1978_lanes[4], Lambda_11_11_p1978_lanes[5], c16 * Lambda_11_11_p1657 - s16 *
      Lambda_11_11_p1658 - inverse_D6_p165_lanes[1] * Lambda_11_11_p1719, c16 * Lambda_11_11_p1557 -
      s16 * Lambda_11_11_p1558 - inverse_D6_p165_lanes[1] * Lambda_11_11_p1418) -
      detail::make_pack<Real>(inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[1], inverse_D6_p294_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2054_lanes[0], Lambda_11_11_p2054_lanes[1],
      Lambda_11_11_p2054_lanes[2], Lambda_11_11_p2054_lanes[3], Lambda_11_11_p2054_lanes[4],
      Lambda_11_11_p2054_lanes[5], Lambda_11_11_p1889, Lambda_11_11_p1720);
  const Lanes<8> Lambda_11_11_p2154_lanes = detail::make_pack<Real>(Lambda_11_11_p2060_lanes[0],
      Lambda_11_11_p2060_lanes[1], Lambda_11_11_p2060_lanes[2], Lambda_11_11_p2060_lanes[3],
      Lambda_11_11_p2060_lanes[4], Lambda_11_11_p2060_lanes[5], c15 * Lambda_11_11_p1816 - s15 *
      Lambda_11_11_p1815, c15 * Lambda_11_11_p1782 - s15 * Lambda_11_11_p1783) -
      detail::make_pack<Real>(inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[1], inverse_D6_p292_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2054_lanes[0], Lambda_11_11_p2054_lanes[1],
      Lambda_11_11_p2054_lanes[2], Lambda_11_11_p2054_lanes[3], Lambda_11_11_p2054_lanes[4],
      Lambda_11_11_p2054_lanes[5], Lambda_11_11_p1889, Lambda_11_11_p1720);
  const Lanes<8> Lambda_11_11_p2162_lanes = detail::make_pack<Real>(Lambda_11_11_p2066_lanes[0],
      Lambda_11_11_p2066_lanes[1], Lambda_11_11_p2066_lanes[2], Lambda_11_11_p2066_lanes[3],
      Lambda_11_11_p2066_lanes[4], Lambda_11_11_p2066_lanes[5], c15 * Lambda_11_11_p1775 - s15 *
      Lambda_11_11_p1808, c15 * Lambda_11_11_p1457 - s15 * Lambda_11_11_p1526) -
      detail::make_pack<Real>(inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[1], inverse_D6_p332_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2054_lanes[0], Lambda_11_11_p2054_lanes[1],
      Lambda_11_11_p2054_lanes[2], Lambda_11_11_p2054_lanes[3], Lambda_11_11_p2054_lanes[4],
      Lambda_11_11_p2054_lanes[5], Lambda_11_11_p1889, Lambda_11_11_p1720);
  const Lanes<8> Lambda_11_11_p2170_lanes = detail::make_pack<Real>(Lambda_11_11_p2072_lanes[0],
      Lambda_11_11_p2072_lanes[1], Lambda_11_11_p2072_lanes[2], Lambda_11_11_p2072_lanes[3],
      Lambda_11_11_p2072_lanes[4], Lambda_11_11_p2072_lanes[5], s15 * Lambda_11_11_p1816 + c15 *
      Lambda_11_11_p1815, s15 * Lambda_11_11_p1782 + c15 * Lambda_11_11_p1783) -
      detail::make_pack<Real>(inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[1], inverse_D6_p299_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2054_lanes[0], Lambda_11_11_p2054_lanes[1],
      Lambda_11_11_p2054_lanes[2], Lambda_11_11_p2054_lanes[3], Lambda_11_11_p2054_lanes[4],
      Lambda_11_11_p2054_lanes[5], Lambda_11_11_p1889, Lambda_11_11_p1720);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2194_lanes = c3 * Lambda_11_11_p2078_lanes - s3 *
      Lambda_11_11_p2086_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2198_lanes = Lambda_11_11_p1114_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2206_lanes = Lambda_11_11_p1014_lanes * inverse_D6;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2210_lanes = Lambda_11_11_p1239_lanes * inverse_D4;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2214_lanes = Lambda_11_11_p1942_lanes * inverse_D3;
  const Lanes<8> Lambda_11_11_p2274_lanes = 0.422 * Lambda_11_11_p2194_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2278_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_11_11_p2146_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_11_11_p2154_lanes;
  const Lanes<8> Lambda_11_11_p2294_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p2146_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p2154_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p2318_lanes = Lambda_11_11_p2274_lanes * inverse_D2;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2354_lanes = Lambda_11_11_p2054_lanes * inverse_D7_lanes[0];
  const Lanes<8> Lambda_11_11_p2360_lanes = 0.226 * Lambda_11_11_p2170_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_11_11_p2278_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p2368_lanes = Lambda_11_11_p1871_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p2382_lanes = Lambda_11_11_p1701_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2392_lanes = Lambda_11_11_p1563_lanes * inverse_D10_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p2404_lanes = Lambda_11_11_p1366_lanes * inverse_D11_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p2410_lanes = s2 * (s3 * Lambda_11_11_p2078_lanes + c3 *
      Lambda_11_11_p2086_lanes - inverse_D1_p6 * Lambda_11_11_p2274_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2414_lanes = Lambda_11_11_p416_lanes * inverse_D12_lanes[0];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_11_11_p2428_lanes = 0.086 * Lambda_11_11_p283_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p2430_lanes = detail::make_pack<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_pack<Real>(Lambda_11_11_p283_lanes[0],
      Lambda_11_11_p244_lanes[0], Lambda_11_11_p285_lanes[0], Lambda_11_11_p246_lanes[0],
      Lambda_11_11_p246_lanes[1], Lambda_11_11_p246_lanes[2], Lambda_11_11_p283_lanes[0],
      Lambda_11_11_p283_lanes[0]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2442_lanes = Lambda_11_11_p2392_lanes * Lambda_11_11_p1563_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2454_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p2122_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p2162_lanes + Lambda_11_11_p2360_lanes);
  const Lanes<8> Lambda_11_11_p2462_lanes = inverse_D5_p73 * Lambda_11_11_p2454_lanes;
  const Lanes<8> Lambda_11_11_p2520_lanes = Lambda_11_11_p2454_lanes * inverse_D6;
  const Real Lambda_11_11_p2526 = Lambda_11_11_p2454_lanes[7] * inverse_D6;
  const Real Lambda_11_11_p2527 = Lambda_11_11_p2454_lanes[6] * inverse_D6;
  const Lanes<8> Lambda_11_11_p2536_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_11_11_p2294_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_11_11_p2122_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_11_11_p2162_lanes) -
      Lambda_11_11_p2462_lanes;
  const Lanes<8> Lambda_11_11_p2544_lanes = 0.226 * Lambda_11_11_p2294_lanes - inverse_D5_p72 *
      Lambda_11_11_p2454_lanes;
  const Lanes<8> Lambda_11_11_p2552_lanes = Lambda_11_11_p2294_lanes - inverse_D5_p71 *
      Lambda_11_11_p2454_lanes;
  const Lanes<8> Lambda_11_11_p2560_lanes = Lambda_11_11_p2278_lanes + inverse_D4_p15 *
      Lambda_11_11_p2454_lanes;
  const Lanes<8> Lambda_11_11_p2568_lanes = Lambda_11_11_p2170_lanes - inverse_D4_p16 *
      Lambda_11_11_p2454_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p2592_lanes = 0.434 *
      (c2 * (Lambda_11_11_p2194_lanes - inverse_D1_p2 * Lambda_11_11_p2274_lanes) -
      Lambda_11_11_p2410_lanes);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2689_lanes = Lambda_11_11_p2392_lanes * Lambda_11_11_p1563_lanes[1];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_11_11_p2712_lanes = 0.086 * Lambda_11_11_p244_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2719_lanes = s6 * Lambda_11_11_p2560_lanes + c6 *
      Lambda_11_11_p2568_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2735_lanes = Lambda_11_11_p2430_lanes * Lambda_11_11_p2428_lanes[0] +
      Lambda_11_11_p2414_lanes * Lambda_11_11_p416_lanes[0] + Lambda_11_11_p2404_lanes *
      Lambda_11_11_p1366_lanes[0] + Lambda_11_11_p2442_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p2749_lanes = Lambda_11_11_p2592_lanes * inverse_D1;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2753_lanes = s6 * Lambda_11_11_p2536_lanes + c6 *
      Lambda_11_11_p2544_lanes + 0.072 * Lambda_11_11_p2552_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2826_lanes = Lambda_11_11_p2753_lanes * inverse_D5;
  const Lanes<8> Lambda_11_11_p2863_lanes = -(0.072 * Lambda_11_11_p2719_lanes) + inverse_D4_p39 *
      Lambda_11_11_p2753_lanes;
  const Lanes<8> Lambda_11_11_p2871_lanes = c6 * Lambda_11_11_p2536_lanes - s6 *
      Lambda_11_11_p2544_lanes - inverse_D4_p40 * Lambda_11_11_p2753_lanes;
  const Lanes<8> Lambda_11_11_p2879_lanes = c6 * Lambda_11_11_p2560_lanes - s6 *
      Lambda_11_11_p2568_lanes - inverse_D3_p7 * Lambda_11_11_p2753_lanes;
  const Lanes<8> Lambda_11_11_p2887_lanes = Lambda_11_11_p2552_lanes - inverse_D3_p6 *
      Lambda_11_11_p2753_lanes;
  const Lanes<8> Lambda_11_11_p2895_lanes = Lambda_11_11_p2719_lanes - inverse_D3_p8 *
      Lambda_11_11_p2753_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2903_lanes = Lambda_11_11_p2735_lanes + Lambda_11_11_p2382_lanes *
      Lambda_11_11_p1701_lanes[0] + Lambda_11_11_p2368_lanes * Lambda_11_11_p1871_lanes[0] +
      Lambda_11_11_p2354_lanes * Lambda_11_11_p2054_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3013_lanes = Lambda_11_11_p2903_lanes + Lambda_11_11_p2520_lanes *
      Lambda_11_11_p2454_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3019_lanes = Lambda_11_11_p2430_lanes * Lambda_11_11_p2712_lanes[0] +
      Lambda_11_11_p2414_lanes * Lambda_11_11_p416_lanes[1] + Lambda_11_11_p2404_lanes *
      Lambda_11_11_p1366_lanes[1] + Lambda_11_11_p2689_lanes;
  const Lanes<8> Lambda_11_11_p3036_lanes = Lambda_11_11_p2392_lanes * Lambda_11_11_p1563_lanes[2];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p3052_lanes = s5 * Lambda_11_11_p2879_lanes - c5 *
      Lambda_11_11_p2887_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3107_lanes = -(s5 * Lambda_11_11_p2863_lanes + c5 *
      Lambda_11_11_p2871_lanes);
  const Lanes<8> Lambda_11_11_p3179_lanes = Lambda_11_11_p3107_lanes * inverse_D4;
  const Lanes<8> Lambda_11_11_p3228_lanes = -(s5 * Lambda_11_11_p2871_lanes - c5 *
      Lambda_11_11_p2863_lanes + 0.21799999999999997 * Lambda_11_11_p2895_lanes);
  const Lanes<8> Lambda_11_11_p3281_lanes = -(s5 * Lambda_11_11_p2887_lanes + c5 *
      Lambda_11_11_p2879_lanes) - inverse_D2_p7 * Lambda_11_11_p3107_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3297_lanes = Lambda_11_11_p3019_lanes + Lambda_11_11_p2382_lanes *
      Lambda_11_11_p1701_lanes[1] + Lambda_11_11_p2368_lanes * Lambda_11_11_p1871_lanes[1] +
      Lambda_11_11_p2354_lanes * Lambda_11_11_p2054_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3330_lanes = c4 * (-(0.21799999999999997 *
      Lambda_11_11_p3052_lanes) + inverse_D3_p37 * Lambda_11_11_p3107_lanes);
  const Lanes<8> Lambda_11_11_p3349_lanes = s4 * (Lambda_11_11_p2895_lanes + inverse_D2_p6 *
      Lambda_11_11_p3107_lanes);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3365_lanes = Lambda_11_11_p3297_lanes + Lambda_11_11_p2520_lanes *
      Lambda_11_11_p2454_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3373_lanes = Lambda_11_11_p2392_lanes * Lambda_11_11_p1563_lanes[3];
  const Lanes<8> Lambda_11_11_p3384_lanes = Lambda_11_11_p2430_lanes * Lambda_11_11_p285_lanes[0] +
      Lambda_11_11_p2414_lanes * Lambda_11_11_p416_lanes[2] + Lambda_11_11_p2404_lanes *
      Lambda_11_11_p1366_lanes[2] + Lambda_11_11_p3036_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3400_lanes = s4 * (Lambda_11_11_p3228_lanes - inverse_D3_p36 *
      Lambda_11_11_p3107_lanes) + Lambda_11_11_p3330_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3459_lanes = inverse_D2_p16 * Lambda_11_11_p3400_lanes;
  const Lanes<8> Lambda_11_11_p3475_lanes = Lambda_11_11_p3400_lanes * inverse_D3;
  const Lanes<8> Lambda_11_11_p3497_lanes = Lambda_11_11_p2214_lanes * Lambda_11_11_p3400_lanes[0];
  const Lanes<8> Lambda_11_11_p3501_lanes = Lambda_11_11_p2214_lanes * Lambda_11_11_p3400_lanes[1];
  const Lanes<8> Lambda_11_11_p3505_lanes = Lambda_11_11_p2214_lanes * Lambda_11_11_p3400_lanes[2];
  const Lanes<8> Lambda_11_11_p3509_lanes = Lambda_11_11_p2214_lanes * Lambda_11_11_p3400_lanes[3];
  const Lanes<8> Lambda_11_11_p3525_lanes = Lambda_11_11_p2214_lanes * Lambda_11_11_p3400_lanes[4];
  const Lanes<8> Lambda_11_11_p3529_lanes = c4 * (-Lambda_11_11_p3052_lanes + inverse_D2_p5 *
      Lambda_11_11_p3107_lanes) - Lambda_11_11_p3349_lanes - Lambda_11_11_p3459_lanes;
  const Lanes<8> Lambda_11_11_p3537_lanes = -Lambda_11_11_p3281_lanes + inverse_D2_p15 *
      Lambda_11_11_p3400_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3560_lanes = Lambda_11_11_p3384_lanes + Lambda_11_11_p2382_lanes *
      Lambda_11_11_p1701_lanes[2] + Lambda_11_11_p2368_lanes * Lambda_11_11_p1871_lanes[2] +
      Lambda_11_11_p2354_lanes * Lambda_11_11_p2054_lanes[2];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3570_lanes = Lambda_11_11_p2430_lanes * Lambda_11_11_p246_lanes[0] +
      Lambda_11_11_p2414_lanes * Lambda_11_11_p416_lanes[3] + Lambda_11_11_p2404_lanes *
      Lambda_11_11_p1366_lanes[3] + Lambda_11_11_p3373_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3610_lanes = detail::make_pack<Real>(Lambda_11_11_p3013_lanes[0],
      Lambda_11_11_p3013_lanes[1], Lambda_11_11_p3013_lanes[2], Lambda_11_11_p3013_lanes[3],
      Lambda_11_11_p3013_lanes[4], Lambda_11_11_p3013_lanes[5], Lambda_11_11_p2527 *
      Lambda_11_11_p2454_lanes[0], Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[0]) +
      Lambda_11_11_p2826_lanes * Lambda_11_11_p2753_lanes[0] + Lambda_11_11_p3179_lanes *
      Lambda_11_11_p3107_lanes[0] + Lambda_11_11_p3475_lanes * Lambda_11_11_p3400_lanes[0];
  const Lanes<8> Lambda_11_11_p3618_lanes = detail::make_pack<Real>(Lambda_11_11_p3365_lanes[1],
      Lambda_11_11_p3365_lanes[1], Lambda_11_11_p3365_lanes[2], Lambda_11_11_p3365_lanes[3],
      Lambda_11_11_p3365_lanes[4], Lambda_11_11_p3365_lanes[5], Lambda_11_11_p2527 *
      Lambda_11_11_p2454_lanes[1], Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[1]) +
      Lambda_11_11_p2826_lanes * Lambda_11_11_p2753_lanes[1] + Lambda_11_11_p3179_lanes *
      Lambda_11_11_p3107_lanes[1] + Lambda_11_11_p3475_lanes * Lambda_11_11_p3400_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3625_lanes = Lambda_11_11_p3560_lanes + Lambda_11_11_p2520_lanes *
      Lambda_11_11_p2454_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3634_lanes = c3 * Lambda_11_11_p3529_lanes - s3 *
      Lambda_11_11_p3537_lanes;
  const Lanes<8> Lambda_11_11_p3669_lanes = 0.422 * Lambda_11_11_p3634_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3683_lanes = Lambda_11_11_p3570_lanes + Lambda_11_11_p2382_lanes *
      Lambda_11_11_p1701_lanes[3] + Lambda_11_11_p2368_lanes * Lambda_11_11_p1871_lanes[3] +
      Lambda_11_11_p2354_lanes * Lambda_11_11_p2054_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3690_lanes = Lambda_11_11_p2206_lanes * Lambda_11_11_p2454_lanes[0] +
      Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[0] + Lambda_11_11_p2210_lanes *
      Lambda_11_11_p3107_lanes[0] + Lambda_11_11_p3497_lanes;
  const Lanes<8> Lambda_11_11_p3694_lanes = Lambda_11_11_p2206_lanes * Lambda_11_11_p2454_lanes[1] +
      Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[1] + Lambda_11_11_p2210_lanes *
      Lambda_11_11_p3107_lanes[1] + Lambda_11_11_p3501_lanes;
  const Lanes<8> Lambda_11_11_p3698_lanes = Lambda_11_11_p2206_lanes * Lambda_11_11_p2454_lanes[2] +
      Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[2] + Lambda_11_11_p2210_lanes *
      Lambda_11_11_p3107_lanes[2] + Lambda_11_11_p3505_lanes;
  const Lanes<8> Lambda_11_11_p3702_lanes = Lambda_11_11_p2206_lanes * Lambda_11_11_p2454_lanes[3] +
      Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[3] + Lambda_11_11_p2210_lanes *
      Lambda_11_11_p3107_lanes[3] + Lambda_11_11_p3509_lanes;
  const Lanes<8> Lambda_11_11_p3720_lanes = detail::make_pack<Real>(Lambda_11_11_p3625_lanes[2],
      Lambda_11_11_p3625_lanes[2], Lambda_11_11_p3625_lanes[2], Lambda_11_11_p3625_lanes[3],
      Lambda_11_11_p3625_lanes[4], Lambda_11_11_p3625_lanes[5], Lambda_11_11_p2527 *
      Lambda_11_11_p2454_lanes[2], Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[2]) +
      Lambda_11_11_p2826_lanes * Lambda_11_11_p2753_lanes[2] + Lambda_11_11_p3179_lanes *
      Lambda_11_11_p3107_lanes[2] + Lambda_11_11_p3475_lanes * Lambda_11_11_p3400_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3726_lanes = Lambda_11_11_p3683_lanes + Lambda_11_11_p2520_lanes *
      Lambda_11_11_p2454_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3733_lanes = Lambda_11_11_p2214_lanes * Lambda_11_11_p3400_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3753_lanes = Lambda_11_11_p3669_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3788_lanes = Lambda_11_11_p2206_lanes * Lambda_11_11_p2454_lanes[4] +
      Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[4] + Lambda_11_11_p2210_lanes *
      Lambda_11_11_p3107_lanes[4] + Lambda_11_11_p3525_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p3858_lanes = Lambda_11_11_p687_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3862_lanes = Lambda_11_11_p607_lanes * inverse_D10_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p3866_lanes = Lambda_11_11_p795_lanes * inverse_D8_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p3870_lanes = Lambda_11_11_p502_lanes * inverse_D11_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3882_lanes = s2 * (s3 * Lambda_11_11_p3529_lanes + c3 *
      Lambda_11_11_p3537_lanes - inverse_D1_p6 * Lambda_11_11_p3669_lanes);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p3890_lanes = Lambda_11_11_p408_lanes * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p3894_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_11_11_p285_lanes[1], Lambda_11_11_p243, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p285_lanes[1], Lambda_11_11_p285_lanes[1],
      Lambda_11_11_p285_lanes[1], Lambda_11_11_p285_lanes[1]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3913_lanes = detail::make_pack<Real>(Lambda_11_11_p3726_lanes[3],
      Lambda_11_11_p3726_lanes[3], Lambda_11_11_p3726_lanes[3], Lambda_11_11_p3726_lanes[3],
      Lambda_11_11_p3726_lanes[4], Lambda_11_11_p3726_lanes[5], Lambda_11_11_p2527 *
      Lambda_11_11_p2454_lanes[3], Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[3]) +
      Lambda_11_11_p2826_lanes * Lambda_11_11_p2753_lanes[3] + Lambda_11_11_p3179_lanes *
      Lambda_11_11_p3107_lanes[3] + Lambda_11_11_p3475_lanes * Lambda_11_11_p3400_lanes[3];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p3918_lanes = Lambda_11_11_p2430_lanes * Lambda_11_11_p246_lanes[1] +
      detail::make_pack<Real>(Lambda_11_11_p2414_lanes[4] * Lambda_11_11_p416_lanes[4],
      Lambda_11_11_p2414_lanes[4] * Lambda_11_11_p416_lanes[4], Lambda_11_11_p2414_lanes[4] *
      Lambda_11_11_p416_lanes[4], Lambda_11_11_p2414_lanes[4] * Lambda_11_11_p416_lanes[4],
      Lambda_11_11_p2414_lanes[4] * Lambda_11_11_p416_lanes[4], Lambda_11_11_p2414_lanes[5] *
      Lambda_11_11_p416_lanes[4], Lambda_11_11_p2414_lanes[4] * Lambda_11_11_p416_lanes[4],
      Lambda_11_11_p2414_lanes[4] * Lambda_11_11_p416_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2404_lanes[4] * Lambda_11_11_p1366_lanes[4],
      Lambda_11_11_p2404_lanes[4] * Lambda_11_11_p1366_lanes[4], Lambda_11_11_p2404_lanes[4] *
      Lambda_11_11_p1366_lanes[4], Lambda_11_11_p2404_lanes[4] * Lambda_11_11_p1366_lanes[4],
      Lambda_11_11_p2404_lanes[4] * Lambda_11_11_p1366_lanes[4], Lambda_11_11_p2404_lanes[5] *
      Lambda_11_11_p1366_lanes[4], Lambda_11_11_p2404_lanes[4] * Lambda_11_11_p1366_lanes[4],
      Lambda_11_11_p2404_lanes[4] * Lambda_11_11_p1366_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2392_lanes[4] * Lambda_11_11_p1563_lanes[4],
      Lambda_11_11_p2392_lanes[4] * Lambda_11_11_p1563_lanes[4], Lambda_11_11_p2392_lanes[4] *
      Lambda_11_11_p1563_lanes[4], Lambda_11_11_p2392_lanes[4] * Lambda_11_11_p1563_lanes[4],
      Lambda_11_11_p2392_lanes[4] * Lambda_11_11_p1563_lanes[4], Lambda_11_11_p2392_lanes[5] *
      Lambda_11_11_p1563_lanes[4], Lambda_11_11_p2392_lanes[4] * Lambda_11_11_p1563_lanes[4],
      Lambda_11_11_p2392_lanes[4] * Lambda_11_11_p1563_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2382_lanes[4] * Lambda_11_11_p1701_lanes[4],
      Lambda_11_11_p2382_lanes[4] * Lambda_11_11_p1701_lanes[4], Lambda_11_11_p2382_lanes[4] *
      Lambda_11_11_p1701_lanes[4], Lambda_11_11_p2382_lanes[4] * Lambda_11_11_p1701_lanes[4],
      Lambda_11_11_p2382_lanes[4] * Lambda_11_11_p1701_lanes[4], Lambda_11_11_p2382_lanes[5] *
      Lambda_11_11_p1701_lanes[4], Lambda_11_11_p2382_lanes[4] * Lambda_11_11_p1701_lanes[4],
      Lambda_11_11_p2382_lanes[4] * Lambda_11_11_p1701_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2368_lanes[4] * Lambda_11_11_p1871_lanes[4],
      Lambda_11_11_p2368_lanes[4] * Lambda_11_11_p1871_lanes[4], Lambda_11_11_p2368_lanes[4] *
      Lambda_11_11_p1871_lanes[4], Lambda_11_11_p2368_lanes[4] * Lambda_11_11_p1871_lanes[4],
      Lambda_11_11_p2368_lanes[4] * Lambda_11_11_p1871_lanes[4], Lambda_11_11_p2368_lanes[5] *
      Lambda_11_11_p1871_lanes[4], Lambda_11_11_p2368_lanes[4] * Lambda_11_11_p1871_lanes[4],
      Lambda_11_11_p2368_lanes[4] * Lambda_11_11_p1871_lanes[4]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3930_lanes = Lambda_11_11_p879_lanes * inverse_D7_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p3936_lanes = detail::make_pack<Real>(Lambda_11_11_p2392_lanes[5],
      Lambda_11_11_p3862_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1563_lanes[5],
      Lambda_11_11_p607_lanes[3]);

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3978_lanes = 0.434 *
      (c2 * (Lambda_11_11_p3634_lanes - inverse_D1_p2 * Lambda_11_11_p3669_lanes) -
      Lambda_11_11_p3882_lanes);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3986_lanes = Lambda_11_11_p3918_lanes +
      detail::make_pack<Real>(Lambda_11_11_p2354_lanes[4] * Lambda_11_11_p2054_lanes[4],
      Lambda_11_11_p2354_lanes[4] * Lambda_11_11_p2054_lanes[4], Lambda_11_11_p2354_lanes[4] *
      Lambda_11_11_p2054_lanes[4], Lambda_11_11_p2354_lanes[4] * Lambda_11_11_p2054_lanes[4],
      Lambda_11_11_p2354_lanes[4] * Lambda_11_11_p2054_lanes[4], Lambda_11_11_p2354_lanes[5] *
      Lambda_11_11_p2054_lanes[4], Lambda_11_11_p2354_lanes[4] * Lambda_11_11_p2054_lanes[4],
      Lambda_11_11_p2354_lanes[4] * Lambda_11_11_p2054_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2520_lanes[4] * Lambda_11_11_p2454_lanes[4],
      Lambda_11_11_p2520_lanes[4] * Lambda_11_11_p2454_lanes[4], Lambda_11_11_p2520_lanes[4] *
      Lambda_11_11_p2454_lanes[4], Lambda_11_11_p2520_lanes[4] * Lambda_11_11_p2454_lanes[4],
      Lambda_11_11_p2520_lanes[4] * Lambda_11_11_p2454_lanes[4], Lambda_11_11_p2520_lanes[5] *
      Lambda_11_11_p2454_lanes[4], Lambda_11_11_p2520_lanes[4] * Lambda_11_11_p2454_lanes[4],
      Lambda_11_11_p2520_lanes[4] * Lambda_11_11_p2454_lanes[4]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4022_lanes = Lambda_11_11_p3862_lanes * Lambda_11_11_p1402;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4042_lanes = Lambda_11_11_p3978_lanes * inverse_D1;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p4080_lanes = Lambda_11_11_p2206_lanes * Lambda_11_11_p2454_lanes[5] +
      Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[5] + Lambda_11_11_p2210_lanes *
      Lambda_11_11_p3107_lanes[5] + Lambda_11_11_p3733_lanes;
  const Lanes<8> Lambda_11_11_p4130_lanes = detail::make_pack<Real>(Lambda_11_11_p3986_lanes[4],
      Lambda_11_11_p3986_lanes[4], Lambda_11_11_p3986_lanes[4], Lambda_11_11_p3986_lanes[4],
      Lambda_11_11_p3986_lanes[4], Lambda_11_11_p3986_lanes[5], Lambda_11_11_p2527 *
      Lambda_11_11_p2454_lanes[4], Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[4]) +
      Lambda_11_11_p2826_lanes * Lambda_11_11_p2753_lanes[4] + Lambda_11_11_p3179_lanes *
      Lambda_11_11_p3107_lanes[4] + Lambda_11_11_p3475_lanes * Lambda_11_11_p3400_lanes[4];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p4134_lanes = detail::make_pack<Real>(Lambda_11_11_p2430_lanes[5],
      Lambda_11_11_p3894_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p246_lanes[2],
      Lambda_11_11_p210) + detail::make_pack<Real>(Lambda_11_11_p2414_lanes[5],
      Lambda_11_11_p3890_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p416_lanes[5],
      Lambda_11_11_p408_lanes[3]) + detail::make_pack<Real>(Lambda_11_11_p2404_lanes[5],
      Lambda_11_11_p3870_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1366_lanes[5],
      Lambda_11_11_p502_lanes[3]) + Lambda_11_11_p3936_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4143_lanes = Lambda_11_11_p3690_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p3669_lanes[0] + Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[0];
  const Lanes<8> Lambda_11_11_p4151_lanes = Lambda_11_11_p3610_lanes + Lambda_11_11_p3753_lanes *
      Lambda_11_11_p3669_lanes[0] + Lambda_11_11_p4042_lanes * Lambda_11_11_p3978_lanes[0];
  const Real Lambda_11_11_p4183 = 1.0 / Lambda_11_11_p4151_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_11_11_p4210_lanes = Lambda_11_11_p4134_lanes +
      detail::make_pack<Real>(Lambda_11_11_p2382_lanes[5], Lambda_11_11_p3858_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p1701_lanes[5], Lambda_11_11_p687_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p2368_lanes[5], Lambda_11_11_p3866_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p1871_lanes[5], Lambda_11_11_p795_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p2354_lanes[5], Lambda_11_11_p3930_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p2054_lanes[5], Lambda_11_11_p879_lanes[3]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4212_lanes = Lambda_11_11_p3894_lanes * Lambda_11_11_p2428_lanes[1] +
      Lambda_11_11_p3890_lanes * Lambda_11_11_p1156 + Lambda_11_11_p3870_lanes *
      Lambda_11_11_p1270 + Lambda_11_11_p4022_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p4227 = 91.62274020012977 * Lambda_11_11_p283_lanes[1] *
      Lambda_11_11_p2428_lanes[1] + Lambda_11_11_p1156 * inverse_D12_lanes[1] * Lambda_11_11_p1156 +
      Lambda_11_11_p1270 * inverse_D11_lanes[1] * Lambda_11_11_p1270;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4232_lanes = Lambda_11_11_p4151_lanes * Lambda_11_11_p4183;
  const Lanes<8> Lambda_11_11_p4242_lanes = Lambda_11_11_p4143_lanes * Lambda_11_11_p4183;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p4246 = Lambda_11_11_p1720 * inverse_D7_lanes[1];
  const Lanes<8> Lambda_11_11_p4247_lanes = Lambda_11_11_p4212_lanes + Lambda_11_11_p3858_lanes *
      Lambda_11_11_p1583 + Lambda_11_11_p3866_lanes * Lambda_11_11_p1719 +
      Lambda_11_11_p3930_lanes * Lambda_11_11_p1889;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p4251 = Lambda_11_11_p1418 * inverse_D8_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p4252_lanes = detail::make_pack<Real>(Lambda_11_11_p4210_lanes[0] +
      Lambda_11_11_p2520_lanes[5] * Lambda_11_11_p2454_lanes[5], Lambda_11_11_p4210_lanes[0] +
      Lambda_11_11_p2520_lanes[5] * Lambda_11_11_p2454_lanes[5], Lambda_11_11_p4210_lanes[0] +
      Lambda_11_11_p2520_lanes[5] * Lambda_11_11_p2454_lanes[5], Lambda_11_11_p4210_lanes[0] +
      Lambda_11_11_p2520_lanes[5] * Lambda_11_11_p2454_lanes[5], Lambda_11_11_p4210_lanes[0] +
      Lambda_11_11_p2520_lanes[5] * Lambda_11_11_p2454_lanes[5], Lambda_11_11_p4210_lanes[0] +
      Lambda_11_11_p2520_lanes[5] * Lambda_11_11_p2454_lanes[5], Lambda_11_11_p2527 *
      Lambda_11_11_p2454_lanes[5], Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[5]) +
      Lambda_11_11_p2826_lanes * Lambda_11_11_p2753_lanes[5] + Lambda_11_11_p3179_lanes *
      Lambda_11_11_p3107_lanes[5] + Lambda_11_11_p3475_lanes * Lambda_11_11_p3400_lanes[5];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4255 = Lambda_11_11_p1233 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p4256 = Lambda_11_11_p1130 * inverse_D10_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p4279 = Lambda_11_11_p989 * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p4280 = 91.62274020012977 * Lambda_11_11_p244_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p4281 = Lambda_11_11_p1059 * inverse_D11_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p4288 = Lambda_11_11_p4227 + Lambda_11_11_p1402 * inverse_D10_lanes[1] *
      Lambda_11_11_p1402 + Lambda_11_11_p1583 * inverse_D9_lanes[1] * Lambda_11_11_p1583 +
      Lambda_11_11_p1719 * inverse_D8_lanes[1] * Lambda_11_11_p1719;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4297_lanes = Lambda_11_11_p3618_lanes + Lambda_11_11_p3753_lanes *
      Lambda_11_11_p3669_lanes[1] + Lambda_11_11_p4042_lanes * Lambda_11_11_p3978_lanes[1] -
      Lambda_11_11_p4232_lanes * Lambda_11_11_p4151_lanes[1];
  const Lanes<8> Lambda_11_11_p4304_lanes = Lambda_11_11_p3720_lanes + Lambda_11_11_p3753_lanes *
      Lambda_11_11_p3669_lanes[2] + Lambda_11_11_p4042_lanes * Lambda_11_11_p3978_lanes[2] -
      Lambda_11_11_p4232_lanes * Lambda_11_11_p4151_lanes[2];
  const Lanes<8> Lambda_11_11_p4310_lanes = Lambda_11_11_p3913_lanes + Lambda_11_11_p3753_lanes *
      Lambda_11_11_p3669_lanes[3] + Lambda_11_11_p4042_lanes * Lambda_11_11_p3978_lanes[3] -
      Lambda_11_11_p4232_lanes * Lambda_11_11_p4151_lanes[3];
  const Lanes<8> Lambda_11_11_p4315_lanes = Lambda_11_11_p4130_lanes + Lambda_11_11_p3753_lanes *
      Lambda_11_11_p3669_lanes[4] + Lambda_11_11_p4042_lanes * Lambda_11_11_p3978_lanes[4] -
      Lambda_11_11_p4232_lanes * Lambda_11_11_p4151_lanes[4];
  const Lanes<8> Lambda_11_11_p4322_lanes = Lambda_11_11_p3694_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p3669_lanes[1] + Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[1] -
      Lambda_11_11_p4242_lanes * Lambda_11_11_p4151_lanes[1];
  const Real Lambda_11_11_p4330 = 1.0 / Lambda_11_11_p4297_lanes[1];
  const Lanes<8> Lambda_11_11_p4331_lanes = Lambda_11_11_p3698_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p3669_lanes[2] + Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[2] -
      Lambda_11_11_p4242_lanes * Lambda_11_11_p4151_lanes[2];
  const Lanes<8> Lambda_11_11_p4339_lanes = Lambda_11_11_p4252_lanes + Lambda_11_11_p3753_lanes *
      Lambda_11_11_p3669_lanes[5] + Lambda_11_11_p4042_lanes * Lambda_11_11_p3978_lanes[5] -
      Lambda_11_11_p4232_lanes * Lambda_11_11_p4151_lanes[5];
  const Lanes<8> Lambda_11_11_p4358_lanes = Lambda_11_11_p3702_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p3669_lanes[3] + Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[3] -
      Lambda_11_11_p4242_lanes * Lambda_11_11_p4151_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4362_lanes = Lambda_11_11_p3862_lanes * Lambda_11_11_p1130;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4382_lanes = Lambda_11_11_p3788_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p3669_lanes[4] + Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[4] -
      Lambda_11_11_p4242_lanes * Lambda_11_11_p4151_lanes[4];
  const Lanes<8> Lambda_11_11_p4398_lanes = Lambda_11_11_p4080_lanes + Lambda_11_11_p2318_lanes *
      Lambda_11_11_p3669_lanes[5] + Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[5] -
      Lambda_11_11_p4242_lanes * Lambda_11_11_p4151_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4414_lanes = Lambda_11_11_p4247_lanes + Lambda_11_11_p2206_lanes *
      Lambda_11_11_p2454_lanes[6] + Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[6] +
      Lambda_11_11_p2210_lanes * Lambda_11_11_p3107_lanes[6];
  const Real Lambda_11_11_p4430 = Lambda_11_11_p4288 + Lambda_11_11_p1889 * inverse_D7_lanes[1] *
      Lambda_11_11_p1889 + Lambda_11_11_p2527 * Lambda_11_11_p2454_lanes[6] +
      Lambda_11_11_p2826_lanes[6] * Lambda_11_11_p2753_lanes[6] + Lambda_11_11_p3179_lanes[6] *
      Lambda_11_11_p3107_lanes[6];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4439 = Lambda_11_11_p4280 * Lambda_11_11_p2428_lanes[1] +
      Lambda_11_11_p4279 * Lambda_11_11_p1156 + Lambda_11_11_p4281 * Lambda_11_11_p1270 +
      Lambda_11_11_p4256 * Lambda_11_11_p1402 + Lambda_11_11_p4255 * Lambda_11_11_p1583;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4444_lanes = Lambda_11_11_p4297_lanes * Lambda_11_11_p4330;
  const Lanes<8> Lambda_11_11_p4450_lanes = Lambda_11_11_p4322_lanes * Lambda_11_11_p4330;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4458_lanes = Lambda_11_11_p3894_lanes * Lambda_11_11_p2712_lanes[1] +
      Lambda_11_11_p3890_lanes * Lambda_11_11_p989 + Lambda_11_11_p3870_lanes * Lambda_11_11_p1059 +
      Lambda_11_11_p4362_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4496_lanes = Lambda_11_11_p4304_lanes - Lambda_11_11_p4444_lanes *
      Lambda_11_11_p4297_lanes[2];
  const Real Lambda_11_11_p4514 = Lambda_11_11_p4430 + Lambda_11_11_p3475_lanes[6] *
      Lambda_11_11_p3400_lanes[6] + Lambda_11_11_p3753_lanes[6] * Lambda_11_11_p3669_lanes[6] +
      Lambda_11_11_p4042_lanes[6] * Lambda_11_11_p3978_lanes[6] - Lambda_11_11_p4232_lanes[6] *
      Lambda_11_11_p4151_lanes[6];
  const Lanes<8> Lambda_11_11_p4519_lanes = Lambda_11_11_p4331_lanes - Lambda_11_11_p4450_lanes *
      Lambda_11_11_p4297_lanes[2];
  const Real Lambda_11_11_p4531 = 1.0 / Lambda_11_11_p4496_lanes[2];
  const Lanes<8> Lambda_11_11_p4536_lanes = Lambda_11_11_p4414_lanes + Lambda_11_11_p2214_lanes *
      Lambda_11_11_p3400_lanes[6] + Lambda_11_11_p2318_lanes * Lambda_11_11_p3669_lanes[6] +
      Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[6];

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4540 = Lambda_11_11_p4439 + Lambda_11_11_p4251 * Lambda_11_11_p1719 +
      Lambda_11_11_p4246 * Lambda_11_11_p1889 + Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[6] +
      Lambda_11_11_p2826_lanes[7] * Lambda_11_11_p2753_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4545_lanes = Lambda_11_11_p4458_lanes + Lambda_11_11_p3858_lanes *
      Lambda_11_11_p1233 + Lambda_11_11_p3866_lanes * Lambda_11_11_p1418 +
      Lambda_11_11_p3930_lanes * Lambda_11_11_p1720;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4565_lanes = Lambda_11_11_p3862_lanes * Lambda_11_11_p607_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4617 = Lambda_11_11_p4280 * Lambda_11_11_p2712_lanes[1] +
      Lambda_11_11_p4279 * Lambda_11_11_p989 + Lambda_11_11_p4281 * Lambda_11_11_p1059 +
      Lambda_11_11_p4256 * Lambda_11_11_p1130 + Lambda_11_11_p4255 * Lambda_11_11_p1233;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4642_lanes = Lambda_11_11_p4545_lanes + Lambda_11_11_p2206_lanes *
      Lambda_11_11_p2454_lanes[7] + Lambda_11_11_p2198_lanes * Lambda_11_11_p2753_lanes[7] +
      Lambda_11_11_p2210_lanes * Lambda_11_11_p3107_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4646_lanes = Lambda_11_11_p4496_lanes * Lambda_11_11_p4531;
  const Lanes<8> Lambda_11_11_p4651_lanes = Lambda_11_11_p4519_lanes * Lambda_11_11_p4531;
  const Real Lambda_11_11_p4655 = Lambda_11_11_p4540 + Lambda_11_11_p3179_lanes[7] *
      Lambda_11_11_p3107_lanes[6] + Lambda_11_11_p3475_lanes[7] * Lambda_11_11_p3400_lanes[6] +
      Lambda_11_11_p3753_lanes[7] * Lambda_11_11_p3669_lanes[6] + Lambda_11_11_p4042_lanes[7] *
      Lambda_11_11_p3978_lanes[6];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4656_lanes = Lambda_11_11_p3894_lanes * Lambda_11_11_p285_lanes[1] +
      Lambda_11_11_p3890_lanes * Lambda_11_11_p408_lanes[0] + Lambda_11_11_p3870_lanes *
      Lambda_11_11_p502_lanes[0] + Lambda_11_11_p4565_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4694 = Lambda_11_11_p4617 + Lambda_11_11_p4251 * Lambda_11_11_p1418 +
      Lambda_11_11_p4246 * Lambda_11_11_p1720 + Lambda_11_11_p2526 * Lambda_11_11_p2454_lanes[7] +
      Lambda_11_11_p2826_lanes[7] * Lambda_11_11_p2753_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4712_lanes = Lambda_11_11_p4310_lanes - Lambda_11_11_p4444_lanes *
      Lambda_11_11_p4297_lanes[3] - Lambda_11_11_p4646_lanes * Lambda_11_11_p4496_lanes[3];
  const Lanes<8> Lambda_11_11_p4724_lanes = Lambda_11_11_p4358_lanes - Lambda_11_11_p4450_lanes *
      Lambda_11_11_p4297_lanes[3] - Lambda_11_11_p4651_lanes * Lambda_11_11_p4496_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4744_lanes = Lambda_11_11_p3862_lanes * Lambda_11_11_p607_lanes[1];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4747 = 1.0 / Lambda_11_11_p4712_lanes[3];
  const Lanes<8> Lambda_11_11_p4751_lanes = Lambda_11_11_p4536_lanes - Lambda_11_11_p4242_lanes *
      Lambda_11_11_p4151_lanes[6] - Lambda_11_11_p4450_lanes * Lambda_11_11_p4297_lanes[6] -
      Lambda_11_11_p4651_lanes * Lambda_11_11_p4496_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4758_lanes = Lambda_11_11_p4656_lanes + Lambda_11_11_p3858_lanes *
      Lambda_11_11_p687_lanes[0] + Lambda_11_11_p3866_lanes * Lambda_11_11_p795_lanes[0] +
      Lambda_11_11_p3930_lanes * Lambda_11_11_p879_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4769_lanes = Lambda_11_11_p4642_lanes + Lambda_11_11_p2214_lanes *
      Lambda_11_11_p3400_lanes[7] + Lambda_11_11_p2318_lanes * Lambda_11_11_p3669_lanes[7] +
      Lambda_11_11_p2749_lanes * Lambda_11_11_p3978_lanes[7];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4812_lanes = Lambda_11_11_p3894_lanes * Lambda_11_11_p243 +
      Lambda_11_11_p3890_lanes * Lambda_11_11_p408_lanes[1] + Lambda_11_11_p3870_lanes *
      Lambda_11_11_p502_lanes[1] + Lambda_11_11_p4744_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4815 = Lambda_11_11_p4694 + Lambda_11_11_p3179_lanes[7] *
      Lambda_11_11_p3107_lanes[7] + Lambda_11_11_p3475_lanes[7] * Lambda_11_11_p3400_lanes[7] +
      Lambda_11_11_p3753_lanes[7] * Lambda_11_11_p3669_lanes[7] + Lambda_11_11_p4042_lanes[7] *
      Lambda_11_11_p3978_lanes[7];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p4820_lanes = Lambda_11_11_p3894_lanes * Lambda_11_11_p187;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4829_lanes = Lambda_11_11_p4758_lanes + Lambda_11_11_p2206_lanes *
      Lambda_11_11_p1014_lanes[0] + Lambda_11_11_p2198_lanes * Lambda_11_11_p1114_lanes[0] +
      Lambda_11_11_p2210_lanes * Lambda_11_11_p1239_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4833_lanes = Lambda_11_11_p4769_lanes - Lambda_11_11_p4242_lanes *
      Lambda_11_11_p4151_lanes[7] - Lambda_11_11_p4450_lanes * Lambda_11_11_p4297_lanes[7] -
      Lambda_11_11_p4651_lanes * Lambda_11_11_p4496_lanes[7];
  const Lanes<8> Lambda_11_11_p4840_lanes = Lambda_11_11_p4712_lanes * Lambda_11_11_p4747;
  const Lanes<8> Lambda_11_11_p4844_lanes = Lambda_11_11_p4724_lanes * Lambda_11_11_p4747;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4852_lanes = Lambda_11_11_p4812_lanes + Lambda_11_11_p3858_lanes *
      Lambda_11_11_p687_lanes[1] + Lambda_11_11_p3866_lanes * Lambda_11_11_p795_lanes[1] +
      Lambda_11_11_p3930_lanes * Lambda_11_11_p879_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4882_lanes = Lambda_11_11_p4829_lanes + Lambda_11_11_p2214_lanes *
      Lambda_11_11_p1942_lanes[0] + Lambda_11_11_p2318_lanes * Lambda_11_11_p2274_lanes[0] +
      Lambda_11_11_p2749_lanes * Lambda_11_11_p2592_lanes[0];
  const Lanes<8> Lambda_11_11_p4893_lanes = Lambda_11_11_p4315_lanes - Lambda_11_11_p4444_lanes *
      Lambda_11_11_p4297_lanes[4] - Lambda_11_11_p4646_lanes * Lambda_11_11_p4496_lanes[4] -
      Lambda_11_11_p4840_lanes * Lambda_11_11_p4712_lanes[4];
  const Lanes<8> Lambda_11_11_p4897_lanes = Lambda_11_11_p4339_lanes - Lambda_11_11_p4444_lanes *
      Lambda_11_11_p4297_lanes[5] - Lambda_11_11_p4646_lanes * Lambda_11_11_p4496_lanes[5] -
      Lambda_11_11_p4840_lanes * Lambda_11_11_p4712_lanes[5];
  const Lanes<8> Lambda_11_11_p4900_lanes = Lambda_11_11_p4382_lanes - Lambda_11_11_p4450_lanes *
      Lambda_11_11_p4297_lanes[4] - Lambda_11_11_p4651_lanes * Lambda_11_11_p4496_lanes[4] -
      Lambda_11_11_p4844_lanes * Lambda_11_11_p4712_lanes[4];
  const Real Lambda_11_11_p4904 = Lambda_11_11_p4655 - Lambda_11_11_p4232_lanes[7] *
      Lambda_11_11_p4151_lanes[6] - Lambda_11_11_p4444_lanes[7] * Lambda_11_11_p4297_lanes[6] -
      Lambda_11_11_p4646_lanes[7] * Lambda_11_11_p4496_lanes[6] - Lambda_11_11_p4840_lanes[7] *
      Lambda_11_11_p4712_lanes[6];
  const Lanes<8> Lambda_11_11_p4905_lanes = Lambda_11_11_p4398_lanes - Lambda_11_11_p4450_lanes *
      Lambda_11_11_p4297_lanes[5] - Lambda_11_11_p4651_lanes * Lambda_11_11_p4496_lanes[5] -
      Lambda_11_11_p4844_lanes * Lambda_11_11_p4712_lanes[5];
  const Real Lambda_11_11_p4909 = Lambda_11_11_p4815 - Lambda_11_11_p4232_lanes[7] *
      Lambda_11_11_p4151_lanes[7] - Lambda_11_11_p4444_lanes[7] * Lambda_11_11_p4297_lanes[7] -
      Lambda_11_11_p4646_lanes[7] * Lambda_11_11_p4496_lanes[7] - Lambda_11_11_p4840_lanes[7] *
      Lambda_11_11_p4712_lanes[7];
  const Real Lambda_11_11_p4922 = 1.0 / Lambda_11_11_p4893_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4933_lanes = Lambda_11_11_p4852_lanes + Lambda_11_11_p2206_lanes *
      Lambda_11_11_p1014_lanes[1] + Lambda_11_11_p2198_lanes * Lambda_11_11_p1114_lanes[1] +
      Lambda_11_11_p2210_lanes * Lambda_11_11_p1239_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4936 = Lambda_11_11_p4820_lanes[3] + Lambda_11_11_p3890_lanes[3] *
      Lambda_11_11_p408_lanes[2] + Lambda_11_11_p3870_lanes[3] * Lambda_11_11_p502_lanes[2] +
      Lambda_11_11_p3862_lanes[3] * Lambda_11_11_p607_lanes[2] + Lambda_11_11_p3858_lanes[3] *
      Lambda_11_11_p687_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4937_lanes = Lambda_11_11_p4882_lanes - Lambda_11_11_p4242_lanes *
      Lambda_11_11_p4143_lanes[0] - Lambda_11_11_p4450_lanes * Lambda_11_11_p4322_lanes[0] -
      Lambda_11_11_p4651_lanes * Lambda_11_11_p4519_lanes[0];
  const Real Lambda_0_0_p1 = Lambda_11_11_p4444_lanes[2] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4232_lanes[2];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4951 = Lambda_11_11_p4820_lanes[2] + Lambda_11_11_p3890_lanes[2] *
      Lambda_11_11_p408_lanes[2] + Lambda_11_11_p3870_lanes[2] * Lambda_11_11_p502_lanes[2] +
      Lambda_11_11_p3862_lanes[2] * Lambda_11_11_p607_lanes[2] + Lambda_11_11_p3858_lanes[2] *
      Lambda_11_11_p687_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4952_lanes = Lambda_11_11_p4933_lanes + Lambda_11_11_p2214_lanes *
      Lambda_11_11_p1942_lanes[1] + Lambda_11_11_p2318_lanes * Lambda_11_11_p2274_lanes[1] +
      Lambda_11_11_p2749_lanes * Lambda_11_11_p2592_lanes[1];
  const Lanes<8> Lambda_11_11_p4955_lanes = Lambda_11_11_p4893_lanes * Lambda_11_11_p4922;
  const Lanes<8> Lambda_11_11_p4958_lanes = Lambda_11_11_p4900_lanes * Lambda_11_11_p4922;
  const Real Lambda_0_0_p2 = Lambda_11_11_p4444_lanes[3] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4232_lanes[3] - Lambda_11_11_p4646_lanes[3] * Lambda_0_0_p1;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4965 = Lambda_11_11_p4936 + Lambda_11_11_p3866_lanes[3] *
      Lambda_11_11_p795_lanes[2] + Lambda_11_11_p3930_lanes[3] * Lambda_11_11_p879_lanes[2] +
      Lambda_11_11_p2206_lanes[3] * Lambda_11_11_p1014_lanes[2] + Lambda_11_11_p2198_lanes[3] *
      Lambda_11_11_p1114_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4991_lanes = Lambda_11_11_p4897_lanes - Lambda_11_11_p4955_lanes *
      Lambda_11_11_p4893_lanes[5];
  const Real Lambda_11_11_p4994 = Lambda_11_11_p4514 - Lambda_11_11_p4444_lanes[6] *
      Lambda_11_11_p4297_lanes[6] - Lambda_11_11_p4646_lanes[6] * Lambda_11_11_p4496_lanes[6] -
      Lambda_11_11_p4840_lanes[6] * Lambda_11_11_p4712_lanes[6] - Lambda_11_11_p4955_lanes[6] *
      Lambda_11_11_p4893_lanes[6];
  const Lanes<8> Lambda_11_11_p4995_lanes = Lambda_11_11_p4905_lanes - Lambda_11_11_p4958_lanes *
      Lambda_11_11_p4893_lanes[5];
  const Lanes<8> Lambda_11_11_p5011_lanes = Lambda_11_11_p4952_lanes - Lambda_11_11_p4242_lanes *
      Lambda_11_11_p4143_lanes[1] - Lambda_11_11_p4450_lanes * Lambda_11_11_p4322_lanes[1] -
      Lambda_11_11_p4651_lanes * Lambda_11_11_p4519_lanes[1];
  const Real Lambda_11_11_p5014 = 1.0 / Lambda_11_11_p4991_lanes[5];
  const Real Lambda_0_0_p3 = Lambda_11_11_p4444_lanes[4] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4232_lanes[4] - Lambda_11_11_p4646_lanes[4] * Lambda_0_0_p1 -
      Lambda_11_11_p4840_lanes[4] * Lambda_0_0_p2;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p5015 = Lambda_11_11_p4951 + Lambda_11_11_p3866_lanes[2] *
      Lambda_11_11_p795_lanes[2] + Lambda_11_11_p3930_lanes[2] * Lambda_11_11_p879_lanes[2] +
      Lambda_11_11_p2206_lanes[2] * Lambda_11_11_p1014_lanes[2] + Lambda_11_11_p2198_lanes[2] *
      Lambda_11_11_p1114_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p5022 = Lambda_11_11_p4965 + Lambda_11_11_p2210_lanes[3] *
      Lambda_11_11_p1239_lanes[2] + Lambda_11_11_p2214_lanes[3] * Lambda_11_11_p1942_lanes[2] +
      Lambda_11_11_p2318_lanes[3] * Lambda_11_11_p2274_lanes[2] + Lambda_11_11_p2749_lanes[3] *
      Lambda_11_11_p2592_lanes[2];
  const Real Lambda_0_0_p4 = Lambda_11_11_p4444_lanes[5] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4232_lanes[5] - Lambda_11_11_p4646_lanes[5] * Lambda_0_0_p1 -
      Lambda_11_11_p4840_lanes[5] * Lambda_0_0_p2 - Lambda_11_11_p4955_lanes[5] * Lambda_0_0_p3;
  const Real Lambda_0_0_p5 = Lambda_11_11_p4444_lanes[6] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4232_lanes[6] - Lambda_11_11_p4646_lanes[6] * Lambda_0_0_p1 -
      Lambda_11_11_p4840_lanes[6] * Lambda_0_0_p2 - Lambda_11_11_p4955_lanes[6] * Lambda_0_0_p3;
  const Real Lambda_0_0_p6 = Lambda_11_11_p4444_lanes[7] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4232_lanes[7] - Lambda_11_11_p4646_lanes[7] * Lambda_0_0_p1 -
      Lambda_11_11_p4840_lanes[7] * Lambda_0_0_p2 - Lambda_11_11_p4955_lanes[7] * Lambda_0_0_p3;
  const Real Lambda_11_11_p5023 = Lambda_11_11_p4991_lanes[6] * Lambda_11_11_p5014;
  const Real Lambda_11_11_p5024 = Lambda_11_11_p4991_lanes[7] * Lambda_11_11_p5014;
  const Lanes<8> Lambda_11_11_p5025_lanes = Lambda_11_11_p4995_lanes * Lambda_11_11_p5014;
  const Real Lambda_11_11_p5029 = Lambda_11_11_p5015 + Lambda_11_11_p2210_lanes[2] *
      Lambda_11_11_p1239_lanes[2] + Lambda_11_11_p2214_lanes[2] * Lambda_11_11_p1942_lanes[2] +
      Lambda_11_11_p2318_lanes[2] * Lambda_11_11_p2274_lanes[2] + Lambda_11_11_p2749_lanes[2] *
      Lambda_11_11_p2592_lanes[2];
  const Real Lambda_11_11_p5045 = Lambda_11_11_p5022 - Lambda_11_11_p4242_lanes[3] *
      Lambda_11_11_p4143_lanes[2] - Lambda_11_11_p4450_lanes[3] * Lambda_11_11_p4322_lanes[2] -
      Lambda_11_11_p4651_lanes[3] * Lambda_11_11_p4519_lanes[2] - Lambda_11_11_p4844_lanes[3] *
      Lambda_11_11_p4724_lanes[2];
  const Real Lambda_11_11_p5046 = Lambda_11_11_p4904 - Lambda_11_11_p4955_lanes[7] *
      Lambda_11_11_p4893_lanes[6] - Lambda_11_11_p5024 * Lambda_11_11_p4991_lanes[6];
  const Lanes<8> Lambda_11_11_p5047_lanes = Lambda_11_11_p4751_lanes - Lambda_11_11_p4844_lanes *
      Lambda_11_11_p4712_lanes[6] - Lambda_11_11_p4958_lanes * Lambda_11_11_p4893_lanes[6] -
      Lambda_11_11_p5025_lanes * Lambda_11_11_p4991_lanes[6];
  const Lanes<8> Lambda_11_11_p5051_lanes = Lambda_11_11_p4833_lanes - Lambda_11_11_p4844_lanes *
      Lambda_11_11_p4712_lanes[7] - Lambda_11_11_p4958_lanes * Lambda_11_11_p4893_lanes[7] -
      Lambda_11_11_p5025_lanes * Lambda_11_11_p4991_lanes[7];
  const Lanes<8> Lambda_11_11_p5055_lanes = Lambda_11_11_p4937_lanes - Lambda_11_11_p4844_lanes *
      Lambda_11_11_p4724_lanes[0] - Lambda_11_11_p4958_lanes * Lambda_11_11_p4900_lanes[0] -
      Lambda_11_11_p5025_lanes * Lambda_11_11_p4995_lanes[0];
  const Lanes<8> Lambda_11_11_p5059_lanes = Lambda_11_11_p5011_lanes - Lambda_11_11_p4844_lanes *
      Lambda_11_11_p4724_lanes[1] - Lambda_11_11_p4958_lanes * Lambda_11_11_p4900_lanes[1] -
      Lambda_11_11_p5025_lanes * Lambda_11_11_p4995_lanes[1];
  const Real Lambda_0_11_p1 = Lambda_11_11_p4450_lanes[0] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4242_lanes[0] - Lambda_11_11_p4651_lanes[0] * Lambda_0_0_p1 -
      Lambda_11_11_p4844_lanes[0] * Lambda_0_0_p2 - Lambda_11_11_p4958_lanes[0] * Lambda_0_0_p3;
  const Real Lambda_11_11_p5062 = 1.0 / (Lambda_11_11_p4994 - Lambda_11_11_p5023 *
      Lambda_11_11_p4991_lanes[6]);
  const Real Lambda_0_0_p7 = Lambda_0_0_p5 - Lambda_11_11_p5023 * Lambda_0_0_p4;
  const Real Lambda_0_0_p8 = Lambda_11_11_p4232_lanes[1] * Lambda_11_11_p4330;
  const Real Lambda_0_11_p2 = Lambda_11_11_p4450_lanes[1] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4242_lanes[1] - Lambda_11_11_p4651_lanes[1] * Lambda_0_0_p1 -
      Lambda_11_11_p4844_lanes[1] * Lambda_0_0_p2 - Lambda_11_11_p4958_lanes[1] * Lambda_0_0_p3;
  const Real Lambda_0_0_p9 = Lambda_0_0_p1 * Lambda_11_11_p4531;
  const Real Lambda_0_0_p10 = Lambda_0_0_p2 * Lambda_11_11_p4747;
  const Real Lambda_11_11_p5063 = Lambda_11_11_p5029 - Lambda_11_11_p4242_lanes[2] *
      Lambda_11_11_p4143_lanes[2] - Lambda_11_11_p4450_lanes[2] * Lambda_11_11_p4322_lanes[2] -
      Lambda_11_11_p4651_lanes[2] * Lambda_11_11_p4519_lanes[2] - Lambda_11_11_p4844_lanes[2] *
      Lambda_11_11_p4724_lanes[2];
  const Real Lambda_0_11_p3 = Lambda_11_11_p4450_lanes[2] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4242_lanes[2] - Lambda_11_11_p4651_lanes[2] * Lambda_0_0_p1 -
      Lambda_11_11_p4844_lanes[2] * Lambda_0_0_p2 - Lambda_11_11_p4958_lanes[2] * Lambda_0_0_p3;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p5064 = Lambda_11_11_p4210_lanes[1] + Lambda_11_11_p2206_lanes[3] *
      Lambda_11_11_p1014_lanes[3] + Lambda_11_11_p2198_lanes[3] * Lambda_11_11_p1114_lanes[3] +
      Lambda_11_11_p2210_lanes[3] * Lambda_11_11_p1239_lanes[3] + Lambda_11_11_p2214_lanes[3] *
      Lambda_11_11_p1942_lanes[3];

  // link 1 (calf), force propagation
  const Real Lambda_0_0_p11 = Lambda_0_0_p3 * Lambda_11_11_p4922;
  const Real Lambda_0_0_p12 = Lambda_0_0_p4 * Lambda_11_11_p5014;
  const Real Lambda_1_11_p1 = Lambda_11_11_p4646_lanes[3] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4444_lanes[3];
  const Real Lambda_0_11_p4 = Lambda_11_11_p4450_lanes[3] * Lambda_11_11_p4232_lanes[1] -
      Lambda_11_11_p4242_lanes[3] - Lambda_11_11_p4651_lanes[3] * Lambda_0_0_p1 -
      Lambda_11_11_p4844_lanes[3] * Lambda_0_0_p2 - Lambda_11_11_p4958_lanes[3] * Lambda_0_0_p3;
  const Real Lambda_11_11_p5065 = Lambda_11_11_p5046 * Lambda_11_11_p5062;
  const Lanes<8> Lambda_11_11_p5066_lanes = Lambda_11_11_p5047_lanes * Lambda_11_11_p5062;
  const Real Lambda_0_0_p13 = Lambda_0_0_p7 * Lambda_11_11_p5062;
  const Real Lambda_1_11_p2 = Lambda_11_11_p4646_lanes[4] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4444_lanes[4] - Lambda_11_11_p4840_lanes[4] * Lambda_1_11_p1;
  const Real Lambda_11_11_p5081 = Lambda_11_11_p5064 + Lambda_11_11_p2318_lanes[3] *
      Lambda_11_11_p2274_lanes[3] + Lambda_11_11_p2749_lanes[3] * Lambda_11_11_p2592_lanes[3] -
      Lambda_11_11_p4242_lanes[3] * Lambda_11_11_p4143_lanes[3] - Lambda_11_11_p4450_lanes[3] *
      Lambda_11_11_p4322_lanes[3];
  const Lanes<8> Lambda_11_11_p5082_lanes = Lambda_11_11_p5051_lanes - Lambda_11_11_p5066_lanes *
      Lambda_11_11_p5046;
  const Real Lambda_1_11_p3 = Lambda_11_11_p4646_lanes[5] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4444_lanes[5] - Lambda_11_11_p4840_lanes[5] * Lambda_1_11_p1 -
      Lambda_11_11_p4955_lanes[5] * Lambda_1_11_p2;
  const Real Lambda_11_11_p5093 = 1.0 / (Lambda_11_11_p4909 - Lambda_11_11_p4955_lanes[7] *
      Lambda_11_11_p4893_lanes[7] - Lambda_11_11_p5024 * Lambda_11_11_p4991_lanes[7] -
      Lambda_11_11_p5065 * Lambda_11_11_p5046);
  const Real Lambda_0_0_p14 = Lambda_0_0_p6 - Lambda_11_11_p5024 * Lambda_0_0_p4 -
      Lambda_11_11_p5065 * Lambda_0_0_p7;
  const Real Lambda_1_11_p4 = Lambda_11_11_p4646_lanes[6] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4444_lanes[6] - Lambda_11_11_p4840_lanes[6] * Lambda_1_11_p1 -
      Lambda_11_11_p4955_lanes[6] * Lambda_1_11_p2 - Lambda_11_11_p5023 * Lambda_1_11_p3;
  const Real Lambda_1_11_p5 = Lambda_11_11_p4646_lanes[7] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4444_lanes[7] - Lambda_11_11_p4840_lanes[7] * Lambda_1_11_p1 -
      Lambda_11_11_p4955_lanes[7] * Lambda_1_11_p2 - Lambda_11_11_p5024 * Lambda_1_11_p3;
  const Real Lambda_1_11_p6 = Lambda_11_11_p4651_lanes[0] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4450_lanes[0] - Lambda_11_11_p4844_lanes[0] * Lambda_1_11_p1 -
      Lambda_11_11_p4958_lanes[0] * Lambda_1_11_p2 - Lambda_11_11_p5025_lanes[0] * Lambda_1_11_p3;
  const Real Lambda_11_11_p5094 = Lambda_11_11_p5081 - Lambda_11_11_p4651_lanes[3] *
      Lambda_11_11_p4519_lanes[3] - Lambda_11_11_p4844_lanes[3] * Lambda_11_11_p4724_lanes[3] -
      Lambda_11_11_p4958_lanes[3] * Lambda_11_11_p4900_lanes[3] - Lambda_11_11_p5025_lanes[3] *
      Lambda_11_11_p4995_lanes[3];
  const Real Lambda_0_1_p1 = Lambda_1_11_p1 * Lambda_11_11_p4747;
  const Real Lambda_1_11_p7 = Lambda_11_11_p4651_lanes[1] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4450_lanes[1] - Lambda_11_11_p4844_lanes[1] * Lambda_1_11_p1 -
      Lambda_11_11_p4958_lanes[1] * Lambda_1_11_p2 - Lambda_11_11_p5025_lanes[1] * Lambda_1_11_p3;
  const Real Lambda_0_1_p2 = Lambda_11_11_p4444_lanes[2] * Lambda_11_11_p4531;
  const Real Lambda_0_1_p3 = Lambda_1_11_p2 * Lambda_11_11_p4922;
  const Real Lambda_0_1_p4 = Lambda_1_11_p3 * Lambda_11_11_p5014;
  const Real Lambda_1_11_p8 = Lambda_1_11_p5 - Lambda_11_11_p5065 * Lambda_1_11_p4;
  const Lanes<8> Lambda_11_11_p5095_lanes = Lambda_11_11_p5082_lanes * Lambda_11_11_p5093;
  const Real Lambda_1_11_p9 = Lambda_11_11_p4651_lanes[2] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4450_lanes[2] - Lambda_11_11_p4844_lanes[2] * Lambda_1_11_p1 -
      Lambda_11_11_p4958_lanes[2] * Lambda_1_11_p2 - Lambda_11_11_p5025_lanes[2] * Lambda_1_11_p3;
  const Real Lambda_0_1_p5 = Lambda_1_11_p4 * Lambda_11_11_p5062;
  const Real Lambda_0_0_p15 = Lambda_11_11_p4183 + Lambda_0_0_p8 * Lambda_11_11_p4232_lanes[1] +
      Lambda_0_0_p9 * Lambda_0_0_p1 + Lambda_0_0_p10 * Lambda_0_0_p2 + Lambda_0_0_p11 *
      Lambda_0_0_p3;
  const Real Lambda_2_11_p1 = Lambda_11_11_p4840_lanes[4] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4646_lanes[4];
  const Real Lambda_0_0_p16 = Lambda_0_0_p14 * Lambda_11_11_p5093;
  const Lanes<8> Lambda_11_11_p5106_lanes = Lambda_11_11_p5055_lanes - Lambda_11_11_p5066_lanes *
      Lambda_11_11_p5047_lanes[0] - Lambda_11_11_p5095_lanes * Lambda_11_11_p5082_lanes[0];
  const Real Lambda_11_11_p5113 = Lambda_11_11_p5063 - Lambda_11_11_p4958_lanes[2] *
      Lambda_11_11_p4900_lanes[2] - Lambda_11_11_p5025_lanes[2] * Lambda_11_11_p4995_lanes[2] -
      Lambda_11_11_p5066_lanes[2] * Lambda_11_11_p5047_lanes[2] - Lambda_11_11_p5095_lanes[2] *
      Lambda_11_11_p5082_lanes[2];
  const Real Lambda_11_11_p5114 = Lambda_11_11_p5045 - Lambda_11_11_p4958_lanes[3] *
      Lambda_11_11_p4900_lanes[2] - Lambda_11_11_p5025_lanes[3] * Lambda_11_11_p4995_lanes[2] -
      Lambda_11_11_p5066_lanes[3] * Lambda_11_11_p5047_lanes[2] - Lambda_11_11_p5095_lanes[3] *
      Lambda_11_11_p5082_lanes[2];
  const Real Lambda_2_11_p2 = Lambda_11_11_p4840_lanes[5] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4646_lanes[5] - Lambda_11_11_p4955_lanes[5] * Lambda_2_11_p1;
  const Real Lambda_11_11_p5115 = 1.0 / Lambda_11_11_p5106_lanes[0];
  const Real Lambda_0_11_p5 = Lambda_0_11_p1 - Lambda_11_11_p5025_lanes[0] * Lambda_0_0_p4 -
      Lambda_11_11_p5066_lanes[0] * Lambda_0_0_p7 - Lambda_11_11_p5095_lanes[0] * Lambda_0_0_p14;
  const Real Lambda_1_11_p10 = Lambda_1_11_p6 - Lambda_11_11_p5066_lanes[0] * Lambda_1_11_p4 -
      Lambda_11_11_p5095_lanes[0] * Lambda_1_11_p8;
  const Real Lambda_1_11_p11 = Lambda_11_11_p4651_lanes[3] * Lambda_11_11_p4444_lanes[2] -
      Lambda_11_11_p4450_lanes[3] - Lambda_11_11_p4844_lanes[3] * Lambda_1_11_p1 -
      Lambda_11_11_p4958_lanes[3] * Lambda_1_11_p2 - Lambda_11_11_p5025_lanes[3] * Lambda_1_11_p3;
  const Real Lambda_2_11_p3 = Lambda_11_11_p4840_lanes[6] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4646_lanes[6] - Lambda_11_11_p4955_lanes[6] * Lambda_2_11_p1 -
      Lambda_11_11_p5023 * Lambda_2_11_p2;
  const Real Lambda_0_1_p6 = Lambda_1_11_p8 * Lambda_11_11_p5093;
  const Real Lambda_0_2_p1 = Lambda_11_11_p4646_lanes[3] * Lambda_11_11_p4747;
  const Real Lambda_0_2_p2 = Lambda_2_11_p1 * Lambda_11_11_p4922;
  const Real Lambda_0_2_p3 = Lambda_2_11_p2 * Lambda_11_11_p5014;
  const Real Lambda_0_2_p4 = Lambda_2_11_p3 * Lambda_11_11_p5062;
  const Lanes<8> Lambda_11_11_p5116_lanes = Lambda_11_11_p5106_lanes * Lambda_11_11_p5115;
  const Real Lambda_2_11_p4 = Lambda_11_11_p4840_lanes[7] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4646_lanes[7] - Lambda_11_11_p4955_lanes[7] * Lambda_2_11_p1 -
      Lambda_11_11_p5024 * Lambda_2_11_p2 - Lambda_11_11_p5065 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_11_11_p4844_lanes[0] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4651_lanes[0] - Lambda_11_11_p4958_lanes[0] * Lambda_2_11_p1 -
      Lambda_11_11_p5025_lanes[0] * Lambda_2_11_p2 - Lambda_11_11_p5066_lanes[0] * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_11_11_p4844_lanes[1] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4651_lanes[1] - Lambda_11_11_p4958_lanes[1] * Lambda_2_11_p1 -
      Lambda_11_11_p5025_lanes[1] * Lambda_2_11_p2 - Lambda_11_11_p5066_lanes[1] * Lambda_2_11_p3;
  const Real Lambda_2_11_p7 = Lambda_11_11_p4844_lanes[2] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4651_lanes[2] - Lambda_11_11_p4958_lanes[2] * Lambda_2_11_p1 -
      Lambda_11_11_p5025_lanes[2] * Lambda_2_11_p2 - Lambda_11_11_p5066_lanes[2] * Lambda_2_11_p3;
  const Real Lambda_3_11_p1 = Lambda_11_11_p4955_lanes[5] * Lambda_11_11_p4840_lanes[4] -
      Lambda_11_11_p4840_lanes[5];
  const Lanes<8> Lambda_11_11_p5122_lanes = Lambda_11_11_p5059_lanes - Lambda_11_11_p5066_lanes *
      Lambda_11_11_p5047_lanes[1] - Lambda_11_11_p5095_lanes * Lambda_11_11_p5082_lanes[1] -
      Lambda_11_11_p5116_lanes * Lambda_11_11_p5106_lanes[1];
  const Real Lambda_2_11_p8 = Lambda_2_11_p5 - Lambda_11_11_p5095_lanes[0] * Lambda_2_11_p4;
  const Real Lambda_0_11_p6 = Lambda_0_11_p2 - Lambda_11_11_p5025_lanes[1] * Lambda_0_0_p4 -
      Lambda_11_11_p5066_lanes[1] * Lambda_0_0_p7 - Lambda_11_11_p5095_lanes[1] * Lambda_0_0_p14 -
      Lambda_11_11_p5116_lanes[1] * Lambda_0_11_p5;
  const Real Lambda_1_11_p12 = Lambda_1_11_p7 - Lambda_11_11_p5066_lanes[1] * Lambda_1_11_p4 -
      Lambda_11_11_p5095_lanes[1] * Lambda_1_11_p8 - Lambda_11_11_p5116_lanes[1] * Lambda_1_11_p10;
  const Real Lambda_11_11_p5125 = 1.0 / Lambda_11_11_p5122_lanes[1];
  const Real Lambda_3_11_p2 = Lambda_11_11_p4955_lanes[6] * Lambda_11_11_p4840_lanes[4] -
      Lambda_11_11_p4840_lanes[6] - Lambda_11_11_p5023 * Lambda_3_11_p1;
  const Real Lambda_2_11_p9 = Lambda_11_11_p4844_lanes[3] * Lambda_11_11_p4646_lanes[3] -
      Lambda_11_11_p4651_lanes[3] - Lambda_11_11_p4958_lanes[3] * Lambda_2_11_p1 -
      Lambda_11_11_p5025_lanes[3] * Lambda_2_11_p2 - Lambda_11_11_p5066_lanes[3] * Lambda_2_11_p3;
  const Real Lambda_2_11_p10 = Lambda_2_11_p6 - Lambda_11_11_p5095_lanes[1] * Lambda_2_11_p4 -
      Lambda_11_11_p5116_lanes[1] * Lambda_2_11_p8;
  const Real Lambda_0_3_p1 = Lambda_3_11_p2 * Lambda_11_11_p5062;
  const Real Lambda_0_11_p7 = Lambda_0_11_p3 - Lambda_11_11_p5025_lanes[2] * Lambda_0_0_p4 -
      Lambda_11_11_p5066_lanes[2] * Lambda_0_0_p7 - Lambda_11_11_p5095_lanes[2] * Lambda_0_0_p14 -
      Lambda_11_11_p5116_lanes[2] * Lambda_0_11_p5;
  const Real Lambda_0_3_p2 = Lambda_3_11_p1 * Lambda_11_11_p5014;
  const Real Lambda_0_3_p3 = Lambda_11_11_p4840_lanes[4] * Lambda_11_11_p4922;
  const Real Lambda_3_11_p3 = Lambda_11_11_p4955_lanes[7] * Lambda_11_11_p4840_lanes[4] -
      Lambda_11_11_p4840_lanes[7] - Lambda_11_11_p5024 * Lambda_3_11_p1 - Lambda_11_11_p5065 *
      Lambda_3_11_p2;
  const Real Lambda_0_2_p5 = Lambda_2_11_p4 * Lambda_11_11_p5093;
  const Real Lambda_0_3_p4 = Lambda_3_11_p3 * Lambda_11_11_p5093;
  const Real Lambda_11_11_p5126 = Lambda_11_11_p5122_lanes[2] * Lambda_11_11_p5125;
  const Real Lambda_4_11_p1 = Lambda_11_11_p5023 * Lambda_11_11_p4955_lanes[5] -
      Lambda_11_11_p4955_lanes[6];
  const Real Lambda_11_11_p5127 = Lambda_11_11_p5122_lanes[3] * Lambda_11_11_p5125;
  const Real Lambda_3_11_p4 = Lambda_11_11_p4958_lanes[0] * Lambda_11_11_p4840_lanes[4] -
      Lambda_11_11_p4844_lanes[0] - Lambda_11_11_p5025_lanes[0] * Lambda_3_11_p1 -
      Lambda_11_11_p5066_lanes[0] * Lambda_3_11_p2 - Lambda_11_11_p5095_lanes[0] * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_11_11_p4958_lanes[1] * Lambda_11_11_p4840_lanes[4] -
      Lambda_11_11_p4844_lanes[1] - Lambda_11_11_p5025_lanes[1] * Lambda_3_11_p1 -
      Lambda_11_11_p5066_lanes[1] * Lambda_3_11_p2 - Lambda_11_11_p5095_lanes[1] * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_11_11_p4958_lanes[2] * Lambda_11_11_p4840_lanes[4] -
      Lambda_11_11_p4844_lanes[2] - Lambda_11_11_p5025_lanes[2] * Lambda_3_11_p1 -
      Lambda_11_11_p5066_lanes[2] * Lambda_3_11_p2 - Lambda_11_11_p5095_lanes[2] * Lambda_3_11_p3;
  const Real Lambda_3_11_p7 = Lambda_11_11_p4958_lanes[3] * Lambda_11_11_p4840_lanes[4] -
      Lambda_11_11_p4844_lanes[3] - Lambda_11_11_p5025_lanes[3] * Lambda_3_11_p1 -
      Lambda_11_11_p5066_lanes[3] * Lambda_3_11_p2 - Lambda_11_11_p5095_lanes[3] * Lambda_3_11_p3;
  const Real Lambda_4_11_p2 = Lambda_11_11_p5024 * Lambda_11_11_p4955_lanes[5] -
      Lambda_11_11_p4955_lanes[7] - Lambda_11_11_p5065 * Lambda_4_11_p1;
  const Real Lambda_11_11_p5128 = Lambda_11_11_p5114 - Lambda_11_11_p5116_lanes[3] *
      Lambda_11_11_p5106_lanes[2] - Lambda_11_11_p5127 * Lambda_11_11_p5122_lanes[2];
  const Real Lambda_11_11_p5129 = Lambda_11_11_p5094 - Lambda_11_11_p5066_lanes[3] *
      Lambda_11_11_p5047_lanes[3] - Lambda_11_11_p5095_lanes[3] * Lambda_11_11_p5082_lanes[3] -
      Lambda_11_11_p5116_lanes[3] * Lambda_11_11_p5106_lanes[3] - Lambda_11_11_p5127 *
      Lambda_11_11_p5122_lanes[3];
  const Real Lambda_0_4_p1 = Lambda_11_11_p4955_lanes[5] * Lambda_11_11_p5014;
  const Real Lambda_3_11_p8 = Lambda_3_11_p5 - Lambda_11_11_p5116_lanes[1] * Lambda_3_11_p4;
  const Real Lambda_11_11_p5130 = 1.0 / (Lambda_11_11_p5113 - Lambda_11_11_p5116_lanes[2] *
      Lambda_11_11_p5106_lanes[2] - Lambda_11_11_p5126 * Lambda_11_11_p5122_lanes[2]);
  const Real Lambda_0_4_p2 = Lambda_4_11_p1 * Lambda_11_11_p5062;
  const Real Lambda_0_4_p3 = Lambda_4_11_p2 * Lambda_11_11_p5093;
  const Real Lambda_0_11_p8 = Lambda_0_11_p7 - Lambda_11_11_p5126 * Lambda_0_11_p6;
  const Real Lambda_4_11_p3 = Lambda_11_11_p5025_lanes[0] * Lambda_11_11_p4955_lanes[5] -
      Lambda_11_11_p4958_lanes[0] - Lambda_11_11_p5066_lanes[0] * Lambda_4_11_p1 -
      Lambda_11_11_p5095_lanes[0] * Lambda_4_11_p2;
  const Real Lambda_1_11_p13 = Lambda_1_11_p9 - Lambda_11_11_p5066_lanes[2] * Lambda_1_11_p4 -
      Lambda_11_11_p5095_lanes[2] * Lambda_1_11_p8 - Lambda_11_11_p5116_lanes[2] * Lambda_1_11_p10 -
      Lambda_11_11_p5126 * Lambda_1_11_p12;
  const Real Lambda_5_11_p1 = Lambda_11_11_p5065 * Lambda_11_11_p5023 - Lambda_11_11_p5024;
  const Real Lambda_0_1_p7 = Lambda_0_1_p1 * Lambda_0_0_p2 -
      (Lambda_0_0_p8 + Lambda_0_1_p2 * Lambda_0_0_p1) + Lambda_0_1_p3 * Lambda_0_0_p3 +
      Lambda_0_1_p4 * Lambda_0_0_p4;
  const Real Lambda_2_11_p11 = Lambda_2_11_p7 - Lambda_11_11_p5095_lanes[2] * Lambda_2_11_p4 -
      Lambda_11_11_p5116_lanes[2] * Lambda_2_11_p8 - Lambda_11_11_p5126 * Lambda_2_11_p10;
  const Real Lambda_3_11_p9 = Lambda_3_11_p6 - Lambda_11_11_p5116_lanes[2] * Lambda_3_11_p4 -
      Lambda_11_11_p5126 * Lambda_3_11_p8;
  const Real Lambda_4_11_p4 = Lambda_11_11_p5025_lanes[1] * Lambda_11_11_p4955_lanes[5] -
      Lambda_11_11_p4958_lanes[1] - Lambda_11_11_p5066_lanes[1] * Lambda_4_11_p1 -
      Lambda_11_11_p5095_lanes[1] * Lambda_4_11_p2 - Lambda_11_11_p5116_lanes[1] * Lambda_4_11_p3;
  const Real Lambda_4_11_p5 = Lambda_11_11_p5025_lanes[2] * Lambda_11_11_p4955_lanes[5] -
      Lambda_11_11_p4958_lanes[2] - Lambda_11_11_p5066_lanes[2] * Lambda_4_11_p1 -
      Lambda_11_11_p5095_lanes[2] * Lambda_4_11_p2 - Lambda_11_11_p5116_lanes[2] * Lambda_4_11_p3;
  const Real Lambda_0_5_p1 = Lambda_11_11_p5023 * Lambda_11_11_p5062;
  const Real Lambda_5_11_p2 = Lambda_11_11_p5066_lanes[0] * Lambda_11_11_p5023 -
      Lambda_11_11_p5025_lanes[0] - Lambda_11_11_p5095_lanes[0] * Lambda_5_11_p1;
  const Real Lambda_0_5_p2 = Lambda_5_11_p1 * Lambda_11_11_p5093;
  const Real Lambda_0_11_p9 = Lambda_0_11_p4 - Lambda_11_11_p5025_lanes[3] * Lambda_0_0_p4 -
      Lambda_11_11_p5066_lanes[3] * Lambda_0_0_p7 - Lambda_11_11_p5095_lanes[3] * Lambda_0_0_p14 -
      Lambda_11_11_p5116_lanes[3] * Lambda_0_11_p5;
  const Real Lambda_0_0_p17 = Lambda_0_11_p5 * Lambda_11_11_p5115;
  const Real Lambda_11_11_p5131 = Lambda_11_11_p5128 * Lambda_11_11_p5130;
  const Real Lambda_0_1_p8 = Lambda_1_11_p10 * Lambda_11_11_p5115;
  const Real Lambda_6_11_p1 = Lambda_11_11_p5095_lanes[0] * Lambda_11_11_p5065 -
      Lambda_11_11_p5066_lanes[0];
  const Real Lambda_0_2_p6 = Lambda_2_11_p8 * Lambda_11_11_p5115;
  const Real Lambda_4_11_p6 = Lambda_4_11_p5 - Lambda_11_11_p5126 * Lambda_4_11_p4;
  const Real Lambda_0_3_p5 = Lambda_3_11_p4 * Lambda_11_11_p5115;
  const Real Lambda_5_11_p3 = Lambda_11_11_p5066_lanes[1] * Lambda_11_11_p5023 -
      Lambda_11_11_p5025_lanes[1] - Lambda_11_11_p5095_lanes[1] * Lambda_5_11_p1 -
      Lambda_11_11_p5116_lanes[1] * Lambda_5_11_p2;
  const Real Lambda_4_11_p7 = Lambda_11_11_p5025_lanes[3] * Lambda_11_11_p4955_lanes[5] -
      Lambda_11_11_p4958_lanes[3] - Lambda_11_11_p5066_lanes[3] * Lambda_4_11_p1 -
      Lambda_11_11_p5095_lanes[3] * Lambda_4_11_p2 - Lambda_11_11_p5116_lanes[3] * Lambda_4_11_p3;
  const Real Lambda_0_6_p1 = Lambda_11_11_p5065 * Lambda_11_11_p5093;
  const Real Lambda_0_4_p4 = Lambda_4_11_p3 * Lambda_11_11_p5115;
  const Real Lambda_0_5_p3 = Lambda_5_11_p2 * Lambda_11_11_p5115;
  const Real Lambda_0_6_p2 = Lambda_6_11_p1 * Lambda_11_11_p5115;
  const Real Lambda_6_11_p2 = Lambda_11_11_p5095_lanes[1] * Lambda_11_11_p5065 -
      Lambda_11_11_p5066_lanes[1] - Lambda_11_11_p5116_lanes[1] * Lambda_6_11_p1;
  const Real Lambda_11_11 = 1.0 / (Lambda_11_11_p5129 - Lambda_11_11_p5131 * Lambda_11_11_p5128);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_7_11_p1 = Lambda_11_11_p5116_lanes[1] * Lambda_11_11_p5095_lanes[0] -
      Lambda_11_11_p5095_lanes[1];
  const Real Lambda_5_11_p4 = Lambda_11_11_p5066_lanes[2] * Lambda_11_11_p5023 -
      Lambda_11_11_p5025_lanes[2] - Lambda_11_11_p5095_lanes[2] * Lambda_5_11_p1 -
      Lambda_11_11_p5116_lanes[2] * Lambda_5_11_p2 - Lambda_11_11_p5126 * Lambda_5_11_p3;
  const Real Lambda_0_7_p1 = Lambda_11_11_p5095_lanes[0] * Lambda_11_11_p5115;
  const Real Lambda_0_2_p7 = Lambda_0_0_p9 - Lambda_0_2_p1 * Lambda_0_0_p2 + Lambda_0_2_p2 *
      Lambda_0_0_p3 + Lambda_0_2_p3 * Lambda_0_0_p4 + Lambda_0_2_p4 * Lambda_0_0_p7;
  const Real Lambda_6_11_p3 = Lambda_11_11_p5095_lanes[2] * Lambda_11_11_p5065 -
      Lambda_11_11_p5066_lanes[2] - Lambda_11_11_p5116_lanes[2] * Lambda_6_11_p1 -
      Lambda_11_11_p5126 * Lambda_6_11_p2;
  const Real Lambda_8_11_p1 = Lambda_11_11_p5126 * Lambda_11_11_p5116_lanes[1] -
      Lambda_11_11_p5116_lanes[2];
  const Real Lambda_7_11_p2 = Lambda_11_11_p5116_lanes[2] * Lambda_11_11_p5095_lanes[0] -
      Lambda_11_11_p5095_lanes[2] - Lambda_11_11_p5126 * Lambda_7_11_p1;
  const Real Lambda_0_0_p18 = Lambda_0_11_p6 * Lambda_11_11_p5125;
  const Real Lambda_1_11_p14 = Lambda_1_11_p11 - Lambda_11_11_p5066_lanes[3] * Lambda_1_11_p4 -
      Lambda_11_11_p5095_lanes[3] * Lambda_1_11_p8 - Lambda_11_11_p5116_lanes[3] * Lambda_1_11_p10 -
      Lambda_11_11_p5127 * Lambda_1_11_p12;
  const Real Lambda_0_1_p9 = Lambda_1_11_p12 * Lambda_11_11_p5125;
  const Real Lambda_0_2_p8 = Lambda_2_11_p10 * Lambda_11_11_p5125;
  const Real Lambda_0_3_p6 = Lambda_3_11_p8 * Lambda_11_11_p5125;
  const Real Lambda_0_4_p5 = Lambda_4_11_p4 * Lambda_11_11_p5125;
  const Real Lambda_5_11_p5 = Lambda_11_11_p5066_lanes[3] * Lambda_11_11_p5023 -
      Lambda_11_11_p5025_lanes[3] - Lambda_11_11_p5095_lanes[3] * Lambda_5_11_p1 -
      Lambda_11_11_p5116_lanes[3] * Lambda_5_11_p2 - Lambda_11_11_p5127 * Lambda_5_11_p3;
  const Real Lambda_0_5_p4 = Lambda_5_11_p3 * Lambda_11_11_p5125;
  const Real Lambda_0_6_p3 = Lambda_6_11_p2 * Lambda_11_11_p5125;
  const Real Lambda_0_7_p2 = Lambda_7_11_p1 * Lambda_11_11_p5125;
  const Real Lambda_0_8_p1 = Lambda_11_11_p5116_lanes[1] * Lambda_11_11_p5125;
  const Real Lambda_0_3_p7 = Lambda_0_0_p10 - Lambda_0_3_p3 * Lambda_0_0_p3 + Lambda_0_3_p2 *
      Lambda_0_0_p4 + Lambda_0_3_p1 * Lambda_0_0_p7 + Lambda_0_3_p4 * Lambda_0_0_p14;
  const Real Lambda_0_11_p10 = Lambda_0_11_p9 - Lambda_11_11_p5127 * Lambda_0_11_p6 -
      Lambda_11_11_p5131 * Lambda_0_11_p8;
  const Real Lambda_0_0_p19 = Lambda_0_11_p8 * Lambda_11_11_p5130;
  const Real Lambda_1_11_p15 = Lambda_1_11_p14 - Lambda_11_11_p5131 * Lambda_1_11_p13;
  const Real Lambda_0_1_p10 = Lambda_1_11_p13 * Lambda_11_11_p5130;
  const Real Lambda_2_11_p12 = Lambda_2_11_p9 - Lambda_11_11_p5095_lanes[3] * Lambda_2_11_p4 -
      Lambda_11_11_p5116_lanes[3] * Lambda_2_11_p8 - Lambda_11_11_p5127 * Lambda_2_11_p10 -
      Lambda_11_11_p5131 * Lambda_2_11_p11;
  const Real Lambda_1_1_p1 = Lambda_11_11_p4330 + Lambda_0_1_p2 * Lambda_11_11_p4444_lanes[2] +
      Lambda_0_1_p1 * Lambda_1_11_p1 + Lambda_0_1_p3 * Lambda_1_11_p2 + Lambda_0_1_p4 *
      Lambda_1_11_p3;
  const Real Lambda_0_2_p9 = Lambda_2_11_p11 * Lambda_11_11_p5130;
  const Real Lambda_3_11_p10 = Lambda_3_11_p7 - Lambda_11_11_p5116_lanes[3] * Lambda_3_11_p4 -
      Lambda_11_11_p5127 * Lambda_3_11_p8 - Lambda_11_11_p5131 * Lambda_3_11_p9;
  const Real Lambda_0_3_p8 = Lambda_3_11_p9 * Lambda_11_11_p5130;
  const Real Lambda_4_11_p8 = Lambda_4_11_p7 - Lambda_11_11_p5127 * Lambda_4_11_p4 -
      Lambda_11_11_p5131 * Lambda_4_11_p6;
  const Real Lambda_0_4_p6 = Lambda_4_11_p6 * Lambda_11_11_p5130;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_11_11_p5131 * Lambda_5_11_p4;
  const Real Lambda_0_5_p5 = Lambda_5_11_p4 * Lambda_11_11_p5130;
  const Real Lambda_6_11_p4 = Lambda_11_11_p5095_lanes[3] * Lambda_11_11_p5065 -
      Lambda_11_11_p5066_lanes[3] - Lambda_11_11_p5116_lanes[3] * Lambda_6_11_p1 -
      Lambda_11_11_p5127 * Lambda_6_11_p2 - Lambda_11_11_p5131 * Lambda_6_11_p3;
  const Real Lambda_0_6_p4 = Lambda_6_11_p3 * Lambda_11_11_p5130;
  const Real Lambda_7_11_p3 = Lambda_11_11_p5116_lanes[3] * Lambda_11_11_p5095_lanes[0] -
      Lambda_11_11_p5095_lanes[3] - Lambda_11_11_p5127 * Lambda_7_11_p1 - Lambda_11_11_p5131 *
      Lambda_7_11_p2;
  const Real Lambda_1_2_p1 = Lambda_0_2_p2 * Lambda_1_11_p2 -
      (Lambda_0_1_p2 + Lambda_0_2_p1 * Lambda_1_11_p1) + Lambda_0_2_p3 * Lambda_1_11_p3 +
      Lambda_0_2_p4 * Lambda_1_11_p4;
  const Real Lambda_0_7_p3 = Lambda_7_11_p2 * Lambda_11_11_p5130;
  const Real Lambda_8_11_p2 = Lambda_11_11_p5127 * Lambda_11_11_p5116_lanes[1] -
      Lambda_11_11_p5116_lanes[3] - Lambda_11_11_p5131 * Lambda_8_11_p1;
  const Real Lambda_0_8_p2 = Lambda_8_11_p1 * Lambda_11_11_p5130;
  const Real Lambda_9_11_p1 = Lambda_11_11_p5131 * Lambda_11_11_p5126 - Lambda_11_11_p5127;
  const Real Lambda_0_9_p1 = Lambda_11_11_p5126 * Lambda_11_11_p5130;
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
  const Real Lambda_2_2_p1 = Lambda_11_11_p4531 + Lambda_0_2_p1 * Lambda_11_11_p4646_lanes[3] +
      Lambda_0_2_p2 * Lambda_2_11_p1 + Lambda_0_2_p3 * Lambda_2_11_p2 + Lambda_0_2_p4 *
      Lambda_2_11_p3;
  const Real Lambda_10_11 = Lambda_11_11_p5131 * Lambda_11_11;
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
  const Real Lambda_3_3_p1 = Lambda_11_11_p4747 + Lambda_0_3_p3 * Lambda_11_11_p4840_lanes[4] +
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
  const Real Lambda_4_4_p1 = Lambda_11_11_p4922 + Lambda_0_4_p1 * Lambda_11_11_p4955_lanes[5] +
      Lambda_0_4_p2 * Lambda_4_11_p1 + Lambda_0_4_p3 * Lambda_4_11_p2 + Lambda_0_4_p4 *
      Lambda_4_11_p3;
  const Real Lambda_4_5_p1 = Lambda_0_5_p2 * Lambda_4_11_p2 -
      (Lambda_0_4_p1 + Lambda_0_5_p1 * Lambda_4_11_p1) + Lambda_0_5_p3 * Lambda_4_11_p3 +
      Lambda_0_5_p4 * Lambda_4_11_p4;
  const Real Lambda_5_5_p1 = Lambda_11_11_p5014 + Lambda_0_5_p1 * Lambda_11_11_p5023 +
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
  const Real Lambda_6_6_p1 = Lambda_11_11_p5062 + Lambda_0_6_p1 * Lambda_11_11_p5065 +
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
  Lambda[91] = Lambda_11_11_p5093 + Lambda_0_7_p1 * Lambda_11_11_p5095_lanes[0] + Lambda_0_7_p2 *
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
  Lambda[104] = Lambda_11_11_p5115 + Lambda_0_8_p1 * Lambda_11_11_p5116_lanes[1] + Lambda_0_8_p2 *
      Lambda_8_11_p1 + Lambda_8_11 * Lambda_8_11_p2;
  const Real Lambda_8_9 = Lambda_9_11 * Lambda_8_11_p2 -
      (Lambda_0_8_p1 + Lambda_0_9_p1 * Lambda_8_11_p1);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p2 - Lambda_10_11 * Lambda_8_11_p2;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = Lambda_11_11_p5125 + Lambda_0_9_p1 * Lambda_11_11_p5126 + Lambda_9_11 *
      Lambda_9_11_p1;
  const Real Lambda_9_10 = Lambda_0_9_p1 + Lambda_10_11 * Lambda_9_11_p1;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_11_11_p5130 + Lambda_10_11 * Lambda_11_11_p5131;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
