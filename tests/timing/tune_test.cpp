#include "timing/tune.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "check/fixture.hpp"

// The choice by measured cost, with times given by the test. Would catch: a tuner that picks the
// wrong candidate, gives up the default because of noise, forgets a batch, takes the operations of
// a routine for lines, or whose choices do not lead to the measured code.

namespace treeline::tests {
namespace {

using Rule = std::function<Timing(const GeneratedFunction& candidate, std::size_t i)>;

Measure measure_by(const Rule& rule) {
  return [rule](const std::vector<GeneratedFunction>& candidates, Diagnostics&) {
    std::vector<Timing> measured;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      measured.push_back(rule(candidates[i], i));
    }
    return std::optional(measured);
  };
}

/// puma560 with functions that have several routes, also in batches.
Subjects puma() {
  Subjects subjects = load("puma560");
  subjects.scene.functions = {Function::forward_dynamics, Function::lambda_inverse};
  subjects.scene.batch = 8;
  return subjects;
}

/// Includes routes far from the least cost, so that the tests do not depend on the costs.
TuneOptions far_reaching() {
  TuneOptions options;
  options.reach = 1;
  return options;
}

Tuning tune_by(const Subjects& subjects, const Rule& rule,
               const TuneOptions& options = far_reaching()) {
  Diagnostics diagnostics;
  auto tuning = tune(subjects.robot, subjects.scene, measure_by(rule), options, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  return std::move(*tuning);
}

TEST(Tune, TakesTheLeastTime) {
  const Tuning tuning = tune_by(puma(), [](const GeneratedFunction& candidate, std::size_t) {
    const double ratio = candidate.chosen.route.algorithm == "aba" ? 0.5 : 1.0;
    return Timing{100 * ratio, ratio, 0.001};
  });
  ASSERT_EQ(tuning.functions.size(), 4U);
  for (const std::size_t i : {0U, 1U}) {
    const TunedFunction& tuned = tuning.functions[i];
    EXPECT_EQ(tuned.function, Function::forward_dynamics);
    EXPECT_EQ(tuned.batch, i == 1 ? 8 : 0);
    EXPECT_NE(tuned.fastest, 0U);
    EXPECT_EQ(tuned.trials[tuned.fastest].choice.route, "aba");
  }
  const Choices choices = choices_of(tuning);
  EXPECT_EQ(choices.plain.at(Function::forward_dynamics).route, "aba");
  EXPECT_GT(choices.plain.at(Function::forward_dynamics).lanes, 0);
  EXPECT_EQ(choices.batch.at(Function::forward_dynamics).lanes, 0);
  EXPECT_EQ(tuning.functions[2].fastest, 0U);
}

TEST(Tune, KeepsTheDefaultWithinNoise) {
  const auto all_at = [](double ratio, double noise) {
    return tune_by(puma(), [=](const GeneratedFunction&, std::size_t i) {
      return i == 0 ? Timing{100, 1, 0} : Timing{100 * ratio, ratio, noise};
    });
  };
  for (const TunedFunction& tuned : all_at(0.985, 0.001).functions) EXPECT_EQ(tuned.fastest, 0U);
  for (const TunedFunction& tuned : all_at(0.95, 0.03).functions) EXPECT_EQ(tuned.fastest, 0U);
  for (const TunedFunction& tuned : all_at(0.95, 0.01).functions) EXPECT_EQ(tuned.fastest, 1U);
}

TEST(Tune, DefaultIsFirst) {
  Subjects subjects = load("samm");
  subjects.scene.functions = {Function::inverse_dynamics, Function::lambda_inverse};
  const Generation& generation = subjects.generation;
  TuneOptions options;
  options.reach = 0.2;
  tune_by(
      subjects,
      [&](const GeneratedFunction& candidate, std::size_t i) {
        if (i == 0) {
          const auto made = std::find_if(
              generation.functions.begin(), generation.functions.end(),
              [&](const GeneratedFunction& each) { return each.function == candidate.function; });
          EXPECT_EQ(key_of(candidate.chosen.route), key_of(made->chosen.route));
          EXPECT_EQ(candidate.other_lanes, subjects.scene.lanes);
        }
        return Timing{};
      },
      options);
}

// The folder generated with the choices has exactly the code that was measured.
TEST(Tune, ChoicesLeadToTheCodeMeasured) {
  const Subjects subjects = puma();
  std::map<std::string, std::string> last;
  const Tuning tuning = tune_by(subjects, [&](const GeneratedFunction& candidate, std::size_t i) {
    Diagnostics diagnostics;
    const auto mechanism = subjects.generation.mechanism;
    for (const GeneratedFile& file :
         emit_to_try(subjects.robot, subjects.scene, mechanism, candidate, diagnostics)) {
      if (file.name == source_stem(candidate) + ".cpp") last[file.name] = file.text;
    }
    const double ratio = 1.0 / static_cast<double>(i + 1);  // the last one wins
    return Timing{100 * ratio, ratio, 0};
  });
  Diagnostics diagnostics;
  const auto made =
      generate_code(subjects.robot, subjects.scene, {}, diagnostics, choices_of(tuning));
  ASSERT_TRUE(made);
  EXPECT_EQ(last.size(), 4U);
  for (const GeneratedFile& file : made->files) {
    if (last.contains(file.name)) {
      EXPECT_EQ(file.text, last[file.name]);
    }
  }
}

// What ends in a routine is measured as it is emitted: as lines and a call.
TEST(Tune, MeasuresRoutinesAsTheyAreEmitted) {
  Subjects subjects = load_unmade("humanoid24", "scene.yaml");
  subjects.scene.functions = {Function::forward_dynamics_derivatives};
  int called = 0;
  tune_by(subjects, [&](const GeneratedFunction& candidate, std::size_t) {
    called += candidate.program.ending ? 1 : 0;
    return Timing{};
  });
  EXPECT_GE(called, 1);
}

TEST(Tune, SizeIsNotForTime) {
  Subjects subjects = puma();
  subjects.scene.optimize = Optimize::size;
  Diagnostics diagnostics;
  EXPECT_FALSE(tune(subjects.robot, subjects.scene, measure_by({}), {}, diagnostics));
  ASSERT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.list().front().element, "optimize");
}

TEST(Tune, CompilerThatFailsIsTold) {
  const Subjects subjects = puma();
  Diagnostics diagnostics;
  EXPECT_FALSE(tune(subjects.robot, subjects.scene,
                    measure_here(subjects.robot, subjects.scene, {"-fno-such-flag-at-all"}), {},
                    diagnostics));
  ASSERT_TRUE(diagnostics.has_errors());
  EXPECT_NE(to_string(diagnostics.list().front()).find("no-such-flag-at-all"), std::string::npos);
}

// Compiles and runs, whatever the times are: each trial has one.
TEST(Tune, MeasuresHere) {
  Subjects subjects = puma();
  subjects.scene.functions = {Function::forward_dynamics};
  Diagnostics diagnostics;
  const auto tuning = tune(subjects.robot, subjects.scene,
                           measure_here(subjects.robot, subjects.scene, {"-O0"}), {}, diagnostics);
  ASSERT_TRUE(tuning);
  ASSERT_EQ(tuning->functions.size(), 2U);
  for (const TunedFunction& tuned : tuning->functions) {
    EXPECT_EQ(tuned.trials.front().measured.ratio, 1);
    for (const Trial& trial : tuned.trials) EXPECT_GT(trial.measured.nanoseconds, 0);
  }
}

TEST(Tune, PrintsFastestFirst) {
  Tuning tuning{{{Function::gravity,
                  0,
                  {{{"slow", 8}, {}, {20, 1, 0}}, {{"fast", 1}, {}, {10, 0.5, 0.01}}},
                  1}},
                "a compiler"};
  const std::string text = print_text(tuning);
  EXPECT_LT(text.find("fast <- chosen"), text.find("slow <- least cost")) << text;
  const auto json = to_json(tuning);
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0].at("route"), "fast");
  EXPECT_EQ(json[0].at("nanoseconds"), 10);
  EXPECT_TRUE(json[0].at("chosen"));
  EXPECT_TRUE(json[1].at("least_cost"));
}

}  // namespace
}  // namespace treeline::tests
