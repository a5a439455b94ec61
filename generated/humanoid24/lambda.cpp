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

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1293_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p1250_lanes - detail::make_pack<Real>(s11, s18) * Lambda_0_11_p1242_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1297_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1285_lanes + detail::make_pack<Real>(s13, s20) * Lambda_0_11_p1293_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1303_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_0_11_p1218_lanes[0], Lambda_0_11_p1276) -
      detail::make_pack<Real>(s12, s19) * Lambda_0_11_p1274_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1311_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_0_11_p1270_lanes - detail::make_pack<Real>(s11, s18) * Lambda_0_11_p1262_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1315_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1303_lanes + detail::make_pack<Real>(s13, s20) * Lambda_0_11_p1311_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1317_lanes = detail::make_pack<Real>(Lambda_0_11_p1315_lanes[1],
      Lambda_0_11_p1315_lanes[1], Lambda_0_11_p1297_lanes[1], Lambda_0_11_p1235_lanes[1],
      Lambda_0_11_p1315_lanes[1], Lambda_0_11_p1315_lanes[1], Lambda_0_11_p1315_lanes[1],
      Lambda_0_11_p1315_lanes[1]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1324_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1223_lanes + detail::make_pack<Real>(c13, c20) * Lambda_0_11_p1231_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_0_11_p1328_lanes = -(0.086 * Lambda_0_11_p1324_lanes);
  const Lanes<2> Lambda_0_11_p1330_lanes = 0.11533812622014242 * Lambda_0_11_p1328_lanes;
  const Lanes<2> Lambda_0_11_p1336_lanes = -Lambda_0_11_p1324_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1346_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1293_lanes - detail::make_pack<Real>(s13, s20) * Lambda_0_11_p1285_lanes;
  const Lanes<2> Lambda_0_11_p1352_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1311_lanes - detail::make_pack<Real>(s13, s20) * Lambda_0_11_p1303_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1354_lanes = detail::make_pack<Real>(-(0.086 * Lambda_0_11_p1237),
      Lambda_0_11_p1352_lanes[1], Lambda_0_11_p1346_lanes[1], Lambda_0_11_p1336_lanes[1],
      -(0.086 * Lambda_0_11_p1237), -(0.086 * Lambda_0_11_p1237), -(0.086 * Lambda_0_11_p1237),
      -(0.086 * Lambda_0_11_p1237)) - (-0.04672761636452121) *
      detail::make_pack<Real>(Lambda_0_11_p1328_lanes[1], Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1328_lanes[1], Lambda_0_11_p1328_lanes[1],
      Lambda_0_11_p1328_lanes[1], Lambda_0_11_p1328_lanes[1]);
  const Lanes<8> Lambda_0_11_p1374_lanes = s20 * detail::make_pack<Real>(Lambda_0_11_p1330_lanes[1],
      Lambda_0_11_p1317_lanes[1], Lambda_0_11_p1317_lanes[2], Lambda_0_11_p1317_lanes[3],
      Lambda_0_11_p1330_lanes[1], Lambda_0_11_p1330_lanes[1], Lambda_0_11_p1330_lanes[1],
      Lambda_0_11_p1330_lanes[1]) + c20 * Lambda_0_11_p1354_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1382_lanes = c20 * detail::make_pack<Real>(Lambda_0_11_p1330_lanes[1],
      Lambda_0_11_p1317_lanes[1], Lambda_0_11_p1317_lanes[2], Lambda_0_11_p1317_lanes[3],
      Lambda_0_11_p1330_lanes[1], Lambda_0_11_p1330_lanes[1], Lambda_0_11_p1330_lanes[1],
      Lambda_0_11_p1330_lanes[1]) - s20 * Lambda_0_11_p1354_lanes - inverse_D11_p1_lanes[1] *
      Lambda_0_11_p1374_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1394_lanes = 3.0523172236718206 *
      detail::make_pack<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);
  const Lanes<8> Lambda_0_11_p1400_lanes = 17.32841575379867 *
      detail::make_pack<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);
  const Lanes<8> Lambda_0_11_p1406_lanes = s20 * Lambda_0_11_p1394_lanes - c20 *
      Lambda_0_11_p1400_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_0_11_p1411_lanes = Lambda_0_11_p1235_lanes +
      detail::make_pack<Real>((-3.0523172236718206), 3.0523172236718206) * Lambda_0_11_p1328_lanes;
  const Lanes<2> Lambda_0_11_p1417_lanes = Lambda_0_11_p1336_lanes - 17.32841575379867 *
      Lambda_0_11_p1328_lanes;
  const Lanes<2> Lambda_0_11_p1421_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_0_11_p1411_lanes + detail::make_pack<Real>(c13, c20) * Lambda_0_11_p1417_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1423_lanes = detail::make_pack<Real>(Lambda_0_11_p1421_lanes[1],
      Lambda_0_11_p1406_lanes[1], Lambda_0_11_p1406_lanes[2], Lambda_0_11_p1406_lanes[3],
      Lambda_0_11_p1421_lanes[1], Lambda_0_11_p1421_lanes[1], Lambda_0_11_p1421_lanes[1],
      Lambda_0_11_p1421_lanes[1]) - Lambda_0_11_p61_lanes[1] * Lambda_0_11_p1374_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1439_lanes = -(c19 * Lambda_0_11_p1382_lanes);
  const Lanes<8> Lambda_0_11_p1447_lanes = 0.269 * Lambda_0_11_p1423_lanes - s19 *
      Lambda_0_11_p1382_lanes - inverse_D10_p1_lanes[1] * Lambda_0_11_p1439_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1455_lanes = Lambda_0_11_p35_lanes[1] * Lambda_0_11_p1374_lanes;
  const Lanes<8> Lambda_0_11_p1473_lanes = c20 * Lambda_0_11_p1394_lanes + s20 *
      Lambda_0_11_p1400_lanes - Lambda_0_11_p11_lanes[1] * Lambda_0_11_p1374_lanes;
  const Lanes<8> Lambda_0_11_p1479_lanes = c19 * Lambda_0_11_p1455_lanes + s19 *
      Lambda_0_11_p1473_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_0_11_p1486_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_0_11_p1411_lanes - detail::make_pack<Real>(s13, s20) * Lambda_0_11_p1417_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p1488 = Lambda_0_11_p1486_lanes[1] - Lambda_0_11_p11_lanes[1] *
      Lambda_0_11_p1374_lanes[0];
  const Real Lambda_0_11_p1489 = Lambda_0_11_p1237 - Lambda_0_11_p35_lanes[1] *
      Lambda_0_11_p1374_lanes[0];
  const Real Lambda_0_11_p1490 = s19 * Lambda_0_11_p1488 - c19 * Lambda_0_11_p1489;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1499_lanes = 0.269 * detail::make_pack<Real>(Lambda_0_11_p1490,
      Lambda_0_11_p1479_lanes[1], Lambda_0_11_p1479_lanes[2], Lambda_0_11_p1479_lanes[3],
      Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1490) -
      inverse_D10_p8_lanes[1] * Lambda_0_11_p1439_lanes;
  const Lanes<8> Lambda_0_11_p1519_lanes = s18 * Lambda_0_11_p1447_lanes + c18 *
      Lambda_0_11_p1499_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1527_lanes = c18 * Lambda_0_11_p1447_lanes - s18 *
      Lambda_0_11_p1499_lanes - Lambda_0_11_p231_lanes[1] * Lambda_0_11_p1519_lanes;
  const Lanes<8> Lambda_0_11_p1535_lanes = Lambda_0_11_p221_lanes[1] * Lambda_0_11_p1519_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1559_lanes = -detail::make_pack<Real>(Lambda_0_11_p1490,
      Lambda_0_11_p1479_lanes[1], Lambda_0_11_p1479_lanes[2], Lambda_0_11_p1479_lanes[3],
      Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1490) +
      Lambda_0_11_p55_lanes[1] * Lambda_0_11_p1439_lanes;
  const Lanes<8> Lambda_0_11_p1571_lanes = Lambda_0_11_p1423_lanes - Lambda_0_11_p119_lanes[1] *
      Lambda_0_11_p1439_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1583_lanes = s18 * Lambda_0_11_p1559_lanes + c18 *
      Lambda_0_11_p1571_lanes - Lambda_0_11_p191_lanes[1] * Lambda_0_11_p1519_lanes;
  const Lanes<8> Lambda_0_11_p1603_lanes = c17 * Lambda_0_11_p1535_lanes - s17 *
      Lambda_0_11_p1527_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p1607_lanes = Lambda_0_11_p259_lanes[1] * Lambda_0_11_p1603_lanes;
  const Lanes<8> Lambda_0_11_p1611_lanes = c17 * Lambda_0_11_p1527_lanes + s17 *
      Lambda_0_11_p1535_lanes + 0.282 * Lambda_0_11_p1583_lanes - Lambda_0_11_p1607_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1629_lanes = s19 * Lambda_0_11_p1455_lanes - c19 *
      Lambda_0_11_p1473_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_0_11_p1642_lanes = c12 * detail::make_pack<Real>(Lambda_0_11_p1274_lanes[0],
      Lambda_0_11_p1254_lanes[0], Lambda_0_11_p1137_lanes[0], Lambda_0_11_p1274_lanes[0],
      Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1274_lanes[0],
      Lambda_0_11_p1274_lanes[0]) + s12 * Lambda_0_11_p1218_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1648_lanes = detail::make_pack<Real>(Lambda_0_11_p1315_lanes[0],
      Lambda_0_11_p1315_lanes[0], Lambda_0_11_p1315_lanes[0], Lambda_0_11_p1315_lanes[0],
      Lambda_0_11_p1297_lanes[0], Lambda_0_11_p1235_lanes[0], Lambda_0_11_p1315_lanes[0],
      Lambda_0_11_p1315_lanes[0]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[0],
      Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[1],
      Lambda_0_11_p1642_lanes[2], Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[0]);
  const Lanes<2> Lambda_0_11_p1651_lanes = 0.009919078854932248 * Lambda_0_11_p1346_lanes;
  const Lanes<2> Lambda_0_11_p1653_lanes = 0.009919078854932248 * Lambda_0_11_p1352_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_0_11_p1667_lanes = 0.086 * Lambda_0_11_p1642_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1670_lanes = detail::make_pack<Real>(-Lambda_0_11_p1667_lanes[0],
      -Lambda_0_11_p1667_lanes[1], -Lambda_0_11_p1667_lanes[2], Lambda_0_11_p1352_lanes[0],
      Lambda_0_11_p1346_lanes[0], Lambda_0_11_p1336_lanes[0], -Lambda_0_11_p1667_lanes[0],
      -Lambda_0_11_p1667_lanes[0]) - detail::make_pack<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_pack<Real>(Lambda_0_11_p1352_lanes[0], Lambda_0_11_p1346_lanes[0],
      Lambda_0_11_p1328_lanes[0], Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[1],
      Lambda_0_11_p1642_lanes[2], Lambda_0_11_p1352_lanes[0], Lambda_0_11_p1352_lanes[0]);
  const Lanes<8> Lambda_0_11_p1682_lanes = s13 * detail::make_pack<Real>(Lambda_0_11_p1653_lanes[0],
      Lambda_0_11_p1651_lanes[0], Lambda_0_11_p1330_lanes[0], Lambda_0_11_p1648_lanes[3],
      Lambda_0_11_p1648_lanes[4], Lambda_0_11_p1648_lanes[5], Lambda_0_11_p1653_lanes[0],
      Lambda_0_11_p1653_lanes[0]) + c13 * Lambda_0_11_p1670_lanes;
  const Lanes<8> Lambda_0_11_p1691_lanes = (-3.0523172236718206) *
      detail::make_pack<Real>(Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[0],
      Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[1],
      Lambda_0_11_p1642_lanes[2], Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[0]);
  const Lanes<2> Lambda_0_11_p1696_lanes = Lambda_0_11_p1297_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_0_11_p1346_lanes;
  const Lanes<2> Lambda_0_11_p1700_lanes = Lambda_0_11_p1315_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_0_11_p1352_lanes;
  const Lanes<8> Lambda_0_11_p1707_lanes = detail::make_pack<Real>(0.49024375482668536,
      0.49024375482668536, 0.49024375482668536, 17.32841575379867, 17.32841575379867,
      17.32841575379867, 0.49024375482668536, 0.49024375482668536) *
      detail::make_pack<Real>(Lambda_0_11_p1352_lanes[0], Lambda_0_11_p1346_lanes[0],
      Lambda_0_11_p1352_lanes[0], Lambda_0_11_p1642_lanes[0], Lambda_0_11_p1642_lanes[1],
      Lambda_0_11_p1642_lanes[2], Lambda_0_11_p1352_lanes[0], Lambda_0_11_p1352_lanes[0]);
  const Lanes<8> Lambda_0_11_p1717_lanes = c13 * detail::make_pack<Real>(Lambda_0_11_p1700_lanes[0],
      Lambda_0_11_p1696_lanes[0], Lambda_0_11_p1700_lanes[0], Lambda_0_11_p1691_lanes[3],
      Lambda_0_11_p1691_lanes[4], Lambda_0_11_p1691_lanes[5], Lambda_0_11_p1700_lanes[0],
      Lambda_0_11_p1700_lanes[0]) + s13 * Lambda_0_11_p1707_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1722_lanes = detail::make_pack<Real>(Lambda_0_11_p1717_lanes[0],
      Lambda_0_11_p1717_lanes[1], Lambda_0_11_p1486_lanes[0], Lambda_0_11_p1717_lanes[0],
      Lambda_0_11_p1717_lanes[0], Lambda_0_11_p1717_lanes[0], Lambda_0_11_p1717_lanes[0],
      Lambda_0_11_p1717_lanes[0]) - Lambda_0_11_p11_lanes[0] * Lambda_0_11_p1682_lanes;
  const Lanes<8> Lambda_0_11_p1730_lanes = Lambda_0_11_p1642_lanes - Lambda_0_11_p35_lanes[0] *
      Lambda_0_11_p1682_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p1737_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_0_11_p1730_lanes[2], Lambda_0_11_p1489) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_0_11_p1722_lanes[2],
      Lambda_0_11_p1488));

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1747_lanes = -(detail::make_pack<Real>(Lambda_0_11_p1737_lanes[1],
      Lambda_0_11_p1629_lanes[1], Lambda_0_11_p1629_lanes[2], Lambda_0_11_p1629_lanes[3],
      Lambda_0_11_p1737_lanes[1], Lambda_0_11_p1737_lanes[1], Lambda_0_11_p1737_lanes[1],
      Lambda_0_11_p1737_lanes[1]) - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1439_lanes) -
      Lambda_0_11_p363_lanes[1] * Lambda_0_11_p1519_lanes;
  const Lanes<8> Lambda_0_11_p1771_lanes = c18 * Lambda_0_11_p1559_lanes - s18 *
      Lambda_0_11_p1571_lanes - Lambda_0_11_p317_lanes[1] * Lambda_0_11_p1519_lanes;
  const Lanes<8> Lambda_0_11_p1779_lanes = s17 * Lambda_0_11_p1747_lanes - c17 *
      Lambda_0_11_p1771_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p1791_lanes = 0.282 * Lambda_0_11_p1779_lanes -
      Lambda_0_11_p401_lanes[1] * Lambda_0_11_p1603_lanes;
  const Lanes<8> Lambda_0_11_p1799_lanes = c16 * Lambda_0_11_p1611_lanes - s16 *
      Lambda_0_11_p1791_lanes;
  const Lanes<8> Lambda_0_11_p1827_lanes = -(s17 * Lambda_0_11_p1771_lanes + c17 *
      Lambda_0_11_p1747_lanes) + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1603_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p1835_lanes = -Lambda_0_11_p1827_lanes + Lambda_0_11_p555_lanes[1] *
      Lambda_0_11_p1799_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p1855_lanes = -Lambda_0_11_p1779_lanes + Lambda_0_11_p569_lanes[1] *
      Lambda_0_11_p1603_lanes;
  const Lanes<8> Lambda_0_11_p1867_lanes = Lambda_0_11_p1583_lanes - Lambda_0_11_p577_lanes[1] *
      Lambda_0_11_p1603_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p1879_lanes = s16 * Lambda_0_11_p1855_lanes + c16 *
      Lambda_0_11_p1867_lanes - Lambda_0_11_p609_lanes[1] * Lambda_0_11_p1799_lanes;
  const Lanes<8> Lambda_0_11_p1907_lanes = s16 * Lambda_0_11_p1611_lanes + c16 *
      Lambda_0_11_p1791_lanes - inverse_D7_p1_lanes[1] * Lambda_0_11_p1799_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p1915_lanes = 0.00010499999999999999 / inverse_D8_p3_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p1917_lanes = Lambda_0_11_p1915_lanes[1] * Lambda_0_11_p1799_lanes;
  const Lanes<8> Lambda_0_11_p1925_lanes = s15 * Lambda_0_11_p1917_lanes + c15 *
      Lambda_0_11_p1907_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p1933_lanes = s15 * Lambda_0_11_p1835_lanes + c15 *
      Lambda_0_11_p1879_lanes - Lambda_0_11_p837_lanes[1] * Lambda_0_11_p1925_lanes;
  const Lanes<8> Lambda_0_11_p1957_lanes = c15 * Lambda_0_11_p1835_lanes - s15 *
      Lambda_0_11_p1879_lanes - Lambda_0_11_p639_lanes[1] * Lambda_0_11_p1925_lanes;
  const Lanes<8> Lambda_0_11_p1965_lanes = Lambda_0_11_p679_lanes[1] * Lambda_0_11_p1925_lanes;
  const Lanes<8> Lambda_0_11_p1989_lanes = c16 * Lambda_0_11_p1855_lanes - s16 *
      Lambda_0_11_p1867_lanes - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p1799_lanes -
      Lambda_0_11_p1965_lanes;
  const Lanes<8> Lambda_0_11_p1997_lanes = s14 * Lambda_0_11_p1989_lanes + c14 *
      Lambda_0_11_p1957_lanes;
  const Lanes<8> Lambda_0_11_p2005_lanes = 0.226 * Lambda_0_11_p1933_lanes + (-0.18) *
      Lambda_0_11_p1997_lanes;
  const Lanes<8> Lambda_0_11_p2025_lanes = c15 * Lambda_0_11_p1917_lanes - s15 *
      Lambda_0_11_p1907_lanes - inverse_D6_p5_lanes[1] * Lambda_0_11_p1925_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p2033_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p17_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2035_lanes = Lambda_0_11_p2033_lanes[1] * Lambda_0_11_p1925_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p2051_lanes = -(c14 * Lambda_0_11_p2035_lanes + s14 *
      Lambda_0_11_p2025_lanes + Lambda_0_11_p2005_lanes);
  const Lanes<8> Lambda_0_11_p2055_lanes = inverse_D5_p16 * Lambda_0_11_p2051_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2067_lanes = c14 * Lambda_0_11_p1989_lanes - s14 *
      Lambda_0_11_p1957_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p2091_lanes = (-0.18) * Lambda_0_11_p2067_lanes -
      (s14 * Lambda_0_11_p2035_lanes - c14 * Lambda_0_11_p2025_lanes) - Lambda_0_11_p2055_lanes;
  const Lanes<8> Lambda_0_11_p2107_lanes = 0.226 * Lambda_0_11_p2067_lanes - inverse_D5_p22 *
      Lambda_0_11_p2051_lanes;
  const Lanes<8> Lambda_0_11_p2123_lanes = Lambda_0_11_p2067_lanes - Lambda_0_11_p993 *
      Lambda_0_11_p2051_lanes;
  const Lanes<8> Lambda_0_11_p2131_lanes = s6 * Lambda_0_11_p2091_lanes + c6 *
      Lambda_0_11_p2107_lanes + 0.072 * Lambda_0_11_p2123_lanes;
  const Lanes<8> Lambda_0_11_p2143_lanes = Lambda_0_11_p1997_lanes + Lambda_0_11_p930 *
      Lambda_0_11_p2051_lanes;
  const Lanes<8> Lambda_0_11_p2155_lanes = Lambda_0_11_p1933_lanes - Lambda_0_11_p984 *
      Lambda_0_11_p2051_lanes;
  const Lanes<8> Lambda_0_11_p2163_lanes = s6 * Lambda_0_11_p2143_lanes + c6 *
      Lambda_0_11_p2155_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p2175_lanes = -(0.072 * Lambda_0_11_p2163_lanes) + Lambda_0_11_p1020 *
      Lambda_0_11_p2131_lanes;
  const Lanes<8> Lambda_0_11_p2199_lanes = c6 * Lambda_0_11_p2091_lanes - s6 *
      Lambda_0_11_p2107_lanes - Lambda_0_11_p1022 * Lambda_0_11_p2131_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p2211_lanes = -(s5 * Lambda_0_11_p2175_lanes + c5 *
      Lambda_0_11_p2199_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p2235_lanes = Lambda_0_11_p2163_lanes - Lambda_0_11_p1005 *
      Lambda_0_11_p2131_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p2247_lanes = -(s5 * Lambda_0_11_p2199_lanes - c5 *
      Lambda_0_11_p2175_lanes + 0.21799999999999997 * Lambda_0_11_p2235_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p2279_lanes = c6 * Lambda_0_11_p2143_lanes - s6 *
      Lambda_0_11_p2155_lanes - Lambda_0_11_p1033 * Lambda_0_11_p2131_lanes;
  const Lanes<8> Lambda_0_11_p2291_lanes = Lambda_0_11_p2123_lanes - Lambda_0_11_p1029 *
      Lambda_0_11_p2131_lanes;
  const Lanes<8> Lambda_0_11_p2299_lanes = s5 * Lambda_0_11_p2279_lanes - c5 *
      Lambda_0_11_p2291_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p2315_lanes = c4 * (-(0.21799999999999997 * Lambda_0_11_p2299_lanes) +
      inverse_D3_p2 * Lambda_0_11_p2211_lanes);
  const Lanes<8> Lambda_0_11_p2319_lanes = s4 * (Lambda_0_11_p2247_lanes - inverse_D3_p1 *
      Lambda_0_11_p2211_lanes) + Lambda_0_11_p2315_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p2323_lanes = Lambda_0_11_p1063 * Lambda_0_11_p2319_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p2351_lanes = s4 * (Lambda_0_11_p2235_lanes + Lambda_0_11_p1050 *
      Lambda_0_11_p2211_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p2359_lanes = c4 * (-Lambda_0_11_p2299_lanes + Lambda_0_11_p1041 *
      Lambda_0_11_p2211_lanes) - Lambda_0_11_p2351_lanes - Lambda_0_11_p2323_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p2391_lanes = -(s5 * Lambda_0_11_p2291_lanes + c5 *
      Lambda_0_11_p2279_lanes) - Lambda_0_11_p1068 * Lambda_0_11_p2211_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p2399_lanes = -Lambda_0_11_p2391_lanes + Lambda_0_11_p1073 *
      Lambda_0_11_p2319_lanes;
  const Lanes<8> Lambda_0_11_p2407_lanes = c3 * Lambda_0_11_p2359_lanes - s3 *
      Lambda_0_11_p2399_lanes;
  const Lanes<8> Lambda_0_11_p2411_lanes = 0.422 * Lambda_0_11_p2407_lanes;

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p2427 = c3 * Lambda_0_11_p1076 - Lambda_0_11_p1075;
  const Real Lambda_0_11_p2428 = 0.031999971599999996 + 0.422 * Lambda_0_11_p2427;

  // link 2 (thigh), articulated inertia
  const Real Lambda_0_11_p2429 = Lambda_0_11_p2428 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p2450_lanes = s2 * (s3 * Lambda_0_11_p2359_lanes + c3 *
      Lambda_0_11_p2399_lanes - Lambda_0_11_p2429 * Lambda_0_11_p2411_lanes);
  const Lanes<8> Lambda_0_11_p2458_lanes = 0.434 * (c2 *
      (Lambda_0_11_p2407_lanes - Lambda_0_11_p1080 * Lambda_0_11_p2411_lanes) -
      Lambda_0_11_p2450_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = Lambda_0_11_p1078 - Lambda_0_11_p1079 * Lambda_0_11_p1080;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (Lambda_0_11_p1074 + Lambda_0_11_p1077 -
      Lambda_0_11_p2428 * Lambda_0_11_p2429)) + c2 * (2.0 *
      (Lambda_0_11_p2427 - Lambda_0_11_p1079 * Lambda_0_11_p2429));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p2462_lanes = Lambda_0_11_p2458_lanes * inverse_D1;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p2466 = 0.49024375482668536 * Lambda_0_11_p1346_lanes[1];
  const Real Lambda_0_11_p2467 = -(0.086 * Lambda_0_11_p1257) - (-0.004018575007348824) *
      Lambda_0_11_p1346_lanes[1];
  const Real Lambda_0_11_p2468 = s20 * Lambda_0_11_p1651_lanes[1] + c20 * Lambda_0_11_p2467;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p2469 = s20 * Lambda_0_11_p1696_lanes[1] - c20 * Lambda_0_11_p2466 -
      Lambda_0_11_p61_lanes[1] * Lambda_0_11_p2468;
  const Real Lambda_0_11_p2470 = c20 * Lambda_0_11_p1651_lanes[1] - s20 * Lambda_0_11_p2467 -
      inverse_D11_p1_lanes[1] * Lambda_0_11_p2468;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2471 = -(c19 * Lambda_0_11_p2470);
  const Real Lambda_0_11_p2472 = 0.269 * Lambda_0_11_p2469 - s19 * Lambda_0_11_p2470 -
      inverse_D10_p1_lanes[1] * Lambda_0_11_p2471;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p2473 = c20 * Lambda_0_11_p1696_lanes[1] + s20 * Lambda_0_11_p2466 -
      Lambda_0_11_p11_lanes[1] * Lambda_0_11_p2468;
  const Real Lambda_0_11_p2474 = Lambda_0_11_p1257 - Lambda_0_11_p35_lanes[1] * Lambda_0_11_p2468;
  const Real Lambda_0_11_p2475 = s19 * Lambda_0_11_p2473 - c19 * Lambda_0_11_p2474;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2476 = 0.269 * Lambda_0_11_p2475 - inverse_D10_p8_lanes[1] *
      Lambda_0_11_p2471;
  const Real Lambda_0_11_p2477 = s18 * Lambda_0_11_p2472 + c18 * Lambda_0_11_p2476;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2478 = c18 * Lambda_0_11_p2472 - s18 * Lambda_0_11_p2476 -
      Lambda_0_11_p231_lanes[1] * Lambda_0_11_p2477;
  const Real Lambda_0_11_p2479 = Lambda_0_11_p221_lanes[1] * Lambda_0_11_p2477;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2480 = -Lambda_0_11_p2475 + Lambda_0_11_p55_lanes[1] * Lambda_0_11_p2471;
  const Real Lambda_0_11_p2481 = Lambda_0_11_p2469 - Lambda_0_11_p119_lanes[1] * Lambda_0_11_p2471;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2482 = s18 * Lambda_0_11_p2480 + c18 * Lambda_0_11_p2481 -
      Lambda_0_11_p191_lanes[1] * Lambda_0_11_p2477;
  const Real Lambda_0_11_p2483 = c17 * Lambda_0_11_p2479 - s17 * Lambda_0_11_p2478;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2484 = c17 * Lambda_0_11_p2478 + s17 * Lambda_0_11_p2479 + 0.282 *
      Lambda_0_11_p2482 - Lambda_0_11_p259_lanes[1] * Lambda_0_11_p2483;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2485 = c18 * Lambda_0_11_p2480 - s18 * Lambda_0_11_p2481 -
      Lambda_0_11_p317_lanes[1] * Lambda_0_11_p2477;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p2492_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_0_11_p1730_lanes[1], Lambda_0_11_p2474) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_0_11_p1722_lanes[1],
      Lambda_0_11_p2473));

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2494 = -(Lambda_0_11_p2492_lanes[1] - Lambda_0_11_p337_lanes[1] *
      Lambda_0_11_p2471) - Lambda_0_11_p363_lanes[1] * Lambda_0_11_p2477;
  const Real Lambda_0_11_p2495 = s17 * Lambda_0_11_p2494 - c17 * Lambda_0_11_p2485;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2496 = 0.282 * Lambda_0_11_p2495 - Lambda_0_11_p401_lanes[1] *
      Lambda_0_11_p2483;
  const Real Lambda_0_11_p2497 = c16 * Lambda_0_11_p2484 - s16 * Lambda_0_11_p2496;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2498 = Lambda_0_11_p1915_lanes[1] * Lambda_0_11_p2497;
  const Real Lambda_0_11_p2499 = s16 * Lambda_0_11_p2484 + c16 * Lambda_0_11_p2496 -
      inverse_D7_p1_lanes[1] * Lambda_0_11_p2497;
  const Real Lambda_0_11_p2500 = s15 * Lambda_0_11_p2498 + c15 * Lambda_0_11_p2499;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p2501 = 0.49024375482668536 * Lambda_0_11_p1352_lanes[1];
  const Real Lambda_0_11_p2502 = -(0.086 * Lambda_0_11_p1277) - (-0.004018575007348824) *
      Lambda_0_11_p1352_lanes[1];
  const Real Lambda_0_11_p2503 = s20 * Lambda_0_11_p1653_lanes[1] + c20 * Lambda_0_11_p2502;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p2504 = s20 * Lambda_0_11_p1700_lanes[1] - c20 * Lambda_0_11_p2501 -
      Lambda_0_11_p61_lanes[1] * Lambda_0_11_p2503;
  const Real Lambda_0_11_p2505 = c20 * Lambda_0_11_p1653_lanes[1] - s20 * Lambda_0_11_p2502 -
      inverse_D11_p1_lanes[1] * Lambda_0_11_p2503;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2506 = -(c19 * Lambda_0_11_p2505);
  const Real Lambda_0_11_p2507 = 0.269 * Lambda_0_11_p2504 - s19 * Lambda_0_11_p2505 -
      inverse_D10_p1_lanes[1] * Lambda_0_11_p2506;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p2508 = c20 * Lambda_0_11_p1700_lanes[1] + s20 * Lambda_0_11_p2501 -
      Lambda_0_11_p11_lanes[1] * Lambda_0_11_p2503;
  const Real Lambda_0_11_p2509 = Lambda_0_11_p1277 - Lambda_0_11_p35_lanes[1] * Lambda_0_11_p2503;
  const Real Lambda_0_11_p2510 = s19 * Lambda_0_11_p2508 - c19 * Lambda_0_11_p2509;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2511 = 0.269 * Lambda_0_11_p2510 - inverse_D10_p8_lanes[1] *
      Lambda_0_11_p2506;
  const Real Lambda_0_11_p2512 = s18 * Lambda_0_11_p2507 + c18 * Lambda_0_11_p2511;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2513 = c18 * Lambda_0_11_p2507 - s18 * Lambda_0_11_p2511 -
      Lambda_0_11_p231_lanes[1] * Lambda_0_11_p2512;
  const Real Lambda_0_11_p2514 = Lambda_0_11_p221_lanes[1] * Lambda_0_11_p2512;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p2515 = -Lambda_0_11_p2510 + Lambda_0_11_p55_lanes[1] * Lambda_0_11_p2506;
  const Real Lambda_0_11_p2516 = Lambda_0_11_p2504 - Lambda_0_11_p119_lanes[1] * Lambda_0_11_p2506;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2517 = s18 * Lambda_0_11_p2515 + c18 * Lambda_0_11_p2516 -
      Lambda_0_11_p191_lanes[1] * Lambda_0_11_p2512;
  const Real Lambda_0_11_p2518 = c17 * Lambda_0_11_p2514 - s17 * Lambda_0_11_p2513;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2519 = c17 * Lambda_0_11_p2513 + s17 * Lambda_0_11_p2514 + 0.282 *
      Lambda_0_11_p2517 - Lambda_0_11_p259_lanes[1] * Lambda_0_11_p2518;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2520 = c18 * Lambda_0_11_p2515 - s18 * Lambda_0_11_p2516 -
      Lambda_0_11_p317_lanes[1] * Lambda_0_11_p2512;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p2527_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_0_11_p1730_lanes[0], Lambda_0_11_p2509) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_0_11_p1722_lanes[0],
      Lambda_0_11_p2508));

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p2529 = -(Lambda_0_11_p2527_lanes[1] - Lambda_0_11_p337_lanes[1] *
      Lambda_0_11_p2506) - Lambda_0_11_p363_lanes[1] * Lambda_0_11_p2512;
  const Real Lambda_0_11_p2530 = s17 * Lambda_0_11_p2529 - c17 * Lambda_0_11_p2520;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2531 = 0.282 * Lambda_0_11_p2530 - Lambda_0_11_p401_lanes[1] *
      Lambda_0_11_p2518;
  const Real Lambda_0_11_p2532 = c16 * Lambda_0_11_p2519 - s16 * Lambda_0_11_p2531;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2533 = s16 * Lambda_0_11_p2519 + c16 * Lambda_0_11_p2531 -
      inverse_D7_p1_lanes[1] * Lambda_0_11_p2532;
  const Real Lambda_0_11_p2534 = Lambda_0_11_p1915_lanes[1] * Lambda_0_11_p2532;
  const Real Lambda_0_11_p2535 = s15 * Lambda_0_11_p2534 + c15 * Lambda_0_11_p2533;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p2560_lanes = c13 * detail::make_pack<Real>(Lambda_0_11_p1653_lanes[0],
      Lambda_0_11_p1651_lanes[0], Lambda_0_11_p1330_lanes[0], Lambda_0_11_p1648_lanes[3],
      Lambda_0_11_p1648_lanes[4], Lambda_0_11_p1648_lanes[5], Lambda_0_11_p1653_lanes[0],
      Lambda_0_11_p1653_lanes[0]) - s13 * Lambda_0_11_p1670_lanes - inverse_D11_p1_lanes[0] *
      Lambda_0_11_p1682_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p2588_lanes = s13 * detail::make_pack<Real>(Lambda_0_11_p1700_lanes[0],
      Lambda_0_11_p1696_lanes[0], Lambda_0_11_p1700_lanes[0], Lambda_0_11_p1691_lanes[3],
      Lambda_0_11_p1691_lanes[4], Lambda_0_11_p1691_lanes[5], Lambda_0_11_p1700_lanes[0],
      Lambda_0_11_p1700_lanes[0]) - c13 * Lambda_0_11_p1707_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p2593_lanes = detail::make_pack<Real>(Lambda_0_11_p2588_lanes[0],
      Lambda_0_11_p2588_lanes[1], Lambda_0_11_p1421_lanes[0], Lambda_0_11_p2588_lanes[3],
      Lambda_0_11_p2588_lanes[4], Lambda_0_11_p2588_lanes[5], Lambda_0_11_p2588_lanes[0],
      Lambda_0_11_p2588_lanes[0]) - Lambda_0_11_p61_lanes[0] * Lambda_0_11_p1682_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p2617_lanes = -(c12 * Lambda_0_11_p2560_lanes);
  const Lanes<8> Lambda_0_11_p2629_lanes = 0.269 * Lambda_0_11_p2593_lanes - s12 *
      Lambda_0_11_p2560_lanes - inverse_D10_p1_lanes[0] * Lambda_0_11_p2617_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p2641_lanes = Lambda_0_11_p35_lanes[0] * Lambda_0_11_p1682_lanes;
  const Lanes<8> Lambda_0_11_p2650_lanes = Lambda_0_11_p1717_lanes - Lambda_0_11_p11_lanes[0] *
      Lambda_0_11_p1682_lanes;
  const Lanes<8> Lambda_0_11_p2656_lanes = c12 * Lambda_0_11_p2641_lanes + s12 *
      Lambda_0_11_p2650_lanes;
  const Lanes<8> Lambda_0_11_p2665_lanes = s12 * Lambda_0_11_p1722_lanes - c12 *
      Lambda_0_11_p1730_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p2680_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_0_11_p2665_lanes[0], Lambda_0_11_p2665_lanes[1],
      Lambda_0_11_p2665_lanes[2], Lambda_0_11_p2656_lanes[3], Lambda_0_11_p2656_lanes[4],
      Lambda_0_11_p2656_lanes[5], Lambda_0_11_p2665_lanes[0], Lambda_0_11_p2665_lanes[0]) -
      inverse_D10_p8_lanes[0] * Lambda_0_11_p2617_lanes;
  const Lanes<8> Lambda_0_11_p2710_lanes = s11 * Lambda_0_11_p2629_lanes + c11 *
      Lambda_0_11_p2680_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2722_lanes = c11 * Lambda_0_11_p2629_lanes - s11 *
      Lambda_0_11_p2680_lanes - Lambda_0_11_p231_lanes[0] * Lambda_0_11_p2710_lanes;
  const Lanes<8> Lambda_0_11_p2734_lanes = Lambda_0_11_p221_lanes[0] * Lambda_0_11_p2710_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p2770_lanes = -detail::make_pack<Real>(Lambda_0_11_p2665_lanes[0],
      Lambda_0_11_p2665_lanes[1], Lambda_0_11_p2665_lanes[2], Lambda_0_11_p2656_lanes[3],
      Lambda_0_11_p2656_lanes[4], Lambda_0_11_p2656_lanes[5], Lambda_0_11_p2665_lanes[0],
      Lambda_0_11_p2665_lanes[0]) + Lambda_0_11_p55_lanes[0] * Lambda_0_11_p2617_lanes;
  const Lanes<8> Lambda_0_11_p2788_lanes = Lambda_0_11_p2593_lanes - Lambda_0_11_p119_lanes[0] *
      Lambda_0_11_p2617_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2806_lanes = s11 * Lambda_0_11_p2770_lanes + c11 *
      Lambda_0_11_p2788_lanes - Lambda_0_11_p191_lanes[0] * Lambda_0_11_p2710_lanes;
  const Lanes<8> Lambda_0_11_p2836_lanes = c10 * Lambda_0_11_p2734_lanes - s10 *
      Lambda_0_11_p2722_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2842_lanes = Lambda_0_11_p259_lanes[0] * Lambda_0_11_p2836_lanes;
  const Lanes<8> Lambda_0_11_p2848_lanes = c10 * Lambda_0_11_p2722_lanes + s10 *
      Lambda_0_11_p2734_lanes + 0.282 * Lambda_0_11_p2806_lanes - Lambda_0_11_p2842_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p2872_lanes = s12 * Lambda_0_11_p2641_lanes - c12 *
      Lambda_0_11_p2650_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2893_lanes = -(detail::make_pack<Real>(Lambda_0_11_p2527_lanes[0],
      Lambda_0_11_p2492_lanes[0], Lambda_0_11_p1737_lanes[0], Lambda_0_11_p2872_lanes[3],
      Lambda_0_11_p2872_lanes[4], Lambda_0_11_p2872_lanes[5], Lambda_0_11_p2527_lanes[0],
      Lambda_0_11_p2527_lanes[0]) - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p2617_lanes) -
      Lambda_0_11_p363_lanes[0] * Lambda_0_11_p2710_lanes;
  const Lanes<8> Lambda_0_11_p2929_lanes = c11 * Lambda_0_11_p2770_lanes - s11 *
      Lambda_0_11_p2788_lanes - Lambda_0_11_p317_lanes[0] * Lambda_0_11_p2710_lanes;
  const Lanes<8> Lambda_0_11_p2941_lanes = s10 * Lambda_0_11_p2893_lanes - c10 *
      Lambda_0_11_p2929_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2959_lanes = 0.282 * Lambda_0_11_p2941_lanes -
      Lambda_0_11_p401_lanes[0] * Lambda_0_11_p2836_lanes;
  const Lanes<8> Lambda_0_11_p2989_lanes = c9 * Lambda_0_11_p2848_lanes - s9 *
      Lambda_0_11_p2959_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p3001_lanes = s9 * Lambda_0_11_p2848_lanes + c9 *
      Lambda_0_11_p2959_lanes - inverse_D7_p1_lanes[0] * Lambda_0_11_p2989_lanes;
  const Lanes<8> Lambda_0_11_p3013_lanes = Lambda_0_11_p1915_lanes[0] * Lambda_0_11_p2989_lanes;
  const Lanes<8> Lambda_0_11_p3025_lanes = s8 * Lambda_0_11_p3013_lanes + c8 *
      Lambda_0_11_p3001_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3031_lanes = detail::make_pack<Real>(Lambda_0_11_p2033_lanes[0],
      Lambda_0_11_p2033_lanes[0], Lambda_0_11_p2033_lanes[0], Lambda_0_11_p2033_lanes[0],
      Lambda_0_11_p2033_lanes[0], Lambda_0_11_p2033_lanes[0], Lambda_0_11_p2033_lanes[1],
      Lambda_0_11_p2033_lanes[1]) * detail::make_pack<Real>(Lambda_0_11_p3025_lanes[0],
      Lambda_0_11_p3025_lanes[1], Lambda_0_11_p3025_lanes[2], Lambda_0_11_p3025_lanes[3],
      Lambda_0_11_p3025_lanes[4], Lambda_0_11_p3025_lanes[5], Lambda_0_11_p2535, Lambda_0_11_p2500);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p3067_lanes = c8 * Lambda_0_11_p3013_lanes - s8 *
      Lambda_0_11_p3001_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3073_lanes = detail::make_pack<Real>(Lambda_0_11_p3067_lanes[0],
      Lambda_0_11_p3067_lanes[1], Lambda_0_11_p3067_lanes[2], Lambda_0_11_p3067_lanes[3],
      Lambda_0_11_p3067_lanes[4], Lambda_0_11_p3067_lanes[5], c15 * Lambda_0_11_p2534 - s15 *
      Lambda_0_11_p2533, c15 * Lambda_0_11_p2498 - s15 * Lambda_0_11_p2499) -
      detail::make_pack<Real>(inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[1], inverse_D6_p5_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p3025_lanes[0], Lambda_0_11_p3025_lanes[1],
      Lambda_0_11_p3025_lanes[2], Lambda_0_11_p3025_lanes[3], Lambda_0_11_p3025_lanes[4],
      Lambda_0_11_p3025_lanes[5], Lambda_0_11_p2535, Lambda_0_11_p2500);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p3105 = -Lambda_0_11_p2495 + Lambda_0_11_p569_lanes[1] * Lambda_0_11_p2483;
  const Real Lambda_0_11_p3106 = Lambda_0_11_p2482 - Lambda_0_11_p577_lanes[1] * Lambda_0_11_p2483;
  const Real Lambda_0_11_p3107 = -Lambda_0_11_p2530 + Lambda_0_11_p569_lanes[1] * Lambda_0_11_p2518;
  const Real Lambda_0_11_p3108 = Lambda_0_11_p2517 - Lambda_0_11_p577_lanes[1] * Lambda_0_11_p2518;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p3127_lanes = -Lambda_0_11_p2941_lanes + Lambda_0_11_p569_lanes[0] *
      Lambda_0_11_p2836_lanes;
  const Lanes<8> Lambda_0_11_p3145_lanes = Lambda_0_11_p2806_lanes - Lambda_0_11_p577_lanes[0] *
      Lambda_0_11_p2836_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p3163_lanes = c9 * Lambda_0_11_p3127_lanes - s9 *
      Lambda_0_11_p3145_lanes - Lambda_0_11_p657_lanes[0] * Lambda_0_11_p2989_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3169_lanes = detail::make_pack<Real>(Lambda_0_11_p3163_lanes[0],
      Lambda_0_11_p3163_lanes[1], Lambda_0_11_p3163_lanes[2], Lambda_0_11_p3163_lanes[3],
      Lambda_0_11_p3163_lanes[4], Lambda_0_11_p3163_lanes[5], c16 * Lambda_0_11_p3107 - s16 *
      Lambda_0_11_p3108 - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p2532, c16 * Lambda_0_11_p3105 -
      s16 * Lambda_0_11_p3106 - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p2497) -
      detail::make_pack<Real>(Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0],
      Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0],
      Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[1], Lambda_0_11_p679_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p3025_lanes[0], Lambda_0_11_p3025_lanes[1],
      Lambda_0_11_p3025_lanes[2], Lambda_0_11_p3025_lanes[3], Lambda_0_11_p3025_lanes[4],
      Lambda_0_11_p3025_lanes[5], Lambda_0_11_p2535, Lambda_0_11_p2500);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p3193 = -(-(s17 * Lambda_0_11_p2485 + c17 * Lambda_0_11_p2494) +
      Lambda_0_11_p515_lanes[1] * Lambda_0_11_p2483) + Lambda_0_11_p555_lanes[1] *
      Lambda_0_11_p2497;
  const Real Lambda_0_11_p3194 = s16 * Lambda_0_11_p3105 + c16 * Lambda_0_11_p3106 -
      Lambda_0_11_p609_lanes[1] * Lambda_0_11_p2497;
  const Real Lambda_0_11_p3195 = s16 * Lambda_0_11_p3107 + c16 * Lambda_0_11_p3108 -
      Lambda_0_11_p609_lanes[1] * Lambda_0_11_p2532;
  const Real Lambda_0_11_p3196 = -(-(s17 * Lambda_0_11_p2520 + c17 * Lambda_0_11_p2529) +
      Lambda_0_11_p515_lanes[1] * Lambda_0_11_p2518) + Lambda_0_11_p555_lanes[1] *
      Lambda_0_11_p2532;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p3233_lanes = -(s10 * Lambda_0_11_p2929_lanes + c10 *
      Lambda_0_11_p2893_lanes) + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2836_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p3245_lanes = -Lambda_0_11_p3233_lanes + Lambda_0_11_p555_lanes[0] *
      Lambda_0_11_p2989_lanes;
  const Lanes<8> Lambda_0_11_p3281_lanes = s9 * Lambda_0_11_p3127_lanes + c9 *
      Lambda_0_11_p3145_lanes - Lambda_0_11_p609_lanes[0] * Lambda_0_11_p2989_lanes;
  const Lanes<8> Lambda_0_11_p3293_lanes = c8 * Lambda_0_11_p3245_lanes - s8 *
      Lambda_0_11_p3281_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3299_lanes = detail::make_pack<Real>(Lambda_0_11_p3293_lanes[0],
      Lambda_0_11_p3293_lanes[1], Lambda_0_11_p3293_lanes[2], Lambda_0_11_p3293_lanes[3],
      Lambda_0_11_p3293_lanes[4], Lambda_0_11_p3293_lanes[5], c15 * Lambda_0_11_p3196 - s15 *
      Lambda_0_11_p3195, c15 * Lambda_0_11_p3193 - s15 * Lambda_0_11_p3194) -
      detail::make_pack<Real>(Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0],
      Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0],
      Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[1], Lambda_0_11_p639_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p3025_lanes[0], Lambda_0_11_p3025_lanes[1],
      Lambda_0_11_p3025_lanes[2], Lambda_0_11_p3025_lanes[3], Lambda_0_11_p3025_lanes[4],
      Lambda_0_11_p3025_lanes[5], Lambda_0_11_p2535, Lambda_0_11_p2500);
  const Lanes<8> Lambda_0_11_p3315_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_0_11_p3169_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_0_11_p3299_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p3351_lanes = s8 * Lambda_0_11_p3245_lanes + c8 *
      Lambda_0_11_p3281_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3357_lanes = detail::make_pack<Real>(Lambda_0_11_p3351_lanes[0],
      Lambda_0_11_p3351_lanes[1], Lambda_0_11_p3351_lanes[2], Lambda_0_11_p3351_lanes[3],
      Lambda_0_11_p3351_lanes[4], Lambda_0_11_p3351_lanes[5], s15 * Lambda_0_11_p3196 + c15 *
      Lambda_0_11_p3195, s15 * Lambda_0_11_p3193 + c15 * Lambda_0_11_p3194) -
      detail::make_pack<Real>(Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0],
      Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0],
      Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[1], Lambda_0_11_p837_lanes[1]) *
      detail::make_pack<Real>(Lambda_0_11_p3025_lanes[0], Lambda_0_11_p3025_lanes[1],
      Lambda_0_11_p3025_lanes[2], Lambda_0_11_p3025_lanes[3], Lambda_0_11_p3025_lanes[4],
      Lambda_0_11_p3025_lanes[5], Lambda_0_11_p2535, Lambda_0_11_p2500);
  const Lanes<8> Lambda_0_11_p3373_lanes = 0.226 * Lambda_0_11_p3357_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_0_11_p3315_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3389_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_0_11_p3031_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_0_11_p3073_lanes + Lambda_0_11_p3373_lanes);
  const Lanes<8> Lambda_0_11_p3397_lanes = inverse_D5_p16 * Lambda_0_11_p3389_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3421_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_0_11_p3169_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_0_11_p3299_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3469_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_0_11_p3421_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_0_11_p3031_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_0_11_p3073_lanes) -
      Lambda_0_11_p3397_lanes;
  const Lanes<8> Lambda_0_11_p3501_lanes = 0.226 * Lambda_0_11_p3421_lanes - inverse_D5_p22 *
      Lambda_0_11_p3389_lanes;
  const Lanes<8> Lambda_0_11_p3533_lanes = Lambda_0_11_p3421_lanes - Lambda_0_11_p993 *
      Lambda_0_11_p3389_lanes;
  const Lanes<8> Lambda_0_11_p3549_lanes = s6 * Lambda_0_11_p3469_lanes + c6 *
      Lambda_0_11_p3501_lanes + 0.072 * Lambda_0_11_p3533_lanes;
  const Lanes<8> Lambda_0_11_p3573_lanes = Lambda_0_11_p3315_lanes + Lambda_0_11_p930 *
      Lambda_0_11_p3389_lanes;
  const Lanes<8> Lambda_0_11_p3597_lanes = Lambda_0_11_p3357_lanes - Lambda_0_11_p984 *
      Lambda_0_11_p3389_lanes;
  const Lanes<8> Lambda_0_11_p3613_lanes = s6 * Lambda_0_11_p3573_lanes + c6 *
      Lambda_0_11_p3597_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3637_lanes = -(0.072 * Lambda_0_11_p3613_lanes) + Lambda_0_11_p1020 *
      Lambda_0_11_p3549_lanes;
  const Lanes<8> Lambda_0_11_p3685_lanes = c6 * Lambda_0_11_p3469_lanes - s6 *
      Lambda_0_11_p3501_lanes - Lambda_0_11_p1022 * Lambda_0_11_p3549_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3709_lanes = -(s5 * Lambda_0_11_p3637_lanes + c5 *
      Lambda_0_11_p3685_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3757_lanes = Lambda_0_11_p3613_lanes - Lambda_0_11_p1005 *
      Lambda_0_11_p3549_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3781_lanes = -(s5 * Lambda_0_11_p3685_lanes - c5 *
      Lambda_0_11_p3637_lanes + 0.21799999999999997 * Lambda_0_11_p3757_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3845_lanes = c6 * Lambda_0_11_p3573_lanes - s6 *
      Lambda_0_11_p3597_lanes - Lambda_0_11_p1033 * Lambda_0_11_p3549_lanes;
  const Lanes<8> Lambda_0_11_p3869_lanes = Lambda_0_11_p3533_lanes - Lambda_0_11_p1029 *
      Lambda_0_11_p3549_lanes;
  const Lanes<8> Lambda_0_11_p3885_lanes = s5 * Lambda_0_11_p3845_lanes - c5 *
      Lambda_0_11_p3869_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3917_lanes = c4 * (-(0.21799999999999997 * Lambda_0_11_p3885_lanes) +
      inverse_D3_p2 * Lambda_0_11_p3709_lanes);
  const Lanes<8> Lambda_0_11_p3925_lanes = s4 * (Lambda_0_11_p3781_lanes - inverse_D3_p1 *
      Lambda_0_11_p3709_lanes) + Lambda_0_11_p3917_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3933_lanes = Lambda_0_11_p1063 * Lambda_0_11_p3925_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3989_lanes = s4 * (Lambda_0_11_p3757_lanes + Lambda_0_11_p1050 *
      Lambda_0_11_p3709_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4005_lanes = c4 * (-Lambda_0_11_p3885_lanes + Lambda_0_11_p1041 *
      Lambda_0_11_p3709_lanes) - Lambda_0_11_p3989_lanes - Lambda_0_11_p3933_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4069_lanes = -(s5 * Lambda_0_11_p3869_lanes + c5 *
      Lambda_0_11_p3845_lanes) - Lambda_0_11_p1068 * Lambda_0_11_p3709_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4085_lanes = -Lambda_0_11_p4069_lanes + Lambda_0_11_p1073 *
      Lambda_0_11_p3925_lanes;
  const Lanes<8> Lambda_0_11_p4101_lanes = c3 * Lambda_0_11_p4005_lanes - s3 *
      Lambda_0_11_p4085_lanes;
  const Lanes<8> Lambda_0_11_p4109_lanes = 0.422 * Lambda_0_11_p4101_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4181_lanes = s2 * (s3 * Lambda_0_11_p4005_lanes + c3 *
      Lambda_0_11_p4085_lanes - Lambda_0_11_p2429 * Lambda_0_11_p4109_lanes);
  const Lanes<8> Lambda_0_11_p4197_lanes = 0.434 * (c2 *
      (Lambda_0_11_p4101_lanes - Lambda_0_11_p1080 * Lambda_0_11_p4109_lanes) -
      Lambda_0_11_p4181_lanes);
  const Lanes<8> Lambda_0_11_p4209_lanes = Lambda_0_11_p2411_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4217_lanes = Lambda_0_11_p2319_lanes * inverse_D3;
  const Lanes<8> Lambda_0_11_p4221_lanes = Lambda_0_11_p4217_lanes * Lambda_0_11_p3925_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4225_lanes = Lambda_0_11_p2211_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4233_lanes = Lambda_0_11_p2131_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4241_lanes = Lambda_0_11_p2051_lanes * inverse_D6;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4257_lanes = Lambda_0_11_p4241_lanes * Lambda_0_11_p3389_lanes[0] +
      Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[0] + Lambda_0_11_p4225_lanes *
      Lambda_0_11_p3709_lanes[0] + Lambda_0_11_p4221_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4265_lanes = Lambda_0_11_p4257_lanes + Lambda_0_11_p4209_lanes *
      Lambda_0_11_p4109_lanes[0] + Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[0];
  const Lanes<8> Lambda_0_11_p4269_lanes = Lambda_0_11_p4197_lanes * inverse_D1;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4285_lanes = Lambda_0_11_p4109_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4301_lanes = Lambda_0_11_p3925_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4317_lanes = Lambda_0_11_p3709_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4333_lanes = Lambda_0_11_p3549_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p4349 = Lambda_0_11_p3389_lanes[7] * inverse_D6;
  const Real Lambda_0_11_p4350 = Lambda_0_11_p3389_lanes[6] * inverse_D6;
  const Lanes<8> Lambda_0_11_p4351_lanes = Lambda_0_11_p3389_lanes * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4363_lanes = Lambda_0_11_p3025_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4375_lanes = Lambda_0_11_p2989_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4387_lanes = Lambda_0_11_p2836_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4399_lanes = Lambda_0_11_p2710_lanes * inverse_D10_lanes[0];
  const Lanes<8> Lambda_0_11_p4405_lanes = Lambda_0_11_p4399_lanes * Lambda_0_11_p2710_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4411_lanes = Lambda_0_11_p2617_lanes * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4423_lanes = Lambda_0_11_p1682_lanes * inverse_D12_lanes[0];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_0_11_p4435_lanes = 0.086 * Lambda_0_11_p1352_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p4437_lanes = detail::make_pack<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_pack<Real>(Lambda_0_11_p1352_lanes[0],
      Lambda_0_11_p1346_lanes[0], Lambda_0_11_p1328_lanes[0], Lambda_0_11_p1642_lanes[0],
      Lambda_0_11_p1642_lanes[1], Lambda_0_11_p1642_lanes[2], Lambda_0_11_p1352_lanes[0],
      Lambda_0_11_p1352_lanes[0]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4461_lanes = Lambda_0_11_p4437_lanes * Lambda_0_11_p4435_lanes[0] +
      Lambda_0_11_p4423_lanes * Lambda_0_11_p1682_lanes[0] + Lambda_0_11_p4411_lanes *
      Lambda_0_11_p2617_lanes[0] + Lambda_0_11_p4405_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4479_lanes = Lambda_0_11_p4461_lanes + Lambda_0_11_p4387_lanes *
      Lambda_0_11_p2836_lanes[0] + Lambda_0_11_p4375_lanes * Lambda_0_11_p2989_lanes[0] +
      Lambda_0_11_p4363_lanes * Lambda_0_11_p3025_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4485_lanes = Lambda_0_11_p4479_lanes + Lambda_0_11_p4351_lanes *
      Lambda_0_11_p3389_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4507_lanes = detail::make_pack<Real>(Lambda_0_11_p4485_lanes[0],
      Lambda_0_11_p4485_lanes[1], Lambda_0_11_p4485_lanes[2], Lambda_0_11_p4485_lanes[3],
      Lambda_0_11_p4485_lanes[4], Lambda_0_11_p4485_lanes[5], Lambda_0_11_p4350 *
      Lambda_0_11_p3389_lanes[0], Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[0]) +
      Lambda_0_11_p4333_lanes * Lambda_0_11_p3549_lanes[0] + Lambda_0_11_p4317_lanes *
      Lambda_0_11_p3709_lanes[0] + Lambda_0_11_p4301_lanes * Lambda_0_11_p3925_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4523_lanes = Lambda_0_11_p4507_lanes + Lambda_0_11_p4285_lanes *
      Lambda_0_11_p4109_lanes[0] + Lambda_0_11_p4269_lanes * Lambda_0_11_p4197_lanes[0];
  const Real Lambda_0_11_p4531 = 1.0 / Lambda_0_11_p4523_lanes[0];
  const Lanes<8> Lambda_0_11_p4532_lanes = Lambda_0_11_p4265_lanes * Lambda_0_11_p4531;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4548_lanes = Lambda_0_11_p4217_lanes * Lambda_0_11_p3925_lanes[1];
  const Lanes<8> Lambda_0_11_p4572_lanes = Lambda_0_11_p4241_lanes * Lambda_0_11_p3389_lanes[1] +
      Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[1] + Lambda_0_11_p4225_lanes *
      Lambda_0_11_p3709_lanes[1] + Lambda_0_11_p4548_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4584_lanes = Lambda_0_11_p4572_lanes + Lambda_0_11_p4209_lanes *
      Lambda_0_11_p4109_lanes[1] + Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[1] -
      Lambda_0_11_p4532_lanes * Lambda_0_11_p4523_lanes[1];
  const Lanes<8> Lambda_0_11_p4588_lanes = Lambda_0_11_p4523_lanes * Lambda_0_11_p4531;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4657_lanes = Lambda_0_11_p4399_lanes * Lambda_0_11_p2710_lanes[1];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_0_11_p4672_lanes = 0.086 * Lambda_0_11_p1346_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4689_lanes = Lambda_0_11_p4437_lanes * Lambda_0_11_p4672_lanes[0] +
      Lambda_0_11_p4423_lanes * Lambda_0_11_p1682_lanes[1] + Lambda_0_11_p4411_lanes *
      Lambda_0_11_p2617_lanes[1] + Lambda_0_11_p4657_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4704_lanes = Lambda_0_11_p4689_lanes + Lambda_0_11_p4387_lanes *
      Lambda_0_11_p2836_lanes[1] + Lambda_0_11_p4375_lanes * Lambda_0_11_p2989_lanes[1] +
      Lambda_0_11_p4363_lanes * Lambda_0_11_p3025_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4709_lanes = Lambda_0_11_p4704_lanes + Lambda_0_11_p4351_lanes *
      Lambda_0_11_p3389_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4728_lanes = detail::make_pack<Real>(Lambda_0_11_p4709_lanes[1],
      Lambda_0_11_p4709_lanes[1], Lambda_0_11_p4709_lanes[2], Lambda_0_11_p4709_lanes[3],
      Lambda_0_11_p4709_lanes[4], Lambda_0_11_p4709_lanes[5], Lambda_0_11_p4350 *
      Lambda_0_11_p3389_lanes[1], Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[1]) +
      Lambda_0_11_p4333_lanes * Lambda_0_11_p3549_lanes[1] + Lambda_0_11_p4317_lanes *
      Lambda_0_11_p3709_lanes[1] + Lambda_0_11_p4301_lanes * Lambda_0_11_p3925_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4749_lanes = Lambda_0_11_p4728_lanes + Lambda_0_11_p4285_lanes *
      Lambda_0_11_p4109_lanes[1] + Lambda_0_11_p4269_lanes * Lambda_0_11_p4197_lanes[1] -
      Lambda_0_11_p4588_lanes * Lambda_0_11_p4523_lanes[1];
  const Real Lambda_0_11_p4756 = 1.0 / Lambda_0_11_p4749_lanes[1];
  const Lanes<8> Lambda_0_11_p4757_lanes = Lambda_0_11_p4584_lanes * Lambda_0_11_p4756;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4777_lanes = Lambda_0_11_p4217_lanes * Lambda_0_11_p3925_lanes[2];
  const Lanes<8> Lambda_0_11_p4801_lanes = Lambda_0_11_p4241_lanes * Lambda_0_11_p3389_lanes[2] +
      Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[2] + Lambda_0_11_p4225_lanes *
      Lambda_0_11_p3709_lanes[2] + Lambda_0_11_p4777_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4813_lanes = Lambda_0_11_p4801_lanes + Lambda_0_11_p4209_lanes *
      Lambda_0_11_p4109_lanes[2] + Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[2] -
      Lambda_0_11_p4532_lanes * Lambda_0_11_p4523_lanes[2];
  const Lanes<8> Lambda_0_11_p4817_lanes = Lambda_0_11_p4813_lanes - Lambda_0_11_p4757_lanes *
      Lambda_0_11_p4749_lanes[2];
  const Lanes<8> Lambda_0_11_p4821_lanes = Lambda_0_11_p4749_lanes * Lambda_0_11_p4756;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4885_lanes = Lambda_0_11_p4399_lanes * Lambda_0_11_p2710_lanes[2];
  const Lanes<8> Lambda_0_11_p4909_lanes = Lambda_0_11_p4437_lanes * Lambda_0_11_p1328_lanes[0] +
      Lambda_0_11_p4423_lanes * Lambda_0_11_p1682_lanes[2] + Lambda_0_11_p4411_lanes *
      Lambda_0_11_p2617_lanes[2] + Lambda_0_11_p4885_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4921_lanes = Lambda_0_11_p4909_lanes + Lambda_0_11_p4387_lanes *
      Lambda_0_11_p2836_lanes[2] + Lambda_0_11_p4375_lanes * Lambda_0_11_p2989_lanes[2] +
      Lambda_0_11_p4363_lanes * Lambda_0_11_p3025_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4925_lanes = Lambda_0_11_p4921_lanes + Lambda_0_11_p4351_lanes *
      Lambda_0_11_p3389_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4941_lanes = detail::make_pack<Real>(Lambda_0_11_p4925_lanes[2],
      Lambda_0_11_p4925_lanes[2], Lambda_0_11_p4925_lanes[2], Lambda_0_11_p4925_lanes[3],
      Lambda_0_11_p4925_lanes[4], Lambda_0_11_p4925_lanes[5], Lambda_0_11_p4350 *
      Lambda_0_11_p3389_lanes[2], Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[2]) +
      Lambda_0_11_p4333_lanes * Lambda_0_11_p3549_lanes[2] + Lambda_0_11_p4317_lanes *
      Lambda_0_11_p3709_lanes[2] + Lambda_0_11_p4301_lanes * Lambda_0_11_p3925_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4959_lanes = Lambda_0_11_p4941_lanes + Lambda_0_11_p4285_lanes *
      Lambda_0_11_p4109_lanes[2] + Lambda_0_11_p4269_lanes * Lambda_0_11_p4197_lanes[2] -
      Lambda_0_11_p4588_lanes * Lambda_0_11_p4523_lanes[2];
  const Lanes<8> Lambda_0_11_p4965_lanes = Lambda_0_11_p4959_lanes - Lambda_0_11_p4821_lanes *
      Lambda_0_11_p4749_lanes[2];
  const Real Lambda_0_11_p4971 = 1.0 / Lambda_0_11_p4965_lanes[2];
  const Lanes<8> Lambda_0_11_p4972_lanes = Lambda_0_11_p4817_lanes * Lambda_0_11_p4971;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4996_lanes = Lambda_0_11_p4217_lanes * Lambda_0_11_p3925_lanes[3];
  const Lanes<8> Lambda_0_11_p5020_lanes = Lambda_0_11_p4241_lanes * Lambda_0_11_p3389_lanes[3] +
      Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[3] + Lambda_0_11_p4225_lanes *
      Lambda_0_11_p3709_lanes[3] + Lambda_0_11_p4996_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5032_lanes = Lambda_0_11_p5020_lanes + Lambda_0_11_p4209_lanes *
      Lambda_0_11_p4109_lanes[3] + Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[3] -
      Lambda_0_11_p4532_lanes * Lambda_0_11_p4523_lanes[3];
  const Lanes<8> Lambda_0_11_p5040_lanes = Lambda_0_11_p5032_lanes - Lambda_0_11_p4757_lanes *
      Lambda_0_11_p4749_lanes[3] - Lambda_0_11_p4972_lanes * Lambda_0_11_p4965_lanes[3];
  const Lanes<8> Lambda_0_11_p5044_lanes = Lambda_0_11_p4965_lanes * Lambda_0_11_p4971;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5101_lanes = Lambda_0_11_p4399_lanes * Lambda_0_11_p2710_lanes[3];
  const Lanes<8> Lambda_0_11_p5119_lanes = Lambda_0_11_p4437_lanes * Lambda_0_11_p1642_lanes[0] +
      Lambda_0_11_p4423_lanes * Lambda_0_11_p1682_lanes[3] + Lambda_0_11_p4411_lanes *
      Lambda_0_11_p2617_lanes[3] + Lambda_0_11_p5101_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5128_lanes = Lambda_0_11_p5119_lanes + Lambda_0_11_p4387_lanes *
      Lambda_0_11_p2836_lanes[3] + Lambda_0_11_p4375_lanes * Lambda_0_11_p2989_lanes[3] +
      Lambda_0_11_p4363_lanes * Lambda_0_11_p3025_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5131_lanes = Lambda_0_11_p5128_lanes + Lambda_0_11_p4351_lanes *
      Lambda_0_11_p3389_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5144_lanes = detail::make_pack<Real>(Lambda_0_11_p5131_lanes[3],
      Lambda_0_11_p5131_lanes[3], Lambda_0_11_p5131_lanes[3], Lambda_0_11_p5131_lanes[3],
      Lambda_0_11_p5131_lanes[4], Lambda_0_11_p5131_lanes[5], Lambda_0_11_p4350 *
      Lambda_0_11_p3389_lanes[3], Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[3]) +
      Lambda_0_11_p4333_lanes * Lambda_0_11_p3549_lanes[3] + Lambda_0_11_p4317_lanes *
      Lambda_0_11_p3709_lanes[3] + Lambda_0_11_p4301_lanes * Lambda_0_11_p3925_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5159_lanes = Lambda_0_11_p5144_lanes + Lambda_0_11_p4285_lanes *
      Lambda_0_11_p4109_lanes[3] + Lambda_0_11_p4269_lanes * Lambda_0_11_p4197_lanes[3] -
      Lambda_0_11_p4588_lanes * Lambda_0_11_p4523_lanes[3];
  const Lanes<8> Lambda_0_11_p5169_lanes = Lambda_0_11_p5159_lanes - Lambda_0_11_p4821_lanes *
      Lambda_0_11_p4749_lanes[3] - Lambda_0_11_p5044_lanes * Lambda_0_11_p4965_lanes[3];
  const Real Lambda_0_11_p5174 = 1.0 / Lambda_0_11_p5169_lanes[3];
  const Lanes<8> Lambda_0_11_p5175_lanes = Lambda_0_11_p5040_lanes * Lambda_0_11_p5174;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5203_lanes = Lambda_0_11_p4217_lanes * Lambda_0_11_p3925_lanes[4];
  const Lanes<8> Lambda_0_11_p5227_lanes = Lambda_0_11_p4241_lanes * Lambda_0_11_p3389_lanes[4] +
      Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[4] + Lambda_0_11_p4225_lanes *
      Lambda_0_11_p3709_lanes[4] + Lambda_0_11_p5203_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5239_lanes = Lambda_0_11_p5227_lanes + Lambda_0_11_p4209_lanes *
      Lambda_0_11_p4109_lanes[4] + Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[4] -
      Lambda_0_11_p4532_lanes * Lambda_0_11_p4523_lanes[4];
  const Lanes<8> Lambda_0_11_p5251_lanes = Lambda_0_11_p5239_lanes - Lambda_0_11_p4757_lanes *
      Lambda_0_11_p4749_lanes[4] - Lambda_0_11_p4972_lanes * Lambda_0_11_p4965_lanes[4] -
      Lambda_0_11_p5175_lanes * Lambda_0_11_p5169_lanes[4];
  const Lanes<8> Lambda_0_11_p5255_lanes = Lambda_0_11_p5169_lanes * Lambda_0_11_p5174;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5305_lanes = Lambda_0_11_p4437_lanes * Lambda_0_11_p1642_lanes[1] +
      detail::make_pack<Real>(Lambda_0_11_p4423_lanes[4] * Lambda_0_11_p1682_lanes[4],
      Lambda_0_11_p4423_lanes[4] * Lambda_0_11_p1682_lanes[4], Lambda_0_11_p4423_lanes[4] *
      Lambda_0_11_p1682_lanes[4], Lambda_0_11_p4423_lanes[4] * Lambda_0_11_p1682_lanes[4],
      Lambda_0_11_p4423_lanes[4] * Lambda_0_11_p1682_lanes[4], Lambda_0_11_p4423_lanes[5] *
      Lambda_0_11_p1682_lanes[4], Lambda_0_11_p4423_lanes[4] * Lambda_0_11_p1682_lanes[4],
      Lambda_0_11_p4423_lanes[4] * Lambda_0_11_p1682_lanes[4]) +
      detail::make_pack<Real>(Lambda_0_11_p4411_lanes[4] * Lambda_0_11_p2617_lanes[4],
      Lambda_0_11_p4411_lanes[4] * Lambda_0_11_p2617_lanes[4], Lambda_0_11_p4411_lanes[4] *
      Lambda_0_11_p2617_lanes[4], Lambda_0_11_p4411_lanes[4] * Lambda_0_11_p2617_lanes[4],
      Lambda_0_11_p4411_lanes[4] * Lambda_0_11_p2617_lanes[4], Lambda_0_11_p4411_lanes[5] *
      Lambda_0_11_p2617_lanes[4], Lambda_0_11_p4411_lanes[4] * Lambda_0_11_p2617_lanes[4],
      Lambda_0_11_p4411_lanes[4] * Lambda_0_11_p2617_lanes[4]) +
      detail::make_pack<Real>(Lambda_0_11_p4399_lanes[4] * Lambda_0_11_p2710_lanes[4],
      Lambda_0_11_p4399_lanes[4] * Lambda_0_11_p2710_lanes[4], Lambda_0_11_p4399_lanes[4] *
      Lambda_0_11_p2710_lanes[4], Lambda_0_11_p4399_lanes[4] * Lambda_0_11_p2710_lanes[4],
      Lambda_0_11_p4399_lanes[4] * Lambda_0_11_p2710_lanes[4], Lambda_0_11_p4399_lanes[5] *
      Lambda_0_11_p2710_lanes[4], Lambda_0_11_p4399_lanes[4] * Lambda_0_11_p2710_lanes[4],
      Lambda_0_11_p4399_lanes[4] * Lambda_0_11_p2710_lanes[4]) +
      detail::make_pack<Real>(Lambda_0_11_p4387_lanes[4] * Lambda_0_11_p2836_lanes[4],
      Lambda_0_11_p4387_lanes[4] * Lambda_0_11_p2836_lanes[4], Lambda_0_11_p4387_lanes[4] *
      Lambda_0_11_p2836_lanes[4], Lambda_0_11_p4387_lanes[4] * Lambda_0_11_p2836_lanes[4],
      Lambda_0_11_p4387_lanes[4] * Lambda_0_11_p2836_lanes[4], Lambda_0_11_p4387_lanes[5] *
      Lambda_0_11_p2836_lanes[4], Lambda_0_11_p4387_lanes[4] * Lambda_0_11_p2836_lanes[4],
      Lambda_0_11_p4387_lanes[4] * Lambda_0_11_p2836_lanes[4]) +
      detail::make_pack<Real>(Lambda_0_11_p4375_lanes[4] * Lambda_0_11_p2989_lanes[4],
      Lambda_0_11_p4375_lanes[4] * Lambda_0_11_p2989_lanes[4], Lambda_0_11_p4375_lanes[4] *
      Lambda_0_11_p2989_lanes[4], Lambda_0_11_p4375_lanes[4] * Lambda_0_11_p2989_lanes[4],
      Lambda_0_11_p4375_lanes[4] * Lambda_0_11_p2989_lanes[4], Lambda_0_11_p4375_lanes[5] *
      Lambda_0_11_p2989_lanes[4], Lambda_0_11_p4375_lanes[4] * Lambda_0_11_p2989_lanes[4],
      Lambda_0_11_p4375_lanes[4] * Lambda_0_11_p2989_lanes[4]);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5309_lanes = Lambda_0_11_p5305_lanes +
      detail::make_pack<Real>(Lambda_0_11_p4363_lanes[4] * Lambda_0_11_p3025_lanes[4],
      Lambda_0_11_p4363_lanes[4] * Lambda_0_11_p3025_lanes[4], Lambda_0_11_p4363_lanes[4] *
      Lambda_0_11_p3025_lanes[4], Lambda_0_11_p4363_lanes[4] * Lambda_0_11_p3025_lanes[4],
      Lambda_0_11_p4363_lanes[4] * Lambda_0_11_p3025_lanes[4], Lambda_0_11_p4363_lanes[5] *
      Lambda_0_11_p3025_lanes[4], Lambda_0_11_p4363_lanes[4] * Lambda_0_11_p3025_lanes[4],
      Lambda_0_11_p4363_lanes[4] * Lambda_0_11_p3025_lanes[4]) +
      detail::make_pack<Real>(Lambda_0_11_p4351_lanes[4] * Lambda_0_11_p3389_lanes[4],
      Lambda_0_11_p4351_lanes[4] * Lambda_0_11_p3389_lanes[4], Lambda_0_11_p4351_lanes[4] *
      Lambda_0_11_p3389_lanes[4], Lambda_0_11_p4351_lanes[4] * Lambda_0_11_p3389_lanes[4],
      Lambda_0_11_p4351_lanes[4] * Lambda_0_11_p3389_lanes[4], Lambda_0_11_p4351_lanes[5] *
      Lambda_0_11_p3389_lanes[4], Lambda_0_11_p4351_lanes[4] * Lambda_0_11_p3389_lanes[4],
      Lambda_0_11_p4351_lanes[4] * Lambda_0_11_p3389_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5319_lanes = detail::make_pack<Real>(Lambda_0_11_p5309_lanes[4],
      Lambda_0_11_p5309_lanes[4], Lambda_0_11_p5309_lanes[4], Lambda_0_11_p5309_lanes[4],
      Lambda_0_11_p5309_lanes[4], Lambda_0_11_p5309_lanes[5], Lambda_0_11_p4350 *
      Lambda_0_11_p3389_lanes[4], Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[4]) +
      Lambda_0_11_p4333_lanes * Lambda_0_11_p3549_lanes[4] + Lambda_0_11_p4317_lanes *
      Lambda_0_11_p3709_lanes[4] + Lambda_0_11_p4301_lanes * Lambda_0_11_p3925_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5331_lanes = Lambda_0_11_p5319_lanes + Lambda_0_11_p4285_lanes *
      Lambda_0_11_p4109_lanes[4] + Lambda_0_11_p4269_lanes * Lambda_0_11_p4197_lanes[4] -
      Lambda_0_11_p4588_lanes * Lambda_0_11_p4523_lanes[4];
  const Lanes<8> Lambda_0_11_p5343_lanes = Lambda_0_11_p5331_lanes - Lambda_0_11_p4821_lanes *
      Lambda_0_11_p4749_lanes[4] - Lambda_0_11_p5044_lanes * Lambda_0_11_p4965_lanes[4] -
      Lambda_0_11_p5255_lanes * Lambda_0_11_p5169_lanes[4];
  const Real Lambda_0_11_p5347 = 1.0 / Lambda_0_11_p5343_lanes[4];
  const Lanes<8> Lambda_0_11_p5348_lanes = Lambda_0_11_p5251_lanes * Lambda_0_11_p5347;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5380_lanes = Lambda_0_11_p4217_lanes * Lambda_0_11_p3925_lanes[5];
  const Lanes<8> Lambda_0_11_p5404_lanes = Lambda_0_11_p4241_lanes * Lambda_0_11_p3389_lanes[5] +
      Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[5] + Lambda_0_11_p4225_lanes *
      Lambda_0_11_p3709_lanes[5] + Lambda_0_11_p5380_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5416_lanes = Lambda_0_11_p5404_lanes + Lambda_0_11_p4209_lanes *
      Lambda_0_11_p4109_lanes[5] + Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[5] -
      Lambda_0_11_p4532_lanes * Lambda_0_11_p4523_lanes[5];
  const Lanes<8> Lambda_0_11_p5428_lanes = Lambda_0_11_p5416_lanes - Lambda_0_11_p4757_lanes *
      Lambda_0_11_p4749_lanes[5] - Lambda_0_11_p4972_lanes * Lambda_0_11_p4965_lanes[5] -
      Lambda_0_11_p5175_lanes * Lambda_0_11_p5169_lanes[5];
  const Lanes<8> Lambda_0_11_p5432_lanes = Lambda_0_11_p5428_lanes - Lambda_0_11_p5348_lanes *
      Lambda_0_11_p5343_lanes[5];
  const Lanes<8> Lambda_0_11_p5436_lanes = Lambda_0_11_p5343_lanes * Lambda_0_11_p5347;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5469_lanes = Lambda_0_11_p1925_lanes * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5473_lanes = Lambda_0_11_p1799_lanes * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5477_lanes = Lambda_0_11_p1603_lanes * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5481_lanes = Lambda_0_11_p1519_lanes * inverse_D10_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p5484_lanes = detail::make_pack<Real>(Lambda_0_11_p4399_lanes[5],
      Lambda_0_11_p5481_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p2710_lanes[5],
      Lambda_0_11_p1519_lanes[3]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5485_lanes = Lambda_0_11_p1439_lanes * inverse_D11_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5489_lanes = Lambda_0_11_p1374_lanes * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5493_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_0_11_p1328_lanes[1], Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1328_lanes[1], Lambda_0_11_p1328_lanes[1],
      Lambda_0_11_p1328_lanes[1], Lambda_0_11_p1328_lanes[1]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p5499_lanes = detail::make_pack<Real>(Lambda_0_11_p4437_lanes[5],
      Lambda_0_11_p5493_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1642_lanes[2],
      Lambda_0_11_p1237) + detail::make_pack<Real>(Lambda_0_11_p4423_lanes[5],
      Lambda_0_11_p5489_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p1682_lanes[5],
      Lambda_0_11_p1374_lanes[3]) + detail::make_pack<Real>(Lambda_0_11_p4411_lanes[5],
      Lambda_0_11_p5485_lanes[3]) * detail::make_pack<Real>(Lambda_0_11_p2617_lanes[5],
      Lambda_0_11_p1439_lanes[3]) + Lambda_0_11_p5484_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p5502_lanes = Lambda_0_11_p5499_lanes +
      detail::make_pack<Real>(Lambda_0_11_p4387_lanes[5], Lambda_0_11_p5477_lanes[3]) *
      detail::make_pack<Real>(Lambda_0_11_p2836_lanes[5], Lambda_0_11_p1603_lanes[3]) +
      detail::make_pack<Real>(Lambda_0_11_p4375_lanes[5], Lambda_0_11_p5473_lanes[3]) *
      detail::make_pack<Real>(Lambda_0_11_p2989_lanes[5], Lambda_0_11_p1799_lanes[3]) +
      detail::make_pack<Real>(Lambda_0_11_p4363_lanes[5], Lambda_0_11_p5469_lanes[3]) *
      detail::make_pack<Real>(Lambda_0_11_p3025_lanes[5], Lambda_0_11_p1925_lanes[3]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5509_lanes = detail::make_pack<Real>(Lambda_0_11_p5502_lanes[0] +
      Lambda_0_11_p4351_lanes[5] * Lambda_0_11_p3389_lanes[5], Lambda_0_11_p5502_lanes[0] +
      Lambda_0_11_p4351_lanes[5] * Lambda_0_11_p3389_lanes[5], Lambda_0_11_p5502_lanes[0] +
      Lambda_0_11_p4351_lanes[5] * Lambda_0_11_p3389_lanes[5], Lambda_0_11_p5502_lanes[0] +
      Lambda_0_11_p4351_lanes[5] * Lambda_0_11_p3389_lanes[5], Lambda_0_11_p5502_lanes[0] +
      Lambda_0_11_p4351_lanes[5] * Lambda_0_11_p3389_lanes[5], Lambda_0_11_p5502_lanes[0] +
      Lambda_0_11_p4351_lanes[5] * Lambda_0_11_p3389_lanes[5], Lambda_0_11_p4350 *
      Lambda_0_11_p3389_lanes[5], Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[5]) +
      Lambda_0_11_p4333_lanes * Lambda_0_11_p3549_lanes[5] + Lambda_0_11_p4317_lanes *
      Lambda_0_11_p3709_lanes[5] + Lambda_0_11_p4301_lanes * Lambda_0_11_p3925_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5518_lanes = Lambda_0_11_p5509_lanes + Lambda_0_11_p4285_lanes *
      Lambda_0_11_p4109_lanes[5] + Lambda_0_11_p4269_lanes * Lambda_0_11_p4197_lanes[5] -
      Lambda_0_11_p4588_lanes * Lambda_0_11_p4523_lanes[5];
  const Lanes<8> Lambda_0_11_p5527_lanes = Lambda_0_11_p5518_lanes - Lambda_0_11_p4821_lanes *
      Lambda_0_11_p4749_lanes[5] - Lambda_0_11_p5044_lanes * Lambda_0_11_p4965_lanes[5] -
      Lambda_0_11_p5255_lanes * Lambda_0_11_p5169_lanes[5];
  const Lanes<8> Lambda_0_11_p5530_lanes = Lambda_0_11_p5527_lanes - Lambda_0_11_p5436_lanes *
      Lambda_0_11_p5343_lanes[5];
  const Real Lambda_0_11_p5533 = 1.0 / Lambda_0_11_p5530_lanes[5];
  const Lanes<8> Lambda_0_11_p5534_lanes = Lambda_0_11_p5432_lanes * Lambda_0_11_p5533;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5598_lanes = Lambda_0_11_p5481_lanes * Lambda_0_11_p2512;
  const Lanes<8> Lambda_0_11_p5622_lanes = Lambda_0_11_p5493_lanes * Lambda_0_11_p4435_lanes[1] +
      Lambda_0_11_p5489_lanes * Lambda_0_11_p2503 + Lambda_0_11_p5485_lanes * Lambda_0_11_p2506 +
      Lambda_0_11_p5598_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5634_lanes = Lambda_0_11_p5622_lanes + Lambda_0_11_p5477_lanes *
      Lambda_0_11_p2518 + Lambda_0_11_p5473_lanes * Lambda_0_11_p2532 + Lambda_0_11_p5469_lanes *
      Lambda_0_11_p2535;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5646_lanes = Lambda_0_11_p5634_lanes + Lambda_0_11_p4241_lanes *
      Lambda_0_11_p3389_lanes[6] + Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[6] +
      Lambda_0_11_p4225_lanes * Lambda_0_11_p3709_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5658_lanes = Lambda_0_11_p5646_lanes + Lambda_0_11_p4217_lanes *
      Lambda_0_11_p3925_lanes[6] + Lambda_0_11_p4209_lanes * Lambda_0_11_p4109_lanes[6] +
      Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[6];
  const Lanes<8> Lambda_0_11_p5670_lanes = Lambda_0_11_p5658_lanes - Lambda_0_11_p4532_lanes *
      Lambda_0_11_p4523_lanes[6] - Lambda_0_11_p4757_lanes * Lambda_0_11_p4749_lanes[6] -
      Lambda_0_11_p4972_lanes * Lambda_0_11_p4965_lanes[6];
  const Lanes<8> Lambda_0_11_p5682_lanes = Lambda_0_11_p5670_lanes - Lambda_0_11_p5175_lanes *
      Lambda_0_11_p5169_lanes[6] - Lambda_0_11_p5348_lanes * Lambda_0_11_p5343_lanes[6] -
      Lambda_0_11_p5534_lanes * Lambda_0_11_p5530_lanes[6];
  const Real Lambda_0_11_p5686 = Lambda_0_11_p5530_lanes[6] * Lambda_0_11_p5533;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p5687 = 91.62274020012977 * Lambda_0_11_p1352_lanes[1] *
      Lambda_0_11_p4435_lanes[1] + Lambda_0_11_p2503 * inverse_D12_lanes[1] * Lambda_0_11_p2503 +
      Lambda_0_11_p2506 * inverse_D11_lanes[1] * Lambda_0_11_p2506;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p5688 = Lambda_0_11_p5687 + Lambda_0_11_p2512 * inverse_D10_lanes[1] *
      Lambda_0_11_p2512 + Lambda_0_11_p2518 * inverse_D9_lanes[1] * Lambda_0_11_p2518 +
      Lambda_0_11_p2532 * inverse_D8_lanes[1] * Lambda_0_11_p2532;

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p5689 = Lambda_0_11_p5688 + Lambda_0_11_p2535 * inverse_D7_lanes[1] *
      Lambda_0_11_p2535 + Lambda_0_11_p4350 * Lambda_0_11_p3389_lanes[6] +
      Lambda_0_11_p4333_lanes[6] * Lambda_0_11_p3549_lanes[6] + Lambda_0_11_p4317_lanes[6] *
      Lambda_0_11_p3709_lanes[6];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5690 = Lambda_0_11_p5689 + Lambda_0_11_p4301_lanes[6] *
      Lambda_0_11_p3925_lanes[6] + Lambda_0_11_p4285_lanes[6] * Lambda_0_11_p4109_lanes[6] +
      Lambda_0_11_p4269_lanes[6] * Lambda_0_11_p4197_lanes[6] - Lambda_0_11_p4588_lanes[6] *
      Lambda_0_11_p4523_lanes[6];
  const Real Lambda_0_11_p5691 = Lambda_0_11_p5690 - Lambda_0_11_p4821_lanes[6] *
      Lambda_0_11_p4749_lanes[6] - Lambda_0_11_p5044_lanes[6] * Lambda_0_11_p4965_lanes[6] -
      Lambda_0_11_p5255_lanes[6] * Lambda_0_11_p5169_lanes[6] - Lambda_0_11_p5436_lanes[6] *
      Lambda_0_11_p5343_lanes[6];
  const Real Lambda_0_11_p5692 = 1.0 / (Lambda_0_11_p5691 - Lambda_0_11_p5686 *
      Lambda_0_11_p5530_lanes[6]);
  const Lanes<8> Lambda_0_11_p5693_lanes = Lambda_0_11_p5682_lanes * Lambda_0_11_p5692;
  const Real Lambda_0_11_p5697 = Lambda_0_11_p5530_lanes[7] * Lambda_0_11_p5533;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_0_11_p5698 = Lambda_0_11_p2500 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p5699 = Lambda_0_11_p2497 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p5700 = Lambda_0_11_p2483 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p5701 = Lambda_0_11_p2477 * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p5702 = Lambda_0_11_p2471 * inverse_D11_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p5703 = Lambda_0_11_p2468 * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p5704 = 91.62274020012977 * Lambda_0_11_p1346_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p5705 = Lambda_0_11_p5704 * Lambda_0_11_p4435_lanes[1] +
      Lambda_0_11_p5703 * Lambda_0_11_p2503 + Lambda_0_11_p5702 * Lambda_0_11_p2506 +
      Lambda_0_11_p5701 * Lambda_0_11_p2512 + Lambda_0_11_p5700 * Lambda_0_11_p2518;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p5706 = Lambda_0_11_p5705 + Lambda_0_11_p5699 * Lambda_0_11_p2532 +
      Lambda_0_11_p5698 * Lambda_0_11_p2535 + Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[6] +
      Lambda_0_11_p4333_lanes[7] * Lambda_0_11_p3549_lanes[6];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5707 = Lambda_0_11_p5706 + Lambda_0_11_p4317_lanes[7] *
      Lambda_0_11_p3709_lanes[6] + Lambda_0_11_p4301_lanes[7] * Lambda_0_11_p3925_lanes[6] +
      Lambda_0_11_p4285_lanes[7] * Lambda_0_11_p4109_lanes[6] + Lambda_0_11_p4269_lanes[7] *
      Lambda_0_11_p4197_lanes[6];
  const Real Lambda_0_11_p5708 = Lambda_0_11_p5707 - Lambda_0_11_p4588_lanes[7] *
      Lambda_0_11_p4523_lanes[6] - Lambda_0_11_p4821_lanes[7] * Lambda_0_11_p4749_lanes[6] -
      Lambda_0_11_p5044_lanes[7] * Lambda_0_11_p4965_lanes[6] - Lambda_0_11_p5255_lanes[7] *
      Lambda_0_11_p5169_lanes[6];
  const Real Lambda_0_11_p5709 = Lambda_0_11_p5708 - Lambda_0_11_p5436_lanes[7] *
      Lambda_0_11_p5343_lanes[6] - Lambda_0_11_p5697 * Lambda_0_11_p5530_lanes[6];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5774_lanes = Lambda_0_11_p5481_lanes * Lambda_0_11_p2477;
  const Lanes<8> Lambda_0_11_p5798_lanes = Lambda_0_11_p5493_lanes * Lambda_0_11_p4672_lanes[1] +
      Lambda_0_11_p5489_lanes * Lambda_0_11_p2468 + Lambda_0_11_p5485_lanes * Lambda_0_11_p2471 +
      Lambda_0_11_p5774_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5810_lanes = Lambda_0_11_p5798_lanes + Lambda_0_11_p5477_lanes *
      Lambda_0_11_p2483 + Lambda_0_11_p5473_lanes * Lambda_0_11_p2497 + Lambda_0_11_p5469_lanes *
      Lambda_0_11_p2500;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5822_lanes = Lambda_0_11_p5810_lanes + Lambda_0_11_p4241_lanes *
      Lambda_0_11_p3389_lanes[7] + Lambda_0_11_p4233_lanes * Lambda_0_11_p3549_lanes[7] +
      Lambda_0_11_p4225_lanes * Lambda_0_11_p3709_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5834_lanes = Lambda_0_11_p5822_lanes + Lambda_0_11_p4217_lanes *
      Lambda_0_11_p3925_lanes[7] + Lambda_0_11_p4209_lanes * Lambda_0_11_p4109_lanes[7] +
      Lambda_0_11_p2462_lanes * Lambda_0_11_p4197_lanes[7];
  const Lanes<8> Lambda_0_11_p5846_lanes = Lambda_0_11_p5834_lanes - Lambda_0_11_p4532_lanes *
      Lambda_0_11_p4523_lanes[7] - Lambda_0_11_p4757_lanes * Lambda_0_11_p4749_lanes[7] -
      Lambda_0_11_p4972_lanes * Lambda_0_11_p4965_lanes[7];
  const Lanes<8> Lambda_0_11_p5858_lanes = Lambda_0_11_p5846_lanes - Lambda_0_11_p5175_lanes *
      Lambda_0_11_p5169_lanes[7] - Lambda_0_11_p5348_lanes * Lambda_0_11_p5343_lanes[7] -
      Lambda_0_11_p5534_lanes * Lambda_0_11_p5530_lanes[7];
  const Lanes<8> Lambda_0_11_p5862_lanes = Lambda_0_11_p5858_lanes - Lambda_0_11_p5693_lanes *
      Lambda_0_11_p5709;
  const Real Lambda_0_11_p5866 = Lambda_0_11_p5709 * Lambda_0_11_p5692;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p5867 = Lambda_0_11_p5704 * Lambda_0_11_p4672_lanes[1] +
      Lambda_0_11_p5703 * Lambda_0_11_p2468 + Lambda_0_11_p5702 * Lambda_0_11_p2471 +
      Lambda_0_11_p5701 * Lambda_0_11_p2477 + Lambda_0_11_p5700 * Lambda_0_11_p2483;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p5868 = Lambda_0_11_p5867 + Lambda_0_11_p5699 * Lambda_0_11_p2497 +
      Lambda_0_11_p5698 * Lambda_0_11_p2500 + Lambda_0_11_p4349 * Lambda_0_11_p3389_lanes[7] +
      Lambda_0_11_p4333_lanes[7] * Lambda_0_11_p3549_lanes[7];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p5869 = Lambda_0_11_p5868 + Lambda_0_11_p4317_lanes[7] *
      Lambda_0_11_p3709_lanes[7] + Lambda_0_11_p4301_lanes[7] * Lambda_0_11_p3925_lanes[7] +
      Lambda_0_11_p4285_lanes[7] * Lambda_0_11_p4109_lanes[7] + Lambda_0_11_p4269_lanes[7] *
      Lambda_0_11_p4197_lanes[7];
  const Real Lambda_0_11_p5870 = Lambda_0_11_p5869 - Lambda_0_11_p4588_lanes[7] *
      Lambda_0_11_p4523_lanes[7] - Lambda_0_11_p4821_lanes[7] * Lambda_0_11_p4749_lanes[7] -
      Lambda_0_11_p5044_lanes[7] * Lambda_0_11_p4965_lanes[7] - Lambda_0_11_p5255_lanes[7] *
      Lambda_0_11_p5169_lanes[7];
  const Real Lambda_0_11_p5871 = 1.0 / (Lambda_0_11_p5870 - Lambda_0_11_p5436_lanes[7] *
      Lambda_0_11_p5343_lanes[7] - Lambda_0_11_p5697 * Lambda_0_11_p5530_lanes[7] -
      Lambda_0_11_p5866 * Lambda_0_11_p5709);
  const Lanes<8> Lambda_0_11_p5872_lanes = Lambda_0_11_p5862_lanes * Lambda_0_11_p5871;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5944_lanes = Lambda_0_11_p5481_lanes * Lambda_0_11_p1519_lanes[0];
  const Lanes<8> Lambda_0_11_p5968_lanes = Lambda_0_11_p5493_lanes * Lambda_0_11_p1328_lanes[1] +
      Lambda_0_11_p5489_lanes * Lambda_0_11_p1374_lanes[0] + Lambda_0_11_p5485_lanes *
      Lambda_0_11_p1439_lanes[0] + Lambda_0_11_p5944_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5980_lanes = Lambda_0_11_p5968_lanes + Lambda_0_11_p5477_lanes *
      Lambda_0_11_p1603_lanes[0] + Lambda_0_11_p5473_lanes * Lambda_0_11_p1799_lanes[0] +
      Lambda_0_11_p5469_lanes * Lambda_0_11_p1925_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5992_lanes = Lambda_0_11_p5980_lanes + Lambda_0_11_p4241_lanes *
      Lambda_0_11_p2051_lanes[0] + Lambda_0_11_p4233_lanes * Lambda_0_11_p2131_lanes[0] +
      Lambda_0_11_p4225_lanes * Lambda_0_11_p2211_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p6004_lanes = Lambda_0_11_p5992_lanes + Lambda_0_11_p4217_lanes *
      Lambda_0_11_p2319_lanes[0] + Lambda_0_11_p4209_lanes * Lambda_0_11_p2411_lanes[0] +
      Lambda_0_11_p2462_lanes * Lambda_0_11_p2458_lanes[0];
  const Lanes<8> Lambda_0_11_p6016_lanes = Lambda_0_11_p6004_lanes - Lambda_0_11_p4532_lanes *
      Lambda_0_11_p4265_lanes[0] - Lambda_0_11_p4757_lanes * Lambda_0_11_p4584_lanes[0] -
      Lambda_0_11_p4972_lanes * Lambda_0_11_p4817_lanes[0];
  const Lanes<8> Lambda_0_11_p6028_lanes = Lambda_0_11_p6016_lanes - Lambda_0_11_p5175_lanes *
      Lambda_0_11_p5040_lanes[0] - Lambda_0_11_p5348_lanes * Lambda_0_11_p5251_lanes[0] -
      Lambda_0_11_p5534_lanes * Lambda_0_11_p5432_lanes[0];
  const Lanes<8> Lambda_0_11_p6036_lanes = Lambda_0_11_p6028_lanes - Lambda_0_11_p5693_lanes *
      Lambda_0_11_p5682_lanes[0] - Lambda_0_11_p5872_lanes * Lambda_0_11_p5862_lanes[0];
  const Real Lambda_0_11_p6040 = 1.0 / Lambda_0_11_p6036_lanes[0];
  const Lanes<8> Lambda_0_11_p6041_lanes = Lambda_0_11_p6036_lanes * Lambda_0_11_p6040;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p6098_lanes = Lambda_0_11_p5481_lanes * Lambda_0_11_p1519_lanes[1];
  const Lanes<8> Lambda_0_11_p6116_lanes = Lambda_0_11_p5493_lanes * Lambda_0_11_p1277 +
      Lambda_0_11_p5489_lanes * Lambda_0_11_p1374_lanes[1] + Lambda_0_11_p5485_lanes *
      Lambda_0_11_p1439_lanes[1] + Lambda_0_11_p6098_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p6125_lanes = Lambda_0_11_p6116_lanes + Lambda_0_11_p5477_lanes *
      Lambda_0_11_p1603_lanes[1] + Lambda_0_11_p5473_lanes * Lambda_0_11_p1799_lanes[1] +
      Lambda_0_11_p5469_lanes * Lambda_0_11_p1925_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p6134_lanes = Lambda_0_11_p6125_lanes + Lambda_0_11_p4241_lanes *
      Lambda_0_11_p2051_lanes[1] + Lambda_0_11_p4233_lanes * Lambda_0_11_p2131_lanes[1] +
      Lambda_0_11_p4225_lanes * Lambda_0_11_p2211_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p6143_lanes = Lambda_0_11_p6134_lanes + Lambda_0_11_p4217_lanes *
      Lambda_0_11_p2319_lanes[1] + Lambda_0_11_p4209_lanes * Lambda_0_11_p2411_lanes[1] +
      Lambda_0_11_p2462_lanes * Lambda_0_11_p2458_lanes[1];
  const Lanes<8> Lambda_0_11_p6152_lanes = Lambda_0_11_p6143_lanes - Lambda_0_11_p4532_lanes *
      Lambda_0_11_p4265_lanes[1] - Lambda_0_11_p4757_lanes * Lambda_0_11_p4584_lanes[1] -
      Lambda_0_11_p4972_lanes * Lambda_0_11_p4817_lanes[1];
  const Lanes<8> Lambda_0_11_p6161_lanes = Lambda_0_11_p6152_lanes - Lambda_0_11_p5175_lanes *
      Lambda_0_11_p5040_lanes[1] - Lambda_0_11_p5348_lanes * Lambda_0_11_p5251_lanes[1] -
      Lambda_0_11_p5534_lanes * Lambda_0_11_p5432_lanes[1];
  const Lanes<8> Lambda_0_11_p6170_lanes = Lambda_0_11_p6161_lanes - Lambda_0_11_p5693_lanes *
      Lambda_0_11_p5682_lanes[1] - Lambda_0_11_p5872_lanes * Lambda_0_11_p5862_lanes[1] -
      Lambda_0_11_p6041_lanes * Lambda_0_11_p6036_lanes[1];
  const Real Lambda_0_11_p6173 = 1.0 / Lambda_0_11_p6170_lanes[1];
  const Real Lambda_0_11_p6174 = Lambda_0_11_p6170_lanes[3] * Lambda_0_11_p6173;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p6175_lanes = Lambda_0_11_p5493_lanes * Lambda_0_11_p1257;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p6177 = Lambda_0_11_p6175_lanes[3] + Lambda_0_11_p5489_lanes[3] *
      Lambda_0_11_p1374_lanes[2] + Lambda_0_11_p5485_lanes[3] * Lambda_0_11_p1439_lanes[2] +
      Lambda_0_11_p5481_lanes[3] * Lambda_0_11_p1519_lanes[2] + Lambda_0_11_p5477_lanes[3] *
      Lambda_0_11_p1603_lanes[2];

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p6178 = Lambda_0_11_p6177 + Lambda_0_11_p5473_lanes[3] *
      Lambda_0_11_p1799_lanes[2] + Lambda_0_11_p5469_lanes[3] * Lambda_0_11_p1925_lanes[2] +
      Lambda_0_11_p4241_lanes[3] * Lambda_0_11_p2051_lanes[2] + Lambda_0_11_p4233_lanes[3] *
      Lambda_0_11_p2131_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p6179 = Lambda_0_11_p6178 + Lambda_0_11_p4225_lanes[3] *
      Lambda_0_11_p2211_lanes[2] + Lambda_0_11_p4217_lanes[3] * Lambda_0_11_p2319_lanes[2] +
      Lambda_0_11_p4209_lanes[3] * Lambda_0_11_p2411_lanes[2] + Lambda_0_11_p2462_lanes[3] *
      Lambda_0_11_p2458_lanes[2];
  const Real Lambda_0_11_p6180 = Lambda_0_11_p6179 - Lambda_0_11_p4532_lanes[3] *
      Lambda_0_11_p4265_lanes[2] - Lambda_0_11_p4757_lanes[3] * Lambda_0_11_p4584_lanes[2] -
      Lambda_0_11_p4972_lanes[3] * Lambda_0_11_p4817_lanes[2] - Lambda_0_11_p5175_lanes[3] *
      Lambda_0_11_p5040_lanes[2];
  const Real Lambda_0_11_p6181 = Lambda_0_11_p6180 - Lambda_0_11_p5348_lanes[3] *
      Lambda_0_11_p5251_lanes[2] - Lambda_0_11_p5534_lanes[3] * Lambda_0_11_p5432_lanes[2] -
      Lambda_0_11_p5693_lanes[3] * Lambda_0_11_p5682_lanes[2] - Lambda_0_11_p5872_lanes[3] *
      Lambda_0_11_p5862_lanes[2];
  const Real Lambda_0_11_p6182 = Lambda_0_11_p6181 - Lambda_0_11_p6041_lanes[3] *
      Lambda_0_11_p6036_lanes[2] - Lambda_0_11_p6174 * Lambda_0_11_p6170_lanes[2];
  const Real Lambda_0_11_p6183 = Lambda_0_11_p6170_lanes[2] * Lambda_0_11_p6173;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p6184 = Lambda_0_11_p6175_lanes[2] + Lambda_0_11_p5489_lanes[2] *
      Lambda_0_11_p1374_lanes[2] + Lambda_0_11_p5485_lanes[2] * Lambda_0_11_p1439_lanes[2] +
      Lambda_0_11_p5481_lanes[2] * Lambda_0_11_p1519_lanes[2] + Lambda_0_11_p5477_lanes[2] *
      Lambda_0_11_p1603_lanes[2];

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p6185 = Lambda_0_11_p6184 + Lambda_0_11_p5473_lanes[2] *
      Lambda_0_11_p1799_lanes[2] + Lambda_0_11_p5469_lanes[2] * Lambda_0_11_p1925_lanes[2] +
      Lambda_0_11_p4241_lanes[2] * Lambda_0_11_p2051_lanes[2] + Lambda_0_11_p4233_lanes[2] *
      Lambda_0_11_p2131_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p6186 = Lambda_0_11_p6185 + Lambda_0_11_p4225_lanes[2] *
      Lambda_0_11_p2211_lanes[2] + Lambda_0_11_p4217_lanes[2] * Lambda_0_11_p2319_lanes[2] +
      Lambda_0_11_p4209_lanes[2] * Lambda_0_11_p2411_lanes[2] + Lambda_0_11_p2462_lanes[2] *
      Lambda_0_11_p2458_lanes[2];
  const Real Lambda_0_11_p6187 = Lambda_0_11_p6186 - Lambda_0_11_p4532_lanes[2] *
      Lambda_0_11_p4265_lanes[2] - Lambda_0_11_p4757_lanes[2] * Lambda_0_11_p4584_lanes[2] -
      Lambda_0_11_p4972_lanes[2] * Lambda_0_11_p4817_lanes[2] - Lambda_0_11_p5175_lanes[2] *
      Lambda_0_11_p5040_lanes[2];
  const Real Lambda_0_11_p6188 = Lambda_0_11_p6187 - Lambda_0_11_p5348_lanes[2] *
      Lambda_0_11_p5251_lanes[2] - Lambda_0_11_p5534_lanes[2] * Lambda_0_11_p5432_lanes[2] -
      Lambda_0_11_p5693_lanes[2] * Lambda_0_11_p5682_lanes[2] - Lambda_0_11_p5872_lanes[2] *
      Lambda_0_11_p5862_lanes[2];
  const Real Lambda_0_11_p6189 = 1.0 / (Lambda_0_11_p6188 - Lambda_0_11_p6041_lanes[2] *
      Lambda_0_11_p6036_lanes[2] - Lambda_0_11_p6183 * Lambda_0_11_p6170_lanes[2]);
  const Real Lambda_0_11_p6190 = Lambda_0_11_p6182 * Lambda_0_11_p6189;
  const Real Lambda_0_11_p6191 = Lambda_0_11_p4821_lanes[2] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4588_lanes[2];
  const Real Lambda_0_11_p6192 = Lambda_0_11_p4821_lanes[3] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4588_lanes[3] - Lambda_0_11_p5044_lanes[3] * Lambda_0_11_p6191;
  const Real Lambda_0_11_p6193 = Lambda_0_11_p4821_lanes[4] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4588_lanes[4] - Lambda_0_11_p5044_lanes[4] * Lambda_0_11_p6191 -
      Lambda_0_11_p5255_lanes[4] * Lambda_0_11_p6192;
  const Real Lambda_0_11_p6194 = Lambda_0_11_p4821_lanes[5] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4588_lanes[5] - Lambda_0_11_p5044_lanes[5] * Lambda_0_11_p6191 -
      Lambda_0_11_p5255_lanes[5] * Lambda_0_11_p6192 - Lambda_0_11_p5436_lanes[5] *
      Lambda_0_11_p6193;
  const Real Lambda_0_11_p6195 = Lambda_0_11_p4821_lanes[6] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4588_lanes[6] - Lambda_0_11_p5044_lanes[6] * Lambda_0_11_p6191 -
      Lambda_0_11_p5255_lanes[6] * Lambda_0_11_p6192 - Lambda_0_11_p5436_lanes[6] *
      Lambda_0_11_p6193;
  const Real Lambda_0_11_p6196 = Lambda_0_11_p6195 - Lambda_0_11_p5686 * Lambda_0_11_p6194;
  const Real Lambda_0_11_p6197 = Lambda_0_11_p4821_lanes[7] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4588_lanes[7] - Lambda_0_11_p5044_lanes[7] * Lambda_0_11_p6191 -
      Lambda_0_11_p5255_lanes[7] * Lambda_0_11_p6192 - Lambda_0_11_p5436_lanes[7] *
      Lambda_0_11_p6193;
  const Real Lambda_0_11_p6198 = Lambda_0_11_p6197 - Lambda_0_11_p5697 * Lambda_0_11_p6194 -
      Lambda_0_11_p5866 * Lambda_0_11_p6196;
  const Real Lambda_0_11_p6199 = Lambda_0_11_p4757_lanes[0] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4532_lanes[0] - Lambda_0_11_p4972_lanes[0] * Lambda_0_11_p6191 -
      Lambda_0_11_p5175_lanes[0] * Lambda_0_11_p6192 - Lambda_0_11_p5348_lanes[0] *
      Lambda_0_11_p6193;
  const Real Lambda_0_11_p6200 = Lambda_0_11_p6199 - Lambda_0_11_p5534_lanes[0] *
      Lambda_0_11_p6194 - Lambda_0_11_p5693_lanes[0] * Lambda_0_11_p6196 -
      Lambda_0_11_p5872_lanes[0] * Lambda_0_11_p6198;
  const Real Lambda_0_11_p6201 = Lambda_0_11_p4757_lanes[1] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4532_lanes[1] - Lambda_0_11_p4972_lanes[1] * Lambda_0_11_p6191 -
      Lambda_0_11_p5175_lanes[1] * Lambda_0_11_p6192 - Lambda_0_11_p5348_lanes[1] *
      Lambda_0_11_p6193;
  const Real Lambda_0_11_p6202 = Lambda_0_11_p6201 - Lambda_0_11_p5534_lanes[1] *
      Lambda_0_11_p6194 - Lambda_0_11_p5693_lanes[1] * Lambda_0_11_p6196 -
      Lambda_0_11_p5872_lanes[1] * Lambda_0_11_p6198 - Lambda_0_11_p6041_lanes[1] *
      Lambda_0_11_p6200;
  const Real Lambda_0_11_p6203 = Lambda_0_11_p4757_lanes[2] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4532_lanes[2] - Lambda_0_11_p4972_lanes[2] * Lambda_0_11_p6191 -
      Lambda_0_11_p5175_lanes[2] * Lambda_0_11_p6192 - Lambda_0_11_p5348_lanes[2] *
      Lambda_0_11_p6193;
  const Real Lambda_0_11_p6204 = Lambda_0_11_p6203 - Lambda_0_11_p5534_lanes[2] *
      Lambda_0_11_p6194 - Lambda_0_11_p5693_lanes[2] * Lambda_0_11_p6196 -
      Lambda_0_11_p5872_lanes[2] * Lambda_0_11_p6198 - Lambda_0_11_p6041_lanes[2] *
      Lambda_0_11_p6200;
  const Real Lambda_0_11_p6205 = Lambda_0_11_p6204 - Lambda_0_11_p6183 * Lambda_0_11_p6202;
  const Real Lambda_0_11_p6206 = Lambda_0_11_p4757_lanes[3] * Lambda_0_11_p4588_lanes[1] -
      Lambda_0_11_p4532_lanes[3] - Lambda_0_11_p4972_lanes[3] * Lambda_0_11_p6191 -
      Lambda_0_11_p5175_lanes[3] * Lambda_0_11_p6192 - Lambda_0_11_p5348_lanes[3] *
      Lambda_0_11_p6193;
  const Real Lambda_0_11_p6207 = Lambda_0_11_p6206 - Lambda_0_11_p5534_lanes[3] *
      Lambda_0_11_p6194 - Lambda_0_11_p5693_lanes[3] * Lambda_0_11_p6196 -
      Lambda_0_11_p5872_lanes[3] * Lambda_0_11_p6198 - Lambda_0_11_p6041_lanes[3] *
      Lambda_0_11_p6200;
  const Real Lambda_0_11_p6208 = Lambda_0_11_p6207 - Lambda_0_11_p6174 * Lambda_0_11_p6202 -
      Lambda_0_11_p6190 * Lambda_0_11_p6205;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p21 = Lambda_0_11_p5502_lanes[1] + Lambda_0_11_p4241_lanes[3] *
      Lambda_0_11_p2051_lanes[3] + Lambda_0_11_p4233_lanes[3] * Lambda_0_11_p2131_lanes[3] +
      Lambda_0_11_p4225_lanes[3] * Lambda_0_11_p2211_lanes[3] + Lambda_0_11_p4217_lanes[3] *
      Lambda_0_11_p2319_lanes[3];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p22 = Lambda_11_11_p21 + Lambda_0_11_p4209_lanes[3] *
      Lambda_0_11_p2411_lanes[3] + Lambda_0_11_p2462_lanes[3] * Lambda_0_11_p2458_lanes[3] -
      Lambda_0_11_p4532_lanes[3] * Lambda_0_11_p4265_lanes[3] - Lambda_0_11_p4757_lanes[3] *
      Lambda_0_11_p4584_lanes[3];
  const Real Lambda_11_11_p23 = Lambda_11_11_p22 - Lambda_0_11_p4972_lanes[3] *
      Lambda_0_11_p4817_lanes[3] - Lambda_0_11_p5175_lanes[3] * Lambda_0_11_p5040_lanes[3] -
      Lambda_0_11_p5348_lanes[3] * Lambda_0_11_p5251_lanes[3] - Lambda_0_11_p5534_lanes[3] *
      Lambda_0_11_p5432_lanes[3];
  const Real Lambda_11_11_p24 = Lambda_11_11_p23 - Lambda_0_11_p5693_lanes[3] *
      Lambda_0_11_p5682_lanes[3] - Lambda_0_11_p5872_lanes[3] * Lambda_0_11_p5862_lanes[3] -
      Lambda_0_11_p6041_lanes[3] * Lambda_0_11_p6036_lanes[3] - Lambda_0_11_p6174 *
      Lambda_0_11_p6170_lanes[3];
  const Real Lambda_11_11 = 1.0 / (Lambda_11_11_p24 - Lambda_0_11_p6190 * Lambda_0_11_p6182);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_0_11 = Lambda_0_11_p6208 * Lambda_11_11;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_0_0_p1 = Lambda_0_11_p6205 * Lambda_0_11_p6189;
  const Real Lambda_0_0_p2 = Lambda_0_11_p6202 * Lambda_0_11_p6173;
  const Real Lambda_0_0_p3 = Lambda_0_11_p6200 * Lambda_0_11_p6040;
  const Real Lambda_0_0_p4 = Lambda_0_11_p6198 * Lambda_0_11_p5871;
  const Real Lambda_0_0_p5 = Lambda_0_11_p6196 * Lambda_0_11_p5692;
  const Real Lambda_0_0_p6 = Lambda_0_11_p6194 * Lambda_0_11_p5533;
  const Real Lambda_0_0_p7 = Lambda_0_11_p6193 * Lambda_0_11_p5347;
  const Real Lambda_0_0_p8 = Lambda_0_11_p6192 * Lambda_0_11_p5174;
  const Real Lambda_0_0_p9 = Lambda_0_11_p6191 * Lambda_0_11_p4971;
  const Real Lambda_0_0_p10 = Lambda_0_11_p4588_lanes[1] * Lambda_0_11_p4756;
  const Real Lambda_0_0_p11 = Lambda_0_11_p4531 + Lambda_0_0_p10 * Lambda_0_11_p4588_lanes[1] +
      Lambda_0_0_p9 * Lambda_0_11_p6191 + Lambda_0_0_p8 * Lambda_0_11_p6192 + Lambda_0_0_p7 *
      Lambda_0_11_p6193;
  const Real Lambda_0_0_p12 = Lambda_0_0_p11 + Lambda_0_0_p6 * Lambda_0_11_p6194 + Lambda_0_0_p5 *
      Lambda_0_11_p6196 + Lambda_0_0_p4 * Lambda_0_11_p6198 + Lambda_0_0_p3 * Lambda_0_11_p6200;
  Lambda[0] = Lambda_0_0_p12 + Lambda_0_0_p2 * Lambda_0_11_p6202 + Lambda_0_0_p1 *
      Lambda_0_11_p6205 + Lambda_0_11 * Lambda_0_11_p6208;
  const Real Lambda_1_11_p1 = Lambda_0_11_p5044_lanes[3] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4821_lanes[3];
  const Real Lambda_1_11_p2 = Lambda_0_11_p5044_lanes[4] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4821_lanes[4] - Lambda_0_11_p5255_lanes[4] * Lambda_1_11_p1;
  const Real Lambda_1_11_p3 = Lambda_0_11_p5044_lanes[5] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4821_lanes[5] - Lambda_0_11_p5255_lanes[5] * Lambda_1_11_p1 -
      Lambda_0_11_p5436_lanes[5] * Lambda_1_11_p2;
  const Real Lambda_1_11_p4 = Lambda_0_11_p5044_lanes[6] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4821_lanes[6] - Lambda_0_11_p5255_lanes[6] * Lambda_1_11_p1 -
      Lambda_0_11_p5436_lanes[6] * Lambda_1_11_p2 - Lambda_0_11_p5686 * Lambda_1_11_p3;
  const Real Lambda_1_11_p5 = Lambda_0_11_p5044_lanes[7] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4821_lanes[7] - Lambda_0_11_p5255_lanes[7] * Lambda_1_11_p1 -
      Lambda_0_11_p5436_lanes[7] * Lambda_1_11_p2 - Lambda_0_11_p5697 * Lambda_1_11_p3;
  const Real Lambda_1_11_p6 = Lambda_1_11_p5 - Lambda_0_11_p5866 * Lambda_1_11_p4;
  const Real Lambda_1_11_p7 = Lambda_0_11_p4972_lanes[0] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4757_lanes[0] - Lambda_0_11_p5175_lanes[0] * Lambda_1_11_p1 -
      Lambda_0_11_p5348_lanes[0] * Lambda_1_11_p2 - Lambda_0_11_p5534_lanes[0] * Lambda_1_11_p3;
  const Real Lambda_1_11_p8 = Lambda_1_11_p7 - Lambda_0_11_p5693_lanes[0] * Lambda_1_11_p4 -
      Lambda_0_11_p5872_lanes[0] * Lambda_1_11_p6;
  const Real Lambda_1_11_p9 = Lambda_0_11_p4972_lanes[1] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4757_lanes[1] - Lambda_0_11_p5175_lanes[1] * Lambda_1_11_p1 -
      Lambda_0_11_p5348_lanes[1] * Lambda_1_11_p2 - Lambda_0_11_p5534_lanes[1] * Lambda_1_11_p3;
  const Real Lambda_1_11_p10 = Lambda_1_11_p9 - Lambda_0_11_p5693_lanes[1] * Lambda_1_11_p4 -
      Lambda_0_11_p5872_lanes[1] * Lambda_1_11_p6 - Lambda_0_11_p6041_lanes[1] * Lambda_1_11_p8;
  const Real Lambda_1_11_p11 = Lambda_0_11_p4972_lanes[2] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4757_lanes[2] - Lambda_0_11_p5175_lanes[2] * Lambda_1_11_p1 -
      Lambda_0_11_p5348_lanes[2] * Lambda_1_11_p2 - Lambda_0_11_p5534_lanes[2] * Lambda_1_11_p3;
  const Real Lambda_1_11_p12 = Lambda_1_11_p11 - Lambda_0_11_p5693_lanes[2] * Lambda_1_11_p4 -
      Lambda_0_11_p5872_lanes[2] * Lambda_1_11_p6 - Lambda_0_11_p6041_lanes[2] * Lambda_1_11_p8 -
      Lambda_0_11_p6183 * Lambda_1_11_p10;
  const Real Lambda_1_11_p13 = Lambda_0_11_p4972_lanes[3] * Lambda_0_11_p4821_lanes[2] -
      Lambda_0_11_p4757_lanes[3] - Lambda_0_11_p5175_lanes[3] * Lambda_1_11_p1 -
      Lambda_0_11_p5348_lanes[3] * Lambda_1_11_p2 - Lambda_0_11_p5534_lanes[3] * Lambda_1_11_p3;
  const Real Lambda_1_11_p14 = Lambda_1_11_p13 - Lambda_0_11_p5693_lanes[3] * Lambda_1_11_p4 -
      Lambda_0_11_p5872_lanes[3] * Lambda_1_11_p6 - Lambda_0_11_p6041_lanes[3] * Lambda_1_11_p8 -
      Lambda_0_11_p6174 * Lambda_1_11_p10;
  const Real Lambda_1_11_p15 = Lambda_1_11_p14 - Lambda_0_11_p6190 * Lambda_1_11_p12;
  const Real Lambda_1_11 = Lambda_1_11_p15 * Lambda_11_11;
  Lambda[23] = Lambda_1_11;
  Lambda[133] = Lambda_1_11;
  const Real Lambda_0_1_p1 = Lambda_1_11_p12 * Lambda_0_11_p6189;
  const Real Lambda_0_1_p2 = Lambda_1_11_p10 * Lambda_0_11_p6173;
  const Real Lambda_0_1_p3 = Lambda_1_11_p8 * Lambda_0_11_p6040;
  const Real Lambda_0_1_p4 = Lambda_1_11_p6 * Lambda_0_11_p5871;
  const Real Lambda_0_1_p5 = Lambda_1_11_p4 * Lambda_0_11_p5692;
  const Real Lambda_0_1_p6 = Lambda_1_11_p3 * Lambda_0_11_p5533;
  const Real Lambda_0_1_p7 = Lambda_1_11_p2 * Lambda_0_11_p5347;
  const Real Lambda_0_1_p8 = Lambda_1_11_p1 * Lambda_0_11_p5174;
  const Real Lambda_0_1_p9 = Lambda_0_11_p4821_lanes[2] * Lambda_0_11_p4971;
  const Real Lambda_0_1_p10 = Lambda_0_1_p8 * Lambda_0_11_p6192 -
      (Lambda_0_0_p10 + Lambda_0_1_p9 * Lambda_0_11_p6191) + Lambda_0_1_p7 * Lambda_0_11_p6193 +
      Lambda_0_1_p6 * Lambda_0_11_p6194;
  const Real Lambda_0_1_p11 = Lambda_0_1_p10 + Lambda_0_1_p5 * Lambda_0_11_p6196 + Lambda_0_1_p4 *
      Lambda_0_11_p6198 + Lambda_0_1_p3 * Lambda_0_11_p6200 + Lambda_0_1_p2 * Lambda_0_11_p6202;
  const Real Lambda_0_1 = Lambda_0_1_p11 + Lambda_0_1_p1 * Lambda_0_11_p6205 + Lambda_1_11 *
      Lambda_0_11_p6208;
  Lambda[1] = Lambda_0_1;
  Lambda[12] = Lambda_0_1;
  const Real Lambda_2_11_p1 = Lambda_0_11_p5255_lanes[4] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p5044_lanes[4];
  const Real Lambda_2_11_p2 = Lambda_0_11_p5255_lanes[5] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p5044_lanes[5] - Lambda_0_11_p5436_lanes[5] * Lambda_2_11_p1;
  const Real Lambda_2_11_p3 = Lambda_0_11_p5255_lanes[6] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p5044_lanes[6] - Lambda_0_11_p5436_lanes[6] * Lambda_2_11_p1 - Lambda_0_11_p5686 *
      Lambda_2_11_p2;
  const Real Lambda_2_11_p4 = Lambda_0_11_p5255_lanes[7] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p5044_lanes[7] - Lambda_0_11_p5436_lanes[7] * Lambda_2_11_p1 - Lambda_0_11_p5697 *
      Lambda_2_11_p2 - Lambda_0_11_p5866 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_0_11_p5175_lanes[0] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p4972_lanes[0] - Lambda_0_11_p5348_lanes[0] * Lambda_2_11_p1 -
      Lambda_0_11_p5534_lanes[0] * Lambda_2_11_p2 - Lambda_0_11_p5693_lanes[0] * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_2_11_p5 - Lambda_0_11_p5872_lanes[0] * Lambda_2_11_p4;
  const Real Lambda_2_11_p7 = Lambda_0_11_p5175_lanes[1] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p4972_lanes[1] - Lambda_0_11_p5348_lanes[1] * Lambda_2_11_p1 -
      Lambda_0_11_p5534_lanes[1] * Lambda_2_11_p2 - Lambda_0_11_p5693_lanes[1] * Lambda_2_11_p3;
  const Real Lambda_2_11_p8 = Lambda_2_11_p7 - Lambda_0_11_p5872_lanes[1] * Lambda_2_11_p4 -
      Lambda_0_11_p6041_lanes[1] * Lambda_2_11_p6;
  const Real Lambda_2_11_p9 = Lambda_0_11_p5175_lanes[2] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p4972_lanes[2] - Lambda_0_11_p5348_lanes[2] * Lambda_2_11_p1 -
      Lambda_0_11_p5534_lanes[2] * Lambda_2_11_p2 - Lambda_0_11_p5693_lanes[2] * Lambda_2_11_p3;
  const Real Lambda_2_11_p10 = Lambda_2_11_p9 - Lambda_0_11_p5872_lanes[2] * Lambda_2_11_p4 -
      Lambda_0_11_p6041_lanes[2] * Lambda_2_11_p6 - Lambda_0_11_p6183 * Lambda_2_11_p8;
  const Real Lambda_2_11_p11 = Lambda_0_11_p5175_lanes[3] * Lambda_0_11_p5044_lanes[3] -
      Lambda_0_11_p4972_lanes[3] - Lambda_0_11_p5348_lanes[3] * Lambda_2_11_p1 -
      Lambda_0_11_p5534_lanes[3] * Lambda_2_11_p2 - Lambda_0_11_p5693_lanes[3] * Lambda_2_11_p3;
  const Real Lambda_2_11_p12 = Lambda_2_11_p11 - Lambda_0_11_p5872_lanes[3] * Lambda_2_11_p4 -
      Lambda_0_11_p6041_lanes[3] * Lambda_2_11_p6 - Lambda_0_11_p6174 * Lambda_2_11_p8 -
      Lambda_0_11_p6190 * Lambda_2_11_p10;
  const Real Lambda_2_11 = Lambda_2_11_p12 * Lambda_11_11;
  Lambda[35] = Lambda_2_11;
  Lambda[134] = Lambda_2_11;
  const Real Lambda_0_2_p1 = Lambda_2_11_p10 * Lambda_0_11_p6189;
  const Real Lambda_0_2_p2 = Lambda_2_11_p8 * Lambda_0_11_p6173;
  const Real Lambda_0_2_p3 = Lambda_2_11_p6 * Lambda_0_11_p6040;
  const Real Lambda_0_2_p4 = Lambda_2_11_p4 * Lambda_0_11_p5871;
  const Real Lambda_0_2_p5 = Lambda_2_11_p3 * Lambda_0_11_p5692;
  const Real Lambda_0_2_p6 = Lambda_2_11_p2 * Lambda_0_11_p5533;
  const Real Lambda_0_2_p7 = Lambda_2_11_p1 * Lambda_0_11_p5347;
  const Real Lambda_0_2_p8 = Lambda_0_11_p5044_lanes[3] * Lambda_0_11_p5174;
  const Real Lambda_0_2_p9 = Lambda_0_0_p9 - Lambda_0_2_p8 * Lambda_0_11_p6192 + Lambda_0_2_p7 *
      Lambda_0_11_p6193 + Lambda_0_2_p6 * Lambda_0_11_p6194 + Lambda_0_2_p5 * Lambda_0_11_p6196;
  const Real Lambda_0_2_p10 = Lambda_0_2_p9 + Lambda_0_2_p4 * Lambda_0_11_p6198 + Lambda_0_2_p3 *
      Lambda_0_11_p6200 + Lambda_0_2_p2 * Lambda_0_11_p6202 + Lambda_0_2_p1 * Lambda_0_11_p6205;
  const Real Lambda_0_2 = Lambda_0_2_p10 + Lambda_2_11 * Lambda_0_11_p6208;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_3_11_p1 = Lambda_0_11_p5436_lanes[5] * Lambda_0_11_p5255_lanes[4] -
      Lambda_0_11_p5255_lanes[5];
  const Real Lambda_3_11_p2 = Lambda_0_11_p5436_lanes[6] * Lambda_0_11_p5255_lanes[4] -
      Lambda_0_11_p5255_lanes[6] - Lambda_0_11_p5686 * Lambda_3_11_p1;
  const Real Lambda_3_11_p3 = Lambda_0_11_p5436_lanes[7] * Lambda_0_11_p5255_lanes[4] -
      Lambda_0_11_p5255_lanes[7] - Lambda_0_11_p5697 * Lambda_3_11_p1 - Lambda_0_11_p5866 *
      Lambda_3_11_p2;
  const Real Lambda_3_11_p4 = Lambda_0_11_p5348_lanes[0] * Lambda_0_11_p5255_lanes[4] -
      Lambda_0_11_p5175_lanes[0] - Lambda_0_11_p5534_lanes[0] * Lambda_3_11_p1 -
      Lambda_0_11_p5693_lanes[0] * Lambda_3_11_p2 - Lambda_0_11_p5872_lanes[0] * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_0_11_p5348_lanes[1] * Lambda_0_11_p5255_lanes[4] -
      Lambda_0_11_p5175_lanes[1] - Lambda_0_11_p5534_lanes[1] * Lambda_3_11_p1 -
      Lambda_0_11_p5693_lanes[1] * Lambda_3_11_p2 - Lambda_0_11_p5872_lanes[1] * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_3_11_p5 - Lambda_0_11_p6041_lanes[1] * Lambda_3_11_p4;
  const Real Lambda_3_11_p7 = Lambda_0_11_p5348_lanes[2] * Lambda_0_11_p5255_lanes[4] -
      Lambda_0_11_p5175_lanes[2] - Lambda_0_11_p5534_lanes[2] * Lambda_3_11_p1 -
      Lambda_0_11_p5693_lanes[2] * Lambda_3_11_p2 - Lambda_0_11_p5872_lanes[2] * Lambda_3_11_p3;
  const Real Lambda_3_11_p8 = Lambda_3_11_p7 - Lambda_0_11_p6041_lanes[2] * Lambda_3_11_p4 -
      Lambda_0_11_p6183 * Lambda_3_11_p6;
  const Real Lambda_3_11_p9 = Lambda_0_11_p5348_lanes[3] * Lambda_0_11_p5255_lanes[4] -
      Lambda_0_11_p5175_lanes[3] - Lambda_0_11_p5534_lanes[3] * Lambda_3_11_p1 -
      Lambda_0_11_p5693_lanes[3] * Lambda_3_11_p2 - Lambda_0_11_p5872_lanes[3] * Lambda_3_11_p3;
  const Real Lambda_3_11_p10 = Lambda_3_11_p9 - Lambda_0_11_p6041_lanes[3] * Lambda_3_11_p4 -
      Lambda_0_11_p6174 * Lambda_3_11_p6 - Lambda_0_11_p6190 * Lambda_3_11_p8;
  const Real Lambda_3_11 = Lambda_3_11_p10 * Lambda_11_11;
  Lambda[47] = Lambda_3_11;
  Lambda[135] = Lambda_3_11;
  const Real Lambda_0_3_p1 = Lambda_3_11_p8 * Lambda_0_11_p6189;
  const Real Lambda_0_3_p2 = Lambda_3_11_p6 * Lambda_0_11_p6173;
  const Real Lambda_0_3_p3 = Lambda_3_11_p4 * Lambda_0_11_p6040;
  const Real Lambda_0_3_p4 = Lambda_3_11_p3 * Lambda_0_11_p5871;
  const Real Lambda_0_3_p5 = Lambda_3_11_p2 * Lambda_0_11_p5692;
  const Real Lambda_0_3_p6 = Lambda_3_11_p1 * Lambda_0_11_p5533;
  const Real Lambda_0_3_p7 = Lambda_0_11_p5255_lanes[4] * Lambda_0_11_p5347;
  const Real Lambda_0_3_p8 = Lambda_0_0_p8 - Lambda_0_3_p7 * Lambda_0_11_p6193 + Lambda_0_3_p6 *
      Lambda_0_11_p6194 + Lambda_0_3_p5 * Lambda_0_11_p6196 + Lambda_0_3_p4 * Lambda_0_11_p6198;
  const Real Lambda_0_3 = Lambda_0_3_p8 + Lambda_0_3_p3 * Lambda_0_11_p6200 + Lambda_0_3_p2 *
      Lambda_0_11_p6202 + Lambda_0_3_p1 * Lambda_0_11_p6205 + Lambda_3_11 * Lambda_0_11_p6208;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_4_11_p1 = Lambda_0_11_p5686 * Lambda_0_11_p5436_lanes[5] -
      Lambda_0_11_p5436_lanes[6];
  const Real Lambda_4_11_p2 = Lambda_0_11_p5697 * Lambda_0_11_p5436_lanes[5] -
      Lambda_0_11_p5436_lanes[7] - Lambda_0_11_p5866 * Lambda_4_11_p1;
  const Real Lambda_4_11_p3 = Lambda_0_11_p5534_lanes[0] * Lambda_0_11_p5436_lanes[5] -
      Lambda_0_11_p5348_lanes[0] - Lambda_0_11_p5693_lanes[0] * Lambda_4_11_p1 -
      Lambda_0_11_p5872_lanes[0] * Lambda_4_11_p2;
  const Real Lambda_4_11_p4 = Lambda_0_11_p5534_lanes[1] * Lambda_0_11_p5436_lanes[5] -
      Lambda_0_11_p5348_lanes[1] - Lambda_0_11_p5693_lanes[1] * Lambda_4_11_p1 -
      Lambda_0_11_p5872_lanes[1] * Lambda_4_11_p2 - Lambda_0_11_p6041_lanes[1] * Lambda_4_11_p3;
  const Real Lambda_4_11_p5 = Lambda_0_11_p5534_lanes[2] * Lambda_0_11_p5436_lanes[5] -
      Lambda_0_11_p5348_lanes[2] - Lambda_0_11_p5693_lanes[2] * Lambda_4_11_p1 -
      Lambda_0_11_p5872_lanes[2] * Lambda_4_11_p2 - Lambda_0_11_p6041_lanes[2] * Lambda_4_11_p3;
  const Real Lambda_4_11_p6 = Lambda_4_11_p5 - Lambda_0_11_p6183 * Lambda_4_11_p4;
  const Real Lambda_4_11_p7 = Lambda_0_11_p5534_lanes[3] * Lambda_0_11_p5436_lanes[5] -
      Lambda_0_11_p5348_lanes[3] - Lambda_0_11_p5693_lanes[3] * Lambda_4_11_p1 -
      Lambda_0_11_p5872_lanes[3] * Lambda_4_11_p2 - Lambda_0_11_p6041_lanes[3] * Lambda_4_11_p3;
  const Real Lambda_4_11_p8 = Lambda_4_11_p7 - Lambda_0_11_p6174 * Lambda_4_11_p4 -
      Lambda_0_11_p6190 * Lambda_4_11_p6;
  const Real Lambda_4_11 = Lambda_4_11_p8 * Lambda_11_11;
  Lambda[59] = Lambda_4_11;
  Lambda[136] = Lambda_4_11;
  const Real Lambda_0_4_p1 = Lambda_4_11_p6 * Lambda_0_11_p6189;
  const Real Lambda_0_4_p2 = Lambda_4_11_p4 * Lambda_0_11_p6173;
  const Real Lambda_0_4_p3 = Lambda_4_11_p3 * Lambda_0_11_p6040;
  const Real Lambda_0_4_p4 = Lambda_4_11_p2 * Lambda_0_11_p5871;
  const Real Lambda_0_4_p5 = Lambda_4_11_p1 * Lambda_0_11_p5692;
  const Real Lambda_0_4_p6 = Lambda_0_11_p5436_lanes[5] * Lambda_0_11_p5533;
  const Real Lambda_0_4_p7 = Lambda_0_0_p7 - Lambda_0_4_p6 * Lambda_0_11_p6194 + Lambda_0_4_p5 *
      Lambda_0_11_p6196 + Lambda_0_4_p4 * Lambda_0_11_p6198 + Lambda_0_4_p3 * Lambda_0_11_p6200;
  const Real Lambda_0_4 = Lambda_0_4_p7 + Lambda_0_4_p2 * Lambda_0_11_p6202 + Lambda_0_4_p1 *
      Lambda_0_11_p6205 + Lambda_4_11 * Lambda_0_11_p6208;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_5_11_p1 = Lambda_0_11_p5866 * Lambda_0_11_p5686 - Lambda_0_11_p5697;
  const Real Lambda_5_11_p2 = Lambda_0_11_p5693_lanes[0] * Lambda_0_11_p5686 -
      Lambda_0_11_p5534_lanes[0] - Lambda_0_11_p5872_lanes[0] * Lambda_5_11_p1;
  const Real Lambda_5_11_p3 = Lambda_0_11_p5693_lanes[1] * Lambda_0_11_p5686 -
      Lambda_0_11_p5534_lanes[1] - Lambda_0_11_p5872_lanes[1] * Lambda_5_11_p1 -
      Lambda_0_11_p6041_lanes[1] * Lambda_5_11_p2;
  const Real Lambda_5_11_p4 = Lambda_0_11_p5693_lanes[2] * Lambda_0_11_p5686 -
      Lambda_0_11_p5534_lanes[2] - Lambda_0_11_p5872_lanes[2] * Lambda_5_11_p1 -
      Lambda_0_11_p6041_lanes[2] * Lambda_5_11_p2 - Lambda_0_11_p6183 * Lambda_5_11_p3;
  const Real Lambda_5_11_p5 = Lambda_0_11_p5693_lanes[3] * Lambda_0_11_p5686 -
      Lambda_0_11_p5534_lanes[3] - Lambda_0_11_p5872_lanes[3] * Lambda_5_11_p1 -
      Lambda_0_11_p6041_lanes[3] * Lambda_5_11_p2 - Lambda_0_11_p6174 * Lambda_5_11_p3;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_0_11_p6190 * Lambda_5_11_p4;
  const Real Lambda_5_11 = Lambda_5_11_p6 * Lambda_11_11;
  Lambda[71] = Lambda_5_11;
  Lambda[137] = Lambda_5_11;
  const Real Lambda_0_5_p1 = Lambda_5_11_p4 * Lambda_0_11_p6189;
  const Real Lambda_0_5_p2 = Lambda_5_11_p3 * Lambda_0_11_p6173;
  const Real Lambda_0_5_p3 = Lambda_5_11_p2 * Lambda_0_11_p6040;
  const Real Lambda_0_5_p4 = Lambda_5_11_p1 * Lambda_0_11_p5871;
  const Real Lambda_0_5_p5 = Lambda_0_11_p5686 * Lambda_0_11_p5692;
  const Real Lambda_0_5_p6 = Lambda_0_0_p6 - Lambda_0_5_p5 * Lambda_0_11_p6196 + Lambda_0_5_p4 *
      Lambda_0_11_p6198 + Lambda_0_5_p3 * Lambda_0_11_p6200 + Lambda_0_5_p2 * Lambda_0_11_p6202;
  const Real Lambda_0_5 = Lambda_0_5_p6 + Lambda_0_5_p1 * Lambda_0_11_p6205 + Lambda_5_11 *
      Lambda_0_11_p6208;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_6_11_p1 = Lambda_0_11_p5872_lanes[0] * Lambda_0_11_p5866 -
      Lambda_0_11_p5693_lanes[0];
  const Real Lambda_6_11_p2 = Lambda_0_11_p5872_lanes[1] * Lambda_0_11_p5866 -
      Lambda_0_11_p5693_lanes[1] - Lambda_0_11_p6041_lanes[1] * Lambda_6_11_p1;
  const Real Lambda_6_11_p3 = Lambda_0_11_p5872_lanes[2] * Lambda_0_11_p5866 -
      Lambda_0_11_p5693_lanes[2] - Lambda_0_11_p6041_lanes[2] * Lambda_6_11_p1 - Lambda_0_11_p6183 *
      Lambda_6_11_p2;
  const Real Lambda_6_11_p4 = Lambda_0_11_p5872_lanes[3] * Lambda_0_11_p5866 -
      Lambda_0_11_p5693_lanes[3] - Lambda_0_11_p6041_lanes[3] * Lambda_6_11_p1 - Lambda_0_11_p6174 *
      Lambda_6_11_p2 - Lambda_0_11_p6190 * Lambda_6_11_p3;
  const Real Lambda_6_11 = Lambda_6_11_p4 * Lambda_11_11;
  Lambda[83] = Lambda_6_11;
  Lambda[138] = Lambda_6_11;
  const Real Lambda_0_6_p1 = Lambda_6_11_p3 * Lambda_0_11_p6189;
  const Real Lambda_0_6_p2 = Lambda_6_11_p2 * Lambda_0_11_p6173;
  const Real Lambda_0_6_p3 = Lambda_6_11_p1 * Lambda_0_11_p6040;
  const Real Lambda_0_6_p4 = Lambda_0_11_p5866 * Lambda_0_11_p5871;
  const Real Lambda_0_6_p5 = Lambda_0_0_p5 - Lambda_0_6_p4 * Lambda_0_11_p6198 + Lambda_0_6_p3 *
      Lambda_0_11_p6200 + Lambda_0_6_p2 * Lambda_0_11_p6202 + Lambda_0_6_p1 * Lambda_0_11_p6205;
  const Real Lambda_0_6 = Lambda_0_6_p5 + Lambda_6_11 * Lambda_0_11_p6208;
  Lambda[6] = Lambda_0_6;
  Lambda[72] = Lambda_0_6;
  const Real Lambda_7_11_p1 = Lambda_0_11_p6041_lanes[1] * Lambda_0_11_p5872_lanes[0] -
      Lambda_0_11_p5872_lanes[1];
  const Real Lambda_7_11_p2 = Lambda_0_11_p6041_lanes[2] * Lambda_0_11_p5872_lanes[0] -
      Lambda_0_11_p5872_lanes[2] - Lambda_0_11_p6183 * Lambda_7_11_p1;
  const Real Lambda_7_11_p3 = Lambda_0_11_p6041_lanes[3] * Lambda_0_11_p5872_lanes[0] -
      Lambda_0_11_p5872_lanes[3] - Lambda_0_11_p6174 * Lambda_7_11_p1 - Lambda_0_11_p6190 *
      Lambda_7_11_p2;
  const Real Lambda_7_11 = Lambda_7_11_p3 * Lambda_11_11;
  Lambda[95] = Lambda_7_11;
  Lambda[139] = Lambda_7_11;
  const Real Lambda_0_7_p1 = Lambda_7_11_p2 * Lambda_0_11_p6189;
  const Real Lambda_0_7_p2 = Lambda_7_11_p1 * Lambda_0_11_p6173;
  const Real Lambda_0_7_p3 = Lambda_0_11_p5872_lanes[0] * Lambda_0_11_p6040;
  const Real Lambda_0_7 = Lambda_0_0_p4 - Lambda_0_7_p3 * Lambda_0_11_p6200 + Lambda_0_7_p2 *
      Lambda_0_11_p6202 + Lambda_0_7_p1 * Lambda_0_11_p6205 + Lambda_7_11 * Lambda_0_11_p6208;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_8_11_p1 = Lambda_0_11_p6183 * Lambda_0_11_p6041_lanes[1] -
      Lambda_0_11_p6041_lanes[2];
  const Real Lambda_8_11_p2 = Lambda_0_11_p6174 * Lambda_0_11_p6041_lanes[1] -
      Lambda_0_11_p6041_lanes[3] - Lambda_0_11_p6190 * Lambda_8_11_p1;
  const Real Lambda_8_11 = Lambda_8_11_p2 * Lambda_11_11;
  Lambda[107] = Lambda_8_11;
  Lambda[140] = Lambda_8_11;
  const Real Lambda_0_8_p1 = Lambda_8_11_p1 * Lambda_0_11_p6189;
  const Real Lambda_0_8_p2 = Lambda_0_11_p6041_lanes[1] * Lambda_0_11_p6173;
  const Real Lambda_0_8 = Lambda_0_0_p3 - Lambda_0_8_p2 * Lambda_0_11_p6202 + Lambda_0_8_p1 *
      Lambda_0_11_p6205 + Lambda_8_11 * Lambda_0_11_p6208;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_9_11_p1 = Lambda_0_11_p6190 * Lambda_0_11_p6183 - Lambda_0_11_p6174;
  const Real Lambda_9_11 = Lambda_9_11_p1 * Lambda_11_11;
  Lambda[119] = Lambda_9_11;
  Lambda[141] = Lambda_9_11;
  const Real Lambda_0_9_p1 = Lambda_0_11_p6183 * Lambda_0_11_p6189;
  const Real Lambda_0_9 = Lambda_0_0_p2 - Lambda_0_9_p1 * Lambda_0_11_p6205 + Lambda_9_11 *
      Lambda_0_11_p6208;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_10_11 = Lambda_0_11_p6190 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real Lambda_0_10 = Lambda_0_0_p1 - Lambda_10_11 * Lambda_0_11_p6208;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  const Real Lambda_1_1_p1 = Lambda_0_11_p4756 + Lambda_0_1_p9 * Lambda_0_11_p4821_lanes[2] +
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
  const Real Lambda_2_2_p1 = Lambda_0_11_p4971 + Lambda_0_2_p8 * Lambda_0_11_p5044_lanes[3] +
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
  const Real Lambda_3_3_p1 = Lambda_0_11_p5174 + Lambda_0_3_p7 * Lambda_0_11_p5255_lanes[4] +
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
  const Real Lambda_4_4_p1 = Lambda_0_11_p5347 + Lambda_0_4_p6 * Lambda_0_11_p5436_lanes[5] +
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
  const Real Lambda_5_5_p1 = Lambda_0_11_p5533 + Lambda_0_5_p5 * Lambda_0_11_p5686 + Lambda_0_5_p4 *
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
  const Real Lambda_6_6_p1 = Lambda_0_11_p5692 + Lambda_0_6_p4 * Lambda_0_11_p5866 + Lambda_0_6_p3 *
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
  Lambda[91] = Lambda_0_11_p5871 + Lambda_0_7_p3 * Lambda_0_11_p5872_lanes[0] + Lambda_0_7_p2 *
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
  Lambda[104] = Lambda_0_11_p6040 + Lambda_0_8_p2 * Lambda_0_11_p6041_lanes[1] + Lambda_0_8_p1 *
      Lambda_8_11_p1 + Lambda_8_11 * Lambda_8_11_p2;
  const Real Lambda_8_9 = Lambda_9_11 * Lambda_8_11_p2 -
      (Lambda_0_8_p2 + Lambda_0_9_p1 * Lambda_8_11_p1);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p1 - Lambda_10_11 * Lambda_8_11_p2;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = Lambda_0_11_p6173 + Lambda_0_9_p1 * Lambda_0_11_p6183 + Lambda_9_11 *
      Lambda_9_11_p1;
  const Real Lambda_9_10 = Lambda_0_9_p1 + Lambda_10_11 * Lambda_9_11_p1;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_0_11_p6189 + Lambda_10_11 * Lambda_0_11_p6190;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
