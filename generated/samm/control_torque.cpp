// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at
//   link origins.
// 1116 flops (add 462, mul 643, div 11), sine and cosine of 6 angles
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
void control_torque(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT qdd_0)[9], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[9]) noexcept {
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[7], q[6]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s8 = sines[4];
  const Real c8 = cosines[4];
  const Real s7 = sines[5];
  const Real c7 = cosines[5];

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
  const Real inverse_D4_p3 = 0.690314699 * s5 + 0.023750999999999998 * c5;
  const Real inverse_D6_p6 = inverse_D6_p3 - 0.012916407125949915;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p7 = c7 * inverse_D6_p4;
  const Real inverse_D4_p4 = s7 * inverse_D6_p4;
  const Real inverse_D7 = 1.0 / (0.0016 + inverse_D7_p2);
  const Real inverse_D4_p5 = inverse_D4_p1 * c7;
  const Real inverse_D4_p6 = 0.004704000000000001 * inverse_D4_p2;
  const Real inverse_D4_p7 = 0.0203 * inverse_D4_p1 - 0.4331 * inverse_D4_p2;
  const Real inverse_D4_p8 = 0.0203 * inverse_D4_p2 + 0.4331 * inverse_D4_p1;
  const Real inverse_D4_p9 = 0.025374999999999998 * inverse_D4_p2 + 0.861795 * inverse_D4_p1;
  const Real inverse_D5_p3 = 0.025374999999999998 * inverse_D4_p1 - 0.861795 * inverse_D4_p2;
  const Real inverse_D2_p1 = 3.79559 * s5 + 0.10439999999999999 * c5;
  const Real inverse_D4_p10 = 0.298925024 * inverse_D4_p1 + 0.021347276999999998 * inverse_D4_p2;
  const Real inverse_D4_p11 = 1.601861202 * s5 + 0.0141984 * c5;
  const Real inverse_D6_p8 = inverse_D6_p1 * inverse_D7;
  const Real inverse_D6_p9 = inverse_D6_p5 * inverse_D7;
  const Real inverse_D6_p10 = inverse_D6_p1 * inverse_D6_p8;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p12 = 3.1467171525 - (s5 * inverse_D4_p11 -
      (0.0067651125 + inverse_D4_p1 * inverse_D4_p10));

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p11 = inverse_D6_p5 * inverse_D6_p8 - 0.0028799999999999997 * c8;
  const Real inverse_D6_p12 = 0.0011921599999999998 - inverse_D7_p2 - inverse_D6_p5 * inverse_D6_p9;
  const Real inverse_D6_p13 = s7 * (inverse_D6_p6 + inverse_D6_p10);
  const Real inverse_D6_p14 = c7 * inverse_D6_p11;
  const Real inverse_D6_p15 = s7 * (inverse_D6_p12 - 0.00065);
  const Real inverse_D6_p16 = s7 * inverse_D6_p13;
  const Real inverse_D6_p17 = c7 * inverse_D6_p14;
  const Real inverse_D4_p13 = c7 * inverse_D6_p13;
  const Real inverse_D4_p14 = s7 * inverse_D6_p14;
  const Real inverse_D6_p18 = s7 * inverse_D6_p15;
  const Real inverse_D6_p19 = inverse_D6_p6 - inverse_D6_p16;
  const Real inverse_D6_p20 = inverse_D6_p17 - inverse_D6_p11;
  const Real inverse_D4_p15 = inverse_D4_p1 * inverse_D4_p14;
  const Real inverse_D4_p16 = inverse_D6_p16 - inverse_D6_p10;
  const Real inverse_D4_p17 = inverse_D4_p1 * inverse_D6_p17;
  const Real inverse_D6_p21 = inverse_D4_p1 * inverse_D6_p20;
  const Real inverse_D6_p22 = inverse_D4_p2 * inverse_D6_p20;
  const Real inverse_D4_p18 = inverse_D4_p2 * inverse_D4_p13 - inverse_D4_p1 * inverse_D4_p4;
  const Real inverse_D4_p19 = inverse_D4_p1 * inverse_D4_p13 + inverse_D4_p2 * inverse_D4_p4;
  const Real inverse_D4_p20 = inverse_D4_p1 * inverse_D4_p15;
  const Real inverse_D4_p21 = inverse_D4_p2 * inverse_D4_p15;
  const Real inverse_D4_p22 = inverse_D4_p8 * inverse_D4_p19;
  const Real inverse_D4_p23 = inverse_D4_p8 * inverse_D4_p16 - inverse_D4_p17;
  const Real inverse_D2_p2 = 0.10439999999999999 * s5 - 3.79559 * c5;
  const Real inverse_D6_p23 = inverse_D4_p1 * (inverse_D6_p19 + inverse_D6_p3) + inverse_D4_p2 *
      (2.0 * inverse_D6_p7);
  const Real f9_z_p1 = s3 * c4 + c3 * s4;
  const Real inverse_D6_p24 = inverse_D4_p1 * inverse_D6_p23;
  const Real inverse_D4_p24 = inverse_D4_p14 - (inverse_D4_p7 * inverse_D4_p18 - inverse_D4_p22);
  const Real f9_z_p2 = c3 * c4 - s3 * s4;

  // link 8 (link5), force propagation
  const Real f9_z_p3 = 4.484863585399276 * s8;

  // link 7 (link4), force propagation
  const Real neg_s8 = -s8;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p25 = inverse_D6_p7 - inverse_D4_p2 * inverse_D6_p23;
  const Real inverse_D6_p26 = inverse_D6_p24 - inverse_D6_p3;
  const Real inverse_D6_p27 = inverse_D6_p19 - inverse_D6_p24;

  // link 7 (link4), force propagation
  const Real f9_z_p4 = -(4.484863585399276 * c8);
  const Lanes<8> f9_z_p5_lanes = c7 * detail::make_pack<Real>(c8, c8, s8, c8, f9_z_p4, c8, c8, c8);
  const Real f9_z_p8 = inverse_D4_p2 * s7;
  const Real f9_z_p9 = inverse_D4_p1 * s7;
  const Real f9_z_p13 = inverse_D6_p8 * neg_s8;
  const Real f9_z_p23 = s7 * f9_z_p13;
  const Real f9_z_p24 = c8 + inverse_D6_p9 * neg_s8;
  const Lanes<8> f9_z_p25_lanes = inverse_D4_p1 * f9_z_p5_lanes + inverse_D4_p2 *
      detail::make_pack<Real>(neg_s8, neg_s8, c8, neg_s8, f9_z_p3, neg_s8, neg_s8, neg_s8);
  const Lanes<8> f9_z_p28_lanes = inverse_D4_p2 * f9_z_p5_lanes - inverse_D4_p1 *
      detail::make_pack<Real>(neg_s8, neg_s8, c8, neg_s8, f9_z_p3, neg_s8, neg_s8, neg_s8);

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p28 = inverse_D6_p21 + (inverse_D4_p7 * inverse_D6_p25 + inverse_D4_p8 *
      inverse_D6_p26);
  const Real inverse_D6_p29 = inverse_D6_p22 - (inverse_D4_p7 * inverse_D6_p27 + inverse_D4_p8 *
      inverse_D6_p25);

  // link 7 (link4), force propagation
  const Real f9_z_p31 = inverse_D4_p1 * f9_z_p23;
  const Real f9_z_p32 = inverse_D4_p2 * f9_z_p23;
  const Real f9_z_p41 = s7 * f9_z_p4;
  const Real f9_z_p42 = c7 * f9_z_p13;

  // link 7 (link4), articulated inertia
  const Real inverse_D5_p4 = inverse_D4_p9 + inverse_D6_p28;
  const Real inverse_D5_p5 = inverse_D6_p29 - inverse_D5_p3;
  const Real inverse_D4_p25 = inverse_D4_p6 + (inverse_D4_p8 * (inverse_D4_p20 + inverse_D4_p24) -
      inverse_D4_p7 * inverse_D4_p21 - inverse_D4_p5 * inverse_D6_p15);

  // link 7 (link4), force propagation
  const Real f9_z_p43 = s7 * s8;
  const Real f9_z_p44 = s7 * c8;
  const Lanes<8> f9_z_p45_lanes = detail::make_pack<Real>(inverse_D4_p8, inverse_D4_p7,
      inverse_D4_p8, inverse_D4_p8, inverse_D4_p8, inverse_D4_p8, inverse_D4_p8, inverse_D4_p8) *
      detail::make_pack<Real>(f9_z_p25_lanes[0], f9_z_p8, f9_z_p25_lanes[2], f9_z_p25_lanes[0],
      f9_z_p25_lanes[4], f9_z_p25_lanes[0], f9_z_p25_lanes[0], f9_z_p25_lanes[0]) -
      detail::make_pack<Real>(inverse_D4_p7, inverse_D4_p8, inverse_D4_p7, inverse_D4_p7,
      inverse_D4_p7, inverse_D4_p7, inverse_D4_p7, inverse_D4_p7) *
      detail::make_pack<Real>(f9_z_p28_lanes[0], f9_z_p9, f9_z_p28_lanes[2], f9_z_p28_lanes[0],
      f9_z_p28_lanes[4], f9_z_p28_lanes[0], f9_z_p28_lanes[0], f9_z_p28_lanes[0]);
  const Real f9_z_p49 = s7 * f9_z_p24 + (inverse_D4_p8 * f9_z_p31 - inverse_D4_p7 * f9_z_p32);

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p30 = 0.312455249 + (0.00065 + inverse_D6_p18 +
      (inverse_D4_p8 * (inverse_D6_p21 + inverse_D6_p28) - inverse_D4_p7 *
      (inverse_D6_p22 + inverse_D6_p29)));

  // link 6 (link3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p30;
  const Real inverse_D5_p6 = inverse_D5_p4 * inverse_D6;
  const Real inverse_D5_p7 = inverse_D5_p5 * inverse_D6;
  const Real inverse_D4_p26 = inverse_D4_p24 * inverse_D6;
  const Real inverse_D4_p27 = inverse_D4_p25 * inverse_D6;

  // link 6 (link3), force propagation
  const Lanes<8> f9_z_p70_lanes = detail::make_pack<Real>(f9_z_p45_lanes[0], f9_z_p45_lanes[1],
      f9_z_p45_lanes[2], f9_z_p49, f9_z_p45_lanes[4], f9_z_p45_lanes[0], f9_z_p45_lanes[0],
      f9_z_p45_lanes[0]) * inverse_D6;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p8 = inverse_D6_p25 + inverse_D5_p5 * inverse_D5_p6;
  const Real inverse_D5_p9 = inverse_D6_p27 - inverse_D5_p5 * inverse_D5_p7;
  const Real inverse_D4_p28 = inverse_D4_p18 - inverse_D5_p5 * inverse_D4_p26;
  const Real inverse_D4_p29 = inverse_D4_p21 + inverse_D4_p8 * inverse_D4_p18 - inverse_D4_p25 *
      inverse_D5_p7;
  const Real inverse_D4_p30 = inverse_D4_p16 - inverse_D4_p24 * inverse_D4_p26;
  const Real inverse_D4_p31 = inverse_D4_p9 + inverse_D4_p23 - inverse_D4_p25 * inverse_D4_p26;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p32 = inverse_D4_p12 + inverse_D4_p1 *
      (inverse_D4_p1 * (inverse_D6_p12 - inverse_D6_p18)) + inverse_D4_p8 *
      (inverse_D4_p23 - inverse_D4_p17) - inverse_D4_p25 * inverse_D4_p27;

  // link 6 (link3), force propagation
  const Lanes<8> f9_z_p75_lanes = detail::make_pack<Real>(f9_z_p28_lanes[0], -f9_z_p8,
      f9_z_p28_lanes[2], f9_z_p32, f9_z_p28_lanes[4], f9_z_p28_lanes[0], f9_z_p28_lanes[0],
      f9_z_p28_lanes[0]) - inverse_D5_p7 * detail::make_pack<Real>(f9_z_p45_lanes[0],
      f9_z_p45_lanes[1], f9_z_p45_lanes[2], f9_z_p49, f9_z_p45_lanes[4], f9_z_p45_lanes[0],
      f9_z_p45_lanes[0], f9_z_p45_lanes[0]);
  const Lanes<8> f9_z_p85_lanes = detail::make_pack<Real>(f9_z_p44, c7, f9_z_p43, -f9_z_p42,
      f9_z_p41, f9_z_p44, f9_z_p44, f9_z_p44) - inverse_D4_p26 *
      detail::make_pack<Real>(f9_z_p45_lanes[0], f9_z_p45_lanes[1], f9_z_p45_lanes[2], f9_z_p49,
      f9_z_p45_lanes[4], f9_z_p45_lanes[0], f9_z_p45_lanes[0], f9_z_p45_lanes[0]);

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p10 = inverse_D5_p1 * inverse_D5_p8 - inverse_D5_p2 * inverse_D5_p9;
  const Real inverse_D4_p33 = inverse_D5_p1 * (inverse_D5_p4 * inverse_D4_p26 - inverse_D4_p19) -
      inverse_D5_p2 * inverse_D4_p28;
  const Real inverse_D2_p3 = inverse_D2_p1 - inverse_D5_p10;
  const Real inverse_D4_p34 = inverse_D4_p29 + (inverse_D5_p1 * inverse_D4_p28 + 0.1501 *
      inverse_D5_p9);

  // link 6 (link3), force propagation
  const Lanes<8> f9_z_p127_lanes = inverse_D5_p2 * f9_z_p75_lanes - inverse_D5_p1 *
      (detail::make_pack<Real>(-f9_z_p25_lanes[0], f9_z_p9, -f9_z_p25_lanes[2], -f9_z_p31,
      -f9_z_p25_lanes[4], -f9_z_p25_lanes[0], -f9_z_p25_lanes[0], -f9_z_p25_lanes[0]) +
      inverse_D5_p6 * detail::make_pack<Real>(f9_z_p45_lanes[0], f9_z_p45_lanes[1],
      f9_z_p45_lanes[2], f9_z_p49, f9_z_p45_lanes[4], f9_z_p45_lanes[0], f9_z_p45_lanes[0],
      f9_z_p45_lanes[0]));

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p35 = inverse_D4_p31 + (inverse_D5_p1 * inverse_D4_p30 + 0.1501 *
      inverse_D4_p28);
  const Real inverse_D5_p11 = inverse_D5_p1 * (inverse_D5_p1 *
      (inverse_D6_p26 - inverse_D5_p4 * inverse_D5_p6) - inverse_D5_p2 * inverse_D5_p8) -
      inverse_D5_p2 * inverse_D5_p10;

  // link 6 (link3), force propagation
  const Lanes<8> f9_z_p137_lanes = detail::make_pack<Real>(inverse_D4_p8 * f9_z_p44, inverse_D4_p8 *
      c7, inverse_D4_p8 * f9_z_p43, -(inverse_D4_p5 * f9_z_p24 + inverse_D4_p8 * f9_z_p42),
      inverse_D4_p8 * f9_z_p41, inverse_D4_p8 * f9_z_p44, inverse_D4_p8 * f9_z_p44, inverse_D4_p8 *
      f9_z_p44) - inverse_D4_p27 * detail::make_pack<Real>(f9_z_p45_lanes[0], f9_z_p45_lanes[1],
      f9_z_p45_lanes[2], f9_z_p49, f9_z_p45_lanes[4], f9_z_p45_lanes[0], f9_z_p45_lanes[0],
      f9_z_p45_lanes[0]) + (0.1501 * f9_z_p75_lanes + inverse_D5_p1 * f9_z_p85_lanes);

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + inverse_D5_p11);

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p36 = inverse_D5_p2 * inverse_D4_p29 - inverse_D5_p1 *
      (inverse_D4_p25 * inverse_D5_p6 - (inverse_D4_p20 + inverse_D4_p22) + inverse_D4_p33) -
      0.1501 * inverse_D5_p10;
  const Real inverse_D4_p37 = inverse_D4_p3 + inverse_D4_p36;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p38 = inverse_D4_p37 * inverse_D5;
  const Real inverse_D2_p4 = inverse_D2_p3 * inverse_D5;
  const Real inverse_D2_p5 = inverse_D4_p33 * inverse_D5;

  // link 5 (link2), force propagation
  const Lanes<8> f9_z_p142_lanes = f9_z_p127_lanes * inverse_D5;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p39 = inverse_D4_p32 + 0.1501 * (inverse_D4_p29 + inverse_D4_p34) +
      inverse_D5_p1 * (inverse_D4_p31 + inverse_D4_p35) - inverse_D4_p37 * inverse_D4_p38;
  const Real inverse_D2_p6 = inverse_D4_p35 - inverse_D2_p2 + inverse_D4_p37 * inverse_D2_p5;

  // link 5 (link2), force propagation
  const Lanes<8> f9_z_p174_lanes = f9_z_p137_lanes - inverse_D4_p38 * f9_z_p127_lanes;

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / inverse_D4_p39;

  // link 5 (link2), articulated inertia
  const Real inverse_D2_p7 = 4.9338049999999996 + (inverse_D4_p34 - inverse_D4_p37 * inverse_D2_p4);

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p8 = inverse_D2_p6 * inverse_D4;
  const Real inverse_D2_p9 = inverse_D2_p7 * inverse_D4;

  // link 4 (link1), force propagation
  const Lanes<8> f9_z_p206_lanes = f9_z_p174_lanes * inverse_D4;

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];
  const Real wd6_z = qdd_0[4] + qdd_0[5];

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p10 = inverse_D2_p7 * inverse_D2_p8 -
      (inverse_D4_p28 + inverse_D2_p3 * inverse_D2_p5);
  const Real inverse_D2_p11 = inverse_D5_p9 - inverse_D2_p3 * inverse_D2_p4 - inverse_D2_p7 *
      inverse_D2_p9;
  const Real inverse_D2_p12 = inverse_D4_p30 - inverse_D4_p33 * inverse_D2_p5 - inverse_D2_p6 *
      inverse_D2_p8;

  // link 4 (link1), force propagation
  const Lanes<8> f9_z_p233_lanes = -(f9_z_p75_lanes - inverse_D2_p4 * f9_z_p127_lanes) +
      inverse_D2_p9 * f9_z_p174_lanes;
  const Lanes<8> f9_z_p238_lanes = f9_z_p85_lanes + inverse_D2_p5 * f9_z_p127_lanes -
      inverse_D2_p8 * f9_z_p174_lanes;

  // link 4 (link1), outward
  const Real a6_x_p1 = w4_z * w4_z;

  // link 5 (link2), outward
  const Real a6_x_p2 = qd[4] * qd[4];

  // link 4 (link1), force propagation
  const Real f9_z_p255 = neg_s8 * inverse_D7 * neg_s8 + f9_z_p70_lanes[3] * f9_z_p49 +
      f9_z_p142_lanes[3] * f9_z_p127_lanes[3] + f9_z_p206_lanes[3] * f9_z_p174_lanes[3];

  // link 6 (link3), outward
  const Real a7_x_p1 = w6_z * w6_z;

  // link 4 (link1), outward
  const Real wd4_z = qdd_0[2] + qdd_0[3];

  // link 5 (link2), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;

  // link 6 (link3), outward
  const Real a7_x_p2 = a6_x_p1 + a7_x_p1;

  // link 5 (link2), outward
  const Real wd5_x = w4_z * qd[4];

  // link 4 (link1), force propagation
  const Lanes<8> f9_z_p276_lanes = f9_z_p1 * f9_z_p233_lanes + f9_z_p2 * f9_z_p238_lanes;

  // link 4 (link1), outward
  const Real a4_x = f9_z_p2 * qdd_0[0] + f9_z_p1 * qdd_0[1];

  // link 6 (link3), outward
  const Real wd6_x = w4_z * w6_z;

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p13 = f9_z_p1 * (inverse_D2_p11 - inverse_D2_p12) + f9_z_p2 *
      (2.0 * inverse_D2_p10);

  // link 5 (link2), outward
  const Real a6_z_p1 = 2.0 * wd5_x;

  // link 6 (link3), outward
  const Real a7_x_p3 = 2.0 * wd6_x;
  const Real a6_y = 9.81 + (a6_x_p2 * inverse_D5_p2 - qdd_0[4] * inverse_D5_p1);

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p14 = f9_z_p1 * inverse_D2_p13;

  // link 9 (link6), outward
  const Real f9_x_p1 = 9.81 + xdd_cmd[2];

  // link 4 (link1), outward
  const Real a4_y = f9_z_p2 * qdd_0[1] - f9_z_p1 * qdd_0[0];

  // link 7 (link4), outward
  const Real a7_x_p4 = a6_y - (wd6_z * inverse_D4_p8 + a7_x_p1 * inverse_D4_p7);

  // link 4 (link1), articulated inertia
  const Real inverse_D1_p1 = f9_z_p2 * inverse_D2_p13 - inverse_D2_p10;

  // link 9 (link6), outward
  const Real f9_x_p2 = f9_z_p2 * xdd_cmd[0] + f9_z_p1 * xdd_cmd[1];

  // link 6 (link3), outward
  const Real a6_x = a6_x_p3 * inverse_D5_p1 + qdd_0[4] * inverse_D5_p2 + 0.1501 * wd4_z - a4_x;

  // link 7 (link4), outward
  const Real w7_x_p1 = inverse_D4_p1 * w4_z;

  // link 9 (link6), outward
  const Real f9_x_p3 = f9_z_p2 * xdd_cmd[1] - f9_z_p1 * xdd_cmd[0];

  // link 7 (link4), outward
  const Real a7_x_p5 = a6_x + (a7_x_p2 * inverse_D4_p8 - wd6_z * inverse_D4_p7);

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (inverse_D2_p12 + inverse_D2_p14));

  // link 7 (link4), outward
  const Real w7_z = qd[6] - inverse_D4_p2 * w4_z;

  // link 6 (link3), outward
  const Real a6_z = a4_y + (wd4_z * inverse_D5_p1 - a6_z_p1 * inverse_D5_p2 - 0.1501 * a6_x_p1);

  // link 9 (link6), outward
  const Real f9_x_p4 = inverse_D4_p2 * f9_x_p2 + inverse_D4_p1 * f9_x_p1;

  // link 7 (link4), outward
  const Real wd7_y_p1 = inverse_D4_p2 * wd6_x - inverse_D4_p1 * wd4_z;
  const Real w7_x = s7 * w6_z - c7 * w7_x_p1;
  const Real a7_x_p6 = a6_z + (wd4_z * inverse_D4_p8 + a7_x_p3 * inverse_D4_p7);

  // link 9 (link6), outward
  const Real f9_x_p5 = inverse_D4_p2 * f9_x_p1 - inverse_D4_p1 * f9_x_p2;

  // link 7 (link4), outward
  const Real a7_x_p7 = inverse_D4_p2 * a7_x_p5 - inverse_D4_p1 * a7_x_p4;

  // link 9 (link6), outward
  const Real f9_x_p6 = f9_z_p2 * xdd_cmd[3] + f9_z_p1 * xdd_cmd[4];

  // link 7 (link4), outward
  const Real minus_a7_z = inverse_D4_p1 * a7_x_p5 + inverse_D4_p2 * a7_x_p4;

  // link 9 (link6), outward
  const Real f9_x_p7 = f9_z_p2 * xdd_cmd[4] - f9_z_p1 * xdd_cmd[3];

  // link 8 (link5), outward
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;

  // link 9 (link6), outward
  const Real f9_x_p8 = s7 * f9_x_p3 - c7 * f9_x_p4;

  // link 7 (link4), outward
  const Real w7_y = s7 * w7_x_p1 + c7 * w6_z;
  const Real wd7_y = c7 * wd6_z - s7 * wd7_y_p1 - w7_x * qd[6];
  const Real a7_x = c7 * a7_x_p7 + s7 * a7_x_p6;

  // link 2 (base_y), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 2 (base_y), force propagation
  const Lanes<8> f9_z_p286_lanes = f9_z_p276_lanes * inverse_D2;

  // link 8 (link5), outward
  const Real wd9_y_p1 = w8_x * minus_w8_y;

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];
  const Real f9_x_p9 = inverse_D4_p2 * f9_x_p6 + inverse_D4_p1 * xdd_cmd[5];

  // link 7 (link4), outward
  const Real wd9_x_p1 = w7_x * w7_y;

  // link 8 (link5), outward
  const Real wd8_z = wd7_y + qdd_0[7];

  // link 7 (link4), outward
  const Real wd7_z = qdd_0[6] - (inverse_D4_p1 * wd6_x + inverse_D4_p2 * wd4_z);

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 2 (base_y), force propagation
  const Lanes<8> f9_z_p296_lanes = f9_z_p286_lanes * f9_z_p276_lanes[0];
  const Lanes<8> f9_z_p301_lanes = f9_z_p286_lanes * f9_z_p276_lanes[1];
  const Lanes<8> f9_z_p305_lanes = f9_z_p286_lanes * f9_z_p276_lanes[2];

  // link 9 (link6), outward
  const Real wd9_y_p2 = w8_x * w9_z;

  // link 8 (link5), outward
  const Real wd9_y_p3 = wd9_y_p1 + wd8_z;

  // link 7 (link4), outward
  const Real wd9_x_p2 = wd9_x_p1 - wd7_z;
  const Real wd9_x_p3 = c7 * wd7_y_p1 + s7 * wd6_z + (w7_z + qd[6]) * w7_y;

  // link 2 (base_y), force propagation
  const Lanes<8> f9_z_p308_lanes = f9_z_p2 * f9_z_p233_lanes - f9_z_p1 * f9_z_p238_lanes -
      inverse_D1_p2 * f9_z_p276_lanes;
  const Lanes<8> f9_z_p313_lanes = f9_z_p70_lanes * f9_z_p45_lanes[0] + f9_z_p142_lanes *
      f9_z_p127_lanes[0] + f9_z_p206_lanes * f9_z_p174_lanes[0] + f9_z_p296_lanes;
  const Lanes<8> f9_z_p318_lanes = f9_z_p70_lanes * f9_z_p45_lanes[1] + f9_z_p142_lanes *
      f9_z_p127_lanes[1] + f9_z_p206_lanes * f9_z_p174_lanes[1] + f9_z_p301_lanes;
  const Lanes<8> f9_z_p322_lanes = f9_z_p70_lanes * f9_z_p45_lanes[2] + f9_z_p142_lanes *
      f9_z_p127_lanes[2] + f9_z_p206_lanes * f9_z_p174_lanes[2] + f9_z_p305_lanes;

  // link 9 (link6), outward
  const Real wd9_y = wd9_y_p3 - wd9_y_p2;
  const Real f9_y_p1 = inverse_D4_p2 * xdd_cmd[5] - inverse_D4_p1 * f9_x_p6;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (inverse_D2_p11 - inverse_D2_p14) - inverse_D1_p1 *
      inverse_D1_p2);

  // link 9 (link6), outward
  const Real f9_y_p2 = s7 * f9_x_p7 - c7 * f9_x_p9;
  const Real wd9_x_p4 = w8_z * w9_z;

  // link 2 (base_y), force propagation
  const Real f9_z_p325 = 1557.24430048586 + f9_z_p70_lanes[4] * f9_z_p45_lanes[4] +
      f9_z_p142_lanes[4] * f9_z_p127_lanes[4] + f9_z_p206_lanes[4] * f9_z_p174_lanes[4] +
      f9_z_p286_lanes[4] * f9_z_p276_lanes[4];

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 9 (link6), outward
  const Real f9_x_p10 = s7 * f9_x_p9 + c7 * f9_x_p7 - wd9_y;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_x_p6 - s7 * a7_x_p7;

  // link 8 (link5), outward
  const Real wd9_x_p5 = s8 * wd9_x_p2 + c8 * wd9_x_p3 - 2.0 * (minus_w8_y * w8_z);
  const Real f9_z_p326 = w8_x * w8_x + w8_z * w8_z;

  // link 9 (link6), outward
  const Real wd9_x = wd9_x_p4 + wd9_x_p5;
  const Real f9_x_p11 = c8 * f9_x_p8 + s8 * f9_x_p5 - a8_x - 0.05625 * (wd9_y_p3 + f9_x_p10);
  const Real f9_y_p3 = c8 * f9_y_p2 + s8 * f9_y_p1 - wd9_x;

  // link 1 (base_x), force propagation
  const Lanes<8> f9_z_p327_lanes = f9_z_p308_lanes * inverse_D1;
  const Lanes<8> f9_z_p344_lanes = f9_z_p313_lanes + f9_z_p327_lanes * f9_z_p308_lanes[0];
  const Real f9_z_p356 = f9_z_p70_lanes[4] * f9_z_p49 + f9_z_p142_lanes[4] * f9_z_p127_lanes[3] +
      f9_z_p206_lanes[4] * f9_z_p174_lanes[3] + f9_z_p286_lanes[4] * f9_z_p276_lanes[3] +
      f9_z_p327_lanes[4] * f9_z_p308_lanes[3];
  const Real f9_z_p357 = f9_z_p344_lanes[0] * f9_z_p344_lanes[0];
  const Real f9_z_p358 = f9_z_p357 * f9_z_p344_lanes[0];
  const Real f9_z_p359 = f9_z_p358 * f9_z_p357 / (7.52316384526264e-37 + f9_z_p358 * f9_z_p358);
  const Lanes<8> f9_z_p360_lanes = f9_z_p344_lanes * f9_z_p359;
  const Lanes<8> f9_z_p371_lanes = f9_z_p318_lanes + f9_z_p327_lanes * f9_z_p308_lanes[1] -
      f9_z_p360_lanes * f9_z_p344_lanes[1];
  const Real n4_z_p1 = c5 * inverse_D4_p11 - 0.0070992;
  const Real f9_z_p378 = f9_z_p371_lanes[1] * f9_z_p371_lanes[1];
  const Real f9_y_p4 = s7 * f9_x_p4 + c7 * f9_x_p3 - a7_y - f9_z_p360_lanes[1] * f9_x_p11 +
      0.05625 * (wd9_x_p5 + f9_y_p3);
  const Real f9_z_p379 = f9_z_p378 * f9_z_p371_lanes[1];
  const Real n4_z_p2 = inverse_D4_p2 * inverse_D4_p10 - 0.010673638499999999;

  // link 8 (link5), outward
  const Real wd8_y_p1 = w8_x * w8_z;

  // link 5 (link2), inward
  const Real n4_z_p3 = qdd_0[4] * inverse_D4_p3 - 4.9338049999999996 * a4_x - a6_z_p1 * n4_z_p1 -
      a6_x_p2 * (0.023750999999999998 * s5 - 0.690314699 * c5);

  // link 8 (link5), outward
  const Real wd8_y = c8 * wd9_x_p2 - s8 * wd9_x_p3 - wd8_y_p1;

  // link 9 (link6), outward
  const Real wd9_z = qdd_0[8] - wd8_y;

  // link 1 (base_x), force propagation
  const Real f9_z_p380 = f9_z_p379 * f9_z_p378 / (4.81482486096809e-35 + f9_z_p379 * f9_z_p379);

  // link 5 (link2), inward
  const Real n4_z_p4 = n4_z_p3 - inverse_D2_p2 * a4_y + wd6_z * inverse_D4_p6 - a7_x_p3 * n4_z_p2 +
      inverse_D4_p9 * a6_z;

  // link 9 (link6), inertial wrench
  const Real n9_z = 4e-05 * wd9_z - 3.9999999999999996e-05 * (c8 * f9_y_p1 - s8 * f9_y_p2 + wd9_z);
  tau[8] = n9_z;

  // link 9 (link6), inward
  const Real minus_n8_y = 2e-04 * (wd8_y_p1 - wd8_y) + n9_z;

  // link 1 (base_x), force propagation
  const Lanes<8> f9_z_p381_lanes = f9_z_p371_lanes * f9_z_p380;
  const Lanes<8> f9_z_p387_lanes = f9_z_p322_lanes + f9_z_p327_lanes * f9_z_p308_lanes[2] -
      f9_z_p360_lanes * f9_z_p344_lanes[2] - f9_z_p381_lanes * f9_z_p371_lanes[2];
  const Real f9_z_p390 = f9_z_p255 + f9_z_p286_lanes[3] * f9_z_p276_lanes[3] + f9_z_p327_lanes[3] *
      f9_z_p308_lanes[3] - f9_z_p360_lanes[3] * f9_z_p344_lanes[3] - f9_z_p381_lanes[3] *
      f9_z_p371_lanes[3];
  const Real f9_z_p391 = f9_z_p387_lanes[2] * f9_z_p387_lanes[2];
  const Real f9_z_p392 = 0.05625 * f9_z_p326 - f9_z_p360_lanes[2] * f9_x_p11 - f9_z_p381_lanes[2] *
      f9_y_p4 + (f9_x_p8 - a7_x) * s8;
  const Real f9_z_p393 = f9_z_p391 * f9_z_p387_lanes[2];
  const Real f9_z_p394 = f9_z_p392 + (minus_a7_z - f9_x_p5) * c8;

  // link 6 (link3), inertial wrench
  const Real n6_z_p1 = 0.312455249 * wd6_z + wd4_z * inverse_D4_p6 + a6_x_p1 * n4_z_p2 -
      (inverse_D4_p9 * a6_y + inverse_D5_p3 * a6_x);

  // link 1 (base_x), force propagation
  const Real f9_z_p395 = f9_z_p393 * f9_z_p391 / (1.1754943508222875e-38 + f9_z_p393 * f9_z_p393);

  // link 5 (link2), inertial wrench
  const Real n5_z_p1 = 1.7481140020000001 * qdd_0[4] + wd4_z * inverse_D4_p3 + a6_x_p1 * n4_z_p1 +
      (9.81 * inverse_D2_p2 - inverse_D2_p1 * a4_x);

  // link 1 (base_x), force propagation
  const Real f9_z_p396 = f9_z_p387_lanes[3] * f9_z_p395;
  const Real f9_z_p397 = f9_z_p387_lanes[4] * f9_z_p395;
  const Real f9_z_p398 = f9_z_p390 - f9_z_p396 * f9_z_p387_lanes[3];
  const Real f9_z_p399 = f9_z_p356 - f9_z_p360_lanes[4] * f9_z_p344_lanes[3] - f9_z_p381_lanes[4] *
      f9_z_p371_lanes[3] - f9_z_p397 * f9_z_p387_lanes[3];
  const Real f9_z_p400 = f9_z_p325 + f9_z_p327_lanes[4] * f9_z_p308_lanes[4] - f9_z_p360_lanes[4] *
      f9_z_p344_lanes[4] - f9_z_p381_lanes[4] * f9_z_p371_lanes[4] - f9_z_p397 * f9_z_p387_lanes[4];
  const Real f9_z_p401 = f9_y_p3 - f9_z_p360_lanes[3] * f9_x_p11 - f9_z_p381_lanes[3] * f9_y_p4 -
      f9_z_p396 * f9_z_p394;
  const Real f9_z_p402 = f9_z_p398 * f9_z_p398;
  const Real f9_z_p403 = f9_z_p402 * f9_z_p398;
  const Real f9_z_p404 = f9_z_p403 * f9_z_p402 / (3.552713678800501e-15 + f9_z_p403 * f9_z_p403);
  const Real f9_z_p405 = f9_z_p399 * f9_z_p404;
  const Real f9_z_p406 = f9_z_p400 - f9_z_p405 * f9_z_p399;
  const Real f9_z_p407 = f9_x_p10 - f9_z_p360_lanes[4] * f9_x_p11 - f9_z_p381_lanes[4] * f9_y_p4 -
      f9_z_p397 * f9_z_p394 - f9_z_p405 * f9_z_p401;
  const Real f9_z_p408 = f9_z_p406 * f9_z_p406;
  const Real f9_z_p409 = f9_z_p408 * f9_z_p406;
  const Real f9_z_p410 = f9_z_p407 * (f9_z_p409 * f9_z_p408 /
      (1.4551915228366852e-11 + f9_z_p409 * f9_z_p409));

  // link 9 (link6), inertial wrench
  const Real n9_y = f9_z_p410 - 2e-05 * (wd9_y_p2 - wd9_y);

  // link 1 (base_x), force propagation
  const Real f9_z_p411 = f9_z_p401 * f9_z_p404 - f9_z_p405 * f9_z_p410;

  // link 9 (link6), inward
  const Real n8_z = 0.00022215999999999997 * wd9_y_p1 + 0.00062216 * wd8_z + 0.0028799999999999997 *
      a8_x + n9_y;
  tau[7] = n8_z;

  // link 9 (link6), inertial wrench
  const Real n9_x = 2e-05 * (wd9_x_p4 + wd9_x) + f9_z_p411;

  // link 8 (link5), inward
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z - wd7_y);

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * wd9_x_p5 - 0.0028799999999999997 * a7_y + n9_x;

  // link 1 (base_x), force propagation
  const Real f9_z = f9_z_p394 * f9_z_p395 - f9_z_p396 * f9_z_p411 - f9_z_p397 * f9_z_p410;

  // link 9 (link6), inward
  const Real f8_y = 0.0028799999999999997 * f9_z_p326 - f9_z;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * wd9_x_p3 + (c8 * n8_x + s8 * minus_n8_y);
  const Real n7_z = 0.0014 * wd7_z - 9.999999999999994e-05 * wd9_x_p1 +
      (c8 * minus_n8_y - s8 * n8_x);
  tau[6] = n7_z;

  // link 1 (base_x), force propagation
  const Real f9_y = f9_y_p4 * f9_z_p380 - f9_z_p381_lanes[2] * f9_z - f9_z_p381_lanes[3] *
      f9_z_p411 - f9_z_p381_lanes[4] * f9_z_p410;

  // link 9 (link6), inward
  const Real f8_z = f9_y - 0.0028799999999999997 * wd9_x_p5;

  // link 1 (base_x), force propagation
  const Real f9_x = f9_x_p11 * f9_z_p359 - f9_z_p360_lanes[1] * f9_y - f9_z_p360_lanes[2] * f9_z -
      f9_z_p360_lanes[3] * f9_z_p411 - f9_z_p360_lanes[4] * f9_z_p410;

  // link 9 (link6), inward
  const Real f8_x = 0.0028799999999999997 * wd9_y_p3 + f9_x;

  // link 8 (link5), inward
  const Real minus_f7_x = s8 * f8_y - c8 * f8_x;
  const Real minus_f7_z = s8 * f8_x + c8 * f8_y;

  // link 7 (link4), inward
  const Real f6_x_p1 = c7 * minus_f7_x + s7 * f8_z;
  const Real n4_z_p5 = c7 * f8_z - s7 * minus_f7_x;
  const Real f6_z = wd4_z * inverse_D4_p9 + a7_x_p3 * inverse_D5_p3 + n4_z_p5;

  // link 6 (link3), inward
  const Real f5_z = f6_z - (wd4_z * inverse_D2_p2 + a6_z_p1 * inverse_D2_p1);

  // link 7 (link4), inward
  const Real f6_x_p2 = inverse_D4_p1 * minus_f7_z - inverse_D4_p2 * f6_x_p1;
  const Real n6_z_p2 = inverse_D4_p1 * f6_x_p1 + inverse_D4_p2 * minus_f7_z;

  // link 5 (link2), inward
  const Real f4_y = f5_z - 4.9338049999999996 * a6_x_p1;

  // link 7 (link4), inward
  const Real f6_x = a7_x_p2 * inverse_D4_p9 - wd6_z * inverse_D5_p3 + f6_x_p2;
  const Real f6_y = n6_z_p2 - (wd6_z * inverse_D4_p9 + a7_x_p1 * inverse_D5_p3);

  // link 6 (link3), inward
  const Real f5_x = qdd_0[4] * inverse_D2_p1 - a6_x_p3 * inverse_D2_p2 + f6_x;

  // link 5 (link2), inward
  const Real minus_f4_x = 4.9338049999999996 * wd4_z + f5_x;
  const Real n4_z_p6 = n4_z_p4 + inverse_D4_p8 * n4_z_p5 - inverse_D4_p2 * n7_z + 0.1501 * f6_x +
      inverse_D5_p1 * f6_z;

  // link 7 (link4), inward
  const Real n6_z = n6_z_p1 + (s7 * n7_x + c7 * n7_y -
      (inverse_D4_p8 * n6_z_p2 + inverse_D4_p7 * f6_x_p2));
  tau[5] = n6_z;

  // link 4 (link1), inward
  const Real minus_f3_x = f9_z_p2 * minus_f4_x + f9_z_p1 * f4_y;
  const Real f3_y = f9_z_p2 * f4_y - f9_z_p1 * minus_f4_x;

  // link 5 (link2), inward
  const Real n4_z = n4_z_p6 + (0.004704000000000001 * a7_x_p1 - (c7 * n7_x - s7 * n7_y)) *
      inverse_D4_p1 + inverse_D4_p12 * wd4_z;
  tau[3] = n4_z;

  // link 3 (base), inward
  const Real f2_x = 186.45 * qdd_0[0] - minus_f3_x;
  tau[0] = f2_x;
  const Real f2_z = 186.45 * qdd_0[1] + f3_y;
  tau[1] = f2_z;

  // link 6 (link3), inward
  const Real n5_z = n5_z_p1 + (n6_z + (inverse_D5_p2 * f6_x - inverse_D5_p1 * f6_y));
  tau[4] = n5_z;

  // link 4 (link1), inward
  const Real n3_z = 7.2 * qdd_0[2] + n4_z;
  tau[2] = n3_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
