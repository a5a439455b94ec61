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
  const Lanes<2> f13_x_p5_lanes = detail::make_pack<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.001742099791326752, 0.001742099791326752) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p7_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5_lanes;
  const Lanes<2> f13_x_p9_lanes = 0.0006340258712020409 + f13_x_p7_lanes;
  const Lanes<2> inverse_D12_p3_lanes = detail::make_pack<Real>((-0.0007660844555829042),
      (-0.0007660844555829042)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.0002628975791811551, (-0.0002628975791811551)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p4_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p3_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (inverse_D12_p4_lanes -
      detail::make_pack<Real>((-0.0010519177038056625), (-0.0010519177038056625)));
  const Lanes<2> f13_x_p11_lanes = f13_x_p9_lanes * inverse_D12_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> f13_x_p15_lanes = detail::make_pack<Real>((-0.00013384878959057754),
      0.00013384878959057754) + detail::make_pack<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> f13_x_p19_lanes = detail::make_pack<Real>(s13, s20) * f13_x_p5_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p23_lanes = detail::make_pack<Real>((-0.00033044389597753786),
      0.00033044389597753786) + f13_x_p19_lanes + f13_x_p15_lanes * f13_x_p11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> f13_x_p33_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(s13, s20) - 0.01626499875 * detail::make_pack<Real>(c13, c20) -
      0.0006000000000000001;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p35_lanes = f13_x_p33_lanes * inverse_D12_lanes;
  const Lanes<2> f13_x_p45_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(c13, c20) + 0.01626499875 * detail::make_pack<Real>(s13, s20) -
      f13_x_p15_lanes * f13_x_p35_lanes;
  const Lanes<2> f13_x_p49_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p23_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p45_lanes;
  const Lanes<2> f13_x_p51_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p49_lanes;
  const Lanes<2> f13_x_p53_lanes = detail::make_pack<Real>(0.001, (-0.001)) + f13_x_p51_lanes;
  const Lanes<2> inverse_D11_p1_lanes = f13_x_p15_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D11_p4_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes -
      f13_x_p15_lanes * inverse_D11_p1_lanes;
  const Lanes<2> inverse_D11_p6_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p4_lanes);
  const Lanes<2> inverse_D11_p7_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p6_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p4_lanes + inverse_D11_p7_lanes));
  const Lanes<2> f13_x_p55_lanes = f13_x_p53_lanes * inverse_D11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> f13_x_p59_lanes = f13_x_p19_lanes -
      detail::make_pack<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p61_lanes = f13_x_p59_lanes * inverse_D12_lanes;
  const Lanes<2> f13_x_p67_lanes = f13_x_p7_lanes -
      detail::make_pack<Real>(0.002376125662528793, 0.002376125662528793) - f13_x_p15_lanes *
      f13_x_p61_lanes;
  const Lanes<2> f13_x_p73_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * f13_x_p67_lanes;
  const Lanes<2> f13_x_p79_lanes = 0.000144 - (detail::make_pack<Real>(c12, c19) *
      inverse_D11_p6_lanes + 0.269 * f13_x_p73_lanes);
  const Lanes<2> f13_x_p83_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p49_lanes;
  const Lanes<2> f13_x_p85_lanes = f13_x_p33_lanes * f13_x_p61_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> f13_x_p95_lanes = detail::make_pack<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.27310176737964387), (-0.27310176737964387)) *
      detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p101_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p95_lanes -
      detail::make_pack<Real>((-0.04964593582762564), 0.04964593582762564) - f13_x_p9_lanes *
      f13_x_p61_lanes;
  const Lanes<2> f13_x_p105_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p85_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p101_lanes;
  const Lanes<2> f13_x_p107_lanes = 0.269 * f13_x_p105_lanes;
  const Lanes<2> f13_x_p109_lanes = f13_x_p83_lanes + f13_x_p107_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p111_lanes = f13_x_p79_lanes * f13_x_p55_lanes - f13_x_p109_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p115_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      f13_x_p51_lanes;
  const Lanes<2> f13_x_p117_lanes = 6e-04 - f13_x_p73_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p119_lanes = f13_x_p117_lanes * inverse_D11_lanes;
  const Lanes<2> f13_x_p123_lanes = f13_x_p107_lanes - f13_x_p115_lanes * f13_x_p119_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> f13_x_p133_lanes = detail::make_pack<Real>(s13, s20) * f13_x_p95_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p137_lanes = detail::make_pack<Real>(0.008744893195371809,
      0.008744893195371809) + f13_x_p133_lanes + f13_x_p9_lanes * f13_x_p11_lanes;
  const Lanes<2> f13_x_p139_lanes = f13_x_p33_lanes * f13_x_p35_lanes;
  const Lanes<2> f13_x_p145_lanes = f13_x_p33_lanes * f13_x_p11_lanes;
  const Lanes<2> f13_x_p151_lanes = detail::make_pack<Real>(c12, c19) * (2.0 * f13_x_p145_lanes) -
      detail::make_pack<Real>(s12, s19) * (f13_x_p137_lanes - f13_x_p139_lanes);
  const Lanes<2> f13_x_p153_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p151_lanes;
  const Lanes<2> f13_x_p155_lanes = f13_x_p153_lanes - f13_x_p139_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p159_lanes = f13_x_p115_lanes * f13_x_p55_lanes - 0.269 * f13_x_p155_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p167_lanes = f13_x_p133_lanes - 0.2818466605750157 - f13_x_p59_lanes *
      f13_x_p61_lanes;
  const Lanes<2> f13_x_p175_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p67_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> f13_x_p177_lanes = 0.269 * f13_x_p167_lanes - f13_x_p175_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p179_lanes = f13_x_p177_lanes - f13_x_p79_lanes * f13_x_p119_lanes;
  const Lanes<2> f13_x_p185_lanes = detail::make_pack<Real>(s11, s18) *
      (f13_x_p111_lanes - f13_x_p123_lanes) + detail::make_pack<Real>(c11, c18) *
      (f13_x_p159_lanes + f13_x_p179_lanes);
  const Lanes<2> f13_x_p187_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p185_lanes;
  const Lanes<2> f13_x_p189_lanes = f13_x_p123_lanes + f13_x_p187_lanes;
  const Lanes<2> inverse_D10_p1_lanes = f13_x_p79_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p7_lanes = 0.000131 - inverse_D11_p7_lanes + 0.269 *
      (f13_x_p177_lanes - f13_x_p175_lanes) - f13_x_p79_lanes * inverse_D10_p1_lanes;
  const Lanes<2> inverse_D10_p8_lanes = f13_x_p115_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p12_lanes = 0.0001098 + 0.07236100000000001 * f13_x_p155_lanes -
      f13_x_p115_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p18_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      f13_x_p109_lanes - f13_x_p79_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p19_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> inverse_D10_p21_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p7_lanes - inverse_D10_p12_lanes) + inverse_D10_p19_lanes *
      inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p22_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p21_lanes;
  const Lanes<2> inverse_D10_p24_lanes = 0.060888541114265754 +
      (inverse_D10_p12_lanes + inverse_D10_p22_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p24_lanes;
  const Lanes<2> f13_x_p191_lanes = f13_x_p189_lanes * inverse_D10_lanes;
  const Lanes<2> f13_x_p195_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * f13_x_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p203_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p21_lanes -
      inverse_D10_p18_lanes);
  const Lanes<2> f13_x_p207_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p185_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p213_lanes = 0.28049749700000004 + (f13_x_p207_lanes - f13_x_p159_lanes) -
      f13_x_p203_lanes * f13_x_p191_lanes;
  const Lanes<2> f13_x_p217_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p195_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p213_lanes;
  const Lanes<2> f13_x_p221_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p24_lanes;
  const Lanes<2> f13_x_p225_lanes = 0.0001499998887063 + f13_x_p203_lanes * f13_x_p221_lanes;
  const Lanes<2> f13_x_p227_lanes = 2.0 * detail::make_pack<Real>(c10, c17);
  const Lanes<2> f13_x_p231_lanes = f13_x_p203_lanes * inverse_D10_lanes;
  const Lanes<2> f13_x_p239_lanes = 0.06060754126741261 +
      (inverse_D10_p7_lanes - inverse_D10_p22_lanes) - f13_x_p203_lanes * f13_x_p231_lanes;
  const Lanes<2> f13_x_p243_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p24_lanes;
  const Lanes<2> f13_x_p249_lanes = f13_x_p227_lanes * f13_x_p225_lanes -
      detail::make_pack<Real>(s10, s17) * (f13_x_p239_lanes - f13_x_p243_lanes);
  const Lanes<2> f13_x_p257_lanes = 0.282 * f13_x_p217_lanes -
      (f13_x_p225_lanes - detail::make_pack<Real>(c10, c17) * f13_x_p249_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D9_p1_lanes = detail::make_pack<Real>(s10, s17) * f13_x_p249_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (f13_x_p243_lanes - inverse_D9_p1_lanes));
  const Lanes<2> f13_x_p259_lanes = f13_x_p257_lanes * inverse_D9_lanes;
  const Lanes<2> f13_x_p261_lanes = f13_x_p257_lanes * f13_x_p259_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p267_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p213_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p195_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p273_lanes = f13_x_p155_lanes - f13_x_p53_lanes * f13_x_p55_lanes;
  const Lanes<2> f13_x_p277_lanes = f13_x_p167_lanes - f13_x_p117_lanes * f13_x_p119_lanes;
  const Lanes<2> f13_x_p285_lanes = f13_x_p53_lanes * f13_x_p119_lanes - f13_x_p105_lanes;
  const Lanes<2> f13_x_p289_lanes = detail::make_pack<Real>(s11, s18) *
      (f13_x_p273_lanes - f13_x_p277_lanes) + inverse_D10_p19_lanes * f13_x_p285_lanes;
  const Lanes<2> f13_x_p291_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p289_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p295_lanes = f13_x_p277_lanes + f13_x_p291_lanes - f13_x_p189_lanes *
      f13_x_p191_lanes;
  const Lanes<2> f13_x_p299_lanes = f13_x_p267_lanes + 0.282 * f13_x_p295_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p311_lanes = 0.0019585440854647937 +
      (f13_x_p239_lanes + inverse_D9_p1_lanes + 0.282 * (f13_x_p267_lanes + f13_x_p299_lanes)) -
      f13_x_p261_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p315_lanes = f13_x_p207_lanes - f13_x_p179_lanes - 0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p317_lanes = f13_x_p315_lanes * inverse_D10_lanes;
  const Lanes<2> f13_x_p319_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * f13_x_p317_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p325_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p85_lanes -
      detail::make_pack<Real>(c12, c19) * f13_x_p101_lanes;
  const Lanes<2> f13_x_p335_lanes = f13_x_p83_lanes - f13_x_p23_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p337_lanes = f13_x_p335_lanes * inverse_D11_lanes;
  const Lanes<2> f13_x_p341_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      (0.269 * f13_x_p325_lanes - (f13_x_p51_lanes - f13_x_p45_lanes)) - f13_x_p79_lanes *
      f13_x_p337_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> f13_x_p349_lanes = f13_x_p145_lanes - detail::make_pack<Real>(c12, c19) *
      f13_x_p151_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p355_lanes = 0.269 * f13_x_p349_lanes - 6e-04 - f13_x_p115_lanes *
      f13_x_p337_lanes;
  const Lanes<2> f13_x_p361_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * f13_x_p341_lanes + detail::make_pack<Real>(c11, c18) *
      f13_x_p355_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p363_lanes = f13_x_p361_lanes * inverse_D10_lanes;
  const Lanes<2> f13_x_p373_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p341_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p355_lanes + f13_x_p203_lanes * f13_x_p363_lanes;
  const Lanes<2> f13_x_p383_lanes = f13_x_p111_lanes - f13_x_p187_lanes - f13_x_p203_lanes *
      f13_x_p317_lanes;
  const Lanes<2> f13_x_p385_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * f13_x_p363_lanes;
  const Lanes<2> f13_x_p391_lanes = detail::make_pack<Real>(c10, c17) *
      (f13_x_p319_lanes + f13_x_p373_lanes) - detail::make_pack<Real>(s10, s17) *
      (f13_x_p383_lanes + f13_x_p385_lanes);
  const Lanes<2> f13_x_p393_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p391_lanes;
  const Lanes<2> f13_x_p395_lanes = f13_x_p373_lanes - f13_x_p393_lanes;
  const Lanes<2> f13_x_p399_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * f13_x_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p401_lanes = f13_x_p399_lanes * inverse_D9_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> f13_x_p409_lanes = f13_x_p53_lanes * f13_x_p337_lanes - f13_x_p349_lanes;
  const Lanes<2> f13_x_p415_lanes = f13_x_p325_lanes - f13_x_p117_lanes * f13_x_p337_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p421_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p409_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p415_lanes + f13_x_p315_lanes * f13_x_p363_lanes;
  const Lanes<2> f13_x_p429_lanes = f13_x_p273_lanes - f13_x_p291_lanes - f13_x_p315_lanes *
      f13_x_p317_lanes;
  const Lanes<2> f13_x_p439_lanes = f13_x_p137_lanes + f13_x_p153_lanes + f13_x_p335_lanes *
      f13_x_p337_lanes + f13_x_p361_lanes * f13_x_p363_lanes;
  const Lanes<2> f13_x_p445_lanes = f13_x_p227_lanes * f13_x_p421_lanes -
      detail::make_pack<Real>(s10, s17) * (f13_x_p429_lanes + f13_x_p439_lanes);
  const Lanes<2> f13_x_p447_lanes = detail::make_pack<Real>(s10, s17) * f13_x_p445_lanes;
  const Lanes<2> f13_x_p449_lanes = f13_x_p429_lanes + f13_x_p447_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p455_lanes = 0.0008177492704690715 + 0.07952399999999998 * f13_x_p449_lanes -
      f13_x_p399_lanes * f13_x_p401_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p463_lanes = detail::make_pack<Real>(s10, s17) * f13_x_p391_lanes;
  const Lanes<2> f13_x_p473_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p289_lanes -
      f13_x_p285_lanes - f13_x_p315_lanes * f13_x_p191_lanes;
  const Lanes<2> f13_x_p485_lanes = detail::make_pack<Real>(s11, s18) * f13_x_p409_lanes +
      detail::make_pack<Real>(c11, c18) * f13_x_p415_lanes + f13_x_p361_lanes * f13_x_p191_lanes;
  const Lanes<2> f13_x_p489_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p473_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p485_lanes;
  const Lanes<2> f13_x_p491_lanes = 0.282 * f13_x_p489_lanes;
  const Lanes<2> f13_x_p493_lanes = f13_x_p383_lanes + f13_x_p463_lanes + f13_x_p491_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p499_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * f13_x_p493_lanes - f13_x_p257_lanes * f13_x_p401_lanes;
  const Lanes<2> f13_x_p501_lanes = 2.0 * detail::make_pack<Real>(s9, s16);
  const Lanes<2> f13_x_p505_lanes = detail::make_pack<Real>(c9, c16) *
      (f13_x_p311_lanes - f13_x_p455_lanes) - f13_x_p501_lanes * f13_x_p499_lanes;
  const Lanes<2> f13_x_p511_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * f13_x_p505_lanes + f13_x_p499_lanes);
  const Lanes<2> inverse_D8_p1_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p505_lanes;
  const Lanes<2> inverse_D8_p3_lanes = 0.18125194219699997 +
      (f13_x_p455_lanes + inverse_D8_p1_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p3_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p513_lanes = f13_x_p385_lanes + f13_x_p463_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p515_lanes = f13_x_p513_lanes * inverse_D9_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p523_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p485_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p473_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p533_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * f13_x_p523_lanes - (f13_x_p319_lanes - f13_x_p393_lanes)) + f13_x_p257_lanes *
      f13_x_p515_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p541_lanes = f13_x_p421_lanes - detail::make_pack<Real>(c10, c17) *
      f13_x_p445_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p547_lanes = 0.0022500062 + 0.282 * f13_x_p541_lanes + f13_x_p399_lanes *
      f13_x_p515_lanes;
  const Lanes<2> f13_x_p553_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * f13_x_p533_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p547_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p555_lanes = f13_x_p553_lanes * inverse_D8_lanes;
  const Lanes<2> f13_x_p565_lanes = f13_x_p511_lanes * f13_x_p555_lanes -
      (detail::make_pack<Real>(s9, s16) * f13_x_p533_lanes + detail::make_pack<Real>(c9, c16) *
      f13_x_p547_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p567_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      f13_x_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p569_lanes = f13_x_p567_lanes * inverse_D9_lanes;
  const Lanes<2> f13_x_p573_lanes = f13_x_p493_lanes + f13_x_p257_lanes * f13_x_p569_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> f13_x_p575_lanes = f13_x_p217_lanes - 0.0022500062;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p577_lanes = f13_x_p575_lanes * inverse_D9_lanes;
  const Lanes<2> f13_x_p581_lanes = f13_x_p491_lanes + f13_x_p399_lanes * f13_x_p577_lanes;
  const Lanes<2> f13_x_p589_lanes = f13_x_p299_lanes - f13_x_p257_lanes * f13_x_p577_lanes;
  const Lanes<2> f13_x_p595_lanes = f13_x_p399_lanes * f13_x_p569_lanes - 0.282 * f13_x_p449_lanes;
  const Lanes<2> f13_x_p601_lanes = detail::make_pack<Real>(c9, c16) *
      (f13_x_p573_lanes + f13_x_p581_lanes) - detail::make_pack<Real>(s9, s16) *
      (f13_x_p595_lanes + f13_x_p589_lanes);
  const Lanes<2> f13_x_p603_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p601_lanes;
  const Lanes<2> f13_x_p607_lanes = 0.7139200499999999 + (f13_x_p603_lanes + f13_x_p589_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p609_lanes = f13_x_p607_lanes * inverse_D8_lanes;
  const Lanes<2> f13_x_p611_lanes = 0.00010499999999999999 * f13_x_p609_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p619_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p601_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p623_lanes = f13_x_p573_lanes - f13_x_p619_lanes - f13_x_p511_lanes *
      f13_x_p609_lanes;
  const Lanes<2> f13_x_p625_lanes = 0.00010499999999999999 * f13_x_p555_lanes;
  const Lanes<2> f13_x_p631_lanes = detail::make_pack<Real>(c8, c15) *
      (f13_x_p565_lanes + f13_x_p611_lanes) - detail::make_pack<Real>(s8, s15) *
      (f13_x_p625_lanes + f13_x_p623_lanes);
  const Lanes<2> f13_x_p633_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p631_lanes;
  const Lanes<2> f13_x_p637_lanes = 0.0017499999999999998 + (f13_x_p633_lanes - f13_x_p611_lanes);
  const Lanes<2> inverse_D7_p1_lanes = f13_x_p511_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p5_lanes = 0.18113119219699997 +
      (f13_x_p311_lanes - inverse_D8_p1_lanes) - f13_x_p511_lanes * inverse_D7_p1_lanes;
  const Lanes<2> inverse_D7_p7_lanes = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p3_lanes;
  const Lanes<2> inverse_D7_p11_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + 0.00010499999999999999 * inverse_D7_p1_lanes;
  const Lanes<2> inverse_D7_p12_lanes = 2.0 * detail::make_pack<Real>(c8, c15);
  const Lanes<2> inverse_D7_p14_lanes = detail::make_pack<Real>(s8, s15) *
      (inverse_D7_p7_lanes - inverse_D7_p5_lanes) + inverse_D7_p12_lanes * inverse_D7_p11_lanes;
  const Lanes<2> inverse_D7_p15_lanes = detail::make_pack<Real>(s8, s15) * inverse_D7_p14_lanes;
  const Lanes<2> inverse_D7_p17_lanes = 0.000448 + (inverse_D7_p5_lanes + inverse_D7_p15_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D7_lanes = 1.0 / inverse_D7_p17_lanes;
  const Lanes<2> f13_x_p639_lanes = f13_x_p637_lanes * inverse_D7_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p645_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p14_lanes -
      inverse_D7_p11_lanes);
  const Lanes<2> f13_x_p649_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p631_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p653_lanes = f13_x_p625_lanes + f13_x_p649_lanes + f13_x_p645_lanes *
      f13_x_p639_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p655_lanes = f13_x_p619_lanes - f13_x_p581_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p657_lanes = f13_x_p655_lanes * inverse_D8_lanes;
  const Lanes<2> f13_x_p661_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * f13_x_p657_lanes;
  const Lanes<2> f13_x_p671_lanes = f13_x_p603_lanes + f13_x_p595_lanes - 0.7139200499999999 -
      f13_x_p511_lanes * f13_x_p657_lanes;
  const Lanes<2> f13_x_p677_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * f13_x_p661_lanes + detail::make_pack<Real>(c8, c15) *
      f13_x_p671_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p679_lanes = f13_x_p677_lanes * inverse_D7_lanes;
  const Lanes<2> f13_x_p681_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * f13_x_p679_lanes;
  const Lanes<2> f13_x_p695_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p661_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p671_lanes - f13_x_p645_lanes * f13_x_p679_lanes;
  const Lanes<2> f13_x_p697_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * f13_x_p639_lanes;
  const Lanes<2> f13_x_p703_lanes = detail::make_pack<Real>(c7, c14) *
      (f13_x_p653_lanes - f13_x_p681_lanes) - detail::make_pack<Real>(s7, s14) *
      (f13_x_p695_lanes - f13_x_p697_lanes);
  const Lanes<2> f13_x_p705_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p703_lanes;
  const Lanes<2> f13_x_p707_lanes = f13_x_p697_lanes - f13_x_p705_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p715_lanes = f13_x_p449_lanes - f13_x_p567_lanes * f13_x_p569_lanes;
  const Lanes<2> f13_x_p719_lanes = f13_x_p295_lanes - f13_x_p575_lanes * f13_x_p577_lanes;
  const Lanes<2> f13_x_p727_lanes = f13_x_p489_lanes + f13_x_p567_lanes * f13_x_p577_lanes;
  const Lanes<2> f13_x_p731_lanes = detail::make_pack<Real>(c9, c16) *
      (f13_x_p715_lanes - f13_x_p719_lanes) - f13_x_p501_lanes * f13_x_p727_lanes;
  const Lanes<2> f13_x_p733_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p731_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p739_lanes = f13_x_p719_lanes + f13_x_p733_lanes - f13_x_p655_lanes *
      f13_x_p657_lanes - f13_x_p677_lanes * f13_x_p679_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> f13_x_p747_lanes = f13_x_p541_lanes + f13_x_p567_lanes * f13_x_p515_lanes;
  const Lanes<2> f13_x_p753_lanes = f13_x_p523_lanes + f13_x_p575_lanes * f13_x_p515_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p759_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p747_lanes -
      detail::make_pack<Real>(c9, c16) * f13_x_p753_lanes + f13_x_p553_lanes * f13_x_p609_lanes;
  const Lanes<2> f13_x_p767_lanes = f13_x_p715_lanes - f13_x_p733_lanes - f13_x_p607_lanes *
      f13_x_p609_lanes;
  const Lanes<2> f13_x_p777_lanes = f13_x_p439_lanes + f13_x_p447_lanes + f13_x_p513_lanes *
      f13_x_p515_lanes + f13_x_p553_lanes * f13_x_p555_lanes;
  const Lanes<2> f13_x_p783_lanes = inverse_D7_p12_lanes * f13_x_p759_lanes -
      detail::make_pack<Real>(s8, s15) * (f13_x_p777_lanes + f13_x_p767_lanes);
  const Lanes<2> f13_x_p785_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p783_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p789_lanes = f13_x_p777_lanes + f13_x_p785_lanes + f13_x_p637_lanes *
      f13_x_p639_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p805_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p747_lanes +
      detail::make_pack<Real>(s9, s16) * f13_x_p753_lanes + f13_x_p553_lanes * f13_x_p657_lanes;
  const Lanes<2> f13_x_p815_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p731_lanes +
      f13_x_p727_lanes - f13_x_p607_lanes * f13_x_p657_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p821_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p805_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p815_lanes - f13_x_p677_lanes * f13_x_p639_lanes;
  const Lanes<2> f13_x_p823_lanes = 2.0 * detail::make_pack<Real>(s7, s14);
  const Lanes<2> f13_x_p827_lanes = detail::make_pack<Real>(c7, c14) *
      (f13_x_p739_lanes + f13_x_p789_lanes) - f13_x_p823_lanes * f13_x_p821_lanes;
  const Lanes<2> f13_x_p829_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p827_lanes;
  const Lanes<2> f13_x_p831_lanes = f13_x_p739_lanes - f13_x_p829_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p835_lanes = f13_x_p623_lanes + f13_x_p649_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p837_lanes = f13_x_p835_lanes * inverse_D7_lanes;
  const Lanes<2> f13_x_p847_lanes = detail::make_pack<Real>(s8, s15) * f13_x_p805_lanes +
      detail::make_pack<Real>(c8, c15) * f13_x_p815_lanes - f13_x_p677_lanes * f13_x_p837_lanes;
  const Lanes<2> f13_x_p857_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p783_lanes -
      f13_x_p759_lanes - f13_x_p637_lanes * f13_x_p837_lanes;
  const Lanes<2> f13_x_p861_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p847_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p857_lanes;
  const Lanes<2> f13_x_p867_lanes = f13_x_p707_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * f13_x_p831_lanes + 0.226 * f13_x_p861_lanes);

  // link 23 (left_eye), articulated inertia
  const Lanes<2> f13_x_p869_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> f13_x_p871_lanes = detail::make_pack<Real>(c23, c24) * f13_x_p869_lanes;
  const Lanes<2> f13_x_p873_lanes = f13_x_p871_lanes - 0.0007770270270270272;
  const Real f13_x_p875 = 0.431222972972973 + f13_x_p871_lanes[1] + f13_x_p873_lanes[0];
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> inverse_D22_p3_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Real inverse_D22_p5 = inverse_D22_p3_lanes[1] + inverse_D22_p3_lanes[0];
  const Real inverse_D22_p6 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p5 + 4.75e-05 * inverse_D22_p6);
  const Real f13_x_p876 = f13_x_p875 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> f13_x_p879_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);
  const Real f13_x_p881 = s24 + s23;
  const Real f13_x_p882 = f13_x_p879_lanes[0] + 2.375e-05 * f13_x_p881 + f13_x_p879_lanes[1];
  const Lanes<2> f13_x_p883_lanes = detail::make_pack<Real>(s23, s24) * f13_x_p869_lanes;
  const Real f13_x_p885 = f13_x_p883_lanes[1] + f13_x_p883_lanes[0];

  // link 22 (head), articulated inertia
  const Real f13_x_p886 = f13_x_p882 * f13_x_p876 - f13_x_p885;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> f13_x_p887_lanes = detail::make_pack<Real>(0.032, (-0.032)) * f13_x_p873_lanes;
  const Real f13_x_p889 = f13_x_p887_lanes[1] + f13_x_p887_lanes[0] - 0.095 * f13_x_p885;
  const Real f13_x_p890 = 0.072575 + 0.00025 * inverse_D22_p6;

  // link 22 (head), articulated inertia
  const Real f13_x_p891 = f13_x_p890 * inverse_D22;
  const Real f13_x_p892 = f13_x_p889 * f13_x_p891;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> f13_x_p893_lanes = 0.006756756756756757 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> f13_x_p895_lanes = detail::make_pack<Real>(c23, c24) * f13_x_p893_lanes;
  const Lanes<2> f13_x_p899_lanes = detail::make_pack<Real>(s23, s24) * f13_x_p893_lanes;
  const Lanes<2> f13_x_p903_lanes = 0.095 * f13_x_p895_lanes +
      detail::make_pack<Real>(0.032, (-0.032)) * f13_x_p899_lanes;

  // link 22 (head), articulated inertia
  const Real f13_x_p905 = f13_x_p903_lanes[1] + f13_x_p903_lanes[0] + f13_x_p889 * f13_x_p876;
  const Real f13_x_p906 = f13_x_p882 * f13_x_p891 - 0.00025 * f13_x_p881;
  const Real f13_x_p907 = s22 * (f13_x_p886 + f13_x_p892) + c22 * (f13_x_p906 - f13_x_p905);
  const Real f13_x_p908 = s22 * f13_x_p907;
  const Real f13_x_p909 = f13_x_p908 - f13_x_p892;
  const Real inverse_D21_p1 = f13_x_p889 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p2_lanes = f13_x_p899_lanes - 0.006756756756756757;
  const Lanes<2> inverse_D21_p8_lanes = 0.095 * inverse_D21_p2_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * f13_x_p895_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p10 = inverse_D21_p8_lanes[1] + inverse_D21_p8_lanes[0];
  const Real inverse_D21_p11 = 0.009438624999999999 - (-0.032) * f13_x_p903_lanes[1] - 0.032 *
      f13_x_p903_lanes[0] - f13_x_p889 * inverse_D21_p1 + 0.095 * inverse_D21_p10;
  const Real inverse_D21_p12 = 0.05450270000000001 + inverse_D22_p5 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - f13_x_p882 * f13_x_p882 * inverse_D22;
  const Real inverse_D21_p13 = inverse_D21_p12 - 0.00017071621621621625;
  const Real inverse_D21_p14 = f13_x_p871_lanes[1] + f13_x_p871_lanes[0];
  const Real inverse_D21_p15 = 0.0074 - (-0.032) * f13_x_p883_lanes[1] - 0.032 *
      f13_x_p883_lanes[0] + f13_x_p882 * inverse_D21_p1 - 0.095 * inverse_D21_p14;
  const Real inverse_D21_p16 = 2.0 * c22;
  const Real inverse_D21_p17 = s22 * (inverse_D21_p13 - inverse_D21_p11) + inverse_D21_p16 *
      inverse_D21_p15;
  const Real inverse_D21_p18 = s22 * inverse_D21_p17;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p11 + inverse_D21_p18));
  const Real f13_x_p910 = f13_x_p909 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real f13_x_p911 = f13_x_p885 * inverse_D22;
  const Real f13_x_p912 = 0.072575 + inverse_D21_p10 + f13_x_p889 * f13_x_p911;
  const Real f13_x_p913 = inverse_D21_p14 - 0.43200000000000005 + f13_x_p882 * f13_x_p911;
  const Real f13_x_p914 = c22 * f13_x_p912 - s22 * f13_x_p913;
  const Real f13_x_p915 = 0.0016155 + (c22 * inverse_D21_p17 - inverse_D21_p15 + 0.394 *
      f13_x_p914);
  const Real f13_x_p916 = c22 * f13_x_p907;
  const Real f13_x_p917 = f13_x_p890 * f13_x_p911;
  const Real f13_x_p918 = f13_x_p895_lanes[1] + f13_x_p895_lanes[0] - f13_x_p875 * f13_x_p911;
  const Real f13_x_p919 = c22 * f13_x_p917 - s22 * f13_x_p918;

  // link 21 (neck), articulated inertia
  const Real f13_x_p920 = f13_x_p915 * f13_x_p910 - (f13_x_p916 + f13_x_p905 + 0.394 * f13_x_p919);

  // link 22 (head), articulated inertia
  const Real f13_x_p921 = f13_x_p916 - f13_x_p906;
  const Real f13_x_p922 = 0.394 * f13_x_p921;
  const Real f13_x_p923 = f13_x_p875 * f13_x_p891;
  const Real f13_x_p924 = f13_x_p899_lanes[1] + f13_x_p899_lanes[0] + f13_x_p875 * f13_x_p876;
  const Real f13_x_p925 = f13_x_p890 * f13_x_p891;
  const Real f13_x_p926 = inverse_D21_p16 * f13_x_p923 - s22 * (f13_x_p925 - f13_x_p924);
  const Real f13_x_p927 = f13_x_p923 - c22 * f13_x_p926;

  // link 21 (neck), articulated inertia
  const Real f13_x_p928 = f13_x_p922 * f13_x_p910 - (0.0045000000000000005 + 0.394 * f13_x_p927);

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p929 = c21 * f13_x_p920 - s21 * f13_x_p928 + f13_x_p867_lanes[1] +
      f13_x_p867_lanes[0];
  const Lanes<2> inverse_D6_p3_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (f13_x_p707_lanes + f13_x_p867_lanes);
  const Lanes<2> inverse_D6_p5_lanes = f13_x_p645_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p13_lanes = 0.0002975 + (inverse_D7_p7_lanes - inverse_D7_p15_lanes) -
      f13_x_p645_lanes * inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p15_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p17_lanes;
  const Lanes<2> inverse_D6_p17_lanes = 0.0001505 - inverse_D6_p15_lanes;
  const Lanes<2> inverse_D6_p25_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p29_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p17_lanes - inverse_D6_p13_lanes) + f13_x_p823_lanes * inverse_D6_p25_lanes;
  const Lanes<2> inverse_D6_p31_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p29_lanes;
  const Real inverse_D6_p33 = inverse_D6_p31_lanes[1] + inverse_D6_p31_lanes[0];

  // link 22 (head), articulated inertia
  const Real inverse_D6_p34 = c22 * f13_x_p913 + s22 * f13_x_p912;
  const Real inverse_D6_p35 = inverse_D21_p2_lanes[1] + inverse_D21_p2_lanes[0] - f13_x_p885 *
      f13_x_p911;
  const Real inverse_D6_p36 = inverse_D6_p34 - 0.394 * inverse_D6_p35;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p37 = 0.005513625 + (inverse_D21_p13 - inverse_D21_p18 - 0.394 *
      (inverse_D6_p34 + inverse_D6_p36)) - f13_x_p915 * (f13_x_p915 * inverse_D21);
  const Real inverse_D6_p38 = f13_x_p922 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p39 = s22 * f13_x_p926;
  const Real inverse_D6_p40 = inverse_D6_p39 - f13_x_p924;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p41 = 0.000703125 + 0.155236 * inverse_D6_p40 - f13_x_p922 * inverse_D6_p38;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p42 = c22 * f13_x_p918 + s22 * f13_x_p917;
  const Real inverse_D6_p43 = 0.394 * inverse_D6_p42;
  const Real inverse_D6_p44 = f13_x_p886 - f13_x_p908 - inverse_D6_p43;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p45 = 0.394 * inverse_D6_p44 - f13_x_p915 * inverse_D6_p38;
  const Real inverse_D6_p46 = 2.0 * s21;
  const Real inverse_D6_p47 = c21 * (inverse_D6_p37 - inverse_D6_p41) - inverse_D6_p46 *
      inverse_D6_p45;
  const Real inverse_D6_p48 = c21 * inverse_D6_p47;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p51_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) * f13_x_p837_lanes;
  const Lanes<2> inverse_D6_p61_lanes = f13_x_p633_lanes - f13_x_p565_lanes -
      0.0017499999999999998 - f13_x_p645_lanes * f13_x_p837_lanes;
  const Lanes<2> inverse_D6_p65_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p51_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p61_lanes;
  const Lanes<2> inverse_D6_p73_lanes = f13_x_p767_lanes + f13_x_p785_lanes - f13_x_p835_lanes *
      f13_x_p837_lanes;
  const Lanes<2> inverse_D6_p79_lanes = inverse_D6_p65_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * f13_x_p861_lanes + 0.226 * inverse_D6_p73_lanes);
  const Real inverse_D6_p81 = inverse_D6_p79_lanes[1] + inverse_D6_p79_lanes[0];
  const Real inverse_D6_p82 = 2.06965463592404 + inverse_D6_p41 + inverse_D6_p48 +
      inverse_D6_p13_lanes[1] + inverse_D6_p33 + inverse_D6_p3_lanes[1] + inverse_D6_p13_lanes[0] +
      inverse_D6_p3_lanes[0] + 0.226 * (inverse_D6_p65_lanes[1] + inverse_D6_p81 +
      inverse_D6_p65_lanes[0]);

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p82;
  const Real f13_x_p930 = f13_x_p929 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p931_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p703_lanes;
  const Lanes<2> f13_x_p937_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p827_lanes +
      f13_x_p821_lanes;
  const Lanes<2> f13_x_p939_lanes = detail::make_pack<Real>(0.18, (-0.18)) * f13_x_p937_lanes;
  const Lanes<2> f13_x_p945_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p847_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p857_lanes;
  const Lanes<2> f13_x_p947_lanes = 0.226 * f13_x_p945_lanes;
  const Lanes<2> f13_x_p951_lanes = f13_x_p931_lanes - f13_x_p653_lanes -
      (f13_x_p939_lanes + f13_x_p947_lanes);
  const Lanes<2> f13_x_p953_lanes = f13_x_p681_lanes + f13_x_p931_lanes;
  const Lanes<2> f13_x_p957_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (f13_x_p951_lanes + f13_x_p953_lanes);
  const Lanes<2> f13_x_p959_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p29_lanes;
  const Lanes<2> f13_x_p965_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p51_lanes -
      detail::make_pack<Real>(c7, c14) * inverse_D6_p61_lanes;
  const Real f13_x_p967 = f13_x_p965_lanes[1] + f13_x_p965_lanes[0];
  const Real f13_x_p968 = 0.0187369177636143 + f13_x_p957_lanes[1] - inverse_D6_p25_lanes[1] +
      f13_x_p959_lanes[1] + f13_x_p957_lanes[0] - inverse_D6_p25_lanes[0] + f13_x_p959_lanes[0] +
      0.226 * f13_x_p967;
  const Lanes<2> f13_x_p969_lanes = f13_x_p939_lanes - f13_x_p953_lanes;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p971 = f13_x_p969_lanes[1] + f13_x_p969_lanes[0] + f13_x_p968 * f13_x_p930;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p972 = f13_x_p951_lanes[1] + f13_x_p951_lanes[0];
  const Real f13_x_p973 = s21 * inverse_D6_p47 + inverse_D6_p45 + 0.226 * f13_x_p972;

  // link 21 (neck), articulated inertia
  const Real f13_x_p974 = f13_x_p921 * inverse_D21;
  const Real f13_x_p975 = inverse_D6_p44 - f13_x_p915 * f13_x_p974;

  // link 22 (head), articulated inertia
  const Real f13_x_p976 = 0.0045000000000000005 + f13_x_p914;

  // link 21 (neck), articulated inertia
  const Real f13_x_p977 = f13_x_p976 * inverse_D21;
  const Real f13_x_p978 = inverse_D6_p43 + f13_x_p922 * f13_x_p977;
  const Real f13_x_p979 = 0.394 * inverse_D6_p40 - f13_x_p922 * f13_x_p974;
  const Real f13_x_p980 = inverse_D6_p36 + f13_x_p915 * f13_x_p977;
  const Real f13_x_p981 = c21 * (f13_x_p975 - f13_x_p978) - s21 * (f13_x_p979 + f13_x_p980);
  const Real f13_x_p982 = s21 * f13_x_p981;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p983 = f13_x_p982 + f13_x_p980 - 6.1665928899999995 - inverse_D6_p81;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p984 = f13_x_p983 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real f13_x_p985 = c21 * f13_x_p981;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p986 = f13_x_p975 - f13_x_p985 + f13_x_p947_lanes[1] + f13_x_p947_lanes[0] -
      f13_x_p973 * f13_x_p984;
  const Real f13_x_p987 = f13_x_p937_lanes[1] + f13_x_p937_lanes[0];
  const Real f13_x_p988 = f13_x_p973 * f13_x_p930 - (s21 * f13_x_p920 + c21 * f13_x_p928) + 0.226 *
      f13_x_p987;
  const Real f13_x_p989 = (-0.18) * f13_x_p945_lanes[1] - f13_x_p967 + 0.18 * f13_x_p945_lanes[0] -
      f13_x_p968 * f13_x_p984;
  const Real f13_x_p990 = s6 * (f13_x_p971 - f13_x_p986) + c6 * (f13_x_p988 + f13_x_p989);
  const Real f13_x_p991 = s6 * f13_x_p990;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p992 = f13_x_p978 + f13_x_p985 + f13_x_p972;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p993 = f13_x_p992 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real f13_x_p994 = f13_x_p921 * f13_x_p910 - f13_x_p927;
  const Real f13_x_p995 = f13_x_p919 - f13_x_p976 * f13_x_p910;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p996 = f13_x_p987 - c21 * f13_x_p994 + s21 * f13_x_p995 + f13_x_p929 *
      f13_x_p993;

  // link 21 (neck), articulated inertia
  const Real f13_x_p997 = inverse_D6_p40 - f13_x_p921 * f13_x_p974;
  const Real f13_x_p998 = inverse_D6_p35 - f13_x_p976 * f13_x_p977;
  const Real f13_x_p999 = inverse_D6_p42 + f13_x_p921 * f13_x_p977;
  const Real f13_x_p1000 = c21 * (f13_x_p997 - f13_x_p998) - inverse_D6_p46 * f13_x_p999;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p1001 = s21 * f13_x_p1000 + f13_x_p999 + f13_x_p945_lanes[1] +
      f13_x_p945_lanes[0] - f13_x_p983 * f13_x_p993;
  const Real f13_x_p1002 = s6 * f13_x_p996 + c6 * f13_x_p1001;
  const Real f13_x_p1003 = 0.072 * f13_x_p1002;
  const Real f13_x_p1004 = f13_x_p986 + f13_x_p991 + f13_x_p1003;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p1_lanes = f13_x_p705_lanes + f13_x_p695_lanes;
  const Lanes<2> inverse_D5_p3_lanes = f13_x_p829_lanes - f13_x_p789_lanes;
  const Lanes<2> inverse_D5_p7_lanes = inverse_D5_p1_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p3_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p9 = inverse_D5_p7_lanes[1] + inverse_D5_p7_lanes[0] - f13_x_p968 *
      f13_x_p993;
  const Real inverse_D5_p10 = inverse_D5_p3_lanes[1] + inverse_D5_p3_lanes[0];
  const Real inverse_D5_p11 = 6.1665928899999995 + f13_x_p982 + f13_x_p979 - f13_x_p973 *
      f13_x_p993 + 0.226 * inverse_D5_p10;
  const Real inverse_D5_p12 = s6 * inverse_D5_p9 + c6 * inverse_D5_p11;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p13 = c21 * f13_x_p1000;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p14 = f13_x_p998 + inverse_D5_p13 + inverse_D5_p10 - f13_x_p992 *
      f13_x_p993;
  const Real inverse_D5_p15 = inverse_D5_p12 + 0.072 * inverse_D5_p14;
  const Real inverse_D5_p16 = f13_x_p968 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p19_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p1_lanes + inverse_D5_p7_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p21 = 0.40056549999999996 - inverse_D6_p15_lanes[1] - inverse_D6_p33 +
      inverse_D5_p19_lanes[1] + inverse_D6_p17_lanes[0] + inverse_D5_p19_lanes[0] - f13_x_p968 *
      inverse_D5_p16;
  const Real inverse_D5_p22 = f13_x_p973 * inverse_D6;
  const Real inverse_D5_p23 = 1.66923963592404 + inverse_D6_p37 - inverse_D6_p48 - f13_x_p973 *
      inverse_D5_p22 + 0.051076 * inverse_D5_p10;
  const Real inverse_D5_p24 = (-0.04068) * inverse_D5_p3_lanes[1] + 0.04068 *
      inverse_D5_p3_lanes[0] - f13_x_p968 * inverse_D5_p22 + 0.226 *
      (inverse_D5_p1_lanes[1] + inverse_D5_p1_lanes[0]);
  const Real inverse_D5_p25 = 2.0 * c6;
  const Real inverse_D5_p26 = s6 * (inverse_D5_p21 - inverse_D5_p23) + inverse_D5_p25 *
      inverse_D5_p24;
  const Real inverse_D5_p27 = s6 * inverse_D5_p26;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p23 + inverse_D5_p27 + 0.072 * (inverse_D5_p12 + inverse_D5_p15)));
  const Real f13_x_p1005 = f13_x_p1004 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p1006 = 0.072 * f13_x_p1004;
  const Real f13_x_p1007 = f13_x_p831_lanes[1] - (f13_x_p925 + inverse_D6_p39 + f13_x_p909 *
      f13_x_p910) + f13_x_p831_lanes[0] - f13_x_p929 * f13_x_p930;
  const Real f13_x_p1008 = f13_x_p997 - inverse_D5_p13 + inverse_D6_p73_lanes[1] +
      inverse_D6_p73_lanes[0] - f13_x_p983 * f13_x_p984;
  const Real f13_x_p1009 = f13_x_p861_lanes[1] - (s21 * f13_x_p994 + c21 * f13_x_p995) +
      f13_x_p861_lanes[0] + f13_x_p929 * f13_x_p984;
  const Real f13_x_p1010 = s6 * (f13_x_p1007 - f13_x_p1008) + inverse_D5_p25 * f13_x_p1009;
  const Real f13_x_p1011 = s6 * f13_x_p1010;
  const Real f13_x_p1012 = f13_x_p1008 + f13_x_p1011;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1013 = f13_x_p1006 * f13_x_p1005 - (2.2194301519999997 + 0.072 * f13_x_p1012);

  // link 6 (chest3), articulated inertia
  const Real f13_x_p1014 = c6 * inverse_D5_p9 - s6 * inverse_D5_p11;
  const Real f13_x_p1015 = c6 * inverse_D5_p26 - inverse_D5_p24 + 0.072 * f13_x_p1014;
  const Real f13_x_p1016 = c6 * f13_x_p990;
  const Real f13_x_p1017 = f13_x_p1016 - f13_x_p988;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1018 = f13_x_p1017 - 0.069699984375 - f13_x_p1015 * f13_x_p1005;
  const Real f13_x_p1019 = s5 * f13_x_p1013 + c5 * f13_x_p1018;
  const Real f13_x_p1020 = f13_x_p1006 * inverse_D5;
  const Real f13_x_p1021 = 0.15637308509675518 + 0.005183999999999999 * f13_x_p1012 - f13_x_p1006 *
      f13_x_p1020;
  const Real f13_x_p1022 = f13_x_p1015 * inverse_D5;
  const Real f13_x_p1023 = 0.04675382692737882 + (inverse_D5_p21 - inverse_D5_p27) - f13_x_p1015 *
      f13_x_p1022;
  const Real f13_x_p1024 = 0.005678398088837119 - 0.072 * f13_x_p1017 + f13_x_p1006 * f13_x_p1022;
  const Real f13_x_p1025 = 2.0 * c5;
  const Real f13_x_p1026 = s5 * (f13_x_p1021 - f13_x_p1023) + f13_x_p1025 * f13_x_p1024;
  const Real f13_x_p1027 = 0.005880002159562879 + (0.21799999999999997 * f13_x_p1019 -
      (c5 * f13_x_p1026 - f13_x_p1024));

  // link 6 (chest3), articulated inertia
  const Real f13_x_p1028 = 2.2194301519999997 + inverse_D5_p15;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1029 = f13_x_p1028 * inverse_D5;
  const Real f13_x_p1030 = f13_x_p1006 * f13_x_p1029 - f13_x_p1003;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p1031 = c6 * f13_x_p996 - s6 * f13_x_p1001;
  const Real f13_x_p1032 = 0.069699984375 + (f13_x_p1016 - f13_x_p989 + 0.072 * f13_x_p1031);

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1033 = f13_x_p1032 * inverse_D5;
  const Real f13_x_p1034 = f13_x_p971 - f13_x_p991 - f13_x_p1015 * f13_x_p1033;
  const Real f13_x_p1035 = f13_x_p1014 - f13_x_p1015 * f13_x_p1029;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p1036 = c6 * f13_x_p1010 - f13_x_p1009;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1037 = f13_x_p1006 * f13_x_p1033 - 0.072 * f13_x_p1036;
  const Real f13_x_p1038 = s5 * (f13_x_p1030 - f13_x_p1034) + c5 * (f13_x_p1035 + f13_x_p1037);
  const Real f13_x_p1039 = c5 * f13_x_p1038;
  const Real f13_x_p1040 = f13_x_p1039 - f13_x_p1037;
  const Real inverse_D4_p1 = s5 * f13_x_p1026;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (f13_x_p1023 + inverse_D4_p1));
  const Real f13_x_p1041 = f13_x_p1040 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1042 = s5 * f13_x_p1038;
  const Real f13_x_p1043 = f13_x_p1036 - f13_x_p1032 * f13_x_p1005;
  const Real f13_x_p1044 = f13_x_p1002 - f13_x_p1028 * f13_x_p1005;
  const Real f13_x_p1045 = s5 * f13_x_p1043 - c5 * f13_x_p1044;
  const Real f13_x_p1046 = 0.21799999999999997 * f13_x_p1045;
  const Real f13_x_p1047 = f13_x_p1030 - f13_x_p1042 + f13_x_p1046;
  const Real f13_x_p1048 = 0.21799999999999997 * f13_x_p1040;
  const Real f13_x_p1049 = 0.0300000063 + f13_x_p1019;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p1050 = f13_x_p1049 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1051 = f13_x_p1007 - f13_x_p1011 - f13_x_p1032 * f13_x_p1033;
  const Real f13_x_p1052 = inverse_D5_p14 - f13_x_p1028 * f13_x_p1029;
  const Real f13_x_p1053 = f13_x_p1031 - f13_x_p1028 * f13_x_p1033;
  const Real f13_x_p1054 = s5 * (f13_x_p1052 - f13_x_p1051) + f13_x_p1025 * f13_x_p1053;
  const Real f13_x_p1055 = s5 * f13_x_p1054;
  const Real f13_x_p1056 = f13_x_p1052 - f13_x_p1055;
  const Real f13_x_p1057 = s5 * f13_x_p1018 - c5 * f13_x_p1013;
  const Real f13_x_p1058 = f13_x_p1012 - f13_x_p1004 * f13_x_p1005;
  const Real f13_x_p1059 = f13_x_p1057 + 0.21799999999999997 * f13_x_p1058;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p1060 = f13_x_p1027 * f13_x_p1050 - f13_x_p1059;
  const Real f13_x_p1061 = s4 * (f13_x_p1047 + f13_x_p1027 * f13_x_p1041 +
      (f13_x_p1046 + f13_x_p1048 * f13_x_p1050)) + c4 *
      (0.21799999999999997 * f13_x_p1056 - f13_x_p1048 * f13_x_p1041 + f13_x_p1060);
  const Real f13_x_p1062 = 8.419374554 + (c4 * f13_x_p1061 - f13_x_p1060);
  const Real inverse_D3_p1 = f13_x_p1027 * inverse_D4;
  const Real inverse_D3_p2 = f13_x_p1048 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * f13_x_p1056 - f13_x_p1048 *
      inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (f13_x_p1021 - inverse_D4_p1 + 0.21799999999999997 *
      (f13_x_p1057 + f13_x_p1059)) - f13_x_p1027 * inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * f13_x_p1047 + f13_x_p1027 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real f13_x_p1063 = f13_x_p1062 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p1064 = f13_x_p1056 - f13_x_p1040 * f13_x_p1041;
  const Real f13_x_p1065 = s4 * (f13_x_p1064 - (f13_x_p1058 - f13_x_p1049 * f13_x_p1050)) -
      inverse_D3_p5 * (f13_x_p1045 + f13_x_p1040 * f13_x_p1050);

  // link 3 (hip), articulated inertia
  const Real f13_x_p1066 = f13_x_p1064 - s4 * f13_x_p1065 - f13_x_p1062 * f13_x_p1063;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1067 = f13_x_p1034 + f13_x_p1042;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p1068 = f13_x_p1067 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p1069 = s5 * f13_x_p1044 + c5 * f13_x_p1043;
  const Real f13_x_p1070 = c5 * f13_x_p1054 - f13_x_p1053;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p1071 = s4 * (0.21799999999999997 * f13_x_p1069 - (f13_x_p1039 - f13_x_p1035) -
      f13_x_p1027 * f13_x_p1068) + c4 * (0.0300000063 - 0.21799999999999997 * f13_x_p1070 +
      f13_x_p1048 * f13_x_p1068);
  const Real f13_x_p1072 = 0.02999999505 + f13_x_p1071;

  // link 3 (hip), articulated inertia
  const Real f13_x_p1073 = f13_x_p1072 * inverse_D3;
  const Real f13_x_p1074 = f13_x_p1051 + f13_x_p1055 - f13_x_p1067 * f13_x_p1068 - f13_x_p1072 *
      f13_x_p1073;
  const Real f13_x_p1075 = f13_x_p1062 * f13_x_p1073 -
      (c4 * (f13_x_p1040 * f13_x_p1068 - f13_x_p1070) - s4 *
      (f13_x_p1049 * f13_x_p1068 - f13_x_p1069));
  const Real f13_x_p1076 = s3 * (f13_x_p1066 - f13_x_p1074) + c3 * (2.0 * f13_x_p1075);
  const Real f13_x_p1077 = s3 * f13_x_p1076;
  const Real f13_x_p1078 = f13_x_p1066 - f13_x_p1077;
  const Real f13_x_p1079 = 24.5839218 + 0.422 * f13_x_p1078;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * f13_x_p1078);
  const Real f13_x_p1080 = f13_x_p1079 * inverse_D2;

  // link 13 (left_hand), force propagation
  const Lanes<2> f13_x_p1085_lanes = 0.11533812622014242 * detail::make_pack<Real>(s13, s20) -
      detail::make_pack<Real>(0.04672761636452121, (-0.04672761636452121)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p1094_lanes = 0.11533812622014242 * detail::make_pack<Real>(c13, c20) +
      detail::make_pack<Real>(0.04672761636452121, (-0.04672761636452121)) *
      detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> neg_s13_lanes = -detail::make_pack<Real>(s13, s20);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p1096_lanes = detail::make_pack<Real>(c20, c20, neg_s13_lanes[1],
      f13_x_p1094_lanes[1], c20, c20, c20, c20) - inverse_D11_p1_lanes[1] *
      detail::make_pack<Real>(s20, s20, c20, f13_x_p1085_lanes[1], s20, s20, s20, s20);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1102_lanes = -(c19 * f13_x_p1096_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1116_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(s13, s20) - 17.32841575379867 *
      detail::make_pack<Real>(c13, c20) - f13_x_p61_lanes * f13_x_p1085_lanes;
  const Lanes<8> f13_x_p1123_lanes = detail::make_pack<Real>(c13, c13, c13, c13, neg_s13_lanes[0],
      f13_x_p1094_lanes[0], c13, c13) - inverse_D11_p1_lanes[0] *
      detail::make_pack<Real>(s13, s13, s13, s13, c13, f13_x_p1085_lanes[0], s13, s13);
  const Lanes<2> f13_x_p1128_lanes = 0.269 * f13_x_p1116_lanes - detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p1123_lanes[5], f13_x_p1096_lanes[3]);
  const Lanes<2> f13_x_p1132_lanes = f13_x_p61_lanes * detail::make_pack<Real>(c13, c20);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1138_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p1123_lanes[4], f13_x_p1096_lanes[2]) + 0.269 *
      f13_x_p1132_lanes);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1142_lanes = f13_x_p61_lanes * detail::make_pack<Real>(s13, s20);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1148_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(f13_x_p1123_lanes[3], f13_x_p1096_lanes[1]) + 0.269 *
      f13_x_p1142_lanes);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1150_lanes = detail::make_pack<Real>(f13_x_p1148_lanes[1],
      f13_x_p1148_lanes[1], f13_x_p1138_lanes[1], f13_x_p1128_lanes[1], f13_x_p1148_lanes[1],
      f13_x_p1148_lanes[1], f13_x_p1148_lanes[1], f13_x_p1148_lanes[1]) - inverse_D10_p1_lanes[1] *
      f13_x_p1102_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1159_lanes = f13_x_p35_lanes * f13_x_p1085_lanes;
  const Lanes<2> f13_x_p1171_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(c13, c20) + 17.32841575379867 *
      detail::make_pack<Real>(s13, s20) - f13_x_p11_lanes * f13_x_p1085_lanes;
  const Lanes<2> f13_x_p1175_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1159_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p1171_lanes;
  const Lanes<2> f13_x_p1177_lanes = f13_x_p35_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p1181_lanes = f13_x_p11_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p1185_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1177_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p1181_lanes;
  const Lanes<2> f13_x_p1187_lanes = f13_x_p35_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p1191_lanes = f13_x_p11_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p1195_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1187_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p1191_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1200_lanes = 0.269 * detail::make_pack<Real>(f13_x_p1195_lanes[1],
      f13_x_p1195_lanes[1], f13_x_p1185_lanes[1], f13_x_p1175_lanes[1], f13_x_p1195_lanes[1],
      f13_x_p1195_lanes[1], f13_x_p1195_lanes[1], f13_x_p1195_lanes[1]) - inverse_D10_p8_lanes[1] *
      f13_x_p1102_lanes;
  const Lanes<8> f13_x_p1206_lanes = s18 * f13_x_p1150_lanes + c18 * f13_x_p1200_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1211_lanes = -(0.269 * detail::make_pack<Real>(c12, c19));
  const Lanes<2> f13_x_p1213_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p1211_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1225_lanes = c18 * f13_x_p1150_lanes - s18 * f13_x_p1200_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p1230_lanes = -(detail::make_pack<Real>(s11, s18) * f13_x_p1211_lanes);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1232_lanes = detail::make_pack<Real>(f13_x_p1230_lanes[1],
      f13_x_p1225_lanes[1], f13_x_p1225_lanes[2], f13_x_p1225_lanes[3], f13_x_p1230_lanes[1],
      f13_x_p1230_lanes[1], f13_x_p1230_lanes[1], f13_x_p1230_lanes[1]) - f13_x_p231_lanes[1] *
      detail::make_pack<Real>(f13_x_p1213_lanes[1], f13_x_p1206_lanes[1], f13_x_p1206_lanes[2],
      f13_x_p1206_lanes[3], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1],
      f13_x_p1213_lanes[1]);
  const Lanes<8> f13_x_p1240_lanes = f13_x_p221_lanes[1] *
      detail::make_pack<Real>(f13_x_p1213_lanes[1], f13_x_p1206_lanes[1], f13_x_p1206_lanes[2],
      f13_x_p1206_lanes[3], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1],
      f13_x_p1213_lanes[1]);
  const Lanes<8> f13_x_p1248_lanes = c17 * f13_x_p1240_lanes - s17 * f13_x_p1232_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1252_lanes = f13_x_p259_lanes[1] * f13_x_p1248_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1278_lanes = -detail::make_pack<Real>(f13_x_p1195_lanes[1],
      f13_x_p1195_lanes[1], f13_x_p1185_lanes[1], f13_x_p1175_lanes[1], f13_x_p1195_lanes[1],
      f13_x_p1195_lanes[1], f13_x_p1195_lanes[1], f13_x_p1195_lanes[1]) + f13_x_p55_lanes[1] *
      f13_x_p1102_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1287_lanes = -f13_x_p1132_lanes;
  const Lanes<2> f13_x_p1289_lanes = -f13_x_p1142_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1291_lanes = detail::make_pack<Real>(f13_x_p1289_lanes[1],
      f13_x_p1289_lanes[1], f13_x_p1287_lanes[1], f13_x_p1116_lanes[1], f13_x_p1289_lanes[1],
      f13_x_p1289_lanes[1], f13_x_p1289_lanes[1], f13_x_p1289_lanes[1]) - f13_x_p119_lanes[1] *
      f13_x_p1102_lanes;
  const Lanes<8> f13_x_p1297_lanes = s18 * f13_x_p1278_lanes + c18 * f13_x_p1291_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1300_lanes = detail::make_pack<Real>(s11, s18) *
      detail::make_pack<Real>(c12, c19);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1302_lanes = detail::make_pack<Real>(f13_x_p1300_lanes[1],
      f13_x_p1297_lanes[1], f13_x_p1297_lanes[2], f13_x_p1297_lanes[3], f13_x_p1300_lanes[1],
      f13_x_p1300_lanes[1], f13_x_p1300_lanes[1], f13_x_p1300_lanes[1]) - f13_x_p191_lanes[1] *
      detail::make_pack<Real>(f13_x_p1213_lanes[1], f13_x_p1206_lanes[1], f13_x_p1206_lanes[2],
      f13_x_p1206_lanes[3], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1],
      f13_x_p1213_lanes[1]);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1314_lanes = c17 * f13_x_p1232_lanes + s17 * f13_x_p1240_lanes + 0.282 *
      f13_x_p1302_lanes - f13_x_p1252_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1336_lanes = c18 * f13_x_p1278_lanes - s18 * f13_x_p1291_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1339_lanes = detail::make_pack<Real>(c11, c18) *
      detail::make_pack<Real>(c12, c19);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1341_lanes = detail::make_pack<Real>(f13_x_p1339_lanes[1],
      f13_x_p1336_lanes[1], f13_x_p1336_lanes[2], f13_x_p1336_lanes[3], f13_x_p1339_lanes[1],
      f13_x_p1339_lanes[1], f13_x_p1339_lanes[1], f13_x_p1339_lanes[1]) - f13_x_p317_lanes[1] *
      detail::make_pack<Real>(f13_x_p1213_lanes[1], f13_x_p1206_lanes[1], f13_x_p1206_lanes[2],
      f13_x_p1206_lanes[3], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1],
      f13_x_p1213_lanes[1]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1356_lanes = -(c12 * f13_x_p1123_lanes);
  const Lanes<2> f13_x_p1367_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1159_lanes -
      detail::make_pack<Real>(c12, c19) * f13_x_p1171_lanes - f13_x_p337_lanes *
      detail::make_pack<Real>(f13_x_p1356_lanes[5], f13_x_p1102_lanes[3]);
  const Lanes<2> f13_x_p1377_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1177_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p1181_lanes - f13_x_p337_lanes *
      detail::make_pack<Real>(f13_x_p1356_lanes[4], f13_x_p1102_lanes[2]);
  const Lanes<2> f13_x_p1387_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1187_lanes +
      detail::make_pack<Real>(c12, c19) * f13_x_p1191_lanes - f13_x_p337_lanes *
      detail::make_pack<Real>(f13_x_p1356_lanes[3], f13_x_p1102_lanes[1]);
  const Lanes<2> neg_s12_lanes = -detail::make_pack<Real>(s12, s19);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1392_lanes = -detail::make_pack<Real>(neg_s12_lanes[1],
      f13_x_p1387_lanes[1], f13_x_p1377_lanes[1], f13_x_p1367_lanes[1], neg_s12_lanes[1],
      neg_s12_lanes[1], neg_s12_lanes[1], neg_s12_lanes[1]) - f13_x_p363_lanes[1] *
      detail::make_pack<Real>(f13_x_p1213_lanes[1], f13_x_p1206_lanes[1], f13_x_p1206_lanes[2],
      f13_x_p1206_lanes[3], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1],
      f13_x_p1213_lanes[1]);
  const Lanes<8> f13_x_p1400_lanes = s17 * f13_x_p1392_lanes - c17 * f13_x_p1341_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1408_lanes = 0.282 * f13_x_p1400_lanes - f13_x_p401_lanes[1] *
      f13_x_p1248_lanes;
  const Lanes<8> f13_x_p1416_lanes = c16 * f13_x_p1314_lanes - s16 * f13_x_p1408_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1436_lanes = s16 * f13_x_p1314_lanes + c16 * f13_x_p1408_lanes -
      inverse_D7_p1_lanes[1] * f13_x_p1416_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p1444_lanes = 0.00010499999999999999 / inverse_D8_p3_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1446_lanes = f13_x_p1444_lanes[1] * f13_x_p1416_lanes;
  const Lanes<8> f13_x_p1454_lanes = s15 * f13_x_p1446_lanes + c15 * f13_x_p1436_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1458_lanes = f13_x_p679_lanes[1] * f13_x_p1454_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1474_lanes = -f13_x_p1400_lanes + f13_x_p569_lanes[1] * f13_x_p1248_lanes;
  const Lanes<8> f13_x_p1486_lanes = f13_x_p1302_lanes - f13_x_p577_lanes[1] * f13_x_p1248_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1502_lanes = c16 * f13_x_p1474_lanes - s16 * f13_x_p1486_lanes -
      f13_x_p657_lanes[1] * f13_x_p1416_lanes - f13_x_p1458_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1530_lanes = s16 * f13_x_p1474_lanes + c16 * f13_x_p1486_lanes -
      f13_x_p609_lanes[1] * f13_x_p1416_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1562_lanes = -(s17 * f13_x_p1341_lanes + c17 * f13_x_p1392_lanes) +
      f13_x_p515_lanes[1] * f13_x_p1248_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1570_lanes = -f13_x_p1562_lanes + f13_x_p555_lanes[1] * f13_x_p1416_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1582_lanes = c15 * f13_x_p1570_lanes - s15 * f13_x_p1530_lanes -
      f13_x_p639_lanes[1] * f13_x_p1454_lanes;
  const Lanes<8> f13_x_p1590_lanes = s14 * f13_x_p1502_lanes + c14 * f13_x_p1582_lanes;
  const Lanes<8> f13_x_p1614_lanes = s15 * f13_x_p1570_lanes + c15 * f13_x_p1530_lanes -
      f13_x_p837_lanes[1] * f13_x_p1454_lanes;
  const Lanes<8> f13_x_p1622_lanes = 0.226 * f13_x_p1614_lanes + (-0.18) * f13_x_p1590_lanes;
  const Lanes<8> f13_x_p1642_lanes = c15 * f13_x_p1446_lanes - s15 * f13_x_p1436_lanes -
      inverse_D6_p5_lanes[1] * f13_x_p1454_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p1650_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p17_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1652_lanes = f13_x_p1650_lanes[1] * f13_x_p1454_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1668_lanes = -(c14 * f13_x_p1652_lanes + s14 * f13_x_p1642_lanes +
      f13_x_p1622_lanes);
  const Lanes<8> f13_x_p1672_lanes = inverse_D5_p16 * f13_x_p1668_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1684_lanes = c14 * f13_x_p1502_lanes - s14 * f13_x_p1582_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p1708_lanes = (-0.18) * f13_x_p1684_lanes -
      (s14 * f13_x_p1652_lanes - c14 * f13_x_p1642_lanes) - f13_x_p1672_lanes;
  const Lanes<8> f13_x_p1724_lanes = 0.226 * f13_x_p1684_lanes - inverse_D5_p22 * f13_x_p1668_lanes;
  const Lanes<8> f13_x_p1740_lanes = f13_x_p1684_lanes - f13_x_p993 * f13_x_p1668_lanes;
  const Lanes<8> f13_x_p1748_lanes = s6 * f13_x_p1708_lanes + c6 * f13_x_p1724_lanes + 0.072 *
      f13_x_p1740_lanes;
  const Lanes<8> f13_x_p1760_lanes = f13_x_p1590_lanes + f13_x_p930 * f13_x_p1668_lanes;
  const Lanes<8> f13_x_p1772_lanes = f13_x_p1614_lanes - f13_x_p984 * f13_x_p1668_lanes;
  const Lanes<8> f13_x_p1780_lanes = s6 * f13_x_p1760_lanes + c6 * f13_x_p1772_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1792_lanes = -(0.072 * f13_x_p1780_lanes) + f13_x_p1020 * f13_x_p1748_lanes;
  const Lanes<8> f13_x_p1816_lanes = c6 * f13_x_p1708_lanes - s6 * f13_x_p1724_lanes - f13_x_p1022 *
      f13_x_p1748_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1828_lanes = -(s5 * f13_x_p1792_lanes + c5 * f13_x_p1816_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1852_lanes = f13_x_p1780_lanes - f13_x_p1005 * f13_x_p1748_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1864_lanes = -(s5 * f13_x_p1816_lanes - c5 * f13_x_p1792_lanes +
      0.21799999999999997 * f13_x_p1852_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p1896_lanes = c6 * f13_x_p1760_lanes - s6 * f13_x_p1772_lanes - f13_x_p1033 *
      f13_x_p1748_lanes;
  const Lanes<8> f13_x_p1908_lanes = f13_x_p1740_lanes - f13_x_p1029 * f13_x_p1748_lanes;
  const Lanes<8> f13_x_p1916_lanes = s5 * f13_x_p1896_lanes - c5 * f13_x_p1908_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1932_lanes = c4 * (-(0.21799999999999997 * f13_x_p1916_lanes) +
      inverse_D3_p2 * f13_x_p1828_lanes);
  const Lanes<8> f13_x_p1936_lanes = s4 * (f13_x_p1864_lanes - inverse_D3_p1 * f13_x_p1828_lanes) +
      f13_x_p1932_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1940_lanes = f13_x_p1063 * f13_x_p1936_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p1968_lanes = s4 * (f13_x_p1852_lanes + f13_x_p1050 * f13_x_p1828_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p1976_lanes = c4 * (-f13_x_p1916_lanes + f13_x_p1041 * f13_x_p1828_lanes) -
      f13_x_p1968_lanes - f13_x_p1940_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2008_lanes = -(s5 * f13_x_p1908_lanes + c5 * f13_x_p1896_lanes) -
      f13_x_p1068 * f13_x_p1828_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2016_lanes = -f13_x_p2008_lanes + f13_x_p1073 * f13_x_p1936_lanes;
  const Lanes<8> f13_x_p2024_lanes = c3 * f13_x_p1976_lanes - s3 * f13_x_p2016_lanes;
  const Lanes<8> f13_x_p2028_lanes = 0.422 * f13_x_p2024_lanes;

  // link 3 (hip), articulated inertia
  const Real f13_x_p2044 = c3 * f13_x_p1076 - f13_x_p1075;
  const Real f13_x_p2045 = 0.031999971599999996 + 0.422 * f13_x_p2044;

  // link 2 (thigh), articulated inertia
  const Real f13_x_p2046 = f13_x_p2045 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2067_lanes = s2 * (s3 * f13_x_p1976_lanes + c3 * f13_x_p2016_lanes -
      f13_x_p2046 * f13_x_p2028_lanes);
  const Lanes<8> f13_x_p2075_lanes = 0.434 * (c2 * (f13_x_p2024_lanes - f13_x_p1080 *
      f13_x_p2028_lanes) - f13_x_p2067_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = f13_x_p1078 - f13_x_p1079 * f13_x_p1080;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (f13_x_p1074 + f13_x_p1077 - f13_x_p2045 *
      f13_x_p2046)) + c2 * (2.0 * (f13_x_p2044 - f13_x_p1079 * f13_x_p2046));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2079_lanes = f13_x_p2075_lanes * inverse_D1;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p2083_lanes = 0.269 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p2085_lanes = detail::make_pack<Real>(s12, s19) * neg_s13_lanes;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p2087 = 0.269 * f13_x_p2085_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p2088 = s18 * f13_x_p2083_lanes[1] + c18 * f13_x_p2087;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p2089 = c18 * f13_x_p2083_lanes[1] - s18 * f13_x_p2087 - f13_x_p231_lanes[1] *
      f13_x_p2088;
  const Real f13_x_p2090 = f13_x_p221_lanes[1] * f13_x_p2088;
  const Real f13_x_p2091 = c17 * f13_x_p2090 - s17 * f13_x_p2089;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p2092 = -f13_x_p2085_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p2093 = s18 * f13_x_p2092 + c18 * c20 - f13_x_p191_lanes[1] * f13_x_p2088;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p2094 = c17 * f13_x_p2089 + s17 * f13_x_p2090 + 0.282 * f13_x_p2093 -
      f13_x_p259_lanes[1] * f13_x_p2091;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p2095 = c18 * f13_x_p2092 - s18 * c20 - f13_x_p317_lanes[1] * f13_x_p2088;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p2096_lanes = detail::make_pack<Real>(c12, c19) * neg_s13_lanes;
  const Lanes<2> f13_x_p2098_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(c13, c20);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p2102_lanes = -(-detail::make_pack<Real>(f13_x_p2098_lanes[1],
      f13_x_p2098_lanes[1], f13_x_p2098_lanes[1], f13_x_p2098_lanes[1], f13_x_p2098_lanes[1],
      f13_x_p2098_lanes[1], f13_x_p2098_lanes[1], f13_x_p2096_lanes[1]));
  const Real f13_x_p2104 = f13_x_p2102_lanes[7] - f13_x_p363_lanes[1] * f13_x_p2088;
  const Real f13_x_p2105 = s17 * f13_x_p2104 - c17 * f13_x_p2095;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p2106 = 0.282 * f13_x_p2105 - f13_x_p401_lanes[1] * f13_x_p2091;
  const Real f13_x_p2107 = c16 * f13_x_p2094 - s16 * f13_x_p2106;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p2108 = s16 * f13_x_p2094 + c16 * f13_x_p2106 - inverse_D7_p1_lanes[1] *
      f13_x_p2107;
  const Real f13_x_p2109 = f13_x_p1444_lanes[1] * f13_x_p2107;
  const Real f13_x_p2110 = s15 * f13_x_p2109 + c15 * f13_x_p2108;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p2111_lanes = 0.269 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p2113_lanes = detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(c13, c20);

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p2115 = 0.269 * f13_x_p2113_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p2116 = s18 * f13_x_p2111_lanes[1] + c18 * f13_x_p2115;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p2117 = c18 * f13_x_p2111_lanes[1] - s18 * f13_x_p2115 - f13_x_p231_lanes[1] *
      f13_x_p2116;
  const Real f13_x_p2118 = f13_x_p221_lanes[1] * f13_x_p2116;
  const Real f13_x_p2119 = c17 * f13_x_p2118 - s17 * f13_x_p2117;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p2120 = -f13_x_p2113_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p2121 = s18 * f13_x_p2120 + c18 * s20 - f13_x_p191_lanes[1] * f13_x_p2116;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p2122 = c17 * f13_x_p2117 + s17 * f13_x_p2118 + 0.282 * f13_x_p2121 -
      f13_x_p259_lanes[1] * f13_x_p2119;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p2123 = c18 * f13_x_p2120 - s18 * s20 - f13_x_p317_lanes[1] * f13_x_p2116;
  const Real f13_x_p2124 = f13_x_p2102_lanes[6] - f13_x_p363_lanes[1] * f13_x_p2116;
  const Real f13_x_p2125 = s17 * f13_x_p2124 - c17 * f13_x_p2123;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p2126 = 0.282 * f13_x_p2125 - f13_x_p401_lanes[1] * f13_x_p2119;
  const Real f13_x_p2127 = c16 * f13_x_p2122 - s16 * f13_x_p2126;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p2128 = s16 * f13_x_p2122 + c16 * f13_x_p2126 - inverse_D7_p1_lanes[1] *
      f13_x_p2127;
  const Real f13_x_p2129 = f13_x_p1444_lanes[1] * f13_x_p2127;
  const Real f13_x_p2130 = s15 * f13_x_p2129 + c15 * f13_x_p2128;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p2131 = f13_x_p1128_lanes[0] - inverse_D10_p1_lanes[0] * f13_x_p1356_lanes[5];
  const Real f13_x_p2132 = f13_x_p1138_lanes[0] - inverse_D10_p1_lanes[0] * f13_x_p1356_lanes[4];
  const Real f13_x_p2133 = f13_x_p1148_lanes[0] - inverse_D10_p1_lanes[0] * f13_x_p1356_lanes[3];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p2139_lanes = 0.269 * detail::make_pack<Real>(f13_x_p2113_lanes[0],
      f13_x_p2085_lanes[0], f13_x_p2113_lanes[0], f13_x_p1195_lanes[0], f13_x_p1185_lanes[0],
      f13_x_p1175_lanes[0], f13_x_p2113_lanes[0], f13_x_p2113_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p2144 = f13_x_p2139_lanes[5] - inverse_D10_p8_lanes[0] * f13_x_p1356_lanes[5];
  const Real f13_x_p2145 = f13_x_p2139_lanes[4] - inverse_D10_p8_lanes[0] * f13_x_p1356_lanes[4];
  const Real f13_x_p2146 = f13_x_p2139_lanes[3] - inverse_D10_p8_lanes[0] * f13_x_p1356_lanes[3];
  const Lanes<8> f13_x_p2152_lanes = s11 * detail::make_pack<Real>(f13_x_p2111_lanes[0],
      f13_x_p2083_lanes[0], f13_x_p2111_lanes[0], f13_x_p2133, f13_x_p2132, f13_x_p2131,
      f13_x_p2111_lanes[0], f13_x_p2111_lanes[0]) + c11 *
      detail::make_pack<Real>(f13_x_p2139_lanes[0], f13_x_p2139_lanes[1], f13_x_p2139_lanes[0],
      f13_x_p2146, f13_x_p2145, f13_x_p2144, f13_x_p2139_lanes[0], f13_x_p2139_lanes[0]);
  const Lanes<8> f13_x_p2173_lanes = c11 * detail::make_pack<Real>(f13_x_p2111_lanes[0],
      f13_x_p2083_lanes[0], f13_x_p2111_lanes[0], f13_x_p2133, f13_x_p2132, f13_x_p2131,
      f13_x_p2111_lanes[0], f13_x_p2111_lanes[0]) - s11 *
      detail::make_pack<Real>(f13_x_p2139_lanes[0], f13_x_p2139_lanes[1], f13_x_p2139_lanes[0],
      f13_x_p2146, f13_x_p2145, f13_x_p2144, f13_x_p2139_lanes[0], f13_x_p2139_lanes[0]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p2178_lanes = detail::make_pack<Real>(f13_x_p2173_lanes[0],
      f13_x_p2173_lanes[1], f13_x_p1230_lanes[0], f13_x_p2173_lanes[3], f13_x_p2173_lanes[4],
      f13_x_p2173_lanes[5], f13_x_p2173_lanes[0], f13_x_p2173_lanes[0]) - f13_x_p231_lanes[0] *
      detail::make_pack<Real>(f13_x_p2152_lanes[0], f13_x_p2152_lanes[1], f13_x_p1213_lanes[0],
      f13_x_p2152_lanes[3], f13_x_p2152_lanes[4], f13_x_p2152_lanes[5], f13_x_p2152_lanes[0],
      f13_x_p2152_lanes[0]);
  const Lanes<8> f13_x_p2190_lanes = f13_x_p221_lanes[0] *
      detail::make_pack<Real>(f13_x_p2152_lanes[0], f13_x_p2152_lanes[1], f13_x_p1213_lanes[0],
      f13_x_p2152_lanes[3], f13_x_p2152_lanes[4], f13_x_p2152_lanes[5], f13_x_p2152_lanes[0],
      f13_x_p2152_lanes[0]);
  const Lanes<8> f13_x_p2202_lanes = c10 * f13_x_p2190_lanes - s10 * f13_x_p2178_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2208_lanes = f13_x_p259_lanes[0] * f13_x_p2202_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p2238_lanes = -detail::make_pack<Real>(f13_x_p2113_lanes[0],
      f13_x_p2085_lanes[0], f13_x_p2113_lanes[0], f13_x_p1195_lanes[0], f13_x_p1185_lanes[0],
      f13_x_p1175_lanes[0], f13_x_p2113_lanes[0], f13_x_p2113_lanes[0]);
  const Real f13_x_p2243 = f13_x_p2238_lanes[5] + f13_x_p55_lanes[0] * f13_x_p1356_lanes[5];
  const Real f13_x_p2244 = f13_x_p2238_lanes[4] + f13_x_p55_lanes[0] * f13_x_p1356_lanes[4];
  const Real f13_x_p2245 = f13_x_p2238_lanes[3] + f13_x_p55_lanes[0] * f13_x_p1356_lanes[3];
  const Real f13_x_p2251 = f13_x_p1116_lanes[0] - f13_x_p119_lanes[0] * f13_x_p1356_lanes[5];
  const Real f13_x_p2252 = f13_x_p1287_lanes[0] - f13_x_p119_lanes[0] * f13_x_p1356_lanes[4];
  const Real f13_x_p2253 = f13_x_p1289_lanes[0] - f13_x_p119_lanes[0] * f13_x_p1356_lanes[3];
  const Lanes<8> f13_x_p2259_lanes = s11 * detail::make_pack<Real>(f13_x_p2238_lanes[0],
      f13_x_p2238_lanes[1], f13_x_p2238_lanes[0], f13_x_p2245, f13_x_p2244, f13_x_p2243,
      f13_x_p2238_lanes[0], f13_x_p2238_lanes[0]) + c11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p2253, f13_x_p2252, f13_x_p2251, s13, s13);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p2264_lanes = detail::make_pack<Real>(f13_x_p2259_lanes[0],
      f13_x_p2259_lanes[1], f13_x_p1300_lanes[0], f13_x_p2259_lanes[3], f13_x_p2259_lanes[4],
      f13_x_p2259_lanes[5], f13_x_p2259_lanes[0], f13_x_p2259_lanes[0]) - f13_x_p191_lanes[0] *
      detail::make_pack<Real>(f13_x_p2152_lanes[0], f13_x_p2152_lanes[1], f13_x_p1213_lanes[0],
      f13_x_p2152_lanes[3], f13_x_p2152_lanes[4], f13_x_p2152_lanes[5], f13_x_p2152_lanes[0],
      f13_x_p2152_lanes[0]);

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2282_lanes = c10 * f13_x_p2178_lanes + s10 * f13_x_p2190_lanes + 0.282 *
      f13_x_p2264_lanes - f13_x_p2208_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p2316_lanes = c11 * detail::make_pack<Real>(f13_x_p2238_lanes[0],
      f13_x_p2238_lanes[1], f13_x_p2238_lanes[0], f13_x_p2245, f13_x_p2244, f13_x_p2243,
      f13_x_p2238_lanes[0], f13_x_p2238_lanes[0]) - s11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p2253, f13_x_p2252, f13_x_p2251, s13, s13);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p2321_lanes = detail::make_pack<Real>(f13_x_p2316_lanes[0],
      f13_x_p2316_lanes[1], f13_x_p1339_lanes[0], f13_x_p2316_lanes[3], f13_x_p2316_lanes[4],
      f13_x_p2316_lanes[5], f13_x_p2316_lanes[0], f13_x_p2316_lanes[0]) - f13_x_p317_lanes[0] *
      detail::make_pack<Real>(f13_x_p2152_lanes[0], f13_x_p2152_lanes[1], f13_x_p1213_lanes[0],
      f13_x_p2152_lanes[3], f13_x_p2152_lanes[4], f13_x_p2152_lanes[5], f13_x_p2152_lanes[0],
      f13_x_p2152_lanes[0]);
  const Lanes<8> f13_x_p2344_lanes = -detail::make_pack<Real>(-f13_x_p2098_lanes[0],
      -f13_x_p2096_lanes[0], neg_s12_lanes[0], f13_x_p1387_lanes[0], f13_x_p1377_lanes[0],
      f13_x_p1367_lanes[0], -f13_x_p2098_lanes[0], -f13_x_p2098_lanes[0]) - f13_x_p363_lanes[0] *
      detail::make_pack<Real>(f13_x_p2152_lanes[0], f13_x_p2152_lanes[1], f13_x_p1213_lanes[0],
      f13_x_p2152_lanes[3], f13_x_p2152_lanes[4], f13_x_p2152_lanes[5], f13_x_p2152_lanes[0],
      f13_x_p2152_lanes[0]);
  const Lanes<8> f13_x_p2356_lanes = s10 * f13_x_p2344_lanes - c10 * f13_x_p2321_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2368_lanes = 0.282 * f13_x_p2356_lanes - f13_x_p401_lanes[0] *
      f13_x_p2202_lanes;
  const Lanes<8> f13_x_p2380_lanes = c9 * f13_x_p2282_lanes - s9 * f13_x_p2368_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2410_lanes = s9 * f13_x_p2282_lanes + c9 * f13_x_p2368_lanes -
      inverse_D7_p1_lanes[0] * f13_x_p2380_lanes;
  const Lanes<8> f13_x_p2422_lanes = f13_x_p1444_lanes[0] * f13_x_p2380_lanes;
  const Lanes<8> f13_x_p2434_lanes = s8 * f13_x_p2422_lanes + c8 * f13_x_p2410_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p2448 = -f13_x_p2105 + f13_x_p569_lanes[1] * f13_x_p2091;
  const Real f13_x_p2449 = f13_x_p2093 - f13_x_p577_lanes[1] * f13_x_p2091;
  const Real f13_x_p2450 = -f13_x_p2125 + f13_x_p569_lanes[1] * f13_x_p2119;
  const Real f13_x_p2451 = f13_x_p2121 - f13_x_p577_lanes[1] * f13_x_p2119;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2470_lanes = -f13_x_p2356_lanes + f13_x_p569_lanes[0] * f13_x_p2202_lanes;
  const Lanes<8> f13_x_p2488_lanes = f13_x_p2264_lanes - f13_x_p577_lanes[0] * f13_x_p2202_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2506_lanes = c9 * f13_x_p2470_lanes - s9 * f13_x_p2488_lanes -
      f13_x_p657_lanes[0] * f13_x_p2380_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2512_lanes = detail::make_pack<Real>(f13_x_p2506_lanes[0],
      f13_x_p2506_lanes[1], f13_x_p2506_lanes[2], f13_x_p2506_lanes[3], f13_x_p2506_lanes[4],
      f13_x_p2506_lanes[5], c16 * f13_x_p2450 - s16 * f13_x_p2451 - f13_x_p657_lanes[1] *
      f13_x_p2127, c16 * f13_x_p2448 - s16 * f13_x_p2449 - f13_x_p657_lanes[1] * f13_x_p2107) -
      detail::make_pack<Real>(f13_x_p679_lanes[0], f13_x_p679_lanes[0], f13_x_p679_lanes[0],
      f13_x_p679_lanes[0], f13_x_p679_lanes[0], f13_x_p679_lanes[0], f13_x_p679_lanes[1],
      f13_x_p679_lanes[1]) * detail::make_pack<Real>(f13_x_p2434_lanes[0], f13_x_p2434_lanes[1],
      f13_x_p2434_lanes[2], f13_x_p2434_lanes[3], f13_x_p2434_lanes[4], f13_x_p2434_lanes[5],
      f13_x_p2130, f13_x_p2110);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p2536 = s16 * f13_x_p2448 + c16 * f13_x_p2449 - f13_x_p609_lanes[1] *
      f13_x_p2107;
  const Real f13_x_p2537 = -(-(s17 * f13_x_p2095 + c17 * f13_x_p2104) + f13_x_p515_lanes[1] *
      f13_x_p2091) + f13_x_p555_lanes[1] * f13_x_p2107;
  const Real f13_x_p2538 = s16 * f13_x_p2450 + c16 * f13_x_p2451 - f13_x_p609_lanes[1] *
      f13_x_p2127;
  const Real f13_x_p2539 = -(-(s17 * f13_x_p2123 + c17 * f13_x_p2124) + f13_x_p515_lanes[1] *
      f13_x_p2119) + f13_x_p555_lanes[1] * f13_x_p2127;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2564_lanes = s9 * f13_x_p2470_lanes + c9 * f13_x_p2488_lanes -
      f13_x_p609_lanes[0] * f13_x_p2380_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p2612_lanes = -(s10 * f13_x_p2321_lanes + c10 * f13_x_p2344_lanes) +
      f13_x_p515_lanes[0] * f13_x_p2202_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2624_lanes = -f13_x_p2612_lanes + f13_x_p555_lanes[0] * f13_x_p2380_lanes;
  const Lanes<8> f13_x_p2636_lanes = c8 * f13_x_p2624_lanes - s8 * f13_x_p2564_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2642_lanes = detail::make_pack<Real>(f13_x_p2636_lanes[0],
      f13_x_p2636_lanes[1], f13_x_p2636_lanes[2], f13_x_p2636_lanes[3], f13_x_p2636_lanes[4],
      f13_x_p2636_lanes[5], c15 * f13_x_p2539 - s15 * f13_x_p2538, c15 * f13_x_p2537 - s15 *
      f13_x_p2536) - detail::make_pack<Real>(f13_x_p639_lanes[0], f13_x_p639_lanes[0],
      f13_x_p639_lanes[0], f13_x_p639_lanes[0], f13_x_p639_lanes[0], f13_x_p639_lanes[0],
      f13_x_p639_lanes[1], f13_x_p639_lanes[1]) * detail::make_pack<Real>(f13_x_p2434_lanes[0],
      f13_x_p2434_lanes[1], f13_x_p2434_lanes[2], f13_x_p2434_lanes[3], f13_x_p2434_lanes[4],
      f13_x_p2434_lanes[5], f13_x_p2130, f13_x_p2110);
  const Lanes<8> f13_x_p2658_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p2512_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p2642_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2694_lanes = s8 * f13_x_p2624_lanes + c8 * f13_x_p2564_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2700_lanes = detail::make_pack<Real>(f13_x_p2694_lanes[0],
      f13_x_p2694_lanes[1], f13_x_p2694_lanes[2], f13_x_p2694_lanes[3], f13_x_p2694_lanes[4],
      f13_x_p2694_lanes[5], s15 * f13_x_p2539 + c15 * f13_x_p2538, s15 * f13_x_p2537 + c15 *
      f13_x_p2536) - detail::make_pack<Real>(f13_x_p837_lanes[0], f13_x_p837_lanes[0],
      f13_x_p837_lanes[0], f13_x_p837_lanes[0], f13_x_p837_lanes[0], f13_x_p837_lanes[0],
      f13_x_p837_lanes[1], f13_x_p837_lanes[1]) * detail::make_pack<Real>(f13_x_p2434_lanes[0],
      f13_x_p2434_lanes[1], f13_x_p2434_lanes[2], f13_x_p2434_lanes[3], f13_x_p2434_lanes[4],
      f13_x_p2434_lanes[5], f13_x_p2130, f13_x_p2110);
  const Lanes<8> f13_x_p2716_lanes = 0.226 * f13_x_p2700_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      f13_x_p2658_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2744_lanes = c8 * f13_x_p2422_lanes - s8 * f13_x_p2410_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2750_lanes = detail::make_pack<Real>(f13_x_p2744_lanes[0],
      f13_x_p2744_lanes[1], f13_x_p2744_lanes[2], f13_x_p2744_lanes[3], f13_x_p2744_lanes[4],
      f13_x_p2744_lanes[5], c15 * f13_x_p2129 - s15 * f13_x_p2128, c15 * f13_x_p2109 - s15 *
      f13_x_p2108) - detail::make_pack<Real>(inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[1], inverse_D6_p5_lanes[1]) *
      detail::make_pack<Real>(f13_x_p2434_lanes[0], f13_x_p2434_lanes[1], f13_x_p2434_lanes[2],
      f13_x_p2434_lanes[3], f13_x_p2434_lanes[4], f13_x_p2434_lanes[5], f13_x_p2130, f13_x_p2110);
  const Lanes<8> f13_x_p2766_lanes = detail::make_pack<Real>(f13_x_p1650_lanes[0],
      f13_x_p1650_lanes[0], f13_x_p1650_lanes[0], f13_x_p1650_lanes[0], f13_x_p1650_lanes[0],
      f13_x_p1650_lanes[0], f13_x_p1650_lanes[1], f13_x_p1650_lanes[1]) *
      detail::make_pack<Real>(f13_x_p2434_lanes[0], f13_x_p2434_lanes[1], f13_x_p2434_lanes[2],
      f13_x_p2434_lanes[3], f13_x_p2434_lanes[4], f13_x_p2434_lanes[5], f13_x_p2130, f13_x_p2110);

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2798_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p2766_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p2750_lanes + f13_x_p2716_lanes);
  const Lanes<8> f13_x_p2806_lanes = inverse_D5_p16 * f13_x_p2798_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2830_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p2512_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p2642_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2878_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18,
      (-0.18), (-0.18)) * f13_x_p2830_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * f13_x_p2766_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p2750_lanes) - f13_x_p2806_lanes;
  const Lanes<8> f13_x_p2910_lanes = 0.226 * f13_x_p2830_lanes - inverse_D5_p22 * f13_x_p2798_lanes;
  const Lanes<8> f13_x_p2942_lanes = f13_x_p2830_lanes - f13_x_p993 * f13_x_p2798_lanes;
  const Lanes<8> f13_x_p2958_lanes = s6 * f13_x_p2878_lanes + c6 * f13_x_p2910_lanes + 0.072 *
      f13_x_p2942_lanes;
  const Lanes<8> f13_x_p2982_lanes = f13_x_p2658_lanes + f13_x_p930 * f13_x_p2798_lanes;
  const Lanes<8> f13_x_p3006_lanes = f13_x_p2700_lanes - f13_x_p984 * f13_x_p2798_lanes;
  const Lanes<8> f13_x_p3022_lanes = s6 * f13_x_p2982_lanes + c6 * f13_x_p3006_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3046_lanes = -(0.072 * f13_x_p3022_lanes) + f13_x_p1020 * f13_x_p2958_lanes;
  const Lanes<8> f13_x_p3094_lanes = c6 * f13_x_p2878_lanes - s6 * f13_x_p2910_lanes - f13_x_p1022 *
      f13_x_p2958_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3118_lanes = -(s5 * f13_x_p3046_lanes + c5 * f13_x_p3094_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3166_lanes = f13_x_p3022_lanes - f13_x_p1005 * f13_x_p2958_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3190_lanes = -(s5 * f13_x_p3094_lanes - c5 * f13_x_p3046_lanes +
      0.21799999999999997 * f13_x_p3166_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3254_lanes = c6 * f13_x_p2982_lanes - s6 * f13_x_p3006_lanes - f13_x_p1033 *
      f13_x_p2958_lanes;
  const Lanes<8> f13_x_p3278_lanes = f13_x_p2942_lanes - f13_x_p1029 * f13_x_p2958_lanes;
  const Lanes<8> f13_x_p3294_lanes = s5 * f13_x_p3254_lanes - c5 * f13_x_p3278_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3326_lanes = c4 * (-(0.21799999999999997 * f13_x_p3294_lanes) +
      inverse_D3_p2 * f13_x_p3118_lanes);
  const Lanes<8> f13_x_p3334_lanes = s4 * (f13_x_p3190_lanes - inverse_D3_p1 * f13_x_p3118_lanes) +
      f13_x_p3326_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3342_lanes = f13_x_p1063 * f13_x_p3334_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3398_lanes = s4 * (f13_x_p3166_lanes + f13_x_p1050 * f13_x_p3118_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3414_lanes = c4 * (-f13_x_p3294_lanes + f13_x_p1041 * f13_x_p3118_lanes) -
      f13_x_p3398_lanes - f13_x_p3342_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3478_lanes = -(s5 * f13_x_p3278_lanes + c5 * f13_x_p3254_lanes) -
      f13_x_p1068 * f13_x_p3118_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3494_lanes = -f13_x_p3478_lanes + f13_x_p1073 * f13_x_p3334_lanes;
  const Lanes<8> f13_x_p3510_lanes = c3 * f13_x_p3414_lanes - s3 * f13_x_p3494_lanes;
  const Lanes<8> f13_x_p3518_lanes = 0.422 * f13_x_p3510_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p3590_lanes = s2 * (s3 * f13_x_p3414_lanes + c3 * f13_x_p3494_lanes -
      f13_x_p2046 * f13_x_p3518_lanes);
  const Lanes<8> f13_x_p3606_lanes = 0.434 * (c2 * (f13_x_p3510_lanes - f13_x_p1080 *
      f13_x_p3518_lanes) - f13_x_p3590_lanes);
  const Lanes<8> f13_x_p3618_lanes = f13_x_p2028_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3626_lanes = f13_x_p1936_lanes * inverse_D3;
  const Lanes<8> f13_x_p3630_lanes = f13_x_p3626_lanes * f13_x_p3334_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3634_lanes = f13_x_p1828_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3642_lanes = f13_x_p1748_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3650_lanes = f13_x_p1668_lanes * inverse_D6;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3666_lanes = f13_x_p3650_lanes * f13_x_p2798_lanes[0] + f13_x_p3642_lanes *
      f13_x_p2958_lanes[0] + f13_x_p3634_lanes * f13_x_p3118_lanes[0] + f13_x_p3630_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3674_lanes = f13_x_p3666_lanes + f13_x_p3618_lanes * f13_x_p3518_lanes[0] +
      f13_x_p2079_lanes * f13_x_p3606_lanes[0];
  const Lanes<8> f13_x_p3678_lanes = f13_x_p3606_lanes * inverse_D1;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p3694_lanes = f13_x_p3518_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3710_lanes = f13_x_p3334_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3726_lanes = f13_x_p3118_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3742_lanes = f13_x_p2958_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Real f13_x_p3758 = f13_x_p2798_lanes[7] * inverse_D6;
  const Real f13_x_p3759 = f13_x_p2798_lanes[6] * inverse_D6;
  const Lanes<8> f13_x_p3760_lanes = f13_x_p2798_lanes * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3772_lanes = f13_x_p2434_lanes * inverse_D7_lanes[0];
  const Lanes<8> f13_x_p3778_lanes = f13_x_p3772_lanes * f13_x_p2434_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p3784_lanes = f13_x_p2380_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p3796_lanes = f13_x_p2202_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p3808_lanes = detail::make_pack<Real>(f13_x_p2152_lanes[0],
      f13_x_p2152_lanes[1], f13_x_p1213_lanes[0], f13_x_p2152_lanes[3], f13_x_p2152_lanes[4],
      f13_x_p2152_lanes[5], f13_x_p2152_lanes[0], f13_x_p2152_lanes[0]) * inverse_D10_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3832_lanes = f13_x_p3808_lanes * f13_x_p2152_lanes[0] + f13_x_p3796_lanes *
      f13_x_p2202_lanes[0] + f13_x_p3784_lanes * f13_x_p2380_lanes[0] + f13_x_p3778_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3838_lanes = f13_x_p3832_lanes + f13_x_p3760_lanes * f13_x_p2798_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3860_lanes = detail::make_pack<Real>(f13_x_p3838_lanes[0],
      f13_x_p3838_lanes[1], f13_x_p3838_lanes[2], f13_x_p3838_lanes[3], f13_x_p3838_lanes[4],
      f13_x_p3838_lanes[5], f13_x_p3759 * f13_x_p2798_lanes[0], f13_x_p3758 *
      f13_x_p2798_lanes[0]) + f13_x_p3742_lanes * f13_x_p2958_lanes[0] + f13_x_p3726_lanes *
      f13_x_p3118_lanes[0] + f13_x_p3710_lanes * f13_x_p3334_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3876_lanes = f13_x_p3860_lanes + f13_x_p3694_lanes * f13_x_p3518_lanes[0] +
      f13_x_p3678_lanes * f13_x_p3606_lanes[0];
  const Real f13_x_p3884 = 1.0 / f13_x_p3876_lanes[0];
  const Lanes<8> f13_x_p3885_lanes = f13_x_p3674_lanes * f13_x_p3884;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3901_lanes = f13_x_p3626_lanes * f13_x_p3334_lanes[1];
  const Lanes<8> f13_x_p3925_lanes = f13_x_p3650_lanes * f13_x_p2798_lanes[1] + f13_x_p3642_lanes *
      f13_x_p2958_lanes[1] + f13_x_p3634_lanes * f13_x_p3118_lanes[1] + f13_x_p3901_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3937_lanes = f13_x_p3925_lanes + f13_x_p3618_lanes * f13_x_p3518_lanes[1] +
      f13_x_p2079_lanes * f13_x_p3606_lanes[1] - f13_x_p3885_lanes * f13_x_p3876_lanes[1];
  const Lanes<8> f13_x_p3941_lanes = f13_x_p3876_lanes * f13_x_p3884;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3995_lanes = f13_x_p3772_lanes * f13_x_p2434_lanes[1];
  const Lanes<8> f13_x_p4025_lanes = f13_x_p3808_lanes * f13_x_p2152_lanes[1] + f13_x_p3796_lanes *
      f13_x_p2202_lanes[1] + f13_x_p3784_lanes * f13_x_p2380_lanes[1] + f13_x_p3995_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4030_lanes = f13_x_p4025_lanes + f13_x_p3760_lanes * f13_x_p2798_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4049_lanes = detail::make_pack<Real>(f13_x_p4030_lanes[1],
      f13_x_p4030_lanes[1], f13_x_p4030_lanes[2], f13_x_p4030_lanes[3], f13_x_p4030_lanes[4],
      f13_x_p4030_lanes[5], f13_x_p3759 * f13_x_p2798_lanes[1], f13_x_p3758 *
      f13_x_p2798_lanes[1]) + f13_x_p3742_lanes * f13_x_p2958_lanes[1] + f13_x_p3726_lanes *
      f13_x_p3118_lanes[1] + f13_x_p3710_lanes * f13_x_p3334_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4070_lanes = f13_x_p4049_lanes + f13_x_p3694_lanes * f13_x_p3518_lanes[1] +
      f13_x_p3678_lanes * f13_x_p3606_lanes[1] - f13_x_p3941_lanes * f13_x_p3876_lanes[1];
  const Real f13_x_p4077 = 1.0 / f13_x_p4070_lanes[1];
  const Lanes<8> f13_x_p4078_lanes = f13_x_p3937_lanes * f13_x_p4077;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4098_lanes = f13_x_p3626_lanes * f13_x_p3334_lanes[2];
  const Lanes<8> f13_x_p4122_lanes = f13_x_p3650_lanes * f13_x_p2798_lanes[2] + f13_x_p3642_lanes *
      f13_x_p2958_lanes[2] + f13_x_p3634_lanes * f13_x_p3118_lanes[2] + f13_x_p4098_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4134_lanes = f13_x_p4122_lanes + f13_x_p3618_lanes * f13_x_p3518_lanes[2] +
      f13_x_p2079_lanes * f13_x_p3606_lanes[2] - f13_x_p3885_lanes * f13_x_p3876_lanes[2];
  const Lanes<8> f13_x_p4138_lanes = f13_x_p4134_lanes - f13_x_p4078_lanes * f13_x_p4070_lanes[2];
  const Lanes<8> f13_x_p4142_lanes = f13_x_p4070_lanes * f13_x_p4077;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p4194_lanes = f13_x_p3772_lanes * f13_x_p2434_lanes[2];
  const Lanes<8> f13_x_p4218_lanes = f13_x_p3808_lanes * f13_x_p1213_lanes[0] + f13_x_p3796_lanes *
      f13_x_p2202_lanes[2] + f13_x_p3784_lanes * f13_x_p2380_lanes[2] + f13_x_p4194_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4222_lanes = f13_x_p4218_lanes + f13_x_p3760_lanes * f13_x_p2798_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4238_lanes = detail::make_pack<Real>(f13_x_p4222_lanes[2],
      f13_x_p4222_lanes[2], f13_x_p4222_lanes[2], f13_x_p4222_lanes[3], f13_x_p4222_lanes[4],
      f13_x_p4222_lanes[5], f13_x_p3759 * f13_x_p2798_lanes[2], f13_x_p3758 *
      f13_x_p2798_lanes[2]) + f13_x_p3742_lanes * f13_x_p2958_lanes[2] + f13_x_p3726_lanes *
      f13_x_p3118_lanes[2] + f13_x_p3710_lanes * f13_x_p3334_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4256_lanes = f13_x_p4238_lanes + f13_x_p3694_lanes * f13_x_p3518_lanes[2] +
      f13_x_p3678_lanes * f13_x_p3606_lanes[2] - f13_x_p3941_lanes * f13_x_p3876_lanes[2];
  const Lanes<8> f13_x_p4262_lanes = f13_x_p4256_lanes - f13_x_p4142_lanes * f13_x_p4070_lanes[2];
  const Real f13_x_p4268 = 1.0 / f13_x_p4262_lanes[2];
  const Lanes<8> f13_x_p4269_lanes = f13_x_p4138_lanes * f13_x_p4268;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4293_lanes = f13_x_p3626_lanes * f13_x_p3334_lanes[3];
  const Lanes<8> f13_x_p4317_lanes = f13_x_p3650_lanes * f13_x_p2798_lanes[3] + f13_x_p3642_lanes *
      f13_x_p2958_lanes[3] + f13_x_p3634_lanes * f13_x_p3118_lanes[3] + f13_x_p4293_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4329_lanes = f13_x_p4317_lanes + f13_x_p3618_lanes * f13_x_p3518_lanes[3] +
      f13_x_p2079_lanes * f13_x_p3606_lanes[3] - f13_x_p3885_lanes * f13_x_p3876_lanes[3];
  const Lanes<8> f13_x_p4337_lanes = f13_x_p4329_lanes - f13_x_p4078_lanes * f13_x_p4070_lanes[3] -
      f13_x_p4269_lanes * f13_x_p4262_lanes[3];
  const Lanes<8> f13_x_p4341_lanes = f13_x_p4262_lanes * f13_x_p4268;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p4395_lanes = f13_x_p3796_lanes * f13_x_p2202_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p4401_lanes = f13_x_p1356_lanes * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p4407_lanes = detail::make_pack<Real>(s13, s13, s13, s13, c13,
      f13_x_p1085_lanes[0], s13, s13) * inverse_D12_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p4419_lanes = f13_x_p4407_lanes * s13 + f13_x_p4401_lanes *
      f13_x_p1356_lanes[3] + f13_x_p3808_lanes * f13_x_p2152_lanes[3] + f13_x_p4395_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4428_lanes = f13_x_p4419_lanes + f13_x_p3784_lanes * f13_x_p2380_lanes[3] +
      f13_x_p3772_lanes * f13_x_p2434_lanes[3] + f13_x_p3760_lanes * f13_x_p2798_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4441_lanes = detail::make_pack<Real>(f13_x_p4428_lanes[3],
      f13_x_p4428_lanes[3], f13_x_p4428_lanes[3], f13_x_p4428_lanes[3], f13_x_p4428_lanes[4],
      f13_x_p4428_lanes[5], f13_x_p3759 * f13_x_p2798_lanes[3], f13_x_p3758 *
      f13_x_p2798_lanes[3]) + f13_x_p3742_lanes * f13_x_p2958_lanes[3] + f13_x_p3726_lanes *
      f13_x_p3118_lanes[3] + f13_x_p3710_lanes * f13_x_p3334_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4456_lanes = f13_x_p4441_lanes + f13_x_p3694_lanes * f13_x_p3518_lanes[3] +
      f13_x_p3678_lanes * f13_x_p3606_lanes[3] - f13_x_p3941_lanes * f13_x_p3876_lanes[3];
  const Lanes<8> f13_x_p4466_lanes = f13_x_p4456_lanes - f13_x_p4142_lanes * f13_x_p4070_lanes[3] -
      f13_x_p4341_lanes * f13_x_p4262_lanes[3];
  const Real f13_x_p4471 = 1.0 / f13_x_p4466_lanes[3];
  const Lanes<8> f13_x_p4472_lanes = f13_x_p4337_lanes * f13_x_p4471;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4500_lanes = f13_x_p3626_lanes * f13_x_p3334_lanes[4];
  const Lanes<8> f13_x_p4524_lanes = f13_x_p3650_lanes * f13_x_p2798_lanes[4] + f13_x_p3642_lanes *
      f13_x_p2958_lanes[4] + f13_x_p3634_lanes * f13_x_p3118_lanes[4] + f13_x_p4500_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4536_lanes = f13_x_p4524_lanes + f13_x_p3618_lanes * f13_x_p3518_lanes[4] +
      f13_x_p2079_lanes * f13_x_p3606_lanes[4] - f13_x_p3885_lanes * f13_x_p3876_lanes[4];
  const Lanes<8> f13_x_p4548_lanes = f13_x_p4536_lanes - f13_x_p4078_lanes * f13_x_p4070_lanes[4] -
      f13_x_p4269_lanes * f13_x_p4262_lanes[4] - f13_x_p4472_lanes * f13_x_p4466_lanes[4];
  const Lanes<8> f13_x_p4552_lanes = f13_x_p4466_lanes * f13_x_p4471;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p4592_lanes = f13_x_p1102_lanes * inverse_D11_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p4595_lanes = detail::make_pack<Real>(f13_x_p4401_lanes[5],
      f13_x_p4592_lanes[3]) * detail::make_pack<Real>(f13_x_p1356_lanes[4], f13_x_p1102_lanes[2]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p4607_lanes = f13_x_p4407_lanes * c13 +
      detail::make_pack<Real>(f13_x_p4401_lanes[4] * f13_x_p1356_lanes[4], f13_x_p4401_lanes[4] *
      f13_x_p1356_lanes[4], f13_x_p4401_lanes[4] * f13_x_p1356_lanes[4], f13_x_p4401_lanes[4] *
      f13_x_p1356_lanes[4], f13_x_p4401_lanes[4] * f13_x_p1356_lanes[4], f13_x_p4595_lanes[0],
      f13_x_p4401_lanes[4] * f13_x_p1356_lanes[4], f13_x_p4401_lanes[4] * f13_x_p1356_lanes[4]) +
      detail::make_pack<Real>(f13_x_p3808_lanes[4] * f13_x_p2152_lanes[4], f13_x_p3808_lanes[4] *
      f13_x_p2152_lanes[4], f13_x_p3808_lanes[4] * f13_x_p2152_lanes[4], f13_x_p3808_lanes[4] *
      f13_x_p2152_lanes[4], f13_x_p3808_lanes[4] * f13_x_p2152_lanes[4], f13_x_p3808_lanes[5] *
      f13_x_p2152_lanes[4], f13_x_p3808_lanes[4] * f13_x_p2152_lanes[4], f13_x_p3808_lanes[4] *
      f13_x_p2152_lanes[4]) + detail::make_pack<Real>(f13_x_p3796_lanes[4] * f13_x_p2202_lanes[4],
      f13_x_p3796_lanes[4] * f13_x_p2202_lanes[4], f13_x_p3796_lanes[4] * f13_x_p2202_lanes[4],
      f13_x_p3796_lanes[4] * f13_x_p2202_lanes[4], f13_x_p3796_lanes[4] * f13_x_p2202_lanes[4],
      f13_x_p3796_lanes[5] * f13_x_p2202_lanes[4], f13_x_p3796_lanes[4] * f13_x_p2202_lanes[4],
      f13_x_p3796_lanes[4] * f13_x_p2202_lanes[4]) + detail::make_pack<Real>(f13_x_p3784_lanes[4] *
      f13_x_p2380_lanes[4], f13_x_p3784_lanes[4] * f13_x_p2380_lanes[4], f13_x_p3784_lanes[4] *
      f13_x_p2380_lanes[4], f13_x_p3784_lanes[4] * f13_x_p2380_lanes[4], f13_x_p3784_lanes[4] *
      f13_x_p2380_lanes[4], f13_x_p3784_lanes[5] * f13_x_p2380_lanes[4], f13_x_p3784_lanes[4] *
      f13_x_p2380_lanes[4], f13_x_p3784_lanes[4] * f13_x_p2380_lanes[4]) +
      detail::make_pack<Real>(f13_x_p3772_lanes[4] * f13_x_p2434_lanes[4], f13_x_p3772_lanes[4] *
      f13_x_p2434_lanes[4], f13_x_p3772_lanes[4] * f13_x_p2434_lanes[4], f13_x_p3772_lanes[4] *
      f13_x_p2434_lanes[4], f13_x_p3772_lanes[4] * f13_x_p2434_lanes[4], f13_x_p3772_lanes[5] *
      f13_x_p2434_lanes[4], f13_x_p3772_lanes[4] * f13_x_p2434_lanes[4], f13_x_p3772_lanes[4] *
      f13_x_p2434_lanes[4]);

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4609_lanes = f13_x_p4607_lanes +
      detail::make_pack<Real>(f13_x_p3760_lanes[4] * f13_x_p2798_lanes[4], f13_x_p3760_lanes[4] *
      f13_x_p2798_lanes[4], f13_x_p3760_lanes[4] * f13_x_p2798_lanes[4], f13_x_p3760_lanes[4] *
      f13_x_p2798_lanes[4], f13_x_p3760_lanes[4] * f13_x_p2798_lanes[4], f13_x_p3760_lanes[5] *
      f13_x_p2798_lanes[4], f13_x_p3760_lanes[4] * f13_x_p2798_lanes[4], f13_x_p3760_lanes[4] *
      f13_x_p2798_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4619_lanes = detail::make_pack<Real>(f13_x_p4609_lanes[4],
      f13_x_p4609_lanes[4], f13_x_p4609_lanes[4], f13_x_p4609_lanes[4], f13_x_p4609_lanes[4],
      f13_x_p4609_lanes[5], f13_x_p3759 * f13_x_p2798_lanes[4], f13_x_p3758 *
      f13_x_p2798_lanes[4]) + f13_x_p3742_lanes * f13_x_p2958_lanes[4] + f13_x_p3726_lanes *
      f13_x_p3118_lanes[4] + f13_x_p3710_lanes * f13_x_p3334_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4631_lanes = f13_x_p4619_lanes + f13_x_p3694_lanes * f13_x_p3518_lanes[4] +
      f13_x_p3678_lanes * f13_x_p3606_lanes[4] - f13_x_p3941_lanes * f13_x_p3876_lanes[4];
  const Lanes<8> f13_x_p4643_lanes = f13_x_p4631_lanes - f13_x_p4142_lanes * f13_x_p4070_lanes[4] -
      f13_x_p4341_lanes * f13_x_p4262_lanes[4] - f13_x_p4552_lanes * f13_x_p4466_lanes[4];
  const Real f13_x_p4647 = 1.0 / f13_x_p4643_lanes[4];
  const Lanes<8> f13_x_p4648_lanes = f13_x_p4548_lanes * f13_x_p4647;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4680_lanes = f13_x_p3626_lanes * f13_x_p3334_lanes[5];
  const Lanes<8> f13_x_p4704_lanes = f13_x_p3650_lanes * f13_x_p2798_lanes[5] + f13_x_p3642_lanes *
      f13_x_p2958_lanes[5] + f13_x_p3634_lanes * f13_x_p3118_lanes[5] + f13_x_p4680_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4716_lanes = f13_x_p4704_lanes + f13_x_p3618_lanes * f13_x_p3518_lanes[5] +
      f13_x_p2079_lanes * f13_x_p3606_lanes[5] - f13_x_p3885_lanes * f13_x_p3876_lanes[5];
  const Lanes<8> f13_x_p4728_lanes = f13_x_p4716_lanes - f13_x_p4078_lanes * f13_x_p4070_lanes[5] -
      f13_x_p4269_lanes * f13_x_p4262_lanes[5] - f13_x_p4472_lanes * f13_x_p4466_lanes[5];
  const Lanes<8> f13_x_p4732_lanes = f13_x_p4728_lanes - f13_x_p4648_lanes * f13_x_p4643_lanes[5];
  const Lanes<8> f13_x_p4736_lanes = f13_x_p4643_lanes * f13_x_p4647;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4769_lanes = f13_x_p1454_lanes * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p4775_lanes = f13_x_p1416_lanes * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p4781_lanes = f13_x_p1248_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p4787_lanes = detail::make_pack<Real>(f13_x_p1213_lanes[1],
      f13_x_p1206_lanes[1], f13_x_p1206_lanes[2], f13_x_p1206_lanes[3], f13_x_p1213_lanes[1],
      f13_x_p1213_lanes[1], f13_x_p1213_lanes[1], f13_x_p1213_lanes[1]) * inverse_D10_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p4795_lanes = detail::make_pack<Real>(s20, s20, c20, f13_x_p1085_lanes[1],
      s20, s20, s20, s20) * inverse_D12_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p4804_lanes = 1065.380700001509 +
      detail::make_pack<Real>(f13_x_p4407_lanes[5], f13_x_p4795_lanes[3]) * f13_x_p1085_lanes +
      detail::make_pack<Real>(f13_x_p4401_lanes[5], f13_x_p4592_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1356_lanes[5], f13_x_p1102_lanes[3]) +
      detail::make_pack<Real>(f13_x_p3808_lanes[5], f13_x_p4787_lanes[3]) *
      detail::make_pack<Real>(f13_x_p2152_lanes[5], f13_x_p1206_lanes[3]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p4810_lanes = f13_x_p4804_lanes +
      detail::make_pack<Real>(f13_x_p3796_lanes[5], f13_x_p4781_lanes[3]) *
      detail::make_pack<Real>(f13_x_p2202_lanes[5], f13_x_p1248_lanes[3]) +
      detail::make_pack<Real>(f13_x_p3784_lanes[5], f13_x_p4775_lanes[3]) *
      detail::make_pack<Real>(f13_x_p2380_lanes[5], f13_x_p1416_lanes[3]) +
      detail::make_pack<Real>(f13_x_p3772_lanes[5], f13_x_p4769_lanes[3]) *
      detail::make_pack<Real>(f13_x_p2434_lanes[5], f13_x_p1454_lanes[3]);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4818_lanes = detail::make_pack<Real>(f13_x_p4810_lanes[0] +
      f13_x_p3760_lanes[5] * f13_x_p2798_lanes[5], f13_x_p4810_lanes[0] + f13_x_p3760_lanes[5] *
      f13_x_p2798_lanes[5], f13_x_p4810_lanes[0] + f13_x_p3760_lanes[5] * f13_x_p2798_lanes[5],
      f13_x_p4810_lanes[0] + f13_x_p3760_lanes[5] * f13_x_p2798_lanes[5], f13_x_p4810_lanes[0] +
      f13_x_p3760_lanes[5] * f13_x_p2798_lanes[5], f13_x_p4810_lanes[0] + f13_x_p3760_lanes[5] *
      f13_x_p2798_lanes[5], f13_x_p3759 * f13_x_p2798_lanes[5], f13_x_p3758 *
      f13_x_p2798_lanes[5]) + f13_x_p3742_lanes * f13_x_p2958_lanes[5] + f13_x_p3726_lanes *
      f13_x_p3118_lanes[5] + f13_x_p3710_lanes * f13_x_p3334_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4827_lanes = f13_x_p4818_lanes + f13_x_p3694_lanes * f13_x_p3518_lanes[5] +
      f13_x_p3678_lanes * f13_x_p3606_lanes[5] - f13_x_p3941_lanes * f13_x_p3876_lanes[5];
  const Lanes<8> f13_x_p4836_lanes = f13_x_p4827_lanes - f13_x_p4142_lanes * f13_x_p4070_lanes[5] -
      f13_x_p4341_lanes * f13_x_p4262_lanes[5] - f13_x_p4552_lanes * f13_x_p4466_lanes[5];
  const Lanes<8> f13_x_p4839_lanes = f13_x_p4836_lanes - f13_x_p4736_lanes * f13_x_p4643_lanes[5];
  const Real f13_x_p4842 = 1.0 / f13_x_p4839_lanes[5];
  const Lanes<8> f13_x_p4843_lanes = f13_x_p4732_lanes * f13_x_p4842;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4895_lanes = f13_x_p4769_lanes * f13_x_p2130;
  const Lanes<8> f13_x_p4919_lanes = f13_x_p4787_lanes * f13_x_p2116 + f13_x_p4781_lanes *
      f13_x_p2119 + f13_x_p4775_lanes * f13_x_p2127 + f13_x_p4895_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p4931_lanes = f13_x_p4919_lanes + f13_x_p3650_lanes * f13_x_p2798_lanes[6] +
      f13_x_p3642_lanes * f13_x_p2958_lanes[6] + f13_x_p3634_lanes * f13_x_p3118_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4943_lanes = f13_x_p4931_lanes + f13_x_p3626_lanes * f13_x_p3334_lanes[6] +
      f13_x_p3618_lanes * f13_x_p3518_lanes[6] + f13_x_p2079_lanes * f13_x_p3606_lanes[6];
  const Lanes<8> f13_x_p4955_lanes = f13_x_p4943_lanes - f13_x_p3885_lanes * f13_x_p3876_lanes[6] -
      f13_x_p4078_lanes * f13_x_p4070_lanes[6] - f13_x_p4269_lanes * f13_x_p4262_lanes[6];
  const Lanes<8> f13_x_p4967_lanes = f13_x_p4955_lanes - f13_x_p4472_lanes * f13_x_p4466_lanes[6] -
      f13_x_p4648_lanes * f13_x_p4643_lanes[6] - f13_x_p4843_lanes * f13_x_p4839_lanes[6];
  const Real f13_x_p4971 = f13_x_p4839_lanes[6] * f13_x_p4842;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4972 = f13_x_p2116 * inverse_D10_lanes[1] * f13_x_p2116 + f13_x_p2119 *
      inverse_D9_lanes[1] * f13_x_p2119 + f13_x_p2127 * inverse_D8_lanes[1] * f13_x_p2127;

  // link 4 (chest1), force propagation
  const Real f13_x_p4973 = f13_x_p4972 + f13_x_p2130 * inverse_D7_lanes[1] * f13_x_p2130 +
      f13_x_p3759 * f13_x_p2798_lanes[6] + f13_x_p3742_lanes[6] * f13_x_p2958_lanes[6] +
      f13_x_p3726_lanes[6] * f13_x_p3118_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p4974 = f13_x_p4973 + f13_x_p3710_lanes[6] * f13_x_p3334_lanes[6] +
      f13_x_p3694_lanes[6] * f13_x_p3518_lanes[6] + f13_x_p3678_lanes[6] * f13_x_p3606_lanes[6] -
      f13_x_p3941_lanes[6] * f13_x_p3876_lanes[6];
  const Real f13_x_p4975 = f13_x_p4974 - f13_x_p4142_lanes[6] * f13_x_p4070_lanes[6] -
      f13_x_p4341_lanes[6] * f13_x_p4262_lanes[6] - f13_x_p4552_lanes[6] * f13_x_p4466_lanes[6] -
      f13_x_p4736_lanes[6] * f13_x_p4643_lanes[6];
  const Real f13_x_p4976 = 1.0 / (f13_x_p4975 - f13_x_p4971 * f13_x_p4839_lanes[6]);
  const Lanes<8> f13_x_p4977_lanes = f13_x_p4967_lanes * f13_x_p4976;
  const Real f13_x_p4981 = f13_x_p4839_lanes[7] * f13_x_p4842;

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p4982 = f13_x_p2110 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4983 = f13_x_p2107 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p4984 = f13_x_p2091 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p4985 = f13_x_p2088 * inverse_D10_lanes[1];

  // link 6 (chest3), force propagation
  const Real f13_x_p4986 = f13_x_p4985 * f13_x_p2116 + f13_x_p4984 * f13_x_p2119 + f13_x_p4983 *
      f13_x_p2127 + f13_x_p4982 * f13_x_p2130 + f13_x_p3758 * f13_x_p2798_lanes[6];

  // link 2 (thigh), force propagation
  const Real f13_x_p4987 = f13_x_p4986 + f13_x_p3742_lanes[7] * f13_x_p2958_lanes[6] +
      f13_x_p3726_lanes[7] * f13_x_p3118_lanes[6] + f13_x_p3710_lanes[7] * f13_x_p3334_lanes[6] +
      f13_x_p3694_lanes[7] * f13_x_p3518_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p4988 = f13_x_p4987 + f13_x_p3678_lanes[7] * f13_x_p3606_lanes[6] -
      f13_x_p3941_lanes[7] * f13_x_p3876_lanes[6] - f13_x_p4142_lanes[7] * f13_x_p4070_lanes[6] -
      f13_x_p4341_lanes[7] * f13_x_p4262_lanes[6];
  const Real f13_x_p4989 = f13_x_p4988 - f13_x_p4552_lanes[7] * f13_x_p4466_lanes[6] -
      f13_x_p4736_lanes[7] * f13_x_p4643_lanes[6] - f13_x_p4981 * f13_x_p4839_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p5042_lanes = f13_x_p4769_lanes * f13_x_p2110;
  const Lanes<8> f13_x_p5066_lanes = f13_x_p4787_lanes * f13_x_p2088 + f13_x_p4781_lanes *
      f13_x_p2091 + f13_x_p4775_lanes * f13_x_p2107 + f13_x_p5042_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p5078_lanes = f13_x_p5066_lanes + f13_x_p3650_lanes * f13_x_p2798_lanes[7] +
      f13_x_p3642_lanes * f13_x_p2958_lanes[7] + f13_x_p3634_lanes * f13_x_p3118_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p5090_lanes = f13_x_p5078_lanes + f13_x_p3626_lanes * f13_x_p3334_lanes[7] +
      f13_x_p3618_lanes * f13_x_p3518_lanes[7] + f13_x_p2079_lanes * f13_x_p3606_lanes[7];
  const Lanes<8> f13_x_p5102_lanes = f13_x_p5090_lanes - f13_x_p3885_lanes * f13_x_p3876_lanes[7] -
      f13_x_p4078_lanes * f13_x_p4070_lanes[7] - f13_x_p4269_lanes * f13_x_p4262_lanes[7];
  const Lanes<8> f13_x_p5114_lanes = f13_x_p5102_lanes - f13_x_p4472_lanes * f13_x_p4466_lanes[7] -
      f13_x_p4648_lanes * f13_x_p4643_lanes[7] - f13_x_p4843_lanes * f13_x_p4839_lanes[7];
  const Lanes<8> f13_x_p5118_lanes = f13_x_p5114_lanes - f13_x_p4977_lanes * f13_x_p4989;
  const Real f13_x_p5122 = f13_x_p4989 * f13_x_p4976;

  // link 6 (chest3), force propagation
  const Real f13_x_p5123 = f13_x_p4985 * f13_x_p2088 + f13_x_p4984 * f13_x_p2091 + f13_x_p4983 *
      f13_x_p2107 + f13_x_p4982 * f13_x_p2110 + f13_x_p3758 * f13_x_p2798_lanes[7];

  // link 2 (thigh), force propagation
  const Real f13_x_p5124 = f13_x_p5123 + f13_x_p3742_lanes[7] * f13_x_p2958_lanes[7] +
      f13_x_p3726_lanes[7] * f13_x_p3118_lanes[7] + f13_x_p3710_lanes[7] * f13_x_p3334_lanes[7] +
      f13_x_p3694_lanes[7] * f13_x_p3518_lanes[7];

  // link 1 (calf), force propagation
  const Real f13_x_p5125 = f13_x_p5124 + f13_x_p3678_lanes[7] * f13_x_p3606_lanes[7] -
      f13_x_p3941_lanes[7] * f13_x_p3876_lanes[7] - f13_x_p4142_lanes[7] * f13_x_p4070_lanes[7] -
      f13_x_p4341_lanes[7] * f13_x_p4262_lanes[7];
  const Real f13_x_p5126 = f13_x_p5125 - f13_x_p4552_lanes[7] * f13_x_p4466_lanes[7] -
      f13_x_p4736_lanes[7] * f13_x_p4643_lanes[7] - f13_x_p4981 * f13_x_p4839_lanes[7] -
      f13_x_p5122 * f13_x_p4989;
  const Real f13_x_p5127 = 1.0 / f13_x_p5126;
  const Lanes<8> f13_x_p5128_lanes = f13_x_p5118_lanes * f13_x_p5127;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p5188_lanes = f13_x_p4769_lanes * f13_x_p1454_lanes[0];
  const Lanes<8> f13_x_p5212_lanes = f13_x_p4787_lanes * f13_x_p1213_lanes[1] + f13_x_p4781_lanes *
      f13_x_p1248_lanes[0] + f13_x_p4775_lanes * f13_x_p1416_lanes[0] + f13_x_p5188_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p5224_lanes = f13_x_p5212_lanes + f13_x_p3650_lanes * f13_x_p1668_lanes[0] +
      f13_x_p3642_lanes * f13_x_p1748_lanes[0] + f13_x_p3634_lanes * f13_x_p1828_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p5236_lanes = f13_x_p5224_lanes + f13_x_p3626_lanes * f13_x_p1936_lanes[0] +
      f13_x_p3618_lanes * f13_x_p2028_lanes[0] + f13_x_p2079_lanes * f13_x_p2075_lanes[0];
  const Lanes<8> f13_x_p5248_lanes = f13_x_p5236_lanes - f13_x_p3885_lanes * f13_x_p3674_lanes[0] -
      f13_x_p4078_lanes * f13_x_p3937_lanes[0] - f13_x_p4269_lanes * f13_x_p4138_lanes[0];
  const Lanes<8> f13_x_p5260_lanes = f13_x_p5248_lanes - f13_x_p4472_lanes * f13_x_p4337_lanes[0] -
      f13_x_p4648_lanes * f13_x_p4548_lanes[0] - f13_x_p4843_lanes * f13_x_p4732_lanes[0];
  const Lanes<8> f13_x_p5268_lanes = f13_x_p5260_lanes - f13_x_p4977_lanes * f13_x_p4967_lanes[0] -
      f13_x_p5128_lanes * f13_x_p5118_lanes[0];
  const Real f13_x_p5272 = 1.0 / f13_x_p5268_lanes[0];
  const Lanes<8> f13_x_p5273_lanes = f13_x_p5268_lanes * f13_x_p5272;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p5327_lanes = f13_x_p4781_lanes * f13_x_p1248_lanes[1];
  const Lanes<8> f13_x_p5345_lanes = f13_x_p4795_lanes * s20 + f13_x_p4592_lanes *
      f13_x_p1102_lanes[1] + f13_x_p4787_lanes * f13_x_p1206_lanes[1] + f13_x_p5327_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p5354_lanes = f13_x_p5345_lanes + f13_x_p4775_lanes * f13_x_p1416_lanes[1] +
      f13_x_p4769_lanes * f13_x_p1454_lanes[1] + f13_x_p3650_lanes * f13_x_p1668_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p5363_lanes = f13_x_p5354_lanes + f13_x_p3642_lanes * f13_x_p1748_lanes[1] +
      f13_x_p3634_lanes * f13_x_p1828_lanes[1] + f13_x_p3626_lanes * f13_x_p1936_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p5372_lanes = f13_x_p5363_lanes + f13_x_p3618_lanes * f13_x_p2028_lanes[1] +
      f13_x_p2079_lanes * f13_x_p2075_lanes[1] - f13_x_p3885_lanes * f13_x_p3674_lanes[1];
  const Lanes<8> f13_x_p5381_lanes = f13_x_p5372_lanes - f13_x_p4078_lanes * f13_x_p3937_lanes[1] -
      f13_x_p4269_lanes * f13_x_p4138_lanes[1] - f13_x_p4472_lanes * f13_x_p4337_lanes[1];
  const Lanes<8> f13_x_p5390_lanes = f13_x_p5381_lanes - f13_x_p4648_lanes * f13_x_p4548_lanes[1] -
      f13_x_p4843_lanes * f13_x_p4732_lanes[1] - f13_x_p4977_lanes * f13_x_p4967_lanes[1];
  const Lanes<8> f13_x_p5396_lanes = f13_x_p5390_lanes - f13_x_p5128_lanes * f13_x_p5118_lanes[1] -
      f13_x_p5273_lanes * f13_x_p5268_lanes[1];
  const Real f13_x_p5399 = 1.0 / f13_x_p5396_lanes[1];
  const Real f13_x_p5400 = f13_x_p5396_lanes[3] * f13_x_p5399;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p5401_lanes = f13_x_p4795_lanes * c20;

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p5403 = f13_x_p5401_lanes[3] + f13_x_p4595_lanes[1] + f13_x_p4787_lanes[3] *
      f13_x_p1206_lanes[2] + f13_x_p4781_lanes[3] * f13_x_p1248_lanes[2] + f13_x_p4775_lanes[3] *
      f13_x_p1416_lanes[2] + f13_x_p4769_lanes[3] * f13_x_p1454_lanes[2];

  // link 3 (hip), force propagation
  const Real f13_x_p5404 = f13_x_p5403 + f13_x_p3650_lanes[3] * f13_x_p1668_lanes[2] +
      f13_x_p3642_lanes[3] * f13_x_p1748_lanes[2] + f13_x_p3634_lanes[3] * f13_x_p1828_lanes[2] +
      f13_x_p3626_lanes[3] * f13_x_p1936_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p5405 = f13_x_p5404 + f13_x_p3618_lanes[3] * f13_x_p2028_lanes[2] +
      f13_x_p2079_lanes[3] * f13_x_p2075_lanes[2] - f13_x_p3885_lanes[3] * f13_x_p3674_lanes[2] -
      f13_x_p4078_lanes[3] * f13_x_p3937_lanes[2];
  const Real f13_x_p5406 = f13_x_p5405 - f13_x_p4269_lanes[3] * f13_x_p4138_lanes[2] -
      f13_x_p4472_lanes[3] * f13_x_p4337_lanes[2] - f13_x_p4648_lanes[3] * f13_x_p4548_lanes[2] -
      f13_x_p4843_lanes[3] * f13_x_p4732_lanes[2];
  const Real f13_x_p5407 = f13_x_p5406 - f13_x_p4977_lanes[3] * f13_x_p4967_lanes[2] -
      f13_x_p5128_lanes[3] * f13_x_p5118_lanes[2] - f13_x_p5273_lanes[3] * f13_x_p5268_lanes[2] -
      f13_x_p5400 * f13_x_p5396_lanes[2];
  const Real f13_x_p5408 = f13_x_p5396_lanes[2] * f13_x_p5399;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p5409 = f13_x_p5401_lanes[2] + f13_x_p4592_lanes[2] * f13_x_p1102_lanes[2] +
      f13_x_p4787_lanes[2] * f13_x_p1206_lanes[2] + f13_x_p4781_lanes[2] * f13_x_p1248_lanes[2] +
      f13_x_p4775_lanes[2] * f13_x_p1416_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p5410 = f13_x_p5409 + f13_x_p4769_lanes[2] * f13_x_p1454_lanes[2] +
      f13_x_p3650_lanes[2] * f13_x_p1668_lanes[2] + f13_x_p3642_lanes[2] * f13_x_p1748_lanes[2] +
      f13_x_p3634_lanes[2] * f13_x_p1828_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p5411 = f13_x_p5410 + f13_x_p3626_lanes[2] * f13_x_p1936_lanes[2] +
      f13_x_p3618_lanes[2] * f13_x_p2028_lanes[2] + f13_x_p2079_lanes[2] * f13_x_p2075_lanes[2] -
      f13_x_p3885_lanes[2] * f13_x_p3674_lanes[2];
  const Real f13_x_p5412 = f13_x_p5411 - f13_x_p4078_lanes[2] * f13_x_p3937_lanes[2] -
      f13_x_p4269_lanes[2] * f13_x_p4138_lanes[2] - f13_x_p4472_lanes[2] * f13_x_p4337_lanes[2] -
      f13_x_p4648_lanes[2] * f13_x_p4548_lanes[2];
  const Real f13_x_p5413 = f13_x_p5412 - f13_x_p4843_lanes[2] * f13_x_p4732_lanes[2] -
      f13_x_p4977_lanes[2] * f13_x_p4967_lanes[2] - f13_x_p5128_lanes[2] * f13_x_p5118_lanes[2] -
      f13_x_p5273_lanes[2] * f13_x_p5268_lanes[2];
  const Real f13_x_p5414 = 1.0 / (f13_x_p5413 - f13_x_p5408 * f13_x_p5396_lanes[2]);
  const Real f13_x_p5415 = f13_x_p5407 * f13_x_p5414;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5418_lanes = 9.81 + detail::make_pack<Real>(xdd_cmd[2], xdd_cmd[8]);
  const Lanes<2> f13_x_p5422_lanes = c1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) - s1 *
      f13_x_p5418_lanes;
  const Lanes<2> f13_x_p5430_lanes = s1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) + c1 *
      f13_x_p5418_lanes;
  const Lanes<2> f13_x_p5434_lanes = c2 * f13_x_p5422_lanes - s2 * f13_x_p5430_lanes;
  const Lanes<2> f13_x_p5442_lanes = s2 * f13_x_p5422_lanes + c2 * f13_x_p5430_lanes;
  const Lanes<2> f13_x_p5446_lanes = c3 * f13_x_p5434_lanes - s3 * f13_x_p5442_lanes;
  const Lanes<2> f13_x_p5452_lanes = c4 * f13_x_p5446_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Lanes<2> f13_x_p5460_lanes = s3 * f13_x_p5434_lanes + c3 * f13_x_p5442_lanes;
  const Lanes<2> f13_x_p5464_lanes = s5 * f13_x_p5452_lanes + c5 * f13_x_p5460_lanes;
  const Lanes<2> f13_x_p5472_lanes = c4 * detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]) - s4 *
      f13_x_p5446_lanes;
  const Lanes<2> f13_x_p5476_lanes = s6 * f13_x_p5472_lanes - c6 * f13_x_p5464_lanes;
  const Lanes<2> f13_x_p5484_lanes = c5 * f13_x_p5452_lanes - s5 * f13_x_p5460_lanes;
  const Lanes<2> f13_x_p5488_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p5476_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p5484_lanes;
  const Lanes<2> f13_x_p5496_lanes = s6 * f13_x_p5464_lanes + c6 * f13_x_p5472_lanes;
  const Lanes<2> f13_x_p5500_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5496_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p5488_lanes;
  const Lanes<2> f13_x_p5508_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p5476_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p5484_lanes;
  const Lanes<2> f13_x_p5512_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p5500_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p5508_lanes;
  const Lanes<2> f13_x_p5520_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5488_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p5496_lanes;
  const Lanes<2> f13_x_p5524_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5512_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p5520_lanes;
  const Lanes<2> f13_x_p5532_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p5500_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p5508_lanes;
  const Lanes<2> f13_x_p5536_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5524_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p5532_lanes;
  const Lanes<2> f13_x_p5544_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5520_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p5512_lanes;
  const Lanes<2> f13_x_p5548_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5544_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p5536_lanes;
  const Lanes<2> f13_x_p5556_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5532_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p5524_lanes;

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real a2_y_p2 = 0.434 * qdd_0[0] - minus_a1_x;
  const Real a2_y = c2 * a2_y_p1 - s2 * a2_y_p2;
  const Real w2_z = qd[0] + qd[1];
  const Real a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real a3_y_p2 = a2_y + 0.422 * a3_y_p1;

  // link 2 (thigh), outward
  const Real a2_x = c2 * a2_y_p2 + s2 * a2_y_p1;
  const Real wd2_z = qdd_0[0] + qdd_0[1];

  // link 3 (hip), outward
  const Real a3_y_p3 = a2_x + 0.422 * wd2_z;
  const Real a3_y = c3 * a3_y_p2 - s3 * a3_y_p3;
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real a5_y_p1 = w4_x * w4_x;
  const Real w4_y = c4 * w3_z;
  const Real a5_y_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * (a5_y_p1 + a5_y_p2);

  // link 3 (hip), outward
  const Real a3_x = c3 * a3_y_p3 + s3 * a3_y_p2;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 3 (hip), outward
  const Real wd3_z = wd2_z + qdd_0[2];

  // link 4 (chest1), outward
  const Real a5_y_p4 = c4 * wd3_z;

  // link 5 (chest2), outward
  const Real a5_y_p5 = a4_x + 0.21799999999999997 * a5_y_p4;
  const Real a5_y = c5 * a5_y_p3 - s5 * a5_y_p5;
  const Real w5_x = c5 * w4_x - s5 * qd[3];
  const Real a6_x_p1 = w5_x * w5_x;
  const Real w5_z = w4_y + qd[4];
  const Real a6_x_p2 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;
  const Real a6_x_p4 = a5_y + 0.072 * a6_x_p3;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;
  const Real minus_a5_z_p1 = s4 * wd3_z;

  // link 5 (chest2), outward
  const Real minus_a5_z = minus_a4_y + 0.21799999999999997 * minus_a5_z_p1;

  // link 4 (chest1), outward
  const Real wd4_x_p1 = w4_y * qd[3];
  const Real wd4_x = minus_a5_z_p1 + wd4_x_p1;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];
  const Real wd5_x = c5 * wd4_x - s5 * qdd_0[3] - minus_w5_y * qd[4];
  const Real a6_x_p5 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p6 = minus_a5_z + 0.072 * a6_x_p5;
  const Real a6_x = c6 * a6_x_p4 - s6 * a6_x_p6;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_z = w5_x + qd[5];
  const Real a7_x_p1 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a7_x_p2 = w6_y * w6_y + a7_x_p1;

  // link 14 (right_shoulder1), outward
  const Real a7_x_p3 = a6_x + 0.226 * a7_x_p2;

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real a7_x_p4 = w6_x * w6_y;
  const Real wd6_z = wd5_x + qdd_0[5];
  const Real a7_x_p5 = a7_x_p4 - wd6_z;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_p7_lanes = a7_x_p3 + detail::make_pack<Real>(0.18, (-0.18)) * a7_x_p5;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a5_y_p5 + s5 * a5_y_p3;
  const Real a6_z_p1 = w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real wd4_y_p1 = w4_x * qd[3];
  const Real wd4_y = a5_y_p4 - wd4_y_p1;

  // link 5 (chest2), outward
  const Real wd5_z = wd4_y + qdd_0[4];
  const Real a6_z_p2 = a6_z_p1 + wd5_z;

  // link 6 (chest3), outward
  const Real a6_z = a5_x + 0.072 * a6_z_p2;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + c5 * qdd_0[3] + w5_x * qd[4];

  // link 6 (chest3), outward
  const Real wd6_y = s6 * minus_wd5_y + c6 * wd5_z - w6_x * qd[5];
  const Real a7_x_p9 = w6_x * w6_z - wd6_y;

  // link 14 (right_shoulder1), outward
  const Real a7_x_p10 = a6_z - 0.226 * a7_x_p9;

  // link 6 (chest3), outward
  const Real a7_x_p11 = w6_y * w6_z;
  const Real wd6_x = s6 * wd5_z - c6 * minus_wd5_y + w6_y * qd[5];
  const Real a7_x_p12 = a7_x_p11 + wd6_x;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_p14_lanes = a7_x_p10 + detail::make_pack<Real>(0.18, (-0.18)) * a7_x_p12;
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_x_p7_lanes +
      detail::make_pack<Real>(c7, c14) * a7_x_p14_lanes;
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_x_p7_lanes -
      detail::make_pack<Real>(s7, s14) * a7_x_p14_lanes;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p4 + c6 * a6_x_p6;
  const Real minus_a7_z_p1 = a7_x_p4 + wd6_z;

  // link 14 (right_shoulder1), outward
  const Real minus_a7_z_p2 = minus_a6_y + 0.226 * minus_a7_z_p1;

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = w6_x * w6_x;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p4 = minus_a7_z_p3 + a7_x_p1;
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p2 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p4;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Lanes<2> wd7_y_lanes = detail::make_pack<Real>(c7, c14) * wd6_x -
      detail::make_pack<Real>(s7, s14) * wd6_z - w7_x_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);
  const Lanes<2> wd7_z_lanes = wd6_y + detail::make_pack<Real>(qdd_0[6], qdd_0[13]);
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;
  const Lanes<2> wd8_y_lanes = detail::make_pack<Real>(c8, c15) * wd7_z_lanes -
      detail::make_pack<Real>(s8, s15) * wd7_y_lanes - w8_x_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_x_lanes = detail::make_pack<Real>(s7, s14) * wd6_x +
      detail::make_pack<Real>(c7, c14) * wd6_z + w7_y_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_z_lanes = wd7_x_lanes + detail::make_pack<Real>(qdd_0[7], qdd_0[14]);
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;
  const Lanes<2> wd9_y_lanes = detail::make_pack<Real>(c9, c16) * wd8_y_lanes -
      detail::make_pack<Real>(s9, s16) * wd8_z_lanes - w9_x_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> w9_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_x_lanes;
  const Lanes<2> a10_x_p1_lanes = w9_x_lanes * w9_z_lanes;
  const Lanes<2> a10_x_p2_lanes = a10_x_p1_lanes + wd9_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p4_lanes = a9_x_lanes - 0.282 * a10_x_p2_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a10_x_p6_lanes = w9_x_lanes * w9_x_lanes;
  const Lanes<2> w9_y_lanes = detail::make_pack<Real>(c9, c16) * w8_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_z_lanes;
  const Lanes<2> a10_x_p7_lanes = w9_y_lanes * w9_y_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p10_lanes = 0.282 * (a10_x_p6_lanes + a10_x_p7_lanes) - a8_x_lanes;
  const Lanes<2> a10_x_lanes = detail::make_pack<Real>(c10, c17) * a10_x_p4_lanes -
      detail::make_pack<Real>(s10, s17) * a10_x_p10_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;
  const Lanes<2> wd9_x_lanes = detail::make_pack<Real>(s9, s16) * wd8_y_lanes +
      detail::make_pack<Real>(c9, c16) * wd8_z_lanes + w9_y_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> minus_a10_z_p1_lanes = w9_y_lanes * w9_z_lanes;
  const Lanes<2> minus_a10_z_p2_lanes = minus_a10_z_p1_lanes - wd9_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * minus_a10_z_p2_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_z_lanes = wd9_y_lanes + detail::make_pack<Real>(qdd_0[9], qdd_0[16]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_lanes = detail::make_pack<Real>(c8, c15) * wd7_y_lanes +
      detail::make_pack<Real>(s8, s15) * wd7_z_lanes + w8_y_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 9 (left_upperarm), outward
  const Lanes<2> wd9_z_lanes = detail::make_pack<Real>(qdd_0[8], qdd_0[15]) - wd8_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;
  const Lanes<2> wd10_x_lanes = detail::make_pack<Real>(c10, c17) * wd9_x_lanes -
      detail::make_pack<Real>(s10, s17) * wd9_z_lanes - minus_w10_y_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;
  const Lanes<2> wd11_y_lanes = detail::make_pack<Real>(c11, c18) * wd10_z_lanes -
      detail::make_pack<Real>(s11, s18) * wd10_x_lanes - w11_x_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> w11_z_lanes = minus_w10_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> minus_a12_y_p1_lanes = w11_x_lanes * w11_z_lanes;
  const Lanes<2> minus_a12_y_p2_lanes = minus_a12_y_p1_lanes + wd11_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p4_lanes = a11_x_lanes - 0.269 * minus_a12_y_p2_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a10_y_lanes = detail::make_pack<Real>(s10, s17) * a10_x_p4_lanes +
      detail::make_pack<Real>(c10, c17) * a10_x_p10_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a12_y_p6_lanes = w11_x_lanes * w11_x_lanes;
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;
  const Lanes<2> minus_a12_y_p7_lanes = w11_y_lanes * w11_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p10_lanes = minus_a10_y_lanes + 0.269 *
      (minus_a12_y_p6_lanes + minus_a12_y_p7_lanes);
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p4_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p10_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;
  const Lanes<2> wd11_x_lanes = detail::make_pack<Real>(c11, c18) * wd10_x_lanes +
      detail::make_pack<Real>(s11, s18) * wd10_z_lanes + w11_y_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> minus_a12_z_p1_lanes = w11_y_lanes * w11_z_lanes;
  const Lanes<2> minus_a12_z_p2_lanes = minus_a12_z_p1_lanes - wd11_x_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_z_lanes = minus_a11_y_lanes + 0.269 * minus_a12_z_p2_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> minus_a13_x_lanes = detail::make_pack<Real>(c13, c20) * minus_a12_y_lanes +
      detail::make_pack<Real>(s13, s20) * minus_a12_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);

  // link 13 (left_hand), outward
  const Lanes<2> w13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_w12_y_lanes +
      detail::make_pack<Real>(c13, c20) * w12_z_lanes;
  const Lanes<2> f13_x_p5562_lanes = w13_y_lanes * w13_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> f13_x_p5564_lanes = w13_z_lanes * w13_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5566_lanes = f13_x_p5562_lanes + f13_x_p5564_lanes;
  const Lanes<2> f13_x_p5572_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5548_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p5556_lanes +
      (minus_a13_x_lanes + 0.086 * f13_x_p5566_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> a13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_a12_y_lanes -
      detail::make_pack<Real>(c13, c20) * minus_a12_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5580_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5556_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p5548_lanes - a13_y_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5586_lanes = c1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) - s1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);
  const Lanes<2> f13_x_p5594_lanes = s1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) + c1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);
  const Lanes<2> f13_x_p5598_lanes = c2 * f13_x_p5586_lanes - s2 * f13_x_p5594_lanes;
  const Lanes<2> f13_x_p5606_lanes = s2 * f13_x_p5586_lanes + c2 * f13_x_p5594_lanes;
  const Lanes<2> f13_x_p5610_lanes = c3 * f13_x_p5598_lanes - s3 * f13_x_p5606_lanes;
  const Lanes<2> f13_x_p5616_lanes = c4 * f13_x_p5610_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> f13_x_p5624_lanes = s3 * f13_x_p5598_lanes + c3 * f13_x_p5606_lanes;
  const Lanes<2> f13_x_p5628_lanes = s5 * f13_x_p5616_lanes + c5 * f13_x_p5624_lanes;
  const Lanes<2> f13_x_p5636_lanes = c4 * detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]) - s4 *
      f13_x_p5610_lanes;
  const Lanes<2> f13_x_p5640_lanes = s6 * f13_x_p5636_lanes - c6 * f13_x_p5628_lanes;
  const Lanes<2> f13_x_p5648_lanes = c5 * f13_x_p5616_lanes - s5 * f13_x_p5624_lanes;
  const Lanes<2> f13_x_p5652_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p5640_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p5648_lanes;
  const Lanes<2> f13_x_p5660_lanes = s6 * f13_x_p5628_lanes + c6 * f13_x_p5636_lanes;
  const Lanes<2> f13_x_p5664_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5660_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p5652_lanes;
  const Lanes<2> f13_x_p5672_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p5640_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p5648_lanes;
  const Lanes<2> f13_x_p5676_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p5664_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p5672_lanes;
  const Lanes<2> f13_x_p5684_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5652_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p5660_lanes;
  const Lanes<2> f13_x_p5688_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5676_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p5684_lanes;
  const Lanes<2> f13_x_p5696_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p5664_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p5672_lanes;
  const Lanes<2> f13_x_p5700_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5688_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p5696_lanes;
  const Lanes<2> f13_x_p5708_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5684_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p5676_lanes;
  const Lanes<2> f13_x_p5712_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5700_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p5708_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_x_lanes = detail::make_pack<Real>(s13, s20) * w12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_w12_y_lanes;
  const Lanes<2> f13_x_p5714_lanes = w13_x_lanes * w13_y_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5718_lanes = 0.086 * (f13_x_p5714_lanes + f13_x_p5712_lanes);
  const Real f13_x_p5720 = f13_x_p5580_lanes[0] - f13_x_p3941_lanes[1] * f13_x_p5572_lanes[0] -
      f13_x_p5718_lanes[0];

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p4_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p10_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5727_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5536_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p5544_lanes - a12_x_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5733_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5696_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p5688_lanes;
  const Lanes<2> f13_x_p5741_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5708_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p5700_lanes;
  const Lanes<2> f13_x_p5745_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5733_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p5741_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p5747_lanes = w13_x_lanes * w13_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5751_lanes = 0.086 * (f13_x_p5745_lanes - f13_x_p5747_lanes);
  const Real f13_x_p5753 = f13_x_p5727_lanes[0] - f13_x_p3941_lanes[2] * f13_x_p5572_lanes[0] -
      f13_x_p4142_lanes[2] * f13_x_p5720 + f13_x_p5751_lanes[0];

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_z_lanes = wd11_y_lanes + detail::make_pack<Real>(qdd_0[11], qdd_0[18]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_wd10_y_lanes = detail::make_pack<Real>(s10, s17) * wd9_x_lanes +
      detail::make_pack<Real>(c10, c17) * wd9_z_lanes + w10_x_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_z_lanes = minus_wd10_y_lanes + detail::make_pack<Real>(qdd_0[10], qdd_0[17]);

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_wd12_y_lanes = detail::make_pack<Real>(s12, s19) * wd11_x_lanes +
      detail::make_pack<Real>(c12, c19) * wd11_z_lanes + w12_x_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 13 (left_hand), outward
  const Lanes<2> wd13_x_lanes = detail::make_pack<Real>(s13, s20) * wd12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_wd12_y_lanes + w13_y_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5760_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5741_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p5733_lanes - wd13_x_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p5762 = f13_x_p5760_lanes[0] - f13_x_p3941_lanes[3] * f13_x_p5572_lanes[0] -
      f13_x_p4142_lanes[3] * f13_x_p5720 - f13_x_p4341_lanes[3] * f13_x_p5753;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_wd12_y_lanes +
      detail::make_pack<Real>(c13, c20) * wd12_z_lanes - w13_x_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5763_lanes = f13_x_p5745_lanes - wd13_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p5765 = f13_x_p5763_lanes[0] - f13_x_p3941_lanes[4] * f13_x_p5572_lanes[0] -
      f13_x_p4142_lanes[4] * f13_x_p5720 - f13_x_p4341_lanes[4] * f13_x_p5753 -
      f13_x_p4552_lanes[4] * f13_x_p5762;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(c12, c19) * wd11_x_lanes -
      detail::make_pack<Real>(s12, s19) * wd11_z_lanes - minus_w12_y_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 13 (left_hand), outward
  const Lanes<2> wd13_z_lanes = wd12_x_lanes + detail::make_pack<Real>(qdd_0[12], qdd_0[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5766_lanes = f13_x_p5712_lanes - wd13_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p5768 = f13_x_p5766_lanes[0] - f13_x_p3941_lanes[5] * f13_x_p5572_lanes[0] -
      f13_x_p4142_lanes[5] * f13_x_p5720 - f13_x_p4341_lanes[5] * f13_x_p5753 -
      f13_x_p4552_lanes[5] * f13_x_p5762;
  const Real f13_x_p5769 = f13_x_p5768 - f13_x_p4736_lanes[5] * f13_x_p5765;
  const Real f13_x_p5770 = f13_x_p5572_lanes[1] - f13_x_p3941_lanes[6] * f13_x_p5572_lanes[0] -
      f13_x_p4142_lanes[6] * f13_x_p5720 - f13_x_p4341_lanes[6] * f13_x_p5753 -
      f13_x_p4552_lanes[6] * f13_x_p5762;
  const Real f13_x_p5771 = f13_x_p5770 - f13_x_p4736_lanes[6] * f13_x_p5765 - f13_x_p4971 *
      f13_x_p5769;
  const Real f13_x_p5772 = f13_x_p5580_lanes[1] - f13_x_p3941_lanes[7] * f13_x_p5572_lanes[0] -
      f13_x_p4142_lanes[7] * f13_x_p5720 - f13_x_p4341_lanes[7] * f13_x_p5753 -
      f13_x_p4552_lanes[7] * f13_x_p5762;
  const Real f13_x_p5773 = f13_x_p5772 - f13_x_p4736_lanes[7] * f13_x_p5765 - f13_x_p4981 *
      f13_x_p5769 - f13_x_p5122 * f13_x_p5771 - f13_x_p5718_lanes[1];
  const Real f13_x_p5774 = f13_x_p5727_lanes[1] - f13_x_p3885_lanes[0] * f13_x_p5572_lanes[0] -
      f13_x_p4078_lanes[0] * f13_x_p5720 - f13_x_p4269_lanes[0] * f13_x_p5753 -
      f13_x_p4472_lanes[0] * f13_x_p5762;
  const Real f13_x_p5775 = f13_x_p5774 - f13_x_p4648_lanes[0] * f13_x_p5765 - f13_x_p4843_lanes[0] *
      f13_x_p5769 - f13_x_p4977_lanes[0] * f13_x_p5771 - f13_x_p5128_lanes[0] * f13_x_p5773;
  const Real f13_x_p5776 = f13_x_p5775 + f13_x_p5751_lanes[1];
  const Real f13_x_p5777 = f13_x_p5760_lanes[1] - f13_x_p3885_lanes[1] * f13_x_p5572_lanes[0] -
      f13_x_p4078_lanes[1] * f13_x_p5720 - f13_x_p4269_lanes[1] * f13_x_p5753 -
      f13_x_p4472_lanes[1] * f13_x_p5762;
  const Real f13_x_p5778 = f13_x_p5777 - f13_x_p4648_lanes[1] * f13_x_p5765 - f13_x_p4843_lanes[1] *
      f13_x_p5769 - f13_x_p4977_lanes[1] * f13_x_p5771 - f13_x_p5128_lanes[1] * f13_x_p5773;
  const Real f13_x_p5779 = f13_x_p5778 - f13_x_p5273_lanes[1] * f13_x_p5776;
  const Real f13_x_p5780 = f13_x_p5763_lanes[1] - f13_x_p3885_lanes[2] * f13_x_p5572_lanes[0] -
      f13_x_p4078_lanes[2] * f13_x_p5720 - f13_x_p4269_lanes[2] * f13_x_p5753 -
      f13_x_p4472_lanes[2] * f13_x_p5762;
  const Real f13_x_p5781 = f13_x_p5780 - f13_x_p4648_lanes[2] * f13_x_p5765 - f13_x_p4843_lanes[2] *
      f13_x_p5769 - f13_x_p4977_lanes[2] * f13_x_p5771 - f13_x_p5128_lanes[2] * f13_x_p5773;
  const Real f13_x_p5782 = f13_x_p5781 - f13_x_p5273_lanes[2] * f13_x_p5776 - f13_x_p5408 *
      f13_x_p5779;
  const Real f13_x_p5783 = f13_x_p5766_lanes[1] - f13_x_p3885_lanes[3] * f13_x_p5572_lanes[0] -
      f13_x_p4078_lanes[3] * f13_x_p5720 - f13_x_p4269_lanes[3] * f13_x_p5753 -
      f13_x_p4472_lanes[3] * f13_x_p5762;
  const Real f13_x_p5784 = f13_x_p5783 - f13_x_p4648_lanes[3] * f13_x_p5765 - f13_x_p4843_lanes[3] *
      f13_x_p5769 - f13_x_p4977_lanes[3] * f13_x_p5771 - f13_x_p5128_lanes[3] * f13_x_p5773;

  // link 3 (hip), force propagation
  const Real f13_x_p5785 = f13_x_p4810_lanes[1] + f13_x_p3650_lanes[3] * f13_x_p1668_lanes[3] +
      f13_x_p3642_lanes[3] * f13_x_p1748_lanes[3] + f13_x_p3634_lanes[3] * f13_x_p1828_lanes[3] +
      f13_x_p3626_lanes[3] * f13_x_p1936_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p5786 = f13_x_p5785 + f13_x_p3618_lanes[3] * f13_x_p2028_lanes[3] +
      f13_x_p2079_lanes[3] * f13_x_p2075_lanes[3] - f13_x_p3885_lanes[3] * f13_x_p3674_lanes[3] -
      f13_x_p4078_lanes[3] * f13_x_p3937_lanes[3];
  const Real f13_x_p5787 = f13_x_p5786 - f13_x_p4269_lanes[3] * f13_x_p4138_lanes[3] -
      f13_x_p4472_lanes[3] * f13_x_p4337_lanes[3] - f13_x_p4648_lanes[3] * f13_x_p4548_lanes[3] -
      f13_x_p4843_lanes[3] * f13_x_p4732_lanes[3];
  const Real f13_x_p5788 = f13_x_p5787 - f13_x_p4977_lanes[3] * f13_x_p4967_lanes[3] -
      f13_x_p5128_lanes[3] * f13_x_p5118_lanes[3] - f13_x_p5273_lanes[3] * f13_x_p5268_lanes[3] -
      f13_x_p5400 * f13_x_p5396_lanes[3];
  const Real f13_x_p5789 = (f13_x_p5784 - f13_x_p5273_lanes[3] * f13_x_p5776 - f13_x_p5400 *
      f13_x_p5779 - f13_x_p5415 * f13_x_p5782) * (1.0 / (f13_x_p5788 - f13_x_p5415 * f13_x_p5407));
  const Real f13_x_p5790 = f13_x_p5782 * f13_x_p5414 - f13_x_p5415 * f13_x_p5789;
  const Real f13_x_p5791 = f13_x_p5779 * f13_x_p5399 - f13_x_p5408 * f13_x_p5790 - f13_x_p5400 *
      f13_x_p5789;
  const Real f13_x_p5792 = f13_x_p5776 * f13_x_p5272 - f13_x_p5273_lanes[1] * f13_x_p5791 -
      f13_x_p5273_lanes[2] * f13_x_p5790 - f13_x_p5273_lanes[3] * f13_x_p5789;
  const Real f13_x_p5793 = f13_x_p5773 * f13_x_p5127 - f13_x_p5128_lanes[0] * f13_x_p5792 -
      f13_x_p5128_lanes[1] * f13_x_p5791 - f13_x_p5128_lanes[2] * f13_x_p5790 -
      f13_x_p5128_lanes[3] * f13_x_p5789;
  const Real f13_x_p5794 = f13_x_p5771 * f13_x_p4976 - f13_x_p5122 * f13_x_p5793 -
      f13_x_p4977_lanes[0] * f13_x_p5792 - f13_x_p4977_lanes[1] * f13_x_p5791 -
      f13_x_p4977_lanes[2] * f13_x_p5790;
  const Real f13_x_p5795 = f13_x_p5794 - f13_x_p4977_lanes[3] * f13_x_p5789;
  const Real f13_x_p5796 = f13_x_p5769 * f13_x_p4842 - f13_x_p4971 * f13_x_p5795 - f13_x_p4981 *
      f13_x_p5793 - f13_x_p4843_lanes[0] * f13_x_p5792 - f13_x_p4843_lanes[1] * f13_x_p5791;
  const Real f13_x_p5797 = f13_x_p5796 - f13_x_p4843_lanes[2] * f13_x_p5790 - f13_x_p4843_lanes[3] *
      f13_x_p5789;
  const Real f13_x_p5798 = f13_x_p5765 * f13_x_p4647 - f13_x_p4736_lanes[5] * f13_x_p5797 -
      f13_x_p4736_lanes[6] * f13_x_p5795 - f13_x_p4736_lanes[7] * f13_x_p5793 -
      f13_x_p4648_lanes[0] * f13_x_p5792;
  const Real f13_x_p5799 = f13_x_p5798 - f13_x_p4648_lanes[1] * f13_x_p5791 - f13_x_p4648_lanes[2] *
      f13_x_p5790 - f13_x_p4648_lanes[3] * f13_x_p5789;
  const Real f13_x_p5800 = f13_x_p5762 * f13_x_p4471 - f13_x_p4552_lanes[4] * f13_x_p5799 -
      f13_x_p4552_lanes[5] * f13_x_p5797 - f13_x_p4552_lanes[6] * f13_x_p5795 -
      f13_x_p4552_lanes[7] * f13_x_p5793;
  const Real f13_x_p5801 = f13_x_p5800 - f13_x_p4472_lanes[0] * f13_x_p5792 - f13_x_p4472_lanes[1] *
      f13_x_p5791 - f13_x_p4472_lanes[2] * f13_x_p5790 - f13_x_p4472_lanes[3] * f13_x_p5789;
  const Real f13_x_p5802 = f13_x_p5753 * f13_x_p4268 - f13_x_p4341_lanes[3] * f13_x_p5801 -
      f13_x_p4341_lanes[4] * f13_x_p5799 - f13_x_p4341_lanes[5] * f13_x_p5797 -
      f13_x_p4341_lanes[6] * f13_x_p5795;
  const Real f13_x_p5803 = f13_x_p5802 - f13_x_p4341_lanes[7] * f13_x_p5793 - f13_x_p4269_lanes[0] *
      f13_x_p5792 - f13_x_p4269_lanes[1] * f13_x_p5791 - f13_x_p4269_lanes[2] * f13_x_p5790;
  const Real f13_x_p5804 = f13_x_p5803 - f13_x_p4269_lanes[3] * f13_x_p5789;
  const Real f13_x_p5805 = f13_x_p5720 * f13_x_p4077 - f13_x_p4142_lanes[2] * f13_x_p5804 -
      f13_x_p4142_lanes[3] * f13_x_p5801 - f13_x_p4142_lanes[4] * f13_x_p5799 -
      f13_x_p4142_lanes[5] * f13_x_p5797;
  const Real f13_x_p5806 = f13_x_p5805 - f13_x_p4142_lanes[6] * f13_x_p5795 - f13_x_p4142_lanes[7] *
      f13_x_p5793 - f13_x_p4078_lanes[0] * f13_x_p5792 - f13_x_p4078_lanes[1] * f13_x_p5791;
  const Real f13_x_p5807 = f13_x_p5806 - f13_x_p4078_lanes[2] * f13_x_p5790 - f13_x_p4078_lanes[3] *
      f13_x_p5789;
  const Real f13_x_p5808 = f13_x_p5572_lanes[0] * f13_x_p3884 - f13_x_p3941_lanes[1] * f13_x_p5807 -
      f13_x_p3941_lanes[2] * f13_x_p5804 - f13_x_p3941_lanes[3] * f13_x_p5801 -
      f13_x_p3941_lanes[4] * f13_x_p5799;
  const Real f13_x_p5809 = f13_x_p5808 - f13_x_p3941_lanes[5] * f13_x_p5797 - f13_x_p3941_lanes[6] *
      f13_x_p5795 - f13_x_p3941_lanes[7] * f13_x_p5793 - f13_x_p3885_lanes[0] * f13_x_p5792;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p5810_lanes = f13_x_p5714_lanes - wd13_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_x_p5813_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      f13_x_p5810_lanes - 0.01626499875 * f13_x_p5566_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_x = f13_x_p5813_lanes[0] + (f13_x_p5809 - f13_x_p3885_lanes[1] * f13_x_p5791 -
      f13_x_p3885_lanes[2] * f13_x_p5790 - f13_x_p3885_lanes[3] * f13_x_p5789);

  // link 13 (left_hand), outward
  const Lanes<2> f13_y_p1_lanes = f13_x_p5714_lanes + wd13_z_lanes;
  const Lanes<2> f13_y_p3_lanes = w13_x_lanes * w13_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_y_p6_lanes = 0.01626499875 * f13_y_p1_lanes -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      (f13_y_p3_lanes + f13_x_p5564_lanes);

  // link 24 (right_eye), inertial wrench
  const Real f13_y = f13_y_p6_lanes[0] + f13_x_p5807;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_y_p1_lanes = w12_x_lanes * minus_w12_y_lanes;
  const Lanes<2> f12_y_p5_lanes = w12_z_lanes * w12_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_y_p8_lanes = 0.0025100003499999995 * (wd12_z_lanes - f12_y_p1_lanes) -
      0.0006000000000000001 * (w12_x_lanes * w12_x_lanes + f12_y_p5_lanes);

  // link 13 (left_hand), inward
  const Real f12_y = f12_y_p8_lanes[0] + (c13 * f13_x - s13 * f13_y);

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p1_lanes = f13_x_p5747_lanes - wd13_y_lanes;
  const Lanes<2> f13_z_p3_lanes = w13_y_lanes * w13_z_lanes;
  const Lanes<2> f13_z_p4_lanes = f13_z_p3_lanes + wd13_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_p6_lanes = 0.01626499875 * f13_z_p1_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * f13_z_p4_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_z = f13_z_p6_lanes[0] + f13_x_p5804;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_x_p1_lanes = minus_w12_y_lanes * minus_w12_y_lanes;
  const Lanes<2> f12_x_p4_lanes = f12_y_p1_lanes + wd12_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_x_p6_lanes = 0.0025100003499999995 * (f12_x_p1_lanes + f12_y_p5_lanes) +
      0.0006000000000000001 * f12_x_p4_lanes;

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - f12_x_p6_lanes[0];

  // link 12 (left_wrist2), inward
  const Real f11_x_p1 = s12 * f12_y - c12 * f12_x;

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_x_p2_lanes = w11_x_lanes * w11_y_lanes;
  const Lanes<2> f11_x_p3_lanes = f11_x_p2_lanes - wd11_z_lanes;
  const Lanes<2> f11_x_p5_lanes = w11_z_lanes * w11_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_x_p8_lanes = detail::make_pack<Real>(0.001, (-0.001)) * f11_x_p3_lanes -
      6e-04 * (minus_a12_y_p7_lanes + f11_x_p5_lanes);

  // link 12 (left_wrist2), inward
  const Real f11_x = f11_x_p8_lanes[0] - f11_x_p1;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_z_p1_lanes = w12_x_lanes * w12_z_lanes;
  const Lanes<2> f12_z_p2_lanes = f12_z_p1_lanes + minus_wd12_y_lanes;
  const Lanes<2> f12_z_p5_lanes = wd12_x_lanes - minus_w12_y_lanes * w12_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_z_p7_lanes = 0.0025100003499999995 * f12_z_p2_lanes + 0.0006000000000000001 *
      f12_z_p5_lanes;

  // link 13 (left_hand), inward
  const Real f12_z = f12_z_p7_lanes[0] + (s13 * f13_x + c13 * f13_y);

  // link 11 (left_wrist1), outward
  const Lanes<2> f11_y_p1_lanes = f11_x_p2_lanes + wd11_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_y_p5_lanes = 6e-04 * f11_y_p1_lanes -
      detail::make_pack<Real>(0.001, (-0.001)) * (minus_a12_y_p6_lanes + f11_x_p5_lanes);

  // link 12 (left_wrist2), inward
  const Real f11_y = f11_y_p5_lanes[0] + f12_z;

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_z_p1_lanes = w10_x_lanes * w10_z_lanes;
  const Lanes<2> f10_z_p2_lanes = f10_z_p1_lanes + minus_wd10_y_lanes;
  const Lanes<2> f10_z_p4_lanes = minus_w10_y_lanes * w10_z_lanes;
  const Lanes<2> f10_z_p5_lanes = wd10_x_lanes - f10_z_p4_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_z_p7_lanes = 0.0014999985000000002 * f10_z_p2_lanes + 0.28049749700000004 *
      f10_z_p5_lanes;

  // link 11 (left_wrist1), inward
  const Real f10_z = f10_z_p7_lanes[0] + (s11 * f11_x + c11 * f11_y);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p8_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * (f13_x_p5564_lanes - f13_x_p5562_lanes);
  const Lanes<2> n13_x_p9_lanes = 9.149209276993575e-05 * f13_z_p4_lanes +
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p1_lanes -
      0.000108260010923775 * f13_y_p1_lanes + n13_x_p8_lanes;
  const Lanes<2> n13_x_p10_lanes = n13_x_p9_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * a12_x_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n13_x = n13_x_p10_lanes[0] + f13_x_p5801;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_y_p8_lanes = 0.000108260010923775 * (f13_y_p3_lanes - f13_x_p5564_lanes);
  const Lanes<2> n13_y_p9_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * f13_x_p5810_lanes - 0.000847139515629375 * f13_z_p1_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p4_lanes +
      n13_y_p8_lanes;
  const Lanes<2> n13_y_p10_lanes = n13_y_p9_lanes - 0.01626499875 * a12_x_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n13_y = n13_y_p10_lanes[0] + f13_x_p5799;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_y_p5_lanes = 0.0025100003499999995 * minus_a12_z_lanes -
      (0.000195227662257343 * f12_z_p2_lanes + detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * f12_x_p4_lanes);

  // link 13 (left_hand), inward
  const Real n12_y = n12_y_p5_lanes[0] + (c13 * n13_x - s13 * n13_y);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p9_lanes = 0.0007556474228594393 * f13_x_p5714_lanes +
      0.0009386316083993107 * wd13_z_lanes + 0.000108260010923775 * (f13_z_p3_lanes - wd13_x_lanes);
  const Lanes<2> n13_z_p15_lanes = n13_z_p9_lanes -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      (f13_x_p5747_lanes + wd13_y_lanes) + detail::make_pack<Real>((-0.0001263900573325125),
      0.0001263900573325125) * (f13_x_p5562_lanes - f13_y_p3_lanes);
  const Lanes<2> n13_z_p16_lanes = n13_z_p15_lanes +
      (0.01626499875 * a13_y_lanes + detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      minus_a13_x_lanes);

  // link 24 (right_eye), inertial wrench
  const Real n13_z = n13_z_p16_lanes[0] + f13_x_p5797;
  tau[12] = n13_z;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_x_p6_lanes = 1.16e-05 * f12_z_p5_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (f12_y_p5_lanes - f12_x_p1_lanes) - 0.0006000000000000001 * minus_a12_z_lanes;

  // link 13 (left_hand), inward
  const Real n12_x = n12_x_p6_lanes[0] + n13_z;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p2_lanes = minus_a12_z_p1_lanes + wd11_x_lanes;
  const Lanes<2> n11_x_p4_lanes = minus_a12_y_p1_lanes - wd11_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p10_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (f11_x_p5_lanes - minus_a12_y_p7_lanes);
  const Lanes<2> n11_x_p11_lanes = 0.0001194 * n11_x_p2_lanes +
      detail::make_pack<Real>(6e-06, (-6e-06)) * n11_x_p4_lanes + 0.000144 * f11_y_p1_lanes +
      n11_x_p10_lanes;
  const Lanes<2> n11_x_p12_lanes = n11_x_p11_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_y_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_x = n11_x_p12_lanes[0] + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p9_lanes = 0.00020682766225734302 * wd12_z_lanes - 0.000183627662257343 *
      f12_y_p1_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (f12_z_p1_lanes - minus_wd12_y_lanes);
  const Lanes<2> n12_z_p10_lanes = n12_z_p9_lanes -
      (0.0025100003499999995 * minus_a12_y_lanes + 0.0006000000000000001 * a12_x_lanes);

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p10_lanes[0] + (s13 * n13_x + c13 * n13_y);
  tau[11] = n12_z;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p8_lanes = 0.000144 * (minus_a12_y_p6_lanes - f11_x_p5_lanes);
  const Lanes<2> n11_y_p9_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      f11_x_p3_lanes - 0.0001098 * n11_x_p4_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) *
      n11_x_p2_lanes - n11_y_p8_lanes;
  const Lanes<2> n11_y_p10_lanes = n11_y_p9_lanes - 6e-04 * minus_a10_y_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_y = n11_y_p10_lanes[0] + (n12_z + 0.269 * f11_x_p1);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p4_lanes = w10_x_lanes * minus_w10_y_lanes;
  const Lanes<2> n10_x_p5_lanes = wd10_z_lanes - n10_x_p4_lanes;
  const Lanes<2> n10_x_p8_lanes = w10_z_lanes * w10_z_lanes;
  const Lanes<2> n10_x_p9_lanes = minus_w10_y_lanes * minus_w10_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p11_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * (n10_x_p8_lanes - n10_x_p9_lanes);
  const Lanes<2> n10_x_p12_lanes = 0.06060754126741261 * f10_z_p5_lanes + 0.0001499998887063 *
      f10_z_p2_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      n10_x_p5_lanes + n10_x_p11_lanes;
  const Lanes<2> n10_x_p14_lanes = n10_x_p12_lanes - 0.28049749700000004 * minus_a10_z_lanes;

  // link 11 (left_wrist1), inward
  const Real n10_x = n10_x_p14_lanes[0] + (c11 * n11_x - s11 * n11_y);

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p3_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;
  const Lanes<2> n11_z_p9_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      minus_a12_y_p2_lanes;
  const Lanes<2> n11_z_p10_lanes = 0.0002292 * wd11_z_lanes - 9.600000000000003e-06 *
      f11_x_p2_lanes - 0.000144 * minus_a12_z_p2_lanes - n11_z_p9_lanes;
  const Lanes<2> n11_z_p14_lanes = n11_z_p10_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (minus_a12_y_p7_lanes - minus_a12_y_p6_lanes) - n11_z_p3_lanes;

  // link 12 (left_wrist2), inward
  const Real n11_z = n11_z_p14_lanes[0] - (s12 * n12_x + c12 * n12_y);
  tau[10] = n11_z;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p2_lanes = n10_x_p4_lanes + wd10_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p6_lanes = 0.00028099984685315 * f10_z_p2_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * n10_y_p2_lanes +
      0.0001499998887063 * f10_z_p5_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p7_lanes = w10_x_lanes * w10_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p12_lanes = detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * (n10_y_p7_lanes - n10_x_p8_lanes) - n10_y_p6_lanes +
      0.0014999985000000002 * minus_a10_z_lanes;

  // link 11 (left_wrist1), inward
  const Real n10_y = n10_y_p12_lanes[0] - n11_z;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p1_lanes = minus_a10_z_p1_lanes + wd9_x_lanes;
  const Lanes<2> n9_x_p3_lanes = a10_x_p1_lanes - wd9_y_lanes;
  const Lanes<2> n9_x_p6_lanes = w9_x_lanes * w9_y_lanes;
  const Lanes<2> n9_x_p7_lanes = n9_x_p6_lanes + wd9_z_lanes;
  const Lanes<2> n9_x_p10_lanes = w9_z_lanes * w9_z_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p12_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (n9_x_p10_lanes - a10_x_p7_lanes);
  const Lanes<2> n9_x_p13_lanes = 0.0019585440854647937 * n9_x_p1_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p3_lanes -
      0.0005895000784280001 * n9_x_p7_lanes + n9_x_p12_lanes;
  const Lanes<2> n9_x_p15_lanes = n9_x_p13_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_x_lanes;

  // link 10 (left_lowerarm), inward
  const Real n9_x = n9_x_p15_lanes[0] + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p9_lanes = 0.06032654142055946 * n10_x_p4_lanes + 0.060888541114265754 *
      wd10_z_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (f10_z_p4_lanes + wd10_x_lanes);
  const Lanes<2> n10_z_p15_lanes = n10_z_p9_lanes -
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (f10_z_p1_lanes - minus_wd10_y_lanes) + 0.0001499998887063 *
      (n10_x_p9_lanes - n10_y_p7_lanes);
  const Lanes<2> n10_z_p16_lanes = n10_z_p15_lanes -
      (0.0014999985000000002 * minus_a10_y_lanes + 0.28049749700000004 * a10_x_lanes);

  // link 11 (left_wrist1), inward
  const Real n10_z = n10_z_p16_lanes[0] + (s11 * n11_x + c11 * n11_y);
  tau[9] = n10_z;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_x_p4_lanes = 0.0014999985000000002 * (n10_x_p9_lanes + n10_x_p8_lanes) +
      0.28049749700000004 * n10_y_p2_lanes;

  // link 11 (left_wrist1), inward
  const Real f10_x = c11 * f11_x - s11 * f11_y - f10_x_p4_lanes[0];

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> f11_z_p3_lanes = 6e-04 * n11_x_p4_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * n11_x_p2_lanes;

  // link 12 (left_wrist2), inward
  const Real f11_z = f11_z_p3_lanes[0] - (s12 * f12_x + c12 * f12_y);

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_y_p4_lanes = 0.0014999985000000002 * n10_x_p5_lanes - 0.28049749700000004 *
      (n10_y_p7_lanes + n10_x_p8_lanes);

  // link 11 (left_wrist1), inward
  const Real f10_y = f10_y_p4_lanes[0] - f11_z;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p1 = s10 * f10_y - c10 * f10_x;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_y_p2_lanes = n9_x_p6_lanes - wd9_z_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p9_lanes = 0.0005895000784280001 * (a10_x_p6_lanes - n9_x_p10_lanes);
  const Lanes<2> n9_y_p10_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * n9_y_p2_lanes - 0.0008177492704690715 * n9_x_p3_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p1_lanes +
      n9_y_p9_lanes;
  const Lanes<2> n9_y_p12_lanes = n9_y_p10_lanes - 0.0022500062 * a8_x_lanes;

  // link 10 (left_lowerarm), inward
  const Real n9_y = n9_y_p12_lanes[0] + (n10_z + 0.282 * n9_y_p1);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p4_lanes = w8_x_lanes * w8_y_lanes;
  const Lanes<2> n8_z_p8_lanes = w8_y_lanes * w8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p11_lanes = 0.18101044219699997 * n8_z_p4_lanes + 0.18125194219699997 *
      wd8_z_lanes + 0.00010499999999999999 * (n8_z_p8_lanes - wd8_x_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p12_lanes = w8_x_lanes * w8_z_lanes;
  const Lanes<2> n8_z_p16_lanes = w8_y_lanes * w8_y_lanes;
  const Lanes<2> n8_z_p17_lanes = w8_x_lanes * w8_x_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p20_lanes = n8_z_p11_lanes - detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_z_p12_lanes + wd8_y_lanes) + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (n8_z_p16_lanes - n8_z_p17_lanes);
  const Lanes<2> n8_z_p21_lanes = n8_z_p20_lanes - (0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes);

  // link 9 (left_upperarm), inward
  const Real n8_z = n8_z_p21_lanes[0] + (c9 * n9_x - s9 * n9_y);
  tau[7] = n8_z;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p1_lanes = w7_y_lanes * w7_z_lanes;
  const Lanes<2> n7_x_p2_lanes = n7_x_p1_lanes + wd7_x_lanes;
  const Lanes<2> n7_x_p4_lanes = w7_x_lanes * w7_z_lanes;
  const Lanes<2> n7_x_p5_lanes = n7_x_p4_lanes - wd7_y_lanes;
  const Lanes<2> n7_x_p8_lanes = w7_x_lanes * w7_y_lanes;
  const Lanes<2> n7_x_p9_lanes = n7_x_p8_lanes + wd7_z_lanes;
  const Lanes<2> n7_x_p12_lanes = w7_y_lanes * w7_y_lanes;
  const Lanes<2> n7_x_p13_lanes = w7_z_lanes * w7_z_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p15_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p13_lanes - n7_x_p12_lanes);
  const Lanes<2> n7_x_p16_lanes = 0.0001505 * n7_x_p2_lanes + 8.75e-06 * n7_x_p5_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * n7_x_p9_lanes +
      n7_x_p15_lanes;
  const Lanes<2> n7_x_p17_lanes = 0.0017499999999999998 * minus_a7_z_lanes;
  const Lanes<2> n7_x_p18_lanes = n7_x_p16_lanes + n7_x_p17_lanes;

  // link 8 (left_shoulder2), inward
  const Real n7_x = n7_x_p18_lanes[0] + n8_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p1_lanes = n8_z_p4_lanes - wd8_z_lanes;
  const Lanes<2> n8_y_p3_lanes = n8_z_p12_lanes - wd8_y_lanes;
  const Lanes<2> n8_y_p6_lanes = n8_z_p8_lanes + wd8_x_lanes;
  const Lanes<2> n8_y_p9_lanes = w8_z_lanes * w8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p11_lanes = 0.00010499999999999999 * (n8_z_p17_lanes - n8_y_p9_lanes);
  const Lanes<2> n8_y_p12_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n8_y_p1_lanes -
      0.18113119219699997 * n8_y_p3_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * n8_y_p6_lanes + n8_y_p11_lanes;
  const Lanes<2> n8_y_p14_lanes = n8_y_p12_lanes - 0.7139200499999999 * a7_x_lanes;

  // link 9 (left_upperarm), inward
  const Real n8_y = n8_y_p14_lanes[0] + (s9 * n9_x + c9 * n9_y);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p3_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes;
  const Lanes<2> n9_z_p9_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * a10_x_p2_lanes;
  const Lanes<2> n9_z_p10_lanes = 0.0027762933559338653 * wd9_z_lanes - 0.001140794814995722 *
      n9_x_p6_lanes + 0.0005895000784280001 * minus_a10_z_p2_lanes - n9_z_p9_lanes;
  const Lanes<2> n9_z_p14_lanes = n9_z_p10_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) *
      (a10_x_p7_lanes - a10_x_p6_lanes) + n9_z_p3_lanes;

  // link 10 (left_lowerarm), inward
  const Real n9_z = n9_z_p14_lanes[0] - (s10 * n10_x + c10 * n10_y);
  tau[8] = n9_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_x_p4_lanes = n8_z_p4_lanes + wd8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p8_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_y_p9_lanes - n8_z_p16_lanes);
  const Lanes<2> n8_x_p9_lanes = 0.00012075 * n8_y_p6_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * n8_y_p3_lanes -
      0.00010499999999999999 * n8_x_p4_lanes + n8_x_p8_lanes;
  const Lanes<2> n8_x_p11_lanes = n8_x_p9_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes;

  // link 9 (left_upperarm), inward
  const Real n8_x = n8_x_p11_lanes[0] - n9_z;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p1_lanes = n7_x_p8_lanes - wd7_z_lanes;
  const Lanes<2> n7_y_p7_lanes = w7_x_lanes * w7_x_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p9_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_y_p7_lanes - n7_x_p13_lanes);
  const Lanes<2> n7_y_p10_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * n7_y_p1_lanes - 0.0002975 * n7_x_p5_lanes - 8.75e-06 *
      n7_x_p2_lanes + n7_y_p9_lanes;
  const Lanes<2> n7_y_p11_lanes = n7_y_p10_lanes + n7_x_p17_lanes;

  // link 8 (left_shoulder2), inward
  const Real n7_y = n7_y_p11_lanes[0] + (c8 * n8_x - s8 * n8_y);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_x_p4_lanes = 0.0022500062 * (a10_x_p7_lanes + n9_x_p10_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * n9_y_p2_lanes;

  // link 10 (left_lowerarm), inward
  const Real f9_x = f9_x_p4_lanes[0] - n9_y_p1;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f7_x_p3_lanes = 0.7139200499999999 * n8_y_p3_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * n8_y_p6_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_y_p4_lanes = 0.0022500062 * n9_x_p7_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      (a10_x_p6_lanes + n9_x_p10_lanes);

  // link 10 (left_lowerarm), inward
  const Real f9_y = f10_z - f9_y_p4_lanes[0];

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_p6_lanes = 0.0017499999999999998 *
      (n7_x_p12_lanes + n7_x_p13_lanes + n7_y_p1_lanes);
  const Real f7_x = f7_x_p3_lanes[0] + c9 * f9_x - s9 * f9_y - f7_x_p6_lanes[0];

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_y_p4_lanes = 0.7139200499999999 * n8_x_p4_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (n8_z_p17_lanes + n8_y_p9_lanes);

  // link 9 (left_upperarm), inward
  const Real f8_y = f8_y_p4_lanes[0] + (s9 * f9_x + c9 * f9_y);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> f9_z_p3_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      n9_x_p1_lanes - 0.0022500062 * n9_x_p3_lanes;

  // link 10 (left_lowerarm), inward
  const Real f9_z = f9_z_p3_lanes[0] - (s10 * f10_x + c10 * f10_y);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> f8_x_p4_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p1_lanes - 0.7139200499999999 *
      (n8_z_p16_lanes + n8_y_p9_lanes);

  // link 9 (left_upperarm), inward
  const Real f8_x = f8_x_p4_lanes[0] - f9_z;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_p3_lanes = 0.0017499999999999998 *
      (n7_x_p9_lanes + (n7_y_p7_lanes + n7_x_p13_lanes));
  const Real f7_y = c8 * f8_x - s8 * f8_y + f7_y_p3_lanes[0];

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = c7 * f7_x - s7 * f7_y;

  // link 24 (right_eye), inertial wrench
  const Real f20_x = f13_x_p5813_lanes[1] + f13_x_p5795;
  const Real f20_y = f13_y_p6_lanes[1] + f13_x_p5793;

  // link 20 (right_hand), inward
  const Real f19_y = f12_y_p8_lanes[1] + (c20 * f20_x - s20 * f20_y);

  // link 24 (right_eye), inertial wrench
  const Real f20_z = f13_z_p6_lanes[1] + f13_x_p5792;

  // link 20 (right_hand), inward
  const Real f19_x = f20_z - f12_x_p6_lanes[1];

  // link 19 (right_wrist2), inward
  const Real f18_x_p8 = s19 * f19_y - c19 * f19_x;
  const Real f18_x = f11_x_p8_lanes[1] - f18_x_p8;

  // link 20 (right_hand), inward
  const Real f19_z = f12_z_p7_lanes[1] + (s20 * f20_x + c20 * f20_y);

  // link 19 (right_wrist2), inward
  const Real f18_y = f11_y_p5_lanes[1] + f19_z;

  // link 18 (right_wrist1), inward
  const Real f17_z = f10_z_p7_lanes[1] + (s18 * f18_x + c18 * f18_y);

  // link 24 (right_eye), inertial wrench
  const Real n20_x = n13_x_p10_lanes[1] + f13_x_p5791;
  const Real n20_y = n13_y_p10_lanes[1] + f13_x_p5790;

  // link 20 (right_hand), inward
  const Real n19_y = n12_y_p5_lanes[1] + (c20 * n20_x - s20 * n20_y);

  // link 24 (right_eye), inertial wrench
  const Real n20_z = n13_z_p16_lanes[1] + f13_x_p5789;
  tau[19] = n20_z;

  // link 20 (right_hand), inward
  const Real n19_x = n12_x_p6_lanes[1] + n20_z;

  // link 19 (right_wrist2), inward
  const Real n18_x = n11_x_p12_lanes[1] + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));

  // link 20 (right_hand), inward
  const Real n19_z = n12_z_p10_lanes[1] + (s20 * n20_x + c20 * n20_y);
  tau[18] = n19_z;

  // link 19 (right_wrist2), inward
  const Real n18_y = n11_y_p10_lanes[1] + (n19_z + 0.269 * f18_x_p8);

  // link 18 (right_wrist1), inward
  const Real n17_x = n10_x_p14_lanes[1] + (c18 * n18_x - s18 * n18_y);

  // link 19 (right_wrist2), inward
  const Real n18_z = n11_z_p14_lanes[1] - (s19 * n19_x + c19 * n19_y);
  tau[17] = n18_z;

  // link 18 (right_wrist1), inward
  const Real n17_y = n10_y_p12_lanes[1] - n18_z;

  // link 17 (right_lowerarm), inward
  const Real n16_x = n9_x_p15_lanes[1] + (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));

  // link 18 (right_wrist1), inward
  const Real n17_z = n10_z_p16_lanes[1] + (s18 * n18_x + c18 * n18_y);
  tau[16] = n17_z;
  const Real f17_x = c18 * f18_x - s18 * f18_y - f10_x_p4_lanes[1];

  // link 19 (right_wrist2), inward
  const Real f18_z = f11_z_p3_lanes[1] - (s19 * f19_x + c19 * f19_y);

  // link 18 (right_wrist1), inward
  const Real f17_y = f10_y_p4_lanes[1] - f18_z;

  // link 17 (right_lowerarm), inward
  const Real n16_y_p12 = s17 * f17_y - c17 * f17_x;
  const Real n16_y = n9_y_p12_lanes[1] + (n17_z + 0.282 * n16_y_p12);

  // link 16 (right_upperarm), inward
  const Real n15_z = n8_z_p21_lanes[1] + (c16 * n16_x - s16 * n16_y);
  tau[14] = n15_z;

  // link 15 (right_shoulder2), inward
  const Real n14_x = n7_x_p18_lanes[1] + n15_z;

  // link 16 (right_upperarm), inward
  const Real n15_y = n8_y_p14_lanes[1] + (s16 * n16_x + c16 * n16_y);

  // link 17 (right_lowerarm), inward
  const Real n16_z = n9_z_p14_lanes[1] - (s17 * n17_x + c17 * n17_y);
  tau[15] = n16_z;

  // link 16 (right_upperarm), inward
  const Real n15_x = n8_x_p11_lanes[1] - n16_z;

  // link 15 (right_shoulder2), inward
  const Real n14_y = n7_y_p11_lanes[1] + (c15 * n15_x - s15 * n15_y);

  // link 17 (right_lowerarm), inward
  const Real f16_x = f9_x_p4_lanes[1] - n16_y_p12;
  const Real f16_y = f17_z - f9_y_p4_lanes[1];

  // link 15 (right_shoulder2), inward
  const Real f14_x = f7_x_p3_lanes[1] + c16 * f16_x - s16 * f16_y - f7_x_p6_lanes[1];

  // link 16 (right_upperarm), inward
  const Real f15_y = f8_y_p4_lanes[1] + (s16 * f16_x + c16 * f16_y);

  // link 17 (right_lowerarm), inward
  const Real f16_z = f9_z_p3_lanes[1] - (s17 * f17_x + c17 * f17_y);

  // link 16 (right_upperarm), inward
  const Real f15_x = f8_x_p4_lanes[1] - f16_z;

  // link 15 (right_shoulder2), inward
  const Real f14_y = c15 * f15_x - s15 * f15_y + f7_y_p3_lanes[1];

  // link 14 (right_shoulder1), inward
  const Real n6_x_p2 = c14 * f14_x - s14 * f14_y;

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Real wd21_x = s21 * wd6_y + c21 * wd6_z + w21_y * qd[20];
  const Real wd21_z = qdd_0[20] - wd6_x;
  const Real w21_x = s21 * w6_y + c21 * w6_z;
  const Real w21_z = qd[20] - w6_x;

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real wd22_x = c22 * wd21_x - s22 * wd21_z - minus_w22_y * qd[21];
  const Real w22_z = w21_y + qd[21];
  const Real n22_x_p1 = minus_w22_y * w22_z;
  const Real n22_x_p2 = wd22_x - n22_x_p1;
  const Real w22_x = c22 * w21_x - s22 * w21_z;
  const Real n22_x_p3 = w22_x * w22_z;
  const Real minus_wd22_y = s22 * wd21_x + c22 * wd21_z + w22_x * qd[21];
  const Real n22_x_p4 = n22_x_p3 + minus_wd22_y;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real a22_z_p1 = w21_y * w21_z;
  const Real a22_z_p2 = a22_z_p1 - wd21_x;

  // link 22 (head), outward
  const Real a22_z = 0.394 * a22_z_p2 - minus_a21_y;

  // link 21 (neck), outward
  const Real a22_y_p1 = w21_x * w21_x;
  const Real a22_y_p2 = w21_y * w21_y;

  // link 22 (head), outward
  const Real a22_y_p3 = a6_x + 0.394 * (a22_y_p1 + a22_y_p2);

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Real wd21_y = c21 * wd6_y - s21 * wd6_z - w21_x * qd[20];
  const Real a22_y_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_y_p5 = a21_x + 0.394 * (a22_y_p4 + wd21_y);
  const Real a22_y = c22 * a22_y_p3 - s22 * a22_y_p5;
  const Real wd22_z = wd21_y + qdd_0[21];
  const Real minus_a23_z_p1 = w22_x * minus_w22_y;
  const Real minus_a23_z_p2 = wd22_z - minus_a23_z_p1;

  // link 24 (right_eye), outward
  const Real minus_a23_z_p3 = a22_y + 0.095 * minus_a23_z_p2;

  // link 22 (head), outward
  const Real minus_a23_z_p4 = n22_x_p1 + wd22_x;

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_z_lanes = minus_a23_z_p3 - detail::make_pack<Real>(0.032, (-0.032)) *
      minus_a23_z_p4;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_p1_lanes = 0.00025 * minus_a23_z_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> w23_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;
  const Lanes<2> w23_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> n23_y_p3_lanes = w23_z_lanes * w23_z_lanes;
  const Lanes<2> n23_y_p11_lanes = (w23_z_lanes + detail::make_pack<Real>(qd[22], qd[23])) *
      w23_x_lanes - (detail::make_pack<Real>(c23, c24) * wd22_z -
      detail::make_pack<Real>(s23, s24) * wd22_x);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_lanes = 2.8750000000000004e-05 *
      (w23_x_lanes * w23_x_lanes - n23_y_p3_lanes) - 5.25e-06 * n23_y_p11_lanes + n23_y_p1_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> w23_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;
  const Lanes<2> wd23_x_lanes = detail::make_pack<Real>(c23, c24) * wd22_x +
      detail::make_pack<Real>(s23, s24) * wd22_z + w23_y_lanes *
      detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> n23_x_p1_lanes = w23_y_lanes * w23_z_lanes;
  const Lanes<2> n23_x_p4_lanes = w23_x_lanes * w23_y_lanes;
  const Lanes<2> wd23_z_lanes = minus_wd22_y + detail::make_pack<Real>(qdd_0[22], qdd_0[23]);
  const Lanes<2> n23_x_p5_lanes = n23_x_p4_lanes + wd23_z_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_x_lanes = 4e-06 * (n23_x_p1_lanes + wd23_x_lanes) - 2.8750000000000004e-05 *
      n23_x_p5_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_x_p13_lanes = detail::make_pack<Real>(c23, c24) * n23_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_y_lanes + detail::make_pack<Real>(8e-06, (-8e-06)) *
      n23_y_p11_lanes;
  const Real n22_x = 0.05450270000000001 * n22_x_p2 - 0.0074 * n22_x_p4 - 0.43200000000000005 *
      a22_z + n22_x_p13_lanes[1] + n22_x_p13_lanes[0];

  // link 22 (head), outward
  const Real a22_x = c22 * a22_y_p5 + s22 * a22_y_p3;
  const Real a23_y_p1 = minus_w22_y * minus_w22_y;
  const Real a23_y_p2 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Real a23_y_p3 = a23_y_p1 + a23_y_p2;

  // link 24 (right_eye), outward
  const Real a23_y_p4 = a22_x - 0.095 * a23_y_p3;

  // link 22 (head), outward
  const Real a23_y_p5 = n22_x_p3 - minus_wd22_y;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_p8_lanes = detail::make_pack<Real>(s23, s24) *
      (a23_y_p4 + detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p5);

  // link 24 (right_eye), outward
  const Real a23_y_p9 = a22_z + 0.095 * n22_x_p4;

  // link 22 (head), outward
  const Real a23_y_p10 = w22_x * w22_x;

  // link 23 (left_eye), outward
  const Real a23_y_p11 = a23_y_p10 + a23_y_p1;
  const Lanes<2> a23_y_lanes = detail::make_pack<Real>(c23, c24) *
      (a23_y_p9 - detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p11) - a23_y_p8_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_p7_lanes = 1.2499999999999999e-06 * n23_x_p4_lanes + 9.25e-06 *
      wd23_z_lanes + 2.8750000000000004e-05 * (n23_x_p1_lanes - wd23_x_lanes);
  const Lanes<2> n23_z_lanes = n23_z_p7_lanes + 0.00025 * a23_y_lanes;
  tau[22] = n23_z_lanes[0];

  // link 24 (right_eye), inertial wrench
  tau[23] = n23_z_lanes[1];

  // link 23 (left_eye), inertial wrench
  const Lanes<2> minus_f23_x_lanes = 0.00025 * (w23_y_lanes * w23_y_lanes + n23_y_p3_lanes);
  const Lanes<2> f23_y_lanes = 0.00025 * n23_x_p5_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p5_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_y_lanes;
  const Real n22_y_p7 = 0.0074 * n22_x_p2 - 0.009438624999999999 * n22_x_p4 - 0.072575 * a22_z -
      n23_z_lanes[1] - (-0.032) * n22_y_p5_lanes[1];
  const Lanes<2> n22_y_p12_lanes = detail::make_pack<Real>(c23, c24) * f23_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_x_lanes;
  const Real n22_y_p14 = n22_y_p12_lanes[1] + n22_y_p12_lanes[0];
  const Real n22_y = n22_y_p7 - n23_z_lanes[0] - 0.032 * n22_y_p5_lanes[0] - 0.095 * n22_y_p14;

  // link 21 (neck), outward
  const Real n21_z_p1 = w21_x * w21_y;

  // link 22 (head), inward
  const Real n21_z = 0.00621675 * wd21_z - 0.0048105000000000005 * n21_z_p1 + 0.0016155 * a22_z_p2 -
      0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;

  // link 14 (right_shoulder1), inward
  const Real n6_x_p3 = 0.40041499999999997 * a7_x_p12 + 0.0187369177636143 * minus_a7_z_p1 - n21_z +
      (s14 * n14_x + c14 * n14_y + (-0.18) * n6_x_p2);

  // link 7 (left_shoulder1), inward
  const Real n6_x = n6_x_p3 + (s7 * n7_x + c7 * n7_y + 0.18 * n6_x_p1);

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p6_lanes = 0.00014700000000000002 * n7_x_p8_lanes + 0.00044800000000000005 *
      wd7_z_lanes + detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) *
      (n7_x_p1_lanes - wd7_x_lanes);
  const Lanes<2> n7_z_p12_lanes = n7_z_p6_lanes - detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p4_lanes + wd7_y_lanes) + 8.75e-06 *
      (n7_x_p12_lanes - n7_y_p7_lanes);

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p14_lanes = 0.0017499999999999998 * (a7_y_lanes + a7_x_lanes);
  const Real n7_z = n7_z_p12_lanes[0] + s8 * n8_x + c8 * n8_y + n7_z_p14_lanes[0];
  tau[6] = n7_z;

  // link 15 (right_shoulder2), inward
  const Real n14_z = n7_z_p12_lanes[1] + s15 * n15_x + c15 * n15_y + n7_z_p14_lanes[1];
  tau[13] = n14_z;

  // link 23 (left_eye), inward
  const Real f22_z = 0.072575 * n22_x_p4 - 0.43200000000000005 * n22_x_p2 + n22_y_p14;

  // link 21 (neck), outward
  const Real n21_x_p1 = n21_z_p1 + wd21_z;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * (a22_z_p1 + wd21_x) - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_x_p9 - 0.0187369177636143 *
      (minus_a7_z_p3 - a7_x_p1) + s21 * n21_x;

  // link 23 (left_eye), inward
  const Real n22_z_p1 = 0.04506407500000001 * minus_a23_z_p1 + 0.06394132500000001 * wd22_z -
      0.0074 * (a23_y_p1 - a23_y_p10) + 0.072575 * a22_y;
  const Lanes<2> n22_z_p2_lanes = detail::make_pack<Real>(s23, s24) * n23_x_lanes;
  const Lanes<2> n22_z_p4_lanes = detail::make_pack<Real>(c23, c24) * n23_y_lanes;
  const Real n22_z_p6 = n23_y_p11_lanes[1] + n23_y_p11_lanes[0];
  const Real n22_z = n22_z_p1 + 0.43200000000000005 * a22_x + n22_z_p2_lanes[1] +
      n22_z_p4_lanes[1] + n22_z_p2_lanes[0] + n22_z_p4_lanes[0] - 2.375e-05 * n22_z_p6;
  tau[21] = n22_z;
  const Real f22_y = 0.072575 * minus_a23_z_p2 + 0.43200000000000005 * (a23_y_p10 + a23_y_p2) -
      0.00025 * n22_z_p6;
  const Real f22_x = 0.43200000000000005 * (minus_a23_z_p1 + wd22_z) - 0.072575 * a23_y_p3 -
      n22_y_p5_lanes[1] - n22_y_p5_lanes[0];

  // link 22 (head), inward
  const Real n21_y_p1 = s22 * f22_y - c22 * f22_x;

  // link 21 (neck), outward
  const Real n21_y_p2 = w21_z * w21_z;
  const Real n21_y_p3 = a22_y_p4 - wd21_y;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a22_y_p1 - n21_y_p2) - 0.000703125 * n21_y_p3 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p1);

  // link 7 (left_shoulder1), inward
  const Real n6_y_p2 = n6_x_p2 + n6_x_p1;
  const Real n6_y = n6_y_p1 + c21 * n21_y + n14_z + n7_z + 0.226 * n6_y_p2;

  // link 5 (chest2), outward
  const Real n5_y_p1 = w5_x * w5_z + minus_wd5_y;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p5 - 0.04675382692737882 * n5_y_p1 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 6 (chest3), inertial wrench
  const Real n6_z_p1 = 1.26882463592404 * a7_x_p4 + 2.06965463592404 * wd6_z - 0.0187369177636143 *
      (a7_x_p11 - wd6_x) + 6.1665928899999995 * minus_a6_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p2 = n6_z_p1 + c21 * n21_x - s21 * n21_y + c14 * n14_x - s14 * n14_y;

  // link 14 (right_shoulder1), inward
  const Real n6_z_p3 = s14 * f14_x + c14 * f14_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p4 = s7 * f7_x + c7 * f7_y;
  const Real n6_z_p5 = n6_z_p2 - (-0.18) * n6_z_p3 + c7 * n7_x - s7 * n7_y - 0.18 * n6_z_p4;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_z_p2_lanes = 0.0017499999999999998 * (n7_x_p5_lanes - n7_x_p2_lanes);
  const Real f7_z = s8 * f8_x + c8 * f8_y + f7_z_p2_lanes[0];

  // link 15 (right_shoulder2), inward
  const Real f14_z = s15 * f15_x + c15 * f15_y + f7_z_p2_lanes[1];

  // link 7 (left_shoulder1), inward
  const Real n6_z_p6 = f14_z + f7_z;
  const Real n6_z = n6_z_p5 - 0.226 * n6_z_p6;
  tau[5] = n6_z;

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p3 - (s22 * f22_x + c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a7_x_p2 - f21_z + n6_z_p3 + n6_z_p4;

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (a22_y_p2 + n21_y_p2) + n21_y_p1;
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 7 (left_shoulder1), inward
  const Real f6_y = n6_z_p6 - 6.1665928899999995 * minus_a7_z_p1 - s21 * minus_f21_x + c21 * f21_y;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real n5_x = 0.15637308509675518 * a6_x_p5 - 0.005678398088837119 * n5_y_p1 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);
  const Real f5_z = 0.069699984375 * n5_y_p1 - 2.2194301519999997 * a6_x_p5 + n5_x_p1;

  // link 4 (chest1), outward
  const Real n4_x_p1 = w4_x * w4_y;
  const Real n4_x_p2 = n4_x_p1 + qdd_0[3];

  // link 5 (chest2), inward
  const Real n4_x = 0.0478915 * (wd4_x_p1 + wd4_x) + 0.005880002159562879 * n4_x_p2 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p2 - 6.1665928899999995 * a7_x_p9 - c21 * minus_f21_x - s21 * f21_y;

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p2 = 0.10961925816937637 * a6_z_p1 + 0.203126912024134 * wd5_z -
      0.005678398088837119 * (n5_z_p1 - a6_x_p1) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);
  tau[4] = n5_z;
  const Real f5_y = 0.069699984375 * (wd5_z - a6_z_p1) + 2.2194301519999997 * a6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_x = 2.2194301519999997 * a6_z_p2 - 0.069699984375 * (n5_z_p1 + a6_x_p2) + f6_z;

  // link 5 (chest2), inward
  const Real n4_y_p1 = s5 * f5_y - c5 * f5_x;

  // link 4 (chest1), outward
  const Real n4_y_p2 = wd4_y_p1 - wd4_y;
  const Real n4_y_p3 = qd[3] * qd[3];

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * n4_y_p1 -
      (0.01227760324629517 * n4_y_p2 + 0.005880002159562879 * (a5_y_p1 - n4_y_p3) + 0.0300000063 *
      a3_y);

  // link 4 (chest1), inward
  const Real n3_z = 1.7824817919087104 * wd3_z + (8.419374554 * a3_x - 0.02999999505 * a3_y) +
      (s4 * n4_x + c4 * n4_y);
  tau[2] = n3_z;

  // link 5 (chest2), inward
  const Real f4_x = 0.0300000063 * (a5_y_p2 + n4_y_p3) - n4_y_p1;
  const Real f4_y = f5_z - 0.0300000063 * n4_x_p2;

  // link 3 (hip), outward
  const Real f3_x_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_x_p1 + 8.419374554 * wd3_z + (c4 * f4_x - s4 * f4_y);

  // link 5 (chest2), inward
  const Real minus_f4_z = 0.0300000063 * n4_y_p2 + (s5 * f5_x + c5 * f5_y);

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_x_p1 - 0.02999999505 * wd3_z + minus_f4_z;

  // link 3 (hip), inward
  const Real n2_z_p1 = c3 * f3_x - s3 * f3_y;
  const Real n2_z = 9.885744550888212 * wd2_z + (0.031999971599999996 * a2_y + 24.5839218 * a2_x) +
      (n3_z + 0.422 * n2_z_p1);
  tau[1] = n2_z;
  const Real f2_x = 24.5839218 * wd2_z - 0.031999971599999996 * a3_y_p1 + n2_z_p1;
  const Real f2_y = 0.031999971599999996 * wd2_z + 24.5839218 * a3_y_p1 + (s3 * f3_x + c3 * f3_y);

  // link 2 (thigh), inward
  const Real n1_z = 13.049859506913753 * qdd_0[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + 0.434 * (c2 * f2_x - s2 * f2_y));
  tau[0] = n1_z;

  // link 5 (chest2), inward
  const Real n4_z = 0.060169103246295166 * qdd_0[3] - 0.03561389675370483 * n4_x_p1 +
      0.005880002159562879 * minus_a5_z_p1 + 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
