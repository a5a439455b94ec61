// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at
//   link origins, alike limbs in lanes.
// 8557 flops (add 3753, mul 4760, div 44), sine and cosine of 24 angles
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
      q[14], q[15], q[16], q[17], q[18], q[19], q[9], q[12], q[11], q[10], q[8], q[7], q[6]};
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
  const Real c5 = cosines[4];
  const Real s5 = sines[4];
  const Real s6 = sines[5];
  const Real c6 = cosines[5];
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
  const Real s10 = sines[17];
  const Real c13 = cosines[18];
  const Real s13 = sines[18];
  const Real s12 = sines[19];
  const Real c12 = cosines[19];
  const Real s11 = sines[20];
  const Real c11 = cosines[20];
  const Real c10 = cosines[17];
  const Real c9 = cosines[21];
  const Real s9 = sines[21];
  const Real s8 = sines[22];
  const Real c8 = cosines[22];
  const Real c7 = cosines[23];
  const Real s7 = sines[23];
  const Lanes<2> inverse_D12_p5_lanes = 0.000108260010923775 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p6_lanes = 0.0007556474228594393 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.000252780114665025), 0.000252780114665025) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D11_p3_lanes = 0.000108260010923775 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> inverse_D10_p5_lanes = 0.01626499875 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D10_p6_lanes = 0.01626499875 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(s13, s20);

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D12_p7_lanes = 1065.380700001509 * inverse_D12_p5_lanes;
  const Lanes<2> inverse_D12_p8_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p6_lanes;
  const Lanes<2> inverse_D11_p5_lanes = 1065.380700001509 * inverse_D11_p3_lanes;
  const Lanes<2> inverse_D10_p7_lanes = 1065.380700001509 * inverse_D10_p5_lanes;
  const Lanes<2> inverse_D10_p8_lanes = 1065.380700001509 * inverse_D10_p6_lanes;
  const Lanes<2> inverse_D10_p9_lanes = 0.0006000000000000001 + inverse_D10_p6_lanes;
  const Lanes<2> inverse_D12_p10_lanes = 0.000847139515629375 - inverse_D12_p8_lanes;
  const Lanes<2> inverse_D11_p7_lanes = detail::make_pack<Real>(c13, c20) * inverse_D12_p6_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125);
  const Lanes<2> inverse_D11_p9_lanes = 9.149209276993575e-05 + inverse_D12_p8_lanes;
  const Lanes<2> inverse_D10_p12_lanes = inverse_D12_p5_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p16_lanes = 0.0025100003499999995 - inverse_D12_p5_lanes *
      inverse_D10_p7_lanes;
  const Lanes<2> inverse_D11_p12_lanes = detail::make_pack<Real>((-2.4000000000000003e-06),
      2.4000000000000003e-06) - (inverse_D11_p7_lanes + inverse_D11_p3_lanes *
      inverse_D12_p7_lanes);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (0.000206827662257343 +
      (inverse_D12_p10_lanes - inverse_D12_p5_lanes * inverse_D12_p7_lanes));
  const Lanes<2> inverse_D11_p14_lanes = inverse_D11_p12_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p18_lanes = inverse_D10_p16_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p19_lanes = inverse_D10_p9_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p20_lanes = inverse_D10_p12_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D10_p25_lanes = inverse_D10_p9_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D11_p16_lanes = 0.000195227662257343 +
      (inverse_D11_p9_lanes - inverse_D11_p3_lanes * inverse_D11_p5_lanes) - inverse_D11_p12_lanes *
      inverse_D11_p14_lanes;
  const Lanes<2> inverse_D10_p28_lanes = inverse_D11_p3_lanes * inverse_D10_p7_lanes +
      inverse_D11_p12_lanes * inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p29_lanes = inverse_D10_p5_lanes + inverse_D11_p12_lanes *
      inverse_D10_p19_lanes;
  const Lanes<2> inverse_D10_p30_lanes = inverse_D11_p3_lanes * inverse_D10_p8_lanes -
      0.0025100003499999995 - inverse_D11_p12_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D10_p31_lanes = inverse_D10_p9_lanes * inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p32_lanes = inverse_D10_p9_lanes * inverse_D10_p19_lanes;
  const Lanes<2> inverse_D10_p33_lanes = inverse_D10_p5_lanes * inverse_D10_p7_lanes +
      inverse_D10_p16_lanes * inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p34_lanes = inverse_D10_p5_lanes * inverse_D10_p8_lanes -
      inverse_D10_p16_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D11_p18_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p16_lanes);
  const Lanes<2> inverse_D10_p46_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p28_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p29_lanes;
  const Lanes<2> inverse_D10_p47_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p30_lanes;
  const Lanes<2> inverse_D10_p49_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p30_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> inverse_D10_p50_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p34_lanes -
      detail::make_pack<Real>(c12, c19) * inverse_D10_p25_lanes;
  const Lanes<2> inverse_D10_p52_lanes = inverse_D10_p6_lanes * inverse_D10_p8_lanes +
      inverse_D10_p12_lanes * inverse_D10_p20_lanes;
  const Lanes<2> inverse_D11_p19_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p18_lanes;
  const Lanes<2> inverse_D10_p53_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p46_lanes;
  const Lanes<2> inverse_D10_p56_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p46_lanes;
  const Lanes<2> inverse_D10_p57_lanes = 0.269 * inverse_D10_p50_lanes;
  const Lanes<2> inverse_D8_p1_lanes = 6e-04 - inverse_D10_p47_lanes;
  const Lanes<2> inverse_D10_p59_lanes = detail::make_pack<Real>(s12, s19) *
      (inverse_D10_p33_lanes - inverse_D10_p32_lanes) + detail::make_pack<Real>(c12, c19) *
      (2.0 * inverse_D10_p31_lanes);
  const Lanes<2> inverse_D10_p63_lanes = inverse_D10_p56_lanes + inverse_D10_p57_lanes;
  const Lanes<2> inverse_D8_p2_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      inverse_D10_p53_lanes;
  const Lanes<2> inverse_D10_p64_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p59_lanes;
  const Lanes<2> inverse_D10_p65_lanes = inverse_D10_p49_lanes + 0.269 * inverse_D10_p52_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p66_lanes = 2.0 * detail::make_pack<Real>(c11, c18);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p67_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p18_lanes + 0.269 * inverse_D10_p47_lanes);
  const Lanes<2> inverse_D10_p68_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      inverse_D10_p53_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p16_lanes + inverse_D11_p19_lanes));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p71_lanes = inverse_D10_p32_lanes + inverse_D10_p64_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p77_lanes = inverse_D10_p67_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p78_lanes = inverse_D10_p68_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p4_lanes = inverse_D8_p2_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D8_p5_lanes = inverse_D8_p1_lanes * inverse_D11_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p1_lanes = 2.0 * detail::make_pack<Real>(c10, c17);

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p82_lanes = 0.000131 - inverse_D11_p19_lanes - 0.269 *
      (inverse_D10_p49_lanes + inverse_D10_p65_lanes) - inverse_D10_p67_lanes *
      inverse_D10_p77_lanes;
  const Lanes<2> inverse_D10_p83_lanes = 0.0001098 - 0.07236100000000001 * inverse_D10_p71_lanes -
      inverse_D10_p68_lanes * inverse_D10_p78_lanes;
  const Lanes<2> inverse_D10_p84_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      inverse_D10_p63_lanes - inverse_D10_p67_lanes * inverse_D10_p78_lanes;
  const Lanes<2> inverse_D8_p10_lanes = inverse_D10_p67_lanes * inverse_D8_p4_lanes -
      inverse_D10_p63_lanes;
  const Lanes<2> inverse_D8_p11_lanes = inverse_D10_p57_lanes - inverse_D10_p68_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D8_p12_lanes = 0.269 * inverse_D10_p71_lanes + inverse_D10_p68_lanes *
      inverse_D8_p4_lanes;
  const Lanes<2> inverse_D8_p13_lanes = inverse_D10_p65_lanes + inverse_D10_p67_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D10_p88_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p82_lanes - inverse_D10_p83_lanes) + inverse_D10_p66_lanes *
      inverse_D10_p84_lanes;
  const Lanes<2> inverse_D8_p18_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p10_lanes - inverse_D8_p11_lanes) + detail::make_pack<Real>(c11, c18) *
      (inverse_D8_p12_lanes - inverse_D8_p13_lanes);
  const Lanes<2> inverse_D10_p89_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p88_lanes;
  const Lanes<2> inverse_D8_p19_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p20_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p18_lanes;
  const Lanes<2> inverse_D8_p21_lanes = inverse_D8_p11_lanes + inverse_D8_p20_lanes;
  const Lanes<2> inverse_D10_p91_lanes = 0.060888541114265754 +
      (inverse_D10_p83_lanes + inverse_D10_p89_lanes);
  const Lanes<2> inverse_D9_p5_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p88_lanes -
      inverse_D10_p84_lanes);
  const Lanes<2> inverse_D8_p27_lanes = inverse_D10_p71_lanes + inverse_D8_p2_lanes *
      inverse_D8_p4_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p91_lanes;
  const Lanes<2> inverse_D9_p7_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p91_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p28_lanes = inverse_D10_p52_lanes + inverse_D8_p1_lanes *
      inverse_D8_p5_lanes;
  const Lanes<2> inverse_D8_p29_lanes = inverse_D8_p2_lanes * inverse_D8_p5_lanes -
      inverse_D10_p50_lanes;
  const Lanes<2> inverse_D8_p33_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D8_p28_lanes - inverse_D8_p27_lanes) + inverse_D10_p66_lanes * inverse_D8_p29_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p9_lanes = inverse_D9_p5_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p11_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p91_lanes;
  const Lanes<2> inverse_D8_p34_lanes = inverse_D8_p21_lanes * inverse_D10_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p35_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p33_lanes;
  const Lanes<2> inverse_D8_p37_lanes = inverse_D8_p19_lanes + inverse_D8_p13_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D9_p13_lanes = 0.0001499998887063 + inverse_D9_p5_lanes *
      inverse_D9_p7_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p44_lanes = inverse_D10_p56_lanes - inverse_D10_p28_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p46_lanes = inverse_D8_p37_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D9_p14_lanes = 0.06060754126741261 +
      (inverse_D10_p82_lanes - inverse_D10_p89_lanes) - inverse_D9_p5_lanes * inverse_D9_p9_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p47_lanes = detail::make_pack<Real>(s12, s19) * inverse_D10_p25_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D10_p34_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p49_lanes = inverse_D8_p44_lanes * inverse_D11_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p50_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * inverse_D8_p34_lanes;
  const Lanes<2> inverse_D8_p51_lanes = 0.28049749700000004 +
      (inverse_D8_p19_lanes - inverse_D8_p12_lanes) - inverse_D9_p5_lanes * inverse_D8_p34_lanes;
  const Lanes<2> inverse_D8_p52_lanes = inverse_D8_p35_lanes - inverse_D8_p28_lanes -
      inverse_D8_p21_lanes * inverse_D8_p34_lanes;
  const Lanes<2> inverse_D8_p53_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p46_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D8_p57_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p59_lanes -
      inverse_D10_p31_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p67_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p50_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p51_lanes;
  const Lanes<2> inverse_D8_p68_lanes = inverse_D8_p10_lanes - inverse_D8_p20_lanes -
      inverse_D9_p5_lanes * inverse_D8_p46_lanes;
  const Lanes<2> inverse_D9_p18_lanes = inverse_D9_p1_lanes * inverse_D9_p13_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D9_p14_lanes - inverse_D9_p11_lanes);
  const Lanes<2> inverse_D8_p69_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p51_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p50_lanes;
  const Lanes<2> inverse_D9_p19_lanes = detail::make_pack<Real>(s10, s17) * inverse_D9_p18_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p76_lanes = detail::make_pack<Real>(0.001, (-0.001)) -
      (inverse_D10_p53_lanes - inverse_D10_p29_lanes + 0.269 * inverse_D8_p47_lanes) -
      inverse_D10_p67_lanes * inverse_D8_p49_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p79_lanes = inverse_D8_p69_lanes + 0.282 * inverse_D8_p52_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p80_lanes = 0.269 * inverse_D8_p57_lanes - 6e-04 -
      inverse_D10_p68_lanes * inverse_D8_p49_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p88_lanes = inverse_D8_p27_lanes + inverse_D8_p35_lanes +
      inverse_D8_p37_lanes * inverse_D8_p46_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p92_lanes = inverse_D8_p2_lanes * inverse_D8_p49_lanes -
      inverse_D8_p57_lanes;
  const Lanes<2> inverse_D8_p95_lanes = inverse_D8_p47_lanes + inverse_D8_p1_lanes *
      inverse_D8_p49_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (inverse_D9_p11_lanes - inverse_D9_p19_lanes));

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D8_p99_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * inverse_D8_p76_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D8_p80_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p103_lanes = 0.282 * inverse_D8_p67_lanes -
      (inverse_D9_p13_lanes - detail::make_pack<Real>(c10, c17) * inverse_D9_p18_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D8_p105_lanes = inverse_D8_p99_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D8_p113_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D8_p105_lanes;
  const Lanes<2> inverse_D8_p117_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p33_lanes -
      inverse_D8_p29_lanes - inverse_D8_p37_lanes * inverse_D8_p34_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p118_lanes = 2.0 * detail::make_pack<Real>(s9, s16);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p119_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p76_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D8_p80_lanes + inverse_D9_p5_lanes *
      inverse_D8_p105_lanes;
  const Lanes<2> inverse_D8_p121_lanes = inverse_D10_p64_lanes - inverse_D10_p33_lanes -
      inverse_D8_p44_lanes * inverse_D8_p49_lanes - inverse_D8_p99_lanes * inverse_D8_p105_lanes;
  const Lanes<2> inverse_D8_p122_lanes = detail::make_pack<Real>(c11, c18) * inverse_D8_p92_lanes +
      detail::make_pack<Real>(s11, s18) * inverse_D8_p95_lanes + inverse_D8_p37_lanes *
      inverse_D8_p105_lanes;
  const Lanes<2> inverse_D8_p123_lanes = detail::make_pack<Real>(s11, s18) * inverse_D8_p92_lanes -
      detail::make_pack<Real>(c11, c18) * inverse_D8_p95_lanes + inverse_D8_p99_lanes *
      inverse_D8_p34_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p125_lanes = inverse_D8_p103_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D8_p131_lanes = inverse_D8_p103_lanes * inverse_D8_p125_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p134_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p117_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D8_p123_lanes;
  const Lanes<2> inverse_D6_p5_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p123_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D8_p117_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D8_p135_lanes = 0.0019585440854647937 +
      (inverse_D9_p14_lanes + inverse_D9_p19_lanes + 0.282 *
      (inverse_D8_p69_lanes + inverse_D8_p79_lanes)) - inverse_D8_p131_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D8_p136_lanes = detail::make_pack<Real>(c10, c17) *
      (inverse_D8_p53_lanes + inverse_D8_p119_lanes) - detail::make_pack<Real>(s10, s17) *
      (inverse_D8_p68_lanes + inverse_D8_p113_lanes);
  const Lanes<2> inverse_D8_p137_lanes = detail::make_pack<Real>(s10, s17) *
      (inverse_D8_p88_lanes + inverse_D8_p121_lanes) + inverse_D9_p1_lanes * inverse_D8_p122_lanes;
  const Lanes<2> inverse_D8_p138_lanes = 0.282 * inverse_D8_p134_lanes;
  const Lanes<2> inverse_D8_p139_lanes = detail::make_pack<Real>(c10, c17) * inverse_D8_p136_lanes;
  const Lanes<2> inverse_D8_p140_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p137_lanes;
  const Lanes<2> inverse_D8_p141_lanes = detail::make_pack<Real>(s10, s17) * inverse_D8_p136_lanes;
  const Lanes<2> inverse_D8_p142_lanes = inverse_D8_p119_lanes - inverse_D8_p139_lanes;
  const Lanes<2> inverse_D8_p143_lanes = inverse_D8_p140_lanes - inverse_D8_p88_lanes;
  const Lanes<2> inverse_D6_p11_lanes = inverse_D8_p113_lanes + inverse_D8_p141_lanes;
  const Lanes<2> inverse_D6_p13_lanes = inverse_D8_p122_lanes - detail::make_pack<Real>(c10, c17) *
      inverse_D8_p137_lanes;
  const Lanes<2> inverse_D8_p147_lanes = inverse_D8_p68_lanes + inverse_D8_p141_lanes +
      inverse_D8_p138_lanes;
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
      (0.282 * inverse_D6_p5_lanes - (inverse_D8_p53_lanes - inverse_D8_p139_lanes)) +
      inverse_D8_p103_lanes * inverse_D6_p19_lanes;
  const Lanes<2> inverse_D6_p51_lanes = inverse_D8_p147_lanes + inverse_D8_p103_lanes *
      inverse_D6_p27_lanes;
  const Lanes<2> inverse_D6_p53_lanes = inverse_D8_p149_lanes * inverse_D6_p27_lanes - 0.282 *
      inverse_D8_p143_lanes;
  const Lanes<2> inverse_D6_p55_lanes = inverse_D8_p138_lanes + inverse_D8_p149_lanes *
      inverse_D6_p29_lanes;
  const Lanes<2> inverse_D6_p57_lanes = inverse_D8_p79_lanes - inverse_D8_p103_lanes *
      inverse_D6_p29_lanes;
  const Lanes<2> inverse_D6_p59_lanes = 0.0022500062 + 0.282 * inverse_D6_p13_lanes +
      inverse_D8_p149_lanes * inverse_D6_p19_lanes;
  const Lanes<2> inverse_D8_p155_lanes = 0.0008177492704690715 + 0.07952399999999998 *
      inverse_D8_p143_lanes - inverse_D8_p149_lanes * inverse_D8_p151_lanes;
  const Lanes<2> inverse_D8_p156_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * inverse_D8_p147_lanes - inverse_D8_p103_lanes *
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
      (inverse_D8_p135_lanes - inverse_D8_p155_lanes) - inverse_D8_p118_lanes *
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
      (inverse_D8_p135_lanes - inverse_D8_p161_lanes) - inverse_D7_p5_lanes * inverse_D7_p8_lanes;
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
  const Lanes<2> inverse_D6_p157_lanes = inverse_D8_p134_lanes + inverse_D6_p17_lanes *
      inverse_D6_p29_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p17_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D7_p9_lanes - inverse_D7_p12_lanes) + inverse_D7_p1_lanes * inverse_D7_p13_lanes;
  const Lanes<2> inverse_D6_p163_lanes = detail::make_pack<Real>(c8, c15) *
      (inverse_D6_p119_lanes + inverse_D6_p109_lanes) - detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p111_lanes + inverse_D6_p121_lanes);
  const Lanes<2> inverse_D6_p173_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * inverse_D6_p123_lanes + detail::make_pack<Real>(c8, c15) *
      inverse_D6_p125_lanes);
  const Lanes<2> inverse_D7_p18_lanes = detail::make_pack<Real>(s8, s15) * inverse_D7_p17_lanes;
  const Lanes<2> inverse_D6_p181_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p163_lanes;
  const Lanes<2> inverse_D6_p191_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p163_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p193_lanes = inverse_D6_p13_lanes + inverse_D6_p17_lanes *
      inverse_D6_p19_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p195_lanes = inverse_D8_p121_lanes - inverse_D8_p140_lanes -
      inverse_D6_p11_lanes * inverse_D6_p19_lanes - inverse_D6_p83_lanes * inverse_D6_p97_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p199_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D6_p151_lanes - inverse_D6_p153_lanes) - inverse_D8_p118_lanes *
      inverse_D6_p157_lanes;
  const Lanes<2> inverse_D6_p201_lanes = inverse_D6_p5_lanes + inverse_D6_p23_lanes *
      inverse_D6_p19_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p20_lanes = 0.000448 + (inverse_D7_p12_lanes + inverse_D7_p18_lanes);
  const Lanes<2> inverse_D6_p211_lanes = 0.0017499999999999998 +
      (inverse_D6_p181_lanes - inverse_D6_p109_lanes);

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D6_p213_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p199_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p225_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p17_lanes -
      inverse_D7_p13_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D7_lanes = 1.0 / inverse_D7_p20_lanes;
  const Lanes<2> inverse_D6_p237_lanes = 2.0 * detail::make_pack<Real>(s7, s14);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p239_lanes = inverse_D6_p151_lanes - inverse_D6_p213_lanes -
      inverse_D6_p93_lanes * inverse_D6_p99_lanes;
  const Lanes<2> inverse_D6_p241_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p193_lanes -
      detail::make_pack<Real>(c9, c16) * inverse_D6_p201_lanes + inverse_D6_p83_lanes *
      inverse_D6_p99_lanes;
  const Lanes<2> inverse_D6_p243_lanes = detail::make_pack<Real>(c9, c16) * inverse_D6_p193_lanes +
      detail::make_pack<Real>(s9, s16) * inverse_D6_p201_lanes + inverse_D6_p83_lanes *
      inverse_D6_p101_lanes;
  const Lanes<2> inverse_D6_p247_lanes = detail::make_pack<Real>(s9, s16) * inverse_D6_p199_lanes +
      inverse_D6_p157_lanes - inverse_D6_p93_lanes * inverse_D6_p101_lanes;
  const Lanes<2> inverse_D6_p249_lanes = inverse_D6_p121_lanes + inverse_D6_p191_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p265_lanes = inverse_D6_p211_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p267_lanes = inverse_D6_p173_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p271_lanes = inverse_D6_p249_lanes * inverse_D7_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p275_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D6_p195_lanes - inverse_D6_p239_lanes) + inverse_D7_p1_lanes * inverse_D6_p241_lanes;

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
      2.6249999999999998e-05) * inverse_D6_p267_lanes;
  const Lanes<2> inverse_D6_p293_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p265_lanes;
  const Lanes<2> inverse_D6_p299_lanes = inverse_D6_p153_lanes + inverse_D6_p213_lanes -
      inverse_D6_p95_lanes * inverse_D6_p101_lanes - inverse_D6_p173_lanes * inverse_D6_p267_lanes;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p5 = s24 + s23;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p301_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p243_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p247_lanes - inverse_D6_p173_lanes *
      inverse_D6_p265_lanes;
  const Lanes<2> inverse_D6_p303_lanes = inverse_D6_p111_lanes + inverse_D6_p191_lanes +
      inverse_D6_p225_lanes * inverse_D6_p265_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D22_p4_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Lanes<2> inverse_D21_p6_lanes = detail::make_pack<Real>(s23, s24) * inverse_D21_p1_lanes;
  const Lanes<2> inverse_D21_p10_lanes = inverse_D21_p3_lanes - 0.0007770270270270272;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p307_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p123_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D6_p125_lanes - inverse_D6_p225_lanes *
      inverse_D6_p267_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p12_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p315_lanes = detail::make_pack<Real>(s8, s15) * inverse_D6_p243_lanes +
      detail::make_pack<Real>(c8, c15) * inverse_D6_p247_lanes - inverse_D6_p173_lanes *
      inverse_D6_p271_lanes;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p6 = inverse_D22_p4_lanes[1] + inverse_D22_p4_lanes[0];
  const Lanes<2> inverse_D21_p14_lanes = 0.006756756756756757 * detail::make_pack<Real>(s23, s24);
  const Real inverse_D21_p16 = inverse_D21_p6_lanes[1] + inverse_D21_p6_lanes[0];
  const Lanes<2> inverse_D21_p17_lanes = detail::make_pack<Real>(0.032, (-0.032)) *
      inverse_D21_p10_lanes;
  const Real inverse_D6_p317 = 0.431222972972973 + inverse_D21_p3_lanes[1] +
      inverse_D21_p10_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p318_lanes = inverse_D6_p195_lanes - inverse_D6_p285_lanes -
      inverse_D6_p211_lanes * inverse_D6_p265_lanes;
  const Lanes<2> inverse_D6_p322_lanes = detail::make_pack<Real>(c8, c15) * inverse_D6_p275_lanes -
      inverse_D6_p241_lanes - inverse_D6_p211_lanes * inverse_D6_p271_lanes;

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
      (inverse_D6_p299_lanes - inverse_D6_p318_lanes) - inverse_D6_p237_lanes *
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
  const Real inverse_D3_p1 = inverse_D6_p324 * inverse_D6_p357;
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
  const Real inverse_D3_p2 = inverse_D6_p317 * inverse_D6_p356;
  const Real inverse_D3_p3 = inverse_D21_p19_lanes[1] + inverse_D21_p19_lanes[0] - inverse_D6_p317 *
      inverse_D6_p357;
  const Real inverse_D21_p45 = 0.009438624999999999 - (-0.032) * inverse_D21_p35_lanes[1] - 0.032 *
      inverse_D21_p35_lanes[0] - inverse_D21_p24 * inverse_D21_p42 + 0.095 * inverse_D21_p41;
  const Real inverse_D21_p46 = 0.0074 - (-0.032) * inverse_D21_p6_lanes[1] - 0.032 *
      inverse_D21_p6_lanes[0] + inverse_D21_p23 * inverse_D21_p42 - 0.095 * inverse_D21_p39;
  const Real inverse_D3_p4 = inverse_D6_p324 * inverse_D6_p356;
  const Real inverse_D3_p5 = inverse_D21_p21_lanes[1] + inverse_D21_p21_lanes[0] + inverse_D6_p317 *
      inverse_D6_p355;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p370_lanes = inverse_D6_p225_lanes * inverse_D7_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p372 = c22 * inverse_D6_p366 - s22 * inverse_D6_p367;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p375_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p20_lanes;
  const Lanes<2> inverse_D6_p377_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D6_p349_lanes + inverse_D6_p361_lanes);

  // link 22 (head), articulated inertia
  const Real inverse_D3_p6 = c22 * inverse_D3_p1 - s22 * inverse_D3_p3;
  const Real inverse_D6_p379 = s22 * (inverse_D6_p363 + inverse_D6_p360) + c22 *
      (inverse_D6_p365 - inverse_D6_p364);
  const Real inverse_D21_p47 = s22 * (inverse_D21_p44 - inverse_D21_p45) + inverse_D21_p40 *
      inverse_D21_p46;
  const Real inverse_D6_p386 = c22 * inverse_D6_p379;
  const Real inverse_D3_p7 = s22 * inverse_D6_p379;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p387_lanes = 0.0002975 + (inverse_D7_p9_lanes - inverse_D7_p18_lanes) -
      inverse_D6_p225_lanes * inverse_D6_p370_lanes;
  const Lanes<2> inverse_D6_p389_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p370_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p48 = s22 * inverse_D21_p47;
  const Real inverse_D3_p8 = inverse_D21_p40 * inverse_D3_p2 - s22 *
      (inverse_D3_p4 - inverse_D3_p5);
  const Real inverse_D6_p391 = c22 * inverse_D6_p367 + s22 * inverse_D6_p366;
  const Real inverse_D6_p392 = inverse_D6_p386 - inverse_D6_p365;
  const Real inverse_D3_p9 = inverse_D3_p7 - inverse_D6_p360;
  const Real inverse_D6_p395 = inverse_D21_p29_lanes[1] + inverse_D21_p29_lanes[0] -
      inverse_D21_p16 * inverse_D6_p357;
  const Real inverse_D6_p396 = s22 * inverse_D3_p8;
  const Real inverse_D6_p397 = 0.394 * inverse_D6_p392;
  const Real inverse_D6_p398 = inverse_D6_p396 - inverse_D3_p5;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p399_lanes = 0.0001505 - inverse_D6_p375_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D3_p10 = inverse_D3_p2 - c22 * inverse_D3_p8;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p401 = 2.0 * s21;
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p45 + inverse_D21_p48));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p402 = inverse_D6_p391 - 0.394 * inverse_D6_p395;
  const Real inverse_D6_p403 = 0.0016155 + (c22 * inverse_D21_p47 - inverse_D21_p46 + 0.394 *
      inverse_D6_p372);
  const Real inverse_D6_p404 = c22 * inverse_D3_p3 + s22 * inverse_D3_p1;
  const Real inverse_D6_p407 = 0.394 * inverse_D6_p404;
  const Real inverse_D6_p416 = inverse_D6_p363 - inverse_D3_p7 - inverse_D6_p407;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p419_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p271_lanes;
  const Lanes<2> inverse_D6_p427_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p399_lanes - inverse_D6_p387_lanes) + inverse_D6_p237_lanes *
      inverse_D6_p389_lanes;
  const Lanes<2> inverse_D6_p429_lanes = inverse_D6_p181_lanes - inverse_D6_p119_lanes -
      0.0017499999999999998 - inverse_D6_p225_lanes * inverse_D6_p271_lanes;
  const Lanes<2> inverse_D6_p433_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p427_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p435 = inverse_D6_p397 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p436_lanes = inverse_D6_p239_lanes + inverse_D6_p285_lanes -
      inverse_D6_p249_lanes * inverse_D6_p271_lanes;
  const Lanes<2> inverse_D5_p1_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p337_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p11 = inverse_D3_p9 * inverse_D21;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p442 = inverse_D6_p433_lanes[1] + inverse_D6_p433_lanes[0];
  const Lanes<2> inverse_D3_p14_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p341_lanes +
      inverse_D6_p301_lanes;
  const Lanes<2> inverse_D6_p443_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p419_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p429_lanes;
  const Lanes<2> inverse_D3_p16_lanes = inverse_D6_p291_lanes + inverse_D5_p1_lanes;
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
  const Lanes<2> inverse_D3_p18_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      inverse_D3_p14_lanes;
  const Lanes<2> inverse_D5_p17_lanes = 0.226 * inverse_D5_p11_lanes;
  const Lanes<2> inverse_D6_p450_lanes = inverse_D6_p443_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D6_p339_lanes + 0.226 *
      inverse_D6_p436_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p20 = inverse_D6_p403 * inverse_D3_p11 -
      (inverse_D6_p386 + inverse_D6_p364 + 0.394 * inverse_D3_p6);
  const Real inverse_D3_p21 = inverse_D6_p397 * inverse_D3_p11 -
      (0.0045000000000000005 + 0.394 * inverse_D3_p10);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D3_p22_lanes = inverse_D3_p18_lanes - inverse_D3_p16_lanes;
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
      (inverse_D3_p18_lanes + inverse_D5_p17_lanes);

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
      (inverse_D5_p27_lanes + inverse_D3_p16_lanes);

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p36 = inverse_D6_p407 + inverse_D6_p397 * inverse_D5_p26;
  const Real inverse_D5_p37 = inverse_D6_p402 + inverse_D6_p403 * inverse_D5_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D3_p24 = c21 * inverse_D3_p20 - s21 * inverse_D3_p21 +
      inverse_D6_p361_lanes[1] + inverse_D6_p361_lanes[0];

  // link 6 (chest3), articulated inertia
  const Real inverse_D3_p25 = inverse_D3_p14_lanes[1] + inverse_D3_p14_lanes[0];

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p38 = s21 * inverse_D6_p453 + inverse_D6_p449 + 0.226 * inverse_D5_p31;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p39 = c21 * (inverse_D5_p32 - inverse_D5_p36) - s21 *
      (inverse_D5_p33 + inverse_D5_p37);
  const Real inverse_D5_p40 = c21 * inverse_D5_p39;
  const Real inverse_D3_p26 = s21 * inverse_D5_p39;
  const Real inverse_D3_p27 = inverse_D6_p392 * inverse_D3_p11 - inverse_D3_p10;
  const Real inverse_D3_p28 = inverse_D3_p6 - inverse_D5_p24 * inverse_D3_p11;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p455 = 2.06965463592404 + inverse_D6_p448 + inverse_D6_p454 +
      inverse_D6_p387_lanes[1] + inverse_D6_p442 + inverse_D6_p377_lanes[1] +
      inverse_D6_p387_lanes[0] + inverse_D6_p377_lanes[0] + 0.226 *
      (inverse_D6_p443_lanes[1] + inverse_D6_p452 + inverse_D6_p443_lanes[0]);

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p29 = inverse_D6_p398 - inverse_D6_p392 * inverse_D5_p21;
  const Real inverse_D3_p30 = inverse_D6_p395 - inverse_D5_p24 * inverse_D5_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p41 = inverse_D5_p36 + inverse_D5_p40 + inverse_D5_p31;
  const Real inverse_D5_p42 = 0.0187369177636143 + inverse_D5_p34_lanes[1] -
      inverse_D6_p389_lanes[1] + inverse_D5_p9_lanes[1] + inverse_D5_p34_lanes[0] -
      inverse_D6_p389_lanes[0] + inverse_D5_p9_lanes[0] + 0.226 * inverse_D5_p25;

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p455;

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p31 = inverse_D6_p404 + inverse_D6_p392 * inverse_D5_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p43_lanes = inverse_D6_p343_lanes + inverse_D6_p307_lanes;
  const Lanes<2> inverse_D5_p45_lanes = inverse_D6_p318_lanes + inverse_D6_p347_lanes;
  const Real inverse_D3_p32 = inverse_D3_p26 + inverse_D5_p37 - 6.1665928899999995 -
      inverse_D6_p452;
  const Lanes<2> inverse_D5_p49_lanes = inverse_D5_p43_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p45_lanes;

  // link 21 (neck), articulated inertia
  const Real inverse_D3_p33 = c21 * (inverse_D3_p29 - inverse_D3_p30) - inverse_D6_p401 *
      inverse_D3_p31;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p51 = inverse_D5_p45_lanes[1] + inverse_D5_p45_lanes[0];
  const Real inverse_D5_p52 = inverse_D5_p41 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p53 = c21 * inverse_D3_p33;

  // link 6 (chest3), articulated inertia
  const Real inverse_D3_p34 = inverse_D3_p24 * inverse_D6;
  const Real inverse_D3_p35 = inverse_D3_p32 * inverse_D6;
  const Real inverse_D5_p54 = inverse_D5_p42 * inverse_D6;
  const Real inverse_D5_p57 = inverse_D5_p38 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p58_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p43_lanes + inverse_D5_p49_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p60 = inverse_D5_p49_lanes[1] + inverse_D5_p49_lanes[0] - inverse_D5_p42 *
      inverse_D5_p52;
  const Real inverse_D5_p61 = inverse_D3_p30 + inverse_D5_p53 + inverse_D5_p51 - inverse_D5_p41 *
      inverse_D5_p52;
  const Real inverse_D3_p36 = inverse_D3_p22_lanes[1] + inverse_D3_p22_lanes[0] + inverse_D5_p42 *
      inverse_D3_p34;
  const Real inverse_D5_p62 = 6.1665928899999995 + inverse_D3_p26 + inverse_D5_p33 -
      inverse_D5_p38 * inverse_D5_p52 + 0.226 * inverse_D5_p51;
  const Real inverse_D5_p63 = 2.0 * c6;
  const Real inverse_D3_p37 = inverse_D5_p32 - inverse_D5_p40 + inverse_D5_p17_lanes[1] +
      inverse_D5_p17_lanes[0] - inverse_D5_p38 * inverse_D3_p35;
  const Real inverse_D3_p38 = inverse_D5_p38 * inverse_D3_p34 -
      (s21 * inverse_D3_p20 + c21 * inverse_D3_p21) + 0.226 * inverse_D3_p25;
  const Real inverse_D3_p39 = (-0.18) * inverse_D5_p11_lanes[1] - inverse_D5_p25 + 0.18 *
      inverse_D5_p11_lanes[0] - inverse_D5_p42 * inverse_D3_p35;
  const Real inverse_D3_p40 = inverse_D3_p25 - c21 * inverse_D3_p27 + s21 * inverse_D3_p28 +
      inverse_D3_p24 * inverse_D5_p52;
  const Real inverse_D3_p41 = s21 * inverse_D3_p33 + inverse_D3_p31 + inverse_D5_p11_lanes[1] +
      inverse_D5_p11_lanes[0] - inverse_D3_p32 * inverse_D5_p52;
  const Real inverse_D5_p64 = 1.66923963592404 + inverse_D6_p447 - inverse_D6_p454 -
      inverse_D5_p38 * inverse_D5_p57 + 0.051076 * inverse_D5_p51;
  const Real inverse_D5_p65 = s6 * inverse_D5_p60 + c6 * inverse_D5_p62;
  const Real inverse_D5_p66 = (-0.04068) * inverse_D5_p45_lanes[1] + 0.04068 *
      inverse_D5_p45_lanes[0] - inverse_D5_p42 * inverse_D5_p57 + 0.226 *
      (inverse_D5_p43_lanes[1] + inverse_D5_p43_lanes[0]);
  const Real inverse_D5_p67 = 0.40056549999999996 - inverse_D6_p375_lanes[1] - inverse_D6_p442 +
      inverse_D5_p58_lanes[1] + inverse_D6_p399_lanes[0] + inverse_D5_p58_lanes[0] -
      inverse_D5_p42 * inverse_D5_p54;
  const Real inverse_D5_p68 = inverse_D5_p65 + 0.072 * inverse_D5_p61;
  const Real inverse_D3_p42 = c6 * inverse_D5_p60 - s6 * inverse_D5_p62;
  const Real inverse_D3_p43 = s6 * (inverse_D3_p36 - inverse_D3_p37) + c6 *
      (inverse_D3_p38 + inverse_D3_p39);
  const Real inverse_D3_p44 = c6 * inverse_D3_p40 - s6 * inverse_D3_p41;
  const Real inverse_D3_p45 = s6 * inverse_D3_p40 + c6 * inverse_D3_p41;
  const Real inverse_D3_p46 = 2.2194301519999997 + inverse_D5_p68;
  const Real inverse_D3_p47 = c6 * inverse_D3_p43;
  const Real inverse_D3_p48 = s6 * inverse_D3_p43;
  const Real inverse_D3_p49 = 0.072 * inverse_D3_p45;
  const Real inverse_D5_p69 = s6 * (inverse_D5_p67 - inverse_D5_p64) + inverse_D5_p63 *
      inverse_D5_p66;
  const Real inverse_D3_p50 = inverse_D3_p37 + inverse_D3_p48 + inverse_D3_p49;
  const Real inverse_D5_p70 = s6 * inverse_D5_p69;
  const Real inverse_D3_p51 = inverse_D3_p29 - inverse_D5_p53 + inverse_D6_p436_lanes[1] +
      inverse_D6_p436_lanes[0] - inverse_D3_p32 * inverse_D3_p35;
  const Real inverse_D3_p52 = inverse_D3_p47 - inverse_D3_p38;
  const Real inverse_D3_p53 = inverse_D6_p351_lanes[1] -
      (inverse_D3_p4 + inverse_D6_p396 + inverse_D3_p9 * inverse_D3_p11) +
      inverse_D6_p351_lanes[0] - inverse_D3_p24 * inverse_D3_p34;
  const Real inverse_D3_p54 = 0.069699984375 + (inverse_D3_p47 - inverse_D3_p39 + 0.072 *
      inverse_D3_p44);
  const Real inverse_D3_p55 = 0.072 * inverse_D3_p50;
  const Real inverse_D3_p56 = inverse_D6_p339_lanes[1] -
      (s21 * inverse_D3_p27 + c21 * inverse_D3_p28) + inverse_D6_p339_lanes[0] + inverse_D3_p24 *
      inverse_D3_p35;
  const Real inverse_D3_p57 = c6 * inverse_D5_p69 - inverse_D5_p66 + 0.072 * inverse_D3_p42;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p64 + inverse_D5_p70 + 0.072 * (inverse_D5_p65 + inverse_D5_p68)));

  // link 6 (chest3), articulated inertia
  const Real inverse_D3_p58 = s6 * (inverse_D3_p53 - inverse_D3_p51) + inverse_D5_p63 *
      inverse_D3_p56;
  const Real inverse_D3_p59 = s6 * inverse_D3_p58;
  const Real inverse_D3_p60 = c6 * inverse_D3_p58 - inverse_D3_p56;
  const Real inverse_D3_p61 = inverse_D3_p51 + inverse_D3_p59;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p62 = inverse_D3_p46 * inverse_D5;
  const Real inverse_D3_p63 = inverse_D3_p54 * inverse_D5;
  const Real inverse_D3_p64 = inverse_D3_p50 * inverse_D5;
  const Real inverse_D3_p65 = 2.0 * c5;
  const Real inverse_D3_p66 = inverse_D3_p53 - inverse_D3_p59 - inverse_D3_p54 * inverse_D3_p63;
  const Real inverse_D3_p67 = inverse_D5_p61 - inverse_D3_p46 * inverse_D3_p62;
  const Real inverse_D3_p68 = inverse_D3_p44 - inverse_D3_p46 * inverse_D3_p63;
  const Real inverse_D3_p69 = inverse_D3_p55 * inverse_D3_p62 - inverse_D3_p49;
  const Real inverse_D3_p70 = inverse_D3_p36 - inverse_D3_p48 - inverse_D3_p57 * inverse_D3_p63;
  const Real inverse_D3_p71 = inverse_D3_p42 - inverse_D3_p57 * inverse_D3_p62;
  const Real inverse_D3_p72 = inverse_D3_p55 * inverse_D3_p63 - 0.072 * inverse_D3_p60;
  const Real inverse_D3_p73 = inverse_D3_p60 - inverse_D3_p54 * inverse_D3_p64;
  const Real inverse_D3_p74 = inverse_D3_p45 - inverse_D3_p46 * inverse_D3_p64;
  const Real inverse_D3_p75 = inverse_D3_p52 - 0.069699984375 - inverse_D3_p57 * inverse_D3_p64;
  const Real inverse_D3_p76 = inverse_D3_p55 * inverse_D3_p64 -
      (2.2194301519999997 + 0.072 * inverse_D3_p61);
  const Real inverse_D4_p1 = inverse_D3_p55 * inverse_D5;
  const Real inverse_D4_p2 = inverse_D3_p57 * inverse_D5;
  const Real inverse_D3_p77 = 0.005880002159562879 * s4;
  const Real inverse_D3_p78 = s5 * (inverse_D3_p67 - inverse_D3_p66) + inverse_D3_p65 *
      inverse_D3_p68;
  const Real inverse_D3_p79 = s5 * inverse_D3_p75 - c5 * inverse_D3_p76;
  const Real inverse_D2_p1 = 0.0300000063 * s4;
  const Real inverse_D4_p3 = 0.15637308509675518 + 0.005183999999999999 * inverse_D3_p61 -
      inverse_D3_p55 * inverse_D4_p1;
  const Real inverse_D3_p80 = s5 * (inverse_D3_p69 - inverse_D3_p70) + c5 *
      (inverse_D3_p71 + inverse_D3_p72);
  const Real inverse_D3_p81 = s5 * inverse_D3_p78;
  const Real inverse_D4_p4 = 0.04675382692737882 + (inverse_D5_p67 - inverse_D5_p70) -
      inverse_D3_p57 * inverse_D4_p2;
  const Real inverse_D4_p5 = 0.005678398088837119 - 0.072 * inverse_D3_p52 + inverse_D3_p55 *
      inverse_D4_p2;
  const Real inverse_D3_p82 = s5 * inverse_D3_p80;
  const Real inverse_D3_p83 = c5 * inverse_D3_p80;
  const Real inverse_D3_p84 = 0.03561389675370483 * s4;
  const Real inverse_D3_p85 = inverse_D3_p67 - inverse_D3_p81;
  const Real inverse_D3_p86 = s4 * inverse_D3_p84;
  const Real inverse_D4_p6 = s5 * (inverse_D4_p3 - inverse_D4_p4) + inverse_D3_p65 * inverse_D4_p5;
  const Real inverse_D3_p87 = s4 * (s5 * inverse_D3_p76 + c5 * inverse_D3_p75) - c4 *
      (inverse_D3_p83 - inverse_D3_p72);
  const Real inverse_D4_p7 = s5 * inverse_D4_p6;
  const Real inverse_D3_p88 = c4 * (2.0 * (s5 * inverse_D3_p73 - c5 * inverse_D3_p74)) - s4 *
      (inverse_D3_p85 - (inverse_D3_p61 - inverse_D3_p50 * inverse_D3_p64));
  const Real inverse_D2_p2 = inverse_D2_p1 + inverse_D3_p87;
  const Real inverse_D2_p3 = 0.0300000063 * c4;
  const Real inverse_D2_p4 = inverse_D3_p70 + inverse_D3_p82;
  const Real inverse_D3_p89 = inverse_D3_p79 - c4 *
      (c4 * inverse_D3_p79 - s4 * (inverse_D3_p69 - inverse_D3_p82));

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p5 = 0.02999999505 + inverse_D2_p3;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p90 = inverse_D3_p85 + s4 * inverse_D3_p88;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D4_p4 + inverse_D4_p7));

  // link 5 (chest2), articulated inertia
  const Real inverse_D2_p6 = s4 * (s5 * inverse_D3_p74 + c5 * inverse_D3_p73) - c4 *
      (c5 * inverse_D3_p78 - inverse_D3_p68);
  const Real inverse_D2_p7 = s2 * c3 + c2 * s3;
  const Real inverse_D3_p91 = inverse_D3_p77 + (0.21799999999999997 * inverse_D3_p87 - s4 *
      (c5 * inverse_D4_p6 - inverse_D4_p5));
  const Real inverse_D3_p92 = inverse_D3_p89 + 0.21799999999999997 * inverse_D3_p90;
  const Real inverse_D2_p8 = 0.422 * c2;
  const Real inverse_D2_p9 = c2 * c3 - s2 * s3;
  const Real inverse_D2_p10 = 0.422 * s2;

  // link 4 (chest1), articulated inertia
  const Real inverse_D3_p93 = inverse_D3_p91 * inverse_D4;
  const Real inverse_D2_p11 = inverse_D2_p2 * inverse_D4;
  const Real inverse_D2_p12 = inverse_D2_p4 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D3_p94 = 0.01227760324629517 + inverse_D3_p86 +
      (s4 * (s4 * (inverse_D4_p3 - inverse_D4_p7)) + 0.21799999999999997 *
      (inverse_D3_p89 + inverse_D3_p92));

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1_lanes = 0.269 * detail::make_pack<Real>(s11, s18);
  const Lanes<2> f13_x_p3_lanes = 0.269 * detail::make_pack<Real>(c11, c18);

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p13 = inverse_D2_p5 + 0.21799999999999997 * inverse_D2_p6 - s4 *
      (inverse_D3_p83 - inverse_D3_p71) - inverse_D3_p91 * inverse_D2_p12;
  const Real inverse_D1_p1 = 0.031999971599999996 * s2 - 24.5839218 * c2;
  const Real inverse_D2_p14 = 8.419374554 + (inverse_D3_p92 - inverse_D3_p91 * inverse_D2_p11);

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p5 = inverse_D9_p7_lanes[1] * f13_x_p1_lanes[1];

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 +
      (inverse_D3_p94 - inverse_D3_p91 * inverse_D3_p93));

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p6 = f13_x_p3_lanes[1] - inverse_D9_p9_lanes[1] * f13_x_p1_lanes[1];
  const Real f13_x_p7 = c18 - inverse_D8_p34_lanes[1] * f13_x_p1_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p10_lanes = inverse_D8_p105_lanes * f13_x_p1_lanes;
  const Lanes<2> f13_x_p12_lanes = -detail::make_pack<Real>(s11, s18) - inverse_D8_p46_lanes *
      f13_x_p1_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p14 = c17 * f13_x_p5 - s17 * f13_x_p6;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p13 * inverse_D3;
  const Real inverse_D2_p16 = inverse_D2_p14 * inverse_D3;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p19_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p12_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p10_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p21 = c17 * f13_x_p6 + s17 * f13_x_p5 + 0.282 * f13_x_p7 -
      inverse_D8_p125_lanes[1] * f13_x_p14;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p22_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p26_lanes = 0.269 * detail::make_pack<Real>(s12, s19);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = inverse_D2_p14 * inverse_D2_p15 -
      (inverse_D2_p6 - inverse_D2_p2 * inverse_D2_p12);
  const Real inverse_D2_p18 = inverse_D3_p90 - inverse_D2_p2 * inverse_D2_p11 - inverse_D2_p14 *
      inverse_D2_p16;
  const Real inverse_D2_p19 = inverse_D3_p66 + inverse_D3_p81 - inverse_D2_p4 * inverse_D2_p12 -
      inverse_D2_p13 * inverse_D2_p15;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p28_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p26_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<2> f13_x_p32_lanes = -(0.282 * f13_x_p19_lanes);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p34 = f13_x_p32_lanes[1] - inverse_D8_p151_lanes[1] * f13_x_p14;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> neg_s12_lanes = -detail::make_pack<Real>(s12, s19);

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p35 = inverse_D9_p7_lanes[1] * f13_x_p28_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p36_lanes = -(detail::make_pack<Real>(s11, s18) * f13_x_p26_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p38_lanes = detail::make_pack<Real>(s11, s18) * neg_s12_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p40 = c16 * f13_x_p21 - s16 * f13_x_p34;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p41_lanes = detail::make_pack<Real>(c11, c18) * neg_s12_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p43 = f13_x_p36_lanes[1] - inverse_D9_p9_lanes[1] * f13_x_p28_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> neg_c12_lanes = -detail::make_pack<Real>(c12, c19);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> neg_neg_c12_lanes = -neg_c12_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p44 = f13_x_p38_lanes[1] - inverse_D8_p34_lanes[1] * f13_x_p28_lanes[1];

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = inverse_D2_p7 * (inverse_D2_p18 - inverse_D2_p19) + inverse_D2_p9 *
      (2.0 * inverse_D2_p17);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p45 = f13_x_p22_lanes[1] * f13_x_p40;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p46 = f13_x_p41_lanes[1] - inverse_D8_p46_lanes[1] * f13_x_p28_lanes[1];
  const Real f13_x_p47 = neg_neg_c12_lanes[1] - inverse_D8_p105_lanes[1] * f13_x_p28_lanes[1];

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = inverse_D2_p7 * inverse_D2_p20;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p48 = s16 * f13_x_p21 + c16 * f13_x_p34 - inverse_D7_p8_lanes[1] * f13_x_p40;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p51 = c17 * f13_x_p35 - s17 * f13_x_p43;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p22 = inverse_D2_p9 * inverse_D2_p20 - inverse_D2_p17;
  const Real inverse_D2_p23 = inverse_D2_p18 - inverse_D2_p21;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p56_lanes = inverse_D11_p5_lanes - inverse_D11_p14_lanes *
      inverse_D12_p7_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p60 = s17 * f13_x_p47 - c17 * f13_x_p46;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p61_lanes = inverse_D10_p19_lanes * inverse_D12_p7_lanes;
  const Lanes<2> f13_x_p63_lanes = -inverse_D10_p8_lanes - inverse_D10_p20_lanes *
      inverse_D12_p7_lanes;
  const Lanes<2> f13_x_p69_lanes = detail::make_pack<Real>(c12, c19) * inverse_D11_p14_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p71 = s15 * f13_x_p45 + c15 * f13_x_p48;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p76 = c17 * f13_x_p43 + s17 * f13_x_p35 + 0.282 * f13_x_p44 -
      inverse_D8_p125_lanes[1] * f13_x_p51;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p77_lanes = inverse_D10_p7_lanes - inverse_D10_p18_lanes *
      inverse_D12_p7_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p24 = inverse_D2_p8 * inverse_D2_p23 + inverse_D2_p10 * inverse_D2_p22;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p87_lanes = -(detail::make_pack<Real>(c12, c19) * f13_x_p56_lanes);
  const Lanes<2> f13_x_p103_lanes = inverse_D10_p78_lanes * neg_c12_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p105_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p19_lanes +
      detail::make_pack<Real>(s12, s19) * inverse_D10_p18_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p109 = 0.282 * f13_x_p60 - inverse_D8_p151_lanes[1] * f13_x_p51;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p112_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p14_lanes -
      0.269 * inverse_D10_p20_lanes - inverse_D10_p77_lanes * f13_x_p69_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p2 = inverse_D2_p24 - inverse_D1_p1;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p114_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p77_lanes -
      detail::make_pack<Real>(c12, c19) * f13_x_p61_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p118_lanes = neg_s12_lanes - inverse_D10_p77_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p122_lanes = 0.269 * f13_x_p63_lanes - detail::make_pack<Real>(s12, s19) *
      f13_x_p56_lanes - inverse_D10_p77_lanes * f13_x_p87_lanes;
  const Lanes<2> f13_x_p124_lanes = -(0.269 * detail::make_pack<Real>(c12, c19));
  const Lanes<2> f13_x_p126_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p124_lanes;
  const Lanes<2> f13_x_p148_lanes = -(0.269 * f13_x_p105_lanes) - inverse_D10_p78_lanes *
      f13_x_p69_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p158_lanes = -(detail::make_pack<Real>(s11, s18) * f13_x_p124_lanes);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p164 = c16 * f13_x_p76 - s16 * f13_x_p109;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p165_lanes = 0.269 * f13_x_p114_lanes - inverse_D10_p78_lanes *
      f13_x_p87_lanes;
  const Lanes<2> f13_x_p169_lanes = inverse_D8_p4_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p171_lanes = inverse_D8_p5_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p173_lanes = -f13_x_p114_lanes + inverse_D8_p4_lanes * f13_x_p87_lanes;
  const Lanes<2> f13_x_p175_lanes = f13_x_p63_lanes - inverse_D8_p5_lanes * f13_x_p87_lanes;
  const Lanes<2> f13_x_p177_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p118_lanes -
      detail::make_pack<Real>(c11, c18) * f13_x_p103_lanes;
  const Lanes<2> f13_x_p181_lanes = f13_x_p105_lanes + inverse_D8_p4_lanes * f13_x_p69_lanes;
  const Lanes<2> f13_x_p183_lanes = -inverse_D10_p20_lanes - inverse_D8_p5_lanes * f13_x_p69_lanes;
  const Lanes<2> f13_x_p185_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p118_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p103_lanes;
  const Lanes<2> f13_x_p187_lanes = detail::make_pack<Real>(s11, s18) *
      detail::make_pack<Real>(c12, c19);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p193 = f13_x_p22_lanes[1] * f13_x_p164;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p194_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p112_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p148_lanes;
  const Lanes<2> f13_x_p210_lanes = detail::make_pack<Real>(c11, c18) *
      detail::make_pack<Real>(c12, c19);
  const Lanes<2> f13_x_p212_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p112_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p148_lanes;
  const Lanes<2> f13_x_p222_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p122_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p165_lanes;
  const Lanes<2> f13_x_p224_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p122_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p165_lanes;
  const Lanes<2> f13_x_p240_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p173_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p175_lanes;
  const Lanes<2> f13_x_p258_lanes = inverse_D8_p49_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p262_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p181_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p183_lanes;
  const Lanes<2> f13_x_p264_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p169_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p171_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p266_lanes = inverse_D9_p7_lanes[0] *
      detail::make_pack<Real>(f13_x_p28_lanes[0], f13_x_p1_lanes[0], f13_x_p126_lanes[0],
      f13_x_p177_lanes[0], f13_x_p194_lanes[0], f13_x_p222_lanes[0], f13_x_p28_lanes[0],
      f13_x_p28_lanes[0]);
  const Lanes<2> neg_neg_s12_lanes = -neg_s12_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p278_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p173_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p175_lanes;
  const Lanes<2> f13_x_p280_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p181_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p183_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p282 = s16 * f13_x_p76 + c16 * f13_x_p109 - inverse_D7_p8_lanes[1] * f13_x_p164;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p285_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p169_lanes -
      detail::make_pack<Real>(c11, c18) * f13_x_p171_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p25 = 9.885744550888212 + (inverse_D2_p10 *
      (inverse_D2_p8 * inverse_D2_p22 + inverse_D2_p10 * (inverse_D2_p19 + inverse_D2_p21)) +
      inverse_D2_p8 * inverse_D2_p24);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p289_lanes = -(detail::make_pack<Real>(s12, s19) * f13_x_p61_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p77_lanes) - inverse_D8_p49_lanes * f13_x_p87_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p291_lanes = detail::make_pack<Real>(f13_x_p36_lanes[0], f13_x_p3_lanes[0],
      f13_x_p158_lanes[0], f13_x_p185_lanes[0], f13_x_p212_lanes[0], f13_x_p224_lanes[0],
      f13_x_p36_lanes[0], f13_x_p36_lanes[0]) - inverse_D9_p9_lanes[0] *
      detail::make_pack<Real>(f13_x_p28_lanes[0], f13_x_p1_lanes[0], f13_x_p126_lanes[0],
      f13_x_p177_lanes[0], f13_x_p194_lanes[0], f13_x_p222_lanes[0], f13_x_p28_lanes[0],
      f13_x_p28_lanes[0]);
  const Lanes<8> f13_x_p297_lanes = detail::make_pack<Real>(f13_x_p41_lanes[0], f13_x_p41_lanes[0],
      f13_x_p210_lanes[0], f13_x_p264_lanes[0], f13_x_p262_lanes[0], f13_x_p240_lanes[0],
      f13_x_p41_lanes[0], f13_x_p41_lanes[0]) - inverse_D8_p46_lanes[0] *
      detail::make_pack<Real>(f13_x_p28_lanes[0], f13_x_p28_lanes[0], f13_x_p126_lanes[0],
      f13_x_p177_lanes[0], f13_x_p194_lanes[0], f13_x_p222_lanes[0], f13_x_p28_lanes[0],
      f13_x_p28_lanes[0]);
  const Lanes<8> f13_x_p316_lanes = detail::make_pack<Real>(f13_x_p38_lanes[0], c11,
      f13_x_p187_lanes[0], f13_x_p285_lanes[0], f13_x_p280_lanes[0], f13_x_p278_lanes[0],
      f13_x_p38_lanes[0], f13_x_p38_lanes[0]) - inverse_D8_p34_lanes[0] *
      detail::make_pack<Real>(f13_x_p28_lanes[0], f13_x_p1_lanes[0], f13_x_p126_lanes[0],
      f13_x_p177_lanes[0], f13_x_p194_lanes[0], f13_x_p222_lanes[0], f13_x_p28_lanes[0],
      f13_x_p28_lanes[0]);
  const Lanes<2> f13_x_p322_lanes = -f13_x_p289_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p341 = f13_x_p19_lanes[1] + inverse_D6_p27_lanes[1] * f13_x_p14;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / inverse_D2_p25;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p342_lanes = -(detail::make_pack<Real>(c12, c19) * inverse_D10_p18_lanes -
      detail::make_pack<Real>(s12, s19) * inverse_D10_p19_lanes - inverse_D8_p49_lanes *
      f13_x_p69_lanes);
  const Lanes<8> f13_x_p344_lanes = detail::make_pack<Real>(neg_neg_c12_lanes[0],
      neg_neg_c12_lanes[0], neg_neg_s12_lanes[0], f13_x_p258_lanes[0], f13_x_p342_lanes[0],
      f13_x_p322_lanes[0], neg_neg_c12_lanes[0], neg_neg_c12_lanes[0]) - inverse_D8_p105_lanes[0] *
      detail::make_pack<Real>(f13_x_p28_lanes[0], f13_x_p28_lanes[0], f13_x_p126_lanes[0],
      f13_x_p177_lanes[0], f13_x_p194_lanes[0], f13_x_p222_lanes[0], f13_x_p28_lanes[0],
      f13_x_p28_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p355 = f13_x_p7 - inverse_D6_p29_lanes[1] * f13_x_p14;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p356 = s15 * f13_x_p193 + c15 * f13_x_p282;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p357 = -f13_x_p60 + inverse_D6_p27_lanes[1] * f13_x_p51;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p358_lanes = c10 * f13_x_p266_lanes - s10 * f13_x_p291_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p370 = f13_x_p44 - inverse_D6_p29_lanes[1] * f13_x_p51;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p376_lanes = inverse_D8_p125_lanes[0] * f13_x_p358_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p410_lanes = s10 * f13_x_p344_lanes - c10 * f13_x_p297_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p415_lanes = c10 * f13_x_p291_lanes + s10 * f13_x_p266_lanes + 0.282 *
      f13_x_p316_lanes - f13_x_p376_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p421_lanes = 0.282 * f13_x_p410_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p426_lanes = -f13_x_p410_lanes;
  const Lanes<8> f13_x_p431_lanes = detail::make_pack<Real>(f13_x_p426_lanes[0], f13_x_p19_lanes[0],
      f13_x_p426_lanes[2], f13_x_p426_lanes[3], f13_x_p426_lanes[4], f13_x_p426_lanes[5],
      f13_x_p426_lanes[0], f13_x_p426_lanes[0]) + inverse_D6_p27_lanes[0] * f13_x_p358_lanes;
  const Lanes<8> f13_x_p437_lanes = f13_x_p316_lanes - inverse_D6_p29_lanes[0] * f13_x_p358_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p443_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p10_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p12_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p457 = s16 * f13_x_p341 + c16 * f13_x_p355 - inverse_D6_p99_lanes[1] * f13_x_p40;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p482_lanes = detail::make_pack<Real>(f13_x_p421_lanes[0], f13_x_p32_lanes[0],
      f13_x_p421_lanes[2], f13_x_p421_lanes[3], f13_x_p421_lanes[4], f13_x_p421_lanes[5],
      f13_x_p421_lanes[0], f13_x_p421_lanes[0]) - inverse_D8_p151_lanes[0] * f13_x_p358_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p504 = s16 * f13_x_p357 + c16 * f13_x_p370 - inverse_D6_p99_lanes[1] *
      f13_x_p164;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p3 = inverse_D1_p2 * inverse_D2;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p523 = -(f13_x_p443_lanes[1] + inverse_D6_p19_lanes[1] * f13_x_p14) +
      inverse_D6_p97_lanes[1] * f13_x_p40;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p535_lanes = c9 * f13_x_p415_lanes - s9 * f13_x_p482_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p547 = -(-(s17 * f13_x_p46 + c17 * f13_x_p47) + inverse_D6_p19_lanes[1] *
      f13_x_p51) + inverse_D6_p97_lanes[1] * f13_x_p164;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p548_lanes = -(s10 * f13_x_p297_lanes + c10 * f13_x_p344_lanes);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p565_lanes = f13_x_p22_lanes[0] * f13_x_p535_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p595_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p597_lanes = s9 * f13_x_p415_lanes + c9 * f13_x_p482_lanes -
      inverse_D7_p8_lanes[0] * f13_x_p535_lanes;
  const Lanes<8> f13_x_p609_lanes = s9 * f13_x_p431_lanes + c9 * f13_x_p437_lanes -
      inverse_D6_p99_lanes[0] * f13_x_p535_lanes;
  const Lanes<8> f13_x_p615_lanes = -(detail::make_pack<Real>(f13_x_p548_lanes[0],
      f13_x_p443_lanes[0], f13_x_p548_lanes[2], f13_x_p548_lanes[3], f13_x_p548_lanes[4],
      f13_x_p548_lanes[5], f13_x_p548_lanes[0], f13_x_p548_lanes[0]) + inverse_D6_p19_lanes[0] *
      f13_x_p358_lanes) + inverse_D6_p97_lanes[0] * f13_x_p535_lanes;
  const Lanes<8> f13_x_p621_lanes = c9 * f13_x_p431_lanes - s9 * f13_x_p437_lanes -
      inverse_D6_p101_lanes[0] * f13_x_p535_lanes;
  const Lanes<8> f13_x_p669_lanes = s8 * f13_x_p565_lanes + c8 * f13_x_p597_lanes;
  const Lanes<8> f13_x_p675_lanes = c8 * f13_x_p615_lanes - s8 * f13_x_p609_lanes;
  const Lanes<8> f13_x_p681_lanes = s8 * f13_x_p615_lanes + c8 * f13_x_p609_lanes;
  const Lanes<8> f13_x_p687_lanes = c8 * f13_x_p565_lanes - s8 * f13_x_p597_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p725_lanes = detail::make_pack<Real>(f13_x_p595_lanes[0],
      f13_x_p595_lanes[0], f13_x_p595_lanes[0], f13_x_p595_lanes[0], f13_x_p595_lanes[0],
      f13_x_p595_lanes[0], f13_x_p595_lanes[1], f13_x_p595_lanes[1]) *
      detail::make_pack<Real>(f13_x_p669_lanes[0], f13_x_p669_lanes[1], f13_x_p669_lanes[2],
      f13_x_p669_lanes[3], f13_x_p669_lanes[4], f13_x_p669_lanes[5], f13_x_p356, f13_x_p71);
  const Lanes<8> f13_x_p733_lanes = detail::make_pack<Real>(f13_x_p621_lanes[0],
      f13_x_p621_lanes[1], f13_x_p621_lanes[2], f13_x_p621_lanes[3], f13_x_p621_lanes[4],
      f13_x_p621_lanes[5], c16 * f13_x_p357 - s16 * f13_x_p370 - inverse_D6_p101_lanes[1] *
      f13_x_p164, c16 * f13_x_p341 - s16 * f13_x_p355 - inverse_D6_p101_lanes[1] * f13_x_p40) -
      detail::make_pack<Real>(inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[0],
      inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[0],
      inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[1], inverse_D6_p267_lanes[1]) *
      detail::make_pack<Real>(f13_x_p669_lanes[0], f13_x_p669_lanes[1], f13_x_p669_lanes[2],
      f13_x_p669_lanes[3], f13_x_p669_lanes[4], f13_x_p669_lanes[5], f13_x_p356, f13_x_p71);
  const Lanes<8> f13_x_p741_lanes = detail::make_pack<Real>(f13_x_p675_lanes[0],
      f13_x_p675_lanes[1], f13_x_p675_lanes[2], f13_x_p675_lanes[3], f13_x_p675_lanes[4],
      f13_x_p675_lanes[5], c15 * f13_x_p547 - s15 * f13_x_p504, c15 * f13_x_p523 - s15 *
      f13_x_p457) - detail::make_pack<Real>(inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[0],
      inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[0],
      inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[1], inverse_D6_p265_lanes[1]) *
      detail::make_pack<Real>(f13_x_p669_lanes[0], f13_x_p669_lanes[1], f13_x_p669_lanes[2],
      f13_x_p669_lanes[3], f13_x_p669_lanes[4], f13_x_p669_lanes[5], f13_x_p356, f13_x_p71);
  const Lanes<8> f13_x_p749_lanes = detail::make_pack<Real>(f13_x_p681_lanes[0],
      f13_x_p681_lanes[1], f13_x_p681_lanes[2], f13_x_p681_lanes[3], f13_x_p681_lanes[4],
      f13_x_p681_lanes[5], s15 * f13_x_p547 + c15 * f13_x_p504, s15 * f13_x_p523 + c15 *
      f13_x_p457) - detail::make_pack<Real>(inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0],
      inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0],
      inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[1], inverse_D6_p271_lanes[1]) *
      detail::make_pack<Real>(f13_x_p669_lanes[0], f13_x_p669_lanes[1], f13_x_p669_lanes[2],
      f13_x_p669_lanes[3], f13_x_p669_lanes[4], f13_x_p669_lanes[5], f13_x_p356, f13_x_p71);
  const Lanes<8> f13_x_p757_lanes = detail::make_pack<Real>(f13_x_p687_lanes[0],
      f13_x_p687_lanes[1], f13_x_p687_lanes[2], f13_x_p687_lanes[3], f13_x_p687_lanes[4],
      f13_x_p687_lanes[5], c15 * f13_x_p193 - s15 * f13_x_p282, c15 * f13_x_p45 - s15 * f13_x_p48) -
      detail::make_pack<Real>(inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0],
      inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0],
      inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[1], inverse_D6_p370_lanes[1]) *
      detail::make_pack<Real>(f13_x_p669_lanes[0], f13_x_p669_lanes[1], f13_x_p669_lanes[2],
      f13_x_p669_lanes[3], f13_x_p669_lanes[4], f13_x_p669_lanes[5], f13_x_p356, f13_x_p71);
  const Lanes<8> f13_x_p837_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p733_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p741_lanes;
  const Lanes<8> f13_x_p853_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p733_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p741_lanes;
  const Lanes<8> f13_x_p893_lanes = 0.226 * f13_x_p749_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      f13_x_p837_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p917_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p725_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p757_lanes + f13_x_p893_lanes);
  const Lanes<8> f13_x_p925_lanes = inverse_D5_p54 * f13_x_p917_lanes;
  const Lanes<8> f13_x_p965_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18,
      (-0.18), (-0.18)) * f13_x_p853_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * f13_x_p725_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p757_lanes) - f13_x_p925_lanes;
  const Lanes<8> f13_x_p973_lanes = 0.226 * f13_x_p853_lanes - inverse_D5_p57 * f13_x_p917_lanes;
  const Lanes<8> f13_x_p981_lanes = f13_x_p853_lanes - inverse_D5_p52 * f13_x_p917_lanes;
  const Lanes<8> f13_x_p989_lanes = f13_x_p837_lanes + inverse_D3_p34 * f13_x_p917_lanes;
  const Lanes<8> f13_x_p997_lanes = f13_x_p749_lanes - inverse_D3_p35 * f13_x_p917_lanes;
  const Lanes<8> f13_x_p1093_lanes = s6 * f13_x_p989_lanes + c6 * f13_x_p997_lanes;
  const Lanes<8> f13_x_p1109_lanes = s6 * f13_x_p965_lanes + c6 * f13_x_p973_lanes + 0.072 *
      f13_x_p981_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1173_lanes = c6 * f13_x_p989_lanes - s6 * f13_x_p997_lanes -
      inverse_D3_p63 * f13_x_p1109_lanes;
  const Lanes<8> f13_x_p1181_lanes = f13_x_p981_lanes - inverse_D3_p62 * f13_x_p1109_lanes;
  const Lanes<8> f13_x_p1189_lanes = c6 * f13_x_p965_lanes - s6 * f13_x_p973_lanes - inverse_D4_p2 *
      f13_x_p1109_lanes;
  const Lanes<8> f13_x_p1197_lanes = -(0.072 * f13_x_p1093_lanes) + inverse_D4_p1 *
      f13_x_p1109_lanes;
  const Lanes<8> f13_x_p1245_lanes = s4 * (f13_x_p1093_lanes - inverse_D3_p64 * f13_x_p1109_lanes);

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1333_lanes = -(s5 * f13_x_p1197_lanes + c5 * f13_x_p1189_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1365_lanes = f13_x_p1109_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1381_lanes = f13_x_p917_lanes * inverse_D6;
  const Real f13_x_p1387 = f13_x_p917_lanes[7] * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1388_lanes = f13_x_p669_lanes * inverse_D7_lanes[0];

  // link 6 (chest3), force propagation
  const Real f13_x_p1394 = f13_x_p917_lanes[6] * inverse_D6;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1395_lanes = f13_x_p535_lanes * inverse_D8_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1401_lanes = f13_x_p1333_lanes * inverse_D4;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1409_lanes = f13_x_p358_lanes * inverse_D9_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1415_lanes = c4 * (s5 * f13_x_p1173_lanes - c5 * f13_x_p1181_lanes) +
      f13_x_p1245_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1423_lanes = detail::make_pack<Real>(f13_x_p28_lanes[0], f13_x_p1_lanes[0],
      f13_x_p126_lanes[0], f13_x_p177_lanes[0], f13_x_p194_lanes[0], f13_x_p222_lanes[0],
      f13_x_p28_lanes[0], f13_x_p28_lanes[0]) * inverse_D10_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1429_lanes = -(s5 * f13_x_p1181_lanes + c5 * f13_x_p1173_lanes) -
      inverse_D2_p12 * f13_x_p1333_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1445_lanes = f13_x_p1388_lanes * f13_x_p669_lanes[0];

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D2_p23 - inverse_D1_p2 * inverse_D1_p3));

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1515_lanes = s4 * (s5 * f13_x_p1189_lanes - c5 * f13_x_p1197_lanes) +
      0.21799999999999997 * f13_x_p1415_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1537_lanes = -f13_x_p1515_lanes - inverse_D3_p93 * f13_x_p1333_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1570_lanes = f13_x_p1388_lanes * f13_x_p669_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1596_lanes = f13_x_p1537_lanes * inverse_D3;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1609_lanes = f13_x_p1423_lanes * f13_x_p28_lanes[0] + f13_x_p1409_lanes *
      f13_x_p358_lanes[0] + f13_x_p1395_lanes * f13_x_p535_lanes[0] + f13_x_p1445_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1620_lanes = -f13_x_p1415_lanes - inverse_D2_p11 * f13_x_p1333_lanes -
      inverse_D2_p16 * f13_x_p1537_lanes;
  const Lanes<8> f13_x_p1628_lanes = -f13_x_p1429_lanes + inverse_D2_p15 * f13_x_p1537_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1636_lanes = f13_x_p1609_lanes + f13_x_p1381_lanes * f13_x_p917_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1715_lanes = inverse_D2_p9 * f13_x_p1620_lanes - inverse_D2_p7 *
      f13_x_p1628_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1731_lanes = f13_x_p1423_lanes * f13_x_p1_lanes[0] + f13_x_p1409_lanes *
      f13_x_p358_lanes[1] + f13_x_p1395_lanes * f13_x_p535_lanes[1] + f13_x_p1570_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1752_lanes = detail::make_pack<Real>(f13_x_p1636_lanes[0],
      f13_x_p1636_lanes[1], f13_x_p1636_lanes[2], f13_x_p1636_lanes[3], f13_x_p1636_lanes[4],
      f13_x_p1636_lanes[5], f13_x_p1394 * f13_x_p917_lanes[0], f13_x_p1387 * f13_x_p917_lanes[0]) +
      f13_x_p1365_lanes * f13_x_p1109_lanes[0] + f13_x_p1401_lanes * f13_x_p1333_lanes[0] +
      f13_x_p1596_lanes * f13_x_p1537_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1760_lanes = f13_x_p1731_lanes + f13_x_p1381_lanes * f13_x_p917_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1775_lanes = f13_x_p1388_lanes * f13_x_p669_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1810_lanes = inverse_D2_p10 *
      (inverse_D2_p7 * f13_x_p1620_lanes + inverse_D2_p9 * f13_x_p1628_lanes) + inverse_D2_p8 *
      f13_x_p1715_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p1837_lanes = f13_x_p1810_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1845_lanes = detail::make_pack<Real>(f13_x_p1760_lanes[1],
      f13_x_p1760_lanes[1], f13_x_p1760_lanes[2], f13_x_p1760_lanes[3], f13_x_p1760_lanes[4],
      f13_x_p1760_lanes[5], f13_x_p1394 * f13_x_p917_lanes[1], f13_x_p1387 * f13_x_p917_lanes[1]) +
      f13_x_p1365_lanes * f13_x_p1109_lanes[1] + f13_x_p1401_lanes * f13_x_p1333_lanes[1] +
      f13_x_p1596_lanes * f13_x_p1537_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1885_lanes = f13_x_p1423_lanes * f13_x_p126_lanes[0] + f13_x_p1409_lanes *
      f13_x_p358_lanes[2] + f13_x_p1395_lanes * f13_x_p535_lanes[2] + f13_x_p1775_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p1889_lanes = 0.434 * (f13_x_p1715_lanes - inverse_D1_p3 *
      f13_x_p1810_lanes);

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1912_lanes = f13_x_p1885_lanes + f13_x_p1381_lanes * f13_x_p917_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p1916_lanes = f13_x_p1889_lanes * inverse_D1;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1956_lanes = f13_x_p1395_lanes * f13_x_p535_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1968_lanes = detail::make_pack<Real>(neg_c12_lanes[0], neg_c12_lanes[0],
      neg_c12_lanes[0], neg_c12_lanes[0], f13_x_p69_lanes[0], f13_x_p87_lanes[0], neg_c12_lanes[0],
      neg_c12_lanes[0]) * inverse_D11_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2000_lanes = detail::make_pack<Real>(f13_x_p1912_lanes[2],
      f13_x_p1912_lanes[2], f13_x_p1912_lanes[2], f13_x_p1912_lanes[3], f13_x_p1912_lanes[4],
      f13_x_p1912_lanes[5], f13_x_p1394 * f13_x_p917_lanes[2], f13_x_p1387 * f13_x_p917_lanes[2]) +
      f13_x_p1365_lanes * f13_x_p1109_lanes[2] + f13_x_p1401_lanes * f13_x_p1333_lanes[2] +
      f13_x_p1596_lanes * f13_x_p1537_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2009_lanes = f13_x_p1752_lanes + f13_x_p1837_lanes * f13_x_p1810_lanes[0] +
      f13_x_p1916_lanes * f13_x_p1889_lanes[0];
  const Real f13_x_p2030 = f13_x_p2009_lanes[0] * f13_x_p2009_lanes[0];
  const Real f13_x_p2043 = f13_x_p2030 * f13_x_p2009_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2044_lanes = f13_x_p1968_lanes * neg_c12_lanes[0] + f13_x_p1423_lanes *
      f13_x_p177_lanes[0] + f13_x_p1409_lanes * f13_x_p358_lanes[3] + f13_x_p1956_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2050_lanes = f13_x_p2044_lanes + f13_x_p1388_lanes * f13_x_p669_lanes[3] +
      f13_x_p1381_lanes * f13_x_p917_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p2053 = f13_x_p2043 * f13_x_p2030 /
      (1.9721522630525295e-31 + f13_x_p2043 * f13_x_p2043);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2064_lanes = detail::make_pack<Real>(f13_x_p2050_lanes[3],
      f13_x_p2050_lanes[3], f13_x_p2050_lanes[3], f13_x_p2050_lanes[3], f13_x_p2050_lanes[4],
      f13_x_p2050_lanes[5], f13_x_p1394 * f13_x_p917_lanes[3], f13_x_p1387 * f13_x_p917_lanes[3]) +
      f13_x_p1365_lanes * f13_x_p1109_lanes[3] + f13_x_p1401_lanes * f13_x_p1333_lanes[3] +
      f13_x_p1596_lanes * f13_x_p1537_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p2098_lanes = detail::make_pack<Real>(f13_x_p158_lanes[1],
      f13_x_p185_lanes[1], f13_x_p212_lanes[1], f13_x_p224_lanes[1], f13_x_p158_lanes[1],
      f13_x_p158_lanes[1], f13_x_p158_lanes[1], f13_x_p158_lanes[1]) - inverse_D9_p9_lanes[1] *
      detail::make_pack<Real>(f13_x_p126_lanes[1], f13_x_p177_lanes[1], f13_x_p194_lanes[1],
      f13_x_p222_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1],
      f13_x_p126_lanes[1]);
  const Lanes<8> f13_x_p2102_lanes = inverse_D9_p7_lanes[1] *
      detail::make_pack<Real>(f13_x_p126_lanes[1], f13_x_p177_lanes[1], f13_x_p194_lanes[1],
      f13_x_p222_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1],
      f13_x_p126_lanes[1]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2111_lanes = f13_x_p2009_lanes * f13_x_p2053;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p2160_lanes = detail::make_pack<Real>(f13_x_p187_lanes[1],
      f13_x_p285_lanes[1], f13_x_p280_lanes[1], f13_x_p278_lanes[1], f13_x_p187_lanes[1],
      f13_x_p187_lanes[1], f13_x_p187_lanes[1], f13_x_p187_lanes[1]) - inverse_D8_p34_lanes[1] *
      detail::make_pack<Real>(f13_x_p126_lanes[1], f13_x_p177_lanes[1], f13_x_p194_lanes[1],
      f13_x_p222_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1],
      f13_x_p126_lanes[1]);
  const Lanes<8> f13_x_p2164_lanes = c17 * f13_x_p2102_lanes - s17 * f13_x_p2098_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2176_lanes = f13_x_p1845_lanes + f13_x_p1837_lanes * f13_x_p1810_lanes[1] +
      f13_x_p1916_lanes * f13_x_p1889_lanes[1] - f13_x_p2111_lanes * f13_x_p2009_lanes[1];
  const Lanes<8> f13_x_p2187_lanes = f13_x_p2000_lanes + f13_x_p1837_lanes * f13_x_p1810_lanes[2] +
      f13_x_p1916_lanes * f13_x_p1889_lanes[2] - f13_x_p2111_lanes * f13_x_p2009_lanes[2];
  const Lanes<8> f13_x_p2193_lanes = f13_x_p2064_lanes + f13_x_p1837_lanes * f13_x_p1810_lanes[3] +
      f13_x_p1916_lanes * f13_x_p1889_lanes[3] - f13_x_p2111_lanes * f13_x_p2009_lanes[3];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2202_lanes = inverse_D8_p125_lanes[1] * f13_x_p2164_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2210 = f13_x_p2176_lanes[1] * f13_x_p2176_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p2211_lanes = detail::make_pack<Real>(f13_x_p210_lanes[1],
      f13_x_p264_lanes[1], f13_x_p262_lanes[1], f13_x_p240_lanes[1], f13_x_p210_lanes[1],
      f13_x_p210_lanes[1], f13_x_p210_lanes[1], f13_x_p210_lanes[1]) - inverse_D8_p46_lanes[1] *
      detail::make_pack<Real>(f13_x_p126_lanes[1], f13_x_p177_lanes[1], f13_x_p194_lanes[1],
      f13_x_p222_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1],
      f13_x_p126_lanes[1]);
  const Lanes<8> f13_x_p2215_lanes = detail::make_pack<Real>(neg_neg_s12_lanes[1],
      f13_x_p258_lanes[1], f13_x_p342_lanes[1], f13_x_p322_lanes[1], neg_neg_s12_lanes[1],
      neg_neg_s12_lanes[1], neg_neg_s12_lanes[1], neg_neg_s12_lanes[1]) - inverse_D8_p105_lanes[1] *
      detail::make_pack<Real>(f13_x_p126_lanes[1], f13_x_p177_lanes[1], f13_x_p194_lanes[1],
      f13_x_p222_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1],
      f13_x_p126_lanes[1]);

  // link 1 (calf), force propagation
  const Real f13_x_p2227 = f13_x_p2210 * f13_x_p2176_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2232_lanes = c17 * f13_x_p2098_lanes + s17 * f13_x_p2102_lanes + 0.282 *
      f13_x_p2160_lanes - f13_x_p2202_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p2236_lanes = s17 * f13_x_p2215_lanes - c17 * f13_x_p2211_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2252_lanes = f13_x_p2164_lanes * inverse_D9_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p2256 = f13_x_p2227 * f13_x_p2210 /
      (1.262177448353619e-29 + f13_x_p2227 * f13_x_p2227);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2257_lanes = 0.282 * f13_x_p2236_lanes - inverse_D8_p151_lanes[1] *
      f13_x_p2164_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p2261_lanes = detail::make_pack<Real>(f13_x_p126_lanes[1],
      f13_x_p177_lanes[1], f13_x_p194_lanes[1], f13_x_p222_lanes[1], f13_x_p126_lanes[1],
      f13_x_p126_lanes[1], f13_x_p126_lanes[1], f13_x_p126_lanes[1]) * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p2265_lanes = detail::make_pack<Real>(neg_c12_lanes[1], neg_c12_lanes[1],
      f13_x_p69_lanes[1], f13_x_p87_lanes[1], neg_c12_lanes[1], neg_c12_lanes[1], neg_c12_lanes[1],
      neg_c12_lanes[1]) * inverse_D11_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p2270_lanes = inverse_D12_p7_lanes * inverse_D12_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2284_lanes = c16 * f13_x_p2232_lanes - s16 * f13_x_p2257_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p2298_lanes = f13_x_p22_lanes[1] * f13_x_p2284_lanes;
  const Lanes<8> f13_x_p2306_lanes = f13_x_p2284_lanes * inverse_D8_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2314_lanes = f13_x_p2176_lanes * f13_x_p2256;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p2320_lanes = s16 * f13_x_p2232_lanes + c16 * f13_x_p2257_lanes -
      inverse_D7_p8_lanes[1] * f13_x_p2284_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<2> f13_x_p2330_lanes = f13_x_p2270_lanes +
      detail::make_pack<Real>(f13_x_p1968_lanes[5], f13_x_p2265_lanes[3]) * f13_x_p69_lanes +
      detail::make_pack<Real>(f13_x_p1423_lanes[5], f13_x_p2261_lanes[3]) * f13_x_p194_lanes +
      detail::make_pack<Real>(f13_x_p1409_lanes[5], f13_x_p2252_lanes[3]) *
      detail::make_pack<Real>(f13_x_p358_lanes[4], f13_x_p2164_lanes[2]);
  const Lanes<2> f13_x_p2359_lanes = inverse_D12_lanes +
      detail::make_pack<Real>(f13_x_p1968_lanes[4], f13_x_p2265_lanes[2]) * f13_x_p69_lanes +
      detail::make_pack<Real>(f13_x_p1423_lanes[4], f13_x_p2261_lanes[2]) * f13_x_p194_lanes +
      detail::make_pack<Real>(f13_x_p1409_lanes[4], f13_x_p2252_lanes[2]) *
      detail::make_pack<Real>(f13_x_p358_lanes[4], f13_x_p2164_lanes[2]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2361_lanes = f13_x_p2187_lanes - f13_x_p2314_lanes * f13_x_p2176_lanes[2];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p2367_lanes = s15 * f13_x_p2298_lanes + c15 * f13_x_p2320_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2378 = f13_x_p2361_lanes[2] * f13_x_p2361_lanes[2];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2379_lanes = f13_x_p2367_lanes * inverse_D7_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p2383 = f13_x_p2378 * f13_x_p2361_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p2414_lanes = f13_x_p2330_lanes +
      detail::make_pack<Real>(f13_x_p1395_lanes[5], f13_x_p2306_lanes[3]) *
      detail::make_pack<Real>(f13_x_p535_lanes[4], f13_x_p2284_lanes[2]) +
      detail::make_pack<Real>(f13_x_p1388_lanes[5], f13_x_p2379_lanes[3]) *
      detail::make_pack<Real>(f13_x_p669_lanes[4], f13_x_p2367_lanes[2]);
  const Lanes<2> f13_x_p2416_lanes = f13_x_p2359_lanes +
      detail::make_pack<Real>(f13_x_p1395_lanes[4], f13_x_p2306_lanes[2]) *
      detail::make_pack<Real>(f13_x_p535_lanes[4], f13_x_p2284_lanes[2]) +
      detail::make_pack<Real>(f13_x_p1388_lanes[4], f13_x_p2379_lanes[2]) *
      detail::make_pack<Real>(f13_x_p669_lanes[4], f13_x_p2367_lanes[2]);

  // link 1 (calf), force propagation
  const Real f13_x_p2431 = f13_x_p2383 * f13_x_p2378 /
      (3.0814879110195774e-33 + f13_x_p2383 * f13_x_p2383);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p2438_lanes = 1065.380700001509 + f13_x_p2270_lanes * inverse_D12_p7_lanes +
      detail::make_pack<Real>(f13_x_p1968_lanes[5], f13_x_p2265_lanes[3]) * f13_x_p87_lanes +
      detail::make_pack<Real>(f13_x_p1423_lanes[5], f13_x_p2261_lanes[3]) * f13_x_p222_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2440_lanes = detail::make_pack<Real>(f13_x_p2416_lanes[0] +
      f13_x_p1381_lanes[4] * f13_x_p917_lanes[4], f13_x_p2416_lanes[0] + f13_x_p1381_lanes[4] *
      f13_x_p917_lanes[4], f13_x_p2416_lanes[0] + f13_x_p1381_lanes[4] * f13_x_p917_lanes[4],
      f13_x_p2416_lanes[0] + f13_x_p1381_lanes[4] * f13_x_p917_lanes[4], f13_x_p2416_lanes[0] +
      f13_x_p1381_lanes[4] * f13_x_p917_lanes[4], f13_x_p2414_lanes[0] + f13_x_p1381_lanes[5] *
      f13_x_p917_lanes[4], f13_x_p1394 * f13_x_p917_lanes[4], f13_x_p1387 * f13_x_p917_lanes[4]) +
      f13_x_p1365_lanes * f13_x_p1109_lanes[4] + f13_x_p1401_lanes * f13_x_p1333_lanes[4] +
      f13_x_p1596_lanes * f13_x_p1537_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2456_lanes = f13_x_p2361_lanes * f13_x_p2431;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p2461_lanes = f13_x_p2438_lanes +
      detail::make_pack<Real>(f13_x_p1409_lanes[5], f13_x_p2252_lanes[3]) *
      detail::make_pack<Real>(f13_x_p358_lanes[5], f13_x_p2164_lanes[3]) +
      detail::make_pack<Real>(f13_x_p1395_lanes[5], f13_x_p2306_lanes[3]) *
      detail::make_pack<Real>(f13_x_p535_lanes[5], f13_x_p2284_lanes[3]) +
      detail::make_pack<Real>(f13_x_p1388_lanes[5], f13_x_p2379_lanes[3]) *
      detail::make_pack<Real>(f13_x_p669_lanes[5], f13_x_p2367_lanes[3]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2463_lanes = f13_x_p2440_lanes + f13_x_p1837_lanes * f13_x_p1810_lanes[4] +
      f13_x_p1916_lanes * f13_x_p1889_lanes[4] - f13_x_p2111_lanes * f13_x_p2009_lanes[4];
  const Lanes<8> f13_x_p2486_lanes = f13_x_p2193_lanes - f13_x_p2314_lanes * f13_x_p2176_lanes[3] -
      f13_x_p2456_lanes * f13_x_p2361_lanes[3];
  const Real f13_x_p2498 = f13_x_p2486_lanes[3] * f13_x_p2486_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2499_lanes = detail::make_pack<Real>(f13_x_p2461_lanes[0] +
      f13_x_p1381_lanes[5] * f13_x_p917_lanes[5], f13_x_p2461_lanes[0] + f13_x_p1381_lanes[5] *
      f13_x_p917_lanes[5], f13_x_p2461_lanes[0] + f13_x_p1381_lanes[5] * f13_x_p917_lanes[5],
      f13_x_p2461_lanes[0] + f13_x_p1381_lanes[5] * f13_x_p917_lanes[5], f13_x_p2461_lanes[0] +
      f13_x_p1381_lanes[5] * f13_x_p917_lanes[5], f13_x_p2461_lanes[0] + f13_x_p1381_lanes[5] *
      f13_x_p917_lanes[5], f13_x_p1394 * f13_x_p917_lanes[5], f13_x_p1387 * f13_x_p917_lanes[5]) +
      f13_x_p1365_lanes * f13_x_p1109_lanes[5] + f13_x_p1401_lanes * f13_x_p1333_lanes[5] +
      f13_x_p1596_lanes * f13_x_p1537_lanes[5];

  // link 1 (calf), force propagation
  const Real f13_x_p2502 = f13_x_p2498 * f13_x_p2486_lanes[3];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p2509 = f13_x_p28_lanes[1] * inverse_D10_lanes[1] * f13_x_p28_lanes[1] +
      f13_x_p51 * inverse_D9_lanes[1] * f13_x_p51 + f13_x_p164 * inverse_D8_lanes[1] * f13_x_p164;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2510_lanes = f13_x_p2499_lanes + f13_x_p1837_lanes * f13_x_p1810_lanes[5] +
      f13_x_p1916_lanes * f13_x_p1889_lanes[5] - f13_x_p2111_lanes * f13_x_p2009_lanes[5];
  const Real f13_x_p2516 = f13_x_p2502 * f13_x_p2498 /
      (2.2737367544323206e-13 + f13_x_p2502 * f13_x_p2502);

  // link 4 (chest1), force propagation
  const Real f13_x_p2520 = f13_x_p2509 + f13_x_p356 * inverse_D7_lanes[1] * f13_x_p356 +
      f13_x_p1394 * f13_x_p917_lanes[6] + f13_x_p1365_lanes[6] * f13_x_p1109_lanes[6] +
      f13_x_p1401_lanes[6] * f13_x_p1333_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2521_lanes = f13_x_p2486_lanes * f13_x_p2516;

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p2525 = f13_x_p71 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p2526 = f13_x_p40 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p2534 = f13_x_p14 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p2535 = f13_x_p1_lanes[1] * inverse_D10_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p2536 = f13_x_p2520 + f13_x_p1596_lanes[6] * f13_x_p1537_lanes[6] +
      f13_x_p1837_lanes[6] * f13_x_p1810_lanes[6] + f13_x_p1916_lanes[6] * f13_x_p1889_lanes[6] -
      f13_x_p2111_lanes[6] * f13_x_p2009_lanes[6];
  const Lanes<8> f13_x_p2537_lanes = f13_x_p2463_lanes - f13_x_p2314_lanes * f13_x_p2176_lanes[4] -
      f13_x_p2456_lanes * f13_x_p2361_lanes[4] - f13_x_p2521_lanes * f13_x_p2486_lanes[4];
  const Lanes<8> f13_x_p2541_lanes = f13_x_p2510_lanes - f13_x_p2314_lanes * f13_x_p2176_lanes[5] -
      f13_x_p2456_lanes * f13_x_p2361_lanes[5] - f13_x_p2521_lanes * f13_x_p2486_lanes[5];
  const Real f13_x_p2544 = f13_x_p2537_lanes[4] * f13_x_p2537_lanes[4];
  const Real f13_x_p2545 = f13_x_p2544 * f13_x_p2537_lanes[4];

  // link 6 (chest3), force propagation
  const Real f13_x_p2546 = f13_x_p2535 * f13_x_p28_lanes[1] + f13_x_p2534 * f13_x_p51 +
      f13_x_p2526 * f13_x_p164 + f13_x_p2525 * f13_x_p356 + f13_x_p1387 * f13_x_p917_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p2547 = f13_x_p2545 * f13_x_p2544 /
      (2.2737367544323206e-13 + f13_x_p2545 * f13_x_p2545);

  // link 2 (thigh), force propagation
  const Real f13_x_p2548 = f13_x_p2546 + f13_x_p1365_lanes[7] * f13_x_p1109_lanes[6] +
      f13_x_p1401_lanes[7] * f13_x_p1333_lanes[6] + f13_x_p1596_lanes[7] * f13_x_p1537_lanes[6] +
      f13_x_p1837_lanes[7] * f13_x_p1810_lanes[6];

  // link 6 (chest3), force propagation
  const Real f13_x_p2549 = f13_x_p2535 * f13_x_p1_lanes[1] + f13_x_p2534 * f13_x_p14 + f13_x_p2526 *
      f13_x_p40 + f13_x_p2525 * f13_x_p71 + f13_x_p1387 * f13_x_p917_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2550_lanes = f13_x_p2537_lanes * f13_x_p2547;
  const Real f13_x_p2556 = f13_x_p2548 + f13_x_p1916_lanes[7] * f13_x_p1889_lanes[6] -
      f13_x_p2111_lanes[7] * f13_x_p2009_lanes[6] - f13_x_p2314_lanes[7] * f13_x_p2176_lanes[6] -
      f13_x_p2456_lanes[7] * f13_x_p2361_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2557_lanes = inverse_D6_p267_lanes[1] * f13_x_p2367_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2573_lanes = f13_x_p2541_lanes - f13_x_p2550_lanes * f13_x_p2537_lanes[5];
  const Real f13_x_p2576 = f13_x_p2536 - f13_x_p2314_lanes[6] * f13_x_p2176_lanes[6] -
      f13_x_p2456_lanes[6] * f13_x_p2361_lanes[6] - f13_x_p2521_lanes[6] * f13_x_p2486_lanes[6] -
      f13_x_p2550_lanes[6] * f13_x_p2537_lanes[6];

  // link 2 (thigh), force propagation
  const Real f13_x_p2581 = f13_x_p2549 + f13_x_p1365_lanes[7] * f13_x_p1109_lanes[7] +
      f13_x_p1401_lanes[7] * f13_x_p1333_lanes[7] + f13_x_p1596_lanes[7] * f13_x_p1537_lanes[7] +
      f13_x_p1837_lanes[7] * f13_x_p1810_lanes[7];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2582_lanes = -f13_x_p2236_lanes + inverse_D6_p27_lanes[1] *
      f13_x_p2164_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2586 = f13_x_p2573_lanes[5] * f13_x_p2573_lanes[5];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2587_lanes = f13_x_p2160_lanes - inverse_D6_p29_lanes[1] *
      f13_x_p2164_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2631 = f13_x_p2586 * f13_x_p2573_lanes[5];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p2644_lanes = s16 * f13_x_p2582_lanes + c16 * f13_x_p2587_lanes -
      inverse_D6_p99_lanes[1] * f13_x_p2284_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2652 = f13_x_p2581 + f13_x_p1916_lanes[7] * f13_x_p1889_lanes[7] -
      f13_x_p2111_lanes[7] * f13_x_p2009_lanes[7] - f13_x_p2314_lanes[7] * f13_x_p2176_lanes[7] -
      f13_x_p2456_lanes[7] * f13_x_p2361_lanes[7];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p2661_lanes = -(s17 * f13_x_p2211_lanes + c17 * f13_x_p2215_lanes) +
      inverse_D6_p19_lanes[1] * f13_x_p2164_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2669_lanes = c16 * f13_x_p2582_lanes - s16 * f13_x_p2587_lanes -
      inverse_D6_p101_lanes[1] * f13_x_p2284_lanes - f13_x_p2557_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p2685_lanes = -f13_x_p2661_lanes + inverse_D6_p97_lanes[1] *
      f13_x_p2284_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2697_lanes = f13_x_p595_lanes[1] * f13_x_p2367_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2701 = f13_x_p2631 * f13_x_p2586 /
      (2.2737367544323206e-13 + f13_x_p2631 * f13_x_p2631);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2734_lanes = c15 * f13_x_p2298_lanes - s15 * f13_x_p2320_lanes -
      inverse_D6_p370_lanes[1] * f13_x_p2367_lanes;
  const Lanes<8> f13_x_p2742_lanes = c15 * f13_x_p2685_lanes - s15 * f13_x_p2644_lanes -
      inverse_D6_p265_lanes[1] * f13_x_p2367_lanes;
  const Lanes<8> f13_x_p2746_lanes = s15 * f13_x_p2685_lanes + c15 * f13_x_p2644_lanes -
      inverse_D6_p271_lanes[1] * f13_x_p2367_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2778 = f13_x_p2573_lanes[6] * f13_x_p2701;
  const Real f13_x_p2779 = f13_x_p2573_lanes[7] * f13_x_p2701;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2780_lanes = s14 * f13_x_p2669_lanes + c14 * f13_x_p2742_lanes;
  const Lanes<8> f13_x_p2784_lanes = c14 * f13_x_p2669_lanes - s14 * f13_x_p2742_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2800 = f13_x_p2576 - f13_x_p2778 * f13_x_p2573_lanes[6];
  const Real f13_x_p2801 = f13_x_p2556 - f13_x_p2521_lanes[7] * f13_x_p2486_lanes[6] -
      f13_x_p2550_lanes[7] * f13_x_p2537_lanes[6] - f13_x_p2779 * f13_x_p2573_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2802_lanes = 0.226 * f13_x_p2746_lanes + (-0.18) * f13_x_p2780_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2810 = f13_x_p2800 * f13_x_p2800;
  const Real f13_x_p2815 = f13_x_p2810 * f13_x_p2800;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2816_lanes = -(c14 * f13_x_p2697_lanes + s14 * f13_x_p2734_lanes +
      f13_x_p2802_lanes);
  const Lanes<8> f13_x_p2820_lanes = inverse_D5_p54 * f13_x_p2816_lanes;
  const Lanes<8> f13_x_p2840_lanes = (-0.18) * f13_x_p2784_lanes -
      (s14 * f13_x_p2697_lanes - c14 * f13_x_p2734_lanes) - f13_x_p2820_lanes;
  const Lanes<8> f13_x_p2844_lanes = 0.226 * f13_x_p2784_lanes - inverse_D5_p57 * f13_x_p2816_lanes;
  const Lanes<8> f13_x_p2848_lanes = f13_x_p2784_lanes - inverse_D5_p52 * f13_x_p2816_lanes;
  const Lanes<8> f13_x_p2852_lanes = f13_x_p2780_lanes + inverse_D3_p34 * f13_x_p2816_lanes;
  const Lanes<8> f13_x_p2856_lanes = f13_x_p2746_lanes - inverse_D3_p35 * f13_x_p2816_lanes;
  const Lanes<8> f13_x_p2904_lanes = s6 * f13_x_p2852_lanes + c6 * f13_x_p2856_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p2908 = f13_x_p2815 * f13_x_p2810 /
      (3.0814879110195774e-33 + f13_x_p2815 * f13_x_p2815);

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2913_lanes = s6 * f13_x_p2840_lanes + c6 * f13_x_p2844_lanes + 0.072 *
      f13_x_p2848_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2945_lanes = c6 * f13_x_p2852_lanes - s6 * f13_x_p2856_lanes -
      inverse_D3_p63 * f13_x_p2913_lanes;
  const Lanes<8> f13_x_p2949_lanes = f13_x_p2848_lanes - inverse_D3_p62 * f13_x_p2913_lanes;
  const Lanes<8> f13_x_p2953_lanes = c6 * f13_x_p2840_lanes - s6 * f13_x_p2844_lanes -
      inverse_D4_p2 * f13_x_p2913_lanes;
  const Lanes<8> f13_x_p2957_lanes = -(0.072 * f13_x_p2904_lanes) + inverse_D4_p1 *
      f13_x_p2913_lanes;
  const Lanes<8> f13_x_p2981_lanes = s4 * (f13_x_p2904_lanes - inverse_D3_p64 * f13_x_p2913_lanes);

  // link 1 (calf), force propagation
  const Real f13_x_p3001 = f13_x_p2801 * f13_x_p2908;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3026_lanes = -(s5 * f13_x_p2957_lanes + c5 * f13_x_p2953_lanes);
  const Lanes<8> f13_x_p3042_lanes = f13_x_p3026_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3050_lanes = f13_x_p2913_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3054_lanes = f13_x_p2816_lanes * inverse_D6;

  // link 1 (calf), force propagation
  const Real f13_x_p3058 = f13_x_p2652 - f13_x_p2521_lanes[7] * f13_x_p2486_lanes[7] -
      f13_x_p2550_lanes[7] * f13_x_p2537_lanes[7] - f13_x_p2779 * f13_x_p2573_lanes[7] -
      f13_x_p3001 * f13_x_p2801;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3059_lanes = c4 * (s5 * f13_x_p2945_lanes - c5 * f13_x_p2949_lanes) +
      f13_x_p2981_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3063_lanes = -(s5 * f13_x_p2949_lanes + c5 * f13_x_p2945_lanes) -
      inverse_D2_p12 * f13_x_p3026_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p3079 = f13_x_p3058 * f13_x_p3058;
  const Real f13_x_p3112 = f13_x_p3079 * f13_x_p3058;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3113_lanes = s4 * (s5 * f13_x_p2953_lanes - c5 * f13_x_p2957_lanes) +
      0.21799999999999997 * f13_x_p3059_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3129_lanes = -f13_x_p3113_lanes - inverse_D3_p93 * f13_x_p3026_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3145_lanes = f13_x_p3129_lanes * inverse_D3;
  const Lanes<8> f13_x_p3161_lanes = -f13_x_p3059_lanes - inverse_D2_p11 * f13_x_p3026_lanes -
      inverse_D2_p16 * f13_x_p3129_lanes;
  const Lanes<8> f13_x_p3165_lanes = -f13_x_p3063_lanes + inverse_D2_p15 * f13_x_p3129_lanes;
  const Lanes<8> f13_x_p3169_lanes = f13_x_p3145_lanes * f13_x_p1537_lanes[0];
  const Lanes<8> f13_x_p3173_lanes = f13_x_p3145_lanes * f13_x_p1537_lanes[1];
  const Lanes<8> f13_x_p3181_lanes = f13_x_p3145_lanes * f13_x_p1537_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p3185 = f13_x_p3112 * f13_x_p3079 /
      (1.262177448353619e-29 + f13_x_p3112 * f13_x_p3112);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3202_lanes = f13_x_p3054_lanes * f13_x_p917_lanes[0] + f13_x_p3050_lanes *
      f13_x_p1109_lanes[0] + f13_x_p3042_lanes * f13_x_p1333_lanes[0] + f13_x_p3169_lanes;
  const Lanes<8> f13_x_p3206_lanes = f13_x_p3054_lanes * f13_x_p917_lanes[1] + f13_x_p3050_lanes *
      f13_x_p1109_lanes[1] + f13_x_p3042_lanes * f13_x_p1333_lanes[1] + f13_x_p3173_lanes;
  const Lanes<8> f13_x_p3226_lanes = f13_x_p3145_lanes * f13_x_p1537_lanes[3];
  const Lanes<8> f13_x_p3234_lanes = inverse_D2_p9 * f13_x_p3161_lanes - inverse_D2_p7 *
      f13_x_p3165_lanes;
  const Lanes<8> f13_x_p3238_lanes = f13_x_p3054_lanes * f13_x_p917_lanes[2] + f13_x_p3050_lanes *
      f13_x_p1109_lanes[2] + f13_x_p3042_lanes * f13_x_p1333_lanes[2] + f13_x_p3181_lanes;
  const Lanes<8> f13_x_p3258_lanes = inverse_D2_p10 *
      (inverse_D2_p7 * f13_x_p3161_lanes + inverse_D2_p9 * f13_x_p3165_lanes) + inverse_D2_p8 *
      f13_x_p3234_lanes;
  const Lanes<8> f13_x_p3262_lanes = f13_x_p3054_lanes * f13_x_p917_lanes[3] + f13_x_p3050_lanes *
      f13_x_p1109_lanes[3] + f13_x_p3042_lanes * f13_x_p1333_lanes[3] + f13_x_p3226_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p3270_lanes = f13_x_p3258_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3306_lanes = f13_x_p3145_lanes * f13_x_p1537_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p3314_lanes = 0.434 * (f13_x_p3234_lanes - inverse_D1_p3 *
      f13_x_p3258_lanes);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3338_lanes = f13_x_p3314_lanes * inverse_D1;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3362_lanes = f13_x_p3054_lanes * f13_x_p917_lanes[4] + f13_x_p3050_lanes *
      f13_x_p1109_lanes[4] + f13_x_p3042_lanes * f13_x_p1333_lanes[4] + f13_x_p3306_lanes;
  const Lanes<8> f13_x_p3382_lanes = f13_x_p3145_lanes * f13_x_p1537_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3394_lanes = f13_x_p3202_lanes + f13_x_p3270_lanes * f13_x_p1810_lanes[0] +
      f13_x_p3338_lanes * f13_x_p1889_lanes[0];
  const Lanes<8> f13_x_p3418_lanes = f13_x_p3394_lanes * f13_x_p2053;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3446_lanes = f13_x_p3054_lanes * f13_x_p917_lanes[5] + f13_x_p3050_lanes *
      f13_x_p1109_lanes[5] + f13_x_p3042_lanes * f13_x_p1333_lanes[5] + f13_x_p3382_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3470_lanes = f13_x_p2379_lanes * f13_x_p356;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3494_lanes = f13_x_p3206_lanes + f13_x_p3270_lanes * f13_x_p1810_lanes[1] +
      f13_x_p3338_lanes * f13_x_p1889_lanes[1] - f13_x_p3418_lanes * f13_x_p2009_lanes[1];
  const Lanes<8> f13_x_p3498_lanes = f13_x_p3238_lanes + f13_x_p3270_lanes * f13_x_p1810_lanes[2] +
      f13_x_p3338_lanes * f13_x_p1889_lanes[2] - f13_x_p3418_lanes * f13_x_p2009_lanes[2];
  const Lanes<8> f13_x_p3502_lanes = f13_x_p3262_lanes + f13_x_p3270_lanes * f13_x_p1810_lanes[3] +
      f13_x_p3338_lanes * f13_x_p1889_lanes[3] - f13_x_p3418_lanes * f13_x_p2009_lanes[3];
  const Lanes<8> f13_x_p3506_lanes = f13_x_p3362_lanes + f13_x_p3270_lanes * f13_x_p1810_lanes[4] +
      f13_x_p3338_lanes * f13_x_p1889_lanes[4] - f13_x_p3418_lanes * f13_x_p2009_lanes[4];
  const Lanes<8> f13_x_p3518_lanes = f13_x_p3494_lanes * f13_x_p2256;
  const Lanes<8> f13_x_p3550_lanes = f13_x_p3446_lanes + f13_x_p3270_lanes * f13_x_p1810_lanes[5] +
      f13_x_p3338_lanes * f13_x_p1889_lanes[5] - f13_x_p3418_lanes * f13_x_p2009_lanes[5];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3558_lanes = f13_x_p2261_lanes * f13_x_p28_lanes[1] + f13_x_p2252_lanes *
      f13_x_p51 + f13_x_p2306_lanes * f13_x_p164 + f13_x_p3470_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3562_lanes = f13_x_p3498_lanes - f13_x_p3518_lanes * f13_x_p2176_lanes[2];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3602_lanes = f13_x_p2379_lanes * f13_x_p71;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3610_lanes = f13_x_p3562_lanes * f13_x_p2431;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3650_lanes = f13_x_p3558_lanes + f13_x_p3054_lanes * f13_x_p917_lanes[6] +
      f13_x_p3050_lanes * f13_x_p1109_lanes[6] + f13_x_p3042_lanes * f13_x_p1333_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3674_lanes = f13_x_p3502_lanes - f13_x_p3518_lanes * f13_x_p2176_lanes[3] -
      f13_x_p3610_lanes * f13_x_p2361_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3686_lanes = f13_x_p2261_lanes * f13_x_p1_lanes[1] + f13_x_p2252_lanes *
      f13_x_p14 + f13_x_p2306_lanes * f13_x_p40 + f13_x_p3602_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3694_lanes = f13_x_p3674_lanes * f13_x_p2516;
  const Lanes<8> f13_x_p3702_lanes = f13_x_p3650_lanes + f13_x_p3145_lanes * f13_x_p1537_lanes[6] +
      f13_x_p3270_lanes * f13_x_p1810_lanes[6] + f13_x_p3338_lanes * f13_x_p1889_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3742_lanes = f13_x_p2379_lanes * f13_x_p2367_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3786_lanes = f13_x_p3506_lanes - f13_x_p3518_lanes * f13_x_p2176_lanes[4] -
      f13_x_p3610_lanes * f13_x_p2361_lanes[4] - f13_x_p3694_lanes * f13_x_p2486_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3790_lanes = f13_x_p3686_lanes + f13_x_p3054_lanes * f13_x_p917_lanes[7] +
      f13_x_p3050_lanes * f13_x_p1109_lanes[7] + f13_x_p3042_lanes * f13_x_p1333_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3794_lanes = f13_x_p3550_lanes - f13_x_p3518_lanes * f13_x_p2176_lanes[5] -
      f13_x_p3610_lanes * f13_x_p2361_lanes[5] - f13_x_p3694_lanes * f13_x_p2486_lanes[5];
  const Lanes<8> f13_x_p3806_lanes = f13_x_p3786_lanes * f13_x_p2547;
  const Lanes<8> f13_x_p3818_lanes = f13_x_p3702_lanes - f13_x_p3418_lanes * f13_x_p2009_lanes[6] -
      f13_x_p3518_lanes * f13_x_p2176_lanes[6] - f13_x_p3610_lanes * f13_x_p2361_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3826_lanes = f13_x_p2261_lanes * f13_x_p126_lanes[1] + f13_x_p2252_lanes *
      f13_x_p2164_lanes[0] + f13_x_p2306_lanes * f13_x_p2284_lanes[0] + f13_x_p3742_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3850_lanes = f13_x_p3790_lanes + f13_x_p3145_lanes * f13_x_p1537_lanes[7] +
      f13_x_p3270_lanes * f13_x_p1810_lanes[7] + f13_x_p3338_lanes * f13_x_p1889_lanes[7];
  const Lanes<8> f13_x_p3858_lanes = f13_x_p3794_lanes - f13_x_p3806_lanes * f13_x_p2537_lanes[5];
  const Lanes<8> f13_x_p3892_lanes = f13_x_p3858_lanes * f13_x_p2701;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p3909_lanes = f13_x_p2306_lanes * f13_x_p2284_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3918_lanes = f13_x_p3826_lanes + f13_x_p3054_lanes * f13_x_p2816_lanes[0] +
      f13_x_p3050_lanes * f13_x_p2913_lanes[0] + f13_x_p3042_lanes * f13_x_p3026_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3938_lanes = f13_x_p3850_lanes - f13_x_p3418_lanes * f13_x_p2009_lanes[7] -
      f13_x_p3518_lanes * f13_x_p2176_lanes[7] - f13_x_p3610_lanes * f13_x_p2361_lanes[7];
  const Lanes<8> f13_x_p3968_lanes = f13_x_p3818_lanes - f13_x_p3694_lanes * f13_x_p2486_lanes[6] -
      f13_x_p3806_lanes * f13_x_p2537_lanes[6] - f13_x_p3892_lanes * f13_x_p2573_lanes[6];
  const Lanes<8> f13_x_p3979_lanes = f13_x_p3918_lanes + f13_x_p3145_lanes * f13_x_p3129_lanes[0] +
      f13_x_p3270_lanes * f13_x_p3258_lanes[0] + f13_x_p3338_lanes * f13_x_p3314_lanes[0];
  const Lanes<8> f13_x_p3983_lanes = f13_x_p3968_lanes * f13_x_p2908;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p3987_lanes = f13_x_p2265_lanes * neg_c12_lanes[1] + f13_x_p2261_lanes *
      f13_x_p177_lanes[1] + f13_x_p2252_lanes * f13_x_p2164_lanes[1] + f13_x_p3909_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3990_lanes = f13_x_p3938_lanes - f13_x_p3694_lanes * f13_x_p2486_lanes[7] -
      f13_x_p3806_lanes * f13_x_p2537_lanes[7] - f13_x_p3892_lanes * f13_x_p2573_lanes[7];
  const Lanes<8> f13_x_p4019_lanes = f13_x_p3990_lanes - f13_x_p3983_lanes * f13_x_p2801;
  const Lanes<8> f13_x_p4023_lanes = f13_x_p3979_lanes - f13_x_p3418_lanes * f13_x_p3394_lanes[0] -
      f13_x_p3518_lanes * f13_x_p3494_lanes[0] - f13_x_p3610_lanes * f13_x_p3562_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p4027_lanes = f13_x_p3987_lanes + f13_x_p2379_lanes * f13_x_p2367_lanes[1] +
      f13_x_p3054_lanes * f13_x_p2816_lanes[1] + f13_x_p3050_lanes * f13_x_p2913_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4030_lanes = f13_x_p4019_lanes * f13_x_p3185;
  const Lanes<8> f13_x_p4055_lanes = f13_x_p4023_lanes - f13_x_p3694_lanes * f13_x_p3674_lanes[0] -
      f13_x_p3806_lanes * f13_x_p3786_lanes[0] - f13_x_p3892_lanes * f13_x_p3858_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p4059_lanes = f13_x_p4027_lanes + f13_x_p3042_lanes * f13_x_p3026_lanes[1] +
      f13_x_p3145_lanes * f13_x_p3129_lanes[1] + f13_x_p3270_lanes * f13_x_p3258_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4069_lanes = f13_x_p4055_lanes - f13_x_p3983_lanes * f13_x_p3968_lanes[0] -
      f13_x_p4030_lanes * f13_x_p4019_lanes[0];

  // link 3 (hip), force propagation
  const Real f13_x_p4076 = f13_x_p2416_lanes[1] + f13_x_p3054_lanes[2] * f13_x_p2816_lanes[2] +
      f13_x_p3050_lanes[2] * f13_x_p2913_lanes[2] + f13_x_p3042_lanes[2] * f13_x_p3026_lanes[2] +
      f13_x_p3145_lanes[2] * f13_x_p3129_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p4077 = f13_x_p4069_lanes[0] * f13_x_p4069_lanes[0];
  const Lanes<8> f13_x_p4078_lanes = f13_x_p4059_lanes + f13_x_p3338_lanes * f13_x_p3314_lanes[1] -
      f13_x_p3418_lanes * f13_x_p3394_lanes[1] - f13_x_p3518_lanes * f13_x_p3494_lanes[1];
  const Real f13_x_p4081 = f13_x_p4077 * f13_x_p4069_lanes[0];
  const Lanes<8> f13_x_p4088_lanes = f13_x_p4078_lanes - f13_x_p3610_lanes * f13_x_p3562_lanes[1] -
      f13_x_p3694_lanes * f13_x_p3674_lanes[1] - f13_x_p3806_lanes * f13_x_p3786_lanes[1];
  const Real f13_x_p4091 = f13_x_p4076 + f13_x_p3270_lanes[2] * f13_x_p3258_lanes[2] +
      f13_x_p3338_lanes[2] * f13_x_p3314_lanes[2] - f13_x_p3418_lanes[2] * f13_x_p3394_lanes[2] -
      f13_x_p3518_lanes[2] * f13_x_p3494_lanes[2];
  const Real f13_x_p4095 = f13_x_p4081 * f13_x_p4077 /
      (3.0814879110195774e-33 + f13_x_p4081 * f13_x_p4081);
  const Lanes<8> f13_x_p4099_lanes = f13_x_p4088_lanes - f13_x_p3892_lanes * f13_x_p3858_lanes[1] -
      f13_x_p3983_lanes * f13_x_p3968_lanes[1] - f13_x_p4030_lanes * f13_x_p4019_lanes[1];

  // link 3 (hip), force propagation
  const Real f13_x_p4102 = f13_x_p2414_lanes[1] + f13_x_p3054_lanes[3] * f13_x_p2816_lanes[2] +
      f13_x_p3050_lanes[3] * f13_x_p2913_lanes[2] + f13_x_p3042_lanes[3] * f13_x_p3026_lanes[2] +
      f13_x_p3145_lanes[3] * f13_x_p3129_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p4103 = f13_x_p4091 - f13_x_p3610_lanes[2] * f13_x_p3562_lanes[2] -
      f13_x_p3694_lanes[2] * f13_x_p3674_lanes[2] - f13_x_p3806_lanes[2] * f13_x_p3786_lanes[2] -
      f13_x_p3892_lanes[2] * f13_x_p3858_lanes[2];
  const Lanes<8> f13_x_p4104_lanes = f13_x_p4069_lanes * f13_x_p4095;
  const Real f13_x_p4110 = f13_x_p4102 + f13_x_p3270_lanes[3] * f13_x_p3258_lanes[2] +
      f13_x_p3338_lanes[3] * f13_x_p3314_lanes[2] - f13_x_p3418_lanes[3] * f13_x_p3394_lanes[2] -
      f13_x_p3518_lanes[3] * f13_x_p3494_lanes[2];
  const Lanes<8> f13_x_p4111_lanes = f13_x_p4099_lanes - f13_x_p4104_lanes * f13_x_p4069_lanes[1];
  const Real f13_x_p4114 = f13_x_p4111_lanes[1] * f13_x_p4111_lanes[1];

  // link 3 (hip), force propagation
  const Real f13_x_p4115 = f13_x_p2461_lanes[1] + f13_x_p3054_lanes[3] * f13_x_p2816_lanes[3] +
      f13_x_p3050_lanes[3] * f13_x_p2913_lanes[3] + f13_x_p3042_lanes[3] * f13_x_p3026_lanes[3] +
      f13_x_p3145_lanes[3] * f13_x_p3129_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p4116 = f13_x_p4114 * f13_x_p4111_lanes[1];
  const Real f13_x_p4117 = f13_x_p4110 - f13_x_p3610_lanes[3] * f13_x_p3562_lanes[2] -
      f13_x_p3694_lanes[3] * f13_x_p3674_lanes[2] - f13_x_p3806_lanes[3] * f13_x_p3786_lanes[2] -
      f13_x_p3892_lanes[3] * f13_x_p3858_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4120_lanes = 9.81 + detail::make_pack<Real>(xdd_cmd[2], xdd_cmd[8]);
  const Lanes<2> f13_x_p4130_lanes = c1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) - s1 *
      f13_x_p4120_lanes;
  const Lanes<2> f13_x_p4132_lanes = s1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) + c1 *
      f13_x_p4120_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4134 = f13_x_p4115 + f13_x_p3270_lanes[3] * f13_x_p3258_lanes[3] +
      f13_x_p3338_lanes[3] * f13_x_p3314_lanes[3] - f13_x_p3418_lanes[3] * f13_x_p3394_lanes[3] -
      f13_x_p3518_lanes[3] * f13_x_p3494_lanes[3];
  const Real f13_x_p4135 = f13_x_p4116 * f13_x_p4114 /
      (1.4551915228366852e-11 + f13_x_p4116 * f13_x_p4116);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4146_lanes = inverse_D2_p9 * f13_x_p4130_lanes - inverse_D2_p7 *
      f13_x_p4132_lanes;
  const Lanes<2> f13_x_p4148_lanes = inverse_D2_p7 * f13_x_p4130_lanes + inverse_D2_p9 *
      f13_x_p4132_lanes;
  const Lanes<2> f13_x_p4158_lanes = c4 * f13_x_p4146_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Lanes<2> f13_x_p4160_lanes = s4 * f13_x_p4146_lanes - c4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);

  // link 1 (calf), force propagation
  const Real f13_x_p4162 = f13_x_p4134 - f13_x_p3610_lanes[3] * f13_x_p3562_lanes[3] -
      f13_x_p3694_lanes[3] * f13_x_p3674_lanes[3] - f13_x_p3806_lanes[3] * f13_x_p3786_lanes[3] -
      f13_x_p3892_lanes[3] * f13_x_p3858_lanes[3];
  const Real f13_x_p4163 = f13_x_p4111_lanes[2] * f13_x_p4135;
  const Real f13_x_p4164 = f13_x_p4111_lanes[3] * f13_x_p4135;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4173_lanes = s5 * f13_x_p4158_lanes + c5 * f13_x_p4148_lanes;
  const Lanes<2> f13_x_p4175_lanes = c5 * f13_x_p4158_lanes - s5 * f13_x_p4148_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4177 = f13_x_p4103 - f13_x_p3983_lanes[2] * f13_x_p3968_lanes[2] -
      f13_x_p4030_lanes[2] * f13_x_p4019_lanes[2] - f13_x_p4104_lanes[2] * f13_x_p4069_lanes[2] -
      f13_x_p4163 * f13_x_p4111_lanes[2];
  const Real f13_x_p4178 = f13_x_p4117 - f13_x_p3983_lanes[3] * f13_x_p3968_lanes[2] -
      f13_x_p4030_lanes[3] * f13_x_p4019_lanes[2] - f13_x_p4104_lanes[3] * f13_x_p4069_lanes[2] -
      f13_x_p4164 * f13_x_p4111_lanes[2];
  const Real f13_x_p4187 = f13_x_p4177 * f13_x_p4177;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4188_lanes = c6 * f13_x_p4173_lanes + s6 * f13_x_p4160_lanes;
  const Lanes<2> f13_x_p4190_lanes = s6 * f13_x_p4173_lanes - c6 * f13_x_p4160_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4192 = f13_x_p4162 - f13_x_p3983_lanes[3] * f13_x_p3968_lanes[3] -
      f13_x_p4030_lanes[3] * f13_x_p4019_lanes[3] - f13_x_p4104_lanes[3] * f13_x_p4069_lanes[3] -
      f13_x_p4164 * f13_x_p4111_lanes[3];
  const Real f13_x_p4193 = f13_x_p4187 * f13_x_p4177;

  // link 2 (thigh), outward
  const Real wd2_z = qdd_0[0] + qdd_0[1];
  const Real w2_z = qd[0] + qd[1];
  const Real a3_x_p1 = w2_z * w2_z;

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4202_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4188_lanes +
      detail::make_pack<Real>(s7, s14) * f13_x_p4175_lanes;
  const Lanes<2> f13_x_p4204_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4175_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4188_lanes;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];

  // link 2 (thigh), outward
  const Real a2_y = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 3 (hip), outward
  const Real a5_y_p1 = w3_z * w3_z;
  const Real wd3_z = wd2_z + qdd_0[2];

  // link 2 (thigh), outward
  const Real a2_x = 0.434 * qdd_0[0] - minus_a1_x;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4214_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4202_lanes +
      detail::make_pack<Real>(c8, c15) * f13_x_p4190_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4216 = f13_x_p4193 * f13_x_p4187 /
      (2.2737367544323206e-13 + f13_x_p4193 * f13_x_p4193);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4217_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4190_lanes -
      detail::make_pack<Real>(c8, c15) * f13_x_p4202_lanes;

  // link 3 (hip), outward
  const Real a3_x_p2 = a2_y + (wd2_z * inverse_D2_p10 + a3_x_p1 * inverse_D2_p8);

  // link 5 (chest2), outward
  const Real w5_x_p1 = s4 * w3_z;

  // link 3 (hip), outward
  const Real a3_x_p3 = a2_x + (wd2_z * inverse_D2_p8 - a3_x_p1 * inverse_D2_p10);

  // link 4 (chest1), outward
  const Real wd4_x = w3_z * qd[3];

  // link 5 (chest2), outward
  const Real w5_z = c4 * w3_z + qd[4];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4227_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4214_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4204_lanes;
  const Lanes<2> f13_x_p4229_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4214_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4204_lanes;

  // link 5 (chest2), outward
  const Real w5_x = c5 * w5_x_p1 - s5 * qd[3];

  // link 3 (hip), outward
  const Real a3_x = inverse_D2_p9 * a3_x_p3 + inverse_D2_p7 * a3_x_p2;
  const Real a3_y = inverse_D2_p9 * a3_x_p2 - inverse_D2_p7 * a3_x_p3;

  // link 5 (chest2), outward
  const Real a6_x_p1 = w5_z * w5_z;
  const Real minus_w5_y = s5 * w5_x_p1 + c5 * qd[3];
  const Real a5_y_p2 = a3_x + 0.21799999999999997 * wd3_z;
  const Real a6_x_p2 = w5_x * w5_x;
  const Real wd5_x_p1 = c4 * wd4_x + s4 * wd3_z;
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * a5_y_p1;

  // link 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];

  // link 1 (calf), force propagation
  const Real f13_x_p4237 = f13_x_p4178 * f13_x_p4216;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4238_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4227_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4217_lanes;
  const Lanes<2> f13_x_p4240_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4217_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4227_lanes;

  // link 5 (chest2), outward
  const Real a5_y_p4 = c4 * a5_y_p2;
  const Real a6_x_p3 = a6_x_p2 + a6_x_p1;
  const Real minus_a5_z = s4 * a5_y_p2;

  // link 6 (chest3), outward
  const Real a7_y_p1 = w6_z * w6_z;

  // link 5 (chest2), outward
  const Real wd6_x_p1 = w5_x * minus_w5_y;

  // link 6 (chest3), outward
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real a7_y_p2 = w6_x * w6_y;
  const Real wd6_y_p1 = w6_x * w6_z;

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd5_x_p1 - s5 * qdd_0[3] - minus_w5_y * qd[4];
  const Real a5_y = c5 * a5_y_p3 - s5 * a5_y_p4;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4246_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4238_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4229_lanes;

  // link 5 (chest2), outward
  const Real wd5_z = qdd_0[4] - (s4 * wd4_x - c4 * wd3_z);

  // link 6 (chest3), outward
  const Real wd6_x_p2 = w6_y * w6_z;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a5_y_p4 + s5 * a5_y_p3;

  // link 1 (calf), force propagation
  const Real f13_x_p4248 = f13_x_p4192 - f13_x_p4237 * f13_x_p4178;

  // link 5 (chest2), outward
  const Real a6_x_p4 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real wd6_z = wd5_x + qdd_0[5];
  const Real a6_x_p5 = a5_y + 0.072 * a6_x_p3;
  const Real a7_y_p3 = w6_y * w6_y + a7_y_p1;

  // link 5 (chest2), outward
  const Real wd6_x_p3 = s5 * wd5_x_p1 + c5 * qdd_0[3] + (w5_z + qd[4]) * w5_x;
  const Real wd6_x_p4 = wd5_z - wd6_x_p1;
  const Real a6_z_p1 = wd6_x_p1 + wd5_z;

  // link 1 (calf), force propagation
  const Real f13_x_p4251 = f13_x_p4248 * f13_x_p4248;

  // link 6 (chest3), outward
  const Real a7_y_p4 = a7_y_p2 - wd6_z;
  const Real minus_a7_z_p1 = w6_x * w6_x;
  const Real minus_a7_z_p2 = a7_y_p2 + wd6_z;
  const Real a6_x_p6 = minus_a5_z + 0.072 * a6_x_p4;

  // link 1 (calf), force propagation
  const Real f13_x_p4254 = f13_x_p4251 * f13_x_p4248;

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = minus_a7_z_p1 + a7_y_p1;
  const Real wd6_x_p5 = c6 * wd6_x_p3 - s6 * wd6_x_p4;
  const Real a6_z = a5_x + 0.072 * a6_z_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // link 6 (chest3), outward
  const Real wd6_x = wd6_x_p2 - wd6_x_p5;
  const Real wd6_y = c6 * wd6_x_p4 + s6 * wd6_x_p3 - wd6_y_p1;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p3_lanes = w7_x_lanes * w7_y_lanes;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a6_x_p5 - s6 * a6_x_p6;
  const Real minus_a12_y_p4 = wd6_x_p2 + wd6_x;
  const Real a7_y_p6 = wd6_y_p1 - wd6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_z_lanes = wd6_y + detail::make_pack<Real>(qdd_0[6], qdd_0[13]);
  const Lanes<2> wd7_x_p2_lanes = w7_y_lanes * w7_z_lanes;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p5 + c6 * a6_x_p6;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p7 = a6_x + 0.226 * a7_y_p3;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p7_lanes = minus_a12_y_p3_lanes + wd7_z_lanes;

  // link 14 (right_shoulder1), outward
  const Real minus_a7_z_p5 = minus_a6_y + 0.226 * minus_a7_z_p2;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p9_lanes = a7_y_p7 + detail::make_pack<Real>(0.18, (-0.18)) * a7_y_p4;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p1_lanes = w8_z_lanes * w8_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p8_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p4 +
      detail::make_pack<Real>(c7, c14) * minus_a12_y_p4;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p10 = a6_z - 0.226 * a7_y_p6;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_x_p4_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p4 -
      detail::make_pack<Real>(s7, s14) * minus_a12_y_p4;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a12_y_p11_lanes = w8_x_lanes * w8_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p5 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p3;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p2_lanes = w8_y_lanes * w8_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p12_lanes = 2.0 * (w7_x_lanes * w7_z_lanes) - minus_a12_y_p8_lanes;
  const Lanes<2> a7_y_p12_lanes = a7_y_p10 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a12_y_p4;
  const Lanes<2> wd7_x_lanes = wd7_x_p2_lanes - wd7_x_p4_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_p2_lanes = w8_y_lanes * w8_z_lanes;
  const Lanes<2> wd8_z_lanes = wd7_x_lanes + detail::make_pack<Real>(qdd_0[7], qdd_0[14]);
  const Lanes<2> a10_x_p3_lanes = a10_x_p2_lanes + a10_x_p1_lanes;
  const Lanes<2> minus_a12_y_p15_lanes = minus_a12_y_p11_lanes + wd8_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_x_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a12_y_p16_lanes = detail::make_pack<Real>(c8, c15) * minus_a12_y_p7_lanes +
      detail::make_pack<Real>(s8, s15) * minus_a12_y_p12_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p9_lanes -
      detail::make_pack<Real>(s7, s14) * a7_y_p12_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_p4_lanes = detail::make_pack<Real>(c8, c15) * minus_a12_y_p12_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a12_y_p7_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p9_lanes +
      detail::make_pack<Real>(c7, c14) * a7_y_p12_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_y_lanes = detail::make_pack<Real>(c9, c16) * w8_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a12_y_p18_lanes = 2.0 * (w8_x_lanes * w8_z_lanes) - minus_a12_y_p16_lanes;
  const Lanes<2> wd8_x_lanes = wd8_x_p2_lanes - wd8_x_p4_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_wd9_y_p1_lanes = w9_x_lanes * w9_z_lanes;
  const Lanes<2> minus_a12_y_p20_lanes = w9_x_lanes * w9_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);

  // link 9 (left_upperarm), outward
  const Lanes<2> wd9_z_lanes = detail::make_pack<Real>(qdd_0[8], qdd_0[15]) - wd8_x_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_z_lanes;
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a12_y_p23_lanes = minus_a12_y_p20_lanes - wd9_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p24_lanes = w10_z_lanes * w10_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a12_y_p25_lanes = detail::make_pack<Real>(s9, s16) * minus_a12_y_p18_lanes -
      detail::make_pack<Real>(c9, c16) * minus_a12_y_p15_lanes;
  const Lanes<2> a10_x_p7_lanes = detail::make_pack<Real>(s9, s16) * minus_a12_y_p15_lanes +
      detail::make_pack<Real>(c9, c16) * minus_a12_y_p18_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;
  const Lanes<2> a10_x_p8_lanes = 0.282 * a10_x_p3_lanes - a8_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a12_y_p28_lanes = 2.0 * (w9_y_lanes * w9_z_lanes) - minus_a12_y_p25_lanes;
  const Lanes<2> minus_wd9_y_lanes = a10_x_p7_lanes + minus_wd9_y_p1_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p29_lanes = w10_x_lanes * minus_w10_y_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p31_lanes = w10_x_lanes * w10_x_lanes;
  const Lanes<2> wd10_z_lanes = detail::make_pack<Real>(qdd_0[9], qdd_0[16]) - minus_wd9_y_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_z_lanes = minus_w10_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p11_lanes = a9_x_lanes + 0.282 * a10_x_p7_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;
  const Lanes<2> f13_x_p4263_lanes = 0.086 * detail::make_pack<Real>(c13, c20);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p33_lanes = minus_a12_y_p29_lanes + wd10_z_lanes;
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * minus_a12_y_p25_lanes;
  const Lanes<2> minus_a12_y_p34_lanes = detail::make_pack<Real>(s10, s17) * minus_a12_y_p23_lanes +
      detail::make_pack<Real>(c10, c17) * minus_a12_y_p28_lanes;
  const Lanes<2> minus_a12_y_p35_lanes = minus_a12_y_p31_lanes + minus_a12_y_p24_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4267_lanes = c1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) - s1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4271_lanes = s1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) + c1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p37_lanes = minus_a12_y_p34_lanes - 2.0 *
      (minus_w10_y_lanes * w10_z_lanes);
  const Lanes<2> a10_x_lanes = detail::make_pack<Real>(c10, c17) * a10_x_p11_lanes -
      detail::make_pack<Real>(s10, s17) * a10_x_p8_lanes;
  const Lanes<2> minus_a10_y_lanes = detail::make_pack<Real>(s10, s17) * a10_x_p11_lanes +
      detail::make_pack<Real>(c10, c17) * a10_x_p8_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> minus_a12_y_p40_lanes = minus_a10_y_lanes + 0.269 * minus_a12_y_p35_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);

  // link 12 (left_wrist2), outward
  const Lanes<2> f13_x_p4281_lanes = w12_z_lanes * w12_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4283_lanes = inverse_D2_p9 * f13_x_p4267_lanes - inverse_D2_p7 *
      f13_x_p4271_lanes;
  const Lanes<2> f13_x_p4285_lanes = inverse_D2_p7 * f13_x_p4267_lanes + inverse_D2_p9 *
      f13_x_p4271_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a12_y_p41_lanes = detail::make_pack<Real>(c11, c18) * minus_a12_y_p33_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a12_y_p37_lanes;
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4287_lanes = w13_z_lanes * w13_z_lanes;
  const Lanes<2> f13_x_p4297_lanes = f13_x_p4281_lanes + f13_x_p4287_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4299_lanes = c4 * f13_x_p4283_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> f13_x_p4301_lanes = s4 * f13_x_p4283_lanes - c4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p44_lanes = a11_x_lanes - 0.269 * minus_a12_y_p41_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4313_lanes = s5 * f13_x_p4299_lanes + c5 * f13_x_p4285_lanes;
  const Lanes<2> f13_x_p4315_lanes = c5 * f13_x_p4299_lanes - s5 * f13_x_p4285_lanes;
  const Lanes<2> f13_x_p4317_lanes = 0.086 * detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p44_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p40_lanes;
  const Lanes<2> f13_x_p4327_lanes = minus_w12_y_lanes * w12_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4335_lanes = c6 * f13_x_p4313_lanes + s6 * f13_x_p4301_lanes;
  const Lanes<2> f13_x_p4337_lanes = s6 * f13_x_p4313_lanes - c6 * f13_x_p4301_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> f13_x_p4339_lanes = minus_w12_y_lanes * minus_w12_y_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4341_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4240_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4246_lanes + minus_a12_y_lanes +
      f13_x_p4297_lanes * f13_x_p4263_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> a12_z_p3_lanes = detail::make_pack<Real>(s11, s18) * minus_a12_y_p33_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a12_y_p37_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4353_lanes = f13_x_p4339_lanes + f13_x_p4287_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4359_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4335_lanes +
      detail::make_pack<Real>(s7, s14) * f13_x_p4315_lanes;
  const Lanes<2> f13_x_p4361_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4315_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4335_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_z_lanes = 0.269 * a12_z_p3_lanes - minus_a11_y_lanes;
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p44_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p40_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4367_lanes = minus_w12_y_lanes * w13_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4379_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4246_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4240_lanes - a12_x_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4381_lanes = w12_z_lanes * w13_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4383_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4359_lanes +
      detail::make_pack<Real>(c8, c15) * f13_x_p4337_lanes;
  const Lanes<2> f13_x_p4385_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4337_lanes -
      detail::make_pack<Real>(c8, c15) * f13_x_p4359_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4387_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4229_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4238_lanes - a12_z_lanes + f13_x_p4353_lanes *
      f13_x_p4317_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_p3_lanes = w10_x_lanes * w10_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4397_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4383_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4361_lanes;
  const Lanes<2> f13_x_p4399_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4383_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4361_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd13_x_p1_lanes = w11_x_lanes * w11_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_p4_lanes = detail::make_pack<Real>(c10, c17) * minus_a12_y_p23_lanes -
      detail::make_pack<Real>(s10, s17) * minus_a12_y_p28_lanes;
  const Lanes<2> wd10_y_lanes = wd10_y_p4_lanes - wd10_y_p3_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4409_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4397_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4385_lanes;
  const Lanes<2> f13_x_p4411_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4385_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4397_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_z_lanes = detail::make_pack<Real>(qdd_0[10], qdd_0[17]) - wd10_y_lanes;
  const Lanes<2> wd13_x_p6_lanes = wd13_x_p1_lanes - wd11_z_lanes;
  const Lanes<2> wd13_x_p7_lanes = a12_z_p3_lanes + 2.0 * (w11_y_lanes * w11_z_lanes);
  const Lanes<2> wd11_y_p1_lanes = w11_x_lanes * w11_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4421_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4409_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4399_lanes;
  const Lanes<2> f13_x_p4423_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4399_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4409_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd13_y_p1_lanes = w12_x_lanes * minus_w12_y_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_y_lanes = minus_a12_y_p41_lanes - wd11_y_p1_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd13_x_p10_lanes = detail::make_pack<Real>(c12, c19) * wd13_x_p6_lanes -
      detail::make_pack<Real>(s12, s19) * wd13_x_p7_lanes;
  const Lanes<2> wd12_z_lanes = wd11_y_lanes + detail::make_pack<Real>(qdd_0[11], qdd_0[18]);

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4431_lanes = (f13_x_p4367_lanes + f13_x_p4423_lanes) * f13_x_p4263_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4433_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4421_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4411_lanes;
  const Lanes<2> f13_x_p4435_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4411_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4421_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd13_x_p11_lanes = 2.0 * (w12_x_lanes * w12_z_lanes) - wd13_x_p10_lanes;
  const Lanes<2> wd13_y_p2_lanes = wd12_z_lanes - wd13_y_p1_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_x_lanes = f13_x_p4381_lanes - wd13_x_p11_lanes;
  const Lanes<2> wd13_y_lanes = wd13_y_p2_lanes + f13_x_p4367_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4443_lanes = (f13_x_p4327_lanes + f13_x_p4433_lanes) * f13_x_p4317_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4445_lanes = (f13_x_p4327_lanes - f13_x_p4433_lanes) * f13_x_p4263_lanes;
  const Lanes<2> f13_x_p4447_lanes = (f13_x_p4381_lanes + f13_x_p4435_lanes) * f13_x_p4317_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4449_lanes = f13_x_p4435_lanes - wd13_x_lanes;
  const Lanes<2> f13_x_p4451_lanes = f13_x_p4423_lanes - wd13_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(s12, s19) * wd13_x_p6_lanes +
      detail::make_pack<Real>(c12, c19) * wd13_x_p7_lanes - f13_x_p4327_lanes;

  // link 24 (right_eye), outward
  const Real f13_x_p4453 = f13_x_p4341_lanes[0] + f13_x_p4443_lanes[0];

  // link 13 (left_hand), outward
  const Lanes<2> wd13_z_lanes = wd12_x_lanes + detail::make_pack<Real>(qdd_0[12], qdd_0[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4454_lanes = f13_x_p4433_lanes - wd13_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4456 = f13_x_p4387_lanes[0] - f13_x_p2111_lanes[1] * f13_x_p4453 +
      f13_x_p4445_lanes[0];
  const Real f13_x_p4457 = f13_x_p4379_lanes[0] - f13_x_p2111_lanes[2] * f13_x_p4453 -
      f13_x_p2314_lanes[2] * f13_x_p4456 + f13_x_p4431_lanes[0] - f13_x_p4447_lanes[0];
  const Real f13_x_p4458 = f13_x_p4449_lanes[0] - f13_x_p2111_lanes[3] * f13_x_p4453 -
      f13_x_p2314_lanes[3] * f13_x_p4456 - f13_x_p2456_lanes[3] * f13_x_p4457;
  const Real f13_x_p4459 = f13_x_p4451_lanes[0] - f13_x_p2111_lanes[4] * f13_x_p4453 -
      f13_x_p2314_lanes[4] * f13_x_p4456 - f13_x_p2456_lanes[4] * f13_x_p4457 -
      f13_x_p2521_lanes[4] * f13_x_p4458;
  const Real f13_x_p4460 = f13_x_p4454_lanes[0] - f13_x_p2111_lanes[5] * f13_x_p4453 -
      f13_x_p2314_lanes[5] * f13_x_p4456 - f13_x_p2456_lanes[5] * f13_x_p4457 -
      f13_x_p2521_lanes[5] * f13_x_p4458;
  const Real f13_x_p4461 = f13_x_p4341_lanes[1] - f13_x_p2111_lanes[6] * f13_x_p4453 -
      f13_x_p2314_lanes[6] * f13_x_p4456 - f13_x_p2456_lanes[6] * f13_x_p4457 -
      f13_x_p2521_lanes[6] * f13_x_p4458;
  const Real f13_x_p4462 = f13_x_p4387_lanes[1] - f13_x_p2111_lanes[7] * f13_x_p4453 -
      f13_x_p2314_lanes[7] * f13_x_p4456 - f13_x_p2456_lanes[7] * f13_x_p4457 -
      f13_x_p2521_lanes[7] * f13_x_p4458;
  const Real f13_x_p4463 = f13_x_p4379_lanes[1] - f13_x_p3418_lanes[0] * f13_x_p4453 -
      f13_x_p3518_lanes[0] * f13_x_p4456 - f13_x_p3610_lanes[0] * f13_x_p4457 -
      f13_x_p3694_lanes[0] * f13_x_p4458;
  const Real f13_x_p4464 = f13_x_p4460 - f13_x_p2550_lanes[5] * f13_x_p4459;
  const Real f13_x_p4465 = f13_x_p4449_lanes[1] - f13_x_p3418_lanes[1] * f13_x_p4453 -
      f13_x_p3518_lanes[1] * f13_x_p4456 - f13_x_p3610_lanes[1] * f13_x_p4457 -
      f13_x_p3694_lanes[1] * f13_x_p4458;
  const Real f13_x_p4466 = f13_x_p4461 - f13_x_p2550_lanes[6] * f13_x_p4459 - f13_x_p2778 *
      f13_x_p4464 + f13_x_p4443_lanes[1];
  const Real f13_x_p4467 = f13_x_p4451_lanes[1] - f13_x_p3418_lanes[2] * f13_x_p4453 -
      f13_x_p3518_lanes[2] * f13_x_p4456 - f13_x_p3610_lanes[2] * f13_x_p4457 -
      f13_x_p3694_lanes[2] * f13_x_p4458;
  const Real f13_x_p4468 = f13_x_p4454_lanes[1] - f13_x_p3418_lanes[3] * f13_x_p4453 -
      f13_x_p3518_lanes[3] * f13_x_p4456 - f13_x_p3610_lanes[3] * f13_x_p4457 -
      f13_x_p3694_lanes[3] * f13_x_p4458;
  const Real f13_x_p4469 = f13_x_p4462 - f13_x_p2550_lanes[7] * f13_x_p4459 - f13_x_p2779 *
      f13_x_p4464 - f13_x_p3001 * f13_x_p4466 + f13_x_p4445_lanes[1];
  const Real f13_x_p4470 = f13_x_p4463 - f13_x_p3806_lanes[0] * f13_x_p4459 - f13_x_p3892_lanes[0] *
      f13_x_p4464 - f13_x_p3983_lanes[0] * f13_x_p4466 - f13_x_p4030_lanes[0] * f13_x_p4469;
  const Real f13_x_p4471 = f13_x_p4465 - f13_x_p3806_lanes[1] * f13_x_p4459 - f13_x_p3892_lanes[1] *
      f13_x_p4464 - f13_x_p3983_lanes[1] * f13_x_p4466 - f13_x_p4030_lanes[1] * f13_x_p4469;
  const Real f13_x_p4472 = f13_x_p4467 - f13_x_p3806_lanes[2] * f13_x_p4459 - f13_x_p3892_lanes[2] *
      f13_x_p4464 - f13_x_p3983_lanes[2] * f13_x_p4466 - f13_x_p4030_lanes[2] * f13_x_p4469;
  const Real f13_x_p4473 = f13_x_p4468 - f13_x_p3806_lanes[3] * f13_x_p4459 - f13_x_p3892_lanes[3] *
      f13_x_p4464 - f13_x_p3983_lanes[3] * f13_x_p4466 - f13_x_p4030_lanes[3] * f13_x_p4469;
  const Real f13_x_p4474 = f13_x_p4470 + f13_x_p4431_lanes[1] - f13_x_p4447_lanes[1];
  const Real f13_x_p4475 = f13_x_p4471 - f13_x_p4104_lanes[1] * f13_x_p4474;
  const Real f13_x_p4476 = f13_x_p4472 - f13_x_p4104_lanes[2] * f13_x_p4474 - f13_x_p4163 *
      f13_x_p4475;
  const Real f13_x_p4477 = (f13_x_p4473 - f13_x_p4104_lanes[3] * f13_x_p4474 - f13_x_p4164 *
      f13_x_p4475 - f13_x_p4237 * f13_x_p4476) * (f13_x_p4254 * f13_x_p4251 /
      (2.2737367544323206e-13 + f13_x_p4254 * f13_x_p4254));
  const Real f13_x_p4478 = f13_x_p4476 * f13_x_p4216 - f13_x_p4237 * f13_x_p4477;
  const Real f13_x_p4479 = f13_x_p4475 * f13_x_p4135 - f13_x_p4163 * f13_x_p4478 - f13_x_p4164 *
      f13_x_p4477;
  const Real f13_x_p4480 = f13_x_p4474 * f13_x_p4095 - f13_x_p4104_lanes[1] * f13_x_p4479 -
      f13_x_p4104_lanes[2] * f13_x_p4478 - f13_x_p4104_lanes[3] * f13_x_p4477;
  const Real f13_x_p4481 = f13_x_p4469 * f13_x_p3185 - f13_x_p4030_lanes[0] * f13_x_p4480 -
      f13_x_p4030_lanes[1] * f13_x_p4479 - f13_x_p4030_lanes[2] * f13_x_p4478 -
      f13_x_p4030_lanes[3] * f13_x_p4477;
  const Real f13_x_p4482 = f13_x_p4466 * f13_x_p2908 - f13_x_p3001 * f13_x_p4481 -
      f13_x_p3983_lanes[0] * f13_x_p4480 - f13_x_p3983_lanes[1] * f13_x_p4479 -
      f13_x_p3983_lanes[2] * f13_x_p4478;
  const Real f13_x_p4483 = f13_x_p4482 - f13_x_p3983_lanes[3] * f13_x_p4477;
  const Real f13_x_p4484 = f13_x_p4464 * f13_x_p2701 - f13_x_p2778 * f13_x_p4483 - f13_x_p2779 *
      f13_x_p4481 - f13_x_p3892_lanes[0] * f13_x_p4480 - f13_x_p3892_lanes[1] * f13_x_p4479;
  const Real f13_x_p4485 = f13_x_p4484 - f13_x_p3892_lanes[2] * f13_x_p4478 - f13_x_p3892_lanes[3] *
      f13_x_p4477;
  const Real f13_x_p4486 = f13_x_p4459 * f13_x_p2547 - f13_x_p2550_lanes[5] * f13_x_p4485 -
      f13_x_p2550_lanes[6] * f13_x_p4483 - f13_x_p2550_lanes[7] * f13_x_p4481 -
      f13_x_p3806_lanes[0] * f13_x_p4480;
  const Real f13_x_p4487 = f13_x_p4486 - f13_x_p3806_lanes[1] * f13_x_p4479 - f13_x_p3806_lanes[2] *
      f13_x_p4478 - f13_x_p3806_lanes[3] * f13_x_p4477;
  const Real f13_x_p4488 = f13_x_p4458 * f13_x_p2516 - f13_x_p2521_lanes[4] * f13_x_p4487 -
      f13_x_p2521_lanes[5] * f13_x_p4485 - f13_x_p2521_lanes[6] * f13_x_p4483 -
      f13_x_p2521_lanes[7] * f13_x_p4481;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4489_lanes = f13_x_p4327_lanes + wd13_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_x_p4492_lanes = f13_x_p4297_lanes * inverse_D10_p6_lanes + f13_x_p4489_lanes *
      inverse_D10_p5_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4493 = f13_x_p4488 - f13_x_p3694_lanes[0] * f13_x_p4480 - f13_x_p3694_lanes[1] *
      f13_x_p4479 - f13_x_p3694_lanes[2] * f13_x_p4478 - f13_x_p3694_lanes[3] * f13_x_p4477;

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p1_lanes = f13_x_p4381_lanes + wd13_x_lanes;
  const Lanes<2> f13_z_p2_lanes = f13_x_p4367_lanes + wd13_y_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_y_p5_lanes = 0.0025100003499999995 * wd13_y_p2_lanes - 0.0006000000000000001 *
      (w12_x_lanes * w12_x_lanes + f13_x_p4281_lanes);

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_x_p2_lanes = wd13_y_p1_lanes + wd12_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_p5_lanes = f13_z_p1_lanes * inverse_D10_p5_lanes - f13_z_p2_lanes *
      inverse_D10_p6_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_x_p1_lanes = w11_y_lanes * w11_y_lanes;
  const Lanes<2> f11_x_p2_lanes = w11_z_lanes * w11_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_x_p5_lanes = 0.0025100003499999995 * (f13_x_p4339_lanes + f13_x_p4281_lanes) +
      0.0006000000000000001 * f12_x_p2_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4494 = f13_x_p4457 * f13_x_p2431 - f13_x_p2456_lanes[3] * f13_x_p4493 -
      f13_x_p2456_lanes[4] * f13_x_p4487 - f13_x_p2456_lanes[5] * f13_x_p4485 -
      f13_x_p2456_lanes[6] * f13_x_p4483;

  // link 13 (left_hand), outward
  const Lanes<2> f13_y_p1_lanes = wd13_z_lanes - f13_x_p4327_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_z_p2_lanes = wd12_x_lanes - f13_x_p4327_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_x_p6_lanes = detail::make_pack<Real>(0.001, (-0.001)) * wd13_x_p6_lanes -
      6e-04 * (f11_x_p1_lanes + f11_x_p2_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_y_p1_lanes = wd13_x_p1_lanes + wd11_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_y_p4_lanes = f13_y_p1_lanes * inverse_D10_p6_lanes - f13_x_p4353_lanes *
      inverse_D10_p5_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_y_p2_lanes = w11_x_lanes * w11_x_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_z_p4_lanes = 0.0025100003499999995 * wd13_x_p11_lanes + 0.0006000000000000001 *
      f12_z_p2_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4495 = f13_x_p4494 - f13_x_p2456_lanes[7] * f13_x_p4481 - f13_x_p3610_lanes[0] *
      f13_x_p4480 - f13_x_p3610_lanes[1] * f13_x_p4479 - f13_x_p3610_lanes[2] * f13_x_p4478;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p1_lanes = wd10_y_p3_lanes - wd10_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4496 = f13_x_p4495 - f13_x_p3610_lanes[3] * f13_x_p4477;

  // link 24 (right_eye), inertial wrench
  const Real f13_z = f13_z_p5_lanes[0] + f13_x_p4496;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_y_p6_lanes = 6e-04 * f11_y_p1_lanes -
      detail::make_pack<Real>(0.001, (-0.001)) * (f11_y_p2_lanes + f11_x_p2_lanes);

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - f12_x_p5_lanes[0];

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_z_p4_lanes = 0.0014999985000000002 * f10_z_p1_lanes + 0.28049749700000004 *
      minus_a12_y_p37_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p7_lanes = (f13_x_p4287_lanes - f13_x_p4281_lanes) * inverse_D12_p5_lanes;
  const Lanes<2> n13_x_p9_lanes = f13_z_p1_lanes * inverse_D11_p9_lanes - f13_z_p2_lanes *
      inverse_D11_p7_lanes - f13_y_p1_lanes * inverse_D11_p3_lanes + n13_x_p7_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4497 = f13_x_p4456 * f13_x_p2256 - f13_x_p2314_lanes[2] * f13_x_p4496 -
      f13_x_p2314_lanes[3] * f13_x_p4493 - f13_x_p2314_lanes[4] * f13_x_p4487 -
      f13_x_p2314_lanes[5] * f13_x_p4485;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n13_z_p6_lanes = f13_x_p4281_lanes - f13_x_p4339_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p10_lanes = n13_x_p9_lanes + inverse_D10_p5_lanes * a12_x_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_y_p5_lanes = 0.000195227662257343 * wd13_x_p11_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * f12_x_p2_lanes +
      0.0025100003499999995 * a12_z_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n13_x = n13_x_p10_lanes[0] + f13_x_p4493;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p11_lanes = inverse_D10_p6_lanes * a12_z_lanes + inverse_D10_p5_lanes *
      minus_a12_y_lanes;
  const Lanes<2> n13_z_p12_lanes = 0.0009386316083993107 * wd13_z_lanes - f13_x_p4327_lanes *
      (inverse_D12_p10_lanes - inverse_D11_p9_lanes) + wd13_x_p11_lanes * inverse_D11_p3_lanes;

  // link 13 (left_hand), inward
  const Real n12_y = n13_x - n12_y_p5_lanes[0];

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p2_lanes = wd11_y_p1_lanes - wd11_y_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_x_p5_lanes = 1.16e-05 * f12_z_p2_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * n13_z_p6_lanes +
      0.0006000000000000001 * a12_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4498 = f13_x_p4497 - f13_x_p2314_lanes[6] * f13_x_p4483 - f13_x_p2314_lanes[7] *
      f13_x_p4481 - f13_x_p3518_lanes[0] * f13_x_p4480 - f13_x_p3518_lanes[1] * f13_x_p4479;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p7_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (f11_x_p2_lanes - f11_x_p1_lanes);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p15_lanes = n13_z_p12_lanes - wd13_y_p2_lanes * inverse_D12_p5_lanes +
      n13_z_p6_lanes * inverse_D11_p7_lanes + n13_z_p11_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p4_lanes = 0.0025100003499999995 * minus_a12_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4499 = f13_x_p4498 - f13_x_p3518_lanes[2] * f13_x_p4478 - f13_x_p3518_lanes[3] *
      f13_x_p4477;

  // link 24 (right_eye), inertial wrench
  const Real n13_z = n13_z_p15_lanes[0] + f13_x_p4485;
  tau[12] = n13_z;
  const Real f13_y = f13_y_p4_lanes[0] + f13_x_p4499;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p11_lanes = inverse_D10_p9_lanes * a12_x_lanes;
  const Real n12_x = n12_x_p5_lanes[0] + n13_z;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p10_lanes = 0.0001194 * wd13_x_p7_lanes +
      detail::make_pack<Real>(6e-06, (-6e-06)) * n11_x_p2_lanes + 0.000144 * f11_y_p1_lanes +
      n11_x_p7_lanes;

  // link 13 (left_hand), inward
  const Real f12_z = f12_z_p4_lanes[0] + f13_y;
  const Lanes<2> n12_z_p13_lanes = 0.000206827662257343 * wd12_z_lanes - 0.000183627662257343 *
      wd13_y_p1_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      wd13_x_p10_lanes - n12_z_p4_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p11_lanes = n11_x_p10_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_y_lanes;
  const Lanes<2> n11_y_p7_lanes = 0.000144 * (f11_y_p2_lanes - f11_x_p2_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p3_lanes = wd10_z_lanes - minus_a12_y_p29_lanes;
  const Lanes<2> n10_x_p4_lanes = minus_w10_y_lanes * minus_w10_y_lanes;

  // link 12 (left_wrist2), inward
  const Real f11_y = f11_y_p6_lanes[0] + f12_z;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p9_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      wd13_x_p6_lanes - 0.0001098 * n11_x_p2_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) *
      wd13_x_p7_lanes - n11_y_p7_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4500 = f13_x_p4453 * f13_x_p2053 - f13_x_p2111_lanes[1] * f13_x_p4499 -
      f13_x_p2111_lanes[2] * f13_x_p4496 - f13_x_p2111_lanes[3] * f13_x_p4493 -
      f13_x_p2111_lanes[4] * f13_x_p4487;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p16_lanes = n12_z_p13_lanes + f13_z_p2_lanes * inverse_D12_p10_lanes -
      f13_x_p4489_lanes * inverse_D12_p5_lanes - f13_z_p1_lanes * inverse_D11_p7_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p6_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      minus_a12_y_p41_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_x = n11_x_p11_lanes[0] + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p10_lanes = n11_y_p9_lanes - 6e-04 * minus_a10_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p10_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * (minus_a12_y_p24_lanes - n10_x_p4_lanes);

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p17_lanes = n12_z_p16_lanes + (f13_x_p4339_lanes - f13_x_p4287_lanes) *
      inverse_D11_p3_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p10_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p11_lanes = 0.06060754126741261 * minus_a12_y_p37_lanes +
      0.0001499998887063 * f10_z_p1_lanes - detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * n10_x_p3_lanes + n10_x_p10_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p2_lanes = minus_wd9_y_p1_lanes + minus_wd9_y_lanes;
  const Lanes<2> n9_x_p3_lanes = w9_y_lanes * w9_y_lanes;
  const Lanes<2> n9_x_p4_lanes = w9_z_lanes * w9_z_lanes;
  const Lanes<2> n9_x_p5_lanes = minus_a12_y_p20_lanes + wd9_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p12_lanes = 0.00022920000000000001 * wd11_z_lanes - 9.600000000000003e-06 *
      wd13_x_p1_lanes + 0.000144 * a12_z_p3_lanes - n11_z_p6_lanes;

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p17_lanes[0] + f13_x_p4487 - n12_z_p11_lanes[0];
  tau[11] = n12_z;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p8_lanes = 0.00028099984685315 * f10_z_p1_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * minus_a12_y_p33_lanes +
      0.0001499998887063 * minus_a12_y_p37_lanes;
  const Lanes<2> n10_x_p12_lanes = n10_x_p11_lanes - 0.28049749700000004 * minus_a10_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4501 = f13_x_p4500 - f13_x_p2111_lanes[5] * f13_x_p4485 - f13_x_p2111_lanes[6] *
      f13_x_p4483 - f13_x_p2111_lanes[7] * f13_x_p4481 - f13_x_p3418_lanes[0] * f13_x_p4480;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p4_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * wd10_y_p4_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p14_lanes = n11_z_p12_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (f11_x_p1_lanes - f11_y_p2_lanes) - n11_z_p10_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p10_lanes = detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * (minus_a12_y_p31_lanes - minus_a12_y_p24_lanes) - n10_y_p8_lanes +
      0.0014999985000000002 * minus_a10_z_lanes;
  const Lanes<2> n10_z_p10_lanes = 0.0014999985000000002 * minus_a10_y_lanes + 0.28049749700000004 *
      a10_x_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p11_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (n9_x_p4_lanes - n9_x_p3_lanes);

  // link 12 (left_wrist2), inward
  const Real n11_z = n11_z_p14_lanes[0] - (s12 * n12_x + c12 * n12_y);
  tau[10] = n11_z;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p12_lanes = 0.06032654142055946 * minus_a12_y_p29_lanes +
      0.060888541114265754 * wd10_z_lanes - detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * minus_a12_y_p34_lanes - n10_z_p4_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p13_lanes = 0.0019585440854647937 * minus_a12_y_p28_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p2_lanes -
      0.0005895000784280001 * n9_x_p5_lanes + n9_x_p11_lanes;

  // link 11 (left_wrist1), inward
  const Real n10_y = n10_y_p10_lanes[0] - n11_z;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_z_p3_lanes = 6e-04 * n11_x_p2_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * wd13_x_p7_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_x_p4_lanes = 0.0014999985000000002 * (n10_x_p4_lanes + minus_a12_y_p24_lanes) +
      0.28049749700000004 * minus_a12_y_p33_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_x = f13_x_p4501 - f13_x_p3418_lanes[1] * f13_x_p4479 - f13_x_p3418_lanes[2] *
      f13_x_p4478 - f13_x_p3418_lanes[3] * f13_x_p4477 - f13_x_p4492_lanes[0];

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_y_p3_lanes = 0.0014999985000000002 * n10_x_p3_lanes - 0.28049749700000004 *
      minus_a12_y_p35_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_y_p4_lanes = w9_x_lanes * w9_x_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p14_lanes = n9_x_p13_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_x_lanes;

  // link 13 (left_hand), inward
  const Real f12_y = f12_y_p5_lanes[0] + f13_x;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p14_lanes = n10_z_p12_lanes + 0.0001499998887063 *
      (n10_x_p4_lanes - minus_a12_y_p31_lanes) - n10_z_p10_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p4_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      minus_a12_y_p16_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p9_lanes = 0.0005895000784280001 * (n9_y_p4_lanes - n9_x_p4_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p5_lanes = w8_x_lanes * w8_x_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_y_p11 = s12 * f12_y - c12 * f12_x;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p10_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * minus_a12_y_p23_lanes - 0.0008177492704690715 * n9_x_p2_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) *
      minus_a12_y_p28_lanes + n9_y_p9_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p1_lanes = wd7_x_p2_lanes + wd7_x_lanes;

  // link 12 (left_wrist2), inward
  const Real f11_x = f11_x_p6_lanes[0] - n11_y_p11;
  const Real f11_z = f11_z_p3_lanes[0] - (s12 * f12_x + c12 * f12_y);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p3_lanes = w7_y_lanes * w7_y_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p11_lanes = n9_y_p10_lanes - 0.0022500062 * a8_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p4_lanes = w7_z_lanes * w7_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p12_lanes = 0.18101044219699997 * minus_a12_y_p11_lanes +
      0.18125194219699997 * wd8_z_lanes + 0.00010499999999999999 * wd8_x_p4_lanes - n8_z_p4_lanes;
  const Lanes<2> n8_z_p13_lanes = 0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p7_lanes = 0.0017499999999999998 * minus_a7_z_lanes;

  // link 11 (left_wrist1), inward
  const Real f10_y = f10_y_p3_lanes[0] - f11_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p2_lanes = minus_a12_y_p11_lanes - wd8_z_lanes;
  const Lanes<2> n8_y_p3_lanes = wd8_x_p2_lanes + wd8_x_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_y = n11_y_p10_lanes[0] + (n12_z + 0.269 * n11_y_p11);

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p10_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p4_lanes - n7_x_p3_lanes);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p8_lanes = 0.00010499999999999999 * (n8_z_p5_lanes - a10_x_p1_lanes);

  // link 11 (left_wrist1), inward
  const Real f10_x = c11 * f11_x - s11 * f11_y - f10_x_p4_lanes[0];

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p6_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * a10_x_p7_lanes;

  // link 11 (left_wrist1), inward
  const Real f10_z = f10_z_p4_lanes[0] + (s11 * f11_x + c11 * f11_y);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p15_lanes = n8_z_p12_lanes + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (a10_x_p2_lanes - n8_z_p5_lanes) - n8_z_p13_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p8_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p1_lanes = minus_a12_y_p3_lanes - wd7_z_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p12_lanes = 0.0001505 * n7_x_p1_lanes + 8.75e-06 * minus_a12_y_p12_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) *
      minus_a12_y_p7_lanes + n7_x_p10_lanes;

  // link 11 (left_wrist1), inward
  const Real n10_x = n10_x_p12_lanes[0] + (c11 * n11_x - s11 * n11_y);

  // link 10 (left_lowerarm), inward
  const Real n9_y_p12 = s10 * f10_y - c10 * f10_x;

  // link 11 (left_wrist1), inward
  const Real n10_z = n10_z_p14_lanes[0] + (s11 * n11_x + c11 * n11_y);
  tau[9] = n10_z;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p7_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (a10_x_p1_lanes - a10_x_p2_lanes);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p3_lanes = w7_x_lanes * w7_x_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p11_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n8_y_p2_lanes -
      0.18113119219699997 * minus_a12_y_p18_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * n8_y_p3_lanes + n8_y_p8_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p13_lanes = n7_x_p12_lanes + n7_x_p7_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p12_lanes = 0.0027762933559338653 * wd9_z_lanes - 0.001140794814995722 *
      minus_a12_y_p20_lanes + 0.0005895000784280001 * minus_a12_y_p25_lanes + n9_z_p6_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p12_lanes = n8_y_p11_lanes - 0.7139200499999999 * a7_x_lanes;
  const Lanes<2> n8_x_p9_lanes = 0.00012075 * n8_y_p3_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) *
      minus_a12_y_p18_lanes - 0.00010499999999999999 * minus_a12_y_p15_lanes + n8_x_p7_lanes;
  const Lanes<2> f7_x_p4_lanes = 0.7139200499999999 * minus_a12_y_p18_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * n8_y_p3_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p8_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_y_p3_lanes - n7_x_p4_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p14_lanes = n9_z_p12_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) *
      (n9_x_p3_lanes - n9_y_p4_lanes) + n9_z_p8_lanes;
  const Lanes<2> f9_x_p4_lanes = 0.0022500062 * (n9_x_p3_lanes + n9_x_p4_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * minus_a12_y_p23_lanes;

  // link 10 (left_lowerarm), inward
  const Real n9_y = n9_y_p11_lanes[0] + (n10_z + 0.282 * n9_y_p12);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p10_lanes = n8_x_p9_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_y_p4_lanes = 0.0022500062 * n9_x_p5_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (n9_y_p4_lanes + n9_x_p4_lanes);

  // link 10 (left_lowerarm), inward
  const Real f9_x = f9_x_p4_lanes[0] - n9_y_p12;
  const Real n9_x = n9_x_p14_lanes[0] + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));
  const Real n9_z = n9_z_p14_lanes[0] - (s10 * n10_x + c10 * n10_y);
  tau[8] = n9_z;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p10_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * n7_y_p1_lanes - 0.0002975 * minus_a12_y_p12_lanes - 8.75e-06 *
      n7_x_p1_lanes + n7_y_p8_lanes;

  // link 10 (left_lowerarm), inward
  const Real f9_y = f10_z - f9_y_p4_lanes[0];

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_z_p3_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      minus_a12_y_p28_lanes - 0.0022500062 * n9_x_p2_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f20_x = f13_x_p4483 - f13_x_p4492_lanes[1];

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_y_p4_lanes = 0.7139200499999999 * minus_a12_y_p15_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (n8_z_p5_lanes + a10_x_p1_lanes);
  const Lanes<2> f8_x_p3_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p2_lanes - 0.7139200499999999 * a10_x_p3_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f20_z = f13_z_p5_lanes[1] + f13_x_p4480;

  // link 10 (left_lowerarm), inward
  const Real f9_z = f9_z_p3_lanes[0] - (s10 * f10_x + c10 * f10_y);

  // link 24 (right_eye), inertial wrench
  const Real f20_y = f13_y_p4_lanes[1] + f13_x_p4481;

  // link 20 (right_hand), inward
  const Real f19_y = f12_y_p5_lanes[1] + f20_x;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_p6_lanes = 0.0017499999999999998 *
      (n7_x_p3_lanes + n7_x_p4_lanes + n7_y_p1_lanes);

  // link 9 (left_upperarm), inward
  const Real n8_x = n8_x_p10_lanes[0] - n9_z;

  // link 20 (right_hand), inward
  const Real f19_x = f20_z - f12_x_p5_lanes[1];

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_p3_lanes = 0.0017499999999999998 *
      (minus_a12_y_p7_lanes + (n7_y_p3_lanes + n7_x_p4_lanes));

  // link 24 (right_eye), inertial wrench
  const Real n20_x = n13_x_p10_lanes[1] + f13_x_p4479;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p11_lanes = n7_y_p10_lanes + n7_x_p7_lanes;

  // link 20 (right_hand), inward
  const Real f19_z = f12_z_p4_lanes[1] + f20_y;

  // link 24 (right_eye), inertial wrench
  const Real n20_z = n13_z_p15_lanes[1] + f13_x_p4477;
  tau[19] = n20_z;

  // link 9 (left_upperarm), inward
  const Real f8_x = f8_x_p3_lanes[0] - f9_z;

  // link 20 (right_hand), inward
  const Real n19_y = n20_x - n12_y_p5_lanes[1];
  const Real n19_x = n12_x_p5_lanes[1] + n20_z;

  // link 19 (right_wrist2), inward
  const Real f18_y = f11_y_p6_lanes[1] + f19_z;

  // link 9 (left_upperarm), inward
  const Real f8_y = f8_y_p4_lanes[0] + (s9 * f9_x + c9 * f9_y);
  const Real n8_y = n8_y_p12_lanes[0] + (s9 * n9_x + c9 * n9_y);

  // link 20 (right_hand), inward
  const Real n19_z = n12_z_p17_lanes[1] + f13_x_p4478 - n12_z_p11_lanes[1];
  tau[18] = n19_z;

  // link 9 (left_upperarm), inward
  const Real n8_z = n8_z_p15_lanes[0] + (c9 * n9_x - s9 * n9_y);
  tau[7] = n8_z;

  // link 19 (right_wrist2), inward
  const Real n18_y_p11 = s19 * f19_y - c19 * f19_x;

  // link 8 (left_shoulder2), inward
  const Real f7_x = f7_x_p4_lanes[0] + c9 * f9_x - s9 * f9_y - f7_x_p6_lanes[0];
  const Real n7_x = n7_x_p13_lanes[0] + n8_z;

  // link 19 (right_wrist2), inward
  const Real f18_x = f11_x_p6_lanes[1] - n18_y_p11;
  const Real n18_z = n11_z_p14_lanes[1] - (s19 * n19_x + c19 * n19_y);
  tau[17] = n18_z;

  // link 8 (left_shoulder2), inward
  const Real f7_y = c8 * f8_x - s8 * f8_y + f7_y_p3_lanes[0];
  const Real n7_y = n7_y_p11_lanes[0] + (c8 * n8_x - s8 * n8_y);

  // link 19 (right_wrist2), inward
  const Real n18_x = n11_x_p11_lanes[1] + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));
  const Real n18_y = n11_y_p10_lanes[1] + (n19_z + 0.269 * n18_y_p11);
  const Real f18_z = f11_z_p3_lanes[1] - (s19 * f19_x + c19 * f19_y);

  // link 18 (right_wrist1), inward
  const Real n17_y = n10_y_p10_lanes[1] - n18_z;
  const Real f17_x = c18 * f18_x - s18 * f18_y - f10_x_p4_lanes[1];
  const Real f17_y = f10_y_p3_lanes[1] - f18_z;
  const Real f17_z = f10_z_p4_lanes[1] + (s18 * f18_x + c18 * f18_y);

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = c7 * f7_x - s7 * f7_y;

  // link 17 (right_lowerarm), inward
  const Real f16_y = f17_z - f9_y_p4_lanes[1];

  // link 18 (right_wrist1), inward
  const Real n17_x = n10_x_p12_lanes[1] + (c18 * n18_x - s18 * n18_y);

  // link 17 (right_lowerarm), inward
  const Real n16_y_p12 = s17 * f17_y - c17 * f17_x;

  // link 18 (right_wrist1), inward
  const Real n17_z = n10_z_p14_lanes[1] + (s18 * n18_x + c18 * n18_y);
  tau[16] = n17_z;

  // link 17 (right_lowerarm), inward
  const Real f16_x = f9_x_p4_lanes[1] - n16_y_p12;
  const Real f16_z = f9_z_p3_lanes[1] - (s17 * f17_x + c17 * f17_y);

  // link 21 (neck), outward
  const Real wd21_z = qdd_0[20] - wd6_x;
  const Real w21_x = s21 * w6_y + c21 * w6_z;
  const Real w21_z = qd[20] - w6_x;

  // link 17 (right_lowerarm), inward
  const Real n16_y = n9_y_p11_lanes[1] + (n17_z + 0.282 * n16_y_p12);

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;

  // link 16 (right_upperarm), inward
  const Real f15_x = f8_x_p3_lanes[1] - f16_z;

  // link 17 (right_lowerarm), inward
  const Real n16_z = n9_z_p14_lanes[1] - (s17 * n17_x + c17 * n17_y);
  tau[15] = n16_z;
  const Real n16_x = n9_x_p14_lanes[1] + (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));

  // link 21 (neck), outward
  const Real wd22_y_p1 = s21 * a7_y_p6 - c21 * minus_a7_z_p2;
  const Real wd22_y_p2 = w21_x * w21_y;

  // link 22 (head), outward
  const Real w22_z = w21_y + qd[21];

  // link 21 (neck), outward
  const Real minus_wd21_y_p1 = w21_x * w21_z;

  // link 16 (right_upperarm), inward
  const Real f15_y = f8_y_p4_lanes[1] + (s16 * f16_x + c16 * f16_y);

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;

  // link 16 (right_upperarm), inward
  const Real n15_x = n8_x_p10_lanes[1] - n16_z;

  // link 21 (neck), outward
  const Real wd22_y_p3 = wd22_y_p2 - wd21_z;
  const Real minus_wd21_y_p2 = s21 * minus_a7_z_p2 + c21 * a7_y_p6;

  // link 22 (head), outward
  const Real w22_x = c22 * w21_x - s22 * w21_z;

  // link 23 (left_eye), outward
  const Lanes<2> w23_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);

  // link 21 (neck), outward
  const Real minus_wd21_y = minus_wd21_y_p2 + minus_wd21_y_p1;
  const Real wd22_y_p4 = 2.0 * (w21_y * w21_z) - wd22_y_p1;

  // link 16 (right_upperarm), inward
  const Real n15_y = n8_y_p12_lanes[1] + (s16 * n16_x + c16 * n16_y);

  // link 15 (right_shoulder2), inward
  const Real f14_x = f7_x_p4_lanes[1] + c16 * f16_x - s16 * f16_y - f7_x_p6_lanes[1];

  // link 22 (head), outward
  const Real wd22_y_p5 = w22_x * w22_z;
  const Real n23_y_p1 = w22_x * minus_w22_y;
  const Real wd22_z = qdd_0[21] - minus_wd21_y;

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p2_lanes = 2.0 * w23_z_lanes;

  // link 16 (right_upperarm), inward
  const Real n15_z = n8_z_p15_lanes[1] + (c16 * n16_x - s16 * n16_y);
  tau[14] = n15_z;

  // link 23 (left_eye), outward
  const Lanes<2> w23_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;
  const Lanes<2> w23_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;

  // link 22 (head), outward
  const Real n23_y_p3 = n23_y_p1 + wd22_z;
  const Real minus_a23_z_p1 = wd22_z - n23_y_p1;
  const Real wd22_y_p6 = c22 * wd22_y_p3 - s22 * wd22_y_p4;
  const Real a22_y_p1 = a6_x + 0.394 * a7_y_p3;
  const Real n23_y_p4 = s22 * wd22_y_p3 + c22 * wd22_y_p4;

  // link 15 (right_shoulder2), inward
  const Real f14_y = c15 * f15_x - s15 * f15_y + f7_y_p3_lanes[1];

  // link 23 (left_eye), outward
  const Lanes<2> f23_y_p1_lanes = w23_x_lanes * w23_y_lanes;
  const Lanes<2> n23_y_p5_lanes = w23_z_lanes * w23_z_lanes;

  // link 22 (head), outward
  const Real a22_y_p2 = a21_x - 0.394 * minus_wd21_y_p2;
  const Real wd22_y = wd22_y_p6 - wd22_y_p5;
  const Real n23_y_p9 = n23_y_p4 - 2.0 * (minus_w22_y * w22_z);

  // link 15 (right_shoulder2), inward
  const Real n14_x = n7_x_p13_lanes[1] + n15_z;

  // link 22 (head), outward
  const Real a23_y_p1 = wd22_y_p5 - wd22_y;

  // link 23 (left_eye), outward
  const Lanes<2> wd23_z_lanes = detail::make_pack<Real>(qdd_0[22], qdd_0[23]) - wd22_y;

  // link 21 (neck), outward
  const Real a23_y_p2 = w21_x * w21_x;
  const Real a23_y_p3 = w21_z * w21_z;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;

  // link 15 (right_shoulder2), inward
  const Real n14_y = n7_y_p11_lanes[1] + (c15 * n15_x - s15 * n15_y);

  // link 22 (head), outward
  const Real a23_y_p4 = minus_w22_y * minus_w22_y;
  const Real a23_y_p5 = w22_z * w22_z;
  const Real a22_y = c22 * a22_y_p1 - s22 * a22_y_p2;

  // link 23 (left_eye), outward
  const Lanes<2> f23_y_p2_lanes = f23_y_p1_lanes + wd23_z_lanes;

  // link 21 (neck), outward
  const Real a23_y_p7 = a23_y_p2 + a23_y_p3;

  // link 22 (head), outward
  const Real a22_z = 0.394 * wd22_y_p1 - minus_a21_y;

  // link 23 (left_eye), outward
  const Lanes<2> n23_x_p4_lanes = detail::make_pack<Real>(s23, s24) * n23_y_p3 +
      detail::make_pack<Real>(c23, c24) * n23_y_p9;

  // link 22 (head), outward
  const Real a23_y_p8 = a23_y_p4 + a23_y_p5;
  const Real a22_x = c22 * a22_y_p2 + s22 * a22_y_p1;

  // link 24 (right_eye), outward
  const Real minus_a23_z_p3 = a22_y + 0.095 * minus_a23_z_p1;

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p14_lanes = n23_y_p2_lanes * w23_x_lanes -
      (detail::make_pack<Real>(c23, c24) * n23_y_p3 - detail::make_pack<Real>(s23, s24) * n23_y_p9);

  // link 24 (right_eye), outward
  const Real a23_y_p10 = a22_z + 0.095 * a23_y_p1;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> f23_y_lanes = 0.00025 * f23_y_p2_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_z_lanes = minus_a23_z_p3 - detail::make_pack<Real>(0.032, (-0.032)) *
      n23_y_p4;

  // link 14 (right_shoulder1), inward
  const Real n6_x_p2 = c14 * f14_x - s14 * f14_y;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_p16_lanes = 0.00025 * minus_a23_z_lanes;

  // link 24 (right_eye), outward
  const Real a23_y_p12 = a22_x - 0.095 * a23_y_p8;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_x_lanes = 4e-06 * (n23_x_p4_lanes + n23_y_p2_lanes * w23_y_lanes) -
      2.8750000000000004e-05 * f23_y_p2_lanes;
  const Lanes<2> minus_f23_x_lanes = 0.00025 * (w23_y_lanes * w23_y_lanes + n23_y_p5_lanes);
  const Lanes<2> n23_y_lanes = 2.8750000000000004e-05 *
      (w23_x_lanes * w23_x_lanes - n23_y_p5_lanes) - 5.25e-06 * n23_y_p14_lanes + n23_y_p16_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p4_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * minus_a12_y_p8_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_p15_lanes = detail::make_pack<Real>(s23, s24) *
      (a23_y_p12 + detail::make_pack<Real>(0.032, (-0.032)) * wd22_y_p6);
  const Lanes<2> a23_y_lanes = detail::make_pack<Real>(c23, c24) *
      (a23_y_p10 - detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p7) - a23_y_p15_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p9_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_y_lanes;
  const Lanes<2> n22_y_p11_lanes = detail::make_pack<Real>(c23, c24) * f23_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_x_lanes;

  // link 21 (neck), outward
  const Real n21_x_p1 = wd22_y_p2 + wd21_z;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p10_lanes = 0.0017499999999999998 * (a7_y_lanes + a7_x_lanes);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_p6_lanes = 0.00025 * a23_y_lanes;

  // link 23 (left_eye), inward
  const Real n22_y_p13 = n22_y_p11_lanes[1] + n22_y_p11_lanes[0];
  const Lanes<2> n22_x_p9_lanes = detail::make_pack<Real>(c23, c24) * n23_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_y_lanes + detail::make_pack<Real>(8e-06, (-8e-06)) *
      n23_y_p14_lanes;

  // link 22 (head), outward
  const Real n22_z_p1 = w22_x * w22_x;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p11_lanes = 0.00014700000000000002 * minus_a12_y_p3_lanes + 0.000448 *
      wd7_z_lanes + detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) *
      wd7_x_p4_lanes - n7_z_p4_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_lanes = 1.2499999999999999e-06 * f23_y_p1_lanes + 9.25e-06 * wd23_z_lanes -
      2.8750000000000004e-05 * n23_x_p4_lanes + n23_z_p6_lanes;
  tau[22] = n23_z_lanes[0];

  // link 24 (right_eye), inertial wrench
  tau[23] = n23_z_lanes[1];

  // link 23 (left_eye), inward
  const Lanes<2> n22_z_p2_lanes = detail::make_pack<Real>(s23, s24) * n23_x_lanes;
  const Real f22_z = 0.072575 * a23_y_p1 - 0.43200000000000005 * n23_y_p9 + n22_y_p13;
  const Lanes<2> n22_z_p4_lanes = detail::make_pack<Real>(c23, c24) * n23_y_lanes;
  const Real f22_y_p1 = n23_y_p14_lanes[1] + n23_y_p14_lanes[0];

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p12_lanes = n7_z_p11_lanes + 8.75e-06 * (n7_x_p3_lanes - n7_y_p3_lanes);

  // link 23 (left_eye), inward
  const Real n22_x = 0.05450270000000001 * n23_y_p9 - 0.0074 * a23_y_p1 - 0.43200000000000005 *
      a22_z + n22_x_p9_lanes[1] + n22_x_p9_lanes[0];
  const Real n22_y_p14 = 0.0074 * n23_y_p9 - 0.009438624999999999 * a23_y_p1 - 0.072575 * a22_z -
      n23_z_lanes[1] - (-0.032) * n22_y_p9_lanes[1];

  // link 21 (neck), outward
  const Real n21_y_p1 = minus_wd21_y_p1 + minus_wd21_y;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = n6_x_p2 + n6_x_p1;

  // link 15 (right_shoulder2), inward
  const Real n14_z = n7_z_p12_lanes[1] + s15 * n15_x + c15 * n15_y + n7_z_p10_lanes[1];
  tau[13] = n14_z;

  // link 23 (left_eye), inward
  const Real n22_z_p6 = 0.04506407500000001 * n23_y_p1 + 0.06394132500000001 * wd22_z - 0.0074 *
      (a23_y_p4 - n22_z_p1) + 0.072575 * a22_y;
  const Real f22_y = 0.072575 * minus_a23_z_p1 + 0.43200000000000005 * (n22_z_p1 + a23_y_p5) -
      0.00025 * f22_y_p1;

  // link 8 (left_shoulder2), inward
  const Real n7_z = n7_z_p12_lanes[0] + s8 * n8_x + c8 * n8_y + n7_z_p10_lanes[0];
  tau[6] = n7_z;

  // link 23 (left_eye), inward
  const Real f22_x = 0.43200000000000005 * n23_y_p3 - 0.072575 * a23_y_p8 - n22_y_p9_lanes[1] -
      n22_y_p9_lanes[0];
  const Real n22_y = n22_y_p14 - n23_z_lanes[0] - 0.032 * n22_y_p9_lanes[0] - 0.095 * n22_y_p13;

  // link 22 (head), inward
  const Real n21_y_p2 = s22 * f22_y - c22 * f22_x;

  // link 14 (right_shoulder1), inward
  const Real n6_z_p1 = s14 * f14_x + c14 * f14_y;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_z_p2_lanes = 0.0017499999999999998 * (minus_a12_y_p12_lanes - n7_x_p1_lanes);

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * wd22_y_p4 - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p2 = s7 * f7_x + c7 * f7_y;

  // link 22 (head), inward
  const Real n21_z = 0.006216750000000001 * wd21_z - 0.0048105000000000005 * wd22_y_p2 + 0.0016155 *
      wd22_y_p1 - 0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;

  // link 23 (left_eye), inward
  const Real n22_z = n22_z_p6 + 0.43200000000000005 * a22_x + n22_z_p2_lanes[1] +
      n22_z_p4_lanes[1] + n22_z_p2_lanes[0] + n22_z_p4_lanes[0] - 2.375e-05 * f22_y_p1;
  tau[21] = n22_z;

  // link 8 (left_shoulder2), inward
  const Real f7_z = s8 * f8_x + c8 * f8_y + f7_z_p2_lanes[0];

  // link 15 (right_shoulder2), inward
  const Real f14_z = s15 * f15_x + c15 * f15_y + f7_z_p2_lanes[1];

  // link 7 (left_shoulder1), inward
  const Real n6_z_p3 = 1.26882463592404 * a7_y_p2 + 2.06965463592404 * wd6_z - 0.0187369177636143 *
      wd6_x_p5 + 6.1665928899999995 * minus_a6_y + c21 * n21_x;

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p1 - (s22 * f22_x + c22 * f22_y);

  // link 14 (right_shoulder1), inward
  const Real n6_x_p3 = 0.40041499999999997 * minus_a12_y_p4 + 0.0187369177636143 * minus_a7_z_p2 -
      n21_z + (s14 * n14_x + c14 * n14_y + (-0.18) * n6_x_p2);

  // link 7 (left_shoulder1), inward
  const Real f6_y_p1 = f14_z + f7_z;

  // link 22 (head), inward
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p2 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_y_p6 - 0.0187369177636143 *
      (minus_a7_z_p1 - a7_y_p1) + s21 * n21_x;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a23_y_p2 - a23_y_p3) - 0.000703125 * n21_y_p1 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p2);

  // link 7 (left_shoulder1), inward
  const Real n6_x = n6_x_p3 + (s7 * n7_x + c7 * n7_y + 0.18 * n6_x_p1);

  // link 4 (chest1), outward
  const Real n3_z_p1 = 2.0 * wd4_x;
  const Real n3_z_p2 = c4 * inverse_D3_p84;

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (w21_y * w21_y + a23_y_p3) + n21_y_p2;

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a7_y_p3 - f21_z + n6_z_p1 + n6_z_p2;

  // link 5 (chest2), outward
  const Real f5_x_p1 = minus_w5_y * minus_w5_y;

  // link 7 (left_shoulder1), inward
  const Real f6_y = f6_y_p1 - 6.1665928899999995 * minus_a7_z_p2 - s21 * minus_f21_x + c21 * f21_y;
  const Real f6_z = n6_y_p1 - 6.1665928899999995 * a7_y_p6 - c21 * minus_f21_x - s21 * f21_y;
  const Real n6_z_p4 = n6_z_p3 - s21 * n21_y + c14 * n14_x - s14 * n14_y - (-0.18) * n6_z_p1;
  const Real n6_y = n6_y_p2 + c21 * n21_y + n14_z + n7_z + 0.226 * n6_y_p1;

  // link 4 (chest1), outward
  const Real f4_x_p1 = qd[3] * qd[3];

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real f5_x = 2.2194301519999997 * a6_z_p1 - 0.069699984375 * (f5_x_p1 + a6_x_p1) + f6_z;
  const Real f5_y = 0.069699984375 * wd6_x_p4 + 2.2194301519999997 * a6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_z = 0.069699984375 * wd6_x_p3 - 2.2194301519999997 * a6_x_p4 + n5_x_p1;
  const Real n5_y = 0.005678398088837119 * a6_x_p4 - 0.04675382692737882 * wd6_x_p3 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 5 (chest2), inertial wrench
  const Real n5_z_p1 = 0.10961925816937637 * wd6_x_p1 + 0.203126912024134 * wd5_z -
      0.005678398088837119 * (f5_x_p1 - a6_x_p2) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 7 (left_shoulder1), inward
  const Real n6_z = n6_z_p4 + c7 * n7_x - s7 * n7_y - 0.18 * n6_z_p2 - 0.226 * f6_y_p1;
  tau[5] = n6_z;

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p1 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);
  tau[4] = n5_z;
  const Real n5_x = 0.15637308509675518 * a6_x_p4 - 0.005678398088837119 * wd6_x_p3 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);
  const Real f2_x_p1 = 0.031999971599999996 * c2 + 24.5839218 * s2;

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * a5_y_p1 + n3_z_p1 * inverse_D2_p1 + s5 * f5_x + c5 * f5_y -
      inverse_D2_p5 * wd3_z;

  // link 5 (chest2), inward
  const Real f4_x_p2 = c4 * (s5 * f5_y - c5 * f5_x) + s4 * f5_z;
  const Real f4_x = (a5_y_p1 + f4_x_p1) * inverse_D2_p3 + qdd_0[3] * inverse_D2_p1 - f4_x_p2;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * a5_y_p1 + 8.419374554 * wd3_z + f4_x;
  const Real n3_z_p3 = 8.419374554 * a3_x + qdd_0[3] * inverse_D3_p77 + n3_z_p1 * n3_z_p2 - s4 *
      (s5 * n5_y - c5 * n5_x);

  // link 5 (chest2), inward
  const Real n4_z = 0.060169103246295166 * qdd_0[3] + wd3_z * inverse_D3_p77 - a5_y_p1 * n3_z_p2 +
      inverse_D2_p1 * a3_x - (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 3 (hip), inward
  const Real n2_z_p1 = inverse_D2_p9 * f3_x - inverse_D2_p7 * f3_y;
  const Real f2_x = n2_z_p1 - (a3_x_p1 * f2_x_p1 + wd2_z * inverse_D1_p1);

  // link 4 (chest1), inward
  const Real n3_z_p4 = n3_z_p3 - 0.21799999999999997 * f4_x_p2 +
      (0.005880002159562879 * f4_x_p1 + n5_z) * c4 - inverse_D2_p5 * a3_y;
  const Real n3_z = n3_z_p4 + (1.7947593951550056 + inverse_D3_p86) * wd3_z;
  tau[2] = n3_z;

  // link 3 (hip), inward
  const Real n2_z = 9.885744550888212 * wd2_z + (f2_x_p1 * a2_y - inverse_D1_p1 * a2_x) +
      (n3_z + (inverse_D2_p10 * (inverse_D2_p7 * f3_x + inverse_D2_p9 * f3_y) + inverse_D2_p8 *
      n2_z_p1));
  tau[1] = n2_z;

  // link 2 (thigh), inward
  const Real n1_z = 13.049859506913753 * qdd_0[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + 0.434 * f2_x);
  tau[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
