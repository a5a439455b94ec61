// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in
//   lanes.
// 6251 flops (add 2644, mul 3575, div 32), sine and cosine of 24 angles
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
void lambda_inverse(const Real (&TREELINE_RESTRICT q)[24],
    Real (&TREELINE_RESTRICT Lambda_inv)[144]) noexcept {
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
  const Real Lambda_inv_0_0_p1 = s2 * c3 + c2 * s3;
  const Real inverse_D3_p41 = inverse_D3_p17 - inverse_D4_p4 - inverse_D4_p7 * inverse_D3_p35;
  const Real inverse_D3_p42 = inverse_D4_p2 - inverse_D4_p7 * inverse_D3_p34;
  const Real inverse_D3_p43 = inverse_D4_p9 * inverse_D3_p35 - 0.072 * inverse_D3_p32;
  const Real inverse_D3_p44 = inverse_D3_p32 - inverse_D3_p33 * inverse_D3_p36;
  const Real inverse_D3_p45 = inverse_D4_p1 - inverse_D3_p29 * inverse_D3_p36;
  const Real inverse_D4_p12 = 0.15637308509675518 + 0.005183999999999999 * inverse_D4_p5 -
      inverse_D4_p9 * inverse_D4_p10;
  const Real Lambda_inv_0_0_p2 = c2 * c3 - s2 * s3;
  const Real inverse_D4_p13 = 0.04675382692737882 + (inverse_D5_p75 - inverse_D5_p83) -
      inverse_D4_p7 * inverse_D4_p11;
  const Real inverse_D4_p14 = 0.005678398088837119 - 0.072 * inverse_D4_p6 + inverse_D4_p9 *
      inverse_D4_p11;
  const Real inverse_D3_p46 = inverse_D4_p6 - 0.069699984375 - inverse_D4_p7 * inverse_D3_p36;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_1_p1 = s5 * s4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p47 = inverse_D4_p9 * inverse_D3_p36 -
      (2.2194301519999997 + 0.072 * inverse_D4_p5);

  // link 5 (chest2), pose
  const Real Lambda_inv_0_1_p2 = c5 * s4;

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
  const Real Lambda_inv_0_1_p5 = s6 * c4 - c6 * Lambda_inv_0_1_p1;
  const Real Lambda_inv_0_1_p6 = s6 * Lambda_inv_0_1_p1 + c6 * c4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p51 = s5 * inverse_D3_p49;
  const Real inverse_D3_p52 = s5 * inverse_D3_p46 - c5 * inverse_D3_p47;
  const Lanes<2> Lambda_inv_0_0_p3_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Real inverse_D4_p16 = s5 * inverse_D4_p15;
  const Real inverse_D3_p53 = c5 * inverse_D3_p49;
  const Real inverse_D3_p54 = inverse_D3_p38 - inverse_D3_p50;
  const Lanes<2> Lambda_inv_0_0_p4_lanes = 0.086 * detail::make_pack<Real>(c13, c20);
  const Real inverse_D2_p3 = inverse_D3_p41 + inverse_D3_p51;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_1_p11_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_1_p5 -
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_1_p2;
  const Lanes<2> Lambda_inv_0_1_p12_lanes = detail::make_pack<Real>(s7, s14) * Lambda_inv_0_1_p5 +
      detail::make_pack<Real>(c7, c14) * Lambda_inv_0_1_p2;

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
  const Lanes<2> Lambda_inv_0_1_p15_lanes = detail::make_pack<Real>(c8, c15) * Lambda_inv_0_1_p6 -
      detail::make_pack<Real>(s8, s15) * Lambda_inv_0_1_p11_lanes;
  const Lanes<2> Lambda_inv_0_1_p16_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_1_p11_lanes + detail::make_pack<Real>(s8, s15) * Lambda_inv_0_1_p6;

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p5 = 0.0300000063 * s4 + inverse_D3_p56;
  const Real inverse_D3_p57 = inverse_D3_p52 - c4 *
      (c4 * inverse_D3_p52 - s4 * (inverse_D3_p40 - inverse_D3_p51));
  const Real inverse_D3_p58 = inverse_D3_p54 + s4 * inverse_D3_p55;
  const Real inverse_D3_p59 = 0.21799999999999997 * inverse_D3_p56 +
      (0.005880002159562879 - (c5 * inverse_D4_p15 - inverse_D4_p14)) * s4;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_7_p15 = s16 * Lambda_inv_0_1_p15_lanes[1] + c16 *
      Lambda_inv_0_1_p12_lanes[1];
  const Real Lambda_inv_0_7_p16 = c16 * Lambda_inv_0_1_p15_lanes[1] - s16 *
      Lambda_inv_0_1_p12_lanes[1];

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p60 = inverse_D3_p59 * inverse_D4;
  const Real inverse_D2_p6 = inverse_D2_p3 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p5 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p61 = inverse_D3_p57 + 0.21799999999999997 * inverse_D3_p58;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_7_p17 = c17 * Lambda_inv_0_7_p15 + s17 * Lambda_inv_0_1_p16_lanes[1];
  const Real Lambda_inv_0_7_p18 = c17 * Lambda_inv_0_1_p16_lanes[1] - s17 * Lambda_inv_0_7_p15;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p8 = 0.0300000063 * c4 + (0.21799999999999997 * inverse_D2_p4 - s4 *
      (inverse_D3_p53 - inverse_D3_p42)) - inverse_D3_p59 * inverse_D2_p6;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_7_p19 = c18 * Lambda_inv_0_7_p17 + s18 * Lambda_inv_0_7_p16;
  const Real Lambda_inv_0_7_p20 = c18 * Lambda_inv_0_7_p16 - s18 * Lambda_inv_0_7_p17;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p9 = 0.02999999505 + inverse_D2_p8;
  const Real inverse_D2_p10 = 8.419374554 + (inverse_D3_p61 - inverse_D3_p59 * inverse_D2_p7);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p5_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_7_p22 = c19 * Lambda_inv_0_7_p18 - s19 * Lambda_inv_0_7_p19;
  const Real Lambda_inv_0_7_p23 = c19 * Lambda_inv_0_7_p19 + s19 * Lambda_inv_0_7_p18;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p62 = 1.7947593951550056 + 0.21799999999999997 *
      (inverse_D3_p57 + inverse_D3_p61) - inverse_D3_p59 * inverse_D3_p60 +
      (0.03561389675370483 + (inverse_D4_p12 - inverse_D4_p16)) * s4 * s4;

  // link 3 (hip), pose
  const Real Lambda_inv_0_0_p6 = Lambda_inv_0_0_p2 * c1 - Lambda_inv_0_0_p1 * s1;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / inverse_D3_p62;

  // link 3 (hip), pose
  const Real Lambda_inv_0_0_p7 = Lambda_inv_0_0_p1 * c1 + Lambda_inv_0_0_p2 * s1;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_0_p8 = c4 * Lambda_inv_0_0_p6;
  const Real Lambda_inv_0_0_p9 = s4 * Lambda_inv_0_0_p6;

  // link 1 (calf), articulated inertia
  const Real Lambda_inv_0_7_p24 = Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_7_p20 -
      Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_7_p22;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p25 = -(Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_7_p23) +
      inverse_D12_p7_lanes[1] * Lambda_inv_0_7_p24;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_0_p10 = s5 * Lambda_inv_0_0_p8 + c5 * Lambda_inv_0_0_p7;
  const Real Lambda_inv_0_0_p11 = c5 * Lambda_inv_0_0_p8 - s5 * Lambda_inv_0_0_p7;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p11 = inverse_D2_p9 * inverse_D3;
  const Real inverse_D2_p12 = inverse_D2_p10 * inverse_D3;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p26 = Lambda_inv_0_7_p22 + inverse_D10_p10_lanes[1] *
      Lambda_inv_0_7_p24 - inverse_D10_p22_lanes[1] * Lambda_inv_0_7_p25;
  const Real Lambda_inv_0_7_p27 = Lambda_inv_0_7_p23 + inverse_D10_p23_lanes[1] *
      Lambda_inv_0_7_p25;
  const Real Lambda_inv_0_7_p28 = Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_7_p23 +
      inverse_D11_p5_lanes[1] * Lambda_inv_0_7_p24 - inverse_D11_p13_lanes[1] * Lambda_inv_0_7_p25;
  const Real Lambda_inv_0_7_p29 = Lambda_inv_0_7_p20 - inverse_D10_p11_lanes[1] *
      Lambda_inv_0_7_p24 - inverse_D10_p24_lanes[1] * Lambda_inv_0_7_p25;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_0_p14 = c6 * Lambda_inv_0_0_p10 + s6 * Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_0_p15 = s6 * Lambda_inv_0_0_p10 - c6 * Lambda_inv_0_0_p9;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p13 = inverse_D2_p10 * inverse_D2_p11 -
      (inverse_D2_p4 - inverse_D2_p5 * inverse_D2_p6);
  const Real inverse_D2_p14 = inverse_D3_p58 - inverse_D2_p5 * inverse_D2_p7 - inverse_D2_p10 *
      inverse_D2_p12;
  const Real inverse_D2_p15 = inverse_D3_p37 + inverse_D3_p50 - inverse_D2_p3 * inverse_D2_p6 -
      inverse_D2_p9 * inverse_D2_p11;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p30 = s19 * Lambda_inv_0_7_p26 - c19 * Lambda_inv_0_7_p27;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p31 = -(c19 * Lambda_inv_0_7_p28);

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_0_p20_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_0_p14 +
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_0_p11;
  const Lanes<2> Lambda_inv_0_0_p21_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_0_p11 -
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_0_p14;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p32 = 0.269 * Lambda_inv_0_7_p29 - s19 * Lambda_inv_0_7_p28 -
      inverse_D10_p77_lanes[1] * Lambda_inv_0_7_p31;
  const Real Lambda_inv_0_7_p33 = -Lambda_inv_0_7_p30 + inverse_D8_p16_lanes[1] *
      Lambda_inv_0_7_p31;
  const Real Lambda_inv_0_7_p34 = Lambda_inv_0_7_p29 - inverse_D8_p17_lanes[1] * Lambda_inv_0_7_p31;
  const Real Lambda_inv_0_7_p35 = 0.269 * Lambda_inv_0_7_p30 - inverse_D10_p78_lanes[1] *
      Lambda_inv_0_7_p31;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_0_p24_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_0_p20_lanes + detail::make_pack<Real>(c8, c15) * Lambda_inv_0_0_p15;
  const Lanes<2> Lambda_inv_0_0_p25_lanes = detail::make_pack<Real>(s8, s15) * Lambda_inv_0_0_p15 -
      detail::make_pack<Real>(c8, c15) * Lambda_inv_0_0_p20_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p16 = Lambda_inv_0_0_p1 * (inverse_D2_p14 - inverse_D2_p15) +
      Lambda_inv_0_0_p2 * (2.0 * inverse_D2_p13);
  const Real inverse_D2_p17 = Lambda_inv_0_0_p1 * inverse_D2_p16;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p36 = s18 * Lambda_inv_0_7_p32 + c18 * Lambda_inv_0_7_p35;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_6_p13 = s16 * Lambda_inv_0_0_p24_lanes[1] + c16 *
      Lambda_inv_0_0_p21_lanes[1];
  const Real Lambda_inv_0_6_p14 = c16 * Lambda_inv_0_0_p24_lanes[1] - s16 *
      Lambda_inv_0_0_p21_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p37 = inverse_D9_p7_lanes[1] * Lambda_inv_0_7_p36;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p18 = Lambda_inv_0_0_p2 * inverse_D2_p16 - inverse_D2_p13;
  const Real inverse_D2_p19 = inverse_D2_p14 - inverse_D2_p17;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p38 = c18 * Lambda_inv_0_7_p32 - s18 * Lambda_inv_0_7_p35 -
      inverse_D9_p9_lanes[1] * Lambda_inv_0_7_p36;
  const Real Lambda_inv_0_7_p39 = c18 * Lambda_inv_0_7_p33 - s18 * Lambda_inv_0_7_p34 -
      inverse_D8_p80_lanes[1] * Lambda_inv_0_7_p36;
  const Real Lambda_inv_0_7_p40 = -(-(s19 * Lambda_inv_0_7_p27 + c19 * Lambda_inv_0_7_p26) -
      inverse_D8_p18_lanes[1] * Lambda_inv_0_7_p31) - inverse_D8_p81_lanes[1] * Lambda_inv_0_7_p36;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p15 = c17 * Lambda_inv_0_6_p13 + s17 * Lambda_inv_0_0_p25_lanes[1];
  const Real Lambda_inv_0_6_p16 = c17 * Lambda_inv_0_0_p25_lanes[1] - s17 * Lambda_inv_0_6_p13;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p41 = s18 * Lambda_inv_0_7_p33 + c18 * Lambda_inv_0_7_p34 -
      inverse_D8_p82_lanes[1] * Lambda_inv_0_7_p36;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = inverse_D2_p1 * inverse_D2_p19 + inverse_D2_p2 * inverse_D2_p18;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p42 = c17 * Lambda_inv_0_7_p37 - s17 * Lambda_inv_0_7_p38;
  const Real Lambda_inv_0_7_p43 = s17 * Lambda_inv_0_7_p40 - c17 * Lambda_inv_0_7_p39;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_2_p1 = c4 * Lambda_inv_0_0_p7;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_6_p17 = c18 * Lambda_inv_0_6_p15 + s18 * Lambda_inv_0_6_p14;
  const Real Lambda_inv_0_6_p18 = c18 * Lambda_inv_0_6_p14 - s18 * Lambda_inv_0_6_p15;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_2_p2 = s4 * Lambda_inv_0_0_p7;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1 = inverse_D2_p20 - (0.031999971599999996 * s2 - 24.5839218 * c2);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p44 = c17 * Lambda_inv_0_7_p38 + s17 * Lambda_inv_0_7_p37 + 0.282 *
      Lambda_inv_0_7_p41 - inverse_D8_p149_lanes[1] * Lambda_inv_0_7_p42;
  const Real Lambda_inv_0_7_p45 = 0.282 * Lambda_inv_0_7_p43 - inverse_D8_p150_lanes[1] *
      Lambda_inv_0_7_p42;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_2_p3 = s5 * Lambda_inv_0_2_p1 - c5 * Lambda_inv_0_0_p6;
  const Real Lambda_inv_0_2_p4 = s5 * Lambda_inv_0_0_p6 + c5 * Lambda_inv_0_2_p1;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p19 = c19 * Lambda_inv_0_6_p16 - s19 * Lambda_inv_0_6_p17;
  const Real Lambda_inv_0_6_p20 = c19 * Lambda_inv_0_6_p17 + s19 * Lambda_inv_0_6_p16;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = 9.885744550888212 + (inverse_D2_p2 *
      (inverse_D2_p1 * inverse_D2_p18 + inverse_D2_p2 * (inverse_D2_p15 + inverse_D2_p17)) +
      inverse_D2_p1 * inverse_D2_p20);

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / inverse_D2_p21;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p46 = c16 * Lambda_inv_0_7_p44 - s16 * Lambda_inv_0_7_p45;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_2_p7 = c6 * Lambda_inv_0_2_p3 + s6 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p8 = c6 * Lambda_inv_0_2_p2 - s6 * Lambda_inv_0_2_p3;

  // link 1 (calf), articulated inertia
  const Real Lambda_inv_0_6_p21 = Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_6_p18 -
      Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_6_p19;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p47 = Lambda_inv_0_0_p5_lanes[1] * Lambda_inv_0_7_p46;
  const Real Lambda_inv_0_7_p48 = s16 * Lambda_inv_0_7_p44 + c16 * Lambda_inv_0_7_p45 -
      inverse_D7_p8_lanes[1] * Lambda_inv_0_7_p46;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_2_p13_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_2_p7 +
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_2_p4;
  const Lanes<2> Lambda_inv_0_2_p14_lanes = detail::make_pack<Real>(s7, s14) * Lambda_inv_0_2_p7 -
      detail::make_pack<Real>(c7, c14) * Lambda_inv_0_2_p4;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p22 = -(Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_6_p20) +
      inverse_D12_p7_lanes[1] * Lambda_inv_0_6_p21;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p49 = s15 * Lambda_inv_0_7_p47 + c15 * Lambda_inv_0_7_p48;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_2_p19_lanes = detail::make_pack<Real>(c8, c15) * Lambda_inv_0_2_p8 -
      detail::make_pack<Real>(s8, s15) * Lambda_inv_0_2_p13_lanes;
  const Lanes<2> Lambda_inv_0_2_p20_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_2_p13_lanes + detail::make_pack<Real>(s8, s15) * Lambda_inv_0_2_p8;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p23 = Lambda_inv_0_6_p19 + inverse_D10_p10_lanes[1] *
      Lambda_inv_0_6_p21 - inverse_D10_p22_lanes[1] * Lambda_inv_0_6_p22;
  const Real Lambda_inv_0_6_p24 = Lambda_inv_0_6_p20 + inverse_D10_p23_lanes[1] *
      Lambda_inv_0_6_p22;
  const Real Lambda_inv_0_6_p25 = Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_6_p20 +
      inverse_D11_p5_lanes[1] * Lambda_inv_0_6_p21 - inverse_D11_p13_lanes[1] * Lambda_inv_0_6_p22;
  const Real Lambda_inv_0_6_p26 = Lambda_inv_0_6_p18 - inverse_D10_p11_lanes[1] *
      Lambda_inv_0_6_p21 - inverse_D10_p24_lanes[1] * Lambda_inv_0_6_p22;

  // link 9 (left_upperarm), pose
  const Lanes<8> Lambda_inv_0_0_p32_lanes = s9 *
      detail::make_pack<Real>(Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_1_p15_lanes[0],
      Lambda_inv_0_2_p19_lanes[0], Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_0_p24_lanes[0],
      Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_0_p24_lanes[0]) + c9 *
      detail::make_pack<Real>(Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_1_p12_lanes[0],
      Lambda_inv_0_2_p14_lanes[0], Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0],
      Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0]);
  const Lanes<8> Lambda_inv_0_0_p33_lanes = c9 *
      detail::make_pack<Real>(Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_1_p15_lanes[0],
      Lambda_inv_0_2_p19_lanes[0], Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_0_p24_lanes[0],
      Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_0_p24_lanes[0], Lambda_inv_0_0_p24_lanes[0]) - s9 *
      detail::make_pack<Real>(Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_1_p12_lanes[0],
      Lambda_inv_0_2_p14_lanes[0], Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0],
      Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0], Lambda_inv_0_0_p21_lanes[0]);

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p27 = s19 * Lambda_inv_0_6_p23 - c19 * Lambda_inv_0_6_p24;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p28 = -(c19 * Lambda_inv_0_6_p25);
  const Real Lambda_inv_0_6_p29 = 0.269 * Lambda_inv_0_6_p26 - s19 * Lambda_inv_0_6_p25 -
      inverse_D10_p77_lanes[1] * Lambda_inv_0_6_p28;
  const Real Lambda_inv_0_6_p30 = -Lambda_inv_0_6_p27 + inverse_D8_p16_lanes[1] *
      Lambda_inv_0_6_p28;
  const Real Lambda_inv_0_6_p31 = Lambda_inv_0_6_p26 - inverse_D8_p17_lanes[1] * Lambda_inv_0_6_p28;

  // link 10 (left_lowerarm), pose
  const Lanes<8> Lambda_inv_0_0_p38_lanes = c10 * Lambda_inv_0_0_p32_lanes + s10 *
      detail::make_pack<Real>(Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_1_p16_lanes[0],
      Lambda_inv_0_2_p20_lanes[0], Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_0_p25_lanes[0],
      Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_0_p25_lanes[0]);
  const Lanes<8> Lambda_inv_0_0_p39_lanes = c10 *
      detail::make_pack<Real>(Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_1_p16_lanes[0],
      Lambda_inv_0_2_p20_lanes[0], Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_0_p25_lanes[0],
      Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_0_p25_lanes[0], Lambda_inv_0_0_p25_lanes[0]) - s10 *
      Lambda_inv_0_0_p32_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p32 = 0.269 * Lambda_inv_0_6_p27 - inverse_D10_p78_lanes[1] *
      Lambda_inv_0_6_p28;

  // link 11 (left_wrist1), pose
  const Lanes<8> Lambda_inv_0_0_p44_lanes = c11 * Lambda_inv_0_0_p38_lanes + s11 *
      Lambda_inv_0_0_p33_lanes;
  const Lanes<8> Lambda_inv_0_0_p45_lanes = c11 * Lambda_inv_0_0_p33_lanes - s11 *
      Lambda_inv_0_0_p38_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p33 = s18 * Lambda_inv_0_6_p29 + c18 * Lambda_inv_0_6_p32;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p34 = inverse_D9_p7_lanes[1] * Lambda_inv_0_6_p33;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_inv_0_0_p49_lanes = c12 * Lambda_inv_0_0_p39_lanes - s12 *
      Lambda_inv_0_0_p44_lanes;
  const Lanes<8> Lambda_inv_0_0_p50_lanes = c12 * Lambda_inv_0_0_p44_lanes + s12 *
      Lambda_inv_0_0_p39_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p35 = c18 * Lambda_inv_0_6_p29 - s18 * Lambda_inv_0_6_p32 -
      inverse_D9_p9_lanes[1] * Lambda_inv_0_6_p33;
  const Real Lambda_inv_0_6_p36 = c18 * Lambda_inv_0_6_p30 - s18 * Lambda_inv_0_6_p31 -
      inverse_D8_p80_lanes[1] * Lambda_inv_0_6_p33;
  const Real Lambda_inv_0_6_p37 = -(-(s19 * Lambda_inv_0_6_p24 + c19 * Lambda_inv_0_6_p23) -
      inverse_D8_p18_lanes[1] * Lambda_inv_0_6_p28) - inverse_D8_p81_lanes[1] * Lambda_inv_0_6_p33;
  const Real Lambda_inv_0_6_p38 = s18 * Lambda_inv_0_6_p30 + c18 * Lambda_inv_0_6_p31 -
      inverse_D8_p82_lanes[1] * Lambda_inv_0_6_p33;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_inv_0_0_p53_lanes = Lambda_inv_0_0_p3_lanes[0] * Lambda_inv_0_0_p50_lanes;
  const Lanes<8> Lambda_inv_0_0_p54_lanes = Lambda_inv_0_0_p4_lanes[0] * Lambda_inv_0_0_p45_lanes -
      Lambda_inv_0_0_p3_lanes[0] * Lambda_inv_0_0_p49_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p55_lanes = -(Lambda_inv_0_0_p4_lanes[0] *
      Lambda_inv_0_0_p50_lanes);

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p39 = c17 * Lambda_inv_0_6_p34 - s17 * Lambda_inv_0_6_p35;
  const Real Lambda_inv_0_6_p40 = s17 * Lambda_inv_0_6_p37 - c17 * Lambda_inv_0_6_p36;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p50 = -Lambda_inv_0_7_p43 + inverse_D6_p31_lanes[1] *
      Lambda_inv_0_7_p42;
  const Real Lambda_inv_0_7_p51 = Lambda_inv_0_7_p41 - inverse_D6_p33_lanes[1] * Lambda_inv_0_7_p42;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p60_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p55_lanes[0],
      Lambda_inv_0_0_p55_lanes[1], Lambda_inv_0_0_p55_lanes[2], Lambda_inv_0_0_p45_lanes[0],
      Lambda_inv_0_0_p45_lanes[1], Lambda_inv_0_0_p45_lanes[2], Lambda_inv_0_0_p55_lanes[0],
      Lambda_inv_0_0_p55_lanes[0]) + inverse_D12_p7_lanes[0] *
      detail::make_pack<Real>(Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[1],
      Lambda_inv_0_0_p54_lanes[2], Lambda_inv_0_0_p50_lanes[0], Lambda_inv_0_0_p50_lanes[1],
      Lambda_inv_0_0_p50_lanes[2], Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[0]);
  const Lanes<8> Lambda_inv_0_0_p61_lanes = Lambda_inv_0_0_p49_lanes + inverse_D10_p10_lanes[0] *
      Lambda_inv_0_0_p54_lanes;
  const Lanes<8> Lambda_inv_0_0_p63_lanes = Lambda_inv_0_0_p45_lanes - inverse_D10_p11_lanes[0] *
      Lambda_inv_0_0_p54_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p41 = 0.282 * Lambda_inv_0_6_p40 - inverse_D8_p150_lanes[1] *
      Lambda_inv_0_6_p39;
  const Real Lambda_inv_0_6_p42 = -Lambda_inv_0_6_p40 + inverse_D6_p31_lanes[1] *
      Lambda_inv_0_6_p39;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_3_p7_lanes = inverse_D10_p23_lanes[0] * Lambda_inv_0_0_p60_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p43 = c17 * Lambda_inv_0_6_p35 + s17 * Lambda_inv_0_6_p34 + 0.282 *
      Lambda_inv_0_6_p38 - inverse_D8_p149_lanes[1] * Lambda_inv_0_6_p39;
  const Real Lambda_inv_0_6_p44 = Lambda_inv_0_6_p38 - inverse_D6_p33_lanes[1] * Lambda_inv_0_6_p39;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p68_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p61_lanes[0],
      Lambda_inv_0_0_p61_lanes[1], Lambda_inv_0_0_p61_lanes[2], inverse_D10_p10_lanes[0] *
      Lambda_inv_0_0_p50_lanes[0], inverse_D10_p10_lanes[0] * Lambda_inv_0_0_p50_lanes[1],
      inverse_D10_p10_lanes[0] * Lambda_inv_0_0_p50_lanes[2], Lambda_inv_0_0_p61_lanes[0],
      Lambda_inv_0_0_p61_lanes[0]) - inverse_D10_p22_lanes[0] * Lambda_inv_0_0_p60_lanes;
  const Lanes<8> Lambda_inv_0_0_p69_lanes = Lambda_inv_0_0_p50_lanes + inverse_D10_p23_lanes[0] *
      Lambda_inv_0_0_p60_lanes;
  const Lanes<8> Lambda_inv_0_0_p70_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p53_lanes[0],
      Lambda_inv_0_0_p53_lanes[1], Lambda_inv_0_0_p53_lanes[2], Lambda_inv_0_0_p49_lanes[0],
      Lambda_inv_0_0_p49_lanes[1], Lambda_inv_0_0_p49_lanes[2], Lambda_inv_0_0_p53_lanes[0],
      Lambda_inv_0_0_p53_lanes[0]) + inverse_D11_p5_lanes[0] *
      detail::make_pack<Real>(Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[1],
      Lambda_inv_0_0_p54_lanes[2], Lambda_inv_0_0_p50_lanes[0], Lambda_inv_0_0_p50_lanes[1],
      Lambda_inv_0_0_p50_lanes[2], Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[0]) -
      inverse_D11_p13_lanes[0] * Lambda_inv_0_0_p60_lanes;
  const Lanes<8> Lambda_inv_0_0_p71_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p63_lanes[0],
      Lambda_inv_0_0_p63_lanes[1], Lambda_inv_0_0_p63_lanes[2],
      -(inverse_D10_p11_lanes[0] * Lambda_inv_0_0_p50_lanes[0]),
      -(inverse_D10_p11_lanes[0] * Lambda_inv_0_0_p50_lanes[1]),
      -(inverse_D10_p11_lanes[0] * Lambda_inv_0_0_p50_lanes[2]), Lambda_inv_0_0_p63_lanes[0],
      Lambda_inv_0_0_p63_lanes[0]) - inverse_D10_p24_lanes[0] * Lambda_inv_0_0_p60_lanes;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p45 = c16 * Lambda_inv_0_6_p43 - s16 * Lambda_inv_0_6_p41;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p52 = s16 * Lambda_inv_0_7_p50 + c16 * Lambda_inv_0_7_p51 -
      inverse_D6_p163_lanes[1] * Lambda_inv_0_7_p46;
  const Real Lambda_inv_0_7_p53 = -(-(s17 * Lambda_inv_0_7_p39 + c17 * Lambda_inv_0_7_p40) +
      inverse_D6_p35_lanes[1] * Lambda_inv_0_7_p42) + inverse_D6_p161_lanes[1] * Lambda_inv_0_7_p46;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p79_lanes = s12 * Lambda_inv_0_0_p68_lanes - c12 *
      detail::make_pack<Real>(Lambda_inv_0_0_p69_lanes[0], Lambda_inv_0_0_p69_lanes[1],
      Lambda_inv_0_0_p69_lanes[2], Lambda_inv_0_3_p7_lanes[3], Lambda_inv_0_3_p7_lanes[4],
      Lambda_inv_0_3_p7_lanes[5], Lambda_inv_0_0_p69_lanes[0], Lambda_inv_0_0_p69_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p80_lanes = -(c12 * Lambda_inv_0_0_p70_lanes);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p46 = Lambda_inv_0_0_p5_lanes[1] * Lambda_inv_0_6_p45;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p90_lanes = 0.269 * Lambda_inv_0_0_p71_lanes - s12 *
      Lambda_inv_0_0_p70_lanes - inverse_D10_p77_lanes[0] * Lambda_inv_0_0_p80_lanes;
  const Lanes<8> Lambda_inv_0_0_p91_lanes = -Lambda_inv_0_0_p79_lanes + inverse_D8_p16_lanes[0] *
      Lambda_inv_0_0_p80_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p93_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p94_lanes = Lambda_inv_0_0_p71_lanes - inverse_D8_p17_lanes[0] *
      Lambda_inv_0_0_p80_lanes;
  const Lanes<8> Lambda_inv_0_0_p95_lanes = -(s12 *
      detail::make_pack<Real>(Lambda_inv_0_0_p69_lanes[0], Lambda_inv_0_0_p69_lanes[1],
      Lambda_inv_0_0_p69_lanes[2], Lambda_inv_0_3_p7_lanes[3], Lambda_inv_0_3_p7_lanes[4],
      Lambda_inv_0_3_p7_lanes[5], Lambda_inv_0_0_p69_lanes[0], Lambda_inv_0_0_p69_lanes[0]) + c12 *
      Lambda_inv_0_0_p68_lanes) - inverse_D8_p18_lanes[0] * Lambda_inv_0_0_p80_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p48 = s16 * Lambda_inv_0_6_p43 + c16 * Lambda_inv_0_6_p41 -
      inverse_D7_p8_lanes[1] * Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p49 = s16 * Lambda_inv_0_6_p42 + c16 * Lambda_inv_0_6_p44 -
      inverse_D6_p163_lanes[1] * Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p50 = -(-(s17 * Lambda_inv_0_6_p36 + c17 * Lambda_inv_0_6_p37) +
      inverse_D6_p35_lanes[1] * Lambda_inv_0_6_p39) + inverse_D6_p161_lanes[1] * Lambda_inv_0_6_p45;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p96_lanes = 0.269 * Lambda_inv_0_0_p79_lanes -
      inverse_D10_p78_lanes[0] * Lambda_inv_0_0_p80_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p51 = s15 * Lambda_inv_0_6_p46 + c15 * Lambda_inv_0_6_p48;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p108_lanes = s11 * Lambda_inv_0_0_p90_lanes + c11 *
      Lambda_inv_0_0_p96_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p113_lanes = inverse_D9_p7_lanes[0] * Lambda_inv_0_0_p108_lanes;
  const Lanes<8> Lambda_inv_0_0_p115_lanes = c11 * Lambda_inv_0_0_p90_lanes - s11 *
      Lambda_inv_0_0_p96_lanes - inverse_D9_p9_lanes[0] * Lambda_inv_0_0_p108_lanes;
  const Lanes<8> Lambda_inv_0_0_p116_lanes = -Lambda_inv_0_0_p95_lanes - inverse_D8_p81_lanes[0] *
      Lambda_inv_0_0_p108_lanes;
  const Lanes<8> Lambda_inv_0_0_p117_lanes = c11 * Lambda_inv_0_0_p91_lanes - s11 *
      Lambda_inv_0_0_p94_lanes - inverse_D8_p80_lanes[0] * Lambda_inv_0_0_p108_lanes;
  const Lanes<8> Lambda_inv_0_0_p120_lanes = s11 * Lambda_inv_0_0_p91_lanes + c11 *
      Lambda_inv_0_0_p94_lanes - inverse_D8_p82_lanes[0] * Lambda_inv_0_0_p108_lanes;
  const Lanes<8> Lambda_inv_0_0_p128_lanes = c10 * Lambda_inv_0_0_p113_lanes - s10 *
      Lambda_inv_0_0_p115_lanes;
  const Lanes<8> Lambda_inv_0_0_p129_lanes = s10 * Lambda_inv_0_0_p116_lanes - c10 *
      Lambda_inv_0_0_p117_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p132_lanes = inverse_D8_p149_lanes[0] * Lambda_inv_0_0_p128_lanes;
  const Lanes<8> Lambda_inv_0_0_p141_lanes = c10 * Lambda_inv_0_0_p115_lanes + s10 *
      Lambda_inv_0_0_p113_lanes + 0.282 * Lambda_inv_0_0_p120_lanes - Lambda_inv_0_0_p132_lanes;
  const Lanes<8> Lambda_inv_0_0_p142_lanes = 0.282 * Lambda_inv_0_0_p129_lanes -
      inverse_D8_p150_lanes[0] * Lambda_inv_0_0_p128_lanes;
  const Lanes<8> Lambda_inv_0_0_p143_lanes = -Lambda_inv_0_0_p129_lanes + inverse_D6_p31_lanes[0] *
      Lambda_inv_0_0_p128_lanes;
  const Lanes<8> Lambda_inv_0_0_p144_lanes = Lambda_inv_0_0_p120_lanes - inverse_D6_p33_lanes[0] *
      Lambda_inv_0_0_p128_lanes;
  const Lanes<8> Lambda_inv_0_0_p145_lanes = -(s10 * Lambda_inv_0_0_p117_lanes + c10 *
      Lambda_inv_0_0_p116_lanes) + inverse_D6_p35_lanes[0] * Lambda_inv_0_0_p128_lanes;
  const Lanes<8> Lambda_inv_0_0_p155_lanes = c9 * Lambda_inv_0_0_p141_lanes - s9 *
      Lambda_inv_0_0_p142_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p160_lanes = Lambda_inv_0_0_p5_lanes[0] * Lambda_inv_0_0_p155_lanes;
  const Lanes<8> Lambda_inv_0_0_p164_lanes = s9 * Lambda_inv_0_0_p141_lanes + c9 *
      Lambda_inv_0_0_p142_lanes - inverse_D7_p8_lanes[0] * Lambda_inv_0_0_p155_lanes;
  const Lanes<8> Lambda_inv_0_0_p166_lanes = s9 * Lambda_inv_0_0_p143_lanes + c9 *
      Lambda_inv_0_0_p144_lanes - inverse_D6_p163_lanes[0] * Lambda_inv_0_0_p155_lanes;
  const Lanes<8> Lambda_inv_0_0_p167_lanes = -Lambda_inv_0_0_p145_lanes + inverse_D6_p161_lanes[0] *
      Lambda_inv_0_0_p155_lanes;
  const Lanes<8> Lambda_inv_0_0_p168_lanes = c9 * Lambda_inv_0_0_p143_lanes - s9 *
      Lambda_inv_0_0_p144_lanes - inverse_D6_p165_lanes[0] * Lambda_inv_0_0_p155_lanes;
  const Lanes<8> Lambda_inv_0_0_p176_lanes = s8 * Lambda_inv_0_0_p160_lanes + c8 *
      Lambda_inv_0_0_p164_lanes;
  const Lanes<8> Lambda_inv_0_0_p177_lanes = c8 * Lambda_inv_0_0_p167_lanes - s8 *
      Lambda_inv_0_0_p166_lanes;
  const Lanes<8> Lambda_inv_0_0_p178_lanes = s8 * Lambda_inv_0_0_p167_lanes + c8 *
      Lambda_inv_0_0_p166_lanes;
  const Lanes<8> Lambda_inv_0_0_p179_lanes = c8 * Lambda_inv_0_0_p160_lanes - s8 *
      Lambda_inv_0_0_p164_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p184_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p93_lanes[0],
      Lambda_inv_0_0_p93_lanes[0], Lambda_inv_0_0_p93_lanes[0], Lambda_inv_0_0_p93_lanes[0],
      Lambda_inv_0_0_p93_lanes[0], Lambda_inv_0_0_p93_lanes[0], Lambda_inv_0_0_p93_lanes[1],
      Lambda_inv_0_0_p93_lanes[1]) * detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[0],
      Lambda_inv_0_0_p176_lanes[1], Lambda_inv_0_0_p176_lanes[2], Lambda_inv_0_0_p176_lanes[3],
      Lambda_inv_0_0_p176_lanes[4], Lambda_inv_0_0_p176_lanes[5], Lambda_inv_0_6_p51,
      Lambda_inv_0_7_p49);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p185_lanes = Lambda_inv_0_0_p108_lanes * inverse_D10_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p186_lanes = Lambda_inv_0_0_p128_lanes * inverse_D9_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p187_lanes = Lambda_inv_0_0_p80_lanes * inverse_D11_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p188_lanes = Lambda_inv_0_0_p155_lanes * inverse_D8_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p189_lanes = Lambda_inv_0_0_p60_lanes * inverse_D12_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p190_lanes = Lambda_inv_0_0_p176_lanes * inverse_D7_lanes[0];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p191_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[1],
      Lambda_inv_0_0_p54_lanes[2], Lambda_inv_0_0_p50_lanes[0], Lambda_inv_0_0_p50_lanes[1],
      Lambda_inv_0_0_p50_lanes[2], Lambda_inv_0_0_p54_lanes[0], Lambda_inv_0_0_p54_lanes[0]);

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D2_p19 - inverse_D1_p1 * inverse_D1_p2));

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p192_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p168_lanes[0],
      Lambda_inv_0_0_p168_lanes[1], Lambda_inv_0_0_p168_lanes[2], Lambda_inv_0_0_p168_lanes[3],
      Lambda_inv_0_0_p168_lanes[4], Lambda_inv_0_0_p168_lanes[5], c16 * Lambda_inv_0_6_p42 - s16 *
      Lambda_inv_0_6_p44 - inverse_D6_p165_lanes[1] * Lambda_inv_0_6_p45, c16 * Lambda_inv_0_7_p50 -
      s16 * Lambda_inv_0_7_p51 - inverse_D6_p165_lanes[1] * Lambda_inv_0_7_p46) -
      detail::make_pack<Real>(inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[0],
      inverse_D6_p294_lanes[0], inverse_D6_p294_lanes[1], inverse_D6_p294_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[0], Lambda_inv_0_0_p176_lanes[1],
      Lambda_inv_0_0_p176_lanes[2], Lambda_inv_0_0_p176_lanes[3], Lambda_inv_0_0_p176_lanes[4],
      Lambda_inv_0_0_p176_lanes[5], Lambda_inv_0_6_p51, Lambda_inv_0_7_p49);
  const Lanes<8> Lambda_inv_0_0_p193_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p177_lanes[0],
      Lambda_inv_0_0_p177_lanes[1], Lambda_inv_0_0_p177_lanes[2], Lambda_inv_0_0_p177_lanes[3],
      Lambda_inv_0_0_p177_lanes[4], Lambda_inv_0_0_p177_lanes[5], c15 * Lambda_inv_0_6_p50 - s15 *
      Lambda_inv_0_6_p49, c15 * Lambda_inv_0_7_p53 - s15 * Lambda_inv_0_7_p52) -
      detail::make_pack<Real>(inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[0],
      inverse_D6_p292_lanes[0], inverse_D6_p292_lanes[1], inverse_D6_p292_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[0], Lambda_inv_0_0_p176_lanes[1],
      Lambda_inv_0_0_p176_lanes[2], Lambda_inv_0_0_p176_lanes[3], Lambda_inv_0_0_p176_lanes[4],
      Lambda_inv_0_0_p176_lanes[5], Lambda_inv_0_6_p51, Lambda_inv_0_7_p49);
  const Lanes<8> Lambda_inv_0_0_p194_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p178_lanes[0],
      Lambda_inv_0_0_p178_lanes[1], Lambda_inv_0_0_p178_lanes[2], Lambda_inv_0_0_p178_lanes[3],
      Lambda_inv_0_0_p178_lanes[4], Lambda_inv_0_0_p178_lanes[5], s15 * Lambda_inv_0_6_p50 + c15 *
      Lambda_inv_0_6_p49, s15 * Lambda_inv_0_7_p53 + c15 * Lambda_inv_0_7_p52) -
      detail::make_pack<Real>(inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[0],
      inverse_D6_p299_lanes[0], inverse_D6_p299_lanes[1], inverse_D6_p299_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[0], Lambda_inv_0_0_p176_lanes[1],
      Lambda_inv_0_0_p176_lanes[2], Lambda_inv_0_0_p176_lanes[3], Lambda_inv_0_0_p176_lanes[4],
      Lambda_inv_0_0_p176_lanes[5], Lambda_inv_0_6_p51, Lambda_inv_0_7_p49);
  const Lanes<8> Lambda_inv_0_0_p195_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p179_lanes[0],
      Lambda_inv_0_0_p179_lanes[1], Lambda_inv_0_0_p179_lanes[2], Lambda_inv_0_0_p179_lanes[3],
      Lambda_inv_0_0_p179_lanes[4], Lambda_inv_0_0_p179_lanes[5], c15 * Lambda_inv_0_6_p46 - s15 *
      Lambda_inv_0_6_p48, c15 * Lambda_inv_0_7_p47 - s15 * Lambda_inv_0_7_p48) -
      detail::make_pack<Real>(inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[0],
      inverse_D6_p332_lanes[0], inverse_D6_p332_lanes[1], inverse_D6_p332_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[0], Lambda_inv_0_0_p176_lanes[1],
      Lambda_inv_0_0_p176_lanes[2], Lambda_inv_0_0_p176_lanes[3], Lambda_inv_0_0_p176_lanes[4],
      Lambda_inv_0_0_p176_lanes[5], Lambda_inv_0_6_p51, Lambda_inv_0_7_p49);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p199_lanes = Lambda_inv_0_0_p185_lanes *
      Lambda_inv_0_0_p108_lanes[0];

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_8_p13 = s16 * Lambda_inv_0_2_p19_lanes[1] + c16 *
      Lambda_inv_0_2_p14_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p213_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_inv_0_0_p192_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_inv_0_0_p193_lanes;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_8_p14 = c16 * Lambda_inv_0_2_p19_lanes[1] - s16 *
      Lambda_inv_0_2_p14_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p215_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p192_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_inv_0_0_p193_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p221_lanes = Lambda_inv_0_0_p191_lanes *
      Lambda_inv_0_0_p54_lanes[0] + Lambda_inv_0_0_p189_lanes * Lambda_inv_0_0_p60_lanes[0] +
      Lambda_inv_0_0_p187_lanes * Lambda_inv_0_0_p80_lanes[0] + Lambda_inv_0_0_p199_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_8_p15 = c17 * Lambda_inv_0_8_p13 + s17 * Lambda_inv_0_2_p20_lanes[1];
  const Real Lambda_inv_0_8_p16 = c17 * Lambda_inv_0_2_p20_lanes[1] - s17 * Lambda_inv_0_8_p13;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p222_lanes = 0.226 * Lambda_inv_0_0_p194_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_inv_0_0_p213_lanes;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_8_p17 = c18 * Lambda_inv_0_8_p15 + s18 * Lambda_inv_0_8_p14;
  const Real Lambda_inv_0_8_p18 = c18 * Lambda_inv_0_8_p14 - s18 * Lambda_inv_0_8_p15;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p227_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p184_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_inv_0_0_p195_lanes + Lambda_inv_0_0_p222_lanes);
  const Lanes<8> Lambda_inv_0_0_p228_lanes = inverse_D5_p73 * Lambda_inv_0_0_p227_lanes;
  const Real Lambda_inv_0_7_p88 = Lambda_inv_0_0_p227_lanes[7] * inverse_D6;
  const Real Lambda_inv_0_6_p86 = Lambda_inv_0_0_p227_lanes[6] * inverse_D6;
  const Lanes<8> Lambda_inv_0_0_p233_lanes = Lambda_inv_0_0_p227_lanes * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p234_lanes = Lambda_inv_0_0_p221_lanes + Lambda_inv_0_0_p186_lanes *
      Lambda_inv_0_0_p128_lanes[0] + Lambda_inv_0_0_p188_lanes * Lambda_inv_0_0_p155_lanes[0] +
      Lambda_inv_0_0_p190_lanes * Lambda_inv_0_0_p176_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p235_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_inv_0_0_p215_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_inv_0_0_p184_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_inv_0_0_p195_lanes) -
      Lambda_inv_0_0_p228_lanes;
  const Lanes<8> Lambda_inv_0_0_p236_lanes = 0.226 * Lambda_inv_0_0_p215_lanes - inverse_D5_p72 *
      Lambda_inv_0_0_p227_lanes;
  const Lanes<8> Lambda_inv_0_0_p237_lanes = Lambda_inv_0_0_p215_lanes - inverse_D5_p71 *
      Lambda_inv_0_0_p227_lanes;
  const Lanes<8> Lambda_inv_0_0_p238_lanes = Lambda_inv_0_0_p213_lanes + inverse_D3_p14 *
      Lambda_inv_0_0_p227_lanes;
  const Lanes<8> Lambda_inv_0_0_p239_lanes = Lambda_inv_0_0_p194_lanes - inverse_D3_p15 *
      Lambda_inv_0_0_p227_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_8_p19 = c19 * Lambda_inv_0_8_p16 - s19 * Lambda_inv_0_8_p17;
  const Real Lambda_inv_0_8_p20 = c19 * Lambda_inv_0_8_p17 + s19 * Lambda_inv_0_8_p16;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_9_p1_lanes = inverse_D10_p10_lanes[1] *
      detail::make_pack<Real>(Lambda_inv_0_6_p20, Lambda_inv_0_6_p20, Lambda_inv_0_7_p23,
      Lambda_inv_0_8_p20, Lambda_inv_0_6_p20, Lambda_inv_0_6_p20, Lambda_inv_0_6_p20,
      Lambda_inv_0_6_p20);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p251_lanes = Lambda_inv_0_0_p234_lanes + Lambda_inv_0_0_p233_lanes *
      Lambda_inv_0_0_p227_lanes[0];
  const Lanes<8> Lambda_inv_0_0_p253_lanes = s6 * Lambda_inv_0_0_p238_lanes + c6 *
      Lambda_inv_0_0_p239_lanes;

  // link 1 (calf), articulated inertia
  const Real Lambda_inv_0_8_p21 = Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_8_p18 -
      Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_8_p19;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p255_lanes = s6 * Lambda_inv_0_0_p235_lanes + c6 *
      Lambda_inv_0_0_p236_lanes + 0.072 * Lambda_inv_0_0_p237_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_9_p3_lanes = -(inverse_D10_p11_lanes[1] *
      detail::make_pack<Real>(Lambda_inv_0_6_p20, Lambda_inv_0_6_p20, Lambda_inv_0_7_p23,
      Lambda_inv_0_8_p20, Lambda_inv_0_6_p20, Lambda_inv_0_6_p20, Lambda_inv_0_6_p20,
      Lambda_inv_0_6_p20));

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p262_lanes = Lambda_inv_0_0_p255_lanes * inverse_D5;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_8_p24_lanes = detail::make_pack<Real>(-(Lambda_inv_0_0_p4_lanes[1] *
      Lambda_inv_0_8_p20), Lambda_inv_0_6_p18, Lambda_inv_0_7_p20, Lambda_inv_0_8_p18,
      -(Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_8_p20),
      -(Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_8_p20),
      -(Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_8_p20),
      -(Lambda_inv_0_0_p4_lanes[1] * Lambda_inv_0_8_p20)) + inverse_D12_p7_lanes[1] *
      detail::make_pack<Real>(Lambda_inv_0_8_p21, Lambda_inv_0_6_p20, Lambda_inv_0_7_p23,
      Lambda_inv_0_8_p20, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p264_lanes = c6 * Lambda_inv_0_0_p238_lanes - s6 *
      Lambda_inv_0_0_p239_lanes - inverse_D3_p35 * Lambda_inv_0_0_p255_lanes;
  const Lanes<8> Lambda_inv_0_0_p265_lanes = Lambda_inv_0_0_p237_lanes - inverse_D3_p34 *
      Lambda_inv_0_0_p255_lanes;
  const Lanes<8> Lambda_inv_0_0_p266_lanes = c6 * Lambda_inv_0_0_p235_lanes - s6 *
      Lambda_inv_0_0_p236_lanes - inverse_D4_p11 * Lambda_inv_0_0_p255_lanes;
  const Lanes<8> Lambda_inv_0_0_p267_lanes = -(0.072 * Lambda_inv_0_0_p253_lanes) + inverse_D4_p10 *
      Lambda_inv_0_0_p255_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_9_p10_lanes = inverse_D10_p23_lanes[1] * Lambda_inv_0_8_p24_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p274_lanes = s4 * (Lambda_inv_0_0_p253_lanes - inverse_D3_p36 *
      Lambda_inv_0_0_p255_lanes);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_8_p29_lanes = detail::make_pack<Real>(Lambda_inv_0_8_p19 +
      inverse_D10_p10_lanes[1] * Lambda_inv_0_8_p21, Lambda_inv_0_9_p1_lanes[1],
      Lambda_inv_0_9_p1_lanes[2], Lambda_inv_0_9_p1_lanes[3], Lambda_inv_0_8_p19 +
      inverse_D10_p10_lanes[1] * Lambda_inv_0_8_p21, Lambda_inv_0_8_p19 + inverse_D10_p10_lanes[1] *
      Lambda_inv_0_8_p21, Lambda_inv_0_8_p19 + inverse_D10_p10_lanes[1] * Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p19 + inverse_D10_p10_lanes[1] * Lambda_inv_0_8_p21) -
      inverse_D10_p22_lanes[1] * Lambda_inv_0_8_p24_lanes;
  const Real Lambda_inv_0_8_p30 = Lambda_inv_0_8_p20 + inverse_D10_p23_lanes[1] *
      Lambda_inv_0_8_p24_lanes[0];
  const Lanes<8> Lambda_inv_0_8_p31_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p3_lanes[1] *
      Lambda_inv_0_8_p20, Lambda_inv_0_6_p19, Lambda_inv_0_7_p22, Lambda_inv_0_8_p19,
      Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_8_p20, Lambda_inv_0_0_p3_lanes[1] *
      Lambda_inv_0_8_p20, Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_8_p20,
      Lambda_inv_0_0_p3_lanes[1] * Lambda_inv_0_8_p20) + inverse_D11_p5_lanes[1] *
      detail::make_pack<Real>(Lambda_inv_0_8_p21, Lambda_inv_0_6_p20, Lambda_inv_0_7_p23,
      Lambda_inv_0_8_p20, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21) - inverse_D11_p13_lanes[1] * Lambda_inv_0_8_p24_lanes;
  const Lanes<8> Lambda_inv_0_8_p32_lanes = detail::make_pack<Real>(Lambda_inv_0_8_p18 -
      inverse_D10_p11_lanes[1] * Lambda_inv_0_8_p21, Lambda_inv_0_9_p3_lanes[1],
      Lambda_inv_0_9_p3_lanes[2], Lambda_inv_0_9_p3_lanes[3], Lambda_inv_0_8_p18 -
      inverse_D10_p11_lanes[1] * Lambda_inv_0_8_p21, Lambda_inv_0_8_p18 - inverse_D10_p11_lanes[1] *
      Lambda_inv_0_8_p21, Lambda_inv_0_8_p18 - inverse_D10_p11_lanes[1] * Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p18 - inverse_D10_p11_lanes[1] * Lambda_inv_0_8_p21) -
      inverse_D10_p24_lanes[1] * Lambda_inv_0_8_p24_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p285_lanes = -(s5 * Lambda_inv_0_0_p267_lanes + c5 *
      Lambda_inv_0_0_p266_lanes);
  const Lanes<8> Lambda_inv_0_0_p290_lanes = Lambda_inv_0_0_p285_lanes * inverse_D4;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_8_p40_lanes = s19 * Lambda_inv_0_8_p29_lanes - c19 *
      detail::make_pack<Real>(Lambda_inv_0_8_p30, Lambda_inv_0_9_p10_lanes[1],
      Lambda_inv_0_9_p10_lanes[2], Lambda_inv_0_9_p10_lanes[3], Lambda_inv_0_8_p30,
      Lambda_inv_0_8_p30, Lambda_inv_0_8_p30, Lambda_inv_0_8_p30);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p41_lanes = -(c19 * Lambda_inv_0_8_p31_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p291_lanes = c4 * (s5 * Lambda_inv_0_0_p264_lanes - c5 *
      Lambda_inv_0_0_p265_lanes) + Lambda_inv_0_0_p274_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p293_lanes = -(s5 * Lambda_inv_0_0_p265_lanes + c5 *
      Lambda_inv_0_0_p264_lanes) - inverse_D2_p6 * Lambda_inv_0_0_p285_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p51_lanes = 0.269 * Lambda_inv_0_8_p32_lanes - s19 *
      Lambda_inv_0_8_p31_lanes - inverse_D10_p77_lanes[1] * Lambda_inv_0_8_p41_lanes;
  const Lanes<8> Lambda_inv_0_8_p52_lanes = -Lambda_inv_0_8_p40_lanes + inverse_D8_p16_lanes[1] *
      Lambda_inv_0_8_p41_lanes;
  const Lanes<8> Lambda_inv_0_8_p54_lanes = Lambda_inv_0_8_p32_lanes - inverse_D8_p17_lanes[1] *
      Lambda_inv_0_8_p41_lanes;
  const Lanes<8> Lambda_inv_0_8_p55_lanes = -(s19 *
      detail::make_pack<Real>(Lambda_inv_0_8_p30, Lambda_inv_0_9_p10_lanes[1],
      Lambda_inv_0_9_p10_lanes[2], Lambda_inv_0_9_p10_lanes[3], Lambda_inv_0_8_p30,
      Lambda_inv_0_8_p30, Lambda_inv_0_8_p30, Lambda_inv_0_8_p30) + c19 *
      Lambda_inv_0_8_p29_lanes) - inverse_D8_p18_lanes[1] * Lambda_inv_0_8_p41_lanes;
  const Lanes<8> Lambda_inv_0_8_p56_lanes = 0.269 * Lambda_inv_0_8_p40_lanes -
      inverse_D10_p78_lanes[1] * Lambda_inv_0_8_p41_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p300_lanes = s4 * (s5 * Lambda_inv_0_0_p266_lanes - c5 *
      Lambda_inv_0_0_p267_lanes) + 0.21799999999999997 * Lambda_inv_0_0_p291_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p302_lanes = -Lambda_inv_0_0_p300_lanes - inverse_D3_p60 *
      Lambda_inv_0_0_p285_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p68_lanes = s18 * Lambda_inv_0_8_p51_lanes + c18 *
      Lambda_inv_0_8_p56_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p305_lanes = Lambda_inv_0_0_p302_lanes * inverse_D3;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p73_lanes = inverse_D9_p7_lanes[1] * Lambda_inv_0_8_p68_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p306_lanes = -Lambda_inv_0_0_p291_lanes - inverse_D2_p7 *
      Lambda_inv_0_0_p285_lanes - inverse_D2_p12 * Lambda_inv_0_0_p302_lanes;
  const Lanes<8> Lambda_inv_0_0_p307_lanes = -Lambda_inv_0_0_p293_lanes + inverse_D2_p11 *
      Lambda_inv_0_0_p302_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p75_lanes = c18 * Lambda_inv_0_8_p51_lanes - s18 *
      Lambda_inv_0_8_p56_lanes - inverse_D9_p9_lanes[1] * Lambda_inv_0_8_p68_lanes;
  const Lanes<8> Lambda_inv_0_8_p76_lanes = -Lambda_inv_0_8_p55_lanes - inverse_D8_p81_lanes[1] *
      Lambda_inv_0_8_p68_lanes;
  const Lanes<8> Lambda_inv_0_8_p77_lanes = c18 * Lambda_inv_0_8_p52_lanes - s18 *
      Lambda_inv_0_8_p54_lanes - inverse_D8_p80_lanes[1] * Lambda_inv_0_8_p68_lanes;
  const Lanes<8> Lambda_inv_0_8_p80_lanes = s18 * Lambda_inv_0_8_p52_lanes + c18 *
      Lambda_inv_0_8_p54_lanes - inverse_D8_p82_lanes[1] * Lambda_inv_0_8_p68_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p313_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p251_lanes[0],
      Lambda_inv_0_0_p251_lanes[1], Lambda_inv_0_0_p251_lanes[2], Lambda_inv_0_0_p251_lanes[3],
      Lambda_inv_0_0_p251_lanes[4], Lambda_inv_0_0_p251_lanes[5], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[0], Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[0]) +
      Lambda_inv_0_0_p262_lanes * Lambda_inv_0_0_p255_lanes[0] + Lambda_inv_0_0_p290_lanes *
      Lambda_inv_0_0_p285_lanes[0] + Lambda_inv_0_0_p305_lanes * Lambda_inv_0_0_p302_lanes[0];
  const Lanes<8> Lambda_inv_0_0_p315_lanes = Lambda_inv_0_0_p2 * Lambda_inv_0_0_p306_lanes -
      Lambda_inv_0_0_p1 * Lambda_inv_0_0_p307_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p88_lanes = c17 * Lambda_inv_0_8_p73_lanes - s17 *
      Lambda_inv_0_8_p75_lanes;
  const Lanes<8> Lambda_inv_0_8_p89_lanes = s17 * Lambda_inv_0_8_p76_lanes - c17 *
      Lambda_inv_0_8_p77_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p92_lanes = inverse_D8_p149_lanes[1] * Lambda_inv_0_8_p88_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p318_lanes = inverse_D2_p2 *
      (Lambda_inv_0_0_p1 * Lambda_inv_0_0_p306_lanes + Lambda_inv_0_0_p2 *
      Lambda_inv_0_0_p307_lanes) + inverse_D2_p1 * Lambda_inv_0_0_p315_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p101_lanes = c17 * Lambda_inv_0_8_p75_lanes + s17 *
      Lambda_inv_0_8_p73_lanes + 0.282 * Lambda_inv_0_8_p80_lanes - Lambda_inv_0_8_p92_lanes;
  const Lanes<8> Lambda_inv_0_8_p102_lanes = 0.282 * Lambda_inv_0_8_p89_lanes -
      inverse_D8_p150_lanes[1] * Lambda_inv_0_8_p88_lanes;
  const Lanes<8> Lambda_inv_0_8_p103_lanes = -Lambda_inv_0_8_p89_lanes + inverse_D6_p31_lanes[1] *
      Lambda_inv_0_8_p88_lanes;
  const Lanes<8> Lambda_inv_0_8_p104_lanes = Lambda_inv_0_8_p80_lanes - inverse_D6_p33_lanes[1] *
      Lambda_inv_0_8_p88_lanes;
  const Lanes<8> Lambda_inv_0_8_p105_lanes = -(s17 * Lambda_inv_0_8_p77_lanes + c17 *
      Lambda_inv_0_8_p76_lanes) + inverse_D6_p35_lanes[1] * Lambda_inv_0_8_p88_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_0_p320_lanes = Lambda_inv_0_0_p318_lanes * inverse_D2;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p115_lanes = c16 * Lambda_inv_0_8_p101_lanes - s16 *
      Lambda_inv_0_8_p102_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_0_p323_lanes = 0.434 *
      (Lambda_inv_0_0_p315_lanes - inverse_D1_p2 * Lambda_inv_0_0_p318_lanes);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_8_p120_lanes = Lambda_inv_0_0_p5_lanes[1] * Lambda_inv_0_8_p115_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_0_p325_lanes = Lambda_inv_0_0_p323_lanes * inverse_D1;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_8_p124_lanes = s16 * Lambda_inv_0_8_p101_lanes + c16 *
      Lambda_inv_0_8_p102_lanes - inverse_D7_p8_lanes[1] * Lambda_inv_0_8_p115_lanes;
  const Lanes<8> Lambda_inv_0_8_p126_lanes = s16 * Lambda_inv_0_8_p103_lanes + c16 *
      Lambda_inv_0_8_p104_lanes - inverse_D6_p163_lanes[1] * Lambda_inv_0_8_p115_lanes;
  const Lanes<8> Lambda_inv_0_8_p127_lanes = -Lambda_inv_0_8_p105_lanes + inverse_D6_p161_lanes[1] *
      Lambda_inv_0_8_p115_lanes;
  const Lanes<8> Lambda_inv_0_8_p136_lanes = s15 * Lambda_inv_0_8_p120_lanes + c15 *
      Lambda_inv_0_8_p124_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p140_lanes = inverse_D6_p294_lanes[1] * Lambda_inv_0_8_p136_lanes;
  const Lanes<8> Lambda_inv_0_8_p144_lanes = Lambda_inv_0_0_p93_lanes[1] *
      Lambda_inv_0_8_p136_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_1_1_p9_lanes = Lambda_inv_0_0_p185_lanes * Lambda_inv_0_0_p108_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_0_lanes = Lambda_inv_0_0_p313_lanes + Lambda_inv_0_0_p320_lanes *
      Lambda_inv_0_0_p318_lanes[0] + Lambda_inv_0_0_p325_lanes * Lambda_inv_0_0_p323_lanes[0];
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

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p145_lanes = c16 * Lambda_inv_0_8_p103_lanes - s16 *
      Lambda_inv_0_8_p104_lanes - inverse_D6_p165_lanes[1] * Lambda_inv_0_8_p115_lanes -
      Lambda_inv_0_8_p140_lanes;
  const Lanes<8> Lambda_inv_0_8_p146_lanes = c15 * Lambda_inv_0_8_p127_lanes - s15 *
      Lambda_inv_0_8_p126_lanes - inverse_D6_p292_lanes[1] * Lambda_inv_0_8_p136_lanes;
  const Lanes<8> Lambda_inv_0_8_p147_lanes = c15 * Lambda_inv_0_8_p120_lanes - s15 *
      Lambda_inv_0_8_p124_lanes - inverse_D6_p332_lanes[1] * Lambda_inv_0_8_p136_lanes;
  const Lanes<8> Lambda_inv_0_8_p148_lanes = s15 * Lambda_inv_0_8_p127_lanes + c15 *
      Lambda_inv_0_8_p126_lanes - inverse_D6_p299_lanes[1] * Lambda_inv_0_8_p136_lanes;
  const Lanes<8> Lambda_inv_0_8_p158_lanes = s14 * Lambda_inv_0_8_p145_lanes + c14 *
      Lambda_inv_0_8_p146_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_1_1_p16_lanes = Lambda_inv_0_0_p191_lanes *
      Lambda_inv_0_0_p54_lanes[1] + Lambda_inv_0_0_p189_lanes * Lambda_inv_0_0_p60_lanes[1] +
      Lambda_inv_0_0_p187_lanes * Lambda_inv_0_0_p80_lanes[1] + Lambda_inv_1_1_p9_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p160_lanes = c14 * Lambda_inv_0_8_p145_lanes - s14 *
      Lambda_inv_0_8_p146_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_2_2_p6_lanes = Lambda_inv_0_0_p185_lanes * Lambda_inv_0_0_p108_lanes[2];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p165_lanes = 0.226 * Lambda_inv_0_8_p148_lanes + (-0.18) *
      Lambda_inv_0_8_p158_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_1_1_p19_lanes = Lambda_inv_1_1_p16_lanes + Lambda_inv_0_0_p186_lanes *
      Lambda_inv_0_0_p128_lanes[1] + Lambda_inv_0_0_p188_lanes * Lambda_inv_0_0_p155_lanes[1] +
      Lambda_inv_0_0_p190_lanes * Lambda_inv_0_0_p176_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p168_lanes = -(c14 * Lambda_inv_0_8_p144_lanes + s14 *
      Lambda_inv_0_8_p147_lanes + Lambda_inv_0_8_p165_lanes);
  const Lanes<8> Lambda_inv_0_8_p169_lanes = inverse_D5_p73 * Lambda_inv_0_8_p168_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_2_2_p16_lanes = Lambda_inv_0_0_p191_lanes *
      Lambda_inv_0_0_p54_lanes[2] + Lambda_inv_0_0_p189_lanes * Lambda_inv_0_0_p60_lanes[2] +
      Lambda_inv_0_0_p187_lanes * Lambda_inv_0_0_p80_lanes[2] + Lambda_inv_2_2_p6_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p174_lanes = Lambda_inv_0_8_p168_lanes * inverse_D6;
  const Lanes<8> Lambda_inv_1_1_p20_lanes = Lambda_inv_1_1_p19_lanes + Lambda_inv_0_0_p233_lanes *
      Lambda_inv_0_0_p227_lanes[1];
  const Lanes<8> Lambda_inv_0_8_p175_lanes = (-0.18) * Lambda_inv_0_8_p160_lanes -
      (s14 * Lambda_inv_0_8_p144_lanes - c14 * Lambda_inv_0_8_p147_lanes) -
      Lambda_inv_0_8_p169_lanes;
  const Lanes<8> Lambda_inv_0_8_p176_lanes = 0.226 * Lambda_inv_0_8_p160_lanes - inverse_D5_p72 *
      Lambda_inv_0_8_p168_lanes;
  const Lanes<8> Lambda_inv_0_8_p177_lanes = Lambda_inv_0_8_p160_lanes - inverse_D5_p71 *
      Lambda_inv_0_8_p168_lanes;
  const Lanes<8> Lambda_inv_0_8_p178_lanes = Lambda_inv_0_8_p158_lanes + inverse_D3_p14 *
      Lambda_inv_0_8_p168_lanes;
  const Lanes<8> Lambda_inv_0_8_p179_lanes = Lambda_inv_0_8_p148_lanes - inverse_D3_p15 *
      Lambda_inv_0_8_p168_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_3_3_p10_lanes = Lambda_inv_0_0_p185_lanes *
      Lambda_inv_0_0_p108_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p192_lanes = s6 * Lambda_inv_0_8_p178_lanes + c6 *
      Lambda_inv_0_8_p179_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_2_2_p19_lanes = Lambda_inv_2_2_p16_lanes + Lambda_inv_0_0_p186_lanes *
      Lambda_inv_0_0_p128_lanes[2] + Lambda_inv_0_0_p188_lanes * Lambda_inv_0_0_p155_lanes[2] +
      Lambda_inv_0_0_p190_lanes * Lambda_inv_0_0_p176_lanes[2];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_6_8_p1_lanes = Lambda_inv_0_8_p136_lanes * inverse_D7_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p194_lanes = s6 * Lambda_inv_0_8_p175_lanes + c6 *
      Lambda_inv_0_8_p176_lanes + 0.072 * Lambda_inv_0_8_p177_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_6_8_p2_lanes = Lambda_inv_0_8_p115_lanes * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p3_lanes = Lambda_inv_0_8_p88_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p4_lanes = Lambda_inv_0_8_p68_lanes * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_6_8_p5_lanes = Lambda_inv_0_8_p41_lanes * inverse_D11_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_3_3_p16_lanes = Lambda_inv_0_0_p191_lanes *
      Lambda_inv_0_0_p50_lanes[0] + Lambda_inv_0_0_p189_lanes * Lambda_inv_0_0_p60_lanes[3] +
      Lambda_inv_0_0_p187_lanes * Lambda_inv_0_0_p80_lanes[3] + Lambda_inv_3_3_p10_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_6_8_p6_lanes = Lambda_inv_0_8_p24_lanes * inverse_D12_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_2_2_p20_lanes = Lambda_inv_2_2_p19_lanes + Lambda_inv_0_0_p233_lanes *
      Lambda_inv_0_0_p227_lanes[2];

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_inv_4_5_p5_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p186_lanes[5],
      Lambda_inv_6_8_p3_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p128_lanes[4],
      Lambda_inv_0_8_p88_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p5_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p186_lanes[4],
      Lambda_inv_6_8_p3_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p128_lanes[4],
      Lambda_inv_0_8_p88_lanes[2]);

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_inv_4_5_p6_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p188_lanes[5],
      Lambda_inv_6_8_p2_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p155_lanes[4],
      Lambda_inv_0_8_p115_lanes[2]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_4_5_p7_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p187_lanes[5],
      Lambda_inv_6_8_p5_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p80_lanes[4],
      Lambda_inv_0_8_p41_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p6_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p187_lanes[4],
      Lambda_inv_6_8_p5_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p80_lanes[4],
      Lambda_inv_0_8_p41_lanes[2]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_4_5_p8_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p185_lanes[5],
      Lambda_inv_6_8_p4_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p108_lanes[4],
      Lambda_inv_0_8_p68_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p7_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p185_lanes[4],
      Lambda_inv_6_8_p4_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p108_lanes[4],
      Lambda_inv_0_8_p68_lanes[2]);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_inv_4_5_p9_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p189_lanes[5],
      Lambda_inv_6_8_p6_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p60_lanes[4],
      Lambda_inv_0_8_p24_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p8_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p189_lanes[4],
      Lambda_inv_6_8_p6_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p60_lanes[4],
      Lambda_inv_0_8_p24_lanes[2]);

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_inv_4_4_p9_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p188_lanes[4],
      Lambda_inv_6_8_p2_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p155_lanes[4],
      Lambda_inv_0_8_p115_lanes[2]);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p202_lanes = c6 * Lambda_inv_0_8_p178_lanes - s6 *
      Lambda_inv_0_8_p179_lanes - inverse_D3_p35 * Lambda_inv_0_8_p194_lanes;
  const Lanes<8> Lambda_inv_0_8_p203_lanes = Lambda_inv_0_8_p177_lanes - inverse_D3_p34 *
      Lambda_inv_0_8_p194_lanes;
  const Lanes<8> Lambda_inv_0_8_p204_lanes = c6 * Lambda_inv_0_8_p175_lanes - s6 *
      Lambda_inv_0_8_p176_lanes - inverse_D4_p11 * Lambda_inv_0_8_p194_lanes;
  const Lanes<8> Lambda_inv_0_8_p205_lanes = -(0.072 * Lambda_inv_0_8_p192_lanes) + inverse_D4_p10 *
      Lambda_inv_0_8_p194_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_inv_4_5_p10_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p190_lanes[5],
      Lambda_inv_6_8_p1_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[4],
      Lambda_inv_0_8_p136_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p10_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p190_lanes[4],
      Lambda_inv_6_8_p1_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[4],
      Lambda_inv_0_8_p136_lanes[2]);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p207_lanes = Lambda_inv_0_8_p194_lanes * inverse_D5;
  const Lanes<8> Lambda_inv_0_8_p212_lanes = s4 * (Lambda_inv_0_8_p192_lanes - inverse_D3_p36 *
      Lambda_inv_0_8_p194_lanes);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_5_5_p2_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p185_lanes[5],
      Lambda_inv_6_8_p4_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p108_lanes[5],
      Lambda_inv_0_8_p68_lanes[3]);

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_6_8_p7_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_inv_0_8_p21, Lambda_inv_0_6_p20, Lambda_inv_0_7_p23,
      Lambda_inv_0_8_p20, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_3_3_p19_lanes = Lambda_inv_3_3_p16_lanes + Lambda_inv_0_0_p186_lanes *
      Lambda_inv_0_0_p128_lanes[3] + Lambda_inv_0_0_p188_lanes * Lambda_inv_0_0_p155_lanes[3] +
      Lambda_inv_0_0_p190_lanes * Lambda_inv_0_0_p176_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p224_lanes = -(s5 * Lambda_inv_0_8_p205_lanes + c5 *
      Lambda_inv_0_8_p204_lanes);
  const Lanes<8> Lambda_inv_0_8_p229_lanes = Lambda_inv_0_8_p224_lanes * inverse_D4;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_7_p1 = Lambda_inv_0_7_p49 * inverse_D7_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p230_lanes = c4 * (s5 * Lambda_inv_0_8_p202_lanes - c5 *
      Lambda_inv_0_8_p203_lanes) + Lambda_inv_0_8_p212_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_7_p2 = Lambda_inv_0_7_p46 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_7_p3 = Lambda_inv_0_7_p42 * inverse_D9_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p231_lanes = -(s5 * Lambda_inv_0_8_p203_lanes + c5 *
      Lambda_inv_0_8_p202_lanes) - inverse_D2_p6 * Lambda_inv_0_8_p224_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_7_p4 = Lambda_inv_0_7_p36 * inverse_D10_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_6_7_p5 = 1065.380700001509 * Lambda_inv_0_7_p24;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_6_7_p6 = Lambda_inv_0_7_p25 * inverse_D12_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_3_3_p20_lanes = Lambda_inv_3_3_p19_lanes + Lambda_inv_0_0_p233_lanes *
      Lambda_inv_0_0_p227_lanes[3];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_6_7_p7 = Lambda_inv_0_7_p31 * inverse_D11_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p236_lanes = s4 * (s5 * Lambda_inv_0_8_p204_lanes - c5 *
      Lambda_inv_0_8_p205_lanes) + 0.21799999999999997 * Lambda_inv_0_8_p230_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_5_5_p11_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p191_lanes[5],
      Lambda_inv_6_8_p7_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p50_lanes[2],
      Lambda_inv_0_8_p20) + detail::make_pack<Real>(Lambda_inv_0_0_p189_lanes[5],
      Lambda_inv_6_8_p6_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p60_lanes[5],
      Lambda_inv_0_8_p24_lanes[3]) + detail::make_pack<Real>(Lambda_inv_0_0_p187_lanes[5],
      Lambda_inv_6_8_p5_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p80_lanes[5],
      Lambda_inv_0_8_p41_lanes[3]) + Lambda_inv_5_5_p2_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_4_4_p16_lanes = Lambda_inv_0_0_p191_lanes *
      Lambda_inv_0_0_p50_lanes[1] + detail::make_pack<Real>(Lambda_inv_4_4_p8_lanes[0],
      Lambda_inv_4_4_p8_lanes[0], Lambda_inv_4_4_p8_lanes[0], Lambda_inv_4_4_p8_lanes[0],
      Lambda_inv_4_4_p8_lanes[0], Lambda_inv_4_5_p9_lanes[0], Lambda_inv_4_4_p8_lanes[0],
      Lambda_inv_4_4_p8_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p6_lanes[0],
      Lambda_inv_4_4_p6_lanes[0], Lambda_inv_4_4_p6_lanes[0], Lambda_inv_4_4_p6_lanes[0],
      Lambda_inv_4_4_p6_lanes[0], Lambda_inv_4_5_p7_lanes[0], Lambda_inv_4_4_p6_lanes[0],
      Lambda_inv_4_4_p6_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_5_p8_lanes[0], Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p5_lanes[0],
      Lambda_inv_4_4_p5_lanes[0], Lambda_inv_4_4_p5_lanes[0], Lambda_inv_4_4_p5_lanes[0],
      Lambda_inv_4_4_p5_lanes[0], Lambda_inv_4_5_p5_lanes[0], Lambda_inv_4_4_p5_lanes[0],
      Lambda_inv_4_4_p5_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p9_lanes[0],
      Lambda_inv_4_4_p9_lanes[0], Lambda_inv_4_4_p9_lanes[0], Lambda_inv_4_4_p9_lanes[0],
      Lambda_inv_4_4_p9_lanes[0], Lambda_inv_4_5_p6_lanes[0], Lambda_inv_4_4_p9_lanes[0],
      Lambda_inv_4_4_p9_lanes[0]);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p239_lanes = -Lambda_inv_0_8_p236_lanes - inverse_D3_p60 *
      Lambda_inv_0_8_p224_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p12_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_6_p33;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_4_4_p18_lanes = Lambda_inv_4_4_p16_lanes +
      detail::make_pack<Real>(Lambda_inv_4_4_p10_lanes[0], Lambda_inv_4_4_p10_lanes[0],
      Lambda_inv_4_4_p10_lanes[0], Lambda_inv_4_4_p10_lanes[0], Lambda_inv_4_4_p10_lanes[0],
      Lambda_inv_4_5_p10_lanes[0], Lambda_inv_4_4_p10_lanes[0], Lambda_inv_4_4_p10_lanes[0]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p233_lanes[4] * Lambda_inv_0_0_p227_lanes[4],
      Lambda_inv_0_0_p233_lanes[4] * Lambda_inv_0_0_p227_lanes[4], Lambda_inv_0_0_p233_lanes[4] *
      Lambda_inv_0_0_p227_lanes[4], Lambda_inv_0_0_p233_lanes[4] * Lambda_inv_0_0_p227_lanes[4],
      Lambda_inv_0_0_p233_lanes[4] * Lambda_inv_0_0_p227_lanes[4], Lambda_inv_0_0_p233_lanes[5] *
      Lambda_inv_0_0_p227_lanes[4], Lambda_inv_0_0_p233_lanes[4] * Lambda_inv_0_0_p227_lanes[4],
      Lambda_inv_0_0_p233_lanes[4] * Lambda_inv_0_0_p227_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p242_lanes = Lambda_inv_0_8_p239_lanes * inverse_D3;
  const Lanes<8> Lambda_inv_0_8_p243_lanes = -Lambda_inv_0_8_p230_lanes - inverse_D2_p7 *
      Lambda_inv_0_8_p224_lanes - inverse_D2_p12 * Lambda_inv_0_8_p239_lanes;
  const Lanes<8> Lambda_inv_0_8_p244_lanes = -Lambda_inv_0_8_p231_lanes + inverse_D2_p11 *
      Lambda_inv_0_8_p239_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_inv_5_5_p15_lanes = Lambda_inv_5_5_p11_lanes +
      detail::make_pack<Real>(Lambda_inv_0_0_p186_lanes[5], Lambda_inv_6_8_p3_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p128_lanes[5], Lambda_inv_0_8_p88_lanes[3]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p188_lanes[5], Lambda_inv_6_8_p2_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p155_lanes[5], Lambda_inv_0_8_p115_lanes[3]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p190_lanes[5], Lambda_inv_6_8_p1_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p176_lanes[5], Lambda_inv_0_8_p136_lanes[3]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p251_lanes = Lambda_inv_0_0_p2 * Lambda_inv_0_8_p243_lanes -
      Lambda_inv_0_0_p1 * Lambda_inv_0_8_p244_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p20_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_6_p21 +
      Lambda_inv_6_8_p6_lanes * Lambda_inv_0_6_p22 + Lambda_inv_6_8_p5_lanes * Lambda_inv_0_6_p28 +
      Lambda_inv_6_8_p12_lanes;
  const Lanes<8> Lambda_inv_7_8_p4_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_7_p36;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_6_6_p6_lanes = detail::make_pack<Real>(1065.380700001509 *
      Lambda_inv_0_6_p21, 1065.380700001509 * Lambda_inv_0_6_p21, 1065.380700001509 *
      Lambda_inv_0_6_p21, 1065.380700001509 * Lambda_inv_0_6_p21, 1065.380700001509 *
      Lambda_inv_0_6_p21, 1065.380700001509 * Lambda_inv_0_6_p21, 1065.380700001509 *
      Lambda_inv_0_6_p21, Lambda_inv_6_7_p5) * Lambda_inv_0_6_p21 +
      detail::make_pack<Real>(Lambda_inv_0_6_p22 * inverse_D12_lanes[1] * Lambda_inv_0_6_p22,
      Lambda_inv_0_6_p22 * inverse_D12_lanes[1] * Lambda_inv_0_6_p22, Lambda_inv_0_6_p22 *
      inverse_D12_lanes[1] * Lambda_inv_0_6_p22, Lambda_inv_0_6_p22 * inverse_D12_lanes[1] *
      Lambda_inv_0_6_p22, Lambda_inv_0_6_p22 * inverse_D12_lanes[1] * Lambda_inv_0_6_p22,
      Lambda_inv_0_6_p22 * inverse_D12_lanes[1] * Lambda_inv_0_6_p22, Lambda_inv_0_6_p22 *
      inverse_D12_lanes[1] * Lambda_inv_0_6_p22, Lambda_inv_6_7_p6 * Lambda_inv_0_6_p22) +
      detail::make_pack<Real>(Lambda_inv_0_6_p28 * inverse_D11_lanes[1] * Lambda_inv_0_6_p28,
      Lambda_inv_0_6_p28 * inverse_D11_lanes[1] * Lambda_inv_0_6_p28, Lambda_inv_0_6_p28 *
      inverse_D11_lanes[1] * Lambda_inv_0_6_p28, Lambda_inv_0_6_p28 * inverse_D11_lanes[1] *
      Lambda_inv_0_6_p28, Lambda_inv_0_6_p28 * inverse_D11_lanes[1] * Lambda_inv_0_6_p28,
      Lambda_inv_0_6_p28 * inverse_D11_lanes[1] * Lambda_inv_0_6_p28, Lambda_inv_0_6_p28 *
      inverse_D11_lanes[1] * Lambda_inv_0_6_p28, Lambda_inv_6_7_p7 * Lambda_inv_0_6_p28) +
      detail::make_pack<Real>(Lambda_inv_0_6_p33 * inverse_D10_lanes[1] * Lambda_inv_0_6_p33,
      Lambda_inv_0_6_p33 * inverse_D10_lanes[1] * Lambda_inv_0_6_p33, Lambda_inv_0_6_p33 *
      inverse_D10_lanes[1] * Lambda_inv_0_6_p33, Lambda_inv_0_6_p33 * inverse_D10_lanes[1] *
      Lambda_inv_0_6_p33, Lambda_inv_0_6_p33 * inverse_D10_lanes[1] * Lambda_inv_0_6_p33,
      Lambda_inv_0_6_p33 * inverse_D10_lanes[1] * Lambda_inv_0_6_p33, Lambda_inv_0_6_p33 *
      inverse_D10_lanes[1] * Lambda_inv_0_6_p33, Lambda_inv_6_7_p4 * Lambda_inv_0_6_p33) +
      detail::make_pack<Real>(Lambda_inv_0_6_p39 * inverse_D9_lanes[1] * Lambda_inv_0_6_p39,
      Lambda_inv_0_6_p39 * inverse_D9_lanes[1] * Lambda_inv_0_6_p39, Lambda_inv_0_6_p39 *
      inverse_D9_lanes[1] * Lambda_inv_0_6_p39, Lambda_inv_0_6_p39 * inverse_D9_lanes[1] *
      Lambda_inv_0_6_p39, Lambda_inv_0_6_p39 * inverse_D9_lanes[1] * Lambda_inv_0_6_p39,
      Lambda_inv_0_6_p39 * inverse_D9_lanes[1] * Lambda_inv_0_6_p39, Lambda_inv_0_6_p39 *
      inverse_D9_lanes[1] * Lambda_inv_0_6_p39, Lambda_inv_6_7_p3 * Lambda_inv_0_6_p39) +
      detail::make_pack<Real>(Lambda_inv_0_6_p45 * inverse_D8_lanes[1] * Lambda_inv_0_6_p45,
      Lambda_inv_0_6_p45 * inverse_D8_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 *
      inverse_D8_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 * inverse_D8_lanes[1] *
      Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 * inverse_D8_lanes[1] * Lambda_inv_0_6_p45,
      Lambda_inv_0_6_p45 * inverse_D8_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 *
      inverse_D8_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_6_7_p2 * Lambda_inv_0_6_p45);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_8_8_p6_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_8_p68_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_7_7_p1 = Lambda_inv_6_7_p5 * Lambda_inv_0_7_p24 + Lambda_inv_6_7_p6 *
      Lambda_inv_0_7_p25 + Lambda_inv_6_7_p7 * Lambda_inv_0_7_p31 + Lambda_inv_6_7_p4 *
      Lambda_inv_0_7_p36 + Lambda_inv_6_7_p3 * Lambda_inv_0_7_p42;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p254_lanes = inverse_D2_p2 *
      (Lambda_inv_0_0_p1 * Lambda_inv_0_8_p243_lanes + Lambda_inv_0_0_p2 *
      Lambda_inv_0_8_p244_lanes) + inverse_D2_p1 * Lambda_inv_0_8_p251_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_6_8_p23_lanes = Lambda_inv_6_8_p20_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_6_p39 + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_6_p45 + Lambda_inv_6_8_p1_lanes *
      Lambda_inv_0_6_p51;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p255_lanes = Lambda_inv_0_8_p242_lanes *
      Lambda_inv_0_0_p302_lanes[0];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_7_8_p13_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_7_p24 +
      Lambda_inv_6_8_p6_lanes * Lambda_inv_0_7_p25 + Lambda_inv_6_8_p5_lanes * Lambda_inv_0_7_p31 +
      Lambda_inv_7_8_p4_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_8_p257_lanes = Lambda_inv_0_8_p254_lanes * inverse_D2;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_9_9_p6_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_8_p68_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_1_8_p5_lanes = Lambda_inv_0_8_p242_lanes * Lambda_inv_0_0_p302_lanes[1];
  const Lanes<8> Lambda_inv_2_8_p5_lanes = Lambda_inv_0_8_p242_lanes * Lambda_inv_0_0_p302_lanes[2];
  const Lanes<8> Lambda_inv_3_8_p5_lanes = Lambda_inv_0_8_p242_lanes * Lambda_inv_0_0_p302_lanes[3];
  const Lanes<8> Lambda_inv_4_8_p5_lanes = Lambda_inv_0_8_p242_lanes * Lambda_inv_0_0_p302_lanes[4];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_8_8_p13_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_8_p21 +
      Lambda_inv_6_8_p6_lanes * Lambda_inv_0_8_p24_lanes[0] + Lambda_inv_6_8_p5_lanes *
      Lambda_inv_0_8_p41_lanes[0] + Lambda_inv_8_8_p6_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_8_p259_lanes = 0.434 *
      (Lambda_inv_0_8_p251_lanes - inverse_D1_p2 * Lambda_inv_0_8_p254_lanes);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_7_8_p16_lanes = Lambda_inv_7_8_p13_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_7_p42 + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_7_p46 + Lambda_inv_6_8_p1_lanes *
      Lambda_inv_0_7_p49;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_7_7_p2 = Lambda_inv_7_7_p1 + Lambda_inv_6_7_p2 * Lambda_inv_0_7_p46 +
      Lambda_inv_6_7_p1 * Lambda_inv_0_7_p49 + Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[7] +
      Lambda_inv_0_0_p262_lanes[7] * Lambda_inv_0_0_p255_lanes[7];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_5_8_p5_lanes = Lambda_inv_0_8_p242_lanes * Lambda_inv_0_0_p302_lanes[5];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_9_9_p13_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_6_p20 +
      Lambda_inv_6_8_p6_lanes * Lambda_inv_0_8_p24_lanes[1] + Lambda_inv_6_8_p5_lanes *
      Lambda_inv_0_8_p41_lanes[1] + Lambda_inv_9_9_p6_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_8_8_p17_lanes = Lambda_inv_8_8_p13_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_8_p88_lanes[0] + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_8_p115_lanes[0] +
      Lambda_inv_6_8_p1_lanes * Lambda_inv_0_8_p136_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_6_8_p27_lanes = Lambda_inv_6_8_p23_lanes + Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[6] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[6] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[6];
  const Lanes<8> Lambda_inv_7_8_p20_lanes = Lambda_inv_7_8_p16_lanes + Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[7] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[7] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_8_p261_lanes = Lambda_inv_0_8_p259_lanes * inverse_D1;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_9_9_p17_lanes = Lambda_inv_9_9_p13_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_8_p88_lanes[1] + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_8_p115_lanes[1] +
      Lambda_inv_6_8_p1_lanes * Lambda_inv_0_8_p136_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_10_10_p18_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_7_p23 +
      detail::make_pack<Real>(Lambda_inv_4_4_p8_lanes[1], Lambda_inv_4_4_p8_lanes[1],
      Lambda_inv_4_4_p8_lanes[1], Lambda_inv_4_5_p9_lanes[1], Lambda_inv_4_4_p8_lanes[1],
      Lambda_inv_4_4_p8_lanes[1], Lambda_inv_4_4_p8_lanes[1], Lambda_inv_4_4_p8_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_4_p6_lanes[1],
      Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_5_p7_lanes[1], Lambda_inv_4_4_p6_lanes[1],
      Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_4_p6_lanes[1], Lambda_inv_4_4_p6_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1],
      Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_5_p8_lanes[1], Lambda_inv_4_4_p7_lanes[1],
      Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1],
      Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_5_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1],
      Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1], Lambda_inv_4_4_p5_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_4_p9_lanes[1],
      Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_5_p6_lanes[1], Lambda_inv_4_4_p9_lanes[1],
      Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_4_p9_lanes[1]);

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_8_8_p20_lanes = Lambda_inv_8_8_p17_lanes + Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_8_p168_lanes[0] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_8_p194_lanes[0] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_8_p224_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p263_lanes = Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[0] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[0] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[0] + Lambda_inv_0_8_p255_lanes;
  const Lanes<8> Lambda_inv_1_1_p23_lanes = detail::make_pack<Real>(Lambda_inv_1_1_p20_lanes[1],
      Lambda_inv_1_1_p20_lanes[1], Lambda_inv_1_1_p20_lanes[2], Lambda_inv_1_1_p20_lanes[3],
      Lambda_inv_1_1_p20_lanes[4], Lambda_inv_1_1_p20_lanes[5], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[1], Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[1]) +
      Lambda_inv_0_0_p262_lanes * Lambda_inv_0_0_p255_lanes[1] + Lambda_inv_0_0_p290_lanes *
      Lambda_inv_0_0_p285_lanes[1] + Lambda_inv_0_0_p305_lanes * Lambda_inv_0_0_p302_lanes[1];
  const Lanes<8> Lambda_inv_1_8_p8_lanes = Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[1] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[1] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[1] + Lambda_inv_1_8_p5_lanes;
  const Lanes<8> Lambda_inv_2_2_p23_lanes = detail::make_pack<Real>(Lambda_inv_2_2_p20_lanes[2],
      Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[3],
      Lambda_inv_2_2_p20_lanes[4], Lambda_inv_2_2_p20_lanes[5], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[2], Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[2]) +
      Lambda_inv_0_0_p262_lanes * Lambda_inv_0_0_p255_lanes[2] + Lambda_inv_0_0_p290_lanes *
      Lambda_inv_0_0_p285_lanes[2] + Lambda_inv_0_0_p305_lanes * Lambda_inv_0_0_p302_lanes[2];
  const Lanes<8> Lambda_inv_2_8_p8_lanes = Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[2] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[2] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[2] + Lambda_inv_2_8_p5_lanes;
  const Lanes<8> Lambda_inv_3_3_p23_lanes = detail::make_pack<Real>(Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[4], Lambda_inv_3_3_p20_lanes[5], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[3], Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[3]) +
      Lambda_inv_0_0_p262_lanes * Lambda_inv_0_0_p255_lanes[3] + Lambda_inv_0_0_p290_lanes *
      Lambda_inv_0_0_p285_lanes[3] + Lambda_inv_0_0_p305_lanes * Lambda_inv_0_0_p302_lanes[3];
  const Lanes<8> Lambda_inv_3_8_p8_lanes = Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[3] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[3] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[3] + Lambda_inv_3_8_p5_lanes;
  const Lanes<8> Lambda_inv_4_4_p22_lanes = detail::make_pack<Real>(Lambda_inv_4_4_p18_lanes[4],
      Lambda_inv_4_4_p18_lanes[4], Lambda_inv_4_4_p18_lanes[4], Lambda_inv_4_4_p18_lanes[4],
      Lambda_inv_4_4_p18_lanes[4], Lambda_inv_4_4_p18_lanes[5], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[4], Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[4]) +
      Lambda_inv_0_0_p262_lanes * Lambda_inv_0_0_p255_lanes[4] + Lambda_inv_0_0_p290_lanes *
      Lambda_inv_0_0_p285_lanes[4] + Lambda_inv_0_0_p305_lanes * Lambda_inv_0_0_p302_lanes[4];
  const Lanes<8> Lambda_inv_4_8_p8_lanes = Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[4] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[4] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[4] + Lambda_inv_4_8_p5_lanes;
  const Lanes<8> Lambda_inv_5_5_p20_lanes = detail::make_pack<Real>(Lambda_inv_5_5_p15_lanes[0] +
      Lambda_inv_0_0_p233_lanes[5] * Lambda_inv_0_0_p227_lanes[5], Lambda_inv_5_5_p15_lanes[0] +
      Lambda_inv_0_0_p233_lanes[5] * Lambda_inv_0_0_p227_lanes[5], Lambda_inv_5_5_p15_lanes[0] +
      Lambda_inv_0_0_p233_lanes[5] * Lambda_inv_0_0_p227_lanes[5], Lambda_inv_5_5_p15_lanes[0] +
      Lambda_inv_0_0_p233_lanes[5] * Lambda_inv_0_0_p227_lanes[5], Lambda_inv_5_5_p15_lanes[0] +
      Lambda_inv_0_0_p233_lanes[5] * Lambda_inv_0_0_p227_lanes[5], Lambda_inv_5_5_p15_lanes[0] +
      Lambda_inv_0_0_p233_lanes[5] * Lambda_inv_0_0_p227_lanes[5], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[5], Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[5]) +
      Lambda_inv_0_0_p262_lanes * Lambda_inv_0_0_p255_lanes[5] + Lambda_inv_0_0_p290_lanes *
      Lambda_inv_0_0_p285_lanes[5] + Lambda_inv_0_0_p305_lanes * Lambda_inv_0_0_p302_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_9_9_p21_lanes = Lambda_inv_9_9_p17_lanes + Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_8_p168_lanes[1] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_8_p194_lanes[1] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_8_p224_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_5_8_p8_lanes = Lambda_inv_0_8_p174_lanes *
      Lambda_inv_0_0_p227_lanes[5] + Lambda_inv_0_8_p207_lanes * Lambda_inv_0_0_p255_lanes[5] +
      Lambda_inv_0_8_p229_lanes * Lambda_inv_0_0_p285_lanes[5] + Lambda_inv_5_8_p5_lanes;
  const Real Lambda_inv_11_11_p15 = Lambda_inv_5_5_p15_lanes[1] + Lambda_inv_0_8_p174_lanes[3] *
      Lambda_inv_0_8_p168_lanes[3] + Lambda_inv_0_8_p207_lanes[3] * Lambda_inv_0_8_p194_lanes[3] +
      Lambda_inv_0_8_p229_lanes[3] * Lambda_inv_0_8_p224_lanes[3] + Lambda_inv_0_8_p242_lanes[3] *
      Lambda_inv_0_8_p239_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_6_6_p12_lanes = Lambda_inv_6_6_p6_lanes +
      detail::make_pack<Real>(Lambda_inv_0_6_p51 * inverse_D7_lanes[1] * Lambda_inv_0_6_p51,
      Lambda_inv_0_6_p51 * inverse_D7_lanes[1] * Lambda_inv_0_6_p51, Lambda_inv_0_6_p51 *
      inverse_D7_lanes[1] * Lambda_inv_0_6_p51, Lambda_inv_0_6_p51 * inverse_D7_lanes[1] *
      Lambda_inv_0_6_p51, Lambda_inv_0_6_p51 * inverse_D7_lanes[1] * Lambda_inv_0_6_p51,
      Lambda_inv_0_6_p51 * inverse_D7_lanes[1] * Lambda_inv_0_6_p51, Lambda_inv_0_6_p51 *
      inverse_D7_lanes[1] * Lambda_inv_0_6_p51, Lambda_inv_6_7_p1 * Lambda_inv_0_6_p51) +
      detail::make_pack<Real>(Lambda_inv_0_6_p86 * Lambda_inv_0_0_p227_lanes[6],
      Lambda_inv_0_6_p86 * Lambda_inv_0_0_p227_lanes[6], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[6], Lambda_inv_0_6_p86 * Lambda_inv_0_0_p227_lanes[6],
      Lambda_inv_0_6_p86 * Lambda_inv_0_0_p227_lanes[6], Lambda_inv_0_6_p86 *
      Lambda_inv_0_0_p227_lanes[6], Lambda_inv_0_6_p86 * Lambda_inv_0_0_p227_lanes[6],
      Lambda_inv_0_7_p88 * Lambda_inv_0_0_p227_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p262_lanes[6] * Lambda_inv_0_0_p255_lanes[6],
      Lambda_inv_0_0_p262_lanes[6] * Lambda_inv_0_0_p255_lanes[6], Lambda_inv_0_0_p262_lanes[6] *
      Lambda_inv_0_0_p255_lanes[6], Lambda_inv_0_0_p262_lanes[6] * Lambda_inv_0_0_p255_lanes[6],
      Lambda_inv_0_0_p262_lanes[6] * Lambda_inv_0_0_p255_lanes[6], Lambda_inv_0_0_p262_lanes[6] *
      Lambda_inv_0_0_p255_lanes[6], Lambda_inv_0_0_p262_lanes[6] * Lambda_inv_0_0_p255_lanes[6],
      Lambda_inv_0_0_p262_lanes[7] * Lambda_inv_0_0_p255_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p290_lanes[6] * Lambda_inv_0_0_p285_lanes[6],
      Lambda_inv_0_0_p290_lanes[6] * Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p290_lanes[6] *
      Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p290_lanes[6] * Lambda_inv_0_0_p285_lanes[6],
      Lambda_inv_0_0_p290_lanes[6] * Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p290_lanes[6] *
      Lambda_inv_0_0_p285_lanes[6], Lambda_inv_0_0_p290_lanes[6] * Lambda_inv_0_0_p285_lanes[6],
      Lambda_inv_0_0_p290_lanes[7] * Lambda_inv_0_0_p285_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p305_lanes[6] * Lambda_inv_0_0_p302_lanes[6],
      Lambda_inv_0_0_p305_lanes[6] * Lambda_inv_0_0_p302_lanes[6], Lambda_inv_0_0_p305_lanes[6] *
      Lambda_inv_0_0_p302_lanes[6], Lambda_inv_0_0_p305_lanes[6] * Lambda_inv_0_0_p302_lanes[6],
      Lambda_inv_0_0_p305_lanes[6] * Lambda_inv_0_0_p302_lanes[6], Lambda_inv_0_0_p305_lanes[6] *
      Lambda_inv_0_0_p302_lanes[6], Lambda_inv_0_0_p305_lanes[6] * Lambda_inv_0_0_p302_lanes[6],
      Lambda_inv_0_0_p305_lanes[7] * Lambda_inv_0_0_p302_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p320_lanes[6] * Lambda_inv_0_0_p318_lanes[6],
      Lambda_inv_0_0_p320_lanes[6] * Lambda_inv_0_0_p318_lanes[6], Lambda_inv_0_0_p320_lanes[6] *
      Lambda_inv_0_0_p318_lanes[6], Lambda_inv_0_0_p320_lanes[6] * Lambda_inv_0_0_p318_lanes[6],
      Lambda_inv_0_0_p320_lanes[6] * Lambda_inv_0_0_p318_lanes[6], Lambda_inv_0_0_p320_lanes[6] *
      Lambda_inv_0_0_p318_lanes[6], Lambda_inv_0_0_p320_lanes[6] * Lambda_inv_0_0_p318_lanes[6],
      Lambda_inv_0_0_p320_lanes[7] * Lambda_inv_0_0_p318_lanes[6]);
  const Lanes<8> Lambda_inv_10_10_p24_lanes = Lambda_inv_10_10_p18_lanes +
      detail::make_pack<Real>(Lambda_inv_4_4_p10_lanes[1], Lambda_inv_4_4_p10_lanes[1],
      Lambda_inv_4_4_p10_lanes[1], Lambda_inv_4_5_p10_lanes[1], Lambda_inv_4_4_p10_lanes[1],
      Lambda_inv_4_4_p10_lanes[1], Lambda_inv_4_4_p10_lanes[1], Lambda_inv_4_4_p10_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p174_lanes[2] * Lambda_inv_0_8_p168_lanes[2],
      Lambda_inv_0_8_p174_lanes[2] * Lambda_inv_0_8_p168_lanes[2], Lambda_inv_0_8_p174_lanes[2] *
      Lambda_inv_0_8_p168_lanes[2], Lambda_inv_0_8_p174_lanes[3] * Lambda_inv_0_8_p168_lanes[2],
      Lambda_inv_0_8_p174_lanes[2] * Lambda_inv_0_8_p168_lanes[2], Lambda_inv_0_8_p174_lanes[2] *
      Lambda_inv_0_8_p168_lanes[2], Lambda_inv_0_8_p174_lanes[2] * Lambda_inv_0_8_p168_lanes[2],
      Lambda_inv_0_8_p174_lanes[2] * Lambda_inv_0_8_p168_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p207_lanes[2] * Lambda_inv_0_8_p194_lanes[2],
      Lambda_inv_0_8_p207_lanes[2] * Lambda_inv_0_8_p194_lanes[2], Lambda_inv_0_8_p207_lanes[2] *
      Lambda_inv_0_8_p194_lanes[2], Lambda_inv_0_8_p207_lanes[3] * Lambda_inv_0_8_p194_lanes[2],
      Lambda_inv_0_8_p207_lanes[2] * Lambda_inv_0_8_p194_lanes[2], Lambda_inv_0_8_p207_lanes[2] *
      Lambda_inv_0_8_p194_lanes[2], Lambda_inv_0_8_p207_lanes[2] * Lambda_inv_0_8_p194_lanes[2],
      Lambda_inv_0_8_p207_lanes[2] * Lambda_inv_0_8_p194_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p229_lanes[2] * Lambda_inv_0_8_p224_lanes[2],
      Lambda_inv_0_8_p229_lanes[2] * Lambda_inv_0_8_p224_lanes[2], Lambda_inv_0_8_p229_lanes[2] *
      Lambda_inv_0_8_p224_lanes[2], Lambda_inv_0_8_p229_lanes[3] * Lambda_inv_0_8_p224_lanes[2],
      Lambda_inv_0_8_p229_lanes[2] * Lambda_inv_0_8_p224_lanes[2], Lambda_inv_0_8_p229_lanes[2] *
      Lambda_inv_0_8_p224_lanes[2], Lambda_inv_0_8_p229_lanes[2] * Lambda_inv_0_8_p224_lanes[2],
      Lambda_inv_0_8_p229_lanes[2] * Lambda_inv_0_8_p224_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p242_lanes[2] * Lambda_inv_0_8_p239_lanes[2],
      Lambda_inv_0_8_p242_lanes[2] * Lambda_inv_0_8_p239_lanes[2], Lambda_inv_0_8_p242_lanes[2] *
      Lambda_inv_0_8_p239_lanes[2], Lambda_inv_0_8_p242_lanes[3] * Lambda_inv_0_8_p239_lanes[2],
      Lambda_inv_0_8_p242_lanes[2] * Lambda_inv_0_8_p239_lanes[2], Lambda_inv_0_8_p242_lanes[2] *
      Lambda_inv_0_8_p239_lanes[2], Lambda_inv_0_8_p242_lanes[2] * Lambda_inv_0_8_p239_lanes[2],
      Lambda_inv_0_8_p242_lanes[2] * Lambda_inv_0_8_p239_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p257_lanes[2] * Lambda_inv_0_8_p254_lanes[2],
      Lambda_inv_0_8_p257_lanes[2] * Lambda_inv_0_8_p254_lanes[2], Lambda_inv_0_8_p257_lanes[2] *
      Lambda_inv_0_8_p254_lanes[2], Lambda_inv_0_8_p257_lanes[3] * Lambda_inv_0_8_p254_lanes[2],
      Lambda_inv_0_8_p257_lanes[2] * Lambda_inv_0_8_p254_lanes[2], Lambda_inv_0_8_p257_lanes[2] *
      Lambda_inv_0_8_p254_lanes[2], Lambda_inv_0_8_p257_lanes[2] * Lambda_inv_0_8_p254_lanes[2],
      Lambda_inv_0_8_p257_lanes[2] * Lambda_inv_0_8_p254_lanes[2]);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_8_lanes = Lambda_inv_0_8_p263_lanes + Lambda_inv_0_8_p257_lanes *
      Lambda_inv_0_0_p318_lanes[0] + Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[0];
  Lambda_inv[8] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[96] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[9] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[108] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[10] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[120] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[11] = Lambda_inv_0_8_lanes[3];
  Lambda_inv[132] = Lambda_inv_0_8_lanes[3];
  const Lanes<8> Lambda_inv_1_1_lanes = Lambda_inv_1_1_p23_lanes + Lambda_inv_0_0_p320_lanes *
      Lambda_inv_0_0_p318_lanes[1] + Lambda_inv_0_0_p325_lanes * Lambda_inv_0_0_p323_lanes[1];
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
  const Lanes<8> Lambda_inv_1_8_lanes = Lambda_inv_1_8_p8_lanes + Lambda_inv_0_8_p257_lanes *
      Lambda_inv_0_0_p318_lanes[1] + Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[1];
  Lambda_inv[20] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[97] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[21] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[109] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[22] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[121] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[23] = Lambda_inv_1_8_lanes[3];
  Lambda_inv[133] = Lambda_inv_1_8_lanes[3];
  const Lanes<8> Lambda_inv_2_2_lanes = Lambda_inv_2_2_p23_lanes + Lambda_inv_0_0_p320_lanes *
      Lambda_inv_0_0_p318_lanes[2] + Lambda_inv_0_0_p325_lanes * Lambda_inv_0_0_p323_lanes[2];
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
  const Lanes<8> Lambda_inv_2_8_lanes = Lambda_inv_2_8_p8_lanes + Lambda_inv_0_8_p257_lanes *
      Lambda_inv_0_0_p318_lanes[2] + Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[2];
  Lambda_inv[32] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[98] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[33] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[110] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[34] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[122] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[35] = Lambda_inv_2_8_lanes[3];
  Lambda_inv[134] = Lambda_inv_2_8_lanes[3];
  const Lanes<8> Lambda_inv_3_3_lanes = Lambda_inv_3_3_p23_lanes + Lambda_inv_0_0_p320_lanes *
      Lambda_inv_0_0_p318_lanes[3] + Lambda_inv_0_0_p325_lanes * Lambda_inv_0_0_p323_lanes[3];
  Lambda_inv[39] = Lambda_inv_3_3_lanes[3];
  Lambda_inv[40] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[51] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[41] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[63] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[42] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[75] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[43] = Lambda_inv_3_3_lanes[7];
  Lambda_inv[87] = Lambda_inv_3_3_lanes[7];
  const Lanes<8> Lambda_inv_3_8_lanes = Lambda_inv_3_8_p8_lanes + Lambda_inv_0_8_p257_lanes *
      Lambda_inv_0_0_p318_lanes[3] + Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[3];
  Lambda_inv[44] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[99] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[45] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[111] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[46] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[123] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[47] = Lambda_inv_3_8_lanes[3];
  Lambda_inv[135] = Lambda_inv_3_8_lanes[3];
  const Lanes<8> Lambda_inv_4_4_lanes = Lambda_inv_4_4_p22_lanes + Lambda_inv_0_0_p320_lanes *
      Lambda_inv_0_0_p318_lanes[4] + Lambda_inv_0_0_p325_lanes * Lambda_inv_0_0_p323_lanes[4];
  Lambda_inv[52] = Lambda_inv_4_4_lanes[4];
  Lambda_inv[53] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[64] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[54] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[76] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[55] = Lambda_inv_4_4_lanes[7];
  Lambda_inv[88] = Lambda_inv_4_4_lanes[7];
  const Lanes<8> Lambda_inv_4_8_lanes = Lambda_inv_4_8_p8_lanes + Lambda_inv_0_8_p257_lanes *
      Lambda_inv_0_0_p318_lanes[4] + Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[4];
  Lambda_inv[56] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[100] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[57] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[112] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[58] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[124] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[59] = Lambda_inv_4_8_lanes[3];
  Lambda_inv[136] = Lambda_inv_4_8_lanes[3];
  const Lanes<8> Lambda_inv_5_5_lanes = Lambda_inv_5_5_p20_lanes + Lambda_inv_0_0_p320_lanes *
      Lambda_inv_0_0_p318_lanes[5] + Lambda_inv_0_0_p325_lanes * Lambda_inv_0_0_p323_lanes[5];
  Lambda_inv[65] = Lambda_inv_5_5_lanes[5];
  Lambda_inv[66] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[77] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[67] = Lambda_inv_5_5_lanes[7];
  Lambda_inv[89] = Lambda_inv_5_5_lanes[7];
  const Lanes<8> Lambda_inv_5_8_lanes = Lambda_inv_5_8_p8_lanes + Lambda_inv_0_8_p257_lanes *
      Lambda_inv_0_0_p318_lanes[5] + Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[5];
  Lambda_inv[68] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[101] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[69] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[113] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[70] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[125] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[71] = Lambda_inv_5_8_lanes[3];
  Lambda_inv[137] = Lambda_inv_5_8_lanes[3];
  const Lanes<8> Lambda_inv_6_6_lanes = Lambda_inv_6_6_p12_lanes +
      detail::make_pack<Real>(Lambda_inv_0_0_p325_lanes[6] * Lambda_inv_0_0_p323_lanes[6],
      Lambda_inv_0_0_p325_lanes[6] * Lambda_inv_0_0_p323_lanes[6], Lambda_inv_0_0_p325_lanes[6] *
      Lambda_inv_0_0_p323_lanes[6], Lambda_inv_0_0_p325_lanes[6] * Lambda_inv_0_0_p323_lanes[6],
      Lambda_inv_0_0_p325_lanes[6] * Lambda_inv_0_0_p323_lanes[6], Lambda_inv_0_0_p325_lanes[6] *
      Lambda_inv_0_0_p323_lanes[6], Lambda_inv_0_0_p325_lanes[6] * Lambda_inv_0_0_p323_lanes[6],
      Lambda_inv_0_0_p325_lanes[7] * Lambda_inv_0_0_p323_lanes[6]);
  Lambda_inv[78] = Lambda_inv_6_6_lanes[6];
  Lambda_inv[79] = Lambda_inv_6_6_lanes[7];
  Lambda_inv[90] = Lambda_inv_6_6_lanes[7];
  const Lanes<8> Lambda_inv_6_8_lanes = Lambda_inv_6_8_p27_lanes + Lambda_inv_0_8_p242_lanes *
      Lambda_inv_0_0_p302_lanes[6] + Lambda_inv_0_8_p257_lanes * Lambda_inv_0_0_p318_lanes[6] +
      Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[6];
  Lambda_inv[80] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[102] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[81] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[114] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[82] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[126] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[83] = Lambda_inv_6_8_lanes[3];
  Lambda_inv[138] = Lambda_inv_6_8_lanes[3];
  Lambda_inv[91] = Lambda_inv_7_7_p2 + Lambda_inv_0_0_p290_lanes[7] * Lambda_inv_0_0_p285_lanes[7] +
      Lambda_inv_0_0_p305_lanes[7] * Lambda_inv_0_0_p302_lanes[7] + Lambda_inv_0_0_p320_lanes[7] *
      Lambda_inv_0_0_p318_lanes[7] + Lambda_inv_0_0_p325_lanes[7] * Lambda_inv_0_0_p323_lanes[7];
  const Lanes<8> Lambda_inv_7_8_lanes = Lambda_inv_7_8_p20_lanes + Lambda_inv_0_8_p242_lanes *
      Lambda_inv_0_0_p302_lanes[7] + Lambda_inv_0_8_p257_lanes * Lambda_inv_0_0_p318_lanes[7] +
      Lambda_inv_0_8_p261_lanes * Lambda_inv_0_0_p323_lanes[7];
  Lambda_inv[92] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[103] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[93] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[115] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[94] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[127] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[95] = Lambda_inv_7_8_lanes[3];
  Lambda_inv[139] = Lambda_inv_7_8_lanes[3];
  const Lanes<8> Lambda_inv_8_8_lanes = Lambda_inv_8_8_p20_lanes + Lambda_inv_0_8_p242_lanes *
      Lambda_inv_0_8_p239_lanes[0] + Lambda_inv_0_8_p257_lanes * Lambda_inv_0_8_p254_lanes[0] +
      Lambda_inv_0_8_p261_lanes * Lambda_inv_0_8_p259_lanes[0];
  Lambda_inv[104] = Lambda_inv_8_8_lanes[0];
  Lambda_inv[105] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[116] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[106] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[128] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[107] = Lambda_inv_8_8_lanes[3];
  Lambda_inv[140] = Lambda_inv_8_8_lanes[3];
  const Lanes<8> Lambda_inv_9_9_lanes = Lambda_inv_9_9_p21_lanes + Lambda_inv_0_8_p242_lanes *
      Lambda_inv_0_8_p239_lanes[1] + Lambda_inv_0_8_p257_lanes * Lambda_inv_0_8_p254_lanes[1] +
      Lambda_inv_0_8_p261_lanes * Lambda_inv_0_8_p259_lanes[1];
  Lambda_inv[117] = Lambda_inv_9_9_lanes[1];
  Lambda_inv[118] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[129] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[119] = Lambda_inv_9_9_lanes[3];
  Lambda_inv[141] = Lambda_inv_9_9_lanes[3];
  const Lanes<8> Lambda_inv_10_10_lanes = Lambda_inv_10_10_p24_lanes +
      detail::make_pack<Real>(Lambda_inv_0_8_p261_lanes[2] * Lambda_inv_0_8_p259_lanes[2],
      Lambda_inv_0_8_p261_lanes[2] * Lambda_inv_0_8_p259_lanes[2], Lambda_inv_0_8_p261_lanes[2] *
      Lambda_inv_0_8_p259_lanes[2], Lambda_inv_0_8_p261_lanes[3] * Lambda_inv_0_8_p259_lanes[2],
      Lambda_inv_0_8_p261_lanes[2] * Lambda_inv_0_8_p259_lanes[2], Lambda_inv_0_8_p261_lanes[2] *
      Lambda_inv_0_8_p259_lanes[2], Lambda_inv_0_8_p261_lanes[2] * Lambda_inv_0_8_p259_lanes[2],
      Lambda_inv_0_8_p261_lanes[2] * Lambda_inv_0_8_p259_lanes[2]);
  Lambda_inv[130] = Lambda_inv_10_10_lanes[2];
  Lambda_inv[131] = Lambda_inv_10_10_lanes[3];
  Lambda_inv[142] = Lambda_inv_10_10_lanes[3];
  Lambda_inv[143] = Lambda_inv_11_11_p15 + Lambda_inv_0_8_p257_lanes[3] *
      Lambda_inv_0_8_p254_lanes[3] + Lambda_inv_0_8_p261_lanes[3] * Lambda_inv_0_8_p259_lanes[3];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
