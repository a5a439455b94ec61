#include "check/step_library.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>

#include "check/judges.hpp"
#include "compilation/compile_folder.hpp"

namespace treeline {
namespace {

template <class Entry>
void find_symbol(void* handle, const char* name, Entry& entry) {
  entry = reinterpret_cast<Entry>(dlsym(handle, name));
}

template <class ListMembers>
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
  Entries& entries = library.entries_;
  if (void* const handle = library.handle_.get(); handle != nullptr) {
    find_symbol(handle, "treeline_check_step_members", entries.list);
    find_symbol(handle, "treeline_check_step_defaults", entries.write_defaults);
    find_symbol(handle, "treeline_check_step", entries.step);
    find_symbol(handle, "treeline_check_step_connect", entries.connect);
  }
  if (entries.list == nullptr || entries.write_defaults == nullptr || entries.step == nullptr) {
    diagnostics.add({Severity::error, path, 0, "", "has no entries of the controller's step",
                     "When the folder is an old one, generate it again."});
    return std::nullopt;
  }
  for (const StepPart part : kStepParts) {
    library.members_[static_cast<std::size_t>(part)] = list_members(entries.list, part);
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
  entries_.write_defaults(config.data());
  return config;
}

void StepLibrary::step(const StepNumbers& config, StepNumbers& state, const StepNumbers& input,
                       StepNumbers& output) const {
  entries_.step(config.data(), state.data(), input.data(), output.data());
}

void StepLibrary::connect(Compute compute, void* with) const {
  entries_.connect(compute, with);
}

std::optional<StepLibrary> compile_step(const Scene& scene, const Generation& generation, int jobs,
                                        const std::filesystem::path& sources,
                                        const std::filesystem::path& work,
                                        Diagnostics& diagnostics) {
  const std::filesystem::path place = work / "host";
  std::filesystem::create_directory(place);
  CompileOptions compile = with_controller(scene, generation, CompileOptions());
  compile.jobs = jobs;
  compile.language = scene.language;
  const auto compiled = compile_folder(sources, scene.name, {}, compile, place, diagnostics);
  if (!compiled) return std::nullopt;
  return StepLibrary::load(compiled->library, diagnostics);
}

}  // namespace treeline
