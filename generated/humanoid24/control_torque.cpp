// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins, alike limbs in lanes.
// 8497 flops (add 3741, mul 4712, div 44), sine and cosine of 24 angles
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

  // link 4 (chest1), articulated inertia
  const Real inverse_D2_p13 = inverse_D2_p5 + 0.21799999999999997 * inverse_D2_p6 - s4 *
      (inverse_D3_p83 - inverse_D3_p71) - inverse_D3_p91 * inverse_D2_p12;
  const Real inverse_D1_p1 = 0.031999971599999996 * s2 - 24.5839218 * c2;
  const Real inverse_D2_p14 = 8.419374554 + (inverse_D3_p92 - inverse_D3_p91 * inverse_D2_p11);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p7_lanes = inverse_D11_p5_lanes - inverse_D11_p14_lanes *
      inverse_D12_p7_lanes;
  const Lanes<2> f13_x_p9_lanes = -inverse_D10_p8_lanes - inverse_D10_p20_lanes *
      inverse_D12_p7_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 +
      (inverse_D3_p94 - inverse_D3_p91 * inverse_D3_p93));

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p17_lanes = inverse_D10_p19_lanes * inverse_D12_p7_lanes;
  const Lanes<2> f13_x_p21_lanes = inverse_D10_p7_lanes - inverse_D10_p18_lanes *
      inverse_D12_p7_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p25_lanes = -(detail::make_pack<Real>(c12, c19) * f13_x_p7_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p31_lanes = detail::make_pack<Real>(c12, c19) * inverse_D11_p14_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p43_lanes = 0.269 * f13_x_p9_lanes - detail::make_pack<Real>(s12, s19) *
      f13_x_p7_lanes - inverse_D10_p77_lanes * f13_x_p25_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p53_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p21_lanes -
      detail::make_pack<Real>(c12, c19) * f13_x_p17_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p57_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p14_lanes -
      0.269 * inverse_D10_p20_lanes - inverse_D10_p77_lanes * f13_x_p31_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p13 * inverse_D3;
  const Real inverse_D2_p16 = inverse_D2_p14 * inverse_D3;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> neg_c12_lanes = -detail::make_pack<Real>(c12, c19);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p61_lanes = detail::make_pack<Real>(c12, c19) * inverse_D10_p19_lanes +
      detail::make_pack<Real>(s12, s19) * inverse_D10_p18_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> neg_s12_lanes = -detail::make_pack<Real>(s12, s19);
  const Lanes<2> f13_x_p65_lanes = inverse_D10_p78_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p71_lanes = neg_s12_lanes - inverse_D10_p77_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p75_lanes = 0.269 * f13_x_p53_lanes - inverse_D10_p78_lanes *
      f13_x_p25_lanes;
  const Lanes<2> f13_x_p91_lanes = -(0.269 * f13_x_p61_lanes) - inverse_D10_p78_lanes *
      f13_x_p31_lanes;
  const Lanes<2> f13_x_p95_lanes = -(0.269 * detail::make_pack<Real>(c12, c19));
  const Lanes<2> f13_x_p97_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p95_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p17 = inverse_D2_p14 * inverse_D2_p15 -
      (inverse_D2_p6 - inverse_D2_p2 * inverse_D2_p12);
  const Real inverse_D2_p18 = inverse_D3_p90 - inverse_D2_p2 * inverse_D2_p11 - inverse_D2_p14 *
      inverse_D2_p16;
  const Real inverse_D2_p19 = inverse_D3_p66 + inverse_D3_p81 - inverse_D2_p4 * inverse_D2_p12 -
      inverse_D2_p13 * inverse_D2_p15;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p105_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p71_lanes -
      detail::make_pack<Real>(c11, c18) * f13_x_p65_lanes;
  const Lanes<2> f13_x_p113_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p43_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p75_lanes;
  const Lanes<2> f13_x_p115_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p43_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p75_lanes;
  const Lanes<2> f13_x_p119_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p71_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p65_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p121_lanes = -(detail::make_pack<Real>(s11, s18) * f13_x_p95_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p125_lanes = -f13_x_p53_lanes + inverse_D8_p4_lanes * f13_x_p25_lanes;
  const Lanes<2> f13_x_p131_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p57_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p91_lanes;
  const Lanes<2> f13_x_p133_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p57_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p91_lanes;
  const Lanes<2> f13_x_p135_lanes = f13_x_p9_lanes - inverse_D8_p5_lanes * f13_x_p25_lanes;
  const Lanes<2> f13_x_p137_lanes = inverse_D8_p4_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p139_lanes = inverse_D8_p5_lanes * neg_c12_lanes;
  const Lanes<2> f13_x_p141_lanes = f13_x_p61_lanes + inverse_D8_p4_lanes * f13_x_p31_lanes;
  const Lanes<2> f13_x_p143_lanes = detail::make_pack<Real>(s11, s18) *
      detail::make_pack<Real>(c12, c19);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p151_lanes = inverse_D9_p7_lanes[1] *
      detail::make_pack<Real>(f13_x_p97_lanes[1], f13_x_p105_lanes[1], f13_x_p131_lanes[1],
      f13_x_p113_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1],
      f13_x_p97_lanes[1]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p159_lanes = -inverse_D10_p20_lanes - inverse_D8_p5_lanes * f13_x_p31_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p20 = inverse_D2_p7 * (inverse_D2_p18 - inverse_D2_p19) + inverse_D2_p9 *
      (2.0 * inverse_D2_p17);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p185_lanes = detail::make_pack<Real>(c11, c18) *
      detail::make_pack<Real>(c12, c19);
  const Lanes<2> f13_x_p199_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p125_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p135_lanes;
  const Lanes<2> f13_x_p201_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p125_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p135_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p21 = inverse_D2_p7 * inverse_D2_p20;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p209_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p137_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p139_lanes;
  const Lanes<2> f13_x_p211_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p137_lanes -
      detail::make_pack<Real>(c11, c18) * f13_x_p139_lanes;
  const Lanes<2> f13_x_p213_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p141_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p159_lanes;
  const Lanes<2> f13_x_p215_lanes = inverse_D8_p49_lanes * neg_c12_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> neg_neg_s12_lanes = -neg_s12_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p217_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p141_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p159_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p219_lanes = detail::make_pack<Real>(f13_x_p121_lanes[1],
      f13_x_p119_lanes[1], f13_x_p133_lanes[1], f13_x_p115_lanes[1], f13_x_p121_lanes[1],
      f13_x_p121_lanes[1], f13_x_p121_lanes[1], f13_x_p121_lanes[1]) - inverse_D9_p9_lanes[1] *
      detail::make_pack<Real>(f13_x_p97_lanes[1], f13_x_p105_lanes[1], f13_x_p131_lanes[1],
      f13_x_p113_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1],
      f13_x_p97_lanes[1]);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p22 = inverse_D2_p9 * inverse_D2_p20 - inverse_D2_p17;
  const Real inverse_D2_p23 = inverse_D2_p18 - inverse_D2_p21;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p235_lanes = detail::make_pack<Real>(f13_x_p185_lanes[1],
      f13_x_p209_lanes[1], f13_x_p213_lanes[1], f13_x_p201_lanes[1], f13_x_p185_lanes[1],
      f13_x_p185_lanes[1], f13_x_p185_lanes[1], f13_x_p185_lanes[1]) - inverse_D8_p46_lanes[1] *
      detail::make_pack<Real>(f13_x_p97_lanes[1], f13_x_p105_lanes[1], f13_x_p131_lanes[1],
      f13_x_p113_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1],
      f13_x_p97_lanes[1]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p249_lanes = -(detail::make_pack<Real>(s12, s19) * f13_x_p17_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p21_lanes) - inverse_D8_p49_lanes * f13_x_p25_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p251_lanes = 0.00010499999999999999 / inverse_D8_p163_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p253_lanes = detail::make_pack<Real>(f13_x_p143_lanes[1],
      f13_x_p211_lanes[1], f13_x_p217_lanes[1], f13_x_p199_lanes[1], f13_x_p143_lanes[1],
      f13_x_p143_lanes[1], f13_x_p143_lanes[1], f13_x_p143_lanes[1]) - inverse_D8_p34_lanes[1] *
      detail::make_pack<Real>(f13_x_p97_lanes[1], f13_x_p105_lanes[1], f13_x_p131_lanes[1],
      f13_x_p113_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1],
      f13_x_p97_lanes[1]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p263_lanes = -f13_x_p249_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p265_lanes = c17 * f13_x_p151_lanes - s17 * f13_x_p219_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p277_lanes = -(detail::make_pack<Real>(c12, c19) * inverse_D10_p18_lanes -
      detail::make_pack<Real>(s12, s19) * inverse_D10_p19_lanes - inverse_D8_p49_lanes *
      f13_x_p31_lanes);

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p24 = inverse_D2_p8 * inverse_D2_p23 + inverse_D2_p10 * inverse_D2_p22;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p279_lanes = detail::make_pack<Real>(neg_neg_s12_lanes[1],
      f13_x_p215_lanes[1], f13_x_p277_lanes[1], f13_x_p263_lanes[1], neg_neg_s12_lanes[1],
      neg_neg_s12_lanes[1], neg_neg_s12_lanes[1], neg_neg_s12_lanes[1]) - inverse_D8_p105_lanes[1] *
      detail::make_pack<Real>(f13_x_p97_lanes[1], f13_x_p105_lanes[1], f13_x_p131_lanes[1],
      f13_x_p113_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1],
      f13_x_p97_lanes[1]);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p283_lanes = inverse_D8_p125_lanes[1] * f13_x_p265_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p2 = inverse_D2_p24 - inverse_D1_p1;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p319_lanes = c17 * f13_x_p219_lanes + s17 * f13_x_p151_lanes + 0.282 *
      f13_x_p253_lanes - f13_x_p283_lanes;
  const Lanes<8> f13_x_p323_lanes = f13_x_p253_lanes - inverse_D6_p29_lanes[1] * f13_x_p265_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p327_lanes = s17 * f13_x_p279_lanes - c17 * f13_x_p235_lanes;

  // link 3 (hip), articulated inertia
  const Real inverse_D2_p25 = 9.885744550888212 + (inverse_D2_p10 *
      (inverse_D2_p8 * inverse_D2_p22 + inverse_D2_p10 * (inverse_D2_p19 + inverse_D2_p21)) +
      inverse_D2_p8 * inverse_D2_p24);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p359_lanes = -f13_x_p327_lanes + inverse_D6_p27_lanes[1] * f13_x_p265_lanes;
  const Lanes<8> f13_x_p367_lanes = -(s17 * f13_x_p235_lanes + c17 * f13_x_p279_lanes) +
      inverse_D6_p19_lanes[1] * f13_x_p265_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / inverse_D2_p25;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p379_lanes = 0.282 * f13_x_p327_lanes - inverse_D8_p151_lanes[1] *
      f13_x_p265_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p399_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p20_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p405_lanes = c16 * f13_x_p319_lanes - s16 * f13_x_p379_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p417_lanes = f13_x_p251_lanes[1] * f13_x_p405_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p3 = inverse_D1_p2 * inverse_D2;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p433_lanes = s16 * f13_x_p319_lanes + c16 * f13_x_p379_lanes -
      inverse_D7_p8_lanes[1] * f13_x_p405_lanes;
  const Lanes<8> f13_x_p441_lanes = s16 * f13_x_p359_lanes + c16 * f13_x_p323_lanes -
      inverse_D6_p99_lanes[1] * f13_x_p405_lanes;
  const Lanes<8> f13_x_p445_lanes = -f13_x_p367_lanes + inverse_D6_p97_lanes[1] * f13_x_p405_lanes;
  const Lanes<8> f13_x_p481_lanes = s15 * f13_x_p417_lanes + c15 * f13_x_p433_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p497_lanes = inverse_D6_p267_lanes[1] * f13_x_p481_lanes;
  const Lanes<8> f13_x_p513_lanes = f13_x_p399_lanes[1] * f13_x_p481_lanes;
  const Lanes<8> f13_x_p517_lanes = c16 * f13_x_p359_lanes - s16 * f13_x_p323_lanes -
      inverse_D6_p101_lanes[1] * f13_x_p405_lanes - f13_x_p497_lanes;
  const Lanes<8> f13_x_p521_lanes = c15 * f13_x_p445_lanes - s15 * f13_x_p441_lanes -
      inverse_D6_p265_lanes[1] * f13_x_p481_lanes;
  const Lanes<8> f13_x_p525_lanes = s15 * f13_x_p445_lanes + c15 * f13_x_p441_lanes -
      inverse_D6_p271_lanes[1] * f13_x_p481_lanes;
  const Lanes<8> f13_x_p529_lanes = c15 * f13_x_p417_lanes - s15 * f13_x_p433_lanes -
      inverse_D6_p370_lanes[1] * f13_x_p481_lanes;
  const Lanes<8> f13_x_p569_lanes = s14 * f13_x_p517_lanes + c14 * f13_x_p521_lanes;
  const Lanes<8> f13_x_p577_lanes = c14 * f13_x_p517_lanes - s14 * f13_x_p521_lanes;
  const Lanes<8> f13_x_p597_lanes = 0.226 * f13_x_p525_lanes + (-0.18) * f13_x_p569_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p609_lanes = -(c14 * f13_x_p513_lanes + s14 * f13_x_p529_lanes +
      f13_x_p597_lanes);
  const Lanes<8> f13_x_p613_lanes = inverse_D5_p54 * f13_x_p609_lanes;
  const Lanes<8> f13_x_p633_lanes = (-0.18) * f13_x_p577_lanes -
      (s14 * f13_x_p513_lanes - c14 * f13_x_p529_lanes) - f13_x_p613_lanes;
  const Lanes<8> f13_x_p637_lanes = 0.226 * f13_x_p577_lanes - inverse_D5_p57 * f13_x_p609_lanes;
  const Lanes<8> f13_x_p641_lanes = f13_x_p577_lanes - inverse_D5_p52 * f13_x_p609_lanes;
  const Lanes<8> f13_x_p645_lanes = f13_x_p569_lanes + inverse_D3_p34 * f13_x_p609_lanes;
  const Lanes<8> f13_x_p649_lanes = f13_x_p525_lanes - inverse_D3_p35 * f13_x_p609_lanes;
  const Lanes<8> f13_x_p697_lanes = s6 * f13_x_p645_lanes + c6 * f13_x_p649_lanes;
  const Lanes<8> f13_x_p705_lanes = s6 * f13_x_p633_lanes + c6 * f13_x_p637_lanes + 0.072 *
      f13_x_p641_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p737_lanes = c6 * f13_x_p645_lanes - s6 * f13_x_p649_lanes - inverse_D3_p63 *
      f13_x_p705_lanes;
  const Lanes<8> f13_x_p741_lanes = f13_x_p641_lanes - inverse_D3_p62 * f13_x_p705_lanes;
  const Lanes<8> f13_x_p745_lanes = c6 * f13_x_p633_lanes - s6 * f13_x_p637_lanes - inverse_D4_p2 *
      f13_x_p705_lanes;
  const Lanes<8> f13_x_p749_lanes = -(0.072 * f13_x_p697_lanes) + inverse_D4_p1 * f13_x_p705_lanes;
  const Lanes<8> f13_x_p773_lanes = s4 * (f13_x_p697_lanes - inverse_D3_p64 * f13_x_p705_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p797_lanes = 0.269 * detail::make_pack<Real>(s11, s18);
  const Lanes<2> f13_x_p803_lanes = 0.269 * detail::make_pack<Real>(c11, c18);

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p821 = inverse_D9_p7_lanes[1] * f13_x_p797_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p822_lanes = -(s5 * f13_x_p749_lanes + c5 * f13_x_p745_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p842_lanes = c4 * (s5 * f13_x_p737_lanes - c5 * f13_x_p741_lanes) +
      f13_x_p773_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p846 = f13_x_p803_lanes[1] - inverse_D9_p9_lanes[1] * f13_x_p797_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p849_lanes = inverse_D8_p105_lanes * f13_x_p797_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p851 = c18 - inverse_D8_p34_lanes[1] * f13_x_p797_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p852_lanes = -(s5 * f13_x_p741_lanes + c5 * f13_x_p737_lanes) -
      inverse_D2_p12 * f13_x_p822_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p868_lanes = -detail::make_pack<Real>(s11, s18) - inverse_D8_p46_lanes *
      f13_x_p797_lanes;

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D2_p23 - inverse_D1_p2 * inverse_D1_p3));

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p876_lanes = s4 * (s5 * f13_x_p745_lanes - c5 * f13_x_p749_lanes) +
      0.21799999999999997 * f13_x_p842_lanes;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p882 = c17 * f13_x_p821 - s17 * f13_x_p846;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p883_lanes = 0.269 * detail::make_pack<Real>(s12, s19);

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p889_lanes = -f13_x_p876_lanes - inverse_D3_p93 * f13_x_p822_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p893_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p883_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p897_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p868_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p849_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p909 = c17 * f13_x_p846 + s17 * f13_x_p821 + 0.282 * f13_x_p851 -
      inverse_D8_p125_lanes[1] * f13_x_p882;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p910 = inverse_D9_p7_lanes[1] * f13_x_p893_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p911_lanes = -(detail::make_pack<Real>(s11, s18) * f13_x_p883_lanes);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p913_lanes = detail::make_pack<Real>(s11, s18) * neg_s12_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p915_lanes = -f13_x_p842_lanes - inverse_D2_p11 * f13_x_p822_lanes -
      inverse_D2_p16 * f13_x_p889_lanes;
  const Lanes<8> f13_x_p919_lanes = -f13_x_p852_lanes + inverse_D2_p15 * f13_x_p889_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p923_lanes = detail::make_pack<Real>(c11, c18) * neg_s12_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<2> f13_x_p925_lanes = -(0.282 * f13_x_p897_lanes);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> neg_neg_c12_lanes = -neg_c12_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p927 = f13_x_p925_lanes[1] - inverse_D8_p151_lanes[1] * f13_x_p882;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p928 = f13_x_p911_lanes[1] - inverse_D9_p9_lanes[1] * f13_x_p893_lanes[1];
  const Real f13_x_p929 = f13_x_p913_lanes[1] - inverse_D8_p34_lanes[1] * f13_x_p893_lanes[1];
  const Real f13_x_p946 = f13_x_p923_lanes[1] - inverse_D8_p46_lanes[1] * f13_x_p893_lanes[1];
  const Real f13_x_p947 = neg_neg_c12_lanes[1] - inverse_D8_p105_lanes[1] * f13_x_p893_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p958_lanes = inverse_D9_p7_lanes[0] *
      detail::make_pack<Real>(f13_x_p893_lanes[0], f13_x_p797_lanes[0], f13_x_p97_lanes[0],
      f13_x_p105_lanes[0], f13_x_p131_lanes[0], f13_x_p113_lanes[0], f13_x_p893_lanes[0],
      f13_x_p893_lanes[0]);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p964_lanes = inverse_D2_p9 * f13_x_p915_lanes - inverse_D2_p7 *
      f13_x_p919_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p968 = c16 * f13_x_p909 - s16 * f13_x_p927;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p969 = c17 * f13_x_p910 - s17 * f13_x_p928;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p976_lanes = detail::make_pack<Real>(f13_x_p911_lanes[0],
      f13_x_p803_lanes[0], f13_x_p121_lanes[0], f13_x_p119_lanes[0], f13_x_p133_lanes[0],
      f13_x_p115_lanes[0], f13_x_p911_lanes[0], f13_x_p911_lanes[0]) - inverse_D9_p9_lanes[0] *
      detail::make_pack<Real>(f13_x_p893_lanes[0], f13_x_p797_lanes[0], f13_x_p97_lanes[0],
      f13_x_p105_lanes[0], f13_x_p131_lanes[0], f13_x_p113_lanes[0], f13_x_p893_lanes[0],
      f13_x_p893_lanes[0]);

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1007 = s17 * f13_x_p947 - c17 * f13_x_p946;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1025_lanes = detail::make_pack<Real>(f13_x_p913_lanes[0], c11,
      f13_x_p143_lanes[0], f13_x_p211_lanes[0], f13_x_p217_lanes[0], f13_x_p199_lanes[0],
      f13_x_p913_lanes[0], f13_x_p913_lanes[0]) - inverse_D8_p34_lanes[0] *
      detail::make_pack<Real>(f13_x_p893_lanes[0], f13_x_p797_lanes[0], f13_x_p97_lanes[0],
      f13_x_p105_lanes[0], f13_x_p131_lanes[0], f13_x_p113_lanes[0], f13_x_p893_lanes[0],
      f13_x_p893_lanes[0]);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1031 = f13_x_p251_lanes[1] * f13_x_p968;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1032_lanes = inverse_D2_p10 *
      (inverse_D2_p7 * f13_x_p915_lanes + inverse_D2_p9 * f13_x_p919_lanes) + inverse_D2_p8 *
      f13_x_p964_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1036_lanes = detail::make_pack<Real>(f13_x_p923_lanes[0],
      f13_x_p923_lanes[0], f13_x_p185_lanes[0], f13_x_p209_lanes[0], f13_x_p213_lanes[0],
      f13_x_p201_lanes[0], f13_x_p923_lanes[0], f13_x_p923_lanes[0]) - inverse_D8_p46_lanes[0] *
      detail::make_pack<Real>(f13_x_p893_lanes[0], f13_x_p893_lanes[0], f13_x_p97_lanes[0],
      f13_x_p105_lanes[0], f13_x_p131_lanes[0], f13_x_p113_lanes[0], f13_x_p893_lanes[0],
      f13_x_p893_lanes[0]);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1041 = s16 * f13_x_p909 + c16 * f13_x_p927 - inverse_D7_p8_lanes[1] *
      f13_x_p968;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1042_lanes = detail::make_pack<Real>(neg_neg_c12_lanes[0],
      neg_neg_c12_lanes[0], neg_neg_s12_lanes[0], f13_x_p215_lanes[0], f13_x_p277_lanes[0],
      f13_x_p263_lanes[0], neg_neg_c12_lanes[0], neg_neg_c12_lanes[0]) - inverse_D8_p105_lanes[0] *
      detail::make_pack<Real>(f13_x_p893_lanes[0], f13_x_p893_lanes[0], f13_x_p97_lanes[0],
      f13_x_p105_lanes[0], f13_x_p131_lanes[0], f13_x_p113_lanes[0], f13_x_p893_lanes[0],
      f13_x_p893_lanes[0]);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1053 = c17 * f13_x_p928 + s17 * f13_x_p910 + 0.282 * f13_x_p929 -
      inverse_D8_p125_lanes[1] * f13_x_p969;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1054_lanes = c10 * f13_x_p958_lanes - s10 * f13_x_p976_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1080 = 0.282 * f13_x_p1007 - inverse_D8_p151_lanes[1] * f13_x_p969;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1081_lanes = inverse_D8_p125_lanes[0] * f13_x_p1054_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1103 = f13_x_p897_lanes[1] + inverse_D6_p27_lanes[1] * f13_x_p882;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1104 = s15 * f13_x_p1031 + c15 * f13_x_p1041;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1105_lanes = s10 * f13_x_p1042_lanes - c10 * f13_x_p1036_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1116 = f13_x_p851 - inverse_D6_p29_lanes[1] * f13_x_p882;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1117_lanes = c10 * f13_x_p976_lanes + s10 * f13_x_p958_lanes + 0.282 *
      f13_x_p1025_lanes - f13_x_p1081_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1129 = -f13_x_p1007 + inverse_D6_p27_lanes[1] * f13_x_p969;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p1130_lanes = 0.434 * (f13_x_p964_lanes - inverse_D1_p3 * f13_x_p1032_lanes);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1134 = f13_x_p929 - inverse_D6_p29_lanes[1] * f13_x_p969;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1135_lanes = 0.282 * f13_x_p1105_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1140 = c16 * f13_x_p1053 - s16 * f13_x_p1080;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1141_lanes = -f13_x_p1105_lanes;
  const Lanes<8> f13_x_p1158_lanes = detail::make_pack<Real>(f13_x_p1141_lanes[0],
      f13_x_p897_lanes[0], f13_x_p1141_lanes[2], f13_x_p1141_lanes[3], f13_x_p1141_lanes[4],
      f13_x_p1141_lanes[5], f13_x_p1141_lanes[0], f13_x_p1141_lanes[0]) + inverse_D6_p27_lanes[0] *
      f13_x_p1054_lanes;
  const Lanes<8> f13_x_p1164_lanes = f13_x_p1025_lanes - inverse_D6_p29_lanes[0] *
      f13_x_p1054_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1174 = f13_x_p251_lanes[1] * f13_x_p1140;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1175_lanes = detail::make_pack<Real>(f13_x_p1135_lanes[0],
      f13_x_p925_lanes[0], f13_x_p1135_lanes[2], f13_x_p1135_lanes[3], f13_x_p1135_lanes[4],
      f13_x_p1135_lanes[5], f13_x_p1135_lanes[0], f13_x_p1135_lanes[0]) - inverse_D8_p151_lanes[0] *
      f13_x_p1054_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p1181_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p849_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p868_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1195 = s16 * f13_x_p1053 + c16 * f13_x_p1080 - inverse_D7_p8_lanes[1] *
      f13_x_p1140;
  const Real f13_x_p1208 = s16 * f13_x_p1103 + c16 * f13_x_p1116 - inverse_D6_p99_lanes[1] *
      f13_x_p968;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1232_lanes = c9 * f13_x_p1117_lanes - s9 * f13_x_p1175_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1249 = -(f13_x_p1181_lanes[1] + inverse_D6_p19_lanes[1] * f13_x_p882) +
      inverse_D6_p97_lanes[1] * f13_x_p968;
  const Real f13_x_p1250 = s16 * f13_x_p1129 + c16 * f13_x_p1134 - inverse_D6_p99_lanes[1] *
      f13_x_p1140;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1269_lanes = f13_x_p251_lanes[0] * f13_x_p1232_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1292 = s15 * f13_x_p1174 + c15 * f13_x_p1195;
  const Real f13_x_p1299 = -(-(s17 * f13_x_p946 + c17 * f13_x_p947) + inverse_D6_p19_lanes[1] *
      f13_x_p969) + inverse_D6_p97_lanes[1] * f13_x_p1140;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1300_lanes = s9 * f13_x_p1117_lanes + c9 * f13_x_p1175_lanes -
      inverse_D7_p8_lanes[0] * f13_x_p1232_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1306_lanes = -(s10 * f13_x_p1036_lanes + c10 * f13_x_p1042_lanes);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1323_lanes = s9 * f13_x_p1158_lanes + c9 * f13_x_p1164_lanes -
      inverse_D6_p99_lanes[0] * f13_x_p1232_lanes;
  const Lanes<8> f13_x_p1329_lanes = c9 * f13_x_p1158_lanes - s9 * f13_x_p1164_lanes -
      inverse_D6_p101_lanes[0] * f13_x_p1232_lanes;
  const Lanes<8> f13_x_p1353_lanes = -(detail::make_pack<Real>(f13_x_p1306_lanes[0],
      f13_x_p1181_lanes[0], f13_x_p1306_lanes[2], f13_x_p1306_lanes[3], f13_x_p1306_lanes[4],
      f13_x_p1306_lanes[5], f13_x_p1306_lanes[0], f13_x_p1306_lanes[0]) + inverse_D6_p19_lanes[0] *
      f13_x_p1054_lanes) + inverse_D6_p97_lanes[0] * f13_x_p1232_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p1377_lanes = f13_x_p1130_lanes * inverse_D1;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1393_lanes = s8 * f13_x_p1269_lanes + c8 * f13_x_p1300_lanes;
  const Lanes<8> f13_x_p1399_lanes = c8 * f13_x_p1269_lanes - s8 * f13_x_p1300_lanes;
  const Lanes<8> f13_x_p1421_lanes = c8 * f13_x_p1353_lanes - s8 * f13_x_p1323_lanes;
  const Lanes<8> f13_x_p1443_lanes = s8 * f13_x_p1353_lanes + c8 * f13_x_p1323_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1449_lanes = detail::make_pack<Real>(f13_x_p399_lanes[0],
      f13_x_p399_lanes[0], f13_x_p399_lanes[0], f13_x_p399_lanes[0], f13_x_p399_lanes[0],
      f13_x_p399_lanes[0], f13_x_p399_lanes[1], f13_x_p399_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[0], f13_x_p1393_lanes[1], f13_x_p1393_lanes[2],
      f13_x_p1393_lanes[3], f13_x_p1393_lanes[4], f13_x_p1393_lanes[5], f13_x_p1292, f13_x_p1104);
  const Lanes<8> f13_x_p1457_lanes = detail::make_pack<Real>(f13_x_p1329_lanes[0],
      f13_x_p1329_lanes[1], f13_x_p1329_lanes[2], f13_x_p1329_lanes[3], f13_x_p1329_lanes[4],
      f13_x_p1329_lanes[5], c16 * f13_x_p1129 - s16 * f13_x_p1134 - inverse_D6_p101_lanes[1] *
      f13_x_p1140, c16 * f13_x_p1103 - s16 * f13_x_p1116 - inverse_D6_p101_lanes[1] * f13_x_p968) -
      detail::make_pack<Real>(inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[0],
      inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[0],
      inverse_D6_p267_lanes[0], inverse_D6_p267_lanes[1], inverse_D6_p267_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[0], f13_x_p1393_lanes[1], f13_x_p1393_lanes[2],
      f13_x_p1393_lanes[3], f13_x_p1393_lanes[4], f13_x_p1393_lanes[5], f13_x_p1292, f13_x_p1104);
  const Lanes<8> f13_x_p1465_lanes = detail::make_pack<Real>(f13_x_p1421_lanes[0],
      f13_x_p1421_lanes[1], f13_x_p1421_lanes[2], f13_x_p1421_lanes[3], f13_x_p1421_lanes[4],
      f13_x_p1421_lanes[5], c15 * f13_x_p1299 - s15 * f13_x_p1250, c15 * f13_x_p1249 - s15 *
      f13_x_p1208) - detail::make_pack<Real>(inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[0],
      inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[0],
      inverse_D6_p265_lanes[0], inverse_D6_p265_lanes[1], inverse_D6_p265_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[0], f13_x_p1393_lanes[1], f13_x_p1393_lanes[2],
      f13_x_p1393_lanes[3], f13_x_p1393_lanes[4], f13_x_p1393_lanes[5], f13_x_p1292, f13_x_p1104);
  const Lanes<8> f13_x_p1473_lanes = detail::make_pack<Real>(f13_x_p1443_lanes[0],
      f13_x_p1443_lanes[1], f13_x_p1443_lanes[2], f13_x_p1443_lanes[3], f13_x_p1443_lanes[4],
      f13_x_p1443_lanes[5], s15 * f13_x_p1299 + c15 * f13_x_p1250, s15 * f13_x_p1249 + c15 *
      f13_x_p1208) - detail::make_pack<Real>(inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0],
      inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[0],
      inverse_D6_p271_lanes[0], inverse_D6_p271_lanes[1], inverse_D6_p271_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[0], f13_x_p1393_lanes[1], f13_x_p1393_lanes[2],
      f13_x_p1393_lanes[3], f13_x_p1393_lanes[4], f13_x_p1393_lanes[5], f13_x_p1292, f13_x_p1104);
  const Lanes<8> f13_x_p1481_lanes = detail::make_pack<Real>(f13_x_p1399_lanes[0],
      f13_x_p1399_lanes[1], f13_x_p1399_lanes[2], f13_x_p1399_lanes[3], f13_x_p1399_lanes[4],
      f13_x_p1399_lanes[5], c15 * f13_x_p1174 - s15 * f13_x_p1195, c15 * f13_x_p1031 - s15 *
      f13_x_p1041) - detail::make_pack<Real>(inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0],
      inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[0],
      inverse_D6_p370_lanes[0], inverse_D6_p370_lanes[1], inverse_D6_p370_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[0], f13_x_p1393_lanes[1], f13_x_p1393_lanes[2],
      f13_x_p1393_lanes[3], f13_x_p1393_lanes[4], f13_x_p1393_lanes[5], f13_x_p1292, f13_x_p1104);
  const Lanes<8> f13_x_p1561_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1457_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1465_lanes;
  const Lanes<8> f13_x_p1577_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1457_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1465_lanes;
  const Lanes<8> f13_x_p1617_lanes = 0.226 * f13_x_p1473_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      f13_x_p1561_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1641_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1449_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1481_lanes + f13_x_p1617_lanes);
  const Lanes<8> f13_x_p1649_lanes = inverse_D5_p54 * f13_x_p1641_lanes;
  const Lanes<8> f13_x_p1689_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18,
      (-0.18), (-0.18)) * f13_x_p1577_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * f13_x_p1449_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1481_lanes) - f13_x_p1649_lanes;
  const Lanes<8> f13_x_p1697_lanes = 0.226 * f13_x_p1577_lanes - inverse_D5_p57 * f13_x_p1641_lanes;
  const Lanes<8> f13_x_p1705_lanes = f13_x_p1577_lanes - inverse_D5_p52 * f13_x_p1641_lanes;
  const Lanes<8> f13_x_p1713_lanes = f13_x_p1561_lanes + inverse_D3_p34 * f13_x_p1641_lanes;
  const Lanes<8> f13_x_p1721_lanes = f13_x_p1473_lanes - inverse_D3_p35 * f13_x_p1641_lanes;
  const Lanes<8> f13_x_p1817_lanes = s6 * f13_x_p1713_lanes + c6 * f13_x_p1721_lanes;
  const Lanes<8> f13_x_p1833_lanes = s6 * f13_x_p1689_lanes + c6 * f13_x_p1697_lanes + 0.072 *
      f13_x_p1705_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1897_lanes = c6 * f13_x_p1713_lanes - s6 * f13_x_p1721_lanes -
      inverse_D3_p63 * f13_x_p1833_lanes;
  const Lanes<8> f13_x_p1905_lanes = f13_x_p1705_lanes - inverse_D3_p62 * f13_x_p1833_lanes;
  const Lanes<8> f13_x_p1913_lanes = c6 * f13_x_p1689_lanes - s6 * f13_x_p1697_lanes -
      inverse_D4_p2 * f13_x_p1833_lanes;
  const Lanes<8> f13_x_p1921_lanes = -(0.072 * f13_x_p1817_lanes) + inverse_D4_p1 *
      f13_x_p1833_lanes;
  const Lanes<8> f13_x_p1969_lanes = s4 * (f13_x_p1817_lanes - inverse_D3_p64 * f13_x_p1833_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2009_lanes = f13_x_p889_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2013_lanes = f13_x_p822_lanes * inverse_D4;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2017_lanes = f13_x_p1032_lanes * inverse_D2;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2021_lanes = f13_x_p705_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2041_lanes = f13_x_p609_lanes * inverse_D6;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2081_lanes = -(s5 * f13_x_p1921_lanes + c5 * f13_x_p1913_lanes);
  const Lanes<8> f13_x_p2125_lanes = f13_x_p2081_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2137_lanes = f13_x_p1833_lanes * inverse_D5;
  const Lanes<8> f13_x_p2145_lanes = c4 * (s5 * f13_x_p1897_lanes - c5 * f13_x_p1905_lanes) +
      f13_x_p1969_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2153 = f13_x_p1641_lanes[7] * inverse_D6;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2154_lanes = -(s5 * f13_x_p1905_lanes + c5 * f13_x_p1897_lanes) -
      inverse_D2_p12 * f13_x_p2081_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2162 = f13_x_p1641_lanes[6] * inverse_D6;
  const Lanes<8> f13_x_p2167_lanes = f13_x_p1641_lanes * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2181_lanes = f13_x_p1393_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2195_lanes = f13_x_p1232_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2225_lanes = f13_x_p1054_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p2231_lanes = detail::make_pack<Real>(f13_x_p893_lanes[0],
      f13_x_p797_lanes[0], f13_x_p97_lanes[0], f13_x_p105_lanes[0], f13_x_p131_lanes[0],
      f13_x_p113_lanes[0], f13_x_p893_lanes[0], f13_x_p893_lanes[0]) * inverse_D10_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2261_lanes = f13_x_p2181_lanes * f13_x_p1393_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2267_lanes = s4 * (s5 * f13_x_p1913_lanes - c5 * f13_x_p1921_lanes) +
      0.21799999999999997 * f13_x_p2145_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2295_lanes = -f13_x_p2267_lanes - inverse_D3_p93 * f13_x_p2081_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2325_lanes = f13_x_p2295_lanes * inverse_D3;
  const Lanes<8> f13_x_p2333_lanes = f13_x_p2009_lanes * f13_x_p2295_lanes[0];
  const Lanes<8> f13_x_p2355_lanes = f13_x_p2009_lanes * f13_x_p2295_lanes[1];
  const Lanes<8> f13_x_p2359_lanes = -f13_x_p2145_lanes - inverse_D2_p11 * f13_x_p2081_lanes -
      inverse_D2_p16 * f13_x_p2295_lanes;
  const Lanes<8> f13_x_p2367_lanes = -f13_x_p2154_lanes + inverse_D2_p15 * f13_x_p2295_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2375_lanes = f13_x_p2231_lanes * f13_x_p893_lanes[0] + f13_x_p2225_lanes *
      f13_x_p1054_lanes[0] + f13_x_p2195_lanes * f13_x_p1232_lanes[0] + f13_x_p2261_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2389_lanes = f13_x_p2041_lanes * f13_x_p1641_lanes[0] + f13_x_p2021_lanes *
      f13_x_p1833_lanes[0] + f13_x_p2013_lanes * f13_x_p2081_lanes[0] + f13_x_p2333_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2455_lanes = f13_x_p2375_lanes + f13_x_p2167_lanes * f13_x_p1641_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2476_lanes = f13_x_p2181_lanes * f13_x_p1393_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2493_lanes = inverse_D2_p9 * f13_x_p2359_lanes - inverse_D2_p7 *
      f13_x_p2367_lanes;
  const Lanes<8> f13_x_p2514_lanes = f13_x_p2041_lanes * f13_x_p1641_lanes[1] + f13_x_p2021_lanes *
      f13_x_p1833_lanes[1] + f13_x_p2013_lanes * f13_x_p2081_lanes[1] + f13_x_p2355_lanes;
  const Lanes<8> f13_x_p2547_lanes = detail::make_pack<Real>(f13_x_p2455_lanes[0],
      f13_x_p2455_lanes[1], f13_x_p2455_lanes[2], f13_x_p2455_lanes[3], f13_x_p2455_lanes[4],
      f13_x_p2455_lanes[5], f13_x_p2162 * f13_x_p1641_lanes[0], f13_x_p2153 *
      f13_x_p1641_lanes[0]) + f13_x_p2137_lanes * f13_x_p1833_lanes[0] + f13_x_p2125_lanes *
      f13_x_p2081_lanes[0] + f13_x_p2325_lanes * f13_x_p2295_lanes[0];
  const Lanes<8> f13_x_p2555_lanes = f13_x_p2009_lanes * f13_x_p2295_lanes[2];
  const Lanes<8> f13_x_p2567_lanes = inverse_D2_p10 *
      (inverse_D2_p7 * f13_x_p2359_lanes + inverse_D2_p9 * f13_x_p2367_lanes) + inverse_D2_p8 *
      f13_x_p2493_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2575_lanes = f13_x_p2231_lanes * f13_x_p797_lanes[0] + f13_x_p2225_lanes *
      f13_x_p1054_lanes[1] + f13_x_p2195_lanes * f13_x_p1232_lanes[1] + f13_x_p2476_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2592_lanes = f13_x_p2567_lanes * inverse_D2;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2600_lanes = f13_x_p2575_lanes + f13_x_p2167_lanes * f13_x_p1641_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2686_lanes = 0.434 * (f13_x_p2493_lanes - inverse_D1_p3 *
      f13_x_p2567_lanes);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2694_lanes = f13_x_p2181_lanes * f13_x_p1393_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2730_lanes = detail::make_pack<Real>(f13_x_p2600_lanes[1],
      f13_x_p2600_lanes[1], f13_x_p2600_lanes[2], f13_x_p2600_lanes[3], f13_x_p2600_lanes[4],
      f13_x_p2600_lanes[5], f13_x_p2162 * f13_x_p1641_lanes[1], f13_x_p2153 *
      f13_x_p1641_lanes[1]) + f13_x_p2137_lanes * f13_x_p1833_lanes[1] + f13_x_p2125_lanes *
      f13_x_p2081_lanes[1] + f13_x_p2325_lanes * f13_x_p2295_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2741_lanes = f13_x_p2686_lanes * inverse_D1;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2757_lanes = f13_x_p2041_lanes * f13_x_p1641_lanes[2] + f13_x_p2021_lanes *
      f13_x_p1833_lanes[2] + f13_x_p2013_lanes * f13_x_p2081_lanes[2] + f13_x_p2555_lanes;
  const Lanes<8> f13_x_p2800_lanes = f13_x_p2009_lanes * f13_x_p2295_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2825_lanes = f13_x_p2389_lanes + f13_x_p2017_lanes * f13_x_p2567_lanes[0] +
      f13_x_p1377_lanes * f13_x_p2686_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2829_lanes = f13_x_p2231_lanes * f13_x_p97_lanes[0] + f13_x_p2225_lanes *
      f13_x_p1054_lanes[2] + f13_x_p2195_lanes * f13_x_p1232_lanes[2] + f13_x_p2694_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2845_lanes = f13_x_p2547_lanes + f13_x_p2592_lanes * f13_x_p2567_lanes[0] +
      f13_x_p2741_lanes * f13_x_p2686_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2860_lanes = f13_x_p2829_lanes + f13_x_p2167_lanes * f13_x_p1641_lanes[2];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2890_lanes = f13_x_p2195_lanes * f13_x_p1232_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p2893 = 1.0 / f13_x_p2845_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p2900_lanes = detail::make_pack<Real>(neg_c12_lanes[0], neg_c12_lanes[0],
      neg_c12_lanes[0], neg_c12_lanes[0], f13_x_p31_lanes[0], f13_x_p25_lanes[0], neg_c12_lanes[0],
      neg_c12_lanes[0]) * inverse_D11_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2927_lanes = f13_x_p2041_lanes * f13_x_p1641_lanes[3] + f13_x_p2021_lanes *
      f13_x_p1833_lanes[3] + f13_x_p2013_lanes * f13_x_p2081_lanes[3] + f13_x_p2800_lanes;
  const Lanes<8> f13_x_p2931_lanes = detail::make_pack<Real>(f13_x_p2860_lanes[2],
      f13_x_p2860_lanes[2], f13_x_p2860_lanes[2], f13_x_p2860_lanes[3], f13_x_p2860_lanes[4],
      f13_x_p2860_lanes[5], f13_x_p2162 * f13_x_p1641_lanes[2], f13_x_p2153 *
      f13_x_p1641_lanes[2]) + f13_x_p2137_lanes * f13_x_p1833_lanes[2] + f13_x_p2125_lanes *
      f13_x_p2081_lanes[2] + f13_x_p2325_lanes * f13_x_p2295_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2963_lanes = f13_x_p2845_lanes * f13_x_p2893;
  const Lanes<8> f13_x_p2970_lanes = f13_x_p2825_lanes * f13_x_p2893;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2974_lanes = f13_x_p2900_lanes * neg_c12_lanes[0] + f13_x_p2231_lanes *
      f13_x_p105_lanes[0] + f13_x_p2225_lanes * f13_x_p1054_lanes[3] + f13_x_p2890_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3018_lanes = f13_x_p2009_lanes * f13_x_p2295_lanes[4];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3030_lanes = f13_x_p2974_lanes + f13_x_p2181_lanes * f13_x_p1393_lanes[3] +
      f13_x_p2167_lanes * f13_x_p1641_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3041_lanes = f13_x_p2730_lanes + f13_x_p2592_lanes * f13_x_p2567_lanes[1] +
      f13_x_p2741_lanes * f13_x_p2686_lanes[1] - f13_x_p2963_lanes * f13_x_p2845_lanes[1];
  const Lanes<8> f13_x_p3048_lanes = f13_x_p2931_lanes + f13_x_p2592_lanes * f13_x_p2567_lanes[2] +
      f13_x_p2741_lanes * f13_x_p2686_lanes[2] - f13_x_p2963_lanes * f13_x_p2845_lanes[2];
  const Lanes<8> f13_x_p3054_lanes = f13_x_p2514_lanes + f13_x_p2017_lanes * f13_x_p2567_lanes[1] +
      f13_x_p1377_lanes * f13_x_p2686_lanes[1] - f13_x_p2970_lanes * f13_x_p2845_lanes[1];
  const Lanes<8> f13_x_p3058_lanes = f13_x_p2757_lanes + f13_x_p2017_lanes * f13_x_p2567_lanes[2] +
      f13_x_p1377_lanes * f13_x_p2686_lanes[2] - f13_x_p2970_lanes * f13_x_p2845_lanes[2];
  const Lanes<8> f13_x_p3071_lanes = f13_x_p2927_lanes + f13_x_p2017_lanes * f13_x_p2567_lanes[3] +
      f13_x_p1377_lanes * f13_x_p2686_lanes[3] - f13_x_p2970_lanes * f13_x_p2845_lanes[3];
  const Real f13_x_p3079 = 1.0 / f13_x_p3041_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3101_lanes = f13_x_p481_lanes * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p3105_lanes = f13_x_p405_lanes * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p3113_lanes = f13_x_p265_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p3121_lanes = detail::make_pack<Real>(f13_x_p97_lanes[1],
      f13_x_p105_lanes[1], f13_x_p131_lanes[1], f13_x_p113_lanes[1], f13_x_p97_lanes[1],
      f13_x_p97_lanes[1], f13_x_p97_lanes[1], f13_x_p97_lanes[1]) * inverse_D10_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3125_lanes = detail::make_pack<Real>(f13_x_p3030_lanes[3],
      f13_x_p3030_lanes[3], f13_x_p3030_lanes[3], f13_x_p3030_lanes[3], f13_x_p3030_lanes[4],
      f13_x_p3030_lanes[5], f13_x_p2162 * f13_x_p1641_lanes[3], f13_x_p2153 *
      f13_x_p1641_lanes[3]) + f13_x_p2137_lanes * f13_x_p1833_lanes[3] + f13_x_p2125_lanes *
      f13_x_p2081_lanes[3] + f13_x_p2325_lanes * f13_x_p2295_lanes[3];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p3130_lanes = detail::make_pack<Real>(neg_c12_lanes[1], neg_c12_lanes[1],
      f13_x_p31_lanes[1], f13_x_p25_lanes[1], neg_c12_lanes[1], neg_c12_lanes[1], neg_c12_lanes[1],
      neg_c12_lanes[1]) * inverse_D11_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p3135_lanes = inverse_D12_p7_lanes * inverse_D12_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3139_lanes = f13_x_p2041_lanes * f13_x_p1641_lanes[4] + f13_x_p2021_lanes *
      f13_x_p1833_lanes[4] + f13_x_p2013_lanes * f13_x_p2081_lanes[4] + f13_x_p3018_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3173_lanes = f13_x_p3041_lanes * f13_x_p3079;
  const Lanes<8> f13_x_p3181_lanes = f13_x_p3054_lanes * f13_x_p3079;
  const Lanes<8> f13_x_p3191_lanes = f13_x_p3125_lanes + f13_x_p2592_lanes * f13_x_p2567_lanes[3] +
      f13_x_p2741_lanes * f13_x_p2686_lanes[3] - f13_x_p2963_lanes * f13_x_p2845_lanes[3];
  const Lanes<8> f13_x_p3198_lanes = f13_x_p3139_lanes + f13_x_p2017_lanes * f13_x_p2567_lanes[4] +
      f13_x_p1377_lanes * f13_x_p2686_lanes[4] - f13_x_p2970_lanes * f13_x_p2845_lanes[4];

  // link 9 (left_upperarm), force propagation
  const Lanes<2> f13_x_p3231_lanes = f13_x_p3135_lanes +
      detail::make_pack<Real>(f13_x_p2900_lanes[5], f13_x_p3130_lanes[3]) * f13_x_p31_lanes +
      detail::make_pack<Real>(f13_x_p2231_lanes[5], f13_x_p3121_lanes[3]) * f13_x_p131_lanes +
      detail::make_pack<Real>(f13_x_p2225_lanes[5], f13_x_p3113_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1054_lanes[4], f13_x_p265_lanes[2]);
  const Lanes<2> f13_x_p3233_lanes = inverse_D12_lanes +
      detail::make_pack<Real>(f13_x_p2900_lanes[4], f13_x_p3130_lanes[2]) * f13_x_p31_lanes +
      detail::make_pack<Real>(f13_x_p2231_lanes[4], f13_x_p3121_lanes[2]) * f13_x_p131_lanes +
      detail::make_pack<Real>(f13_x_p2225_lanes[4], f13_x_p3113_lanes[2]) *
      detail::make_pack<Real>(f13_x_p1054_lanes[4], f13_x_p265_lanes[2]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3235_lanes = f13_x_p3048_lanes - f13_x_p3173_lanes * f13_x_p3041_lanes[2];
  const Lanes<8> f13_x_p3256_lanes = f13_x_p3058_lanes - f13_x_p3181_lanes * f13_x_p3041_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3278_lanes = f13_x_p2009_lanes * f13_x_p2295_lanes[5];

  // link 1 (calf), force propagation
  const Real f13_x_p3282 = 1.0 / f13_x_p3235_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p3295_lanes = f13_x_p3231_lanes +
      detail::make_pack<Real>(f13_x_p2195_lanes[5], f13_x_p3105_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1232_lanes[4], f13_x_p405_lanes[2]) +
      detail::make_pack<Real>(f13_x_p2181_lanes[5], f13_x_p3101_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[4], f13_x_p481_lanes[2]);
  const Lanes<2> f13_x_p3297_lanes = f13_x_p3233_lanes +
      detail::make_pack<Real>(f13_x_p2195_lanes[4], f13_x_p3105_lanes[2]) *
      detail::make_pack<Real>(f13_x_p1232_lanes[4], f13_x_p405_lanes[2]) +
      detail::make_pack<Real>(f13_x_p2181_lanes[4], f13_x_p3101_lanes[2]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[4], f13_x_p481_lanes[2]);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3348_lanes = f13_x_p2041_lanes * f13_x_p1641_lanes[5] + f13_x_p2021_lanes *
      f13_x_p1833_lanes[5] + f13_x_p2013_lanes * f13_x_p2081_lanes[5] + f13_x_p3278_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3352_lanes = f13_x_p3235_lanes * f13_x_p3282;
  const Lanes<8> f13_x_p3357_lanes = f13_x_p3256_lanes * f13_x_p3282;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3361_lanes = detail::make_pack<Real>(f13_x_p3297_lanes[0] +
      f13_x_p2167_lanes[4] * f13_x_p1641_lanes[4], f13_x_p3297_lanes[0] + f13_x_p2167_lanes[4] *
      f13_x_p1641_lanes[4], f13_x_p3297_lanes[0] + f13_x_p2167_lanes[4] * f13_x_p1641_lanes[4],
      f13_x_p3297_lanes[0] + f13_x_p2167_lanes[4] * f13_x_p1641_lanes[4], f13_x_p3297_lanes[0] +
      f13_x_p2167_lanes[4] * f13_x_p1641_lanes[4], f13_x_p3295_lanes[0] + f13_x_p2167_lanes[5] *
      f13_x_p1641_lanes[4], f13_x_p2162 * f13_x_p1641_lanes[4], f13_x_p2153 *
      f13_x_p1641_lanes[4]) + f13_x_p2137_lanes * f13_x_p1833_lanes[4] + f13_x_p2125_lanes *
      f13_x_p2081_lanes[4] + f13_x_p2325_lanes * f13_x_p2295_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3409_lanes = f13_x_p3191_lanes - f13_x_p3173_lanes * f13_x_p3041_lanes[3] -
      f13_x_p3352_lanes * f13_x_p3235_lanes[3];
  const Lanes<8> f13_x_p3414_lanes = f13_x_p3348_lanes + f13_x_p2017_lanes * f13_x_p2567_lanes[5] +
      f13_x_p1377_lanes * f13_x_p2686_lanes[5] - f13_x_p2970_lanes * f13_x_p2845_lanes[5];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p3418_lanes = 1065.380700001509 + f13_x_p3135_lanes * inverse_D12_p7_lanes +
      detail::make_pack<Real>(f13_x_p2900_lanes[5], f13_x_p3130_lanes[3]) * f13_x_p25_lanes +
      detail::make_pack<Real>(f13_x_p2231_lanes[5], f13_x_p3121_lanes[3]) * f13_x_p113_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3420_lanes = f13_x_p3071_lanes - f13_x_p3181_lanes * f13_x_p3041_lanes[3] -
      f13_x_p3357_lanes * f13_x_p3235_lanes[3];
  const Lanes<8> f13_x_p3432_lanes = f13_x_p3361_lanes + f13_x_p2592_lanes * f13_x_p2567_lanes[4] +
      f13_x_p2741_lanes * f13_x_p2686_lanes[4] - f13_x_p2963_lanes * f13_x_p2845_lanes[4];
  const Real f13_x_p3448 = 1.0 / f13_x_p3409_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3479_lanes = f13_x_p3101_lanes * f13_x_p1292;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p3509_lanes = f13_x_p3418_lanes +
      detail::make_pack<Real>(f13_x_p2225_lanes[5], f13_x_p3113_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1054_lanes[5], f13_x_p265_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2195_lanes[5], f13_x_p3105_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1232_lanes[5], f13_x_p405_lanes[3]) +
      detail::make_pack<Real>(f13_x_p2181_lanes[5], f13_x_p3101_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1393_lanes[5], f13_x_p481_lanes[3]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3515_lanes = f13_x_p3121_lanes * f13_x_p893_lanes[1] + f13_x_p3113_lanes *
      f13_x_p969 + f13_x_p3105_lanes * f13_x_p1140 + f13_x_p3479_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3519_lanes = f13_x_p3409_lanes * f13_x_p3448;
  const Lanes<8> f13_x_p3526_lanes = f13_x_p3420_lanes * f13_x_p3448;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3544_lanes = detail::make_pack<Real>(f13_x_p3509_lanes[0] +
      f13_x_p2167_lanes[5] * f13_x_p1641_lanes[5], f13_x_p3509_lanes[0] + f13_x_p2167_lanes[5] *
      f13_x_p1641_lanes[5], f13_x_p3509_lanes[0] + f13_x_p2167_lanes[5] * f13_x_p1641_lanes[5],
      f13_x_p3509_lanes[0] + f13_x_p2167_lanes[5] * f13_x_p1641_lanes[5], f13_x_p3509_lanes[0] +
      f13_x_p2167_lanes[5] * f13_x_p1641_lanes[5], f13_x_p3509_lanes[0] + f13_x_p2167_lanes[5] *
      f13_x_p1641_lanes[5], f13_x_p2162 * f13_x_p1641_lanes[5], f13_x_p2153 *
      f13_x_p1641_lanes[5]) + f13_x_p2137_lanes * f13_x_p1833_lanes[5] + f13_x_p2125_lanes *
      f13_x_p2081_lanes[5] + f13_x_p2325_lanes * f13_x_p2295_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3547_lanes = f13_x_p3432_lanes - f13_x_p3173_lanes * f13_x_p3041_lanes[4] -
      f13_x_p3352_lanes * f13_x_p3235_lanes[4] - f13_x_p3519_lanes * f13_x_p3409_lanes[4];
  const Real f13_x_p3570 = 1.0 / f13_x_p3547_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3571_lanes = f13_x_p3515_lanes + f13_x_p2041_lanes * f13_x_p1641_lanes[6] +
      f13_x_p2021_lanes * f13_x_p1833_lanes[6] + f13_x_p2013_lanes * f13_x_p2081_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3578_lanes = f13_x_p3198_lanes - f13_x_p3181_lanes * f13_x_p3041_lanes[4] -
      f13_x_p3357_lanes * f13_x_p3235_lanes[4] - f13_x_p3526_lanes * f13_x_p3409_lanes[4];
  const Lanes<8> f13_x_p3582_lanes = f13_x_p3414_lanes - f13_x_p3181_lanes * f13_x_p3041_lanes[5] -
      f13_x_p3357_lanes * f13_x_p3235_lanes[5] - f13_x_p3526_lanes * f13_x_p3409_lanes[5];
  const Lanes<8> f13_x_p3590_lanes = f13_x_p3544_lanes + f13_x_p2592_lanes * f13_x_p2567_lanes[5] +
      f13_x_p2741_lanes * f13_x_p2686_lanes[5] - f13_x_p2963_lanes * f13_x_p2845_lanes[5];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3600 = f13_x_p893_lanes[1] * inverse_D10_lanes[1] * f13_x_p893_lanes[1] +
      f13_x_p969 * inverse_D9_lanes[1] * f13_x_p969 + f13_x_p1140 * inverse_D8_lanes[1] *
      f13_x_p1140;

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p3604 = f13_x_p1104 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3605 = f13_x_p968 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p3606 = f13_x_p882 * inverse_D9_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3607_lanes = f13_x_p3571_lanes + f13_x_p2009_lanes * f13_x_p2295_lanes[6] +
      f13_x_p2017_lanes * f13_x_p2567_lanes[6] + f13_x_p1377_lanes * f13_x_p2686_lanes[6];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p3611 = f13_x_p797_lanes[1] * inverse_D10_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3612_lanes = f13_x_p3547_lanes * f13_x_p3570;
  const Lanes<8> f13_x_p3615_lanes = f13_x_p3590_lanes - f13_x_p3173_lanes * f13_x_p3041_lanes[5] -
      f13_x_p3352_lanes * f13_x_p3235_lanes[5] - f13_x_p3519_lanes * f13_x_p3409_lanes[5];
  const Lanes<8> f13_x_p3618_lanes = f13_x_p3578_lanes * f13_x_p3570;

  // link 4 (chest1), force propagation
  const Real f13_x_p3641 = f13_x_p3600 + f13_x_p1292 * inverse_D7_lanes[1] * f13_x_p1292 +
      f13_x_p2162 * f13_x_p1641_lanes[6] + f13_x_p2137_lanes[6] * f13_x_p1833_lanes[6] +
      f13_x_p2125_lanes[6] * f13_x_p2081_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3650_lanes = f13_x_p3615_lanes - f13_x_p3612_lanes * f13_x_p3547_lanes[5];
  const Lanes<8> f13_x_p3653_lanes = f13_x_p3607_lanes - f13_x_p2970_lanes * f13_x_p2845_lanes[6] -
      f13_x_p3181_lanes * f13_x_p3041_lanes[6] - f13_x_p3357_lanes * f13_x_p3235_lanes[6];
  const Real f13_x_p3689 = 1.0 / f13_x_p3650_lanes[5];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3694_lanes = f13_x_p3101_lanes * f13_x_p1104;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3702_lanes = f13_x_p3582_lanes - f13_x_p3618_lanes * f13_x_p3547_lanes[5];

  // link 6 (chest3), force propagation
  const Real f13_x_p3726 = f13_x_p3611 * f13_x_p893_lanes[1] + f13_x_p3606 * f13_x_p969 +
      f13_x_p3605 * f13_x_p1140 + f13_x_p3604 * f13_x_p1292 + f13_x_p2153 * f13_x_p1641_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p3731 = f13_x_p3641 + f13_x_p2325_lanes[6] * f13_x_p2295_lanes[6] +
      f13_x_p2592_lanes[6] * f13_x_p2567_lanes[6] + f13_x_p2741_lanes[6] * f13_x_p2686_lanes[6] -
      f13_x_p2963_lanes[6] * f13_x_p2845_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3732_lanes = f13_x_p3121_lanes * f13_x_p797_lanes[1] + f13_x_p3113_lanes *
      f13_x_p882 + f13_x_p3105_lanes * f13_x_p968 + f13_x_p3694_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p3736 = f13_x_p3650_lanes[6] * f13_x_p3689;
  const Real f13_x_p3741 = f13_x_p3650_lanes[7] * f13_x_p3689;
  const Lanes<8> f13_x_p3742_lanes = f13_x_p3702_lanes * f13_x_p3689;

  // link 2 (thigh), force propagation
  const Real f13_x_p3746 = f13_x_p3726 + f13_x_p2137_lanes[7] * f13_x_p1833_lanes[6] +
      f13_x_p2125_lanes[7] * f13_x_p2081_lanes[6] + f13_x_p2325_lanes[7] * f13_x_p2295_lanes[6] +
      f13_x_p2592_lanes[7] * f13_x_p2567_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p3759 = f13_x_p3731 - f13_x_p3173_lanes[6] * f13_x_p3041_lanes[6] -
      f13_x_p3352_lanes[6] * f13_x_p3235_lanes[6] - f13_x_p3519_lanes[6] * f13_x_p3409_lanes[6] -
      f13_x_p3612_lanes[6] * f13_x_p3547_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3760_lanes = f13_x_p3732_lanes + f13_x_p2041_lanes * f13_x_p1641_lanes[7] +
      f13_x_p2021_lanes * f13_x_p1833_lanes[7] + f13_x_p2013_lanes * f13_x_p2081_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3764_lanes = f13_x_p3653_lanes - f13_x_p3526_lanes * f13_x_p3409_lanes[6] -
      f13_x_p3618_lanes * f13_x_p3547_lanes[6] - f13_x_p3742_lanes * f13_x_p3650_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3800_lanes = f13_x_p3101_lanes * f13_x_p481_lanes[0];

  // link 6 (chest3), force propagation
  const Real f13_x_p3812 = f13_x_p3611 * f13_x_p797_lanes[1] + f13_x_p3606 * f13_x_p882 +
      f13_x_p3605 * f13_x_p968 + f13_x_p3604 * f13_x_p1104 + f13_x_p2153 * f13_x_p1641_lanes[7];

  // link 1 (calf), force propagation
  const Real f13_x_p3817 = 1.0 / (f13_x_p3759 - f13_x_p3736 * f13_x_p3650_lanes[6]);
  const Real f13_x_p3838 = f13_x_p3746 + f13_x_p2741_lanes[7] * f13_x_p2686_lanes[6] -
      f13_x_p2963_lanes[7] * f13_x_p2845_lanes[6] - f13_x_p3173_lanes[7] * f13_x_p3041_lanes[6] -
      f13_x_p3352_lanes[7] * f13_x_p3235_lanes[6];
  const Lanes<8> f13_x_p3847_lanes = f13_x_p3760_lanes + f13_x_p2009_lanes * f13_x_p2295_lanes[7] +
      f13_x_p2017_lanes * f13_x_p2567_lanes[7] + f13_x_p1377_lanes * f13_x_p2686_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p3859_lanes = f13_x_p3121_lanes * f13_x_p97_lanes[1] + f13_x_p3113_lanes *
      f13_x_p265_lanes[0] + f13_x_p3105_lanes * f13_x_p405_lanes[0] + f13_x_p3800_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p3867 = f13_x_p3838 - f13_x_p3519_lanes[7] * f13_x_p3409_lanes[6] -
      f13_x_p3612_lanes[7] * f13_x_p3547_lanes[6] - f13_x_p3741 * f13_x_p3650_lanes[6];

  // link 2 (thigh), force propagation
  const Real f13_x_p3868 = f13_x_p3812 + f13_x_p2137_lanes[7] * f13_x_p1833_lanes[7] +
      f13_x_p2125_lanes[7] * f13_x_p2081_lanes[7] + f13_x_p2325_lanes[7] * f13_x_p2295_lanes[7] +
      f13_x_p2592_lanes[7] * f13_x_p2567_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3882_lanes = f13_x_p3847_lanes - f13_x_p2970_lanes * f13_x_p2845_lanes[7] -
      f13_x_p3181_lanes * f13_x_p3041_lanes[7] - f13_x_p3357_lanes * f13_x_p3235_lanes[7];
  const Lanes<8> f13_x_p3886_lanes = f13_x_p3764_lanes * f13_x_p3817;
  const Real f13_x_p3893 = f13_x_p3867 * f13_x_p3817;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p3906_lanes = f13_x_p3105_lanes * f13_x_p405_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3946_lanes = f13_x_p3859_lanes + f13_x_p2041_lanes * f13_x_p609_lanes[0] +
      f13_x_p2021_lanes * f13_x_p705_lanes[0] + f13_x_p2013_lanes * f13_x_p822_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3970_lanes = f13_x_p3882_lanes - f13_x_p3526_lanes * f13_x_p3409_lanes[7] -
      f13_x_p3618_lanes * f13_x_p3547_lanes[7] - f13_x_p3742_lanes * f13_x_p3650_lanes[7];
  const Real f13_x_p3974 = f13_x_p3868 + f13_x_p2741_lanes[7] * f13_x_p2686_lanes[7] -
      f13_x_p2963_lanes[7] * f13_x_p2845_lanes[7] - f13_x_p3173_lanes[7] * f13_x_p3041_lanes[7] -
      f13_x_p3352_lanes[7] * f13_x_p3235_lanes[7];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p3979_lanes = f13_x_p3130_lanes * neg_c12_lanes[1] + f13_x_p3121_lanes *
      f13_x_p105_lanes[1] + f13_x_p3113_lanes * f13_x_p265_lanes[1] + f13_x_p3906_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3982_lanes = f13_x_p3970_lanes - f13_x_p3886_lanes * f13_x_p3867;
  const Lanes<8> f13_x_p3986_lanes = f13_x_p3946_lanes + f13_x_p2009_lanes * f13_x_p889_lanes[0] +
      f13_x_p2017_lanes * f13_x_p1032_lanes[0] + f13_x_p1377_lanes * f13_x_p1130_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p4004_lanes = f13_x_p3979_lanes + f13_x_p3101_lanes * f13_x_p481_lanes[1] +
      f13_x_p2041_lanes * f13_x_p609_lanes[1] + f13_x_p2021_lanes * f13_x_p705_lanes[1];

  // link 1 (calf), force propagation
  const Real f13_x_p4007 = f13_x_p3974 - f13_x_p3519_lanes[7] * f13_x_p3409_lanes[7] -
      f13_x_p3612_lanes[7] * f13_x_p3547_lanes[7] - f13_x_p3741 * f13_x_p3650_lanes[7] -
      f13_x_p3893 * f13_x_p3867;
  const Lanes<8> f13_x_p4008_lanes = f13_x_p3986_lanes - f13_x_p2970_lanes * f13_x_p2825_lanes[0] -
      f13_x_p3181_lanes * f13_x_p3054_lanes[0] - f13_x_p3357_lanes * f13_x_p3256_lanes[0];
  const Real f13_x_p4015 = 1.0 / f13_x_p4007;

  // link 3 (hip), force propagation
  const Real f13_x_p4027 = f13_x_p3295_lanes[1] + f13_x_p2041_lanes[3] * f13_x_p609_lanes[2] +
      f13_x_p2021_lanes[3] * f13_x_p705_lanes[2] + f13_x_p2013_lanes[3] * f13_x_p822_lanes[2] +
      f13_x_p2009_lanes[3] * f13_x_p889_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p4028_lanes = f13_x_p4004_lanes + f13_x_p2013_lanes * f13_x_p822_lanes[1] +
      f13_x_p2009_lanes * f13_x_p889_lanes[1] + f13_x_p2017_lanes * f13_x_p1032_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4031_lanes = f13_x_p4008_lanes - f13_x_p3526_lanes * f13_x_p3420_lanes[0] -
      f13_x_p3618_lanes * f13_x_p3578_lanes[0] - f13_x_p3742_lanes * f13_x_p3702_lanes[0];
  const Lanes<8> f13_x_p4045_lanes = f13_x_p3982_lanes * f13_x_p4015;
  const Lanes<8> f13_x_p4049_lanes = f13_x_p4028_lanes + f13_x_p1377_lanes * f13_x_p1130_lanes[1] -
      f13_x_p2970_lanes * f13_x_p2825_lanes[1] - f13_x_p3181_lanes * f13_x_p3054_lanes[1];
  const Real f13_x_p4062 = f13_x_p4027 + f13_x_p2017_lanes[3] * f13_x_p1032_lanes[2] +
      f13_x_p1377_lanes[3] * f13_x_p1130_lanes[2] - f13_x_p2970_lanes[3] * f13_x_p2825_lanes[2] -
      f13_x_p3181_lanes[3] * f13_x_p3054_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4065_lanes = 9.81 + detail::make_pack<Real>(xdd_cmd[2], xdd_cmd[8]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4070_lanes = f13_x_p4031_lanes - f13_x_p3886_lanes * f13_x_p3764_lanes[0] -
      f13_x_p4045_lanes * f13_x_p3982_lanes[0];

  // link 3 (hip), force propagation
  const Real f13_x_p4074 = f13_x_p3297_lanes[1] + f13_x_p2041_lanes[2] * f13_x_p609_lanes[2] +
      f13_x_p2021_lanes[2] * f13_x_p705_lanes[2] + f13_x_p2013_lanes[2] * f13_x_p822_lanes[2] +
      f13_x_p2009_lanes[2] * f13_x_p889_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4081_lanes = f13_x_p4049_lanes - f13_x_p3357_lanes * f13_x_p3256_lanes[1] -
      f13_x_p3526_lanes * f13_x_p3420_lanes[1] - f13_x_p3618_lanes * f13_x_p3578_lanes[1];
  const Real f13_x_p4084 = 1.0 / f13_x_p4070_lanes[0];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4087_lanes = c1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) - s1 *
      f13_x_p4065_lanes;
  const Lanes<2> f13_x_p4089_lanes = s1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) + c1 *
      f13_x_p4065_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4107 = f13_x_p4062 - f13_x_p3357_lanes[3] * f13_x_p3256_lanes[2] -
      f13_x_p3526_lanes[3] * f13_x_p3420_lanes[2] - f13_x_p3618_lanes[3] * f13_x_p3578_lanes[2] -
      f13_x_p3742_lanes[3] * f13_x_p3702_lanes[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4108_lanes = inverse_D2_p9 * f13_x_p4087_lanes - inverse_D2_p7 *
      f13_x_p4089_lanes;
  const Lanes<2> f13_x_p4110_lanes = inverse_D2_p7 * f13_x_p4087_lanes + inverse_D2_p9 *
      f13_x_p4089_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4112_lanes = f13_x_p4081_lanes - f13_x_p3742_lanes * f13_x_p3702_lanes[1] -
      f13_x_p3886_lanes * f13_x_p3764_lanes[1] - f13_x_p4045_lanes * f13_x_p3982_lanes[1];
  const Real f13_x_p4115 = f13_x_p4074 + f13_x_p2017_lanes[2] * f13_x_p1032_lanes[2] +
      f13_x_p1377_lanes[2] * f13_x_p1130_lanes[2] - f13_x_p2970_lanes[2] * f13_x_p2825_lanes[2] -
      f13_x_p3181_lanes[2] * f13_x_p3054_lanes[2];
  const Lanes<8> f13_x_p4124_lanes = f13_x_p4070_lanes * f13_x_p4084;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4127_lanes = c4 * f13_x_p4108_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Lanes<2> f13_x_p4129_lanes = s4 * f13_x_p4108_lanes - c4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4142_lanes = f13_x_p4112_lanes - f13_x_p4124_lanes * f13_x_p4070_lanes[1];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4145_lanes = s5 * f13_x_p4127_lanes + c5 * f13_x_p4110_lanes;
  const Lanes<2> f13_x_p4147_lanes = c5 * f13_x_p4127_lanes - s5 * f13_x_p4110_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4149 = f13_x_p4115 - f13_x_p3357_lanes[2] * f13_x_p3256_lanes[2] -
      f13_x_p3526_lanes[2] * f13_x_p3420_lanes[2] - f13_x_p3618_lanes[2] * f13_x_p3578_lanes[2] -
      f13_x_p3742_lanes[2] * f13_x_p3702_lanes[2];
  const Real f13_x_p4150 = 1.0 / f13_x_p4142_lanes[1];

  // link 2 (thigh), outward
  const Real wd2_z = qdd_0[0] + qdd_0[1];
  const Real w2_z = qd[0] + qd[1];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4159_lanes = c6 * f13_x_p4145_lanes + s6 * f13_x_p4129_lanes;
  const Lanes<2> f13_x_p4161_lanes = s6 * f13_x_p4145_lanes - c6 * f13_x_p4129_lanes;

  // link 2 (thigh), outward
  const Real a3_x_p1 = w2_z * w2_z;

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;
  const Real minus_a1_x = 9.81 * s1;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4171_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4159_lanes +
      detail::make_pack<Real>(s7, s14) * f13_x_p4147_lanes;

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4173_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4147_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4159_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4175 = f13_x_p4142_lanes[2] * f13_x_p4150;
  const Real f13_x_p4176 = f13_x_p4142_lanes[3] * f13_x_p4150;

  // link 2 (thigh), outward
  const Real a2_y = 0.434 * (qd[0] * qd[0]) - minus_a1_y;
  const Real a2_x = 0.434 * qdd_0[0] - minus_a1_x;

  // link 3 (hip), outward
  const Real a5_y_p1 = w3_z * w3_z;
  const Real wd3_z = wd2_z + qdd_0[2];

  // link 5 (chest2), outward
  const Real w5_x_p1 = s4 * w3_z;

  // link 3 (hip), outward
  const Real a3_x_p2 = a2_y + (wd2_z * inverse_D2_p10 + a3_x_p1 * inverse_D2_p8);
  const Real a3_x_p3 = a2_x + (wd2_z * inverse_D2_p8 - a3_x_p1 * inverse_D2_p10);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4185_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4171_lanes +
      detail::make_pack<Real>(c8, c15) * f13_x_p4161_lanes;
  const Lanes<2> f13_x_p4187_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4161_lanes -
      detail::make_pack<Real>(c8, c15) * f13_x_p4171_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4189 = f13_x_p4149 - f13_x_p3886_lanes[2] * f13_x_p3764_lanes[2] -
      f13_x_p4045_lanes[2] * f13_x_p3982_lanes[2] - f13_x_p4124_lanes[2] * f13_x_p4070_lanes[2] -
      f13_x_p4175 * f13_x_p4142_lanes[2];

  // link 4 (chest1), outward
  const Real wd4_x = w3_z * qd[3];

  // link 1 (calf), force propagation
  const Real f13_x_p4190 = f13_x_p4107 - f13_x_p3886_lanes[3] * f13_x_p3764_lanes[2] -
      f13_x_p4045_lanes[3] * f13_x_p3982_lanes[2] - f13_x_p4124_lanes[3] * f13_x_p4070_lanes[2] -
      f13_x_p4176 * f13_x_p4142_lanes[2];

  // link 5 (chest2), outward
  const Real w5_z = c4 * w3_z + qd[4];
  const Real w5_x = c5 * w5_x_p1 - s5 * qd[3];
  const Real a6_x_p1 = w5_z * w5_z;

  // link 3 (hip), outward
  const Real a3_x = inverse_D2_p9 * a3_x_p3 + inverse_D2_p7 * a3_x_p2;

  // link 1 (calf), force propagation
  const Real f13_x_p4199 = 1.0 / f13_x_p4189;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w5_x_p1 + c5 * qd[3];

  // link 3 (hip), outward
  const Real a3_y = inverse_D2_p9 * a3_x_p2 - inverse_D2_p7 * a3_x_p3;

  // link 5 (chest2), outward
  const Real a6_x_p2 = w5_x * w5_x;

  // link 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4200_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4185_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4173_lanes;
  const Lanes<2> f13_x_p4202_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4185_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4173_lanes;

  // link 5 (chest2), outward
  const Real wd5_x_p1 = c4 * wd4_x + s4 * wd3_z;
  const Real a5_y_p2 = a3_x + 0.21799999999999997 * wd3_z;
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * a5_y_p1;

  // link 6 (chest3), outward
  const Real a7_y_p1 = w6_z * w6_z;

  // link 5 (chest2), outward
  const Real wd6_x_p1 = w5_x * minus_w5_y;
  const Real a5_y_p4 = c4 * a5_y_p2;
  const Real a6_x_p3 = a6_x_p2 + a6_x_p1;
  const Real minus_a5_z = s4 * a5_y_p2;

  // link 6 (chest3), outward
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4210_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4200_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4187_lanes;

  // link 6 (chest3), outward
  const Real a7_y_p2 = w6_x * w6_y;
  const Real wd6_y_p1 = w6_x * w6_z;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4214_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4187_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4200_lanes;

  // link 5 (chest2), outward
  const Real wd5_z = qdd_0[4] - (s4 * wd4_x - c4 * wd3_z);
  const Real wd5_x = c5 * wd5_x_p1 - s5 * qdd_0[3] - minus_w5_y * qd[4];

  // link 6 (chest3), outward
  const Real wd6_x_p2 = w6_y * w6_z;

  // link 1 (calf), force propagation
  const Real f13_x_p4216 = f13_x_p4190 * f13_x_p4199;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p3 - s5 * a5_y_p4;

  // link 6 (chest3), outward
  const Real a7_y_p3 = w6_y * w6_y + a7_y_p1;

  // link 5 (chest2), outward
  const Real wd6_x_p3 = wd5_z - wd6_x_p1;
  const Real wd6_x_p4 = s5 * wd5_x_p1 + c5 * qdd_0[3] + (w5_z + qd[4]) * w5_x;
  const Real a6_x_p4 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real wd6_z = wd5_x + qdd_0[5];

  // link 5 (chest2), outward
  const Real a6_z_p1 = wd6_x_p1 + wd5_z;
  const Real a5_x = c5 * a5_y_p4 + s5 * a5_y_p3;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4219_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4210_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4202_lanes;

  // link 6 (chest3), outward
  const Real a6_x_p5 = a5_y + 0.072 * a6_x_p3;
  const Real a7_y_p4 = a7_y_p2 - wd6_z;
  const Real minus_a7_z_p1 = w6_x * w6_x;
  const Real minus_a7_z_p2 = a7_y_p2 + wd6_z;
  const Real wd6_x_p5 = c6 * wd6_x_p4 - s6 * wd6_x_p3;
  const Real a6_x_p6 = minus_a5_z + 0.072 * a6_x_p4;
  const Real a6_z = a5_x + 0.072 * a6_z_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = minus_a7_z_p1 + a7_y_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;

  // link 6 (chest3), outward
  const Real wd6_x = wd6_x_p2 - wd6_x_p5;
  const Real wd6_y = c6 * wd6_x_p3 + s6 * wd6_x_p4 - wd6_y_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 6 (chest3), outward
  const Real minus_a12_y_p3 = wd6_x_p2 + wd6_x;
  const Real a7_y_p6 = wd6_y_p1 - wd6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p4_lanes = w7_x_lanes * w7_y_lanes;
  const Lanes<2> wd7_z_lanes = wd6_y + detail::make_pack<Real>(qdd_0[6], qdd_0[13]);
  const Lanes<2> wd7_x_p2_lanes = w7_y_lanes * w7_z_lanes;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a6_x_p5 - s6 * a6_x_p6;
  const Real minus_a6_y = s6 * a6_x_p5 + c6 * a6_x_p6;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p7_lanes = minus_a12_y_p4_lanes + wd7_z_lanes;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p8 = a6_x + 0.226 * a7_y_p3;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;

  // link 14 (right_shoulder1), outward
  const Real minus_a7_z_p5 = minus_a6_y + 0.226 * minus_a7_z_p2;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p1_lanes = w8_z_lanes * w8_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p8_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p4 +
      detail::make_pack<Real>(c7, c14) * minus_a12_y_p3;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p9 = a6_z - 0.226 * a7_y_p6;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_x_p4_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p4 -
      detail::make_pack<Real>(s7, s14) * minus_a12_y_p3;
  const Lanes<2> a7_y_p10_lanes = a7_y_p8 + detail::make_pack<Real>(0.18, (-0.18)) * a7_y_p4;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a12_y_p11_lanes = w8_x_lanes * w8_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p5 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p3;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p2_lanes = w8_y_lanes * w8_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a12_y_p12_lanes = 2.0 * (w7_x_lanes * w7_z_lanes) - minus_a12_y_p8_lanes;
  const Lanes<2> a7_y_p11_lanes = a7_y_p9 + detail::make_pack<Real>(0.18, (-0.18)) * minus_a12_y_p3;
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
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p10_lanes -
      detail::make_pack<Real>(s7, s14) * a7_y_p11_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_p4_lanes = detail::make_pack<Real>(c8, c15) * minus_a12_y_p12_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a12_y_p7_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p10_lanes +
      detail::make_pack<Real>(c7, c14) * a7_y_p11_lanes;

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
  const Lanes<2> f13_x_p4233_lanes = 0.086 * detail::make_pack<Real>(c13, c20);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p33_lanes = minus_a12_y_p29_lanes + wd10_z_lanes;
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * minus_a12_y_p25_lanes;
  const Lanes<2> minus_a12_y_p34_lanes = detail::make_pack<Real>(s10, s17) * minus_a12_y_p23_lanes +
      detail::make_pack<Real>(c10, c17) * minus_a12_y_p28_lanes;
  const Lanes<2> minus_a12_y_p35_lanes = minus_a12_y_p31_lanes + minus_a12_y_p24_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4237_lanes = c1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) - s1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4241_lanes = s1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) + c1 *
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
  const Lanes<2> f13_x_p4251_lanes = w12_z_lanes * w12_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4253_lanes = inverse_D2_p9 * f13_x_p4237_lanes - inverse_D2_p7 *
      f13_x_p4241_lanes;
  const Lanes<2> f13_x_p4255_lanes = inverse_D2_p7 * f13_x_p4237_lanes + inverse_D2_p9 *
      f13_x_p4241_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a12_y_p41_lanes = detail::make_pack<Real>(c11, c18) * minus_a12_y_p33_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a12_y_p37_lanes;
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4257_lanes = w13_z_lanes * w13_z_lanes;
  const Lanes<2> f13_x_p4267_lanes = f13_x_p4251_lanes + f13_x_p4257_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4269_lanes = c4 * f13_x_p4253_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> f13_x_p4271_lanes = s4 * f13_x_p4253_lanes - c4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p44_lanes = a11_x_lanes - 0.269 * minus_a12_y_p41_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4283_lanes = s5 * f13_x_p4269_lanes + c5 * f13_x_p4255_lanes;
  const Lanes<2> f13_x_p4285_lanes = c5 * f13_x_p4269_lanes - s5 * f13_x_p4255_lanes;
  const Lanes<2> f13_x_p4287_lanes = 0.086 * detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p44_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p40_lanes;
  const Lanes<2> f13_x_p4297_lanes = minus_w12_y_lanes * w12_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4305_lanes = c6 * f13_x_p4283_lanes + s6 * f13_x_p4271_lanes;
  const Lanes<2> f13_x_p4307_lanes = s6 * f13_x_p4283_lanes - c6 * f13_x_p4271_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> f13_x_p4309_lanes = minus_w12_y_lanes * minus_w12_y_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4311_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4214_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4219_lanes + minus_a12_y_lanes +
      f13_x_p4267_lanes * f13_x_p4233_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> a12_z_p3_lanes = detail::make_pack<Real>(s11, s18) * minus_a12_y_p33_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a12_y_p37_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4323_lanes = f13_x_p4309_lanes + f13_x_p4257_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4329_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4305_lanes +
      detail::make_pack<Real>(s7, s14) * f13_x_p4285_lanes;
  const Lanes<2> f13_x_p4331_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p4285_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p4305_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_z_lanes = 0.269 * a12_z_p3_lanes - minus_a11_y_lanes;
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p44_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p40_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4337_lanes = minus_w12_y_lanes * w13_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4349_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4219_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4214_lanes - a12_x_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4351_lanes = w12_z_lanes * w13_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4353_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4329_lanes +
      detail::make_pack<Real>(c8, c15) * f13_x_p4307_lanes;
  const Lanes<2> f13_x_p4355_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p4307_lanes -
      detail::make_pack<Real>(c8, c15) * f13_x_p4329_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4357_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4202_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4210_lanes - a12_z_lanes + f13_x_p4323_lanes *
      f13_x_p4287_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_p3_lanes = w10_x_lanes * w10_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4367_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p4353_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p4331_lanes;
  const Lanes<2> f13_x_p4369_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p4353_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p4331_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd13_x_p1_lanes = w11_x_lanes * w11_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_p4_lanes = detail::make_pack<Real>(c10, c17) * minus_a12_y_p23_lanes -
      detail::make_pack<Real>(s10, s17) * minus_a12_y_p28_lanes;
  const Lanes<2> wd10_y_lanes = wd10_y_p4_lanes - wd10_y_p3_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4379_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4367_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p4355_lanes;
  const Lanes<2> f13_x_p4381_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p4355_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p4367_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_z_lanes = detail::make_pack<Real>(qdd_0[10], qdd_0[17]) - wd10_y_lanes;
  const Lanes<2> wd13_x_p6_lanes = wd13_x_p1_lanes - wd11_z_lanes;
  const Lanes<2> wd13_x_p7_lanes = a12_z_p3_lanes + 2.0 * (w11_y_lanes * w11_z_lanes);
  const Lanes<2> wd11_y_p1_lanes = w11_x_lanes * w11_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4391_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4379_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p4369_lanes;
  const Lanes<2> f13_x_p4393_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p4369_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p4379_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd13_y_p1_lanes = w12_x_lanes * minus_w12_y_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_y_lanes = minus_a12_y_p41_lanes - wd11_y_p1_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd13_x_p10_lanes = detail::make_pack<Real>(c12, c19) * wd13_x_p6_lanes -
      detail::make_pack<Real>(s12, s19) * wd13_x_p7_lanes;
  const Lanes<2> wd12_z_lanes = wd11_y_lanes + detail::make_pack<Real>(qdd_0[11], qdd_0[18]);

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4401_lanes = (f13_x_p4337_lanes + f13_x_p4393_lanes) * f13_x_p4233_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4403_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4391_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p4381_lanes;
  const Lanes<2> f13_x_p4405_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p4381_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p4391_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd13_x_p11_lanes = 2.0 * (w12_x_lanes * w12_z_lanes) - wd13_x_p10_lanes;
  const Lanes<2> wd13_y_p2_lanes = wd12_z_lanes - wd13_y_p1_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_x_lanes = f13_x_p4351_lanes - wd13_x_p11_lanes;
  const Lanes<2> wd13_y_lanes = wd13_y_p2_lanes + f13_x_p4337_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4413_lanes = (f13_x_p4297_lanes + f13_x_p4403_lanes) * f13_x_p4287_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p4415_lanes = (f13_x_p4297_lanes - f13_x_p4403_lanes) * f13_x_p4233_lanes;
  const Lanes<2> f13_x_p4417_lanes = (f13_x_p4351_lanes + f13_x_p4405_lanes) * f13_x_p4287_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4419_lanes = f13_x_p4405_lanes - wd13_x_lanes;
  const Lanes<2> f13_x_p4421_lanes = f13_x_p4393_lanes - wd13_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(s12, s19) * wd13_x_p6_lanes +
      detail::make_pack<Real>(c12, c19) * wd13_x_p7_lanes - f13_x_p4297_lanes;

  // link 24 (right_eye), outward
  const Real f13_x_p4423 = f13_x_p4311_lanes[0] + f13_x_p4413_lanes[0];

  // link 13 (left_hand), outward
  const Lanes<2> wd13_z_lanes = wd12_x_lanes + detail::make_pack<Real>(qdd_0[12], qdd_0[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p4424_lanes = f13_x_p4403_lanes - wd13_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4426 = f13_x_p4357_lanes[0] - f13_x_p2963_lanes[1] * f13_x_p4423 +
      f13_x_p4415_lanes[0];
  const Real f13_x_p4427 = f13_x_p4349_lanes[0] - f13_x_p2963_lanes[2] * f13_x_p4423 -
      f13_x_p3173_lanes[2] * f13_x_p4426 + f13_x_p4401_lanes[0] - f13_x_p4417_lanes[0];
  const Real f13_x_p4428 = f13_x_p4419_lanes[0] - f13_x_p2963_lanes[3] * f13_x_p4423 -
      f13_x_p3173_lanes[3] * f13_x_p4426 - f13_x_p3352_lanes[3] * f13_x_p4427;
  const Real f13_x_p4429 = f13_x_p4421_lanes[0] - f13_x_p2963_lanes[4] * f13_x_p4423 -
      f13_x_p3173_lanes[4] * f13_x_p4426 - f13_x_p3352_lanes[4] * f13_x_p4427 -
      f13_x_p3519_lanes[4] * f13_x_p4428;
  const Real f13_x_p4430 = f13_x_p4424_lanes[0] - f13_x_p2963_lanes[5] * f13_x_p4423 -
      f13_x_p3173_lanes[5] * f13_x_p4426 - f13_x_p3352_lanes[5] * f13_x_p4427 -
      f13_x_p3519_lanes[5] * f13_x_p4428;
  const Real f13_x_p4431 = f13_x_p4311_lanes[1] - f13_x_p2963_lanes[6] * f13_x_p4423 -
      f13_x_p3173_lanes[6] * f13_x_p4426 - f13_x_p3352_lanes[6] * f13_x_p4427 -
      f13_x_p3519_lanes[6] * f13_x_p4428;
  const Real f13_x_p4432 = f13_x_p4357_lanes[1] - f13_x_p2963_lanes[7] * f13_x_p4423 -
      f13_x_p3173_lanes[7] * f13_x_p4426 - f13_x_p3352_lanes[7] * f13_x_p4427 -
      f13_x_p3519_lanes[7] * f13_x_p4428;
  const Real f13_x_p4433 = f13_x_p4349_lanes[1] - f13_x_p2970_lanes[0] * f13_x_p4423 -
      f13_x_p3181_lanes[0] * f13_x_p4426 - f13_x_p3357_lanes[0] * f13_x_p4427 -
      f13_x_p3526_lanes[0] * f13_x_p4428;
  const Real f13_x_p4434 = f13_x_p4430 - f13_x_p3612_lanes[5] * f13_x_p4429;
  const Real f13_x_p4435 = f13_x_p4419_lanes[1] - f13_x_p2970_lanes[1] * f13_x_p4423 -
      f13_x_p3181_lanes[1] * f13_x_p4426 - f13_x_p3357_lanes[1] * f13_x_p4427 -
      f13_x_p3526_lanes[1] * f13_x_p4428;
  const Real f13_x_p4436 = f13_x_p4431 - f13_x_p3612_lanes[6] * f13_x_p4429 - f13_x_p3736 *
      f13_x_p4434 + f13_x_p4413_lanes[1];
  const Real f13_x_p4437 = f13_x_p4421_lanes[1] - f13_x_p2970_lanes[2] * f13_x_p4423 -
      f13_x_p3181_lanes[2] * f13_x_p4426 - f13_x_p3357_lanes[2] * f13_x_p4427 -
      f13_x_p3526_lanes[2] * f13_x_p4428;
  const Real f13_x_p4438 = f13_x_p4432 - f13_x_p3612_lanes[7] * f13_x_p4429 - f13_x_p3741 *
      f13_x_p4434 - f13_x_p3893 * f13_x_p4436 + f13_x_p4415_lanes[1];
  const Real f13_x_p4439 = f13_x_p4424_lanes[1] - f13_x_p2970_lanes[3] * f13_x_p4423 -
      f13_x_p3181_lanes[3] * f13_x_p4426 - f13_x_p3357_lanes[3] * f13_x_p4427 -
      f13_x_p3526_lanes[3] * f13_x_p4428;

  // link 3 (hip), force propagation
  const Real f13_x_p4440 = f13_x_p3509_lanes[1] + f13_x_p2041_lanes[3] * f13_x_p609_lanes[3] +
      f13_x_p2021_lanes[3] * f13_x_p705_lanes[3] + f13_x_p2013_lanes[3] * f13_x_p822_lanes[3] +
      f13_x_p2009_lanes[3] * f13_x_p889_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p4441 = f13_x_p4433 - f13_x_p3618_lanes[0] * f13_x_p4429 - f13_x_p3742_lanes[0] *
      f13_x_p4434 - f13_x_p3886_lanes[0] * f13_x_p4436 - f13_x_p4045_lanes[0] * f13_x_p4438;
  const Real f13_x_p4442 = f13_x_p4435 - f13_x_p3618_lanes[1] * f13_x_p4429 - f13_x_p3742_lanes[1] *
      f13_x_p4434 - f13_x_p3886_lanes[1] * f13_x_p4436 - f13_x_p4045_lanes[1] * f13_x_p4438;
  const Real f13_x_p4443 = f13_x_p4437 - f13_x_p3618_lanes[2] * f13_x_p4429 - f13_x_p3742_lanes[2] *
      f13_x_p4434 - f13_x_p3886_lanes[2] * f13_x_p4436 - f13_x_p4045_lanes[2] * f13_x_p4438;
  const Real f13_x_p4444 = f13_x_p4439 - f13_x_p3618_lanes[3] * f13_x_p4429 - f13_x_p3742_lanes[3] *
      f13_x_p4434 - f13_x_p3886_lanes[3] * f13_x_p4436 - f13_x_p4045_lanes[3] * f13_x_p4438;
  const Real f13_x_p4445 = f13_x_p4441 + f13_x_p4401_lanes[1] - f13_x_p4417_lanes[1];
  const Real f13_x_p4446 = f13_x_p4440 + f13_x_p2017_lanes[3] * f13_x_p1032_lanes[3] +
      f13_x_p1377_lanes[3] * f13_x_p1130_lanes[3] - f13_x_p2970_lanes[3] * f13_x_p2825_lanes[3] -
      f13_x_p3181_lanes[3] * f13_x_p3054_lanes[3];
  const Real f13_x_p4447 = f13_x_p4442 - f13_x_p4124_lanes[1] * f13_x_p4445;
  const Real f13_x_p4448 = f13_x_p4443 - f13_x_p4124_lanes[2] * f13_x_p4445 - f13_x_p4175 *
      f13_x_p4447;
  const Real f13_x_p4449 = f13_x_p4446 - f13_x_p3357_lanes[3] * f13_x_p3256_lanes[3] -
      f13_x_p3526_lanes[3] * f13_x_p3420_lanes[3] - f13_x_p3618_lanes[3] * f13_x_p3578_lanes[3] -
      f13_x_p3742_lanes[3] * f13_x_p3702_lanes[3];
  const Real f13_x_p4450 = f13_x_p4449 - f13_x_p3886_lanes[3] * f13_x_p3764_lanes[3] -
      f13_x_p4045_lanes[3] * f13_x_p3982_lanes[3] - f13_x_p4124_lanes[3] * f13_x_p4070_lanes[3] -
      f13_x_p4176 * f13_x_p4142_lanes[3];
  const Real f13_x_p4451 = (f13_x_p4444 - f13_x_p4124_lanes[3] * f13_x_p4445 - f13_x_p4176 *
      f13_x_p4447 - f13_x_p4216 * f13_x_p4448) * (1.0 / (f13_x_p4450 - f13_x_p4216 * f13_x_p4190));
  const Real f13_x_p4452 = f13_x_p4448 * f13_x_p4199 - f13_x_p4216 * f13_x_p4451;
  const Real f13_x_p4453 = f13_x_p4447 * f13_x_p4150 - f13_x_p4175 * f13_x_p4452 - f13_x_p4176 *
      f13_x_p4451;
  const Real f13_x_p4454 = f13_x_p4445 * f13_x_p4084 - f13_x_p4124_lanes[1] * f13_x_p4453 -
      f13_x_p4124_lanes[2] * f13_x_p4452 - f13_x_p4124_lanes[3] * f13_x_p4451;
  const Real f13_x_p4455 = f13_x_p4438 * f13_x_p4015 - f13_x_p4045_lanes[0] * f13_x_p4454 -
      f13_x_p4045_lanes[1] * f13_x_p4453 - f13_x_p4045_lanes[2] * f13_x_p4452 -
      f13_x_p4045_lanes[3] * f13_x_p4451;
  const Real f13_x_p4456 = f13_x_p4436 * f13_x_p3817 - f13_x_p3893 * f13_x_p4455 -
      f13_x_p3886_lanes[0] * f13_x_p4454 - f13_x_p3886_lanes[1] * f13_x_p4453 -
      f13_x_p3886_lanes[2] * f13_x_p4452;
  const Real f13_x_p4457 = f13_x_p4456 - f13_x_p3886_lanes[3] * f13_x_p4451;
  const Real f13_x_p4458 = f13_x_p4434 * f13_x_p3689 - f13_x_p3736 * f13_x_p4457 - f13_x_p3741 *
      f13_x_p4455 - f13_x_p3742_lanes[0] * f13_x_p4454 - f13_x_p3742_lanes[1] * f13_x_p4453;
  const Real f13_x_p4459 = f13_x_p4458 - f13_x_p3742_lanes[2] * f13_x_p4452 - f13_x_p3742_lanes[3] *
      f13_x_p4451;
  const Real f13_x_p4460 = f13_x_p4429 * f13_x_p3570 - f13_x_p3612_lanes[5] * f13_x_p4459 -
      f13_x_p3612_lanes[6] * f13_x_p4457 - f13_x_p3612_lanes[7] * f13_x_p4455 -
      f13_x_p3618_lanes[0] * f13_x_p4454;
  const Real f13_x_p4461 = f13_x_p4460 - f13_x_p3618_lanes[1] * f13_x_p4453 - f13_x_p3618_lanes[2] *
      f13_x_p4452 - f13_x_p3618_lanes[3] * f13_x_p4451;
  const Real f13_x_p4462 = f13_x_p4428 * f13_x_p3448 - f13_x_p3519_lanes[4] * f13_x_p4461 -
      f13_x_p3519_lanes[5] * f13_x_p4459 - f13_x_p3519_lanes[6] * f13_x_p4457 -
      f13_x_p3519_lanes[7] * f13_x_p4455;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p4463_lanes = f13_x_p4297_lanes + wd13_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_x_p4466_lanes = f13_x_p4267_lanes * inverse_D10_p6_lanes + f13_x_p4463_lanes *
      inverse_D10_p5_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4467 = f13_x_p4462 - f13_x_p3526_lanes[0] * f13_x_p4454 - f13_x_p3526_lanes[1] *
      f13_x_p4453 - f13_x_p3526_lanes[2] * f13_x_p4452 - f13_x_p3526_lanes[3] * f13_x_p4451;

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p1_lanes = f13_x_p4351_lanes + wd13_x_lanes;
  const Lanes<2> f13_z_p2_lanes = f13_x_p4337_lanes + wd13_y_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_y_p5_lanes = 0.0025100003499999995 * wd13_y_p2_lanes - 0.0006000000000000001 *
      (w12_x_lanes * w12_x_lanes + f13_x_p4251_lanes);

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_x_p2_lanes = wd13_y_p1_lanes + wd12_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_p5_lanes = f13_z_p1_lanes * inverse_D10_p5_lanes - f13_z_p2_lanes *
      inverse_D10_p6_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_x_p1_lanes = w11_y_lanes * w11_y_lanes;
  const Lanes<2> f11_x_p2_lanes = w11_z_lanes * w11_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_x_p5_lanes = 0.0025100003499999995 * (f13_x_p4309_lanes + f13_x_p4251_lanes) +
      0.0006000000000000001 * f12_x_p2_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4468 = f13_x_p4427 * f13_x_p3282 - f13_x_p3352_lanes[3] * f13_x_p4467 -
      f13_x_p3352_lanes[4] * f13_x_p4461 - f13_x_p3352_lanes[5] * f13_x_p4459 -
      f13_x_p3352_lanes[6] * f13_x_p4457;

  // link 13 (left_hand), outward
  const Lanes<2> f13_y_p1_lanes = wd13_z_lanes - f13_x_p4297_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_z_p2_lanes = wd12_x_lanes - f13_x_p4297_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_x_p6_lanes = detail::make_pack<Real>(0.001, (-0.001)) * wd13_x_p6_lanes -
      6e-04 * (f11_x_p1_lanes + f11_x_p2_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_y_p1_lanes = wd13_x_p1_lanes + wd11_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_y_p4_lanes = f13_y_p1_lanes * inverse_D10_p6_lanes - f13_x_p4323_lanes *
      inverse_D10_p5_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_y_p2_lanes = w11_x_lanes * w11_x_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_z_p4_lanes = 0.0025100003499999995 * wd13_x_p11_lanes + 0.0006000000000000001 *
      f12_z_p2_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4469 = f13_x_p4468 - f13_x_p3352_lanes[7] * f13_x_p4455 - f13_x_p3357_lanes[0] *
      f13_x_p4454 - f13_x_p3357_lanes[1] * f13_x_p4453 - f13_x_p3357_lanes[2] * f13_x_p4452;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p1_lanes = wd10_y_p3_lanes - wd10_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4470 = f13_x_p4469 - f13_x_p3357_lanes[3] * f13_x_p4451;

  // link 24 (right_eye), inertial wrench
  const Real f13_z = f13_z_p5_lanes[0] + f13_x_p4470;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_y_p6_lanes = 6e-04 * f11_y_p1_lanes -
      detail::make_pack<Real>(0.001, (-0.001)) * (f11_y_p2_lanes + f11_x_p2_lanes);

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - f12_x_p5_lanes[0];

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_z_p4_lanes = 0.0014999985000000002 * f10_z_p1_lanes + 0.28049749700000004 *
      minus_a12_y_p37_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p7_lanes = (f13_x_p4257_lanes - f13_x_p4251_lanes) * inverse_D12_p5_lanes;
  const Lanes<2> n13_x_p9_lanes = f13_z_p1_lanes * inverse_D11_p9_lanes - f13_z_p2_lanes *
      inverse_D11_p7_lanes - f13_y_p1_lanes * inverse_D11_p3_lanes + n13_x_p7_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4471 = f13_x_p4426 * f13_x_p3079 - f13_x_p3173_lanes[2] * f13_x_p4470 -
      f13_x_p3173_lanes[3] * f13_x_p4467 - f13_x_p3173_lanes[4] * f13_x_p4461 -
      f13_x_p3173_lanes[5] * f13_x_p4459;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n13_z_p6_lanes = f13_x_p4251_lanes - f13_x_p4309_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p10_lanes = n13_x_p9_lanes + inverse_D10_p5_lanes * a12_x_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_y_p5_lanes = 0.000195227662257343 * wd13_x_p11_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * f12_x_p2_lanes +
      0.0025100003499999995 * a12_z_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n13_x = n13_x_p10_lanes[0] + f13_x_p4467;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p11_lanes = inverse_D10_p6_lanes * a12_z_lanes + inverse_D10_p5_lanes *
      minus_a12_y_lanes;
  const Lanes<2> n13_z_p12_lanes = 0.0009386316083993107 * wd13_z_lanes - f13_x_p4297_lanes *
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
  const Real f13_x_p4472 = f13_x_p4471 - f13_x_p3173_lanes[6] * f13_x_p4457 - f13_x_p3173_lanes[7] *
      f13_x_p4455 - f13_x_p3181_lanes[0] * f13_x_p4454 - f13_x_p3181_lanes[1] * f13_x_p4453;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p7_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (f11_x_p2_lanes - f11_x_p1_lanes);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p15_lanes = n13_z_p12_lanes - wd13_y_p2_lanes * inverse_D12_p5_lanes +
      n13_z_p6_lanes * inverse_D11_p7_lanes + n13_z_p11_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p4_lanes = 0.0025100003499999995 * minus_a12_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4473 = f13_x_p4472 - f13_x_p3181_lanes[2] * f13_x_p4452 - f13_x_p3181_lanes[3] *
      f13_x_p4451;

  // link 24 (right_eye), inertial wrench
  const Real n13_z = n13_z_p15_lanes[0] + f13_x_p4459;
  tau[12] = n13_z;
  const Real f13_y = f13_y_p4_lanes[0] + f13_x_p4473;

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
  const Real f13_x_p4474 = f13_x_p4423 * f13_x_p2893 - f13_x_p2963_lanes[1] * f13_x_p4473 -
      f13_x_p2963_lanes[2] * f13_x_p4470 - f13_x_p2963_lanes[3] * f13_x_p4467 -
      f13_x_p2963_lanes[4] * f13_x_p4461;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p16_lanes = n12_z_p13_lanes + f13_z_p2_lanes * inverse_D12_p10_lanes -
      f13_x_p4463_lanes * inverse_D12_p5_lanes - f13_z_p1_lanes * inverse_D11_p7_lanes;

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
  const Lanes<2> n12_z_p17_lanes = n12_z_p16_lanes + (f13_x_p4309_lanes - f13_x_p4257_lanes) *
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
  const Real n12_z = n12_z_p17_lanes[0] + f13_x_p4461 - n12_z_p11_lanes[0];
  tau[11] = n12_z;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p8_lanes = 0.00028099984685315 * f10_z_p1_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * minus_a12_y_p33_lanes +
      0.0001499998887063 * minus_a12_y_p37_lanes;
  const Lanes<2> n10_x_p12_lanes = n10_x_p11_lanes - 0.28049749700000004 * minus_a10_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p4475 = f13_x_p4474 - f13_x_p2963_lanes[5] * f13_x_p4459 - f13_x_p2963_lanes[6] *
      f13_x_p4457 - f13_x_p2963_lanes[7] * f13_x_p4455 - f13_x_p2970_lanes[0] * f13_x_p4454;

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
  const Real f13_x = f13_x_p4475 - f13_x_p2970_lanes[1] * f13_x_p4453 - f13_x_p2970_lanes[2] *
      f13_x_p4452 - f13_x_p2970_lanes[3] * f13_x_p4451 - f13_x_p4466_lanes[0];

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
  const Lanes<2> n7_y_p1_lanes = minus_a12_y_p4_lanes - wd7_z_lanes;

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
  const Real f20_x = f13_x_p4457 - f13_x_p4466_lanes[1];

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_y_p4_lanes = 0.7139200499999999 * minus_a12_y_p15_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (n8_z_p5_lanes + a10_x_p1_lanes);
  const Lanes<2> f8_x_p3_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p2_lanes - 0.7139200499999999 * a10_x_p3_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f20_z = f13_z_p5_lanes[1] + f13_x_p4454;

  // link 10 (left_lowerarm), inward
  const Real f9_z = f9_z_p3_lanes[0] - (s10 * f10_x + c10 * f10_y);

  // link 24 (right_eye), inertial wrench
  const Real f20_y = f13_y_p4_lanes[1] + f13_x_p4455;

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
  const Real n20_x = n13_x_p10_lanes[1] + f13_x_p4453;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p11_lanes = n7_y_p10_lanes + n7_x_p7_lanes;

  // link 20 (right_hand), inward
  const Real f19_z = f12_z_p4_lanes[1] + f20_y;

  // link 24 (right_eye), inertial wrench
  const Real n20_z = n13_z_p15_lanes[1] + f13_x_p4451;
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
  const Real n19_z = n12_z_p17_lanes[1] + f13_x_p4452 - n12_z_p11_lanes[1];
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
  const Lanes<2> n7_z_p11_lanes = 0.00014700000000000002 * minus_a12_y_p4_lanes + 0.000448 *
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
  const Real n6_x_p3 = 0.40041499999999997 * minus_a12_y_p3 + 0.0187369177636143 * minus_a7_z_p2 -
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
  const Real f5_y = 0.069699984375 * wd6_x_p3 + 2.2194301519999997 * a6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_z = 0.069699984375 * wd6_x_p4 - 2.2194301519999997 * a6_x_p4 + n5_x_p1;
  const Real n5_y = 0.005678398088837119 * a6_x_p4 - 0.04675382692737882 * wd6_x_p4 +
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
  const Real n5_x = 0.15637308509675518 * a6_x_p4 - 0.005678398088837119 * wd6_x_p4 +
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
