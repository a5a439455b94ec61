// Judges the recorded motion of an experiment: nothing passes through anything.
#include <fmt/core.h>

#include "command_line/run_experiment.hpp"
#include "overlaps/find_overlaps.hpp"

namespace {

using namespace treeline;               // NOLINT: a program, not a header
using namespace treeline::experiments;  // NOLINT: a program, not a header

constexpr std::size_t kShown = 10;

Findings judge(const OverlapQuestion& question) {
  Diagnostics diagnostics;
  const auto overlaps = find_overlaps(question, diagnostics);
  if (!overlaps) {
    std::string errors;
    for (const Diagnostic& diagnostic : diagnostics.list()) errors += to_string(diagnostic) + "\n";
    return bad_input(errors);
  }
  Findings findings;
  for (std::size_t i = 0; i < overlaps->size() && i < kShown; ++i) {
    const Overlap& overlap = (*overlaps)[i];
    findings.summary += fmt::format("{:6.2f} mm  {} in {} at {:.3f} s\n", 1e3 * overlap.depth,
                                    overlap.first, overlap.second, overlap.time);
  }
  const double deepest = overlaps->empty() ? 0.0 : overlaps->front().depth;
  findings.summary +=
      fmt::format("deepest  {:.2f} mm (allowed {:.0f} mm)\n", 1e3 * deepest, 1e3 * kAllowedOverlap);
  findings.claims_hold = deepest <= kAllowedOverlap;
  return findings;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine command{
      "Bodies that pass through each other in a recorded motion: links by their <collision> "
      "shapes,\n"
      "objects in hands, obstacles, the ground. Exit status 3 if one is deeper than 1 mm in "
      "another."};
  OverlapQuestion question;
  std::string left_out;
  bool without_floor = false;
  bool not_itself = false;
  command.add_text("--robot", question.robot, "URDF; or a scene that lists robots");
  command.add_text("--scene", question.scene, "of the URDF");
  command.add_text("--motion", question.motion, "table of an experiment");
  command.add_text(
      "--leave-out", left_out,
      "file of pairs that may overlap, a line each: hand:wrist1, ends of links' names");
  command.add_flag("--no-floor", without_floor, "the ground is not there");
  command.add_flag("--not-itself", not_itself, "links may overlap each other");
  return run_experiment(command, argc, argv, [&] {
    question.left_out = read_left_out(left_out);
    if (!left_out.empty() && question.left_out.empty()) {
      return bad_input(left_out + ": has no pairs");
    }
    question.floor = !without_floor;
    question.itself = !not_itself;
    return judge(question);
  });
}
