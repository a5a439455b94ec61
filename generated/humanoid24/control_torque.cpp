// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins, alike limbs in lanes.
// 8953 flops (add 3944, mul 4965, div 44), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
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
  const Lanes<2> inverse_D10_p10_lanes = detail::make_pack<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.001742099791326752, 0.001742099791326752) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p12_lanes = detail::make_pack<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.27310176737964387), (-0.27310176737964387)) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> inverse_D12_p4_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D10_p14_lanes = detail::make_pack<Real>(c13, c20) * inverse_D10_p10_lanes;
  const Lanes<2> inverse_D10_p15_lanes = detail::make_pack<Real>(s13, s20) * inverse_D10_p10_lanes;
  const Lanes<2> inverse_D10_p16_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(s13, s20) - 0.01626499875 *
      detail::make_pack<Real>(c13, c20) - 0.0006000000000000001;
  const Lanes<2> inverse_D10_p17_lanes = detail::make_pack<Real>(s13, s20) * inverse_D10_p12_lanes;
  const Lanes<2> inverse_D11_p2_lanes = detail::make_pack<Real>((-0.00013384878959057754),
      0.00013384878959057754) + detail::make_pack<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D10_p19_lanes = 0.0006340258712020409 + inverse_D10_p14_lanes;
  const Lanes<2> inverse_D10_p20_lanes = inverse_D10_p15_lanes -
      detail::make_pack<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (inverse_D12_p4_lanes -
      detail::make_pack<Real>((-0.0010519177038056625), (-0.0010519177038056625)));
  const Lanes<2> inverse_D11_p4_lanes = inverse_D11_p2_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p25_lanes = inverse_D10_p19_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p26_lanes = inverse_D10_p16_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p27_lanes = inverse_D10_p20_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p34_lanes = inverse_D10_p16_lanes * inverse_D10_p25_lanes;
  const Lanes<2> inverse_D10_p35_lanes = inverse_D10_p16_lanes * inverse_D10_p26_lanes;
  const Lanes<2> inverse_D10_p38_lanes = inverse_D10_p16_lanes * inverse_D10_p27_lanes;
  const Lanes<2> inverse_D11_p6_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes -
      inverse_D11_p2_lanes * inverse_D11_p4_lanes;
  const Lanes<2> inverse_D10_p39_lanes = detail::make_pack<Real>((-0.00033044389597753786),
      0.00033044389597753786) + inverse_D10_p15_lanes + inverse_D11_p2_lanes *
      inverse_D10_p25_lanes;
  const Lanes<2> inverse_D10_p40_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(c13, c20) + 0.01626499875 *
      detail::make_pack<Real>(s13, s20) - inverse_D11_p2_lanes * inverse_D10_p26_lanes;
  const Lanes<2> inverse_D10_p41_lanes = inverse_D10_p14_lanes -
      detail::make_pack<Real>(0.002376125662528793, 0.002376125662528793) - inverse_D11_p2_lanes *
      inverse_D10_p27_lanes;
  const Lanes<2> inverse_D10_p42_lanes = detail::make_pack<Real>(0.008744893195371809,
      0.008744893195371809) + inverse_D10_p17_lanes + inverse_D10_p19_lanes * inverse_D10_p25_lanes;
  const Lanes<2> inverse_D10_p44_lanes = detail::make_pack<Real>(c13, c20) * inverse_D10_p12_lanes -
      detail::make_pack<Real>((-0.04964593582762564), 0.04964593582762564) - inverse_D10_p19_lanes *
      inverse_D10_p27_lanes;
  const Lanes<2> inverse_D10_p45_lanes = inverse_D10_p17_lanes - 0.2818466605750157 -
      inverse_D10_p20_lanes * inverse_D10_p27_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p53_lanes = 2.0 * detail::make_pack<Real>(c11, c18);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D11_p8_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p6_lanes);
  const Lanes<2> inverse_D10_p56_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p39_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p40_lanes;
  const Lanes<2> inverse_D10_p57_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p41_lanes;
  const Lanes<2> inverse_D10_p59_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p41_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> inverse_D10_p60_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p38_lanes +
      detail::make_pack<Real>(s12, s19) * inverse_D10_p44_lanes;
  const Lanes<2> inverse_D11_p9_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p8_lanes;
  const Lanes<2> inverse_D10_p61_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p56_lanes;
  const Lanes<2> inverse_D10_p64_lanes = detail::make_pack<Real>(c12, c19) *
      (2.0 * inverse_D10_p34_lanes) - detail::make_pack<Real>(s12, s19) *
      (inverse_D10_p42_lanes - inverse_D10_p35_lanes);
  const Lanes<2> inverse_D10_p65_lanes = 0.269 * inverse_D10_p45_lanes - inverse_D10_p59_lanes;
  const Lanes<2> inverse_D10_p66_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p56_lanes;
  const Lanes<2> inverse_D10_p67_lanes = 0.269 * inverse_D10_p60_lanes;
  const Lanes<2> inverse_D8_p1_lanes = 6e-04 - inverse_D10_p57_lanes;
  const Lanes<2> inverse_D10_p70_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p64_lanes;
  const Lanes<2> inverse_D10_p72_lanes = inverse_D10_p66_lanes + inverse_D10_p67_lanes;
  const Lanes<2> inverse_D8_p2_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      inverse_D10_p61_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p1_lanes = 2.0 * detail::make_pack<Real>(c10, c17);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p74_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p8_lanes + 0.269 * inverse_D10_p57_lanes);
  const Lanes<2> inverse_D10_p75_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      inverse_D10_p61_lanes;
  const Lanes<2> inverse_D10_p76_lanes = inverse_D10_p70_lanes - inverse_D10_p35_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p6_lanes + inverse_D11_p9_lanes));
  const Lanes<2> inverse_D10_p83_lanes = inverse_D10_p74_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p84_lanes = inverse_D10_p75_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p4_lanes = inverse_D8_p2_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p5_lanes = inverse_D8_p1_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p88_lanes = 0.000131 - inverse_D11_p9_lanes + 0.269 *
      (inverse_D10_p65_lanes - inverse_D10_p59_lanes) - inverse_D10_p74_lanes *
      inverse_D10_p83_lanes;
  const Lanes<2> inverse_D10_p89_lanes = 0.0001098 + 0.07236100000000001 * inverse_D10_p76_lanes -
      inverse_D10_p75_lanes * inverse_D10_p84_lanes;
  const Lanes<2> inverse_D10_p90_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      inverse_D10_p72_lanes - inverse_D10_p74_lanes * inverse_D10_p84_lanes;
  const Lanes<2> inverse_D8_p10_lanes = inverse_D10_p74_lanes * inverse_D8_p4_lanes -
      inverse_D10_p72_lanes;
  const Lanes<2> inverse_D8_p11_lanes = inverse_D10_p67_lanes - inverse_D10_p75_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D8_p12_lanes = inverse_D10_p75_lanes * inverse_D8_p4_lanes - 0.269 *
      inverse_D10_p76_lanes;
  const Lanes<2> inverse_D8_p13_lanes = inverse_D10_p65_lanes - inverse_D10_p74_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D8_p19_lanes = inverse_D10_p76_lanes - inverse_D8_p2_lanes *
      inverse_D8_p4_lanes;
  const Lanes<2> inverse_D8_p20_lanes = inverse_D10_p45_lanes - inverse_D8_p1_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D8_p21_lanes = inverse_D8_p2_lanes * inverse_D8_p5_lanes -
      inverse_D10_p60_lanes;
  const Lanes<2> inverse_D10_p94_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p88_lanes - inverse_D10_p89_lanes) + inverse_D10_p53_lanes *
      inverse_D10_p90_lanes;
  const Lanes<2> inverse_D8_p26_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p10_lanes - inverse_D8_p11_lanes) + detail::make_pack<Real>(c11, c18) *
      (inverse_D8_p12_lanes + inverse_D8_p13_lanes);
  const Lanes<2> inverse_D10_p95_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p94_lanes;
  const Lanes<2> inverse_D8_p30_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p26_lanes;
  const Lanes<2> inverse_D8_p32_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p26_lanes;
  const Lanes<2> inverse_D8_p33_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p19_lanes - inverse_D8_p20_lanes) + inverse_D10_p53_lanes * inverse_D8_p21_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p34_lanes = inverse_D10_p66_lanes - inverse_D10_p39_lanes;
  const Lanes<2> inverse_D8_p35_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p38_lanes -
      detail::make_pack<Real>(c12, c19) * inverse_D10_p44_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p38_lanes = inverse_D8_p11_lanes + inverse_D8_p32_lanes;
  const Lanes<2> inverse_D8_p40_lanes = inverse_D8_p34_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p41_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p33_lanes;
  const Lanes<2> inverse_D10_p97_lanes = 0.060888541114265754 +
      (inverse_D10_p89_lanes + inverse_D10_p95_lanes);
  const Lanes<2> inverse_D9_p5_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p94_lanes -
      inverse_D10_p90_lanes);
  const Lanes<2> inverse_D8_p43_lanes = inverse_D8_p30_lanes - inverse_D8_p13_lanes -
      0.28049749700000004;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p45_lanes = inverse_D10_p34_lanes - detail::make_pack<Real>(c12, c19) *
      inverse_D10_p64_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p97_lanes;
  const Lanes<2> inverse_D9_p7_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p97_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p54_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      (0.269 * inverse_D8_p35_lanes - (inverse_D10_p61_lanes - inverse_D10_p40_lanes)) -
      inverse_D10_p74_lanes * inverse_D8_p40_lanes;
  const Lanes<2> inverse_D8_p55_lanes = 0.269 * inverse_D8_p45_lanes - 6e-04 -
      inverse_D10_p75_lanes * inverse_D8_p40_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p9_lanes = inverse_D9_p5_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p60_lanes = inverse_D8_p43_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p11_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p97_lanes;
  const Lanes<2> inverse_D8_p63_lanes = inverse_D8_p38_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p13_lanes = 0.0001499998887063 + inverse_D9_p5_lanes *
      inverse_D9_p7_lanes;
  const Lanes<2> inverse_D8_p67_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p60_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p68_lanes = inverse_D8_p2_lanes * inverse_D8_p40_lanes -
      inverse_D8_p45_lanes;
  const Lanes<2> inverse_D8_p69_lanes = inverse_D8_p35_lanes - inverse_D8_p1_lanes *
      inverse_D8_p40_lanes;
  const Lanes<2> inverse_D8_p72_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * inverse_D8_p54_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p55_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p15_lanes = 0.06060754126741261 +
      (inverse_D10_p88_lanes - inverse_D10_p95_lanes) - inverse_D9_p5_lanes * inverse_D9_p9_lanes;
  const Lanes<2> inverse_D8_p78_lanes = inverse_D8_p10_lanes - inverse_D8_p32_lanes -
      inverse_D9_p5_lanes * inverse_D8_p60_lanes;
  const Lanes<2> inverse_D8_p81_lanes = inverse_D8_p72_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p83_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p84_lanes = 0.28049749700000004 +
      (inverse_D8_p30_lanes - inverse_D8_p12_lanes) - inverse_D9_p5_lanes * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p86_lanes = inverse_D8_p19_lanes - inverse_D8_p41_lanes -
      inverse_D8_p43_lanes * inverse_D8_p60_lanes;
  const Lanes<2> inverse_D8_p92_lanes = inverse_D8_p20_lanes + inverse_D8_p41_lanes -
      inverse_D8_p38_lanes * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p94_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p81_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p103_lanes = 2.0 * detail::make_pack<Real>(s9, s16);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p105_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p54_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p55_lanes + inverse_D9_p5_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p107_lanes = inverse_D10_p42_lanes + inverse_D10_p70_lanes +
      inverse_D8_p34_lanes * inverse_D8_p40_lanes + inverse_D8_p72_lanes * inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p108_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p68_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p69_lanes + inverse_D8_p43_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D9_p18_lanes = inverse_D9_p1_lanes * inverse_D9_p13_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D9_p15_lanes - inverse_D9_p11_lanes);
  const Lanes<2> inverse_D8_p109_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p83_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p84_lanes;
  const Lanes<2> inverse_D8_p110_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p33_lanes -
      inverse_D8_p21_lanes - inverse_D8_p43_lanes * inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p111_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p68_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p69_lanes + inverse_D8_p72_lanes *
      inverse_D8_p63_lanes;
  const Lanes<2> inverse_D8_p112_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p84_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p83_lanes;
  const Lanes<2> inverse_D9_p19_lanes = detail::make_pack<Real>(s10, s17) * inverse_D9_p18_lanes;
  const Lanes<2> inverse_D8_p121_lanes = inverse_D8_p112_lanes + 0.282 * inverse_D8_p92_lanes;
  const Lanes<2> inverse_D8_p127_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p110_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p111_lanes;
  const Lanes<2> inverse_D6_p5_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p111_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p110_lanes;
  const Lanes<2> inverse_D8_p128_lanes = detail::make_pack<Real>(c10, c17) *
      (inverse_D8_p67_lanes + inverse_D8_p105_lanes) - detail::make_pack<Real>(s10, s17) *
      (inverse_D8_p78_lanes + inverse_D8_p94_lanes);
  const Lanes<2> inverse_D8_p129_lanes = inverse_D9_p1_lanes * inverse_D8_p108_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D8_p86_lanes + inverse_D8_p107_lanes);
  const Lanes<2> inverse_D8_p132_lanes = 0.282 * inverse_D8_p127_lanes;
  const Lanes<2> inverse_D6_p7_lanes = inverse_D8_p109_lanes - 0.0022500062;
  const Lanes<2> inverse_D8_p133_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p128_lanes;
  const Lanes<2> inverse_D8_p134_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p129_lanes;
  const Lanes<2> inverse_D8_p135_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p128_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (inverse_D9_p11_lanes - inverse_D9_p19_lanes));

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p136_lanes = 0.282 * inverse_D8_p109_lanes -
      (inverse_D9_p13_lanes - detail::make_pack<Real>(c10, c17) * inverse_D9_p18_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D8_p138_lanes = inverse_D8_p105_lanes - inverse_D8_p133_lanes;
  const Lanes<2> inverse_D8_p139_lanes = inverse_D8_p86_lanes + inverse_D8_p134_lanes;
  const Lanes<2> inverse_D6_p13_lanes = inverse_D8_p94_lanes + inverse_D8_p135_lanes;
  const Lanes<2> inverse_D6_p15_lanes = inverse_D8_p108_lanes - detail::make_pack<Real>(c10, c17) *
      inverse_D8_p129_lanes;
  const Lanes<2> inverse_D8_p144_lanes = inverse_D8_p78_lanes + inverse_D8_p135_lanes +
      inverse_D8_p132_lanes;
  const Lanes<2> inverse_D6_p19_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      inverse_D8_p138_lanes;
  const Lanes<2> inverse_D8_p146_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * inverse_D8_p138_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p148_lanes = inverse_D8_p136_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D8_p149_lanes = inverse_D8_p146_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D6_p31_lanes = inverse_D6_p19_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D6_p33_lanes = inverse_D6_p7_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D6_p35_lanes = inverse_D6_p13_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D8_p151_lanes = inverse_D8_p136_lanes * inverse_D8_p148_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p1_lanes = 2.0 * detail::make_pack<Real>(c8, c15);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p154_lanes = 0.0019585440854647937 +
      (inverse_D9_p15_lanes + inverse_D9_p19_lanes + 0.282 *
      (inverse_D8_p112_lanes + inverse_D8_p121_lanes)) - inverse_D8_p151_lanes;
  const Lanes<2> inverse_D8_p155_lanes = 0.0008177492704690715 + 0.07952399999999998 *
      inverse_D8_p139_lanes - inverse_D8_p146_lanes * inverse_D8_p149_lanes;
  const Lanes<2> inverse_D8_p156_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * inverse_D8_p144_lanes - inverse_D8_p136_lanes *
      inverse_D8_p149_lanes;
  const Lanes<2> inverse_D6_p49_lanes = inverse_D8_p144_lanes + inverse_D8_p136_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p51_lanes = inverse_D8_p132_lanes + inverse_D8_p146_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p53_lanes = inverse_D8_p121_lanes - inverse_D8_p136_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p55_lanes = inverse_D8_p146_lanes * inverse_D6_p31_lanes - 0.282 *
      inverse_D8_p139_lanes;
  const Lanes<2> inverse_D6_p57_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * inverse_D6_p5_lanes - (inverse_D8_p67_lanes - inverse_D8_p133_lanes)) +
      inverse_D8_p136_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p59_lanes = 0.0022500062 + 0.282 * inverse_D6_p15_lanes +
      inverse_D8_p146_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D8_p160_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D8_p154_lanes - inverse_D8_p155_lanes) - inverse_D8_p103_lanes *
      inverse_D8_p156_lanes;
  const Lanes<2> inverse_D6_p81_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p49_lanes + inverse_D6_p51_lanes) - detail::make_pack<Real>(s9, s16) *
      (inverse_D6_p55_lanes + inverse_D6_p53_lanes);
  const Lanes<2> inverse_D6_p83_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * inverse_D6_p57_lanes -
      detail::make_pack<Real>(s9, s16) * inverse_D6_p59_lanes);
  const Lanes<2> inverse_D8_p161_lanes = detail::make_pack<Real>(c9, c16) * inverse_D8_p160_lanes;
  const Lanes<2> inverse_D6_p85_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p81_lanes;
  const Lanes<2> inverse_D6_p87_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p81_lanes;
  const Lanes<2> inverse_D6_p93_lanes = inverse_D6_p87_lanes - inverse_D6_p51_lanes;
  const Lanes<2> inverse_D8_p163_lanes = 0.18125194219699997 +
      (inverse_D8_p155_lanes + inverse_D8_p161_lanes);
  const Lanes<2> inverse_D7_p5_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * inverse_D8_p160_lanes + inverse_D8_p156_lanes);
  const Lanes<2> inverse_D6_p97_lanes = 0.7139200499999999 +
      (inverse_D6_p85_lanes + inverse_D6_p53_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p163_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p103_lanes = inverse_D8_p139_lanes - inverse_D6_p19_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p107_lanes = inverse_D8_p92_lanes - inverse_D6_p7_lanes *
      inverse_D6_p33_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p8_lanes = inverse_D7_p5_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p9_lanes = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p163_lanes;
  const Lanes<2> inverse_D6_p113_lanes = inverse_D6_p83_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D6_p115_lanes = inverse_D6_p97_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D6_p119_lanes = inverse_D6_p93_lanes * inverse_D8_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p121_lanes = inverse_D8_p127_lanes + inverse_D6_p19_lanes *
      inverse_D6_p33_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p127_lanes = 0.00010499999999999999 * inverse_D6_p115_lanes;
  const Lanes<2> inverse_D6_p129_lanes = 0.00010499999999999999 * inverse_D6_p113_lanes;
  const Lanes<2> inverse_D7_p12_lanes = 0.18113119219699997 +
      (inverse_D8_p154_lanes - inverse_D8_p161_lanes) - inverse_D7_p5_lanes * inverse_D7_p8_lanes;
  const Lanes<2> inverse_D7_p13_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + 0.00010499999999999999 * inverse_D7_p8_lanes;
  const Lanes<2> inverse_D6_p147_lanes = inverse_D7_p5_lanes * inverse_D6_p113_lanes -
      (detail::make_pack<Real>(s9, s16) * inverse_D6_p57_lanes + detail::make_pack<Real>(c9, c16) *
      inverse_D6_p59_lanes);
  const Lanes<2> inverse_D6_p151_lanes = inverse_D6_p49_lanes - inverse_D6_p87_lanes -
      inverse_D7_p5_lanes * inverse_D6_p115_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p153_lanes = inverse_D6_p15_lanes + inverse_D6_p19_lanes *
      inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p159_lanes = inverse_D6_p5_lanes + inverse_D6_p7_lanes *
      inverse_D6_p35_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p161_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * inverse_D6_p119_lanes;
  const Lanes<2> inverse_D6_p163_lanes = inverse_D6_p85_lanes + inverse_D6_p55_lanes -
      0.7139200499999999 - inverse_D7_p5_lanes * inverse_D6_p119_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p165_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p103_lanes - inverse_D6_p107_lanes) - inverse_D8_p103_lanes *
      inverse_D6_p121_lanes;
  const Lanes<2> inverse_D6_p185_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p165_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p193_lanes = inverse_D8_p107_lanes + inverse_D8_p134_lanes +
      inverse_D6_p13_lanes * inverse_D6_p35_lanes + inverse_D6_p83_lanes * inverse_D6_p113_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p203_lanes = 2.0 * detail::make_pack<Real>(s7, s14);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p17_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D7_p9_lanes - inverse_D7_p12_lanes) + inverse_D7_p1_lanes * inverse_D7_p13_lanes;
  const Lanes<2> inverse_D6_p217_lanes = detail::make_pack<Real>(c8, c15) *
      (inverse_D6_p147_lanes + inverse_D6_p127_lanes) - detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p129_lanes + inverse_D6_p151_lanes);
  const Lanes<2> inverse_D6_p219_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p153_lanes -
      detail::make_pack<Real>(c9, c16) * inverse_D6_p159_lanes + inverse_D6_p83_lanes *
      inverse_D6_p115_lanes;
  const Lanes<2> inverse_D6_p221_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * inverse_D6_p161_lanes + detail::make_pack<Real>(c8, c15) *
      inverse_D6_p163_lanes);
  const Lanes<2> inverse_D6_p223_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p153_lanes +
      detail::make_pack<Real>(s9, s16) * inverse_D6_p159_lanes + inverse_D6_p83_lanes *
      inverse_D6_p119_lanes;
  const Lanes<2> inverse_D7_p18_lanes = detail::make_pack<Real>(s8, s15) * inverse_D7_p17_lanes;
  const Lanes<2> inverse_D6_p227_lanes = inverse_D6_p103_lanes - inverse_D6_p185_lanes -
      inverse_D6_p97_lanes * inverse_D6_p115_lanes;
  const Lanes<2> inverse_D6_p231_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p165_lanes +
      inverse_D6_p121_lanes - inverse_D6_p97_lanes * inverse_D6_p119_lanes;
  const Lanes<2> inverse_D6_p233_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p217_lanes;
  const Lanes<2> inverse_D6_p235_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p217_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p1_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Real inverse_D22_p3 = c24 + c23;
  const Lanes<2> inverse_D21_p3_lanes = detail::make_pack<Real>(c23, c24) * inverse_D21_p1_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p255_lanes = inverse_D6_p151_lanes + inverse_D6_p235_lanes;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p5 = s24 + s23;
  const Lanes<2> inverse_D22_p4_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Lanes<2> inverse_D21_p8_lanes = detail::make_pack<Real>(s23, s24) * inverse_D21_p1_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p20_lanes = 0.000448 + (inverse_D7_p12_lanes + inverse_D7_p18_lanes);
  const Lanes<2> inverse_D6_p259_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p17_lanes -
      inverse_D7_p13_lanes);
  const Lanes<2> inverse_D6_p263_lanes = 0.0017499999999999998 +
      (inverse_D6_p233_lanes - inverse_D6_p127_lanes);

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p10_lanes = inverse_D21_p3_lanes - 0.0007770270270270272;
  const Lanes<2> inverse_D21_p12_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);
  const Real inverse_D22_p6 = inverse_D22_p4_lanes[1] + inverse_D22_p4_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D7_lanes = 1.0 / inverse_D7_p20_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p14_lanes = 0.006756756756756757 * detail::make_pack<Real>(s23, s24);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p269_lanes = inverse_D7_p1_lanes * inverse_D6_p219_lanes -
      detail::make_pack<Real>(s8, s15) * (inverse_D6_p193_lanes + inverse_D6_p227_lanes);

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p16 = inverse_D21_p8_lanes[1] + inverse_D21_p8_lanes[0];
  const Lanes<2> inverse_D21_p17_lanes = detail::make_pack<Real>(0.032, (-0.032)) *
      inverse_D21_p10_lanes;
  const Real inverse_D6_p271 = 0.431222972972973 + inverse_D21_p3_lanes[1] +
      inverse_D21_p10_lanes[0];
  const Real inverse_D6_p272 = 0.072575 + 0.00025 * inverse_D22_p3;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p273_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p269_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p19_lanes = detail::make_pack<Real>(c23, c24) * inverse_D21_p14_lanes;
  const Lanes<2> inverse_D21_p21_lanes = detail::make_pack<Real>(s23, s24) * inverse_D21_p14_lanes;
  const Real inverse_D21_p23 = inverse_D21_p12_lanes[0] + 2.375e-05 * inverse_D21_p5 +
      inverse_D21_p12_lanes[1];

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p6 + 4.75e-05 * inverse_D22_p3);

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p28 = inverse_D21_p17_lanes[1] + inverse_D21_p17_lanes[0] - 0.095 *
      inverse_D21_p16;
  const Lanes<2> inverse_D21_p29_lanes = inverse_D21_p21_lanes - 0.006756756756756757;
  const Lanes<2> inverse_D21_p31_lanes = 0.095 * inverse_D21_p19_lanes +
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D21_p21_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p281_lanes = inverse_D6_p263_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p283_lanes = inverse_D6_p221_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p285_lanes = inverse_D6_p255_lanes * inverse_D7_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p37_lanes = 0.095 * inverse_D21_p29_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D21_p19_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p297_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p283_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p39 = inverse_D21_p37_lanes[1] + inverse_D21_p37_lanes[0];
  const Real inverse_D21_p40 = inverse_D21_p3_lanes[1] + inverse_D21_p3_lanes[0];
  const Real inverse_D6_p299 = 2.0 * c22;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p300_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p281_lanes;
  const Lanes<2> inverse_D6_p306_lanes = inverse_D6_p107_lanes + inverse_D6_p185_lanes -
      inverse_D6_p93_lanes * inverse_D6_p119_lanes - inverse_D6_p221_lanes * inverse_D6_p283_lanes;
  const Lanes<2> inverse_D6_p308_lanes = inverse_D6_p193_lanes + inverse_D6_p273_lanes +
      inverse_D6_p263_lanes * inverse_D6_p281_lanes;
  const Lanes<2> inverse_D6_p310_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p223_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p231_lanes - inverse_D6_p221_lanes *
      inverse_D6_p281_lanes;
  const Lanes<2> inverse_D6_p312_lanes = inverse_D6_p129_lanes + inverse_D6_p235_lanes +
      inverse_D6_p259_lanes * inverse_D6_p281_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p41 = inverse_D21_p28 * inverse_D22;
  const Real inverse_D6_p314 = inverse_D6_p271 * inverse_D22;
  const Real inverse_D6_p315 = inverse_D6_p272 * inverse_D22;
  const Real inverse_D6_p316 = inverse_D21_p16 * inverse_D22;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p321_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p161_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p163_lanes - inverse_D6_p259_lanes *
      inverse_D6_p283_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p42 = 0.05450270000000001 + inverse_D22_p6 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - inverse_D21_p23 * inverse_D21_p23 * inverse_D22;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p325_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p223_lanes +
      detail::make_pack<Real>(c8, c15) * inverse_D6_p231_lanes - inverse_D6_p221_lanes *
      inverse_D6_p285_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p327 = inverse_D21_p28 * inverse_D6_p315;
  const Real inverse_D21_p43 = inverse_D21_p42 - 0.00017071621621621625;
  const Real inverse_D4_p1 = inverse_D6_p272 * inverse_D6_p316;
  const Real inverse_D6_p330 = inverse_D21_p23 * inverse_D6_p314 - inverse_D21_p16;
  const Real inverse_D6_p331 = inverse_D21_p31_lanes[1] + inverse_D21_p31_lanes[0] +
      inverse_D21_p28 * inverse_D6_p314;
  const Real inverse_D6_p332 = inverse_D6_p272 * inverse_D6_p315;
  const Real inverse_D6_p333 = inverse_D6_p271 * inverse_D6_p315;
  const Real inverse_D6_p334 = inverse_D21_p23 * inverse_D6_p315 - 0.00025 * inverse_D21_p5;
  const Real inverse_D6_p335 = 0.072575 + inverse_D21_p39 + inverse_D21_p28 * inverse_D6_p316;
  const Real inverse_D6_p336 = inverse_D21_p40 - 0.43200000000000005 + inverse_D21_p23 *
      inverse_D6_p316;
  const Real inverse_D21_p44 = 0.009438624999999999 - (-0.032) * inverse_D21_p31_lanes[1] - 0.032 *
      inverse_D21_p31_lanes[0] - inverse_D21_p28 * inverse_D21_p41 + 0.095 * inverse_D21_p39;
  const Real inverse_D21_p45 = 0.0074 - (-0.032) * inverse_D21_p8_lanes[1] - 0.032 *
      inverse_D21_p8_lanes[0] + inverse_D21_p23 * inverse_D21_p41 - 0.095 * inverse_D21_p40;
  const Real inverse_D4_p2 = inverse_D21_p19_lanes[1] + inverse_D21_p19_lanes[0] - inverse_D6_p271 *
      inverse_D6_p316;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p339_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p306_lanes + inverse_D6_p308_lanes) - inverse_D6_p203_lanes *
      inverse_D6_p310_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p341 = inverse_D21_p21_lanes[1] + inverse_D21_p21_lanes[0] +
      inverse_D6_p271 * inverse_D6_p314;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p342_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p269_lanes -
      inverse_D6_p219_lanes - inverse_D6_p263_lanes * inverse_D6_p285_lanes;
  const Lanes<2> inverse_D6_p346_lanes = inverse_D6_p259_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p348_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p20_lanes;
  const Lanes<2> inverse_D6_p354_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p339_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p360 = c22 * inverse_D6_p335 - s22 * inverse_D6_p336;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p367_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p312_lanes - inverse_D6_p297_lanes) - detail::make_pack<Real>(s7, s14) *
      (inverse_D6_p321_lanes - inverse_D6_p300_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p369 = s22 * (inverse_D6_p330 + inverse_D6_p327) + c22 *
      (inverse_D6_p334 - inverse_D6_p331);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p370_lanes = inverse_D6_p306_lanes - inverse_D6_p354_lanes;
  const Lanes<2> inverse_D6_p372_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p325_lanes +
      detail::make_pack<Real>(c7, c14) * inverse_D6_p342_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p46 = s22 * (inverse_D21_p43 - inverse_D21_p44) + inverse_D6_p299 *
      inverse_D21_p45;
  const Real inverse_D6_p374 = c22 * inverse_D6_p336 + s22 * inverse_D6_p335;
  const Real inverse_D6_p375 = inverse_D21_p29_lanes[1] + inverse_D21_p29_lanes[0] -
      inverse_D21_p16 * inverse_D6_p316;
  const Real inverse_D6_p376 = inverse_D6_p299 * inverse_D6_p333 - s22 *
      (inverse_D6_p332 - inverse_D6_p341);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p377_lanes = 0.0002975 + (inverse_D7_p9_lanes - inverse_D7_p18_lanes) -
      inverse_D6_p259_lanes * inverse_D6_p346_lanes;
  const Lanes<2> inverse_D6_p379_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p367_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p381 = c22 * inverse_D6_p369;
  const Real inverse_D6_p382 = s22 * inverse_D6_p369;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p383_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p346_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p47 = s22 * inverse_D21_p46;
  const Real inverse_D6_p387 = s22 * inverse_D6_p376;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p388 = 2.0 * s21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p393_lanes = inverse_D6_p300_lanes - inverse_D6_p379_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D4_p3 = c22 * inverse_D4_p1 - s22 * inverse_D4_p2;
  const Real inverse_D6_p395 = inverse_D6_p381 - inverse_D6_p334;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p396_lanes = 0.0001505 - inverse_D6_p348_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D4_p4 = inverse_D6_p382 - inverse_D6_p327;
  const Real inverse_D6_p398 = c22 * inverse_D4_p2 + s22 * inverse_D4_p1;
  const Real inverse_D6_p399 = inverse_D6_p374 - 0.394 * inverse_D6_p375;
  const Real inverse_D6_p400 = inverse_D6_p387 - inverse_D6_p341;
  const Real inverse_D6_p405 = 0.394 * inverse_D6_p395;
  const Real inverse_D6_p412 = 0.394 * inverse_D6_p398;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p421_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p285_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D4_p5 = inverse_D6_p333 - c22 * inverse_D6_p376;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p44 + inverse_D21_p47));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p425 = 0.0016155 + (c22 * inverse_D21_p46 - inverse_D21_p45 + 0.394 *
      inverse_D6_p360);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p426_lanes = inverse_D6_p227_lanes + inverse_D6_p273_lanes -
      inverse_D6_p255_lanes * inverse_D6_p285_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p428 = inverse_D6_p330 - inverse_D6_p382 - inverse_D6_p412;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p429_lanes = inverse_D6_p233_lanes - inverse_D6_p147_lanes -
      0.0017499999999999998 - inverse_D6_p259_lanes * inverse_D6_p285_lanes;
  const Lanes<2> inverse_D6_p433_lanes = inverse_D6_p393_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p370_lanes + 0.226 *
      inverse_D6_p372_lanes);
  const Lanes<2> inverse_D6_p437_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p396_lanes - inverse_D6_p377_lanes) + inverse_D6_p203_lanes *
      inverse_D6_p383_lanes;
  const Lanes<2> inverse_D5_p5_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p367_lanes;
  const Lanes<2> inverse_D4_p8_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p339_lanes +
      inverse_D6_p310_lanes;
  const Lanes<2> inverse_D5_p11_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p325_lanes -
      detail::make_pack<Real>(s7, s14) * inverse_D6_p342_lanes;
  const Lanes<2> inverse_D6_p443_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p437_lanes;
  const Lanes<2> inverse_D5_p13_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p437_lanes;
  const Lanes<2> inverse_D4_p10_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      inverse_D4_p8_lanes;
  const Lanes<2> inverse_D4_p12_lanes = inverse_D6_p297_lanes + inverse_D5_p5_lanes;
  const Lanes<2> inverse_D6_p447_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p421_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p429_lanes;
  const Lanes<2> inverse_D6_p449_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D6_p393_lanes + inverse_D6_p433_lanes);
  const Lanes<2> inverse_D5_p17_lanes = 0.226 * inverse_D5_p11_lanes;
  const Lanes<2> inverse_D5_p19_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p421_lanes -
      detail::make_pack<Real>(c7, c14) * inverse_D6_p429_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D5_p21 = 0.0045000000000000005 + inverse_D6_p360;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p451 = inverse_D6_p443_lanes[1] + inverse_D6_p443_lanes[0];
  const Lanes<2> inverse_D6_p452_lanes = inverse_D6_p447_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p372_lanes + 0.226 *
      inverse_D6_p426_lanes);
  const Lanes<2> inverse_D4_p14_lanes = inverse_D4_p10_lanes - inverse_D4_p12_lanes;
  const Real inverse_D5_p22 = inverse_D5_p19_lanes[1] + inverse_D5_p19_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p454 = inverse_D6_p405 * inverse_D21;
  const Real inverse_D5_p25 = inverse_D6_p395 * inverse_D21;
  const Real inverse_D5_p26 = inverse_D5_p21 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p455 = inverse_D6_p452_lanes[1] + inverse_D6_p452_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p16 = inverse_D4_p4 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p27_lanes = inverse_D5_p5_lanes - inverse_D6_p312_lanes -
      (inverse_D4_p10_lanes + inverse_D5_p17_lanes);
  const Real inverse_D5_p31 = inverse_D5_p27_lanes[1] + inverse_D5_p27_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p456 = 0.005513625 + (inverse_D21_p43 - inverse_D21_p47 - 0.394 *
      (inverse_D6_p374 + inverse_D6_p399)) - inverse_D6_p425 * (inverse_D6_p425 * inverse_D21);
  const Real inverse_D6_p457 = 0.000703125 + 0.155236 * inverse_D6_p400 - inverse_D6_p405 *
      inverse_D6_p454;
  const Real inverse_D6_p458 = 0.394 * inverse_D6_p428 - inverse_D6_p425 * inverse_D6_p454;
  const Real inverse_D5_p32 = inverse_D6_p428 - inverse_D6_p425 * inverse_D5_p25;
  const Real inverse_D5_p33 = inverse_D6_p412 + inverse_D6_p405 * inverse_D5_p26;
  const Real inverse_D5_p34 = 0.394 * inverse_D6_p400 - inverse_D6_p405 * inverse_D5_p25;
  const Real inverse_D5_p35 = inverse_D6_p399 + inverse_D6_p425 * inverse_D5_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p36_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p27_lanes + inverse_D4_p12_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p17 = inverse_D6_p425 * inverse_D4_p16 -
      (inverse_D6_p381 + inverse_D6_p331 + 0.394 * inverse_D4_p3);
  const Real inverse_D4_p18 = inverse_D6_p405 * inverse_D4_p16 -
      (0.0045000000000000005 + 0.394 * inverse_D4_p5);

  // link 6 (chest3), articulated inertia
  const Real inverse_D4_p19 = inverse_D4_p8_lanes[1] + inverse_D4_p8_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D4_p20 = inverse_D6_p395 * inverse_D4_p16 - inverse_D4_p5;
  const Real inverse_D6_p459 = c21 * (inverse_D6_p456 - inverse_D6_p457) - inverse_D6_p388 *
      inverse_D6_p458;
  const Real inverse_D4_p21 = inverse_D4_p3 - inverse_D5_p21 * inverse_D4_p16;
  const Real inverse_D5_p38 = c21 * (inverse_D5_p32 - inverse_D5_p33) - s21 *
      (inverse_D5_p34 + inverse_D5_p35);
  const Real inverse_D5_p39 = inverse_D6_p400 - inverse_D6_p395 * inverse_D5_p25;
  const Real inverse_D6_p460 = c21 * inverse_D6_p459;
  const Real inverse_D5_p40 = inverse_D6_p375 - inverse_D5_p21 * inverse_D5_p26;
  const Real inverse_D5_p41 = c21 * inverse_D5_p38;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p42_lanes = inverse_D6_p379_lanes + inverse_D6_p321_lanes;
  const Lanes<2> inverse_D5_p44_lanes = inverse_D6_p354_lanes - inverse_D6_p308_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p46 = inverse_D6_p398 + inverse_D6_p395 * inverse_D5_p26;
  const Real inverse_D5_p47 = s21 * inverse_D5_p38;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D4_p22 = c21 * inverse_D4_p17 - s21 * inverse_D4_p18 +
      inverse_D6_p433_lanes[1] + inverse_D6_p433_lanes[0];

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p50 = inverse_D5_p44_lanes[1] + inverse_D5_p44_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p51 = s21 * inverse_D6_p459 + inverse_D6_p458 + 0.226 * inverse_D5_p31;
  const Lanes<2> inverse_D5_p52_lanes = inverse_D5_p42_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p44_lanes;
  const Real inverse_D5_p54 = inverse_D5_p33 + inverse_D5_p41 + inverse_D5_p31;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p55 = c21 * (inverse_D5_p39 - inverse_D5_p40) - inverse_D6_p388 *
      inverse_D5_p46;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p58 = 0.0187369177636143 + inverse_D5_p36_lanes[1] -
      inverse_D6_p383_lanes[1] + inverse_D5_p13_lanes[1] + inverse_D5_p36_lanes[0] -
      inverse_D6_p383_lanes[0] + inverse_D5_p13_lanes[0] + 0.226 * inverse_D5_p22;
  const Real inverse_D4_p23 = inverse_D5_p47 + inverse_D5_p35 - 6.1665928899999995 -
      inverse_D6_p455;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p59 = c21 * inverse_D5_p55;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p60_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p42_lanes + inverse_D5_p52_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p62 = 2.0 * c6;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p461 = 2.06965463592404 + inverse_D6_p457 + inverse_D6_p460 +
      inverse_D6_p377_lanes[1] + inverse_D6_p451 + inverse_D6_p449_lanes[1] +
      inverse_D6_p377_lanes[0] + inverse_D6_p449_lanes[0] + 0.226 *
      (inverse_D6_p447_lanes[1] + inverse_D6_p455 + inverse_D6_p447_lanes[0]);

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p461;
  const Real inverse_D5_p63 = inverse_D5_p54 * inverse_D6;
  const Real inverse_D5_p64 = inverse_D5_p51 * inverse_D6;
  const Real inverse_D5_p65 = inverse_D5_p58 * inverse_D6;
  const Real inverse_D4_p24 = inverse_D4_p22 * inverse_D6;
  const Real inverse_D4_p25 = inverse_D4_p23 * inverse_D6;
  const Real inverse_D5_p66 = inverse_D5_p52_lanes[1] + inverse_D5_p52_lanes[0] - inverse_D5_p58 *
      inverse_D5_p63;
  const Real inverse_D5_p67 = 0.40056549999999996 - inverse_D6_p348_lanes[1] - inverse_D6_p451 +
      inverse_D5_p60_lanes[1] + inverse_D6_p396_lanes[0] + inverse_D5_p60_lanes[0] -
      inverse_D5_p58 * inverse_D5_p65;
  const Real inverse_D5_p68 = inverse_D5_p40 + inverse_D5_p59 + inverse_D5_p50 - inverse_D5_p54 *
      inverse_D5_p63;
  const Real inverse_D4_p26 = inverse_D4_p14_lanes[1] + inverse_D4_p14_lanes[0] + inverse_D5_p58 *
      inverse_D4_p24;
  const Real inverse_D4_p27 = inverse_D5_p32 - inverse_D5_p41 + inverse_D5_p17_lanes[1] +
      inverse_D5_p17_lanes[0] - inverse_D5_p51 * inverse_D4_p25;
  const Real inverse_D4_p28 = (-0.18) * inverse_D5_p11_lanes[1] - inverse_D5_p22 + 0.18 *
      inverse_D5_p11_lanes[0] - inverse_D5_p58 * inverse_D4_p25;
  const Real inverse_D5_p69 = 6.1665928899999995 + inverse_D5_p47 + inverse_D5_p34 -
      inverse_D5_p51 * inverse_D5_p63 + 0.226 * inverse_D5_p50;
  const Real inverse_D5_p70 = 1.66923963592404 + inverse_D6_p456 - inverse_D6_p460 -
      inverse_D5_p51 * inverse_D5_p64 + 0.051076 * inverse_D5_p50;
  const Real inverse_D5_p71 = (-0.04068) * inverse_D5_p44_lanes[1] + 0.04068 *
      inverse_D5_p44_lanes[0] - inverse_D5_p58 * inverse_D5_p64 + 0.226 *
      (inverse_D5_p42_lanes[1] + inverse_D5_p42_lanes[0]);
  const Real inverse_D4_p29 = inverse_D5_p51 * inverse_D4_p24 -
      (s21 * inverse_D4_p17 + c21 * inverse_D4_p18) + 0.226 * inverse_D4_p19;
  const Real inverse_D4_p30 = inverse_D4_p19 - c21 * inverse_D4_p20 + s21 * inverse_D4_p21 +
      inverse_D4_p22 * inverse_D5_p63;
  const Real inverse_D4_p31 = s21 * inverse_D5_p55 + inverse_D5_p46 + inverse_D5_p11_lanes[1] +
      inverse_D5_p11_lanes[0] - inverse_D4_p23 * inverse_D5_p63;
  const Real inverse_D4_p32 = inverse_D6_p370_lanes[1] -
      (inverse_D6_p332 + inverse_D6_p387 + inverse_D4_p4 * inverse_D4_p16) +
      inverse_D6_p370_lanes[0] - inverse_D4_p22 * inverse_D4_p24;
  const Real inverse_D4_p33 = inverse_D5_p39 - inverse_D5_p59 + inverse_D6_p426_lanes[1] +
      inverse_D6_p426_lanes[0] - inverse_D4_p23 * inverse_D4_p25;
  const Real inverse_D5_p72 = s6 * inverse_D5_p66 + c6 * inverse_D5_p69;

  // link 5 (chest2), articulated inertia
  const Real inverse_D4_p34 = 2.0 * c5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D4_p35 = inverse_D6_p372_lanes[1] -
      (s21 * inverse_D4_p20 + c21 * inverse_D4_p21) + inverse_D6_p372_lanes[0] + inverse_D4_p22 *
      inverse_D4_p25;
  const Real inverse_D4_p36 = c6 * inverse_D5_p66 - s6 * inverse_D5_p69;
  const Real inverse_D5_p73 = inverse_D5_p72 + 0.072 * inverse_D5_p68;
  const Real inverse_D5_p74 = s6 * (inverse_D5_p67 - inverse_D5_p70) + inverse_D5_p62 *
      inverse_D5_p71;
  const Real inverse_D4_p37 = s6 * (inverse_D4_p26 - inverse_D4_p27) + c6 *
      (inverse_D4_p29 + inverse_D4_p28);
  const Real inverse_D4_p38 = s6 * inverse_D4_p30 + c6 * inverse_D4_p31;
  const Real inverse_D5_p75 = s6 * inverse_D5_p74;
  const Real inverse_D3_p1 = 2.2194301519999997 + inverse_D5_p73;
  const Real inverse_D4_p39 = s6 * inverse_D4_p37;
  const Real inverse_D4_p40 = 0.072 * inverse_D4_p38;
  const Real inverse_D4_p41 = c6 * inverse_D4_p37;
  const Real inverse_D3_p2 = c6 * inverse_D4_p30 - s6 * inverse_D4_p31;
  const Real inverse_D4_p42 = s6 * (inverse_D4_p32 - inverse_D4_p33) + inverse_D5_p62 *
      inverse_D4_p35;
  const Real inverse_D4_p43 = inverse_D4_p41 - inverse_D4_p29;
  const Real inverse_D4_p44 = s6 * inverse_D4_p42;
  const Real inverse_D4_p45 = c6 * inverse_D5_p74 - inverse_D5_p71 + 0.072 * inverse_D4_p36;
  const Real inverse_D4_p46 = inverse_D4_p27 + inverse_D4_p39 + inverse_D4_p40;
  const Real inverse_D4_p47 = inverse_D4_p33 + inverse_D4_p44;
  const Real inverse_D3_p3 = c6 * inverse_D4_p42 - inverse_D4_p35;
  const Real inverse_D4_p48 = 0.072 * inverse_D4_p46;
  const Real inverse_D3_p4 = 0.069699984375 + (inverse_D4_p41 - inverse_D4_p28 + 0.072 *
      inverse_D3_p2);

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p70 + inverse_D5_p75 + 0.072 * (inverse_D5_p72 + inverse_D5_p73)));
  const Real inverse_D4_p49 = inverse_D4_p48 * inverse_D5;
  const Real inverse_D4_p50 = inverse_D4_p45 * inverse_D5;
  const Real inverse_D3_p5 = inverse_D3_p1 * inverse_D5;
  const Real inverse_D3_p6 = inverse_D3_p4 * inverse_D5;
  const Real inverse_D3_p7 = inverse_D4_p46 * inverse_D5;
  const Real inverse_D4_p51 = 0.15637308509675518 + 0.005183999999999999 * inverse_D4_p47 -
      inverse_D4_p48 * inverse_D4_p49;
  const Real inverse_D4_p52 = 0.04675382692737882 + (inverse_D5_p67 - inverse_D5_p75) -
      inverse_D4_p45 * inverse_D4_p50;
  const Real inverse_D4_p53 = 0.005678398088837119 - 0.072 * inverse_D4_p43 + inverse_D4_p48 *
      inverse_D4_p50;
  const Real inverse_D3_p8 = inverse_D4_p48 * inverse_D3_p5 - inverse_D4_p40;
  const Real inverse_D3_p9 = inverse_D4_p26 - inverse_D4_p39 - inverse_D4_p45 * inverse_D3_p6;
  const Real inverse_D3_p10 = inverse_D4_p36 - inverse_D4_p45 * inverse_D3_p5;
  const Real inverse_D3_p11 = inverse_D4_p48 * inverse_D3_p6 - 0.072 * inverse_D3_p3;
  const Real inverse_D3_p12 = inverse_D4_p48 * inverse_D3_p7 -
      (2.2194301519999997 + 0.072 * inverse_D4_p47);
  const Real inverse_D3_p13 = inverse_D4_p43 - 0.069699984375 - inverse_D4_p45 * inverse_D3_p7;
  const Real inverse_D3_p14 = inverse_D4_p32 - inverse_D4_p44 - inverse_D3_p4 * inverse_D3_p6;
  const Real inverse_D3_p15 = inverse_D5_p68 - inverse_D3_p1 * inverse_D3_p5;
  const Real inverse_D3_p16 = inverse_D3_p2 - inverse_D3_p1 * inverse_D3_p6;
  const Real inverse_D3_p17 = inverse_D3_p3 - inverse_D3_p4 * inverse_D3_p7;
  const Real inverse_D3_p18 = inverse_D4_p38 - inverse_D3_p1 * inverse_D3_p7;
  const Real inverse_D3_p19 = inverse_D4_p47 - inverse_D4_p46 * inverse_D3_p7;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p20 = 2.0 * c4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p21 = s5 * inverse_D3_p12 + c5 * inverse_D3_p13;
  const Real inverse_D3_p22 = s5 * inverse_D3_p13 - c5 * inverse_D3_p12;
  const Real inverse_D4_p54 = s5 * (inverse_D4_p51 - inverse_D4_p52) + inverse_D4_p34 *
      inverse_D4_p53;
  const Real inverse_D3_p23 = s5 * (inverse_D3_p8 - inverse_D3_p9) + c5 *
      (inverse_D3_p10 + inverse_D3_p11);
  const Real inverse_D3_p24 = s5 * (inverse_D3_p15 - inverse_D3_p14) + inverse_D4_p34 *
      inverse_D3_p16;
  const Real inverse_D3_p25 = s5 * inverse_D3_p17 - c5 * inverse_D3_p18;
  const Real inverse_D2_p1 = 0.0300000063 + inverse_D3_p21;
  const Real inverse_D4_p55 = s5 * inverse_D4_p54;
  const Real inverse_D3_p26 = inverse_D3_p22 + 0.21799999999999997 * inverse_D3_p19;
  const Real inverse_D3_p27 = c5 * inverse_D3_p23;
  const Real inverse_D3_p28 = s5 * inverse_D3_p23;
  const Real inverse_D3_p29 = s5 * inverse_D3_p24;
  const Real inverse_D3_p30 = 0.21799999999999997 * inverse_D3_p25;
  const Real inverse_D3_p31 = inverse_D3_p27 - inverse_D3_p11;
  const Real inverse_D2_p2 = inverse_D3_p9 + inverse_D3_p28;
  const Real inverse_D3_p32 = inverse_D3_p15 - inverse_D3_p29;
  const Real inverse_D3_p33 = 0.21799999999999997 * inverse_D3_p31;
  const Real inverse_D3_p34 = inverse_D3_p8 - inverse_D3_p28 + inverse_D3_p30;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p52 + inverse_D4_p55));

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p35 = 0.005880002159562879 +
      (0.21799999999999997 * inverse_D3_p21 - (c5 * inverse_D4_p54 - inverse_D4_p53));
  const Real inverse_D2_p3 = s5 * inverse_D3_p18 + c5 * inverse_D3_p17;
  const Real inverse_D2_p4 = c5 * inverse_D3_p24 - inverse_D3_p16;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p36 = inverse_D3_p35 * inverse_D4;
  const Real inverse_D3_p37 = inverse_D3_p33 * inverse_D4;
  const Real inverse_D2_p5 = inverse_D3_p31 * inverse_D4;
  const Real inverse_D2_p6 = inverse_D2_p1 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p2 * inverse_D4;
  const Real inverse_D3_p38 = 0.01227760324629517 + 0.04752399999999999 * inverse_D3_p32 -
      inverse_D3_p33 * inverse_D3_p37;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> neg_s13_lanes = -detail::make_pack<Real>(s13, s20);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p8 = inverse_D3_p35 * inverse_D2_p6 - inverse_D3_p26;
  const Real inverse_D3_p39 = 0.0478915 + (inverse_D4_p51 - inverse_D4_p55 + 0.21799999999999997 *
      (inverse_D3_p22 + inverse_D3_p26)) - inverse_D3_p35 * inverse_D3_p36 - inverse_D3_p38;

  // link 13 (left_hand), force propagation
  const Lanes<2> f13_x_p13_lanes = 0.11533812622014242 * detail::make_pack<Real>(s13, s20) -
      detail::make_pack<Real>(0.04672761636452121, (-0.04672761636452121)) *
      detail::make_pack<Real>(c13, c20);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p9 = inverse_D3_p32 - inverse_D3_p31 * inverse_D2_p5;

  // link 13 (left_hand), force propagation
  const Lanes<2> f13_x_p15_lanes = 0.11533812622014242 * detail::make_pack<Real>(c13, c20) +
      detail::make_pack<Real>(0.04672761636452121, (-0.04672761636452121)) *
      detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p17_lanes = inverse_D10_p27_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p29_lanes = inverse_D10_p27_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p31_lanes = inverse_D10_p26_lanes * f13_x_p13_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p10 = s4 * (0.21799999999999997 * inverse_D2_p3 -
      (inverse_D3_p27 - inverse_D3_p10) - inverse_D3_p35 * inverse_D2_p7) + c4 *
      (0.0300000063 - 0.21799999999999997 * inverse_D2_p4 + inverse_D3_p33 * inverse_D2_p7);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p41_lanes = inverse_D10_p26_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<8> f13_x_p43_lanes = detail::make_pack<Real>(c13, c13, c13, c13, neg_s13_lanes[0],
      f13_x_p15_lanes[0], c13, c13) - inverse_D11_p4_lanes[0] *
      detail::make_pack<Real>(s13, s13, s13, s13, c13, f13_x_p13_lanes[0], s13, s13);
  const Lanes<2> f13_x_p46_lanes = inverse_D10_p25_lanes * detail::make_pack<Real>(c13, c20);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p48_lanes = detail::make_pack<Real>(c20, c20, neg_s13_lanes[1],
      f13_x_p15_lanes[1], c20, c20, c20, c20) - inverse_D11_p4_lanes[1] *
      detail::make_pack<Real>(s20, s20, c20, f13_x_p13_lanes[1], s20, s20, s20, s20);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p53_lanes = inverse_D10_p26_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p55_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(s13, s20) - 17.32841575379867 *
      detail::make_pack<Real>(c13, c20) - inverse_D10_p27_lanes * f13_x_p13_lanes;
  const Lanes<2> f13_x_p57_lanes = inverse_D10_p25_lanes * detail::make_pack<Real>(s13, s20);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p11 = s4 * (inverse_D3_p34 + inverse_D3_p35 * inverse_D2_p5 +
      (inverse_D3_p30 + inverse_D3_p33 * inverse_D2_p6)) + c4 *
      (0.21799999999999997 * inverse_D3_p32 - inverse_D3_p33 * inverse_D2_p5 + inverse_D2_p8);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p80_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(c13, c20) + 17.32841575379867 *
      detail::make_pack<Real>(s13, s20) - inverse_D10_p25_lanes * f13_x_p13_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p40 = inverse_D3_p38 + s4 *
      (s4 * inverse_D3_p39 + inverse_D3_p20 * (0.21799999999999997 * inverse_D3_p34 +
      inverse_D3_p35 * inverse_D3_p37));
  const Real inverse_D2_p12 = 0.02999999505 + inverse_D2_p10;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p90_lanes = -(0.269 * detail::make_pack<Real>(c12, c19));
  const Lanes<2> f13_x_p92_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p90_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p98_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p41_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p46_lanes;
  const Lanes<2> f13_x_p100_lanes = 0.269 * f13_x_p55_lanes - detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p43_lanes[5], f13_x_p48_lanes[3]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p102_lanes = -(c19 * f13_x_p48_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p105_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p53_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p57_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p107_lanes = -f13_x_p17_lanes;
  const Lanes<2> f13_x_p109_lanes = -f13_x_p29_lanes;
  const Lanes<2> f13_x_p111_lanes = detail::make_pack<Real>(s11, s18) *
      detail::make_pack<Real>(c12, c19);
  const Lanes<2> f13_x_p113_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p43_lanes[4], f13_x_p48_lanes[2]) + 0.269 * f13_x_p17_lanes);
  const Lanes<2> f13_x_p115_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p43_lanes[3], f13_x_p48_lanes[1]) + 0.269 * f13_x_p29_lanes);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p13 = s4 * (inverse_D2_p9 -
      (inverse_D3_p19 - inverse_D2_p1 * inverse_D2_p6)) - inverse_D3_p20 *
      (inverse_D3_p25 + inverse_D3_p31 * inverse_D2_p6);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p120_lanes = -(detail::make_pack<Real>(s11, s18) * f13_x_p90_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p128_lanes = detail::make_pack<Real>(c11, c18) *
      detail::make_pack<Real>(c12, c19);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p130_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p31_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p80_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p40);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p14 = 8.419374554 + (c4 * inverse_D2_p11 - inverse_D2_p8);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p142_lanes = detail::make_pack<Real>(f13_x_p115_lanes[1],
      f13_x_p115_lanes[1], f13_x_p113_lanes[1], f13_x_p100_lanes[1], f13_x_p115_lanes[1],
      f13_x_p115_lanes[1], f13_x_p115_lanes[1], f13_x_p115_lanes[1]) - inverse_D10_p83_lanes[1] *
      f13_x_p102_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p152_lanes = -(c12 * f13_x_p43_lanes);
  const Lanes<2> neg_s12_lanes = -detail::make_pack<Real>(s12, s19);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p173_lanes = -detail::make_pack<Real>(f13_x_p105_lanes[1],
      f13_x_p105_lanes[1], f13_x_p98_lanes[1], f13_x_p130_lanes[1], f13_x_p105_lanes[1],
      f13_x_p105_lanes[1], f13_x_p105_lanes[1], f13_x_p105_lanes[1]) + inverse_D8_p4_lanes[1] *
      f13_x_p102_lanes;
  const Lanes<8> f13_x_p176_lanes = detail::make_pack<Real>(f13_x_p109_lanes[1],
      f13_x_p109_lanes[1], f13_x_p107_lanes[1], f13_x_p55_lanes[1], f13_x_p109_lanes[1],
      f13_x_p109_lanes[1], f13_x_p109_lanes[1], f13_x_p109_lanes[1]) - inverse_D8_p5_lanes[1] *
      f13_x_p102_lanes;
  const Lanes<8> f13_x_p184_lanes = 0.269 * detail::make_pack<Real>(f13_x_p105_lanes[1],
      f13_x_p105_lanes[1], f13_x_p98_lanes[1], f13_x_p130_lanes[1], f13_x_p105_lanes[1],
      f13_x_p105_lanes[1], f13_x_p105_lanes[1], f13_x_p105_lanes[1]) - inverse_D10_p84_lanes[1] *
      f13_x_p102_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p189_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p31_lanes -
      detail::make_pack<Real>(c12, c19) * f13_x_p80_lanes - inverse_D8_p40_lanes *
      detail::make_pack<Real>(f13_x_p152_lanes[5], f13_x_p102_lanes[3]);
  const Lanes<2> f13_x_p203_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p41_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p46_lanes - inverse_D8_p40_lanes *
      detail::make_pack<Real>(f13_x_p152_lanes[4], f13_x_p102_lanes[2]);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p205_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p213_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p53_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p57_lanes - inverse_D8_p40_lanes *
      detail::make_pack<Real>(f13_x_p152_lanes[3], f13_x_p102_lanes[1]);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p12 * inverse_D3;
  const Real inverse_D2_p16 = inverse_D2_p14 * inverse_D3;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p215_lanes = c18 * f13_x_p173_lanes - s18 * f13_x_p176_lanes;
  const Lanes<8> f13_x_p218_lanes = s18 * f13_x_p173_lanes + c18 * f13_x_p176_lanes;
  const Lanes<8> f13_x_p221_lanes = s18 * f13_x_p142_lanes + c18 * f13_x_p184_lanes;
  const Lanes<8> f13_x_p224_lanes = c18 * f13_x_p142_lanes - s18 * f13_x_p184_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p242_lanes = inverse_D9_p7_lanes[1] *
      detail::make_pack<Real>(f13_x_p92_lanes[1], f13_x_p221_lanes[1], f13_x_p221_lanes[2],
      f13_x_p221_lanes[3], f13_x_p92_lanes[1], f13_x_p92_lanes[1], f13_x_p92_lanes[1],
      f13_x_p92_lanes[1]);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = inverse_D2_p14 * inverse_D2_p15 -
      (c4 * (inverse_D3_p31 * inverse_D2_p7 - inverse_D2_p4) - s4 *
      (inverse_D2_p1 * inverse_D2_p7 - inverse_D2_p3));
  const Real inverse_D2_p18 = inverse_D2_p9 - s4 * inverse_D2_p13 - inverse_D2_p14 * inverse_D2_p16;
  const Real inverse_D2_p19 = inverse_D3_p14 + inverse_D3_p29 - inverse_D2_p2 * inverse_D2_p7 -
      inverse_D2_p12 * inverse_D2_p15;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p250_lanes = detail::make_pack<Real>(f13_x_p120_lanes[1],
      f13_x_p224_lanes[1], f13_x_p224_lanes[2], f13_x_p224_lanes[3], f13_x_p120_lanes[1],
      f13_x_p120_lanes[1], f13_x_p120_lanes[1], f13_x_p120_lanes[1]) - inverse_D9_p9_lanes[1] *
      detail::make_pack<Real>(f13_x_p92_lanes[1], f13_x_p221_lanes[1], f13_x_p221_lanes[2],
      f13_x_p221_lanes[3], f13_x_p92_lanes[1], f13_x_p92_lanes[1], f13_x_p92_lanes[1],
      f13_x_p92_lanes[1]);
  const Lanes<8> f13_x_p254_lanes = detail::make_pack<Real>(f13_x_p128_lanes[1],
      f13_x_p215_lanes[1], f13_x_p215_lanes[2], f13_x_p215_lanes[3], f13_x_p128_lanes[1],
      f13_x_p128_lanes[1], f13_x_p128_lanes[1], f13_x_p128_lanes[1]) - inverse_D8_p60_lanes[1] *
      detail::make_pack<Real>(f13_x_p92_lanes[1], f13_x_p221_lanes[1], f13_x_p221_lanes[2],
      f13_x_p221_lanes[3], f13_x_p92_lanes[1], f13_x_p92_lanes[1], f13_x_p92_lanes[1],
      f13_x_p92_lanes[1]);
  const Lanes<8> f13_x_p258_lanes = -detail::make_pack<Real>(neg_s12_lanes[1], f13_x_p213_lanes[1],
      f13_x_p203_lanes[1], f13_x_p189_lanes[1], neg_s12_lanes[1], neg_s12_lanes[1],
      neg_s12_lanes[1], neg_s12_lanes[1]) - inverse_D8_p81_lanes[1] *
      detail::make_pack<Real>(f13_x_p92_lanes[1], f13_x_p221_lanes[1], f13_x_p221_lanes[2],
      f13_x_p221_lanes[3], f13_x_p92_lanes[1], f13_x_p92_lanes[1], f13_x_p92_lanes[1],
      f13_x_p92_lanes[1]);
  const Lanes<8> f13_x_p270_lanes = detail::make_pack<Real>(f13_x_p111_lanes[1],
      f13_x_p218_lanes[1], f13_x_p218_lanes[2], f13_x_p218_lanes[3], f13_x_p111_lanes[1],
      f13_x_p111_lanes[1], f13_x_p111_lanes[1], f13_x_p111_lanes[1]) - inverse_D8_p63_lanes[1] *
      detail::make_pack<Real>(f13_x_p92_lanes[1], f13_x_p221_lanes[1], f13_x_p221_lanes[2],
      f13_x_p221_lanes[3], f13_x_p92_lanes[1], f13_x_p92_lanes[1], f13_x_p92_lanes[1],
      f13_x_p92_lanes[1]);
  const Lanes<8> f13_x_p302_lanes = c17 * f13_x_p242_lanes - s17 * f13_x_p250_lanes;
  const Lanes<8> f13_x_p310_lanes = s17 * f13_x_p258_lanes - c17 * f13_x_p254_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p318_lanes = inverse_D8_p148_lanes[1] * f13_x_p302_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = s3 * (inverse_D2_p18 - inverse_D2_p19) + c3 * (2.0 * inverse_D2_p17);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p346_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = s3 * inverse_D2_p20;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p356_lanes = c17 * f13_x_p250_lanes + s17 * f13_x_p242_lanes + 0.282 *
      f13_x_p270_lanes - f13_x_p318_lanes;
  const Lanes<8> f13_x_p360_lanes = -f13_x_p310_lanes + inverse_D6_p31_lanes[1] * f13_x_p302_lanes;
  const Lanes<8> f13_x_p364_lanes = 0.282 * f13_x_p310_lanes - inverse_D8_p149_lanes[1] *
      f13_x_p302_lanes;
  const Lanes<8> f13_x_p368_lanes = f13_x_p270_lanes - inverse_D6_p33_lanes[1] * f13_x_p302_lanes;
  const Lanes<8> f13_x_p372_lanes = -(s17 * f13_x_p254_lanes + c17 * f13_x_p258_lanes) +
      inverse_D6_p35_lanes[1] * f13_x_p302_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p22 = inverse_D2_p18 - inverse_D2_p21;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p412_lanes = c16 * f13_x_p356_lanes - s16 * f13_x_p364_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = 24.5839218 + 0.422 * inverse_D2_p22;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p432_lanes = f13_x_p205_lanes[1] * f13_x_p412_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * inverse_D2_p22);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p448_lanes = s16 * f13_x_p356_lanes + c16 * f13_x_p364_lanes -
      inverse_D7_p8_lanes[1] * f13_x_p412_lanes;
  const Lanes<8> f13_x_p460_lanes = s16 * f13_x_p360_lanes + c16 * f13_x_p368_lanes -
      inverse_D6_p115_lanes[1] * f13_x_p412_lanes;
  const Lanes<8> f13_x_p464_lanes = -f13_x_p372_lanes + inverse_D6_p113_lanes[1] * f13_x_p412_lanes;
  const Lanes<8> f13_x_p496_lanes = s15 * f13_x_p432_lanes + c15 * f13_x_p448_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p512_lanes = inverse_D6_p283_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p528_lanes = f13_x_p346_lanes[1] * f13_x_p496_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p532_lanes = c16 * f13_x_p360_lanes - s16 * f13_x_p368_lanes -
      inverse_D6_p119_lanes[1] * f13_x_p412_lanes - f13_x_p512_lanes;
  const Lanes<8> f13_x_p536_lanes = c15 * f13_x_p464_lanes - s15 * f13_x_p460_lanes -
      inverse_D6_p281_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p540_lanes = s15 * f13_x_p464_lanes + c15 * f13_x_p460_lanes -
      inverse_D6_p285_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p544_lanes = c15 * f13_x_p432_lanes - s15 * f13_x_p448_lanes -
      inverse_D6_p346_lanes[1] * f13_x_p496_lanes;
  const Lanes<8> f13_x_p584_lanes = s14 * f13_x_p532_lanes + c14 * f13_x_p536_lanes;
  const Lanes<8> f13_x_p592_lanes = c14 * f13_x_p532_lanes - s14 * f13_x_p536_lanes;
  const Lanes<8> f13_x_p612_lanes = 0.226 * f13_x_p540_lanes + (-0.18) * f13_x_p584_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p624_lanes = -(c14 * f13_x_p528_lanes + s14 * f13_x_p544_lanes +
      f13_x_p612_lanes);
  const Lanes<8> f13_x_p628_lanes = inverse_D5_p65 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p648_lanes = (-0.18) * f13_x_p592_lanes -
      (s14 * f13_x_p528_lanes - c14 * f13_x_p544_lanes) - f13_x_p628_lanes;
  const Lanes<8> f13_x_p652_lanes = 0.226 * f13_x_p592_lanes - inverse_D5_p64 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p656_lanes = f13_x_p592_lanes - inverse_D5_p63 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p660_lanes = f13_x_p584_lanes + inverse_D4_p24 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p664_lanes = f13_x_p540_lanes - inverse_D4_p25 * f13_x_p624_lanes;
  const Lanes<8> f13_x_p708_lanes = s6 * f13_x_p660_lanes + c6 * f13_x_p664_lanes;
  const Lanes<8> f13_x_p720_lanes = s6 * f13_x_p648_lanes + c6 * f13_x_p652_lanes + 0.072 *
      f13_x_p656_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p3 = c3 * inverse_D2_p20 - inverse_D2_p17;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p752_lanes = -(0.072 * f13_x_p708_lanes) + inverse_D4_p49 * f13_x_p720_lanes;
  const Lanes<8> f13_x_p756_lanes = c6 * f13_x_p648_lanes - s6 * f13_x_p652_lanes - inverse_D4_p50 *
      f13_x_p720_lanes;
  const Lanes<8> f13_x_p760_lanes = c6 * f13_x_p660_lanes - s6 * f13_x_p664_lanes - inverse_D3_p6 *
      f13_x_p720_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p4 = 0.031999971599999996 + 0.422 * inverse_D1_p3;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p5 = inverse_D2_p22 - inverse_D1_p1 * inverse_D1_p2;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p764_lanes = f13_x_p656_lanes - inverse_D3_p5 * f13_x_p720_lanes;
  const Lanes<8> f13_x_p768_lanes = f13_x_p708_lanes - inverse_D3_p7 * f13_x_p720_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p6 = inverse_D1_p4 * inverse_D2;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p800_lanes = 0.269 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p806_lanes = detail::make_pack<Real>(s12, s19) * neg_s13_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p816_lanes = s5 * f13_x_p760_lanes - c5 * f13_x_p764_lanes;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p824 = 0.269 * f13_x_p806_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p829_lanes = -(s5 * f13_x_p752_lanes + c5 * f13_x_p756_lanes);

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p857 = -f13_x_p806_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p870_lanes = -(s5 * f13_x_p756_lanes - c5 * f13_x_p752_lanes +
      0.21799999999999997 * f13_x_p768_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p882_lanes = detail::make_pack<Real>(c12, c19) * neg_s13_lanes;
  const Lanes<2> f13_x_p884_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(c13, c20);

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p898_lanes = -(s5 * f13_x_p764_lanes + c5 * f13_x_p760_lanes) -
      inverse_D2_p7 * f13_x_p829_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p902 = s18 * f13_x_p800_lanes[1] + c18 * f13_x_p824;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p913_lanes = -(-detail::make_pack<Real>(f13_x_p884_lanes[1],
      f13_x_p884_lanes[1], f13_x_p884_lanes[1], f13_x_p884_lanes[1], f13_x_p884_lanes[1],
      f13_x_p884_lanes[1], f13_x_p884_lanes[1], f13_x_p882_lanes[1]));

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p915_lanes = c4 * (-(0.21799999999999997 * f13_x_p816_lanes) +
      inverse_D3_p37 * f13_x_p829_lanes);
  const Lanes<8> f13_x_p919_lanes = s4 * (f13_x_p768_lanes + inverse_D2_p6 * f13_x_p829_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p923_lanes = 0.269 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p925_lanes = detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(c13, c20);

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p927 = inverse_D9_p7_lanes[1] * f13_x_p902;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p7 = s2 * (inverse_D1_p5 - (inverse_D2_p19 + inverse_D2_p21 -
      inverse_D1_p4 * inverse_D1_p6)) + c2 * (2.0 * (inverse_D1_p3 - inverse_D1_p1 *
      inverse_D1_p6));

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p932_lanes = s4 * (f13_x_p870_lanes - inverse_D3_p36 * f13_x_p829_lanes) +
      f13_x_p915_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p940 = c18 * f13_x_p800_lanes[1] - s18 * f13_x_p824 - inverse_D9_p9_lanes[1] *
      f13_x_p902;
  const Real f13_x_p941 = c18 * f13_x_p857 - s18 * c20 - inverse_D8_p60_lanes[1] * f13_x_p902;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p942 = 0.269 * f13_x_p925_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p943 = f13_x_p913_lanes[7] - inverse_D8_p81_lanes[1] * f13_x_p902;
  const Real f13_x_p944 = s18 * f13_x_p857 + c18 * c20 - inverse_D8_p63_lanes[1] * f13_x_p902;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p945_lanes = inverse_D2_p16 * f13_x_p932_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p949 = -f13_x_p925_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p954_lanes = c4 * (-f13_x_p816_lanes + inverse_D2_p5 * f13_x_p829_lanes) -
      f13_x_p919_lanes - f13_x_p945_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p958 = c17 * f13_x_p927 - s17 * f13_x_p940;
  const Real f13_x_p959 = s17 * f13_x_p943 - c17 * f13_x_p941;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p960_lanes = -f13_x_p898_lanes + inverse_D2_p15 * f13_x_p932_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p964 = s18 * f13_x_p923_lanes[1] + c18 * f13_x_p942;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p981 = inverse_D9_p7_lanes[1] * f13_x_p964;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p982_lanes = 0.269 * detail::make_pack<Real>(f13_x_p925_lanes[0],
      f13_x_p806_lanes[0], f13_x_p925_lanes[0], f13_x_p105_lanes[0], f13_x_p98_lanes[0],
      f13_x_p130_lanes[0], f13_x_p925_lanes[0], f13_x_p925_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p987 = c17 * f13_x_p940 + s17 * f13_x_p927 + 0.282 * f13_x_p944 -
      inverse_D8_p148_lanes[1] * f13_x_p958;
  const Real f13_x_p988 = 0.282 * f13_x_p959 - inverse_D8_p149_lanes[1] * f13_x_p958;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p989_lanes = c3 * f13_x_p954_lanes - s3 * f13_x_p960_lanes;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p993 = f13_x_p100_lanes[0] - inverse_D10_p83_lanes[0] * f13_x_p152_lanes[5];
  const Real f13_x_p994 = f13_x_p113_lanes[0] - inverse_D10_p83_lanes[0] * f13_x_p152_lanes[4];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p995 = c18 * f13_x_p923_lanes[1] - s18 * f13_x_p942 - inverse_D9_p9_lanes[1] *
      f13_x_p964;
  const Real f13_x_p996 = c18 * f13_x_p949 - s18 * s20 - inverse_D8_p60_lanes[1] * f13_x_p964;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p997 = f13_x_p115_lanes[0] - inverse_D10_p83_lanes[0] * f13_x_p152_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p998 = f13_x_p913_lanes[6] - inverse_D8_p81_lanes[1] * f13_x_p964;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p999 = f13_x_p982_lanes[5] - inverse_D10_p84_lanes[0] * f13_x_p152_lanes[5];
  const Real f13_x_p1000 = f13_x_p982_lanes[4] - inverse_D10_p84_lanes[0] * f13_x_p152_lanes[4];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1001 = s18 * f13_x_p949 + c18 * s20 - inverse_D8_p63_lanes[1] * f13_x_p964;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1002 = f13_x_p982_lanes[3] - inverse_D10_p84_lanes[0] * f13_x_p152_lanes[3];
  const Lanes<8> f13_x_p1008_lanes = -detail::make_pack<Real>(f13_x_p925_lanes[0],
      f13_x_p806_lanes[0], f13_x_p925_lanes[0], f13_x_p105_lanes[0], f13_x_p98_lanes[0],
      f13_x_p130_lanes[0], f13_x_p925_lanes[0], f13_x_p925_lanes[0]);
  const Real f13_x_p1028 = f13_x_p1008_lanes[5] + inverse_D8_p4_lanes[0] * f13_x_p152_lanes[5];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1029 = c17 * f13_x_p981 - s17 * f13_x_p995;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1030 = f13_x_p1008_lanes[4] + inverse_D8_p4_lanes[0] * f13_x_p152_lanes[4];
  const Real f13_x_p1031 = f13_x_p1008_lanes[3] + inverse_D8_p4_lanes[0] * f13_x_p152_lanes[3];

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p5 - s2 * inverse_D1_p7));

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1032 = f13_x_p55_lanes[0] - inverse_D8_p5_lanes[0] * f13_x_p152_lanes[5];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1033 = s17 * f13_x_p998 - c17 * f13_x_p996;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1034_lanes = 0.422 * f13_x_p989_lanes;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1038 = f13_x_p107_lanes[0] - inverse_D8_p5_lanes[0] * f13_x_p152_lanes[4];
  const Real f13_x_p1039 = f13_x_p109_lanes[0] - inverse_D8_p5_lanes[0] * f13_x_p152_lanes[3];
  const Lanes<8> f13_x_p1040_lanes = s11 * detail::make_pack<Real>(f13_x_p923_lanes[0],
      f13_x_p800_lanes[0], f13_x_p923_lanes[0], f13_x_p997, f13_x_p994, f13_x_p993,
      f13_x_p923_lanes[0], f13_x_p923_lanes[0]) + c11 *
      detail::make_pack<Real>(f13_x_p982_lanes[0], f13_x_p982_lanes[1], f13_x_p982_lanes[0],
      f13_x_p1002, f13_x_p1000, f13_x_p999, f13_x_p982_lanes[0], f13_x_p982_lanes[0]);
  const Lanes<8> f13_x_p1045_lanes = c11 * detail::make_pack<Real>(f13_x_p923_lanes[0],
      f13_x_p800_lanes[0], f13_x_p923_lanes[0], f13_x_p997, f13_x_p994, f13_x_p993,
      f13_x_p923_lanes[0], f13_x_p923_lanes[0]) - s11 *
      detail::make_pack<Real>(f13_x_p982_lanes[0], f13_x_p982_lanes[1], f13_x_p982_lanes[0],
      f13_x_p1002, f13_x_p1000, f13_x_p999, f13_x_p982_lanes[0], f13_x_p982_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1065 = c16 * f13_x_p987 - s16 * f13_x_p988;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1094_lanes = inverse_D9_p7_lanes[0] *
      detail::make_pack<Real>(f13_x_p1040_lanes[0], f13_x_p1040_lanes[1], f13_x_p92_lanes[0],
      f13_x_p1040_lanes[3], f13_x_p1040_lanes[4], f13_x_p1040_lanes[5], f13_x_p1040_lanes[0],
      f13_x_p1040_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1110 = c17 * f13_x_p995 + s17 * f13_x_p981 + 0.282 * f13_x_p1001 -
      inverse_D8_p148_lanes[1] * f13_x_p1029;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1111 = f13_x_p205_lanes[1] * f13_x_p1065;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1112 = 0.282 * f13_x_p1033 - inverse_D8_p149_lanes[1] * f13_x_p1029;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1117_lanes = c11 * detail::make_pack<Real>(f13_x_p1008_lanes[0],
      f13_x_p1008_lanes[1], f13_x_p1008_lanes[0], f13_x_p1031, f13_x_p1030, f13_x_p1028,
      f13_x_p1008_lanes[0], f13_x_p1008_lanes[0]) - s11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p1039, f13_x_p1038, f13_x_p1032, s13, s13);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1122_lanes = detail::make_pack<Real>(f13_x_p1045_lanes[0],
      f13_x_p1045_lanes[1], f13_x_p120_lanes[0], f13_x_p1045_lanes[3], f13_x_p1045_lanes[4],
      f13_x_p1045_lanes[5], f13_x_p1045_lanes[0], f13_x_p1045_lanes[0]) - inverse_D9_p9_lanes[0] *
      detail::make_pack<Real>(f13_x_p1040_lanes[0], f13_x_p1040_lanes[1], f13_x_p92_lanes[0],
      f13_x_p1040_lanes[3], f13_x_p1040_lanes[4], f13_x_p1040_lanes[5], f13_x_p1040_lanes[0],
      f13_x_p1040_lanes[0]);
  const Lanes<8> f13_x_p1128_lanes = -detail::make_pack<Real>(-f13_x_p884_lanes[0],
      -f13_x_p882_lanes[0], neg_s12_lanes[0], f13_x_p213_lanes[0], f13_x_p203_lanes[0],
      f13_x_p189_lanes[0], -f13_x_p884_lanes[0], -f13_x_p884_lanes[0]) - inverse_D8_p81_lanes[0] *
      detail::make_pack<Real>(f13_x_p1040_lanes[0], f13_x_p1040_lanes[1], f13_x_p92_lanes[0],
      f13_x_p1040_lanes[3], f13_x_p1040_lanes[4], f13_x_p1040_lanes[5], f13_x_p1040_lanes[0],
      f13_x_p1040_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1134_lanes = s11 * detail::make_pack<Real>(f13_x_p1008_lanes[0],
      f13_x_p1008_lanes[1], f13_x_p1008_lanes[0], f13_x_p1031, f13_x_p1030, f13_x_p1028,
      f13_x_p1008_lanes[0], f13_x_p1008_lanes[0]) + c11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p1039, f13_x_p1038, f13_x_p1032, s13, s13);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1151_lanes = detail::make_pack<Real>(f13_x_p1117_lanes[0],
      f13_x_p1117_lanes[1], f13_x_p128_lanes[0], f13_x_p1117_lanes[3], f13_x_p1117_lanes[4],
      f13_x_p1117_lanes[5], f13_x_p1117_lanes[0], f13_x_p1117_lanes[0]) - inverse_D8_p60_lanes[0] *
      detail::make_pack<Real>(f13_x_p1040_lanes[0], f13_x_p1040_lanes[1], f13_x_p92_lanes[0],
      f13_x_p1040_lanes[3], f13_x_p1040_lanes[4], f13_x_p1040_lanes[5], f13_x_p1040_lanes[0],
      f13_x_p1040_lanes[0]);
  const Lanes<8> f13_x_p1175_lanes = detail::make_pack<Real>(f13_x_p1134_lanes[0],
      f13_x_p1134_lanes[1], f13_x_p111_lanes[0], f13_x_p1134_lanes[3], f13_x_p1134_lanes[4],
      f13_x_p1134_lanes[5], f13_x_p1134_lanes[0], f13_x_p1134_lanes[0]) - inverse_D8_p63_lanes[0] *
      detail::make_pack<Real>(f13_x_p1040_lanes[0], f13_x_p1040_lanes[1], f13_x_p92_lanes[0],
      f13_x_p1040_lanes[3], f13_x_p1040_lanes[4], f13_x_p1040_lanes[5], f13_x_p1040_lanes[0],
      f13_x_p1040_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1181 = -f13_x_p959 + inverse_D6_p31_lanes[1] * f13_x_p958;
  const Real f13_x_p1182 = f13_x_p944 - inverse_D6_p33_lanes[1] * f13_x_p958;
  const Real f13_x_p1183 = -f13_x_p1033 + inverse_D6_p31_lanes[1] * f13_x_p1029;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1184 = s16 * f13_x_p987 + c16 * f13_x_p988 - inverse_D7_p8_lanes[1] *
      f13_x_p1065;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1195 = c16 * f13_x_p1110 - s16 * f13_x_p1112;
  const Real f13_x_p1196 = f13_x_p1001 - inverse_D6_p33_lanes[1] * f13_x_p1029;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1197_lanes = c10 * f13_x_p1094_lanes - s10 * f13_x_p1122_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1215 = f13_x_p205_lanes[1] * f13_x_p1195;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1216_lanes = s10 * f13_x_p1128_lanes - c10 * f13_x_p1151_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1222_lanes = inverse_D8_p148_lanes[0] * f13_x_p1197_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1264 = s16 * f13_x_p1110 + c16 * f13_x_p1112 - inverse_D7_p8_lanes[1] *
      f13_x_p1195;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1265_lanes = c10 * f13_x_p1122_lanes + s10 * f13_x_p1094_lanes + 0.282 *
      f13_x_p1175_lanes - f13_x_p1222_lanes;
  const Lanes<8> f13_x_p1271_lanes = -f13_x_p1216_lanes + inverse_D6_p31_lanes[0] *
      f13_x_p1197_lanes;
  const Lanes<8> f13_x_p1277_lanes = f13_x_p1175_lanes - inverse_D6_p33_lanes[0] *
      f13_x_p1197_lanes;
  const Lanes<8> f13_x_p1301_lanes = 0.282 * f13_x_p1216_lanes - inverse_D8_p149_lanes[0] *
      f13_x_p1197_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1361 = s16 * f13_x_p1181 + c16 * f13_x_p1182 - inverse_D6_p115_lanes[1] *
      f13_x_p1065;
  const Real f13_x_p1362 = -(-(s17 * f13_x_p941 + c17 * f13_x_p943) + inverse_D6_p35_lanes[1] *
      f13_x_p958) + inverse_D6_p113_lanes[1] * f13_x_p1065;
  const Real f13_x_p1363 = s16 * f13_x_p1183 + c16 * f13_x_p1196 - inverse_D6_p115_lanes[1] *
      f13_x_p1195;
  const Real f13_x_p1364 = s15 * f13_x_p1111 + c15 * f13_x_p1184;
  const Real f13_x_p1365 = s15 * f13_x_p1215 + c15 * f13_x_p1264;
  const Real f13_x_p1372 = -(-(s17 * f13_x_p996 + c17 * f13_x_p998) + inverse_D6_p35_lanes[1] *
      f13_x_p1029) + inverse_D6_p113_lanes[1] * f13_x_p1195;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1379_lanes = -(s10 * f13_x_p1151_lanes + c10 * f13_x_p1128_lanes) +
      inverse_D6_p35_lanes[0] * f13_x_p1197_lanes;
  const Lanes<8> f13_x_p1391_lanes = c9 * f13_x_p1265_lanes - s9 * f13_x_p1301_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1415_lanes = f13_x_p205_lanes[0] * f13_x_p1391_lanes;
  const Lanes<8> f13_x_p1447_lanes = s9 * f13_x_p1265_lanes + c9 * f13_x_p1301_lanes -
      inverse_D7_p8_lanes[0] * f13_x_p1391_lanes;
  const Lanes<8> f13_x_p1459_lanes = s9 * f13_x_p1271_lanes + c9 * f13_x_p1277_lanes -
      inverse_D6_p115_lanes[0] * f13_x_p1391_lanes;
  const Lanes<8> f13_x_p1465_lanes = -f13_x_p1379_lanes + inverse_D6_p113_lanes[0] *
      f13_x_p1391_lanes;
  const Lanes<8> f13_x_p1471_lanes = c9 * f13_x_p1271_lanes - s9 * f13_x_p1277_lanes -
      inverse_D6_p119_lanes[0] * f13_x_p1391_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p1487_lanes = s2 * (s3 * f13_x_p954_lanes + c3 * f13_x_p960_lanes -
      inverse_D1_p6 * f13_x_p1034_lanes);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1531_lanes = s8 * f13_x_p1415_lanes + c8 * f13_x_p1447_lanes;
  const Lanes<8> f13_x_p1537_lanes = c8 * f13_x_p1465_lanes - s8 * f13_x_p1459_lanes;
  const Lanes<8> f13_x_p1543_lanes = s8 * f13_x_p1465_lanes + c8 * f13_x_p1459_lanes;
  const Lanes<8> f13_x_p1549_lanes = c8 * f13_x_p1415_lanes - s8 * f13_x_p1447_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p1555_lanes = 0.434 * (c2 * (f13_x_p989_lanes - inverse_D1_p2 *
      f13_x_p1034_lanes) - f13_x_p1487_lanes);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1591_lanes = detail::make_pack<Real>(f13_x_p346_lanes[0],
      f13_x_p346_lanes[0], f13_x_p346_lanes[0], f13_x_p346_lanes[0], f13_x_p346_lanes[0],
      f13_x_p346_lanes[0], f13_x_p346_lanes[1], f13_x_p346_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1531_lanes[0], f13_x_p1531_lanes[1], f13_x_p1531_lanes[2],
      f13_x_p1531_lanes[3], f13_x_p1531_lanes[4], f13_x_p1531_lanes[5], f13_x_p1365, f13_x_p1364);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p1599_lanes = f13_x_p1555_lanes * inverse_D1;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1603_lanes = detail::make_pack<Real>(f13_x_p1471_lanes[0],
      f13_x_p1471_lanes[1], f13_x_p1471_lanes[2], f13_x_p1471_lanes[3], f13_x_p1471_lanes[4],
      f13_x_p1471_lanes[5], c16 * f13_x_p1183 - s16 * f13_x_p1196 - inverse_D6_p119_lanes[1] *
      f13_x_p1195, c16 * f13_x_p1181 - s16 * f13_x_p1182 - inverse_D6_p119_lanes[1] * f13_x_p1065) -
      detail::make_pack<Real>(inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[0],
      inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[0],
      inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[1], inverse_D6_p283_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1531_lanes[0], f13_x_p1531_lanes[1], f13_x_p1531_lanes[2],
      f13_x_p1531_lanes[3], f13_x_p1531_lanes[4], f13_x_p1531_lanes[5], f13_x_p1365, f13_x_p1364);
  const Lanes<8> f13_x_p1611_lanes = detail::make_pack<Real>(f13_x_p1537_lanes[0],
      f13_x_p1537_lanes[1], f13_x_p1537_lanes[2], f13_x_p1537_lanes[3], f13_x_p1537_lanes[4],
      f13_x_p1537_lanes[5], c15 * f13_x_p1372 - s15 * f13_x_p1363, c15 * f13_x_p1362 - s15 *
      f13_x_p1361) - detail::make_pack<Real>(inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[0],
      inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[0],
      inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[1], inverse_D6_p281_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1531_lanes[0], f13_x_p1531_lanes[1], f13_x_p1531_lanes[2],
      f13_x_p1531_lanes[3], f13_x_p1531_lanes[4], f13_x_p1531_lanes[5], f13_x_p1365, f13_x_p1364);
  const Lanes<8> f13_x_p1619_lanes = detail::make_pack<Real>(f13_x_p1543_lanes[0],
      f13_x_p1543_lanes[1], f13_x_p1543_lanes[2], f13_x_p1543_lanes[3], f13_x_p1543_lanes[4],
      f13_x_p1543_lanes[5], s15 * f13_x_p1372 + c15 * f13_x_p1363, s15 * f13_x_p1362 + c15 *
      f13_x_p1361) - detail::make_pack<Real>(inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[0],
      inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[0],
      inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[1], inverse_D6_p285_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1531_lanes[0], f13_x_p1531_lanes[1], f13_x_p1531_lanes[2],
      f13_x_p1531_lanes[3], f13_x_p1531_lanes[4], f13_x_p1531_lanes[5], f13_x_p1365, f13_x_p1364);
  const Lanes<8> f13_x_p1627_lanes = detail::make_pack<Real>(f13_x_p1549_lanes[0],
      f13_x_p1549_lanes[1], f13_x_p1549_lanes[2], f13_x_p1549_lanes[3], f13_x_p1549_lanes[4],
      f13_x_p1549_lanes[5], c15 * f13_x_p1215 - s15 * f13_x_p1264, c15 * f13_x_p1111 - s15 *
      f13_x_p1184) - detail::make_pack<Real>(inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[0],
      inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[0],
      inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[1], inverse_D6_p346_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1531_lanes[0], f13_x_p1531_lanes[1], f13_x_p1531_lanes[2],
      f13_x_p1531_lanes[3], f13_x_p1531_lanes[4], f13_x_p1531_lanes[5], f13_x_p1365, f13_x_p1364);
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
      f13_x_p1591_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1627_lanes + f13_x_p1763_lanes);
  const Lanes<8> f13_x_p1795_lanes = inverse_D5_p65 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1835_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18,
      (-0.18), (-0.18)) * f13_x_p1723_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * f13_x_p1591_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1627_lanes) - f13_x_p1795_lanes;
  const Lanes<8> f13_x_p1843_lanes = 0.226 * f13_x_p1723_lanes - inverse_D5_p64 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1851_lanes = f13_x_p1723_lanes - inverse_D5_p63 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1859_lanes = f13_x_p1707_lanes + inverse_D4_p24 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1867_lanes = f13_x_p1619_lanes - inverse_D4_p25 * f13_x_p1787_lanes;
  const Lanes<8> f13_x_p1955_lanes = s6 * f13_x_p1859_lanes + c6 * f13_x_p1867_lanes;
  const Lanes<8> f13_x_p1979_lanes = s6 * f13_x_p1835_lanes + c6 * f13_x_p1843_lanes + 0.072 *
      f13_x_p1851_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2035_lanes = f13_x_p1034_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2039_lanes = f13_x_p932_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2051_lanes = f13_x_p829_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2055_lanes = -(0.072 * f13_x_p1955_lanes) + inverse_D4_p49 *
      f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2063_lanes = c6 * f13_x_p1835_lanes - s6 * f13_x_p1843_lanes -
      inverse_D4_p50 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2071_lanes = c6 * f13_x_p1859_lanes - s6 * f13_x_p1867_lanes -
      inverse_D3_p6 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2079_lanes = f13_x_p1851_lanes - inverse_D3_p5 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2087_lanes = f13_x_p1955_lanes - inverse_D3_p7 * f13_x_p1979_lanes;
  const Lanes<8> f13_x_p2095_lanes = f13_x_p720_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2099_lanes = f13_x_p624_lanes * inverse_D6;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2183_lanes = f13_x_p1979_lanes * inverse_D5;
  const Lanes<8> f13_x_p2199_lanes = s5 * f13_x_p2071_lanes - c5 * f13_x_p2079_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2207 = f13_x_p1787_lanes[7] * inverse_D6;
  const Real f13_x_p2208 = f13_x_p1787_lanes[6] * inverse_D6;
  const Lanes<8> f13_x_p2217_lanes = f13_x_p1787_lanes * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2231_lanes = f13_x_p1531_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2245_lanes = f13_x_p1391_lanes * inverse_D8_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2251_lanes = -(s5 * f13_x_p2055_lanes + c5 * f13_x_p2063_lanes);

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2323_lanes = f13_x_p1197_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p2337_lanes = detail::make_pack<Real>(f13_x_p1040_lanes[0],
      f13_x_p1040_lanes[1], f13_x_p92_lanes[0], f13_x_p1040_lanes[3], f13_x_p1040_lanes[4],
      f13_x_p1040_lanes[5], f13_x_p1040_lanes[0], f13_x_p1040_lanes[0]) * inverse_D10_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2349_lanes = f13_x_p2251_lanes * inverse_D4;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2363_lanes = f13_x_p2231_lanes * f13_x_p1531_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2373_lanes = -(s5 * f13_x_p2063_lanes - c5 * f13_x_p2055_lanes +
      0.21799999999999997 * f13_x_p2087_lanes);
  const Lanes<8> f13_x_p2425_lanes = -(s5 * f13_x_p2079_lanes + c5 * f13_x_p2071_lanes) -
      inverse_D2_p7 * f13_x_p2251_lanes;
  const Lanes<8> f13_x_p2473_lanes = c4 * (-(0.21799999999999997 * f13_x_p2199_lanes) +
      inverse_D3_p37 * f13_x_p2251_lanes);
  const Lanes<8> f13_x_p2496_lanes = s4 * (f13_x_p2087_lanes + inverse_D2_p6 * f13_x_p2251_lanes);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2512_lanes = f13_x_p2231_lanes * f13_x_p1531_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2558_lanes = s4 * (f13_x_p2373_lanes - inverse_D3_p36 * f13_x_p2251_lanes) +
      f13_x_p2473_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2589_lanes = inverse_D2_p16 * f13_x_p2558_lanes;
  const Lanes<8> f13_x_p2605_lanes = f13_x_p2558_lanes * inverse_D3;
  const Lanes<8> f13_x_p2613_lanes = f13_x_p2039_lanes * f13_x_p2558_lanes[0];
  const Lanes<8> f13_x_p2617_lanes = f13_x_p2039_lanes * f13_x_p2558_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2633_lanes = f13_x_p2337_lanes * f13_x_p1040_lanes[0] + f13_x_p2323_lanes *
      f13_x_p1197_lanes[0] + f13_x_p2245_lanes * f13_x_p1391_lanes[0] + f13_x_p2363_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2644_lanes = f13_x_p2039_lanes * f13_x_p2558_lanes[2];
  const Lanes<8> f13_x_p2648_lanes = c4 * (-f13_x_p2199_lanes + inverse_D2_p5 * f13_x_p2251_lanes) -
      f13_x_p2496_lanes - f13_x_p2589_lanes;
  const Lanes<8> f13_x_p2656_lanes = -f13_x_p2425_lanes + inverse_D2_p15 * f13_x_p2558_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2679_lanes = f13_x_p2633_lanes + f13_x_p2217_lanes * f13_x_p1787_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2685_lanes = f13_x_p2337_lanes * f13_x_p1040_lanes[1] + f13_x_p2323_lanes *
      f13_x_p1197_lanes[1] + f13_x_p2245_lanes * f13_x_p1391_lanes[1] + f13_x_p2512_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2690_lanes = f13_x_p2099_lanes * f13_x_p1787_lanes[0] + f13_x_p2095_lanes *
      f13_x_p1979_lanes[0] + f13_x_p2051_lanes * f13_x_p2251_lanes[0] + f13_x_p2613_lanes;
  const Lanes<8> f13_x_p2694_lanes = f13_x_p2099_lanes * f13_x_p1787_lanes[1] + f13_x_p2095_lanes *
      f13_x_p1979_lanes[1] + f13_x_p2051_lanes * f13_x_p2251_lanes[1] + f13_x_p2617_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2760_lanes = f13_x_p2685_lanes + f13_x_p2217_lanes * f13_x_p1787_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2777_lanes = f13_x_p2231_lanes * f13_x_p1531_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2789_lanes = c3 * f13_x_p2648_lanes - s3 * f13_x_p2656_lanes;
  const Lanes<8> f13_x_p2824_lanes = f13_x_p2099_lanes * f13_x_p1787_lanes[2] + f13_x_p2095_lanes *
      f13_x_p1979_lanes[2] + f13_x_p2051_lanes * f13_x_p2251_lanes[2] + f13_x_p2644_lanes;
  const Lanes<8> f13_x_p2828_lanes = 0.422 * f13_x_p2789_lanes;
  const Lanes<8> f13_x_p2836_lanes = detail::make_pack<Real>(f13_x_p2679_lanes[0],
      f13_x_p2679_lanes[1], f13_x_p2679_lanes[2], f13_x_p2679_lanes[3], f13_x_p2679_lanes[4],
      f13_x_p2679_lanes[5], f13_x_p2208 * f13_x_p1787_lanes[0], f13_x_p2207 *
      f13_x_p1787_lanes[0]) + f13_x_p2183_lanes * f13_x_p1979_lanes[0] + f13_x_p2349_lanes *
      f13_x_p2251_lanes[0] + f13_x_p2605_lanes * f13_x_p2558_lanes[0];
  const Lanes<8> f13_x_p2855_lanes = detail::make_pack<Real>(f13_x_p2760_lanes[1],
      f13_x_p2760_lanes[1], f13_x_p2760_lanes[2], f13_x_p2760_lanes[3], f13_x_p2760_lanes[4],
      f13_x_p2760_lanes[5], f13_x_p2208 * f13_x_p1787_lanes[1], f13_x_p2207 *
      f13_x_p1787_lanes[1]) + f13_x_p2183_lanes * f13_x_p1979_lanes[1] + f13_x_p2349_lanes *
      f13_x_p2251_lanes[1] + f13_x_p2605_lanes * f13_x_p2558_lanes[1];
  const Lanes<8> f13_x_p2862_lanes = f13_x_p2039_lanes * f13_x_p2558_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2890_lanes = f13_x_p2828_lanes * inverse_D2;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2898_lanes = f13_x_p2337_lanes * f13_x_p92_lanes[0] + f13_x_p2323_lanes *
      f13_x_p1197_lanes[2] + f13_x_p2245_lanes * f13_x_p1391_lanes[2] + f13_x_p2777_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2922_lanes = f13_x_p2898_lanes + f13_x_p2217_lanes * f13_x_p1787_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2998_lanes = s2 * (s3 * f13_x_p2648_lanes + c3 * f13_x_p2656_lanes -
      inverse_D1_p6 * f13_x_p2828_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p3009_lanes = f13_x_p152_lanes * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p3027_lanes = detail::make_pack<Real>(s13, s13, s13, s13, c13,
      f13_x_p13_lanes[0], s13, s13) * inverse_D12_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p3030_lanes = f13_x_p2323_lanes * f13_x_p1197_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3077_lanes = detail::make_pack<Real>(f13_x_p2922_lanes[2],
      f13_x_p2922_lanes[2], f13_x_p2922_lanes[2], f13_x_p2922_lanes[3], f13_x_p2922_lanes[4],
      f13_x_p2922_lanes[5], f13_x_p2208 * f13_x_p1787_lanes[2], f13_x_p2207 *
      f13_x_p1787_lanes[2]) + f13_x_p2183_lanes * f13_x_p1979_lanes[2] + f13_x_p2349_lanes *
      f13_x_p2251_lanes[2] + f13_x_p2605_lanes * f13_x_p2558_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p3087_lanes = 0.434 * (c2 * (f13_x_p2789_lanes - inverse_D1_p2 *
      f13_x_p2828_lanes) - f13_x_p2998_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3104_lanes = f13_x_p2099_lanes * f13_x_p1787_lanes[3] + f13_x_p2095_lanes *
      f13_x_p1979_lanes[3] + f13_x_p2051_lanes * f13_x_p2251_lanes[3] + f13_x_p2862_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3108_lanes = f13_x_p3087_lanes * inverse_D1;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3151_lanes = f13_x_p2039_lanes * f13_x_p2558_lanes[4];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p3184_lanes = f13_x_p3027_lanes * s13 + f13_x_p3009_lanes *
      f13_x_p152_lanes[3] + f13_x_p2337_lanes * f13_x_p1040_lanes[3] + f13_x_p3030_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3192_lanes = f13_x_p2690_lanes + f13_x_p2035_lanes * f13_x_p2828_lanes[0] +
      f13_x_p1599_lanes * f13_x_p3087_lanes[0];
  const Lanes<8> f13_x_p3227_lanes = f13_x_p2836_lanes + f13_x_p2890_lanes * f13_x_p2828_lanes[0] +
      f13_x_p3108_lanes * f13_x_p3087_lanes[0];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p3248_lanes = f13_x_p102_lanes * inverse_D11_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p3256 = 1.0 / f13_x_p3227_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3265_lanes = f13_x_p3184_lanes + f13_x_p2245_lanes * f13_x_p1391_lanes[3] +
      f13_x_p2231_lanes * f13_x_p1531_lanes[3] + f13_x_p2217_lanes * f13_x_p1787_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p3268_lanes = detail::make_pack<Real>(f13_x_p3009_lanes[5],
      f13_x_p3248_lanes[3]) * detail::make_pack<Real>(f13_x_p152_lanes[4], f13_x_p102_lanes[2]);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3274_lanes = f13_x_p2099_lanes * f13_x_p1787_lanes[4] + f13_x_p2095_lanes *
      f13_x_p1979_lanes[4] + f13_x_p2051_lanes * f13_x_p2251_lanes[4] + f13_x_p3151_lanes;
  const Lanes<8> f13_x_p3300_lanes = detail::make_pack<Real>(f13_x_p3265_lanes[3],
      f13_x_p3265_lanes[3], f13_x_p3265_lanes[3], f13_x_p3265_lanes[3], f13_x_p3265_lanes[4],
      f13_x_p3265_lanes[5], f13_x_p2208 * f13_x_p1787_lanes[3], f13_x_p2207 *
      f13_x_p1787_lanes[3]) + f13_x_p2183_lanes * f13_x_p1979_lanes[3] + f13_x_p2349_lanes *
      f13_x_p2251_lanes[3] + f13_x_p2605_lanes * f13_x_p2558_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3307_lanes = f13_x_p3227_lanes * f13_x_p3256;
  const Lanes<8> f13_x_p3314_lanes = f13_x_p3192_lanes * f13_x_p3256;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3333_lanes = f13_x_p2039_lanes * f13_x_p2558_lanes[5];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3372_lanes = f13_x_p3027_lanes * c13 +
      detail::make_pack<Real>(f13_x_p3009_lanes[4] * f13_x_p152_lanes[4], f13_x_p3009_lanes[4] *
      f13_x_p152_lanes[4], f13_x_p3009_lanes[4] * f13_x_p152_lanes[4], f13_x_p3009_lanes[4] *
      f13_x_p152_lanes[4], f13_x_p3009_lanes[4] * f13_x_p152_lanes[4], f13_x_p3268_lanes[0],
      f13_x_p3009_lanes[4] * f13_x_p152_lanes[4], f13_x_p3009_lanes[4] * f13_x_p152_lanes[4]) +
      detail::make_pack<Real>(f13_x_p2337_lanes[4] * f13_x_p1040_lanes[4], f13_x_p2337_lanes[4] *
      f13_x_p1040_lanes[4], f13_x_p2337_lanes[4] * f13_x_p1040_lanes[4], f13_x_p2337_lanes[4] *
      f13_x_p1040_lanes[4], f13_x_p2337_lanes[4] * f13_x_p1040_lanes[4], f13_x_p2337_lanes[5] *
      f13_x_p1040_lanes[4], f13_x_p2337_lanes[4] * f13_x_p1040_lanes[4], f13_x_p2337_lanes[4] *
      f13_x_p1040_lanes[4]) + detail::make_pack<Real>(f13_x_p2323_lanes[4] * f13_x_p1197_lanes[4],
      f13_x_p2323_lanes[4] * f13_x_p1197_lanes[4], f13_x_p2323_lanes[4] * f13_x_p1197_lanes[4],
      f13_x_p2323_lanes[4] * f13_x_p1197_lanes[4], f13_x_p2323_lanes[4] * f13_x_p1197_lanes[4],
      f13_x_p2323_lanes[5] * f13_x_p1197_lanes[4], f13_x_p2323_lanes[4] * f13_x_p1197_lanes[4],
      f13_x_p2323_lanes[4] * f13_x_p1197_lanes[4]) + detail::make_pack<Real>(f13_x_p2245_lanes[4] *
      f13_x_p1391_lanes[4], f13_x_p2245_lanes[4] * f13_x_p1391_lanes[4], f13_x_p2245_lanes[4] *
      f13_x_p1391_lanes[4], f13_x_p2245_lanes[4] * f13_x_p1391_lanes[4], f13_x_p2245_lanes[4] *
      f13_x_p1391_lanes[4], f13_x_p2245_lanes[5] * f13_x_p1391_lanes[4], f13_x_p2245_lanes[4] *
      f13_x_p1391_lanes[4], f13_x_p2245_lanes[4] * f13_x_p1391_lanes[4]) +
      detail::make_pack<Real>(f13_x_p2231_lanes[4] * f13_x_p1531_lanes[4], f13_x_p2231_lanes[4] *
      f13_x_p1531_lanes[4], f13_x_p2231_lanes[4] * f13_x_p1531_lanes[4], f13_x_p2231_lanes[4] *
      f13_x_p1531_lanes[4], f13_x_p2231_lanes[4] * f13_x_p1531_lanes[4], f13_x_p2231_lanes[5] *
      f13_x_p1531_lanes[4], f13_x_p2231_lanes[4] * f13_x_p1531_lanes[4], f13_x_p2231_lanes[4] *
      f13_x_p1531_lanes[4]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3402_lanes = f13_x_p2855_lanes + f13_x_p2890_lanes * f13_x_p2828_lanes[1] +
      f13_x_p3108_lanes * f13_x_p3087_lanes[1] - f13_x_p3307_lanes * f13_x_p3227_lanes[1];
  const Lanes<8> f13_x_p3409_lanes = f13_x_p3077_lanes + f13_x_p2890_lanes * f13_x_p2828_lanes[2] +
      f13_x_p3108_lanes * f13_x_p3087_lanes[2] - f13_x_p3307_lanes * f13_x_p3227_lanes[2];
  const Lanes<8> f13_x_p3415_lanes = f13_x_p3300_lanes + f13_x_p2890_lanes * f13_x_p2828_lanes[3] +
      f13_x_p3108_lanes * f13_x_p3087_lanes[3] - f13_x_p3307_lanes * f13_x_p3227_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3420_lanes = f13_x_p3372_lanes +
      detail::make_pack<Real>(f13_x_p2217_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2217_lanes[4] *
      f13_x_p1787_lanes[4], f13_x_p2217_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2217_lanes[4] *
      f13_x_p1787_lanes[4], f13_x_p2217_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2217_lanes[5] *
      f13_x_p1787_lanes[4], f13_x_p2217_lanes[4] * f13_x_p1787_lanes[4], f13_x_p2217_lanes[4] *
      f13_x_p1787_lanes[4]);

  // link 1 (calf), force propagation
  const Real f13_x_p3437 = 1.0 / f13_x_p3402_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p3442_lanes = f13_x_p412_lanes * inverse_D8_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3446_lanes = f13_x_p496_lanes * inverse_D7_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p3450_lanes = f13_x_p302_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p3457_lanes = detail::make_pack<Real>(f13_x_p92_lanes[1],
      f13_x_p221_lanes[1], f13_x_p221_lanes[2], f13_x_p221_lanes[3], f13_x_p92_lanes[1],
      f13_x_p92_lanes[1], f13_x_p92_lanes[1], f13_x_p92_lanes[1]) * inverse_D10_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3461_lanes = f13_x_p2694_lanes + f13_x_p2035_lanes * f13_x_p2828_lanes[1] +
      f13_x_p1599_lanes * f13_x_p3087_lanes[1] - f13_x_p3314_lanes * f13_x_p3227_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p3467_lanes = detail::make_pack<Real>(s20, s20, c20, f13_x_p13_lanes[1], s20,
      s20, s20, s20) * inverse_D12_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3470_lanes = f13_x_p2824_lanes + f13_x_p2035_lanes * f13_x_p2828_lanes[2] +
      f13_x_p1599_lanes * f13_x_p3087_lanes[2] - f13_x_p3314_lanes * f13_x_p3227_lanes[2];
  const Lanes<8> f13_x_p3474_lanes = f13_x_p3104_lanes + f13_x_p2035_lanes * f13_x_p2828_lanes[3] +
      f13_x_p1599_lanes * f13_x_p3087_lanes[3] - f13_x_p3314_lanes * f13_x_p3227_lanes[3];
  const Lanes<8> f13_x_p3486_lanes = f13_x_p3274_lanes + f13_x_p2035_lanes * f13_x_p2828_lanes[4] +
      f13_x_p1599_lanes * f13_x_p3087_lanes[4] - f13_x_p3314_lanes * f13_x_p3227_lanes[4];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3500_lanes = detail::make_pack<Real>(f13_x_p3420_lanes[4],
      f13_x_p3420_lanes[4], f13_x_p3420_lanes[4], f13_x_p3420_lanes[4], f13_x_p3420_lanes[4],
      f13_x_p3420_lanes[5], f13_x_p2208 * f13_x_p1787_lanes[4], f13_x_p2207 *
      f13_x_p1787_lanes[4]) + f13_x_p2183_lanes * f13_x_p1979_lanes[4] + f13_x_p2349_lanes *
      f13_x_p2251_lanes[4] + f13_x_p2605_lanes * f13_x_p2558_lanes[4];
  const Lanes<8> f13_x_p3504_lanes = f13_x_p2099_lanes * f13_x_p1787_lanes[5] + f13_x_p2095_lanes *
      f13_x_p1979_lanes[5] + f13_x_p2051_lanes * f13_x_p2251_lanes[5] + f13_x_p3333_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3526_lanes = f13_x_p3402_lanes * f13_x_p3437;
  const Lanes<8> f13_x_p3534_lanes = f13_x_p3461_lanes * f13_x_p3437;
  const Lanes<8> f13_x_p3538_lanes = f13_x_p3500_lanes + f13_x_p2890_lanes * f13_x_p2828_lanes[4] +
      f13_x_p3108_lanes * f13_x_p3087_lanes[4] - f13_x_p3307_lanes * f13_x_p3227_lanes[4];
  const Lanes<8> f13_x_p3542_lanes = f13_x_p3504_lanes + f13_x_p2035_lanes * f13_x_p2828_lanes[5] +
      f13_x_p1599_lanes * f13_x_p3087_lanes[5] - f13_x_p3314_lanes * f13_x_p3227_lanes[5];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p3546_lanes = 1065.380700001509 +
      detail::make_pack<Real>(f13_x_p3027_lanes[5], f13_x_p3467_lanes[3]) * f13_x_p13_lanes +
      detail::make_pack<Real>(f13_x_p3009_lanes[5], f13_x_p3248_lanes[3]) *
      detail::make_pack<Real>(f13_x_p152_lanes[5], f13_x_p102_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2337_lanes[5], f13_x_p3457_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1040_lanes[5], f13_x_p221_lanes[3]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3584_lanes = f13_x_p3446_lanes * f13_x_p1365;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3612_lanes = f13_x_p3409_lanes - f13_x_p3526_lanes * f13_x_p3402_lanes[2];
  const Lanes<8> f13_x_p3633_lanes = f13_x_p3470_lanes - f13_x_p3534_lanes * f13_x_p3402_lanes[2];
  const Real f13_x_p3661 = 1.0 / f13_x_p3612_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p3666_lanes = f13_x_p3546_lanes +
      detail::make_pack<Real>(f13_x_p2323_lanes[5], f13_x_p3450_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1197_lanes[5], f13_x_p302_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2245_lanes[5], f13_x_p3442_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1391_lanes[5], f13_x_p412_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2231_lanes[5], f13_x_p3446_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1531_lanes[5], f13_x_p496_lanes[3]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3676_lanes = f13_x_p3457_lanes * f13_x_p964 + f13_x_p3450_lanes *
      f13_x_p1029 + f13_x_p3442_lanes * f13_x_p1195 + f13_x_p3584_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3694_lanes = f13_x_p3612_lanes * f13_x_p3661;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3699_lanes = detail::make_pack<Real>(f13_x_p3666_lanes[0] +
      f13_x_p2217_lanes[5] * f13_x_p1787_lanes[5], f13_x_p3666_lanes[0] + f13_x_p2217_lanes[5] *
      f13_x_p1787_lanes[5], f13_x_p3666_lanes[0] + f13_x_p2217_lanes[5] * f13_x_p1787_lanes[5],
      f13_x_p3666_lanes[0] + f13_x_p2217_lanes[5] * f13_x_p1787_lanes[5], f13_x_p3666_lanes[0] +
      f13_x_p2217_lanes[5] * f13_x_p1787_lanes[5], f13_x_p3666_lanes[0] + f13_x_p2217_lanes[5] *
      f13_x_p1787_lanes[5], f13_x_p2208 * f13_x_p1787_lanes[5], f13_x_p2207 *
      f13_x_p1787_lanes[5]) + f13_x_p2183_lanes * f13_x_p1979_lanes[5] + f13_x_p2349_lanes *
      f13_x_p2251_lanes[5] + f13_x_p2605_lanes * f13_x_p2558_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3702_lanes = f13_x_p3633_lanes * f13_x_p3661;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3706_lanes = f13_x_p3676_lanes + f13_x_p2099_lanes * f13_x_p1787_lanes[6] +
      f13_x_p2095_lanes * f13_x_p1979_lanes[6] + f13_x_p2051_lanes * f13_x_p2251_lanes[6];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3725 = f13_x_p964 * inverse_D10_lanes[1] * f13_x_p964 + f13_x_p1029 *
      inverse_D9_lanes[1] * f13_x_p1029 + f13_x_p1195 * inverse_D8_lanes[1] * f13_x_p1195;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3741_lanes = f13_x_p3415_lanes - f13_x_p3526_lanes * f13_x_p3402_lanes[3] -
      f13_x_p3694_lanes * f13_x_p3612_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p3750 = f13_x_p1364 * inverse_D7_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3751_lanes = f13_x_p3699_lanes + f13_x_p2890_lanes * f13_x_p2828_lanes[5] +
      f13_x_p3108_lanes * f13_x_p3087_lanes[5] - f13_x_p3307_lanes * f13_x_p3227_lanes[5];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3754 = f13_x_p1065 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p3755 = f13_x_p958 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p3756 = f13_x_p902 * inverse_D10_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3757_lanes = f13_x_p3474_lanes - f13_x_p3534_lanes * f13_x_p3402_lanes[3] -
      f13_x_p3702_lanes * f13_x_p3612_lanes[3];
  const Real f13_x_p3765 = 1.0 / f13_x_p3741_lanes[3];
  const Lanes<8> f13_x_p3781_lanes = f13_x_p3706_lanes + f13_x_p2039_lanes * f13_x_p2558_lanes[6] +
      f13_x_p2035_lanes * f13_x_p2828_lanes[6] + f13_x_p1599_lanes * f13_x_p3087_lanes[6];

  // link 4 (chest1), force propagation
  const Real f13_x_p3792 = f13_x_p3725 + f13_x_p1365 * inverse_D7_lanes[1] * f13_x_p1365 +
      f13_x_p2208 * f13_x_p1787_lanes[6] + f13_x_p2183_lanes[6] * f13_x_p1979_lanes[6] +
      f13_x_p2349_lanes[6] * f13_x_p2251_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3829_lanes = f13_x_p3446_lanes * f13_x_p1364;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3853_lanes = f13_x_p3741_lanes * f13_x_p3765;
  const Lanes<8> f13_x_p3857_lanes = f13_x_p3757_lanes * f13_x_p3765;
  const Lanes<8> f13_x_p3865_lanes = f13_x_p3781_lanes - f13_x_p3314_lanes * f13_x_p3227_lanes[6] -
      f13_x_p3534_lanes * f13_x_p3402_lanes[6] - f13_x_p3702_lanes * f13_x_p3612_lanes[6];

  // link 6 (chest3), force propagation
  const Real f13_x_p3869 = f13_x_p3756 * f13_x_p964 + f13_x_p3755 * f13_x_p1029 + f13_x_p3754 *
      f13_x_p1195 + f13_x_p3750 * f13_x_p1365 + f13_x_p2207 * f13_x_p1787_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p3881 = f13_x_p3792 + f13_x_p2605_lanes[6] * f13_x_p2558_lanes[6] +
      f13_x_p2890_lanes[6] * f13_x_p2828_lanes[6] + f13_x_p3108_lanes[6] * f13_x_p3087_lanes[6] -
      f13_x_p3307_lanes[6] * f13_x_p3227_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3890_lanes = f13_x_p3457_lanes * f13_x_p902 + f13_x_p3450_lanes *
      f13_x_p958 + f13_x_p3442_lanes * f13_x_p1065 + f13_x_p3829_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3894_lanes = f13_x_p3538_lanes - f13_x_p3526_lanes * f13_x_p3402_lanes[4] -
      f13_x_p3694_lanes * f13_x_p3612_lanes[4] - f13_x_p3853_lanes * f13_x_p3741_lanes[4];
  const Lanes<8> f13_x_p3898_lanes = f13_x_p3751_lanes - f13_x_p3526_lanes * f13_x_p3402_lanes[5] -
      f13_x_p3694_lanes * f13_x_p3612_lanes[5] - f13_x_p3853_lanes * f13_x_p3741_lanes[5];
  const Real f13_x_p3905 = 1.0 / f13_x_p3894_lanes[4];
  const Lanes<8> f13_x_p3906_lanes = f13_x_p3486_lanes - f13_x_p3534_lanes * f13_x_p3402_lanes[4] -
      f13_x_p3702_lanes * f13_x_p3612_lanes[4] - f13_x_p3857_lanes * f13_x_p3741_lanes[4];
  const Lanes<8> f13_x_p3910_lanes = f13_x_p3542_lanes - f13_x_p3534_lanes * f13_x_p3402_lanes[5] -
      f13_x_p3702_lanes * f13_x_p3612_lanes[5] - f13_x_p3857_lanes * f13_x_p3741_lanes[5];

  // link 2 (thigh), force propagation
  const Real f13_x_p3926 = f13_x_p3869 + f13_x_p2183_lanes[7] * f13_x_p1979_lanes[6] +
      f13_x_p2349_lanes[7] * f13_x_p2251_lanes[6] + f13_x_p2605_lanes[7] * f13_x_p2558_lanes[6] +
      f13_x_p2890_lanes[7] * f13_x_p2828_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3927_lanes = f13_x_p3890_lanes + f13_x_p2099_lanes * f13_x_p1787_lanes[7] +
      f13_x_p2095_lanes * f13_x_p1979_lanes[7] + f13_x_p2051_lanes * f13_x_p2251_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3971_lanes = f13_x_p3446_lanes * f13_x_p496_lanes[0];

  // link 6 (chest3), force propagation
  const Real f13_x_p3975 = f13_x_p3756 * f13_x_p902 + f13_x_p3755 * f13_x_p958 + f13_x_p3754 *
      f13_x_p1065 + f13_x_p3750 * f13_x_p1364 + f13_x_p2207 * f13_x_p1787_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4000_lanes = f13_x_p3894_lanes * f13_x_p3905;
  const Lanes<8> f13_x_p4003_lanes = f13_x_p3906_lanes * f13_x_p3905;
  const Lanes<8> f13_x_p4011_lanes = f13_x_p3927_lanes + f13_x_p2039_lanes * f13_x_p2558_lanes[7] +
      f13_x_p2035_lanes * f13_x_p2828_lanes[7] + f13_x_p1599_lanes * f13_x_p3087_lanes[7];
  const Real f13_x_p4015 = f13_x_p3926 + f13_x_p3108_lanes[7] * f13_x_p3087_lanes[6] -
      f13_x_p3307_lanes[7] * f13_x_p3227_lanes[6] - f13_x_p3526_lanes[7] * f13_x_p3402_lanes[6] -
      f13_x_p3694_lanes[7] * f13_x_p3612_lanes[6];
  const Lanes<8> f13_x_p4052_lanes = f13_x_p3898_lanes - f13_x_p4000_lanes * f13_x_p3894_lanes[5];
  const Real f13_x_p4055 = f13_x_p3881 - f13_x_p3526_lanes[6] * f13_x_p3402_lanes[6] -
      f13_x_p3694_lanes[6] * f13_x_p3612_lanes[6] - f13_x_p3853_lanes[6] * f13_x_p3741_lanes[6] -
      f13_x_p4000_lanes[6] * f13_x_p3894_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4056_lanes = f13_x_p3457_lanes * f13_x_p92_lanes[1] + f13_x_p3450_lanes *
      f13_x_p302_lanes[0] + f13_x_p3442_lanes * f13_x_p412_lanes[0] + f13_x_p3971_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4063_lanes = f13_x_p3910_lanes - f13_x_p4003_lanes * f13_x_p3894_lanes[5];

  // link 2 (thigh), force propagation
  const Real f13_x_p4075 = f13_x_p3975 + f13_x_p2183_lanes[7] * f13_x_p1979_lanes[7] +
      f13_x_p2349_lanes[7] * f13_x_p2251_lanes[7] + f13_x_p2605_lanes[7] * f13_x_p2558_lanes[7] +
      f13_x_p2890_lanes[7] * f13_x_p2828_lanes[7];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p4076_lanes = f13_x_p3450_lanes * f13_x_p302_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p4085 = 1.0 / f13_x_p4052_lanes[5];
  const Lanes<8> f13_x_p4099_lanes = f13_x_p4011_lanes - f13_x_p3314_lanes * f13_x_p3227_lanes[7] -
      f13_x_p3534_lanes * f13_x_p3402_lanes[7] - f13_x_p3702_lanes * f13_x_p3612_lanes[7];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p4135_lanes = f13_x_p4056_lanes + f13_x_p2099_lanes * f13_x_p624_lanes[0] +
      f13_x_p2095_lanes * f13_x_p720_lanes[0] + f13_x_p2051_lanes * f13_x_p829_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p4150_lanes = f13_x_p3467_lanes * s20 + f13_x_p3248_lanes *
      f13_x_p102_lanes[1] + f13_x_p3457_lanes * f13_x_p221_lanes[1] + f13_x_p4076_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4153 = f13_x_p4075 + f13_x_p3108_lanes[7] * f13_x_p3087_lanes[7] -
      f13_x_p3307_lanes[7] * f13_x_p3227_lanes[7] - f13_x_p3526_lanes[7] * f13_x_p3402_lanes[7] -
      f13_x_p3694_lanes[7] * f13_x_p3612_lanes[7];
  const Real f13_x_p4158 = f13_x_p4052_lanes[6] * f13_x_p4085;
  const Real f13_x_p4159 = f13_x_p4052_lanes[7] * f13_x_p4085;
  const Lanes<8> f13_x_p4160_lanes = f13_x_p4063_lanes * f13_x_p4085;
  const Lanes<8> f13_x_p4167_lanes = f13_x_p4135_lanes + f13_x_p2039_lanes * f13_x_p932_lanes[0] +
      f13_x_p2035_lanes * f13_x_p1034_lanes[0] + f13_x_p1599_lanes * f13_x_p1555_lanes[0];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p4186_lanes = f13_x_p3467_lanes * c20;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4188_lanes = f13_x_p4150_lanes + f13_x_p3442_lanes * f13_x_p412_lanes[1] +
      f13_x_p3446_lanes * f13_x_p496_lanes[1] + f13_x_p2099_lanes * f13_x_p624_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p4198 = f13_x_p4015 - f13_x_p3853_lanes[7] * f13_x_p3741_lanes[6] -
      f13_x_p4000_lanes[7] * f13_x_p3894_lanes[6] - f13_x_p4159 * f13_x_p4052_lanes[6];
  const Lanes<8> f13_x_p4203_lanes = f13_x_p3865_lanes - f13_x_p3857_lanes * f13_x_p3741_lanes[6] -
      f13_x_p4003_lanes * f13_x_p3894_lanes[6] - f13_x_p4160_lanes * f13_x_p4052_lanes[6];
  const Lanes<8> f13_x_p4210_lanes = f13_x_p4099_lanes - f13_x_p3857_lanes * f13_x_p3741_lanes[7] -
      f13_x_p4003_lanes * f13_x_p3894_lanes[7] - f13_x_p4160_lanes * f13_x_p4052_lanes[7];
  const Real f13_x_p4214 = 1.0 / (f13_x_p4055 - f13_x_p4158 * f13_x_p4052_lanes[6]);
  const Lanes<8> f13_x_p4215_lanes = f13_x_p4167_lanes - f13_x_p3314_lanes * f13_x_p3192_lanes[0] -
      f13_x_p3534_lanes * f13_x_p3461_lanes[0] - f13_x_p3702_lanes * f13_x_p3633_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4226_lanes = f13_x_p4188_lanes + f13_x_p2095_lanes * f13_x_p720_lanes[1] +
      f13_x_p2051_lanes * f13_x_p829_lanes[1] + f13_x_p2039_lanes * f13_x_p932_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4236_lanes = f13_x_p4215_lanes - f13_x_p3857_lanes * f13_x_p3757_lanes[0] -
      f13_x_p4003_lanes * f13_x_p3906_lanes[0] - f13_x_p4160_lanes * f13_x_p4063_lanes[0];

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p4243 = f13_x_p4186_lanes[3] + f13_x_p3268_lanes[1] + f13_x_p3457_lanes[3] *
      f13_x_p221_lanes[2] + f13_x_p3450_lanes[3] * f13_x_p302_lanes[2] + f13_x_p3442_lanes[3] *
      f13_x_p412_lanes[2] + f13_x_p3446_lanes[3] * f13_x_p496_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p4244 = f13_x_p4198 * f13_x_p4214;
  const Lanes<8> f13_x_p4245_lanes = f13_x_p4203_lanes * f13_x_p4214;
  const Lanes<8> f13_x_p4249_lanes = f13_x_p4226_lanes + f13_x_p2035_lanes * f13_x_p1034_lanes[1] +
      f13_x_p1599_lanes * f13_x_p1555_lanes[1] - f13_x_p3314_lanes * f13_x_p3192_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4263 = f13_x_p4186_lanes[2] + f13_x_p3248_lanes[2] * f13_x_p102_lanes[2] +
      f13_x_p3457_lanes[2] * f13_x_p221_lanes[2] + f13_x_p3450_lanes[2] * f13_x_p302_lanes[2] +
      f13_x_p3442_lanes[2] * f13_x_p412_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4266_lanes = 9.81 + detail::make_pack<Real>(xdd_cmd[2], xdd_cmd[8]);

  // link 1 (calf), force propagation
  const Real f13_x_p4280 = f13_x_p4153 - f13_x_p3853_lanes[7] * f13_x_p3741_lanes[7] -
      f13_x_p4000_lanes[7] * f13_x_p3894_lanes[7] - f13_x_p4159 * f13_x_p4052_lanes[7] -
      f13_x_p4244 * f13_x_p4198;
  const Lanes<8> f13_x_p4281_lanes = f13_x_p4210_lanes - f13_x_p4245_lanes * f13_x_p4198;
  const Lanes<8> f13_x_p4289_lanes = f13_x_p4249_lanes - f13_x_p3534_lanes * f13_x_p3461_lanes[1] -
      f13_x_p3702_lanes * f13_x_p3633_lanes[1] - f13_x_p3857_lanes * f13_x_p3757_lanes[1];
  const Real f13_x_p4294 = 1.0 / f13_x_p4280;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4295_lanes = c1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) - s1 *
      f13_x_p4266_lanes;
  const Lanes<2> f13_x_p4297_lanes = s1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) + c1 *
      f13_x_p4266_lanes;

  // link 3 (hip), force propagation
  const Real f13_x_p4302 = f13_x_p4243 + f13_x_p2099_lanes[3] * f13_x_p624_lanes[2] +
      f13_x_p2095_lanes[3] * f13_x_p720_lanes[2] + f13_x_p2051_lanes[3] * f13_x_p829_lanes[2] +
      f13_x_p2039_lanes[3] * f13_x_p932_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p4313 = f13_x_p4263 + f13_x_p3446_lanes[2] * f13_x_p496_lanes[2] +
      f13_x_p2099_lanes[2] * f13_x_p624_lanes[2] + f13_x_p2095_lanes[2] * f13_x_p720_lanes[2] +
      f13_x_p2051_lanes[2] * f13_x_p829_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4317_lanes = c2 * f13_x_p4295_lanes - s2 * f13_x_p4297_lanes;
  const Lanes<2> f13_x_p4319_lanes = s2 * f13_x_p4295_lanes + c2 * f13_x_p4297_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4321_lanes = f13_x_p4289_lanes - f13_x_p4003_lanes * f13_x_p3906_lanes[1] -
      f13_x_p4160_lanes * f13_x_p4063_lanes[1] - f13_x_p4245_lanes * f13_x_p4203_lanes[1];
  const Lanes<8> f13_x_p4332_lanes = f13_x_p4281_lanes * f13_x_p4294;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4336_lanes = c3 * f13_x_p4317_lanes - s3 * f13_x_p4319_lanes;
  const Lanes<2> f13_x_p4338_lanes = s3 * f13_x_p4317_lanes + c3 * f13_x_p4319_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4340 = f13_x_p4302 + f13_x_p2035_lanes[3] * f13_x_p1034_lanes[2] +
      f13_x_p1599_lanes[3] * f13_x_p1555_lanes[2] - f13_x_p3314_lanes[3] * f13_x_p3192_lanes[2] -
      f13_x_p3534_lanes[3] * f13_x_p3461_lanes[2];
  const Real f13_x_p4356 = f13_x_p4313 + f13_x_p2039_lanes[2] * f13_x_p932_lanes[2] +
      f13_x_p2035_lanes[2] * f13_x_p1034_lanes[2] + f13_x_p1599_lanes[2] * f13_x_p1555_lanes[2] -
      f13_x_p3314_lanes[2] * f13_x_p3192_lanes[2];
  const Lanes<8> f13_x_p4357_lanes = f13_x_p4236_lanes - f13_x_p4245_lanes * f13_x_p4203_lanes[0] -
      f13_x_p4332_lanes * f13_x_p4281_lanes[0];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4364_lanes = c4 * f13_x_p4336_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Lanes<2> f13_x_p4366_lanes = c4 * detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]) - s4 *
      f13_x_p4336_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4368 = 1.0 / f13_x_p4357_lanes[0];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4377_lanes = s5 * f13_x_p4364_lanes + c5 * f13_x_p4338_lanes;
  const Lanes<2> f13_x_p4379_lanes = c5 * f13_x_p4364_lanes - s5 * f13_x_p4338_lanes;

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 1 (calf), force propagation
  const Real f13_x_p4381 = f13_x_p4340 - f13_x_p3702_lanes[3] * f13_x_p3633_lanes[2] -
      f13_x_p3857_lanes[3] * f13_x_p3757_lanes[2] - f13_x_p4003_lanes[3] * f13_x_p3906_lanes[2] -
      f13_x_p4160_lanes[3] * f13_x_p4063_lanes[2];

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];

  // link 1 (calf), force propagation
  const Real f13_x_p4390 = f13_x_p4356 - f13_x_p3534_lanes[2] * f13_x_p3461_lanes[2] -
      f13_x_p3702_lanes[2] * f13_x_p3633_lanes[2] - f13_x_p3857_lanes[2] * f13_x_p3757_lanes[2] -
      f13_x_p4003_lanes[2] * f13_x_p3906_lanes[2];

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * qdd_0[0] - minus_a1_x;
  const Real a3_x_p1 = w2_z * w2_z;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4391_lanes = s6 * f13_x_p4366_lanes - c6 * f13_x_p4377_lanes;

  // link 2 (thigh), outward
  const Real a2_y_p2 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;
  const Real wd2_z = qdd_0[0] + qdd_0[1];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4393_lanes = s6 * f13_x_p4377_lanes + c6 * f13_x_p4366_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4395_lanes = f13_x_p4357_lanes * f13_x_p4368;

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_y = c4 * w3_z;
  const Real w4_x = s4 * w3_z;

  // link 3 (hip), outward
  const Real wd3_z = wd2_z + qdd_0[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4409_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4391_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4379_lanes;
  const Lanes<2> f13_x_p4411_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p4391_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p4379_lanes;

  // link 2 (thigh), outward
  const Real a2_y = c2 * a2_y_p2 - s2 * a2_y_p1;
  const Real a2_x = c2 * a2_y_p1 + s2 * a2_y_p2;

  // link 4 (chest1), outward
  const Real a5_y_p1 = c4 * wd3_z;
  const Real a5_y_p2 = w4_x * w4_x;
  const Real a5_y_p3 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (chest1), outward
  const Real wd4_x_p1 = s4 * wd3_z;

  // link 3 (hip), outward
  const Real a3_x_p2 = a2_y + 0.422 * a3_x_p1;
  const Real a3_x_p3 = a2_x + 0.422 * wd2_z;

  // link 4 (chest1), outward
  const Real wd4_x_p2 = w4_y * qd[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4421_lanes = f13_x_p4321_lanes - f13_x_p4332_lanes * f13_x_p4281_lanes[1] -
      f13_x_p4395_lanes * f13_x_p4357_lanes[1];

  // link 5 (chest2), outward
  const Real w5_x = c5 * w4_x - s5 * qd[3];

  // link 4 (chest1), outward
  const Real wd4_x = wd4_x_p1 + wd4_x_p2;

  // link 5 (chest2), outward
  const Real a6_x_p1 = w5_z * w5_z;
  const Real a6_x_p2 = w5_x * w5_x;

  // link 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4424_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4393_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p4409_lanes;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4426_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4409_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p4393_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4428 = 1.0 / f13_x_p4421_lanes[1];

  // link 3 (hip), outward
  const Real a3_x = c3 * a3_x_p3 + s3 * a3_x_p2;
  const Real a3_y = c3 * a3_x_p2 - s3 * a3_x_p3;

  // link 6 (chest3), outward
  const Real a7_y_p1 = w6_z * w6_z;

  // link 4 (chest1), outward
  const Real wd4_y_p1 = w4_x * qd[3];
  const Real a4_x = c4 * a3_x;

  // link 5 (chest2), outward
  const Real a5_y_p4 = a3_y + 0.21799999999999997 * (a5_y_p2 + a5_y_p3);

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p2 + a6_x_p1;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;

  // link 5 (chest2), outward
  const Real a6_z_p1 = w5_x * minus_w5_y;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4433_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4424_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4411_lanes;

  // link 6 (chest3), outward
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;

  // link 4 (chest1), outward
  const Real wd4_y = a5_y_p1 - wd4_y_p1;

  // link 5 (chest2), outward
  const Real a5_y_p5 = a4_x + 0.21799999999999997 * a5_y_p1;
  const Real wd5_x = c5 * wd4_x - s5 * qdd_0[3] - minus_w5_y * qd[4];
  const Real minus_a5_z = minus_a4_y + 0.21799999999999997 * wd4_x_p1;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4439_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4424_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4411_lanes;

  // link 5 (chest2), outward
  const Real wd5_z = wd4_y + qdd_0[4];
  const Real a6_x_p4 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real wd6_z = wd5_x + qdd_0[5];
  const Real a7_y_p2 = w6_x * w6_y;
  const Real a7_y_p3 = w6_y * w6_z;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + c5 * qdd_0[3] + w5_x * qd[4];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4443_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4433_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4426_lanes;

  // link 5 (chest2), outward
  const Real a6_z_p2 = a6_z_p1 + wd5_z;
  const Real a5_y = c5 * a5_y_p4 - s5 * a5_y_p5;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p4 = w6_y * w6_y + a7_y_p1;

  // link 6 (chest3), outward
  const Real minus_a7_z_p1 = w6_x * w6_x;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a5_y_p5 + s5 * a5_y_p4;

  // link 6 (chest3), outward
  const Real a7_y_p5 = a7_y_p2 - wd6_z;
  const Real a6_x_p5 = a5_y + 0.072 * a6_x_p3;
  const Real a6_x_p6 = minus_a5_z + 0.072 * a6_x_p4;
  const Real minus_a7_z_p2 = a7_y_p2 + wd6_z;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p3 = minus_a7_z_p1 + a7_y_p1;
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;

  // link 6 (chest3), outward
  const Real a6_z = a5_x + 0.072 * a6_z_p2;
  const Real wd6_x = s6 * wd5_z - c6 * minus_wd5_y + w6_y * qd[5];
  const Real wd6_y = s6 * minus_wd5_y + c6 * wd5_z - w6_x * qd[5];

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4453_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4443_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4439_lanes;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a6_x_p5 - s6 * a6_x_p6;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4455_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4426_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4433_lanes;

  // link 6 (chest3), outward
  const Real a7_y_p7 = w6_x * w6_z - wd6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_z_lanes = wd6_y + detail::make_pack<Real>(qdd_0[6], qdd_0[13]);

  // link 6 (chest3), outward
  const Real a7_y_p8 = a7_y_p3 + wd6_x;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p9 = a6_x + 0.226 * a7_y_p4;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p5 + c6 * a6_x_p6;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4463_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4439_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4443_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p11_lanes = a7_y_p9 + detail::make_pack<Real>(0.18, (-0.18)) * a7_y_p5;

  // link 14 (right_shoulder1), outward
  const Real minus_a7_z_p5 = minus_a6_y + 0.226 * minus_a7_z_p2;

  // link 1 (calf), force propagation
  const Real f13_x_p4465 = f13_x_p4421_lanes[2] * f13_x_p4428;
  const Real f13_x_p4466 = f13_x_p4390 - f13_x_p4160_lanes[2] * f13_x_p4063_lanes[2] -
      f13_x_p4245_lanes[2] * f13_x_p4203_lanes[2] - f13_x_p4332_lanes[2] * f13_x_p4281_lanes[2] -
      f13_x_p4395_lanes[2] * f13_x_p4357_lanes[2];
  const Real f13_x_p4467 = f13_x_p4421_lanes[3] * f13_x_p4428;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_y_lanes = detail::make_pack<Real>(c7, c14) * wd6_x -
      detail::make_pack<Real>(s7, s14) * wd6_z - w7_x_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);

  // link 14 (right_shoulder1), outward
  const Real a7_y_p12 = a6_z - 0.226 * a7_y_p7;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_x_lanes = detail::make_pack<Real>(s7, s14) * wd6_x +
      detail::make_pack<Real>(c7, c14) * wd6_z + w7_y_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p5 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p3;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4468_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4455_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4453_lanes;

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
  const Lanes<2> a10_x_p2_lanes = w9_x_lanes * w9_x_lanes;
  const Lanes<2> a10_x_p3_lanes = w9_y_lanes * w9_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_y_lanes = detail::make_pack<Real>(c8, c15) * wd7_z_lanes -
      detail::make_pack<Real>(s8, s15) * wd7_y_lanes - w8_x_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p11_lanes -
      detail::make_pack<Real>(s7, s14) * a7_y_p14_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_lanes = detail::make_pack<Real>(c8, c15) * wd7_y_lanes +
      detail::make_pack<Real>(s8, s15) * wd7_z_lanes + w8_y_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p11_lanes +
      detail::make_pack<Real>(c7, c14) * a7_y_p14_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a10_z_p1_lanes = w9_y_lanes * w9_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4474 = f13_x_p4381 - f13_x_p4245_lanes[3] * f13_x_p4203_lanes[2] -
      f13_x_p4332_lanes[3] * f13_x_p4281_lanes[2] - f13_x_p4395_lanes[3] * f13_x_p4357_lanes[2] -
      f13_x_p4467 * f13_x_p4421_lanes[2];

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> wd9_z_lanes = detail::make_pack<Real>(qdd_0[8], qdd_0[15]) - wd8_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_z_lanes = minus_w10_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);

  // link 1 (calf), force propagation
  const Real f13_x_p4477 = 1.0 / (f13_x_p4466 - f13_x_p4465 * f13_x_p4421_lanes[2]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_z_lanes;
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> wd9_x_lanes = detail::make_pack<Real>(s9, s16) * wd8_y_lanes +
      detail::make_pack<Real>(c9, c16) * wd8_z_lanes + w9_y_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> wd9_y_lanes = detail::make_pack<Real>(c9, c16) * wd8_y_lanes -
      detail::make_pack<Real>(s9, s16) * wd8_z_lanes - w9_x_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p6_lanes = 0.282 * (a10_x_p2_lanes + a10_x_p3_lanes) - a8_x_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a10_x_p7_lanes = a10_x_p1_lanes + wd9_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_z_lanes = wd9_y_lanes + detail::make_pack<Real>(qdd_0[9], qdd_0[16]);

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a10_z_p2_lanes = minus_a10_z_p1_lanes - wd9_x_lanes;
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a12_y_p1_lanes = w11_x_lanes * w11_z_lanes;
  const Lanes<2> minus_a12_y_p2_lanes = w11_x_lanes * w11_x_lanes;
  const Lanes<2> minus_a12_y_p3_lanes = w11_y_lanes * w11_y_lanes;
  const Lanes<2> minus_a12_z_p1_lanes = w11_y_lanes * w11_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_x_lanes = detail::make_pack<Real>(c10, c17) * wd9_x_lanes -
      detail::make_pack<Real>(s10, s17) * wd9_z_lanes - minus_w10_y_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> a10_x_p10_lanes = a9_x_lanes - 0.282 * a10_x_p7_lanes;
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * minus_a10_z_p2_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4490_lanes = c1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) - s1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);

  // link 1 (calf), force propagation
  const Real f13_x_p4494 = f13_x_p4474 * f13_x_p4477;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4495_lanes = s1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) + c1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);

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

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4509_lanes = c2 * f13_x_p4490_lanes - s2 * f13_x_p4495_lanes;
  const Lanes<2> f13_x_p4511_lanes = s2 * f13_x_p4490_lanes + c2 * f13_x_p4495_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_w12_y_lanes +
      detail::make_pack<Real>(c13, c20) * w12_z_lanes;
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_y_lanes = detail::make_pack<Real>(c11, c18) * wd10_z_lanes -
      detail::make_pack<Real>(s11, s18) * wd10_x_lanes - w11_x_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> wd11_x_lanes = detail::make_pack<Real>(c11, c18) * wd10_x_lanes +
      detail::make_pack<Real>(s11, s18) * wd10_z_lanes + w11_y_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p6_lanes = minus_a10_y_lanes + 0.269 *
      (minus_a12_y_p2_lanes + minus_a12_y_p3_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a12_y_p7_lanes = minus_a12_y_p1_lanes + wd11_y_lanes;
  const Lanes<2> minus_a12_z_p2_lanes = minus_a12_z_p1_lanes - wd11_x_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4521_lanes = w13_y_lanes * w13_y_lanes;
  const Lanes<2> f13_x_p4523_lanes = w13_z_lanes * w13_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4525_lanes = c3 * f13_x_p4509_lanes - s3 * f13_x_p4511_lanes;
  const Lanes<2> f13_x_p4527_lanes = s3 * f13_x_p4509_lanes + c3 * f13_x_p4511_lanes;
  const Lanes<2> f13_x_p4529_lanes = f13_x_p4521_lanes + f13_x_p4523_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p10_lanes = a11_x_lanes - 0.269 * minus_a12_y_p7_lanes;
  const Lanes<2> minus_a12_z_lanes = minus_a11_y_lanes + 0.269 * minus_a12_z_p2_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_x_lanes = detail::make_pack<Real>(s13, s20) * w12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_w12_y_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4545_lanes = c4 * f13_x_p4525_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> f13_x_p4547_lanes = c4 * detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]) - s4 *
      f13_x_p4525_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4549_lanes = w13_x_lanes * w13_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p10_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p6_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4561_lanes = w13_x_lanes * w13_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p10_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p6_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4563_lanes = s5 * f13_x_p4545_lanes + c5 * f13_x_p4527_lanes;
  const Lanes<2> f13_x_p4565_lanes = c5 * f13_x_p4545_lanes - s5 * f13_x_p4527_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4567_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4453_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4455_lanes - a12_x_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> minus_a13_x_lanes = detail::make_pack<Real>(c13, c20) * minus_a12_y_lanes +
      detail::make_pack<Real>(s13, s20) * minus_a12_z_lanes;
  const Lanes<2> a13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_a12_y_lanes -
      detail::make_pack<Real>(c13, c20) * minus_a12_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_z_lanes = wd11_y_lanes + detail::make_pack<Real>(qdd_0[11], qdd_0[18]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4577_lanes = s6 * f13_x_p4547_lanes - c6 * f13_x_p4563_lanes;
  const Lanes<2> f13_x_p4579_lanes = s6 * f13_x_p4563_lanes + c6 * f13_x_p4547_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4583_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4463_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p4468_lanes - a13_y_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4593_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4468_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p4463_lanes +
      (minus_a13_x_lanes + 0.086 * f13_x_p4529_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_wd10_y_lanes = detail::make_pack<Real>(s10, s17) * wd9_x_lanes +
      detail::make_pack<Real>(c10, c17) * wd9_z_lanes + w10_x_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4595_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4577_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4565_lanes;
  const Lanes<2> f13_x_p4597_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p4577_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p4565_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_z_lanes = minus_wd10_y_lanes + detail::make_pack<Real>(qdd_0[10], qdd_0[17]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4607_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4579_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p4595_lanes;
  const Lanes<2> f13_x_p4609_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p4595_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p4579_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_wd12_y_lanes = detail::make_pack<Real>(s12, s19) * wd11_x_lanes +
      detail::make_pack<Real>(c12, c19) * wd11_z_lanes + w12_x_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(c12, c19) * wd11_x_lanes -
      detail::make_pack<Real>(s12, s19) * wd11_z_lanes - minus_w12_y_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4619_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4607_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4597_lanes;
  const Lanes<2> f13_x_p4621_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4607_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4597_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_z_lanes = wd12_x_lanes + detail::make_pack<Real>(qdd_0[12], qdd_0[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4631_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4619_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4609_lanes;
  const Lanes<2> f13_x_p4633_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4609_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4619_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_x_lanes = detail::make_pack<Real>(s13, s20) * wd12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_wd12_y_lanes + w13_y_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> wd13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_wd12_y_lanes +
      detail::make_pack<Real>(c13, c20) * wd12_z_lanes - w13_x_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4643_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4631_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4621_lanes;
  const Lanes<2> f13_x_p4645_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4621_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4631_lanes;
  const Lanes<2> f13_x_p4655_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4643_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4633_lanes;
  const Lanes<2> f13_x_p4657_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4633_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4643_lanes;
  const Lanes<2> f13_x_p4665_lanes = f13_x_p4655_lanes - wd13_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4667_lanes = 0.086 * (f13_x_p4549_lanes + f13_x_p4655_lanes);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4669_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4645_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p4657_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4673 = f13_x_p4583_lanes[0] - f13_x_p3307_lanes[1] * f13_x_p4593_lanes[0] -
      f13_x_p4667_lanes[0];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4676_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p4657_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p4645_lanes - wd13_x_lanes;
  const Lanes<2> f13_x_p4678_lanes = f13_x_p4669_lanes - wd13_y_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4680_lanes = 0.086 * (f13_x_p4669_lanes - f13_x_p4561_lanes);
  const Real f13_x_p4682 = f13_x_p4567_lanes[0] - f13_x_p3307_lanes[2] * f13_x_p4593_lanes[0] -
      f13_x_p3526_lanes[2] * f13_x_p4673 + f13_x_p4680_lanes[0];
  const Real f13_x_p4683 = f13_x_p4676_lanes[0] - f13_x_p3307_lanes[3] * f13_x_p4593_lanes[0] -
      f13_x_p3526_lanes[3] * f13_x_p4673 - f13_x_p3694_lanes[3] * f13_x_p4682;
  const Real f13_x_p4684 = f13_x_p4678_lanes[0] - f13_x_p3307_lanes[4] * f13_x_p4593_lanes[0] -
      f13_x_p3526_lanes[4] * f13_x_p4673 - f13_x_p3694_lanes[4] * f13_x_p4682 -
      f13_x_p3853_lanes[4] * f13_x_p4683;
  const Real f13_x_p4685 = f13_x_p4665_lanes[0] - f13_x_p3307_lanes[5] * f13_x_p4593_lanes[0] -
      f13_x_p3526_lanes[5] * f13_x_p4673 - f13_x_p3694_lanes[5] * f13_x_p4682 -
      f13_x_p3853_lanes[5] * f13_x_p4683;
  const Real f13_x_p4686 = f13_x_p4593_lanes[1] - f13_x_p3307_lanes[6] * f13_x_p4593_lanes[0] -
      f13_x_p3526_lanes[6] * f13_x_p4673 - f13_x_p3694_lanes[6] * f13_x_p4682 -
      f13_x_p3853_lanes[6] * f13_x_p4683;
  const Real f13_x_p4687 = f13_x_p4583_lanes[1] - f13_x_p3307_lanes[7] * f13_x_p4593_lanes[0] -
      f13_x_p3526_lanes[7] * f13_x_p4673 - f13_x_p3694_lanes[7] * f13_x_p4682 -
      f13_x_p3853_lanes[7] * f13_x_p4683;
  const Real f13_x_p4688 = f13_x_p4567_lanes[1] - f13_x_p3314_lanes[0] * f13_x_p4593_lanes[0] -
      f13_x_p3534_lanes[0] * f13_x_p4673 - f13_x_p3702_lanes[0] * f13_x_p4682 -
      f13_x_p3857_lanes[0] * f13_x_p4683;
  const Real f13_x_p4689 = f13_x_p4676_lanes[1] - f13_x_p3314_lanes[1] * f13_x_p4593_lanes[0] -
      f13_x_p3534_lanes[1] * f13_x_p4673 - f13_x_p3702_lanes[1] * f13_x_p4682 -
      f13_x_p3857_lanes[1] * f13_x_p4683;
  const Real f13_x_p4690 = f13_x_p4685 - f13_x_p4000_lanes[5] * f13_x_p4684;
  const Real f13_x_p4691 = f13_x_p4678_lanes[1] - f13_x_p3314_lanes[2] * f13_x_p4593_lanes[0] -
      f13_x_p3534_lanes[2] * f13_x_p4673 - f13_x_p3702_lanes[2] * f13_x_p4682 -
      f13_x_p3857_lanes[2] * f13_x_p4683;
  const Real f13_x_p4692 = f13_x_p4686 - f13_x_p4000_lanes[6] * f13_x_p4684 - f13_x_p4158 *
      f13_x_p4690;
  const Real f13_x_p4693 = f13_x_p4665_lanes[1] - f13_x_p3314_lanes[3] * f13_x_p4593_lanes[0] -
      f13_x_p3534_lanes[3] * f13_x_p4673 - f13_x_p3702_lanes[3] * f13_x_p4682 -
      f13_x_p3857_lanes[3] * f13_x_p4683;

  // link 3 (hip), force propagation
  const Real f13_x_p4694 = f13_x_p3666_lanes[1] + f13_x_p2099_lanes[3] * f13_x_p624_lanes[3] +
      f13_x_p2095_lanes[3] * f13_x_p720_lanes[3] + f13_x_p2051_lanes[3] * f13_x_p829_lanes[3] +
      f13_x_p2039_lanes[3] * f13_x_p932_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p4695 = f13_x_p4687 - f13_x_p4000_lanes[7] * f13_x_p4684 - f13_x_p4159 *
      f13_x_p4690 - f13_x_p4244 * f13_x_p4692 - f13_x_p4667_lanes[1];
  const Real f13_x_p4696 = f13_x_p4694 + f13_x_p2035_lanes[3] * f13_x_p1034_lanes[3] +
      f13_x_p1599_lanes[3] * f13_x_p1555_lanes[3] - f13_x_p3314_lanes[3] * f13_x_p3192_lanes[3] -
      f13_x_p3534_lanes[3] * f13_x_p3461_lanes[3];
  const Real f13_x_p4697 = f13_x_p4688 - f13_x_p4003_lanes[0] * f13_x_p4684 - f13_x_p4160_lanes[0] *
      f13_x_p4690 - f13_x_p4245_lanes[0] * f13_x_p4692 - f13_x_p4332_lanes[0] * f13_x_p4695;
  const Real f13_x_p4698 = f13_x_p4689 - f13_x_p4003_lanes[1] * f13_x_p4684 - f13_x_p4160_lanes[1] *
      f13_x_p4690 - f13_x_p4245_lanes[1] * f13_x_p4692 - f13_x_p4332_lanes[1] * f13_x_p4695;
  const Real f13_x_p4699 = f13_x_p4691 - f13_x_p4003_lanes[2] * f13_x_p4684 - f13_x_p4160_lanes[2] *
      f13_x_p4690 - f13_x_p4245_lanes[2] * f13_x_p4692 - f13_x_p4332_lanes[2] * f13_x_p4695;
  const Real f13_x_p4700 = f13_x_p4693 - f13_x_p4003_lanes[3] * f13_x_p4684 - f13_x_p4160_lanes[3] *
      f13_x_p4690 - f13_x_p4245_lanes[3] * f13_x_p4692 - f13_x_p4332_lanes[3] * f13_x_p4695;
  const Real f13_x_p4701 = f13_x_p4697 + f13_x_p4680_lanes[1];
  const Real f13_x_p4702 = f13_x_p4698 - f13_x_p4395_lanes[1] * f13_x_p4701;
  const Real f13_x_p4703 = f13_x_p4696 - f13_x_p3702_lanes[3] * f13_x_p3633_lanes[3] -
      f13_x_p3857_lanes[3] * f13_x_p3757_lanes[3] - f13_x_p4003_lanes[3] * f13_x_p3906_lanes[3] -
      f13_x_p4160_lanes[3] * f13_x_p4063_lanes[3];
  const Real f13_x_p4704 = f13_x_p4699 - f13_x_p4395_lanes[2] * f13_x_p4701 - f13_x_p4465 *
      f13_x_p4702;
  const Real f13_x_p4705 = f13_x_p4703 - f13_x_p4245_lanes[3] * f13_x_p4203_lanes[3] -
      f13_x_p4332_lanes[3] * f13_x_p4281_lanes[3] - f13_x_p4395_lanes[3] * f13_x_p4357_lanes[3] -
      f13_x_p4467 * f13_x_p4421_lanes[3];
  const Real f13_x_p4706 = (f13_x_p4700 - f13_x_p4395_lanes[3] * f13_x_p4701 - f13_x_p4467 *
      f13_x_p4702 - f13_x_p4494 * f13_x_p4704) * (1.0 / (f13_x_p4705 - f13_x_p4494 * f13_x_p4474));
  const Real f13_x_p4707 = f13_x_p4704 * f13_x_p4477 - f13_x_p4494 * f13_x_p4706;
  const Real f13_x_p4708 = f13_x_p4702 * f13_x_p4428 - f13_x_p4465 * f13_x_p4707 - f13_x_p4467 *
      f13_x_p4706;
  const Real f13_x_p4709 = f13_x_p4701 * f13_x_p4368 - f13_x_p4395_lanes[1] * f13_x_p4708 -
      f13_x_p4395_lanes[2] * f13_x_p4707 - f13_x_p4395_lanes[3] * f13_x_p4706;
  const Real f13_x_p4710 = f13_x_p4695 * f13_x_p4294 - f13_x_p4332_lanes[0] * f13_x_p4709 -
      f13_x_p4332_lanes[1] * f13_x_p4708 - f13_x_p4332_lanes[2] * f13_x_p4707 -
      f13_x_p4332_lanes[3] * f13_x_p4706;
  const Real f13_x_p4711 = f13_x_p4692 * f13_x_p4214 - f13_x_p4244 * f13_x_p4710 -
      f13_x_p4245_lanes[0] * f13_x_p4709 - f13_x_p4245_lanes[1] * f13_x_p4708 -
      f13_x_p4245_lanes[2] * f13_x_p4707;
  const Real f13_x_p4712 = f13_x_p4711 - f13_x_p4245_lanes[3] * f13_x_p4706;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4713_lanes = f13_x_p4549_lanes - wd13_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4716 = f13_x_p4690 * f13_x_p4085 - f13_x_p4158 * f13_x_p4712 - f13_x_p4159 *
      f13_x_p4710 - f13_x_p4160_lanes[0] * f13_x_p4709 - f13_x_p4160_lanes[1] * f13_x_p4708;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_x_p4717_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      f13_x_p4713_lanes - 0.01626499875 * f13_x_p4529_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_y_p1_lanes = f13_x_p4549_lanes + wd13_z_lanes;
  const Lanes<2> f13_y_p2_lanes = w13_x_lanes * w13_x_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4718 = f13_x_p4716 - f13_x_p4160_lanes[2] * f13_x_p4707 - f13_x_p4160_lanes[3] *
      f13_x_p4706;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_y_p1_lanes = w12_x_lanes * minus_w12_y_lanes;
  const Lanes<2> f12_y_p3_lanes = w12_z_lanes * w12_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_y_p6_lanes = 0.01626499875 * f13_y_p1_lanes -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      (f13_y_p2_lanes + f13_x_p4523_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p1_lanes = f13_x_p4561_lanes - wd13_y_lanes;
  const Lanes<2> f13_z_p2_lanes = w13_y_lanes * w13_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_x_p1_lanes = minus_w12_y_lanes * minus_w12_y_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p4_lanes = f13_z_p2_lanes + wd13_x_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4719 = f13_x_p4684 * f13_x_p3905 - f13_x_p4000_lanes[5] * f13_x_p4718 -
      f13_x_p4000_lanes[6] * f13_x_p4712 - f13_x_p4000_lanes[7] * f13_x_p4710 -
      f13_x_p4003_lanes[0] * f13_x_p4709;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_x_p2_lanes = f12_y_p1_lanes + wd12_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_y_p8_lanes = 0.0025100003499999995 * (wd12_z_lanes - f12_y_p1_lanes) -
      0.0006000000000000001 * (w12_x_lanes * w12_x_lanes + f12_y_p3_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_x_p1_lanes = w11_x_lanes * w11_y_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_p6_lanes = 0.01626499875 * f13_z_p1_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * f13_z_p4_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_x_p2_lanes = w11_z_lanes * w11_z_lanes;
  const Lanes<2> f11_x_p3_lanes = f11_x_p1_lanes - wd11_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_x_p6_lanes = 0.0025100003499999995 * (f12_x_p1_lanes + f12_y_p3_lanes) +
      0.0006000000000000001 * f12_x_p2_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4720 = f13_x_p4719 - f13_x_p4003_lanes[1] * f13_x_p4708 - f13_x_p4003_lanes[2] *
      f13_x_p4707 - f13_x_p4003_lanes[3] * f13_x_p4706;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_z_p1_lanes = w12_x_lanes * w12_z_lanes;
  const Lanes<2> f12_z_p3_lanes = f12_z_p1_lanes + minus_wd12_y_lanes;
  const Lanes<2> f12_z_p4_lanes = wd12_x_lanes - minus_w12_y_lanes * w12_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_y_p1_lanes = f11_x_p1_lanes + wd11_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_x_p7_lanes = detail::make_pack<Real>(0.001, (-0.001)) * f11_x_p3_lanes -
      6e-04 * (minus_a12_y_p3_lanes + f11_x_p2_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p1_lanes = w10_x_lanes * w10_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_z_p7_lanes = 0.0025100003499999995 * f12_z_p3_lanes + 0.0006000000000000001 *
      f12_z_p4_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p2_lanes = minus_w10_y_lanes * w10_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4721 = f13_x_p4683 * f13_x_p3765 - f13_x_p3853_lanes[4] * f13_x_p4720 -
      f13_x_p3853_lanes[5] * f13_x_p4718 - f13_x_p3853_lanes[6] * f13_x_p4712 -
      f13_x_p3853_lanes[7] * f13_x_p4710;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p3_lanes = f10_z_p1_lanes + minus_wd10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_y_p5_lanes = 6e-04 * f11_y_p1_lanes -
      detail::make_pack<Real>(0.001, (-0.001)) * (minus_a12_y_p2_lanes + f11_x_p2_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p4_lanes = wd10_x_lanes - f10_z_p2_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p7_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * (f13_x_p4523_lanes - f13_x_p4521_lanes);

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_z_p7_lanes = 0.0014999985000000002 * f10_z_p3_lanes + 0.28049749700000004 *
      f10_z_p4_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4722 = f13_x_p4721 - f13_x_p3857_lanes[0] * f13_x_p4709 - f13_x_p3857_lanes[1] *
      f13_x_p4708 - f13_x_p3857_lanes[2] * f13_x_p4707 - f13_x_p3857_lanes[3] * f13_x_p4706;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p9_lanes = 9.149209276993575e-05 * f13_z_p4_lanes +
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p1_lanes -
      0.000108260010923775 * f13_y_p1_lanes + n13_x_p7_lanes;
  const Lanes<2> n13_y_p7_lanes = 0.000108260010923775 * (f13_y_p2_lanes - f13_x_p4523_lanes);
  const Lanes<2> n13_x_p10_lanes = n13_x_p9_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * a12_x_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n13_x = n13_x_p10_lanes[0] + f13_x_p4722;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_y_p9_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * f13_x_p4713_lanes - 0.000847139515629375 * f13_z_p1_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p4_lanes +
      n13_y_p7_lanes;
  const Lanes<2> n13_y_p10_lanes = n13_y_p9_lanes - 0.01626499875 * a12_x_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_y_p5_lanes = 0.0025100003499999995 * minus_a12_z_lanes -
      (0.000195227662257343 * f12_z_p3_lanes + detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * f12_x_p2_lanes);

  // link 24 (right_eye), inertial wrench
  const Real n13_y = n13_y_p10_lanes[0] + f13_x_p4720;

  // link 1 (calf), force propagation
  const Real f13_x_p4723 = f13_x_p4682 * f13_x_p3661 - f13_x_p3694_lanes[3] * f13_x_p4722 -
      f13_x_p3694_lanes[4] * f13_x_p4720 - f13_x_p3694_lanes[5] * f13_x_p4718 -
      f13_x_p3694_lanes[6] * f13_x_p4712;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p13_lanes = 0.0007556474228594393 * f13_x_p4549_lanes +
      0.0009386316083993107 * wd13_z_lanes + 0.000108260010923775 * (f13_z_p2_lanes - wd13_x_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p2_lanes = minus_a12_z_p1_lanes + wd11_x_lanes;
  const Lanes<2> n11_x_p3_lanes = minus_a12_y_p1_lanes - wd11_y_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p15_lanes = n13_z_p13_lanes -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      (f13_x_p4561_lanes + wd13_y_lanes) + detail::make_pack<Real>((-0.0001263900573325125),
      0.0001263900573325125) * (f13_x_p4521_lanes - f13_y_p2_lanes);

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_x_p6_lanes = 1.16e-05 * f12_z_p4_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (f12_y_p3_lanes - f12_x_p1_lanes) - 0.0006000000000000001 * minus_a12_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p8_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (f11_x_p2_lanes - minus_a12_y_p3_lanes);

  // link 13 (left_hand), inward
  const Real n12_y = n12_y_p5_lanes[0] + (c13 * n13_x - s13 * n13_y);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p16_lanes = n13_z_p15_lanes +
      (0.01626499875 * a13_y_lanes + detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      minus_a13_x_lanes);

  // link 1 (calf), force propagation
  const Real f13_x_p4724 = f13_x_p4723 - f13_x_p3694_lanes[7] * f13_x_p4710 - f13_x_p3702_lanes[0] *
      f13_x_p4709 - f13_x_p3702_lanes[1] * f13_x_p4708 - f13_x_p3702_lanes[2] * f13_x_p4707;

  // link 24 (right_eye), inertial wrench
  const Real n13_z = n13_z_p16_lanes[0] + f13_x_p4718;
  tau[12] = n13_z;

  // link 1 (calf), force propagation
  const Real f13_x_p4725 = f13_x_p4724 - f13_x_p3702_lanes[3] * f13_x_p4706;

  // link 13 (left_hand), inward
  const Real n12_x = n12_x_p6_lanes[0] + n13_z;

  // link 24 (right_eye), inertial wrench
  const Real f13_z = f13_z_p6_lanes[0] + f13_x_p4725;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p9_lanes = 0.00020682766225734302 * wd12_z_lanes - 0.000183627662257343 *
      f12_y_p1_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (f12_z_p1_lanes - minus_wd12_y_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p2_lanes = w10_x_lanes * minus_w10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p7_lanes = 0.000144 * (minus_a12_y_p2_lanes - f11_x_p2_lanes);
  const Lanes<2> n11_x_p11_lanes = 0.0001194 * n11_x_p2_lanes +
      detail::make_pack<Real>(6e-06, (-6e-06)) * n11_x_p3_lanes + 0.000144 * f11_y_p1_lanes +
      n11_x_p8_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p4_lanes = w10_z_lanes * w10_z_lanes;

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - f12_x_p6_lanes[0];

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p5_lanes = minus_w10_y_lanes * minus_w10_y_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p10_lanes = n12_z_p9_lanes -
      (0.0025100003499999995 * minus_a12_y_lanes + 0.0006000000000000001 * a12_x_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p7_lanes = wd10_z_lanes - n10_x_p2_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p12_lanes = n11_x_p11_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_y_lanes;
  const Lanes<2> n11_y_p9_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      f11_x_p3_lanes - 0.0001098 * n11_x_p3_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) *
      n11_x_p2_lanes - n11_y_p7_lanes;
  const Lanes<2> n11_z_p6_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      minus_a12_y_p7_lanes;

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p10_lanes[0] + (s13 * n13_x + c13 * n13_y);
  tau[11] = n12_z;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p2_lanes = n10_x_p2_lanes + wd10_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p10_lanes = n11_y_p9_lanes - 6e-04 * minus_a10_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p4_lanes = w10_x_lanes * w10_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p11_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * (n10_x_p4_lanes - n10_x_p5_lanes);

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p10_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4726 = f13_x_p4673 * f13_x_p3437 - f13_x_p3526_lanes[2] * f13_x_p4725 -
      f13_x_p3526_lanes[3] * f13_x_p4722 - f13_x_p3526_lanes[4] * f13_x_p4720 -
      f13_x_p3526_lanes[5] * f13_x_p4718;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p1_lanes = minus_a10_z_p1_lanes + wd9_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p13_lanes = 0.06060754126741261 * f10_z_p4_lanes + 0.0001499998887063 *
      f10_z_p3_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      n10_x_p7_lanes + n10_x_p11_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p2_lanes = a10_x_p1_lanes - wd9_y_lanes;
  const Lanes<2> n9_x_p3_lanes = w9_x_lanes * w9_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p12_lanes = 0.0002292 * wd11_z_lanes - 9.600000000000003e-06 *
      f11_x_p1_lanes - 0.000144 * minus_a12_z_p2_lanes - n11_z_p6_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p5_lanes = w9_z_lanes * w9_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p14_lanes = n10_x_p13_lanes - 0.28049749700000004 * minus_a10_z_lanes;
  const Lanes<2> n10_y_p10_lanes = 0.00028099984685315 * f10_z_p3_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * n10_y_p2_lanes +
      0.0001499998887063 * f10_z_p4_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p8_lanes = n9_x_p3_lanes + wd9_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p14_lanes = n11_z_p12_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (minus_a12_y_p3_lanes - minus_a12_y_p2_lanes) - n11_z_p10_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p12_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (n9_x_p5_lanes - a10_x_p3_lanes);

  // link 1 (calf), force propagation
  const Real f13_x_p4727 = f13_x_p4726 - f13_x_p3526_lanes[6] * f13_x_p4712 - f13_x_p3526_lanes[7] *
      f13_x_p4710 - f13_x_p3534_lanes[0] * f13_x_p4709 - f13_x_p3534_lanes[1] * f13_x_p4708;

  // link 12 (left_wrist2), inward
  const Real n11_z = n11_z_p14_lanes[0] - (s12 * n12_x + c12 * n12_y);
  tau[10] = n11_z;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p12_lanes = detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * (n10_y_p4_lanes - n10_x_p4_lanes) - n10_y_p10_lanes +
      0.0014999985000000002 * minus_a10_z_lanes;
  const Lanes<2> n10_z_p13_lanes = 0.06032654142055946 * n10_x_p2_lanes + 0.060888541114265754 *
      wd10_z_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (f10_z_p2_lanes + wd10_x_lanes);

  // link 11 (left_wrist1), inward
  const Real n10_y = n10_y_p12_lanes[0] - n11_z;

  // link 1 (calf), force propagation
  const Real f13_x_p4728 = f13_x_p4727 - f13_x_p3534_lanes[2] * f13_x_p4707 - f13_x_p3534_lanes[3] *
      f13_x_p4706;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p14_lanes = 0.0019585440854647937 * n9_x_p1_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p2_lanes -
      0.0005895000784280001 * n9_x_p8_lanes + n9_x_p12_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_y = f13_y_p6_lanes[0] + f13_x_p4728;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_x_p4_lanes = 0.0014999985000000002 * (n10_x_p5_lanes + n10_x_p4_lanes) +
      0.28049749700000004 * n10_y_p2_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p15_lanes = n9_x_p14_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_x_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_z_p3_lanes = 6e-04 * n11_x_p3_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * n11_x_p2_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_y_p1_lanes = n9_x_p3_lanes - wd9_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p15_lanes = n10_z_p13_lanes -
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (f10_z_p1_lanes - minus_wd10_y_lanes) + 0.0001499998887063 *
      (n10_x_p5_lanes - n10_y_p4_lanes);
  const Lanes<2> n10_z_p16_lanes = n10_z_p15_lanes -
      (0.0014999985000000002 * minus_a10_y_lanes + 0.28049749700000004 * a10_x_lanes);
  const Lanes<2> f10_y_p4_lanes = 0.0014999985000000002 * n10_x_p7_lanes - 0.28049749700000004 *
      (n10_y_p4_lanes + n10_x_p4_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p7_lanes = 0.0005895000784280001 * (a10_x_p2_lanes - n9_x_p5_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p3_lanes = w8_x_lanes * w8_y_lanes;
  const Lanes<2> n8_z_p6_lanes = w8_y_lanes * w8_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4729 = f13_x_p4593_lanes[0] * f13_x_p3256 - f13_x_p3307_lanes[1] * f13_x_p4728 -
      f13_x_p3307_lanes[2] * f13_x_p4725 - f13_x_p3307_lanes[3] * f13_x_p4722 -
      f13_x_p3307_lanes[4] * f13_x_p4720;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p8_lanes = w8_x_lanes * w8_z_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p10_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * n9_y_p1_lanes - 0.0008177492704690715 * n9_x_p2_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p1_lanes +
      n9_y_p7_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p10_lanes = w8_y_lanes * w8_y_lanes;
  const Lanes<2> n8_z_p11_lanes = w8_x_lanes * w8_x_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p11_lanes = n9_y_p10_lanes - 0.0022500062 * a8_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p1_lanes = w7_y_lanes * w7_z_lanes;
  const Lanes<2> n7_x_p2_lanes = w7_x_lanes * w7_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p17_lanes = 0.18101044219699997 * n8_z_p3_lanes + 0.18125194219699997 *
      wd8_z_lanes + 0.00010499999999999999 * (n8_z_p6_lanes - wd8_x_lanes);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p3_lanes = n7_x_p1_lanes + wd7_x_lanes;
  const Lanes<2> n7_x_p4_lanes = w7_x_lanes * w7_y_lanes;
  const Lanes<2> n7_x_p5_lanes = n7_x_p2_lanes - wd7_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4730 = f13_x_p4729 - f13_x_p3307_lanes[5] * f13_x_p4718 - f13_x_p3307_lanes[6] *
      f13_x_p4712 - f13_x_p3307_lanes[7] * f13_x_p4710 - f13_x_p3314_lanes[0] * f13_x_p4709;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p6_lanes = w7_y_lanes * w7_y_lanes;
  const Lanes<2> n7_x_p7_lanes = w7_z_lanes * w7_z_lanes;
  const Lanes<2> n7_x_p10_lanes = n7_x_p4_lanes + wd7_z_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p11_lanes = 0.0017499999999999998 * minus_a7_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p20_lanes = n8_z_p17_lanes - detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_z_p8_lanes + wd8_y_lanes) + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (n8_z_p10_lanes - n8_z_p11_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p1_lanes = n8_z_p3_lanes - wd8_z_lanes;
  const Lanes<2> n8_y_p2_lanes = n8_z_p8_lanes - wd8_y_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p15_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p7_lanes - n7_x_p6_lanes);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p21_lanes = n8_z_p20_lanes - (0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p3_lanes = n8_z_p6_lanes + wd8_x_lanes;
  const Lanes<2> n8_y_p5_lanes = w8_z_lanes * w8_z_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_x = f13_x_p4717_lanes[0] + (f13_x_p4730 - f13_x_p3314_lanes[1] * f13_x_p4708 -
      f13_x_p3314_lanes[2] * f13_x_p4707 - f13_x_p3314_lanes[3] * f13_x_p4706);

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p17_lanes = 0.0001505 * n7_x_p3_lanes + 8.75e-06 * n7_x_p5_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * n7_x_p10_lanes +
      n7_x_p15_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p11_lanes = 0.00010499999999999999 * (n8_z_p11_lanes - n8_y_p5_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p6_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * a10_x_p7_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p18_lanes = n7_x_p17_lanes + n7_x_p11_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p8_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_x_p3_lanes = n8_z_p3_lanes + wd8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p13_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n8_y_p1_lanes -
      0.18113119219699997 * n8_y_p2_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * n8_y_p3_lanes + n8_y_p11_lanes;

  // link 13 (left_hand), inward
  const Real f12_y = f12_y_p8_lanes[0] + (c13 * f13_x - s13 * f13_y);
  const Real f12_z = f12_z_p7_lanes[0] + (s13 * f13_x + c13 * f13_y);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p14_lanes = n8_y_p13_lanes - 0.7139200499999999 * a7_x_lanes;

  // link 12 (left_wrist2), inward
  const Real f11_y = f11_y_p5_lanes[0] + f12_z;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p12_lanes = 0.0027762933559338653 * wd9_z_lanes - 0.001140794814995722 *
      n9_x_p3_lanes + 0.0005895000784280001 * minus_a10_z_p2_lanes - n9_z_p6_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p8_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_y_p5_lanes - n8_z_p10_lanes);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p1_lanes = n7_x_p4_lanes - wd7_z_lanes;
  const Lanes<2> n7_y_p2_lanes = w7_x_lanes * w7_x_lanes;

  // link 12 (left_wrist2), inward
  const Real f11_x_p8 = s12 * f12_y - c12 * f12_x;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p10_lanes = 0.00012075 * n8_y_p3_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * n8_y_p2_lanes -
      0.00010499999999999999 * n8_x_p3_lanes + n8_x_p8_lanes;

  // link 12 (left_wrist2), inward
  const Real f11_x = f11_x_p7_lanes[0] - f11_x_p8;
  const Real f11_z = f11_z_p3_lanes[0] - (s12 * f12_x + c12 * f12_y);
  const Real n11_x = n11_x_p12_lanes[0] + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p14_lanes = n9_z_p12_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) *
      (a10_x_p3_lanes - a10_x_p2_lanes) + n9_z_p8_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p11_lanes = n8_x_p10_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p8_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_y_p2_lanes - n7_x_p7_lanes);

  // link 11 (left_wrist1), inward
  const Real f10_y = f10_y_p4_lanes[0] - f11_z;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_x_p4_lanes = 0.0022500062 * (a10_x_p3_lanes + n9_x_p5_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * n9_y_p1_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f7_x_p4_lanes = 0.7139200499999999 * n8_y_p2_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * n8_y_p3_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_y = n11_y_p10_lanes[0] + (n12_z + 0.269 * f11_x_p8);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_y_p4_lanes = 0.0022500062 * n9_x_p8_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (a10_x_p2_lanes + n9_x_p5_lanes);

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_p6_lanes = 0.0017499999999999998 *
      (n7_x_p6_lanes + n7_x_p7_lanes + n7_y_p1_lanes);

  // link 11 (left_wrist1), inward
  const Real f10_x = c11 * f11_x - s11 * f11_y - f10_x_p4_lanes[0];
  const Real f10_z = f10_z_p7_lanes[0] + (s11 * f11_x + c11 * f11_y);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_z_p3_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      n9_x_p1_lanes - 0.0022500062 * n9_x_p2_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f20_x = f13_x_p4717_lanes[1] + f13_x_p4712;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_y_p4_lanes = 0.7139200499999999 * n8_x_p3_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (n8_z_p11_lanes + n8_y_p5_lanes);

  // link 24 (right_eye), inertial wrench
  const Real f20_y = f13_y_p6_lanes[1] + f13_x_p4710;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p10_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * n7_y_p1_lanes - 0.0002975 * n7_x_p5_lanes - 8.75e-06 *
      n7_x_p3_lanes + n7_y_p8_lanes;

  // link 10 (left_lowerarm), inward
  const Real f9_y = f10_z - f9_y_p4_lanes[0];

  // link 24 (right_eye), inertial wrench
  const Real f20_z = f13_z_p6_lanes[1] + f13_x_p4709;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_x_p4_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p1_lanes - 0.7139200499999999 *
      (n8_z_p10_lanes + n8_y_p5_lanes);

  // link 20 (right_hand), inward
  const Real f19_x = f20_z - f12_x_p6_lanes[1];

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_p3_lanes = 0.0017499999999999998 *
      (n7_x_p10_lanes + (n7_y_p2_lanes + n7_x_p7_lanes));

  // link 10 (left_lowerarm), inward
  const Real f9_x_p5 = s10 * f10_y - c10 * f10_x;

  // link 11 (left_wrist1), inward
  const Real n10_x = n10_x_p14_lanes[0] + (c11 * n11_x - s11 * n11_y);

  // link 24 (right_eye), inertial wrench
  const Real n20_x = n13_x_p10_lanes[1] + f13_x_p4708;
  const Real n20_y = n13_y_p10_lanes[1] + f13_x_p4707;

  // link 11 (left_wrist1), inward
  const Real n10_z = n10_z_p16_lanes[0] + (s11 * n11_x + c11 * n11_y);
  tau[9] = n10_z;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p11_lanes = n7_y_p10_lanes + n7_x_p11_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n20_z = n13_z_p16_lanes[1] + f13_x_p4706;
  tau[19] = n20_z;

  // link 10 (left_lowerarm), inward
  const Real f9_x = f9_x_p4_lanes[0] - f9_x_p5;
  const Real f9_z = f9_z_p3_lanes[0] - (s10 * f10_x + c10 * f10_y);

  // link 20 (right_hand), inward
  const Real f19_y = f12_y_p8_lanes[1] + (c20 * f20_x - s20 * f20_y);
  const Real n19_x = n12_x_p6_lanes[1] + n20_z;
  const Real f19_z = f12_z_p7_lanes[1] + (s20 * f20_x + c20 * f20_y);

  // link 9 (left_upperarm), inward
  const Real f8_x = f8_x_p4_lanes[0] - f9_z;

  // link 19 (right_wrist2), inward
  const Real f18_y = f11_y_p5_lanes[1] + f19_z;

  // link 10 (left_lowerarm), inward
  const Real n9_y = n9_y_p11_lanes[0] + (n10_z + 0.282 * f9_x_p5);

  // link 20 (right_hand), inward
  const Real n19_y = n12_y_p5_lanes[1] + (c20 * n20_x - s20 * n20_y);
  const Real n19_z = n12_z_p10_lanes[1] + (s20 * n20_x + c20 * n20_y);
  tau[18] = n19_z;

  // link 19 (right_wrist2), inward
  const Real n18_y_p11 = s19 * f19_y - c19 * f19_x;

  // link 9 (left_upperarm), inward
  const Real f8_y = f8_y_p4_lanes[0] + (s9 * f9_x + c9 * f9_y);

  // link 10 (left_lowerarm), inward
  const Real n9_x = n9_x_p15_lanes[0] + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));
  const Real n9_z = n9_z_p14_lanes[0] - (s10 * n10_x + c10 * n10_y);
  tau[8] = n9_z;

  // link 19 (right_wrist2), inward
  const Real f18_x = f11_x_p7_lanes[1] - n18_y_p11;

  // link 8 (left_shoulder2), inward
  const Real f7_x = f7_x_p4_lanes[0] + c9 * f9_x - s9 * f9_y - f7_x_p6_lanes[0];

  // link 9 (left_upperarm), inward
  const Real n8_x = n8_x_p11_lanes[0] - n9_z;

  // link 19 (right_wrist2), inward
  const Real f18_z = f11_z_p3_lanes[1] - (s19 * f19_x + c19 * f19_y);
  const Real n18_z = n11_z_p14_lanes[1] - (s19 * n19_x + c19 * n19_y);
  tau[17] = n18_z;
  const Real n18_y = n11_y_p10_lanes[1] + (n19_z + 0.269 * n18_y_p11);

  // link 18 (right_wrist1), inward
  const Real f17_y = f10_y_p4_lanes[1] - f18_z;

  // link 8 (left_shoulder2), inward
  const Real f7_y = c8 * f8_x - s8 * f8_y + f7_y_p3_lanes[0];

  // link 9 (left_upperarm), inward
  const Real n8_y = n8_y_p14_lanes[0] + (s9 * n9_x + c9 * n9_y);

  // link 19 (right_wrist2), inward
  const Real n18_x = n11_x_p12_lanes[1] + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));

  // link 18 (right_wrist1), inward
  const Real n17_y = n10_y_p12_lanes[1] - n18_z;

  // link 9 (left_upperarm), inward
  const Real n8_z = n8_z_p21_lanes[0] + (c9 * n9_x - s9 * n9_y);
  tau[7] = n8_z;

  // link 18 (right_wrist1), inward
  const Real f17_x = c18 * f18_x - s18 * f18_y - f10_x_p4_lanes[1];
  const Real f17_z = f10_z_p7_lanes[1] + (s18 * f18_x + c18 * f18_y);

  // link 17 (right_lowerarm), inward
  const Real f16_y = f17_z - f9_y_p4_lanes[1];

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = c7 * f7_x - s7 * f7_y;

  // link 8 (left_shoulder2), inward
  const Real n7_x = n7_x_p18_lanes[0] + n8_z;

  // link 21 (neck), outward
  const Real wd21_z = qdd_0[20] - wd6_x;

  // link 17 (right_lowerarm), inward
  const Real n16_y_p12 = s17 * f17_y - c17 * f17_x;

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Real w21_z = qd[20] - w6_x;

  // link 18 (right_wrist1), inward
  const Real n17_x = n10_x_p14_lanes[1] + (c18 * n18_x - s18 * n18_y);
  const Real n17_z = n10_z_p16_lanes[1] + (s18 * n18_x + c18 * n18_y);
  tau[16] = n17_z;

  // link 8 (left_shoulder2), inward
  const Real n7_y = n7_y_p11_lanes[0] + (c8 * n8_x - s8 * n8_y);

  // link 17 (right_lowerarm), inward
  const Real f16_x = f9_x_p4_lanes[1] - n16_y_p12;

  // link 21 (neck), outward
  const Real w21_x = s21 * w6_y + c21 * w6_z;

  // link 22 (head), outward
  const Real w22_z = w21_y + qd[21];

  // link 17 (right_lowerarm), inward
  const Real f16_z = f9_z_p3_lanes[1] - (s17 * f17_x + c17 * f17_y);

  // link 21 (neck), outward
  const Real a22_z_p1 = w21_y * w21_z;
  const Real wd21_x = s21 * wd6_y + c21 * wd6_z + w21_y * qd[20];
  const Real a22_y_p1 = w21_x * w21_x;
  const Real a22_y_p2 = w21_y * w21_y;

  // link 16 (right_upperarm), inward
  const Real f15_x = f8_x_p4_lanes[1] - f16_z;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;

  // link 22 (head), outward
  const Real w22_x = c22 * w21_x - s22 * w21_z;

  // link 21 (neck), outward
  const Real a22_x_p1 = w21_x * w21_z;

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;

  // link 21 (neck), outward
  const Real a22_z_p2 = a22_z_p1 - wd21_x;

  // link 17 (right_lowerarm), inward
  const Real n16_y = n9_y_p11_lanes[1] + (n17_z + 0.282 * n16_y_p12);

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;

  // link 22 (head), outward
  const Real n22_x_p1 = w22_x * w22_z;
  const Real minus_a23_z_p1 = w22_x * minus_w22_y;

  // link 23 (left_eye), outward
  const Lanes<2> w23_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);

  // link 22 (head), outward
  const Real minus_a23_z_p2 = minus_w22_y * w22_z;

  // link 17 (right_lowerarm), inward
  const Real n16_x = n9_x_p15_lanes[1] + (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));

  // link 21 (neck), outward
  const Real wd21_y = c21 * wd6_y - s21 * wd6_z - w21_x * qd[20];

  // link 22 (head), outward
  const Real minus_wd22_y = s22 * wd21_x + c22 * wd21_z + w22_x * qd[21];

  // link 16 (right_upperarm), inward
  const Real f15_y = f8_y_p4_lanes[1] + (s16 * f16_x + c16 * f16_y);

  // link 22 (head), outward
  const Real a22_y_p3 = a6_x + 0.394 * (a22_y_p1 + a22_y_p2);
  const Real wd22_x = c22 * wd21_x - s22 * wd21_z - minus_w22_y * qd[21];

  // link 17 (right_lowerarm), inward
  const Real n16_z = n9_z_p14_lanes[1] - (s17 * n17_x + c17 * n17_y);
  tau[15] = n16_z;

  // link 22 (head), outward
  const Real a22_z = 0.394 * a22_z_p2 - minus_a21_y;

  // link 23 (left_eye), outward
  const Lanes<2> w23_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;
  const Lanes<2> n23_y_p2_lanes = w23_z_lanes * w23_z_lanes;

  // link 22 (head), outward
  const Real n22_x_p2 = n22_x_p1 + minus_wd22_y;
  const Real wd22_z = wd21_y + qdd_0[21];
  const Real minus_a23_z_p3 = minus_a23_z_p2 + wd22_x;

  // link 23 (left_eye), outward
  const Lanes<2> wd23_z_lanes = minus_wd22_y + detail::make_pack<Real>(qdd_0[22], qdd_0[23]);

  // link 22 (head), outward
  const Real n22_y_p1 = wd22_x - minus_a23_z_p2;

  // link 23 (left_eye), outward
  const Lanes<2> w23_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;

  // link 22 (head), outward
  const Real minus_a23_z_p4 = wd22_z - minus_a23_z_p1;
  const Real a23_y_p1 = minus_w22_y * minus_w22_y;
  const Real a23_y_p2 = w22_z * w22_z;
  const Real a22_x_p2 = a21_x + 0.394 * (a22_x_p1 + wd21_y);
  const Real a23_y_p3 = n22_x_p1 - minus_wd22_y;

  // link 23 (left_eye), outward
  const Lanes<2> f23_y_p1_lanes = w23_x_lanes * w23_y_lanes;
  const Lanes<2> n23_z_p1_lanes = w23_y_lanes * w23_z_lanes;

  // link 22 (head), outward
  const Real a23_y_p4 = w22_x * w22_x;

  // link 23 (left_eye), outward
  const Real a23_y_p5 = a23_y_p1 + a23_y_p2;
  const Lanes<2> wd23_x_lanes = detail::make_pack<Real>(c23, c24) * wd22_x +
      detail::make_pack<Real>(s23, s24) * wd22_z + w23_y_lanes *
      detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> f23_y_p2_lanes = f23_y_p1_lanes + wd23_z_lanes;
  const Lanes<2> n23_y_p10_lanes = (w23_z_lanes + detail::make_pack<Real>(qd[22], qd[23])) *
      w23_x_lanes - (detail::make_pack<Real>(c23, c24) * wd22_z -
      detail::make_pack<Real>(s23, s24) * wd22_x);
  const Real a23_y_p7 = a23_y_p4 + a23_y_p1;

  // link 24 (right_eye), outward
  const Real a23_y_p8 = a22_z + 0.095 * n22_x_p2;

  // link 22 (head), outward
  const Real a22_x = c22 * a22_x_p2 + s22 * a22_y_p3;
  const Real a22_y = c22 * a22_y_p3 - s22 * a22_x_p2;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> f23_y_lanes = 0.00025 * f23_y_p2_lanes;

  // link 24 (right_eye), outward
  const Real minus_a23_z_p6 = a22_y + 0.095 * minus_a23_z_p4;
  const Real a23_y_p10 = a22_x - 0.095 * a23_y_p5;

  // link 21 (neck), outward
  const Real n21_z_p1 = w21_x * w21_y;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> minus_f23_x_lanes = 0.00025 * (w23_y_lanes * w23_y_lanes + n23_y_p2_lanes);

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_z_lanes = minus_a23_z_p6 - detail::make_pack<Real>(0.032, (-0.032)) *
      minus_a23_z_p3;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_p7_lanes = 1.2499999999999999e-06 * f23_y_p1_lanes + 9.25e-06 *
      wd23_z_lanes + 2.8750000000000004e-05 * (n23_z_p1_lanes - wd23_x_lanes);

  // link 16 (right_upperarm), inward
  const Real n15_x = n8_x_p11_lanes[1] - n16_z;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_x_lanes = 4e-06 * (n23_z_p1_lanes + wd23_x_lanes) - 2.8750000000000004e-05 *
      f23_y_p2_lanes;

  // link 16 (right_upperarm), inward
  const Real n15_y = n8_y_p14_lanes[1] + (s16 * n16_x + c16 * n16_y);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_p13_lanes = 0.00025 * minus_a23_z_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_p14_lanes = detail::make_pack<Real>(s23, s24) *
      (a23_y_p10 + detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p3);

  // link 15 (right_shoulder2), inward
  const Real f14_y = c15 * f15_x - s15 * f15_y + f7_y_p3_lanes[1];

  // link 16 (right_upperarm), inward
  const Real n15_z = n8_z_p21_lanes[1] + (c16 * n16_x - s16 * n16_y);
  tau[14] = n15_z;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_lanes = 2.8750000000000004e-05 *
      (w23_x_lanes * w23_x_lanes - n23_y_p2_lanes) - 5.25e-06 * n23_y_p10_lanes + n23_y_p13_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_lanes = detail::make_pack<Real>(c23, c24) *
      (a23_y_p8 - detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p7) - a23_y_p14_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p10_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_y_lanes;
  const Lanes<2> n22_y_p12_lanes = detail::make_pack<Real>(c23, c24) * f23_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_x_lanes;

  // link 15 (right_shoulder2), inward
  const Real f14_x = f7_x_p4_lanes[1] + c16 * f16_x - s16 * f16_y - f7_x_p6_lanes[1];
  const Real n14_x = n7_x_p18_lanes[1] + n15_z;

  // link 23 (left_eye), inward
  const Real n22_y_p14 = n22_y_p12_lanes[1] + n22_y_p12_lanes[0];

  // link 21 (neck), outward
  const Real n21_x_p1 = n21_z_p1 + wd21_z;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p10_lanes = 0.00014700000000000002 * n7_x_p4_lanes + 0.00044800000000000005 *
      wd7_z_lanes + detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) *
      (n7_x_p1_lanes - wd7_x_lanes);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_lanes = n23_z_p7_lanes + 0.00025 * a23_y_lanes;
  tau[22] = n23_z_lanes[0];

  // link 24 (right_eye), inertial wrench
  tau[23] = n23_z_lanes[1];

  // link 23 (left_eye), inward
  const Real f22_z = 0.072575 * n22_x_p2 - 0.43200000000000005 * n22_y_p1 + n22_y_p14;
  const Lanes<2> n22_x_p11_lanes = detail::make_pack<Real>(c23, c24) * n23_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_y_lanes + detail::make_pack<Real>(8e-06, (-8e-06)) *
      n23_y_p10_lanes;
  const Lanes<2> n22_z_p1_lanes = detail::make_pack<Real>(s23, s24) * n23_x_lanes;
  const Lanes<2> n22_z_p3_lanes = detail::make_pack<Real>(c23, c24) * n23_y_lanes;
  const Real f22_y_p1 = n23_y_p10_lanes[1] + n23_y_p10_lanes[0];

  // link 15 (right_shoulder2), inward
  const Real n14_y = n7_y_p11_lanes[1] + (c15 * n15_x - s15 * n15_y);

  // link 23 (left_eye), inward
  const Real n22_y_p15 = 0.0074 * n22_y_p1 - 0.009438624999999999 * n22_x_p2 - 0.072575 * a22_z -
      n23_z_lanes[1] - (-0.032) * n22_y_p10_lanes[1];
  const Real n22_x = 0.05450270000000001 * n22_y_p1 - 0.0074 * n22_x_p2 - 0.43200000000000005 *
      a22_z + n22_x_p11_lanes[1] + n22_x_p11_lanes[0];

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p12_lanes = n7_z_p10_lanes - detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p2_lanes + wd7_y_lanes) + 8.75e-06 *
      (n7_x_p6_lanes - n7_y_p2_lanes);

  // link 21 (neck), outward
  const Real n21_y_p1 = w21_z * w21_z;
  const Real n21_y_p2 = a22_x_p1 - wd21_y;

  // link 14 (right_shoulder1), inward
  const Real n6_y_p1 = c14 * f14_x - s14 * f14_y;

  // link 23 (left_eye), inward
  const Real n22_z_p5 = 0.04506407500000001 * minus_a23_z_p1 + 0.06394132500000001 * wd22_z -
      0.0074 * (a23_y_p1 - a23_y_p4) + 0.072575 * a22_y;
  const Real f22_y = 0.072575 * minus_a23_z_p4 + 0.43200000000000005 * (a23_y_p4 + a23_y_p2) -
      0.00025 * f22_y_p1;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p2 = n6_y_p1 + n6_x_p1;

  // link 23 (left_eye), inward
  const Real n22_y = n22_y_p15 - n23_z_lanes[0] - 0.032 * n22_y_p10_lanes[0] - 0.095 * n22_y_p14;
  const Real f22_x = 0.43200000000000005 * (minus_a23_z_p1 + wd22_z) - 0.072575 * a23_y_p5 -
      n22_y_p10_lanes[1] - n22_y_p10_lanes[0];

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p14_lanes = 0.0017499999999999998 * (a7_y_lanes + a7_x_lanes);

  // link 14 (right_shoulder1), inward
  const Real n6_z_p1 = s14 * f14_x + c14 * f14_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p2 = s7 * f7_x + c7 * f7_y;

  // link 22 (head), inward
  const Real n21_y_p3 = s22 * f22_y - c22 * f22_x;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_z_p2_lanes = 0.0017499999999999998 * (n7_x_p5_lanes - n7_x_p3_lanes);

  // link 6 (chest3), inertial wrench
  const Real n6_z_p3 = 1.26882463592404 * a7_y_p2 + 2.06965463592404 * wd6_z - 0.0187369177636143 *
      (a7_y_p3 - wd6_x) + 6.1665928899999995 * minus_a6_y;

  // link 23 (left_eye), inward
  const Real n22_z = n22_z_p5 + 0.43200000000000005 * a22_x + n22_z_p1_lanes[1] +
      n22_z_p3_lanes[1] + n22_z_p1_lanes[0] + n22_z_p3_lanes[0] - 2.375e-05 * f22_y_p1;
  tau[21] = n22_z;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * (a22_z_p1 + wd21_x) - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 8 (left_shoulder2), inward
  const Real f7_z = s8 * f8_x + c8 * f8_y + f7_z_p2_lanes[0];

  // link 15 (right_shoulder2), inward
  const Real f14_z = s15 * f15_x + c15 * f15_y + f7_z_p2_lanes[1];

  // link 22 (head), inward
  const Real n21_z = 0.00621675 * wd21_z - 0.0048105000000000005 * n21_z_p1 + 0.0016155 * a22_z_p2 -
      0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;
  const Real f21_z = 0.0045000000000000005 * n21_y_p2 - (s22 * f22_x + c22 * f22_y);

  // link 15 (right_shoulder2), inward
  const Real n14_z = n7_z_p12_lanes[1] + s15 * n15_x + c15 * n15_y + n7_z_p14_lanes[1];
  tau[13] = n14_z;

  // link 7 (left_shoulder1), inward
  const Real f6_y_p1 = f14_z + f7_z;

  // link 22 (head), inward
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;
  const Real minus_f21_x = 0.0045000000000000005 * (a22_y_p2 + n21_y_p1) + n21_y_p3;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p3 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_y_p7 - 0.0187369177636143 *
      (minus_a7_z_p1 - a7_y_p1) + s21 * n21_x;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a22_y_p1 - n21_y_p1) - 0.000703125 * n21_y_p2 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p3);

  // link 8 (left_shoulder2), inward
  const Real n7_z = n7_z_p12_lanes[0] + s8 * n8_x + c8 * n8_y + n7_z_p14_lanes[0];
  tau[6] = n7_z;

  // link 5 (chest2), outward
  const Real f5_z_p1 = w5_x * w5_z + minus_wd5_y;

  // link 14 (right_shoulder1), inward
  const Real n6_x_p2 = 0.40041499999999997 * a7_y_p8 + 0.0187369177636143 * minus_a7_z_p2 - n21_z +
      (s14 * n14_x + c14 * n14_y + (-0.18) * n6_y_p1);

  // link 4 (chest1), outward
  const Real f4_y_p1 = w4_x * w4_y;

  // link 5 (chest2), outward
  const Real f5_x_p1 = minus_w5_y * minus_w5_y;

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a7_y_p4 - f21_z + n6_z_p1 + n6_z_p2;
  const Real n6_x = n6_x_p2 + (s7 * n7_x + c7 * n7_y + 0.18 * n6_x_p1);
  const Real f6_y = f6_y_p1 - 6.1665928899999995 * minus_a7_z_p2 - s21 * minus_f21_x + c21 * f21_y;

  // link 4 (chest1), outward
  const Real f4_y_p2 = f4_y_p1 + qdd_0[3];

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p2 - 6.1665928899999995 * a7_y_p7 - c21 * minus_f21_x - s21 * f21_y;

  // link 4 (chest1), outward
  const Real f4_x_p1 = qd[3] * qd[3];

  // link 7 (left_shoulder1), inward
  const Real n6_z_p4 = n6_z_p3 + c21 * n21_x - s21 * n21_y + c14 * n14_x - s14 * n14_y;
  const Real n6_y = n6_y_p3 + c21 * n21_y + n14_z + n7_z + 0.226 * n6_y_p2;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real f5_y = 0.069699984375 * (wd5_z - a6_z_p1) + 2.2194301519999997 * a6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_x = 2.2194301519999997 * a6_z_p2 - 0.069699984375 * (f5_x_p1 + a6_x_p1) + f6_z;
  const Real f5_z = 0.069699984375 * f5_z_p1 - 2.2194301519999997 * a6_x_p4 + n5_x_p1;

  // link 3 (hip), outward
  const Real f3_x_p1 = w3_z * w3_z;

  // link 4 (chest1), outward
  const Real minus_f4_z_p1 = wd4_y_p1 - wd4_y;

  // link 5 (chest2), inward
  const Real f4_y = f5_z - 0.0300000063 * f4_y_p2;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p5 = n6_z_p4 - (-0.18) * n6_z_p1 + c7 * n7_x - s7 * n7_y - 0.18 * n6_z_p2;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p4 - 0.04675382692737882 * f5_z_p1 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 5 (chest2), inward
  const Real f4_x_p2 = s5 * f5_y - c5 * f5_x;

  // link 7 (left_shoulder1), inward
  const Real n6_z = n6_z_p5 - 0.226 * f6_y_p1;
  tau[5] = n6_z;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p1 = 0.10961925816937637 * a6_z_p1 + 0.203126912024134 * wd5_z -
      0.005678398088837119 * (f5_x_p1 - a6_x_p2) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 5 (chest2), inward
  const Real f4_x = 0.0300000063 * (a5_y_p3 + f4_x_p1) - f4_x_p2;
  const Real minus_f4_z = 0.0300000063 * minus_f4_z_p1 + (s5 * f5_x + c5 * f5_y);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p1 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);
  tau[4] = n5_z;

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_x_p1 - 0.02999999505 * wd3_z + minus_f4_z;

  // link 6 (chest3), inward
  const Real n5_x = 0.15637308509675518 * a6_x_p4 - 0.005678398088837119 * f5_z_p1 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * f4_x_p2 -
      (0.01227760324629517 * minus_f4_z_p1 + 0.005880002159562879 * (a5_y_p2 - f4_x_p1) +
      0.0300000063 * a3_y);

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_x_p1 + 8.419374554 * wd3_z + (c4 * f4_x - s4 * f4_y);

  // link 5 (chest2), inward
  const Real n4_x = 0.0478915 * (wd4_x_p2 + wd4_x) + 0.005880002159562879 * f4_y_p2 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);

  // link 3 (hip), inward
  const Real f2_x_p1 = c3 * f3_x - s3 * f3_y;
  const Real f2_x = 24.5839218 * wd2_z - 0.031999971599999996 * a3_x_p1 + f2_x_p1;
  const Real f2_y = 0.031999971599999996 * wd2_z + 24.5839218 * a3_x_p1 + (s3 * f3_x + c3 * f3_y);

  // link 5 (chest2), inward
  const Real n4_z = 0.060169103246295166 * qdd_0[3] - 0.03561389675370483 * f4_y_p1 +
      0.005880002159562879 * wd4_x_p1 + 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

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
