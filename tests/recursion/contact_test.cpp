#include <gtest/gtest.h>

#include <iostream>

#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/least_flops.hpp"
#include "recursion/methods/contacts.hpp"
#include "recursion/methods/link_inverse_inertias.hpp"
#include "recursion/routes/trace_function.hpp"

// Every route of every function about contacts, compared with the interpreter in 50 digits for the
// robot as written in the files; and their cost, which must be proportional to the number of links.
// Would catch: a wrong formula, a link frame that is not updated when frames are placed again,
// impulses in the wrong axes, and work for links that the scene does not need.

namespace treeline::tests {
namespace {

struct Drawn {
  Robot robot;
  Scene scene;
  interpreter::Model<Digits50> model;
  interpreter::Points<Digits50> contacts;
};

/// A random robot with up to `count` contacts on moving links.
Drawn draw(std::uint64_t seed, const RandomOptions& options, int count) {
  RandomMechanism made = random_mechanism(seed, options);
  Drawn drawn{made.robot, made.scene, model_from_robot<Digits50>(made.robot, made.scene), {}};
  Rng rng(seed + 500);
  const auto q = random_position(rng, drawn.model);
  for (int i = 0; i < count; ++i) {
    RandomOptions anywhere = options;
    ScenePoint contact =
        detail::random_point(rng, anywhere, drawn.robot, "contact_" + std::to_string(i));
    contact.axes = Axes::world;
    contact.rows = {true, true, true, false, false, false};
    const auto point = points_from_scene(drawn.model, {contact});
    if (interpreter::jacobian<Digits50>(drawn.model, point, q).rowwise().norm().minCoeff() < 1e-9) {
      continue;
    }
    drawn.scene.contacts.push_back(contact);
  }
  drawn.contacts = points_from_scene(drawn.model, drawn.scene.contacts);
  return drawn;
}

/// Chains and trees, fixed and floating, with mimics and joints of several degrees of freedom.
std::vector<std::pair<std::uint64_t, RandomOptions>> contact_robots() {
  std::vector<std::pair<std::uint64_t, RandomOptions>> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.emplace_back(100 + all.size(), options);
  };
  add({.joints = 1}, 4);
  add({.joints = 7, .branching = 0}, 4);
  add({.joints = 8, .branching = 0.5}, 4);
  add({.joints = 8, .branching = 0.4, .floating_base = true}, 5);
  add({.joints = 8, .branching = 0.4, .mimic = 0.4, .locked = 0.1}, 4);
  add({.joints = 6, .branching = 0.3, .mimic = 0.2, .rotors = 0.7}, 3);
  add({.joints = 7, .branching = 0.3, .rotors = 0.7}, 3);
  add({.joints = 6, .branching = 0.3, .floating_base = true, .rotors = 0.7}, 3);
  add({.joints = 6, .branching = 0.2, .mix = {5, 1, 2, 1, 2, 2}}, 5);
  add({.joints = 6, .branching = 0.3, .mix = {3, 1, 2, 1, 1, 1, 5}}, 5);
  add({.joints = 5, .branching = 0.3, .mix = {3, 1, 2, 1, 0, 0, 5}, .floating_base = true}, 3);
  return all;
}

interpreter::Vector<Digits50> vector(const std::vector<double>& values) {
  interpreter::Vector<Digits50> x(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = values[static_cast<std::size_t>(i)];
  return x;
}

std::vector<double> doubles(const interpreter::Vector<Digits50>& x) {
  return rounded_to<double>(listed(x));
}

/// Draws the arguments of the function, as doubles.
std::vector<std::vector<double>> draw_arguments(const Drawn& drawn, Function function, Rng& rng) {
  std::vector<std::vector<double>> arguments{doubles(random_position(rng, drawn.model))};
  const int contacts = 3 * static_cast<int>(drawn.contacts.size());
  if (function == Function::contact_motion) {
    arguments.push_back(doubles(random_entries<Digits50>(rng, drawn.model.nv, 3)));
  } else if (function == Function::effective_mass || function == Function::impulse_response) {
    arguments.push_back(doubles(random_entries<Digits50>(rng, contacts, 1)));
  }
  return arguments;
}

/// Inverse inertias of all links that move relative to their parents, in the order of the links.
Results<Digits50> all_omegas(const Drawn& drawn, const interpreter::Vector<Digits50>& q) {
  const auto Omega = interpreter::link_inverse_inertias<Digits50>(drawn.model, q);
  Results<Digits50> results(1);
  for (int i = 0; i < drawn.model.size(); ++i) {
    if (drawn.model.body(i).kind == interpreter::JointKind::fixed) continue;
    const interpreter::Matrix<Digits50> block = Omega[i];
    for (const Digits50& x : listed(block)) results[0].push_back(x);
  }
  return results;
}

Results<Digits50> expected(const Drawn& drawn, Function function,
                           const std::vector<std::vector<double>>& arguments) {
  namespace ip = interpreter;
  const auto q = vector(arguments[0]);
  const auto other = vector(arguments.size() > 1 ? arguments[1] : std::vector<double>());
  switch (function) {
    case Function::contact_motion: {
      const auto motion = ip::contact_motion<Digits50>(drawn.model, drawn.contacts, q, other);
      return {listed(motion.position), listed(motion.velocity)};
    }
    case Function::contact_inverse_inertia:
      return {listed(ip::contact_inverse_inertia<Digits50>(drawn.model, drawn.contacts, q))};
    case Function::effective_mass:
      return {listed(ip::effective_masses<Digits50>(drawn.model, drawn.contacts, q, other))};
    case Function::impulse_response:
      return {listed(ip::impulse_response<Digits50>(drawn.model, drawn.contacts, q, other).dqd)};
    default:
      return all_omegas(drawn, q);
  }
}

/// Factor by which a solve may amplify rounding: the condition number of M, and for masses also
/// that of the directions.
double growth(const Drawn& drawn, Function function, const std::vector<double>& q) {
  if (function == Function::contact_motion) return 1;
  const auto M = interpreter::mass_matrix<Digits50>(drawn.model, vector(q));
  double result = condition(M);
  if (function == Function::effective_mass) {
    const auto A =
        interpreter::contact_inverse_inertia<Digits50>(drawn.model, drawn.contacts, vector(q));
    for (Eigen::Index i = 0; i < A.rows(); i += 3) {
      result = std::max(result, condition(A.block(i, i, 3, 3)));
    }
  }
  return result;
}

template <class Scalar>
Results<Scalar> run(const Program& program, const std::vector<std::vector<double>>& arguments) {
  std::vector<std::vector<Scalar>> given;
  for (const auto& argument : arguments) given.push_back(rounded_to<Scalar>(argument));
  return evaluate<Scalar>(program, given);
}

struct Tally {
  int compared = 0;
  double worst = 0;
};

/// Compares each route of `function` for each robot. Returns the largest error in double, in units
/// of 2^-52 times growth.
Tally compare_all(Function function) {
  Tally tally;
  for (const auto& [seed, options] : contact_robots()) {
    SCOPED_TRACE(described(seed, options));
    const Drawn drawn = draw(seed, options, 3);
    if (drawn.contacts.empty()) continue;
    Rng rng(seed);
    const auto arguments = draw_arguments(drawn, function, rng);
    const auto truth = expected(drawn, function, arguments);
    const double allowed = growth(drawn, function, arguments[0]);
    if (!(allowed < 1e9)) continue;
    for (const Program& program :
         trace_function(reduced_mechanism(drawn.robot, drawn.scene), function)) {
      const double ulp = relative_error(run<double>(program, arguments), truth, 0) * 0x1p52;
      EXPECT_LE(ulp, 64 * allowed) << describe(program.route);
      const double exact = relative_error(run<Digits50>(program, arguments), truth, 0) * 0x1p52;
      EXPECT_LE(exact, 64 * allowed) << describe(program.route);
      tally.worst = std::max(tally.worst, ulp / allowed);
      ++tally.compared;
    }
  }
  return tally;
}

TEST(ContactFunctions, AgreeWithTheInterpreter) {
  for (const Function function : kContactFunctions) {
    const Tally tally = compare_all(function);
    EXPECT_GE(tally.compared, 20) << function_name(function);
    std::cout << function_name(function) << ": " << tally.compared << " compared, worst error "
              << tally.worst << " ulp over the condition\n";
  }
}

/// The recursions in 50 digits with unrounded constants, so that only a formula can be wrong.
struct InFiftyDigits {
  Tree<Digits50> tree;
  std::vector<JointTransform<Digits50>> X;
  std::vector<WorldPose<Digits50>> poses;

  InFiftyDigits(const Drawn& drawn, const std::vector<Digits50>& q)
      : tree(tree_of<Digits50>(reduced_mechanism(drawn.robot, drawn.scene))),
        X(joint_transforms<Digits50>(tree, q)),
        poses(world_poses(tree, X)) {}
};

TEST(ContactFunctions, AgreeInFiftyDigitsWithUnroundedConstants) {
  for (const auto& [seed, options] : contact_robots()) {
    SCOPED_TRACE(described(seed, options));
    const Drawn drawn = draw(seed, options, 2);
    if (drawn.contacts.empty()) continue;
    Rng rng(seed + 1);
    const auto position = random_position(rng, drawn.model);
    const auto y = random_entries<Digits50>(rng, 3 * static_cast<int>(drawn.contacts.size()), 1);
    const InFiftyDigits run(drawn, listed(position));
    const auto impulses = listed(y);
    const Results<Digits50> dqd{listed(
        interpreter::impulse_response<Digits50>(drawn.model, drawn.contacts, position, y).dqd)};
    const auto on_links = impulses_on_links<Digits50>(run.tree, run.poses, impulses);
    const auto expect = [](const std::vector<Digits50>& actual, const Results<Digits50>& wanted) {
      EXPECT_LT(relative_error(Results<Digits50>{actual}, wanted, 0), 1e-36);
    };
    expect(impulse_response_by_factors(run.tree, run.X, on_links), dqd);
    const auto omegas = all_omegas(drawn, position);
    expect(link_inverse_inertias_by_factors(run.tree, run.X, run.poses), omegas);
    if (find_clusters(run.tree)) expect(impulse_response(run.tree, run.X, on_links), dqd);
    if (run.tree.has_mimics) continue;
    expect(link_inverse_inertias(run.tree, run.X), omegas);
  }
}

/// Hinges without a right angle among them and of equal cost, with one contact on the last link.
RandomMechanism hinged(int links, double branching, bool floating) {
  RandomOptions options;
  options.joints = links;
  options.branching = branching;
  options.mix = {1, 0, 0, 0, 0, 0};
  options.aligned = 0;
  options.floating_base = floating;
  RandomMechanism made = random_mechanism(11, options);
  ScenePoint contact;
  contact.name = "tip";
  contact.link = "link_" + std::to_string(links - 1);
  contact.origin.xyz = {0.1, 0.2, 0.3};
  contact.rows = {true, true, true, false, false, false};
  made.scene.contacts = {contact};
  return made;
}

std::vector<double> counts_over_links(Function function, double branching, bool floating) {
  std::vector<double> counts;
  std::cout << function_name(function) << (branching > 0 ? ", trees" : ", chains")
            << (floating ? ", floating" : "") << ':';
  for (const int links : {4, 8, 16, 32, 64}) {
    const RandomMechanism made = hinged(links, branching, floating);
    counts.push_back(least_flops(made.robot, made.scene, function));
    std::cout << ' ' << links << ": " << counts.back();
  }
  std::cout << '\n';
  return counts;
}

// O(n): along a chain each further link costs exactly the same.
TEST(ContactFunctions, CostInProportionToTheLinksOfAChain) {
  for (const Function function :
       {Function::link_inverse_inertias, Function::effective_mass, Function::impulse_response}) {
    for (const bool floating : {false, true}) {
      const auto counts = counts_over_links(function, 0, floating);
      const double a_link = (counts[4] - counts[3]) / 32;
      EXPECT_EQ((counts[3] - counts[2]) / 16, a_link) << function_name(function);
    }
  }
}

// Each link may be attached to any earlier one. The cost of a link depends a little on the number
// of its children.
TEST(ContactFunctions, CostInProportionToTheLinksOfATree) {
  const auto counts = counts_over_links(Function::link_inverse_inertias, 1, true);
  const double a_link = (counts[4] - counts[3]) / 32;
  EXPECT_NEAR((counts[3] - counts[2]) / 16, a_link, 0.1 * a_link);
}

// A second contact on another branch costs only its own path; on the same link it costs almost
// nothing.
TEST(ContactFunctions, CostForAContactOnlyItsOwn) {
  const RandomMechanism made = hinged(12, 0.5, true);
  Scene two = made.scene;
  two.contacts.push_back(two.contacts[0]);
  two.contacts[1].name = "beside";
  two.contacts[1].origin.xyz = {0, 0.1, 0.4};
  const int one = least_flops(made.robot, made.scene, Function::impulse_response);
  const int both = least_flops(made.robot, two, Function::impulse_response);
  EXPECT_GT(both, one);
  EXPECT_LT(both, one + 40);  // turned into the link, its moment, added
}

// Reports must distinguish the routes and state what each would have cost.
TEST(ContactFunctions, HaveSeveralRoutesWithNamesOfTheirOwn) {
  const RandomMechanism made = hinged(6, 0, false);
  const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
  EXPECT_EQ(trace_function(mechanism, Function::effective_mass).size(), 3U);
  EXPECT_EQ(trace_function(mechanism, Function::impulse_response).size(), 2U);
  EXPECT_GE(trace_function(mechanism, Function::contact_inverse_inertia).size(), 3U);
}

}  // namespace
}  // namespace treeline::tests
