#include "launch/driven_library.hpp"

#include <dlfcn.h>

#include <string>

namespace treeline {

void DrivenLibrary::Closer::operator()(void* handle) const {
  dlclose(handle);
}

std::optional<DrivenLibrary> DrivenLibrary::load(const std::filesystem::path& path,
                                                 Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& fault) {
    diagnostics.add({Severity::error, path.filename(), 0, "", fault,
                     "Look whether $CXX compiles for this machine."});
    return std::nullopt;
  };
  DrivenLibrary library;
  library.handle_.reset(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!library.handle_) return refuse(std::string("cannot be loaded: ") + dlerror());
  void* const symbol = dlsym(library.handle_.get(), drive::kLibrarySymbol);
  if (symbol == nullptr) return refuse(std::string("has no symbol ") + drive::kLibrarySymbol);
  library.functions_ = reinterpret_cast<const drive::RobotLibrary* (*)()>(symbol)();
  if (library.functions_->version != drive::kLibraryVersion) {
    return refuse("is of another version than this program");
  }
  return library;
}

}  // namespace treeline
