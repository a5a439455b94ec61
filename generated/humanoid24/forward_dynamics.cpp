// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By articulated bodies, Chang table 4.2, alike limbs in lanes.
// 4826 flops (add 2289, mul 2505, div 32), sine and cosine of 24 angles
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
  const Real angles[24] = {q[23], q[22], q[21], q[20], q[13], q[19], q[18], q[17], q[16], q[15],
      q[14], q[6], q[12], q[11], q[10], q[9], q[8], q[7], q[5], q[4], q[3], q[2], q[1], q[0]};
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
  const Real c14 = cosines[4];
  const Real s20 = sines[5];
  const Real c20 = cosines[5];
  const Real s19 = sines[6];
  const Real c19 = cosines[6];
  const Real s18 = sines[7];
  const Real c18 = cosines[7];
  const Real c17 = cosines[8];
  const Real s17 = sines[8];
  const Real c16 = cosines[9];
  const Real s16 = sines[9];
  const Real s15 = sines[10];
  const Real c15 = cosines[10];
  const Real s14 = sines[4];
  const Real c7 = cosines[11];
  const Real s13 = sines[12];
  const Real c13 = cosines[12];
  const Real s12 = sines[13];
  const Real c12 = cosines[13];
  const Real s11 = sines[14];
  const Real c11 = cosines[14];
  const Real c10 = cosines[15];
  const Real s10 = sines[15];
  const Real c9 = cosines[16];
  const Real s9 = sines[16];
  const Real s8 = sines[17];
  const Real c8 = cosines[17];
  const Real s7 = sines[11];
  const Real s6 = sines[18];
  const Real c6 = cosines[18];
  const Real s5 = sines[19];
  const Real c5 = cosines[19];
  const Real s4 = sines[20];
  const Real c4 = cosines[20];
  const Real s3 = sines[21];
  const Real c3 = cosines[21];
  const Real s2 = sines[22];
  const Real c2 = cosines[22];
  const Real c1 = cosines[23];
  const Real s1 = sines[23];

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D1_p5_lanes = detail::make_pack<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.001742099791326752, 0.001742099791326752) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D1_p7_lanes = detail::make_pack<Real>(c13, c20) * inverse_D1_p5_lanes;
  const Lanes<2> inverse_D1_p9_lanes = 0.0006340258712020409 + inverse_D1_p7_lanes;
  const Lanes<2> inverse_D12_p3_lanes = detail::make_pack<Real>((-0.0007660844555829042),
      (-0.0007660844555829042)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.0002628975791811551, (-0.0002628975791811551)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p4_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p3_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (inverse_D12_p4_lanes -
      detail::make_pack<Real>((-0.0010519177038056625), (-0.0010519177038056625)));
  const Lanes<2> inverse_D1_p11_lanes = inverse_D1_p9_lanes * inverse_D12_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D1_p15_lanes = detail::make_pack<Real>((-0.00013384878959057754),
      0.00013384878959057754) + detail::make_pack<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D1_p19_lanes = detail::make_pack<Real>(s13, s20) * inverse_D1_p5_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p23_lanes = detail::make_pack<Real>((-0.00033044389597753786),
      0.00033044389597753786) + inverse_D1_p19_lanes + inverse_D1_p15_lanes * inverse_D1_p11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D1_p33_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(s13, s20) - 0.01626499875 * detail::make_pack<Real>(c13, c20) -
      0.0006000000000000001;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p35_lanes = inverse_D1_p33_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D1_p45_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(c13, c20) + 0.01626499875 * detail::make_pack<Real>(s13, s20) -
      inverse_D1_p15_lanes * inverse_D1_p35_lanes;
  const Lanes<2> inverse_D1_p49_lanes = detail::make_pack<Real>(s12, s19) * inverse_D1_p23_lanes +
      detail::make_pack<Real>(c12, c19) * inverse_D1_p45_lanes;
  const Lanes<2> inverse_D1_p51_lanes = detail::make_pack<Real>(c12, c19) * inverse_D1_p49_lanes;
  const Lanes<2> inverse_D1_p53_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      inverse_D1_p51_lanes;
  const Lanes<2> inverse_D11_p1_lanes = inverse_D1_p15_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D11_p4_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes -
      inverse_D1_p15_lanes * inverse_D11_p1_lanes;
  const Lanes<2> inverse_D11_p6_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p4_lanes);
  const Lanes<2> inverse_D11_p7_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p6_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p4_lanes + inverse_D11_p7_lanes));
  const Lanes<2> inverse_D1_p55_lanes = inverse_D1_p53_lanes * inverse_D11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D1_p59_lanes = inverse_D1_p19_lanes -
      detail::make_pack<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p61_lanes = inverse_D1_p59_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D1_p67_lanes = inverse_D1_p7_lanes -
      detail::make_pack<Real>(0.002376125662528793, 0.002376125662528793) - inverse_D1_p15_lanes *
      inverse_D1_p61_lanes;
  const Lanes<2> inverse_D1_p73_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * inverse_D1_p67_lanes;
  const Lanes<2> inverse_D1_p79_lanes = 0.000144 - (detail::make_pack<Real>(c12, c19) *
      inverse_D11_p6_lanes + 0.269 * inverse_D1_p73_lanes);
  const Lanes<2> inverse_D1_p83_lanes = detail::make_pack<Real>(s12, s19) * inverse_D1_p49_lanes;
  const Lanes<2> inverse_D1_p85_lanes = inverse_D1_p33_lanes * inverse_D1_p61_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D1_p95_lanes = detail::make_pack<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.27310176737964387), (-0.27310176737964387)) *
      detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p101_lanes = detail::make_pack<Real>(c13, c20) * inverse_D1_p95_lanes -
      detail::make_pack<Real>((-0.04964593582762564), 0.04964593582762564) - inverse_D1_p9_lanes *
      inverse_D1_p61_lanes;
  const Lanes<2> inverse_D1_p105_lanes = detail::make_pack<Real>(c12, c19) * inverse_D1_p85_lanes +
      detail::make_pack<Real>(s12, s19) * inverse_D1_p101_lanes;
  const Lanes<2> inverse_D1_p107_lanes = 0.269 * inverse_D1_p105_lanes;
  const Lanes<2> inverse_D1_p109_lanes = inverse_D1_p83_lanes + inverse_D1_p107_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p111_lanes = inverse_D1_p79_lanes * inverse_D1_p55_lanes -
      inverse_D1_p109_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p115_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      inverse_D1_p51_lanes;
  const Lanes<2> inverse_D1_p117_lanes = 6e-04 - inverse_D1_p73_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p119_lanes = inverse_D1_p117_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D1_p123_lanes = inverse_D1_p107_lanes - inverse_D1_p115_lanes *
      inverse_D1_p119_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D1_p133_lanes = detail::make_pack<Real>(s13, s20) * inverse_D1_p95_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p137_lanes = detail::make_pack<Real>(0.008744893195371809,
      0.008744893195371809) + inverse_D1_p133_lanes + inverse_D1_p9_lanes * inverse_D1_p11_lanes;
  const Lanes<2> inverse_D1_p139_lanes = inverse_D1_p33_lanes * inverse_D1_p35_lanes;
  const Lanes<2> inverse_D1_p145_lanes = inverse_D1_p33_lanes * inverse_D1_p11_lanes;
  const Lanes<2> inverse_D1_p151_lanes = detail::make_pack<Real>(c12, c19) *
      (2.0 * inverse_D1_p145_lanes) - detail::make_pack<Real>(s12, s19) *
      (inverse_D1_p137_lanes - inverse_D1_p139_lanes);
  const Lanes<2> inverse_D1_p153_lanes = detail::make_pack<Real>(s12, s19) * inverse_D1_p151_lanes;
  const Lanes<2> inverse_D1_p155_lanes = inverse_D1_p153_lanes - inverse_D1_p139_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p159_lanes = inverse_D1_p115_lanes * inverse_D1_p55_lanes - 0.269 *
      inverse_D1_p155_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p167_lanes = inverse_D1_p133_lanes - 0.2818466605750157 -
      inverse_D1_p59_lanes * inverse_D1_p61_lanes;
  const Lanes<2> inverse_D1_p175_lanes = detail::make_pack<Real>(s12, s19) * inverse_D1_p67_lanes -
      0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> inverse_D1_p177_lanes = 0.269 * inverse_D1_p167_lanes - inverse_D1_p175_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p179_lanes = inverse_D1_p177_lanes - inverse_D1_p79_lanes *
      inverse_D1_p119_lanes;
  const Lanes<2> inverse_D1_p185_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D1_p111_lanes - inverse_D1_p123_lanes) + detail::make_pack<Real>(c11, c18) *
      (inverse_D1_p159_lanes + inverse_D1_p179_lanes);
  const Lanes<2> inverse_D1_p187_lanes = detail::make_pack<Real>(s11, s18) * inverse_D1_p185_lanes;
  const Lanes<2> inverse_D1_p189_lanes = inverse_D1_p123_lanes + inverse_D1_p187_lanes;
  const Lanes<2> inverse_D10_p1_lanes = inverse_D1_p79_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p7_lanes = 0.000131 - inverse_D11_p7_lanes + 0.269 *
      (inverse_D1_p177_lanes - inverse_D1_p175_lanes) - inverse_D1_p79_lanes * inverse_D10_p1_lanes;
  const Lanes<2> inverse_D10_p8_lanes = inverse_D1_p115_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p12_lanes = 0.0001098 + 0.07236100000000001 * inverse_D1_p155_lanes -
      inverse_D1_p115_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p18_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      inverse_D1_p109_lanes - inverse_D1_p79_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p19_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> inverse_D10_p21_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p7_lanes - inverse_D10_p12_lanes) + inverse_D10_p19_lanes *
      inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p22_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p21_lanes;
  const Lanes<2> inverse_D10_p24_lanes = 0.060888541114265754 +
      (inverse_D10_p12_lanes + inverse_D10_p22_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p24_lanes;
  const Lanes<2> inverse_D1_p191_lanes = inverse_D1_p189_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D1_p195_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * inverse_D1_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p203_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p21_lanes -
      inverse_D10_p18_lanes);
  const Lanes<2> inverse_D1_p207_lanes = detail::make_pack<Real>(c11, c18) * inverse_D1_p185_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p213_lanes = 0.28049749700000004 +
      (inverse_D1_p207_lanes - inverse_D1_p159_lanes) - inverse_D1_p203_lanes *
      inverse_D1_p191_lanes;
  const Lanes<2> inverse_D1_p217_lanes = detail::make_pack<Real>(c10, c17) * inverse_D1_p195_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D1_p213_lanes;
  const Lanes<2> inverse_D1_p221_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p24_lanes;
  const Lanes<2> inverse_D1_p225_lanes = 0.0001499998887063 + inverse_D1_p203_lanes *
      inverse_D1_p221_lanes;
  const Lanes<2> inverse_D1_p227_lanes = 2.0 * detail::make_pack<Real>(c10, c17);
  const Lanes<2> inverse_D1_p231_lanes = inverse_D1_p203_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D1_p239_lanes = 0.06060754126741261 +
      (inverse_D10_p7_lanes - inverse_D10_p22_lanes) - inverse_D1_p203_lanes *
      inverse_D1_p231_lanes;
  const Lanes<2> inverse_D1_p243_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p24_lanes;
  const Lanes<2> inverse_D1_p249_lanes = inverse_D1_p227_lanes * inverse_D1_p225_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D1_p239_lanes - inverse_D1_p243_lanes);
  const Lanes<2> inverse_D1_p257_lanes = 0.282 * inverse_D1_p217_lanes -
      (inverse_D1_p225_lanes - detail::make_pack<Real>(c10, c17) * inverse_D1_p249_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D9_p1_lanes = detail::make_pack<Real>(s10, s17) * inverse_D1_p249_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (inverse_D1_p243_lanes - inverse_D9_p1_lanes));
  const Lanes<2> inverse_D1_p259_lanes = inverse_D1_p257_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D1_p261_lanes = inverse_D1_p257_lanes * inverse_D1_p259_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p267_lanes = detail::make_pack<Real>(c10, c17) * inverse_D1_p213_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D1_p195_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p273_lanes = inverse_D1_p155_lanes - inverse_D1_p53_lanes *
      inverse_D1_p55_lanes;
  const Lanes<2> inverse_D1_p277_lanes = inverse_D1_p167_lanes - inverse_D1_p117_lanes *
      inverse_D1_p119_lanes;
  const Lanes<2> inverse_D1_p285_lanes = inverse_D1_p53_lanes * inverse_D1_p119_lanes -
      inverse_D1_p105_lanes;
  const Lanes<2> inverse_D1_p289_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D1_p273_lanes - inverse_D1_p277_lanes) + inverse_D10_p19_lanes *
      inverse_D1_p285_lanes;
  const Lanes<2> inverse_D1_p291_lanes = detail::make_pack<Real>(s11, s18) * inverse_D1_p289_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p295_lanes = inverse_D1_p277_lanes + inverse_D1_p291_lanes -
      inverse_D1_p189_lanes * inverse_D1_p191_lanes;
  const Lanes<2> inverse_D1_p299_lanes = inverse_D1_p267_lanes + 0.282 * inverse_D1_p295_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p311_lanes = 0.0019585440854647937 +
      (inverse_D1_p239_lanes + inverse_D9_p1_lanes + 0.282 *
      (inverse_D1_p267_lanes + inverse_D1_p299_lanes)) - inverse_D1_p261_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p315_lanes = inverse_D1_p207_lanes - inverse_D1_p179_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p317_lanes = inverse_D1_p315_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D1_p319_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D1_p317_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p325_lanes = detail::make_pack<Real>(s12, s19) * inverse_D1_p85_lanes -
      detail::make_pack<Real>(c12, c19) * inverse_D1_p101_lanes;
  const Lanes<2> inverse_D1_p335_lanes = inverse_D1_p83_lanes - inverse_D1_p23_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p337_lanes = inverse_D1_p335_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D1_p341_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      (0.269 * inverse_D1_p325_lanes - (inverse_D1_p51_lanes - inverse_D1_p45_lanes)) -
      inverse_D1_p79_lanes * inverse_D1_p337_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D1_p349_lanes = inverse_D1_p145_lanes - detail::make_pack<Real>(c12, c19) *
      inverse_D1_p151_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p355_lanes = 0.269 * inverse_D1_p349_lanes - 6e-04 -
      inverse_D1_p115_lanes * inverse_D1_p337_lanes;
  const Lanes<2> inverse_D1_p361_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * inverse_D1_p341_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D1_p355_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p363_lanes = inverse_D1_p361_lanes * inverse_D10_lanes;
  const Lanes<2> inverse_D1_p373_lanes = detail::make_pack<Real>(c11, c18) * inverse_D1_p341_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D1_p355_lanes + inverse_D1_p203_lanes *
      inverse_D1_p363_lanes;
  const Lanes<2> inverse_D1_p383_lanes = inverse_D1_p111_lanes - inverse_D1_p187_lanes -
      inverse_D1_p203_lanes * inverse_D1_p317_lanes;
  const Lanes<2> inverse_D1_p385_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * inverse_D1_p363_lanes;
  const Lanes<2> inverse_D1_p391_lanes = detail::make_pack<Real>(c10, c17) *
      (inverse_D1_p319_lanes + inverse_D1_p373_lanes) - detail::make_pack<Real>(s10, s17) *
      (inverse_D1_p383_lanes + inverse_D1_p385_lanes);
  const Lanes<2> inverse_D1_p393_lanes = detail::make_pack<Real>(c10, c17) * inverse_D1_p391_lanes;
  const Lanes<2> inverse_D1_p395_lanes = inverse_D1_p373_lanes - inverse_D1_p393_lanes;
  const Lanes<2> inverse_D1_p399_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * inverse_D1_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p401_lanes = inverse_D1_p399_lanes * inverse_D9_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D1_p409_lanes = inverse_D1_p53_lanes * inverse_D1_p337_lanes -
      inverse_D1_p349_lanes;
  const Lanes<2> inverse_D1_p415_lanes = inverse_D1_p325_lanes - inverse_D1_p117_lanes *
      inverse_D1_p337_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p421_lanes = detail::make_pack<Real>(c11, c18) * inverse_D1_p409_lanes -
      detail::make_pack<Real>(s11, s18) * inverse_D1_p415_lanes + inverse_D1_p315_lanes *
      inverse_D1_p363_lanes;
  const Lanes<2> inverse_D1_p429_lanes = inverse_D1_p273_lanes - inverse_D1_p291_lanes -
      inverse_D1_p315_lanes * inverse_D1_p317_lanes;
  const Lanes<2> inverse_D1_p439_lanes = inverse_D1_p137_lanes + inverse_D1_p153_lanes +
      inverse_D1_p335_lanes * inverse_D1_p337_lanes + inverse_D1_p361_lanes * inverse_D1_p363_lanes;
  const Lanes<2> inverse_D1_p445_lanes = inverse_D1_p227_lanes * inverse_D1_p421_lanes -
      detail::make_pack<Real>(s10, s17) * (inverse_D1_p429_lanes + inverse_D1_p439_lanes);
  const Lanes<2> inverse_D1_p447_lanes = detail::make_pack<Real>(s10, s17) * inverse_D1_p445_lanes;
  const Lanes<2> inverse_D1_p449_lanes = inverse_D1_p429_lanes + inverse_D1_p447_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p455_lanes = 0.0008177492704690715 + 0.07952399999999998 *
      inverse_D1_p449_lanes - inverse_D1_p399_lanes * inverse_D1_p401_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p463_lanes = detail::make_pack<Real>(s10, s17) * inverse_D1_p391_lanes;
  const Lanes<2> inverse_D1_p473_lanes = detail::make_pack<Real>(c11, c18) * inverse_D1_p289_lanes -
      inverse_D1_p285_lanes - inverse_D1_p315_lanes * inverse_D1_p191_lanes;
  const Lanes<2> inverse_D1_p485_lanes = detail::make_pack<Real>(s11, s18) * inverse_D1_p409_lanes +
      detail::make_pack<Real>(c11, c18) * inverse_D1_p415_lanes + inverse_D1_p361_lanes *
      inverse_D1_p191_lanes;
  const Lanes<2> inverse_D1_p489_lanes = detail::make_pack<Real>(c10, c17) * inverse_D1_p473_lanes +
      detail::make_pack<Real>(s10, s17) * inverse_D1_p485_lanes;
  const Lanes<2> inverse_D1_p491_lanes = 0.282 * inverse_D1_p489_lanes;
  const Lanes<2> inverse_D1_p493_lanes = inverse_D1_p383_lanes + inverse_D1_p463_lanes +
      inverse_D1_p491_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p499_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * inverse_D1_p493_lanes - inverse_D1_p257_lanes *
      inverse_D1_p401_lanes;
  const Lanes<2> inverse_D1_p501_lanes = 2.0 * detail::make_pack<Real>(s9, s16);
  const Lanes<2> inverse_D1_p505_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D1_p311_lanes - inverse_D1_p455_lanes) - inverse_D1_p501_lanes *
      inverse_D1_p499_lanes;
  const Lanes<2> inverse_D1_p511_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * inverse_D1_p505_lanes + inverse_D1_p499_lanes);
  const Lanes<2> inverse_D8_p1_lanes = detail::make_pack<Real>(c9, c16) * inverse_D1_p505_lanes;
  const Lanes<2> inverse_D8_p3_lanes = 0.18125194219699997 +
      (inverse_D1_p455_lanes + inverse_D8_p1_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p3_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p513_lanes = inverse_D1_p385_lanes + inverse_D1_p463_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p515_lanes = inverse_D1_p513_lanes * inverse_D9_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p523_lanes = detail::make_pack<Real>(c10, c17) * inverse_D1_p485_lanes -
      detail::make_pack<Real>(s10, s17) * inverse_D1_p473_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p533_lanes = detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) + (0.282 * inverse_D1_p523_lanes -
      (inverse_D1_p319_lanes - inverse_D1_p393_lanes)) + inverse_D1_p257_lanes *
      inverse_D1_p515_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p541_lanes = inverse_D1_p421_lanes - detail::make_pack<Real>(c10, c17) *
      inverse_D1_p445_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p547_lanes = 0.0022500062 + 0.282 * inverse_D1_p541_lanes +
      inverse_D1_p399_lanes * inverse_D1_p515_lanes;
  const Lanes<2> inverse_D1_p553_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * inverse_D1_p533_lanes -
      detail::make_pack<Real>(s9, s16) * inverse_D1_p547_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p555_lanes = inverse_D1_p553_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D1_p565_lanes = inverse_D1_p511_lanes * inverse_D1_p555_lanes -
      (detail::make_pack<Real>(s9, s16) * inverse_D1_p533_lanes + detail::make_pack<Real>(c9, c16) *
      inverse_D1_p547_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p567_lanes = detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) + inverse_D1_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p569_lanes = inverse_D1_p567_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D1_p573_lanes = inverse_D1_p493_lanes + inverse_D1_p257_lanes *
      inverse_D1_p569_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D1_p575_lanes = inverse_D1_p217_lanes - 0.0022500062;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p577_lanes = inverse_D1_p575_lanes * inverse_D9_lanes;
  const Lanes<2> inverse_D1_p581_lanes = inverse_D1_p491_lanes + inverse_D1_p399_lanes *
      inverse_D1_p577_lanes;
  const Lanes<2> inverse_D1_p589_lanes = inverse_D1_p299_lanes - inverse_D1_p257_lanes *
      inverse_D1_p577_lanes;
  const Lanes<2> inverse_D1_p595_lanes = inverse_D1_p399_lanes * inverse_D1_p569_lanes - 0.282 *
      inverse_D1_p449_lanes;
  const Lanes<2> inverse_D1_p601_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D1_p573_lanes + inverse_D1_p581_lanes) - detail::make_pack<Real>(s9, s16) *
      (inverse_D1_p595_lanes + inverse_D1_p589_lanes);
  const Lanes<2> inverse_D1_p603_lanes = detail::make_pack<Real>(s9, s16) * inverse_D1_p601_lanes;
  const Lanes<2> inverse_D1_p607_lanes = 0.7139200499999999 +
      (inverse_D1_p603_lanes + inverse_D1_p589_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p609_lanes = inverse_D1_p607_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D1_p611_lanes = 0.00010499999999999999 * inverse_D1_p609_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p619_lanes = detail::make_pack<Real>(c9, c16) * inverse_D1_p601_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p623_lanes = inverse_D1_p573_lanes - inverse_D1_p619_lanes -
      inverse_D1_p511_lanes * inverse_D1_p609_lanes;
  const Lanes<2> inverse_D1_p625_lanes = 0.00010499999999999999 * inverse_D1_p555_lanes;
  const Lanes<2> inverse_D1_p631_lanes = detail::make_pack<Real>(c8, c15) *
      (inverse_D1_p565_lanes + inverse_D1_p611_lanes) - detail::make_pack<Real>(s8, s15) *
      (inverse_D1_p625_lanes + inverse_D1_p623_lanes);
  const Lanes<2> inverse_D1_p633_lanes = detail::make_pack<Real>(c8, c15) * inverse_D1_p631_lanes;
  const Lanes<2> inverse_D1_p637_lanes = 0.0017499999999999998 +
      (inverse_D1_p633_lanes - inverse_D1_p611_lanes);
  const Lanes<2> inverse_D7_p1_lanes = inverse_D1_p511_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p5_lanes = 0.18113119219699997 +
      (inverse_D1_p311_lanes - inverse_D8_p1_lanes) - inverse_D1_p511_lanes * inverse_D7_p1_lanes;
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
  const Lanes<2> inverse_D1_p639_lanes = inverse_D1_p637_lanes * inverse_D7_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p645_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p14_lanes -
      inverse_D7_p11_lanes);
  const Lanes<2> inverse_D1_p649_lanes = detail::make_pack<Real>(s8, s15) * inverse_D1_p631_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D1_p653_lanes = inverse_D1_p625_lanes + inverse_D1_p649_lanes +
      inverse_D1_p645_lanes * inverse_D1_p639_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p655_lanes = inverse_D1_p619_lanes - inverse_D1_p581_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p657_lanes = inverse_D1_p655_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D1_p661_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * inverse_D1_p657_lanes;
  const Lanes<2> inverse_D1_p671_lanes = inverse_D1_p603_lanes + inverse_D1_p595_lanes -
      0.7139200499999999 - inverse_D1_p511_lanes * inverse_D1_p657_lanes;
  const Lanes<2> inverse_D1_p677_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * inverse_D1_p661_lanes + detail::make_pack<Real>(c8, c15) *
      inverse_D1_p671_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D1_p679_lanes = inverse_D1_p677_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D1_p681_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D1_p679_lanes;
  const Lanes<2> inverse_D1_p695_lanes = detail::make_pack<Real>(c8, c15) * inverse_D1_p661_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D1_p671_lanes - inverse_D1_p645_lanes *
      inverse_D1_p679_lanes;
  const Lanes<2> inverse_D1_p697_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D1_p639_lanes;
  const Lanes<2> inverse_D1_p703_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D1_p653_lanes - inverse_D1_p681_lanes) - detail::make_pack<Real>(s7, s14) *
      (inverse_D1_p695_lanes - inverse_D1_p697_lanes);
  const Lanes<2> inverse_D1_p705_lanes = detail::make_pack<Real>(s7, s14) * inverse_D1_p703_lanes;
  const Lanes<2> inverse_D1_p707_lanes = inverse_D1_p697_lanes - inverse_D1_p705_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p715_lanes = inverse_D1_p449_lanes - inverse_D1_p567_lanes *
      inverse_D1_p569_lanes;
  const Lanes<2> inverse_D1_p719_lanes = inverse_D1_p295_lanes - inverse_D1_p575_lanes *
      inverse_D1_p577_lanes;
  const Lanes<2> inverse_D1_p727_lanes = inverse_D1_p489_lanes + inverse_D1_p567_lanes *
      inverse_D1_p577_lanes;
  const Lanes<2> inverse_D1_p731_lanes = detail::make_pack<Real>(c9, c16) *
      (inverse_D1_p715_lanes - inverse_D1_p719_lanes) - inverse_D1_p501_lanes *
      inverse_D1_p727_lanes;
  const Lanes<2> inverse_D1_p733_lanes = detail::make_pack<Real>(c9, c16) * inverse_D1_p731_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D1_p739_lanes = inverse_D1_p719_lanes + inverse_D1_p733_lanes -
      inverse_D1_p655_lanes * inverse_D1_p657_lanes - inverse_D1_p677_lanes * inverse_D1_p679_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D1_p747_lanes = inverse_D1_p541_lanes + inverse_D1_p567_lanes *
      inverse_D1_p515_lanes;
  const Lanes<2> inverse_D1_p753_lanes = inverse_D1_p523_lanes + inverse_D1_p575_lanes *
      inverse_D1_p515_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p759_lanes = detail::make_pack<Real>(s9, s16) * inverse_D1_p747_lanes -
      detail::make_pack<Real>(c9, c16) * inverse_D1_p753_lanes + inverse_D1_p553_lanes *
      inverse_D1_p609_lanes;
  const Lanes<2> inverse_D1_p767_lanes = inverse_D1_p715_lanes - inverse_D1_p733_lanes -
      inverse_D1_p607_lanes * inverse_D1_p609_lanes;
  const Lanes<2> inverse_D1_p777_lanes = inverse_D1_p439_lanes + inverse_D1_p447_lanes +
      inverse_D1_p513_lanes * inverse_D1_p515_lanes + inverse_D1_p553_lanes * inverse_D1_p555_lanes;
  const Lanes<2> inverse_D1_p783_lanes = inverse_D7_p12_lanes * inverse_D1_p759_lanes -
      detail::make_pack<Real>(s8, s15) * (inverse_D1_p777_lanes + inverse_D1_p767_lanes);
  const Lanes<2> inverse_D1_p785_lanes = detail::make_pack<Real>(s8, s15) * inverse_D1_p783_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D1_p789_lanes = inverse_D1_p777_lanes + inverse_D1_p785_lanes +
      inverse_D1_p637_lanes * inverse_D1_p639_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p805_lanes = detail::make_pack<Real>(c9, c16) * inverse_D1_p747_lanes +
      detail::make_pack<Real>(s9, s16) * inverse_D1_p753_lanes + inverse_D1_p553_lanes *
      inverse_D1_p657_lanes;
  const Lanes<2> inverse_D1_p815_lanes = detail::make_pack<Real>(s9, s16) * inverse_D1_p731_lanes +
      inverse_D1_p727_lanes - inverse_D1_p607_lanes * inverse_D1_p657_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D1_p821_lanes = detail::make_pack<Real>(c8, c15) * inverse_D1_p805_lanes -
      detail::make_pack<Real>(s8, s15) * inverse_D1_p815_lanes - inverse_D1_p677_lanes *
      inverse_D1_p639_lanes;
  const Lanes<2> inverse_D1_p823_lanes = 2.0 * detail::make_pack<Real>(s7, s14);
  const Lanes<2> inverse_D1_p827_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D1_p739_lanes + inverse_D1_p789_lanes) - inverse_D1_p823_lanes *
      inverse_D1_p821_lanes;
  const Lanes<2> inverse_D1_p829_lanes = detail::make_pack<Real>(c7, c14) * inverse_D1_p827_lanes;
  const Lanes<2> inverse_D1_p831_lanes = inverse_D1_p739_lanes - inverse_D1_p829_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D1_p835_lanes = inverse_D1_p623_lanes + inverse_D1_p649_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D1_p837_lanes = inverse_D1_p835_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D1_p847_lanes = detail::make_pack<Real>(s8, s15) * inverse_D1_p805_lanes +
      detail::make_pack<Real>(c8, c15) * inverse_D1_p815_lanes - inverse_D1_p677_lanes *
      inverse_D1_p837_lanes;
  const Lanes<2> inverse_D1_p857_lanes = detail::make_pack<Real>(c8, c15) * inverse_D1_p783_lanes -
      inverse_D1_p759_lanes - inverse_D1_p637_lanes * inverse_D1_p837_lanes;
  const Lanes<2> inverse_D1_p861_lanes = detail::make_pack<Real>(s7, s14) * inverse_D1_p847_lanes +
      detail::make_pack<Real>(c7, c14) * inverse_D1_p857_lanes;
  const Lanes<2> inverse_D1_p867_lanes = inverse_D1_p707_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D1_p831_lanes + 0.226 *
      inverse_D1_p861_lanes);

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D1_p869_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> inverse_D1_p871_lanes = detail::make_pack<Real>(c23, c24) * inverse_D1_p869_lanes;
  const Lanes<2> inverse_D1_p873_lanes = inverse_D1_p871_lanes - 0.0007770270270270272;
  const Real inverse_D1_p875 = 0.431222972972973 + inverse_D1_p871_lanes[1] +
      inverse_D1_p873_lanes[0];
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> inverse_D22_p3_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Real inverse_D22_p5 = inverse_D22_p3_lanes[1] + inverse_D22_p3_lanes[0];
  const Real inverse_D22_p6 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p5 + 4.75e-05 * inverse_D22_p6);
  const Real inverse_D1_p876 = inverse_D1_p875 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D1_p879_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);
  const Real inverse_D1_p881 = s24 + s23;
  const Real inverse_D1_p882 = inverse_D1_p879_lanes[0] + 2.375e-05 * inverse_D1_p881 +
      inverse_D1_p879_lanes[1];
  const Lanes<2> inverse_D1_p883_lanes = detail::make_pack<Real>(s23, s24) * inverse_D1_p869_lanes;
  const Real inverse_D1_p885 = inverse_D1_p883_lanes[1] + inverse_D1_p883_lanes[0];

  // link 22 (head), articulated inertia
  const Real inverse_D1_p886 = inverse_D1_p882 * inverse_D1_p876 - inverse_D1_p885;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D1_p887_lanes = detail::make_pack<Real>(0.032, (-0.032)) *
      inverse_D1_p873_lanes;
  const Real inverse_D1_p889 = inverse_D1_p887_lanes[1] + inverse_D1_p887_lanes[0] - 0.095 *
      inverse_D1_p885;
  const Real inverse_D1_p890 = 0.072575 + 0.00025 * inverse_D22_p6;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p891 = inverse_D1_p890 * inverse_D22;
  const Real inverse_D1_p892 = inverse_D1_p889 * inverse_D1_p891;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D1_p893_lanes = 0.006756756756756757 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> inverse_D1_p895_lanes = detail::make_pack<Real>(c23, c24) * inverse_D1_p893_lanes;
  const Lanes<2> inverse_D1_p899_lanes = detail::make_pack<Real>(s23, s24) * inverse_D1_p893_lanes;
  const Lanes<2> inverse_D1_p903_lanes = 0.095 * inverse_D1_p895_lanes +
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D1_p899_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p905 = inverse_D1_p903_lanes[1] + inverse_D1_p903_lanes[0] +
      inverse_D1_p889 * inverse_D1_p876;
  const Real inverse_D1_p906 = inverse_D1_p882 * inverse_D1_p891 - 0.00025 * inverse_D1_p881;
  const Real inverse_D1_p907 = s22 * (inverse_D1_p886 + inverse_D1_p892) + c22 *
      (inverse_D1_p906 - inverse_D1_p905);
  const Real inverse_D1_p908 = s22 * inverse_D1_p907;
  const Real inverse_D1_p909 = inverse_D1_p908 - inverse_D1_p892;
  const Real inverse_D21_p1 = inverse_D1_p889 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p2_lanes = inverse_D1_p899_lanes - 0.006756756756756757;
  const Lanes<2> inverse_D21_p8_lanes = 0.095 * inverse_D21_p2_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * inverse_D1_p895_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p10 = inverse_D21_p8_lanes[1] + inverse_D21_p8_lanes[0];
  const Real inverse_D21_p11 = 0.009438624999999999 - (-0.032) * inverse_D1_p903_lanes[1] - 0.032 *
      inverse_D1_p903_lanes[0] - inverse_D1_p889 * inverse_D21_p1 + 0.095 * inverse_D21_p10;
  const Real inverse_D21_p12 = inverse_D1_p882 * inverse_D22;
  const Real inverse_D21_p13 = 0.05450270000000001 + inverse_D22_p5 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - inverse_D1_p882 * inverse_D21_p12 - 0.00017071621621621625;
  const Real inverse_D21_p14 = inverse_D1_p871_lanes[1] + inverse_D1_p871_lanes[0];
  const Real inverse_D21_p15 = 0.0074 - (-0.032) * inverse_D1_p883_lanes[1] - 0.032 *
      inverse_D1_p883_lanes[0] + inverse_D1_p882 * inverse_D21_p1 - 0.095 * inverse_D21_p14;
  const Real inverse_D21_p16 = 2.0 * c22;
  const Real inverse_D21_p17 = s22 * (inverse_D21_p13 - inverse_D21_p11) + inverse_D21_p16 *
      inverse_D21_p15;
  const Real inverse_D21_p18 = s22 * inverse_D21_p17;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p11 + inverse_D21_p18));
  const Real inverse_D1_p910 = inverse_D1_p909 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p911 = inverse_D1_p885 * inverse_D22;
  const Real inverse_D1_p912 = 0.072575 + inverse_D21_p10 + inverse_D1_p889 * inverse_D1_p911;
  const Real inverse_D1_p913 = inverse_D21_p14 - 0.43200000000000005 + inverse_D1_p882 *
      inverse_D1_p911;
  const Real inverse_D1_p914 = c22 * inverse_D1_p912 - s22 * inverse_D1_p913;
  const Real inverse_D1_p915 = 0.0016155 + (c22 * inverse_D21_p17 - inverse_D21_p15 + 0.394 *
      inverse_D1_p914);
  const Real inverse_D1_p916 = c22 * inverse_D1_p907;
  const Real inverse_D1_p917 = inverse_D1_p890 * inverse_D1_p911;
  const Real inverse_D1_p918 = inverse_D1_p895_lanes[1] + inverse_D1_p895_lanes[0] -
      inverse_D1_p875 * inverse_D1_p911;
  const Real inverse_D1_p919 = c22 * inverse_D1_p917 - s22 * inverse_D1_p918;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p920 = inverse_D1_p915 * inverse_D1_p910 -
      (inverse_D1_p916 + inverse_D1_p905 + 0.394 * inverse_D1_p919);

  // link 22 (head), articulated inertia
  const Real inverse_D1_p921 = inverse_D1_p916 - inverse_D1_p906;
  const Real inverse_D1_p922 = 0.394 * inverse_D1_p921;
  const Real inverse_D1_p923 = inverse_D1_p875 * inverse_D1_p891;
  const Real inverse_D1_p924 = inverse_D1_p899_lanes[1] + inverse_D1_p899_lanes[0] +
      inverse_D1_p875 * inverse_D1_p876;
  const Real inverse_D1_p925 = inverse_D1_p890 * inverse_D1_p891;
  const Real inverse_D1_p926 = inverse_D21_p16 * inverse_D1_p923 - s22 *
      (inverse_D1_p925 - inverse_D1_p924);
  const Real inverse_D1_p927 = inverse_D1_p923 - c22 * inverse_D1_p926;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p928 = inverse_D1_p922 * inverse_D1_p910 -
      (0.0045000000000000005 + 0.394 * inverse_D1_p927);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p929 = c21 * inverse_D1_p920 - s21 * inverse_D1_p928 +
      inverse_D1_p867_lanes[1] + inverse_D1_p867_lanes[0];
  const Lanes<2> inverse_D6_p3_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D1_p707_lanes + inverse_D1_p867_lanes);
  const Lanes<2> inverse_D6_p5_lanes = inverse_D1_p645_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p13_lanes = 0.0002975 + (inverse_D7_p7_lanes - inverse_D7_p15_lanes) -
      inverse_D1_p645_lanes * inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p15_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p17_lanes;
  const Lanes<2> inverse_D6_p17_lanes = 0.0001505 - inverse_D6_p15_lanes;
  const Lanes<2> inverse_D6_p25_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p29_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p17_lanes - inverse_D6_p13_lanes) + inverse_D1_p823_lanes * inverse_D6_p25_lanes;
  const Lanes<2> inverse_D6_p31_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p29_lanes;
  const Real inverse_D6_p33 = inverse_D6_p31_lanes[1] + inverse_D6_p31_lanes[0];

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p34 = inverse_D1_p915 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p35 = c22 * inverse_D1_p913 + s22 * inverse_D1_p912;
  const Real inverse_D6_p36 = inverse_D21_p2_lanes[1] + inverse_D21_p2_lanes[0] - inverse_D1_p885 *
      inverse_D1_p911;
  const Real inverse_D6_p37 = inverse_D6_p35 - 0.394 * inverse_D6_p36;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p38 = 0.005513625 + (inverse_D21_p13 - inverse_D21_p18 - 0.394 *
      (inverse_D6_p35 + inverse_D6_p37)) - inverse_D1_p915 * inverse_D6_p34;
  const Real inverse_D6_p39 = inverse_D1_p922 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p40 = s22 * inverse_D1_p926;
  const Real inverse_D6_p41 = inverse_D6_p40 - inverse_D1_p924;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p42 = 0.000703125 + 0.155236 * inverse_D6_p41 - inverse_D1_p922 *
      inverse_D6_p39;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p43 = c22 * inverse_D1_p918 + s22 * inverse_D1_p917;
  const Real inverse_D6_p44 = 0.394 * inverse_D6_p43;
  const Real inverse_D6_p45 = inverse_D1_p886 - inverse_D1_p908 - inverse_D6_p44;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p46 = 0.394 * inverse_D6_p45 - inverse_D1_p915 * inverse_D6_p39;
  const Real inverse_D6_p47 = 2.0 * s21;
  const Real inverse_D6_p48 = c21 * (inverse_D6_p38 - inverse_D6_p42) - inverse_D6_p47 *
      inverse_D6_p46;
  const Real inverse_D6_p49 = c21 * inverse_D6_p48;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p52_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D1_p837_lanes;
  const Lanes<2> inverse_D6_p62_lanes = inverse_D1_p633_lanes - inverse_D1_p565_lanes -
      0.0017499999999999998 - inverse_D1_p645_lanes * inverse_D1_p837_lanes;
  const Lanes<2> inverse_D6_p66_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p52_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p62_lanes;
  const Lanes<2> inverse_D6_p74_lanes = inverse_D1_p767_lanes + inverse_D1_p785_lanes -
      inverse_D1_p835_lanes * inverse_D1_p837_lanes;
  const Lanes<2> inverse_D6_p80_lanes = inverse_D6_p66_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * inverse_D1_p861_lanes + 0.226 *
      inverse_D6_p74_lanes);
  const Real inverse_D6_p82 = inverse_D6_p80_lanes[1] + inverse_D6_p80_lanes[0];
  const Real inverse_D6_p83 = 2.06965463592404 + inverse_D6_p42 + inverse_D6_p49 +
      inverse_D6_p13_lanes[1] + inverse_D6_p33 + inverse_D6_p3_lanes[1] + inverse_D6_p13_lanes[0] +
      inverse_D6_p3_lanes[0] + 0.226 * (inverse_D6_p66_lanes[1] + inverse_D6_p82 +
      inverse_D6_p66_lanes[0]);

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p83;
  const Real inverse_D1_p930 = inverse_D1_p929 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D1_p931_lanes = detail::make_pack<Real>(c7, c14) * inverse_D1_p703_lanes;
  const Lanes<2> inverse_D1_p937_lanes = detail::make_pack<Real>(s7, s14) * inverse_D1_p827_lanes +
      inverse_D1_p821_lanes;
  const Lanes<2> inverse_D1_p939_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      inverse_D1_p937_lanes;
  const Lanes<2> inverse_D1_p945_lanes = detail::make_pack<Real>(c7, c14) * inverse_D1_p847_lanes -
      detail::make_pack<Real>(s7, s14) * inverse_D1_p857_lanes;
  const Lanes<2> inverse_D1_p947_lanes = 0.226 * inverse_D1_p945_lanes;
  const Lanes<2> inverse_D1_p951_lanes = inverse_D1_p931_lanes - inverse_D1_p653_lanes -
      (inverse_D1_p939_lanes + inverse_D1_p947_lanes);
  const Lanes<2> inverse_D1_p953_lanes = inverse_D1_p681_lanes + inverse_D1_p931_lanes;
  const Lanes<2> inverse_D1_p957_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D1_p951_lanes + inverse_D1_p953_lanes);
  const Lanes<2> inverse_D1_p959_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p29_lanes;
  const Lanes<2> inverse_D1_p965_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p52_lanes -
      detail::make_pack<Real>(c7, c14) * inverse_D6_p62_lanes;
  const Real inverse_D1_p967 = inverse_D1_p965_lanes[1] + inverse_D1_p965_lanes[0];
  const Real inverse_D1_p968 = 0.0187369177636143 + inverse_D1_p957_lanes[1] -
      inverse_D6_p25_lanes[1] + inverse_D1_p959_lanes[1] + inverse_D1_p957_lanes[0] -
      inverse_D6_p25_lanes[0] + inverse_D1_p959_lanes[0] + 0.226 * inverse_D1_p967;
  const Lanes<2> inverse_D1_p969_lanes = inverse_D1_p939_lanes - inverse_D1_p953_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p971 = inverse_D1_p969_lanes[1] + inverse_D1_p969_lanes[0] +
      inverse_D1_p968 * inverse_D1_p930;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p972 = inverse_D1_p951_lanes[1] + inverse_D1_p951_lanes[0];
  const Real inverse_D1_p973 = s21 * inverse_D6_p48 + inverse_D6_p46 + 0.226 * inverse_D1_p972;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p974 = inverse_D1_p921 * inverse_D21;
  const Real inverse_D1_p975 = inverse_D6_p45 - inverse_D1_p915 * inverse_D1_p974;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p976 = 0.0045000000000000005 + inverse_D1_p914;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p977 = inverse_D1_p976 * inverse_D21;
  const Real inverse_D1_p978 = inverse_D6_p44 + inverse_D1_p922 * inverse_D1_p977;
  const Real inverse_D1_p979 = 0.394 * inverse_D6_p41 - inverse_D1_p922 * inverse_D1_p974;
  const Real inverse_D1_p980 = inverse_D6_p37 + inverse_D1_p915 * inverse_D1_p977;
  const Real inverse_D1_p981 = c21 * (inverse_D1_p975 - inverse_D1_p978) - s21 *
      (inverse_D1_p979 + inverse_D1_p980);
  const Real inverse_D1_p982 = s21 * inverse_D1_p981;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p983 = inverse_D1_p982 + inverse_D1_p980 - 6.1665928899999995 -
      inverse_D6_p82;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p984 = inverse_D1_p983 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p985 = c21 * inverse_D1_p981;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p986 = inverse_D1_p975 - inverse_D1_p985 + inverse_D1_p947_lanes[1] +
      inverse_D1_p947_lanes[0] - inverse_D1_p973 * inverse_D1_p984;
  const Real inverse_D1_p987 = inverse_D1_p937_lanes[1] + inverse_D1_p937_lanes[0];
  const Real inverse_D1_p988 = inverse_D1_p973 * inverse_D1_p930 -
      (s21 * inverse_D1_p920 + c21 * inverse_D1_p928) + 0.226 * inverse_D1_p987;
  const Real inverse_D1_p989 = (-0.18) * inverse_D1_p945_lanes[1] - inverse_D1_p967 + 0.18 *
      inverse_D1_p945_lanes[0] - inverse_D1_p968 * inverse_D1_p984;
  const Real inverse_D1_p990 = s6 * (inverse_D1_p971 - inverse_D1_p986) + c6 *
      (inverse_D1_p988 + inverse_D1_p989);
  const Real inverse_D1_p991 = s6 * inverse_D1_p990;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p992 = inverse_D1_p978 + inverse_D1_p985 + inverse_D1_p972;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p993 = inverse_D1_p992 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p994 = inverse_D1_p921 * inverse_D1_p910 - inverse_D1_p927;
  const Real inverse_D1_p995 = inverse_D1_p919 - inverse_D1_p976 * inverse_D1_p910;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p996 = inverse_D1_p987 - c21 * inverse_D1_p994 + s21 * inverse_D1_p995 +
      inverse_D1_p929 * inverse_D1_p993;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p997 = inverse_D6_p41 - inverse_D1_p921 * inverse_D1_p974;
  const Real inverse_D1_p998 = inverse_D6_p36 - inverse_D1_p976 * inverse_D1_p977;
  const Real inverse_D1_p999 = inverse_D6_p43 + inverse_D1_p921 * inverse_D1_p977;
  const Real inverse_D1_p1000 = c21 * (inverse_D1_p997 - inverse_D1_p998) - inverse_D6_p47 *
      inverse_D1_p999;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p1001 = s21 * inverse_D1_p1000 + inverse_D1_p999 +
      inverse_D1_p945_lanes[1] + inverse_D1_p945_lanes[0] - inverse_D1_p983 * inverse_D1_p993;
  const Real inverse_D1_p1002 = s6 * inverse_D1_p996 + c6 * inverse_D1_p1001;
  const Real inverse_D1_p1003 = 0.072 * inverse_D1_p1002;
  const Real inverse_D1_p1004 = inverse_D1_p986 + inverse_D1_p991 + inverse_D1_p1003;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p1_lanes = inverse_D1_p705_lanes + inverse_D1_p695_lanes;
  const Lanes<2> inverse_D5_p3_lanes = inverse_D1_p829_lanes - inverse_D1_p789_lanes;
  const Lanes<2> inverse_D5_p7_lanes = inverse_D5_p1_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p3_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p9 = inverse_D5_p7_lanes[1] + inverse_D5_p7_lanes[0] - inverse_D1_p968 *
      inverse_D1_p993;
  const Real inverse_D5_p10 = inverse_D5_p3_lanes[1] + inverse_D5_p3_lanes[0];
  const Real inverse_D5_p11 = 6.1665928899999995 + inverse_D1_p982 + inverse_D1_p979 -
      inverse_D1_p973 * inverse_D1_p993 + 0.226 * inverse_D5_p10;
  const Real inverse_D5_p12 = s6 * inverse_D5_p9 + c6 * inverse_D5_p11;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p13 = c21 * inverse_D1_p1000;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p14 = inverse_D1_p998 + inverse_D5_p13 + inverse_D5_p10 - inverse_D1_p992 *
      inverse_D1_p993;
  const Real inverse_D5_p15 = inverse_D5_p12 + 0.072 * inverse_D5_p14;
  const Real inverse_D5_p16 = inverse_D1_p968 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p19_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p1_lanes + inverse_D5_p7_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p21 = 0.40056549999999996 - inverse_D6_p15_lanes[1] - inverse_D6_p33 +
      inverse_D5_p19_lanes[1] + inverse_D6_p17_lanes[0] + inverse_D5_p19_lanes[0] -
      inverse_D1_p968 * inverse_D5_p16;
  const Real inverse_D5_p22 = inverse_D1_p973 * inverse_D6;
  const Real inverse_D5_p23 = 1.66923963592404 + inverse_D6_p38 - inverse_D6_p49 - inverse_D1_p973 *
      inverse_D5_p22 + 0.051076 * inverse_D5_p10;
  const Real inverse_D5_p24 = (-0.04068) * inverse_D5_p3_lanes[1] + 0.04068 *
      inverse_D5_p3_lanes[0] - inverse_D1_p968 * inverse_D5_p22 + 0.226 *
      (inverse_D5_p1_lanes[1] + inverse_D5_p1_lanes[0]);
  const Real inverse_D5_p25 = 2.0 * c6;
  const Real inverse_D5_p26 = s6 * (inverse_D5_p21 - inverse_D5_p23) + inverse_D5_p25 *
      inverse_D5_p24;
  const Real inverse_D5_p27 = s6 * inverse_D5_p26;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p23 + inverse_D5_p27 + 0.072 * (inverse_D5_p12 + inverse_D5_p15)));
  const Real inverse_D1_p1005 = inverse_D1_p1004 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p1006 = 0.072 * inverse_D1_p1004;
  const Real inverse_D1_p1007 = inverse_D1_p831_lanes[1] -
      (inverse_D1_p925 + inverse_D6_p40 + inverse_D1_p909 * inverse_D1_p910) +
      inverse_D1_p831_lanes[0] - inverse_D1_p929 * inverse_D1_p930;
  const Real inverse_D1_p1008 = inverse_D1_p997 - inverse_D5_p13 + inverse_D6_p74_lanes[1] +
      inverse_D6_p74_lanes[0] - inverse_D1_p983 * inverse_D1_p984;
  const Real inverse_D1_p1009 = inverse_D1_p861_lanes[1] -
      (s21 * inverse_D1_p994 + c21 * inverse_D1_p995) + inverse_D1_p861_lanes[0] + inverse_D1_p929 *
      inverse_D1_p984;
  const Real inverse_D1_p1010 = s6 * (inverse_D1_p1007 - inverse_D1_p1008) + inverse_D5_p25 *
      inverse_D1_p1009;
  const Real inverse_D1_p1011 = s6 * inverse_D1_p1010;
  const Real inverse_D1_p1012 = inverse_D1_p1008 + inverse_D1_p1011;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1013 = inverse_D1_p1006 * inverse_D1_p1005 -
      (2.2194301519999997 + 0.072 * inverse_D1_p1012);

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p1014 = c6 * inverse_D5_p9 - s6 * inverse_D5_p11;
  const Real inverse_D1_p1015 = c6 * inverse_D5_p26 - inverse_D5_p24 + 0.072 * inverse_D1_p1014;
  const Real inverse_D1_p1016 = c6 * inverse_D1_p990;
  const Real inverse_D1_p1017 = inverse_D1_p1016 - inverse_D1_p988;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1018 = inverse_D1_p1017 - 0.069699984375 - inverse_D1_p1015 *
      inverse_D1_p1005;
  const Real inverse_D1_p1019 = s5 * inverse_D1_p1013 + c5 * inverse_D1_p1018;
  const Real inverse_D1_p1020 = inverse_D1_p1006 * inverse_D5;
  const Real inverse_D1_p1021 = 0.15637308509675518 + 0.005183999999999999 * inverse_D1_p1012 -
      inverse_D1_p1006 * inverse_D1_p1020;
  const Real inverse_D1_p1022 = inverse_D1_p1015 * inverse_D5;
  const Real inverse_D1_p1023 = 0.04675382692737882 + (inverse_D5_p21 - inverse_D5_p27) -
      inverse_D1_p1015 * inverse_D1_p1022;
  const Real inverse_D1_p1024 = 0.005678398088837119 - 0.072 * inverse_D1_p1017 + inverse_D1_p1006 *
      inverse_D1_p1022;
  const Real inverse_D1_p1025 = 2.0 * c5;
  const Real inverse_D1_p1026 = s5 * (inverse_D1_p1021 - inverse_D1_p1023) + inverse_D1_p1025 *
      inverse_D1_p1024;
  const Real inverse_D1_p1027 = 0.005880002159562879 +
      (0.21799999999999997 * inverse_D1_p1019 - (c5 * inverse_D1_p1026 - inverse_D1_p1024));

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p1028 = 2.2194301519999997 + inverse_D5_p15;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1029 = inverse_D1_p1028 * inverse_D5;
  const Real inverse_D1_p1030 = inverse_D1_p1006 * inverse_D1_p1029 - inverse_D1_p1003;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p1031 = c6 * inverse_D1_p996 - s6 * inverse_D1_p1001;
  const Real inverse_D1_p1032 = 0.069699984375 + (inverse_D1_p1016 - inverse_D1_p989 + 0.072 *
      inverse_D1_p1031);

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1033 = inverse_D1_p1032 * inverse_D5;
  const Real inverse_D1_p1034 = inverse_D1_p971 - inverse_D1_p991 - inverse_D1_p1015 *
      inverse_D1_p1033;
  const Real inverse_D1_p1035 = inverse_D1_p1014 - inverse_D1_p1015 * inverse_D1_p1029;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p1036 = c6 * inverse_D1_p1010 - inverse_D1_p1009;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1037 = inverse_D1_p1006 * inverse_D1_p1033 - 0.072 * inverse_D1_p1036;
  const Real inverse_D1_p1038 = s5 * (inverse_D1_p1030 - inverse_D1_p1034) + c5 *
      (inverse_D1_p1035 + inverse_D1_p1037);
  const Real inverse_D1_p1039 = c5 * inverse_D1_p1038;
  const Real inverse_D1_p1040 = inverse_D1_p1039 - inverse_D1_p1037;
  const Real inverse_D4_p1 = s5 * inverse_D1_p1026;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D1_p1023 + inverse_D4_p1));
  const Real inverse_D1_p1041 = inverse_D1_p1040 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1042 = s5 * inverse_D1_p1038;
  const Real inverse_D1_p1043 = inverse_D1_p1036 - inverse_D1_p1032 * inverse_D1_p1005;
  const Real inverse_D1_p1044 = inverse_D1_p1002 - inverse_D1_p1028 * inverse_D1_p1005;
  const Real inverse_D1_p1045 = s5 * inverse_D1_p1043 - c5 * inverse_D1_p1044;
  const Real inverse_D1_p1046 = 0.21799999999999997 * inverse_D1_p1045;
  const Real inverse_D1_p1047 = inverse_D1_p1030 - inverse_D1_p1042 + inverse_D1_p1046;
  const Real inverse_D1_p1048 = 0.21799999999999997 * inverse_D1_p1040;
  const Real inverse_D1_p1049 = 0.0300000063 + inverse_D1_p1019;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p1050 = inverse_D1_p1049 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1051 = inverse_D1_p1007 - inverse_D1_p1011 - inverse_D1_p1032 *
      inverse_D1_p1033;
  const Real inverse_D1_p1052 = inverse_D5_p14 - inverse_D1_p1028 * inverse_D1_p1029;
  const Real inverse_D1_p1053 = inverse_D1_p1031 - inverse_D1_p1028 * inverse_D1_p1033;
  const Real inverse_D1_p1054 = s5 * (inverse_D1_p1052 - inverse_D1_p1051) + inverse_D1_p1025 *
      inverse_D1_p1053;
  const Real inverse_D1_p1055 = s5 * inverse_D1_p1054;
  const Real inverse_D1_p1056 = inverse_D1_p1052 - inverse_D1_p1055;
  const Real inverse_D1_p1057 = s5 * inverse_D1_p1018 - c5 * inverse_D1_p1013;
  const Real inverse_D1_p1058 = inverse_D1_p1012 - inverse_D1_p1004 * inverse_D1_p1005;
  const Real inverse_D1_p1059 = inverse_D1_p1057 + 0.21799999999999997 * inverse_D1_p1058;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p1060 = inverse_D1_p1027 * inverse_D1_p1050 - inverse_D1_p1059;
  const Real inverse_D1_p1061 = s4 * (inverse_D1_p1047 + inverse_D1_p1027 * inverse_D1_p1041 +
      (inverse_D1_p1046 + inverse_D1_p1048 * inverse_D1_p1050)) + c4 *
      (0.21799999999999997 * inverse_D1_p1056 - inverse_D1_p1048 * inverse_D1_p1041 +
      inverse_D1_p1060);
  const Real inverse_D1_p1062 = 8.419374554 + (c4 * inverse_D1_p1061 - inverse_D1_p1060);
  const Real inverse_D3_p1 = inverse_D1_p1027 * inverse_D4;
  const Real inverse_D3_p2 = inverse_D1_p1048 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * inverse_D1_p1056 -
      inverse_D1_p1048 * inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (inverse_D1_p1021 - inverse_D4_p1 + 0.21799999999999997 *
      (inverse_D1_p1057 + inverse_D1_p1059)) - inverse_D1_p1027 * inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * inverse_D1_p1047 + inverse_D1_p1027 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real inverse_D1_p1063 = inverse_D1_p1062 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p1064 = inverse_D1_p1056 - inverse_D1_p1040 * inverse_D1_p1041;
  const Real inverse_D1_p1065 = s4 * (inverse_D1_p1064 -
      (inverse_D1_p1058 - inverse_D1_p1049 * inverse_D1_p1050)) - inverse_D3_p5 *
      (inverse_D1_p1045 + inverse_D1_p1040 * inverse_D1_p1050);

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1066 = inverse_D1_p1064 - s4 * inverse_D1_p1065 - inverse_D1_p1062 *
      inverse_D1_p1063;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1067 = inverse_D1_p1034 + inverse_D1_p1042;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p1068 = inverse_D1_p1067 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p1069 = s5 * inverse_D1_p1044 + c5 * inverse_D1_p1043;
  const Real inverse_D1_p1070 = c5 * inverse_D1_p1054 - inverse_D1_p1053;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p1071 = s4 * (0.21799999999999997 * inverse_D1_p1069 -
      (inverse_D1_p1039 - inverse_D1_p1035) - inverse_D1_p1027 * inverse_D1_p1068) + c4 *
      (0.0300000063 - 0.21799999999999997 * inverse_D1_p1070 + inverse_D1_p1048 * inverse_D1_p1068);
  const Real inverse_D1_p1072 = 0.02999999505 + inverse_D1_p1071;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1073 = inverse_D1_p1072 * inverse_D3;
  const Real inverse_D1_p1074 = inverse_D1_p1051 + inverse_D1_p1055 - inverse_D1_p1067 *
      inverse_D1_p1068 - inverse_D1_p1072 * inverse_D1_p1073;
  const Real inverse_D1_p1075 = inverse_D1_p1062 * inverse_D1_p1073 -
      (c4 * (inverse_D1_p1040 * inverse_D1_p1068 - inverse_D1_p1070) - s4 *
      (inverse_D1_p1049 * inverse_D1_p1068 - inverse_D1_p1069));
  const Real inverse_D1_p1076 = s3 * (inverse_D1_p1066 - inverse_D1_p1074) + c3 *
      (2.0 * inverse_D1_p1075);
  const Real inverse_D1_p1077 = s3 * inverse_D1_p1076;
  const Real inverse_D1_p1078 = inverse_D1_p1066 - inverse_D1_p1077;
  const Real inverse_D1_p1079 = 24.5839218 + 0.422 * inverse_D1_p1078;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * inverse_D1_p1078);
  const Real inverse_D1_p1080 = inverse_D1_p1079 * inverse_D2;
  const Real inverse_D1_p1081 = inverse_D1_p1078 - inverse_D1_p1079 * inverse_D1_p1080;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p1082 = c3 * inverse_D1_p1076 - inverse_D1_p1075;
  const Real inverse_D1_p1083 = 0.031999971599999996 + 0.422 * inverse_D1_p1082;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1084 = inverse_D1_p1083 * inverse_D2;
  const Real inverse_D1_p1085 = s2 * (inverse_D1_p1081 -
      (inverse_D1_p1074 + inverse_D1_p1077 - inverse_D1_p1083 * inverse_D1_p1084)) + c2 *
      (2.0 * (inverse_D1_p1082 - inverse_D1_p1079 * inverse_D1_p1084));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1081 - s2 * inverse_D1_p1085));

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real a2_y = s2 * minus_a1_x + c2 * a2_y_p1;
  const Real w2_z = qd[0] + qd[1];
  const Real a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real a3_y_p2 = a2_y + 0.422 * a3_y_p1;

  // link 2 (thigh), outward
  const Real a2_x = s2 * a2_y_p1 - c2 * minus_a1_x;

  // link 3 (hip), outward
  const Real a3_y = c3 * a3_y_p2 - s3 * a2_x;
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real a5_y_p1 = w4_x * w4_x;
  const Real w4_y = c4 * w3_z;
  const Real a5_y_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * (a5_y_p1 + a5_y_p2);

  // link 3 (hip), outward
  const Real a3_x = c3 * a2_x + s3 * a3_y_p2;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p3 - s5 * a4_x;
  const Real w5_x = c5 * w4_x - s5 * qd[3];
  const Real a6_x_p1 = w5_x * w5_x;
  const Real w5_z = w4_y + qd[4];
  const Real a6_x_p2 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;
  const Real a6_x_p4 = a5_y + 0.072 * a6_x_p3;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];

  // link 4 (chest1), outward
  const Real wd4_x = w4_y * qd[3];

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd4_x - minus_w5_y * qd[4];
  const Real a6_x_p5 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p6 = minus_a4_y + 0.072 * a6_x_p5;
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
  const Real a7_x_p5 = a7_x_p4 - wd5_x;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_p7_lanes = a7_x_p3 + detail::make_pack<Real>(0.18, (-0.18)) * a7_x_p5;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a4_x + s5 * a5_y_p3;
  const Real a6_z_p1 = w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real minus_wd4_y = w4_x * qd[3];

  // link 5 (chest2), outward
  const Real a6_z_p2 = minus_wd4_y - a6_z_p1;

  // link 6 (chest3), outward
  const Real a6_z = a5_x - 0.072 * a6_z_p2;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + w5_x * qd[4];

  // link 6 (chest3), outward
  const Real wd6_y = s6 * minus_wd5_y - c6 * minus_wd4_y - w6_x * qd[5];
  const Real a7_x_p9 = w6_x * w6_z - wd6_y;

  // link 14 (right_shoulder1), outward
  const Real a7_x_p10 = a6_z - 0.226 * a7_x_p9;

  // link 6 (chest3), outward
  const Real a7_x_p11 = w6_y * w6_z;
  const Real wd6_x = w6_y * qd[5] - (c6 * minus_wd5_y + s6 * minus_wd4_y);
  const Real a7_x_p12 = a7_x_p11 + wd6_x;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_x_p14_lanes = a7_x_p10 + detail::make_pack<Real>(0.18, (-0.18)) * a7_x_p12;
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_x_p7_lanes +
      detail::make_pack<Real>(c7, c14) * a7_x_p14_lanes;
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_x_p7_lanes -
      detail::make_pack<Real>(s7, s14) * a7_x_p14_lanes;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p4 + c6 * a6_x_p6;
  const Real minus_a7_z_p1 = a7_x_p4 + wd5_x;

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
      detail::make_pack<Real>(s7, s14) * wd5_x - w7_x_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;
  const Lanes<2> wd8_y_lanes = detail::make_pack<Real>(c8, c15) * wd6_y -
      detail::make_pack<Real>(s8, s15) * wd7_y_lanes - w8_x_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_x_lanes = detail::make_pack<Real>(s7, s14) * wd6_x +
      detail::make_pack<Real>(c7, c14) * wd5_x + w7_y_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;
  const Lanes<2> wd9_y_lanes = detail::make_pack<Real>(c9, c16) * wd8_y_lanes -
      detail::make_pack<Real>(s9, s16) * wd7_x_lanes - w9_x_lanes *
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
      detail::make_pack<Real>(c9, c16) * wd7_x_lanes + w9_y_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> minus_a10_z_p1_lanes = w9_y_lanes * w9_z_lanes;
  const Lanes<2> minus_a10_z_p2_lanes = minus_a10_z_p1_lanes - wd9_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * minus_a10_z_p2_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_lanes = detail::make_pack<Real>(c8, c15) * wd7_y_lanes +
      detail::make_pack<Real>(s8, s15) * wd6_y + w8_y_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;
  const Lanes<2> wd10_x_lanes = detail::make_pack<Real>(c10, c17) * wd9_x_lanes +
      detail::make_pack<Real>(s10, s17) * wd8_x_lanes - minus_w10_y_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;
  const Lanes<2> wd11_y_lanes = detail::make_pack<Real>(c11, c18) * wd9_y_lanes -
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
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p4_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p10_lanes;
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;
  const Lanes<2> n12_z_p5_lanes = w12_x_lanes * minus_w12_y_lanes;
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> n12_z_p8_lanes = w12_x_lanes * w12_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_x_lanes = detail::make_pack<Real>(c11, c18) * wd10_x_lanes +
      detail::make_pack<Real>(s11, s18) * wd9_y_lanes + w11_y_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_lanes = detail::make_pack<Real>(c10, c17) * wd8_x_lanes -
      detail::make_pack<Real>(s10, s17) * wd9_x_lanes - w10_x_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_y_lanes = detail::make_pack<Real>(c12, c19) * wd10_y_lanes -
      detail::make_pack<Real>(s12, s19) * wd11_x_lanes - w12_x_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p11_lanes = 0.00020682766225734302 * wd11_y_lanes - 0.000183627662257343 *
      n12_z_p5_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (n12_z_p8_lanes + wd12_y_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> w13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_w12_y_lanes +
      detail::make_pack<Real>(c13, c20) * w12_z_lanes;
  const Lanes<2> wd13_x_lanes = detail::make_pack<Real>(c13, c20) * wd12_y_lanes +
      detail::make_pack<Real>(s13, s20) * wd11_y_lanes + w13_y_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> n13_x_p2_lanes = w13_y_lanes * w13_z_lanes;
  const Lanes<2> n13_x_p3_lanes = n13_x_p2_lanes + wd13_x_lanes;
  const Lanes<2> w13_x_lanes = detail::make_pack<Real>(s13, s20) * w12_z_lanes -
      detail::make_pack<Real>(c13, c20) * minus_w12_y_lanes;
  const Lanes<2> wd13_y_lanes = detail::make_pack<Real>(c13, c20) * wd11_y_lanes -
      detail::make_pack<Real>(s13, s20) * wd12_y_lanes - w13_x_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> n13_x_p5_lanes = w13_x_lanes * w13_z_lanes;
  const Lanes<2> n13_x_p6_lanes = n13_x_p5_lanes - wd13_y_lanes;
  const Lanes<2> n13_x_p9_lanes = w13_x_lanes * w13_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(c12, c19) * wd11_x_lanes +
      detail::make_pack<Real>(s12, s19) * wd10_y_lanes - minus_w12_y_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 13 (left_hand), outward
  const Lanes<2> n13_x_p10_lanes = n13_x_p9_lanes + wd12_x_lanes;
  const Lanes<2> n13_x_p13_lanes = w13_y_lanes * w13_y_lanes;
  const Lanes<2> n13_x_p14_lanes = w13_z_lanes * w13_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p16_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * (n13_x_p14_lanes - n13_x_p13_lanes);
  const Lanes<2> n13_x_p17_lanes = 9.149209276993575e-05 * n13_x_p3_lanes +
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * n13_x_p6_lanes -
      0.000108260010923775 * n13_x_p10_lanes + n13_x_p16_lanes;
  const Lanes<2> n13_x_lanes = n13_x_p17_lanes + detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * a12_x_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> n13_y_p2_lanes = n13_x_p9_lanes - wd12_x_lanes;
  const Lanes<2> n13_y_p8_lanes = w13_x_lanes * w13_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_y_p10_lanes = 0.000108260010923775 * (n13_y_p8_lanes - n13_x_p14_lanes);
  const Lanes<2> n13_y_p11_lanes = detail::make_pack<Real>((-4.38600177048965e-05),
      4.38600177048965e-05) * n13_y_p2_lanes - 0.000847139515629375 * n13_x_p6_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) * n13_x_p3_lanes +
      n13_y_p10_lanes;
  const Lanes<2> n13_y_lanes = n13_y_p11_lanes - 0.01626499875 * a12_x_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p15_lanes = detail::make_pack<Real>(s13, s20) * n13_x_lanes +
      detail::make_pack<Real>(c13, c20) * n13_y_lanes;
  const Lanes<2> n12_z_lanes = n12_z_p11_lanes - (0.0025100003499999995 * minus_a12_y_lanes +
      0.0006000000000000001 * a12_x_lanes) + n12_z_p15_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p1_lanes = detail::make_pack<Real>(tau[11], tau[18]) - n12_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;
  const Lanes<2> minus_a12_z_p1_lanes = w11_y_lanes * w11_z_lanes;
  const Lanes<2> minus_a12_z_p2_lanes = minus_a12_z_p1_lanes - wd11_x_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_z_lanes = minus_a11_y_lanes + 0.269 * minus_a12_z_p2_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> a13_y_lanes = detail::make_pack<Real>(s13, s20) * minus_a12_y_lanes -
      detail::make_pack<Real>(c13, c20) * minus_a12_z_lanes;
  const Lanes<2> minus_a13_x_lanes = detail::make_pack<Real>(c13, c20) * minus_a12_y_lanes +
      detail::make_pack<Real>(s13, s20) * minus_a12_z_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p9_lanes = 0.0007556474228594393 * n13_x_p9_lanes + 0.0009386316083993107 *
      wd12_x_lanes + 0.000108260010923775 * (n13_x_p2_lanes - wd13_x_lanes);
  const Lanes<2> n13_z_p15_lanes = n13_z_p9_lanes -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      (n13_x_p5_lanes + wd13_y_lanes) + detail::make_pack<Real>((-0.0001263900573325125),
      0.0001263900573325125) * (n13_x_p13_lanes - n13_y_p8_lanes);
  const Lanes<2> n13_z_lanes = n13_z_p15_lanes + (0.01626499875 * a13_y_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * minus_a13_x_lanes);

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p3_lanes = detail::make_pack<Real>(tau[12], tau[19]) - n13_z_lanes;

  // link 13 (left_hand), bias force
  const Lanes<2> qdd_0_p5_lanes = detail::make_pack<Real>(0.04672761636452121,
      (-0.04672761636452121)) * qdd_0_p3_lanes;
  const Lanes<2> qdd_0_p9_lanes = 0.11533812622014242 * qdd_0_p3_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p15_lanes = qdd_0_p1_lanes -
      (detail::make_pack<Real>(c13, c20) * qdd_0_p5_lanes - detail::make_pack<Real>(s13, s20) *
      qdd_0_p9_lanes);

  // link 13 (left_hand), bias force
  const Lanes<2> qdd_0_p19_lanes = 17.32841575379867 * qdd_0_p3_lanes;
  const Lanes<2> qdd_0_p23_lanes = detail::make_pack<Real>((-3.0523172236718206),
      3.0523172236718206) * qdd_0_p3_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p29_lanes = detail::make_pack<Real>(c13, c20) * qdd_0_p19_lanes -
      detail::make_pack<Real>(s13, s20) * qdd_0_p23_lanes + inverse_D1_p61_lanes * qdd_0_p15_lanes;
  const Lanes<2> qdd_0_p39_lanes = inverse_D11_p1_lanes * qdd_0_p15_lanes -
      (detail::make_pack<Real>(c13, c20) * qdd_0_p9_lanes + detail::make_pack<Real>(s13, s20) *
      qdd_0_p5_lanes);

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_x_p2_lanes = wd12_x_lanes - minus_w12_y_lanes * w12_z_lanes;
  const Lanes<2> n12_x_p4_lanes = w12_z_lanes * w12_z_lanes;
  const Lanes<2> n12_x_p5_lanes = minus_w12_y_lanes * minus_w12_y_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_x_p10_lanes = 1.16e-05 * n12_x_p2_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      (n12_x_p4_lanes - n12_x_p5_lanes) - 0.0006000000000000001 * minus_a12_z_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_x_lanes = n12_x_p10_lanes + n13_z_lanes;
  const Lanes<2> n12_y_p3_lanes = detail::make_pack<Real>(c13, c20) * n13_x_lanes -
      detail::make_pack<Real>(s13, s20) * n13_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_y_p5_lanes = n12_z_p8_lanes - wd12_y_lanes;
  const Lanes<2> n12_y_p7_lanes = n12_z_p5_lanes + wd11_y_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_y_lanes = 0.0025100003499999995 * minus_a12_z_lanes -
      (0.000195227662257343 * n12_y_p5_lanes + detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * n12_y_p7_lanes) + n12_y_p3_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_z_p3_lanes = detail::make_pack<Real>(s12, s19) * n12_x_lanes +
      detail::make_pack<Real>(c12, c19) * n12_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p6_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_z_p9_lanes = w11_x_lanes * w11_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p15_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      minus_a12_y_p2_lanes;
  const Lanes<2> n11_z_p16_lanes = 9.600000000000003e-06 * n11_z_p9_lanes + 0.0002292 *
      wd10_y_lanes + 0.000144 * minus_a12_z_p2_lanes + n11_z_p15_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_z_lanes = detail::make_pack<Real>(6e-06, (-6e-06)) *
      (minus_a12_y_p7_lanes - minus_a12_y_p6_lanes) - n11_z_p16_lanes - n11_z_p6_lanes -
      n11_z_p3_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p47_lanes = detail::make_pack<Real>(tau[10], tau[17]) - n11_z_lanes;

  // link 11 (left_wrist1), bias force
  const Lanes<2> qdd_0_p49_lanes = qdd_0_p47_lanes +
      (detail::make_pack<Real>(s12, s19) * qdd_0_p3_lanes + detail::make_pack<Real>(c12, c19) *
      qdd_0_p39_lanes);
  const Lanes<2> qdd_0_p53_lanes = qdd_0_p29_lanes + inverse_D1_p119_lanes * qdd_0_p49_lanes;

  // link 12 (left_wrist2), bias force
  const Lanes<2> qdd_0_p65_lanes = inverse_D1_p11_lanes * qdd_0_p15_lanes -
      (detail::make_pack<Real>(c13, c20) * qdd_0_p23_lanes + detail::make_pack<Real>(s13, s20) *
      qdd_0_p19_lanes);
  const Lanes<2> qdd_0_p69_lanes = inverse_D1_p35_lanes * qdd_0_p15_lanes;
  const Lanes<2> qdd_0_p73_lanes = detail::make_pack<Real>(s12, s19) * qdd_0_p65_lanes -
      detail::make_pack<Real>(c12, c19) * qdd_0_p69_lanes;

  // link 11 (left_wrist1), bias force
  const Lanes<2> qdd_0_p77_lanes = qdd_0_p73_lanes + inverse_D1_p55_lanes * qdd_0_p49_lanes;
  const Lanes<2> qdd_0_p93_lanes = inverse_D10_p1_lanes * qdd_0_p49_lanes;
  const Lanes<2> qdd_0_p95_lanes = 0.269 * qdd_0_p29_lanes -
      (detail::make_pack<Real>(s12, s19) * qdd_0_p39_lanes - detail::make_pack<Real>(c12, c19) *
      qdd_0_p3_lanes) + qdd_0_p93_lanes;
  const Lanes<2> qdd_0_p105_lanes = qdd_0_p1_lanes + 0.269 * qdd_0_p73_lanes +
      inverse_D10_p8_lanes * qdd_0_p49_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_x_lanes = detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      n13_y_p2_lanes - 0.01626499875 * (n13_x_p13_lanes + n13_x_p14_lanes);
  const Lanes<2> f13_y_lanes = 0.01626499875 * n13_x_p10_lanes -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      (n13_y_p8_lanes + n13_x_p14_lanes);

  // link 13 (left_hand), inward
  const Lanes<2> f12_z_p3_lanes = detail::make_pack<Real>(s13, s20) * f13_x_lanes +
      detail::make_pack<Real>(c13, c20) * f13_y_lanes;
  const Lanes<2> f12_z_lanes = 0.0025100003499999995 * n12_y_p5_lanes + 0.0006000000000000001 *
      n12_x_p2_lanes + f12_z_p3_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_x_p5_lanes = 0.269 * f12_z_lanes -
      (detail::make_pack<Real>(s12, s19) * n12_y_lanes - detail::make_pack<Real>(c12, c19) *
      n12_x_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p7_lanes = minus_a12_z_p1_lanes + wd11_x_lanes;
  const Lanes<2> n11_x_p9_lanes = minus_a12_y_p1_lanes - wd11_y_lanes;
  const Lanes<2> n11_x_p12_lanes = n11_z_p9_lanes - wd10_y_lanes;
  const Lanes<2> n11_x_p15_lanes = w11_z_lanes * w11_z_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p17_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (n11_x_p15_lanes - minus_a12_y_p7_lanes);
  const Lanes<2> n11_x_p18_lanes = 0.0001194 * n11_x_p7_lanes +
      detail::make_pack<Real>(6e-06, (-6e-06)) * n11_x_p9_lanes + 0.000144 * n11_x_p12_lanes +
      n11_x_p17_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_x_lanes = n11_x_p18_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_y_lanes + n11_x_p5_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> f12_y_p9_lanes = 0.0025100003499999995 * (wd11_y_lanes - n12_z_p5_lanes) -
      0.0006000000000000001 * (w12_x_lanes * w12_x_lanes + n12_x_p4_lanes);

  // link 13 (left_hand), inward
  const Lanes<2> f12_y_lanes = f12_y_p9_lanes + (detail::make_pack<Real>(c13, c20) * f13_x_lanes -
      detail::make_pack<Real>(s13, s20) * f13_y_lanes);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_lanes = 0.01626499875 * n13_x_p6_lanes +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) * n13_x_p3_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> f12_x_lanes = f13_z_lanes - (0.0025100003499999995 *
      (n12_x_p5_lanes + n12_x_p4_lanes) + 0.0006000000000000001 * n12_y_p7_lanes);

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_y_p3_lanes = detail::make_pack<Real>(s12, s19) * f12_y_lanes -
      detail::make_pack<Real>(c12, c19) * f12_x_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_y_p7_lanes = n11_z_p9_lanes + wd10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p14_lanes = 0.000144 * (minus_a12_y_p6_lanes - n11_x_p15_lanes);
  const Lanes<2> n11_y_p15_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      n11_y_p7_lanes - 0.0001098 * n11_x_p9_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) *
      n11_x_p7_lanes - n11_y_p14_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_y_lanes = n11_y_p15_lanes - 6e-04 * minus_a10_y_lanes +
      (n12_z_lanes + 0.269 * n11_y_p3_lanes);

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_z_p3_lanes = detail::make_pack<Real>(s11, s18) * n11_x_lanes +
      detail::make_pack<Real>(c11, c18) * n11_y_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_z_p7_lanes = w10_x_lanes * minus_w10_y_lanes;
  const Lanes<2> n10_z_p11_lanes = minus_w10_y_lanes * w10_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p14_lanes = 0.06032654142055946 * n10_z_p7_lanes + 0.060888541114265754 *
      wd9_y_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (n10_z_p11_lanes + wd10_x_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_z_p15_lanes = w10_x_lanes * w10_z_lanes;
  const Lanes<2> n10_z_p19_lanes = minus_w10_y_lanes * minus_w10_y_lanes;
  const Lanes<2> n10_z_p20_lanes = w10_x_lanes * w10_x_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p23_lanes = n10_z_p14_lanes -
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (n10_z_p15_lanes + wd10_y_lanes) + 0.0001499998887063 * (n10_z_p19_lanes - n10_z_p20_lanes);

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_z_lanes = n10_z_p23_lanes - (0.0014999985000000002 * minus_a10_y_lanes +
      0.28049749700000004 * a10_x_lanes) + n10_z_p3_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p111_lanes = detail::make_pack<Real>(tau[9], tau[16]) - n10_z_lanes;

  // link 10 (left_lowerarm), bias force
  const Lanes<2> qdd_0_p113_lanes = qdd_0_p111_lanes -
      (detail::make_pack<Real>(s11, s18) * qdd_0_p95_lanes + detail::make_pack<Real>(c11, c18) *
      qdd_0_p105_lanes);
  const Lanes<2> qdd_0_p117_lanes = detail::make_pack<Real>(c11, c18) * qdd_0_p53_lanes -
      detail::make_pack<Real>(s11, s18) * qdd_0_p77_lanes + inverse_D1_p191_lanes *
      qdd_0_p113_lanes;
  const Lanes<2> qdd_0_p129_lanes = detail::make_pack<Real>(c11, c18) * qdd_0_p95_lanes -
      detail::make_pack<Real>(s11, s18) * qdd_0_p105_lanes + inverse_D1_p231_lanes *
      qdd_0_p113_lanes;
  const Lanes<2> qdd_0_p135_lanes = inverse_D1_p221_lanes * qdd_0_p113_lanes - qdd_0_p47_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p4_lanes = wd10_x_lanes - n10_z_p11_lanes;
  const Lanes<2> n10_x_p6_lanes = n10_z_p15_lanes - wd10_y_lanes;
  const Lanes<2> n10_x_p9_lanes = wd9_y_lanes - n10_z_p7_lanes;
  const Lanes<2> n10_x_p12_lanes = w10_z_lanes * w10_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p14_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * (n10_x_p12_lanes - n10_z_p19_lanes);
  const Lanes<2> n10_x_p15_lanes = 0.06060754126741261 * n10_x_p4_lanes + 0.0001499998887063 *
      n10_x_p6_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      n10_x_p9_lanes + n10_x_p14_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_x_lanes = n10_x_p15_lanes - 0.28049749700000004 * minus_a10_z_lanes +
      (detail::make_pack<Real>(c11, c18) * n11_x_lanes - detail::make_pack<Real>(s11, s18) *
      n11_y_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p2_lanes = n10_z_p7_lanes + wd9_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p6_lanes = 0.00028099984685315 * n10_x_p6_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * n10_y_p2_lanes +
      0.0001499998887063 * n10_x_p4_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_y_lanes = detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (n10_z_p20_lanes - n10_x_p12_lanes) - n10_y_p6_lanes + 0.0014999985000000002 *
      minus_a10_z_lanes - n11_z_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_z_p3_lanes = detail::make_pack<Real>(s10, s17) * n10_x_lanes +
      detail::make_pack<Real>(c10, c17) * n10_y_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p6_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_z_p8_lanes = w9_x_lanes * w9_y_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p13_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * a10_x_p2_lanes;
  const Lanes<2> n9_z_p14_lanes = 0.0005895000784280001 * minus_a10_z_p2_lanes -
      (0.001140794814995722 * n9_z_p8_lanes + 0.0027762933559338653 * wd8_x_lanes) - n9_z_p13_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_z_lanes = n9_z_p14_lanes + detail::make_pack<Real>((-4.4999986458742003e-05),
      4.4999986458742003e-05) * (a10_x_p7_lanes - a10_x_p6_lanes) + n9_z_p6_lanes - n9_z_p3_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p149_lanes = detail::make_pack<Real>(tau[8], tau[15]) - n9_z_lanes;

  // link 9 (left_upperarm), bias force
  const Lanes<2> qdd_0_p151_lanes = qdd_0_p149_lanes +
      (detail::make_pack<Real>(s10, s17) * qdd_0_p129_lanes + detail::make_pack<Real>(c10, c17) *
      qdd_0_p135_lanes);
  const Lanes<2> qdd_0_p153_lanes = inverse_D1_p259_lanes * qdd_0_p151_lanes;
  const Lanes<2> qdd_0_p155_lanes = 0.282 * qdd_0_p117_lanes -
      (detail::make_pack<Real>(s10, s17) * qdd_0_p135_lanes - detail::make_pack<Real>(c10, c17) *
      qdd_0_p129_lanes) + qdd_0_p153_lanes;

  // link 10 (left_lowerarm), bias force
  const Lanes<2> qdd_0_p167_lanes = inverse_D1_p317_lanes * qdd_0_p113_lanes -
      (detail::make_pack<Real>(c11, c18) * qdd_0_p77_lanes + detail::make_pack<Real>(s11, s18) *
      qdd_0_p53_lanes);

  // link 11 (left_wrist1), bias force
  const Lanes<2> qdd_0_p181_lanes = inverse_D1_p337_lanes * qdd_0_p49_lanes -
      (detail::make_pack<Real>(s12, s19) * qdd_0_p69_lanes + detail::make_pack<Real>(c12, c19) *
      qdd_0_p65_lanes);

  // link 10 (left_lowerarm), bias force
  const Lanes<2> qdd_0_p183_lanes = inverse_D1_p363_lanes * qdd_0_p113_lanes - qdd_0_p181_lanes;
  const Lanes<2> qdd_0_p187_lanes = detail::make_pack<Real>(s10, s17) * qdd_0_p183_lanes -
      detail::make_pack<Real>(c10, c17) * qdd_0_p167_lanes;

  // link 9 (left_upperarm), bias force
  const Lanes<2> qdd_0_p195_lanes = qdd_0_p111_lanes + 0.282 * qdd_0_p187_lanes +
      inverse_D1_p401_lanes * qdd_0_p151_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> f11_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * n11_y_p7_lanes - 6e-04 *
      (minus_a12_y_p7_lanes + n11_x_p15_lanes) - n11_y_p3_lanes;
  const Lanes<2> f11_y_lanes = 6e-04 * n11_x_p12_lanes - detail::make_pack<Real>(0.001, (-0.001)) *
      (minus_a12_y_p6_lanes + n11_x_p15_lanes) + f12_z_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> f10_z_p3_lanes = detail::make_pack<Real>(s11, s18) * f11_x_lanes +
      detail::make_pack<Real>(c11, c18) * f11_y_lanes;
  const Lanes<2> f10_z_lanes = 0.0014999985000000002 * n10_x_p6_lanes + 0.28049749700000004 *
      n10_x_p4_lanes + f10_z_p3_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_x_p5_lanes = 0.282 * f10_z_lanes -
      (detail::make_pack<Real>(s10, s17) * n10_y_lanes - detail::make_pack<Real>(c10, c17) *
      n10_x_lanes);

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p6_lanes = minus_a10_z_p1_lanes + wd9_x_lanes;
  const Lanes<2> n9_x_p8_lanes = a10_x_p1_lanes - wd9_y_lanes;
  const Lanes<2> n9_x_p11_lanes = n9_z_p8_lanes - wd8_x_lanes;
  const Lanes<2> n9_x_p14_lanes = w9_z_lanes * w9_z_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p16_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (n9_x_p14_lanes - a10_x_p7_lanes);
  const Lanes<2> n9_x_p17_lanes = 0.0019585440854647937 * n9_x_p6_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p8_lanes -
      0.0005895000784280001 * n9_x_p11_lanes + n9_x_p16_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_x_lanes = n9_x_p17_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_x_lanes + n9_x_p5_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> f11_z_p3_lanes = detail::make_pack<Real>(s12, s19) * f12_x_lanes +
      detail::make_pack<Real>(c12, c19) * f12_y_lanes;
  const Lanes<2> f11_z_lanes = 6e-04 * n11_x_p9_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      n11_x_p7_lanes - f11_z_p3_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> f10_y_lanes = 0.0014999985000000002 * n10_x_p9_lanes - 0.28049749700000004 *
      (n10_z_p20_lanes + n10_x_p12_lanes) - f11_z_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_x_p7_lanes = 0.0014999985000000002 * (n10_z_p19_lanes + n10_x_p12_lanes) +
      0.28049749700000004 * n10_y_p2_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> f10_x_lanes = detail::make_pack<Real>(c11, c18) * f11_x_lanes -
      detail::make_pack<Real>(s11, s18) * f11_y_lanes - f10_x_p7_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_y_p3_lanes = detail::make_pack<Real>(s10, s17) * f10_y_lanes -
      detail::make_pack<Real>(c10, c17) * f10_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_y_p6_lanes = n9_z_p8_lanes + wd8_x_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p13_lanes = 0.0005895000784280001 * (a10_x_p6_lanes - n9_x_p14_lanes);
  const Lanes<2> n9_y_p14_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * n9_y_p6_lanes - 0.0008177492704690715 * n9_x_p8_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p6_lanes +
      n9_y_p13_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_y_lanes = n9_y_p14_lanes - 0.0022500062 * a8_x_lanes +
      (n10_z_lanes + 0.282 * n9_y_p3_lanes);

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_z_p3_lanes = detail::make_pack<Real>(c9, c16) * n9_x_lanes -
      detail::make_pack<Real>(s9, s16) * n9_y_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p7_lanes = w8_x_lanes * w8_y_lanes;
  const Lanes<2> n8_z_p11_lanes = w8_y_lanes * w8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p14_lanes = 0.18101044219699997 * n8_z_p7_lanes + 0.18125194219699997 *
      wd7_x_lanes + 0.00010499999999999999 * (n8_z_p11_lanes - wd8_x_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_z_p15_lanes = w8_x_lanes * w8_z_lanes;
  const Lanes<2> n8_z_p19_lanes = w8_y_lanes * w8_y_lanes;
  const Lanes<2> n8_z_p20_lanes = w8_x_lanes * w8_x_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p23_lanes = n8_z_p14_lanes - detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_z_p15_lanes + wd8_y_lanes) + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (n8_z_p19_lanes - n8_z_p20_lanes);

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_z_lanes = n8_z_p23_lanes - (0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes) +
      n8_z_p3_lanes;

  // link 1 (calf), inward
  const Lanes<2> qdd_0_p201_lanes = detail::make_pack<Real>(tau[7], tau[14]) - n8_z_lanes;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p203_lanes = qdd_0_p201_lanes -
      (detail::make_pack<Real>(c9, c16) * qdd_0_p155_lanes - detail::make_pack<Real>(s9, s16) *
      qdd_0_p195_lanes);

  // link 9 (left_upperarm), bias force
  const Lanes<2> qdd_0_p209_lanes = qdd_0_p187_lanes + inverse_D1_p569_lanes * qdd_0_p151_lanes;
  const Lanes<2> qdd_0_p215_lanes = qdd_0_p117_lanes + inverse_D1_p577_lanes * qdd_0_p151_lanes;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p231_lanes = detail::make_pack<Real>(s9, s16) * qdd_0_p155_lanes +
      detail::make_pack<Real>(c9, c16) * qdd_0_p195_lanes + inverse_D7_p1_lanes * qdd_0_p203_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> qdd_0_p235_lanes = 0.00010499999999999999 / inverse_D8_p3_lanes;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p239_lanes = qdd_0_p149_lanes + qdd_0_p235_lanes * qdd_0_p203_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p4_lanes = n8_z_p7_lanes - wd7_x_lanes;
  const Lanes<2> n8_y_p6_lanes = n8_z_p15_lanes - wd8_y_lanes;
  const Lanes<2> n8_y_p9_lanes = n8_z_p11_lanes + wd8_x_lanes;
  const Lanes<2> n8_y_p12_lanes = w8_z_lanes * w8_z_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p14_lanes = 0.00010499999999999999 * (n8_z_p20_lanes - n8_y_p12_lanes);
  const Lanes<2> n8_y_p15_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n8_y_p4_lanes -
      0.18113119219699997 * n8_y_p6_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * n8_y_p9_lanes + n8_y_p14_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_y_lanes = n8_y_p15_lanes - 0.7139200499999999 * a7_x_lanes +
      (detail::make_pack<Real>(s9, s16) * n9_x_lanes + detail::make_pack<Real>(c9, c16) *
      n9_y_lanes);

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p1_lanes = detail::make_pack<Real>(c8, c15) * n8_y_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_x_p4_lanes = n8_z_p7_lanes + wd7_x_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p8_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (n8_y_p12_lanes - n8_z_p19_lanes);
  const Lanes<2> n8_x_p9_lanes = 0.00012075 * n8_y_p9_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * n8_y_p6_lanes -
      0.00010499999999999999 * n8_x_p4_lanes + n8_x_p8_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_x_lanes = n8_x_p9_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes - n9_z_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_z_p3_lanes = w7_x_lanes * w7_y_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_z_p5 = 0.00044800000000000005 * wd6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_z_p7_lanes = w7_y_lanes * w7_z_lanes;
  const Lanes<2> n7_z_p11_lanes = w7_x_lanes * w7_z_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p13_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_z_p11_lanes + wd7_y_lanes);
  const Lanes<2> n7_z_p14_lanes = 0.00014700000000000002 * n7_z_p3_lanes + n7_z_p5 +
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) *
      (n7_z_p7_lanes - wd7_x_lanes) - n7_z_p13_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_z_p15_lanes = w7_y_lanes * w7_y_lanes;
  const Lanes<2> n7_z_p16_lanes = w7_x_lanes * w7_x_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p21_lanes = n7_z_p14_lanes + 8.75e-06 * (n7_z_p15_lanes - n7_z_p16_lanes) +
      detail::make_pack<Real>(s8, s15) * n8_x_lanes + n7_z_p1_lanes;
  const Lanes<2> n7_z_lanes = n7_z_p21_lanes + 0.0017499999999999998 * (a7_y_lanes + a7_x_lanes);

  // link 1 (calf), inward
  const Real qdd_0_p245 = tau[13] - n7_z_lanes[1];
  const Real qdd_0_p246 = tau[6] - n7_z_lanes[0];

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p247_lanes = detail::make_pack<Real>(qdd_0_p246, qdd_0_p245) -
      (detail::make_pack<Real>(c8, c15) * qdd_0_p231_lanes - detail::make_pack<Real>(s8, s15) *
      qdd_0_p239_lanes);
  const Lanes<2> qdd_0_p249_lanes = inverse_D1_p679_lanes * qdd_0_p247_lanes;
  const Lanes<2> qdd_0_p251_lanes = inverse_D1_p657_lanes * qdd_0_p203_lanes -
      (detail::make_pack<Real>(c9, c16) * qdd_0_p209_lanes + detail::make_pack<Real>(s9, s16) *
      qdd_0_p215_lanes) + qdd_0_p249_lanes;

  // link 8 (left_shoulder2), bias force
  const Lanes<2> qdd_0_p263_lanes = inverse_D1_p609_lanes * qdd_0_p203_lanes -
      (detail::make_pack<Real>(s9, s16) * qdd_0_p209_lanes - detail::make_pack<Real>(c9, c16) *
      qdd_0_p215_lanes);
  const Lanes<2> qdd_0_p267_lanes = inverse_D1_p555_lanes * qdd_0_p203_lanes;
  const Lanes<2> qdd_0_p279_lanes = detail::make_pack<Real>(s10, s17) * qdd_0_p167_lanes +
      detail::make_pack<Real>(c10, c17) * qdd_0_p183_lanes + inverse_D1_p515_lanes *
      qdd_0_p151_lanes - qdd_0_p267_lanes;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p287_lanes = detail::make_pack<Real>(c8, c15) * qdd_0_p279_lanes -
      detail::make_pack<Real>(s8, s15) * qdd_0_p263_lanes + inverse_D1_p639_lanes *
      qdd_0_p247_lanes;
  const Lanes<2> qdd_0_p291_lanes = detail::make_pack<Real>(c7, c14) * qdd_0_p251_lanes -
      detail::make_pack<Real>(s7, s14) * qdd_0_p287_lanes;
  const Lanes<2> qdd_0_p303_lanes = inverse_D6_p5_lanes * qdd_0_p247_lanes -
      (detail::make_pack<Real>(c8, c15) * qdd_0_p239_lanes + detail::make_pack<Real>(s8, s15) *
      qdd_0_p231_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> qdd_0_p307_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p17_lanes;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p311_lanes = qdd_0_p201_lanes + qdd_0_p307_lanes * qdd_0_p247_lanes;
  const Lanes<2> qdd_0_p317_lanes = detail::make_pack<Real>(s7, s14) * qdd_0_p311_lanes +
      detail::make_pack<Real>(c7, c14) * qdd_0_p303_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      qdd_0_p291_lanes;

  // link 21 (neck), outward
  const Real w21_x = s21 * w6_y + c21 * w6_z;
  const Real w21_z = qd[20] - w6_x;

  // link 22 (head), outward
  const Real w22_x = c22 * w21_x - s22 * w21_z;

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;

  // link 22 (head), outward
  const Real w22_z = w21_y + qd[21];

  // link 23 (left_eye), outward
  const Lanes<2> w23_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;

  // link 23 (left_eye), outward
  const Lanes<2> w23_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> n23_y_p2_lanes = w23_z_lanes * w23_z_lanes;

  // link 21 (neck), outward
  const Real wd21_y = c21 * wd6_y - s21 * wd5_x - w21_x * qd[20];
  const Real wd21_x = s21 * wd6_y + c21 * wd5_x + w21_y * qd[20];

  // link 22 (head), outward
  const Real wd22_x = c22 * wd21_x + s22 * wd6_x - minus_w22_y * qd[21];

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p10_lanes = (w23_z_lanes + detail::make_pack<Real>(qd[22], qd[23])) *
      w23_x_lanes - (detail::make_pack<Real>(c23, c24) * wd21_y -
      detail::make_pack<Real>(s23, s24) * wd22_x);

  // link 21 (neck), outward
  const Real a22_y_p1 = w21_x * w21_x;
  const Real a22_y_p2 = w21_y * w21_y;

  // link 22 (head), outward
  const Real a22_y_p3 = a6_x + 0.394 * (a22_y_p1 + a22_y_p2);

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Real a22_y_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_y_p5 = a21_x + 0.394 * (a22_y_p4 + wd21_y);
  const Real a22_y = c22 * a22_y_p3 - s22 * a22_y_p5;
  const Real minus_a23_z_p1 = w22_x * minus_w22_y;
  const Real minus_a23_z_p2 = wd21_y - minus_a23_z_p1;

  // link 24 (right_eye), outward
  const Real minus_a23_z_p3 = a22_y + 0.095 * minus_a23_z_p2;

  // link 22 (head), outward
  const Real minus_a23_z_p4 = minus_w22_y * w22_z;
  const Real minus_a23_z_p5 = minus_a23_z_p4 + wd22_x;

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_z_lanes = minus_a23_z_p3 - detail::make_pack<Real>(0.032, (-0.032)) *
      minus_a23_z_p5;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_p13_lanes = 0.00025 * minus_a23_z_lanes;
  const Lanes<2> n23_y_lanes = 2.8750000000000004e-05 *
      (w23_x_lanes * w23_x_lanes - n23_y_p2_lanes) - 5.25e-06 * n23_y_p10_lanes + n23_y_p13_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> w23_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;
  const Lanes<2> wd23_x_lanes = detail::make_pack<Real>(c23, c24) * wd22_x +
      detail::make_pack<Real>(s23, s24) * wd21_y + w23_y_lanes *
      detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> n23_x_p1_lanes = w23_y_lanes * w23_z_lanes;
  const Lanes<2> n23_x_p4_lanes = w23_x_lanes * w23_y_lanes;

  // link 22 (head), outward
  const Real wd22_y = c22 * wd6_x - s22 * wd21_x - w22_x * qd[21];

  // link 23 (left_eye), outward
  const Lanes<2> n23_x_p5_lanes = n23_x_p4_lanes - wd22_y;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_x_lanes = 4e-06 * (n23_x_p1_lanes + wd23_x_lanes) - 2.8750000000000004e-05 *
      n23_x_p5_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_x_p9_lanes = detail::make_pack<Real>(c23, c24) * n23_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_y_lanes + detail::make_pack<Real>(8e-06, (-8e-06)) *
      n23_y_p10_lanes;

  // link 22 (head), outward
  const Real n22_x_p11 = wd22_x - minus_a23_z_p4;
  const Real n22_x_p12 = w22_x * w22_z;
  const Real n22_x_p13 = n22_x_p12 - wd22_y;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real a22_z_p1 = w21_y * w21_z;
  const Real a22_z_p2 = a22_z_p1 - wd21_x;

  // link 22 (head), outward
  const Real a22_z = 0.394 * a22_z_p2 - minus_a21_y;

  // link 23 (left_eye), inward
  const Real n22_x = 0.05450270000000001 * n22_x_p11 - 0.0074 * n22_x_p13 - 0.43200000000000005 *
      a22_z + n22_x_p9_lanes[1] + n22_x_p9_lanes[0];

  // link 24 (right_eye), outward
  const Real a23_y_p1 = a22_z + 0.095 * n22_x_p13;

  // link 22 (head), outward
  const Real a23_y_p2 = w22_x * w22_x;
  const Real a23_y_p3 = minus_w22_y * minus_w22_y;

  // link 23 (left_eye), outward
  const Real a23_y_p4 = a23_y_p2 + a23_y_p3;

  // link 22 (head), outward
  const Real a22_x = c22 * a22_y_p5 + s22 * a22_y_p3;
  const Real a23_y_p8 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Real a23_y_p9 = a23_y_p3 + a23_y_p8;

  // link 24 (right_eye), outward
  const Real a23_y_p10 = a22_x - 0.095 * a23_y_p9;

  // link 22 (head), outward
  const Real a23_y_p11 = n22_x_p12 + wd22_y;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_p14_lanes = detail::make_pack<Real>(s23, s24) *
      (a23_y_p10 + detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p11);
  const Lanes<2> a23_y_lanes = detail::make_pack<Real>(c23, c24) *
      (a23_y_p1 - detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p4) - a23_y_p14_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_p1_lanes = 0.00025 * a23_y_lanes;
  const Real n23_z_p3 = 9.25e-06 * wd22_y;
  const Lanes<2> n23_z_lanes = 1.2499999999999999e-06 * n23_x_p4_lanes - n23_z_p3 +
      2.8750000000000004e-05 * (n23_x_p1_lanes - wd23_x_lanes) + n23_z_p1_lanes;
  const Lanes<2> minus_f23_x_lanes = 0.00025 * (w23_y_lanes * w23_y_lanes + n23_y_p2_lanes);
  const Lanes<2> f23_y_lanes = 0.00025 * n23_x_p5_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p5_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_y_lanes;
  const Real n22_y_p7 = 0.0074 * n22_x_p11 - 0.009438624999999999 * n22_x_p13 - 0.072575 * a22_z -
      n23_z_lanes[1] - (-0.032) * n22_y_p5_lanes[1];
  const Lanes<2> n22_y_p12_lanes = detail::make_pack<Real>(c23, c24) * f23_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_x_lanes;
  const Real n22_y_p14 = n22_y_p12_lanes[1] + n22_y_p12_lanes[0];
  const Real n22_y = n22_y_p7 - n23_z_lanes[0] - 0.032 * n22_y_p5_lanes[0] - 0.095 * n22_y_p14;

  // link 21 (neck), outward
  const Real n21_z_p1 = w21_x * w21_y;

  // link 22 (head), inward
  const Real n21_z = 0.0016155 * a22_z_p2 - (0.0048105000000000005 * n21_z_p1 + 0.00621675 *
      wd6_x) - 0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);

  // link 1 (calf), inward
  const Real qdd_0_p319 = tau[20] - n21_z;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p324_lanes = detail::make_pack<Real>(s7, s14) * qdd_0_p251_lanes +
      detail::make_pack<Real>(c7, c14) * qdd_0_p287_lanes;
  const Lanes<2> qdd_0_p326_lanes = detail::make_pack<Real>(s7, s14) * qdd_0_p303_lanes;
  const Lanes<2> qdd_0_p328_lanes = detail::make_pack<Real>(c7, c14) * qdd_0_p311_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p1_lanes = n7_z_p7_lanes + wd7_x_lanes;
  const Lanes<2> n7_x_p3_lanes = n7_z_p11_lanes - wd7_y_lanes;
  const Lanes<2> n7_x_p6_lanes = n7_z_p3_lanes + wd6_y;
  const Lanes<2> n7_x_p9_lanes = w7_z_lanes * w7_z_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p11_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_x_p9_lanes - n7_z_p15_lanes);
  const Lanes<2> n7_x_p12_lanes = 0.0001505 * n7_x_p1_lanes + 8.75e-06 * n7_x_p3_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * n7_x_p6_lanes +
      n7_x_p11_lanes;
  const Lanes<2> n7_x_p13_lanes = 0.0017499999999999998 * minus_a7_z_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_x_lanes = n7_x_p12_lanes + n7_x_p13_lanes + n8_z_lanes;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p1_lanes = detail::make_pack<Real>(c7, c14) * n7_x_lanes;

  // link 23 (left_eye), inward
  const Real f22_z = 0.072575 * n22_x_p13 - 0.43200000000000005 * n22_x_p11 + n22_y_p14;

  // link 21 (neck), outward
  const Real n21_x_p1 = n21_z_p1 - wd6_x;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * (a22_z_p1 + wd21_x) - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 6 (chest3), inertial wrench
  const Real n6_z_p3 = 1.26882463592404 * a7_x_p4 + 2.06965463592404 * wd5_x - 0.0187369177636143 *
      (a7_x_p11 - wd6_x) + 6.1665928899999995 * minus_a6_y;

  // link 23 (left_eye), inward
  const Real n22_z_p1 = 0.04506407500000001 * minus_a23_z_p1 + 0.06394132500000001 * wd21_y -
      0.0074 * (a23_y_p3 - a23_y_p2) + 0.072575 * a22_y;
  const Lanes<2> n22_z_p2_lanes = detail::make_pack<Real>(s23, s24) * n23_x_lanes;
  const Lanes<2> n22_z_p4_lanes = detail::make_pack<Real>(c23, c24) * n23_y_lanes;
  const Real n22_z_p6 = n23_y_p10_lanes[1] + n23_y_p10_lanes[0];
  const Real n22_z = n22_z_p1 + 0.43200000000000005 * a22_x + n22_z_p2_lanes[1] +
      n22_z_p4_lanes[1] + n22_z_p2_lanes[0] + n22_z_p4_lanes[0] - 2.375e-05 * n22_z_p6;
  const Real f22_y = 0.072575 * minus_a23_z_p2 + 0.43200000000000005 * (a23_y_p2 + a23_y_p8) -
      0.00025 * n22_z_p6;
  const Real f22_x = 0.43200000000000005 * (minus_a23_z_p1 + wd21_y) - 0.072575 * a23_y_p9 -
      n22_y_p5_lanes[1] - n22_y_p5_lanes[0];

  // link 22 (head), inward
  const Real n21_y_p1 = s22 * f22_y - c22 * f22_x;

  // link 21 (neck), outward
  const Real n21_y_p2 = w21_z * w21_z;
  const Real n21_y_p3 = a22_y_p4 - wd21_y;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a22_y_p1 - n21_y_p2) - 0.000703125 * n21_y_p3 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p1);

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p4_lanes = n7_z_p3_lanes - wd6_y;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p11_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (n7_z_p16_lanes - n7_x_p9_lanes);
  const Lanes<2> n7_y_p12_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * n7_y_p4_lanes - 0.0002975 * n7_x_p3_lanes - 8.75e-06 *
      n7_x_p1_lanes + n7_y_p11_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_y_lanes = n7_y_p12_lanes + n7_x_p13_lanes +
      (detail::make_pack<Real>(c8, c15) * n8_x_lanes - detail::make_pack<Real>(s8, s15) *
      n8_y_lanes);

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p4_lanes = detail::make_pack<Real>(s7, s14) * n7_y_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_z_p3_lanes = detail::make_pack<Real>(s10, s17) * f10_x_lanes +
      detail::make_pack<Real>(c10, c17) * f10_y_lanes;
  const Lanes<2> f9_z_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      n9_x_p6_lanes - 0.0022500062 * n9_x_p8_lanes - f9_z_p3_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p4_lanes - 0.7139200499999999 *
      (n8_z_p19_lanes + n8_y_p12_lanes) - f9_z_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_x_lanes = 0.0022500062 * (a10_x_p7_lanes + n9_x_p14_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * n9_y_p6_lanes - n9_y_p3_lanes;
  const Lanes<2> f9_y_lanes = f10_z_lanes - (0.0022500062 * n9_x_p11_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      (a10_x_p6_lanes + n9_x_p14_lanes));

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_y_p3_lanes = detail::make_pack<Real>(s9, s16) * f9_x_lanes +
      detail::make_pack<Real>(c9, c16) * f9_y_lanes;
  const Lanes<2> f8_y_lanes = 0.7139200499999999 * n8_x_p4_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (n8_z_p20_lanes + n8_y_p12_lanes) + f8_y_p3_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_p6_lanes = 0.0017499999999999998 *
      (n7_x_p6_lanes + (n7_z_p16_lanes + n7_x_p9_lanes));
  const Lanes<2> f7_y_lanes = detail::make_pack<Real>(c8, c15) * f8_x_lanes -
      detail::make_pack<Real>(s8, s15) * f8_y_lanes + f7_y_p6_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> f7_x_p6_lanes = detail::make_pack<Real>(s9, s16) * f9_y_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_p7_lanes = 0.7139200499999999 * n8_y_p6_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * n8_y_p9_lanes +
      detail::make_pack<Real>(c9, c16) * f9_x_lanes - f7_x_p6_lanes;
  const Lanes<2> f7_x_lanes = f7_x_p7_lanes - 0.0017499999999999998 *
      (n7_z_p15_lanes + n7_x_p9_lanes + n7_y_p4_lanes);

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p10_lanes = detail::make_pack<Real>(s7, s14) * f7_x_lanes +
      detail::make_pack<Real>(c7, c14) * f7_y_lanes;
  const Real n6_z_p12 = n6_z_p3 + c21 * n21_x - s21 * n21_y + n6_z_p1_lanes[1] - n6_z_p4_lanes[1] -
      (-0.18) * n6_z_p10_lanes[1];

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_z_lanes = detail::make_pack<Real>(s8, s15) * f8_x_lanes +
      detail::make_pack<Real>(c8, c15) * f8_y_lanes + 0.0017499999999999998 *
      (n7_x_p3_lanes - n7_x_p1_lanes);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p13 = f7_z_lanes[1] + f7_z_lanes[0];
  const Real n6_z = n6_z_p12 + n6_z_p1_lanes[0] - n6_z_p4_lanes[0] - 0.18 * n6_z_p10_lanes[0] -
      0.226 * n6_z_p13;

  // link 1 (calf), inward
  const Real qdd_0_p330 = tau[5] - n6_z;
  const Real qdd_0_p331 = tau[21] - n22_z;
  const Real qdd_0_p332 = tau[23] - n23_z_lanes[1];
  const Real qdd_0_p333 = tau[22] - n23_z_lanes[0];

  // link 23 (left_eye), bias force
  const Lanes<2> qdd_0_p334_lanes = 3.1081081081081083 *
      detail::make_pack<Real>(qdd_0_p333, qdd_0_p332);
  const Lanes<2> qdd_0_p336_lanes = detail::make_pack<Real>(s23, s24) * qdd_0_p334_lanes;

  // link 22 (head), bias force
  const Real qdd_0_p338 = qdd_0_p331 + (qdd_0_p336_lanes[1] + qdd_0_p336_lanes[0]);

  // link 23 (left_eye), bias force
  const Lanes<2> qdd_0_p339_lanes = detail::make_pack<Real>(c23, c24) * qdd_0_p334_lanes;

  // link 22 (head), bias force
  const Real qdd_0_p341 = qdd_0_p339_lanes[1] + qdd_0_p339_lanes[0] + inverse_D21_p12 * qdd_0_p338;

  // link 23 (left_eye), bias force
  const Lanes<2> qdd_0_p342_lanes = 27.027027027027028 *
      detail::make_pack<Real>(qdd_0_p333, qdd_0_p332);
  const Lanes<2> qdd_0_p344_lanes = detail::make_pack<Real>(s23, s24) * qdd_0_p342_lanes;
  const Lanes<2> qdd_0_p346_lanes = detail::make_pack<Real>(c23, c24) * qdd_0_p342_lanes;

  // link 22 (head), bias force
  const Real qdd_0_p348 = qdd_0_p346_lanes[1] + qdd_0_p346_lanes[0];
  const Real qdd_0_p349 = inverse_D21_p1 * qdd_0_p338 - qdd_0_p332 - (-0.032) *
      qdd_0_p344_lanes[1] - qdd_0_p333 - 0.032 * qdd_0_p344_lanes[0] - 0.095 * qdd_0_p348;
  const Real qdd_0_p350 = qdd_0_p348 + inverse_D1_p911 * qdd_0_p338;

  // link 21 (neck), bias force
  const Real qdd_0_p351 = qdd_0_p319 - (s22 * qdd_0_p341 - c22 * qdd_0_p349);
  const Real qdd_0_p352 = c22 * qdd_0_p341 + s22 * qdd_0_p349 + 0.394 * qdd_0_p350 +
      inverse_D6_p34 * qdd_0_p351;

  // link 22 (head), bias force
  const Real qdd_0_p353 = inverse_D1_p891 * qdd_0_p338;
  const Real qdd_0_p354 = inverse_D1_p876 * qdd_0_p338 -
      (qdd_0_p344_lanes[1] + qdd_0_p344_lanes[0]);
  const Real qdd_0_p355 = s22 * qdd_0_p353 - c22 * qdd_0_p354;

  // link 21 (neck), bias force
  const Real qdd_0_p356 = qdd_0_p331 - 0.394 * qdd_0_p355 - inverse_D6_p39 * qdd_0_p351;

  // link 6 (chest3), bias force
  const Real qdd_0_p357 = qdd_0_p330 - qdd_0_p328_lanes[1] + qdd_0_p326_lanes[1] + (-0.18) *
      qdd_0_p324_lanes[1] + c21 * qdd_0_p352 + s21 * qdd_0_p356;

  // link 7 (left_shoulder1), bias force
  const Lanes<2> qdd_0_p366_lanes = detail::make_pack<Real>(s8, s15) * qdd_0_p279_lanes +
      detail::make_pack<Real>(c8, c15) * qdd_0_p263_lanes + inverse_D1_p837_lanes *
      qdd_0_p247_lanes;

  // link 6 (chest3), bias force
  const Real qdd_0_p368 = qdd_0_p366_lanes[1] + qdd_0_p366_lanes[0];
  const Real qdd_0_p369 = qdd_0_p357 - qdd_0_p328_lanes[0] + qdd_0_p326_lanes[0] + 0.18 *
      qdd_0_p324_lanes[0] + 0.226 * qdd_0_p368;
  const Real qdd_0_p370 = qdd_0_p317_lanes[1] - qdd_0_p319 + qdd_0_p317_lanes[0] + inverse_D5_p16 *
      qdd_0_p369;
  const Real qdd_0_p371 = qdd_0_p291_lanes[1] + qdd_0_p291_lanes[0];
  const Real qdd_0_p372 = qdd_0_p245 - s21 * qdd_0_p352 + c21 * qdd_0_p356 + qdd_0_p246 +
      inverse_D5_p22 * qdd_0_p369 + 0.226 * qdd_0_p371;

  // link 21 (neck), bias force
  const Real qdd_0_p373 = qdd_0_p355 + inverse_D1_p974 * qdd_0_p351;
  const Real qdd_0_p374 = qdd_0_p350 + inverse_D1_p977 * qdd_0_p351;

  // link 6 (chest3), bias force
  const Real qdd_0_p375 = qdd_0_p371 - c21 * qdd_0_p373 - s21 * qdd_0_p374 + inverse_D1_p993 *
      qdd_0_p369;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_x_p11_lanes = detail::make_pack<Real>(c7, c14) * f7_x_lanes -
      detail::make_pack<Real>(s7, s14) * f7_y_lanes;
  const Lanes<2> n6_x_p15_lanes = detail::make_pack<Real>(s7, s14) * n7_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_y_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      n6_x_p11_lanes;
  const Real n6_x = 0.40041499999999997 * a7_x_p12 + 0.0187369177636143 * minus_a7_z_p1 - n21_z +
      n6_x_p15_lanes[1] + n6_x_p15_lanes[0];
  const Real n6_y_p1 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_x_p9 - 0.0187369177636143 *
      (minus_a7_z_p3 - a7_x_p1) + s21 * n21_x;
  const Real n6_y_p2 = n6_x_p11_lanes[1] + n6_x_p11_lanes[0];
  const Real n6_y = n6_y_p1 + c21 * n21_y + n7_z_lanes[1] + n7_z_lanes[0] + 0.226 * n6_y_p2;

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (a22_y_p2 + n21_y_p2) + n21_y_p1;
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p2 - 6.1665928899999995 * a7_x_p9 - c21 * minus_f21_x - s21 * f21_y;

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p2 = 0.10961925816937637 * a6_z_p1 - 0.203126912024134 * minus_wd4_y -
      0.005678398088837119 * (n5_z_p1 - a6_x_p1) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);

  // link 1 (calf), inward
  const Real qdd_0_p376 = tau[4] - n5_z;

  // link 5 (chest2), bias force
  const Real qdd_0_p377 = qdd_0_p376 - (s6 * qdd_0_p370 + c6 * qdd_0_p372 + 0.072 * qdd_0_p375);
  const Real qdd_0_p378 = c6 * qdd_0_p370 - s6 * qdd_0_p372 + inverse_D1_p1022 * qdd_0_p377;

  // link 5 (chest2), outward
  const Real n5_y_p1 = w5_x * w5_z + minus_wd5_y;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p5 - 0.04675382692737882 * n5_y_p1 +
      0.069699984375 * minus_a4_y + (c6 * n6_x - s6 * n6_y);

  // link 4 (chest1), outward
  const Real qdd_0_p379 = w4_x * w4_y;

  // link 6 (chest3), bias force
  const Real qdd_0_p380 = qdd_0_p324_lanes[1] - (inverse_D1_p910 * qdd_0_p351 -
      (s22 * qdd_0_p354 + c22 * qdd_0_p353)) + qdd_0_p324_lanes[0] - inverse_D1_p930 * qdd_0_p369;
  const Real qdd_0_p381 = qdd_0_p368 - s21 * qdd_0_p373 + c21 * qdd_0_p374 + inverse_D1_p984 *
      qdd_0_p369;
  const Real qdd_0_p382 = s6 * qdd_0_p380 + c6 * qdd_0_p381;

  // link 5 (chest2), bias force
  const Real qdd_0_p383 = qdd_0_p330 - 0.072 * qdd_0_p382 - inverse_D1_p1020 * qdd_0_p377;

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p3 - (s22 * f22_x + c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a7_x_p2 - f21_z + n6_z_p10_lanes[1] + n6_z_p10_lanes[0];
  const Real f6_y = n6_z_p13 - 6.1665928899999995 * minus_a7_z_p1 - s21 * minus_f21_x + c21 * f21_y;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real n5_x = 0.15637308509675518 * a6_x_p5 - 0.005678398088837119 * n5_y_p1 +
      2.2194301519999997 * minus_a4_y + (n6_z - 0.072 * n5_x_p1);

  // link 4 (chest1), bias force
  const Real qdd_0_p384 = tau[3] - 0.0300000063 * minus_a4_y + 0.03561389675370483 * qdd_0_p379 +
      (n5_y + qdd_0_p378) * c5 + (n5_x + qdd_0_p383) * s5;

  // link 5 (chest2), bias force
  const Real qdd_0_p385 = qdd_0_p382 + inverse_D1_p1005 * qdd_0_p377;

  // link 4 (chest1), bias force
  const Real qdd_0_p386 = s4 * (inverse_D3_p1 * qdd_0_p384 -
      (s5 * qdd_0_p378 - c5 * qdd_0_p383 + 0.21799999999999997 * qdd_0_p385));

  // link 5 (chest2), bias force
  const Real qdd_0_p387 = c6 * qdd_0_p380 - s6 * qdd_0_p381 + inverse_D1_p1033 * qdd_0_p377;
  const Real qdd_0_p388 = qdd_0_p375 + inverse_D1_p1029 * qdd_0_p377;
  const Real qdd_0_p389 = s5 * qdd_0_p387 - c5 * qdd_0_p388;

  // link 6 (chest3), inward
  const Real f5_z = 0.069699984375 * n5_y_p1 - 2.2194301519999997 * a6_x_p5 + n5_x_p1;

  // link 5 (chest2), inward
  const Real n4_x = 0.095783 * wd4_x + 0.005880002159562879 * qdd_0_p379 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);

  // link 6 (chest3), inward
  const Real f5_y = 2.2194301519999997 * a6_x_p3 - 0.069699984375 * (a6_z_p1 + minus_wd4_y) +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_x = f6_z - (0.069699984375 * (n5_z_p1 + a6_x_p2) + 2.2194301519999997 * a6_z_p2);

  // link 5 (chest2), inward
  const Real n4_y_p1 = s5 * f5_y - c5 * f5_x;

  // link 4 (chest1), outward
  const Real n4_y_p2 = qd[3] * qd[3];

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * n4_y_p1 -
      (0.02455520649259034 * minus_wd4_y + 0.005880002159562879 * (a5_y_p1 - n4_y_p2) +
      0.0300000063 * a3_y);

  // link 4 (chest1), inward
  const Real n3_z = 8.419374554 * a3_x - 0.02999999505 * a3_y + (s4 * n4_x + c4 * n4_y);

  // link 1 (calf), inward
  const Real qdd_0_p390 = tau[2] - n3_z;

  // link 3 (hip), bias force
  const Real qdd_0_p391 = qdd_0_p390 - (qdd_0_p386 + c4 *
      (qdd_0_p376 - 0.21799999999999997 * qdd_0_p389 - inverse_D3_p2 * qdd_0_p384));
  const Real qdd_0_p392 = inverse_D1_p1063 * qdd_0_p391 -
      (c4 * (qdd_0_p389 + inverse_D1_p1041 * qdd_0_p384) + s4 *
      (qdd_0_p385 - inverse_D1_p1050 * qdd_0_p384));
  const Real qdd_0_p393 = inverse_D1_p1068 * qdd_0_p384 - (s5 * qdd_0_p388 + c5 * qdd_0_p387) +
      inverse_D1_p1073 * qdd_0_p391;
  const Real qdd_0_p394 = c3 * qdd_0_p392 + s3 * qdd_0_p393;

  // link 5 (chest2), inward
  const Real f4_x = 0.0300000063 * (a5_y_p2 + n4_y_p2) - n4_y_p1;
  const Real f4_y = f5_z - 0.0300000063 * qdd_0_p379;

  // link 3 (hip), outward
  const Real f3_x_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_x_p1 + (c4 * f4_x - s4 * f4_y);

  // link 5 (chest2), inward
  const Real minus_f4_z = 0.0600000126 * minus_wd4_y + (s5 * f5_x + c5 * f5_y);

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_x_p1 + minus_f4_z;

  // link 3 (hip), inward
  const Real n2_z_p1 = c3 * f3_x - s3 * f3_y;
  const Real n2_z = 0.031999971599999996 * a2_y + 24.5839218 * a2_x + (n3_z + 0.422 * n2_z_p1);

  // link 2 (thigh), bias force
  const Real qdd_0_p395 = tau[1] - n2_z - (qdd_0_p390 + 0.422 * qdd_0_p394);
  const Real qdd_0_p396 = c2 * (qdd_0_p394 + inverse_D1_p1080 * qdd_0_p395) - s2 *
      (s3 * qdd_0_p392 - c3 * qdd_0_p393 + inverse_D1_p1084 * qdd_0_p395);

  // link 3 (hip), inward
  const Real f2_x = n2_z_p1 - 0.031999971599999996 * a3_y_p1;
  const Real f2_y = 24.5839218 * a3_y_p1 + (s3 * f3_x + c3 * f3_y);

  // link 1 (calf), bias force
  const Real qdd_0_p397 = tau[0] - 0.1569597827085 * c1 + 299.6743959432 * s1 - tau[1] - 0.434 *
      (c2 * f2_x - s2 * f2_y + qdd_0_p396);

  // link 1 (calf), acceleration
  const Real qdd_0 = inverse_D1 * qdd_0_p397;
  qdd[0] = qdd_0;

  // link 2 (thigh), acceleration
  const Real qdd_1_p1 = 0.434 * qdd_0;
  const Real qdd_1_p2 = c2 * qdd_1_p1;
  const Real qdd_1_p3 = s2 * qdd_1_p1;
  const Real qdd_1 = inverse_D2 * qdd_0_p395 - (inverse_D1_p1080 * qdd_1_p2 - inverse_D1_p1084 *
      qdd_1_p3 + qdd_0);
  qdd[1] = qdd_1;
  const Real qdd_2_p1 = qdd_0 + qdd_1;

  // link 3 (hip), acceleration
  const Real qdd_2_p2 = qdd_1_p2 + 0.422 * qdd_2_p1;
  const Real qdd_2_p3 = c3 * qdd_2_p2 - s3 * qdd_1_p3;
  const Real qdd_2_p4 = s3 * qdd_2_p2 + c3 * qdd_1_p3;
  const Real qdd_2 = inverse_D3 * qdd_0_p391 - (inverse_D1_p1063 * qdd_2_p3 + inverse_D1_p1073 *
      qdd_2_p4 + qdd_2_p1);
  qdd[2] = qdd_2;
  const Real qdd_3_p1 = qdd_2_p1 + qdd_2;

  // link 4 (chest1), acceleration
  const Real qdd_3_p2 = s4 * qdd_3_p1;
  const Real qdd_3_p3 = c4 * qdd_3_p1;
  const Real qdd_3_p4 = s4 * qdd_2_p3;
  const Real qdd_3_p5 = c4 * qdd_2_p3;
  const Real qdd_3_p6 = inverse_D1_p1050 * qdd_3_p4 - inverse_D1_p1041 * qdd_3_p5 +
      inverse_D1_p1068 * qdd_2_p4 + (inverse_D3_p1 * qdd_3_p2 - inverse_D3_p2 * qdd_3_p3);
  const Real qdd_3 = inverse_D4 * qdd_0_p384 - qdd_3_p6;
  qdd[3] = qdd_3;

  // link 5 (chest2), acceleration
  const Real qdd_4_p1 = c5 * qdd_3_p2 - s5 * qdd_3;
  const Real qdd_4_p2 = s5 * qdd_3_p2 + c5 * qdd_3;
  const Real qdd_4_p3 = qdd_3_p5 + 0.21799999999999997 * qdd_3_p3;
  const Real qdd_4_p4 = c5 * qdd_4_p3 - s5 * qdd_2_p4;
  const Real qdd_4_p5 = s5 * qdd_4_p3 + c5 * qdd_2_p4;
  const Real qdd_4_p6 = qdd_3_p4 + 0.21799999999999997 * qdd_3_p2;
  const Real qdd_4_p7 = inverse_D1_p1029 * qdd_4_p4 - inverse_D1_p1033 * qdd_4_p5 -
      inverse_D1_p1005 * qdd_4_p6 + (qdd_3_p3 - (inverse_D1_p1020 * qdd_4_p1 + inverse_D1_p1022 *
      qdd_4_p2));
  const Real qdd_4 = inverse_D5 * qdd_0_p377 - qdd_4_p7;
  qdd[4] = qdd_4;

  // link 6 (chest3), acceleration
  const Real qdd_5_p1 = qdd_4_p6 + 0.072 * qdd_4_p1;
  const Real qdd_5_p2 = c6 * qdd_4_p5 + s6 * qdd_5_p1;
  const Real qdd_5_p3 = s6 * qdd_4_p5 - c6 * qdd_5_p1;

  // link 5 (chest2), acceleration
  const Real qdd_5_p4 = qdd_3_p3 + qdd_4;

  // link 6 (chest3), acceleration
  const Real qdd_5_p5 = qdd_4_p4 + 0.072 * qdd_5_p4;
  const Real qdd_5_p6 = s6 * qdd_5_p4 - c6 * qdd_4_p2;
  const Real qdd_5_p7 = s6 * qdd_4_p2 + c6 * qdd_5_p4;
  const Real qdd_5_p8 = inverse_D1_p930 * qdd_5_p2 + inverse_D1_p984 * qdd_5_p3 + inverse_D1_p993 *
      qdd_5_p5 + (inverse_D5_p16 * qdd_5_p6 + inverse_D5_p22 * qdd_5_p7 + qdd_4_p1);
  const Real qdd_5 = inverse_D6 * qdd_0_p369 - qdd_5_p8;
  qdd[5] = qdd_5;
  const Real qdd_6_p1 = qdd_4_p1 + qdd_5;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6_p2 = qdd_5_p2 + 0.18 * qdd_6_p1;
  const Real qdd_6_p3 = qdd_5_p5 + 0.226 * qdd_5_p7;
  const Real qdd_6_p4 = qdd_6_p3 + 0.18 * qdd_5_p6;
  const Real qdd_6_p5 = c7 * qdd_6_p4 - s7 * qdd_6_p2;
  const Real qdd_6_p6 = c7 * qdd_6_p2 + s7 * qdd_6_p4;
  const Real qdd_6_p7 = qdd_5_p3 - 0.226 * qdd_6_p1;
  const Real qdd_6_p8 = s7 * qdd_5_p6 + c7 * qdd_6_p1;
  const Real qdd_6_p9 = c7 * qdd_5_p6 - s7 * qdd_6_p1;
  const Real qdd_6_p10 = inverse_D1_p679_lanes[0] * qdd_6_p5 - inverse_D1_p639_lanes[0] * qdd_6_p6 +
      inverse_D1_p837_lanes[0] * qdd_6_p7 + (qdd_0_p307_lanes[0] * qdd_6_p8 +
      inverse_D6_p5_lanes[0] * qdd_6_p9 + qdd_5_p7);
  const Lanes<2> qdd_6_p11_lanes = inverse_D7_lanes * qdd_0_p247_lanes;
  const Real qdd_6 = qdd_6_p11_lanes[0] - qdd_6_p10;
  qdd[6] = qdd_6;
  const Real qdd_7_p1 = qdd_5_p7 + qdd_6;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7_p2 = c8 * qdd_7_p1 - s8 * qdd_6_p9;
  const Real qdd_7_p3 = c8 * qdd_6_p9 + s8 * qdd_7_p1;
  const Real qdd_7_p4 = s8 * qdd_6_p6 + c8 * qdd_6_p7;
  const Real qdd_7_p5 = s8 * qdd_6_p7 - c8 * qdd_6_p6;
  const Real qdd_7_p6 = inverse_D1_p609_lanes[0] * qdd_7_p4 - inverse_D1_p555_lanes[0] * qdd_7_p5 +
      inverse_D1_p657_lanes[0] * qdd_6_p5 + (inverse_D7_p1_lanes[0] * qdd_7_p2 -
      qdd_0_p235_lanes[0] * qdd_7_p3 + qdd_6_p8);
  const Lanes<2> qdd_7_p7_lanes = inverse_D8_lanes * qdd_0_p203_lanes;
  const Real qdd_7 = qdd_7_p7_lanes[0] - qdd_7_p6;
  qdd[7] = qdd_7;
  const Real qdd_8_p1 = qdd_6_p8 + qdd_7;

  // link 9 (left_upperarm), acceleration
  const Real qdd_8_p2 = s9 * qdd_7_p2 + c9 * qdd_8_p1;
  const Real qdd_8_p3 = c9 * qdd_7_p2 - s9 * qdd_8_p1;
  const Real qdd_8_p4 = c9 * qdd_7_p4 - s9 * qdd_6_p5;
  const Real qdd_8_p5 = s9 * qdd_7_p4 + c9 * qdd_6_p5;
  const Real qdd_8_p6 = inverse_D1_p577_lanes[0] * qdd_8_p4 - inverse_D1_p569_lanes[0] * qdd_8_p5 +
      inverse_D1_p515_lanes[0] * qdd_7_p5 + (inverse_D1_p259_lanes[0] * qdd_8_p2 +
      inverse_D1_p401_lanes[0] * qdd_8_p3 - qdd_7_p3);
  const Lanes<2> qdd_8_p7_lanes = inverse_D9_lanes * qdd_0_p151_lanes;
  const Real qdd_8 = qdd_8_p7_lanes[0] - qdd_8_p6;
  qdd[8] = qdd_8;
  const Real qdd_9_p1 = qdd_8 - qdd_7_p3;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p2 = c10 * qdd_8_p2 - s10 * qdd_9_p1;
  const Real qdd_9_p3 = s10 * qdd_8_p2 + c10 * qdd_9_p1;
  const Real qdd_9_p4 = qdd_8_p5 - 0.282 * qdd_8_p3;
  const Real qdd_9_p5 = c10 * qdd_9_p4 + s10 * qdd_7_p5;
  const Real qdd_9_p6 = c10 * qdd_7_p5 - s10 * qdd_9_p4;
  const Real qdd_9_p7 = qdd_8_p4 + 0.282 * qdd_8_p2;
  const Real qdd_9_p8 = inverse_D1_p317_lanes[0] * qdd_9_p5 + inverse_D1_p363_lanes[0] * qdd_9_p6 +
      inverse_D1_p191_lanes[0] * qdd_9_p7 + (inverse_D1_p231_lanes[0] * qdd_9_p2 -
      inverse_D1_p221_lanes[0] * qdd_9_p3 + qdd_8_p3);
  const Lanes<2> qdd_9_p9_lanes = inverse_D10_lanes * qdd_0_p113_lanes;
  const Real qdd_9 = qdd_9_p9_lanes[0] - qdd_9_p8;
  qdd[9] = qdd_9;
  const Real qdd_10_p1 = qdd_8_p3 + qdd_9;

  // link 11 (left_wrist1), acceleration
  const Real qdd_10_p2 = c11 * qdd_9_p2 + s11 * qdd_10_p1;
  const Real qdd_10_p3 = c11 * qdd_10_p1 - s11 * qdd_9_p2;
  const Real qdd_10_p4 = c11 * qdd_9_p7 - s11 * qdd_9_p5;
  const Real qdd_10_p5 = c11 * qdd_9_p5 + s11 * qdd_9_p7;
  const Real qdd_10_p6 = inverse_D1_p119_lanes[0] * qdd_10_p4 - inverse_D1_p55_lanes[0] *
      qdd_10_p5 - inverse_D1_p337_lanes[0] * qdd_9_p6 +
      (inverse_D10_p1_lanes[0] * qdd_10_p2 + inverse_D10_p8_lanes[0] * qdd_10_p3 + qdd_9_p3);
  const Lanes<2> qdd_10_p7_lanes = inverse_D11_lanes * qdd_0_p49_lanes;
  const Real qdd_10 = qdd_10_p7_lanes[0] - qdd_10_p6;
  qdd[10] = qdd_10;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p1 = qdd_10_p5 - 0.269 * qdd_10_p3;
  const Real qdd_11_p2 = c12 * qdd_9_p6 - s12 * qdd_11_p1;
  const Real qdd_11_p3 = qdd_10_p4 + 0.269 * qdd_10_p2;
  const Real qdd_11_p4 = inverse_D1_p35_lanes[0] * (c12 * qdd_11_p1 + s12 * qdd_9_p6) +
      inverse_D1_p11_lanes[0] * qdd_11_p2 + inverse_D1_p61_lanes[0] * qdd_11_p3;

  // link 11 (left_wrist1), acceleration
  const Real qdd_11_p5 = qdd_9_p3 + qdd_10;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p6 = s12 * qdd_10_p2 + c12 * qdd_11_p5;
  const Lanes<2> qdd_11_p7_lanes = inverse_D12_lanes * qdd_0_p15_lanes;
  const Real qdd_11 = qdd_11_p7_lanes[0] - (qdd_11_p4 +
      (qdd_10_p3 - inverse_D11_p1_lanes[0] * qdd_11_p6));
  qdd[11] = qdd_11;
  const Real qdd_12_p1 = qdd_10_p3 + qdd_11;

  // link 13 (left_hand), acceleration
  const Real qdd_12_p2 = 0.04672761636452121 * (s13 * qdd_11_p6 + c13 * qdd_12_p1) -
      0.11533812622014242 * (s13 * qdd_12_p1 - c13 * qdd_11_p6);
  const Real qdd_12_p3 = 17.32841575379867 * (c13 * qdd_11_p3 - s13 * qdd_11_p2) -
      (-3.0523172236718206) * (c13 * qdd_11_p2 + s13 * qdd_11_p3);
  const Lanes<2> qdd_12_p4_lanes = 1065.380700001509 * qdd_0_p3_lanes;
  qdd[12] = qdd_12_p4_lanes[0] - (qdd_12_p3 + (qdd_12_p2 + (c12 * qdd_10_p2 - s12 * qdd_11_p5)));

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p2 = qdd_5_p2 + (-0.18) * qdd_6_p1;
  const Real qdd_13_p3 = qdd_6_p3 + (-0.18) * qdd_5_p6;
  const Real qdd_13_p4 = c14 * qdd_13_p3 - s14 * qdd_13_p2;
  const Real qdd_13_p5 = c14 * qdd_13_p2 + s14 * qdd_13_p3;
  const Real qdd_13_p6 = s14 * qdd_5_p6 + c14 * qdd_6_p1;
  const Real qdd_13_p7 = c14 * qdd_5_p6 - s14 * qdd_6_p1;
  const Real qdd_13_p8 = inverse_D1_p679_lanes[1] * qdd_13_p4 - inverse_D1_p639_lanes[1] *
      qdd_13_p5 + inverse_D1_p837_lanes[1] * qdd_6_p7 +
      (qdd_0_p307_lanes[1] * qdd_13_p6 + inverse_D6_p5_lanes[1] * qdd_13_p7 + qdd_5_p7);
  const Real qdd_13 = qdd_6_p11_lanes[1] - qdd_13_p8;
  qdd[13] = qdd_13;
  const Real qdd_14_p2 = qdd_5_p7 + qdd_13;

  // link 15 (right_shoulder2), acceleration
  const Real qdd_14_p3 = c15 * qdd_14_p2 - s15 * qdd_13_p7;
  const Real qdd_14_p4 = c15 * qdd_13_p7 + s15 * qdd_14_p2;
  const Real qdd_14_p5 = s15 * qdd_13_p5 + c15 * qdd_6_p7;
  const Real qdd_14_p6 = s15 * qdd_6_p7 - c15 * qdd_13_p5;
  const Real qdd_14_p7 = inverse_D1_p609_lanes[1] * qdd_14_p5 - inverse_D1_p555_lanes[1] *
      qdd_14_p6 + inverse_D1_p657_lanes[1] * qdd_13_p4 +
      (inverse_D7_p1_lanes[1] * qdd_14_p3 - qdd_0_p235_lanes[1] * qdd_14_p4 + qdd_13_p6);
  const Real qdd_14 = qdd_7_p7_lanes[1] - qdd_14_p7;
  qdd[14] = qdd_14;
  const Real qdd_15_p2 = qdd_13_p6 + qdd_14;

  // link 16 (right_upperarm), acceleration
  const Real qdd_15_p3 = s16 * qdd_14_p3 + c16 * qdd_15_p2;
  const Real qdd_15_p4 = c16 * qdd_14_p3 - s16 * qdd_15_p2;
  const Real qdd_15_p5 = c16 * qdd_14_p5 - s16 * qdd_13_p4;
  const Real qdd_15_p6 = s16 * qdd_14_p5 + c16 * qdd_13_p4;
  const Real qdd_15_p7 = inverse_D1_p577_lanes[1] * qdd_15_p5 - inverse_D1_p569_lanes[1] *
      qdd_15_p6 + inverse_D1_p515_lanes[1] * qdd_14_p6 +
      (inverse_D1_p259_lanes[1] * qdd_15_p3 + inverse_D1_p401_lanes[1] * qdd_15_p4 - qdd_14_p4);
  const Real qdd_15 = qdd_8_p7_lanes[1] - qdd_15_p7;
  qdd[15] = qdd_15;
  const Real qdd_16_p2 = qdd_15 - qdd_14_p4;

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16_p3 = c17 * qdd_15_p3 - s17 * qdd_16_p2;
  const Real qdd_16_p4 = s17 * qdd_15_p3 + c17 * qdd_16_p2;
  const Real qdd_16_p5 = qdd_15_p6 - 0.282 * qdd_15_p4;
  const Real qdd_16_p6 = c17 * qdd_16_p5 + s17 * qdd_14_p6;
  const Real qdd_16_p7 = c17 * qdd_14_p6 - s17 * qdd_16_p5;
  const Real qdd_16_p8 = qdd_15_p5 + 0.282 * qdd_15_p3;
  const Real qdd_16_p9 = inverse_D1_p317_lanes[1] * qdd_16_p6 + inverse_D1_p363_lanes[1] *
      qdd_16_p7 + inverse_D1_p191_lanes[1] * qdd_16_p8 +
      (inverse_D1_p231_lanes[1] * qdd_16_p3 - inverse_D1_p221_lanes[1] * qdd_16_p4 + qdd_15_p4);
  const Real qdd_16 = qdd_9_p9_lanes[1] - qdd_16_p9;
  qdd[16] = qdd_16;
  const Real qdd_17_p2 = qdd_15_p4 + qdd_16;

  // link 18 (right_wrist1), acceleration
  const Real qdd_17_p3 = c18 * qdd_16_p3 + s18 * qdd_17_p2;
  const Real qdd_17_p4 = c18 * qdd_17_p2 - s18 * qdd_16_p3;
  const Real qdd_17_p5 = c18 * qdd_16_p8 - s18 * qdd_16_p6;
  const Real qdd_17_p6 = c18 * qdd_16_p6 + s18 * qdd_16_p8;
  const Real qdd_17_p7 = inverse_D1_p119_lanes[1] * qdd_17_p5 - inverse_D1_p55_lanes[1] *
      qdd_17_p6 - inverse_D1_p337_lanes[1] * qdd_16_p7 +
      (inverse_D10_p1_lanes[1] * qdd_17_p3 + inverse_D10_p8_lanes[1] * qdd_17_p4 + qdd_16_p4);
  const Real qdd_17 = qdd_10_p7_lanes[1] - qdd_17_p7;
  qdd[17] = qdd_17;

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p2 = qdd_17_p6 - 0.269 * qdd_17_p4;
  const Real qdd_18_p3 = c19 * qdd_16_p7 - s19 * qdd_18_p2;
  const Real qdd_18_p4 = qdd_17_p5 + 0.269 * qdd_17_p3;
  const Real qdd_18_p5 = inverse_D1_p35_lanes[1] * (c19 * qdd_18_p2 + s19 * qdd_16_p7) +
      inverse_D1_p11_lanes[1] * qdd_18_p3 + inverse_D1_p61_lanes[1] * qdd_18_p4;

  // link 18 (right_wrist1), acceleration
  const Real qdd_18_p6 = qdd_16_p4 + qdd_17;

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p7 = s19 * qdd_17_p3 + c19 * qdd_18_p6;
  const Real qdd_18 = qdd_11_p7_lanes[1] - (qdd_18_p5 +
      (qdd_17_p4 - inverse_D11_p1_lanes[1] * qdd_18_p7));
  qdd[18] = qdd_18;
  const Real qdd_19_p2 = qdd_17_p4 + qdd_18;

  // link 20 (right_hand), acceleration
  const Real qdd_19_p3 = (-0.04672761636452121) * (s20 * qdd_18_p7 + c20 * qdd_19_p2) -
      0.11533812622014242 * (s20 * qdd_19_p2 - c20 * qdd_18_p7);
  const Real qdd_19_p4 = 17.32841575379867 * (c20 * qdd_18_p4 - s20 * qdd_18_p3) -
      3.0523172236718206 * (c20 * qdd_18_p3 + s20 * qdd_18_p4);
  qdd[19] = qdd_12_p4_lanes[1] - (qdd_19_p4 + (qdd_19_p3 + (c19 * qdd_17_p3 - s19 * qdd_18_p6)));

  // link 21 (neck), acceleration
  const Real qdd_20_p1 = s21 * qdd_5_p7 + c21 * qdd_6_p1;
  const Real qdd_20_p2 = c21 * qdd_5_p7 - s21 * qdd_6_p1;
  const Real qdd_20_p3 = c21 * qdd_5_p3 - s21 * qdd_5_p5;
  const Real qdd_20_p4 = s21 * qdd_5_p3 + c21 * qdd_5_p5;
  const Real qdd_20_p5 = inverse_D1_p977 * qdd_20_p3 - inverse_D1_p974 * qdd_20_p4 +
      inverse_D1_p910 * qdd_5_p2 - (inverse_D6_p34 * qdd_20_p1 + inverse_D6_p39 * qdd_20_p2 +
      qdd_5_p6);
  const Real qdd_20 = inverse_D21 * qdd_0_p351 - qdd_20_p5;
  qdd[20] = qdd_20;
  const Real qdd_21_p1 = qdd_20 - qdd_5_p6;

  // link 22 (head), acceleration
  const Real qdd_21_p2 = c22 * qdd_20_p1 - s22 * qdd_21_p1;
  const Real qdd_21_p3 = s22 * qdd_20_p1 + c22 * qdd_21_p1;
  const Real qdd_21_p4 = qdd_20_p4 + 0.394 * qdd_20_p2;
  const Real qdd_21_p5 = c22 * qdd_21_p4 - s22 * qdd_5_p2;
  const Real qdd_21_p6 = qdd_20_p3 - 0.394 * qdd_20_p1;
  const Real qdd_21_p7 = inverse_D1_p876 * qdd_21_p5 - inverse_D1_p891 *
      (s22 * qdd_21_p4 + c22 * qdd_5_p2) + inverse_D1_p911 * qdd_21_p6;
  const Real qdd_21 = inverse_D22 * qdd_0_p338 - (qdd_21_p7 +
      (qdd_20_p2 - (inverse_D21_p12 * qdd_21_p2 + inverse_D21_p1 * qdd_21_p3)));
  qdd[21] = qdd_21;

  // link 23 (left_eye), acceleration
  const Real qdd_22_p1 = qdd_21_p6 + 0.095 * qdd_21_p3;

  // link 22 (head), acceleration
  const Real qdd_22_p2 = qdd_20_p2 + qdd_21;

  // link 23 (left_eye), acceleration
  const Real qdd_22_p3 = 27.027027027027028 * (c23 * qdd_22_p1 - s23 *
      (qdd_21_p5 - 0.032 * qdd_21_p3)) + (qdd_21_p3 - 3.1081081081081083 *
      (c23 * qdd_21_p2 + s23 * qdd_22_p2));
  qdd[22] = 108108.1081081081 * qdd_0_p333 - qdd_22_p3;

  // link 24 (right_eye), acceleration
  const Real qdd_23_p1 = 27.027027027027028 * (c24 * qdd_22_p1 - s24 *
      (qdd_21_p5 - (-0.032) * qdd_21_p3)) + (qdd_21_p3 - 3.1081081081081083 *
      (c24 * qdd_21_p2 + s24 * qdd_22_p2));
  qdd[23] = 108108.1081081081 * qdd_0_p332 - qdd_23_p1;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
