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
  const Lanes<2> Lambda_0_11_p5_lanes = detail::make_pack<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.001742099791326752, 0.001742099791326752) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> Lambda_0_11_p7_lanes = detail::make_pack<Real>(c13, c20) * Lambda_0_11_p5_lanes;
  const Lanes<2> Lambda_0_11_p9_lanes = 0.0006340258712020409 + Lambda_0_11_p7_lanes;
  const Lanes<2> inverse_D12_p3_lanes = detail::make_pack<Real>((-0.0007660844555829042),
      (-0.0007660844555829042)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.0002628975791811551, (-0.0002628975791811551)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p4_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p3_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (inverse_D12_p4_lanes -
      detail::make_pack<Real>((-0.0010519177038056625), (-0.0010519177038056625)));
  const Lanes<2> Lambda_0_11_p11_lanes = Lambda_0_11_p9_lanes * inverse_D12_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p15_lanes = detail::make_pack<Real>((-0.00013384878959057754),
      0.00013384878959057754) + detail::make_pack<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> Lambda_0_11_p19_lanes = detail::make_pack<Real>(s13, s20) * Lambda_0_11_p5_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p23_lanes = detail::make_pack<Real>((-0.00033044389597753786),
      0.00033044389597753786) + Lambda_0_11_p19_lanes + Lambda_0_11_p15_lanes *
      Lambda_0_11_p11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p33_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(s13, s20) - 0.01626499875 *
      detail::make_pack<Real>(c13, c20) - 0.0006000000000000001;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p35_lanes = Lambda_0_11_p33_lanes * inverse_D12_lanes;
  const Lanes<2> Lambda_0_11_p45_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(c13, c20) + 0.01626499875 *
      detail::make_pack<Real>(s13, s20) - Lambda_0_11_p15_lanes * Lambda_0_11_p35_lanes;
  const Lanes<2> Lambda_0_11_p49_lanes = detail::make_pack<Real>(s12, s19) * Lambda_0_11_p23_lanes +
      detail::make_pack<Real>(c12, c19) * Lambda_0_11_p45_lanes;
  const Lanes<2> Lambda_0_11_p51_lanes = detail::make_pack<Real>(c12, c19) * Lambda_0_11_p49_lanes;
  const Lanes<2> Lambda_0_11_p53_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      Lambda_0_11_p51_lanes;
  const Lanes<2> inverse_D11_p1_lanes = Lambda_0_11_p15_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D11_p4_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes -
      Lambda_0_11_p15_lanes * inverse_D11_p1_lanes;
  const Lanes<2> inverse_D11_p6_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p4_lanes);
  const Lanes<2> inverse_D11_p7_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p6_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p4_lanes + inverse_D11_p7_lanes));
  const Lanes<2> Lambda_0_11_p55_lanes = Lambda_0_11_p53_lanes * inverse_D11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p59_lanes = Lambda_0_11_p19_lanes -
      detail::make_pack<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p61_lanes = Lambda_0_11_p59_lanes * inverse_D12_lanes;
  const Lanes<2> Lambda_0_11_p67_lanes = Lambda_0_11_p7_lanes -
      detail::make_pack<Real>(0.002376125662528793, 0.002376125662528793) - Lambda_0_11_p15_lanes *
      Lambda_0_11_p61_lanes;
  const Lanes<2> Lambda_0_11_p73_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * Lambda_0_11_p67_lanes;
  const Lanes<2> Lambda_0_11_p79_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p6_lanes + 0.269 * Lambda_0_11_p73_lanes);
  const Lanes<2> Lambda_0_11_p83_lanes = detail::make_pack<Real>(s12, s19) * Lambda_0_11_p49_lanes;
  const Lanes<2> Lambda_0_11_p85_lanes = Lambda_0_11_p33_lanes * Lambda_0_11_p61_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p95_lanes = detail::make_pack<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.27310176737964387), (-0.27310176737964387)) *
      detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p101_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p95_lanes - detail::make_pack<Real>((-0.04964593582762564), 0.04964593582762564) -
      Lambda_0_11_p9_lanes * Lambda_0_11_p61_lanes;
  const Lanes<2> Lambda_0_11_p105_lanes = detail::make_pack<Real>(c12, c19) *
      Lambda_0_11_p85_lanes + detail::make_pack<Real>(s12, s19) * Lambda_0_11_p101_lanes;
  const Lanes<2> Lambda_0_11_p107_lanes = 0.269 * Lambda_0_11_p105_lanes;
  const Lanes<2> Lambda_0_11_p109_lanes = Lambda_0_11_p83_lanes + Lambda_0_11_p107_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p111_lanes = Lambda_0_11_p79_lanes * Lambda_0_11_p55_lanes -
      Lambda_0_11_p109_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p115_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 *
      Lambda_0_11_p51_lanes;
  const Lanes<2> Lambda_0_11_p117_lanes = 6e-04 - Lambda_0_11_p73_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p119_lanes = Lambda_0_11_p117_lanes * inverse_D11_lanes;
  const Lanes<2> Lambda_0_11_p123_lanes = Lambda_0_11_p107_lanes - Lambda_0_11_p115_lanes *
      Lambda_0_11_p119_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p133_lanes = detail::make_pack<Real>(s13, s20) * Lambda_0_11_p95_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p137_lanes = detail::make_pack<Real>(0.008744893195371809,
      0.008744893195371809) + Lambda_0_11_p133_lanes + Lambda_0_11_p9_lanes * Lambda_0_11_p11_lanes;
  const Lanes<2> Lambda_0_11_p139_lanes = Lambda_0_11_p33_lanes * Lambda_0_11_p35_lanes;
  const Lanes<2> Lambda_0_11_p145_lanes = Lambda_0_11_p33_lanes * Lambda_0_11_p11_lanes;
  const Lanes<2> Lambda_0_11_p151_lanes = detail::make_pack<Real>(c12, c19) *
      (2.0 * Lambda_0_11_p145_lanes) - detail::make_pack<Real>(s12, s19) *
      (Lambda_0_11_p137_lanes - Lambda_0_11_p139_lanes);
  const Lanes<2> Lambda_0_11_p153_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p151_lanes;
  const Lanes<2> Lambda_0_11_p155_lanes = Lambda_0_11_p153_lanes - Lambda_0_11_p139_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p159_lanes = Lambda_0_11_p115_lanes * Lambda_0_11_p55_lanes - 0.269 *
      Lambda_0_11_p155_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p167_lanes = Lambda_0_11_p133_lanes - 0.2818466605750157 -
      Lambda_0_11_p59_lanes * Lambda_0_11_p61_lanes;
  const Lanes<2> Lambda_0_11_p175_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p67_lanes - 0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> Lambda_0_11_p177_lanes = 0.269 * Lambda_0_11_p167_lanes - Lambda_0_11_p175_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p179_lanes = Lambda_0_11_p177_lanes - Lambda_0_11_p79_lanes *
      Lambda_0_11_p119_lanes;
  const Lanes<2> Lambda_0_11_p185_lanes = detail::make_pack<Real>(s11, s18) *
      (Lambda_0_11_p111_lanes - Lambda_0_11_p123_lanes) + detail::make_pack<Real>(c11, c18) *
      (Lambda_0_11_p159_lanes + Lambda_0_11_p179_lanes);
  const Lanes<2> Lambda_0_11_p187_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_0_11_p185_lanes;
  const Lanes<2> Lambda_0_11_p189_lanes = Lambda_0_11_p123_lanes + Lambda_0_11_p187_lanes;
  const Lanes<2> inverse_D10_p1_lanes = Lambda_0_11_p79_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p7_lanes = 0.000131 - inverse_D11_p7_lanes + 0.269 *
      (Lambda_0_11_p177_lanes - Lambda_0_11_p175_lanes) - Lambda_0_11_p79_lanes *
      inverse_D10_p1_lanes;
  const Lanes<2> inverse_D10_p8_lanes = Lambda_0_11_p115_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p12_lanes = 0.0001098 + 0.07236100000000001 * Lambda_0_11_p155_lanes -
      Lambda_0_11_p115_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p18_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      Lambda_0_11_p109_lanes - Lambda_0_11_p79_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p19_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> inverse_D10_p21_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p7_lanes - inverse_D10_p12_lanes) + inverse_D10_p19_lanes *
      inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p22_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p21_lanes;
  const Lanes<2> inverse_D10_p24_lanes = 0.060888541114265754 +
      (inverse_D10_p12_lanes + inverse_D10_p22_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_0_11_p191_lanes = Lambda_0_11_p189_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p195_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * Lambda_0_11_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p203_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p21_lanes -
      inverse_D10_p18_lanes);
  const Lanes<2> Lambda_0_11_p207_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p185_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p213_lanes = 0.28049749700000004 +
      (Lambda_0_11_p207_lanes - Lambda_0_11_p159_lanes) - Lambda_0_11_p203_lanes *
      Lambda_0_11_p191_lanes;
  const Lanes<2> Lambda_0_11_p217_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p195_lanes - detail::make_pack<Real>(s10, s17) * Lambda_0_11_p213_lanes;
  const Lanes<2> Lambda_0_11_p221_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_0_11_p225_lanes = 0.0001499998887063 + Lambda_0_11_p203_lanes *
      Lambda_0_11_p221_lanes;
  const Lanes<2> Lambda_0_11_p227_lanes = 2.0 * detail::make_pack<Real>(c10, c17);
  const Lanes<2> Lambda_0_11_p231_lanes = Lambda_0_11_p203_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p239_lanes = 0.06060754126741261 +
      (inverse_D10_p7_lanes - inverse_D10_p22_lanes) - Lambda_0_11_p203_lanes *
      Lambda_0_11_p231_lanes;
  const Lanes<2> Lambda_0_11_p243_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_0_11_p249_lanes = Lambda_0_11_p227_lanes * Lambda_0_11_p225_lanes -
      detail::make_pack<Real>(s10, s17) * (Lambda_0_11_p239_lanes - Lambda_0_11_p243_lanes);
  const Lanes<2> Lambda_0_11_p257_lanes = 0.282 * Lambda_0_11_p217_lanes -
      (Lambda_0_11_p225_lanes - detail::make_pack<Real>(c10, c17) * Lambda_0_11_p249_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D9_p1_lanes = detail::make_pack<Real>(s10, s17) * Lambda_0_11_p249_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (Lambda_0_11_p243_lanes - inverse_D9_p1_lanes));
  const Lanes<2> Lambda_0_11_p259_lanes = Lambda_0_11_p257_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p261_lanes = Lambda_0_11_p257_lanes * Lambda_0_11_p259_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p267_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p213_lanes + detail::make_pack<Real>(s10, s17) * Lambda_0_11_p195_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p273_lanes = Lambda_0_11_p155_lanes - Lambda_0_11_p53_lanes *
      Lambda_0_11_p55_lanes;
  const Lanes<2> Lambda_0_11_p277_lanes = Lambda_0_11_p167_lanes - Lambda_0_11_p117_lanes *
      Lambda_0_11_p119_lanes;
  const Lanes<2> Lambda_0_11_p285_lanes = Lambda_0_11_p53_lanes * Lambda_0_11_p119_lanes -
      Lambda_0_11_p105_lanes;
  const Lanes<2> Lambda_0_11_p289_lanes = detail::make_pack<Real>(s11, s18) *
      (Lambda_0_11_p273_lanes - Lambda_0_11_p277_lanes) + inverse_D10_p19_lanes *
      Lambda_0_11_p285_lanes;
  const Lanes<2> Lambda_0_11_p291_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_0_11_p289_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p295_lanes = Lambda_0_11_p277_lanes + Lambda_0_11_p291_lanes -
      Lambda_0_11_p189_lanes * Lambda_0_11_p191_lanes;
  const Lanes<2> Lambda_0_11_p299_lanes = Lambda_0_11_p267_lanes + 0.282 * Lambda_0_11_p295_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p311_lanes = 0.0019585440854647937 +
      (Lambda_0_11_p239_lanes + inverse_D9_p1_lanes + 0.282 *
      (Lambda_0_11_p267_lanes + Lambda_0_11_p299_lanes)) - Lambda_0_11_p261_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p315_lanes = Lambda_0_11_p207_lanes - Lambda_0_11_p179_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p317_lanes = Lambda_0_11_p315_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p319_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * Lambda_0_11_p317_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p325_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p85_lanes - detail::make_pack<Real>(c12, c19) * Lambda_0_11_p101_lanes;
  const Lanes<2> Lambda_0_11_p335_lanes = Lambda_0_11_p83_lanes - Lambda_0_11_p23_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p337_lanes = Lambda_0_11_p335_lanes * inverse_D11_lanes;
  const Lanes<2> Lambda_0_11_p341_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      (0.269 * Lambda_0_11_p325_lanes - (Lambda_0_11_p51_lanes - Lambda_0_11_p45_lanes)) -
      Lambda_0_11_p79_lanes * Lambda_0_11_p337_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p349_lanes = Lambda_0_11_p145_lanes -
      detail::make_pack<Real>(c12, c19) * Lambda_0_11_p151_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p355_lanes = 0.269 * Lambda_0_11_p349_lanes - 6e-04 -
      Lambda_0_11_p115_lanes * Lambda_0_11_p337_lanes;
  const Lanes<2> Lambda_0_11_p361_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * Lambda_0_11_p341_lanes +
      detail::make_pack<Real>(c11, c18) * Lambda_0_11_p355_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p363_lanes = Lambda_0_11_p361_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p373_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p341_lanes - detail::make_pack<Real>(s11, s18) * Lambda_0_11_p355_lanes +
      Lambda_0_11_p203_lanes * Lambda_0_11_p363_lanes;
  const Lanes<2> Lambda_0_11_p383_lanes = Lambda_0_11_p111_lanes - Lambda_0_11_p187_lanes -
      Lambda_0_11_p203_lanes * Lambda_0_11_p317_lanes;
  const Lanes<2> Lambda_0_11_p385_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * Lambda_0_11_p363_lanes;
  const Lanes<2> Lambda_0_11_p391_lanes = detail::make_pack<Real>(c10, c17) *
      (Lambda_0_11_p319_lanes + Lambda_0_11_p373_lanes) - detail::make_pack<Real>(s10, s17) *
      (Lambda_0_11_p383_lanes + Lambda_0_11_p385_lanes);
  const Lanes<2> Lambda_0_11_p393_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p391_lanes;
  const Lanes<2> Lambda_0_11_p395_lanes = Lambda_0_11_p373_lanes - Lambda_0_11_p393_lanes;
  const Lanes<2> Lambda_0_11_p399_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * Lambda_0_11_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p401_lanes = Lambda_0_11_p399_lanes * inverse_D9_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p409_lanes = Lambda_0_11_p53_lanes * Lambda_0_11_p337_lanes -
      Lambda_0_11_p349_lanes;
  const Lanes<2> Lambda_0_11_p415_lanes = Lambda_0_11_p325_lanes - Lambda_0_11_p117_lanes *
      Lambda_0_11_p337_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p421_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p409_lanes - detail::make_pack<Real>(s11, s18) * Lambda_0_11_p415_lanes +
      Lambda_0_11_p315_lanes * Lambda_0_11_p363_lanes;
  const Lanes<2> Lambda_0_11_p429_lanes = Lambda_0_11_p273_lanes - Lambda_0_11_p291_lanes -
      Lambda_0_11_p315_lanes * Lambda_0_11_p317_lanes;
  const Lanes<2> Lambda_0_11_p439_lanes = Lambda_0_11_p137_lanes + Lambda_0_11_p153_lanes +
      Lambda_0_11_p335_lanes * Lambda_0_11_p337_lanes + Lambda_0_11_p361_lanes *
      Lambda_0_11_p363_lanes;
  const Lanes<2> Lambda_0_11_p445_lanes = Lambda_0_11_p227_lanes * Lambda_0_11_p421_lanes -
      detail::make_pack<Real>(s10, s17) * (Lambda_0_11_p429_lanes + Lambda_0_11_p439_lanes);
  const Lanes<2> Lambda_0_11_p447_lanes = detail::make_pack<Real>(s10, s17) *
      Lambda_0_11_p445_lanes;
  const Lanes<2> Lambda_0_11_p449_lanes = Lambda_0_11_p429_lanes + Lambda_0_11_p447_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p455_lanes = 0.0008177492704690715 + 0.07952399999999998 *
      Lambda_0_11_p449_lanes - Lambda_0_11_p399_lanes * Lambda_0_11_p401_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p463_lanes = detail::make_pack<Real>(s10, s17) *
      Lambda_0_11_p391_lanes;
  const Lanes<2> Lambda_0_11_p473_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p289_lanes - Lambda_0_11_p285_lanes - Lambda_0_11_p315_lanes *
      Lambda_0_11_p191_lanes;
  const Lanes<2> Lambda_0_11_p485_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_0_11_p409_lanes + detail::make_pack<Real>(c11, c18) * Lambda_0_11_p415_lanes +
      Lambda_0_11_p361_lanes * Lambda_0_11_p191_lanes;
  const Lanes<2> Lambda_0_11_p489_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p473_lanes + detail::make_pack<Real>(s10, s17) * Lambda_0_11_p485_lanes;
  const Lanes<2> Lambda_0_11_p491_lanes = 0.282 * Lambda_0_11_p489_lanes;
  const Lanes<2> Lambda_0_11_p493_lanes = Lambda_0_11_p383_lanes + Lambda_0_11_p463_lanes +
      Lambda_0_11_p491_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p499_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * Lambda_0_11_p493_lanes - Lambda_0_11_p257_lanes *
      Lambda_0_11_p401_lanes;
  const Lanes<2> Lambda_0_11_p501_lanes = 2.0 * detail::make_pack<Real>(s9, s16);
  const Lanes<2> Lambda_0_11_p505_lanes = detail::make_pack<Real>(c9, c16) *
      (Lambda_0_11_p311_lanes - Lambda_0_11_p455_lanes) - Lambda_0_11_p501_lanes *
      Lambda_0_11_p499_lanes;
  const Lanes<2> Lambda_0_11_p511_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * Lambda_0_11_p505_lanes + Lambda_0_11_p499_lanes);
  const Lanes<2> inverse_D8_p1_lanes = detail::make_pack<Real>(c9, c16) * Lambda_0_11_p505_lanes;
  const Lanes<2> inverse_D8_p3_lanes = 0.18125194219699997 +
      (Lambda_0_11_p455_lanes + inverse_D8_p1_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p3_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p513_lanes = Lambda_0_11_p385_lanes + Lambda_0_11_p463_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p515_lanes = Lambda_0_11_p513_lanes * inverse_D9_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p523_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p485_lanes - detail::make_pack<Real>(s10, s17) * Lambda_0_11_p473_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p533_lanes = detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) + (0.282 * Lambda_0_11_p523_lanes -
      (Lambda_0_11_p319_lanes - Lambda_0_11_p393_lanes)) + Lambda_0_11_p257_lanes *
      Lambda_0_11_p515_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p541_lanes = Lambda_0_11_p421_lanes -
      detail::make_pack<Real>(c10, c17) * Lambda_0_11_p445_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p547_lanes = 0.0022500062 + 0.282 * Lambda_0_11_p541_lanes +
      Lambda_0_11_p399_lanes * Lambda_0_11_p515_lanes;
  const Lanes<2> Lambda_0_11_p553_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * Lambda_0_11_p533_lanes -
      detail::make_pack<Real>(s9, s16) * Lambda_0_11_p547_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p555_lanes = Lambda_0_11_p553_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_0_11_p565_lanes = Lambda_0_11_p511_lanes * Lambda_0_11_p555_lanes -
      (detail::make_pack<Real>(s9, s16) * Lambda_0_11_p533_lanes +
      detail::make_pack<Real>(c9, c16) * Lambda_0_11_p547_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p567_lanes = detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) + Lambda_0_11_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p569_lanes = Lambda_0_11_p567_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p573_lanes = Lambda_0_11_p493_lanes + Lambda_0_11_p257_lanes *
      Lambda_0_11_p569_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p575_lanes = Lambda_0_11_p217_lanes - 0.0022500062;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p577_lanes = Lambda_0_11_p575_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p581_lanes = Lambda_0_11_p491_lanes + Lambda_0_11_p399_lanes *
      Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p589_lanes = Lambda_0_11_p299_lanes - Lambda_0_11_p257_lanes *
      Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p595_lanes = Lambda_0_11_p399_lanes * Lambda_0_11_p569_lanes - 0.282 *
      Lambda_0_11_p449_lanes;
  const Lanes<2> Lambda_0_11_p601_lanes = detail::make_pack<Real>(c9, c16) *
      (Lambda_0_11_p573_lanes + Lambda_0_11_p581_lanes) - detail::make_pack<Real>(s9, s16) *
      (Lambda_0_11_p595_lanes + Lambda_0_11_p589_lanes);
  const Lanes<2> Lambda_0_11_p603_lanes = detail::make_pack<Real>(s9, s16) * Lambda_0_11_p601_lanes;
  const Lanes<2> Lambda_0_11_p607_lanes = 0.7139200499999999 +
      (Lambda_0_11_p603_lanes + Lambda_0_11_p589_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p609_lanes = Lambda_0_11_p607_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_0_11_p611_lanes = 0.00010499999999999999 * Lambda_0_11_p609_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p619_lanes = detail::make_pack<Real>(c9, c16) * Lambda_0_11_p601_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p623_lanes = Lambda_0_11_p573_lanes - Lambda_0_11_p619_lanes -
      Lambda_0_11_p511_lanes * Lambda_0_11_p609_lanes;
  const Lanes<2> Lambda_0_11_p625_lanes = 0.00010499999999999999 * Lambda_0_11_p555_lanes;
  const Lanes<2> Lambda_0_11_p631_lanes = detail::make_pack<Real>(c8, c15) *
      (Lambda_0_11_p565_lanes + Lambda_0_11_p611_lanes) - detail::make_pack<Real>(s8, s15) *
      (Lambda_0_11_p625_lanes + Lambda_0_11_p623_lanes);
  const Lanes<2> Lambda_0_11_p633_lanes = detail::make_pack<Real>(c8, c15) * Lambda_0_11_p631_lanes;
  const Lanes<2> Lambda_0_11_p637_lanes = 0.0017499999999999998 +
      (Lambda_0_11_p633_lanes - Lambda_0_11_p611_lanes);
  const Lanes<2> inverse_D7_p1_lanes = Lambda_0_11_p511_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p5_lanes = 0.18113119219699997 +
      (Lambda_0_11_p311_lanes - inverse_D8_p1_lanes) - Lambda_0_11_p511_lanes * inverse_D7_p1_lanes;
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
  const Lanes<2> Lambda_0_11_p639_lanes = Lambda_0_11_p637_lanes * inverse_D7_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p645_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p14_lanes -
      inverse_D7_p11_lanes);
  const Lanes<2> Lambda_0_11_p649_lanes = detail::make_pack<Real>(s8, s15) * Lambda_0_11_p631_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p653_lanes = Lambda_0_11_p625_lanes + Lambda_0_11_p649_lanes +
      Lambda_0_11_p645_lanes * Lambda_0_11_p639_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p655_lanes = Lambda_0_11_p619_lanes - Lambda_0_11_p581_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p657_lanes = Lambda_0_11_p655_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_0_11_p661_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * Lambda_0_11_p657_lanes;
  const Lanes<2> Lambda_0_11_p671_lanes = Lambda_0_11_p603_lanes + Lambda_0_11_p595_lanes -
      0.7139200499999999 - Lambda_0_11_p511_lanes * Lambda_0_11_p657_lanes;
  const Lanes<2> Lambda_0_11_p677_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * Lambda_0_11_p661_lanes +
      detail::make_pack<Real>(c8, c15) * Lambda_0_11_p671_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p679_lanes = Lambda_0_11_p677_lanes * inverse_D7_lanes;
  const Lanes<2> Lambda_0_11_p681_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * Lambda_0_11_p679_lanes;
  const Lanes<2> Lambda_0_11_p695_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_0_11_p661_lanes - detail::make_pack<Real>(s8, s15) * Lambda_0_11_p671_lanes -
      Lambda_0_11_p645_lanes * Lambda_0_11_p679_lanes;
  const Lanes<2> Lambda_0_11_p697_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * Lambda_0_11_p639_lanes;
  const Lanes<2> Lambda_0_11_p703_lanes = detail::make_pack<Real>(c7, c14) *
      (Lambda_0_11_p653_lanes - Lambda_0_11_p681_lanes) - detail::make_pack<Real>(s7, s14) *
      (Lambda_0_11_p695_lanes - Lambda_0_11_p697_lanes);
  const Lanes<2> Lambda_0_11_p705_lanes = detail::make_pack<Real>(s7, s14) * Lambda_0_11_p703_lanes;
  const Lanes<2> Lambda_0_11_p707_lanes = Lambda_0_11_p697_lanes - Lambda_0_11_p705_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p715_lanes = Lambda_0_11_p449_lanes - Lambda_0_11_p567_lanes *
      Lambda_0_11_p569_lanes;
  const Lanes<2> Lambda_0_11_p719_lanes = Lambda_0_11_p295_lanes - Lambda_0_11_p575_lanes *
      Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p727_lanes = Lambda_0_11_p489_lanes + Lambda_0_11_p567_lanes *
      Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p731_lanes = detail::make_pack<Real>(c9, c16) *
      (Lambda_0_11_p715_lanes - Lambda_0_11_p719_lanes) - Lambda_0_11_p501_lanes *
      Lambda_0_11_p727_lanes;
  const Lanes<2> Lambda_0_11_p733_lanes = detail::make_pack<Real>(c9, c16) * Lambda_0_11_p731_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p739_lanes = Lambda_0_11_p719_lanes + Lambda_0_11_p733_lanes -
      Lambda_0_11_p655_lanes * Lambda_0_11_p657_lanes - Lambda_0_11_p677_lanes *
      Lambda_0_11_p679_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p747_lanes = Lambda_0_11_p541_lanes + Lambda_0_11_p567_lanes *
      Lambda_0_11_p515_lanes;
  const Lanes<2> Lambda_0_11_p753_lanes = Lambda_0_11_p523_lanes + Lambda_0_11_p575_lanes *
      Lambda_0_11_p515_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p759_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_0_11_p747_lanes - detail::make_pack<Real>(c9, c16) * Lambda_0_11_p753_lanes +
      Lambda_0_11_p553_lanes * Lambda_0_11_p609_lanes;
  const Lanes<2> Lambda_0_11_p767_lanes = Lambda_0_11_p715_lanes - Lambda_0_11_p733_lanes -
      Lambda_0_11_p607_lanes * Lambda_0_11_p609_lanes;
  const Lanes<2> Lambda_0_11_p777_lanes = Lambda_0_11_p439_lanes + Lambda_0_11_p447_lanes +
      Lambda_0_11_p513_lanes * Lambda_0_11_p515_lanes + Lambda_0_11_p553_lanes *
      Lambda_0_11_p555_lanes;
  const Lanes<2> Lambda_0_11_p783_lanes = inverse_D7_p12_lanes * Lambda_0_11_p759_lanes -
      detail::make_pack<Real>(s8, s15) * (Lambda_0_11_p777_lanes + Lambda_0_11_p767_lanes);
  const Lanes<2> Lambda_0_11_p785_lanes = detail::make_pack<Real>(s8, s15) * Lambda_0_11_p783_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p789_lanes = Lambda_0_11_p777_lanes + Lambda_0_11_p785_lanes +
      Lambda_0_11_p637_lanes * Lambda_0_11_p639_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p805_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_0_11_p747_lanes + detail::make_pack<Real>(s9, s16) * Lambda_0_11_p753_lanes +
      Lambda_0_11_p553_lanes * Lambda_0_11_p657_lanes;
  const Lanes<2> Lambda_0_11_p815_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_0_11_p731_lanes + Lambda_0_11_p727_lanes - Lambda_0_11_p607_lanes *
      Lambda_0_11_p657_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p821_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_0_11_p805_lanes - detail::make_pack<Real>(s8, s15) * Lambda_0_11_p815_lanes -
      Lambda_0_11_p677_lanes * Lambda_0_11_p639_lanes;
  const Lanes<2> Lambda_0_11_p823_lanes = 2.0 * detail::make_pack<Real>(s7, s14);
  const Lanes<2> Lambda_0_11_p827_lanes = detail::make_pack<Real>(c7, c14) *
      (Lambda_0_11_p739_lanes + Lambda_0_11_p789_lanes) - Lambda_0_11_p823_lanes *
      Lambda_0_11_p821_lanes;
  const Lanes<2> Lambda_0_11_p829_lanes = detail::make_pack<Real>(c7, c14) * Lambda_0_11_p827_lanes;
  const Lanes<2> Lambda_0_11_p831_lanes = Lambda_0_11_p739_lanes - Lambda_0_11_p829_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p835_lanes = Lambda_0_11_p623_lanes + Lambda_0_11_p649_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p837_lanes = Lambda_0_11_p835_lanes * inverse_D7_lanes;
  const Lanes<2> Lambda_0_11_p847_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_0_11_p805_lanes + detail::make_pack<Real>(c8, c15) * Lambda_0_11_p815_lanes -
      Lambda_0_11_p677_lanes * Lambda_0_11_p837_lanes;
  const Lanes<2> Lambda_0_11_p857_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_0_11_p783_lanes - Lambda_0_11_p759_lanes - Lambda_0_11_p637_lanes *
      Lambda_0_11_p837_lanes;
  const Lanes<2> Lambda_0_11_p861_lanes = detail::make_pack<Real>(s7, s14) *
      Lambda_0_11_p847_lanes + detail::make_pack<Real>(c7, c14) * Lambda_0_11_p857_lanes;
  const Lanes<2> Lambda_0_11_p867_lanes = Lambda_0_11_p707_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * Lambda_0_11_p831_lanes + 0.226 *
      Lambda_0_11_p861_lanes);

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p869_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> Lambda_0_11_p871_lanes = detail::make_pack<Real>(c23, c24) *
      Lambda_0_11_p869_lanes;
  const Lanes<2> Lambda_0_11_p873_lanes = Lambda_0_11_p871_lanes - 0.0007770270270270272;
  const Real Lambda_0_11_p875 = 0.431222972972973 + Lambda_0_11_p871_lanes[1] +
      Lambda_0_11_p873_lanes[0];
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> inverse_D22_p3_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Real inverse_D22_p5 = inverse_D22_p3_lanes[1] + inverse_D22_p3_lanes[0];
  const Real inverse_D22_p6 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p5 + 4.75e-05 * inverse_D22_p6);
  const Real Lambda_0_11_p876 = Lambda_0_11_p875 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p879_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);
  const Real Lambda_0_11_p881 = s24 + s23;
  const Real Lambda_0_11_p882 = Lambda_0_11_p879_lanes[0] + 2.375e-05 * Lambda_0_11_p881 +
      Lambda_0_11_p879_lanes[1];
  const Lanes<2> Lambda_0_11_p883_lanes = detail::make_pack<Real>(s23, s24) *
      Lambda_0_11_p869_lanes;
  const Real Lambda_0_11_p885 = Lambda_0_11_p883_lanes[1] + Lambda_0_11_p883_lanes[0];

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p886 = Lambda_0_11_p882 * Lambda_0_11_p876 - Lambda_0_11_p885;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p887_lanes = detail::make_pack<Real>(0.032, (-0.032)) *
      Lambda_0_11_p873_lanes;
  const Real Lambda_0_11_p889 = Lambda_0_11_p887_lanes[1] + Lambda_0_11_p887_lanes[0] - 0.095 *
      Lambda_0_11_p885;
  const Real Lambda_0_11_p890 = 0.072575 + 0.00025 * inverse_D22_p6;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p891 = Lambda_0_11_p890 * inverse_D22;
  const Real Lambda_0_11_p892 = Lambda_0_11_p889 * Lambda_0_11_p891;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p893_lanes = 0.006756756756756757 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> Lambda_0_11_p895_lanes = detail::make_pack<Real>(c23, c24) *
      Lambda_0_11_p893_lanes;
  const Lanes<2> Lambda_0_11_p899_lanes = detail::make_pack<Real>(s23, s24) *
      Lambda_0_11_p893_lanes;
  const Lanes<2> Lambda_0_11_p903_lanes = 0.095 * Lambda_0_11_p895_lanes +
      detail::make_pack<Real>(0.032, (-0.032)) * Lambda_0_11_p899_lanes;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p905 = Lambda_0_11_p903_lanes[1] + Lambda_0_11_p903_lanes[0] +
      Lambda_0_11_p889 * Lambda_0_11_p876;
  const Real Lambda_0_11_p906 = Lambda_0_11_p882 * Lambda_0_11_p891 - 0.00025 * Lambda_0_11_p881;
  const Real Lambda_0_11_p907 = s22 * (Lambda_0_11_p886 + Lambda_0_11_p892) + c22 *
      (Lambda_0_11_p906 - Lambda_0_11_p905);
  const Real Lambda_0_11_p908 = s22 * Lambda_0_11_p907;
  const Real Lambda_0_11_p909 = Lambda_0_11_p908 - Lambda_0_11_p892;
  const Real inverse_D21_p1 = Lambda_0_11_p889 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p2_lanes = Lambda_0_11_p899_lanes - 0.006756756756756757;
  const Lanes<2> inverse_D21_p8_lanes = 0.095 * inverse_D21_p2_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * Lambda_0_11_p895_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p10 = inverse_D21_p8_lanes[1] + inverse_D21_p8_lanes[0];
  const Real inverse_D21_p11 = 0.009438624999999999 - (-0.032) * Lambda_0_11_p903_lanes[1] - 0.032 *
      Lambda_0_11_p903_lanes[0] - Lambda_0_11_p889 * inverse_D21_p1 + 0.095 * inverse_D21_p10;
  const Real inverse_D21_p12 = 0.05450270000000001 + inverse_D22_p5 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - Lambda_0_11_p882 * Lambda_0_11_p882 * inverse_D22;
  const Real inverse_D21_p13 = inverse_D21_p12 - 0.00017071621621621625;
  const Real inverse_D21_p14 = Lambda_0_11_p871_lanes[1] + Lambda_0_11_p871_lanes[0];
  const Real inverse_D21_p15 = 0.0074 - (-0.032) * Lambda_0_11_p883_lanes[1] - 0.032 *
      Lambda_0_11_p883_lanes[0] + Lambda_0_11_p882 * inverse_D21_p1 - 0.095 * inverse_D21_p14;
  const Real inverse_D21_p16 = 2.0 * c22;
  const Real inverse_D21_p17 = s22 * (inverse_D21_p13 - inverse_D21_p11) + inverse_D21_p16 *
      inverse_D21_p15;
  const Real inverse_D21_p18 = s22 * inverse_D21_p17;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p11 + inverse_D21_p18));
  const Real Lambda_0_11_p910 = Lambda_0_11_p909 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p911 = Lambda_0_11_p885 * inverse_D22;
  const Real Lambda_0_11_p912 = 0.072575 + inverse_D21_p10 + Lambda_0_11_p889 * Lambda_0_11_p911;
  const Real Lambda_0_11_p913 = inverse_D21_p14 - 0.43200000000000005 + Lambda_0_11_p882 *
      Lambda_0_11_p911;
  const Real Lambda_0_11_p914 = c22 * Lambda_0_11_p912 - s22 * Lambda_0_11_p913;
  const Real Lambda_0_11_p915 = 0.0016155 + (c22 * inverse_D21_p17 - inverse_D21_p15 + 0.394 *
      Lambda_0_11_p914);
  const Real Lambda_0_11_p916 = c22 * Lambda_0_11_p907;
  const Real Lambda_0_11_p917 = Lambda_0_11_p890 * Lambda_0_11_p911;
  const Real Lambda_0_11_p918 = Lambda_0_11_p895_lanes[1] + Lambda_0_11_p895_lanes[0] -
      Lambda_0_11_p875 * Lambda_0_11_p911;
  const Real Lambda_0_11_p919 = c22 * Lambda_0_11_p917 - s22 * Lambda_0_11_p918;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p920 = Lambda_0_11_p915 * Lambda_0_11_p910 -
      (Lambda_0_11_p916 + Lambda_0_11_p905 + 0.394 * Lambda_0_11_p919);

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p921 = Lambda_0_11_p916 - Lambda_0_11_p906;
  const Real Lambda_0_11_p922 = 0.394 * Lambda_0_11_p921;
  const Real Lambda_0_11_p923 = Lambda_0_11_p875 * Lambda_0_11_p891;
  const Real Lambda_0_11_p924 = Lambda_0_11_p899_lanes[1] + Lambda_0_11_p899_lanes[0] +
      Lambda_0_11_p875 * Lambda_0_11_p876;
  const Real Lambda_0_11_p925 = Lambda_0_11_p890 * Lambda_0_11_p891;
  const Real Lambda_0_11_p926 = inverse_D21_p16 * Lambda_0_11_p923 - s22 *
      (Lambda_0_11_p925 - Lambda_0_11_p924);
  const Real Lambda_0_11_p927 = Lambda_0_11_p923 - c22 * Lambda_0_11_p926;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p928 = Lambda_0_11_p922 * Lambda_0_11_p910 -
      (0.0045000000000000005 + 0.394 * Lambda_0_11_p927);

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p929 = c21 * Lambda_0_11_p920 - s21 * Lambda_0_11_p928 +
      Lambda_0_11_p867_lanes[1] + Lambda_0_11_p867_lanes[0];
  const Lanes<2> inverse_D6_p3_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (Lambda_0_11_p707_lanes + Lambda_0_11_p867_lanes);
  const Lanes<2> inverse_D6_p5_lanes = Lambda_0_11_p645_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p13_lanes = 0.0002975 + (inverse_D7_p7_lanes - inverse_D7_p15_lanes) -
      Lambda_0_11_p645_lanes * inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p15_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p17_lanes;
  const Lanes<2> inverse_D6_p17_lanes = 0.0001505 - inverse_D6_p15_lanes;
  const Lanes<2> inverse_D6_p25_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p29_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p17_lanes - inverse_D6_p13_lanes) + Lambda_0_11_p823_lanes * inverse_D6_p25_lanes;
  const Lanes<2> inverse_D6_p31_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p29_lanes;
  const Real inverse_D6_p33 = inverse_D6_p31_lanes[1] + inverse_D6_p31_lanes[0];

  // link 22 (head), articulated inertia
  const Real inverse_D6_p34 = c22 * Lambda_0_11_p913 + s22 * Lambda_0_11_p912;
  const Real inverse_D6_p35 = inverse_D21_p2_lanes[1] + inverse_D21_p2_lanes[0] - Lambda_0_11_p885 *
      Lambda_0_11_p911;
  const Real inverse_D6_p36 = inverse_D6_p34 - 0.394 * inverse_D6_p35;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p37 = 0.005513625 + (inverse_D21_p13 - inverse_D21_p18 - 0.394 *
      (inverse_D6_p34 + inverse_D6_p36)) - Lambda_0_11_p915 * (Lambda_0_11_p915 * inverse_D21);
  const Real inverse_D6_p38 = Lambda_0_11_p922 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p39 = s22 * Lambda_0_11_p926;
  const Real inverse_D6_p40 = inverse_D6_p39 - Lambda_0_11_p924;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p41 = 0.000703125 + 0.155236 * inverse_D6_p40 - Lambda_0_11_p922 *
      inverse_D6_p38;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p42 = c22 * Lambda_0_11_p918 + s22 * Lambda_0_11_p917;
  const Real inverse_D6_p43 = 0.394 * inverse_D6_p42;
  const Real inverse_D6_p44 = Lambda_0_11_p886 - Lambda_0_11_p908 - inverse_D6_p43;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p45 = 0.394 * inverse_D6_p44 - Lambda_0_11_p915 * inverse_D6_p38;
  const Real inverse_D6_p46 = 2.0 * s21;
  const Real inverse_D6_p47 = c21 * (inverse_D6_p37 - inverse_D6_p41) - inverse_D6_p46 *
      inverse_D6_p45;
  const Real inverse_D6_p48 = c21 * inverse_D6_p47;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p51_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      Lambda_0_11_p837_lanes;
  const Lanes<2> inverse_D6_p61_lanes = Lambda_0_11_p633_lanes - Lambda_0_11_p565_lanes -
      0.0017499999999999998 - Lambda_0_11_p645_lanes * Lambda_0_11_p837_lanes;
  const Lanes<2> inverse_D6_p65_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p51_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p61_lanes;
  const Lanes<2> inverse_D6_p73_lanes = Lambda_0_11_p767_lanes + Lambda_0_11_p785_lanes -
      Lambda_0_11_p835_lanes * Lambda_0_11_p837_lanes;
  const Lanes<2> inverse_D6_p79_lanes = inverse_D6_p65_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * Lambda_0_11_p861_lanes + 0.226 *
      inverse_D6_p73_lanes);
  const Real inverse_D6_p81 = inverse_D6_p79_lanes[1] + inverse_D6_p79_lanes[0];
  const Real inverse_D6_p82 = 2.06965463592404 + inverse_D6_p41 + inverse_D6_p48 +
      inverse_D6_p13_lanes[1] + inverse_D6_p33 + inverse_D6_p3_lanes[1] + inverse_D6_p13_lanes[0] +
      inverse_D6_p3_lanes[0] + 0.226 * (inverse_D6_p65_lanes[1] + inverse_D6_p81 +
      inverse_D6_p65_lanes[0]);

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p82;
  const Real Lambda_0_11_p930 = Lambda_0_11_p929 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p931_lanes = detail::make_pack<Real>(c7, c14) * Lambda_0_11_p703_lanes;
  const Lanes<2> Lambda_0_11_p937_lanes = detail::make_pack<Real>(s7, s14) *
      Lambda_0_11_p827_lanes + Lambda_0_11_p821_lanes;
  const Lanes<2> Lambda_0_11_p939_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      Lambda_0_11_p937_lanes;
  const Lanes<2> Lambda_0_11_p945_lanes = detail::make_pack<Real>(c7, c14) *
      Lambda_0_11_p847_lanes - detail::make_pack<Real>(s7, s14) * Lambda_0_11_p857_lanes;
  const Lanes<2> Lambda_0_11_p947_lanes = 0.226 * Lambda_0_11_p945_lanes;
  const Lanes<2> Lambda_0_11_p951_lanes = Lambda_0_11_p931_lanes - Lambda_0_11_p653_lanes -
      (Lambda_0_11_p939_lanes + Lambda_0_11_p947_lanes);
  const Lanes<2> Lambda_0_11_p953_lanes = Lambda_0_11_p681_lanes + Lambda_0_11_p931_lanes;
  const Lanes<2> Lambda_0_11_p957_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (Lambda_0_11_p951_lanes + Lambda_0_11_p953_lanes);
  const Lanes<2> Lambda_0_11_p959_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p29_lanes;
  const Lanes<2> Lambda_0_11_p965_lanes = detail::make_pack<Real>(s7, s14) * inverse_D6_p51_lanes -
      detail::make_pack<Real>(c7, c14) * inverse_D6_p61_lanes;
  const Real Lambda_0_11_p967 = Lambda_0_11_p965_lanes[1] + Lambda_0_11_p965_lanes[0];
  const Real Lambda_0_11_p968 = 0.0187369177636143 + Lambda_0_11_p957_lanes[1] -
      inverse_D6_p25_lanes[1] + Lambda_0_11_p959_lanes[1] + Lambda_0_11_p957_lanes[0] -
      inverse_D6_p25_lanes[0] + Lambda_0_11_p959_lanes[0] + 0.226 * Lambda_0_11_p967;
  const Lanes<2> Lambda_0_11_p969_lanes = Lambda_0_11_p939_lanes - Lambda_0_11_p953_lanes;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p971 = Lambda_0_11_p969_lanes[1] + Lambda_0_11_p969_lanes[0] +
      Lambda_0_11_p968 * Lambda_0_11_p930;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p972 = Lambda_0_11_p951_lanes[1] + Lambda_0_11_p951_lanes[0];
  const Real Lambda_0_11_p973 = s21 * inverse_D6_p47 + inverse_D6_p45 + 0.226 * Lambda_0_11_p972;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p974 = Lambda_0_11_p921 * inverse_D21;
  const Real Lambda_0_11_p975 = inverse_D6_p44 - Lambda_0_11_p915 * Lambda_0_11_p974;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p976 = 0.0045000000000000005 + Lambda_0_11_p914;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p977 = Lambda_0_11_p976 * inverse_D21;
  const Real Lambda_0_11_p978 = inverse_D6_p43 + Lambda_0_11_p922 * Lambda_0_11_p977;
  const Real Lambda_0_11_p979 = 0.394 * inverse_D6_p40 - Lambda_0_11_p922 * Lambda_0_11_p974;
  const Real Lambda_0_11_p980 = inverse_D6_p36 + Lambda_0_11_p915 * Lambda_0_11_p977;
  const Real Lambda_0_11_p981 = c21 * (Lambda_0_11_p975 - Lambda_0_11_p978) - s21 *
      (Lambda_0_11_p979 + Lambda_0_11_p980);
  const Real Lambda_0_11_p982 = s21 * Lambda_0_11_p981;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p983 = Lambda_0_11_p982 + Lambda_0_11_p980 - 6.1665928899999995 -
      inverse_D6_p81;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p984 = Lambda_0_11_p983 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p985 = c21 * Lambda_0_11_p981;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p986 = Lambda_0_11_p975 - Lambda_0_11_p985 + Lambda_0_11_p947_lanes[1] +
      Lambda_0_11_p947_lanes[0] - Lambda_0_11_p973 * Lambda_0_11_p984;
  const Real Lambda_0_11_p987 = Lambda_0_11_p937_lanes[1] + Lambda_0_11_p937_lanes[0];
  const Real Lambda_0_11_p988 = Lambda_0_11_p973 * Lambda_0_11_p930 -
      (s21 * Lambda_0_11_p920 + c21 * Lambda_0_11_p928) + 0.226 * Lambda_0_11_p987;
  const Real Lambda_0_11_p989 = (-0.18) * Lambda_0_11_p945_lanes[1] - Lambda_0_11_p967 + 0.18 *
      Lambda_0_11_p945_lanes[0] - Lambda_0_11_p968 * Lambda_0_11_p984;
  const Real Lambda_0_11_p990 = s6 * (Lambda_0_11_p971 - Lambda_0_11_p986) + c6 *
      (Lambda_0_11_p988 + Lambda_0_11_p989);
  const Real Lambda_0_11_p991 = s6 * Lambda_0_11_p990;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p992 = Lambda_0_11_p978 + Lambda_0_11_p985 + Lambda_0_11_p972;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p993 = Lambda_0_11_p992 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p994 = Lambda_0_11_p921 * Lambda_0_11_p910 - Lambda_0_11_p927;
  const Real Lambda_0_11_p995 = Lambda_0_11_p919 - Lambda_0_11_p976 * Lambda_0_11_p910;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p996 = Lambda_0_11_p987 - c21 * Lambda_0_11_p994 + s21 * Lambda_0_11_p995 +
      Lambda_0_11_p929 * Lambda_0_11_p993;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p997 = inverse_D6_p40 - Lambda_0_11_p921 * Lambda_0_11_p974;
  const Real Lambda_0_11_p998 = inverse_D6_p35 - Lambda_0_11_p976 * Lambda_0_11_p977;
  const Real Lambda_0_11_p999 = inverse_D6_p42 + Lambda_0_11_p921 * Lambda_0_11_p977;
  const Real Lambda_0_11_p1000 = c21 * (Lambda_0_11_p997 - Lambda_0_11_p998) - inverse_D6_p46 *
      Lambda_0_11_p999;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p1001 = s21 * Lambda_0_11_p1000 + Lambda_0_11_p999 +
      Lambda_0_11_p945_lanes[1] + Lambda_0_11_p945_lanes[0] - Lambda_0_11_p983 * Lambda_0_11_p993;
  const Real Lambda_0_11_p1002 = s6 * Lambda_0_11_p996 + c6 * Lambda_0_11_p1001;
  const Real Lambda_0_11_p1003 = 0.072 * Lambda_0_11_p1002;
  const Real Lambda_0_11_p1004 = Lambda_0_11_p986 + Lambda_0_11_p991 + Lambda_0_11_p1003;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p1_lanes = Lambda_0_11_p705_lanes + Lambda_0_11_p695_lanes;
  const Lanes<2> inverse_D5_p3_lanes = Lambda_0_11_p829_lanes - Lambda_0_11_p789_lanes;
  const Lanes<2> inverse_D5_p7_lanes = inverse_D5_p1_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p3_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p9 = inverse_D5_p7_lanes[1] + inverse_D5_p7_lanes[0] - Lambda_0_11_p968 *
      Lambda_0_11_p993;
  const Real inverse_D5_p10 = inverse_D5_p3_lanes[1] + inverse_D5_p3_lanes[0];
  const Real inverse_D5_p11 = 6.1665928899999995 + Lambda_0_11_p982 + Lambda_0_11_p979 -
      Lambda_0_11_p973 * Lambda_0_11_p993 + 0.226 * inverse_D5_p10;
  const Real inverse_D5_p12 = s6 * inverse_D5_p9 + c6 * inverse_D5_p11;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p13 = c21 * Lambda_0_11_p1000;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p14 = Lambda_0_11_p998 + inverse_D5_p13 + inverse_D5_p10 -
      Lambda_0_11_p992 * Lambda_0_11_p993;
  const Real inverse_D5_p15 = inverse_D5_p12 + 0.072 * inverse_D5_p14;
  const Real inverse_D5_p16 = Lambda_0_11_p968 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p19_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p1_lanes + inverse_D5_p7_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p21 = 0.40056549999999996 - inverse_D6_p15_lanes[1] - inverse_D6_p33 +
      inverse_D5_p19_lanes[1] + inverse_D6_p17_lanes[0] + inverse_D5_p19_lanes[0] -
      Lambda_0_11_p968 * inverse_D5_p16;
  const Real inverse_D5_p22 = Lambda_0_11_p973 * inverse_D6;
  const Real inverse_D5_p23 = 1.66923963592404 + inverse_D6_p37 - inverse_D6_p48 -
      Lambda_0_11_p973 * inverse_D5_p22 + 0.051076 * inverse_D5_p10;
  const Real inverse_D5_p24 = (-0.04068) * inverse_D5_p3_lanes[1] + 0.04068 *
      inverse_D5_p3_lanes[0] - Lambda_0_11_p968 * inverse_D5_p22 + 0.226 *
      (inverse_D5_p1_lanes[1] + inverse_D5_p1_lanes[0]);
  const Real inverse_D5_p25 = 2.0 * c6;
  const Real inverse_D5_p26 = s6 * (inverse_D5_p21 - inverse_D5_p23) + inverse_D5_p25 *
      inverse_D5_p24;
  const Real inverse_D5_p27 = s6 * inverse_D5_p26;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p23 + inverse_D5_p27 + 0.072 * (inverse_D5_p12 + inverse_D5_p15)));
  const Real Lambda_0_11_p1005 = Lambda_0_11_p1004 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p1006 = 0.072 * Lambda_0_11_p1004;
  const Real Lambda_0_11_p1007 = Lambda_0_11_p831_lanes[1] -
      (Lambda_0_11_p925 + inverse_D6_p39 + Lambda_0_11_p909 * Lambda_0_11_p910) +
      Lambda_0_11_p831_lanes[0] - Lambda_0_11_p929 * Lambda_0_11_p930;
  const Real Lambda_0_11_p1008 = Lambda_0_11_p997 - inverse_D5_p13 + inverse_D6_p73_lanes[1] +
      inverse_D6_p73_lanes[0] - Lambda_0_11_p983 * Lambda_0_11_p984;
  const Real Lambda_0_11_p1009 = Lambda_0_11_p861_lanes[1] -
      (s21 * Lambda_0_11_p994 + c21 * Lambda_0_11_p995) + Lambda_0_11_p861_lanes[0] +
      Lambda_0_11_p929 * Lambda_0_11_p984;
  const Real Lambda_0_11_p1010 = s6 * (Lambda_0_11_p1007 - Lambda_0_11_p1008) + inverse_D5_p25 *
      Lambda_0_11_p1009;
  const Real Lambda_0_11_p1011 = s6 * Lambda_0_11_p1010;
  const Real Lambda_0_11_p1012 = Lambda_0_11_p1008 + Lambda_0_11_p1011;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1013 = Lambda_0_11_p1006 * Lambda_0_11_p1005 -
      (2.2194301519999997 + 0.072 * Lambda_0_11_p1012);

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p1014 = c6 * inverse_D5_p9 - s6 * inverse_D5_p11;
  const Real Lambda_0_11_p1015 = c6 * inverse_D5_p26 - inverse_D5_p24 + 0.072 * Lambda_0_11_p1014;
  const Real Lambda_0_11_p1016 = c6 * Lambda_0_11_p990;
  const Real Lambda_0_11_p1017 = Lambda_0_11_p1016 - Lambda_0_11_p988;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1018 = Lambda_0_11_p1017 - 0.069699984375 - Lambda_0_11_p1015 *
      Lambda_0_11_p1005;
  const Real Lambda_0_11_p1019 = s5 * Lambda_0_11_p1013 + c5 * Lambda_0_11_p1018;
  const Real Lambda_0_11_p1020 = Lambda_0_11_p1006 * inverse_D5;
  const Real Lambda_0_11_p1021 = 0.15637308509675518 + 0.005183999999999999 * Lambda_0_11_p1012 -
      Lambda_0_11_p1006 * Lambda_0_11_p1020;
  const Real Lambda_0_11_p1022 = Lambda_0_11_p1015 * inverse_D5;
  const Real Lambda_0_11_p1023 = 0.04675382692737882 + (inverse_D5_p21 - inverse_D5_p27) -
      Lambda_0_11_p1015 * Lambda_0_11_p1022;
  const Real Lambda_0_11_p1024 = 0.005678398088837119 - 0.072 * Lambda_0_11_p1017 +
      Lambda_0_11_p1006 * Lambda_0_11_p1022;
  const Real Lambda_0_11_p1025 = 2.0 * c5;
  const Real Lambda_0_11_p1026 = s5 * (Lambda_0_11_p1021 - Lambda_0_11_p1023) + Lambda_0_11_p1025 *
      Lambda_0_11_p1024;
  const Real Lambda_0_11_p1027 = 0.005880002159562879 +
      (0.21799999999999997 * Lambda_0_11_p1019 - (c5 * Lambda_0_11_p1026 - Lambda_0_11_p1024));

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p1028 = 2.2194301519999997 + inverse_D5_p15;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1029 = Lambda_0_11_p1028 * inverse_D5;
  const Real Lambda_0_11_p1030 = Lambda_0_11_p1006 * Lambda_0_11_p1029 - Lambda_0_11_p1003;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p1031 = c6 * Lambda_0_11_p996 - s6 * Lambda_0_11_p1001;
  const Real Lambda_0_11_p1032 = 0.069699984375 + (Lambda_0_11_p1016 - Lambda_0_11_p989 + 0.072 *
      Lambda_0_11_p1031);

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1033 = Lambda_0_11_p1032 * inverse_D5;
  const Real Lambda_0_11_p1034 = Lambda_0_11_p971 - Lambda_0_11_p991 - Lambda_0_11_p1015 *
      Lambda_0_11_p1033;
  const Real Lambda_0_11_p1035 = Lambda_0_11_p1014 - Lambda_0_11_p1015 * Lambda_0_11_p1029;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p1036 = c6 * Lambda_0_11_p1010 - Lambda_0_11_p1009;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1037 = Lambda_0_11_p1006 * Lambda_0_11_p1033 - 0.072 * Lambda_0_11_p1036;
  const Real Lambda_0_11_p1038 = s5 * (Lambda_0_11_p1030 - Lambda_0_11_p1034) + c5 *
      (Lambda_0_11_p1035 + Lambda_0_11_p1037);
  const Real Lambda_0_11_p1039 = c5 * Lambda_0_11_p1038;
  const Real Lambda_0_11_p1040 = Lambda_0_11_p1039 - Lambda_0_11_p1037;
  const Real inverse_D4_p1 = s5 * Lambda_0_11_p1026;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (Lambda_0_11_p1023 + inverse_D4_p1));
  const Real Lambda_0_11_p1041 = Lambda_0_11_p1040 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1042 = s5 * Lambda_0_11_p1038;
  const Real Lambda_0_11_p1043 = Lambda_0_11_p1036 - Lambda_0_11_p1032 * Lambda_0_11_p1005;
  const Real Lambda_0_11_p1044 = Lambda_0_11_p1002 - Lambda_0_11_p1028 * Lambda_0_11_p1005;
  const Real Lambda_0_11_p1045 = s5 * Lambda_0_11_p1043 - c5 * Lambda_0_11_p1044;
  const Real Lambda_0_11_p1046 = 0.21799999999999997 * Lambda_0_11_p1045;
  const Real Lambda_0_11_p1047 = Lambda_0_11_p1030 - Lambda_0_11_p1042 + Lambda_0_11_p1046;
  const Real Lambda_0_11_p1048 = 0.21799999999999997 * Lambda_0_11_p1040;
  const Real Lambda_0_11_p1049 = 0.0300000063 + Lambda_0_11_p1019;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p1050 = Lambda_0_11_p1049 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1051 = Lambda_0_11_p1007 - Lambda_0_11_p1011 - Lambda_0_11_p1032 *
      Lambda_0_11_p1033;
  const Real Lambda_0_11_p1052 = inverse_D5_p14 - Lambda_0_11_p1028 * Lambda_0_11_p1029;
  const Real Lambda_0_11_p1053 = Lambda_0_11_p1031 - Lambda_0_11_p1028 * Lambda_0_11_p1033;
  const Real Lambda_0_11_p1054 = s5 * (Lambda_0_11_p1052 - Lambda_0_11_p1051) + Lambda_0_11_p1025 *
      Lambda_0_11_p1053;
  const Real Lambda_0_11_p1055 = s5 * Lambda_0_11_p1054;
  const Real Lambda_0_11_p1056 = Lambda_0_11_p1052 - Lambda_0_11_p1055;
  const Real Lambda_0_11_p1057 = s5 * Lambda_0_11_p1018 - c5 * Lambda_0_11_p1013;
  const Real Lambda_0_11_p1058 = Lambda_0_11_p1012 - Lambda_0_11_p1004 * Lambda_0_11_p1005;
  const Real Lambda_0_11_p1059 = Lambda_0_11_p1057 + 0.21799999999999997 * Lambda_0_11_p1058;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p1060 = Lambda_0_11_p1027 * Lambda_0_11_p1050 - Lambda_0_11_p1059;
  const Real Lambda_0_11_p1061 = s4 * (Lambda_0_11_p1047 + Lambda_0_11_p1027 * Lambda_0_11_p1041 +
      (Lambda_0_11_p1046 + Lambda_0_11_p1048 * Lambda_0_11_p1050)) + c4 *
      (0.21799999999999997 * Lambda_0_11_p1056 - Lambda_0_11_p1048 * Lambda_0_11_p1041 +
      Lambda_0_11_p1060);
  const Real Lambda_0_11_p1062 = 8.419374554 + (c4 * Lambda_0_11_p1061 - Lambda_0_11_p1060);
  const Real inverse_D3_p1 = Lambda_0_11_p1027 * inverse_D4;
  const Real inverse_D3_p2 = Lambda_0_11_p1048 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * Lambda_0_11_p1056 -
      Lambda_0_11_p1048 * inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (Lambda_0_11_p1021 - inverse_D4_p1 + 0.21799999999999997 *
      (Lambda_0_11_p1057 + Lambda_0_11_p1059)) - Lambda_0_11_p1027 * inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * Lambda_0_11_p1047 + Lambda_0_11_p1027 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real Lambda_0_11_p1063 = Lambda_0_11_p1062 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p1064 = Lambda_0_11_p1056 - Lambda_0_11_p1040 * Lambda_0_11_p1041;
  const Real Lambda_0_11_p1065 = s4 * (Lambda_0_11_p1064 -
      (Lambda_0_11_p1058 - Lambda_0_11_p1049 * Lambda_0_11_p1050)) - inverse_D3_p5 *
      (Lambda_0_11_p1045 + Lambda_0_11_p1040 * Lambda_0_11_p1050);

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p1066 = Lambda_0_11_p1064 - s4 * Lambda_0_11_p1065 - Lambda_0_11_p1062 *
      Lambda_0_11_p1063;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1067 = Lambda_0_11_p1034 + Lambda_0_11_p1042;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p1068 = Lambda_0_11_p1067 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p1069 = s5 * Lambda_0_11_p1044 + c5 * Lambda_0_11_p1043;
  const Real Lambda_0_11_p1070 = c5 * Lambda_0_11_p1054 - Lambda_0_11_p1053;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p1071 = s4 * (0.21799999999999997 * Lambda_0_11_p1069 -
      (Lambda_0_11_p1039 - Lambda_0_11_p1035) - Lambda_0_11_p1027 * Lambda_0_11_p1068) + c4 *
      (0.0300000063 - 0.21799999999999997 * Lambda_0_11_p1070 + Lambda_0_11_p1048 *
      Lambda_0_11_p1068);
  const Real Lambda_0_11_p1072 = 0.02999999505 + Lambda_0_11_p1071;

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p1073 = Lambda_0_11_p1072 * inverse_D3;
  const Real Lambda_0_11_p1074 = Lambda_0_11_p1051 + Lambda_0_11_p1055 - Lambda_0_11_p1067 *
      Lambda_0_11_p1068 - Lambda_0_11_p1072 * Lambda_0_11_p1073;
  const Real Lambda_0_11_p1075 = Lambda_0_11_p1062 * Lambda_0_11_p1073 -
      (c4 * (Lambda_0_11_p1040 * Lambda_0_11_p1068 - Lambda_0_11_p1070) - s4 *
      (Lambda_0_11_p1049 * Lambda_0_11_p1068 - Lambda_0_11_p1069));
  const Real Lambda_0_11_p1076 = s3 * (Lambda_0_11_p1066 - Lambda_0_11_p1074) + c3 *
      (2.0 * Lambda_0_11_p1075);
  const Real Lambda_0_11_p1077 = s3 * Lambda_0_11_p1076;
  const Real Lambda_0_11_p1078 = Lambda_0_11_p1066 - Lambda_0_11_p1077;
  const Real Lambda_0_11_p1079 = 24.5839218 + 0.422 * Lambda_0_11_p1078;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * Lambda_0_11_p1078);
  const Real Lambda_0_11_p1080 = Lambda_0_11_p1079 * inverse_D2;

  // link 2 (thigh), pose
  const Real Lambda_0_11_p1081 = c2 * c1 - s2 * s1;
  const Real Lambda_0_11_p1082 = s2 * c1 + c2 * s1;

  // link 3 (hip), pose
  const Real Lambda_0_11_p1083 = s3 * Lambda_0_11_p1081 + c3 * Lambda_0_11_p1082;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p1084 = c4 * Lambda_0_11_p1083;

  // link 3 (hip), pose
  const Real Lambda_0_11_p1085 = c3 * Lambda_0_11_p1081 - s3 * Lambda_0_11_p1082;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1086 = s5 * Lambda_0_11_p1084 - c5 * Lambda_0_11_p1085;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p1087 = s4 * Lambda_0_11_p1083;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1088 = c6 * Lambda_0_11_p1086 + s6 * Lambda_0_11_p1087;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1091 = c5 * Lambda_0_11_p1084 + s5 * Lambda_0_11_p1085;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1094_lanes = detail::make_pack<Real>(s7, s14) * Lambda_0_11_p1088 -
      detail::make_pack<Real>(c7, c14) * Lambda_0_11_p1091;
  const Lanes<2> Lambda_0_11_p1102_lanes = detail::make_pack<Real>(c7, c14) * Lambda_0_11_p1088 +
      detail::make_pack<Real>(s7, s14) * Lambda_0_11_p1091;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1106 = s6 * Lambda_0_11_p1086 - c6 * Lambda_0_11_p1087;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1109_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_0_11_p1102_lanes + detail::make_pack<Real>(c8, c15) * Lambda_0_11_p1106;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1113_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_0_11_p1094_lanes - detail::make_pack<Real>(s9, s16) * Lambda_0_11_p1109_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1121_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_0_11_p1102_lanes - detail::make_pack<Real>(s8, s15) * Lambda_0_11_p1106;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_0_11_p1125_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p1113_lanes + detail::make_pack<Real>(s10, s17) * Lambda_0_11_p1121_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1133_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_0_11_p1109_lanes + detail::make_pack<Real>(s9, s16) * Lambda_0_11_p1094_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1137_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p1125_lanes - detail::make_pack<Real>(s11, s18) * Lambda_0_11_p1133_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p1141 = c17 * Lambda_0_11_p1121_lanes[1] - s17 *
      Lambda_0_11_p1113_lanes[1];

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1142 = s5 * s4;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1143 = s6 * Lambda_0_11_p1142 + c6 * c4;
  const Real Lambda_0_11_p1146 = s6 * c4 - c6 * Lambda_0_11_p1142;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1149 = c5 * s4;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1152_lanes = detail::make_pack<Real>(c7, c14) * Lambda_0_11_p1146 -
      detail::make_pack<Real>(s7, s14) * Lambda_0_11_p1149;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1156_lanes = detail::make_pack<Real>(c8, c15) * Lambda_0_11_p1143 -
      detail::make_pack<Real>(s8, s15) * Lambda_0_11_p1152_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1164_lanes = detail::make_pack<Real>(s7, s14) * Lambda_0_11_p1146 +
      detail::make_pack<Real>(c7, c14) * Lambda_0_11_p1149;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1168_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_0_11_p1156_lanes + detail::make_pack<Real>(c9, c16) * Lambda_0_11_p1164_lanes;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p1170 = c4 * Lambda_0_11_p1085;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1171 = s5 * Lambda_0_11_p1170 + c5 * Lambda_0_11_p1083;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p1172 = s4 * Lambda_0_11_p1085;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1173 = c6 * Lambda_0_11_p1171 + s6 * Lambda_0_11_p1172;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1176 = c5 * Lambda_0_11_p1170 - s5 * Lambda_0_11_p1083;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1179_lanes = detail::make_pack<Real>(c7, c14) * Lambda_0_11_p1173 +
      detail::make_pack<Real>(s7, s14) * Lambda_0_11_p1176;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1183 = s6 * Lambda_0_11_p1171 - c6 * Lambda_0_11_p1172;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1186_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_0_11_p1179_lanes + detail::make_pack<Real>(c8, c15) * Lambda_0_11_p1183;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1194_lanes = detail::make_pack<Real>(c7, c14) * Lambda_0_11_p1176 -
      detail::make_pack<Real>(s7, s14) * Lambda_0_11_p1173;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1198_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_0_11_p1186_lanes + detail::make_pack<Real>(c9, c16) * Lambda_0_11_p1194_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1207_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_0_11_p1152_lanes + detail::make_pack<Real>(s8, s15) * Lambda_0_11_p1143;
  const Lanes<2> Lambda_0_11_p1213_lanes = detail::make_pack<Real>(s8, s15) * Lambda_0_11_p1183 -
      detail::make_pack<Real>(c8, c15) * Lambda_0_11_p1179_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<8> Lambda_0_11_p1218_lanes = c10 * detail::make_pack<Real>(Lambda_0_11_p1213_lanes[0],
      Lambda_0_11_p1207_lanes[0], Lambda_0_11_p1121_lanes[0], Lambda_0_11_p1213_lanes[0],
      Lambda_0_11_p1213_lanes[0], Lambda_0_11_p1213_lanes[0], Lambda_0_11_p1213_lanes[0],
      Lambda_0_11_p1213_lanes[0]) - s10 * detail::make_pack<Real>(Lambda_0_11_p1198_lanes[0],
      Lambda_0_11_p1168_lanes[0], Lambda_0_11_p1113_lanes[0], Lambda_0_11_p1198_lanes[0],
      Lambda_0_11_p1198_lanes[0], Lambda_0_11_p1198_lanes[0], Lambda_0_11_p1198_lanes[0],
      Lambda_0_11_p1198_lanes[0]);

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1223_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_0_11_p1218_lanes[2], Lambda_0_11_p1141) -
      detail::make_pack<Real>(s12, s19) * Lambda_0_11_p1137_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1231_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_0_11_p1125_lanes + detail::make_pack<Real>(c11, c18) * Lambda_0_11_p1133_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1235_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1223_lanes - detail::make_pack<Real>(s13, s20) * Lambda_0_11_p1231_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p1237 = c19 * Lambda_0_11_p1137_lanes[1] + s19 * Lambda_0_11_p1141;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_0_11_p1242_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p1168_lanes + detail::make_pack<Real>(s10, s17) * Lambda_0_11_p1207_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1250_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_0_11_p1156_lanes - detail::make_pack<Real>(s9, s16) * Lambda_0_11_p1164_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1254_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p1242_lanes + detail::make_pack<Real>(s11, s18) * Lambda_0_11_p1250_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p1256 = c17 * Lambda_0_11_p1207_lanes[1] - s17 *
      Lambda_0_11_p1168_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p1257 = c19 * Lambda_0_11_p1254_lanes[1] + s19 * Lambda_0_11_p1256;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_0_11_p1262_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_0_11_p1198_lanes + detail::make_pack<Real>(s10, s17) * Lambda_0_11_p1213_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1270_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_0_11_p1186_lanes - detail::make_pack<Real>(s9, s16) * Lambda_0_11_p1194_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1274_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p1262_lanes + detail::make_pack<Real>(s11, s18) * Lambda_0_11_p1270_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p1276 = c17 * Lambda_0_11_p1213_lanes[1] - s17 *
      Lambda_0_11_p1198_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p1277 = c19 * Lambda_0_11_p1274_lanes[1] + s19 * Lambda_0_11_p1276;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1285_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_0_11_p1218_lanes[1], Lambda_0_11_p1256) -
      detail::make_pack<Real>(s12, s19) * Lambda_0_11_p1254_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1287_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1285_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1293_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p1250_lanes - detail::make_pack<Real>(s11, s18) * Lambda_0_11_p1242_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1295_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1293_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1297 = Lambda_0_11_p1287_lanes[1] + Lambda_0_11_p1295_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1302_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_0_11_p1218_lanes[0], Lambda_0_11_p1276) -
      detail::make_pack<Real>(s12, s19) * Lambda_0_11_p1274_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1304_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1302_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1310_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p1270_lanes - detail::make_pack<Real>(s11, s18) * Lambda_0_11_p1262_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1312_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1310_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1314 = Lambda_0_11_p1304_lanes[1] + Lambda_0_11_p1312_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1315_lanes = detail::make_pack<Real>(Lambda_0_11_p1314,
      Lambda_0_11_p1314, Lambda_0_11_p1297, Lambda_0_11_p1235_lanes[1], Lambda_0_11_p1314,
      Lambda_0_11_p1314, Lambda_0_11_p1314, Lambda_0_11_p1314) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1322_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1223_lanes + detail::make_pack<Real>(c13, c20) * Lambda_0_11_p1231_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1324 = -(0.086 * Lambda_0_11_p1322_lanes[1]);
  const Real Lambda_0_11_p1325 = 0.11533812622014242 * Lambda_0_11_p1324;
  const Real Lambda_0_11_p1330 = -Lambda_0_11_p1322_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1335_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1285_lanes;
  const Lanes<2> Lambda_0_11_p1337_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1293_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1339 = Lambda_0_11_p1337_lanes[1] - Lambda_0_11_p1335_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1340_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1310_lanes;
  const Lanes<2> Lambda_0_11_p1342_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1302_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1344 = Lambda_0_11_p1340_lanes[1] - Lambda_0_11_p1342_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1345_lanes = detail::make_pack<Real>(-(0.086 * Lambda_0_11_p1237),
      Lambda_0_11_p1344, Lambda_0_11_p1339, Lambda_0_11_p1330, -(0.086 * Lambda_0_11_p1237),
      -(0.086 * Lambda_0_11_p1237), -(0.086 * Lambda_0_11_p1237), -(0.086 * Lambda_0_11_p1237)) -
      (-0.04672761636452121) * detail::make_pack<Real>(Lambda_0_11_p1324, Lambda_0_11_p1277,
      Lambda_0_11_p1257, Lambda_0_11_p1237, Lambda_0_11_p1324, Lambda_0_11_p1324, Lambda_0_11_p1324,
      Lambda_0_11_p1324);
  const Lanes<8> Lambda_0_11_p1365_lanes = s20 * detail::make_pack<Real>(Lambda_0_11_p1325,
      Lambda_0_11_p1315_lanes[1], Lambda_0_11_p1315_lanes[2], Lambda_0_11_p1315_lanes[3],
      Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325) + c20 *
      Lambda_0_11_p1345_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1373_lanes = c20 * detail::make_pack<Real>(Lambda_0_11_p1325,
      Lambda_0_11_p1315_lanes[1], Lambda_0_11_p1315_lanes[2], Lambda_0_11_p1315_lanes[3],
      Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325) - s20 *
      Lambda_0_11_p1345_lanes - inverse_D11_p1_lanes[1] * Lambda_0_11_p1365_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1385_lanes = 3.0523172236718206 *
      detail::make_pack<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);
  const Lanes<8> Lambda_0_11_p1391_lanes = 17.32841575379867 *
      detail::make_pack<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);
  const Lanes<8> Lambda_0_11_p1397_lanes = s20 * Lambda_0_11_p1385_lanes - c20 *
      Lambda_0_11_p1391_lanes;

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1400 = -(0.086 * Lambda_0_11_p1322_lanes[0]);
  const Lanes<2> Lambda_0_11_p1403_lanes = Lambda_0_11_p1235_lanes +
      detail::make_pack<Real>((-3.0523172236718206), 3.0523172236718206) *
      detail::make_pack<Real>(Lambda_0_11_p1400, Lambda_0_11_p1324);
  const Real Lambda_0_11_p1409 = -Lambda_0_11_p1322_lanes[0];
  const Lanes<2> Lambda_0_11_p1410_lanes = detail::make_pack<Real>(Lambda_0_11_p1409,
      Lambda_0_11_p1330) - 17.32841575379867 * detail::make_pack<Real>(Lambda_0_11_p1400,
      Lambda_0_11_p1324);
  const Lanes<2> Lambda_0_11_p1414_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1403_lanes + detail::make_pack<Real>(c13, c20) * Lambda_0_11_p1410_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1416_lanes = detail::make_pack<Real>(Lambda_0_11_p1414_lanes[1],
      Lambda_0_11_p1397_lanes[1], Lambda_0_11_p1397_lanes[2], Lambda_0_11_p1397_lanes[3],
      Lambda_0_11_p1414_lanes[1], Lambda_0_11_p1414_lanes[1], Lambda_0_11_p1414_lanes[1],
      Lambda_0_11_p1414_lanes[1]) - Lambda_0_11_p61_lanes[1] * Lambda_0_11_p1365_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1428 = -(c19 * Lambda_0_11_p1373_lanes[3]);
  const Real Lambda_0_11_p1429 = -(c19 * Lambda_0_11_p1373_lanes[2]);
  const Real Lambda_0_11_p1430 = -(c19 * Lambda_0_11_p1373_lanes[1]);
  const Real Lambda_0_11_p1431 = -(c19 * Lambda_0_11_p1373_lanes[0]);
  const Lanes<8> Lambda_0_11_p1436_lanes = 0.269 * Lambda_0_11_p1416_lanes - s19 *
      Lambda_0_11_p1373_lanes - inverse_D10_p1_lanes[1] *
      detail::make_pack<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430, Lambda_0_11_p1429,
      Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1444_lanes = Lambda_0_11_p35_lanes[1] * Lambda_0_11_p1365_lanes;
  const Lanes<8> Lambda_0_11_p1462_lanes = c20 * Lambda_0_11_p1385_lanes + s20 *
      Lambda_0_11_p1391_lanes - Lambda_0_11_p11_lanes[1] * Lambda_0_11_p1365_lanes;
  const Lanes<8> Lambda_0_11_p1468_lanes = c19 * Lambda_0_11_p1444_lanes + s19 *
      Lambda_0_11_p1462_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_0_11_p1483_lanes = c12 * detail::make_pack<Real>(Lambda_0_11_p1274_lanes[0],
      Lambda_0_11_p1254_lanes[0], Lambda_0_11_p1137_lanes[0], Lambda_0_11_p1274_lanes[0],
      Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1274_lanes[0],
      Lambda_0_11_p1274_lanes[0]) + s12 * Lambda_0_11_p1218_lanes;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1489 = Lambda_0_11_p1287_lanes[0] + Lambda_0_11_p1295_lanes[0];
  const Real Lambda_0_11_p1490 = Lambda_0_11_p1304_lanes[0] + Lambda_0_11_p1312_lanes[0];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1491_lanes = detail::make_pack<Real>(Lambda_0_11_p1490,
      Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1489,
      Lambda_0_11_p1235_lanes[0], Lambda_0_11_p1490, Lambda_0_11_p1490) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0],
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1483_lanes[2], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0]);
  const Real Lambda_0_11_p1494 = 0.11533812622014242 * Lambda_0_11_p1400;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1495 = Lambda_0_11_p1337_lanes[0] - Lambda_0_11_p1335_lanes[0];

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1496 = 0.009919078854932248 * Lambda_0_11_p1495;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1497 = Lambda_0_11_p1340_lanes[0] - Lambda_0_11_p1342_lanes[0];

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1498 = 0.009919078854932248 * Lambda_0_11_p1497;
  const Lanes<8> Lambda_0_11_p1511_lanes = detail::make_pack<Real>(-(0.086 *
      Lambda_0_11_p1483_lanes[0]), -(0.086 * Lambda_0_11_p1483_lanes[1]),
      -(0.086 * Lambda_0_11_p1483_lanes[2]), Lambda_0_11_p1497, Lambda_0_11_p1495,
      Lambda_0_11_p1409, -(0.086 * Lambda_0_11_p1483_lanes[0]),
      -(0.086 * Lambda_0_11_p1483_lanes[0])) - detail::make_pack<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_pack<Real>(Lambda_0_11_p1497, Lambda_0_11_p1495, Lambda_0_11_p1400,
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1], Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1497, Lambda_0_11_p1497);
  const Lanes<8> Lambda_0_11_p1523_lanes = s13 * detail::make_pack<Real>(Lambda_0_11_p1498,
      Lambda_0_11_p1496, Lambda_0_11_p1494, Lambda_0_11_p1491_lanes[3], Lambda_0_11_p1491_lanes[4],
      Lambda_0_11_p1491_lanes[5], Lambda_0_11_p1498, Lambda_0_11_p1498) + c13 *
      Lambda_0_11_p1511_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1531_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1403_lanes - detail::make_pack<Real>(s13, s20) * Lambda_0_11_p1410_lanes -
      Lambda_0_11_p11_lanes * detail::make_pack<Real>(Lambda_0_11_p1523_lanes[2],
      Lambda_0_11_p1365_lanes[0]);
  const Lanes<2> Lambda_0_11_p1537_lanes = detail::make_pack<Real>(Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1237) - Lambda_0_11_p35_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1523_lanes[2], Lambda_0_11_p1365_lanes[0]);
  const Lanes<2> Lambda_0_11_p1541_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p1531_lanes - detail::make_pack<Real>(c12, c19) * Lambda_0_11_p1537_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1551_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_0_11_p1541_lanes[1], Lambda_0_11_p1468_lanes[1],
      Lambda_0_11_p1468_lanes[2], Lambda_0_11_p1468_lanes[3], Lambda_0_11_p1541_lanes[1],
      Lambda_0_11_p1541_lanes[1], Lambda_0_11_p1541_lanes[1], Lambda_0_11_p1541_lanes[1]) -
      inverse_D10_p8_lanes[1] * detail::make_pack<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430,
      Lambda_0_11_p1429, Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);
  const Lanes<8> Lambda_0_11_p1571_lanes = s18 * Lambda_0_11_p1436_lanes + c18 *
      Lambda_0_11_p1551_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1579_lanes = c18 * Lambda_0_11_p1436_lanes - s18 *
      Lambda_0_11_p1551_lanes - Lambda_0_11_p231_lanes[1] * Lambda_0_11_p1571_lanes;
  const Lanes<8> Lambda_0_11_p1587_lanes = Lambda_0_11_p221_lanes[1] * Lambda_0_11_p1571_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1607_lanes = detail::make_pack<Real>(-Lambda_0_11_p1541_lanes[1],
      -Lambda_0_11_p1468_lanes[1], -Lambda_0_11_p1468_lanes[2], -Lambda_0_11_p1468_lanes[3],
      -Lambda_0_11_p1541_lanes[1], -Lambda_0_11_p1541_lanes[1], -Lambda_0_11_p1541_lanes[1],
      -Lambda_0_11_p1541_lanes[1]) + Lambda_0_11_p55_lanes[1] *
      detail::make_pack<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430, Lambda_0_11_p1429,
      Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);
  const Lanes<8> Lambda_0_11_p1619_lanes = Lambda_0_11_p1416_lanes - Lambda_0_11_p119_lanes[1] *
      detail::make_pack<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430, Lambda_0_11_p1429,
      Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1631_lanes = s18 * Lambda_0_11_p1607_lanes + c18 *
      Lambda_0_11_p1619_lanes - Lambda_0_11_p191_lanes[1] * Lambda_0_11_p1571_lanes;
  const Lanes<8> Lambda_0_11_p1651_lanes = c17 * Lambda_0_11_p1587_lanes - s17 *
      Lambda_0_11_p1579_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p1655_lanes = Lambda_0_11_p259_lanes[1] * Lambda_0_11_p1651_lanes;
  const Lanes<8> Lambda_0_11_p1659_lanes = c17 * Lambda_0_11_p1579_lanes + s17 *
      Lambda_0_11_p1587_lanes + 0.282 * Lambda_0_11_p1631_lanes - Lambda_0_11_p1655_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1677_lanes = s19 * Lambda_0_11_p1444_lanes - c19 *
      Lambda_0_11_p1462_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1704_lanes = c13 * detail::make_pack<Real>(Lambda_0_11_p1498,
      Lambda_0_11_p1496, Lambda_0_11_p1494, Lambda_0_11_p1491_lanes[3], Lambda_0_11_p1491_lanes[4],
      Lambda_0_11_p1491_lanes[5], Lambda_0_11_p1498, Lambda_0_11_p1498) - s13 *
      Lambda_0_11_p1511_lanes - inverse_D11_p1_lanes[0] * Lambda_0_11_p1523_lanes;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_0_11_p1710 = -(c12 * Lambda_0_11_p1704_lanes[5]);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1713_lanes = Lambda_0_11_p35_lanes[0] * Lambda_0_11_p1523_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1722_lanes = (-3.0523172236718206) *
      detail::make_pack<Real>(Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0],
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1483_lanes[2], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0]);
  const Lanes<2> Lambda_0_11_p1727_lanes = detail::make_pack<Real>(Lambda_0_11_p1489,
      Lambda_0_11_p1297) + detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      detail::make_pack<Real>(Lambda_0_11_p1495, Lambda_0_11_p1339);
  const Lanes<2> Lambda_0_11_p1731_lanes = detail::make_pack<Real>(Lambda_0_11_p1490,
      Lambda_0_11_p1314) + detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      detail::make_pack<Real>(Lambda_0_11_p1497, Lambda_0_11_p1344);
  const Lanes<8> Lambda_0_11_p1738_lanes = detail::make_pack<Real>(0.49024375482668536,
      0.49024375482668536, 0.49024375482668536, 17.32841575379867, 17.32841575379867,
      17.32841575379867, 0.49024375482668536, 0.49024375482668536) *
      detail::make_pack<Real>(Lambda_0_11_p1497, Lambda_0_11_p1495, Lambda_0_11_p1497,
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1], Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1497, Lambda_0_11_p1497);
  const Lanes<8> Lambda_0_11_p1748_lanes = c13 * detail::make_pack<Real>(Lambda_0_11_p1731_lanes[0],
      Lambda_0_11_p1727_lanes[0], Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1722_lanes[3],
      Lambda_0_11_p1722_lanes[4], Lambda_0_11_p1722_lanes[5], Lambda_0_11_p1731_lanes[0],
      Lambda_0_11_p1731_lanes[0]) + s13 * Lambda_0_11_p1738_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1753_lanes = Lambda_0_11_p1748_lanes - Lambda_0_11_p11_lanes[0] *
      Lambda_0_11_p1523_lanes;
  const Lanes<8> Lambda_0_11_p1759_lanes = s12 * Lambda_0_11_p1713_lanes - c12 *
      Lambda_0_11_p1753_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p1762_lanes = detail::make_pack<Real>(Lambda_0_11_p1759_lanes[5],
      Lambda_0_11_p1677_lanes[3]) - Lambda_0_11_p337_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1710, Lambda_0_11_p1428);
  const Real Lambda_0_11_p1764 = -(c12 * Lambda_0_11_p1704_lanes[4]);
  const Lanes<2> Lambda_0_11_p1767_lanes = detail::make_pack<Real>(Lambda_0_11_p1759_lanes[4],
      Lambda_0_11_p1677_lanes[2]) - Lambda_0_11_p337_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1764, Lambda_0_11_p1429);
  const Real Lambda_0_11_p1769 = -(c12 * Lambda_0_11_p1704_lanes[3]);
  const Lanes<2> Lambda_0_11_p1772_lanes = detail::make_pack<Real>(Lambda_0_11_p1759_lanes[3],
      Lambda_0_11_p1677_lanes[1]) - Lambda_0_11_p337_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1769, Lambda_0_11_p1430);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1778_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p1537_lanes + detail::make_pack<Real>(c12, c19) * Lambda_0_11_p1531_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1780_lanes = detail::make_pack<Real>(-(-Lambda_0_11_p1778_lanes[1] -
      Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431), -Lambda_0_11_p1772_lanes[1],
      -Lambda_0_11_p1767_lanes[1], -Lambda_0_11_p1762_lanes[1],
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431),
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431),
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431),
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431)) -
      Lambda_0_11_p363_lanes[1] * Lambda_0_11_p1571_lanes;
  const Lanes<8> Lambda_0_11_p1804_lanes = c18 * Lambda_0_11_p1607_lanes - s18 *
      Lambda_0_11_p1619_lanes - Lambda_0_11_p317_lanes[1] * Lambda_0_11_p1571_lanes;
  const Lanes<8> Lambda_0_11_p1812_lanes = s17 * Lambda_0_11_p1780_lanes - c17 *
      Lambda_0_11_p1804_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p1824_lanes = 0.282 * Lambda_0_11_p1812_lanes -
      Lambda_0_11_p401_lanes[1] * Lambda_0_11_p1651_lanes;
  const Lanes<8> Lambda_0_11_p1832_lanes = c16 * Lambda_0_11_p1659_lanes - s16 *
      Lambda_0_11_p1824_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1862_lanes = s13 * detail::make_pack<Real>(Lambda_0_11_p1731_lanes[0],
      Lambda_0_11_p1727_lanes[0], Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1722_lanes[3],
      Lambda_0_11_p1722_lanes[4], Lambda_0_11_p1722_lanes[5], Lambda_0_11_p1731_lanes[0],
      Lambda_0_11_p1731_lanes[0]) - c13 * Lambda_0_11_p1738_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1867_lanes = detail::make_pack<Real>(Lambda_0_11_p1862_lanes[0],
      Lambda_0_11_p1862_lanes[1], Lambda_0_11_p1414_lanes[0], Lambda_0_11_p1862_lanes[3],
      Lambda_0_11_p1862_lanes[4], Lambda_0_11_p1862_lanes[5], Lambda_0_11_p1862_lanes[0],
      Lambda_0_11_p1862_lanes[0]) - Lambda_0_11_p61_lanes[0] * Lambda_0_11_p1523_lanes;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_0_11_p1885 = -(c12 * Lambda_0_11_p1704_lanes[2]);
  const Real Lambda_0_11_p1886 = -(c12 * Lambda_0_11_p1704_lanes[1]);
  const Real Lambda_0_11_p1887 = -(c12 * Lambda_0_11_p1704_lanes[0]);
  const Lanes<8> Lambda_0_11_p1894_lanes = 0.269 * Lambda_0_11_p1867_lanes - s12 *
      Lambda_0_11_p1704_lanes - inverse_D10_p1_lanes[0] *
      detail::make_pack<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886, Lambda_0_11_p1885,
      Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1912_lanes = c12 * Lambda_0_11_p1713_lanes + s12 *
      Lambda_0_11_p1753_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1915 = 0.49024375482668536 * Lambda_0_11_p1339;
  const Real Lambda_0_11_p1916 = -(0.086 * Lambda_0_11_p1257) - (-0.004018575007348824) *
      Lambda_0_11_p1339;
  const Real Lambda_0_11_p1917 = 0.009919078854932248 * Lambda_0_11_p1339;
  const Real Lambda_0_11_p1918 = s20 * Lambda_0_11_p1917 + c20 * Lambda_0_11_p1916;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1921_lanes = detail::make_pack<Real>(Lambda_0_11_p1748_lanes[1], c20 *
      Lambda_0_11_p1727_lanes[1] + s20 * Lambda_0_11_p1915) - Lambda_0_11_p11_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1523_lanes[1], Lambda_0_11_p1918);
  const Lanes<2> Lambda_0_11_p1927_lanes = detail::make_pack<Real>(Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1257) - Lambda_0_11_p35_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1523_lanes[1], Lambda_0_11_p1918);
  const Lanes<2> Lambda_0_11_p1931_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p1921_lanes - detail::make_pack<Real>(c12, c19) * Lambda_0_11_p1927_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1933 = 0.49024375482668536 * Lambda_0_11_p1344;
  const Real Lambda_0_11_p1934 = 0.009919078854932248 * Lambda_0_11_p1344;
  const Real Lambda_0_11_p1935 = -(0.086 * Lambda_0_11_p1277) - (-0.004018575007348824) *
      Lambda_0_11_p1344;
  const Real Lambda_0_11_p1936 = s20 * Lambda_0_11_p1934 + c20 * Lambda_0_11_p1935;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1939_lanes = detail::make_pack<Real>(Lambda_0_11_p1748_lanes[0], c20 *
      Lambda_0_11_p1731_lanes[1] + s20 * Lambda_0_11_p1933) - Lambda_0_11_p11_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1523_lanes[0], Lambda_0_11_p1936);
  const Lanes<2> Lambda_0_11_p1945_lanes = detail::make_pack<Real>(Lambda_0_11_p1483_lanes[0],
      Lambda_0_11_p1277) - Lambda_0_11_p35_lanes *
      detail::make_pack<Real>(Lambda_0_11_p1523_lanes[0], Lambda_0_11_p1936);
  const Lanes<2> Lambda_0_11_p1949_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p1939_lanes - detail::make_pack<Real>(c12, c19) * Lambda_0_11_p1945_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1963_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_0_11_p1949_lanes[0], Lambda_0_11_p1931_lanes[0],
      Lambda_0_11_p1541_lanes[0], Lambda_0_11_p1912_lanes[3], Lambda_0_11_p1912_lanes[4],
      Lambda_0_11_p1912_lanes[5], Lambda_0_11_p1949_lanes[0], Lambda_0_11_p1949_lanes[0]) -
      inverse_D10_p8_lanes[0] * detail::make_pack<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886,
      Lambda_0_11_p1885, Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);
  const Lanes<8> Lambda_0_11_p1975_lanes = s11 * Lambda_0_11_p1894_lanes + c11 *
      Lambda_0_11_p1963_lanes;
  const Lanes<8> Lambda_0_11_p1993_lanes = detail::make_pack<Real>(-Lambda_0_11_p1949_lanes[0],
      -Lambda_0_11_p1931_lanes[0], -Lambda_0_11_p1541_lanes[0], -Lambda_0_11_p1912_lanes[3],
      -Lambda_0_11_p1912_lanes[4], -Lambda_0_11_p1912_lanes[5], -Lambda_0_11_p1949_lanes[0],
      -Lambda_0_11_p1949_lanes[0]) + Lambda_0_11_p55_lanes[0] *
      detail::make_pack<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886, Lambda_0_11_p1885,
      Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);
  const Lanes<8> Lambda_0_11_p2011_lanes = Lambda_0_11_p1867_lanes - Lambda_0_11_p119_lanes[0] *
      detail::make_pack<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886, Lambda_0_11_p1885,
      Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2029_lanes = c11 * Lambda_0_11_p1993_lanes - s11 *
      Lambda_0_11_p2011_lanes - Lambda_0_11_p317_lanes[0] * Lambda_0_11_p1975_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p2047_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p1927_lanes + detail::make_pack<Real>(c12, c19) * Lambda_0_11_p1921_lanes;
  const Lanes<2> Lambda_0_11_p2053_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_0_11_p1945_lanes + detail::make_pack<Real>(c12, c19) * Lambda_0_11_p1939_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2055_lanes = detail::make_pack<Real>(-(-Lambda_0_11_p2053_lanes[0] -
      Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1887),
      -(-Lambda_0_11_p2047_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1886),
      -(-Lambda_0_11_p1778_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1885),
      -Lambda_0_11_p1772_lanes[0], -Lambda_0_11_p1767_lanes[0], -Lambda_0_11_p1762_lanes[0],
      -(-Lambda_0_11_p2053_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1887),
      -(-Lambda_0_11_p2053_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1887)) -
      Lambda_0_11_p363_lanes[0] * Lambda_0_11_p1975_lanes;
  const Lanes<2> Lambda_0_11_p2063_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(Lambda_0_11_p2029_lanes[5], Lambda_0_11_p1804_lanes[3]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(Lambda_0_11_p2055_lanes[5],
      Lambda_0_11_p1780_lanes[3]);
  const Lanes<2> Lambda_0_11_p2069_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(Lambda_0_11_p2029_lanes[4], Lambda_0_11_p1804_lanes[2]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(Lambda_0_11_p2055_lanes[4],
      Lambda_0_11_p1780_lanes[2]);
  const Lanes<2> Lambda_0_11_p2075_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(Lambda_0_11_p2029_lanes[3], Lambda_0_11_p1804_lanes[1]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(Lambda_0_11_p2055_lanes[3],
      Lambda_0_11_p1780_lanes[1]);
  const Lanes<2> Lambda_0_11_p2081_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(Lambda_0_11_p2029_lanes[2], Lambda_0_11_p1804_lanes[0]) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(Lambda_0_11_p2055_lanes[2],
      Lambda_0_11_p1780_lanes[0]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2083_lanes = detail::make_pack<Real>(-(-Lambda_0_11_p2081_lanes[1] +
      Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2075_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[1]),
      -(-Lambda_0_11_p2069_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[2]),
      -(-Lambda_0_11_p2063_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[3]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0])) +
      Lambda_0_11_p555_lanes[1] * Lambda_0_11_p1832_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2099_lanes = detail::make_pack<Real>(-Lambda_0_11_p1812_lanes[0],
      -Lambda_0_11_p1812_lanes[1], -Lambda_0_11_p1812_lanes[2], -Lambda_0_11_p1812_lanes[3],
      -Lambda_0_11_p1812_lanes[0], -Lambda_0_11_p1812_lanes[0], -Lambda_0_11_p1812_lanes[0],
      -Lambda_0_11_p1812_lanes[0]) + Lambda_0_11_p569_lanes[1] * Lambda_0_11_p1651_lanes;
  const Lanes<8> Lambda_0_11_p2111_lanes = Lambda_0_11_p1631_lanes - Lambda_0_11_p577_lanes[1] *
      Lambda_0_11_p1651_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2123_lanes = s16 * Lambda_0_11_p2099_lanes + c16 *
      Lambda_0_11_p2111_lanes - Lambda_0_11_p609_lanes[1] * Lambda_0_11_p1832_lanes;
  const Lanes<8> Lambda_0_11_p2151_lanes = s16 * Lambda_0_11_p1659_lanes + c16 *
      Lambda_0_11_p1824_lanes - inverse_D7_p1_lanes[1] * Lambda_0_11_p1832_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p2159_lanes = 0.00010499999999999999 / inverse_D8_p3_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2161_lanes = Lambda_0_11_p2159_lanes[1] * Lambda_0_11_p1832_lanes;
  const Lanes<8> Lambda_0_11_p2169_lanes = s15 * Lambda_0_11_p2161_lanes + c15 *
      Lambda_0_11_p2151_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2177_lanes = s15 * Lambda_0_11_p2083_lanes + c15 *
      Lambda_0_11_p2123_lanes - Lambda_0_11_p837_lanes[1] * Lambda_0_11_p2169_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p2181 = s20 * Lambda_0_11_p1727_lanes[1] - c20 * Lambda_0_11_p1915 -
      Lambda_0_11_p61_lanes[1] * Lambda_0_11_p1918;
  const Real Lambda_0_11_p2182 = c20 * Lambda_0_11_p1917 - s20 * Lambda_0_11_p1916 -
      inverse_D11_p1_lanes[1] * Lambda_0_11_p1918;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2183 = -(c19 * Lambda_0_11_p2182);
  const Real Lambda_0_11_p2184 = 0.269 * Lambda_0_11_p2181 - s19 * Lambda_0_11_p2182 -
      inverse_D10_p1_lanes[1] * Lambda_0_11_p2183;
  const Real Lambda_0_11_p2185 = 0.269 * Lambda_0_11_p1931_lanes[1] - inverse_D10_p8_lanes[1] *
      Lambda_0_11_p2183;
  const Real Lambda_0_11_p2186 = s18 * Lambda_0_11_p2184 + c18 * Lambda_0_11_p2185;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2187 = c18 * Lambda_0_11_p2184 - s18 * Lambda_0_11_p2185 -
      Lambda_0_11_p231_lanes[1] * Lambda_0_11_p2186;
  const Real Lambda_0_11_p2188 = Lambda_0_11_p221_lanes[1] * Lambda_0_11_p2186;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2189 = -Lambda_0_11_p1931_lanes[1] + Lambda_0_11_p55_lanes[1] *
      Lambda_0_11_p2183;
  const Real Lambda_0_11_p2190 = Lambda_0_11_p2181 - Lambda_0_11_p119_lanes[1] * Lambda_0_11_p2183;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2191 = s18 * Lambda_0_11_p2189 + c18 * Lambda_0_11_p2190 -
      Lambda_0_11_p191_lanes[1] * Lambda_0_11_p2186;
  const Real Lambda_0_11_p2192 = c17 * Lambda_0_11_p2188 - s17 * Lambda_0_11_p2187;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2193 = c17 * Lambda_0_11_p2187 + s17 * Lambda_0_11_p2188 + 0.282 *
      Lambda_0_11_p2191 - Lambda_0_11_p259_lanes[1] * Lambda_0_11_p2192;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2194 = c18 * Lambda_0_11_p2189 - s18 * Lambda_0_11_p2190 -
      Lambda_0_11_p317_lanes[1] * Lambda_0_11_p2186;
  const Real Lambda_0_11_p2195 = -(-Lambda_0_11_p2047_lanes[1] - Lambda_0_11_p337_lanes[1] *
      Lambda_0_11_p2183) - Lambda_0_11_p363_lanes[1] * Lambda_0_11_p2186;
  const Real Lambda_0_11_p2196 = s17 * Lambda_0_11_p2195 - c17 * Lambda_0_11_p2194;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2197 = 0.282 * Lambda_0_11_p2196 - Lambda_0_11_p401_lanes[1] *
      Lambda_0_11_p2192;
  const Real Lambda_0_11_p2198 = c16 * Lambda_0_11_p2193 - s16 * Lambda_0_11_p2197;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2199 = Lambda_0_11_p2159_lanes[1] * Lambda_0_11_p2198;
  const Real Lambda_0_11_p2200 = s16 * Lambda_0_11_p2193 + c16 * Lambda_0_11_p2197 -
      inverse_D7_p1_lanes[1] * Lambda_0_11_p2198;
  const Real Lambda_0_11_p2201 = s15 * Lambda_0_11_p2199 + c15 * Lambda_0_11_p2200;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p2202 = s20 * Lambda_0_11_p1731_lanes[1] - c20 * Lambda_0_11_p1933 -
      Lambda_0_11_p61_lanes[1] * Lambda_0_11_p1936;
  const Real Lambda_0_11_p2203 = c20 * Lambda_0_11_p1934 - s20 * Lambda_0_11_p1935 -
      inverse_D11_p1_lanes[1] * Lambda_0_11_p1936;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2204 = -(c19 * Lambda_0_11_p2203);
  const Real Lambda_0_11_p2205 = 0.269 * Lambda_0_11_p2202 - s19 * Lambda_0_11_p2203 -
      inverse_D10_p1_lanes[1] * Lambda_0_11_p2204;
  const Real Lambda_0_11_p2206 = 0.269 * Lambda_0_11_p1949_lanes[1] - inverse_D10_p8_lanes[1] *
      Lambda_0_11_p2204;
  const Real Lambda_0_11_p2207 = s18 * Lambda_0_11_p2205 + c18 * Lambda_0_11_p2206;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2208 = c18 * Lambda_0_11_p2205 - s18 * Lambda_0_11_p2206 -
      Lambda_0_11_p231_lanes[1] * Lambda_0_11_p2207;
  const Real Lambda_0_11_p2209 = Lambda_0_11_p221_lanes[1] * Lambda_0_11_p2207;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2210 = -Lambda_0_11_p1949_lanes[1] + Lambda_0_11_p55_lanes[1] *
      Lambda_0_11_p2204;
  const Real Lambda_0_11_p2211 = Lambda_0_11_p2202 - Lambda_0_11_p119_lanes[1] * Lambda_0_11_p2204;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2212 = s18 * Lambda_0_11_p2210 + c18 * Lambda_0_11_p2211 -
      Lambda_0_11_p191_lanes[1] * Lambda_0_11_p2207;
  const Real Lambda_0_11_p2213 = c17 * Lambda_0_11_p2209 - s17 * Lambda_0_11_p2208;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2214 = c17 * Lambda_0_11_p2208 + s17 * Lambda_0_11_p2209 + 0.282 *
      Lambda_0_11_p2212 - Lambda_0_11_p259_lanes[1] * Lambda_0_11_p2213;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2215 = c18 * Lambda_0_11_p2210 - s18 * Lambda_0_11_p2211 -
      Lambda_0_11_p317_lanes[1] * Lambda_0_11_p2207;
  const Real Lambda_0_11_p2216 = -(-Lambda_0_11_p2053_lanes[1] - Lambda_0_11_p337_lanes[1] *
      Lambda_0_11_p2204) - Lambda_0_11_p363_lanes[1] * Lambda_0_11_p2207;
  const Real Lambda_0_11_p2217 = s17 * Lambda_0_11_p2216 - c17 * Lambda_0_11_p2215;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2218 = 0.282 * Lambda_0_11_p2217 - Lambda_0_11_p401_lanes[1] *
      Lambda_0_11_p2213;
  const Real Lambda_0_11_p2219 = c16 * Lambda_0_11_p2214 - s16 * Lambda_0_11_p2218;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2220 = s16 * Lambda_0_11_p2214 + c16 * Lambda_0_11_p2218 -
      inverse_D7_p1_lanes[1] * Lambda_0_11_p2219;
  const Real Lambda_0_11_p2221 = Lambda_0_11_p2159_lanes[1] * Lambda_0_11_p2219;
  const Real Lambda_0_11_p2222 = s15 * Lambda_0_11_p2221 + c15 * Lambda_0_11_p2220;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2247_lanes = c11 * Lambda_0_11_p1894_lanes - s11 *
      Lambda_0_11_p1963_lanes - Lambda_0_11_p231_lanes[0] * Lambda_0_11_p1975_lanes;
  const Lanes<8> Lambda_0_11_p2259_lanes = Lambda_0_11_p221_lanes[0] * Lambda_0_11_p1975_lanes;
  const Lanes<8> Lambda_0_11_p2301_lanes = s11 * Lambda_0_11_p1993_lanes + c11 *
      Lambda_0_11_p2011_lanes - Lambda_0_11_p191_lanes[0] * Lambda_0_11_p1975_lanes;
  const Lanes<8> Lambda_0_11_p2331_lanes = c10 * Lambda_0_11_p2259_lanes - s10 *
      Lambda_0_11_p2247_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2337_lanes = Lambda_0_11_p259_lanes[0] * Lambda_0_11_p2331_lanes;
  const Lanes<8> Lambda_0_11_p2343_lanes = c10 * Lambda_0_11_p2247_lanes + s10 *
      Lambda_0_11_p2259_lanes + 0.282 * Lambda_0_11_p2301_lanes - Lambda_0_11_p2337_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2367_lanes = s10 * Lambda_0_11_p2055_lanes - c10 *
      Lambda_0_11_p2029_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2385_lanes = 0.282 * Lambda_0_11_p2367_lanes -
      Lambda_0_11_p401_lanes[0] * Lambda_0_11_p2331_lanes;
  const Lanes<8> Lambda_0_11_p2415_lanes = c9 * Lambda_0_11_p2343_lanes - s9 *
      Lambda_0_11_p2385_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2427_lanes = s9 * Lambda_0_11_p2343_lanes + c9 *
      Lambda_0_11_p2385_lanes - inverse_D7_p1_lanes[0] * Lambda_0_11_p2415_lanes;
  const Lanes<8> Lambda_0_11_p2439_lanes = Lambda_0_11_p2159_lanes[0] * Lambda_0_11_p2415_lanes;
  const Lanes<8> Lambda_0_11_p2451_lanes = s8 * Lambda_0_11_p2439_lanes + c8 *
      Lambda_0_11_p2427_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p2469_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(Lambda_0_11_p2029_lanes[1], Lambda_0_11_p2194) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(Lambda_0_11_p2055_lanes[1],
      Lambda_0_11_p2195);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2471 = -(-Lambda_0_11_p2469_lanes[1] + Lambda_0_11_p515_lanes[1] *
      Lambda_0_11_p2192) + Lambda_0_11_p555_lanes[1] * Lambda_0_11_p2198;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2472 = -Lambda_0_11_p2196 + Lambda_0_11_p569_lanes[1] * Lambda_0_11_p2192;
  const Real Lambda_0_11_p2473 = Lambda_0_11_p2191 - Lambda_0_11_p577_lanes[1] * Lambda_0_11_p2192;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2474 = s16 * Lambda_0_11_p2472 + c16 * Lambda_0_11_p2473 -
      Lambda_0_11_p609_lanes[1] * Lambda_0_11_p2198;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2475 = -Lambda_0_11_p2217 + Lambda_0_11_p569_lanes[1] * Lambda_0_11_p2213;
  const Real Lambda_0_11_p2476 = Lambda_0_11_p2212 - Lambda_0_11_p577_lanes[1] * Lambda_0_11_p2213;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2477 = s16 * Lambda_0_11_p2475 + c16 * Lambda_0_11_p2476 -
      Lambda_0_11_p609_lanes[1] * Lambda_0_11_p2219;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p2482_lanes = detail::make_pack<Real>(s10, s17) *
      detail::make_pack<Real>(Lambda_0_11_p2029_lanes[0], Lambda_0_11_p2215) +
      detail::make_pack<Real>(c10, c17) * detail::make_pack<Real>(Lambda_0_11_p2055_lanes[0],
      Lambda_0_11_p2216);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2484 = -(-Lambda_0_11_p2482_lanes[1] + Lambda_0_11_p515_lanes[1] *
      Lambda_0_11_p2213) + Lambda_0_11_p555_lanes[1] * Lambda_0_11_p2219;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2491_lanes = detail::make_pack<Real>(-(-Lambda_0_11_p2482_lanes[0] +
      Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[0]),
      -(-Lambda_0_11_p2469_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[1]),
      -(-Lambda_0_11_p2081_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[2]),
      -(-Lambda_0_11_p2075_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[3]),
      -(-Lambda_0_11_p2069_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[4]),
      -(-Lambda_0_11_p2063_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[5]),
      -(-Lambda_0_11_p2482_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[0]),
      -(-Lambda_0_11_p2482_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[0])) +
      Lambda_0_11_p555_lanes[0] * Lambda_0_11_p2415_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2515_lanes = detail::make_pack<Real>(-Lambda_0_11_p2367_lanes[0],
      -Lambda_0_11_p2367_lanes[1], -Lambda_0_11_p2367_lanes[2], -Lambda_0_11_p2367_lanes[3],
      -Lambda_0_11_p2367_lanes[4], -Lambda_0_11_p2367_lanes[5], -Lambda_0_11_p2367_lanes[0],
      -Lambda_0_11_p2367_lanes[0]) + Lambda_0_11_p569_lanes[0] * Lambda_0_11_p2331_lanes;
  const Lanes<8> Lambda_0_11_p2533_lanes = Lambda_0_11_p2301_lanes - Lambda_0_11_p577_lanes[0] *
      Lambda_0_11_p2331_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2551_lanes = s9 * Lambda_0_11_p2515_lanes + c9 *
      Lambda_0_11_p2533_lanes - Lambda_0_11_p609_lanes[0] * Lambda_0_11_p2415_lanes;
  const Lanes<8> Lambda_0_11_p2563_lanes = s8 * Lambda_0_11_p2491_lanes + c8 *
      Lambda_0_11_p2551_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2569_lanes = detail::make_pack<Real>(Lambda_0_11_p2563_lanes[0],
      Lambda_0_11_p2563_lanes[1], Lambda_0_11_p2563_lanes[2], Lambda_0_11_p2563_lanes[3],
      Lambda_0_11_p2563_lanes[4], Lambda_0_11_p2563_lanes[5], s15 * Lambda_0_11_p2484 + c15 *
      Lambda_0_11_p2477, s15 * Lambda_0_11_p2471 + c15 * Lambda_0_11_p2474) -
      detail::make_pack<Real>(Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0],
      Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0],
      Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[1], Lambda_0_11_p837_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p2451_lanes[0], Lambda_0_11_p2451_lanes[1],
      Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3], Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2595_lanes = c15 * Lambda_0_11_p2083_lanes - s15 *
      Lambda_0_11_p2123_lanes - Lambda_0_11_p639_lanes[1] * Lambda_0_11_p2169_lanes;
  const Lanes<8> Lambda_0_11_p2603_lanes = Lambda_0_11_p679_lanes[1] * Lambda_0_11_p2169_lanes;
  const Lanes<8> Lambda_0_11_p2627_lanes = c16 * Lambda_0_11_p2099_lanes - s16 *
      Lambda_0_11_p2111_lanes - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p1832_lanes -
      Lambda_0_11_p2603_lanes;
  const Lanes<8> Lambda_0_11_p2635_lanes = s14 * Lambda_0_11_p2627_lanes + c14 *
      Lambda_0_11_p2595_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2671_lanes = c9 * Lambda_0_11_p2515_lanes - s9 *
      Lambda_0_11_p2533_lanes - Lambda_0_11_p657_lanes[0] * Lambda_0_11_p2415_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2677_lanes = detail::make_pack<Real>(Lambda_0_11_p2671_lanes[0],
      Lambda_0_11_p2671_lanes[1], Lambda_0_11_p2671_lanes[2], Lambda_0_11_p2671_lanes[3],
      Lambda_0_11_p2671_lanes[4], Lambda_0_11_p2671_lanes[5], c16 * Lambda_0_11_p2475 - s16 *
      Lambda_0_11_p2476 - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p2219, c16 * Lambda_0_11_p2472 -
      s16 * Lambda_0_11_p2473 - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p2198) -
      detail::make_pack<Real>(Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0],
      Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0],
      Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[1], Lambda_0_11_p679_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p2451_lanes[0], Lambda_0_11_p2451_lanes[1],
      Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3], Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2713_lanes = c8 * Lambda_0_11_p2491_lanes - s8 *
      Lambda_0_11_p2551_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2719_lanes = detail::make_pack<Real>(Lambda_0_11_p2713_lanes[0],
      Lambda_0_11_p2713_lanes[1], Lambda_0_11_p2713_lanes[2], Lambda_0_11_p2713_lanes[3],
      Lambda_0_11_p2713_lanes[4], Lambda_0_11_p2713_lanes[5], c15 * Lambda_0_11_p2484 - s15 *
      Lambda_0_11_p2477, c15 * Lambda_0_11_p2471 - s15 * Lambda_0_11_p2474) -
      detail::make_pack<Real>(Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0],
      Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0],
      Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[1], Lambda_0_11_p639_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p2451_lanes[0], Lambda_0_11_p2451_lanes[1],
      Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3], Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);
  const Lanes<8> Lambda_0_11_p2735_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_0_11_p2677_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_0_11_p2719_lanes;
  const Lanes<2> Lambda_0_11_p2745_lanes = 0.226 *
      detail::make_pack<Real>(Lambda_0_11_p2569_lanes[5], Lambda_0_11_p2177_lanes[3]) +
      detail::make_pack<Real>(0.18, (-0.18)) * detail::make_pack<Real>(Lambda_0_11_p2735_lanes[5],
      Lambda_0_11_p2635_lanes[3]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2763_lanes = c15 * Lambda_0_11_p2161_lanes - s15 *
      Lambda_0_11_p2151_lanes - inverse_D6_p5_lanes[1] * Lambda_0_11_p2169_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2787_lanes = c8 * Lambda_0_11_p2439_lanes - s8 *
      Lambda_0_11_p2427_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2793_lanes = detail::make_pack<Real>(Lambda_0_11_p2787_lanes[0],
      Lambda_0_11_p2787_lanes[1], Lambda_0_11_p2787_lanes[2], Lambda_0_11_p2787_lanes[3],
      Lambda_0_11_p2787_lanes[4], Lambda_0_11_p2787_lanes[5], c15 * Lambda_0_11_p2221 - s15 *
      Lambda_0_11_p2220, c15 * Lambda_0_11_p2199 - s15 * Lambda_0_11_p2200) -
      detail::make_pack<Real>(inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[1], inverse_D6_p5_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p2451_lanes[0], Lambda_0_11_p2451_lanes[1],
      Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3], Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p2803_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p17_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2805_lanes = Lambda_0_11_p2803_lanes[1] * Lambda_0_11_p2169_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2809_lanes = detail::make_pack<Real>(Lambda_0_11_p2803_lanes[0],
      Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[0],
      Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[1],
      Lambda_0_11_p2803_lanes[1]) * detail::make_pack<Real>(Lambda_0_11_p2451_lanes[0],
      Lambda_0_11_p2451_lanes[1], Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3],
      Lambda_0_11_p2451_lanes[4], Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);
  const Lanes<2> Lambda_0_11_p2821_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(Lambda_0_11_p2809_lanes[5], Lambda_0_11_p2805_lanes[3]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(Lambda_0_11_p2793_lanes[5],
      Lambda_0_11_p2763_lanes[3]) + Lambda_0_11_p2745_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2823 = -Lambda_0_11_p2821_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p2834_lanes = 0.226 *
      detail::make_pack<Real>(Lambda_0_11_p2569_lanes[4], Lambda_0_11_p2177_lanes[2]) +
      detail::make_pack<Real>(0.18, (-0.18)) * detail::make_pack<Real>(Lambda_0_11_p2735_lanes[4],
      Lambda_0_11_p2635_lanes[2]);
  const Lanes<2> Lambda_0_11_p2836_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(Lambda_0_11_p2809_lanes[4], Lambda_0_11_p2805_lanes[2]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(Lambda_0_11_p2793_lanes[4],
      Lambda_0_11_p2763_lanes[2]) + Lambda_0_11_p2834_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2838 = -Lambda_0_11_p2836_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p2843_lanes = 0.226 *
      detail::make_pack<Real>(Lambda_0_11_p2569_lanes[3], Lambda_0_11_p2177_lanes[1]) +
      detail::make_pack<Real>(0.18, (-0.18)) * detail::make_pack<Real>(Lambda_0_11_p2735_lanes[3],
      Lambda_0_11_p2635_lanes[1]);
  const Lanes<2> Lambda_0_11_p2851_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(Lambda_0_11_p2809_lanes[3], Lambda_0_11_p2805_lanes[1]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(Lambda_0_11_p2793_lanes[3],
      Lambda_0_11_p2763_lanes[1]) + Lambda_0_11_p2843_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2853 = -Lambda_0_11_p2851_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p2858_lanes = 0.226 *
      detail::make_pack<Real>(Lambda_0_11_p2569_lanes[2], Lambda_0_11_p2177_lanes[0]) +
      detail::make_pack<Real>(0.18, (-0.18)) * detail::make_pack<Real>(Lambda_0_11_p2735_lanes[2],
      Lambda_0_11_p2635_lanes[0]);
  const Lanes<2> Lambda_0_11_p2866_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(Lambda_0_11_p2809_lanes[2], Lambda_0_11_p2805_lanes[0]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(Lambda_0_11_p2793_lanes[2],
      Lambda_0_11_p2763_lanes[0]) + Lambda_0_11_p2858_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2868 = -Lambda_0_11_p2866_lanes[1];
  const Lanes<8> Lambda_0_11_p2869_lanes = inverse_D5_p16 *
      detail::make_pack<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2881_lanes = c14 * Lambda_0_11_p2627_lanes - s14 *
      Lambda_0_11_p2595_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p2905_lanes = (-0.18) * Lambda_0_11_p2881_lanes -
      (s14 * Lambda_0_11_p2805_lanes - c14 * Lambda_0_11_p2763_lanes) - Lambda_0_11_p2869_lanes;
  const Lanes<8> Lambda_0_11_p2921_lanes = 0.226 * Lambda_0_11_p2881_lanes - inverse_D5_p22 *
      detail::make_pack<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);
  const Lanes<8> Lambda_0_11_p2937_lanes = Lambda_0_11_p2881_lanes - Lambda_0_11_p993 *
      detail::make_pack<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);
  const Lanes<8> Lambda_0_11_p2945_lanes = s6 * Lambda_0_11_p2905_lanes + c6 *
      Lambda_0_11_p2921_lanes + 0.072 * Lambda_0_11_p2937_lanes;
  const Lanes<8> Lambda_0_11_p2953_lanes = Lambda_0_11_p2635_lanes + Lambda_0_11_p930 *
      detail::make_pack<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);
  const Lanes<8> Lambda_0_11_p2965_lanes = Lambda_0_11_p2177_lanes - Lambda_0_11_p984 *
      detail::make_pack<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);
  const Lanes<8> Lambda_0_11_p2973_lanes = s6 * Lambda_0_11_p2953_lanes + c6 *
      Lambda_0_11_p2965_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2977 = -(0.072 * Lambda_0_11_p2973_lanes[3]) + Lambda_0_11_p1020 *
      Lambda_0_11_p2945_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p2986_lanes = c6 * Lambda_0_11_p2905_lanes - s6 *
      Lambda_0_11_p2921_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2990 = Lambda_0_11_p2986_lanes[3] - Lambda_0_11_p1022 *
      Lambda_0_11_p2945_lanes[3];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2991 = -(s5 * Lambda_0_11_p2977 + c5 * Lambda_0_11_p2990);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2992 = -(0.072 * Lambda_0_11_p2973_lanes[2]) + Lambda_0_11_p1020 *
      Lambda_0_11_p2945_lanes[2];
  const Real Lambda_0_11_p2993 = Lambda_0_11_p2986_lanes[2] - Lambda_0_11_p1022 *
      Lambda_0_11_p2945_lanes[2];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2994 = -(s5 * Lambda_0_11_p2992 + c5 * Lambda_0_11_p2993);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2995 = -(0.072 * Lambda_0_11_p2973_lanes[1]) + Lambda_0_11_p1020 *
      Lambda_0_11_p2945_lanes[1];
  const Real Lambda_0_11_p2996 = Lambda_0_11_p2986_lanes[1] - Lambda_0_11_p1022 *
      Lambda_0_11_p2945_lanes[1];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2997 = -(s5 * Lambda_0_11_p2995 + c5 * Lambda_0_11_p2996);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2998 = -(0.072 * Lambda_0_11_p2973_lanes[0]) + Lambda_0_11_p1020 *
      Lambda_0_11_p2945_lanes[0];
  const Real Lambda_0_11_p2999 = Lambda_0_11_p2986_lanes[0] - Lambda_0_11_p1022 *
      Lambda_0_11_p2945_lanes[0];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3000 = -(s5 * Lambda_0_11_p2998 + c5 * Lambda_0_11_p2999);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3009_lanes = Lambda_0_11_p2973_lanes - Lambda_0_11_p1005 *
      Lambda_0_11_p2945_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3033_lanes = c6 * Lambda_0_11_p2953_lanes - s6 *
      Lambda_0_11_p2965_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3037 = Lambda_0_11_p3033_lanes[3] - Lambda_0_11_p1033 *
      Lambda_0_11_p2945_lanes[3];
  const Real Lambda_0_11_p3038 = Lambda_0_11_p2937_lanes[3] - Lambda_0_11_p1029 *
      Lambda_0_11_p2945_lanes[3];
  const Real Lambda_0_11_p3039 = s5 * Lambda_0_11_p3037 - c5 * Lambda_0_11_p3038;
  const Real Lambda_0_11_p3040 = Lambda_0_11_p3033_lanes[2] - Lambda_0_11_p1033 *
      Lambda_0_11_p2945_lanes[2];
  const Real Lambda_0_11_p3041 = Lambda_0_11_p2937_lanes[2] - Lambda_0_11_p1029 *
      Lambda_0_11_p2945_lanes[2];
  const Real Lambda_0_11_p3042 = s5 * Lambda_0_11_p3040 - c5 * Lambda_0_11_p3041;
  const Real Lambda_0_11_p3043 = Lambda_0_11_p3033_lanes[1] - Lambda_0_11_p1033 *
      Lambda_0_11_p2945_lanes[1];
  const Real Lambda_0_11_p3044 = Lambda_0_11_p2937_lanes[1] - Lambda_0_11_p1029 *
      Lambda_0_11_p2945_lanes[1];
  const Real Lambda_0_11_p3045 = s5 * Lambda_0_11_p3043 - c5 * Lambda_0_11_p3044;
  const Real Lambda_0_11_p3046 = Lambda_0_11_p3033_lanes[0] - Lambda_0_11_p1033 *
      Lambda_0_11_p2945_lanes[0];
  const Real Lambda_0_11_p3047 = Lambda_0_11_p2937_lanes[0] - Lambda_0_11_p1029 *
      Lambda_0_11_p2945_lanes[0];
  const Real Lambda_0_11_p3048 = s5 * Lambda_0_11_p3046 - c5 * Lambda_0_11_p3047;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3053_lanes = c4 * (detail::make_pack<Real>(-(0.21799999999999997 *
      Lambda_0_11_p3048), -(0.21799999999999997 * Lambda_0_11_p3045),
      -(0.21799999999999997 * Lambda_0_11_p3042), -(0.21799999999999997 * Lambda_0_11_p3039),
      -(0.21799999999999997 * Lambda_0_11_p3048), -(0.21799999999999997 * Lambda_0_11_p3048),
      -(0.21799999999999997 * Lambda_0_11_p3048), -(0.21799999999999997 * Lambda_0_11_p3048)) +
      inverse_D3_p2 * detail::make_pack<Real>(Lambda_0_11_p3000, Lambda_0_11_p2997,
      Lambda_0_11_p2994, Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000));
  const Lanes<8> Lambda_0_11_p3057_lanes = s4 * (detail::make_pack<Real>(-(s5 * Lambda_0_11_p2999 -
      c5 * Lambda_0_11_p2998 + 0.21799999999999997 * Lambda_0_11_p3009_lanes[0]),
      -(s5 * Lambda_0_11_p2996 - c5 * Lambda_0_11_p2995 + 0.21799999999999997 *
      Lambda_0_11_p3009_lanes[1]), -(s5 * Lambda_0_11_p2993 - c5 * Lambda_0_11_p2992 +
      0.21799999999999997 * Lambda_0_11_p3009_lanes[2]),
      -(s5 * Lambda_0_11_p2990 - c5 * Lambda_0_11_p2977 + 0.21799999999999997 *
      Lambda_0_11_p3009_lanes[3]), -(s5 * Lambda_0_11_p2999 - c5 * Lambda_0_11_p2998 +
      0.21799999999999997 * Lambda_0_11_p3009_lanes[0]),
      -(s5 * Lambda_0_11_p2999 - c5 * Lambda_0_11_p2998 + 0.21799999999999997 *
      Lambda_0_11_p3009_lanes[0]), -(s5 * Lambda_0_11_p2999 - c5 * Lambda_0_11_p2998 +
      0.21799999999999997 * Lambda_0_11_p3009_lanes[0]),
      -(s5 * Lambda_0_11_p2999 - c5 * Lambda_0_11_p2998 + 0.21799999999999997 *
      Lambda_0_11_p3009_lanes[0])) - inverse_D3_p1 * detail::make_pack<Real>(Lambda_0_11_p3000,
      Lambda_0_11_p2997, Lambda_0_11_p2994, Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000, Lambda_0_11_p3000)) + Lambda_0_11_p3053_lanes;
  const Lanes<8> Lambda_0_11_p3085_lanes = s4 * (Lambda_0_11_p3009_lanes + Lambda_0_11_p1050 *
      detail::make_pack<Real>(Lambda_0_11_p3000, Lambda_0_11_p2997, Lambda_0_11_p2994,
      Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000));

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3093_lanes = c4 * (detail::make_pack<Real>(-Lambda_0_11_p3048,
      -Lambda_0_11_p3045, -Lambda_0_11_p3042, -Lambda_0_11_p3039, -Lambda_0_11_p3048,
      -Lambda_0_11_p3048, -Lambda_0_11_p3048, -Lambda_0_11_p3048) + Lambda_0_11_p1041 *
      detail::make_pack<Real>(Lambda_0_11_p3000, Lambda_0_11_p2997, Lambda_0_11_p2994,
      Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000)) - Lambda_0_11_p3085_lanes - Lambda_0_11_p1063 * Lambda_0_11_p3057_lanes;
  const Lanes<8> Lambda_0_11_p3105_lanes = detail::make_pack<Real>(-(-(s5 * Lambda_0_11_p3047 + c5 *
      Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3044 + c5 * Lambda_0_11_p3043) - Lambda_0_11_p1068 * Lambda_0_11_p2997),
      -(-(s5 * Lambda_0_11_p3041 + c5 * Lambda_0_11_p3040) - Lambda_0_11_p1068 * Lambda_0_11_p2994),
      -(-(s5 * Lambda_0_11_p3038 + c5 * Lambda_0_11_p3037) - Lambda_0_11_p1068 * Lambda_0_11_p2991),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 *
      Lambda_0_11_p3000)) + Lambda_0_11_p1073 * Lambda_0_11_p3057_lanes;
  const Lanes<8> Lambda_0_11_p3113_lanes = c3 * Lambda_0_11_p3093_lanes - s3 *
      Lambda_0_11_p3105_lanes;
  const Lanes<8> Lambda_0_11_p3117_lanes = 0.422 * Lambda_0_11_p3113_lanes;

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p3133 = c3 * Lambda_0_11_p1076 - Lambda_0_11_p1075;
  const Real Lambda_0_11_p3134 = 0.031999971599999996 + 0.422 * Lambda_0_11_p3133;

  // link 2 (thigh), articulated inertia
  const Real Lambda_0_11_p3135 = Lambda_0_11_p3134 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3156_lanes = s2 * (s3 * Lambda_0_11_p3093_lanes + c3 *
      Lambda_0_11_p3105_lanes - Lambda_0_11_p3135 * Lambda_0_11_p3117_lanes);
  const Lanes<8> Lambda_0_11_p3164_lanes = 0.434 * (c2 *
      (Lambda_0_11_p3113_lanes - Lambda_0_11_p1080 * Lambda_0_11_p3117_lanes) -
      Lambda_0_11_p3156_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = Lambda_0_11_p1078 - Lambda_0_11_p1079 * Lambda_0_11_p1080;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (Lambda_0_11_p1074 + Lambda_0_11_p1077 -
      Lambda_0_11_p3134 * Lambda_0_11_p3135)) + c2 * (2.0 *
      (Lambda_0_11_p3133 - Lambda_0_11_p1079 * Lambda_0_11_p3135));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p3168_lanes = Lambda_0_11_p3164_lanes * inverse_D1;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p3182_lanes = 0.226 *
      detail::make_pack<Real>(Lambda_0_11_p2569_lanes[1], Lambda_0_11_p2569_lanes[7]) +
      detail::make_pack<Real>(0.18, (-0.18)) * detail::make_pack<Real>(Lambda_0_11_p2735_lanes[1],
      Lambda_0_11_p2735_lanes[7]);
  const Lanes<2> Lambda_0_11_p3184_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(Lambda_0_11_p2809_lanes[1], Lambda_0_11_p2809_lanes[7]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(Lambda_0_11_p2793_lanes[1],
      Lambda_0_11_p2793_lanes[7]) + Lambda_0_11_p3182_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p3186 = -Lambda_0_11_p3184_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p3191_lanes = 0.226 *
      detail::make_pack<Real>(Lambda_0_11_p2569_lanes[0], Lambda_0_11_p2569_lanes[6]) +
      detail::make_pack<Real>(0.18, (-0.18)) * detail::make_pack<Real>(Lambda_0_11_p2735_lanes[0],
      Lambda_0_11_p2735_lanes[6]);
  const Lanes<2> Lambda_0_11_p3199_lanes = detail::make_pack<Real>(c7, c14) *
      detail::make_pack<Real>(Lambda_0_11_p2809_lanes[0], Lambda_0_11_p2809_lanes[6]) +
      detail::make_pack<Real>(s7, s14) * detail::make_pack<Real>(Lambda_0_11_p2793_lanes[0],
      Lambda_0_11_p2793_lanes[6]) + Lambda_0_11_p3191_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p3201 = -Lambda_0_11_p3199_lanes[1];
  const Real Lambda_0_11_p3202 = -Lambda_0_11_p2821_lanes[0];
  const Real Lambda_0_11_p3203 = -Lambda_0_11_p2836_lanes[0];
  const Real Lambda_0_11_p3204 = -Lambda_0_11_p2851_lanes[0];
  const Real Lambda_0_11_p3205 = -Lambda_0_11_p2866_lanes[0];
  const Real Lambda_0_11_p3206 = -Lambda_0_11_p3184_lanes[0];
  const Real Lambda_0_11_p3207 = -Lambda_0_11_p3199_lanes[0];
  const Lanes<8> Lambda_0_11_p3208_lanes = inverse_D5_p16 *
      detail::make_pack<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3232_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_0_11_p2677_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_0_11_p2719_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3280_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_0_11_p3232_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_0_11_p2809_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_0_11_p2793_lanes) -
      Lambda_0_11_p3208_lanes;
  const Lanes<8> Lambda_0_11_p3312_lanes = 0.226 * Lambda_0_11_p3232_lanes - inverse_D5_p22 *
      detail::make_pack<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);
  const Lanes<8> Lambda_0_11_p3344_lanes = Lambda_0_11_p3232_lanes - Lambda_0_11_p993 *
      detail::make_pack<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);
  const Lanes<8> Lambda_0_11_p3360_lanes = s6 * Lambda_0_11_p3280_lanes + c6 *
      Lambda_0_11_p3312_lanes + 0.072 * Lambda_0_11_p3344_lanes;
  const Lanes<8> Lambda_0_11_p3376_lanes = Lambda_0_11_p2735_lanes + Lambda_0_11_p930 *
      detail::make_pack<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);
  const Lanes<8> Lambda_0_11_p3400_lanes = Lambda_0_11_p2569_lanes - Lambda_0_11_p984 *
      detail::make_pack<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);
  const Lanes<8> Lambda_0_11_p3416_lanes = s6 * Lambda_0_11_p3376_lanes + c6 *
      Lambda_0_11_p3400_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3424 = -(0.072 * Lambda_0_11_p3416_lanes[7]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3441_lanes = c6 * Lambda_0_11_p3280_lanes - s6 *
      Lambda_0_11_p3312_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3449 = Lambda_0_11_p3441_lanes[7] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[7];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3450 = -(s5 * Lambda_0_11_p3424 + c5 * Lambda_0_11_p3449);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3451 = -(0.072 * Lambda_0_11_p3416_lanes[6]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[6];
  const Real Lambda_0_11_p3452 = Lambda_0_11_p3441_lanes[6] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[6];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3453 = -(s5 * Lambda_0_11_p3451 + c5 * Lambda_0_11_p3452);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3454 = -(0.072 * Lambda_0_11_p3416_lanes[5]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[5];
  const Real Lambda_0_11_p3455 = Lambda_0_11_p3441_lanes[5] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[5];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3456 = -(s5 * Lambda_0_11_p3454 + c5 * Lambda_0_11_p3455);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3457 = -(0.072 * Lambda_0_11_p3416_lanes[4]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[4];
  const Real Lambda_0_11_p3458 = Lambda_0_11_p3441_lanes[4] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[4];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3459 = -(s5 * Lambda_0_11_p3457 + c5 * Lambda_0_11_p3458);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3460 = -(0.072 * Lambda_0_11_p3416_lanes[3]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[3];
  const Real Lambda_0_11_p3461 = Lambda_0_11_p3441_lanes[3] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[3];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3462 = -(s5 * Lambda_0_11_p3460 + c5 * Lambda_0_11_p3461);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3463 = -(0.072 * Lambda_0_11_p3416_lanes[2]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[2];
  const Real Lambda_0_11_p3464 = Lambda_0_11_p3441_lanes[2] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[2];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3465 = -(s5 * Lambda_0_11_p3463 + c5 * Lambda_0_11_p3464);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3466 = -(0.072 * Lambda_0_11_p3416_lanes[1]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[1];
  const Real Lambda_0_11_p3467 = Lambda_0_11_p3441_lanes[1] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[1];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3468 = -(s5 * Lambda_0_11_p3466 + c5 * Lambda_0_11_p3467);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3469 = -(0.072 * Lambda_0_11_p3416_lanes[0]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[0];
  const Real Lambda_0_11_p3470 = Lambda_0_11_p3441_lanes[0] - Lambda_0_11_p1022 *
      Lambda_0_11_p3360_lanes[0];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p3471 = -(s5 * Lambda_0_11_p3469 + c5 * Lambda_0_11_p3470);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3488_lanes = Lambda_0_11_p3416_lanes - Lambda_0_11_p1005 *
      Lambda_0_11_p3360_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3536_lanes = c6 * Lambda_0_11_p3376_lanes - s6 *
      Lambda_0_11_p3400_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3544 = Lambda_0_11_p3536_lanes[7] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[7];
  const Real Lambda_0_11_p3545 = Lambda_0_11_p3344_lanes[7] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[7];
  const Real Lambda_0_11_p3546 = s5 * Lambda_0_11_p3544 - c5 * Lambda_0_11_p3545;
  const Real Lambda_0_11_p3547 = Lambda_0_11_p3536_lanes[6] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[6];
  const Real Lambda_0_11_p3548 = Lambda_0_11_p3344_lanes[6] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[6];
  const Real Lambda_0_11_p3549 = s5 * Lambda_0_11_p3547 - c5 * Lambda_0_11_p3548;
  const Real Lambda_0_11_p3550 = Lambda_0_11_p3536_lanes[5] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[5];
  const Real Lambda_0_11_p3551 = Lambda_0_11_p3344_lanes[5] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[5];
  const Real Lambda_0_11_p3552 = s5 * Lambda_0_11_p3550 - c5 * Lambda_0_11_p3551;
  const Real Lambda_0_11_p3553 = Lambda_0_11_p3536_lanes[4] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[4];
  const Real Lambda_0_11_p3554 = Lambda_0_11_p3344_lanes[4] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[4];
  const Real Lambda_0_11_p3555 = s5 * Lambda_0_11_p3553 - c5 * Lambda_0_11_p3554;
  const Real Lambda_0_11_p3556 = Lambda_0_11_p3536_lanes[3] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[3];
  const Real Lambda_0_11_p3557 = Lambda_0_11_p3344_lanes[3] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[3];
  const Real Lambda_0_11_p3558 = s5 * Lambda_0_11_p3556 - c5 * Lambda_0_11_p3557;
  const Real Lambda_0_11_p3559 = Lambda_0_11_p3536_lanes[2] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[2];
  const Real Lambda_0_11_p3560 = Lambda_0_11_p3344_lanes[2] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[2];
  const Real Lambda_0_11_p3561 = s5 * Lambda_0_11_p3559 - c5 * Lambda_0_11_p3560;
  const Real Lambda_0_11_p3562 = Lambda_0_11_p3536_lanes[1] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[1];
  const Real Lambda_0_11_p3563 = Lambda_0_11_p3344_lanes[1] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[1];
  const Real Lambda_0_11_p3564 = s5 * Lambda_0_11_p3562 - c5 * Lambda_0_11_p3563;
  const Real Lambda_0_11_p3565 = Lambda_0_11_p3536_lanes[0] - Lambda_0_11_p1033 *
      Lambda_0_11_p3360_lanes[0];
  const Real Lambda_0_11_p3566 = Lambda_0_11_p3344_lanes[0] - Lambda_0_11_p1029 *
      Lambda_0_11_p3360_lanes[0];
  const Real Lambda_0_11_p3567 = s5 * Lambda_0_11_p3565 - c5 * Lambda_0_11_p3566;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3576_lanes = c4 * (detail::make_pack<Real>(-(0.21799999999999997 *
      Lambda_0_11_p3567), -(0.21799999999999997 * Lambda_0_11_p3564),
      -(0.21799999999999997 * Lambda_0_11_p3561), -(0.21799999999999997 * Lambda_0_11_p3558),
      -(0.21799999999999997 * Lambda_0_11_p3555), -(0.21799999999999997 * Lambda_0_11_p3552),
      -(0.21799999999999997 * Lambda_0_11_p3549), -(0.21799999999999997 * Lambda_0_11_p3546)) +
      inverse_D3_p2 * detail::make_pack<Real>(Lambda_0_11_p3471, Lambda_0_11_p3468,
      Lambda_0_11_p3465, Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456, Lambda_0_11_p3453,
      Lambda_0_11_p3450));
  const Lanes<8> Lambda_0_11_p3584_lanes = s4 * (detail::make_pack<Real>(-(s5 * Lambda_0_11_p3470 -
      c5 * Lambda_0_11_p3469 + 0.21799999999999997 * Lambda_0_11_p3488_lanes[0]),
      -(s5 * Lambda_0_11_p3467 - c5 * Lambda_0_11_p3466 + 0.21799999999999997 *
      Lambda_0_11_p3488_lanes[1]), -(s5 * Lambda_0_11_p3464 - c5 * Lambda_0_11_p3463 +
      0.21799999999999997 * Lambda_0_11_p3488_lanes[2]),
      -(s5 * Lambda_0_11_p3461 - c5 * Lambda_0_11_p3460 + 0.21799999999999997 *
      Lambda_0_11_p3488_lanes[3]), -(s5 * Lambda_0_11_p3458 - c5 * Lambda_0_11_p3457 +
      0.21799999999999997 * Lambda_0_11_p3488_lanes[4]),
      -(s5 * Lambda_0_11_p3455 - c5 * Lambda_0_11_p3454 + 0.21799999999999997 *
      Lambda_0_11_p3488_lanes[5]), -(s5 * Lambda_0_11_p3452 - c5 * Lambda_0_11_p3451 +
      0.21799999999999997 * Lambda_0_11_p3488_lanes[6]),
      -(s5 * Lambda_0_11_p3449 - c5 * Lambda_0_11_p3424 + 0.21799999999999997 *
      Lambda_0_11_p3488_lanes[7])) - inverse_D3_p1 * detail::make_pack<Real>(Lambda_0_11_p3471,
      Lambda_0_11_p3468, Lambda_0_11_p3465, Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456,
      Lambda_0_11_p3453, Lambda_0_11_p3450)) + Lambda_0_11_p3576_lanes;
  const Lanes<8> Lambda_0_11_p3640_lanes = s4 * (Lambda_0_11_p3488_lanes + Lambda_0_11_p1050 *
      detail::make_pack<Real>(Lambda_0_11_p3471, Lambda_0_11_p3468, Lambda_0_11_p3465,
      Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456, Lambda_0_11_p3453,
      Lambda_0_11_p3450));

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3656_lanes = c4 * (detail::make_pack<Real>(-Lambda_0_11_p3567,
      -Lambda_0_11_p3564, -Lambda_0_11_p3561, -Lambda_0_11_p3558, -Lambda_0_11_p3555,
      -Lambda_0_11_p3552, -Lambda_0_11_p3549, -Lambda_0_11_p3546) + Lambda_0_11_p1041 *
      detail::make_pack<Real>(Lambda_0_11_p3471, Lambda_0_11_p3468, Lambda_0_11_p3465,
      Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456, Lambda_0_11_p3453,
      Lambda_0_11_p3450)) - Lambda_0_11_p3640_lanes - Lambda_0_11_p1063 * Lambda_0_11_p3584_lanes;
  const Lanes<8> Lambda_0_11_p3680_lanes = detail::make_pack<Real>(-(-(s5 * Lambda_0_11_p3566 + c5 *
      Lambda_0_11_p3565) - Lambda_0_11_p1068 * Lambda_0_11_p3471),
      -(-(s5 * Lambda_0_11_p3563 + c5 * Lambda_0_11_p3562) - Lambda_0_11_p1068 * Lambda_0_11_p3468),
      -(-(s5 * Lambda_0_11_p3560 + c5 * Lambda_0_11_p3559) - Lambda_0_11_p1068 * Lambda_0_11_p3465),
      -(-(s5 * Lambda_0_11_p3557 + c5 * Lambda_0_11_p3556) - Lambda_0_11_p1068 * Lambda_0_11_p3462),
      -(-(s5 * Lambda_0_11_p3554 + c5 * Lambda_0_11_p3553) - Lambda_0_11_p1068 * Lambda_0_11_p3459),
      -(-(s5 * Lambda_0_11_p3551 + c5 * Lambda_0_11_p3550) - Lambda_0_11_p1068 * Lambda_0_11_p3456),
      -(-(s5 * Lambda_0_11_p3548 + c5 * Lambda_0_11_p3547) - Lambda_0_11_p1068 * Lambda_0_11_p3453),
      -(-(s5 * Lambda_0_11_p3545 + c5 * Lambda_0_11_p3544) - Lambda_0_11_p1068 *
      Lambda_0_11_p3450)) + Lambda_0_11_p1073 * Lambda_0_11_p3584_lanes;
  const Lanes<8> Lambda_0_11_p3696_lanes = c3 * Lambda_0_11_p3656_lanes - s3 *
      Lambda_0_11_p3680_lanes;
  const Lanes<8> Lambda_0_11_p3704_lanes = 0.422 * Lambda_0_11_p3696_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3776_lanes = s2 * (s3 * Lambda_0_11_p3656_lanes + c3 *
      Lambda_0_11_p3680_lanes - Lambda_0_11_p3135 * Lambda_0_11_p3704_lanes);
  const Lanes<8> Lambda_0_11_p3792_lanes = 0.434 * (c2 *
      (Lambda_0_11_p3696_lanes - Lambda_0_11_p1080 * Lambda_0_11_p3704_lanes) -
      Lambda_0_11_p3776_lanes);
  const Lanes<8> Lambda_0_11_p3804_lanes = Lambda_0_11_p3117_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3812_lanes = Lambda_0_11_p3057_lanes * inverse_D3;
  const Lanes<8> Lambda_0_11_p3816_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3820_lanes = detail::make_pack<Real>(Lambda_0_11_p3000,
      Lambda_0_11_p2997, Lambda_0_11_p2994, Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000, Lambda_0_11_p3000) * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3828_lanes = Lambda_0_11_p2945_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3836_lanes = detail::make_pack<Real>(Lambda_0_11_p2868,
      Lambda_0_11_p2853, Lambda_0_11_p2838, Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868, Lambda_0_11_p2868) * inverse_D6;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3852_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3207 +
      Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[0] + Lambda_0_11_p3820_lanes *
      Lambda_0_11_p3471 + Lambda_0_11_p3816_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p3860_lanes = Lambda_0_11_p3852_lanes + Lambda_0_11_p3804_lanes *
      Lambda_0_11_p3704_lanes[0] + Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[0];
  const Lanes<8> Lambda_0_11_p3864_lanes = Lambda_0_11_p3792_lanes * inverse_D1;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3880_lanes = Lambda_0_11_p3704_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3896_lanes = Lambda_0_11_p3584_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3912_lanes = detail::make_pack<Real>(Lambda_0_11_p3471,
      Lambda_0_11_p3468, Lambda_0_11_p3465, Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456,
      Lambda_0_11_p3453, Lambda_0_11_p3450) * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3928_lanes = Lambda_0_11_p3360_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p3944 = Lambda_0_11_p3186 * inverse_D6;
  const Real Lambda_0_11_p3945 = Lambda_0_11_p3201 * inverse_D6;
  const Lanes<8> Lambda_0_11_p3946_lanes = detail::make_pack<Real>(Lambda_0_11_p3207,
      Lambda_0_11_p3206, Lambda_0_11_p3205, Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202,
      Lambda_0_11_p3207, Lambda_0_11_p3207) * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3958_lanes = Lambda_0_11_p2451_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p3970_lanes = Lambda_0_11_p2415_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p3982_lanes = Lambda_0_11_p2331_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p3994_lanes = Lambda_0_11_p1975_lanes * inverse_D10_lanes[0];
  const Lanes<8> Lambda_0_11_p4000_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4006_lanes = detail::make_pack<Real>(Lambda_0_11_p1887,
      Lambda_0_11_p1886, Lambda_0_11_p1885, Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710,
      Lambda_0_11_p1887, Lambda_0_11_p1887) * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4018_lanes = Lambda_0_11_p1523_lanes * inverse_D12_lanes[0];

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p4030 = 0.086 * Lambda_0_11_p1497;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p4031_lanes = detail::make_pack<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_pack<Real>(Lambda_0_11_p1497,
      Lambda_0_11_p1495, Lambda_0_11_p1400, Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1483_lanes[2], Lambda_0_11_p1497, Lambda_0_11_p1497);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4055_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p4030 +
      Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[0] + Lambda_0_11_p4006_lanes *
      Lambda_0_11_p1887 + Lambda_0_11_p4000_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4073_lanes = Lambda_0_11_p4055_lanes + Lambda_0_11_p3982_lanes *
      Lambda_0_11_p2331_lanes[0] + Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[0] +
      Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4079_lanes = Lambda_0_11_p4073_lanes + Lambda_0_11_p3946_lanes *
      Lambda_0_11_p3207;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4101_lanes = detail::make_pack<Real>(Lambda_0_11_p4079_lanes[0],
      Lambda_0_11_p4079_lanes[1], Lambda_0_11_p4079_lanes[2], Lambda_0_11_p4079_lanes[3],
      Lambda_0_11_p4079_lanes[4], Lambda_0_11_p4079_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3207,
      Lambda_0_11_p3944 * Lambda_0_11_p3207) + Lambda_0_11_p3928_lanes *
      Lambda_0_11_p3360_lanes[0] + Lambda_0_11_p3912_lanes * Lambda_0_11_p3471 +
      Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4117_lanes = Lambda_0_11_p4101_lanes + Lambda_0_11_p3880_lanes *
      Lambda_0_11_p3704_lanes[0] + Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[0];
  const Real Lambda_0_11_p4125 = 1.0 / Lambda_0_11_p4117_lanes[0];
  const Lanes<8> Lambda_0_11_p4126_lanes = Lambda_0_11_p3860_lanes * Lambda_0_11_p4125;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4142_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[1];
  const Lanes<8> Lambda_0_11_p4166_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3206 +
      Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[1] + Lambda_0_11_p3820_lanes *
      Lambda_0_11_p3468 + Lambda_0_11_p4142_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4178_lanes = Lambda_0_11_p4166_lanes + Lambda_0_11_p3804_lanes *
      Lambda_0_11_p3704_lanes[1] + Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[1] -
      Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[1];
  const Lanes<8> Lambda_0_11_p4182_lanes = Lambda_0_11_p4117_lanes * Lambda_0_11_p4125;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4251_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[1];

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p4266 = 0.086 * Lambda_0_11_p1495;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4282_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p4266 +
      Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[1] + Lambda_0_11_p4006_lanes *
      Lambda_0_11_p1886 + Lambda_0_11_p4251_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4297_lanes = Lambda_0_11_p4282_lanes + Lambda_0_11_p3982_lanes *
      Lambda_0_11_p2331_lanes[1] + Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[1] +
      Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4302_lanes = Lambda_0_11_p4297_lanes + Lambda_0_11_p3946_lanes *
      Lambda_0_11_p3206;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4321_lanes = detail::make_pack<Real>(Lambda_0_11_p4302_lanes[1],
      Lambda_0_11_p4302_lanes[1], Lambda_0_11_p4302_lanes[2], Lambda_0_11_p4302_lanes[3],
      Lambda_0_11_p4302_lanes[4], Lambda_0_11_p4302_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3206,
      Lambda_0_11_p3944 * Lambda_0_11_p3206) + Lambda_0_11_p3928_lanes *
      Lambda_0_11_p3360_lanes[1] + Lambda_0_11_p3912_lanes * Lambda_0_11_p3468 +
      Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4342_lanes = Lambda_0_11_p4321_lanes + Lambda_0_11_p3880_lanes *
      Lambda_0_11_p3704_lanes[1] + Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[1] -
      Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[1];
  const Real Lambda_0_11_p4349 = 1.0 / Lambda_0_11_p4342_lanes[1];
  const Lanes<8> Lambda_0_11_p4350_lanes = Lambda_0_11_p4178_lanes * Lambda_0_11_p4349;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4370_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[2];
  const Lanes<8> Lambda_0_11_p4394_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3205 +
      Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[2] + Lambda_0_11_p3820_lanes *
      Lambda_0_11_p3465 + Lambda_0_11_p4370_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4406_lanes = Lambda_0_11_p4394_lanes + Lambda_0_11_p3804_lanes *
      Lambda_0_11_p3704_lanes[2] + Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[2] -
      Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[2];
  const Lanes<8> Lambda_0_11_p4410_lanes = Lambda_0_11_p4406_lanes - Lambda_0_11_p4350_lanes *
      Lambda_0_11_p4342_lanes[2];
  const Lanes<8> Lambda_0_11_p4414_lanes = Lambda_0_11_p4342_lanes * Lambda_0_11_p4349;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4478_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[2];
  const Lanes<8> Lambda_0_11_p4502_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p1400 +
      Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[2] + Lambda_0_11_p4006_lanes *
      Lambda_0_11_p1885 + Lambda_0_11_p4478_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4514_lanes = Lambda_0_11_p4502_lanes + Lambda_0_11_p3982_lanes *
      Lambda_0_11_p2331_lanes[2] + Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[2] +
      Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4518_lanes = Lambda_0_11_p4514_lanes + Lambda_0_11_p3946_lanes *
      Lambda_0_11_p3205;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4534_lanes = detail::make_pack<Real>(Lambda_0_11_p4518_lanes[2],
      Lambda_0_11_p4518_lanes[2], Lambda_0_11_p4518_lanes[2], Lambda_0_11_p4518_lanes[3],
      Lambda_0_11_p4518_lanes[4], Lambda_0_11_p4518_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3205,
      Lambda_0_11_p3944 * Lambda_0_11_p3205) + Lambda_0_11_p3928_lanes *
      Lambda_0_11_p3360_lanes[2] + Lambda_0_11_p3912_lanes * Lambda_0_11_p3465 +
      Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4552_lanes = Lambda_0_11_p4534_lanes + Lambda_0_11_p3880_lanes *
      Lambda_0_11_p3704_lanes[2] + Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[2] -
      Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[2];
  const Lanes<8> Lambda_0_11_p4558_lanes = Lambda_0_11_p4552_lanes - Lambda_0_11_p4414_lanes *
      Lambda_0_11_p4342_lanes[2];
  const Real Lambda_0_11_p4564 = 1.0 / Lambda_0_11_p4558_lanes[2];
  const Lanes<8> Lambda_0_11_p4565_lanes = Lambda_0_11_p4410_lanes * Lambda_0_11_p4564;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4589_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[3];
  const Lanes<8> Lambda_0_11_p4613_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3204 +
      Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[3] + Lambda_0_11_p3820_lanes *
      Lambda_0_11_p3462 + Lambda_0_11_p4589_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4625_lanes = Lambda_0_11_p4613_lanes + Lambda_0_11_p3804_lanes *
      Lambda_0_11_p3704_lanes[3] + Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[3] -
      Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[3];
  const Lanes<8> Lambda_0_11_p4633_lanes = Lambda_0_11_p4625_lanes - Lambda_0_11_p4350_lanes *
      Lambda_0_11_p4342_lanes[3] - Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[3];
  const Lanes<8> Lambda_0_11_p4637_lanes = Lambda_0_11_p4558_lanes * Lambda_0_11_p4564;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4694_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[3];
  const Lanes<8> Lambda_0_11_p4712_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p1483_lanes[0] +
      Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[3] + Lambda_0_11_p4006_lanes *
      Lambda_0_11_p1769 + Lambda_0_11_p4694_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4721_lanes = Lambda_0_11_p4712_lanes + Lambda_0_11_p3982_lanes *
      Lambda_0_11_p2331_lanes[3] + Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[3] +
      Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4724_lanes = Lambda_0_11_p4721_lanes + Lambda_0_11_p3946_lanes *
      Lambda_0_11_p3204;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4737_lanes = detail::make_pack<Real>(Lambda_0_11_p4724_lanes[3],
      Lambda_0_11_p4724_lanes[3], Lambda_0_11_p4724_lanes[3], Lambda_0_11_p4724_lanes[3],
      Lambda_0_11_p4724_lanes[4], Lambda_0_11_p4724_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3204,
      Lambda_0_11_p3944 * Lambda_0_11_p3204) + Lambda_0_11_p3928_lanes *
      Lambda_0_11_p3360_lanes[3] + Lambda_0_11_p3912_lanes * Lambda_0_11_p3462 +
      Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4752_lanes = Lambda_0_11_p4737_lanes + Lambda_0_11_p3880_lanes *
      Lambda_0_11_p3704_lanes[3] + Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[3] -
      Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[3];
  const Lanes<8> Lambda_0_11_p4762_lanes = Lambda_0_11_p4752_lanes - Lambda_0_11_p4414_lanes *
      Lambda_0_11_p4342_lanes[3] - Lambda_0_11_p4637_lanes * Lambda_0_11_p4558_lanes[3];
  const Real Lambda_0_11_p4767 = 1.0 / Lambda_0_11_p4762_lanes[3];
  const Lanes<8> Lambda_0_11_p4768_lanes = Lambda_0_11_p4633_lanes * Lambda_0_11_p4767;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4796_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[4];
  const Lanes<8> Lambda_0_11_p4820_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3203 +
      Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[4] + Lambda_0_11_p3820_lanes *
      Lambda_0_11_p3459 + Lambda_0_11_p4796_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4832_lanes = Lambda_0_11_p4820_lanes + Lambda_0_11_p3804_lanes *
      Lambda_0_11_p3704_lanes[4] + Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[4] -
      Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[4];
  const Lanes<8> Lambda_0_11_p4844_lanes = Lambda_0_11_p4832_lanes - Lambda_0_11_p4350_lanes *
      Lambda_0_11_p4342_lanes[4] - Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[4] -
      Lambda_0_11_p4768_lanes * Lambda_0_11_p4762_lanes[4];
  const Lanes<8> Lambda_0_11_p4848_lanes = Lambda_0_11_p4762_lanes * Lambda_0_11_p4767;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4888_lanes = Lambda_0_11_p2169_lanes * inverse_D7_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p4892_lanes = detail::make_pack<Real>(Lambda_0_11_p3958_lanes[5],
      Lambda_0_11_p4888_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2169_lanes[2]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4894_lanes = Lambda_0_11_p1832_lanes * inverse_D8_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_0_11_p4898_lanes = detail::make_pack<Real>(Lambda_0_11_p3970_lanes[5],
      Lambda_0_11_p4894_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p2415_lanes[4],
      Lambda_0_11_p1832_lanes[2]);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4900_lanes = Lambda_0_11_p1651_lanes * inverse_D9_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_0_11_p4904_lanes = detail::make_pack<Real>(Lambda_0_11_p3982_lanes[5],
      Lambda_0_11_p4900_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p2331_lanes[4],
      Lambda_0_11_p1651_lanes[2]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4906_lanes = Lambda_0_11_p1571_lanes * inverse_D10_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p4910_lanes = detail::make_pack<Real>(Lambda_0_11_p3994_lanes[5],
      Lambda_0_11_p4906_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1975_lanes[4],
      Lambda_0_11_p1571_lanes[2]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4912_lanes = detail::make_pack<Real>(Lambda_0_11_p1431,
      Lambda_0_11_p1430, Lambda_0_11_p1429, Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431, Lambda_0_11_p1431) * inverse_D11_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p4916_lanes = detail::make_pack<Real>(Lambda_0_11_p4006_lanes[5],
      Lambda_0_11_p4912_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1764, Lambda_0_11_p1429);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4918_lanes = Lambda_0_11_p1365_lanes * inverse_D12_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p4922_lanes = detail::make_pack<Real>(Lambda_0_11_p4018_lanes[5],
      Lambda_0_11_p4918_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1523_lanes[4],
      Lambda_0_11_p1365_lanes[2]);
  const Lanes<2> Lambda_0_11_p4926_lanes = detail::make_pack<Real>(Lambda_0_11_p4018_lanes[4],
      Lambda_0_11_p4918_lanes[2]) * detail::make_pack<Real>(Lambda_0_11_p1523_lanes[4],
      Lambda_0_11_p1365_lanes[2]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p4930_lanes = detail::make_pack<Real>(Lambda_0_11_p4006_lanes[4],
      Lambda_0_11_p4912_lanes[2]) * detail::make_pack<Real>(Lambda_0_11_p1764, Lambda_0_11_p1429);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p4934_lanes = detail::make_pack<Real>(Lambda_0_11_p3994_lanes[4],
      Lambda_0_11_p4906_lanes[2]) * detail::make_pack<Real>(Lambda_0_11_p1975_lanes[4],
      Lambda_0_11_p1571_lanes[2]);

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_0_11_p4938_lanes = detail::make_pack<Real>(Lambda_0_11_p3982_lanes[4],
      Lambda_0_11_p4900_lanes[2]) * detail::make_pack<Real>(Lambda_0_11_p2331_lanes[4],
      Lambda_0_11_p1651_lanes[2]);

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_0_11_p4942_lanes = detail::make_pack<Real>(Lambda_0_11_p3970_lanes[4],
      Lambda_0_11_p4894_lanes[2]) * detail::make_pack<Real>(Lambda_0_11_p2415_lanes[4],
      Lambda_0_11_p1832_lanes[2]);
  const Lanes<8> Lambda_0_11_p4944_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p1483_lanes[1] +
      detail::make_pack<Real>(Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0],
      Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0],
      Lambda_0_11_p4922_lanes[0], Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0]) +
      detail::make_pack<Real>(Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0],
      Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0],
      Lambda_0_11_p4916_lanes[0], Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0]) +
      detail::make_pack<Real>(Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0],
      Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0],
      Lambda_0_11_p4910_lanes[0], Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0]) +
      detail::make_pack<Real>(Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0],
      Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0],
      Lambda_0_11_p4904_lanes[0], Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0]) +
      detail::make_pack<Real>(Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0],
      Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0],
      Lambda_0_11_p4898_lanes[0], Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p4946_lanes = detail::make_pack<Real>(Lambda_0_11_p3958_lanes[4],
      Lambda_0_11_p4888_lanes[2]) * detail::make_pack<Real>(Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2169_lanes[2]);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4950_lanes = Lambda_0_11_p4944_lanes +
      detail::make_pack<Real>(Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0],
      Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0],
      Lambda_0_11_p4892_lanes[0], Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0]) +
      detail::make_pack<Real>(Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203,
      Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[4] *
      Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203,
      Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[5] *
      Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203,
      Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4960_lanes = detail::make_pack<Real>(Lambda_0_11_p4950_lanes[4],
      Lambda_0_11_p4950_lanes[4], Lambda_0_11_p4950_lanes[4], Lambda_0_11_p4950_lanes[4],
      Lambda_0_11_p4950_lanes[4], Lambda_0_11_p4950_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3203,
      Lambda_0_11_p3944 * Lambda_0_11_p3203) + Lambda_0_11_p3928_lanes *
      Lambda_0_11_p3360_lanes[4] + Lambda_0_11_p3912_lanes * Lambda_0_11_p3459 +
      Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4972_lanes = Lambda_0_11_p4960_lanes + Lambda_0_11_p3880_lanes *
      Lambda_0_11_p3704_lanes[4] + Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[4] -
      Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[4];
  const Lanes<8> Lambda_0_11_p4984_lanes = Lambda_0_11_p4972_lanes - Lambda_0_11_p4414_lanes *
      Lambda_0_11_p4342_lanes[4] - Lambda_0_11_p4637_lanes * Lambda_0_11_p4558_lanes[4] -
      Lambda_0_11_p4848_lanes * Lambda_0_11_p4762_lanes[4];
  const Real Lambda_0_11_p4988 = 1.0 / Lambda_0_11_p4984_lanes[4];
  const Lanes<8> Lambda_0_11_p4989_lanes = Lambda_0_11_p4844_lanes * Lambda_0_11_p4988;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5021_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[5];
  const Lanes<8> Lambda_0_11_p5045_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3202 +
      Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[5] + Lambda_0_11_p3820_lanes *
      Lambda_0_11_p3456 + Lambda_0_11_p5021_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5057_lanes = Lambda_0_11_p5045_lanes + Lambda_0_11_p3804_lanes *
      Lambda_0_11_p3704_lanes[5] + Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[5] -
      Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[5];
  const Lanes<8> Lambda_0_11_p5069_lanes = Lambda_0_11_p5057_lanes - Lambda_0_11_p4350_lanes *
      Lambda_0_11_p4342_lanes[5] - Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[5] -
      Lambda_0_11_p4768_lanes * Lambda_0_11_p4762_lanes[5];
  const Lanes<8> Lambda_0_11_p5073_lanes = Lambda_0_11_p5069_lanes - Lambda_0_11_p4989_lanes *
      Lambda_0_11_p4984_lanes[5];
  const Lanes<8> Lambda_0_11_p5077_lanes = Lambda_0_11_p4984_lanes * Lambda_0_11_p4988;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p5113_lanes = detail::make_pack<Real>(Lambda_0_11_p3994_lanes[5],
      Lambda_0_11_p4906_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1975_lanes[5],
      Lambda_0_11_p1571_lanes[3]);

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5116_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_0_11_p1324, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1324, Lambda_0_11_p1324, Lambda_0_11_p1324,
      Lambda_0_11_p1324);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p5122_lanes = detail::make_pack<Real>(Lambda_0_11_p4031_lanes[5],
      Lambda_0_11_p5116_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1237) + detail::make_pack<Real>(Lambda_0_11_p4018_lanes[5],
      Lambda_0_11_p4918_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1523_lanes[5],
      Lambda_0_11_p1365_lanes[3]) + detail::make_pack<Real>(Lambda_0_11_p4006_lanes[5],
      Lambda_0_11_p4912_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1710, Lambda_0_11_p1428) +
      Lambda_0_11_p5113_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p5125_lanes = Lambda_0_11_p5122_lanes +
      detail::make_pack<Real>(Lambda_0_11_p3982_lanes[5], Lambda_0_11_p4900_lanes[3]) *
      detail::make_pack<Real>(Lambda_0_11_p2331_lanes[5], Lambda_0_11_p1651_lanes[3]) +
      detail::make_pack<Real>(Lambda_0_11_p3970_lanes[5], Lambda_0_11_p4894_lanes[3]) *
      detail::make_pack<Real>(Lambda_0_11_p2415_lanes[5], Lambda_0_11_p1832_lanes[3]) +
      detail::make_pack<Real>(Lambda_0_11_p3958_lanes[5], Lambda_0_11_p4888_lanes[3]) *
      detail::make_pack<Real>(Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2169_lanes[3]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5132_lanes = detail::make_pack<Real>(Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p3945 * Lambda_0_11_p3202,
      Lambda_0_11_p3944 * Lambda_0_11_p3202) + Lambda_0_11_p3928_lanes *
      Lambda_0_11_p3360_lanes[5] + Lambda_0_11_p3912_lanes * Lambda_0_11_p3456 +
      Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5141_lanes = Lambda_0_11_p5132_lanes + Lambda_0_11_p3880_lanes *
      Lambda_0_11_p3704_lanes[5] + Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[5] -
      Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[5];
  const Lanes<8> Lambda_0_11_p5150_lanes = Lambda_0_11_p5141_lanes - Lambda_0_11_p4414_lanes *
      Lambda_0_11_p4342_lanes[5] - Lambda_0_11_p4637_lanes * Lambda_0_11_p4558_lanes[5] -
      Lambda_0_11_p4848_lanes * Lambda_0_11_p4762_lanes[5];
  const Lanes<8> Lambda_0_11_p5153_lanes = Lambda_0_11_p5150_lanes - Lambda_0_11_p5077_lanes *
      Lambda_0_11_p4984_lanes[5];
  const Real Lambda_0_11_p5156 = 1.0 / Lambda_0_11_p5153_lanes[5];
  const Lanes<8> Lambda_0_11_p5157_lanes = Lambda_0_11_p5073_lanes * Lambda_0_11_p5156;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5221_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p2207;

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p5233 = 0.086 * Lambda_0_11_p1344;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5246_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p5233 +
      Lambda_0_11_p4918_lanes * Lambda_0_11_p1936 + Lambda_0_11_p4912_lanes * Lambda_0_11_p2204 +
      Lambda_0_11_p5221_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5258_lanes = Lambda_0_11_p5246_lanes + Lambda_0_11_p4900_lanes *
      Lambda_0_11_p2213 + Lambda_0_11_p4894_lanes * Lambda_0_11_p2219 + Lambda_0_11_p4888_lanes *
      Lambda_0_11_p2222;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5270_lanes = Lambda_0_11_p5258_lanes + Lambda_0_11_p3836_lanes *
      Lambda_0_11_p3201 + Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[6] +
      Lambda_0_11_p3820_lanes * Lambda_0_11_p3453;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5282_lanes = Lambda_0_11_p5270_lanes + Lambda_0_11_p3812_lanes *
      Lambda_0_11_p3584_lanes[6] + Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[6] +
      Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[6];
  const Lanes<8> Lambda_0_11_p5294_lanes = Lambda_0_11_p5282_lanes - Lambda_0_11_p4126_lanes *
      Lambda_0_11_p4117_lanes[6] - Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[6] -
      Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[6];
  const Lanes<8> Lambda_0_11_p5306_lanes = Lambda_0_11_p5294_lanes - Lambda_0_11_p4768_lanes *
      Lambda_0_11_p4762_lanes[6] - Lambda_0_11_p4989_lanes * Lambda_0_11_p4984_lanes[6] -
      Lambda_0_11_p5157_lanes * Lambda_0_11_p5153_lanes[6];
  const Real Lambda_0_11_p5310 = Lambda_0_11_p5153_lanes[6] * Lambda_0_11_p5156;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p5311 = 91.62274020012977 * Lambda_0_11_p1344 * Lambda_0_11_p5233 +
      Lambda_0_11_p1936 * inverse_D12_lanes[1] * Lambda_0_11_p1936 + Lambda_0_11_p2204 *
      inverse_D11_lanes[1] * Lambda_0_11_p2204;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p5312 = Lambda_0_11_p5311 + Lambda_0_11_p2207 * inverse_D10_lanes[1] *
      Lambda_0_11_p2207 + Lambda_0_11_p2213 * inverse_D9_lanes[1] * Lambda_0_11_p2213 +
      Lambda_0_11_p2219 * inverse_D8_lanes[1] * Lambda_0_11_p2219;

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p5313 = Lambda_0_11_p5312 + Lambda_0_11_p2222 * inverse_D7_lanes[1] *
      Lambda_0_11_p2222 + Lambda_0_11_p3945 * Lambda_0_11_p3201 + Lambda_0_11_p3928_lanes[6] *
      Lambda_0_11_p3360_lanes[6] + Lambda_0_11_p3912_lanes[6] * Lambda_0_11_p3453;

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5314 = Lambda_0_11_p5313 + Lambda_0_11_p3896_lanes[6] *
      Lambda_0_11_p3584_lanes[6] + Lambda_0_11_p3880_lanes[6] * Lambda_0_11_p3704_lanes[6] +
      Lambda_0_11_p3864_lanes[6] * Lambda_0_11_p3792_lanes[6] - Lambda_0_11_p4182_lanes[6] *
      Lambda_0_11_p4117_lanes[6];
  const Real Lambda_0_11_p5315 = Lambda_0_11_p5314 - Lambda_0_11_p4414_lanes[6] *
      Lambda_0_11_p4342_lanes[6] - Lambda_0_11_p4637_lanes[6] * Lambda_0_11_p4558_lanes[6] -
      Lambda_0_11_p4848_lanes[6] * Lambda_0_11_p4762_lanes[6] - Lambda_0_11_p5077_lanes[6] *
      Lambda_0_11_p4984_lanes[6];
  const Real Lambda_0_11_p5316 = 1.0 / (Lambda_0_11_p5315 - Lambda_0_11_p5310 *
      Lambda_0_11_p5153_lanes[6]);
  const Lanes<8> Lambda_0_11_p5317_lanes = Lambda_0_11_p5306_lanes * Lambda_0_11_p5316;
  const Real Lambda_0_11_p5321 = Lambda_0_11_p5153_lanes[7] * Lambda_0_11_p5156;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_0_11_p5322 = Lambda_0_11_p2201 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p5323 = Lambda_0_11_p2198 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p5324 = Lambda_0_11_p2192 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p5325 = Lambda_0_11_p2186 * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p5326 = Lambda_0_11_p2183 * inverse_D11_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p5327 = Lambda_0_11_p1918 * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p5328 = 91.62274020012977 * Lambda_0_11_p1339;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p5329 = Lambda_0_11_p5328 * Lambda_0_11_p5233 + Lambda_0_11_p5327 *
      Lambda_0_11_p1936 + Lambda_0_11_p5326 * Lambda_0_11_p2204 + Lambda_0_11_p5325 *
      Lambda_0_11_p2207 + Lambda_0_11_p5324 * Lambda_0_11_p2213;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p5330 = Lambda_0_11_p5329 + Lambda_0_11_p5323 * Lambda_0_11_p2219 +
      Lambda_0_11_p5322 * Lambda_0_11_p2222 + Lambda_0_11_p3944 * Lambda_0_11_p3201 +
      Lambda_0_11_p3928_lanes[7] * Lambda_0_11_p3360_lanes[6];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5331 = Lambda_0_11_p5330 + Lambda_0_11_p3912_lanes[7] *
      Lambda_0_11_p3453 + Lambda_0_11_p3896_lanes[7] * Lambda_0_11_p3584_lanes[6] +
      Lambda_0_11_p3880_lanes[7] * Lambda_0_11_p3704_lanes[6] + Lambda_0_11_p3864_lanes[7] *
      Lambda_0_11_p3792_lanes[6];
  const Real Lambda_0_11_p5332 = Lambda_0_11_p5331 - Lambda_0_11_p4182_lanes[7] *
      Lambda_0_11_p4117_lanes[6] - Lambda_0_11_p4414_lanes[7] * Lambda_0_11_p4342_lanes[6] -
      Lambda_0_11_p4637_lanes[7] * Lambda_0_11_p4558_lanes[6] - Lambda_0_11_p4848_lanes[7] *
      Lambda_0_11_p4762_lanes[6];
  const Real Lambda_0_11_p5333 = Lambda_0_11_p5332 - Lambda_0_11_p5077_lanes[7] *
      Lambda_0_11_p4984_lanes[6] - Lambda_0_11_p5321 * Lambda_0_11_p5153_lanes[6];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5398_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p2186;

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p5410 = 0.086 * Lambda_0_11_p1339;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5423_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p5410 +
      Lambda_0_11_p4918_lanes * Lambda_0_11_p1918 + Lambda_0_11_p4912_lanes * Lambda_0_11_p2183 +
      Lambda_0_11_p5398_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5435_lanes = Lambda_0_11_p5423_lanes + Lambda_0_11_p4900_lanes *
      Lambda_0_11_p2192 + Lambda_0_11_p4894_lanes * Lambda_0_11_p2198 + Lambda_0_11_p4888_lanes *
      Lambda_0_11_p2201;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5447_lanes = Lambda_0_11_p5435_lanes + Lambda_0_11_p3836_lanes *
      Lambda_0_11_p3186 + Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[7] +
      Lambda_0_11_p3820_lanes * Lambda_0_11_p3450;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5459_lanes = Lambda_0_11_p5447_lanes + Lambda_0_11_p3812_lanes *
      Lambda_0_11_p3584_lanes[7] + Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[7] +
      Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[7];
  const Lanes<8> Lambda_0_11_p5471_lanes = Lambda_0_11_p5459_lanes - Lambda_0_11_p4126_lanes *
      Lambda_0_11_p4117_lanes[7] - Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[7] -
      Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[7];
  const Lanes<8> Lambda_0_11_p5483_lanes = Lambda_0_11_p5471_lanes - Lambda_0_11_p4768_lanes *
      Lambda_0_11_p4762_lanes[7] - Lambda_0_11_p4989_lanes * Lambda_0_11_p4984_lanes[7] -
      Lambda_0_11_p5157_lanes * Lambda_0_11_p5153_lanes[7];
  const Lanes<8> Lambda_0_11_p5487_lanes = Lambda_0_11_p5483_lanes - Lambda_0_11_p5317_lanes *
      Lambda_0_11_p5333;
  const Real Lambda_0_11_p5491 = Lambda_0_11_p5333 * Lambda_0_11_p5316;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p5492 = Lambda_0_11_p5328 * Lambda_0_11_p5410 + Lambda_0_11_p5327 *
      Lambda_0_11_p1918 + Lambda_0_11_p5326 * Lambda_0_11_p2183 + Lambda_0_11_p5325 *
      Lambda_0_11_p2186 + Lambda_0_11_p5324 * Lambda_0_11_p2192;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p5493 = Lambda_0_11_p5492 + Lambda_0_11_p5323 * Lambda_0_11_p2198 +
      Lambda_0_11_p5322 * Lambda_0_11_p2201 + Lambda_0_11_p3944 * Lambda_0_11_p3186 +
      Lambda_0_11_p3928_lanes[7] * Lambda_0_11_p3360_lanes[7];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5494 = Lambda_0_11_p5493 + Lambda_0_11_p3912_lanes[7] *
      Lambda_0_11_p3450 + Lambda_0_11_p3896_lanes[7] * Lambda_0_11_p3584_lanes[7] +
      Lambda_0_11_p3880_lanes[7] * Lambda_0_11_p3704_lanes[7] + Lambda_0_11_p3864_lanes[7] *
      Lambda_0_11_p3792_lanes[7];
  const Real Lambda_0_11_p5495 = Lambda_0_11_p5494 - Lambda_0_11_p4182_lanes[7] *
      Lambda_0_11_p4117_lanes[7] - Lambda_0_11_p4414_lanes[7] * Lambda_0_11_p4342_lanes[7] -
      Lambda_0_11_p4637_lanes[7] * Lambda_0_11_p4558_lanes[7] - Lambda_0_11_p4848_lanes[7] *
      Lambda_0_11_p4762_lanes[7];
  const Real Lambda_0_11_p5496 = 1.0 / (Lambda_0_11_p5495 - Lambda_0_11_p5077_lanes[7] *
      Lambda_0_11_p4984_lanes[7] - Lambda_0_11_p5321 * Lambda_0_11_p5153_lanes[7] -
      Lambda_0_11_p5491 * Lambda_0_11_p5333);
  const Lanes<8> Lambda_0_11_p5497_lanes = Lambda_0_11_p5487_lanes * Lambda_0_11_p5496;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5569_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p1571_lanes[0];
  const Lanes<8> Lambda_0_11_p5593_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p1324 +
      Lambda_0_11_p4918_lanes * Lambda_0_11_p1365_lanes[0] + Lambda_0_11_p4912_lanes *
      Lambda_0_11_p1431 + Lambda_0_11_p5569_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5605_lanes = Lambda_0_11_p5593_lanes + Lambda_0_11_p4900_lanes *
      Lambda_0_11_p1651_lanes[0] + Lambda_0_11_p4894_lanes * Lambda_0_11_p1832_lanes[0] +
      Lambda_0_11_p4888_lanes * Lambda_0_11_p2169_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5617_lanes = Lambda_0_11_p5605_lanes + Lambda_0_11_p3836_lanes *
      Lambda_0_11_p2868 + Lambda_0_11_p3828_lanes * Lambda_0_11_p2945_lanes[0] +
      Lambda_0_11_p3820_lanes * Lambda_0_11_p3000;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5629_lanes = Lambda_0_11_p5617_lanes + Lambda_0_11_p3812_lanes *
      Lambda_0_11_p3057_lanes[0] + Lambda_0_11_p3804_lanes * Lambda_0_11_p3117_lanes[0] +
      Lambda_0_11_p3168_lanes * Lambda_0_11_p3164_lanes[0];
  const Lanes<8> Lambda_0_11_p5641_lanes = Lambda_0_11_p5629_lanes - Lambda_0_11_p4126_lanes *
      Lambda_0_11_p3860_lanes[0] - Lambda_0_11_p4350_lanes * Lambda_0_11_p4178_lanes[0] -
      Lambda_0_11_p4565_lanes * Lambda_0_11_p4410_lanes[0];
  const Lanes<8> Lambda_0_11_p5653_lanes = Lambda_0_11_p5641_lanes - Lambda_0_11_p4768_lanes *
      Lambda_0_11_p4633_lanes[0] - Lambda_0_11_p4989_lanes * Lambda_0_11_p4844_lanes[0] -
      Lambda_0_11_p5157_lanes * Lambda_0_11_p5073_lanes[0];
  const Lanes<8> Lambda_0_11_p5661_lanes = Lambda_0_11_p5653_lanes - Lambda_0_11_p5317_lanes *
      Lambda_0_11_p5306_lanes[0] - Lambda_0_11_p5497_lanes * Lambda_0_11_p5487_lanes[0];
  const Real Lambda_0_11_p5665 = 1.0 / Lambda_0_11_p5661_lanes[0];
  const Lanes<8> Lambda_0_11_p5666_lanes = Lambda_0_11_p5661_lanes * Lambda_0_11_p5665;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5723_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p1571_lanes[1];
  const Lanes<8> Lambda_0_11_p5741_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p1277 +
      Lambda_0_11_p4918_lanes * Lambda_0_11_p1365_lanes[1] + Lambda_0_11_p4912_lanes *
      Lambda_0_11_p1430 + Lambda_0_11_p5723_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5750_lanes = Lambda_0_11_p5741_lanes + Lambda_0_11_p4900_lanes *
      Lambda_0_11_p1651_lanes[1] + Lambda_0_11_p4894_lanes * Lambda_0_11_p1832_lanes[1] +
      Lambda_0_11_p4888_lanes * Lambda_0_11_p2169_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5759_lanes = Lambda_0_11_p5750_lanes + Lambda_0_11_p3836_lanes *
      Lambda_0_11_p2853 + Lambda_0_11_p3828_lanes * Lambda_0_11_p2945_lanes[1] +
      Lambda_0_11_p3820_lanes * Lambda_0_11_p2997;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5768_lanes = Lambda_0_11_p5759_lanes + Lambda_0_11_p3812_lanes *
      Lambda_0_11_p3057_lanes[1] + Lambda_0_11_p3804_lanes * Lambda_0_11_p3117_lanes[1] +
      Lambda_0_11_p3168_lanes * Lambda_0_11_p3164_lanes[1];
  const Lanes<8> Lambda_0_11_p5777_lanes = Lambda_0_11_p5768_lanes - Lambda_0_11_p4126_lanes *
      Lambda_0_11_p3860_lanes[1] - Lambda_0_11_p4350_lanes * Lambda_0_11_p4178_lanes[1] -
      Lambda_0_11_p4565_lanes * Lambda_0_11_p4410_lanes[1];
  const Lanes<8> Lambda_0_11_p5786_lanes = Lambda_0_11_p5777_lanes - Lambda_0_11_p4768_lanes *
      Lambda_0_11_p4633_lanes[1] - Lambda_0_11_p4989_lanes * Lambda_0_11_p4844_lanes[1] -
      Lambda_0_11_p5157_lanes * Lambda_0_11_p5073_lanes[1];
  const Lanes<8> Lambda_0_11_p5795_lanes = Lambda_0_11_p5786_lanes - Lambda_0_11_p5317_lanes *
      Lambda_0_11_p5306_lanes[1] - Lambda_0_11_p5497_lanes * Lambda_0_11_p5487_lanes[1] -
      Lambda_0_11_p5666_lanes * Lambda_0_11_p5661_lanes[1];
  const Real Lambda_0_11_p5798 = 1.0 / Lambda_0_11_p5795_lanes[1];
  const Real Lambda_0_11_p5799 = Lambda_0_11_p5795_lanes[3] * Lambda_0_11_p5798;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5810_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p1257 +
      detail::make_pack<Real>(Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4926_lanes[1],
      Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4922_lanes[1], Lambda_0_11_p4926_lanes[1],
      Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4926_lanes[1]) +
      detail::make_pack<Real>(Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4930_lanes[1],
      Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4916_lanes[1], Lambda_0_11_p4930_lanes[1],
      Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4930_lanes[1]) +
      detail::make_pack<Real>(Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4934_lanes[1],
      Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4910_lanes[1], Lambda_0_11_p4934_lanes[1],
      Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4934_lanes[1]) +
      detail::make_pack<Real>(Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4938_lanes[1],
      Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4904_lanes[1], Lambda_0_11_p4938_lanes[1],
      Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4938_lanes[1]) +
      detail::make_pack<Real>(Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4942_lanes[1],
      Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4898_lanes[1], Lambda_0_11_p4942_lanes[1],
      Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4942_lanes[1]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5812_lanes = Lambda_0_11_p5810_lanes +
      detail::make_pack<Real>(Lambda_0_11_p4946_lanes[1], Lambda_0_11_p4946_lanes[1],
      Lambda_0_11_p4946_lanes[1], Lambda_0_11_p4892_lanes[1], Lambda_0_11_p4946_lanes[1],
      Lambda_0_11_p4946_lanes[1], Lambda_0_11_p4946_lanes[1], Lambda_0_11_p4946_lanes[1]);

  // link 3 (hip), force propagation
  const Real Lambda_0_11_p5814 = Lambda_0_11_p5812_lanes[3] + Lambda_0_11_p3836_lanes[3] *
      Lambda_0_11_p2838 + Lambda_0_11_p3828_lanes[3] * Lambda_0_11_p2945_lanes[2] +
      Lambda_0_11_p3820_lanes[3] * Lambda_0_11_p2994 + Lambda_0_11_p3812_lanes[3] *
      Lambda_0_11_p3057_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5815 = Lambda_0_11_p5814 + Lambda_0_11_p3804_lanes[3] *
      Lambda_0_11_p3117_lanes[2] + Lambda_0_11_p3168_lanes[3] * Lambda_0_11_p3164_lanes[2] -
      Lambda_0_11_p4126_lanes[3] * Lambda_0_11_p3860_lanes[2] - Lambda_0_11_p4350_lanes[3] *
      Lambda_0_11_p4178_lanes[2];
  const Real Lambda_0_11_p5816 = Lambda_0_11_p5815 - Lambda_0_11_p4565_lanes[3] *
      Lambda_0_11_p4410_lanes[2] - Lambda_0_11_p4768_lanes[3] * Lambda_0_11_p4633_lanes[2] -
      Lambda_0_11_p4989_lanes[3] * Lambda_0_11_p4844_lanes[2] - Lambda_0_11_p5157_lanes[3] *
      Lambda_0_11_p5073_lanes[2];
  const Real Lambda_0_11_p5817 = Lambda_0_11_p5816 - Lambda_0_11_p5317_lanes[3] *
      Lambda_0_11_p5306_lanes[2] - Lambda_0_11_p5497_lanes[3] * Lambda_0_11_p5487_lanes[2] -
      Lambda_0_11_p5666_lanes[3] * Lambda_0_11_p5661_lanes[2] - Lambda_0_11_p5799 *
      Lambda_0_11_p5795_lanes[2];
  const Real Lambda_0_11_p5818 = Lambda_0_11_p5795_lanes[2] * Lambda_0_11_p5798;

  // link 3 (hip), force propagation
  const Real Lambda_0_11_p5819 = Lambda_0_11_p5812_lanes[2] + Lambda_0_11_p3836_lanes[2] *
      Lambda_0_11_p2838 + Lambda_0_11_p3828_lanes[2] * Lambda_0_11_p2945_lanes[2] +
      Lambda_0_11_p3820_lanes[2] * Lambda_0_11_p2994 + Lambda_0_11_p3812_lanes[2] *
      Lambda_0_11_p3057_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5820 = Lambda_0_11_p5819 + Lambda_0_11_p3804_lanes[2] *
      Lambda_0_11_p3117_lanes[2] + Lambda_0_11_p3168_lanes[2] * Lambda_0_11_p3164_lanes[2] -
      Lambda_0_11_p4126_lanes[2] * Lambda_0_11_p3860_lanes[2] - Lambda_0_11_p4350_lanes[2] *
      Lambda_0_11_p4178_lanes[2];
  const Real Lambda_0_11_p5821 = Lambda_0_11_p5820 - Lambda_0_11_p4565_lanes[2] *
      Lambda_0_11_p4410_lanes[2] - Lambda_0_11_p4768_lanes[2] * Lambda_0_11_p4633_lanes[2] -
      Lambda_0_11_p4989_lanes[2] * Lambda_0_11_p4844_lanes[2] - Lambda_0_11_p5157_lanes[2] *
      Lambda_0_11_p5073_lanes[2];
  const Real Lambda_0_11_p5822 = Lambda_0_11_p5821 - Lambda_0_11_p5317_lanes[2] *
      Lambda_0_11_p5306_lanes[2] - Lambda_0_11_p5497_lanes[2] * Lambda_0_11_p5487_lanes[2] -
      Lambda_0_11_p5666_lanes[2] * Lambda_0_11_p5661_lanes[2] - Lambda_0_11_p5818 *
      Lambda_0_11_p5795_lanes[2];
  const Real Lambda_0_11_p5823 = 1.0 / Lambda_0_11_p5822;
  const Real Lambda_0_11_p5824 = Lambda_0_11_p5817 * Lambda_0_11_p5823;
  const Real Lambda_0_11_p5825 = Lambda_0_11_p4414_lanes[2] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4182_lanes[2];
  const Real Lambda_0_11_p5826 = Lambda_0_11_p4414_lanes[3] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4182_lanes[3] - Lambda_0_11_p4637_lanes[3] * Lambda_0_11_p5825;
  const Real Lambda_0_11_p5827 = Lambda_0_11_p4414_lanes[4] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4182_lanes[4] - Lambda_0_11_p4637_lanes[4] * Lambda_0_11_p5825 -
      Lambda_0_11_p4848_lanes[4] * Lambda_0_11_p5826;
  const Real Lambda_0_11_p5828 = Lambda_0_11_p4414_lanes[5] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4182_lanes[5] - Lambda_0_11_p4637_lanes[5] * Lambda_0_11_p5825 -
      Lambda_0_11_p4848_lanes[5] * Lambda_0_11_p5826 - Lambda_0_11_p5077_lanes[5] *
      Lambda_0_11_p5827;
  const Real Lambda_0_11_p5829 = Lambda_0_11_p4414_lanes[6] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4182_lanes[6] - Lambda_0_11_p4637_lanes[6] * Lambda_0_11_p5825 -
      Lambda_0_11_p4848_lanes[6] * Lambda_0_11_p5826 - Lambda_0_11_p5077_lanes[6] *
      Lambda_0_11_p5827;
  const Real Lambda_0_11_p5830 = Lambda_0_11_p5829 - Lambda_0_11_p5310 * Lambda_0_11_p5828;
  const Real Lambda_0_11_p5831 = Lambda_0_11_p4414_lanes[7] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4182_lanes[7] - Lambda_0_11_p4637_lanes[7] * Lambda_0_11_p5825 -
      Lambda_0_11_p4848_lanes[7] * Lambda_0_11_p5826 - Lambda_0_11_p5077_lanes[7] *
      Lambda_0_11_p5827;
  const Real Lambda_0_11_p5832 = Lambda_0_11_p5831 - Lambda_0_11_p5321 * Lambda_0_11_p5828 -
      Lambda_0_11_p5491 * Lambda_0_11_p5830;
  const Real Lambda_0_11_p5833 = Lambda_0_11_p4350_lanes[0] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4126_lanes[0] - Lambda_0_11_p4565_lanes[0] * Lambda_0_11_p5825 -
      Lambda_0_11_p4768_lanes[0] * Lambda_0_11_p5826 - Lambda_0_11_p4989_lanes[0] *
      Lambda_0_11_p5827;
  const Real Lambda_0_11_p5834 = Lambda_0_11_p5833 - Lambda_0_11_p5157_lanes[0] *
      Lambda_0_11_p5828 - Lambda_0_11_p5317_lanes[0] * Lambda_0_11_p5830 -
      Lambda_0_11_p5497_lanes[0] * Lambda_0_11_p5832;
  const Real Lambda_0_11_p5835 = Lambda_0_11_p4350_lanes[1] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4126_lanes[1] - Lambda_0_11_p4565_lanes[1] * Lambda_0_11_p5825 -
      Lambda_0_11_p4768_lanes[1] * Lambda_0_11_p5826 - Lambda_0_11_p4989_lanes[1] *
      Lambda_0_11_p5827;
  const Real Lambda_0_11_p5836 = Lambda_0_11_p5835 - Lambda_0_11_p5157_lanes[1] *
      Lambda_0_11_p5828 - Lambda_0_11_p5317_lanes[1] * Lambda_0_11_p5830 -
      Lambda_0_11_p5497_lanes[1] * Lambda_0_11_p5832 - Lambda_0_11_p5666_lanes[1] *
      Lambda_0_11_p5834;
  const Real Lambda_0_11_p5837 = Lambda_0_11_p4350_lanes[2] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4126_lanes[2] - Lambda_0_11_p4565_lanes[2] * Lambda_0_11_p5825 -
      Lambda_0_11_p4768_lanes[2] * Lambda_0_11_p5826 - Lambda_0_11_p4989_lanes[2] *
      Lambda_0_11_p5827;
  const Real Lambda_0_11_p5838 = Lambda_0_11_p5837 - Lambda_0_11_p5157_lanes[2] *
      Lambda_0_11_p5828 - Lambda_0_11_p5317_lanes[2] * Lambda_0_11_p5830 -
      Lambda_0_11_p5497_lanes[2] * Lambda_0_11_p5832 - Lambda_0_11_p5666_lanes[2] *
      Lambda_0_11_p5834;
  const Real Lambda_0_11_p5839 = Lambda_0_11_p5838 - Lambda_0_11_p5818 * Lambda_0_11_p5836;
  const Real Lambda_0_11_p5840 = Lambda_0_11_p4350_lanes[3] * Lambda_0_11_p4182_lanes[1] -
      Lambda_0_11_p4126_lanes[3] - Lambda_0_11_p4565_lanes[3] * Lambda_0_11_p5825 -
      Lambda_0_11_p4768_lanes[3] * Lambda_0_11_p5826 - Lambda_0_11_p4989_lanes[3] *
      Lambda_0_11_p5827;
  const Real Lambda_0_11_p5841 = Lambda_0_11_p5840 - Lambda_0_11_p5157_lanes[3] *
      Lambda_0_11_p5828 - Lambda_0_11_p5317_lanes[3] * Lambda_0_11_p5830 -
      Lambda_0_11_p5497_lanes[3] * Lambda_0_11_p5832 - Lambda_0_11_p5666_lanes[3] *
      Lambda_0_11_p5834;
  const Real Lambda_0_11_p5842 = Lambda_0_11_p5841 - Lambda_0_11_p5799 * Lambda_0_11_p5836 -
      Lambda_0_11_p5824 * Lambda_0_11_p5839;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p15 = Lambda_0_11_p5125_lanes[1] + Lambda_0_11_p3836_lanes[3] *
      Lambda_0_11_p2823 + Lambda_0_11_p3828_lanes[3] * Lambda_0_11_p2945_lanes[3] +
      Lambda_0_11_p3820_lanes[3] * Lambda_0_11_p2991 + Lambda_0_11_p3812_lanes[3] *
      Lambda_0_11_p3057_lanes[3];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p16 = Lambda_11_11_p15 + Lambda_0_11_p3804_lanes[3] *
      Lambda_0_11_p3117_lanes[3] + Lambda_0_11_p3168_lanes[3] * Lambda_0_11_p3164_lanes[3] -
      Lambda_0_11_p4126_lanes[3] * Lambda_0_11_p3860_lanes[3] - Lambda_0_11_p4350_lanes[3] *
      Lambda_0_11_p4178_lanes[3];
  const Real Lambda_11_11_p17 = Lambda_11_11_p16 - Lambda_0_11_p4565_lanes[3] *
      Lambda_0_11_p4410_lanes[3] - Lambda_0_11_p4768_lanes[3] * Lambda_0_11_p4633_lanes[3] -
      Lambda_0_11_p4989_lanes[3] * Lambda_0_11_p4844_lanes[3] - Lambda_0_11_p5157_lanes[3] *
      Lambda_0_11_p5073_lanes[3];
  const Real Lambda_11_11_p18 = Lambda_11_11_p17 - Lambda_0_11_p5317_lanes[3] *
      Lambda_0_11_p5306_lanes[3] - Lambda_0_11_p5497_lanes[3] * Lambda_0_11_p5487_lanes[3] -
      Lambda_0_11_p5666_lanes[3] * Lambda_0_11_p5661_lanes[3] - Lambda_0_11_p5799 *
      Lambda_0_11_p5795_lanes[3];
  const Real Lambda_11_11 = 1.0 / (Lambda_11_11_p18 - Lambda_0_11_p5824 * Lambda_0_11_p5817);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_0_11 = Lambda_0_11_p5842 * Lambda_11_11;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_0_0_p1 = Lambda_0_11_p5839 * Lambda_0_11_p5823;
  const Real Lambda_0_0_p2 = Lambda_0_11_p5836 * Lambda_0_11_p5798;
  const Real Lambda_0_0_p3 = Lambda_0_11_p5834 * Lambda_0_11_p5665;
  const Real Lambda_0_0_p4 = Lambda_0_11_p5832 * Lambda_0_11_p5496;
  const Real Lambda_0_0_p5 = Lambda_0_11_p5830 * Lambda_0_11_p5316;
  const Real Lambda_0_0_p6 = Lambda_0_11_p5828 * Lambda_0_11_p5156;
  const Real Lambda_0_0_p7 = Lambda_0_11_p5827 * Lambda_0_11_p4988;
  const Real Lambda_0_0_p8 = Lambda_0_11_p5826 * Lambda_0_11_p4767;
  const Real Lambda_0_0_p9 = Lambda_0_11_p5825 * Lambda_0_11_p4564;
  const Real Lambda_0_0_p10 = Lambda_0_11_p4182_lanes[1] * Lambda_0_11_p4349;
  const Real Lambda_0_0_p11 = Lambda_0_11_p4125 + Lambda_0_0_p10 * Lambda_0_11_p4182_lanes[1] +
      Lambda_0_0_p9 * Lambda_0_11_p5825 + Lambda_0_0_p8 * Lambda_0_11_p5826 + Lambda_0_0_p7 *
      Lambda_0_11_p5827;
  const Real Lambda_0_0_p12 = Lambda_0_0_p11 + Lambda_0_0_p6 * Lambda_0_11_p5828 + Lambda_0_0_p5 *
      Lambda_0_11_p5830 + Lambda_0_0_p4 * Lambda_0_11_p5832 + Lambda_0_0_p3 * Lambda_0_11_p5834;
  Lambda[0] = Lambda_0_0_p12 + Lambda_0_0_p2 * Lambda_0_11_p5836 + Lambda_0_0_p1 *
      Lambda_0_11_p5839 + Lambda_0_11 * Lambda_0_11_p5842;
  const Real Lambda_1_11_p1 = Lambda_0_11_p4637_lanes[3] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4414_lanes[3];
  const Real Lambda_1_11_p2 = Lambda_0_11_p4637_lanes[4] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4414_lanes[4] - Lambda_0_11_p4848_lanes[4] * Lambda_1_11_p1;
  const Real Lambda_1_11_p3 = Lambda_0_11_p4637_lanes[5] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4414_lanes[5] - Lambda_0_11_p4848_lanes[5] * Lambda_1_11_p1 -
      Lambda_0_11_p5077_lanes[5] * Lambda_1_11_p2;
  const Real Lambda_1_11_p4 = Lambda_0_11_p4637_lanes[6] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4414_lanes[6] - Lambda_0_11_p4848_lanes[6] * Lambda_1_11_p1 -
      Lambda_0_11_p5077_lanes[6] * Lambda_1_11_p2 - Lambda_0_11_p5310 * Lambda_1_11_p3;
  const Real Lambda_1_11_p5 = Lambda_0_11_p4637_lanes[7] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4414_lanes[7] - Lambda_0_11_p4848_lanes[7] * Lambda_1_11_p1 -
      Lambda_0_11_p5077_lanes[7] * Lambda_1_11_p2 - Lambda_0_11_p5321 * Lambda_1_11_p3;
  const Real Lambda_1_11_p6 = Lambda_1_11_p5 - Lambda_0_11_p5491 * Lambda_1_11_p4;
  const Real Lambda_1_11_p7 = Lambda_0_11_p4565_lanes[0] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4350_lanes[0] - Lambda_0_11_p4768_lanes[0] * Lambda_1_11_p1 -
      Lambda_0_11_p4989_lanes[0] * Lambda_1_11_p2 - Lambda_0_11_p5157_lanes[0] * Lambda_1_11_p3;
  const Real Lambda_1_11_p8 = Lambda_1_11_p7 - Lambda_0_11_p5317_lanes[0] * Lambda_1_11_p4 -
      Lambda_0_11_p5497_lanes[0] * Lambda_1_11_p6;
  const Real Lambda_1_11_p9 = Lambda_0_11_p4565_lanes[1] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4350_lanes[1] - Lambda_0_11_p4768_lanes[1] * Lambda_1_11_p1 -
      Lambda_0_11_p4989_lanes[1] * Lambda_1_11_p2 - Lambda_0_11_p5157_lanes[1] * Lambda_1_11_p3;
  const Real Lambda_1_11_p10 = Lambda_1_11_p9 - Lambda_0_11_p5317_lanes[1] * Lambda_1_11_p4 -
      Lambda_0_11_p5497_lanes[1] * Lambda_1_11_p6 - Lambda_0_11_p5666_lanes[1] * Lambda_1_11_p8;
  const Real Lambda_1_11_p11 = Lambda_0_11_p4565_lanes[2] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4350_lanes[2] - Lambda_0_11_p4768_lanes[2] * Lambda_1_11_p1 -
      Lambda_0_11_p4989_lanes[2] * Lambda_1_11_p2 - Lambda_0_11_p5157_lanes[2] * Lambda_1_11_p3;
  const Real Lambda_1_11_p12 = Lambda_1_11_p11 - Lambda_0_11_p5317_lanes[2] * Lambda_1_11_p4 -
      Lambda_0_11_p5497_lanes[2] * Lambda_1_11_p6 - Lambda_0_11_p5666_lanes[2] * Lambda_1_11_p8 -
      Lambda_0_11_p5818 * Lambda_1_11_p10;
  const Real Lambda_1_11_p13 = Lambda_0_11_p4565_lanes[3] * Lambda_0_11_p4414_lanes[2] -
      Lambda_0_11_p4350_lanes[3] - Lambda_0_11_p4768_lanes[3] * Lambda_1_11_p1 -
      Lambda_0_11_p4989_lanes[3] * Lambda_1_11_p2 - Lambda_0_11_p5157_lanes[3] * Lambda_1_11_p3;
  const Real Lambda_1_11_p14 = Lambda_1_11_p13 - Lambda_0_11_p5317_lanes[3] * Lambda_1_11_p4 -
      Lambda_0_11_p5497_lanes[3] * Lambda_1_11_p6 - Lambda_0_11_p5666_lanes[3] * Lambda_1_11_p8 -
      Lambda_0_11_p5799 * Lambda_1_11_p10;
  const Real Lambda_1_11_p15 = Lambda_1_11_p14 - Lambda_0_11_p5824 * Lambda_1_11_p12;
  const Real Lambda_1_11 = Lambda_1_11_p15 * Lambda_11_11;
  Lambda[23] = Lambda_1_11;
  Lambda[133] = Lambda_1_11;
  const Real Lambda_0_1_p1 = Lambda_1_11_p12 * Lambda_0_11_p5823;
  const Real Lambda_0_1_p2 = Lambda_1_11_p10 * Lambda_0_11_p5798;
  const Real Lambda_0_1_p3 = Lambda_1_11_p8 * Lambda_0_11_p5665;
  const Real Lambda_0_1_p4 = Lambda_1_11_p6 * Lambda_0_11_p5496;
  const Real Lambda_0_1_p5 = Lambda_1_11_p4 * Lambda_0_11_p5316;
  const Real Lambda_0_1_p6 = Lambda_1_11_p3 * Lambda_0_11_p5156;
  const Real Lambda_0_1_p7 = Lambda_1_11_p2 * Lambda_0_11_p4988;
  const Real Lambda_0_1_p8 = Lambda_1_11_p1 * Lambda_0_11_p4767;
  const Real Lambda_0_1_p9 = Lambda_0_11_p4414_lanes[2] * Lambda_0_11_p4564;
  const Real Lambda_0_1_p10 = Lambda_0_1_p8 * Lambda_0_11_p5826 -
      (Lambda_0_0_p10 + Lambda_0_1_p9 * Lambda_0_11_p5825) + Lambda_0_1_p7 * Lambda_0_11_p5827 +
      Lambda_0_1_p6 * Lambda_0_11_p5828;
  const Real Lambda_0_1_p11 = Lambda_0_1_p10 + Lambda_0_1_p5 * Lambda_0_11_p5830 + Lambda_0_1_p4 *
      Lambda_0_11_p5832 + Lambda_0_1_p3 * Lambda_0_11_p5834 + Lambda_0_1_p2 * Lambda_0_11_p5836;
  const Real Lambda_0_1 = Lambda_0_1_p11 + Lambda_0_1_p1 * Lambda_0_11_p5839 + Lambda_1_11 *
      Lambda_0_11_p5842;
  Lambda[1] = Lambda_0_1;
  Lambda[12] = Lambda_0_1;
  const Real Lambda_2_11_p1 = Lambda_0_11_p4848_lanes[4] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4637_lanes[4];
  const Real Lambda_2_11_p2 = Lambda_0_11_p4848_lanes[5] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4637_lanes[5] - Lambda_0_11_p5077_lanes[5] * Lambda_2_11_p1;
  const Real Lambda_2_11_p3 = Lambda_0_11_p4848_lanes[6] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4637_lanes[6] - Lambda_0_11_p5077_lanes[6] * Lambda_2_11_p1 - Lambda_0_11_p5310 *
      Lambda_2_11_p2;
  const Real Lambda_2_11_p4 = Lambda_0_11_p4848_lanes[7] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4637_lanes[7] - Lambda_0_11_p5077_lanes[7] * Lambda_2_11_p1 - Lambda_0_11_p5321 *
      Lambda_2_11_p2 - Lambda_0_11_p5491 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_0_11_p4768_lanes[0] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4565_lanes[0] - Lambda_0_11_p4989_lanes[0] * Lambda_2_11_p1 -
      Lambda_0_11_p5157_lanes[0] * Lambda_2_11_p2 - Lambda_0_11_p5317_lanes[0] * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_2_11_p5 - Lambda_0_11_p5497_lanes[0] * Lambda_2_11_p4;
  const Real Lambda_2_11_p7 = Lambda_0_11_p4768_lanes[1] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4565_lanes[1] - Lambda_0_11_p4989_lanes[1] * Lambda_2_11_p1 -
      Lambda_0_11_p5157_lanes[1] * Lambda_2_11_p2 - Lambda_0_11_p5317_lanes[1] * Lambda_2_11_p3;
  const Real Lambda_2_11_p8 = Lambda_2_11_p7 - Lambda_0_11_p5497_lanes[1] * Lambda_2_11_p4 -
      Lambda_0_11_p5666_lanes[1] * Lambda_2_11_p6;
  const Real Lambda_2_11_p9 = Lambda_0_11_p4768_lanes[2] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4565_lanes[2] - Lambda_0_11_p4989_lanes[2] * Lambda_2_11_p1 -
      Lambda_0_11_p5157_lanes[2] * Lambda_2_11_p2 - Lambda_0_11_p5317_lanes[2] * Lambda_2_11_p3;
  const Real Lambda_2_11_p10 = Lambda_2_11_p9 - Lambda_0_11_p5497_lanes[2] * Lambda_2_11_p4 -
      Lambda_0_11_p5666_lanes[2] * Lambda_2_11_p6 - Lambda_0_11_p5818 * Lambda_2_11_p8;
  const Real Lambda_2_11_p11 = Lambda_0_11_p4768_lanes[3] * Lambda_0_11_p4637_lanes[3] -
      Lambda_0_11_p4565_lanes[3] - Lambda_0_11_p4989_lanes[3] * Lambda_2_11_p1 -
      Lambda_0_11_p5157_lanes[3] * Lambda_2_11_p2 - Lambda_0_11_p5317_lanes[3] * Lambda_2_11_p3;
  const Real Lambda_2_11_p12 = Lambda_2_11_p11 - Lambda_0_11_p5497_lanes[3] * Lambda_2_11_p4 -
      Lambda_0_11_p5666_lanes[3] * Lambda_2_11_p6 - Lambda_0_11_p5799 * Lambda_2_11_p8 -
      Lambda_0_11_p5824 * Lambda_2_11_p10;
  const Real Lambda_2_11 = Lambda_2_11_p12 * Lambda_11_11;
  Lambda[35] = Lambda_2_11;
  Lambda[134] = Lambda_2_11;
  const Real Lambda_0_2_p1 = Lambda_2_11_p10 * Lambda_0_11_p5823;
  const Real Lambda_0_2_p2 = Lambda_2_11_p8 * Lambda_0_11_p5798;
  const Real Lambda_0_2_p3 = Lambda_2_11_p6 * Lambda_0_11_p5665;
  const Real Lambda_0_2_p4 = Lambda_2_11_p4 * Lambda_0_11_p5496;
  const Real Lambda_0_2_p5 = Lambda_2_11_p3 * Lambda_0_11_p5316;
  const Real Lambda_0_2_p6 = Lambda_2_11_p2 * Lambda_0_11_p5156;
  const Real Lambda_0_2_p7 = Lambda_2_11_p1 * Lambda_0_11_p4988;
  const Real Lambda_0_2_p8 = Lambda_0_11_p4637_lanes[3] * Lambda_0_11_p4767;
  const Real Lambda_0_2_p9 = Lambda_0_0_p9 - Lambda_0_2_p8 * Lambda_0_11_p5826 + Lambda_0_2_p7 *
      Lambda_0_11_p5827 + Lambda_0_2_p6 * Lambda_0_11_p5828 + Lambda_0_2_p5 * Lambda_0_11_p5830;
  const Real Lambda_0_2_p10 = Lambda_0_2_p9 + Lambda_0_2_p4 * Lambda_0_11_p5832 + Lambda_0_2_p3 *
      Lambda_0_11_p5834 + Lambda_0_2_p2 * Lambda_0_11_p5836 + Lambda_0_2_p1 * Lambda_0_11_p5839;
  const Real Lambda_0_2 = Lambda_0_2_p10 + Lambda_2_11 * Lambda_0_11_p5842;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_3_11_p1 = Lambda_0_11_p5077_lanes[5] * Lambda_0_11_p4848_lanes[4] -
      Lambda_0_11_p4848_lanes[5];
  const Real Lambda_3_11_p2 = Lambda_0_11_p5077_lanes[6] * Lambda_0_11_p4848_lanes[4] -
      Lambda_0_11_p4848_lanes[6] - Lambda_0_11_p5310 * Lambda_3_11_p1;
  const Real Lambda_3_11_p3 = Lambda_0_11_p5077_lanes[7] * Lambda_0_11_p4848_lanes[4] -
      Lambda_0_11_p4848_lanes[7] - Lambda_0_11_p5321 * Lambda_3_11_p1 - Lambda_0_11_p5491 *
      Lambda_3_11_p2;
  const Real Lambda_3_11_p4 = Lambda_0_11_p4989_lanes[0] * Lambda_0_11_p4848_lanes[4] -
      Lambda_0_11_p4768_lanes[0] - Lambda_0_11_p5157_lanes[0] * Lambda_3_11_p1 -
      Lambda_0_11_p5317_lanes[0] * Lambda_3_11_p2 - Lambda_0_11_p5497_lanes[0] * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_0_11_p4989_lanes[1] * Lambda_0_11_p4848_lanes[4] -
      Lambda_0_11_p4768_lanes[1] - Lambda_0_11_p5157_lanes[1] * Lambda_3_11_p1 -
      Lambda_0_11_p5317_lanes[1] * Lambda_3_11_p2 - Lambda_0_11_p5497_lanes[1] * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_3_11_p5 - Lambda_0_11_p5666_lanes[1] * Lambda_3_11_p4;
  const Real Lambda_3_11_p7 = Lambda_0_11_p4989_lanes[2] * Lambda_0_11_p4848_lanes[4] -
      Lambda_0_11_p4768_lanes[2] - Lambda_0_11_p5157_lanes[2] * Lambda_3_11_p1 -
      Lambda_0_11_p5317_lanes[2] * Lambda_3_11_p2 - Lambda_0_11_p5497_lanes[2] * Lambda_3_11_p3;
  const Real Lambda_3_11_p8 = Lambda_3_11_p7 - Lambda_0_11_p5666_lanes[2] * Lambda_3_11_p4 -
      Lambda_0_11_p5818 * Lambda_3_11_p6;
  const Real Lambda_3_11_p9 = Lambda_0_11_p4989_lanes[3] * Lambda_0_11_p4848_lanes[4] -
      Lambda_0_11_p4768_lanes[3] - Lambda_0_11_p5157_lanes[3] * Lambda_3_11_p1 -
      Lambda_0_11_p5317_lanes[3] * Lambda_3_11_p2 - Lambda_0_11_p5497_lanes[3] * Lambda_3_11_p3;
  const Real Lambda_3_11_p10 = Lambda_3_11_p9 - Lambda_0_11_p5666_lanes[3] * Lambda_3_11_p4 -
      Lambda_0_11_p5799 * Lambda_3_11_p6 - Lambda_0_11_p5824 * Lambda_3_11_p8;
  const Real Lambda_3_11 = Lambda_3_11_p10 * Lambda_11_11;
  Lambda[47] = Lambda_3_11;
  Lambda[135] = Lambda_3_11;
  const Real Lambda_0_3_p1 = Lambda_3_11_p8 * Lambda_0_11_p5823;
  const Real Lambda_0_3_p2 = Lambda_3_11_p6 * Lambda_0_11_p5798;
  const Real Lambda_0_3_p3 = Lambda_3_11_p4 * Lambda_0_11_p5665;
  const Real Lambda_0_3_p4 = Lambda_3_11_p3 * Lambda_0_11_p5496;
  const Real Lambda_0_3_p5 = Lambda_3_11_p2 * Lambda_0_11_p5316;
  const Real Lambda_0_3_p6 = Lambda_3_11_p1 * Lambda_0_11_p5156;
  const Real Lambda_0_3_p7 = Lambda_0_11_p4848_lanes[4] * Lambda_0_11_p4988;
  const Real Lambda_0_3_p8 = Lambda_0_0_p8 - Lambda_0_3_p7 * Lambda_0_11_p5827 + Lambda_0_3_p6 *
      Lambda_0_11_p5828 + Lambda_0_3_p5 * Lambda_0_11_p5830 + Lambda_0_3_p4 * Lambda_0_11_p5832;
  const Real Lambda_0_3 = Lambda_0_3_p8 + Lambda_0_3_p3 * Lambda_0_11_p5834 + Lambda_0_3_p2 *
      Lambda_0_11_p5836 + Lambda_0_3_p1 * Lambda_0_11_p5839 + Lambda_3_11 * Lambda_0_11_p5842;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_4_11_p1 = Lambda_0_11_p5310 * Lambda_0_11_p5077_lanes[5] -
      Lambda_0_11_p5077_lanes[6];
  const Real Lambda_4_11_p2 = Lambda_0_11_p5321 * Lambda_0_11_p5077_lanes[5] -
      Lambda_0_11_p5077_lanes[7] - Lambda_0_11_p5491 * Lambda_4_11_p1;
  const Real Lambda_4_11_p3 = Lambda_0_11_p5157_lanes[0] * Lambda_0_11_p5077_lanes[5] -
      Lambda_0_11_p4989_lanes[0] - Lambda_0_11_p5317_lanes[0] * Lambda_4_11_p1 -
      Lambda_0_11_p5497_lanes[0] * Lambda_4_11_p2;
  const Real Lambda_4_11_p4 = Lambda_0_11_p5157_lanes[1] * Lambda_0_11_p5077_lanes[5] -
      Lambda_0_11_p4989_lanes[1] - Lambda_0_11_p5317_lanes[1] * Lambda_4_11_p1 -
      Lambda_0_11_p5497_lanes[1] * Lambda_4_11_p2 - Lambda_0_11_p5666_lanes[1] * Lambda_4_11_p3;
  const Real Lambda_4_11_p5 = Lambda_0_11_p5157_lanes[2] * Lambda_0_11_p5077_lanes[5] -
      Lambda_0_11_p4989_lanes[2] - Lambda_0_11_p5317_lanes[2] * Lambda_4_11_p1 -
      Lambda_0_11_p5497_lanes[2] * Lambda_4_11_p2 - Lambda_0_11_p5666_lanes[2] * Lambda_4_11_p3;
  const Real Lambda_4_11_p6 = Lambda_4_11_p5 - Lambda_0_11_p5818 * Lambda_4_11_p4;
  const Real Lambda_4_11_p7 = Lambda_0_11_p5157_lanes[3] * Lambda_0_11_p5077_lanes[5] -
      Lambda_0_11_p4989_lanes[3] - Lambda_0_11_p5317_lanes[3] * Lambda_4_11_p1 -
      Lambda_0_11_p5497_lanes[3] * Lambda_4_11_p2 - Lambda_0_11_p5666_lanes[3] * Lambda_4_11_p3;
  const Real Lambda_4_11_p8 = Lambda_4_11_p7 - Lambda_0_11_p5799 * Lambda_4_11_p4 -
      Lambda_0_11_p5824 * Lambda_4_11_p6;
  const Real Lambda_4_11 = Lambda_4_11_p8 * Lambda_11_11;
  Lambda[59] = Lambda_4_11;
  Lambda[136] = Lambda_4_11;
  const Real Lambda_0_4_p1 = Lambda_4_11_p6 * Lambda_0_11_p5823;
  const Real Lambda_0_4_p2 = Lambda_4_11_p4 * Lambda_0_11_p5798;
  const Real Lambda_0_4_p3 = Lambda_4_11_p3 * Lambda_0_11_p5665;
  const Real Lambda_0_4_p4 = Lambda_4_11_p2 * Lambda_0_11_p5496;
  const Real Lambda_0_4_p5 = Lambda_4_11_p1 * Lambda_0_11_p5316;
  const Real Lambda_0_4_p6 = Lambda_0_11_p5077_lanes[5] * Lambda_0_11_p5156;
  const Real Lambda_0_4_p7 = Lambda_0_0_p7 - Lambda_0_4_p6 * Lambda_0_11_p5828 + Lambda_0_4_p5 *
      Lambda_0_11_p5830 + Lambda_0_4_p4 * Lambda_0_11_p5832 + Lambda_0_4_p3 * Lambda_0_11_p5834;
  const Real Lambda_0_4 = Lambda_0_4_p7 + Lambda_0_4_p2 * Lambda_0_11_p5836 + Lambda_0_4_p1 *
      Lambda_0_11_p5839 + Lambda_4_11 * Lambda_0_11_p5842;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_5_11_p1 = Lambda_0_11_p5491 * Lambda_0_11_p5310 - Lambda_0_11_p5321;
  const Real Lambda_5_11_p2 = Lambda_0_11_p5317_lanes[0] * Lambda_0_11_p5310 -
      Lambda_0_11_p5157_lanes[0] - Lambda_0_11_p5497_lanes[0] * Lambda_5_11_p1;
  const Real Lambda_5_11_p3 = Lambda_0_11_p5317_lanes[1] * Lambda_0_11_p5310 -
      Lambda_0_11_p5157_lanes[1] - Lambda_0_11_p5497_lanes[1] * Lambda_5_11_p1 -
      Lambda_0_11_p5666_lanes[1] * Lambda_5_11_p2;
  const Real Lambda_5_11_p4 = Lambda_0_11_p5317_lanes[2] * Lambda_0_11_p5310 -
      Lambda_0_11_p5157_lanes[2] - Lambda_0_11_p5497_lanes[2] * Lambda_5_11_p1 -
      Lambda_0_11_p5666_lanes[2] * Lambda_5_11_p2 - Lambda_0_11_p5818 * Lambda_5_11_p3;
  const Real Lambda_5_11_p5 = Lambda_0_11_p5317_lanes[3] * Lambda_0_11_p5310 -
      Lambda_0_11_p5157_lanes[3] - Lambda_0_11_p5497_lanes[3] * Lambda_5_11_p1 -
      Lambda_0_11_p5666_lanes[3] * Lambda_5_11_p2 - Lambda_0_11_p5799 * Lambda_5_11_p3;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_0_11_p5824 * Lambda_5_11_p4;
  const Real Lambda_5_11 = Lambda_5_11_p6 * Lambda_11_11;
  Lambda[71] = Lambda_5_11;
  Lambda[137] = Lambda_5_11;
  const Real Lambda_0_5_p1 = Lambda_5_11_p4 * Lambda_0_11_p5823;
  const Real Lambda_0_5_p2 = Lambda_5_11_p3 * Lambda_0_11_p5798;
  const Real Lambda_0_5_p3 = Lambda_5_11_p2 * Lambda_0_11_p5665;
  const Real Lambda_0_5_p4 = Lambda_5_11_p1 * Lambda_0_11_p5496;
  const Real Lambda_0_5_p5 = Lambda_0_11_p5310 * Lambda_0_11_p5316;
  const Real Lambda_0_5_p6 = Lambda_0_0_p6 - Lambda_0_5_p5 * Lambda_0_11_p5830 + Lambda_0_5_p4 *
      Lambda_0_11_p5832 + Lambda_0_5_p3 * Lambda_0_11_p5834 + Lambda_0_5_p2 * Lambda_0_11_p5836;
  const Real Lambda_0_5 = Lambda_0_5_p6 + Lambda_0_5_p1 * Lambda_0_11_p5839 + Lambda_5_11 *
      Lambda_0_11_p5842;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_6_11_p1 = Lambda_0_11_p5497_lanes[0] * Lambda_0_11_p5491 -
      Lambda_0_11_p5317_lanes[0];
  const Real Lambda_6_11_p2 = Lambda_0_11_p5497_lanes[1] * Lambda_0_11_p5491 -
      Lambda_0_11_p5317_lanes[1] - Lambda_0_11_p5666_lanes[1] * Lambda_6_11_p1;
  const Real Lambda_6_11_p3 = Lambda_0_11_p5497_lanes[2] * Lambda_0_11_p5491 -
      Lambda_0_11_p5317_lanes[2] - Lambda_0_11_p5666_lanes[2] * Lambda_6_11_p1 - Lambda_0_11_p5818 *
      Lambda_6_11_p2;
  const Real Lambda_6_11_p4 = Lambda_0_11_p5497_lanes[3] * Lambda_0_11_p5491 -
      Lambda_0_11_p5317_lanes[3] - Lambda_0_11_p5666_lanes[3] * Lambda_6_11_p1 - Lambda_0_11_p5799 *
      Lambda_6_11_p2 - Lambda_0_11_p5824 * Lambda_6_11_p3;
  const Real Lambda_6_11 = Lambda_6_11_p4 * Lambda_11_11;
  Lambda[83] = Lambda_6_11;
  Lambda[138] = Lambda_6_11;
  const Real Lambda_0_6_p1 = Lambda_6_11_p3 * Lambda_0_11_p5823;
  const Real Lambda_0_6_p2 = Lambda_6_11_p2 * Lambda_0_11_p5798;
  const Real Lambda_0_6_p3 = Lambda_6_11_p1 * Lambda_0_11_p5665;
  const Real Lambda_0_6_p4 = Lambda_0_11_p5491 * Lambda_0_11_p5496;
  const Real Lambda_0_6_p5 = Lambda_0_0_p5 - Lambda_0_6_p4 * Lambda_0_11_p5832 + Lambda_0_6_p3 *
      Lambda_0_11_p5834 + Lambda_0_6_p2 * Lambda_0_11_p5836 + Lambda_0_6_p1 * Lambda_0_11_p5839;
  const Real Lambda_0_6 = Lambda_0_6_p5 + Lambda_6_11 * Lambda_0_11_p5842;
  Lambda[6] = Lambda_0_6;
  Lambda[72] = Lambda_0_6;
  const Real Lambda_7_11_p1 = Lambda_0_11_p5666_lanes[1] * Lambda_0_11_p5497_lanes[0] -
      Lambda_0_11_p5497_lanes[1];
  const Real Lambda_7_11_p2 = Lambda_0_11_p5666_lanes[2] * Lambda_0_11_p5497_lanes[0] -
      Lambda_0_11_p5497_lanes[2] - Lambda_0_11_p5818 * Lambda_7_11_p1;
  const Real Lambda_7_11_p3 = Lambda_0_11_p5666_lanes[3] * Lambda_0_11_p5497_lanes[0] -
      Lambda_0_11_p5497_lanes[3] - Lambda_0_11_p5799 * Lambda_7_11_p1 - Lambda_0_11_p5824 *
      Lambda_7_11_p2;
  const Real Lambda_7_11 = Lambda_7_11_p3 * Lambda_11_11;
  Lambda[95] = Lambda_7_11;
  Lambda[139] = Lambda_7_11;
  const Real Lambda_0_7_p1 = Lambda_7_11_p2 * Lambda_0_11_p5823;
  const Real Lambda_0_7_p2 = Lambda_7_11_p1 * Lambda_0_11_p5798;
  const Real Lambda_0_7_p3 = Lambda_0_11_p5497_lanes[0] * Lambda_0_11_p5665;
  const Real Lambda_0_7 = Lambda_0_0_p4 - Lambda_0_7_p3 * Lambda_0_11_p5834 + Lambda_0_7_p2 *
      Lambda_0_11_p5836 + Lambda_0_7_p1 * Lambda_0_11_p5839 + Lambda_7_11 * Lambda_0_11_p5842;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_8_11_p1 = Lambda_0_11_p5818 * Lambda_0_11_p5666_lanes[1] -
      Lambda_0_11_p5666_lanes[2];
  const Real Lambda_8_11_p2 = Lambda_0_11_p5799 * Lambda_0_11_p5666_lanes[1] -
      Lambda_0_11_p5666_lanes[3] - Lambda_0_11_p5824 * Lambda_8_11_p1;
  const Real Lambda_8_11 = Lambda_8_11_p2 * Lambda_11_11;
  Lambda[107] = Lambda_8_11;
  Lambda[140] = Lambda_8_11;
  const Real Lambda_0_8_p1 = Lambda_8_11_p1 * Lambda_0_11_p5823;
  const Real Lambda_0_8_p2 = Lambda_0_11_p5666_lanes[1] * Lambda_0_11_p5798;
  const Real Lambda_0_8 = Lambda_0_0_p3 - Lambda_0_8_p2 * Lambda_0_11_p5836 + Lambda_0_8_p1 *
      Lambda_0_11_p5839 + Lambda_8_11 * Lambda_0_11_p5842;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_9_11_p1 = Lambda_0_11_p5824 * Lambda_0_11_p5818 - Lambda_0_11_p5799;
  const Real Lambda_9_11 = Lambda_9_11_p1 * Lambda_11_11;
  Lambda[119] = Lambda_9_11;
  Lambda[141] = Lambda_9_11;
  const Real Lambda_0_9_p1 = Lambda_0_11_p5818 * Lambda_0_11_p5823;
  const Real Lambda_0_9 = Lambda_0_0_p2 - Lambda_0_9_p1 * Lambda_0_11_p5839 + Lambda_9_11 *
      Lambda_0_11_p5842;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_10_11 = Lambda_0_11_p5824 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real Lambda_0_10 = Lambda_0_0_p1 - Lambda_10_11 * Lambda_0_11_p5842;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  const Real Lambda_1_1_p1 = Lambda_0_11_p4349 + Lambda_0_1_p9 * Lambda_0_11_p4414_lanes[2] +
      Lambda_0_1_p8 * Lambda_1_11_p1 + Lambda_0_1_p7 * Lambda_1_11_p2 + Lambda_0_1_p6 *
      Lambda_1_11_p3;
  const Real Lambda_1_1_p2 = Lambda_1_1_p1 + Lambda_0_1_p5 * Lambda_1_11_p4 + Lambda_0_1_p4 *
      Lambda_1_11_p6 + Lambda_0_1_p3 * Lambda_1_11_p8 + Lambda_0_1_p2 * Lambda_1_11_p10;
  Lambda[13] = Lambda_1_1_p2 + Lambda_0_1_p1 * Lambda_1_11_p12 + Lambda_1_11 * Lambda_1_11_p15;
  const Real Lambda_1_2_p1 = Lambda_0_2_p7 * Lambda_1_11_p2 -
      (Lambda_0_1_p9 + Lambda_0_2_p8 * Lambda_1_11_p1) + Lambda_0_2_p6 * Lambda_1_11_p3 +
      Lambda_0_2_p5 * Lambda_1_11_p4;
  const Real Lambda_1_2_p2 = Lambda_1_2_p1 + Lambda_0_2_p4 * Lambda_1_11_p6 + Lambda_0_2_p3 *
      Lambda_1_11_p8 + Lambda_0_2_p2 * Lambda_1_11_p10 + Lambda_0_2_p1 * Lambda_1_11_p12;
  const Real Lambda_1_2 = Lambda_1_2_p2 + Lambda_2_11 * Lambda_1_11_p15;
  Lambda[14] = Lambda_1_2;
  Lambda[25] = Lambda_1_2;
  const Real Lambda_1_3_p1 = Lambda_0_1_p8 - Lambda_0_3_p7 * Lambda_1_11_p2 + Lambda_0_3_p6 *
      Lambda_1_11_p3 + Lambda_0_3_p5 * Lambda_1_11_p4 + Lambda_0_3_p4 * Lambda_1_11_p6;
  const Real Lambda_1_3 = Lambda_1_3_p1 + Lambda_0_3_p3 * Lambda_1_11_p8 + Lambda_0_3_p2 *
      Lambda_1_11_p10 + Lambda_0_3_p1 * Lambda_1_11_p12 + Lambda_3_11 * Lambda_1_11_p15;
  Lambda[15] = Lambda_1_3;
  Lambda[37] = Lambda_1_3;
  const Real Lambda_1_4_p1 = Lambda_0_1_p7 - Lambda_0_4_p6 * Lambda_1_11_p3 + Lambda_0_4_p5 *
      Lambda_1_11_p4 + Lambda_0_4_p4 * Lambda_1_11_p6 + Lambda_0_4_p3 * Lambda_1_11_p8;
  const Real Lambda_1_4 = Lambda_1_4_p1 + Lambda_0_4_p2 * Lambda_1_11_p10 + Lambda_0_4_p1 *
      Lambda_1_11_p12 + Lambda_4_11 * Lambda_1_11_p15;
  Lambda[16] = Lambda_1_4;
  Lambda[49] = Lambda_1_4;
  const Real Lambda_1_5_p1 = Lambda_0_1_p6 - Lambda_0_5_p5 * Lambda_1_11_p4 + Lambda_0_5_p4 *
      Lambda_1_11_p6 + Lambda_0_5_p3 * Lambda_1_11_p8 + Lambda_0_5_p2 * Lambda_1_11_p10;
  const Real Lambda_1_5 = Lambda_1_5_p1 + Lambda_0_5_p1 * Lambda_1_11_p12 + Lambda_5_11 *
      Lambda_1_11_p15;
  Lambda[17] = Lambda_1_5;
  Lambda[61] = Lambda_1_5;
  const Real Lambda_1_6_p1 = Lambda_0_1_p5 - Lambda_0_6_p4 * Lambda_1_11_p6 + Lambda_0_6_p3 *
      Lambda_1_11_p8 + Lambda_0_6_p2 * Lambda_1_11_p10 + Lambda_0_6_p1 * Lambda_1_11_p12;
  const Real Lambda_1_6 = Lambda_1_6_p1 + Lambda_6_11 * Lambda_1_11_p15;
  Lambda[18] = Lambda_1_6;
  Lambda[73] = Lambda_1_6;
  const Real Lambda_1_7 = Lambda_0_1_p4 - Lambda_0_7_p3 * Lambda_1_11_p8 + Lambda_0_7_p2 *
      Lambda_1_11_p10 + Lambda_0_7_p1 * Lambda_1_11_p12 + Lambda_7_11 * Lambda_1_11_p15;
  Lambda[19] = Lambda_1_7;
  Lambda[85] = Lambda_1_7;
  const Real Lambda_1_8 = Lambda_0_1_p3 - Lambda_0_8_p2 * Lambda_1_11_p10 + Lambda_0_8_p1 *
      Lambda_1_11_p12 + Lambda_8_11 * Lambda_1_11_p15;
  Lambda[20] = Lambda_1_8;
  Lambda[97] = Lambda_1_8;
  const Real Lambda_1_9 = Lambda_0_1_p2 - Lambda_0_9_p1 * Lambda_1_11_p12 + Lambda_9_11 *
      Lambda_1_11_p15;
  Lambda[21] = Lambda_1_9;
  Lambda[109] = Lambda_1_9;
  const Real Lambda_1_10 = Lambda_0_1_p1 - Lambda_10_11 * Lambda_1_11_p15;
  Lambda[22] = Lambda_1_10;
  Lambda[121] = Lambda_1_10;
  const Real Lambda_2_2_p1 = Lambda_0_11_p4564 + Lambda_0_2_p8 * Lambda_0_11_p4637_lanes[3] +
      Lambda_0_2_p7 * Lambda_2_11_p1 + Lambda_0_2_p6 * Lambda_2_11_p2 + Lambda_0_2_p5 *
      Lambda_2_11_p3;
  const Real Lambda_2_2_p2 = Lambda_2_2_p1 + Lambda_0_2_p4 * Lambda_2_11_p4 + Lambda_0_2_p3 *
      Lambda_2_11_p6 + Lambda_0_2_p2 * Lambda_2_11_p8 + Lambda_0_2_p1 * Lambda_2_11_p10;
  Lambda[26] = Lambda_2_2_p2 + Lambda_2_11 * Lambda_2_11_p12;
  const Real Lambda_2_3_p1 = Lambda_0_3_p6 * Lambda_2_11_p2 -
      (Lambda_0_2_p8 + Lambda_0_3_p7 * Lambda_2_11_p1) + Lambda_0_3_p5 * Lambda_2_11_p3 +
      Lambda_0_3_p4 * Lambda_2_11_p4;
  const Real Lambda_2_3 = Lambda_2_3_p1 + Lambda_0_3_p3 * Lambda_2_11_p6 + Lambda_0_3_p2 *
      Lambda_2_11_p8 + Lambda_0_3_p1 * Lambda_2_11_p10 + Lambda_3_11 * Lambda_2_11_p12;
  Lambda[27] = Lambda_2_3;
  Lambda[38] = Lambda_2_3;
  const Real Lambda_2_4_p1 = Lambda_0_2_p7 - Lambda_0_4_p6 * Lambda_2_11_p2 + Lambda_0_4_p5 *
      Lambda_2_11_p3 + Lambda_0_4_p4 * Lambda_2_11_p4 + Lambda_0_4_p3 * Lambda_2_11_p6;
  const Real Lambda_2_4 = Lambda_2_4_p1 + Lambda_0_4_p2 * Lambda_2_11_p8 + Lambda_0_4_p1 *
      Lambda_2_11_p10 + Lambda_4_11 * Lambda_2_11_p12;
  Lambda[28] = Lambda_2_4;
  Lambda[50] = Lambda_2_4;
  const Real Lambda_2_5_p1 = Lambda_0_2_p6 - Lambda_0_5_p5 * Lambda_2_11_p3 + Lambda_0_5_p4 *
      Lambda_2_11_p4 + Lambda_0_5_p3 * Lambda_2_11_p6 + Lambda_0_5_p2 * Lambda_2_11_p8;
  const Real Lambda_2_5 = Lambda_2_5_p1 + Lambda_0_5_p1 * Lambda_2_11_p10 + Lambda_5_11 *
      Lambda_2_11_p12;
  Lambda[29] = Lambda_2_5;
  Lambda[62] = Lambda_2_5;
  const Real Lambda_2_6_p1 = Lambda_0_2_p5 - Lambda_0_6_p4 * Lambda_2_11_p4 + Lambda_0_6_p3 *
      Lambda_2_11_p6 + Lambda_0_6_p2 * Lambda_2_11_p8 + Lambda_0_6_p1 * Lambda_2_11_p10;
  const Real Lambda_2_6 = Lambda_2_6_p1 + Lambda_6_11 * Lambda_2_11_p12;
  Lambda[30] = Lambda_2_6;
  Lambda[74] = Lambda_2_6;
  const Real Lambda_2_7 = Lambda_0_2_p4 - Lambda_0_7_p3 * Lambda_2_11_p6 + Lambda_0_7_p2 *
      Lambda_2_11_p8 + Lambda_0_7_p1 * Lambda_2_11_p10 + Lambda_7_11 * Lambda_2_11_p12;
  Lambda[31] = Lambda_2_7;
  Lambda[86] = Lambda_2_7;
  const Real Lambda_2_8 = Lambda_0_2_p3 - Lambda_0_8_p2 * Lambda_2_11_p8 + Lambda_0_8_p1 *
      Lambda_2_11_p10 + Lambda_8_11 * Lambda_2_11_p12;
  Lambda[32] = Lambda_2_8;
  Lambda[98] = Lambda_2_8;
  const Real Lambda_2_9 = Lambda_0_2_p2 - Lambda_0_9_p1 * Lambda_2_11_p10 + Lambda_9_11 *
      Lambda_2_11_p12;
  Lambda[33] = Lambda_2_9;
  Lambda[110] = Lambda_2_9;
  const Real Lambda_2_10 = Lambda_0_2_p1 - Lambda_10_11 * Lambda_2_11_p12;
  Lambda[34] = Lambda_2_10;
  Lambda[122] = Lambda_2_10;
  const Real Lambda_3_3_p1 = Lambda_0_11_p4767 + Lambda_0_3_p7 * Lambda_0_11_p4848_lanes[4] +
      Lambda_0_3_p6 * Lambda_3_11_p1 + Lambda_0_3_p5 * Lambda_3_11_p2 + Lambda_0_3_p4 *
      Lambda_3_11_p3;
  Lambda[39] = Lambda_3_3_p1 + Lambda_0_3_p3 * Lambda_3_11_p4 + Lambda_0_3_p2 * Lambda_3_11_p6 +
      Lambda_0_3_p1 * Lambda_3_11_p8 + Lambda_3_11 * Lambda_3_11_p10;
  const Real Lambda_3_4_p1 = Lambda_0_4_p5 * Lambda_3_11_p2 -
      (Lambda_0_3_p7 + Lambda_0_4_p6 * Lambda_3_11_p1) + Lambda_0_4_p4 * Lambda_3_11_p3 +
      Lambda_0_4_p3 * Lambda_3_11_p4;
  const Real Lambda_3_4 = Lambda_3_4_p1 + Lambda_0_4_p2 * Lambda_3_11_p6 + Lambda_0_4_p1 *
      Lambda_3_11_p8 + Lambda_4_11 * Lambda_3_11_p10;
  Lambda[40] = Lambda_3_4;
  Lambda[51] = Lambda_3_4;
  const Real Lambda_3_5_p1 = Lambda_0_3_p6 - Lambda_0_5_p5 * Lambda_3_11_p2 + Lambda_0_5_p4 *
      Lambda_3_11_p3 + Lambda_0_5_p3 * Lambda_3_11_p4 + Lambda_0_5_p2 * Lambda_3_11_p6;
  const Real Lambda_3_5 = Lambda_3_5_p1 + Lambda_0_5_p1 * Lambda_3_11_p8 + Lambda_5_11 *
      Lambda_3_11_p10;
  Lambda[41] = Lambda_3_5;
  Lambda[63] = Lambda_3_5;
  const Real Lambda_3_6_p1 = Lambda_0_3_p5 - Lambda_0_6_p4 * Lambda_3_11_p3 + Lambda_0_6_p3 *
      Lambda_3_11_p4 + Lambda_0_6_p2 * Lambda_3_11_p6 + Lambda_0_6_p1 * Lambda_3_11_p8;
  const Real Lambda_3_6 = Lambda_3_6_p1 + Lambda_6_11 * Lambda_3_11_p10;
  Lambda[42] = Lambda_3_6;
  Lambda[75] = Lambda_3_6;
  const Real Lambda_3_7 = Lambda_0_3_p4 - Lambda_0_7_p3 * Lambda_3_11_p4 + Lambda_0_7_p2 *
      Lambda_3_11_p6 + Lambda_0_7_p1 * Lambda_3_11_p8 + Lambda_7_11 * Lambda_3_11_p10;
  Lambda[43] = Lambda_3_7;
  Lambda[87] = Lambda_3_7;
  const Real Lambda_3_8 = Lambda_0_3_p3 - Lambda_0_8_p2 * Lambda_3_11_p6 + Lambda_0_8_p1 *
      Lambda_3_11_p8 + Lambda_8_11 * Lambda_3_11_p10;
  Lambda[44] = Lambda_3_8;
  Lambda[99] = Lambda_3_8;
  const Real Lambda_3_9 = Lambda_0_3_p2 - Lambda_0_9_p1 * Lambda_3_11_p8 + Lambda_9_11 *
      Lambda_3_11_p10;
  Lambda[45] = Lambda_3_9;
  Lambda[111] = Lambda_3_9;
  const Real Lambda_3_10 = Lambda_0_3_p1 - Lambda_10_11 * Lambda_3_11_p10;
  Lambda[46] = Lambda_3_10;
  Lambda[123] = Lambda_3_10;
  const Real Lambda_4_4_p1 = Lambda_0_11_p4988 + Lambda_0_4_p6 * Lambda_0_11_p5077_lanes[5] +
      Lambda_0_4_p5 * Lambda_4_11_p1 + Lambda_0_4_p4 * Lambda_4_11_p2 + Lambda_0_4_p3 *
      Lambda_4_11_p3;
  Lambda[52] = Lambda_4_4_p1 + Lambda_0_4_p2 * Lambda_4_11_p4 + Lambda_0_4_p1 * Lambda_4_11_p6 +
      Lambda_4_11 * Lambda_4_11_p8;
  const Real Lambda_4_5_p1 = Lambda_0_5_p4 * Lambda_4_11_p2 -
      (Lambda_0_4_p6 + Lambda_0_5_p5 * Lambda_4_11_p1) + Lambda_0_5_p3 * Lambda_4_11_p3 +
      Lambda_0_5_p2 * Lambda_4_11_p4;
  const Real Lambda_4_5 = Lambda_4_5_p1 + Lambda_0_5_p1 * Lambda_4_11_p6 + Lambda_5_11 *
      Lambda_4_11_p8;
  Lambda[53] = Lambda_4_5;
  Lambda[64] = Lambda_4_5;
  const Real Lambda_4_6_p1 = Lambda_0_4_p5 - Lambda_0_6_p4 * Lambda_4_11_p2 + Lambda_0_6_p3 *
      Lambda_4_11_p3 + Lambda_0_6_p2 * Lambda_4_11_p4 + Lambda_0_6_p1 * Lambda_4_11_p6;
  const Real Lambda_4_6 = Lambda_4_6_p1 + Lambda_6_11 * Lambda_4_11_p8;
  Lambda[54] = Lambda_4_6;
  Lambda[76] = Lambda_4_6;
  const Real Lambda_4_7 = Lambda_0_4_p4 - Lambda_0_7_p3 * Lambda_4_11_p3 + Lambda_0_7_p2 *
      Lambda_4_11_p4 + Lambda_0_7_p1 * Lambda_4_11_p6 + Lambda_7_11 * Lambda_4_11_p8;
  Lambda[55] = Lambda_4_7;
  Lambda[88] = Lambda_4_7;
  const Real Lambda_4_8 = Lambda_0_4_p3 - Lambda_0_8_p2 * Lambda_4_11_p4 + Lambda_0_8_p1 *
      Lambda_4_11_p6 + Lambda_8_11 * Lambda_4_11_p8;
  Lambda[56] = Lambda_4_8;
  Lambda[100] = Lambda_4_8;
  const Real Lambda_4_9 = Lambda_0_4_p2 - Lambda_0_9_p1 * Lambda_4_11_p6 + Lambda_9_11 *
      Lambda_4_11_p8;
  Lambda[57] = Lambda_4_9;
  Lambda[112] = Lambda_4_9;
  const Real Lambda_4_10 = Lambda_0_4_p1 - Lambda_10_11 * Lambda_4_11_p8;
  Lambda[58] = Lambda_4_10;
  Lambda[124] = Lambda_4_10;
  const Real Lambda_5_5_p1 = Lambda_0_11_p5156 + Lambda_0_5_p5 * Lambda_0_11_p5310 + Lambda_0_5_p4 *
      Lambda_5_11_p1 + Lambda_0_5_p3 * Lambda_5_11_p2 + Lambda_0_5_p2 * Lambda_5_11_p3;
  Lambda[65] = Lambda_5_5_p1 + Lambda_0_5_p1 * Lambda_5_11_p4 + Lambda_5_11 * Lambda_5_11_p6;
  const Real Lambda_5_6_p1 = Lambda_0_6_p3 * Lambda_5_11_p2 -
      (Lambda_0_5_p5 + Lambda_0_6_p4 * Lambda_5_11_p1) + Lambda_0_6_p2 * Lambda_5_11_p3 +
      Lambda_0_6_p1 * Lambda_5_11_p4;
  const Real Lambda_5_6 = Lambda_5_6_p1 + Lambda_6_11 * Lambda_5_11_p6;
  Lambda[66] = Lambda_5_6;
  Lambda[77] = Lambda_5_6;
  const Real Lambda_5_7 = Lambda_0_5_p4 - Lambda_0_7_p3 * Lambda_5_11_p2 + Lambda_0_7_p2 *
      Lambda_5_11_p3 + Lambda_0_7_p1 * Lambda_5_11_p4 + Lambda_7_11 * Lambda_5_11_p6;
  Lambda[67] = Lambda_5_7;
  Lambda[89] = Lambda_5_7;
  const Real Lambda_5_8 = Lambda_0_5_p3 - Lambda_0_8_p2 * Lambda_5_11_p3 + Lambda_0_8_p1 *
      Lambda_5_11_p4 + Lambda_8_11 * Lambda_5_11_p6;
  Lambda[68] = Lambda_5_8;
  Lambda[101] = Lambda_5_8;
  const Real Lambda_5_9 = Lambda_0_5_p2 - Lambda_0_9_p1 * Lambda_5_11_p4 + Lambda_9_11 *
      Lambda_5_11_p6;
  Lambda[69] = Lambda_5_9;
  Lambda[113] = Lambda_5_9;
  const Real Lambda_5_10 = Lambda_0_5_p1 - Lambda_10_11 * Lambda_5_11_p6;
  Lambda[70] = Lambda_5_10;
  Lambda[125] = Lambda_5_10;
  const Real Lambda_6_6_p1 = Lambda_0_11_p5316 + Lambda_0_6_p4 * Lambda_0_11_p5491 + Lambda_0_6_p3 *
      Lambda_6_11_p1 + Lambda_0_6_p2 * Lambda_6_11_p2 + Lambda_0_6_p1 * Lambda_6_11_p3;
  Lambda[78] = Lambda_6_6_p1 + Lambda_6_11 * Lambda_6_11_p4;
  const Real Lambda_6_7 = Lambda_0_7_p2 * Lambda_6_11_p2 -
      (Lambda_0_6_p4 + Lambda_0_7_p3 * Lambda_6_11_p1) + Lambda_0_7_p1 * Lambda_6_11_p3 +
      Lambda_7_11 * Lambda_6_11_p4;
  Lambda[79] = Lambda_6_7;
  Lambda[90] = Lambda_6_7;
  const Real Lambda_6_8 = Lambda_0_6_p3 - Lambda_0_8_p2 * Lambda_6_11_p2 + Lambda_0_8_p1 *
      Lambda_6_11_p3 + Lambda_8_11 * Lambda_6_11_p4;
  Lambda[80] = Lambda_6_8;
  Lambda[102] = Lambda_6_8;
  const Real Lambda_6_9 = Lambda_0_6_p2 - Lambda_0_9_p1 * Lambda_6_11_p3 + Lambda_9_11 *
      Lambda_6_11_p4;
  Lambda[81] = Lambda_6_9;
  Lambda[114] = Lambda_6_9;
  const Real Lambda_6_10 = Lambda_0_6_p1 - Lambda_10_11 * Lambda_6_11_p4;
  Lambda[82] = Lambda_6_10;
  Lambda[126] = Lambda_6_10;
  Lambda[91] = Lambda_0_11_p5496 + Lambda_0_7_p3 * Lambda_0_11_p5497_lanes[0] + Lambda_0_7_p2 *
      Lambda_7_11_p1 + Lambda_0_7_p1 * Lambda_7_11_p2 + Lambda_7_11 * Lambda_7_11_p3;
  const Real Lambda_7_8 = Lambda_0_8_p1 * Lambda_7_11_p2 -
      (Lambda_0_7_p3 + Lambda_0_8_p2 * Lambda_7_11_p1) + Lambda_8_11 * Lambda_7_11_p3;
  Lambda[92] = Lambda_7_8;
  Lambda[103] = Lambda_7_8;
  const Real Lambda_7_9 = Lambda_0_7_p2 - Lambda_0_9_p1 * Lambda_7_11_p2 + Lambda_9_11 *
      Lambda_7_11_p3;
  Lambda[93] = Lambda_7_9;
  Lambda[115] = Lambda_7_9;
  const Real Lambda_7_10 = Lambda_0_7_p1 - Lambda_10_11 * Lambda_7_11_p3;
  Lambda[94] = Lambda_7_10;
  Lambda[127] = Lambda_7_10;
  Lambda[104] = Lambda_0_11_p5665 + Lambda_0_8_p2 * Lambda_0_11_p5666_lanes[1] + Lambda_0_8_p1 *
      Lambda_8_11_p1 + Lambda_8_11 * Lambda_8_11_p2;
  const Real Lambda_8_9 = Lambda_9_11 * Lambda_8_11_p2 -
      (Lambda_0_8_p2 + Lambda_0_9_p1 * Lambda_8_11_p1);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p1 - Lambda_10_11 * Lambda_8_11_p2;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = Lambda_0_11_p5798 + Lambda_0_9_p1 * Lambda_0_11_p5818 + Lambda_9_11 *
      Lambda_9_11_p1;
  const Real Lambda_9_10 = Lambda_0_9_p1 + Lambda_10_11 * Lambda_9_11_p1;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_0_11_p5823 + Lambda_10_11 * Lambda_0_11_p5824;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
