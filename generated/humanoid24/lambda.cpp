// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in
//   lanes.
// 8039 flops (add 3448, mul 4547, div 44), sine and cosine of 24 angles
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

  // link 5 (chest2), pose
  const Real Lambda_11_11_p3 = s5 * s4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p47 = inverse_D4_p9 * inverse_D3_p36 -
      (2.2194301519999997 + 0.072 * inverse_D4_p5);

  // link 5 (chest2), pose
  const Real Lambda_11_11_p4 = c5 * s4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p48 = s5 * (inverse_D3_p38 - inverse_D3_p37) + inverse_D3_p16 *
      inverse_D3_p39;
  const Real inverse_D2_p1 = 0.422 * c2;
  const Real inverse_D3_p49 = s5 * (inverse_D3_p40 - inverse_D3_p41) + c5 *
      (inverse_D3_p42 + inverse_D3_p43);
  const Real inverse_D2_p2 = 0.422 * s2;
  const Real inverse_D3_p50 = s5 * inverse_D3_p48;
  const Real inverse_D4_p15 = s5 * (inverse_D4_p12 - inverse_D4_p13) + inverse_D3_p16 *
      inverse_D4_p14;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p9 = s6 * c4 - c6 * Lambda_11_11_p3;
  const Real Lambda_11_11_p10 = s6 * Lambda_11_11_p3 + c6 * c4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p51 = s5 * inverse_D3_p49;
  const Real inverse_D3_p52 = s5 * inverse_D3_p46 - c5 * inverse_D3_p47;
  const Lanes<2> Lambda_11_11_p11_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Real inverse_D4_p16 = s5 * inverse_D4_p15;
  const Real inverse_D3_p53 = c5 * inverse_D3_p49;
  const Real inverse_D3_p54 = inverse_D3_p38 - inverse_D3_p50;
  const Lanes<2> Lambda_11_11_p21_lanes = 0.086 * detail::make_pack<Real>(c13, c20);
  const Real inverse_D2_p3 = inverse_D3_p41 + inverse_D3_p51;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p23_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p9 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p4;
  const Lanes<2> Lambda_11_11_p25_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p9 +
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p4;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p13 + inverse_D4_p16));

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p4 = s4 * (s5 * inverse_D3_p45 + c5 * inverse_D3_p44) - c4 *
      (c5 * inverse_D3_p48 - inverse_D3_p39);
  const Real inverse_D3_p55 = c4 * (2.0 * (s5 * inverse_D3_p44 - c5 * inverse_D3_p45)) - s4 *
      (inverse_D3_p54 - (inverse_D4_p5 - inverse_D4_p8 * inverse_D3_p36));
  const Real inverse_D3_p56 = s4 * (s5 * inverse_D3_p47 + c5 * inverse_D3_p46) - c4 *
      (inverse_D3_p53 - inverse_D3_p43);

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p31_lanes = detail::make_pack<Real>(c8, c15) * Lambda_11_11_p10 -
      detail::make_pack<Real>(s8, s15) * Lambda_11_11_p23_lanes;
  const Lanes<2> Lambda_11_11_p33_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p23_lanes + detail::make_pack<Real>(s8, s15) * Lambda_11_11_p10;

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p5 = 0.0300000063 * s4 + inverse_D3_p56;
  const Real inverse_D3_p57 = inverse_D3_p52 - c4 *
      (c4 * inverse_D3_p52 - s4 * (inverse_D3_p40 - inverse_D3_p51));
  const Real inverse_D3_p58 = inverse_D3_p54 + s4 * inverse_D3_p55;
  const Real inverse_D3_p59 = 0.21799999999999997 * inverse_D3_p56 +
      (0.005880002159562879 - (c5 * inverse_D4_p15 - inverse_D4_p14)) * s4;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p35 = s16 * Lambda_11_11_p31_lanes[1] + c16 * Lambda_11_11_p25_lanes[1];
  const Real Lambda_11_11_p36 = c16 * Lambda_11_11_p31_lanes[1] - s16 * Lambda_11_11_p25_lanes[1];

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p60 = inverse_D3_p59 * inverse_D4;
  const Real inverse_D2_p6 = inverse_D2_p3 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p5 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p61 = inverse_D3_p57 + 0.21799999999999997 * inverse_D3_p58;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p37 = c17 * Lambda_11_11_p35 + s17 * Lambda_11_11_p33_lanes[1];
  const Real Lambda_11_11_p38 = c17 * Lambda_11_11_p33_lanes[1] - s17 * Lambda_11_11_p35;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p8 = 0.0300000063 * c4 + (0.21799999999999997 * inverse_D2_p4 - s4 *
      (inverse_D3_p53 - inverse_D3_p42)) - inverse_D3_p59 * inverse_D2_p6;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p39 = c18 * Lambda_11_11_p37 + s18 * Lambda_11_11_p36;
  const Real Lambda_11_11_p40 = c18 * Lambda_11_11_p36 - s18 * Lambda_11_11_p37;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p9 = 0.02999999505 + inverse_D2_p8;
  const Real inverse_D2_p10 = 8.419374554 + (inverse_D3_p61 - inverse_D3_p59 * inverse_D2_p7);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_11_11_p41_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p43 = c19 * Lambda_11_11_p38 - s19 * Lambda_11_11_p39;
  const Real Lambda_11_11_p44 = c19 * Lambda_11_11_p39 + s19 * Lambda_11_11_p38;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p62 = 1.7947593951550056 + 0.21799999999999997 *
      (inverse_D3_p57 + inverse_D3_p61) - inverse_D3_p59 * inverse_D3_p60 +
      (0.03561389675370483 + (inverse_D4_p12 - inverse_D4_p16)) * s4 * s4;

  // link 3 (hip), pose
  const Real Lambda_11_11_p45 = Lambda_11_11_p2 * c1 - Lambda_11_11_p1 * s1;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / inverse_D3_p62;

  // link 3 (hip), pose
  const Real Lambda_11_11_p46 = Lambda_11_11_p1 * c1 + Lambda_11_11_p2 * s1;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p47 = c4 * Lambda_11_11_p45;
  const Real Lambda_11_11_p48 = s4 * Lambda_11_11_p45;

  // link 1 (calf), articulated inertia
  const Real Lambda_11_11_p49 = Lambda_11_11_p21_lanes[1] * Lambda_11_11_p40 -
      Lambda_11_11_p11_lanes[1] * Lambda_11_11_p43;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p50 = -(Lambda_11_11_p21_lanes[1] * Lambda_11_11_p44) +
      inverse_D12_p7_lanes[1] * Lambda_11_11_p49;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p51 = s5 * Lambda_11_11_p47 + c5 * Lambda_11_11_p46;
  const Real Lambda_11_11_p52 = c5 * Lambda_11_11_p47 - s5 * Lambda_11_11_p46;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p11 = inverse_D2_p9 * inverse_D3;
  const Real inverse_D2_p12 = inverse_D2_p10 * inverse_D3;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p57 = Lambda_11_11_p43 + inverse_D10_p10_lanes[1] * Lambda_11_11_p49 -
      inverse_D10_p22_lanes[1] * Lambda_11_11_p50;
  const Real Lambda_11_11_p58 = Lambda_11_11_p44 + inverse_D10_p23_lanes[1] * Lambda_11_11_p50;
  const Real Lambda_11_11_p59 = Lambda_11_11_p11_lanes[1] * Lambda_11_11_p44 +
      inverse_D11_p5_lanes[1] * Lambda_11_11_p49 - inverse_D11_p13_lanes[1] * Lambda_11_11_p50;
  const Real Lambda_11_11_p60 = Lambda_11_11_p40 - inverse_D10_p11_lanes[1] * Lambda_11_11_p49 -
      inverse_D10_p24_lanes[1] * Lambda_11_11_p50;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p61 = c6 * Lambda_11_11_p51 + s6 * Lambda_11_11_p48;
  const Real Lambda_11_11_p62 = s6 * Lambda_11_11_p51 - c6 * Lambda_11_11_p48;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p13 = inverse_D2_p10 * inverse_D2_p11 -
      (inverse_D2_p4 - inverse_D2_p5 * inverse_D2_p6);
  const Real inverse_D2_p14 = inverse_D3_p58 - inverse_D2_p5 * inverse_D2_p7 - inverse_D2_p10 *
      inverse_D2_p12;
  const Real inverse_D2_p15 = inverse_D3_p37 + inverse_D3_p50 - inverse_D2_p3 * inverse_D2_p6 -
      inverse_D2_p9 * inverse_D2_p11;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p71 = s19 * Lambda_11_11_p57 - c19 * Lambda_11_11_p58;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p72 = -(c19 * Lambda_11_11_p59);

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p73_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p61 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p52;
  const Lanes<2> Lambda_11_11_p75_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p52 -
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p61;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p81 = 0.269 * Lambda_11_11_p60 - s19 * Lambda_11_11_p59 -
      inverse_D10_p77_lanes[1] * Lambda_11_11_p72;
  const Real Lambda_11_11_p82 = -Lambda_11_11_p71 + inverse_D8_p16_lanes[1] * Lambda_11_11_p72;
  const Real Lambda_11_11_p83 = Lambda_11_11_p60 - inverse_D8_p17_lanes[1] * Lambda_11_11_p72;
  const Real Lambda_11_11_p84 = 0.269 * Lambda_11_11_p71 - inverse_D10_p78_lanes[1] *
      Lambda_11_11_p72;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p85_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_11_11_p73_lanes + detail::make_pack<Real>(c8, c15) * Lambda_11_11_p62;
  const Lanes<2> Lambda_11_11_p87_lanes = detail::make_pack<Real>(s8, s15) * Lambda_11_11_p62 -
      detail::make_pack<Real>(c8, c15) * Lambda_11_11_p73_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p16 = Lambda_11_11_p1 * (inverse_D2_p14 - inverse_D2_p15) +
      Lambda_11_11_p2 * (2.0 * inverse_D2_p13);
  const Real inverse_D2_p17 = Lambda_11_11_p1 * inverse_D2_p16;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p89 = s18 * Lambda_11_11_p81 + c18 * Lambda_11_11_p84;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p90 = s16 * Lambda_11_11_p85_lanes[1] + c16 * Lambda_11_11_p75_lanes[1];
  const Real Lambda_11_11_p91 = c16 * Lambda_11_11_p85_lanes[1] - s16 * Lambda_11_11_p75_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p92 = inverse_D9_p7_lanes[1] * Lambda_11_11_p89;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p18 = Lambda_11_11_p2 * inverse_D2_p16 - inverse_D2_p13;
  const Real inverse_D2_p19 = inverse_D2_p14 - inverse_D2_p17;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p93 = c18 * Lambda_11_11_p81 - s18 * Lambda_11_11_p84 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p89;
  const Real Lambda_11_11_p94 = c18 * Lambda_11_11_p82 - s18 * Lambda_11_11_p83 -
      inverse_D8_p80_lanes[1] * Lambda_11_11_p89;
  const Real Lambda_11_11_p95 = -(-(s19 * Lambda_11_11_p58 + c19 * Lambda_11_11_p57) -
      inverse_D8_p18_lanes[1] * Lambda_11_11_p72) - inverse_D8_p81_lanes[1] * Lambda_11_11_p89;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p96 = c17 * Lambda_11_11_p90 + s17 * Lambda_11_11_p87_lanes[1];
  const Real Lambda_11_11_p97 = c17 * Lambda_11_11_p87_lanes[1] - s17 * Lambda_11_11_p90;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p98 = s18 * Lambda_11_11_p82 + c18 * Lambda_11_11_p83 -
      inverse_D8_p82_lanes[1] * Lambda_11_11_p89;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = inverse_D2_p1 * inverse_D2_p19 + inverse_D2_p2 * inverse_D2_p18;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p99 = c17 * Lambda_11_11_p92 - s17 * Lambda_11_11_p93;
  const Real Lambda_11_11_p100 = s17 * Lambda_11_11_p95 - c17 * Lambda_11_11_p94;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p101 = c4 * Lambda_11_11_p46;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p102 = c18 * Lambda_11_11_p96 + s18 * Lambda_11_11_p91;
  const Real Lambda_11_11_p103 = c18 * Lambda_11_11_p91 - s18 * Lambda_11_11_p96;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p104 = s4 * Lambda_11_11_p46;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = inverse_D2_p20 - (0.031999971599999996 * s2 - 24.5839218 * c2);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p105 = c17 * Lambda_11_11_p93 + s17 * Lambda_11_11_p92 + 0.282 *
      Lambda_11_11_p98 - inverse_D8_p149_lanes[1] * Lambda_11_11_p99;
  const Real Lambda_11_11_p106 = 0.282 * Lambda_11_11_p100 - inverse_D8_p150_lanes[1] *
      Lambda_11_11_p99;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p107 = s5 * Lambda_11_11_p101 - c5 * Lambda_11_11_p45;
  const Real Lambda_11_11_p108 = s5 * Lambda_11_11_p45 + c5 * Lambda_11_11_p101;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p109 = c19 * Lambda_11_11_p97 - s19 * Lambda_11_11_p102;
  const Real Lambda_11_11_p110 = c19 * Lambda_11_11_p102 + s19 * Lambda_11_11_p97;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = 9.885744550888212 + (inverse_D2_p2 *
      (inverse_D2_p1 * inverse_D2_p18 + inverse_D2_p2 * (inverse_D2_p15 + inverse_D2_p17)) +
      inverse_D2_p1 * inverse_D2_p20);

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / inverse_D2_p21;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p115 = c16 * Lambda_11_11_p105 - s16 * Lambda_11_11_p106;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p116 = c6 * Lambda_11_11_p107 + s6 * Lambda_11_11_p104;
  const Real Lambda_11_11_p117 = c6 * Lambda_11_11_p104 - s6 * Lambda_11_11_p107;

  // link 1 (calf), articulated inertia
  const Real Lambda_11_11_p118 = Lambda_11_11_p21_lanes[1] * Lambda_11_11_p103 -
      Lambda_11_11_p11_lanes[1] * Lambda_11_11_p109;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p119 = Lambda_11_11_p41_lanes[1] * Lambda_11_11_p115;
  const Real Lambda_11_11_p128 = s16 * Lambda_11_11_p105 + c16 * Lambda_11_11_p106 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p115;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_11_11_p129_lanes = detail::make_pack<Real>(c7, c14) * Lambda_11_11_p116 +
      detail::make_pack<Real>(s7, s14) * Lambda_11_11_p108;
  const Lanes<2> Lambda_11_11_p131_lanes = detail::make_pack<Real>(s7, s14) * Lambda_11_11_p116 -
      detail::make_pack<Real>(c7, c14) * Lambda_11_11_p108;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p133 = -(Lambda_11_11_p21_lanes[1] * Lambda_11_11_p110) +
      inverse_D12_p7_lanes[1] * Lambda_11_11_p118;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p144 = s15 * Lambda_11_11_p119 + c15 * Lambda_11_11_p128;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_11_11_p145_lanes = detail::make_pack<Real>(c8, c15) * Lambda_11_11_p117 -
      detail::make_pack<Real>(s8, s15) * Lambda_11_11_p129_lanes;
  const Lanes<2> Lambda_11_11_p147_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_11_11_p129_lanes + detail::make_pack<Real>(s8, s15) * Lambda_11_11_p117;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p149 = Lambda_11_11_p109 + inverse_D10_p10_lanes[1] * Lambda_11_11_p118 -
      inverse_D10_p22_lanes[1] * Lambda_11_11_p133;
  const Real Lambda_11_11_p150 = Lambda_11_11_p110 + inverse_D10_p23_lanes[1] * Lambda_11_11_p133;
  const Real Lambda_11_11_p151 = Lambda_11_11_p11_lanes[1] * Lambda_11_11_p110 +
      inverse_D11_p5_lanes[1] * Lambda_11_11_p118 - inverse_D11_p13_lanes[1] * Lambda_11_11_p133;
  const Real Lambda_11_11_p152 = Lambda_11_11_p103 - inverse_D10_p11_lanes[1] * Lambda_11_11_p118 -
      inverse_D10_p24_lanes[1] * Lambda_11_11_p133;

  // link 9 (left_upperarm), pose
  const Lanes<8> Lambda_11_11_p165_lanes = s9 * detail::make_pack<Real>(Lambda_11_11_p85_lanes[0],
      Lambda_11_11_p31_lanes[0], Lambda_11_11_p145_lanes[0], Lambda_11_11_p85_lanes[0],
      Lambda_11_11_p85_lanes[0], Lambda_11_11_p85_lanes[0], Lambda_11_11_p85_lanes[0],
      Lambda_11_11_p85_lanes[0]) + c9 * detail::make_pack<Real>(Lambda_11_11_p75_lanes[0],
      Lambda_11_11_p25_lanes[0], Lambda_11_11_p131_lanes[0], Lambda_11_11_p75_lanes[0],
      Lambda_11_11_p75_lanes[0], Lambda_11_11_p75_lanes[0], Lambda_11_11_p75_lanes[0],
      Lambda_11_11_p75_lanes[0]);
  const Lanes<8> Lambda_11_11_p168_lanes = c9 * detail::make_pack<Real>(Lambda_11_11_p85_lanes[0],
      Lambda_11_11_p31_lanes[0], Lambda_11_11_p145_lanes[0], Lambda_11_11_p85_lanes[0],
      Lambda_11_11_p85_lanes[0], Lambda_11_11_p85_lanes[0], Lambda_11_11_p85_lanes[0],
      Lambda_11_11_p85_lanes[0]) - s9 * detail::make_pack<Real>(Lambda_11_11_p75_lanes[0],
      Lambda_11_11_p25_lanes[0], Lambda_11_11_p131_lanes[0], Lambda_11_11_p75_lanes[0],
      Lambda_11_11_p75_lanes[0], Lambda_11_11_p75_lanes[0], Lambda_11_11_p75_lanes[0],
      Lambda_11_11_p75_lanes[0]);

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p171 = s19 * Lambda_11_11_p149 - c19 * Lambda_11_11_p150;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p172 = -(c19 * Lambda_11_11_p151);
  const Real Lambda_11_11_p185 = 0.269 * Lambda_11_11_p152 - s19 * Lambda_11_11_p151 -
      inverse_D10_p77_lanes[1] * Lambda_11_11_p172;
  const Real Lambda_11_11_p186 = -Lambda_11_11_p171 + inverse_D8_p16_lanes[1] * Lambda_11_11_p172;
  const Real Lambda_11_11_p187 = Lambda_11_11_p152 - inverse_D8_p17_lanes[1] * Lambda_11_11_p172;

  // link 10 (left_lowerarm), pose
  const Lanes<8> Lambda_11_11_p188_lanes = c10 * Lambda_11_11_p165_lanes + s10 *
      detail::make_pack<Real>(Lambda_11_11_p87_lanes[0], Lambda_11_11_p33_lanes[0],
      Lambda_11_11_p147_lanes[0], Lambda_11_11_p87_lanes[0], Lambda_11_11_p87_lanes[0],
      Lambda_11_11_p87_lanes[0], Lambda_11_11_p87_lanes[0], Lambda_11_11_p87_lanes[0]);
  const Lanes<8> Lambda_11_11_p191_lanes = c10 * detail::make_pack<Real>(Lambda_11_11_p87_lanes[0],
      Lambda_11_11_p33_lanes[0], Lambda_11_11_p147_lanes[0], Lambda_11_11_p87_lanes[0],
      Lambda_11_11_p87_lanes[0], Lambda_11_11_p87_lanes[0], Lambda_11_11_p87_lanes[0],
      Lambda_11_11_p87_lanes[0]) - s10 * Lambda_11_11_p165_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p194 = 0.269 * Lambda_11_11_p171 - inverse_D10_p78_lanes[1] *
      Lambda_11_11_p172;

  // link 11 (left_wrist1), pose
  const Lanes<8> Lambda_11_11_p207_lanes = c11 * Lambda_11_11_p188_lanes + s11 *
      Lambda_11_11_p168_lanes;
  const Lanes<8> Lambda_11_11_p210_lanes = c11 * Lambda_11_11_p168_lanes - s11 *
      Lambda_11_11_p188_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p213 = s18 * Lambda_11_11_p185 + c18 * Lambda_11_11_p194;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p223 = inverse_D9_p7_lanes[1] * Lambda_11_11_p213;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_11_11_p224_lanes = c12 * Lambda_11_11_p191_lanes - s12 *
      Lambda_11_11_p207_lanes;
  const Lanes<8> Lambda_11_11_p227_lanes = c12 * Lambda_11_11_p207_lanes + s12 *
      Lambda_11_11_p191_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p230 = c18 * Lambda_11_11_p185 - s18 * Lambda_11_11_p194 -
      inverse_D9_p9_lanes[1] * Lambda_11_11_p213;
  const Real Lambda_11_11_p231 = c18 * Lambda_11_11_p186 - s18 * Lambda_11_11_p187 -
      inverse_D8_p80_lanes[1] * Lambda_11_11_p213;
  const Real Lambda_11_11_p232 = -(-(s19 * Lambda_11_11_p150 + c19 * Lambda_11_11_p149) -
      inverse_D8_p18_lanes[1] * Lambda_11_11_p172) - inverse_D8_p81_lanes[1] * Lambda_11_11_p213;
  const Real Lambda_11_11_p233 = s18 * Lambda_11_11_p186 + c18 * Lambda_11_11_p187 -
      inverse_D8_p82_lanes[1] * Lambda_11_11_p213;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_11_11_p240_lanes = Lambda_11_11_p11_lanes[0] * Lambda_11_11_p227_lanes;
  const Lanes<8> Lambda_11_11_p243_lanes = Lambda_11_11_p21_lanes[0] * Lambda_11_11_p210_lanes -
      Lambda_11_11_p11_lanes[0] * Lambda_11_11_p224_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p246_lanes = -(Lambda_11_11_p21_lanes[0] * Lambda_11_11_p227_lanes);

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p249 = c17 * Lambda_11_11_p223 - s17 * Lambda_11_11_p230;
  const Real Lambda_11_11_p250 = s17 * Lambda_11_11_p232 - c17 * Lambda_11_11_p231;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p269 = -Lambda_11_11_p100 + inverse_D6_p31_lanes[1] * Lambda_11_11_p99;
  const Real Lambda_11_11_p270 = Lambda_11_11_p98 - inverse_D6_p33_lanes[1] * Lambda_11_11_p99;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p271_lanes = detail::make_pack<Real>(Lambda_11_11_p246_lanes[0],
      Lambda_11_11_p246_lanes[1], Lambda_11_11_p246_lanes[2], Lambda_11_11_p210_lanes[0],
      Lambda_11_11_p210_lanes[1], Lambda_11_11_p210_lanes[2], Lambda_11_11_p246_lanes[0],
      Lambda_11_11_p246_lanes[0]) + inverse_D12_p7_lanes[0] *
      detail::make_pack<Real>(Lambda_11_11_p243_lanes[0], Lambda_11_11_p243_lanes[1],
      Lambda_11_11_p243_lanes[2], Lambda_11_11_p227_lanes[0], Lambda_11_11_p227_lanes[1],
      Lambda_11_11_p227_lanes[2], Lambda_11_11_p243_lanes[0], Lambda_11_11_p243_lanes[0]);
  const Lanes<8> Lambda_11_11_p277_lanes = Lambda_11_11_p224_lanes + inverse_D10_p10_lanes[0] *
      Lambda_11_11_p243_lanes;
  const Lanes<8> Lambda_11_11_p286_lanes = Lambda_11_11_p210_lanes - inverse_D10_p11_lanes[0] *
      Lambda_11_11_p243_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p289 = 0.282 * Lambda_11_11_p250 - inverse_D8_p150_lanes[1] *
      Lambda_11_11_p249;
  const Real Lambda_11_11_p290 = -Lambda_11_11_p250 + inverse_D6_p31_lanes[1] * Lambda_11_11_p249;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p306_lanes = inverse_D10_p23_lanes[0] * Lambda_11_11_p271_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p315 = c17 * Lambda_11_11_p230 + s17 * Lambda_11_11_p223 + 0.282 *
      Lambda_11_11_p233 - inverse_D8_p149_lanes[1] * Lambda_11_11_p249;
  const Real Lambda_11_11_p316 = Lambda_11_11_p233 - inverse_D6_p33_lanes[1] * Lambda_11_11_p249;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p317_lanes = detail::make_pack<Real>(Lambda_11_11_p277_lanes[0],
      Lambda_11_11_p277_lanes[1], Lambda_11_11_p277_lanes[2], inverse_D10_p10_lanes[0] *
      Lambda_11_11_p227_lanes[0], inverse_D10_p10_lanes[0] * Lambda_11_11_p227_lanes[1],
      inverse_D10_p10_lanes[0] * Lambda_11_11_p227_lanes[2], Lambda_11_11_p277_lanes[0],
      Lambda_11_11_p277_lanes[0]) - inverse_D10_p22_lanes[0] * Lambda_11_11_p271_lanes;
  const Lanes<8> Lambda_11_11_p323_lanes = Lambda_11_11_p227_lanes + inverse_D10_p23_lanes[0] *
      Lambda_11_11_p271_lanes;
  const Lanes<8> Lambda_11_11_p326_lanes = detail::make_pack<Real>(Lambda_11_11_p240_lanes[0],
      Lambda_11_11_p240_lanes[1], Lambda_11_11_p240_lanes[2], Lambda_11_11_p224_lanes[0],
      Lambda_11_11_p224_lanes[1], Lambda_11_11_p224_lanes[2], Lambda_11_11_p240_lanes[0],
      Lambda_11_11_p240_lanes[0]) + inverse_D11_p5_lanes[0] *
      detail::make_pack<Real>(Lambda_11_11_p243_lanes[0], Lambda_11_11_p243_lanes[1],
      Lambda_11_11_p243_lanes[2], Lambda_11_11_p227_lanes[0], Lambda_11_11_p227_lanes[1],
      Lambda_11_11_p227_lanes[2], Lambda_11_11_p243_lanes[0], Lambda_11_11_p243_lanes[0]) -
      inverse_D11_p13_lanes[0] * Lambda_11_11_p271_lanes;
  const Lanes<8> Lambda_11_11_p332_lanes = detail::make_pack<Real>(Lambda_11_11_p286_lanes[0],
      Lambda_11_11_p286_lanes[1], Lambda_11_11_p286_lanes[2],
      -(inverse_D10_p11_lanes[0] * Lambda_11_11_p227_lanes[0]),
      -(inverse_D10_p11_lanes[0] * Lambda_11_11_p227_lanes[1]),
      -(inverse_D10_p11_lanes[0] * Lambda_11_11_p227_lanes[2]), Lambda_11_11_p286_lanes[0],
      Lambda_11_11_p286_lanes[0]) - inverse_D10_p24_lanes[0] * Lambda_11_11_p271_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p380 = c16 * Lambda_11_11_p315 - s16 * Lambda_11_11_p289;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p381 = s16 * Lambda_11_11_p269 + c16 * Lambda_11_11_p270 -
      inverse_D6_p163_lanes[1] * Lambda_11_11_p115;
  const Real Lambda_11_11_p382 = -(-(s17 * Lambda_11_11_p94 + c17 * Lambda_11_11_p95) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p99) + inverse_D6_p161_lanes[1] * Lambda_11_11_p115;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p383_lanes = s12 * Lambda_11_11_p317_lanes - c12 *
      detail::make_pack<Real>(Lambda_11_11_p323_lanes[0], Lambda_11_11_p323_lanes[1],
      Lambda_11_11_p323_lanes[2], Lambda_11_11_p306_lanes[3], Lambda_11_11_p306_lanes[4],
      Lambda_11_11_p306_lanes[5], Lambda_11_11_p323_lanes[0], Lambda_11_11_p323_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p389_lanes = -(c12 * Lambda_11_11_p326_lanes);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p437 = Lambda_11_11_p41_lanes[1] * Lambda_11_11_p380;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p450_lanes = 0.269 * Lambda_11_11_p332_lanes - s12 *
      Lambda_11_11_p326_lanes - inverse_D10_p77_lanes[0] * Lambda_11_11_p389_lanes;
  const Lanes<8> Lambda_11_11_p456_lanes = -Lambda_11_11_p383_lanes + inverse_D8_p16_lanes[0] *
      Lambda_11_11_p389_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_11_11_p468_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p470_lanes = Lambda_11_11_p332_lanes - inverse_D8_p17_lanes[0] *
      Lambda_11_11_p389_lanes;
  const Lanes<8> Lambda_11_11_p476_lanes = -(s12 *
      detail::make_pack<Real>(Lambda_11_11_p323_lanes[0], Lambda_11_11_p323_lanes[1],
      Lambda_11_11_p323_lanes[2], Lambda_11_11_p306_lanes[3], Lambda_11_11_p306_lanes[4],
      Lambda_11_11_p306_lanes[5], Lambda_11_11_p323_lanes[0], Lambda_11_11_p323_lanes[0]) + c12 *
      Lambda_11_11_p317_lanes) - inverse_D8_p18_lanes[0] * Lambda_11_11_p389_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p482 = s16 * Lambda_11_11_p315 + c16 * Lambda_11_11_p289 -
      inverse_D7_p8_lanes[1] * Lambda_11_11_p380;
  const Real Lambda_11_11_p483 = s16 * Lambda_11_11_p290 + c16 * Lambda_11_11_p316 -
      inverse_D6_p163_lanes[1] * Lambda_11_11_p380;
  const Real Lambda_11_11_p484 = -(-(s17 * Lambda_11_11_p231 + c17 * Lambda_11_11_p232) +
      inverse_D6_p35_lanes[1] * Lambda_11_11_p249) + inverse_D6_p161_lanes[1] * Lambda_11_11_p380;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p485_lanes = 0.269 * Lambda_11_11_p383_lanes -
      inverse_D10_p78_lanes[0] * Lambda_11_11_p389_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p557 = s15 * Lambda_11_11_p437 + c15 * Lambda_11_11_p482;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p558_lanes = s11 * Lambda_11_11_p450_lanes + c11 *
      Lambda_11_11_p485_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p588_lanes = inverse_D9_p7_lanes[0] * Lambda_11_11_p558_lanes;
  const Lanes<8> Lambda_11_11_p600_lanes = c11 * Lambda_11_11_p450_lanes - s11 *
      Lambda_11_11_p485_lanes - inverse_D9_p9_lanes[0] * Lambda_11_11_p558_lanes;
  const Lanes<8> Lambda_11_11_p606_lanes = -Lambda_11_11_p476_lanes - inverse_D8_p81_lanes[0] *
      Lambda_11_11_p558_lanes;
  const Lanes<8> Lambda_11_11_p612_lanes = c11 * Lambda_11_11_p456_lanes - s11 *
      Lambda_11_11_p470_lanes - inverse_D8_p80_lanes[0] * Lambda_11_11_p558_lanes;
  const Lanes<8> Lambda_11_11_p630_lanes = s11 * Lambda_11_11_p456_lanes + c11 *
      Lambda_11_11_p470_lanes - inverse_D8_p82_lanes[0] * Lambda_11_11_p558_lanes;
  const Lanes<8> Lambda_11_11_p678_lanes = c10 * Lambda_11_11_p588_lanes - s10 *
      Lambda_11_11_p600_lanes;
  const Lanes<8> Lambda_11_11_p684_lanes = s10 * Lambda_11_11_p606_lanes - c10 *
      Lambda_11_11_p612_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p702_lanes = inverse_D8_p149_lanes[0] * Lambda_11_11_p678_lanes;
  const Lanes<8> Lambda_11_11_p756_lanes = c10 * Lambda_11_11_p600_lanes + s10 *
      Lambda_11_11_p588_lanes + 0.282 * Lambda_11_11_p630_lanes - Lambda_11_11_p702_lanes;
  const Lanes<8> Lambda_11_11_p762_lanes = 0.282 * Lambda_11_11_p684_lanes -
      inverse_D8_p150_lanes[0] * Lambda_11_11_p678_lanes;
  const Lanes<8> Lambda_11_11_p768_lanes = -Lambda_11_11_p684_lanes + inverse_D6_p31_lanes[0] *
      Lambda_11_11_p678_lanes;
  const Lanes<8> Lambda_11_11_p774_lanes = Lambda_11_11_p630_lanes - inverse_D6_p33_lanes[0] *
      Lambda_11_11_p678_lanes;
  const Lanes<8> Lambda_11_11_p780_lanes = -(s10 * Lambda_11_11_p612_lanes + c10 *
      Lambda_11_11_p606_lanes) + inverse_D6_p35_lanes[0] * Lambda_11_11_p678_lanes;
  const Lanes<8> Lambda_11_11_p840_lanes = c9 * Lambda_11_11_p756_lanes - s9 *
      Lambda_11_11_p762_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p870_lanes = Lambda_11_11_p41_lanes[0] * Lambda_11_11_p840_lanes;
  const Lanes<8> Lambda_11_11_p894_lanes = s9 * Lambda_11_11_p756_lanes + c9 *
      Lambda_11_11_p762_lanes - inverse_D7_p8_lanes[0] * Lambda_11_11_p840_lanes;
  const Lanes<8> Lambda_11_11_p906_lanes = s9 * Lambda_11_11_p768_lanes + c9 *
      Lambda_11_11_p774_lanes - inverse_D6_p163_lanes[0] * Lambda_11_11_p840_lanes;
  const Lanes<8> Lambda_11_11_p912_lanes = -Lambda_11_11_p780_lanes + inverse_D6_p161_lanes[0] *
      Lambda_11_11_p840_lanes;
  const Lanes<8> Lambda_11_11_p918_lanes = c9 * Lambda_11_11_p768_lanes - s9 *
      Lambda_11_11_p774_lanes - inverse_D6_p165_lanes[0] * Lambda_11_11_p840_lanes;
  const Lanes<8> Lambda_11_11_p966_lanes = s8 * Lambda_11_11_p870_lanes + c8 *
      Lambda_11_11_p894_lanes;
  const Lanes<8> Lambda_11_11_p972_lanes = c8 * Lambda_11_11_p912_lanes - s8 *
      Lambda_11_11_p906_lanes;
  const Lanes<8> Lambda_11_11_p978_lanes = s8 * Lambda_11_11_p912_lanes + c8 *
      Lambda_11_11_p906_lanes;
  const Lanes<8> Lambda_11_11_p984_lanes = c8 * Lambda_11_11_p870_lanes - s8 *
      Lambda_11_11_p894_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1022_lanes = detail::make_pack<Real>(Lambda_11_11_p468_lanes[0],
      Lambda_11_11_p468_lanes[0], Lambda_11_11_p468_lanes[0], Lambda_11_11_p468_lanes[0],
      Lambda_11_11_p468_lanes[0], Lambda_11_11_p468_lanes[0], Lambda_11_11_p468_lanes[1],
      Lambda_11_11_p468_lanes[1]) * detail::make_pack<Real>(Lambda_11_11_p966_lanes[0],
      Lambda_11_11_p966_lanes[1], Lambda_11_11_p966_lanes[2], Lambda_11_11_p966_lanes[3],
      Lambda_11_11_p966_lanes[4], Lambda_11_11_p966_lanes[5], Lambda_11_11_p557, Lambda_11_11_p144);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1030_lanes = Lambda_11_11_p558_lanes * inverse_D10_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p1036_lanes = Lambda_11_11_p678_lanes * inverse_D9_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p1042_lanes = Lambda_11_11_p389_lanes * inverse_D11_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p1048_lanes = Lambda_11_11_p840_lanes * inverse_D8_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p1054_lanes = Lambda_11_11_p271_lanes * inverse_D12_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1060_lanes = Lambda_11_11_p966_lanes * inverse_D7_lanes[0];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_11_11_p1066_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_11_11_p243_lanes[0], Lambda_11_11_p243_lanes[1],
      Lambda_11_11_p243_lanes[2], Lambda_11_11_p227_lanes[0], Lambda_11_11_p227_lanes[1],
      Lambda_11_11_p227_lanes[2], Lambda_11_11_p243_lanes[0], Lambda_11_11_p243_lanes[0]);

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D2_p19 - inverse_D1_p1 * inverse_D1_p2));

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1072_lanes = detail::make_pack<Real>(Lambda_11_11_p918_lanes[0],
      Lambda_11_11_p918_lanes[1], Lambda_11_11_p918_lanes[2], Lambda_11_11_p918_lanes[3],
      Lambda_11_11_p918_lanes[4], Lambda_11_11_p918_lanes[5], c16 * Lambda_11_11_p290 - s16 *
      Lambda_11_11_p316 - inverse_D6_p165_lanes[1] * Lambda_11_11_p380, c16 * Lambda_11_11_p269 -
      s16 * Lambda_11_11_p270 - inverse_D6_p165_lanes[1] * Lambda_11_11_p115) -
      detail::make_pack<Real>(inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[1], inverse_D6_p294_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p966_lanes[0], Lambda_11_11_p966_lanes[1],
      Lambda_11_11_p966_lanes[2], Lambda_11_11_p966_lanes[3], Lambda_11_11_p966_lanes[4],
      Lambda_11_11_p966_lanes[5], Lambda_11_11_p557, Lambda_11_11_p144);
  const Lanes<8> Lambda_11_11_p1080_lanes = detail::make_pack<Real>(Lambda_11_11_p972_lanes[0],
      Lambda_11_11_p972_lanes[1], Lambda_11_11_p972_lanes[2], Lambda_11_11_p972_lanes[3],
      Lambda_11_11_p972_lanes[4], Lambda_11_11_p972_lanes[5], c15 * Lambda_11_11_p484 - s15 *
      Lambda_11_11_p483, c15 * Lambda_11_11_p382 - s15 * Lambda_11_11_p381) -
      detail::make_pack<Real>(inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[1], inverse_D6_p292_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p966_lanes[0], Lambda_11_11_p966_lanes[1],
      Lambda_11_11_p966_lanes[2], Lambda_11_11_p966_lanes[3], Lambda_11_11_p966_lanes[4],
      Lambda_11_11_p966_lanes[5], Lambda_11_11_p557, Lambda_11_11_p144);
  const Lanes<8> Lambda_11_11_p1088_lanes = detail::make_pack<Real>(Lambda_11_11_p978_lanes[0],
      Lambda_11_11_p978_lanes[1], Lambda_11_11_p978_lanes[2], Lambda_11_11_p978_lanes[3],
      Lambda_11_11_p978_lanes[4], Lambda_11_11_p978_lanes[5], s15 * Lambda_11_11_p484 + c15 *
      Lambda_11_11_p483, s15 * Lambda_11_11_p382 + c15 * Lambda_11_11_p381) -
      detail::make_pack<Real>(inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[1], inverse_D6_p299_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p966_lanes[0], Lambda_11_11_p966_lanes[1],
      Lambda_11_11_p966_lanes[2], Lambda_11_11_p966_lanes[3], Lambda_11_11_p966_lanes[4],
      Lambda_11_11_p966_lanes[5], Lambda_11_11_p557, Lambda_11_11_p144);
  const Lanes<8> Lambda_11_11_p1096_lanes = detail::make_pack<Real>(Lambda_11_11_p984_lanes[0],
      Lambda_11_11_p984_lanes[1], Lambda_11_11_p984_lanes[2], Lambda_11_11_p984_lanes[3],
      Lambda_11_11_p984_lanes[4], Lambda_11_11_p984_lanes[5], c15 * Lambda_11_11_p437 - s15 *
      Lambda_11_11_p482, c15 * Lambda_11_11_p119 - s15 * Lambda_11_11_p128) -
      detail::make_pack<Real>(inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[1], inverse_D6_p332_lanes[1]) *
      detail::make_pack<Real>(Lambda_11_11_p966_lanes[0], Lambda_11_11_p966_lanes[1],
      Lambda_11_11_p966_lanes[2], Lambda_11_11_p966_lanes[3], Lambda_11_11_p966_lanes[4],
      Lambda_11_11_p966_lanes[5], Lambda_11_11_p557, Lambda_11_11_p144);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1126_lanes = Lambda_11_11_p1030_lanes * Lambda_11_11_p558_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1224_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_11_11_p1072_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_11_11_p1080_lanes;
  const Lanes<8> Lambda_11_11_p1240_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p1072_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p1080_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1296_lanes = Lambda_11_11_p1066_lanes * Lambda_11_11_p243_lanes[0] +
      Lambda_11_11_p1054_lanes * Lambda_11_11_p271_lanes[0] + Lambda_11_11_p1042_lanes *
      Lambda_11_11_p389_lanes[0] + Lambda_11_11_p1126_lanes;
  const Lanes<8> Lambda_11_11_p1317_lanes = Lambda_11_11_p1030_lanes * Lambda_11_11_p558_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1327_lanes = 0.226 * Lambda_11_11_p1088_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_11_11_p1224_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1373_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_11_11_p1022_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_11_11_p1096_lanes + Lambda_11_11_p1327_lanes);
  const Lanes<8> Lambda_11_11_p1381_lanes = inverse_D5_p73 * Lambda_11_11_p1373_lanes;
  const Lanes<8> Lambda_11_11_p1421_lanes = Lambda_11_11_p1373_lanes * inverse_D6;
  const Real Lambda_11_11_p1427 = Lambda_11_11_p1373_lanes[7] * inverse_D6;
  const Real Lambda_11_11_p1428 = Lambda_11_11_p1373_lanes[6] * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1429_lanes = Lambda_11_11_p1296_lanes + Lambda_11_11_p1036_lanes *
      Lambda_11_11_p678_lanes[0] + Lambda_11_11_p1048_lanes * Lambda_11_11_p840_lanes[0] +
      Lambda_11_11_p1060_lanes * Lambda_11_11_p966_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1435_lanes = Lambda_11_11_p1066_lanes * Lambda_11_11_p243_lanes[1] +
      Lambda_11_11_p1054_lanes * Lambda_11_11_p271_lanes[1] + Lambda_11_11_p1042_lanes *
      Lambda_11_11_p389_lanes[1] + Lambda_11_11_p1317_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1440_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_11_11_p1240_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_11_11_p1022_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_11_11_p1096_lanes) -
      Lambda_11_11_p1381_lanes;
  const Lanes<8> Lambda_11_11_p1448_lanes = 0.226 * Lambda_11_11_p1240_lanes - inverse_D5_p72 *
      Lambda_11_11_p1373_lanes;
  const Lanes<8> Lambda_11_11_p1456_lanes = Lambda_11_11_p1240_lanes - inverse_D5_p71 *
      Lambda_11_11_p1373_lanes;
  const Lanes<8> Lambda_11_11_p1464_lanes = Lambda_11_11_p1224_lanes + inverse_D3_p14 *
      Lambda_11_11_p1373_lanes;
  const Lanes<8> Lambda_11_11_p1472_lanes = Lambda_11_11_p1088_lanes - inverse_D3_p15 *
      Lambda_11_11_p1373_lanes;
  const Lanes<8> Lambda_11_11_p1568_lanes = Lambda_11_11_p1429_lanes + Lambda_11_11_p1421_lanes *
      Lambda_11_11_p1373_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1591_lanes = Lambda_11_11_p1030_lanes * Lambda_11_11_p558_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1627_lanes = s6 * Lambda_11_11_p1464_lanes + c6 *
      Lambda_11_11_p1472_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p1635_lanes = Lambda_11_11_p1435_lanes + Lambda_11_11_p1036_lanes *
      Lambda_11_11_p678_lanes[1] + Lambda_11_11_p1048_lanes * Lambda_11_11_p840_lanes[1] +
      Lambda_11_11_p1060_lanes * Lambda_11_11_p966_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p1648_lanes = s6 * Lambda_11_11_p1440_lanes + c6 *
      Lambda_11_11_p1448_lanes + 0.072 * Lambda_11_11_p1456_lanes;
  const Lanes<8> Lambda_11_11_p1668_lanes = Lambda_11_11_p1635_lanes + Lambda_11_11_p1421_lanes *
      Lambda_11_11_p1373_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1713_lanes = Lambda_11_11_p1648_lanes * inverse_D5;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1739_lanes = Lambda_11_11_p1030_lanes * Lambda_11_11_p558_lanes[3];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1757_lanes = c6 * Lambda_11_11_p1464_lanes - s6 *
      Lambda_11_11_p1472_lanes - inverse_D3_p35 * Lambda_11_11_p1648_lanes;
  const Lanes<8> Lambda_11_11_p1765_lanes = Lambda_11_11_p1456_lanes - inverse_D3_p34 *
      Lambda_11_11_p1648_lanes;
  const Lanes<8> Lambda_11_11_p1773_lanes = c6 * Lambda_11_11_p1440_lanes - s6 *
      Lambda_11_11_p1448_lanes - inverse_D4_p11 * Lambda_11_11_p1648_lanes;
  const Lanes<8> Lambda_11_11_p1781_lanes = -(0.072 * Lambda_11_11_p1627_lanes) + inverse_D4_p10 *
      Lambda_11_11_p1648_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p1812_lanes = Lambda_11_11_p1066_lanes * Lambda_11_11_p243_lanes[2] +
      Lambda_11_11_p1054_lanes * Lambda_11_11_p271_lanes[2] + Lambda_11_11_p1042_lanes *
      Lambda_11_11_p389_lanes[2] + Lambda_11_11_p1591_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p1859_lanes = s4 * (Lambda_11_11_p1627_lanes - inverse_D3_p36 *
      Lambda_11_11_p1648_lanes);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p1982_lanes = -(s5 * Lambda_11_11_p1781_lanes + c5 *
      Lambda_11_11_p1773_lanes);
  const Lanes<8> Lambda_11_11_p2014_lanes = Lambda_11_11_p1982_lanes * inverse_D4;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2030_lanes = Lambda_11_11_p1812_lanes + Lambda_11_11_p1036_lanes *
      Lambda_11_11_p678_lanes[2] + Lambda_11_11_p1048_lanes * Lambda_11_11_p840_lanes[2] +
      Lambda_11_11_p1060_lanes * Lambda_11_11_p966_lanes[2];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2034_lanes = Lambda_11_11_p1066_lanes * Lambda_11_11_p227_lanes[0] +
      Lambda_11_11_p1054_lanes * Lambda_11_11_p271_lanes[3] + Lambda_11_11_p1042_lanes *
      Lambda_11_11_p389_lanes[3] + Lambda_11_11_p1739_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2037_lanes = c4 * (s5 * Lambda_11_11_p1757_lanes - c5 *
      Lambda_11_11_p1765_lanes) + Lambda_11_11_p1859_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2045_lanes = -(s5 * Lambda_11_11_p1765_lanes + c5 *
      Lambda_11_11_p1757_lanes) - inverse_D2_p6 * Lambda_11_11_p1982_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2068_lanes = Lambda_11_11_p2030_lanes + Lambda_11_11_p1421_lanes *
      Lambda_11_11_p1373_lanes[2];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p2153_lanes = s4 * (s5 * Lambda_11_11_p1773_lanes - c5 *
      Lambda_11_11_p1781_lanes) + 0.21799999999999997 * Lambda_11_11_p2037_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p2167_lanes = Lambda_11_11_p2034_lanes + Lambda_11_11_p1036_lanes *
      Lambda_11_11_p678_lanes[3] + Lambda_11_11_p1048_lanes * Lambda_11_11_p840_lanes[3] +
      Lambda_11_11_p1060_lanes * Lambda_11_11_p966_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p2183_lanes = -Lambda_11_11_p2153_lanes - inverse_D3_p60 *
      Lambda_11_11_p1982_lanes;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p2191 = s16 * Lambda_11_11_p145_lanes[1] + c16 *
      Lambda_11_11_p131_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2192_lanes = Lambda_11_11_p2167_lanes + Lambda_11_11_p1421_lanes *
      Lambda_11_11_p1373_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2213_lanes = Lambda_11_11_p2183_lanes * inverse_D3;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p2221 = c16 * Lambda_11_11_p145_lanes[1] - s16 *
      Lambda_11_11_p131_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p2227_lanes = Lambda_11_11_p1066_lanes * Lambda_11_11_p227_lanes[1] +
      detail::make_pack<Real>(Lambda_11_11_p1054_lanes[4] * Lambda_11_11_p271_lanes[4],
      Lambda_11_11_p1054_lanes[4] * Lambda_11_11_p271_lanes[4], Lambda_11_11_p1054_lanes[4] *
      Lambda_11_11_p271_lanes[4], Lambda_11_11_p1054_lanes[4] * Lambda_11_11_p271_lanes[4],
      Lambda_11_11_p1054_lanes[4] * Lambda_11_11_p271_lanes[4], Lambda_11_11_p1054_lanes[5] *
      Lambda_11_11_p271_lanes[4], Lambda_11_11_p1054_lanes[4] * Lambda_11_11_p271_lanes[4],
      Lambda_11_11_p1054_lanes[4] * Lambda_11_11_p271_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p1042_lanes[4] * Lambda_11_11_p389_lanes[4],
      Lambda_11_11_p1042_lanes[4] * Lambda_11_11_p389_lanes[4], Lambda_11_11_p1042_lanes[4] *
      Lambda_11_11_p389_lanes[4], Lambda_11_11_p1042_lanes[4] * Lambda_11_11_p389_lanes[4],
      Lambda_11_11_p1042_lanes[4] * Lambda_11_11_p389_lanes[4], Lambda_11_11_p1042_lanes[5] *
      Lambda_11_11_p389_lanes[4], Lambda_11_11_p1042_lanes[4] * Lambda_11_11_p389_lanes[4],
      Lambda_11_11_p1042_lanes[4] * Lambda_11_11_p389_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p1030_lanes[4] * Lambda_11_11_p558_lanes[4],
      Lambda_11_11_p1030_lanes[4] * Lambda_11_11_p558_lanes[4], Lambda_11_11_p1030_lanes[4] *
      Lambda_11_11_p558_lanes[4], Lambda_11_11_p1030_lanes[4] * Lambda_11_11_p558_lanes[4],
      Lambda_11_11_p1030_lanes[4] * Lambda_11_11_p558_lanes[4], Lambda_11_11_p1030_lanes[5] *
      Lambda_11_11_p558_lanes[4], Lambda_11_11_p1030_lanes[4] * Lambda_11_11_p558_lanes[4],
      Lambda_11_11_p1030_lanes[4] * Lambda_11_11_p558_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p1036_lanes[4] * Lambda_11_11_p678_lanes[4],
      Lambda_11_11_p1036_lanes[4] * Lambda_11_11_p678_lanes[4], Lambda_11_11_p1036_lanes[4] *
      Lambda_11_11_p678_lanes[4], Lambda_11_11_p1036_lanes[4] * Lambda_11_11_p678_lanes[4],
      Lambda_11_11_p1036_lanes[4] * Lambda_11_11_p678_lanes[4], Lambda_11_11_p1036_lanes[5] *
      Lambda_11_11_p678_lanes[4], Lambda_11_11_p1036_lanes[4] * Lambda_11_11_p678_lanes[4],
      Lambda_11_11_p1036_lanes[4] * Lambda_11_11_p678_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p1048_lanes[4] * Lambda_11_11_p840_lanes[4],
      Lambda_11_11_p1048_lanes[4] * Lambda_11_11_p840_lanes[4], Lambda_11_11_p1048_lanes[4] *
      Lambda_11_11_p840_lanes[4], Lambda_11_11_p1048_lanes[4] * Lambda_11_11_p840_lanes[4],
      Lambda_11_11_p1048_lanes[4] * Lambda_11_11_p840_lanes[4], Lambda_11_11_p1048_lanes[5] *
      Lambda_11_11_p840_lanes[4], Lambda_11_11_p1048_lanes[4] * Lambda_11_11_p840_lanes[4],
      Lambda_11_11_p1048_lanes[4] * Lambda_11_11_p840_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2229_lanes = -Lambda_11_11_p2037_lanes - inverse_D2_p7 *
      Lambda_11_11_p1982_lanes - inverse_D2_p12 * Lambda_11_11_p2183_lanes;
  const Lanes<8> Lambda_11_11_p2237_lanes = -Lambda_11_11_p2045_lanes + inverse_D2_p11 *
      Lambda_11_11_p2183_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p2260 = c17 * Lambda_11_11_p2191 + s17 * Lambda_11_11_p147_lanes[1];
  const Real Lambda_11_11_p2261 = c17 * Lambda_11_11_p147_lanes[1] - s17 * Lambda_11_11_p2191;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2319_lanes = detail::make_pack<Real>(Lambda_11_11_p1568_lanes[0],
      Lambda_11_11_p1568_lanes[1], Lambda_11_11_p1568_lanes[2], Lambda_11_11_p1568_lanes[3],
      Lambda_11_11_p1568_lanes[4], Lambda_11_11_p1568_lanes[5], Lambda_11_11_p1428 *
      Lambda_11_11_p1373_lanes[0], Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[0]) +
      Lambda_11_11_p1713_lanes * Lambda_11_11_p1648_lanes[0] + Lambda_11_11_p2014_lanes *
      Lambda_11_11_p1982_lanes[0] + Lambda_11_11_p2213_lanes * Lambda_11_11_p2183_lanes[0];
  const Lanes<8> Lambda_11_11_p2327_lanes = detail::make_pack<Real>(Lambda_11_11_p1668_lanes[1],
      Lambda_11_11_p1668_lanes[1], Lambda_11_11_p1668_lanes[2], Lambda_11_11_p1668_lanes[3],
      Lambda_11_11_p1668_lanes[4], Lambda_11_11_p1668_lanes[5], Lambda_11_11_p1428 *
      Lambda_11_11_p1373_lanes[1], Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[1]) +
      Lambda_11_11_p1713_lanes * Lambda_11_11_p1648_lanes[1] + Lambda_11_11_p2014_lanes *
      Lambda_11_11_p1982_lanes[1] + Lambda_11_11_p2213_lanes * Lambda_11_11_p2183_lanes[1];
  const Lanes<8> Lambda_11_11_p2334_lanes = detail::make_pack<Real>(Lambda_11_11_p2068_lanes[2],
      Lambda_11_11_p2068_lanes[2], Lambda_11_11_p2068_lanes[2], Lambda_11_11_p2068_lanes[3],
      Lambda_11_11_p2068_lanes[4], Lambda_11_11_p2068_lanes[5], Lambda_11_11_p1428 *
      Lambda_11_11_p1373_lanes[2], Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[2]) +
      Lambda_11_11_p1713_lanes * Lambda_11_11_p1648_lanes[2] + Lambda_11_11_p2014_lanes *
      Lambda_11_11_p1982_lanes[2] + Lambda_11_11_p2213_lanes * Lambda_11_11_p2183_lanes[2];
  const Lanes<8> Lambda_11_11_p2340_lanes = detail::make_pack<Real>(Lambda_11_11_p2192_lanes[3],
      Lambda_11_11_p2192_lanes[3], Lambda_11_11_p2192_lanes[3], Lambda_11_11_p2192_lanes[3],
      Lambda_11_11_p2192_lanes[4], Lambda_11_11_p2192_lanes[5], Lambda_11_11_p1428 *
      Lambda_11_11_p1373_lanes[3], Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[3]) +
      Lambda_11_11_p1713_lanes * Lambda_11_11_p1648_lanes[3] + Lambda_11_11_p2014_lanes *
      Lambda_11_11_p1982_lanes[3] + Lambda_11_11_p2213_lanes * Lambda_11_11_p2183_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p2345_lanes = Lambda_11_11_p2227_lanes +
      detail::make_pack<Real>(Lambda_11_11_p1060_lanes[4] * Lambda_11_11_p966_lanes[4],
      Lambda_11_11_p1060_lanes[4] * Lambda_11_11_p966_lanes[4], Lambda_11_11_p1060_lanes[4] *
      Lambda_11_11_p966_lanes[4], Lambda_11_11_p1060_lanes[4] * Lambda_11_11_p966_lanes[4],
      Lambda_11_11_p1060_lanes[4] * Lambda_11_11_p966_lanes[4], Lambda_11_11_p1060_lanes[5] *
      Lambda_11_11_p966_lanes[4], Lambda_11_11_p1060_lanes[4] * Lambda_11_11_p966_lanes[4],
      Lambda_11_11_p1060_lanes[4] * Lambda_11_11_p966_lanes[4]) +
      detail::make_pack<Real>(Lambda_11_11_p1421_lanes[4] * Lambda_11_11_p1373_lanes[4],
      Lambda_11_11_p1421_lanes[4] * Lambda_11_11_p1373_lanes[4], Lambda_11_11_p1421_lanes[4] *
      Lambda_11_11_p1373_lanes[4], Lambda_11_11_p1421_lanes[4] * Lambda_11_11_p1373_lanes[4],
      Lambda_11_11_p1421_lanes[4] * Lambda_11_11_p1373_lanes[4], Lambda_11_11_p1421_lanes[5] *
      Lambda_11_11_p1373_lanes[4], Lambda_11_11_p1421_lanes[4] * Lambda_11_11_p1373_lanes[4],
      Lambda_11_11_p1421_lanes[4] * Lambda_11_11_p1373_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2355_lanes = Lambda_11_11_p2 * Lambda_11_11_p2229_lanes -
      Lambda_11_11_p1 * Lambda_11_11_p2237_lanes;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p2363 = c18 * Lambda_11_11_p2260 + s18 * Lambda_11_11_p2221;
  const Real Lambda_11_11_p2364 = c18 * Lambda_11_11_p2221 - s18 * Lambda_11_11_p2260;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2389_lanes = inverse_D2_p2 *
      (Lambda_11_11_p1 * Lambda_11_11_p2229_lanes + Lambda_11_11_p2 * Lambda_11_11_p2237_lanes) +
      inverse_D2_p1 * Lambda_11_11_p2355_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p2397 = c19 * Lambda_11_11_p2261 - s19 * Lambda_11_11_p2363;
  const Real Lambda_11_11_p2398 = c19 * Lambda_11_11_p2363 + s19 * Lambda_11_11_p2261;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p2399_lanes = detail::make_pack<Real>(Lambda_11_11_p2345_lanes[4],
      Lambda_11_11_p2345_lanes[4], Lambda_11_11_p2345_lanes[4], Lambda_11_11_p2345_lanes[4],
      Lambda_11_11_p2345_lanes[4], Lambda_11_11_p2345_lanes[5], Lambda_11_11_p1428 *
      Lambda_11_11_p1373_lanes[4], Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[4]) +
      Lambda_11_11_p1713_lanes * Lambda_11_11_p1648_lanes[4] + Lambda_11_11_p2014_lanes *
      Lambda_11_11_p1982_lanes[4] + Lambda_11_11_p2213_lanes * Lambda_11_11_p2183_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p2411_lanes = Lambda_11_11_p2389_lanes * inverse_D2;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p2419_lanes = inverse_D10_p10_lanes[1] *
      detail::make_pack<Real>(Lambda_11_11_p110, Lambda_11_11_p110, Lambda_11_11_p44,
      Lambda_11_11_p2398, Lambda_11_11_p110, Lambda_11_11_p110, Lambda_11_11_p110,
      Lambda_11_11_p110);

  // link 1 (calf), articulated inertia
  const Real Lambda_11_11_p2454 = Lambda_11_11_p21_lanes[1] * Lambda_11_11_p2364 -
      Lambda_11_11_p11_lanes[1] * Lambda_11_11_p2397;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2467_lanes = -(inverse_D10_p11_lanes[1] *
      detail::make_pack<Real>(Lambda_11_11_p110, Lambda_11_11_p110, Lambda_11_11_p44,
      Lambda_11_11_p2398, Lambda_11_11_p110, Lambda_11_11_p110, Lambda_11_11_p110,
      Lambda_11_11_p110));

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p2470_lanes = 0.434 *
      (Lambda_11_11_p2355_lanes - inverse_D1_p2 * Lambda_11_11_p2389_lanes);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p2516_lanes = Lambda_11_11_p2470_lanes * inverse_D1;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p2524_lanes = detail::make_pack<Real>(-(Lambda_11_11_p21_lanes[1] *
      Lambda_11_11_p2398), Lambda_11_11_p103, Lambda_11_11_p40, Lambda_11_11_p2364,
      -(Lambda_11_11_p21_lanes[1] * Lambda_11_11_p2398),
      -(Lambda_11_11_p21_lanes[1] * Lambda_11_11_p2398),
      -(Lambda_11_11_p21_lanes[1] * Lambda_11_11_p2398),
      -(Lambda_11_11_p21_lanes[1] * Lambda_11_11_p2398)) + inverse_D12_p7_lanes[1] *
      detail::make_pack<Real>(Lambda_11_11_p2454, Lambda_11_11_p110, Lambda_11_11_p44,
      Lambda_11_11_p2398, Lambda_11_11_p2454, Lambda_11_11_p2454, Lambda_11_11_p2454,
      Lambda_11_11_p2454);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2555_lanes = inverse_D10_p23_lanes[1] * Lambda_11_11_p2524_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p2580_lanes = Lambda_11_11_p2319_lanes + Lambda_11_11_p2411_lanes *
      Lambda_11_11_p2389_lanes[0] + Lambda_11_11_p2516_lanes * Lambda_11_11_p2470_lanes[0];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2595_lanes = detail::make_pack<Real>(Lambda_11_11_p2397 +
      inverse_D10_p10_lanes[1] * Lambda_11_11_p2454, Lambda_11_11_p2419_lanes[1],
      Lambda_11_11_p2419_lanes[2], Lambda_11_11_p2419_lanes[3], Lambda_11_11_p2397 +
      inverse_D10_p10_lanes[1] * Lambda_11_11_p2454, Lambda_11_11_p2397 + inverse_D10_p10_lanes[1] *
      Lambda_11_11_p2454, Lambda_11_11_p2397 + inverse_D10_p10_lanes[1] * Lambda_11_11_p2454,
      Lambda_11_11_p2397 + inverse_D10_p10_lanes[1] * Lambda_11_11_p2454) -
      inverse_D10_p22_lanes[1] * Lambda_11_11_p2524_lanes;
  const Real Lambda_11_11_p2599 = Lambda_11_11_p2398 + inverse_D10_p23_lanes[1] *
      Lambda_11_11_p2524_lanes[0];
  const Lanes<8> Lambda_11_11_p2600_lanes = detail::make_pack<Real>(Lambda_11_11_p11_lanes[1] *
      Lambda_11_11_p2398, Lambda_11_11_p109, Lambda_11_11_p43, Lambda_11_11_p2397,
      Lambda_11_11_p11_lanes[1] * Lambda_11_11_p2398, Lambda_11_11_p11_lanes[1] *
      Lambda_11_11_p2398, Lambda_11_11_p11_lanes[1] * Lambda_11_11_p2398,
      Lambda_11_11_p11_lanes[1] * Lambda_11_11_p2398) + inverse_D11_p5_lanes[1] *
      detail::make_pack<Real>(Lambda_11_11_p2454, Lambda_11_11_p110, Lambda_11_11_p44,
      Lambda_11_11_p2398, Lambda_11_11_p2454, Lambda_11_11_p2454, Lambda_11_11_p2454,
      Lambda_11_11_p2454) - inverse_D11_p13_lanes[1] * Lambda_11_11_p2524_lanes;
  const Lanes<8> Lambda_11_11_p2604_lanes = detail::make_pack<Real>(Lambda_11_11_p2364 -
      inverse_D10_p11_lanes[1] * Lambda_11_11_p2454, Lambda_11_11_p2467_lanes[1],
      Lambda_11_11_p2467_lanes[2], Lambda_11_11_p2467_lanes[3], Lambda_11_11_p2364 -
      inverse_D10_p11_lanes[1] * Lambda_11_11_p2454, Lambda_11_11_p2364 - inverse_D10_p11_lanes[1] *
      Lambda_11_11_p2454, Lambda_11_11_p2364 - inverse_D10_p11_lanes[1] * Lambda_11_11_p2454,
      Lambda_11_11_p2364 - inverse_D10_p11_lanes[1] * Lambda_11_11_p2454) -
      inverse_D10_p24_lanes[1] * Lambda_11_11_p2524_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p2623 = Lambda_11_11_p2580_lanes[0] * Lambda_11_11_p2580_lanes[0];
  const Real Lambda_11_11_p2652 = Lambda_11_11_p2623 * Lambda_11_11_p2580_lanes[0];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2653_lanes = s19 * Lambda_11_11_p2595_lanes - c19 *
      detail::make_pack<Real>(Lambda_11_11_p2599, Lambda_11_11_p2555_lanes[1],
      Lambda_11_11_p2555_lanes[2], Lambda_11_11_p2555_lanes[3], Lambda_11_11_p2599,
      Lambda_11_11_p2599, Lambda_11_11_p2599, Lambda_11_11_p2599);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p2657_lanes = -(c19 * Lambda_11_11_p2600_lanes);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_11_11_p2689_lanes = Lambda_11_11_p2524_lanes * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p2701_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_11_11_p2454, Lambda_11_11_p110, Lambda_11_11_p44,
      Lambda_11_11_p2398, Lambda_11_11_p2454, Lambda_11_11_p2454, Lambda_11_11_p2454,
      Lambda_11_11_p2454);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p2705_lanes = Lambda_11_11_p2657_lanes * inverse_D11_lanes[1];
  const Lanes<8> Lambda_11_11_p2709_lanes = 0.269 * Lambda_11_11_p2604_lanes - s19 *
      Lambda_11_11_p2600_lanes - inverse_D10_p77_lanes[1] * Lambda_11_11_p2657_lanes;
  const Lanes<8> Lambda_11_11_p2713_lanes = -Lambda_11_11_p2653_lanes + inverse_D8_p16_lanes[1] *
      Lambda_11_11_p2657_lanes;
  const Lanes<8> Lambda_11_11_p2721_lanes = Lambda_11_11_p2604_lanes - inverse_D8_p17_lanes[1] *
      Lambda_11_11_p2657_lanes;
  const Lanes<8> Lambda_11_11_p2725_lanes = -(s19 *
      detail::make_pack<Real>(Lambda_11_11_p2599, Lambda_11_11_p2555_lanes[1],
      Lambda_11_11_p2555_lanes[2], Lambda_11_11_p2555_lanes[3], Lambda_11_11_p2599,
      Lambda_11_11_p2599, Lambda_11_11_p2599, Lambda_11_11_p2599) + c19 *
      Lambda_11_11_p2595_lanes) - inverse_D8_p18_lanes[1] * Lambda_11_11_p2657_lanes;
  const Lanes<8> Lambda_11_11_p2731_lanes = 0.269 * Lambda_11_11_p2653_lanes -
      inverse_D10_p78_lanes[1] * Lambda_11_11_p2657_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p2775 = Lambda_11_11_p2652 * Lambda_11_11_p2623 /
      (8.077935669463161e-28 + Lambda_11_11_p2652 * Lambda_11_11_p2652);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_11_11_p2786_lanes = s18 * Lambda_11_11_p2709_lanes + c18 *
      Lambda_11_11_p2731_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2808_lanes = inverse_D9_p7_lanes[1] * Lambda_11_11_p2786_lanes;
  const Lanes<8> Lambda_11_11_p2816_lanes = Lambda_11_11_p2786_lanes * inverse_D10_lanes[1];
  const Lanes<8> Lambda_11_11_p2820_lanes = c18 * Lambda_11_11_p2709_lanes - s18 *
      Lambda_11_11_p2731_lanes - inverse_D9_p9_lanes[1] * Lambda_11_11_p2786_lanes;
  const Lanes<8> Lambda_11_11_p2824_lanes = -Lambda_11_11_p2725_lanes - inverse_D8_p81_lanes[1] *
      Lambda_11_11_p2786_lanes;
  const Lanes<8> Lambda_11_11_p2828_lanes = c18 * Lambda_11_11_p2713_lanes - s18 *
      Lambda_11_11_p2721_lanes - inverse_D8_p80_lanes[1] * Lambda_11_11_p2786_lanes;
  const Lanes<8> Lambda_11_11_p2840_lanes = s18 * Lambda_11_11_p2713_lanes + c18 *
      Lambda_11_11_p2721_lanes - inverse_D8_p82_lanes[1] * Lambda_11_11_p2786_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p2844_lanes = detail::make_pack<Real>(Lambda_11_11_p1030_lanes[5],
      Lambda_11_11_p2816_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p558_lanes[5],
      Lambda_11_11_p2786_lanes[3]);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p2846_lanes = Lambda_11_11_p2580_lanes * Lambda_11_11_p2775;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_11_11_p2873_lanes = detail::make_pack<Real>(Lambda_11_11_p1066_lanes[5],
      Lambda_11_11_p2701_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p227_lanes[2],
      Lambda_11_11_p2398) + detail::make_pack<Real>(Lambda_11_11_p1054_lanes[5],
      Lambda_11_11_p2689_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p271_lanes[5],
      Lambda_11_11_p2524_lanes[3]) + detail::make_pack<Real>(Lambda_11_11_p1042_lanes[5],
      Lambda_11_11_p2705_lanes[3]) * detail::make_pack<Real>(Lambda_11_11_p389_lanes[5],
      Lambda_11_11_p2657_lanes[3]) + Lambda_11_11_p2844_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p2888_lanes = c17 * Lambda_11_11_p2808_lanes - s17 *
      Lambda_11_11_p2820_lanes;
  const Lanes<8> Lambda_11_11_p2892_lanes = s17 * Lambda_11_11_p2824_lanes - c17 *
      Lambda_11_11_p2828_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p2912 = 1065.380700001509 * Lambda_11_11_p118 * Lambda_11_11_p118 +
      Lambda_11_11_p133 * inverse_D12_lanes[1] * Lambda_11_11_p133 + Lambda_11_11_p172 *
      inverse_D11_lanes[1] * Lambda_11_11_p172;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p2913_lanes = inverse_D8_p149_lanes[1] * Lambda_11_11_p2888_lanes;
  const Lanes<8> Lambda_11_11_p2925_lanes = Lambda_11_11_p2888_lanes * inverse_D9_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p2929_lanes = Lambda_11_11_p2327_lanes + Lambda_11_11_p2411_lanes *
      Lambda_11_11_p2389_lanes[1] + Lambda_11_11_p2516_lanes * Lambda_11_11_p2470_lanes[1] -
      Lambda_11_11_p2846_lanes * Lambda_11_11_p2580_lanes[1];
  const Lanes<8> Lambda_11_11_p2936_lanes = Lambda_11_11_p2334_lanes + Lambda_11_11_p2411_lanes *
      Lambda_11_11_p2389_lanes[2] + Lambda_11_11_p2516_lanes * Lambda_11_11_p2470_lanes[2] -
      Lambda_11_11_p2846_lanes * Lambda_11_11_p2580_lanes[2];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p2946 = Lambda_11_11_p99 * inverse_D9_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p2947_lanes = Lambda_11_11_p2340_lanes + Lambda_11_11_p2411_lanes *
      Lambda_11_11_p2389_lanes[3] + Lambda_11_11_p2516_lanes * Lambda_11_11_p2470_lanes[3] -
      Lambda_11_11_p2846_lanes * Lambda_11_11_p2580_lanes[3];
  const Lanes<8> Lambda_11_11_p2952_lanes = Lambda_11_11_p2399_lanes + Lambda_11_11_p2411_lanes *
      Lambda_11_11_p2389_lanes[4] + Lambda_11_11_p2516_lanes * Lambda_11_11_p2470_lanes[4] -
      Lambda_11_11_p2846_lanes * Lambda_11_11_p2580_lanes[4];

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p2956 = 1065.380700001509 * Lambda_11_11_p49;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p2957 = Lambda_11_11_p89 * inverse_D10_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p2958 = Lambda_11_11_p50 * inverse_D12_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p2959 = Lambda_11_11_p115 * inverse_D8_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p2960 = Lambda_11_11_p144 * inverse_D7_lanes[1];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p2961 = Lambda_11_11_p2929_lanes[1] * Lambda_11_11_p2929_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p2962_lanes = c17 * Lambda_11_11_p2820_lanes + s17 *
      Lambda_11_11_p2808_lanes + 0.282 * Lambda_11_11_p2840_lanes - Lambda_11_11_p2913_lanes;
  const Lanes<8> Lambda_11_11_p2966_lanes = 0.282 * Lambda_11_11_p2892_lanes -
      inverse_D8_p150_lanes[1] * Lambda_11_11_p2888_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p2972 = Lambda_11_11_p72 * inverse_D11_lanes[1];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p2989 = Lambda_11_11_p2961 * Lambda_11_11_p2929_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p2992 = Lambda_11_11_p2912 + Lambda_11_11_p213 * inverse_D10_lanes[1] *
      Lambda_11_11_p213 + Lambda_11_11_p249 * inverse_D9_lanes[1] * Lambda_11_11_p249 +
      Lambda_11_11_p380 * inverse_D8_lanes[1] * Lambda_11_11_p380;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p2993_lanes = c16 * Lambda_11_11_p2962_lanes - s16 *
      Lambda_11_11_p2966_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p3005_lanes = Lambda_11_11_p41_lanes[1] * Lambda_11_11_p2993_lanes;
  const Lanes<8> Lambda_11_11_p3009_lanes = Lambda_11_11_p2993_lanes * inverse_D8_lanes[1];
  const Lanes<8> Lambda_11_11_p3013_lanes = s16 * Lambda_11_11_p2962_lanes + c16 *
      Lambda_11_11_p2966_lanes - inverse_D7_p8_lanes[1] * Lambda_11_11_p2993_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3023 = Lambda_11_11_p2989 * Lambda_11_11_p2961 /
      (8.077935669463161e-28 + Lambda_11_11_p2989 * Lambda_11_11_p2989);

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p3024 = Lambda_11_11_p2992 + Lambda_11_11_p557 * inverse_D7_lanes[1] *
      Lambda_11_11_p557 + Lambda_11_11_p1428 * Lambda_11_11_p1373_lanes[6] +
      Lambda_11_11_p1713_lanes[6] * Lambda_11_11_p1648_lanes[6] + Lambda_11_11_p2014_lanes[6] *
      Lambda_11_11_p1982_lanes[6];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p3029 = Lambda_11_11_p2956 * Lambda_11_11_p118 + Lambda_11_11_p2958 *
      Lambda_11_11_p133 + Lambda_11_11_p2972 * Lambda_11_11_p172 + Lambda_11_11_p2957 *
      Lambda_11_11_p213 + Lambda_11_11_p2946 * Lambda_11_11_p249;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p3032_lanes = s15 * Lambda_11_11_p3005_lanes + c15 *
      Lambda_11_11_p3013_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3048_lanes = Lambda_11_11_p468_lanes[1] * Lambda_11_11_p3032_lanes;
  const Lanes<8> Lambda_11_11_p3052_lanes = Lambda_11_11_p3032_lanes * inverse_D7_lanes[1];
  const Lanes<8> Lambda_11_11_p3056_lanes = inverse_D6_p294_lanes[1] * Lambda_11_11_p3032_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p3072 = Lambda_11_11_p2956 * Lambda_11_11_p49 + Lambda_11_11_p2958 *
      Lambda_11_11_p50 + Lambda_11_11_p2972 * Lambda_11_11_p72 + Lambda_11_11_p2957 *
      Lambda_11_11_p89 + Lambda_11_11_p2946 * Lambda_11_11_p99;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3081_lanes = Lambda_11_11_p2929_lanes * Lambda_11_11_p3023;
  const Real Lambda_11_11_p3093 = Lambda_11_11_p3024 + Lambda_11_11_p2213_lanes[6] *
      Lambda_11_11_p2183_lanes[6] + Lambda_11_11_p2411_lanes[6] * Lambda_11_11_p2389_lanes[6] +
      Lambda_11_11_p2516_lanes[6] * Lambda_11_11_p2470_lanes[6] - Lambda_11_11_p2846_lanes[6] *
      Lambda_11_11_p2580_lanes[6];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p3094_lanes = -Lambda_11_11_p2892_lanes + inverse_D6_p31_lanes[1] *
      Lambda_11_11_p2888_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3106_lanes = c15 * Lambda_11_11_p3005_lanes - s15 *
      Lambda_11_11_p3013_lanes - inverse_D6_p332_lanes[1] * Lambda_11_11_p3032_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p3110_lanes = Lambda_11_11_p2840_lanes - inverse_D6_p33_lanes[1] *
      Lambda_11_11_p2888_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p3114 = Lambda_11_11_p3029 + Lambda_11_11_p2959 * Lambda_11_11_p380 +
      Lambda_11_11_p2960 * Lambda_11_11_p557 + Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[6] +
      Lambda_11_11_p1713_lanes[7] * Lambda_11_11_p1648_lanes[6];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_11_11_p3166_lanes = Lambda_11_11_p2873_lanes +
      detail::make_pack<Real>(Lambda_11_11_p1036_lanes[5], Lambda_11_11_p2925_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p678_lanes[5], Lambda_11_11_p2888_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p1048_lanes[5], Lambda_11_11_p3009_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p840_lanes[5], Lambda_11_11_p2993_lanes[3]) +
      detail::make_pack<Real>(Lambda_11_11_p1060_lanes[5], Lambda_11_11_p3052_lanes[3]) *
      detail::make_pack<Real>(Lambda_11_11_p966_lanes[5], Lambda_11_11_p3032_lanes[3]);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3179_lanes = Lambda_11_11_p2936_lanes - Lambda_11_11_p3081_lanes *
      Lambda_11_11_p2929_lanes[2];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_11_11_p3206_lanes = -(s17 * Lambda_11_11_p2828_lanes + c17 *
      Lambda_11_11_p2824_lanes) + inverse_D6_p35_lanes[1] * Lambda_11_11_p2888_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3222 = Lambda_11_11_p3179_lanes[2] * Lambda_11_11_p3179_lanes[2];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_11_11_p3223_lanes = s16 * Lambda_11_11_p3094_lanes + c16 *
      Lambda_11_11_p3110_lanes - inverse_D6_p163_lanes[1] * Lambda_11_11_p2993_lanes;
  const Lanes<8> Lambda_11_11_p3235_lanes = -Lambda_11_11_p3206_lanes + inverse_D6_p161_lanes[1] *
      Lambda_11_11_p2993_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p3246 = Lambda_11_11_p3072 + Lambda_11_11_p2959 * Lambda_11_11_p115 +
      Lambda_11_11_p2960 * Lambda_11_11_p144 + Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[7] +
      Lambda_11_11_p1713_lanes[7] * Lambda_11_11_p1648_lanes[7];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3247 = Lambda_11_11_p3222 * Lambda_11_11_p3179_lanes[2];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3252_lanes = c16 * Lambda_11_11_p3094_lanes - s16 *
      Lambda_11_11_p3110_lanes - inverse_D6_p165_lanes[1] * Lambda_11_11_p2993_lanes -
      Lambda_11_11_p3056_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3279 = Lambda_11_11_p3114 + Lambda_11_11_p2014_lanes[7] *
      Lambda_11_11_p1982_lanes[6] + Lambda_11_11_p2213_lanes[7] * Lambda_11_11_p2183_lanes[6] +
      Lambda_11_11_p2411_lanes[7] * Lambda_11_11_p2389_lanes[6] + Lambda_11_11_p2516_lanes[7] *
      Lambda_11_11_p2470_lanes[6];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3288_lanes = detail::make_pack<Real>(Lambda_11_11_p3166_lanes[0] +
      Lambda_11_11_p1421_lanes[5] * Lambda_11_11_p1373_lanes[5], Lambda_11_11_p3166_lanes[0] +
      Lambda_11_11_p1421_lanes[5] * Lambda_11_11_p1373_lanes[5], Lambda_11_11_p3166_lanes[0] +
      Lambda_11_11_p1421_lanes[5] * Lambda_11_11_p1373_lanes[5], Lambda_11_11_p3166_lanes[0] +
      Lambda_11_11_p1421_lanes[5] * Lambda_11_11_p1373_lanes[5], Lambda_11_11_p3166_lanes[0] +
      Lambda_11_11_p1421_lanes[5] * Lambda_11_11_p1373_lanes[5], Lambda_11_11_p3166_lanes[0] +
      Lambda_11_11_p1421_lanes[5] * Lambda_11_11_p1373_lanes[5], Lambda_11_11_p1428 *
      Lambda_11_11_p1373_lanes[5], Lambda_11_11_p1427 * Lambda_11_11_p1373_lanes[5]) +
      Lambda_11_11_p1713_lanes * Lambda_11_11_p1648_lanes[5] + Lambda_11_11_p2014_lanes *
      Lambda_11_11_p1982_lanes[5] + Lambda_11_11_p2213_lanes * Lambda_11_11_p2183_lanes[5];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3291_lanes = c15 * Lambda_11_11_p3235_lanes - s15 *
      Lambda_11_11_p3223_lanes - inverse_D6_p292_lanes[1] * Lambda_11_11_p3032_lanes;
  const Lanes<8> Lambda_11_11_p3295_lanes = s15 * Lambda_11_11_p3235_lanes + c15 *
      Lambda_11_11_p3223_lanes - inverse_D6_p299_lanes[1] * Lambda_11_11_p3032_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3302 = Lambda_11_11_p3247 * Lambda_11_11_p3222 /
      (8.077935669463161e-28 + Lambda_11_11_p3247 * Lambda_11_11_p3247);
  const Real Lambda_11_11_p3318 = Lambda_11_11_p3246 + Lambda_11_11_p2014_lanes[7] *
      Lambda_11_11_p1982_lanes[7] + Lambda_11_11_p2213_lanes[7] * Lambda_11_11_p2183_lanes[7] +
      Lambda_11_11_p2411_lanes[7] * Lambda_11_11_p2389_lanes[7] + Lambda_11_11_p2516_lanes[7] *
      Lambda_11_11_p2470_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3319_lanes = s14 * Lambda_11_11_p3252_lanes + c14 *
      Lambda_11_11_p3291_lanes;
  const Lanes<8> Lambda_11_11_p3323_lanes = c14 * Lambda_11_11_p3252_lanes - s14 *
      Lambda_11_11_p3291_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3327_lanes = Lambda_11_11_p3288_lanes + Lambda_11_11_p2411_lanes *
      Lambda_11_11_p2389_lanes[5] + Lambda_11_11_p2516_lanes * Lambda_11_11_p2470_lanes[5] -
      Lambda_11_11_p2846_lanes * Lambda_11_11_p2580_lanes[5];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p3345_lanes = 0.226 * Lambda_11_11_p3295_lanes + (-0.18) *
      Lambda_11_11_p3319_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3353_lanes = Lambda_11_11_p3179_lanes * Lambda_11_11_p3302;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3367_lanes = -(c14 * Lambda_11_11_p3048_lanes + s14 *
      Lambda_11_11_p3106_lanes + Lambda_11_11_p3345_lanes);
  const Lanes<8> Lambda_11_11_p3371_lanes = inverse_D5_p73 * Lambda_11_11_p3367_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3398_lanes = Lambda_11_11_p2947_lanes - Lambda_11_11_p3081_lanes *
      Lambda_11_11_p2929_lanes[3] - Lambda_11_11_p3353_lanes * Lambda_11_11_p3179_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3403_lanes = (-0.18) * Lambda_11_11_p3323_lanes -
      (s14 * Lambda_11_11_p3048_lanes - c14 * Lambda_11_11_p3106_lanes) - Lambda_11_11_p3371_lanes;
  const Lanes<8> Lambda_11_11_p3407_lanes = 0.226 * Lambda_11_11_p3323_lanes - inverse_D5_p72 *
      Lambda_11_11_p3367_lanes;
  const Lanes<8> Lambda_11_11_p3411_lanes = Lambda_11_11_p3323_lanes - inverse_D5_p71 *
      Lambda_11_11_p3367_lanes;
  const Lanes<8> Lambda_11_11_p3415_lanes = Lambda_11_11_p3319_lanes + inverse_D3_p14 *
      Lambda_11_11_p3367_lanes;
  const Lanes<8> Lambda_11_11_p3419_lanes = Lambda_11_11_p3295_lanes - inverse_D3_p15 *
      Lambda_11_11_p3367_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3430 = Lambda_11_11_p3398_lanes[3] * Lambda_11_11_p3398_lanes[3];
  const Real Lambda_11_11_p3467 = Lambda_11_11_p3430 * Lambda_11_11_p3398_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_11_11_p3476_lanes = s6 * Lambda_11_11_p3415_lanes + c6 *
      Lambda_11_11_p3419_lanes;
  const Lanes<8> Lambda_11_11_p3480_lanes = Lambda_11_11_p3367_lanes * inverse_D6;
  const Lanes<8> Lambda_11_11_p3488_lanes = s6 * Lambda_11_11_p3403_lanes + c6 *
      Lambda_11_11_p3407_lanes + 0.072 * Lambda_11_11_p3411_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p3520_lanes = Lambda_11_11_p3488_lanes * inverse_D5;
  const Lanes<8> Lambda_11_11_p3532_lanes = c6 * Lambda_11_11_p3415_lanes - s6 *
      Lambda_11_11_p3419_lanes - inverse_D3_p35 * Lambda_11_11_p3488_lanes;
  const Lanes<8> Lambda_11_11_p3536_lanes = Lambda_11_11_p3411_lanes - inverse_D3_p34 *
      Lambda_11_11_p3488_lanes;
  const Lanes<8> Lambda_11_11_p3540_lanes = c6 * Lambda_11_11_p3403_lanes - s6 *
      Lambda_11_11_p3407_lanes - inverse_D4_p11 * Lambda_11_11_p3488_lanes;
  const Lanes<8> Lambda_11_11_p3544_lanes = -(0.072 * Lambda_11_11_p3476_lanes) + inverse_D4_p10 *
      Lambda_11_11_p3488_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3548 = Lambda_11_11_p3467 * Lambda_11_11_p3430 /
      (3.552713678800501e-15 + Lambda_11_11_p3467 * Lambda_11_11_p3467);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p3577_lanes = s4 * (Lambda_11_11_p3476_lanes - inverse_D3_p36 *
      Lambda_11_11_p3488_lanes);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3641_lanes = -(s5 * Lambda_11_11_p3544_lanes + c5 *
      Lambda_11_11_p3540_lanes);
  const Lanes<8> Lambda_11_11_p3657_lanes = Lambda_11_11_p3641_lanes * inverse_D4;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3673_lanes = Lambda_11_11_p3398_lanes * Lambda_11_11_p3548;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p3677_lanes = c4 * (s5 * Lambda_11_11_p3532_lanes - c5 *
      Lambda_11_11_p3536_lanes) + Lambda_11_11_p3577_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3681_lanes = -(s5 * Lambda_11_11_p3536_lanes + c5 *
      Lambda_11_11_p3532_lanes) - inverse_D2_p6 * Lambda_11_11_p3641_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_11_11_p3756_lanes = s4 * (s5 * Lambda_11_11_p3540_lanes - c5 *
      Lambda_11_11_p3544_lanes) + 0.21799999999999997 * Lambda_11_11_p3677_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3760_lanes = Lambda_11_11_p2952_lanes - Lambda_11_11_p3081_lanes *
      Lambda_11_11_p2929_lanes[4] - Lambda_11_11_p3353_lanes * Lambda_11_11_p3179_lanes[4] -
      Lambda_11_11_p3673_lanes * Lambda_11_11_p3398_lanes[4];
  const Lanes<8> Lambda_11_11_p3764_lanes = Lambda_11_11_p3327_lanes - Lambda_11_11_p3081_lanes *
      Lambda_11_11_p2929_lanes[5] - Lambda_11_11_p3353_lanes * Lambda_11_11_p3179_lanes[5] -
      Lambda_11_11_p3673_lanes * Lambda_11_11_p3398_lanes[5];
  const Real Lambda_11_11_p3771 = Lambda_11_11_p3279 - Lambda_11_11_p2846_lanes[7] *
      Lambda_11_11_p2580_lanes[6] - Lambda_11_11_p3081_lanes[7] * Lambda_11_11_p2929_lanes[6] -
      Lambda_11_11_p3353_lanes[7] * Lambda_11_11_p3179_lanes[6] - Lambda_11_11_p3673_lanes[7] *
      Lambda_11_11_p3398_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p3776_lanes = -Lambda_11_11_p3756_lanes - inverse_D3_p60 *
      Lambda_11_11_p3641_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3792 = Lambda_11_11_p3760_lanes[4] * Lambda_11_11_p3760_lanes[4];
  const Real Lambda_11_11_p3797 = Lambda_11_11_p3318 - Lambda_11_11_p2846_lanes[7] *
      Lambda_11_11_p2580_lanes[7] - Lambda_11_11_p3081_lanes[7] * Lambda_11_11_p2929_lanes[7] -
      Lambda_11_11_p3353_lanes[7] * Lambda_11_11_p3179_lanes[7] - Lambda_11_11_p3673_lanes[7] *
      Lambda_11_11_p3398_lanes[7];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3806_lanes = Lambda_11_11_p3776_lanes * inverse_D3;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3814 = Lambda_11_11_p3792 * Lambda_11_11_p3760_lanes[4];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3815_lanes = -Lambda_11_11_p3677_lanes - inverse_D2_p7 *
      Lambda_11_11_p3641_lanes - inverse_D2_p12 * Lambda_11_11_p3776_lanes;
  const Lanes<8> Lambda_11_11_p3819_lanes = -Lambda_11_11_p3681_lanes + inverse_D2_p11 *
      Lambda_11_11_p3776_lanes;
  const Lanes<8> Lambda_11_11_p3823_lanes = Lambda_11_11_p3806_lanes * Lambda_11_11_p2183_lanes[0];
  const Lanes<8> Lambda_11_11_p3827_lanes = Lambda_11_11_p3806_lanes * Lambda_11_11_p2183_lanes[1];
  const Lanes<8> Lambda_11_11_p3831_lanes = Lambda_11_11_p3806_lanes * Lambda_11_11_p2183_lanes[2];
  const Lanes<8> Lambda_11_11_p3835_lanes = Lambda_11_11_p3806_lanes * Lambda_11_11_p2183_lanes[3];
  const Lanes<8> Lambda_11_11_p3839_lanes = Lambda_11_11_p3806_lanes * Lambda_11_11_p2183_lanes[4];
  const Lanes<8> Lambda_11_11_p3843_lanes = Lambda_11_11_p3806_lanes * Lambda_11_11_p2183_lanes[5];
  const Lanes<8> Lambda_11_11_p3871_lanes = Lambda_11_11_p3480_lanes * Lambda_11_11_p1373_lanes[0] +
      Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[0] + Lambda_11_11_p3657_lanes *
      Lambda_11_11_p1982_lanes[0] + Lambda_11_11_p3823_lanes;
  const Lanes<8> Lambda_11_11_p3875_lanes = Lambda_11_11_p3480_lanes * Lambda_11_11_p1373_lanes[1] +
      Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[1] + Lambda_11_11_p3657_lanes *
      Lambda_11_11_p1982_lanes[1] + Lambda_11_11_p3827_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3879_lanes = Lambda_11_11_p2816_lanes * Lambda_11_11_p213;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3887_lanes = Lambda_11_11_p3480_lanes * Lambda_11_11_p1373_lanes[2] +
      Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[2] + Lambda_11_11_p3657_lanes *
      Lambda_11_11_p1982_lanes[2] + Lambda_11_11_p3831_lanes;
  const Lanes<8> Lambda_11_11_p3899_lanes = Lambda_11_11_p3480_lanes * Lambda_11_11_p1373_lanes[3] +
      Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[3] + Lambda_11_11_p3657_lanes *
      Lambda_11_11_p1982_lanes[3] + Lambda_11_11_p3835_lanes;
  const Lanes<8> Lambda_11_11_p3911_lanes = Lambda_11_11_p3480_lanes * Lambda_11_11_p1373_lanes[4] +
      Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[4] + Lambda_11_11_p3657_lanes *
      Lambda_11_11_p1982_lanes[4] + Lambda_11_11_p3839_lanes;
  const Lanes<8> Lambda_11_11_p3919_lanes = Lambda_11_11_p2 * Lambda_11_11_p3815_lanes -
      Lambda_11_11_p1 * Lambda_11_11_p3819_lanes;
  const Lanes<8> Lambda_11_11_p3935_lanes = Lambda_11_11_p3480_lanes * Lambda_11_11_p1373_lanes[5] +
      Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[5] + Lambda_11_11_p3657_lanes *
      Lambda_11_11_p1982_lanes[5] + Lambda_11_11_p3843_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3943 = Lambda_11_11_p3814 * Lambda_11_11_p3792 /
      (5.551115123125783e-17 + Lambda_11_11_p3814 * Lambda_11_11_p3814);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_11_11_p3960_lanes = inverse_D2_p2 *
      (Lambda_11_11_p1 * Lambda_11_11_p3815_lanes + Lambda_11_11_p2 * Lambda_11_11_p3819_lanes) +
      inverse_D2_p1 * Lambda_11_11_p3919_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p3964_lanes = Lambda_11_11_p2701_lanes * Lambda_11_11_p118 +
      Lambda_11_11_p2689_lanes * Lambda_11_11_p133 + Lambda_11_11_p2705_lanes * Lambda_11_11_p172 +
      Lambda_11_11_p3879_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p3972_lanes = Lambda_11_11_p3960_lanes * inverse_D2;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p3996_lanes = Lambda_11_11_p3760_lanes * Lambda_11_11_p3943;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_11_11_p4027_lanes = 0.434 *
      (Lambda_11_11_p3919_lanes - inverse_D1_p2 * Lambda_11_11_p3960_lanes);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4055_lanes = Lambda_11_11_p2816_lanes * Lambda_11_11_p89;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4070_lanes = Lambda_11_11_p3964_lanes + Lambda_11_11_p2925_lanes *
      Lambda_11_11_p249 + Lambda_11_11_p3009_lanes * Lambda_11_11_p380 + Lambda_11_11_p3052_lanes *
      Lambda_11_11_p557;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4082_lanes = Lambda_11_11_p4027_lanes * inverse_D1;
  const Lanes<8> Lambda_11_11_p4110_lanes = Lambda_11_11_p3764_lanes - Lambda_11_11_p3996_lanes *
      Lambda_11_11_p3760_lanes[5];
  const Real Lambda_11_11_p4113 = Lambda_11_11_p3093 - Lambda_11_11_p3081_lanes[6] *
      Lambda_11_11_p2929_lanes[6] - Lambda_11_11_p3353_lanes[6] * Lambda_11_11_p3179_lanes[6] -
      Lambda_11_11_p3673_lanes[6] * Lambda_11_11_p3398_lanes[6] - Lambda_11_11_p3996_lanes[6] *
      Lambda_11_11_p3760_lanes[6];
  const Real Lambda_11_11_p4138 = Lambda_11_11_p4110_lanes[5] * Lambda_11_11_p4110_lanes[5];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4151_lanes = Lambda_11_11_p2701_lanes * Lambda_11_11_p49 +
      Lambda_11_11_p2689_lanes * Lambda_11_11_p50 + Lambda_11_11_p2705_lanes * Lambda_11_11_p72 +
      Lambda_11_11_p4055_lanes;
  const Lanes<8> Lambda_11_11_p4167_lanes = Lambda_11_11_p2816_lanes * Lambda_11_11_p2786_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4183_lanes = Lambda_11_11_p3871_lanes + Lambda_11_11_p3972_lanes *
      Lambda_11_11_p2389_lanes[0] + Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[0];
  const Real Lambda_11_11_p4199 = Lambda_11_11_p4138 * Lambda_11_11_p4110_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4208_lanes = Lambda_11_11_p4070_lanes + Lambda_11_11_p3480_lanes *
      Lambda_11_11_p1373_lanes[6] + Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[6] +
      Lambda_11_11_p3657_lanes * Lambda_11_11_p1982_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4224_lanes = Lambda_11_11_p4183_lanes * Lambda_11_11_p2775;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4284_lanes = Lambda_11_11_p4151_lanes + Lambda_11_11_p2925_lanes *
      Lambda_11_11_p99 + Lambda_11_11_p3009_lanes * Lambda_11_11_p115 + Lambda_11_11_p3052_lanes *
      Lambda_11_11_p144;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4300_lanes = Lambda_11_11_p2701_lanes * Lambda_11_11_p2454 +
      Lambda_11_11_p2689_lanes * Lambda_11_11_p2524_lanes[0] + Lambda_11_11_p2705_lanes *
      Lambda_11_11_p2657_lanes[0] + Lambda_11_11_p4167_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4324_lanes = Lambda_11_11_p3875_lanes + Lambda_11_11_p3972_lanes *
      Lambda_11_11_p2389_lanes[1] + Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[1] -
      Lambda_11_11_p4224_lanes * Lambda_11_11_p2580_lanes[1];
  const Lanes<8> Lambda_11_11_p4328_lanes = Lambda_11_11_p3887_lanes + Lambda_11_11_p3972_lanes *
      Lambda_11_11_p2389_lanes[2] + Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[2] -
      Lambda_11_11_p4224_lanes * Lambda_11_11_p2580_lanes[2];
  const Lanes<8> Lambda_11_11_p4332_lanes = Lambda_11_11_p3899_lanes + Lambda_11_11_p3972_lanes *
      Lambda_11_11_p2389_lanes[3] + Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[3] -
      Lambda_11_11_p4224_lanes * Lambda_11_11_p2580_lanes[3];
  const Lanes<8> Lambda_11_11_p4336_lanes = Lambda_11_11_p3911_lanes + Lambda_11_11_p3972_lanes *
      Lambda_11_11_p2389_lanes[4] + Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[4] -
      Lambda_11_11_p4224_lanes * Lambda_11_11_p2580_lanes[4];
  const Real Lambda_11_11_p4340 = Lambda_11_11_p4199 * Lambda_11_11_p4138 /
      (8.673617379884035e-19 + Lambda_11_11_p4199 * Lambda_11_11_p4199);
  const Lanes<8> Lambda_11_11_p4349_lanes = Lambda_11_11_p3935_lanes + Lambda_11_11_p3972_lanes *
      Lambda_11_11_p2389_lanes[5] + Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[5] -
      Lambda_11_11_p4224_lanes * Lambda_11_11_p2580_lanes[5];
  const Lanes<8> Lambda_11_11_p4353_lanes = Lambda_11_11_p4208_lanes + Lambda_11_11_p3806_lanes *
      Lambda_11_11_p2183_lanes[6] + Lambda_11_11_p3972_lanes * Lambda_11_11_p2389_lanes[6] +
      Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[6];
  const Lanes<8> Lambda_11_11_p4366_lanes = Lambda_11_11_p4324_lanes * Lambda_11_11_p3023;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4370_lanes = Lambda_11_11_p2816_lanes * Lambda_11_11_p2786_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4422_lanes = Lambda_11_11_p4300_lanes + Lambda_11_11_p2925_lanes *
      Lambda_11_11_p2888_lanes[0] + Lambda_11_11_p3009_lanes * Lambda_11_11_p2993_lanes[0] +
      Lambda_11_11_p3052_lanes * Lambda_11_11_p3032_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4426_lanes = Lambda_11_11_p4284_lanes + Lambda_11_11_p3480_lanes *
      Lambda_11_11_p1373_lanes[7] + Lambda_11_11_p3520_lanes * Lambda_11_11_p1648_lanes[7] +
      Lambda_11_11_p3657_lanes * Lambda_11_11_p1982_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4448_lanes = Lambda_11_11_p4328_lanes - Lambda_11_11_p4366_lanes *
      Lambda_11_11_p2929_lanes[2];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_11_11_p4476_lanes = Lambda_11_11_p2701_lanes * Lambda_11_11_p110 +
      Lambda_11_11_p2689_lanes * Lambda_11_11_p2524_lanes[1] + Lambda_11_11_p2705_lanes *
      Lambda_11_11_p2657_lanes[1] + Lambda_11_11_p4370_lanes;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4479 = Lambda_11_11_p4110_lanes[6] * Lambda_11_11_p4340;
  const Lanes<8> Lambda_11_11_p4480_lanes = Lambda_11_11_p4448_lanes * Lambda_11_11_p3302;
  const Real Lambda_11_11_p4484 = Lambda_11_11_p4110_lanes[7] * Lambda_11_11_p4340;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_11_11_p4496_lanes = Lambda_11_11_p2701_lanes * Lambda_11_11_p44;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4514_lanes = Lambda_11_11_p4422_lanes + Lambda_11_11_p3480_lanes *
      Lambda_11_11_p3367_lanes[0] + Lambda_11_11_p3520_lanes * Lambda_11_11_p3488_lanes[0] +
      Lambda_11_11_p3657_lanes * Lambda_11_11_p3641_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4518_lanes = Lambda_11_11_p4426_lanes + Lambda_11_11_p3806_lanes *
      Lambda_11_11_p2183_lanes[7] + Lambda_11_11_p3972_lanes * Lambda_11_11_p2389_lanes[7] +
      Lambda_11_11_p4082_lanes * Lambda_11_11_p2470_lanes[7];
  const Real Lambda_11_11_p4536 = Lambda_11_11_p4113 - Lambda_11_11_p4479 *
      Lambda_11_11_p4110_lanes[6];
  const Lanes<8> Lambda_11_11_p4537_lanes = Lambda_11_11_p4332_lanes - Lambda_11_11_p4366_lanes *
      Lambda_11_11_p2929_lanes[3] - Lambda_11_11_p4480_lanes * Lambda_11_11_p3179_lanes[3];
  const Real Lambda_11_11_p4541 = Lambda_11_11_p3771 - Lambda_11_11_p3996_lanes[7] *
      Lambda_11_11_p3760_lanes[6] - Lambda_11_11_p4484 * Lambda_11_11_p4110_lanes[6];
  const Lanes<8> Lambda_11_11_p4550_lanes = Lambda_11_11_p4353_lanes - Lambda_11_11_p4224_lanes *
      Lambda_11_11_p2580_lanes[6] - Lambda_11_11_p4366_lanes * Lambda_11_11_p2929_lanes[6] -
      Lambda_11_11_p4480_lanes * Lambda_11_11_p3179_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_11_11_p4562_lanes = Lambda_11_11_p4476_lanes + Lambda_11_11_p2925_lanes *
      Lambda_11_11_p2888_lanes[1] + Lambda_11_11_p3009_lanes * Lambda_11_11_p2993_lanes[1] +
      Lambda_11_11_p3052_lanes * Lambda_11_11_p3032_lanes[1];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p4565 = Lambda_11_11_p4536 * Lambda_11_11_p4536;
  const Lanes<8> Lambda_11_11_p4566_lanes = Lambda_11_11_p4537_lanes * Lambda_11_11_p3548;
  const Real Lambda_11_11_p4581 = Lambda_11_11_p4565 * Lambda_11_11_p4536;
  const Lanes<8> Lambda_11_11_p4598_lanes = Lambda_11_11_p4514_lanes + Lambda_11_11_p3806_lanes *
      Lambda_11_11_p3776_lanes[0] + Lambda_11_11_p3972_lanes * Lambda_11_11_p3960_lanes[0] +
      Lambda_11_11_p4082_lanes * Lambda_11_11_p4027_lanes[0];
  const Lanes<8> Lambda_11_11_p4602_lanes = Lambda_11_11_p4518_lanes - Lambda_11_11_p4224_lanes *
      Lambda_11_11_p2580_lanes[7] - Lambda_11_11_p4366_lanes * Lambda_11_11_p2929_lanes[7] -
      Lambda_11_11_p4480_lanes * Lambda_11_11_p3179_lanes[7];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4616 = Lambda_11_11_p4496_lanes[2] + Lambda_11_11_p2689_lanes[2] *
      Lambda_11_11_p2524_lanes[2] + Lambda_11_11_p2705_lanes[2] * Lambda_11_11_p2657_lanes[2] +
      Lambda_11_11_p2816_lanes[2] * Lambda_11_11_p2786_lanes[2] + Lambda_11_11_p2925_lanes[2] *
      Lambda_11_11_p2888_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4617_lanes = Lambda_11_11_p4336_lanes - Lambda_11_11_p4366_lanes *
      Lambda_11_11_p2929_lanes[4] - Lambda_11_11_p4480_lanes * Lambda_11_11_p3179_lanes[4] -
      Lambda_11_11_p4566_lanes * Lambda_11_11_p3398_lanes[4];
  const Lanes<8> Lambda_11_11_p4621_lanes = Lambda_11_11_p4349_lanes - Lambda_11_11_p4366_lanes *
      Lambda_11_11_p2929_lanes[5] - Lambda_11_11_p4480_lanes * Lambda_11_11_p3179_lanes[5] -
      Lambda_11_11_p4566_lanes * Lambda_11_11_p3398_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_11_11_p4637_lanes = Lambda_11_11_p4562_lanes + Lambda_11_11_p3480_lanes *
      Lambda_11_11_p3367_lanes[1] + Lambda_11_11_p3520_lanes * Lambda_11_11_p3488_lanes[1] +
      Lambda_11_11_p3657_lanes * Lambda_11_11_p3641_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4640_lanes = Lambda_11_11_p4617_lanes * Lambda_11_11_p3943;
  const Real Lambda_11_11_p4651 = Lambda_11_11_p4581 * Lambda_11_11_p4565 /
      (8.077935669463161e-28 + Lambda_11_11_p4581 * Lambda_11_11_p4581);
  const Lanes<8> Lambda_11_11_p4664_lanes = Lambda_11_11_p4598_lanes - Lambda_11_11_p4224_lanes *
      Lambda_11_11_p4183_lanes[0] - Lambda_11_11_p4366_lanes * Lambda_11_11_p4324_lanes[0] -
      Lambda_11_11_p4480_lanes * Lambda_11_11_p4448_lanes[0];
  const Lanes<8> Lambda_11_11_p4678_lanes = Lambda_11_11_p4621_lanes - Lambda_11_11_p4640_lanes *
      Lambda_11_11_p3760_lanes[5];
  const Lanes<8> Lambda_11_11_p4694_lanes = Lambda_11_11_p4637_lanes + Lambda_11_11_p3806_lanes *
      Lambda_11_11_p3776_lanes[1] + Lambda_11_11_p3972_lanes * Lambda_11_11_p3960_lanes[1] +
      Lambda_11_11_p4082_lanes * Lambda_11_11_p4027_lanes[1];

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4697 = Lambda_11_11_p4616 + Lambda_11_11_p3009_lanes[2] *
      Lambda_11_11_p2993_lanes[2] + Lambda_11_11_p3052_lanes[2] * Lambda_11_11_p3032_lanes[2] +
      Lambda_11_11_p3480_lanes[2] * Lambda_11_11_p3367_lanes[2] + Lambda_11_11_p3520_lanes[2] *
      Lambda_11_11_p3488_lanes[2];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p4698 = Lambda_11_11_p4496_lanes[3] + Lambda_11_11_p2689_lanes[3] *
      Lambda_11_11_p2524_lanes[2] + Lambda_11_11_p2705_lanes[3] * Lambda_11_11_p2657_lanes[2] +
      Lambda_11_11_p2816_lanes[3] * Lambda_11_11_p2786_lanes[2] + Lambda_11_11_p2925_lanes[3] *
      Lambda_11_11_p2888_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4699_lanes = Lambda_11_11_p4678_lanes * Lambda_11_11_p4340;
  const Real Lambda_11_11_p4728 = Lambda_11_11_p4541 * Lambda_11_11_p4651;
  const Real Lambda_0_0_p1 = Lambda_11_11_p3081_lanes[2] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p2846_lanes[2];
  const Lanes<8> Lambda_11_11_p4729_lanes = Lambda_11_11_p4694_lanes - Lambda_11_11_p4224_lanes *
      Lambda_11_11_p4183_lanes[1] - Lambda_11_11_p4366_lanes * Lambda_11_11_p4324_lanes[1] -
      Lambda_11_11_p4480_lanes * Lambda_11_11_p4448_lanes[1];
  const Lanes<8> Lambda_11_11_p4732_lanes = Lambda_11_11_p4550_lanes - Lambda_11_11_p4566_lanes *
      Lambda_11_11_p3398_lanes[6] - Lambda_11_11_p4640_lanes * Lambda_11_11_p3760_lanes[6] -
      Lambda_11_11_p4699_lanes * Lambda_11_11_p4110_lanes[6];
  const Lanes<8> Lambda_11_11_p4736_lanes = Lambda_11_11_p4602_lanes - Lambda_11_11_p4566_lanes *
      Lambda_11_11_p3398_lanes[7] - Lambda_11_11_p4640_lanes * Lambda_11_11_p3760_lanes[7] -
      Lambda_11_11_p4699_lanes * Lambda_11_11_p4110_lanes[7];
  const Lanes<8> Lambda_11_11_p4740_lanes = Lambda_11_11_p4664_lanes - Lambda_11_11_p4566_lanes *
      Lambda_11_11_p4537_lanes[0] - Lambda_11_11_p4640_lanes * Lambda_11_11_p4617_lanes[0] -
      Lambda_11_11_p4699_lanes * Lambda_11_11_p4678_lanes[0];

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p4744 = Lambda_11_11_p3166_lanes[1] + Lambda_11_11_p3480_lanes[3] *
      Lambda_11_11_p3367_lanes[3] + Lambda_11_11_p3520_lanes[3] * Lambda_11_11_p3488_lanes[3] +
      Lambda_11_11_p3657_lanes[3] * Lambda_11_11_p3641_lanes[3] + Lambda_11_11_p3806_lanes[3] *
      Lambda_11_11_p3776_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_11_11_p4748_lanes = Lambda_11_11_p4732_lanes * Lambda_11_11_p4651;
  const Real Lambda_11_11_p4752 = Lambda_11_11_p4697 + Lambda_11_11_p3657_lanes[2] *
      Lambda_11_11_p3641_lanes[2] + Lambda_11_11_p3806_lanes[2] * Lambda_11_11_p3776_lanes[2] +
      Lambda_11_11_p3972_lanes[2] * Lambda_11_11_p3960_lanes[2] + Lambda_11_11_p4082_lanes[2] *
      Lambda_11_11_p4027_lanes[2];

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p4753 = Lambda_11_11_p4698 + Lambda_11_11_p3009_lanes[3] *
      Lambda_11_11_p2993_lanes[2] + Lambda_11_11_p3052_lanes[3] * Lambda_11_11_p3032_lanes[2] +
      Lambda_11_11_p3480_lanes[3] * Lambda_11_11_p3367_lanes[2] + Lambda_11_11_p3520_lanes[3] *
      Lambda_11_11_p3488_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_0_0_p2 = Lambda_11_11_p3081_lanes[3] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p2846_lanes[3] - Lambda_11_11_p3353_lanes[3] * Lambda_0_0_p1;
  const Real Lambda_11_11_p4757 = Lambda_11_11_p3797 - Lambda_11_11_p3996_lanes[7] *
      Lambda_11_11_p3760_lanes[7] - Lambda_11_11_p4484 * Lambda_11_11_p4110_lanes[7] -
      Lambda_11_11_p4728 * Lambda_11_11_p4541;
  const Lanes<8> Lambda_11_11_p4769_lanes = Lambda_11_11_p4729_lanes - Lambda_11_11_p4566_lanes *
      Lambda_11_11_p4537_lanes[1] - Lambda_11_11_p4640_lanes * Lambda_11_11_p4617_lanes[1] -
      Lambda_11_11_p4699_lanes * Lambda_11_11_p4678_lanes[1];
  const Real Lambda_11_11_p4772 = Lambda_11_11_p4757 * Lambda_11_11_p4757;
  const Lanes<8> Lambda_11_11_p4773_lanes = Lambda_11_11_p4736_lanes - Lambda_11_11_p4748_lanes *
      Lambda_11_11_p4541;
  const Real Lambda_0_0_p3 = Lambda_11_11_p3081_lanes[4] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p2846_lanes[4] - Lambda_11_11_p3353_lanes[4] * Lambda_0_0_p1 -
      Lambda_11_11_p3673_lanes[4] * Lambda_0_0_p2;
  const Real Lambda_11_11_p4784 = Lambda_11_11_p4772 * Lambda_11_11_p4757;
  const Real Lambda_11_11_p4785 = Lambda_11_11_p4752 - Lambda_11_11_p4224_lanes[2] *
      Lambda_11_11_p4183_lanes[2] - Lambda_11_11_p4366_lanes[2] * Lambda_11_11_p4324_lanes[2] -
      Lambda_11_11_p4480_lanes[2] * Lambda_11_11_p4448_lanes[2] - Lambda_11_11_p4566_lanes[2] *
      Lambda_11_11_p4537_lanes[2];
  const Real Lambda_11_11_p4786 = Lambda_11_11_p4744 + Lambda_11_11_p3972_lanes[3] *
      Lambda_11_11_p3960_lanes[3] + Lambda_11_11_p4082_lanes[3] * Lambda_11_11_p4027_lanes[3] -
      Lambda_11_11_p4224_lanes[3] * Lambda_11_11_p4183_lanes[3] - Lambda_11_11_p4366_lanes[3] *
      Lambda_11_11_p4324_lanes[3];
  const Real Lambda_11_11_p4787 = Lambda_11_11_p4753 + Lambda_11_11_p3657_lanes[3] *
      Lambda_11_11_p3641_lanes[2] + Lambda_11_11_p3806_lanes[3] * Lambda_11_11_p3776_lanes[2] +
      Lambda_11_11_p3972_lanes[3] * Lambda_11_11_p3960_lanes[2] + Lambda_11_11_p4082_lanes[3] *
      Lambda_11_11_p4027_lanes[2];
  const Real Lambda_0_0_p4 = Lambda_11_11_p3081_lanes[5] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p2846_lanes[5] - Lambda_11_11_p3353_lanes[5] * Lambda_0_0_p1 -
      Lambda_11_11_p3673_lanes[5] * Lambda_0_0_p2 - Lambda_11_11_p3996_lanes[5] * Lambda_0_0_p3;
  const Real Lambda_0_0_p5 = Lambda_11_11_p3081_lanes[6] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p2846_lanes[6] - Lambda_11_11_p3353_lanes[6] * Lambda_0_0_p1 -
      Lambda_11_11_p3673_lanes[6] * Lambda_0_0_p2 - Lambda_11_11_p3996_lanes[6] * Lambda_0_0_p3;
  const Real Lambda_0_0_p6 = Lambda_11_11_p3081_lanes[7] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p2846_lanes[7] - Lambda_11_11_p3353_lanes[7] * Lambda_0_0_p1 -
      Lambda_11_11_p3673_lanes[7] * Lambda_0_0_p2 - Lambda_11_11_p3996_lanes[7] * Lambda_0_0_p3;
  const Real Lambda_11_11_p4788 = Lambda_11_11_p4784 * Lambda_11_11_p4772 /
      (8.077935669463161e-28 + Lambda_11_11_p4784 * Lambda_11_11_p4784);
  const Real Lambda_0_0_p7 = Lambda_11_11_p4366_lanes[0] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p4224_lanes[0] - Lambda_11_11_p4480_lanes[0] * Lambda_0_0_p1 -
      Lambda_11_11_p4566_lanes[0] * Lambda_0_0_p2 - Lambda_11_11_p4640_lanes[0] * Lambda_0_0_p3;
  const Real Lambda_0_0_p8 = Lambda_0_0_p5 - Lambda_11_11_p4479 * Lambda_0_0_p4;
  const Real Lambda_11_11_p4789 = Lambda_11_11_p4786 - Lambda_11_11_p4480_lanes[3] *
      Lambda_11_11_p4448_lanes[3] - Lambda_11_11_p4566_lanes[3] * Lambda_11_11_p4537_lanes[3] -
      Lambda_11_11_p4640_lanes[3] * Lambda_11_11_p4617_lanes[3] - Lambda_11_11_p4699_lanes[3] *
      Lambda_11_11_p4678_lanes[3];
  const Real Lambda_0_0_p9 = Lambda_11_11_p2846_lanes[1] * Lambda_11_11_p3023;
  const Real Lambda_0_11_p1 = Lambda_11_11_p4366_lanes[1] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p4224_lanes[1] - Lambda_11_11_p4480_lanes[1] * Lambda_0_0_p1 -
      Lambda_11_11_p4566_lanes[1] * Lambda_0_0_p2 - Lambda_11_11_p4640_lanes[1] * Lambda_0_0_p3;
  const Real Lambda_11_11_p4790 = Lambda_11_11_p4787 - Lambda_11_11_p4224_lanes[3] *
      Lambda_11_11_p4183_lanes[2] - Lambda_11_11_p4366_lanes[3] * Lambda_11_11_p4324_lanes[2] -
      Lambda_11_11_p4480_lanes[3] * Lambda_11_11_p4448_lanes[2] - Lambda_11_11_p4566_lanes[3] *
      Lambda_11_11_p4537_lanes[2];
  const Real Lambda_0_0_p10 = Lambda_0_0_p1 * Lambda_11_11_p3302;
  const Real Lambda_0_11_p2 = Lambda_11_11_p4366_lanes[2] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p4224_lanes[2] - Lambda_11_11_p4480_lanes[2] * Lambda_0_0_p1 -
      Lambda_11_11_p4566_lanes[2] * Lambda_0_0_p2 - Lambda_11_11_p4640_lanes[2] * Lambda_0_0_p3;
  const Real Lambda_0_0_p11 = Lambda_0_0_p6 - Lambda_11_11_p4484 * Lambda_0_0_p4 -
      Lambda_11_11_p4728 * Lambda_0_0_p8;
  const Real Lambda_0_1_p1 = Lambda_11_11_p3353_lanes[3] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p3081_lanes[3];
  const Real Lambda_0_0_p12 = Lambda_0_0_p2 * Lambda_11_11_p3548;
  const Lanes<8> Lambda_11_11_p4791_lanes = Lambda_11_11_p4773_lanes * Lambda_11_11_p4788;
  const Real Lambda_0_11_p3 = Lambda_11_11_p4366_lanes[3] * Lambda_11_11_p2846_lanes[1] -
      Lambda_11_11_p4224_lanes[3] - Lambda_11_11_p4480_lanes[3] * Lambda_0_0_p1 -
      Lambda_11_11_p4566_lanes[3] * Lambda_0_0_p2 - Lambda_11_11_p4640_lanes[3] * Lambda_0_0_p3;
  const Real Lambda_0_0_p13 = Lambda_0_0_p3 * Lambda_11_11_p3943;
  const Real Lambda_0_1_p2 = Lambda_11_11_p3353_lanes[4] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p3081_lanes[4] - Lambda_11_11_p3673_lanes[4] * Lambda_0_1_p1;
  const Lanes<8> Lambda_11_11_p4802_lanes = Lambda_11_11_p4740_lanes - Lambda_11_11_p4748_lanes *
      Lambda_11_11_p4732_lanes[0] - Lambda_11_11_p4791_lanes * Lambda_11_11_p4773_lanes[0];
  const Real Lambda_11_11_p4809 = Lambda_11_11_p4785 - Lambda_11_11_p4640_lanes[2] *
      Lambda_11_11_p4617_lanes[2] - Lambda_11_11_p4699_lanes[2] * Lambda_11_11_p4678_lanes[2] -
      Lambda_11_11_p4748_lanes[2] * Lambda_11_11_p4732_lanes[2] - Lambda_11_11_p4791_lanes[2] *
      Lambda_11_11_p4773_lanes[2];
  const Real Lambda_11_11_p4810 = Lambda_11_11_p4790 - Lambda_11_11_p4640_lanes[3] *
      Lambda_11_11_p4617_lanes[2] - Lambda_11_11_p4699_lanes[3] * Lambda_11_11_p4678_lanes[2] -
      Lambda_11_11_p4748_lanes[3] * Lambda_11_11_p4732_lanes[2] - Lambda_11_11_p4791_lanes[3] *
      Lambda_11_11_p4773_lanes[2];
  const Real Lambda_11_11_p4811 = Lambda_11_11_p4802_lanes[0] * Lambda_11_11_p4802_lanes[0];
  const Real Lambda_0_1_p3 = Lambda_11_11_p3353_lanes[5] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p3081_lanes[5] - Lambda_11_11_p3673_lanes[5] * Lambda_0_1_p1 -
      Lambda_11_11_p3996_lanes[5] * Lambda_0_1_p2;
  const Real Lambda_0_0_p14 = Lambda_0_0_p7 - Lambda_11_11_p4699_lanes[0] * Lambda_0_0_p4 -
      Lambda_11_11_p4748_lanes[0] * Lambda_0_0_p8 - Lambda_11_11_p4791_lanes[0] * Lambda_0_0_p11;
  const Real Lambda_11_11_p4812 = Lambda_11_11_p4811 * Lambda_11_11_p4802_lanes[0];
  const Real Lambda_0_0_p15 = Lambda_0_0_p4 * Lambda_11_11_p4340;
  const Real Lambda_0_1_p4 = Lambda_0_1_p3 * Lambda_11_11_p4340;
  const Real Lambda_0_1_p5 = Lambda_11_11_p3353_lanes[6] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p3081_lanes[6] - Lambda_11_11_p3673_lanes[6] * Lambda_0_1_p1 -
      Lambda_11_11_p3996_lanes[6] * Lambda_0_1_p2 - Lambda_11_11_p4479 * Lambda_0_1_p3;
  const Real Lambda_0_1_p6 = Lambda_11_11_p3353_lanes[7] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p3081_lanes[7] - Lambda_11_11_p3673_lanes[7] * Lambda_0_1_p1 -
      Lambda_11_11_p3996_lanes[7] * Lambda_0_1_p2 - Lambda_11_11_p4484 * Lambda_0_1_p3;
  const Real Lambda_0_1_p7 = Lambda_11_11_p4480_lanes[0] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p4366_lanes[0] - Lambda_11_11_p4566_lanes[0] * Lambda_0_1_p1 -
      Lambda_11_11_p4640_lanes[0] * Lambda_0_1_p2 - Lambda_11_11_p4699_lanes[0] * Lambda_0_1_p3;
  const Real Lambda_0_1_p8 = Lambda_11_11_p3081_lanes[2] * Lambda_11_11_p3302;
  const Real Lambda_1_11_p1 = Lambda_11_11_p4480_lanes[1] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p4366_lanes[1] - Lambda_11_11_p4566_lanes[1] * Lambda_0_1_p1 -
      Lambda_11_11_p4640_lanes[1] * Lambda_0_1_p2 - Lambda_11_11_p4699_lanes[1] * Lambda_0_1_p3;
  const Real Lambda_0_1_p9 = Lambda_0_1_p1 * Lambda_11_11_p3548;
  const Real Lambda_0_1_p10 = Lambda_0_1_p2 * Lambda_11_11_p3943;
  const Real Lambda_1_11_p2 = Lambda_11_11_p4480_lanes[2] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p4366_lanes[2] - Lambda_11_11_p4566_lanes[2] * Lambda_0_1_p1 -
      Lambda_11_11_p4640_lanes[2] * Lambda_0_1_p2 - Lambda_11_11_p4699_lanes[2] * Lambda_0_1_p3;
  const Real Lambda_0_0_p16 = Lambda_0_0_p8 * Lambda_11_11_p4651;
  const Real Lambda_0_1_p11 = Lambda_0_1_p5 * Lambda_11_11_p4651;
  const Real Lambda_11_11_p4813 = Lambda_11_11_p4812 * Lambda_11_11_p4811 /
      (8.077935669463161e-28 + Lambda_11_11_p4812 * Lambda_11_11_p4812);
  const Real Lambda_0_1_p12 = Lambda_0_1_p6 - Lambda_11_11_p4728 * Lambda_0_1_p5;
  const Real Lambda_2_11_p1 = Lambda_11_11_p3673_lanes[4] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p3353_lanes[4];
  const Real Lambda_1_11_p3 = Lambda_11_11_p4480_lanes[3] * Lambda_11_11_p3081_lanes[2] -
      Lambda_11_11_p4366_lanes[3] - Lambda_11_11_p4566_lanes[3] * Lambda_0_1_p1 -
      Lambda_11_11_p4640_lanes[3] * Lambda_0_1_p2 - Lambda_11_11_p4699_lanes[3] * Lambda_0_1_p3;
  const Real Lambda_0_0_p17 = Lambda_11_11_p2775 + Lambda_0_0_p9 * Lambda_11_11_p2846_lanes[1] +
      Lambda_0_0_p10 * Lambda_0_0_p1 + Lambda_0_0_p12 * Lambda_0_0_p2 + Lambda_0_0_p13 *
      Lambda_0_0_p3;
  const Real Lambda_0_1_p13 = Lambda_0_1_p7 - Lambda_11_11_p4748_lanes[0] * Lambda_0_1_p5 -
      Lambda_11_11_p4791_lanes[0] * Lambda_0_1_p12;
  const Real Lambda_2_11_p2 = Lambda_11_11_p3673_lanes[5] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p3353_lanes[5] - Lambda_11_11_p3996_lanes[5] * Lambda_2_11_p1;
  const Real Lambda_0_0_p18 = Lambda_0_0_p11 * Lambda_11_11_p4788;
  const Real Lambda_0_1_p14 = Lambda_0_1_p12 * Lambda_11_11_p4788;
  const Lanes<8> Lambda_11_11_p4814_lanes = Lambda_11_11_p4802_lanes * Lambda_11_11_p4813;
  const Real Lambda_0_1_p15 = Lambda_0_1_p9 * Lambda_0_0_p2 -
      (Lambda_0_0_p9 + Lambda_0_1_p8 * Lambda_0_0_p1) + Lambda_0_1_p10 * Lambda_0_0_p3 +
      Lambda_0_1_p4 * Lambda_0_0_p4;
  const Real Lambda_0_0_p19 = Lambda_0_0_p14 * Lambda_11_11_p4813;
  const Real Lambda_2_11_p3 = Lambda_11_11_p3673_lanes[6] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p3353_lanes[6] - Lambda_11_11_p3996_lanes[6] * Lambda_2_11_p1 -
      Lambda_11_11_p4479 * Lambda_2_11_p2;
  const Real Lambda_0_1_p16 = Lambda_0_1_p13 * Lambda_11_11_p4813;
  const Real Lambda_0_2_p1 = Lambda_11_11_p3353_lanes[3] * Lambda_11_11_p3548;
  const Real Lambda_0_2_p2 = Lambda_2_11_p1 * Lambda_11_11_p3943;
  const Real Lambda_0_2_p3 = Lambda_2_11_p2 * Lambda_11_11_p4340;
  const Lanes<8> Lambda_11_11_p4820_lanes = Lambda_11_11_p4769_lanes - Lambda_11_11_p4748_lanes *
      Lambda_11_11_p4732_lanes[1] - Lambda_11_11_p4791_lanes * Lambda_11_11_p4773_lanes[1] -
      Lambda_11_11_p4814_lanes * Lambda_11_11_p4802_lanes[1];
  const Real Lambda_2_11_p4 = Lambda_11_11_p3673_lanes[7] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p3353_lanes[7] - Lambda_11_11_p3996_lanes[7] * Lambda_2_11_p1 -
      Lambda_11_11_p4484 * Lambda_2_11_p2 - Lambda_11_11_p4728 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_11_11_p4566_lanes[0] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p4480_lanes[0] - Lambda_11_11_p4640_lanes[0] * Lambda_2_11_p1 -
      Lambda_11_11_p4699_lanes[0] * Lambda_2_11_p2 - Lambda_11_11_p4748_lanes[0] * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_11_11_p4566_lanes[1] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p4480_lanes[1] - Lambda_11_11_p4640_lanes[1] * Lambda_2_11_p1 -
      Lambda_11_11_p4699_lanes[1] * Lambda_2_11_p2 - Lambda_11_11_p4748_lanes[1] * Lambda_2_11_p3;
  const Real Lambda_2_11_p7 = Lambda_11_11_p4566_lanes[2] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p4480_lanes[2] - Lambda_11_11_p4640_lanes[2] * Lambda_2_11_p1 -
      Lambda_11_11_p4699_lanes[2] * Lambda_2_11_p2 - Lambda_11_11_p4748_lanes[2] * Lambda_2_11_p3;
  const Real Lambda_11_11_p4823 = Lambda_11_11_p4820_lanes[1] * Lambda_11_11_p4820_lanes[1];
  const Real Lambda_0_11_p4 = Lambda_0_11_p1 - Lambda_11_11_p4699_lanes[1] * Lambda_0_0_p4 -
      Lambda_11_11_p4748_lanes[1] * Lambda_0_0_p8 - Lambda_11_11_p4791_lanes[1] * Lambda_0_0_p11 -
      Lambda_11_11_p4814_lanes[1] * Lambda_0_0_p14;
  const Real Lambda_3_11_p1 = Lambda_11_11_p3996_lanes[5] * Lambda_11_11_p3673_lanes[4] -
      Lambda_11_11_p3673_lanes[5];
  const Real Lambda_1_11_p4 = Lambda_1_11_p1 - Lambda_11_11_p4748_lanes[1] * Lambda_0_1_p5 -
      Lambda_11_11_p4791_lanes[1] * Lambda_0_1_p12 - Lambda_11_11_p4814_lanes[1] * Lambda_0_1_p13;
  const Real Lambda_11_11_p4824 = Lambda_11_11_p4823 * Lambda_11_11_p4820_lanes[1];
  const Real Lambda_0_2_p4 = Lambda_2_11_p3 * Lambda_11_11_p4651;
  const Real Lambda_2_11_p8 = Lambda_2_11_p5 - Lambda_11_11_p4791_lanes[0] * Lambda_2_11_p4;
  const Real Lambda_2_11_p9 = Lambda_11_11_p4566_lanes[3] * Lambda_11_11_p3353_lanes[3] -
      Lambda_11_11_p4480_lanes[3] - Lambda_11_11_p4640_lanes[3] * Lambda_2_11_p1 -
      Lambda_11_11_p4699_lanes[3] * Lambda_2_11_p2 - Lambda_11_11_p4748_lanes[3] * Lambda_2_11_p3;
  const Real Lambda_0_11_p5 = Lambda_0_11_p2 - Lambda_11_11_p4699_lanes[2] * Lambda_0_0_p4 -
      Lambda_11_11_p4748_lanes[2] * Lambda_0_0_p8 - Lambda_11_11_p4791_lanes[2] * Lambda_0_0_p11 -
      Lambda_11_11_p4814_lanes[2] * Lambda_0_0_p14;
  const Real Lambda_3_11_p2 = Lambda_11_11_p3996_lanes[6] * Lambda_11_11_p3673_lanes[4] -
      Lambda_11_11_p3673_lanes[6] - Lambda_11_11_p4479 * Lambda_3_11_p1;
  const Real Lambda_2_11_p10 = Lambda_2_11_p6 - Lambda_11_11_p4791_lanes[1] * Lambda_2_11_p4 -
      Lambda_11_11_p4814_lanes[1] * Lambda_2_11_p8;
  const Real Lambda_0_3_p1 = Lambda_3_11_p2 * Lambda_11_11_p4651;
  const Real Lambda_11_11_p4825 = Lambda_11_11_p4824 * Lambda_11_11_p4823 /
      (5.551115123125783e-17 + Lambda_11_11_p4824 * Lambda_11_11_p4824);
  const Real Lambda_0_3_p2 = Lambda_3_11_p1 * Lambda_11_11_p4340;
  const Real Lambda_0_3_p3 = Lambda_11_11_p3673_lanes[4] * Lambda_11_11_p3943;
  const Real Lambda_3_11_p3 = Lambda_11_11_p3996_lanes[7] * Lambda_11_11_p3673_lanes[4] -
      Lambda_11_11_p3673_lanes[7] - Lambda_11_11_p4484 * Lambda_3_11_p1 - Lambda_11_11_p4728 *
      Lambda_3_11_p2;
  const Real Lambda_0_2_p5 = Lambda_2_11_p4 * Lambda_11_11_p4788;
  const Real Lambda_0_3_p4 = Lambda_3_11_p3 * Lambda_11_11_p4788;
  const Real Lambda_0_11_p6 = Lambda_0_11_p3 - Lambda_11_11_p4699_lanes[3] * Lambda_0_0_p4 -
      Lambda_11_11_p4748_lanes[3] * Lambda_0_0_p8 - Lambda_11_11_p4791_lanes[3] * Lambda_0_0_p11 -
      Lambda_11_11_p4814_lanes[3] * Lambda_0_0_p14;
  const Real Lambda_4_11_p1 = Lambda_11_11_p4479 * Lambda_11_11_p3996_lanes[5] -
      Lambda_11_11_p3996_lanes[6];
  const Real Lambda_0_2_p6 = Lambda_2_11_p8 * Lambda_11_11_p4813;
  const Real Lambda_3_11_p4 = Lambda_11_11_p4640_lanes[0] * Lambda_11_11_p3673_lanes[4] -
      Lambda_11_11_p4566_lanes[0] - Lambda_11_11_p4699_lanes[0] * Lambda_3_11_p1 -
      Lambda_11_11_p4748_lanes[0] * Lambda_3_11_p2 - Lambda_11_11_p4791_lanes[0] * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_11_11_p4640_lanes[1] * Lambda_11_11_p3673_lanes[4] -
      Lambda_11_11_p4566_lanes[1] - Lambda_11_11_p4699_lanes[1] * Lambda_3_11_p1 -
      Lambda_11_11_p4748_lanes[1] * Lambda_3_11_p2 - Lambda_11_11_p4791_lanes[1] * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_11_11_p4640_lanes[2] * Lambda_11_11_p3673_lanes[4] -
      Lambda_11_11_p4566_lanes[2] - Lambda_11_11_p4699_lanes[2] * Lambda_3_11_p1 -
      Lambda_11_11_p4748_lanes[2] * Lambda_3_11_p2 - Lambda_11_11_p4791_lanes[2] * Lambda_3_11_p3;
  const Real Lambda_3_11_p7 = Lambda_11_11_p4640_lanes[3] * Lambda_11_11_p3673_lanes[4] -
      Lambda_11_11_p4566_lanes[3] - Lambda_11_11_p4699_lanes[3] * Lambda_3_11_p1 -
      Lambda_11_11_p4748_lanes[3] * Lambda_3_11_p2 - Lambda_11_11_p4791_lanes[3] * Lambda_3_11_p3;
  const Real Lambda_0_3_p5 = Lambda_3_11_p4 * Lambda_11_11_p4813;
  const Real Lambda_11_11_p4826 = Lambda_11_11_p4820_lanes[2] * Lambda_11_11_p4825;
  const Real Lambda_11_11_p4827 = Lambda_11_11_p4820_lanes[3] * Lambda_11_11_p4825;
  const Real Lambda_4_11_p2 = Lambda_11_11_p4484 * Lambda_11_11_p3996_lanes[5] -
      Lambda_11_11_p3996_lanes[7] - Lambda_11_11_p4728 * Lambda_4_11_p1;
  const Real Lambda_3_11_p8 = Lambda_3_11_p5 - Lambda_11_11_p4814_lanes[1] * Lambda_3_11_p4;
  const Real Lambda_0_2_p7 = Lambda_0_0_p10 - Lambda_0_2_p1 * Lambda_0_0_p2 + Lambda_0_2_p2 *
      Lambda_0_0_p3 + Lambda_0_2_p3 * Lambda_0_0_p4 + Lambda_0_2_p4 * Lambda_0_0_p8;
  const Real Lambda_0_4_p1 = Lambda_4_11_p1 * Lambda_11_11_p4651;
  const Real Lambda_0_4_p2 = Lambda_11_11_p3996_lanes[5] * Lambda_11_11_p4340;
  const Real Lambda_11_11_p4828 = Lambda_11_11_p4809 - Lambda_11_11_p4814_lanes[2] *
      Lambda_11_11_p4802_lanes[2] - Lambda_11_11_p4826 * Lambda_11_11_p4820_lanes[2];
  const Real Lambda_11_11_p4829 = Lambda_11_11_p4810 - Lambda_11_11_p4814_lanes[3] *
      Lambda_11_11_p4802_lanes[2] - Lambda_11_11_p4827 * Lambda_11_11_p4820_lanes[2];
  const Real Lambda_11_11_p4830 = Lambda_11_11_p4789 - Lambda_11_11_p4748_lanes[3] *
      Lambda_11_11_p4732_lanes[3] - Lambda_11_11_p4791_lanes[3] * Lambda_11_11_p4773_lanes[3] -
      Lambda_11_11_p4814_lanes[3] * Lambda_11_11_p4802_lanes[3] - Lambda_11_11_p4827 *
      Lambda_11_11_p4820_lanes[3];
  const Real Lambda_4_11_p3 = Lambda_11_11_p4699_lanes[0] * Lambda_11_11_p3996_lanes[5] -
      Lambda_11_11_p4640_lanes[0] - Lambda_11_11_p4748_lanes[0] * Lambda_4_11_p1 -
      Lambda_11_11_p4791_lanes[0] * Lambda_4_11_p2;
  const Real Lambda_5_11_p1 = Lambda_11_11_p4728 * Lambda_11_11_p4479 - Lambda_11_11_p4484;
  const Real Lambda_0_4_p3 = Lambda_4_11_p2 * Lambda_11_11_p4788;
  const Real Lambda_11_11_p4831 = Lambda_11_11_p4828 * Lambda_11_11_p4828;
  const Real Lambda_0_11_p7 = Lambda_0_11_p5 - Lambda_11_11_p4826 * Lambda_0_11_p4;
  const Real Lambda_1_11_p5 = Lambda_1_11_p2 - Lambda_11_11_p4748_lanes[2] * Lambda_0_1_p5 -
      Lambda_11_11_p4791_lanes[2] * Lambda_0_1_p12 - Lambda_11_11_p4814_lanes[2] * Lambda_0_1_p13 -
      Lambda_11_11_p4826 * Lambda_1_11_p4;
  const Real Lambda_2_11_p11 = Lambda_2_11_p7 - Lambda_11_11_p4791_lanes[2] * Lambda_2_11_p4 -
      Lambda_11_11_p4814_lanes[2] * Lambda_2_11_p8 - Lambda_11_11_p4826 * Lambda_2_11_p10;
  const Real Lambda_11_11_p4832 = Lambda_11_11_p4831 * Lambda_11_11_p4828;
  const Real Lambda_4_11_p4 = Lambda_11_11_p4699_lanes[1] * Lambda_11_11_p3996_lanes[5] -
      Lambda_11_11_p4640_lanes[1] - Lambda_11_11_p4748_lanes[1] * Lambda_4_11_p1 -
      Lambda_11_11_p4791_lanes[1] * Lambda_4_11_p2 - Lambda_11_11_p4814_lanes[1] * Lambda_4_11_p3;
  const Real Lambda_0_5_p1 = Lambda_11_11_p4479 * Lambda_11_11_p4651;
  const Real Lambda_5_11_p2 = Lambda_11_11_p4748_lanes[0] * Lambda_11_11_p4479 -
      Lambda_11_11_p4699_lanes[0] - Lambda_11_11_p4791_lanes[0] * Lambda_5_11_p1;
  const Real Lambda_4_11_p5 = Lambda_11_11_p4699_lanes[2] * Lambda_11_11_p3996_lanes[5] -
      Lambda_11_11_p4640_lanes[2] - Lambda_11_11_p4748_lanes[2] * Lambda_4_11_p1 -
      Lambda_11_11_p4791_lanes[2] * Lambda_4_11_p2 - Lambda_11_11_p4814_lanes[2] * Lambda_4_11_p3;
  const Real Lambda_0_5_p2 = Lambda_5_11_p1 * Lambda_11_11_p4788;
  const Real Lambda_3_11_p9 = Lambda_3_11_p6 - Lambda_11_11_p4814_lanes[2] * Lambda_3_11_p4 -
      Lambda_11_11_p4826 * Lambda_3_11_p8;
  const Real Lambda_6_11_p1 = Lambda_11_11_p4791_lanes[0] * Lambda_11_11_p4728 -
      Lambda_11_11_p4748_lanes[0];
  const Real Lambda_4_11_p6 = Lambda_4_11_p5 - Lambda_11_11_p4826 * Lambda_4_11_p4;
  const Real Lambda_4_11_p7 = Lambda_11_11_p4699_lanes[3] * Lambda_11_11_p3996_lanes[5] -
      Lambda_11_11_p4640_lanes[3] - Lambda_11_11_p4748_lanes[3] * Lambda_4_11_p1 -
      Lambda_11_11_p4791_lanes[3] * Lambda_4_11_p2 - Lambda_11_11_p4814_lanes[3] * Lambda_4_11_p3;
  const Real Lambda_0_4_p4 = Lambda_4_11_p3 * Lambda_11_11_p4813;
  const Real Lambda_5_11_p3 = Lambda_11_11_p4748_lanes[1] * Lambda_11_11_p4479 -
      Lambda_11_11_p4699_lanes[1] - Lambda_11_11_p4791_lanes[1] * Lambda_5_11_p1 -
      Lambda_11_11_p4814_lanes[1] * Lambda_5_11_p2;
  const Real Lambda_0_5_p3 = Lambda_5_11_p2 * Lambda_11_11_p4813;
  const Real Lambda_0_6_p1 = Lambda_11_11_p4728 * Lambda_11_11_p4788;
  const Real Lambda_0_6_p2 = Lambda_6_11_p1 * Lambda_11_11_p4813;
  const Real Lambda_11_11_p4833 = Lambda_11_11_p4832 * Lambda_11_11_p4831 /
      (5.551115123125783e-17 + Lambda_11_11_p4832 * Lambda_11_11_p4832);
  const Real Lambda_6_11_p2 = Lambda_11_11_p4791_lanes[1] * Lambda_11_11_p4728 -
      Lambda_11_11_p4748_lanes[1] - Lambda_11_11_p4814_lanes[1] * Lambda_6_11_p1;
  const Real Lambda_7_11_p1 = Lambda_11_11_p4814_lanes[1] * Lambda_11_11_p4791_lanes[0] -
      Lambda_11_11_p4791_lanes[1];
  const Real Lambda_5_11_p4 = Lambda_11_11_p4748_lanes[2] * Lambda_11_11_p4479 -
      Lambda_11_11_p4699_lanes[2] - Lambda_11_11_p4791_lanes[2] * Lambda_5_11_p1 -
      Lambda_11_11_p4814_lanes[2] * Lambda_5_11_p2 - Lambda_11_11_p4826 * Lambda_5_11_p3;
  const Real Lambda_0_0_p20 = Lambda_0_11_p4 * Lambda_11_11_p4825;
  const Real Lambda_1_11_p6 = Lambda_1_11_p3 - Lambda_11_11_p4748_lanes[3] * Lambda_0_1_p5 -
      Lambda_11_11_p4791_lanes[3] * Lambda_0_1_p12 - Lambda_11_11_p4814_lanes[3] * Lambda_0_1_p13 -
      Lambda_11_11_p4827 * Lambda_1_11_p4;
  const Real Lambda_0_7_p1 = Lambda_11_11_p4791_lanes[0] * Lambda_11_11_p4813;
  const Real Lambda_0_1_p17 = Lambda_1_11_p4 * Lambda_11_11_p4825;
  const Real Lambda_0_2_p8 = Lambda_2_11_p10 * Lambda_11_11_p4825;
  const Real Lambda_0_3_p6 = Lambda_3_11_p8 * Lambda_11_11_p4825;
  const Real Lambda_0_4_p5 = Lambda_4_11_p4 * Lambda_11_11_p4825;
  const Real Lambda_6_11_p3 = Lambda_11_11_p4791_lanes[2] * Lambda_11_11_p4728 -
      Lambda_11_11_p4748_lanes[2] - Lambda_11_11_p4814_lanes[2] * Lambda_6_11_p1 -
      Lambda_11_11_p4826 * Lambda_6_11_p2;
  const Real Lambda_5_11_p5 = Lambda_11_11_p4748_lanes[3] * Lambda_11_11_p4479 -
      Lambda_11_11_p4699_lanes[3] - Lambda_11_11_p4791_lanes[3] * Lambda_5_11_p1 -
      Lambda_11_11_p4814_lanes[3] * Lambda_5_11_p2 - Lambda_11_11_p4827 * Lambda_5_11_p3;
  const Real Lambda_0_5_p4 = Lambda_5_11_p3 * Lambda_11_11_p4825;
  const Real Lambda_8_11_p1 = Lambda_11_11_p4826 * Lambda_11_11_p4814_lanes[1] -
      Lambda_11_11_p4814_lanes[2];
  const Real Lambda_0_6_p3 = Lambda_6_11_p2 * Lambda_11_11_p4825;
  const Real Lambda_0_7_p2 = Lambda_7_11_p1 * Lambda_11_11_p4825;
  const Real Lambda_0_8_p1 = Lambda_11_11_p4814_lanes[1] * Lambda_11_11_p4825;
  const Real Lambda_7_11_p2 = Lambda_11_11_p4814_lanes[2] * Lambda_11_11_p4791_lanes[0] -
      Lambda_11_11_p4791_lanes[2] - Lambda_11_11_p4826 * Lambda_7_11_p1;
  const Real Lambda_11_11_p4834 = Lambda_11_11_p4829 * Lambda_11_11_p4833;
  const Real Lambda_0_3_p7 = Lambda_0_0_p12 - Lambda_0_3_p3 * Lambda_0_0_p3 + Lambda_0_3_p2 *
      Lambda_0_0_p4 + Lambda_0_3_p1 * Lambda_0_0_p8 + Lambda_0_3_p4 * Lambda_0_0_p11;
  const Real Lambda_11_11_p4835 = Lambda_11_11_p4830 - Lambda_11_11_p4834 * Lambda_11_11_p4829;
  const Real Lambda_0_11_p8 = Lambda_0_11_p6 - Lambda_11_11_p4827 * Lambda_0_11_p4 -
      Lambda_11_11_p4834 * Lambda_0_11_p7;
  const Real Lambda_0_0_p21 = Lambda_0_11_p7 * Lambda_11_11_p4833;
  const Real Lambda_1_11_p7 = Lambda_1_11_p6 - Lambda_11_11_p4834 * Lambda_1_11_p5;
  const Real Lambda_11_11_p4836 = Lambda_11_11_p4835 * Lambda_11_11_p4835;
  const Real Lambda_0_1_p18 = Lambda_1_11_p5 * Lambda_11_11_p4833;
  const Real Lambda_2_11_p12 = Lambda_2_11_p9 - Lambda_11_11_p4791_lanes[3] * Lambda_2_11_p4 -
      Lambda_11_11_p4814_lanes[3] * Lambda_2_11_p8 - Lambda_11_11_p4827 * Lambda_2_11_p10 -
      Lambda_11_11_p4834 * Lambda_2_11_p11;
  const Real Lambda_0_2_p9 = Lambda_2_11_p11 * Lambda_11_11_p4833;
  const Real Lambda_3_11_p10 = Lambda_3_11_p7 - Lambda_11_11_p4814_lanes[3] * Lambda_3_11_p4 -
      Lambda_11_11_p4827 * Lambda_3_11_p8 - Lambda_11_11_p4834 * Lambda_3_11_p9;
  const Real Lambda_0_3_p8 = Lambda_3_11_p9 * Lambda_11_11_p4833;
  const Real Lambda_4_11_p8 = Lambda_4_11_p7 - Lambda_11_11_p4827 * Lambda_4_11_p4 -
      Lambda_11_11_p4834 * Lambda_4_11_p6;
  const Real Lambda_0_4_p6 = Lambda_4_11_p6 * Lambda_11_11_p4833;
  const Real Lambda_11_11_p4837 = Lambda_11_11_p4836 * Lambda_11_11_p4835;
  const Real Lambda_1_1_p1 = Lambda_11_11_p3023 + Lambda_0_1_p8 * Lambda_11_11_p3081_lanes[2] +
      Lambda_0_1_p9 * Lambda_0_1_p1 + Lambda_0_1_p10 * Lambda_0_1_p2 + Lambda_0_1_p4 *
      Lambda_0_1_p3;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_11_11_p4834 * Lambda_5_11_p4;
  const Real Lambda_0_5_p5 = Lambda_5_11_p4 * Lambda_11_11_p4833;
  const Real Lambda_6_11_p4 = Lambda_11_11_p4791_lanes[3] * Lambda_11_11_p4728 -
      Lambda_11_11_p4748_lanes[3] - Lambda_11_11_p4814_lanes[3] * Lambda_6_11_p1 -
      Lambda_11_11_p4827 * Lambda_6_11_p2 - Lambda_11_11_p4834 * Lambda_6_11_p3;
  const Real Lambda_0_6_p4 = Lambda_6_11_p3 * Lambda_11_11_p4833;
  const Real Lambda_7_11_p3 = Lambda_11_11_p4814_lanes[3] * Lambda_11_11_p4791_lanes[0] -
      Lambda_11_11_p4791_lanes[3] - Lambda_11_11_p4827 * Lambda_7_11_p1 - Lambda_11_11_p4834 *
      Lambda_7_11_p2;
  const Real Lambda_0_7_p3 = Lambda_7_11_p2 * Lambda_11_11_p4833;
  const Real Lambda_8_11_p2 = Lambda_11_11_p4827 * Lambda_11_11_p4814_lanes[1] -
      Lambda_11_11_p4814_lanes[3] - Lambda_11_11_p4834 * Lambda_8_11_p1;
  const Real Lambda_1_2_p1 = Lambda_0_2_p2 * Lambda_0_1_p2 -
      (Lambda_0_1_p8 + Lambda_0_2_p1 * Lambda_0_1_p1) + Lambda_0_2_p3 * Lambda_0_1_p3 +
      Lambda_0_2_p4 * Lambda_0_1_p5;
  const Real Lambda_0_8_p2 = Lambda_8_11_p1 * Lambda_11_11_p4833;
  const Real Lambda_9_11_p1 = Lambda_11_11_p4834 * Lambda_11_11_p4826 - Lambda_11_11_p4827;
  const Real Lambda_0_9_p1 = Lambda_11_11_p4826 * Lambda_11_11_p4833;
  const Real Lambda_1_3_p1 = Lambda_0_1_p9 - Lambda_0_3_p3 * Lambda_0_1_p2 + Lambda_0_3_p2 *
      Lambda_0_1_p3 + Lambda_0_3_p1 * Lambda_0_1_p5 + Lambda_0_3_p4 * Lambda_0_1_p12;
  const Real Lambda_11_11 = Lambda_11_11_p4837 * Lambda_11_11_p4836 /
      (8.673617379884035e-19 + Lambda_11_11_p4837 * Lambda_11_11_p4837);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_0_0_p22 = Lambda_0_0_p17 + Lambda_0_0_p15 * Lambda_0_0_p4 + Lambda_0_0_p16 *
      Lambda_0_0_p8 + Lambda_0_0_p18 * Lambda_0_0_p11 + Lambda_0_0_p19 * Lambda_0_0_p14;
  const Real Lambda_0_4_p7 = Lambda_0_0_p13 - Lambda_0_4_p2 * Lambda_0_0_p4 + Lambda_0_4_p1 *
      Lambda_0_0_p8 + Lambda_0_4_p3 * Lambda_0_0_p11 + Lambda_0_4_p4 * Lambda_0_0_p14;
  const Real Lambda_1_4_p1 = Lambda_0_1_p10 - Lambda_0_4_p2 * Lambda_0_1_p3 + Lambda_0_4_p1 *
      Lambda_0_1_p5 + Lambda_0_4_p3 * Lambda_0_1_p12 + Lambda_0_4_p4 * Lambda_0_1_p13;
  const Real Lambda_0_11 = Lambda_0_11_p8 * Lambda_11_11;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_1_11 = Lambda_1_11_p7 * Lambda_11_11;
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
  const Real Lambda_2_2_p1 = Lambda_11_11_p3302 + Lambda_0_2_p1 * Lambda_11_11_p3353_lanes[3] +
      Lambda_0_2_p2 * Lambda_2_11_p1 + Lambda_0_2_p3 * Lambda_2_11_p2 + Lambda_0_2_p4 *
      Lambda_2_11_p3;
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
  const Real Lambda_10_11 = Lambda_11_11_p4834 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real Lambda_2_3_p1 = Lambda_0_3_p2 * Lambda_2_11_p2 -
      (Lambda_0_2_p1 + Lambda_0_3_p3 * Lambda_2_11_p1) + Lambda_0_3_p1 * Lambda_2_11_p3 +
      Lambda_0_3_p4 * Lambda_2_11_p4;
  const Real Lambda_2_4_p1 = Lambda_0_2_p2 - Lambda_0_4_p2 * Lambda_2_11_p2 + Lambda_0_4_p1 *
      Lambda_2_11_p3 + Lambda_0_4_p3 * Lambda_2_11_p4 + Lambda_0_4_p4 * Lambda_2_11_p8;
  const Real Lambda_0_1_p19 = Lambda_0_1_p15 + Lambda_0_1_p11 * Lambda_0_0_p8 + Lambda_0_1_p14 *
      Lambda_0_0_p11 + Lambda_0_1_p16 * Lambda_0_0_p14 + Lambda_0_1_p17 * Lambda_0_11_p4;
  const Real Lambda_0_5_p6 = Lambda_0_0_p15 - Lambda_0_5_p1 * Lambda_0_0_p8 + Lambda_0_5_p2 *
      Lambda_0_0_p11 + Lambda_0_5_p3 * Lambda_0_0_p14 + Lambda_0_5_p4 * Lambda_0_11_p4;
  const Real Lambda_3_3_p1 = Lambda_11_11_p3548 + Lambda_0_3_p3 * Lambda_11_11_p3673_lanes[4] +
      Lambda_0_3_p2 * Lambda_3_11_p1 + Lambda_0_3_p1 * Lambda_3_11_p2 + Lambda_0_3_p4 *
      Lambda_3_11_p3;
  const Real Lambda_1_1_p2 = Lambda_1_1_p1 + Lambda_0_1_p11 * Lambda_0_1_p5 + Lambda_0_1_p14 *
      Lambda_0_1_p12 + Lambda_0_1_p16 * Lambda_0_1_p13 + Lambda_0_1_p17 * Lambda_1_11_p4;
  const Real Lambda_1_5_p1 = Lambda_0_1_p4 - Lambda_0_5_p1 * Lambda_0_1_p5 + Lambda_0_5_p2 *
      Lambda_0_1_p12 + Lambda_0_5_p3 * Lambda_0_1_p13 + Lambda_0_5_p4 * Lambda_1_11_p4;
  const Real Lambda_3_4_p1 = Lambda_0_4_p1 * Lambda_3_11_p2 -
      (Lambda_0_3_p3 + Lambda_0_4_p2 * Lambda_3_11_p1) + Lambda_0_4_p3 * Lambda_3_11_p3 +
      Lambda_0_4_p4 * Lambda_3_11_p4;
  const Real Lambda_2_5_p1 = Lambda_0_2_p3 - Lambda_0_5_p1 * Lambda_2_11_p3 + Lambda_0_5_p2 *
      Lambda_2_11_p4 + Lambda_0_5_p3 * Lambda_2_11_p8 + Lambda_0_5_p4 * Lambda_2_11_p10;
  const Real Lambda_3_5_p1 = Lambda_0_3_p2 - Lambda_0_5_p1 * Lambda_3_11_p2 + Lambda_0_5_p2 *
      Lambda_3_11_p3 + Lambda_0_5_p3 * Lambda_3_11_p4 + Lambda_0_5_p4 * Lambda_3_11_p8;
  const Real Lambda_4_4_p1 = Lambda_11_11_p3943 + Lambda_0_4_p2 * Lambda_11_11_p3996_lanes[5] +
      Lambda_0_4_p1 * Lambda_4_11_p1 + Lambda_0_4_p3 * Lambda_4_11_p2 + Lambda_0_4_p4 *
      Lambda_4_11_p3;
  const Real Lambda_4_5_p1 = Lambda_0_5_p2 * Lambda_4_11_p2 -
      (Lambda_0_4_p2 + Lambda_0_5_p1 * Lambda_4_11_p1) + Lambda_0_5_p3 * Lambda_4_11_p3 +
      Lambda_0_5_p4 * Lambda_4_11_p4;
  const Real Lambda_5_5_p1 = Lambda_11_11_p4340 + Lambda_0_5_p1 * Lambda_11_11_p4479 +
      Lambda_0_5_p2 * Lambda_5_11_p1 + Lambda_0_5_p3 * Lambda_5_11_p2 + Lambda_0_5_p4 *
      Lambda_5_11_p3;
  const Real Lambda_0_2_p10 = Lambda_0_2_p7 + Lambda_0_2_p5 * Lambda_0_0_p11 + Lambda_0_2_p6 *
      Lambda_0_0_p14 + Lambda_0_2_p8 * Lambda_0_11_p4 + Lambda_0_2_p9 * Lambda_0_11_p7;
  const Real Lambda_0_6_p5 = Lambda_0_0_p16 - Lambda_0_6_p1 * Lambda_0_0_p11 + Lambda_0_6_p2 *
      Lambda_0_0_p14 + Lambda_0_6_p3 * Lambda_0_11_p4 + Lambda_0_6_p4 * Lambda_0_11_p7;
  const Real Lambda_1_2_p2 = Lambda_1_2_p1 + Lambda_0_2_p5 * Lambda_0_1_p12 + Lambda_0_2_p6 *
      Lambda_0_1_p13 + Lambda_0_2_p8 * Lambda_1_11_p4 + Lambda_0_2_p9 * Lambda_1_11_p5;
  const Real Lambda_1_6_p1 = Lambda_0_1_p11 - Lambda_0_6_p1 * Lambda_0_1_p12 + Lambda_0_6_p2 *
      Lambda_0_1_p13 + Lambda_0_6_p3 * Lambda_1_11_p4 + Lambda_0_6_p4 * Lambda_1_11_p5;
  const Real Lambda_2_2_p2 = Lambda_2_2_p1 + Lambda_0_2_p5 * Lambda_2_11_p4 + Lambda_0_2_p6 *
      Lambda_2_11_p8 + Lambda_0_2_p8 * Lambda_2_11_p10 + Lambda_0_2_p9 * Lambda_2_11_p11;
  const Real Lambda_2_6_p1 = Lambda_0_2_p4 - Lambda_0_6_p1 * Lambda_2_11_p4 + Lambda_0_6_p2 *
      Lambda_2_11_p8 + Lambda_0_6_p3 * Lambda_2_11_p10 + Lambda_0_6_p4 * Lambda_2_11_p11;
  const Real Lambda_3_6_p1 = Lambda_0_3_p1 - Lambda_0_6_p1 * Lambda_3_11_p3 + Lambda_0_6_p2 *
      Lambda_3_11_p4 + Lambda_0_6_p3 * Lambda_3_11_p8 + Lambda_0_6_p4 * Lambda_3_11_p9;
  const Real Lambda_4_6_p1 = Lambda_0_4_p1 - Lambda_0_6_p1 * Lambda_4_11_p2 + Lambda_0_6_p2 *
      Lambda_4_11_p3 + Lambda_0_6_p3 * Lambda_4_11_p4 + Lambda_0_6_p4 * Lambda_4_11_p6;
  const Real Lambda_5_6_p1 = Lambda_0_6_p2 * Lambda_5_11_p2 -
      (Lambda_0_5_p1 + Lambda_0_6_p1 * Lambda_5_11_p1) + Lambda_0_6_p3 * Lambda_5_11_p3 +
      Lambda_0_6_p4 * Lambda_5_11_p4;
  const Real Lambda_6_6_p1 = Lambda_11_11_p4651 + Lambda_0_6_p1 * Lambda_11_11_p4728 +
      Lambda_0_6_p2 * Lambda_6_11_p1 + Lambda_0_6_p3 * Lambda_6_11_p2 + Lambda_0_6_p4 *
      Lambda_6_11_p3;
  Lambda[0] = Lambda_0_0_p22 + Lambda_0_0_p20 * Lambda_0_11_p4 + Lambda_0_0_p21 * Lambda_0_11_p7 +
      Lambda_0_11 * Lambda_0_11_p8;
  const Real Lambda_0_1 = Lambda_0_1_p19 + Lambda_0_1_p18 * Lambda_0_11_p7 + Lambda_1_11 *
      Lambda_0_11_p8;
  Lambda[1] = Lambda_0_1;
  Lambda[12] = Lambda_0_1;
  const Real Lambda_0_2 = Lambda_0_2_p10 + Lambda_2_11 * Lambda_0_11_p8;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_0_3 = Lambda_0_3_p7 + Lambda_0_3_p5 * Lambda_0_0_p14 + Lambda_0_3_p6 *
      Lambda_0_11_p4 + Lambda_0_3_p8 * Lambda_0_11_p7 + Lambda_3_11 * Lambda_0_11_p8;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_0_4 = Lambda_0_4_p7 + Lambda_0_4_p5 * Lambda_0_11_p4 + Lambda_0_4_p6 *
      Lambda_0_11_p7 + Lambda_4_11 * Lambda_0_11_p8;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_0_5 = Lambda_0_5_p6 + Lambda_0_5_p5 * Lambda_0_11_p7 + Lambda_5_11 *
      Lambda_0_11_p8;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_0_6 = Lambda_0_6_p5 + Lambda_6_11 * Lambda_0_11_p8;
  Lambda[6] = Lambda_0_6;
  Lambda[72] = Lambda_0_6;
  const Real Lambda_0_7 = Lambda_0_0_p18 - Lambda_0_7_p1 * Lambda_0_0_p14 + Lambda_0_7_p2 *
      Lambda_0_11_p4 + Lambda_0_7_p3 * Lambda_0_11_p7 + Lambda_7_11 * Lambda_0_11_p8;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_0_8 = Lambda_0_0_p19 - Lambda_0_8_p1 * Lambda_0_11_p4 + Lambda_0_8_p2 *
      Lambda_0_11_p7 + Lambda_8_11 * Lambda_0_11_p8;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_0_9 = Lambda_0_0_p20 - Lambda_0_9_p1 * Lambda_0_11_p7 + Lambda_9_11 *
      Lambda_0_11_p8;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_0_10 = Lambda_0_0_p21 - Lambda_10_11 * Lambda_0_11_p8;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  Lambda[13] = Lambda_1_1_p2 + Lambda_0_1_p18 * Lambda_1_11_p5 + Lambda_1_11 * Lambda_1_11_p7;
  const Real Lambda_1_2 = Lambda_1_2_p2 + Lambda_2_11 * Lambda_1_11_p7;
  Lambda[14] = Lambda_1_2;
  Lambda[25] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_1_3_p1 + Lambda_0_3_p5 * Lambda_0_1_p13 + Lambda_0_3_p6 *
      Lambda_1_11_p4 + Lambda_0_3_p8 * Lambda_1_11_p5 + Lambda_3_11 * Lambda_1_11_p7;
  Lambda[15] = Lambda_1_3;
  Lambda[37] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_1_4_p1 + Lambda_0_4_p5 * Lambda_1_11_p4 + Lambda_0_4_p6 *
      Lambda_1_11_p5 + Lambda_4_11 * Lambda_1_11_p7;
  Lambda[16] = Lambda_1_4;
  Lambda[49] = Lambda_1_4;
  const Real Lambda_1_5 = Lambda_1_5_p1 + Lambda_0_5_p5 * Lambda_1_11_p5 + Lambda_5_11 *
      Lambda_1_11_p7;
  Lambda[17] = Lambda_1_5;
  Lambda[61] = Lambda_1_5;
  const Real Lambda_1_6 = Lambda_1_6_p1 + Lambda_6_11 * Lambda_1_11_p7;
  Lambda[18] = Lambda_1_6;
  Lambda[73] = Lambda_1_6;
  const Real Lambda_1_7 = Lambda_0_1_p14 - Lambda_0_7_p1 * Lambda_0_1_p13 + Lambda_0_7_p2 *
      Lambda_1_11_p4 + Lambda_0_7_p3 * Lambda_1_11_p5 + Lambda_7_11 * Lambda_1_11_p7;
  Lambda[19] = Lambda_1_7;
  Lambda[85] = Lambda_1_7;
  const Real Lambda_1_8 = Lambda_0_1_p16 - Lambda_0_8_p1 * Lambda_1_11_p4 + Lambda_0_8_p2 *
      Lambda_1_11_p5 + Lambda_8_11 * Lambda_1_11_p7;
  Lambda[20] = Lambda_1_8;
  Lambda[97] = Lambda_1_8;
  const Real Lambda_1_9 = Lambda_0_1_p17 - Lambda_0_9_p1 * Lambda_1_11_p5 + Lambda_9_11 *
      Lambda_1_11_p7;
  Lambda[21] = Lambda_1_9;
  Lambda[109] = Lambda_1_9;
  const Real Lambda_1_10 = Lambda_0_1_p18 - Lambda_10_11 * Lambda_1_11_p7;
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
  Lambda[91] = Lambda_11_11_p4788 + Lambda_0_7_p1 * Lambda_11_11_p4791_lanes[0] + Lambda_0_7_p2 *
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
  Lambda[104] = Lambda_11_11_p4813 + Lambda_0_8_p1 * Lambda_11_11_p4814_lanes[1] + Lambda_0_8_p2 *
      Lambda_8_11_p1 + Lambda_8_11 * Lambda_8_11_p2;
  const Real Lambda_8_9 = Lambda_9_11 * Lambda_8_11_p2 -
      (Lambda_0_8_p1 + Lambda_0_9_p1 * Lambda_8_11_p1);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p2 - Lambda_10_11 * Lambda_8_11_p2;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = Lambda_11_11_p4825 + Lambda_0_9_p1 * Lambda_11_11_p4826 + Lambda_9_11 *
      Lambda_9_11_p1;
  const Real Lambda_9_10 = Lambda_0_9_p1 + Lambda_10_11 * Lambda_9_11_p1;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_11_11_p4833 + Lambda_10_11 * Lambda_11_11_p4834;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
