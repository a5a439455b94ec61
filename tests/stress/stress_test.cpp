// Every stress experiment in its quick form: its claims hold. Would catch: an algorithm that loses
// more than the condition number of the problem explains, for robots and states that random tests
// do not draw. The long form is `stress`.
#include <gtest/gtest.h>

#include <ostream>

#include "experiments.hpp"

namespace treeline::stress {

/// Gives the test the name that ctest prints.
void PrintTo(const Experiment& experiment, std::ostream* out) {
  *out << experiment.name;
}

namespace {

std::vector<Experiment> all_experiments() {
  std::vector<Experiment> all = sweep_experiments();
  for (const auto& more : {table_experiments(), motion_experiments(), loop_experiments()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

class Stress : public testing::TestWithParam<Experiment> {};
INSTANTIATE_TEST_SUITE_P(All, Stress, testing::ValuesIn(all_experiments()),
                         [](const auto& of) { return of.param.name; });

TEST_P(Stress, ClaimsHold) {
  const Finding finding = GetParam().run({true, TREELINE_ROBOTS_DIR});
  EXPECT_FALSE(finding.x.empty());
  for (const std::string& broken : finding.broken) ADD_FAILURE() << broken;
}

}  // namespace
}  // namespace treeline::stress
