#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "drive/robot_library.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A robot's library that is loaded into this process.
class DrivenLibrary {
 public:
  /// Errors: those of the loader; a library of another version.
  static std::optional<DrivenLibrary> load(const std::filesystem::path& path,
                                           Diagnostics& diagnostics);

  /// Valid as long as this object lives.
  [[nodiscard]] const drive::RobotLibrary& functions() const { return *functions_; }

 private:
  struct Closer {
    void operator()(void* handle) const;
  };
  std::unique_ptr<void, Closer> handle_;
  const drive::RobotLibrary* functions_ = nullptr;
};

}  // namespace treeline
