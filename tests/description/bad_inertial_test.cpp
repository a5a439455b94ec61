// Would catch: a kind of fault that is accepted without a message, or reported without its place or
// a remedy. Every case has one fault in an otherwise correct robot, in the reported line.
#include <gtest/gtest.h>

#include "bad_urdf.hpp"

namespace treeline::bad_urdf {
namespace {

class BadInertial : public testing::TestWithParam<Case> {};

TEST_P(BadInertial, IsDiagnosed) {
  expect_case(GetParam());
}

const Case kInertials[] = {
    {"NoMass",
     with_link("<inertial><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>"),
     {kError, 3, "robot/link[a]/inertial", "no <mass>", "add <mass"}},
    {"NoMassValue",
     with_link("<inertial><mass/></inertial>"),
     {kError, 3, "robot/link[a]/inertial/mass", "\"value\" is missing", "kg"}},
    {"NegativeMass",
     with_link("<inertial><mass value='-2'/></inertial>"),
     {kError, 3, "robot/link[a]/inertial/mass", "the mass -2 kg is negative", "mass"}},
    {"InfiniteMass",
     with_link("<inertial><mass value='inf'/></inertial>"),
     {kError, 3, "robot/link[a]/inertial/mass", "not a finite number", "decimal"}},
    {"NoInertia",
     with_link("<inertial><mass value='2'/></inertial>"),
     {kWarning, 3, "robot/link[a]/inertial", "2 kg and no <inertia>", "add <inertia"}},
    {"MissingMoment",
     inertia("ixx='1' ixy='0' ixz='0' iyz='0' izz='1'"),
     {kError, 4, "robot/link[a]/inertial/inertia", "\"iyy\" is missing", "all six"}},
    {"MissingProduct",
     inertia("ixx='1' ixz='0' iyy='1' iyz='0' izz='1'"),
     {kError, 4, "robot/link[a]/inertial/inertia", "\"ixy\" is missing", "all six"}},
    {"MomentNoNumber",
     inertia("ixx='0 2 3' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'"),
     {kError, 4, "robot/link[a]/inertial/inertia", "ixx=\"0 2 3\"", "one decimal number"}},
    {"Asymmetric",
     inertia("ixx='1' ixy='0.1' iyx='0.2' ixz='0' iyy='1' iyz='0' izz='1'"),
     {kWarning, 4, "robot/link[a]/inertial/inertia",
      "iyx=0.2 differ, though an inertia is symmetric: "
      "ixy is used",
      "keep ixy"}},
    // Eigenvalues of [1 2 3; 2 4 5; 3 5 6]: -0.515729, 0.170915, 11.3448.
    {"Indefinite",
     inertia("ixx='1' ixy='2' ixz='3' iyy='4' iyz='5' izz='6'"),
     {kWarning, 3, "robot/link[a]/inertial",
      "indefinite: principal moments -0.515729, 0.170915, 11.3448 kg m^2, worst -0.515729",
      "units"}},
    {"Triangle",
     inertia("ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='4'"),
     {kWarning, 3, "robot/link[a]/inertial",
      "1, 1, 4 kg m^2 the largest exceeds the sum of the others by 50 %", "units"}},
    {"MomentWithoutMass",
     with_link("<inertial><mass value='0'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
               "izz='1'/></inertial>"),
     {kWarning, 3, "robot/link[a]/inertial", "the mass is 0 but", "units"}},
    {"TwoInertials",
     with_link(link_body() + "\n" + link_body()),
     {kWarning, 4, "robot/link[a]/inertial", "the first, in line 3, is used", "keep one"}},
    {"OutsideInertial",
     with_link("<mass value='1'/>"),
     {kWarning, 3, "robot/link[a]", "<mass> stands outside <inertial>", "move"}},
    {"ShapeOnly",
     "<robot name='r'>\n<link name='a'/><joint name='j' type='fixed'><parent link='a'/><child "
     "link='b'/></joint>\n<link name='b'><visual/></link></robot>",
     {kWarning, 3, "robot/link[b]", "a shape but no <inertial>", "add <inertial>"}},
};
INSTANTIATE_TEST_SUITE_P(Inertials, BadInertial, testing::ValuesIn(kInertials), name_of);

// Would catch: warnings about inertias that are wrong only by the rounding of their figures.
TEST(UnphysicalInertia, AllowsForRoundedFigures) {
  Diagnostics diagnostics;
  // A thin plate: ixx + iyy = izz up to the last figure.
  EXPECT_TRUE(
      parse_urdf(inertia("ixx='0.33333' ixy='0' ixz='0' iyy='0.33333' iyz='0' izz='0.66667'"),
                 "plate.urdf", diagnostics));
  EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics);
}

}  // namespace
}  // namespace treeline::bad_urdf
