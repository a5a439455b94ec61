// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1, alike limbs in lanes.
// 1939 flops (add 915, mul 1024, div 0), sine and cosine of 24 angles
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
void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT qdd)[24], Real (&TREELINE_RESTRICT tau)[24]) noexcept {
  const Real c20_p1 = 0.17435661841416683 + q[19];
  const Real c13_p1 = (-0.17435661841416683) + q[12];
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], c20_p1, q[6], q[7], q[8], q[9], q[10], q[11], c13_p1};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real s1 = sines[0];
  const Real c2 = cosines[1];
  const Real s2 = sines[1];
  const Real c3 = cosines[2];
  const Real s3 = sines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];
  const Real s21 = sines[6];
  const Real c21 = cosines[6];
  const Real s22 = sines[7];
  const Real c22 = cosines[7];
  const Real c24 = cosines[8];
  const Real s24 = sines[8];
  const Real c23 = cosines[9];
  const Real s23 = sines[9];
  const Real s14 = sines[10];
  const Real c14 = cosines[10];
  const Real c15 = cosines[11];
  const Real s15 = sines[11];
  const Real c16 = cosines[12];
  const Real s16 = sines[12];
  const Real c17 = cosines[13];
  const Real s17 = sines[13];
  const Real s18 = sines[14];
  const Real c18 = cosines[14];
  const Real s19 = sines[15];
  const Real c19 = cosines[15];
  const Real c20 = cosines[16];
  const Real s20 = sines[16];
  const Real s7 = sines[17];
  const Real c7 = cosines[17];
  const Real c8 = cosines[18];
  const Real s8 = sines[18];
  const Real c9 = cosines[19];
  const Real s9 = sines[19];
  const Real c10 = cosines[20];
  const Real s10 = sines[20];
  const Real s11 = sines[21];
  const Real c11 = cosines[21];
  const Real s12 = sines[22];
  const Real c12 = cosines[22];
  const Real c13 = cosines[23];
  const Real s13 = sines[23];

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];
  const Real wd2_z = qdd[0] + qdd[1];

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];
  const Real wd3_z = wd2_z + qdd[2];

  // link 4 (chest1), outward
  const Real w4_y = c4 * w3_z;
  const Real w4_x = s4 * w3_z;
  const Real wd6_x_p1 = s4 * wd3_z;
  const Real wd4_y_p1 = c4 * wd3_z;
  const Real wd6_x_p2 = w4_x * w4_y;

  // link 5 (chest2), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (chest1), outward
  const Real wd4_y_p2 = w4_x * qd[3];

  // link 5 (chest2), outward
  const Real w5_x = c5 * w4_x - s5 * qd[3];

  // link 4 (chest1), outward
  const Real wd6_x_p3 = wd6_x_p2 - qdd[3];

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];

  // link 4 (chest1), outward
  const Real wd4_y = wd4_y_p1 - wd4_y_p2;

  // link 5 (chest2), outward
  const Real wd6_x_p4 = w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real wd6_x_p5 = wd6_x_p1 + 2.0 * (w4_y * qd[3]);

  // link 5 (chest2), outward
  const Real wd5_z = wd4_y + qdd[4];
  const Real wd5_x_p1 = minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];

  // link 5 (chest2), outward
  const Real wd6_x_p6 = wd5_z - wd6_x_p4;

  // link 6 (chest3), outward
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real wd6_x_p7 = w6_y * w6_z;
  const Real wd12_x_p1 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);

  // link 6 (chest3), outward
  const Real wd6_y_p1 = w6_x * w6_z;
  const Lanes<2> n13_z_p3_lanes = 0.0007965395222188762 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(2.0630162081277884e-05, (-2.0630162081277884e-05)) *
      detail::make_pack<Real>(c13, c20);

  // link 5 (chest2), outward
  const Real wd6_x_p8 = 2.0 * (w5_x * w5_z) - (c5 * wd6_x_p3 - s5 * wd6_x_p5);
  const Real wd5_x = s5 * wd6_x_p3 + c5 * wd6_x_p5 - wd5_x_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;
  const Lanes<2> n13_z_p5_lanes = detail::make_pack<Real>(s13, s20) * n13_z_p3_lanes;

  // link 6 (chest3), outward
  const Real wd6_z = wd5_x + qdd[5];

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd12_x_p3_lanes = w7_x_lanes * w7_y_lanes;
  const Lanes<2> wd7_x_p1_lanes = w7_y_lanes * w7_z_lanes;

  // link 6 (chest3), outward
  const Real wd12_x_p4 = wd12_x_p1 - wd6_z;
  const Lanes<2> n13_z_p7_lanes = 0.0008675855653090935 - n13_z_p5_lanes;
  const Lanes<2> n13_z_p8_lanes = 7.104604309021728e-05 + n13_z_p5_lanes;
  const Real wd6_x_p9 = c6 * wd6_x_p8 - s6 * wd6_x_p6;
  const Lanes<2> n13_z_p10_lanes = 0.00011422720754895356 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(s13, s20);

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 6 (chest3), outward
  const Real wd6_x = wd6_x_p7 - wd6_x_p9;
  const Real wd6_y = c6 * wd6_x_p6 + s6 * wd6_x_p8 - wd6_y_p1;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;

  // link 2 (thigh), outward
  const Real a3_x_p1 = w2_z * w2_z;
  const Lanes<2> n13_z_p12_lanes = detail::make_pack<Real>(c13, c20) * n13_z_p3_lanes -
      detail::make_pack<Real>(1.0315081040638942e-05, (-1.0315081040638942e-05));
  const Lanes<2> n13_x_p3_lanes = 0.00011422720754895356 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(c13, c20);

  // link 6 (chest3), outward
  const Real wd12_x_p7 = wd6_x_p7 + wd6_x;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_z_lanes = wd6_y + detail::make_pack<Real>(qdd[6], qdd[13]);

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * qdd[0] - minus_a1_x;

  // link 3 (hip), outward
  const Real a5_y_p1 = w3_z * w3_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd12_x_p9_lanes = w8_x_lanes * w8_y_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_x_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd12_x_p11_lanes = wd12_x_p3_lanes + wd7_z_lanes;

  // link 2 (thigh), outward
  const Real a2_y_p2 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 5 (chest2), outward
  const Real a6_x_p1 = w5_x * w5_x;
  const Real a6_x_p2 = w5_z * w5_z;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_y_lanes = detail::make_pack<Real>(c9, c16) * w8_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_z_lanes;

  // link 5 (chest2), outward
  const Real a6_x_p3 = wd5_x - wd5_x_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd12_x_p14_lanes = detail::make_pack<Real>(s7, s14) * wd12_x_p4 +
      detail::make_pack<Real>(c7, c14) * wd12_x_p7;
  const Lanes<2> wd7_x_p4_lanes = detail::make_pack<Real>(c7, c14) * wd12_x_p4 -
      detail::make_pack<Real>(s7, s14) * wd12_x_p7;

  // link 6 (chest3), outward
  const Real a7_y_p1 = w6_z * w6_z;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_p2_lanes = w8_y_lanes * w8_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;

  // link 5 (chest2), outward
  const Real a6_x_p4 = a6_x_p1 + a6_x_p2;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd12_x_p16_lanes = 2.0 * (w7_x_lanes * w7_z_lanes) - wd12_x_p14_lanes;
  const Lanes<2> wd7_x_lanes = wd7_x_p1_lanes - wd7_x_p4_lanes;

  // link 5 (chest2), outward
  const Real a6_z_p1 = wd6_x_p4 + wd5_z;

  // link 2 (thigh), outward
  const Real a2_y = c2 * a2_y_p2 - s2 * a2_y_p1;
  const Real a2_x = c2 * a2_y_p1 + s2 * a2_y_p2;

  // link 6 (chest3), outward
  const Real a7_y_p3 = wd6_y_p1 - wd6_y;
  const Real a7_y_p4 = w6_y * w6_y + a7_y_p1;

  // link 9 (left_upperarm), outward
  const Lanes<2> wd12_x_p17_lanes = w9_x_lanes * w9_y_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_z_lanes = wd7_x_lanes + detail::make_pack<Real>(qdd[7], qdd[14]);

  // link 3 (hip), outward
  const Real a3_x_p2 = a2_y + 0.422 * a3_x_p1;
  const Real a3_x_p3 = a2_x + 0.422 * wd2_z;

  // link 6 (chest3), outward
  const Real minus_a7_z_p1 = wd12_x_p1 + wd6_z;
  const Real minus_a7_z_p2 = w6_x * w6_x;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd12_x_p20_lanes = wd12_x_p9_lanes + wd8_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd12_x_p21_lanes = detail::make_pack<Real>(c8, c15) * wd12_x_p11_lanes +
      detail::make_pack<Real>(s8, s15) * wd12_x_p16_lanes;
  const Lanes<2> wd8_x_p4_lanes = detail::make_pack<Real>(c8, c15) * wd12_x_p16_lanes -
      detail::make_pack<Real>(s8, s15) * wd12_x_p11_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_wd9_y_p1_lanes = w9_x_lanes * w9_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = minus_a7_z_p2 + a7_y_p1;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p1_lanes = w8_y_lanes * w8_y_lanes;
  const Lanes<2> a10_x_p2_lanes = w8_z_lanes * w8_z_lanes;

  // link 3 (hip), outward
  const Real a3_x = c3 * a3_x_p3 + s3 * a3_x_p2;
  const Real a3_y = c3 * a3_x_p2 - s3 * a3_x_p3;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd12_x_p24_lanes = 2.0 * (w8_x_lanes * w8_z_lanes) - wd12_x_p21_lanes;
  const Lanes<2> wd8_x_lanes = wd8_x_p2_lanes - wd8_x_p4_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd12_x_p25_lanes = w10_x_lanes * minus_w10_y_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_z_lanes = minus_w10_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_p1_lanes = w10_x_lanes * w10_z_lanes;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 5 (chest2), outward
  const Real a5_y_p2 = a3_y + 0.21799999999999997 * a5_y_p1;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;

  // link 9 (left_upperarm), outward
  const Lanes<2> wd9_z_lanes = detail::make_pack<Real>(qdd[8], qdd[15]) - wd8_x_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> a10_x_p3_lanes = a10_x_p1_lanes + a10_x_p2_lanes;
  const Lanes<2> minus_f13_x_p1_lanes = 0.0165153994048813 * detail::make_pack<Real>(c13, c20);

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p1_lanes = w10_x_lanes * w10_x_lanes;
  const Lanes<2> minus_a12_y_p2_lanes = w10_z_lanes * w10_z_lanes;

  // link 5 (chest2), outward
  const Real a5_y_p3 = a4_x + 0.21799999999999997 * wd4_y_p1;
  const Real minus_a5_z = minus_a4_y + 0.21799999999999997 * wd6_x_p1;

  // link 9 (left_upperarm), outward
  const Lanes<2> wd12_x_p28_lanes = detail::make_pack<Real>(s9, s16) * wd12_x_p24_lanes -
      detail::make_pack<Real>(c9, c16) * wd12_x_p20_lanes;
  const Lanes<2> wd12_x_p29_lanes = wd12_x_p17_lanes - wd9_z_lanes;
  const Lanes<2> minus_wd9_y_p4_lanes = detail::make_pack<Real>(s9, s16) * wd12_x_p20_lanes +
      detail::make_pack<Real>(c9, c16) * wd12_x_p24_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_z_p1_lanes = w11_x_lanes * w11_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_y_p1_lanes = w11_x_lanes * w11_z_lanes;

  // link 6 (chest3), outward
  const Real a6_x_p5 = minus_a5_z + 0.072 * a6_x_p3;

  // link 9 (left_upperarm), outward
  const Lanes<2> wd12_x_p31_lanes = 2.0 * (w9_y_lanes * w9_z_lanes) - wd12_x_p28_lanes;
  const Lanes<2> minus_wd9_y_lanes = minus_wd9_y_p4_lanes + minus_wd9_y_p1_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n13_x_p4_lanes = 2.0 * w12_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a12_y_p3_lanes = minus_a12_y_p1_lanes + minus_a12_y_p2_lanes;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p2 - s5 * a5_y_p3;
  const Real a5_x = c5 * a5_y_p3 + s5 * a5_y_p2;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_z_lanes = detail::make_pack<Real>(qdd[9], qdd[16]) - minus_wd9_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;
  const Lanes<2> n13_z_p13_lanes = w12_z_lanes * w12_z_lanes;
  const Lanes<2> f13_y_p1_lanes = 0.0165153994048813 * detail::make_pack<Real>(s13, s20);

  // link 6 (chest3), outward
  const Real a6_x_p6 = a5_y + 0.072 * a6_x_p4;
  const Real a6_z = a5_x + 0.072 * a6_z_p1;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd12_x_p35_lanes = detail::make_pack<Real>(s10, s17) * wd12_x_p29_lanes +
      detail::make_pack<Real>(c10, c17) * wd12_x_p31_lanes;
  const Lanes<2> wd12_x_p36_lanes = wd12_x_p25_lanes + wd10_z_lanes;
  const Lanes<2> wd10_y_p4_lanes = detail::make_pack<Real>(c10, c17) * wd12_x_p29_lanes -
      detail::make_pack<Real>(s10, s17) * wd12_x_p31_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);

  // link 12 (left_wrist2), outward
  const Lanes<2> n13_z_p14_lanes = minus_w12_y_lanes * w12_z_lanes;
  const Lanes<2> n13_x_p6_lanes = w12_x_lanes * minus_w12_y_lanes;
  const Lanes<2> n13_z_p15_lanes = minus_w12_y_lanes * minus_w12_y_lanes;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p6 = a6_z - 0.226 * a7_y_p3;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd12_x_p37_lanes = wd12_x_p35_lanes - 2.0 * (minus_w10_y_lanes * w10_z_lanes);
  const Lanes<2> wd10_y_lanes = wd10_y_p4_lanes - wd10_y_p1_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> n13_x_p9_lanes = w13_z_lanes * w13_z_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_z_p2_lanes = w11_y_lanes * w11_y_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p7_lanes = a7_y_p6 + detail::make_pack<Real>(0.18, (-0.18)) * wd12_x_p7;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n13_z_p17_lanes = n13_z_p13_lanes - n13_z_p15_lanes;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a6_x_p6 - s6 * a6_x_p5;
  const Real minus_a6_y = s6 * a6_x_p6 + c6 * a6_x_p5;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_z_lanes = detail::make_pack<Real>(qdd[10], qdd[17]) - wd10_y_lanes;
  const Lanes<2> n11_z_p3_lanes = w11_x_lanes * w11_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_y_p1_lanes = wd10_y_p1_lanes - wd10_y_lanes;

  // link 14 (right_shoulder1), outward
  const Real a7_y_p9 = a6_x + 0.226 * a7_y_p4;
  const Real minus_a7_z_p5 = minus_a6_y + 0.226 * minus_a7_z_p1;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd12_x_p40_lanes = detail::make_pack<Real>(s11, s18) * wd12_x_p36_lanes +
      detail::make_pack<Real>(c11, c18) * wd12_x_p37_lanes;
  const Lanes<2> wd12_x_p41_lanes = n11_z_p1_lanes - wd11_z_lanes;
  const Lanes<2> wd11_y_p4_lanes = detail::make_pack<Real>(c11, c18) * wd12_x_p36_lanes -
      detail::make_pack<Real>(s11, s18) * wd12_x_p37_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_x_p12_lanes = (n13_x_p9_lanes - n13_z_p13_lanes) * n13_x_p3_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p10_lanes = a7_y_p9 + detail::make_pack<Real>(0.18, (-0.18)) * wd12_x_p4;
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p5 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p3;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd12_x_p42_lanes = wd12_x_p40_lanes + 2.0 * (w11_y_lanes * w11_z_lanes);
  const Lanes<2> wd11_y_lanes = wd11_y_p4_lanes - wd11_y_p1_lanes;
  const Lanes<2> n11_x_p1_lanes = n11_z_p1_lanes + wd11_z_lanes;
  const Lanes<2> n11_x_p2_lanes = w11_z_lanes * w11_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_z_lanes = wd11_y_lanes + detail::make_pack<Real>(qdd[11], qdd[18]);

  // link 11 (left_wrist1), outward
  const Lanes<2> n11_x_p3_lanes = wd11_y_p1_lanes - wd11_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p9_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      wd11_y_p4_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p10_lanes -
      detail::make_pack<Real>(s7, s14) * a7_y_p7_lanes;
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p10_lanes +
      detail::make_pack<Real>(c7, c14) * a7_y_p7_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n13_x_p15_lanes = wd12_z_lanes - n13_x_p6_lanes;
  const Lanes<2> f12_x_p1_lanes = n13_x_p6_lanes + wd12_z_lanes;
  const Lanes<2> n13_x_p16_lanes = detail::make_pack<Real>(c12, c19) * wd12_x_p41_lanes -
      detail::make_pack<Real>(s12, s19) * wd12_x_p42_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p8_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (n11_x_p2_lanes - n11_z_p2_lanes);

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(s12, s19) * wd12_x_p41_lanes +
      detail::make_pack<Real>(c12, c19) * wd12_x_p42_lanes - n13_z_p14_lanes;
  const Lanes<2> n13_x_p17_lanes = n13_x_p4_lanes * w12_x_lanes - n13_x_p16_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> n13_x_p18_lanes = n13_x_p15_lanes + 2.0 * (minus_w12_y_lanes * w13_z_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_z_lanes;
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_z_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> wd13_z_lanes = wd12_x_lanes + detail::make_pack<Real>(qdd[12], qdd[19]);
  const Lanes<2> n13_x_p19_lanes = n13_x_p4_lanes * w13_z_lanes - n13_x_p17_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> n12_x_p2_lanes = wd12_x_lanes - n13_z_p14_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p6_lanes = 0.282 * a10_x_p3_lanes - a8_x_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> n13_x_p22_lanes = wd13_z_lanes - n13_z_p14_lanes;
  const Lanes<2> minus_f13_x_p4_lanes = n13_z_p14_lanes + wd13_z_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> f13_z_lanes = n13_x_p19_lanes * f13_y_p1_lanes - n13_x_p18_lanes *
      minus_f13_x_p1_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p8_lanes = a9_x_lanes + 0.282 * minus_wd9_y_p4_lanes;
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 * wd12_x_p28_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p23_lanes = 0.0009386316083993107 * wd13_z_lanes - n13_z_p14_lanes *
      (n13_z_p7_lanes - n13_z_p8_lanes) + n13_x_p17_lanes * n13_z_p10_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> f12_x_lanes = f13_z_lanes - (0.0025100003499999995 *
      (n13_z_p15_lanes + n13_z_p13_lanes) + 0.0006000000000000001 * f12_x_p1_lanes);

  // link 13 (left_hand), inertial wrench
  const Lanes<2> minus_f13_x_lanes = (n13_z_p13_lanes + n13_x_p9_lanes) * minus_f13_x_p1_lanes +
      minus_f13_x_p4_lanes * f13_y_p1_lanes;
  const Lanes<2> n13_x_p26_lanes = n13_x_p19_lanes * n13_z_p8_lanes - n13_x_p18_lanes *
      n13_z_p12_lanes - n13_x_p22_lanes * n13_z_p10_lanes + n13_x_p12_lanes;
  const Lanes<2> f13_y_lanes = n13_x_p22_lanes * minus_f13_x_p1_lanes -
      (n13_z_p15_lanes + n13_x_p9_lanes) * f13_y_p1_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> f12_y_lanes = 0.0025100003499999995 * n13_x_p15_lanes - 0.0006000000000000001 *
      (w12_x_lanes * w12_x_lanes + n13_z_p13_lanes) - minus_f13_x_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_lanes = detail::make_pack<Real>(c10, c17) * a10_x_p8_lanes -
      detail::make_pack<Real>(s10, s17) * a10_x_p6_lanes;
  const Lanes<2> minus_a10_y_lanes = detail::make_pack<Real>(s10, s17) * a10_x_p8_lanes +
      detail::make_pack<Real>(c10, c17) * a10_x_p6_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> f12_z_lanes = 0.0025100003499999995 * n13_x_p17_lanes + 0.0006000000000000001 *
      n12_x_p2_lanes + f13_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_y_p8_lanes = 0.000144 * (n11_z_p3_lanes - n11_x_p2_lanes);

  // link 10 (left_lowerarm), outward
  const Lanes<2> f10_x_p1_lanes = minus_w10_y_lanes * minus_w10_y_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p6_lanes = minus_a10_y_lanes + 0.269 * minus_a12_y_p3_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_y_p11_lanes = detail::make_pack<Real>(s12, s19) * f12_y_lanes -
      detail::make_pack<Real>(c12, c19) * f12_x_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_x_p13_lanes = 0.0001194 * wd12_x_p42_lanes +
      detail::make_pack<Real>(6e-06, (-6e-06)) * n11_x_p3_lanes + 0.000144 * n11_x_p1_lanes +
      n11_x_p8_lanes;
  const Lanes<2> n11_y_p12_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      wd12_x_p41_lanes - 0.0001098 * n11_x_p3_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) *
      wd12_x_p42_lanes - n11_y_p8_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> n10_x_p3_lanes = wd10_z_lanes - wd12_x_p25_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> f11_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * wd12_x_p41_lanes - 6e-04 *
      (n11_z_p2_lanes + n11_x_p2_lanes) - n11_y_p11_lanes;
  const Lanes<2> f11_y_lanes = 6e-04 * n11_x_p1_lanes - detail::make_pack<Real>(0.001, (-0.001)) *
      (n11_z_p3_lanes + n11_x_p2_lanes) + f12_z_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p8_lanes = a11_x_lanes - 0.269 * wd11_y_p4_lanes;
  const Lanes<2> a12_z_lanes = 0.269 * wd12_x_p40_lanes - minus_a11_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p14_lanes = 0.00022920000000000001 * wd11_z_lanes - 9.600000000000003e-06 *
      n11_z_p1_lanes + 0.000144 * wd12_x_p40_lanes - n11_z_p9_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_x_p7_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * (minus_a12_y_p2_lanes - f10_x_p1_lanes);

  // link 12 (left_wrist2), inward
  const Lanes<2> f11_z_p5_lanes = detail::make_pack<Real>(s12, s19) * f12_x_lanes +
      detail::make_pack<Real>(c12, c19) * f12_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p15_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p8_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p6_lanes;
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p8_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p6_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_y_p8_lanes = 0.00028099984685315 * n10_y_p1_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * wd12_x_p36_lanes +
      0.0001499998887063 * wd12_x_p37_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p1_lanes = w9_y_lanes * w9_y_lanes;
  const Lanes<2> n9_x_p2_lanes = w9_z_lanes * w9_z_lanes;
  const Lanes<2> n9_y_p1_lanes = w9_x_lanes * w9_x_lanes;

  // link 12 (left_wrist2), inertial wrench
  const Lanes<2> n12_z_p12_lanes = 0.0025100003499999995 * minus_a12_y_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> f11_z_lanes = 6e-04 * n11_x_p3_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      wd12_x_p42_lanes - f11_z_p5_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> f10_x_p8_lanes = 0.0014999985000000002 * (f10_x_p1_lanes + minus_a12_y_p2_lanes) +
      0.28049749700000004 * wd12_x_p36_lanes;
  const Lanes<2> n10_x_p10_lanes = 0.06060754126741261 * wd12_x_p37_lanes + 0.0001499998887063 *
      n10_y_p1_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      n10_x_p3_lanes + n10_x_p7_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p3_lanes = minus_wd9_y_p1_lanes + minus_wd9_y_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p5_lanes = detail::make_pack<Real>(0.0001499998887063,
      (-0.0001499998887063)) * wd10_y_p4_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p14_lanes = 0.000206827662257343 * wd12_z_lanes - 0.000183627662257343 *
      n13_x_p6_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      n13_x_p16_lanes - n12_z_p12_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_p28_lanes = minus_f13_x_p1_lanes * a12_z_lanes + f13_y_p1_lanes *
      minus_a12_y_lanes;
  const Lanes<2> n13_x_lanes = n13_x_p26_lanes + f13_y_p1_lanes * a12_x_lanes;

  // link 9 (left_upperarm), outward
  const Lanes<2> n9_x_p4_lanes = wd12_x_p17_lanes + wd9_z_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> f10_y_lanes = 0.0014999985000000002 * n10_x_p3_lanes - 0.28049749700000004 *
      minus_a12_y_p3_lanes - f11_z_lanes;
  const Lanes<2> f10_x_lanes = detail::make_pack<Real>(c11, c18) * f11_x_lanes -
      detail::make_pack<Real>(s11, s18) * f11_y_lanes - f10_x_p8_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> n13_z_lanes = n13_z_p23_lanes - n13_x_p15_lanes * n13_x_p3_lanes +
      n13_z_p17_lanes * n13_z_p12_lanes + n13_z_p28_lanes;
  tau[12] = n13_z_lanes[0];

  // link 20 (right_hand), inertial wrench
  tau[19] = n13_z_lanes[1];

  // link 13 (left_hand), inward
  const Lanes<2> n12_y_lanes = n13_x_lanes - (0.000195227662257343 * n13_x_p17_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * f12_x_p1_lanes +
      0.0025100003499999995 * a12_z_lanes);

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p11_lanes = 0.06032654142055946 * wd12_x_p25_lanes + 0.060888541114265754 *
      wd10_z_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      wd12_x_p35_lanes - n10_z_p5_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_x_lanes = 1.16e-05 * n12_x_p2_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * n13_z_p17_lanes +
      0.0006000000000000001 * a12_z_lanes + n13_z_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> f10_z_p5_lanes = detail::make_pack<Real>(s11, s18) * f11_x_lanes +
      detail::make_pack<Real>(c11, c18) * f11_y_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_p17_lanes = n12_z_p14_lanes + n13_x_p18_lanes * n13_z_p7_lanes -
      minus_f13_x_p4_lanes * n13_x_p3_lanes - n13_x_p19_lanes * n13_z_p12_lanes;

  // link 10 (left_lowerarm), inertial wrench
  const Lanes<2> n10_z_p13_lanes = 0.0014999985000000002 * minus_a10_y_lanes + 0.28049749700000004 *
      a10_x_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> f8_y_p1_lanes = w8_x_lanes * w8_x_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> f10_z_lanes = 0.0014999985000000002 * n10_y_p1_lanes + 0.28049749700000004 *
      wd12_x_p37_lanes + f10_z_p5_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p10_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (n9_x_p2_lanes - n9_x_p1_lanes);

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_y_p9_lanes = detail::make_pack<Real>(s10, s17) * f10_y_lanes -
      detail::make_pack<Real>(c10, c17) * f10_x_lanes;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_y_p10_lanes = 0.0005895000784280001 * (n9_y_p1_lanes - n9_x_p2_lanes);

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_y_p1_lanes = wd12_x_p9_lanes - wd8_z_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_z_p20_lanes = detail::make_pack<Real>(s12, s19) * n12_x_lanes +
      detail::make_pack<Real>(c12, c19) * n12_y_lanes;

  // link 8 (left_shoulder2), outward
  const Lanes<2> n8_x_p1_lanes = wd8_x_p2_lanes + wd8_x_lanes;

  // link 13 (left_hand), inward
  const Lanes<2> n12_z_lanes = n12_z_p17_lanes + (n13_z_p15_lanes - n13_x_p9_lanes) *
      n13_z_p10_lanes - (0.0006000000000000001 + minus_f13_x_p1_lanes) * a12_x_lanes;
  tau[11] = n12_z_lanes[0];

  // link 20 (right_hand), inward
  tau[18] = n12_z_lanes[1];

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_x_p18_lanes = 0.269 * f12_z_lanes -
      (detail::make_pack<Real>(s12, s19) * n12_y_lanes - detail::make_pack<Real>(c12, c19) *
      n12_x_lanes);
  const Lanes<2> n11_z_lanes = n11_z_p14_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (n11_z_p2_lanes - n11_z_p3_lanes) - n11_z_p15_lanes - n11_z_p20_lanes;
  tau[10] = n11_z_lanes[0];

  // link 19 (right_wrist2), inward
  tau[17] = n11_z_lanes[1];

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_x_p14_lanes = 0.0019585440854647937 * wd12_x_p31_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * n9_x_p3_lanes -
      0.0005895000784280001 * n9_x_p4_lanes + n9_x_p10_lanes;
  const Lanes<2> n9_y_p14_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * wd12_x_p29_lanes - 0.0008177492704690715 * n9_x_p3_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) *
      wd12_x_p31_lanes + n9_y_p10_lanes;
  const Lanes<2> n9_z_p5_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * minus_wd9_y_p4_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_x_lanes = n11_x_p13_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_y_lanes + n11_x_p18_lanes;

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_y_lanes = detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (minus_a12_y_p1_lanes - minus_a12_y_p2_lanes) - n10_y_p8_lanes + 0.0014999985000000002 *
      minus_a10_z_lanes - n11_z_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_y_lanes = n11_y_p12_lanes - 6e-04 * minus_a10_y_lanes +
      (n12_z_lanes + 0.269 * n11_y_p11_lanes);

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_z_p17_lanes = detail::make_pack<Real>(s11, s18) * n11_x_lanes +
      detail::make_pack<Real>(c11, c18) * n11_y_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_x_lanes = 0.0022500062 * (n9_x_p1_lanes + n9_x_p2_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * wd12_x_p29_lanes - n9_y_p9_lanes;

  // link 21 (neck), outward
  const Real wd21_z = qdd[20] - wd6_x;

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_y_lanes = f10_z_lanes - (0.0022500062 * n9_x_p4_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (n9_y_p1_lanes + n9_x_p2_lanes));

  // link 21 (neck), outward
  const Real w21_z = qd[20] - w6_x;
  const Real w21_x = s21 * w6_y + c21 * w6_z;

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_x_lanes = n10_x_p10_lanes - 0.28049749700000004 * minus_a10_z_lanes +
      (detail::make_pack<Real>(c11, c18) * n11_x_lanes - detail::make_pack<Real>(s11, s18) *
      n11_y_lanes);
  const Lanes<2> n10_z_lanes = n10_z_p11_lanes + 0.0001499998887063 *
      (f10_x_p1_lanes - minus_a12_y_p1_lanes) - n10_z_p13_lanes + n10_z_p17_lanes;
  tau[9] = n10_z_lanes[0];

  // link 18 (right_wrist1), inward
  tau[16] = n10_z_lanes[1];

  // link 10 (left_lowerarm), inward
  const Lanes<2> f9_z_p5_lanes = detail::make_pack<Real>(s10, s17) * f10_x_lanes +
      detail::make_pack<Real>(c10, c17) * f10_y_lanes;

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_x_p1_lanes = wd7_x_p1_lanes + wd7_x_lanes;

  // link 21 (neck), outward
  const Real wd22_y_p1 = s21 * a7_y_p3 - c21 * minus_a7_z_p1;
  const Real wd22_y_p2 = w21_x * w21_y;

  // link 22 (head), outward
  const Real w22_z = w21_y + qd[21];

  // link 21 (neck), outward
  const Real minus_wd21_y_p1 = w21_x * w21_z;

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p11_lanes = 0.0027762933559338653 * wd9_z_lanes - 0.001140794814995722 *
      wd12_x_p17_lanes + 0.0005895000784280001 * wd12_x_p28_lanes + n9_z_p5_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> f7_x_p1_lanes = w7_y_lanes * w7_y_lanes;

  // link 21 (neck), outward
  const Real minus_wd21_y_p2 = s21 * minus_a7_z_p1 + c21 * a7_y_p3;

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;

  // link 7 (left_shoulder1), outward
  const Lanes<2> f7_y_p1_lanes = w7_z_lanes * w7_z_lanes;

  // link 21 (neck), outward
  const Real wd22_y_p3 = wd22_y_p2 - wd21_z;

  // link 7 (left_shoulder1), outward
  const Lanes<2> f7_y_p2_lanes = w7_x_lanes * w7_x_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_y_lanes = n9_y_p14_lanes - 0.0022500062 * a8_x_lanes +
      (n10_z_lanes + 0.282 * n9_y_p9_lanes);

  // link 22 (head), outward
  const Real w22_x = c22 * w21_x - s22 * w21_z;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p7_lanes = 0.00010499999999999999 * (f8_y_p1_lanes - a10_x_p2_lanes);

  // link 21 (neck), outward
  const Real minus_wd21_y = minus_wd21_y_p2 + minus_wd21_y_p1;

  // link 23 (left_eye), outward
  const Lanes<2> w23_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p7_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (a10_x_p2_lanes - a10_x_p1_lanes);

  // link 21 (neck), outward
  const Real wd22_y_p4 = 2.0 * (w21_y * w21_z) - wd22_y_p1;

  // link 22 (head), outward
  const Real wd22_y_p5 = w22_x * w22_z;
  const Real n23_y_p1 = w22_x * minus_w22_y;
  const Real wd22_z = qdd[21] - minus_wd21_y;

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p2_lanes = 2.0 * w23_z_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_x_p19_lanes = 0.282 * f10_z_lanes -
      (detail::make_pack<Real>(s10, s17) * n10_y_lanes - detail::make_pack<Real>(c10, c17) *
      n10_x_lanes);
  const Lanes<2> f9_z_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      wd12_x_p31_lanes - 0.0022500062 * n9_x_p3_lanes - f9_z_p5_lanes;

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_y_p7_lanes = detail::make_pack<Real>(s9, s16) * f9_x_lanes +
      detail::make_pack<Real>(c9, c16) * f9_y_lanes;

  // link 22 (head), outward
  const Real a22_y_p1 = a6_x + 0.394 * a7_y_p4;
  const Real n23_y_p3 = n23_y_p1 + wd22_z;
  const Real minus_a23_z_p1 = wd22_z - n23_y_p1;

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p4_lanes = w23_z_lanes * w23_z_lanes;
  const Lanes<2> w23_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;
  const Lanes<2> w23_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_x_lanes = n9_x_p14_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_x_lanes + n9_x_p19_lanes;

  // link 22 (head), outward
  const Real wd22_y_p6 = c22 * wd22_y_p3 - s22 * wd22_y_p4;
  const Real a22_y_p2 = a21_x - 0.394 * minus_wd21_y_p2;
  const Real n23_y_p5 = s22 * wd22_y_p3 + c22 * wd22_y_p4;

  // link 23 (left_eye), outward
  const Lanes<2> n23_z_p1_lanes = w23_x_lanes * w23_y_lanes;

  // link 22 (head), outward
  const Real wd22_y = wd22_y_p6 - wd22_y_p5;
  const Real n23_y_p8 = n23_y_p5 - 2.0 * (minus_w22_y * w22_z);

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p5_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * wd12_x_p21_lanes;

  // link 21 (neck), outward
  const Real a23_y_p1 = w21_x * w21_x;
  const Real a23_y_p2 = w21_z * w21_z;

  // link 22 (head), outward
  const Real a23_y_p3 = wd22_y_p5 - wd22_y;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;

  // link 22 (head), outward
  const Real a23_y_p4 = minus_w22_y * minus_w22_y;
  const Real a23_y_p5 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Lanes<2> wd23_z_lanes = detail::make_pack<Real>(qdd[22], qdd[23]) - wd22_y;

  // link 22 (head), outward
  const Real a22_y = c22 * a22_y_p1 - s22 * a22_y_p2;

  // link 21 (neck), outward
  const Real a23_y_p7 = a23_y_p1 + a23_y_p2;

  // link 22 (head), outward
  const Real a22_z = 0.394 * wd22_y_p1 - minus_a21_y;
  const Real a22_x = c22 * a22_y_p2 + s22 * a22_y_p1;
  const Real a23_y_p8 = a23_y_p4 + a23_y_p5;

  // link 23 (left_eye), outward
  const Lanes<2> f23_y_p1_lanes = n23_z_p1_lanes + wd23_z_lanes;
  const Lanes<2> n23_x_p4_lanes = detail::make_pack<Real>(s23, s24) * n23_y_p3 +
      detail::make_pack<Real>(c23, c24) * n23_y_p8;

  // link 24 (right_eye), outward
  const Real minus_a23_z_p3 = a22_y + 0.095 * minus_a23_z_p1;
  const Real a23_y_p10 = a22_z + 0.095 * a23_y_p3;

  // link 23 (left_eye), outward
  const Lanes<2> n23_y_p14_lanes = n23_y_p2_lanes * w23_x_lanes -
      (detail::make_pack<Real>(c23, c24) * n23_y_p3 - detail::make_pack<Real>(s23, s24) * n23_y_p8);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> f23_y_lanes = 0.00025 * f23_y_p1_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_z_lanes = minus_a23_z_p3 - detail::make_pack<Real>(0.032, (-0.032)) *
      n23_y_p5;

  // link 24 (right_eye), outward
  const Real a23_y_p12 = a22_x - 0.095 * a23_y_p8;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_p16_lanes = 0.00025 * minus_a23_z_lanes;
  const Lanes<2> minus_f23_x_lanes = 0.00025 * (w23_y_lanes * w23_y_lanes + n23_y_p4_lanes);

  // link 9 (left_upperarm), inertial wrench
  const Lanes<2> n9_z_p14_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_x_lanes = 4e-06 * (n23_x_p4_lanes + n23_y_p2_lanes * w23_y_lanes) -
      2.8750000000000004e-05 * f23_y_p1_lanes;

  // link 7 (left_shoulder1), outward
  const Lanes<2> n7_y_p1_lanes = wd12_x_p3_lanes - wd7_z_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * n8_y_p1_lanes - 0.7139200499999999 * a10_x_p3_lanes - f9_z_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_p15_lanes = detail::make_pack<Real>(s23, s24) *
      (a23_y_p12 + detail::make_pack<Real>(0.032, (-0.032)) * wd22_y_p6);

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_y_lanes = 2.8750000000000004e-05 *
      (w23_x_lanes * w23_x_lanes - n23_y_p4_lanes) - 5.25e-06 * n23_y_p14_lanes + n23_y_p16_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> f8_y_lanes = 0.7139200499999999 * wd12_x_p20_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (f8_y_p1_lanes + a10_x_p2_lanes) + f8_y_p7_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> a23_y_lanes = detail::make_pack<Real>(c23, c24) *
      (a23_y_p10 - detail::make_pack<Real>(0.032, (-0.032)) * a23_y_p7) - a23_y_p15_lanes;

  // link 23 (left_eye), inward
  const Lanes<2> n22_y_p9_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_y_lanes;
  const Lanes<2> n22_y_p11_lanes = detail::make_pack<Real>(c23, c24) * f23_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_x_lanes;

  // link 21 (neck), outward
  const Real n21_x_p1 = wd22_y_p2 + wd21_z;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_y_p12_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * n8_y_p1_lanes -
      0.18113119219699997 * wd12_x_p24_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * n8_x_p1_lanes + n8_y_p7_lanes;

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_z_p16_lanes = detail::make_pack<Real>(s10, s17) * n10_x_lanes +
      detail::make_pack<Real>(c10, c17) * n10_y_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_x_p10_lanes = 0.00012075 * n8_x_p1_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) *
      wd12_x_p24_lanes - 0.00010499999999999999 * wd12_x_p20_lanes + n8_x_p7_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_p7_lanes = 0.00025 * a23_y_lanes;

  // link 23 (left_eye), inward
  const Real n22_y_p13 = n22_y_p11_lanes[1] + n22_y_p11_lanes[0];

  // link 22 (head), outward
  const Real n22_z_p1 = w22_x * w22_x;

  // link 23 (left_eye), inward
  const Lanes<2> n22_x_p9_lanes = detail::make_pack<Real>(c23, c24) * n23_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_y_lanes + detail::make_pack<Real>(8e-06, (-8e-06)) *
      n23_y_p14_lanes;
  const Lanes<2> n22_z_p2_lanes = detail::make_pack<Real>(s23, s24) * n23_x_lanes;

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p11_lanes = 0.18101044219699997 * wd12_x_p9_lanes + 0.18125194219699997 *
      wd8_z_lanes + 0.00010499999999999999 * wd8_x_p4_lanes - n8_z_p5_lanes;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> n23_z_lanes = 1.2499999999999999e-06 * n23_z_p1_lanes + 9.25e-06 * wd23_z_lanes -
      2.8750000000000004e-05 * n23_x_p4_lanes + n23_z_p7_lanes;
  tau[22] = n23_z_lanes[0];

  // link 24 (right_eye), inertial wrench
  tau[23] = n23_z_lanes[1];

  // link 23 (left_eye), inward
  const Lanes<2> n22_z_p4_lanes = detail::make_pack<Real>(c23, c24) * n23_y_lanes;
  const Real f22_z = 0.072575 * a23_y_p3 - 0.43200000000000005 * n23_y_p8 + n22_y_p13;
  const Real f22_y_p1 = n23_y_p14_lanes[1] + n23_y_p14_lanes[0];
  const Real n22_x = 0.05450270000000001 * n23_y_p8 - 0.0074 * a23_y_p3 - 0.43200000000000005 *
      a22_z + n22_x_p9_lanes[1] + n22_x_p9_lanes[0];

  // link 21 (neck), outward
  const Real n21_y_p1 = minus_wd21_y_p1 + minus_wd21_y;

  // link 23 (left_eye), inward
  const Real n22_y_p14 = 0.0074 * n23_y_p8 - 0.009438624999999999 * a23_y_p3 - 0.072575 * a22_z -
      n23_z_lanes[1] - (-0.032) * n22_y_p9_lanes[1];

  // link 9 (left_upperarm), inward
  const Lanes<2> f7_x_p7_lanes = detail::make_pack<Real>(s9, s16) * f9_y_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p7_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (f7_y_p1_lanes - f7_x_p1_lanes);

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_z_lanes = n9_z_p11_lanes + detail::make_pack<Real>((-4.4999986458742003e-05),
      4.4999986458742003e-05) * (n9_x_p1_lanes - n9_y_p1_lanes) + n9_z_p14_lanes - n9_z_p16_lanes;
  tau[8] = n9_z_lanes[0];

  // link 17 (right_lowerarm), inward
  tau[15] = n9_z_lanes[1];

  // link 23 (left_eye), inward
  const Real n22_z_p6 = 0.04506407500000001 * n23_y_p1 + 0.06394132500000001 * wd22_z - 0.0074 *
      (a23_y_p4 - n22_z_p1) + 0.072575 * a22_y;
  const Real f22_y = 0.072575 * minus_a23_z_p1 + 0.43200000000000005 * (n22_z_p1 + a23_y_p5) -
      0.00025 * f22_y_p1;
  const Real f22_x = 0.43200000000000005 * n23_y_p3 - 0.072575 * a23_y_p8 - n22_y_p9_lanes[1] -
      n22_y_p9_lanes[0];

  // link 8 (left_shoulder2), inertial wrench
  const Lanes<2> n8_z_p15_lanes = 0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes;

  // link 23 (left_eye), inward
  const Real n22_y = n22_y_p14 - n23_z_lanes[0] - 0.032 * n22_y_p9_lanes[0] - 0.095 * n22_y_p13;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_p7_lanes = 0.0017499999999999998 *
      (wd12_x_p11_lanes + (f7_y_p2_lanes + f7_y_p1_lanes));

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p9_lanes = 0.0017499999999999998 * minus_a7_z_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_y_lanes = n8_y_p12_lanes - 0.7139200499999999 * a7_x_lanes +
      (detail::make_pack<Real>(s9, s16) * n9_x_lanes + detail::make_pack<Real>(c9, c16) *
      n9_y_lanes);
  const Lanes<2> n8_x_lanes = n8_x_p10_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes - n9_z_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p7_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (f7_y_p2_lanes - f7_y_p1_lanes);

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_x_p11_lanes = 0.7139200499999999 * wd12_x_p24_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * n8_x_p1_lanes +
      detail::make_pack<Real>(c9, c16) * f9_x_lanes - f7_x_p7_lanes;

  // link 22 (head), inward
  const Real n21_y_p2 = s22 * f22_y - c22 * f22_x;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_z_p16_lanes = detail::make_pack<Real>(c9, c16) * n9_x_lanes -
      detail::make_pack<Real>(s9, s16) * n9_y_lanes;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_x_p10_lanes = 0.0001505 * n7_x_p1_lanes + 8.75e-06 * wd12_x_p16_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) *
      wd12_x_p11_lanes + n7_x_p7_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_y_lanes = detail::make_pack<Real>(c8, c15) * f8_x_lanes -
      detail::make_pack<Real>(s8, s15) * f8_y_lanes + f7_y_p7_lanes;
  const Lanes<2> f7_x_lanes = f7_x_p11_lanes - 0.0017499999999999998 *
      (f7_x_p1_lanes + f7_y_p1_lanes + n7_y_p1_lanes);

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p5_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * wd12_x_p14_lanes;

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_z_lanes = n8_z_p11_lanes + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (a10_x_p1_lanes - f8_y_p1_lanes) - n8_z_p15_lanes +
      n8_z_p16_lanes;
  tau[7] = n8_z_lanes[0];

  // link 16 (right_upperarm), inward
  tau[14] = n8_z_lanes[1];

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_y_p11_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * n7_y_p1_lanes - 0.0002975 * wd12_x_p16_lanes - 8.75e-06 *
      n7_x_p1_lanes + n7_y_p7_lanes;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * wd22_y_p4 - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 8 (left_shoulder2), inward
  const Lanes<2> f7_z_lanes = detail::make_pack<Real>(s8, s15) * f8_x_lanes +
      detail::make_pack<Real>(c8, c15) * f8_y_lanes + 0.0017499999999999998 *
      (wd12_x_p16_lanes - n7_x_p1_lanes);

  // link 23 (left_eye), inward
  const Real n22_z = n22_z_p6 + 0.43200000000000005 * a22_x + n22_z_p2_lanes[1] +
      n22_z_p4_lanes[1] + n22_z_p2_lanes[0] + n22_z_p4_lanes[0] - 2.375e-05 * f22_y_p1;
  tau[21] = n22_z;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_x_lanes = n7_x_p10_lanes + n7_x_p9_lanes + n8_z_lanes;

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (w21_y * w21_y + a23_y_p2) + n21_y_p2;

  // link 7 (left_shoulder1), inertial wrench
  const Lanes<2> n7_z_p9_lanes = 0.00014700000000000002 * wd12_x_p3_lanes + 0.000448 * wd7_z_lanes +
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * wd7_x_p4_lanes -
      n7_z_p5_lanes;

  // link 7 (left_shoulder1), inward
  const Real f6_y_p1 = f7_z_lanes[1] + f7_z_lanes[0];

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p1 - (s22 * f22_x + c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p1 = 1.26882463592404 * wd12_x_p1 + 2.06965463592404 * wd6_z -
      0.0187369177636143 * wd6_x_p9 + 6.1665928899999995 * minus_a6_y + c21 * n21_x;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a23_y_p1 - a23_y_p2) - 0.000703125 * n21_y_p1 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p2);
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_y_lanes = n7_y_p11_lanes + n7_x_p9_lanes +
      (detail::make_pack<Real>(c8, c15) * n8_x_lanes - detail::make_pack<Real>(s8, s15) *
      n8_y_lanes);

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p2_lanes = detail::make_pack<Real>(c7, c14) * n7_x_lanes;
  const Lanes<2> f6_x_p5_lanes = detail::make_pack<Real>(s7, s14) * f7_x_lanes +
      detail::make_pack<Real>(c7, c14) * f7_y_lanes;
  const Lanes<2> f6_z_p5_lanes = detail::make_pack<Real>(c7, c14) * f7_x_lanes -
      detail::make_pack<Real>(s7, s14) * f7_y_lanes;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p12_lanes = detail::make_pack<Real>(c8, c15) * n8_y_lanes;

  // link 5 (chest2), outward
  const Real f5_x_p1 = minus_w5_y * minus_w5_y;

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_z_p4_lanes = detail::make_pack<Real>(s7, s14) * n7_y_lanes;
  const Real f6_z_p7 = f6_z_p5_lanes[1] + f6_z_p5_lanes[0];

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_p16_lanes = n7_z_p9_lanes + 8.75e-06 * (f7_x_p1_lanes - f7_y_p2_lanes) +
      detail::make_pack<Real>(s8, s15) * n8_x_lanes + n7_z_p12_lanes;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_y_p3 - 0.0187369177636143 *
      (minus_a7_z_p2 - a7_y_p1) + s21 * n21_x;
  const Real f6_x = 6.1665928899999995 * a7_y_p4 - f21_z + f6_x_p5_lanes[1] + f6_x_p5_lanes[0];
  const Real f6_y = f6_y_p1 - 6.1665928899999995 * minus_a7_z_p1 - s21 * minus_f21_x + c21 * f21_y;

  // link 22 (head), inward
  const Real n21_z = 0.006216750000000001 * wd21_z - 0.0048105000000000005 * wd22_y_p2 + 0.0016155 *
      wd22_y_p1 - 0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_z_lanes = n7_z_p16_lanes + 0.0017499999999999998 * (a7_y_lanes + a7_x_lanes);
  tau[6] = n7_z_lanes[0];

  // link 15 (right_shoulder2), inward
  tau[13] = n7_z_lanes[1];

  // link 7 (left_shoulder1), inward
  const Lanes<2> n6_x_p9_lanes = detail::make_pack<Real>(s7, s14) * n7_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_y_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      f6_z_p5_lanes;

  // link 4 (chest1), outward
  const Real f4_x_p1 = qd[3] * qd[3];

  // link 7 (left_shoulder1), inward
  const Real f6_z = f6_z_p7 - 6.1665928899999995 * a7_y_p3 - c21 * minus_f21_x - s21 * f21_y;

  // link 6 (chest3), inward
  const Real f5_y = 0.069699984375 * wd6_x_p6 + 2.2194301519999997 * a6_x_p4 +
      (c6 * f6_x - s6 * f6_y);
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p6 = n6_z_p1 - s21 * n21_y + n6_z_p2_lanes[1] - n6_z_p4_lanes[1] - (-0.18) *
      f6_x_p5_lanes[1] + n6_z_p2_lanes[0] - n6_z_p4_lanes[0];

  // link 6 (chest3), inward
  const Real f5_x = 2.2194301519999997 * a6_z_p1 - 0.069699984375 * (f5_x_p1 + a6_x_p2) + f6_z;

  // link 7 (left_shoulder1), inward
  const Real n6_x = 0.40041499999999997 * wd12_x_p7 + 0.0187369177636143 * minus_a7_z_p1 - n21_z +
      n6_x_p9_lanes[1] + n6_x_p9_lanes[0];
  const Real n6_y = n6_y_p1 + c21 * n21_y + n7_z_lanes[1] + n7_z_lanes[0] + 0.226 * f6_z_p7;

  // link 4 (chest1), outward
  const Real f4_y_p1 = wd6_x_p2 + qdd[3];

  // link 6 (chest3), inward
  const Real f5_z = 0.069699984375 * wd6_x_p8 - 2.2194301519999997 * a6_x_p3 + n5_x_p1;

  // link 7 (left_shoulder1), inward
  const Real n6_z = n6_z_p6 - 0.18 * f6_x_p5_lanes[0] - 0.226 * f6_y_p1;
  tau[5] = n6_z;

  // link 5 (chest2), inward
  const Real f4_x_p2 = s5 * f5_y - c5 * f5_x;

  // link 4 (chest1), outward
  const Real minus_f4_z_p1 = wd4_y_p2 - wd4_y;

  // link 5 (chest2), inward
  const Real f4_y = f5_z - 0.0300000063 * f4_y_p1;
  const Real f4_x = 0.0300000063 * (w4_y * w4_y + f4_x_p1) - f4_x_p2;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p3 - 0.04675382692737882 * wd6_x_p8 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);
  const Real n5_x = 0.15637308509675518 * a6_x_p3 - 0.005678398088837119 * wd6_x_p8 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);

  // link 5 (chest2), inertial wrench
  const Real n5_z_p1 = 0.10961925816937637 * wd6_x_p4 + 0.203126912024134 * wd5_z -
      0.005678398088837119 * (f5_x_p1 - a6_x_p1) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 5 (chest2), inward
  const Real minus_f4_z = 0.0300000063 * minus_f4_z_p1 + (s5 * f5_x + c5 * f5_y);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p1 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);
  tau[4] = n5_z;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * a5_y_p1 + 8.419374554 * wd3_z + (c4 * f4_x - s4 * f4_y);
  const Real f3_y = 8.419374554 * a5_y_p1 - 0.02999999505 * wd3_z + minus_f4_z;

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * f4_x_p2 -
      (0.01227760324629517 * minus_f4_z_p1 + 0.005880002159562879 * (w4_x * w4_x - f4_x_p1) +
      0.0300000063 * a3_y);
  const Real n4_x = 0.0478915 * wd6_x_p5 + 0.005880002159562879 * f4_y_p1 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);

  // link 3 (hip), inward
  const Real f2_x_p1 = c3 * f3_x - s3 * f3_y;
  const Real f2_x = 24.5839218 * wd2_z - 0.031999971599999996 * a3_x_p1 + f2_x_p1;
  const Real f2_y = 0.031999971599999996 * wd2_z + 24.5839218 * a3_x_p1 + (s3 * f3_x + c3 * f3_y);

  // link 4 (chest1), inward
  const Real n3_z = 1.7824817919087104 * wd3_z + (8.419374554 * a3_x - 0.02999999505 * a3_y) +
      (s4 * n4_x + c4 * n4_y);
  tau[2] = n3_z;

  // link 5 (chest2), inward
  const Real n4_z = 0.060169103246295166 * qdd[3] - 0.03561389675370483 * wd6_x_p2 +
      0.005880002159562879 * wd6_x_p1 + 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 3 (hip), inward
  const Real n2_z = 9.885744550888212 * wd2_z + (0.031999971599999996 * a2_y + 24.5839218 * a2_x) +
      (n3_z + 0.422 * f2_x_p1);
  tau[1] = n2_z;

  // link 2 (thigh), inward
  const Real n1_z = 13.049859506913753 * qdd[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + 0.434 * (c2 * f2_x - s2 * f2_y));
  tau[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
