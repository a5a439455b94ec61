// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 1001 flops (add 395, mul 600, div 6), sine and cosine of 6 angles
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
void lambda_inverse(const Real (&TREELINE_RESTRICT q)[9],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
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
  const Real Lambda_inv_0_1_p1 = s3 * c4 + c3 * s4;
  const Real inverse_D6_p24 = inverse_D4_p1 * inverse_D6_p23;
  const Real inverse_D4_p19 = inverse_D4_p9 - (inverse_D4_p5 * inverse_D4_p13 - inverse_D4_p17);
  const Real Lambda_inv_0_0_p1 = c3 * c4 - s3 * s4;

  // link 7 (link4), pose
  const Real Lambda_inv_0_1_p2 = inverse_D4_p2 * Lambda_inv_0_1_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p25 = inverse_D6_p7 - inverse_D4_p2 * inverse_D6_p23;
  const Real inverse_D6_p26 = inverse_D6_p24 - inverse_D6_p3;
  const Real inverse_D6_p27 = inverse_D6_p19 - inverse_D6_p24;

  // link 7 (link4), pose
  const Real Lambda_inv_0_1_p3 = inverse_D4_p1 * Lambda_inv_0_1_p1;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p20 = 3.153482265 - s5 * (1.601861202 * s5 + 0.0141984 * c5) +
      inverse_D4_p6 * (inverse_D4_p18 - inverse_D4_p12);

  // link 7 (link4), pose
  const Real Lambda_inv_0_0_p2 = inverse_D4_p2 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_0_p3 = inverse_D4_p1 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_2_p1 = s7 * inverse_D4_p1;

  // link 8 (link5), pose
  const Real Lambda_inv_0_2_p2 = s8 * inverse_D4_p2 - c8 * inverse_D4_p4;

  // link 7 (link4), pose
  const Real Lambda_inv_0_1_p4 = s7 * Lambda_inv_0_0_p1 - c7 * Lambda_inv_0_1_p2;
  const Real Lambda_inv_0_1_p5 = s7 * Lambda_inv_0_1_p2 + c7 * Lambda_inv_0_0_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p28 = inverse_D6_p21 + (inverse_D4_p5 * inverse_D6_p25 + inverse_D4_p6 *
      inverse_D6_p26);
  const Real inverse_D6_p29 = inverse_D6_p22 - (inverse_D4_p5 * inverse_D6_p27 + inverse_D4_p6 *
      inverse_D6_p25);

  // link 7 (link4), pose
  const Real Lambda_inv_0_0_p4 = c7 * Lambda_inv_0_0_p2 + s7 * Lambda_inv_0_1_p1;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_5_p1 = 4.484863585399276 * Lambda_inv_0_2_p1;

  // link 7 (link4), pose
  const Real Lambda_inv_0_0_p5 = s7 * Lambda_inv_0_0_p2 - c7 * Lambda_inv_0_1_p1;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_2_p3 = -(0.05625 * Lambda_inv_0_2_p1);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_4_p1 = 4.484863585399276 * Lambda_inv_0_1_p5;

  // link 7 (link4), articulated inertia
  const Real inverse_D5_p3 = inverse_D4_p7 + inverse_D6_p28;
  const Real inverse_D5_p4 = inverse_D6_p29 - (0.025374999999999998 * inverse_D4_p1 - 0.861795 *
      inverse_D4_p2);
  const Real inverse_D4_p21 = 0.004704000000000001 * inverse_D4_p2 +
      (inverse_D4_p6 * (inverse_D4_p15 + inverse_D4_p19) - inverse_D4_p5 * inverse_D4_p16 -
      inverse_D4_p4 * inverse_D6_p15);

  // link 8 (link5), pose
  const Real Lambda_inv_0_1_p6 = c8 * Lambda_inv_0_1_p4 - s8 * Lambda_inv_0_1_p3;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_1_p7 = -(0.05625 * Lambda_inv_0_1_p5);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_2_p4 = 0.7477264233212907 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_3_p1 = 4.484863585399276 * Lambda_inv_0_0_p5;

  // link 8 (link5), pose
  const Real Lambda_inv_0_0_p6 = c8 * Lambda_inv_0_0_p4 + s8 * Lambda_inv_0_0_p3;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_0_p7 = -(0.05625 * Lambda_inv_0_0_p5);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_1_p8 = 0.7477264233212907 * Lambda_inv_0_1_p6;

  // link 8 (link5), pose
  const Real Lambda_inv_0_1_p9 = s8 * Lambda_inv_0_1_p4 + c8 * Lambda_inv_0_1_p3;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_3_p2 = -Lambda_inv_0_0_p6;

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_5_p3 = -(c8 * Lambda_inv_0_5_p1);
  const Real Lambda_inv_0_4_p3 = -(c8 * Lambda_inv_0_4_p1);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_5_p4 = s8 * Lambda_inv_0_5_p1;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_2_p6 = -(s8 * inverse_D4_p4 + c8 * inverse_D4_p2);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_2_p7 = -Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_1_p11 = -Lambda_inv_0_1_p9;
  const Real Lambda_inv_0_4_p4 = s8 * Lambda_inv_0_4_p1;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_0_p9 = -(s8 * Lambda_inv_0_0_p4 - c8 * Lambda_inv_0_0_p3);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_0_p10 = -Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_3_p4 = s8 * Lambda_inv_0_3_p1;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_0_p12 = -(0.05625 * Lambda_inv_0_0_p6);

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_inv_0_0_p13_lanes = -(s8 * detail::make_pack<Real>(Lambda_inv_0_0_p7,
      Lambda_inv_0_1_p7, Lambda_inv_0_2_p3, Lambda_inv_0_3_p2, Lambda_inv_0_1_p6, Lambda_inv_0_2_p2,
      Lambda_inv_0_0_p7, Lambda_inv_0_0_p7));
  const Lanes<8> Lambda_inv_0_3_p6_lanes = inverse_D6_p8 * Lambda_inv_0_0_p13_lanes;
  const Real Lambda_inv_0_3_p7 = -(c8 * Lambda_inv_0_3_p1);

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p30 = 0.312455249 + (0.00065 + inverse_D6_p18 +
      (inverse_D4_p6 * (inverse_D6_p21 + inverse_D6_p28) - inverse_D4_p5 *
      (inverse_D6_p22 + inverse_D6_p29)));

  // link 6 (link3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p30;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_0_p17 = Lambda_inv_0_3_p2 - 4.484863585399276 * Lambda_inv_0_0_p12;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_inv_0_0_p18_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p5,
      Lambda_inv_0_1_p5, Lambda_inv_0_2_p1, Lambda_inv_0_0_p5, Lambda_inv_0_0_p5, Lambda_inv_0_0_p5,
      Lambda_inv_0_0_p5, Lambda_inv_0_0_p5) - inverse_D6_p8 * Lambda_inv_0_0_p13_lanes;
  const Real Lambda_inv_0_2_p14 = -(s8 * Lambda_inv_0_2_p4 + c8 * Lambda_inv_0_2_p7);
  const Real Lambda_inv_0_1_p18 = -(s8 * Lambda_inv_0_1_p8 + c8 * Lambda_inv_0_1_p11);
  const Lanes<8> Lambda_inv_0_0_p19_lanes = c8 * detail::make_pack<Real>(Lambda_inv_0_0_p7,
      Lambda_inv_0_1_p7, Lambda_inv_0_2_p3, Lambda_inv_0_3_p2, Lambda_inv_0_1_p6, Lambda_inv_0_2_p2,
      Lambda_inv_0_0_p7, Lambda_inv_0_0_p7) + inverse_D6_p9 * Lambda_inv_0_0_p13_lanes;
  const Lanes<8> Lambda_inv_0_3_p13_lanes = c7 * detail::make_pack<Real>(Lambda_inv_0_3_p7,
      Lambda_inv_0_3_p7, Lambda_inv_0_3_p7, Lambda_inv_0_3_p7, Lambda_inv_0_4_p3, Lambda_inv_0_5_p3,
      Lambda_inv_0_3_p7, Lambda_inv_0_3_p7) + s7 * Lambda_inv_0_3_p6_lanes;

  // link 8 (link5), force propagation
  const Lanes<8> Lambda_inv_0_0_p23_lanes = s8 * detail::make_pack<Real>(Lambda_inv_0_0_p10,
      Lambda_inv_0_1_p11, Lambda_inv_0_2_p7, Lambda_inv_0_0_p10, Lambda_inv_0_0_p10,
      Lambda_inv_0_0_p10, Lambda_inv_0_0_p10, Lambda_inv_0_0_p10) - c8 *
      detail::make_pack<Real>(Lambda_inv_0_0_p17, Lambda_inv_0_1_p8, Lambda_inv_0_2_p4,
      Lambda_inv_0_0_p17, Lambda_inv_0_0_p17, Lambda_inv_0_0_p17, Lambda_inv_0_0_p17,
      Lambda_inv_0_0_p17);

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_5_p14 = s7 * Lambda_inv_0_5_p3 - c7 * Lambda_inv_0_3_p6_lanes[5];
  const Real Lambda_inv_0_2_p20 = -Lambda_inv_0_0_p23_lanes[2];
  const Real Lambda_inv_0_1_p24 = -Lambda_inv_0_0_p23_lanes[1];
  const Real Lambda_inv_0_0_p24 = -Lambda_inv_0_0_p23_lanes[0];
  const Real Lambda_inv_0_0_p26 = -(s8 * Lambda_inv_0_0_p17 + c8 * Lambda_inv_0_0_p10);
  const Real Lambda_inv_0_4_p16 = s7 * Lambda_inv_0_4_p3 - c7 * Lambda_inv_0_3_p6_lanes[4];
  const Real Lambda_inv_0_3_p18 = s7 * Lambda_inv_0_3_p7 - c7 * Lambda_inv_0_3_p6_lanes[3];

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p5 = inverse_D5_p3 * inverse_D6;
  const Real inverse_D5_p6 = inverse_D5_p4 * inverse_D6;
  const Real inverse_D4_p22 = inverse_D4_p19 * inverse_D6;
  const Real inverse_D4_p23 = inverse_D4_p21 * inverse_D6;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_inv_0_0_p32_lanes = c7 * detail::make_pack<Real>(Lambda_inv_0_0_p24,
      Lambda_inv_0_1_p24, Lambda_inv_0_2_p20, Lambda_inv_0_0_p24, Lambda_inv_0_0_p24,
      Lambda_inv_0_0_p24, Lambda_inv_0_0_p24, Lambda_inv_0_0_p24) - s7 * Lambda_inv_0_0_p18_lanes;
  const Lanes<8> Lambda_inv_0_0_p33_lanes = s7 * detail::make_pack<Real>(Lambda_inv_0_0_p24,
      Lambda_inv_0_1_p24, Lambda_inv_0_2_p20, Lambda_inv_0_0_p24, Lambda_inv_0_0_p24,
      Lambda_inv_0_0_p24, Lambda_inv_0_0_p24, Lambda_inv_0_0_p24) + c7 * Lambda_inv_0_0_p18_lanes;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p7 = inverse_D6_p25 + inverse_D5_p4 * inverse_D5_p5;
  const Real inverse_D5_p8 = inverse_D6_p27 - inverse_D5_p4 * inverse_D5_p6;
  const Real inverse_D4_p24 = inverse_D4_p13 - inverse_D5_p4 * inverse_D4_p22;
  const Real inverse_D4_p25 = inverse_D4_p16 + inverse_D4_p6 * inverse_D4_p13 - inverse_D4_p21 *
      inverse_D5_p6;
  const Real inverse_D4_p26 = inverse_D4_p11 - inverse_D4_p19 * inverse_D4_p22;
  const Real inverse_D4_p27 = inverse_D4_p7 + inverse_D4_p18 - inverse_D4_p21 * inverse_D4_p22;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_inv_0_0_p37_lanes = inverse_D4_p1 *
      detail::make_pack<Real>(Lambda_inv_0_0_p32_lanes[0], Lambda_inv_0_0_p32_lanes[1],
      Lambda_inv_0_0_p32_lanes[2], Lambda_inv_0_3_p13_lanes[3], Lambda_inv_0_3_p13_lanes[4],
      Lambda_inv_0_3_p13_lanes[5], Lambda_inv_0_0_p32_lanes[0], Lambda_inv_0_0_p32_lanes[0]) +
      inverse_D4_p2 * detail::make_pack<Real>(Lambda_inv_0_0_p26, Lambda_inv_0_1_p18,
      Lambda_inv_0_2_p14, Lambda_inv_0_3_p4, Lambda_inv_0_4_p4, Lambda_inv_0_5_p4,
      Lambda_inv_0_0_p26, Lambda_inv_0_0_p26);
  const Lanes<8> Lambda_inv_0_0_p38_lanes = inverse_D4_p2 *
      detail::make_pack<Real>(Lambda_inv_0_0_p32_lanes[0], Lambda_inv_0_0_p32_lanes[1],
      Lambda_inv_0_0_p32_lanes[2], Lambda_inv_0_3_p13_lanes[3], Lambda_inv_0_3_p13_lanes[4],
      Lambda_inv_0_3_p13_lanes[5], Lambda_inv_0_0_p32_lanes[0], Lambda_inv_0_0_p32_lanes[0]) -
      inverse_D4_p1 * detail::make_pack<Real>(Lambda_inv_0_0_p26, Lambda_inv_0_1_p18,
      Lambda_inv_0_2_p14, Lambda_inv_0_3_p4, Lambda_inv_0_4_p4, Lambda_inv_0_5_p4,
      Lambda_inv_0_0_p26, Lambda_inv_0_0_p26);

  // link 8 (link5), force propagation
  const Lanes<8> Lambda_inv_0_0_p43_lanes = detail::make_pack<Real>(1557.24430048586,
      87.59499190232964, 87.59499190232964, 1557.24430048586, 1557.24430048586, 1557.24430048586,
      1557.24430048586, 1557.24430048586) * detail::make_pack<Real>(Lambda_inv_0_0_p12,
      Lambda_inv_0_1_p6, Lambda_inv_0_2_p2, Lambda_inv_0_0_p5, Lambda_inv_0_1_p5, Lambda_inv_0_2_p1,
      Lambda_inv_0_0_p12, Lambda_inv_0_0_p12);

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_inv_0_0_p44_lanes = Lambda_inv_0_0_p13_lanes * inverse_D7;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p9 = inverse_D5_p1 * inverse_D5_p7 - inverse_D5_p2 * inverse_D5_p8;

  // link 1 (base_x), articulated inertia
  const Real Lambda_inv_1_1_p1 = 0.05625 * Lambda_inv_0_1_p6;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p28 = inverse_D5_p1 * (inverse_D5_p3 * inverse_D4_p22 - inverse_D4_p14) -
      inverse_D5_p2 * inverse_D4_p24;
  const Real inverse_D2_p1 = 3.79559 * s5 + 0.10439999999999999 * c5 - inverse_D5_p9;
  const Real inverse_D4_p29 = inverse_D4_p25 + (inverse_D5_p1 * inverse_D4_p24 + 0.1501 *
      inverse_D5_p8);
  const Real inverse_D4_p30 = inverse_D4_p27 + (inverse_D5_p1 * inverse_D4_p26 + 0.1501 *
      inverse_D4_p24);

  // link 1 (base_x), articulated inertia
  const Real Lambda_inv_2_2_p1 = 0.05625 * Lambda_inv_0_2_p2;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p10 = inverse_D5_p1 * (inverse_D5_p1 *
      (inverse_D6_p26 - inverse_D5_p3 * inverse_D5_p5) - inverse_D5_p2 * inverse_D5_p7) -
      inverse_D5_p2 * inverse_D5_p9;

  // link 7 (link4), force propagation
  const Lanes<8> Lambda_inv_0_0_p48_lanes = s7 * Lambda_inv_0_0_p19_lanes +
      (inverse_D4_p6 * Lambda_inv_0_0_p37_lanes - inverse_D4_p5 * Lambda_inv_0_0_p38_lanes);

  // link 9 (link6), force propagation
  const Lanes<8> Lambda_inv_3_3_p1_lanes = 24999.999999999996 *
      detail::make_pack<Real>(Lambda_inv_0_0_p9, Lambda_inv_0_0_p9, Lambda_inv_0_0_p9,
      Lambda_inv_0_0_p9, Lambda_inv_0_1_p9, Lambda_inv_0_2_p6, Lambda_inv_0_0_p9,
      Lambda_inv_0_0_p9);

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_inv_0_0_p54_lanes = Lambda_inv_0_0_p48_lanes * inverse_D6;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + inverse_D5_p10);

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p31 = inverse_D5_p2 * inverse_D4_p25 - inverse_D5_p1 *
      (inverse_D4_p21 * inverse_D5_p5 - (inverse_D4_p15 + inverse_D4_p17) + inverse_D4_p28) -
      0.1501 * inverse_D5_p9;

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_inv_0_0_p55_lanes = Lambda_inv_0_0_p38_lanes - inverse_D5_p6 *
      Lambda_inv_0_0_p48_lanes;
  const Lanes<8> Lambda_inv_0_0_p57_lanes = detail::make_pack<Real>(Lambda_inv_0_0_p33_lanes[0],
      Lambda_inv_0_0_p33_lanes[1], Lambda_inv_0_0_p33_lanes[2], Lambda_inv_0_3_p18,
      Lambda_inv_0_4_p16, Lambda_inv_0_5_p14, Lambda_inv_0_0_p33_lanes[0],
      Lambda_inv_0_0_p33_lanes[0]) - inverse_D4_p22 * Lambda_inv_0_0_p48_lanes;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p32 = 0.690314699 * s5 + 0.023750999999999998 * c5 + inverse_D4_p31;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p33 = inverse_D4_p20 - inverse_D4_p21 * inverse_D4_p23 + 0.1501 *
      (inverse_D4_p25 + inverse_D4_p29) + inverse_D5_p1 * (inverse_D4_p27 + inverse_D4_p30);

  // link 6 (link3), force propagation
  const Lanes<8> Lambda_inv_3_3_p6_lanes = Lambda_inv_0_0_p54_lanes * Lambda_inv_0_0_p48_lanes[3];
  const Lanes<8> Lambda_inv_0_0_p64_lanes = inverse_D5_p2 * Lambda_inv_0_0_p55_lanes -
      inverse_D5_p1 * (-Lambda_inv_0_0_p37_lanes + inverse_D5_p5 * Lambda_inv_0_0_p48_lanes);
  const Lanes<8> Lambda_inv_0_0_p66_lanes = 0.1501 * Lambda_inv_0_0_p55_lanes + inverse_D5_p1 *
      Lambda_inv_0_0_p57_lanes;
  const Lanes<8> Lambda_inv_3_3_p8_lanes = Lambda_inv_3_3_p1_lanes * Lambda_inv_0_0_p9 +
      Lambda_inv_0_0_p43_lanes * Lambda_inv_0_0_p5 + Lambda_inv_0_0_p44_lanes *
      Lambda_inv_0_0_p13_lanes[3] + Lambda_inv_3_3_p6_lanes;
  const Lanes<8> Lambda_inv_0_0_p67_lanes = inverse_D4_p6 *
      detail::make_pack<Real>(Lambda_inv_0_0_p33_lanes[0], Lambda_inv_0_0_p33_lanes[1],
      Lambda_inv_0_0_p33_lanes[2], Lambda_inv_0_3_p18, Lambda_inv_0_4_p16, Lambda_inv_0_5_p14,
      Lambda_inv_0_0_p33_lanes[0], Lambda_inv_0_0_p33_lanes[0]) - inverse_D4_p4 *
      Lambda_inv_0_0_p19_lanes - inverse_D4_p23 * Lambda_inv_0_0_p48_lanes +
      Lambda_inv_0_0_p66_lanes;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p34 = inverse_D4_p32 * inverse_D5;
  const Real inverse_D2_p2 = inverse_D2_p1 * inverse_D5;
  const Real inverse_D2_p3 = inverse_D4_p28 * inverse_D5;

  // link 5 (link2), force propagation
  const Lanes<8> Lambda_inv_0_0_p68_lanes = Lambda_inv_0_0_p64_lanes * inverse_D5;
  const Lanes<8> Lambda_inv_0_0_p72_lanes = Lambda_inv_0_0_p68_lanes * Lambda_inv_0_0_p64_lanes[0];
  const Lanes<8> Lambda_inv_1_1_p7_lanes = Lambda_inv_0_0_p68_lanes * Lambda_inv_0_0_p64_lanes[1];
  const Lanes<8> Lambda_inv_2_2_p7_lanes = Lambda_inv_0_0_p68_lanes * Lambda_inv_0_0_p64_lanes[2];

  // link 5 (link2), articulated inertia
  const Real inverse_D2_p4 = inverse_D4_p30 - (0.10439999999999999 * s5 - 3.79559 * c5) +
      inverse_D4_p32 * inverse_D2_p3;

  // link 5 (link2), force propagation
  const Lanes<8> Lambda_inv_0_0_p73_lanes = Lambda_inv_0_0_p67_lanes - inverse_D4_p34 *
      Lambda_inv_0_0_p64_lanes;
  const Lanes<8> Lambda_inv_0_0_p76_lanes = Lambda_inv_0_0_p43_lanes * Lambda_inv_0_0_p12 +
      Lambda_inv_0_0_p44_lanes * Lambda_inv_0_0_p13_lanes[0] + Lambda_inv_0_0_p54_lanes *
      Lambda_inv_0_0_p48_lanes[0] + Lambda_inv_0_0_p72_lanes;
  const Lanes<8> Lambda_inv_1_1_p8_lanes = Lambda_inv_0_0_p43_lanes * Lambda_inv_1_1_p1 +
      Lambda_inv_0_0_p44_lanes * Lambda_inv_0_0_p13_lanes[1] + Lambda_inv_0_0_p54_lanes *
      Lambda_inv_0_0_p48_lanes[1] + Lambda_inv_1_1_p7_lanes;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p35 = inverse_D4_p33 - inverse_D4_p32 * inverse_D4_p34 +
      (0.298925024 * inverse_D4_p1 + 0.021347276999999998 * inverse_D4_p2 + inverse_D4_p1 *
      (inverse_D6_p12 - inverse_D6_p18)) * inverse_D4_p1;
  const Real inverse_D2_p5 = 4.9338049999999996 + (inverse_D4_p29 - inverse_D4_p32 * inverse_D2_p2);

  // link 5 (link2), force propagation
  const Lanes<8> Lambda_inv_2_2_p8_lanes = Lambda_inv_0_0_p43_lanes * Lambda_inv_2_2_p1 +
      Lambda_inv_0_0_p44_lanes * Lambda_inv_0_0_p13_lanes[2] + Lambda_inv_0_0_p54_lanes *
      Lambda_inv_0_0_p48_lanes[2] + Lambda_inv_2_2_p7_lanes;
  const Real Lambda_inv_5_5_p1 = Lambda_inv_3_3_p1_lanes[5] * Lambda_inv_0_2_p6 +
      Lambda_inv_0_0_p43_lanes[5] * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p44_lanes[5] *
      Lambda_inv_0_0_p13_lanes[5] + Lambda_inv_0_0_p54_lanes[5] * Lambda_inv_0_0_p48_lanes[5] +
      Lambda_inv_0_0_p68_lanes[5] * Lambda_inv_0_0_p64_lanes[5];

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / inverse_D4_p35;
  const Real inverse_D2_p6 = inverse_D2_p4 * inverse_D4;
  const Real inverse_D2_p7 = inverse_D2_p5 * inverse_D4;

  // link 4 (link1), force propagation
  const Lanes<8> Lambda_inv_0_0_p78_lanes = Lambda_inv_0_0_p73_lanes * inverse_D4;

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p8 = inverse_D2_p5 * inverse_D2_p6 -
      (inverse_D4_p24 + inverse_D2_p1 * inverse_D2_p3);
  const Real inverse_D2_p9 = inverse_D5_p8 - inverse_D2_p1 * inverse_D2_p2 - inverse_D2_p5 *
      inverse_D2_p7;
  const Real inverse_D2_p10 = inverse_D4_p26 - inverse_D4_p28 * inverse_D2_p3 - inverse_D2_p4 *
      inverse_D2_p6;

  // link 4 (link1), force propagation
  const Lanes<8> Lambda_inv_0_0_p82_lanes = -(Lambda_inv_0_0_p55_lanes - inverse_D2_p2 *
      Lambda_inv_0_0_p64_lanes) + inverse_D2_p7 * Lambda_inv_0_0_p73_lanes;
  const Lanes<8> Lambda_inv_0_0_p83_lanes = Lambda_inv_0_0_p57_lanes + inverse_D2_p3 *
      Lambda_inv_0_0_p64_lanes - inverse_D2_p6 * Lambda_inv_0_0_p73_lanes;
  const Lanes<8> Lambda_inv_4_4_p6_lanes = Lambda_inv_3_3_p1_lanes * Lambda_inv_0_1_p9 +
      detail::make_pack<Real>(Lambda_inv_0_0_p43_lanes[4] * Lambda_inv_0_1_p5,
      Lambda_inv_0_0_p43_lanes[4] * Lambda_inv_0_1_p5, Lambda_inv_0_0_p43_lanes[4] *
      Lambda_inv_0_1_p5, Lambda_inv_0_0_p43_lanes[4] * Lambda_inv_0_1_p5,
      Lambda_inv_0_0_p43_lanes[4] * Lambda_inv_0_1_p5, Lambda_inv_0_0_p43_lanes[5] *
      Lambda_inv_0_1_p5, Lambda_inv_0_0_p43_lanes[4] * Lambda_inv_0_1_p5,
      Lambda_inv_0_0_p43_lanes[4] * Lambda_inv_0_1_p5) +
      detail::make_pack<Real>(Lambda_inv_0_0_p44_lanes[4] * Lambda_inv_0_0_p13_lanes[4],
      Lambda_inv_0_0_p44_lanes[4] * Lambda_inv_0_0_p13_lanes[4], Lambda_inv_0_0_p44_lanes[4] *
      Lambda_inv_0_0_p13_lanes[4], Lambda_inv_0_0_p44_lanes[4] * Lambda_inv_0_0_p13_lanes[4],
      Lambda_inv_0_0_p44_lanes[4] * Lambda_inv_0_0_p13_lanes[4], Lambda_inv_0_0_p44_lanes[5] *
      Lambda_inv_0_0_p13_lanes[4], Lambda_inv_0_0_p44_lanes[4] * Lambda_inv_0_0_p13_lanes[4],
      Lambda_inv_0_0_p44_lanes[4] * Lambda_inv_0_0_p13_lanes[4]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p54_lanes[4] * Lambda_inv_0_0_p48_lanes[4],
      Lambda_inv_0_0_p54_lanes[4] * Lambda_inv_0_0_p48_lanes[4], Lambda_inv_0_0_p54_lanes[4] *
      Lambda_inv_0_0_p48_lanes[4], Lambda_inv_0_0_p54_lanes[4] * Lambda_inv_0_0_p48_lanes[4],
      Lambda_inv_0_0_p54_lanes[4] * Lambda_inv_0_0_p48_lanes[4], Lambda_inv_0_0_p54_lanes[5] *
      Lambda_inv_0_0_p48_lanes[4], Lambda_inv_0_0_p54_lanes[4] * Lambda_inv_0_0_p48_lanes[4],
      Lambda_inv_0_0_p54_lanes[4] * Lambda_inv_0_0_p48_lanes[4]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p68_lanes[4] * Lambda_inv_0_0_p64_lanes[4],
      Lambda_inv_0_0_p68_lanes[4] * Lambda_inv_0_0_p64_lanes[4], Lambda_inv_0_0_p68_lanes[4] *
      Lambda_inv_0_0_p64_lanes[4], Lambda_inv_0_0_p68_lanes[4] * Lambda_inv_0_0_p64_lanes[4],
      Lambda_inv_0_0_p68_lanes[4] * Lambda_inv_0_0_p64_lanes[4], Lambda_inv_0_0_p68_lanes[5] *
      Lambda_inv_0_0_p64_lanes[4], Lambda_inv_0_0_p68_lanes[4] * Lambda_inv_0_0_p64_lanes[4],
      Lambda_inv_0_0_p68_lanes[4] * Lambda_inv_0_0_p64_lanes[4]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p78_lanes[4] * Lambda_inv_0_0_p73_lanes[4],
      Lambda_inv_0_0_p78_lanes[4] * Lambda_inv_0_0_p73_lanes[4], Lambda_inv_0_0_p78_lanes[4] *
      Lambda_inv_0_0_p73_lanes[4], Lambda_inv_0_0_p78_lanes[4] * Lambda_inv_0_0_p73_lanes[4],
      Lambda_inv_0_0_p78_lanes[4] * Lambda_inv_0_0_p73_lanes[4], Lambda_inv_0_0_p78_lanes[5] *
      Lambda_inv_0_0_p73_lanes[4], Lambda_inv_0_0_p78_lanes[4] * Lambda_inv_0_0_p73_lanes[4],
      Lambda_inv_0_0_p78_lanes[4] * Lambda_inv_0_0_p73_lanes[4]);
  const Lanes<8> Lambda_inv_0_0_p89_lanes = Lambda_inv_0_1_p1 * Lambda_inv_0_0_p82_lanes +
      Lambda_inv_0_0_p1 * Lambda_inv_0_0_p83_lanes;

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p11 = Lambda_inv_0_1_p1 * (inverse_D2_p9 - inverse_D2_p10) +
      Lambda_inv_0_0_p1 * (2.0 * inverse_D2_p8);
  const Real inverse_D2_p12 = Lambda_inv_0_1_p1 * inverse_D2_p11;
  const Real inverse_D1_p1 = Lambda_inv_0_0_p1 * inverse_D2_p11 - inverse_D2_p8;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (inverse_D2_p10 + inverse_D2_p12));
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 2 (base_y), force propagation
  const Lanes<8> Lambda_inv_0_0_p91_lanes = Lambda_inv_0_0_p89_lanes * inverse_D2;
  const Lanes<8> Lambda_inv_0_0_p94_lanes = Lambda_inv_0_0_p1 * Lambda_inv_0_0_p82_lanes -
      Lambda_inv_0_1_p1 * Lambda_inv_0_0_p83_lanes - inverse_D1_p2 * Lambda_inv_0_0_p89_lanes;
  const Lanes<8> Lambda_inv_3_3_p14_lanes = Lambda_inv_3_3_p8_lanes + Lambda_inv_0_0_p68_lanes *
      Lambda_inv_0_0_p64_lanes[3] + Lambda_inv_0_0_p78_lanes * Lambda_inv_0_0_p73_lanes[3] +
      Lambda_inv_0_0_p91_lanes * Lambda_inv_0_0_p89_lanes[3];

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (inverse_D2_p9 - inverse_D2_p12) - inverse_D1_p1 *
      inverse_D1_p2);

  // link 1 (base_x), force propagation
  const Lanes<8> Lambda_inv_0_0_p96_lanes = Lambda_inv_0_0_p94_lanes * inverse_D1;
  const Lanes<8> Lambda_inv_0_0_lanes = Lambda_inv_0_0_p76_lanes + Lambda_inv_0_0_p78_lanes *
      Lambda_inv_0_0_p73_lanes[0] + Lambda_inv_0_0_p91_lanes * Lambda_inv_0_0_p89_lanes[0] +
      Lambda_inv_0_0_p96_lanes * Lambda_inv_0_0_p94_lanes[0];
  Lambda_inv[0] = Lambda_inv_0_0_lanes[0];
  Lambda_inv[1] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[6] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[2] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[12] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[3] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[18] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[4] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[24] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[5] = Lambda_inv_0_0_lanes[5];
  Lambda_inv[30] = Lambda_inv_0_0_lanes[5];
  const Lanes<8> Lambda_inv_1_1_lanes = Lambda_inv_1_1_p8_lanes + Lambda_inv_0_0_p78_lanes *
      Lambda_inv_0_0_p73_lanes[1] + Lambda_inv_0_0_p91_lanes * Lambda_inv_0_0_p89_lanes[1] +
      Lambda_inv_0_0_p96_lanes * Lambda_inv_0_0_p94_lanes[1];
  Lambda_inv[7] = Lambda_inv_1_1_lanes[1];
  Lambda_inv[8] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[13] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[9] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[19] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[10] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[25] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[11] = Lambda_inv_1_1_lanes[5];
  Lambda_inv[31] = Lambda_inv_1_1_lanes[5];
  const Lanes<8> Lambda_inv_2_2_lanes = Lambda_inv_2_2_p8_lanes + Lambda_inv_0_0_p78_lanes *
      Lambda_inv_0_0_p73_lanes[2] + Lambda_inv_0_0_p91_lanes * Lambda_inv_0_0_p89_lanes[2] +
      Lambda_inv_0_0_p96_lanes * Lambda_inv_0_0_p94_lanes[2];
  Lambda_inv[14] = Lambda_inv_2_2_lanes[2];
  Lambda_inv[15] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[20] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[16] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[26] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[17] = Lambda_inv_2_2_lanes[5];
  Lambda_inv[32] = Lambda_inv_2_2_lanes[5];
  const Lanes<8> Lambda_inv_3_3_lanes = Lambda_inv_3_3_p14_lanes + Lambda_inv_0_0_p96_lanes *
      Lambda_inv_0_0_p94_lanes[3];
  Lambda_inv[21] = Lambda_inv_3_3_lanes[3];
  Lambda_inv[22] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[27] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[23] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[33] = Lambda_inv_3_3_lanes[5];
  const Lanes<8> Lambda_inv_4_4_lanes = Lambda_inv_4_4_p6_lanes +
      detail::make_pack<Real>(Lambda_inv_0_0_p91_lanes[4] * Lambda_inv_0_0_p89_lanes[4],
      Lambda_inv_0_0_p91_lanes[4] * Lambda_inv_0_0_p89_lanes[4], Lambda_inv_0_0_p91_lanes[4] *
      Lambda_inv_0_0_p89_lanes[4], Lambda_inv_0_0_p91_lanes[4] * Lambda_inv_0_0_p89_lanes[4],
      Lambda_inv_0_0_p91_lanes[4] * Lambda_inv_0_0_p89_lanes[4], Lambda_inv_0_0_p91_lanes[5] *
      Lambda_inv_0_0_p89_lanes[4], Lambda_inv_0_0_p91_lanes[4] * Lambda_inv_0_0_p89_lanes[4],
      Lambda_inv_0_0_p91_lanes[4] * Lambda_inv_0_0_p89_lanes[4]) +
      detail::make_pack<Real>(Lambda_inv_0_0_p96_lanes[4] * Lambda_inv_0_0_p94_lanes[4],
      Lambda_inv_0_0_p96_lanes[4] * Lambda_inv_0_0_p94_lanes[4], Lambda_inv_0_0_p96_lanes[4] *
      Lambda_inv_0_0_p94_lanes[4], Lambda_inv_0_0_p96_lanes[4] * Lambda_inv_0_0_p94_lanes[4],
      Lambda_inv_0_0_p96_lanes[4] * Lambda_inv_0_0_p94_lanes[4], Lambda_inv_0_0_p96_lanes[5] *
      Lambda_inv_0_0_p94_lanes[4], Lambda_inv_0_0_p96_lanes[4] * Lambda_inv_0_0_p94_lanes[4],
      Lambda_inv_0_0_p96_lanes[4] * Lambda_inv_0_0_p94_lanes[4]);
  Lambda_inv[28] = Lambda_inv_4_4_lanes[4];
  Lambda_inv[29] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[34] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[35] = Lambda_inv_5_5_p1 + Lambda_inv_0_0_p78_lanes[5] * Lambda_inv_0_0_p73_lanes[5] +
      Lambda_inv_0_0_p91_lanes[5] * Lambda_inv_0_0_p89_lanes[5] + Lambda_inv_0_0_p96_lanes[5] *
      Lambda_inv_0_0_p94_lanes[5];
}

}  // namespace samm

#undef TREELINE_RESTRICT
