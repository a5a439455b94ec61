// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 1247 flops (add 491, mul 744, div 12), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  const Real angles[6] = {q[7], q[6], q[4], q[5], q[2], q[3]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c8 = cosines[0];
  const Real c7 = cosines[1];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c5 = cosines[2];
  const Real c6 = cosines[3];
  const Real c3 = cosines[4];
  const Real c4 = cosines[5];
  const Real s3 = sines[4];
  const Real s4 = sines[5];
  const Real s7 = sines[1];
  const Real s8 = sines[0];

  // link 8 (link5), articulated inertia
  const Real inverse_D7_p1 = 0.00024215999999999997 * s8;
  const Real inverse_D6_p1 = 0.0028799999999999997 * s8;
  const Real inverse_D6_p2 = 0.012916407125949915 * s8;
  const Real inverse_D5_p1 = 0.4318 * c5;
  const Real inverse_D5_p2 = 0.4318 * s5;
  const Real inverse_D7_p2 = s8 * inverse_D7_p1;
  const Real inverse_D6_p3 = s8 * inverse_D6_p2;
  const Real inverse_D6_p4 = c8 * inverse_D6_p2;
  const Real inverse_D6_p5 = c8 * inverse_D7_p1;
  const Real inverse_D4_p1 = s5 * c6 + c5 * s6;
  const Real inverse_D4_p2 = s5 * s6 - c5 * c6;
  const Real inverse_D6_p6 = inverse_D6_p3 - 0.012916407125949915;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p7 = c7 * inverse_D6_p4;
  const Real inverse_D4_p3 = s7 * inverse_D6_p4;
  const Real inverse_D7 = 1.0 / (0.0016 + inverse_D7_p2);

  // link 7 (link4), force propagation
  const Real inverse_D4_p4 = c7 * inverse_D4_p1;
  const Real inverse_D4_p5 = 0.0203 * inverse_D4_p1 - 0.4331 * inverse_D4_p2;
  const Real inverse_D4_p6 = 0.0203 * inverse_D4_p2 + 0.4331 * inverse_D4_p1;
  const Real inverse_D4_p7 = 0.025374999999999998 * inverse_D4_p2 + 0.861795 * inverse_D4_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p8 = inverse_D6_p1 * inverse_D7;
  const Real inverse_D6_p9 = inverse_D6_p5 * inverse_D7;
  const Real inverse_D6_p10 = inverse_D6_p1 * inverse_D6_p8;
  const Real inverse_D6_p11 = inverse_D6_p5 * inverse_D6_p8 - 0.0028799999999999997 * c8;
  const Real inverse_D6_p12 = 0.0011921599999999998 - inverse_D7_p2 - inverse_D6_p5 * inverse_D6_p9;
  const Real inverse_D6_p13 = s7 * (inverse_D6_p6 + inverse_D6_p10);
  const Real inverse_D6_p14 = c7 * inverse_D6_p11;
  const Real inverse_D6_p15 = s7 * (inverse_D6_p12 - 0.00065);
  const Real inverse_D6_p16 = s7 * inverse_D6_p13;
  const Real inverse_D6_p17 = c7 * inverse_D6_p14;
  const Real inverse_D4_p8 = c7 * inverse_D6_p13;
  const Real inverse_D4_p9 = s7 * inverse_D6_p14;
  const Real inverse_D6_p18 = s7 * inverse_D6_p15;
  const Real inverse_D6_p19 = inverse_D6_p6 - inverse_D6_p16;
  const Real inverse_D6_p20 = inverse_D6_p17 - inverse_D6_p11;
  const Real inverse_D4_p10 = inverse_D4_p1 * inverse_D4_p9;
  const Real inverse_D4_p11 = inverse_D6_p16 - inverse_D6_p10;
  const Real inverse_D4_p12 = inverse_D4_p1 * inverse_D6_p17;
  const Real inverse_D6_p21 = inverse_D4_p1 * inverse_D6_p20;
  const Real inverse_D6_p22 = inverse_D4_p2 * inverse_D6_p20;
  const Real inverse_D4_p13 = inverse_D4_p2 * inverse_D4_p8 - inverse_D4_p1 * inverse_D4_p3;
  const Real inverse_D4_p14 = inverse_D4_p1 * inverse_D4_p8 + inverse_D4_p2 * inverse_D4_p3;
  const Real inverse_D4_p15 = inverse_D4_p1 * inverse_D4_p10;
  const Real inverse_D4_p16 = inverse_D4_p2 * inverse_D4_p10;
  const Real inverse_D4_p17 = inverse_D4_p6 * inverse_D4_p14;
  const Real inverse_D4_p18 = inverse_D4_p6 * inverse_D4_p11 - inverse_D4_p12;
  const Real inverse_D6_p23 = inverse_D4_p1 * (inverse_D6_p19 + inverse_D6_p3) + inverse_D4_p2 *
      (2.0 * inverse_D6_p7);
  const Real Lambda_5_5_p1 = s3 * c4 + c3 * s4;
  const Real inverse_D6_p24 = inverse_D4_p1 * inverse_D6_p23;
  const Real inverse_D4_p19 = inverse_D4_p9 - (inverse_D4_p5 * inverse_D4_p13 - inverse_D4_p17);
  const Real Lambda_5_5_p2 = c3 * c4 - s3 * s4;

  // link 7 (link4), pose
  const Real Lambda_5_5_p3 = inverse_D4_p2 * Lambda_5_5_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p25 = inverse_D6_p7 - inverse_D4_p2 * inverse_D6_p23;
  const Real inverse_D6_p26 = inverse_D6_p24 - inverse_D6_p3;
  const Real inverse_D6_p27 = inverse_D6_p19 - inverse_D6_p24;

  // link 7 (link4), pose
  const Real Lambda_5_5_p4 = inverse_D4_p1 * Lambda_5_5_p1;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p20 = 3.153482265 - s5 * (1.601861202 * s5 + 0.0141984 * c5) +
      inverse_D4_p6 * (inverse_D4_p18 - inverse_D4_p12);

  // link 7 (link4), pose
  const Real Lambda_5_5_p5 = inverse_D4_p2 * Lambda_5_5_p2;
  const Real Lambda_5_5_p6 = inverse_D4_p1 * Lambda_5_5_p2;
  const Real Lambda_5_5_p7 = s7 * inverse_D4_p1;

  // link 8 (link5), pose
  const Real Lambda_5_5_p8 = s8 * inverse_D4_p2 - c8 * inverse_D4_p4;

  // link 7 (link4), pose
  const Real Lambda_5_5_p9 = s7 * Lambda_5_5_p2 - c7 * Lambda_5_5_p3;
  const Real Lambda_5_5_p10 = s7 * Lambda_5_5_p3 + c7 * Lambda_5_5_p2;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p28 = inverse_D6_p21 + (inverse_D4_p5 * inverse_D6_p25 + inverse_D4_p6 *
      inverse_D6_p26);
  const Real inverse_D6_p29 = inverse_D6_p22 - (inverse_D4_p5 * inverse_D6_p27 + inverse_D4_p6 *
      inverse_D6_p25);

  // link 7 (link4), pose
  const Real Lambda_5_5_p11 = c7 * Lambda_5_5_p5 + s7 * Lambda_5_5_p1;

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p12 = 4.484863585399276 * Lambda_5_5_p7;

  // link 7 (link4), pose
  const Real Lambda_5_5_p13 = s7 * Lambda_5_5_p5 - c7 * Lambda_5_5_p1;

  // link 9 (link6), force propagation
  const Real Lambda_5_5_p14 = -(0.05625 * Lambda_5_5_p7);

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p15 = 4.484863585399276 * Lambda_5_5_p10;

  // link 7 (link4), articulated inertia
  const Real inverse_D5_p3 = inverse_D4_p7 + inverse_D6_p28;
  const Real inverse_D5_p4 = inverse_D6_p29 - (0.025374999999999998 * inverse_D4_p1 - 0.861795 *
      inverse_D4_p2);
  const Real inverse_D4_p21 = 0.004704000000000001 * inverse_D4_p2 +
      (inverse_D4_p6 * (inverse_D4_p15 + inverse_D4_p19) - inverse_D4_p5 * inverse_D4_p16 -
      inverse_D4_p4 * inverse_D6_p15);

  // link 8 (link5), pose
  const Real Lambda_5_5_p16 = c8 * Lambda_5_5_p9 - s8 * Lambda_5_5_p4;

  // link 9 (link6), force propagation
  const Real Lambda_5_5_p17 = -(0.05625 * Lambda_5_5_p10);

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p18 = 0.7477264233212907 * Lambda_5_5_p8;
  const Real Lambda_5_5_p19 = 4.484863585399276 * Lambda_5_5_p13;

  // link 8 (link5), pose
  const Real Lambda_5_5_p20 = c8 * Lambda_5_5_p11 + s8 * Lambda_5_5_p6;

  // link 9 (link6), force propagation
  const Real Lambda_5_5_p21 = -(0.05625 * Lambda_5_5_p13);

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p22 = 0.7477264233212907 * Lambda_5_5_p16;

  // link 8 (link5), pose
  const Real Lambda_5_5_p23 = s8 * Lambda_5_5_p9 + c8 * Lambda_5_5_p4;

  // link 9 (link6), force propagation
  const Real Lambda_5_5_p24 = -Lambda_5_5_p20;

  // link 7 (link4), force propagation
  const Real Lambda_5_5_p31 = -(c8 * Lambda_5_5_p12);
  const Real Lambda_5_5_p32 = -(c8 * Lambda_5_5_p15);

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p33 = s8 * Lambda_5_5_p12;

  // link 9 (link6), force propagation
  const Real Lambda_5_5_p34 = -(s8 * inverse_D4_p4 + c8 * inverse_D4_p2);

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p35 = -Lambda_5_5_p34;
  const Real Lambda_5_5_p36 = -Lambda_5_5_p23;
  const Real Lambda_5_5_p37 = s8 * Lambda_5_5_p15;

  // link 9 (link6), force propagation
  const Real Lambda_5_5_p38 = -(s8 * Lambda_5_5_p11 - c8 * Lambda_5_5_p6);

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p39 = -Lambda_5_5_p38;
  const Real Lambda_5_5_p43 = s8 * Lambda_5_5_p19;

  // link 9 (link6), force propagation
  const Real Lambda_5_5_p44 = -(0.05625 * Lambda_5_5_p20);

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_5_5_p45_lanes = -(s8 * detail::make_pack<Real>(Lambda_5_5_p21,
      Lambda_5_5_p17, Lambda_5_5_p14, Lambda_5_5_p24, Lambda_5_5_p16, Lambda_5_5_p8, Lambda_5_5_p21,
      Lambda_5_5_p21));
  const Lanes<8> Lambda_5_5_p54_lanes = inverse_D6_p8 * Lambda_5_5_p45_lanes;
  const Real Lambda_5_5_p57 = -(c8 * Lambda_5_5_p19);

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p30 = 0.312455249 + (0.00065 + inverse_D6_p18 +
      (inverse_D4_p6 * (inverse_D6_p21 + inverse_D6_p28) - inverse_D4_p5 *
      (inverse_D6_p22 + inverse_D6_p29)));

  // link 6 (link3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p30;

  // link 8 (link5), force propagation
  const Real Lambda_5_5_p73 = Lambda_5_5_p24 - 4.484863585399276 * Lambda_5_5_p44;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_5_5_p74_lanes = detail::make_pack<Real>(Lambda_5_5_p13, Lambda_5_5_p10,
      Lambda_5_5_p7, Lambda_5_5_p13, Lambda_5_5_p13, Lambda_5_5_p13, Lambda_5_5_p13,
      Lambda_5_5_p13) - inverse_D6_p8 * Lambda_5_5_p45_lanes;
  const Real Lambda_5_5_p80 = -(s8 * Lambda_5_5_p18 + c8 * Lambda_5_5_p35);
  const Real Lambda_5_5_p81 = -(s8 * Lambda_5_5_p22 + c8 * Lambda_5_5_p36);
  const Lanes<8> Lambda_5_5_p82_lanes = c8 * detail::make_pack<Real>(Lambda_5_5_p21, Lambda_5_5_p17,
      Lambda_5_5_p14, Lambda_5_5_p24, Lambda_5_5_p16, Lambda_5_5_p8, Lambda_5_5_p21,
      Lambda_5_5_p21) + inverse_D6_p9 * Lambda_5_5_p45_lanes;
  const Lanes<8> Lambda_5_5_p94_lanes = c7 * detail::make_pack<Real>(Lambda_5_5_p57, Lambda_5_5_p57,
      Lambda_5_5_p57, Lambda_5_5_p57, Lambda_5_5_p32, Lambda_5_5_p31, Lambda_5_5_p57,
      Lambda_5_5_p57) + s7 * Lambda_5_5_p54_lanes;

  // link 8 (link5), force propagation
  const Lanes<8> Lambda_5_5_p103_lanes = s8 * detail::make_pack<Real>(Lambda_5_5_p39,
      Lambda_5_5_p36, Lambda_5_5_p35, Lambda_5_5_p39, Lambda_5_5_p39, Lambda_5_5_p39,
      Lambda_5_5_p39, Lambda_5_5_p39) - c8 * detail::make_pack<Real>(Lambda_5_5_p73, Lambda_5_5_p22,
      Lambda_5_5_p18, Lambda_5_5_p73, Lambda_5_5_p73, Lambda_5_5_p73, Lambda_5_5_p73,
      Lambda_5_5_p73);

  // link 7 (link4), force propagation
  const Real Lambda_5_5_p106 = s7 * Lambda_5_5_p31 - c7 * Lambda_5_5_p54_lanes[5];
  const Real Lambda_5_5_p107 = -Lambda_5_5_p103_lanes[2];
  const Real Lambda_5_5_p108 = -Lambda_5_5_p103_lanes[1];
  const Real Lambda_5_5_p109 = -Lambda_5_5_p103_lanes[0];
  const Real Lambda_5_5_p113 = -(s8 * Lambda_5_5_p73 + c8 * Lambda_5_5_p39);
  const Real Lambda_5_5_p132 = s7 * Lambda_5_5_p32 - c7 * Lambda_5_5_p54_lanes[4];
  const Real Lambda_5_5_p139 = s7 * Lambda_5_5_p57 - c7 * Lambda_5_5_p54_lanes[3];

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p5 = inverse_D5_p3 * inverse_D6;
  const Real inverse_D5_p6 = inverse_D5_p4 * inverse_D6;
  const Real inverse_D4_p22 = inverse_D4_p19 * inverse_D6;
  const Real inverse_D4_p23 = inverse_D4_p21 * inverse_D6;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_5_5_p140_lanes = c7 * detail::make_pack<Real>(Lambda_5_5_p109,
      Lambda_5_5_p108, Lambda_5_5_p107, Lambda_5_5_p109, Lambda_5_5_p109, Lambda_5_5_p109,
      Lambda_5_5_p109, Lambda_5_5_p109) - s7 * Lambda_5_5_p74_lanes;
  const Lanes<8> Lambda_5_5_p143_lanes = s7 * detail::make_pack<Real>(Lambda_5_5_p109,
      Lambda_5_5_p108, Lambda_5_5_p107, Lambda_5_5_p109, Lambda_5_5_p109, Lambda_5_5_p109,
      Lambda_5_5_p109, Lambda_5_5_p109) + c7 * Lambda_5_5_p74_lanes;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p7 = inverse_D6_p25 + inverse_D5_p4 * inverse_D5_p5;
  const Real inverse_D5_p8 = inverse_D6_p27 - inverse_D5_p4 * inverse_D5_p6;
  const Real inverse_D4_p24 = inverse_D4_p13 - inverse_D5_p4 * inverse_D4_p22;
  const Real inverse_D4_p25 = inverse_D4_p16 + inverse_D4_p6 * inverse_D4_p13 - inverse_D4_p21 *
      inverse_D5_p6;
  const Real inverse_D4_p26 = inverse_D4_p11 - inverse_D4_p19 * inverse_D4_p22;
  const Real inverse_D4_p27 = inverse_D4_p7 + inverse_D4_p18 - inverse_D4_p21 * inverse_D4_p22;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_5_5_p164_lanes = inverse_D4_p1 *
      detail::make_pack<Real>(Lambda_5_5_p140_lanes[0], Lambda_5_5_p140_lanes[1],
      Lambda_5_5_p140_lanes[2], Lambda_5_5_p94_lanes[3], Lambda_5_5_p94_lanes[4],
      Lambda_5_5_p94_lanes[5], Lambda_5_5_p140_lanes[0], Lambda_5_5_p140_lanes[0]) + inverse_D4_p2 *
      detail::make_pack<Real>(Lambda_5_5_p113, Lambda_5_5_p81, Lambda_5_5_p80, Lambda_5_5_p43,
      Lambda_5_5_p37, Lambda_5_5_p33, Lambda_5_5_p113, Lambda_5_5_p113);
  const Lanes<8> Lambda_5_5_p170_lanes = inverse_D4_p2 *
      detail::make_pack<Real>(Lambda_5_5_p140_lanes[0], Lambda_5_5_p140_lanes[1],
      Lambda_5_5_p140_lanes[2], Lambda_5_5_p94_lanes[3], Lambda_5_5_p94_lanes[4],
      Lambda_5_5_p94_lanes[5], Lambda_5_5_p140_lanes[0], Lambda_5_5_p140_lanes[0]) - inverse_D4_p1 *
      detail::make_pack<Real>(Lambda_5_5_p113, Lambda_5_5_p81, Lambda_5_5_p80, Lambda_5_5_p43,
      Lambda_5_5_p37, Lambda_5_5_p33, Lambda_5_5_p113, Lambda_5_5_p113);

  // link 8 (link5), force propagation
  const Lanes<8> Lambda_5_5_p200_lanes = detail::make_pack<Real>(1557.24430048586,
      87.59499190232964, 87.59499190232964, 1557.24430048586, 1557.24430048586, 1557.24430048586,
      1557.24430048586, 1557.24430048586) * detail::make_pack<Real>(Lambda_5_5_p44, Lambda_5_5_p16,
      Lambda_5_5_p8, Lambda_5_5_p13, Lambda_5_5_p10, Lambda_5_5_p7, Lambda_5_5_p44, Lambda_5_5_p44);

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_5_5_p206_lanes = Lambda_5_5_p45_lanes * inverse_D7;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p9 = inverse_D5_p1 * inverse_D5_p7 - inverse_D5_p2 * inverse_D5_p8;
  const Real inverse_D4_p28 = inverse_D5_p1 * (inverse_D5_p3 * inverse_D4_p22 - inverse_D4_p14) -
      inverse_D5_p2 * inverse_D4_p24;
  const Real inverse_D2_p1 = 3.79559 * s5 + 0.10439999999999999 * c5 - inverse_D5_p9;
  const Real inverse_D4_p29 = inverse_D4_p25 + (inverse_D5_p1 * inverse_D4_p24 + 0.1501 *
      inverse_D5_p8);
  const Real inverse_D4_p30 = inverse_D4_p27 + (inverse_D5_p1 * inverse_D4_p26 + 0.1501 *
      inverse_D4_p24);

  // link 1 (base_x), articulated inertia
  const Real Lambda_5_5_p230 = 0.05625 * Lambda_5_5_p16;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p10 = inverse_D5_p1 * (inverse_D5_p1 *
      (inverse_D6_p26 - inverse_D5_p3 * inverse_D5_p5) - inverse_D5_p2 * inverse_D5_p7) -
      inverse_D5_p2 * inverse_D5_p9;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_5_5_p236_lanes = s7 * Lambda_5_5_p82_lanes +
      (inverse_D4_p6 * Lambda_5_5_p164_lanes - inverse_D4_p5 * Lambda_5_5_p170_lanes);

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_5_5_p277_lanes = Lambda_5_5_p236_lanes * inverse_D6;

  // link 1 (base_x), articulated inertia
  const Real Lambda_5_5_p283 = 0.05625 * Lambda_5_5_p8;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + inverse_D5_p10);

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p31 = inverse_D5_p2 * inverse_D4_p25 - inverse_D5_p1 *
      (inverse_D4_p21 * inverse_D5_p5 - (inverse_D4_p15 + inverse_D4_p17) + inverse_D4_p28) -
      0.1501 * inverse_D5_p9;

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_5_5_p293_lanes = Lambda_5_5_p170_lanes - inverse_D5_p6 *
      Lambda_5_5_p236_lanes;
  const Lanes<8> Lambda_5_5_p305_lanes = detail::make_pack<Real>(Lambda_5_5_p143_lanes[0],
      Lambda_5_5_p143_lanes[1], Lambda_5_5_p143_lanes[2], Lambda_5_5_p139, Lambda_5_5_p132,
      Lambda_5_5_p106, Lambda_5_5_p143_lanes[0], Lambda_5_5_p143_lanes[0]) - inverse_D4_p22 *
      Lambda_5_5_p236_lanes;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p32 = 0.690314699 * s5 + 0.023750999999999998 * c5 + inverse_D4_p31;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p33 = inverse_D4_p20 - inverse_D4_p21 * inverse_D4_p23 + 0.1501 *
      (inverse_D4_p25 + inverse_D4_p29) + inverse_D5_p1 * (inverse_D4_p27 + inverse_D4_p30);

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_5_5_p375_lanes = Lambda_5_5_p277_lanes * Lambda_5_5_p236_lanes[3];
  const Lanes<8> Lambda_5_5_p378_lanes = inverse_D5_p2 * Lambda_5_5_p293_lanes - inverse_D5_p1 *
      (-Lambda_5_5_p164_lanes + inverse_D5_p5 * Lambda_5_5_p236_lanes);

  // link 9 (link6), force propagation
  const Lanes<8> Lambda_5_5_p384_lanes = 24999.999999999996 *
      detail::make_pack<Real>(Lambda_5_5_p38, Lambda_5_5_p38, Lambda_5_5_p38, Lambda_5_5_p38,
      Lambda_5_5_p23, Lambda_5_5_p34, Lambda_5_5_p38, Lambda_5_5_p38);

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_5_5_p390_lanes = 0.1501 * Lambda_5_5_p293_lanes + inverse_D5_p1 *
      Lambda_5_5_p305_lanes;
  const Lanes<8> Lambda_5_5_p403_lanes = inverse_D4_p6 *
      detail::make_pack<Real>(Lambda_5_5_p143_lanes[0], Lambda_5_5_p143_lanes[1],
      Lambda_5_5_p143_lanes[2], Lambda_5_5_p139, Lambda_5_5_p132, Lambda_5_5_p106,
      Lambda_5_5_p143_lanes[0], Lambda_5_5_p143_lanes[0]) - inverse_D4_p4 * Lambda_5_5_p82_lanes -
      inverse_D4_p23 * Lambda_5_5_p236_lanes + Lambda_5_5_p390_lanes;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p34 = inverse_D4_p32 * inverse_D5;
  const Real inverse_D2_p2 = inverse_D2_p1 * inverse_D5;
  const Real inverse_D2_p3 = inverse_D4_p28 * inverse_D5;

  // link 5 (link2), force propagation
  const Lanes<8> Lambda_5_5_p412_lanes = Lambda_5_5_p378_lanes * inverse_D5;
  const Lanes<8> Lambda_5_5_p439_lanes = Lambda_5_5_p412_lanes * Lambda_5_5_p378_lanes[0];
  const Lanes<8> Lambda_5_5_p445_lanes = Lambda_5_5_p412_lanes * Lambda_5_5_p378_lanes[1];
  const Lanes<8> Lambda_5_5_p450_lanes = Lambda_5_5_p412_lanes * Lambda_5_5_p378_lanes[2];

  // link 5 (link2), articulated inertia
  const Real inverse_D2_p4 = inverse_D4_p30 - (0.10439999999999999 * s5 - 3.79559 * c5) +
      inverse_D4_p32 * inverse_D2_p3;

  // link 5 (link2), force propagation
  const Lanes<8> Lambda_5_5_p460_lanes = Lambda_5_5_p403_lanes - inverse_D4_p34 *
      Lambda_5_5_p378_lanes;
  const Lanes<8> Lambda_5_5_p478_lanes = Lambda_5_5_p200_lanes * Lambda_5_5_p44 +
      Lambda_5_5_p206_lanes * Lambda_5_5_p45_lanes[0] + Lambda_5_5_p277_lanes *
      Lambda_5_5_p236_lanes[0] + Lambda_5_5_p439_lanes;
  const Lanes<8> Lambda_5_5_p484_lanes = Lambda_5_5_p200_lanes * Lambda_5_5_p230 +
      Lambda_5_5_p206_lanes * Lambda_5_5_p45_lanes[1] + Lambda_5_5_p277_lanes *
      Lambda_5_5_p236_lanes[1] + Lambda_5_5_p445_lanes;
  const Lanes<8> Lambda_5_5_p489_lanes = Lambda_5_5_p200_lanes * Lambda_5_5_p283 +
      Lambda_5_5_p206_lanes * Lambda_5_5_p45_lanes[2] + Lambda_5_5_p277_lanes *
      Lambda_5_5_p236_lanes[2] + Lambda_5_5_p450_lanes;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p35 = inverse_D4_p33 - inverse_D4_p32 * inverse_D4_p34 +
      (0.298925024 * inverse_D4_p1 + 0.021347276999999998 * inverse_D4_p2 + inverse_D4_p1 *
      (inverse_D6_p12 - inverse_D6_p18)) * inverse_D4_p1;
  const Real inverse_D2_p5 = 4.9338049999999996 + (inverse_D4_p29 - inverse_D4_p32 * inverse_D2_p2);

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_5_5_p493_lanes = Lambda_5_5_p384_lanes * Lambda_5_5_p38 +
      Lambda_5_5_p200_lanes * Lambda_5_5_p13 + Lambda_5_5_p206_lanes * Lambda_5_5_p45_lanes[3] +
      Lambda_5_5_p375_lanes;

  // link 9 (link6), force propagation
  const Lanes<8> Lambda_5_5_p496_lanes = Lambda_5_5_p384_lanes * Lambda_5_5_p23;

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / inverse_D4_p35;

  // link 5 (link2), force propagation
  const Real Lambda_5_5_p507 = Lambda_5_5_p496_lanes[4] + Lambda_5_5_p200_lanes[4] *
      Lambda_5_5_p10 + Lambda_5_5_p206_lanes[4] * Lambda_5_5_p45_lanes[4] +
      Lambda_5_5_p277_lanes[4] * Lambda_5_5_p236_lanes[4] + Lambda_5_5_p412_lanes[4] *
      Lambda_5_5_p378_lanes[4];

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p6 = inverse_D2_p4 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p5 * inverse_D4;

  // link 4 (link1), force propagation
  const Lanes<8> Lambda_5_5_p508_lanes = Lambda_5_5_p460_lanes * inverse_D4;

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p8 = inverse_D2_p5 * inverse_D2_p6 -
      (inverse_D4_p24 + inverse_D2_p1 * inverse_D2_p3);
  const Real inverse_D2_p9 = inverse_D5_p8 - inverse_D2_p1 * inverse_D2_p2 - inverse_D2_p5 *
      inverse_D2_p7;
  const Real inverse_D2_p10 = inverse_D4_p26 - inverse_D4_p28 * inverse_D2_p3 - inverse_D2_p4 *
      inverse_D2_p6;

  // link 4 (link1), force propagation
  const Lanes<8> Lambda_5_5_p544_lanes = -(Lambda_5_5_p293_lanes - inverse_D2_p2 *
      Lambda_5_5_p378_lanes) + inverse_D2_p7 * Lambda_5_5_p460_lanes;
  const Lanes<8> Lambda_5_5_p550_lanes = Lambda_5_5_p305_lanes + inverse_D2_p3 *
      Lambda_5_5_p378_lanes - inverse_D2_p6 * Lambda_5_5_p460_lanes;
  const Lanes<8> Lambda_5_5_p598_lanes = Lambda_5_5_p1 * Lambda_5_5_p544_lanes + Lambda_5_5_p2 *
      Lambda_5_5_p550_lanes;

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p11 = Lambda_5_5_p1 * (inverse_D2_p9 - inverse_D2_p10) + Lambda_5_5_p2 *
      (2.0 * inverse_D2_p8);

  // link 5 (link2), force propagation
  const Real Lambda_5_5_p610 = Lambda_5_5_p496_lanes[5] + Lambda_5_5_p200_lanes[5] *
      Lambda_5_5_p10 + Lambda_5_5_p206_lanes[5] * Lambda_5_5_p45_lanes[4] +
      Lambda_5_5_p277_lanes[5] * Lambda_5_5_p236_lanes[4] + Lambda_5_5_p412_lanes[5] *
      Lambda_5_5_p378_lanes[4];

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p12 = Lambda_5_5_p1 * inverse_D2_p11;

  // link 5 (link2), force propagation
  const Real Lambda_5_5_p611 = Lambda_5_5_p384_lanes[5] * Lambda_5_5_p34 +
      Lambda_5_5_p200_lanes[5] * Lambda_5_5_p7 + Lambda_5_5_p206_lanes[5] *
      Lambda_5_5_p45_lanes[5] + Lambda_5_5_p277_lanes[5] * Lambda_5_5_p236_lanes[5] +
      Lambda_5_5_p412_lanes[5] * Lambda_5_5_p378_lanes[5];

  // link 4 (link1), articulated inertia
  const Real inverse_D1_p1 = Lambda_5_5_p2 * inverse_D2_p11 - inverse_D2_p8;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (inverse_D2_p10 + inverse_D2_p12));
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 2 (base_y), force propagation
  const Lanes<8> Lambda_5_5_p612_lanes = Lambda_5_5_p598_lanes * inverse_D2;
  const Lanes<8> Lambda_5_5_p642_lanes = Lambda_5_5_p2 * Lambda_5_5_p544_lanes - Lambda_5_5_p1 *
      Lambda_5_5_p550_lanes - inverse_D1_p2 * Lambda_5_5_p598_lanes;
  const Lanes<8> Lambda_5_5_p663_lanes = Lambda_5_5_p493_lanes + Lambda_5_5_p412_lanes *
      Lambda_5_5_p378_lanes[3] + Lambda_5_5_p508_lanes * Lambda_5_5_p460_lanes[3] +
      Lambda_5_5_p612_lanes * Lambda_5_5_p598_lanes[3];

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (inverse_D2_p9 - inverse_D2_p12) - inverse_D1_p1 *
      inverse_D1_p2);

  // link 1 (base_x), force propagation
  const Lanes<8> Lambda_5_5_p666_lanes = Lambda_5_5_p642_lanes * inverse_D1;
  const Lanes<8> Lambda_5_5_p690_lanes = Lambda_5_5_p478_lanes + Lambda_5_5_p508_lanes *
      Lambda_5_5_p460_lanes[0] + Lambda_5_5_p612_lanes * Lambda_5_5_p598_lanes[0] +
      Lambda_5_5_p666_lanes * Lambda_5_5_p642_lanes[0];
  const Lanes<8> Lambda_5_5_p696_lanes = Lambda_5_5_p484_lanes + Lambda_5_5_p508_lanes *
      Lambda_5_5_p460_lanes[1] + Lambda_5_5_p612_lanes * Lambda_5_5_p598_lanes[1] +
      Lambda_5_5_p666_lanes * Lambda_5_5_p642_lanes[1];
  const Lanes<8> Lambda_5_5_p701_lanes = Lambda_5_5_p489_lanes + Lambda_5_5_p508_lanes *
      Lambda_5_5_p460_lanes[2] + Lambda_5_5_p612_lanes * Lambda_5_5_p598_lanes[2] +
      Lambda_5_5_p666_lanes * Lambda_5_5_p642_lanes[2];
  const Real Lambda_5_5_p708 = Lambda_5_5_p690_lanes[0] * Lambda_5_5_p690_lanes[0];
  const Real Lambda_5_5_p709 = Lambda_5_5_p708 * Lambda_5_5_p690_lanes[0];
  const Real Lambda_5_5_p710 = Lambda_5_5_p709 * Lambda_5_5_p708 /
      (1.262177448353619e-29 + Lambda_5_5_p709 * Lambda_5_5_p709);
  const Lanes<8> Lambda_5_5_p711_lanes = Lambda_5_5_p690_lanes * Lambda_5_5_p710;
  const Lanes<8> Lambda_5_5_p728_lanes = Lambda_5_5_p696_lanes - Lambda_5_5_p711_lanes *
      Lambda_5_5_p690_lanes[1];
  const Real Lambda_5_5_p740 = Lambda_5_5_p507 + Lambda_5_5_p508_lanes[4] *
      Lambda_5_5_p460_lanes[4] + Lambda_5_5_p612_lanes[4] * Lambda_5_5_p598_lanes[4] +
      Lambda_5_5_p666_lanes[4] * Lambda_5_5_p642_lanes[4] - Lambda_5_5_p711_lanes[4] *
      Lambda_5_5_p690_lanes[4];
  const Real Lambda_5_5_p741 = Lambda_5_5_p610 + Lambda_5_5_p508_lanes[5] *
      Lambda_5_5_p460_lanes[4] + Lambda_5_5_p612_lanes[5] * Lambda_5_5_p598_lanes[4] +
      Lambda_5_5_p666_lanes[5] * Lambda_5_5_p642_lanes[4] - Lambda_5_5_p711_lanes[5] *
      Lambda_5_5_p690_lanes[4];
  const Real Lambda_5_5_p742 = Lambda_5_5_p611 + Lambda_5_5_p508_lanes[5] *
      Lambda_5_5_p460_lanes[5] + Lambda_5_5_p612_lanes[5] * Lambda_5_5_p598_lanes[5] +
      Lambda_5_5_p666_lanes[5] * Lambda_5_5_p642_lanes[5] - Lambda_5_5_p711_lanes[5] *
      Lambda_5_5_p690_lanes[5];
  const Real Lambda_5_5_p743 = Lambda_5_5_p728_lanes[1] * Lambda_5_5_p728_lanes[1];
  const Real Lambda_5_5_p744 = Lambda_5_5_p743 * Lambda_5_5_p728_lanes[1];
  const Real Lambda_5_5_p745 = Lambda_5_5_p744 * Lambda_5_5_p743 /
      (1.9721522630525295e-31 + Lambda_5_5_p744 * Lambda_5_5_p744);
  const Lanes<8> Lambda_5_5_p746_lanes = Lambda_5_5_p728_lanes * Lambda_5_5_p745;
  const Real Lambda_0_0_p1 = Lambda_5_5_p711_lanes[1] * Lambda_5_5_p745;
  const Lanes<8> Lambda_5_5_p757_lanes = Lambda_5_5_p701_lanes - Lambda_5_5_p711_lanes *
      Lambda_5_5_p690_lanes[2] - Lambda_5_5_p746_lanes * Lambda_5_5_p728_lanes[2];
  const Lanes<8> Lambda_5_5_p761_lanes = Lambda_5_5_p663_lanes + Lambda_5_5_p666_lanes *
      Lambda_5_5_p642_lanes[3] - Lambda_5_5_p711_lanes * Lambda_5_5_p690_lanes[3] -
      Lambda_5_5_p746_lanes * Lambda_5_5_p728_lanes[3];
  const Real Lambda_0_0_p2 = Lambda_5_5_p746_lanes[2] * Lambda_5_5_p711_lanes[1] -
      Lambda_5_5_p711_lanes[2];
  const Real Lambda_5_5_p764 = Lambda_5_5_p757_lanes[2] * Lambda_5_5_p757_lanes[2];
  const Real Lambda_5_5_p765 = Lambda_5_5_p764 * Lambda_5_5_p757_lanes[2];
  const Real Lambda_5_5_p766 = Lambda_5_5_p765 * Lambda_5_5_p764 /
      (3.0814879110195774e-33 + Lambda_5_5_p765 * Lambda_5_5_p765);
  const Lanes<8> Lambda_5_5_p767_lanes = Lambda_5_5_p757_lanes * Lambda_5_5_p766;
  const Real Lambda_0_0_p3 = Lambda_0_0_p2 * Lambda_5_5_p766;
  const Real Lambda_0_1_p1 = Lambda_5_5_p746_lanes[2] * Lambda_5_5_p766;
  const Lanes<8> Lambda_5_5_p773_lanes = Lambda_5_5_p761_lanes - Lambda_5_5_p767_lanes *
      Lambda_5_5_p757_lanes[3];
  const Real Lambda_0_0_p4 = Lambda_5_5_p746_lanes[3] * Lambda_5_5_p711_lanes[1] -
      Lambda_5_5_p711_lanes[3] - Lambda_5_5_p767_lanes[3] * Lambda_0_0_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p767_lanes[3] * Lambda_5_5_p746_lanes[2] -
      Lambda_5_5_p746_lanes[3];
  const Real Lambda_5_5_p776 = Lambda_5_5_p773_lanes[3] * Lambda_5_5_p773_lanes[3];
  const Real Lambda_5_5_p777 = Lambda_5_5_p776 * Lambda_5_5_p773_lanes[3];
  const Real Lambda_5_5_p778 = Lambda_5_5_p777 * Lambda_5_5_p776 /
      (5.960464477539063e-08 + Lambda_5_5_p777 * Lambda_5_5_p777);
  const Real Lambda_5_5_p779 = Lambda_5_5_p773_lanes[4] * Lambda_5_5_p778;
  const Real Lambda_5_5_p780 = Lambda_5_5_p773_lanes[5] * Lambda_5_5_p778;
  const Real Lambda_0_0_p5 = Lambda_0_0_p4 * Lambda_5_5_p778;
  const Real Lambda_0_1_p3 = Lambda_0_1_p2 * Lambda_5_5_p778;
  const Real Lambda_0_2_p1 = Lambda_5_5_p767_lanes[3] * Lambda_5_5_p778;
  const Real Lambda_5_5_p781 = Lambda_5_5_p740 - Lambda_5_5_p746_lanes[4] *
      Lambda_5_5_p728_lanes[4] - Lambda_5_5_p767_lanes[4] * Lambda_5_5_p757_lanes[4] -
      Lambda_5_5_p779 * Lambda_5_5_p773_lanes[4];
  const Real Lambda_5_5_p782 = Lambda_5_5_p741 - Lambda_5_5_p746_lanes[5] *
      Lambda_5_5_p728_lanes[4] - Lambda_5_5_p767_lanes[5] * Lambda_5_5_p757_lanes[4] -
      Lambda_5_5_p780 * Lambda_5_5_p773_lanes[4];
  const Real Lambda_0_0_p6 = Lambda_5_5_p746_lanes[4] * Lambda_5_5_p711_lanes[1] -
      Lambda_5_5_p711_lanes[4] - Lambda_5_5_p767_lanes[4] * Lambda_0_0_p2 - Lambda_5_5_p779 *
      Lambda_0_0_p4;
  const Real Lambda_0_1_p4 = Lambda_5_5_p767_lanes[4] * Lambda_5_5_p746_lanes[2] -
      Lambda_5_5_p746_lanes[4] - Lambda_5_5_p779 * Lambda_0_1_p2;
  const Real Lambda_0_2_p2 = Lambda_5_5_p779 * Lambda_5_5_p767_lanes[3] - Lambda_5_5_p767_lanes[4];
  const Real Lambda_5_5_p783 = Lambda_5_5_p781 * Lambda_5_5_p781;
  const Real Lambda_5_5_p784 = Lambda_5_5_p783 * Lambda_5_5_p781;
  const Real Lambda_5_5_p785 = Lambda_5_5_p784 * Lambda_5_5_p783 /
      (1.3552527156068805e-20 + Lambda_5_5_p784 * Lambda_5_5_p784);
  const Real Lambda_5_5_p786 = Lambda_5_5_p782 * Lambda_5_5_p785;
  const Real Lambda_0_0_p7 = Lambda_0_0_p6 * Lambda_5_5_p785;
  const Real Lambda_0_1_p5 = Lambda_0_1_p4 * Lambda_5_5_p785;
  const Real Lambda_0_2_p3 = Lambda_0_2_p2 * Lambda_5_5_p785;
  const Real Lambda_0_3_p1 = Lambda_5_5_p779 * Lambda_5_5_p785;
  const Real Lambda_5_5_p787 = Lambda_5_5_p742 - Lambda_5_5_p746_lanes[5] *
      Lambda_5_5_p728_lanes[5] - Lambda_5_5_p767_lanes[5] * Lambda_5_5_p757_lanes[5] -
      Lambda_5_5_p780 * Lambda_5_5_p773_lanes[5] - Lambda_5_5_p786 * Lambda_5_5_p782;
  const Real Lambda_0_5_p1 = Lambda_5_5_p746_lanes[5] * Lambda_5_5_p711_lanes[1] -
      Lambda_5_5_p711_lanes[5] - Lambda_5_5_p767_lanes[5] * Lambda_0_0_p2 - Lambda_5_5_p780 *
      Lambda_0_0_p4 - Lambda_5_5_p786 * Lambda_0_0_p6;
  const Real Lambda_1_5_p1 = Lambda_5_5_p767_lanes[5] * Lambda_5_5_p746_lanes[2] -
      Lambda_5_5_p746_lanes[5] - Lambda_5_5_p780 * Lambda_0_1_p2 - Lambda_5_5_p786 * Lambda_0_1_p4;
  const Real Lambda_2_5_p1 = Lambda_5_5_p780 * Lambda_5_5_p767_lanes[3] - Lambda_5_5_p767_lanes[5] -
      Lambda_5_5_p786 * Lambda_0_2_p2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p786 * Lambda_5_5_p779 - Lambda_5_5_p780;
  const Real Lambda_0_0_p8 = Lambda_5_5_p710 + Lambda_0_0_p1 * Lambda_5_5_p711_lanes[1] +
      Lambda_0_0_p3 * Lambda_0_0_p2 + Lambda_0_0_p5 * Lambda_0_0_p4 + Lambda_0_0_p7 * Lambda_0_0_p6;
  const Real Lambda_5_5_p788 = Lambda_5_5_p787 * Lambda_5_5_p787;
  const Real Lambda_5_5_p789 = Lambda_5_5_p788 * Lambda_5_5_p787;
  const Real Lambda_5_5 = Lambda_5_5_p789 * Lambda_5_5_p788 /
      (2.117582368135751e-22 + Lambda_5_5_p789 * Lambda_5_5_p789);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = Lambda_0_5_p1 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_1_5 = Lambda_1_5_p1 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_2_5 = Lambda_2_5_p1 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_3_5 = Lambda_3_5_p1 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_4_5 = Lambda_5_5_p786 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  Lambda[0] = Lambda_0_0_p8 + Lambda_0_5 * Lambda_0_5_p1;
  const Real Lambda_0_1 = Lambda_0_1_p3 * Lambda_0_0_p4 -
      (Lambda_0_0_p1 + Lambda_0_1_p1 * Lambda_0_0_p2) + Lambda_0_1_p5 * Lambda_0_0_p6 + Lambda_1_5 *
      Lambda_0_5_p1;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_2_p1 * Lambda_0_0_p4 + Lambda_0_2_p3 *
      Lambda_0_0_p6 + Lambda_2_5 * Lambda_0_5_p1;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_0_3 = Lambda_0_0_p5 - Lambda_0_3_p1 * Lambda_0_0_p6 + Lambda_3_5 *
      Lambda_0_5_p1;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_0_4 = Lambda_0_0_p7 - Lambda_4_5 * Lambda_0_5_p1;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = Lambda_5_5_p745 + Lambda_0_1_p1 * Lambda_5_5_p746_lanes[2] + Lambda_0_1_p3 *
      Lambda_0_1_p2 + Lambda_0_1_p5 * Lambda_0_1_p4 + Lambda_1_5 * Lambda_1_5_p1;
  const Real Lambda_1_2 = Lambda_0_2_p3 * Lambda_0_1_p4 -
      (Lambda_0_1_p1 + Lambda_0_2_p1 * Lambda_0_1_p2) + Lambda_2_5 * Lambda_1_5_p1;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_0_1_p3 - Lambda_0_3_p1 * Lambda_0_1_p4 + Lambda_3_5 *
      Lambda_1_5_p1;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_0_1_p5 - Lambda_4_5 * Lambda_1_5_p1;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = Lambda_5_5_p766 + Lambda_0_2_p1 * Lambda_5_5_p767_lanes[3] + Lambda_0_2_p3 *
      Lambda_0_2_p2 + Lambda_2_5 * Lambda_2_5_p1;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p1 -
      (Lambda_0_2_p1 + Lambda_0_3_p1 * Lambda_0_2_p2);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p3 - Lambda_4_5 * Lambda_2_5_p1;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p778 + Lambda_0_3_p1 * Lambda_5_5_p779 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p785 + Lambda_4_5 * Lambda_5_5_p786;
}

}  // namespace samm

#undef TREELINE_RESTRICT
