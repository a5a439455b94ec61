#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "compilation/run_commands.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "emission/write_files.hpp"
#include "generation/draw_limbs.hpp"
#include "generation/generate_code.hpp"
#include "generation/mixed_lanes.hpp"
#include "own_folder.hpp"

// Random robots with families of limbs, in two, four and eight lanes: families of two, three to
// four and five to eight limbs share registers of different widths, and columns of matrices others.
// Would catch: an expression whose operands have different numbers of lanes, which no compiler
// takes.

namespace treeline::tests {
namespace {

constexpr std::uint64_t kSeeds = 10;

/// Files of a robot, if its scene is one that can be had; random ones may be singular.
std::vector<GeneratedFile> generate(const DrawnLimbs& drawn) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(drawn.urdf, "limbed.urdf", diagnostics);
  const auto scene =
      robot ? parse_scene(drawn.scene, "limbed.yaml", *robot, diagnostics) : std::nullopt;
  auto generation =
      scene ? generate_code(*robot, *scene, {"limbed.urdf", drawn.urdf, "limbed.yaml", drawn.scene},
                            diagnostics)
            : std::nullopt;
  if (generation) return std::move(generation->files);
  for (const Diagnostic& each : diagnostics.list()) {
    if (each.severity == Severity::error) ADD_FAILURE() << to_string(each) << drawn.scene;
  }
  return {};
}

TEST(LimbLanes, NoExpressionMixesNumbersOfLanes) {
  std::set<int> widths;
  int sources_of_several_widths = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const int lanes : {2, 4, 8}) {
      const DrawnLimbs drawn = draw_limbs(seed, lanes);
      for (const GeneratedFile& file : generate(drawn)) {
        if (!file.name.ends_with(".cpp")) continue;
        const DeclaredLanes read = read_lanes(file.text);
        EXPECT_EQ(read.mixed, "") << "seed " << seed << ", " << file.name << '\n' << drawn.scene;
        std::set<int> own;
        for (const auto& [name, width] : read.widths) own.insert(width);
        widths.insert(own.begin(), own.end());
        sources_of_several_widths += own.size() > 1 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(widths, (std::set<int>{2, 4, 8}));
  EXPECT_GT(sources_of_several_widths, static_cast<int>(kSeeds));
}

TEST(LimbLanes, MixedExpressionsAreSeen) {
  const std::string narrow = "const Lanes<4> a_lanes = detail::make_pack<Real>(x, (y), z, w);\n";
  EXPECT_EQ(read_lanes(narrow + "const Lanes<4> b_lanes = 2.0 * a_lanes;").mixed, "");
  EXPECT_EQ(read_lanes(narrow + "const Lanes<8> b_lanes = a_lanes[1] * a_lanes;").mixed,
            "const Lanes<8> b_lanes = a_lanes[1] * a_lanes");
  EXPECT_NE(read_lanes("const Lanes<8> c_lanes = detail::make_pack<Real>(x, y);").mixed, "");
}

class LimbLanesCompile : public test::OwnFolder {};

/// A compiler's front end agrees on some of them.
TEST_F(LimbLanesCompile, SourcesAreWellFormed) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const std::vector<GeneratedFile> files = generate(draw_limbs(seed, 8));
    const auto folder = root_ / std::to_string(seed);
    Diagnostics diagnostics;
    ASSERT_TRUE(write_files(folder, files, diagnostics));
    Command command{"c++", "-std=c++17", "-fsyntax-only"};
    for (const GeneratedFile& file : files) {
      if (file.name.ends_with(".cpp")) command.push_back(folder / file.name);
    }
    const auto outcome = run_commands({command}, 1, root_);
    EXPECT_EQ(outcome.at(0).exit_code, 0) << "seed " << seed << '\n' << outcome[0].output;
  }
}

}  // namespace
}  // namespace treeline::tests
