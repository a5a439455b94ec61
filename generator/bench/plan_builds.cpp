#include "bench/plan_builds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "bench/templates.hpp"
#include "choice/function_mechanisms.hpp"
#include "description/scene_words.hpp"
#include "emission/backend.hpp"
#include "emission/emitted_text.hpp"
#include "generation/describe_scene.hpp"
#include "generation/without_callers.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

constexpr std::array kLanes = {8, 4, 1};
constexpr int kStatesOfBatch = 8;

constexpr std::array kGroups = {"emitted", "language",    "batch",    "lanes",       "real",
                                "route",   "inertia",     "accuracy", "contraction", "sines",
                                "solve",   "interpreter", "peer"};

/// Difference of a build from the scene's code.
struct Difference {
  VariantGroup group{};
  std::string name;
  Real real{};
  bool library_sines = false;
  bool contracted = true;
  Language language = Language::cpp;
  int batch = 0;  ///< states of a call; 0: a function of one state
};

class Planner {
 public:
  Planner(const Robot& robot, const Scene& scene, std::string flags,
          std::vector<VariantGroup> groups, Diagnostics& diagnostics)
      : robot_(robot),
        scene_(without_callers(scene)),
        flags_(std::move(flags)),
        groups_(std::move(groups)),
        diagnostics_(diagnostics) {
    scene_.batch = 0;
  }

  VariantBuild plan_first() {
    generate_emitted();
    add_emitted();
    return std::move(builds_.front());
  }

  std::vector<VariantBuild> plan() {
    generate_emitted();
    add_emitted();
    if (wants(VariantGroup::language)) {
      add(emitted_, {VariantGroup::language, "C99", scene_.real, false, true, Language::c});
    }
    if (wants(VariantGroup::batch)) add_batch();
    if (wants(VariantGroup::lanes) || wants(VariantGroup::real)) add_lanes();
    if (wants(VariantGroup::route)) add_routes();
    if (wants(VariantGroup::inertia)) {
      add_generated({VariantGroup::inertia, "full inertias", scene_.real}, scene_, Inertias::full);
    }
    if (wants(VariantGroup::accuracy)) add_accuracies();
    if (wants(VariantGroup::sines)) add_sines();
    if (wants(VariantGroup::contraction)) {
      add(emitted_, {VariantGroup::contraction, "not contracted", scene_.real, false, false});
    }
    std::erase_if(builds_, [](const VariantBuild& build) { return build.variants.empty(); });
    return std::move(builds_);
  }

 private:
  using Functions = std::vector<GeneratedFunction>;

  [[nodiscard]] bool wants(VariantGroup group) const { return is_wanted(group, groups_); }

  [[nodiscard]] std::string lanes_name(Real real, int lanes) const {
    return fmt::format("{}, {} lane{}", word_of(real), lanes, lanes == 1 ? "" : "s");
  }

  void generate_emitted() {
    FunctionMechanisms mechanisms(robot_, scene_);
    for (const Function function : scene_.functions) {
      routes_.push_back(generate_routes(mechanisms.of(function), function, route_options(scene_)));
      emitted_.push_back(routes_.back().front());
    }
  }

  static Functions generate(const Robot& robot, const Scene& scene, Inertias inertias) {
    Functions functions;
    FunctionMechanisms mechanisms(robot, scene, inertias);
    for (const Function function : scene.functions) {
      functions.push_back(
          generate_function(mechanisms.of(function), function, route_options(scene)));
    }
    return functions;
  }

  void add_emitted() {
    add(emitted_, {VariantGroup::emitted, lanes_name(scene_.real, scene_.lanes), scene_.real});
  }

  void add_batch() {
    Functions functions;
    FunctionMechanisms mechanisms(robot_, scene_);
    for (const Function function : scene_.functions) {
      functions.push_back(
          generate_function(mechanisms.of(function), function, route_options(scene_, true)));
      functions.back().batch = kStatesOfBatch;
    }
    add(functions, {VariantGroup::batch, fmt::format("{} states a call", kStatesOfBatch),
                    scene_.real, false, true, Language::cpp, kStatesOfBatch});
  }

  void add_lanes() {
    const Real other = scene_.real == Real::float64 ? Real::float32 : Real::float64;
    add(emitted_, {VariantGroup::real, lanes_name(other, scene_.lanes), other});
    for (const int lanes : kLanes) {
      if (lanes == scene_.lanes) continue;
      Scene scene = scene_;
      scene.lanes = lanes;
      const Functions functions = generate(robot_, scene, Inertias::regrouped);
      add(functions, {VariantGroup::lanes, lanes_name(scene_.real, lanes), scene_.real});
      add(functions, {VariantGroup::real, lanes_name(other, lanes), other});
    }
  }

  /// Adds a build with the second routes of all functions, one with the third routes, and so on.
  void add_routes() {
    std::size_t most = 0;
    for (const Functions& each : routes_) most = std::max(most, each.size());
    for (std::size_t k = 1; k < most; ++k) {
      Functions functions;
      for (const Functions& each : routes_) {
        if (k < each.size()) functions.push_back(each[k]);
      }
      add(functions, {VariantGroup::route, "route: ", scene_.real});
    }
  }

  void add_accuracies() {
    for (const Accuracy accuracy : {Accuracy::best, Accuracy::balanced, Accuracy::fastest}) {
      if (accuracy == scene_.accuracy) continue;
      Scene scene = scene_;
      scene.accuracy = accuracy;
      add_generated(
          {VariantGroup::accuracy, fmt::format("accuracy: {}", word_of(accuracy)), scene_.real},
          scene, Inertias::regrouped);
    }
  }

  void add_sines() {
    Scene scene = scene_;
    const bool given = scene_.sin_cos == Sines::given;
    scene.sin_cos = given ? Sines::computed : Sines::given;
    add_generated({VariantGroup::sines, given ? "sines computed" : "sines given", scene_.real},
                  scene, Inertias::regrouped);
    if (!given) {
      add(emitted_, {VariantGroup::sines, "sines of the C library", scene_.real, true});
    }
  }

  void add_generated(const Difference& difference, const Scene& scene, Inertias inertias) {
    add(generate(robot_, scene, inertias), difference);
  }

  void add(const Functions& functions, const Difference& difference) {
    if (functions.empty()) return;
    VariantBuild build;
    build.scene = scene_;
    build.scene.real = difference.real;
    build.scene.language = difference.language;
    build.scene.batch = difference.batch;
    build.flags = flags_ + (difference.contracted ? "" : " -ffp-contract=off");
    std::vector<Program> programs;
    for (const GeneratedFunction& each : functions) programs.push_back(each.program);
    const EmissionContext context =
        describe_scene(robot_, build.scene, reduced_mechanism(robot_, scene_));
    build.files = emit(context, programs, diagnostics_,
                       difference.batch > 0 ? programs : std::vector<Program>{});
    if (difference.library_sines) take_library_sines(build.files);
    for (const GeneratedFunction& each : functions) {
      Variant variant = variant_of(each, difference);
      variant.flags = build.flags;
      if (is_repeat(variant, source_stem(each), build)) continue;
      build.variants.push_back(std::move(variant));
      build.functions.push_back(each);
    }
    builds_.push_back(std::move(build));
  }

  /// Whether the function takes sines as inputs although the scene's code computes them.
  [[nodiscard]] bool spares_sines(const Program& program) const {
    return scene_.sin_cos == Sines::computed &&
           std::any_of(program.arguments.begin(), program.arguments.end(),
                       [](const Argument& argument) {
                         return argument.name == symbol_of(Quantity::sin_q);
                       });
  }

  [[nodiscard]] Variant variant_of(const GeneratedFunction& generated,
                                   const Difference& difference) const {
    Variant variant{generated.function, difference.group, difference.name, difference.real};
    variant.method = describe(generated.chosen.route);
    variant.flops = generated.chosen.count.flops();
    variant.states = std::max(generated.batch, 1);
    variant.whole = generated.batch == 0 && !spares_sines(generated.program);
    if (difference.group == VariantGroup::route) {
      variant.name += generated.chosen.route.algorithm_words;
    }
    return variant;
  }

  void take_library_sines(std::vector<GeneratedFile>& files) const {
    for (GeneratedFile& file : files) {
      if (file.name != "sin_cos.hpp") continue;
      file.text = fill_template(bench_templates::kLibrarySines, {{"name", scene_.name}});
    }
  }

  static std::string text_of(const VariantBuild& build, const std::string& name) {
    for (const GeneratedFile& file : build.files) {
      if (file.name == name) return file.text;
    }
    return {};
  }

  /// Whether an earlier variant has the same code and flags. If so, it is noted there.
  bool is_repeat(const Variant& variant, const std::string& stem, const VariantBuild& build) {
    const std::string source = text_of(build, source_name(build.scene.language, stem));
    const bool sines = source.find("sin_cos.hpp") != std::string::npos;
    const Key key{variant.real, build.flags, source, sines ? text_of(build, "sin_cos.hpp") : ""};
    const auto [at, is_new] = first_.emplace(key, std::pair{builds_.size(), build.variants.size()});
    if (is_new) return false;
    const auto [earlier, i] = at->second;
    if (earlier < builds_.size()) {
      builds_[earlier].variants[i].repeats.push_back(variant.name);
    }
    return true;
  }

  using Key = std::tuple<Real, std::string, std::string, std::string>;

  const Robot& robot_;
  Scene scene_;
  std::string flags_;
  std::vector<VariantGroup> groups_;  ///< that are planned; empty: all
  Diagnostics& diagnostics_;
  std::vector<Functions> routes_;  ///< by function, the emitted route first
  Functions emitted_;
  std::vector<VariantBuild> builds_;
  std::map<Key, std::pair<std::size_t, std::size_t>> first_;  ///< build and variant
};

}  // namespace

const char* group_name(VariantGroup group) {
  return kGroups[static_cast<std::size_t>(group)];
}

std::optional<VariantGroup> find_group(std::string_view name) {
  const auto at = std::find(kGroups.begin(), kGroups.end(), name);
  if (at == kGroups.end()) return std::nullopt;
  return static_cast<VariantGroup>(at - kGroups.begin());
}

std::vector<std::string> group_names() {
  return {kGroups.begin(), kGroups.end()};
}

bool is_wanted(VariantGroup group, const std::vector<VariantGroup>& groups) {
  return groups.empty() || std::find(groups.begin(), groups.end(), group) != groups.end();
}

std::optional<std::vector<VariantBuild>> plan_builds(const Robot& robot, const Scene& scene,
                                                     const std::string& flags,
                                                     const std::vector<VariantGroup>& groups,
                                                     Diagnostics& diagnostics) {
  auto builds = Planner(robot, scene, flags, groups, diagnostics).plan();
  if (diagnostics.has_errors()) return std::nullopt;
  return builds;
}

std::optional<VariantBuild> plan_emitted(const Robot& robot, const Scene& scene,
                                         const std::string& flags, Diagnostics& diagnostics) {
  auto build = Planner(robot, scene, flags, {}, diagnostics).plan_first();
  if (diagnostics.has_errors()) return std::nullopt;
  return build;
}

}  // namespace treeline
