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

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1095_lanes = 0.11533812622014242 * detail::make_pack<Real>(c13, c20) +
      detail::make_pack<Real>(0.04672761636452121, (-0.04672761636452121)) *
      detail::make_pack<Real>(s13, s20) - inverse_D11_p1_lanes * f13_x_p1085_lanes;
  const Lanes<2> f13_x_p1097_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1095_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1099 = -f13_x_p1097_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Real neg_s20 = -s20;

  // link 12 (left_wrist2), force propagation
  const Real neg_s13 = -s13;
  const Lanes<2> f13_x_p1102_lanes = detail::make_pack<Real>(neg_s13, neg_s20) -
      inverse_D11_p1_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p1104_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1102_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1106 = -f13_x_p1104_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1109_lanes = detail::make_pack<Real>(c13, c20) - inverse_D11_p1_lanes *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p1111_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1109_lanes;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1113 = -f13_x_p1111_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1125_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(s13, s20) - 17.32841575379867 *
      detail::make_pack<Real>(c13, c20) - f13_x_p61_lanes * f13_x_p1085_lanes;
  const Lanes<2> f13_x_p1131_lanes = 0.269 * f13_x_p1125_lanes - detail::make_pack<Real>(s12, s19) *
      f13_x_p1095_lanes;
  const Lanes<2> f13_x_p1135_lanes = f13_x_p61_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p1139_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1102_lanes + 0.269 *
      f13_x_p1135_lanes;
  const Lanes<2> f13_x_p1143_lanes = f13_x_p61_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p1147_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1109_lanes + 0.269 *
      f13_x_p1143_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1149_lanes = detail::make_pack<Real>(-f13_x_p1147_lanes[1],
      -f13_x_p1147_lanes[1], -f13_x_p1139_lanes[1], f13_x_p1131_lanes[1], -f13_x_p1147_lanes[1],
      -f13_x_p1147_lanes[1], -f13_x_p1147_lanes[1], -f13_x_p1147_lanes[1]) -
      inverse_D10_p1_lanes[1] * detail::make_pack<Real>(f13_x_p1113, f13_x_p1113, f13_x_p1106,
      f13_x_p1099, f13_x_p1113, f13_x_p1113, f13_x_p1113, f13_x_p1113);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1158_lanes = f13_x_p35_lanes * f13_x_p1085_lanes;
  const Lanes<2> f13_x_p1170_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_pack<Real>(c13, c20) + 17.32841575379867 *
      detail::make_pack<Real>(s13, s20) - f13_x_p11_lanes * f13_x_p1085_lanes;
  const Lanes<2> f13_x_p1174_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1158_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p1170_lanes;
  const Lanes<2> f13_x_p1176_lanes = f13_x_p35_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p1180_lanes = f13_x_p11_lanes * detail::make_pack<Real>(c13, c20);
  const Lanes<2> f13_x_p1184_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1176_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p1180_lanes;
  const Lanes<2> f13_x_p1186_lanes = f13_x_p35_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p1190_lanes = f13_x_p11_lanes * detail::make_pack<Real>(s13, s20);
  const Lanes<2> f13_x_p1194_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1186_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p1190_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1199_lanes = 0.269 * detail::make_pack<Real>(f13_x_p1194_lanes[1],
      f13_x_p1194_lanes[1], f13_x_p1184_lanes[1], f13_x_p1174_lanes[1], f13_x_p1194_lanes[1],
      f13_x_p1194_lanes[1], f13_x_p1194_lanes[1], f13_x_p1194_lanes[1]) - inverse_D10_p8_lanes[1] *
      detail::make_pack<Real>(f13_x_p1113, f13_x_p1113, f13_x_p1106, f13_x_p1099, f13_x_p1113,
      f13_x_p1113, f13_x_p1113, f13_x_p1113);
  const Lanes<8> f13_x_p1205_lanes = s18 * f13_x_p1149_lanes + c18 * f13_x_p1199_lanes;
  const Real f13_x_p1208 = -(0.269 * c19);
  const Real f13_x_p1209 = c18 * f13_x_p1208;
  const Lanes<8> f13_x_p1220_lanes = c18 * f13_x_p1149_lanes - s18 * f13_x_p1199_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1223_lanes = detail::make_pack<Real>(-(s18 * f13_x_p1208),
      f13_x_p1220_lanes[1], f13_x_p1220_lanes[2], f13_x_p1220_lanes[3], -(s18 * f13_x_p1208),
      -(s18 * f13_x_p1208), -(s18 * f13_x_p1208), -(s18 * f13_x_p1208)) - f13_x_p231_lanes[1] *
      detail::make_pack<Real>(f13_x_p1209, f13_x_p1205_lanes[1], f13_x_p1205_lanes[2],
      f13_x_p1205_lanes[3], f13_x_p1209, f13_x_p1209, f13_x_p1209, f13_x_p1209);
  const Lanes<8> f13_x_p1231_lanes = f13_x_p221_lanes[1] *
      detail::make_pack<Real>(f13_x_p1209, f13_x_p1205_lanes[1], f13_x_p1205_lanes[2],
      f13_x_p1205_lanes[3], f13_x_p1209, f13_x_p1209, f13_x_p1209, f13_x_p1209);
  const Lanes<8> f13_x_p1239_lanes = c17 * f13_x_p1231_lanes - s17 * f13_x_p1223_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1243_lanes = f13_x_p259_lanes[1] * f13_x_p1239_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1266_lanes = detail::make_pack<Real>(-f13_x_p1194_lanes[1],
      -f13_x_p1194_lanes[1], -f13_x_p1184_lanes[1], -f13_x_p1174_lanes[1], -f13_x_p1194_lanes[1],
      -f13_x_p1194_lanes[1], -f13_x_p1194_lanes[1], -f13_x_p1194_lanes[1]) + f13_x_p55_lanes[1] *
      detail::make_pack<Real>(f13_x_p1113, f13_x_p1113, f13_x_p1106, f13_x_p1099, f13_x_p1113,
      f13_x_p1113, f13_x_p1113, f13_x_p1113);
  const Lanes<8> f13_x_p1275_lanes = detail::make_pack<Real>(-f13_x_p1143_lanes[1],
      -f13_x_p1143_lanes[1], -f13_x_p1135_lanes[1], f13_x_p1125_lanes[1], -f13_x_p1143_lanes[1],
      -f13_x_p1143_lanes[1], -f13_x_p1143_lanes[1], -f13_x_p1143_lanes[1]) - f13_x_p119_lanes[1] *
      detail::make_pack<Real>(f13_x_p1113, f13_x_p1113, f13_x_p1106, f13_x_p1099, f13_x_p1113,
      f13_x_p1113, f13_x_p1113, f13_x_p1113);
  const Lanes<8> f13_x_p1281_lanes = s18 * f13_x_p1266_lanes + c18 * f13_x_p1275_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1284_lanes = detail::make_pack<Real>(s11, s18) *
      detail::make_pack<Real>(c12, c19);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1286_lanes = detail::make_pack<Real>(f13_x_p1284_lanes[1],
      f13_x_p1281_lanes[1], f13_x_p1281_lanes[2], f13_x_p1281_lanes[3], f13_x_p1284_lanes[1],
      f13_x_p1284_lanes[1], f13_x_p1284_lanes[1], f13_x_p1284_lanes[1]) - f13_x_p191_lanes[1] *
      detail::make_pack<Real>(f13_x_p1209, f13_x_p1205_lanes[1], f13_x_p1205_lanes[2],
      f13_x_p1205_lanes[3], f13_x_p1209, f13_x_p1209, f13_x_p1209, f13_x_p1209);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1298_lanes = c17 * f13_x_p1223_lanes + s17 * f13_x_p1231_lanes + 0.282 *
      f13_x_p1286_lanes - f13_x_p1243_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p1320_lanes = c18 * f13_x_p1266_lanes - s18 * f13_x_p1275_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p1323_lanes = detail::make_pack<Real>(c11, c18) *
      detail::make_pack<Real>(c12, c19);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1325_lanes = detail::make_pack<Real>(f13_x_p1323_lanes[1],
      f13_x_p1320_lanes[1], f13_x_p1320_lanes[2], f13_x_p1320_lanes[3], f13_x_p1323_lanes[1],
      f13_x_p1323_lanes[1], f13_x_p1323_lanes[1], f13_x_p1323_lanes[1]) - f13_x_p317_lanes[1] *
      detail::make_pack<Real>(f13_x_p1209, f13_x_p1205_lanes[1], f13_x_p1205_lanes[2],
      f13_x_p1205_lanes[3], f13_x_p1209, f13_x_p1209, f13_x_p1209, f13_x_p1209);

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1337 = -f13_x_p1097_lanes[0];
  const Lanes<2> f13_x_p1346_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1158_lanes -
      detail::make_pack<Real>(c12, c19) * f13_x_p1170_lanes - f13_x_p337_lanes *
      detail::make_pack<Real>(f13_x_p1337, f13_x_p1099);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> f13_x_p1348_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1176_lanes;
  const Lanes<2> f13_x_p1350_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1180_lanes;
  const Lanes<2> f13_x_p1352_lanes = detail::make_pack<Real>(s12, s19) * f13_x_p1186_lanes;
  const Lanes<2> f13_x_p1354_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p1190_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p1356_lanes = detail::make_pack<Real>(-(-s19),
      -(f13_x_p1352_lanes[1] + f13_x_p1354_lanes[1] - f13_x_p337_lanes[1] * f13_x_p1113),
      -(f13_x_p1348_lanes[1] + f13_x_p1350_lanes[1] - f13_x_p337_lanes[1] * f13_x_p1106),
      -f13_x_p1346_lanes[1], -(-s19), -(-s19), -(-s19), -(-s19)) - f13_x_p363_lanes[1] *
      detail::make_pack<Real>(f13_x_p1209, f13_x_p1205_lanes[1], f13_x_p1205_lanes[2],
      f13_x_p1205_lanes[3], f13_x_p1209, f13_x_p1209, f13_x_p1209, f13_x_p1209);
  const Lanes<8> f13_x_p1364_lanes = s17 * f13_x_p1356_lanes - c17 * f13_x_p1325_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1372_lanes = 0.282 * f13_x_p1364_lanes - f13_x_p401_lanes[1] *
      f13_x_p1239_lanes;
  const Lanes<8> f13_x_p1380_lanes = c16 * f13_x_p1298_lanes - s16 * f13_x_p1372_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1400_lanes = s16 * f13_x_p1298_lanes + c16 * f13_x_p1372_lanes -
      inverse_D7_p1_lanes[1] * f13_x_p1380_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> f13_x_p1408_lanes = 0.00010499999999999999 / inverse_D8_p3_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1410_lanes = f13_x_p1408_lanes[1] * f13_x_p1380_lanes;
  const Lanes<8> f13_x_p1418_lanes = s15 * f13_x_p1410_lanes + c15 * f13_x_p1400_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1422_lanes = f13_x_p679_lanes[1] * f13_x_p1418_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p1434_lanes = detail::make_pack<Real>(-f13_x_p1364_lanes[0],
      -f13_x_p1364_lanes[1], -f13_x_p1364_lanes[2], -f13_x_p1364_lanes[3], -f13_x_p1364_lanes[0],
      -f13_x_p1364_lanes[0], -f13_x_p1364_lanes[0], -f13_x_p1364_lanes[0]) + f13_x_p569_lanes[1] *
      f13_x_p1239_lanes;
  const Lanes<8> f13_x_p1446_lanes = f13_x_p1286_lanes - f13_x_p577_lanes[1] * f13_x_p1239_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1462_lanes = c16 * f13_x_p1434_lanes - s16 * f13_x_p1446_lanes -
      f13_x_p657_lanes[1] * f13_x_p1380_lanes - f13_x_p1422_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1490_lanes = s16 * f13_x_p1434_lanes + c16 * f13_x_p1446_lanes -
      f13_x_p609_lanes[1] * f13_x_p1380_lanes;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1502 = f13_x_p1131_lanes[0] - inverse_D10_p1_lanes[0] * f13_x_p1337;
  const Real f13_x_p1503 = -f13_x_p1104_lanes[0];
  const Real f13_x_p1504 = -f13_x_p1139_lanes[0] - inverse_D10_p1_lanes[0] * f13_x_p1503;
  const Real f13_x_p1505 = -f13_x_p1111_lanes[0];
  const Real f13_x_p1506 = -f13_x_p1147_lanes[0] - inverse_D10_p1_lanes[0] * f13_x_p1505;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1507 = 0.269 * c13;
  const Real f13_x_p1508 = 0.269 * s13;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1514 = 0.269 * f13_x_p1174_lanes[0] - inverse_D10_p8_lanes[0] * f13_x_p1337;
  const Real f13_x_p1515 = 0.269 * f13_x_p1184_lanes[0] - inverse_D10_p8_lanes[0] * f13_x_p1503;
  const Real f13_x_p1516 = 0.269 * f13_x_p1194_lanes[0] - inverse_D10_p8_lanes[0] * f13_x_p1505;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1517 = s12 * neg_s13;
  const Real f13_x_p1518 = 0.269 * f13_x_p1517;
  const Real f13_x_p1519 = s12 * c13;
  const Real f13_x_p1520 = 0.269 * f13_x_p1519;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1526_lanes = s11 * detail::make_pack<Real>(f13_x_p1508, f13_x_p1507,
      f13_x_p1508, f13_x_p1506, f13_x_p1504, f13_x_p1502, f13_x_p1508, f13_x_p1508) + c11 *
      detail::make_pack<Real>(f13_x_p1520, f13_x_p1518, f13_x_p1520, f13_x_p1516, f13_x_p1515,
      f13_x_p1514, f13_x_p1520, f13_x_p1520);
  const Real f13_x_p1531 = -(0.269 * c12);
  const Real f13_x_p1532 = c11 * f13_x_p1531;
  const Real f13_x_p1539 = -f13_x_p1174_lanes[0] + f13_x_p55_lanes[0] * f13_x_p1337;
  const Real f13_x_p1540 = -f13_x_p1184_lanes[0] + f13_x_p55_lanes[0] * f13_x_p1503;
  const Real f13_x_p1541 = -f13_x_p1194_lanes[0] + f13_x_p55_lanes[0] * f13_x_p1505;
  const Real f13_x_p1542 = -f13_x_p1517;
  const Real f13_x_p1543 = -f13_x_p1519;
  const Real f13_x_p1549 = f13_x_p1125_lanes[0] - f13_x_p119_lanes[0] * f13_x_p1337;
  const Real f13_x_p1550 = -f13_x_p1135_lanes[0] - f13_x_p119_lanes[0] * f13_x_p1503;
  const Real f13_x_p1551 = -f13_x_p1143_lanes[0] - f13_x_p119_lanes[0] * f13_x_p1505;
  const Lanes<8> f13_x_p1557_lanes = c11 * detail::make_pack<Real>(f13_x_p1543, f13_x_p1542,
      f13_x_p1543, f13_x_p1541, f13_x_p1540, f13_x_p1539, f13_x_p1543, f13_x_p1543) - s11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p1551, f13_x_p1550, f13_x_p1549, s13, s13);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1562_lanes = detail::make_pack<Real>(f13_x_p1557_lanes[0],
      f13_x_p1557_lanes[1], f13_x_p1323_lanes[0], f13_x_p1557_lanes[3], f13_x_p1557_lanes[4],
      f13_x_p1557_lanes[5], f13_x_p1557_lanes[0], f13_x_p1557_lanes[0]) - f13_x_p317_lanes[0] *
      detail::make_pack<Real>(f13_x_p1526_lanes[0], f13_x_p1526_lanes[1], f13_x_p1532,
      f13_x_p1526_lanes[3], f13_x_p1526_lanes[4], f13_x_p1526_lanes[5], f13_x_p1526_lanes[0],
      f13_x_p1526_lanes[0]);
  const Lanes<8> f13_x_p1576_lanes = detail::make_pack<Real>(-(-(c12 * c13)), -(-(c12 * neg_s13)),
      -(-s12), -(f13_x_p1352_lanes[0] + f13_x_p1354_lanes[0] - f13_x_p337_lanes[0] * f13_x_p1505),
      -(f13_x_p1348_lanes[0] + f13_x_p1350_lanes[0] - f13_x_p337_lanes[0] * f13_x_p1503),
      -f13_x_p1346_lanes[0], -(-(c12 * c13)), -(-(c12 * c13))) - f13_x_p363_lanes[0] *
      detail::make_pack<Real>(f13_x_p1526_lanes[0], f13_x_p1526_lanes[1], f13_x_p1532,
      f13_x_p1526_lanes[3], f13_x_p1526_lanes[4], f13_x_p1526_lanes[5], f13_x_p1526_lanes[0],
      f13_x_p1526_lanes[0]);
  const Lanes<2> f13_x_p1584_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(f13_x_p1562_lanes[5], f13_x_p1325_lanes[3]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(f13_x_p1576_lanes[5],
      f13_x_p1356_lanes[3]);
  const Lanes<2> f13_x_p1590_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(f13_x_p1562_lanes[4], f13_x_p1325_lanes[2]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(f13_x_p1576_lanes[4],
      f13_x_p1356_lanes[2]);
  const Lanes<2> f13_x_p1596_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(f13_x_p1562_lanes[3], f13_x_p1325_lanes[1]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(f13_x_p1576_lanes[3],
      f13_x_p1356_lanes[1]);
  const Lanes<2> f13_x_p1602_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(f13_x_p1562_lanes[2], f13_x_p1325_lanes[0]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(f13_x_p1576_lanes[2],
      f13_x_p1356_lanes[0]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p1604_lanes = detail::make_pack<Real>(-(-f13_x_p1602_lanes[1] +
      f13_x_p515_lanes[1] * f13_x_p1239_lanes[0]), -(-f13_x_p1596_lanes[1] + f13_x_p515_lanes[1] *
      f13_x_p1239_lanes[1]), -(-f13_x_p1590_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1239_lanes[2]),
      -(-f13_x_p1584_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1239_lanes[3]),
      -(-f13_x_p1602_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1239_lanes[0]),
      -(-f13_x_p1602_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1239_lanes[0]),
      -(-f13_x_p1602_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1239_lanes[0]),
      -(-f13_x_p1602_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1239_lanes[0])) + f13_x_p555_lanes[1] *
      f13_x_p1380_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p1616_lanes = c15 * f13_x_p1604_lanes - s15 * f13_x_p1490_lanes -
      f13_x_p639_lanes[1] * f13_x_p1418_lanes;
  const Lanes<8> f13_x_p1624_lanes = s14 * f13_x_p1462_lanes + c14 * f13_x_p1616_lanes;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p1628 = 0.269 * c20;
  const Real f13_x_p1629 = s19 * neg_s20;
  const Real f13_x_p1630 = 0.269 * f13_x_p1629;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1631 = s18 * f13_x_p1628 + c18 * f13_x_p1630;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1632 = c18 * f13_x_p1628 - s18 * f13_x_p1630 - f13_x_p231_lanes[1] *
      f13_x_p1631;
  const Real f13_x_p1633 = f13_x_p221_lanes[1] * f13_x_p1631;
  const Real f13_x_p1634 = c17 * f13_x_p1633 - s17 * f13_x_p1632;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1635 = -f13_x_p1629;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1636 = s18 * f13_x_p1635 + c18 * c20 - f13_x_p191_lanes[1] * f13_x_p1631;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1637 = c17 * f13_x_p1632 + s17 * f13_x_p1633 + 0.282 * f13_x_p1636 -
      f13_x_p259_lanes[1] * f13_x_p1634;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1638 = c18 * f13_x_p1635 - s18 * c20 - f13_x_p317_lanes[1] * f13_x_p1631;
  const Real f13_x_p1639 = -(-(c19 * neg_s20)) - f13_x_p363_lanes[1] * f13_x_p1631;
  const Real f13_x_p1640 = s17 * f13_x_p1639 - c17 * f13_x_p1638;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1641 = 0.282 * f13_x_p1640 - f13_x_p401_lanes[1] * f13_x_p1634;
  const Real f13_x_p1642 = c16 * f13_x_p1637 - s16 * f13_x_p1641;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1643 = s16 * f13_x_p1637 + c16 * f13_x_p1641 - inverse_D7_p1_lanes[1] *
      f13_x_p1642;
  const Real f13_x_p1644 = f13_x_p1408_lanes[1] * f13_x_p1642;
  const Real f13_x_p1645 = s15 * f13_x_p1644 + c15 * f13_x_p1643;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p1646 = 0.269 * s20;
  const Real f13_x_p1647 = s19 * c20;
  const Real f13_x_p1648 = 0.269 * f13_x_p1647;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1649 = s18 * f13_x_p1646 + c18 * f13_x_p1648;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1650 = c18 * f13_x_p1646 - s18 * f13_x_p1648 - f13_x_p231_lanes[1] *
      f13_x_p1649;
  const Real f13_x_p1651 = f13_x_p221_lanes[1] * f13_x_p1649;
  const Real f13_x_p1652 = c17 * f13_x_p1651 - s17 * f13_x_p1650;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1653 = -f13_x_p1647;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1654 = s18 * f13_x_p1653 + c18 * s20 - f13_x_p191_lanes[1] * f13_x_p1649;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1655 = c17 * f13_x_p1650 + s17 * f13_x_p1651 + 0.282 * f13_x_p1654 -
      f13_x_p259_lanes[1] * f13_x_p1652;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1656 = c18 * f13_x_p1653 - s18 * s20 - f13_x_p317_lanes[1] * f13_x_p1649;
  const Real f13_x_p1657 = -(-(c19 * c20)) - f13_x_p363_lanes[1] * f13_x_p1649;
  const Real f13_x_p1658 = s17 * f13_x_p1657 - c17 * f13_x_p1656;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1659 = 0.282 * f13_x_p1658 - f13_x_p401_lanes[1] * f13_x_p1652;
  const Real f13_x_p1660 = c16 * f13_x_p1655 - s16 * f13_x_p1659;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1661 = s16 * f13_x_p1655 + c16 * f13_x_p1659 - inverse_D7_p1_lanes[1] *
      f13_x_p1660;
  const Real f13_x_p1662 = f13_x_p1408_lanes[1] * f13_x_p1660;
  const Real f13_x_p1663 = s15 * f13_x_p1662 + c15 * f13_x_p1661;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1680_lanes = c11 * detail::make_pack<Real>(f13_x_p1508, f13_x_p1507,
      f13_x_p1508, f13_x_p1506, f13_x_p1504, f13_x_p1502, f13_x_p1508, f13_x_p1508) - s11 *
      detail::make_pack<Real>(f13_x_p1520, f13_x_p1518, f13_x_p1520, f13_x_p1516, f13_x_p1515,
      f13_x_p1514, f13_x_p1520, f13_x_p1520);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1685_lanes = detail::make_pack<Real>(f13_x_p1680_lanes[0],
      f13_x_p1680_lanes[1], -(s11 * f13_x_p1531), f13_x_p1680_lanes[3], f13_x_p1680_lanes[4],
      f13_x_p1680_lanes[5], f13_x_p1680_lanes[0], f13_x_p1680_lanes[0]) - f13_x_p231_lanes[0] *
      detail::make_pack<Real>(f13_x_p1526_lanes[0], f13_x_p1526_lanes[1], f13_x_p1532,
      f13_x_p1526_lanes[3], f13_x_p1526_lanes[4], f13_x_p1526_lanes[5], f13_x_p1526_lanes[0],
      f13_x_p1526_lanes[0]);
  const Lanes<8> f13_x_p1697_lanes = f13_x_p221_lanes[0] *
      detail::make_pack<Real>(f13_x_p1526_lanes[0], f13_x_p1526_lanes[1], f13_x_p1532,
      f13_x_p1526_lanes[3], f13_x_p1526_lanes[4], f13_x_p1526_lanes[5], f13_x_p1526_lanes[0],
      f13_x_p1526_lanes[0]);
  const Lanes<8> f13_x_p1709_lanes = c10 * f13_x_p1697_lanes - s10 * f13_x_p1685_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1715_lanes = f13_x_p259_lanes[0] * f13_x_p1709_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p1755_lanes = s11 * detail::make_pack<Real>(f13_x_p1543, f13_x_p1542,
      f13_x_p1543, f13_x_p1541, f13_x_p1540, f13_x_p1539, f13_x_p1543, f13_x_p1543) + c11 *
      detail::make_pack<Real>(s13, c13, s13, f13_x_p1551, f13_x_p1550, f13_x_p1549, s13, s13);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1760_lanes = detail::make_pack<Real>(f13_x_p1755_lanes[0],
      f13_x_p1755_lanes[1], f13_x_p1284_lanes[0], f13_x_p1755_lanes[3], f13_x_p1755_lanes[4],
      f13_x_p1755_lanes[5], f13_x_p1755_lanes[0], f13_x_p1755_lanes[0]) - f13_x_p191_lanes[0] *
      detail::make_pack<Real>(f13_x_p1526_lanes[0], f13_x_p1526_lanes[1], f13_x_p1532,
      f13_x_p1526_lanes[3], f13_x_p1526_lanes[4], f13_x_p1526_lanes[5], f13_x_p1526_lanes[0],
      f13_x_p1526_lanes[0]);

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1778_lanes = c10 * f13_x_p1685_lanes + s10 * f13_x_p1697_lanes + 0.282 *
      f13_x_p1760_lanes - f13_x_p1715_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p1808_lanes = s10 * f13_x_p1576_lanes - c10 * f13_x_p1562_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1820_lanes = 0.282 * f13_x_p1808_lanes - f13_x_p401_lanes[0] *
      f13_x_p1709_lanes;
  const Lanes<8> f13_x_p1832_lanes = c9 * f13_x_p1778_lanes - s9 * f13_x_p1820_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1862_lanes = s9 * f13_x_p1778_lanes + c9 * f13_x_p1820_lanes -
      inverse_D7_p1_lanes[0] * f13_x_p1832_lanes;
  const Lanes<8> f13_x_p1874_lanes = f13_x_p1408_lanes[0] * f13_x_p1832_lanes;
  const Lanes<8> f13_x_p1886_lanes = s8 * f13_x_p1874_lanes + c8 * f13_x_p1862_lanes;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1900 = -f13_x_p1640 + f13_x_p569_lanes[1] * f13_x_p1634;
  const Real f13_x_p1901 = f13_x_p1636 - f13_x_p577_lanes[1] * f13_x_p1634;
  const Real f13_x_p1902 = -f13_x_p1658 + f13_x_p569_lanes[1] * f13_x_p1652;
  const Real f13_x_p1903 = f13_x_p1654 - f13_x_p577_lanes[1] * f13_x_p1652;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p1916_lanes = detail::make_pack<Real>(-f13_x_p1808_lanes[0],
      -f13_x_p1808_lanes[1], -f13_x_p1808_lanes[2], -f13_x_p1808_lanes[3], -f13_x_p1808_lanes[4],
      -f13_x_p1808_lanes[5], -f13_x_p1808_lanes[0], -f13_x_p1808_lanes[0]) + f13_x_p569_lanes[0] *
      f13_x_p1709_lanes;
  const Lanes<8> f13_x_p1934_lanes = f13_x_p1760_lanes - f13_x_p577_lanes[0] * f13_x_p1709_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p1952_lanes = c9 * f13_x_p1916_lanes - s9 * f13_x_p1934_lanes -
      f13_x_p657_lanes[0] * f13_x_p1832_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p1958_lanes = detail::make_pack<Real>(f13_x_p1952_lanes[0],
      f13_x_p1952_lanes[1], f13_x_p1952_lanes[2], f13_x_p1952_lanes[3], f13_x_p1952_lanes[4],
      f13_x_p1952_lanes[5], c16 * f13_x_p1902 - s16 * f13_x_p1903 - f13_x_p657_lanes[1] *
      f13_x_p1660, c16 * f13_x_p1900 - s16 * f13_x_p1901 - f13_x_p657_lanes[1] * f13_x_p1642) -
      detail::make_pack<Real>(f13_x_p679_lanes[0], f13_x_p679_lanes[0], f13_x_p679_lanes[0],
      f13_x_p679_lanes[0], f13_x_p679_lanes[0], f13_x_p679_lanes[0], f13_x_p679_lanes[1],
      f13_x_p679_lanes[1]) * detail::make_pack<Real>(f13_x_p1886_lanes[0], f13_x_p1886_lanes[1],
      f13_x_p1886_lanes[2], f13_x_p1886_lanes[3], f13_x_p1886_lanes[4], f13_x_p1886_lanes[5],
      f13_x_p1663, f13_x_p1645);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1982 = s16 * f13_x_p1900 + c16 * f13_x_p1901 - f13_x_p609_lanes[1] *
      f13_x_p1642;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p1987_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(f13_x_p1562_lanes[1], f13_x_p1638) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(f13_x_p1576_lanes[1],
      f13_x_p1639);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1989 = -(-f13_x_p1987_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1634) +
      f13_x_p555_lanes[1] * f13_x_p1642;
  const Real f13_x_p1990 = s16 * f13_x_p1902 + c16 * f13_x_p1903 - f13_x_p609_lanes[1] *
      f13_x_p1660;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p1995_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(f13_x_p1562_lanes[0], f13_x_p1656) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(f13_x_p1576_lanes[0],
      f13_x_p1657);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1997 = -(-f13_x_p1995_lanes[1] + f13_x_p515_lanes[1] * f13_x_p1652) +
      f13_x_p555_lanes[1] * f13_x_p1660;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2022_lanes = s9 * f13_x_p1916_lanes + c9 * f13_x_p1934_lanes -
      f13_x_p609_lanes[0] * f13_x_p1832_lanes;
  const Lanes<8> f13_x_p2040_lanes = detail::make_pack<Real>(-(-f13_x_p1995_lanes[0] +
      f13_x_p515_lanes[0] * f13_x_p1709_lanes[0]), -(-f13_x_p1987_lanes[0] + f13_x_p515_lanes[0] *
      f13_x_p1709_lanes[1]), -(-f13_x_p1602_lanes[0] + f13_x_p515_lanes[0] * f13_x_p1709_lanes[2]),
      -(-f13_x_p1596_lanes[0] + f13_x_p515_lanes[0] * f13_x_p1709_lanes[3]),
      -(-f13_x_p1590_lanes[0] + f13_x_p515_lanes[0] * f13_x_p1709_lanes[4]),
      -(-f13_x_p1584_lanes[0] + f13_x_p515_lanes[0] * f13_x_p1709_lanes[5]),
      -(-f13_x_p1995_lanes[0] + f13_x_p515_lanes[0] * f13_x_p1709_lanes[0]),
      -(-f13_x_p1995_lanes[0] + f13_x_p515_lanes[0] * f13_x_p1709_lanes[0])) + f13_x_p555_lanes[0] *
      f13_x_p1832_lanes;
  const Lanes<8> f13_x_p2052_lanes = c8 * f13_x_p2040_lanes - s8 * f13_x_p2022_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2058_lanes = detail::make_pack<Real>(f13_x_p2052_lanes[0],
      f13_x_p2052_lanes[1], f13_x_p2052_lanes[2], f13_x_p2052_lanes[3], f13_x_p2052_lanes[4],
      f13_x_p2052_lanes[5], c15 * f13_x_p1997 - s15 * f13_x_p1990, c15 * f13_x_p1989 - s15 *
      f13_x_p1982) - detail::make_pack<Real>(f13_x_p639_lanes[0], f13_x_p639_lanes[0],
      f13_x_p639_lanes[0], f13_x_p639_lanes[0], f13_x_p639_lanes[0], f13_x_p639_lanes[0],
      f13_x_p639_lanes[1], f13_x_p639_lanes[1]) * detail::make_pack<Real>(f13_x_p1886_lanes[0],
      f13_x_p1886_lanes[1], f13_x_p1886_lanes[2], f13_x_p1886_lanes[3], f13_x_p1886_lanes[4],
      f13_x_p1886_lanes[5], f13_x_p1663, f13_x_p1645);
  const Lanes<8> f13_x_p2074_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1958_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p2058_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2100_lanes = s15 * f13_x_p1604_lanes + c15 * f13_x_p1490_lanes -
      f13_x_p837_lanes[1] * f13_x_p1418_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2124_lanes = s8 * f13_x_p2040_lanes + c8 * f13_x_p2022_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2130_lanes = detail::make_pack<Real>(f13_x_p2124_lanes[0],
      f13_x_p2124_lanes[1], f13_x_p2124_lanes[2], f13_x_p2124_lanes[3], f13_x_p2124_lanes[4],
      f13_x_p2124_lanes[5], s15 * f13_x_p1997 + c15 * f13_x_p1990, s15 * f13_x_p1989 + c15 *
      f13_x_p1982) - detail::make_pack<Real>(f13_x_p837_lanes[0], f13_x_p837_lanes[0],
      f13_x_p837_lanes[0], f13_x_p837_lanes[0], f13_x_p837_lanes[0], f13_x_p837_lanes[0],
      f13_x_p837_lanes[1], f13_x_p837_lanes[1]) * detail::make_pack<Real>(f13_x_p1886_lanes[0],
      f13_x_p1886_lanes[1], f13_x_p1886_lanes[2], f13_x_p1886_lanes[3], f13_x_p1886_lanes[4],
      f13_x_p1886_lanes[5], f13_x_p1663, f13_x_p1645);
  const Lanes<2> f13_x_p2140_lanes = 0.226 * detail::make_pack<Real>(f13_x_p2130_lanes[5],
      f13_x_p2100_lanes[3]) + detail::make_pack<Real>(0.18, (-0.18)) *
      detail::make_pack<Real>(f13_x_p2074_lanes[5], f13_x_p1624_lanes[3]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2158_lanes = c15 * f13_x_p1410_lanes - s15 * f13_x_p1400_lanes -
      inverse_D6_p5_lanes[1] * f13_x_p1418_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p2182_lanes = c8 * f13_x_p1874_lanes - s8 * f13_x_p1862_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2188_lanes = detail::make_pack<Real>(f13_x_p2182_lanes[0],
      f13_x_p2182_lanes[1], f13_x_p2182_lanes[2], f13_x_p2182_lanes[3], f13_x_p2182_lanes[4],
      f13_x_p2182_lanes[5], c15 * f13_x_p1662 - s15 * f13_x_p1661, c15 * f13_x_p1644 - s15 *
      f13_x_p1643) - detail::make_pack<Real>(inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[1], inverse_D6_p5_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1886_lanes[0], f13_x_p1886_lanes[1], f13_x_p1886_lanes[2],
      f13_x_p1886_lanes[3], f13_x_p1886_lanes[4], f13_x_p1886_lanes[5], f13_x_p1663, f13_x_p1645);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> f13_x_p2198_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p17_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2200_lanes = f13_x_p2198_lanes[1] * f13_x_p1418_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2204_lanes = detail::make_pack<Real>(f13_x_p2198_lanes[0],
      f13_x_p2198_lanes[0], f13_x_p2198_lanes[0], f13_x_p2198_lanes[0], f13_x_p2198_lanes[0],
      f13_x_p2198_lanes[0], f13_x_p2198_lanes[1], f13_x_p2198_lanes[1]) *
      detail::make_pack<Real>(f13_x_p1886_lanes[0], f13_x_p1886_lanes[1], f13_x_p1886_lanes[2],
      f13_x_p1886_lanes[3], f13_x_p1886_lanes[4], f13_x_p1886_lanes[5], f13_x_p1663, f13_x_p1645);
  const Lanes<2> f13_x_p2216_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(f13_x_p2204_lanes[5], f13_x_p2200_lanes[3]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(f13_x_p2188_lanes[5],
      f13_x_p2158_lanes[3]) + f13_x_p2140_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2218 = -f13_x_p2216_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p2223_lanes = 0.226 * detail::make_pack<Real>(f13_x_p2130_lanes[4],
      f13_x_p2100_lanes[2]) + detail::make_pack<Real>(0.18, (-0.18)) *
      detail::make_pack<Real>(f13_x_p2074_lanes[4], f13_x_p1624_lanes[2]);
  const Lanes<2> f13_x_p2231_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(f13_x_p2204_lanes[4], f13_x_p2200_lanes[2]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(f13_x_p2188_lanes[4],
      f13_x_p2158_lanes[2]) + f13_x_p2223_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2233 = -f13_x_p2231_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p2238_lanes = 0.226 * detail::make_pack<Real>(f13_x_p2130_lanes[3],
      f13_x_p2100_lanes[1]) + detail::make_pack<Real>(0.18, (-0.18)) *
      detail::make_pack<Real>(f13_x_p2074_lanes[3], f13_x_p1624_lanes[1]);
  const Lanes<2> f13_x_p2246_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(f13_x_p2204_lanes[3], f13_x_p2200_lanes[1]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(f13_x_p2188_lanes[3],
      f13_x_p2158_lanes[1]) + f13_x_p2238_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2248 = -f13_x_p2246_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p2253_lanes = 0.226 * detail::make_pack<Real>(f13_x_p2130_lanes[2],
      f13_x_p2100_lanes[0]) + detail::make_pack<Real>(0.18, (-0.18)) *
      detail::make_pack<Real>(f13_x_p2074_lanes[2], f13_x_p1624_lanes[0]);
  const Lanes<2> f13_x_p2261_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(f13_x_p2204_lanes[2], f13_x_p2200_lanes[0]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(f13_x_p2188_lanes[2],
      f13_x_p2158_lanes[0]) + f13_x_p2253_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2263 = -f13_x_p2261_lanes[1];
  const Lanes<8> f13_x_p2264_lanes = inverse_D5_p16 *
      detail::make_pack<Real>(f13_x_p2263, f13_x_p2248, f13_x_p2233, f13_x_p2218, f13_x_p2263,
      f13_x_p2263, f13_x_p2263, f13_x_p2263);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p2276_lanes = c14 * f13_x_p1462_lanes - s14 * f13_x_p1616_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2300_lanes = (-0.18) * f13_x_p2276_lanes -
      (s14 * f13_x_p2200_lanes - c14 * f13_x_p2158_lanes) - f13_x_p2264_lanes;
  const Lanes<8> f13_x_p2316_lanes = 0.226 * f13_x_p2276_lanes - inverse_D5_p22 *
      detail::make_pack<Real>(f13_x_p2263, f13_x_p2248, f13_x_p2233, f13_x_p2218, f13_x_p2263,
      f13_x_p2263, f13_x_p2263, f13_x_p2263);
  const Lanes<8> f13_x_p2332_lanes = f13_x_p2276_lanes - f13_x_p993 *
      detail::make_pack<Real>(f13_x_p2263, f13_x_p2248, f13_x_p2233, f13_x_p2218, f13_x_p2263,
      f13_x_p2263, f13_x_p2263, f13_x_p2263);
  const Lanes<8> f13_x_p2340_lanes = s6 * f13_x_p2300_lanes + c6 * f13_x_p2316_lanes + 0.072 *
      f13_x_p2332_lanes;
  const Lanes<8> f13_x_p2348_lanes = f13_x_p1624_lanes + f13_x_p930 *
      detail::make_pack<Real>(f13_x_p2263, f13_x_p2248, f13_x_p2233, f13_x_p2218, f13_x_p2263,
      f13_x_p2263, f13_x_p2263, f13_x_p2263);
  const Lanes<8> f13_x_p2360_lanes = f13_x_p2100_lanes - f13_x_p984 *
      detail::make_pack<Real>(f13_x_p2263, f13_x_p2248, f13_x_p2233, f13_x_p2218, f13_x_p2263,
      f13_x_p2263, f13_x_p2263, f13_x_p2263);
  const Lanes<8> f13_x_p2368_lanes = s6 * f13_x_p2348_lanes + c6 * f13_x_p2360_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2372 = -(0.072 * f13_x_p2368_lanes[3]) + f13_x_p1020 * f13_x_p2340_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2381_lanes = c6 * f13_x_p2300_lanes - s6 * f13_x_p2316_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2385 = f13_x_p2381_lanes[3] - f13_x_p1022 * f13_x_p2340_lanes[3];

  // link 4 (chest1), force propagation
  const Real f13_x_p2386 = -(s5 * f13_x_p2372 + c5 * f13_x_p2385);

  // link 5 (chest2), force propagation
  const Real f13_x_p2387 = -(0.072 * f13_x_p2368_lanes[2]) + f13_x_p1020 * f13_x_p2340_lanes[2];
  const Real f13_x_p2388 = f13_x_p2381_lanes[2] - f13_x_p1022 * f13_x_p2340_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p2389 = -(s5 * f13_x_p2387 + c5 * f13_x_p2388);

  // link 5 (chest2), force propagation
  const Real f13_x_p2390 = -(0.072 * f13_x_p2368_lanes[1]) + f13_x_p1020 * f13_x_p2340_lanes[1];
  const Real f13_x_p2391 = f13_x_p2381_lanes[1] - f13_x_p1022 * f13_x_p2340_lanes[1];

  // link 4 (chest1), force propagation
  const Real f13_x_p2392 = -(s5 * f13_x_p2390 + c5 * f13_x_p2391);

  // link 5 (chest2), force propagation
  const Real f13_x_p2393 = -(0.072 * f13_x_p2368_lanes[0]) + f13_x_p1020 * f13_x_p2340_lanes[0];
  const Real f13_x_p2394 = f13_x_p2381_lanes[0] - f13_x_p1022 * f13_x_p2340_lanes[0];

  // link 4 (chest1), force propagation
  const Real f13_x_p2395 = -(s5 * f13_x_p2393 + c5 * f13_x_p2394);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2404_lanes = f13_x_p2368_lanes - f13_x_p1005 * f13_x_p2340_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2428_lanes = c6 * f13_x_p2348_lanes - s6 * f13_x_p2360_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2432 = f13_x_p2428_lanes[3] - f13_x_p1033 * f13_x_p2340_lanes[3];
  const Real f13_x_p2433 = f13_x_p2332_lanes[3] - f13_x_p1029 * f13_x_p2340_lanes[3];
  const Real f13_x_p2434 = s5 * f13_x_p2432 - c5 * f13_x_p2433;
  const Real f13_x_p2435 = f13_x_p2428_lanes[2] - f13_x_p1033 * f13_x_p2340_lanes[2];
  const Real f13_x_p2436 = f13_x_p2332_lanes[2] - f13_x_p1029 * f13_x_p2340_lanes[2];
  const Real f13_x_p2437 = s5 * f13_x_p2435 - c5 * f13_x_p2436;
  const Real f13_x_p2438 = f13_x_p2428_lanes[1] - f13_x_p1033 * f13_x_p2340_lanes[1];
  const Real f13_x_p2439 = f13_x_p2332_lanes[1] - f13_x_p1029 * f13_x_p2340_lanes[1];
  const Real f13_x_p2440 = s5 * f13_x_p2438 - c5 * f13_x_p2439;
  const Real f13_x_p2441 = f13_x_p2428_lanes[0] - f13_x_p1033 * f13_x_p2340_lanes[0];
  const Real f13_x_p2442 = f13_x_p2332_lanes[0] - f13_x_p1029 * f13_x_p2340_lanes[0];
  const Real f13_x_p2443 = s5 * f13_x_p2441 - c5 * f13_x_p2442;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2448_lanes = c4 * (detail::make_pack<Real>(-(0.21799999999999997 *
      f13_x_p2443), -(0.21799999999999997 * f13_x_p2440), -(0.21799999999999997 * f13_x_p2437),
      -(0.21799999999999997 * f13_x_p2434), -(0.21799999999999997 * f13_x_p2443),
      -(0.21799999999999997 * f13_x_p2443), -(0.21799999999999997 * f13_x_p2443),
      -(0.21799999999999997 * f13_x_p2443)) + inverse_D3_p2 *
      detail::make_pack<Real>(f13_x_p2395, f13_x_p2392, f13_x_p2389, f13_x_p2386, f13_x_p2395,
      f13_x_p2395, f13_x_p2395, f13_x_p2395));
  const Lanes<8> f13_x_p2452_lanes = s4 * (detail::make_pack<Real>(-(s5 * f13_x_p2394 - c5 *
      f13_x_p2393 + 0.21799999999999997 * f13_x_p2404_lanes[0]),
      -(s5 * f13_x_p2391 - c5 * f13_x_p2390 + 0.21799999999999997 * f13_x_p2404_lanes[1]),
      -(s5 * f13_x_p2388 - c5 * f13_x_p2387 + 0.21799999999999997 * f13_x_p2404_lanes[2]),
      -(s5 * f13_x_p2385 - c5 * f13_x_p2372 + 0.21799999999999997 * f13_x_p2404_lanes[3]),
      -(s5 * f13_x_p2394 - c5 * f13_x_p2393 + 0.21799999999999997 * f13_x_p2404_lanes[0]),
      -(s5 * f13_x_p2394 - c5 * f13_x_p2393 + 0.21799999999999997 * f13_x_p2404_lanes[0]),
      -(s5 * f13_x_p2394 - c5 * f13_x_p2393 + 0.21799999999999997 * f13_x_p2404_lanes[0]),
      -(s5 * f13_x_p2394 - c5 * f13_x_p2393 + 0.21799999999999997 * f13_x_p2404_lanes[0])) -
      inverse_D3_p1 * detail::make_pack<Real>(f13_x_p2395, f13_x_p2392, f13_x_p2389, f13_x_p2386,
      f13_x_p2395, f13_x_p2395, f13_x_p2395, f13_x_p2395)) + f13_x_p2448_lanes;
  const Lanes<8> f13_x_p2480_lanes = s4 * (f13_x_p2404_lanes + f13_x_p1050 *
      detail::make_pack<Real>(f13_x_p2395, f13_x_p2392, f13_x_p2389, f13_x_p2386, f13_x_p2395,
      f13_x_p2395, f13_x_p2395, f13_x_p2395));

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p2488_lanes = c4 * (detail::make_pack<Real>(-f13_x_p2443, -f13_x_p2440,
      -f13_x_p2437, -f13_x_p2434, -f13_x_p2443, -f13_x_p2443, -f13_x_p2443, -f13_x_p2443) +
      f13_x_p1041 * detail::make_pack<Real>(f13_x_p2395, f13_x_p2392, f13_x_p2389, f13_x_p2386,
      f13_x_p2395, f13_x_p2395, f13_x_p2395, f13_x_p2395)) - f13_x_p2480_lanes - f13_x_p1063 *
      f13_x_p2452_lanes;
  const Lanes<8> f13_x_p2500_lanes = detail::make_pack<Real>(-(-(s5 * f13_x_p2442 + c5 *
      f13_x_p2441) - f13_x_p1068 * f13_x_p2395), -(-(s5 * f13_x_p2439 + c5 * f13_x_p2438) -
      f13_x_p1068 * f13_x_p2392), -(-(s5 * f13_x_p2436 + c5 * f13_x_p2435) - f13_x_p1068 *
      f13_x_p2389), -(-(s5 * f13_x_p2433 + c5 * f13_x_p2432) - f13_x_p1068 * f13_x_p2386),
      -(-(s5 * f13_x_p2442 + c5 * f13_x_p2441) - f13_x_p1068 * f13_x_p2395),
      -(-(s5 * f13_x_p2442 + c5 * f13_x_p2441) - f13_x_p1068 * f13_x_p2395),
      -(-(s5 * f13_x_p2442 + c5 * f13_x_p2441) - f13_x_p1068 * f13_x_p2395),
      -(-(s5 * f13_x_p2442 + c5 * f13_x_p2441) - f13_x_p1068 * f13_x_p2395)) + f13_x_p1073 *
      f13_x_p2452_lanes;
  const Lanes<8> f13_x_p2508_lanes = c3 * f13_x_p2488_lanes - s3 * f13_x_p2500_lanes;
  const Lanes<8> f13_x_p2512_lanes = 0.422 * f13_x_p2508_lanes;

  // link 3 (hip), articulated inertia
  const Real f13_x_p2528 = c3 * f13_x_p1076 - f13_x_p1075;
  const Real f13_x_p2529 = 0.031999971599999996 + 0.422 * f13_x_p2528;

  // link 2 (thigh), articulated inertia
  const Real f13_x_p2530 = f13_x_p2529 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p2551_lanes = s2 * (s3 * f13_x_p2488_lanes + c3 * f13_x_p2500_lanes -
      f13_x_p2530 * f13_x_p2512_lanes);
  const Lanes<8> f13_x_p2559_lanes = 0.434 * (c2 * (f13_x_p2508_lanes - f13_x_p1080 *
      f13_x_p2512_lanes) - f13_x_p2551_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = f13_x_p1078 - f13_x_p1079 * f13_x_p1080;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (f13_x_p1074 + f13_x_p1077 - f13_x_p2529 *
      f13_x_p2530)) + c2 * (2.0 * (f13_x_p2528 - f13_x_p1079 * f13_x_p2530));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p2563_lanes = f13_x_p2559_lanes * inverse_D1;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p2571_lanes = 0.226 * detail::make_pack<Real>(f13_x_p2130_lanes[1],
      f13_x_p2130_lanes[7]) + detail::make_pack<Real>(0.18, (-0.18)) *
      detail::make_pack<Real>(f13_x_p2074_lanes[1], f13_x_p2074_lanes[7]);
  const Lanes<2> f13_x_p2579_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(f13_x_p2204_lanes[1], f13_x_p2204_lanes[7]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(f13_x_p2188_lanes[1],
      f13_x_p2188_lanes[7]) + f13_x_p2571_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2581 = -f13_x_p2579_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p2586_lanes = 0.226 * detail::make_pack<Real>(f13_x_p2130_lanes[0],
      f13_x_p2130_lanes[6]) + detail::make_pack<Real>(0.18, (-0.18)) *
      detail::make_pack<Real>(f13_x_p2074_lanes[0], f13_x_p2074_lanes[6]);
  const Lanes<2> f13_x_p2594_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(f13_x_p2204_lanes[0], f13_x_p2204_lanes[6]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(f13_x_p2188_lanes[0],
      f13_x_p2188_lanes[6]) + f13_x_p2586_lanes;

  // link 6 (chest3), force propagation
  const Real f13_x_p2596 = -f13_x_p2594_lanes[1];
  const Real f13_x_p2597 = -f13_x_p2216_lanes[0];
  const Real f13_x_p2598 = -f13_x_p2231_lanes[0];
  const Real f13_x_p2599 = -f13_x_p2246_lanes[0];
  const Real f13_x_p2600 = -f13_x_p2261_lanes[0];
  const Real f13_x_p2601 = -f13_x_p2579_lanes[0];
  const Real f13_x_p2602 = -f13_x_p2594_lanes[0];
  const Lanes<8> f13_x_p2603_lanes = inverse_D5_p16 *
      detail::make_pack<Real>(f13_x_p2602, f13_x_p2601, f13_x_p2600, f13_x_p2599, f13_x_p2598,
      f13_x_p2597, f13_x_p2596, f13_x_p2581);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p2627_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1958_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p2058_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2675_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18,
      (-0.18), (-0.18)) * f13_x_p2627_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * f13_x_p2204_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p2188_lanes) - f13_x_p2603_lanes;
  const Lanes<8> f13_x_p2707_lanes = 0.226 * f13_x_p2627_lanes - inverse_D5_p22 *
      detail::make_pack<Real>(f13_x_p2602, f13_x_p2601, f13_x_p2600, f13_x_p2599, f13_x_p2598,
      f13_x_p2597, f13_x_p2596, f13_x_p2581);
  const Lanes<8> f13_x_p2739_lanes = f13_x_p2627_lanes - f13_x_p993 *
      detail::make_pack<Real>(f13_x_p2602, f13_x_p2601, f13_x_p2600, f13_x_p2599, f13_x_p2598,
      f13_x_p2597, f13_x_p2596, f13_x_p2581);
  const Lanes<8> f13_x_p2755_lanes = s6 * f13_x_p2675_lanes + c6 * f13_x_p2707_lanes + 0.072 *
      f13_x_p2739_lanes;
  const Lanes<8> f13_x_p2771_lanes = f13_x_p2074_lanes + f13_x_p930 *
      detail::make_pack<Real>(f13_x_p2602, f13_x_p2601, f13_x_p2600, f13_x_p2599, f13_x_p2598,
      f13_x_p2597, f13_x_p2596, f13_x_p2581);
  const Lanes<8> f13_x_p2795_lanes = f13_x_p2130_lanes - f13_x_p984 *
      detail::make_pack<Real>(f13_x_p2602, f13_x_p2601, f13_x_p2600, f13_x_p2599, f13_x_p2598,
      f13_x_p2597, f13_x_p2596, f13_x_p2581);
  const Lanes<8> f13_x_p2811_lanes = s6 * f13_x_p2771_lanes + c6 * f13_x_p2795_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2819 = -(0.072 * f13_x_p2811_lanes[7]) + f13_x_p1020 * f13_x_p2755_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2836_lanes = c6 * f13_x_p2675_lanes - s6 * f13_x_p2707_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2844 = f13_x_p2836_lanes[7] - f13_x_p1022 * f13_x_p2755_lanes[7];

  // link 4 (chest1), force propagation
  const Real f13_x_p2845 = -(s5 * f13_x_p2819 + c5 * f13_x_p2844);

  // link 5 (chest2), force propagation
  const Real f13_x_p2846 = -(0.072 * f13_x_p2811_lanes[6]) + f13_x_p1020 * f13_x_p2755_lanes[6];
  const Real f13_x_p2847 = f13_x_p2836_lanes[6] - f13_x_p1022 * f13_x_p2755_lanes[6];

  // link 4 (chest1), force propagation
  const Real f13_x_p2848 = -(s5 * f13_x_p2846 + c5 * f13_x_p2847);

  // link 5 (chest2), force propagation
  const Real f13_x_p2849 = -(0.072 * f13_x_p2811_lanes[5]) + f13_x_p1020 * f13_x_p2755_lanes[5];
  const Real f13_x_p2850 = f13_x_p2836_lanes[5] - f13_x_p1022 * f13_x_p2755_lanes[5];

  // link 4 (chest1), force propagation
  const Real f13_x_p2851 = -(s5 * f13_x_p2849 + c5 * f13_x_p2850);

  // link 5 (chest2), force propagation
  const Real f13_x_p2852 = -(0.072 * f13_x_p2811_lanes[4]) + f13_x_p1020 * f13_x_p2755_lanes[4];
  const Real f13_x_p2853 = f13_x_p2836_lanes[4] - f13_x_p1022 * f13_x_p2755_lanes[4];

  // link 4 (chest1), force propagation
  const Real f13_x_p2854 = -(s5 * f13_x_p2852 + c5 * f13_x_p2853);

  // link 5 (chest2), force propagation
  const Real f13_x_p2855 = -(0.072 * f13_x_p2811_lanes[3]) + f13_x_p1020 * f13_x_p2755_lanes[3];
  const Real f13_x_p2856 = f13_x_p2836_lanes[3] - f13_x_p1022 * f13_x_p2755_lanes[3];

  // link 4 (chest1), force propagation
  const Real f13_x_p2857 = -(s5 * f13_x_p2855 + c5 * f13_x_p2856);

  // link 5 (chest2), force propagation
  const Real f13_x_p2858 = -(0.072 * f13_x_p2811_lanes[2]) + f13_x_p1020 * f13_x_p2755_lanes[2];
  const Real f13_x_p2859 = f13_x_p2836_lanes[2] - f13_x_p1022 * f13_x_p2755_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p2860 = -(s5 * f13_x_p2858 + c5 * f13_x_p2859);

  // link 5 (chest2), force propagation
  const Real f13_x_p2861 = -(0.072 * f13_x_p2811_lanes[1]) + f13_x_p1020 * f13_x_p2755_lanes[1];
  const Real f13_x_p2862 = f13_x_p2836_lanes[1] - f13_x_p1022 * f13_x_p2755_lanes[1];

  // link 4 (chest1), force propagation
  const Real f13_x_p2863 = -(s5 * f13_x_p2861 + c5 * f13_x_p2862);

  // link 5 (chest2), force propagation
  const Real f13_x_p2864 = -(0.072 * f13_x_p2811_lanes[0]) + f13_x_p1020 * f13_x_p2755_lanes[0];
  const Real f13_x_p2865 = f13_x_p2836_lanes[0] - f13_x_p1022 * f13_x_p2755_lanes[0];

  // link 4 (chest1), force propagation
  const Real f13_x_p2866 = -(s5 * f13_x_p2864 + c5 * f13_x_p2865);

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p2883_lanes = f13_x_p2811_lanes - f13_x_p1005 * f13_x_p2755_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p2931_lanes = c6 * f13_x_p2771_lanes - s6 * f13_x_p2795_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2939 = f13_x_p2931_lanes[7] - f13_x_p1033 * f13_x_p2755_lanes[7];
  const Real f13_x_p2940 = f13_x_p2739_lanes[7] - f13_x_p1029 * f13_x_p2755_lanes[7];
  const Real f13_x_p2941 = s5 * f13_x_p2939 - c5 * f13_x_p2940;
  const Real f13_x_p2942 = f13_x_p2931_lanes[6] - f13_x_p1033 * f13_x_p2755_lanes[6];
  const Real f13_x_p2943 = f13_x_p2739_lanes[6] - f13_x_p1029 * f13_x_p2755_lanes[6];
  const Real f13_x_p2944 = s5 * f13_x_p2942 - c5 * f13_x_p2943;
  const Real f13_x_p2945 = f13_x_p2931_lanes[5] - f13_x_p1033 * f13_x_p2755_lanes[5];
  const Real f13_x_p2946 = f13_x_p2739_lanes[5] - f13_x_p1029 * f13_x_p2755_lanes[5];
  const Real f13_x_p2947 = s5 * f13_x_p2945 - c5 * f13_x_p2946;
  const Real f13_x_p2948 = f13_x_p2931_lanes[4] - f13_x_p1033 * f13_x_p2755_lanes[4];
  const Real f13_x_p2949 = f13_x_p2739_lanes[4] - f13_x_p1029 * f13_x_p2755_lanes[4];
  const Real f13_x_p2950 = s5 * f13_x_p2948 - c5 * f13_x_p2949;
  const Real f13_x_p2951 = f13_x_p2931_lanes[3] - f13_x_p1033 * f13_x_p2755_lanes[3];
  const Real f13_x_p2952 = f13_x_p2739_lanes[3] - f13_x_p1029 * f13_x_p2755_lanes[3];
  const Real f13_x_p2953 = s5 * f13_x_p2951 - c5 * f13_x_p2952;
  const Real f13_x_p2954 = f13_x_p2931_lanes[2] - f13_x_p1033 * f13_x_p2755_lanes[2];
  const Real f13_x_p2955 = f13_x_p2739_lanes[2] - f13_x_p1029 * f13_x_p2755_lanes[2];
  const Real f13_x_p2956 = s5 * f13_x_p2954 - c5 * f13_x_p2955;
  const Real f13_x_p2957 = f13_x_p2931_lanes[1] - f13_x_p1033 * f13_x_p2755_lanes[1];
  const Real f13_x_p2958 = f13_x_p2739_lanes[1] - f13_x_p1029 * f13_x_p2755_lanes[1];
  const Real f13_x_p2959 = s5 * f13_x_p2957 - c5 * f13_x_p2958;
  const Real f13_x_p2960 = f13_x_p2931_lanes[0] - f13_x_p1033 * f13_x_p2755_lanes[0];
  const Real f13_x_p2961 = f13_x_p2739_lanes[0] - f13_x_p1029 * f13_x_p2755_lanes[0];
  const Real f13_x_p2962 = s5 * f13_x_p2960 - c5 * f13_x_p2961;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p2971_lanes = c4 * (detail::make_pack<Real>(-(0.21799999999999997 *
      f13_x_p2962), -(0.21799999999999997 * f13_x_p2959), -(0.21799999999999997 * f13_x_p2956),
      -(0.21799999999999997 * f13_x_p2953), -(0.21799999999999997 * f13_x_p2950),
      -(0.21799999999999997 * f13_x_p2947), -(0.21799999999999997 * f13_x_p2944),
      -(0.21799999999999997 * f13_x_p2941)) + inverse_D3_p2 *
      detail::make_pack<Real>(f13_x_p2866, f13_x_p2863, f13_x_p2860, f13_x_p2857, f13_x_p2854,
      f13_x_p2851, f13_x_p2848, f13_x_p2845));
  const Lanes<8> f13_x_p2979_lanes = s4 * (detail::make_pack<Real>(-(s5 * f13_x_p2865 - c5 *
      f13_x_p2864 + 0.21799999999999997 * f13_x_p2883_lanes[0]),
      -(s5 * f13_x_p2862 - c5 * f13_x_p2861 + 0.21799999999999997 * f13_x_p2883_lanes[1]),
      -(s5 * f13_x_p2859 - c5 * f13_x_p2858 + 0.21799999999999997 * f13_x_p2883_lanes[2]),
      -(s5 * f13_x_p2856 - c5 * f13_x_p2855 + 0.21799999999999997 * f13_x_p2883_lanes[3]),
      -(s5 * f13_x_p2853 - c5 * f13_x_p2852 + 0.21799999999999997 * f13_x_p2883_lanes[4]),
      -(s5 * f13_x_p2850 - c5 * f13_x_p2849 + 0.21799999999999997 * f13_x_p2883_lanes[5]),
      -(s5 * f13_x_p2847 - c5 * f13_x_p2846 + 0.21799999999999997 * f13_x_p2883_lanes[6]),
      -(s5 * f13_x_p2844 - c5 * f13_x_p2819 + 0.21799999999999997 * f13_x_p2883_lanes[7])) -
      inverse_D3_p1 * detail::make_pack<Real>(f13_x_p2866, f13_x_p2863, f13_x_p2860, f13_x_p2857,
      f13_x_p2854, f13_x_p2851, f13_x_p2848, f13_x_p2845)) + f13_x_p2971_lanes;
  const Lanes<8> f13_x_p3035_lanes = s4 * (f13_x_p2883_lanes + f13_x_p1050 *
      detail::make_pack<Real>(f13_x_p2866, f13_x_p2863, f13_x_p2860, f13_x_p2857, f13_x_p2854,
      f13_x_p2851, f13_x_p2848, f13_x_p2845));

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3051_lanes = c4 * (detail::make_pack<Real>(-f13_x_p2962, -f13_x_p2959,
      -f13_x_p2956, -f13_x_p2953, -f13_x_p2950, -f13_x_p2947, -f13_x_p2944, -f13_x_p2941) +
      f13_x_p1041 * detail::make_pack<Real>(f13_x_p2866, f13_x_p2863, f13_x_p2860, f13_x_p2857,
      f13_x_p2854, f13_x_p2851, f13_x_p2848, f13_x_p2845)) - f13_x_p3035_lanes - f13_x_p1063 *
      f13_x_p2979_lanes;
  const Lanes<8> f13_x_p3075_lanes = detail::make_pack<Real>(-(-(s5 * f13_x_p2961 + c5 *
      f13_x_p2960) - f13_x_p1068 * f13_x_p2866), -(-(s5 * f13_x_p2958 + c5 * f13_x_p2957) -
      f13_x_p1068 * f13_x_p2863), -(-(s5 * f13_x_p2955 + c5 * f13_x_p2954) - f13_x_p1068 *
      f13_x_p2860), -(-(s5 * f13_x_p2952 + c5 * f13_x_p2951) - f13_x_p1068 * f13_x_p2857),
      -(-(s5 * f13_x_p2949 + c5 * f13_x_p2948) - f13_x_p1068 * f13_x_p2854),
      -(-(s5 * f13_x_p2946 + c5 * f13_x_p2945) - f13_x_p1068 * f13_x_p2851),
      -(-(s5 * f13_x_p2943 + c5 * f13_x_p2942) - f13_x_p1068 * f13_x_p2848),
      -(-(s5 * f13_x_p2940 + c5 * f13_x_p2939) - f13_x_p1068 * f13_x_p2845)) + f13_x_p1073 *
      f13_x_p2979_lanes;
  const Lanes<8> f13_x_p3091_lanes = c3 * f13_x_p3051_lanes - s3 * f13_x_p3075_lanes;
  const Lanes<8> f13_x_p3099_lanes = 0.422 * f13_x_p3091_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p3171_lanes = s2 * (s3 * f13_x_p3051_lanes + c3 * f13_x_p3075_lanes -
      f13_x_p2530 * f13_x_p3099_lanes);
  const Lanes<8> f13_x_p3187_lanes = 0.434 * (c2 * (f13_x_p3091_lanes - f13_x_p1080 *
      f13_x_p3099_lanes) - f13_x_p3171_lanes);
  const Lanes<8> f13_x_p3199_lanes = f13_x_p2512_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3207_lanes = f13_x_p2452_lanes * inverse_D3;
  const Lanes<8> f13_x_p3211_lanes = f13_x_p3207_lanes * f13_x_p2979_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3215_lanes = detail::make_pack<Real>(f13_x_p2395, f13_x_p2392, f13_x_p2389,
      f13_x_p2386, f13_x_p2395, f13_x_p2395, f13_x_p2395, f13_x_p2395) * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3223_lanes = f13_x_p2340_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3231_lanes = detail::make_pack<Real>(f13_x_p2263, f13_x_p2248, f13_x_p2233,
      f13_x_p2218, f13_x_p2263, f13_x_p2263, f13_x_p2263, f13_x_p2263) * inverse_D6;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3247_lanes = f13_x_p3231_lanes * f13_x_p2602 + f13_x_p3223_lanes *
      f13_x_p2755_lanes[0] + f13_x_p3215_lanes * f13_x_p2866 + f13_x_p3211_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3255_lanes = f13_x_p3247_lanes + f13_x_p3199_lanes * f13_x_p3099_lanes[0] +
      f13_x_p2563_lanes * f13_x_p3187_lanes[0];
  const Lanes<8> f13_x_p3259_lanes = f13_x_p3187_lanes * inverse_D1;

  // link 2 (thigh), force propagation
  const Lanes<8> f13_x_p3275_lanes = f13_x_p3099_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3291_lanes = f13_x_p2979_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p3307_lanes = detail::make_pack<Real>(f13_x_p2866, f13_x_p2863, f13_x_p2860,
      f13_x_p2857, f13_x_p2854, f13_x_p2851, f13_x_p2848, f13_x_p2845) * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> f13_x_p3323_lanes = f13_x_p2755_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Real f13_x_p3339 = f13_x_p2581 * inverse_D6;
  const Real f13_x_p3340 = f13_x_p2596 * inverse_D6;
  const Lanes<8> f13_x_p3341_lanes = detail::make_pack<Real>(f13_x_p2602, f13_x_p2601, f13_x_p2600,
      f13_x_p2599, f13_x_p2598, f13_x_p2597, f13_x_p2602, f13_x_p2602) * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3353_lanes = f13_x_p1886_lanes * inverse_D7_lanes[0];
  const Lanes<8> f13_x_p3359_lanes = f13_x_p3353_lanes * f13_x_p1886_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> f13_x_p3365_lanes = f13_x_p1832_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p3377_lanes = f13_x_p1709_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> f13_x_p3389_lanes = detail::make_pack<Real>(f13_x_p1526_lanes[0],
      f13_x_p1526_lanes[1], f13_x_p1532, f13_x_p1526_lanes[3], f13_x_p1526_lanes[4],
      f13_x_p1526_lanes[5], f13_x_p1526_lanes[0], f13_x_p1526_lanes[0]) * inverse_D10_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3413_lanes = f13_x_p3389_lanes * f13_x_p1526_lanes[0] + f13_x_p3377_lanes *
      f13_x_p1709_lanes[0] + f13_x_p3365_lanes * f13_x_p1832_lanes[0] + f13_x_p3359_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3419_lanes = f13_x_p3413_lanes + f13_x_p3341_lanes * f13_x_p2602;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3441_lanes = detail::make_pack<Real>(f13_x_p3419_lanes[0],
      f13_x_p3419_lanes[1], f13_x_p3419_lanes[2], f13_x_p3419_lanes[3], f13_x_p3419_lanes[4],
      f13_x_p3419_lanes[5], f13_x_p3340 * f13_x_p2602, f13_x_p3339 * f13_x_p2602) +
      f13_x_p3323_lanes * f13_x_p2755_lanes[0] + f13_x_p3307_lanes * f13_x_p2866 +
      f13_x_p3291_lanes * f13_x_p2979_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3457_lanes = f13_x_p3441_lanes + f13_x_p3275_lanes * f13_x_p3099_lanes[0] +
      f13_x_p3259_lanes * f13_x_p3187_lanes[0];
  const Real f13_x_p3465 = 1.0 / f13_x_p3457_lanes[0];
  const Lanes<8> f13_x_p3466_lanes = f13_x_p3255_lanes * f13_x_p3465;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3482_lanes = f13_x_p3207_lanes * f13_x_p2979_lanes[1];
  const Lanes<8> f13_x_p3506_lanes = f13_x_p3231_lanes * f13_x_p2601 + f13_x_p3223_lanes *
      f13_x_p2755_lanes[1] + f13_x_p3215_lanes * f13_x_p2863 + f13_x_p3482_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3518_lanes = f13_x_p3506_lanes + f13_x_p3199_lanes * f13_x_p3099_lanes[1] +
      f13_x_p2563_lanes * f13_x_p3187_lanes[1] - f13_x_p3466_lanes * f13_x_p3457_lanes[1];
  const Lanes<8> f13_x_p3522_lanes = f13_x_p3457_lanes * f13_x_p3465;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3576_lanes = f13_x_p3353_lanes * f13_x_p1886_lanes[1];
  const Lanes<8> f13_x_p3606_lanes = f13_x_p3389_lanes * f13_x_p1526_lanes[1] + f13_x_p3377_lanes *
      f13_x_p1709_lanes[1] + f13_x_p3365_lanes * f13_x_p1832_lanes[1] + f13_x_p3576_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3611_lanes = f13_x_p3606_lanes + f13_x_p3341_lanes * f13_x_p2601;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3630_lanes = detail::make_pack<Real>(f13_x_p3611_lanes[1],
      f13_x_p3611_lanes[1], f13_x_p3611_lanes[2], f13_x_p3611_lanes[3], f13_x_p3611_lanes[4],
      f13_x_p3611_lanes[5], f13_x_p3340 * f13_x_p2601, f13_x_p3339 * f13_x_p2601) +
      f13_x_p3323_lanes * f13_x_p2755_lanes[1] + f13_x_p3307_lanes * f13_x_p2863 +
      f13_x_p3291_lanes * f13_x_p2979_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3651_lanes = f13_x_p3630_lanes + f13_x_p3275_lanes * f13_x_p3099_lanes[1] +
      f13_x_p3259_lanes * f13_x_p3187_lanes[1] - f13_x_p3522_lanes * f13_x_p3457_lanes[1];
  const Real f13_x_p3658 = 1.0 / f13_x_p3651_lanes[1];
  const Lanes<8> f13_x_p3659_lanes = f13_x_p3518_lanes * f13_x_p3658;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3679_lanes = f13_x_p3207_lanes * f13_x_p2979_lanes[2];
  const Lanes<8> f13_x_p3703_lanes = f13_x_p3231_lanes * f13_x_p2600 + f13_x_p3223_lanes *
      f13_x_p2755_lanes[2] + f13_x_p3215_lanes * f13_x_p2860 + f13_x_p3679_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3715_lanes = f13_x_p3703_lanes + f13_x_p3199_lanes * f13_x_p3099_lanes[2] +
      f13_x_p2563_lanes * f13_x_p3187_lanes[2] - f13_x_p3466_lanes * f13_x_p3457_lanes[2];
  const Lanes<8> f13_x_p3719_lanes = f13_x_p3715_lanes - f13_x_p3659_lanes * f13_x_p3651_lanes[2];
  const Lanes<8> f13_x_p3723_lanes = f13_x_p3651_lanes * f13_x_p3658;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> f13_x_p3775_lanes = f13_x_p3353_lanes * f13_x_p1886_lanes[2];
  const Lanes<8> f13_x_p3799_lanes = f13_x_p3389_lanes * f13_x_p1532 + f13_x_p3377_lanes *
      f13_x_p1709_lanes[2] + f13_x_p3365_lanes * f13_x_p1832_lanes[2] + f13_x_p3775_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p3803_lanes = f13_x_p3799_lanes + f13_x_p3341_lanes * f13_x_p2600;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3819_lanes = detail::make_pack<Real>(f13_x_p3803_lanes[2],
      f13_x_p3803_lanes[2], f13_x_p3803_lanes[2], f13_x_p3803_lanes[3], f13_x_p3803_lanes[4],
      f13_x_p3803_lanes[5], f13_x_p3340 * f13_x_p2600, f13_x_p3339 * f13_x_p2600) +
      f13_x_p3323_lanes * f13_x_p2755_lanes[2] + f13_x_p3307_lanes * f13_x_p2860 +
      f13_x_p3291_lanes * f13_x_p2979_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3837_lanes = f13_x_p3819_lanes + f13_x_p3275_lanes * f13_x_p3099_lanes[2] +
      f13_x_p3259_lanes * f13_x_p3187_lanes[2] - f13_x_p3522_lanes * f13_x_p3457_lanes[2];
  const Lanes<8> f13_x_p3843_lanes = f13_x_p3837_lanes - f13_x_p3723_lanes * f13_x_p3651_lanes[2];
  const Real f13_x_p3849 = 1.0 / f13_x_p3843_lanes[2];
  const Lanes<8> f13_x_p3850_lanes = f13_x_p3719_lanes * f13_x_p3849;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p3874_lanes = f13_x_p3207_lanes * f13_x_p2979_lanes[3];
  const Lanes<8> f13_x_p3898_lanes = f13_x_p3231_lanes * f13_x_p2599 + f13_x_p3223_lanes *
      f13_x_p2755_lanes[3] + f13_x_p3215_lanes * f13_x_p2857 + f13_x_p3874_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p3910_lanes = f13_x_p3898_lanes + f13_x_p3199_lanes * f13_x_p3099_lanes[3] +
      f13_x_p2563_lanes * f13_x_p3187_lanes[3] - f13_x_p3466_lanes * f13_x_p3457_lanes[3];
  const Lanes<8> f13_x_p3918_lanes = f13_x_p3910_lanes - f13_x_p3659_lanes * f13_x_p3651_lanes[3] -
      f13_x_p3850_lanes * f13_x_p3843_lanes[3];
  const Lanes<8> f13_x_p3922_lanes = f13_x_p3843_lanes * f13_x_p3849;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p3976_lanes = f13_x_p3377_lanes * f13_x_p1709_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> f13_x_p3982_lanes = detail::make_pack<Real>(f13_x_p1505, f13_x_p1505, f13_x_p1505,
      f13_x_p1505, f13_x_p1503, f13_x_p1337, f13_x_p1505, f13_x_p1505) * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> f13_x_p3988_lanes = detail::make_pack<Real>(s13, s13, s13, s13, c13,
      f13_x_p1085_lanes[0], s13, s13) * inverse_D12_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> f13_x_p4000_lanes = f13_x_p3988_lanes * s13 + f13_x_p3982_lanes * f13_x_p1505 +
      f13_x_p3389_lanes * f13_x_p1526_lanes[3] + f13_x_p3976_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4009_lanes = f13_x_p4000_lanes + f13_x_p3365_lanes * f13_x_p1832_lanes[3] +
      f13_x_p3353_lanes * f13_x_p1886_lanes[3] + f13_x_p3341_lanes * f13_x_p2599;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4022_lanes = detail::make_pack<Real>(f13_x_p4009_lanes[3],
      f13_x_p4009_lanes[3], f13_x_p4009_lanes[3], f13_x_p4009_lanes[3], f13_x_p4009_lanes[4],
      f13_x_p4009_lanes[5], f13_x_p3340 * f13_x_p2599, f13_x_p3339 * f13_x_p2599) +
      f13_x_p3323_lanes * f13_x_p2755_lanes[3] + f13_x_p3307_lanes * f13_x_p2857 +
      f13_x_p3291_lanes * f13_x_p2979_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4037_lanes = f13_x_p4022_lanes + f13_x_p3275_lanes * f13_x_p3099_lanes[3] +
      f13_x_p3259_lanes * f13_x_p3187_lanes[3] - f13_x_p3522_lanes * f13_x_p3457_lanes[3];
  const Lanes<8> f13_x_p4047_lanes = f13_x_p4037_lanes - f13_x_p3723_lanes * f13_x_p3651_lanes[3] -
      f13_x_p3922_lanes * f13_x_p3843_lanes[3];
  const Real f13_x_p4052 = 1.0 / f13_x_p4047_lanes[3];
  const Lanes<8> f13_x_p4053_lanes = f13_x_p3918_lanes * f13_x_p4052;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4081_lanes = f13_x_p3207_lanes * f13_x_p2979_lanes[4];
  const Lanes<8> f13_x_p4105_lanes = f13_x_p3231_lanes * f13_x_p2598 + f13_x_p3223_lanes *
      f13_x_p2755_lanes[4] + f13_x_p3215_lanes * f13_x_p2854 + f13_x_p4081_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4117_lanes = f13_x_p4105_lanes + f13_x_p3199_lanes * f13_x_p3099_lanes[4] +
      f13_x_p2563_lanes * f13_x_p3187_lanes[4] - f13_x_p3466_lanes * f13_x_p3457_lanes[4];
  const Lanes<8> f13_x_p4129_lanes = f13_x_p4117_lanes - f13_x_p3659_lanes * f13_x_p3651_lanes[4] -
      f13_x_p3850_lanes * f13_x_p3843_lanes[4] - f13_x_p4053_lanes * f13_x_p4047_lanes[4];
  const Lanes<8> f13_x_p4133_lanes = f13_x_p4047_lanes * f13_x_p4052;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4173_lanes = f13_x_p1418_lanes * inverse_D7_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p4177_lanes = detail::make_pack<Real>(f13_x_p3353_lanes[5],
      f13_x_p4173_lanes[3]) * detail::make_pack<Real>(f13_x_p1886_lanes[4], f13_x_p1418_lanes[2]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> f13_x_p4179_lanes = f13_x_p1380_lanes * inverse_D8_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> f13_x_p4183_lanes = detail::make_pack<Real>(f13_x_p3365_lanes[5],
      f13_x_p4179_lanes[3]) * detail::make_pack<Real>(f13_x_p1832_lanes[4], f13_x_p1380_lanes[2]);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p4185_lanes = f13_x_p1239_lanes * inverse_D9_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes<2> f13_x_p4189_lanes = detail::make_pack<Real>(f13_x_p3377_lanes[5],
      f13_x_p4185_lanes[3]) * detail::make_pack<Real>(f13_x_p1709_lanes[4], f13_x_p1239_lanes[2]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> f13_x_p4191_lanes = detail::make_pack<Real>(f13_x_p1209, f13_x_p1205_lanes[1],
      f13_x_p1205_lanes[2], f13_x_p1205_lanes[3], f13_x_p1209, f13_x_p1209, f13_x_p1209,
      f13_x_p1209) * inverse_D10_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p4195_lanes = detail::make_pack<Real>(f13_x_p3389_lanes[5],
      f13_x_p4191_lanes[3]) * detail::make_pack<Real>(f13_x_p1526_lanes[4], f13_x_p1205_lanes[2]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> f13_x_p4197_lanes = detail::make_pack<Real>(f13_x_p1113, f13_x_p1113, f13_x_p1106,
      f13_x_p1099, f13_x_p1113, f13_x_p1113, f13_x_p1113, f13_x_p1113) * inverse_D11_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> f13_x_p4200_lanes = detail::make_pack<Real>(f13_x_p3982_lanes[5],
      f13_x_p4197_lanes[3]) * detail::make_pack<Real>(f13_x_p1503, f13_x_p1106);
  const Lanes<2> f13_x_p4204_lanes = detail::make_pack<Real>(f13_x_p3982_lanes[4],
      f13_x_p4197_lanes[2]) * detail::make_pack<Real>(f13_x_p1503, f13_x_p1106);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p4208_lanes = detail::make_pack<Real>(f13_x_p3389_lanes[4],
      f13_x_p4191_lanes[2]) * detail::make_pack<Real>(f13_x_p1526_lanes[4], f13_x_p1205_lanes[2]);

  // link 9 (left_upperarm), force propagation
  const Lanes<2> f13_x_p4212_lanes = detail::make_pack<Real>(f13_x_p3377_lanes[4],
      f13_x_p4185_lanes[2]) * detail::make_pack<Real>(f13_x_p1709_lanes[4], f13_x_p1239_lanes[2]);

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> f13_x_p4216_lanes = detail::make_pack<Real>(f13_x_p3365_lanes[4],
      f13_x_p4179_lanes[2]) * detail::make_pack<Real>(f13_x_p1832_lanes[4], f13_x_p1380_lanes[2]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p4220_lanes = detail::make_pack<Real>(f13_x_p3353_lanes[4],
      f13_x_p4173_lanes[2]) * detail::make_pack<Real>(f13_x_p1886_lanes[4], f13_x_p1418_lanes[2]);
  const Lanes<8> f13_x_p4222_lanes = f13_x_p3988_lanes * c13 +
      detail::make_pack<Real>(f13_x_p4204_lanes[0], f13_x_p4204_lanes[0], f13_x_p4204_lanes[0],
      f13_x_p4204_lanes[0], f13_x_p4204_lanes[0], f13_x_p4200_lanes[0], f13_x_p4204_lanes[0],
      f13_x_p4204_lanes[0]) + detail::make_pack<Real>(f13_x_p4208_lanes[0], f13_x_p4208_lanes[0],
      f13_x_p4208_lanes[0], f13_x_p4208_lanes[0], f13_x_p4208_lanes[0], f13_x_p4195_lanes[0],
      f13_x_p4208_lanes[0], f13_x_p4208_lanes[0]) + detail::make_pack<Real>(f13_x_p4212_lanes[0],
      f13_x_p4212_lanes[0], f13_x_p4212_lanes[0], f13_x_p4212_lanes[0], f13_x_p4212_lanes[0],
      f13_x_p4189_lanes[0], f13_x_p4212_lanes[0], f13_x_p4212_lanes[0]) +
      detail::make_pack<Real>(f13_x_p4216_lanes[0], f13_x_p4216_lanes[0], f13_x_p4216_lanes[0],
      f13_x_p4216_lanes[0], f13_x_p4216_lanes[0], f13_x_p4183_lanes[0], f13_x_p4216_lanes[0],
      f13_x_p4216_lanes[0]) + detail::make_pack<Real>(f13_x_p4220_lanes[0], f13_x_p4220_lanes[0],
      f13_x_p4220_lanes[0], f13_x_p4220_lanes[0], f13_x_p4220_lanes[0], f13_x_p4177_lanes[0],
      f13_x_p4220_lanes[0], f13_x_p4220_lanes[0]);

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4224_lanes = f13_x_p4222_lanes +
      detail::make_pack<Real>(f13_x_p3341_lanes[4] * f13_x_p2598, f13_x_p3341_lanes[4] *
      f13_x_p2598, f13_x_p3341_lanes[4] * f13_x_p2598, f13_x_p3341_lanes[4] * f13_x_p2598,
      f13_x_p3341_lanes[4] * f13_x_p2598, f13_x_p3341_lanes[5] * f13_x_p2598, f13_x_p3341_lanes[4] *
      f13_x_p2598, f13_x_p3341_lanes[4] * f13_x_p2598);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4234_lanes = detail::make_pack<Real>(f13_x_p4224_lanes[4],
      f13_x_p4224_lanes[4], f13_x_p4224_lanes[4], f13_x_p4224_lanes[4], f13_x_p4224_lanes[4],
      f13_x_p4224_lanes[5], f13_x_p3340 * f13_x_p2598, f13_x_p3339 * f13_x_p2598) +
      f13_x_p3323_lanes * f13_x_p2755_lanes[4] + f13_x_p3307_lanes * f13_x_p2854 +
      f13_x_p3291_lanes * f13_x_p2979_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4246_lanes = f13_x_p4234_lanes + f13_x_p3275_lanes * f13_x_p3099_lanes[4] +
      f13_x_p3259_lanes * f13_x_p3187_lanes[4] - f13_x_p3522_lanes * f13_x_p3457_lanes[4];
  const Lanes<8> f13_x_p4258_lanes = f13_x_p4246_lanes - f13_x_p3723_lanes * f13_x_p3651_lanes[4] -
      f13_x_p3922_lanes * f13_x_p3843_lanes[4] - f13_x_p4133_lanes * f13_x_p4047_lanes[4];
  const Real f13_x_p4262 = 1.0 / f13_x_p4258_lanes[4];
  const Lanes<8> f13_x_p4263_lanes = f13_x_p4129_lanes * f13_x_p4262;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4295_lanes = f13_x_p3207_lanes * f13_x_p2979_lanes[5];
  const Lanes<8> f13_x_p4319_lanes = f13_x_p3231_lanes * f13_x_p2597 + f13_x_p3223_lanes *
      f13_x_p2755_lanes[5] + f13_x_p3215_lanes * f13_x_p2851 + f13_x_p4295_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4331_lanes = f13_x_p4319_lanes + f13_x_p3199_lanes * f13_x_p3099_lanes[5] +
      f13_x_p2563_lanes * f13_x_p3187_lanes[5] - f13_x_p3466_lanes * f13_x_p3457_lanes[5];
  const Lanes<8> f13_x_p4343_lanes = f13_x_p4331_lanes - f13_x_p3659_lanes * f13_x_p3651_lanes[5] -
      f13_x_p3850_lanes * f13_x_p3843_lanes[5] - f13_x_p4053_lanes * f13_x_p4047_lanes[5];
  const Lanes<8> f13_x_p4347_lanes = f13_x_p4343_lanes - f13_x_p4263_lanes * f13_x_p4258_lanes[5];
  const Lanes<8> f13_x_p4351_lanes = f13_x_p4258_lanes * f13_x_p4262;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> f13_x_p4394_lanes = detail::make_pack<Real>(s20, s20, c20, f13_x_p1085_lanes[1],
      s20, s20, s20, s20) * inverse_D12_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> f13_x_p4403_lanes = 1065.380700001509 +
      detail::make_pack<Real>(f13_x_p3988_lanes[5], f13_x_p4394_lanes[3]) * f13_x_p1085_lanes +
      detail::make_pack<Real>(f13_x_p3982_lanes[5], f13_x_p4197_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1337, f13_x_p1099) +
      detail::make_pack<Real>(f13_x_p3389_lanes[5], f13_x_p4191_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1526_lanes[5], f13_x_p1205_lanes[3]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> f13_x_p4409_lanes = f13_x_p4403_lanes +
      detail::make_pack<Real>(f13_x_p3377_lanes[5], f13_x_p4185_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1709_lanes[5], f13_x_p1239_lanes[3]) +
      detail::make_pack<Real>(f13_x_p3365_lanes[5], f13_x_p4179_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1832_lanes[5], f13_x_p1380_lanes[3]) +
      detail::make_pack<Real>(f13_x_p3353_lanes[5], f13_x_p4173_lanes[3]) *
      detail::make_pack<Real>(f13_x_p1886_lanes[5], f13_x_p1418_lanes[3]);

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4417_lanes = detail::make_pack<Real>(f13_x_p4409_lanes[0] +
      f13_x_p3341_lanes[5] * f13_x_p2597, f13_x_p4409_lanes[0] + f13_x_p3341_lanes[5] * f13_x_p2597,
      f13_x_p4409_lanes[0] + f13_x_p3341_lanes[5] * f13_x_p2597, f13_x_p4409_lanes[0] +
      f13_x_p3341_lanes[5] * f13_x_p2597, f13_x_p4409_lanes[0] + f13_x_p3341_lanes[5] * f13_x_p2597,
      f13_x_p4409_lanes[0] + f13_x_p3341_lanes[5] * f13_x_p2597, f13_x_p3340 * f13_x_p2597,
      f13_x_p3339 * f13_x_p2597) + f13_x_p3323_lanes * f13_x_p2755_lanes[5] + f13_x_p3307_lanes *
      f13_x_p2851 + f13_x_p3291_lanes * f13_x_p2979_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4426_lanes = f13_x_p4417_lanes + f13_x_p3275_lanes * f13_x_p3099_lanes[5] +
      f13_x_p3259_lanes * f13_x_p3187_lanes[5] - f13_x_p3522_lanes * f13_x_p3457_lanes[5];
  const Lanes<8> f13_x_p4435_lanes = f13_x_p4426_lanes - f13_x_p3723_lanes * f13_x_p3651_lanes[5] -
      f13_x_p3922_lanes * f13_x_p3843_lanes[5] - f13_x_p4133_lanes * f13_x_p4047_lanes[5];
  const Lanes<8> f13_x_p4438_lanes = f13_x_p4435_lanes - f13_x_p4351_lanes * f13_x_p4258_lanes[5];
  const Real f13_x_p4441 = 1.0 / f13_x_p4438_lanes[5];
  const Lanes<8> f13_x_p4442_lanes = f13_x_p4347_lanes * f13_x_p4441;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4494_lanes = f13_x_p4173_lanes * f13_x_p1663;
  const Lanes<8> f13_x_p4518_lanes = f13_x_p4191_lanes * f13_x_p1649 + f13_x_p4185_lanes *
      f13_x_p1652 + f13_x_p4179_lanes * f13_x_p1660 + f13_x_p4494_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p4530_lanes = f13_x_p4518_lanes + f13_x_p3231_lanes * f13_x_p2596 +
      f13_x_p3223_lanes * f13_x_p2755_lanes[6] + f13_x_p3215_lanes * f13_x_p2848;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4542_lanes = f13_x_p4530_lanes + f13_x_p3207_lanes * f13_x_p2979_lanes[6] +
      f13_x_p3199_lanes * f13_x_p3099_lanes[6] + f13_x_p2563_lanes * f13_x_p3187_lanes[6];
  const Lanes<8> f13_x_p4554_lanes = f13_x_p4542_lanes - f13_x_p3466_lanes * f13_x_p3457_lanes[6] -
      f13_x_p3659_lanes * f13_x_p3651_lanes[6] - f13_x_p3850_lanes * f13_x_p3843_lanes[6];
  const Lanes<8> f13_x_p4566_lanes = f13_x_p4554_lanes - f13_x_p4053_lanes * f13_x_p4047_lanes[6] -
      f13_x_p4263_lanes * f13_x_p4258_lanes[6] - f13_x_p4442_lanes * f13_x_p4438_lanes[6];
  const Real f13_x_p4570 = f13_x_p4438_lanes[6] * f13_x_p4441;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4571 = f13_x_p1649 * inverse_D10_lanes[1] * f13_x_p1649 + f13_x_p1652 *
      inverse_D9_lanes[1] * f13_x_p1652 + f13_x_p1660 * inverse_D8_lanes[1] * f13_x_p1660;

  // link 4 (chest1), force propagation
  const Real f13_x_p4572 = f13_x_p4571 + f13_x_p1663 * inverse_D7_lanes[1] * f13_x_p1663 +
      f13_x_p3340 * f13_x_p2596 + f13_x_p3323_lanes[6] * f13_x_p2755_lanes[6] +
      f13_x_p3307_lanes[6] * f13_x_p2848;

  // link 1 (calf), force propagation
  const Real f13_x_p4573 = f13_x_p4572 + f13_x_p3291_lanes[6] * f13_x_p2979_lanes[6] +
      f13_x_p3275_lanes[6] * f13_x_p3099_lanes[6] + f13_x_p3259_lanes[6] * f13_x_p3187_lanes[6] -
      f13_x_p3522_lanes[6] * f13_x_p3457_lanes[6];
  const Real f13_x_p4574 = f13_x_p4573 - f13_x_p3723_lanes[6] * f13_x_p3651_lanes[6] -
      f13_x_p3922_lanes[6] * f13_x_p3843_lanes[6] - f13_x_p4133_lanes[6] * f13_x_p4047_lanes[6] -
      f13_x_p4351_lanes[6] * f13_x_p4258_lanes[6];
  const Real f13_x_p4575 = 1.0 / (f13_x_p4574 - f13_x_p4570 * f13_x_p4438_lanes[6]);
  const Lanes<8> f13_x_p4576_lanes = f13_x_p4566_lanes * f13_x_p4575;
  const Real f13_x_p4580 = f13_x_p4438_lanes[7] * f13_x_p4441;

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p4581 = f13_x_p1645 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4582 = f13_x_p1642 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p4583 = f13_x_p1634 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p4584 = f13_x_p1631 * inverse_D10_lanes[1];

  // link 6 (chest3), force propagation
  const Real f13_x_p4585 = f13_x_p4584 * f13_x_p1649 + f13_x_p4583 * f13_x_p1652 + f13_x_p4582 *
      f13_x_p1660 + f13_x_p4581 * f13_x_p1663 + f13_x_p3339 * f13_x_p2596;

  // link 2 (thigh), force propagation
  const Real f13_x_p4586 = f13_x_p4585 + f13_x_p3323_lanes[7] * f13_x_p2755_lanes[6] +
      f13_x_p3307_lanes[7] * f13_x_p2848 + f13_x_p3291_lanes[7] * f13_x_p2979_lanes[6] +
      f13_x_p3275_lanes[7] * f13_x_p3099_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p4587 = f13_x_p4586 + f13_x_p3259_lanes[7] * f13_x_p3187_lanes[6] -
      f13_x_p3522_lanes[7] * f13_x_p3457_lanes[6] - f13_x_p3723_lanes[7] * f13_x_p3651_lanes[6] -
      f13_x_p3922_lanes[7] * f13_x_p3843_lanes[6];
  const Real f13_x_p4588 = f13_x_p4587 - f13_x_p4133_lanes[7] * f13_x_p4047_lanes[6] -
      f13_x_p4351_lanes[7] * f13_x_p4258_lanes[6] - f13_x_p4580 * f13_x_p4438_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4641_lanes = f13_x_p4173_lanes * f13_x_p1645;
  const Lanes<8> f13_x_p4665_lanes = f13_x_p4191_lanes * f13_x_p1631 + f13_x_p4185_lanes *
      f13_x_p1634 + f13_x_p4179_lanes * f13_x_p1642 + f13_x_p4641_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p4677_lanes = f13_x_p4665_lanes + f13_x_p3231_lanes * f13_x_p2581 +
      f13_x_p3223_lanes * f13_x_p2755_lanes[7] + f13_x_p3215_lanes * f13_x_p2845;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4689_lanes = f13_x_p4677_lanes + f13_x_p3207_lanes * f13_x_p2979_lanes[7] +
      f13_x_p3199_lanes * f13_x_p3099_lanes[7] + f13_x_p2563_lanes * f13_x_p3187_lanes[7];
  const Lanes<8> f13_x_p4701_lanes = f13_x_p4689_lanes - f13_x_p3466_lanes * f13_x_p3457_lanes[7] -
      f13_x_p3659_lanes * f13_x_p3651_lanes[7] - f13_x_p3850_lanes * f13_x_p3843_lanes[7];
  const Lanes<8> f13_x_p4713_lanes = f13_x_p4701_lanes - f13_x_p4053_lanes * f13_x_p4047_lanes[7] -
      f13_x_p4263_lanes * f13_x_p4258_lanes[7] - f13_x_p4442_lanes * f13_x_p4438_lanes[7];
  const Lanes<8> f13_x_p4717_lanes = f13_x_p4713_lanes - f13_x_p4576_lanes * f13_x_p4588;
  const Real f13_x_p4721 = f13_x_p4588 * f13_x_p4575;

  // link 6 (chest3), force propagation
  const Real f13_x_p4722 = f13_x_p4584 * f13_x_p1631 + f13_x_p4583 * f13_x_p1634 + f13_x_p4582 *
      f13_x_p1642 + f13_x_p4581 * f13_x_p1645 + f13_x_p3339 * f13_x_p2581;

  // link 2 (thigh), force propagation
  const Real f13_x_p4723 = f13_x_p4722 + f13_x_p3323_lanes[7] * f13_x_p2755_lanes[7] +
      f13_x_p3307_lanes[7] * f13_x_p2845 + f13_x_p3291_lanes[7] * f13_x_p2979_lanes[7] +
      f13_x_p3275_lanes[7] * f13_x_p3099_lanes[7];

  // link 1 (calf), force propagation
  const Real f13_x_p4724 = f13_x_p4723 + f13_x_p3259_lanes[7] * f13_x_p3187_lanes[7] -
      f13_x_p3522_lanes[7] * f13_x_p3457_lanes[7] - f13_x_p3723_lanes[7] * f13_x_p3651_lanes[7] -
      f13_x_p3922_lanes[7] * f13_x_p3843_lanes[7];
  const Real f13_x_p4725 = f13_x_p4724 - f13_x_p4133_lanes[7] * f13_x_p4047_lanes[7] -
      f13_x_p4351_lanes[7] * f13_x_p4258_lanes[7] - f13_x_p4580 * f13_x_p4438_lanes[7] -
      f13_x_p4721 * f13_x_p4588;
  const Real f13_x_p4726 = 1.0 / f13_x_p4725;
  const Lanes<8> f13_x_p4727_lanes = f13_x_p4717_lanes * f13_x_p4726;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p4787_lanes = f13_x_p4173_lanes * f13_x_p1418_lanes[0];
  const Lanes<8> f13_x_p4811_lanes = f13_x_p4191_lanes * f13_x_p1209 + f13_x_p4185_lanes *
      f13_x_p1239_lanes[0] + f13_x_p4179_lanes * f13_x_p1380_lanes[0] + f13_x_p4787_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> f13_x_p4823_lanes = f13_x_p4811_lanes + f13_x_p3231_lanes * f13_x_p2263 +
      f13_x_p3223_lanes * f13_x_p2340_lanes[0] + f13_x_p3215_lanes * f13_x_p2395;

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4835_lanes = f13_x_p4823_lanes + f13_x_p3207_lanes * f13_x_p2452_lanes[0] +
      f13_x_p3199_lanes * f13_x_p2512_lanes[0] + f13_x_p2563_lanes * f13_x_p2559_lanes[0];
  const Lanes<8> f13_x_p4847_lanes = f13_x_p4835_lanes - f13_x_p3466_lanes * f13_x_p3255_lanes[0] -
      f13_x_p3659_lanes * f13_x_p3518_lanes[0] - f13_x_p3850_lanes * f13_x_p3719_lanes[0];
  const Lanes<8> f13_x_p4859_lanes = f13_x_p4847_lanes - f13_x_p4053_lanes * f13_x_p3918_lanes[0] -
      f13_x_p4263_lanes * f13_x_p4129_lanes[0] - f13_x_p4442_lanes * f13_x_p4347_lanes[0];
  const Lanes<8> f13_x_p4867_lanes = f13_x_p4859_lanes - f13_x_p4576_lanes * f13_x_p4566_lanes[0] -
      f13_x_p4727_lanes * f13_x_p4717_lanes[0];
  const Real f13_x_p4871 = 1.0 / f13_x_p4867_lanes[0];
  const Lanes<8> f13_x_p4872_lanes = f13_x_p4867_lanes * f13_x_p4871;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> f13_x_p4926_lanes = f13_x_p4185_lanes * f13_x_p1239_lanes[1];
  const Lanes<8> f13_x_p4944_lanes = f13_x_p4394_lanes * s20 + f13_x_p4197_lanes * f13_x_p1113 +
      f13_x_p4191_lanes * f13_x_p1205_lanes[1] + f13_x_p4926_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> f13_x_p4953_lanes = f13_x_p4944_lanes + f13_x_p4179_lanes * f13_x_p1380_lanes[1] +
      f13_x_p4173_lanes * f13_x_p1418_lanes[1] + f13_x_p3231_lanes * f13_x_p2248;

  // link 3 (hip), force propagation
  const Lanes<8> f13_x_p4962_lanes = f13_x_p4953_lanes + f13_x_p3223_lanes * f13_x_p2340_lanes[1] +
      f13_x_p3215_lanes * f13_x_p2392 + f13_x_p3207_lanes * f13_x_p2452_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> f13_x_p4971_lanes = f13_x_p4962_lanes + f13_x_p3199_lanes * f13_x_p2512_lanes[1] +
      f13_x_p2563_lanes * f13_x_p2559_lanes[1] - f13_x_p3466_lanes * f13_x_p3255_lanes[1];
  const Lanes<8> f13_x_p4980_lanes = f13_x_p4971_lanes - f13_x_p3659_lanes * f13_x_p3518_lanes[1] -
      f13_x_p3850_lanes * f13_x_p3719_lanes[1] - f13_x_p4053_lanes * f13_x_p3918_lanes[1];
  const Lanes<8> f13_x_p4989_lanes = f13_x_p4980_lanes - f13_x_p4263_lanes * f13_x_p4129_lanes[1] -
      f13_x_p4442_lanes * f13_x_p4347_lanes[1] - f13_x_p4576_lanes * f13_x_p4566_lanes[1];
  const Lanes<8> f13_x_p4995_lanes = f13_x_p4989_lanes - f13_x_p4727_lanes * f13_x_p4717_lanes[1] -
      f13_x_p4872_lanes * f13_x_p4867_lanes[1];
  const Real f13_x_p4998 = 1.0 / f13_x_p4995_lanes[1];
  const Real f13_x_p4999 = f13_x_p4995_lanes[3] * f13_x_p4998;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> f13_x_p5010_lanes = f13_x_p4394_lanes * c20 +
      detail::make_pack<Real>(f13_x_p4204_lanes[1], f13_x_p4204_lanes[1], f13_x_p4204_lanes[1],
      f13_x_p4200_lanes[1], f13_x_p4204_lanes[1], f13_x_p4204_lanes[1], f13_x_p4204_lanes[1],
      f13_x_p4204_lanes[1]) + detail::make_pack<Real>(f13_x_p4208_lanes[1], f13_x_p4208_lanes[1],
      f13_x_p4208_lanes[1], f13_x_p4195_lanes[1], f13_x_p4208_lanes[1], f13_x_p4208_lanes[1],
      f13_x_p4208_lanes[1], f13_x_p4208_lanes[1]) + detail::make_pack<Real>(f13_x_p4212_lanes[1],
      f13_x_p4212_lanes[1], f13_x_p4212_lanes[1], f13_x_p4189_lanes[1], f13_x_p4212_lanes[1],
      f13_x_p4212_lanes[1], f13_x_p4212_lanes[1], f13_x_p4212_lanes[1]) +
      detail::make_pack<Real>(f13_x_p4216_lanes[1], f13_x_p4216_lanes[1], f13_x_p4216_lanes[1],
      f13_x_p4183_lanes[1], f13_x_p4216_lanes[1], f13_x_p4216_lanes[1], f13_x_p4216_lanes[1],
      f13_x_p4216_lanes[1]) + detail::make_pack<Real>(f13_x_p4220_lanes[1], f13_x_p4220_lanes[1],
      f13_x_p4220_lanes[1], f13_x_p4177_lanes[1], f13_x_p4220_lanes[1], f13_x_p4220_lanes[1],
      f13_x_p4220_lanes[1], f13_x_p4220_lanes[1]);

  // link 3 (hip), force propagation
  const Real f13_x_p5012 = f13_x_p5010_lanes[3] + f13_x_p3231_lanes[3] * f13_x_p2233 +
      f13_x_p3223_lanes[3] * f13_x_p2340_lanes[2] + f13_x_p3215_lanes[3] * f13_x_p2389 +
      f13_x_p3207_lanes[3] * f13_x_p2452_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p5013 = f13_x_p5012 + f13_x_p3199_lanes[3] * f13_x_p2512_lanes[2] +
      f13_x_p2563_lanes[3] * f13_x_p2559_lanes[2] - f13_x_p3466_lanes[3] * f13_x_p3255_lanes[2] -
      f13_x_p3659_lanes[3] * f13_x_p3518_lanes[2];
  const Real f13_x_p5014 = f13_x_p5013 - f13_x_p3850_lanes[3] * f13_x_p3719_lanes[2] -
      f13_x_p4053_lanes[3] * f13_x_p3918_lanes[2] - f13_x_p4263_lanes[3] * f13_x_p4129_lanes[2] -
      f13_x_p4442_lanes[3] * f13_x_p4347_lanes[2];
  const Real f13_x_p5015 = f13_x_p5014 - f13_x_p4576_lanes[3] * f13_x_p4566_lanes[2] -
      f13_x_p4727_lanes[3] * f13_x_p4717_lanes[2] - f13_x_p4872_lanes[3] * f13_x_p4867_lanes[2] -
      f13_x_p4999 * f13_x_p4995_lanes[2];
  const Real f13_x_p5016 = f13_x_p4995_lanes[2] * f13_x_p4998;

  // link 3 (hip), force propagation
  const Real f13_x_p5017 = f13_x_p5010_lanes[2] + f13_x_p3231_lanes[2] * f13_x_p2233 +
      f13_x_p3223_lanes[2] * f13_x_p2340_lanes[2] + f13_x_p3215_lanes[2] * f13_x_p2389 +
      f13_x_p3207_lanes[2] * f13_x_p2452_lanes[2];

  // link 1 (calf), force propagation
  const Real f13_x_p5018 = f13_x_p5017 + f13_x_p3199_lanes[2] * f13_x_p2512_lanes[2] +
      f13_x_p2563_lanes[2] * f13_x_p2559_lanes[2] - f13_x_p3466_lanes[2] * f13_x_p3255_lanes[2] -
      f13_x_p3659_lanes[2] * f13_x_p3518_lanes[2];
  const Real f13_x_p5019 = f13_x_p5018 - f13_x_p3850_lanes[2] * f13_x_p3719_lanes[2] -
      f13_x_p4053_lanes[2] * f13_x_p3918_lanes[2] - f13_x_p4263_lanes[2] * f13_x_p4129_lanes[2] -
      f13_x_p4442_lanes[2] * f13_x_p4347_lanes[2];
  const Real f13_x_p5020 = f13_x_p5019 - f13_x_p4576_lanes[2] * f13_x_p4566_lanes[2] -
      f13_x_p4727_lanes[2] * f13_x_p4717_lanes[2] - f13_x_p4872_lanes[2] * f13_x_p4867_lanes[2] -
      f13_x_p5016 * f13_x_p4995_lanes[2];
  const Real f13_x_p5021 = 1.0 / f13_x_p5020;
  const Real f13_x_p5022 = f13_x_p5015 * f13_x_p5021;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5025_lanes = 9.81 + detail::make_pack<Real>(xdd_cmd[2], xdd_cmd[8]);
  const Lanes<2> f13_x_p5029_lanes = c1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) - s1 *
      f13_x_p5025_lanes;
  const Lanes<2> f13_x_p5037_lanes = s1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) + c1 *
      f13_x_p5025_lanes;
  const Lanes<2> f13_x_p5041_lanes = c2 * f13_x_p5029_lanes - s2 * f13_x_p5037_lanes;
  const Lanes<2> f13_x_p5049_lanes = s2 * f13_x_p5029_lanes + c2 * f13_x_p5037_lanes;
  const Lanes<2> f13_x_p5053_lanes = c3 * f13_x_p5041_lanes - s3 * f13_x_p5049_lanes;
  const Lanes<2> f13_x_p5059_lanes = c4 * f13_x_p5053_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Lanes<2> f13_x_p5067_lanes = s3 * f13_x_p5041_lanes + c3 * f13_x_p5049_lanes;
  const Lanes<2> f13_x_p5071_lanes = s5 * f13_x_p5059_lanes + c5 * f13_x_p5067_lanes;
  const Lanes<2> f13_x_p5079_lanes = c4 * detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]) - s4 *
      f13_x_p5053_lanes;
  const Lanes<2> f13_x_p5083_lanes = s6 * f13_x_p5079_lanes - c6 * f13_x_p5071_lanes;
  const Lanes<2> f13_x_p5091_lanes = c5 * f13_x_p5059_lanes - s5 * f13_x_p5067_lanes;
  const Lanes<2> f13_x_p5095_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p5083_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p5091_lanes;
  const Lanes<2> f13_x_p5103_lanes = s6 * f13_x_p5071_lanes + c6 * f13_x_p5079_lanes;
  const Lanes<2> f13_x_p5107_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5103_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p5095_lanes;
  const Lanes<2> f13_x_p5115_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p5083_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p5091_lanes;
  const Lanes<2> f13_x_p5119_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p5107_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p5115_lanes;
  const Lanes<2> f13_x_p5127_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5095_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p5103_lanes;
  const Lanes<2> f13_x_p5131_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5119_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p5127_lanes;
  const Lanes<2> f13_x_p5139_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p5107_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p5115_lanes;
  const Lanes<2> f13_x_p5143_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5131_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p5139_lanes;
  const Lanes<2> f13_x_p5151_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5127_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p5119_lanes;
  const Lanes<2> f13_x_p5155_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5151_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p5143_lanes;
  const Lanes<2> f13_x_p5163_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5139_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p5131_lanes;

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
  const Lanes<2> f13_x_p5169_lanes = w13_y_lanes * w13_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> f13_x_p5171_lanes = w13_z_lanes * w13_z_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5173_lanes = f13_x_p5169_lanes + f13_x_p5171_lanes;
  const Lanes<2> f13_x_p5179_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5155_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p5163_lanes +
      (minus_a13_x_lanes + 0.086 * f13_x_p5173_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> a13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_a12_y_lanes -
      detail::make_pack<Real>(c13, c20) * minus_a12_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5187_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5163_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p5155_lanes - a13_y_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5193_lanes = c1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) - s1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);
  const Lanes<2> f13_x_p5201_lanes = s1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) + c1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);
  const Lanes<2> f13_x_p5205_lanes = c2 * f13_x_p5193_lanes - s2 * f13_x_p5201_lanes;
  const Lanes<2> f13_x_p5213_lanes = s2 * f13_x_p5193_lanes + c2 * f13_x_p5201_lanes;
  const Lanes<2> f13_x_p5217_lanes = c3 * f13_x_p5205_lanes - s3 * f13_x_p5213_lanes;
  const Lanes<2> f13_x_p5223_lanes = c4 * f13_x_p5217_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> f13_x_p5231_lanes = s3 * f13_x_p5205_lanes + c3 * f13_x_p5213_lanes;
  const Lanes<2> f13_x_p5235_lanes = s5 * f13_x_p5223_lanes + c5 * f13_x_p5231_lanes;
  const Lanes<2> f13_x_p5243_lanes = c4 * detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]) - s4 *
      f13_x_p5217_lanes;
  const Lanes<2> f13_x_p5247_lanes = s6 * f13_x_p5243_lanes - c6 * f13_x_p5235_lanes;
  const Lanes<2> f13_x_p5255_lanes = c5 * f13_x_p5223_lanes - s5 * f13_x_p5231_lanes;
  const Lanes<2> f13_x_p5259_lanes = detail::make_pack<Real>(c7, c14) * f13_x_p5247_lanes -
      detail::make_pack<Real>(s7, s14) * f13_x_p5255_lanes;
  const Lanes<2> f13_x_p5267_lanes = s6 * f13_x_p5235_lanes + c6 * f13_x_p5243_lanes;
  const Lanes<2> f13_x_p5271_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5267_lanes -
      detail::make_pack<Real>(s8, s15) * f13_x_p5259_lanes;
  const Lanes<2> f13_x_p5279_lanes = detail::make_pack<Real>(s7, s14) * f13_x_p5247_lanes +
      detail::make_pack<Real>(c7, c14) * f13_x_p5255_lanes;
  const Lanes<2> f13_x_p5283_lanes = detail::make_pack<Real>(s9, s16) * f13_x_p5271_lanes +
      detail::make_pack<Real>(c9, c16) * f13_x_p5279_lanes;
  const Lanes<2> f13_x_p5291_lanes = detail::make_pack<Real>(c8, c15) * f13_x_p5259_lanes +
      detail::make_pack<Real>(s8, s15) * f13_x_p5267_lanes;
  const Lanes<2> f13_x_p5295_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5283_lanes +
      detail::make_pack<Real>(s10, s17) * f13_x_p5291_lanes;
  const Lanes<2> f13_x_p5303_lanes = detail::make_pack<Real>(c9, c16) * f13_x_p5271_lanes -
      detail::make_pack<Real>(s9, s16) * f13_x_p5279_lanes;
  const Lanes<2> f13_x_p5307_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5295_lanes +
      detail::make_pack<Real>(s11, s18) * f13_x_p5303_lanes;
  const Lanes<2> f13_x_p5315_lanes = detail::make_pack<Real>(c10, c17) * f13_x_p5291_lanes -
      detail::make_pack<Real>(s10, s17) * f13_x_p5283_lanes;
  const Lanes<2> f13_x_p5319_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5307_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p5315_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_x_lanes = detail::make_pack<Real>(s13, s20) * w12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_w12_y_lanes;
  const Lanes<2> f13_x_p5321_lanes = w13_x_lanes * w13_y_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5325_lanes = 0.086 * (f13_x_p5321_lanes + f13_x_p5319_lanes);
  const Real f13_x_p5327 = f13_x_p5187_lanes[0] - f13_x_p3522_lanes[1] * f13_x_p5179_lanes[0] -
      f13_x_p5325_lanes[0];

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p4_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p10_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5334_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5143_lanes +
      detail::make_pack<Real>(s12, s19) * f13_x_p5151_lanes - a12_x_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5340_lanes = detail::make_pack<Real>(c11, c18) * f13_x_p5303_lanes -
      detail::make_pack<Real>(s11, s18) * f13_x_p5295_lanes;
  const Lanes<2> f13_x_p5348_lanes = detail::make_pack<Real>(c12, c19) * f13_x_p5315_lanes -
      detail::make_pack<Real>(s12, s19) * f13_x_p5307_lanes;
  const Lanes<2> f13_x_p5352_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5340_lanes -
      detail::make_pack<Real>(s13, s20) * f13_x_p5348_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p5354_lanes = w13_x_lanes * w13_z_lanes;

  // link 1 (calf), force propagation
  const Lanes<2> f13_x_p5358_lanes = 0.086 * (f13_x_p5352_lanes - f13_x_p5354_lanes);
  const Real f13_x_p5360 = f13_x_p5334_lanes[0] - f13_x_p3522_lanes[2] * f13_x_p5179_lanes[0] -
      f13_x_p3723_lanes[2] * f13_x_p5327 + f13_x_p5358_lanes[0];

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
  const Lanes<2> f13_x_p5367_lanes = detail::make_pack<Real>(c13, c20) * f13_x_p5348_lanes +
      detail::make_pack<Real>(s13, s20) * f13_x_p5340_lanes - wd13_x_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p5369 = f13_x_p5367_lanes[0] - f13_x_p3522_lanes[3] * f13_x_p5179_lanes[0] -
      f13_x_p3723_lanes[3] * f13_x_p5327 - f13_x_p3922_lanes[3] * f13_x_p5360;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_wd12_y_lanes +
      detail::make_pack<Real>(c13, c20) * wd12_z_lanes - w13_x_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5370_lanes = f13_x_p5352_lanes - wd13_y_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p5372 = f13_x_p5370_lanes[0] - f13_x_p3522_lanes[4] * f13_x_p5179_lanes[0] -
      f13_x_p3723_lanes[4] * f13_x_p5327 - f13_x_p3922_lanes[4] * f13_x_p5360 -
      f13_x_p4133_lanes[4] * f13_x_p5369;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(c12, c19) * wd11_x_lanes -
      detail::make_pack<Real>(s12, s19) * wd11_z_lanes - minus_w12_y_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 13 (left_hand), outward
  const Lanes<2> wd13_z_lanes = wd12_x_lanes + detail::make_pack<Real>(qdd_0[12], qdd_0[19]);

  // link 24 (right_eye), outward
  const Lanes<2> f13_x_p5373_lanes = f13_x_p5319_lanes - wd13_z_lanes;

  // link 1 (calf), force propagation
  const Real f13_x_p5375 = f13_x_p5373_lanes[0] - f13_x_p3522_lanes[5] * f13_x_p5179_lanes[0] -
      f13_x_p3723_lanes[5] * f13_x_p5327 - f13_x_p3922_lanes[5] * f13_x_p5360 -
      f13_x_p4133_lanes[5] * f13_x_p5369;
  const Real f13_x_p5376 = f13_x_p5375 - f13_x_p4351_lanes[5] * f13_x_p5372;
  const Real f13_x_p5377 = f13_x_p5179_lanes[1] - f13_x_p3522_lanes[6] * f13_x_p5179_lanes[0] -
      f13_x_p3723_lanes[6] * f13_x_p5327 - f13_x_p3922_lanes[6] * f13_x_p5360 -
      f13_x_p4133_lanes[6] * f13_x_p5369;
  const Real f13_x_p5378 = f13_x_p5377 - f13_x_p4351_lanes[6] * f13_x_p5372 - f13_x_p4570 *
      f13_x_p5376;
  const Real f13_x_p5379 = f13_x_p5187_lanes[1] - f13_x_p3522_lanes[7] * f13_x_p5179_lanes[0] -
      f13_x_p3723_lanes[7] * f13_x_p5327 - f13_x_p3922_lanes[7] * f13_x_p5360 -
      f13_x_p4133_lanes[7] * f13_x_p5369;
  const Real f13_x_p5380 = f13_x_p5379 - f13_x_p4351_lanes[7] * f13_x_p5372 - f13_x_p4580 *
      f13_x_p5376 - f13_x_p4721 * f13_x_p5378 - f13_x_p5325_lanes[1];
  const Real f13_x_p5381 = f13_x_p5334_lanes[1] - f13_x_p3466_lanes[0] * f13_x_p5179_lanes[0] -
      f13_x_p3659_lanes[0] * f13_x_p5327 - f13_x_p3850_lanes[0] * f13_x_p5360 -
      f13_x_p4053_lanes[0] * f13_x_p5369;
  const Real f13_x_p5382 = f13_x_p5381 - f13_x_p4263_lanes[0] * f13_x_p5372 - f13_x_p4442_lanes[0] *
      f13_x_p5376 - f13_x_p4576_lanes[0] * f13_x_p5378 - f13_x_p4727_lanes[0] * f13_x_p5380;
  const Real f13_x_p5383 = f13_x_p5382 + f13_x_p5358_lanes[1];
  const Real f13_x_p5384 = f13_x_p5367_lanes[1] - f13_x_p3466_lanes[1] * f13_x_p5179_lanes[0] -
      f13_x_p3659_lanes[1] * f13_x_p5327 - f13_x_p3850_lanes[1] * f13_x_p5360 -
      f13_x_p4053_lanes[1] * f13_x_p5369;
  const Real f13_x_p5385 = f13_x_p5384 - f13_x_p4263_lanes[1] * f13_x_p5372 - f13_x_p4442_lanes[1] *
      f13_x_p5376 - f13_x_p4576_lanes[1] * f13_x_p5378 - f13_x_p4727_lanes[1] * f13_x_p5380;
  const Real f13_x_p5386 = f13_x_p5385 - f13_x_p4872_lanes[1] * f13_x_p5383;
  const Real f13_x_p5387 = f13_x_p5370_lanes[1] - f13_x_p3466_lanes[2] * f13_x_p5179_lanes[0] -
      f13_x_p3659_lanes[2] * f13_x_p5327 - f13_x_p3850_lanes[2] * f13_x_p5360 -
      f13_x_p4053_lanes[2] * f13_x_p5369;
  const Real f13_x_p5388 = f13_x_p5387 - f13_x_p4263_lanes[2] * f13_x_p5372 - f13_x_p4442_lanes[2] *
      f13_x_p5376 - f13_x_p4576_lanes[2] * f13_x_p5378 - f13_x_p4727_lanes[2] * f13_x_p5380;
  const Real f13_x_p5389 = f13_x_p5388 - f13_x_p4872_lanes[2] * f13_x_p5383 - f13_x_p5016 *
      f13_x_p5386;
  const Real f13_x_p5390 = f13_x_p5373_lanes[1] - f13_x_p3466_lanes[3] * f13_x_p5179_lanes[0] -
      f13_x_p3659_lanes[3] * f13_x_p5327 - f13_x_p3850_lanes[3] * f13_x_p5360 -
      f13_x_p4053_lanes[3] * f13_x_p5369;
  const Real f13_x_p5391 = f13_x_p5390 - f13_x_p4263_lanes[3] * f13_x_p5372 - f13_x_p4442_lanes[3] *
      f13_x_p5376 - f13_x_p4576_lanes[3] * f13_x_p5378 - f13_x_p4727_lanes[3] * f13_x_p5380;

  // link 3 (hip), force propagation
  const Real f13_x_p5392 = f13_x_p4409_lanes[1] + f13_x_p3231_lanes[3] * f13_x_p2218 +
      f13_x_p3223_lanes[3] * f13_x_p2340_lanes[3] + f13_x_p3215_lanes[3] * f13_x_p2386 +
      f13_x_p3207_lanes[3] * f13_x_p2452_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p5393 = f13_x_p5392 + f13_x_p3199_lanes[3] * f13_x_p2512_lanes[3] +
      f13_x_p2563_lanes[3] * f13_x_p2559_lanes[3] - f13_x_p3466_lanes[3] * f13_x_p3255_lanes[3] -
      f13_x_p3659_lanes[3] * f13_x_p3518_lanes[3];
  const Real f13_x_p5394 = f13_x_p5393 - f13_x_p3850_lanes[3] * f13_x_p3719_lanes[3] -
      f13_x_p4053_lanes[3] * f13_x_p3918_lanes[3] - f13_x_p4263_lanes[3] * f13_x_p4129_lanes[3] -
      f13_x_p4442_lanes[3] * f13_x_p4347_lanes[3];
  const Real f13_x_p5395 = f13_x_p5394 - f13_x_p4576_lanes[3] * f13_x_p4566_lanes[3] -
      f13_x_p4727_lanes[3] * f13_x_p4717_lanes[3] - f13_x_p4872_lanes[3] * f13_x_p4867_lanes[3] -
      f13_x_p4999 * f13_x_p4995_lanes[3];
  const Real f13_x_p5396 = (f13_x_p5391 - f13_x_p4872_lanes[3] * f13_x_p5383 - f13_x_p4999 *
      f13_x_p5386 - f13_x_p5022 * f13_x_p5389) * (1.0 / (f13_x_p5395 - f13_x_p5022 * f13_x_p5015));
  const Real f13_x_p5397 = f13_x_p5389 * f13_x_p5021 - f13_x_p5022 * f13_x_p5396;
  const Real f13_x_p5398 = f13_x_p5386 * f13_x_p4998 - f13_x_p5016 * f13_x_p5397 - f13_x_p4999 *
      f13_x_p5396;
  const Real f13_x_p5399 = f13_x_p5383 * f13_x_p4871 - f13_x_p4872_lanes[1] * f13_x_p5398 -
      f13_x_p4872_lanes[2] * f13_x_p5397 - f13_x_p4872_lanes[3] * f13_x_p5396;
  const Real f13_x_p5400 = f13_x_p5380 * f13_x_p4726 - f13_x_p4727_lanes[0] * f13_x_p5399 -
      f13_x_p4727_lanes[1] * f13_x_p5398 - f13_x_p4727_lanes[2] * f13_x_p5397 -
      f13_x_p4727_lanes[3] * f13_x_p5396;
  const Real f13_x_p5401 = f13_x_p5378 * f13_x_p4575 - f13_x_p4721 * f13_x_p5400 -
      f13_x_p4576_lanes[0] * f13_x_p5399 - f13_x_p4576_lanes[1] * f13_x_p5398 -
      f13_x_p4576_lanes[2] * f13_x_p5397;
  const Real f13_x_p5402 = f13_x_p5401 - f13_x_p4576_lanes[3] * f13_x_p5396;
  const Real f13_x_p5403 = f13_x_p5376 * f13_x_p4441 - f13_x_p4570 * f13_x_p5402 - f13_x_p4580 *
      f13_x_p5400 - f13_x_p4442_lanes[0] * f13_x_p5399 - f13_x_p4442_lanes[1] * f13_x_p5398;
  const Real f13_x_p5404 = f13_x_p5403 - f13_x_p4442_lanes[2] * f13_x_p5397 - f13_x_p4442_lanes[3] *
      f13_x_p5396;
  const Real f13_x_p5405 = f13_x_p5372 * f13_x_p4262 - f13_x_p4351_lanes[5] * f13_x_p5404 -
      f13_x_p4351_lanes[6] * f13_x_p5402 - f13_x_p4351_lanes[7] * f13_x_p5400 -
      f13_x_p4263_lanes[0] * f13_x_p5399;
  const Real f13_x_p5406 = f13_x_p5405 - f13_x_p4263_lanes[1] * f13_x_p5398 - f13_x_p4263_lanes[2] *
      f13_x_p5397 - f13_x_p4263_lanes[3] * f13_x_p5396;
  const Real f13_x_p5407 = f13_x_p5369 * f13_x_p4052 - f13_x_p4133_lanes[4] * f13_x_p5406 -
      f13_x_p4133_lanes[5] * f13_x_p5404 - f13_x_p4133_lanes[6] * f13_x_p5402 -
      f13_x_p4133_lanes[7] * f13_x_p5400;
  const Real f13_x_p5408 = f13_x_p5407 - f13_x_p4053_lanes[0] * f13_x_p5399 - f13_x_p4053_lanes[1] *
      f13_x_p5398 - f13_x_p4053_lanes[2] * f13_x_p5397 - f13_x_p4053_lanes[3] * f13_x_p5396;
  const Real f13_x_p5409 = f13_x_p5360 * f13_x_p3849 - f13_x_p3922_lanes[3] * f13_x_p5408 -
      f13_x_p3922_lanes[4] * f13_x_p5406 - f13_x_p3922_lanes[5] * f13_x_p5404 -
      f13_x_p3922_lanes[6] * f13_x_p5402;
  const Real f13_x_p5410 = f13_x_p5409 - f13_x_p3922_lanes[7] * f13_x_p5400 - f13_x_p3850_lanes[0] *
      f13_x_p5399 - f13_x_p3850_lanes[1] * f13_x_p5398 - f13_x_p3850_lanes[2] * f13_x_p5397;
  const Real f13_x_p5411 = f13_x_p5410 - f13_x_p3850_lanes[3] * f13_x_p5396;
  const Real f13_x_p5412 = f13_x_p5327 * f13_x_p3658 - f13_x_p3723_lanes[2] * f13_x_p5411 -
      f13_x_p3723_lanes[3] * f13_x_p5408 - f13_x_p3723_lanes[4] * f13_x_p5406 -
      f13_x_p3723_lanes[5] * f13_x_p5404;
  const Real f13_x_p5413 = f13_x_p5412 - f13_x_p3723_lanes[6] * f13_x_p5402 - f13_x_p3723_lanes[7] *
      f13_x_p5400 - f13_x_p3659_lanes[0] * f13_x_p5399 - f13_x_p3659_lanes[1] * f13_x_p5398;
  const Real f13_x_p5414 = f13_x_p5413 - f13_x_p3659_lanes[2] * f13_x_p5397 - f13_x_p3659_lanes[3] *
      f13_x_p5396;
  const Real f13_x_p5415 = f13_x_p5179_lanes[0] * f13_x_p3465 - f13_x_p3522_lanes[1] * f13_x_p5414 -
      f13_x_p3522_lanes[2] * f13_x_p5411 - f13_x_p3522_lanes[3] * f13_x_p5408 -
      f13_x_p3522_lanes[4] * f13_x_p5406;
  const Real f13_x_p5416 = f13_x_p5415 - f13_x_p3522_lanes[5] * f13_x_p5404 - f13_x_p3522_lanes[6] *
      f13_x_p5402 - f13_x_p3522_lanes[7] * f13_x_p5400 - f13_x_p3466_lanes[0] * f13_x_p5399;

  // link 13 (left_hand), outward
  const Lanes<2> f13_x_p5417_lanes = f13_x_p5321_lanes - wd13_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_x_p5420_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      f13_x_p5417_lanes - 0.01626499875 * f13_x_p5173_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_x = f13_x_p5420_lanes[0] + (f13_x_p5416 - f13_x_p3466_lanes[1] * f13_x_p5398 -
      f13_x_p3466_lanes[2] * f13_x_p5397 - f13_x_p3466_lanes[3] * f13_x_p5396);

  // link 13 (left_hand), outward
  const Lanes<2> f13_y_p1_lanes = f13_x_p5321_lanes + wd13_z_lanes;
  const Lanes<2> f13_y_p3_lanes = w13_x_lanes * w13_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_y_p6_lanes = 0.01626499875 * f13_y_p1_lanes -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      (f13_y_p3_lanes + f13_x_p5171_lanes);

  // link 24 (right_eye), inertial wrench
  const Real f13_y = f13_y_p6_lanes[0] + f13_x_p5414;

  // link 12 (left_wrist2), outward
  const Lanes<2> f12_y_p1_lanes = w12_x_lanes * minus_w12_y_lanes;
  const Lanes<2> f12_y_p5_lanes = w12_z_lanes * w12_z_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_y_p8_lanes = 0.0025100003499999995 * (wd12_z_lanes - f12_y_p1_lanes) -
      0.0006000000000000001 * (w12_x_lanes * w12_x_lanes + f12_y_p5_lanes);

  // link 13 (left_hand), inward
  const Real f12_y = f12_y_p8_lanes[0] + (c13 * f13_x - s13 * f13_y);

  // link 13 (left_hand), outward
  const Lanes<2> f13_z_p1_lanes = f13_x_p5354_lanes - wd13_y_lanes;
  const Lanes<2> f13_z_p3_lanes = w13_y_lanes * w13_z_lanes;
  const Lanes<2> f13_z_p4_lanes = f13_z_p3_lanes + wd13_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_p6_lanes = 0.01626499875 * f13_z_p1_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * f13_z_p4_lanes;

  // link 24 (right_eye), inertial wrench
  const Real f13_z = f13_z_p6_lanes[0] + f13_x_p5411;

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
      4.38600177048965e-05) * (f13_x_p5171_lanes - f13_x_p5169_lanes);
  const Lanes<2> n13_x_p9_lanes = 9.149209276993575e-05 * f13_z_p4_lanes +
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p1_lanes -
      0.000108260010923775 * f13_y_p1_lanes + n13_x_p8_lanes;
  const Lanes<2> n13_x_p10_lanes = n13_x_p9_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * a12_x_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n13_x = n13_x_p10_lanes[0] + f13_x_p5408;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_y_p8_lanes = 0.000108260010923775 * (f13_y_p3_lanes - f13_x_p5171_lanes);
  const Lanes<2> n13_y_p9_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * f13_x_p5417_lanes - 0.000847139515629375 * f13_z_p1_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * f13_z_p4_lanes +
      n13_y_p8_lanes;
  const Lanes<2> n13_y_p10_lanes = n13_y_p9_lanes - 0.01626499875 * a12_x_lanes;

  // link 24 (right_eye), inertial wrench
  const Real n13_y = n13_y_p10_lanes[0] + f13_x_p5406;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_y_p5_lanes = 0.0025100003499999995 * minus_a12_z_lanes -
      (0.000195227662257343 * f12_z_p2_lanes + detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * f12_x_p4_lanes);

  // link 13 (left_hand), inward
  const Real n12_y = n12_y_p5_lanes[0] + (c13 * n13_x - s13 * n13_y);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p9_lanes = 0.0007556474228594393 * f13_x_p5321_lanes +
      0.0009386316083993107 * wd13_z_lanes + 0.000108260010923775 * (f13_z_p3_lanes - wd13_x_lanes);
  const Lanes<2> n13_z_p15_lanes = n13_z_p9_lanes -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      (f13_x_p5354_lanes + wd13_y_lanes) + detail::make_pack<Real>((-0.0001263900573325125),
      0.0001263900573325125) * (f13_x_p5169_lanes - f13_y_p3_lanes);
  const Lanes<2> n13_z_p16_lanes = n13_z_p15_lanes +
      (0.01626499875 * a13_y_lanes + detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      minus_a13_x_lanes);

  // link 24 (right_eye), inertial wrench
  const Real n13_z = n13_z_p16_lanes[0] + f13_x_p5404;
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
  const Real f20_x = f13_x_p5420_lanes[1] + f13_x_p5402;
  const Real f20_y = f13_y_p6_lanes[1] + f13_x_p5400;

  // link 20 (right_hand), inward
  const Real f19_y = f12_y_p8_lanes[1] + (c20 * f20_x - s20 * f20_y);

  // link 24 (right_eye), inertial wrench
  const Real f20_z = f13_z_p6_lanes[1] + f13_x_p5399;

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
  const Real n20_x = n13_x_p10_lanes[1] + f13_x_p5398;
  const Real n20_y = n13_y_p10_lanes[1] + f13_x_p5397;

  // link 20 (right_hand), inward
  const Real n19_y = n12_y_p5_lanes[1] + (c20 * n20_x - s20 * n20_y);

  // link 24 (right_eye), inertial wrench
  const Real n20_z = n13_z_p16_lanes[1] + f13_x_p5396;
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
