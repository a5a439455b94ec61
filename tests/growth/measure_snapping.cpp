#include "measure_snapping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "choice/function_mechanisms.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "generation/generate_code.hpp"

namespace treeline::growth {
namespace {

constexpr int kLeastPercent = 3;

std::vector<int> count_operations_of(const Robot& robot, const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(scene_text, "scene.yaml", robot, diagnostics);
  if (!scene) throw std::runtime_error("no scene for " + robot.name);
  FunctionMechanisms mechanisms(robot, *scene);
  std::vector<int> counts;
  for (const Function function :
       {Function::inverse_dynamics, Function::forward_dynamics, Function::mass_matrix}) {
    const GeneratedFunction generated =
        generate_function(mechanisms.of(function), function, route_options(*scene));
    counts.push_back(generated.chosen.count.flops());
  }
  return counts;
}

int percent_saved(const Snapping& snapping, std::size_t function) {
  const int written = snapping.written[function];
  if (written == 0) return 0;
  const double saved = written - snapping.snapped[function];
  return static_cast<int>(std::max(0.0, 100 * saved / written + 0.5));
}

}  // namespace

Snapping measure_snapping(const tests::DataRobot& from) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(from.path, diagnostics);
  if (!robot) throw std::runtime_error("cannot read " + from.path);
  return {from.name.substr(from.name.find('/') + 1), count_operations_of(*robot, "lanes: 1\n"),
          count_operations_of(*robot, "lanes: 1\nsnap_angles: 1e-5\n")};
}

bool has_row(const Snapping& snapping) {
  for (std::size_t i = 0; i < snapping.written.size(); ++i) {
    if (percent_saved(snapping, i) >= kLeastPercent) return true;
  }
  return false;
}

std::string print_row(const Snapping& snapping) {
  std::string text = fmt::format("| {} |", snapping.robot);
  for (std::size_t i = 0; i < snapping.written.size(); ++i) {
    text += fmt::format(" {} % |", percent_saved(snapping, i));
  }
  return text;
}

std::string print_snapping(const std::vector<Snapping>& all) {
  std::string text =
      "| `tests/data/published` | inverse dynamics | forward dynamics | M |\n|---|---|---|---|\n";
  std::size_t others = 0;
  for (const Snapping& snapping : all) {
    if (has_row(snapping)) text += print_row(snapping) + "\n";
    others += has_row(snapping) ? 0 : 1;
  }
  return text + fmt::format("| {} others | 0 to {} % | 0 to {} % | 0 to {} % |\n", others,
                            kLeastPercent - 1, kLeastPercent - 1, kLeastPercent - 1);
}

}  // namespace treeline::growth
