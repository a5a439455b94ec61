#pragma once
// Drives robots without a page, as scripts do, in a folder of its own.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "program_test.hpp"

namespace treeline {

using nlohmann::json;
using test::Outcome;

inline const std::string kRobots = TREELINE_ROBOTS;

/// The state at the end of a drive, and the interpreter's poses of the scene's points there.
struct Arrival {
  json state;
  std::vector<interpreter::PointPose<double>> poses;
};

class DriveTest : public test::OwnFolder {
 protected:
  [[nodiscard]] Outcome drive(const std::string& files, const std::string& script,
                              const std::string& options = "") const {
    write("script.txt", script);
    return test::run_program(root_,
                             "drive " + files + " --headless --script script.txt " + options);
  }

  [[nodiscard]] Outcome run_drive(const std::string& options) const {
    return test::run_program(root_, "drive " + kRobots + "/planar3r/planar3r.urdf " + options);
  }

  /// Drives a robot and finds where its points are, by the interpreter and the final coordinates.
  [[nodiscard]] Arrival arrive(const std::string& urdf, const std::string& scene,
                               const std::string& script) const {
    const Outcome outcome = drive(urdf + " " + scene, script);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json state = json::parse(outcome.out);
    return {state, poses_at(urdf, scene, state)};
  }

  /// Where the scene's points are at the coordinates of `state`, by the interpreter.
  [[nodiscard]] static std::vector<interpreter::PointPose<double>> poses_at(
      const std::string& urdf, const std::string& scene, const json& state) {
    Diagnostics diagnostics;
    const auto robot = read_urdf(urdf, diagnostics);
    const auto read = read_scene(scene, *robot, diagnostics);
    const auto model = model_from_robot<double>(*robot, *read);
    const auto q = state["q"].get<std::vector<double>>();
    return interpreter::forward_kinematics<double>(
        model, points_from_scene(model, read->operational_points),
        interpreter::Vector<double>::Map(q.data(), static_cast<Eigen::Index>(q.size())));
  }
};

}  // namespace treeline
