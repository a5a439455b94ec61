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
using Lanes = detail::Lanes<Real, count>;
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
  const Lanes<2> Lambda_0_11_p1_lanes = detail::make_lanes<Real>(0.001090468517736955,
      (-0.001090468517736955)) * detail::make_lanes<Real>(s13, s20);
  const Lanes<2> Lambda_0_11_p3_lanes = detail::make_lanes<Real>(0.001742099791326752,
      0.001742099791326752) * detail::make_lanes<Real>(c13, c20);
  const Lanes<2> Lambda_0_11_p5_lanes = Lambda_0_11_p1_lanes + Lambda_0_11_p3_lanes;
  const Lanes<2> Lambda_0_11_p7_lanes = detail::make_lanes<Real>(c13, c20) * Lambda_0_11_p5_lanes;
  const Lanes<2> Lambda_0_11_p9_lanes = 0.0006340258712020409 + Lambda_0_11_p7_lanes;
  const Lanes<2> inverse_D12_p1_lanes = detail::make_lanes<Real>((-0.0007660844555829042),
      (-0.0007660844555829042)) * detail::make_lanes<Real>(s13, s20);
  const Lanes<2> inverse_D12_p2_lanes = detail::make_lanes<Real>(0.0002628975791811551,
      (-0.0002628975791811551)) * detail::make_lanes<Real>(c13, c20);
  const Lanes<2> inverse_D12_p3_lanes = inverse_D12_p1_lanes + inverse_D12_p2_lanes;
  const Lanes<2> inverse_D12_p4_lanes = detail::make_lanes<Real>(s13, s20) * inverse_D12_p3_lanes;
  const Lanes<2> inverse_D12_p5_lanes = inverse_D12_p4_lanes -
      detail::make_lanes<Real>((-0.0010519177038056625), (-0.0010519177038056625));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D12_lanes = 1.0 / inverse_D12_p5_lanes;
  const Lanes<2> Lambda_0_11_p11_lanes = Lambda_0_11_p9_lanes * inverse_D12_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p13_lanes = detail::make_lanes<Real>(c13, c20) * inverse_D12_p3_lanes;
  const Lanes<2> Lambda_0_11_p15_lanes = detail::make_lanes<Real>((-0.00013384878959057754),
      0.00013384878959057754) + Lambda_0_11_p13_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p17_lanes = Lambda_0_11_p15_lanes * Lambda_0_11_p11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p19_lanes = detail::make_lanes<Real>(s13, s20) * Lambda_0_11_p5_lanes;
  const Lanes<2> Lambda_0_11_p21_lanes = detail::make_lanes<Real>((-0.00033044389597753786),
      0.00033044389597753786) + Lambda_0_11_p19_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p23_lanes = Lambda_0_11_p21_lanes + Lambda_0_11_p17_lanes;
  const Lanes<2> Lambda_0_11_p25_lanes = detail::make_lanes<Real>(s12, s19) * Lambda_0_11_p23_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p27_lanes = detail::make_lanes<Real>((-0.002865001425),
      0.002865001425) * detail::make_lanes<Real>(s13, s20);
  const Lanes<2> Lambda_0_11_p29_lanes = 0.01626499875 * detail::make_lanes<Real>(c13, c20);
  const Lanes<2> Lambda_0_11_p31_lanes = Lambda_0_11_p27_lanes - Lambda_0_11_p29_lanes;
  const Lanes<2> Lambda_0_11_p33_lanes = Lambda_0_11_p31_lanes - 0.0006000000000000001;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p35_lanes = Lambda_0_11_p33_lanes * inverse_D12_lanes;
  const Lanes<2> Lambda_0_11_p37_lanes = Lambda_0_11_p15_lanes * Lambda_0_11_p35_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p39_lanes = detail::make_lanes<Real>((-0.002865001425),
      0.002865001425) * detail::make_lanes<Real>(c13, c20);
  const Lanes<2> Lambda_0_11_p41_lanes = 0.01626499875 * detail::make_lanes<Real>(s13, s20);
  const Lanes<2> Lambda_0_11_p43_lanes = Lambda_0_11_p39_lanes + Lambda_0_11_p41_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p45_lanes = Lambda_0_11_p43_lanes - Lambda_0_11_p37_lanes;
  const Lanes<2> Lambda_0_11_p47_lanes = detail::make_lanes<Real>(c12, c19) * Lambda_0_11_p45_lanes;
  const Lanes<2> Lambda_0_11_p49_lanes = Lambda_0_11_p25_lanes + Lambda_0_11_p47_lanes;
  const Lanes<2> Lambda_0_11_p51_lanes = detail::make_lanes<Real>(c12, c19) * Lambda_0_11_p49_lanes;
  const Lanes<2> Lambda_0_11_p53_lanes = detail::make_lanes<Real>(0.001, (-0.001)) +
      Lambda_0_11_p51_lanes;
  const Lanes<2> inverse_D11_p1_lanes = Lambda_0_11_p15_lanes * inverse_D12_lanes;
  const Lanes<2> inverse_D11_p2_lanes = Lambda_0_11_p15_lanes * inverse_D11_p1_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> inverse_D11_p3_lanes = 0.0002742332482227584 - inverse_D12_p4_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D11_p4_lanes = inverse_D11_p3_lanes - inverse_D11_p2_lanes;
  const Lanes<2> inverse_D11_p5_lanes = 1.16e-05 - inverse_D11_p4_lanes;
  const Lanes<2> inverse_D11_p6_lanes = detail::make_lanes<Real>(s12, s19) * inverse_D11_p5_lanes;
  const Lanes<2> inverse_D11_p7_lanes = detail::make_lanes<Real>(s12, s19) * inverse_D11_p6_lanes;
  const Lanes<2> inverse_D11_p8_lanes = inverse_D11_p4_lanes + inverse_D11_p7_lanes;
  const Lanes<2> inverse_D11_p9_lanes = 0.00022920000000000001 + inverse_D11_p8_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D11_lanes = 1.0 / inverse_D11_p9_lanes;
  const Lanes<2> Lambda_0_11_p55_lanes = Lambda_0_11_p53_lanes * inverse_D11_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p57_lanes = detail::make_lanes<Real>(c12, c19) * inverse_D11_p6_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p59_lanes = Lambda_0_11_p19_lanes -
      detail::make_lanes<Real>(0.000760024621759417, (-0.000760024621759417));

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p61_lanes = Lambda_0_11_p59_lanes * inverse_D12_lanes;
  const Lanes<2> Lambda_0_11_p63_lanes = Lambda_0_11_p15_lanes * Lambda_0_11_p61_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p65_lanes = Lambda_0_11_p7_lanes -
      detail::make_lanes<Real>(0.002376125662528793, 0.002376125662528793);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p67_lanes = Lambda_0_11_p65_lanes - Lambda_0_11_p63_lanes;
  const Lanes<2> Lambda_0_11_p69_lanes = detail::make_lanes<Real>(c12, c19) * Lambda_0_11_p67_lanes;
  const Lanes<2> Lambda_0_11_p71_lanes = 0.0006000000000000001 * detail::make_lanes<Real>(s12, s19);
  const Lanes<2> Lambda_0_11_p73_lanes = Lambda_0_11_p71_lanes + Lambda_0_11_p69_lanes;
  const Lanes<2> Lambda_0_11_p75_lanes = 0.269 * Lambda_0_11_p73_lanes;
  const Lanes<2> Lambda_0_11_p77_lanes = Lambda_0_11_p57_lanes + Lambda_0_11_p75_lanes;
  const Lanes<2> Lambda_0_11_p79_lanes = 0.000144 - Lambda_0_11_p77_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p81_lanes = Lambda_0_11_p79_lanes * Lambda_0_11_p55_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p83_lanes = detail::make_lanes<Real>(s12, s19) * Lambda_0_11_p49_lanes;
  const Lanes<2> Lambda_0_11_p85_lanes = Lambda_0_11_p33_lanes * Lambda_0_11_p61_lanes;
  const Lanes<2> Lambda_0_11_p87_lanes = detail::make_lanes<Real>(c12, c19) * Lambda_0_11_p85_lanes;
  const Lanes<2> Lambda_0_11_p89_lanes = Lambda_0_11_p9_lanes * Lambda_0_11_p61_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p91_lanes = detail::make_lanes<Real>((-0.09929187165525127),
      0.09929187165525127) * detail::make_lanes<Real>(c13, c20);
  const Lanes<2> Lambda_0_11_p93_lanes = detail::make_lanes<Real>((-0.27310176737964387),
      (-0.27310176737964387)) * detail::make_lanes<Real>(s13, s20);
  const Lanes<2> Lambda_0_11_p95_lanes = Lambda_0_11_p91_lanes - Lambda_0_11_p93_lanes;
  const Lanes<2> Lambda_0_11_p97_lanes = detail::make_lanes<Real>(c13, c20) * Lambda_0_11_p95_lanes;
  const Lanes<2> Lambda_0_11_p99_lanes = Lambda_0_11_p97_lanes -
      detail::make_lanes<Real>((-0.04964593582762564), 0.04964593582762564);

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p101_lanes = Lambda_0_11_p99_lanes - Lambda_0_11_p89_lanes;
  const Lanes<2> Lambda_0_11_p103_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p101_lanes;
  const Lanes<2> Lambda_0_11_p105_lanes = Lambda_0_11_p87_lanes + Lambda_0_11_p103_lanes;
  const Lanes<2> Lambda_0_11_p107_lanes = 0.269 * Lambda_0_11_p105_lanes;
  const Lanes<2> Lambda_0_11_p109_lanes = Lambda_0_11_p83_lanes + Lambda_0_11_p107_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p111_lanes = Lambda_0_11_p81_lanes - Lambda_0_11_p109_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p113_lanes = 0.269 * Lambda_0_11_p51_lanes;
  const Lanes<2> Lambda_0_11_p115_lanes = detail::make_lanes<Real>(0.0002516, (-0.0002516)) +
      Lambda_0_11_p113_lanes;
  const Lanes<2> Lambda_0_11_p117_lanes = 6e-04 - Lambda_0_11_p73_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p119_lanes = Lambda_0_11_p117_lanes * inverse_D11_lanes;
  const Lanes<2> Lambda_0_11_p121_lanes = Lambda_0_11_p115_lanes * Lambda_0_11_p119_lanes;
  const Lanes<2> Lambda_0_11_p123_lanes = Lambda_0_11_p107_lanes - Lambda_0_11_p121_lanes;
  const Lanes<2> Lambda_0_11_p125_lanes = Lambda_0_11_p111_lanes - Lambda_0_11_p123_lanes;
  const Lanes<2> Lambda_0_11_p127_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p125_lanes;
  const Lanes<2> Lambda_0_11_p129_lanes = Lambda_0_11_p115_lanes * Lambda_0_11_p55_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p131_lanes = Lambda_0_11_p9_lanes * Lambda_0_11_p11_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p133_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p95_lanes;
  const Lanes<2> Lambda_0_11_p135_lanes = detail::make_lanes<Real>(0.008744893195371809,
      0.008744893195371809) + Lambda_0_11_p133_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p137_lanes = Lambda_0_11_p135_lanes + Lambda_0_11_p131_lanes;
  const Lanes<2> Lambda_0_11_p139_lanes = Lambda_0_11_p33_lanes * Lambda_0_11_p35_lanes;
  const Lanes<2> Lambda_0_11_p141_lanes = Lambda_0_11_p137_lanes - Lambda_0_11_p139_lanes;
  const Lanes<2> Lambda_0_11_p143_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p141_lanes;
  const Lanes<2> Lambda_0_11_p145_lanes = Lambda_0_11_p33_lanes * Lambda_0_11_p11_lanes;
  const Lanes<2> Lambda_0_11_p147_lanes = 2.0 * Lambda_0_11_p145_lanes;
  const Lanes<2> Lambda_0_11_p149_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p147_lanes;
  const Lanes<2> Lambda_0_11_p151_lanes = Lambda_0_11_p149_lanes - Lambda_0_11_p143_lanes;
  const Lanes<2> Lambda_0_11_p153_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p151_lanes;
  const Lanes<2> Lambda_0_11_p155_lanes = Lambda_0_11_p153_lanes - Lambda_0_11_p139_lanes;
  const Lanes<2> Lambda_0_11_p157_lanes = 0.269 * Lambda_0_11_p155_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p159_lanes = Lambda_0_11_p129_lanes - Lambda_0_11_p157_lanes;
  const Lanes<2> Lambda_0_11_p161_lanes = Lambda_0_11_p79_lanes * Lambda_0_11_p119_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p163_lanes = Lambda_0_11_p59_lanes * Lambda_0_11_p61_lanes;

  // link 13 (left_hand), articulated inertia
  const Lanes<2> Lambda_0_11_p165_lanes = Lambda_0_11_p133_lanes - 0.2818466605750157;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p167_lanes = Lambda_0_11_p165_lanes - Lambda_0_11_p163_lanes;
  const Lanes<2> Lambda_0_11_p169_lanes = 0.269 * Lambda_0_11_p167_lanes;
  const Lanes<2> Lambda_0_11_p171_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p67_lanes;
  const Lanes<2> Lambda_0_11_p173_lanes = 0.0006000000000000001 *
      detail::make_lanes<Real>(c12, c19);
  const Lanes<2> Lambda_0_11_p175_lanes = Lambda_0_11_p171_lanes - Lambda_0_11_p173_lanes;
  const Lanes<2> Lambda_0_11_p177_lanes = Lambda_0_11_p169_lanes - Lambda_0_11_p175_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p179_lanes = Lambda_0_11_p177_lanes - Lambda_0_11_p161_lanes;
  const Lanes<2> Lambda_0_11_p181_lanes = Lambda_0_11_p159_lanes + Lambda_0_11_p179_lanes;
  const Lanes<2> Lambda_0_11_p183_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p181_lanes;
  const Lanes<2> Lambda_0_11_p185_lanes = Lambda_0_11_p127_lanes + Lambda_0_11_p183_lanes;
  const Lanes<2> Lambda_0_11_p187_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p185_lanes;
  const Lanes<2> Lambda_0_11_p189_lanes = Lambda_0_11_p123_lanes + Lambda_0_11_p187_lanes;
  const Lanes<2> inverse_D10_p1_lanes = Lambda_0_11_p79_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p2_lanes = Lambda_0_11_p79_lanes * inverse_D10_p1_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p3_lanes = Lambda_0_11_p177_lanes - Lambda_0_11_p175_lanes;
  const Lanes<2> inverse_D10_p4_lanes = 0.269 * inverse_D10_p3_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p5_lanes = 0.000131 - inverse_D11_p7_lanes;
  const Lanes<2> inverse_D10_p6_lanes = inverse_D10_p5_lanes + inverse_D10_p4_lanes;
  const Lanes<2> inverse_D10_p7_lanes = inverse_D10_p6_lanes - inverse_D10_p2_lanes;
  const Lanes<2> inverse_D10_p8_lanes = Lambda_0_11_p115_lanes * inverse_D11_lanes;
  const Lanes<2> inverse_D10_p9_lanes = Lambda_0_11_p115_lanes * inverse_D10_p8_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p10_lanes = 0.07236100000000001 * Lambda_0_11_p155_lanes;
  const Lanes<2> inverse_D10_p11_lanes = 0.0001098 + inverse_D10_p10_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p12_lanes = inverse_D10_p11_lanes - inverse_D10_p9_lanes;
  const Lanes<2> inverse_D10_p13_lanes = inverse_D10_p7_lanes - inverse_D10_p12_lanes;
  const Lanes<2> inverse_D10_p14_lanes = detail::make_lanes<Real>(s11, s18) * inverse_D10_p13_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> inverse_D10_p15_lanes = 0.269 * Lambda_0_11_p109_lanes;
  const Lanes<2> inverse_D10_p16_lanes = detail::make_lanes<Real>((-6e-06), 6e-06) +
      inverse_D10_p15_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> inverse_D10_p17_lanes = Lambda_0_11_p79_lanes * inverse_D10_p8_lanes;
  const Lanes<2> inverse_D10_p18_lanes = inverse_D10_p16_lanes - inverse_D10_p17_lanes;
  const Lanes<2> inverse_D10_p19_lanes = 2.0 * detail::make_lanes<Real>(c11, c18);
  const Lanes<2> inverse_D10_p20_lanes = inverse_D10_p19_lanes * inverse_D10_p18_lanes;
  const Lanes<2> inverse_D10_p21_lanes = inverse_D10_p14_lanes + inverse_D10_p20_lanes;
  const Lanes<2> inverse_D10_p22_lanes = detail::make_lanes<Real>(s11, s18) * inverse_D10_p21_lanes;
  const Lanes<2> inverse_D10_p23_lanes = inverse_D10_p12_lanes + inverse_D10_p22_lanes;
  const Lanes<2> inverse_D10_p24_lanes = 0.060888541114265754 + inverse_D10_p23_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_lanes = 1.0 / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_0_11_p191_lanes = Lambda_0_11_p189_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p193_lanes = detail::make_lanes<Real>((-0.0001499998887063),
      0.0001499998887063) * Lambda_0_11_p191_lanes;
  const Lanes<2> Lambda_0_11_p195_lanes = 0.0014999985000000002 + Lambda_0_11_p193_lanes;
  const Lanes<2> Lambda_0_11_p197_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p195_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p199_lanes = detail::make_lanes<Real>(c11, c18) *
      inverse_D10_p21_lanes;
  const Lanes<2> Lambda_0_11_p201_lanes = Lambda_0_11_p199_lanes - inverse_D10_p18_lanes;
  const Lanes<2> Lambda_0_11_p203_lanes = detail::make_lanes<Real>((-2.249994685315e-05),
      2.249994685315e-05) + Lambda_0_11_p201_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p205_lanes = Lambda_0_11_p203_lanes * Lambda_0_11_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p207_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p185_lanes;
  const Lanes<2> Lambda_0_11_p209_lanes = Lambda_0_11_p207_lanes - Lambda_0_11_p159_lanes;
  const Lanes<2> Lambda_0_11_p211_lanes = 0.28049749700000004 + Lambda_0_11_p209_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p213_lanes = Lambda_0_11_p211_lanes - Lambda_0_11_p205_lanes;
  const Lanes<2> Lambda_0_11_p215_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p213_lanes;
  const Lanes<2> Lambda_0_11_p217_lanes = Lambda_0_11_p197_lanes - Lambda_0_11_p215_lanes;
  const Lanes<2> Lambda_0_11_p219_lanes = 0.282 * Lambda_0_11_p217_lanes;
  const Lanes<2> Lambda_0_11_p221_lanes = detail::make_lanes<Real>((-0.0001499998887063),
      0.0001499998887063) / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_0_11_p223_lanes = Lambda_0_11_p203_lanes * Lambda_0_11_p221_lanes;
  const Lanes<2> Lambda_0_11_p225_lanes = 0.0001499998887063 + Lambda_0_11_p223_lanes;
  const Lanes<2> Lambda_0_11_p227_lanes = 2.0 * detail::make_lanes<Real>(c10, c17);
  const Lanes<2> Lambda_0_11_p229_lanes = Lambda_0_11_p227_lanes * Lambda_0_11_p225_lanes;
  const Lanes<2> Lambda_0_11_p231_lanes = Lambda_0_11_p203_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p233_lanes = Lambda_0_11_p203_lanes * Lambda_0_11_p231_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p235_lanes = inverse_D10_p7_lanes - inverse_D10_p22_lanes;
  const Lanes<2> Lambda_0_11_p237_lanes = 0.06060754126741261 + Lambda_0_11_p235_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p239_lanes = Lambda_0_11_p237_lanes - Lambda_0_11_p233_lanes;
  const Lanes<2> Lambda_0_11_p241_lanes = detail::make_lanes<Real>(2.249996661190239e-08,
      2.249996661190239e-08) / inverse_D10_p24_lanes;
  const Lanes<2> Lambda_0_11_p243_lanes = 0.00028099984685315 - Lambda_0_11_p241_lanes;
  const Lanes<2> Lambda_0_11_p245_lanes = Lambda_0_11_p239_lanes - Lambda_0_11_p243_lanes;
  const Lanes<2> Lambda_0_11_p247_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p245_lanes;
  const Lanes<2> Lambda_0_11_p249_lanes = Lambda_0_11_p229_lanes - Lambda_0_11_p247_lanes;
  const Lanes<2> Lambda_0_11_p251_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p249_lanes;
  const Lanes<2> Lambda_0_11_p253_lanes = Lambda_0_11_p225_lanes - Lambda_0_11_p251_lanes;
  const Lanes<2> Lambda_0_11_p255_lanes = Lambda_0_11_p219_lanes - Lambda_0_11_p253_lanes;
  const Lanes<2> Lambda_0_11_p257_lanes = Lambda_0_11_p255_lanes - 0.0005895000784280001;
  const Lanes<2> inverse_D9_p1_lanes = detail::make_lanes<Real>(s10, s17) * Lambda_0_11_p249_lanes;
  const Lanes<2> inverse_D9_p2_lanes = Lambda_0_11_p243_lanes - inverse_D9_p1_lanes;
  const Lanes<2> inverse_D9_p3_lanes = 0.0027762933559338653 + inverse_D9_p2_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D9_lanes = 1.0 / inverse_D9_p3_lanes;
  const Lanes<2> Lambda_0_11_p259_lanes = Lambda_0_11_p257_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p261_lanes = Lambda_0_11_p257_lanes * Lambda_0_11_p259_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p263_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p213_lanes;
  const Lanes<2> Lambda_0_11_p265_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p195_lanes;
  const Lanes<2> Lambda_0_11_p267_lanes = Lambda_0_11_p263_lanes + Lambda_0_11_p265_lanes;
  const Lanes<2> Lambda_0_11_p269_lanes = Lambda_0_11_p189_lanes * Lambda_0_11_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p271_lanes = Lambda_0_11_p53_lanes * Lambda_0_11_p55_lanes;
  const Lanes<2> Lambda_0_11_p273_lanes = Lambda_0_11_p155_lanes - Lambda_0_11_p271_lanes;
  const Lanes<2> Lambda_0_11_p275_lanes = Lambda_0_11_p117_lanes * Lambda_0_11_p119_lanes;
  const Lanes<2> Lambda_0_11_p277_lanes = Lambda_0_11_p167_lanes - Lambda_0_11_p275_lanes;
  const Lanes<2> Lambda_0_11_p279_lanes = Lambda_0_11_p273_lanes - Lambda_0_11_p277_lanes;
  const Lanes<2> Lambda_0_11_p281_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p279_lanes;
  const Lanes<2> Lambda_0_11_p283_lanes = Lambda_0_11_p53_lanes * Lambda_0_11_p119_lanes;
  const Lanes<2> Lambda_0_11_p285_lanes = Lambda_0_11_p283_lanes - Lambda_0_11_p105_lanes;
  const Lanes<2> Lambda_0_11_p287_lanes = inverse_D10_p19_lanes * Lambda_0_11_p285_lanes;
  const Lanes<2> Lambda_0_11_p289_lanes = Lambda_0_11_p281_lanes + Lambda_0_11_p287_lanes;
  const Lanes<2> Lambda_0_11_p291_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p289_lanes;
  const Lanes<2> Lambda_0_11_p293_lanes = Lambda_0_11_p277_lanes + Lambda_0_11_p291_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p295_lanes = Lambda_0_11_p293_lanes - Lambda_0_11_p269_lanes;
  const Lanes<2> Lambda_0_11_p297_lanes = 0.282 * Lambda_0_11_p295_lanes;
  const Lanes<2> Lambda_0_11_p299_lanes = Lambda_0_11_p267_lanes + Lambda_0_11_p297_lanes;
  const Lanes<2> Lambda_0_11_p301_lanes = Lambda_0_11_p267_lanes + Lambda_0_11_p299_lanes;
  const Lanes<2> Lambda_0_11_p303_lanes = 0.282 * Lambda_0_11_p301_lanes;
  const Lanes<2> Lambda_0_11_p305_lanes = Lambda_0_11_p239_lanes + inverse_D9_p1_lanes;
  const Lanes<2> Lambda_0_11_p307_lanes = Lambda_0_11_p305_lanes + Lambda_0_11_p303_lanes;
  const Lanes<2> Lambda_0_11_p309_lanes = 0.0019585440854647937 + Lambda_0_11_p307_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p311_lanes = Lambda_0_11_p309_lanes - Lambda_0_11_p261_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p313_lanes = Lambda_0_11_p207_lanes - Lambda_0_11_p179_lanes;
  const Lanes<2> Lambda_0_11_p315_lanes = Lambda_0_11_p313_lanes - 0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p317_lanes = Lambda_0_11_p315_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p319_lanes = detail::make_lanes<Real>((-0.0001499998887063),
      0.0001499998887063) * Lambda_0_11_p317_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p321_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p85_lanes;
  const Lanes<2> Lambda_0_11_p323_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p101_lanes;
  const Lanes<2> Lambda_0_11_p325_lanes = Lambda_0_11_p321_lanes - Lambda_0_11_p323_lanes;
  const Lanes<2> Lambda_0_11_p327_lanes = 0.269 * Lambda_0_11_p325_lanes;
  const Lanes<2> Lambda_0_11_p329_lanes = Lambda_0_11_p51_lanes - Lambda_0_11_p45_lanes;
  const Lanes<2> Lambda_0_11_p331_lanes = Lambda_0_11_p327_lanes - Lambda_0_11_p329_lanes;
  const Lanes<2> Lambda_0_11_p333_lanes = detail::make_lanes<Real>(0.001, (-0.001)) +
      Lambda_0_11_p331_lanes;
  const Lanes<2> Lambda_0_11_p335_lanes = Lambda_0_11_p83_lanes - Lambda_0_11_p23_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p337_lanes = Lambda_0_11_p335_lanes * inverse_D11_lanes;
  const Lanes<2> Lambda_0_11_p339_lanes = Lambda_0_11_p79_lanes * Lambda_0_11_p337_lanes;
  const Lanes<2> Lambda_0_11_p341_lanes = Lambda_0_11_p333_lanes - Lambda_0_11_p339_lanes;
  const Lanes<2> Lambda_0_11_p343_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p341_lanes;
  const Lanes<2> Lambda_0_11_p345_lanes = Lambda_0_11_p115_lanes * Lambda_0_11_p337_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p347_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p151_lanes;
  const Lanes<2> Lambda_0_11_p349_lanes = Lambda_0_11_p145_lanes - Lambda_0_11_p347_lanes;
  const Lanes<2> Lambda_0_11_p351_lanes = 0.269 * Lambda_0_11_p349_lanes;
  const Lanes<2> Lambda_0_11_p353_lanes = Lambda_0_11_p351_lanes - 6e-04;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p355_lanes = Lambda_0_11_p353_lanes - Lambda_0_11_p345_lanes;
  const Lanes<2> Lambda_0_11_p357_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p355_lanes;
  const Lanes<2> Lambda_0_11_p359_lanes = Lambda_0_11_p343_lanes + Lambda_0_11_p357_lanes;
  const Lanes<2> Lambda_0_11_p361_lanes = 0.0014999985000000002 - Lambda_0_11_p359_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p363_lanes = Lambda_0_11_p361_lanes * inverse_D10_lanes;
  const Lanes<2> Lambda_0_11_p365_lanes = Lambda_0_11_p203_lanes * Lambda_0_11_p363_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p367_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p341_lanes;
  const Lanes<2> Lambda_0_11_p369_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p355_lanes;
  const Lanes<2> Lambda_0_11_p371_lanes = Lambda_0_11_p367_lanes - Lambda_0_11_p369_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p373_lanes = Lambda_0_11_p371_lanes + Lambda_0_11_p365_lanes;
  const Lanes<2> Lambda_0_11_p375_lanes = Lambda_0_11_p319_lanes + Lambda_0_11_p373_lanes;
  const Lanes<2> Lambda_0_11_p377_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p375_lanes;
  const Lanes<2> Lambda_0_11_p379_lanes = Lambda_0_11_p203_lanes * Lambda_0_11_p317_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p381_lanes = Lambda_0_11_p111_lanes - Lambda_0_11_p187_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p383_lanes = Lambda_0_11_p381_lanes - Lambda_0_11_p379_lanes;
  const Lanes<2> Lambda_0_11_p385_lanes = detail::make_lanes<Real>((-0.0001499998887063),
      0.0001499998887063) * Lambda_0_11_p363_lanes;
  const Lanes<2> Lambda_0_11_p387_lanes = Lambda_0_11_p383_lanes + Lambda_0_11_p385_lanes;
  const Lanes<2> Lambda_0_11_p389_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p387_lanes;
  const Lanes<2> Lambda_0_11_p391_lanes = Lambda_0_11_p377_lanes - Lambda_0_11_p389_lanes;
  const Lanes<2> Lambda_0_11_p393_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p391_lanes;
  const Lanes<2> Lambda_0_11_p395_lanes = Lambda_0_11_p373_lanes - Lambda_0_11_p393_lanes;
  const Lanes<2> Lambda_0_11_p397_lanes = 0.282 * Lambda_0_11_p395_lanes;
  const Lanes<2> Lambda_0_11_p399_lanes = detail::make_lanes<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + Lambda_0_11_p397_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p401_lanes = Lambda_0_11_p399_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p403_lanes = Lambda_0_11_p399_lanes * Lambda_0_11_p401_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p405_lanes = Lambda_0_11_p315_lanes * Lambda_0_11_p363_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p407_lanes = Lambda_0_11_p53_lanes * Lambda_0_11_p337_lanes;
  const Lanes<2> Lambda_0_11_p409_lanes = Lambda_0_11_p407_lanes - Lambda_0_11_p349_lanes;
  const Lanes<2> Lambda_0_11_p411_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p409_lanes;
  const Lanes<2> Lambda_0_11_p413_lanes = Lambda_0_11_p117_lanes * Lambda_0_11_p337_lanes;
  const Lanes<2> Lambda_0_11_p415_lanes = Lambda_0_11_p325_lanes - Lambda_0_11_p413_lanes;
  const Lanes<2> Lambda_0_11_p417_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p415_lanes;
  const Lanes<2> Lambda_0_11_p419_lanes = Lambda_0_11_p411_lanes - Lambda_0_11_p417_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p421_lanes = Lambda_0_11_p419_lanes + Lambda_0_11_p405_lanes;
  const Lanes<2> Lambda_0_11_p423_lanes = Lambda_0_11_p227_lanes * Lambda_0_11_p421_lanes;
  const Lanes<2> Lambda_0_11_p425_lanes = Lambda_0_11_p315_lanes * Lambda_0_11_p317_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p427_lanes = Lambda_0_11_p273_lanes - Lambda_0_11_p291_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p429_lanes = Lambda_0_11_p427_lanes - Lambda_0_11_p425_lanes;
  const Lanes<2> Lambda_0_11_p431_lanes = Lambda_0_11_p361_lanes * Lambda_0_11_p363_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p433_lanes = Lambda_0_11_p335_lanes * Lambda_0_11_p337_lanes;

  // link 12 (left_wrist2), articulated inertia
  const Lanes<2> Lambda_0_11_p435_lanes = Lambda_0_11_p137_lanes + Lambda_0_11_p153_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p437_lanes = Lambda_0_11_p435_lanes + Lambda_0_11_p433_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p439_lanes = Lambda_0_11_p437_lanes + Lambda_0_11_p431_lanes;
  const Lanes<2> Lambda_0_11_p441_lanes = Lambda_0_11_p429_lanes + Lambda_0_11_p439_lanes;
  const Lanes<2> Lambda_0_11_p443_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p441_lanes;
  const Lanes<2> Lambda_0_11_p445_lanes = Lambda_0_11_p423_lanes - Lambda_0_11_p443_lanes;
  const Lanes<2> Lambda_0_11_p447_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p445_lanes;
  const Lanes<2> Lambda_0_11_p449_lanes = Lambda_0_11_p429_lanes + Lambda_0_11_p447_lanes;
  const Lanes<2> Lambda_0_11_p451_lanes = 0.07952399999999998 * Lambda_0_11_p449_lanes;
  const Lanes<2> Lambda_0_11_p453_lanes = 0.0008177492704690715 + Lambda_0_11_p451_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p455_lanes = Lambda_0_11_p453_lanes - Lambda_0_11_p403_lanes;
  const Lanes<2> Lambda_0_11_p457_lanes = Lambda_0_11_p311_lanes - Lambda_0_11_p455_lanes;
  const Lanes<2> Lambda_0_11_p459_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p457_lanes;
  const Lanes<2> Lambda_0_11_p461_lanes = Lambda_0_11_p257_lanes * Lambda_0_11_p401_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p463_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p391_lanes;
  const Lanes<2> Lambda_0_11_p465_lanes = Lambda_0_11_p383_lanes + Lambda_0_11_p463_lanes;
  const Lanes<2> Lambda_0_11_p467_lanes = Lambda_0_11_p315_lanes * Lambda_0_11_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p469_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p289_lanes;
  const Lanes<2> Lambda_0_11_p471_lanes = Lambda_0_11_p469_lanes - Lambda_0_11_p285_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p473_lanes = Lambda_0_11_p471_lanes - Lambda_0_11_p467_lanes;
  const Lanes<2> Lambda_0_11_p475_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p473_lanes;
  const Lanes<2> Lambda_0_11_p477_lanes = Lambda_0_11_p361_lanes * Lambda_0_11_p191_lanes;

  // link 11 (left_wrist1), articulated inertia
  const Lanes<2> Lambda_0_11_p479_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p409_lanes;
  const Lanes<2> Lambda_0_11_p481_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p415_lanes;
  const Lanes<2> Lambda_0_11_p483_lanes = Lambda_0_11_p479_lanes + Lambda_0_11_p481_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p485_lanes = Lambda_0_11_p483_lanes + Lambda_0_11_p477_lanes;
  const Lanes<2> Lambda_0_11_p487_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p485_lanes;
  const Lanes<2> Lambda_0_11_p489_lanes = Lambda_0_11_p475_lanes + Lambda_0_11_p487_lanes;
  const Lanes<2> Lambda_0_11_p491_lanes = 0.282 * Lambda_0_11_p489_lanes;
  const Lanes<2> Lambda_0_11_p493_lanes = Lambda_0_11_p465_lanes + Lambda_0_11_p491_lanes;
  const Lanes<2> Lambda_0_11_p495_lanes = 0.282 * Lambda_0_11_p493_lanes;
  const Lanes<2> Lambda_0_11_p497_lanes = detail::make_lanes<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - Lambda_0_11_p495_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p499_lanes = Lambda_0_11_p497_lanes - Lambda_0_11_p461_lanes;
  const Lanes<2> Lambda_0_11_p501_lanes = 2.0 * detail::make_lanes<Real>(s9, s16);
  const Lanes<2> Lambda_0_11_p503_lanes = Lambda_0_11_p501_lanes * Lambda_0_11_p499_lanes;
  const Lanes<2> Lambda_0_11_p505_lanes = Lambda_0_11_p459_lanes - Lambda_0_11_p503_lanes;
  const Lanes<2> Lambda_0_11_p507_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p505_lanes;
  const Lanes<2> Lambda_0_11_p509_lanes = Lambda_0_11_p507_lanes + Lambda_0_11_p499_lanes;
  const Lanes<2> Lambda_0_11_p511_lanes = detail::make_lanes<Real>((-1.75e-05), 1.75e-05) +
      Lambda_0_11_p509_lanes;
  const Lanes<2> inverse_D8_p1_lanes = detail::make_lanes<Real>(c9, c16) * Lambda_0_11_p505_lanes;
  const Lanes<2> inverse_D8_p2_lanes = Lambda_0_11_p455_lanes + inverse_D8_p1_lanes;
  const Lanes<2> inverse_D8_p3_lanes = 0.18125194219699997 + inverse_D8_p2_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_lanes = 1.0 / inverse_D8_p3_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p513_lanes = Lambda_0_11_p385_lanes + Lambda_0_11_p463_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p515_lanes = Lambda_0_11_p513_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p517_lanes = Lambda_0_11_p257_lanes * Lambda_0_11_p515_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p519_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p485_lanes;
  const Lanes<2> Lambda_0_11_p521_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p473_lanes;
  const Lanes<2> Lambda_0_11_p523_lanes = Lambda_0_11_p519_lanes - Lambda_0_11_p521_lanes;
  const Lanes<2> Lambda_0_11_p525_lanes = 0.282 * Lambda_0_11_p523_lanes;
  const Lanes<2> Lambda_0_11_p527_lanes = Lambda_0_11_p319_lanes - Lambda_0_11_p393_lanes;
  const Lanes<2> Lambda_0_11_p529_lanes = Lambda_0_11_p525_lanes - Lambda_0_11_p527_lanes;
  const Lanes<2> Lambda_0_11_p531_lanes = detail::make_lanes<Real>(0.004500002325,
      (-0.004500002325)) + Lambda_0_11_p529_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p533_lanes = Lambda_0_11_p531_lanes + Lambda_0_11_p517_lanes;
  const Lanes<2> Lambda_0_11_p535_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p533_lanes;
  const Lanes<2> Lambda_0_11_p537_lanes = Lambda_0_11_p399_lanes * Lambda_0_11_p515_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p539_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p445_lanes;
  const Lanes<2> Lambda_0_11_p541_lanes = Lambda_0_11_p421_lanes - Lambda_0_11_p539_lanes;
  const Lanes<2> Lambda_0_11_p543_lanes = 0.282 * Lambda_0_11_p541_lanes;
  const Lanes<2> Lambda_0_11_p545_lanes = 0.0022500062 + Lambda_0_11_p543_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p547_lanes = Lambda_0_11_p545_lanes + Lambda_0_11_p537_lanes;
  const Lanes<2> Lambda_0_11_p549_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p547_lanes;
  const Lanes<2> Lambda_0_11_p551_lanes = Lambda_0_11_p535_lanes - Lambda_0_11_p549_lanes;
  const Lanes<2> Lambda_0_11_p553_lanes = detail::make_lanes<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + Lambda_0_11_p551_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p555_lanes = Lambda_0_11_p553_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_0_11_p557_lanes = Lambda_0_11_p511_lanes * Lambda_0_11_p555_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p559_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p533_lanes;
  const Lanes<2> Lambda_0_11_p561_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p547_lanes;
  const Lanes<2> Lambda_0_11_p563_lanes = Lambda_0_11_p559_lanes + Lambda_0_11_p561_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p565_lanes = Lambda_0_11_p557_lanes - Lambda_0_11_p563_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p567_lanes = detail::make_lanes<Real>(0.004500002325,
      (-0.004500002325)) + Lambda_0_11_p395_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p569_lanes = Lambda_0_11_p567_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p571_lanes = Lambda_0_11_p257_lanes * Lambda_0_11_p569_lanes;
  const Lanes<2> Lambda_0_11_p573_lanes = Lambda_0_11_p493_lanes + Lambda_0_11_p571_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p575_lanes = Lambda_0_11_p217_lanes - 0.0022500062;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p577_lanes = Lambda_0_11_p575_lanes * inverse_D9_lanes;
  const Lanes<2> Lambda_0_11_p579_lanes = Lambda_0_11_p399_lanes * Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p581_lanes = Lambda_0_11_p491_lanes + Lambda_0_11_p579_lanes;
  const Lanes<2> Lambda_0_11_p583_lanes = Lambda_0_11_p573_lanes + Lambda_0_11_p581_lanes;
  const Lanes<2> Lambda_0_11_p585_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p583_lanes;
  const Lanes<2> Lambda_0_11_p587_lanes = Lambda_0_11_p257_lanes * Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p589_lanes = Lambda_0_11_p299_lanes - Lambda_0_11_p587_lanes;
  const Lanes<2> Lambda_0_11_p591_lanes = Lambda_0_11_p399_lanes * Lambda_0_11_p569_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p593_lanes = 0.282 * Lambda_0_11_p449_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p595_lanes = Lambda_0_11_p591_lanes - Lambda_0_11_p593_lanes;
  const Lanes<2> Lambda_0_11_p597_lanes = Lambda_0_11_p595_lanes + Lambda_0_11_p589_lanes;
  const Lanes<2> Lambda_0_11_p599_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p597_lanes;
  const Lanes<2> Lambda_0_11_p601_lanes = Lambda_0_11_p585_lanes - Lambda_0_11_p599_lanes;
  const Lanes<2> Lambda_0_11_p603_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p601_lanes;
  const Lanes<2> Lambda_0_11_p605_lanes = Lambda_0_11_p603_lanes + Lambda_0_11_p589_lanes;
  const Lanes<2> Lambda_0_11_p607_lanes = 0.7139200499999999 + Lambda_0_11_p605_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p609_lanes = Lambda_0_11_p607_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_0_11_p611_lanes = 0.00010499999999999999 * Lambda_0_11_p609_lanes;
  const Lanes<2> Lambda_0_11_p613_lanes = Lambda_0_11_p565_lanes + Lambda_0_11_p611_lanes;
  const Lanes<2> Lambda_0_11_p615_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p613_lanes;
  const Lanes<2> Lambda_0_11_p617_lanes = Lambda_0_11_p511_lanes * Lambda_0_11_p609_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p619_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p601_lanes;
  const Lanes<2> Lambda_0_11_p621_lanes = Lambda_0_11_p573_lanes - Lambda_0_11_p619_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p623_lanes = Lambda_0_11_p621_lanes - Lambda_0_11_p617_lanes;
  const Lanes<2> Lambda_0_11_p625_lanes = 0.00010499999999999999 * Lambda_0_11_p555_lanes;
  const Lanes<2> Lambda_0_11_p627_lanes = Lambda_0_11_p625_lanes + Lambda_0_11_p623_lanes;
  const Lanes<2> Lambda_0_11_p629_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p627_lanes;
  const Lanes<2> Lambda_0_11_p631_lanes = Lambda_0_11_p615_lanes - Lambda_0_11_p629_lanes;
  const Lanes<2> Lambda_0_11_p633_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p631_lanes;
  const Lanes<2> Lambda_0_11_p635_lanes = Lambda_0_11_p633_lanes - Lambda_0_11_p611_lanes;
  const Lanes<2> Lambda_0_11_p637_lanes = 0.0017499999999999998 + Lambda_0_11_p635_lanes;
  const Lanes<2> inverse_D7_p1_lanes = Lambda_0_11_p511_lanes * inverse_D8_lanes;
  const Lanes<2> inverse_D7_p2_lanes = Lambda_0_11_p511_lanes * inverse_D7_p1_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> inverse_D7_p3_lanes = Lambda_0_11_p311_lanes - inverse_D8_p1_lanes;
  const Lanes<2> inverse_D7_p4_lanes = 0.18113119219699997 + inverse_D7_p3_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D7_p5_lanes = inverse_D7_p4_lanes - inverse_D7_p2_lanes;
  const Lanes<2> inverse_D7_p6_lanes = 1.1024999999999998e-08 / inverse_D8_p3_lanes;
  const Lanes<2> inverse_D7_p7_lanes = 0.00012075 - inverse_D7_p6_lanes;
  const Lanes<2> inverse_D7_p8_lanes = inverse_D7_p7_lanes - inverse_D7_p5_lanes;
  const Lanes<2> inverse_D7_p9_lanes = detail::make_lanes<Real>(s8, s15) * inverse_D7_p8_lanes;
  const Lanes<2> inverse_D7_p10_lanes = 0.00010499999999999999 * inverse_D7_p1_lanes;
  const Lanes<2> inverse_D7_p11_lanes = detail::make_lanes<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + inverse_D7_p10_lanes;
  const Lanes<2> inverse_D7_p12_lanes = 2.0 * detail::make_lanes<Real>(c8, c15);
  const Lanes<2> inverse_D7_p13_lanes = inverse_D7_p12_lanes * inverse_D7_p11_lanes;
  const Lanes<2> inverse_D7_p14_lanes = inverse_D7_p9_lanes + inverse_D7_p13_lanes;
  const Lanes<2> inverse_D7_p15_lanes = detail::make_lanes<Real>(s8, s15) * inverse_D7_p14_lanes;
  const Lanes<2> inverse_D7_p16_lanes = inverse_D7_p5_lanes + inverse_D7_p15_lanes;
  const Lanes<2> inverse_D7_p17_lanes = 0.000448 + inverse_D7_p16_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D7_lanes = 1.0 / inverse_D7_p17_lanes;
  const Lanes<2> Lambda_0_11_p639_lanes = Lambda_0_11_p637_lanes * inverse_D7_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p641_lanes = detail::make_lanes<Real>(c8, c15) * inverse_D7_p14_lanes;
  const Lanes<2> Lambda_0_11_p643_lanes = Lambda_0_11_p641_lanes - inverse_D7_p11_lanes;
  const Lanes<2> Lambda_0_11_p645_lanes = detail::make_lanes<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + Lambda_0_11_p643_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p647_lanes = Lambda_0_11_p645_lanes * Lambda_0_11_p639_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p649_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p631_lanes;
  const Lanes<2> Lambda_0_11_p651_lanes = Lambda_0_11_p625_lanes + Lambda_0_11_p649_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p653_lanes = Lambda_0_11_p651_lanes + Lambda_0_11_p647_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p655_lanes = Lambda_0_11_p619_lanes - Lambda_0_11_p581_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p657_lanes = Lambda_0_11_p655_lanes * inverse_D8_lanes;
  const Lanes<2> Lambda_0_11_p659_lanes = 0.00010499999999999999 * Lambda_0_11_p657_lanes;
  const Lanes<2> Lambda_0_11_p661_lanes = detail::make_lanes<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + Lambda_0_11_p659_lanes;
  const Lanes<2> Lambda_0_11_p663_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p661_lanes;
  const Lanes<2> Lambda_0_11_p665_lanes = Lambda_0_11_p511_lanes * Lambda_0_11_p657_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p667_lanes = Lambda_0_11_p603_lanes + Lambda_0_11_p595_lanes;
  const Lanes<2> Lambda_0_11_p669_lanes = Lambda_0_11_p667_lanes - 0.7139200499999999;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p671_lanes = Lambda_0_11_p669_lanes - Lambda_0_11_p665_lanes;
  const Lanes<2> Lambda_0_11_p673_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p671_lanes;
  const Lanes<2> Lambda_0_11_p675_lanes = Lambda_0_11_p663_lanes + Lambda_0_11_p673_lanes;
  const Lanes<2> Lambda_0_11_p677_lanes = 0.0017499999999999998 + Lambda_0_11_p675_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p679_lanes = Lambda_0_11_p677_lanes * inverse_D7_lanes;
  const Lanes<2> Lambda_0_11_p681_lanes = detail::make_lanes<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * Lambda_0_11_p679_lanes;
  const Lanes<2> Lambda_0_11_p683_lanes = Lambda_0_11_p653_lanes - Lambda_0_11_p681_lanes;
  const Lanes<2> Lambda_0_11_p685_lanes = detail::make_lanes<Real>(c7, c14) *
      Lambda_0_11_p683_lanes;
  const Lanes<2> Lambda_0_11_p687_lanes = Lambda_0_11_p645_lanes * Lambda_0_11_p679_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p689_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p661_lanes;
  const Lanes<2> Lambda_0_11_p691_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p671_lanes;
  const Lanes<2> Lambda_0_11_p693_lanes = Lambda_0_11_p689_lanes - Lambda_0_11_p691_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p695_lanes = Lambda_0_11_p693_lanes - Lambda_0_11_p687_lanes;
  const Lanes<2> Lambda_0_11_p697_lanes = detail::make_lanes<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * Lambda_0_11_p639_lanes;
  const Lanes<2> Lambda_0_11_p699_lanes = Lambda_0_11_p695_lanes - Lambda_0_11_p697_lanes;
  const Lanes<2> Lambda_0_11_p701_lanes = detail::make_lanes<Real>(s7, s14) *
      Lambda_0_11_p699_lanes;
  const Lanes<2> Lambda_0_11_p703_lanes = Lambda_0_11_p685_lanes - Lambda_0_11_p701_lanes;
  const Lanes<2> Lambda_0_11_p705_lanes = detail::make_lanes<Real>(s7, s14) *
      Lambda_0_11_p703_lanes;
  const Lanes<2> Lambda_0_11_p707_lanes = Lambda_0_11_p697_lanes - Lambda_0_11_p705_lanes;
  const Lanes<2> Lambda_0_11_p709_lanes = Lambda_0_11_p677_lanes * Lambda_0_11_p679_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p711_lanes = Lambda_0_11_p655_lanes * Lambda_0_11_p657_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p713_lanes = Lambda_0_11_p567_lanes * Lambda_0_11_p569_lanes;
  const Lanes<2> Lambda_0_11_p715_lanes = Lambda_0_11_p449_lanes - Lambda_0_11_p713_lanes;
  const Lanes<2> Lambda_0_11_p717_lanes = Lambda_0_11_p575_lanes * Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p719_lanes = Lambda_0_11_p295_lanes - Lambda_0_11_p717_lanes;
  const Lanes<2> Lambda_0_11_p721_lanes = Lambda_0_11_p715_lanes - Lambda_0_11_p719_lanes;
  const Lanes<2> Lambda_0_11_p723_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p721_lanes;
  const Lanes<2> Lambda_0_11_p725_lanes = Lambda_0_11_p567_lanes * Lambda_0_11_p577_lanes;
  const Lanes<2> Lambda_0_11_p727_lanes = Lambda_0_11_p489_lanes + Lambda_0_11_p725_lanes;
  const Lanes<2> Lambda_0_11_p729_lanes = Lambda_0_11_p501_lanes * Lambda_0_11_p727_lanes;
  const Lanes<2> Lambda_0_11_p731_lanes = Lambda_0_11_p723_lanes - Lambda_0_11_p729_lanes;
  const Lanes<2> Lambda_0_11_p733_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p731_lanes;
  const Lanes<2> Lambda_0_11_p735_lanes = Lambda_0_11_p719_lanes + Lambda_0_11_p733_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p737_lanes = Lambda_0_11_p735_lanes - Lambda_0_11_p711_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p739_lanes = Lambda_0_11_p737_lanes - Lambda_0_11_p709_lanes;
  const Lanes<2> Lambda_0_11_p741_lanes = Lambda_0_11_p637_lanes * Lambda_0_11_p639_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p743_lanes = Lambda_0_11_p553_lanes * Lambda_0_11_p609_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p745_lanes = Lambda_0_11_p567_lanes * Lambda_0_11_p515_lanes;
  const Lanes<2> Lambda_0_11_p747_lanes = Lambda_0_11_p541_lanes + Lambda_0_11_p745_lanes;
  const Lanes<2> Lambda_0_11_p749_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p747_lanes;
  const Lanes<2> Lambda_0_11_p751_lanes = Lambda_0_11_p575_lanes * Lambda_0_11_p515_lanes;
  const Lanes<2> Lambda_0_11_p753_lanes = Lambda_0_11_p523_lanes + Lambda_0_11_p751_lanes;
  const Lanes<2> Lambda_0_11_p755_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p753_lanes;
  const Lanes<2> Lambda_0_11_p757_lanes = Lambda_0_11_p749_lanes - Lambda_0_11_p755_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p759_lanes = Lambda_0_11_p757_lanes + Lambda_0_11_p743_lanes;
  const Lanes<2> Lambda_0_11_p761_lanes = inverse_D7_p12_lanes * Lambda_0_11_p759_lanes;
  const Lanes<2> Lambda_0_11_p763_lanes = Lambda_0_11_p607_lanes * Lambda_0_11_p609_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p765_lanes = Lambda_0_11_p715_lanes - Lambda_0_11_p733_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p767_lanes = Lambda_0_11_p765_lanes - Lambda_0_11_p763_lanes;
  const Lanes<2> Lambda_0_11_p769_lanes = Lambda_0_11_p553_lanes * Lambda_0_11_p555_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p771_lanes = Lambda_0_11_p513_lanes * Lambda_0_11_p515_lanes;

  // link 10 (left_lowerarm), articulated inertia
  const Lanes<2> Lambda_0_11_p773_lanes = Lambda_0_11_p439_lanes + Lambda_0_11_p447_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p775_lanes = Lambda_0_11_p773_lanes + Lambda_0_11_p771_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p777_lanes = Lambda_0_11_p775_lanes + Lambda_0_11_p769_lanes;
  const Lanes<2> Lambda_0_11_p779_lanes = Lambda_0_11_p777_lanes + Lambda_0_11_p767_lanes;
  const Lanes<2> Lambda_0_11_p781_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p779_lanes;
  const Lanes<2> Lambda_0_11_p783_lanes = Lambda_0_11_p761_lanes - Lambda_0_11_p781_lanes;
  const Lanes<2> Lambda_0_11_p785_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p783_lanes;
  const Lanes<2> Lambda_0_11_p787_lanes = Lambda_0_11_p777_lanes + Lambda_0_11_p785_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p789_lanes = Lambda_0_11_p787_lanes + Lambda_0_11_p741_lanes;
  const Lanes<2> Lambda_0_11_p791_lanes = Lambda_0_11_p739_lanes + Lambda_0_11_p789_lanes;
  const Lanes<2> Lambda_0_11_p793_lanes = detail::make_lanes<Real>(c7, c14) *
      Lambda_0_11_p791_lanes;
  const Lanes<2> Lambda_0_11_p795_lanes = Lambda_0_11_p677_lanes * Lambda_0_11_p639_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p797_lanes = Lambda_0_11_p553_lanes * Lambda_0_11_p657_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p799_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p747_lanes;
  const Lanes<2> Lambda_0_11_p801_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p753_lanes;
  const Lanes<2> Lambda_0_11_p803_lanes = Lambda_0_11_p799_lanes + Lambda_0_11_p801_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p805_lanes = Lambda_0_11_p803_lanes + Lambda_0_11_p797_lanes;
  const Lanes<2> Lambda_0_11_p807_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p805_lanes;
  const Lanes<2> Lambda_0_11_p809_lanes = Lambda_0_11_p607_lanes * Lambda_0_11_p657_lanes;

  // link 9 (left_upperarm), articulated inertia
  const Lanes<2> Lambda_0_11_p811_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p731_lanes;
  const Lanes<2> Lambda_0_11_p813_lanes = Lambda_0_11_p811_lanes + Lambda_0_11_p727_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p815_lanes = Lambda_0_11_p813_lanes - Lambda_0_11_p809_lanes;
  const Lanes<2> Lambda_0_11_p817_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p815_lanes;
  const Lanes<2> Lambda_0_11_p819_lanes = Lambda_0_11_p807_lanes - Lambda_0_11_p817_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p821_lanes = Lambda_0_11_p819_lanes - Lambda_0_11_p795_lanes;
  const Lanes<2> Lambda_0_11_p823_lanes = 2.0 * detail::make_lanes<Real>(s7, s14);
  const Lanes<2> Lambda_0_11_p825_lanes = Lambda_0_11_p823_lanes * Lambda_0_11_p821_lanes;
  const Lanes<2> Lambda_0_11_p827_lanes = Lambda_0_11_p793_lanes - Lambda_0_11_p825_lanes;
  const Lanes<2> Lambda_0_11_p829_lanes = detail::make_lanes<Real>(c7, c14) *
      Lambda_0_11_p827_lanes;
  const Lanes<2> Lambda_0_11_p831_lanes = Lambda_0_11_p739_lanes - Lambda_0_11_p829_lanes;
  const Lanes<2> Lambda_0_11_p833_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      Lambda_0_11_p831_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p835_lanes = Lambda_0_11_p623_lanes + Lambda_0_11_p649_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p837_lanes = Lambda_0_11_p835_lanes * inverse_D7_lanes;
  const Lanes<2> Lambda_0_11_p839_lanes = Lambda_0_11_p677_lanes * Lambda_0_11_p837_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p841_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p805_lanes;
  const Lanes<2> Lambda_0_11_p843_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p815_lanes;
  const Lanes<2> Lambda_0_11_p845_lanes = Lambda_0_11_p841_lanes + Lambda_0_11_p843_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p847_lanes = Lambda_0_11_p845_lanes - Lambda_0_11_p839_lanes;
  const Lanes<2> Lambda_0_11_p849_lanes = detail::make_lanes<Real>(s7, s14) *
      Lambda_0_11_p847_lanes;
  const Lanes<2> Lambda_0_11_p851_lanes = Lambda_0_11_p637_lanes * Lambda_0_11_p837_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p853_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p783_lanes;
  const Lanes<2> Lambda_0_11_p855_lanes = Lambda_0_11_p853_lanes - Lambda_0_11_p759_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p857_lanes = Lambda_0_11_p855_lanes - Lambda_0_11_p851_lanes;
  const Lanes<2> Lambda_0_11_p859_lanes = detail::make_lanes<Real>(c7, c14) *
      Lambda_0_11_p857_lanes;
  const Lanes<2> Lambda_0_11_p861_lanes = Lambda_0_11_p849_lanes + Lambda_0_11_p859_lanes;
  const Lanes<2> Lambda_0_11_p863_lanes = 0.226 * Lambda_0_11_p861_lanes;
  const Lanes<2> Lambda_0_11_p865_lanes = Lambda_0_11_p833_lanes + Lambda_0_11_p863_lanes;
  const Lanes<2> Lambda_0_11_p867_lanes = Lambda_0_11_p707_lanes + Lambda_0_11_p865_lanes;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p869_lanes = 0.0007770270270270272 *
      detail::make_lanes<Real>(c23, c24);
  const Lanes<2> Lambda_0_11_p871_lanes = detail::make_lanes<Real>(c23, c24) *
      Lambda_0_11_p869_lanes;
  const Lanes<2> Lambda_0_11_p873_lanes = Lambda_0_11_p871_lanes - 0.0007770270270270272;
  const Real Lambda_0_11_p875 = 0.431222972972973 + Lambda_0_11_p871_lanes[1] +
      Lambda_0_11_p873_lanes[0];
  const Lanes<2> inverse_D22_p1_lanes = 9.060810810810813e-05 * detail::make_lanes<Real>(s23, s24);
  const Lanes<2> inverse_D22_p3_lanes = detail::make_lanes<Real>(s23, s24) * inverse_D22_p1_lanes;
  const Real inverse_D22_p5 = inverse_D22_p3_lanes[1] + inverse_D22_p3_lanes[0];
  const Real inverse_D22_p6 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p5 + 4.75e-05 * inverse_D22_p6);
  const Real Lambda_0_11_p876 = Lambda_0_11_p875 * inverse_D22;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p877_lanes = detail::make_lanes<Real>(8e-06, (-8e-06)) +
      inverse_D22_p1_lanes;
  const Lanes<2> Lambda_0_11_p879_lanes = Lambda_0_11_p877_lanes *
      detail::make_lanes<Real>(c23, c24);
  const Real Lambda_0_11_p881 = s24 + s23;
  const Real Lambda_0_11_p882 = Lambda_0_11_p879_lanes[0] + 2.375e-05 * Lambda_0_11_p881 +
      Lambda_0_11_p879_lanes[1];
  const Lanes<2> Lambda_0_11_p883_lanes = detail::make_lanes<Real>(s23, s24) *
      Lambda_0_11_p869_lanes;
  const Real Lambda_0_11_p885 = Lambda_0_11_p883_lanes[1] + Lambda_0_11_p883_lanes[0];

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p886 = Lambda_0_11_p882 * Lambda_0_11_p876 - Lambda_0_11_p885;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p887_lanes = detail::make_lanes<Real>(0.032, (-0.032)) *
      Lambda_0_11_p873_lanes;
  const Real Lambda_0_11_p889 = Lambda_0_11_p887_lanes[1] + Lambda_0_11_p887_lanes[0] - 0.095 *
      Lambda_0_11_p885;
  const Real Lambda_0_11_p890 = 0.072575 + 0.00025 * inverse_D22_p6;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p891 = Lambda_0_11_p890 * inverse_D22;
  const Real Lambda_0_11_p892 = Lambda_0_11_p889 * Lambda_0_11_p891;

  // link 23 (left_eye), articulated inertia
  const Lanes<2> Lambda_0_11_p893_lanes = 0.006756756756756757 * detail::make_lanes<Real>(s23, s24);
  const Lanes<2> Lambda_0_11_p895_lanes = detail::make_lanes<Real>(c23, c24) *
      Lambda_0_11_p893_lanes;
  const Lanes<2> Lambda_0_11_p897_lanes = 0.095 * Lambda_0_11_p895_lanes;
  const Lanes<2> Lambda_0_11_p899_lanes = detail::make_lanes<Real>(s23, s24) *
      Lambda_0_11_p893_lanes;
  const Lanes<2> Lambda_0_11_p901_lanes = detail::make_lanes<Real>(0.032, (-0.032)) *
      Lambda_0_11_p899_lanes;
  const Lanes<2> Lambda_0_11_p903_lanes = Lambda_0_11_p897_lanes + Lambda_0_11_p901_lanes;

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
  const Lanes<2> inverse_D21_p4_lanes = 0.095 * inverse_D21_p2_lanes;
  const Lanes<2> inverse_D21_p6_lanes = detail::make_lanes<Real>(0.032, (-0.032)) *
      Lambda_0_11_p895_lanes;
  const Lanes<2> inverse_D21_p8_lanes = inverse_D21_p4_lanes - inverse_D21_p6_lanes;

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
  const Lanes<2> inverse_D6_p1_lanes = Lambda_0_11_p707_lanes + Lambda_0_11_p867_lanes;
  const Lanes<2> inverse_D6_p3_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      inverse_D6_p1_lanes;
  const Lanes<2> inverse_D6_p5_lanes = Lambda_0_11_p645_lanes * inverse_D7_lanes;
  const Lanes<2> inverse_D6_p7_lanes = Lambda_0_11_p645_lanes * inverse_D6_p5_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p9_lanes = inverse_D7_p7_lanes - inverse_D7_p15_lanes;
  const Lanes<2> inverse_D6_p11_lanes = 0.0002975 + inverse_D6_p9_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p13_lanes = inverse_D6_p11_lanes - inverse_D6_p7_lanes;
  const Lanes<2> inverse_D6_p15_lanes = detail::make_lanes<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / inverse_D7_p17_lanes;
  const Lanes<2> inverse_D6_p17_lanes = 0.0001505 - inverse_D6_p15_lanes;
  const Lanes<2> inverse_D6_p19_lanes = inverse_D6_p17_lanes - inverse_D6_p13_lanes;
  const Lanes<2> inverse_D6_p21_lanes = detail::make_lanes<Real>(c7, c14) * inverse_D6_p19_lanes;
  const Lanes<2> inverse_D6_p23_lanes = detail::make_lanes<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * inverse_D6_p5_lanes;
  const Lanes<2> inverse_D6_p25_lanes = 8.75e-06 + inverse_D6_p23_lanes;
  const Lanes<2> inverse_D6_p27_lanes = Lambda_0_11_p823_lanes * inverse_D6_p25_lanes;
  const Lanes<2> inverse_D6_p29_lanes = inverse_D6_p21_lanes + inverse_D6_p27_lanes;
  const Lanes<2> inverse_D6_p31_lanes = detail::make_lanes<Real>(c7, c14) * inverse_D6_p29_lanes;
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
  const Lanes<2> inverse_D6_p49_lanes = detail::make_lanes<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * Lambda_0_11_p837_lanes;
  const Lanes<2> inverse_D6_p51_lanes = 0.0017499999999999998 + inverse_D6_p49_lanes;
  const Lanes<2> inverse_D6_p53_lanes = detail::make_lanes<Real>(c7, c14) * inverse_D6_p51_lanes;
  const Lanes<2> inverse_D6_p55_lanes = Lambda_0_11_p645_lanes * Lambda_0_11_p837_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p57_lanes = Lambda_0_11_p633_lanes - Lambda_0_11_p565_lanes;
  const Lanes<2> inverse_D6_p59_lanes = inverse_D6_p57_lanes - 0.0017499999999999998;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p61_lanes = inverse_D6_p59_lanes - inverse_D6_p55_lanes;
  const Lanes<2> inverse_D6_p63_lanes = detail::make_lanes<Real>(s7, s14) * inverse_D6_p61_lanes;
  const Lanes<2> inverse_D6_p65_lanes = inverse_D6_p53_lanes + inverse_D6_p63_lanes;
  const Lanes<2> inverse_D6_p67_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      Lambda_0_11_p861_lanes;
  const Lanes<2> inverse_D6_p69_lanes = Lambda_0_11_p835_lanes * Lambda_0_11_p837_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> inverse_D6_p71_lanes = Lambda_0_11_p767_lanes + Lambda_0_11_p785_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> inverse_D6_p73_lanes = inverse_D6_p71_lanes - inverse_D6_p69_lanes;
  const Lanes<2> inverse_D6_p75_lanes = 0.226 * inverse_D6_p73_lanes;
  const Lanes<2> inverse_D6_p77_lanes = inverse_D6_p67_lanes + inverse_D6_p75_lanes;
  const Lanes<2> inverse_D6_p79_lanes = inverse_D6_p65_lanes + inverse_D6_p77_lanes;
  const Real inverse_D6_p81 = inverse_D6_p79_lanes[1] + inverse_D6_p79_lanes[0];
  const Real inverse_D6_p82 = 2.06965463592404 + inverse_D6_p41 + inverse_D6_p48 +
      inverse_D6_p13_lanes[1] + inverse_D6_p33 + inverse_D6_p3_lanes[1] + inverse_D6_p13_lanes[0] +
      inverse_D6_p3_lanes[0] + 0.226 * (inverse_D6_p65_lanes[1] + inverse_D6_p81 +
      inverse_D6_p65_lanes[0]);

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p82;
  const Real Lambda_0_11_p930 = Lambda_0_11_p929 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p931_lanes = detail::make_lanes<Real>(c7, c14) *
      Lambda_0_11_p703_lanes;
  const Lanes<2> Lambda_0_11_p933_lanes = Lambda_0_11_p931_lanes - Lambda_0_11_p653_lanes;
  const Lanes<2> Lambda_0_11_p935_lanes = detail::make_lanes<Real>(s7, s14) *
      Lambda_0_11_p827_lanes;
  const Lanes<2> Lambda_0_11_p937_lanes = Lambda_0_11_p935_lanes + Lambda_0_11_p821_lanes;
  const Lanes<2> Lambda_0_11_p939_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      Lambda_0_11_p937_lanes;
  const Lanes<2> Lambda_0_11_p941_lanes = detail::make_lanes<Real>(c7, c14) *
      Lambda_0_11_p847_lanes;
  const Lanes<2> Lambda_0_11_p943_lanes = detail::make_lanes<Real>(s7, s14) *
      Lambda_0_11_p857_lanes;
  const Lanes<2> Lambda_0_11_p945_lanes = Lambda_0_11_p941_lanes - Lambda_0_11_p943_lanes;
  const Lanes<2> Lambda_0_11_p947_lanes = 0.226 * Lambda_0_11_p945_lanes;
  const Lanes<2> Lambda_0_11_p949_lanes = Lambda_0_11_p939_lanes + Lambda_0_11_p947_lanes;
  const Lanes<2> Lambda_0_11_p951_lanes = Lambda_0_11_p933_lanes - Lambda_0_11_p949_lanes;
  const Lanes<2> Lambda_0_11_p953_lanes = Lambda_0_11_p681_lanes + Lambda_0_11_p931_lanes;
  const Lanes<2> Lambda_0_11_p955_lanes = Lambda_0_11_p951_lanes + Lambda_0_11_p953_lanes;
  const Lanes<2> Lambda_0_11_p957_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      Lambda_0_11_p955_lanes;
  const Lanes<2> Lambda_0_11_p959_lanes = detail::make_lanes<Real>(s7, s14) * inverse_D6_p29_lanes;
  const Lanes<2> Lambda_0_11_p961_lanes = detail::make_lanes<Real>(s7, s14) * inverse_D6_p51_lanes;
  const Lanes<2> Lambda_0_11_p963_lanes = detail::make_lanes<Real>(c7, c14) * inverse_D6_p61_lanes;
  const Lanes<2> Lambda_0_11_p965_lanes = Lambda_0_11_p961_lanes - Lambda_0_11_p963_lanes;
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
  const Lanes<2> inverse_D5_p5_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      inverse_D5_p3_lanes;
  const Lanes<2> inverse_D5_p7_lanes = inverse_D5_p1_lanes + inverse_D5_p5_lanes;

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
  const Lanes<2> inverse_D5_p17_lanes = inverse_D5_p1_lanes + inverse_D5_p7_lanes;
  const Lanes<2> inverse_D5_p19_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      inverse_D5_p17_lanes;

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

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1089_lanes = detail::make_lanes<Real>(s7, s14) * Lambda_0_11_p1088;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1091 = c5 * Lambda_0_11_p1084 + s5 * Lambda_0_11_p1085;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1092_lanes = detail::make_lanes<Real>(c7, c14) * Lambda_0_11_p1091;
  const Lanes<2> Lambda_0_11_p1094_lanes = Lambda_0_11_p1089_lanes - Lambda_0_11_p1092_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1096_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p1094_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1098_lanes = detail::make_lanes<Real>(c7, c14) * Lambda_0_11_p1088;
  const Lanes<2> Lambda_0_11_p1100_lanes = detail::make_lanes<Real>(s7, s14) * Lambda_0_11_p1091;
  const Lanes<2> Lambda_0_11_p1102_lanes = Lambda_0_11_p1098_lanes + Lambda_0_11_p1100_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1104_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p1102_lanes;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1106 = s6 * Lambda_0_11_p1086 - c6 * Lambda_0_11_p1087;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1107_lanes = detail::make_lanes<Real>(c8, c15) * Lambda_0_11_p1106;
  const Lanes<2> Lambda_0_11_p1109_lanes = Lambda_0_11_p1104_lanes + Lambda_0_11_p1107_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1111_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p1109_lanes;
  const Lanes<2> Lambda_0_11_p1113_lanes = Lambda_0_11_p1096_lanes - Lambda_0_11_p1111_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_0_11_p1115_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p1113_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1117_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p1102_lanes;
  const Lanes<2> Lambda_0_11_p1119_lanes = detail::make_lanes<Real>(s8, s15) * Lambda_0_11_p1106;
  const Lanes<2> Lambda_0_11_p1121_lanes = Lambda_0_11_p1117_lanes - Lambda_0_11_p1119_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_0_11_p1123_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p1121_lanes;
  const Lanes<2> Lambda_0_11_p1125_lanes = Lambda_0_11_p1115_lanes + Lambda_0_11_p1123_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1127_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p1125_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1129_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p1109_lanes;
  const Lanes<2> Lambda_0_11_p1131_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p1094_lanes;
  const Lanes<2> Lambda_0_11_p1133_lanes = Lambda_0_11_p1129_lanes + Lambda_0_11_p1131_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1135_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p1133_lanes;
  const Lanes<2> Lambda_0_11_p1137_lanes = Lambda_0_11_p1127_lanes - Lambda_0_11_p1135_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1139_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1137_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p1141 = c17 * Lambda_0_11_p1121_lanes[1] - s17 *
      Lambda_0_11_p1113_lanes[1];

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1142 = s5 * s4;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1143 = s6 * Lambda_0_11_p1142 + c6 * c4;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1144_lanes = detail::make_lanes<Real>(c8, c15) * Lambda_0_11_p1143;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1146 = s6 * c4 - c6 * Lambda_0_11_p1142;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1147_lanes = detail::make_lanes<Real>(c7, c14) * Lambda_0_11_p1146;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1149 = c5 * s4;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1150_lanes = detail::make_lanes<Real>(s7, s14) * Lambda_0_11_p1149;
  const Lanes<2> Lambda_0_11_p1152_lanes = Lambda_0_11_p1147_lanes - Lambda_0_11_p1150_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1154_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p1152_lanes;
  const Lanes<2> Lambda_0_11_p1156_lanes = Lambda_0_11_p1144_lanes - Lambda_0_11_p1154_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1158_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p1156_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1160_lanes = detail::make_lanes<Real>(s7, s14) * Lambda_0_11_p1146;
  const Lanes<2> Lambda_0_11_p1162_lanes = detail::make_lanes<Real>(c7, c14) * Lambda_0_11_p1149;
  const Lanes<2> Lambda_0_11_p1164_lanes = Lambda_0_11_p1160_lanes + Lambda_0_11_p1162_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1166_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p1164_lanes;
  const Lanes<2> Lambda_0_11_p1168_lanes = Lambda_0_11_p1158_lanes + Lambda_0_11_p1166_lanes;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p1170 = c4 * Lambda_0_11_p1085;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1171 = s5 * Lambda_0_11_p1170 + c5 * Lambda_0_11_p1083;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p1172 = s4 * Lambda_0_11_p1085;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1173 = c6 * Lambda_0_11_p1171 + s6 * Lambda_0_11_p1172;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1174_lanes = detail::make_lanes<Real>(c7, c14) * Lambda_0_11_p1173;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p1176 = c5 * Lambda_0_11_p1170 - s5 * Lambda_0_11_p1083;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1177_lanes = detail::make_lanes<Real>(s7, s14) * Lambda_0_11_p1176;
  const Lanes<2> Lambda_0_11_p1179_lanes = Lambda_0_11_p1174_lanes + Lambda_0_11_p1177_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1181_lanes = detail::make_lanes<Real>(s8, s15) *
      Lambda_0_11_p1179_lanes;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p1183 = s6 * Lambda_0_11_p1171 - c6 * Lambda_0_11_p1172;

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1184_lanes = detail::make_lanes<Real>(c8, c15) * Lambda_0_11_p1183;
  const Lanes<2> Lambda_0_11_p1186_lanes = Lambda_0_11_p1181_lanes + Lambda_0_11_p1184_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1188_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p1186_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> Lambda_0_11_p1190_lanes = detail::make_lanes<Real>(c7, c14) * Lambda_0_11_p1176;
  const Lanes<2> Lambda_0_11_p1192_lanes = detail::make_lanes<Real>(s7, s14) * Lambda_0_11_p1173;
  const Lanes<2> Lambda_0_11_p1194_lanes = Lambda_0_11_p1190_lanes - Lambda_0_11_p1192_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1196_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p1194_lanes;
  const Lanes<2> Lambda_0_11_p1198_lanes = Lambda_0_11_p1188_lanes + Lambda_0_11_p1196_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<8> Lambda_0_11_p1200_lanes = s10 *
      detail::make_lanes<Real>(Lambda_0_11_p1198_lanes[0], Lambda_0_11_p1168_lanes[0],
      Lambda_0_11_p1113_lanes[0], Lambda_0_11_p1198_lanes[0], Lambda_0_11_p1198_lanes[0],
      Lambda_0_11_p1198_lanes[0], Lambda_0_11_p1198_lanes[0], Lambda_0_11_p1198_lanes[0]);

  // link 8 (left_shoulder2), pose
  const Lanes<2> Lambda_0_11_p1203_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p1152_lanes;
  const Lanes<2> Lambda_0_11_p1205_lanes = detail::make_lanes<Real>(s8, s15) * Lambda_0_11_p1143;
  const Lanes<2> Lambda_0_11_p1207_lanes = Lambda_0_11_p1203_lanes + Lambda_0_11_p1205_lanes;
  const Lanes<2> Lambda_0_11_p1209_lanes = detail::make_lanes<Real>(c8, c15) *
      Lambda_0_11_p1179_lanes;
  const Lanes<2> Lambda_0_11_p1211_lanes = detail::make_lanes<Real>(s8, s15) * Lambda_0_11_p1183;
  const Lanes<2> Lambda_0_11_p1213_lanes = Lambda_0_11_p1211_lanes - Lambda_0_11_p1209_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<8> Lambda_0_11_p1215_lanes = c10 *
      detail::make_lanes<Real>(Lambda_0_11_p1213_lanes[0], Lambda_0_11_p1207_lanes[0],
      Lambda_0_11_p1121_lanes[0], Lambda_0_11_p1213_lanes[0], Lambda_0_11_p1213_lanes[0],
      Lambda_0_11_p1213_lanes[0], Lambda_0_11_p1213_lanes[0], Lambda_0_11_p1213_lanes[0]);
  const Lanes<8> Lambda_0_11_p1218_lanes = Lambda_0_11_p1215_lanes - Lambda_0_11_p1200_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1221_lanes = detail::make_lanes<Real>(c12, c19) *
      detail::make_lanes<Real>(Lambda_0_11_p1218_lanes[2], Lambda_0_11_p1141);
  const Lanes<2> Lambda_0_11_p1223_lanes = Lambda_0_11_p1221_lanes - Lambda_0_11_p1139_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1225_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1223_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1227_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p1125_lanes;
  const Lanes<2> Lambda_0_11_p1229_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p1133_lanes;
  const Lanes<2> Lambda_0_11_p1231_lanes = Lambda_0_11_p1227_lanes + Lambda_0_11_p1229_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1233_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1231_lanes;
  const Lanes<2> Lambda_0_11_p1235_lanes = Lambda_0_11_p1225_lanes - Lambda_0_11_p1233_lanes;

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p1237 = c19 * Lambda_0_11_p1137_lanes[1] + s19 * Lambda_0_11_p1141;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_0_11_p1238_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p1168_lanes;
  const Lanes<2> Lambda_0_11_p1240_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p1207_lanes;
  const Lanes<2> Lambda_0_11_p1242_lanes = Lambda_0_11_p1238_lanes + Lambda_0_11_p1240_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1244_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p1242_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1246_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p1156_lanes;
  const Lanes<2> Lambda_0_11_p1248_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p1164_lanes;
  const Lanes<2> Lambda_0_11_p1250_lanes = Lambda_0_11_p1246_lanes - Lambda_0_11_p1248_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1252_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p1250_lanes;
  const Lanes<2> Lambda_0_11_p1254_lanes = Lambda_0_11_p1244_lanes + Lambda_0_11_p1252_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p1256 = c17 * Lambda_0_11_p1207_lanes[1] - s17 *
      Lambda_0_11_p1168_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p1257 = c19 * Lambda_0_11_p1254_lanes[1] + s19 * Lambda_0_11_p1256;

  // link 10 (left_lowerarm), pose
  const Lanes<2> Lambda_0_11_p1258_lanes = detail::make_lanes<Real>(c10, c17) *
      Lambda_0_11_p1198_lanes;
  const Lanes<2> Lambda_0_11_p1260_lanes = detail::make_lanes<Real>(s10, s17) *
      Lambda_0_11_p1213_lanes;
  const Lanes<2> Lambda_0_11_p1262_lanes = Lambda_0_11_p1258_lanes + Lambda_0_11_p1260_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1264_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p1262_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> Lambda_0_11_p1266_lanes = detail::make_lanes<Real>(c9, c16) *
      Lambda_0_11_p1186_lanes;
  const Lanes<2> Lambda_0_11_p1268_lanes = detail::make_lanes<Real>(s9, s16) *
      Lambda_0_11_p1194_lanes;
  const Lanes<2> Lambda_0_11_p1270_lanes = Lambda_0_11_p1266_lanes - Lambda_0_11_p1268_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1272_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p1270_lanes;
  const Lanes<2> Lambda_0_11_p1274_lanes = Lambda_0_11_p1264_lanes + Lambda_0_11_p1272_lanes;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p1276 = c17 * Lambda_0_11_p1213_lanes[1] - s17 *
      Lambda_0_11_p1198_lanes[1];

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p1277 = c19 * Lambda_0_11_p1274_lanes[1] + s19 * Lambda_0_11_p1276;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1278_lanes = 0.11533812622014242 *
      detail::make_lanes<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1281_lanes = detail::make_lanes<Real>(c12, c19) *
      detail::make_lanes<Real>(Lambda_0_11_p1218_lanes[1], Lambda_0_11_p1256);
  const Lanes<2> Lambda_0_11_p1283_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1254_lanes;
  const Lanes<2> Lambda_0_11_p1285_lanes = Lambda_0_11_p1281_lanes - Lambda_0_11_p1283_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1287_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1285_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1289_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p1242_lanes;
  const Lanes<2> Lambda_0_11_p1291_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p1250_lanes;
  const Lanes<2> Lambda_0_11_p1293_lanes = Lambda_0_11_p1291_lanes - Lambda_0_11_p1289_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1295_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1293_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1297 = Lambda_0_11_p1287_lanes[1] + Lambda_0_11_p1295_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> Lambda_0_11_p1298_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1274_lanes;
  const Lanes<2> Lambda_0_11_p1300_lanes = detail::make_lanes<Real>(c12, c19) *
      detail::make_lanes<Real>(Lambda_0_11_p1218_lanes[0], Lambda_0_11_p1276);
  const Lanes<2> Lambda_0_11_p1302_lanes = Lambda_0_11_p1300_lanes - Lambda_0_11_p1298_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1304_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1302_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> Lambda_0_11_p1306_lanes = detail::make_lanes<Real>(c11, c18) *
      Lambda_0_11_p1270_lanes;
  const Lanes<2> Lambda_0_11_p1308_lanes = detail::make_lanes<Real>(s11, s18) *
      Lambda_0_11_p1262_lanes;
  const Lanes<2> Lambda_0_11_p1310_lanes = Lambda_0_11_p1306_lanes - Lambda_0_11_p1308_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1312_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1310_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1314 = Lambda_0_11_p1304_lanes[1] + Lambda_0_11_p1312_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1315_lanes = detail::make_lanes<Real>(Lambda_0_11_p1314,
      Lambda_0_11_p1314, Lambda_0_11_p1297, Lambda_0_11_p1235_lanes[1], Lambda_0_11_p1314,
      Lambda_0_11_p1314, Lambda_0_11_p1314, Lambda_0_11_p1314) + Lambda_0_11_p1278_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1318_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1223_lanes;
  const Lanes<2> Lambda_0_11_p1320_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1231_lanes;
  const Lanes<2> Lambda_0_11_p1322_lanes = Lambda_0_11_p1318_lanes + Lambda_0_11_p1320_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1324 = -(0.086 * Lambda_0_11_p1322_lanes[1]);
  const Real Lambda_0_11_p1325 = 0.11533812622014242 * Lambda_0_11_p1324;
  const Lanes<8> Lambda_0_11_p1326_lanes = c20 * detail::make_lanes<Real>(Lambda_0_11_p1325,
      Lambda_0_11_p1315_lanes[1], Lambda_0_11_p1315_lanes[2], Lambda_0_11_p1315_lanes[3],
      Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325);
  const Real Lambda_0_11_p1330 = -Lambda_0_11_p1322_lanes[1];
  const Lanes<8> Lambda_0_11_p1331_lanes = (-0.04672761636452121) *
      detail::make_lanes<Real>(Lambda_0_11_p1324, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1324, Lambda_0_11_p1324, Lambda_0_11_p1324,
      Lambda_0_11_p1324);

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1335_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1285_lanes;
  const Lanes<2> Lambda_0_11_p1337_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1293_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1339 = Lambda_0_11_p1337_lanes[1] - Lambda_0_11_p1335_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> Lambda_0_11_p1340_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1310_lanes;
  const Lanes<2> Lambda_0_11_p1342_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1302_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p1344 = Lambda_0_11_p1340_lanes[1] - Lambda_0_11_p1342_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1345_lanes = detail::make_lanes<Real>(-(0.086 * Lambda_0_11_p1237),
      Lambda_0_11_p1344, Lambda_0_11_p1339, Lambda_0_11_p1330, -(0.086 * Lambda_0_11_p1237),
      -(0.086 * Lambda_0_11_p1237), -(0.086 * Lambda_0_11_p1237), -(0.086 * Lambda_0_11_p1237)) -
      Lambda_0_11_p1331_lanes;
  const Lanes<8> Lambda_0_11_p1349_lanes = s20 * Lambda_0_11_p1345_lanes;
  const Lanes<8> Lambda_0_11_p1353_lanes = Lambda_0_11_p1326_lanes - Lambda_0_11_p1349_lanes;
  const Lanes<8> Lambda_0_11_p1357_lanes = s20 * detail::make_lanes<Real>(Lambda_0_11_p1325,
      Lambda_0_11_p1315_lanes[1], Lambda_0_11_p1315_lanes[2], Lambda_0_11_p1315_lanes[3],
      Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325, Lambda_0_11_p1325);
  const Lanes<8> Lambda_0_11_p1361_lanes = c20 * Lambda_0_11_p1345_lanes;
  const Lanes<8> Lambda_0_11_p1365_lanes = Lambda_0_11_p1357_lanes + Lambda_0_11_p1361_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1369_lanes = inverse_D11_p1_lanes[1] * Lambda_0_11_p1365_lanes;
  const Lanes<8> Lambda_0_11_p1373_lanes = Lambda_0_11_p1353_lanes - Lambda_0_11_p1369_lanes;
  const Lanes<8> Lambda_0_11_p1377_lanes = s19 * Lambda_0_11_p1373_lanes;
  const Lanes<8> Lambda_0_11_p1381_lanes = Lambda_0_11_p61_lanes[1] * Lambda_0_11_p1365_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1385_lanes = 3.0523172236718206 *
      detail::make_lanes<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);
  const Lanes<8> Lambda_0_11_p1388_lanes = s20 * Lambda_0_11_p1385_lanes;
  const Lanes<8> Lambda_0_11_p1391_lanes = 17.32841575379867 *
      detail::make_lanes<Real>(Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1277, Lambda_0_11_p1277, Lambda_0_11_p1277,
      Lambda_0_11_p1277);
  const Lanes<8> Lambda_0_11_p1394_lanes = c20 * Lambda_0_11_p1391_lanes;
  const Lanes<8> Lambda_0_11_p1397_lanes = Lambda_0_11_p1388_lanes - Lambda_0_11_p1394_lanes;

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1400 = -(0.086 * Lambda_0_11_p1322_lanes[0]);
  const Lanes<2> Lambda_0_11_p1401_lanes = detail::make_lanes<Real>((-3.0523172236718206),
      3.0523172236718206) * detail::make_lanes<Real>(Lambda_0_11_p1400, Lambda_0_11_p1324);
  const Lanes<2> Lambda_0_11_p1403_lanes = Lambda_0_11_p1235_lanes + Lambda_0_11_p1401_lanes;
  const Lanes<2> Lambda_0_11_p1405_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1403_lanes;
  const Lanes<2> Lambda_0_11_p1407_lanes = 17.32841575379867 *
      detail::make_lanes<Real>(Lambda_0_11_p1400, Lambda_0_11_p1324);
  const Real Lambda_0_11_p1409 = -Lambda_0_11_p1322_lanes[0];
  const Lanes<2> Lambda_0_11_p1410_lanes = detail::make_lanes<Real>(Lambda_0_11_p1409,
      Lambda_0_11_p1330) - Lambda_0_11_p1407_lanes;
  const Lanes<2> Lambda_0_11_p1412_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1410_lanes;
  const Lanes<2> Lambda_0_11_p1414_lanes = Lambda_0_11_p1405_lanes + Lambda_0_11_p1412_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1416_lanes = detail::make_lanes<Real>(Lambda_0_11_p1414_lanes[1],
      Lambda_0_11_p1397_lanes[1], Lambda_0_11_p1397_lanes[2], Lambda_0_11_p1397_lanes[3],
      Lambda_0_11_p1414_lanes[1], Lambda_0_11_p1414_lanes[1], Lambda_0_11_p1414_lanes[1],
      Lambda_0_11_p1414_lanes[1]) - Lambda_0_11_p1381_lanes;
  const Lanes<8> Lambda_0_11_p1420_lanes = 0.269 * Lambda_0_11_p1416_lanes;
  const Lanes<8> Lambda_0_11_p1424_lanes = Lambda_0_11_p1420_lanes - Lambda_0_11_p1377_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1428 = -(c19 * Lambda_0_11_p1373_lanes[3]);
  const Real Lambda_0_11_p1429 = -(c19 * Lambda_0_11_p1373_lanes[2]);
  const Real Lambda_0_11_p1430 = -(c19 * Lambda_0_11_p1373_lanes[1]);
  const Real Lambda_0_11_p1431 = -(c19 * Lambda_0_11_p1373_lanes[0]);
  const Lanes<8> Lambda_0_11_p1432_lanes = inverse_D10_p1_lanes[1] *
      detail::make_lanes<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430, Lambda_0_11_p1429,
      Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);
  const Lanes<8> Lambda_0_11_p1436_lanes = Lambda_0_11_p1424_lanes - Lambda_0_11_p1432_lanes;
  const Lanes<8> Lambda_0_11_p1440_lanes = c18 * Lambda_0_11_p1436_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1444_lanes = Lambda_0_11_p35_lanes[1] * Lambda_0_11_p1365_lanes;
  const Lanes<8> Lambda_0_11_p1447_lanes = c19 * Lambda_0_11_p1444_lanes;
  const Lanes<8> Lambda_0_11_p1450_lanes = Lambda_0_11_p11_lanes[1] * Lambda_0_11_p1365_lanes;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p1453_lanes = c20 * Lambda_0_11_p1385_lanes;
  const Lanes<8> Lambda_0_11_p1456_lanes = s20 * Lambda_0_11_p1391_lanes;
  const Lanes<8> Lambda_0_11_p1459_lanes = Lambda_0_11_p1453_lanes + Lambda_0_11_p1456_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1462_lanes = Lambda_0_11_p1459_lanes - Lambda_0_11_p1450_lanes;
  const Lanes<8> Lambda_0_11_p1465_lanes = s19 * Lambda_0_11_p1462_lanes;
  const Lanes<8> Lambda_0_11_p1468_lanes = Lambda_0_11_p1447_lanes + Lambda_0_11_p1465_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_0_11_p1471_lanes = detail::make_lanes<Real>(c13, c20) *
      Lambda_0_11_p1403_lanes;
  const Lanes<2> Lambda_0_11_p1473_lanes = detail::make_lanes<Real>(s13, s20) *
      Lambda_0_11_p1410_lanes;
  const Lanes<2> Lambda_0_11_p1475_lanes = Lambda_0_11_p1471_lanes - Lambda_0_11_p1473_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<8> Lambda_0_11_p1477_lanes = c12 *
      detail::make_lanes<Real>(Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1254_lanes[0],
      Lambda_0_11_p1137_lanes[0], Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1274_lanes[0],
      Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1274_lanes[0], Lambda_0_11_p1274_lanes[0]);
  const Lanes<8> Lambda_0_11_p1480_lanes = s12 * Lambda_0_11_p1218_lanes;
  const Lanes<8> Lambda_0_11_p1483_lanes = Lambda_0_11_p1477_lanes + Lambda_0_11_p1480_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1486_lanes = 0.11533812622014242 *
      detail::make_lanes<Real>(Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0],
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1483_lanes[2], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0]);

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1489 = Lambda_0_11_p1287_lanes[0] + Lambda_0_11_p1295_lanes[0];
  const Real Lambda_0_11_p1490 = Lambda_0_11_p1304_lanes[0] + Lambda_0_11_p1312_lanes[0];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1491_lanes = detail::make_lanes<Real>(Lambda_0_11_p1490,
      Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1490, Lambda_0_11_p1489,
      Lambda_0_11_p1235_lanes[0], Lambda_0_11_p1490, Lambda_0_11_p1490) + Lambda_0_11_p1486_lanes;
  const Real Lambda_0_11_p1494 = 0.11533812622014242 * Lambda_0_11_p1400;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1495 = Lambda_0_11_p1337_lanes[0] - Lambda_0_11_p1335_lanes[0];

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1496 = 0.009919078854932248 * Lambda_0_11_p1495;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1497 = Lambda_0_11_p1340_lanes[0] - Lambda_0_11_p1342_lanes[0];

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1498 = 0.009919078854932248 * Lambda_0_11_p1497;
  const Lanes<8> Lambda_0_11_p1499_lanes = s13 * detail::make_lanes<Real>(Lambda_0_11_p1498,
      Lambda_0_11_p1496, Lambda_0_11_p1494, Lambda_0_11_p1491_lanes[3], Lambda_0_11_p1491_lanes[4],
      Lambda_0_11_p1491_lanes[5], Lambda_0_11_p1498, Lambda_0_11_p1498);
  const Lanes<8> Lambda_0_11_p1505_lanes = detail::make_lanes<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_lanes<Real>(Lambda_0_11_p1497, Lambda_0_11_p1495, Lambda_0_11_p1400,
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1], Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1497, Lambda_0_11_p1497);
  const Lanes<8> Lambda_0_11_p1511_lanes = detail::make_lanes<Real>(-(0.086 *
      Lambda_0_11_p1483_lanes[0]), -(0.086 * Lambda_0_11_p1483_lanes[1]),
      -(0.086 * Lambda_0_11_p1483_lanes[2]), Lambda_0_11_p1497, Lambda_0_11_p1495,
      Lambda_0_11_p1409, -(0.086 * Lambda_0_11_p1483_lanes[0]),
      -(0.086 * Lambda_0_11_p1483_lanes[0])) - Lambda_0_11_p1505_lanes;
  const Lanes<8> Lambda_0_11_p1517_lanes = c13 * Lambda_0_11_p1511_lanes;
  const Lanes<8> Lambda_0_11_p1523_lanes = Lambda_0_11_p1499_lanes + Lambda_0_11_p1517_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1529_lanes = Lambda_0_11_p11_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[2], Lambda_0_11_p1365_lanes[0]);
  const Lanes<2> Lambda_0_11_p1531_lanes = Lambda_0_11_p1475_lanes - Lambda_0_11_p1529_lanes;
  const Lanes<2> Lambda_0_11_p1533_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1531_lanes;
  const Lanes<2> Lambda_0_11_p1535_lanes = Lambda_0_11_p35_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[2], Lambda_0_11_p1365_lanes[0]);
  const Lanes<2> Lambda_0_11_p1537_lanes = detail::make_lanes<Real>(Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1237) - Lambda_0_11_p1535_lanes;
  const Lanes<2> Lambda_0_11_p1539_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p1537_lanes;
  const Lanes<2> Lambda_0_11_p1541_lanes = Lambda_0_11_p1533_lanes - Lambda_0_11_p1539_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1543_lanes = 0.269 *
      detail::make_lanes<Real>(Lambda_0_11_p1541_lanes[1], Lambda_0_11_p1468_lanes[1],
      Lambda_0_11_p1468_lanes[2], Lambda_0_11_p1468_lanes[3], Lambda_0_11_p1541_lanes[1],
      Lambda_0_11_p1541_lanes[1], Lambda_0_11_p1541_lanes[1], Lambda_0_11_p1541_lanes[1]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1547_lanes = inverse_D10_p8_lanes[1] *
      detail::make_lanes<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430, Lambda_0_11_p1429,
      Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);
  const Lanes<8> Lambda_0_11_p1551_lanes = Lambda_0_11_p1543_lanes - Lambda_0_11_p1547_lanes;
  const Lanes<8> Lambda_0_11_p1555_lanes = s18 * Lambda_0_11_p1551_lanes;
  const Lanes<8> Lambda_0_11_p1559_lanes = Lambda_0_11_p1440_lanes - Lambda_0_11_p1555_lanes;
  const Lanes<8> Lambda_0_11_p1563_lanes = s18 * Lambda_0_11_p1436_lanes;
  const Lanes<8> Lambda_0_11_p1567_lanes = c18 * Lambda_0_11_p1551_lanes;
  const Lanes<8> Lambda_0_11_p1571_lanes = Lambda_0_11_p1563_lanes + Lambda_0_11_p1567_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1575_lanes = Lambda_0_11_p231_lanes[1] * Lambda_0_11_p1571_lanes;
  const Lanes<8> Lambda_0_11_p1579_lanes = Lambda_0_11_p1559_lanes - Lambda_0_11_p1575_lanes;
  const Lanes<8> Lambda_0_11_p1583_lanes = c17 * Lambda_0_11_p1579_lanes;
  const Lanes<8> Lambda_0_11_p1587_lanes = Lambda_0_11_p221_lanes[1] * Lambda_0_11_p1571_lanes;
  const Lanes<8> Lambda_0_11_p1591_lanes = s17 * Lambda_0_11_p1587_lanes;
  const Lanes<8> Lambda_0_11_p1595_lanes = Lambda_0_11_p1583_lanes + Lambda_0_11_p1591_lanes;
  const Lanes<8> Lambda_0_11_p1599_lanes = Lambda_0_11_p191_lanes[1] * Lambda_0_11_p1571_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1603_lanes = Lambda_0_11_p55_lanes[1] *
      detail::make_lanes<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430, Lambda_0_11_p1429,
      Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);
  const Lanes<8> Lambda_0_11_p1607_lanes = detail::make_lanes<Real>(-Lambda_0_11_p1541_lanes[1],
      -Lambda_0_11_p1468_lanes[1], -Lambda_0_11_p1468_lanes[2], -Lambda_0_11_p1468_lanes[3],
      -Lambda_0_11_p1541_lanes[1], -Lambda_0_11_p1541_lanes[1], -Lambda_0_11_p1541_lanes[1],
      -Lambda_0_11_p1541_lanes[1]) + Lambda_0_11_p1603_lanes;
  const Lanes<8> Lambda_0_11_p1611_lanes = s18 * Lambda_0_11_p1607_lanes;
  const Lanes<8> Lambda_0_11_p1615_lanes = Lambda_0_11_p119_lanes[1] *
      detail::make_lanes<Real>(Lambda_0_11_p1431, Lambda_0_11_p1430, Lambda_0_11_p1429,
      Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431);
  const Lanes<8> Lambda_0_11_p1619_lanes = Lambda_0_11_p1416_lanes - Lambda_0_11_p1615_lanes;
  const Lanes<8> Lambda_0_11_p1623_lanes = c18 * Lambda_0_11_p1619_lanes;
  const Lanes<8> Lambda_0_11_p1627_lanes = Lambda_0_11_p1611_lanes + Lambda_0_11_p1623_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1631_lanes = Lambda_0_11_p1627_lanes - Lambda_0_11_p1599_lanes;
  const Lanes<8> Lambda_0_11_p1635_lanes = 0.282 * Lambda_0_11_p1631_lanes;
  const Lanes<8> Lambda_0_11_p1639_lanes = Lambda_0_11_p1595_lanes + Lambda_0_11_p1635_lanes;
  const Lanes<8> Lambda_0_11_p1643_lanes = s17 * Lambda_0_11_p1579_lanes;
  const Lanes<8> Lambda_0_11_p1647_lanes = c17 * Lambda_0_11_p1587_lanes;
  const Lanes<8> Lambda_0_11_p1651_lanes = Lambda_0_11_p1647_lanes - Lambda_0_11_p1643_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p1655_lanes = Lambda_0_11_p259_lanes[1] * Lambda_0_11_p1651_lanes;
  const Lanes<8> Lambda_0_11_p1659_lanes = Lambda_0_11_p1639_lanes - Lambda_0_11_p1655_lanes;
  const Lanes<8> Lambda_0_11_p1663_lanes = c16 * Lambda_0_11_p1659_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1667_lanes = Lambda_0_11_p363_lanes[1] * Lambda_0_11_p1571_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1671_lanes = s19 * Lambda_0_11_p1444_lanes;
  const Lanes<8> Lambda_0_11_p1674_lanes = c19 * Lambda_0_11_p1462_lanes;
  const Lanes<8> Lambda_0_11_p1677_lanes = Lambda_0_11_p1671_lanes - Lambda_0_11_p1674_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1680_lanes = c13 * detail::make_lanes<Real>(Lambda_0_11_p1498,
      Lambda_0_11_p1496, Lambda_0_11_p1494, Lambda_0_11_p1491_lanes[3], Lambda_0_11_p1491_lanes[4],
      Lambda_0_11_p1491_lanes[5], Lambda_0_11_p1498, Lambda_0_11_p1498);
  const Lanes<8> Lambda_0_11_p1686_lanes = s13 * Lambda_0_11_p1511_lanes;
  const Lanes<8> Lambda_0_11_p1692_lanes = Lambda_0_11_p1680_lanes - Lambda_0_11_p1686_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1698_lanes = inverse_D11_p1_lanes[0] * Lambda_0_11_p1523_lanes;
  const Lanes<8> Lambda_0_11_p1704_lanes = Lambda_0_11_p1692_lanes - Lambda_0_11_p1698_lanes;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_0_11_p1710 = -(c12 * Lambda_0_11_p1704_lanes[5]);
  const Lanes<2> Lambda_0_11_p1711_lanes = Lambda_0_11_p337_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1710, Lambda_0_11_p1428);

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1713_lanes = Lambda_0_11_p35_lanes[0] * Lambda_0_11_p1523_lanes;
  const Lanes<8> Lambda_0_11_p1716_lanes = s12 * Lambda_0_11_p1713_lanes;
  const Lanes<8> Lambda_0_11_p1719_lanes = Lambda_0_11_p11_lanes[0] * Lambda_0_11_p1523_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1722_lanes = (-3.0523172236718206) *
      detail::make_lanes<Real>(Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0],
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1483_lanes[2], Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[0]);
  const Lanes<2> Lambda_0_11_p1725_lanes = detail::make_lanes<Real>((-0.26249928123577654),
      0.26249928123577654) * detail::make_lanes<Real>(Lambda_0_11_p1495, Lambda_0_11_p1339);
  const Lanes<2> Lambda_0_11_p1727_lanes = detail::make_lanes<Real>(Lambda_0_11_p1489,
      Lambda_0_11_p1297) + Lambda_0_11_p1725_lanes;
  const Lanes<2> Lambda_0_11_p1729_lanes = detail::make_lanes<Real>((-0.26249928123577654),
      0.26249928123577654) * detail::make_lanes<Real>(Lambda_0_11_p1497, Lambda_0_11_p1344);
  const Lanes<2> Lambda_0_11_p1731_lanes = detail::make_lanes<Real>(Lambda_0_11_p1490,
      Lambda_0_11_p1314) + Lambda_0_11_p1729_lanes;
  const Lanes<8> Lambda_0_11_p1733_lanes = c13 *
      detail::make_lanes<Real>(Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1727_lanes[0],
      Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1722_lanes[3], Lambda_0_11_p1722_lanes[4],
      Lambda_0_11_p1722_lanes[5], Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1731_lanes[0]);
  const Lanes<8> Lambda_0_11_p1738_lanes = detail::make_lanes<Real>(0.49024375482668536,
      0.49024375482668536, 0.49024375482668536, 17.32841575379867, 17.32841575379867,
      17.32841575379867, 0.49024375482668536, 0.49024375482668536) *
      detail::make_lanes<Real>(Lambda_0_11_p1497, Lambda_0_11_p1495, Lambda_0_11_p1497,
      Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1], Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1497, Lambda_0_11_p1497);
  const Lanes<8> Lambda_0_11_p1743_lanes = s13 * Lambda_0_11_p1738_lanes;
  const Lanes<8> Lambda_0_11_p1748_lanes = Lambda_0_11_p1733_lanes + Lambda_0_11_p1743_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1753_lanes = Lambda_0_11_p1748_lanes - Lambda_0_11_p1719_lanes;
  const Lanes<8> Lambda_0_11_p1756_lanes = c12 * Lambda_0_11_p1753_lanes;
  const Lanes<8> Lambda_0_11_p1759_lanes = Lambda_0_11_p1716_lanes - Lambda_0_11_p1756_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p1762_lanes = detail::make_lanes<Real>(Lambda_0_11_p1759_lanes[5],
      Lambda_0_11_p1677_lanes[3]) - Lambda_0_11_p1711_lanes;
  const Real Lambda_0_11_p1764 = -(c12 * Lambda_0_11_p1704_lanes[4]);
  const Lanes<2> Lambda_0_11_p1765_lanes = Lambda_0_11_p337_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1764, Lambda_0_11_p1429);
  const Lanes<2> Lambda_0_11_p1767_lanes = detail::make_lanes<Real>(Lambda_0_11_p1759_lanes[4],
      Lambda_0_11_p1677_lanes[2]) - Lambda_0_11_p1765_lanes;
  const Real Lambda_0_11_p1769 = -(c12 * Lambda_0_11_p1704_lanes[3]);
  const Lanes<2> Lambda_0_11_p1770_lanes = Lambda_0_11_p337_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1769, Lambda_0_11_p1430);
  const Lanes<2> Lambda_0_11_p1772_lanes = detail::make_lanes<Real>(Lambda_0_11_p1759_lanes[3],
      Lambda_0_11_p1677_lanes[1]) - Lambda_0_11_p1770_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1774_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p1531_lanes;
  const Lanes<2> Lambda_0_11_p1776_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1537_lanes;
  const Lanes<2> Lambda_0_11_p1778_lanes = Lambda_0_11_p1776_lanes + Lambda_0_11_p1774_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1780_lanes = detail::make_lanes<Real>(-(-Lambda_0_11_p1778_lanes[1] -
      Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431), -Lambda_0_11_p1772_lanes[1],
      -Lambda_0_11_p1767_lanes[1], -Lambda_0_11_p1762_lanes[1],
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431),
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431),
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431),
      -(-Lambda_0_11_p1778_lanes[1] - Lambda_0_11_p337_lanes[1] * Lambda_0_11_p1431)) -
      Lambda_0_11_p1667_lanes;
  const Lanes<8> Lambda_0_11_p1784_lanes = s17 * Lambda_0_11_p1780_lanes;
  const Lanes<8> Lambda_0_11_p1788_lanes = Lambda_0_11_p317_lanes[1] * Lambda_0_11_p1571_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1792_lanes = c18 * Lambda_0_11_p1607_lanes;
  const Lanes<8> Lambda_0_11_p1796_lanes = s18 * Lambda_0_11_p1619_lanes;
  const Lanes<8> Lambda_0_11_p1800_lanes = Lambda_0_11_p1792_lanes - Lambda_0_11_p1796_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1804_lanes = Lambda_0_11_p1800_lanes - Lambda_0_11_p1788_lanes;
  const Lanes<8> Lambda_0_11_p1808_lanes = c17 * Lambda_0_11_p1804_lanes;
  const Lanes<8> Lambda_0_11_p1812_lanes = Lambda_0_11_p1784_lanes - Lambda_0_11_p1808_lanes;
  const Lanes<8> Lambda_0_11_p1816_lanes = 0.282 * Lambda_0_11_p1812_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p1820_lanes = Lambda_0_11_p401_lanes[1] * Lambda_0_11_p1651_lanes;
  const Lanes<8> Lambda_0_11_p1824_lanes = Lambda_0_11_p1816_lanes - Lambda_0_11_p1820_lanes;
  const Lanes<8> Lambda_0_11_p1828_lanes = s16 * Lambda_0_11_p1824_lanes;
  const Lanes<8> Lambda_0_11_p1832_lanes = Lambda_0_11_p1663_lanes - Lambda_0_11_p1828_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p1836_lanes = Lambda_0_11_p555_lanes[1] * Lambda_0_11_p1832_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1840_lanes = s12 * Lambda_0_11_p1704_lanes;
  const Lanes<8> Lambda_0_11_p1846_lanes = Lambda_0_11_p61_lanes[0] * Lambda_0_11_p1523_lanes;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p1852_lanes = s13 *
      detail::make_lanes<Real>(Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1727_lanes[0],
      Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1722_lanes[3], Lambda_0_11_p1722_lanes[4],
      Lambda_0_11_p1722_lanes[5], Lambda_0_11_p1731_lanes[0], Lambda_0_11_p1731_lanes[0]);
  const Lanes<8> Lambda_0_11_p1857_lanes = c13 * Lambda_0_11_p1738_lanes;
  const Lanes<8> Lambda_0_11_p1862_lanes = Lambda_0_11_p1852_lanes - Lambda_0_11_p1857_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1867_lanes = detail::make_lanes<Real>(Lambda_0_11_p1862_lanes[0],
      Lambda_0_11_p1862_lanes[1], Lambda_0_11_p1414_lanes[0], Lambda_0_11_p1862_lanes[3],
      Lambda_0_11_p1862_lanes[4], Lambda_0_11_p1862_lanes[5], Lambda_0_11_p1862_lanes[0],
      Lambda_0_11_p1862_lanes[0]) - Lambda_0_11_p1846_lanes;
  const Lanes<8> Lambda_0_11_p1873_lanes = 0.269 * Lambda_0_11_p1867_lanes;
  const Lanes<8> Lambda_0_11_p1879_lanes = Lambda_0_11_p1873_lanes - Lambda_0_11_p1840_lanes;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_0_11_p1885 = -(c12 * Lambda_0_11_p1704_lanes[2]);
  const Real Lambda_0_11_p1886 = -(c12 * Lambda_0_11_p1704_lanes[1]);
  const Real Lambda_0_11_p1887 = -(c12 * Lambda_0_11_p1704_lanes[0]);
  const Lanes<8> Lambda_0_11_p1888_lanes = inverse_D10_p1_lanes[0] *
      detail::make_lanes<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886, Lambda_0_11_p1885,
      Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);
  const Lanes<8> Lambda_0_11_p1894_lanes = Lambda_0_11_p1879_lanes - Lambda_0_11_p1888_lanes;
  const Lanes<8> Lambda_0_11_p1900_lanes = s11 * Lambda_0_11_p1894_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p1906_lanes = c12 * Lambda_0_11_p1713_lanes;
  const Lanes<8> Lambda_0_11_p1909_lanes = s12 * Lambda_0_11_p1753_lanes;
  const Lanes<8> Lambda_0_11_p1912_lanes = Lambda_0_11_p1906_lanes + Lambda_0_11_p1909_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1915 = 0.49024375482668536 * Lambda_0_11_p1339;
  const Real Lambda_0_11_p1916 = -(0.086 * Lambda_0_11_p1257) - (-0.004018575007348824) *
      Lambda_0_11_p1339;
  const Real Lambda_0_11_p1917 = 0.009919078854932248 * Lambda_0_11_p1339;
  const Real Lambda_0_11_p1918 = s20 * Lambda_0_11_p1917 + c20 * Lambda_0_11_p1916;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1919_lanes = Lambda_0_11_p11_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[1], Lambda_0_11_p1918);
  const Lanes<2> Lambda_0_11_p1921_lanes = detail::make_lanes<Real>(Lambda_0_11_p1748_lanes[1],
      c20 * Lambda_0_11_p1727_lanes[1] + s20 * Lambda_0_11_p1915) - Lambda_0_11_p1919_lanes;
  const Lanes<2> Lambda_0_11_p1923_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1921_lanes;
  const Lanes<2> Lambda_0_11_p1925_lanes = Lambda_0_11_p35_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[1], Lambda_0_11_p1918);
  const Lanes<2> Lambda_0_11_p1927_lanes = detail::make_lanes<Real>(Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1257) - Lambda_0_11_p1925_lanes;
  const Lanes<2> Lambda_0_11_p1929_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p1927_lanes;
  const Lanes<2> Lambda_0_11_p1931_lanes = Lambda_0_11_p1923_lanes - Lambda_0_11_p1929_lanes;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1933 = 0.49024375482668536 * Lambda_0_11_p1344;
  const Real Lambda_0_11_p1934 = 0.009919078854932248 * Lambda_0_11_p1344;
  const Real Lambda_0_11_p1935 = -(0.086 * Lambda_0_11_p1277) - (-0.004018575007348824) *
      Lambda_0_11_p1344;
  const Real Lambda_0_11_p1936 = s20 * Lambda_0_11_p1934 + c20 * Lambda_0_11_p1935;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p1937_lanes = Lambda_0_11_p11_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[0], Lambda_0_11_p1936);
  const Lanes<2> Lambda_0_11_p1939_lanes = detail::make_lanes<Real>(Lambda_0_11_p1748_lanes[0],
      c20 * Lambda_0_11_p1731_lanes[1] + s20 * Lambda_0_11_p1933) - Lambda_0_11_p1937_lanes;
  const Lanes<2> Lambda_0_11_p1941_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1939_lanes;
  const Lanes<2> Lambda_0_11_p1943_lanes = Lambda_0_11_p35_lanes *
      detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[0], Lambda_0_11_p1936);
  const Lanes<2> Lambda_0_11_p1945_lanes = detail::make_lanes<Real>(Lambda_0_11_p1483_lanes[0],
      Lambda_0_11_p1277) - Lambda_0_11_p1943_lanes;
  const Lanes<2> Lambda_0_11_p1947_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p1945_lanes;
  const Lanes<2> Lambda_0_11_p1949_lanes = Lambda_0_11_p1941_lanes - Lambda_0_11_p1947_lanes;
  const Lanes<8> Lambda_0_11_p1951_lanes = 0.269 *
      detail::make_lanes<Real>(Lambda_0_11_p1949_lanes[0], Lambda_0_11_p1931_lanes[0],
      Lambda_0_11_p1541_lanes[0], Lambda_0_11_p1912_lanes[3], Lambda_0_11_p1912_lanes[4],
      Lambda_0_11_p1912_lanes[5], Lambda_0_11_p1949_lanes[0], Lambda_0_11_p1949_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1957_lanes = inverse_D10_p8_lanes[0] *
      detail::make_lanes<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886, Lambda_0_11_p1885,
      Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);
  const Lanes<8> Lambda_0_11_p1963_lanes = Lambda_0_11_p1951_lanes - Lambda_0_11_p1957_lanes;
  const Lanes<8> Lambda_0_11_p1969_lanes = c11 * Lambda_0_11_p1963_lanes;
  const Lanes<8> Lambda_0_11_p1975_lanes = Lambda_0_11_p1900_lanes + Lambda_0_11_p1969_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p1981_lanes = Lambda_0_11_p317_lanes[0] * Lambda_0_11_p1975_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p1987_lanes = Lambda_0_11_p55_lanes[0] *
      detail::make_lanes<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886, Lambda_0_11_p1885,
      Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);
  const Lanes<8> Lambda_0_11_p1993_lanes = detail::make_lanes<Real>(-Lambda_0_11_p1949_lanes[0],
      -Lambda_0_11_p1931_lanes[0], -Lambda_0_11_p1541_lanes[0], -Lambda_0_11_p1912_lanes[3],
      -Lambda_0_11_p1912_lanes[4], -Lambda_0_11_p1912_lanes[5], -Lambda_0_11_p1949_lanes[0],
      -Lambda_0_11_p1949_lanes[0]) + Lambda_0_11_p1987_lanes;
  const Lanes<8> Lambda_0_11_p1999_lanes = c11 * Lambda_0_11_p1993_lanes;
  const Lanes<8> Lambda_0_11_p2005_lanes = Lambda_0_11_p119_lanes[0] *
      detail::make_lanes<Real>(Lambda_0_11_p1887, Lambda_0_11_p1886, Lambda_0_11_p1885,
      Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710, Lambda_0_11_p1887,
      Lambda_0_11_p1887);
  const Lanes<8> Lambda_0_11_p2011_lanes = Lambda_0_11_p1867_lanes - Lambda_0_11_p2005_lanes;
  const Lanes<8> Lambda_0_11_p2017_lanes = s11 * Lambda_0_11_p2011_lanes;
  const Lanes<8> Lambda_0_11_p2023_lanes = Lambda_0_11_p1999_lanes - Lambda_0_11_p2017_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2029_lanes = Lambda_0_11_p2023_lanes - Lambda_0_11_p1981_lanes;
  const Lanes<2> Lambda_0_11_p2035_lanes = detail::make_lanes<Real>(s10, s17) *
      detail::make_lanes<Real>(Lambda_0_11_p2029_lanes[5], Lambda_0_11_p1804_lanes[3]);
  const Lanes<8> Lambda_0_11_p2037_lanes = Lambda_0_11_p363_lanes[0] * Lambda_0_11_p1975_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p2043_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p1921_lanes;
  const Lanes<2> Lambda_0_11_p2045_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1927_lanes;
  const Lanes<2> Lambda_0_11_p2047_lanes = Lambda_0_11_p2045_lanes + Lambda_0_11_p2043_lanes;
  const Lanes<2> Lambda_0_11_p2049_lanes = detail::make_lanes<Real>(c12, c19) *
      Lambda_0_11_p1939_lanes;
  const Lanes<2> Lambda_0_11_p2051_lanes = detail::make_lanes<Real>(s12, s19) *
      Lambda_0_11_p1945_lanes;
  const Lanes<2> Lambda_0_11_p2053_lanes = Lambda_0_11_p2051_lanes + Lambda_0_11_p2049_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2055_lanes = detail::make_lanes<Real>(-(-Lambda_0_11_p2053_lanes[0] -
      Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1887),
      -(-Lambda_0_11_p2047_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1886),
      -(-Lambda_0_11_p1778_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1885),
      -Lambda_0_11_p1772_lanes[0], -Lambda_0_11_p1767_lanes[0], -Lambda_0_11_p1762_lanes[0],
      -(-Lambda_0_11_p2053_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1887),
      -(-Lambda_0_11_p2053_lanes[0] - Lambda_0_11_p337_lanes[0] * Lambda_0_11_p1887)) -
      Lambda_0_11_p2037_lanes;
  const Lanes<2> Lambda_0_11_p2061_lanes = detail::make_lanes<Real>(c10, c17) *
      detail::make_lanes<Real>(Lambda_0_11_p2055_lanes[5], Lambda_0_11_p1780_lanes[3]);
  const Lanes<2> Lambda_0_11_p2063_lanes = Lambda_0_11_p2035_lanes + Lambda_0_11_p2061_lanes;
  const Lanes<2> Lambda_0_11_p2065_lanes = detail::make_lanes<Real>(s10, s17) *
      detail::make_lanes<Real>(Lambda_0_11_p2029_lanes[4], Lambda_0_11_p1804_lanes[2]);
  const Lanes<2> Lambda_0_11_p2067_lanes = detail::make_lanes<Real>(c10, c17) *
      detail::make_lanes<Real>(Lambda_0_11_p2055_lanes[4], Lambda_0_11_p1780_lanes[2]);
  const Lanes<2> Lambda_0_11_p2069_lanes = Lambda_0_11_p2065_lanes + Lambda_0_11_p2067_lanes;
  const Lanes<2> Lambda_0_11_p2071_lanes = detail::make_lanes<Real>(s10, s17) *
      detail::make_lanes<Real>(Lambda_0_11_p2029_lanes[3], Lambda_0_11_p1804_lanes[1]);
  const Lanes<2> Lambda_0_11_p2073_lanes = detail::make_lanes<Real>(c10, c17) *
      detail::make_lanes<Real>(Lambda_0_11_p2055_lanes[3], Lambda_0_11_p1780_lanes[1]);
  const Lanes<2> Lambda_0_11_p2075_lanes = Lambda_0_11_p2071_lanes + Lambda_0_11_p2073_lanes;
  const Lanes<2> Lambda_0_11_p2077_lanes = detail::make_lanes<Real>(s10, s17) *
      detail::make_lanes<Real>(Lambda_0_11_p2029_lanes[2], Lambda_0_11_p1804_lanes[0]);
  const Lanes<2> Lambda_0_11_p2079_lanes = detail::make_lanes<Real>(c10, c17) *
      detail::make_lanes<Real>(Lambda_0_11_p2055_lanes[2], Lambda_0_11_p1780_lanes[0]);
  const Lanes<2> Lambda_0_11_p2081_lanes = Lambda_0_11_p2077_lanes + Lambda_0_11_p2079_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2083_lanes = detail::make_lanes<Real>(-(-Lambda_0_11_p2081_lanes[1] +
      Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2075_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[1]),
      -(-Lambda_0_11_p2069_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[2]),
      -(-Lambda_0_11_p2063_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[3]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0]),
      -(-Lambda_0_11_p2081_lanes[1] + Lambda_0_11_p515_lanes[1] * Lambda_0_11_p1651_lanes[0])) +
      Lambda_0_11_p1836_lanes;
  const Lanes<8> Lambda_0_11_p2087_lanes = s15 * Lambda_0_11_p2083_lanes;
  const Lanes<8> Lambda_0_11_p2091_lanes = Lambda_0_11_p609_lanes[1] * Lambda_0_11_p1832_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2095_lanes = Lambda_0_11_p569_lanes[1] * Lambda_0_11_p1651_lanes;
  const Lanes<8> Lambda_0_11_p2099_lanes = detail::make_lanes<Real>(-Lambda_0_11_p1812_lanes[0],
      -Lambda_0_11_p1812_lanes[1], -Lambda_0_11_p1812_lanes[2], -Lambda_0_11_p1812_lanes[3],
      -Lambda_0_11_p1812_lanes[0], -Lambda_0_11_p1812_lanes[0], -Lambda_0_11_p1812_lanes[0],
      -Lambda_0_11_p1812_lanes[0]) + Lambda_0_11_p2095_lanes;
  const Lanes<8> Lambda_0_11_p2103_lanes = s16 * Lambda_0_11_p2099_lanes;
  const Lanes<8> Lambda_0_11_p2107_lanes = Lambda_0_11_p577_lanes[1] * Lambda_0_11_p1651_lanes;
  const Lanes<8> Lambda_0_11_p2111_lanes = Lambda_0_11_p1631_lanes - Lambda_0_11_p2107_lanes;
  const Lanes<8> Lambda_0_11_p2115_lanes = c16 * Lambda_0_11_p2111_lanes;
  const Lanes<8> Lambda_0_11_p2119_lanes = Lambda_0_11_p2103_lanes + Lambda_0_11_p2115_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2123_lanes = Lambda_0_11_p2119_lanes - Lambda_0_11_p2091_lanes;
  const Lanes<8> Lambda_0_11_p2127_lanes = c15 * Lambda_0_11_p2123_lanes;
  const Lanes<8> Lambda_0_11_p2131_lanes = Lambda_0_11_p2087_lanes + Lambda_0_11_p2127_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2135_lanes = s16 * Lambda_0_11_p1659_lanes;
  const Lanes<8> Lambda_0_11_p2139_lanes = c16 * Lambda_0_11_p1824_lanes;
  const Lanes<8> Lambda_0_11_p2143_lanes = Lambda_0_11_p2135_lanes + Lambda_0_11_p2139_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2147_lanes = inverse_D7_p1_lanes[1] * Lambda_0_11_p1832_lanes;
  const Lanes<8> Lambda_0_11_p2151_lanes = Lambda_0_11_p2143_lanes - Lambda_0_11_p2147_lanes;
  const Lanes<8> Lambda_0_11_p2155_lanes = c15 * Lambda_0_11_p2151_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Lanes<2> Lambda_0_11_p2159_lanes = 0.00010499999999999999 / inverse_D8_p3_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2161_lanes = Lambda_0_11_p2159_lanes[1] * Lambda_0_11_p1832_lanes;
  const Lanes<8> Lambda_0_11_p2165_lanes = s15 * Lambda_0_11_p2161_lanes;
  const Lanes<8> Lambda_0_11_p2169_lanes = Lambda_0_11_p2165_lanes + Lambda_0_11_p2155_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2173_lanes = Lambda_0_11_p837_lanes[1] * Lambda_0_11_p2169_lanes;
  const Lanes<8> Lambda_0_11_p2177_lanes = Lambda_0_11_p2131_lanes - Lambda_0_11_p2173_lanes;

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

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p2223_lanes = c11 * Lambda_0_11_p1894_lanes;
  const Lanes<8> Lambda_0_11_p2229_lanes = s11 * Lambda_0_11_p1963_lanes;
  const Lanes<8> Lambda_0_11_p2235_lanes = Lambda_0_11_p2223_lanes - Lambda_0_11_p2229_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2241_lanes = Lambda_0_11_p231_lanes[0] * Lambda_0_11_p1975_lanes;
  const Lanes<8> Lambda_0_11_p2247_lanes = Lambda_0_11_p2235_lanes - Lambda_0_11_p2241_lanes;
  const Lanes<8> Lambda_0_11_p2253_lanes = c10 * Lambda_0_11_p2247_lanes;
  const Lanes<8> Lambda_0_11_p2259_lanes = Lambda_0_11_p221_lanes[0] * Lambda_0_11_p1975_lanes;
  const Lanes<8> Lambda_0_11_p2265_lanes = s10 * Lambda_0_11_p2259_lanes;
  const Lanes<8> Lambda_0_11_p2271_lanes = Lambda_0_11_p2253_lanes + Lambda_0_11_p2265_lanes;
  const Lanes<8> Lambda_0_11_p2277_lanes = Lambda_0_11_p191_lanes[0] * Lambda_0_11_p1975_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p2283_lanes = s11 * Lambda_0_11_p1993_lanes;
  const Lanes<8> Lambda_0_11_p2289_lanes = c11 * Lambda_0_11_p2011_lanes;
  const Lanes<8> Lambda_0_11_p2295_lanes = Lambda_0_11_p2283_lanes + Lambda_0_11_p2289_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2301_lanes = Lambda_0_11_p2295_lanes - Lambda_0_11_p2277_lanes;
  const Lanes<8> Lambda_0_11_p2307_lanes = 0.282 * Lambda_0_11_p2301_lanes;
  const Lanes<8> Lambda_0_11_p2313_lanes = Lambda_0_11_p2271_lanes + Lambda_0_11_p2307_lanes;
  const Lanes<8> Lambda_0_11_p2319_lanes = s10 * Lambda_0_11_p2247_lanes;
  const Lanes<8> Lambda_0_11_p2325_lanes = c10 * Lambda_0_11_p2259_lanes;
  const Lanes<8> Lambda_0_11_p2331_lanes = Lambda_0_11_p2325_lanes - Lambda_0_11_p2319_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2337_lanes = Lambda_0_11_p259_lanes[0] * Lambda_0_11_p2331_lanes;
  const Lanes<8> Lambda_0_11_p2343_lanes = Lambda_0_11_p2313_lanes - Lambda_0_11_p2337_lanes;
  const Lanes<8> Lambda_0_11_p2349_lanes = s9 * Lambda_0_11_p2343_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p2355_lanes = s10 * Lambda_0_11_p2055_lanes;
  const Lanes<8> Lambda_0_11_p2361_lanes = c10 * Lambda_0_11_p2029_lanes;
  const Lanes<8> Lambda_0_11_p2367_lanes = Lambda_0_11_p2355_lanes - Lambda_0_11_p2361_lanes;
  const Lanes<8> Lambda_0_11_p2373_lanes = 0.282 * Lambda_0_11_p2367_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2379_lanes = Lambda_0_11_p401_lanes[0] * Lambda_0_11_p2331_lanes;
  const Lanes<8> Lambda_0_11_p2385_lanes = Lambda_0_11_p2373_lanes - Lambda_0_11_p2379_lanes;
  const Lanes<8> Lambda_0_11_p2391_lanes = c9 * Lambda_0_11_p2385_lanes;
  const Lanes<8> Lambda_0_11_p2397_lanes = Lambda_0_11_p2349_lanes + Lambda_0_11_p2391_lanes;
  const Lanes<8> Lambda_0_11_p2403_lanes = c9 * Lambda_0_11_p2343_lanes;
  const Lanes<8> Lambda_0_11_p2409_lanes = s9 * Lambda_0_11_p2385_lanes;
  const Lanes<8> Lambda_0_11_p2415_lanes = Lambda_0_11_p2403_lanes - Lambda_0_11_p2409_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2421_lanes = inverse_D7_p1_lanes[0] * Lambda_0_11_p2415_lanes;
  const Lanes<8> Lambda_0_11_p2427_lanes = Lambda_0_11_p2397_lanes - Lambda_0_11_p2421_lanes;
  const Lanes<8> Lambda_0_11_p2433_lanes = c8 * Lambda_0_11_p2427_lanes;
  const Lanes<8> Lambda_0_11_p2439_lanes = Lambda_0_11_p2159_lanes[0] * Lambda_0_11_p2415_lanes;
  const Lanes<8> Lambda_0_11_p2445_lanes = s8 * Lambda_0_11_p2439_lanes;
  const Lanes<8> Lambda_0_11_p2451_lanes = Lambda_0_11_p2445_lanes + Lambda_0_11_p2433_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2457_lanes = detail::make_lanes<Real>(Lambda_0_11_p837_lanes[0],
      Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0],
      Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[0], Lambda_0_11_p837_lanes[1],
      Lambda_0_11_p837_lanes[1]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[0],
      Lambda_0_11_p2451_lanes[1], Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3],
      Lambda_0_11_p2451_lanes[4], Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p2465_lanes = detail::make_lanes<Real>(s10, s17) *
      detail::make_lanes<Real>(Lambda_0_11_p2029_lanes[1], Lambda_0_11_p2194);
  const Lanes<2> Lambda_0_11_p2467_lanes = detail::make_lanes<Real>(c10, c17) *
      detail::make_lanes<Real>(Lambda_0_11_p2055_lanes[1], Lambda_0_11_p2195);
  const Lanes<2> Lambda_0_11_p2469_lanes = Lambda_0_11_p2465_lanes + Lambda_0_11_p2467_lanes;

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
  const Lanes<2> Lambda_0_11_p2478_lanes = detail::make_lanes<Real>(s10, s17) *
      detail::make_lanes<Real>(Lambda_0_11_p2029_lanes[0], Lambda_0_11_p2215);
  const Lanes<2> Lambda_0_11_p2480_lanes = detail::make_lanes<Real>(c10, c17) *
      detail::make_lanes<Real>(Lambda_0_11_p2055_lanes[0], Lambda_0_11_p2216);
  const Lanes<2> Lambda_0_11_p2482_lanes = Lambda_0_11_p2478_lanes + Lambda_0_11_p2480_lanes;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2484 = -(-Lambda_0_11_p2482_lanes[1] + Lambda_0_11_p515_lanes[1] *
      Lambda_0_11_p2213) + Lambda_0_11_p555_lanes[1] * Lambda_0_11_p2219;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2485_lanes = Lambda_0_11_p555_lanes[0] * Lambda_0_11_p2415_lanes;
  const Lanes<8> Lambda_0_11_p2491_lanes = detail::make_lanes<Real>(-(-Lambda_0_11_p2482_lanes[0] +
      Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[0]),
      -(-Lambda_0_11_p2469_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[1]),
      -(-Lambda_0_11_p2081_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[2]),
      -(-Lambda_0_11_p2075_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[3]),
      -(-Lambda_0_11_p2069_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[4]),
      -(-Lambda_0_11_p2063_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[5]),
      -(-Lambda_0_11_p2482_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[0]),
      -(-Lambda_0_11_p2482_lanes[0] + Lambda_0_11_p515_lanes[0] * Lambda_0_11_p2331_lanes[0])) +
      Lambda_0_11_p2485_lanes;
  const Lanes<8> Lambda_0_11_p2497_lanes = s8 * Lambda_0_11_p2491_lanes;
  const Lanes<8> Lambda_0_11_p2503_lanes = Lambda_0_11_p609_lanes[0] * Lambda_0_11_p2415_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2509_lanes = Lambda_0_11_p569_lanes[0] * Lambda_0_11_p2331_lanes;
  const Lanes<8> Lambda_0_11_p2515_lanes = detail::make_lanes<Real>(-Lambda_0_11_p2367_lanes[0],
      -Lambda_0_11_p2367_lanes[1], -Lambda_0_11_p2367_lanes[2], -Lambda_0_11_p2367_lanes[3],
      -Lambda_0_11_p2367_lanes[4], -Lambda_0_11_p2367_lanes[5], -Lambda_0_11_p2367_lanes[0],
      -Lambda_0_11_p2367_lanes[0]) + Lambda_0_11_p2509_lanes;
  const Lanes<8> Lambda_0_11_p2521_lanes = s9 * Lambda_0_11_p2515_lanes;
  const Lanes<8> Lambda_0_11_p2527_lanes = Lambda_0_11_p577_lanes[0] * Lambda_0_11_p2331_lanes;
  const Lanes<8> Lambda_0_11_p2533_lanes = Lambda_0_11_p2301_lanes - Lambda_0_11_p2527_lanes;
  const Lanes<8> Lambda_0_11_p2539_lanes = c9 * Lambda_0_11_p2533_lanes;
  const Lanes<8> Lambda_0_11_p2545_lanes = Lambda_0_11_p2521_lanes + Lambda_0_11_p2539_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2551_lanes = Lambda_0_11_p2545_lanes - Lambda_0_11_p2503_lanes;
  const Lanes<8> Lambda_0_11_p2557_lanes = c8 * Lambda_0_11_p2551_lanes;
  const Lanes<8> Lambda_0_11_p2563_lanes = Lambda_0_11_p2497_lanes + Lambda_0_11_p2557_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2569_lanes = detail::make_lanes<Real>(Lambda_0_11_p2563_lanes[0],
      Lambda_0_11_p2563_lanes[1], Lambda_0_11_p2563_lanes[2], Lambda_0_11_p2563_lanes[3],
      Lambda_0_11_p2563_lanes[4], Lambda_0_11_p2563_lanes[5], s15 * Lambda_0_11_p2484 + c15 *
      Lambda_0_11_p2477, s15 * Lambda_0_11_p2471 + c15 * Lambda_0_11_p2474) -
      Lambda_0_11_p2457_lanes;
  const Lanes<2> Lambda_0_11_p2577_lanes = 0.226 *
      detail::make_lanes<Real>(Lambda_0_11_p2569_lanes[5], Lambda_0_11_p2177_lanes[3]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2579_lanes = c15 * Lambda_0_11_p2083_lanes;
  const Lanes<8> Lambda_0_11_p2583_lanes = s15 * Lambda_0_11_p2123_lanes;
  const Lanes<8> Lambda_0_11_p2587_lanes = Lambda_0_11_p2579_lanes - Lambda_0_11_p2583_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2591_lanes = Lambda_0_11_p639_lanes[1] * Lambda_0_11_p2169_lanes;
  const Lanes<8> Lambda_0_11_p2595_lanes = Lambda_0_11_p2587_lanes - Lambda_0_11_p2591_lanes;
  const Lanes<8> Lambda_0_11_p2599_lanes = c14 * Lambda_0_11_p2595_lanes;
  const Lanes<8> Lambda_0_11_p2603_lanes = Lambda_0_11_p679_lanes[1] * Lambda_0_11_p2169_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2607_lanes = Lambda_0_11_p657_lanes[1] * Lambda_0_11_p1832_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2611_lanes = c16 * Lambda_0_11_p2099_lanes;
  const Lanes<8> Lambda_0_11_p2615_lanes = s16 * Lambda_0_11_p2111_lanes;
  const Lanes<8> Lambda_0_11_p2619_lanes = Lambda_0_11_p2611_lanes - Lambda_0_11_p2615_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2623_lanes = Lambda_0_11_p2619_lanes - Lambda_0_11_p2607_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2627_lanes = Lambda_0_11_p2623_lanes - Lambda_0_11_p2603_lanes;
  const Lanes<8> Lambda_0_11_p2631_lanes = s14 * Lambda_0_11_p2627_lanes;
  const Lanes<8> Lambda_0_11_p2635_lanes = Lambda_0_11_p2631_lanes + Lambda_0_11_p2599_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2639_lanes = detail::make_lanes<Real>(Lambda_0_11_p679_lanes[0],
      Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0],
      Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[0], Lambda_0_11_p679_lanes[1],
      Lambda_0_11_p679_lanes[1]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[0],
      Lambda_0_11_p2451_lanes[1], Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3],
      Lambda_0_11_p2451_lanes[4], Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2647_lanes = Lambda_0_11_p657_lanes[0] * Lambda_0_11_p2415_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p2653_lanes = c9 * Lambda_0_11_p2515_lanes;
  const Lanes<8> Lambda_0_11_p2659_lanes = s9 * Lambda_0_11_p2533_lanes;
  const Lanes<8> Lambda_0_11_p2665_lanes = Lambda_0_11_p2653_lanes - Lambda_0_11_p2659_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2671_lanes = Lambda_0_11_p2665_lanes - Lambda_0_11_p2647_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2677_lanes = detail::make_lanes<Real>(Lambda_0_11_p2671_lanes[0],
      Lambda_0_11_p2671_lanes[1], Lambda_0_11_p2671_lanes[2], Lambda_0_11_p2671_lanes[3],
      Lambda_0_11_p2671_lanes[4], Lambda_0_11_p2671_lanes[5], c16 * Lambda_0_11_p2475 - s16 *
      Lambda_0_11_p2476 - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p2219, c16 * Lambda_0_11_p2472 -
      s16 * Lambda_0_11_p2473 - Lambda_0_11_p657_lanes[1] * Lambda_0_11_p2198) -
      Lambda_0_11_p2639_lanes;
  const Lanes<8> Lambda_0_11_p2685_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_0_11_p2677_lanes;
  const Lanes<8> Lambda_0_11_p2693_lanes = detail::make_lanes<Real>(Lambda_0_11_p639_lanes[0],
      Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0],
      Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[0], Lambda_0_11_p639_lanes[1],
      Lambda_0_11_p639_lanes[1]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[0],
      Lambda_0_11_p2451_lanes[1], Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3],
      Lambda_0_11_p2451_lanes[4], Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2701_lanes = c8 * Lambda_0_11_p2491_lanes;
  const Lanes<8> Lambda_0_11_p2707_lanes = s8 * Lambda_0_11_p2551_lanes;
  const Lanes<8> Lambda_0_11_p2713_lanes = Lambda_0_11_p2701_lanes - Lambda_0_11_p2707_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2719_lanes = detail::make_lanes<Real>(Lambda_0_11_p2713_lanes[0],
      Lambda_0_11_p2713_lanes[1], Lambda_0_11_p2713_lanes[2], Lambda_0_11_p2713_lanes[3],
      Lambda_0_11_p2713_lanes[4], Lambda_0_11_p2713_lanes[5], c15 * Lambda_0_11_p2484 - s15 *
      Lambda_0_11_p2477, c15 * Lambda_0_11_p2471 - s15 * Lambda_0_11_p2474) -
      Lambda_0_11_p2693_lanes;
  const Lanes<8> Lambda_0_11_p2727_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_0_11_p2719_lanes;
  const Lanes<8> Lambda_0_11_p2735_lanes = Lambda_0_11_p2685_lanes + Lambda_0_11_p2727_lanes;
  const Lanes<2> Lambda_0_11_p2743_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      detail::make_lanes<Real>(Lambda_0_11_p2735_lanes[5], Lambda_0_11_p2635_lanes[3]);
  const Lanes<2> Lambda_0_11_p2745_lanes = Lambda_0_11_p2577_lanes + Lambda_0_11_p2743_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2747_lanes = s15 * Lambda_0_11_p2151_lanes;
  const Lanes<8> Lambda_0_11_p2751_lanes = c15 * Lambda_0_11_p2161_lanes;
  const Lanes<8> Lambda_0_11_p2755_lanes = Lambda_0_11_p2751_lanes - Lambda_0_11_p2747_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2759_lanes = inverse_D6_p5_lanes[1] * Lambda_0_11_p2169_lanes;
  const Lanes<8> Lambda_0_11_p2763_lanes = Lambda_0_11_p2755_lanes - Lambda_0_11_p2759_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2767_lanes = detail::make_lanes<Real>(inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0],
      inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[0], inverse_D6_p5_lanes[1],
      inverse_D6_p5_lanes[1]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[0],
      Lambda_0_11_p2451_lanes[1], Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3],
      Lambda_0_11_p2451_lanes[4], Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p2775_lanes = s8 * Lambda_0_11_p2427_lanes;
  const Lanes<8> Lambda_0_11_p2781_lanes = c8 * Lambda_0_11_p2439_lanes;
  const Lanes<8> Lambda_0_11_p2787_lanes = Lambda_0_11_p2781_lanes - Lambda_0_11_p2775_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2793_lanes = detail::make_lanes<Real>(Lambda_0_11_p2787_lanes[0],
      Lambda_0_11_p2787_lanes[1], Lambda_0_11_p2787_lanes[2], Lambda_0_11_p2787_lanes[3],
      Lambda_0_11_p2787_lanes[4], Lambda_0_11_p2787_lanes[5], c15 * Lambda_0_11_p2221 - s15 *
      Lambda_0_11_p2220, c15 * Lambda_0_11_p2199 - s15 * Lambda_0_11_p2200) -
      Lambda_0_11_p2767_lanes;
  const Lanes<2> Lambda_0_11_p2801_lanes = detail::make_lanes<Real>(s7, s14) *
      detail::make_lanes<Real>(Lambda_0_11_p2793_lanes[5], Lambda_0_11_p2763_lanes[3]);

  // link 7 (left_shoulder1), articulated inertia
  const Lanes<2> Lambda_0_11_p2803_lanes = detail::make_lanes<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / inverse_D7_p17_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2805_lanes = Lambda_0_11_p2803_lanes[1] * Lambda_0_11_p2169_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2809_lanes = detail::make_lanes<Real>(Lambda_0_11_p2803_lanes[0],
      Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[0],
      Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[0], Lambda_0_11_p2803_lanes[1],
      Lambda_0_11_p2803_lanes[1]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[0],
      Lambda_0_11_p2451_lanes[1], Lambda_0_11_p2451_lanes[2], Lambda_0_11_p2451_lanes[3],
      Lambda_0_11_p2451_lanes[4], Lambda_0_11_p2451_lanes[5], Lambda_0_11_p2222, Lambda_0_11_p2201);
  const Lanes<2> Lambda_0_11_p2817_lanes = detail::make_lanes<Real>(c7, c14) *
      detail::make_lanes<Real>(Lambda_0_11_p2809_lanes[5], Lambda_0_11_p2805_lanes[3]);
  const Lanes<2> Lambda_0_11_p2819_lanes = Lambda_0_11_p2817_lanes + Lambda_0_11_p2801_lanes;
  const Lanes<2> Lambda_0_11_p2821_lanes = Lambda_0_11_p2819_lanes + Lambda_0_11_p2745_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2823 = -Lambda_0_11_p2821_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p2824_lanes = detail::make_lanes<Real>(c7, c14) *
      detail::make_lanes<Real>(Lambda_0_11_p2809_lanes[4], Lambda_0_11_p2805_lanes[2]);
  const Lanes<2> Lambda_0_11_p2826_lanes = detail::make_lanes<Real>(s7, s14) *
      detail::make_lanes<Real>(Lambda_0_11_p2793_lanes[4], Lambda_0_11_p2763_lanes[2]);
  const Lanes<2> Lambda_0_11_p2828_lanes = Lambda_0_11_p2824_lanes + Lambda_0_11_p2826_lanes;
  const Lanes<2> Lambda_0_11_p2830_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      detail::make_lanes<Real>(Lambda_0_11_p2735_lanes[4], Lambda_0_11_p2635_lanes[2]);
  const Lanes<2> Lambda_0_11_p2832_lanes = 0.226 *
      detail::make_lanes<Real>(Lambda_0_11_p2569_lanes[4], Lambda_0_11_p2177_lanes[2]);
  const Lanes<2> Lambda_0_11_p2834_lanes = Lambda_0_11_p2832_lanes + Lambda_0_11_p2830_lanes;
  const Lanes<2> Lambda_0_11_p2836_lanes = Lambda_0_11_p2828_lanes + Lambda_0_11_p2834_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2838 = -Lambda_0_11_p2836_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p2839_lanes = 0.226 *
      detail::make_lanes<Real>(Lambda_0_11_p2569_lanes[3], Lambda_0_11_p2177_lanes[1]);
  const Lanes<2> Lambda_0_11_p2841_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      detail::make_lanes<Real>(Lambda_0_11_p2735_lanes[3], Lambda_0_11_p2635_lanes[1]);
  const Lanes<2> Lambda_0_11_p2843_lanes = Lambda_0_11_p2839_lanes + Lambda_0_11_p2841_lanes;
  const Lanes<2> Lambda_0_11_p2845_lanes = detail::make_lanes<Real>(s7, s14) *
      detail::make_lanes<Real>(Lambda_0_11_p2793_lanes[3], Lambda_0_11_p2763_lanes[1]);
  const Lanes<2> Lambda_0_11_p2847_lanes = detail::make_lanes<Real>(c7, c14) *
      detail::make_lanes<Real>(Lambda_0_11_p2809_lanes[3], Lambda_0_11_p2805_lanes[1]);
  const Lanes<2> Lambda_0_11_p2849_lanes = Lambda_0_11_p2847_lanes + Lambda_0_11_p2845_lanes;
  const Lanes<2> Lambda_0_11_p2851_lanes = Lambda_0_11_p2849_lanes + Lambda_0_11_p2843_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2853 = -Lambda_0_11_p2851_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p2854_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      detail::make_lanes<Real>(Lambda_0_11_p2735_lanes[2], Lambda_0_11_p2635_lanes[0]);
  const Lanes<2> Lambda_0_11_p2856_lanes = 0.226 *
      detail::make_lanes<Real>(Lambda_0_11_p2569_lanes[2], Lambda_0_11_p2177_lanes[0]);
  const Lanes<2> Lambda_0_11_p2858_lanes = Lambda_0_11_p2856_lanes + Lambda_0_11_p2854_lanes;
  const Lanes<2> Lambda_0_11_p2860_lanes = detail::make_lanes<Real>(s7, s14) *
      detail::make_lanes<Real>(Lambda_0_11_p2793_lanes[2], Lambda_0_11_p2763_lanes[0]);
  const Lanes<2> Lambda_0_11_p2862_lanes = detail::make_lanes<Real>(c7, c14) *
      detail::make_lanes<Real>(Lambda_0_11_p2809_lanes[2], Lambda_0_11_p2805_lanes[0]);
  const Lanes<2> Lambda_0_11_p2864_lanes = Lambda_0_11_p2862_lanes + Lambda_0_11_p2860_lanes;
  const Lanes<2> Lambda_0_11_p2866_lanes = Lambda_0_11_p2864_lanes + Lambda_0_11_p2858_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p2868 = -Lambda_0_11_p2866_lanes[1];
  const Lanes<8> Lambda_0_11_p2869_lanes = inverse_D5_p16 *
      detail::make_lanes<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2873_lanes = s14 * Lambda_0_11_p2595_lanes;
  const Lanes<8> Lambda_0_11_p2877_lanes = c14 * Lambda_0_11_p2627_lanes;
  const Lanes<8> Lambda_0_11_p2881_lanes = Lambda_0_11_p2877_lanes - Lambda_0_11_p2873_lanes;
  const Lanes<8> Lambda_0_11_p2885_lanes = (-0.18) * Lambda_0_11_p2881_lanes;
  const Lanes<8> Lambda_0_11_p2889_lanes = c14 * Lambda_0_11_p2763_lanes;
  const Lanes<8> Lambda_0_11_p2893_lanes = s14 * Lambda_0_11_p2805_lanes;
  const Lanes<8> Lambda_0_11_p2897_lanes = Lambda_0_11_p2893_lanes - Lambda_0_11_p2889_lanes;
  const Lanes<8> Lambda_0_11_p2901_lanes = Lambda_0_11_p2885_lanes - Lambda_0_11_p2897_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p2905_lanes = Lambda_0_11_p2901_lanes - Lambda_0_11_p2869_lanes;
  const Lanes<8> Lambda_0_11_p2909_lanes = s6 * Lambda_0_11_p2905_lanes;
  const Lanes<8> Lambda_0_11_p2913_lanes = inverse_D5_p22 *
      detail::make_lanes<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p2917_lanes = 0.226 * Lambda_0_11_p2881_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p2921_lanes = Lambda_0_11_p2917_lanes - Lambda_0_11_p2913_lanes;
  const Lanes<8> Lambda_0_11_p2925_lanes = c6 * Lambda_0_11_p2921_lanes;
  const Lanes<8> Lambda_0_11_p2929_lanes = Lambda_0_11_p2909_lanes + Lambda_0_11_p2925_lanes;
  const Lanes<8> Lambda_0_11_p2933_lanes = Lambda_0_11_p993 *
      detail::make_lanes<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);
  const Lanes<8> Lambda_0_11_p2937_lanes = Lambda_0_11_p2881_lanes - Lambda_0_11_p2933_lanes;
  const Lanes<8> Lambda_0_11_p2941_lanes = 0.072 * Lambda_0_11_p2937_lanes;
  const Lanes<8> Lambda_0_11_p2945_lanes = Lambda_0_11_p2929_lanes + Lambda_0_11_p2941_lanes;
  const Lanes<8> Lambda_0_11_p2949_lanes = Lambda_0_11_p930 *
      detail::make_lanes<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);
  const Lanes<8> Lambda_0_11_p2953_lanes = Lambda_0_11_p2635_lanes + Lambda_0_11_p2949_lanes;
  const Lanes<8> Lambda_0_11_p2957_lanes = s6 * Lambda_0_11_p2953_lanes;
  const Lanes<8> Lambda_0_11_p2961_lanes = Lambda_0_11_p984 *
      detail::make_lanes<Real>(Lambda_0_11_p2868, Lambda_0_11_p2853, Lambda_0_11_p2838,
      Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868);
  const Lanes<8> Lambda_0_11_p2965_lanes = Lambda_0_11_p2177_lanes - Lambda_0_11_p2961_lanes;
  const Lanes<8> Lambda_0_11_p2969_lanes = c6 * Lambda_0_11_p2965_lanes;
  const Lanes<8> Lambda_0_11_p2973_lanes = Lambda_0_11_p2957_lanes + Lambda_0_11_p2969_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2977 = -(0.072 * Lambda_0_11_p2973_lanes[3]) + Lambda_0_11_p1020 *
      Lambda_0_11_p2945_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p2978_lanes = c6 * Lambda_0_11_p2905_lanes;
  const Lanes<8> Lambda_0_11_p2982_lanes = s6 * Lambda_0_11_p2921_lanes;
  const Lanes<8> Lambda_0_11_p2986_lanes = Lambda_0_11_p2978_lanes - Lambda_0_11_p2982_lanes;

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
  const Lanes<8> Lambda_0_11_p3001_lanes = inverse_D3_p1 *
      detail::make_lanes<Real>(Lambda_0_11_p3000, Lambda_0_11_p2997, Lambda_0_11_p2994,
      Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3005_lanes = Lambda_0_11_p1005 * Lambda_0_11_p2945_lanes;
  const Lanes<8> Lambda_0_11_p3009_lanes = Lambda_0_11_p2973_lanes - Lambda_0_11_p3005_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3013_lanes = detail::make_lanes<Real>(-(s5 * Lambda_0_11_p2999 - c5 *
      Lambda_0_11_p2998 + 0.21799999999999997 * Lambda_0_11_p3009_lanes[0]),
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
      Lambda_0_11_p3009_lanes[0])) - Lambda_0_11_p3001_lanes;
  const Lanes<8> Lambda_0_11_p3017_lanes = s4 * Lambda_0_11_p3013_lanes;
  const Lanes<8> Lambda_0_11_p3021_lanes = inverse_D3_p2 *
      detail::make_lanes<Real>(Lambda_0_11_p3000, Lambda_0_11_p2997, Lambda_0_11_p2994,
      Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3025_lanes = c6 * Lambda_0_11_p2953_lanes;
  const Lanes<8> Lambda_0_11_p3029_lanes = s6 * Lambda_0_11_p2965_lanes;
  const Lanes<8> Lambda_0_11_p3033_lanes = Lambda_0_11_p3025_lanes - Lambda_0_11_p3029_lanes;

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
  const Lanes<8> Lambda_0_11_p3049_lanes = detail::make_lanes<Real>(-(0.21799999999999997 *
      Lambda_0_11_p3048), -(0.21799999999999997 * Lambda_0_11_p3045),
      -(0.21799999999999997 * Lambda_0_11_p3042), -(0.21799999999999997 * Lambda_0_11_p3039),
      -(0.21799999999999997 * Lambda_0_11_p3048), -(0.21799999999999997 * Lambda_0_11_p3048),
      -(0.21799999999999997 * Lambda_0_11_p3048), -(0.21799999999999997 * Lambda_0_11_p3048)) +
      Lambda_0_11_p3021_lanes;
  const Lanes<8> Lambda_0_11_p3053_lanes = c4 * Lambda_0_11_p3049_lanes;
  const Lanes<8> Lambda_0_11_p3057_lanes = Lambda_0_11_p3017_lanes + Lambda_0_11_p3053_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3061_lanes = Lambda_0_11_p1063 * Lambda_0_11_p3057_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3065_lanes = Lambda_0_11_p1041 *
      detail::make_lanes<Real>(Lambda_0_11_p3000, Lambda_0_11_p2997, Lambda_0_11_p2994,
      Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000);
  const Lanes<8> Lambda_0_11_p3069_lanes = detail::make_lanes<Real>(-Lambda_0_11_p3048,
      -Lambda_0_11_p3045, -Lambda_0_11_p3042, -Lambda_0_11_p3039, -Lambda_0_11_p3048,
      -Lambda_0_11_p3048, -Lambda_0_11_p3048, -Lambda_0_11_p3048) + Lambda_0_11_p3065_lanes;
  const Lanes<8> Lambda_0_11_p3073_lanes = c4 * Lambda_0_11_p3069_lanes;
  const Lanes<8> Lambda_0_11_p3077_lanes = Lambda_0_11_p1050 *
      detail::make_lanes<Real>(Lambda_0_11_p3000, Lambda_0_11_p2997, Lambda_0_11_p2994,
      Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000);
  const Lanes<8> Lambda_0_11_p3081_lanes = Lambda_0_11_p3009_lanes + Lambda_0_11_p3077_lanes;
  const Lanes<8> Lambda_0_11_p3085_lanes = s4 * Lambda_0_11_p3081_lanes;
  const Lanes<8> Lambda_0_11_p3089_lanes = Lambda_0_11_p3073_lanes - Lambda_0_11_p3085_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3093_lanes = Lambda_0_11_p3089_lanes - Lambda_0_11_p3061_lanes;
  const Lanes<8> Lambda_0_11_p3097_lanes = c3 * Lambda_0_11_p3093_lanes;
  const Lanes<8> Lambda_0_11_p3101_lanes = Lambda_0_11_p1073 * Lambda_0_11_p3057_lanes;
  const Lanes<8> Lambda_0_11_p3105_lanes = detail::make_lanes<Real>(-(-(s5 * Lambda_0_11_p3047 +
      c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3044 + c5 * Lambda_0_11_p3043) - Lambda_0_11_p1068 * Lambda_0_11_p2997),
      -(-(s5 * Lambda_0_11_p3041 + c5 * Lambda_0_11_p3040) - Lambda_0_11_p1068 * Lambda_0_11_p2994),
      -(-(s5 * Lambda_0_11_p3038 + c5 * Lambda_0_11_p3037) - Lambda_0_11_p1068 * Lambda_0_11_p2991),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 * Lambda_0_11_p3000),
      -(-(s5 * Lambda_0_11_p3047 + c5 * Lambda_0_11_p3046) - Lambda_0_11_p1068 *
      Lambda_0_11_p3000)) + Lambda_0_11_p3101_lanes;
  const Lanes<8> Lambda_0_11_p3109_lanes = s3 * Lambda_0_11_p3105_lanes;
  const Lanes<8> Lambda_0_11_p3113_lanes = Lambda_0_11_p3097_lanes - Lambda_0_11_p3109_lanes;
  const Lanes<8> Lambda_0_11_p3117_lanes = 0.422 * Lambda_0_11_p3113_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3121_lanes = Lambda_0_11_p1080 * Lambda_0_11_p3117_lanes;
  const Lanes<8> Lambda_0_11_p3125_lanes = Lambda_0_11_p3113_lanes - Lambda_0_11_p3121_lanes;
  const Lanes<8> Lambda_0_11_p3129_lanes = c2 * Lambda_0_11_p3125_lanes;

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p3133 = c3 * Lambda_0_11_p1076 - Lambda_0_11_p1075;
  const Real Lambda_0_11_p3134 = 0.031999971599999996 + 0.422 * Lambda_0_11_p3133;

  // link 2 (thigh), articulated inertia
  const Real Lambda_0_11_p3135 = Lambda_0_11_p3134 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3136_lanes = Lambda_0_11_p3135 * Lambda_0_11_p3117_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3140_lanes = s3 * Lambda_0_11_p3093_lanes;
  const Lanes<8> Lambda_0_11_p3144_lanes = c3 * Lambda_0_11_p3105_lanes;
  const Lanes<8> Lambda_0_11_p3148_lanes = Lambda_0_11_p3140_lanes + Lambda_0_11_p3144_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3152_lanes = Lambda_0_11_p3148_lanes - Lambda_0_11_p3136_lanes;
  const Lanes<8> Lambda_0_11_p3156_lanes = s2 * Lambda_0_11_p3152_lanes;
  const Lanes<8> Lambda_0_11_p3160_lanes = Lambda_0_11_p3129_lanes - Lambda_0_11_p3156_lanes;
  const Lanes<8> Lambda_0_11_p3164_lanes = 0.434 * Lambda_0_11_p3160_lanes;

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
  const Lanes<2> Lambda_0_11_p3172_lanes = detail::make_lanes<Real>(c7, c14) *
      detail::make_lanes<Real>(Lambda_0_11_p2809_lanes[1], Lambda_0_11_p2809_lanes[7]);
  const Lanes<2> Lambda_0_11_p3174_lanes = detail::make_lanes<Real>(s7, s14) *
      detail::make_lanes<Real>(Lambda_0_11_p2793_lanes[1], Lambda_0_11_p2793_lanes[7]);
  const Lanes<2> Lambda_0_11_p3176_lanes = Lambda_0_11_p3172_lanes + Lambda_0_11_p3174_lanes;
  const Lanes<2> Lambda_0_11_p3178_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      detail::make_lanes<Real>(Lambda_0_11_p2735_lanes[1], Lambda_0_11_p2735_lanes[7]);
  const Lanes<2> Lambda_0_11_p3180_lanes = 0.226 *
      detail::make_lanes<Real>(Lambda_0_11_p2569_lanes[1], Lambda_0_11_p2569_lanes[7]);
  const Lanes<2> Lambda_0_11_p3182_lanes = Lambda_0_11_p3180_lanes + Lambda_0_11_p3178_lanes;
  const Lanes<2> Lambda_0_11_p3184_lanes = Lambda_0_11_p3176_lanes + Lambda_0_11_p3182_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p3186 = -Lambda_0_11_p3184_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p3187_lanes = detail::make_lanes<Real>(0.18, (-0.18)) *
      detail::make_lanes<Real>(Lambda_0_11_p2735_lanes[0], Lambda_0_11_p2735_lanes[6]);
  const Lanes<2> Lambda_0_11_p3189_lanes = 0.226 *
      detail::make_lanes<Real>(Lambda_0_11_p2569_lanes[0], Lambda_0_11_p2569_lanes[6]);
  const Lanes<2> Lambda_0_11_p3191_lanes = Lambda_0_11_p3189_lanes + Lambda_0_11_p3187_lanes;
  const Lanes<2> Lambda_0_11_p3193_lanes = detail::make_lanes<Real>(s7, s14) *
      detail::make_lanes<Real>(Lambda_0_11_p2793_lanes[0], Lambda_0_11_p2793_lanes[6]);
  const Lanes<2> Lambda_0_11_p3195_lanes = detail::make_lanes<Real>(c7, c14) *
      detail::make_lanes<Real>(Lambda_0_11_p2809_lanes[0], Lambda_0_11_p2809_lanes[6]);
  const Lanes<2> Lambda_0_11_p3197_lanes = Lambda_0_11_p3195_lanes + Lambda_0_11_p3193_lanes;
  const Lanes<2> Lambda_0_11_p3199_lanes = Lambda_0_11_p3197_lanes + Lambda_0_11_p3191_lanes;

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p3201 = -Lambda_0_11_p3199_lanes[1];
  const Real Lambda_0_11_p3202 = -Lambda_0_11_p2821_lanes[0];
  const Real Lambda_0_11_p3203 = -Lambda_0_11_p2836_lanes[0];
  const Real Lambda_0_11_p3204 = -Lambda_0_11_p2851_lanes[0];
  const Real Lambda_0_11_p3205 = -Lambda_0_11_p2866_lanes[0];
  const Real Lambda_0_11_p3206 = -Lambda_0_11_p3184_lanes[0];
  const Real Lambda_0_11_p3207 = -Lambda_0_11_p3199_lanes[0];
  const Lanes<8> Lambda_0_11_p3208_lanes = inverse_D5_p16 *
      detail::make_lanes<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3216_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_0_11_p2677_lanes;
  const Lanes<8> Lambda_0_11_p3224_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_0_11_p2719_lanes;
  const Lanes<8> Lambda_0_11_p3232_lanes = Lambda_0_11_p3216_lanes - Lambda_0_11_p3224_lanes;
  const Lanes<8> Lambda_0_11_p3240_lanes = detail::make_lanes<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, (-0.18), (-0.18)) * Lambda_0_11_p3232_lanes;
  const Lanes<8> Lambda_0_11_p3248_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_0_11_p2809_lanes;
  const Lanes<8> Lambda_0_11_p3256_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_0_11_p2793_lanes;
  const Lanes<8> Lambda_0_11_p3264_lanes = Lambda_0_11_p3248_lanes - Lambda_0_11_p3256_lanes;
  const Lanes<8> Lambda_0_11_p3272_lanes = Lambda_0_11_p3240_lanes - Lambda_0_11_p3264_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3280_lanes = Lambda_0_11_p3272_lanes - Lambda_0_11_p3208_lanes;
  const Lanes<8> Lambda_0_11_p3288_lanes = s6 * Lambda_0_11_p3280_lanes;
  const Lanes<8> Lambda_0_11_p3296_lanes = inverse_D5_p22 *
      detail::make_lanes<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3304_lanes = 0.226 * Lambda_0_11_p3232_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3312_lanes = Lambda_0_11_p3304_lanes - Lambda_0_11_p3296_lanes;
  const Lanes<8> Lambda_0_11_p3320_lanes = c6 * Lambda_0_11_p3312_lanes;
  const Lanes<8> Lambda_0_11_p3328_lanes = Lambda_0_11_p3288_lanes + Lambda_0_11_p3320_lanes;
  const Lanes<8> Lambda_0_11_p3336_lanes = Lambda_0_11_p993 *
      detail::make_lanes<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);
  const Lanes<8> Lambda_0_11_p3344_lanes = Lambda_0_11_p3232_lanes - Lambda_0_11_p3336_lanes;
  const Lanes<8> Lambda_0_11_p3352_lanes = 0.072 * Lambda_0_11_p3344_lanes;
  const Lanes<8> Lambda_0_11_p3360_lanes = Lambda_0_11_p3328_lanes + Lambda_0_11_p3352_lanes;
  const Lanes<8> Lambda_0_11_p3368_lanes = Lambda_0_11_p930 *
      detail::make_lanes<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);
  const Lanes<8> Lambda_0_11_p3376_lanes = Lambda_0_11_p2735_lanes + Lambda_0_11_p3368_lanes;
  const Lanes<8> Lambda_0_11_p3384_lanes = s6 * Lambda_0_11_p3376_lanes;
  const Lanes<8> Lambda_0_11_p3392_lanes = Lambda_0_11_p984 *
      detail::make_lanes<Real>(Lambda_0_11_p3207, Lambda_0_11_p3206, Lambda_0_11_p3205,
      Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202, Lambda_0_11_p3201,
      Lambda_0_11_p3186);
  const Lanes<8> Lambda_0_11_p3400_lanes = Lambda_0_11_p2569_lanes - Lambda_0_11_p3392_lanes;
  const Lanes<8> Lambda_0_11_p3408_lanes = c6 * Lambda_0_11_p3400_lanes;
  const Lanes<8> Lambda_0_11_p3416_lanes = Lambda_0_11_p3384_lanes + Lambda_0_11_p3408_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p3424 = -(0.072 * Lambda_0_11_p3416_lanes[7]) + Lambda_0_11_p1020 *
      Lambda_0_11_p3360_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3425_lanes = c6 * Lambda_0_11_p3280_lanes;
  const Lanes<8> Lambda_0_11_p3433_lanes = s6 * Lambda_0_11_p3312_lanes;
  const Lanes<8> Lambda_0_11_p3441_lanes = Lambda_0_11_p3425_lanes - Lambda_0_11_p3433_lanes;

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
  const Lanes<8> Lambda_0_11_p3472_lanes = inverse_D3_p1 *
      detail::make_lanes<Real>(Lambda_0_11_p3471, Lambda_0_11_p3468, Lambda_0_11_p3465,
      Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456, Lambda_0_11_p3453,
      Lambda_0_11_p3450);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3480_lanes = Lambda_0_11_p1005 * Lambda_0_11_p3360_lanes;
  const Lanes<8> Lambda_0_11_p3488_lanes = Lambda_0_11_p3416_lanes - Lambda_0_11_p3480_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3496_lanes = detail::make_lanes<Real>(-(s5 * Lambda_0_11_p3470 - c5 *
      Lambda_0_11_p3469 + 0.21799999999999997 * Lambda_0_11_p3488_lanes[0]),
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
      Lambda_0_11_p3488_lanes[7])) - Lambda_0_11_p3472_lanes;
  const Lanes<8> Lambda_0_11_p3504_lanes = s4 * Lambda_0_11_p3496_lanes;
  const Lanes<8> Lambda_0_11_p3512_lanes = inverse_D3_p2 *
      detail::make_lanes<Real>(Lambda_0_11_p3471, Lambda_0_11_p3468, Lambda_0_11_p3465,
      Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456, Lambda_0_11_p3453,
      Lambda_0_11_p3450);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3520_lanes = c6 * Lambda_0_11_p3376_lanes;
  const Lanes<8> Lambda_0_11_p3528_lanes = s6 * Lambda_0_11_p3400_lanes;
  const Lanes<8> Lambda_0_11_p3536_lanes = Lambda_0_11_p3520_lanes - Lambda_0_11_p3528_lanes;

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
  const Lanes<8> Lambda_0_11_p3568_lanes = detail::make_lanes<Real>(-(0.21799999999999997 *
      Lambda_0_11_p3567), -(0.21799999999999997 * Lambda_0_11_p3564),
      -(0.21799999999999997 * Lambda_0_11_p3561), -(0.21799999999999997 * Lambda_0_11_p3558),
      -(0.21799999999999997 * Lambda_0_11_p3555), -(0.21799999999999997 * Lambda_0_11_p3552),
      -(0.21799999999999997 * Lambda_0_11_p3549), -(0.21799999999999997 * Lambda_0_11_p3546)) +
      Lambda_0_11_p3512_lanes;
  const Lanes<8> Lambda_0_11_p3576_lanes = c4 * Lambda_0_11_p3568_lanes;
  const Lanes<8> Lambda_0_11_p3584_lanes = Lambda_0_11_p3504_lanes + Lambda_0_11_p3576_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3592_lanes = Lambda_0_11_p1063 * Lambda_0_11_p3584_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3600_lanes = Lambda_0_11_p1041 *
      detail::make_lanes<Real>(Lambda_0_11_p3471, Lambda_0_11_p3468, Lambda_0_11_p3465,
      Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456, Lambda_0_11_p3453,
      Lambda_0_11_p3450);
  const Lanes<8> Lambda_0_11_p3608_lanes = detail::make_lanes<Real>(-Lambda_0_11_p3567,
      -Lambda_0_11_p3564, -Lambda_0_11_p3561, -Lambda_0_11_p3558, -Lambda_0_11_p3555,
      -Lambda_0_11_p3552, -Lambda_0_11_p3549, -Lambda_0_11_p3546) + Lambda_0_11_p3600_lanes;
  const Lanes<8> Lambda_0_11_p3616_lanes = c4 * Lambda_0_11_p3608_lanes;
  const Lanes<8> Lambda_0_11_p3624_lanes = Lambda_0_11_p1050 *
      detail::make_lanes<Real>(Lambda_0_11_p3471, Lambda_0_11_p3468, Lambda_0_11_p3465,
      Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456, Lambda_0_11_p3453,
      Lambda_0_11_p3450);
  const Lanes<8> Lambda_0_11_p3632_lanes = Lambda_0_11_p3488_lanes + Lambda_0_11_p3624_lanes;
  const Lanes<8> Lambda_0_11_p3640_lanes = s4 * Lambda_0_11_p3632_lanes;
  const Lanes<8> Lambda_0_11_p3648_lanes = Lambda_0_11_p3616_lanes - Lambda_0_11_p3640_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3656_lanes = Lambda_0_11_p3648_lanes - Lambda_0_11_p3592_lanes;
  const Lanes<8> Lambda_0_11_p3664_lanes = c3 * Lambda_0_11_p3656_lanes;
  const Lanes<8> Lambda_0_11_p3672_lanes = Lambda_0_11_p1073 * Lambda_0_11_p3584_lanes;
  const Lanes<8> Lambda_0_11_p3680_lanes = detail::make_lanes<Real>(-(-(s5 * Lambda_0_11_p3566 +
      c5 * Lambda_0_11_p3565) - Lambda_0_11_p1068 * Lambda_0_11_p3471),
      -(-(s5 * Lambda_0_11_p3563 + c5 * Lambda_0_11_p3562) - Lambda_0_11_p1068 * Lambda_0_11_p3468),
      -(-(s5 * Lambda_0_11_p3560 + c5 * Lambda_0_11_p3559) - Lambda_0_11_p1068 * Lambda_0_11_p3465),
      -(-(s5 * Lambda_0_11_p3557 + c5 * Lambda_0_11_p3556) - Lambda_0_11_p1068 * Lambda_0_11_p3462),
      -(-(s5 * Lambda_0_11_p3554 + c5 * Lambda_0_11_p3553) - Lambda_0_11_p1068 * Lambda_0_11_p3459),
      -(-(s5 * Lambda_0_11_p3551 + c5 * Lambda_0_11_p3550) - Lambda_0_11_p1068 * Lambda_0_11_p3456),
      -(-(s5 * Lambda_0_11_p3548 + c5 * Lambda_0_11_p3547) - Lambda_0_11_p1068 * Lambda_0_11_p3453),
      -(-(s5 * Lambda_0_11_p3545 + c5 * Lambda_0_11_p3544) - Lambda_0_11_p1068 *
      Lambda_0_11_p3450)) + Lambda_0_11_p3672_lanes;
  const Lanes<8> Lambda_0_11_p3688_lanes = s3 * Lambda_0_11_p3680_lanes;
  const Lanes<8> Lambda_0_11_p3696_lanes = Lambda_0_11_p3664_lanes - Lambda_0_11_p3688_lanes;
  const Lanes<8> Lambda_0_11_p3704_lanes = 0.422 * Lambda_0_11_p3696_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3712_lanes = Lambda_0_11_p1080 * Lambda_0_11_p3704_lanes;
  const Lanes<8> Lambda_0_11_p3720_lanes = Lambda_0_11_p3696_lanes - Lambda_0_11_p3712_lanes;
  const Lanes<8> Lambda_0_11_p3728_lanes = c2 * Lambda_0_11_p3720_lanes;
  const Lanes<8> Lambda_0_11_p3736_lanes = Lambda_0_11_p3135 * Lambda_0_11_p3704_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3744_lanes = s3 * Lambda_0_11_p3656_lanes;
  const Lanes<8> Lambda_0_11_p3752_lanes = c3 * Lambda_0_11_p3680_lanes;
  const Lanes<8> Lambda_0_11_p3760_lanes = Lambda_0_11_p3744_lanes + Lambda_0_11_p3752_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3768_lanes = Lambda_0_11_p3760_lanes - Lambda_0_11_p3736_lanes;
  const Lanes<8> Lambda_0_11_p3776_lanes = s2 * Lambda_0_11_p3768_lanes;
  const Lanes<8> Lambda_0_11_p3784_lanes = Lambda_0_11_p3728_lanes - Lambda_0_11_p3776_lanes;
  const Lanes<8> Lambda_0_11_p3792_lanes = 0.434 * Lambda_0_11_p3784_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p3800_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3804_lanes = Lambda_0_11_p3117_lanes * inverse_D2;
  const Lanes<8> Lambda_0_11_p3808_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3812_lanes = Lambda_0_11_p3057_lanes * inverse_D3;
  const Lanes<8> Lambda_0_11_p3816_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3820_lanes = detail::make_lanes<Real>(Lambda_0_11_p3000,
      Lambda_0_11_p2997, Lambda_0_11_p2994, Lambda_0_11_p2991, Lambda_0_11_p3000, Lambda_0_11_p3000,
      Lambda_0_11_p3000, Lambda_0_11_p3000) * inverse_D4;
  const Lanes<8> Lambda_0_11_p3824_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3471;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3828_lanes = Lambda_0_11_p2945_lanes * inverse_D5;
  const Lanes<8> Lambda_0_11_p3832_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p3836_lanes = detail::make_lanes<Real>(Lambda_0_11_p2868,
      Lambda_0_11_p2853, Lambda_0_11_p2838, Lambda_0_11_p2823, Lambda_0_11_p2868, Lambda_0_11_p2868,
      Lambda_0_11_p2868, Lambda_0_11_p2868) * inverse_D6;
  const Lanes<8> Lambda_0_11_p3840_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3207;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3844_lanes = Lambda_0_11_p3840_lanes + Lambda_0_11_p3832_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3848_lanes = Lambda_0_11_p3844_lanes + Lambda_0_11_p3824_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3852_lanes = Lambda_0_11_p3848_lanes + Lambda_0_11_p3816_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3856_lanes = Lambda_0_11_p3852_lanes + Lambda_0_11_p3808_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p3860_lanes = Lambda_0_11_p3856_lanes + Lambda_0_11_p3800_lanes;
  const Lanes<8> Lambda_0_11_p3864_lanes = Lambda_0_11_p3792_lanes * inverse_D1;
  const Lanes<8> Lambda_0_11_p3872_lanes = Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p3880_lanes = Lambda_0_11_p3704_lanes * inverse_D2;
  const Lanes<8> Lambda_0_11_p3888_lanes = Lambda_0_11_p3880_lanes * Lambda_0_11_p3704_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p3896_lanes = Lambda_0_11_p3584_lanes * inverse_D3;
  const Lanes<8> Lambda_0_11_p3904_lanes = Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p3912_lanes = detail::make_lanes<Real>(Lambda_0_11_p3471,
      Lambda_0_11_p3468, Lambda_0_11_p3465, Lambda_0_11_p3462, Lambda_0_11_p3459, Lambda_0_11_p3456,
      Lambda_0_11_p3453, Lambda_0_11_p3450) * inverse_D4;
  const Lanes<8> Lambda_0_11_p3920_lanes = Lambda_0_11_p3912_lanes * Lambda_0_11_p3471;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p3928_lanes = Lambda_0_11_p3360_lanes * inverse_D5;
  const Lanes<8> Lambda_0_11_p3936_lanes = Lambda_0_11_p3928_lanes * Lambda_0_11_p3360_lanes[0];

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p3944 = Lambda_0_11_p3186 * inverse_D6;
  const Real Lambda_0_11_p3945 = Lambda_0_11_p3201 * inverse_D6;
  const Lanes<8> Lambda_0_11_p3946_lanes = detail::make_lanes<Real>(Lambda_0_11_p3207,
      Lambda_0_11_p3206, Lambda_0_11_p3205, Lambda_0_11_p3204, Lambda_0_11_p3203, Lambda_0_11_p3202,
      Lambda_0_11_p3207, Lambda_0_11_p3207) * inverse_D6;
  const Lanes<8> Lambda_0_11_p3952_lanes = Lambda_0_11_p3946_lanes * Lambda_0_11_p3207;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p3958_lanes = Lambda_0_11_p2451_lanes * inverse_D7_lanes[0];
  const Lanes<8> Lambda_0_11_p3964_lanes = Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p3970_lanes = Lambda_0_11_p2415_lanes * inverse_D8_lanes[0];
  const Lanes<8> Lambda_0_11_p3976_lanes = Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p3982_lanes = Lambda_0_11_p2331_lanes * inverse_D9_lanes[0];
  const Lanes<8> Lambda_0_11_p3988_lanes = Lambda_0_11_p3982_lanes * Lambda_0_11_p2331_lanes[0];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p3994_lanes = Lambda_0_11_p1975_lanes * inverse_D10_lanes[0];
  const Lanes<8> Lambda_0_11_p4000_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4006_lanes = detail::make_lanes<Real>(Lambda_0_11_p1887,
      Lambda_0_11_p1886, Lambda_0_11_p1885, Lambda_0_11_p1769, Lambda_0_11_p1764, Lambda_0_11_p1710,
      Lambda_0_11_p1887, Lambda_0_11_p1887) * inverse_D11_lanes[0];
  const Lanes<8> Lambda_0_11_p4012_lanes = Lambda_0_11_p4006_lanes * Lambda_0_11_p1887;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4018_lanes = Lambda_0_11_p1523_lanes * inverse_D12_lanes[0];
  const Lanes<8> Lambda_0_11_p4024_lanes = Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[0];

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p4030 = 0.086 * Lambda_0_11_p1497;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p4031_lanes = detail::make_lanes<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_lanes<Real>(Lambda_0_11_p1497,
      Lambda_0_11_p1495, Lambda_0_11_p1400, Lambda_0_11_p1483_lanes[0], Lambda_0_11_p1483_lanes[1],
      Lambda_0_11_p1483_lanes[2], Lambda_0_11_p1497, Lambda_0_11_p1497);
  const Lanes<8> Lambda_0_11_p4037_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p4030;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4043_lanes = Lambda_0_11_p4037_lanes + Lambda_0_11_p4024_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4049_lanes = Lambda_0_11_p4043_lanes + Lambda_0_11_p4012_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4055_lanes = Lambda_0_11_p4049_lanes + Lambda_0_11_p4000_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4061_lanes = Lambda_0_11_p4055_lanes + Lambda_0_11_p3988_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4067_lanes = Lambda_0_11_p4061_lanes + Lambda_0_11_p3976_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4073_lanes = Lambda_0_11_p4067_lanes + Lambda_0_11_p3964_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4079_lanes = Lambda_0_11_p4073_lanes + Lambda_0_11_p3952_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4085_lanes = detail::make_lanes<Real>(Lambda_0_11_p4079_lanes[0],
      Lambda_0_11_p4079_lanes[1], Lambda_0_11_p4079_lanes[2], Lambda_0_11_p4079_lanes[3],
      Lambda_0_11_p4079_lanes[4], Lambda_0_11_p4079_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3207,
      Lambda_0_11_p3944 * Lambda_0_11_p3207) + Lambda_0_11_p3936_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4093_lanes = Lambda_0_11_p4085_lanes + Lambda_0_11_p3920_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4101_lanes = Lambda_0_11_p4093_lanes + Lambda_0_11_p3904_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4109_lanes = Lambda_0_11_p4101_lanes + Lambda_0_11_p3888_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4117_lanes = Lambda_0_11_p4109_lanes + Lambda_0_11_p3872_lanes;
  const Real Lambda_0_11_p4125 = 1.0 / Lambda_0_11_p4117_lanes[0];
  const Lanes<8> Lambda_0_11_p4126_lanes = Lambda_0_11_p3860_lanes * Lambda_0_11_p4125;
  const Lanes<8> Lambda_0_11_p4130_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[1];
  const Lanes<8> Lambda_0_11_p4134_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4138_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4142_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4146_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3468;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4150_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4154_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3206;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4158_lanes = Lambda_0_11_p4154_lanes + Lambda_0_11_p4150_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4162_lanes = Lambda_0_11_p4158_lanes + Lambda_0_11_p4146_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4166_lanes = Lambda_0_11_p4162_lanes + Lambda_0_11_p4142_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4170_lanes = Lambda_0_11_p4166_lanes + Lambda_0_11_p4138_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4174_lanes = Lambda_0_11_p4170_lanes + Lambda_0_11_p4134_lanes;
  const Lanes<8> Lambda_0_11_p4178_lanes = Lambda_0_11_p4174_lanes - Lambda_0_11_p4130_lanes;
  const Lanes<8> Lambda_0_11_p4182_lanes = Lambda_0_11_p4117_lanes * Lambda_0_11_p4125;
  const Lanes<8> Lambda_0_11_p4189_lanes = Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[1];
  const Lanes<8> Lambda_0_11_p4196_lanes = Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4203_lanes = Lambda_0_11_p3880_lanes * Lambda_0_11_p3704_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4210_lanes = Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4217_lanes = Lambda_0_11_p3912_lanes * Lambda_0_11_p3468;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4224_lanes = Lambda_0_11_p3928_lanes * Lambda_0_11_p3360_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4231_lanes = Lambda_0_11_p3946_lanes * Lambda_0_11_p3206;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4236_lanes = Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4241_lanes = Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4246_lanes = Lambda_0_11_p3982_lanes * Lambda_0_11_p2331_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4251_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4256_lanes = Lambda_0_11_p4006_lanes * Lambda_0_11_p1886;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4261_lanes = Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[1];

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p4266 = 0.086 * Lambda_0_11_p1495;

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p4267_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p4266;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4272_lanes = Lambda_0_11_p4267_lanes + Lambda_0_11_p4261_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4277_lanes = Lambda_0_11_p4272_lanes + Lambda_0_11_p4256_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4282_lanes = Lambda_0_11_p4277_lanes + Lambda_0_11_p4251_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4287_lanes = Lambda_0_11_p4282_lanes + Lambda_0_11_p4246_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4292_lanes = Lambda_0_11_p4287_lanes + Lambda_0_11_p4241_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4297_lanes = Lambda_0_11_p4292_lanes + Lambda_0_11_p4236_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4302_lanes = Lambda_0_11_p4297_lanes + Lambda_0_11_p4231_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4307_lanes = detail::make_lanes<Real>(Lambda_0_11_p4302_lanes[1],
      Lambda_0_11_p4302_lanes[1], Lambda_0_11_p4302_lanes[2], Lambda_0_11_p4302_lanes[3],
      Lambda_0_11_p4302_lanes[4], Lambda_0_11_p4302_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3206,
      Lambda_0_11_p3944 * Lambda_0_11_p3206) + Lambda_0_11_p4224_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4314_lanes = Lambda_0_11_p4307_lanes + Lambda_0_11_p4217_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4321_lanes = Lambda_0_11_p4314_lanes + Lambda_0_11_p4210_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4328_lanes = Lambda_0_11_p4321_lanes + Lambda_0_11_p4203_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4335_lanes = Lambda_0_11_p4328_lanes + Lambda_0_11_p4196_lanes;
  const Lanes<8> Lambda_0_11_p4342_lanes = Lambda_0_11_p4335_lanes - Lambda_0_11_p4189_lanes;
  const Real Lambda_0_11_p4349 = 1.0 / Lambda_0_11_p4342_lanes[1];
  const Lanes<8> Lambda_0_11_p4350_lanes = Lambda_0_11_p4178_lanes * Lambda_0_11_p4349;
  const Lanes<8> Lambda_0_11_p4354_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[2];
  const Lanes<8> Lambda_0_11_p4358_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[2];
  const Lanes<8> Lambda_0_11_p4362_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4366_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4370_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4374_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3465;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4378_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4382_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3205;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4386_lanes = Lambda_0_11_p4382_lanes + Lambda_0_11_p4378_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4390_lanes = Lambda_0_11_p4386_lanes + Lambda_0_11_p4374_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4394_lanes = Lambda_0_11_p4390_lanes + Lambda_0_11_p4370_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4398_lanes = Lambda_0_11_p4394_lanes + Lambda_0_11_p4366_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4402_lanes = Lambda_0_11_p4398_lanes + Lambda_0_11_p4362_lanes;
  const Lanes<8> Lambda_0_11_p4406_lanes = Lambda_0_11_p4402_lanes - Lambda_0_11_p4358_lanes;
  const Lanes<8> Lambda_0_11_p4410_lanes = Lambda_0_11_p4406_lanes - Lambda_0_11_p4354_lanes;
  const Lanes<8> Lambda_0_11_p4414_lanes = Lambda_0_11_p4342_lanes * Lambda_0_11_p4349;
  const Lanes<8> Lambda_0_11_p4420_lanes = Lambda_0_11_p4414_lanes * Lambda_0_11_p4342_lanes[2];
  const Lanes<8> Lambda_0_11_p4426_lanes = Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[2];
  const Lanes<8> Lambda_0_11_p4432_lanes = Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4438_lanes = Lambda_0_11_p3880_lanes * Lambda_0_11_p3704_lanes[2];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4444_lanes = Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4450_lanes = Lambda_0_11_p3912_lanes * Lambda_0_11_p3465;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4456_lanes = Lambda_0_11_p3928_lanes * Lambda_0_11_p3360_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4462_lanes = Lambda_0_11_p3946_lanes * Lambda_0_11_p3205;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4466_lanes = Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[2];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4470_lanes = Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[2];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4474_lanes = Lambda_0_11_p3982_lanes * Lambda_0_11_p2331_lanes[2];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4478_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[2];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4482_lanes = Lambda_0_11_p4006_lanes * Lambda_0_11_p1885;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4486_lanes = Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[2];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p4490_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p1400;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4494_lanes = Lambda_0_11_p4490_lanes + Lambda_0_11_p4486_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4498_lanes = Lambda_0_11_p4494_lanes + Lambda_0_11_p4482_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4502_lanes = Lambda_0_11_p4498_lanes + Lambda_0_11_p4478_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4506_lanes = Lambda_0_11_p4502_lanes + Lambda_0_11_p4474_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4510_lanes = Lambda_0_11_p4506_lanes + Lambda_0_11_p4470_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4514_lanes = Lambda_0_11_p4510_lanes + Lambda_0_11_p4466_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4518_lanes = Lambda_0_11_p4514_lanes + Lambda_0_11_p4462_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4522_lanes = detail::make_lanes<Real>(Lambda_0_11_p4518_lanes[2],
      Lambda_0_11_p4518_lanes[2], Lambda_0_11_p4518_lanes[2], Lambda_0_11_p4518_lanes[3],
      Lambda_0_11_p4518_lanes[4], Lambda_0_11_p4518_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3205,
      Lambda_0_11_p3944 * Lambda_0_11_p3205) + Lambda_0_11_p4456_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4528_lanes = Lambda_0_11_p4522_lanes + Lambda_0_11_p4450_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4534_lanes = Lambda_0_11_p4528_lanes + Lambda_0_11_p4444_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4540_lanes = Lambda_0_11_p4534_lanes + Lambda_0_11_p4438_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4546_lanes = Lambda_0_11_p4540_lanes + Lambda_0_11_p4432_lanes;
  const Lanes<8> Lambda_0_11_p4552_lanes = Lambda_0_11_p4546_lanes - Lambda_0_11_p4426_lanes;
  const Lanes<8> Lambda_0_11_p4558_lanes = Lambda_0_11_p4552_lanes - Lambda_0_11_p4420_lanes;
  const Real Lambda_0_11_p4564 = 1.0 / Lambda_0_11_p4558_lanes[2];
  const Lanes<8> Lambda_0_11_p4565_lanes = Lambda_0_11_p4410_lanes * Lambda_0_11_p4564;
  const Lanes<8> Lambda_0_11_p4569_lanes = Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[3];
  const Lanes<8> Lambda_0_11_p4573_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[3];
  const Lanes<8> Lambda_0_11_p4577_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[3];
  const Lanes<8> Lambda_0_11_p4581_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4585_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4589_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4593_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3462;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4597_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4601_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3204;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4605_lanes = Lambda_0_11_p4601_lanes + Lambda_0_11_p4597_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4609_lanes = Lambda_0_11_p4605_lanes + Lambda_0_11_p4593_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4613_lanes = Lambda_0_11_p4609_lanes + Lambda_0_11_p4589_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4617_lanes = Lambda_0_11_p4613_lanes + Lambda_0_11_p4585_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4621_lanes = Lambda_0_11_p4617_lanes + Lambda_0_11_p4581_lanes;
  const Lanes<8> Lambda_0_11_p4625_lanes = Lambda_0_11_p4621_lanes - Lambda_0_11_p4577_lanes;
  const Lanes<8> Lambda_0_11_p4629_lanes = Lambda_0_11_p4625_lanes - Lambda_0_11_p4573_lanes;
  const Lanes<8> Lambda_0_11_p4633_lanes = Lambda_0_11_p4629_lanes - Lambda_0_11_p4569_lanes;
  const Lanes<8> Lambda_0_11_p4637_lanes = Lambda_0_11_p4558_lanes * Lambda_0_11_p4564;
  const Lanes<8> Lambda_0_11_p4642_lanes = Lambda_0_11_p4637_lanes * Lambda_0_11_p4558_lanes[3];
  const Lanes<8> Lambda_0_11_p4647_lanes = Lambda_0_11_p4414_lanes * Lambda_0_11_p4342_lanes[3];
  const Lanes<8> Lambda_0_11_p4652_lanes = Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[3];
  const Lanes<8> Lambda_0_11_p4657_lanes = Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4662_lanes = Lambda_0_11_p3880_lanes * Lambda_0_11_p3704_lanes[3];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4667_lanes = Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4672_lanes = Lambda_0_11_p3912_lanes * Lambda_0_11_p3462;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4677_lanes = Lambda_0_11_p3928_lanes * Lambda_0_11_p3360_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4682_lanes = Lambda_0_11_p3946_lanes * Lambda_0_11_p3204;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4685_lanes = Lambda_0_11_p3958_lanes * Lambda_0_11_p2451_lanes[3];

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4688_lanes = Lambda_0_11_p3970_lanes * Lambda_0_11_p2415_lanes[3];

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4691_lanes = Lambda_0_11_p3982_lanes * Lambda_0_11_p2331_lanes[3];

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4694_lanes = Lambda_0_11_p3994_lanes * Lambda_0_11_p1975_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4697_lanes = Lambda_0_11_p4006_lanes * Lambda_0_11_p1769;

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4700_lanes = Lambda_0_11_p4018_lanes * Lambda_0_11_p1523_lanes[3];

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p4703_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p1483_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4706_lanes = Lambda_0_11_p4703_lanes + Lambda_0_11_p4700_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4709_lanes = Lambda_0_11_p4706_lanes + Lambda_0_11_p4697_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4712_lanes = Lambda_0_11_p4709_lanes + Lambda_0_11_p4694_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4715_lanes = Lambda_0_11_p4712_lanes + Lambda_0_11_p4691_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4718_lanes = Lambda_0_11_p4715_lanes + Lambda_0_11_p4688_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4721_lanes = Lambda_0_11_p4718_lanes + Lambda_0_11_p4685_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4724_lanes = Lambda_0_11_p4721_lanes + Lambda_0_11_p4682_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4727_lanes = detail::make_lanes<Real>(Lambda_0_11_p4724_lanes[3],
      Lambda_0_11_p4724_lanes[3], Lambda_0_11_p4724_lanes[3], Lambda_0_11_p4724_lanes[3],
      Lambda_0_11_p4724_lanes[4], Lambda_0_11_p4724_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3204,
      Lambda_0_11_p3944 * Lambda_0_11_p3204) + Lambda_0_11_p4677_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4732_lanes = Lambda_0_11_p4727_lanes + Lambda_0_11_p4672_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4737_lanes = Lambda_0_11_p4732_lanes + Lambda_0_11_p4667_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4742_lanes = Lambda_0_11_p4737_lanes + Lambda_0_11_p4662_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4747_lanes = Lambda_0_11_p4742_lanes + Lambda_0_11_p4657_lanes;
  const Lanes<8> Lambda_0_11_p4752_lanes = Lambda_0_11_p4747_lanes - Lambda_0_11_p4652_lanes;
  const Lanes<8> Lambda_0_11_p4757_lanes = Lambda_0_11_p4752_lanes - Lambda_0_11_p4647_lanes;
  const Lanes<8> Lambda_0_11_p4762_lanes = Lambda_0_11_p4757_lanes - Lambda_0_11_p4642_lanes;
  const Real Lambda_0_11_p4767 = 1.0 / Lambda_0_11_p4762_lanes[3];
  const Lanes<8> Lambda_0_11_p4768_lanes = Lambda_0_11_p4633_lanes * Lambda_0_11_p4767;
  const Lanes<8> Lambda_0_11_p4772_lanes = Lambda_0_11_p4768_lanes * Lambda_0_11_p4762_lanes[4];
  const Lanes<8> Lambda_0_11_p4776_lanes = Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[4];
  const Lanes<8> Lambda_0_11_p4780_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[4];
  const Lanes<8> Lambda_0_11_p4784_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[4];
  const Lanes<8> Lambda_0_11_p4788_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4792_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[4];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4796_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4800_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3459;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4804_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[4];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4808_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3203;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4812_lanes = Lambda_0_11_p4808_lanes + Lambda_0_11_p4804_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4816_lanes = Lambda_0_11_p4812_lanes + Lambda_0_11_p4800_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4820_lanes = Lambda_0_11_p4816_lanes + Lambda_0_11_p4796_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4824_lanes = Lambda_0_11_p4820_lanes + Lambda_0_11_p4792_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4828_lanes = Lambda_0_11_p4824_lanes + Lambda_0_11_p4788_lanes;
  const Lanes<8> Lambda_0_11_p4832_lanes = Lambda_0_11_p4828_lanes - Lambda_0_11_p4784_lanes;
  const Lanes<8> Lambda_0_11_p4836_lanes = Lambda_0_11_p4832_lanes - Lambda_0_11_p4780_lanes;
  const Lanes<8> Lambda_0_11_p4840_lanes = Lambda_0_11_p4836_lanes - Lambda_0_11_p4776_lanes;
  const Lanes<8> Lambda_0_11_p4844_lanes = Lambda_0_11_p4840_lanes - Lambda_0_11_p4772_lanes;
  const Lanes<8> Lambda_0_11_p4848_lanes = Lambda_0_11_p4762_lanes * Lambda_0_11_p4767;
  const Lanes<8> Lambda_0_11_p4852_lanes = Lambda_0_11_p4848_lanes * Lambda_0_11_p4762_lanes[4];
  const Lanes<8> Lambda_0_11_p4856_lanes = Lambda_0_11_p4637_lanes * Lambda_0_11_p4558_lanes[4];
  const Lanes<8> Lambda_0_11_p4860_lanes = Lambda_0_11_p4414_lanes * Lambda_0_11_p4342_lanes[4];
  const Lanes<8> Lambda_0_11_p4864_lanes = Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[4];
  const Lanes<8> Lambda_0_11_p4868_lanes = Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4872_lanes = Lambda_0_11_p3880_lanes * Lambda_0_11_p3704_lanes[4];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4876_lanes = Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4880_lanes = Lambda_0_11_p3912_lanes * Lambda_0_11_p3459;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4884_lanes = Lambda_0_11_p3928_lanes * Lambda_0_11_p3360_lanes[4];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p4888_lanes = Lambda_0_11_p2169_lanes * inverse_D7_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p4892_lanes = detail::make_lanes<Real>(Lambda_0_11_p3958_lanes[5],
      Lambda_0_11_p4888_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2169_lanes[2]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p4894_lanes = Lambda_0_11_p1832_lanes * inverse_D8_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_0_11_p4898_lanes = detail::make_lanes<Real>(Lambda_0_11_p3970_lanes[5],
      Lambda_0_11_p4894_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p2415_lanes[4],
      Lambda_0_11_p1832_lanes[2]);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p4900_lanes = Lambda_0_11_p1651_lanes * inverse_D9_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_0_11_p4904_lanes = detail::make_lanes<Real>(Lambda_0_11_p3982_lanes[5],
      Lambda_0_11_p4900_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p2331_lanes[4],
      Lambda_0_11_p1651_lanes[2]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p4906_lanes = Lambda_0_11_p1571_lanes * inverse_D10_lanes[1];

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p4910_lanes = detail::make_lanes<Real>(Lambda_0_11_p3994_lanes[5],
      Lambda_0_11_p4906_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p1975_lanes[4],
      Lambda_0_11_p1571_lanes[2]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p4912_lanes = detail::make_lanes<Real>(Lambda_0_11_p1431,
      Lambda_0_11_p1430, Lambda_0_11_p1429, Lambda_0_11_p1428, Lambda_0_11_p1431, Lambda_0_11_p1431,
      Lambda_0_11_p1431, Lambda_0_11_p1431) * inverse_D11_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p4916_lanes = detail::make_lanes<Real>(Lambda_0_11_p4006_lanes[5],
      Lambda_0_11_p4912_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p1764, Lambda_0_11_p1429);

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p4918_lanes = Lambda_0_11_p1365_lanes * inverse_D12_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p4922_lanes = detail::make_lanes<Real>(Lambda_0_11_p4018_lanes[5],
      Lambda_0_11_p4918_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[4],
      Lambda_0_11_p1365_lanes[2]);

  // link 13 (left_hand), force propagation
  const Lanes<8> Lambda_0_11_p4924_lanes = Lambda_0_11_p4031_lanes * Lambda_0_11_p1483_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p4926_lanes = detail::make_lanes<Real>(Lambda_0_11_p4018_lanes[4],
      Lambda_0_11_p4918_lanes[2]) * detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[4],
      Lambda_0_11_p1365_lanes[2]);
  const Lanes<8> Lambda_0_11_p4928_lanes = Lambda_0_11_p4924_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0],
      Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0],
      Lambda_0_11_p4922_lanes[0], Lambda_0_11_p4926_lanes[0], Lambda_0_11_p4926_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p4930_lanes = detail::make_lanes<Real>(Lambda_0_11_p4006_lanes[4],
      Lambda_0_11_p4912_lanes[2]) * detail::make_lanes<Real>(Lambda_0_11_p1764, Lambda_0_11_p1429);
  const Lanes<8> Lambda_0_11_p4932_lanes = Lambda_0_11_p4928_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0],
      Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0],
      Lambda_0_11_p4916_lanes[0], Lambda_0_11_p4930_lanes[0], Lambda_0_11_p4930_lanes[0]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p4934_lanes = detail::make_lanes<Real>(Lambda_0_11_p3994_lanes[4],
      Lambda_0_11_p4906_lanes[2]) * detail::make_lanes<Real>(Lambda_0_11_p1975_lanes[4],
      Lambda_0_11_p1571_lanes[2]);
  const Lanes<8> Lambda_0_11_p4936_lanes = Lambda_0_11_p4932_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0],
      Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0],
      Lambda_0_11_p4910_lanes[0], Lambda_0_11_p4934_lanes[0], Lambda_0_11_p4934_lanes[0]);

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_0_11_p4938_lanes = detail::make_lanes<Real>(Lambda_0_11_p3982_lanes[4],
      Lambda_0_11_p4900_lanes[2]) * detail::make_lanes<Real>(Lambda_0_11_p2331_lanes[4],
      Lambda_0_11_p1651_lanes[2]);
  const Lanes<8> Lambda_0_11_p4940_lanes = Lambda_0_11_p4936_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0],
      Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0],
      Lambda_0_11_p4904_lanes[0], Lambda_0_11_p4938_lanes[0], Lambda_0_11_p4938_lanes[0]);

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_0_11_p4942_lanes = detail::make_lanes<Real>(Lambda_0_11_p3970_lanes[4],
      Lambda_0_11_p4894_lanes[2]) * detail::make_lanes<Real>(Lambda_0_11_p2415_lanes[4],
      Lambda_0_11_p1832_lanes[2]);
  const Lanes<8> Lambda_0_11_p4944_lanes = Lambda_0_11_p4940_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0],
      Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0],
      Lambda_0_11_p4898_lanes[0], Lambda_0_11_p4942_lanes[0], Lambda_0_11_p4942_lanes[0]);

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p4946_lanes = detail::make_lanes<Real>(Lambda_0_11_p3958_lanes[4],
      Lambda_0_11_p4888_lanes[2]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[4],
      Lambda_0_11_p2169_lanes[2]);
  const Lanes<8> Lambda_0_11_p4948_lanes = Lambda_0_11_p4944_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0],
      Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0],
      Lambda_0_11_p4892_lanes[0], Lambda_0_11_p4946_lanes[0], Lambda_0_11_p4946_lanes[0]);

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p4950_lanes = Lambda_0_11_p4948_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203,
      Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[4] *
      Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203,
      Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[5] *
      Lambda_0_11_p3203, Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203,
      Lambda_0_11_p3946_lanes[4] * Lambda_0_11_p3203);

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p4952_lanes = detail::make_lanes<Real>(Lambda_0_11_p4950_lanes[4],
      Lambda_0_11_p4950_lanes[4], Lambda_0_11_p4950_lanes[4], Lambda_0_11_p4950_lanes[4],
      Lambda_0_11_p4950_lanes[4], Lambda_0_11_p4950_lanes[5], Lambda_0_11_p3945 * Lambda_0_11_p3203,
      Lambda_0_11_p3944 * Lambda_0_11_p3203) + Lambda_0_11_p4884_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p4956_lanes = Lambda_0_11_p4952_lanes + Lambda_0_11_p4880_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p4960_lanes = Lambda_0_11_p4956_lanes + Lambda_0_11_p4876_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p4964_lanes = Lambda_0_11_p4960_lanes + Lambda_0_11_p4872_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p4968_lanes = Lambda_0_11_p4964_lanes + Lambda_0_11_p4868_lanes;
  const Lanes<8> Lambda_0_11_p4972_lanes = Lambda_0_11_p4968_lanes - Lambda_0_11_p4864_lanes;
  const Lanes<8> Lambda_0_11_p4976_lanes = Lambda_0_11_p4972_lanes - Lambda_0_11_p4860_lanes;
  const Lanes<8> Lambda_0_11_p4980_lanes = Lambda_0_11_p4976_lanes - Lambda_0_11_p4856_lanes;
  const Lanes<8> Lambda_0_11_p4984_lanes = Lambda_0_11_p4980_lanes - Lambda_0_11_p4852_lanes;
  const Real Lambda_0_11_p4988 = 1.0 / Lambda_0_11_p4984_lanes[4];
  const Lanes<8> Lambda_0_11_p4989_lanes = Lambda_0_11_p4844_lanes * Lambda_0_11_p4988;
  const Lanes<8> Lambda_0_11_p4993_lanes = Lambda_0_11_p4989_lanes * Lambda_0_11_p4984_lanes[5];
  const Lanes<8> Lambda_0_11_p4997_lanes = Lambda_0_11_p4768_lanes * Lambda_0_11_p4762_lanes[5];
  const Lanes<8> Lambda_0_11_p5001_lanes = Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[5];
  const Lanes<8> Lambda_0_11_p5005_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[5];
  const Lanes<8> Lambda_0_11_p5009_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[5];
  const Lanes<8> Lambda_0_11_p5013_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5017_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[5];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5021_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5025_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3456;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5029_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[5];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5033_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3202;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5037_lanes = Lambda_0_11_p5033_lanes + Lambda_0_11_p5029_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5041_lanes = Lambda_0_11_p5037_lanes + Lambda_0_11_p5025_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5045_lanes = Lambda_0_11_p5041_lanes + Lambda_0_11_p5021_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5049_lanes = Lambda_0_11_p5045_lanes + Lambda_0_11_p5017_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5053_lanes = Lambda_0_11_p5049_lanes + Lambda_0_11_p5013_lanes;
  const Lanes<8> Lambda_0_11_p5057_lanes = Lambda_0_11_p5053_lanes - Lambda_0_11_p5009_lanes;
  const Lanes<8> Lambda_0_11_p5061_lanes = Lambda_0_11_p5057_lanes - Lambda_0_11_p5005_lanes;
  const Lanes<8> Lambda_0_11_p5065_lanes = Lambda_0_11_p5061_lanes - Lambda_0_11_p5001_lanes;
  const Lanes<8> Lambda_0_11_p5069_lanes = Lambda_0_11_p5065_lanes - Lambda_0_11_p4997_lanes;
  const Lanes<8> Lambda_0_11_p5073_lanes = Lambda_0_11_p5069_lanes - Lambda_0_11_p4993_lanes;
  const Lanes<8> Lambda_0_11_p5077_lanes = Lambda_0_11_p4984_lanes * Lambda_0_11_p4988;
  const Lanes<8> Lambda_0_11_p5080_lanes = Lambda_0_11_p5077_lanes * Lambda_0_11_p4984_lanes[5];
  const Lanes<8> Lambda_0_11_p5083_lanes = Lambda_0_11_p4848_lanes * Lambda_0_11_p4762_lanes[5];
  const Lanes<8> Lambda_0_11_p5086_lanes = Lambda_0_11_p4637_lanes * Lambda_0_11_p4558_lanes[5];
  const Lanes<8> Lambda_0_11_p5089_lanes = Lambda_0_11_p4414_lanes * Lambda_0_11_p4342_lanes[5];
  const Lanes<8> Lambda_0_11_p5092_lanes = Lambda_0_11_p4182_lanes * Lambda_0_11_p4117_lanes[5];
  const Lanes<8> Lambda_0_11_p5095_lanes = Lambda_0_11_p3864_lanes * Lambda_0_11_p3792_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5098_lanes = Lambda_0_11_p3880_lanes * Lambda_0_11_p3704_lanes[5];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5101_lanes = Lambda_0_11_p3896_lanes * Lambda_0_11_p3584_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5104_lanes = Lambda_0_11_p3912_lanes * Lambda_0_11_p3456;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5107_lanes = Lambda_0_11_p3928_lanes * Lambda_0_11_p3360_lanes[5];

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p5110_lanes = detail::make_lanes<Real>(Lambda_0_11_p3958_lanes[5],
      Lambda_0_11_p4888_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p2451_lanes[5],
      Lambda_0_11_p2169_lanes[3]);

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_0_11_p5111_lanes = detail::make_lanes<Real>(Lambda_0_11_p3970_lanes[5],
      Lambda_0_11_p4894_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p2415_lanes[5],
      Lambda_0_11_p1832_lanes[3]);

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_0_11_p5112_lanes = detail::make_lanes<Real>(Lambda_0_11_p3982_lanes[5],
      Lambda_0_11_p4900_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p2331_lanes[5],
      Lambda_0_11_p1651_lanes[3]);

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p5113_lanes = detail::make_lanes<Real>(Lambda_0_11_p3994_lanes[5],
      Lambda_0_11_p4906_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p1975_lanes[5],
      Lambda_0_11_p1571_lanes[3]);

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p5114_lanes = detail::make_lanes<Real>(Lambda_0_11_p4006_lanes[5],
      Lambda_0_11_p4912_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p1710, Lambda_0_11_p1428);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p5115_lanes = detail::make_lanes<Real>(Lambda_0_11_p4018_lanes[5],
      Lambda_0_11_p4918_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p1523_lanes[5],
      Lambda_0_11_p1365_lanes[3]);

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5116_lanes = 1065.380700001509 *
      detail::make_lanes<Real>(Lambda_0_11_p1324, Lambda_0_11_p1277, Lambda_0_11_p1257,
      Lambda_0_11_p1237, Lambda_0_11_p1324, Lambda_0_11_p1324, Lambda_0_11_p1324,
      Lambda_0_11_p1324);

  // link 13 (left_hand), force propagation
  const Lanes<2> Lambda_0_11_p5119_lanes = detail::make_lanes<Real>(Lambda_0_11_p4031_lanes[5],
      Lambda_0_11_p5116_lanes[3]) * detail::make_lanes<Real>(Lambda_0_11_p1483_lanes[2],
      Lambda_0_11_p1237);

  // link 12 (left_wrist2), force propagation
  const Lanes<2> Lambda_0_11_p5120_lanes = Lambda_0_11_p5119_lanes + Lambda_0_11_p5115_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes<2> Lambda_0_11_p5121_lanes = Lambda_0_11_p5120_lanes + Lambda_0_11_p5114_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<2> Lambda_0_11_p5122_lanes = Lambda_0_11_p5121_lanes + Lambda_0_11_p5113_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<2> Lambda_0_11_p5123_lanes = Lambda_0_11_p5122_lanes + Lambda_0_11_p5112_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<2> Lambda_0_11_p5124_lanes = Lambda_0_11_p5123_lanes + Lambda_0_11_p5111_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes<2> Lambda_0_11_p5125_lanes = Lambda_0_11_p5124_lanes + Lambda_0_11_p5110_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5126_lanes = detail::make_lanes<Real>(Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p5125_lanes[0] +
      Lambda_0_11_p3946_lanes[5] * Lambda_0_11_p3202, Lambda_0_11_p3945 * Lambda_0_11_p3202,
      Lambda_0_11_p3944 * Lambda_0_11_p3202) + Lambda_0_11_p5107_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5129_lanes = Lambda_0_11_p5126_lanes + Lambda_0_11_p5104_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5132_lanes = Lambda_0_11_p5129_lanes + Lambda_0_11_p5101_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5135_lanes = Lambda_0_11_p5132_lanes + Lambda_0_11_p5098_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5138_lanes = Lambda_0_11_p5135_lanes + Lambda_0_11_p5095_lanes;
  const Lanes<8> Lambda_0_11_p5141_lanes = Lambda_0_11_p5138_lanes - Lambda_0_11_p5092_lanes;
  const Lanes<8> Lambda_0_11_p5144_lanes = Lambda_0_11_p5141_lanes - Lambda_0_11_p5089_lanes;
  const Lanes<8> Lambda_0_11_p5147_lanes = Lambda_0_11_p5144_lanes - Lambda_0_11_p5086_lanes;
  const Lanes<8> Lambda_0_11_p5150_lanes = Lambda_0_11_p5147_lanes - Lambda_0_11_p5083_lanes;
  const Lanes<8> Lambda_0_11_p5153_lanes = Lambda_0_11_p5150_lanes - Lambda_0_11_p5080_lanes;
  const Real Lambda_0_11_p5156 = 1.0 / Lambda_0_11_p5153_lanes[5];
  const Lanes<8> Lambda_0_11_p5157_lanes = Lambda_0_11_p5073_lanes * Lambda_0_11_p5156;
  const Lanes<8> Lambda_0_11_p5161_lanes = Lambda_0_11_p5157_lanes * Lambda_0_11_p5153_lanes[6];
  const Lanes<8> Lambda_0_11_p5165_lanes = Lambda_0_11_p4989_lanes * Lambda_0_11_p4984_lanes[6];
  const Lanes<8> Lambda_0_11_p5169_lanes = Lambda_0_11_p4768_lanes * Lambda_0_11_p4762_lanes[6];
  const Lanes<8> Lambda_0_11_p5173_lanes = Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[6];
  const Lanes<8> Lambda_0_11_p5177_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[6];
  const Lanes<8> Lambda_0_11_p5181_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[6];
  const Lanes<8> Lambda_0_11_p5185_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[6];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5189_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[6];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5193_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5197_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3453;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5201_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[6];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5205_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3201;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5209_lanes = Lambda_0_11_p4888_lanes * Lambda_0_11_p2222;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5213_lanes = Lambda_0_11_p4894_lanes * Lambda_0_11_p2219;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5217_lanes = Lambda_0_11_p4900_lanes * Lambda_0_11_p2213;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5221_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p2207;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5225_lanes = Lambda_0_11_p4912_lanes * Lambda_0_11_p2204;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5229_lanes = Lambda_0_11_p4918_lanes * Lambda_0_11_p1936;

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p5233 = 0.086 * Lambda_0_11_p1344;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5234_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p5233;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5238_lanes = Lambda_0_11_p5234_lanes + Lambda_0_11_p5229_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5242_lanes = Lambda_0_11_p5238_lanes + Lambda_0_11_p5225_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5246_lanes = Lambda_0_11_p5242_lanes + Lambda_0_11_p5221_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5250_lanes = Lambda_0_11_p5246_lanes + Lambda_0_11_p5217_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5254_lanes = Lambda_0_11_p5250_lanes + Lambda_0_11_p5213_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5258_lanes = Lambda_0_11_p5254_lanes + Lambda_0_11_p5209_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5262_lanes = Lambda_0_11_p5258_lanes + Lambda_0_11_p5205_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5266_lanes = Lambda_0_11_p5262_lanes + Lambda_0_11_p5201_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5270_lanes = Lambda_0_11_p5266_lanes + Lambda_0_11_p5197_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5274_lanes = Lambda_0_11_p5270_lanes + Lambda_0_11_p5193_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5278_lanes = Lambda_0_11_p5274_lanes + Lambda_0_11_p5189_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5282_lanes = Lambda_0_11_p5278_lanes + Lambda_0_11_p5185_lanes;
  const Lanes<8> Lambda_0_11_p5286_lanes = Lambda_0_11_p5282_lanes - Lambda_0_11_p5181_lanes;
  const Lanes<8> Lambda_0_11_p5290_lanes = Lambda_0_11_p5286_lanes - Lambda_0_11_p5177_lanes;
  const Lanes<8> Lambda_0_11_p5294_lanes = Lambda_0_11_p5290_lanes - Lambda_0_11_p5173_lanes;
  const Lanes<8> Lambda_0_11_p5298_lanes = Lambda_0_11_p5294_lanes - Lambda_0_11_p5169_lanes;
  const Lanes<8> Lambda_0_11_p5302_lanes = Lambda_0_11_p5298_lanes - Lambda_0_11_p5165_lanes;
  const Lanes<8> Lambda_0_11_p5306_lanes = Lambda_0_11_p5302_lanes - Lambda_0_11_p5161_lanes;
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
  const Lanes<8> Lambda_0_11_p5334_lanes = Lambda_0_11_p5317_lanes * Lambda_0_11_p5333;
  const Lanes<8> Lambda_0_11_p5338_lanes = Lambda_0_11_p5157_lanes * Lambda_0_11_p5153_lanes[7];
  const Lanes<8> Lambda_0_11_p5342_lanes = Lambda_0_11_p4989_lanes * Lambda_0_11_p4984_lanes[7];
  const Lanes<8> Lambda_0_11_p5346_lanes = Lambda_0_11_p4768_lanes * Lambda_0_11_p4762_lanes[7];
  const Lanes<8> Lambda_0_11_p5350_lanes = Lambda_0_11_p4565_lanes * Lambda_0_11_p4558_lanes[7];
  const Lanes<8> Lambda_0_11_p5354_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4342_lanes[7];
  const Lanes<8> Lambda_0_11_p5358_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p4117_lanes[7];
  const Lanes<8> Lambda_0_11_p5362_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3792_lanes[7];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5366_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3704_lanes[7];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5370_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3584_lanes[7];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5374_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3450;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5378_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p3360_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5382_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p3186;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5386_lanes = Lambda_0_11_p4888_lanes * Lambda_0_11_p2201;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5390_lanes = Lambda_0_11_p4894_lanes * Lambda_0_11_p2198;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5394_lanes = Lambda_0_11_p4900_lanes * Lambda_0_11_p2192;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5398_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p2186;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5402_lanes = Lambda_0_11_p4912_lanes * Lambda_0_11_p2183;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5406_lanes = Lambda_0_11_p4918_lanes * Lambda_0_11_p1918;

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p5410 = 0.086 * Lambda_0_11_p1339;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5411_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p5410;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5415_lanes = Lambda_0_11_p5411_lanes + Lambda_0_11_p5406_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5419_lanes = Lambda_0_11_p5415_lanes + Lambda_0_11_p5402_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5423_lanes = Lambda_0_11_p5419_lanes + Lambda_0_11_p5398_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5427_lanes = Lambda_0_11_p5423_lanes + Lambda_0_11_p5394_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5431_lanes = Lambda_0_11_p5427_lanes + Lambda_0_11_p5390_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5435_lanes = Lambda_0_11_p5431_lanes + Lambda_0_11_p5386_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5439_lanes = Lambda_0_11_p5435_lanes + Lambda_0_11_p5382_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5443_lanes = Lambda_0_11_p5439_lanes + Lambda_0_11_p5378_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5447_lanes = Lambda_0_11_p5443_lanes + Lambda_0_11_p5374_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5451_lanes = Lambda_0_11_p5447_lanes + Lambda_0_11_p5370_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5455_lanes = Lambda_0_11_p5451_lanes + Lambda_0_11_p5366_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5459_lanes = Lambda_0_11_p5455_lanes + Lambda_0_11_p5362_lanes;
  const Lanes<8> Lambda_0_11_p5463_lanes = Lambda_0_11_p5459_lanes - Lambda_0_11_p5358_lanes;
  const Lanes<8> Lambda_0_11_p5467_lanes = Lambda_0_11_p5463_lanes - Lambda_0_11_p5354_lanes;
  const Lanes<8> Lambda_0_11_p5471_lanes = Lambda_0_11_p5467_lanes - Lambda_0_11_p5350_lanes;
  const Lanes<8> Lambda_0_11_p5475_lanes = Lambda_0_11_p5471_lanes - Lambda_0_11_p5346_lanes;
  const Lanes<8> Lambda_0_11_p5479_lanes = Lambda_0_11_p5475_lanes - Lambda_0_11_p5342_lanes;
  const Lanes<8> Lambda_0_11_p5483_lanes = Lambda_0_11_p5479_lanes - Lambda_0_11_p5338_lanes;
  const Lanes<8> Lambda_0_11_p5487_lanes = Lambda_0_11_p5483_lanes - Lambda_0_11_p5334_lanes;
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
  const Lanes<8> Lambda_0_11_p5501_lanes = Lambda_0_11_p5497_lanes * Lambda_0_11_p5487_lanes[0];
  const Lanes<8> Lambda_0_11_p5505_lanes = Lambda_0_11_p5317_lanes * Lambda_0_11_p5306_lanes[0];
  const Lanes<8> Lambda_0_11_p5509_lanes = Lambda_0_11_p5157_lanes * Lambda_0_11_p5073_lanes[0];
  const Lanes<8> Lambda_0_11_p5513_lanes = Lambda_0_11_p4989_lanes * Lambda_0_11_p4844_lanes[0];
  const Lanes<8> Lambda_0_11_p5517_lanes = Lambda_0_11_p4768_lanes * Lambda_0_11_p4633_lanes[0];
  const Lanes<8> Lambda_0_11_p5521_lanes = Lambda_0_11_p4565_lanes * Lambda_0_11_p4410_lanes[0];
  const Lanes<8> Lambda_0_11_p5525_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4178_lanes[0];
  const Lanes<8> Lambda_0_11_p5529_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p3860_lanes[0];
  const Lanes<8> Lambda_0_11_p5533_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3164_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5537_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3117_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5541_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3057_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5545_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p3000;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5549_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p2945_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5553_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p2868;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5557_lanes = Lambda_0_11_p4888_lanes * Lambda_0_11_p2169_lanes[0];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5561_lanes = Lambda_0_11_p4894_lanes * Lambda_0_11_p1832_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5565_lanes = Lambda_0_11_p4900_lanes * Lambda_0_11_p1651_lanes[0];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5569_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p1571_lanes[0];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5573_lanes = Lambda_0_11_p4912_lanes * Lambda_0_11_p1431;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5577_lanes = Lambda_0_11_p4918_lanes * Lambda_0_11_p1365_lanes[0];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5581_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p1324;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5585_lanes = Lambda_0_11_p5581_lanes + Lambda_0_11_p5577_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5589_lanes = Lambda_0_11_p5585_lanes + Lambda_0_11_p5573_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5593_lanes = Lambda_0_11_p5589_lanes + Lambda_0_11_p5569_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5597_lanes = Lambda_0_11_p5593_lanes + Lambda_0_11_p5565_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5601_lanes = Lambda_0_11_p5597_lanes + Lambda_0_11_p5561_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5605_lanes = Lambda_0_11_p5601_lanes + Lambda_0_11_p5557_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5609_lanes = Lambda_0_11_p5605_lanes + Lambda_0_11_p5553_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5613_lanes = Lambda_0_11_p5609_lanes + Lambda_0_11_p5549_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5617_lanes = Lambda_0_11_p5613_lanes + Lambda_0_11_p5545_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5621_lanes = Lambda_0_11_p5617_lanes + Lambda_0_11_p5541_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5625_lanes = Lambda_0_11_p5621_lanes + Lambda_0_11_p5537_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5629_lanes = Lambda_0_11_p5625_lanes + Lambda_0_11_p5533_lanes;
  const Lanes<8> Lambda_0_11_p5633_lanes = Lambda_0_11_p5629_lanes - Lambda_0_11_p5529_lanes;
  const Lanes<8> Lambda_0_11_p5637_lanes = Lambda_0_11_p5633_lanes - Lambda_0_11_p5525_lanes;
  const Lanes<8> Lambda_0_11_p5641_lanes = Lambda_0_11_p5637_lanes - Lambda_0_11_p5521_lanes;
  const Lanes<8> Lambda_0_11_p5645_lanes = Lambda_0_11_p5641_lanes - Lambda_0_11_p5517_lanes;
  const Lanes<8> Lambda_0_11_p5649_lanes = Lambda_0_11_p5645_lanes - Lambda_0_11_p5513_lanes;
  const Lanes<8> Lambda_0_11_p5653_lanes = Lambda_0_11_p5649_lanes - Lambda_0_11_p5509_lanes;
  const Lanes<8> Lambda_0_11_p5657_lanes = Lambda_0_11_p5653_lanes - Lambda_0_11_p5505_lanes;
  const Lanes<8> Lambda_0_11_p5661_lanes = Lambda_0_11_p5657_lanes - Lambda_0_11_p5501_lanes;
  const Real Lambda_0_11_p5665 = 1.0 / Lambda_0_11_p5661_lanes[0];
  const Lanes<8> Lambda_0_11_p5666_lanes = Lambda_0_11_p5661_lanes * Lambda_0_11_p5665;
  const Lanes<8> Lambda_0_11_p5669_lanes = Lambda_0_11_p5666_lanes * Lambda_0_11_p5661_lanes[1];
  const Lanes<8> Lambda_0_11_p5672_lanes = Lambda_0_11_p5497_lanes * Lambda_0_11_p5487_lanes[1];
  const Lanes<8> Lambda_0_11_p5675_lanes = Lambda_0_11_p5317_lanes * Lambda_0_11_p5306_lanes[1];
  const Lanes<8> Lambda_0_11_p5678_lanes = Lambda_0_11_p5157_lanes * Lambda_0_11_p5073_lanes[1];
  const Lanes<8> Lambda_0_11_p5681_lanes = Lambda_0_11_p4989_lanes * Lambda_0_11_p4844_lanes[1];
  const Lanes<8> Lambda_0_11_p5684_lanes = Lambda_0_11_p4768_lanes * Lambda_0_11_p4633_lanes[1];
  const Lanes<8> Lambda_0_11_p5687_lanes = Lambda_0_11_p4565_lanes * Lambda_0_11_p4410_lanes[1];
  const Lanes<8> Lambda_0_11_p5690_lanes = Lambda_0_11_p4350_lanes * Lambda_0_11_p4178_lanes[1];
  const Lanes<8> Lambda_0_11_p5693_lanes = Lambda_0_11_p4126_lanes * Lambda_0_11_p3860_lanes[1];
  const Lanes<8> Lambda_0_11_p5696_lanes = Lambda_0_11_p3168_lanes * Lambda_0_11_p3164_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5699_lanes = Lambda_0_11_p3804_lanes * Lambda_0_11_p3117_lanes[1];

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5702_lanes = Lambda_0_11_p3812_lanes * Lambda_0_11_p3057_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5705_lanes = Lambda_0_11_p3820_lanes * Lambda_0_11_p2997;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5708_lanes = Lambda_0_11_p3828_lanes * Lambda_0_11_p2945_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5711_lanes = Lambda_0_11_p3836_lanes * Lambda_0_11_p2853;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5714_lanes = Lambda_0_11_p4888_lanes * Lambda_0_11_p2169_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5717_lanes = Lambda_0_11_p4894_lanes * Lambda_0_11_p1832_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5720_lanes = Lambda_0_11_p4900_lanes * Lambda_0_11_p1651_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5723_lanes = Lambda_0_11_p4906_lanes * Lambda_0_11_p1571_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5726_lanes = Lambda_0_11_p4912_lanes * Lambda_0_11_p1430;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5729_lanes = Lambda_0_11_p4918_lanes * Lambda_0_11_p1365_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5732_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p1277;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5735_lanes = Lambda_0_11_p5732_lanes + Lambda_0_11_p5729_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5738_lanes = Lambda_0_11_p5735_lanes + Lambda_0_11_p5726_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5741_lanes = Lambda_0_11_p5738_lanes + Lambda_0_11_p5723_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5744_lanes = Lambda_0_11_p5741_lanes + Lambda_0_11_p5720_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5747_lanes = Lambda_0_11_p5744_lanes + Lambda_0_11_p5717_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5750_lanes = Lambda_0_11_p5747_lanes + Lambda_0_11_p5714_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> Lambda_0_11_p5753_lanes = Lambda_0_11_p5750_lanes + Lambda_0_11_p5711_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> Lambda_0_11_p5756_lanes = Lambda_0_11_p5753_lanes + Lambda_0_11_p5708_lanes;

  // link 4 (chest1), force propagation
  const Lanes<8> Lambda_0_11_p5759_lanes = Lambda_0_11_p5756_lanes + Lambda_0_11_p5705_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> Lambda_0_11_p5762_lanes = Lambda_0_11_p5759_lanes + Lambda_0_11_p5702_lanes;

  // link 2 (thigh), force propagation
  const Lanes<8> Lambda_0_11_p5765_lanes = Lambda_0_11_p5762_lanes + Lambda_0_11_p5699_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> Lambda_0_11_p5768_lanes = Lambda_0_11_p5765_lanes + Lambda_0_11_p5696_lanes;
  const Lanes<8> Lambda_0_11_p5771_lanes = Lambda_0_11_p5768_lanes - Lambda_0_11_p5693_lanes;
  const Lanes<8> Lambda_0_11_p5774_lanes = Lambda_0_11_p5771_lanes - Lambda_0_11_p5690_lanes;
  const Lanes<8> Lambda_0_11_p5777_lanes = Lambda_0_11_p5774_lanes - Lambda_0_11_p5687_lanes;
  const Lanes<8> Lambda_0_11_p5780_lanes = Lambda_0_11_p5777_lanes - Lambda_0_11_p5684_lanes;
  const Lanes<8> Lambda_0_11_p5783_lanes = Lambda_0_11_p5780_lanes - Lambda_0_11_p5681_lanes;
  const Lanes<8> Lambda_0_11_p5786_lanes = Lambda_0_11_p5783_lanes - Lambda_0_11_p5678_lanes;
  const Lanes<8> Lambda_0_11_p5789_lanes = Lambda_0_11_p5786_lanes - Lambda_0_11_p5675_lanes;
  const Lanes<8> Lambda_0_11_p5792_lanes = Lambda_0_11_p5789_lanes - Lambda_0_11_p5672_lanes;
  const Lanes<8> Lambda_0_11_p5795_lanes = Lambda_0_11_p5792_lanes - Lambda_0_11_p5669_lanes;
  const Real Lambda_0_11_p5798 = 1.0 / Lambda_0_11_p5795_lanes[1];
  const Real Lambda_0_11_p5799 = Lambda_0_11_p5795_lanes[3] * Lambda_0_11_p5798;

  // link 20 (right_hand), force propagation
  const Lanes<8> Lambda_0_11_p5800_lanes = Lambda_0_11_p5116_lanes * Lambda_0_11_p1257;

  // link 19 (right_wrist2), force propagation
  const Lanes<8> Lambda_0_11_p5802_lanes = Lambda_0_11_p5800_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4926_lanes[1],
      Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4922_lanes[1], Lambda_0_11_p4926_lanes[1],
      Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4926_lanes[1], Lambda_0_11_p4926_lanes[1]);

  // link 18 (right_wrist1), force propagation
  const Lanes<8> Lambda_0_11_p5804_lanes = Lambda_0_11_p5802_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4930_lanes[1],
      Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4916_lanes[1], Lambda_0_11_p4930_lanes[1],
      Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4930_lanes[1], Lambda_0_11_p4930_lanes[1]);

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> Lambda_0_11_p5806_lanes = Lambda_0_11_p5804_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4934_lanes[1],
      Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4910_lanes[1], Lambda_0_11_p4934_lanes[1],
      Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4934_lanes[1], Lambda_0_11_p4934_lanes[1]);

  // link 16 (right_upperarm), force propagation
  const Lanes<8> Lambda_0_11_p5808_lanes = Lambda_0_11_p5806_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4938_lanes[1],
      Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4904_lanes[1], Lambda_0_11_p4938_lanes[1],
      Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4938_lanes[1], Lambda_0_11_p4938_lanes[1]);

  // link 15 (right_shoulder2), force propagation
  const Lanes<8> Lambda_0_11_p5810_lanes = Lambda_0_11_p5808_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4942_lanes[1],
      Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4898_lanes[1], Lambda_0_11_p4942_lanes[1],
      Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4942_lanes[1], Lambda_0_11_p4942_lanes[1]);

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> Lambda_0_11_p5812_lanes = Lambda_0_11_p5810_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p4946_lanes[1], Lambda_0_11_p4946_lanes[1],
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
