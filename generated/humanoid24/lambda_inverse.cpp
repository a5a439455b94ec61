// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in lanes.
// 6533 flops (add 2756, mul 3745, div 32), sine and cosine of 24 angles
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
  const Lanes<2> Lambda_inv_0_0_p5_lanes = detail::make_pack<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.001742099791326752, 0.001742099791326752) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> Lambda_inv_0_0_p7_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_0_p5_lanes;
  const Lanes<2> Lambda_inv_0_0_p9_lanes = 0.0006340258712020409 + Lambda_inv_0_0_p7_lanes;
  const Lanes<2> inverse_D12_p3_lanes = detail::make_pack<Real>((-0.0007660844555829042),
      (-0.0007660844555829042)) * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(0.0002628975791811551, (-0.0002628975791811551)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> inverse_D12_p4_lanes = detail::make_pack<Real>(s13, s20) * inverse_D12_p3_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / (inverse_D12_p4_lanes -
      detail::make_pack<Real>((-0.0010519177038056625), (-0.0010519177038056625)));
  const Lanes<2> Lambda_inv_0_0_p11_lanes = Lambda_inv_0_0_p9_lanes * inverse_D12_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p15_lanes = detail::make_pack<Real>((-0.00013384878959057754),
      0.00013384878959057754) + detail::make_pack<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> Lambda_inv_0_0_p19_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_inv_0_0_p5_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p23_lanes = detail::make_pack<Real>((-0.00033044389597753786),
      0.00033044389597753786) + Lambda_inv_0_0_p19_lanes + Lambda_inv_0_0_p15_lanes *
      Lambda_inv_0_0_p11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p33_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(s13, s20) - 0.01626499875 *
      detail::make_pack<Real>(c13, c20) - 0.0006000000000000001;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p35_lanes = Lambda_inv_0_0_p33_lanes * inverse_D12_lanes;
  const Lanes<2> Lambda_inv_0_0_p45_lanes = detail::make_pack<Real>((-0.002865001425),
      0.002865001425) * detail::make_pack<Real>(c13, c20) + 0.01626499875 *
      detail::make_pack<Real>(s13, s20) - Lambda_inv_0_0_p15_lanes * Lambda_inv_0_0_p35_lanes;
  const Lanes<2> Lambda_inv_0_0_p49_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_inv_0_0_p23_lanes + detail::make_pack<Real>(c12, c19) * Lambda_inv_0_0_p45_lanes;
  const Lanes<2> Lambda_inv_0_0_p51_lanes = detail::make_pack<Real>(c12, c19) *
      Lambda_inv_0_0_p49_lanes;
  const Lanes<2> Lambda_inv_0_0_p53_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      Lambda_inv_0_0_p51_lanes;
  const Lanes<2> inverse_D11_p1_lanes = Lambda_inv_0_0_p15_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D11_p4_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes -
      Lambda_inv_0_0_p15_lanes * inverse_D11_p1_lanes;
  const Lanes<2> inverse_D11_p6_lanes = detail::make_pack<Real>(s12, s19) *
      (1.16e-05 - inverse_D11_p4_lanes);
  const Lanes<2> inverse_D11_p7_lanes = detail::make_pack<Real>(s12, s19) * inverse_D11_p6_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / (0.00022920000000000001 +
      (inverse_D11_p4_lanes + inverse_D11_p7_lanes));
  const Lanes<2> Lambda_inv_0_0_p55_lanes = Lambda_inv_0_0_p53_lanes * inverse_D11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p59_lanes = Lambda_inv_0_0_p19_lanes -
      detail::make_pack<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p61_lanes = Lambda_inv_0_0_p59_lanes * inverse_D12_lanes;
  const Lanes<2> Lambda_inv_0_0_p67_lanes = Lambda_inv_0_0_p7_lanes -
      detail::make_pack<Real>(0.002376125662528793, 0.002376125662528793) -
      Lambda_inv_0_0_p15_lanes * Lambda_inv_0_0_p61_lanes;
  const Lanes<2> Lambda_inv_0_0_p73_lanes = 0.0006000000000000001 *
      detail::make_pack<Real>(s12, s19) + detail::make_pack<Real>(c12, c19) *
      Lambda_inv_0_0_p67_lanes;
  const Lanes<2> Lambda_inv_0_0_p79_lanes = 0.000144 -
      (detail::make_pack<Real>(c12, c19) * inverse_D11_p6_lanes + 0.269 * Lambda_inv_0_0_p73_lanes);
  const Lanes<2> Lambda_inv_0_0_p83_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_inv_0_0_p49_lanes;
  const Lanes<2> Lambda_inv_0_0_p85_lanes = Lambda_inv_0_0_p33_lanes * Lambda_inv_0_0_p61_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p95_lanes = detail::make_pack<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.27310176737964387), (-0.27310176737964387)) *
      detail::make_pack<Real>(s13, s20);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p101_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_0_p95_lanes - detail::make_pack<Real>((-0.04964593582762564),
      0.04964593582762564) - Lambda_inv_0_0_p9_lanes * Lambda_inv_0_0_p61_lanes;
  const Lanes<2> Lambda_inv_0_0_p105_lanes = detail::make_pack<Real>(c12, c19) *
      Lambda_inv_0_0_p85_lanes + detail::make_pack<Real>(s12, s19) * Lambda_inv_0_0_p101_lanes;
  const Lanes<2> Lambda_inv_0_0_p107_lanes = 0.269 * Lambda_inv_0_0_p105_lanes;
  const Lanes<2> Lambda_inv_0_0_p109_lanes = Lambda_inv_0_0_p83_lanes + Lambda_inv_0_0_p107_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p111_lanes = Lambda_inv_0_0_p79_lanes * Lambda_inv_0_0_p55_lanes -
      Lambda_inv_0_0_p109_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p115_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) +
      0.269 * Lambda_inv_0_0_p51_lanes;
  const Lanes<2> Lambda_inv_0_0_p117_lanes = 6e-04 - Lambda_inv_0_0_p73_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p119_lanes = Lambda_inv_0_0_p117_lanes * inverse_D11_lanes;
  const Lanes<2> Lambda_inv_0_0_p123_lanes = Lambda_inv_0_0_p107_lanes - Lambda_inv_0_0_p115_lanes *
      Lambda_inv_0_0_p119_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p133_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_inv_0_0_p95_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p137_lanes = detail::make_pack<Real>(0.008744893195371809,
      0.008744893195371809) + Lambda_inv_0_0_p133_lanes + Lambda_inv_0_0_p9_lanes *
      Lambda_inv_0_0_p11_lanes;
  const Lanes<2> Lambda_inv_0_0_p139_lanes = Lambda_inv_0_0_p33_lanes * Lambda_inv_0_0_p35_lanes;
  const Lanes<2> Lambda_inv_0_0_p145_lanes = Lambda_inv_0_0_p33_lanes * Lambda_inv_0_0_p11_lanes;
  const Lanes<2> Lambda_inv_0_0_p151_lanes = detail::make_pack<Real>(c12, c19) *
      (2.0 * Lambda_inv_0_0_p145_lanes) - detail::make_pack<Real>(s12, s19) *
      (Lambda_inv_0_0_p137_lanes - Lambda_inv_0_0_p139_lanes);
  const Lanes<2> Lambda_inv_0_0_p153_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_inv_0_0_p151_lanes;
  const Lanes<2> Lambda_inv_0_0_p155_lanes = Lambda_inv_0_0_p153_lanes - Lambda_inv_0_0_p139_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p159_lanes = Lambda_inv_0_0_p115_lanes * Lambda_inv_0_0_p55_lanes -
      0.269 * Lambda_inv_0_0_p155_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p167_lanes = Lambda_inv_0_0_p133_lanes - 0.2818466605750157 -
      Lambda_inv_0_0_p59_lanes * Lambda_inv_0_0_p61_lanes;
  const Lanes<2> Lambda_inv_0_0_p175_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_inv_0_0_p67_lanes - 0.0006000000000000001 * detail::make_pack<Real>(c12, c19);
  const Lanes<2> Lambda_inv_0_0_p177_lanes = 0.269 * Lambda_inv_0_0_p167_lanes -
      Lambda_inv_0_0_p175_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p179_lanes = Lambda_inv_0_0_p177_lanes - Lambda_inv_0_0_p79_lanes *
      Lambda_inv_0_0_p119_lanes;
  const Lanes<2> Lambda_inv_0_0_p185_lanes = detail::make_pack<Real>(s11, s18) *
      (Lambda_inv_0_0_p111_lanes - Lambda_inv_0_0_p123_lanes) + detail::make_pack<Real>(c11, c18) *
      (Lambda_inv_0_0_p159_lanes + Lambda_inv_0_0_p179_lanes);
  const Lanes<2> Lambda_inv_0_0_p187_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_inv_0_0_p185_lanes;
  const Lanes<2> Lambda_inv_0_0_p189_lanes = Lambda_inv_0_0_p123_lanes + Lambda_inv_0_0_p187_lanes;
  const Lanes<2> inverse_D10_p1_lanes = Lambda_inv_0_0_p79_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p7_lanes = 0.000131 - inverse_D11_p7_lanes + 0.269 *
      (Lambda_inv_0_0_p177_lanes - Lambda_inv_0_0_p175_lanes) - Lambda_inv_0_0_p79_lanes *
      inverse_D10_p1_lanes;
  const Lanes<2> inverse_D10_p8_lanes = Lambda_inv_0_0_p115_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p12_lanes = 0.0001098 + 0.07236100000000001 *
      Lambda_inv_0_0_p155_lanes - Lambda_inv_0_0_p115_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p18_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 *
      Lambda_inv_0_0_p109_lanes - Lambda_inv_0_0_p79_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p19_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> inverse_D10_p21_lanes = detail::make_pack<Real>(s11, s18) *
      (inverse_D10_p7_lanes - inverse_D10_p12_lanes) + inverse_D10_p19_lanes *
      inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p22_lanes = detail::make_pack<Real>(s11, s18) * inverse_D10_p21_lanes;
  const Lanes<2> inverse_D10_p24_lanes = 0.060888541114265754 +
      (inverse_D10_p12_lanes + inverse_D10_p22_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_inv_0_0_p191_lanes = Lambda_inv_0_0_p189_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_inv_0_0_p195_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) *
      Lambda_inv_0_0_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p203_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * inverse_D10_p21_lanes -
      inverse_D10_p18_lanes);
  const Lanes<2> Lambda_inv_0_0_p207_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_0_p185_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p213_lanes = 0.28049749700000004 +
      (Lambda_inv_0_0_p207_lanes - Lambda_inv_0_0_p159_lanes) - Lambda_inv_0_0_p203_lanes *
      Lambda_inv_0_0_p191_lanes;
  const Lanes<2> Lambda_inv_0_0_p217_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_0_p195_lanes - detail::make_pack<Real>(s10, s17) * Lambda_inv_0_0_p213_lanes;
  const Lanes<2> Lambda_inv_0_0_p221_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_inv_0_0_p225_lanes = 0.0001499998887063 + Lambda_inv_0_0_p203_lanes *
      Lambda_inv_0_0_p221_lanes;
  const Lanes<2> Lambda_inv_0_0_p227_lanes = 2.0 * detail::make_pack<Real>(c10, c17);
  const Lanes<2> Lambda_inv_0_0_p231_lanes = Lambda_inv_0_0_p203_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_inv_0_0_p239_lanes = 0.06060754126741261 +
      (inverse_D10_p7_lanes - inverse_D10_p22_lanes) - Lambda_inv_0_0_p203_lanes *
      Lambda_inv_0_0_p231_lanes;
  const Lanes<2> Lambda_inv_0_0_p243_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_inv_0_0_p249_lanes = Lambda_inv_0_0_p227_lanes * Lambda_inv_0_0_p225_lanes -
      detail::make_pack<Real>(s10, s17) * (Lambda_inv_0_0_p239_lanes - Lambda_inv_0_0_p243_lanes);
  const Lanes<2> Lambda_inv_0_0_p257_lanes = 0.282 * Lambda_inv_0_0_p217_lanes -
      (Lambda_inv_0_0_p225_lanes - detail::make_pack<Real>(c10, c17) * Lambda_inv_0_0_p249_lanes) -
      0.0005895000784280001;
  const Lanes<2> inverse_D9_p1_lanes = detail::make_pack<Real>(s10, s17) *
      Lambda_inv_0_0_p249_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / (0.0027762933559338653 +
      (Lambda_inv_0_0_p243_lanes - inverse_D9_p1_lanes));
  const Lanes<2> Lambda_inv_0_0_p259_lanes = Lambda_inv_0_0_p257_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_inv_0_0_p261_lanes = Lambda_inv_0_0_p257_lanes * Lambda_inv_0_0_p259_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p267_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_0_p213_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_0_p195_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p273_lanes = Lambda_inv_0_0_p155_lanes - Lambda_inv_0_0_p53_lanes *
      Lambda_inv_0_0_p55_lanes;
  const Lanes<2> Lambda_inv_0_0_p277_lanes = Lambda_inv_0_0_p167_lanes - Lambda_inv_0_0_p117_lanes *
      Lambda_inv_0_0_p119_lanes;
  const Lanes<2> Lambda_inv_0_0_p285_lanes = Lambda_inv_0_0_p53_lanes * Lambda_inv_0_0_p119_lanes -
      Lambda_inv_0_0_p105_lanes;
  const Lanes<2> Lambda_inv_0_0_p289_lanes = detail::make_pack<Real>(s11, s18) *
      (Lambda_inv_0_0_p273_lanes - Lambda_inv_0_0_p277_lanes) + inverse_D10_p19_lanes *
      Lambda_inv_0_0_p285_lanes;
  const Lanes<2> Lambda_inv_0_0_p291_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_inv_0_0_p289_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p295_lanes = Lambda_inv_0_0_p277_lanes + Lambda_inv_0_0_p291_lanes -
      Lambda_inv_0_0_p189_lanes * Lambda_inv_0_0_p191_lanes;
  const Lanes<2> Lambda_inv_0_0_p299_lanes = Lambda_inv_0_0_p267_lanes + 0.282 *
      Lambda_inv_0_0_p295_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p311_lanes = 0.0019585440854647937 +
      (Lambda_inv_0_0_p239_lanes + inverse_D9_p1_lanes + 0.282 *
      (Lambda_inv_0_0_p267_lanes + Lambda_inv_0_0_p299_lanes)) - Lambda_inv_0_0_p261_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p315_lanes = Lambda_inv_0_0_p207_lanes - Lambda_inv_0_0_p179_lanes -
      0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p317_lanes = Lambda_inv_0_0_p315_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_inv_0_0_p319_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * Lambda_inv_0_0_p317_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p325_lanes = detail::make_pack<Real>(s12, s19) *
      Lambda_inv_0_0_p85_lanes - detail::make_pack<Real>(c12, c19) * Lambda_inv_0_0_p101_lanes;
  const Lanes<2> Lambda_inv_0_0_p335_lanes = Lambda_inv_0_0_p83_lanes - Lambda_inv_0_0_p23_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p337_lanes = Lambda_inv_0_0_p335_lanes * inverse_D11_lanes;
  const Lanes<2> Lambda_inv_0_0_p341_lanes = detail::make_pack<Real>(0.001, (-0.001)) +
      (0.269 * Lambda_inv_0_0_p325_lanes - (Lambda_inv_0_0_p51_lanes - Lambda_inv_0_0_p45_lanes)) -
      Lambda_inv_0_0_p79_lanes * Lambda_inv_0_0_p337_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p349_lanes = Lambda_inv_0_0_p145_lanes -
      detail::make_pack<Real>(c12, c19) * Lambda_inv_0_0_p151_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p355_lanes = 0.269 * Lambda_inv_0_0_p349_lanes - 6e-04 -
      Lambda_inv_0_0_p115_lanes * Lambda_inv_0_0_p337_lanes;
  const Lanes<2> Lambda_inv_0_0_p361_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * Lambda_inv_0_0_p341_lanes +
      detail::make_pack<Real>(c11, c18) * Lambda_inv_0_0_p355_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p363_lanes = Lambda_inv_0_0_p361_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_inv_0_0_p373_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_0_p341_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_0_p355_lanes +
      Lambda_inv_0_0_p203_lanes * Lambda_inv_0_0_p363_lanes;
  const Lanes<2> Lambda_inv_0_0_p383_lanes = Lambda_inv_0_0_p111_lanes - Lambda_inv_0_0_p187_lanes -
      Lambda_inv_0_0_p203_lanes * Lambda_inv_0_0_p317_lanes;
  const Lanes<2> Lambda_inv_0_0_p385_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) * Lambda_inv_0_0_p363_lanes;
  const Lanes<2> Lambda_inv_0_0_p391_lanes = detail::make_pack<Real>(c10, c17) *
      (Lambda_inv_0_0_p319_lanes + Lambda_inv_0_0_p373_lanes) - detail::make_pack<Real>(s10, s17) *
      (Lambda_inv_0_0_p383_lanes + Lambda_inv_0_0_p385_lanes);
  const Lanes<2> Lambda_inv_0_0_p393_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_0_p391_lanes;
  const Lanes<2> Lambda_inv_0_0_p395_lanes = Lambda_inv_0_0_p373_lanes - Lambda_inv_0_0_p393_lanes;
  const Lanes<2> Lambda_inv_0_0_p399_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * Lambda_inv_0_0_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p401_lanes = Lambda_inv_0_0_p399_lanes * inverse_D9_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p409_lanes = Lambda_inv_0_0_p53_lanes * Lambda_inv_0_0_p337_lanes -
      Lambda_inv_0_0_p349_lanes;
  const Lanes<2> Lambda_inv_0_0_p415_lanes = Lambda_inv_0_0_p325_lanes - Lambda_inv_0_0_p117_lanes *
      Lambda_inv_0_0_p337_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p421_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_0_p409_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_0_p415_lanes +
      Lambda_inv_0_0_p315_lanes * Lambda_inv_0_0_p363_lanes;
  const Lanes<2> Lambda_inv_0_0_p429_lanes = Lambda_inv_0_0_p273_lanes - Lambda_inv_0_0_p291_lanes -
      Lambda_inv_0_0_p315_lanes * Lambda_inv_0_0_p317_lanes;
  const Lanes<2> Lambda_inv_0_0_p439_lanes = Lambda_inv_0_0_p137_lanes + Lambda_inv_0_0_p153_lanes +
      Lambda_inv_0_0_p335_lanes * Lambda_inv_0_0_p337_lanes + Lambda_inv_0_0_p361_lanes *
      Lambda_inv_0_0_p363_lanes;
  const Lanes<2> Lambda_inv_0_0_p445_lanes = Lambda_inv_0_0_p227_lanes * Lambda_inv_0_0_p421_lanes -
      detail::make_pack<Real>(s10, s17) * (Lambda_inv_0_0_p429_lanes + Lambda_inv_0_0_p439_lanes);
  const Lanes<2> Lambda_inv_0_0_p447_lanes = detail::make_pack<Real>(s10, s17) *
      Lambda_inv_0_0_p445_lanes;
  const Lanes<2> Lambda_inv_0_0_p449_lanes = Lambda_inv_0_0_p429_lanes + Lambda_inv_0_0_p447_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p455_lanes = 0.0008177492704690715 + 0.07952399999999998 *
      Lambda_inv_0_0_p449_lanes - Lambda_inv_0_0_p399_lanes * Lambda_inv_0_0_p401_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p463_lanes = detail::make_pack<Real>(s10, s17) *
      Lambda_inv_0_0_p391_lanes;
  const Lanes<2> Lambda_inv_0_0_p473_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_0_p289_lanes - Lambda_inv_0_0_p285_lanes - Lambda_inv_0_0_p315_lanes *
      Lambda_inv_0_0_p191_lanes;
  const Lanes<2> Lambda_inv_0_0_p485_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_inv_0_0_p409_lanes + detail::make_pack<Real>(c11, c18) * Lambda_inv_0_0_p415_lanes +
      Lambda_inv_0_0_p361_lanes * Lambda_inv_0_0_p191_lanes;
  const Lanes<2> Lambda_inv_0_0_p489_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_0_p473_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_0_p485_lanes;
  const Lanes<2> Lambda_inv_0_0_p491_lanes = 0.282 * Lambda_inv_0_0_p489_lanes;
  const Lanes<2> Lambda_inv_0_0_p493_lanes = Lambda_inv_0_0_p383_lanes + Lambda_inv_0_0_p463_lanes +
      Lambda_inv_0_0_p491_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p499_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * Lambda_inv_0_0_p493_lanes - Lambda_inv_0_0_p257_lanes *
      Lambda_inv_0_0_p401_lanes;
  const Lanes<2> Lambda_inv_0_0_p501_lanes = 2.0 * detail::make_pack<Real>(s9, s16);
  const Lanes<2> Lambda_inv_0_0_p505_lanes = detail::make_pack<Real>(c9, c16) *
      (Lambda_inv_0_0_p311_lanes - Lambda_inv_0_0_p455_lanes) - Lambda_inv_0_0_p501_lanes *
      Lambda_inv_0_0_p499_lanes;
  const Lanes<2> Lambda_inv_0_0_p511_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * Lambda_inv_0_0_p505_lanes + Lambda_inv_0_0_p499_lanes);
  const Lanes<2> inverse_D8_p1_lanes = detail::make_pack<Real>(c9, c16) * Lambda_inv_0_0_p505_lanes;
  const Lanes<2> inverse_D8_p3_lanes = 0.18125194219699997 +
      (Lambda_inv_0_0_p455_lanes + inverse_D8_p1_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p3_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p513_lanes = Lambda_inv_0_0_p385_lanes + Lambda_inv_0_0_p463_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p515_lanes = Lambda_inv_0_0_p513_lanes * inverse_D9_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p523_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_0_p485_lanes - detail::make_pack<Real>(s10, s17) * Lambda_inv_0_0_p473_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p533_lanes = detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) + (0.282 * Lambda_inv_0_0_p523_lanes -
      (Lambda_inv_0_0_p319_lanes - Lambda_inv_0_0_p393_lanes)) + Lambda_inv_0_0_p257_lanes *
      Lambda_inv_0_0_p515_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p541_lanes = Lambda_inv_0_0_p421_lanes -
      detail::make_pack<Real>(c10, c17) * Lambda_inv_0_0_p445_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p547_lanes = 0.0022500062 + 0.282 * Lambda_inv_0_0_p541_lanes +
      Lambda_inv_0_0_p399_lanes * Lambda_inv_0_0_p515_lanes;
  const Lanes<2> Lambda_inv_0_0_p553_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * Lambda_inv_0_0_p533_lanes -
      detail::make_pack<Real>(s9, s16) * Lambda_inv_0_0_p547_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p555_lanes = Lambda_inv_0_0_p553_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_inv_0_0_p565_lanes = Lambda_inv_0_0_p511_lanes * Lambda_inv_0_0_p555_lanes -
      (detail::make_pack<Real>(s9, s16) * Lambda_inv_0_0_p533_lanes +
      detail::make_pack<Real>(c9, c16) * Lambda_inv_0_0_p547_lanes);

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p567_lanes = detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) + Lambda_inv_0_0_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p569_lanes = Lambda_inv_0_0_p567_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_inv_0_0_p573_lanes = Lambda_inv_0_0_p493_lanes + Lambda_inv_0_0_p257_lanes *
      Lambda_inv_0_0_p569_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p575_lanes = Lambda_inv_0_0_p217_lanes - 0.0022500062;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p577_lanes = Lambda_inv_0_0_p575_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_inv_0_0_p581_lanes = Lambda_inv_0_0_p491_lanes + Lambda_inv_0_0_p399_lanes *
      Lambda_inv_0_0_p577_lanes;
  const Lanes<2> Lambda_inv_0_0_p589_lanes = Lambda_inv_0_0_p299_lanes - Lambda_inv_0_0_p257_lanes *
      Lambda_inv_0_0_p577_lanes;
  const Lanes<2> Lambda_inv_0_0_p595_lanes = Lambda_inv_0_0_p399_lanes * Lambda_inv_0_0_p569_lanes -
      0.282 * Lambda_inv_0_0_p449_lanes;
  const Lanes<2> Lambda_inv_0_0_p601_lanes = detail::make_pack<Real>(c9, c16) *
      (Lambda_inv_0_0_p573_lanes + Lambda_inv_0_0_p581_lanes) - detail::make_pack<Real>(s9, s16) *
      (Lambda_inv_0_0_p595_lanes + Lambda_inv_0_0_p589_lanes);
  const Lanes<2> Lambda_inv_0_0_p603_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_inv_0_0_p601_lanes;
  const Lanes<2> Lambda_inv_0_0_p607_lanes = 0.7139200499999999 +
      (Lambda_inv_0_0_p603_lanes + Lambda_inv_0_0_p589_lanes);

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p609_lanes = Lambda_inv_0_0_p607_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_inv_0_0_p611_lanes = 0.00010499999999999999 * Lambda_inv_0_0_p609_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p619_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_0_p601_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p623_lanes = Lambda_inv_0_0_p573_lanes - Lambda_inv_0_0_p619_lanes -
      Lambda_inv_0_0_p511_lanes * Lambda_inv_0_0_p609_lanes;
  const Lanes<2> Lambda_inv_0_0_p625_lanes = 0.00010499999999999999 * Lambda_inv_0_0_p555_lanes;
  const Lanes<2> Lambda_inv_0_0_p631_lanes = detail::make_pack<Real>(c8, c15) *
      (Lambda_inv_0_0_p565_lanes + Lambda_inv_0_0_p611_lanes) - detail::make_pack<Real>(s8, s15) *
      (Lambda_inv_0_0_p625_lanes + Lambda_inv_0_0_p623_lanes);
  const Lanes<2> Lambda_inv_0_0_p633_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_0_p631_lanes;
  const Lanes<2> Lambda_inv_0_0_p637_lanes = 0.0017499999999999998 +
      (Lambda_inv_0_0_p633_lanes - Lambda_inv_0_0_p611_lanes);
  const Lanes<2> inverse_D7_p1_lanes = Lambda_inv_0_0_p511_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p5_lanes = 0.18113119219699997 +
      (Lambda_inv_0_0_p311_lanes - inverse_D8_p1_lanes) - Lambda_inv_0_0_p511_lanes *
      inverse_D7_p1_lanes;
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
  const Lanes<2> Lambda_inv_0_0_p639_lanes = Lambda_inv_0_0_p637_lanes * inverse_D7_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p645_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * inverse_D7_p14_lanes -
      inverse_D7_p11_lanes);
  const Lanes<2> Lambda_inv_0_0_p649_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_0_p631_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p653_lanes = Lambda_inv_0_0_p625_lanes + Lambda_inv_0_0_p649_lanes +
      Lambda_inv_0_0_p645_lanes * Lambda_inv_0_0_p639_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p655_lanes = Lambda_inv_0_0_p619_lanes - Lambda_inv_0_0_p581_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p657_lanes = Lambda_inv_0_0_p655_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_inv_0_0_p661_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * Lambda_inv_0_0_p657_lanes;
  const Lanes<2> Lambda_inv_0_0_p671_lanes = Lambda_inv_0_0_p603_lanes + Lambda_inv_0_0_p595_lanes -
      0.7139200499999999 - Lambda_inv_0_0_p511_lanes * Lambda_inv_0_0_p657_lanes;
  const Lanes<2> Lambda_inv_0_0_p677_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * Lambda_inv_0_0_p661_lanes +
      detail::make_pack<Real>(c8, c15) * Lambda_inv_0_0_p671_lanes);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p679_lanes = Lambda_inv_0_0_p677_lanes * inverse_D7_lanes;
  const Lanes<2> Lambda_inv_0_0_p681_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * Lambda_inv_0_0_p679_lanes;
  const Lanes<2> Lambda_inv_0_0_p695_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_0_p661_lanes - detail::make_pack<Real>(s8, s15) * Lambda_inv_0_0_p671_lanes -
      Lambda_inv_0_0_p645_lanes * Lambda_inv_0_0_p679_lanes;
  const Lanes<2> Lambda_inv_0_0_p697_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * Lambda_inv_0_0_p639_lanes;
  const Lanes<2> Lambda_inv_0_0_p703_lanes = detail::make_pack<Real>(c7, c14) *
      (Lambda_inv_0_0_p653_lanes - Lambda_inv_0_0_p681_lanes) - detail::make_pack<Real>(s7, s14) *
      (Lambda_inv_0_0_p695_lanes - Lambda_inv_0_0_p697_lanes);
  const Lanes<2> Lambda_inv_0_0_p705_lanes = detail::make_pack<Real>(s7, s14) *
      Lambda_inv_0_0_p703_lanes;
  const Lanes<2> Lambda_inv_0_0_p707_lanes = Lambda_inv_0_0_p697_lanes - Lambda_inv_0_0_p705_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p715_lanes = Lambda_inv_0_0_p449_lanes - Lambda_inv_0_0_p567_lanes *
      Lambda_inv_0_0_p569_lanes;
  const Lanes<2> Lambda_inv_0_0_p719_lanes = Lambda_inv_0_0_p295_lanes - Lambda_inv_0_0_p575_lanes *
      Lambda_inv_0_0_p577_lanes;
  const Lanes<2> Lambda_inv_0_0_p727_lanes = Lambda_inv_0_0_p489_lanes + Lambda_inv_0_0_p567_lanes *
      Lambda_inv_0_0_p577_lanes;
  const Lanes<2> Lambda_inv_0_0_p731_lanes = detail::make_pack<Real>(c9, c16) *
      (Lambda_inv_0_0_p715_lanes - Lambda_inv_0_0_p719_lanes) - Lambda_inv_0_0_p501_lanes *
      Lambda_inv_0_0_p727_lanes;
  const Lanes<2> Lambda_inv_0_0_p733_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_0_p731_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p739_lanes = Lambda_inv_0_0_p719_lanes + Lambda_inv_0_0_p733_lanes -
      Lambda_inv_0_0_p655_lanes * Lambda_inv_0_0_p657_lanes - Lambda_inv_0_0_p677_lanes *
      Lambda_inv_0_0_p679_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p747_lanes = Lambda_inv_0_0_p541_lanes + Lambda_inv_0_0_p567_lanes *
      Lambda_inv_0_0_p515_lanes;
  const Lanes<2> Lambda_inv_0_0_p753_lanes = Lambda_inv_0_0_p523_lanes + Lambda_inv_0_0_p575_lanes *
      Lambda_inv_0_0_p515_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p759_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_inv_0_0_p747_lanes - detail::make_pack<Real>(c9, c16) * Lambda_inv_0_0_p753_lanes +
      Lambda_inv_0_0_p553_lanes * Lambda_inv_0_0_p609_lanes;
  const Lanes<2> Lambda_inv_0_0_p767_lanes = Lambda_inv_0_0_p715_lanes - Lambda_inv_0_0_p733_lanes -
      Lambda_inv_0_0_p607_lanes * Lambda_inv_0_0_p609_lanes;
  const Lanes<2> Lambda_inv_0_0_p777_lanes = Lambda_inv_0_0_p439_lanes + Lambda_inv_0_0_p447_lanes +
      Lambda_inv_0_0_p513_lanes * Lambda_inv_0_0_p515_lanes + Lambda_inv_0_0_p553_lanes *
      Lambda_inv_0_0_p555_lanes;
  const Lanes<2> Lambda_inv_0_0_p783_lanes = inverse_D7_p12_lanes * Lambda_inv_0_0_p759_lanes -
      detail::make_pack<Real>(s8, s15) * (Lambda_inv_0_0_p777_lanes + Lambda_inv_0_0_p767_lanes);
  const Lanes<2> Lambda_inv_0_0_p785_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_0_p783_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p789_lanes = Lambda_inv_0_0_p777_lanes + Lambda_inv_0_0_p785_lanes +
      Lambda_inv_0_0_p637_lanes * Lambda_inv_0_0_p639_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p805_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_0_p747_lanes + detail::make_pack<Real>(s9, s16) * Lambda_inv_0_0_p753_lanes +
      Lambda_inv_0_0_p553_lanes * Lambda_inv_0_0_p657_lanes;
  const Lanes<2> Lambda_inv_0_0_p815_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_inv_0_0_p731_lanes + Lambda_inv_0_0_p727_lanes - Lambda_inv_0_0_p607_lanes *
      Lambda_inv_0_0_p657_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p821_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_0_p805_lanes - detail::make_pack<Real>(s8, s15) * Lambda_inv_0_0_p815_lanes -
      Lambda_inv_0_0_p677_lanes * Lambda_inv_0_0_p639_lanes;
  const Lanes<2> Lambda_inv_0_0_p823_lanes = 2.0 * detail::make_pack<Real>(s7, s14);
  const Lanes<2> Lambda_inv_0_0_p827_lanes = detail::make_pack<Real>(c7, c14) *
      (Lambda_inv_0_0_p739_lanes + Lambda_inv_0_0_p789_lanes) - Lambda_inv_0_0_p823_lanes *
      Lambda_inv_0_0_p821_lanes;
  const Lanes<2> Lambda_inv_0_0_p829_lanes = detail::make_pack<Real>(c7, c14) *
      Lambda_inv_0_0_p827_lanes;
  const Lanes<2> Lambda_inv_0_0_p831_lanes = Lambda_inv_0_0_p739_lanes - Lambda_inv_0_0_p829_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p835_lanes = Lambda_inv_0_0_p623_lanes + Lambda_inv_0_0_p649_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p837_lanes = Lambda_inv_0_0_p835_lanes * inverse_D7_lanes;
  const Lanes<2> Lambda_inv_0_0_p847_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_0_p805_lanes + detail::make_pack<Real>(c8, c15) * Lambda_inv_0_0_p815_lanes -
      Lambda_inv_0_0_p677_lanes * Lambda_inv_0_0_p837_lanes;
  const Lanes<2> Lambda_inv_0_0_p857_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_0_p783_lanes - Lambda_inv_0_0_p759_lanes - Lambda_inv_0_0_p637_lanes *
      Lambda_inv_0_0_p837_lanes;
  const Lanes<2> Lambda_inv_0_0_p861_lanes = detail::make_pack<Real>(s7, s14) *
      Lambda_inv_0_0_p847_lanes + detail::make_pack<Real>(c7, c14) * Lambda_inv_0_0_p857_lanes;
  const Lanes<2> Lambda_inv_0_0_p867_lanes = Lambda_inv_0_0_p707_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * Lambda_inv_0_0_p831_lanes + 0.226 *
      Lambda_inv_0_0_p861_lanes);

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p869_lanes = 0.0007770270270270272 *
      detail::make_pack<Real>(c23, c24);
  const Lanes<2> Lambda_inv_0_0_p871_lanes = detail::make_pack<Real>(c23, c24) *
      Lambda_inv_0_0_p869_lanes;
  const Lanes<2> Lambda_inv_0_0_p873_lanes = Lambda_inv_0_0_p871_lanes - 0.0007770270270270272;
  const Real Lambda_inv_0_0_p875 = 0.431222972972973 + Lambda_inv_0_0_p871_lanes[1] +
      Lambda_inv_0_0_p873_lanes[0];
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> inverse_D22_p3_lanes = detail::make_pack<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Real inverse_D22_p5 = inverse_D22_p3_lanes[1] + inverse_D22_p3_lanes[0];
  const Real inverse_D22_p6 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p5 + 4.75e-05 * inverse_D22_p6);
  const Real Lambda_inv_0_0_p876 = Lambda_inv_0_0_p875 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p879_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes) * detail::make_pack<Real>(c23, c24);
  const Real Lambda_inv_0_0_p881 = s24 + s23;
  const Real Lambda_inv_0_0_p882 = Lambda_inv_0_0_p879_lanes[0] + 2.375e-05 * Lambda_inv_0_0_p881 +
      Lambda_inv_0_0_p879_lanes[1];
  const Lanes<2> Lambda_inv_0_0_p883_lanes = detail::make_pack<Real>(s23, s24) *
      Lambda_inv_0_0_p869_lanes;
  const Real Lambda_inv_0_0_p885 = Lambda_inv_0_0_p883_lanes[1] + Lambda_inv_0_0_p883_lanes[0];

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p886 = Lambda_inv_0_0_p882 * Lambda_inv_0_0_p876 - Lambda_inv_0_0_p885;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p887_lanes = detail::make_pack<Real>(0.032, (-0.032)) *
      Lambda_inv_0_0_p873_lanes;
  const Real Lambda_inv_0_0_p889 = Lambda_inv_0_0_p887_lanes[1] + Lambda_inv_0_0_p887_lanes[0] -
      0.095 * Lambda_inv_0_0_p885;
  const Real Lambda_inv_0_0_p890 = 0.072575 + 0.00025 * inverse_D22_p6;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p891 = Lambda_inv_0_0_p890 * inverse_D22;
  const Real Lambda_inv_0_0_p892 = Lambda_inv_0_0_p889 * Lambda_inv_0_0_p891;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p893_lanes = 0.006756756756756757 *
      detail::make_pack<Real>(s23, s24);
  const Lanes<2> Lambda_inv_0_0_p895_lanes = detail::make_pack<Real>(c23, c24) *
      Lambda_inv_0_0_p893_lanes;
  const Lanes<2> Lambda_inv_0_0_p899_lanes = detail::make_pack<Real>(s23, s24) *
      Lambda_inv_0_0_p893_lanes;
  const Lanes<2> Lambda_inv_0_0_p903_lanes = 0.095 * Lambda_inv_0_0_p895_lanes +
      detail::make_pack<Real>(0.032, (-0.032)) * Lambda_inv_0_0_p899_lanes;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p905 = Lambda_inv_0_0_p903_lanes[1] + Lambda_inv_0_0_p903_lanes[0] +
      Lambda_inv_0_0_p889 * Lambda_inv_0_0_p876;
  const Real Lambda_inv_0_0_p906 = Lambda_inv_0_0_p882 * Lambda_inv_0_0_p891 - 0.00025 *
      Lambda_inv_0_0_p881;
  const Real Lambda_inv_0_0_p907 = s22 * (Lambda_inv_0_0_p886 + Lambda_inv_0_0_p892) + c22 *
      (Lambda_inv_0_0_p906 - Lambda_inv_0_0_p905);
  const Real Lambda_inv_0_0_p908 = s22 * Lambda_inv_0_0_p907;
  const Real Lambda_inv_0_0_p909 = Lambda_inv_0_0_p908 - Lambda_inv_0_0_p892;
  const Real inverse_D21_p1 = Lambda_inv_0_0_p889 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> inverse_D21_p2_lanes = Lambda_inv_0_0_p899_lanes - 0.006756756756756757;
  const Lanes<2> inverse_D21_p8_lanes = 0.095 * inverse_D21_p2_lanes -
      detail::make_pack<Real>(0.032, (-0.032)) * Lambda_inv_0_0_p895_lanes;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p10 = inverse_D21_p8_lanes[1] + inverse_D21_p8_lanes[0];
  const Real inverse_D21_p11 = 0.009438624999999999 - (-0.032) * Lambda_inv_0_0_p903_lanes[1] -
      0.032 * Lambda_inv_0_0_p903_lanes[0] - Lambda_inv_0_0_p889 * inverse_D21_p1 + 0.095 *
      inverse_D21_p10;
  const Real inverse_D21_p12 = 0.05450270000000001 + inverse_D22_p5 + (-1.6e-05) * s24 + 1.6e-05 *
      s23 - Lambda_inv_0_0_p882 * Lambda_inv_0_0_p882 * inverse_D22;
  const Real inverse_D21_p13 = inverse_D21_p12 - 0.00017071621621621625;
  const Real inverse_D21_p14 = Lambda_inv_0_0_p871_lanes[1] + Lambda_inv_0_0_p871_lanes[0];
  const Real inverse_D21_p15 = 0.0074 - (-0.032) * Lambda_inv_0_0_p883_lanes[1] - 0.032 *
      Lambda_inv_0_0_p883_lanes[0] + Lambda_inv_0_0_p882 * inverse_D21_p1 - 0.095 * inverse_D21_p14;
  const Real inverse_D21_p16 = 2.0 * c22;
  const Real inverse_D21_p17 = s22 * (inverse_D21_p13 - inverse_D21_p11) + inverse_D21_p16 *
      inverse_D21_p15;
  const Real inverse_D21_p18 = s22 * inverse_D21_p17;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p11 + inverse_D21_p18));
  const Real Lambda_inv_0_0_p910 = Lambda_inv_0_0_p909 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p911 = Lambda_inv_0_0_p885 * inverse_D22;
  const Real Lambda_inv_0_0_p912 = 0.072575 + inverse_D21_p10 + Lambda_inv_0_0_p889 *
      Lambda_inv_0_0_p911;
  const Real Lambda_inv_0_0_p913 = inverse_D21_p14 - 0.43200000000000005 + Lambda_inv_0_0_p882 *
      Lambda_inv_0_0_p911;
  const Real Lambda_inv_0_0_p914 = c22 * Lambda_inv_0_0_p912 - s22 * Lambda_inv_0_0_p913;
  const Real Lambda_inv_0_0_p915 = 0.0016155 + (c22 * inverse_D21_p17 - inverse_D21_p15 + 0.394 *
      Lambda_inv_0_0_p914);
  const Real Lambda_inv_0_0_p916 = c22 * Lambda_inv_0_0_p907;
  const Real Lambda_inv_0_0_p917 = Lambda_inv_0_0_p890 * Lambda_inv_0_0_p911;
  const Real Lambda_inv_0_0_p918 = Lambda_inv_0_0_p895_lanes[1] + Lambda_inv_0_0_p895_lanes[0] -
      Lambda_inv_0_0_p875 * Lambda_inv_0_0_p911;
  const Real Lambda_inv_0_0_p919 = c22 * Lambda_inv_0_0_p917 - s22 * Lambda_inv_0_0_p918;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p920 = Lambda_inv_0_0_p915 * Lambda_inv_0_0_p910 -
      (Lambda_inv_0_0_p916 + Lambda_inv_0_0_p905 + 0.394 * Lambda_inv_0_0_p919);

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p921 = Lambda_inv_0_0_p916 - Lambda_inv_0_0_p906;
  const Real Lambda_inv_0_0_p922 = 0.394 * Lambda_inv_0_0_p921;
  const Real Lambda_inv_0_0_p923 = Lambda_inv_0_0_p875 * Lambda_inv_0_0_p891;
  const Real Lambda_inv_0_0_p924 = Lambda_inv_0_0_p899_lanes[1] + Lambda_inv_0_0_p899_lanes[0] +
      Lambda_inv_0_0_p875 * Lambda_inv_0_0_p876;
  const Real Lambda_inv_0_0_p925 = Lambda_inv_0_0_p890 * Lambda_inv_0_0_p891;
  const Real Lambda_inv_0_0_p926 = inverse_D21_p16 * Lambda_inv_0_0_p923 - s22 *
      (Lambda_inv_0_0_p925 - Lambda_inv_0_0_p924);
  const Real Lambda_inv_0_0_p927 = Lambda_inv_0_0_p923 - c22 * Lambda_inv_0_0_p926;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p928 = Lambda_inv_0_0_p922 * Lambda_inv_0_0_p910 -
      (0.0045000000000000005 + 0.394 * Lambda_inv_0_0_p927);

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p929 = c21 * Lambda_inv_0_0_p920 - s21 * Lambda_inv_0_0_p928 +
      Lambda_inv_0_0_p867_lanes[1] + Lambda_inv_0_0_p867_lanes[0];
  const Lanes<2> inverse_D6_p3_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (Lambda_inv_0_0_p707_lanes + Lambda_inv_0_0_p867_lanes);
  const Lanes<2> inverse_D6_p5_lanes = Lambda_inv_0_0_p645_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p13_lanes = 0.0002975 + (inverse_D7_p7_lanes - inverse_D7_p15_lanes) -
      Lambda_inv_0_0_p645_lanes * inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p15_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p17_lanes;
  const Lanes<2> inverse_D6_p17_lanes = 0.0001505 - inverse_D6_p15_lanes;
  const Lanes<2> inverse_D6_p25_lanes = 8.75e-06 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p29_lanes = detail::make_pack<Real>(c7, c14) *
      (inverse_D6_p17_lanes - inverse_D6_p13_lanes) + Lambda_inv_0_0_p823_lanes *
      inverse_D6_p25_lanes;
  const Lanes<2> inverse_D6_p31_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p29_lanes;
  const Real inverse_D6_p33 = inverse_D6_p31_lanes[1] + inverse_D6_p31_lanes[0];

  // link 22 (head), articulated inertia
  const Real inverse_D6_p34 = c22 * Lambda_inv_0_0_p913 + s22 * Lambda_inv_0_0_p912;
  const Real inverse_D6_p35 = inverse_D21_p2_lanes[1] + inverse_D21_p2_lanes[0] -
      Lambda_inv_0_0_p885 * Lambda_inv_0_0_p911;
  const Real inverse_D6_p36 = inverse_D6_p34 - 0.394 * inverse_D6_p35;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p37 = 0.005513625 + (inverse_D21_p13 - inverse_D21_p18 - 0.394 *
      (inverse_D6_p34 + inverse_D6_p36)) - Lambda_inv_0_0_p915 *
      (Lambda_inv_0_0_p915 * inverse_D21);
  const Real inverse_D6_p38 = Lambda_inv_0_0_p922 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p39 = s22 * Lambda_inv_0_0_p926;
  const Real inverse_D6_p40 = inverse_D6_p39 - Lambda_inv_0_0_p924;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p41 = 0.000703125 + 0.155236 * inverse_D6_p40 - Lambda_inv_0_0_p922 *
      inverse_D6_p38;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p42 = c22 * Lambda_inv_0_0_p918 + s22 * Lambda_inv_0_0_p917;
  const Real inverse_D6_p43 = 0.394 * inverse_D6_p42;
  const Real inverse_D6_p44 = Lambda_inv_0_0_p886 - Lambda_inv_0_0_p908 - inverse_D6_p43;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p45 = 0.394 * inverse_D6_p44 - Lambda_inv_0_0_p915 * inverse_D6_p38;
  const Real inverse_D6_p46 = 2.0 * s21;
  const Real inverse_D6_p47 = c21 * (inverse_D6_p37 - inverse_D6_p41) - inverse_D6_p46 *
      inverse_D6_p45;
  const Real inverse_D6_p48 = c21 * inverse_D6_p47;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p51_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) *
      Lambda_inv_0_0_p837_lanes;
  const Lanes<2> inverse_D6_p61_lanes = Lambda_inv_0_0_p633_lanes - Lambda_inv_0_0_p565_lanes -
      0.0017499999999999998 - Lambda_inv_0_0_p645_lanes * Lambda_inv_0_0_p837_lanes;
  const Lanes<2> inverse_D6_p65_lanes = detail::make_pack<Real>(c7, c14) * inverse_D6_p51_lanes +
      detail::make_pack<Real>(s7, s14) * inverse_D6_p61_lanes;
  const Lanes<2> inverse_D6_p73_lanes = Lambda_inv_0_0_p767_lanes + Lambda_inv_0_0_p785_lanes -
      Lambda_inv_0_0_p835_lanes * Lambda_inv_0_0_p837_lanes;
  const Lanes<2> inverse_D6_p79_lanes = inverse_D6_p65_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * Lambda_inv_0_0_p861_lanes + 0.226 *
      inverse_D6_p73_lanes);
  const Real inverse_D6_p81 = inverse_D6_p79_lanes[1] + inverse_D6_p79_lanes[0];
  const Real inverse_D6_p82 = 2.06965463592404 + inverse_D6_p41 + inverse_D6_p48 +
      inverse_D6_p13_lanes[1] + inverse_D6_p33 + inverse_D6_p3_lanes[1] + inverse_D6_p13_lanes[0] +
      inverse_D6_p3_lanes[0] + 0.226 * (inverse_D6_p65_lanes[1] + inverse_D6_p81 +
      inverse_D6_p65_lanes[0]);

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p82;
  const Real Lambda_inv_0_0_p930 = Lambda_inv_0_0_p929 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p931_lanes = detail::make_pack<Real>(c7, c14) *
      Lambda_inv_0_0_p703_lanes;
  const Lanes<2> Lambda_inv_0_0_p937_lanes = detail::make_pack<Real>(s7, s14) *
      Lambda_inv_0_0_p827_lanes + Lambda_inv_0_0_p821_lanes;
  const Lanes<2> Lambda_inv_0_0_p939_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      Lambda_inv_0_0_p937_lanes;
  const Lanes<2> Lambda_inv_0_0_p945_lanes = detail::make_pack<Real>(c7, c14) *
      Lambda_inv_0_0_p847_lanes - detail::make_pack<Real>(s7, s14) * Lambda_inv_0_0_p857_lanes;
  const Lanes<2> Lambda_inv_0_0_p947_lanes = 0.226 * Lambda_inv_0_0_p945_lanes;
  const Lanes<2> Lambda_inv_0_0_p951_lanes = Lambda_inv_0_0_p931_lanes - Lambda_inv_0_0_p653_lanes -
      (Lambda_inv_0_0_p939_lanes + Lambda_inv_0_0_p947_lanes);
  const Lanes<2> Lambda_inv_0_0_p953_lanes = Lambda_inv_0_0_p681_lanes + Lambda_inv_0_0_p931_lanes;
  const Lanes<2> Lambda_inv_0_0_p957_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (Lambda_inv_0_0_p951_lanes + Lambda_inv_0_0_p953_lanes);
  const Lanes<2> Lambda_inv_0_0_p959_lanes = detail::make_pack<Real>(s7, s14) *
      inverse_D6_p29_lanes;
  const Lanes<2> Lambda_inv_0_0_p965_lanes = detail::make_pack<Real>(s7, s14) *
      inverse_D6_p51_lanes - detail::make_pack<Real>(c7, c14) * inverse_D6_p61_lanes;
  const Real Lambda_inv_0_0_p967 = Lambda_inv_0_0_p965_lanes[1] + Lambda_inv_0_0_p965_lanes[0];
  const Real Lambda_inv_0_0_p968 = 0.0187369177636143 + Lambda_inv_0_0_p957_lanes[1] -
      inverse_D6_p25_lanes[1] + Lambda_inv_0_0_p959_lanes[1] + Lambda_inv_0_0_p957_lanes[0] -
      inverse_D6_p25_lanes[0] + Lambda_inv_0_0_p959_lanes[0] + 0.226 * Lambda_inv_0_0_p967;
  const Lanes<2> Lambda_inv_0_0_p969_lanes = Lambda_inv_0_0_p939_lanes - Lambda_inv_0_0_p953_lanes;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p971 = Lambda_inv_0_0_p969_lanes[1] + Lambda_inv_0_0_p969_lanes[0] +
      Lambda_inv_0_0_p968 * Lambda_inv_0_0_p930;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p972 = Lambda_inv_0_0_p951_lanes[1] + Lambda_inv_0_0_p951_lanes[0];
  const Real Lambda_inv_0_0_p973 = s21 * inverse_D6_p47 + inverse_D6_p45 + 0.226 *
      Lambda_inv_0_0_p972;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p974 = Lambda_inv_0_0_p921 * inverse_D21;
  const Real Lambda_inv_0_0_p975 = inverse_D6_p44 - Lambda_inv_0_0_p915 * Lambda_inv_0_0_p974;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p976 = 0.0045000000000000005 + Lambda_inv_0_0_p914;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p977 = Lambda_inv_0_0_p976 * inverse_D21;
  const Real Lambda_inv_0_0_p978 = inverse_D6_p43 + Lambda_inv_0_0_p922 * Lambda_inv_0_0_p977;
  const Real Lambda_inv_0_0_p979 = 0.394 * inverse_D6_p40 - Lambda_inv_0_0_p922 *
      Lambda_inv_0_0_p974;
  const Real Lambda_inv_0_0_p980 = inverse_D6_p36 + Lambda_inv_0_0_p915 * Lambda_inv_0_0_p977;
  const Real Lambda_inv_0_0_p981 = c21 * (Lambda_inv_0_0_p975 - Lambda_inv_0_0_p978) - s21 *
      (Lambda_inv_0_0_p979 + Lambda_inv_0_0_p980);
  const Real Lambda_inv_0_0_p982 = s21 * Lambda_inv_0_0_p981;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p983 = Lambda_inv_0_0_p982 + Lambda_inv_0_0_p980 - 6.1665928899999995 -
      inverse_D6_p81;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p984 = Lambda_inv_0_0_p983 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p985 = c21 * Lambda_inv_0_0_p981;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p986 = Lambda_inv_0_0_p975 - Lambda_inv_0_0_p985 +
      Lambda_inv_0_0_p947_lanes[1] + Lambda_inv_0_0_p947_lanes[0] - Lambda_inv_0_0_p973 *
      Lambda_inv_0_0_p984;
  const Real Lambda_inv_0_0_p987 = Lambda_inv_0_0_p937_lanes[1] + Lambda_inv_0_0_p937_lanes[0];
  const Real Lambda_inv_0_0_p988 = Lambda_inv_0_0_p973 * Lambda_inv_0_0_p930 -
      (s21 * Lambda_inv_0_0_p920 + c21 * Lambda_inv_0_0_p928) + 0.226 * Lambda_inv_0_0_p987;
  const Real Lambda_inv_0_0_p989 = (-0.18) * Lambda_inv_0_0_p945_lanes[1] - Lambda_inv_0_0_p967 +
      0.18 * Lambda_inv_0_0_p945_lanes[0] - Lambda_inv_0_0_p968 * Lambda_inv_0_0_p984;
  const Real Lambda_inv_0_0_p990 = s6 * (Lambda_inv_0_0_p971 - Lambda_inv_0_0_p986) + c6 *
      (Lambda_inv_0_0_p988 + Lambda_inv_0_0_p989);
  const Real Lambda_inv_0_0_p991 = s6 * Lambda_inv_0_0_p990;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p992 = Lambda_inv_0_0_p978 + Lambda_inv_0_0_p985 + Lambda_inv_0_0_p972;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p993 = Lambda_inv_0_0_p992 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p994 = Lambda_inv_0_0_p921 * Lambda_inv_0_0_p910 - Lambda_inv_0_0_p927;
  const Real Lambda_inv_0_0_p995 = Lambda_inv_0_0_p919 - Lambda_inv_0_0_p976 * Lambda_inv_0_0_p910;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p996 = Lambda_inv_0_0_p987 - c21 * Lambda_inv_0_0_p994 + s21 *
      Lambda_inv_0_0_p995 + Lambda_inv_0_0_p929 * Lambda_inv_0_0_p993;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p997 = inverse_D6_p40 - Lambda_inv_0_0_p921 * Lambda_inv_0_0_p974;
  const Real Lambda_inv_0_0_p998 = inverse_D6_p35 - Lambda_inv_0_0_p976 * Lambda_inv_0_0_p977;
  const Real Lambda_inv_0_0_p999 = inverse_D6_p42 + Lambda_inv_0_0_p921 * Lambda_inv_0_0_p977;
  const Real Lambda_inv_0_0_p1000 = c21 * (Lambda_inv_0_0_p997 - Lambda_inv_0_0_p998) -
      inverse_D6_p46 * Lambda_inv_0_0_p999;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p1001 = s21 * Lambda_inv_0_0_p1000 + Lambda_inv_0_0_p999 +
      Lambda_inv_0_0_p945_lanes[1] + Lambda_inv_0_0_p945_lanes[0] - Lambda_inv_0_0_p983 *
      Lambda_inv_0_0_p993;
  const Real Lambda_inv_0_0_p1002 = s6 * Lambda_inv_0_0_p996 + c6 * Lambda_inv_0_0_p1001;
  const Real Lambda_inv_0_0_p1003 = 0.072 * Lambda_inv_0_0_p1002;
  const Real Lambda_inv_0_0_p1004 = Lambda_inv_0_0_p986 + Lambda_inv_0_0_p991 +
      Lambda_inv_0_0_p1003;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p1_lanes = Lambda_inv_0_0_p705_lanes + Lambda_inv_0_0_p695_lanes;
  const Lanes<2> inverse_D5_p3_lanes = Lambda_inv_0_0_p829_lanes - Lambda_inv_0_0_p789_lanes;
  const Lanes<2> inverse_D5_p7_lanes = inverse_D5_p1_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * inverse_D5_p3_lanes;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p9 = inverse_D5_p7_lanes[1] + inverse_D5_p7_lanes[0] - Lambda_inv_0_0_p968 *
      Lambda_inv_0_0_p993;
  const Real inverse_D5_p10 = inverse_D5_p3_lanes[1] + inverse_D5_p3_lanes[0];
  const Real inverse_D5_p11 = 6.1665928899999995 + Lambda_inv_0_0_p982 + Lambda_inv_0_0_p979 -
      Lambda_inv_0_0_p973 * Lambda_inv_0_0_p993 + 0.226 * inverse_D5_p10;
  const Real inverse_D5_p12 = s6 * inverse_D5_p9 + c6 * inverse_D5_p11;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p13 = c21 * Lambda_inv_0_0_p1000;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p14 = Lambda_inv_0_0_p998 + inverse_D5_p13 + inverse_D5_p10 -
      Lambda_inv_0_0_p992 * Lambda_inv_0_0_p993;
  const Real inverse_D5_p15 = inverse_D5_p12 + 0.072 * inverse_D5_p14;
  const Real inverse_D5_p16 = Lambda_inv_0_0_p968 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D5_p19_lanes = detail::make_pack<Real>(0.18, (-0.18)) *
      (inverse_D5_p1_lanes + inverse_D5_p7_lanes);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p21 = 0.40056549999999996 - inverse_D6_p15_lanes[1] - inverse_D6_p33 +
      inverse_D5_p19_lanes[1] + inverse_D6_p17_lanes[0] + inverse_D5_p19_lanes[0] -
      Lambda_inv_0_0_p968 * inverse_D5_p16;
  const Real inverse_D5_p22 = Lambda_inv_0_0_p973 * inverse_D6;
  const Real inverse_D5_p23 = 1.66923963592404 + inverse_D6_p37 - inverse_D6_p48 -
      Lambda_inv_0_0_p973 * inverse_D5_p22 + 0.051076 * inverse_D5_p10;
  const Real inverse_D5_p24 = (-0.04068) * inverse_D5_p3_lanes[1] + 0.04068 *
      inverse_D5_p3_lanes[0] - Lambda_inv_0_0_p968 * inverse_D5_p22 + 0.226 *
      (inverse_D5_p1_lanes[1] + inverse_D5_p1_lanes[0]);
  const Real inverse_D5_p25 = 2.0 * c6;
  const Real inverse_D5_p26 = s6 * (inverse_D5_p21 - inverse_D5_p23) + inverse_D5_p25 *
      inverse_D5_p24;
  const Real inverse_D5_p27 = s6 * inverse_D5_p26;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p23 + inverse_D5_p27 + 0.072 * (inverse_D5_p12 + inverse_D5_p15)));
  const Real Lambda_inv_0_0_p1005 = Lambda_inv_0_0_p1004 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p1006 = 0.072 * Lambda_inv_0_0_p1004;
  const Real Lambda_inv_0_0_p1007 = Lambda_inv_0_0_p831_lanes[1] -
      (Lambda_inv_0_0_p925 + inverse_D6_p39 + Lambda_inv_0_0_p909 * Lambda_inv_0_0_p910) +
      Lambda_inv_0_0_p831_lanes[0] - Lambda_inv_0_0_p929 * Lambda_inv_0_0_p930;
  const Real Lambda_inv_0_0_p1008 = Lambda_inv_0_0_p997 - inverse_D5_p13 + inverse_D6_p73_lanes[1] +
      inverse_D6_p73_lanes[0] - Lambda_inv_0_0_p983 * Lambda_inv_0_0_p984;
  const Real Lambda_inv_0_0_p1009 = Lambda_inv_0_0_p861_lanes[1] -
      (s21 * Lambda_inv_0_0_p994 + c21 * Lambda_inv_0_0_p995) + Lambda_inv_0_0_p861_lanes[0] +
      Lambda_inv_0_0_p929 * Lambda_inv_0_0_p984;
  const Real Lambda_inv_0_0_p1010 = s6 * (Lambda_inv_0_0_p1007 - Lambda_inv_0_0_p1008) +
      inverse_D5_p25 * Lambda_inv_0_0_p1009;
  const Real Lambda_inv_0_0_p1011 = s6 * Lambda_inv_0_0_p1010;
  const Real Lambda_inv_0_0_p1012 = Lambda_inv_0_0_p1008 + Lambda_inv_0_0_p1011;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1013 = Lambda_inv_0_0_p1006 * Lambda_inv_0_0_p1005 -
      (2.2194301519999997 + 0.072 * Lambda_inv_0_0_p1012);

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p1014 = c6 * inverse_D5_p9 - s6 * inverse_D5_p11;
  const Real Lambda_inv_0_0_p1015 = c6 * inverse_D5_p26 - inverse_D5_p24 + 0.072 *
      Lambda_inv_0_0_p1014;
  const Real Lambda_inv_0_0_p1016 = c6 * Lambda_inv_0_0_p990;
  const Real Lambda_inv_0_0_p1017 = Lambda_inv_0_0_p1016 - Lambda_inv_0_0_p988;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1018 = Lambda_inv_0_0_p1017 - 0.069699984375 - Lambda_inv_0_0_p1015 *
      Lambda_inv_0_0_p1005;
  const Real Lambda_inv_0_0_p1019 = s5 * Lambda_inv_0_0_p1013 + c5 * Lambda_inv_0_0_p1018;
  const Real Lambda_inv_0_0_p1020 = Lambda_inv_0_0_p1006 * inverse_D5;
  const Real Lambda_inv_0_0_p1021 = 0.15637308509675518 + 0.005183999999999999 *
      Lambda_inv_0_0_p1012 - Lambda_inv_0_0_p1006 * Lambda_inv_0_0_p1020;
  const Real Lambda_inv_0_0_p1022 = Lambda_inv_0_0_p1015 * inverse_D5;
  const Real Lambda_inv_0_0_p1023 = 0.04675382692737882 + (inverse_D5_p21 - inverse_D5_p27) -
      Lambda_inv_0_0_p1015 * Lambda_inv_0_0_p1022;
  const Real Lambda_inv_0_0_p1024 = 0.005678398088837119 - 0.072 * Lambda_inv_0_0_p1017 +
      Lambda_inv_0_0_p1006 * Lambda_inv_0_0_p1022;
  const Real Lambda_inv_0_0_p1025 = 2.0 * c5;
  const Real Lambda_inv_0_0_p1026 = s5 * (Lambda_inv_0_0_p1021 - Lambda_inv_0_0_p1023) +
      Lambda_inv_0_0_p1025 * Lambda_inv_0_0_p1024;
  const Real Lambda_inv_0_0_p1027 = 0.005880002159562879 +
      (0.21799999999999997 * Lambda_inv_0_0_p1019 - (c5 * Lambda_inv_0_0_p1026 -
      Lambda_inv_0_0_p1024));

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p1028 = 2.2194301519999997 + inverse_D5_p15;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1029 = Lambda_inv_0_0_p1028 * inverse_D5;
  const Real Lambda_inv_0_0_p1030 = Lambda_inv_0_0_p1006 * Lambda_inv_0_0_p1029 -
      Lambda_inv_0_0_p1003;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p1031 = c6 * Lambda_inv_0_0_p996 - s6 * Lambda_inv_0_0_p1001;
  const Real Lambda_inv_0_0_p1032 = 0.069699984375 +
      (Lambda_inv_0_0_p1016 - Lambda_inv_0_0_p989 + 0.072 * Lambda_inv_0_0_p1031);

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1033 = Lambda_inv_0_0_p1032 * inverse_D5;
  const Real Lambda_inv_0_0_p1034 = Lambda_inv_0_0_p971 - Lambda_inv_0_0_p991 -
      Lambda_inv_0_0_p1015 * Lambda_inv_0_0_p1033;
  const Real Lambda_inv_0_0_p1035 = Lambda_inv_0_0_p1014 - Lambda_inv_0_0_p1015 *
      Lambda_inv_0_0_p1029;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p1036 = c6 * Lambda_inv_0_0_p1010 - Lambda_inv_0_0_p1009;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1037 = Lambda_inv_0_0_p1006 * Lambda_inv_0_0_p1033 - 0.072 *
      Lambda_inv_0_0_p1036;
  const Real Lambda_inv_0_0_p1038 = s5 * (Lambda_inv_0_0_p1030 - Lambda_inv_0_0_p1034) + c5 *
      (Lambda_inv_0_0_p1035 + Lambda_inv_0_0_p1037);
  const Real Lambda_inv_0_0_p1039 = c5 * Lambda_inv_0_0_p1038;
  const Real Lambda_inv_0_0_p1040 = Lambda_inv_0_0_p1039 - Lambda_inv_0_0_p1037;
  const Real inverse_D4_p1 = s5 * Lambda_inv_0_0_p1026;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (Lambda_inv_0_0_p1023 + inverse_D4_p1));
  const Real Lambda_inv_0_0_p1041 = Lambda_inv_0_0_p1040 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1042 = s5 * Lambda_inv_0_0_p1038;
  const Real Lambda_inv_0_0_p1043 = Lambda_inv_0_0_p1036 - Lambda_inv_0_0_p1032 *
      Lambda_inv_0_0_p1005;
  const Real Lambda_inv_0_0_p1044 = Lambda_inv_0_0_p1002 - Lambda_inv_0_0_p1028 *
      Lambda_inv_0_0_p1005;
  const Real Lambda_inv_0_0_p1045 = s5 * Lambda_inv_0_0_p1043 - c5 * Lambda_inv_0_0_p1044;
  const Real Lambda_inv_0_0_p1046 = 0.21799999999999997 * Lambda_inv_0_0_p1045;
  const Real Lambda_inv_0_0_p1047 = Lambda_inv_0_0_p1030 - Lambda_inv_0_0_p1042 +
      Lambda_inv_0_0_p1046;
  const Real Lambda_inv_0_0_p1048 = 0.21799999999999997 * Lambda_inv_0_0_p1040;
  const Real Lambda_inv_0_0_p1049 = 0.0300000063 + Lambda_inv_0_0_p1019;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p1050 = Lambda_inv_0_0_p1049 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1051 = Lambda_inv_0_0_p1007 - Lambda_inv_0_0_p1011 -
      Lambda_inv_0_0_p1032 * Lambda_inv_0_0_p1033;
  const Real Lambda_inv_0_0_p1052 = inverse_D5_p14 - Lambda_inv_0_0_p1028 * Lambda_inv_0_0_p1029;
  const Real Lambda_inv_0_0_p1053 = Lambda_inv_0_0_p1031 - Lambda_inv_0_0_p1028 *
      Lambda_inv_0_0_p1033;
  const Real Lambda_inv_0_0_p1054 = s5 * (Lambda_inv_0_0_p1052 - Lambda_inv_0_0_p1051) +
      Lambda_inv_0_0_p1025 * Lambda_inv_0_0_p1053;
  const Real Lambda_inv_0_0_p1055 = s5 * Lambda_inv_0_0_p1054;
  const Real Lambda_inv_0_0_p1056 = Lambda_inv_0_0_p1052 - Lambda_inv_0_0_p1055;
  const Real Lambda_inv_0_0_p1057 = s5 * Lambda_inv_0_0_p1018 - c5 * Lambda_inv_0_0_p1013;
  const Real Lambda_inv_0_0_p1058 = Lambda_inv_0_0_p1012 - Lambda_inv_0_0_p1004 *
      Lambda_inv_0_0_p1005;
  const Real Lambda_inv_0_0_p1059 = Lambda_inv_0_0_p1057 + 0.21799999999999997 *
      Lambda_inv_0_0_p1058;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p1060 = Lambda_inv_0_0_p1027 * Lambda_inv_0_0_p1050 -
      Lambda_inv_0_0_p1059;
  const Real Lambda_inv_0_0_p1061 = s4 * (Lambda_inv_0_0_p1047 + Lambda_inv_0_0_p1027 *
      Lambda_inv_0_0_p1041 + (Lambda_inv_0_0_p1046 + Lambda_inv_0_0_p1048 * Lambda_inv_0_0_p1050)) +
      c4 * (0.21799999999999997 * Lambda_inv_0_0_p1056 - Lambda_inv_0_0_p1048 *
      Lambda_inv_0_0_p1041 + Lambda_inv_0_0_p1060);
  const Real Lambda_inv_0_0_p1062 = 8.419374554 + (c4 * Lambda_inv_0_0_p1061 -
      Lambda_inv_0_0_p1060);
  const Real inverse_D3_p1 = Lambda_inv_0_0_p1027 * inverse_D4;
  const Real inverse_D3_p2 = Lambda_inv_0_0_p1048 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * Lambda_inv_0_0_p1056 -
      Lambda_inv_0_0_p1048 * inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (Lambda_inv_0_0_p1021 - inverse_D4_p1 +
      0.21799999999999997 * (Lambda_inv_0_0_p1057 + Lambda_inv_0_0_p1059)) - Lambda_inv_0_0_p1027 *
      inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * Lambda_inv_0_0_p1047 + Lambda_inv_0_0_p1027 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real Lambda_inv_0_0_p1063 = Lambda_inv_0_0_p1062 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p1064 = Lambda_inv_0_0_p1056 - Lambda_inv_0_0_p1040 *
      Lambda_inv_0_0_p1041;
  const Real Lambda_inv_0_0_p1065 = s4 * (Lambda_inv_0_0_p1064 -
      (Lambda_inv_0_0_p1058 - Lambda_inv_0_0_p1049 * Lambda_inv_0_0_p1050)) - inverse_D3_p5 *
      (Lambda_inv_0_0_p1045 + Lambda_inv_0_0_p1040 * Lambda_inv_0_0_p1050);

  // link 3 (hip), articulated inertia
  const Real Lambda_inv_0_0_p1066 = Lambda_inv_0_0_p1064 - s4 * Lambda_inv_0_0_p1065 -
      Lambda_inv_0_0_p1062 * Lambda_inv_0_0_p1063;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1067 = Lambda_inv_0_0_p1034 + Lambda_inv_0_0_p1042;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p1068 = Lambda_inv_0_0_p1067 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p1069 = s5 * Lambda_inv_0_0_p1044 + c5 * Lambda_inv_0_0_p1043;
  const Real Lambda_inv_0_0_p1070 = c5 * Lambda_inv_0_0_p1054 - Lambda_inv_0_0_p1053;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p1071 = s4 * (0.21799999999999997 * Lambda_inv_0_0_p1069 -
      (Lambda_inv_0_0_p1039 - Lambda_inv_0_0_p1035) - Lambda_inv_0_0_p1027 * Lambda_inv_0_0_p1068) +
      c4 * (0.0300000063 - 0.21799999999999997 * Lambda_inv_0_0_p1070 + Lambda_inv_0_0_p1048 *
      Lambda_inv_0_0_p1068);
  const Real Lambda_inv_0_0_p1072 = 0.02999999505 + Lambda_inv_0_0_p1071;

  // link 3 (hip), articulated inertia
  const Real Lambda_inv_0_0_p1073 = Lambda_inv_0_0_p1072 * inverse_D3;
  const Real Lambda_inv_0_0_p1074 = Lambda_inv_0_0_p1051 + Lambda_inv_0_0_p1055 -
      Lambda_inv_0_0_p1067 * Lambda_inv_0_0_p1068 - Lambda_inv_0_0_p1072 * Lambda_inv_0_0_p1073;
  const Real Lambda_inv_0_0_p1075 = Lambda_inv_0_0_p1062 * Lambda_inv_0_0_p1073 -
      (c4 * (Lambda_inv_0_0_p1040 * Lambda_inv_0_0_p1068 - Lambda_inv_0_0_p1070) - s4 *
      (Lambda_inv_0_0_p1049 * Lambda_inv_0_0_p1068 - Lambda_inv_0_0_p1069));
  const Real Lambda_inv_0_0_p1076 = s3 * (Lambda_inv_0_0_p1066 - Lambda_inv_0_0_p1074) + c3 *
      (2.0 * Lambda_inv_0_0_p1075);
  const Real Lambda_inv_0_0_p1077 = s3 * Lambda_inv_0_0_p1076;
  const Real Lambda_inv_0_0_p1078 = Lambda_inv_0_0_p1066 - Lambda_inv_0_0_p1077;
  const Real Lambda_inv_0_0_p1079 = 24.5839218 + 0.422 * Lambda_inv_0_0_p1078;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * Lambda_inv_0_0_p1078);
  const Real Lambda_inv_0_0_p1080 = Lambda_inv_0_0_p1079 * inverse_D2;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p1081_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p17_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p1082_lanes = 0.00010499999999999999 / inverse_D8_p3_lanes;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_1_p1 = s5 * s4;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_1_p2 = s6 * c4 - c6 * Lambda_inv_0_1_p1;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_1_p4 = c5 * s4;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_1_p6_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_1_p2 -
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_1_p4;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_1_p8 = s6 * Lambda_inv_0_1_p1 + c6 * c4;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_1_p10_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_1_p6_lanes + detail::make_pack<Real>(s8, s15) * Lambda_inv_0_1_p8;
  const Lanes<2> Lambda_inv_0_1_p13_lanes = detail::make_pack<Real>(c8, c15) * Lambda_inv_0_1_p8 -
      detail::make_pack<Real>(s8, s15) * Lambda_inv_0_1_p6_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_1_p17_lanes = detail::make_pack<Real>(s7, s14) * Lambda_inv_0_1_p2 +
      detail::make_pack<Real>(c7, c14) * Lambda_inv_0_1_p4;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_1_p19_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_inv_0_1_p13_lanes + detail::make_pack<Real>(c9, c16) * Lambda_inv_0_1_p17_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_7_p17 = c17 * Lambda_inv_0_1_p10_lanes[1] - s17 *
      Lambda_inv_0_1_p19_lanes[1];

  // link 2 (thigh), pose
  const Real Lambda_inv_0_2_p1 = c2 * c1 - s2 * s1;
  const Real Lambda_inv_0_2_p2 = s2 * c1 + c2 * s1;

  // link 3 (hip), pose
  const Real Lambda_inv_0_2_p3 = s3 * Lambda_inv_0_2_p1 + c3 * Lambda_inv_0_2_p2;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_2_p4 = c4 * Lambda_inv_0_2_p3;

  // link 3 (hip), pose
  const Real Lambda_inv_0_2_p5 = c3 * Lambda_inv_0_2_p1 - s3 * Lambda_inv_0_2_p2;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_2_p6 = s5 * Lambda_inv_0_2_p4 - c5 * Lambda_inv_0_2_p5;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_2_p7 = s4 * Lambda_inv_0_2_p3;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_2_p8 = c6 * Lambda_inv_0_2_p6 + s6 * Lambda_inv_0_2_p7;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_2_p10 = c5 * Lambda_inv_0_2_p4 + s5 * Lambda_inv_0_2_p5;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_2_p12_lanes = detail::make_pack<Real>(s7, s14) * Lambda_inv_0_2_p8 -
      detail::make_pack<Real>(c7, c14) * Lambda_inv_0_2_p10;
  const Lanes<2> Lambda_inv_0_2_p16_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_2_p8 +
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_2_p10;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_2_p18 = s6 * Lambda_inv_0_2_p6 - c6 * Lambda_inv_0_2_p7;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_2_p20_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_2_p16_lanes + detail::make_pack<Real>(c8, c15) * Lambda_inv_0_2_p18;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_2_p22_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_2_p12_lanes - detail::make_pack<Real>(s9, s16) * Lambda_inv_0_2_p20_lanes;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_3_p1 = c4 * Lambda_inv_0_2_p5;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_3_p2 = s5 * Lambda_inv_0_3_p1 + c5 * Lambda_inv_0_2_p3;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_3_p3 = s4 * Lambda_inv_0_2_p5;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_3_p4 = c6 * Lambda_inv_0_3_p2 + s6 * Lambda_inv_0_3_p3;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_3_p6 = c5 * Lambda_inv_0_3_p1 - s5 * Lambda_inv_0_2_p3;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_3_p8_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_3_p4 +
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_3_p6;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_3_p10 = s6 * Lambda_inv_0_3_p2 - c6 * Lambda_inv_0_3_p3;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_3_p12_lanes = detail::make_pack<Real>(s8, s15) *
      Lambda_inv_0_3_p8_lanes + detail::make_pack<Real>(c8, c15) * Lambda_inv_0_3_p10;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_inv_0_3_p16_lanes = detail::make_pack<Real>(c7, c14) * Lambda_inv_0_3_p6 -
      detail::make_pack<Real>(s7, s14) * Lambda_inv_0_3_p4;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_3_p18_lanes = detail::make_pack<Real>(s9, s16) *
      Lambda_inv_0_3_p12_lanes + detail::make_pack<Real>(c9, c16) * Lambda_inv_0_3_p16_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_inv_0_2_p26_lanes = detail::make_pack<Real>(c8, c15) *
      Lambda_inv_0_2_p16_lanes - detail::make_pack<Real>(s8, s15) * Lambda_inv_0_2_p18;
  const Lanes<2> Lambda_inv_0_3_p22_lanes = detail::make_pack<Real>(s8, s15) * Lambda_inv_0_3_p10 -
      detail::make_pack<Real>(c8, c15) * Lambda_inv_0_3_p8_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<8> Lambda_inv_0_3_p24_lanes = c10 *
      detail::make_pack<Real>(Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_1_p10_lanes[0],
      Lambda_inv_0_2_p26_lanes[0], Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_3_p22_lanes[0],
      Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_3_p22_lanes[0], Lambda_inv_0_3_p22_lanes[0]) - s10 *
      detail::make_pack<Real>(Lambda_inv_0_3_p18_lanes[0], Lambda_inv_0_1_p19_lanes[0],
      Lambda_inv_0_2_p22_lanes[0], Lambda_inv_0_3_p18_lanes[0], Lambda_inv_0_3_p18_lanes[0],
      Lambda_inv_0_3_p18_lanes[0], Lambda_inv_0_3_p18_lanes[0], Lambda_inv_0_3_p18_lanes[0]);
  const Lanes<2> Lambda_inv_0_1_p26_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_1_p19_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_1_p10_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_1_p30_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_1_p13_lanes - detail::make_pack<Real>(s9, s16) * Lambda_inv_0_1_p17_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_1_p32_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_1_p26_lanes + detail::make_pack<Real>(s11, s18) * Lambda_inv_0_1_p30_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_inv_0_1_p34_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_inv_0_3_p24_lanes[1], Lambda_inv_0_7_p17) -
      detail::make_pack<Real>(s12, s19) * Lambda_inv_0_1_p32_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_1_p38_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_1_p30_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_1_p26_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_1_p40_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_1_p34_lanes + detail::make_pack<Real>(s13, s20) * Lambda_inv_0_1_p38_lanes;
  const Lanes<2> Lambda_inv_0_1_p43_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_1_p38_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_1_p34_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_1_p45_lanes = Lambda_inv_0_1_p40_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_inv_0_1_p43_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p41 = 0.49024375482668536 * Lambda_inv_0_1_p43_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_7_p42 = c19 * Lambda_inv_0_1_p32_lanes[1] + s19 * Lambda_inv_0_7_p17;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p43 = -(0.086 * Lambda_inv_0_7_p42) - (-0.004018575007348824) *
      Lambda_inv_0_1_p43_lanes[1];

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_1_p46_lanes = 0.009919078854932248 * Lambda_inv_0_1_p43_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p45 = s20 * Lambda_inv_0_1_p46_lanes[1] + c20 * Lambda_inv_0_7_p43;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p46 = s20 * Lambda_inv_0_1_p45_lanes[1] - c20 * Lambda_inv_0_7_p41 -
      Lambda_inv_0_0_p61_lanes[1] * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p47 = c20 * Lambda_inv_0_1_p46_lanes[1] - s20 * Lambda_inv_0_7_p43 -
      inverse_D11_p1_lanes[1] * Lambda_inv_0_7_p45;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p48 = -(c19 * Lambda_inv_0_7_p47);
  const Real Lambda_inv_0_7_p49 = 0.269 * Lambda_inv_0_7_p46 - s19 * Lambda_inv_0_7_p47 -
      inverse_D10_p1_lanes[1] * Lambda_inv_0_7_p48;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p50 = c20 * Lambda_inv_0_1_p45_lanes[1] + s20 * Lambda_inv_0_7_p41 -
      Lambda_inv_0_0_p11_lanes[1] * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p51 = Lambda_inv_0_7_p42 - Lambda_inv_0_0_p35_lanes[1] *
      Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p52 = s19 * Lambda_inv_0_7_p50 - c19 * Lambda_inv_0_7_p51;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p53 = 0.269 * Lambda_inv_0_7_p52 - inverse_D10_p8_lanes[1] *
      Lambda_inv_0_7_p48;
  const Real Lambda_inv_0_7_p54 = s18 * Lambda_inv_0_7_p49 + c18 * Lambda_inv_0_7_p53;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p55 = c18 * Lambda_inv_0_7_p49 - s18 * Lambda_inv_0_7_p53 -
      Lambda_inv_0_0_p231_lanes[1] * Lambda_inv_0_7_p54;
  const Real Lambda_inv_0_7_p56 = Lambda_inv_0_0_p221_lanes[1] * Lambda_inv_0_7_p54;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p57 = -Lambda_inv_0_7_p52 + Lambda_inv_0_0_p55_lanes[1] *
      Lambda_inv_0_7_p48;
  const Real Lambda_inv_0_7_p58 = Lambda_inv_0_7_p46 - Lambda_inv_0_0_p119_lanes[1] *
      Lambda_inv_0_7_p48;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p59 = s18 * Lambda_inv_0_7_p57 + c18 * Lambda_inv_0_7_p58 -
      Lambda_inv_0_0_p191_lanes[1] * Lambda_inv_0_7_p54;
  const Real Lambda_inv_0_7_p60 = c17 * Lambda_inv_0_7_p56 - s17 * Lambda_inv_0_7_p55;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p61 = c17 * Lambda_inv_0_7_p55 + s17 * Lambda_inv_0_7_p56 + 0.282 *
      Lambda_inv_0_7_p59 - Lambda_inv_0_0_p259_lanes[1] * Lambda_inv_0_7_p60;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p62 = c18 * Lambda_inv_0_7_p57 - s18 * Lambda_inv_0_7_p58 -
      Lambda_inv_0_0_p317_lanes[1] * Lambda_inv_0_7_p54;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_inv_0_2_p31_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_2_p22_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_2_p26_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_2_p35_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_2_p20_lanes + detail::make_pack<Real>(s9, s16) * Lambda_inv_0_2_p12_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_2_p37_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_2_p31_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_2_p35_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_8_p26 = c17 * Lambda_inv_0_2_p26_lanes[1] - s17 *
      Lambda_inv_0_2_p22_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_inv_0_2_p40_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_inv_0_3_p24_lanes[2], Lambda_inv_0_8_p26) -
      detail::make_pack<Real>(s12, s19) * Lambda_inv_0_2_p37_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_2_p44_lanes = detail::make_pack<Real>(s11, s18) *
      Lambda_inv_0_2_p31_lanes + detail::make_pack<Real>(c11, c18) * Lambda_inv_0_2_p35_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_2_p46_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_2_p40_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_2_p44_lanes;
  const Lanes<2> Lambda_inv_0_2_p49_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_inv_0_2_p40_lanes + detail::make_pack<Real>(c13, c20) * Lambda_inv_0_2_p44_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_2_p51_lanes = -(0.086 * Lambda_inv_0_2_p49_lanes);
  const Lanes<2> Lambda_inv_0_2_p53_lanes = Lambda_inv_0_2_p46_lanes +
      detail::make_pack<Real>((-3.0523172236718206), 3.0523172236718206) * Lambda_inv_0_2_p51_lanes;
  const Lanes<2> Lambda_inv_0_2_p55_lanes = -Lambda_inv_0_2_p49_lanes;
  const Lanes<2> Lambda_inv_0_2_p57_lanes = Lambda_inv_0_2_p55_lanes - 17.32841575379867 *
      Lambda_inv_0_2_p51_lanes;
  const Lanes<2> Lambda_inv_0_2_p59_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_2_p53_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_2_p57_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_inv_0_3_p27_lanes = detail::make_pack<Real>(c10, c17) *
      Lambda_inv_0_3_p18_lanes + detail::make_pack<Real>(s10, s17) * Lambda_inv_0_3_p22_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_inv_0_3_p31_lanes = detail::make_pack<Real>(c9, c16) *
      Lambda_inv_0_3_p12_lanes - detail::make_pack<Real>(s9, s16) * Lambda_inv_0_3_p16_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_3_p33_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_3_p27_lanes + detail::make_pack<Real>(s11, s18) * Lambda_inv_0_3_p31_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_inv_0_3_p36_lanes = c12 *
      detail::make_pack<Real>(Lambda_inv_0_3_p33_lanes[0], Lambda_inv_0_1_p32_lanes[0],
      Lambda_inv_0_2_p37_lanes[0], Lambda_inv_0_3_p33_lanes[0], Lambda_inv_0_3_p33_lanes[0],
      Lambda_inv_0_3_p33_lanes[0], Lambda_inv_0_3_p33_lanes[0], Lambda_inv_0_3_p33_lanes[0]) + s12 *
      Lambda_inv_0_3_p24_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p27 = c17 * Lambda_inv_0_3_p22_lanes[1] - s17 *
      Lambda_inv_0_3_p18_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_inv_0_3_p40_lanes = detail::make_pack<Real>(c12, c19) *
      detail::make_pack<Real>(Lambda_inv_0_3_p24_lanes[0], Lambda_inv_0_6_p27) -
      detail::make_pack<Real>(s12, s19) * Lambda_inv_0_3_p33_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_inv_0_3_p44_lanes = detail::make_pack<Real>(c11, c18) *
      Lambda_inv_0_3_p31_lanes - detail::make_pack<Real>(s11, s18) * Lambda_inv_0_3_p27_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_3_p46_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_3_p40_lanes + detail::make_pack<Real>(s13, s20) * Lambda_inv_0_3_p44_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_3_p47_lanes = detail::make_pack<Real>(Lambda_inv_0_3_p46_lanes[0],
      Lambda_inv_0_3_p46_lanes[0], Lambda_inv_0_3_p46_lanes[0], Lambda_inv_0_3_p46_lanes[0],
      Lambda_inv_0_1_p40_lanes[0], Lambda_inv_0_2_p46_lanes[0], Lambda_inv_0_3_p46_lanes[0],
      Lambda_inv_0_3_p46_lanes[0]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[0],
      Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[1],
      Lambda_inv_0_3_p36_lanes[2], Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[0]);
  const Lanes<2> Lambda_inv_0_2_p60_lanes = 0.11533812622014242 * Lambda_inv_0_2_p51_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_inv_0_0_p1085_lanes = detail::make_pack<Real>(c13, c20) *
      Lambda_inv_0_3_p44_lanes - detail::make_pack<Real>(s13, s20) * Lambda_inv_0_3_p40_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_inv_0_0_p1086_lanes = 0.009919078854932248 * Lambda_inv_0_0_p1085_lanes;

  // link 1 (calf), articulated inertia
  const Lanes<8> Lambda_inv_0_0_p1089_lanes = 0.086 * Lambda_inv_0_3_p36_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p1090_lanes =
      detail::make_pack<Real>(-Lambda_inv_0_0_p1089_lanes[0], -Lambda_inv_0_0_p1089_lanes[1],
      -Lambda_inv_0_0_p1089_lanes[2], Lambda_inv_0_0_p1085_lanes[0], Lambda_inv_0_1_p43_lanes[0],
      Lambda_inv_0_2_p55_lanes[0], -Lambda_inv_0_0_p1089_lanes[0], -Lambda_inv_0_0_p1089_lanes[0]) -
      detail::make_pack<Real>(0.004018575007348824, 0.004018575007348824, 0.04672761636452121,
      0.04672761636452121, 0.04672761636452121, 0.04672761636452121, 0.004018575007348824,
      0.004018575007348824) * detail::make_pack<Real>(Lambda_inv_0_0_p1085_lanes[0],
      Lambda_inv_0_1_p43_lanes[0], Lambda_inv_0_2_p51_lanes[0], Lambda_inv_0_3_p36_lanes[0],
      Lambda_inv_0_3_p36_lanes[1], Lambda_inv_0_3_p36_lanes[2], Lambda_inv_0_0_p1085_lanes[0],
      Lambda_inv_0_0_p1085_lanes[0]);
  const Lanes<8> Lambda_inv_0_0_p1092_lanes = s13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p1086_lanes[0], Lambda_inv_0_1_p46_lanes[0],
      Lambda_inv_0_2_p60_lanes[0], Lambda_inv_0_3_p47_lanes[3], Lambda_inv_0_3_p47_lanes[4],
      Lambda_inv_0_3_p47_lanes[5], Lambda_inv_0_0_p1086_lanes[0], Lambda_inv_0_0_p1086_lanes[0]) +
      c13 * Lambda_inv_0_0_p1090_lanes;
  const Lanes<8> Lambda_inv_0_3_p53_lanes = (-3.0523172236718206) *
      detail::make_pack<Real>(Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[0],
      Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[1],
      Lambda_inv_0_3_p36_lanes[2], Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[0]);
  const Lanes<2> Lambda_inv_0_0_p1095_lanes = Lambda_inv_0_3_p46_lanes +
      detail::make_pack<Real>((-0.26249928123577654), 0.26249928123577654) *
      Lambda_inv_0_0_p1085_lanes;
  const Lanes<8> Lambda_inv_0_0_p1097_lanes = detail::make_pack<Real>(0.49024375482668536,
      0.49024375482668536, 0.49024375482668536, 17.32841575379867, 17.32841575379867,
      17.32841575379867, 0.49024375482668536, 0.49024375482668536) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1085_lanes[0], Lambda_inv_0_1_p43_lanes[0],
      Lambda_inv_0_0_p1085_lanes[0], Lambda_inv_0_3_p36_lanes[0], Lambda_inv_0_3_p36_lanes[1],
      Lambda_inv_0_3_p36_lanes[2], Lambda_inv_0_0_p1085_lanes[0], Lambda_inv_0_0_p1085_lanes[0]);
  const Lanes<8> Lambda_inv_0_0_p1099_lanes = c13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p1095_lanes[0], Lambda_inv_0_1_p45_lanes[0],
      Lambda_inv_0_0_p1095_lanes[0], Lambda_inv_0_3_p53_lanes[3], Lambda_inv_0_3_p53_lanes[4],
      Lambda_inv_0_3_p53_lanes[5], Lambda_inv_0_0_p1095_lanes[0], Lambda_inv_0_0_p1095_lanes[0]) +
      s13 * Lambda_inv_0_0_p1097_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1100_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1099_lanes[0],
      Lambda_inv_0_0_p1099_lanes[1], Lambda_inv_0_2_p59_lanes[0], Lambda_inv_0_0_p1099_lanes[0],
      Lambda_inv_0_0_p1099_lanes[0], Lambda_inv_0_0_p1099_lanes[0], Lambda_inv_0_0_p1099_lanes[0],
      Lambda_inv_0_0_p1099_lanes[0]) - Lambda_inv_0_0_p11_lanes[0] * Lambda_inv_0_0_p1092_lanes;
  const Lanes<8> Lambda_inv_0_0_p1102_lanes = Lambda_inv_0_3_p36_lanes -
      Lambda_inv_0_0_p35_lanes[0] * Lambda_inv_0_0_p1092_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_0_1_p64_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1102_lanes[1], Lambda_inv_0_7_p51) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_inv_0_0_p1100_lanes[1],
      Lambda_inv_0_7_p50));

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p67 = -(Lambda_inv_0_1_p64_lanes[1] - Lambda_inv_0_0_p337_lanes[1] *
      Lambda_inv_0_7_p48) - Lambda_inv_0_0_p363_lanes[1] * Lambda_inv_0_7_p54;
  const Real Lambda_inv_0_7_p68 = s17 * Lambda_inv_0_7_p67 - c17 * Lambda_inv_0_7_p62;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p69 = 0.282 * Lambda_inv_0_7_p68 - Lambda_inv_0_0_p401_lanes[1] *
      Lambda_inv_0_7_p60;
  const Real Lambda_inv_0_7_p70 = c16 * Lambda_inv_0_7_p61 - s16 * Lambda_inv_0_7_p69;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p71 = Lambda_inv_0_0_p1082_lanes[1] * Lambda_inv_0_7_p70;
  const Real Lambda_inv_0_7_p72 = s16 * Lambda_inv_0_7_p61 + c16 * Lambda_inv_0_7_p69 -
      inverse_D7_p1_lanes[1] * Lambda_inv_0_7_p70;
  const Real Lambda_inv_0_7_p73 = s15 * Lambda_inv_0_7_p71 + c15 * Lambda_inv_0_7_p72;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p42 = 0.49024375482668536 * Lambda_inv_0_0_p1085_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p43 = c19 * Lambda_inv_0_3_p33_lanes[1] + s19 * Lambda_inv_0_6_p27;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p44 = -(0.086 * Lambda_inv_0_6_p43) - (-0.004018575007348824) *
      Lambda_inv_0_0_p1085_lanes[1];
  const Real Lambda_inv_0_6_p45 = s20 * Lambda_inv_0_0_p1086_lanes[1] + c20 * Lambda_inv_0_6_p44;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p46 = s20 * Lambda_inv_0_0_p1095_lanes[1] - c20 * Lambda_inv_0_6_p42 -
      Lambda_inv_0_0_p61_lanes[1] * Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p47 = c20 * Lambda_inv_0_0_p1086_lanes[1] - s20 * Lambda_inv_0_6_p44 -
      inverse_D11_p1_lanes[1] * Lambda_inv_0_6_p45;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p48 = -(c19 * Lambda_inv_0_6_p47);
  const Real Lambda_inv_0_6_p49 = 0.269 * Lambda_inv_0_6_p46 - s19 * Lambda_inv_0_6_p47 -
      inverse_D10_p1_lanes[1] * Lambda_inv_0_6_p48;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p50 = c20 * Lambda_inv_0_0_p1095_lanes[1] + s20 * Lambda_inv_0_6_p42 -
      Lambda_inv_0_0_p11_lanes[1] * Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p51 = Lambda_inv_0_6_p43 - Lambda_inv_0_0_p35_lanes[1] *
      Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p52 = s19 * Lambda_inv_0_6_p50 - c19 * Lambda_inv_0_6_p51;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p53 = 0.269 * Lambda_inv_0_6_p52 - inverse_D10_p8_lanes[1] *
      Lambda_inv_0_6_p48;
  const Real Lambda_inv_0_6_p54 = s18 * Lambda_inv_0_6_p49 + c18 * Lambda_inv_0_6_p53;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p55 = c18 * Lambda_inv_0_6_p49 - s18 * Lambda_inv_0_6_p53 -
      Lambda_inv_0_0_p231_lanes[1] * Lambda_inv_0_6_p54;
  const Real Lambda_inv_0_6_p56 = Lambda_inv_0_0_p221_lanes[1] * Lambda_inv_0_6_p54;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p57 = -Lambda_inv_0_6_p52 + Lambda_inv_0_0_p55_lanes[1] *
      Lambda_inv_0_6_p48;
  const Real Lambda_inv_0_6_p58 = Lambda_inv_0_6_p46 - Lambda_inv_0_0_p119_lanes[1] *
      Lambda_inv_0_6_p48;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p59 = s18 * Lambda_inv_0_6_p57 + c18 * Lambda_inv_0_6_p58 -
      Lambda_inv_0_0_p191_lanes[1] * Lambda_inv_0_6_p54;
  const Real Lambda_inv_0_6_p60 = c17 * Lambda_inv_0_6_p56 - s17 * Lambda_inv_0_6_p55;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p61 = c17 * Lambda_inv_0_6_p55 + s17 * Lambda_inv_0_6_p56 + 0.282 *
      Lambda_inv_0_6_p59 - Lambda_inv_0_0_p259_lanes[1] * Lambda_inv_0_6_p60;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p62 = c18 * Lambda_inv_0_6_p57 - s18 * Lambda_inv_0_6_p58 -
      Lambda_inv_0_0_p317_lanes[1] * Lambda_inv_0_6_p54;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_0_0_p1106_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1102_lanes[0], Lambda_inv_0_6_p51) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_inv_0_0_p1100_lanes[0],
      Lambda_inv_0_6_p50));

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p67 = -(Lambda_inv_0_0_p1106_lanes[1] - Lambda_inv_0_0_p337_lanes[1] *
      Lambda_inv_0_6_p48) - Lambda_inv_0_0_p363_lanes[1] * Lambda_inv_0_6_p54;
  const Real Lambda_inv_0_6_p68 = s17 * Lambda_inv_0_6_p67 - c17 * Lambda_inv_0_6_p62;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p69 = 0.282 * Lambda_inv_0_6_p68 - Lambda_inv_0_0_p401_lanes[1] *
      Lambda_inv_0_6_p60;
  const Real Lambda_inv_0_6_p70 = c16 * Lambda_inv_0_6_p61 - s16 * Lambda_inv_0_6_p69;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p71 = s16 * Lambda_inv_0_6_p61 + c16 * Lambda_inv_0_6_p69 -
      inverse_D7_p1_lanes[1] * Lambda_inv_0_6_p70;
  const Real Lambda_inv_0_6_p72 = Lambda_inv_0_0_p1082_lanes[1] * Lambda_inv_0_6_p70;
  const Real Lambda_inv_0_6_p73 = s15 * Lambda_inv_0_6_p72 + c15 * Lambda_inv_0_6_p71;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1111_lanes = c13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p1086_lanes[0], Lambda_inv_0_1_p46_lanes[0],
      Lambda_inv_0_2_p60_lanes[0], Lambda_inv_0_3_p47_lanes[3], Lambda_inv_0_3_p47_lanes[4],
      Lambda_inv_0_3_p47_lanes[5], Lambda_inv_0_0_p1086_lanes[0], Lambda_inv_0_0_p1086_lanes[0]) -
      s13 * Lambda_inv_0_0_p1090_lanes - inverse_D11_p1_lanes[0] * Lambda_inv_0_0_p1092_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p1116_lanes = s13 *
      detail::make_pack<Real>(Lambda_inv_0_0_p1095_lanes[0], Lambda_inv_0_1_p45_lanes[0],
      Lambda_inv_0_0_p1095_lanes[0], Lambda_inv_0_3_p53_lanes[3], Lambda_inv_0_3_p53_lanes[4],
      Lambda_inv_0_3_p53_lanes[5], Lambda_inv_0_0_p1095_lanes[0], Lambda_inv_0_0_p1095_lanes[0]) -
      c13 * Lambda_inv_0_0_p1097_lanes;
  const Lanes<2> Lambda_inv_0_2_p80_lanes = detail::make_pack<Real>(s13, s20) *
      Lambda_inv_0_2_p53_lanes + detail::make_pack<Real>(c13, c20) * Lambda_inv_0_2_p57_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1117_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1116_lanes[0],
      Lambda_inv_0_0_p1116_lanes[1], Lambda_inv_0_2_p80_lanes[0], Lambda_inv_0_0_p1116_lanes[3],
      Lambda_inv_0_0_p1116_lanes[4], Lambda_inv_0_0_p1116_lanes[5], Lambda_inv_0_0_p1116_lanes[0],
      Lambda_inv_0_0_p1116_lanes[0]) - Lambda_inv_0_0_p61_lanes[0] * Lambda_inv_0_0_p1092_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1121_lanes = -(c12 * Lambda_inv_0_0_p1111_lanes);
  const Lanes<8> Lambda_inv_0_0_p1123_lanes = 0.269 * Lambda_inv_0_0_p1117_lanes - s12 *
      Lambda_inv_0_0_p1111_lanes - inverse_D10_p1_lanes[0] * Lambda_inv_0_0_p1121_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_3_p76_lanes = Lambda_inv_0_0_p35_lanes[0] *
      Lambda_inv_0_0_p1092_lanes;
  const Lanes<8> Lambda_inv_0_3_p79_lanes = Lambda_inv_0_0_p1099_lanes -
      Lambda_inv_0_0_p11_lanes[0] * Lambda_inv_0_0_p1092_lanes;
  const Lanes<8> Lambda_inv_0_3_p81_lanes = c12 * Lambda_inv_0_3_p76_lanes + s12 *
      Lambda_inv_0_3_p79_lanes;
  const Lanes<8> Lambda_inv_0_0_p1127_lanes = s12 * Lambda_inv_0_0_p1100_lanes - c12 *
      Lambda_inv_0_0_p1102_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1130_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_inv_0_0_p1127_lanes[0], Lambda_inv_0_0_p1127_lanes[1],
      Lambda_inv_0_0_p1127_lanes[2], Lambda_inv_0_3_p81_lanes[3], Lambda_inv_0_3_p81_lanes[4],
      Lambda_inv_0_3_p81_lanes[5], Lambda_inv_0_0_p1127_lanes[0], Lambda_inv_0_0_p1127_lanes[0]) -
      inverse_D10_p8_lanes[0] * Lambda_inv_0_0_p1121_lanes;
  const Lanes<8> Lambda_inv_0_0_p1135_lanes = s11 * Lambda_inv_0_0_p1123_lanes + c11 *
      Lambda_inv_0_0_p1130_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1137_lanes = c11 * Lambda_inv_0_0_p1123_lanes - s11 *
      Lambda_inv_0_0_p1130_lanes - Lambda_inv_0_0_p231_lanes[0] * Lambda_inv_0_0_p1135_lanes;
  const Lanes<8> Lambda_inv_0_0_p1139_lanes = Lambda_inv_0_0_p221_lanes[0] *
      Lambda_inv_0_0_p1135_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1145_lanes =
      -detail::make_pack<Real>(Lambda_inv_0_0_p1127_lanes[0], Lambda_inv_0_0_p1127_lanes[1],
      Lambda_inv_0_0_p1127_lanes[2], Lambda_inv_0_3_p81_lanes[3], Lambda_inv_0_3_p81_lanes[4],
      Lambda_inv_0_3_p81_lanes[5], Lambda_inv_0_0_p1127_lanes[0], Lambda_inv_0_0_p1127_lanes[0]) +
      Lambda_inv_0_0_p55_lanes[0] * Lambda_inv_0_0_p1121_lanes;
  const Lanes<8> Lambda_inv_0_0_p1148_lanes = Lambda_inv_0_0_p1117_lanes -
      Lambda_inv_0_0_p119_lanes[0] * Lambda_inv_0_0_p1121_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1151_lanes = s11 * Lambda_inv_0_0_p1145_lanes + c11 *
      Lambda_inv_0_0_p1148_lanes - Lambda_inv_0_0_p191_lanes[0] * Lambda_inv_0_0_p1135_lanes;
  const Lanes<8> Lambda_inv_0_0_p1156_lanes = c10 * Lambda_inv_0_0_p1139_lanes - s10 *
      Lambda_inv_0_0_p1137_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1157_lanes = Lambda_inv_0_0_p259_lanes[0] *
      Lambda_inv_0_0_p1156_lanes;
  const Lanes<8> Lambda_inv_0_0_p1158_lanes = c10 * Lambda_inv_0_0_p1137_lanes + s10 *
      Lambda_inv_0_0_p1139_lanes + 0.282 * Lambda_inv_0_0_p1151_lanes - Lambda_inv_0_0_p1157_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_3_p117_lanes = s12 * Lambda_inv_0_3_p76_lanes - c12 *
      Lambda_inv_0_3_p79_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_11_p1 = c19 * Lambda_inv_0_2_p37_lanes[1] + s19 * Lambda_inv_0_8_p26;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_9_p2_lanes = detail::make_pack<Real>(Lambda_inv_0_3_p46_lanes[1],
      Lambda_inv_0_3_p46_lanes[1], Lambda_inv_0_1_p40_lanes[1], Lambda_inv_0_2_p46_lanes[1],
      Lambda_inv_0_3_p46_lanes[1], Lambda_inv_0_3_p46_lanes[1], Lambda_inv_0_3_p46_lanes[1],
      Lambda_inv_0_3_p46_lanes[1]) + 0.11533812622014242 *
      detail::make_pack<Real>(Lambda_inv_0_6_p43, Lambda_inv_0_6_p43, Lambda_inv_0_7_p42,
      Lambda_inv_0_11_p1, Lambda_inv_0_6_p43, Lambda_inv_0_6_p43, Lambda_inv_0_6_p43,
      Lambda_inv_0_6_p43);
  const Lanes<8> Lambda_inv_0_8_p54_lanes = detail::make_pack<Real>(-(0.086 * Lambda_inv_0_11_p1),
      Lambda_inv_0_0_p1085_lanes[1], Lambda_inv_0_1_p43_lanes[1], Lambda_inv_0_2_p55_lanes[1],
      -(0.086 * Lambda_inv_0_11_p1), -(0.086 * Lambda_inv_0_11_p1), -(0.086 * Lambda_inv_0_11_p1),
      -(0.086 * Lambda_inv_0_11_p1)) - (-0.04672761636452121) *
      detail::make_pack<Real>(Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_6_p43, Lambda_inv_0_7_p42,
      Lambda_inv_0_11_p1, Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1],
      Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1]);
  const Lanes<8> Lambda_inv_0_8_p56_lanes = s20 *
      detail::make_pack<Real>(Lambda_inv_0_2_p60_lanes[1], Lambda_inv_0_9_p2_lanes[1],
      Lambda_inv_0_9_p2_lanes[2], Lambda_inv_0_9_p2_lanes[3], Lambda_inv_0_2_p60_lanes[1],
      Lambda_inv_0_2_p60_lanes[1], Lambda_inv_0_2_p60_lanes[1], Lambda_inv_0_2_p60_lanes[1]) + c20 *
      Lambda_inv_0_8_p54_lanes;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_8_p57 = Lambda_inv_0_2_p59_lanes[1] - Lambda_inv_0_0_p11_lanes[1] *
      Lambda_inv_0_8_p56_lanes[0];
  const Real Lambda_inv_0_8_p59 = Lambda_inv_0_11_p1 - Lambda_inv_0_0_p35_lanes[1] *
      Lambda_inv_0_8_p56_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_0_2_p129_lanes = -(detail::make_pack<Real>(s12, s19) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1102_lanes[2], Lambda_inv_0_8_p59) +
      detail::make_pack<Real>(c12, c19) * detail::make_pack<Real>(Lambda_inv_0_0_p1100_lanes[2],
      Lambda_inv_0_8_p57));

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1164_lanes =
      -(detail::make_pack<Real>(Lambda_inv_0_0_p1106_lanes[0], Lambda_inv_0_1_p64_lanes[0],
      Lambda_inv_0_2_p129_lanes[0], Lambda_inv_0_3_p117_lanes[3], Lambda_inv_0_3_p117_lanes[4],
      Lambda_inv_0_3_p117_lanes[5], Lambda_inv_0_0_p1106_lanes[0], Lambda_inv_0_0_p1106_lanes[0]) -
      Lambda_inv_0_0_p337_lanes[0] * Lambda_inv_0_0_p1121_lanes) - Lambda_inv_0_0_p363_lanes[0] *
      Lambda_inv_0_0_p1135_lanes;
  const Lanes<8> Lambda_inv_0_0_p1170_lanes = c11 * Lambda_inv_0_0_p1145_lanes - s11 *
      Lambda_inv_0_0_p1148_lanes - Lambda_inv_0_0_p317_lanes[0] * Lambda_inv_0_0_p1135_lanes;
  const Lanes<8> Lambda_inv_0_0_p1172_lanes = s10 * Lambda_inv_0_0_p1164_lanes - c10 *
      Lambda_inv_0_0_p1170_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1175_lanes = 0.282 * Lambda_inv_0_0_p1172_lanes -
      Lambda_inv_0_0_p401_lanes[0] * Lambda_inv_0_0_p1156_lanes;
  const Lanes<8> Lambda_inv_0_0_p1180_lanes = c9 * Lambda_inv_0_0_p1158_lanes - s9 *
      Lambda_inv_0_0_p1175_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1182_lanes = s9 * Lambda_inv_0_0_p1158_lanes + c9 *
      Lambda_inv_0_0_p1175_lanes - inverse_D7_p1_lanes[0] * Lambda_inv_0_0_p1180_lanes;
  const Lanes<8> Lambda_inv_0_0_p1184_lanes = Lambda_inv_0_0_p1082_lanes[0] *
      Lambda_inv_0_0_p1180_lanes;
  const Lanes<8> Lambda_inv_0_0_p1186_lanes = s8 * Lambda_inv_0_0_p1184_lanes + c8 *
      Lambda_inv_0_0_p1182_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1187_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1081_lanes[0],
      Lambda_inv_0_0_p1081_lanes[0], Lambda_inv_0_0_p1081_lanes[0], Lambda_inv_0_0_p1081_lanes[0],
      Lambda_inv_0_0_p1081_lanes[0], Lambda_inv_0_0_p1081_lanes[0], Lambda_inv_0_0_p1081_lanes[1],
      Lambda_inv_0_0_p1081_lanes[1]) * detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[0],
      Lambda_inv_0_0_p1186_lanes[1], Lambda_inv_0_0_p1186_lanes[2], Lambda_inv_0_0_p1186_lanes[3],
      Lambda_inv_0_0_p1186_lanes[4], Lambda_inv_0_0_p1186_lanes[5], Lambda_inv_0_6_p73,
      Lambda_inv_0_7_p73);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1192_lanes = c8 * Lambda_inv_0_0_p1184_lanes - s8 *
      Lambda_inv_0_0_p1182_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1193_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1192_lanes[0],
      Lambda_inv_0_0_p1192_lanes[1], Lambda_inv_0_0_p1192_lanes[2], Lambda_inv_0_0_p1192_lanes[3],
      Lambda_inv_0_0_p1192_lanes[4], Lambda_inv_0_0_p1192_lanes[5], c15 * Lambda_inv_0_6_p72 - s15 *
      Lambda_inv_0_6_p71, c15 * Lambda_inv_0_7_p71 - s15 * Lambda_inv_0_7_p72) -
      detail::make_pack<Real>(inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[1], inverse_D6_p5_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[0], Lambda_inv_0_0_p1186_lanes[1],
      Lambda_inv_0_0_p1186_lanes[2], Lambda_inv_0_0_p1186_lanes[3], Lambda_inv_0_0_p1186_lanes[4],
      Lambda_inv_0_0_p1186_lanes[5], Lambda_inv_0_6_p73, Lambda_inv_0_7_p73);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p81 = -Lambda_inv_0_7_p68 + Lambda_inv_0_0_p569_lanes[1] *
      Lambda_inv_0_7_p60;
  const Real Lambda_inv_0_7_p82 = Lambda_inv_0_7_p59 - Lambda_inv_0_0_p577_lanes[1] *
      Lambda_inv_0_7_p60;
  const Real Lambda_inv_0_6_p81 = -Lambda_inv_0_6_p68 + Lambda_inv_0_0_p569_lanes[1] *
      Lambda_inv_0_6_p60;
  const Real Lambda_inv_0_6_p82 = Lambda_inv_0_6_p59 - Lambda_inv_0_0_p577_lanes[1] *
      Lambda_inv_0_6_p60;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1200_lanes = -Lambda_inv_0_0_p1172_lanes +
      Lambda_inv_0_0_p569_lanes[0] * Lambda_inv_0_0_p1156_lanes;
  const Lanes<8> Lambda_inv_0_0_p1203_lanes = Lambda_inv_0_0_p1151_lanes -
      Lambda_inv_0_0_p577_lanes[0] * Lambda_inv_0_0_p1156_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1206_lanes = c9 * Lambda_inv_0_0_p1200_lanes - s9 *
      Lambda_inv_0_0_p1203_lanes - Lambda_inv_0_0_p657_lanes[0] * Lambda_inv_0_0_p1180_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1207_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1206_lanes[0],
      Lambda_inv_0_0_p1206_lanes[1], Lambda_inv_0_0_p1206_lanes[2], Lambda_inv_0_0_p1206_lanes[3],
      Lambda_inv_0_0_p1206_lanes[4], Lambda_inv_0_0_p1206_lanes[5], c16 * Lambda_inv_0_6_p81 - s16 *
      Lambda_inv_0_6_p82 - Lambda_inv_0_0_p657_lanes[1] * Lambda_inv_0_6_p70, c16 *
      Lambda_inv_0_7_p81 - s16 * Lambda_inv_0_7_p82 - Lambda_inv_0_0_p657_lanes[1] *
      Lambda_inv_0_7_p70) - detail::make_pack<Real>(Lambda_inv_0_0_p679_lanes[0],
      Lambda_inv_0_0_p679_lanes[0], Lambda_inv_0_0_p679_lanes[0], Lambda_inv_0_0_p679_lanes[0],
      Lambda_inv_0_0_p679_lanes[0], Lambda_inv_0_0_p679_lanes[0], Lambda_inv_0_0_p679_lanes[1],
      Lambda_inv_0_0_p679_lanes[1]) * detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[0],
      Lambda_inv_0_0_p1186_lanes[1], Lambda_inv_0_0_p1186_lanes[2], Lambda_inv_0_0_p1186_lanes[3],
      Lambda_inv_0_0_p1186_lanes[4], Lambda_inv_0_0_p1186_lanes[5], Lambda_inv_0_6_p73,
      Lambda_inv_0_7_p73);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p86 = -(-(s17 * Lambda_inv_0_7_p62 + c17 * Lambda_inv_0_7_p67) +
      Lambda_inv_0_0_p515_lanes[1] * Lambda_inv_0_7_p60) + Lambda_inv_0_0_p555_lanes[1] *
      Lambda_inv_0_7_p70;
  const Real Lambda_inv_0_7_p87 = s16 * Lambda_inv_0_7_p81 + c16 * Lambda_inv_0_7_p82 -
      Lambda_inv_0_0_p609_lanes[1] * Lambda_inv_0_7_p70;
  const Real Lambda_inv_0_6_p86 = s16 * Lambda_inv_0_6_p81 + c16 * Lambda_inv_0_6_p82 -
      Lambda_inv_0_0_p609_lanes[1] * Lambda_inv_0_6_p70;
  const Real Lambda_inv_0_6_p87 = -(-(s17 * Lambda_inv_0_6_p62 + c17 * Lambda_inv_0_6_p67) +
      Lambda_inv_0_0_p515_lanes[1] * Lambda_inv_0_6_p60) + Lambda_inv_0_0_p555_lanes[1] *
      Lambda_inv_0_6_p70;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1216_lanes = -(s10 * Lambda_inv_0_0_p1170_lanes + c10 *
      Lambda_inv_0_0_p1164_lanes) + Lambda_inv_0_0_p515_lanes[0] * Lambda_inv_0_0_p1156_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1218_lanes = -Lambda_inv_0_0_p1216_lanes +
      Lambda_inv_0_0_p555_lanes[0] * Lambda_inv_0_0_p1180_lanes;
  const Lanes<8> Lambda_inv_0_0_p1224_lanes = s9 * Lambda_inv_0_0_p1200_lanes + c9 *
      Lambda_inv_0_0_p1203_lanes - Lambda_inv_0_0_p609_lanes[0] * Lambda_inv_0_0_p1180_lanes;
  const Lanes<8> Lambda_inv_0_0_p1226_lanes = c8 * Lambda_inv_0_0_p1218_lanes - s8 *
      Lambda_inv_0_0_p1224_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1227_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1226_lanes[0],
      Lambda_inv_0_0_p1226_lanes[1], Lambda_inv_0_0_p1226_lanes[2], Lambda_inv_0_0_p1226_lanes[3],
      Lambda_inv_0_0_p1226_lanes[4], Lambda_inv_0_0_p1226_lanes[5], c15 * Lambda_inv_0_6_p87 - s15 *
      Lambda_inv_0_6_p86, c15 * Lambda_inv_0_7_p86 - s15 * Lambda_inv_0_7_p87) -
      detail::make_pack<Real>(Lambda_inv_0_0_p639_lanes[0], Lambda_inv_0_0_p639_lanes[0],
      Lambda_inv_0_0_p639_lanes[0], Lambda_inv_0_0_p639_lanes[0], Lambda_inv_0_0_p639_lanes[0],
      Lambda_inv_0_0_p639_lanes[0], Lambda_inv_0_0_p639_lanes[1], Lambda_inv_0_0_p639_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[0], Lambda_inv_0_0_p1186_lanes[1],
      Lambda_inv_0_0_p1186_lanes[2], Lambda_inv_0_0_p1186_lanes[3], Lambda_inv_0_0_p1186_lanes[4],
      Lambda_inv_0_0_p1186_lanes[5], Lambda_inv_0_6_p73, Lambda_inv_0_7_p73);
  const Lanes<8> Lambda_inv_0_0_p1229_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_inv_0_0_p1207_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p1227_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1234_lanes = s8 * Lambda_inv_0_0_p1218_lanes + c8 *
      Lambda_inv_0_0_p1224_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1235_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1234_lanes[0],
      Lambda_inv_0_0_p1234_lanes[1], Lambda_inv_0_0_p1234_lanes[2], Lambda_inv_0_0_p1234_lanes[3],
      Lambda_inv_0_0_p1234_lanes[4], Lambda_inv_0_0_p1234_lanes[5], s15 * Lambda_inv_0_6_p87 + c15 *
      Lambda_inv_0_6_p86, s15 * Lambda_inv_0_7_p86 + c15 * Lambda_inv_0_7_p87) -
      detail::make_pack<Real>(Lambda_inv_0_0_p837_lanes[0], Lambda_inv_0_0_p837_lanes[0],
      Lambda_inv_0_0_p837_lanes[0], Lambda_inv_0_0_p837_lanes[0], Lambda_inv_0_0_p837_lanes[0],
      Lambda_inv_0_0_p837_lanes[0], Lambda_inv_0_0_p837_lanes[1], Lambda_inv_0_0_p837_lanes[1]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[0], Lambda_inv_0_0_p1186_lanes[1],
      Lambda_inv_0_0_p1186_lanes[2], Lambda_inv_0_0_p1186_lanes[3], Lambda_inv_0_0_p1186_lanes[4],
      Lambda_inv_0_0_p1186_lanes[5], Lambda_inv_0_6_p73, Lambda_inv_0_7_p73);
  const Lanes<8> Lambda_inv_0_0_p1237_lanes = 0.226 * Lambda_inv_0_0_p1235_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) *
      Lambda_inv_0_0_p1229_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p1239_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p1187_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_inv_0_0_p1193_lanes + Lambda_inv_0_0_p1237_lanes);
  const Lanes<8> Lambda_inv_0_0_p1240_lanes = inverse_D5_p16 * Lambda_inv_0_0_p1239_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1243_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p1207_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_inv_0_0_p1227_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p1249_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_inv_0_0_p1243_lanes -
      (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * Lambda_inv_0_0_p1187_lanes -
      detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * Lambda_inv_0_0_p1193_lanes) -
      Lambda_inv_0_0_p1240_lanes;
  const Lanes<8> Lambda_inv_0_0_p1253_lanes = 0.226 * Lambda_inv_0_0_p1243_lanes - inverse_D5_p22 *
      Lambda_inv_0_0_p1239_lanes;
  const Lanes<8> Lambda_inv_0_0_p1257_lanes = Lambda_inv_0_0_p1243_lanes - Lambda_inv_0_0_p993 *
      Lambda_inv_0_0_p1239_lanes;
  const Lanes<8> Lambda_inv_0_0_p1259_lanes = s6 * Lambda_inv_0_0_p1249_lanes + c6 *
      Lambda_inv_0_0_p1253_lanes + 0.072 * Lambda_inv_0_0_p1257_lanes;
  const Lanes<8> Lambda_inv_0_0_p1262_lanes = Lambda_inv_0_0_p1229_lanes + Lambda_inv_0_0_p930 *
      Lambda_inv_0_0_p1239_lanes;
  const Lanes<8> Lambda_inv_0_0_p1265_lanes = Lambda_inv_0_0_p1235_lanes - Lambda_inv_0_0_p984 *
      Lambda_inv_0_0_p1239_lanes;
  const Lanes<8> Lambda_inv_0_0_p1267_lanes = s6 * Lambda_inv_0_0_p1262_lanes + c6 *
      Lambda_inv_0_0_p1265_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1270_lanes = -(0.072 * Lambda_inv_0_0_p1267_lanes) +
      Lambda_inv_0_0_p1020 * Lambda_inv_0_0_p1259_lanes;
  const Lanes<8> Lambda_inv_0_0_p1276_lanes = c6 * Lambda_inv_0_0_p1249_lanes - s6 *
      Lambda_inv_0_0_p1253_lanes - Lambda_inv_0_0_p1022 * Lambda_inv_0_0_p1259_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1279_lanes = -(s5 * Lambda_inv_0_0_p1270_lanes + c5 *
      Lambda_inv_0_0_p1276_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1285_lanes = Lambda_inv_0_0_p1267_lanes - Lambda_inv_0_0_p1005 *
      Lambda_inv_0_0_p1259_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1288_lanes = -(s5 * Lambda_inv_0_0_p1276_lanes - c5 *
      Lambda_inv_0_0_p1270_lanes + 0.21799999999999997 * Lambda_inv_0_0_p1285_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1296_lanes = c6 * Lambda_inv_0_0_p1262_lanes - s6 *
      Lambda_inv_0_0_p1265_lanes - Lambda_inv_0_0_p1033 * Lambda_inv_0_0_p1259_lanes;
  const Lanes<8> Lambda_inv_0_0_p1299_lanes = Lambda_inv_0_0_p1257_lanes - Lambda_inv_0_0_p1029 *
      Lambda_inv_0_0_p1259_lanes;
  const Lanes<8> Lambda_inv_0_0_p1301_lanes = s5 * Lambda_inv_0_0_p1296_lanes - c5 *
      Lambda_inv_0_0_p1299_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1305_lanes = c4 * (-(0.21799999999999997 *
      Lambda_inv_0_0_p1301_lanes) + inverse_D3_p2 * Lambda_inv_0_0_p1279_lanes);
  const Lanes<8> Lambda_inv_0_0_p1306_lanes = s4 * (Lambda_inv_0_0_p1288_lanes - inverse_D3_p1 *
      Lambda_inv_0_0_p1279_lanes) + Lambda_inv_0_0_p1305_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p1307_lanes = Lambda_inv_0_0_p1063 * Lambda_inv_0_0_p1306_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1314_lanes = s4 * (Lambda_inv_0_0_p1285_lanes +
      Lambda_inv_0_0_p1050 * Lambda_inv_0_0_p1279_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p1316_lanes = c4 * (-Lambda_inv_0_0_p1301_lanes +
      Lambda_inv_0_0_p1041 * Lambda_inv_0_0_p1279_lanes) - Lambda_inv_0_0_p1314_lanes -
      Lambda_inv_0_0_p1307_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1324_lanes = -(s5 * Lambda_inv_0_0_p1299_lanes + c5 *
      Lambda_inv_0_0_p1296_lanes) - Lambda_inv_0_0_p1068 * Lambda_inv_0_0_p1279_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p1326_lanes = -Lambda_inv_0_0_p1324_lanes + Lambda_inv_0_0_p1073 *
      Lambda_inv_0_0_p1306_lanes;
  const Lanes<8> Lambda_inv_0_0_p1328_lanes = c3 * Lambda_inv_0_0_p1316_lanes - s3 *
      Lambda_inv_0_0_p1326_lanes;
  const Lanes<8> Lambda_inv_0_0_p1329_lanes = 0.422 * Lambda_inv_0_0_p1328_lanes;

  // link 3 (hip), articulated inertia
  const Real Lambda_inv_0_0_p1333 = c3 * Lambda_inv_0_0_p1076 - Lambda_inv_0_0_p1075;
  const Real Lambda_inv_0_0_p1334 = 0.031999971599999996 + 0.422 * Lambda_inv_0_0_p1333;

  // link 2 (thigh), articulated inertia
  const Real Lambda_inv_0_0_p1335 = Lambda_inv_0_0_p1334 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_0_p1341_lanes = s2 * (s3 * Lambda_inv_0_0_p1316_lanes + c3 *
      Lambda_inv_0_0_p1326_lanes - Lambda_inv_0_0_p1335 * Lambda_inv_0_0_p1329_lanes);
  const Lanes<8> Lambda_inv_0_0_p1343_lanes = 0.434 *
      (c2 * (Lambda_inv_0_0_p1328_lanes - Lambda_inv_0_0_p1080 * Lambda_inv_0_0_p1329_lanes) -
      Lambda_inv_0_0_p1341_lanes);

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = Lambda_inv_0_0_p1078 - Lambda_inv_0_0_p1079 * Lambda_inv_0_0_p1080;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (Lambda_inv_0_0_p1074 + Lambda_inv_0_0_p1077 -
      Lambda_inv_0_0_p1334 * Lambda_inv_0_0_p1335)) + c2 *
      (2.0 * (Lambda_inv_0_0_p1333 - Lambda_inv_0_0_p1079 * Lambda_inv_0_0_p1335));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_0_p1344_lanes = Lambda_inv_0_0_p1343_lanes * inverse_D1;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_0_p1346_lanes = Lambda_inv_0_0_p1329_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p1348_lanes = Lambda_inv_0_0_p1306_lanes * inverse_D3;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1350_lanes = Lambda_inv_0_0_p1279_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1352_lanes = Lambda_inv_0_0_p1259_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p209 = Lambda_inv_0_0_p1239_lanes[7] * inverse_D6;
  const Real Lambda_inv_0_6_p209 = Lambda_inv_0_0_p1239_lanes[6] * inverse_D6;
  const Lanes<8> Lambda_inv_0_0_p1354_lanes = Lambda_inv_0_0_p1239_lanes * inverse_D6;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1356_lanes = Lambda_inv_0_0_p1186_lanes * inverse_D7_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1358_lanes = Lambda_inv_0_0_p1180_lanes * inverse_D8_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1360_lanes = Lambda_inv_0_0_p1156_lanes * inverse_D9_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1362_lanes = Lambda_inv_0_0_p1135_lanes * inverse_D10_lanes[0];
  const Lanes<8> Lambda_inv_0_0_p1363_lanes = Lambda_inv_0_0_p1362_lanes *
      Lambda_inv_0_0_p1135_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1364_lanes = Lambda_inv_0_0_p1121_lanes * inverse_D11_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_0_p1366_lanes = Lambda_inv_0_0_p1092_lanes * inverse_D12_lanes[0];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_inv_0_0_p1368_lanes = 0.086 * Lambda_inv_0_0_p1085_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_inv_0_0_p1369_lanes = detail::make_pack<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_pack<Real>(Lambda_inv_0_0_p1085_lanes[0],
      Lambda_inv_0_1_p43_lanes[0], Lambda_inv_0_2_p51_lanes[0], Lambda_inv_0_3_p36_lanes[0],
      Lambda_inv_0_3_p36_lanes[1], Lambda_inv_0_3_p36_lanes[2], Lambda_inv_0_0_p1085_lanes[0],
      Lambda_inv_0_0_p1085_lanes[0]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_0_p1373_lanes = Lambda_inv_0_0_p1369_lanes *
      Lambda_inv_0_0_p1368_lanes[0] + Lambda_inv_0_0_p1366_lanes * Lambda_inv_0_0_p1092_lanes[0] +
      Lambda_inv_0_0_p1364_lanes * Lambda_inv_0_0_p1121_lanes[0] + Lambda_inv_0_0_p1363_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_0_p1376_lanes = Lambda_inv_0_0_p1373_lanes +
      Lambda_inv_0_0_p1360_lanes * Lambda_inv_0_0_p1156_lanes[0] + Lambda_inv_0_0_p1358_lanes *
      Lambda_inv_0_0_p1180_lanes[0] + Lambda_inv_0_0_p1356_lanes * Lambda_inv_0_0_p1186_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_0_p1377_lanes = Lambda_inv_0_0_p1376_lanes +
      Lambda_inv_0_0_p1354_lanes * Lambda_inv_0_0_p1239_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_0_p1380_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1377_lanes[0],
      Lambda_inv_0_0_p1377_lanes[1], Lambda_inv_0_0_p1377_lanes[2], Lambda_inv_0_0_p1377_lanes[3],
      Lambda_inv_0_0_p1377_lanes[4], Lambda_inv_0_0_p1377_lanes[5], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[0], Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[0]) +
      Lambda_inv_0_0_p1352_lanes * Lambda_inv_0_0_p1259_lanes[0] + Lambda_inv_0_0_p1350_lanes *
      Lambda_inv_0_0_p1279_lanes[0] + Lambda_inv_0_0_p1348_lanes * Lambda_inv_0_0_p1306_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_0_lanes = Lambda_inv_0_0_p1380_lanes + Lambda_inv_0_0_p1346_lanes *
      Lambda_inv_0_0_p1329_lanes[0] + Lambda_inv_0_0_p1344_lanes * Lambda_inv_0_0_p1343_lanes[0];
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

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_8_p67_lanes = c20 *
      detail::make_pack<Real>(Lambda_inv_0_2_p60_lanes[1], Lambda_inv_0_9_p2_lanes[1],
      Lambda_inv_0_9_p2_lanes[2], Lambda_inv_0_9_p2_lanes[3], Lambda_inv_0_2_p60_lanes[1],
      Lambda_inv_0_2_p60_lanes[1], Lambda_inv_0_2_p60_lanes[1], Lambda_inv_0_2_p60_lanes[1]) - s20 *
      Lambda_inv_0_8_p54_lanes - inverse_D11_p1_lanes[1] * Lambda_inv_0_8_p56_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_0_9_p15_lanes = 3.0523172236718206 *
      detail::make_pack<Real>(Lambda_inv_0_6_p43, Lambda_inv_0_6_p43, Lambda_inv_0_7_p42,
      Lambda_inv_0_11_p1, Lambda_inv_0_6_p43, Lambda_inv_0_6_p43, Lambda_inv_0_6_p43,
      Lambda_inv_0_6_p43);
  const Lanes<8> Lambda_inv_0_9_p17_lanes = 17.32841575379867 *
      detail::make_pack<Real>(Lambda_inv_0_6_p43, Lambda_inv_0_6_p43, Lambda_inv_0_7_p42,
      Lambda_inv_0_11_p1, Lambda_inv_0_6_p43, Lambda_inv_0_6_p43, Lambda_inv_0_6_p43,
      Lambda_inv_0_6_p43);
  const Lanes<8> Lambda_inv_0_9_p19_lanes = s20 * Lambda_inv_0_9_p15_lanes - c20 *
      Lambda_inv_0_9_p17_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_8_p70_lanes = detail::make_pack<Real>(Lambda_inv_0_2_p80_lanes[1],
      Lambda_inv_0_9_p19_lanes[1], Lambda_inv_0_9_p19_lanes[2], Lambda_inv_0_9_p19_lanes[3],
      Lambda_inv_0_2_p80_lanes[1], Lambda_inv_0_2_p80_lanes[1], Lambda_inv_0_2_p80_lanes[1],
      Lambda_inv_0_2_p80_lanes[1]) - Lambda_inv_0_0_p61_lanes[1] * Lambda_inv_0_8_p56_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p74_lanes = -(c19 * Lambda_inv_0_8_p67_lanes);
  const Lanes<8> Lambda_inv_0_8_p76_lanes = 0.269 * Lambda_inv_0_8_p70_lanes - s19 *
      Lambda_inv_0_8_p67_lanes - inverse_D10_p1_lanes[1] * Lambda_inv_0_8_p74_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_9_p28_lanes = Lambda_inv_0_0_p35_lanes[1] * Lambda_inv_0_8_p56_lanes;
  const Lanes<8> Lambda_inv_0_9_p34_lanes = c20 * Lambda_inv_0_9_p15_lanes + s20 *
      Lambda_inv_0_9_p17_lanes - Lambda_inv_0_0_p11_lanes[1] * Lambda_inv_0_8_p56_lanes;
  const Lanes<8> Lambda_inv_0_9_p36_lanes = c19 * Lambda_inv_0_9_p28_lanes + s19 *
      Lambda_inv_0_9_p34_lanes;
  const Real Lambda_inv_0_8_p78 = s19 * Lambda_inv_0_8_p57 - c19 * Lambda_inv_0_8_p59;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p81_lanes = 0.269 *
      detail::make_pack<Real>(Lambda_inv_0_8_p78, Lambda_inv_0_9_p36_lanes[1],
      Lambda_inv_0_9_p36_lanes[2], Lambda_inv_0_9_p36_lanes[3], Lambda_inv_0_8_p78,
      Lambda_inv_0_8_p78, Lambda_inv_0_8_p78, Lambda_inv_0_8_p78) - inverse_D10_p8_lanes[1] *
      Lambda_inv_0_8_p74_lanes;
  const Lanes<8> Lambda_inv_0_8_p86_lanes = s18 * Lambda_inv_0_8_p76_lanes + c18 *
      Lambda_inv_0_8_p81_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p88_lanes = c18 * Lambda_inv_0_8_p76_lanes - s18 *
      Lambda_inv_0_8_p81_lanes - Lambda_inv_0_0_p231_lanes[1] * Lambda_inv_0_8_p86_lanes;
  const Lanes<8> Lambda_inv_0_8_p90_lanes = Lambda_inv_0_0_p221_lanes[1] * Lambda_inv_0_8_p86_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_0_8_p96_lanes = -detail::make_pack<Real>(Lambda_inv_0_8_p78,
      Lambda_inv_0_9_p36_lanes[1], Lambda_inv_0_9_p36_lanes[2], Lambda_inv_0_9_p36_lanes[3],
      Lambda_inv_0_8_p78, Lambda_inv_0_8_p78, Lambda_inv_0_8_p78, Lambda_inv_0_8_p78) +
      Lambda_inv_0_0_p55_lanes[1] * Lambda_inv_0_8_p74_lanes;
  const Lanes<8> Lambda_inv_0_8_p99_lanes = Lambda_inv_0_8_p70_lanes -
      Lambda_inv_0_0_p119_lanes[1] * Lambda_inv_0_8_p74_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p102_lanes = s18 * Lambda_inv_0_8_p96_lanes + c18 *
      Lambda_inv_0_8_p99_lanes - Lambda_inv_0_0_p191_lanes[1] * Lambda_inv_0_8_p86_lanes;
  const Lanes<8> Lambda_inv_0_8_p107_lanes = c17 * Lambda_inv_0_8_p90_lanes - s17 *
      Lambda_inv_0_8_p88_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p108_lanes = Lambda_inv_0_0_p259_lanes[1] *
      Lambda_inv_0_8_p107_lanes;
  const Lanes<8> Lambda_inv_0_8_p109_lanes = c17 * Lambda_inv_0_8_p88_lanes + s17 *
      Lambda_inv_0_8_p90_lanes + 0.282 * Lambda_inv_0_8_p102_lanes - Lambda_inv_0_8_p108_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_0_9_p72_lanes = s19 * Lambda_inv_0_9_p28_lanes - c19 *
      Lambda_inv_0_9_p34_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p115_lanes = -(detail::make_pack<Real>(Lambda_inv_0_2_p129_lanes[1],
      Lambda_inv_0_9_p72_lanes[1], Lambda_inv_0_9_p72_lanes[2], Lambda_inv_0_9_p72_lanes[3],
      Lambda_inv_0_2_p129_lanes[1], Lambda_inv_0_2_p129_lanes[1], Lambda_inv_0_2_p129_lanes[1],
      Lambda_inv_0_2_p129_lanes[1]) - Lambda_inv_0_0_p337_lanes[1] * Lambda_inv_0_8_p74_lanes) -
      Lambda_inv_0_0_p363_lanes[1] * Lambda_inv_0_8_p86_lanes;
  const Lanes<8> Lambda_inv_0_8_p121_lanes = c18 * Lambda_inv_0_8_p96_lanes - s18 *
      Lambda_inv_0_8_p99_lanes - Lambda_inv_0_0_p317_lanes[1] * Lambda_inv_0_8_p86_lanes;
  const Lanes<8> Lambda_inv_0_8_p123_lanes = s17 * Lambda_inv_0_8_p115_lanes - c17 *
      Lambda_inv_0_8_p121_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p126_lanes = 0.282 * Lambda_inv_0_8_p123_lanes -
      Lambda_inv_0_0_p401_lanes[1] * Lambda_inv_0_8_p107_lanes;
  const Lanes<8> Lambda_inv_0_8_p128_lanes = c16 * Lambda_inv_0_8_p109_lanes - s16 *
      Lambda_inv_0_8_p126_lanes;
  const Lanes<8> Lambda_inv_0_8_p135_lanes = -(s17 * Lambda_inv_0_8_p121_lanes + c17 *
      Lambda_inv_0_8_p115_lanes) + Lambda_inv_0_0_p515_lanes[1] * Lambda_inv_0_8_p107_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_8_p137_lanes = -Lambda_inv_0_8_p135_lanes +
      Lambda_inv_0_0_p555_lanes[1] * Lambda_inv_0_8_p128_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_0_8_p142_lanes = -Lambda_inv_0_8_p123_lanes +
      Lambda_inv_0_0_p569_lanes[1] * Lambda_inv_0_8_p107_lanes;
  const Lanes<8> Lambda_inv_0_8_p145_lanes = Lambda_inv_0_8_p102_lanes -
      Lambda_inv_0_0_p577_lanes[1] * Lambda_inv_0_8_p107_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_0_8_p148_lanes = s16 * Lambda_inv_0_8_p142_lanes + c16 *
      Lambda_inv_0_8_p145_lanes - Lambda_inv_0_0_p609_lanes[1] * Lambda_inv_0_8_p128_lanes;
  const Lanes<8> Lambda_inv_0_8_p155_lanes = s16 * Lambda_inv_0_8_p109_lanes + c16 *
      Lambda_inv_0_8_p126_lanes - inverse_D7_p1_lanes[1] * Lambda_inv_0_8_p128_lanes;
  const Lanes<8> Lambda_inv_0_8_p157_lanes = Lambda_inv_0_0_p1082_lanes[1] *
      Lambda_inv_0_8_p128_lanes;
  const Lanes<8> Lambda_inv_0_8_p159_lanes = s15 * Lambda_inv_0_8_p157_lanes + c15 *
      Lambda_inv_0_8_p155_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p161_lanes = s15 * Lambda_inv_0_8_p137_lanes + c15 *
      Lambda_inv_0_8_p148_lanes - Lambda_inv_0_0_p837_lanes[1] * Lambda_inv_0_8_p159_lanes;
  const Lanes<8> Lambda_inv_0_8_p167_lanes = c15 * Lambda_inv_0_8_p137_lanes - s15 *
      Lambda_inv_0_8_p148_lanes - Lambda_inv_0_0_p639_lanes[1] * Lambda_inv_0_8_p159_lanes;
  const Lanes<8> Lambda_inv_0_8_p169_lanes = Lambda_inv_0_0_p679_lanes[1] *
      Lambda_inv_0_8_p159_lanes;
  const Lanes<8> Lambda_inv_0_8_p175_lanes = c16 * Lambda_inv_0_8_p142_lanes - s16 *
      Lambda_inv_0_8_p145_lanes - Lambda_inv_0_0_p657_lanes[1] * Lambda_inv_0_8_p128_lanes -
      Lambda_inv_0_8_p169_lanes;
  const Lanes<8> Lambda_inv_0_8_p177_lanes = s14 * Lambda_inv_0_8_p175_lanes + c14 *
      Lambda_inv_0_8_p167_lanes;
  const Lanes<8> Lambda_inv_0_8_p179_lanes = 0.226 * Lambda_inv_0_8_p161_lanes + (-0.18) *
      Lambda_inv_0_8_p177_lanes;
  const Lanes<8> Lambda_inv_0_8_p184_lanes = c15 * Lambda_inv_0_8_p157_lanes - s15 *
      Lambda_inv_0_8_p155_lanes - inverse_D6_p5_lanes[1] * Lambda_inv_0_8_p159_lanes;
  const Lanes<8> Lambda_inv_0_8_p186_lanes = Lambda_inv_0_0_p1081_lanes[1] *
      Lambda_inv_0_8_p159_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p190_lanes = -(c14 * Lambda_inv_0_8_p186_lanes + s14 *
      Lambda_inv_0_8_p184_lanes + Lambda_inv_0_8_p179_lanes);
  const Lanes<8> Lambda_inv_0_8_p191_lanes = inverse_D5_p16 * Lambda_inv_0_8_p190_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_0_8_p194_lanes = c14 * Lambda_inv_0_8_p175_lanes - s14 *
      Lambda_inv_0_8_p167_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p200_lanes = (-0.18) * Lambda_inv_0_8_p194_lanes -
      (s14 * Lambda_inv_0_8_p186_lanes - c14 * Lambda_inv_0_8_p184_lanes) -
      Lambda_inv_0_8_p191_lanes;
  const Lanes<8> Lambda_inv_0_8_p204_lanes = 0.226 * Lambda_inv_0_8_p194_lanes - inverse_D5_p22 *
      Lambda_inv_0_8_p190_lanes;
  const Lanes<8> Lambda_inv_0_8_p208_lanes = Lambda_inv_0_8_p194_lanes - Lambda_inv_0_0_p993 *
      Lambda_inv_0_8_p190_lanes;
  const Lanes<8> Lambda_inv_0_8_p210_lanes = s6 * Lambda_inv_0_8_p200_lanes + c6 *
      Lambda_inv_0_8_p204_lanes + 0.072 * Lambda_inv_0_8_p208_lanes;
  const Lanes<8> Lambda_inv_0_8_p213_lanes = Lambda_inv_0_8_p177_lanes + Lambda_inv_0_0_p930 *
      Lambda_inv_0_8_p190_lanes;
  const Lanes<8> Lambda_inv_0_8_p216_lanes = Lambda_inv_0_8_p161_lanes - Lambda_inv_0_0_p984 *
      Lambda_inv_0_8_p190_lanes;
  const Lanes<8> Lambda_inv_0_8_p218_lanes = s6 * Lambda_inv_0_8_p213_lanes + c6 *
      Lambda_inv_0_8_p216_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p221_lanes = -(0.072 * Lambda_inv_0_8_p218_lanes) +
      Lambda_inv_0_0_p1020 * Lambda_inv_0_8_p210_lanes;
  const Lanes<8> Lambda_inv_0_8_p227_lanes = c6 * Lambda_inv_0_8_p200_lanes - s6 *
      Lambda_inv_0_8_p204_lanes - Lambda_inv_0_0_p1022 * Lambda_inv_0_8_p210_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p230_lanes = -(s5 * Lambda_inv_0_8_p221_lanes + c5 *
      Lambda_inv_0_8_p227_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p236_lanes = Lambda_inv_0_8_p218_lanes - Lambda_inv_0_0_p1005 *
      Lambda_inv_0_8_p210_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p239_lanes = -(s5 * Lambda_inv_0_8_p227_lanes - c5 *
      Lambda_inv_0_8_p221_lanes + 0.21799999999999997 * Lambda_inv_0_8_p236_lanes);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p247_lanes = c6 * Lambda_inv_0_8_p213_lanes - s6 *
      Lambda_inv_0_8_p216_lanes - Lambda_inv_0_0_p1033 * Lambda_inv_0_8_p210_lanes;
  const Lanes<8> Lambda_inv_0_8_p250_lanes = Lambda_inv_0_8_p208_lanes - Lambda_inv_0_0_p1029 *
      Lambda_inv_0_8_p210_lanes;
  const Lanes<8> Lambda_inv_0_8_p252_lanes = s5 * Lambda_inv_0_8_p247_lanes - c5 *
      Lambda_inv_0_8_p250_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p256_lanes = c4 * (-(0.21799999999999997 *
      Lambda_inv_0_8_p252_lanes) + inverse_D3_p2 * Lambda_inv_0_8_p230_lanes);
  const Lanes<8> Lambda_inv_0_8_p257_lanes = s4 * (Lambda_inv_0_8_p239_lanes - inverse_D3_p1 *
      Lambda_inv_0_8_p230_lanes) + Lambda_inv_0_8_p256_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p258_lanes = Lambda_inv_0_0_p1063 * Lambda_inv_0_8_p257_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p265_lanes = s4 * (Lambda_inv_0_8_p236_lanes +
      Lambda_inv_0_0_p1050 * Lambda_inv_0_8_p230_lanes);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p267_lanes = c4 * (-Lambda_inv_0_8_p252_lanes +
      Lambda_inv_0_0_p1041 * Lambda_inv_0_8_p230_lanes) - Lambda_inv_0_8_p265_lanes -
      Lambda_inv_0_8_p258_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p275_lanes = -(s5 * Lambda_inv_0_8_p250_lanes + c5 *
      Lambda_inv_0_8_p247_lanes) - Lambda_inv_0_0_p1068 * Lambda_inv_0_8_p230_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p277_lanes = -Lambda_inv_0_8_p275_lanes + Lambda_inv_0_0_p1073 *
      Lambda_inv_0_8_p257_lanes;
  const Lanes<8> Lambda_inv_0_8_p279_lanes = c3 * Lambda_inv_0_8_p267_lanes - s3 *
      Lambda_inv_0_8_p277_lanes;
  const Lanes<8> Lambda_inv_0_8_p280_lanes = 0.422 * Lambda_inv_0_8_p279_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_8_p289_lanes = s2 * (s3 * Lambda_inv_0_8_p267_lanes + c3 *
      Lambda_inv_0_8_p277_lanes - Lambda_inv_0_0_p1335 * Lambda_inv_0_8_p280_lanes);
  const Lanes<8> Lambda_inv_0_8_p291_lanes = 0.434 *
      (c2 * (Lambda_inv_0_8_p279_lanes - Lambda_inv_0_0_p1080 * Lambda_inv_0_8_p280_lanes) -
      Lambda_inv_0_8_p289_lanes);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_8_p292_lanes = Lambda_inv_0_8_p291_lanes * inverse_D1;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_0_8_p294_lanes = Lambda_inv_0_8_p280_lanes * inverse_D2;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p296_lanes = Lambda_inv_0_8_p257_lanes * inverse_D3;
  const Lanes<8> Lambda_inv_0_8_p297_lanes = Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_0_8_p298_lanes = Lambda_inv_0_8_p230_lanes * inverse_D4;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_inv_0_8_p300_lanes = Lambda_inv_0_8_p210_lanes * inverse_D5;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_0_8_p302_lanes = Lambda_inv_0_8_p190_lanes * inverse_D6;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_0_8_p306_lanes = Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[0] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[0] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[0] + Lambda_inv_0_8_p297_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_0_8_lanes = Lambda_inv_0_8_p306_lanes + Lambda_inv_0_8_p294_lanes *
      Lambda_inv_0_0_p1329_lanes[0] + Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[0];
  Lambda_inv[8] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[96] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[9] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[108] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[10] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[120] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[11] = Lambda_inv_0_8_lanes[3];
  Lambda_inv[132] = Lambda_inv_0_8_lanes[3];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_1_1_p10_lanes = Lambda_inv_0_0_p1362_lanes *
      Lambda_inv_0_0_p1135_lanes[1];

  // link 1 (calf), articulated inertia
  const Lanes<2> Lambda_inv_1_1_p13_lanes = 0.086 * Lambda_inv_0_1_p43_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_1_1_p17_lanes = Lambda_inv_0_0_p1369_lanes *
      Lambda_inv_1_1_p13_lanes[0] + Lambda_inv_0_0_p1366_lanes * Lambda_inv_0_0_p1092_lanes[1] +
      Lambda_inv_0_0_p1364_lanes * Lambda_inv_0_0_p1121_lanes[1] + Lambda_inv_1_1_p10_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_1_1_p20_lanes = Lambda_inv_1_1_p17_lanes + Lambda_inv_0_0_p1360_lanes *
      Lambda_inv_0_0_p1156_lanes[1] + Lambda_inv_0_0_p1358_lanes * Lambda_inv_0_0_p1180_lanes[1] +
      Lambda_inv_0_0_p1356_lanes * Lambda_inv_0_0_p1186_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_1_1_p21_lanes = Lambda_inv_1_1_p20_lanes + Lambda_inv_0_0_p1354_lanes *
      Lambda_inv_0_0_p1239_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_1_1_p24_lanes = detail::make_pack<Real>(Lambda_inv_1_1_p21_lanes[1],
      Lambda_inv_1_1_p21_lanes[1], Lambda_inv_1_1_p21_lanes[2], Lambda_inv_1_1_p21_lanes[3],
      Lambda_inv_1_1_p21_lanes[4], Lambda_inv_1_1_p21_lanes[5], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[1], Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[1]) +
      Lambda_inv_0_0_p1352_lanes * Lambda_inv_0_0_p1259_lanes[1] + Lambda_inv_0_0_p1350_lanes *
      Lambda_inv_0_0_p1279_lanes[1] + Lambda_inv_0_0_p1348_lanes * Lambda_inv_0_0_p1306_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_1_1_lanes = Lambda_inv_1_1_p24_lanes + Lambda_inv_0_0_p1346_lanes *
      Lambda_inv_0_0_p1329_lanes[1] + Lambda_inv_0_0_p1344_lanes * Lambda_inv_0_0_p1343_lanes[1];
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

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_1_8_p3_lanes = Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[1];
  const Lanes<8> Lambda_inv_1_8_p9_lanes = Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[1] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[1] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[1] + Lambda_inv_1_8_p3_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_1_8_lanes = Lambda_inv_1_8_p9_lanes + Lambda_inv_0_8_p294_lanes *
      Lambda_inv_0_0_p1329_lanes[1] + Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[1];
  Lambda_inv[20] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[97] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[21] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[109] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[22] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[121] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[23] = Lambda_inv_1_8_lanes[3];
  Lambda_inv[133] = Lambda_inv_1_8_lanes[3];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_2_2_p10_lanes = Lambda_inv_0_0_p1362_lanes *
      Lambda_inv_0_0_p1135_lanes[2];
  const Lanes<8> Lambda_inv_2_2_p16_lanes = Lambda_inv_0_0_p1369_lanes *
      Lambda_inv_0_2_p51_lanes[0] + Lambda_inv_0_0_p1366_lanes * Lambda_inv_0_0_p1092_lanes[2] +
      Lambda_inv_0_0_p1364_lanes * Lambda_inv_0_0_p1121_lanes[2] + Lambda_inv_2_2_p10_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_2_2_p19_lanes = Lambda_inv_2_2_p16_lanes + Lambda_inv_0_0_p1360_lanes *
      Lambda_inv_0_0_p1156_lanes[2] + Lambda_inv_0_0_p1358_lanes * Lambda_inv_0_0_p1180_lanes[2] +
      Lambda_inv_0_0_p1356_lanes * Lambda_inv_0_0_p1186_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_2_2_p20_lanes = Lambda_inv_2_2_p19_lanes + Lambda_inv_0_0_p1354_lanes *
      Lambda_inv_0_0_p1239_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_2_2_p23_lanes = detail::make_pack<Real>(Lambda_inv_2_2_p20_lanes[2],
      Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[3],
      Lambda_inv_2_2_p20_lanes[4], Lambda_inv_2_2_p20_lanes[5], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[2], Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[2]) +
      Lambda_inv_0_0_p1352_lanes * Lambda_inv_0_0_p1259_lanes[2] + Lambda_inv_0_0_p1350_lanes *
      Lambda_inv_0_0_p1279_lanes[2] + Lambda_inv_0_0_p1348_lanes * Lambda_inv_0_0_p1306_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_2_2_lanes = Lambda_inv_2_2_p23_lanes + Lambda_inv_0_0_p1346_lanes *
      Lambda_inv_0_0_p1329_lanes[2] + Lambda_inv_0_0_p1344_lanes * Lambda_inv_0_0_p1343_lanes[2];
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

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_2_8_p3_lanes = Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[2];
  const Lanes<8> Lambda_inv_2_8_p9_lanes = Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[2] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[2] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[2] + Lambda_inv_2_8_p3_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_2_8_lanes = Lambda_inv_2_8_p9_lanes + Lambda_inv_0_8_p294_lanes *
      Lambda_inv_0_0_p1329_lanes[2] + Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[2];
  Lambda_inv[32] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[98] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[33] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[110] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[34] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[122] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[35] = Lambda_inv_2_8_lanes[3];
  Lambda_inv[134] = Lambda_inv_2_8_lanes[3];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_inv_3_3_p10_lanes = Lambda_inv_0_0_p1362_lanes *
      Lambda_inv_0_0_p1135_lanes[3];
  const Lanes<8> Lambda_inv_3_3_p16_lanes = Lambda_inv_0_0_p1369_lanes *
      Lambda_inv_0_3_p36_lanes[0] + Lambda_inv_0_0_p1366_lanes * Lambda_inv_0_0_p1092_lanes[3] +
      Lambda_inv_0_0_p1364_lanes * Lambda_inv_0_0_p1121_lanes[3] + Lambda_inv_3_3_p10_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_inv_3_3_p19_lanes = Lambda_inv_3_3_p16_lanes + Lambda_inv_0_0_p1360_lanes *
      Lambda_inv_0_0_p1156_lanes[3] + Lambda_inv_0_0_p1358_lanes * Lambda_inv_0_0_p1180_lanes[3] +
      Lambda_inv_0_0_p1356_lanes * Lambda_inv_0_0_p1186_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_3_3_p20_lanes = Lambda_inv_3_3_p19_lanes + Lambda_inv_0_0_p1354_lanes *
      Lambda_inv_0_0_p1239_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_3_3_p23_lanes = detail::make_pack<Real>(Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[4], Lambda_inv_3_3_p20_lanes[5], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[3], Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[3]) +
      Lambda_inv_0_0_p1352_lanes * Lambda_inv_0_0_p1259_lanes[3] + Lambda_inv_0_0_p1350_lanes *
      Lambda_inv_0_0_p1279_lanes[3] + Lambda_inv_0_0_p1348_lanes * Lambda_inv_0_0_p1306_lanes[3];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_3_3_lanes = Lambda_inv_3_3_p23_lanes + Lambda_inv_0_0_p1346_lanes *
      Lambda_inv_0_0_p1329_lanes[3] + Lambda_inv_0_0_p1344_lanes * Lambda_inv_0_0_p1343_lanes[3];
  Lambda_inv[39] = Lambda_inv_3_3_lanes[3];
  Lambda_inv[40] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[51] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[41] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[63] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[42] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[75] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[43] = Lambda_inv_3_3_lanes[7];
  Lambda_inv[87] = Lambda_inv_3_3_lanes[7];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_3_8_p3_lanes = Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[3];
  const Lanes<8> Lambda_inv_3_8_p9_lanes = Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[3] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[3] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[3] + Lambda_inv_3_8_p3_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_3_8_lanes = Lambda_inv_3_8_p9_lanes + Lambda_inv_0_8_p294_lanes *
      Lambda_inv_0_0_p1329_lanes[3] + Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[3];
  Lambda_inv[44] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[99] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[45] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[111] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[46] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[123] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[47] = Lambda_inv_3_8_lanes[3];
  Lambda_inv[135] = Lambda_inv_3_8_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_6_8_p1_lanes = Lambda_inv_0_8_p159_lanes * inverse_D7_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_inv_4_5_p6_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1356_lanes[5],
      Lambda_inv_6_8_p1_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[4],
      Lambda_inv_0_8_p159_lanes[2]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_6_8_p2_lanes = Lambda_inv_0_8_p128_lanes * inverse_D8_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_inv_4_5_p7_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1358_lanes[5],
      Lambda_inv_6_8_p2_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1180_lanes[4],
      Lambda_inv_0_8_p128_lanes[2]);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p3_lanes = Lambda_inv_0_8_p107_lanes * inverse_D9_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_inv_4_5_p8_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1360_lanes[5],
      Lambda_inv_6_8_p3_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1156_lanes[4],
      Lambda_inv_0_8_p107_lanes[2]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p4_lanes = Lambda_inv_0_8_p86_lanes * inverse_D10_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_4_5_p9_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1362_lanes[5],
      Lambda_inv_6_8_p4_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1135_lanes[4],
      Lambda_inv_0_8_p86_lanes[2]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_inv_6_8_p5_lanes = Lambda_inv_0_8_p74_lanes * inverse_D11_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_4_5_p10_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1364_lanes[5],
      Lambda_inv_6_8_p5_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1121_lanes[4],
      Lambda_inv_0_8_p74_lanes[2]);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_inv_6_8_p6_lanes = Lambda_inv_0_8_p56_lanes * inverse_D12_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_inv_4_5_p11_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1366_lanes[5],
      Lambda_inv_6_8_p6_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1092_lanes[4],
      Lambda_inv_0_8_p56_lanes[2]);
  const Lanes<2> Lambda_inv_4_4_p7_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1366_lanes[4],
      Lambda_inv_6_8_p6_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p1092_lanes[4],
      Lambda_inv_0_8_p56_lanes[2]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_inv_4_4_p9_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1364_lanes[4],
      Lambda_inv_6_8_p5_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p1121_lanes[4],
      Lambda_inv_0_8_p74_lanes[2]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_4_4_p11_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1362_lanes[4],
      Lambda_inv_6_8_p4_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p1135_lanes[4],
      Lambda_inv_0_8_p86_lanes[2]);

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_inv_4_4_p13_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1360_lanes[4],
      Lambda_inv_6_8_p3_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p1156_lanes[4],
      Lambda_inv_0_8_p107_lanes[2]);

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_inv_4_4_p15_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1358_lanes[4],
      Lambda_inv_6_8_p2_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p1180_lanes[4],
      Lambda_inv_0_8_p128_lanes[2]);
  const Lanes<8> Lambda_inv_4_4_p16_lanes = Lambda_inv_0_0_p1369_lanes *
      Lambda_inv_0_3_p36_lanes[1] + detail::make_pack<Real>(Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0], Lambda_inv_4_5_p11_lanes[0], Lambda_inv_4_4_p7_lanes[0],
      Lambda_inv_4_4_p7_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p9_lanes[0],
      Lambda_inv_4_4_p9_lanes[0], Lambda_inv_4_4_p9_lanes[0], Lambda_inv_4_4_p9_lanes[0],
      Lambda_inv_4_4_p9_lanes[0], Lambda_inv_4_5_p10_lanes[0], Lambda_inv_4_4_p9_lanes[0],
      Lambda_inv_4_4_p9_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p11_lanes[0],
      Lambda_inv_4_4_p11_lanes[0], Lambda_inv_4_4_p11_lanes[0], Lambda_inv_4_4_p11_lanes[0],
      Lambda_inv_4_4_p11_lanes[0], Lambda_inv_4_5_p9_lanes[0], Lambda_inv_4_4_p11_lanes[0],
      Lambda_inv_4_4_p11_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p13_lanes[0],
      Lambda_inv_4_4_p13_lanes[0], Lambda_inv_4_4_p13_lanes[0], Lambda_inv_4_4_p13_lanes[0],
      Lambda_inv_4_4_p13_lanes[0], Lambda_inv_4_5_p8_lanes[0], Lambda_inv_4_4_p13_lanes[0],
      Lambda_inv_4_4_p13_lanes[0]) + detail::make_pack<Real>(Lambda_inv_4_4_p15_lanes[0],
      Lambda_inv_4_4_p15_lanes[0], Lambda_inv_4_4_p15_lanes[0], Lambda_inv_4_4_p15_lanes[0],
      Lambda_inv_4_4_p15_lanes[0], Lambda_inv_4_5_p7_lanes[0], Lambda_inv_4_4_p15_lanes[0],
      Lambda_inv_4_4_p15_lanes[0]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_inv_4_4_p17_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1356_lanes[4],
      Lambda_inv_6_8_p1_lanes[2]) * detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[4],
      Lambda_inv_0_8_p159_lanes[2]);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_inv_4_4_p19_lanes = Lambda_inv_4_4_p16_lanes +
      detail::make_pack<Real>(Lambda_inv_4_4_p17_lanes[0], Lambda_inv_4_4_p17_lanes[0],
      Lambda_inv_4_4_p17_lanes[0], Lambda_inv_4_4_p17_lanes[0], Lambda_inv_4_4_p17_lanes[0],
      Lambda_inv_4_5_p6_lanes[0], Lambda_inv_4_4_p17_lanes[0], Lambda_inv_4_4_p17_lanes[0]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p1354_lanes[4] * Lambda_inv_0_0_p1239_lanes[4],
      Lambda_inv_0_0_p1354_lanes[4] * Lambda_inv_0_0_p1239_lanes[4], Lambda_inv_0_0_p1354_lanes[4] *
      Lambda_inv_0_0_p1239_lanes[4], Lambda_inv_0_0_p1354_lanes[4] * Lambda_inv_0_0_p1239_lanes[4],
      Lambda_inv_0_0_p1354_lanes[4] * Lambda_inv_0_0_p1239_lanes[4], Lambda_inv_0_0_p1354_lanes[5] *
      Lambda_inv_0_0_p1239_lanes[4], Lambda_inv_0_0_p1354_lanes[4] * Lambda_inv_0_0_p1239_lanes[4],
      Lambda_inv_0_0_p1354_lanes[4] * Lambda_inv_0_0_p1239_lanes[4]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_4_4_p22_lanes = detail::make_pack<Real>(Lambda_inv_4_4_p19_lanes[4],
      Lambda_inv_4_4_p19_lanes[4], Lambda_inv_4_4_p19_lanes[4], Lambda_inv_4_4_p19_lanes[4],
      Lambda_inv_4_4_p19_lanes[4], Lambda_inv_4_4_p19_lanes[5], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[4], Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[4]) +
      Lambda_inv_0_0_p1352_lanes * Lambda_inv_0_0_p1259_lanes[4] + Lambda_inv_0_0_p1350_lanes *
      Lambda_inv_0_0_p1279_lanes[4] + Lambda_inv_0_0_p1348_lanes * Lambda_inv_0_0_p1306_lanes[4];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_4_4_lanes = Lambda_inv_4_4_p22_lanes + Lambda_inv_0_0_p1346_lanes *
      Lambda_inv_0_0_p1329_lanes[4] + Lambda_inv_0_0_p1344_lanes * Lambda_inv_0_0_p1343_lanes[4];
  Lambda_inv[52] = Lambda_inv_4_4_lanes[4];
  Lambda_inv[53] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[64] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[54] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[76] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[55] = Lambda_inv_4_4_lanes[7];
  Lambda_inv[88] = Lambda_inv_4_4_lanes[7];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_4_8_p3_lanes = Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[4];
  const Lanes<8> Lambda_inv_4_8_p9_lanes = Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[4] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[4] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[4] + Lambda_inv_4_8_p3_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_4_8_lanes = Lambda_inv_4_8_p9_lanes + Lambda_inv_0_8_p294_lanes *
      Lambda_inv_0_0_p1329_lanes[4] + Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[4];
  Lambda_inv[56] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[100] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[57] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[112] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[58] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[124] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[59] = Lambda_inv_4_8_lanes[3];
  Lambda_inv[136] = Lambda_inv_4_8_lanes[3];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_5_5_p9_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1362_lanes[5],
      Lambda_inv_6_8_p4_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1135_lanes[5],
      Lambda_inv_0_8_p86_lanes[3]);

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_inv_6_8_p7_lanes = 1065.380700001509 *
      detail::make_pack<Real>(Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_6_p43, Lambda_inv_0_7_p42,
      Lambda_inv_0_11_p1, Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1],
      Lambda_inv_0_2_p51_lanes[1], Lambda_inv_0_2_p51_lanes[1]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_inv_5_5_p15_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p1369_lanes[5],
      Lambda_inv_6_8_p7_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_3_p36_lanes[2],
      Lambda_inv_0_11_p1) + detail::make_pack<Real>(Lambda_inv_0_0_p1366_lanes[5],
      Lambda_inv_6_8_p6_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1092_lanes[5],
      Lambda_inv_0_8_p56_lanes[3]) + detail::make_pack<Real>(Lambda_inv_0_0_p1364_lanes[5],
      Lambda_inv_6_8_p5_lanes[3]) * detail::make_pack<Real>(Lambda_inv_0_0_p1121_lanes[5],
      Lambda_inv_0_8_p74_lanes[3]) + Lambda_inv_5_5_p9_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_inv_5_5_p18_lanes = Lambda_inv_5_5_p15_lanes +
      detail::make_pack<Real>(Lambda_inv_0_0_p1360_lanes[5], Lambda_inv_6_8_p3_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1156_lanes[5], Lambda_inv_0_8_p107_lanes[3]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p1358_lanes[5], Lambda_inv_6_8_p2_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1180_lanes[5], Lambda_inv_0_8_p128_lanes[3]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p1356_lanes[5], Lambda_inv_6_8_p1_lanes[3]) *
      detail::make_pack<Real>(Lambda_inv_0_0_p1186_lanes[5], Lambda_inv_0_8_p159_lanes[3]);

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_5_5_p21_lanes = detail::make_pack<Real>(Lambda_inv_5_5_p18_lanes[0] +
      Lambda_inv_0_0_p1354_lanes[5] * Lambda_inv_0_0_p1239_lanes[5], Lambda_inv_5_5_p18_lanes[0] +
      Lambda_inv_0_0_p1354_lanes[5] * Lambda_inv_0_0_p1239_lanes[5], Lambda_inv_5_5_p18_lanes[0] +
      Lambda_inv_0_0_p1354_lanes[5] * Lambda_inv_0_0_p1239_lanes[5], Lambda_inv_5_5_p18_lanes[0] +
      Lambda_inv_0_0_p1354_lanes[5] * Lambda_inv_0_0_p1239_lanes[5], Lambda_inv_5_5_p18_lanes[0] +
      Lambda_inv_0_0_p1354_lanes[5] * Lambda_inv_0_0_p1239_lanes[5], Lambda_inv_5_5_p18_lanes[0] +
      Lambda_inv_0_0_p1354_lanes[5] * Lambda_inv_0_0_p1239_lanes[5], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[5], Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[5]) +
      Lambda_inv_0_0_p1352_lanes * Lambda_inv_0_0_p1259_lanes[5] + Lambda_inv_0_0_p1350_lanes *
      Lambda_inv_0_0_p1279_lanes[5] + Lambda_inv_0_0_p1348_lanes * Lambda_inv_0_0_p1306_lanes[5];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_5_5_lanes = Lambda_inv_5_5_p21_lanes + Lambda_inv_0_0_p1346_lanes *
      Lambda_inv_0_0_p1329_lanes[5] + Lambda_inv_0_0_p1344_lanes * Lambda_inv_0_0_p1343_lanes[5];
  Lambda_inv[65] = Lambda_inv_5_5_lanes[5];
  Lambda_inv[66] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[77] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[67] = Lambda_inv_5_5_lanes[7];
  Lambda_inv[89] = Lambda_inv_5_5_lanes[7];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_inv_5_8_p3_lanes = Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[5];
  const Lanes<8> Lambda_inv_5_8_p9_lanes = Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[5] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[5] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[5] + Lambda_inv_5_8_p3_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_5_8_lanes = Lambda_inv_5_8_p9_lanes + Lambda_inv_0_8_p294_lanes *
      Lambda_inv_0_0_p1329_lanes[5] + Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[5];
  Lambda_inv[68] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[101] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[69] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[113] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[70] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[125] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[71] = Lambda_inv_5_8_lanes[3];
  Lambda_inv[137] = Lambda_inv_5_8_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_7_p1 = Lambda_inv_0_7_p73 * inverse_D7_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_7_p2 = Lambda_inv_0_7_p70 * inverse_D8_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_7_p3 = Lambda_inv_0_7_p60 * inverse_D9_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_7_p4 = Lambda_inv_0_7_p54 * inverse_D10_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_6_7_p5 = Lambda_inv_0_7_p48 * inverse_D11_lanes[1];

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_6_7_p6 = Lambda_inv_0_7_p45 * inverse_D12_lanes[1];

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_6_7_p7 = 91.62274020012977 * Lambda_inv_0_1_p43_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_6_6_p7_lanes = detail::make_pack<Real>(91.62274020012977 *
      Lambda_inv_0_0_p1085_lanes[1], 91.62274020012977 * Lambda_inv_0_0_p1085_lanes[1],
      91.62274020012977 * Lambda_inv_0_0_p1085_lanes[1], 91.62274020012977 *
      Lambda_inv_0_0_p1085_lanes[1], 91.62274020012977 * Lambda_inv_0_0_p1085_lanes[1],
      91.62274020012977 * Lambda_inv_0_0_p1085_lanes[1], 91.62274020012977 *
      Lambda_inv_0_0_p1085_lanes[1], Lambda_inv_6_7_p7) * Lambda_inv_0_0_p1368_lanes[1] +
      detail::make_pack<Real>(Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45,
      Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 *
      inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 * inverse_D12_lanes[1] *
      Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45,
      Lambda_inv_0_6_p45 * inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_0_6_p45 *
      inverse_D12_lanes[1] * Lambda_inv_0_6_p45, Lambda_inv_6_7_p6 * Lambda_inv_0_6_p45) +
      detail::make_pack<Real>(Lambda_inv_0_6_p48 * inverse_D11_lanes[1] * Lambda_inv_0_6_p48,
      Lambda_inv_0_6_p48 * inverse_D11_lanes[1] * Lambda_inv_0_6_p48, Lambda_inv_0_6_p48 *
      inverse_D11_lanes[1] * Lambda_inv_0_6_p48, Lambda_inv_0_6_p48 * inverse_D11_lanes[1] *
      Lambda_inv_0_6_p48, Lambda_inv_0_6_p48 * inverse_D11_lanes[1] * Lambda_inv_0_6_p48,
      Lambda_inv_0_6_p48 * inverse_D11_lanes[1] * Lambda_inv_0_6_p48, Lambda_inv_0_6_p48 *
      inverse_D11_lanes[1] * Lambda_inv_0_6_p48, Lambda_inv_6_7_p5 * Lambda_inv_0_6_p48) +
      detail::make_pack<Real>(Lambda_inv_0_6_p54 * inverse_D10_lanes[1] * Lambda_inv_0_6_p54,
      Lambda_inv_0_6_p54 * inverse_D10_lanes[1] * Lambda_inv_0_6_p54, Lambda_inv_0_6_p54 *
      inverse_D10_lanes[1] * Lambda_inv_0_6_p54, Lambda_inv_0_6_p54 * inverse_D10_lanes[1] *
      Lambda_inv_0_6_p54, Lambda_inv_0_6_p54 * inverse_D10_lanes[1] * Lambda_inv_0_6_p54,
      Lambda_inv_0_6_p54 * inverse_D10_lanes[1] * Lambda_inv_0_6_p54, Lambda_inv_0_6_p54 *
      inverse_D10_lanes[1] * Lambda_inv_0_6_p54, Lambda_inv_6_7_p4 * Lambda_inv_0_6_p54) +
      detail::make_pack<Real>(Lambda_inv_0_6_p60 * inverse_D9_lanes[1] * Lambda_inv_0_6_p60,
      Lambda_inv_0_6_p60 * inverse_D9_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 *
      inverse_D9_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 * inverse_D9_lanes[1] *
      Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 * inverse_D9_lanes[1] * Lambda_inv_0_6_p60,
      Lambda_inv_0_6_p60 * inverse_D9_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_0_6_p60 *
      inverse_D9_lanes[1] * Lambda_inv_0_6_p60, Lambda_inv_6_7_p3 * Lambda_inv_0_6_p60) +
      detail::make_pack<Real>(Lambda_inv_0_6_p70 * inverse_D8_lanes[1] * Lambda_inv_0_6_p70,
      Lambda_inv_0_6_p70 * inverse_D8_lanes[1] * Lambda_inv_0_6_p70, Lambda_inv_0_6_p70 *
      inverse_D8_lanes[1] * Lambda_inv_0_6_p70, Lambda_inv_0_6_p70 * inverse_D8_lanes[1] *
      Lambda_inv_0_6_p70, Lambda_inv_0_6_p70 * inverse_D8_lanes[1] * Lambda_inv_0_6_p70,
      Lambda_inv_0_6_p70 * inverse_D8_lanes[1] * Lambda_inv_0_6_p70, Lambda_inv_0_6_p70 *
      inverse_D8_lanes[1] * Lambda_inv_0_6_p70, Lambda_inv_6_7_p2 * Lambda_inv_0_6_p70);

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_6_6_p13_lanes = Lambda_inv_6_6_p7_lanes +
      detail::make_pack<Real>(Lambda_inv_0_6_p73 * inverse_D7_lanes[1] * Lambda_inv_0_6_p73,
      Lambda_inv_0_6_p73 * inverse_D7_lanes[1] * Lambda_inv_0_6_p73, Lambda_inv_0_6_p73 *
      inverse_D7_lanes[1] * Lambda_inv_0_6_p73, Lambda_inv_0_6_p73 * inverse_D7_lanes[1] *
      Lambda_inv_0_6_p73, Lambda_inv_0_6_p73 * inverse_D7_lanes[1] * Lambda_inv_0_6_p73,
      Lambda_inv_0_6_p73 * inverse_D7_lanes[1] * Lambda_inv_0_6_p73, Lambda_inv_0_6_p73 *
      inverse_D7_lanes[1] * Lambda_inv_0_6_p73, Lambda_inv_6_7_p1 * Lambda_inv_0_6_p73) +
      detail::make_pack<Real>(Lambda_inv_0_6_p209 * Lambda_inv_0_0_p1239_lanes[6],
      Lambda_inv_0_6_p209 * Lambda_inv_0_0_p1239_lanes[6], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[6], Lambda_inv_0_6_p209 * Lambda_inv_0_0_p1239_lanes[6],
      Lambda_inv_0_6_p209 * Lambda_inv_0_0_p1239_lanes[6], Lambda_inv_0_6_p209 *
      Lambda_inv_0_0_p1239_lanes[6], Lambda_inv_0_6_p209 * Lambda_inv_0_0_p1239_lanes[6],
      Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p1352_lanes[6] * Lambda_inv_0_0_p1259_lanes[6],
      Lambda_inv_0_0_p1352_lanes[6] * Lambda_inv_0_0_p1259_lanes[6], Lambda_inv_0_0_p1352_lanes[6] *
      Lambda_inv_0_0_p1259_lanes[6], Lambda_inv_0_0_p1352_lanes[6] * Lambda_inv_0_0_p1259_lanes[6],
      Lambda_inv_0_0_p1352_lanes[6] * Lambda_inv_0_0_p1259_lanes[6], Lambda_inv_0_0_p1352_lanes[6] *
      Lambda_inv_0_0_p1259_lanes[6], Lambda_inv_0_0_p1352_lanes[6] * Lambda_inv_0_0_p1259_lanes[6],
      Lambda_inv_0_0_p1352_lanes[7] * Lambda_inv_0_0_p1259_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p1350_lanes[6] * Lambda_inv_0_0_p1279_lanes[6],
      Lambda_inv_0_0_p1350_lanes[6] * Lambda_inv_0_0_p1279_lanes[6], Lambda_inv_0_0_p1350_lanes[6] *
      Lambda_inv_0_0_p1279_lanes[6], Lambda_inv_0_0_p1350_lanes[6] * Lambda_inv_0_0_p1279_lanes[6],
      Lambda_inv_0_0_p1350_lanes[6] * Lambda_inv_0_0_p1279_lanes[6], Lambda_inv_0_0_p1350_lanes[6] *
      Lambda_inv_0_0_p1279_lanes[6], Lambda_inv_0_0_p1350_lanes[6] * Lambda_inv_0_0_p1279_lanes[6],
      Lambda_inv_0_0_p1350_lanes[7] * Lambda_inv_0_0_p1279_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p1348_lanes[6] * Lambda_inv_0_0_p1306_lanes[6],
      Lambda_inv_0_0_p1348_lanes[6] * Lambda_inv_0_0_p1306_lanes[6], Lambda_inv_0_0_p1348_lanes[6] *
      Lambda_inv_0_0_p1306_lanes[6], Lambda_inv_0_0_p1348_lanes[6] * Lambda_inv_0_0_p1306_lanes[6],
      Lambda_inv_0_0_p1348_lanes[6] * Lambda_inv_0_0_p1306_lanes[6], Lambda_inv_0_0_p1348_lanes[6] *
      Lambda_inv_0_0_p1306_lanes[6], Lambda_inv_0_0_p1348_lanes[6] * Lambda_inv_0_0_p1306_lanes[6],
      Lambda_inv_0_0_p1348_lanes[7] * Lambda_inv_0_0_p1306_lanes[6]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p1346_lanes[6] * Lambda_inv_0_0_p1329_lanes[6],
      Lambda_inv_0_0_p1346_lanes[6] * Lambda_inv_0_0_p1329_lanes[6], Lambda_inv_0_0_p1346_lanes[6] *
      Lambda_inv_0_0_p1329_lanes[6], Lambda_inv_0_0_p1346_lanes[6] * Lambda_inv_0_0_p1329_lanes[6],
      Lambda_inv_0_0_p1346_lanes[6] * Lambda_inv_0_0_p1329_lanes[6], Lambda_inv_0_0_p1346_lanes[6] *
      Lambda_inv_0_0_p1329_lanes[6], Lambda_inv_0_0_p1346_lanes[6] * Lambda_inv_0_0_p1329_lanes[6],
      Lambda_inv_0_0_p1346_lanes[7] * Lambda_inv_0_0_p1329_lanes[6]);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_6_6_lanes = Lambda_inv_6_6_p13_lanes +
      detail::make_pack<Real>(Lambda_inv_0_0_p1344_lanes[6] * Lambda_inv_0_0_p1343_lanes[6],
      Lambda_inv_0_0_p1344_lanes[6] * Lambda_inv_0_0_p1343_lanes[6], Lambda_inv_0_0_p1344_lanes[6] *
      Lambda_inv_0_0_p1343_lanes[6], Lambda_inv_0_0_p1344_lanes[6] * Lambda_inv_0_0_p1343_lanes[6],
      Lambda_inv_0_0_p1344_lanes[6] * Lambda_inv_0_0_p1343_lanes[6], Lambda_inv_0_0_p1344_lanes[6] *
      Lambda_inv_0_0_p1343_lanes[6], Lambda_inv_0_0_p1344_lanes[6] * Lambda_inv_0_0_p1343_lanes[6],
      Lambda_inv_0_0_p1344_lanes[7] * Lambda_inv_0_0_p1343_lanes[6]);
  Lambda_inv[78] = Lambda_inv_6_6_lanes[6];
  Lambda_inv[79] = Lambda_inv_6_6_lanes[7];
  Lambda_inv[90] = Lambda_inv_6_6_lanes[7];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_6_8_p17_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_6_p54;
  const Lanes<8> Lambda_inv_6_8_p23_lanes = Lambda_inv_6_8_p7_lanes *
      Lambda_inv_0_0_p1368_lanes[1] + Lambda_inv_6_8_p6_lanes * Lambda_inv_0_6_p45 +
      Lambda_inv_6_8_p5_lanes * Lambda_inv_0_6_p48 + Lambda_inv_6_8_p17_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_6_8_p26_lanes = Lambda_inv_6_8_p23_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_6_p60 + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_6_p70 + Lambda_inv_6_8_p1_lanes *
      Lambda_inv_0_6_p73;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_6_8_p29_lanes = Lambda_inv_6_8_p26_lanes + Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[6] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[6] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[6];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_6_8_lanes = Lambda_inv_6_8_p29_lanes + Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[6] + Lambda_inv_0_8_p294_lanes * Lambda_inv_0_0_p1329_lanes[6] +
      Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[6];
  Lambda_inv[80] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[102] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[81] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[114] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[82] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[126] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[83] = Lambda_inv_6_8_lanes[3];
  Lambda_inv[138] = Lambda_inv_6_8_lanes[3];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_7_7_p2 = Lambda_inv_6_7_p7 * Lambda_inv_1_1_p13_lanes[1] +
      Lambda_inv_6_7_p6 * Lambda_inv_0_7_p45 + Lambda_inv_6_7_p5 * Lambda_inv_0_7_p48 +
      Lambda_inv_6_7_p4 * Lambda_inv_0_7_p54 + Lambda_inv_6_7_p3 * Lambda_inv_0_7_p60;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_7_7_p3 = Lambda_inv_7_7_p2 + Lambda_inv_6_7_p2 * Lambda_inv_0_7_p70 +
      Lambda_inv_6_7_p1 * Lambda_inv_0_7_p73 + Lambda_inv_0_7_p209 * Lambda_inv_0_0_p1239_lanes[7] +
      Lambda_inv_0_0_p1352_lanes[7] * Lambda_inv_0_0_p1259_lanes[7];

  // link 1 (calf), force propagation
  Lambda_inv[91] = Lambda_inv_7_7_p3 + Lambda_inv_0_0_p1350_lanes[7] *
      Lambda_inv_0_0_p1279_lanes[7] + Lambda_inv_0_0_p1348_lanes[7] *
      Lambda_inv_0_0_p1306_lanes[7] + Lambda_inv_0_0_p1346_lanes[7] *
      Lambda_inv_0_0_p1329_lanes[7] + Lambda_inv_0_0_p1344_lanes[7] * Lambda_inv_0_0_p1343_lanes[7];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_7_8_p10_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_7_p54;
  const Lanes<8> Lambda_inv_7_8_p16_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_1_1_p13_lanes[1] +
      Lambda_inv_6_8_p6_lanes * Lambda_inv_0_7_p45 + Lambda_inv_6_8_p5_lanes * Lambda_inv_0_7_p48 +
      Lambda_inv_7_8_p10_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_7_8_p19_lanes = Lambda_inv_7_8_p16_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_7_p60 + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_7_p70 + Lambda_inv_6_8_p1_lanes *
      Lambda_inv_0_7_p73;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_7_8_p22_lanes = Lambda_inv_7_8_p19_lanes + Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_0_p1239_lanes[7] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_0_p1259_lanes[7] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_0_p1279_lanes[7];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_7_8_lanes = Lambda_inv_7_8_p22_lanes + Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_0_p1306_lanes[7] + Lambda_inv_0_8_p294_lanes * Lambda_inv_0_0_p1329_lanes[7] +
      Lambda_inv_0_8_p292_lanes * Lambda_inv_0_0_p1343_lanes[7];
  Lambda_inv[92] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[103] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[93] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[115] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[94] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[127] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[95] = Lambda_inv_7_8_lanes[3];
  Lambda_inv[139] = Lambda_inv_7_8_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_8_8_p10_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_8_p86_lanes[0];
  const Lanes<8> Lambda_inv_8_8_p16_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_2_p51_lanes[1] +
      Lambda_inv_6_8_p6_lanes * Lambda_inv_0_8_p56_lanes[0] + Lambda_inv_6_8_p5_lanes *
      Lambda_inv_0_8_p74_lanes[0] + Lambda_inv_8_8_p10_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_8_8_p19_lanes = Lambda_inv_8_8_p16_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_8_p107_lanes[0] + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_8_p128_lanes[0] +
      Lambda_inv_6_8_p1_lanes * Lambda_inv_0_8_p159_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_8_8_p22_lanes = Lambda_inv_8_8_p19_lanes + Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_8_p190_lanes[0] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_8_p210_lanes[0] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_8_p230_lanes[0];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_8_8_lanes = Lambda_inv_8_8_p22_lanes + Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_8_p257_lanes[0] + Lambda_inv_0_8_p294_lanes * Lambda_inv_0_8_p280_lanes[0] +
      Lambda_inv_0_8_p292_lanes * Lambda_inv_0_8_p291_lanes[0];
  Lambda_inv[104] = Lambda_inv_8_8_lanes[0];
  Lambda_inv[105] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[116] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[106] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[128] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[107] = Lambda_inv_8_8_lanes[3];
  Lambda_inv[140] = Lambda_inv_8_8_lanes[3];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_inv_9_9_p10_lanes = Lambda_inv_6_8_p4_lanes * Lambda_inv_0_8_p86_lanes[1];
  const Lanes<8> Lambda_inv_9_9_p16_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_6_p43 +
      Lambda_inv_6_8_p6_lanes * Lambda_inv_0_8_p56_lanes[1] + Lambda_inv_6_8_p5_lanes *
      Lambda_inv_0_8_p74_lanes[1] + Lambda_inv_9_9_p10_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_inv_9_9_p19_lanes = Lambda_inv_9_9_p16_lanes + Lambda_inv_6_8_p3_lanes *
      Lambda_inv_0_8_p107_lanes[1] + Lambda_inv_6_8_p2_lanes * Lambda_inv_0_8_p128_lanes[1] +
      Lambda_inv_6_8_p1_lanes * Lambda_inv_0_8_p159_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_inv_9_9_p22_lanes = Lambda_inv_9_9_p19_lanes + Lambda_inv_0_8_p302_lanes *
      Lambda_inv_0_8_p190_lanes[1] + Lambda_inv_0_8_p300_lanes * Lambda_inv_0_8_p210_lanes[1] +
      Lambda_inv_0_8_p298_lanes * Lambda_inv_0_8_p230_lanes[1];

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_9_9_lanes = Lambda_inv_9_9_p22_lanes + Lambda_inv_0_8_p296_lanes *
      Lambda_inv_0_8_p257_lanes[1] + Lambda_inv_0_8_p294_lanes * Lambda_inv_0_8_p280_lanes[1] +
      Lambda_inv_0_8_p292_lanes * Lambda_inv_0_8_p291_lanes[1];
  Lambda_inv[117] = Lambda_inv_9_9_lanes[1];
  Lambda_inv[118] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[129] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[119] = Lambda_inv_9_9_lanes[3];
  Lambda_inv[141] = Lambda_inv_9_9_lanes[3];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_inv_10_10_p18_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_7_p42 +
      detail::make_pack<Real>(Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1],
      Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_5_p11_lanes[1], Lambda_inv_4_4_p7_lanes[1],
      Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1], Lambda_inv_4_4_p7_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_4_p9_lanes[1],
      Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_5_p10_lanes[1], Lambda_inv_4_4_p9_lanes[1],
      Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_4_p9_lanes[1], Lambda_inv_4_4_p9_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p11_lanes[1], Lambda_inv_4_4_p11_lanes[1],
      Lambda_inv_4_4_p11_lanes[1], Lambda_inv_4_5_p9_lanes[1], Lambda_inv_4_4_p11_lanes[1],
      Lambda_inv_4_4_p11_lanes[1], Lambda_inv_4_4_p11_lanes[1], Lambda_inv_4_4_p11_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p13_lanes[1], Lambda_inv_4_4_p13_lanes[1],
      Lambda_inv_4_4_p13_lanes[1], Lambda_inv_4_5_p8_lanes[1], Lambda_inv_4_4_p13_lanes[1],
      Lambda_inv_4_4_p13_lanes[1], Lambda_inv_4_4_p13_lanes[1], Lambda_inv_4_4_p13_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_4_4_p15_lanes[1], Lambda_inv_4_4_p15_lanes[1],
      Lambda_inv_4_4_p15_lanes[1], Lambda_inv_4_5_p7_lanes[1], Lambda_inv_4_4_p15_lanes[1],
      Lambda_inv_4_4_p15_lanes[1], Lambda_inv_4_4_p15_lanes[1], Lambda_inv_4_4_p15_lanes[1]);

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_inv_10_10_p24_lanes = Lambda_inv_10_10_p18_lanes +
      detail::make_pack<Real>(Lambda_inv_4_4_p17_lanes[1], Lambda_inv_4_4_p17_lanes[1],
      Lambda_inv_4_4_p17_lanes[1], Lambda_inv_4_5_p6_lanes[1], Lambda_inv_4_4_p17_lanes[1],
      Lambda_inv_4_4_p17_lanes[1], Lambda_inv_4_4_p17_lanes[1], Lambda_inv_4_4_p17_lanes[1]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p302_lanes[2] * Lambda_inv_0_8_p190_lanes[2],
      Lambda_inv_0_8_p302_lanes[2] * Lambda_inv_0_8_p190_lanes[2], Lambda_inv_0_8_p302_lanes[2] *
      Lambda_inv_0_8_p190_lanes[2], Lambda_inv_0_8_p302_lanes[3] * Lambda_inv_0_8_p190_lanes[2],
      Lambda_inv_0_8_p302_lanes[2] * Lambda_inv_0_8_p190_lanes[2], Lambda_inv_0_8_p302_lanes[2] *
      Lambda_inv_0_8_p190_lanes[2], Lambda_inv_0_8_p302_lanes[2] * Lambda_inv_0_8_p190_lanes[2],
      Lambda_inv_0_8_p302_lanes[2] * Lambda_inv_0_8_p190_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p300_lanes[2] * Lambda_inv_0_8_p210_lanes[2],
      Lambda_inv_0_8_p300_lanes[2] * Lambda_inv_0_8_p210_lanes[2], Lambda_inv_0_8_p300_lanes[2] *
      Lambda_inv_0_8_p210_lanes[2], Lambda_inv_0_8_p300_lanes[3] * Lambda_inv_0_8_p210_lanes[2],
      Lambda_inv_0_8_p300_lanes[2] * Lambda_inv_0_8_p210_lanes[2], Lambda_inv_0_8_p300_lanes[2] *
      Lambda_inv_0_8_p210_lanes[2], Lambda_inv_0_8_p300_lanes[2] * Lambda_inv_0_8_p210_lanes[2],
      Lambda_inv_0_8_p300_lanes[2] * Lambda_inv_0_8_p210_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p298_lanes[2] * Lambda_inv_0_8_p230_lanes[2],
      Lambda_inv_0_8_p298_lanes[2] * Lambda_inv_0_8_p230_lanes[2], Lambda_inv_0_8_p298_lanes[2] *
      Lambda_inv_0_8_p230_lanes[2], Lambda_inv_0_8_p298_lanes[3] * Lambda_inv_0_8_p230_lanes[2],
      Lambda_inv_0_8_p298_lanes[2] * Lambda_inv_0_8_p230_lanes[2], Lambda_inv_0_8_p298_lanes[2] *
      Lambda_inv_0_8_p230_lanes[2], Lambda_inv_0_8_p298_lanes[2] * Lambda_inv_0_8_p230_lanes[2],
      Lambda_inv_0_8_p298_lanes[2] * Lambda_inv_0_8_p230_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p296_lanes[2] * Lambda_inv_0_8_p257_lanes[2],
      Lambda_inv_0_8_p296_lanes[2] * Lambda_inv_0_8_p257_lanes[2], Lambda_inv_0_8_p296_lanes[2] *
      Lambda_inv_0_8_p257_lanes[2], Lambda_inv_0_8_p296_lanes[3] * Lambda_inv_0_8_p257_lanes[2],
      Lambda_inv_0_8_p296_lanes[2] * Lambda_inv_0_8_p257_lanes[2], Lambda_inv_0_8_p296_lanes[2] *
      Lambda_inv_0_8_p257_lanes[2], Lambda_inv_0_8_p296_lanes[2] * Lambda_inv_0_8_p257_lanes[2],
      Lambda_inv_0_8_p296_lanes[2] * Lambda_inv_0_8_p257_lanes[2]) +
      detail::make_pack<Real>(Lambda_inv_0_8_p294_lanes[2] * Lambda_inv_0_8_p280_lanes[2],
      Lambda_inv_0_8_p294_lanes[2] * Lambda_inv_0_8_p280_lanes[2], Lambda_inv_0_8_p294_lanes[2] *
      Lambda_inv_0_8_p280_lanes[2], Lambda_inv_0_8_p294_lanes[3] * Lambda_inv_0_8_p280_lanes[2],
      Lambda_inv_0_8_p294_lanes[2] * Lambda_inv_0_8_p280_lanes[2], Lambda_inv_0_8_p294_lanes[2] *
      Lambda_inv_0_8_p280_lanes[2], Lambda_inv_0_8_p294_lanes[2] * Lambda_inv_0_8_p280_lanes[2],
      Lambda_inv_0_8_p294_lanes[2] * Lambda_inv_0_8_p280_lanes[2]);

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_inv_10_10_lanes = Lambda_inv_10_10_p24_lanes +
      detail::make_pack<Real>(Lambda_inv_0_8_p292_lanes[2] * Lambda_inv_0_8_p291_lanes[2],
      Lambda_inv_0_8_p292_lanes[2] * Lambda_inv_0_8_p291_lanes[2], Lambda_inv_0_8_p292_lanes[2] *
      Lambda_inv_0_8_p291_lanes[2], Lambda_inv_0_8_p292_lanes[3] * Lambda_inv_0_8_p291_lanes[2],
      Lambda_inv_0_8_p292_lanes[2] * Lambda_inv_0_8_p291_lanes[2], Lambda_inv_0_8_p292_lanes[2] *
      Lambda_inv_0_8_p291_lanes[2], Lambda_inv_0_8_p292_lanes[2] * Lambda_inv_0_8_p291_lanes[2],
      Lambda_inv_0_8_p292_lanes[2] * Lambda_inv_0_8_p291_lanes[2]);
  Lambda_inv[130] = Lambda_inv_10_10_lanes[2];
  Lambda_inv[131] = Lambda_inv_10_10_lanes[3];
  Lambda_inv[142] = Lambda_inv_10_10_lanes[3];

  // link 3 (hip), force propagation
  const Real Lambda_inv_11_11_p15 = Lambda_inv_5_5_p18_lanes[1] + Lambda_inv_0_8_p302_lanes[3] *
      Lambda_inv_0_8_p190_lanes[3] + Lambda_inv_0_8_p300_lanes[3] * Lambda_inv_0_8_p210_lanes[3] +
      Lambda_inv_0_8_p298_lanes[3] * Lambda_inv_0_8_p230_lanes[3] + Lambda_inv_0_8_p296_lanes[3] *
      Lambda_inv_0_8_p257_lanes[3];

  // link 1 (calf), force propagation
  Lambda_inv[143] = Lambda_inv_11_11_p15 + Lambda_inv_0_8_p294_lanes[3] *
      Lambda_inv_0_8_p280_lanes[3] + Lambda_inv_0_8_p292_lanes[3] * Lambda_inv_0_8_p291_lanes[3];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
