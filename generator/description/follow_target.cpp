#include "description/follow_target.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "target/target.hpp"

namespace treeline {
namespace {

const Target& target_of(const Scene& scene) {
  const Target* const target = find_target(scene.target);
  if (target == nullptr) throw std::logic_error("no target " + scene.target);
  return *target;
}

void warn(const Scene& scene, const std::string& element, std::string fault, std::string remedy,
          Diagnostics& diagnostics) {
  diagnostics.add({Severity::warning, scene.file, 0, element, std::move(fault), std::move(remedy)});
}

}  // namespace

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (const Target& target : all_targets()) names.emplace_back(target.name);
  return names;
}

int bytes_of(Real real) {
  return real == Real::float32 ? 4 : 8;
}

void follow_target(Scene& scene) {
  if (scene.asks_for_lanes) return;
  const bool is_scalar = scene.profile == Profile::misra || scene.language == Language::opencl;
  scene.lanes = is_scalar ? 1 : choose_lanes(target_of(scene), bytes_of(scene.real));
}

void warn_of_target(const Scene& scene, Diagnostics& diagnostics) {
  const Target& target = target_of(scene);
  const int bytes = bytes_of(scene.real);
  if (emulates(target, bytes)) {
    const bool can_single = !emulates(target, bytes_of(Real::float32));
    warn(scene, "real",
         fmt::format(
             "{} has no instructions for {}: a library emulates each operation, in 12 to 110 "
             "times the instructions and in a time that depends on the numbers",
             target.name, bytes == 4 ? "float" : "double"),
         can_single ? "write real: float, which it computes with instructions"
                    : "see what a call takes with treeline check --target, or take another target",
         diagnostics);
  }
  const int most = choose_lanes(target, bytes);
  if (is_particular(target) && scene.lanes > most) {
    warn(scene, "lanes",
         fmt::format("{} lanes are asked for, but the registers of {} hold {}", scene.lanes,
                     target.name, most),
         "leave out lanes: they follow the target", diagnostics);
  }
}

}  // namespace treeline
