#include <gtest/gtest.h>
#include <unistd.h>

#include "compilation/keep_library.hpp"
#include "own_folder.hpp"

// Would catch: code that is loaded from a folder to which another user could have written.

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

class DistrustFolder : public test::OwnFolder {
 protected:
  DistrustFolder() {
    fs::create_directories(root_ / "above" / "kept");
    set_mode("", 0755);
    set_mode("above", 0755);
    set_mode("above/kept", 0700);
  }
  void set_mode(const std::string& folder, unsigned mode) const {
    fs::permissions(root_ / folder, fs::perms(mode));
  }
  [[nodiscard]] std::string reason(const std::string& folder = "above/kept") const {
    const auto found = reason_to_distrust(root_ / folder);
    if (found) EXPECT_FALSE(found->remedy.empty());
    return found ? found->fault : "";
  }
};

TEST_F(DistrustFolder, TrustsWhatIsOnlyTheUsers) {
  EXPECT_EQ(reason(), "");
  set_mode("above/kept", 0755);
  EXPECT_EQ(reason(), "");
  EXPECT_EQ(reason("above/not/there/yet"), "");
  EXPECT_FALSE(reason_to_distrust(""));
}

TEST_F(DistrustFolder, DistrustsWhatOthersMayWrite) {
  for (const unsigned mode : {0777U, 0770U, 0720U, 0702U, 01777U}) {
    set_mode("above/kept", mode);
    EXPECT_NE(reason().find("others may write to it"), std::string::npos) << mode;
  }
}

TEST_F(DistrustFolder, DistrustsWhatOthersMayReplace) {
  set_mode("above", 0777);
  EXPECT_NE(reason().find("above it, and so replace it"), std::string::npos) << reason();
  EXPECT_NE(reason("above/not/there/yet"), "");
  set_mode("above", 01777);  // as /tmp: nobody removes what is another's
  EXPECT_EQ(reason(), "");
}

TEST_F(DistrustFolder, SeesThroughLinks) {
  set_mode("above/kept", 0777);
  fs::create_symlink(root_ / "above" / "kept", root_ / "link");
  EXPECT_NE(reason("link"), "");
}

TEST_F(DistrustFolder, DistrustsWhatAnotherOwns) {
  if (geteuid() != 0) {
    EXPECT_EQ(reason_to_distrust("/usr").has_value(), true) << "it is root's";
    return;
  }
  ASSERT_EQ(::chown((root_ / "above/kept").c_str(), 12345, 12345), 0);
  EXPECT_NE(reason().find("belongs to the user of number 12345"), std::string::npos) << reason();
  // What sudo finds that keeps HOME.
  ASSERT_EQ(::chown((root_ / "above/kept").c_str(), 0, 0), 0);
  ASSERT_EQ(::chown((root_ / "above").c_str(), 12345, 12345), 0);
  EXPECT_NE(reason().find("above it belongs to the user"), std::string::npos) << reason();
  EXPECT_NE(reason("above/not/there/yet"), "");
}

}  // namespace
}  // namespace treeline::tests
