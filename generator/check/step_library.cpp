#include "check/step_library.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>

namespace treeline {
namespace {

using ListMembers = int (*)(int part, const char** names, int* counts);

template <class Entry>
Entry find_symbol(void* handle, const char* name) {
  return reinterpret_cast<Entry>(dlsym(handle, name));
}

std::vector<StepMember> list_members(ListMembers list, StepPart part) {
  constexpr std::size_t kMost = 128;
  std::array<const char*, kMost> names{};
  std::array<int, kMost> counts{};
  const int size = list(static_cast<int>(part), names.data(), counts.data());
  std::vector<StepMember> members;
  std::size_t at = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    const auto count = static_cast<std::size_t>(std::abs(counts[i]));
    members.push_back({names[i], at, count, counts[i] < 0});
    at += count;
  }
  return members;
}

}  // namespace

void StepLibrary::Closer::operator()(void* handle) const {
  dlclose(handle);
}

std::optional<StepLibrary> StepLibrary::load(const std::filesystem::path& path,
                                             Diagnostics& diagnostics) {
  StepLibrary library;
  library.handle_.reset(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  const auto list = library.handle_ ? find_symbol<ListMembers>(library.handle_.get(),
                                                               "treeline_check_step_members")
                                    : nullptr;
  if (list == nullptr) {
    diagnostics.add({Severity::error, path, 0, "", "has no entries of the controller's step",
                     "When the folder is an old one, generate it again."});
    return std::nullopt;
  }
  for (const StepPart part : kStepParts) {
    library.members_[static_cast<std::size_t>(part)] = list_members(list, part);
  }
  return library;
}

const StepMember* StepLibrary::find(StepPart part, const std::string& name) const {
  const auto& all = members(part);
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const StepMember& member) { return member.name == name; });
  return found == all.end() ? nullptr : &*found;
}

StepNumbers StepLibrary::zeros(StepPart part) const {
  const auto& all = members(part);
  return StepNumbers(all.empty() ? 0 : all.back().at + all.back().count);
}

StepNumbers StepLibrary::default_config() const {
  StepNumbers config = zeros(StepPart::config);
  find_symbol<void (*)(long double*)>(handle_.get(), "treeline_check_step_defaults")(config.data());
  return config;
}

void StepLibrary::step(const StepNumbers& config, StepNumbers& state, const StepNumbers& input,
                       StepNumbers& output) const {
  using Step = void (*)(const long double*, long double*, const long double*, long double*);
  find_symbol<Step>(handle_.get(), "treeline_check_step")(config.data(), state.data(), input.data(),
                                                          output.data());
}

void StepLibrary::connect(Compute compute, void* with) const {
  find_symbol<void (*)(Compute, void*)>(handle_.get(), "treeline_check_step_connect")(compute,
                                                                                      with);
}

}  // namespace treeline
