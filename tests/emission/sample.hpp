#pragma once

#include <limits>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "passes/passes.hpp"
#include "passes/two_link_arm.hpp"

namespace treeline::test {

/// A function with the emitter's special cases: results that are zero, constant, negative, equal,
/// an input, or a sine; an argument that is not read; names that are keywords or collide; a sine of
/// a sine; long expressions; quotients on either side.
inline Program trace_corner_cases() {
  Program program;
  program.name = "corner_cases";
  program.arguments = {{"q", 3, 1, "angles, rad"},
                       {"unread", 2, 1, "nothing"},
                       {"delta", 2, 1, "a length, m, and a mass, kg"}};
  const Graph::Scope scope(program.graph);
  const auto q = input_vector("q", 3);
  const auto delta = input_vector("delta", 2);
  const Expression product = q[0] * delta[1];
  program.graph.name(product, "double");
  program.graph.name(q[1] * delta[1], "Real");
  program.graph.name(q[2] * delta[1], "2nd angle__x");
  program.graph.name(q[2] * delta[0], "angles");
  program.graph.name(q[1] * delta[0], "out");
  program.graph.begin_section(SectionTitle{0, "", "sums"});
  Expression sum;
  for (int i = 0; i < 30; ++i) {
    sum += q[static_cast<std::size_t>(i % 3)] * (delta[0] + 0.1 * i);
  }
  program.graph.begin_section(SectionTitle{0, "", "quotients"});
  const Expression quotient = (product - 3) / (delta[0] * (q[1] / (q[2] - delta[1] / q[0])));
  const Expression nested = sin(sin(q[1]) * 0.7) + cos(q[1] - q[2]);
  program.results = {
      {{"out", 4, 3, "various"},
       {0, -2.5, -product, product, q[1], -q[2], -sin(q[0]), sum, -(sum - quotient), nested,
        q[1] * delta[1] + q[1] * delta[0], q[2] * delta[1] - q[2] * delta[0]}},
      {{"second", 1, 1, "a single value"}, {-(quotient / nested)}}};
  return program;
}

/// 2700 values, each of two before it: more than fit functions of bounded length, and more of these
/// than one may call. Angles that one call of sines and cosines does not take, at its end.
inline Program trace_long_chain() {
  Program program;
  program.name = "long_chain";
  program.arguments = {{"q", 20, 1, "angles, rad"}};
  const Graph::Scope scope(program.graph);
  const auto q = input_vector("q", 20);
  std::vector<Expression> chain = {q[0], q[1]};
  for (int i = 0; i < 2700; ++i) {
    const double factor = 0.5 + 1e-5 * (i * 37 % 201 - 100);  // neither grows nor fades
    chain.push_back(chain[chain.size() - 2] * 0.5 - chain.back() * factor);
  }
  Expression turned = chain.back();
  for (const Expression& angle : q) turned += sin(angle) * chain[900] + cos(angle);
  program.results = {{{"out", 3, 1, "various"}, {turned, chain[1300] + chain[40], -chain.back()}}};
  return program;
}

inline constexpr int kSampleBatch = 4;  ///< states a call of the batch functions

/// Programs of the sample folders.
inline std::vector<Program> sample_programs() {
  std::vector<PassReport> log;
  return {put_in_order(reduce_operations(trace_two_link_arm(), log), log),
          put_in_order(reduce_operations(trace_corner_cases(), log), log)};
}

/// Programs of the sample folders in the profile of rules for safe code.
inline std::vector<Program> safe_programs() {
  std::vector<Program> programs = sample_programs();
  programs.push_back(trace_long_chain());
  for (Program& program : programs) program.packs.clear();
  return programs;
}

inline EmissionContext sample_context(const std::string& name, bool single_precision,
                                      Language language = Language::cpp) {
  EmissionContext context;
  context.language = language;
  context.name = name;
  context.robot = "Two links \"2R\"";
  context.command = "treeline generate arm.urdf arm.yaml --output " + name;
  context.single_precision = single_precision;
  context.coordinates = 2;
  context.velocities = 2;
  context.task_rows = 2;
  context.base = "fixed";
  context.gravity = {0, -9.81, 0};
  context.inputs = {{"arm.urdf", "<robot/>\n"}, {"arm.yaml", "base: fixed\n"}};
  context.joints = {{"shoulder", "revolute", 0, 1, 0, 1, "-3.1 .. 3.1 rad, 80 Nm, 3 rad/s"},
                    {"elbow", "continuous", 1, 1, 1, 1, ""}};
  constexpr double kNone = std::numeric_limits<double>::infinity();
  context.coordinate_rows = {{"shoulder", "angle, rad", -3.1, 3.1, 0},
                             {"elbow \\ \"2\"", "angle, rad", -kNone, kNone, 0.25}};
  context.velocity_rows = {{"shoulder", "shoulder, rad/s", 3, 80},
                           {"elbow", "elbow, rad/s", kNone, kNone}};
  context.operational_points = {{"tool", "forearm", "origin (0.4, 0, 0) m, world axes", "x y", 0}};
  EmissionContext::ChoiceRow choice;
  choice.function = "inverse_dynamics";
  choice.chosen = {"textbook", "by the textbook", 40, 47.2};
  choice.rejected.push_back({"recursion", "by recursion", 55, 62.9});
  context.choices.push_back(choice);
  context.notes = {"Locked: gripper at 0.02 m."};
  return context;
}

}  // namespace treeline::test
