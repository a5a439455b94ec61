#pragma once

#include <dlfcn.h>

#include <filesystem>

namespace treeline::tests {

/// Whether this machine has what tests with OpenCL need: the headers, the loader and a driver.
inline bool has_opencl() {
  if (!std::filesystem::exists("/usr/include/CL/cl.h")) return false;
  void* const loader = dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (loader == nullptr) return false;
  using ListPlatforms = int (*)(unsigned entries, void** platforms, unsigned* count);
  const auto list = reinterpret_cast<ListPlatforms>(dlsym(loader, "clGetPlatformIDs"));
  unsigned count = 0;
  return list != nullptr && list(0, nullptr, &count) == 0 && count > 0;
}

}  // namespace treeline::tests
