#include "timing/call_arguments.hpp"

#include "check/fixture.hpp"
#include "oracle/reference.hpp"
#include "timing/load_build.hpp"

// Compiled functions find the numbers for timing where they expect them. Would catch: arrays of the
// wrong Real or shape, and a batch whose states are stored state by state.

namespace treeline::tests {
namespace {

/// planar3r with a few functions of one state and of eight.
Subjects small_subjects(Real real) {
  Subjects subjects = load("planar3r");
  subjects.scene.functions = {Function::jacobian, Function::inverse_dynamics};
  subjects.scene.real = real;
  subjects.scene.batch = 8;
  subjects.generation = generate(subjects.robot, subjects.scene);
  return subjects;
}

template <class T>
void expect_results(const Subjects& subjects) {
  const std::vector<GeneratedFunction> functions = all_functions(subjects.generation);
  const TemporaryFolder folder;
  write_folder(folder.path() / "code", subjects.generation);
  Diagnostics diagnostics;
  const auto build = load_build(folder.path() / "code", subjects.scene, functions,
                                {"-O0 -ffp-contract=off"}, folder.path() / "work", diagnostics);
  ASSERT_TRUE(build);
  const auto states = draw_timing_states(subjects.robot, subjects.scene,
                                         subjects.generation.mechanism, functions, 11);
  ASSERT_EQ(states.size(), 11U);
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const CallArguments arguments(functions[f], states, subjects.scene.real);
    ASSERT_EQ(arguments.calls(), states.size());
    const std::size_t batch = functions[f].batch > 0 ? 8 : 1;
    for (std::size_t call = 0; call < states.size(); ++call) {
      build->library.raw_entry(f)(arguments.in(call), arguments.out());
      const auto* const out = static_cast<const T*>(arguments.out()[0]);
      for (std::size_t k = 0; k < batch; ++k) {
        const auto expected = build->library.call(f, states[(call + k) % states.size()]).entries;
        for (std::size_t i = 0; i < expected.size(); ++i) {
          EXPECT_EQ(static_cast<double>(out[i * batch + k]), expected[i])
              << source_stem(functions[f]) << " call " << call << " state " << k << " entry " << i;
        }
      }
    }
  }
}

// Would catch: memory of another call that is flushed in place of this one's.
TEST(CallArguments, NameTheBytesOfACall) {
  const Subjects subjects = small_subjects(Real::float64);
  const GeneratedFunction& dynamics = subjects.generation.functions[1];
  const auto states = draw_timing_states(subjects.robot, subjects.scene,
                                         subjects.generation.mechanism, {dynamics}, 5);
  const CallArguments arguments(dynamics, states, Real::float64);
  for (const std::size_t call : {0U, 4U}) {
    const auto bytes = arguments.bytes_of(call);
    ASSERT_EQ(bytes.size(), dynamics.program.arguments.size() + 1);
    for (std::size_t a = 0; a + 1 < bytes.size(); ++a) {
      EXPECT_EQ(bytes[a].data(), arguments.in(call)[a]);
      EXPECT_GE(bytes[a].size(), 3 * sizeof(double));
    }
    EXPECT_EQ(bytes.back().data(), arguments.out()[0]);
  }
}

TEST(CallArguments, AreWhatDoubleTakes) {
  expect_results<double>(small_subjects(Real::float64));
}

TEST(CallArguments, AreWhatFloatTakes) {
  expect_results<float>(small_subjects(Real::float32));
}

}  // namespace
}  // namespace treeline::tests
