#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "timing/time_cold_calls.hpp"

#if defined(__x86_64__) && defined(__linux__)
#include <immintrin.h>
#include <link.h>
#define TREELINE_CAN_FLUSH
#endif

namespace treeline {
namespace {

constexpr std::size_t kLine = 64;

#if defined(__x86_64__) || defined(__aarch64__)
// 8192 lines of code with one jump each.
__attribute__((noinline)) void run_foreign_code() {
#if defined(__x86_64__)
  asm volatile(".rept 8192\n jmp 1f\n .balign 64\n 1:\n .endr\n" ::: "memory");
#else
  asm volatile(".rept 8192\n b 1f\n .balign 64\n 1:\n .endr\n" ::: "memory");
#endif
}
#else
void run_foreign_code() {}
#endif

std::vector<std::uint64_t>& foreign_data() {
  static std::vector<std::uint64_t> data = [] {
    long level2 = 0;
#ifdef _SC_LEVEL2_CACHE_SIZE
    level2 = sysconf(_SC_LEVEL2_CACHE_SIZE);
#endif
    const auto bytes = static_cast<std::size_t>(level2 > 0 ? level2 : 2 << 20) * 4;
    return std::vector<std::uint64_t>(bytes / sizeof(std::uint64_t), 1);
  }();
  return data;
}

#ifdef TREELINE_CAN_FLUSH
void flush(const void* begin, std::size_t bytes) {
  const auto* at = static_cast<const char*>(begin);
  for (std::size_t i = 0; i < bytes + kLine; i += kLine) _mm_clflush(at + i);
}

struct Segment {
  const void* begin;
  std::size_t bytes;
};

/// Segments collected from the objects that are loaded.
struct Collection {
  std::span<const std::string> objects;
  std::vector<Segment> segments;

  [[nodiscard]] bool wants(const std::string& name) const {
    return std::any_of(objects.begin(), objects.end(), [&](const std::string& part) {
      return part.empty() ? name.empty() : name.find(part) != std::string::npos;
    });
  }
};

/// Code and constants are the segments that are loaded readable and never written.
int collect(dl_phdr_info* info, std::size_t, void* collection) {
  auto& found = *static_cast<Collection*>(collection);
  const bool wanted = found.wants(info->dlpi_name);
  for (int i = 0; wanted && i < info->dlpi_phnum; ++i) {
    const auto& header = info->dlpi_phdr[i];
    if (header.p_type == PT_LOAD && (header.p_flags & PF_R) != 0 && (header.p_flags & PF_W) == 0) {
      const auto address = static_cast<std::uintptr_t>(info->dlpi_addr + header.p_vaddr);
      found.segments.push_back({reinterpret_cast<const void*>(address), header.p_memsz});
    }
  }
  return 0;
}

std::vector<Segment> code_and_constants(std::span<const std::string> objects) {
  Collection collection{objects, {}};
  dl_iterate_phdr(collect, &collection);
  return std::move(collection.segments);
}
#endif

}  // namespace

void evict_from_core() {
  auto& data = foreign_data();
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < data.size(); i += kLine / sizeof(std::uint64_t)) data[i] += 1;
  }
  run_foreign_code();
}

#ifdef TREELINE_CAN_FLUSH
bool evict_from_caches(std::span<const std::span<const std::byte>> data,
                       std::span<const std::string> objects) {
  const std::vector<Segment> segments = code_and_constants(objects);
  evict_from_core();
  for (const auto& segment : segments) {
    // The last line may extend beyond the segment, so stop before its end.
    const std::size_t bytes = segment.bytes > 2 * kLine ? segment.bytes - 2 * kLine : 0;
    flush(segment.begin, bytes);
  }
  for (const auto& each : data) flush(each.data(), each.size_bytes());
  _mm_mfence();
  return true;
}
#else
bool evict_from_caches(std::span<const std::span<const std::byte>>, std::span<const std::string>) {
  evict_from_core();
  return false;
}
#endif

}  // namespace treeline
