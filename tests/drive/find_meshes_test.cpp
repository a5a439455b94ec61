// Would catch: a file of the machine that a URDF makes the server give away; a mesh that is there,
// by consent, and is not found; a reason that is not the true one, or a remedy that does not help.
#include "drive/find_meshes.hpp"

#include <gtest/gtest.h>

#include "../own_folder.hpp"

namespace treeline::drive {
namespace {

namespace fs = std::filesystem;

class MeshTest : public treeline::test::OwnFolder {
 protected:
  void make(const std::string& file, const std::string& bytes = "solid") const {
    fs::create_directories((root_ / file).parent_path());
    write(file, bytes);
  }
  /// The mesh of one name in a URDF that lies in `folder`.
  [[nodiscard]] ServedMesh find(const std::string& name, const std::string& folder,
                                const MeshPlaces& places = {}) const {
    return find_meshes("<mesh filename=\"" + name + "\"/>", root_ / folder, places).at(0);
  }
  [[nodiscard]] std::string path(const std::string& file) const { return (root_ / file).string(); }
};

// A URDF can name any file; only meshes inside of its own folder or package are found.
TEST_F(MeshTest, FindsOnlyMeshesBelowTheirFolder) {
  for (const char* name :
       {"arm/meshes/a.stl", "arm/urdf/b.DAE", "secret.stl", "arm/urdf/key.txt"}) {
    make(name);
  }
  fs::create_symlink(root_ / "secret.stl", root_ / "arm/urdf/link.stl");
  const std::string urdf =
      "<mesh filename=\"package://arm/meshes/a.stl\"/><mesh scale='1 1 1' filename='b.DAE'/>"
      "<mesh filename='../../secret.stl'/><mesh filename='link.stl'/><mesh filename='key.txt'/>"
      "<mesh filename='/etc/passwd'/><mesh filename='package://arm/../secret.stl'/>"
      "<mesh filename='package://other/c.stl'/><mesh filename='package://../secret.stl'/>"
      "<mesh filename='http://host/a.stl'/><mesh filename='file:///etc/passwd'/>"
      "<mesh filename=\"package://arm/meshes/a.stl\"/>";
  const auto meshes = find_meshes(urdf, root_ / "arm/urdf", {});
  ASSERT_EQ(meshes.size(), 11U);
  for (const ServedMesh& mesh : meshes) {
    const bool wanted = mesh.uri == "package://arm/meshes/a.stl" || mesh.uri == "b.DAE";
    EXPECT_EQ(!mesh.path.empty(), wanted) << mesh.uri << ": " << mesh.path;
    EXPECT_EQ(mesh.problem.empty(), wanted) << mesh.uri;
    EXPECT_EQ(mesh.remedy.empty(), wanted) << mesh.uri;
  }
}

// A home is above each robot in it, and has a name too.
TEST_F(MeshTest, AFolderAboveIsAPackageOnlyIfItSaysSo) {
  make("home/secret/key.stl");
  make("home/robots/arm/arm.urdf");
  make("home/robots/other/c.stl");
  for (const char* name : {"package://home/secret/key.stl", "package://robots/other/c.stl",
                           "package://secret/key.stl", "package://other/c.stl"}) {
    const ServedMesh mesh = find(name, "home/robots/arm");
    EXPECT_EQ(mesh.path, "") << name;
    EXPECT_NE(mesh.problem.find("no package.xml"), std::string::npos) << mesh.problem;
    EXPECT_NE(mesh.remedy.find("--package "), std::string::npos) << mesh.remedy;
  }
  const ServedMesh told = find("package://other/c.stl", "home/robots/arm");
  EXPECT_EQ(told.remedy, "If it is meant: --package other=" + path("home/robots/other") + ".");
  MeshPlaces given;
  given.packages["other"] = root_ / "home/robots/other";
  EXPECT_EQ(find("package://other/c.stl", "home/robots/arm", given).path,
            path("home/robots/other/c.stl"));
  make("home/robots/other/package.xml");
  EXPECT_EQ(find("package://other/c.stl", "home/robots/arm").path, path("home/robots/other/c.stl"));
  make("home/robots/package.xml");
  EXPECT_NE(find("package://robots/other/c.stl", "home/robots/arm").path, "");
}

TEST_F(MeshTest, FindsWhatTheUserConsentsTo) {
  make("arm/meshes/my arm.stl");
  const std::string absolute = path("arm/meshes/my arm.stl");
  std::string address = "file://" + absolute;
  address.replace(address.find(' '), 1, "%20");
  MeshPlaces places;
  places.folders = {root_ / "arm/meshes"};
  for (const std::string& name : {std::string("../meshes/my arm.stl"), absolute,
                                  "file://" + absolute, address, "file://localhost" + absolute}) {
    const ServedMesh without = find(name, "arm/urdf");
    EXPECT_EQ(without.path, "") << name;
    EXPECT_NE(without.problem.find("lies outside of"), std::string::npos) << without.problem;
    EXPECT_EQ(without.remedy, "If its folder is meant: --mesh-folder " + path("arm/meshes") + ".");
    EXPECT_EQ(find(name, "arm/urdf", places).path, absolute) << name;
    EXPECT_EQ(find(name, "arm").path, name.starts_with("..") ? "" : absolute) << name;
  }
}

TEST_F(MeshTest, FindsInstalledPackages) {
  make("ws/install/share/arm_meshes/source/a.stl");
  fs::create_symlink(root_ / "ws/install/share/arm_meshes/source/a.stl",
                     root_ / "ws/install/share/arm_meshes/a.stl");
  make("src/stack/deep/package.xml");
  make("src/stack/deep/b.stl");
  make("src/flat/b.stl");
  make("secret.stl");
  make("robots/arm.urdf");
  MeshPlaces places;
  places.prefixes = {root_ / "none", root_ / "ws/install"};
  places.sources = {root_ / "none", root_ / "src"};
  EXPECT_NE(find("package://arm_meshes/a.stl", "robots", places).path, "");
  EXPECT_NE(find("package://flat/b.stl", "robots", places).path, "");
  EXPECT_NE(find("package://deep/b.stl", "robots", places).path, "");
  EXPECT_EQ(find("package://flat/../../secret.stl", "robots", places).path, "");
  const ServedMesh none = find("package://nowhere/b.stl", "robots", places);
  EXPECT_NE(none.problem.find("no package nowhere"), std::string::npos) << none.problem;
  EXPECT_NE(none.remedy.find("--package nowhere=DIR"), std::string::npos) << none.remedy;
  EXPECT_NE(find("package://flat/c.stl", "robots", places).problem.find("there is no file"),
            std::string::npos);
}

TEST_F(MeshTest, TellsAnStlThatIsCutShort) {
  const auto binary = [](std::size_t triangles, std::size_t bytes) {
    std::string stl(80, ' ');
    for (int i = 0; i < 4; ++i) stl += static_cast<char>(triangles >> (8 * i));
    stl.resize(bytes, '\0');
    return stl;
  };
  make("arm/whole.stl", binary(3, 84 + 150));
  make("arm/cut.stl", binary(3, 84 + 149));
  make("arm/head.STL", std::string(40, ' '));
  make("arm/words.stl", "solid a\nfacet normal 0 0 1\nendsolid a\n");
  EXPECT_NE(find("whole.stl", "arm").path, "");
  EXPECT_NE(find("words.stl", "arm").path, "");
  const ServedMesh cut = find("cut.stl", "arm");
  EXPECT_EQ(cut.path, "");
  EXPECT_EQ(cut.problem, "it is cut short: 3 triangles take 234 bytes, it has 233");
  EXPECT_EQ(find("head.STL", "arm").problem, "it is cut short: it has 40 bytes");
}

}  // namespace
}  // namespace treeline::drive
