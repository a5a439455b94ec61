#include <map>

#include "fixture.hpp"
#include "mutate.hpp"

// Plants hundreds of single faults into the sources of a generated folder; the check must detect
// each. Would catch: states that leave parts of a function unused, an output that is not compared,
// a bound so wide that faults pass, and a library that is not made from the folder.

namespace treeline::tests {
namespace {

/// Number of faults of a kind, and how they were detected.
struct Seen {
  int made = 0, by_bound = 0, by_bits = 0, harmless = 0;
};

class Mutations {
 public:
  Mutations(Subjects subjects, std::uint64_t seed)
      : subjects_(std::move(subjects)), rng_(seed), options_(quick_options()) {
    options_.folder = folder_.path() / "generated";
    write_folder(options_.folder, subjects_.generation);
    references_ = references(options_);
  }

  /// Plants one fault into every function, `rounds` times.
  void run(int rounds) {
    expect_original_passes();
    for (int round = 0; round < rounds; ++round) {
      const Mutation mutation = kMutations[static_cast<std::size_t>(round) % kMutations.size()];
      const auto mutants = plant(mutation);
      const CheckReport report = check_folder(references_, options_);
      for (std::size_t i = 0; i < report.functions.size(); ++i) {
        const auto mutant = mutants.find(report.functions[i].name);
        if (mutant != mutants.end()) judge(report.functions[i], i, mutant->second);
      }
      EXPECT_EQ(report.stale.size(), mutants.size());
      restore(mutants);
    }
  }

  void expect_all_seen() const {
    for (const auto& [mutation, seen] : seen_) {
      std::cout << "  " << mutation_name(mutation) << ": " << seen.made << " faults, "
                << seen.by_bound << " seen by the bound, " << seen.by_bits << " by the bits, "
                << seen.harmless << " may be missed\n";
      EXPECT_GT(seen.made, 0);
      EXPECT_EQ(seen.by_bits + seen.harmless, seen.made);
      EXPECT_LE(seen.harmless, 1 + seen.made / 20) << "too many to believe";
      EXPECT_GE(20 * seen.by_bound, 17 * (seen.made - seen.harmless)) << "bounds are too wide";
    }
  }

 private:
  using Mutants = std::map<std::string, Mutant>;

  std::vector<StateReference> references(const CheckOptions& options) const {
    return make_references(subjects_.robot, subjects_.scene, subjects_.generation,
                           options.references);
  }

  CheckReport check_folder(const std::vector<StateReference>& references,
                           const CheckOptions& options) const {
    Diagnostics diagnostics;
    const auto report =
        check(subjects_.scene, subjects_.generation, references, options, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.list()) {
      ADD_FAILURE() << to_string(diagnostic);
    }
    if (!report) throw std::runtime_error("nothing checked");
    return *report;
  }

  void expect_original_passes() const {
    const CheckReport report = check_folder(references_, options_);
    EXPECT_TRUE(report.passed()) << print_text(report);
  }

  [[nodiscard]] std::filesystem::path source_of(const std::string& function) const {
    return options_.folder / (function + ".cpp");
  }

  Mutants plant(Mutation mutation) {
    Mutants planted;
    for (const GeneratedFunction& generated : subjects_.generation.functions) {
      const std::string& name = generated.program.name;
      originals_.try_emplace(name, read_file(source_of(name)));
      const auto mutants = mutants_of(originals_[name], mutation, rng_);
      if (mutants.empty()) continue;
      const auto chosen = static_cast<std::size_t>(rng_.below(static_cast<int>(mutants.size())));
      planted[name] = mutants[chosen];
      write_file(source_of(name), mutants[chosen].text);
    }
    return planted;
  }

  void restore(const Mutants& mutants) {
    for (const auto& [name, mutant] : mutants) write_file(source_of(name), originals_[name]);
  }

  void judge(const FunctionReport& report, std::size_t function, const Mutant& mutant) {
    Seen& seen = seen_[mutant.mutation];
    ++seen.made;
    seen.by_bound += report.beyond_bound > 0 ? 1 : 0;
    seen.by_bits += report.bits_differ > 0 ? 1 : 0;
    if (!report.passed()) return;
    ++seen.harmless;
    EXPECT_TRUE(may_be_missed(function)) << report.name << " passes with " << mutant.description;
  }

  /// Whether the folder in its present form differs from the graph's bits in fewer states than one
  /// of those that were checked, by twenty times as many others: such as one whose fault is in a
  /// constant that only counts next to a singular pose.
  bool may_be_missed(std::size_t function) {
    constexpr int kTimes = 20;
    CheckOptions more = options_;
    more.references.seed = 99;
    more.references.states *= kTimes;
    return check_folder(references(more), more).functions[function].bits_differ < kTimes;
  }

  Subjects subjects_;
  Rng rng_;
  CheckOptions options_;
  TemporaryFolder folder_;
  std::vector<StateReference> references_;
  std::map<std::string, std::string> originals_;
  std::map<Mutation, Seen> seen_;
};

TEST(Mutations, Puma560) {
  Mutations mutations(load("puma560"), 1);
  mutations.run(20);
  mutations.expect_all_seen();
}

TEST(Mutations, Planar3r) {
  Mutations mutations(load("planar3r"), 2);
  mutations.run(5);
  mutations.expect_all_seen();
}

// A floating base, mimic joints, a planar joint, external forces, a task of some rows.
TEST(Mutations, OddRobot) {
  RandomOptions options;
  options.floating_base = true;
  options.mimic = 0.3;
  options.mix.planar = 1;
  options.mix.floating = 0;
  options.all_rows = false;
  options.external_forces = 1;
  Subjects subjects = draw(11, options);
  Mutations mutations(std::move(subjects), 3);
  mutations.run(5);
  mutations.expect_all_seen();
}

}  // namespace
}  // namespace treeline::tests
