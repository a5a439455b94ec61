// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes asked for at the points.
// 822 flops (add 331, mul 481, div 10), sine and cosine of 5 angles
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
void lambda(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  const Real angles[5] = {q[4], q[1], q[2], q[3], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c5 = cosines[0];
  const Real c2 = cosines[1];
  const Real c3 = cosines[2];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c4 = cosines[3];
  const Real s4 = sines[3];
  const Real c1 = cosines[4];
  const Real s5 = sines[0];
  const Real s1 = sines[4];

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p1 = 0.0054190910375000005 * s5;
  const Real Lambda_5_5_p2 = 0.09132825 * s5;
  const Real Lambda_5_5_p3 = 0.09132825 * c5;
  const Real Lambda_5_5_p4 = 0.0106962107625 * c5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p5 = 1.2551157591996094 * c5;
  const Real Lambda_5_5_p6 = 0.6127 * s2;
  const Real Lambda_5_5_p7 = 0.6127 * c2;
  const Real Lambda_5_5_p8 = c2 * c3 - s2 * s3;
  const Real Lambda_5_5_p9 = s2 * c3 + c2 * s3;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p10 = s5 * Lambda_5_5_p1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p11 = c5 * (0.000623 * c5);

  // link 5 (wrist_2), Jacobian
  const Real Lambda_5_5_p12 = 0.11655 * s5;
  const Real Lambda_5_5_p13 = 0.57155 * Lambda_5_5_p9;
  const Real Lambda_5_5_p14 = 0.57155 * Lambda_5_5_p8;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p15 = 0.041592816387499995 + Lambda_5_5_p10;
  const Real Lambda_5_5_p16 = Lambda_5_5_p8 * c4 - Lambda_5_5_p9 * s4;
  const Real Lambda_5_5_p17 = Lambda_5_5_p9 * c4 + Lambda_5_5_p8 * s4;
  const Real Lambda_5_5_p18 = Lambda_5_5_p17 * Lambda_5_5_p2;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p19 = Lambda_5_5_p17 * Lambda_5_5_p3;
  const Real Lambda_5_5_p20 = Lambda_5_5_p16 * Lambda_5_5_p3;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p21 = Lambda_5_5_p17 * c5;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p22 = s5 * Lambda_5_5_p17;

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p23 = Lambda_5_5_p16 * s1;
  const Real Lambda_5_5_p24 = Lambda_5_5_p16 * c1;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p25 = 0.33495075 * Lambda_5_5_p16 + Lambda_5_5_p18;
  const Real Lambda_5_5_p26 = 0.33495075 * Lambda_5_5_p17 - Lambda_5_5_p16 * Lambda_5_5_p2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p27 = 1.0 / (Lambda_5_5_p15 - Lambda_5_5_p11 - Lambda_5_5_p5 *
      Lambda_5_5_p4);

  // link 6 (wrist_3), mass matrix
  const Real Lambda_5_5_p28 = 0.000623 * Lambda_5_5_p22;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p29 = Lambda_5_5_p14 * Lambda_5_5_p26;

  // link 5 (wrist_2), Jacobian
  const Real Lambda_5_5_p30 = 0.11655 * Lambda_5_5_p21;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p31 = c5 * Lambda_5_5_p28;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p32 = Lambda_5_5_p13 * Lambda_5_5_p25 - Lambda_5_5_p29;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p33 = Lambda_5_5_p7 * (Lambda_5_5_p26 - 4.0059802 * Lambda_5_5_p8);

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p34 = Lambda_5_5_p14 * Lambda_5_5_p19 - Lambda_5_5_p13 * Lambda_5_5_p20 -
      Lambda_5_5_p4;

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p35 = c5 * Lambda_5_5_p23 - s5 * c1;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p36 = Lambda_5_5_p21 * Lambda_5_5_p1 + 0.17415 * Lambda_5_5_p18 +
      (0.0585962731125 + Lambda_5_5_p4) * Lambda_5_5_p16;

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p37 = c5 * Lambda_5_5_p24 + s5 * s1;
  const Real Lambda_5_5_p38 = c5 * s1 - s5 * Lambda_5_5_p24;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p39 = 117.34209310833121 * Lambda_5_5_p34;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p40 = Lambda_5_5_p34 + (Lambda_5_5_p7 * Lambda_5_5_p19 - Lambda_5_5_p6 *
      Lambda_5_5_p20);

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p41 = Lambda_5_5_p6 * (4.0059802 * Lambda_5_5_p9 + Lambda_5_5_p25) -
      Lambda_5_5_p33;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p42 = 0.0106962107625 * Lambda_5_5_p22 - 0.0085220910375 * Lambda_5_5_p16 -
      0.17415 * Lambda_5_5_p20 - (Lambda_5_5_p14 + Lambda_5_5_p7) * Lambda_5_5_p2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p43 = Lambda_5_5_p15 + Lambda_5_5_p32 - Lambda_5_5_p11;
  const Real Lambda_5_5_p44 = 117.34209310833121 * Lambda_5_5_p40;
  const Real Lambda_5_5_p45 = Lambda_5_5_p43 + Lambda_5_5_p5 * Lambda_5_5_p34;
  const Real Lambda_5_5_p46 = 117.34209310833121 * Lambda_5_5_p42;

  // link 5 (wrist_2), Jacobian
  const Real Lambda_5_5_p47 = 0.11655 * Lambda_5_5_p35;
  const Real Lambda_5_5_p48 = 0.11655 * Lambda_5_5_p37;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p49 = 0.5656542411875001 * Lambda_5_5_p9 +
      (Lambda_5_5_p36 + Lambda_5_5_p13 * Lambda_5_5_p3) + Lambda_5_5_p31;

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p50 = Lambda_5_5_p17 * c1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p51 = Lambda_5_5_p45 * Lambda_5_5_p27;
  const Real Lambda_5_5_p52 = Lambda_5_5_p36 + Lambda_5_5_p31 + Lambda_5_5_p5 * Lambda_5_5_p42;

  // link 5 (wrist_2), Jacobian
  const Real Lambda_5_5_p53 = Lambda_5_5_p17 * Lambda_5_5_p12 + 0.11985 * Lambda_5_5_p16;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p54 = 2.08330527531 + (Lambda_5_5_p15 + 2.0 * Lambda_5_5_p32) -
      Lambda_5_5_p11;
  const Real Lambda_5_5_p55 = Lambda_5_5_p43 + Lambda_5_5_p6 * Lambda_5_5_p25 - Lambda_5_5_p7 *
      Lambda_5_5_p26 + Lambda_5_5_p5 * Lambda_5_5_p40;
  const Real Lambda_5_5_p56 = Lambda_5_5_p52 * Lambda_5_5_p27;
  const Real Lambda_5_5_p57 = c5 * Lambda_5_5_p22;

  // link 5 (wrist_2), Jacobian
  const Real Lambda_5_5_p62 = 0.11985 * Lambda_5_5_p17 - Lambda_5_5_p16 * Lambda_5_5_p12;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p63 = Lambda_5_5_p55 * Lambda_5_5_p27;
  const Real Lambda_5_5_p64 = 0.0098370910375 + (6.991093406097501 - s2 * (4.36318718615 * s2) -
      Lambda_5_5_p9 * (2.07831527531 * Lambda_5_5_p9)) + 0.031809629475 * c5;
  const Real Lambda_5_5_p65 = s1 - c5 * Lambda_5_5_p38;
  const Real Lambda_5_5_p66 = Lambda_5_5_p49 - Lambda_5_5_p39 * Lambda_5_5_p42 - Lambda_5_5_p51 *
      Lambda_5_5_p52;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p67 = Lambda_5_5_p53 + Lambda_5_5_p13;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p68 = Lambda_5_5_p54 + Lambda_5_5_p41 - Lambda_5_5_p39 * Lambda_5_5_p40 -
      Lambda_5_5_p51 * Lambda_5_5_p55;
  const Real Lambda_5_5_p69 = 1.0 / (Lambda_5_5_p54 - Lambda_5_5_p39 * Lambda_5_5_p34 -
      Lambda_5_5_p51 * Lambda_5_5_p45);

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p70 = Lambda_5_5_p62 - Lambda_5_5_p14;

  // link 1 (shoulder), mass matrix
  const Lanes<8> Lambda_5_5_p71_lanes = detail::make_pack<Real>(Lambda_5_5_p53 * c1,
      Lambda_5_5_p53 * s1, Lambda_5_5_p62, Lambda_5_5_p53 * c1, Lambda_5_5_p53 * c1, Lambda_5_5_p57,
      Lambda_5_5_p53 * c1, Lambda_5_5_p53 * c1) - Lambda_5_5_p5 *
      detail::make_pack<Real>(Lambda_5_5_p48, Lambda_5_5_p47, Lambda_5_5_p30, Lambda_5_5_p48,
      Lambda_5_5_p48, Lambda_5_5_p16, Lambda_5_5_p48, Lambda_5_5_p48);
  const Real Lambda_5_5_p75 = Lambda_5_5_p65 + Lambda_5_5_p5 * Lambda_5_5_p50;

  // link 3 (forearm), Jacobian
  const Real Lambda_5_5_p80 = Lambda_5_5_p67 + Lambda_5_5_p6;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p81 = 1.156008191975 * s2 + Lambda_5_5_p49 + Lambda_5_5_p6 * Lambda_5_5_p3 -
      Lambda_5_5_p44 * Lambda_5_5_p42 - Lambda_5_5_p63 * Lambda_5_5_p52;

  // link 3 (forearm), Jacobian
  const Real Lambda_5_5_p82 = Lambda_5_5_p70 - Lambda_5_5_p7;

  // link 5 (wrist_2), Jacobian
  const Real Lambda_5_5_p83 = 0.17415 + 0.11655 * c5;

  // link 1 (shoulder), mass matrix
  const Lanes<8> Lambda_5_5_p93_lanes = detail::make_pack<Real>(Lambda_5_5_p67 * c1,
      Lambda_5_5_p67 * s1, Lambda_5_5_p70, Lambda_5_5_p67 * c1, Lambda_5_5_p67 * c1, Lambda_5_5_p57,
      Lambda_5_5_p67 * c1, Lambda_5_5_p67 * c1) + Lambda_5_5_p39 *
      detail::make_pack<Real>(Lambda_5_5_p48, Lambda_5_5_p47, Lambda_5_5_p30, Lambda_5_5_p48,
      Lambda_5_5_p48, Lambda_5_5_p16, Lambda_5_5_p48, Lambda_5_5_p48);
  const Real Lambda_5_5_p97 = (0.037099816387500005 * Lambda_5_5_p17 -
      (Lambda_5_5_p17 * (0.0012399999999999998 + Lambda_5_5_p10) + Lambda_5_5_p16 *
      (0.021392421525 * s5))) * Lambda_5_5_p17;
  const Lanes<8> Lambda_5_5_p106_lanes = detail::make_pack<Real>(Lambda_5_5_p93_lanes[0],
      Lambda_5_5_p93_lanes[1], Lambda_5_5_p93_lanes[2], Lambda_5_5_p65 - Lambda_5_5_p39 *
      Lambda_5_5_p50, Lambda_5_5_p93_lanes[0], Lambda_5_5_p93_lanes[5], Lambda_5_5_p93_lanes[0],
      Lambda_5_5_p93_lanes[0]) - Lambda_5_5_p51 * detail::make_pack<Real>(Lambda_5_5_p71_lanes[0],
      Lambda_5_5_p71_lanes[1], Lambda_5_5_p71_lanes[2], Lambda_5_5_p75, Lambda_5_5_p71_lanes[0],
      Lambda_5_5_p71_lanes[5], Lambda_5_5_p71_lanes[0], Lambda_5_5_p71_lanes[0]);
  const Lanes<8> Lambda_5_5_p111_lanes = detail::make_pack<Real>(Lambda_5_5_p80 * c1,
      Lambda_5_5_p80 * s1, Lambda_5_5_p82, Lambda_5_5_p80 * c1, Lambda_5_5_p80 * c1, Lambda_5_5_p57,
      Lambda_5_5_p80 * c1, Lambda_5_5_p80 * c1) + Lambda_5_5_p44 *
      detail::make_pack<Real>(Lambda_5_5_p48, Lambda_5_5_p47, Lambda_5_5_p30, Lambda_5_5_p48,
      Lambda_5_5_p48, Lambda_5_5_p16, Lambda_5_5_p48, Lambda_5_5_p48);
  const Lanes<8> Lambda_5_5_p120_lanes = Lambda_5_5_p71_lanes * Lambda_5_5_p27;
  const Lanes<8> Lambda_5_5_p124_lanes = detail::make_pack<Real>(13.676220951776003,
      13.676220951776003, 13.676220951776003, 13.676220951776003, 13.676220951776003,
      117.34209310833121, 13.676220951776003, 13.676220951776003) *
      detail::make_pack<Real>(Lambda_5_5_p37, Lambda_5_5_p35, Lambda_5_5_p21, Lambda_5_5_p37,
      Lambda_5_5_p37, Lambda_5_5_p16, Lambda_5_5_p37, Lambda_5_5_p37);
  const Real Lambda_5_5_p133 = Lambda_5_5_p75 * Lambda_5_5_p27;
  const Real Lambda_5_5_p134 = 117.34209310833121 * Lambda_5_5_p50;
  const Real Lambda_5_5_p135 = Lambda_5_5_p68 * Lambda_5_5_p69;
  const Real Lambda_5_5_p136 = Lambda_5_5_p66 * Lambda_5_5_p69;
  const Lanes<8> Lambda_5_5_p137_lanes = Lambda_5_5_p106_lanes * Lambda_5_5_p69;

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p142 = Lambda_5_5_p17 * s1;

  // link 1 (shoulder), mass matrix
  const Lanes<8> Lambda_5_5_p143_lanes = detail::make_pack<Real>(Lambda_5_5_p83 * c1 -
      Lambda_5_5_p82 * s1, Lambda_5_5_p82 * c1 + Lambda_5_5_p83 * s1, Lambda_5_5_p83 * c1 -
      Lambda_5_5_p82 * s1, Lambda_5_5_p83 * c1 - Lambda_5_5_p82 * s1, Lambda_5_5_p83 * c1 -
      Lambda_5_5_p82 * s1, 1.0 - Lambda_5_5_p22 * Lambda_5_5_p22, Lambda_5_5_p83 * c1 -
      Lambda_5_5_p82 * s1, Lambda_5_5_p83 * c1 - Lambda_5_5_p82 * s1) + Lambda_5_5_p46 *
      detail::make_pack<Real>(Lambda_5_5_p48, Lambda_5_5_p47, Lambda_5_5_p48, Lambda_5_5_p48,
      Lambda_5_5_p48, Lambda_5_5_p16, Lambda_5_5_p48, Lambda_5_5_p48);

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p146 = s5 * Lambda_5_5_p23 + c5 * c1;

  // link 1 (shoulder), mass matrix
  const Lanes<8> Lambda_5_5_p181_lanes = Lambda_5_5_p124_lanes * Lambda_5_5_p48 +
      Lambda_5_5_p120_lanes * Lambda_5_5_p71_lanes[0];
  const Real Lambda_5_5_p185 = 117.34209310833121 * Lambda_5_5_p142;
  const Real Lambda_5_5_p186 = 4.3866871861500005 + Lambda_5_5_p54 + 2.0 * Lambda_5_5_p41 -
      Lambda_5_5_p44 * Lambda_5_5_p40 - Lambda_5_5_p63 * Lambda_5_5_p55 - Lambda_5_5_p135 *
      Lambda_5_5_p68;
  const Real Lambda_5_5_p187 = Lambda_5_5_p81 - Lambda_5_5_p135 * Lambda_5_5_p66;
  const Real Lambda_5_5_p188 = Lambda_5_5_p64 - Lambda_5_5_p22 * Lambda_5_5_p28 - Lambda_5_5_p46 *
      Lambda_5_5_p42 - Lambda_5_5_p56 * Lambda_5_5_p52 - Lambda_5_5_p136 * Lambda_5_5_p66;
  const Lanes<8> Lambda_5_5_p189_lanes = detail::make_pack<Real>(Lambda_5_5_p111_lanes[0],
      Lambda_5_5_p111_lanes[1], Lambda_5_5_p111_lanes[2], Lambda_5_5_p65 - Lambda_5_5_p44 *
      Lambda_5_5_p50, Lambda_5_5_p111_lanes[0], Lambda_5_5_p111_lanes[5], Lambda_5_5_p111_lanes[0],
      Lambda_5_5_p111_lanes[0]) - Lambda_5_5_p63 * detail::make_pack<Real>(Lambda_5_5_p71_lanes[0],
      Lambda_5_5_p71_lanes[1], Lambda_5_5_p71_lanes[2], Lambda_5_5_p75, Lambda_5_5_p71_lanes[0],
      Lambda_5_5_p71_lanes[5], Lambda_5_5_p71_lanes[0], Lambda_5_5_p71_lanes[0]) - Lambda_5_5_p135 *
      Lambda_5_5_p106_lanes;
  const Real Lambda_5_5_p199 = c5 * Lambda_5_5_p146 - c1;
  const Lanes<8> Lambda_5_5_p209_lanes = Lambda_5_5_p124_lanes * Lambda_5_5_p47 +
      Lambda_5_5_p120_lanes * Lambda_5_5_p71_lanes[1];
  const Real Lambda_5_5_p212 = 1.0 / Lambda_5_5_p186;
  const Real Lambda_5_5_p213 = Lambda_5_5_p199 + Lambda_5_5_p5 * Lambda_5_5_p142;
  const Real Lambda_5_5_p217 = 1605.1364365971108 * Lambda_5_5_p22;
  const Real Lambda_5_5_p218 = Lambda_5_5_p213 * Lambda_5_5_p27;
  const Real Lambda_5_5_p223 = 1605.1364365971108 * Lambda_5_5_p146;
  const Real Lambda_5_5_p224 = Lambda_5_5_p199 - Lambda_5_5_p39 * Lambda_5_5_p142 - Lambda_5_5_p51 *
      Lambda_5_5_p213;
  const Real Lambda_5_5_p228 = Lambda_5_5_p224 * Lambda_5_5_p69;
  const Real Lambda_5_5_p229 = Lambda_5_5_p187 * Lambda_5_5_p212;
  const Lanes<8> Lambda_5_5_p230_lanes = Lambda_5_5_p189_lanes * Lambda_5_5_p212;
  const Real Lambda_5_5_p235 = Lambda_5_5_p199 - Lambda_5_5_p44 * Lambda_5_5_p142 - Lambda_5_5_p63 *
      Lambda_5_5_p213 - Lambda_5_5_p135 * Lambda_5_5_p224;
  const Real Lambda_5_5_p250 = Lambda_5_5_p235 * Lambda_5_5_p212;
  const Lanes<8> Lambda_5_5_p254_lanes = detail::make_pack<Real>(Lambda_5_5_p143_lanes[0],
      Lambda_5_5_p143_lanes[1], Lambda_5_5_p46 * Lambda_5_5_p30, Lambda_5_5_p22 * Lambda_5_5_p38 -
      Lambda_5_5_p46 * Lambda_5_5_p50, Lambda_5_5_p143_lanes[0], Lambda_5_5_p143_lanes[5],
      Lambda_5_5_p143_lanes[0], Lambda_5_5_p143_lanes[0]) - Lambda_5_5_p56 *
      detail::make_pack<Real>(Lambda_5_5_p71_lanes[0], Lambda_5_5_p71_lanes[1],
      Lambda_5_5_p71_lanes[2], Lambda_5_5_p75, Lambda_5_5_p71_lanes[0], Lambda_5_5_p71_lanes[5],
      Lambda_5_5_p71_lanes[0], Lambda_5_5_p71_lanes[0]) - Lambda_5_5_p136 * Lambda_5_5_p106_lanes -
      Lambda_5_5_p229 * Lambda_5_5_p189_lanes;
  const Real Lambda_5_5_p268 = Lambda_5_5_p22 * Lambda_5_5_p146 + Lambda_5_5_p46 * Lambda_5_5_p142 +
      Lambda_5_5_p56 * Lambda_5_5_p213 + Lambda_5_5_p136 * Lambda_5_5_p224 + Lambda_5_5_p229 *
      Lambda_5_5_p235;
  const Real Lambda_5_5_p272 = 1605.1364365971108 * Lambda_5_5_p38 * Lambda_5_5_p38 +
      Lambda_5_5_p134 * Lambda_5_5_p50 + Lambda_5_5_p133 * Lambda_5_5_p75 +
      Lambda_5_5_p137_lanes[3] * Lambda_5_5_p106_lanes[3];
  const Real Lambda_5_5_p273 = Lambda_5_5_p120_lanes[5] * Lambda_5_5_p75 -
      (Lambda_5_5_p217 * Lambda_5_5_p38 + Lambda_5_5_p124_lanes[5] * Lambda_5_5_p50) +
      Lambda_5_5_p137_lanes[5] * Lambda_5_5_p106_lanes[3] + Lambda_5_5_p230_lanes[5] *
      Lambda_5_5_p189_lanes[3];
  const Real Lambda_5_5_p274 = Lambda_5_5_p185 * Lambda_5_5_p50 - Lambda_5_5_p223 * Lambda_5_5_p38 +
      Lambda_5_5_p218 * Lambda_5_5_p75 + Lambda_5_5_p228 * Lambda_5_5_p106_lanes[3] +
      Lambda_5_5_p250 * Lambda_5_5_p189_lanes[3];
  const Real Lambda_5_5_p275 = Lambda_5_5_p223 * Lambda_5_5_p146 + Lambda_5_5_p185 *
      Lambda_5_5_p142 + Lambda_5_5_p218 * Lambda_5_5_p213 + Lambda_5_5_p228 * Lambda_5_5_p224 +
      Lambda_5_5_p250 * Lambda_5_5_p235;
  const Real Lambda_5_5_p276 = 1.0 / (Lambda_5_5_p188 - Lambda_5_5_p229 * Lambda_5_5_p187 - 2.0 *
      (Lambda_5_5_p29 + Lambda_5_5_p33) + Lambda_5_5_p97);
  const Real Lambda_5_5_p277 = Lambda_5_5_p217 * Lambda_5_5_p146 - Lambda_5_5_p124_lanes[5] *
      Lambda_5_5_p142 + Lambda_5_5_p120_lanes[5] * Lambda_5_5_p213 + Lambda_5_5_p137_lanes[5] *
      Lambda_5_5_p224 + Lambda_5_5_p230_lanes[5] * Lambda_5_5_p235;
  const Real Lambda_5_5_p278 = Lambda_5_5_p217 * Lambda_5_5_p22 + Lambda_5_5_p124_lanes[5] *
      Lambda_5_5_p16 + Lambda_5_5_p120_lanes[5] * Lambda_5_5_p71_lanes[5] +
      Lambda_5_5_p137_lanes[5] * Lambda_5_5_p106_lanes[5] + Lambda_5_5_p230_lanes[5] *
      Lambda_5_5_p189_lanes[5];
  const Lanes<8> Lambda_5_5_p279_lanes = Lambda_5_5_p254_lanes * Lambda_5_5_p276;
  const Real Lambda_5_5_p284 = Lambda_5_5_p268 * Lambda_5_5_p276;
  const Lanes<8> Lambda_5_5_p297_lanes = detail::make_pack<Real>(Lambda_5_5_p181_lanes[0],
      Lambda_5_5_p181_lanes[1], Lambda_5_5_p181_lanes[2], Lambda_5_5_p133 *
      Lambda_5_5_p71_lanes[0] - Lambda_5_5_p134 * Lambda_5_5_p48, Lambda_5_5_p181_lanes[0],
      Lambda_5_5_p181_lanes[5], Lambda_5_5_p181_lanes[0], Lambda_5_5_p181_lanes[0]) +
      Lambda_5_5_p137_lanes * Lambda_5_5_p106_lanes[0] + Lambda_5_5_p230_lanes *
      Lambda_5_5_p189_lanes[0] + Lambda_5_5_p279_lanes * Lambda_5_5_p254_lanes[0];
  const Real Lambda_5_5_p302 = Lambda_5_5_p218 * Lambda_5_5_p71_lanes[0] - Lambda_5_5_p185 *
      Lambda_5_5_p48 + Lambda_5_5_p228 * Lambda_5_5_p106_lanes[0] + Lambda_5_5_p250 *
      Lambda_5_5_p189_lanes[0] - Lambda_5_5_p284 * Lambda_5_5_p254_lanes[0];
  const Lanes<8> Lambda_5_5_p303_lanes = detail::make_pack<Real>(Lambda_5_5_p209_lanes[1],
      Lambda_5_5_p209_lanes[1], Lambda_5_5_p209_lanes[2], Lambda_5_5_p133 *
      Lambda_5_5_p71_lanes[1] - Lambda_5_5_p134 * Lambda_5_5_p47, Lambda_5_5_p209_lanes[1],
      Lambda_5_5_p209_lanes[5], Lambda_5_5_p209_lanes[1], Lambda_5_5_p209_lanes[1]) +
      Lambda_5_5_p137_lanes * Lambda_5_5_p106_lanes[1] + Lambda_5_5_p230_lanes *
      Lambda_5_5_p189_lanes[1] + Lambda_5_5_p279_lanes * Lambda_5_5_p254_lanes[1];
  const Real Lambda_5_5_p307 = Lambda_5_5_p218 * Lambda_5_5_p71_lanes[1] - Lambda_5_5_p185 *
      Lambda_5_5_p47 + Lambda_5_5_p228 * Lambda_5_5_p106_lanes[1] + Lambda_5_5_p250 *
      Lambda_5_5_p189_lanes[1] - Lambda_5_5_p284 * Lambda_5_5_p254_lanes[1];
  const Lanes<8> Lambda_5_5_p308_lanes = detail::make_pack<Real>(Lambda_5_5_p124_lanes[2] *
      Lambda_5_5_p30 + Lambda_5_5_p120_lanes[2] * Lambda_5_5_p71_lanes[2],
      Lambda_5_5_p124_lanes[2] * Lambda_5_5_p30 + Lambda_5_5_p120_lanes[2] *
      Lambda_5_5_p71_lanes[2], Lambda_5_5_p124_lanes[2] * Lambda_5_5_p30 +
      Lambda_5_5_p120_lanes[2] * Lambda_5_5_p71_lanes[2], Lambda_5_5_p133 *
      Lambda_5_5_p71_lanes[2] - Lambda_5_5_p134 * Lambda_5_5_p30, Lambda_5_5_p124_lanes[2] *
      Lambda_5_5_p30 + Lambda_5_5_p120_lanes[2] * Lambda_5_5_p71_lanes[2],
      Lambda_5_5_p124_lanes[5] * Lambda_5_5_p30 + Lambda_5_5_p120_lanes[5] *
      Lambda_5_5_p71_lanes[2], Lambda_5_5_p124_lanes[2] * Lambda_5_5_p30 +
      Lambda_5_5_p120_lanes[2] * Lambda_5_5_p71_lanes[2], Lambda_5_5_p124_lanes[2] *
      Lambda_5_5_p30 + Lambda_5_5_p120_lanes[2] * Lambda_5_5_p71_lanes[2]) + Lambda_5_5_p137_lanes *
      Lambda_5_5_p106_lanes[2] + Lambda_5_5_p230_lanes * Lambda_5_5_p189_lanes[2] +
      Lambda_5_5_p279_lanes * Lambda_5_5_p254_lanes[2];
  const Real Lambda_5_5_p311 = Lambda_5_5_p218 * Lambda_5_5_p71_lanes[2] - Lambda_5_5_p185 *
      Lambda_5_5_p30 + Lambda_5_5_p228 * Lambda_5_5_p106_lanes[2] + Lambda_5_5_p250 *
      Lambda_5_5_p189_lanes[2] - Lambda_5_5_p284 * Lambda_5_5_p254_lanes[2];
  const Real Lambda_5_5_p312 = Lambda_5_5_p297_lanes[0] * Lambda_5_5_p297_lanes[0];
  const Real Lambda_5_5_p313 = Lambda_5_5_p312 * Lambda_5_5_p297_lanes[0];
  const Real Lambda_5_5_p314 = Lambda_5_5_p313 * Lambda_5_5_p312 /
      (3.0814879110195774e-33 + Lambda_5_5_p313 * Lambda_5_5_p313);
  const Real Lambda_5_5_p315 = Lambda_5_5_p297_lanes[5] * Lambda_5_5_p314;
  const Real Lambda_5_5_p316 = Lambda_5_5_p302 * Lambda_5_5_p314;
  const Real Lambda_5_5_p317 = Lambda_5_5_p297_lanes[3] * Lambda_5_5_p314;
  const Real Lambda_5_5_p318 = Lambda_5_5_p297_lanes[2] * Lambda_5_5_p314;
  const Real Lambda_5_5_p319 = Lambda_5_5_p297_lanes[1] * Lambda_5_5_p314;
  const Lanes<8> Lambda_5_5_p339_lanes = detail::make_pack<Real>(Lambda_5_5_p303_lanes[1],
      Lambda_5_5_p303_lanes[1], Lambda_5_5_p303_lanes[2], Lambda_5_5_p303_lanes[3], Lambda_5_5_p307,
      Lambda_5_5_p303_lanes[5], Lambda_5_5_p303_lanes[1], Lambda_5_5_p303_lanes[1]) -
      detail::make_pack<Real>(Lambda_5_5_p319, Lambda_5_5_p319, Lambda_5_5_p318, Lambda_5_5_p317,
      Lambda_5_5_p316, Lambda_5_5_p315, Lambda_5_5_p319, Lambda_5_5_p319) *
      Lambda_5_5_p297_lanes[1];
  const Real Lambda_5_5_p344 = Lambda_5_5_p339_lanes[1] * Lambda_5_5_p339_lanes[1];
  const Real Lambda_5_5_p345 = Lambda_5_5_p344 * Lambda_5_5_p339_lanes[1];
  const Real Lambda_5_5_p346 = Lambda_5_5_p345 * Lambda_5_5_p344 /
      (3.0814879110195774e-33 + Lambda_5_5_p345 * Lambda_5_5_p345);
  const Lanes<8> Lambda_5_5_p347_lanes = Lambda_5_5_p339_lanes * Lambda_5_5_p346;
  const Real Lambda_0_0_p1 = Lambda_5_5_p319 * Lambda_5_5_p346;
  const Lanes<8> Lambda_5_5_p358_lanes = detail::make_pack<Real>(Lambda_5_5_p308_lanes[2],
      Lambda_5_5_p308_lanes[2], Lambda_5_5_p308_lanes[2], Lambda_5_5_p308_lanes[3], Lambda_5_5_p311,
      Lambda_5_5_p308_lanes[5], Lambda_5_5_p308_lanes[2], Lambda_5_5_p308_lanes[2]) -
      detail::make_pack<Real>(Lambda_5_5_p318, Lambda_5_5_p318, Lambda_5_5_p318, Lambda_5_5_p317,
      Lambda_5_5_p316, Lambda_5_5_p315, Lambda_5_5_p318, Lambda_5_5_p318) *
      Lambda_5_5_p297_lanes[2] - Lambda_5_5_p347_lanes * Lambda_5_5_p339_lanes[2];
  const Real Lambda_0_0_p2 = Lambda_5_5_p347_lanes[2] * Lambda_5_5_p319 - Lambda_5_5_p318;
  const Real Lambda_5_5_p365 = Lambda_5_5_p358_lanes[2] * Lambda_5_5_p358_lanes[2];
  const Real Lambda_5_5_p366 = Lambda_5_5_p365 * Lambda_5_5_p358_lanes[2];
  const Real Lambda_5_5_p367 = Lambda_5_5_p366 * Lambda_5_5_p365 /
      (4.81482486096809e-35 + Lambda_5_5_p366 * Lambda_5_5_p366);
  const Lanes<8> Lambda_5_5_p368_lanes = Lambda_5_5_p358_lanes * Lambda_5_5_p367;
  const Real Lambda_0_0_p3 = Lambda_0_0_p2 * Lambda_5_5_p367;
  const Real Lambda_0_1_p1 = Lambda_5_5_p347_lanes[2] * Lambda_5_5_p367;
  const Lanes<8> Lambda_5_5_p374_lanes = detail::make_pack<Real>(Lambda_5_5_p272 +
      Lambda_5_5_p230_lanes[3] * Lambda_5_5_p189_lanes[3] + Lambda_5_5_p279_lanes[3] *
      Lambda_5_5_p254_lanes[3], Lambda_5_5_p272 + Lambda_5_5_p230_lanes[3] *
      Lambda_5_5_p189_lanes[3] + Lambda_5_5_p279_lanes[3] * Lambda_5_5_p254_lanes[3],
      Lambda_5_5_p272 + Lambda_5_5_p230_lanes[3] * Lambda_5_5_p189_lanes[3] +
      Lambda_5_5_p279_lanes[3] * Lambda_5_5_p254_lanes[3], Lambda_5_5_p272 +
      Lambda_5_5_p230_lanes[3] * Lambda_5_5_p189_lanes[3] + Lambda_5_5_p279_lanes[3] *
      Lambda_5_5_p254_lanes[3], Lambda_5_5_p274 - Lambda_5_5_p284 * Lambda_5_5_p254_lanes[3],
      Lambda_5_5_p273 + Lambda_5_5_p279_lanes[5] * Lambda_5_5_p254_lanes[3], Lambda_5_5_p272 +
      Lambda_5_5_p230_lanes[3] * Lambda_5_5_p189_lanes[3] + Lambda_5_5_p279_lanes[3] *
      Lambda_5_5_p254_lanes[3], Lambda_5_5_p272 + Lambda_5_5_p230_lanes[3] *
      Lambda_5_5_p189_lanes[3] + Lambda_5_5_p279_lanes[3] * Lambda_5_5_p254_lanes[3]) -
      detail::make_pack<Real>(Lambda_5_5_p317, Lambda_5_5_p317, Lambda_5_5_p317, Lambda_5_5_p317,
      Lambda_5_5_p316, Lambda_5_5_p315, Lambda_5_5_p317, Lambda_5_5_p317) *
      Lambda_5_5_p297_lanes[3] - Lambda_5_5_p347_lanes * Lambda_5_5_p339_lanes[3] -
      Lambda_5_5_p368_lanes * Lambda_5_5_p358_lanes[3];
  const Real Lambda_5_5_p377 = Lambda_5_5_p275 + Lambda_5_5_p284 * Lambda_5_5_p268 -
      Lambda_5_5_p316 * Lambda_5_5_p302 - Lambda_5_5_p347_lanes[4] * Lambda_5_5_p339_lanes[4] -
      Lambda_5_5_p368_lanes[4] * Lambda_5_5_p358_lanes[4];
  const Real Lambda_5_5_p378 = Lambda_5_5_p277 - Lambda_5_5_p279_lanes[5] * Lambda_5_5_p268 -
      Lambda_5_5_p315 * Lambda_5_5_p302 - Lambda_5_5_p347_lanes[5] * Lambda_5_5_p339_lanes[4] -
      Lambda_5_5_p368_lanes[5] * Lambda_5_5_p358_lanes[4];
  const Real Lambda_5_5_p379 = Lambda_5_5_p278 + Lambda_5_5_p279_lanes[5] *
      Lambda_5_5_p254_lanes[5] - Lambda_5_5_p315 * Lambda_5_5_p297_lanes[5] -
      Lambda_5_5_p347_lanes[5] * Lambda_5_5_p339_lanes[5] - Lambda_5_5_p368_lanes[5] *
      Lambda_5_5_p358_lanes[5];
  const Real Lambda_0_0_p4 = Lambda_5_5_p347_lanes[3] * Lambda_5_5_p319 - Lambda_5_5_p317 -
      Lambda_5_5_p368_lanes[3] * Lambda_0_0_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p368_lanes[3] * Lambda_5_5_p347_lanes[2] -
      Lambda_5_5_p347_lanes[3];
  const Real Lambda_5_5_p380 = Lambda_5_5_p374_lanes[3] * Lambda_5_5_p374_lanes[3];
  const Real Lambda_5_5_p381 = Lambda_5_5_p380 * Lambda_5_5_p374_lanes[3];
  const Real Lambda_5_5_p382 = Lambda_5_5_p381 * Lambda_5_5_p380 /
      (3.552713678800501e-15 + Lambda_5_5_p381 * Lambda_5_5_p381);
  const Real Lambda_5_5_p383 = Lambda_5_5_p374_lanes[4] * Lambda_5_5_p382;
  const Real Lambda_5_5_p384 = Lambda_5_5_p374_lanes[5] * Lambda_5_5_p382;
  const Real Lambda_0_0_p5 = Lambda_0_0_p4 * Lambda_5_5_p382;
  const Real Lambda_0_1_p3 = Lambda_0_1_p2 * Lambda_5_5_p382;
  const Real Lambda_0_2_p1 = Lambda_5_5_p368_lanes[3] * Lambda_5_5_p382;
  const Real Lambda_5_5_p385 = Lambda_5_5_p377 - Lambda_5_5_p383 * Lambda_5_5_p374_lanes[4];
  const Real Lambda_5_5_p386 = Lambda_5_5_p378 - Lambda_5_5_p384 * Lambda_5_5_p374_lanes[4];
  const Real Lambda_0_0_p6 = Lambda_5_5_p347_lanes[4] * Lambda_5_5_p319 - Lambda_5_5_p316 -
      Lambda_5_5_p368_lanes[4] * Lambda_0_0_p2 - Lambda_5_5_p383 * Lambda_0_0_p4;
  const Real Lambda_0_1_p4 = Lambda_5_5_p368_lanes[4] * Lambda_5_5_p347_lanes[2] -
      Lambda_5_5_p347_lanes[4] - Lambda_5_5_p383 * Lambda_0_1_p2;
  const Real Lambda_0_2_p2 = Lambda_5_5_p383 * Lambda_5_5_p368_lanes[3] - Lambda_5_5_p368_lanes[4];
  const Real Lambda_5_5_p387 = Lambda_5_5_p385 * Lambda_5_5_p385;
  const Real Lambda_5_5_p388 = Lambda_5_5_p387 * Lambda_5_5_p385;
  const Real Lambda_5_5_p389 = Lambda_5_5_p388 * Lambda_5_5_p387 /
      (5.169878828456423e-26 + Lambda_5_5_p388 * Lambda_5_5_p388);
  const Real Lambda_5_5_p390 = Lambda_5_5_p386 * Lambda_5_5_p389;
  const Real Lambda_0_0_p7 = Lambda_0_0_p6 * Lambda_5_5_p389;
  const Real Lambda_0_1_p5 = Lambda_0_1_p4 * Lambda_5_5_p389;
  const Real Lambda_0_2_p3 = Lambda_0_2_p2 * Lambda_5_5_p389;
  const Real Lambda_0_3_p1 = Lambda_5_5_p383 * Lambda_5_5_p389;
  const Real Lambda_5_5_p391 = Lambda_5_5_p379 - Lambda_5_5_p384 * Lambda_5_5_p374_lanes[5] -
      Lambda_5_5_p390 * Lambda_5_5_p386;
  const Real Lambda_0_5_p1 = Lambda_5_5_p347_lanes[5] * Lambda_5_5_p319 - Lambda_5_5_p315 -
      Lambda_5_5_p368_lanes[5] * Lambda_0_0_p2 - Lambda_5_5_p384 * Lambda_0_0_p4 - Lambda_5_5_p390 *
      Lambda_0_0_p6;
  const Real Lambda_1_5_p1 = Lambda_5_5_p368_lanes[5] * Lambda_5_5_p347_lanes[2] -
      Lambda_5_5_p347_lanes[5] - Lambda_5_5_p384 * Lambda_0_1_p2 - Lambda_5_5_p390 * Lambda_0_1_p4;
  const Real Lambda_2_5_p1 = Lambda_5_5_p384 * Lambda_5_5_p368_lanes[3] - Lambda_5_5_p368_lanes[5] -
      Lambda_5_5_p390 * Lambda_0_2_p2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p390 * Lambda_5_5_p383 - Lambda_5_5_p384;
  const Real Lambda_0_0_p8 = Lambda_5_5_p314 + Lambda_0_0_p1 * Lambda_5_5_p319 + Lambda_0_0_p3 *
      Lambda_0_0_p2 + Lambda_0_0_p5 * Lambda_0_0_p4 + Lambda_0_0_p7 * Lambda_0_0_p6;
  const Real Lambda_5_5_p392 = Lambda_5_5_p391 * Lambda_5_5_p391;
  const Real Lambda_5_5_p393 = Lambda_5_5_p392 * Lambda_5_5_p391;
  const Real Lambda_5_5 = Lambda_5_5_p393 * Lambda_5_5_p392 /
      (8.077935669463161e-28 + Lambda_5_5_p393 * Lambda_5_5_p393);
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
  const Real Lambda_4_5 = Lambda_5_5_p390 * Lambda_5_5;
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
  Lambda[7] = Lambda_5_5_p346 + Lambda_0_1_p1 * Lambda_5_5_p347_lanes[2] + Lambda_0_1_p3 *
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
  Lambda[14] = Lambda_5_5_p367 + Lambda_0_2_p1 * Lambda_5_5_p368_lanes[3] + Lambda_0_2_p3 *
      Lambda_0_2_p2 + Lambda_2_5 * Lambda_2_5_p1;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p1 -
      (Lambda_0_2_p1 + Lambda_0_3_p1 * Lambda_0_2_p2);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p3 - Lambda_4_5 * Lambda_2_5_p1;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p382 + Lambda_0_3_p1 * Lambda_5_5_p383 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p389 + Lambda_4_5 * Lambda_5_5_p390;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
