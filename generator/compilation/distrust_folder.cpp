#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compilation/keep_library.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

Diagnostic warn(const fs::path& folder, std::string fault, std::string remedy) {
  return {Severity::warning,
          folder,
          0,
          "TREELINE_CACHE",
          "compiled code is neither taken from this folder nor kept there: " + std::move(fault),
          std::move(remedy)};
}

/// The folder where code lies. Nobody else may own it or write to it.
std::optional<Diagnostic> distrust_place(const fs::path& folder, const struct stat& status) {
  if (status.st_uid != geteuid()) {
    return warn(folder,
                fmt::format("it belongs to the user of number {}, and this program runs for {}",
                            status.st_uid, geteuid()),
                "Name a folder of your own in TREELINE_CACHE, or set it to nothing; with sudo: "
                "`sudo -H`.");
  }
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) == 0) return std::nullopt;
  return warn(folder, "others may write to it",
              fmt::format("`chmod go-w '{}'`, after a look at what is in it.", folder.string()));
}

/// A folder above. Others may write to it only where they can replace nothing but what is theirs.
std::optional<Diagnostic> distrust_above(const fs::path& folder, const fs::path& above,
                                         const struct stat& status) {
  if (status.st_uid != 0 && status.st_uid != geteuid()) {
    return warn(folder,
                fmt::format("\"{}\" above it belongs to the user of number {}, and this program "
                            "runs for {}",
                            above.string(), status.st_uid, geteuid()),
                "Name a folder of your own in TREELINE_CACHE, or set it to nothing; with sudo: "
                "`sudo -H`.");
  }
  const bool sticky = (status.st_mode & S_ISVTX) != 0;
  const bool of_others = (status.st_mode & S_IWOTH) != 0 ||
                         ((status.st_mode & S_IWGRP) != 0 && status.st_gid != getegid());
  if (sticky || !of_others) return std::nullopt;
  return warn(folder,
              fmt::format("others may write to \"{}\" above it, and so replace it", above.string()),
              "Name a folder in TREELINE_CACHE that lies below your own alone.");
}

}  // namespace

std::optional<Diagnostic> reason_to_distrust(const fs::path& folder) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(folder, error);  // links lead where they lead
  if (error || place.empty()) return std::nullopt;             // nothing can be kept there
  struct stat status {};
  if (stat(place.c_str(), &status) == 0) {
    if (auto reason = distrust_place(place, status)) return reason;
  }
  for (fs::path above = place.parent_path();; above = above.parent_path()) {
    if (stat(above.c_str(), &status) == 0) {
      if (auto reason = distrust_above(place, above, status)) return reason;
    }
    if (above == above.parent_path()) return std::nullopt;
  }
}

}  // namespace treeline
