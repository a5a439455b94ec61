// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins, alike limbs in lanes.
// 8953 flops (add 3944, mul 4965, div 44), sine and cosine of 24 angles
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
void control_torque(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT qdd_0)[24], const Real (&TREELINE_RESTRICT xdd_cmd)[12],
    Real (&TREELINE_RESTRICT tau)[24]) noexcept {
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], q[19], q[11], q[12], q[10], q[9], q[8], q[7], q[6]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real s1 = sines[0];
  const Real c2 = cosines[1];
  const Real s2 = sines[1];
  const Real c3 = cosines[2];
  const Real s3 = sines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];
  const Real s21 = sines[6];
  const Real c21 = cosines[6];
  const Real s22 = sines[7];
  const Real c22 = cosines[7];
  const Real c24 = cosines[8];
  const Real s24 = sines[8];
  const Real c23 = cosines[9];
  const Real s23 = sines[9];
  const Real s14 = sines[10];
  const Real c14 = cosines[10];
  const Real c15 = cosines[11];
  const Real s15 = sines[11];
  const Real c16 = cosines[12];
  const Real s16 = sines[12];
  const Real c17 = cosines[13];
  const Real s17 = sines[13];
  const Real s18 = sines[14];
  const Real c18 = cosines[14];
  const Real s19 = sines[15];
  const Real c19 = cosines[15];
  const Real c20 = cosines[16];
  const Real s20 = sines[16];
  const Real s12 = sines[17];
  const Real c12 = cosines[17];
  const Real s13 = sines[18];
  const Real c13 = cosines[18];
  const Real s11 = sines[19];
  const Real c11 = cosines[19];
  const Real s10 = sines[20];
  const Real c10 = cosines[20];
  const Real c9 = cosines[21];
  const Real s9 = sines[21];
  const Real s8 = sines[22];
  const Real c8 = cosines[22];
  const Real c7 = cosines[23];
  const Real s7 = sines[23];

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D12_p3_lanes = detail::make_pack<Real>((-0.0007660844555829042),
      (-0.0007660844555829042)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.0002628975791811551, (-0.0002628975791811551)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p7_lanes = detail::make_pack<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.001742099791326752, 0.001742099791326752) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p4_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D10_p11_lanes = detail::make_pack<Real>(c13, c20) * inverse_D10_p7_lanes;
  const Lanes<2> inverse_D10_p12_lanes = detail::make_pack<Real>(s13, s20) * inverse_D10_p7_lanes;
  const Lanes<2> inverse_D10_p13_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(s13, s20) - 0.01626499875 *
      detail::make_pack<Real>(c13, c20) - 0.0006000000000000001;
  const Lanes<2> inverse_D11_p2_lanes = detail::make_pack<Real>((-0.00013384878959057754),
      0.00013384878959057754) + detail::make_pack<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D10_p16_lanes = 0.0006340258712020409 + inverse_D10_p11_lanes;
  const Lanes<2> inverse_D10_p17_lanes = inverse_D10_p12_lanes -
      detail::make_pack<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (inverse_D12_p4_lanes -
      detail::make_pack<Real>((-0.0010519177038056625), (-0.0010519177038056625)));

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D10_p20_lanes = detail::make_pack<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.27310176737964387), (-0.27310176737964387)) *
      detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D11_p4_lanes = inverse_D11_p2_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p23_lanes = inverse_D10_p16_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p24_lanes = inverse_D10_p13_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p25_lanes = inverse_D10_p17_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p30_lanes = inverse_D10_p13_lanes * inverse_D10_p25_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D10_p32_lanes = detail::make_pack<Real>(s13, s20) * inverse_D10_p20_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D11_p6_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes -
      inverse_D11_p2_lanes * inverse_D11_p4_lanes;
  const Lanes<2> inverse_D10_p33_lanes = detail::make_pack<Real>((-0.00033044389597753786),
      0.00033044389597753786) + inverse_D10_p12_lanes + inverse_D11_p2_lanes *
      inverse_D10_p23_lanes;
  const Lanes<2> inverse_D10_p34_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(c13, c20) + 0.01626499875 *
      detail::make_pack<Real>(s13, s20) - inverse_D11_p2_lanes * inverse_D10_p24_lanes;
  const Lanes<2> inverse_D10_p35_lanes = inverse_D10_p11_lanes -
      detail::make_pack<Real>(0.002376125662528793, 0.002376125662528793) - inverse_D11_p2_lanes *
      inverse_D10_p25_lanes;
  const Lanes<2> inverse_D10_p37_lanes = inverse_D10_p13_lanes * inverse_D10_p23_lanes;
  const Lanes<2> inverse_D10_p38_lanes = inverse_D10_p13_lanes * inverse_D10_p24_lanes;
  const Lanes<2> inverse_D10_p39_lanes = detail::make_pack<Real>(c13, c20) * inverse_D10_p20_lanes -
      detail::make_pack<Real>((-0.04964593582762564), 0.04964593582762564) - inverse_D10_p16_lanes *
      inverse_D10_p25_lanes;
  const Lanes<2> inverse_D10_p44_lanes = detail::make_pack<Real>(0.008744893195371809,
      0.008744893195371809) + inverse_D10_p32_lanes + inverse_D10_p16_lanes * inverse_D10_p23_lanes;
  const Lanes<2> inverse_D11_p8_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p6_lanes);
  const Lanes<2> inverse_D10_p52_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p33_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p34_lanes;
  const Lanes<2> inverse_D10_p53_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p35_lanes;
  const Lanes<2> inverse_D10_p54_lanes = inverse_D10_p32_lanes - 0.2818466605750157 -
      inverse_D10_p17_lanes * inverse_D10_p25_lanes;
  const Lanes<2> inverse_D10_p55_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p30_lanes +
      detail::make_pack<Real>(s12, s19) * inverse_D10_p39_lanes;
  const Lanes<2> inverse_D10_p57_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p35_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> inverse_D11_p9_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p8_lanes;
  const Lanes<2> inverse_D10_p59_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p52_lanes;
  const Lanes<2> inverse_D10_p63_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p52_lanes;
  const Lanes<2> inverse_D10_p64_lanes = 0.269 * inverse_D10_p55_lanes;
  const Lanes<2> inverse_D8_p1_lanes = 6e-04 - inverse_D10_p53_lanes;
  const Lanes<2> inverse_D10_p65_lanes = detail::make_pack<Real>(c12, c19) *
      (2.0 * inverse_D10_p37_lanes) - detail::make_pack<Real>(s12, s19) *
      (inverse_D10_p44_lanes - inverse_D10_p38_lanes);
  const Lanes<2> inverse_D10_p69_lanes = 0.269 * inverse_D10_p54_lanes - inverse_D10_p57_lanes;
  const Lanes<2> inverse_D10_p70_lanes = inverse_D10_p63_lanes + inverse_D10_p64_lanes;
  const Lanes<2> inverse_D8_p2_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      inverse_D10_p59_lanes;
  const Lanes<2> inverse_D10_p71_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p65_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p72_lanes = 2.0 * detail::make_pack<Real>(c11, c18);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p73_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p8_lanes + 0.269 * inverse_D10_p53_lanes);
  const Lanes<2> inverse_D10_p74_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      inverse_D10_p59_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p6_lanes + inverse_D11_p9_lanes));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p77_lanes = inverse_D10_p71_lanes - inverse_D10_p38_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p83_lanes = inverse_D10_p73_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p84_lanes = inverse_D10_p74_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p4_lanes = inverse_D8_p2_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p5_lanes = inverse_D8_p1_lanes * inverse_D11_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p1_lanes = 2.0 * detail::make_pack<Real>(c10, c17);

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p88_lanes = 0.000131 - inverse_D11_p9_lanes + 0.269 *
      (inverse_D10_p69_lanes - inverse_D10_p57_lanes) - inverse_D10_p73_lanes *
      inverse_D10_p83_lanes;
  const Lanes<2> inverse_D10_p89_lanes = 0.0001098 + 0.07236100000000001 * inverse_D10_p77_lanes -
      inverse_D10_p74_lanes * inverse_D10_p84_lanes;
  const Lanes<2> inverse_D10_p90_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      inverse_D10_p70_lanes - inverse_D10_p73_lanes * inverse_D10_p84_lanes;
  const Lanes<2> inverse_D8_p10_lanes = inverse_D10_p73_lanes * inverse_D8_p4_lanes -
      inverse_D10_p70_lanes;
  const Lanes<2> inverse_D8_p11_lanes = inverse_D10_p64_lanes - inverse_D10_p74_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D8_p12_lanes = inverse_D10_p74_lanes * inverse_D8_p4_lanes - 0.269 *
      inverse_D10_p77_lanes;
  const Lanes<2> inverse_D8_p13_lanes = inverse_D10_p69_lanes - inverse_D10_p73_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D10_p94_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p88_lanes - inverse_D10_p89_lanes) + inverse_D10_p72_lanes *
      inverse_D10_p90_lanes;
  const Lanes<2> inverse_D8_p18_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p10_lanes - inverse_D8_p11_lanes) + detail::make_pack<Real>(c11, c18) *
      (inverse_D8_p12_lanes + inverse_D8_p13_lanes);
  const Lanes<2> inverse_D10_p95_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p94_lanes;
  const Lanes<2> inverse_D8_p19_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p20_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p21_lanes = inverse_D8_p11_lanes + inverse_D8_p20_lanes;
  const Lanes<2> inverse_D10_p97_lanes = 0.060888541114265754 +
      (inverse_D10_p89_lanes + inverse_D10_p95_lanes);
  const Lanes<2> inverse_D9_p5_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p94_lanes -
      inverse_D10_p90_lanes);
  const Lanes<2> inverse_D8_p27_lanes = inverse_D10_p77_lanes - inverse_D8_p2_lanes *
      inverse_D8_p4_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p97_lanes;
  const Lanes<2> inverse_D9_p7_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p97_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p28_lanes = inverse_D10_p54_lanes - inverse_D8_p1_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D8_p29_lanes = inverse_D8_p2_lanes * inverse_D8_p5_lanes -
      inverse_D10_p55_lanes;
  const Lanes<2> inverse_D8_p33_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p27_lanes - inverse_D8_p28_lanes) + inverse_D10_p72_lanes * inverse_D8_p29_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p9_lanes = inverse_D9_p5_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p11_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p97_lanes;
  const Lanes<2> inverse_D8_p34_lanes = inverse_D8_p21_lanes * inverse_D10_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p35_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p33_lanes;
  const Lanes<2> inverse_D8_p37_lanes = inverse_D8_p19_lanes - inverse_D8_p13_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p13_lanes = 0.0001499998887063 + inverse_D9_p5_lanes *
      inverse_D9_p7_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p44_lanes = inverse_D10_p63_lanes - inverse_D10_p33_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p46_lanes = inverse_D8_p37_lanes * inverse_D10_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p47_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p30_lanes -
      detail::make_pack<Real>(c12, c19) * inverse_D10_p39_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p14_lanes = 0.06060754126741261 +
      (inverse_D10_p88_lanes - inverse_D10_p95_lanes) - inverse_D9_p5_lanes * inverse_D9_p9_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p49_lanes = inverse_D8_p44_lanes * inverse_D11_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p50_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * inverse_D8_p34_lanes;
  const Lanes<2> inverse_D8_p51_lanes = 0.28049749700000004 +
      (inverse_D8_p19_lanes - inverse_D8_p12_lanes) - inverse_D9_p5_lanes * inverse_D8_p34_lanes;
  const Lanes<2> inverse_D8_p52_lanes = inverse_D8_p28_lanes + inverse_D8_p35_lanes -
      inverse_D8_p21_lanes * inverse_D8_p34_lanes;
  const Lanes<2> inverse_D8_p54_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p46_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p55_lanes = inverse_D10_p37_lanes - detail::make_pack<Real>(c12, c19) *
      inverse_D10_p65_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p67_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p50_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p51_lanes;
  const Lanes<2> inverse_D8_p68_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p51_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p50_lanes;
  const Lanes<2> inverse_D8_p70_lanes = inverse_D8_p10_lanes - inverse_D8_p20_lanes -
      inverse_D9_p5_lanes * inverse_D8_p46_lanes;
  const Lanes<2> inverse_D9_p18_lanes = inverse_D9_p1_lanes * inverse_D9_p13_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D9_p14_lanes - inverse_D9_p11_lanes);
  const Lanes<2> inverse_D8_p73_lanes = inverse_D8_p68_lanes + 0.282 * inverse_D8_p52_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p74_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      (0.269 * inverse_D8_p47_lanes - (inverse_D10_p59_lanes - inverse_D10_p34_lanes)) -
      inverse_D10_p73_lanes * inverse_D8_p49_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p19_lanes = detail::make_pack<Real>(s10, s17) * inverse_D9_p18_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p77_lanes = 0.269 * inverse_D8_p55_lanes - 6e-04 -
      inverse_D10_p74_lanes * inverse_D8_p49_lanes;
  const Lanes<2> inverse_D8_p84_lanes = inverse_D8_p2_lanes * inverse_D8_p49_lanes -
      inverse_D8_p55_lanes;
  const Lanes<2> inverse_D8_p86_lanes = inverse_D8_p47_lanes - inverse_D8_p1_lanes *
      inverse_D8_p49_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p97_lanes = inverse_D8_p27_lanes - inverse_D8_p35_lanes -
      inverse_D8_p37_lanes * inverse_D8_p46_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p101_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * inverse_D8_p74_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p77_lanes);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (inverse_D9_p11_lanes - inverse_D9_p19_lanes));

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p105_lanes = 0.282 * inverse_D8_p67_lanes -
      (inverse_D9_p13_lanes - detail::make_pack<Real>(c10, c17) * inverse_D9_p18_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D8_p109_lanes = inverse_D8_p101_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p114_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p109_lanes;
  const Lanes<2> inverse_D8_p117_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p33_lanes -
      inverse_D8_p29_lanes - inverse_D8_p37_lanes * inverse_D8_p34_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p118_lanes = 2.0 * detail::make_pack<Real>(s9, s16);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p119_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p84_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p86_lanes + inverse_D8_p101_lanes *
      inverse_D8_p34_lanes;
  const Lanes<2> inverse_D8_p120_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p74_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p77_lanes + inverse_D9_p5_lanes *
      inverse_D8_p109_lanes;
  const Lanes<2> inverse_D8_p122_lanes = inverse_D10_p44_lanes + inverse_D10_p71_lanes +
      inverse_D8_p44_lanes * inverse_D8_p49_lanes + inverse_D8_p101_lanes * inverse_D8_p109_lanes;
  const Lanes<2> inverse_D8_p123_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p84_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p86_lanes + inverse_D8_p37_lanes *
      inverse_D8_p109_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p130_lanes = inverse_D8_p105_lanes * inverse_D9_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p131_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p117_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p119_lanes;
  const Lanes<2> inverse_D8_p134_lanes = 0.282 * inverse_D8_p131_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p135_lanes = inverse_D8_p105_lanes * inverse_D8_p130_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D6_p5_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p119_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p117_lanes;
  const Lanes<2> inverse_D8_p136_lanes = detail::make_pack<Real>(c10, c17) *
      (inverse_D8_p54_lanes + inverse_D8_p120_lanes) - detail::make_pack<Real>(s10, s17) *
      (inverse_D8_p70_lanes + inverse_D8_p114_lanes);
  const Lanes<2> inverse_D8_p137_lanes = inverse_D9_p1_lanes * inverse_D8_p123_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D8_p97_lanes + inverse_D8_p122_lanes);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p138_lanes = 0.0019585440854647937 +
      (inverse_D9_p14_lanes + inverse_D9_p19_lanes + 0.282 *
      (inverse_D8_p68_lanes + inverse_D8_p73_lanes)) - inverse_D8_p135_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p139_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p136_lanes;
  const Lanes<2> inverse_D8_p140_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p137_lanes;
  const Lanes<2> inverse_D8_p141_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p136_lanes;
  const Lanes<2> inverse_D8_p142_lanes = inverse_D8_p120_lanes - inverse_D8_p139_lanes;
  const Lanes<2> inverse_D8_p143_lanes = inverse_D8_p97_lanes + inverse_D8_p140_lanes;
  const Lanes<2> inverse_D6_p11_lanes = inverse_D8_p114_lanes + inverse_D8_p141_lanes;
  const Lanes<2> inverse_D6_p13_lanes = inverse_D8_p123_lanes - detail::make_pack<Real>(c10, c17) *
      inverse_D8_p137_lanes;
  const Lanes<2> inverse_D8_p147_lanes = inverse_D8_p70_lanes + inverse_D8_p141_lanes +
      inverse_D8_p134_lanes;
  const Lanes<2> inverse_D6_p17_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      inverse_D8_p142_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p19_lanes = inverse_D6_p11_lanes * inverse_D9_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D6_p23_lanes = inverse_D8_p67_lanes - 0.0022500062;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p27_lanes = inverse_D6_p17_lanes * inverse_D9_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p149_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * inverse_D8_p142_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p29_lanes = inverse_D6_p23_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D8_p151_lanes = inverse_D8_p149_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D6_p49_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * inverse_D6_p5_lanes - (inverse_D8_p54_lanes - inverse_D8_p139_lanes)) +
      inverse_D8_p105_lanes * inverse_D6_p19_lanes;
  const Lanes<2> inverse_D6_p51_lanes = inverse_D8_p147_lanes + inverse_D8_p105_lanes *
      inverse_D6_p27_lanes;
  const Lanes<2> inverse_D6_p53_lanes = inverse_D8_p149_lanes * inverse_D6_p27_lanes - 0.282 *
      inverse_D8_p143_lanes;
  const Lanes<2> inverse_D6_p55_lanes = inverse_D8_p134_lanes + inverse_D8_p149_lanes *
      inverse_D6_p29_lanes;
  const Lanes<2> inverse_D6_p57_lanes = inverse_D8_p73_lanes - inverse_D8_p105_lanes *
      inverse_D6_p29_lanes;
  const Lanes<2> inverse_D6_p59_lanes = 0.0022500062 + 0.282 * inverse_D6_p13_lanes +
      inverse_D8_p149_lanes * inverse_D6_p19_lanes;
  const Lanes<2> inverse_D8_p155_lanes = 0.0008177492704690715 + 0.07952399999999998 *
      inverse_D8_p143_lanes - inverse_D8_p149_lanes * inverse_D8_p151_lanes;
  const Lanes<2> inverse_D8_p156_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * inverse_D8_p147_lanes - inverse_D8_p105_lanes *
      inverse_D8_p151_lanes;
  const Lanes<2> inverse_D6_p81_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p51_lanes + inverse_D6_p55_lanes) - detail::make_pack<Real>(s9, s16) *
      (inverse_D6_p53_lanes + inverse_D6_p57_lanes);
  const Lanes<2> inverse_D6_p83_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * inverse_D6_p49_lanes -
      detail::make_pack<Real>(s9, s16) * inverse_D6_p59_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p1_lanes = 2.0 * detail::make_pack<Real>(c8, c15);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p160_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D8_p138_lanes - inverse_D8_p155_lanes) - inverse_D8_p118_lanes *
      inverse_D8_p156_lanes;
  const Lanes<2> inverse_D6_p85_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p81_lanes;
  const Lanes<2> inverse_D6_p87_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p81_lanes;
  const Lanes<2> inverse_D8_p161_lanes = detail::make_pack<Real>(c9, c16) * inverse_D8_p160_lanes;
  const Lanes<2> inverse_D6_p93_lanes = 0.7139200499999999 +
      (inverse_D6_p85_lanes + inverse_D6_p57_lanes);
  const Lanes<2> inverse_D8_p163_lanes = 0.18125194219699997 +
      (inverse_D8_p155_lanes + inverse_D8_p161_lanes);
  const Lanes<2> inverse_D7_p5_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * inverse_D8_p160_lanes + inverse_D8_p156_lanes);
  const Lanes<2> inverse_D6_p95_lanes = inverse_D6_p87_lanes - inverse_D6_p55_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p163_lanes;
  const Lanes<2> inverse_D7_p8_lanes = inverse_D7_p5_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p9_lanes = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p163_lanes;
  const Lanes<2> inverse_D6_p97_lanes = inverse_D6_p83_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D6_p99_lanes = inverse_D6_p93_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D6_p101_lanes = inverse_D6_p95_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D6_p109_lanes = 0.00010499999999999999 * inverse_D6_p99_lanes;
  const Lanes<2> inverse_D6_p111_lanes = 0.00010499999999999999 * inverse_D6_p97_lanes;
  const Lanes<2> inverse_D7_p12_lanes = 0.18113119219699997 +
      (inverse_D8_p138_lanes - inverse_D8_p161_lanes) - inverse_D7_p5_lanes * inverse_D7_p8_lanes;
  const Lanes<2> inverse_D7_p13_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + 0.00010499999999999999 * inverse_D7_p8_lanes;
  const Lanes<2> inverse_D6_p119_lanes = inverse_D7_p5_lanes * inverse_D6_p97_lanes -
      (detail::make_pack<Real>(s9, s16) * inverse_D6_p49_lanes + detail::make_pack<Real>(c9, c16) *
      inverse_D6_p59_lanes);
  const Lanes<2> inverse_D6_p121_lanes = inverse_D6_p51_lanes - inverse_D6_p87_lanes -
      inverse_D7_p5_lanes * inverse_D6_p99_lanes;
  const Lanes<2> inverse_D6_p123_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * inverse_D6_p101_lanes;
  const Lanes<2> inverse_D6_p125_lanes = inverse_D6_p85_lanes + inverse_D6_p53_lanes -
      0.7139200499999999 - inverse_D7_p5_lanes * inverse_D6_p101_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p151_lanes = inverse_D8_p143_lanes - inverse_D6_p17_lanes *
      inverse_D6_p27_lanes;
  const Lanes<2> inverse_D6_p153_lanes = inverse_D8_p52_lanes - inverse_D6_p23_lanes *
      inverse_D6_p29_lanes;
  const Lanes<2> inverse_D6_p157_lanes = inverse_D8_p131_lanes + inverse_D6_p17_lanes *
      inverse_D6_p29_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p17_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D7_p9_lanes - inverse_D7_p12_lanes) + inverse_D7_p1_lanes * inverse_D7_p13_lanes;
  const Lanes<2> inverse_D6_p165_lanes = detail::make_pack<Real>(c8, c15) *
      (inverse_D6_p119_lanes + inverse_D6_p109_lanes) - detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p111_lanes + inverse_D6_p121_lanes);
  const Lanes<2> inverse_D6_p171_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * inverse_D6_p123_lanes + detail::make_pack<Real>(c8, c15) *
      inverse_D6_p125_lanes);
  const Lanes<2> inverse_D7_p18_lanes = detail::make_pack<Real>(s8, s15) * inverse_D7_p17_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p175_lanes = inverse_D6_p13_lanes + inverse_D6_p17_lanes *
      inverse_D6_p19_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p179_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p165_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p183_lanes = inverse_D6_p5_lanes + inverse_D6_p23_lanes *
      inverse_D6_p19_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p193_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p165_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p201_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p151_lanes - inverse_D6_p153_lanes) - inverse_D8_p118_lanes *
      inverse_D6_p157_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p20_lanes = 0.000448 + (inverse_D7_p12_lanes + inverse_D7_p18_lanes);
  const Lanes<2> inverse_D6_p215_lanes = 0.0017499999999999998 +
      (inverse_D6_p179_lanes - inverse_D6_p109_lanes);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p217_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p201_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p221_lanes = inverse_D8_p122_lanes + inverse_D8_p140_lanes +
      inverse_D6_p11_lanes * inverse_D6_p19_lanes + inverse_D6_p83_lanes * inverse_D6_p97_lanes;
  const Lanes<2> inverse_D6_p227_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p17_lanes -
      inverse_D7_p13_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D7_lanes = 1.0 / inverse_D7_p20_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p229_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p175_lanes -
      detail::make_pack<Real>(c9, c16) * inverse_D6_p183_lanes + inverse_D6_p83_lanes *
      inverse_D6_p99_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p233_lanes = 2.0 * detail::make_pack<Real>(s7, s14);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p243_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p175_lanes +
      detail::make_pack<Real>(s9, s16) * inverse_D6_p183_lanes + inverse_D6_p83_lanes *
      inverse_D6_p101_lanes;
  const Lanes<2> inverse_D6_p245_lanes = inverse_D6_p121_lanes + inverse_D6_p193_lanes;
  const Lanes<2> inverse_D6_p247_lanes = inverse_D6_p151_lanes - inverse_D6_p217_lanes -
      inverse_D6_p93_lanes * inverse_D6_p99_lanes;
  const Lanes<2> inverse_D6_p249_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p201_lanes +
      inverse_D6_p157_lanes - inverse_D6_p93_lanes * inverse_D6_p101_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p269_lanes = inverse_D6_p215_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p271_lanes = inverse_D6_p171_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p273_lanes = inverse_D6_p245_lanes * inverse_D7_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p275_lanes = inverse_D7_p1_lanes * inverse_D6_p229_lanes -
      detail::make_pack<Real>(s8, s15) * (inverse_D6_p221_lanes + inverse_D6_p247_lanes);

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p1_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p285_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p275_lanes;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p3 = c24 + c23;
  const Lanes<2> inverse_D21_p3_lanes = detail::make_pack<Real>(c23, c24) * inverse_D21_p1_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p291_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p271_lanes;
  const Lanes<2> inverse_D6_p293_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p269_lanes;
  const Lanes<2> inverse_D6_p299_lanes = inverse_D6_p153_lanes + inverse_D6_p217_lanes -
      inverse_D6_p95_lanes * inverse_D6_p101_lanes - inverse_D6_p171_lanes * inverse_D6_p271_lanes;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p5 = s24 + s23;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p301_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p243_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p249_lanes - inverse_D6_p171_lanes *
      inverse_D6_p269_lanes;
  const Lanes<2> inverse_D6_p303_lanes = inverse_D6_p111_lanes + inverse_D6_p193_lanes +
      inverse_D6_p227_lanes * inverse_D6_p269_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D22_p4_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Lanes<2> inverse_D21_p6_lanes = detail::make_pack<Real>(s23, s24) * inverse_D21_p1_lanes;
  const Lanes<2> inverse_D21_p10_lanes = inverse_D21_p3_lanes - 0.0007770270270270272;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p307_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p123_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p125_lanes - inverse_D6_p227_lanes *
      inverse_D6_p271_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p12_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p315_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p243_lanes +
      detail::make_pack<Real>(c8, c15) * inverse_D6_p249_lanes - inverse_D6_p171_lanes *
      inverse_D6_p273_lanes;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p6 = inverse_D22_p4_lanes[1] + inverse_D22_p4_lanes[0];
  const Lanes<2> inverse_D21_p14_lanes = 0.006756756756756757 * detail::make_pack<Real>(s23, s24);
  const Real inverse_D21_p16 = inverse_D21_p6_lanes[1] + inverse_D21_p6_lanes[0];
  const Lanes<2> inverse_D21_p17_lanes = detail::make_pack<Real>(0.032, (-0.032)) *
      inverse_D21_p10_lanes;
  const Real inverse_D6_p317 = 0.431222972972973 + inverse_D21_p3_lanes[1] +
      inverse_D21_p10_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p318_lanes = inverse_D6_p221_lanes + inverse_D6_p285_lanes +
      inverse_D6_p215_lanes * inverse_D6_p269_lanes;
  const Lanes<2> inverse_D6_p322_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p275_lanes -
      inverse_D6_p229_lanes - inverse_D6_p215_lanes * inverse_D6_p273_lanes;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p324 = 0.072575 + 0.00025 * inverse_D22_p3;
  const Lanes<2> inverse_D21_p19_lanes = detail::make_pack<Real>(c23, c24) * inverse_D21_p14_lanes;
  const Lanes<2> inverse_D21_p21_lanes = detail::make_pack<Real>(s23, s24) * inverse_D21_p14_lanes;
  const Real inverse_D21_p23 = inverse_D21_p12_lanes[0] + 2.375e-05 * inverse_D21_p5 +
      inverse_D21_p12_lanes[1];
  const Real inverse_D21_p24 = inverse_D21_p17_lanes[1] + inverse_D21_p17_lanes[0] - 0.095 *
      inverse_D21_p16;
  const Lanes<2> inverse_D21_p29_lanes = inverse_D21_p21_lanes - 0.006756756756756757;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p6 + 4.75e-05 * inverse_D22_p3);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p337_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p303_lanes - inverse_D6_p291_lanes) - detail::make_pack<Real>(s7, s14) *
      (inverse_D6_p307_lanes - inverse_D6_p293_lanes);
  const Lanes<2> inverse_D6_p339_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p315_lanes +
      detail::make_pack<Real>(c7, c14) * inverse_D6_p322_lanes;
  const Lanes<2> inverse_D6_p341_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p299_lanes + inverse_D6_p318_lanes) - inverse_D6_p233_lanes *
      inverse_D6_p301_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p35_lanes = 0.095 * inverse_D21_p19_lanes +
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D21_p21_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p343_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p337_lanes;
  const Lanes<2> inverse_D6_p347_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p341_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p37_lanes = 0.095 * inverse_D21_p29_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D21_p19_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p39 = inverse_D21_p3_lanes[1] + inverse_D21_p3_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p349_lanes = inverse_D6_p293_lanes - inverse_D6_p343_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p40 = 2.0 * c22;
  const Real inverse_D21_p41 = inverse_D21_p37_lanes[1] + inverse_D21_p37_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p351_lanes = inverse_D6_p299_lanes - inverse_D6_p347_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p42 = inverse_D21_p24 * inverse_D22;
  const Real inverse_D6_p355 = inverse_D6_p317 * inverse_D22;
  const Real inverse_D6_p356 = inverse_D6_p324 * inverse_D22;
  const Real inverse_D6_p357 = inverse_D21_p16 * inverse_D22;
  const Real inverse_D21_p43 = 0.05450270000000001 + inverse_D22_p6 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - inverse_D21_p23 * inverse_D21_p23 * inverse_D22;
  const Real inverse_D6_p360 = inverse_D21_p24 * inverse_D6_p356;
  const Real inverse_D4_p1 = inverse_D6_p324 * inverse_D6_p357;
  const Real inverse_D21_p44 = inverse_D21_p43 - 0.00017071621621621625;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p361_lanes = inverse_D6_p349_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p351_lanes + 0.226 *
      inverse_D6_p339_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p363 = inverse_D21_p23 * inverse_D6_p355 - inverse_D21_p16;
  const Real inverse_D6_p364 = inverse_D21_p35_lanes[1] + inverse_D21_p35_lanes[0] +
      inverse_D21_p24 * inverse_D6_p355;
  const Real inverse_D6_p365 = inverse_D21_p23 * inverse_D6_p356 - 0.00025 * inverse_D21_p5;
  const Real inverse_D6_p366 = 0.072575 + inverse_D21_p41 + inverse_D21_p24 * inverse_D6_p357;
  const Real inverse_D6_p367 = inverse_D21_p39 - 0.43200000000000005 + inverse_D21_p23 *
      inverse_D6_p357;
  const Real inverse_D4_p2 = inverse_D6_p317 * inverse_D6_p356;
  const Real inverse_D4_p3 = inverse_D21_p19_lanes[1] + inverse_D21_p19_lanes[0] - inverse_D6_p317 *
      inverse_D6_p357;
  const Real inverse_D21_p45 = 0.009438624999999999 - (-0.032) * inverse_D21_p35_lanes[1] - 0.032 *
      inverse_D21_p35_lanes[0] - inverse_D21_p24 * inverse_D21_p42 + 0.095 * inverse_D21_p41;
  const Real inverse_D21_p46 = 0.0074 - (-0.032) * inverse_D21_p6_lanes[1] - 0.032 *
      inverse_D21_p6_lanes[0] + inverse_D21_p23 * inverse_D21_p42 - 0.095 * inverse_D21_p39;
  const Real inverse_D4_p4 = inverse_D6_p324 * inverse_D6_p356;
  const Real inverse_D4_p5 = inverse_D21_p21_lanes[1] + inverse_D21_p21_lanes[0] + inverse_D6_p317 *
      inverse_D6_p355;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p370_lanes = inverse_D6_p227_lanes * inverse_D7_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p372 = c22 * inverse_D6_p366 - s22 * inverse_D6_p367;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p375_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p20_lanes;
  const Lanes<2> inverse_D6_p377_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D6_p349_lanes + inverse_D6_p361_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D4_p6 = c22 * inverse_D4_p1 - s22 * inverse_D4_p3;
  const Real inverse_D6_p379 = s22 * (inverse_D6_p363 + inverse_D6_p360) + c22 *
      (inverse_D6_p365 - inverse_D6_p364);
  const Real inverse_D21_p47 = s22 * (inverse_D21_p44 - inverse_D21_p45) + inverse_D21_p40 *
      inverse_D21_p46;
  const Real inverse_D6_p386 = c22 * inverse_D6_p379;
  const Real inverse_D4_p7 = s22 * inverse_D6_p379;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p387_lanes = 0.0002975 + (inverse_D7_p9_lanes - inverse_D7_p18_lanes) -
      inverse_D6_p227_lanes * inverse_D6_p370_lanes;
  const Lanes<2> inverse_D6_p389_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p370_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p48 = s22 * inverse_D21_p47;
  const Real inverse_D4_p8 = inverse_D21_p40 * inverse_D4_p2 - s22 *
      (inverse_D4_p4 - inverse_D4_p5);
  const Real inverse_D6_p391 = c22 * inverse_D6_p367 + s22 * inverse_D6_p366;
  const Real inverse_D6_p392 = inverse_D6_p386 - inverse_D6_p365;
  const Real inverse_D4_p9 = inverse_D4_p7 - inverse_D6_p360;
  const Real inverse_D6_p395 = inverse_D21_p29_lanes[1] + inverse_D21_p29_lanes[0] -
      inverse_D21_p16 * inverse_D6_p357;
  const Real inverse_D6_p396 = s22 * inverse_D4_p8;
  const Real inverse_D6_p397 = 0.394 * inverse_D6_p392;
  const Real inverse_D6_p398 = inverse_D6_p396 - inverse_D4_p5;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p399_lanes = 0.0001505 - inverse_D6_p375_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D4_p10 = inverse_D4_p2 - c22 * inverse_D4_p8;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p401 = 2.0 * s21;
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p45 + inverse_D21_p48));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p402 = inverse_D6_p391 - 0.394 * inverse_D6_p395;
  const Real inverse_D6_p403 = 0.0016155 + (c22 * inverse_D21_p47 - inverse_D21_p46 + 0.394 *
      inverse_D6_p372);
  const Real inverse_D6_p404 = c22 * inverse_D4_p3 + s22 * inverse_D4_p1;
  const Real inverse_D6_p407 = 0.394 * inverse_D6_p404;
  const Real inverse_D6_p416 = inverse_D6_p363 - inverse_D4_p7 - inverse_D6_p407;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p419_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p273_lanes;
  const Lanes<2> inverse_D6_p427_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p399_lanes - inverse_D6_p387_lanes) + inverse_D6_p233_lanes *
      inverse_D6_p389_lanes;
  const Lanes<2> inverse_D6_p429_lanes = inverse_D6_p179_lanes - inverse_D6_p119_lanes -
      0.0017499999999999998 - inverse_D6_p227_lanes * inverse_D6_p273_lanes;
  const Lanes<2> inverse_D6_p433_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p427_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p435 = inverse_D6_p397 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p436_lanes = inverse_D6_p247_lanes + inverse_D6_p285_lanes -
      inverse_D6_p245_lanes * inverse_D6_p273_lanes;
  const Lanes<2> inverse_D5_p1_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p337_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p11 = inverse_D4_p9 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p442 = inverse_D6_p433_lanes[1] + inverse_D6_p433_lanes[0];
  const Lanes<2> inverse_D4_p14_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p341_lanes +
      inverse_D6_p301_lanes;
  const Lanes<2> inverse_D6_p443_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p419_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p429_lanes;
  const Lanes<2> inverse_D4_p16_lanes = inverse_D6_p291_lanes + inverse_D5_p1_lanes;
  const Lanes<2> inverse_D5_p9_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p427_lanes;
  const Lanes<2> inverse_D5_p11_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p315_lanes -
      detail::make_pack<Real>(s7, s14) * inverse_D6_p322_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p447 = 0.005513625 + (inverse_D21_p44 - inverse_D21_p48 - 0.394 *
      (inverse_D6_p391 + inverse_D6_p402)) - inverse_D6_p403 * (inverse_D6_p403 * inverse_D21);
  const Real inverse_D6_p448 = 0.000703125 + 0.155236 * inverse_D6_p398 - inverse_D6_p397 *
      inverse_D6_p435;
  const Real inverse_D6_p449 = 0.394 * inverse_D6_p416 - inverse_D6_p403 * inverse_D6_p435;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D4_p18_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      inverse_D4_p14_lanes;
  const Lanes<2> inverse_D5_p17_lanes = 0.226 * inverse_D5_p11_lanes;
  const Lanes<2> inverse_D6_p450_lanes = inverse_D6_p443_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p339_lanes + 0.226 *
      inverse_D6_p436_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p20 = inverse_D6_p403 * inverse_D4_p11 -
      (inverse_D6_p386 + inverse_D6_p364 + 0.394 * inverse_D4_p6);
  const Real inverse_D4_p21 = inverse_D6_p397 * inverse_D4_p11 -
      (0.0045000000000000005 + 0.394 * inverse_D4_p10);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D4_p22_lanes = inverse_D4_p18_lanes - inverse_D4_p16_lanes;
  const Real inverse_D6_p452 = inverse_D6_p450_lanes[1] + inverse_D6_p450_lanes[0];
  const Lanes<2> inverse_D5_p19_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p419_lanes -
      detail::make_pack<Real>(c7, c14) * inverse_D6_p429_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p21 = inverse_D6_p392 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D5_p24 = 0.0045000000000000005 + inverse_D6_p372;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p25 = inverse_D5_p19_lanes[1] + inverse_D5_p19_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p26 = inverse_D5_p24 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p27_lanes = inverse_D5_p1_lanes - inverse_D6_p303_lanes -
      (inverse_D4_p18_lanes + inverse_D5_p17_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p453 = c21 * (inverse_D6_p447 - inverse_D6_p448) - inverse_D6_p401 *
      inverse_D6_p449;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p31 = inverse_D5_p27_lanes[1] + inverse_D5_p27_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p454 = c21 * inverse_D6_p453;
  const Real inverse_D5_p32 = inverse_D6_p416 - inverse_D6_p403 * inverse_D5_p21;
  const Real inverse_D5_p33 = 0.394 * inverse_D6_p398 - inverse_D6_p397 * inverse_D5_p21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p34_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p27_lanes + inverse_D4_p16_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p36 = inverse_D6_p407 + inverse_D6_p397 * inverse_D5_p26;
  const Real inverse_D5_p37 = inverse_D6_p402 + inverse_D6_p403 * inverse_D5_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D4_p24 = c21 * inverse_D4_p20 - s21 * inverse_D4_p21 +
      inverse_D6_p361_lanes[1] + inverse_D6_p361_lanes[0];

  // link 6 (chest3), articulated inertia
  const Real inverse_D4_p25 = inverse_D4_p14_lanes[1] + inverse_D4_p14_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p38 = s21 * inverse_D6_p453 + inverse_D6_p449 + 0.226 * inverse_D5_p31;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p39 = c21 * (inverse_D5_p32 - inverse_D5_p36) - s21 *
      (inverse_D5_p33 + inverse_D5_p37);
  const Real inverse_D5_p40 = c21 * inverse_D5_p39;
  const Real inverse_D4_p26 = s21 * inverse_D5_p39;
  const Real inverse_D4_p27 = inverse_D6_p392 * inverse_D4_p11 - inverse_D4_p10;
  const Real inverse_D4_p28 = inverse_D4_p6 - inverse_D5_p24 * inverse_D4_p11;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p455 = 2.06965463592404 + inverse_D6_p448 + inverse_D6_p454 +
      inverse_D6_p387_lanes[1] + inverse_D6_p442 + inverse_D6_p377_lanes[1] +
      inverse_D6_p387_lanes[0] + inverse_D6_p377_lanes[0] + 0.226 *
      (inverse_D6_p443_lanes[1] + inverse_D6_p452 + inverse_D6_p443_lanes[0]);

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p29 = inverse_D6_p398 - inverse_D6_p392 * inverse_D5_p21;
  const Real inverse_D4_p30 = inverse_D6_p395 - inverse_D5_p24 * inverse_D5_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p41 = inverse_D5_p36 + inverse_D5_p40 + inverse_D5_p31;
  const Real inverse_D5_p42 = 0.0187369177636143 + inverse_D5_p34_lanes[1] -
      inverse_D6_p389_lanes[1] + inverse_D5_p9_lanes[1] + inverse_D5_p34_lanes[0] -
      inverse_D6_p389_lanes[0] + inverse_D5_p9_lanes[0] + 0.226 * inverse_D5_p25;

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p455;

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p31 = inverse_D6_p404 + inverse_D6_p392 * inverse_D5_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p43_lanes = inverse_D6_p343_lanes + inverse_D6_p307_lanes;
  const Lanes<2> inverse_D5_p45_lanes = inverse_D6_p347_lanes - inverse_D6_p318_lanes;
  const Real inverse_D4_p32 = inverse_D4_p26 + inverse_D5_p37 - 6.1665928899999995 -
      inverse_D6_p452;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p49 = inverse_D5_p45_lanes[1] + inverse_D5_p45_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p50_lanes = inverse_D5_p43_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p45_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p33 = c21 * (inverse_D4_p29 - inverse_D4_p30) - inverse_D6_p401 *
      inverse_D4_p31;
  const Real inverse_D5_p52 = c21 * inverse_D4_p33;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p53 = inverse_D5_p41 * inverse_D6;
  const Real inverse_D4_p34 = inverse_D4_p24 * inverse_D6;
  const Real inverse_D4_p35 = inverse_D4_p32 * inverse_D6;
  const Real inverse_D5_p54 = inverse_D5_p42 * inverse_D6;
  const Real inverse_D5_p57 = inverse_D5_p38 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p58_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p43_lanes + inverse_D5_p50_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p60 = inverse_D5_p50_lanes[1] + inverse_D5_p50_lanes[0] - inverse_D5_p42 *
      inverse_D5_p53;
  const Real inverse_D5_p61 = inverse_D4_p30 + inverse_D5_p52 + inverse_D5_p49 - inverse_D5_p41 *
      inverse_D5_p53;
  const Real inverse_D5_p62 = 2.0 * c6;
  const Real inverse_D4_p36 = inverse_D4_p22_lanes[1] + inverse_D4_p22_lanes[0] + inverse_D5_p42 *
      inverse_D4_p34;
  const Real inverse_D5_p63 = 6.1665928899999995 + inverse_D4_p26 + inverse_D5_p33 -
      inverse_D5_p38 * inverse_D5_p53 + 0.226 * inverse_D5_p49;
  const Real inverse_D4_p37 = inverse_D5_p32 - inverse_D5_p40 + inverse_D5_p17_lanes[1] +
      inverse_D5_p17_lanes[0] - inverse_D5_p38 * inverse_D4_p35;
  const Real inverse_D4_p38 = inverse_D5_p38 * inverse_D4_p34 -
      (s21 * inverse_D4_p20 + c21 * inverse_D4_p21) + 0.226 * inverse_D4_p25;
  const Real inverse_D4_p39 = (-0.18) * inverse_D5_p11_lanes[1] - inverse_D5_p25 + 0.18 *
      inverse_D5_p11_lanes[0] - inverse_D5_p42 * inverse_D4_p35;
  const Real inverse_D4_p40 = inverse_D4_p25 - c21 * inverse_D4_p27 + s21 * inverse_D4_p28 +
      inverse_D4_p24 * inverse_D5_p53;
  const Real inverse_D4_p41 = s21 * inverse_D4_p33 + inverse_D4_p31 + inverse_D5_p11_lanes[1] +
      inverse_D5_p11_lanes[0] - inverse_D4_p32 * inverse_D5_p53;
  const Real inverse_D5_p64 = 1.66923963592404 + inverse_D6_p447 - inverse_D6_p454 -
      inverse_D5_p38 * inverse_D5_p57 + 0.051076 * inverse_D5_p49;
  const Real inverse_D5_p65 = (-0.04068) * inverse_D5_p45_lanes[1] + 0.04068 *
      inverse_D5_p45_lanes[0] - inverse_D5_p42 * inverse_D5_p57 + 0.226 *
      (inverse_D5_p43_lanes[1] + inverse_D5_p43_lanes[0]);
  const Real inverse_D5_p66 = s6 * inverse_D5_p60 + c6 * inverse_D5_p63;
  const Real inverse_D5_p67 = 0.40056549999999996 - inverse_D6_p375_lanes[1] - inverse_D6_p442 +
      inverse_D5_p58_lanes[1] + inverse_D6_p399_lanes[0] + inverse_D5_p58_lanes[0] -
      inverse_D5_p42 * inverse_D5_p54;
  const Real inverse_D5_p68 = inverse_D5_p66 + 0.072 * inverse_D5_p61;
  const Real inverse_D4_p42 = s6 * (inverse_D4_p36 - inverse_D4_p37) + c6 *
      (inverse_D4_p38 + inverse_D4_p39);
  const Real inverse_D4_p43 = s6 * inverse_D4_p40 + c6 * inverse_D4_p41;
  const Real inverse_D4_p44 = inverse_D4_p29 - inverse_D5_p52 + inverse_D6_p436_lanes[1] +
      inverse_D6_p436_lanes[0] - inverse_D4_p32 * inverse_D4_p35;
  const Real inverse_D4_p45 = s6 * inverse_D4_p42;
  const Real inverse_D4_p46 = 0.072 * inverse_D4_p43;
  const Real inverse_D4_p47 = c6 * inverse_D5_p60 - s6 * inverse_D5_p63;
  const Real inverse_D4_p48 = inverse_D6_p351_lanes[1] -
      (inverse_D4_p4 + inverse_D6_p396 + inverse_D4_p9 * inverse_D4_p11) +
      inverse_D6_p351_lanes[0] - inverse_D4_p24 * inverse_D4_p34;
  const Real inverse_D4_p49 = c6 * inverse_D4_p42;
  const Real inverse_D5_p69 = s6 * (inverse_D5_p67 - inverse_D5_p64) + inverse_D5_p62 *
      inverse_D5_p65;
  const Real inverse_D4_p50 = inverse_D6_p339_lanes[1] -
      (s21 * inverse_D4_p27 + c21 * inverse_D4_p28) + inverse_D6_p339_lanes[0] + inverse_D4_p24 *
      inverse_D4_p35;
  const Real inverse_D4_p51 = inverse_D4_p49 - inverse_D4_p38;
  const Real inverse_D5_p70 = s6 * inverse_D5_p69;
  const Real inverse_D4_p52 = inverse_D4_p37 + inverse_D4_p45 + inverse_D4_p46;

  // link 5 (chest2), articulated inertia
  const Real inverse_D4_p53 = 2.0 * c5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D4_p54 = s6 * (inverse_D4_p48 - inverse_D4_p44) + inverse_D5_p62 *
      inverse_D4_p50;
  const Real inverse_D4_p55 = 0.072 * inverse_D4_p52;
  const Real inverse_D3_p1 = 2.2194301519999997 + inverse_D5_p68;
  const Real inverse_D4_p56 = s6 * inverse_D4_p54;
  const Real inverse_D4_p57 = c6 * inverse_D5_p69 - inverse_D5_p65 + 0.072 * inverse_D4_p47;
  const Real inverse_D3_p2 = c6 * inverse_D4_p40 - s6 * inverse_D4_p41;
  const Real inverse_D4_p58 = inverse_D4_p44 + inverse_D4_p56;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p64 + inverse_D5_p70 + 0.072 * (inverse_D5_p66 + inverse_D5_p68)));

  // link 6 (chest3), articulated inertia
  const Real inverse_D3_p3 = c6 * inverse_D4_p54 - inverse_D4_p50;
  const Real inverse_D3_p4 = 0.069699984375 + (inverse_D4_p49 - inverse_D4_p39 + 0.072 *
      inverse_D3_p2);

  // link 5 (chest2), articulated inertia
  const Real inverse_D4_p59 = inverse_D4_p55 * inverse_D5;
  const Real inverse_D4_p60 = inverse_D4_p57 * inverse_D5;
  const Real inverse_D3_p5 = inverse_D3_p1 * inverse_D5;
  const Real inverse_D3_p6 = inverse_D3_p4 * inverse_D5;
  const Real inverse_D3_p7 = inverse_D4_p52 * inverse_D5;
  const Real inverse_D4_p61 = 0.15637308509675518 + 0.005183999999999999 * inverse_D4_p58 -
      inverse_D4_p55 * inverse_D4_p59;
  const Real inverse_D4_p62 = 0.04675382692737882 + (inverse_D5_p67 - inverse_D5_p70) -
      inverse_D4_p57 * inverse_D4_p60;
  const Real inverse_D4_p63 = 0.005678398088837119 - 0.072 * inverse_D4_p51 + inverse_D4_p55 *
      inverse_D4_p60;
  const Real inverse_D3_p8 = inverse_D4_p55 * inverse_D3_p5 - inverse_D4_p46;
  const Real inverse_D3_p9 = inverse_D4_p36 - inverse_D4_p45 - inverse_D4_p57 * inverse_D3_p6;
  const Real inverse_D3_p10 = inverse_D4_p47 - inverse_D4_p57 * inverse_D3_p5;
  const Real inverse_D3_p11 = inverse_D4_p55 * inverse_D3_p6 - 0.072 * inverse_D3_p3;
  const Real inverse_D3_p12 = inverse_D4_p55 * inverse_D3_p7 -
      (2.2194301519999997 + 0.072 * inverse_D4_p58);
  const Real inverse_D3_p13 = inverse_D4_p51 - 0.069699984375 - inverse_D4_p57 * inverse_D3_p7;
  const Real inverse_D3_p14 = inverse_D3_p3 - inverse_D3_p4 * inverse_D3_p7;
  const Real inverse_D3_p15 = inverse_D4_p43 - inverse_D3_p1 * inverse_D3_p7;
  const Real inverse_D3_p16 = inverse_D4_p48 - inverse_D4_p56 - inverse_D3_p4 * inverse_D3_p6;
  const Real inverse_D3_p17 = inverse_D5_p61 - inverse_D3_p1 * inverse_D3_p5;
  const Real inverse_D3_p18 = inverse_D3_p2 - inverse_D3_p1 * inverse_D3_p6;
  const Real inverse_D3_p19 = s5 * inverse_D3_p12 + c5 * inverse_D3_p13;
  const Real inverse_D3_p20 = s5 * inverse_D3_p14 - c5 * inverse_D3_p15;
  const Real inverse_D4_p64 = s5 * (inverse_D4_p61 - inverse_D4_p62) + inverse_D4_p53 *
      inverse_D4_p63;
  const Real inverse_D3_p21 = s5 * (inverse_D3_p8 - inverse_D3_p9) + c5 *
      (inverse_D3_p10 + inverse_D3_p11);
  const Real inverse_D3_p22 = s5 * inverse_D3_p13 - c5 * inverse_D3_p12;
  const Real inverse_D3_p23 = 0.21799999999999997 * inverse_D3_p20;
  const Real inverse_D4_p65 = s5 * inverse_D4_p64;
  const Real inverse_D3_p24 = inverse_D4_p58 - inverse_D4_p52 * inverse_D3_p7;
  const Real inverse_D2_p1 = 0.0300000063 + inverse_D3_p19;
  const Real inverse_D3_p25 = c5 * inverse_D3_p21;
  const Real inverse_D3_p26 = s5 * inverse_D3_p21;
  const Real inverse_D3_p27 = s5 * (inverse_D3_p17 - inverse_D3_p16) + inverse_D4_p53 *
      inverse_D3_p18;
  const Real inverse_D3_p28 = inverse_D3_p25 - inverse_D3_p11;
  const Real inverse_D3_p29 = inverse_D3_p22 + 0.21799999999999997 * inverse_D3_p24;
  const Real inverse_D3_p30 = s5 * inverse_D3_p27;
  const Real inverse_D3_p31 = 0.21799999999999997 * inverse_D3_p28;
  const Real inverse_D3_p32 = inverse_D3_p8 - inverse_D3_p26 + inverse_D3_p23;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p33 = 2.0 * c4;
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p62 + inverse_D4_p65));

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p34 = 0.005880002159562879 +
      (0.21799999999999997 * inverse_D3_p19 - (c5 * inverse_D4_p64 - inverse_D4_p63));
  const Real inverse_D3_p35 = inverse_D3_p17 - inverse_D3_p30;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p36 = inverse_D3_p34 * inverse_D4;
  const Real inverse_D3_p37 = inverse_D3_p31 * inverse_D4;
  const Real inverse_D2_p2 = inverse_D3_p28 * inverse_D4;
  const Real inverse_D2_p3 = inverse_D2_p1 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p4 = inverse_D3_p9 + inverse_D3_p26;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p38 = 0.01227760324629517 + 0.04752399999999999 * inverse_D3_p35 -
      inverse_D3_p31 * inverse_D3_p37;
  const Real inverse_D2_p5 = inverse_D3_p34 * inverse_D2_p3 - inverse_D3_p29;

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p6 = s5 * inverse_D3_p15 + c5 * inverse_D3_p14;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p7 = inverse_D2_p4 * inverse_D4;
  const Real inverse_D2_p8 = inverse_D3_p35 - inverse_D3_p28 * inverse_D2_p2;
  const Real inverse_D3_p39 = 0.0478915 + (inverse_D4_p61 - inverse_D4_p65 + 0.21799999999999997 *
      (inverse_D3_p22 + inverse_D3_p29)) - inverse_D3_p34 * inverse_D3_p36 - inverse_D3_p38;

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p9 = c5 * inverse_D3_p27 - inverse_D3_p18;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p10 = s4 * (inverse_D3_p32 + inverse_D3_p34 * inverse_D2_p2 +
      (inverse_D3_p23 + inverse_D3_p31 * inverse_D2_p3)) + c4 *
      (0.21799999999999997 * inverse_D3_p35 - inverse_D3_p31 * inverse_D2_p2 + inverse_D2_p5);
  const Real inverse_D2_p11 = s4 * (inverse_D2_p8 -
      (inverse_D3_p24 - inverse_D2_p1 * inverse_D2_p3)) - inverse_D3_p33 *
      (inverse_D3_p20 + inverse_D3_p28 * inverse_D2_p3);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> neg_s13_lanes = -detail::make_pack<Real>(s13, s20);

  // link 13 (left_hand), force propagation
  const Lanes<2> f13_x_p13_lanes = 0.11533812622014242 * detail::make_pack<Real>(s13, s20) -
      detail::make_pack<Real>(0.04672761636452121, (-0.04672761636452121)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p15_lanes = 0.11533812622014242 * detail::make_pack<Real>(c13, c20) +
      detail::make_pack<Real>(0.04672761636452121, (-0.04672761636452121)) *
      detail::make_pack<Real>(s13, s20);

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p40 = inverse_D3_p38 + s4 *
      (s4 * inverse_D3_p39 + inverse_D3_p33 * (0.21799999999999997 * inverse_D3_p32 +
      inverse_D3_p34 * inverse_D3_p37));

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p27_lanes = inverse_D10_p25_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p29_lanes = inverse_D10_p25_lanes * detail::make_pack<Real>(s13, s20);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p12 = s4 * (0.21799999999999997 * inverse_D2_p6 -
      (inverse_D3_p25 - inverse_D3_p10) - inverse_D3_p34 * inverse_D2_p7) + c4 *
      (0.0300000063 - 0.21799999999999997 * inverse_D2_p9 + inverse_D3_p31 * inverse_D2_p7);
  const Real inverse_D2_p13 = 8.419374554 + (c4 * inverse_D2_p10 - inverse_D2_p5);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p31_lanes = detail::make_pack<Real>(c13, c13, c13, c13, neg_s13_lanes[0],
      f13_x_p15_lanes[0], c13, c13) - inverse_D11_p4_lanes[0] *
      detail::make_pack<Real>(s13, s13, s13, s13, c13, f13_x_p13_lanes[0], s13, s13);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p34_lanes = detail::make_pack<Real>(c20, c20, neg_s13_lanes[1],
      f13_x_p15_lanes[1], c20, c20, c20, c20) - inverse_D11_p4_lanes[1] *
      detail::make_pack<Real>(s20, s20, c20, f13_x_p13_lanes[1], s20, s20, s20, s20);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p37_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(s13, s20) - 17.32841575379867 *
      detail::make_pack<Real>(c13, c20) - inverse_D10_p25_lanes * f13_x_p13_lanes;
  const Lanes<2> f13_x_p39_lanes = inverse_D10_p24_lanes * f13_x_p13_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p40);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p14 = 0.02999999505 + inverse_D2_p12;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p53_lanes = inverse_D10_p24_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p57_lanes = inverse_D10_p23_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p63_lanes = inverse_D10_p24_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p69_lanes = inverse_D10_p23_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p78_lanes = 0.269 * f13_x_p37_lanes - detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p31_lanes[5], f13_x_p34_lanes[3]);
  const Lanes<2> f13_x_p80_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(c13, c20) + 17.32841575379867 *
      detail::make_pack<Real>(s13, s20) - inverse_D10_p23_lanes * f13_x_p13_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p92_lanes = -(c19 * f13_x_p34_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p103_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p53_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p57_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p105_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p31_lanes[4], f13_x_p34_lanes[2]) + 0.269 * f13_x_p27_lanes);
  const Lanes<2> f13_x_p107_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p31_lanes[3], f13_x_p34_lanes[1]) + 0.269 * f13_x_p29_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p109_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p63_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p69_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p111_lanes = -(0.269 * detail::make_pack<Real>(c12, c19));
  const Lanes<2> f13_x_p113_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p111_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p117_lanes = detail::make_pack<Real>(f13_x_p107_lanes[1],
      f13_x_p107_lanes[1], f13_x_p105_lanes[1], f13_x_p78_lanes[1], f13_x_p107_lanes[1],
      f13_x_p107_lanes[1], f13_x_p107_lanes[1], f13_x_p107_lanes[1]) - inverse_D10_p83_lanes[1] *
      f13_x_p92_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p120_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p39_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p80_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p14 * inverse_D3;
  const Real inverse_D2_p16 = inverse_D2_p13 * inverse_D3;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p134_lanes = -f13_x_p27_lanes;
  const Lanes<2> f13_x_p136_lanes = -f13_x_p29_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p138_lanes = -(detail::make_pack<Real>(s11, s18) * f13_x_p111_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p146_lanes = detail::make_pack<Real>(s11, s18) *
      detail::make_pack<Real>(c12, c19);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p148_lanes = -detail::make_pack<Real>(f13_x_p109_lanes[1],
      f13_x_p109_lanes[1], f13_x_p103_lanes[1], f13_x_p120_lanes[1], f13_x_p109_lanes[1],
      f13_x_p109_lanes[1], f13_x_p109_lanes[1], f13_x_p109_lanes[1]) + inverse_D8_p4_lanes[1] *
      f13_x_p92_lanes;
  const Lanes<8> f13_x_p151_lanes = detail::make_pack<Real>(f13_x_p136_lanes[1],
      f13_x_p136_lanes[1], f13_x_p134_lanes[1], f13_x_p37_lanes[1], f13_x_p136_lanes[1],
      f13_x_p136_lanes[1], f13_x_p136_lanes[1], f13_x_p136_lanes[1]) - inverse_D8_p5_lanes[1] *
      f13_x_p92_lanes;
  const Lanes<8> f13_x_p154_lanes = 0.269 * detail::make_pack<Real>(f13_x_p109_lanes[1],
      f13_x_p109_lanes[1], f13_x_p103_lanes[1], f13_x_p120_lanes[1], f13_x_p109_lanes[1],
      f13_x_p109_lanes[1], f13_x_p109_lanes[1], f13_x_p109_lanes[1]) - inverse_D10_p84_lanes[1] *
      f13_x_p92_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = inverse_D2_p13 * inverse_D2_p15 -
      (c4 * (inverse_D3_p28 * inverse_D2_p7 - inverse_D2_p9) - s4 *
      (inverse_D2_p1 * inverse_D2_p7 - inverse_D2_p6));
  const Real inverse_D2_p18 = inverse_D2_p8 - s4 * inverse_D2_p11 - inverse_D2_p13 * inverse_D2_p16;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p163_lanes = detail::make_pack<Real>(c11, c18) *
      detail::make_pack<Real>(c12, c19);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p19 = inverse_D3_p16 + inverse_D3_p30 - inverse_D2_p4 * inverse_D2_p7 -
      inverse_D2_p14 * inverse_D2_p15;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p184_lanes = -(c12 * f13_x_p31_lanes);
  const Lanes<2> neg_s12_lanes = -detail::make_pack<Real>(s12, s19);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p203_lanes = s18 * f13_x_p117_lanes + c18 * f13_x_p154_lanes;
  const Lanes<8> f13_x_p206_lanes = c18 * f13_x_p117_lanes - s18 * f13_x_p154_lanes;
  const Lanes<8> f13_x_p209_lanes = c18 * f13_x_p148_lanes - s18 * f13_x_p151_lanes;
  const Lanes<8> f13_x_p212_lanes = s18 * f13_x_p148_lanes + c18 * f13_x_p151_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p217_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p39_lanes -
      detail::make_pack<Real>(c12, c19) * f13_x_p80_lanes - inverse_D8_p49_lanes *
      detail::make_pack<Real>(f13_x_p184_lanes[5], f13_x_p92_lanes[3]);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = s3 * (inverse_D2_p18 - inverse_D2_p19) + c3 * (2.0 * inverse_D2_p17);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p233_lanes = inverse_D9_p7_lanes[1] *
      detail::make_pack<Real>(f13_x_p113_lanes[1], f13_x_p203_lanes[1], f13_x_p203_lanes[2],
      f13_x_p203_lanes[3], f13_x_p113_lanes[1], f13_x_p113_lanes[1], f13_x_p113_lanes[1],
      f13_x_p113_lanes[1]);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p241_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p243_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p53_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p57_lanes - inverse_D8_p49_lanes *
      detail::make_pack<Real>(f13_x_p184_lanes[4], f13_x_p92_lanes[2]);
  const Lanes<2> f13_x_p245_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p63_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p69_lanes - inverse_D8_p49_lanes *
      detail::make_pack<Real>(f13_x_p184_lanes[3], f13_x_p92_lanes[1]);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = s3 * inverse_D2_p20;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p247_lanes = detail::make_pack<Real>(f13_x_p138_lanes[1],
      f13_x_p206_lanes[1], f13_x_p206_lanes[2], f13_x_p206_lanes[3], f13_x_p138_lanes[1],
      f13_x_p138_lanes[1], f13_x_p138_lanes[1], f13_x_p138_lanes[1]) - inverse_D9_p9_lanes[1] *
      detail::make_pack<Real>(f13_x_p113_lanes[1], f13_x_p203_lanes[1], f13_x_p203_lanes[2],
      f13_x_p203_lanes[3], f13_x_p113_lanes[1], f13_x_p113_lanes[1], f13_x_p113_lanes[1],
      f13_x_p113_lanes[1]);
  const Lanes<8> f13_x_p251_lanes = detail::make_pack<Real>(f13_x_p163_lanes[1],
      f13_x_p209_lanes[1], f13_x_p209_lanes[2], f13_x_p209_lanes[3], f13_x_p163_lanes[1],
      f13_x_p163_lanes[1], f13_x_p163_lanes[1], f13_x_p163_lanes[1]) - inverse_D8_p46_lanes[1] *
      detail::make_pack<Real>(f13_x_p113_lanes[1], f13_x_p203_lanes[1], f13_x_p203_lanes[2],
      f13_x_p203_lanes[3], f13_x_p113_lanes[1], f13_x_p113_lanes[1], f13_x_p113_lanes[1],
      f13_x_p113_lanes[1]);
  const Lanes<8> f13_x_p263_lanes = detail::make_pack<Real>(f13_x_p146_lanes[1],
      f13_x_p212_lanes[1], f13_x_p212_lanes[2], f13_x_p212_lanes[3], f13_x_p146_lanes[1],
      f13_x_p146_lanes[1], f13_x_p146_lanes[1], f13_x_p146_lanes[1]) - inverse_D8_p34_lanes[1] *
      detail::make_pack<Real>(f13_x_p113_lanes[1], f13_x_p203_lanes[1], f13_x_p203_lanes[2],
      f13_x_p203_lanes[3], f13_x_p113_lanes[1], f13_x_p113_lanes[1], f13_x_p113_lanes[1],
      f13_x_p113_lanes[1]);
  const Lanes<8> f13_x_p270_lanes = -detail::make_pack<Real>(neg_s12_lanes[1], f13_x_p245_lanes[1],
      f13_x_p243_lanes[1], f13_x_p217_lanes[1], neg_s12_lanes[1], neg_s12_lanes[1],
      neg_s12_lanes[1], neg_s12_lanes[1]) - inverse_D8_p109_lanes[1] *
      detail::make_pack<Real>(f13_x_p113_lanes[1], f13_x_p203_lanes[1], f13_x_p203_lanes[2],
      f13_x_p203_lanes[3], f13_x_p113_lanes[1], f13_x_p113_lanes[1], f13_x_p113_lanes[1],
      f13_x_p113_lanes[1]);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p22 = inverse_D2_p18 - inverse_D2_p21;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p294_lanes = c17 * f13_x_p233_lanes - s17 * f13_x_p247_lanes;
  const Lanes<8> f13_x_p302_lanes = s17 * f13_x_p270_lanes - c17 * f13_x_p251_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p306_lanes = inverse_D8_p130_lanes[1] * f13_x_p294_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = 24.5839218 + 0.422 * inverse_D2_p22;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * inverse_D2_p22);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p346_lanes = c17 * f13_x_p247_lanes + s17 * f13_x_p233_lanes + 0.282 *
      f13_x_p263_lanes - f13_x_p306_lanes;
  const Lanes<8> f13_x_p350_lanes = -f13_x_p302_lanes + inverse_D6_p27_lanes[1] * f13_x_p294_lanes;
  const Lanes<8> f13_x_p354_lanes = f13_x_p263_lanes - inverse_D6_p29_lanes[1] * f13_x_p294_lanes;
  const Lanes<8> f13_x_p358_lanes = 0.282 * f13_x_p302_lanes - inverse_D8_p151_lanes[1] *
      f13_x_p294_lanes;
  const Lanes<8> f13_x_p402_lanes = -(s17 * f13_x_p251_lanes + c17 * f13_x_p270_lanes) +
      inverse_D6_p19_lanes[1] * f13_x_p294_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p414_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p420_lanes = c16 * f13_x_p346_lanes - s16 * f13_x_p358_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p432_lanes = f13_x_p241_lanes[1] * f13_x_p420_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p448_lanes = s16 * f13_x_p346_lanes + c16 * f13_x_p358_lanes -
      inverse_D7_p8_lanes[1] * f13_x_p420_lanes;
  const Lanes<8> f13_x_p456_lanes = s16 * f13_x_p350_lanes + c16 * f13_x_p354_lanes -
      inverse_D6_p99_lanes[1] * f13_x_p420_lanes;
  const Lanes<8> f13_x_p460_lanes = -f13_x_p402_lanes + inverse_D6_p97_lanes[1] * f13_x_p420_lanes;
  const Lanes<8> f13_x_p496_lanes = s15 * f13_x_p432_lanes + c15 * f13_x_p448_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p512_lanes = inverse_D6_p271_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p528_lanes = f13_x_p414_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p532_lanes = c16 * f13_x_p350_lanes - s16 * f13_x_p354_lanes -
      inverse_D6_p101_lanes[1] * f13_x_p420_lanes - f13_x_p512_lanes;
  const Lanes<8> f13_x_p536_lanes = c15 * f13_x_p460_lanes - s15 * f13_x_p456_lanes -
      inverse_D6_p269_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p540_lanes = s15 * f13_x_p460_lanes + c15 * f13_x_p456_lanes -
      inverse_D6_p273_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p544_lanes = c15 * f13_x_p432_lanes - s15 * f13_x_p448_lanes -
      inverse_D6_p370_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p584_lanes = s14 * f13_x_p532_lanes + c14 * f13_x_p536_lanes;
  const Lanes<8> f13_x_p592_lanes = c14 * f13_x_p532_lanes - s14 * f13_x_p536_lanes;
  const Lanes<8> f13_x_p612_lanes = 0.226 * f13_x_p540_lanes + (-0.18) * f13_x_p584_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p624_lanes = -(c14 * f13_x_p528_lanes + s14 * f13_x_p544_lanes +
      f13_x_p612_lanes);
  const Lanes<8> f13_x_p628_lanes = inverse_D5_p54 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p648_lanes = (-0.18) * f13_x_p592_lanes -
      (s14 * f13_x_p528_lanes - c14 * f13_x_p544_lanes) - f13_x_p628_lanes;
  const Lanes<8> f13_x_p652_lanes = 0.226 * f13_x_p592_lanes - inverse_D5_p57 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p656_lanes = f13_x_p592_lanes - inverse_D5_p53 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p660_lanes = f13_x_p584_lanes + inverse_D4_p34 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p664_lanes = f13_x_p540_lanes - inverse_D4_p35 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p708_lanes = s6 * f13_x_p660_lanes + c6 * f13_x_p664_lanes;
  const Lanes<8> f13_x_p720_lanes = s6 * f13_x_p648_lanes + c6 * f13_x_p652_lanes + 0.072 *
      f13_x_p656_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p752_lanes = -(0.072 * f13_x_p708_lanes) + inverse_D4_p59 * f13_x_p720_lanes;
  const Lanes<8> f13_x_p756_lanes = c6 * f13_x_p648_lanes - s6 * f13_x_p652_lanes - inverse_D4_p60 *
      f13_x_p720_lanes;
  const Lanes<8> f13_x_p760_lanes = c6 * f13_x_p660_lanes - s6 * f13_x_p664_lanes - inverse_D3_p6 *
      f13_x_p720_lanes;
  const Lanes<8> f13_x_p764_lanes = f13_x_p656_lanes - inverse_D3_p5 * f13_x_p720_lanes;
  const Lanes<8> f13_x_p768_lanes = f13_x_p708_lanes - inverse_D3_p7 * f13_x_p720_lanes;
  const Lanes<8> f13_x_p812_lanes = s5 * f13_x_p760_lanes - c5 * f13_x_p764_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p3 = c3 * inverse_D2_p20 - inverse_D2_p17;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p824_lanes = -(s5 * f13_x_p752_lanes + c5 * f13_x_p756_lanes);
  const Lanes<8> f13_x_p864_lanes = -(s5 * f13_x_p756_lanes - c5 * f13_x_p752_lanes +
      0.21799999999999997 * f13_x_p768_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p4 = inverse_D2_p22 - inverse_D1_p1 * inverse_D1_p2;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p5 = 0.031999971599999996 + 0.422 * inverse_D1_p3;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p888_lanes = -(s5 * f13_x_p764_lanes + c5 * f13_x_p760_lanes) -
      inverse_D2_p7 * f13_x_p824_lanes;
  const Lanes<8> f13_x_p896_lanes = c4 * (-(0.21799999999999997 * f13_x_p812_lanes) +
      inverse_D3_p37 * f13_x_p824_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p900_lanes = 0.269 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p906_lanes = detail::make_pack<Real>(s12, s19) * neg_s13_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p908_lanes = s4 * (f13_x_p768_lanes + inverse_D2_p3 * f13_x_p824_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p6 = inverse_D1_p5 * inverse_D2;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p916_lanes = s4 * (f13_x_p864_lanes - inverse_D3_p36 * f13_x_p824_lanes) +
      f13_x_p896_lanes;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p920 = 0.269 * f13_x_p906_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p925_lanes = inverse_D2_p16 * f13_x_p916_lanes;
  const Lanes<8> f13_x_p933_lanes = c4 * (-f13_x_p812_lanes + inverse_D2_p2 * f13_x_p824_lanes) -
      f13_x_p908_lanes - f13_x_p925_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p937 = -f13_x_p906_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p938_lanes = -f13_x_p888_lanes + inverse_D2_p15 * f13_x_p916_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p942 = s18 * f13_x_p900_lanes[1] + c18 * f13_x_p920;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p959_lanes = detail::make_pack<Real>(c12, c19) * neg_s13_lanes;
  const Lanes<2> f13_x_p961_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(c13, c20);

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p963 = inverse_D9_p7_lanes[1] * f13_x_p942;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p964_lanes = c3 * f13_x_p933_lanes - s3 * f13_x_p938_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p972 = c18 * f13_x_p900_lanes[1] - s18 * f13_x_p920 - inverse_D9_p9_lanes[1] *
      f13_x_p942;
  const Lanes<8> f13_x_p975_lanes = -(-detail::make_pack<Real>(f13_x_p961_lanes[1],
      f13_x_p961_lanes[1], f13_x_p961_lanes[1], f13_x_p961_lanes[1], f13_x_p961_lanes[1],
      f13_x_p961_lanes[1], f13_x_p961_lanes[1], f13_x_p959_lanes[1]));
  const Real f13_x_p977 = f13_x_p975_lanes[7] - inverse_D8_p109_lanes[1] * f13_x_p942;
  const Real f13_x_p978 = s18 * f13_x_p937 + c18 * c20 - inverse_D8_p34_lanes[1] * f13_x_p942;
  const Real f13_x_p979 = c18 * f13_x_p937 - s18 * c20 - inverse_D8_p46_lanes[1] * f13_x_p942;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p7 = s2 * (inverse_D1_p4 - (inverse_D2_p19 + inverse_D2_p21 -
      inverse_D1_p5 * inverse_D1_p6)) + c2 * (2.0 * (inverse_D1_p3 - inverse_D1_p1 *
      inverse_D1_p6));

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p980_lanes = 0.422 * f13_x_p964_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p984_lanes = 0.269 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p986_lanes = detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(c13, c20);

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p996 = 0.269 * f13_x_p986_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p997 = c17 * f13_x_p963 - s17 * f13_x_p972;
  const Real f13_x_p998 = s17 * f13_x_p977 - c17 * f13_x_p979;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p999 = -f13_x_p986_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1008 = c17 * f13_x_p972 + s17 * f13_x_p963 + 0.282 * f13_x_p978 -
      inverse_D8_p130_lanes[1] * f13_x_p997;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1013 = s18 * f13_x_p984_lanes[1] + c18 * f13_x_p996;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p1014_lanes = s2 * (s3 * f13_x_p933_lanes + c3 * f13_x_p938_lanes -
      inverse_D1_p6 * f13_x_p980_lanes);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1018 = 0.282 * f13_x_p998 - inverse_D8_p151_lanes[1] * f13_x_p997;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1019 = inverse_D9_p7_lanes[1] * f13_x_p1013;

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p4 - s2 * inverse_D1_p7));

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1024 = c18 * f13_x_p984_lanes[1] - s18 * f13_x_p996 - inverse_D9_p9_lanes[1] *
      f13_x_p1013;
  const Real f13_x_p1025 = c18 * f13_x_p999 - s18 * s20 - inverse_D8_p46_lanes[1] * f13_x_p1013;
  const Real f13_x_p1026 = f13_x_p975_lanes[6] - inverse_D8_p109_lanes[1] * f13_x_p1013;
  const Real f13_x_p1027 = s18 * f13_x_p999 + c18 * s20 - inverse_D8_p34_lanes[1] * f13_x_p1013;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p1028_lanes = 0.269 * detail::make_pack<Real>(f13_x_p986_lanes[0],
      f13_x_p906_lanes[0], f13_x_p986_lanes[0], f13_x_p109_lanes[0], f13_x_p103_lanes[0],
      f13_x_p120_lanes[0], f13_x_p986_lanes[0], f13_x_p986_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1033 = c16 * f13_x_p1008 - s16 * f13_x_p1018;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1034 = f13_x_p78_lanes[0] - inverse_D10_p83_lanes[0] * f13_x_p184_lanes[5];
  const Real f13_x_p1035 = f13_x_p105_lanes[0] - inverse_D10_p83_lanes[0] * f13_x_p184_lanes[4];
  const Real f13_x_p1036 = f13_x_p107_lanes[0] - inverse_D10_p83_lanes[0] * f13_x_p184_lanes[3];
  const Real f13_x_p1037 = f13_x_p1028_lanes[5] - inverse_D10_p84_lanes[0] * f13_x_p184_lanes[5];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1038 = f13_x_p241_lanes[1] * f13_x_p1033;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p1039_lanes = 0.434 * (c2 * (f13_x_p964_lanes - inverse_D1_p2 *
      f13_x_p980_lanes) - f13_x_p1014_lanes);

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1043 = f13_x_p1028_lanes[4] - inverse_D10_p84_lanes[0] * f13_x_p184_lanes[4];
  const Real f13_x_p1044 = f13_x_p1028_lanes[3] - inverse_D10_p84_lanes[0] * f13_x_p184_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1045 = c17 * f13_x_p1019 - s17 * f13_x_p1024;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1056_lanes = -detail::make_pack<Real>(f13_x_p986_lanes[0],
      f13_x_p906_lanes[0], f13_x_p986_lanes[0], f13_x_p109_lanes[0], f13_x_p103_lanes[0],
      f13_x_p120_lanes[0], f13_x_p986_lanes[0], f13_x_p986_lanes[0]);

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1061 = s17 * f13_x_p1026 - c17 * f13_x_p1025;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1062 = s16 * f13_x_p1008 + c16 * f13_x_p1018 - inverse_D7_p8_lanes[1] *
      f13_x_p1033;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1073 = f13_x_p1056_lanes[5] + inverse_D8_p4_lanes[0] * f13_x_p184_lanes[5];
  const Real f13_x_p1074 = f13_x_p1056_lanes[4] + inverse_D8_p4_lanes[0] * f13_x_p184_lanes[4];
  const Real f13_x_p1075 = f13_x_p1056_lanes[3] + inverse_D8_p4_lanes[0] * f13_x_p184_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p1076_lanes = f13_x_p1039_lanes * inverse_D1;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1080 = f13_x_p37_lanes[0] - inverse_D8_p5_lanes[0] * f13_x_p184_lanes[5];
  const Real f13_x_p1081 = f13_x_p134_lanes[0] - inverse_D8_p5_lanes[0] * f13_x_p184_lanes[4];
  const Lanes<8> f13_x_p1082_lanes = s11 * detail::make_pack<Real>(f13_x_p984_lanes[0],
      f13_x_p900_lanes[0], f13_x_p984_lanes[0], f13_x_p1036, f13_x_p1035, f13_x_p1034,
      f13_x_p984_lanes[0], f13_x_p984_lanes[0]) + c11 *
      detail::make_pack<Real>(f13_x_p1028_lanes[0], f13_x_p1028_lanes[1], f13_x_p1028_lanes[0],
      f13_x_p1044, f13_x_p1043, f13_x_p1037, f13_x_p1028_lanes[0], f13_x_p1028_lanes[0]);
  const Lanes<8> f13_x_p1087_lanes = c11 * detail::make_pack<Real>(f13_x_p984_lanes[0],
      f13_x_p900_lanes[0], f13_x_p984_lanes[0], f13_x_p1036, f13_x_p1035, f13_x_p1034,
      f13_x_p984_lanes[0], f13_x_p984_lanes[0]) - s11 *
      detail::make_pack<Real>(f13_x_p1028_lanes[0], f13_x_p1028_lanes[1], f13_x_p1028_lanes[0],
      f13_x_p1044, f13_x_p1043, f13_x_p1037, f13_x_p1028_lanes[0], f13_x_p1028_lanes[0]);
  const Real f13_x_p1092 = f13_x_p136_lanes[0] - inverse_D8_p5_lanes[0] * f13_x_p184_lanes[3];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1093 = c17 * f13_x_p1024 + s17 * f13_x_p1019 + 0.282 * f13_x_p1027 -
      inverse_D8_p130_lanes[1] * f13_x_p1045;
  const Real f13_x_p1094 = 0.282 * f13_x_p1061 - inverse_D8_p151_lanes[1] * f13_x_p1045;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1110 = s15 * f13_x_p1038 + c15 * f13_x_p1062;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1129_lanes = inverse_D9_p7_lanes[0] *
      detail::make_pack<Real>(f13_x_p1082_lanes[0], f13_x_p1082_lanes[1], f13_x_p113_lanes[0],
      f13_x_p1082_lanes[3], f13_x_p1082_lanes[4], f13_x_p1082_lanes[5], f13_x_p1082_lanes[0],
      f13_x_p1082_lanes[0]);
  const Lanes<8> f13_x_p1151_lanes = detail::make_pack<Real>(f13_x_p1087_lanes[0],
      f13_x_p1087_lanes[1], f13_x_p138_lanes[0], f13_x_p1087_lanes[3], f13_x_p1087_lanes[4],
      f13_x_p1087_lanes[5], f13_x_p1087_lanes[0], f13_x_p1087_lanes[0]) - inverse_D9_p9_lanes[0] *
      detail::make_pack<Real>(f13_x_p1082_lanes[0], f13_x_p1082_lanes[1], f13_x_p113_lanes[0],
      f13_x_p1082_lanes[3], f13_x_p1082_lanes[4], f13_x_p1082_lanes[5], f13_x_p1082_lanes[0],
      f13_x_p1082_lanes[0]);
  const Lanes<8> f13_x_p1157_lanes = -detail::make_pack<Real>(-f13_x_p961_lanes[0],
      -f13_x_p959_lanes[0], neg_s12_lanes[0], f13_x_p245_lanes[0], f13_x_p243_lanes[0],
      f13_x_p217_lanes[0], -f13_x_p961_lanes[0], -f13_x_p961_lanes[0]) - inverse_D8_p109_lanes[0] *
      detail::make_pack<Real>(f13_x_p1082_lanes[0], f13_x_p1082_lanes[1], f13_x_p113_lanes[0],
      f13_x_p1082_lanes[3], f13_x_p1082_lanes[4], f13_x_p1082_lanes[5], f13_x_p1082_lanes[0],
      f13_x_p1082_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1175_lanes = c11 * detail::make_pack<Real>(f13_x_p1056_lanes[0],
      f13_x_p1056_lanes[1], f13_x_p1056_lanes[0], f13_x_p1075, f13_x_p1074, f13_x_p1073,
      f13_x_p1056_lanes[0], f13_x_p1056_lanes[0]) - s11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p1092, f13_x_p1081, f13_x_p1080, s13, s13);
  const Lanes<8> f13_x_p1180_lanes = s11 * detail::make_pack<Real>(f13_x_p1056_lanes[0],
      f13_x_p1056_lanes[1], f13_x_p1056_lanes[0], f13_x_p1075, f13_x_p1074, f13_x_p1073,
      f13_x_p1056_lanes[0], f13_x_p1056_lanes[0]) + c11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p1092, f13_x_p1081, f13_x_p1080, s13, s13);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1185 = c16 * f13_x_p1093 - s16 * f13_x_p1094;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1204_lanes = detail::make_pack<Real>(f13_x_p1175_lanes[0],
      f13_x_p1175_lanes[1], f13_x_p163_lanes[0], f13_x_p1175_lanes[3], f13_x_p1175_lanes[4],
      f13_x_p1175_lanes[5], f13_x_p1175_lanes[0], f13_x_p1175_lanes[0]) - inverse_D8_p46_lanes[0] *
      detail::make_pack<Real>(f13_x_p1082_lanes[0], f13_x_p1082_lanes[1], f13_x_p113_lanes[0],
      f13_x_p1082_lanes[3], f13_x_p1082_lanes[4], f13_x_p1082_lanes[5], f13_x_p1082_lanes[0],
      f13_x_p1082_lanes[0]);
  const Lanes<8> f13_x_p1210_lanes = detail::make_pack<Real>(f13_x_p1180_lanes[0],
      f13_x_p1180_lanes[1], f13_x_p146_lanes[0], f13_x_p1180_lanes[3], f13_x_p1180_lanes[4],
      f13_x_p1180_lanes[5], f13_x_p1180_lanes[0], f13_x_p1180_lanes[0]) - inverse_D8_p34_lanes[0] *
      detail::make_pack<Real>(f13_x_p1082_lanes[0], f13_x_p1082_lanes[1], f13_x_p113_lanes[0],
      f13_x_p1082_lanes[3], f13_x_p1082_lanes[4], f13_x_p1082_lanes[5], f13_x_p1082_lanes[0],
      f13_x_p1082_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1216 = -f13_x_p998 + inverse_D6_p27_lanes[1] * f13_x_p997;
  const Real f13_x_p1217 = f13_x_p978 - inverse_D6_p29_lanes[1] * f13_x_p997;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1218 = f13_x_p241_lanes[1] * f13_x_p1185;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1225_lanes = c10 * f13_x_p1129_lanes - s10 * f13_x_p1151_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1243 = -f13_x_p1061 + inverse_D6_p27_lanes[1] * f13_x_p1045;
  const Real f13_x_p1244 = f13_x_p1027 - inverse_D6_p29_lanes[1] * f13_x_p1045;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1245 = s16 * f13_x_p1093 + c16 * f13_x_p1094 - inverse_D7_p8_lanes[1] *
      f13_x_p1185;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1246_lanes = inverse_D8_p130_lanes[0] * f13_x_p1225_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1270_lanes = s10 * f13_x_p1157_lanes - c10 * f13_x_p1204_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1288_lanes = c10 * f13_x_p1151_lanes + s10 * f13_x_p1129_lanes + 0.282 *
      f13_x_p1210_lanes - f13_x_p1246_lanes;
  const Lanes<8> f13_x_p1300_lanes = -f13_x_p1270_lanes + inverse_D6_p27_lanes[0] *
      f13_x_p1225_lanes;
  const Lanes<8> f13_x_p1306_lanes = f13_x_p1210_lanes - inverse_D6_p29_lanes[0] *
      f13_x_p1225_lanes;
  const Lanes<8> f13_x_p1330_lanes = 0.282 * f13_x_p1270_lanes - inverse_D8_p151_lanes[0] *
      f13_x_p1225_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1342 = s15 * f13_x_p1218 + c15 * f13_x_p1245;
  const Real f13_x_p1385 = s16 * f13_x_p1216 + c16 * f13_x_p1217 - inverse_D6_p99_lanes[1] *
      f13_x_p1033;
  const Real f13_x_p1386 = -(-(s17 * f13_x_p979 + c17 * f13_x_p977) + inverse_D6_p19_lanes[1] *
      f13_x_p997) + inverse_D6_p97_lanes[1] * f13_x_p1033;
  const Real f13_x_p1387 = s16 * f13_x_p1243 + c16 * f13_x_p1244 - inverse_D6_p99_lanes[1] *
      f13_x_p1185;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1406_lanes = c9 * f13_x_p1288_lanes - s9 * f13_x_p1330_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1418 = -(-(s17 * f13_x_p1025 + c17 * f13_x_p1026) + inverse_D6_p19_lanes[1] *
      f13_x_p1045) + inverse_D6_p97_lanes[1] * f13_x_p1185;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1425_lanes = -(s10 * f13_x_p1204_lanes + c10 * f13_x_p1157_lanes) +
      inverse_D6_p19_lanes[0] * f13_x_p1225_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1437_lanes = f13_x_p241_lanes[0] * f13_x_p1406_lanes;
  const Lanes<8> f13_x_p1467_lanes = s9 * f13_x_p1288_lanes + c9 * f13_x_p1330_lanes -
      inverse_D7_p8_lanes[0] * f13_x_p1406_lanes;
  const Lanes<8> f13_x_p1479_lanes = s9 * f13_x_p1300_lanes + c9 * f13_x_p1306_lanes -
      inverse_D6_p99_lanes[0] * f13_x_p1406_lanes;
  const Lanes<8> f13_x_p1485_lanes = -f13_x_p1425_lanes + inverse_D6_p97_lanes[0] *
      f13_x_p1406_lanes;
  const Lanes<8> f13_x_p1491_lanes = c9 * f13_x_p1300_lanes - s9 * f13_x_p1306_lanes -
      inverse_D6_p101_lanes[0] * f13_x_p1406_lanes;
  const Lanes<8> f13_x_p1539_lanes = s8 * f13_x_p1437_lanes + c8 * f13_x_p1467_lanes;
  const Lanes<8> f13_x_p1545_lanes = c8 * f13_x_p1485_lanes - s8 * f13_x_p1479_lanes;
  const Lanes<8> f13_x_p1551_lanes = s8 * f13_x_p1485_lanes + c8 * f13_x_p1479_lanes;
  const Lanes<8> f13_x_p1557_lanes = c8 * f13_x_p1437_lanes - s8 * f13_x_p1467_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1595_lanes = detail::make_pack<Real>(f13_x_p414_lanes[0],
      f13_x_p414_lanes[0], f13_x_p414_lanes[0], f13_x_p414_lanes[0], f13_x_p414_lanes[0],
      f13_x_p414_lanes[0], f13_x_p414_lanes[1], f13_x_p414_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1539_lanes[0], f13_x_p1539_lanes[1], f13_x_p1539_lanes[2],
      f13_x_p1539_lanes[3], f13_x_p1539_lanes[4], f13_x_p1539_lanes[5], f13_x_p1342, f13_x_p1110);
  const Lanes<8> f13_x_p1603_lanes = detail::make_pack<Real>(f13_x_p1491_lanes[0],
      f13_x_p1491_lanes[1], f13_x_p1491_lanes[2], f13_x_p1491_lanes[3], f13_x_p1491_lanes[4],
      f13_x_p1491_lanes[5], c16 * f13_x_p1243 - s16 * f13_x_p1244 - inverse_D6_p101_lanes[1] *
      f13_x_p1185, c16 * f13_x_p1216 - s16 * f13_x_p1217 - inverse_D6_p101_lanes[1] * f13_x_p1033) -
      detail::make_pack<Real>(inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0],
      inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0],
      inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[1], inverse_D6_p271_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1539_lanes[0], f13_x_p1539_lanes[1], f13_x_p1539_lanes[2],
      f13_x_p1539_lanes[3], f13_x_p1539_lanes[4], f13_x_p1539_lanes[5], f13_x_p1342, f13_x_p1110);
  const Lanes<8> f13_x_p1611_lanes = detail::make_pack<Real>(f13_x_p1545_lanes[0],
      f13_x_p1545_lanes[1], f13_x_p1545_lanes[2], f13_x_p1545_lanes[3], f13_x_p1545_lanes[4],
      f13_x_p1545_lanes[5], c15 * f13_x_p1418 - s15 * f13_x_p1387, c15 * f13_x_p1386 - s15 *
      f13_x_p1385) - detail::make_pack<Real>(inverse_D6_p269_lanes[0], inverse_D6_p269_lanes[0],
      inverse_D6_p269_lanes[0], inverse_D6_p269_lanes[0], inverse_D6_p269_lanes[0],
      inverse_D6_p269_lanes[0], inverse_D6_p269_lanes[1], inverse_D6_p269_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1539_lanes[0], f13_x_p1539_lanes[1], f13_x_p1539_lanes[2],
      f13_x_p1539_lanes[3], f13_x_p1539_lanes[4], f13_x_p1539_lanes[5], f13_x_p1342, f13_x_p1110);
  const Lanes<8> f13_x_p1619_lanes = detail::make_pack<Real>(f13_x_p1551_lanes[0],
      f13_x_p1551_lanes[1], f13_x_p1551_lanes[2], f13_x_p1551_lanes[3], f13_x_p1551_lanes[4],
      f13_x_p1551_lanes[5], s15 * f13_x_p1418 + c15 * f13_x_p1387, s15 * f13_x_p1386 + c15 *
      f13_x_p1385) - detail::make_pack<Real>(inverse_D6_p273_lanes[0], inverse_D6_p273_lanes[0],
      inverse_D6_p273_lanes[0], inverse_D6_p273_lanes[0], inverse_D6_p273_lanes[0],
      inverse_D6_p273_lanes[0], inverse_D6_p273_lanes[1], inverse_D6_p273_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1539_lanes[0], f13_x_p1539_lanes[1], f13_x_p1539_lanes[2],
      f13_x_p1539_lanes[3], f13_x_p1539_lanes[4], f13_x_p1539_lanes[5], f13_x_p1342, f13_x_p1110);
  const Lanes<8> f13_x_p1627_lanes = detail::make_pack<Real>(f13_x_p1557_lanes[0],
      f13_x_p1557_lanes[1], f13_x_p1557_lanes[2], f13_x_p1557_lanes[3], f13_x_p1557_lanes[4],
      f13_x_p1557_lanes[5], c15 * f13_x_p1218 - s15 * f13_x_p1245, c15 * f13_x_p1038 - s15 *
      f13_x_p1062) - detail::make_pack<Real>(inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0],
      inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0],
      inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[1], inverse_D6_p370_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1539_lanes[0], f13_x_p1539_lanes[1], f13_x_p1539_lanes[2],
      f13_x_p1539_lanes[3], f13_x_p1539_lanes[4], f13_x_p1539_lanes[5], f13_x_p1342, f13_x_p1110);
  const Lanes<8> f13_x_p1707_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1603_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1611_lanes;
  const Lanes<8> f13_x_p1723_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1603_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1611_lanes;
  const Lanes<8> f13_x_p1763_lanes = 0.226 * f13_x_p1619_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      f13_x_p1707_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1787_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1595_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1627_lanes + f13_x_p1763_lanes);
  const Lanes<8> f13_x_p1795_lanes = inverse_D5_p54 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1835_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18,
      (-0.18), (-0.18)) * f13_x_p1723_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * f13_x_p1595_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1627_lanes) - f13_x_p1795_lanes;
  const Lanes<8> f13_x_p1843_lanes = 0.226 * f13_x_p1723_lanes - inverse_D5_p57 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1851_lanes = f13_x_p1723_lanes - inverse_D5_p53 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1859_lanes = f13_x_p1707_lanes + inverse_D4_p34 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1867_lanes = f13_x_p1619_lanes - inverse_D4_p35 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1955_lanes = s6 * f13_x_p1859_lanes + c6 * f13_x_p1867_lanes;
  const Lanes<8> f13_x_p1979_lanes = s6 * f13_x_p1835_lanes + c6 * f13_x_p1843_lanes + 0.072 *
      f13_x_p1851_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2043_lanes = -(0.072 * f13_x_p1955_lanes) + inverse_D4_p59 *
      f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2051_lanes = c6 * f13_x_p1835_lanes - s6 * f13_x_p1843_lanes -
      inverse_D4_p60 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2059_lanes = c6 * f13_x_p1859_lanes - s6 * f13_x_p1867_lanes -
      inverse_D3_p6 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2067_lanes = f13_x_p1851_lanes - inverse_D3_p5 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2075_lanes = f13_x_p1955_lanes - inverse_D3_p7 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2163_lanes = s5 * f13_x_p2059_lanes - c5 * f13_x_p2067_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2187_lanes = -(s5 * f13_x_p2043_lanes + c5 * f13_x_p2051_lanes);
  const Lanes<8> f13_x_p2259_lanes = f13_x_p824_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2271_lanes = f13_x_p720_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2275_lanes = f13_x_p624_lanes * inverse_D6;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2279_lanes = f13_x_p916_lanes * inverse_D3;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2283_lanes = f13_x_p980_lanes * inverse_D2;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2287_lanes = -(s5 * f13_x_p2051_lanes - c5 * f13_x_p2043_lanes +
      0.21799999999999997 * f13_x_p2075_lanes);
  const Lanes<8> f13_x_p2335_lanes = -(s5 * f13_x_p2067_lanes + c5 * f13_x_p2059_lanes) -
      inverse_D2_p7 * f13_x_p2187_lanes;
  const Lanes<8> f13_x_p2355_lanes = f13_x_p2187_lanes * inverse_D4;
  const Lanes<8> f13_x_p2371_lanes = c4 * (-(0.21799999999999997 * f13_x_p2163_lanes) +
      inverse_D3_p37 * f13_x_p2187_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2387_lanes = f13_x_p1979_lanes * inverse_D5;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2395_lanes = s4 * (f13_x_p2075_lanes + inverse_D2_p3 * f13_x_p2187_lanes);

  // link 6 (chest3), force propagation
  const Real f13_x_p2411 = f13_x_p1787_lanes[7] * inverse_D6;
  const Lanes<8> f13_x_p2412_lanes = f13_x_p1787_lanes * inverse_D6;
  const Real f13_x_p2418 = f13_x_p1787_lanes[6] * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2419_lanes = f13_x_p1539_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2433_lanes = f13_x_p1406_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2443_lanes = f13_x_p1225_lanes * inverse_D9_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2449_lanes = s4 * (f13_x_p2287_lanes - inverse_D3_p36 * f13_x_p2187_lanes) +
      f13_x_p2371_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p2457_lanes = detail::make_pack<Real>(f13_x_p1082_lanes[0],
      f13_x_p1082_lanes[1], f13_x_p113_lanes[0], f13_x_p1082_lanes[3], f13_x_p1082_lanes[4],
      f13_x_p1082_lanes[5], f13_x_p1082_lanes[0], f13_x_p1082_lanes[0]) * inverse_D10_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2485_lanes = f13_x_p2419_lanes * f13_x_p1539_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2495_lanes = inverse_D2_p16 * f13_x_p2449_lanes;
  const Lanes<8> f13_x_p2529_lanes = f13_x_p2449_lanes * inverse_D3;
  const Lanes<8> f13_x_p2537_lanes = f13_x_p2279_lanes * f13_x_p2449_lanes[0];
  const Lanes<8> f13_x_p2541_lanes = c4 * (-f13_x_p2163_lanes + inverse_D2_p2 * f13_x_p2187_lanes) -
      f13_x_p2395_lanes - f13_x_p2495_lanes;
  const Lanes<8> f13_x_p2549_lanes = -f13_x_p2335_lanes + inverse_D2_p15 * f13_x_p2449_lanes;
  const Lanes<8> f13_x_p2583_lanes = f13_x_p2275_lanes * f13_x_p1787_lanes[0] + f13_x_p2271_lanes *
      f13_x_p1979_lanes[0] + f13_x_p2259_lanes * f13_x_p2187_lanes[0] + f13_x_p2537_lanes;
  const Lanes<8> f13_x_p2587_lanes = f13_x_p2279_lanes * f13_x_p2449_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2659_lanes = f13_x_p2419_lanes * f13_x_p1539_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2664_lanes = c3 * f13_x_p2541_lanes - s3 * f13_x_p2549_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2680_lanes = f13_x_p2457_lanes * f13_x_p1082_lanes[0] + f13_x_p2443_lanes *
      f13_x_p1225_lanes[0] + f13_x_p2433_lanes * f13_x_p1406_lanes[0] + f13_x_p2485_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2705_lanes = 0.422 * f13_x_p2664_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2713_lanes = f13_x_p2680_lanes + f13_x_p2412_lanes * f13_x_p1787_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2719_lanes = f13_x_p2275_lanes * f13_x_p1787_lanes[1] + f13_x_p2271_lanes *
      f13_x_p1979_lanes[1] + f13_x_p2259_lanes * f13_x_p2187_lanes[1] + f13_x_p2587_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2752_lanes = f13_x_p2705_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2777_lanes = f13_x_p2279_lanes * f13_x_p2449_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2825_lanes = f13_x_p2457_lanes * f13_x_p1082_lanes[1] + f13_x_p2443_lanes *
      f13_x_p1225_lanes[1] + f13_x_p2433_lanes * f13_x_p1406_lanes[1] + f13_x_p2659_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2830_lanes = detail::make_pack<Real>(f13_x_p2713_lanes[0],
      f13_x_p2713_lanes[1], f13_x_p2713_lanes[2], f13_x_p2713_lanes[3], f13_x_p2713_lanes[4],
      f13_x_p2713_lanes[5], f13_x_p2418 * f13_x_p1787_lanes[0], f13_x_p2411 *
      f13_x_p1787_lanes[0]) + f13_x_p2387_lanes * f13_x_p1979_lanes[0] + f13_x_p2355_lanes *
      f13_x_p2187_lanes[0] + f13_x_p2529_lanes * f13_x_p2449_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2865_lanes = s2 * (s3 * f13_x_p2541_lanes + c3 * f13_x_p2549_lanes -
      inverse_D1_p6 * f13_x_p2705_lanes);

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2873_lanes = f13_x_p2825_lanes + f13_x_p2412_lanes * f13_x_p1787_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2902_lanes = f13_x_p2419_lanes * f13_x_p1539_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2960_lanes = 0.434 * (c2 * (f13_x_p2664_lanes - inverse_D1_p2 *
      f13_x_p2705_lanes) - f13_x_p2865_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2968_lanes = f13_x_p2275_lanes * f13_x_p1787_lanes[2] + f13_x_p2271_lanes *
      f13_x_p1979_lanes[2] + f13_x_p2259_lanes * f13_x_p2187_lanes[2] + f13_x_p2777_lanes;
  const Lanes<8> f13_x_p2972_lanes = detail::make_pack<Real>(f13_x_p2873_lanes[1],
      f13_x_p2873_lanes[1], f13_x_p2873_lanes[2], f13_x_p2873_lanes[3], f13_x_p2873_lanes[4],
      f13_x_p2873_lanes[5], f13_x_p2418 * f13_x_p1787_lanes[1], f13_x_p2411 *
      f13_x_p1787_lanes[1]) + f13_x_p2387_lanes * f13_x_p1979_lanes[1] + f13_x_p2355_lanes *
      f13_x_p2187_lanes[1] + f13_x_p2529_lanes * f13_x_p2449_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2987_lanes = f13_x_p2960_lanes * inverse_D1;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3014_lanes = f13_x_p2457_lanes * f13_x_p113_lanes[0] + f13_x_p2443_lanes *
      f13_x_p1225_lanes[2] + f13_x_p2433_lanes * f13_x_p1406_lanes[2] + f13_x_p2902_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3030_lanes = f13_x_p2279_lanes * f13_x_p2449_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3057_lanes = f13_x_p3014_lanes + f13_x_p2412_lanes * f13_x_p1787_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3067_lanes = f13_x_p2583_lanes + f13_x_p2283_lanes * f13_x_p2705_lanes[0] +
      f13_x_p1076_lanes * f13_x_p2960_lanes[0];
  const Lanes<8> f13_x_p3104_lanes = f13_x_p2830_lanes + f13_x_p2752_lanes * f13_x_p2705_lanes[0] +
      f13_x_p2987_lanes * f13_x_p2960_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p3133_lanes = f13_x_p2443_lanes * f13_x_p1225_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p3139_lanes = f13_x_p184_lanes * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p3148_lanes = detail::make_pack<Real>(s13, s13, s13, s13, c13,
      f13_x_p13_lanes[0], s13, s13) * inverse_D12_lanes[0];

  // link 1 (calf), force propagation
  const Real f13_x_p3151 = 1.0 / f13_x_p3104_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3161_lanes = detail::make_pack<Real>(f13_x_p3057_lanes[2],
      f13_x_p3057_lanes[2], f13_x_p3057_lanes[2], f13_x_p3057_lanes[3], f13_x_p3057_lanes[4],
      f13_x_p3057_lanes[5], f13_x_p2418 * f13_x_p1787_lanes[2], f13_x_p2411 *
      f13_x_p1787_lanes[2]) + f13_x_p2387_lanes * f13_x_p1979_lanes[2] + f13_x_p2355_lanes *
      f13_x_p2187_lanes[2] + f13_x_p2529_lanes * f13_x_p2449_lanes[2];
  const Lanes<8> f13_x_p3173_lanes = f13_x_p2275_lanes * f13_x_p1787_lanes[3] + f13_x_p2271_lanes *
      f13_x_p1979_lanes[3] + f13_x_p2259_lanes * f13_x_p2187_lanes[3] + f13_x_p3030_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3203_lanes = f13_x_p3104_lanes * f13_x_p3151;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p3210_lanes = f13_x_p3148_lanes * s13 + f13_x_p3139_lanes *
      f13_x_p184_lanes[3] + f13_x_p2457_lanes * f13_x_p1082_lanes[3] + f13_x_p3133_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3213_lanes = f13_x_p3067_lanes * f13_x_p3151;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3246_lanes = f13_x_p2279_lanes * f13_x_p2449_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3281_lanes = f13_x_p2972_lanes + f13_x_p2752_lanes * f13_x_p2705_lanes[1] +
      f13_x_p2987_lanes * f13_x_p2960_lanes[1] - f13_x_p3203_lanes * f13_x_p3104_lanes[1];
  const Lanes<8> f13_x_p3288_lanes = f13_x_p3161_lanes + f13_x_p2752_lanes * f13_x_p2705_lanes[2] +
      f13_x_p2987_lanes * f13_x_p2960_lanes[2] - f13_x_p3203_lanes * f13_x_p3104_lanes[2];
  const Lanes<8> f13_x_p3294_lanes = f13_x_p2719_lanes + f13_x_p2283_lanes * f13_x_p2705_lanes[1] +
      f13_x_p1076_lanes * f13_x_p2960_lanes[1] - f13_x_p3213_lanes * f13_x_p3104_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3298_lanes = f13_x_p3210_lanes + f13_x_p2433_lanes * f13_x_p1406_lanes[3] +
      f13_x_p2419_lanes * f13_x_p1539_lanes[3] + f13_x_p2412_lanes * f13_x_p1787_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3301_lanes = f13_x_p2968_lanes + f13_x_p2283_lanes * f13_x_p2705_lanes[2] +
      f13_x_p1076_lanes * f13_x_p2960_lanes[2] - f13_x_p3213_lanes * f13_x_p3104_lanes[2];
  const Lanes<8> f13_x_p3309_lanes = f13_x_p3173_lanes + f13_x_p2283_lanes * f13_x_p2705_lanes[3] +
      f13_x_p1076_lanes * f13_x_p2960_lanes[3] - f13_x_p3213_lanes * f13_x_p3104_lanes[3];
  const Real f13_x_p3313 = 1.0 / f13_x_p3281_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p3339_lanes = f13_x_p92_lanes * inverse_D11_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p3357_lanes = detail::make_pack<Real>(f13_x_p3139_lanes[5],
      f13_x_p3339_lanes[3]) * detail::make_pack<Real>(f13_x_p184_lanes[4], f13_x_p92_lanes[2]);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3359_lanes = detail::make_pack<Real>(f13_x_p3298_lanes[3],
      f13_x_p3298_lanes[3], f13_x_p3298_lanes[3], f13_x_p3298_lanes[3], f13_x_p3298_lanes[4],
      f13_x_p3298_lanes[5], f13_x_p2418 * f13_x_p1787_lanes[3], f13_x_p2411 *
      f13_x_p1787_lanes[3]) + f13_x_p2387_lanes * f13_x_p1979_lanes[3] + f13_x_p2355_lanes *
      f13_x_p2187_lanes[3] + f13_x_p2529_lanes * f13_x_p2449_lanes[3];
  const Lanes<8> f13_x_p3364_lanes = f13_x_p2275_lanes * f13_x_p1787_lanes[4] + f13_x_p2271_lanes *
      f13_x_p1979_lanes[4] + f13_x_p2259_lanes * f13_x_p2187_lanes[4] + f13_x_p3246_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3379_lanes = f13_x_p3281_lanes * f13_x_p3313;
  const Lanes<8> f13_x_p3390_lanes = f13_x_p3294_lanes * f13_x_p3313;
  const Lanes<8> f13_x_p3400_lanes = f13_x_p3359_lanes + f13_x_p2752_lanes * f13_x_p2705_lanes[3] +
      f13_x_p2987_lanes * f13_x_p2960_lanes[3] - f13_x_p3203_lanes * f13_x_p3104_lanes[3];
  const Lanes<8> f13_x_p3434_lanes = f13_x_p3364_lanes + f13_x_p2283_lanes * f13_x_p2705_lanes[4] +
      f13_x_p1076_lanes * f13_x_p2960_lanes[4] - f13_x_p3213_lanes * f13_x_p3104_lanes[4];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3446_lanes = f13_x_p2279_lanes * f13_x_p2449_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3468_lanes = f13_x_p3288_lanes - f13_x_p3379_lanes * f13_x_p3281_lanes[2];
  const Lanes<8> f13_x_p3483_lanes = f13_x_p3301_lanes - f13_x_p3390_lanes * f13_x_p3281_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3495_lanes = f13_x_p3148_lanes * c13 +
      detail::make_pack<Real>(f13_x_p3139_lanes[4] * f13_x_p184_lanes[4], f13_x_p3139_lanes[4] *
      f13_x_p184_lanes[4], f13_x_p3139_lanes[4] * f13_x_p184_lanes[4], f13_x_p3139_lanes[4] *
      f13_x_p184_lanes[4], f13_x_p3139_lanes[4] * f13_x_p184_lanes[4], f13_x_p3357_lanes[0],
      f13_x_p3139_lanes[4] * f13_x_p184_lanes[4], f13_x_p3139_lanes[4] * f13_x_p184_lanes[4]) +
      detail::make_pack<Real>(f13_x_p2457_lanes[4] * f13_x_p1082_lanes[4], f13_x_p2457_lanes[4] *
      f13_x_p1082_lanes[4], f13_x_p2457_lanes[4] * f13_x_p1082_lanes[4], f13_x_p2457_lanes[4] *
      f13_x_p1082_lanes[4], f13_x_p2457_lanes[4] * f13_x_p1082_lanes[4], f13_x_p2457_lanes[5] *
      f13_x_p1082_lanes[4], f13_x_p2457_lanes[4] * f13_x_p1082_lanes[4], f13_x_p2457_lanes[4] *
      f13_x_p1082_lanes[4]) + detail::make_pack<Real>(f13_x_p2443_lanes[4] * f13_x_p1225_lanes[4],
      f13_x_p2443_lanes[4] * f13_x_p1225_lanes[4], f13_x_p2443_lanes[4] * f13_x_p1225_lanes[4],
      f13_x_p2443_lanes[4] * f13_x_p1225_lanes[4], f13_x_p2443_lanes[4] * f13_x_p1225_lanes[4],
      f13_x_p2443_lanes[5] * f13_x_p1225_lanes[4], f13_x_p2443_lanes[4] * f13_x_p1225_lanes[4],
      f13_x_p2443_lanes[4] * f13_x_p1225_lanes[4]) + detail::make_pack<Real>(f13_x_p2433_lanes[4] *
      f13_x_p1406_lanes[4], f13_x_p2433_lanes[4] * f13_x_p1406_lanes[4], f13_x_p2433_lanes[4] *
      f13_x_p1406_lanes[4], f13_x_p2433_lanes[4] * f13_x_p1406_lanes[4], f13_x_p2433_lanes[4] *
      f13_x_p1406_lanes[4], f13_x_p2433_lanes[5] * f13_x_p1406_lanes[4], f13_x_p2433_lanes[4] *
      f13_x_p1406_lanes[4], f13_x_p2433_lanes[4] * f13_x_p1406_lanes[4]) +
      detail::make_pack<Real>(f13_x_p2419_lanes[4] * f13_x_p1539_lanes[4], f13_x_p2419_lanes[4] *
      f13_x_p1539_lanes[4], f13_x_p2419_lanes[4] * f13_x_p1539_lanes[4], f13_x_p2419_lanes[4] *
      f13_x_p1539_lanes[4], f13_x_p2419_lanes[4] * f13_x_p1539_lanes[4], f13_x_p2419_lanes[5] *
      f13_x_p1539_lanes[4], f13_x_p2419_lanes[4] * f13_x_p1539_lanes[4], f13_x_p2419_lanes[4] *
      f13_x_p1539_lanes[4]);

  // link 1 (calf), force propagation
  const Real f13_x_p3497 = 1.0 / f13_x_p3468_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3502_lanes = f13_x_p3495_lanes +
      detail::make_pack<Real>(f13_x_p2412_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2412_lanes[4] *
      f13_x_p1787_lanes[4], f13_x_p2412_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2412_lanes[4] *
      f13_x_p1787_lanes[4], f13_x_p2412_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2412_lanes[5] *
      f13_x_p1787_lanes[4], f13_x_p2412_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2412_lanes[4] *
      f13_x_p1787_lanes[4]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3533_lanes = f13_x_p496_lanes * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p3541_lanes = f13_x_p420_lanes * inverse_D8_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3545_lanes = f13_x_p2275_lanes * f13_x_p1787_lanes[5] + f13_x_p2271_lanes *
      f13_x_p1979_lanes[5] + f13_x_p2259_lanes * f13_x_p2187_lanes[5] + f13_x_p3446_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p3549_lanes = f13_x_p294_lanes * inverse_D9_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3553_lanes = detail::make_pack<Real>(f13_x_p3502_lanes[4],
      f13_x_p3502_lanes[4], f13_x_p3502_lanes[4], f13_x_p3502_lanes[4], f13_x_p3502_lanes[4],
      f13_x_p3502_lanes[5], f13_x_p2418 * f13_x_p1787_lanes[4], f13_x_p2411 *
      f13_x_p1787_lanes[4]) + f13_x_p2387_lanes * f13_x_p1979_lanes[4] + f13_x_p2355_lanes *
      f13_x_p2187_lanes[4] + f13_x_p2529_lanes * f13_x_p2449_lanes[4];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p3557_lanes = detail::make_pack<Real>(f13_x_p113_lanes[1],
      f13_x_p203_lanes[1], f13_x_p203_lanes[2], f13_x_p203_lanes[3], f13_x_p113_lanes[1],
      f13_x_p113_lanes[1], f13_x_p113_lanes[1], f13_x_p113_lanes[1]) * inverse_D10_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p3565_lanes = detail::make_pack<Real>(s20, s20, c20, f13_x_p13_lanes[1], s20,
      s20, s20, s20) * inverse_D12_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3576_lanes = f13_x_p3468_lanes * f13_x_p3497;
  const Lanes<8> f13_x_p3581_lanes = f13_x_p3483_lanes * f13_x_p3497;
  const Lanes<8> f13_x_p3621_lanes = f13_x_p3545_lanes + f13_x_p2283_lanes * f13_x_p2705_lanes[5] +
      f13_x_p1076_lanes * f13_x_p2960_lanes[5] - f13_x_p3213_lanes * f13_x_p3104_lanes[5];
  const Lanes<8> f13_x_p3631_lanes = f13_x_p3553_lanes + f13_x_p2752_lanes * f13_x_p2705_lanes[4] +
      f13_x_p2987_lanes * f13_x_p2960_lanes[4] - f13_x_p3203_lanes * f13_x_p3104_lanes[4];
  const Lanes<8> f13_x_p3635_lanes = f13_x_p3400_lanes - f13_x_p3379_lanes * f13_x_p3281_lanes[3] -
      f13_x_p3576_lanes * f13_x_p3468_lanes[3];
  const Lanes<8> f13_x_p3644_lanes = f13_x_p3309_lanes - f13_x_p3390_lanes * f13_x_p3281_lanes[3] -
      f13_x_p3581_lanes * f13_x_p3468_lanes[3];
  const Real f13_x_p3674 = 1.0 / f13_x_p3635_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3683_lanes = f13_x_p3533_lanes * f13_x_p1342;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p3703_lanes = 1065.380700001509 +
      detail::make_pack<Real>(f13_x_p3148_lanes[5], f13_x_p3565_lanes[3]) * f13_x_p13_lanes +
      detail::make_pack<Real>(f13_x_p3139_lanes[5], f13_x_p3339_lanes[3]) *
      detail::make_pack<Real>(f13_x_p184_lanes[5], f13_x_p92_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2457_lanes[5], f13_x_p3557_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1082_lanes[5], f13_x_p203_lanes[3]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p3733_lanes = f13_x_p3703_lanes +
      detail::make_pack<Real>(f13_x_p2443_lanes[5], f13_x_p3549_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1225_lanes[5], f13_x_p294_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2433_lanes[5], f13_x_p3541_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1406_lanes[5], f13_x_p420_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2419_lanes[5], f13_x_p3533_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1539_lanes[5], f13_x_p496_lanes[3]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3735_lanes = f13_x_p3557_lanes * f13_x_p1013 + f13_x_p3549_lanes *
      f13_x_p1045 + f13_x_p3541_lanes * f13_x_p1185 + f13_x_p3683_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3739_lanes = f13_x_p3635_lanes * f13_x_p3674;
  const Lanes<8> f13_x_p3743_lanes = f13_x_p3644_lanes * f13_x_p3674;
  const Lanes<8> f13_x_p3764_lanes = f13_x_p3631_lanes - f13_x_p3379_lanes * f13_x_p3281_lanes[4] -
      f13_x_p3576_lanes * f13_x_p3468_lanes[4] - f13_x_p3739_lanes * f13_x_p3635_lanes[4];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3784_lanes = detail::make_pack<Real>(f13_x_p3733_lanes[0] +
      f13_x_p2412_lanes[5] * f13_x_p1787_lanes[5], f13_x_p3733_lanes[0] + f13_x_p2412_lanes[5] *
      f13_x_p1787_lanes[5], f13_x_p3733_lanes[0] + f13_x_p2412_lanes[5] * f13_x_p1787_lanes[5],
      f13_x_p3733_lanes[0] + f13_x_p2412_lanes[5] * f13_x_p1787_lanes[5], f13_x_p3733_lanes[0] +
      f13_x_p2412_lanes[5] * f13_x_p1787_lanes[5], f13_x_p3733_lanes[0] + f13_x_p2412_lanes[5] *
      f13_x_p1787_lanes[5], f13_x_p2418 * f13_x_p1787_lanes[5], f13_x_p2411 *
      f13_x_p1787_lanes[5]) + f13_x_p2387_lanes * f13_x_p1979_lanes[5] + f13_x_p2355_lanes *
      f13_x_p2187_lanes[5] + f13_x_p2529_lanes * f13_x_p2449_lanes[5];

  // link 1 (calf), force propagation
  const Real f13_x_p3787 = 1.0 / f13_x_p3764_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3788_lanes = f13_x_p3735_lanes + f13_x_p2275_lanes * f13_x_p1787_lanes[6] +
      f13_x_p2271_lanes * f13_x_p1979_lanes[6] + f13_x_p2259_lanes * f13_x_p2187_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3795_lanes = f13_x_p3434_lanes - f13_x_p3390_lanes * f13_x_p3281_lanes[4] -
      f13_x_p3581_lanes * f13_x_p3468_lanes[4] - f13_x_p3743_lanes * f13_x_p3635_lanes[4];
  const Lanes<8> f13_x_p3799_lanes = f13_x_p3621_lanes - f13_x_p3390_lanes * f13_x_p3281_lanes[5] -
      f13_x_p3581_lanes * f13_x_p3468_lanes[5] - f13_x_p3743_lanes * f13_x_p3635_lanes[5];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3814 = f13_x_p1013 * inverse_D10_lanes[1] * f13_x_p1013 + f13_x_p1045 *
      inverse_D9_lanes[1] * f13_x_p1045 + f13_x_p1185 * inverse_D8_lanes[1] * f13_x_p1185;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3815_lanes = f13_x_p3784_lanes + f13_x_p2752_lanes * f13_x_p2705_lanes[5] +
      f13_x_p2987_lanes * f13_x_p2960_lanes[5] - f13_x_p3203_lanes * f13_x_p3104_lanes[5];
  const Lanes<8> f13_x_p3818_lanes = f13_x_p3788_lanes + f13_x_p2279_lanes * f13_x_p2449_lanes[6] +
      f13_x_p2283_lanes * f13_x_p2705_lanes[6] + f13_x_p1076_lanes * f13_x_p2960_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p3825 = f13_x_p1110 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3826 = f13_x_p1033 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p3827 = f13_x_p997 * inverse_D9_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3828_lanes = f13_x_p3764_lanes * f13_x_p3787;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p3831 = f13_x_p942 * inverse_D10_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3832_lanes = f13_x_p3795_lanes * f13_x_p3787;
  const Lanes<8> f13_x_p3850_lanes = f13_x_p3815_lanes - f13_x_p3379_lanes * f13_x_p3281_lanes[5] -
      f13_x_p3576_lanes * f13_x_p3468_lanes[5] - f13_x_p3739_lanes * f13_x_p3635_lanes[5];
  const Lanes<8> f13_x_p3861_lanes = f13_x_p3818_lanes - f13_x_p3213_lanes * f13_x_p3104_lanes[6] -
      f13_x_p3390_lanes * f13_x_p3281_lanes[6] - f13_x_p3581_lanes * f13_x_p3468_lanes[6];

  // link 4 (chest1), force propagation
  const Real f13_x_p3865 = f13_x_p3814 + f13_x_p1342 * inverse_D7_lanes[1] * f13_x_p1342 +
      f13_x_p2418 * f13_x_p1787_lanes[6] + f13_x_p2387_lanes[6] * f13_x_p1979_lanes[6] +
      f13_x_p2355_lanes[6] * f13_x_p2187_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3878_lanes = f13_x_p3850_lanes - f13_x_p3828_lanes * f13_x_p3764_lanes[5];
  const Real f13_x_p3917 = 1.0 / f13_x_p3878_lanes[5];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3918_lanes = f13_x_p3533_lanes * f13_x_p1110;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3922_lanes = f13_x_p3799_lanes - f13_x_p3832_lanes * f13_x_p3764_lanes[5];

  // link 6 (chest3), force propagation
  const Real f13_x_p3946 = f13_x_p3831 * f13_x_p1013 + f13_x_p3827 * f13_x_p1045 + f13_x_p3826 *
      f13_x_p1185 + f13_x_p3825 * f13_x_p1342 + f13_x_p2411 * f13_x_p1787_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p3951 = f13_x_p3865 + f13_x_p2529_lanes[6] * f13_x_p2449_lanes[6] +
      f13_x_p2752_lanes[6] * f13_x_p2705_lanes[6] + f13_x_p2987_lanes[6] * f13_x_p2960_lanes[6] -
      f13_x_p3203_lanes[6] * f13_x_p3104_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3952_lanes = f13_x_p3557_lanes * f13_x_p942 + f13_x_p3549_lanes *
      f13_x_p997 + f13_x_p3541_lanes * f13_x_p1033 + f13_x_p3918_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p3960 = f13_x_p3878_lanes[6] * f13_x_p3917;
  const Real f13_x_p3965 = f13_x_p3878_lanes[7] * f13_x_p3917;
  const Lanes<8> f13_x_p3966_lanes = f13_x_p3922_lanes * f13_x_p3917;

  // link 2 (thigh), force propagation
  const Real f13_x_p3970 = f13_x_p3946 + f13_x_p2387_lanes[7] * f13_x_p1979_lanes[6] +
      f13_x_p2355_lanes[7] * f13_x_p2187_lanes[6] + f13_x_p2529_lanes[7] * f13_x_p2449_lanes[6] +
      f13_x_p2752_lanes[7] * f13_x_p2705_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3971_lanes = f13_x_p3952_lanes + f13_x_p2275_lanes * f13_x_p1787_lanes[7] +
      f13_x_p2271_lanes * f13_x_p1979_lanes[7] + f13_x_p2259_lanes * f13_x_p2187_lanes[7];

  // link 1 (calf), force propagation
  const Real f13_x_p3975 = f13_x_p3951 - f13_x_p3379_lanes[6] * f13_x_p3281_lanes[6] -
      f13_x_p3576_lanes[6] * f13_x_p3468_lanes[6] - f13_x_p3739_lanes[6] * f13_x_p3635_lanes[6] -
      f13_x_p3828_lanes[6] * f13_x_p3764_lanes[6];
  const Real f13_x_p4020 = 1.0 / (f13_x_p3975 - f13_x_p3960 * f13_x_p3878_lanes[6]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4021_lanes = f13_x_p3533_lanes * f13_x_p496_lanes[0];

  // link 6 (chest3), force propagation
  const Real f13_x_p4049 = f13_x_p3831 * f13_x_p942 + f13_x_p3827 * f13_x_p997 + f13_x_p3826 *
      f13_x_p1033 + f13_x_p3825 * f13_x_p1110 + f13_x_p2411 * f13_x_p1787_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4054_lanes = f13_x_p3861_lanes - f13_x_p3743_lanes * f13_x_p3635_lanes[6] -
      f13_x_p3832_lanes * f13_x_p3764_lanes[6] - f13_x_p3966_lanes * f13_x_p3878_lanes[6];
  const Lanes<8> f13_x_p4062_lanes = f13_x_p3971_lanes + f13_x_p2279_lanes * f13_x_p2449_lanes[7] +
      f13_x_p2283_lanes * f13_x_p2705_lanes[7] + f13_x_p1076_lanes * f13_x_p2960_lanes[7];
  const Real f13_x_p4070 = f13_x_p3970 + f13_x_p2987_lanes[7] * f13_x_p2960_lanes[6] -
      f13_x_p3203_lanes[7] * f13_x_p3104_lanes[6] - f13_x_p3379_lanes[7] * f13_x_p3281_lanes[6] -
      f13_x_p3576_lanes[7] * f13_x_p3468_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4083_lanes = f13_x_p3557_lanes * f13_x_p113_lanes[1] + f13_x_p3549_lanes *
      f13_x_p294_lanes[0] + f13_x_p3541_lanes * f13_x_p420_lanes[0] + f13_x_p4021_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4087_lanes = f13_x_p4062_lanes - f13_x_p3213_lanes * f13_x_p3104_lanes[7] -
      f13_x_p3390_lanes * f13_x_p3281_lanes[7] - f13_x_p3581_lanes * f13_x_p3468_lanes[7];
  const Lanes<8> f13_x_p4091_lanes = f13_x_p4054_lanes * f13_x_p4020;

  // link 2 (thigh), force propagation
  const Real f13_x_p4101 = f13_x_p4049 + f13_x_p2387_lanes[7] * f13_x_p1979_lanes[7] +
      f13_x_p2355_lanes[7] * f13_x_p2187_lanes[7] + f13_x_p2529_lanes[7] * f13_x_p2449_lanes[7] +
      f13_x_p2752_lanes[7] * f13_x_p2705_lanes[7];

  // link 1 (calf), force propagation
  const Real f13_x_p4106 = f13_x_p4070 - f13_x_p3739_lanes[7] * f13_x_p3635_lanes[6] -
      f13_x_p3828_lanes[7] * f13_x_p3764_lanes[6] - f13_x_p3965 * f13_x_p3878_lanes[6];
  const Real f13_x_p4148 = f13_x_p4106 * f13_x_p4020;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p4149_lanes = f13_x_p3549_lanes * f13_x_p294_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p4170_lanes = f13_x_p4083_lanes + f13_x_p2275_lanes * f13_x_p624_lanes[0] +
      f13_x_p2271_lanes * f13_x_p720_lanes[0] + f13_x_p2259_lanes * f13_x_p824_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4186_lanes = f13_x_p4087_lanes - f13_x_p3743_lanes * f13_x_p3635_lanes[7] -
      f13_x_p3832_lanes * f13_x_p3764_lanes[7] - f13_x_p3966_lanes * f13_x_p3878_lanes[7];
  const Lanes<8> f13_x_p4197_lanes = f13_x_p4186_lanes - f13_x_p4091_lanes * f13_x_p4106;
  const Real f13_x_p4201 = f13_x_p4101 + f13_x_p2987_lanes[7] * f13_x_p2960_lanes[7] -
      f13_x_p3203_lanes[7] * f13_x_p3104_lanes[7] - f13_x_p3379_lanes[7] * f13_x_p3281_lanes[7] -
      f13_x_p3576_lanes[7] * f13_x_p3468_lanes[7];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p4206_lanes = f13_x_p3565_lanes * s20 + f13_x_p3339_lanes *
      f13_x_p92_lanes[1] + f13_x_p3557_lanes * f13_x_p203_lanes[1] + f13_x_p4149_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4209_lanes = f13_x_p4170_lanes + f13_x_p2279_lanes * f13_x_p916_lanes[0] +
      f13_x_p2283_lanes * f13_x_p980_lanes[0] + f13_x_p1076_lanes * f13_x_p1039_lanes[0];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p4223_lanes = f13_x_p3565_lanes * c20;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4229_lanes = f13_x_p4206_lanes + f13_x_p3541_lanes * f13_x_p420_lanes[1] +
      f13_x_p3533_lanes * f13_x_p496_lanes[1] + f13_x_p2275_lanes * f13_x_p624_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p4232 = f13_x_p4201 - f13_x_p3739_lanes[7] * f13_x_p3635_lanes[7] -
      f13_x_p3828_lanes[7] * f13_x_p3764_lanes[7] - f13_x_p3965 * f13_x_p3878_lanes[7] -
      f13_x_p4148 * f13_x_p4106;
  const Lanes<8> f13_x_p4233_lanes = f13_x_p4209_lanes - f13_x_p3213_lanes * f13_x_p3067_lanes[0] -
      f13_x_p3390_lanes * f13_x_p3294_lanes[0] - f13_x_p3581_lanes * f13_x_p3483_lanes[0];
  const Real f13_x_p4240 = 1.0 / f13_x_p4232;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4252_lanes = f13_x_p4229_lanes + f13_x_p2271_lanes * f13_x_p720_lanes[1] +
      f13_x_p2259_lanes * f13_x_p824_lanes[1] + f13_x_p2279_lanes * f13_x_p916_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4255_lanes = f13_x_p4233_lanes - f13_x_p3743_lanes * f13_x_p3644_lanes[0] -
      f13_x_p3832_lanes * f13_x_p3795_lanes[0] - f13_x_p3966_lanes * f13_x_p3922_lanes[0];

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p4262 = f13_x_p4223_lanes[3] + f13_x_p3357_lanes[1] + f13_x_p3557_lanes[3] *
      f13_x_p203_lanes[2] + f13_x_p3549_lanes[3] * f13_x_p294_lanes[2] + f13_x_p3541_lanes[3] *
      f13_x_p420_lanes[2] + f13_x_p3533_lanes[3] * f13_x_p496_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4270_lanes = f13_x_p4197_lanes * f13_x_p4240;
  const Lanes<8> f13_x_p4274_lanes = f13_x_p4252_lanes + f13_x_p2283_lanes * f13_x_p980_lanes[1] +
      f13_x_p1076_lanes * f13_x_p1039_lanes[1] - f13_x_p3213_lanes * f13_x_p3067_lanes[1];
  const Lanes<8> f13_x_p4290_lanes = f13_x_p4255_lanes - f13_x_p4091_lanes * f13_x_p4054_lanes[0] -
      f13_x_p4270_lanes * f13_x_p4197_lanes[0];
  const Lanes<8> f13_x_p4294_lanes = f13_x_p4274_lanes - f13_x_p3390_lanes * f13_x_p3294_lanes[1] -
      f13_x_p3581_lanes * f13_x_p3483_lanes[1] - f13_x_p3743_lanes * f13_x_p3644_lanes[1];

  // link 3 (hip), force propagation
  const Real f13_x_p4297 = f13_x_p4262 + f13_x_p2275_lanes[3] * f13_x_p624_lanes[2] +
      f13_x_p2271_lanes[3] * f13_x_p720_lanes[2] + f13_x_p2259_lanes[3] * f13_x_p824_lanes[2] +
      f13_x_p2279_lanes[3] * f13_x_p916_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p4298 = 1.0 / f13_x_p4290_lanes[0];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4302 = f13_x_p4223_lanes[2] + f13_x_p3339_lanes[2] * f13_x_p92_lanes[2] +
      f13_x_p3557_lanes[2] * f13_x_p203_lanes[2] + f13_x_p3549_lanes[2] * f13_x_p294_lanes[2] +
      f13_x_p3541_lanes[2] * f13_x_p420_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4308_lanes = 9.81 + detail::make_pack<Real>(xdd_cmd[2], xdd_cmd[8]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4310_lanes = f13_x_p4294_lanes - f13_x_p3832_lanes * f13_x_p3795_lanes[1] -
      f13_x_p3966_lanes * f13_x_p3922_lanes[1] - f13_x_p4091_lanes * f13_x_p4054_lanes[1];
  const Real f13_x_p4322 = f13_x_p4297 + f13_x_p2283_lanes[3] * f13_x_p980_lanes[2] +
      f13_x_p1076_lanes[3] * f13_x_p1039_lanes[2] - f13_x_p3213_lanes[3] * f13_x_p3067_lanes[2] -
      f13_x_p3390_lanes[3] * f13_x_p3294_lanes[2];
  const Lanes<8> f13_x_p4323_lanes = f13_x_p4290_lanes * f13_x_p4298;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4326_lanes = c1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) - s1 *
      f13_x_p4308_lanes;
  const Lanes<2> f13_x_p4328_lanes = s1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) + c1 *
      f13_x_p4308_lanes;

  // link 4 (chest1), force propagation
  const Real f13_x_p4330 = f13_x_p4302 + f13_x_p3533_lanes[2] * f13_x_p496_lanes[2] +
      f13_x_p2275_lanes[2] * f13_x_p624_lanes[2] + f13_x_p2271_lanes[2] * f13_x_p720_lanes[2] +
      f13_x_p2259_lanes[2] * f13_x_p824_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4344_lanes = c2 * f13_x_p4326_lanes - s2 * f13_x_p4328_lanes;
  const Lanes<2> f13_x_p4346_lanes = s2 * f13_x_p4326_lanes + c2 * f13_x_p4328_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4350_lanes = f13_x_p4310_lanes - f13_x_p4270_lanes * f13_x_p4197_lanes[1] -
      f13_x_p4323_lanes * f13_x_p4290_lanes[1];
  const Real f13_x_p4361 = 1.0 / f13_x_p4350_lanes[1];
  const Real f13_x_p4362 = f13_x_p4322 - f13_x_p3581_lanes[3] * f13_x_p3483_lanes[2] -
      f13_x_p3743_lanes[3] * f13_x_p3644_lanes[2] - f13_x_p3832_lanes[3] * f13_x_p3795_lanes[2] -
      f13_x_p3966_lanes[3] * f13_x_p3922_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4363_lanes = c3 * f13_x_p4344_lanes - s3 * f13_x_p4346_lanes;
  const Lanes<2> f13_x_p4365_lanes = s3 * f13_x_p4344_lanes + c3 * f13_x_p4346_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4367 = f13_x_p4330 + f13_x_p2279_lanes[2] * f13_x_p916_lanes[2] +
      f13_x_p2283_lanes[2] * f13_x_p980_lanes[2] + f13_x_p1076_lanes[2] * f13_x_p1039_lanes[2] -
      f13_x_p3213_lanes[2] * f13_x_p3067_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4376_lanes = c4 * f13_x_p4363_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Lanes<2> f13_x_p4378_lanes = c4 * detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]) - s4 *
      f13_x_p4363_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4388 = f13_x_p4350_lanes[2] * f13_x_p4361;
  const Real f13_x_p4389 = f13_x_p4350_lanes[3] * f13_x_p4361;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4390_lanes = s5 * f13_x_p4376_lanes + c5 * f13_x_p4365_lanes;
  const Lanes<2> f13_x_p4392_lanes = c5 * f13_x_p4376_lanes - s5 * f13_x_p4365_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4394 = f13_x_p4367 - f13_x_p3390_lanes[2] * f13_x_p3294_lanes[2] -
      f13_x_p3581_lanes[2] * f13_x_p3483_lanes[2] - f13_x_p3743_lanes[2] * f13_x_p3644_lanes[2] -
      f13_x_p3832_lanes[2] * f13_x_p3795_lanes[2];
  const Real f13_x_p4403 = f13_x_p4362 - f13_x_p4091_lanes[3] * f13_x_p4054_lanes[2] -
      f13_x_p4270_lanes[3] * f13_x_p4197_lanes[2] - f13_x_p4323_lanes[3] * f13_x_p4290_lanes[2] -
      f13_x_p4389 * f13_x_p4350_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4404_lanes = s6 * f13_x_p4378_lanes - c6 * f13_x_p4390_lanes;
  const Lanes<2> f13_x_p4406_lanes = s6 * f13_x_p4390_lanes + c6 * f13_x_p4378_lanes;

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];
  const Real a2_y_p1 = 0.434 * qdd_0[0] - minus_a1_x;
  const Real a3_x_p1 = w2_z * w2_z;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4416_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4404_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4392_lanes;

  // link 2 (thigh), outward
  const Real a2_y_p2 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4418_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p4404_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p4392_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4420 = f13_x_p4394 - f13_x_p3966_lanes[2] * f13_x_p3922_lanes[2] -
      f13_x_p4091_lanes[2] * f13_x_p4054_lanes[2] - f13_x_p4270_lanes[2] * f13_x_p4197_lanes[2] -
      f13_x_p4323_lanes[2] * f13_x_p4290_lanes[2];

  // link 2 (thigh), outward
  const Real wd2_z = qdd_0[0] + qdd_0[1];

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_y = c4 * w3_z;
  const Real w4_x = s4 * w3_z;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4429_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4406_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p4416_lanes;
  const Lanes<2> f13_x_p4431_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4416_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p4406_lanes;

  // link 2 (thigh), outward
  const Real a2_y = c2 * a2_y_p2 - s2 * a2_y_p1;

  // link 3 (hip), outward
  const Real wd3_z = wd2_z + qdd_0[2];

  // link 2 (thigh), outward
  const Real a2_x = c2 * a2_y_p1 + s2 * a2_y_p2;

  // link 1 (calf), force propagation
  const Real f13_x_p4433 = 1.0 / (f13_x_p4420 - f13_x_p4388 * f13_x_p4350_lanes[2]);

  // link 3 (hip), outward
  const Real a3_x_p2 = a2_y + 0.422 * a3_x_p1;
  const Real a3_x_p3 = a2_x + 0.422 * wd2_z;

  // link 4 (chest1), outward
  const Real a5_y_p1 = c4 * wd3_z;
  const Real a5_y_p2 = w4_x * w4_x;
  const Real a5_y_p3 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (chest1), outward
  const Real minus_a5_z_p1 = s4 * wd3_z;

  // link 5 (chest2), outward
  const Real w5_x = c5 * w4_x - s5 * qd[3];

  // link 4 (chest1), outward
  const Real wd4_x_p1 = w4_y * qd[3];

  // link 5 (chest2), outward
  const Real a6_x_p1 = w5_z * w5_z;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4442_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4429_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4418_lanes;
  const Lanes<2> f13_x_p4444_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4429_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4418_lanes;

  // link 3 (hip), outward
  const Real a3_x = c3 * a3_x_p3 + s3 * a3_x_p2;

  // link 5 (chest2), outward
  const Real a6_x_p2 = w5_x * w5_x;

  // link 4 (chest1), outward
  const Real wd4_x = minus_a5_z_p1 + wd4_x_p1;

  // link 3 (hip), outward
  const Real a3_y = c3 * a3_x_p2 - s3 * a3_x_p3;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p2 + a6_x_p1;

  // link 5 (chest2), outward
  const Real a5_y_p4 = a3_y + 0.21799999999999997 * (a5_y_p2 + a5_y_p3);

  // link 6 (chest3), outward
  const Real a7_y_p1 = w6_z * w6_z;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4454_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4442_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4431_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4456 = f13_x_p4403 * f13_x_p4433;

  // link 5 (chest2), outward
  const Real a5_y_p5 = a4_x + 0.21799999999999997 * a5_y_p1;

  // link 4 (chest1), outward
  const Real wd4_y_p1 = w4_x * qd[3];

  // link 5 (chest2), outward
  const Real a6_z_p1 = w5_x * minus_w5_y;
  const Real minus_a5_z = minus_a4_y + 0.21799999999999997 * minus_a5_z_p1;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4457_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4431_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4442_lanes;

  // link 6 (chest3), outward
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;

  // link 4 (chest1), outward
  const Real wd4_y = a5_y_p1 - wd4_y_p1;

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd4_x - s5 * qdd_0[3] - minus_w5_y * qd[4];

  // link 6 (chest3), outward
  const Real a7_y_p2 = w6_x * w6_y;
  const Real a7_y_p3 = w6_y * w6_z;

  // link 5 (chest2), outward
  const Real wd5_z = wd4_y + qdd_0[4];
  const Real a6_x_p4 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real wd6_z = wd5_x + qdd_0[5];

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p4 - s5 * a5_y_p5;
  const Real a5_x = c5 * a5_y_p5 + s5 * a5_y_p4;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4463_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4454_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4444_lanes;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + c5 * qdd_0[3] + w5_x * qd[4];

  // link 7 (left_shoulder1), outward
  const Real a7_y_p4 = w6_y * w6_y + a7_y_p1;

  // link 6 (chest3), outward
  const Real a6_x_p5 = a5_y + 0.072 * a6_x_p3;

  // link 5 (chest2), outward
  const Real a6_z_p2 = a6_z_p1 + wd5_z;

  // link 6 (chest3), outward
  const Real a7_y_p5 = a7_y_p2 - wd6_z;
  const Real minus_a7_z_p1 = a7_y_p2 + wd6_z;
  const Real minus_a7_z_p2 = w6_x * w6_x;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4469_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4444_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4454_lanes;

  // link 6 (chest3), outward
  const Real a6_x_p6 = minus_a5_z + 0.072 * a6_x_p4;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4471_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4457_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4463_lanes;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p3 = minus_a7_z_p2 + a7_y_p1;

  // link 6 (chest3), outward
  const Real a6_z = a5_x + 0.072 * a6_z_p2;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);

  // link 6 (chest3), outward
  const Real wd6_x = s6 * wd5_z - c6 * minus_wd5_y + w6_y * qd[5];

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;

  // link 6 (chest3), outward
  const Real wd6_y = s6 * minus_wd5_y + c6 * wd5_z - w6_x * qd[5];

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a6_x_p5 - s6 * a6_x_p6;
  const Real a7_y_p7 = w6_x * w6_z - wd6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_z_lanes = wd6_y + detail::make_pack<Real>(qdd_0[6], qdd_0[13]);

  // link 6 (chest3), outward
  const Real a7_y_p8 = a7_y_p3 + wd6_x;
  const Real minus_a6_y = s6 * a6_x_p5 + c6 * a6_x_p6;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p9 = a6_x + 0.226 * a7_y_p4;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 14 (right_shoulder1), outward
  const Real minus_a7_z_p5 = minus_a6_y + 0.226 * minus_a7_z_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p11_lanes = a7_y_p9 + detail::make_pack<Real>(0.18, (-0.18)) * a7_y_p5;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_y_lanes = detail::make_pack<Real>(c7, c14) * wd6_x -
      detail::make_pack<Real>(s7, s14) * wd6_z - w7_x_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);

  // link 14 (right_shoulder1), outward
  const Real a7_y_p12 = a6_z - 0.226 * a7_y_p7;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p5 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p3;
  const Lanes<2> wd7_x_lanes = detail::make_pack<Real>(s7, s14) * wd6_x +
      detail::make_pack<Real>(c7, c14) * wd6_z + w7_y_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p14_lanes = a7_y_p12 + detail::make_pack<Real>(0.18, (-0.18)) * a7_y_p8;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_z_lanes = wd7_x_lanes + detail::make_pack<Real>(qdd_0[7], qdd_0[14]);

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_y_lanes = detail::make_pack<Real>(c9, c16) * w8_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_z_lanes;
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;
  const Lanes<2> a10_x_p1_lanes = w9_x_lanes * w9_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_y_lanes = detail::make_pack<Real>(c8, c15) * wd7_z_lanes -
      detail::make_pack<Real>(s8, s15) * wd7_y_lanes - w8_x_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p11_lanes -
      detail::make_pack<Real>(s7, s14) * a7_y_p14_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a10_x_p2_lanes = w9_x_lanes * w9_x_lanes;
  const Lanes<2> a10_x_p3_lanes = w9_y_lanes * w9_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p11_lanes +
      detail::make_pack<Real>(c7, c14) * a7_y_p14_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a10_z_p1_lanes = w9_y_lanes * w9_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_lanes = detail::make_pack<Real>(c8, c15) * wd7_y_lanes +
      detail::make_pack<Real>(s8, s15) * wd7_z_lanes + w8_y_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_z_lanes = minus_w10_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);

  // link 9 (left_upperarm), outward
  const Lanes<2> wd9_x_lanes = detail::make_pack<Real>(s9, s16) * wd8_y_lanes +
      detail::make_pack<Real>(c9, c16) * wd8_z_lanes + w9_y_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> wd9_z_lanes = detail::make_pack<Real>(qdd_0[8], qdd_0[15]) - wd8_x_lanes;
  const Lanes<2> wd9_y_lanes = detail::make_pack<Real>(c9, c16) * wd8_y_lanes -
      detail::make_pack<Real>(s9, s16) * wd8_z_lanes - w9_x_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p6_lanes = 0.282 * (a10_x_p2_lanes + a10_x_p3_lanes) - a8_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a10_x_p7_lanes = a10_x_p1_lanes + wd9_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_z_lanes = wd9_y_lanes + detail::make_pack<Real>(qdd_0[9], qdd_0[16]);

  // link 9 (left_upperarm), outward
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;
  const Lanes<2> minus_a10_z_p2_lanes = minus_a10_z_p1_lanes - wd9_x_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a12_y_p1_lanes = w11_x_lanes * w11_z_lanes;
  const Lanes<2> minus_a12_y_p2_lanes = w11_x_lanes * w11_x_lanes;
  const Lanes<2> minus_a12_y_p3_lanes = w11_y_lanes * w11_y_lanes;
  const Lanes<2> minus_a12_z_p1_lanes = w11_y_lanes * w11_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_x_lanes = detail::make_pack<Real>(c10, c17) * wd9_x_lanes -
      detail::make_pack<Real>(s10, s17) * wd9_z_lanes - minus_w10_y_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> a10_x_p10_lanes = a9_x_lanes - 0.282 * a10_x_p7_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * minus_a10_z_p2_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_lanes = detail::make_pack<Real>(c10, c17) * a10_x_p10_lanes -
      detail::make_pack<Real>(s10, s17) * a10_x_p6_lanes;
  const Lanes<2> minus_a10_y_lanes = detail::make_pack<Real>(s10, s17) * a10_x_p10_lanes +
      detail::make_pack<Real>(c10, c17) * a10_x_p6_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4491_lanes = c1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) - s1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_y_lanes = detail::make_pack<Real>(c11, c18) * wd10_z_lanes -
      detail::make_pack<Real>(s11, s18) * wd10_x_lanes - w11_x_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4493_lanes = s1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) + c1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_x_lanes = detail::make_pack<Real>(c11, c18) * wd10_x_lanes +
      detail::make_pack<Real>(s11, s18) * wd10_z_lanes + w11_y_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p6_lanes = minus_a10_y_lanes + 0.269 *
      (minus_a12_y_p2_lanes + minus_a12_y_p3_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> w13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_w12_y_lanes +
      detail::make_pack<Real>(c13, c20) * w12_z_lanes;
  const Lanes<2> f13_x_p4497_lanes = w13_z_lanes * w13_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a12_y_p7_lanes = minus_a12_y_p1_lanes + wd11_y_lanes;
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;
  const Lanes<2> minus_a12_z_p2_lanes = minus_a12_z_p1_lanes - wd11_x_lanes;
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4511_lanes = w13_y_lanes * w13_y_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4513_lanes = c2 * f13_x_p4491_lanes - s2 * f13_x_p4493_lanes;
  const Lanes<2> f13_x_p4515_lanes = s2 * f13_x_p4491_lanes + c2 * f13_x_p4493_lanes;
  const Lanes<2> f13_x_p4517_lanes = f13_x_p4511_lanes + f13_x_p4497_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p10_lanes = a11_x_lanes - 0.269 * minus_a12_y_p7_lanes;
  const Lanes<2> minus_a12_z_lanes = minus_a11_y_lanes + 0.269 * minus_a12_z_p2_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4529_lanes = c3 * f13_x_p4513_lanes - s3 * f13_x_p4515_lanes;
  const Lanes<2> f13_x_p4531_lanes = s3 * f13_x_p4513_lanes + c3 * f13_x_p4515_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p10_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p6_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4541_lanes = c4 * f13_x_p4529_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> f13_x_p4543_lanes = c4 * detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]) - s4 *
      f13_x_p4529_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> minus_a13_x_lanes = detail::make_pack<Real>(c13, c20) * minus_a12_y_lanes +
      detail::make_pack<Real>(s13, s20) * minus_a12_z_lanes;
  const Lanes<2> a13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_a12_y_lanes -
      detail::make_pack<Real>(c13, c20) * minus_a12_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4555_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4469_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p4471_lanes - a13_y_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4557_lanes = s5 * f13_x_p4541_lanes + c5 * f13_x_p4531_lanes;
  const Lanes<2> f13_x_p4559_lanes = c5 * f13_x_p4541_lanes - s5 * f13_x_p4531_lanes;
  const Lanes<2> f13_x_p4561_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4471_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p4469_lanes +
      (minus_a13_x_lanes + 0.086 * f13_x_p4517_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> w13_x_lanes = detail::make_pack<Real>(s13, s20) * w12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_w12_y_lanes;
  const Lanes<2> f13_x_p4573_lanes = w13_x_lanes * w13_y_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4577_lanes = s6 * f13_x_p4543_lanes - c6 * f13_x_p4557_lanes;
  const Lanes<2> f13_x_p4579_lanes = s6 * f13_x_p4557_lanes + c6 * f13_x_p4543_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p10_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p6_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4591_lanes = w13_x_lanes * w13_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4593_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4463_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4457_lanes - a12_x_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4595_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4577_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4559_lanes;
  const Lanes<2> f13_x_p4597_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p4577_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p4559_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_z_lanes = wd11_y_lanes + detail::make_pack<Real>(qdd_0[11], qdd_0[18]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4607_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4579_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p4595_lanes;
  const Lanes<2> f13_x_p4609_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4595_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p4579_lanes;
  const Lanes<2> f13_x_p4619_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4607_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4597_lanes;
  const Lanes<2> f13_x_p4621_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4607_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4597_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_wd10_y_lanes = detail::make_pack<Real>(s10, s17) * wd9_x_lanes +
      detail::make_pack<Real>(c10, c17) * wd9_z_lanes + w10_x_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_z_lanes = minus_wd10_y_lanes + detail::make_pack<Real>(qdd_0[10], qdd_0[17]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4631_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4619_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4609_lanes;
  const Lanes<2> f13_x_p4633_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4609_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4619_lanes;
  const Lanes<2> f13_x_p4643_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4631_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4621_lanes;
  const Lanes<2> f13_x_p4645_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4621_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4631_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_wd12_y_lanes = detail::make_pack<Real>(s12, s19) * wd11_x_lanes +
      detail::make_pack<Real>(c12, c19) * wd11_z_lanes + w12_x_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4655_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4643_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4633_lanes;
  const Lanes<2> f13_x_p4657_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4633_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4643_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_x_lanes = detail::make_pack<Real>(s13, s20) * wd12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_wd12_y_lanes + w13_y_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> wd13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_wd12_y_lanes +
      detail::make_pack<Real>(c13, c20) * wd12_z_lanes - w13_x_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(c12, c19) * wd11_x_lanes -
      detail::make_pack<Real>(s12, s19) * wd11_z_lanes - minus_w12_y_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4665_lanes = 0.086 * (f13_x_p4573_lanes + f13_x_p4655_lanes);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4667_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4645_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p4657_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_z_lanes = wd12_x_lanes + detail::make_pack<Real>(qdd_0[12], qdd_0[19]);

  // link 1 (calf), force propagation
  const Real f13_x_p4671 = f13_x_p4555_lanes[0] - f13_x_p3203_lanes[1] * f13_x_p4561_lanes[0] -
      f13_x_p4665_lanes[0];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4674_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4657_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p4645_lanes - wd13_x_lanes;
  const Lanes<2> f13_x_p4676_lanes = f13_x_p4667_lanes - wd13_y_lanes;
  const Lanes<2> f13_x_p4678_lanes = f13_x_p4655_lanes - wd13_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4680_lanes = 0.086 * (f13_x_p4667_lanes - f13_x_p4591_lanes);
  const Real f13_x_p4682 = f13_x_p4593_lanes[0] - f13_x_p3203_lanes[2] * f13_x_p4561_lanes[0] -
      f13_x_p3379_lanes[2] * f13_x_p4671 + f13_x_p4680_lanes[0];
  const Real f13_x_p4683 = f13_x_p4674_lanes[0] - f13_x_p3203_lanes[3] * f13_x_p4561_lanes[0] -
      f13_x_p3379_lanes[3] * f13_x_p4671 - f13_x_p3576_lanes[3] * f13_x_p4682;
  const Real f13_x_p4684 = f13_x_p4676_lanes[0] - f13_x_p3203_lanes[4] * f13_x_p4561_lanes[0] -
      f13_x_p3379_lanes[4] * f13_x_p4671 - f13_x_p3576_lanes[4] * f13_x_p4682 -
      f13_x_p3739_lanes[4] * f13_x_p4683;
  const Real f13_x_p4685 = f13_x_p4678_lanes[0] - f13_x_p3203_lanes[5] * f13_x_p4561_lanes[0] -
      f13_x_p3379_lanes[5] * f13_x_p4671 - f13_x_p3576_lanes[5] * f13_x_p4682 -
      f13_x_p3739_lanes[5] * f13_x_p4683;
  const Real f13_x_p4686 = f13_x_p4561_lanes[1] - f13_x_p3203_lanes[6] * f13_x_p4561_lanes[0] -
      f13_x_p3379_lanes[6] * f13_x_p4671 - f13_x_p3576_lanes[6] * f13_x_p4682 -
      f13_x_p3739_lanes[6] * f13_x_p4683;
  const Real f13_x_p4687 = f13_x_p4555_lanes[1] - f13_x_p3203_lanes[7] * f13_x_p4561_lanes[0] -
      f13_x_p3379_lanes[7] * f13_x_p4671 - f13_x_p3576_lanes[7] * f13_x_p4682 -
      f13_x_p3739_lanes[7] * f13_x_p4683;
  const Real f13_x_p4688 = f13_x_p4593_lanes[1] - f13_x_p3213_lanes[0] * f13_x_p4561_lanes[0] -
      f13_x_p3390_lanes[0] * f13_x_p4671 - f13_x_p3581_lanes[0] * f13_x_p4682 -
      f13_x_p3743_lanes[0] * f13_x_p4683;
  const Real f13_x_p4689 = f13_x_p4685 - f13_x_p3828_lanes[5] * f13_x_p4684;
  const Real f13_x_p4690 = f13_x_p4674_lanes[1] - f13_x_p3213_lanes[1] * f13_x_p4561_lanes[0] -
      f13_x_p3390_lanes[1] * f13_x_p4671 - f13_x_p3581_lanes[1] * f13_x_p4682 -
      f13_x_p3743_lanes[1] * f13_x_p4683;
  const Real f13_x_p4691 = f13_x_p4686 - f13_x_p3828_lanes[6] * f13_x_p4684 - f13_x_p3960 *
      f13_x_p4689;
  const Real f13_x_p4692 = f13_x_p4676_lanes[1] - f13_x_p3213_lanes[2] * f13_x_p4561_lanes[0] -
      f13_x_p3390_lanes[2] * f13_x_p4671 - f13_x_p3581_lanes[2] * f13_x_p4682 -
      f13_x_p3743_lanes[2] * f13_x_p4683;
  const Real f13_x_p4693 = f13_x_p4687 - f13_x_p3828_lanes[7] * f13_x_p4684 - f13_x_p3965 *
      f13_x_p4689 - f13_x_p4148 * f13_x_p4691 - f13_x_p4665_lanes[1];
  const Real f13_x_p4694 = f13_x_p4678_lanes[1] - f13_x_p3213_lanes[3] * f13_x_p4561_lanes[0] -
      f13_x_p3390_lanes[3] * f13_x_p4671 - f13_x_p3581_lanes[3] * f13_x_p4682 -
      f13_x_p3743_lanes[3] * f13_x_p4683;
  const Real f13_x_p4695 = f13_x_p4688 - f13_x_p3832_lanes[0] * f13_x_p4684 - f13_x_p3966_lanes[0] *
      f13_x_p4689 - f13_x_p4091_lanes[0] * f13_x_p4691 - f13_x_p4270_lanes[0] * f13_x_p4693;
  const Real f13_x_p4696 = f13_x_p4690 - f13_x_p3832_lanes[1] * f13_x_p4684 - f13_x_p3966_lanes[1] *
      f13_x_p4689 - f13_x_p4091_lanes[1] * f13_x_p4691 - f13_x_p4270_lanes[1] * f13_x_p4693;
  const Real f13_x_p4697 = f13_x_p4692 - f13_x_p3832_lanes[2] * f13_x_p4684 - f13_x_p3966_lanes[2] *
      f13_x_p4689 - f13_x_p4091_lanes[2] * f13_x_p4691 - f13_x_p4270_lanes[2] * f13_x_p4693;

  // link 3 (hip), force propagation
  const Real f13_x_p4698 = f13_x_p3733_lanes[1] + f13_x_p2275_lanes[3] * f13_x_p624_lanes[3] +
      f13_x_p2271_lanes[3] * f13_x_p720_lanes[3] + f13_x_p2259_lanes[3] * f13_x_p824_lanes[3] +
      f13_x_p2279_lanes[3] * f13_x_p916_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p4699 = f13_x_p4695 + f13_x_p4680_lanes[1];
  const Real f13_x_p4700 = f13_x_p4694 - f13_x_p3832_lanes[3] * f13_x_p4684 - f13_x_p3966_lanes[3] *
      f13_x_p4689 - f13_x_p4091_lanes[3] * f13_x_p4691 - f13_x_p4270_lanes[3] * f13_x_p4693;
  const Real f13_x_p4701 = f13_x_p4696 - f13_x_p4323_lanes[1] * f13_x_p4699;
  const Real f13_x_p4702 = f13_x_p4698 + f13_x_p2283_lanes[3] * f13_x_p980_lanes[3] +
      f13_x_p1076_lanes[3] * f13_x_p1039_lanes[3] - f13_x_p3213_lanes[3] * f13_x_p3067_lanes[3] -
      f13_x_p3390_lanes[3] * f13_x_p3294_lanes[3];
  const Real f13_x_p4703 = f13_x_p4697 - f13_x_p4323_lanes[2] * f13_x_p4699 - f13_x_p4388 *
      f13_x_p4701;
  const Real f13_x_p4704 = f13_x_p4702 - f13_x_p3581_lanes[3] * f13_x_p3483_lanes[3] -
      f13_x_p3743_lanes[3] * f13_x_p3644_lanes[3] - f13_x_p3832_lanes[3] * f13_x_p3795_lanes[3] -
      f13_x_p3966_lanes[3] * f13_x_p3922_lanes[3];
  const Real f13_x_p4705 = f13_x_p4704 - f13_x_p4091_lanes[3] * f13_x_p4054_lanes[3] -
      f13_x_p4270_lanes[3] * f13_x_p4197_lanes[3] - f13_x_p4323_lanes[3] * f13_x_p4290_lanes[3] -
      f13_x_p4389 * f13_x_p4350_lanes[3];
  const Real f13_x_p4706 = (f13_x_p4700 - f13_x_p4323_lanes[3] * f13_x_p4699 - f13_x_p4389 *
      f13_x_p4701 - f13_x_p4456 * f13_x_p4703) * (1.0 / (f13_x_p4705 - f13_x_p4456 * f13_x_p4403));
  const Real f13_x_p4707 = f13_x_p4703 * f13_x_p4433 - f13_x_p4456 * f13_x_p4706;
  const Real f13_x_p4708 = f13_x_p4701 * f13_x_p4361 - f13_x_p4388 * f13_x_p4707 - f13_x_p4389 *
      f13_x_p4706;
  const Real f13_x_p4709 = f13_x_p4699 * f13_x_p4298 - f13_x_p4323_lanes[1] * f13_x_p4708 -
      f13_x_p4323_lanes[2] * f13_x_p4707 - f13_x_p4323_lanes[3] * f13_x_p4706;
  const Real f13_x_p4710 = f13_x_p4693 * f13_x_p4240 - f13_x_p4270_lanes[0] * f13_x_p4709 -
      f13_x_p4270_lanes[1] * f13_x_p4708 - f13_x_p4270_lanes[2] * f13_x_p4707 -
      f13_x_p4270_lanes[3] * f13_x_p4706;
  const Real f13_x_p4711 = f13_x_p4691 * f13_x_p4020 - f13_x_p4148 * f13_x_p4710 -
      f13_x_p4091_lanes[0] * f13_x_p4709 - f13_x_p4091_lanes[1] * f13_x_p4708 -
      f13_x_p4091_lanes[2] * f13_x_p4707;
  const Real f13_x_p4712 = f13_x_p4711 - f13_x_p4091_lanes[3] * f13_x_p4706;
  const Real f13_x_p4713 = f13_x_p4689 * f13_x_p3917 - f13_x_p3960 * f13_x_p4712 - f13_x_p3965 *
      f13_x_p4710 - f13_x_p3966_lanes[0] * f13_x_p4709 - f13_x_p3966_lanes[1] * f13_x_p4708;
  const Real f13_x_p4714 = f13_x_p4713 - f13_x_p3966_lanes[2] * f13_x_p4707 - f13_x_p3966_lanes[3] *
      f13_x_p4706;
  const Real f13_x_p4715 = f13_x_p4684 * f13_x_p3787 - f13_x_p3828_lanes[5] * f13_x_p4714 -
      f13_x_p3828_lanes[6] * f13_x_p4712 - f13_x_p3828_lanes[7] * f13_x_p4710 -
      f13_x_p3832_lanes[0] * f13_x_p4709;
  const Real f13_x_p4716 = f13_x_p4715 - f13_x_p3832_lanes[1] * f13_x_p4708 - f13_x_p3832_lanes[2] *
      f13_x_p4707 - f13_x_p3832_lanes[3] * f13_x_p4706;
  const Real f13_x_p4717 = f13_x_p4683 * f13_x_p3674 - f13_x_p3739_lanes[4] * f13_x_p4716 -
      f13_x_p3739_lanes[5] * f13_x_p4714 - f13_x_p3739_lanes[6] * f13_x_p4712 -
      f13_x_p3739_lanes[7] * f13_x_p4710;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4718_lanes = f13_x_p4573_lanes - wd13_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_x_p4721_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      f13_x_p4718_lanes - 0.01626499875 * f13_x_p4517_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_y_p1_lanes = f13_x_p4573_lanes + wd13_z_lanes;
  const Lanes<2> f13_y_p2_lanes = w13_x_lanes * w13_x_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4722 = f13_x_p4717 - f13_x_p3743_lanes[0] * f13_x_p4709 - f13_x_p3743_lanes[1] *
      f13_x_p4708 - f13_x_p3743_lanes[2] * f13_x_p4707 - f13_x_p3743_lanes[3] * f13_x_p4706;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_y_p1_lanes = w12_x_lanes * minus_w12_y_lanes;
  const Lanes<2> f12_y_p3_lanes = w12_z_lanes * w12_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_y_p6_lanes = 0.01626499875 * f13_y_p1_lanes -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      (f13_y_p2_lanes + f13_x_p4497_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p1_lanes = f13_x_p4591_lanes - wd13_y_lanes;
  const Lanes<2> f13_z_p2_lanes = w13_y_lanes * w13_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4723 = f13_x_p4682 * f13_x_p3497 - f13_x_p3576_lanes[3] * f13_x_p4722 -
      f13_x_p3576_lanes[4] * f13_x_p4716 - f13_x_p3576_lanes[5] * f13_x_p4714 -
      f13_x_p3576_lanes[6] * f13_x_p4712;

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p4_lanes = f13_z_p2_lanes + wd13_x_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_x_p1_lanes = minus_w12_y_lanes * minus_w12_y_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_y_p8_lanes = 0.0025100003499999995 * (wd12_z_lanes - f12_y_p1_lanes) -
      0.0006000000000000001 * (w12_x_lanes * w12_x_lanes + f12_y_p3_lanes);

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_x_p2_lanes = f12_y_p1_lanes + wd12_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_p6_lanes = 0.01626499875 * f13_z_p1_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * f13_z_p4_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_x_p1_lanes = w11_x_lanes * w11_y_lanes;
  const Lanes<2> f11_x_p2_lanes = w11_z_lanes * w11_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4724 = f13_x_p4723 - f13_x_p3576_lanes[7] * f13_x_p4710 - f13_x_p3581_lanes[0] *
      f13_x_p4709 - f13_x_p3581_lanes[1] * f13_x_p4708 - f13_x_p3581_lanes[2] * f13_x_p4707;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_x_p6_lanes = 0.0025100003499999995 * (f12_x_p1_lanes + f12_y_p3_lanes) +
      0.0006000000000000001 * f12_x_p2_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_x_p3_lanes = f11_x_p1_lanes - wd11_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4725 = f13_x_p4724 - f13_x_p3581_lanes[3] * f13_x_p4706;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_z_p1_lanes = w12_x_lanes * w12_z_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_z = f13_z_p6_lanes[0] + f13_x_p4725;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_x_p7_lanes = detail::make_pack<Real>(0.001, (-0.001)) * f11_x_p3_lanes -
      6e-04 * (minus_a12_y_p3_lanes + f11_x_p2_lanes);

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - f12_x_p6_lanes[0];

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_z_p3_lanes = f12_z_p1_lanes + minus_wd12_y_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_y_p1_lanes = f11_x_p1_lanes + wd11_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_z_p4_lanes = wd12_x_lanes - minus_w12_y_lanes * w12_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p1_lanes = w10_x_lanes * w10_z_lanes;
  const Lanes<2> f10_z_p2_lanes = minus_w10_y_lanes * w10_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_z_p7_lanes = 0.0025100003499999995 * f12_z_p3_lanes + 0.0006000000000000001 *
      f12_z_p4_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p3_lanes = f10_z_p1_lanes + minus_wd10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_y_p5_lanes = 6e-04 * f11_y_p1_lanes -
      detail::make_pack<Real>(0.001, (-0.001)) * (minus_a12_y_p2_lanes + f11_x_p2_lanes);

  // link 1 (calf), force propagation
  const Real f13_x_p4726 = f13_x_p4671 * f13_x_p3313 - f13_x_p3379_lanes[2] * f13_x_p4725 -
      f13_x_p3379_lanes[3] * f13_x_p4722 - f13_x_p3379_lanes[4] * f13_x_p4716 -
      f13_x_p3379_lanes[5] * f13_x_p4714;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p4_lanes = wd10_x_lanes - f10_z_p2_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p7_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * (f13_x_p4497_lanes - f13_x_p4511_lanes);

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_z_p7_lanes = 0.0014999985000000002 * f10_z_p3_lanes + 0.28049749700000004 *
      f10_z_p4_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4727 = f13_x_p4726 - f13_x_p3379_lanes[6] * f13_x_p4712 - f13_x_p3379_lanes[7] *
      f13_x_p4710 - f13_x_p3390_lanes[0] * f13_x_p4709 - f13_x_p3390_lanes[1] * f13_x_p4708;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p9_lanes = 9.149209276993575e-05 * f13_z_p4_lanes +
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p1_lanes -
      0.000108260010923775 * f13_y_p1_lanes + n13_x_p7_lanes;
  const Lanes<2> n13_y_p7_lanes = 0.000108260010923775 * (f13_y_p2_lanes - f13_x_p4497_lanes);
  const Lanes<2> n13_x_p10_lanes = n13_x_p9_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * a12_x_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4728 = f13_x_p4727 - f13_x_p3390_lanes[2] * f13_x_p4707 - f13_x_p3390_lanes[3] *
      f13_x_p4706;

  // link 24 (right_eye), inertial wrench
  const Real n13_x = n13_x_p10_lanes[0] + f13_x_p4722;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_y_p9_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * f13_x_p4718_lanes - 0.000847139515629375 * f13_z_p1_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p4_lanes +
      n13_y_p7_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_y = f13_y_p6_lanes[0] + f13_x_p4728;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_y_p10_lanes = n13_y_p9_lanes - 0.01626499875 * a12_x_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_y_p5_lanes = 0.0025100003499999995 * minus_a12_z_lanes -
      (0.000195227662257343 * f12_z_p3_lanes + detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * f12_x_p2_lanes);

  // link 24 (right_eye), inertial wrench
  const Real n13_y = n13_y_p10_lanes[0] + f13_x_p4716;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p13_lanes = 0.0007556474228594393 * f13_x_p4573_lanes +
      0.0009386316083993107 * wd13_z_lanes + 0.000108260010923775 * (f13_z_p2_lanes - wd13_x_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p1_lanes = minus_a12_z_p1_lanes + wd11_x_lanes;
  const Lanes<2> n11_x_p3_lanes = minus_a12_y_p1_lanes - wd11_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4729 = f13_x_p4561_lanes[0] * f13_x_p3151 - f13_x_p3203_lanes[1] * f13_x_p4728 -
      f13_x_p3203_lanes[2] * f13_x_p4725 - f13_x_p3203_lanes[3] * f13_x_p4722 -
      f13_x_p3203_lanes[4] * f13_x_p4716;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p15_lanes = n13_z_p13_lanes -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      (f13_x_p4591_lanes + wd13_y_lanes) + detail::make_pack<Real>((-0.0001263900573325125),
      0.0001263900573325125) * (f13_x_p4511_lanes - f13_y_p2_lanes);

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p8_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (f11_x_p2_lanes - minus_a12_y_p3_lanes);

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_x_p6_lanes = 1.16e-05 * f12_z_p4_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (f12_y_p3_lanes - f12_x_p1_lanes) - 0.0006000000000000001 * minus_a12_z_lanes;

  // link 13 (left_hand), inward
  const Real n12_y = n12_y_p5_lanes[0] + (c13 * n13_x - s13 * n13_y);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p16_lanes = n13_z_p15_lanes +
      (0.01626499875 * a13_y_lanes + detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      minus_a13_x_lanes);

  // link 24 (right_eye), inertial wrench
  const Real n13_z = n13_z_p16_lanes[0] + f13_x_p4714;
  tau[12] = n13_z;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p9_lanes = 0.00020682766225734302 * wd12_z_lanes - 0.000183627662257343 *
      f12_y_p1_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (f12_z_p1_lanes - minus_wd12_y_lanes);

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p7_lanes = 0.000144 * (minus_a12_y_p2_lanes - f11_x_p2_lanes);

  // link 13 (left_hand), inward
  const Real n12_x = n12_x_p6_lanes[0] + n13_z;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p2_lanes = w10_x_lanes * minus_w10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p11_lanes = 0.0001194 * n11_x_p1_lanes +
      detail::make_pack<Real>(6e-06, (-6e-06)) * n11_x_p3_lanes + 0.000144 * f11_y_p1_lanes +
      n11_x_p8_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4730 = f13_x_p4729 - f13_x_p3203_lanes[5] * f13_x_p4714 - f13_x_p3203_lanes[6] *
      f13_x_p4712 - f13_x_p3203_lanes[7] * f13_x_p4710 - f13_x_p3213_lanes[0] * f13_x_p4709;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p4_lanes = w10_z_lanes * w10_z_lanes;
  const Lanes<2> n10_x_p5_lanes = minus_w10_y_lanes * minus_w10_y_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p10_lanes = n12_z_p9_lanes -
      (0.0025100003499999995 * minus_a12_y_lanes + 0.0006000000000000001 * a12_x_lanes);

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p12_lanes = n11_x_p11_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p7_lanes = wd10_z_lanes - n10_x_p2_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p9_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      f11_x_p3_lanes - 0.0001098 * n11_x_p3_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) *
      n11_x_p1_lanes - n11_y_p7_lanes;

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p10_lanes[0] + (s13 * n13_x + c13 * n13_y);
  tau[11] = n12_z;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p6_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      minus_a12_y_p7_lanes;
  const Lanes<2> n11_y_p10_lanes = n11_y_p9_lanes - 6e-04 * minus_a10_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p11_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * (n10_x_p4_lanes - n10_x_p5_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p2_lanes = n10_x_p2_lanes + wd10_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p8_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p3_lanes = w10_x_lanes * w10_x_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_x = f13_x_p4721_lanes[0] + (f13_x_p4730 - f13_x_p3213_lanes[1] * f13_x_p4708 -
      f13_x_p3213_lanes[2] * f13_x_p4707 - f13_x_p3213_lanes[3] * f13_x_p4706);

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p13_lanes = 0.06060754126741261 * f10_z_p4_lanes + 0.0001499998887063 *
      f10_z_p3_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      n10_x_p7_lanes + n10_x_p11_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p1_lanes = minus_a10_z_p1_lanes + wd9_x_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p12_lanes = 0.0002292 * wd11_z_lanes - 9.600000000000003e-06 *
      f11_x_p1_lanes - 0.000144 * minus_a12_z_p2_lanes - n11_z_p6_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p2_lanes = a10_x_p1_lanes - wd9_y_lanes;
  const Lanes<2> n9_x_p3_lanes = w9_x_lanes * w9_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p14_lanes = n10_x_p13_lanes - 0.28049749700000004 * minus_a10_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p5_lanes = w9_z_lanes * w9_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p10_lanes = 0.00028099984685315 * f10_z_p3_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * n10_y_p2_lanes +
      0.0001499998887063 * f10_z_p4_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p8_lanes = n9_x_p3_lanes + wd9_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p14_lanes = n11_z_p12_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (minus_a12_y_p3_lanes - minus_a12_y_p2_lanes) - n11_z_p8_lanes;

  // link 13 (left_hand), inward
  const Real f12_y = f12_y_p8_lanes[0] + (c13 * f13_x - s13 * f13_y);
  const Real f12_z = f12_z_p7_lanes[0] + (s13 * f13_x + c13 * f13_y);

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p12_lanes = detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * (n10_y_p3_lanes - n10_x_p4_lanes) - n10_y_p10_lanes +
      0.0014999985000000002 * minus_a10_z_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_z = n11_z_p14_lanes[0] - (s12 * n12_x + c12 * n12_y);
  tau[10] = n11_z;
  const Real f11_y = f11_y_p5_lanes[0] + f12_z;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p12_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (n9_x_p5_lanes - a10_x_p3_lanes);

  // link 12 (left_wrist2), inward
  const Real f11_x_p8 = s12 * f12_y - c12 * f12_x;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p13_lanes = 0.06032654142055946 * n10_x_p2_lanes + 0.060888541114265754 *
      wd10_z_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (f10_z_p2_lanes + wd10_x_lanes);

  // link 11 (left_wrist1), inward
  const Real n10_y = n10_y_p12_lanes[0] - n11_z;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p14_lanes = 0.0019585440854647937 * n9_x_p1_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p2_lanes -
      0.0005895000784280001 * n9_x_p8_lanes + n9_x_p12_lanes;

  // link 12 (left_wrist2), inward
  const Real f11_x = f11_x_p7_lanes[0] - f11_x_p8;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_y_p1_lanes = n9_x_p3_lanes - wd9_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_z_p3_lanes = 6e-04 * n11_x_p3_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * n11_x_p1_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_x_p4_lanes = 0.0014999985000000002 * (n10_x_p5_lanes + n10_x_p4_lanes) +
      0.28049749700000004 * n10_y_p2_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_x = n11_x_p12_lanes[0] + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));
  const Real f11_z = f11_z_p3_lanes[0] - (s12 * f12_x + c12 * f12_y);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p1_lanes = w8_x_lanes * w8_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_y_p4_lanes = 0.0014999985000000002 * n10_x_p7_lanes - 0.28049749700000004 *
      (n10_y_p3_lanes + n10_x_p4_lanes);
  const Lanes<2> n10_z_p15_lanes = n10_z_p13_lanes -
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (f10_z_p1_lanes - minus_wd10_y_lanes) + 0.0001499998887063 *
      (n10_x_p5_lanes - n10_y_p3_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p7_lanes = 0.0005895000784280001 * (a10_x_p2_lanes - n9_x_p5_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p2_lanes = w8_y_lanes * w8_z_lanes;
  const Lanes<2> n8_z_p4_lanes = w8_x_lanes * w8_z_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_y = n11_y_p10_lanes[0] + (n12_z + 0.269 * f11_x_p8);

  // link 11 (left_wrist1), inward
  const Real f10_y = f10_y_p4_lanes[0] - f11_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p5_lanes = w8_y_lanes * w8_y_lanes;
  const Lanes<2> n8_z_p6_lanes = w8_x_lanes * w8_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p16_lanes = n10_z_p15_lanes -
      (0.0014999985000000002 * minus_a10_y_lanes + 0.28049749700000004 * a10_x_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p15_lanes = n9_x_p14_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p1_lanes = w7_y_lanes * w7_z_lanes;

  // link 11 (left_wrist1), inward
  const Real f10_x = c11 * f11_x - s11 * f11_y - f10_x_p4_lanes[0];
  const Real f10_z = f10_z_p7_lanes[0] + (s11 * f11_x + c11 * f11_y);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p2_lanes = w7_x_lanes * w7_z_lanes;
  const Lanes<2> n7_x_p3_lanes = w7_x_lanes * w7_y_lanes;
  const Lanes<2> n7_x_p4_lanes = w7_y_lanes * w7_y_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p10_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * n9_y_p1_lanes - 0.0008177492704690715 * n9_x_p2_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p1_lanes +
      n9_y_p7_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p5_lanes = n7_x_p1_lanes + wd7_x_lanes;
  const Lanes<2> n7_x_p6_lanes = w7_z_lanes * w7_z_lanes;
  const Lanes<2> n7_x_p7_lanes = n7_x_p2_lanes - wd7_y_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p11_lanes = n9_y_p10_lanes - 0.0022500062 * a8_x_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p1_lanes = n8_z_p1_lanes - wd8_z_lanes;
  const Lanes<2> n8_y_p2_lanes = n8_z_p4_lanes - wd8_y_lanes;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p12 = s10 * f10_y - c10 * f10_x;

  // link 11 (left_wrist1), inward
  const Real n10_x = n10_x_p14_lanes[0] + (c11 * n11_x - s11 * n11_y);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p3_lanes = n8_z_p2_lanes + wd8_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p9_lanes = n7_x_p3_lanes + wd7_z_lanes;

  // link 11 (left_wrist1), inward
  const Real n10_z = n10_z_p16_lanes[0] + (s11 * n11_x + c11 * n11_y);
  tau[9] = n10_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p4_lanes = w8_z_lanes * w8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p16_lanes = 0.18101044219699997 * n8_z_p1_lanes + 0.18125194219699997 *
      wd8_z_lanes + 0.00010499999999999999 * (n8_z_p2_lanes - wd8_x_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p6_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * a10_x_p7_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_x_p3_lanes = n8_z_p1_lanes + wd8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p11_lanes = 0.00010499999999999999 * (n8_z_p6_lanes - n8_y_p4_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p9_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p1_lanes = n7_x_p3_lanes - wd7_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p8_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_y_p4_lanes - n8_z_p5_lanes);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p3_lanes = w7_x_lanes * w7_x_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p13_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n8_y_p1_lanes -
      0.18113119219699997 * n8_y_p2_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * n8_y_p3_lanes + n8_y_p11_lanes;

  // link 10 (left_lowerarm), inward
  const Real n9_y = n9_y_p11_lanes[0] + (n10_z + 0.282 * n9_y_p12);
  const Real n9_x = n9_x_p15_lanes[0] + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p14_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p6_lanes - n7_x_p4_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p12_lanes = 0.0027762933559338653 * wd9_z_lanes - 0.001140794814995722 *
      n9_x_p3_lanes + 0.0005895000784280001 * minus_a10_z_p2_lanes - n9_z_p6_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p14_lanes = n8_y_p13_lanes - 0.7139200499999999 * a7_x_lanes;
  const Lanes<2> n8_x_p10_lanes = 0.00012075 * n8_y_p3_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * n8_y_p2_lanes -
      0.00010499999999999999 * n8_x_p3_lanes + n8_x_p8_lanes;
  const Lanes<2> n8_z_p20_lanes = n8_z_p16_lanes - detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_z_p4_lanes + wd8_y_lanes) + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (n8_z_p5_lanes - n8_z_p6_lanes);
  const Lanes<2> f7_x_p4_lanes = 0.7139200499999999 * n8_y_p2_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * n8_y_p3_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p16_lanes = 0.0017499999999999998 * minus_a7_z_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_x_p4_lanes = 0.0022500062 * (a10_x_p3_lanes + n9_x_p5_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * n9_y_p1_lanes;
  const Lanes<2> n9_z_p14_lanes = n9_z_p12_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) *
      (a10_x_p3_lanes - a10_x_p2_lanes) + n9_z_p9_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p11_lanes = n8_x_p10_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p8_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_y_p3_lanes - n7_x_p6_lanes);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p21_lanes = n8_z_p20_lanes - (0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_y_p4_lanes = 0.0022500062 * n9_x_p8_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (a10_x_p2_lanes + n9_x_p5_lanes);

  // link 10 (left_lowerarm), inward
  const Real f9_x = f9_x_p4_lanes[0] - n9_y_p12;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_p6_lanes = 0.0017499999999999998 *
      (n7_x_p4_lanes + n7_x_p6_lanes + n7_y_p1_lanes);

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p17_lanes = 0.0001505 * n7_x_p5_lanes + 8.75e-06 * n7_x_p7_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * n7_x_p9_lanes +
      n7_x_p14_lanes;

  // link 10 (left_lowerarm), inward
  const Real n9_z = n9_z_p14_lanes[0] - (s10 * n10_x + c10 * n10_y);
  tau[8] = n9_z;
  const Real f9_y = f10_z - f9_y_p4_lanes[0];

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_z_p3_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      n9_x_p1_lanes - 0.0022500062 * n9_x_p2_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f20_x = f13_x_p4721_lanes[1] + f13_x_p4712;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_y_p4_lanes = 0.7139200499999999 * n8_x_p3_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (n8_z_p6_lanes + n8_y_p4_lanes);

  // link 24 (right_eye), inertial wrench
  const Real f20_y = f13_y_p6_lanes[1] + f13_x_p4710;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p18_lanes = n7_x_p17_lanes + n7_x_p16_lanes;
  const Lanes<2> n7_y_p10_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * n7_y_p1_lanes - 0.0002975 * n7_x_p7_lanes - 8.75e-06 *
      n7_x_p5_lanes + n7_y_p8_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f20_z = f13_z_p6_lanes[1] + f13_x_p4709;

  // link 10 (left_lowerarm), inward
  const Real f9_z = f9_z_p3_lanes[0] - (s10 * f10_x + c10 * f10_y);

  // link 20 (right_hand), inward
  const Real f19_x = f20_z - f12_x_p6_lanes[1];

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_x_p4_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p1_lanes - 0.7139200499999999 *
      (n8_z_p5_lanes + n8_y_p4_lanes);

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_p3_lanes = 0.0017499999999999998 *
      (n7_x_p9_lanes + (n7_y_p3_lanes + n7_x_p6_lanes));

  // link 9 (left_upperarm), inward
  const Real n8_y = n8_y_p14_lanes[0] + (s9 * n9_x + c9 * n9_y);
  const Real n8_x = n8_x_p11_lanes[0] - n9_z;

  // link 24 (right_eye), inertial wrench
  const Real n20_x = n13_x_p10_lanes[1] + f13_x_p4708;
  const Real n20_y = n13_y_p10_lanes[1] + f13_x_p4707;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p11_lanes = n7_y_p10_lanes + n7_x_p16_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n20_z = n13_z_p16_lanes[1] + f13_x_p4706;
  tau[19] = n20_z;

  // link 9 (left_upperarm), inward
  const Real f8_x = f8_x_p4_lanes[0] - f9_z;
  const Real f8_y = f8_y_p4_lanes[0] + (s9 * f9_x + c9 * f9_y);

  // link 20 (right_hand), inward
  const Real f19_y = f12_y_p8_lanes[1] + (c20 * f20_x - s20 * f20_y);
  const Real n19_x = n12_x_p6_lanes[1] + n20_z;
  const Real f19_z = f12_z_p7_lanes[1] + (s20 * f20_x + c20 * f20_y);

  // link 8 (left_shoulder2), inward
  const Real f7_x = f7_x_p4_lanes[0] + c9 * f9_x - s9 * f9_y - f7_x_p6_lanes[0];

  // link 19 (right_wrist2), inward
  const Real f18_y = f11_y_p5_lanes[1] + f19_z;

  // link 9 (left_upperarm), inward
  const Real n8_z = n8_z_p21_lanes[0] + (c9 * n9_x - s9 * n9_y);
  tau[7] = n8_z;

  // link 20 (right_hand), inward
  const Real n19_y = n12_y_p5_lanes[1] + (c20 * n20_x - s20 * n20_y);

  // link 19 (right_wrist2), inward
  const Real n18_y_p11 = s19 * f19_y - c19 * f19_x;

  // link 20 (right_hand), inward
  const Real n19_z = n12_z_p10_lanes[1] + (s20 * n20_x + c20 * n20_y);
  tau[18] = n19_z;

  // link 8 (left_shoulder2), inward
  const Real n7_x = n7_x_p18_lanes[0] + n8_z;
  const Real n7_y = n7_y_p11_lanes[0] + (c8 * n8_x - s8 * n8_y);

  // link 19 (right_wrist2), inward
  const Real f18_x = f11_x_p7_lanes[1] - n18_y_p11;

  // link 8 (left_shoulder2), inward
  const Real f7_y = c8 * f8_x - s8 * f8_y + f7_y_p3_lanes[0];

  // link 19 (right_wrist2), inward
  const Real f18_z = f11_z_p3_lanes[1] - (s19 * f19_x + c19 * f19_y);
  const Real n18_z = n11_z_p14_lanes[1] - (s19 * n19_x + c19 * n19_y);
  tau[17] = n18_z;
  const Real n18_y = n11_y_p10_lanes[1] + (n19_z + 0.269 * n18_y_p11);

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = c7 * f7_x - s7 * f7_y;

  // link 19 (right_wrist2), inward
  const Real n18_x = n11_x_p12_lanes[1] + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));

  // link 18 (right_wrist1), inward
  const Real f17_y = f10_y_p4_lanes[1] - f18_z;
  const Real n17_y = n10_y_p12_lanes[1] - n18_z;
  const Real f17_x = c18 * f18_x - s18 * f18_y - f10_x_p4_lanes[1];
  const Real f17_z = f10_z_p7_lanes[1] + (s18 * f18_x + c18 * f18_y);

  // link 17 (right_lowerarm), inward
  const Real f16_y = f17_z - f9_y_p4_lanes[1];
  const Real n16_y_p12 = s17 * f17_y - c17 * f17_x;

  // link 18 (right_wrist1), inward
  const Real n17_x = n10_x_p14_lanes[1] + (c18 * n18_x - s18 * n18_y);
  const Real n17_z = n10_z_p16_lanes[1] + (s18 * n18_x + c18 * n18_y);
  tau[16] = n17_z;

  // link 17 (right_lowerarm), inward
  const Real f16_x = f9_x_p4_lanes[1] - n16_y_p12;
  const Real f16_z = f9_z_p3_lanes[1] - (s17 * f17_x + c17 * f17_y);

  // link 21 (neck), outward
  const Real wd21_z = qdd_0[20] - wd6_x;

  // link 17 (right_lowerarm), inward
  const Real n16_y = n9_y_p11_lanes[1] + (n17_z + 0.282 * n16_y_p12);

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;

  // link 16 (right_upperarm), inward
  const Real f15_x = f8_x_p4_lanes[1] - f16_z;

  // link 21 (neck), outward
  const Real w21_z = qd[20] - w6_x;

  // link 17 (right_lowerarm), inward
  const Real n16_z = n9_z_p14_lanes[1] - (s17 * n17_x + c17 * n17_y);
  tau[15] = n16_z;

  // link 16 (right_upperarm), inward
  const Real f15_y = f8_y_p4_lanes[1] + (s16 * f16_x + c16 * f16_y);

  // link 22 (head), outward
  const Real w22_z = w21_y + qd[21];

  // link 21 (neck), outward
  const Real w21_x = s21 * w6_y + c21 * w6_z;

  // link 17 (right_lowerarm), inward
  const Real n16_x = n9_x_p15_lanes[1] + (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));

  // link 16 (right_upperarm), inward
  const Real n15_x = n8_x_p11_lanes[1] - n16_z;

  // link 21 (neck), outward
  const Real wd21_x = s21 * wd6_y + c21 * wd6_z + w21_y * qd[20];
  const Real a22_z_p1 = w21_y * w21_z;

  // link 15 (right_shoulder2), inward
  const Real f14_x = f7_x_p4_lanes[1] + c16 * f16_x - s16 * f16_y - f7_x_p6_lanes[1];

  // link 21 (neck), outward
  const Real a22_y_p1 = w21_x * w21_x;
  const Real a22_y_p2 = w21_y * w21_y;

  // link 22 (head), outward
  const Real w22_x = c22 * w21_x - s22 * w21_z;
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;

  // link 21 (neck), outward
  const Real a22_z_p2 = a22_z_p1 - wd21_x;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real a22_x_p1 = w21_x * w21_z;

  // link 22 (head), outward
  const Real n22_x_p1 = w22_x * w22_z;

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;

  // link 22 (head), outward
  const Real minus_a23_z_p1 = w22_x * minus_w22_y;
  const Real minus_a23_z_p2 = minus_w22_y * w22_z;

  // link 16 (right_upperarm), inward
  const Real n15_y = n8_y_p14_lanes[1] + (s16 * n16_x + c16 * n16_y);

  // link 15 (right_shoulder2), inward
  const Real f14_y = c15 * f15_x - s15 * f15_y + f7_y_p3_lanes[1];

  // link 22 (head), outward
  const Real minus_wd22_y = s22 * wd21_x + c22 * wd21_z + w22_x * qd[21];

  // link 23 (left_eye), outward
  const Lanes<2> w23_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);

  // link 16 (right_upperarm), inward
  const Real n15_z = n8_z_p21_lanes[1] + (c16 * n16_x - s16 * n16_y);
  tau[14] = n15_z;

  // link 21 (neck), outward
  const Real wd21_y = c21 * wd6_y - s21 * wd6_z - w21_x * qd[20];

  // link 22 (head), outward
  const Real wd22_x = c22 * wd21_x - s22 * wd21_z - minus_w22_y * qd[21];
  const Real a22_z = 0.394 * a22_z_p2 - minus_a21_y;
  const Real a22_y_p3 = a6_x + 0.394 * (a22_y_p1 + a22_y_p2);
  const Real n22_x_p2 = n22_x_p1 + minus_wd22_y;

  // link 23 (left_eye), outward
  const Lanes<2> w23_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;

  // link 22 (head), outward
  const Real wd22_z = wd21_y + qdd_0[21];

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p3_lanes = w23_z_lanes * w23_z_lanes;

  // link 22 (head), outward
  const Real minus_a23_z_p3 = minus_a23_z_p2 + wd22_x;
  const Real n22_x_p3 = wd22_x - minus_a23_z_p2;
  const Real minus_a23_z_p4 = wd22_z - minus_a23_z_p1;

  // link 23 (left_eye), outward
  const Lanes<2> wd23_z_lanes = minus_wd22_y + detail::make_pack<Real>(qdd_0[22], qdd_0[23]);
  const Lanes<2> w23_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;

  // link 15 (right_shoulder2), inward
  const Real n14_x = n7_x_p18_lanes[1] + n15_z;

  // link 22 (head), outward
  const Real a22_x_p2 = a21_x + 0.394 * (a22_x_p1 + wd21_y);
  const Real a23_y_p1 = minus_w22_y * minus_w22_y;
  const Real a23_y_p2 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Lanes<2> f23_y_p1_lanes = w23_x_lanes * w23_y_lanes;
  const Lanes<2> n23_z_p1_lanes = w23_y_lanes * w23_z_lanes;

  // link 22 (head), outward
  const Real a23_y_p3 = n22_x_p1 - minus_wd22_y;

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p10_lanes = (w23_z_lanes + detail::make_pack<Real>(qd[22], qd[23])) *
      w23_x_lanes - (detail::make_pack<Real>(c23, c24) * wd22_z -
      detail::make_pack<Real>(s23, s24) * wd22_x);

  // link 22 (head), outward
  const Real a23_y_p4 = w22_x * w22_x;

  // link 15 (right_shoulder2), inward
  const Real n14_y = n7_y_p11_lanes[1] + (c15 * n15_x - s15 * n15_y);

  // link 23 (left_eye), outward
  const Real a23_y_p5 = a23_y_p1 + a23_y_p2;
  const Lanes<2> wd23_x_lanes = detail::make_pack<Real>(c23, c24) * wd22_x +
      detail::make_pack<Real>(s23, s24) * wd22_z + w23_y_lanes *
      detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> f23_y_p2_lanes = f23_y_p1_lanes + wd23_z_lanes;

  // link 22 (head), outward
  const Real a22_x = c22 * a22_x_p2 + s22 * a22_y_p3;

  // link 24 (right_eye), outward
  const Real a23_y_p7 = a22_z + 0.095 * n22_x_p2;

  // link 22 (head), outward
  const Real a22_y = c22 * a22_y_p3 - s22 * a22_x_p2;

  // link 23 (left_eye), outward
  const Real a23_y_p8 = a23_y_p4 + a23_y_p1;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> f23_y_lanes = 0.00025 * f23_y_p2_lanes;

  // link 24 (right_eye), outward
  const Real minus_a23_z_p6 = a22_y + 0.095 * minus_a23_z_p4;

  // link 14 (right_shoulder1), inward
  const Real n6_x_p2 = c14 * f14_x - s14 * f14_y;

  // link 24 (right_eye), outward
  const Real a23_y_p10 = a22_x - 0.095 * a23_y_p5;

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_z_lanes = minus_a23_z_p6 - detail::make_pack<Real>(0.032, (-0.032)) *
      minus_a23_z_p3;

  // link 21 (neck), outward
  const Real n21_z_p1 = w21_x * w21_y;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> minus_f23_x_lanes = 0.00025 * (w23_y_lanes * w23_y_lanes + n23_y_p3_lanes);
  const Lanes<2> n23_z_p7_lanes = 1.2499999999999999e-06 * f23_y_p1_lanes + 9.25e-06 *
      wd23_z_lanes + 2.8750000000000004e-05 * (n23_z_p1_lanes - wd23_x_lanes);
  const Lanes<2> n23_y_p13_lanes = 0.00025 * minus_a23_z_lanes;
  const Lanes<2> n23_x_lanes = 4e-06 * (n23_z_p1_lanes + wd23_x_lanes) - 2.8750000000000004e-05 *
      f23_y_p2_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_p13_lanes = detail::make_pack<Real>(s23, s24) *
      (a23_y_p10 + detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p3);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_lanes = 2.8750000000000004e-05 *
      (w23_x_lanes * w23_x_lanes - n23_y_p3_lanes) - 5.25e-06 * n23_y_p10_lanes + n23_y_p13_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_lanes = detail::make_pack<Real>(c23, c24) *
      (a23_y_p7 - detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p8) - a23_y_p13_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p9_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_y_lanes;
  const Lanes<2> n22_y_p11_lanes = detail::make_pack<Real>(c23, c24) * f23_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_x_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p11_lanes = 0.0017499999999999998 * (a7_y_lanes + a7_x_lanes);

  // link 23 (left_eye), inward
  const Real n22_y_p13 = n22_y_p11_lanes[1] + n22_y_p11_lanes[0];

  // link 21 (neck), outward
  const Real n21_x_p1 = n21_z_p1 + wd21_z;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p12_lanes = 0.00014700000000000002 * n7_x_p3_lanes + 0.00044800000000000005 *
      wd7_z_lanes + detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) *
      (n7_x_p1_lanes - wd7_x_lanes);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_lanes = n23_z_p7_lanes + 0.00025 * a23_y_lanes;
  tau[22] = n23_z_lanes[0];

  // link 24 (right_eye), inertial wrench
  tau[23] = n23_z_lanes[1];

  // link 23 (left_eye), inward
  const Lanes<2> n22_x_p12_lanes = detail::make_pack<Real>(c23, c24) * n23_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_y_lanes + detail::make_pack<Real>(8e-06, (-8e-06)) *
      n23_y_p10_lanes;
  const Real f22_z = 0.072575 * n22_x_p2 - 0.43200000000000005 * n22_x_p3 + n22_y_p13;
  const Lanes<2> n22_z_p1_lanes = detail::make_pack<Real>(s23, s24) * n23_x_lanes;
  const Lanes<2> n22_z_p3_lanes = detail::make_pack<Real>(c23, c24) * n23_y_lanes;
  const Real f22_y_p1 = n23_y_p10_lanes[1] + n23_y_p10_lanes[0];

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p14_lanes = n7_z_p12_lanes - detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p2_lanes + wd7_y_lanes) + 8.75e-06 *
      (n7_x_p4_lanes - n7_y_p3_lanes);

  // link 23 (left_eye), inward
  const Real n22_y_p14 = 0.0074 * n22_x_p3 - 0.009438624999999999 * n22_x_p2 - 0.072575 * a22_z -
      n23_z_lanes[1] - (-0.032) * n22_y_p9_lanes[1];
  const Real n22_x = 0.05450270000000001 * n22_x_p3 - 0.0074 * n22_x_p2 - 0.43200000000000005 *
      a22_z + n22_x_p12_lanes[1] + n22_x_p12_lanes[0];

  // link 21 (neck), outward
  const Real n21_y_p1 = w21_z * w21_z;
  const Real n21_y_p2 = a22_x_p1 - wd21_y;

  // link 23 (left_eye), inward
  const Real n22_z_p5 = 0.04506407500000001 * minus_a23_z_p1 + 0.06394132500000001 * wd22_z -
      0.0074 * (a23_y_p1 - a23_y_p4) + 0.072575 * a22_y;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = n6_x_p2 + n6_x_p1;

  // link 23 (left_eye), inward
  const Real f22_y = 0.072575 * minus_a23_z_p4 + 0.43200000000000005 * (a23_y_p4 + a23_y_p2) -
      0.00025 * f22_y_p1;

  // link 15 (right_shoulder2), inward
  const Real n14_z = n7_z_p14_lanes[1] + s15 * n15_x + c15 * n15_y + n7_z_p11_lanes[1];
  tau[13] = n14_z;

  // link 8 (left_shoulder2), inward
  const Real n7_z = n7_z_p14_lanes[0] + s8 * n8_x + c8 * n8_y + n7_z_p11_lanes[0];
  tau[6] = n7_z;

  // link 23 (left_eye), inward
  const Real n22_y = n22_y_p14 - n23_z_lanes[0] - 0.032 * n22_y_p9_lanes[0] - 0.095 * n22_y_p13;
  const Real f22_x = 0.43200000000000005 * (minus_a23_z_p1 + wd22_z) - 0.072575 * a23_y_p5 -
      n22_y_p9_lanes[1] - n22_y_p9_lanes[0];

  // link 5 (chest2), outward
  const Real n5_y_p1 = w5_x * w5_z + minus_wd5_y;

  // link 22 (head), inward
  const Real n21_y_p3 = s22 * f22_y - c22 * f22_x;
  const Real n21_z = 0.00621675 * wd21_z - 0.0048105000000000005 * n21_z_p1 + 0.0016155 * a22_z_p2 -
      0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;

  // link 14 (right_shoulder1), inward
  const Real n6_z_p1 = s14 * f14_x + c14 * f14_y;

  // link 23 (left_eye), inward
  const Real n22_z = n22_z_p5 + 0.43200000000000005 * a22_x + n22_z_p1_lanes[1] +
      n22_z_p3_lanes[1] + n22_z_p1_lanes[0] + n22_z_p3_lanes[0] - 2.375e-05 * f22_y_p1;
  tau[21] = n22_z;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * (a22_z_p1 + wd21_x) - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p2 = s7 * f7_x + c7 * f7_y;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_z_p2_lanes = 0.0017499999999999998 * (n7_x_p7_lanes - n7_x_p5_lanes);

  // link 6 (chest3), inertial wrench
  const Real n6_z_p3 = 1.26882463592404 * a7_y_p2 + 2.06965463592404 * wd6_z - 0.0187369177636143 *
      (a7_y_p3 - wd6_x) + 6.1665928899999995 * minus_a6_y;

  // link 8 (left_shoulder2), inward
  const Real f7_z = s8 * f8_x + c8 * f8_y + f7_z_p2_lanes[0];

  // link 15 (right_shoulder2), inward
  const Real f14_z = s15 * f15_x + c15 * f15_y + f7_z_p2_lanes[1];

  // link 7 (left_shoulder1), inward
  const Real n6_y_p2 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_y_p7 - 0.0187369177636143 *
      (minus_a7_z_p2 - a7_y_p1) + s21 * n21_x;

  // link 14 (right_shoulder1), inward
  const Real n6_x_p3 = 0.40041499999999997 * a7_y_p8 + 0.0187369177636143 * minus_a7_z_p1 - n21_z +
      (s14 * n14_x + c14 * n14_y + (-0.18) * n6_x_p2);

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a22_y_p1 - n21_y_p1) - 0.000703125 * n21_y_p2 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p3);
  const Real f21_z = 0.0045000000000000005 * n21_y_p2 - (s22 * f22_x + c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real f6_y_p1 = f14_z + f7_z;

  // link 22 (head), inward
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 7 (left_shoulder1), inward
  const Real n6_x = n6_x_p3 + (s7 * n7_x + c7 * n7_y + 0.18 * n6_x_p1);

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (a22_y_p2 + n21_y_p1) + n21_y_p3;

  // link 4 (chest1), outward
  const Real n4_x_p1 = w4_x * w4_y;
  const Real n4_x_p2 = n4_x_p1 + qdd_0[3];

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a7_y_p4 - f21_z + n6_z_p1 + n6_z_p2;

  // link 5 (chest2), outward
  const Real f5_x_p1 = minus_w5_y * minus_w5_y;

  // link 7 (left_shoulder1), inward
  const Real f6_y = f6_y_p1 - 6.1665928899999995 * minus_a7_z_p1 - s21 * minus_f21_x + c21 * f21_y;
  const Real n6_z_p4 = n6_z_p3 + c21 * n21_x - s21 * n21_y + c14 * n14_x - s14 * n14_y;
  const Real f6_z = n6_y_p1 - 6.1665928899999995 * a7_y_p7 - c21 * minus_f21_x - s21 * f21_y;
  const Real n6_y = n6_y_p2 + c21 * n21_y + n14_z + n7_z + 0.226 * n6_y_p1;

  // link 4 (chest1), outward
  const Real n4_y_p1 = qd[3] * qd[3];
  const Real n4_y_p2 = wd4_y_p1 - wd4_y;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real f5_y = 0.069699984375 * (wd5_z - a6_z_p1) + 2.2194301519999997 * a6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_z = 0.069699984375 * n5_y_p1 - 2.2194301519999997 * a6_x_p4 + n5_x_p1;

  // link 3 (hip), outward
  const Real f3_x_p1 = w3_z * w3_z;

  // link 6 (chest3), inward
  const Real f5_x = 2.2194301519999997 * a6_z_p2 - 0.069699984375 * (f5_x_p1 + a6_x_p1) + f6_z;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p5 = n6_z_p4 - (-0.18) * n6_z_p1 + c7 * n7_x - s7 * n7_y - 0.18 * n6_z_p2;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p1 = 0.10961925816937637 * a6_z_p1 + 0.203126912024134 * wd5_z -
      0.005678398088837119 * (f5_x_p1 - a6_x_p2) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 5 (chest2), inward
  const Real f4_y = f5_z - 0.0300000063 * n4_x_p2;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p4 - 0.04675382692737882 * n5_y_p1 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 7 (left_shoulder1), inward
  const Real n6_z = n6_z_p5 - 0.226 * f6_y_p1;
  tau[5] = n6_z;

  // link 5 (chest2), inward
  const Real f4_x_p1 = s5 * f5_y - c5 * f5_x;

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p1 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);
  tau[4] = n5_z;

  // link 5 (chest2), inward
  const Real f4_x = 0.0300000063 * (a5_y_p3 + n4_y_p1) - f4_x_p1;

  // link 6 (chest3), inward
  const Real n5_x = 0.15637308509675518 * a6_x_p4 - 0.005678398088837119 * n5_y_p1 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);

  // link 5 (chest2), inward
  const Real minus_f4_z = 0.0300000063 * n4_y_p2 + (s5 * f5_x + c5 * f5_y);

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_x_p1 - 0.02999999505 * wd3_z + minus_f4_z;

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * f4_x_p1 -
      (0.01227760324629517 * n4_y_p2 + 0.005880002159562879 * (a5_y_p2 - n4_y_p1) + 0.0300000063 *
      a3_y);

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_x_p1 + 8.419374554 * wd3_z + (c4 * f4_x - s4 * f4_y);

  // link 5 (chest2), inward
  const Real n4_x = 0.0478915 * (wd4_x_p1 + wd4_x) + 0.005880002159562879 * n4_x_p2 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);
  const Real n4_z = 0.060169103246295166 * qdd_0[3] - 0.03561389675370483 * n4_x_p1 +
      0.005880002159562879 * minus_a5_z_p1 + 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 3 (hip), inward
  const Real f2_x_p1 = c3 * f3_x - s3 * f3_y;
  const Real f2_x = 24.5839218 * wd2_z - 0.031999971599999996 * a3_x_p1 + f2_x_p1;
  const Real f2_y = 0.031999971599999996 * wd2_z + 24.5839218 * a3_x_p1 + (s3 * f3_x + c3 * f3_y);

  // link 4 (chest1), inward
  const Real n3_z = 1.7824817919087104 * wd3_z + (8.419374554 * a3_x - 0.02999999505 * a3_y) +
      (s4 * n4_x + c4 * n4_y);
  tau[2] = n3_z;

  // link 3 (hip), inward
  const Real n2_z = 9.885744550888212 * wd2_z + (0.031999971599999996 * a2_y + 24.5839218 * a2_x) +
      (n3_z + 0.422 * f2_x_p1);
  tau[1] = n2_z;

  // link 2 (thigh), inward
  const Real n1_z = 13.049859506913753 * qdd_0[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + 0.434 * (c2 * f2_x - s2 * f2_y));
  tau[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
