#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace treeline::drive {

/// Who may fetch meshes: each front end is told a pass of its own. With one that came with the
/// token a mesh may be fetched again and again, with one of a watcher once. For several threads.
class MeshPasses {
 public:
  explicit MeshPasses(std::size_t meshes) : meshes_(meshes) {}

  void issue(const std::string& pass, bool may_command) {
    const std::lock_guard lock(mutex_);
    passes_[pass] = {may_command, std::vector<bool>(meshes_)};
  }
  void withdraw(const std::string& pass) {
    const std::lock_guard lock(mutex_);
    passes_.erase(pass);
  }

  enum class Answer { refused, once, always };
  /// Whether mesh `number` may be fetched with this pass, now.
  Answer ask(std::string_view pass, std::size_t number) {
    const std::lock_guard lock(mutex_);
    const auto found = passes_.find(pass);
    if (found == passes_.end()) return Answer::refused;
    if (found->second.may_command) return Answer::always;
    if (found->second.given.at(number)) return Answer::refused;
    found->second.given[number] = true;
    return Answer::once;
  }

 private:
  struct Pass {
    bool may_command = false;
    std::vector<bool> given;
  };
  std::size_t meshes_;
  std::mutex mutex_;
  std::map<std::string, Pass, std::less<>> passes_;
};

}  // namespace treeline::drive
