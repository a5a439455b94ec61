// Would catch: a damaged mesh that ends the program, takes memory without end, or is drawn in part
// as if it were whole; and a fault that is not told. What whole meshes must give is in
// meshes_test.py.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "../../own_folder.hpp"
#include "description/mesh/mesh.hpp"

namespace treeline {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::string bytes_of(std::uint32_t number) {
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i));
  return bytes;
}

/// A binary STL that states `count` triangles and has those of `corners`, nine numbers each.
std::string binary(std::uint32_t count, const std::vector<float>& corners) {
  std::string stl = "solid of a program that begins so" + std::string(47, ' ') + bytes_of(count);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 9 == 0) stl += std::string(12, '\0');
    stl += bytes_of(std::bit_cast<std::uint32_t>(corners[i]));
    if (i % 9 == 8) stl += std::string(2, '\0');
  }
  return stl;
}

const std::string kWords =
    "solid a vertex of it\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 1e0 0\nendloop\nendfacet\nendsolid\n";

const std::string kObj =
    "# a square\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3 -1\n";

const std::string kCollada = R"(<?xml version="1.0"?><COLLADA><asset><unit meter="0.01"/></asset>
<library_effects><effect id="e"><profile_COMMON><technique><phong>
  <diffuse><color>0.2 0.4 0.6 1</color></diffuse></phong></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="s"><float_array id="f" count="9">0 0 0 100 0 0 0 100 0</float_array>
  <technique_common><accessor stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<polylist material="k"><input semantic="NORMAL" offset="0" source="#n"/>
  <input semantic="VERTEX" offset="1" source="#v"/><vcount>3</vcount><p>7 0 7 1 7 2</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node id="one"><translate>0 0 300</translate>
  <rotate>0 0 1 90</rotate><instance_geometry url="#g"><bind_material><technique_common>
  <instance_material symbol="k" target="#m"/></technique_common></bind_material></instance_geometry>
</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>)";

class ReadMeshTest : public test::OwnFolder {
 protected:
  [[nodiscard]] Mesh read(const std::string& name, const std::string& bytes) const {
    write(name, bytes);
    return read_mesh((root_ / name).string());
  }
  [[nodiscard]] std::string problem(const std::string& name, const std::string& bytes) const {
    const Mesh mesh = read(name, bytes);
    EXPECT_TRUE(mesh.triangles.empty()) << name;
    EXPECT_NE(mesh.remedy, "") << name;
    return mesh.problem;
  }
};

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  return text.replace(text.find(old), old.size(), by);
}

TEST_F(ReadMeshTest, ReadsEachFormat) {
  EXPECT_EQ(read("a.stl", binary(1, {0, 0, 0, 1, 0, 0, 0, 1, 0})).triangles.size(), 1U);
  EXPECT_EQ(read("a.STL", kWords).triangles.size(), 1U);
  EXPECT_EQ(read("a.obj", kObj).triangles.size(), 2U);
  // A face of four corners that is not plane: along the shorter diagonal, as in other programs.
  const Mesh bent = read("b.obj", "v 0 0 0\nv 1 0 1\nv 3 3 0\nv 0 1 1\nf 1 2 3 4\n");
  ASSERT_EQ(bent.triangles.size(), 2U);
  for (const Triangle& triangle : bent.triangles) {
    for (const Eigen::Vector3d& end : {Eigen::Vector3d(1, 0, 1), Eigen::Vector3d(0, 1, 1)}) {
      EXPECT_TRUE(std::ranges::count(triangle.corners, end));
    }
  }
  const Mesh mesh = read("a.dae", kCollada);
  ASSERT_EQ(mesh.triangles.size(), 1U) << mesh.problem;
  EXPECT_EQ(mesh.triangles[0].color, (Color{0.2, 0.4, 0.6}));
  EXPECT_LT((mesh.triangles[0].corners[1] - Eigen::Vector3d(0, 1, 3)).norm(), 1e-12);
}

TEST_F(ReadMeshTest, TellsWhatIsWrong) {
  const std::vector<float> one = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(problem("a.stl", ""), "it is cut short: it has 0 bytes");
  EXPECT_EQ(problem("a.stl", binary(0, {})), "it has no triangles");
  EXPECT_EQ(problem("a.stl", "x" + binary(4294967295, one).substr(1)),
            "it is cut short: 4294967295 triangles take 214748364834 bytes, it has 134");
  EXPECT_EQ(problem("a.stl", binary(1, {0, 0, 0, 1, kNan, 0, 0, 1, 0})),
            "a coordinate is no number, or beyond 1e30");
  EXPECT_EQ(problem("a.stl", replaced(kWords, "vertex 1 0 0", "vertex 1 nan 0")),
            "a vertex is not three numbers");
  EXPECT_EQ(problem("a.stl", replaced(kWords, "vertex 1 0 0", "")),
            "it is cut short within a triangle");
  EXPECT_EQ(problem("a.stl", "solid nothing\nendsolid\n"), "it has no triangles");
  EXPECT_EQ(problem("a.obj", "v 0 0 0\nv 1 0\n"), "line 2: a vertex is not three numbers");
  for (const char* face :
       {"f 1 2 5", "f 1 2", "f 1 2 0", "f 1 2 -5", "f 1 2 3x", "f 1 2 99999999999999999999"}) {
    EXPECT_EQ(problem("a.obj", replaced(kObj, "f 1//1 2//1 3 -1", face)),
              "line 7: a face is not three or more vertices of those above");
  }
  EXPECT_EQ(problem("a.glb", "glTF"), "pictures have no meshes of the format .glb");
  EXPECT_EQ(read_mesh((root_ / "nowhere.stl").string()).problem, "there is no such file");
}

TEST_F(ReadMeshTest, TellsWhatIsWrongInCollada) {
  const auto with = [&](const std::string& old, const std::string& by) {
    return problem("a.dae", replaced(kCollada, old, by));
  };
  EXPECT_EQ(problem("a.dae", "<COLLADA>"), "line 1: it is not well-formed XML");
  EXPECT_EQ(problem("a.dae", "<robot/>"), "it is no COLLADA");
  EXPECT_EQ(problem("a.dae", "<COLLADA/>"), "it has no visual scene");
  EXPECT_EQ(with("7 0 7 1 7 2", "7 0 7 1 7 3"), "line 10: a vertex is not there");
  EXPECT_EQ(with("7 0 7 1 7 2", "7 0 7 1 7 -1"), "line 10: an index is no whole number");
  EXPECT_EQ(with("7 0 7 1 7 2", "7 0 7 1"), "line 10: it is cut short");
  EXPECT_EQ(with("<vcount>3", "<vcount>18446744073709551615"), "line 10: it is cut short");
  EXPECT_EQ(with("0 0 0 100", "0 0 nan 100"), "line 9: the vertices cannot be read");
  EXPECT_EQ(with("stride=\"3\"", "stride=\"0\""), "line 9: the vertices cannot be read");
  EXPECT_EQ(with("offset=\"1\"", "offset=\"4294967295\""), "line 10: it is cut short");
  EXPECT_EQ(with("url=\"#g\"", "url=\"#s\""), "it has no triangles");
  EXPECT_EQ(with("url=\"#g\"", "url=\"#gone\""),
            "line 13: <instance_geometry> names nothing that can be drawn");
  EXPECT_EQ(with("<translate>", "<instance_node url=\"#one\"/><translate>"),
            "line 12: nodes stand for one another without end");
  EXPECT_EQ(with("polylist material=\"k\"", "tristrips"), "line 9: it is not well-formed XML");
}

// Every beginning of a file, and every byte changed. Would catch, with sanitizers: a place beyond
// the end that is read.
TEST_F(ReadMeshTest, SurvivesEveryCutAndEveryChange) {
  const auto read_text = [](const std::string& text, auto reader) {
    std::vector<Triangle> triangles;
    (void)reader(text, triangles);
    return triangles.size();
  };
  const auto try_all = [&](const std::string& text, auto reader) {
    ASSERT_GT(read_text(text, reader), 0U);
    for (std::size_t i = 0; i < text.size(); ++i) {
      EXPECT_LE(read_text(text.substr(0, i), reader), 2U);
      for (const char c : {'\0', '9', '-', '<', '\xff'}) {
        std::string changed = text;
        changed[i] = c;
        EXPECT_LE(read_text(changed, reader), 4U);
      }
    }
  };
  try_all(binary(1, {0, 0, 0, 1, 0, 0, 0, 1, 0}), read_stl);
  try_all(kWords, read_stl);
  try_all(kObj, read_obj);
  try_all(kCollada, read_collada);
}

}  // namespace
}  // namespace treeline
