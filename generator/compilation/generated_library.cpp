#include "compilation/generated_library.hpp"

#include <dlfcn.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "compilation/print_entry.hpp"
#include "oracle/reference.hpp"

namespace treeline {
namespace {

/// Number of guard entries on each side of an array.
constexpr std::size_t kMargin = 16;

/// An array between margins of NaN.
template <class T>
class Fenced {
 public:
  explicit Fenced(std::size_t size)
      : all_(size + 2 * kMargin, std::numeric_limits<T>::quiet_NaN()), size_(size) {}

  [[nodiscard]] T* data() { return all_.data() + kMargin; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Whether the margins are unchanged. Compares bytes, so that a different NaN counts as a change.
  [[nodiscard]] bool fence_stands() const {
    const T untouched = std::numeric_limits<T>::quiet_NaN();
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const bool own = i >= kMargin && i < kMargin + size_;
      if (!own && std::memcmp(&all_[i], &untouched, sizeof(T)) != 0) return false;
    }
    return true;
  }

 private:
  std::vector<T> all_;
  std::size_t size_;
};

void report(const std::filesystem::path& path, const std::string& fault, Diagnostics& diagnostics) {
  diagnostics.add(
      {Severity::error, path, 0, "", fault, "When the folder is an old one, generate it again."});
}

}  // namespace

void GeneratedLibrary::Closer::operator()(void* handle) const {
  dlclose(handle);
}

std::optional<GeneratedLibrary> GeneratedLibrary::load(
    const std::filesystem::path& path, const std::vector<GeneratedFunction>& functions, Real real,
    Diagnostics& diagnostics) {
  GeneratedLibrary library;
  library.real_ = real;
  library.handle_.reset(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!library.handle_) {
    report(path, std::string("cannot be loaded: ") + dlerror(), diagnostics);
    return std::nullopt;
  }
  void* const bytes = dlsym(library.handle_.get(), "treeline_check_bytes_of_real");
  const int expected = real == Real::float32 ? sizeof(float) : sizeof(double);
  if (bytes == nullptr || reinterpret_cast<int (*)()>(bytes)() != expected) {
    report(path, "computes with another Real than the scene asks for", diagnostics);
    return std::nullopt;
  }
  void* const faults = dlsym(library.handle_.get(), "treeline_check_fault");
  const char* const fault = faults ? reinterpret_cast<const char* (*)()>(faults)() : nullptr;
  if (fault != nullptr) {
    report(path, fault, diagnostics);
    return std::nullopt;
  }
  for (const GeneratedFunction& generated : functions) {
    LoadedFunction function{generated.program, nullptr, nullptr};
    for (const auto& [symbol, entry] :
         {std::pair{entry_symbol(source_stem(generated)), &function.entry},
          std::pair{raw_entry_symbol(generated), &function.raw}}) {
      *entry = reinterpret_cast<CompiledEntry>(dlsym(library.handle_.get(), symbol.c_str()));
      if (*entry != nullptr) continue;
      report(path, "has no symbol " + symbol, diagnostics);
      return std::nullopt;
    }
    library.functions_.push_back(std::move(function));
  }
  return library;
}

CallResult GeneratedLibrary::call(std::size_t i, const State& state) const {
  std::vector<std::size_t> sizes;
  for (const Result& result : functions_[i].program.results) sizes.push_back(result.values.size());
  return call_entry(functions_[i].entry, i, state, sizes);
}

CallResult GeneratedLibrary::call_entry(CompiledEntry entry, std::size_t i, const State& state,
                                        const std::vector<std::size_t>& sizes) const {
  const Program& program = functions_[i].program;
  return real_ == Real::float32 ? call_in<float>(entry, program, state, sizes)
                                : call_in<double>(entry, program, state, sizes);
}

CompiledEntry GeneratedLibrary::find_entry(const std::string& name) const {
  return reinterpret_cast<CompiledEntry>(dlsym(handle_.get(), entry_symbol(name).c_str()));
}

int GeneratedLibrary::run_selftest() const {
  using Selftest = int (*)();
  const auto selftest =
      reinterpret_cast<Selftest>(dlsym(handle_.get(), entry_symbol("selftest").c_str()));
  return selftest == nullptr ? -1 : selftest();
}

template <class T>
CallResult GeneratedLibrary::call_in(CompiledEntry entry, const Program& program,
                                     const State& state,
                                     const std::vector<std::size_t>& sizes) const {
  std::vector<Fenced<T>> inputs;
  std::vector<Fenced<T>> outputs;
  for (const auto* argument : arguments_of(program, state)) {
    Fenced<T>& input = inputs.emplace_back(argument->size());
    for (std::size_t k = 0; k < argument->size(); ++k) {
      input.data()[k] = static_cast<T>((*argument)[k]);
    }
  }
  for (const std::size_t size : sizes) outputs.emplace_back(size);
  std::vector<const void*> in;
  std::vector<void*> out;
  for (auto& input : inputs) in.push_back(input.data());
  for (auto& output : outputs) out.push_back(output.data());
  entry(in.data(), out.data());
  CallResult result;
  for (auto& output : outputs) {
    result.entries.insert(result.entries.end(), output.data(), output.data() + output.size());
    result.wrote_out_of_bounds = result.wrote_out_of_bounds || !output.fence_stands();
  }
  return result;
}

}  // namespace treeline
