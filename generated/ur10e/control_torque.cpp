// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By Chang table 6.1, fused; Lambda^-1: M = L^T D L, J carried inward, in the axes of link 5
//   (wrist_2) at link origins.
// 835 flops (add 352, mul 474, div 9), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

template <int count>
using Lanes = detail::Pack<Real, count>;
void control_torque(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd_0)[6], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];
  const Real c1 = cosines[4];
  const Real s1 = sines[4];

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p1 = 0.0054190910375000005 * s5;
  const Real f6_y_p2 = 0.09132825 * s5;
  const Real f6_y_p3 = 0.09132825 * c5;
  const Real f6_y_p4 = 0.0106962107625 * c5;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p5 = 1.2551157591996094 * c5;
  const Real f6_y_p6 = 0.6127 * s2;
  const Real f6_y_p7 = 0.6127 * c2;
  const Real f6_y_p8 = 1.156008191975 * s2;
  const Real f6_y_p9 = c2 * c3 - s2 * s3;
  const Real f6_y_p10 = s2 * c3 + c2 * s3;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p11 = s5 * f6_y_p1;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p12 = c5 * (0.000623 * c5);
  const Real f6_y_p13 = 0.57155 * f6_y_p10;
  const Real f6_y_p14 = 0.57155 * f6_y_p9;
  const Real f6_y_p15 = 4.0059802 * f6_y_p10;
  const Real f6_y_p16 = 4.0059802 * f6_y_p9;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p17 = 0.041592816387499995 + f6_y_p11;
  const Real f6_y_p18 = 0.5656542411875001 * f6_y_p10;
  const Real f6_y_p19 = f6_y_p9 * c4 - f6_y_p10 * s4;
  const Real f6_y_p20 = f6_y_p10 * c4 + f6_y_p9 * s4;
  const Real f6_y_p21 = 0.33495075 * f6_y_p19;
  const Real f6_y_p22 = f6_y_p20 * f6_y_p2;
  const Real f6_y_p23 = 0.33495075 * f6_y_p20;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p24 = f6_y_p20 * f6_y_p3;
  const Real f6_y_p25 = f6_y_p19 * f6_y_p3;

  // link 5 (wrist_2), pose
  const Real f6_y_p26 = f6_y_p20 * c5;
  const Real f6_y_p27 = f6_y_p20 * s5;
  const Real f6_y_p28 = 0.0585962731125 * f6_y_p19;
  const Real f6_y_p29 = f6_y_p19 * s5;

  // link 5 (wrist_2), Jacobian
  const Real f6_y_p30 = 0.11985 * f6_y_p19;
  const Real f6_y_p31 = 0.11985 * f6_y_p20;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p32 = f6_y_p21 + f6_y_p22;
  const Real f6_y_p33 = f6_y_p23 - f6_y_p19 * f6_y_p2;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p34 = 1.0 / (f6_y_p17 - f6_y_p12 - f6_y_p5 * f6_y_p4);

  // link 6 (wrist_3), mass matrix
  const Real f6_y_p35 = 0.000623 * f6_y_p27;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p36 = f6_y_p14 * f6_y_p33;

  // link 5 (wrist_2), pose
  const Real f6_y_p37 = f6_y_p19 * c5;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p38 = c5 * f6_y_p35;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p39 = f6_y_p13 * f6_y_p32 - f6_y_p36;

  // link 3 (forearm), composite inertia
  const Real f6_y_p40 = f6_y_p7 * (f6_y_p33 - f6_y_p16);

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p41 = f6_y_p14 * f6_y_p24 - f6_y_p13 * f6_y_p25 - f6_y_p4;

  // link 4 (wrist_1), Jacobian
  const Real f6_y_p42 = f6_y_p30 + f6_y_p13;
  const Real f6_y_p43 = f6_y_p31 - f6_y_p14;
  const Real f6_y_p44 = f6_y_p30 * f6_y_p20 - f6_y_p31 * f6_y_p19;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p45 = 117.34209310833121 * f6_y_p41;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p46 = f6_y_p41 + (f6_y_p7 * f6_y_p24 - f6_y_p6 * f6_y_p25);

  // link 3 (forearm), composite inertia
  const Real f6_y_p47 = f6_y_p6 * (f6_y_p15 + f6_y_p32) - f6_y_p40;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p48 = f6_y_p28 + (f6_y_p26 * f6_y_p1 + f6_y_p19 * f6_y_p4 + 0.17415 * f6_y_p22);

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p49 = 0.0106962107625 * f6_y_p27 - 0.0085220910375 * f6_y_p19 - 0.17415 *
      f6_y_p25 - (f6_y_p14 + f6_y_p7) * f6_y_p2;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p50 = f6_y_p17 + f6_y_p39 - f6_y_p12;

  // link 4 (wrist_1), Jacobian
  const Real f6_y_p51 = f6_y_p31 * f6_y_p27 + f6_y_p30 * f6_y_p29;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p52 = 117.34209310833121 * f6_y_p46;
  const Real f6_y_p53 = 0.037099816387500005 * f6_y_p20;
  const Real f6_y_p54 = 2.07831527531 * f6_y_p10;
  const Real f6_y_p55 = f6_y_p50 + f6_y_p5 * f6_y_p41;
  const Real f6_y_p56 = 4.36318718615 * s2;
  const Real f6_y_p57 = f6_y_p55 * f6_y_p34;
  const Real f6_y_p58 = 2.08330527531 + (f6_y_p17 + 2.0 * f6_y_p39) - f6_y_p12;
  const Real f6_y_p59 = f6_y_p48 + f6_y_p38 + f6_y_p5 * f6_y_p49;
  const Real f6_y_p60 = 117.34209310833121 * f6_y_p49;
  const Real f6_y_p61 = f6_y_p50 + f6_y_p6 * f6_y_p32 - f6_y_p7 * f6_y_p33 + f6_y_p5 * f6_y_p46;

  // link 4 (wrist_1), Jacobian
  const Real f6_y_p62 = f6_y_p31 * f6_y_p26 + f6_y_p30 * f6_y_p37;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p63 = f6_y_p18 + (f6_y_p48 + f6_y_p13 * f6_y_p3) + f6_y_p38;
  const Real f6_y_p64 = f6_y_p61 * f6_y_p34;
  const Real f6_y_p65 = f6_y_p59 * f6_y_p34;

  // link 3 (forearm), Jacobian
  const Real f6_y_p66 = f6_y_p42 + f6_y_p6;
  const Real f6_y_p67 = f6_y_p43 - f6_y_p7;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p68 = f6_y_p58 + f6_y_p47 - f6_y_p45 * f6_y_p46 - f6_y_p57 * f6_y_p61;
  const Real f6_y_p69 = 1.0 / (f6_y_p58 - f6_y_p45 * f6_y_p41 - f6_y_p57 * f6_y_p55);
  const Real f6_y_p70 = 4.910283130787501 - s2 * f6_y_p56 + (2.08081027531 - f6_y_p10 * f6_y_p54) +
      (0.001315 + f6_y_p20 * f6_y_p53);
  const Real f6_y_p71 = f6_y_p63 - f6_y_p45 * f6_y_p49 - f6_y_p57 * f6_y_p59;
  const Real f6_y_p72 = (1.0 - f6_y_p57) * s5;
  const Real f6_y_p73 = f6_y_p45 + f6_y_p57 * f6_y_p5;
  const Real f6_y_p74 = f6_y_p42 * f6_y_p20 - f6_y_p43 * f6_y_p19 - f6_y_p57 * f6_y_p44;
  const Real f6_y_p75 = f6_y_p57 * f6_y_p51 - (f6_y_p43 * f6_y_p27 + f6_y_p42 * f6_y_p29);
  const Real f6_y_p76 = f6_y_p43 * f6_y_p26 + f6_y_p42 * f6_y_p37 - f6_y_p57 * f6_y_p62;
  const Real f6_y_p77 = 0.0085220910375 + f6_y_p70 - f6_y_p20 *
      (f6_y_p20 * (0.0012399999999999998 + f6_y_p11) + 0.021392421525 * f6_y_p29) + 0.031809629475 *
      c5;
  const Real f6_y_p78 = f6_y_p68 * f6_y_p69;
  const Real f6_y_p79 = f6_y_p71 * f6_y_p69;
  const Real f6_y_p80 = f6_y_p73 * f6_y_p69;
  const Real f6_y_p81 = f6_y_p5 * f6_y_p34;
  const Lanes<8> f6_y_p82_lanes = detail::make_pack<Real>(f6_y_p76, f6_y_p76, f6_y_p74, f6_y_p72,
      f6_y_p76, f6_y_p76, f6_y_p76, f6_y_p76) * f6_y_p69;
  const Lanes<8> f6_y_p85_lanes = detail::make_pack<Real>(f6_y_p62, f6_y_p62, f6_y_p44, s5,
      f6_y_p62, f6_y_p62, f6_y_p62, f6_y_p62) * f6_y_p34;
  const Real f6_y_p88 = f6_y_p75 * f6_y_p69;
  const Real f6_y_p89 = f6_y_p51 * f6_y_p34;
  const Real f6_y_p90 = 4.3866871861500005 + f6_y_p58 + 2.0 * f6_y_p47 - f6_y_p52 * f6_y_p46 -
      f6_y_p64 * f6_y_p61 - f6_y_p78 * f6_y_p68;
  const Real f6_y_p91 = f6_y_p8 + f6_y_p63 + f6_y_p6 * f6_y_p3 - f6_y_p52 * f6_y_p49 - f6_y_p64 *
      f6_y_p59 - f6_y_p78 * f6_y_p71;
  const Real f6_y_p92 = f6_y_p77 - f6_y_p27 * f6_y_p35 - f6_y_p60 * f6_y_p49 - f6_y_p65 * f6_y_p59 -
      f6_y_p79 * f6_y_p71;
  const Real f6_y_p93 = f6_y_p78 * f6_y_p73 - (f6_y_p52 + f6_y_p64 * f6_y_p5);
  const Real f6_y_p94 = (1.0 - f6_y_p64) * s5 - f6_y_p78 * f6_y_p72;
  const Real f6_y_p95 = f6_y_p66 * f6_y_p20 - f6_y_p67 * f6_y_p19 - f6_y_p64 * f6_y_p44 - f6_y_p78 *
      f6_y_p74;
  const Real f6_y_p96 = f6_y_p64 * f6_y_p51 - (f6_y_p67 * f6_y_p27 + f6_y_p66 * f6_y_p29) -
      f6_y_p78 * f6_y_p75;
  const Real f6_y_p97 = f6_y_p67 * f6_y_p26 + f6_y_p66 * f6_y_p37 - f6_y_p64 * f6_y_p62 - f6_y_p78 *
      f6_y_p76;
  const Real f6_y_p98 = 1.0 / f6_y_p90;
  const Lanes<8> f6_y_p105_lanes = f6_y_p85_lanes * f6_y_p62 + f6_y_p82_lanes * f6_y_p76;

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];

  // link 1 (shoulder), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 2 (upper_arm), outward
  const Real a3_x_p2 = qd[1] * qd[1];

  // link 3 (forearm), outward
  const Real a4_x_p1 = w3_z * w3_z;
  const Real wd3_z = qdd_0[1] + qdd_0[2];

  // link 2 (upper_arm), outward
  const Real a4_z_p1 = 2.0 * qd[0];

  // link 1 (shoulder), mass matrix
  const Real f6_y_p108 = f6_y_p91 * f6_y_p98;
  const Lanes<8> f6_y_p109_lanes = detail::make_pack<Real>(f6_y_p97, f6_y_p96, f6_y_p95, f6_y_p94,
      f6_y_p97, f6_y_p93, f6_y_p97, f6_y_p97) * f6_y_p98;

  // link 3 (forearm), outward
  const Real a4_x_p2 = a3_x_p1 + a4_x_p1;
  const Real a4_z_p2 = a4_z_p1 * w3_z;

  // link 2 (upper_arm), outward
  const Real a3_z_p1 = a4_z_p1 * qd[1];

  // link 6 (wrist_3), outward
  const Real minus_f6_x_p1 = 9.81 + xdd_cmd[2];

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];

  // link 5 (wrist_2), outward
  const Real w5_x_p1 = f6_y_p20 * qd[0];

  // link 3 (forearm), outward
  const Real a3_x = (a3_x_p1 + a3_x_p2) * f6_y_p7 + qdd_0[1] * f6_y_p6;
  const Real a3_y = 9.81 + (a3_x_p2 * f6_y_p6 - qdd_0[1] * f6_y_p7);

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p130_lanes = detail::make_pack<Real>(0.17415 * f6_y_p37 - f6_y_p67 * s5 -
      f6_y_p65 * f6_y_p62 - f6_y_p79 * f6_y_p76, f6_y_p65 * f6_y_p51 -
      (f6_y_p67 * c5 + 0.17415 * f6_y_p29) - f6_y_p79 * f6_y_p75, 0.17415 * f6_y_p20 - f6_y_p65 *
      f6_y_p44 - f6_y_p79 * f6_y_p74, f6_y_p26 - f6_y_p65 * s5 - f6_y_p79 * f6_y_p72, 0.17415 *
      f6_y_p37 - f6_y_p67 * s5 - f6_y_p65 * f6_y_p62 - f6_y_p79 * f6_y_p76, f6_y_p79 * f6_y_p73 -
      (f6_y_p19 + f6_y_p60 + f6_y_p65 * f6_y_p5), 0.17415 * f6_y_p37 - f6_y_p67 * s5 - f6_y_p65 *
      f6_y_p62 - f6_y_p79 * f6_y_p76, 0.17415 * f6_y_p37 - f6_y_p67 * s5 - f6_y_p65 * f6_y_p62 -
      f6_y_p79 * f6_y_p76) - f6_y_p108 * detail::make_pack<Real>(f6_y_p97, f6_y_p96, f6_y_p95,
      f6_y_p94, f6_y_p97, f6_y_p93, f6_y_p97, f6_y_p97);
  const Lanes<8> f6_y_p140_lanes = detail::make_pack<Real>(f6_y_p89 * f6_y_p51 + f6_y_p88 *
      f6_y_p75, f6_y_p89 * f6_y_p51 + f6_y_p88 * f6_y_p75, f6_y_p82_lanes[2] * f6_y_p75 -
      f6_y_p85_lanes[2] * f6_y_p51, f6_y_p82_lanes[3] * f6_y_p75 - f6_y_p85_lanes[3] * f6_y_p51,
      f6_y_p89 * f6_y_p51 + f6_y_p88 * f6_y_p75, f6_y_p89 * f6_y_p51 + f6_y_p88 * f6_y_p75,
      f6_y_p89 * f6_y_p51 + f6_y_p88 * f6_y_p75, f6_y_p89 * f6_y_p51 + f6_y_p88 * f6_y_p75) +
      f6_y_p109_lanes * f6_y_p96;

  // link 4 (wrist_1), outward
  const Real wd4_x = qd[0] * w4_z;
  const Real a4_x = a3_x + (a4_x_p2 * f6_y_p14 + wd3_z * f6_y_p13);
  const Real a4_y = a3_y + (a4_x_p1 * f6_y_p13 - wd3_z * f6_y_p14);

  // link 6 (wrist_3), outward
  const Real minus_f6_x_p2 = c1 * xdd_cmd[0] + s1 * xdd_cmd[1];

  // link 4 (wrist_1), outward
  const Real wd4_z = wd3_z + qdd_0[3];

  // link 3 (forearm), outward
  const Real a3_z = qdd_0[0] * f6_y_p7 - a3_z_p1 * f6_y_p6;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p146 = 1.0 / (f6_y_p92 - f6_y_p108 * f6_y_p91 - 2.0 * (f6_y_p36 + f6_y_p40));

  // link 5 (wrist_2), outward
  const Real a5_x_p1 = a4_x + 0.17415 * qdd_0[0];
  const Real w5_x = c5 * w5_x_p1 + s5 * w4_z;
  const Real w5_y = c5 * w4_z - s5 * w5_x_p1;

  // link 4 (wrist_1), outward
  const Real a4_z = a3_z + (qdd_0[0] * f6_y_p14 - a4_z_p2 * f6_y_p13);

  // link 6 (wrist_3), outward
  const Real minus_f6_x_p3 = c1 * xdd_cmd[1] - s1 * xdd_cmd[0];

  // link 5 (wrist_2), outward
  const Real wd5_y_p1 = f6_y_p19 * wd4_x + f6_y_p20 * qdd_0[0];
  const Real w5_z = qd[4] - f6_y_p19 * qd[0];
  const Real wd6_y_p1 = w5_x * w5_y;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];
  const Real minus_f6_x_p4 = c1 * xdd_cmd[3] + s1 * xdd_cmd[4];

  // link 5 (wrist_2), outward
  const Real a5_x_p2 = a4_z - 0.17415 * a3_x_p1;

  // link 6 (wrist_3), outward
  const Real minus_f6_x_p5 = f6_y_p19 * minus_f6_x_p2 + f6_y_p20 * minus_f6_x_p1;

  // link 5 (wrist_2), outward
  const Real wd5_z = qdd_0[4] - (f6_y_p19 * qdd_0[0] - f6_y_p20 * wd4_x);
  const Real minus_f6_x_p6 = w5_x * w5_z;

  // link 6 (wrist_3), outward
  const Real wd6_y_p2 = w5_x * w6_z;

  // link 5 (wrist_2), outward
  const Real a5_x_p3 = f6_y_p19 * a5_x_p1 + f6_y_p20 * a4_y;
  const Real minus_f6_z_p1 = w5_y * w5_z;
  const Real minus_f6_z_p2 = w5_x * w5_x;
  const Real wd6_y_p3 = wd6_y_p1 - wd5_z;
  const Real minus_f6_z_p3 = w5_z * w5_z;

  // link 6 (wrist_3), outward
  const Real wd6_y = wd6_y_p2 - wd6_y_p3;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p147_lanes = f6_y_p130_lanes * f6_y_p146;

  // link 5 (wrist_2), outward
  const Real wd5_y = c5 * wd4_z - s5 * wd5_y_p1 - w5_x * qd[4];
  const Real wd5_x = c5 * wd5_y_p1 + s5 * wd4_z + w5_y * qd[4];
  const Real minus_f6_z_p4 = minus_f6_z_p2 + minus_f6_z_p3;
  const Real a5_x = c5 * a5_x_p3 + s5 * a5_x_p2;

  // link 6 (wrist_3), outward
  const Real minus_f6_x_p7 = f6_y_p19 * xdd_cmd[5] - f6_y_p20 * minus_f6_x_p4 + wd6_y;

  // link 5 (wrist_2), outward
  const Real minus_f6_x_p8 = minus_f6_x_p6 + wd5_y;

  // link 6 (wrist_3), outward
  const Real f6_y_p164 = f6_y_p19 * minus_f6_x_p4 + f6_y_p20 * xdd_cmd[5];
  const Real f6_y_p165 = c1 * xdd_cmd[4] - s1 * xdd_cmd[3];

  // link 5 (wrist_2), outward
  const Real f6_y_p166 = w5_y * w5_y;

  // link 6 (wrist_3), outward
  const Real wd6_x_p1 = w5_z * w6_z;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p167_lanes = detail::make_pack<Real>(f6_y_p105_lanes[0], f6_y_p88 * f6_y_p76 -
      f6_y_p89 * f6_y_p62, f6_y_p105_lanes[2], f6_y_p105_lanes[3], f6_y_p105_lanes[0], f6_y_p81 *
      f6_y_p62 - f6_y_p80 * f6_y_p76, f6_y_p105_lanes[0], f6_y_p105_lanes[0]) + f6_y_p109_lanes *
      f6_y_p97 + f6_y_p147_lanes * f6_y_p130_lanes[0];
  const Real f6_y_p179 = f6_y_p167_lanes[0] * f6_y_p167_lanes[0];

  // link 5 (wrist_2), outward
  const Real wd6_x_p2 = minus_f6_z_p1 + wd5_x;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p180 = 117.34209310833121 + f6_y_p81 * f6_y_p5 + f6_y_p80 * f6_y_p73 +
      f6_y_p109_lanes[5] * f6_y_p93 + f6_y_p147_lanes[5] * f6_y_p130_lanes[5];

  // link 6 (wrist_3), outward
  const Real minus_f6_x_p9 = c5 * minus_f6_x_p5 - s5 * minus_f6_x_p3 - a5_x - 0.11985 *
      minus_f6_x_p8 - 0.11655 * (wd6_y_p3 + minus_f6_x_p7);
  const Real wd6_x = wd6_x_p1 - wd6_x_p2;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p181 = f6_y_p179 * f6_y_p167_lanes[0];

  // link 5 (wrist_2), outward
  const Real minus_a5_z = f6_y_p19 * a4_y - f6_y_p20 * a5_x_p1;

  // link 6 (wrist_3), outward
  const Real f6_y_p182 = c5 * f6_y_p164 - s5 * f6_y_p165 + wd6_x;
  const Real n1_z_p1 = c2 * f6_y_p56;
  const Real n1_z_p2 = f6_y_p9 * f6_y_p54;
  const Real n1_z_p3 = f6_y_p19 * f6_y_p53;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p183 = f6_y_p181 * f6_y_p179 / (4.81482486096809e-35 + f6_y_p181 * f6_y_p181);

  // link 4 (wrist_1), outward
  const Real n1_z_p4 = 2.0 * wd4_x;

  // link 2 (upper_arm), inward
  const Real n1_z_p5 = qdd_0[1] * f6_y_p8 - a3_z_p1 * n1_z_p1 + 1.156008191975 * a3_x_p2 * c2 +
      wd3_z * f6_y_p18;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p184_lanes = f6_y_p167_lanes * f6_y_p183;

  // link 6 (wrist_3), outward
  const Real wd6_z = wd5_y + qdd_0[5];

  // link 2 (upper_arm), inward
  const Real n1_z_p6 = n1_z_p5 - a4_z_p2 * n1_z_p2 + 0.5656542411875001 * a4_x_p1 * f6_y_p9 +
      f6_y_p16 * a3_z + wd4_z * f6_y_p28;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p195_lanes = detail::make_pack<Real>(f6_y_p140_lanes[1], f6_y_p140_lanes[1],
      f6_y_p140_lanes[2], f6_y_p140_lanes[3], f6_y_p140_lanes[1], f6_y_p109_lanes[5] * f6_y_p96 -
      (f6_y_p81 * f6_y_p51 + f6_y_p80 * f6_y_p75), f6_y_p140_lanes[1], f6_y_p140_lanes[1]) +
      f6_y_p147_lanes * f6_y_p130_lanes[1] - f6_y_p184_lanes * f6_y_p167_lanes[1];
  const Lanes<8> f6_y_p199_lanes = detail::make_pack<Real>(f6_y_p85_lanes[2] * f6_y_p44 +
      f6_y_p82_lanes[2] * f6_y_p74, f6_y_p85_lanes[2] * f6_y_p44 + f6_y_p82_lanes[2] * f6_y_p74,
      f6_y_p85_lanes[2] * f6_y_p44 + f6_y_p82_lanes[2] * f6_y_p74, f6_y_p85_lanes[3] * f6_y_p44 +
      f6_y_p82_lanes[3] * f6_y_p74, f6_y_p85_lanes[2] * f6_y_p44 + f6_y_p82_lanes[2] * f6_y_p74,
      f6_y_p81 * f6_y_p44 - f6_y_p80 * f6_y_p74, f6_y_p85_lanes[2] * f6_y_p44 + f6_y_p82_lanes[2] *
      f6_y_p74, f6_y_p85_lanes[2] * f6_y_p44 + f6_y_p82_lanes[2] * f6_y_p74) + f6_y_p109_lanes *
      f6_y_p95 + f6_y_p147_lanes * f6_y_p130_lanes[2] - f6_y_p184_lanes * f6_y_p167_lanes[2];
  const Real f6_y_p202 = f6_y_p85_lanes[3] * s5 + f6_y_p82_lanes[3] * f6_y_p72 +
      f6_y_p109_lanes[3] * f6_y_p94 + f6_y_p147_lanes[3] * f6_y_p130_lanes[3] - f6_y_p184_lanes[3] *
      f6_y_p167_lanes[3];
  const Real f6_y_p203 = f6_y_p81 * s5 - f6_y_p80 * f6_y_p72 + f6_y_p109_lanes[5] * f6_y_p94 +
      f6_y_p147_lanes[5] * f6_y_p130_lanes[3] - f6_y_p184_lanes[5] * f6_y_p167_lanes[3];
  const Real f6_y_p204 = f6_y_p195_lanes[1] * f6_y_p195_lanes[1];
  const Real minus_f6_z_p5 = 0.11985 * (minus_f6_z_p1 - wd5_x) - 0.11655 * minus_f6_z_p4 +
      f6_y_p184_lanes[1] * minus_f6_x_p9 + (minus_f6_x_p3 + a5_x_p2) * c5;

  // link 4 (wrist_1), outward
  const Real f4_x_p1 = w4_z * w4_z;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p205 = f6_y_p204 * f6_y_p195_lanes[1];
  const Real minus_f6_z_p6 = minus_f6_z_p5 + (minus_f6_x_p5 - a5_x_p3) * s5;

  // link 6 (wrist_3), inertial wrench
  const Real n6_z = 0.000623 * wd6_z - 0.0006230000000000001 *
      (s5 * f6_y_p164 + c5 * f6_y_p165 + wd6_z);
  tau[5] = n6_z;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p206 = f6_y_p205 * f6_y_p204 / (7.52316384526264e-37 + f6_y_p205 * f6_y_p205);
  const Lanes<8> f6_y_p207_lanes = f6_y_p195_lanes * f6_y_p206;

  // link 4 (wrist_1), inertial wrench
  const Real n4_z_p1 = 0.0397298163875 * wd4_z + qdd_0[0] * f6_y_p28 - a3_x_p1 * n1_z_p3 +
      (f6_y_p23 * a4_y + f6_y_p21 * a4_x);

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p213_lanes = f6_y_p199_lanes - f6_y_p207_lanes * f6_y_p195_lanes[2];
  const Real f6_y_p216 = f6_y_p213_lanes[2] * f6_y_p213_lanes[2];
  const Real f6_y_p217 = f6_y_p216 * f6_y_p213_lanes[2];

  // link 3 (forearm), inertial wrench
  const Real n3_z_p1 = 2.08330527531 * wd3_z + qdd_0[0] * f6_y_p18 + a3_x_p1 * n1_z_p2 +
      (f6_y_p15 * a3_x - f6_y_p16 * a3_y);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p218 = f6_y_p207_lanes[2] * minus_f6_z_p6 - f6_y_p19 * minus_f6_x_p1 + f6_y_p20 *
      minus_f6_x_p2 + minus_a5_z + 0.11985 * (minus_f6_z_p2 + f6_y_p166);
  const Real f6_y_p219 = f6_y_p218 - f6_y_p184_lanes[2] * minus_f6_x_p9 - 0.11655 *
      (wd6_x_p2 + f6_y_p182);
  const Real f6_y_p220 = f6_y_p217 * f6_y_p216 / (7.52316384526264e-37 + f6_y_p217 * f6_y_p217);
  const Real f6_y_p221 = f6_y_p213_lanes[3] * f6_y_p220;
  const Real f6_y_p222 = f6_y_p213_lanes[5] * f6_y_p220;
  const Real f6_y_p223 = f6_y_p202 - f6_y_p207_lanes[3] * f6_y_p195_lanes[3] - f6_y_p221 *
      f6_y_p213_lanes[3];
  const Real f6_y_p224 = f6_y_p203 - f6_y_p207_lanes[5] * f6_y_p195_lanes[3] - f6_y_p222 *
      f6_y_p213_lanes[3];
  const Real f6_y_p225 = f6_y_p182 - f6_y_p184_lanes[3] * minus_f6_x_p9 + f6_y_p207_lanes[3] *
      minus_f6_z_p6 - f6_y_p221 * f6_y_p219;
  const Real f6_y_p226 = f6_y_p223 * f6_y_p223;
  const Real f6_y_p227 = f6_y_p226 * f6_y_p223;
  const Real f6_y_p228 = f6_y_p227 * f6_y_p226 / (8.077935669463161e-28 + f6_y_p227 * f6_y_p227);
  const Real f6_y_p229 = f6_y_p224 * f6_y_p228;
  const Real f6_y_p230 = f6_y_p180 - f6_y_p184_lanes[5] * f6_y_p167_lanes[5] - f6_y_p207_lanes[5] *
      f6_y_p195_lanes[5] - f6_y_p222 * f6_y_p213_lanes[5] - f6_y_p229 * f6_y_p224;
  const Real f6_y_p231 = f6_y_p207_lanes[5] * minus_f6_z_p6 -
      (minus_f6_x_p7 + f6_y_p184_lanes[5] * minus_f6_x_p9) - f6_y_p222 * f6_y_p219 - f6_y_p229 *
      f6_y_p225;
  const Real f6_y_p232 = f6_y_p230 * f6_y_p230;
  const Real f6_y_p233 = f6_y_p232 * f6_y_p230;
  const Real f6_y_p234 = f6_y_p231 * (f6_y_p233 * f6_y_p232 /
      (8.673617379884035e-19 + f6_y_p233 * f6_y_p233));

  // link 6 (wrist_3), inertial wrench
  const Real n6_y = 0.0003115 * (wd6_y_p2 + wd6_y) + f6_y_p234;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p235 = f6_y_p225 * f6_y_p228 - f6_y_p229 * f6_y_p234;

  // link 6 (wrist_3), inward
  const Real n5_z = 0.008210591037500001 * wd5_z - 0.005730591037500001 * wd6_y_p1 -
      0.0106962107625 * minus_f6_x_p8 - 0.09132825 * a5_x + n6_y;
  tau[4] = n5_z;

  // link 6 (wrist_3), inertial wrench
  const Real n6_x = 0.0003115 * (wd6_x_p1 + wd6_x) - f6_y_p235;

  // link 1 (shoulder), mass matrix
  const Real f6_y = f6_y_p219 * f6_y_p220 - f6_y_p221 * f6_y_p235 - f6_y_p222 * f6_y_p234;

  // link 6 (wrist_3), inward
  const Real f5_z = 0.09132825 * wd6_x_p2 + f6_y;

  // link 1 (shoulder), mass matrix
  const Real minus_f6_z = minus_f6_z_p6 * f6_y_p206 + f6_y_p207_lanes[2] * f6_y +
      f6_y_p207_lanes[3] * f6_y_p235 + f6_y_p207_lanes[5] * f6_y_p234;

  // link 6 (wrist_3), inward
  const Real minus_f5_y = 0.09132825 * minus_f6_z_p4 + minus_f6_z;
  const Real n5_x = 0.0069705910375000004 * wd6_x_p2 + 0.0106962107625 *
      (minus_f6_z_p3 - f6_y_p166) - 0.09132825 * minus_a5_z + (0.11985 * minus_f6_z - n6_x);

  // link 1 (shoulder), mass matrix
  const Real minus_f6_x = minus_f6_x_p9 * f6_y_p183 + f6_y_p184_lanes[1] * minus_f6_z -
      f6_y_p184_lanes[2] * f6_y - f6_y_p184_lanes[3] * f6_y_p235 - f6_y_p184_lanes[5] * f6_y_p234;

  // link 6 (wrist_3), inward
  const Real f5_x = 0.09132825 * wd6_y_p3 + minus_f6_x;

  // link 5 (wrist_2), inward
  const Real f4_x_p2 = c5 * f5_x + s5 * minus_f5_y;

  // link 6 (wrist_3), inward
  const Real n5_y = 0.0106962107625 * wd6_y_p3 - 0.00124 * (minus_f6_x_p6 - wd5_y) +
      (n6_z + 0.11985 * minus_f6_x);

  // link 5 (wrist_2), inward
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - (qdd_0[0] * f6_y_p23 + n1_z_p4 * f6_y_p21);
  const Real f4_x_p3 = f6_y_p19 * f4_x_p2 + f6_y_p20 * f5_z;

  // link 4 (wrist_1), inward
  const Real f3_z = qdd_0[0] * f6_y_p16 - a4_z_p2 * f6_y_p15 + f4_z;

  // link 5 (wrist_2), inward
  const Real f4_x = wd4_z * f6_y_p21 - (a3_x_p1 + f4_x_p1) * f6_y_p23 + f4_x_p3;
  const Real f4_y = wd4_z * f6_y_p23 + f4_x_p1 * f6_y_p21 + (f6_y_p20 * f4_x_p2 - f6_y_p19 * f5_z);
  const Real n4_z = n4_z_p1 + (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 4 (wrist_1), inward
  const Real f3_x = a4_x_p2 * f6_y_p16 + wd3_z * f6_y_p15 + f4_x;
  const Real f3_y = a4_x_p1 * f6_y_p15 - wd3_z * f6_y_p16 + f4_y;

  // link 2 (upper_arm), inward
  const Real n1_z_p7 = n1_z_p6 + n1_z_p4 * n1_z_p3 - f6_y_p23 * a4_z - f6_y_p19 * n5_z + 0.17415 *
      f4_x_p3;

  // link 4 (wrist_1), inward
  const Real n3_z = n3_z_p1 + (n4_z + (f6_y_p13 * f4_x - f6_y_p14 * f4_y));
  tau[2] = n3_z;

  // link 2 (upper_arm), inward
  const Real n1_z_p8 = n1_z_p7 + f6_y_p14 * f4_z + f6_y_p7 * f3_z +
      (c5 * n5_x - s5 * n5_y - 0.0585962731125 * f4_x_p1) * f6_y_p20;
  const Real n1_z = n1_z_p8 + f6_y_p70 * qdd_0[0];
  tau[0] = n1_z;

  // link 3 (forearm), inward
  const Real n2_z = 4.3866871861500005 * qdd_0[1] + qdd_0[0] * f6_y_p8 + a3_x_p1 * n1_z_p1 -
      81.98859064500002 * c2 + (n3_z + (f6_y_p6 * f3_x - f6_y_p7 * f3_y));
  tau[1] = n2_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
