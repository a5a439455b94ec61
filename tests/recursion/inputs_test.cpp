// Would catch: a payload or inertial parameters that are taken about another origin, in other axes
// or with the other sign of products; parameters that the file's are added to; a payload that
// regrouping or a link's frame misplaces; gravity or a tool that some recursion does not see; a
// quaternion that is read in another order, the other way round or as if it had unit length. The
// oracle is the interpreter on another file: with the payload as a link, the parameters in place,
// and the scene's gravity, origin and angles changed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>

#include "description/rotation.hpp"
#include "description/scene_queries.hpp"
#include "mechanism/build_mechanism.hpp"
#include "program/evaluate.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/function_results.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"
#include "recursion/template_results.hpp"

namespace treeline::tests {
namespace {

namespace ip = interpreter;

/// A robot as functions with arguments see it, and as files would describe it.
struct Changed {
  Robot robot, files_robot;
  Scene scene, files_scene;
  std::vector<std::array<Digits50, 10>> payloads, parameters;
  std::vector<std::array<Digits50, 3>> tools;
  std::vector<std::array<Digits50, 4>> orientations;
};

/// By the definitions: m, m c, and J about the frame's origin by parallel axes.
std::array<Digits50, 10> ten_parameters(const Inertial& inertial) {
  const auto R = rotation_from_rpy<Digits50>(inertial.origin.rpy);
  ip::Matrix3<Digits50> J;
  J << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,   //
      inertial.ixz, inertial.iyz, inertial.izz;
  const auto& xyz = inertial.origin.xyz;
  const ip::Vector3<Digits50> c{Digits50(xyz[0]), Digits50(xyz[1]), Digits50(xyz[2])};
  const Digits50 m(inertial.mass);
  const ip::Matrix3<Digits50> unit = ip::Matrix3<Digits50>::Identity();
  J = (R * J * R.transpose() + m * (c.dot(c) * unit - c * c.transpose())).eval();
  return {m, m * c(0), m * c(1), m * c(2), J(0, 0), J(0, 1), J(1, 1), J(0, 2), J(1, 2), J(2, 2)};
}

std::vector<std::string> moving_links(const Robot& robot, const Scene& scene) {
  std::vector<std::string> links;
  for (const Link& link : robot.links) {
    if (!find_freedoms_of_link(robot, scene, link.name).empty()) links.push_back(link.name);
  }
  return links;
}

int index_of(const Robot& robot, const std::string& name) {
  int i = 0;
  while (robot.links[static_cast<std::size_t>(i)].name != name) ++i;
  return i;
}

void add_payload(Rng& rng, const std::string& link, Changed& changed) {
  const Inertial body = detail::random_inertial(rng, 0.3);
  changed.scene.inputs.payloads.push_back({link});
  changed.payloads.push_back(ten_parameters(body));
  Robot& robot = changed.files_robot;
  Joint joint;
  joint.name = "to_payload_of_" + link;
  joint.type = JointType::fixed;
  joint.parent = index_of(robot, link);
  joint.child = static_cast<int>(robot.links.size());
  robot.links.push_back({"payload_of_" + link, body, 0});
  robot.joints.push_back(joint);
}

void change_parameters(Rng& rng, const std::string& link, Changed& changed) {
  const Inertial body = detail::random_inertial(rng, 0.3);
  changed.scene.inputs.parameters.push_back({link});
  changed.parameters.push_back(ten_parameters(body));
  Robot& robot = changed.files_robot;
  robot.links[static_cast<std::size_t>(index_of(robot, link))].inertial = body;
}

/// x, y, z, w of a rotation by the product of those about z, y and x, times a length.
std::array<Digits50, 4> quaternion(const std::array<double, 3>& rpy, const Digits50& length) {
  const auto turn = [&](int i) {
    ip::Vector3<Digits50> axis = ip::Vector3<Digits50>::Zero();
    axis(i) = 1;
    const Digits50 half = Digits50(rpy[static_cast<std::size_t>(i)]) / 2;
    const ip::Vector3<Digits50> v = axis * Digits50(sin(half));
    return Eigen::Quaternion<Digits50>(Digits50(cos(half)), v(0), v(1), v(2));
  };
  const Eigen::Quaternion<Digits50> turned = turn(2) * turn(1) * turn(0);
  return {length * turned.x(), length * turned.y(), length * turned.z(), length * turned.w()};
}

void change_tool(Rng& rng, std::size_t k, bool orientation, Changed& changed) {
  const auto xyz = detail::random_vector(rng, 0.4);
  ScenePoint& files_point = changed.files_scene.operational_points[k];
  changed.scene.inputs.tools.push_back({files_point.name, 1, orientation});
  changed.tools.push_back({Digits50(xyz[0]), Digits50(xyz[1]), Digits50(xyz[2])});
  files_point.origin.xyz = xyz;
  if (!orientation) return;
  files_point.origin.rpy = detail::random_vector(rng, 3);
  changed.orientations.push_back(
      quaternion(files_point.origin.rpy, Digits50(rng.uniform(0.25, 4))));
}

/// Two payloads, the parameters of up to two links (one of which may carry a payload), gravity, and
/// the first point.
Changed change(const Seeded& seeded) {
  const RandomMechanism made = random_mechanism(seeded.seed, seeded.options);
  Changed changed{made.robot, made.robot, made.scene, made.scene, {}, {}, {}, {}};
  Rng rng(seeded.seed + 5);
  const std::vector<std::string> links = moving_links(made.robot, made.scene);
  const auto draw = [&] {
    return links[static_cast<std::size_t>(rng.below(static_cast<int>(links.size())))];
  };
  const std::string first = draw(), second = draw();
  add_payload(rng, first, changed);
  if (second != first) add_payload(rng, second, changed);
  const std::string third = draw();
  change_parameters(rng, third, changed);
  if (first != third) change_parameters(rng, first, changed);
  changed.scene.inputs.gravity = true;
  changed.files_scene.gravity = detail::random_vector(rng, 10);
  for (std::size_t k = 0; k < made.scene.operational_points.size(); k += 2) {
    change_tool(rng, k, (k + seeded.seed) % 3 != 0, changed);
  }
  return changed;
}

template <std::size_t size>
std::vector<Digits50> joined(const std::vector<std::array<Digits50, size>>& bodies) {
  std::vector<Digits50> entries;
  for (const auto& body : bodies) entries.insert(entries.end(), body.begin(), body.end());
  return entries;
}

std::vector<Digits50> gravity_of(const Changed& changed) {
  const auto& g = changed.files_scene.gravity;
  return {Digits50(g[0]), Digits50(g[1]), Digits50(g[2])};
}

ModelInputs<Digits50> model_inputs(const Changed& changed) {
  ModelInputs<Digits50> inputs;
  inputs.gravity = triple_at(gravity_of(changed), 0);
  inputs.payloads = inertial_parameters(joined(changed.payloads));
  inputs.parameters = inertial_parameters(joined(changed.parameters));
  inputs.tools = triples(joined(changed.tools));
  inputs.orientations = rotations(joined(changed.orientations));
  return inputs;
}

std::vector<Seeded> inputs_robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.push_back({3100 + all.size(), options});
  };
  add({.joints = 2, .branching = 0, .mix = {1, 0, 0, 0, 0, 0}}, 2);
  add({.joints = 6, .branching = 0, .mix = {1, 0, 0, 0, 0, 0}}, 5);
  add({.joints = 7, .branching = 0.4, .locked = 0.2, .operational_points = 2}, 5);
  add({.joints = 6, .branching = 0.4, .floating_base = true}, 4);
  add({.joints = 7, .branching = 0.4, .mimic = 0.4, .massless = 0.5}, 4);
  add({.joints = 4, .branching = 0.3, .mix = {2, 0, 1, 1, 0.5, 0.5, 4}, .floating_base = true}, 4);
  return all;
}

constexpr std::array kOthers = {Function::coriolis_matrix, Function::kinetic_energy,
                                Function::potential_energy};

class ModelArguments : public testing::TestWithParam<Seeded> {
 protected:
  ModelArguments()
      : changed_(change(GetParam())),
        mechanism_(reduced_mechanism(changed_.robot, changed_.scene)),
        oracle_(changed_.files_robot, changed_.files_scene) {
    Rng rng(GetParam().seed + 9);
    in_ = oracle_.random_inputs(rng);
    size_ = yardstick(oracle_, in_);
  }

  [[nodiscard]] std::vector<Function> functions() const {
    std::vector<Function> wanted(kDefaultFunctions.begin(), kDefaultFunctions.end());
    wanted.insert(wanted.end(), kOthers.begin(), kOthers.end());
    std::erase_if(wanted, [&](Function f) { return !permits(f, oracle_.has_points(), size_); });
    return wanted;
  }

  Changed changed_;
  Mechanism mechanism_;
  Oracle<Digits50> oracle_;
  Inputs<Digits50> in_;
  Yardstick size_;
};

INSTANTIATE_TEST_SUITE_P(Robots, ModelArguments, testing::ValuesIn(inputs_robots()));

// Only a formula can be wrong.
TEST_P(ModelArguments, AreWhatFilesWouldSay) {
  const TemplateRun<Digits50> run(mechanism_, in_, model_inputs(changed_));
  for (const Function function : functions()) {
    const Results<Digits50> expected = oracle_.results(function, in_);
    for (const auto& [route, results] : run.results(function)) {
      const double error = relative_error(results, expected, size_.least_scale(function));
      EXPECT_LT(error, 1e-38 * size_.growth(function)) << function_name(function) << " " << route;
    }
  }
  const ip::Vector<Digits50> q =
      Eigen::Map<const ip::Vector<Digits50>>(in_.q.data(), static_cast<Eigen::Index>(in_.q.size()));
  const auto center = ip::center_of_mass<Digits50>(oracle_.model(), q);
  const auto own = run.center();
  EXPECT_LT(relative_error(Results<Digits50>{{own.x, own.y, own.z}},
                           Results<Digits50>{listed(center)}, 1),
            1e-40);
}

// What the files say is what they say without arguments.
TEST_P(ModelArguments, DefaultToTheFiles) {
  const Oracle<Digits50> oracle(changed_.robot, changed_.scene);
  const TemplateRun<Digits50> run(mechanism_, in_);
  for (const Function function : {Function::inverse_dynamics, Function::mass_matrix}) {
    const Results<Digits50> expected = oracle.results(function, in_);
    for (const auto& [route, results] : run.results(function)) {
      EXPECT_LT(relative_error(results, expected, size_.least_scale(function)), 1e-40)
          << function_name(function) << " " << route;
    }
  }
}

// Traces declare the arguments and use them. Their constants are rounded to double.
TEST_P(ModelArguments, AreArgumentsOfTraces) {
  for (const Function function : functions()) {
    const Results<Digits50> expected = oracle_.results(function, in_);
    for (const Program& program : trace_function(mechanism_, function)) {
      std::vector<std::vector<Digits50>> arguments;
      for (const Argument& argument : program.arguments) {
        const std::string& name = argument.name;
        arguments.push_back(name == "q"                        ? in_.q
                            : name == "qd"                     ? in_.qd
                            : name == "qdd" || name == "qdd_0" ? in_.qdd
                            : name == "tau"                    ? in_.tau
                            : name == "xdd_cmd"                ? in_.xdd_cmd
                            : name == "gravity"                ? gravity_of(changed_)
                            : name == "payload"                ? joined(changed_.payloads)
                            : name == "parameters"             ? joined(changed_.parameters)
                            : name == "tool"                   ? joined(changed_.tools)
                            : name == "tool_orientation"       ? joined(changed_.orientations)
                                                               : in_.f_ext);
        EXPECT_EQ(static_cast<int>(arguments.back().size()), argument.rows) << name;
        const auto quantity = find_quantity(name);
        EXPECT_TRUE(quantity && takes(function, *quantity)) << name;
      }
      const double error = relative_error(evaluate<Digits50>(program, arguments), expected,
                                          size_.least_scale(function));
      EXPECT_LT(error, kUlpBound * 0x1p-52 * size_.growth(function))
          << function_name(function) << " by " << describe(program.route);
    }
  }
}

}  // namespace
}  // namespace treeline::tests
