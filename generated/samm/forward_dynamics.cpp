// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By articulated bodies, Chang table 4.2.
// 610 flops (add 261, mul 343, div 6), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT tau)[9], Real (&TREELINE_RESTRICT qdd)[9]) noexcept {
  const Real angles[6] = {q[7], q[6], q[4], q[5], q[2], q[3]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s8 = sines[0];
  const Real s7 = sines[1];
  const Real s5 = sines[2];
  const Real c6 = cosines[3];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c7 = cosines[1];
  const Real c8 = cosines[0];
  const Real s3 = sines[4];
  const Real c4 = cosines[5];
  const Real c3 = cosines[4];
  const Real s4 = sines[5];

  // link 8 (link5), articulated inertia
  const Real inverse_D7_p1 = 0.00024215999999999997 * s8;
  const Real inverse_D6_p1 = 0.0028799999999999997 * s8;
  const Real inverse_D6_p2 = 0.012916407125949915 * s8;
  const Real a6_y_p1 = 0.4318 * s5;
  const Real a6_x_p1 = 0.4318 * c5;
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
  const Real inverse_D4_p4 = 0.0203 * inverse_D4_p1 - 0.4331 * inverse_D4_p2;
  const Real inverse_D4_p5 = 0.0203 * inverse_D4_p2 + 0.4331 * inverse_D4_p1;
  const Real inverse_D4_p6 = 0.025374999999999998 * inverse_D4_p2 + 0.861795 * inverse_D4_p1;
  const Real inverse_D5_p1 = 0.025374999999999998 * inverse_D4_p1 - 0.861795 * inverse_D4_p2;
  const Real inverse_D2_p1 = 3.79559 * s5 + 0.10439999999999999 * c5;
  const Real inverse_D6_p8 = inverse_D6_p1 * inverse_D7;
  const Real inverse_D6_p9 = inverse_D6_p5 * inverse_D7;
  const Real inverse_D6_p10 = inverse_D6_p1 * inverse_D6_p8;
  const Real inverse_D4_p7 = 1.601861202 * s5 + 0.0141984 * c5;
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
  const Real inverse_D4_p17 = 0.298925024 * inverse_D4_p1 + 0.021347276999999998 * inverse_D4_p2;
  const Real inverse_D4_p18 = inverse_D4_p5 * inverse_D4_p14;
  const Real inverse_D4_p19 = inverse_D4_p5 * inverse_D4_p11 - inverse_D4_p12;
  const Real inverse_D6_p23 = inverse_D4_p1 * (inverse_D6_p19 + inverse_D6_p3) + inverse_D4_p2 *
      (2.0 * inverse_D6_p7);
  const Real inverse_D2_p2 = 0.10439999999999999 * s5 - 3.79559 * c5;
  const Real inverse_D6_p24 = inverse_D4_p1 * inverse_D6_p23;
  const Real inverse_D2_p3 = s3 * c4 + c3 * s4;
  const Real inverse_D4_p20 = inverse_D4_p9 - (inverse_D4_p4 * inverse_D4_p13 - inverse_D4_p18);

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];
  const Real inverse_D2_p4 = c3 * c4 - s3 * s4;

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p25 = inverse_D6_p7 - inverse_D4_p2 * inverse_D6_p23;
  const Real inverse_D6_p26 = inverse_D6_p24 - inverse_D6_p3;
  const Real inverse_D6_p27 = inverse_D6_p19 - inverse_D6_p24;

  // link 7 (link4), outward
  const Real w7_x_p1 = inverse_D4_p1 * w4_z;

  // link 6 (link3), outward
  const Real wd6_x = w4_z * w6_z;

  // link 7 (link4), outward
  const Real wd8_y_p1 = inverse_D4_p2 * wd6_x;
  const Real minus_wd7_z = inverse_D4_p1 * wd6_x;
  const Real w7_z = qd[6] - inverse_D4_p2 * w4_z;
  const Real w7_x = s7 * w6_z - c7 * w7_x_p1;
  const Real w7_y = s7 * w7_x_p1 + c7 * w6_z;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p28 = inverse_D6_p21 + (inverse_D4_p4 * inverse_D6_p25 + inverse_D4_p5 *
      inverse_D6_p26);
  const Real inverse_D6_p29 = inverse_D6_p22 - (inverse_D4_p4 * inverse_D6_p27 + inverse_D4_p5 *
      inverse_D6_p25);

  // link 7 (link4), outward
  const Real wd8_y_p2 = w7_x * w7_y;

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 7 (link4), articulated inertia
  const Real inverse_D5_p2 = inverse_D4_p6 + inverse_D6_p28;
  const Real inverse_D5_p3 = inverse_D6_p29 - inverse_D5_p1;

  // link 6 (link3), outward
  const Real a7_y_p1 = 2.0 * wd6_x;

  // link 5 (link2), outward
  const Real wd5_x = w4_z * qd[4];

  // link 7 (link4), outward
  const Real wd8_y_p3 = wd8_y_p2 + minus_wd7_z;

  // link 8 (link5), outward
  const Real n8_x_p1 = 2.0 * w8_z;

  // link 4 (link1), outward
  const Real minus_a6_z_p1 = w4_z * w4_z;

  // link 8 (link5), outward
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;

  // link 6 (link3), outward
  const Real a7_y_p2 = w6_z * w6_z;

  // link 7 (link4), articulated inertia
  const Real inverse_D4_p21 = 0.004704000000000001 * inverse_D4_p2 +
      (inverse_D4_p5 * (inverse_D4_p15 + inverse_D4_p20) - inverse_D4_p4 * inverse_D4_p16 -
      inverse_D4_p1 * (c7 * inverse_D6_p15));

  // link 5 (link2), outward
  const Real minus_a6_z_p2 = 2.0 * wd5_x;
  const Real a6_x_p2 = qd[4] * qd[4];

  // link 7 (link4), outward
  const Real wd8_y_p4 = c7 * wd8_y_p1 + (w7_z + qd[6]) * w7_y;

  // link 8 (link5), outward
  const Real wd8_y_p5 = w8_x * w8_z;

  // link 6 (link3), outward
  const Real a7_y_p3 = minus_a6_z_p1 + a7_y_p2;

  // link 5 (link2), outward
  const Real a6_x_p3 = minus_a6_z_p1 + a6_x_p2;

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 6 (link3), outward
  const Real a6_x = a6_x_p3 * a6_x_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p30 = 0.312455249 + (0.00065 + inverse_D6_p18 +
      (inverse_D4_p5 * (inverse_D6_p21 + inverse_D6_p28) - inverse_D4_p4 *
      (inverse_D6_p22 + inverse_D6_p29)));

  // link 6 (link3), outward
  const Real a6_y = 9.81 + a6_x_p2 * a6_y_p1;
  const Real minus_a6_z = minus_a6_z_p2 * a6_y_p1 + 0.1501 * minus_a6_z_p1;

  // link 8 (link5), outward
  const Real wd8_y = c8 * wd8_y_p3 - s8 * wd8_y_p4 - wd8_y_p5;
  const Real n8_x_p2 = s8 * wd8_y_p3 + c8 * wd8_y_p4 - n8_x_p1 * minus_w8_y;

  // link 6 (link3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p30;

  // link 7 (link4), outward
  const Real a7_y_p4 = a6_x + a7_y_p3 * inverse_D4_p5;
  const Real a7_y_p5 = a6_y - a7_y_p2 * inverse_D4_p4;
  const Real a7_y_p6 = a7_y_p1 * inverse_D4_p4 - minus_a6_z;

  // link 8 (link5), outward
  const Real n8_z_p1 = w8_x * minus_w8_y;

  // link 9 (link6), inertial wrench
  const Real minus_n9_z = 4e-05 * wd8_y;
  const Real n9_x = 2e-05 * (n8_x_p2 + n8_x_p1 * w9_z);

  // link 7 (link4), outward
  const Real a7_y_p7 = inverse_D4_p2 * a7_y_p4 - inverse_D4_p1 * a7_y_p5;
  const Real minus_a7_z = inverse_D4_p1 * a7_y_p4 + inverse_D4_p2 * a7_y_p5;
  const Real minus_wd7_y = s7 * wd8_y_p1 + w7_x * qd[6];

  // link 9 (link6), inward
  const Real n8_y = minus_n9_z - 2e-04 * (wd8_y_p5 - wd8_y);

  // link 8 (link5), inertial wrench
  const Real minus_f8_z = 0.0028799999999999997 * n8_x_p2;

  // link 8 (link5), outward
  const Real minus_n9_y_p1 = minus_wd7_y - n8_z_p1;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p4 = inverse_D5_p2 * inverse_D6;
  const Real inverse_D5_p5 = inverse_D5_p3 * inverse_D6;
  const Real inverse_D4_p22 = inverse_D4_p20 * inverse_D6;
  const Real inverse_D4_p23 = inverse_D4_p21 * inverse_D6;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_y_p6 - s7 * a7_y_p7;
  const Real a7_x = c7 * a7_y_p7 + s7 * a7_y_p6;

  // link 8 (link5), inertial wrench
  const Real minus_f8_x = 0.0028799999999999997 * minus_n9_y_p1;

  // link 9 (link6), inertial wrench
  const Real minus_n9_y = 2e-05 * (minus_n9_y_p1 + 2.0 * (w8_x * w9_z));

  // link 8 (link5), inertial wrench
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z);

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p6 = inverse_D6_p25 + inverse_D5_p3 * inverse_D5_p4;
  const Real inverse_D5_p7 = inverse_D6_p27 - inverse_D5_p3 * inverse_D5_p5;

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p24 = inverse_D4_p13 - inverse_D5_p3 * inverse_D4_p22;

  // link 1 (base_x), inward
  const Real qdd_0_p1 = tau[8] + minus_n9_z;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p25 = inverse_D4_p16 + inverse_D4_p5 * inverse_D4_p13 - inverse_D4_p21 *
      inverse_D5_p5;

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * n8_x_p2 - 0.0028799999999999997 * a7_y + n9_x;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p26 = inverse_D4_p11 - inverse_D4_p20 * inverse_D4_p22;
  const Real inverse_D5_p8 = a6_x_p1 * inverse_D5_p6 - a6_y_p1 * inverse_D5_p7;
  const Real inverse_D4_p27 = a6_x_p1 * (inverse_D5_p2 * inverse_D4_p22 - inverse_D4_p14) -
      a6_y_p1 * inverse_D4_p24;
  const Real inverse_D4_p28 = inverse_D4_p6 + inverse_D4_p19 - inverse_D4_p21 * inverse_D4_p22;

  // link 8 (link5), inward
  const Real minus_f7_x = c8 * minus_f8_x + s8 * f8_y;

  // link 9 (link6), inward
  const Real n8_z = 0.00022215999999999997 * n8_z_p1 - 0.00062216 * minus_wd7_y +
      0.0028799999999999997 * a8_x - minus_n9_y;

  // link 8 (link5), inward
  const Real f7_z = s8 * minus_f8_x - c8 * f8_y;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p29 = inverse_D4_p25 + (a6_x_p1 * inverse_D4_p24 + 0.1501 * inverse_D5_p7);
  const Real inverse_D5_p9 = a6_x_p1 * (a6_x_p1 * (inverse_D6_p26 - inverse_D5_p2 * inverse_D5_p4) -
      a6_y_p1 * inverse_D5_p6) - a6_y_p1 * inverse_D5_p8;

  // link 8 (link5), inward
  const Real minus_n7_z = 9.999999999999994e-05 * wd8_y_p2 + 0.0014 * minus_wd7_z +
      (s8 * n8_x + c8 * n8_y);

  // link 1 (base_x), inward
  const Real qdd_0_p2 = tau[7] - n8_z;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p30 = inverse_D4_p28 + (a6_x_p1 * inverse_D4_p26 + 0.1501 * inverse_D4_p24);

  // link 7 (link4), inward
  const Real n6_z_p1 = s7 * minus_f8_z - c7 * minus_f7_x;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * wd8_y_p4 - (s8 * n8_y - c8 * n8_x);
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z + minus_wd7_y);
  const Real n6_z_p2 = inverse_D4_p2 * inverse_D4_p17 - 0.010673638499999999;

  // link 8 (link5), bias force
  const Real qdd_0_p3 = 4.484863585399276 * qdd_0_p2;

  // link 6 (link3), articulated inertia
  const Real inverse_D2_p5 = inverse_D2_p1 - inverse_D5_p8;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + inverse_D5_p9);

  // link 7 (link4), bias force
  const Real qdd_0_p4 = tau[6] + minus_n7_z - c8 * qdd_0_p1;

  // link 8 (link5), bias force
  const Real qdd_0_p5 = c8 * qdd_0_p3;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p31 = a6_y_p1 * inverse_D4_p25 - a6_x_p1 *
      (inverse_D4_p21 * inverse_D5_p4 - (inverse_D4_p15 + inverse_D4_p18) + inverse_D4_p27) -
      0.1501 * inverse_D5_p8;

  // link 8 (link5), bias force
  const Real qdd_0_p6 = s8 * qdd_0_p3;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p32 = 3.153482265 - s5 * inverse_D4_p7 + inverse_D4_p5 *
      (inverse_D4_p19 - inverse_D4_p12) - inverse_D4_p21 * inverse_D4_p23 + 0.1501 *
      (inverse_D4_p25 + inverse_D4_p29);

  // link 7 (link4), bias force
  const Real qdd_0_p7 = inverse_D6_p8 * qdd_0_p4;

  // link 7 (link4), inward
  const Real n6_z_p3 = inverse_D4_p1 * n6_z_p1 + inverse_D4_p2 * f7_z;
  const Real n6_z_p4 = inverse_D4_p2 * n6_z_p1 - inverse_D4_p1 * f7_z;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p33 = 0.690314699 * s5 + 0.023750999999999998 * c5 + inverse_D4_p31;
  const Real qdd_0_p8 = c5 * inverse_D4_p7 - 0.0070992;

  // link 7 (link4), inward
  const Real f6_x = a7_y_p3 * inverse_D4_p6 + n6_z_p4;

  // link 7 (link4), bias force
  const Real qdd_0_p9 = s8 * qdd_0_p1 - inverse_D6_p9 * qdd_0_p4;

  // link 7 (link4), inward
  const Real minus_f6_y = a7_y_p2 * inverse_D5_p1 + n6_z_p3;

  // link 7 (link4), bias force
  const Real qdd_0_p10 = c7 * qdd_0_p5 - s7 * qdd_0_p7;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p34 = inverse_D4_p33 * inverse_D5;
  const Real inverse_D2_p6 = inverse_D2_p5 * inverse_D5;
  const Real inverse_D2_p7 = inverse_D4_p27 * inverse_D5;

  // link 7 (link4), bias force
  const Real qdd_0_p11 = s7 * qdd_0_p5 + c7 * qdd_0_p7;

  // link 7 (link4), inward
  const Real f6_z_p1 = s7 * minus_f7_x + c7 * minus_f8_z;
  const Real n6_z = minus_a6_z_p1 * n6_z_p2 - (inverse_D4_p6 * a6_y + inverse_D5_p1 * a6_x) +
      (s7 * n7_x + c7 * n7_y + (inverse_D4_p5 * n6_z_p3 - inverse_D4_p4 * n6_z_p4));

  // link 7 (link4), bias force
  const Real qdd_0_p12 = inverse_D4_p2 * qdd_0_p6 - inverse_D4_p1 * qdd_0_p10;
  const Real qdd_0_p13 = inverse_D4_p2 * qdd_0_p10 + inverse_D4_p1 * qdd_0_p6;

  // link 7 (link4), inward
  const Real f6_z = a7_y_p1 * inverse_D5_p1 - f6_z_p1;

  // link 5 (link2), articulated inertia
  const Real inverse_D2_p8 = inverse_D4_p30 - inverse_D2_p2 + inverse_D4_p33 * inverse_D2_p7;

  // link 4 (link1), bias force
  const Real qdd_0_p14 = tau[3] + a7_y_p1 * n6_z_p2 + inverse_D4_p6 * minus_a6_z + minus_a6_z_p2 *
      qdd_0_p8 + a6_x_p2 * (0.023750999999999998 * s5 - 0.690314699 * c5);
  const Real qdd_0_p15 = c7 * n7_x - s7 * n7_y - 0.004704000000000001 * a7_y_p2 +
      (c7 * qdd_0_p9 - s7 * qdd_0_p2);

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p35 = inverse_D4_p32 + a6_x_p1 * (inverse_D4_p28 + inverse_D4_p30) -
      inverse_D4_p33 * inverse_D4_p34 + (inverse_D4_p17 + inverse_D4_p1 *
      (inverse_D6_p12 - inverse_D6_p18)) * inverse_D4_p1;
  const Real inverse_D2_p9 = 4.9338049999999996 + (inverse_D4_p29 - inverse_D4_p33 * inverse_D2_p6);

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / inverse_D4_p35;

  // link 3 (base), acceleration
  const Real qdd_2 = 0.1388888888888889 * (tau[2] - tau[3]);
  qdd[2] = qdd_2;

  // link 6 (link3), bias force
  const Real qdd_0_p16 = tau[5] - n6_z - (s7 * qdd_0_p9 + c7 * qdd_0_p2 -
      (inverse_D4_p5 * qdd_0_p12 + inverse_D4_p4 * qdd_0_p13));

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p10 = inverse_D2_p8 * inverse_D4;
  const Real inverse_D2_p11 = inverse_D2_p9 * inverse_D4;

  // link 5 (link2), bias force
  const Real qdd_0_p17 = f6_x + (qdd_0_p13 + inverse_D5_p5 * qdd_0_p16);

  // link 4 (link1), bias force
  const Real qdd_0_p18 = f6_z + (qdd_0_p11 + inverse_D4_p22 * qdd_0_p16);

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p12 = inverse_D2_p9 * inverse_D2_p10 -
      (inverse_D4_p24 + inverse_D2_p5 * inverse_D2_p7);
  const Real inverse_D2_p13 = inverse_D5_p7 - inverse_D2_p5 * inverse_D2_p6 - inverse_D2_p9 *
      inverse_D2_p11;
  const Real inverse_D2_p14 = inverse_D4_p26 - inverse_D4_p27 * inverse_D2_p7 - inverse_D2_p8 *
      inverse_D2_p10;

  // link 5 (link2), bias force
  const Real qdd_0_p19 = tau[4] - minus_a6_z_p1 * qdd_0_p8 - 9.81 * inverse_D2_p2 - tau[5] -
      qdd_0_p17 * a6_y_p1 + (qdd_0_p12 - inverse_D5_p4 * qdd_0_p16 - minus_f6_y) * a6_x_p1;

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p15 = inverse_D2_p3 * (inverse_D2_p13 - inverse_D2_p14) + inverse_D2_p4 *
      (2.0 * inverse_D2_p12);
  const Real inverse_D2_p16 = inverse_D2_p3 * inverse_D2_p15;

  // link 4 (link1), bias force
  const Real qdd_0_p20 = qdd_0_p14 - inverse_D4_p23 * qdd_0_p16 - inverse_D4_p34 * qdd_0_p19 -
      qdd_0_p18 * a6_x_p1 - 0.1501 * qdd_0_p17;

  // link 4 (link1), articulated inertia
  const Real inverse_D1_p1 = inverse_D2_p4 * inverse_D2_p15 - inverse_D2_p12;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (inverse_D2_p14 + inverse_D2_p16));

  // link 4 (link1), bias force
  const Real qdd_0_p21 = qdd_0_p20 + (f6_z_p1 - qdd_0_p11) * inverse_D4_p5 + tau[6] *
      inverse_D4_p2 + qdd_0_p15 * inverse_D4_p1;

  // link 2 (base_y), bias force
  const Real qdd_0_p22 = qdd_0_p17 - a6_x_p3 * inverse_D2_p2 + inverse_D2_p6 * qdd_0_p19 +
      inverse_D2_p11 * qdd_0_p21;
  const Real qdd_0_p23 = qdd_0_p18 - minus_a6_z_p2 * inverse_D2_p1 - 4.9338049999999996 *
      minus_a6_z_p1 - inverse_D2_p7 * qdd_0_p19 + inverse_D2_p10 * qdd_0_p21;

  // link 2 (base_y), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 2 (base_y), bias force
  const Real qdd_0_p24 = tau[1] + qdd_0_p22 * inverse_D2_p3 - qdd_0_p23 * inverse_D2_p4;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (inverse_D2_p13 - inverse_D2_p16) - inverse_D1_p1 *
      inverse_D1_p2);

  // link 1 (base_x), acceleration
  const Real qdd_0 = inverse_D1 * (tau[0] - inverse_D1_p2 * qdd_0_p24 + qdd_0_p23 * inverse_D2_p3 +
      qdd_0_p22 * inverse_D2_p4);
  qdd[0] = qdd_0;

  // link 2 (base_y), acceleration
  const Real qdd_1 = inverse_D2 * qdd_0_p24 - inverse_D1_p2 * qdd_0;
  qdd[1] = qdd_1;

  // link 4 (link1), acceleration
  const Real qdd_3_p1 = inverse_D2_p4 * qdd_1 - inverse_D2_p3 * qdd_0;
  const Real qdd_3_p2 = inverse_D2_p4 * qdd_0 + inverse_D2_p3 * qdd_1;
  const Real qdd_3 = inverse_D4 * qdd_0_p21 - (inverse_D2_p10 * qdd_3_p1 - inverse_D2_p11 *
      qdd_3_p2 + qdd_2);
  qdd[3] = qdd_3;
  const Real qdd_4_p1 = qdd_2 + qdd_3;

  // link 7 (link4), acceleration
  const Real qdd_6_p1 = inverse_D4_p1 * qdd_4_p1;
  const Real qdd_6_p2 = inverse_D4_p2 * qdd_4_p1;

  // link 6 (link3), acceleration
  const Real qdd_5_p1 = qdd_3_p1 + qdd_4_p1 * a6_x_p1;

  // link 5 (link2), acceleration
  const Real qdd_4 = inverse_D5 * qdd_0_p19 - (inverse_D4_p34 * qdd_4_p1 -
      (inverse_D2_p6 * qdd_3_p2 + inverse_D2_p7 * qdd_3_p1));
  qdd[4] = qdd_4;

  // link 7 (link4), acceleration
  const Real qdd_6_p3 = qdd_5_p1 + qdd_4_p1 * inverse_D4_p5;

  // link 6 (link3), acceleration
  const Real qdd_5_p2 = qdd_4 * a6_x_p1;
  const Real qdd_5_p3 = 0.1501 * qdd_4_p1 + qdd_4 * a6_y_p1 - qdd_3_p2;
  const Real qdd_5_p4 = inverse_D5_p5 * qdd_5_p3 + inverse_D5_p4 * qdd_5_p2 + inverse_D4_p22 *
      qdd_5_p1 + (inverse_D4_p23 * qdd_4_p1 + qdd_4);
  const Real qdd_5 = inverse_D6 * qdd_0_p16 - qdd_5_p4;
  qdd[5] = qdd_5;
  const Real qdd_6_p4 = qdd_4 + qdd_5;

  // link 7 (link4), acceleration
  const Real qdd_6_p5 = qdd_5_p3 - qdd_6_p4 * inverse_D4_p4;
  const Real qdd_6_p6 = qdd_5_p2 + qdd_6_p4 * inverse_D4_p5;
  const Real qdd_6_p7 = s7 * qdd_6_p4 - c7 * qdd_6_p1;
  const Real qdd_6_p8 = inverse_D4_p2 * qdd_6_p5 + inverse_D4_p1 * qdd_6_p6;

  // link 8 (link5), acceleration
  const Real qdd_7_p1 = c8 * (c7 * qdd_6_p8 + s7 * qdd_6_p3) + s8 *
      (inverse_D4_p1 * qdd_6_p5 - inverse_D4_p2 * qdd_6_p6);

  // link 7 (link4), acceleration
  const Real qdd_6 = inverse_D7 * qdd_0_p4 - (inverse_D6_p8 * (c7 * qdd_6_p3 - s7 * qdd_6_p8) -
      (inverse_D6_p9 * qdd_6_p7 + qdd_6_p2));
  qdd[6] = qdd_6;

  // link 8 (link5), acceleration
  qdd[7] = 1557.24430048586 * qdd_0_p2 - (4.484863585399276 * qdd_7_p1 +
      (s7 * qdd_6_p1 + c7 * qdd_6_p4));

  // link 9 (link6), acceleration
  qdd[8] = 24999.999999999996 * qdd_0_p1 - (s8 * qdd_6_p7 + c8 * (qdd_6 - qdd_6_p2));
}

}  // namespace samm

#undef TREELINE_RESTRICT
