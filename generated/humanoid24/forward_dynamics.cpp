// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By articulated bodies, Chang table 4.2, alike limbs in lanes.
// 4579 flops (add 2154, mul 2393, div 32), sine and cosine of 24 angles
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
void forward_dynamics(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT tau)[24], Real (&TREELINE_RESTRICT qdd)[24]) noexcept {
  const Real s20_p1 = 0.17435661841416683 + q[19];
  const Real s13_p1 = (-0.17435661841416683) + q[12];
  const Real angles[24] = {q[23], q[22], q[21], q[20], q[18], s20_p1, q[17], q[16], q[15], q[14],
      q[13], q[11], s13_p1, q[10], q[9], q[8], q[7], q[6], q[5], q[4], q[3], q[1], q[2], q[0]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real s24 = sines[0];
  const Real s23 = sines[1];
  const Real c24 = cosines[0];
  const Real c23 = cosines[1];
  const Real c22 = cosines[2];
  const Real s22 = sines[2];
  const Real c21 = cosines[3];
  const Real s21 = sines[3];
  const Real s19 = sines[4];
  const Real s20 = sines[5];
  const Real c20 = cosines[5];
  const Real c19 = cosines[4];
  const Real s18 = sines[6];
  const Real c18 = cosines[6];
  const Real s17 = sines[7];
  const Real c17 = cosines[7];
  const Real c16 = cosines[8];
  const Real s16 = sines[8];
  const Real s15 = sines[9];
  const Real c15 = cosines[9];
  const Real c14 = cosines[10];
  const Real s14 = sines[10];
  const Real s12 = sines[11];
  const Real s13 = sines[12];
  const Real c13 = cosines[12];
  const Real c12 = cosines[11];
  const Real s11 = sines[13];
  const Real c11 = cosines[13];
  const Real s10 = sines[14];
  const Real c10 = cosines[14];
  const Real c9 = cosines[15];
  const Real s9 = sines[15];
  const Real s8 = sines[16];
  const Real c8 = cosines[16];
  const Real c7 = cosines[17];
  const Real s7 = sines[17];
  const Real s6 = sines[18];
  const Real c6 = cosines[18];
  const Real s5 = sines[19];
  const Real c5 = cosines[19];
  const Real s4 = sines[20];
  const Real c4 = cosines[20];
  const Real s2 = sines[21];
  const Real c3 = cosines[22];
  const Real c2 = cosines[21];
  const Real s3 = sines[22];
  const Real c1 = cosines[23];
  const Real s1 = sines[23];

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D10_p1_lanes = 17.595187778776943 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> inverse_D10_p2_lanes = 0.0165153994048813 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p3_lanes = 17.595187778776943 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p4_lanes = 0.0165153994048813 * detail::make_pack<Real>(s13, s20);

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p7_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> inverse_D12_p5_lanes = 0.00011422720754895356 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p6_lanes = 0.0007965395222188762 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(2.0630162081277884e-05, (-2.0630162081277884e-05)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D11_p3_lanes = 0.00011422720754895356 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(s13, s20);

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D10_p8_lanes = 0.0006000000000000001 + inverse_D10_p2_lanes;
  const Lanes<2> inverse_D12_p7_lanes = 1065.380700001509 * inverse_D12_p5_lanes;
  const Lanes<2> inverse_D12_p8_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p6_lanes;
  const Lanes<2> inverse_D11_p5_lanes = 1065.380700001509 * inverse_D11_p3_lanes;
  const Lanes<2> inverse_D10_p13_lanes = inverse_D12_p5_lanes * inverse_D10_p3_lanes;
  const Lanes<2> inverse_D12_p10_lanes = 0.0008675855653090935 - inverse_D12_p8_lanes;
  const Lanes<2> inverse_D11_p7_lanes = detail::make_pack<Real>(c13, c20) * inverse_D12_p6_lanes -
      detail::make_pack<Real>(1.0315081040638942e-05, (-1.0315081040638942e-05));
  const Lanes<2> inverse_D11_p9_lanes = 7.104604309021728e-05 + inverse_D12_p8_lanes;
  const Lanes<2> inverse_D10_p16_lanes = 0.0025100003499999995 - inverse_D12_p5_lanes *
      inverse_D10_p1_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p1_lanes = 2.0 * detail::make_pack<Real>(c10, c17);

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D11_p12_lanes = detail::make_pack<Real>((-2.4000000000000003e-06),
      2.4000000000000003e-06) - (inverse_D11_p7_lanes + inverse_D11_p3_lanes *
      inverse_D12_p7_lanes);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (0.000206827662257343 +
      (inverse_D12_p10_lanes - inverse_D12_p5_lanes * inverse_D12_p7_lanes));
  const Lanes<2> inverse_D11_p14_lanes = inverse_D11_p12_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p18_lanes = inverse_D10_p16_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p19_lanes = inverse_D10_p8_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p20_lanes = inverse_D10_p13_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p25_lanes = inverse_D10_p8_lanes * inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p26_lanes = inverse_D10_p8_lanes * inverse_D10_p19_lanes;
  const Lanes<2> inverse_D10_p29_lanes = inverse_D10_p8_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D11_p16_lanes = 0.000195227662257343 +
      (inverse_D11_p9_lanes - inverse_D11_p3_lanes * inverse_D11_p5_lanes) - inverse_D11_p12_lanes *
      inverse_D11_p14_lanes;
  const Lanes<2> inverse_D10_p30_lanes = inverse_D11_p3_lanes * inverse_D10_p1_lanes +
      inverse_D11_p12_lanes * inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p31_lanes = inverse_D10_p4_lanes + inverse_D11_p12_lanes *
      inverse_D10_p19_lanes;
  const Lanes<2> inverse_D10_p32_lanes = inverse_D11_p3_lanes * inverse_D10_p3_lanes -
      0.0025100003499999995 - inverse_D11_p12_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D10_p33_lanes = inverse_D10_p4_lanes * inverse_D10_p1_lanes +
      inverse_D10_p16_lanes * inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p35_lanes = inverse_D10_p4_lanes * inverse_D10_p3_lanes -
      inverse_D10_p16_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D10_p36_lanes = inverse_D10_p2_lanes * inverse_D10_p3_lanes +
      inverse_D10_p13_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D11_p18_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p16_lanes);
  const Lanes<2> inverse_D10_p46_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p30_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p31_lanes;
  const Lanes<2> inverse_D10_p47_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p32_lanes;
  const Lanes<2> inverse_D10_p49_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p32_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> inverse_D10_p50_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p35_lanes -
      detail::make_pack<Real>(c12, c19) * inverse_D10_p29_lanes;
  const Lanes<2> inverse_D8_p3_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p29_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p35_lanes;
  const Lanes<2> inverse_D11_p19_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p18_lanes;
  const Lanes<2> inverse_D10_p51_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p46_lanes;
  const Lanes<2> inverse_D10_p54_lanes = detail::make_pack<Real>(s12, s19) *
      (inverse_D10_p33_lanes - inverse_D10_p26_lanes) + detail::make_pack<Real>(c12, c19) *
      (2.0 * inverse_D10_p25_lanes);
  const Lanes<2> inverse_D10_p55_lanes = inverse_D10_p49_lanes + 0.269 * inverse_D10_p36_lanes;
  const Lanes<2> inverse_D10_p56_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p46_lanes;
  const Lanes<2> inverse_D10_p57_lanes = 0.269 * inverse_D10_p50_lanes;
  const Lanes<2> inverse_D8_p4_lanes = 6e-04 - inverse_D10_p47_lanes;
  const Lanes<2> inverse_D10_p60_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p54_lanes;
  const Lanes<2> inverse_D10_p62_lanes = inverse_D10_p56_lanes + inverse_D10_p57_lanes;
  const Lanes<2> inverse_D8_p6_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      inverse_D10_p51_lanes;
  const Lanes<2> inverse_D8_p8_lanes = inverse_D10_p56_lanes - inverse_D10_p30_lanes;
  const Lanes<2> inverse_D10_p64_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p18_lanes + 0.269 * inverse_D10_p47_lanes);
  const Lanes<2> inverse_D10_p65_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      inverse_D10_p51_lanes;
  const Lanes<2> inverse_D10_p66_lanes = inverse_D10_p26_lanes + inverse_D10_p60_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p16_lanes + inverse_D11_p19_lanes));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p11_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p54_lanes -
      inverse_D10_p25_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p73_lanes = inverse_D10_p64_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p74_lanes = inverse_D10_p65_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p16_lanes = inverse_D8_p6_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p17_lanes = inverse_D8_p4_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p18_lanes = inverse_D8_p8_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p78_lanes = 0.000131 - inverse_D11_p19_lanes - 0.269 *
      (inverse_D10_p49_lanes + inverse_D10_p55_lanes) - inverse_D10_p64_lanes *
      inverse_D10_p73_lanes;
  const Lanes<2> inverse_D10_p79_lanes = 0.0001098 - 0.07236100000000001 * inverse_D10_p66_lanes -
      inverse_D10_p65_lanes * inverse_D10_p74_lanes;
  const Lanes<2> inverse_D10_p80_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      inverse_D10_p62_lanes - inverse_D10_p64_lanes * inverse_D10_p74_lanes;
  const Lanes<2> inverse_D8_p32_lanes = inverse_D10_p64_lanes * inverse_D8_p16_lanes -
      inverse_D10_p62_lanes;
  const Lanes<2> inverse_D8_p33_lanes = inverse_D10_p57_lanes - inverse_D10_p65_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p34_lanes = 0.269 * inverse_D10_p66_lanes + inverse_D10_p65_lanes *
      inverse_D8_p16_lanes;
  const Lanes<2> inverse_D8_p35_lanes = inverse_D10_p55_lanes + inverse_D10_p64_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p36_lanes = detail::make_pack<Real>(0.001, (-0.001)) -
      (inverse_D10_p51_lanes - inverse_D10_p31_lanes + 0.269 * inverse_D8_p3_lanes) -
      inverse_D10_p64_lanes * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p37_lanes = 0.269 * inverse_D8_p11_lanes - 6e-04 -
      inverse_D10_p65_lanes * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p38_lanes = inverse_D10_p66_lanes + inverse_D8_p6_lanes *
      inverse_D8_p16_lanes;
  const Lanes<2> inverse_D8_p39_lanes = inverse_D10_p36_lanes + inverse_D8_p4_lanes *
      inverse_D8_p17_lanes;
  const Lanes<2> inverse_D8_p40_lanes = inverse_D8_p6_lanes * inverse_D8_p17_lanes -
      inverse_D10_p50_lanes;
  const Lanes<2> inverse_D8_p41_lanes = inverse_D8_p6_lanes * inverse_D8_p18_lanes -
      inverse_D8_p11_lanes;
  const Lanes<2> inverse_D8_p42_lanes = inverse_D8_p3_lanes + inverse_D8_p4_lanes *
      inverse_D8_p18_lanes;
  const Lanes<2> inverse_D10_p84_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p78_lanes - inverse_D10_p79_lanes) + inverse_D10_p7_lanes *
      inverse_D10_p80_lanes;
  const Lanes<2> inverse_D8_p62_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p32_lanes - inverse_D8_p33_lanes) + detail::make_pack<Real>(c11, c18) *
      (inverse_D8_p34_lanes - inverse_D8_p35_lanes);
  const Lanes<2> inverse_D8_p64_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * inverse_D8_p36_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p37_lanes);
  const Lanes<2> inverse_D8_p65_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p39_lanes - inverse_D8_p38_lanes) + inverse_D10_p7_lanes * inverse_D8_p40_lanes;
  const Lanes<2> inverse_D10_p85_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p84_lanes;
  const Lanes<2> inverse_D8_p66_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p62_lanes;
  const Lanes<2> inverse_D8_p67_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p62_lanes;
  const Lanes<2> inverse_D8_p68_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p65_lanes;
  const Lanes<2> inverse_D8_p71_lanes = inverse_D8_p33_lanes + inverse_D8_p67_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p77_lanes = 2.0 * detail::make_pack<Real>(s9, s16);

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p87_lanes = 0.060888541114265754 +
      (inverse_D10_p79_lanes + inverse_D10_p85_lanes);
  const Lanes<2> inverse_D9_p5_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p84_lanes -
      inverse_D10_p80_lanes);
  const Lanes<2> inverse_D8_p78_lanes = inverse_D8_p66_lanes + inverse_D8_p35_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p87_lanes;
  const Lanes<2> inverse_D9_p7_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p87_lanes;
  const Lanes<2> inverse_D9_p9_lanes = inverse_D9_p5_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p11_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p87_lanes;
  const Lanes<2> inverse_D8_p80_lanes = inverse_D8_p78_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p81_lanes = inverse_D8_p64_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p82_lanes = inverse_D8_p71_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p13_lanes = 0.0001499998887063 + inverse_D9_p5_lanes *
      inverse_D9_p7_lanes;
  const Lanes<2> inverse_D8_p84_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p86_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p81_lanes;
  const Lanes<2> inverse_D9_p15_lanes = 0.06060754126741261 +
      (inverse_D10_p78_lanes - inverse_D10_p85_lanes) - inverse_D9_p5_lanes * inverse_D9_p9_lanes;
  const Lanes<2> inverse_D8_p95_lanes = inverse_D8_p32_lanes - inverse_D8_p67_lanes -
      inverse_D9_p5_lanes * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p96_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p36_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p37_lanes + inverse_D9_p5_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p97_lanes = 0.28049749700000004 +
      (inverse_D8_p66_lanes - inverse_D8_p34_lanes) - inverse_D9_p5_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p98_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p99_lanes = inverse_D8_p38_lanes + inverse_D8_p68_lanes +
      inverse_D8_p78_lanes * inverse_D8_p80_lanes;
  const Lanes<2> inverse_D8_p100_lanes = inverse_D10_p60_lanes - inverse_D10_p33_lanes -
      inverse_D8_p8_lanes * inverse_D8_p18_lanes - inverse_D8_p64_lanes * inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p101_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p41_lanes +
      detail::make_pack<Real>(s11, s18) * inverse_D8_p42_lanes + inverse_D8_p78_lanes *
      inverse_D8_p81_lanes;
  const Lanes<2> inverse_D8_p102_lanes = inverse_D8_p68_lanes - inverse_D8_p39_lanes -
      inverse_D8_p71_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p104_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p65_lanes -
      inverse_D8_p40_lanes - inverse_D8_p78_lanes * inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p105_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p41_lanes -
      detail::make_pack<Real>(c11, c18) * inverse_D8_p42_lanes + inverse_D8_p64_lanes *
      inverse_D8_p82_lanes;
  const Lanes<2> inverse_D8_p118_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p98_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p97_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p1_lanes = 2.0 * detail::make_pack<Real>(c8, c15);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p120_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p97_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p98_lanes;
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
  const Lanes<2> inverse_D6_p63_lanes = inverse_D8_p140_lanes + inverse_D8_p143_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p65_lanes = inverse_D8_p127_lanes + inverse_D8_p145_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p67_lanes = inverse_D8_p145_lanes * inverse_D6_p31_lanes - 0.282 *
      inverse_D8_p137_lanes;
  const Lanes<2> inverse_D6_p69_lanes = inverse_D8_p125_lanes - inverse_D8_p143_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p71_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * inverse_D6_p7_lanes - (inverse_D8_p84_lanes - inverse_D8_p128_lanes)) +
      inverse_D8_p143_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p73_lanes = 0.0022500062 + 0.282 * inverse_D6_p15_lanes +
      inverse_D8_p145_lanes * inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p75_lanes = inverse_D8_p137_lanes - inverse_D6_p19_lanes *
      inverse_D6_p31_lanes;
  const Lanes<2> inverse_D6_p77_lanes = inverse_D8_p102_lanes - inverse_D6_p5_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p79_lanes = inverse_D8_p121_lanes + inverse_D6_p19_lanes *
      inverse_D6_p33_lanes;
  const Lanes<2> inverse_D6_p81_lanes = inverse_D6_p15_lanes + inverse_D6_p19_lanes *
      inverse_D6_p35_lanes;
  const Lanes<2> inverse_D6_p83_lanes = inverse_D6_p7_lanes + inverse_D6_p5_lanes *
      inverse_D6_p35_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p117_lanes = 2.0 * detail::make_pack<Real>(s7, s14);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p160_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D8_p154_lanes - inverse_D8_p155_lanes) - inverse_D8_p77_lanes *
      inverse_D8_p156_lanes;
  const Lanes<2> inverse_D6_p125_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p63_lanes + inverse_D6_p65_lanes) - detail::make_pack<Real>(s9, s16) *
      (inverse_D6_p67_lanes + inverse_D6_p69_lanes);
  const Lanes<2> inverse_D6_p129_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * inverse_D6_p71_lanes -
      detail::make_pack<Real>(s9, s16) * inverse_D6_p73_lanes);
  const Lanes<2> inverse_D6_p131_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p75_lanes - inverse_D6_p77_lanes) - inverse_D8_p77_lanes * inverse_D6_p79_lanes;
  const Lanes<2> inverse_D8_p161_lanes = detail::make_pack<Real>(c9, c16) * inverse_D8_p160_lanes;
  const Lanes<2> inverse_D6_p133_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p125_lanes;
  const Lanes<2> inverse_D6_p135_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p125_lanes;
  const Lanes<2> inverse_D6_p137_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p131_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p1_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p145_lanes = inverse_D6_p135_lanes - inverse_D6_p65_lanes;

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
      (inverse_D6_p133_lanes + inverse_D6_p69_lanes);

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
  const Lanes<2> inverse_D6_p161_lanes = inverse_D6_p129_lanes * inverse_D8_lanes;
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
  const Lanes<2> inverse_D6_p185_lanes = inverse_D7_p5_lanes * inverse_D6_p161_lanes -
      (detail::make_pack<Real>(s9, s16) * inverse_D6_p71_lanes + detail::make_pack<Real>(c9, c16) *
      inverse_D6_p73_lanes);
  const Lanes<2> inverse_D6_p187_lanes = inverse_D6_p63_lanes - inverse_D6_p135_lanes -
      inverse_D7_p5_lanes * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p189_lanes = inverse_D6_p133_lanes + inverse_D6_p67_lanes -
      0.7139200499999999 - inverse_D7_p5_lanes * inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p37 = inverse_D21_p3_lanes[1] + inverse_D21_p3_lanes[0];

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p191_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p38 = inverse_D21_p24 * inverse_D22;
  const Real inverse_D21_p39 = inverse_D21_p19 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p40_lanes = 0.095 * inverse_D21_p31_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D21_p20_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p42 = 2.0 * c22;
  const Real inverse_D6_p193 = inverse_D6_p159 * inverse_D22;
  const Real inverse_D6_p194 = inverse_D6_p160 * inverse_D22;
  const Real inverse_D21_p43 = inverse_D21_p40_lanes[1] + inverse_D21_p40_lanes[0];
  const Real inverse_D6_p199 = inverse_D21_p14 * inverse_D22;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p17_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D7_p9_lanes - inverse_D7_p12_lanes) + inverse_D7_p1_lanes * inverse_D7_p13_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p204 = inverse_D21_p24 * inverse_D6_p194;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p205_lanes = inverse_D6_p75_lanes - inverse_D6_p137_lanes -
      inverse_D6_p155_lanes * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p207_lanes = inverse_D8_p100_lanes - inverse_D8_p130_lanes -
      inverse_D6_p13_lanes * inverse_D6_p35_lanes - inverse_D6_p129_lanes * inverse_D6_p161_lanes;
  const Lanes<2> inverse_D7_p18_lanes = detail::make_pack<Real>(s8, s15) * inverse_D7_p17_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p209 = inverse_D21_p19 * inverse_D6_p193 - inverse_D21_p14;
  const Real inverse_D6_p210 = inverse_D21_p29_lanes[1] + inverse_D21_p29_lanes[0] +
      inverse_D21_p24 * inverse_D6_p193;
  const Real inverse_D6_p211 = inverse_D21_p19 * inverse_D6_p194 - 0.00025 * inverse_D21_p5;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p212_lanes = detail::make_pack<Real>(c8, c15) *
      (inverse_D6_p185_lanes + inverse_D6_p171_lanes) - detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p173_lanes + inverse_D6_p187_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D21_p44 = 0.009438624999999999 - (-0.032) * inverse_D21_p29_lanes[1] - 0.032 *
      inverse_D21_p29_lanes[0] - inverse_D21_p24 * inverse_D21_p38 + 0.095 * inverse_D21_p43;
  const Real inverse_D21_p45 = 0.05450270000000001 + inverse_D22_p6 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - inverse_D21_p19 * inverse_D21_p39 - 0.00017071621621621625;
  const Real inverse_D21_p46 = 0.0074 - (-0.032) * inverse_D21_p8_lanes[1] - 0.032 *
      inverse_D21_p8_lanes[0] + inverse_D21_p19 * inverse_D21_p38 - 0.095 * inverse_D21_p37;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p218_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p212_lanes;
  const Lanes<2> inverse_D6_p222_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p81_lanes -
      detail::make_pack<Real>(c9, c16) * inverse_D6_p83_lanes + inverse_D6_p129_lanes *
      inverse_D6_p163_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p224 = 0.072575 + inverse_D21_p43 + inverse_D21_p24 * inverse_D6_p199;
  const Real inverse_D6_p225 = inverse_D21_p37 - 0.43200000000000005 + inverse_D21_p19 *
      inverse_D6_p199;
  const Real inverse_D6_p226 = inverse_D6_p160 * inverse_D6_p194;
  const Real inverse_D6_p227 = inverse_D21_p22_lanes[1] + inverse_D21_p22_lanes[0] +
      inverse_D6_p159 * inverse_D6_p193;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p20_lanes = 0.000448 + (inverse_D7_p12_lanes + inverse_D7_p18_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p236 = inverse_D6_p159 * inverse_D6_p194;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D7_lanes = 1.0 / inverse_D7_p20_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p241_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * inverse_D6_p191_lanes + detail::make_pack<Real>(c8, c15) *
      inverse_D6_p189_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p243 = s22 * (inverse_D6_p209 + inverse_D6_p204) + c22 *
      (inverse_D6_p211 - inverse_D6_p210);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p244_lanes = 0.0017499999999999998 +
      (inverse_D6_p218_lanes - inverse_D6_p171_lanes);
  const Lanes<2> inverse_D6_p246_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p207_lanes - inverse_D6_p205_lanes) + inverse_D7_p1_lanes * inverse_D6_p222_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p248 = inverse_D6_p160 * inverse_D6_p199;
  const Real inverse_D21_p47 = s22 * (inverse_D21_p45 - inverse_D21_p44) + inverse_D21_p42 *
      inverse_D21_p46;
  const Real inverse_D6_p249 = c22 * inverse_D6_p224 - s22 * inverse_D6_p225;
  const Real inverse_D6_p250 = c22 * inverse_D6_p243;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p253_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p246_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p48 = s22 * inverse_D21_p47;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p257_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p131_lanes +
      inverse_D6_p79_lanes - inverse_D6_p155_lanes * inverse_D6_p165_lanes;
  const Lanes<2> inverse_D6_p259_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p81_lanes +
      detail::make_pack<Real>(s9, s16) * inverse_D6_p83_lanes + inverse_D6_p129_lanes *
      inverse_D6_p165_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p261 = inverse_D21_p31_lanes[1] + inverse_D21_p31_lanes[0] -
      inverse_D21_p14 * inverse_D6_p199;
  const Real inverse_D6_p262 = c22 * inverse_D6_p225 + s22 * inverse_D6_p224;
  const Real inverse_D6_p263 = inverse_D21_p20_lanes[1] + inverse_D21_p20_lanes[0] -
      inverse_D6_p159 * inverse_D6_p199;
  const Real inverse_D6_p264 = inverse_D21_p42 * inverse_D6_p236 - s22 *
      (inverse_D6_p226 - inverse_D6_p227);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p265_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p212_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p275 = inverse_D6_p250 - inverse_D6_p211;
  const Real inverse_D6_p282 = s22 * inverse_D6_p264;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p283_lanes = inverse_D6_p187_lanes + inverse_D6_p265_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p285 = 0.394 * inverse_D6_p275;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p286_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p17_lanes -
      inverse_D7_p13_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p288 = s22 * inverse_D6_p243;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p291_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p20_lanes;
  const Lanes<2> inverse_D6_p293_lanes = inverse_D6_p244_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p295_lanes = inverse_D6_p241_lanes * inverse_D7_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p297 = inverse_D6_p262 - 0.394 * inverse_D6_p261;
  const Real inverse_D6_p298 = c22 * inverse_D6_p263 + s22 * inverse_D6_p248;
  const Real inverse_D6_p299 = inverse_D6_p282 - inverse_D6_p227;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p300_lanes = inverse_D6_p283_lanes * inverse_D7_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p44 + inverse_D21_p48));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p304 = 0.0016155 + (c22 * inverse_D21_p47 - inverse_D21_p46 + 0.394 *
      inverse_D6_p249);
  const Real inverse_D6_p323 = 0.394 * inverse_D6_p298;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p324_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p295_lanes;
  const Lanes<2> inverse_D6_p326_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p293_lanes;
  const Lanes<2> inverse_D6_p332_lanes = inverse_D6_p286_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p340_lanes = inverse_D6_p207_lanes - inverse_D6_p253_lanes -
      inverse_D6_p244_lanes * inverse_D6_p293_lanes;
  const Lanes<2> inverse_D6_p342_lanes = inverse_D6_p77_lanes + inverse_D6_p137_lanes -
      inverse_D6_p145_lanes * inverse_D6_p165_lanes - inverse_D6_p241_lanes * inverse_D6_p295_lanes;
  const Lanes<2> inverse_D6_p344_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p259_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p257_lanes - inverse_D6_p241_lanes *
      inverse_D6_p293_lanes;
  const Lanes<2> inverse_D6_p346_lanes = inverse_D6_p173_lanes + inverse_D6_p265_lanes +
      inverse_D6_p286_lanes * inverse_D6_p293_lanes;
  const Lanes<2> inverse_D6_p348_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p191_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p189_lanes - inverse_D6_p286_lanes *
      inverse_D6_p295_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p350 = inverse_D6_p209 - inverse_D6_p288 - inverse_D6_p323;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p351 = 2.0 * s21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p352_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p246_lanes -
      inverse_D6_p222_lanes - inverse_D6_p244_lanes * inverse_D6_p300_lanes;
  const Lanes<2> inverse_D6_p354_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p259_lanes +
      detail::make_pack<Real>(c8, c15) * inverse_D6_p257_lanes - inverse_D6_p241_lanes *
      inverse_D6_p300_lanes;
  const Lanes<2> inverse_D6_p370_lanes = 0.0001505 - inverse_D6_p291_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p386 = inverse_D6_p304 * inverse_D21;
  const Real inverse_D6_p387 = inverse_D6_p285 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p390_lanes = 0.0002975 + (inverse_D7_p9_lanes - inverse_D7_p18_lanes) -
      inverse_D6_p286_lanes * inverse_D6_p332_lanes;
  const Lanes<2> inverse_D6_p394_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p332_lanes;
  const Lanes<2> inverse_D6_p400_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p354_lanes +
      detail::make_pack<Real>(c7, c14) * inverse_D6_p352_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D5_p5 = 0.0045000000000000005 + inverse_D6_p249;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p402_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p342_lanes - inverse_D6_p340_lanes) - inverse_D6_p117_lanes *
      inverse_D6_p344_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p6 = inverse_D6_p275 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p406_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p346_lanes - inverse_D6_p324_lanes) - detail::make_pack<Real>(s7, s14) *
      (inverse_D6_p348_lanes - inverse_D6_p326_lanes);
  const Lanes<2> inverse_D6_p412_lanes = inverse_D6_p205_lanes + inverse_D6_p253_lanes -
      inverse_D6_p283_lanes * inverse_D6_p300_lanes;
  const Lanes<2> inverse_D6_p414_lanes = inverse_D6_p218_lanes - inverse_D6_p185_lanes -
      0.0017499999999999998 - inverse_D6_p286_lanes * inverse_D6_p300_lanes;
  const Lanes<2> inverse_D6_p416_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p402_lanes;
  const Lanes<2> inverse_D6_p420_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p300_lanes;
  const Lanes<2> inverse_D6_p422_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p406_lanes;
  const Lanes<2> inverse_D5_p9_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p354_lanes -
      detail::make_pack<Real>(s7, s14) * inverse_D6_p352_lanes;
  const Lanes<2> inverse_D5_p11_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p406_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p426 = 0.005513625 + (inverse_D21_p45 - inverse_D21_p48 - 0.394 *
      (inverse_D6_p262 + inverse_D6_p297)) - inverse_D6_p304 * inverse_D6_p386;
  const Real inverse_D6_p427 = 0.000703125 + 0.155236 * inverse_D6_p299 - inverse_D6_p285 *
      inverse_D6_p387;
  const Real inverse_D6_p428 = 0.394 * inverse_D6_p350 - inverse_D6_p304 * inverse_D6_p387;
  const Real inverse_D5_p13 = inverse_D5_p5 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p435_lanes = inverse_D6_p342_lanes - inverse_D6_p416_lanes;
  const Lanes<2> inverse_D6_p437_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p370_lanes - inverse_D6_p390_lanes) + inverse_D6_p117_lanes *
      inverse_D6_p394_lanes;
  const Lanes<2> inverse_D5_p14_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p402_lanes +
      inverse_D6_p344_lanes;
  const Lanes<2> inverse_D5_p16_lanes = 0.226 * inverse_D5_p9_lanes;
  const Lanes<2> inverse_D6_p439_lanes = inverse_D6_p326_lanes - inverse_D6_p422_lanes;
  const Lanes<2> inverse_D5_p20_lanes = inverse_D6_p324_lanes + inverse_D5_p11_lanes;
  const Lanes<2> inverse_D6_p445_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p437_lanes;
  const Lanes<2> inverse_D6_p447_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p420_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p414_lanes;
  const Lanes<2> inverse_D5_p22_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      inverse_D5_p14_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p24 = inverse_D6_p350 - inverse_D6_p304 * inverse_D5_p6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p25_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p437_lanes;
  const Lanes<2> inverse_D6_p449_lanes = inverse_D6_p447_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p400_lanes + 0.226 *
      inverse_D6_p412_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p27 = 0.394 * inverse_D6_p299 - inverse_D6_p285 * inverse_D5_p6;

  // link 22 (head), articulated inertia
  const Real inverse_D3_p1 = inverse_D6_p288 - inverse_D6_p204;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p453 = inverse_D6_p445_lanes[1] + inverse_D6_p445_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p454 = c21 * (inverse_D6_p426 - inverse_D6_p427) - inverse_D6_p351 *
      inverse_D6_p428;
  const Real inverse_D5_p34 = inverse_D6_p323 + inverse_D6_p285 * inverse_D5_p13;
  const Real inverse_D5_p35 = inverse_D6_p297 + inverse_D6_p304 * inverse_D5_p13;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p455 = inverse_D6_p449_lanes[1] + inverse_D6_p449_lanes[0];

  // link 22 (head), articulated inertia
  const Real inverse_D3_p2 = c22 * inverse_D6_p248 - s22 * inverse_D6_p263;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p36_lanes = inverse_D6_p340_lanes + inverse_D6_p416_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D3_p3 = inverse_D6_p236 - c22 * inverse_D6_p264;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p456_lanes = inverse_D6_p439_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p435_lanes + 0.226 *
      inverse_D6_p400_lanes);
  const Lanes<2> inverse_D5_p38_lanes = inverse_D5_p11_lanes - inverse_D6_p346_lanes -
      (inverse_D5_p22_lanes + inverse_D5_p16_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p4 = inverse_D3_p1 * inverse_D21;
  const Real inverse_D6_p458 = c21 * inverse_D6_p454;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p40_lanes = inverse_D6_p422_lanes + inverse_D6_p348_lanes;
  const Lanes<2> inverse_D5_p46_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p420_lanes -
      detail::make_pack<Real>(c7, c14) * inverse_D6_p414_lanes;
  const Real inverse_D5_p48 = inverse_D5_p38_lanes[1] + inverse_D5_p38_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p49 = inverse_D6_p299 - inverse_D6_p275 * inverse_D5_p6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p461_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D6_p439_lanes + inverse_D6_p456_lanes);
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
  const Real inverse_D5_p57 = inverse_D6_p298 + inverse_D6_p275 * inverse_D5_p13;
  const Real inverse_D5_p60 = c21 * inverse_D5_p56;
  const Real inverse_D3_p5 = inverse_D6_p304 * inverse_D3_p4 -
      (inverse_D6_p250 + inverse_D6_p210 + 0.394 * inverse_D3_p2);
  const Real inverse_D5_p61 = s21 * inverse_D5_p56;
  const Real inverse_D3_p6 = inverse_D6_p285 * inverse_D3_p4 -
      (0.0045000000000000005 + 0.394 * inverse_D3_p3);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p62 = s21 * inverse_D6_p454 + inverse_D6_p428 + 0.226 * inverse_D5_p48;
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
  const Real inverse_D6_p463 = 2.06965463592404 + inverse_D6_p427 + inverse_D6_p458 +
      inverse_D6_p390_lanes[1] + inverse_D6_p453 + inverse_D6_p461_lanes[1] +
      inverse_D6_p390_lanes[0] + inverse_D6_p461_lanes[0] + 0.226 *
      (inverse_D6_p447_lanes[1] + inverse_D6_p455 + inverse_D6_p447_lanes[0]);
  const Real inverse_D3_p7 = inverse_D5_p61 + inverse_D5_p35 - 6.1665928899999995 - inverse_D6_p455;

  // link 6 (chest3), articulated inertia
  const Real inverse_D3_p8 = inverse_D5_p14_lanes[1] + inverse_D5_p14_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p9 = inverse_D6_p275 * inverse_D3_p4 - inverse_D3_p3;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D3_p10 = c21 * inverse_D3_p5 - s21 * inverse_D3_p6 + inverse_D6_p456_lanes[1] +
      inverse_D6_p456_lanes[0];
  const Lanes<2> inverse_D3_p11_lanes = inverse_D5_p22_lanes - inverse_D5_p20_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p463;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p70 = 0.0187369177636143 + inverse_D5_p50_lanes[1] -
      inverse_D6_p394_lanes[1] + inverse_D5_p25_lanes[1] + inverse_D5_p50_lanes[0] -
      inverse_D6_p394_lanes[0] + inverse_D5_p25_lanes[0] + 0.226 * inverse_D5_p55;

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
  const Real inverse_D5_p75 = 0.40056549999999996 - inverse_D6_p291_lanes[1] - inverse_D6_p453 +
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
  const Real inverse_D5_p78 = 1.66923963592404 + inverse_D6_p426 - inverse_D6_p458 -
      inverse_D5_p62 * inverse_D5_p72 + 0.051076 * inverse_D5_p65;
  const Real inverse_D3_p22 = inverse_D6_p435_lanes[1] -
      (inverse_D6_p226 + inverse_D6_p282 + inverse_D3_p1 * inverse_D3_p4) +
      inverse_D6_p435_lanes[0] - inverse_D3_p10 * inverse_D3_p14;
  const Real inverse_D5_p79 = (-0.04068) * inverse_D5_p36_lanes[1] + 0.04068 *
      inverse_D5_p36_lanes[0] - inverse_D5_p70 * inverse_D5_p72 + 0.226 *
      (inverse_D5_p40_lanes[1] + inverse_D5_p40_lanes[0]);
  const Real inverse_D3_p23 = inverse_D5_p62 * inverse_D3_p14 -
      (s21 * inverse_D3_p5 + c21 * inverse_D3_p6) + 0.226 * inverse_D3_p8;
  const Real inverse_D3_p24 = inverse_D5_p49 - inverse_D5_p68 + inverse_D6_p412_lanes[1] +
      inverse_D6_p412_lanes[0] - inverse_D3_p7 * inverse_D3_p15;
  const Real inverse_D3_p25 = inverse_D6_p400_lanes[1] -
      (s21 * inverse_D3_p9 + c21 * inverse_D3_p13) + inverse_D6_p400_lanes[0] + inverse_D3_p10 *
      inverse_D3_p15;
  const Real inverse_D3_p26 = c6 * inverse_D3_p20 - s6 * inverse_D3_p21;
  const Real inverse_D5_p80 = s6 * inverse_D5_p74 + c6 * inverse_D5_p77;
  const Real inverse_D4_p1 = s6 * inverse_D3_p20 + c6 * inverse_D3_p21;
  const Real inverse_D4_p2 = c6 * inverse_D5_p74 - s6 * inverse_D5_p77;
  const Real inverse_D2_p1 = 0.0300000063 * s4;
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
  const Real inverse_D3_p32 = 0.03561389675370483 * s4;
  const Real inverse_D3_p33 = c6 * inverse_D3_p28 - inverse_D3_p25;
  const Real inverse_D4_p5 = inverse_D3_p24 + inverse_D3_p31;
  const Real inverse_D4_p6 = inverse_D3_p30 - inverse_D3_p23;
  const Real inverse_D4_p7 = c6 * inverse_D5_p82 - inverse_D5_p79 + 0.072 * inverse_D4_p2;
  const Real inverse_D4_p8 = inverse_D3_p18 + inverse_D4_p4 + inverse_D4_p3;
  const Real inverse_D2_p2 = 0.0300000063 * c4;
  const Real inverse_D3_p34 = 0.069699984375 + (inverse_D3_p30 - inverse_D3_p19 + 0.072 *
      inverse_D3_p26);
  const Real inverse_D4_p9 = 0.072 * inverse_D4_p8;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p78 + inverse_D5_p83 + 0.072 * (inverse_D5_p80 + inverse_D5_p81)));

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p3 = 0.02999999505 + inverse_D2_p2;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p35 = inverse_D3_p29 * inverse_D5;
  const Real inverse_D3_p36 = inverse_D3_p34 * inverse_D5;
  const Real inverse_D3_p37 = inverse_D4_p8 * inverse_D5;
  const Real inverse_D4_p10 = inverse_D4_p9 * inverse_D5;
  const Real inverse_D4_p11 = inverse_D4_p7 * inverse_D5;
  const Real inverse_D3_p38 = inverse_D3_p22 - inverse_D3_p31 - inverse_D3_p34 * inverse_D3_p36;
  const Real inverse_D3_p39 = inverse_D5_p76 - inverse_D3_p29 * inverse_D3_p35;
  const Real inverse_D3_p40 = inverse_D3_p26 - inverse_D3_p29 * inverse_D3_p36;
  const Real a3_x_p1 = 0.422 * c2;
  const Real a3_y_p1 = s2 * c3 + c2 * s3;
  const Real inverse_D3_p41 = inverse_D4_p9 * inverse_D3_p35 - inverse_D4_p3;
  const Real inverse_D3_p42 = inverse_D3_p17 - inverse_D4_p4 - inverse_D4_p7 * inverse_D3_p36;
  const Real a3_x_p2 = 0.422 * s2;
  const Real inverse_D3_p43 = inverse_D4_p2 - inverse_D4_p7 * inverse_D3_p35;
  const Real inverse_D3_p44 = inverse_D4_p9 * inverse_D3_p36 - 0.072 * inverse_D3_p33;
  const Real inverse_D3_p45 = inverse_D3_p33 - inverse_D3_p34 * inverse_D3_p37;
  const Real inverse_D3_p46 = inverse_D4_p1 - inverse_D3_p29 * inverse_D3_p37;
  const Real a3_x_p3 = c2 * c3 - s2 * s3;
  const Real inverse_D4_p12 = 0.15637308509675518 + 0.005183999999999999 * inverse_D4_p5 -
      inverse_D4_p9 * inverse_D4_p10;
  const Real inverse_D4_p13 = 0.04675382692737882 + (inverse_D5_p75 - inverse_D5_p83) -
      inverse_D4_p7 * inverse_D4_p11;
  const Real inverse_D4_p14 = 0.005678398088837119 - 0.072 * inverse_D4_p6 + inverse_D4_p9 *
      inverse_D4_p11;

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p47 = inverse_D4_p6 - 0.069699984375 - inverse_D4_p7 * inverse_D3_p37;
  const Real inverse_D3_p48 = inverse_D4_p9 * inverse_D3_p37 -
      (2.2194301519999997 + 0.072 * inverse_D4_p5);

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p49 = s5 * (inverse_D3_p39 - inverse_D3_p38) + inverse_D3_p16 *
      inverse_D3_p40;
  const Real inverse_D3_p50 = s5 * (inverse_D3_p41 - inverse_D3_p42) + c5 *
      (inverse_D3_p43 + inverse_D3_p44);

  // link 5 (chest2), outward
  const Real minus_w5_y_p1 = s4 * w3_z;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p51 = s5 * inverse_D3_p49;
  const Real inverse_D4_p15 = s5 * (inverse_D4_p12 - inverse_D4_p13) + inverse_D3_p16 *
      inverse_D4_p14;
  const Real inverse_D1_p1 = 0.031999971599999996 * s2 - 24.5839218 * c2;
  const Real inverse_D3_p52 = s5 * inverse_D3_p50;
  const Real inverse_D3_p53 = s5 * inverse_D3_p47 - c5 * inverse_D3_p48;
  const Real inverse_D3_p54 = c5 * inverse_D3_p50;

  // link 5 (chest2), outward
  const Real w5_z = c4 * w3_z + qd[4];

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p55 = inverse_D3_p39 - inverse_D3_p51;

  // link 4 (chest1), outward
  const Real wd4_x = w3_z * qd[3];

  // link 5 (chest2), articulated inertia
  const Real inverse_D4_p16 = s5 * inverse_D4_p15;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * minus_w5_y_p1 + c5 * qd[3];
  const Real w5_x = c5 * minus_w5_y_p1 - s5 * qd[3];

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p4 = inverse_D3_p42 + inverse_D3_p52;

  // link 5 (chest2), outward
  const Real wd6_x_p1 = c4 * wd4_x;
  const Real minus_wd5_z = s4 * wd4_x;
  const Real wd6_x_p2 = w5_x * minus_w5_y;

  // link 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p56 = c4 * (2.0 * (s5 * inverse_D3_p45 - c5 * inverse_D3_p46)) - s4 *
      (inverse_D3_p55 - (inverse_D4_p5 - inverse_D4_p8 * inverse_D3_p37));
  const Real inverse_D3_p57 = s4 * (s5 * inverse_D3_p48 + c5 * inverse_D3_p47) - c4 *
      (inverse_D3_p54 - inverse_D3_p44);

  // link 5 (chest2), outward
  const Real wd6_x_p3 = wd6_x_p2 + minus_wd5_z;

  // link 6 (chest3), outward
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p13 + inverse_D4_p16));

  // link 5 (chest2), outward
  const Real wd6_x_p4 = s5 * wd6_x_p1 + (w5_z + qd[4]) * w5_x;
  const Real wd5_x = c5 * wd6_x_p1 - minus_w5_y * qd[4];

  // link 6 (chest3), outward
  const Real wd6_x_p5 = w6_y * w6_z;
  const Real n12_z_p1 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);

  // link 6 (chest3), outward
  const Real wd6_y_p1 = w6_x * w6_z;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p58 = inverse_D3_p53 - c4 *
      (c4 * inverse_D3_p53 - s4 * (inverse_D3_p41 - inverse_D3_p52));
  const Real inverse_D3_p59 = inverse_D3_p55 + s4 * inverse_D3_p56;
  const Real inverse_D3_p60 = 0.21799999999999997 * inverse_D3_p57 +
      (0.005880002159562879 - (c5 * inverse_D4_p15 - inverse_D4_p14)) * s4;
  const Real inverse_D2_p5 = inverse_D2_p1 + inverse_D3_p57;
  const Real inverse_D2_p6 = s4 * (s5 * inverse_D3_p46 + c5 * inverse_D3_p45) - c4 *
      (c5 * inverse_D3_p49 - inverse_D3_p40);

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;

  // link 6 (chest3), outward
  const Real n12_z_p2 = n12_z_p1 - wd5_x;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // link 6 (chest3), outward
  const Real wd6_x_p6 = s6 * wd6_x_p3 + c6 * wd6_x_p4;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n12_z_p5_lanes = w7_x_lanes * w7_y_lanes;
  const Lanes<2> wd7_x_p2_lanes = w7_y_lanes * w7_z_lanes;

  // link 6 (chest3), outward
  const Real wd6_x = wd6_x_p5 - wd6_x_p6;
  const Real wd6_y = s6 * wd6_x_p4 - c6 * wd6_x_p3 - wd6_y_p1;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p61 = inverse_D3_p58 + 0.21799999999999997 * inverse_D3_p59;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p62 = inverse_D3_p60 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p5 * inverse_D4;
  const Real inverse_D2_p8 = inverse_D2_p4 * inverse_D4;

  // link 6 (chest3), outward
  const Real n12_z_p7 = wd6_x_p5 + wd6_x;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n12_z_p8_lanes = n12_z_p5_lanes + wd6_y;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;
  const Lanes<2> n12_z_p12_lanes = w8_x_lanes * w8_y_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_x_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_p2_lanes = w8_y_lanes * w8_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n12_z_p13_lanes = detail::make_pack<Real>(s7, s14) * n12_z_p2 +
      detail::make_pack<Real>(c7, c14) * n12_z_p7;
  const Lanes<2> wd7_x_p4_lanes = detail::make_pack<Real>(c7, c14) * n12_z_p2 -
      detail::make_pack<Real>(s7, s14) * n12_z_p7;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_y_lanes = detail::make_pack<Real>(c9, c16) * w8_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_z_lanes;
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n12_z_p15_lanes = 2.0 * (w7_x_lanes * w7_z_lanes) - n12_z_p13_lanes;
  const Lanes<2> wd7_x_lanes = wd7_x_p2_lanes - wd7_x_p4_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p9 = inverse_D2_p3 + 0.21799999999999997 * inverse_D2_p6 - s4 *
      (inverse_D3_p54 - inverse_D3_p43) - inverse_D3_p60 * inverse_D2_p8;

  // link 9 (left_upperarm), outward
  const Lanes<2> n12_z_p17_lanes = w9_x_lanes * w9_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);

  // link 2 (thigh), outward
  const Real a3_x_p4 = w2_z * w2_z;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_wd9_y_p1_lanes = w9_x_lanes * w9_z_lanes;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n12_z_p19_lanes = n12_z_p12_lanes + wd7_x_lanes;

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p10 = 8.419374554 + (inverse_D3_p61 - inverse_D3_p60 * inverse_D2_p7);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;

  // link 3 (hip), outward
  const Real a5_y_p1 = w3_z * w3_z;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n12_z_p22_lanes = detail::make_pack<Real>(c8, c15) * n12_z_p8_lanes +
      detail::make_pack<Real>(s8, s15) * n12_z_p15_lanes;
  const Lanes<2> wd8_x_p4_lanes = detail::make_pack<Real>(c8, c15) * n12_z_p15_lanes -
      detail::make_pack<Real>(s8, s15) * n12_z_p8_lanes;

  // link 5 (chest2), outward
  const Real a6_x_p1 = w5_x * w5_x;
  const Real a6_x_p2 = w5_z * w5_z;

  // link 3 (hip), outward
  const Real a3_x_p5 = minus_a1_x + a3_x_p4 * a3_x_p2;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n12_z_p24_lanes = 2.0 * (w8_x_lanes * w8_z_lanes) - n12_z_p22_lanes;
  const Lanes<2> wd8_x_lanes = wd8_x_p2_lanes - wd8_x_p4_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n12_z_p25_lanes = w10_x_lanes * minus_w10_y_lanes;

  // link 2 (thigh), outward
  const Real a2_y = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 6 (chest3), outward
  const Real a7_y_p1 = w6_z * w6_z;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_z_lanes = minus_w10_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);

  // link 5 (chest2), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;

  // link 5 (chest2), outward
  const Real a6_x_p4 = wd5_x - minus_w5_y * w5_z;

  // link 3 (hip), outward
  const Real a3_x_p6 = a2_y + a3_x_p4 * a3_x_p1;

  // link 5 (chest2), outward
  const Real a6_z_p1 = minus_wd5_z - wd6_x_p2;

  // link 9 (left_upperarm), outward
  const Lanes<2> n12_z_p28_lanes = n12_z_p17_lanes + wd8_x_lanes;

  // link 6 (chest3), outward
  const Real a7_y_p3 = wd6_y_p1 - wd6_y;
  const Real a7_y_p4 = w6_y * w6_y + a7_y_p1;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n12_z_p29_lanes = detail::make_pack<Real>(s9, s16) * n12_z_p24_lanes -
      detail::make_pack<Real>(c9, c16) * n12_z_p19_lanes;

  // link 6 (chest3), outward
  const Real minus_a7_z_p1 = n12_z_p1 + wd5_x;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_wd9_y_p4_lanes = detail::make_pack<Real>(s9, s16) * n12_z_p19_lanes +
      detail::make_pack<Real>(c9, c16) * n12_z_p24_lanes;

  // link 6 (chest3), outward
  const Real minus_a7_z_p2 = w6_x * w6_x;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_p2_lanes = w10_x_lanes * w10_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n12_z_p32_lanes = w11_x_lanes * w11_y_lanes;

  // link 3 (hip), outward
  const Real a3_x = a3_y_p1 * a3_x_p6 - a3_x_p3 * a3_x_p5;
  const Real a3_y = a3_y_p1 * a3_x_p5 + a3_x_p3 * a3_x_p6;

  // link 9 (left_upperarm), outward
  const Lanes<2> n12_z_p33_lanes = 2.0 * (w9_y_lanes * w9_z_lanes) - n12_z_p29_lanes;
  const Lanes<2> minus_wd9_y_lanes = minus_wd9_y_p4_lanes + minus_wd9_y_p1_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p2_lanes = w8_y_lanes * w8_y_lanes;

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = minus_a7_z_p2 + a7_y_p1;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p3_lanes = w8_z_lanes * w8_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);

  // link 5 (chest2), outward
  const Real a5_y_p2 = c4 * a3_x;
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * a5_y_p1;
  const Real minus_a5_z = s4 * a3_x;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n12_z_p36_lanes = minus_wd9_y_lanes - n12_z_p25_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_wd11_y_p1_lanes = w11_x_lanes * w11_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_z_p37_lanes = 2.0 * w12_z_lanes;
  const Lanes<2> n13_z_p2_lanes = w12_z_lanes * w12_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p4_lanes = a10_x_p2_lanes + a10_x_p3_lanes;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p63 = 1.7947593951550056 + 0.21799999999999997 *
      (inverse_D3_p58 + inverse_D3_p61) - inverse_D3_p60 * inverse_D3_p62 +
      (inverse_D3_p32 + s4 * (inverse_D4_p12 - inverse_D4_p16)) * s4;

  // link 6 (chest3), outward
  const Real a6_x_p5 = minus_a5_z + 0.072 * a6_x_p4;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n12_z_p38_lanes = detail::make_pack<Real>(s10, s17) * n12_z_p28_lanes +
      detail::make_pack<Real>(c10, c17) * n12_z_p33_lanes;
  const Lanes<2> wd10_y_p4_lanes = detail::make_pack<Real>(c10, c17) * n12_z_p28_lanes -
      detail::make_pack<Real>(s10, s17) * n12_z_p33_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_z_p40_lanes = w12_x_lanes * minus_w12_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p1_lanes = w10_x_lanes * w10_x_lanes;
  const Lanes<2> minus_a12_y_p2_lanes = w10_z_lanes * w10_z_lanes;
  const Lanes<2> n12_z_p42_lanes = n12_z_p38_lanes - 2.0 * (minus_w10_y_lanes * w10_z_lanes);

  // link 12 (left_wrist2), outward
  const Lanes<2> n13_z_p3_lanes = minus_w12_y_lanes * w12_z_lanes;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p3 - s5 * a5_y_p2;
  const Real a5_x = c5 * a5_y_p2 + s5 * a5_y_p3;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_lanes = wd10_y_p4_lanes - wd10_y_p2_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n13_z_p4_lanes = minus_w12_y_lanes * minus_w12_y_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / inverse_D3_p63;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p3_lanes = minus_a12_y_p1_lanes + minus_a12_y_p2_lanes;

  // link 6 (chest3), outward
  const Real a6_x_p6 = a5_y + 0.072 * a6_x_p3;
  const Real a6_z = a5_x - 0.072 * a6_z_p1;

  // link 11 (left_wrist1), outward
  const Lanes<2> n12_z_p44_lanes = n12_z_p32_lanes + wd10_y_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n13_z_p6_lanes = n13_z_p2_lanes - n13_z_p4_lanes;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p6 = a6_z - 0.226 * a7_y_p3;

  // link 11 (left_wrist1), outward
  const Lanes<2> n12_z_p45_lanes = detail::make_pack<Real>(s11, s18) * n12_z_p36_lanes -
      detail::make_pack<Real>(c11, c18) * n12_z_p42_lanes;
  const Lanes<2> minus_wd11_y_p4_lanes = detail::make_pack<Real>(c11, c18) * n12_z_p36_lanes +
      detail::make_pack<Real>(s11, s18) * n12_z_p42_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> n13_x_p1_lanes = w13_z_lanes * w13_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p7_lanes = a7_y_p6 + detail::make_pack<Real>(0.18, (-0.18)) * n12_z_p7;

  // link 11 (left_wrist1), outward
  const Lanes<2> n12_z_p50_lanes = 2.0 * (w11_y_lanes * w11_z_lanes) - n12_z_p45_lanes;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a6_x_p6 - s6 * a6_x_p5;
  const Real minus_a6_y = s6 * a6_x_p6 + c6 * a6_x_p5;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_wd11_y_lanes = minus_wd11_y_p4_lanes + minus_wd11_y_p1_lanes;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p9 = a6_x + 0.226 * a7_y_p4;
  const Real minus_a7_z_p5 = minus_a6_y + 0.226 * minus_a7_z_p1;

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_z_p54_lanes = n12_z_p40_lanes + minus_wd11_y_lanes;
  const Lanes<2> n12_y_p1_lanes = minus_wd11_y_lanes - n12_z_p40_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_z_p4_lanes = w11_y_lanes * w11_y_lanes;
  const Lanes<2> n11_z_p5_lanes = w11_x_lanes * w11_x_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p11 = inverse_D2_p9 * inverse_D3;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p10_lanes = a7_y_p9 + detail::make_pack<Real>(0.18, (-0.18)) * n12_z_p2;
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p5 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p3;

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_z_p55_lanes = detail::make_pack<Real>(c12, c19) * n12_z_p44_lanes -
      detail::make_pack<Real>(s12, s19) * n12_z_p50_lanes;
  const Lanes<2> n12_z_p56_lanes = detail::make_pack<Real>(s12, s19) * n12_z_p44_lanes +
      detail::make_pack<Real>(c12, c19) * n12_z_p50_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> n12_z_p57_lanes = 2.0 * (minus_w12_y_lanes * w13_z_lanes) - n12_z_p54_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p3_lanes = (n13_x_p1_lanes - n13_z_p2_lanes) * inverse_D12_p5_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p12 = inverse_D2_p10 * inverse_D3;

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_z_p59_lanes = n12_z_p37_lanes * w12_x_lanes - n12_z_p55_lanes;
  const Lanes<2> wd12_x_lanes = n12_z_p56_lanes - n13_z_p3_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n12_z_p62_lanes = (n13_z_p4_lanes - n13_x_p1_lanes) * inverse_D11_p3_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p9_lanes = 9.600000000000003e-06 * n12_z_p32_lanes + 0.00022920000000000001 *
      wd10_y_lanes + 0.000144 * n12_z_p45_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p10_lanes -
      detail::make_pack<Real>(s7, s14) * a7_y_p7_lanes;
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p10_lanes +
      detail::make_pack<Real>(c7, c14) * a7_y_p7_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> n12_z_p66_lanes = n12_z_p37_lanes * w13_z_lanes - n12_z_p59_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n13_x_p5_lanes = wd12_x_lanes - n13_z_p3_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p13 = inverse_D2_p10 * inverse_D2_p11 -
      (inverse_D2_p6 - inverse_D2_p5 * inverse_D2_p8);
  const Real inverse_D2_p14 = inverse_D3_p59 - inverse_D2_p5 * inverse_D2_p7 - inverse_D2_p10 *
      inverse_D2_p12;
  const Real inverse_D2_p15 = inverse_D3_p38 + inverse_D3_p51 - inverse_D2_p4 * inverse_D2_p8 -
      inverse_D2_p9 * inverse_D2_p11;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_z_lanes;
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p12_lanes = 0.0009386316083993107 * wd12_x_lanes - n13_z_p3_lanes *
      (inverse_D12_p10_lanes - inverse_D11_p9_lanes) + n12_z_p59_lanes * inverse_D11_p3_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p6_lanes = 0.282 * a10_x_p4_lanes - a8_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n12_z_p70_lanes = n12_z_p57_lanes * inverse_D12_p10_lanes - n12_z_p56_lanes *
      inverse_D12_p5_lanes - n12_z_p66_lanes * inverse_D11_p7_lanes + n12_z_p62_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p1_lanes = minus_wd11_y_p1_lanes + minus_wd11_y_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p10_lanes = n12_z_p66_lanes * inverse_D11_p9_lanes - n12_z_p57_lanes *
      inverse_D11_p7_lanes - n13_x_p5_lanes * inverse_D11_p3_lanes + n13_x_p3_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p2_lanes = w11_z_lanes * w11_z_lanes;
  const Lanes<2> n11_x_p4_lanes = n12_z_p32_lanes - wd10_y_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p16 = a3_y_p1 * (inverse_D2_p14 - inverse_D2_p15) + a3_x_p3 *
      (2.0 * inverse_D2_p13);

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p8_lanes = a9_x_lanes + 0.282 * minus_wd9_y_p4_lanes;
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * n12_z_p29_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p73_lanes = n12_z_p70_lanes - 0.000183627662257343 * n12_z_p40_lanes -
      0.000206827662257343 * minus_wd11_y_lanes - detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * n12_z_p55_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_lanes = n12_z_p66_lanes * inverse_D10_p4_lanes - n12_z_p57_lanes *
      inverse_D10_p2_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> f12_z_lanes = 0.0025100003499999995 * n12_z_p59_lanes -
      (n13_z_p4_lanes + n13_x_p1_lanes) * inverse_D10_p4_lanes + inverse_D10_p8_lanes *
      n13_x_p5_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p9_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (n11_x_p2_lanes - n11_z_p4_lanes);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = a3_y_p1 * inverse_D2_p16;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_lanes = detail::make_pack<Real>(c10, c17) * a10_x_p8_lanes -
      detail::make_pack<Real>(s10, s17) * a10_x_p6_lanes;
  const Lanes<2> minus_a10_y_lanes = detail::make_pack<Real>(s10, s17) * a10_x_p8_lanes +
      detail::make_pack<Real>(c10, c17) * a10_x_p6_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p18 = a3_x_p3 * inverse_D2_p16 - inverse_D2_p13;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p6_lanes = minus_a10_y_lanes + 0.269 * minus_a12_y_p3_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> minus_f13_x_lanes = (n13_z_p2_lanes + n13_x_p1_lanes) * inverse_D10_p2_lanes +
      n12_z_p56_lanes * inverse_D10_p4_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> f12_x_lanes = 0.0006000000000000001 * n12_y_p1_lanes - 0.0025100003499999995 *
      (n13_z_p4_lanes + n13_z_p2_lanes) + f13_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p6_lanes = 0.000144 * (n11_z_p5_lanes - n11_x_p2_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_z_p4_lanes = minus_w10_y_lanes * minus_w10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p13_lanes = 0.0001194 * n12_z_p50_lanes +
      detail::make_pack<Real>(6e-06, (-6e-06)) * n11_x_p1_lanes + 0.000144 * n11_x_p4_lanes +
      n11_x_p9_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p5_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * wd10_y_p4_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p10_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      n12_z_p44_lanes - 0.0001098 * n11_x_p1_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) *
      n12_z_p50_lanes - n11_y_p6_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p8_lanes = a11_x_lanes + 0.269 * minus_wd11_y_p4_lanes;
  const Lanes<2> minus_a12_z_lanes = minus_a11_y_lanes + 0.269 * n12_z_p45_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> minus_f12_y_lanes = 0.0025100003499999995 * n12_z_p54_lanes +
      0.0006000000000000001 * (w12_x_lanes * w12_x_lanes + n13_z_p2_lanes) + minus_f13_x_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p19 = inverse_D2_p14 - inverse_D2_p17;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p1_lanes = wd10_y_p2_lanes - wd10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p15_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p12_lanes = 0.06032654142055946 * n12_z_p25_lanes - 0.060888541114265754 *
      minus_wd9_y_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      n12_z_p38_lanes - n10_z_p5_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p4_lanes = n12_z_p25_lanes + minus_wd9_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p13_lanes = 0.0014999985000000002 * minus_a10_y_lanes + 0.28049749700000004 *
      a10_x_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p8_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p6_lanes;
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p8_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p6_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p16_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      minus_wd11_y_p4_lanes - n11_z_p9_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (n11_z_p4_lanes - n11_z_p5_lanes) - n11_z_p15_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_y_p13_lanes = detail::make_pack<Real>(c12, c19) * f12_x_lanes +
      detail::make_pack<Real>(s12, s19) * minus_f12_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p8_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * (minus_a12_y_p2_lanes - n10_z_p4_lanes);
  const Lanes<2> n10_y_p6_lanes = detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * (minus_a12_y_p1_lanes - minus_a12_y_p2_lanes);

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_z_p3_lanes = w9_y_lanes * w9_y_lanes;
  const Lanes<2> n9_z_p4_lanes = w9_x_lanes * w9_x_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p6_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * minus_wd9_y_p4_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p17_lanes = inverse_D10_p4_lanes * minus_a12_y_lanes - inverse_D10_p2_lanes *
      minus_a12_z_lanes;
  const Lanes<2> n13_x_lanes = n13_x_p10_lanes + inverse_D10_p4_lanes * a12_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p11_lanes = 0.06060754126741261 * n12_z_p42_lanes + 0.0001499998887063 *
      n10_x_p1_lanes + detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      n10_x_p4_lanes + n10_x_p8_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_lanes = n13_z_p12_lanes + n12_z_p54_lanes * inverse_D12_p5_lanes +
      n13_z_p6_lanes * inverse_D11_p7_lanes + n13_z_p17_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_lanes = n12_z_p73_lanes - 0.0025100003499999995 * minus_a12_y_lanes -
      inverse_D10_p8_lanes * a12_x_lanes;
  const Lanes<2> n12_y_lanes = detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * n12_y_p1_lanes - 0.000195227662257343 * n12_z_p59_lanes +
      0.0025100003499999995 * minus_a12_z_lanes + n13_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p9_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * n12_z_p36_lanes - 0.00028099984685315 * n10_x_p1_lanes -
      0.0001499998887063 * n12_z_p42_lanes + n10_y_p6_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p12_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p1_lanes = detail::make_pack<Real>(tau[12], tau[19]) - n13_z_lanes;
  const Lanes<2> qdd_0_p3_lanes = detail::make_pack<Real>(tau[11], tau[18]) - n12_z_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_x_lanes = 1.16e-05 * n13_x_p5_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * n13_z_p6_lanes -
      0.0006000000000000001 * minus_a12_z_lanes + n13_z_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p14_lanes = 0.0005895000784280001 * n12_z_p29_lanes -
      (0.001140794814995722 * n12_z_p17_lanes + 0.0027762933559338653 * wd8_x_lanes) +
      n9_z_p6_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_y_lanes = n11_y_p10_lanes - 6e-04 * minus_a10_y_lanes +
      (n12_z_lanes - 0.269 * n11_y_p13_lanes);

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p1_lanes = minus_wd9_y_p1_lanes + minus_wd9_y_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p17_lanes = qdd_0_p3_lanes + inverse_D12_p7_lanes * qdd_0_p1_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p3_lanes = n12_z_p17_lanes - wd8_x_lanes;
  const Lanes<2> n9_x_p4_lanes = w9_z_lanes * w9_z_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p23_lanes = inverse_D10_p19_lanes * qdd_0_p17_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_z_lanes = n11_z_p16_lanes - (detail::make_pack<Real>(s12, s19) * n12_x_lanes +
      detail::make_pack<Real>(c12, c19) * n12_y_lanes);
  const Lanes<2> n11_x_p18_lanes = 0.269 * f12_z_lanes -
      (detail::make_pack<Real>(s12, s19) * n12_y_lanes - detail::make_pack<Real>(c12, c19) *
      n12_x_lanes);
  const Lanes<2> f11_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * n12_z_p44_lanes - 6e-04 *
      (n11_z_p4_lanes + n11_x_p2_lanes) + n11_y_p13_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p27_lanes = inverse_D11_p14_lanes * qdd_0_p17_lanes - inverse_D11_p5_lanes *
      qdd_0_p1_lanes;
  const Lanes<2> qdd_0_p29_lanes = inverse_D10_p18_lanes * qdd_0_p17_lanes - inverse_D10_p1_lanes *
      qdd_0_p1_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p33_lanes = detail::make_pack<Real>(tau[10], tau[17]) - n11_z_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p35_lanes = inverse_D10_p3_lanes * qdd_0_p1_lanes + inverse_D10_p20_lanes *
      qdd_0_p17_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_x_lanes = n11_x_p13_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_y_lanes + n11_x_p18_lanes;
  const Lanes<2> f11_y_lanes = 6e-04 * n11_x_p4_lanes - detail::make_pack<Real>(0.001, (-0.001)) *
      (n11_z_p5_lanes + n11_x_p2_lanes) + f12_z_lanes;
  const Lanes<2> f11_z_p5_lanes = detail::make_pack<Real>(c12, c19) * minus_f12_y_lanes -
      detail::make_pack<Real>(s12, s19) * f12_x_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_y_lanes = n10_y_p9_lanes + 0.0014999985000000002 * minus_a10_z_lanes -
      n11_z_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> f11_z_lanes = 6e-04 * n11_x_p1_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      n12_z_p50_lanes + f11_z_p5_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p51_lanes = detail::make_pack<Real>(c12, c19) * qdd_0_p23_lanes +
      detail::make_pack<Real>(s12, s19) * qdd_0_p29_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_z_p18_lanes = detail::make_pack<Real>(s11, s18) * n11_x_lanes +
      detail::make_pack<Real>(c11, c18) * n11_y_lanes;
  const Lanes<2> f10_x_p7_lanes = detail::make_pack<Real>(c11, c18) * f11_x_lanes -
      detail::make_pack<Real>(s11, s18) * f11_y_lanes;
  const Lanes<2> minus_f10_y_lanes = 0.0014999985000000002 * n10_x_p4_lanes + 0.28049749700000004 *
      minus_a12_y_p3_lanes + f11_z_lanes;
  const Lanes<2> f10_z_p6_lanes = detail::make_pack<Real>(s11, s18) * f11_x_lanes +
      detail::make_pack<Real>(c11, c18) * f11_y_lanes;

  // link 11 (left_wrist1), bias force
  const Lanes<2> qdd_0_p57_lanes = qdd_0_p33_lanes +
      (detail::make_pack<Real>(s12, s19) * qdd_0_p1_lanes + detail::make_pack<Real>(c12, c19) *
      qdd_0_p27_lanes);

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_z_lanes = n10_z_p12_lanes + 0.0001499998887063 *
      (n10_z_p4_lanes - minus_a12_y_p1_lanes) - n10_z_p13_lanes + n10_z_p18_lanes;
  const Lanes<2> n10_x_lanes = n10_x_p11_lanes - 0.28049749700000004 * minus_a10_z_lanes +
      (detail::make_pack<Real>(c11, c18) * n11_x_lanes - detail::make_pack<Real>(s11, s18) *
      n11_y_lanes);
  const Lanes<2> f10_x_lanes = 0.28049749700000004 * n12_z_p36_lanes - 0.0014999985000000002 *
      (n10_z_p4_lanes + minus_a12_y_p2_lanes) + f10_x_p7_lanes;

  // link 11 (left_wrist1), bias force
  const Lanes<2> qdd_0_p63_lanes = inverse_D10_p73_lanes * qdd_0_p57_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p73_lanes = detail::make_pack<Real>(tau[9], tau[16]) - n10_z_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> f10_z_lanes = 0.0014999985000000002 * n10_x_p1_lanes + 0.28049749700000004 *
      n12_z_p42_lanes + f10_z_p6_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p12_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (n9_x_p4_lanes - n9_z_p3_lanes);
  const Lanes<2> n9_y_p8_lanes = 0.0005895000784280001 * (n9_z_p4_lanes - n9_x_p4_lanes);

  // link 11 (left_wrist1), bias force
  const Lanes<2> qdd_0_p77_lanes = 0.269 * qdd_0_p35_lanes -
      (detail::make_pack<Real>(s12, s19) * qdd_0_p27_lanes - detail::make_pack<Real>(c12, c19) *
      qdd_0_p1_lanes) + qdd_0_p63_lanes;
  const Lanes<2> qdd_0_p79_lanes = qdd_0_p3_lanes + 0.269 * qdd_0_p51_lanes +
      inverse_D10_p74_lanes * qdd_0_p57_lanes;
  const Lanes<2> qdd_0_p81_lanes = qdd_0_p35_lanes + inverse_D8_p17_lanes * qdd_0_p57_lanes;
  const Lanes<2> qdd_0_p83_lanes = qdd_0_p51_lanes + inverse_D8_p16_lanes * qdd_0_p57_lanes;
  const Lanes<2> qdd_0_p85_lanes = detail::make_pack<Real>(s12, s19) * qdd_0_p23_lanes -
      detail::make_pack<Real>(c12, c19) * qdd_0_p29_lanes + inverse_D8_p18_lanes * qdd_0_p57_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_z_p19_lanes = detail::make_pack<Real>(s10, s17) * n10_x_lanes +
      detail::make_pack<Real>(c10, c17) * n10_y_lanes;
  const Lanes<2> n9_y_p10_lanes = detail::make_pack<Real>(c10, c17) * f10_x_lanes +
      detail::make_pack<Real>(s10, s17) * minus_f10_y_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p1_lanes = n12_z_p12_lanes - wd7_x_lanes;
  const Lanes<2> n8_x_p1_lanes = wd8_x_p2_lanes + wd8_x_lanes;
  const Lanes<2> n8_z_p3_lanes = w8_x_lanes * w8_x_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_z_lanes = n9_z_p14_lanes + detail::make_pack<Real>((-4.4999986458742003e-05),
      4.4999986458742003e-05) * (n9_z_p3_lanes - n9_z_p4_lanes) + n9_z_p12_lanes - n9_z_p19_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p16_lanes = 0.0019585440854647937 * n12_z_p33_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p1_lanes -
      0.0005895000784280001 * n9_x_p3_lanes + n9_x_p12_lanes;
  const Lanes<2> n9_y_p13_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * n12_z_p28_lanes - 0.0008177492704690715 * n9_x_p1_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n12_z_p33_lanes +
      n9_y_p8_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p111_lanes = detail::make_pack<Real>(tau[8], tau[15]) - n9_z_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_x_p17_lanes = 0.282 * f10_z_lanes -
      (detail::make_pack<Real>(s10, s17) * n10_y_lanes - detail::make_pack<Real>(c10, c17) *
      n10_x_lanes);

  // link 10 (left_lowerarm), bias force
  const Lanes<2> qdd_0_p113_lanes = qdd_0_p73_lanes -
      (detail::make_pack<Real>(s11, s18) * qdd_0_p77_lanes + detail::make_pack<Real>(c11, c18) *
      qdd_0_p79_lanes);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p6_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n12_z_p22_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_x_lanes = n9_x_p16_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_x_lanes + n9_x_p17_lanes;
  const Lanes<2> n9_y_lanes = n9_y_p13_lanes - 0.0022500062 * a8_x_lanes +
      (n10_z_lanes - 0.282 * n9_y_p10_lanes);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p7_lanes = 0.00010499999999999999 * (n8_z_p3_lanes - a10_x_p3_lanes);
  const Lanes<2> n8_x_p7_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (a10_x_p3_lanes - a10_x_p2_lanes);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p1_lanes = w7_y_lanes * w7_y_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p12_lanes = 0.18101044219699997 * n12_z_p12_lanes + 0.18125194219699997 *
      wd7_x_lanes + 0.00010499999999999999 * wd8_x_p4_lanes - n8_z_p6_lanes;

  // link 10 (left_lowerarm), bias force
  const Lanes<2> qdd_0_p125_lanes = detail::make_pack<Real>(c11, c18) * qdd_0_p77_lanes -
      detail::make_pack<Real>(s11, s18) * qdd_0_p79_lanes + inverse_D9_p9_lanes * qdd_0_p113_lanes;
  const Lanes<2> qdd_0_p127_lanes = inverse_D9_p7_lanes * qdd_0_p113_lanes - qdd_0_p33_lanes;
  const Lanes<2> qdd_0_p129_lanes = inverse_D8_p80_lanes * qdd_0_p113_lanes -
      (detail::make_pack<Real>(c11, c18) * qdd_0_p83_lanes + detail::make_pack<Real>(s11, s18) *
      qdd_0_p81_lanes);
  const Lanes<2> qdd_0_p131_lanes = inverse_D8_p81_lanes * qdd_0_p113_lanes - qdd_0_p85_lanes;
  const Lanes<2> qdd_0_p133_lanes = detail::make_pack<Real>(c11, c18) * qdd_0_p81_lanes -
      detail::make_pack<Real>(s11, s18) * qdd_0_p83_lanes + inverse_D8_p82_lanes * qdd_0_p113_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_z_p1_lanes = w7_x_lanes * w7_x_lanes;
  const Lanes<2> n7_x_p2_lanes = wd7_x_p2_lanes + wd7_x_lanes;
  const Lanes<2> n7_x_p3_lanes = w7_z_lanes * w7_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p15_lanes = 0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes;
  const Lanes<2> n8_y_p12_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n8_y_p1_lanes -
      0.18113119219699997 * n12_z_p24_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * n8_x_p1_lanes + n8_y_p7_lanes;
  const Lanes<2> n8_x_p10_lanes = 0.00012075 * n8_x_p1_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * n12_z_p24_lanes -
      0.00010499999999999999 * n12_z_p19_lanes + n8_x_p7_lanes;

  // link 10 (left_lowerarm), bias force
  const Lanes<2> qdd_0_p151_lanes = detail::make_pack<Real>(s10, s17) * qdd_0_p131_lanes -
      detail::make_pack<Real>(c10, c17) * qdd_0_p129_lanes;

  // link 21 (neck), outward
  const Real w21_z = qd[20] - w6_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_z_p3 = 0.000448 * wd6_y;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> qdd_0_p155_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 21 (neck), outward
  const Real w21_x = s21 * w6_y + c21 * w6_z;

  // link 9 (left_upperarm), bias force
  const Lanes<2> qdd_0_p157_lanes = qdd_0_p111_lanes +
      (detail::make_pack<Real>(s10, s17) * qdd_0_p125_lanes + detail::make_pack<Real>(c10, c17) *
      qdd_0_p127_lanes);

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_z_p17_lanes = detail::make_pack<Real>(c9, c16) * n9_x_lanes -
      detail::make_pack<Real>(s9, s16) * n9_y_lanes;

  // link 9 (left_upperarm), bias force
  const Lanes<2> qdd_0_p163_lanes = inverse_D8_p149_lanes * qdd_0_p157_lanes;

  // link 21 (neck), outward
  const Real minus_wd21_y_p1 = w21_x * w21_z;
  const Real wd22_y_p1 = w21_x * w21_y;
  const Real a22_z_p1 = s21 * a7_y_p3 - c21 * minus_a7_z_p1;

  // link 22 (head), outward
  const Real w22_z = w21_y + qd[21];

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p9_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p3_lanes - n7_x_p1_lanes);

  // link 22 (head), outward
  const Real w22_x = c22 * w21_x - s22 * w21_z;

  // link 9 (left_upperarm), bias force
  const Lanes<2> qdd_0_p169_lanes = 0.282 * qdd_0_p133_lanes -
      (detail::make_pack<Real>(s10, s17) * qdd_0_p127_lanes - detail::make_pack<Real>(c10, c17) *
      qdd_0_p125_lanes) + qdd_0_p163_lanes;
  const Lanes<2> qdd_0_p171_lanes = qdd_0_p73_lanes + 0.282 * qdd_0_p151_lanes +
      inverse_D8_p150_lanes * qdd_0_p157_lanes;

  // link 21 (neck), outward
  const Real minus_wd21_y_p2 = s21 * minus_a7_z_p1 + c21 * a7_y_p3;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_z_lanes = n8_z_p12_lanes + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (a10_x_p2_lanes - n8_z_p3_lanes) - n8_z_p15_lanes +
      n8_z_p17_lanes;

  // link 21 (neck), outward
  const Real wd22_y_p2 = wd22_y_p1 + wd6_x;

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real wd22_y_p3 = w22_x * w22_z;

  // link 21 (neck), outward
  const Real minus_wd21_y = minus_wd21_y_p2 + minus_wd21_y_p1;
  const Real a23_y_p1 = w21_x * w21_x;
  const Real a23_y_p2 = w21_z * w21_z;
  const Real wd22_y_p4 = 2.0 * (w21_y * w21_z) - a22_z_p1;

  // link 22 (head), outward
  const Real n23_x_p1 = w22_x * minus_w22_y;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real a23_y_p3 = a23_y_p1 + a23_y_p2;

  // link 22 (head), outward
  const Real a23_y_p4 = minus_w22_y * minus_w22_y;
  const Real a23_y_p5 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Lanes<2> w23_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;

  // link 22 (head), outward
  const Real a22_z = 0.394 * a22_z_p1 - minus_a21_y;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_y_lanes = n8_y_p12_lanes - 0.7139200499999999 * a7_x_lanes +
      (detail::make_pack<Real>(s9, s16) * n9_x_lanes + detail::make_pack<Real>(c9, c16) *
      n9_y_lanes);

  // link 22 (head), outward
  const Real a22_x_p1 = a6_x + 0.394 * a7_y_p4;
  const Real n23_x_p2 = minus_wd21_y - n23_x_p1;

  // link 23 (left_eye), outward
  const Lanes<2> w23_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;

  // link 22 (head), outward
  const Real a23_y_p7 = a23_y_p4 + a23_y_p5;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_x_lanes = n8_x_p10_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes - n9_z_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p11_lanes = 0.0017499999999999998 * minus_a7_z_lanes;

  // link 22 (head), outward
  const Real wd22_y_p5 = c22 * wd22_y_p2 - s22 * wd22_y_p4;
  const Real a22_x_p2 = a21_x - 0.394 * minus_wd21_y_p2;
  const Real n23_y_p1 = s22 * wd22_y_p2 + c22 * wd22_y_p4;

  // link 23 (left_eye), outward
  const Lanes<2> w23_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> n23_z_p1_lanes = w23_x_lanes * w23_y_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p12_lanes = 0.0001505 * n7_x_p2_lanes + 8.75e-06 * n12_z_p15_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * n12_z_p8_lanes +
      n7_x_p9_lanes;

  // link 22 (head), outward
  const Real wd22_y = wd22_y_p5 - wd22_y_p3;
  const Real n23_y_p2 = n23_y_p1 - 2.0 * (minus_w22_y * w22_z);

  // link 23 (left_eye), outward
  const Lanes<2> minus_f23_x_p2_lanes = w23_z_lanes * w23_z_lanes;
  const Lanes<2> n23_y_p3_lanes = 2.0 * w23_z_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p179_lanes = detail::make_pack<Real>(tau[7], tau[14]) - n8_z_lanes;

  // link 22 (head), outward
  const Real a23_y_p9 = wd22_y_p3 - wd22_y;
  const Real a22_x = c22 * a22_x_p2 + s22 * a22_x_p1;

  // link 23 (left_eye), outward
  const Lanes<2> f23_y_p1_lanes = n23_z_p1_lanes - wd22_y;

  // link 23 (left_eye), inertial wrench
  const Real n23_z_p3 = 9.25e-06 * wd22_y;

  // link 22 (head), outward
  const Real minus_a23_z_p1 = n23_x_p1 + minus_wd21_y;

  // link 24 (right_eye), outward
  const Real a23_y_p10 = a22_x - 0.095 * a23_y_p7;

  // link 23 (left_eye), outward
  const Lanes<2> n23_x_p6_lanes = detail::make_pack<Real>(s23, s24) * n23_x_p2 -
      detail::make_pack<Real>(c23, c24) * n23_y_p2;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> f23_y_lanes = 0.00025 * f23_y_p1_lanes;
  const Lanes<2> minus_f23_x_lanes = 0.00025 * (w23_y_lanes * w23_y_lanes + minus_f23_x_p2_lanes);

  // link 24 (right_eye), outward
  const Real a23_y_p11 = a22_z + 0.095 * a23_y_p9;

  // link 22 (head), outward
  const Real a22_y = c22 * a22_x_p1 - s22 * a22_x_p2;

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p10_lanes = detail::make_pack<Real>(c23, c24) * n23_x_p2 +
      detail::make_pack<Real>(s23, s24) * n23_y_p2 + n23_y_p3_lanes * w23_x_lanes;
  const Lanes<2> a23_y_p14_lanes = detail::make_pack<Real>(s23, s24) *
      (a23_y_p10 + detail::make_pack<Real>(0.032, (-0.032)) * wd22_y_p5);

  // link 24 (right_eye), outward
  const Real minus_a23_z_p3 = a22_y - 0.095 * minus_a23_z_p1;

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_z_lanes = minus_a23_z_p3 - detail::make_pack<Real>(0.032, (-0.032)) *
      n23_y_p1;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p9_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_y_lanes;

  // link 22 (head), outward
  const Real n22_z_p1 = w22_x * w22_x;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_x_lanes = 4e-06 * (n23_y_p3_lanes * w23_y_lanes - n23_x_p6_lanes) -
      2.8750000000000004e-05 * f23_y_p1_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p11_lanes = detail::make_pack<Real>(c23, c24) * f23_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_x_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_p14_lanes = 0.00025 * minus_a23_z_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_lanes = detail::make_pack<Real>(c23, c24) *
      (a23_y_p11 - detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p3) - a23_y_p14_lanes;

  // link 21 (neck), outward
  const Real n21_x_p1 = wd22_y_p1 - wd6_x;

  // link 23 (left_eye), inward
  const Real f22_y_p1 = n23_y_p10_lanes[1] + n23_y_p10_lanes[0];
  const Real n22_y_p13 = n22_y_p11_lanes[1] + n22_y_p11_lanes[0];
  const Lanes<2> n22_z_p2_lanes = detail::make_pack<Real>(s23, s24) * n23_x_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_lanes = 2.8750000000000004e-05 *
      (w23_x_lanes * w23_x_lanes - minus_f23_x_p2_lanes) - 5.25e-06 * n23_y_p10_lanes +
      n23_y_p14_lanes;

  // link 23 (left_eye), inward
  const Real f22_z = 0.072575 * a23_y_p9 - 0.43200000000000005 * n23_y_p2 + n22_y_p13;
  const Lanes<2> n22_z_p4_lanes = detail::make_pack<Real>(c23, c24) * n23_y_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_lanes = 1.2499999999999999e-06 * n23_z_p1_lanes - n23_z_p3 +
      2.8750000000000004e-05 * n23_x_p6_lanes + 0.00025 * a23_y_lanes;

  // link 21 (neck), outward
  const Real n21_y_p1 = minus_wd21_y_p1 + minus_wd21_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p1_lanes = n12_z_p5_lanes - wd6_y;

  // link 23 (left_eye), inward
  const Real n22_z_p6 = 0.04506407500000001 * n23_x_p1 - 0.06394132500000001 * minus_wd21_y -
      0.0074 * (a23_y_p4 - n22_z_p1) + 0.072575 * a22_y;
  const Real minus_f22_x = 0.072575 * a23_y_p7 + 0.43200000000000005 * n23_x_p2 +
      n22_y_p9_lanes[1] + n22_y_p9_lanes[0];
  const Real n22_y_p14 = 0.0074 * n23_y_p2 - 0.009438624999999999 * a23_y_p9 - 0.072575 * a22_z -
      n23_z_lanes[1] - (-0.032) * n22_y_p9_lanes[1];
  const Lanes<2> n22_x_p9_lanes = detail::make_pack<Real>(c23, c24) * n23_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_y_lanes + detail::make_pack<Real>(8e-06, (-8e-06)) *
      n23_y_p10_lanes;
  const Real f22_y = 0.43200000000000005 * (n22_z_p1 + a23_y_p5) - 0.072575 * minus_a23_z_p1 -
      0.00025 * f22_y_p1;

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_z_p5_lanes = detail::make_pack<Real>(c10, c17) * minus_f10_y_lanes -
      detail::make_pack<Real>(s10, s17) * f10_x_lanes;

  // link 23 (left_eye), inward
  const Real n22_x = 0.05450270000000001 * n23_y_p2 - 0.0074 * a23_y_p9 - 0.43200000000000005 *
      a22_z + n22_x_p9_lanes[1] + n22_x_p9_lanes[0];

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p7_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_z_p1_lanes - n7_x_p3_lanes);

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_z_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      n12_z_p33_lanes - 0.0022500062 * n9_x_p1_lanes + f9_z_p5_lanes;

  // link 22 (head), inward
  const Real n21_y_p2 = c22 * minus_f22_x + s22 * f22_y;

  // link 23 (left_eye), inward
  const Real n22_y = n22_y_p14 - n23_z_lanes[0] - 0.032 * n22_y_p9_lanes[0] - 0.095 * n22_y_p13;

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p1_lanes - 0.7139200499999999 * a10_x_p4_lanes - f9_z_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_x_lanes = 0.0022500062 * (n9_z_p3_lanes + n9_x_p4_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * n12_z_p28_lanes + n9_y_p10_lanes;
  const Lanes<2> f9_y_lanes = f10_z_lanes - (0.0022500062 * n9_x_p3_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (n9_z_p4_lanes + n9_x_p4_lanes));

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_p4_lanes = 0.0017499999999999998 *
      (n12_z_p8_lanes + (n7_z_p1_lanes + n7_x_p3_lanes));

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p11_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * n7_y_p1_lanes - 0.0002975 * n12_z_p15_lanes - 8.75e-06 *
      n7_x_p2_lanes + n7_y_p7_lanes;
  const Lanes<2> n7_z_p10_lanes = 0.00014700000000000002 * n12_z_p5_lanes + n7_z_p3 +
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * wd7_x_p4_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * n12_z_p13_lanes;

  // link 23 (left_eye), inward
  const Real n22_z = n22_z_p6 + 0.43200000000000005 * a22_x + n22_z_p2_lanes[1] +
      n22_z_p4_lanes[1] + n22_z_p2_lanes[0] + n22_z_p4_lanes[0] - 2.375e-05 * f22_y_p1;

  // link 1 (calf), inward
  const Real qdd_0_p181 = tau[23] - n23_z_lanes[1];
  const Real qdd_0_p182 = tau[22] - n23_z_lanes[0];

  // link 9 (left_upperarm), inward
  const Lanes<2> f7_x_p8_lanes = detail::make_pack<Real>(s9, s16) * f9_y_lanes;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p183_lanes = qdd_0_p179_lanes -
      (detail::make_pack<Real>(c9, c16) * qdd_0_p169_lanes - detail::make_pack<Real>(s9, s16) *
      qdd_0_p171_lanes);

  // link 1 (calf), inward
  const Real qdd_0_p191 = tau[21] - n22_z;

  // link 23 (left_eye), bias force
  const Lanes<2> qdd_0_p192_lanes = 3.1081081081081083 *
      detail::make_pack<Real>(qdd_0_p182, qdd_0_p181);
  const Lanes<2> qdd_0_p194_lanes = 27.027027027027028 *
      detail::make_pack<Real>(qdd_0_p182, qdd_0_p181);

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_y_p7_lanes = detail::make_pack<Real>(s9, s16) * f9_x_lanes +
      detail::make_pack<Real>(c9, c16) * f9_y_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_x_lanes = n7_x_p12_lanes + n7_x_p11_lanes + n8_z_lanes;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * wd22_y_p4 - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_p10_lanes = 0.7139200499999999 * n12_z_p24_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * n8_x_p1_lanes +
      detail::make_pack<Real>(c9, c16) * f9_x_lanes - f7_x_p8_lanes;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a23_y_p1 - a23_y_p2) - 0.000703125 * n21_y_p1 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p2);

  // link 9 (left_upperarm), bias force
  const Lanes<2> qdd_0_p202_lanes = qdd_0_p151_lanes + inverse_D6_p31_lanes * qdd_0_p157_lanes;
  const Lanes<2> qdd_0_p204_lanes = qdd_0_p133_lanes + inverse_D6_p33_lanes * qdd_0_p157_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_y_lanes = 0.7139200499999999 * n12_z_p19_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (n8_z_p3_lanes + a10_x_p3_lanes) + f8_y_p7_lanes;

  // link 23 (left_eye), bias force
  const Lanes<2> qdd_0_p206_lanes = detail::make_pack<Real>(s23, s24) * qdd_0_p192_lanes;
  const Lanes<2> qdd_0_p208_lanes = detail::make_pack<Real>(s23, s24) * qdd_0_p194_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_lanes = f7_x_p10_lanes - 0.0017499999999999998 *
      (n7_x_p1_lanes + n7_x_p3_lanes + n7_y_p1_lanes);
  const Lanes<2> n7_z_p13_lanes = detail::make_pack<Real>(c8, c15) * n8_y_lanes;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p1_lanes = detail::make_pack<Real>(c7, c14) * n7_x_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_y_lanes = n7_y_p11_lanes + n7_x_p11_lanes +
      (detail::make_pack<Real>(c8, c15) * n8_x_lanes - detail::make_pack<Real>(s8, s15) *
      n8_y_lanes);

  // link 23 (left_eye), bias force
  const Lanes<2> qdd_0_p216_lanes = detail::make_pack<Real>(c23, c24) * qdd_0_p194_lanes;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p218_lanes = detail::make_pack<Real>(s9, s16) * qdd_0_p169_lanes +
      detail::make_pack<Real>(c9, c16) * qdd_0_p171_lanes + inverse_D7_p8_lanes * qdd_0_p183_lanes;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p5 = 1.26882463592404 * n12_z_p1 + 2.06965463592404 * wd5_x - 0.0187369177636143 *
      wd6_x_p6 + 6.1665928899999995 * minus_a6_y + c21 * n21_x;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p220_lanes = qdd_0_p111_lanes + qdd_0_p155_lanes * qdd_0_p183_lanes;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p6_lanes = detail::make_pack<Real>(s7, s14) * n7_y_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p17_lanes = n7_z_p10_lanes + 8.75e-06 * (n7_x_p1_lanes - n7_z_p1_lanes) +
      detail::make_pack<Real>(s8, s15) * n8_x_lanes + n7_z_p13_lanes;

  // link 22 (head), bias force
  const Real qdd_0_p228 = qdd_0_p191 + (qdd_0_p206_lanes[1] + qdd_0_p206_lanes[0]);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> qdd_0_p231_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_lanes = detail::make_pack<Real>(c8, c15) * f8_x_lanes -
      detail::make_pack<Real>(s8, s15) * f8_y_lanes + f7_y_p4_lanes;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p239_lanes = inverse_D6_p161_lanes * qdd_0_p183_lanes;

  // link 23 (left_eye), bias force
  const Lanes<2> qdd_0_p241_lanes = detail::make_pack<Real>(c23, c24) * qdd_0_p192_lanes;

  // link 22 (head), bias force
  const Real qdd_0_p243 = qdd_0_p216_lanes[1] + qdd_0_p216_lanes[0];

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_lanes = n7_z_p17_lanes + 0.0017499999999999998 * (a7_y_lanes + a7_x_lanes);

  // link 1 (calf), inward
  const Real qdd_0_p254 = tau[13] - n7_z_lanes[1];
  const Real qdd_0_p255 = tau[6] - n7_z_lanes[0];

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p256_lanes = inverse_D6_p163_lanes * qdd_0_p183_lanes -
      (detail::make_pack<Real>(s9, s16) * qdd_0_p202_lanes - detail::make_pack<Real>(c9, c16) *
      qdd_0_p204_lanes);
  const Lanes<2> qdd_0_p258_lanes = detail::make_pack<Real>(s10, s17) * qdd_0_p129_lanes +
      detail::make_pack<Real>(c10, c17) * qdd_0_p131_lanes + inverse_D6_p35_lanes *
      qdd_0_p157_lanes - qdd_0_p239_lanes;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p10_lanes = detail::make_pack<Real>(s7, s14) * f7_x_lanes +
      detail::make_pack<Real>(c7, c14) * f7_y_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_z_lanes = detail::make_pack<Real>(s8, s15) * f8_x_lanes +
      detail::make_pack<Real>(c8, c15) * f8_y_lanes + 0.0017499999999999998 *
      (n12_z_p15_lanes - n7_x_p2_lanes);

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p262_lanes = detail::make_pack<Real>(qdd_0_p255, qdd_0_p254) -
      (detail::make_pack<Real>(c8, c15) * qdd_0_p218_lanes - detail::make_pack<Real>(s8, s15) *
      qdd_0_p220_lanes);

  // link 22 (head), bias force
  const Real qdd_0_p268 = qdd_0_p241_lanes[1] + qdd_0_p241_lanes[0] + inverse_D21_p39 * qdd_0_p228;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p12 = f7_z_lanes[1] + f7_z_lanes[0];

  // link 22 (head), bias force
  const Real qdd_0_p271 = inverse_D6_p194 * qdd_0_p228;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p272_lanes = inverse_D6_p295_lanes * qdd_0_p262_lanes;

  // link 22 (head), bias force
  const Real qdd_0_p276 = inverse_D6_p193 * qdd_0_p228 -
      (qdd_0_p208_lanes[1] + qdd_0_p208_lanes[0]);

  // link 22 (head), inward
  const Real n21_z = 0.0016155 * a22_z_p1 - (0.0048105000000000005 * wd22_y_p1 +
      0.006216750000000001 * wd6_x) - 0.0045000000000000005 * minus_a21_y -
      (s22 * n22_x + c22 * n22_y);

  // link 22 (head), bias force
  const Real qdd_0_p287 = inverse_D21_p38 * qdd_0_p228 - qdd_0_p181 - (-0.032) *
      qdd_0_p208_lanes[1] - qdd_0_p182 - 0.032 * qdd_0_p208_lanes[0] - 0.095 * qdd_0_p243;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p290_lanes = inverse_D6_p165_lanes * qdd_0_p183_lanes -
      (detail::make_pack<Real>(c9, c16) * qdd_0_p202_lanes + detail::make_pack<Real>(s9, s16) *
      qdd_0_p204_lanes) + qdd_0_p272_lanes;
  const Lanes<2> qdd_0_p292_lanes = detail::make_pack<Real>(c8, c15) * qdd_0_p258_lanes -
      detail::make_pack<Real>(s8, s15) * qdd_0_p256_lanes + inverse_D6_p293_lanes *
      qdd_0_p262_lanes;

  // link 22 (head), bias force
  const Real qdd_0_p294 = qdd_0_p243 + inverse_D6_p199 * qdd_0_p228;

  // link 1 (calf), inward
  const Real qdd_0_p295 = tau[20] - n21_z;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p298_lanes = qdd_0_p179_lanes + qdd_0_p231_lanes * qdd_0_p262_lanes;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p13 = n6_z_p5 - s21 * n21_y + n6_z_p1_lanes[1] - n6_z_p6_lanes[1] - (-0.18) *
      n6_z_p10_lanes[1] + n6_z_p1_lanes[0] - n6_z_p6_lanes[0];

  // link 22 (head), bias force
  const Real qdd_0_p304 = s22 * qdd_0_p271 - c22 * qdd_0_p276;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p309_lanes = inverse_D6_p332_lanes * qdd_0_p262_lanes -
      (detail::make_pack<Real>(c8, c15) * qdd_0_p220_lanes + detail::make_pack<Real>(s8, s15) *
      qdd_0_p218_lanes);
  const Lanes<2> qdd_0_p311_lanes = detail::make_pack<Real>(c7, c14) * qdd_0_p298_lanes;
  const Lanes<2> qdd_0_p315_lanes = detail::make_pack<Real>(s7, s14) * qdd_0_p290_lanes +
      detail::make_pack<Real>(c7, c14) * qdd_0_p292_lanes;
  const Lanes<2> qdd_0_p317_lanes = detail::make_pack<Real>(s7, s14) * qdd_0_p309_lanes;

  // link 7 (left_shoulder1), inward
  const Real n6_z = n6_z_p13 - 0.18 * n6_z_p10_lanes[0] - 0.226 * n6_z_p12;

  // link 21 (neck), bias force
  const Real qdd_0_p321 = qdd_0_p295 - (s22 * qdd_0_p268 - c22 * qdd_0_p287);

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p326_lanes = detail::make_pack<Real>(s8, s15) * qdd_0_p258_lanes +
      detail::make_pack<Real>(c8, c15) * qdd_0_p256_lanes + inverse_D6_p300_lanes *
      qdd_0_p262_lanes;

  // link 1 (calf), inward
  const Real qdd_0_p328 = tau[5] - n6_z;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_x_p9_lanes = detail::make_pack<Real>(c7, c14) * f7_x_lanes -
      detail::make_pack<Real>(s7, s14) * f7_y_lanes;
  const Real n6_y_p1 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_y_p3 - 0.0187369177636143 *
      (minus_a7_z_p2 - a7_y_p1) + s21 * n21_x;

  // link 6 (chest3), bias force
  const Real qdd_0_p329 = qdd_0_p326_lanes[1] + qdd_0_p326_lanes[0];

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p330_lanes = detail::make_pack<Real>(c7, c14) * qdd_0_p290_lanes -
      detail::make_pack<Real>(s7, s14) * qdd_0_p292_lanes;

  // link 21 (neck), bias force
  const Real qdd_0_p336 = c22 * qdd_0_p268 + s22 * qdd_0_p287 + 0.394 * qdd_0_p294 +
      inverse_D6_p386 * qdd_0_p321;
  const Real qdd_0_p337 = qdd_0_p191 - 0.394 * qdd_0_p304 - inverse_D6_p387 * qdd_0_p321;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p2 = n6_x_p9_lanes[1] + n6_x_p9_lanes[0];

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (w21_y * w21_y + a23_y_p2) + n21_y_p2;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_x_p15_lanes = detail::make_pack<Real>(s7, s14) * n7_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_y_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      n6_x_p9_lanes;

  // link 21 (neck), bias force
  const Real qdd_0_p342 = qdd_0_p304 + inverse_D5_p6 * qdd_0_p321;

  // link 22 (head), inward
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p343_lanes = detail::make_pack<Real>(s7, s14) * qdd_0_p298_lanes +
      detail::make_pack<Real>(c7, c14) * qdd_0_p309_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      qdd_0_p330_lanes;

  // link 6 (chest3), bias force
  const Real qdd_0_p345 = qdd_0_p330_lanes[1] + qdd_0_p330_lanes[0];

  // link 21 (neck), bias force
  const Real qdd_0_p346 = qdd_0_p294 + inverse_D5_p13 * qdd_0_p321;

  // link 6 (chest3), bias force
  const Real qdd_0_p347 = qdd_0_p328 - qdd_0_p311_lanes[1] + qdd_0_p317_lanes[1] + (-0.18) *
      qdd_0_p315_lanes[1] + c21 * qdd_0_p336 + s21 * qdd_0_p337;

  // link 7 (left_shoulder1), inward
  const Real n6_x = 0.40041499999999997 * n12_z_p7 + 0.0187369177636143 * minus_a7_z_p1 - n21_z +
      n6_x_p15_lanes[1] + n6_x_p15_lanes[0];
  const Real n6_y = n6_y_p1 + c21 * n21_y + n7_z_lanes[1] + n7_z_lanes[0] + 0.226 * n6_y_p2;
  const Real f6_z = n6_y_p2 - 6.1665928899999995 * a7_y_p3 - c21 * minus_f21_x - s21 * f21_y;

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p1 + (s22 * minus_f22_x - c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real f6_y = n6_z_p12 - 6.1665928899999995 * minus_a7_z_p1 - s21 * minus_f21_x + c21 * f21_y;

  // link 6 (chest3), bias force
  const Real qdd_0_p348 = qdd_0_p347 - qdd_0_p311_lanes[0] + qdd_0_p317_lanes[0] + 0.18 *
      qdd_0_p315_lanes[0] + 0.226 * qdd_0_p329;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p2 = 0.10961925816937637 * wd6_x_p2 - 0.203126912024134 * minus_wd5_z -
      0.005678398088837119 * (n5_z_p1 - a6_x_p1) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a7_y_p4 - f21_z + n6_z_p10_lanes[1] + n6_z_p10_lanes[0];

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);

  // link 6 (chest3), bias force
  const Real qdd_0_p349 = qdd_0_p343_lanes[1] - qdd_0_p295 + qdd_0_p343_lanes[0] + inverse_D5_p73 *
      qdd_0_p348;
  const Real qdd_0_p350 = qdd_0_p345 - c21 * qdd_0_p342 - s21 * qdd_0_p346 + inverse_D5_p71 *
      qdd_0_p348;
  const Real qdd_0_p351 = qdd_0_p315_lanes[1] - (inverse_D3_p4 * qdd_0_p321 -
      (s22 * qdd_0_p276 + c22 * qdd_0_p271)) + qdd_0_p315_lanes[0] - inverse_D3_p14 * qdd_0_p348;
  const Real qdd_0_p352 = qdd_0_p329 - s21 * qdd_0_p342 + c21 * qdd_0_p346 + inverse_D3_p15 *
      qdd_0_p348;

  // link 1 (calf), inward
  const Real qdd_0_p353 = tau[4] - n5_z;

  // link 6 (chest3), bias force
  const Real qdd_0_p354 = qdd_0_p254 - s21 * qdd_0_p336 + c21 * qdd_0_p337 + qdd_0_p255 +
      inverse_D5_p72 * qdd_0_p348 + 0.226 * qdd_0_p345;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real f5_x = f6_z - (0.069699984375 * (n5_z_p1 + a6_x_p2) + 2.2194301519999997 * a6_z_p1);
  const Real f5_y = 2.2194301519999997 * a6_x_p3 - 0.069699984375 * wd6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real n3_z_p1 = c4 * inverse_D3_p32;

  // link 4 (chest1), outward
  const Real n3_z_p2 = 2.0 * wd4_x;

  // link 6 (chest3), bias force
  const Real qdd_0_p355 = s6 * qdd_0_p351 + c6 * qdd_0_p352;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p4 - 0.04675382692737882 * wd6_x_p4 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 4 (chest1), outward
  const Real n3_z_p3 = qd[3] * qd[3];

  // link 6 (chest3), inward
  const Real f5_z = 0.069699984375 * wd6_x_p4 - 2.2194301519999997 * a6_x_p4 + n5_x_p1;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = a3_x_p1 * inverse_D2_p19 + a3_x_p2 * inverse_D2_p18;

  // link 6 (chest3), inward
  const Real n5_x = 0.15637308509675518 * a6_x_p4 - 0.005678398088837119 * wd6_x_p4 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);

  // link 5 (chest2), bias force
  const Real qdd_0_p356 = qdd_0_p353 - (s6 * qdd_0_p349 + c6 * qdd_0_p354 + 0.072 * qdd_0_p350);

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p2 = inverse_D2_p20 - inverse_D1_p1;

  // link 5 (chest2), inward
  const Real n3_z_p4 = c4 * (s5 * f5_y - c5 * f5_x) + s4 * f5_z;
  const Real minus_f4_z = n3_z_p2 * inverse_D2_p1 + (s5 * f5_x + c5 * f5_y);
  const Real n2_z_p1 = 0.031999971599999996 * c2 + 24.5839218 * s2;

  // link 5 (chest2), bias force
  const Real qdd_0_p357 = c6 * qdd_0_p351 - s6 * qdd_0_p352 + inverse_D3_p36 * qdd_0_p356;
  const Real qdd_0_p358 = qdd_0_p350 + inverse_D3_p35 * qdd_0_p356;
  const Real qdd_0_p359 = c6 * qdd_0_p349 - s6 * qdd_0_p354 + inverse_D4_p11 * qdd_0_p356;
  const Real qdd_0_p360 = qdd_0_p328 - 0.072 * qdd_0_p355 - inverse_D4_p10 * qdd_0_p356;

  // link 5 (chest2), inward
  const Real f4_x = (a5_y_p1 + n3_z_p3) * inverse_D2_p2 - n3_z_p4;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = 9.885744550888212 + (a3_x_p2 *
      (a3_x_p1 * inverse_D2_p18 + a3_x_p2 * (inverse_D2_p15 + inverse_D2_p17)) + a3_x_p1 *
      inverse_D2_p20);

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * a5_y_p1 + minus_f4_z;
  const Real n3_z_p5 = 8.419374554 * a3_x + n3_z_p2 * n3_z_p1 - s4 * (s5 * n5_y - c5 * n5_x);
  const Real f3_x = 0.02999999505 * a5_y_p1 + f4_x;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / inverse_D2_p21;

  // link 3 (hip), inward
  const Real n2_z_p2 = a3_x_p3 * f3_x - a3_y_p1 * f3_y;

  // link 5 (chest2), bias force
  const Real qdd_0_p361 = c4 * (s5 * qdd_0_p357 - c5 * qdd_0_p358) + s4 *
      (qdd_0_p355 + inverse_D3_p37 * qdd_0_p356);

  // link 4 (chest1), bias force
  const Real qdd_0_p362 = tau[3] - inverse_D2_p1 * a3_x + a5_y_p1 * n3_z_p1 + (n5_y + qdd_0_p359) *
      c5 + (n5_x + qdd_0_p360) * s5;

  // link 4 (chest1), inward
  const Real n3_z = n3_z_p5 - 0.21799999999999997 * n3_z_p4 +
      (0.005880002159562879 * n3_z_p3 + n5_z) * c4 - inverse_D2_p3 * a3_y;

  // link 3 (hip), inward
  const Real f2_x = n2_z_p2 - a3_x_p4 * n2_z_p1;

  // link 1 (calf), inward
  const Real qdd_0_p363 = tau[2] - n3_z;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p3 = inverse_D1_p2 * inverse_D2;

  // link 5 (chest2), bias force
  const Real qdd_0_p364 = c4 * qdd_0_p353 - s4 * (s5 * qdd_0_p359 - c5 * qdd_0_p360) -
      0.21799999999999997 * qdd_0_p361;

  // link 3 (hip), inward
  const Real n2_z = n2_z_p1 * a2_y + inverse_D1_p1 * minus_a1_x +
      (n3_z + (a3_x_p2 * (a3_y_p1 * f3_x + a3_x_p3 * f3_y) + a3_x_p1 * n2_z_p2));

  // link 3 (hip), bias force
  const Real qdd_0_p365 = qdd_0_p363 - (qdd_0_p364 + inverse_D3_p62 * qdd_0_p362);
  const Real qdd_0_p366 = inverse_D2_p7 * qdd_0_p362 - qdd_0_p361 + inverse_D2_p12 * qdd_0_p365;
  const Real qdd_0_p367 = inverse_D2_p8 * qdd_0_p362 - (s5 * qdd_0_p358 + c5 * qdd_0_p357) +
      inverse_D2_p11 * qdd_0_p365;

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D2_p19 - inverse_D1_p2 * inverse_D1_p3));

  // link 7 (left_shoulder1), acceleration
  const Lanes<2> qdd_6_p1_lanes = inverse_D7_lanes * qdd_0_p262_lanes;

  // link 3 (hip), bias force
  const Real qdd_0_p368 = a3_x_p3 * qdd_0_p366 + a3_y_p1 * qdd_0_p367;

  // link 2 (thigh), bias force
  const Real qdd_0_p369 = tau[1] - n2_z - (qdd_0_p363 +
      (a3_x_p2 * (a3_y_p1 * qdd_0_p366 - a3_x_p3 * qdd_0_p367) + a3_x_p1 * qdd_0_p368));

  // link 1 (calf), bias force
  const Real qdd_0_p370 = tau[0] - 0.1569597827085 * c1 + 299.6743959432 * s1 - tau[1] - 0.434 *
      (f2_x + (qdd_0_p368 + inverse_D1_p3 * qdd_0_p369));

  // link 1 (calf), acceleration
  const Real qdd_0 = inverse_D1 * qdd_0_p370;
  qdd[0] = qdd_0;

  // link 2 (thigh), acceleration
  const Real qdd_1_p1 = 0.434 * qdd_0;
  const Real qdd_1 = inverse_D2 * qdd_0_p369 - (inverse_D1_p3 * qdd_1_p1 + qdd_0);
  qdd[1] = qdd_1;
  const Real qdd_2_p1 = qdd_0 + qdd_1;

  // link 3 (hip), acceleration
  const Real qdd_2_p2 = qdd_2_p1 * a3_x_p2;
  const Real qdd_2_p3 = qdd_1_p1 + qdd_2_p1 * a3_x_p1;

  // link 8 (left_shoulder2), acceleration
  const Lanes<2> qdd_7_p1_lanes = inverse_D8_lanes * qdd_0_p183_lanes;

  // link 3 (hip), acceleration
  const Real qdd_2_p4 = a3_x_p3 * qdd_2_p3 + a3_y_p1 * qdd_2_p2;
  const Real qdd_2_p5 = a3_x_p3 * qdd_2_p2 - a3_y_p1 * qdd_2_p3;
  const Real qdd_2 = inverse_D3 * qdd_0_p365 - (inverse_D2_p12 * qdd_2_p4 - inverse_D2_p11 *
      qdd_2_p5 + qdd_2_p1);
  qdd[2] = qdd_2;
  const Real qdd_4_p1 = qdd_2_p1 + qdd_2;

  // link 5 (chest2), acceleration
  const Real qdd_4_p2 = s4 * qdd_4_p1;
  const Real qdd_4_p3 = c4 * qdd_4_p1;
  const Real qdd_4_p4 = qdd_2_p4 + 0.21799999999999997 * qdd_4_p1;
  const Real qdd_4_p5 = c4 * qdd_4_p4;

  // link 4 (chest1), acceleration
  const Real qdd_3 = inverse_D4 * qdd_0_p362 - (inverse_D2_p7 * qdd_2_p4 - inverse_D2_p8 *
      qdd_2_p5 + inverse_D3_p62 * qdd_4_p1);
  qdd[3] = qdd_3;

  // link 5 (chest2), acceleration
  const Real qdd_4_p6 = s4 * qdd_4_p4;

  // link 9 (left_upperarm), acceleration
  const Lanes<2> qdd_8_p1_lanes = inverse_D9_lanes * qdd_0_p157_lanes;

  // link 5 (chest2), acceleration
  const Real qdd_4_p7 = c5 * qdd_4_p2 - s5 * qdd_3;
  const Real qdd_4_p8 = s5 * qdd_4_p2 + c5 * qdd_3;
  const Real qdd_4_p9 = c5 * qdd_4_p5 + s5 * qdd_2_p5;
  const Real qdd_4_p10 = c5 * qdd_2_p5 - s5 * qdd_4_p5;

  // link 6 (chest3), acceleration
  const Real qdd_5_p1 = qdd_4_p6 + 0.072 * qdd_4_p7;

  // link 5 (chest2), acceleration
  const Real qdd_4_p11 = inverse_D3_p35 * qdd_4_p9 + inverse_D3_p36 * qdd_4_p10 - inverse_D3_p37 *
      qdd_4_p6 + (qdd_4_p3 - (inverse_D4_p10 * qdd_4_p7 + inverse_D4_p11 * qdd_4_p8));

  // link 6 (chest3), acceleration
  const Real qdd_5_p2 = c6 * qdd_4_p10 - s6 * qdd_5_p1;
  const Real qdd_5_p3 = s6 * qdd_4_p10 + c6 * qdd_5_p1;

  // link 10 (left_lowerarm), acceleration
  const Lanes<2> qdd_9_p1_lanes = inverse_D10_lanes * qdd_0_p113_lanes;

  // link 5 (chest2), acceleration
  const Real qdd_4 = inverse_D5 * qdd_0_p356 - qdd_4_p11;
  qdd[4] = qdd_4;
  const Real qdd_5_p4 = qdd_4_p3 + qdd_4;

  // link 6 (chest3), acceleration
  const Real qdd_5_p5 = s6 * qdd_5_p4 - c6 * qdd_4_p8;
  const Real qdd_5_p6 = s6 * qdd_4_p8 + c6 * qdd_5_p4;
  const Real qdd_5_p7 = qdd_4_p9 + 0.072 * qdd_5_p4;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6_p2 = qdd_5_p7 + 0.226 * qdd_5_p6;
  const Real qdd_6_p3 = qdd_6_p2 + 0.18 * qdd_5_p5;

  // link 11 (left_wrist1), acceleration
  const Lanes<2> qdd_10_p1_lanes = inverse_D11_lanes * qdd_0_p57_lanes;

  // link 6 (chest3), acceleration
  const Real qdd_5_p8 = inverse_D5_p71 * qdd_5_p7 -
      (inverse_D3_p14 * qdd_5_p2 + inverse_D3_p15 * qdd_5_p3) +
      (inverse_D5_p73 * qdd_5_p5 + inverse_D5_p72 * qdd_5_p6 + qdd_4_p7);
  const Real qdd_5 = inverse_D6 * qdd_0_p348 - qdd_5_p8;
  qdd[5] = qdd_5;
  const Real qdd_6_p4 = qdd_4_p7 + qdd_5;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6_p5 = qdd_5_p2 - 0.18 * qdd_6_p4;
  const Real qdd_6_p6 = s7 * qdd_5_p5 + c7 * qdd_6_p4;
  const Real qdd_6_p7 = c7 * qdd_5_p5 - s7 * qdd_6_p4;
  const Real qdd_6_p8 = qdd_5_p3 + 0.226 * qdd_6_p4;

  // link 12 (left_wrist2), acceleration
  const Lanes<2> qdd_11_p1_lanes = inverse_D12_lanes * qdd_0_p17_lanes;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6_p9 = s7 * qdd_6_p5 + c7 * qdd_6_p3;
  const Real qdd_6_p10 = c7 * qdd_6_p5 - s7 * qdd_6_p3;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7_p2 = c8 * qdd_6_p10 - s8 * qdd_6_p8;

  // link 13 (left_hand), acceleration
  const Lanes<2> qdd_12_p1_lanes = 1065.380700001509 * qdd_0_p1_lanes;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7_p3 = s8 * qdd_6_p10 + c8 * qdd_6_p8;

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p2 = qdd_5_p2 - (-0.18) * qdd_6_p4;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6_p11 = inverse_D6_p295_lanes[0] * qdd_6_p9 + inverse_D6_p293_lanes[0] *
      qdd_6_p10 - inverse_D6_p300_lanes[0] * qdd_6_p8 +
      (qdd_0_p231_lanes[0] * qdd_6_p6 + inverse_D6_p332_lanes[0] * qdd_6_p7 + qdd_5_p6);

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p3 = qdd_6_p2 + (-0.18) * qdd_5_p5;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6 = qdd_6_p1_lanes[0] - qdd_6_p11;
  qdd[6] = qdd_6;

  // link 9 (left_upperarm), acceleration
  const Real qdd_8_p2 = c9 * qdd_6_p9 - s9 * qdd_7_p3;
  const Real qdd_8_p3 = c9 * qdd_7_p3 + s9 * qdd_6_p9;

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p4 = s14 * qdd_5_p5 + c14 * qdd_6_p4;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_7_p4 = qdd_5_p6 + qdd_6;

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p5 = c14 * qdd_5_p5 - s14 * qdd_6_p4;
  const Real qdd_13_p6 = s14 * qdd_13_p2 + c14 * qdd_13_p3;
  const Real qdd_13_p7 = c14 * qdd_13_p2 - s14 * qdd_13_p3;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7_p5 = c8 * qdd_7_p4 - s8 * qdd_6_p7;
  const Real qdd_7_p6 = c8 * qdd_6_p7 + s8 * qdd_7_p4;

  // link 15 (right_shoulder2), acceleration
  const Real qdd_14_p2 = c15 * qdd_13_p7 - s15 * qdd_6_p8;
  const Real qdd_14_p3 = s15 * qdd_13_p7 + c15 * qdd_6_p8;

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p8 = inverse_D6_p295_lanes[1] * qdd_13_p6 + inverse_D6_p293_lanes[1] *
      qdd_13_p7 - inverse_D6_p300_lanes[1] * qdd_6_p8 +
      (qdd_0_p231_lanes[1] * qdd_13_p4 + inverse_D6_p332_lanes[1] * qdd_13_p5 + qdd_5_p6);

  // link 16 (right_upperarm), acceleration
  const Real qdd_15_p2 = c16 * qdd_13_p6 - s16 * qdd_14_p3;

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13 = qdd_6_p1_lanes[1] - qdd_13_p8;
  qdd[13] = qdd_13;

  // link 16 (right_upperarm), acceleration
  const Real qdd_15_p3 = c16 * qdd_14_p3 + s16 * qdd_13_p6;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7_p7 = inverse_D6_p165_lanes[0] * qdd_6_p9 -
      (inverse_D6_p161_lanes[0] * qdd_7_p2 + inverse_D6_p163_lanes[0] * qdd_7_p3) +
      (inverse_D7_p8_lanes[0] * qdd_7_p5 - qdd_0_p155_lanes[0] * qdd_7_p6 + qdd_6_p6);

  // link 14 (right_shoulder1), acceleration
  const Real qdd_14_p4 = qdd_5_p6 + qdd_13;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7 = qdd_7_p1_lanes[0] - qdd_7_p7;
  qdd[7] = qdd_7;
  const Real qdd_8_p4 = qdd_6_p6 + qdd_7;

  // link 15 (right_shoulder2), acceleration
  const Real qdd_14_p5 = c15 * qdd_14_p4 - s15 * qdd_13_p5;
  const Real qdd_14_p6 = c15 * qdd_13_p5 + s15 * qdd_14_p4;

  // link 9 (left_upperarm), acceleration
  const Real qdd_8_p5 = s9 * qdd_7_p5 + c9 * qdd_8_p4;
  const Real qdd_8_p6 = c9 * qdd_7_p5 - s9 * qdd_8_p4;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p2 = qdd_8_p2 - 0.282 * qdd_8_p6;

  // link 15 (right_shoulder2), acceleration
  const Real qdd_14_p7 = inverse_D6_p165_lanes[1] * qdd_13_p6 -
      (inverse_D6_p161_lanes[1] * qdd_14_p2 + inverse_D6_p163_lanes[1] * qdd_14_p3) +
      (inverse_D7_p8_lanes[1] * qdd_14_p5 - qdd_0_p155_lanes[1] * qdd_14_p6 + qdd_13_p4);

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p3 = 0.282 * qdd_8_p5 - qdd_8_p3;

  // link 15 (right_shoulder2), acceleration
  const Real qdd_14 = qdd_7_p1_lanes[1] - qdd_14_p7;
  qdd[14] = qdd_14;

  // link 9 (left_upperarm), acceleration
  const Real qdd_8_p7 = inverse_D6_p35_lanes[0] * qdd_7_p2 -
      (inverse_D6_p31_lanes[0] * qdd_8_p2 + inverse_D6_p33_lanes[0] * qdd_8_p3) +
      (inverse_D8_p149_lanes[0] * qdd_8_p5 + inverse_D8_p150_lanes[0] * qdd_8_p6 - qdd_7_p6);

  // link 15 (right_shoulder2), acceleration
  const Real qdd_15_p4 = qdd_13_p4 + qdd_14;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p4 = c10 * qdd_9_p2 + s10 * qdd_7_p2;
  const Real qdd_9_p5 = c10 * qdd_7_p2 - s10 * qdd_9_p2;

  // link 9 (left_upperarm), acceleration
  const Real qdd_8 = qdd_8_p1_lanes[0] - qdd_8_p7;
  qdd[8] = qdd_8;
  const Real qdd_9_p6 = qdd_8 - qdd_7_p6;

  // link 16 (right_upperarm), acceleration
  const Real qdd_15_p5 = s16 * qdd_14_p5 + c16 * qdd_15_p4;
  const Real qdd_15_p6 = c16 * qdd_14_p5 - s16 * qdd_15_p4;

  // link 11 (left_wrist1), acceleration
  const Real qdd_10_p2 = c11 * qdd_9_p3 - s11 * qdd_9_p4;
  const Real qdd_10_p3 = c11 * qdd_9_p4 + s11 * qdd_9_p3;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p7 = c10 * qdd_8_p5 - s10 * qdd_9_p6;
  const Real qdd_9_p8 = s10 * qdd_8_p5 + c10 * qdd_9_p6;

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16_p2 = qdd_15_p2 - 0.282 * qdd_15_p6;
  const Real qdd_16_p3 = 0.282 * qdd_15_p5 - qdd_15_p3;

  // link 16 (right_upperarm), acceleration
  const Real qdd_15_p7 = inverse_D6_p35_lanes[1] * qdd_14_p2 -
      (inverse_D6_p31_lanes[1] * qdd_15_p2 + inverse_D6_p33_lanes[1] * qdd_15_p3) +
      (inverse_D8_p149_lanes[1] * qdd_15_p5 + inverse_D8_p150_lanes[1] * qdd_15_p6 - qdd_14_p6);

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16_p4 = c17 * qdd_16_p2 + s17 * qdd_14_p2;
  const Real qdd_16_p5 = c17 * qdd_14_p2 - s17 * qdd_16_p2;

  // link 21 (neck), acceleration
  const Real qdd_20_p1 = s21 * qdd_5_p6 + c21 * qdd_6_p4;

  // link 16 (right_upperarm), acceleration
  const Real qdd_15 = qdd_8_p1_lanes[1] - qdd_15_p7;
  qdd[15] = qdd_15;

  // link 21 (neck), acceleration
  const Real qdd_20_p2 = c21 * qdd_5_p6 - s21 * qdd_6_p4;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p9 = inverse_D8_p80_lanes[0] * qdd_9_p4 + inverse_D8_p81_lanes[0] * qdd_9_p5 +
      inverse_D8_p82_lanes[0] * qdd_9_p3 + (inverse_D9_p9_lanes[0] * qdd_9_p7 -
      inverse_D9_p7_lanes[0] * qdd_9_p8 + qdd_8_p6);

  // link 21 (neck), acceleration
  const Real qdd_20_p3 = c21 * qdd_5_p7 - s21 * qdd_5_p3;

  // link 16 (right_upperarm), acceleration
  const Real qdd_16_p6 = qdd_15 - qdd_14_p6;

  // link 21 (neck), acceleration
  const Real qdd_20_p4 = c21 * qdd_5_p3 + s21 * qdd_5_p7;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9 = qdd_9_p1_lanes[0] - qdd_9_p9;
  qdd[9] = qdd_9;

  // link 18 (right_wrist1), acceleration
  const Real qdd_17_p2 = c18 * qdd_16_p3 - s18 * qdd_16_p4;
  const Real qdd_17_p3 = c18 * qdd_16_p4 + s18 * qdd_16_p3;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_10_p4 = qdd_8_p6 + qdd_9;

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16_p7 = c17 * qdd_15_p5 - s17 * qdd_16_p6;
  const Real qdd_16_p8 = s17 * qdd_15_p5 + c17 * qdd_16_p6;

  // link 22 (head), acceleration
  const Real qdd_21_p1 = qdd_20_p3 + 0.394 * qdd_20_p2;
  const Real qdd_21_p2 = qdd_20_p4 + 0.394 * qdd_20_p1;

  // link 11 (left_wrist1), acceleration
  const Real qdd_10_p5 = c11 * qdd_9_p7 + s11 * qdd_10_p4;
  const Real qdd_10_p6 = c11 * qdd_10_p4 - s11 * qdd_9_p7;

  // link 21 (neck), acceleration
  const Real qdd_20_p5 = inverse_D5_p6 * qdd_20_p3 + inverse_D5_p13 * qdd_20_p4 + inverse_D3_p4 *
      qdd_5_p2 + (inverse_D6_p386 * qdd_20_p1 + inverse_D6_p387 * qdd_20_p2 + qdd_5_p5);

  // link 22 (head), acceleration
  const Real qdd_21_p3 = c22 * qdd_21_p1 + s22 * qdd_5_p2;

  // link 21 (neck), acceleration
  const Real qdd_20 = inverse_D21 * qdd_0_p321 + qdd_20_p5;
  qdd[20] = qdd_20;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p2 = qdd_10_p3 - 0.269 * qdd_10_p6;

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16_p9 = inverse_D8_p80_lanes[1] * qdd_16_p4 + inverse_D8_p81_lanes[1] * qdd_16_p5 +
      inverse_D8_p82_lanes[1] * qdd_16_p3 + (inverse_D9_p9_lanes[1] * qdd_16_p7 -
      inverse_D9_p7_lanes[1] * qdd_16_p8 + qdd_15_p6);

  // link 21 (neck), acceleration
  const Real qdd_21_p4 = qdd_20 - qdd_5_p5;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p3 = qdd_10_p2 + 0.269 * qdd_10_p5;

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16 = qdd_9_p1_lanes[1] - qdd_16_p9;
  qdd[16] = qdd_16;

  // link 11 (left_wrist1), acceleration
  const Real qdd_10_p7 = inverse_D8_p17_lanes[0] * qdd_10_p2 - inverse_D8_p16_lanes[0] * qdd_10_p3 -
      inverse_D8_p18_lanes[0] * qdd_9_p5 + (inverse_D10_p73_lanes[0] * qdd_10_p5 +
      inverse_D10_p74_lanes[0] * qdd_10_p6 + qdd_9_p8);

  // link 17 (right_lowerarm), acceleration
  const Real qdd_17_p4 = qdd_15_p6 + qdd_16;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p4 = c12 * qdd_9_p5 - s12 * qdd_11_p2;

  // link 22 (head), acceleration
  const Real qdd_21_p5 = inverse_D6_p193 * qdd_21_p3 + inverse_D6_p194 *
      (c22 * qdd_5_p2 - s22 * qdd_21_p1) - inverse_D6_p199 * qdd_21_p2;
  const Real qdd_21_p6 = c22 * qdd_20_p1 - s22 * qdd_21_p4;
  const Real qdd_21_p7 = s22 * qdd_20_p1 + c22 * qdd_21_p4;

  // link 11 (left_wrist1), acceleration
  const Real qdd_10 = qdd_10_p1_lanes[0] - qdd_10_p7;
  qdd[10] = qdd_10;
  const Real qdd_11_p5 = qdd_9_p8 + qdd_10;

  // link 18 (right_wrist1), acceleration
  const Real qdd_17_p5 = c18 * qdd_16_p7 + s18 * qdd_17_p4;
  const Real qdd_17_p6 = c18 * qdd_17_p4 - s18 * qdd_16_p7;

  // link 23 (left_eye), acceleration
  const Real qdd_22_p1 = 0.095 * qdd_21_p7 - qdd_21_p2;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p6 = inverse_D10_p18_lanes[0] * qdd_11_p4 - inverse_D10_p19_lanes[0] *
      (c12 * qdd_11_p2 + s12 * qdd_9_p5) + inverse_D10_p20_lanes[0] * qdd_11_p3;
  const Real qdd_11_p7 = s12 * qdd_10_p5 + c12 * qdd_11_p5;

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p2 = qdd_17_p3 - 0.269 * qdd_17_p6;
  const Real qdd_18_p3 = qdd_17_p2 + 0.269 * qdd_17_p5;

  // link 22 (head), acceleration
  const Real qdd_21 = inverse_D22 * qdd_0_p228 - (qdd_21_p5 +
      (qdd_20_p2 - (inverse_D21_p39 * qdd_21_p6 + inverse_D21_p38 * qdd_21_p7)));
  qdd[21] = qdd_21;

  // link 18 (right_wrist1), acceleration
  const Real qdd_17_p7 = inverse_D8_p17_lanes[1] * qdd_17_p2 - inverse_D8_p16_lanes[1] * qdd_17_p3 -
      inverse_D8_p18_lanes[1] * qdd_16_p5 + (inverse_D10_p73_lanes[1] * qdd_17_p5 +
      inverse_D10_p74_lanes[1] * qdd_17_p6 + qdd_16_p8);

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p4 = c19 * qdd_16_p5 - s19 * qdd_18_p2;

  // link 22 (head), acceleration
  const Real qdd_22_p2 = qdd_20_p2 + qdd_21;

  // link 18 (right_wrist1), acceleration
  const Real qdd_17 = qdd_10_p1_lanes[1] - qdd_17_p7;
  qdd[17] = qdd_17;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11 = qdd_11_p1_lanes[0] - (qdd_11_p6 +
      (qdd_10_p6 - inverse_D11_p14_lanes[0] * qdd_11_p7));
  qdd[11] = qdd_11;

  // link 18 (right_wrist1), acceleration
  const Real qdd_18_p5 = qdd_16_p8 + qdd_17;

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p6 = inverse_D10_p18_lanes[1] * qdd_18_p4 - inverse_D10_p19_lanes[1] *
      (c19 * qdd_18_p2 + s19 * qdd_16_p5) + inverse_D10_p20_lanes[1] * qdd_18_p3;
  const Real qdd_18_p7 = s19 * qdd_17_p5 + c19 * qdd_18_p5;

  // link 13 (left_hand), acceleration
  const Real qdd_12_p2 = inverse_D11_p5_lanes[0] * qdd_11_p7 - inverse_D12_p7_lanes[0] *
      (qdd_10_p6 + qdd_11) + (c12 * qdd_10_p5 - s12 * qdd_11_p5);

  // link 23 (left_eye), acceleration
  const Real qdd_22_p3 = 27.027027027027028 * (c23 * qdd_22_p1 - s23 *
      (qdd_21_p3 - 0.032 * qdd_21_p7)) + (qdd_21_p7 - 3.1081081081081083 *
      (c23 * qdd_21_p6 + s23 * qdd_22_p2));

  // link 24 (right_eye), acceleration
  const Real qdd_23_p1 = 27.027027027027028 * (c24 * qdd_22_p1 - s24 *
      (qdd_21_p3 - (-0.032) * qdd_21_p7)) + (qdd_21_p7 - 3.1081081081081083 *
      (c24 * qdd_21_p6 + s24 * qdd_22_p2));

  // link 23 (left_eye), acceleration
  qdd[22] = 108108.1081081081 * qdd_0_p182 - qdd_22_p3;

  // link 24 (right_eye), acceleration
  qdd[23] = 108108.1081081081 * qdd_0_p181 - qdd_23_p1;

  // link 13 (left_hand), acceleration
  qdd[12] = qdd_12_p1_lanes[0] - (inverse_D10_p3_lanes[0] * qdd_11_p3 - inverse_D10_p1_lanes[0] *
      qdd_11_p4 + qdd_12_p2);

  // link 19 (right_wrist2), acceleration
  const Real qdd_18 = qdd_11_p1_lanes[1] - (qdd_18_p6 +
      (qdd_17_p6 - inverse_D11_p14_lanes[1] * qdd_18_p7));
  qdd[18] = qdd_18;

  // link 20 (right_hand), acceleration
  const Real qdd_19_p2 = inverse_D11_p5_lanes[1] * qdd_18_p7 - inverse_D12_p7_lanes[1] *
      (qdd_17_p6 + qdd_18) + (c19 * qdd_17_p5 - s19 * qdd_18_p5);
  qdd[19] = qdd_12_p1_lanes[1] - (inverse_D10_p3_lanes[1] * qdd_18_p3 - inverse_D10_p1_lanes[1] *
      qdd_18_p4 + qdd_19_p2);
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
