#include "compilation/keep_library.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <thread>

#include "own_environment.hpp"
#include "own_folder.hpp"

// Would catch: a library of other sources, flags or of another compiler that is taken for the one
// asked for, one that is damaged, a folder that grows without end or is found against XDG's rules,
// and a run that fails because its library cannot be kept.

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

class KeptLibrary : public test::OwnFolder {
 protected:
  KeptLibrary() {
    fs::create_directories(root_ / "work" / "runtime");
    write("work/gravity.cpp", "int gravity();\n");
  }
  [[nodiscard]] std::string identity(const std::string& work, const std::string& flag = "-O2",
                                     const std::string& compiler = "c++",
                                     const std::string& link_flag = "-shared") const {
    const fs::path folder = root_ / work;
    return identify_library({compiler}, {{compiler, flag, "-c", folder / "gravity.cpp"}},
                            {compiler, link_flag, folder / "gravity.o"}, folder);
  }

  void keep(const std::string& name, const std::string& bytes) {
    write("library.so", bytes);
    keep_library(root_ / "library.so", root_ / "kept", name);
  }

  [[nodiscard]] std::string take(const std::string& name) const {
    return take_kept_library(root_ / "kept", name, root_ / "taken.so")
               ? read_file(root_ / "taken.so")
               : "none";
  }

  test::OwnEnvironment environment_;
};

TEST_F(KeptLibrary, IsNamedByAllThatGoesIntoIt) {
  const std::string name = identity("work");
  EXPECT_EQ(identity("work"), name);
  fs::rename(root_ / "work", root_ / "moved");
  EXPECT_EQ(identity("moved"), name);
  EXPECT_NE(identity("moved", "-O1"), name);
  EXPECT_NE(identity("moved", "-O2", "clang++"), name);
  EXPECT_NE(identity("moved", "-O2", "c++", "-static"), name);
  environment_.set("CPATH", "/opt/include");
  EXPECT_NE(identity("moved"), name);
  environment_.set("CPATH", std::nullopt);
  write("moved/gravity.cpp", "int  gravity();\n");
  EXPECT_NE(identity("moved"), name);
  write("moved/gravity.cpp", "int gravity();\n");
  EXPECT_EQ(identity("moved"), name);
  write("moved/runtime/sin_cos.hpp", "");
  EXPECT_NE(identity("moved"), name);
}

TEST_F(KeptLibrary, IsTakenWithTheSameBytes) {
  EXPECT_EQ(take("gravity"), "none");
  keep("gravity", "bytes");
  keep("gravity_of_another", "others");
  EXPECT_EQ(take("gravity"), "bytes");
  EXPECT_EQ(take("gravit"), "none");
  keep("gravity", "bytes");
  EXPECT_EQ(take("gravity"), "bytes");
}

TEST_F(KeptLibrary, IsNotTakenOnceItIsDamaged) {
  keep("gravity", "bytes");
  for (const auto& entry : fs::directory_iterator(root_ / "kept")) {
    std::ofstream(entry.path(), std::ios::app) << "more";
  }
  EXPECT_EQ(take("gravity"), "none");
  EXPECT_TRUE(fs::is_empty(root_ / "kept"));
}

TEST_F(KeptLibrary, GivesPlaceToThoseUsedLater) {
  const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  keep("first", "1");
  wait();
  keep("second", "2");
  wait();
  EXPECT_EQ(take("first"), "1");
  wait();
  for (int i = 0; i < 31; ++i) keep("other" + std::to_string(i), "other");
  EXPECT_EQ(take("first"), "1");
  EXPECT_EQ(take("second"), "none");
}

TEST_F(KeptLibrary, IsLeftAloneWhereItsFolderCannotBe) {
  write("file", "");
  write("library.so", "bytes");
  keep_library(root_ / "library.so", root_ / "file" / "kept", "gravity");
  EXPECT_FALSE(take_kept_library(root_ / "file" / "kept", "gravity", root_ / "taken.so"));
  EXPECT_EQ(read_file(root_ / "library.so"), "bytes");
}

TEST_F(KeptLibrary, LiesWhereTheEnvironmentSays) {
  environment_.set("TREELINE_CACHE", std::nullopt);
  environment_.set("XDG_CACHE_HOME", std::nullopt);
  environment_.set("HOME", "/home/someone");
  EXPECT_EQ(folder_of_kept_libraries(), "/home/someone/.cache/treeline");
  environment_.set("XDG_CACHE_HOME", "relative");  // is to be ignored, says the specification
  EXPECT_EQ(folder_of_kept_libraries(), "/home/someone/.cache/treeline");
  environment_.set("XDG_CACHE_HOME", "/var/cache/someone");
  EXPECT_EQ(folder_of_kept_libraries(), "/var/cache/someone/treeline");
  environment_.set("TREELINE_CACHE", "/tmp/kept");
  EXPECT_EQ(folder_of_kept_libraries(), "/tmp/kept");
  environment_.set("TREELINE_CACHE", "kept");
  EXPECT_EQ(folder_of_kept_libraries(), fs::current_path() / "kept");
  environment_.set("TREELINE_CACHE", "");
  EXPECT_EQ(folder_of_kept_libraries(), "");
  environment_.set("TREELINE_CACHE", std::nullopt);
  environment_.set("XDG_CACHE_HOME", std::nullopt);
  environment_.set("HOME", std::nullopt);
  EXPECT_EQ(folder_of_kept_libraries(), "");
}

}  // namespace
}  // namespace treeline::tests
