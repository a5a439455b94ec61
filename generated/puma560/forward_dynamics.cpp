// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 583 flops (add 255, mul 324, div 4), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT tau)[6], Real (&TREELINE_RESTRICT qdd)[6]) noexcept {
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[5]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c3 = cosines[1];
  const Real s4 = sines[2];
  const Real c4 = cosines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real s6 = sines[4];
  const Real c6 = cosines[4];

  // link 2 (link2), outward
  const Real minus_w2_y = qd[0] * c2;
  const Real minus_w2_x = qd[0] * s2;

  // link 3 (link3), outward
  const Real minus_w3_y = c3 * minus_w2_y - s3 * minus_w2_x;

  // link 4 (link4), outward
  const Real w4_z = qd[3] + minus_w3_y;

  // link 3 (link3), outward
  const Real minus_w3_x = s3 * minus_w2_y + c3 * minus_w2_x;
  const Real w3_z = qd[1] + qd[2];

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 5 (link5), outward
  const Real minus_w5_x = s5 * w4_z - c5 * w4_x;

  // link 4 (link4), outward
  const Real w4_y = c4 * w3_z + s4 * minus_w3_x;

  // link 5 (link5), outward
  const Real w5_z = qd[4] + w4_y;

  // link 5 (link5), inertial wrench
  const Real f5_y = 0.0028799999999999997 * (minus_w5_x * minus_w5_x + w5_z * w5_z);

  // link 5 (link5), outward
  const Real minus_w5_y = c5 * w4_z + s5 * w4_x;
  const Real minus_f5_x_p1 = minus_w5_x * minus_w5_y;

  // link 2 (link2), outward
  const Real wd2_y = qd[1] * minus_w2_x;
  const Real minus_wd2_x = qd[1] * minus_w2_y;

  // link 3 (link3), outward
  const Real wd3_x = s3 * wd2_y - c3 * minus_wd2_x - qd[2] * minus_w3_y;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd3_x + qd[3] * w4_x;

  // link 5 (link5), inertial wrench
  const Real minus_f5_x = 0.0028799999999999997 * (minus_wd4_y + minus_f5_x_p1);

  // link 5 (link5), inward
  const Real minus_f4_z = c5 * f5_y - s5 * minus_f5_x;

  // link 3 (link3), outward
  const Real f3_y_p1 = minus_w3_x * minus_w3_x;
  const Real f3_y_p2 = w3_z * w3_z;

  // link 4 (link4), outward
  const Real f3_y_p3 = f3_y_p1 + f3_y_p2;

  // link 3 (link3), outward
  const Real f3_y_p4 = minus_w3_x * minus_w3_y;

  // link 4 (link4), inward
  const Real f3_y = minus_f4_z + (0.861795 * f3_y_p3 - 0.025374999999999998 * f3_y_p4);

  // link 5 (link5), inward
  const Real minus_f4_x = s5 * f5_y + c5 * minus_f5_x;

  // link 3 (link3), outward
  const Real wd3_y = c3 * wd2_y + s3 * minus_wd2_x + qd[2] * minus_w3_x;

  // link 4 (link4), outward
  const Real wd4_x = c4 * wd3_x + qd[3] * w4_y;

  // link 5 (link5), outward
  const Real wd5_x = s5 * wd3_y + c5 * wd4_x - qd[4] * minus_w5_y;
  const Real minus_f5_z_p1 = wd5_x - minus_w5_y * w5_z;

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * minus_f5_z_p1;

  // link 4 (link4), inward
  const Real f3_x_p1 = s4 * minus_f5_z - c4 * minus_f4_x;

  // link 3 (link3), outward
  const Real f3_x_p2 = minus_w3_y * minus_w3_y;

  // link 4 (link4), outward
  const Real f3_x_p3 = f3_x_p2 + f3_y_p2;

  // link 4 (link4), inward
  const Real f3_x = f3_x_p1 - (0.861795 * f3_y_p4 - 0.025374999999999998 * f3_x_p3);
  const Real minus_f3_z_p1 = c4 * minus_f5_z + s4 * minus_f4_x;

  // link 3 (link3), outward
  const Real minus_f3_z_p2 = wd3_x - minus_w3_y * w3_z;
  const Real minus_f3_z_p3 = minus_w3_x * w3_z;
  const Real minus_f3_z_p4 = wd3_y + minus_f3_z_p3;

  // link 4 (link4), inward
  const Real minus_f3_z = minus_f3_z_p1 + (0.861795 * minus_f3_z_p2 - 0.025374999999999998 *
      minus_f3_z_p4);

  // link 2 (link2), outward
  const Real n2_y_p1 = minus_w2_x * minus_w2_x;
  const Real n2_y_p2 = qd[1] * qd[1];
  const Real n2_y_p3 = minus_w2_x * minus_w2_y;

  // link 3 (link3), inward
  const Real n2_y_p4 = 0.690314699 * (n2_y_p1 - n2_y_p2) + 0.0141984 * minus_wd2_x +
      0.023750999999999998 * n2_y_p3 + 3.349975204 * wd2_y;

  // link 2 (link2), outward
  const Real minus_a3_z_p1 = minus_w2_y * minus_w2_y;

  // link 3 (link3), outward
  const Real minus_a3_z = 0.1501 * (n2_y_p1 + minus_a3_z_p1) + 0.8636 * wd2_y;

  // link 4 (link4), outward
  const Real minus_a4_y_p1 = minus_a3_z + 0.4331 * minus_f3_z_p2 - 0.0203 * minus_f3_z_p4;

  // link 3 (link3), outward
  const Real minus_a3_x_p1 = 9.81 * c2 - 0.4318 * n2_y_p3;
  const Real minus_a3_x_p2 = 9.81 * s2 + 0.4318 * (minus_a3_z_p1 + n2_y_p2);
  const Real minus_a3_x = s3 * minus_a3_x_p1 + c3 * minus_a3_x_p2;

  // link 4 (link4), outward
  const Real minus_a4_y_p2 = minus_a3_x + 0.4331 * f3_y_p4 - 0.0203 * f3_x_p3;
  const Real minus_a4_y = c4 * minus_a4_y_p1 - s4 * minus_a4_y_p2;

  // link 6 (link6), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_x;
  const Real w6_z = qd[5] + minus_w5_y;
  const Real minus_n6_y_p1 = qd[5] + w6_z;

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = 2e-05 * (w6_x * minus_n6_y_p1 + (c6 * minus_wd4_y + s6 * wd5_x));

  // link 6 (link6), outward
  const Real w6_y = c6 * w5_z + s6 * minus_w5_x;

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (w6_y * minus_n6_y_p1 - (s6 * minus_wd4_y - c6 * wd5_x));

  // link 6 (link6), inward
  const Real n5_x = 0.00042216 * minus_f5_z_p1 + 0.0028799999999999997 * minus_a4_y + s6 *
      minus_n6_y + c6 * n6_x;

  // link 5 (link5), outward
  const Real wd5_y = c5 * wd3_y - s5 * wd4_x + qd[4] * minus_w5_x;

  // link 6 (link6), inertial wrench
  const Real minus_n6_z = 4e-05 * wd5_y;

  // link 6 (link6), inward
  const Real n5_y = minus_n6_z + 2e-04 * (wd5_y + minus_w5_x * w5_z);

  // link 5 (link5), inward
  const Real minus_n4_z = 0.0013999999999999998 * wd3_y + w4_y * (9.999999999999994e-05 * w4_x) +
      c5 * n5_y + s5 * n5_x;

  // link 4 (link4), inward
  const Real n3_y_p1 = minus_n4_z - (0.010673638499999999 * minus_f3_z_p2 + 0.004704000000000001 *
      f3_y_p4 - 0.0067651125 * minus_f3_z_p4 + 0.025374999999999998 * minus_a3_z);
  const Real n3_y = n3_y_p1 - 0.0203 * minus_f3_z_p1;

  // link 3 (link3), inward
  const Real n2_y_p5 = n2_y_p4 + 0.4318 * minus_f3_z - 0.1501 * (s3 * f3_y - c3 * f3_x) + c3 * n3_y;

  // link 4 (link4), outward
  const Real minus_a4_x = s4 * minus_a4_y_p1 + c4 * minus_a4_y_p2;

  // link 3 (link3), outward
  const Real minus_a3_y = c3 * minus_a3_x_p1 - s3 * minus_a3_x_p2;

  // link 4 (link4), outward
  const Real a4_z = minus_a3_y - 0.4331 * f3_y_p3 + 0.0203 * f3_y_p4;

  // link 5 (link5), outward
  const Real minus_a5_x = s5 * a4_z + c5 * minus_a4_x;

  // link 6 (link6), inward
  const Real minus_n5_z = 0.00062216 * minus_wd4_y + 0.00022215999999999997 * minus_f5_x_p1 +
      0.0028799999999999997 * minus_a5_x + c6 * minus_n6_y - s6 * n6_x;

  // link 5 (link5), inward
  const Real minus_n4_y = minus_n5_z + 0.00065 * (minus_wd4_y + w4_x * w4_z);

  // link 4 (link4), inward
  const Real n3_x_p1 = 0.004704000000000001 * (f3_x_p2 - f3_y_p2) - 0.010673638499999999 *
      minus_f3_z_p4 + 0.3056901365 * minus_f3_z_p2 + 0.861795 * minus_a3_z;

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * (wd4_x + w4_y * w4_z) - s5 * n5_y + c5 * n5_x;

  // link 4 (link4), inward
  const Real n3_x = n3_x_p1 + 0.4331 * minus_f3_z_p1 + s4 * minus_n4_y + c4 * n4_x;

  // link 3 (link3), inward
  const Real n2_y = n2_y_p5 + s3 * n3_x;
  const Real minus_n2_x_p1 = c3 * f3_y + s3 * f3_x;
  const Real minus_n2_x_p2 = 0.023750999999999998 * (minus_a3_z_p1 - n2_y_p2) + 0.690314699 *
      n2_y_p3 + 0.0141984 * wd2_y + 0.14625280000000002 * minus_wd2_x;
  const Real minus_n2_x = minus_n2_x_p2 + 0.1501 * minus_n2_x_p1 + s3 * n3_y - c3 * n3_x;

  // link 1 (link1), inward
  const Real qdd_0_p1 = tau[5] + minus_n6_z;

  // link 6 (link6), mass matrix
  const Real qdd_0_p2 = 4e-05 * c5;
  const Real qdd_0_p3 = 4e-05 * s5;
  const Real qdd_0_p4 = c4 * qdd_0_p3;
  const Real qdd_0_p5 = c2 * (c3 * qdd_0_p2 - s3 * qdd_0_p4) - s2 * (s3 * qdd_0_p2 + c3 * qdd_0_p4);

  // link 1 (link1), mass matrix
  const Real qdd_0_p6 = 24999.999999999996 * qdd_0_p5;

  // link 1 (link1), inward
  const Real qdd_0_p7 = tau[4] + minus_n5_z;

  // link 5 (link5), composite inertia
  const Real qdd_0_p8 = 0.0028799999999999997 * s5;
  const Real qdd_0_p9 = 0.0028799999999999997 * c5;

  // link 5 (link5), mass matrix
  const Real qdd_0_p10 = c4 * qdd_0_p9;
  const Real qdd_0_p11 = s4 * qdd_0_p9;
  const Real qdd_0_p12 = 0.0203 * qdd_0_p11;
  const Real qdd_0_p13 = 0.4318 * qdd_0_p11 + 0.1501 * (s3 * qdd_0_p8 - c3 * qdd_0_p10) - c3 *
      qdd_0_p12;
  const Real qdd_0_p14 = 0.4331 * qdd_0_p11 + 0.00064216 * s4;
  const Real qdd_0_p15 = c3 * qdd_0_p8 + s3 * qdd_0_p10;
  const Real qdd_0_p16 = c2 * (qdd_0_p13 + s3 * qdd_0_p14) + s2 *
      (0.1501 * qdd_0_p15 + s3 * qdd_0_p12 + c3 * qdd_0_p14);

  // link 1 (link1), mass matrix
  const Real qdd_0_p17 = 1557.24430048586 * qdd_0_p16;

  // link 1 (link1), inward
  const Real qdd_0_p18 = tau[0] + c2 * n2_y - s2 * minus_n2_x - qdd_0_p6 * qdd_0_p1 - qdd_0_p17 *
      qdd_0_p7;

  // link 1 (link1), mass matrix
  const Real qdd_0_p19 = 0.9999999999999999 * c5;

  // link 1 (link1), inward
  const Real qdd_0_p20 = tau[3] + minus_n4_z - qdd_0_p19 * qdd_0_p1;

  // link 5 (link5), composite inertia
  const Real qdd_0_p21 = 0.00020215999999999998 * s5;
  const Real qdd_0_p22 = s5 * qdd_0_p21;
  const Real qdd_0_p23 = 0.00164 + qdd_0_p22;

  // link 4 (link4), composite inertia
  const Real qdd_0_p24 = c4 * qdd_0_p8;
  const Real qdd_0_p25 = 0.0203 * qdd_0_p24;

  // link 4 (link4), mass matrix
  const Real qdd_0_p26 = qdd_0_p23 - qdd_0_p25;

  // link 4 (link4), composite inertia
  const Real qdd_0_p27 = s4 * qdd_0_p8;

  // link 3 (link3), composite inertia
  const Real qdd_0_p28 = 0.1501 * qdd_0_p27;

  // link 4 (link4), composite inertia
  const Real qdd_0_p29 = 0.4331 * qdd_0_p24;

  // link 5 (link5), composite inertia
  const Real qdd_0_p30 = c5 * qdd_0_p21;

  // link 4 (link4), composite inertia
  const Real qdd_0_p31 = c4 * qdd_0_p30;

  // link 4 (link4), mass matrix
  const Real qdd_0_p32 = qdd_0_p29 + qdd_0_p31;
  const Real qdd_0_p33 = s3 * qdd_0_p27;

  // link 1 (link1), mass matrix
  const Real qdd_0_p34 = c2 * (c3 * (qdd_0_p28 + qdd_0_p26) +
      (0.4318 * qdd_0_p24 + s3 * qdd_0_p32)) - s2 * (0.1501 * qdd_0_p33 + s3 * qdd_0_p26 - c3 *
      qdd_0_p32);
  const Real qdd_0_p35 = qdd_0_p34 - qdd_0_p5 * qdd_0_p19;
  const Real qdd_0_p36 = 1.0 / (qdd_0_p23 - qdd_0_p2 * qdd_0_p19);
  const Real qdd_0_p37 = qdd_0_p35 * qdd_0_p36;

  // link 4 (link4), inward
  const Real minus_n3_z_p1 = 0.010673638499999999 * (f3_y_p1 - f3_x_p2) - 0.004704000000000001 *
      (wd3_y - minus_f3_z_p3) + 0.298925024 * f3_y_p4 + 0.861795 * minus_a3_x;
  const Real minus_n3_z_p2 = minus_n3_z_p1 - 0.025374999999999998 * minus_a3_y - 0.4331 * f3_x_p1 +
      0.0203 * minus_f4_z + c4 * minus_n4_y;
  const Real minus_n3_z = minus_n3_z_p2 - s4 * n4_x;

  // link 6 (link6), mass matrix
  const Real qdd_0_p38 = s4 * qdd_0_p3;

  // link 1 (link1), mass matrix
  const Real qdd_0_p39 = 24999.999999999996 * qdd_0_p38;

  // link 1 (link1), inward
  const Real qdd_0_p40 = qdd_0_p39 * qdd_0_p1;

  // link 5 (link5), mass matrix
  const Real qdd_0_p41 = 0.4331 * qdd_0_p10 - 5.846399999999999e-05 * s5 + 0.00064216 * c4;

  // link 1 (link1), mass matrix
  const Real qdd_0_p42 = 1557.24430048586 * qdd_0_p41;

  // link 4 (link4), composite inertia
  const Real qdd_0_p43 = 0.4331 * qdd_0_p27 + s4 * qdd_0_p30;

  // link 1 (link1), mass matrix
  const Real qdd_0_p44 = qdd_0_p38 * qdd_0_p19;
  const Real qdd_0_p45 = qdd_0_p43 + qdd_0_p44;
  const Real qdd_0_p46 = qdd_0_p45 * qdd_0_p36;

  // link 1 (link1), inward
  const Real qdd_0_p47 = qdd_0_p40 - (tau[2] + minus_n3_z) + qdd_0_p42 * qdd_0_p7 - qdd_0_p46 *
      qdd_0_p20;

  // link 4 (link4), composite inertia
  const Real qdd_0_p48 = 0.861795 + qdd_0_p9;
  const Real qdd_0_p49 = 0.025374999999999998 - qdd_0_p24;

  // link 3 (link3), composite inertia
  const Real qdd_0_p50 = c3 * qdd_0_p48 + s3 * qdd_0_p49;

  // link 4 (link4), composite inertia
  const Real qdd_0_p51 = 0.004704000000000001 + qdd_0_p43;
  const Real qdd_0_p52 = s4 * (0.00010000000000000026 + qdd_0_p22);
  const Real qdd_0_p53 = 0.0203 * qdd_0_p27 - c4 * qdd_0_p52;

  // link 3 (link3), composite inertia
  const Real qdd_0_p54 = 0.1501 * qdd_0_p50 + c3 * qdd_0_p51 + s3 * qdd_0_p53;
  const Real qdd_0_p55 = s3 * qdd_0_p51 - c3 * qdd_0_p53;
  const Real qdd_0_p56 = s3 * qdd_0_p48 - c3 * qdd_0_p49;
  const Real qdd_0_p57 = 0.1501 * qdd_0_p56;

  // link 1 (link1), mass matrix
  const Real qdd_0_p58 = qdd_0_p5 * qdd_0_p39;
  const Real qdd_0_p59 = qdd_0_p58 + (c2 * qdd_0_p54 - s2 * (qdd_0_p57 + qdd_0_p55)) + qdd_0_p16 *
      qdd_0_p42 - qdd_0_p35 * qdd_0_p46;

  // link 4 (link4), composite inertia
  const Real qdd_0_p60 = s4 * qdd_0_p52;
  const Real qdd_0_p61 = qdd_0_p60 + (2.0 * (qdd_0_p25 - 0.0012473279999999998 * c5) - 0.313747409);

  // link 1 (link1), mass matrix
  const Real qdd_0_p62 = qdd_0_p38 * qdd_0_p39;
  const Real qdd_0_p63 = 1.0 / (qdd_0_p61 + qdd_0_p62 + qdd_0_p41 * qdd_0_p42 + qdd_0_p45 *
      qdd_0_p46);
  const Real qdd_0_p64 = qdd_0_p59 * qdd_0_p63;

  // link 1 (link1), inward
  const Real qdd_0_p65 = tau[1] + 0.0070992 * (n2_y_p1 - minus_a3_z_p1) - 1.601861202 * n2_y_p3 -
      1.024164 * s2 + 37.2347379 * c2;

  // link 5 (link5), mass matrix
  const Real qdd_0_p66 = qdd_0_p41 + 0.4318 * qdd_0_p15;

  // link 1 (link1), mass matrix
  const Real qdd_0_p67 = 1557.24430048586 * qdd_0_p66;
  const Real qdd_0_p68 = qdd_0_p44 + (qdd_0_p43 + 0.4318 * qdd_0_p33);
  const Real qdd_0_p69 = qdd_0_p68 * qdd_0_p36;

  // link 1 (link1), inward
  const Real qdd_0_p70 = qdd_0_p40 - (minus_n3_z + qdd_0_p65 - 0.4318 * minus_n2_x_p1) + qdd_0_p67 *
      qdd_0_p7 - qdd_0_p69 * qdd_0_p20;

  // link 3 (link3), composite inertia
  const Real qdd_0_p71 = 0.4318 * qdd_0_p56;

  // link 1 (link1), mass matrix
  const Real qdd_0_p72 = qdd_0_p62 + (qdd_0_p61 - qdd_0_p71) + qdd_0_p66 * qdd_0_p42 + qdd_0_p68 *
      qdd_0_p46;
  const Real qdd_0_p73 = qdd_0_p72 * qdd_0_p63;

  // link 1 (link1), inward
  const Real qdd_0_p74 = qdd_0_p70 - qdd_0_p73 * qdd_0_p47;

  // link 1 (link1), mass matrix
  const Real qdd_0_p75 = c2 * (0.023750999999999998 - qdd_0_p54) + s2 *
      (qdd_0_p55 + (0.690314699 + qdd_0_p57 + 0.4318 * qdd_0_p27));
  const Real qdd_0_p76 = qdd_0_p58 - qdd_0_p75 + qdd_0_p16 * qdd_0_p67 - qdd_0_p35 * qdd_0_p69 -
      qdd_0_p59 * qdd_0_p73;
  const Real qdd_0_p77 = qdd_0_p62 - (1.7481140020000001 - qdd_0_p61 + 0.8636 * qdd_0_p56) +
      qdd_0_p66 * qdd_0_p67 + qdd_0_p68 * qdd_0_p69;
  const Real qdd_0_p78 = 1.0 / (qdd_0_p77 - qdd_0_p72 * qdd_0_p73);
  const Real qdd_0_p79 = qdd_0_p76 * qdd_0_p78;

  // link 4 (link4), composite inertia
  const Real qdd_0_p80 = qdd_0_p31 - (0.010673638499999999 - qdd_0_p29 + 5.846399999999999e-05 *
      c5);
  const Real qdd_0_p81 = qdd_0_p60 + (0.0011921599999999998 -
      (qdd_0_p22 - (0.3056901365 + 0.0024946559999999996 * c5)));
  const Real qdd_0_p82 = 0.008405112499999999 + qdd_0_p22 - 0.0406 * qdd_0_p24;

  // link 3 (link3), composite inertia
  const Real qdd_0_p83 = qdd_0_p80 * (2.0 * c3) + s3 * (qdd_0_p81 - qdd_0_p82);
  const Real qdd_0_p84 = s3 * qdd_0_p83;
  const Real qdd_0_p85 = qdd_0_p84 + (qdd_0_p82 + (1.674987602 + 2.0 * (qdd_0_p71 + qdd_0_p28)));

  // link 2 (link2), composite inertia
  const Real qdd_0_p86 = (qdd_0_p80 + (0.0070992 - 0.4318 * qdd_0_p50) - c3 * qdd_0_p83) *
      (2.0 * c2) + s2 * (qdd_0_p85 + (qdd_0_p84 - (qdd_0_p81 +
      (0.07312640000000001 + 0.3002 * qdd_0_p27))));

  // link 1 (link1), mass matrix
  const Real qdd_0_p87 = 1.4717295504999999 + qdd_0_p85 - s2 * qdd_0_p86 - qdd_0_p5 * qdd_0_p6 -
      qdd_0_p16 * qdd_0_p17 - qdd_0_p35 * qdd_0_p37;

  // link 1 (link1), inward
  const Real qdd_0 = 1.0 / (qdd_0_p87 + qdd_0_p59 * qdd_0_p64 + qdd_0_p76 * qdd_0_p79) *
      (qdd_0_p18 - qdd_0_p37 * qdd_0_p20 + qdd_0_p64 * qdd_0_p47 + qdd_0_p79 * qdd_0_p74);
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_0_p78 * qdd_0_p74 - qdd_0_p79 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = qdd_0_p63 * qdd_0_p47 - qdd_0_p64 * qdd_0 - qdd_0_p73 * qdd_1;
  qdd[2] = qdd_2;
  const Real qdd_3 = qdd_0_p36 * qdd_0_p20 - qdd_0_p37 * qdd_0 + qdd_0_p69 * qdd_1 + qdd_0_p46 *
      qdd_2;
  qdd[3] = qdd_3;
  qdd[4] = 1557.24430048586 * qdd_0_p7 - qdd_0_p17 * qdd_0 - qdd_0_p67 * qdd_1 - qdd_0_p42 * qdd_2;
  qdd[5] = -(qdd_0_p39 * (qdd_1 + qdd_2) - (24999.999999999996 * qdd_0_p1 - qdd_0_p6 * qdd_0 -
      qdd_0_p19 * qdd_3));
}

}  // namespace puma560

#undef TREELINE_RESTRICT
