// Would catch: a file of tests/data whose source or licence is not stated, and a stated file that
// does not exist, with which a test would pass without testing anything.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "data/list_data.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> kLicences = {"Apache-2.0",   "Apache-2.0 OR BSD", "Apache-2.0 OR MIT",
                                         "BSD-2-Clause", "BSD-3-Clause",      "MIT",
                                         "Zlib",         "as Treeline"};

std::set<std::string> files_present() {
  std::set<std::string> files;
  for (const char* folder : {"golden", "hands", "mjcf", "published", "odd", "suite", "written"}) {
    for (const auto& entry : fs::directory_iterator(data_folder() + "/" + folder)) {
      files.insert(std::string(folder) + "/" + entry.path().filename().string());
    }
  }
  files.erase("odd/expected.tsv");
  return files;
}

TEST(DataSources, NameEveryFileOnce) {
  std::set<std::string> named;
  for (const DataSource& source : data_sources()) {
    EXPECT_TRUE(named.insert(source.file).second) << source.file << " has two rows";
  }
  EXPECT_EQ(named, files_present());
}

TEST(DataSources, StateAPermittedLicence) {
  for (const DataSource& source : data_sources()) {
    EXPECT_EQ(kLicences.count(source.licence), 1U) << source.file << ": " << source.licence;
    EXPECT_EQ(source.repository == "-", source.licence == "as Treeline") << source.file;
  }
}

TEST(DataSources, AreAllThere) {
  EXPECT_EQ(data_robots("published").size(), 29U);
  EXPECT_EQ(data_robots("golden").size(), 5U);
  EXPECT_ANY_THROW((void)data_file("published/none.urdf"));
}

}  // namespace
}  // namespace treeline::tests
