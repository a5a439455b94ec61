// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 139 flops (add 59, mul 80, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void mass_matrix(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT M)[36]) noexcept {
  M[22] = 0.0;
  M[27] = 0.0;
  M[29] = 0.0;
  M[34] = 0.0;
  const Real angles[4] = {q[1], q[4], q[3], q[2]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real s5 = sines[1];
  const Real c4 = cosines[2];
  const Real c3 = cosines[3];
  const Real s3 = sines[3];
  const Real c5 = cosines[1];
  const Real s4 = sines[2];

  // link 5 (link5), composite inertia
  const Real M_0_0_p1 = 0.00020215999999999998 * s5;
  const Real M_0_0_p2 = 0.0028799999999999997 * s5;
  const Real M_0_0_p3 = 0.0028799999999999997 * c5;
  const Real M_0_0_p4 = 0.4318 * c2;
  const Real M_1_1_p1 = 0.4318 * s2;
  M[28] = 0.00064216;

  // link 5 (link5), mass matrix
  M[35] = 4e-05;

  // link 6 (link6), mass matrix
  const Real M_0_5_p1 = 4e-05 * s5;

  // link 5 (link5), composite inertia
  const Real M_0_0_p5 = s5 * M_0_0_p1;
  const Real M_0_0_p6 = c5 * M_0_0_p1;

  // link 4 (link4), composite inertia
  const Real M_0_0_p7 = c4 * M_0_0_p2;
  const Real M_2_3_p1 = s4 * M_0_0_p2;
  const Real M_1_1_p2 = s2 * s3 - c2 * c3;
  const Real M_0_0_p8 = s2 * c3 + c2 * s3;
  const Real M_0_0_p9 = 0.861795 + M_0_0_p3;

  // link 5 (link5), mass matrix
  const Real M_0_4_p1 = s4 * M_0_0_p3;
  const Real M_0_4_p2 = c4 * M_0_0_p3;

  // link 6 (link6), mass matrix
  const Real M_3_5 = 4e-05 * c5;
  M[23] = M_3_5;
  M[33] = M_3_5;

  // link 5 (link5), composite inertia
  const Real M_3_3 = 0.00164 + M_0_0_p5;
  M[21] = M_3_3;

  // link 4 (link4), composite inertia
  const Real M_0_0_p10 = M_0_0_p7 - 0.025374999999999998;
  const Real M_0_0_p11 = s4 * (0.00010000000000000026 + M_0_0_p5);
  const Real M_2_2_p1 = 0.0203 * M_0_0_p7;
  const Real M_0_0_p12 = c4 * M_0_0_p6 + 0.4331 * M_0_0_p7;
  const Real M_2_3 = s4 * M_0_0_p6 + 0.4331 * M_2_3_p1;
  M[15] = -M_2_3;
  M[20] = -M_2_3;

  // link 4 (link4), mass matrix
  const Real M_0_3_p1 = M_1_1_p2 * M_2_3_p1;

  // link 4 (link4), composite inertia
  const Real M_0_0_p13 = s4 * M_0_0_p11;
  const Real M_0_0_p14 = 0.0067651125 + (M_3_3 - 0.0406 * M_0_0_p7);

  // link 3 (link3), composite inertia
  const Real M_1_1_p3 = M_0_0_p8 * M_0_0_p10 + M_1_1_p2 * M_0_0_p9;

  // link 5 (link5), mass matrix
  const Real M_0_4_p3 = M_1_1_p2 * M_0_4_p2 + M_0_0_p8 * M_0_0_p2;

  // link 3 (link3), composite inertia
  const Real M_0_0_p15 = M_0_0_p4 * (M_1_1_p2 * M_0_0_p10 - M_0_0_p8 * M_0_0_p9);
  const Real M_1_1_p4 = M_1_1_p1 * M_1_1_p3 - M_0_0_p15;

  // link 4 (link4), composite inertia
  const Real M_2_2 = 0.312455249 + (0.00129216 - M_0_0_p13 + 2.0 *
      (0.0012473279999999998 * c5 - M_2_2_p1));
  M[14] = M_2_2;

  // link 3 (link3), composite inertia
  const Real M_0_2 = M_1_1_p2 * (0.004704000000000001 + M_2_3) - M_0_0_p8 *
      (0.0203 * M_2_3_p1 - c4 * M_0_0_p11) + 0.1501 * M_1_1_p3;
  M[2] = M_0_2;
  M[12] = M_0_2;

  // link 5 (link5), mass matrix
  const Real M_2_4 = 0.00064216 * c4 + (0.4331 * M_0_4_p2 - 5.846399999999999e-05 * s5);
  M[16] = M_2_4;
  M[26] = M_2_4;

  // link 6 (link6), mass matrix
  const Real M_1_5 = s4 * M_0_5_p1;
  M[11] = M_1_5;
  M[17] = M_1_5;
  M[31] = M_1_5;
  M[32] = M_1_5;

  // link 3 (link3), mass matrix
  const Real M_1_2 = M_2_2 + M_1_1_p4;
  M[8] = M_1_2;
  M[13] = M_1_2;

  // link 4 (link4), mass matrix
  const Real M_0_3 = M_0_0_p8 * M_0_0_p12 + M_1_1_p2 * (M_2_2_p1 - M_3_3) +
      (M_0_0_p4 * M_0_0_p7 - 0.1501 * M_0_3_p1);
  M[3] = M_0_3;
  M[18] = M_0_3;

  // link 5 (link5), mass matrix
  const Real M_0_4 = M_0_0_p8 * (0.00064216 * s4 + 0.4331 * M_0_4_p1) + 0.1501 * M_0_4_p3 +
      (0.0203 * M_1_1_p2 + M_0_0_p4) * M_0_4_p1;
  M[4] = M_0_4;
  M[24] = M_0_4;

  // link 6 (link6), mass matrix
  const Real M_0_5 = M_0_0_p8 * (c4 * M_0_5_p1) + M_1_1_p2 * M_3_5;
  M[5] = -M_0_5;
  M[30] = -M_0_5;

  // link 4 (link4), mass matrix
  const Real M_1_3 = M_2_3 + (M_0_0_p4 * (M_0_0_p8 * M_2_3_p1) + M_1_1_p1 * M_0_3_p1);
  M[9] = -M_1_3;
  M[19] = -M_1_3;

  // link 3 (link3), composite inertia
  M[7] = 1.7481140020000001 + (M_2_2 + 2.0 * M_1_1_p4);

  // link 5 (link5), mass matrix
  const Real M_1_4 = M_2_4 + (M_1_1_p1 * M_0_4_p3 - M_0_0_p4 *
      (M_1_1_p2 * M_0_0_p2 - M_0_0_p8 * M_0_4_p2));
  M[10] = M_1_4;
  M[25] = M_1_4;

  // link 3 (link3), composite inertia
  const Real M_0_0_p16 = M_1_1_p2 * (2.0 * (M_0_0_p12 - 5.846399999999999e-05 * c5 -
      0.010673638499999999)) - M_0_0_p8 * (0.3056901365 +
      (0.0011921599999999998 - M_0_0_p5 + M_0_0_p13 + 0.0024946559999999996 * c5) - M_0_0_p14);
  const Real M_0_1 = 0.690314699 * s2 + 0.023750999999999998 * c2 + M_0_2 + M_1_1_p1 * M_2_3_p1;
  M[1] = M_0_1;
  M[6] = M_0_1;
  const Real M_0_0_p17 = 1.674987602 - s2 * (1.601861202 * s2 + 0.0141984 * c2) +
      (M_0_0_p14 - M_0_0_p8 * M_0_0_p16 + 2.0 * (0.1501 * M_2_3_p1 - M_0_0_p15));

  // link 2 (link2), composite inertia
  M[0] = 1.4717295504999999 + M_0_0_p17;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
