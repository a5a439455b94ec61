// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in lanes.
// 8261 flops (add 3548, mul 4669, div 44), sine and cosine of 24 angles
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
  const Real inverse_D2_p8 = inverse_D3_p35 * inverse_D2_p6 - inverse_D3_p26;
  const Real inverse_D3_p39 = 0.0478915 + (inverse_D4_p51 - inverse_D4_p55 + 0.21799999999999997 *
      (inverse_D3_p22 + inverse_D3_p26)) - inverse_D3_p35 * inverse_D3_p36 - inverse_D3_p38;
  const Real inverse_D2_p9 = inverse_D3_p32 - inverse_D3_p31 * inverse_D2_p5;

  // link 2 (thigh), pose
  const Real Lambda_11_11_p1 = c2 * c1 - s2 * s1;
  const Real Lambda_11_11_p2 = s2 * c1 + c2 * s1;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p10 = s4 * (0.21799999999999997 * inverse_D2_p3 -
      (inverse_D3_p27 - inverse_D3_p10) - inverse_D3_p35 * inverse_D2_p7) + c4 *
      (0.0300000063 - 0.21799999999999997 * inverse_D2_p4 + inverse_D3_p33 * inverse_D2_p7);

  // link 3 (hip), pose
  const Real Lambda_11_11_p3 = s3 * Lambda_11_11_p1 + c3 * Lambda_11_11_p2;
  const Real Lambda_11_11_p4 = c3 * Lambda_11_11_p1 - s3 * Lambda_11_11_p2;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p11 = s4 * (inverse_D3_p34 + inverse_D3_p35 * inverse_D2_p5 +
      (inverse_D3_p30 + inverse_D3_p33 * inverse_D2_p6)) + c4 *
      (0.21799999999999997 * inverse_D3_p32 - inverse_D3_p33 * inverse_D2_p5 + inverse_D2_p8);
  const Real inverse_D2_p12 = 0.02999999505 + inverse_D2_p10;
  const Real inverse_D2_p13 = s4 * (inverse_D2_p9 -
      (inverse_D3_p19 - inverse_D2_p1 * inverse_D2_p6)) - inverse_D3_p20 *
      (inverse_D3_p25 + inverse_D3_p31 * inverse_D2_p6);

  // link 4 (chest1), pose
  const Real Lambda_11_11_p5 = c4 * Lambda_11_11_p3;
  const Real Lambda_11_11_p6 = s4 * Lambda_11_11_p3;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p40 = inverse_D3_p38 + s4 *
      (s4 * inverse_D3_p39 + inverse_D3_p20 * (0.21799999999999997 * inverse_D3_p34 +
      inverse_D3_p35 * inverse_D3_p37));

  // link 5 (chest2), pose
  const Real Lambda_11_11_p7 = s5 * s4;
  const Real Lambda_11_11_p8 = c5 * s4;
  const Real Lambda_11_11_p9 = s5 * Lambda_11_11_p5 - c5 * Lambda_11_11_p4;
  const Real Lambda_11_11_p10 = c5 * Lambda_11_11_p5 + s5 * Lambda_11_11_p4;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p40);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p14 = 8.419374554 + (c4 * inverse_D2_p11 - inverse_D2_p8);

  // link 6 (chest3), pose
  const Real Lambda_11_11_p11 = s6 * c4 - c6 * Lambda_11_11_p7;
  const Real Lambda_11_11_p14 = s6 * Lambda_11_11_p7 + c6 * c4;

  // link 4 (chest1), pose
  const Real Lambda_11_11_p15 = c4 * Lambda_11_11_p4;
  const Real Lambda_11_11_p18 = s4 * Lambda_11_11_p4;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p29 = c6 * Lambda_11_11_p9 + s6 * Lambda_11_11_p6;
  const Real Lambda_11_11_p30 = s6 * Lambda_11_11_p9 - c6 * Lambda_11_11_p6;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p31_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p11 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p8;
  const Lanes<2> Lambda_11_11_p33_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p11 +
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p8;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p35 = s5 * Lambda_11_11_p15 + c5 * Lambda_11_11_p3;
  const Real Lambda_11_11_p38 = c5 * Lambda_11_11_p15 - s5 * Lambda_11_11_p3;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p57_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p29 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p10;
  const Lanes<2> Lambda_11_11_p59_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p29 -
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p10;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p12 * inverse_D3;
  const Real inverse_D2_p16 = inverse_D2_p14 * inverse_D3;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p61_lanes = detail::make_pack<Real>(c8, c15) * Lambda_11_11_p14 -
      detail::make_pack<Real>(s8, s15) * Lambda_11_11_p31_lanes;
  const Lanes<2> Lambda_11_11_p63_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p31_lanes + detail::make_pack<Real>(s8, s15) * Lambda_11_11_p14;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p65 = c6 * Lambda_11_11_p35 + s6 * Lambda_11_11_p18;
  const Real Lambda_11_11_p68 = s6 * Lambda_11_11_p35 - c6 * Lambda_11_11_p18;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p91_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_11_11_p57_lanes + detail::make_pack<Real>(c8, c15) * Lambda_11_11_p30;
  const Lanes<2> Lambda_11_11_p93_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p57_lanes - detail::make_pack<Real>(s8, s15) * Lambda_11_11_p30;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = inverse_D2_p14 * inverse_D2_p15 -
      (c4 * (inverse_D3_p31 * inverse_D2_p7 - inverse_D2_p4) - s4 *
      (inverse_D2_p1 * inverse_D2_p7 - inverse_D2_p3));
  const Real inverse_D2_p18 = inverse_D2_p9 - s4 * inverse_D2_p13 - inverse_D2_p14 * inverse_D2_p16;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_11_11_p95_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_11_11_p61_lanes + detail::make_pack<Real>(c9, c16) * Lambda_11_11_p33_lanes;
  const Lanes<2> Lambda_11_11_p97_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p61_lanes - detail::make_pack<Real>(s9, s16) * Lambda_11_11_p33_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p99_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p65 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p38;
  const Lanes<2> Lambda_11_11_p103_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p38 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p65;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p19 = inverse_D3_p14 + inverse_D3_p29 - inverse_D2_p2 * inverse_D2_p7 -
      inverse_D2_p12 * inverse_D2_p15;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_11_11_p121_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p59_lanes - detail::make_pack<Real>(s9, s16) * Lambda_11_11_p91_lanes;
  const Lanes<2> Lambda_11_11_p123_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p91_lanes + detail::make_pack<Real>(s9, s16) * Lambda_11_11_p59_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_11_11_p127_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_11_11_p95_lanes + detail::make_pack<Real>(s10, s17) * Lambda_11_11_p63_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p129 = c17 * Lambda_11_11_p63_lanes[1] - s17 * Lambda_11_11_p95_lanes[1];

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p130_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_11_11_p99_lanes + detail::make_pack<Real>(c8, c15) * Lambda_11_11_p68;
  const Lanes<2> Lambda_11_11_p134_lanes = detail::make_pack<Real>(s8, s15) * Lambda_11_11_p68 -
      detail::make_pack<Real>(c8, c15) * Lambda_11_11_p99_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_11_11_p153_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_11_11_p121_lanes + detail::make_pack<Real>(s10, s17) * Lambda_11_11_p93_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p155 = c17 * Lambda_11_11_p93_lanes[1] - s17 * Lambda_11_11_p121_lanes[1];

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = s3 * (inverse_D2_p18 - inverse_D2_p19) + c3 * (2.0 * inverse_D2_p17);

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p156_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p127_lanes + detail::make_pack<Real>(s11, s18) * Lambda_11_11_p97_lanes;
  const Lanes<2> Lambda_11_11_p158_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p97_lanes - detail::make_pack<Real>(s11, s18) * Lambda_11_11_p127_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_11_11_p160_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_11_11_p130_lanes + detail::make_pack<Real>(c9, c16) * Lambda_11_11_p103_lanes;
  const Lanes<2> Lambda_11_11_p164_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_11_11_p130_lanes - detail::make_pack<Real>(s9, s16) * Lambda_11_11_p103_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = s3 * inverse_D2_p20;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p181_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p153_lanes - detail::make_pack<Real>(s11, s18) * Lambda_11_11_p123_lanes;
  const Lanes<2> Lambda_11_11_p183_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_11_11_p153_lanes + detail::make_pack<Real>(c11, c18) * Lambda_11_11_p123_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p22 = inverse_D2_p18 - inverse_D2_p21;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p187 = c19 * Lambda_11_11_p156_lanes[1] + s19 * Lambda_11_11_p129;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_11_11_p188_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_11_11_p160_lanes + detail::make_pack<Real>(s10, s17) * Lambda_11_11_p134_lanes;
  const Lanes<8> Lambda_11_11_p190_lanes = c10 * detail::make_pack<Real>(Lambda_11_11_p134_lanes[0],
      Lambda_11_11_p63_lanes[0], Lambda_11_11_p93_lanes[0], Lambda_11_11_p134_lanes[0],
      Lambda_11_11_p134_lanes[0], Lambda_11_11_p134_lanes[0], Lambda_11_11_p134_lanes[0],
      Lambda_11_11_p134_lanes[0]) - s10 * detail::make_pack<Real>(Lambda_11_11_p160_lanes[0],
      Lambda_11_11_p95_lanes[0], Lambda_11_11_p121_lanes[0], Lambda_11_11_p160_lanes[0],
      Lambda_11_11_p160_lanes[0], Lambda_11_11_p160_lanes[0], Lambda_11_11_p160_lanes[0],
      Lambda_11_11_p160_lanes[0]);

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p195 = c17 * Lambda_11_11_p134_lanes[1] - s17 *
      Lambda_11_11_p160_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p210 = c19 * Lambda_11_11_p181_lanes[1] + s19 * Lambda_11_11_p155;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = 24.5839218 + 0.422 * inverse_D2_p22;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p211_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p188_lanes + detail::make_pack<Real>(s11, s18) * Lambda_11_11_p164_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_11_11_p213_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_11_11_p190_lanes[2], Lambda_11_11_p155) -
      detail::make_pack<Real>(s12, s19) * Lambda_11_11_p181_lanes;
  const Lanes<2> Lambda_11_11_p215_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_11_11_p190_lanes[1], Lambda_11_11_p129) -
      detail::make_pack<Real>(s12, s19) * Lambda_11_11_p156_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_11_11_p217_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_11_11_p164_lanes - detail::make_pack<Real>(s11, s18) * Lambda_11_11_p188_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * inverse_D2_p22);

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_11_11_p233_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_11_11_p190_lanes[0], Lambda_11_11_p195) -
      detail::make_pack<Real>(s12, s19) * Lambda_11_11_p211_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p235_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_11_11_p213_lanes + detail::make_pack<Real>(c13, c20) * Lambda_11_11_p183_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p237 = c19 * Lambda_11_11_p211_lanes[1] + s19 * Lambda_11_11_p195;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p238_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p158_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p215_lanes;
  const Lanes<2> Lambda_11_11_p240_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p213_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p183_lanes;
  const Lanes<2> Lambda_11_11_p242_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p215_lanes + detail::make_pack<Real>(s13, s20) * Lambda_11_11_p158_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p250_lanes = -Lambda_11_11_p235_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p255_lanes = 3.0523172236718206 *
      detail::make_pack<Real>(Lambda_11_11_p237, Lambda_11_11_p237, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p237, Lambda_11_11_p237, Lambda_11_11_p237,
      Lambda_11_11_p237);
  const Lanes<8> Lambda_11_11_p258_lanes = 17.32841575379867 *
      detail::make_pack<Real>(Lambda_11_11_p237, Lambda_11_11_p237, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p237, Lambda_11_11_p237, Lambda_11_11_p237,
      Lambda_11_11_p237);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p261_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p217_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p233_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p263_lanes = -(0.086 * Lambda_11_11_p235_lanes);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_11_11_p265_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p233_lanes + detail::make_pack<Real>(s13, s20) * Lambda_11_11_p217_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p267_lanes = 0.11533812622014242 * Lambda_11_11_p263_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p289_lanes = detail::make_pack<Real>(Lambda_11_11_p265_lanes[1],
      Lambda_11_11_p265_lanes[1], Lambda_11_11_p242_lanes[1], Lambda_11_11_p240_lanes[1],
      Lambda_11_11_p265_lanes[1], Lambda_11_11_p265_lanes[1], Lambda_11_11_p265_lanes[1],
      Lambda_11_11_p265_lanes[1]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_11_11_p237, Lambda_11_11_p237, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p237, Lambda_11_11_p237, Lambda_11_11_p237,
      Lambda_11_11_p237);

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p292_lanes = Lambda_11_11_p240_lanes +
      detail::make_pack<Real>((-3.0523172236718206), 3.0523172236718206) * Lambda_11_11_p263_lanes;
  const Lanes<2> Lambda_11_11_p294_lanes = Lambda_11_11_p250_lanes - 17.32841575379867 *
      Lambda_11_11_p263_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p296_lanes = detail::make_pack<Real>(-(0.086 * Lambda_11_11_p210),
      Lambda_11_11_p261_lanes[1], Lambda_11_11_p238_lanes[1], Lambda_11_11_p250_lanes[1],
      -(0.086 * Lambda_11_11_p210), -(0.086 * Lambda_11_11_p210), -(0.086 * Lambda_11_11_p210),
      -(0.086 * Lambda_11_11_p210)) - (-0.04672761636452121) *
      detail::make_pack<Real>(Lambda_11_11_p263_lanes[1], Lambda_11_11_p237, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p263_lanes[1], Lambda_11_11_p263_lanes[1],
      Lambda_11_11_p263_lanes[1], Lambda_11_11_p263_lanes[1]);
  const Lanes<8> Lambda_11_11_p311_lanes = s20 * Lambda_11_11_p255_lanes - c20 *
      Lambda_11_11_p258_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p330_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_11_11_p292_lanes - detail::make_pack<Real>(s13, s20) * Lambda_11_11_p294_lanes;
  const Lanes<2> Lambda_11_11_p332_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_11_11_p292_lanes + detail::make_pack<Real>(c13, c20) * Lambda_11_11_p294_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p340_lanes = s20 * detail::make_pack<Real>(Lambda_11_11_p267_lanes[1],
      Lambda_11_11_p289_lanes[1], Lambda_11_11_p289_lanes[2], Lambda_11_11_p289_lanes[3],
      Lambda_11_11_p267_lanes[1], Lambda_11_11_p267_lanes[1], Lambda_11_11_p267_lanes[1],
      Lambda_11_11_p267_lanes[1]) + c20 * Lambda_11_11_p296_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_11_11_p348_lanes = c12 * detail::make_pack<Real>(Lambda_11_11_p211_lanes[0],
      Lambda_11_11_p156_lanes[0], Lambda_11_11_p181_lanes[0], Lambda_11_11_p211_lanes[0],
      Lambda_11_11_p211_lanes[0], Lambda_11_11_p211_lanes[0], Lambda_11_11_p211_lanes[0],
      Lambda_11_11_p211_lanes[0]) + s12 * Lambda_11_11_p190_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_11_11_p351_lanes = 0.009919078854932248 * Lambda_11_11_p238_lanes;
  const Lanes<2> Lambda_11_11_p353_lanes = 0.009919078854932248 * Lambda_11_11_p261_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p362_lanes = inverse_D10_p26_lanes[1] * Lambda_11_11_p340_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_11_11_p378_lanes = 0.086 * Lambda_11_11_p348_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p381 = Lambda_11_11_p330_lanes[1] - inverse_D10_p25_lanes[1] *
      Lambda_11_11_p340_lanes[0];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p382_lanes = (-3.0523172236718206) *
      detail::make_pack<Real>(Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[0],
      Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[1],
      Lambda_11_11_p348_lanes[2], Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[0]);

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p387 = Lambda_11_11_p210 - inverse_D10_p26_lanes[1] *
      Lambda_11_11_p340_lanes[0];
  const Lanes<8> Lambda_11_11_p390_lanes = c20 * Lambda_11_11_p255_lanes + s20 *
      Lambda_11_11_p258_lanes - inverse_D10_p25_lanes[1] * Lambda_11_11_p340_lanes;
  const Lanes<8> Lambda_11_11_p393_lanes = c20 * detail::make_pack<Real>(Lambda_11_11_p267_lanes[1],
      Lambda_11_11_p289_lanes[1], Lambda_11_11_p289_lanes[2], Lambda_11_11_p289_lanes[3],
      Lambda_11_11_p267_lanes[1], Lambda_11_11_p267_lanes[1], Lambda_11_11_p267_lanes[1],
      Lambda_11_11_p267_lanes[1]) - s20 * Lambda_11_11_p296_lanes - inverse_D11_p4_lanes[1] *
      Lambda_11_11_p340_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p397_lanes = detail::make_pack<Real>(0.49024375482668536,
      0.49024375482668536, 0.49024375482668536, 17.32841575379867, 17.32841575379867,
      17.32841575379867, 0.49024375482668536, 0.49024375482668536) *
      detail::make_pack<Real>(Lambda_11_11_p261_lanes[0], Lambda_11_11_p238_lanes[0],
      Lambda_11_11_p261_lanes[0], Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[1],
      Lambda_11_11_p348_lanes[2], Lambda_11_11_p261_lanes[0], Lambda_11_11_p261_lanes[0]);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p405_lanes = detail::make_pack<Real>(Lambda_11_11_p332_lanes[1],
      Lambda_11_11_p311_lanes[1], Lambda_11_11_p311_lanes[2], Lambda_11_11_p311_lanes[3],
      Lambda_11_11_p332_lanes[1], Lambda_11_11_p332_lanes[1], Lambda_11_11_p332_lanes[1],
      Lambda_11_11_p332_lanes[1]) - inverse_D10_p27_lanes[1] * Lambda_11_11_p340_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p412_lanes = detail::make_pack<Real>(Lambda_11_11_p265_lanes[0],
      Lambda_11_11_p265_lanes[0], Lambda_11_11_p265_lanes[0], Lambda_11_11_p265_lanes[0],
      Lambda_11_11_p242_lanes[0], Lambda_11_11_p240_lanes[0], Lambda_11_11_p265_lanes[0],
      Lambda_11_11_p265_lanes[0]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[0],
      Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[1],
      Lambda_11_11_p348_lanes[2], Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[0]);
  const Lanes<8> Lambda_11_11_p415_lanes = detail::make_pack<Real>(-Lambda_11_11_p378_lanes[0],
      -Lambda_11_11_p378_lanes[1], -Lambda_11_11_p378_lanes[2], Lambda_11_11_p261_lanes[0],
      Lambda_11_11_p238_lanes[0], Lambda_11_11_p250_lanes[0], -Lambda_11_11_p378_lanes[0],
      -Lambda_11_11_p378_lanes[0]) - detail::make_pack<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_pack<Real>(Lambda_11_11_p261_lanes[0], Lambda_11_11_p238_lanes[0],
      Lambda_11_11_p263_lanes[0], Lambda_11_11_p348_lanes[0], Lambda_11_11_p348_lanes[1],
      Lambda_11_11_p348_lanes[2], Lambda_11_11_p261_lanes[0], Lambda_11_11_p261_lanes[0]);
  const Lanes<2> Lambda_11_11_p421_lanes = Lambda_11_11_p242_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_11_11_p238_lanes;
  const Lanes<2> Lambda_11_11_p430_lanes = Lambda_11_11_p265_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_11_11_p261_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p465_lanes = c19 * Lambda_11_11_p362_lanes + s19 *
      Lambda_11_11_p390_lanes;
  const Real Lambda_11_11_p468 = s19 * Lambda_11_11_p381 - c19 * Lambda_11_11_p387;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p469_lanes = -(c19 * Lambda_11_11_p393_lanes);

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p493_lanes = s13 * detail::make_pack<Real>(Lambda_11_11_p353_lanes[0],
      Lambda_11_11_p351_lanes[0], Lambda_11_11_p267_lanes[0], Lambda_11_11_p412_lanes[3],
      Lambda_11_11_p412_lanes[4], Lambda_11_11_p412_lanes[5], Lambda_11_11_p353_lanes[0],
      Lambda_11_11_p353_lanes[0]) + c13 * Lambda_11_11_p415_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p503_lanes = s19 * Lambda_11_11_p362_lanes - c19 *
      Lambda_11_11_p390_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p514_lanes = c13 * detail::make_pack<Real>(Lambda_11_11_p430_lanes[0],
      Lambda_11_11_p421_lanes[0], Lambda_11_11_p430_lanes[0], Lambda_11_11_p382_lanes[3],
      Lambda_11_11_p382_lanes[4], Lambda_11_11_p382_lanes[5], Lambda_11_11_p430_lanes[0],
      Lambda_11_11_p430_lanes[0]) + s13 * Lambda_11_11_p397_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p519_lanes = 0.269 * Lambda_11_11_p405_lanes - s19 *
      Lambda_11_11_p393_lanes - inverse_D10_p83_lanes[1] * Lambda_11_11_p469_lanes;
  const Lanes<8> Lambda_11_11_p529_lanes = -detail::make_pack<Real>(Lambda_11_11_p468,
      Lambda_11_11_p465_lanes[1], Lambda_11_11_p465_lanes[2], Lambda_11_11_p465_lanes[3],
      Lambda_11_11_p468, Lambda_11_11_p468, Lambda_11_11_p468, Lambda_11_11_p468) +
      inverse_D8_p4_lanes[1] * Lambda_11_11_p469_lanes;
  const Lanes<8> Lambda_11_11_p533_lanes = Lambda_11_11_p405_lanes - inverse_D8_p5_lanes[1] *
      Lambda_11_11_p469_lanes;
  const Lanes<8> Lambda_11_11_p537_lanes = 0.269 * detail::make_pack<Real>(Lambda_11_11_p468,
      Lambda_11_11_p465_lanes[1], Lambda_11_11_p465_lanes[2], Lambda_11_11_p465_lanes[3],
      Lambda_11_11_p468, Lambda_11_11_p468, Lambda_11_11_p468, Lambda_11_11_p468) -
      inverse_D10_p84_lanes[1] * Lambda_11_11_p469_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p565_lanes = detail::make_pack<Real>(Lambda_11_11_p514_lanes[0],
      Lambda_11_11_p514_lanes[1], Lambda_11_11_p330_lanes[0], Lambda_11_11_p514_lanes[0],
      Lambda_11_11_p514_lanes[0], Lambda_11_11_p514_lanes[0], Lambda_11_11_p514_lanes[0],
      Lambda_11_11_p514_lanes[0]) - inverse_D10_p25_lanes[0] * Lambda_11_11_p493_lanes;
  const Lanes<8> Lambda_11_11_p568_lanes = Lambda_11_11_p348_lanes - inverse_D10_p26_lanes[0] *
      Lambda_11_11_p493_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_11_11_p583_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p593_lanes = s18 * Lambda_11_11_p519_lanes + c18 *
      Lambda_11_11_p537_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p615_lanes = inverse_D9_p7_lanes[1] * Lambda_11_11_p593_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_11_11_p623_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_11_11_p568_lanes[2], Lambda_11_11_p387) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_11_11_p565_lanes[2],
      Lambda_11_11_p381));

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p629_lanes = c18 * Lambda_11_11_p519_lanes - s18 *
      Lambda_11_11_p537_lanes - inverse_D9_p9_lanes[1] * Lambda_11_11_p593_lanes;
  const Lanes<8> Lambda_11_11_p633_lanes = c18 * Lambda_11_11_p529_lanes - s18 *
      Lambda_11_11_p533_lanes - inverse_D8_p60_lanes[1] * Lambda_11_11_p593_lanes;
  const Lanes<8> Lambda_11_11_p649_lanes = -(detail::make_pack<Real>(Lambda_11_11_p623_lanes[1],
      Lambda_11_11_p503_lanes[1], Lambda_11_11_p503_lanes[2], Lambda_11_11_p503_lanes[3],
      Lambda_11_11_p623_lanes[1], Lambda_11_11_p623_lanes[1], Lambda_11_11_p623_lanes[1],
      Lambda_11_11_p623_lanes[1]) - inverse_D8_p40_lanes[1] * Lambda_11_11_p469_lanes) -
      inverse_D8_p81_lanes[1] * Lambda_11_11_p593_lanes;
  const Lanes<8> Lambda_11_11_p653_lanes = s18 * Lambda_11_11_p529_lanes + c18 *
      Lambda_11_11_p533_lanes - inverse_D8_p63_lanes[1] * Lambda_11_11_p593_lanes;
  const Lanes<8> Lambda_11_11_p685_lanes = c17 * Lambda_11_11_p615_lanes - s17 *
      Lambda_11_11_p629_lanes;
  const Lanes<8> Lambda_11_11_p693_lanes = s17 * Lambda_11_11_p649_lanes - c17 *
      Lambda_11_11_p633_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_11_11_p697_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p703_lanes = inverse_D8_p148_lanes[1] * Lambda_11_11_p685_lanes;
  const Lanes<8> Lambda_11_11_p739_lanes = c17 * Lambda_11_11_p629_lanes + s17 *
      Lambda_11_11_p615_lanes + 0.282 * Lambda_11_11_p653_lanes - Lambda_11_11_p703_lanes;
  const Lanes<8> Lambda_11_11_p743_lanes = -Lambda_11_11_p693_lanes + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p685_lanes;
  const Lanes<8> Lambda_11_11_p747_lanes = 0.282 * Lambda_11_11_p693_lanes -
      inverse_D8_p149_lanes[1] * Lambda_11_11_p685_lanes;
  const Lanes<8> Lambda_11_11_p751_lanes = Lambda_11_11_p653_lanes - inverse_D6_p33_lanes[1] *
      Lambda_11_11_p685_lanes;
  const Lanes<8> Lambda_11_11_p755_lanes = -(s17 * Lambda_11_11_p633_lanes + c17 *
      Lambda_11_11_p649_lanes) + inverse_D6_p35_lanes[1] * Lambda_11_11_p685_lanes;
  const Lanes<8> Lambda_11_11_p795_lanes = c16 * Lambda_11_11_p739_lanes - s16 *
      Lambda_11_11_p747_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p815_lanes = Lambda_11_11_p583_lanes[1] * Lambda_11_11_p795_lanes;
  const Lanes<8> Lambda_11_11_p831_lanes = s16 * Lambda_11_11_p739_lanes + c16 *
      Lambda_11_11_p747_lanes - inverse_D7_p8_lanes[1] * Lambda_11_11_p795_lanes;
  const Lanes<8> Lambda_11_11_p839_lanes = -Lambda_11_11_p755_lanes + inverse_D6_p113_lanes[1] *
      Lambda_11_11_p795_lanes;
  const Lanes<8> Lambda_11_11_p843_lanes = s16 * Lambda_11_11_p743_lanes + c16 *
      Lambda_11_11_p751_lanes - inverse_D6_p115_lanes[1] * Lambda_11_11_p795_lanes;
  const Lanes<8> Lambda_11_11_p879_lanes = s15 * Lambda_11_11_p815_lanes + c15 *
      Lambda_11_11_p831_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p899_lanes = inverse_D6_p283_lanes[1] * Lambda_11_11_p879_lanes;
  const Lanes<8> Lambda_11_11_p911_lanes = Lambda_11_11_p697_lanes[1] * Lambda_11_11_p879_lanes;
  const Lanes<8> Lambda_11_11_p915_lanes = c15 * Lambda_11_11_p839_lanes - s15 *
      Lambda_11_11_p843_lanes - inverse_D6_p281_lanes[1] * Lambda_11_11_p879_lanes;
  const Lanes<8> Lambda_11_11_p919_lanes = c16 * Lambda_11_11_p743_lanes - s16 *
      Lambda_11_11_p751_lanes - inverse_D6_p119_lanes[1] * Lambda_11_11_p795_lanes -
      Lambda_11_11_p899_lanes;
  const Lanes<8> Lambda_11_11_p923_lanes = s15 * Lambda_11_11_p839_lanes + c15 *
      Lambda_11_11_p843_lanes - inverse_D6_p285_lanes[1] * Lambda_11_11_p879_lanes;
  const Lanes<8> Lambda_11_11_p927_lanes = c15 * Lambda_11_11_p815_lanes - s15 *
      Lambda_11_11_p831_lanes - inverse_D6_p346_lanes[1] * Lambda_11_11_p879_lanes;
  const Lanes<8> Lambda_11_11_p967_lanes = s14 * Lambda_11_11_p919_lanes + c14 *
      Lambda_11_11_p915_lanes;
  const Lanes<8> Lambda_11_11_p975_lanes = c14 * Lambda_11_11_p919_lanes - s14 *
      Lambda_11_11_p915_lanes;
  const Lanes<8> Lambda_11_11_p995_lanes = 0.226 * Lambda_11_11_p923_lanes + (-0.18) *
      Lambda_11_11_p967_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1007_lanes = -(c14 * Lambda_11_11_p911_lanes + s14 *
      Lambda_11_11_p927_lanes + Lambda_11_11_p995_lanes);
  const Lanes<8> Lambda_11_11_p1011_lanes = inverse_D5_p65 * Lambda_11_11_p1007_lanes;
  const Lanes<8> Lambda_11_11_p1031_lanes = (-0.18) * Lambda_11_11_p975_lanes -
      (s14 * Lambda_11_11_p911_lanes - c14 * Lambda_11_11_p927_lanes) - Lambda_11_11_p1011_lanes;
  const Lanes<8> Lambda_11_11_p1035_lanes = 0.226 * Lambda_11_11_p975_lanes - inverse_D5_p64 *
      Lambda_11_11_p1007_lanes;
  const Lanes<8> Lambda_11_11_p1039_lanes = Lambda_11_11_p975_lanes - inverse_D5_p63 *
      Lambda_11_11_p1007_lanes;
  const Lanes<8> Lambda_11_11_p1043_lanes = Lambda_11_11_p967_lanes + inverse_D4_p24 *
      Lambda_11_11_p1007_lanes;
  const Lanes<8> Lambda_11_11_p1047_lanes = Lambda_11_11_p923_lanes - inverse_D4_p25 *
      Lambda_11_11_p1007_lanes;
  const Lanes<8> Lambda_11_11_p1091_lanes = s6 * Lambda_11_11_p1043_lanes + c6 *
      Lambda_11_11_p1047_lanes;
  const Lanes<8> Lambda_11_11_p1103_lanes = s6 * Lambda_11_11_p1031_lanes + c6 *
      Lambda_11_11_p1035_lanes + 0.072 * Lambda_11_11_p1039_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p3 = c3 * inverse_D2_p20 - inverse_D2_p17;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1135_lanes = -(0.072 * Lambda_11_11_p1091_lanes) + inverse_D4_p49 *
      Lambda_11_11_p1103_lanes;
  const Lanes<8> Lambda_11_11_p1139_lanes = c6 * Lambda_11_11_p1031_lanes - s6 *
      Lambda_11_11_p1035_lanes - inverse_D4_p50 * Lambda_11_11_p1103_lanes;
  const Lanes<8> Lambda_11_11_p1143_lanes = c6 * Lambda_11_11_p1043_lanes - s6 *
      Lambda_11_11_p1047_lanes - inverse_D3_p6 * Lambda_11_11_p1103_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p4 = 0.031999971599999996 + 0.422 * inverse_D1_p3;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p5 = inverse_D2_p22 - inverse_D1_p1 * inverse_D1_p2;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1147_lanes = Lambda_11_11_p1039_lanes - inverse_D3_p5 *
      Lambda_11_11_p1103_lanes;
  const Lanes<8> Lambda_11_11_p1151_lanes = Lambda_11_11_p1091_lanes - inverse_D3_p7 *
      Lambda_11_11_p1103_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p6 = inverse_D1_p4 * inverse_D2;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1183 = 0.49024375482668536 * Lambda_11_11_p238_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1196_lanes = s5 * Lambda_11_11_p1143_lanes - c5 *
      Lambda_11_11_p1147_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1208_lanes = -(s5 * Lambda_11_11_p1135_lanes + c5 *
      Lambda_11_11_p1139_lanes);

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1224 = -(0.086 * Lambda_11_11_p187) - (-0.004018575007348824) *
      Lambda_11_11_p238_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1265_lanes = -(s5 * Lambda_11_11_p1139_lanes - c5 *
      Lambda_11_11_p1135_lanes + 0.21799999999999997 * Lambda_11_11_p1151_lanes);
  const Lanes<8> Lambda_11_11_p1273_lanes = -(s5 * Lambda_11_11_p1147_lanes + c5 *
      Lambda_11_11_p1143_lanes) - inverse_D2_p7 * Lambda_11_11_p1208_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1281 = s20 * Lambda_11_11_p351_lanes[1] + c20 * Lambda_11_11_p1224;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1282_lanes = c4 * (-(0.21799999999999997 *
      Lambda_11_11_p1196_lanes) + inverse_D3_p37 * Lambda_11_11_p1208_lanes);
  const Lanes<8> Lambda_11_11_p1290_lanes = s4 * (Lambda_11_11_p1151_lanes + inverse_D2_p6 *
      Lambda_11_11_p1208_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p7 = s2 * (inverse_D1_p5 - (inverse_D2_p19 + inverse_D2_p21 -
      inverse_D1_p4 * inverse_D1_p6)) + c2 * (2.0 * (inverse_D1_p3 - inverse_D1_p1 *
      inverse_D1_p6));

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1298_lanes = s4 * (Lambda_11_11_p1265_lanes - inverse_D3_p36 *
      Lambda_11_11_p1208_lanes) + Lambda_11_11_p1282_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1306 = c20 * Lambda_11_11_p421_lanes[1] + s20 * Lambda_11_11_p1183 -
      inverse_D10_p25_lanes[1] * Lambda_11_11_p1281;
  const Real Lambda_11_11_p1307 = Lambda_11_11_p187 - inverse_D10_p26_lanes[1] * Lambda_11_11_p1281;
  const Real Lambda_11_11_p1308 = c20 * Lambda_11_11_p351_lanes[1] - s20 * Lambda_11_11_p1224 -
      inverse_D11_p4_lanes[1] * Lambda_11_11_p1281;
  const Real Lambda_11_11_p1309 = s20 * Lambda_11_11_p421_lanes[1] - c20 * Lambda_11_11_p1183 -
      inverse_D10_p27_lanes[1] * Lambda_11_11_p1281;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1310_lanes = inverse_D2_p16 * Lambda_11_11_p1298_lanes;
  const Lanes<8> Lambda_11_11_p1318_lanes = c4 * (-Lambda_11_11_p1196_lanes + inverse_D2_p5 *
      Lambda_11_11_p1208_lanes) - Lambda_11_11_p1290_lanes - Lambda_11_11_p1310_lanes;
  const Lanes<8> Lambda_11_11_p1322_lanes = -Lambda_11_11_p1273_lanes + inverse_D2_p15 *
      Lambda_11_11_p1298_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1326 = s19 * Lambda_11_11_p1306 - c19 * Lambda_11_11_p1307;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1327 = -(c19 * Lambda_11_11_p1308);
  const Real Lambda_11_11_p1348 = 0.269 * Lambda_11_11_p1309 - s19 * Lambda_11_11_p1308 -
      inverse_D10_p83_lanes[1] * Lambda_11_11_p1327;
  const Real Lambda_11_11_p1349 = -Lambda_11_11_p1326 + inverse_D8_p4_lanes[1] * Lambda_11_11_p1327;
  const Real Lambda_11_11_p1350 = Lambda_11_11_p1309 - inverse_D8_p5_lanes[1] * Lambda_11_11_p1327;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1353_lanes = c3 * Lambda_11_11_p1318_lanes - s3 *
      Lambda_11_11_p1322_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1357 = 0.269 * Lambda_11_11_p1326 - inverse_D10_p84_lanes[1] *
      Lambda_11_11_p1327;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1358 = 0.49024375482668536 * Lambda_11_11_p261_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_11_11_p1359_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_11_11_p568_lanes[1], Lambda_11_11_p1307) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_11_11_p565_lanes[1],
      Lambda_11_11_p1306));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p5 - s2 * inverse_D1_p7));

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p1361_lanes = 0.422 * Lambda_11_11_p1353_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1369 = -(0.086 * Lambda_11_11_p237) - (-0.004018575007348824) *
      Lambda_11_11_p261_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1370 = s18 * Lambda_11_11_p1348 + c18 * Lambda_11_11_p1357;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1379 = inverse_D9_p7_lanes[1] * Lambda_11_11_p1370;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1380 = s20 * Lambda_11_11_p353_lanes[1] + c20 * Lambda_11_11_p1369;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1389 = c18 * Lambda_11_11_p1348 - s18 * Lambda_11_11_p1357 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p1370;
  const Real Lambda_11_11_p1390 = c18 * Lambda_11_11_p1349 - s18 * Lambda_11_11_p1350 -
      inverse_D8_p60_lanes[1] * Lambda_11_11_p1370;
  const Real Lambda_11_11_p1391 = -(Lambda_11_11_p1359_lanes[1] - inverse_D8_p40_lanes[1] *
      Lambda_11_11_p1327) - inverse_D8_p81_lanes[1] * Lambda_11_11_p1370;
  const Real Lambda_11_11_p1392 = s18 * Lambda_11_11_p1349 + c18 * Lambda_11_11_p1350 -
      inverse_D8_p63_lanes[1] * Lambda_11_11_p1370;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p1397_lanes = s2 * (s3 * Lambda_11_11_p1318_lanes + c3 *
      Lambda_11_11_p1322_lanes - inverse_D1_p6 * Lambda_11_11_p1361_lanes);

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1401 = c20 * Lambda_11_11_p430_lanes[1] + s20 * Lambda_11_11_p1358 -
      inverse_D10_p25_lanes[1] * Lambda_11_11_p1380;
  const Real Lambda_11_11_p1402 = Lambda_11_11_p237 - inverse_D10_p26_lanes[1] * Lambda_11_11_p1380;
  const Real Lambda_11_11_p1403 = c20 * Lambda_11_11_p353_lanes[1] - s20 * Lambda_11_11_p1369 -
      inverse_D11_p4_lanes[1] * Lambda_11_11_p1380;
  const Real Lambda_11_11_p1404 = s20 * Lambda_11_11_p430_lanes[1] - c20 * Lambda_11_11_p1358 -
      inverse_D10_p27_lanes[1] * Lambda_11_11_p1380;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1409 = c17 * Lambda_11_11_p1379 - s17 * Lambda_11_11_p1389;
  const Real Lambda_11_11_p1410 = s17 * Lambda_11_11_p1391 - c17 * Lambda_11_11_p1390;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p1411_lanes = 0.434 *
      (c2 * (Lambda_11_11_p1353_lanes - inverse_D1_p2 * Lambda_11_11_p1361_lanes) -
      Lambda_11_11_p1397_lanes);

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1419 = s19 * Lambda_11_11_p1401 - c19 * Lambda_11_11_p1402;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1420 = -(c19 * Lambda_11_11_p1403);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1423 = c17 * Lambda_11_11_p1389 + s17 * Lambda_11_11_p1379 + 0.282 *
      Lambda_11_11_p1392 - inverse_D8_p148_lanes[1] * Lambda_11_11_p1409;
  const Real Lambda_11_11_p1424 = 0.282 * Lambda_11_11_p1410 - inverse_D8_p149_lanes[1] *
      Lambda_11_11_p1409;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p1425_lanes = Lambda_11_11_p1411_lanes * inverse_D1;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1429 = 0.269 * Lambda_11_11_p1404 - s19 * Lambda_11_11_p1403 -
      inverse_D10_p83_lanes[1] * Lambda_11_11_p1420;
  const Real Lambda_11_11_p1430 = -Lambda_11_11_p1419 + inverse_D8_p4_lanes[1] * Lambda_11_11_p1420;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_11_11_p1431_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_11_11_p568_lanes[0], Lambda_11_11_p1402) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_11_11_p565_lanes[0],
      Lambda_11_11_p1401));

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1433 = Lambda_11_11_p1404 - inverse_D8_p5_lanes[1] * Lambda_11_11_p1420;
  const Real Lambda_11_11_p1468 = 0.269 * Lambda_11_11_p1419 - inverse_D10_p84_lanes[1] *
      Lambda_11_11_p1420;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1475_lanes = inverse_D10_p26_lanes[0] * Lambda_11_11_p493_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1481 = c16 * Lambda_11_11_p1423 - s16 * Lambda_11_11_p1424;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p1482_lanes = s13 *
      detail::make_pack<Real>(Lambda_11_11_p430_lanes[0], Lambda_11_11_p421_lanes[0],
      Lambda_11_11_p430_lanes[0], Lambda_11_11_p382_lanes[3], Lambda_11_11_p382_lanes[4],
      Lambda_11_11_p382_lanes[5], Lambda_11_11_p430_lanes[0], Lambda_11_11_p430_lanes[0]) - c13 *
      Lambda_11_11_p397_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1493_lanes = c13 *
      detail::make_pack<Real>(Lambda_11_11_p353_lanes[0], Lambda_11_11_p351_lanes[0],
      Lambda_11_11_p267_lanes[0], Lambda_11_11_p412_lanes[3], Lambda_11_11_p412_lanes[4],
      Lambda_11_11_p412_lanes[5], Lambda_11_11_p353_lanes[0], Lambda_11_11_p353_lanes[0]) - s13 *
      Lambda_11_11_p415_lanes - inverse_D11_p4_lanes[0] * Lambda_11_11_p493_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1502 = Lambda_11_11_p583_lanes[1] * Lambda_11_11_p1481;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1503_lanes = Lambda_11_11_p514_lanes - inverse_D10_p25_lanes[0] *
      Lambda_11_11_p493_lanes;
  const Lanes<8> Lambda_11_11_p1506_lanes = detail::make_pack<Real>(Lambda_11_11_p1482_lanes[0],
      Lambda_11_11_p1482_lanes[1], Lambda_11_11_p332_lanes[0], Lambda_11_11_p1482_lanes[3],
      Lambda_11_11_p1482_lanes[4], Lambda_11_11_p1482_lanes[5], Lambda_11_11_p1482_lanes[0],
      Lambda_11_11_p1482_lanes[0]) - inverse_D10_p27_lanes[0] * Lambda_11_11_p493_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1512 = s18 * Lambda_11_11_p1429 + c18 * Lambda_11_11_p1468;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1525_lanes = s12 * Lambda_11_11_p565_lanes - c12 *
      Lambda_11_11_p568_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1537 = inverse_D9_p7_lanes[1] * Lambda_11_11_p1512;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1538 = s16 * Lambda_11_11_p1423 + c16 * Lambda_11_11_p1424 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p1481;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1539_lanes = -(c12 * Lambda_11_11_p1493_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1569_lanes = c12 * Lambda_11_11_p1475_lanes + s12 *
      Lambda_11_11_p1503_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1578 = c18 * Lambda_11_11_p1429 - s18 * Lambda_11_11_p1468 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p1512;
  const Real Lambda_11_11_p1579 = c18 * Lambda_11_11_p1430 - s18 * Lambda_11_11_p1433 -
      inverse_D8_p60_lanes[1] * Lambda_11_11_p1512;
  const Real Lambda_11_11_p1586 = -(Lambda_11_11_p1431_lanes[1] - inverse_D8_p40_lanes[1] *
      Lambda_11_11_p1420) - inverse_D8_p81_lanes[1] * Lambda_11_11_p1512;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1593_lanes = Lambda_11_11_p1506_lanes - inverse_D8_p5_lanes[0] *
      Lambda_11_11_p1539_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1599 = s18 * Lambda_11_11_p1430 + c18 * Lambda_11_11_p1433 -
      inverse_D8_p63_lanes[1] * Lambda_11_11_p1512;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1606_lanes = 0.269 * Lambda_11_11_p1506_lanes - s12 *
      Lambda_11_11_p1493_lanes - inverse_D10_p83_lanes[0] * Lambda_11_11_p1539_lanes;
  const Lanes<8> Lambda_11_11_p1618_lanes = -detail::make_pack<Real>(Lambda_11_11_p1525_lanes[0],
      Lambda_11_11_p1525_lanes[1], Lambda_11_11_p1525_lanes[2], Lambda_11_11_p1569_lanes[3],
      Lambda_11_11_p1569_lanes[4], Lambda_11_11_p1569_lanes[5], Lambda_11_11_p1525_lanes[0],
      Lambda_11_11_p1525_lanes[0]) + inverse_D8_p4_lanes[0] * Lambda_11_11_p1539_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1630_lanes = s12 * Lambda_11_11_p1475_lanes - c12 *
      Lambda_11_11_p1503_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1663_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_11_11_p1525_lanes[0], Lambda_11_11_p1525_lanes[1],
      Lambda_11_11_p1525_lanes[2], Lambda_11_11_p1569_lanes[3], Lambda_11_11_p1569_lanes[4],
      Lambda_11_11_p1569_lanes[5], Lambda_11_11_p1525_lanes[0], Lambda_11_11_p1525_lanes[0]) -
      inverse_D10_p84_lanes[0] * Lambda_11_11_p1539_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1669 = c17 * Lambda_11_11_p1537 - s17 * Lambda_11_11_p1578;
  const Real Lambda_11_11_p1676 = s17 * Lambda_11_11_p1586 - c17 * Lambda_11_11_p1579;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1677 = s15 * Lambda_11_11_p1502 + c15 * Lambda_11_11_p1538;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1708_lanes = s11 * Lambda_11_11_p1606_lanes + c11 *
      Lambda_11_11_p1663_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1720 = c17 * Lambda_11_11_p1578 + s17 * Lambda_11_11_p1537 + 0.282 *
      Lambda_11_11_p1599 - inverse_D8_p148_lanes[1] * Lambda_11_11_p1669;
  const Real Lambda_11_11_p1721 = 0.282 * Lambda_11_11_p1676 - inverse_D8_p149_lanes[1] *
      Lambda_11_11_p1669;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1740_lanes = inverse_D9_p7_lanes[0] * Lambda_11_11_p1708_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1752 = -Lambda_11_11_p1410 + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p1409;
  const Real Lambda_11_11_p1753 = Lambda_11_11_p1392 - inverse_D6_p33_lanes[1] * Lambda_11_11_p1409;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1754_lanes = c11 * Lambda_11_11_p1606_lanes - s11 *
      Lambda_11_11_p1663_lanes - inverse_D9_p9_lanes[0] * Lambda_11_11_p1708_lanes;
  const Lanes<8> Lambda_11_11_p1760_lanes = -(detail::make_pack<Real>(Lambda_11_11_p1431_lanes[0],
      Lambda_11_11_p1359_lanes[0], Lambda_11_11_p623_lanes[0], Lambda_11_11_p1630_lanes[3],
      Lambda_11_11_p1630_lanes[4], Lambda_11_11_p1630_lanes[5], Lambda_11_11_p1431_lanes[0],
      Lambda_11_11_p1431_lanes[0]) - inverse_D8_p40_lanes[0] * Lambda_11_11_p1539_lanes) -
      inverse_D8_p81_lanes[0] * Lambda_11_11_p1708_lanes;
  const Lanes<8> Lambda_11_11_p1766_lanes = c11 * Lambda_11_11_p1618_lanes - s11 *
      Lambda_11_11_p1593_lanes - inverse_D8_p60_lanes[0] * Lambda_11_11_p1708_lanes;
  const Lanes<8> Lambda_11_11_p1784_lanes = s11 * Lambda_11_11_p1618_lanes + c11 *
      Lambda_11_11_p1593_lanes - inverse_D8_p63_lanes[0] * Lambda_11_11_p1708_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1790 = c16 * Lambda_11_11_p1720 - s16 * Lambda_11_11_p1721;
  const Real Lambda_11_11_p1791 = -Lambda_11_11_p1676 + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p1669;
  const Real Lambda_11_11_p1792 = Lambda_11_11_p1599 - inverse_D6_p33_lanes[1] * Lambda_11_11_p1669;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1823 = Lambda_11_11_p583_lanes[1] * Lambda_11_11_p1790;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1824_lanes = c10 * Lambda_11_11_p1740_lanes - s10 *
      Lambda_11_11_p1754_lanes;
  const Lanes<8> Lambda_11_11_p1830_lanes = s10 * Lambda_11_11_p1760_lanes - c10 *
      Lambda_11_11_p1766_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1842 = s16 * Lambda_11_11_p1720 + c16 * Lambda_11_11_p1721 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p1790;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1843_lanes = inverse_D8_p148_lanes[0] * Lambda_11_11_p1824_lanes;
  const Lanes<8> Lambda_11_11_p1903_lanes = c10 * Lambda_11_11_p1754_lanes + s10 *
      Lambda_11_11_p1740_lanes + 0.282 * Lambda_11_11_p1784_lanes - Lambda_11_11_p1843_lanes;
  const Lanes<8> Lambda_11_11_p1909_lanes = 0.282 * Lambda_11_11_p1830_lanes -
      inverse_D8_p149_lanes[0] * Lambda_11_11_p1824_lanes;
  const Lanes<8> Lambda_11_11_p1915_lanes = -Lambda_11_11_p1830_lanes + inverse_D6_p31_lanes[0] *
      Lambda_11_11_p1824_lanes;
  const Lanes<8> Lambda_11_11_p1921_lanes = Lambda_11_11_p1784_lanes - inverse_D6_p33_lanes[0] *
      Lambda_11_11_p1824_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1927 = -(-(s17 * Lambda_11_11_p1390 + c17 * Lambda_11_11_p1391) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p1409) + inverse_D6_p113_lanes[1] * Lambda_11_11_p1481;
  const Real Lambda_11_11_p1928 = s16 * Lambda_11_11_p1752 + c16 * Lambda_11_11_p1753 -
      inverse_D6_p115_lanes[1] * Lambda_11_11_p1481;
  const Real Lambda_11_11_p1935 = s16 * Lambda_11_11_p1791 + c16 * Lambda_11_11_p1792 -
      inverse_D6_p115_lanes[1] * Lambda_11_11_p1790;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1990_lanes = -(s10 * Lambda_11_11_p1766_lanes + c10 *
      Lambda_11_11_p1760_lanes) + inverse_D6_p35_lanes[0] * Lambda_11_11_p1824_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1996 = -(-(s17 * Lambda_11_11_p1579 + c17 * Lambda_11_11_p1586) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p1669) + inverse_D6_p113_lanes[1] * Lambda_11_11_p1790;
  const Real Lambda_11_11_p1997 = s15 * Lambda_11_11_p1823 + c15 * Lambda_11_11_p1842;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1998_lanes = c9 * Lambda_11_11_p1903_lanes - s9 *
      Lambda_11_11_p1909_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p2034_lanes = Lambda_11_11_p583_lanes[0] * Lambda_11_11_p1998_lanes;
  const Lanes<8> Lambda_11_11_p2058_lanes = s9 * Lambda_11_11_p1903_lanes + c9 *
      Lambda_11_11_p1909_lanes - inverse_D7_p8_lanes[0] * Lambda_11_11_p1998_lanes;
  const Lanes<8> Lambda_11_11_p2070_lanes = -Lambda_11_11_p1990_lanes + inverse_D6_p113_lanes[0] *
      Lambda_11_11_p1998_lanes;
  const Lanes<8> Lambda_11_11_p2076_lanes = s9 * Lambda_11_11_p1915_lanes + c9 *
      Lambda_11_11_p1921_lanes - inverse_D6_p115_lanes[0] * Lambda_11_11_p1998_lanes;
  const Lanes<8> Lambda_11_11_p2082_lanes = c9 * Lambda_11_11_p1915_lanes - s9 *
      Lambda_11_11_p1921_lanes - inverse_D6_p119_lanes[0] * Lambda_11_11_p1998_lanes;
  const Lanes<8> Lambda_11_11_p2130_lanes = s8 * Lambda_11_11_p2034_lanes + c8 *
      Lambda_11_11_p2058_lanes;
  const Lanes<8> Lambda_11_11_p2136_lanes = c8 * Lambda_11_11_p2070_lanes - s8 *
      Lambda_11_11_p2076_lanes;
  const Lanes<8> Lambda_11_11_p2142_lanes = c8 * Lambda_11_11_p2034_lanes - s8 *
      Lambda_11_11_p2058_lanes;
  const Lanes<8> Lambda_11_11_p2148_lanes = s8 * Lambda_11_11_p2070_lanes + c8 *
      Lambda_11_11_p2076_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2186_lanes = detail::make_pack<Real>(Lambda_11_11_p697_lanes[0],
      Lambda_11_11_p697_lanes[0], Lambda_11_11_p697_lanes[0], Lambda_11_11_p697_lanes[0],
      Lambda_11_11_p697_lanes[0], Lambda_11_11_p697_lanes[0], Lambda_11_11_p697_lanes[1],
      Lambda_11_11_p697_lanes[1]) * detail::make_pack<Real>(Lambda_11_11_p2130_lanes[0],
      Lambda_11_11_p2130_lanes[1], Lambda_11_11_p2130_lanes[2], Lambda_11_11_p2130_lanes[3],
      Lambda_11_11_p2130_lanes[4], Lambda_11_11_p2130_lanes[5], Lambda_11_11_p1997,
      Lambda_11_11_p1677);
  const Lanes<8> Lambda_11_11_p2194_lanes = detail::make_pack<Real>(Lambda_11_11_p2082_lanes[0],
      Lambda_11_11_p2082_lanes[1], Lambda_11_11_p2082_lanes[2], Lambda_11_11_p2082_lanes[3],
      Lambda_11_11_p2082_lanes[4], Lambda_11_11_p2082_lanes[5], c16 * Lambda_11_11_p1791 - s16 *
      Lambda_11_11_p1792 - inverse_D6_p119_lanes[1] * Lambda_11_11_p1790, c16 * Lambda_11_11_p1752 -
      s16 * Lambda_11_11_p1753 - inverse_D6_p119_lanes[1] * Lambda_11_11_p1481) -
      detail::make_pack<Real>(inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[0],
      inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[0],
      inverse_D6_p283_lanes[0], inverse_D6_p283_lanes[1], inverse_D6_p283_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2130_lanes[0], Lambda_11_11_p2130_lanes[1],
      Lambda_11_11_p2130_lanes[2], Lambda_11_11_p2130_lanes[3], Lambda_11_11_p2130_lanes[4],
      Lambda_11_11_p2130_lanes[5], Lambda_11_11_p1997, Lambda_11_11_p1677);
  const Lanes<8> Lambda_11_11_p2202_lanes = detail::make_pack<Real>(Lambda_11_11_p2136_lanes[0],
      Lambda_11_11_p2136_lanes[1], Lambda_11_11_p2136_lanes[2], Lambda_11_11_p2136_lanes[3],
      Lambda_11_11_p2136_lanes[4], Lambda_11_11_p2136_lanes[5], c15 * Lambda_11_11_p1996 - s15 *
      Lambda_11_11_p1935, c15 * Lambda_11_11_p1927 - s15 * Lambda_11_11_p1928) -
      detail::make_pack<Real>(inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[0],
      inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[0],
      inverse_D6_p281_lanes[0], inverse_D6_p281_lanes[1], inverse_D6_p281_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2130_lanes[0], Lambda_11_11_p2130_lanes[1],
      Lambda_11_11_p2130_lanes[2], Lambda_11_11_p2130_lanes[3], Lambda_11_11_p2130_lanes[4],
      Lambda_11_11_p2130_lanes[5], Lambda_11_11_p1997, Lambda_11_11_p1677);
  const Lanes<8> Lambda_11_11_p2210_lanes = detail::make_pack<Real>(Lambda_11_11_p2142_lanes[0],
      Lambda_11_11_p2142_lanes[1], Lambda_11_11_p2142_lanes[2], Lambda_11_11_p2142_lanes[3],
      Lambda_11_11_p2142_lanes[4], Lambda_11_11_p2142_lanes[5], c15 * Lambda_11_11_p1823 - s15 *
      Lambda_11_11_p1842, c15 * Lambda_11_11_p1502 - s15 * Lambda_11_11_p1538) -
      detail::make_pack<Real>(inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[0],
      inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[0],
      inverse_D6_p346_lanes[0], inverse_D6_p346_lanes[1], inverse_D6_p346_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2130_lanes[0], Lambda_11_11_p2130_lanes[1],
      Lambda_11_11_p2130_lanes[2], Lambda_11_11_p2130_lanes[3], Lambda_11_11_p2130_lanes[4],
      Lambda_11_11_p2130_lanes[5], Lambda_11_11_p1997, Lambda_11_11_p1677);
  const Lanes<8> Lambda_11_11_p2218_lanes = detail::make_pack<Real>(Lambda_11_11_p2148_lanes[0],
      Lambda_11_11_p2148_lanes[1], Lambda_11_11_p2148_lanes[2], Lambda_11_11_p2148_lanes[3],
      Lambda_11_11_p2148_lanes[4], Lambda_11_11_p2148_lanes[5], s15 * Lambda_11_11_p1996 + c15 *
      Lambda_11_11_p1935, s15 * Lambda_11_11_p1927 + c15 * Lambda_11_11_p1928) -
      detail::make_pack<Real>(inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[0],
      inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[0],
      inverse_D6_p285_lanes[0], inverse_D6_p285_lanes[1], inverse_D6_p285_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p2130_lanes[0], Lambda_11_11_p2130_lanes[1],
      Lambda_11_11_p2130_lanes[2], Lambda_11_11_p2130_lanes[3], Lambda_11_11_p2130_lanes[4],
      Lambda_11_11_p2130_lanes[5], Lambda_11_11_p1997, Lambda_11_11_p1677);
  const Lanes<8> Lambda_11_11_p2298_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_11_11_p2194_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_11_11_p2202_lanes;
  const Lanes<8> Lambda_11_11_p2314_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p2194_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p2202_lanes;
  const Lanes<8> Lambda_11_11_p2354_lanes = 0.226 * Lambda_11_11_p2218_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_11_11_p2298_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2378_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p2186_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p2210_lanes + Lambda_11_11_p2354_lanes);
  const Lanes<8> Lambda_11_11_p2386_lanes = inverse_D5_p65 * Lambda_11_11_p2378_lanes;
  const Lanes<8> Lambda_11_11_p2426_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_11_11_p2314_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_11_11_p2186_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_11_11_p2210_lanes) -
      Lambda_11_11_p2386_lanes;
  const Lanes<8> Lambda_11_11_p2434_lanes = 0.226 * Lambda_11_11_p2314_lanes - inverse_D5_p64 *
      Lambda_11_11_p2378_lanes;
  const Lanes<8> Lambda_11_11_p2442_lanes = Lambda_11_11_p2314_lanes - inverse_D5_p63 *
      Lambda_11_11_p2378_lanes;
  const Lanes<8> Lambda_11_11_p2450_lanes = Lambda_11_11_p2298_lanes + inverse_D4_p24 *
      Lambda_11_11_p2378_lanes;
  const Lanes<8> Lambda_11_11_p2458_lanes = Lambda_11_11_p2218_lanes - inverse_D4_p25 *
      Lambda_11_11_p2378_lanes;
  const Lanes<8> Lambda_11_11_p2546_lanes = s6 * Lambda_11_11_p2450_lanes + c6 *
      Lambda_11_11_p2458_lanes;
  const Lanes<8> Lambda_11_11_p2570_lanes = s6 * Lambda_11_11_p2426_lanes + c6 *
      Lambda_11_11_p2434_lanes + 0.072 * Lambda_11_11_p2442_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p2626_lanes = Lambda_11_11_p1361_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2630_lanes = Lambda_11_11_p1298_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2642_lanes = Lambda_11_11_p1208_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2646_lanes = -(0.072 * Lambda_11_11_p2546_lanes) + inverse_D4_p49 *
      Lambda_11_11_p2570_lanes;
  const Lanes<8> Lambda_11_11_p2654_lanes = c6 * Lambda_11_11_p2426_lanes - s6 *
      Lambda_11_11_p2434_lanes - inverse_D4_p50 * Lambda_11_11_p2570_lanes;
  const Lanes<8> Lambda_11_11_p2662_lanes = c6 * Lambda_11_11_p2450_lanes - s6 *
      Lambda_11_11_p2458_lanes - inverse_D3_p6 * Lambda_11_11_p2570_lanes;
  const Lanes<8> Lambda_11_11_p2670_lanes = Lambda_11_11_p2442_lanes - inverse_D3_p5 *
      Lambda_11_11_p2570_lanes;
  const Lanes<8> Lambda_11_11_p2678_lanes = Lambda_11_11_p2546_lanes - inverse_D3_p7 *
      Lambda_11_11_p2570_lanes;
  const Lanes<8> Lambda_11_11_p2686_lanes = Lambda_11_11_p1103_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2690_lanes = Lambda_11_11_p1007_lanes * inverse_D6;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2774_lanes = Lambda_11_11_p2570_lanes * inverse_D5;
  const Lanes<8> Lambda_11_11_p2790_lanes = s5 * Lambda_11_11_p2662_lanes - c5 *
      Lambda_11_11_p2670_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p2798 = Lambda_11_11_p2378_lanes[7] * inverse_D6;
  const Real Lambda_11_11_p2799 = Lambda_11_11_p2378_lanes[6] * inverse_D6;
  const Lanes<8> Lambda_11_11_p2808_lanes = Lambda_11_11_p2378_lanes * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2822_lanes = Lambda_11_11_p2130_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p2836_lanes = Lambda_11_11_p1998_lanes * inverse_D8_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2842_lanes = -(s5 * Lambda_11_11_p2646_lanes + c5 *
      Lambda_11_11_p2654_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2914_lanes = Lambda_11_11_p493_lanes * inverse_D12_lanes[0];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_11_11_p2928_lanes = 0.086 * Lambda_11_11_p261_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p2930_lanes = detail::make_pack<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_pack<Real>(Lambda_11_11_p261_lanes[0],
      Lambda_11_11_p238_lanes[0], Lambda_11_11_p263_lanes[0], Lambda_11_11_p348_lanes[0],
      Lambda_11_11_p348_lanes[1], Lambda_11_11_p348_lanes[2], Lambda_11_11_p261_lanes[0],
      Lambda_11_11_p261_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p2936_lanes = Lambda_11_11_p1539_lanes * inverse_D11_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2942_lanes = Lambda_11_11_p1708_lanes * inverse_D10_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p2948_lanes = Lambda_11_11_p1824_lanes * inverse_D9_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2972_lanes = -(s5 * Lambda_11_11_p2654_lanes - c5 *
      Lambda_11_11_p2646_lanes + 0.21799999999999997 * Lambda_11_11_p2678_lanes);
  const Lanes<8> Lambda_11_11_p3012_lanes = Lambda_11_11_p2842_lanes * inverse_D4;
  const Lanes<8> Lambda_11_11_p3028_lanes = -(s5 * Lambda_11_11_p2670_lanes + c5 *
      Lambda_11_11_p2662_lanes) - inverse_D2_p7 * Lambda_11_11_p2842_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3054_lanes = Lambda_11_11_p2942_lanes * Lambda_11_11_p1708_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3068_lanes = c4 * (-(0.21799999999999997 *
      Lambda_11_11_p2790_lanes) + inverse_D3_p37 * Lambda_11_11_p2842_lanes);
  const Lanes<8> Lambda_11_11_p3090_lanes = s4 * (Lambda_11_11_p2678_lanes + inverse_D2_p6 *
      Lambda_11_11_p2842_lanes);
  const Lanes<8> Lambda_11_11_p3160_lanes = s4 * (Lambda_11_11_p2972_lanes - inverse_D3_p36 *
      Lambda_11_11_p2842_lanes) + Lambda_11_11_p3068_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3173_lanes = Lambda_11_11_p2942_lanes * Lambda_11_11_p1708_lanes[1];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_11_11_p3191_lanes = 0.086 * Lambda_11_11_p238_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3217_lanes = inverse_D2_p16 * Lambda_11_11_p3160_lanes;
  const Lanes<8> Lambda_11_11_p3233_lanes = Lambda_11_11_p3160_lanes * inverse_D3;
  const Lanes<8> Lambda_11_11_p3241_lanes = Lambda_11_11_p2630_lanes * Lambda_11_11_p3160_lanes[0];
  const Lanes<8> Lambda_11_11_p3249_lanes = Lambda_11_11_p2630_lanes * Lambda_11_11_p3160_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3253_lanes = Lambda_11_11_p2930_lanes * Lambda_11_11_p2928_lanes[0] +
      Lambda_11_11_p2914_lanes * Lambda_11_11_p493_lanes[0] + Lambda_11_11_p2936_lanes *
      Lambda_11_11_p1539_lanes[0] + Lambda_11_11_p3054_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3264_lanes = c4 * (-Lambda_11_11_p2790_lanes + inverse_D2_p5 *
      Lambda_11_11_p2842_lanes) - Lambda_11_11_p3090_lanes - Lambda_11_11_p3217_lanes;
  const Lanes<8> Lambda_11_11_p3272_lanes = -Lambda_11_11_p3028_lanes + inverse_D2_p15 *
      Lambda_11_11_p3160_lanes;
  const Lanes<8> Lambda_11_11_p3301_lanes = Lambda_11_11_p2690_lanes * Lambda_11_11_p2378_lanes[0] +
      Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[0] + Lambda_11_11_p2642_lanes *
      Lambda_11_11_p2842_lanes[0] + Lambda_11_11_p3241_lanes;
  const Lanes<8> Lambda_11_11_p3326_lanes = Lambda_11_11_p2630_lanes * Lambda_11_11_p3160_lanes[2];
  const Lanes<8> Lambda_11_11_p3368_lanes = Lambda_11_11_p2690_lanes * Lambda_11_11_p2378_lanes[1] +
      Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[1] + Lambda_11_11_p2642_lanes *
      Lambda_11_11_p2842_lanes[1] + Lambda_11_11_p3249_lanes;
  const Lanes<8> Lambda_11_11_p3381_lanes = c3 * Lambda_11_11_p3264_lanes - s3 *
      Lambda_11_11_p3272_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3397_lanes = Lambda_11_11_p3253_lanes + Lambda_11_11_p2948_lanes *
      Lambda_11_11_p1824_lanes[0] + Lambda_11_11_p2836_lanes * Lambda_11_11_p1998_lanes[0] +
      Lambda_11_11_p2822_lanes * Lambda_11_11_p2130_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3409_lanes = Lambda_11_11_p2930_lanes * Lambda_11_11_p3191_lanes[0] +
      Lambda_11_11_p2914_lanes * Lambda_11_11_p493_lanes[1] + Lambda_11_11_p2936_lanes *
      Lambda_11_11_p1539_lanes[1] + Lambda_11_11_p3173_lanes;
  const Lanes<8> Lambda_11_11_p3436_lanes = Lambda_11_11_p2942_lanes * Lambda_11_11_p1708_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3440_lanes = 0.422 * Lambda_11_11_p3381_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3448_lanes = Lambda_11_11_p3397_lanes + Lambda_11_11_p2808_lanes *
      Lambda_11_11_p2378_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3505_lanes = Lambda_11_11_p3440_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3542_lanes = Lambda_11_11_p2690_lanes * Lambda_11_11_p2378_lanes[2] +
      Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[2] + Lambda_11_11_p2642_lanes *
      Lambda_11_11_p2842_lanes[2] + Lambda_11_11_p3326_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3546_lanes = Lambda_11_11_p3409_lanes + Lambda_11_11_p2948_lanes *
      Lambda_11_11_p1824_lanes[1] + Lambda_11_11_p2836_lanes * Lambda_11_11_p1998_lanes[1] +
      Lambda_11_11_p2822_lanes * Lambda_11_11_p2130_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3579_lanes = detail::make_pack<Real>(Lambda_11_11_p3448_lanes[0],
      Lambda_11_11_p3448_lanes[1], Lambda_11_11_p3448_lanes[2], Lambda_11_11_p3448_lanes[3],
      Lambda_11_11_p3448_lanes[4], Lambda_11_11_p3448_lanes[5], Lambda_11_11_p2799 *
      Lambda_11_11_p2378_lanes[0], Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[0]) +
      Lambda_11_11_p2774_lanes * Lambda_11_11_p2570_lanes[0] + Lambda_11_11_p3012_lanes *
      Lambda_11_11_p2842_lanes[0] + Lambda_11_11_p3233_lanes * Lambda_11_11_p3160_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3604_lanes = Lambda_11_11_p3546_lanes + Lambda_11_11_p2808_lanes *
      Lambda_11_11_p2378_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3629_lanes = s2 * (s3 * Lambda_11_11_p3264_lanes + c3 *
      Lambda_11_11_p3272_lanes - inverse_D1_p6 * Lambda_11_11_p3440_lanes);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3637_lanes = Lambda_11_11_p2930_lanes * Lambda_11_11_p263_lanes[0] +
      Lambda_11_11_p2914_lanes * Lambda_11_11_p493_lanes[2] + Lambda_11_11_p2936_lanes *
      Lambda_11_11_p1539_lanes[2] + Lambda_11_11_p3436_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3657_lanes = Lambda_11_11_p2630_lanes * Lambda_11_11_p3160_lanes[3];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3708_lanes = Lambda_11_11_p2942_lanes * Lambda_11_11_p1708_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3743_lanes = 0.434 *
      (c2 * (Lambda_11_11_p3381_lanes - inverse_D1_p2 * Lambda_11_11_p3440_lanes) -
      Lambda_11_11_p3629_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3751_lanes = detail::make_pack<Real>(Lambda_11_11_p3604_lanes[1],
      Lambda_11_11_p3604_lanes[1], Lambda_11_11_p3604_lanes[2], Lambda_11_11_p3604_lanes[3],
      Lambda_11_11_p3604_lanes[4], Lambda_11_11_p3604_lanes[5], Lambda_11_11_p2799 *
      Lambda_11_11_p2378_lanes[1], Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[1]) +
      Lambda_11_11_p2774_lanes * Lambda_11_11_p2570_lanes[1] + Lambda_11_11_p3012_lanes *
      Lambda_11_11_p2842_lanes[1] + Lambda_11_11_p3233_lanes * Lambda_11_11_p3160_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3758_lanes = Lambda_11_11_p3637_lanes + Lambda_11_11_p2948_lanes *
      Lambda_11_11_p1824_lanes[2] + Lambda_11_11_p2836_lanes * Lambda_11_11_p1998_lanes[2] +
      Lambda_11_11_p2822_lanes * Lambda_11_11_p2130_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3769_lanes = Lambda_11_11_p3743_lanes * inverse_D1;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3792_lanes = Lambda_11_11_p3758_lanes + Lambda_11_11_p2808_lanes *
      Lambda_11_11_p2378_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3803_lanes = Lambda_11_11_p2690_lanes * Lambda_11_11_p2378_lanes[3] +
      Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[3] + Lambda_11_11_p2642_lanes *
      Lambda_11_11_p2842_lanes[3] + Lambda_11_11_p3657_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3832_lanes = Lambda_11_11_p2930_lanes * Lambda_11_11_p348_lanes[0] +
      Lambda_11_11_p2914_lanes * Lambda_11_11_p493_lanes[3] + Lambda_11_11_p2936_lanes *
      Lambda_11_11_p1539_lanes[3] + Lambda_11_11_p3708_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3846_lanes = Lambda_11_11_p3301_lanes + Lambda_11_11_p2626_lanes *
      Lambda_11_11_p3440_lanes[0] + Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3883_lanes = Lambda_11_11_p2630_lanes * Lambda_11_11_p3160_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3887_lanes = Lambda_11_11_p3579_lanes + Lambda_11_11_p3505_lanes *
      Lambda_11_11_p3440_lanes[0] + Lambda_11_11_p3769_lanes * Lambda_11_11_p3743_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3910_lanes = detail::make_pack<Real>(Lambda_11_11_p3792_lanes[2],
      Lambda_11_11_p3792_lanes[2], Lambda_11_11_p3792_lanes[2], Lambda_11_11_p3792_lanes[3],
      Lambda_11_11_p3792_lanes[4], Lambda_11_11_p3792_lanes[5], Lambda_11_11_p2799 *
      Lambda_11_11_p2378_lanes[2], Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[2]) +
      Lambda_11_11_p2774_lanes * Lambda_11_11_p2570_lanes[2] + Lambda_11_11_p3012_lanes *
      Lambda_11_11_p2842_lanes[2] + Lambda_11_11_p3233_lanes * Lambda_11_11_p3160_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3927 = 1.0 / Lambda_11_11_p3887_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3938_lanes = Lambda_11_11_p3832_lanes + Lambda_11_11_p2948_lanes *
      Lambda_11_11_p1824_lanes[3] + Lambda_11_11_p2836_lanes * Lambda_11_11_p1998_lanes[3] +
      Lambda_11_11_p2822_lanes * Lambda_11_11_p2130_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3957_lanes = Lambda_11_11_p3938_lanes + Lambda_11_11_p2808_lanes *
      Lambda_11_11_p2378_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3986_lanes = Lambda_11_11_p2690_lanes * Lambda_11_11_p2378_lanes[4] +
      Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[4] + Lambda_11_11_p2642_lanes *
      Lambda_11_11_p2842_lanes[4] + Lambda_11_11_p3883_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3990_lanes = Lambda_11_11_p3887_lanes * Lambda_11_11_p3927;
  const Lanes<8> Lambda_11_11_p3999_lanes = Lambda_11_11_p3846_lanes * Lambda_11_11_p3927;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p4003_lanes = detail::make_pack<Real>(Lambda_11_11_p3957_lanes[3],
      Lambda_11_11_p3957_lanes[3], Lambda_11_11_p3957_lanes[3], Lambda_11_11_p3957_lanes[3],
      Lambda_11_11_p3957_lanes[4], Lambda_11_11_p3957_lanes[5], Lambda_11_11_p2799 *
      Lambda_11_11_p2378_lanes[3], Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[3]) +
      Lambda_11_11_p2774_lanes * Lambda_11_11_p2570_lanes[3] + Lambda_11_11_p3012_lanes *
      Lambda_11_11_p2842_lanes[3] + Lambda_11_11_p3233_lanes * Lambda_11_11_p3160_lanes[3];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p4053_lanes = Lambda_11_11_p2930_lanes * Lambda_11_11_p348_lanes[1] +
      detail::make_pack<Real>(Lambda_11_11_p2914_lanes[4] * Lambda_11_11_p493_lanes[4],
      Lambda_11_11_p2914_lanes[4] * Lambda_11_11_p493_lanes[4], Lambda_11_11_p2914_lanes[4] *
      Lambda_11_11_p493_lanes[4], Lambda_11_11_p2914_lanes[4] * Lambda_11_11_p493_lanes[4],
      Lambda_11_11_p2914_lanes[4] * Lambda_11_11_p493_lanes[4], Lambda_11_11_p2914_lanes[5] *
      Lambda_11_11_p493_lanes[4], Lambda_11_11_p2914_lanes[4] * Lambda_11_11_p493_lanes[4],
      Lambda_11_11_p2914_lanes[4] * Lambda_11_11_p493_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2936_lanes[4] * Lambda_11_11_p1539_lanes[4],
      Lambda_11_11_p2936_lanes[4] * Lambda_11_11_p1539_lanes[4], Lambda_11_11_p2936_lanes[4] *
      Lambda_11_11_p1539_lanes[4], Lambda_11_11_p2936_lanes[4] * Lambda_11_11_p1539_lanes[4],
      Lambda_11_11_p2936_lanes[4] * Lambda_11_11_p1539_lanes[4], Lambda_11_11_p2936_lanes[5] *
      Lambda_11_11_p1539_lanes[4], Lambda_11_11_p2936_lanes[4] * Lambda_11_11_p1539_lanes[4],
      Lambda_11_11_p2936_lanes[4] * Lambda_11_11_p1539_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2942_lanes[4] * Lambda_11_11_p1708_lanes[4],
      Lambda_11_11_p2942_lanes[4] * Lambda_11_11_p1708_lanes[4], Lambda_11_11_p2942_lanes[4] *
      Lambda_11_11_p1708_lanes[4], Lambda_11_11_p2942_lanes[4] * Lambda_11_11_p1708_lanes[4],
      Lambda_11_11_p2942_lanes[4] * Lambda_11_11_p1708_lanes[4], Lambda_11_11_p2942_lanes[5] *
      Lambda_11_11_p1708_lanes[4], Lambda_11_11_p2942_lanes[4] * Lambda_11_11_p1708_lanes[4],
      Lambda_11_11_p2942_lanes[4] * Lambda_11_11_p1708_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2948_lanes[4] * Lambda_11_11_p1824_lanes[4],
      Lambda_11_11_p2948_lanes[4] * Lambda_11_11_p1824_lanes[4], Lambda_11_11_p2948_lanes[4] *
      Lambda_11_11_p1824_lanes[4], Lambda_11_11_p2948_lanes[4] * Lambda_11_11_p1824_lanes[4],
      Lambda_11_11_p2948_lanes[4] * Lambda_11_11_p1824_lanes[4], Lambda_11_11_p2948_lanes[5] *
      Lambda_11_11_p1824_lanes[4], Lambda_11_11_p2948_lanes[4] * Lambda_11_11_p1824_lanes[4],
      Lambda_11_11_p2948_lanes[4] * Lambda_11_11_p1824_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2836_lanes[4] * Lambda_11_11_p1998_lanes[4],
      Lambda_11_11_p2836_lanes[4] * Lambda_11_11_p1998_lanes[4], Lambda_11_11_p2836_lanes[4] *
      Lambda_11_11_p1998_lanes[4], Lambda_11_11_p2836_lanes[4] * Lambda_11_11_p1998_lanes[4],
      Lambda_11_11_p2836_lanes[4] * Lambda_11_11_p1998_lanes[4], Lambda_11_11_p2836_lanes[5] *
      Lambda_11_11_p1998_lanes[4], Lambda_11_11_p2836_lanes[4] * Lambda_11_11_p1998_lanes[4],
      Lambda_11_11_p2836_lanes[4] * Lambda_11_11_p1998_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p4072_lanes = Lambda_11_11_p2630_lanes * Lambda_11_11_p3160_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4084_lanes = Lambda_11_11_p3751_lanes + Lambda_11_11_p3505_lanes *
      Lambda_11_11_p3440_lanes[1] + Lambda_11_11_p3769_lanes * Lambda_11_11_p3743_lanes[1] -
      Lambda_11_11_p3990_lanes * Lambda_11_11_p3887_lanes[1];
  const Lanes<8> Lambda_11_11_p4091_lanes = Lambda_11_11_p3910_lanes + Lambda_11_11_p3505_lanes *
      Lambda_11_11_p3440_lanes[2] + Lambda_11_11_p3769_lanes * Lambda_11_11_p3743_lanes[2] -
      Lambda_11_11_p3990_lanes * Lambda_11_11_p3887_lanes[2];
  const Lanes<8> Lambda_11_11_p4107_lanes = Lambda_11_11_p3368_lanes + Lambda_11_11_p2626_lanes *
      Lambda_11_11_p3440_lanes[1] + Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[1] -
      Lambda_11_11_p3999_lanes * Lambda_11_11_p3887_lanes[1];
  const Lanes<8> Lambda_11_11_p4111_lanes = Lambda_11_11_p3542_lanes + Lambda_11_11_p2626_lanes *
      Lambda_11_11_p3440_lanes[2] + Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[2] -
      Lambda_11_11_p3999_lanes * Lambda_11_11_p3887_lanes[2];
  const Lanes<8> Lambda_11_11_p4115_lanes = Lambda_11_11_p3803_lanes + Lambda_11_11_p2626_lanes *
      Lambda_11_11_p3440_lanes[3] + Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[3] -
      Lambda_11_11_p3999_lanes * Lambda_11_11_p3887_lanes[3];
  const Lanes<8> Lambda_11_11_p4119_lanes = Lambda_11_11_p4003_lanes + Lambda_11_11_p3505_lanes *
      Lambda_11_11_p3440_lanes[3] + Lambda_11_11_p3769_lanes * Lambda_11_11_p3743_lanes[3] -
      Lambda_11_11_p3990_lanes * Lambda_11_11_p3887_lanes[3];
  const Real Lambda_11_11_p4133 = 1.0 / Lambda_11_11_p4084_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p4137_lanes = Lambda_11_11_p4053_lanes +
      detail::make_pack<Real>(Lambda_11_11_p2822_lanes[4] * Lambda_11_11_p2130_lanes[4],
      Lambda_11_11_p2822_lanes[4] * Lambda_11_11_p2130_lanes[4], Lambda_11_11_p2822_lanes[4] *
      Lambda_11_11_p2130_lanes[4], Lambda_11_11_p2822_lanes[4] * Lambda_11_11_p2130_lanes[4],
      Lambda_11_11_p2822_lanes[4] * Lambda_11_11_p2130_lanes[4], Lambda_11_11_p2822_lanes[5] *
      Lambda_11_11_p2130_lanes[4], Lambda_11_11_p2822_lanes[4] * Lambda_11_11_p2130_lanes[4],
      Lambda_11_11_p2822_lanes[4] * Lambda_11_11_p2130_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p2808_lanes[4] * Lambda_11_11_p2378_lanes[4],
      Lambda_11_11_p2808_lanes[4] * Lambda_11_11_p2378_lanes[4], Lambda_11_11_p2808_lanes[4] *
      Lambda_11_11_p2378_lanes[4], Lambda_11_11_p2808_lanes[4] * Lambda_11_11_p2378_lanes[4],
      Lambda_11_11_p2808_lanes[4] * Lambda_11_11_p2378_lanes[4], Lambda_11_11_p2808_lanes[5] *
      Lambda_11_11_p2378_lanes[4], Lambda_11_11_p2808_lanes[4] * Lambda_11_11_p2378_lanes[4],
      Lambda_11_11_p2808_lanes[4] * Lambda_11_11_p2378_lanes[4]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4139_lanes = Lambda_11_11_p879_lanes * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p4143_lanes = Lambda_11_11_p795_lanes * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p4150_lanes = Lambda_11_11_p685_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4157_lanes = Lambda_11_11_p593_lanes * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p4165_lanes = Lambda_11_11_p469_lanes * inverse_D11_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4169_lanes = Lambda_11_11_p3986_lanes + Lambda_11_11_p2626_lanes *
      Lambda_11_11_p3440_lanes[4] + Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[4] -
      Lambda_11_11_p3999_lanes * Lambda_11_11_p3887_lanes[4];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p4173_lanes = Lambda_11_11_p340_lanes * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p4181_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_11_11_p263_lanes[1], Lambda_11_11_p237, Lambda_11_11_p187,
      Lambda_11_11_p210, Lambda_11_11_p263_lanes[1], Lambda_11_11_p263_lanes[1],
      Lambda_11_11_p263_lanes[1], Lambda_11_11_p263_lanes[1]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p4193_lanes = detail::make_pack<Real>(Lambda_11_11_p2942_lanes[5],
      Lambda_11_11_p4157_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1708_lanes[5],
      Lambda_11_11_p593_lanes[3]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p4211_lanes = Lambda_11_11_p2690_lanes * Lambda_11_11_p2378_lanes[5] +
      Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[5] + Lambda_11_11_p2642_lanes *
      Lambda_11_11_p2842_lanes[5] + Lambda_11_11_p4072_lanes;
  const Lanes<8> Lambda_11_11_p4215_lanes = detail::make_pack<Real>(Lambda_11_11_p4137_lanes[4],
      Lambda_11_11_p4137_lanes[4], Lambda_11_11_p4137_lanes[4], Lambda_11_11_p4137_lanes[4],
      Lambda_11_11_p4137_lanes[4], Lambda_11_11_p4137_lanes[5], Lambda_11_11_p2799 *
      Lambda_11_11_p2378_lanes[4], Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[4]) +
      Lambda_11_11_p2774_lanes * Lambda_11_11_p2570_lanes[4] + Lambda_11_11_p3012_lanes *
      Lambda_11_11_p2842_lanes[4] + Lambda_11_11_p3233_lanes * Lambda_11_11_p3160_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4225_lanes = Lambda_11_11_p4084_lanes * Lambda_11_11_p4133;
  const Lanes<8> Lambda_11_11_p4235_lanes = Lambda_11_11_p4107_lanes * Lambda_11_11_p4133;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p4267_lanes = detail::make_pack<Real>(Lambda_11_11_p2930_lanes[5],
      Lambda_11_11_p4181_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p348_lanes[2],
      Lambda_11_11_p210) + detail::make_pack<Real>(Lambda_11_11_p2914_lanes[5],
      Lambda_11_11_p4173_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p493_lanes[5],
      Lambda_11_11_p340_lanes[3]) + detail::make_pack<Real>(Lambda_11_11_p2936_lanes[5],
      Lambda_11_11_p4165_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p1539_lanes[5],
      Lambda_11_11_p469_lanes[3]) + Lambda_11_11_p4193_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4281_lanes = Lambda_11_11_p4215_lanes + Lambda_11_11_p3505_lanes *
      Lambda_11_11_p3440_lanes[4] + Lambda_11_11_p3769_lanes * Lambda_11_11_p3743_lanes[4] -
      Lambda_11_11_p3990_lanes * Lambda_11_11_p3887_lanes[4];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4309_lanes = Lambda_11_11_p4157_lanes * Lambda_11_11_p1512;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4313_lanes = Lambda_11_11_p4091_lanes - Lambda_11_11_p4225_lanes *
      Lambda_11_11_p4084_lanes[2];
  const Lanes<8> Lambda_11_11_p4342_lanes = Lambda_11_11_p4111_lanes - Lambda_11_11_p4235_lanes *
      Lambda_11_11_p4084_lanes[2];
  const Real Lambda_11_11_p4362 = 1.0 / Lambda_11_11_p4313_lanes[2];
  const Lanes<8> Lambda_11_11_p4369_lanes = Lambda_11_11_p4211_lanes + Lambda_11_11_p2626_lanes *
      Lambda_11_11_p3440_lanes[5] + Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[5] -
      Lambda_11_11_p3999_lanes * Lambda_11_11_p3887_lanes[5];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_11_11_p4389_lanes = Lambda_11_11_p4267_lanes +
      detail::make_pack<Real>(Lambda_11_11_p2948_lanes[5], Lambda_11_11_p4150_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p1824_lanes[5], Lambda_11_11_p685_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p2836_lanes[5], Lambda_11_11_p4143_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p1998_lanes[5], Lambda_11_11_p795_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p2822_lanes[5], Lambda_11_11_p4139_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p2130_lanes[5], Lambda_11_11_p879_lanes[3]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4399_lanes = Lambda_11_11_p4181_lanes * Lambda_11_11_p2928_lanes[1] +
      Lambda_11_11_p4173_lanes * Lambda_11_11_p1380 + Lambda_11_11_p4165_lanes *
      Lambda_11_11_p1420 + Lambda_11_11_p4309_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4413_lanes = Lambda_11_11_p4313_lanes * Lambda_11_11_p4362;
  const Lanes<8> Lambda_11_11_p4418_lanes = Lambda_11_11_p4342_lanes * Lambda_11_11_p4362;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p4426_lanes = detail::make_pack<Real>(Lambda_11_11_p4389_lanes[0] +
      Lambda_11_11_p2808_lanes[5] * Lambda_11_11_p2378_lanes[5], Lambda_11_11_p4389_lanes[0] +
      Lambda_11_11_p2808_lanes[5] * Lambda_11_11_p2378_lanes[5], Lambda_11_11_p4389_lanes[0] +
      Lambda_11_11_p2808_lanes[5] * Lambda_11_11_p2378_lanes[5], Lambda_11_11_p4389_lanes[0] +
      Lambda_11_11_p2808_lanes[5] * Lambda_11_11_p2378_lanes[5], Lambda_11_11_p4389_lanes[0] +
      Lambda_11_11_p2808_lanes[5] * Lambda_11_11_p2378_lanes[5], Lambda_11_11_p4389_lanes[0] +
      Lambda_11_11_p2808_lanes[5] * Lambda_11_11_p2378_lanes[5], Lambda_11_11_p2799 *
      Lambda_11_11_p2378_lanes[5], Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[5]) +
      Lambda_11_11_p2774_lanes * Lambda_11_11_p2570_lanes[5] + Lambda_11_11_p3012_lanes *
      Lambda_11_11_p2842_lanes[5] + Lambda_11_11_p3233_lanes * Lambda_11_11_p3160_lanes[5];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4448_lanes = Lambda_11_11_p4399_lanes + Lambda_11_11_p4150_lanes *
      Lambda_11_11_p1669 + Lambda_11_11_p4143_lanes * Lambda_11_11_p1790 +
      Lambda_11_11_p4139_lanes * Lambda_11_11_p1997;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4464_lanes = Lambda_11_11_p4119_lanes - Lambda_11_11_p4225_lanes *
      Lambda_11_11_p4084_lanes[3] - Lambda_11_11_p4413_lanes * Lambda_11_11_p4313_lanes[3];
  const Lanes<8> Lambda_11_11_p4480_lanes = Lambda_11_11_p4115_lanes - Lambda_11_11_p4235_lanes *
      Lambda_11_11_p4084_lanes[3] - Lambda_11_11_p4418_lanes * Lambda_11_11_p4313_lanes[3];
  const Real Lambda_11_11_p4488 = 1.0 / Lambda_11_11_p4464_lanes[3];
  const Lanes<8> Lambda_11_11_p4489_lanes = Lambda_11_11_p4426_lanes + Lambda_11_11_p3505_lanes *
      Lambda_11_11_p3440_lanes[5] + Lambda_11_11_p3769_lanes * Lambda_11_11_p3743_lanes[5] -
      Lambda_11_11_p3990_lanes * Lambda_11_11_p3887_lanes[5];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p4492 = 91.62274020012977 * Lambda_11_11_p261_lanes[1] *
      Lambda_11_11_p2928_lanes[1] + Lambda_11_11_p1380 * inverse_D12_lanes[1] * Lambda_11_11_p1380 +
      Lambda_11_11_p1420 * inverse_D11_lanes[1] * Lambda_11_11_p1420;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p4493 = Lambda_11_11_p1677 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p4494 = Lambda_11_11_p1481 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4498 = Lambda_11_11_p1409 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p4503 = Lambda_11_11_p1370 * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p4504 = Lambda_11_11_p1327 * inverse_D11_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p4509 = Lambda_11_11_p1281 * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p4510 = 91.62274020012977 * Lambda_11_11_p238_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4514_lanes = Lambda_11_11_p4448_lanes + Lambda_11_11_p2690_lanes *
      Lambda_11_11_p2378_lanes[6] + Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[6] +
      Lambda_11_11_p2642_lanes * Lambda_11_11_p2842_lanes[6];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p4522 = Lambda_11_11_p4492 + Lambda_11_11_p1512 * inverse_D10_lanes[1] *
      Lambda_11_11_p1512 + Lambda_11_11_p1669 * inverse_D9_lanes[1] * Lambda_11_11_p1669 +
      Lambda_11_11_p1790 * inverse_D8_lanes[1] * Lambda_11_11_p1790;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4527_lanes = Lambda_11_11_p4464_lanes * Lambda_11_11_p4488;
  const Lanes<8> Lambda_11_11_p4531_lanes = Lambda_11_11_p4480_lanes * Lambda_11_11_p4488;
  const Lanes<8> Lambda_11_11_p4535_lanes = Lambda_11_11_p4514_lanes + Lambda_11_11_p2630_lanes *
      Lambda_11_11_p3160_lanes[6] + Lambda_11_11_p2626_lanes * Lambda_11_11_p3440_lanes[6] +
      Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[6];
  const Lanes<8> Lambda_11_11_p4582_lanes = Lambda_11_11_p4281_lanes - Lambda_11_11_p4225_lanes *
      Lambda_11_11_p4084_lanes[4] - Lambda_11_11_p4413_lanes * Lambda_11_11_p4313_lanes[4] -
      Lambda_11_11_p4527_lanes * Lambda_11_11_p4464_lanes[4];
  const Lanes<8> Lambda_11_11_p4586_lanes = Lambda_11_11_p4489_lanes - Lambda_11_11_p4225_lanes *
      Lambda_11_11_p4084_lanes[5] - Lambda_11_11_p4413_lanes * Lambda_11_11_p4313_lanes[5] -
      Lambda_11_11_p4527_lanes * Lambda_11_11_p4464_lanes[5];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4597 = Lambda_11_11_p4510 * Lambda_11_11_p2928_lanes[1] +
      Lambda_11_11_p4509 * Lambda_11_11_p1380 + Lambda_11_11_p4504 * Lambda_11_11_p1420 +
      Lambda_11_11_p4503 * Lambda_11_11_p1512 + Lambda_11_11_p4498 * Lambda_11_11_p1669;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4602_lanes = Lambda_11_11_p4157_lanes * Lambda_11_11_p1370;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p4610 = Lambda_11_11_p4522 + Lambda_11_11_p1997 * inverse_D7_lanes[1] *
      Lambda_11_11_p1997 + Lambda_11_11_p2799 * Lambda_11_11_p2378_lanes[6] +
      Lambda_11_11_p2774_lanes[6] * Lambda_11_11_p2570_lanes[6] + Lambda_11_11_p3012_lanes[6] *
      Lambda_11_11_p2842_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4611_lanes = Lambda_11_11_p4169_lanes - Lambda_11_11_p4235_lanes *
      Lambda_11_11_p4084_lanes[4] - Lambda_11_11_p4418_lanes * Lambda_11_11_p4313_lanes[4] -
      Lambda_11_11_p4531_lanes * Lambda_11_11_p4464_lanes[4];
  const Lanes<8> Lambda_11_11_p4619_lanes = Lambda_11_11_p4369_lanes - Lambda_11_11_p4235_lanes *
      Lambda_11_11_p4084_lanes[5] - Lambda_11_11_p4418_lanes * Lambda_11_11_p4313_lanes[5] -
      Lambda_11_11_p4531_lanes * Lambda_11_11_p4464_lanes[5];
  const Real Lambda_11_11_p4623 = 1.0 / Lambda_11_11_p4582_lanes[4];
  const Lanes<8> Lambda_11_11_p4656_lanes = Lambda_11_11_p4535_lanes - Lambda_11_11_p3999_lanes *
      Lambda_11_11_p3887_lanes[6] - Lambda_11_11_p4235_lanes * Lambda_11_11_p4084_lanes[6] -
      Lambda_11_11_p4418_lanes * Lambda_11_11_p4313_lanes[6];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4664_lanes = Lambda_11_11_p4181_lanes * Lambda_11_11_p3191_lanes[1] +
      Lambda_11_11_p4173_lanes * Lambda_11_11_p1281 + Lambda_11_11_p4165_lanes *
      Lambda_11_11_p1327 + Lambda_11_11_p4602_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4668 = Lambda_11_11_p4597 + Lambda_11_11_p4494 * Lambda_11_11_p1790 +
      Lambda_11_11_p4493 * Lambda_11_11_p1997 + Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[6] +
      Lambda_11_11_p2774_lanes[7] * Lambda_11_11_p2570_lanes[6];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4673 = Lambda_11_11_p4610 + Lambda_11_11_p3233_lanes[6] *
      Lambda_11_11_p3160_lanes[6] + Lambda_11_11_p3505_lanes[6] * Lambda_11_11_p3440_lanes[6] +
      Lambda_11_11_p3769_lanes[6] * Lambda_11_11_p3743_lanes[6] - Lambda_11_11_p3990_lanes[6] *
      Lambda_11_11_p3887_lanes[6];
  const Lanes<8> Lambda_11_11_p4678_lanes = Lambda_11_11_p4582_lanes * Lambda_11_11_p4623;
  const Lanes<8> Lambda_11_11_p4681_lanes = Lambda_11_11_p4611_lanes * Lambda_11_11_p4623;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4696_lanes = Lambda_11_11_p4664_lanes + Lambda_11_11_p4150_lanes *
      Lambda_11_11_p1409 + Lambda_11_11_p4143_lanes * Lambda_11_11_p1481 +
      Lambda_11_11_p4139_lanes * Lambda_11_11_p1677;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4728_lanes = Lambda_11_11_p4586_lanes - Lambda_11_11_p4678_lanes *
      Lambda_11_11_p4582_lanes[5];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4739 = Lambda_11_11_p4510 * Lambda_11_11_p3191_lanes[1] +
      Lambda_11_11_p4509 * Lambda_11_11_p1281 + Lambda_11_11_p4504 * Lambda_11_11_p1327 +
      Lambda_11_11_p4503 * Lambda_11_11_p1370 + Lambda_11_11_p4498 * Lambda_11_11_p1409;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4740 = Lambda_11_11_p4668 + Lambda_11_11_p3012_lanes[7] *
      Lambda_11_11_p2842_lanes[6] + Lambda_11_11_p3233_lanes[7] * Lambda_11_11_p3160_lanes[6] +
      Lambda_11_11_p3505_lanes[7] * Lambda_11_11_p3440_lanes[6] + Lambda_11_11_p3769_lanes[7] *
      Lambda_11_11_p3743_lanes[6];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4745_lanes = Lambda_11_11_p4157_lanes * Lambda_11_11_p593_lanes[0];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4765 = 1.0 / Lambda_11_11_p4728_lanes[5];
  const Real Lambda_11_11_p4766 = Lambda_11_11_p4673 - Lambda_11_11_p4225_lanes[6] *
      Lambda_11_11_p4084_lanes[6] - Lambda_11_11_p4413_lanes[6] * Lambda_11_11_p4313_lanes[6] -
      Lambda_11_11_p4527_lanes[6] * Lambda_11_11_p4464_lanes[6] - Lambda_11_11_p4678_lanes[6] *
      Lambda_11_11_p4582_lanes[6];
  const Lanes<8> Lambda_11_11_p4787_lanes = Lambda_11_11_p4619_lanes - Lambda_11_11_p4681_lanes *
      Lambda_11_11_p4582_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4803_lanes = Lambda_11_11_p4696_lanes + Lambda_11_11_p2690_lanes *
      Lambda_11_11_p2378_lanes[7] + Lambda_11_11_p2686_lanes * Lambda_11_11_p2570_lanes[7] +
      Lambda_11_11_p2642_lanes * Lambda_11_11_p2842_lanes[7];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4819_lanes = Lambda_11_11_p4181_lanes * Lambda_11_11_p263_lanes[1] +
      Lambda_11_11_p4173_lanes * Lambda_11_11_p340_lanes[0] + Lambda_11_11_p4165_lanes *
      Lambda_11_11_p469_lanes[0] + Lambda_11_11_p4745_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4827 = Lambda_11_11_p4739 + Lambda_11_11_p4494 * Lambda_11_11_p1481 +
      Lambda_11_11_p4493 * Lambda_11_11_p1677 + Lambda_11_11_p2798 * Lambda_11_11_p2378_lanes[7] +
      Lambda_11_11_p2774_lanes[7] * Lambda_11_11_p2570_lanes[7];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4828 = Lambda_11_11_p4740 - Lambda_11_11_p3990_lanes[7] *
      Lambda_11_11_p3887_lanes[6] - Lambda_11_11_p4225_lanes[7] * Lambda_11_11_p4084_lanes[6] -
      Lambda_11_11_p4413_lanes[7] * Lambda_11_11_p4313_lanes[6] - Lambda_11_11_p4527_lanes[7] *
      Lambda_11_11_p4464_lanes[6];
  const Lanes<8> Lambda_11_11_p4851_lanes = Lambda_11_11_p4803_lanes + Lambda_11_11_p2630_lanes *
      Lambda_11_11_p3160_lanes[7] + Lambda_11_11_p2626_lanes * Lambda_11_11_p3440_lanes[7] +
      Lambda_11_11_p1425_lanes * Lambda_11_11_p3743_lanes[7];
  const Real Lambda_11_11_p4861 = Lambda_11_11_p4728_lanes[6] * Lambda_11_11_p4765;
  const Real Lambda_11_11_p4862 = Lambda_11_11_p4728_lanes[7] * Lambda_11_11_p4765;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4863_lanes = Lambda_11_11_p4157_lanes * Lambda_11_11_p593_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4882_lanes = Lambda_11_11_p4787_lanes * Lambda_11_11_p4765;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4902_lanes = Lambda_11_11_p4819_lanes + Lambda_11_11_p4150_lanes *
      Lambda_11_11_p685_lanes[0] + Lambda_11_11_p4143_lanes * Lambda_11_11_p795_lanes[0] +
      Lambda_11_11_p4139_lanes * Lambda_11_11_p879_lanes[0];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4935 = Lambda_11_11_p4828 - Lambda_11_11_p4678_lanes[7] *
      Lambda_11_11_p4582_lanes[6] - Lambda_11_11_p4862 * Lambda_11_11_p4728_lanes[6];
  const Real Lambda_11_11_p4939 = Lambda_11_11_p4827 + Lambda_11_11_p3012_lanes[7] *
      Lambda_11_11_p2842_lanes[7] + Lambda_11_11_p3233_lanes[7] * Lambda_11_11_p3160_lanes[7] +
      Lambda_11_11_p3505_lanes[7] * Lambda_11_11_p3440_lanes[7] + Lambda_11_11_p3769_lanes[7] *
      Lambda_11_11_p3743_lanes[7];
  const Lanes<8> Lambda_11_11_p4940_lanes = Lambda_11_11_p4851_lanes - Lambda_11_11_p3999_lanes *
      Lambda_11_11_p3887_lanes[7] - Lambda_11_11_p4235_lanes * Lambda_11_11_p4084_lanes[7] -
      Lambda_11_11_p4418_lanes * Lambda_11_11_p4313_lanes[7];
  const Lanes<8> Lambda_11_11_p4944_lanes = Lambda_11_11_p4656_lanes - Lambda_11_11_p4531_lanes *
      Lambda_11_11_p4464_lanes[6] - Lambda_11_11_p4681_lanes * Lambda_11_11_p4582_lanes[6] -
      Lambda_11_11_p4882_lanes * Lambda_11_11_p4728_lanes[6];
  const Real Lambda_11_11_p4948 = 1.0 / (Lambda_11_11_p4766 - Lambda_11_11_p4861 *
      Lambda_11_11_p4728_lanes[6]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4953_lanes = Lambda_11_11_p4181_lanes * Lambda_11_11_p237 +
      Lambda_11_11_p4173_lanes * Lambda_11_11_p340_lanes[1] + Lambda_11_11_p4165_lanes *
      Lambda_11_11_p469_lanes[1] + Lambda_11_11_p4863_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4960_lanes = Lambda_11_11_p4902_lanes + Lambda_11_11_p2690_lanes *
      Lambda_11_11_p1007_lanes[0] + Lambda_11_11_p2686_lanes * Lambda_11_11_p1103_lanes[0] +
      Lambda_11_11_p2642_lanes * Lambda_11_11_p1208_lanes[0];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p4967_lanes = Lambda_11_11_p4181_lanes * Lambda_11_11_p187;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4980_lanes = Lambda_11_11_p4940_lanes - Lambda_11_11_p4531_lanes *
      Lambda_11_11_p4464_lanes[7] - Lambda_11_11_p4681_lanes * Lambda_11_11_p4582_lanes[7] -
      Lambda_11_11_p4882_lanes * Lambda_11_11_p4728_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4988_lanes = Lambda_11_11_p4953_lanes + Lambda_11_11_p4150_lanes *
      Lambda_11_11_p685_lanes[1] + Lambda_11_11_p4143_lanes * Lambda_11_11_p795_lanes[1] +
      Lambda_11_11_p4139_lanes * Lambda_11_11_p879_lanes[1];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4991 = Lambda_11_11_p4939 - Lambda_11_11_p3990_lanes[7] *
      Lambda_11_11_p3887_lanes[7] - Lambda_11_11_p4225_lanes[7] * Lambda_11_11_p4084_lanes[7] -
      Lambda_11_11_p4413_lanes[7] * Lambda_11_11_p4313_lanes[7] - Lambda_11_11_p4527_lanes[7] *
      Lambda_11_11_p4464_lanes[7];
  const Lanes<8> Lambda_11_11_p4992_lanes = Lambda_11_11_p4960_lanes + Lambda_11_11_p2630_lanes *
      Lambda_11_11_p1298_lanes[0] + Lambda_11_11_p2626_lanes * Lambda_11_11_p1361_lanes[0] +
      Lambda_11_11_p1425_lanes * Lambda_11_11_p1411_lanes[0];
  const Real Lambda_11_11_p4999 = Lambda_11_11_p4935 * Lambda_11_11_p4948;
  const Lanes<8> Lambda_11_11_p5000_lanes = Lambda_11_11_p4944_lanes * Lambda_11_11_p4948;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p5011 = Lambda_11_11_p4967_lanes[3] + Lambda_11_11_p4173_lanes[3] *
      Lambda_11_11_p340_lanes[2] + Lambda_11_11_p4165_lanes[3] * Lambda_11_11_p469_lanes[2] +
      Lambda_11_11_p4157_lanes[3] * Lambda_11_11_p593_lanes[2] + Lambda_11_11_p4150_lanes[3] *
      Lambda_11_11_p685_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p5024_lanes = Lambda_11_11_p4988_lanes + Lambda_11_11_p2690_lanes *
      Lambda_11_11_p1007_lanes[1] + Lambda_11_11_p2686_lanes * Lambda_11_11_p1103_lanes[1] +
      Lambda_11_11_p2642_lanes * Lambda_11_11_p1208_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p5027_lanes = Lambda_11_11_p4992_lanes - Lambda_11_11_p3999_lanes *
      Lambda_11_11_p3846_lanes[0] - Lambda_11_11_p4235_lanes * Lambda_11_11_p4107_lanes[0] -
      Lambda_11_11_p4418_lanes * Lambda_11_11_p4342_lanes[0];
  const Lanes<8> Lambda_11_11_p5031_lanes = Lambda_11_11_p4980_lanes - Lambda_11_11_p5000_lanes *
      Lambda_11_11_p4935;
  const Real Lambda_11_11_p5041 = 1.0 / (Lambda_11_11_p4991 - Lambda_11_11_p4678_lanes[7] *
      Lambda_11_11_p4582_lanes[7] - Lambda_11_11_p4862 * Lambda_11_11_p4728_lanes[7] -
      Lambda_11_11_p4999 * Lambda_11_11_p4935);
  const Lanes<8> Lambda_11_11_p5053_lanes = Lambda_11_11_p5024_lanes + Lambda_11_11_p2630_lanes *
      Lambda_11_11_p1298_lanes[1] + Lambda_11_11_p2626_lanes * Lambda_11_11_p1361_lanes[1] +
      Lambda_11_11_p1425_lanes * Lambda_11_11_p1411_lanes[1];

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p5056 = Lambda_11_11_p5011 + Lambda_11_11_p4143_lanes[3] *
      Lambda_11_11_p795_lanes[2] + Lambda_11_11_p4139_lanes[3] * Lambda_11_11_p879_lanes[2] +
      Lambda_11_11_p2690_lanes[3] * Lambda_11_11_p1007_lanes[2] + Lambda_11_11_p2686_lanes[3] *
      Lambda_11_11_p1103_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p5057_lanes = Lambda_11_11_p5027_lanes - Lambda_11_11_p4531_lanes *
      Lambda_11_11_p4480_lanes[0] - Lambda_11_11_p4681_lanes * Lambda_11_11_p4611_lanes[0] -
      Lambda_11_11_p4882_lanes * Lambda_11_11_p4787_lanes[0];
  const Real Lambda_0_0_p1 = Lambda_11_11_p4225_lanes[2] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3990_lanes[2];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p5064 = Lambda_11_11_p4967_lanes[2] + Lambda_11_11_p4173_lanes[2] *
      Lambda_11_11_p340_lanes[2] + Lambda_11_11_p4165_lanes[2] * Lambda_11_11_p469_lanes[2] +
      Lambda_11_11_p4157_lanes[2] * Lambda_11_11_p593_lanes[2] + Lambda_11_11_p4150_lanes[2] *
      Lambda_11_11_p685_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p5072_lanes = Lambda_11_11_p5053_lanes - Lambda_11_11_p3999_lanes *
      Lambda_11_11_p3846_lanes[1] - Lambda_11_11_p4235_lanes * Lambda_11_11_p4107_lanes[1] -
      Lambda_11_11_p4418_lanes * Lambda_11_11_p4342_lanes[1];
  const Lanes<8> Lambda_11_11_p5075_lanes = Lambda_11_11_p5031_lanes * Lambda_11_11_p5041;
  const Real Lambda_0_0_p2 = Lambda_11_11_p4225_lanes[3] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3990_lanes[3] - Lambda_11_11_p4413_lanes[3] * Lambda_0_0_p1;
  const Real Lambda_11_11_p5089 = Lambda_11_11_p5056 + Lambda_11_11_p2642_lanes[3] *
      Lambda_11_11_p1208_lanes[2] + Lambda_11_11_p2630_lanes[3] * Lambda_11_11_p1298_lanes[2] +
      Lambda_11_11_p2626_lanes[3] * Lambda_11_11_p1361_lanes[2] + Lambda_11_11_p1425_lanes[3] *
      Lambda_11_11_p1411_lanes[2];

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p5093 = Lambda_11_11_p5064 + Lambda_11_11_p4143_lanes[2] *
      Lambda_11_11_p795_lanes[2] + Lambda_11_11_p4139_lanes[2] * Lambda_11_11_p879_lanes[2] +
      Lambda_11_11_p2690_lanes[2] * Lambda_11_11_p1007_lanes[2] + Lambda_11_11_p2686_lanes[2] *
      Lambda_11_11_p1103_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p5094_lanes = Lambda_11_11_p5057_lanes - Lambda_11_11_p5000_lanes *
      Lambda_11_11_p4944_lanes[0] - Lambda_11_11_p5075_lanes * Lambda_11_11_p5031_lanes[0];
  const Lanes<8> Lambda_11_11_p5098_lanes = Lambda_11_11_p5072_lanes - Lambda_11_11_p4531_lanes *
      Lambda_11_11_p4480_lanes[1] - Lambda_11_11_p4681_lanes * Lambda_11_11_p4611_lanes[1] -
      Lambda_11_11_p4882_lanes * Lambda_11_11_p4787_lanes[1];
  const Real Lambda_0_0_p3 = Lambda_11_11_p4225_lanes[4] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3990_lanes[4] - Lambda_11_11_p4413_lanes[4] * Lambda_0_0_p1 -
      Lambda_11_11_p4527_lanes[4] * Lambda_0_0_p2;
  const Real Lambda_11_11_p5101 = 1.0 / Lambda_11_11_p5094_lanes[0];
  const Real Lambda_11_11_p5108 = Lambda_11_11_p5089 - Lambda_11_11_p3999_lanes[3] *
      Lambda_11_11_p3846_lanes[2] - Lambda_11_11_p4235_lanes[3] * Lambda_11_11_p4107_lanes[2] -
      Lambda_11_11_p4418_lanes[3] * Lambda_11_11_p4342_lanes[2] - Lambda_11_11_p4531_lanes[3] *
      Lambda_11_11_p4480_lanes[2];
  const Real Lambda_0_0_p4 = Lambda_11_11_p4225_lanes[5] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3990_lanes[5] - Lambda_11_11_p4413_lanes[5] * Lambda_0_0_p1 -
      Lambda_11_11_p4527_lanes[5] * Lambda_0_0_p2 - Lambda_11_11_p4678_lanes[5] * Lambda_0_0_p3;
  const Real Lambda_0_0_p5 = Lambda_11_11_p4225_lanes[6] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3990_lanes[6] - Lambda_11_11_p4413_lanes[6] * Lambda_0_0_p1 -
      Lambda_11_11_p4527_lanes[6] * Lambda_0_0_p2 - Lambda_11_11_p4678_lanes[6] * Lambda_0_0_p3;
  const Real Lambda_11_11_p5109 = Lambda_11_11_p5093 + Lambda_11_11_p2642_lanes[2] *
      Lambda_11_11_p1208_lanes[2] + Lambda_11_11_p2630_lanes[2] * Lambda_11_11_p1298_lanes[2] +
      Lambda_11_11_p2626_lanes[2] * Lambda_11_11_p1361_lanes[2] + Lambda_11_11_p1425_lanes[2] *
      Lambda_11_11_p1411_lanes[2];
  const Real Lambda_0_0_p6 = Lambda_11_11_p4225_lanes[7] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3990_lanes[7] - Lambda_11_11_p4413_lanes[7] * Lambda_0_0_p1 -
      Lambda_11_11_p4527_lanes[7] * Lambda_0_0_p2 - Lambda_11_11_p4678_lanes[7] * Lambda_0_0_p3;
  const Real Lambda_0_0_p7 = Lambda_11_11_p4235_lanes[0] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3999_lanes[0] - Lambda_11_11_p4418_lanes[0] * Lambda_0_0_p1 -
      Lambda_11_11_p4531_lanes[0] * Lambda_0_0_p2 - Lambda_11_11_p4681_lanes[0] * Lambda_0_0_p3;
  const Real Lambda_0_0_p8 = Lambda_0_0_p5 - Lambda_11_11_p4861 * Lambda_0_0_p4;
  const Lanes<8> Lambda_11_11_p5110_lanes = Lambda_11_11_p5094_lanes * Lambda_11_11_p5101;
  const Real Lambda_11_11_p5116 = Lambda_11_11_p5108 - Lambda_11_11_p4681_lanes[3] *
      Lambda_11_11_p4611_lanes[2] - Lambda_11_11_p4882_lanes[3] * Lambda_11_11_p4787_lanes[2] -
      Lambda_11_11_p5000_lanes[3] * Lambda_11_11_p4944_lanes[2] - Lambda_11_11_p5075_lanes[3] *
      Lambda_11_11_p5031_lanes[2];
  const Real Lambda_11_11_p5117 = Lambda_11_11_p5109 - Lambda_11_11_p3999_lanes[2] *
      Lambda_11_11_p3846_lanes[2] - Lambda_11_11_p4235_lanes[2] * Lambda_11_11_p4107_lanes[2] -
      Lambda_11_11_p4418_lanes[2] * Lambda_11_11_p4342_lanes[2] - Lambda_11_11_p4531_lanes[2] *
      Lambda_11_11_p4480_lanes[2];
  const Real Lambda_0_0_p9 = Lambda_0_0_p6 - Lambda_11_11_p4862 * Lambda_0_0_p4 -
      Lambda_11_11_p4999 * Lambda_0_0_p8;
  const Real Lambda_0_0_p10 = Lambda_11_11_p4235_lanes[1] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3999_lanes[1] - Lambda_11_11_p4418_lanes[1] * Lambda_0_0_p1 -
      Lambda_11_11_p4531_lanes[1] * Lambda_0_0_p2 - Lambda_11_11_p4681_lanes[1] * Lambda_0_0_p3;
  const Lanes<8> Lambda_11_11_p5118_lanes = Lambda_11_11_p5098_lanes - Lambda_11_11_p5000_lanes *
      Lambda_11_11_p4944_lanes[1] - Lambda_11_11_p5075_lanes * Lambda_11_11_p5031_lanes[1] -
      Lambda_11_11_p5110_lanes * Lambda_11_11_p5094_lanes[1];
  const Real Lambda_11_11_p5121 = 1.0 / Lambda_11_11_p5118_lanes[1];
  const Real Lambda_0_0_p11 = Lambda_11_11_p4235_lanes[2] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3999_lanes[2] - Lambda_11_11_p4418_lanes[2] * Lambda_0_0_p1 -
      Lambda_11_11_p4531_lanes[2] * Lambda_0_0_p2 - Lambda_11_11_p4681_lanes[2] * Lambda_0_0_p3;
  const Real Lambda_0_0_p12 = Lambda_0_0_p4 * Lambda_11_11_p4765;
  const Real Lambda_0_0_p13 = Lambda_0_0_p3 * Lambda_11_11_p4623;
  const Real Lambda_0_0_p14 = Lambda_0_0_p7 - Lambda_11_11_p4882_lanes[0] * Lambda_0_0_p4 -
      Lambda_11_11_p5000_lanes[0] * Lambda_0_0_p8 - Lambda_11_11_p5075_lanes[0] * Lambda_0_0_p9;
  const Real Lambda_0_0_p15 = Lambda_0_0_p2 * Lambda_11_11_p4488;
  const Real Lambda_0_0_p16 = Lambda_0_0_p1 * Lambda_11_11_p4362;
  const Real Lambda_0_0_p17 = Lambda_11_11_p3990_lanes[1] * Lambda_11_11_p4133;
  const Real Lambda_0_0_p18 = Lambda_0_0_p8 * Lambda_11_11_p4948;
  const Real Lambda_0_11_p1 = Lambda_11_11_p4235_lanes[3] * Lambda_11_11_p3990_lanes[1] -
      Lambda_11_11_p3999_lanes[3] - Lambda_11_11_p4418_lanes[3] * Lambda_0_0_p1 -
      Lambda_11_11_p4531_lanes[3] * Lambda_0_0_p2 - Lambda_11_11_p4681_lanes[3] * Lambda_0_0_p3;
  const Real Lambda_0_0_p19 = Lambda_0_0_p9 * Lambda_11_11_p5041;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p5122 = Lambda_11_11_p4389_lanes[1] + Lambda_11_11_p2690_lanes[3] *
      Lambda_11_11_p1007_lanes[3] + Lambda_11_11_p2686_lanes[3] * Lambda_11_11_p1103_lanes[3] +
      Lambda_11_11_p2642_lanes[3] * Lambda_11_11_p1208_lanes[3] + Lambda_11_11_p2630_lanes[3] *
      Lambda_11_11_p1298_lanes[3];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p5123 = Lambda_11_11_p5117 - Lambda_11_11_p4681_lanes[2] *
      Lambda_11_11_p4611_lanes[2] - Lambda_11_11_p4882_lanes[2] * Lambda_11_11_p4787_lanes[2] -
      Lambda_11_11_p5000_lanes[2] * Lambda_11_11_p4944_lanes[2] - Lambda_11_11_p5075_lanes[2] *
      Lambda_11_11_p5031_lanes[2];
  const Real Lambda_0_0_p20 = Lambda_0_0_p10 - Lambda_11_11_p4882_lanes[1] * Lambda_0_0_p4 -
      Lambda_11_11_p5000_lanes[1] * Lambda_0_0_p8 - Lambda_11_11_p5075_lanes[1] * Lambda_0_0_p9 -
      Lambda_11_11_p5110_lanes[1] * Lambda_0_0_p14;
  const Real Lambda_0_0_p21 = Lambda_0_0_p14 * Lambda_11_11_p5101;
  const Real Lambda_1_11_p1 = Lambda_11_11_p4413_lanes[3] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4225_lanes[3];
  const Real Lambda_11_11_p5124 = Lambda_11_11_p5118_lanes[2] * Lambda_11_11_p5121;
  const Real Lambda_11_11_p5125 = Lambda_11_11_p5118_lanes[3] * Lambda_11_11_p5121;
  const Real Lambda_0_0_p22 = Lambda_0_0_p11 - Lambda_11_11_p4882_lanes[2] * Lambda_0_0_p4 -
      Lambda_11_11_p5000_lanes[2] * Lambda_0_0_p8 - Lambda_11_11_p5075_lanes[2] * Lambda_0_0_p9 -
      Lambda_11_11_p5110_lanes[2] * Lambda_0_0_p14;
  const Real Lambda_0_0_p23 = Lambda_0_0_p20 * Lambda_11_11_p5121;
  const Real Lambda_1_11_p2 = Lambda_11_11_p4413_lanes[4] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4225_lanes[4] - Lambda_11_11_p4527_lanes[4] * Lambda_1_11_p1;
  const Real Lambda_11_11_p5126 = Lambda_11_11_p5122 + Lambda_11_11_p2626_lanes[3] *
      Lambda_11_11_p1361_lanes[3] + Lambda_11_11_p1425_lanes[3] * Lambda_11_11_p1411_lanes[3] -
      Lambda_11_11_p3999_lanes[3] * Lambda_11_11_p3846_lanes[3] - Lambda_11_11_p4235_lanes[3] *
      Lambda_11_11_p4107_lanes[3];
  const Real Lambda_0_0_p24 = Lambda_11_11_p3927 + Lambda_0_0_p17 * Lambda_11_11_p3990_lanes[1] +
      Lambda_0_0_p16 * Lambda_0_0_p1 + Lambda_0_0_p15 * Lambda_0_0_p2 + Lambda_0_0_p13 *
      Lambda_0_0_p3;
  const Real Lambda_11_11_p5127 = 1.0 / (Lambda_11_11_p5123 - Lambda_11_11_p5110_lanes[2] *
      Lambda_11_11_p5094_lanes[2] - Lambda_11_11_p5124 * Lambda_11_11_p5118_lanes[2]);
  const Real Lambda_11_11_p5128 = Lambda_11_11_p5116 - Lambda_11_11_p5110_lanes[3] *
      Lambda_11_11_p5094_lanes[2] - Lambda_11_11_p5125 * Lambda_11_11_p5118_lanes[2];
  const Real Lambda_0_0_p25 = Lambda_0_0_p22 - Lambda_11_11_p5124 * Lambda_0_0_p20;
  const Real Lambda_1_11_p3 = Lambda_11_11_p4413_lanes[5] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4225_lanes[5] - Lambda_11_11_p4527_lanes[5] * Lambda_1_11_p1 -
      Lambda_11_11_p4678_lanes[5] * Lambda_1_11_p2;
  const Real Lambda_0_11_p2 = Lambda_0_11_p1 - Lambda_11_11_p4882_lanes[3] * Lambda_0_0_p4 -
      Lambda_11_11_p5000_lanes[3] * Lambda_0_0_p8 - Lambda_11_11_p5075_lanes[3] * Lambda_0_0_p9 -
      Lambda_11_11_p5110_lanes[3] * Lambda_0_0_p14;
  const Real Lambda_11_11_p5129 = Lambda_11_11_p5126 - Lambda_11_11_p4418_lanes[3] *
      Lambda_11_11_p4342_lanes[3] - Lambda_11_11_p4531_lanes[3] * Lambda_11_11_p4480_lanes[3] -
      Lambda_11_11_p4681_lanes[3] * Lambda_11_11_p4611_lanes[3] - Lambda_11_11_p4882_lanes[3] *
      Lambda_11_11_p4787_lanes[3];
  const Real Lambda_1_11_p4 = Lambda_11_11_p4413_lanes[6] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4225_lanes[6] - Lambda_11_11_p4527_lanes[6] * Lambda_1_11_p1 -
      Lambda_11_11_p4678_lanes[6] * Lambda_1_11_p2 - Lambda_11_11_p4861 * Lambda_1_11_p3;
  const Real Lambda_1_11_p5 = Lambda_11_11_p4413_lanes[7] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4225_lanes[7] - Lambda_11_11_p4527_lanes[7] * Lambda_1_11_p1 -
      Lambda_11_11_p4678_lanes[7] * Lambda_1_11_p2 - Lambda_11_11_p4862 * Lambda_1_11_p3;
  const Real Lambda_1_11_p6 = Lambda_11_11_p4418_lanes[0] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4235_lanes[0] - Lambda_11_11_p4531_lanes[0] * Lambda_1_11_p1 -
      Lambda_11_11_p4681_lanes[0] * Lambda_1_11_p2 - Lambda_11_11_p4882_lanes[0] * Lambda_1_11_p3;
  const Real Lambda_1_11_p7 = Lambda_11_11_p4418_lanes[1] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4235_lanes[1] - Lambda_11_11_p4531_lanes[1] * Lambda_1_11_p1 -
      Lambda_11_11_p4681_lanes[1] * Lambda_1_11_p2 - Lambda_11_11_p4882_lanes[1] * Lambda_1_11_p3;
  const Real Lambda_0_1_p1 = Lambda_1_11_p3 * Lambda_11_11_p4765;
  const Real Lambda_0_1_p2 = Lambda_1_11_p2 * Lambda_11_11_p4623;
  const Real Lambda_0_1_p3 = Lambda_1_11_p1 * Lambda_11_11_p4488;
  const Real Lambda_0_1_p4 = Lambda_11_11_p4225_lanes[2] * Lambda_11_11_p4362;
  const Real Lambda_1_11_p8 = Lambda_11_11_p4418_lanes[2] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4235_lanes[2] - Lambda_11_11_p4531_lanes[2] * Lambda_1_11_p1 -
      Lambda_11_11_p4681_lanes[2] * Lambda_1_11_p2 - Lambda_11_11_p4882_lanes[2] * Lambda_1_11_p3;
  const Real Lambda_0_1_p5 = Lambda_1_11_p4 * Lambda_11_11_p4948;
  const Real Lambda_11_11_p5130 = Lambda_11_11_p5128 * Lambda_11_11_p5127;
  const Real Lambda_0_0_p26 = Lambda_0_0_p25 * Lambda_11_11_p5127;
  const Real Lambda_1_11_p9 = Lambda_1_11_p5 - Lambda_11_11_p4999 * Lambda_1_11_p4;
  const Real Lambda_1_11_p10 = Lambda_11_11_p4418_lanes[3] * Lambda_11_11_p4225_lanes[2] -
      Lambda_11_11_p4235_lanes[3] - Lambda_11_11_p4531_lanes[3] * Lambda_1_11_p1 -
      Lambda_11_11_p4681_lanes[3] * Lambda_1_11_p2 - Lambda_11_11_p4882_lanes[3] * Lambda_1_11_p3;
  const Real Lambda_2_11_p1 = Lambda_11_11_p4527_lanes[4] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4413_lanes[4];
  const Real Lambda_11_11_p5131 = Lambda_11_11_p5129 - Lambda_11_11_p5000_lanes[3] *
      Lambda_11_11_p4944_lanes[3] - Lambda_11_11_p5075_lanes[3] * Lambda_11_11_p5031_lanes[3] -
      Lambda_11_11_p5110_lanes[3] * Lambda_11_11_p5094_lanes[3] - Lambda_11_11_p5125 *
      Lambda_11_11_p5118_lanes[3];
  const Real Lambda_1_11_p11 = Lambda_1_11_p6 - Lambda_11_11_p5000_lanes[0] * Lambda_1_11_p4 -
      Lambda_11_11_p5075_lanes[0] * Lambda_1_11_p9;
  const Real Lambda_0_1_p6 = Lambda_1_11_p9 * Lambda_11_11_p5041;
  const Real Lambda_0_11_p3 = Lambda_0_11_p2 - Lambda_11_11_p5125 * Lambda_0_0_p20 -
      Lambda_11_11_p5130 * Lambda_0_0_p25;
  const Real Lambda_2_11_p2 = Lambda_11_11_p4527_lanes[5] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4413_lanes[5] - Lambda_11_11_p4678_lanes[5] * Lambda_2_11_p1;
  const Real Lambda_11_11 = 1.0 / (Lambda_11_11_p5131 - Lambda_11_11_p5130 * Lambda_11_11_p5128);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_1_11_p12 = Lambda_1_11_p7 - Lambda_11_11_p5000_lanes[1] * Lambda_1_11_p4 -
      Lambda_11_11_p5075_lanes[1] * Lambda_1_11_p9 - Lambda_11_11_p5110_lanes[1] * Lambda_1_11_p11;
  const Real Lambda_0_1_p7 = Lambda_0_1_p3 * Lambda_0_0_p2 -
      (Lambda_0_0_p17 + Lambda_0_1_p4 * Lambda_0_0_p1) + Lambda_0_1_p2 * Lambda_0_0_p3 +
      Lambda_0_1_p1 * Lambda_0_0_p4;
  const Real Lambda_0_1_p8 = Lambda_1_11_p11 * Lambda_11_11_p5101;
  const Real Lambda_2_11_p3 = Lambda_11_11_p4527_lanes[6] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4413_lanes[6] - Lambda_11_11_p4678_lanes[6] * Lambda_2_11_p1 -
      Lambda_11_11_p4861 * Lambda_2_11_p2;
  const Real Lambda_0_1_p9 = Lambda_1_11_p12 * Lambda_11_11_p5121;
  const Real Lambda_0_0_p27 = Lambda_0_0_p24 + Lambda_0_0_p12 * Lambda_0_0_p4 + Lambda_0_0_p18 *
      Lambda_0_0_p8 + Lambda_0_0_p19 * Lambda_0_0_p9 + Lambda_0_0_p21 * Lambda_0_0_p14;
  const Real Lambda_0_2_p1 = Lambda_11_11_p4413_lanes[3] * Lambda_11_11_p4488;
  const Real Lambda_0_2_p2 = Lambda_2_11_p1 * Lambda_11_11_p4623;
  const Real Lambda_0_2_p3 = Lambda_2_11_p2 * Lambda_11_11_p4765;
  const Real Lambda_0_2_p4 = Lambda_2_11_p3 * Lambda_11_11_p4948;
  const Real Lambda_1_11_p13 = Lambda_1_11_p8 - Lambda_11_11_p5000_lanes[2] * Lambda_1_11_p4 -
      Lambda_11_11_p5075_lanes[2] * Lambda_1_11_p9 - Lambda_11_11_p5110_lanes[2] * Lambda_1_11_p11 -
      Lambda_11_11_p5124 * Lambda_1_11_p12;
  const Real Lambda_1_11_p14 = Lambda_1_11_p10 - Lambda_11_11_p5000_lanes[3] * Lambda_1_11_p4 -
      Lambda_11_11_p5075_lanes[3] * Lambda_1_11_p9 - Lambda_11_11_p5110_lanes[3] * Lambda_1_11_p11 -
      Lambda_11_11_p5125 * Lambda_1_11_p12;
  const Real Lambda_2_11_p4 = Lambda_11_11_p4527_lanes[7] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4413_lanes[7] - Lambda_11_11_p4678_lanes[7] * Lambda_2_11_p1 -
      Lambda_11_11_p4862 * Lambda_2_11_p2 - Lambda_11_11_p4999 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_11_11_p4531_lanes[0] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4418_lanes[0] - Lambda_11_11_p4681_lanes[0] * Lambda_2_11_p1 -
      Lambda_11_11_p4882_lanes[0] * Lambda_2_11_p2 - Lambda_11_11_p5000_lanes[0] * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_11_11_p4531_lanes[1] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4418_lanes[1] - Lambda_11_11_p4681_lanes[1] * Lambda_2_11_p1 -
      Lambda_11_11_p4882_lanes[1] * Lambda_2_11_p2 - Lambda_11_11_p5000_lanes[1] * Lambda_2_11_p3;
  const Real Lambda_2_11_p7 = Lambda_11_11_p4531_lanes[2] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4418_lanes[2] - Lambda_11_11_p4681_lanes[2] * Lambda_2_11_p1 -
      Lambda_11_11_p4882_lanes[2] * Lambda_2_11_p2 - Lambda_11_11_p5000_lanes[2] * Lambda_2_11_p3;
  const Real Lambda_3_11_p1 = Lambda_11_11_p4678_lanes[5] * Lambda_11_11_p4527_lanes[4] -
      Lambda_11_11_p4527_lanes[5];
  const Real Lambda_2_11_p8 = Lambda_11_11_p4531_lanes[3] * Lambda_11_11_p4413_lanes[3] -
      Lambda_11_11_p4418_lanes[3] - Lambda_11_11_p4681_lanes[3] * Lambda_2_11_p1 -
      Lambda_11_11_p4882_lanes[3] * Lambda_2_11_p2 - Lambda_11_11_p5000_lanes[3] * Lambda_2_11_p3;
  const Real Lambda_0_2_p5 = Lambda_2_11_p4 * Lambda_11_11_p5041;
  const Real Lambda_0_1_p10 = Lambda_1_11_p13 * Lambda_11_11_p5127;
  const Real Lambda_0_11 = Lambda_0_11_p3 * Lambda_11_11;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_2_11_p9 = Lambda_2_11_p5 - Lambda_11_11_p5075_lanes[0] * Lambda_2_11_p4;
  const Real Lambda_1_11_p15 = Lambda_1_11_p14 - Lambda_11_11_p5130 * Lambda_1_11_p13;
  const Real Lambda_3_11_p2 = Lambda_11_11_p4678_lanes[6] * Lambda_11_11_p4527_lanes[4] -
      Lambda_11_11_p4527_lanes[6] - Lambda_11_11_p4861 * Lambda_3_11_p1;
  const Real Lambda_0_2_p6 = Lambda_2_11_p9 * Lambda_11_11_p5101;
  const Real Lambda_1_11 = Lambda_1_11_p15 * Lambda_11_11;
  Lambda[23] = Lambda_1_11;
  Lambda[133] = Lambda_1_11;
  const Real Lambda_2_11_p10 = Lambda_2_11_p6 - Lambda_11_11_p5075_lanes[1] * Lambda_2_11_p4 -
      Lambda_11_11_p5110_lanes[1] * Lambda_2_11_p9;
  const Real Lambda_0_3_p1 = Lambda_3_11_p2 * Lambda_11_11_p4948;
  const Real Lambda_0_3_p2 = Lambda_3_11_p1 * Lambda_11_11_p4765;
  const Real Lambda_0_3_p3 = Lambda_11_11_p4527_lanes[4] * Lambda_11_11_p4623;
  const Real Lambda_0_2_p7 = Lambda_0_0_p16 - Lambda_0_2_p1 * Lambda_0_0_p2 + Lambda_0_2_p2 *
      Lambda_0_0_p3 + Lambda_0_2_p3 * Lambda_0_0_p4 + Lambda_0_2_p4 * Lambda_0_0_p8;
  const Real Lambda_3_11_p3 = Lambda_11_11_p4678_lanes[7] * Lambda_11_11_p4527_lanes[4] -
      Lambda_11_11_p4527_lanes[7] - Lambda_11_11_p4862 * Lambda_3_11_p1 - Lambda_11_11_p4999 *
      Lambda_3_11_p2;
  const Real Lambda_0_2_p8 = Lambda_2_11_p10 * Lambda_11_11_p5121;
  const Real Lambda_0_3_p4 = Lambda_3_11_p3 * Lambda_11_11_p5041;
  const Real Lambda_2_11_p11 = Lambda_2_11_p7 - Lambda_11_11_p5075_lanes[2] * Lambda_2_11_p4 -
      Lambda_11_11_p5110_lanes[2] * Lambda_2_11_p9 - Lambda_11_11_p5124 * Lambda_2_11_p10;
  const Real Lambda_4_11_p1 = Lambda_11_11_p4861 * Lambda_11_11_p4678_lanes[5] -
      Lambda_11_11_p4678_lanes[6];
  const Real Lambda_3_11_p4 = Lambda_11_11_p4681_lanes[0] * Lambda_11_11_p4527_lanes[4] -
      Lambda_11_11_p4531_lanes[0] - Lambda_11_11_p4882_lanes[0] * Lambda_3_11_p1 -
      Lambda_11_11_p5000_lanes[0] * Lambda_3_11_p2 - Lambda_11_11_p5075_lanes[0] * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_11_11_p4681_lanes[1] * Lambda_11_11_p4527_lanes[4] -
      Lambda_11_11_p4531_lanes[1] - Lambda_11_11_p4882_lanes[1] * Lambda_3_11_p1 -
      Lambda_11_11_p5000_lanes[1] * Lambda_3_11_p2 - Lambda_11_11_p5075_lanes[1] * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_11_11_p4681_lanes[2] * Lambda_11_11_p4527_lanes[4] -
      Lambda_11_11_p4531_lanes[2] - Lambda_11_11_p4882_lanes[2] * Lambda_3_11_p1 -
      Lambda_11_11_p5000_lanes[2] * Lambda_3_11_p2 - Lambda_11_11_p5075_lanes[2] * Lambda_3_11_p3;
  const Real Lambda_3_11_p7 = Lambda_11_11_p4681_lanes[3] * Lambda_11_11_p4527_lanes[4] -
      Lambda_11_11_p4531_lanes[3] - Lambda_11_11_p4882_lanes[3] * Lambda_3_11_p1 -
      Lambda_11_11_p5000_lanes[3] * Lambda_3_11_p2 - Lambda_11_11_p5075_lanes[3] * Lambda_3_11_p3;
  const Real Lambda_0_3_p5 = Lambda_3_11_p4 * Lambda_11_11_p5101;
  const Real Lambda_2_11_p12 = Lambda_2_11_p8 - Lambda_11_11_p5075_lanes[3] * Lambda_2_11_p4 -
      Lambda_11_11_p5110_lanes[3] * Lambda_2_11_p9 - Lambda_11_11_p5125 * Lambda_2_11_p10 -
      Lambda_11_11_p5130 * Lambda_2_11_p11;
  const Real Lambda_0_2_p9 = Lambda_2_11_p11 * Lambda_11_11_p5127;
  const Real Lambda_4_11_p2 = Lambda_11_11_p4862 * Lambda_11_11_p4678_lanes[5] -
      Lambda_11_11_p4678_lanes[7] - Lambda_11_11_p4999 * Lambda_4_11_p1;
  const Real Lambda_3_11_p8 = Lambda_3_11_p5 - Lambda_11_11_p5110_lanes[1] * Lambda_3_11_p4;
  const Real Lambda_0_1_p11 = Lambda_0_1_p7 + Lambda_0_1_p5 * Lambda_0_0_p8 + Lambda_0_1_p6 *
      Lambda_0_0_p9 + Lambda_0_1_p8 * Lambda_0_0_p14 + Lambda_0_1_p9 * Lambda_0_0_p20;
  const Real Lambda_0_4_p1 = Lambda_4_11_p1 * Lambda_11_11_p4948;
  const Real Lambda_0_4_p2 = Lambda_11_11_p4678_lanes[5] * Lambda_11_11_p4765;
  const Real Lambda_0_4_p3 = Lambda_4_11_p2 * Lambda_11_11_p5041;
  const Real Lambda_0_3_p6 = Lambda_3_11_p8 * Lambda_11_11_p5121;
  const Real Lambda_4_11_p3 = Lambda_11_11_p4882_lanes[0] * Lambda_11_11_p4678_lanes[5] -
      Lambda_11_11_p4681_lanes[0] - Lambda_11_11_p5000_lanes[0] * Lambda_4_11_p1 -
      Lambda_11_11_p5075_lanes[0] * Lambda_4_11_p2;
  const Real Lambda_5_11_p1 = Lambda_11_11_p4999 * Lambda_11_11_p4861 - Lambda_11_11_p4862;
  const Real Lambda_3_11_p9 = Lambda_3_11_p6 - Lambda_11_11_p5110_lanes[2] * Lambda_3_11_p4 -
      Lambda_11_11_p5124 * Lambda_3_11_p8;
  const Real Lambda_0_3_p7 = Lambda_0_0_p15 - Lambda_0_3_p3 * Lambda_0_0_p3 + Lambda_0_3_p2 *
      Lambda_0_0_p4 + Lambda_0_3_p1 * Lambda_0_0_p8 + Lambda_0_3_p4 * Lambda_0_0_p9;
  const Real Lambda_0_4_p4 = Lambda_4_11_p3 * Lambda_11_11_p5101;
  const Real Lambda_0_3_p8 = Lambda_3_11_p9 * Lambda_11_11_p5127;
  const Real Lambda_2_11 = Lambda_2_11_p12 * Lambda_11_11;
  Lambda[35] = Lambda_2_11;
  Lambda[134] = Lambda_2_11;
  const Real Lambda_4_11_p4 = Lambda_11_11_p4882_lanes[1] * Lambda_11_11_p4678_lanes[5] -
      Lambda_11_11_p4681_lanes[1] - Lambda_11_11_p5000_lanes[1] * Lambda_4_11_p1 -
      Lambda_11_11_p5075_lanes[1] * Lambda_4_11_p2 - Lambda_11_11_p5110_lanes[1] * Lambda_4_11_p3;
  const Real Lambda_4_11_p5 = Lambda_11_11_p4882_lanes[2] * Lambda_11_11_p4678_lanes[5] -
      Lambda_11_11_p4681_lanes[2] - Lambda_11_11_p5000_lanes[2] * Lambda_4_11_p1 -
      Lambda_11_11_p5075_lanes[2] * Lambda_4_11_p2 - Lambda_11_11_p5110_lanes[2] * Lambda_4_11_p3;
  const Real Lambda_0_5_p1 = Lambda_11_11_p4861 * Lambda_11_11_p4948;
  const Real Lambda_5_11_p2 = Lambda_11_11_p5000_lanes[0] * Lambda_11_11_p4861 -
      Lambda_11_11_p4882_lanes[0] - Lambda_11_11_p5075_lanes[0] * Lambda_5_11_p1;
  const Real Lambda_0_5_p2 = Lambda_5_11_p1 * Lambda_11_11_p5041;
  const Real Lambda_4_11_p6 = Lambda_11_11_p4882_lanes[3] * Lambda_11_11_p4678_lanes[5] -
      Lambda_11_11_p4681_lanes[3] - Lambda_11_11_p5000_lanes[3] * Lambda_4_11_p1 -
      Lambda_11_11_p5075_lanes[3] * Lambda_4_11_p2 - Lambda_11_11_p5110_lanes[3] * Lambda_4_11_p3;
  const Real Lambda_0_5_p3 = Lambda_5_11_p2 * Lambda_11_11_p5101;
  const Real Lambda_0_4_p5 = Lambda_4_11_p4 * Lambda_11_11_p5121;
  const Real Lambda_6_11_p1 = Lambda_11_11_p5075_lanes[0] * Lambda_11_11_p4999 -
      Lambda_11_11_p5000_lanes[0];
  const Real Lambda_3_11_p10 = Lambda_3_11_p7 - Lambda_11_11_p5110_lanes[3] * Lambda_3_11_p4 -
      Lambda_11_11_p5125 * Lambda_3_11_p8 - Lambda_11_11_p5130 * Lambda_3_11_p9;
  const Real Lambda_4_11_p7 = Lambda_4_11_p5 - Lambda_11_11_p5124 * Lambda_4_11_p4;
  const Real Lambda_5_11_p3 = Lambda_11_11_p5000_lanes[1] * Lambda_11_11_p4861 -
      Lambda_11_11_p4882_lanes[1] - Lambda_11_11_p5075_lanes[1] * Lambda_5_11_p1 -
      Lambda_11_11_p5110_lanes[1] * Lambda_5_11_p2;
  const Real Lambda_0_6_p1 = Lambda_11_11_p4999 * Lambda_11_11_p5041;
  const Real Lambda_0_6_p2 = Lambda_6_11_p1 * Lambda_11_11_p5101;
  const Real Lambda_0_5_p4 = Lambda_5_11_p3 * Lambda_11_11_p5121;
  const Real Lambda_0_4_p6 = Lambda_4_11_p7 * Lambda_11_11_p5127;
  const Real Lambda_6_11_p2 = Lambda_11_11_p5075_lanes[1] * Lambda_11_11_p4999 -
      Lambda_11_11_p5000_lanes[1] - Lambda_11_11_p5110_lanes[1] * Lambda_6_11_p1;
  const Real Lambda_4_11_p8 = Lambda_4_11_p6 - Lambda_11_11_p5125 * Lambda_4_11_p4 -
      Lambda_11_11_p5130 * Lambda_4_11_p7;
  const Real Lambda_7_11_p1 = Lambda_11_11_p5110_lanes[1] * Lambda_11_11_p5075_lanes[0] -
      Lambda_11_11_p5075_lanes[1];
  const Real Lambda_5_11_p4 = Lambda_11_11_p5000_lanes[2] * Lambda_11_11_p4861 -
      Lambda_11_11_p4882_lanes[2] - Lambda_11_11_p5075_lanes[2] * Lambda_5_11_p1 -
      Lambda_11_11_p5110_lanes[2] * Lambda_5_11_p2 - Lambda_11_11_p5124 * Lambda_5_11_p3;
  const Real Lambda_5_11_p5 = Lambda_11_11_p5000_lanes[3] * Lambda_11_11_p4861 -
      Lambda_11_11_p4882_lanes[3] - Lambda_11_11_p5075_lanes[3] * Lambda_5_11_p1 -
      Lambda_11_11_p5110_lanes[3] * Lambda_5_11_p2 - Lambda_11_11_p5125 * Lambda_5_11_p3;
  const Real Lambda_0_7_p1 = Lambda_11_11_p5075_lanes[0] * Lambda_11_11_p5101;
  const Real Lambda_0_6_p3 = Lambda_6_11_p2 * Lambda_11_11_p5121;
  const Real Lambda_0_4_p7 = Lambda_0_0_p13 - Lambda_0_4_p2 * Lambda_0_0_p4 + Lambda_0_4_p1 *
      Lambda_0_0_p8 + Lambda_0_4_p3 * Lambda_0_0_p9 + Lambda_0_4_p4 * Lambda_0_0_p14;
  const Real Lambda_0_7_p2 = Lambda_7_11_p1 * Lambda_11_11_p5121;
  const Real Lambda_0_5_p5 = Lambda_5_11_p4 * Lambda_11_11_p5127;
  const Real Lambda_6_11_p3 = Lambda_11_11_p5075_lanes[2] * Lambda_11_11_p4999 -
      Lambda_11_11_p5000_lanes[2] - Lambda_11_11_p5110_lanes[2] * Lambda_6_11_p1 -
      Lambda_11_11_p5124 * Lambda_6_11_p2;
  const Real Lambda_0_8_p1 = Lambda_11_11_p5110_lanes[1] * Lambda_11_11_p5121;
  const Real Lambda_8_11_p1 = Lambda_11_11_p5124 * Lambda_11_11_p5110_lanes[1] -
      Lambda_11_11_p5110_lanes[2];
  const Real Lambda_3_11 = Lambda_3_11_p10 * Lambda_11_11;
  Lambda[47] = Lambda_3_11;
  Lambda[135] = Lambda_3_11;
  const Real Lambda_7_11_p2 = Lambda_11_11_p5110_lanes[2] * Lambda_11_11_p5075_lanes[0] -
      Lambda_11_11_p5075_lanes[2] - Lambda_11_11_p5124 * Lambda_7_11_p1;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_11_11_p5130 * Lambda_5_11_p4;
  const Real Lambda_0_6_p4 = Lambda_6_11_p3 * Lambda_11_11_p5127;
  const Real Lambda_0_9_p1 = Lambda_11_11_p5124 * Lambda_11_11_p5127;
  const Real Lambda_0_8_p2 = Lambda_8_11_p1 * Lambda_11_11_p5127;
  const Real Lambda_0_7_p3 = Lambda_7_11_p2 * Lambda_11_11_p5127;
  const Real Lambda_6_11_p4 = Lambda_11_11_p5075_lanes[3] * Lambda_11_11_p4999 -
      Lambda_11_11_p5000_lanes[3] - Lambda_11_11_p5110_lanes[3] * Lambda_6_11_p1 -
      Lambda_11_11_p5125 * Lambda_6_11_p2 - Lambda_11_11_p5130 * Lambda_6_11_p3;
  const Real Lambda_9_11_p1 = Lambda_11_11_p5130 * Lambda_11_11_p5124 - Lambda_11_11_p5125;
  const Real Lambda_8_11_p2 = Lambda_11_11_p5125 * Lambda_11_11_p5110_lanes[1] -
      Lambda_11_11_p5110_lanes[3] - Lambda_11_11_p5130 * Lambda_8_11_p1;
  const Real Lambda_4_11 = Lambda_4_11_p8 * Lambda_11_11;
  Lambda[59] = Lambda_4_11;
  Lambda[136] = Lambda_4_11;
  const Real Lambda_5_11 = Lambda_5_11_p6 * Lambda_11_11;
  Lambda[71] = Lambda_5_11;
  Lambda[137] = Lambda_5_11;
  const Real Lambda_10_11 = Lambda_11_11_p5130 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real Lambda_7_11_p3 = Lambda_11_11_p5110_lanes[3] * Lambda_11_11_p5075_lanes[0] -
      Lambda_11_11_p5075_lanes[3] - Lambda_11_11_p5125 * Lambda_7_11_p1 - Lambda_11_11_p5130 *
      Lambda_7_11_p2;
  const Real Lambda_6_11 = Lambda_6_11_p4 * Lambda_11_11;
  Lambda[83] = Lambda_6_11;
  Lambda[138] = Lambda_6_11;
  const Real Lambda_8_11 = Lambda_8_11_p2 * Lambda_11_11;
  Lambda[107] = Lambda_8_11;
  Lambda[140] = Lambda_8_11;
  const Real Lambda_9_11 = Lambda_9_11_p1 * Lambda_11_11;
  Lambda[119] = Lambda_9_11;
  Lambda[141] = Lambda_9_11;
  const Real Lambda_7_11 = Lambda_7_11_p3 * Lambda_11_11;
  Lambda[95] = Lambda_7_11;
  Lambda[139] = Lambda_7_11;
  const Real Lambda_1_1_p1 = Lambda_11_11_p4133 + Lambda_0_1_p4 * Lambda_11_11_p4225_lanes[2] +
      Lambda_0_1_p3 * Lambda_1_11_p1 + Lambda_0_1_p2 * Lambda_1_11_p2 + Lambda_0_1_p1 *
      Lambda_1_11_p3;
  const Real Lambda_0_5_p6 = Lambda_0_0_p12 - Lambda_0_5_p1 * Lambda_0_0_p8 + Lambda_0_5_p2 *
      Lambda_0_0_p9 + Lambda_0_5_p3 * Lambda_0_0_p14 + Lambda_0_5_p4 * Lambda_0_0_p20;
  const Real Lambda_1_2_p1 = Lambda_0_2_p2 * Lambda_1_11_p2 -
      (Lambda_0_1_p4 + Lambda_0_2_p1 * Lambda_1_11_p1) + Lambda_0_2_p3 * Lambda_1_11_p3 +
      Lambda_0_2_p4 * Lambda_1_11_p4;
  const Real Lambda_1_3_p1 = Lambda_0_1_p3 - Lambda_0_3_p3 * Lambda_1_11_p2 + Lambda_0_3_p2 *
      Lambda_1_11_p3 + Lambda_0_3_p1 * Lambda_1_11_p4 + Lambda_0_3_p4 * Lambda_1_11_p9;
  const Real Lambda_1_1_p2 = Lambda_1_1_p1 + Lambda_0_1_p5 * Lambda_1_11_p4 + Lambda_0_1_p6 *
      Lambda_1_11_p9 + Lambda_0_1_p8 * Lambda_1_11_p11 + Lambda_0_1_p9 * Lambda_1_11_p12;
  const Real Lambda_1_4_p1 = Lambda_0_1_p2 - Lambda_0_4_p2 * Lambda_1_11_p3 + Lambda_0_4_p1 *
      Lambda_1_11_p4 + Lambda_0_4_p3 * Lambda_1_11_p9 + Lambda_0_4_p4 * Lambda_1_11_p11;
  const Real Lambda_1_5_p1 = Lambda_0_1_p1 - Lambda_0_5_p1 * Lambda_1_11_p4 + Lambda_0_5_p2 *
      Lambda_1_11_p9 + Lambda_0_5_p3 * Lambda_1_11_p11 + Lambda_0_5_p4 * Lambda_1_11_p12;
  const Real Lambda_2_2_p1 = Lambda_11_11_p4362 + Lambda_0_2_p1 * Lambda_11_11_p4413_lanes[3] +
      Lambda_0_2_p2 * Lambda_2_11_p1 + Lambda_0_2_p3 * Lambda_2_11_p2 + Lambda_0_2_p4 *
      Lambda_2_11_p3;
  const Real Lambda_2_3_p1 = Lambda_0_3_p2 * Lambda_2_11_p2 -
      (Lambda_0_2_p1 + Lambda_0_3_p3 * Lambda_2_11_p1) + Lambda_0_3_p1 * Lambda_2_11_p3 +
      Lambda_0_3_p4 * Lambda_2_11_p4;
  const Real Lambda_0_2_p10 = Lambda_0_2_p7 + Lambda_0_2_p5 * Lambda_0_0_p9 + Lambda_0_2_p6 *
      Lambda_0_0_p14 + Lambda_0_2_p8 * Lambda_0_0_p20 + Lambda_0_2_p9 * Lambda_0_0_p25;
  const Real Lambda_2_4_p1 = Lambda_0_2_p2 - Lambda_0_4_p2 * Lambda_2_11_p2 + Lambda_0_4_p1 *
      Lambda_2_11_p3 + Lambda_0_4_p3 * Lambda_2_11_p4 + Lambda_0_4_p4 * Lambda_2_11_p9;
  const Real Lambda_2_5_p1 = Lambda_0_2_p3 - Lambda_0_5_p1 * Lambda_2_11_p3 + Lambda_0_5_p2 *
      Lambda_2_11_p4 + Lambda_0_5_p3 * Lambda_2_11_p9 + Lambda_0_5_p4 * Lambda_2_11_p10;
  const Real Lambda_0_6_p5 = Lambda_0_0_p18 - Lambda_0_6_p1 * Lambda_0_0_p9 + Lambda_0_6_p2 *
      Lambda_0_0_p14 + Lambda_0_6_p3 * Lambda_0_0_p20 + Lambda_0_6_p4 * Lambda_0_0_p25;
  const Real Lambda_1_2_p2 = Lambda_1_2_p1 + Lambda_0_2_p5 * Lambda_1_11_p9 + Lambda_0_2_p6 *
      Lambda_1_11_p11 + Lambda_0_2_p8 * Lambda_1_11_p12 + Lambda_0_2_p9 * Lambda_1_11_p13;
  const Real Lambda_3_3_p1 = Lambda_11_11_p4488 + Lambda_0_3_p3 * Lambda_11_11_p4527_lanes[4] +
      Lambda_0_3_p2 * Lambda_3_11_p1 + Lambda_0_3_p1 * Lambda_3_11_p2 + Lambda_0_3_p4 *
      Lambda_3_11_p3;
  const Real Lambda_1_6_p1 = Lambda_0_1_p5 - Lambda_0_6_p1 * Lambda_1_11_p9 + Lambda_0_6_p2 *
      Lambda_1_11_p11 + Lambda_0_6_p3 * Lambda_1_11_p12 + Lambda_0_6_p4 * Lambda_1_11_p13;
  const Real Lambda_3_4_p1 = Lambda_0_4_p1 * Lambda_3_11_p2 -
      (Lambda_0_3_p3 + Lambda_0_4_p2 * Lambda_3_11_p1) + Lambda_0_4_p3 * Lambda_3_11_p3 +
      Lambda_0_4_p4 * Lambda_3_11_p4;
  const Real Lambda_3_5_p1 = Lambda_0_3_p2 - Lambda_0_5_p1 * Lambda_3_11_p2 + Lambda_0_5_p2 *
      Lambda_3_11_p3 + Lambda_0_5_p3 * Lambda_3_11_p4 + Lambda_0_5_p4 * Lambda_3_11_p8;
  const Real Lambda_2_2_p2 = Lambda_2_2_p1 + Lambda_0_2_p5 * Lambda_2_11_p4 + Lambda_0_2_p6 *
      Lambda_2_11_p9 + Lambda_0_2_p8 * Lambda_2_11_p10 + Lambda_0_2_p9 * Lambda_2_11_p11;
  const Real Lambda_2_6_p1 = Lambda_0_2_p4 - Lambda_0_6_p1 * Lambda_2_11_p4 + Lambda_0_6_p2 *
      Lambda_2_11_p9 + Lambda_0_6_p3 * Lambda_2_11_p10 + Lambda_0_6_p4 * Lambda_2_11_p11;
  const Real Lambda_4_4_p1 = Lambda_11_11_p4623 + Lambda_0_4_p2 * Lambda_11_11_p4678_lanes[5] +
      Lambda_0_4_p1 * Lambda_4_11_p1 + Lambda_0_4_p3 * Lambda_4_11_p2 + Lambda_0_4_p4 *
      Lambda_4_11_p3;
  const Real Lambda_4_5_p1 = Lambda_0_5_p2 * Lambda_4_11_p2 -
      (Lambda_0_4_p2 + Lambda_0_5_p1 * Lambda_4_11_p1) + Lambda_0_5_p3 * Lambda_4_11_p3 +
      Lambda_0_5_p4 * Lambda_4_11_p4;
  const Real Lambda_3_6_p1 = Lambda_0_3_p1 - Lambda_0_6_p1 * Lambda_3_11_p3 + Lambda_0_6_p2 *
      Lambda_3_11_p4 + Lambda_0_6_p3 * Lambda_3_11_p8 + Lambda_0_6_p4 * Lambda_3_11_p9;
  const Real Lambda_4_6_p1 = Lambda_0_4_p1 - Lambda_0_6_p1 * Lambda_4_11_p2 + Lambda_0_6_p2 *
      Lambda_4_11_p3 + Lambda_0_6_p3 * Lambda_4_11_p4 + Lambda_0_6_p4 * Lambda_4_11_p7;
  const Real Lambda_5_5_p1 = Lambda_11_11_p4765 + Lambda_0_5_p1 * Lambda_11_11_p4861 +
      Lambda_0_5_p2 * Lambda_5_11_p1 + Lambda_0_5_p3 * Lambda_5_11_p2 + Lambda_0_5_p4 *
      Lambda_5_11_p3;
  Lambda[0] = Lambda_0_0_p27 + Lambda_0_0_p23 * Lambda_0_0_p20 + Lambda_0_0_p26 * Lambda_0_0_p25 +
      Lambda_0_11 * Lambda_0_11_p3;
  const Real Lambda_5_6_p1 = Lambda_0_6_p2 * Lambda_5_11_p2 -
      (Lambda_0_5_p1 + Lambda_0_6_p1 * Lambda_5_11_p1) + Lambda_0_6_p3 * Lambda_5_11_p3 +
      Lambda_0_6_p4 * Lambda_5_11_p4;
  const Real Lambda_0_1 = Lambda_0_1_p11 + Lambda_0_1_p10 * Lambda_0_0_p25 + Lambda_1_11 *
      Lambda_0_11_p3;
  Lambda[1] = Lambda_0_1;
  Lambda[12] = Lambda_0_1;
  const Real Lambda_0_2 = Lambda_0_2_p10 + Lambda_2_11 * Lambda_0_11_p3;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_6_6_p1 = Lambda_11_11_p4948 + Lambda_0_6_p1 * Lambda_11_11_p4999 +
      Lambda_0_6_p2 * Lambda_6_11_p1 + Lambda_0_6_p3 * Lambda_6_11_p2 + Lambda_0_6_p4 *
      Lambda_6_11_p3;
  const Real Lambda_0_3 = Lambda_0_3_p7 + Lambda_0_3_p5 * Lambda_0_0_p14 + Lambda_0_3_p6 *
      Lambda_0_0_p20 + Lambda_0_3_p8 * Lambda_0_0_p25 + Lambda_3_11 * Lambda_0_11_p3;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_0_4 = Lambda_0_4_p7 + Lambda_0_4_p5 * Lambda_0_0_p20 + Lambda_0_4_p6 *
      Lambda_0_0_p25 + Lambda_4_11 * Lambda_0_11_p3;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_0_5 = Lambda_0_5_p6 + Lambda_0_5_p5 * Lambda_0_0_p25 + Lambda_5_11 *
      Lambda_0_11_p3;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_0_6 = Lambda_0_6_p5 + Lambda_6_11 * Lambda_0_11_p3;
  Lambda[6] = Lambda_0_6;
  Lambda[72] = Lambda_0_6;
  const Real Lambda_0_7 = Lambda_0_0_p19 - Lambda_0_7_p1 * Lambda_0_0_p14 + Lambda_0_7_p2 *
      Lambda_0_0_p20 + Lambda_0_7_p3 * Lambda_0_0_p25 + Lambda_7_11 * Lambda_0_11_p3;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_0_8 = Lambda_0_0_p21 - Lambda_0_8_p1 * Lambda_0_0_p20 + Lambda_0_8_p2 *
      Lambda_0_0_p25 + Lambda_8_11 * Lambda_0_11_p3;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_0_9 = Lambda_0_0_p23 - Lambda_0_9_p1 * Lambda_0_0_p25 + Lambda_9_11 *
      Lambda_0_11_p3;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_0_10 = Lambda_0_0_p26 - Lambda_10_11 * Lambda_0_11_p3;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  Lambda[13] = Lambda_1_1_p2 + Lambda_0_1_p10 * Lambda_1_11_p13 + Lambda_1_11 * Lambda_1_11_p15;
  const Real Lambda_1_2 = Lambda_1_2_p2 + Lambda_2_11 * Lambda_1_11_p15;
  Lambda[14] = Lambda_1_2;
  Lambda[25] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_1_3_p1 + Lambda_0_3_p5 * Lambda_1_11_p11 + Lambda_0_3_p6 *
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
  const Real Lambda_1_7 = Lambda_0_1_p6 - Lambda_0_7_p1 * Lambda_1_11_p11 + Lambda_0_7_p2 *
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
  const Real Lambda_2_3 = Lambda_2_3_p1 + Lambda_0_3_p5 * Lambda_2_11_p9 + Lambda_0_3_p6 *
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
  const Real Lambda_2_7 = Lambda_0_2_p5 - Lambda_0_7_p1 * Lambda_2_11_p9 + Lambda_0_7_p2 *
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
  Lambda[52] = Lambda_4_4_p1 + Lambda_0_4_p5 * Lambda_4_11_p4 + Lambda_0_4_p6 * Lambda_4_11_p7 +
      Lambda_4_11 * Lambda_4_11_p8;
  const Real Lambda_4_5 = Lambda_4_5_p1 + Lambda_0_5_p5 * Lambda_4_11_p7 + Lambda_5_11 *
      Lambda_4_11_p8;
  Lambda[53] = Lambda_4_5;
  Lambda[64] = Lambda_4_5;
  const Real Lambda_4_6 = Lambda_4_6_p1 + Lambda_6_11 * Lambda_4_11_p8;
  Lambda[54] = Lambda_4_6;
  Lambda[76] = Lambda_4_6;
  const Real Lambda_4_7 = Lambda_0_4_p3 - Lambda_0_7_p1 * Lambda_4_11_p3 + Lambda_0_7_p2 *
      Lambda_4_11_p4 + Lambda_0_7_p3 * Lambda_4_11_p7 + Lambda_7_11 * Lambda_4_11_p8;
  Lambda[55] = Lambda_4_7;
  Lambda[88] = Lambda_4_7;
  const Real Lambda_4_8 = Lambda_0_4_p4 - Lambda_0_8_p1 * Lambda_4_11_p4 + Lambda_0_8_p2 *
      Lambda_4_11_p7 + Lambda_8_11 * Lambda_4_11_p8;
  Lambda[56] = Lambda_4_8;
  Lambda[100] = Lambda_4_8;
  const Real Lambda_4_9 = Lambda_0_4_p5 - Lambda_0_9_p1 * Lambda_4_11_p7 + Lambda_9_11 *
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
  Lambda[91] = Lambda_11_11_p5041 + Lambda_0_7_p1 * Lambda_11_11_p5075_lanes[0] + Lambda_0_7_p2 *
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
  Lambda[104] = Lambda_11_11_p5101 + Lambda_0_8_p1 * Lambda_11_11_p5110_lanes[1] + Lambda_0_8_p2 *
      Lambda_8_11_p1 + Lambda_8_11 * Lambda_8_11_p2;
  const Real Lambda_8_9 = Lambda_9_11 * Lambda_8_11_p2 -
      (Lambda_0_8_p1 + Lambda_0_9_p1 * Lambda_8_11_p1);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p2 - Lambda_10_11 * Lambda_8_11_p2;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = Lambda_11_11_p5121 + Lambda_0_9_p1 * Lambda_11_11_p5124 + Lambda_9_11 *
      Lambda_9_11_p1;
  const Real Lambda_9_10 = Lambda_0_9_p1 + Lambda_10_11 * Lambda_9_11_p1;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_11_11_p5127 + Lambda_10_11 * Lambda_11_11_p5130;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
