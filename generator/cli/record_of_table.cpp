#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/record.hpp"
#include "description/read_surroundings.hpp"
#include "drawing/place_links.hpp"
#include "drawing/recorded_motion.hpp"
#include "drive/session.hpp"
#include "drive/wire.hpp"
#include "launch/describe_robot.hpp"
#include "mechanism/build_mechanism.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

bool has_ball_joint(const Robot& robot, const std::string& path, Diagnostics& diagnostics) {
  const auto ball = std::find_if(robot.joints.begin(), robot.joints.end(),
                                 [](const Joint& joint) { return joint.type == JointType::ball; });
  if (ball == robot.joints.end()) return false;
  diagnostics.add({Severity::error, path, 0, "",
                   "the page shows the ball joint `" + ball->name +
                       "` as three hinges, a table has "
                       "its quaternion",
                   "Show a record of `treeline drive`, or draw the table with `treeline draw`."});
  return true;
}

/// Describes a robot that nobody drives to front ends.
drive::RobotDescription describe(const RobotAndScene& inputs, const std::string& checksum) {
  auto description =
      describe_robot(inputs.robot, inputs.scene, {}, build_mechanism(inputs.robot, inputs.scene));
  description.checksum = checksum;
  description.obstacles =
      describe_obstacles(surroundings_of(inputs.files.scene_text, inputs.robot).obstacles);
  return description;
}

/// The report of a loop that is where the row says, as its goals are.
std::vector<double> report_of(const std::vector<double>& q, const LinkPlacer& placer,
                              const drive::ReportLayout& at) {
  std::vector<double> numbers(static_cast<std::size_t>(at.size), 0.0);
  const auto put = [&numbers](int first, const auto& values) {
    std::copy(values.begin(), values.end(), numbers.begin() + first);
  };
  put(at.q, q);
  put(at.goal, q);
  int point = 0;
  for (const Eigen::Isometry3d& pose : placer.place_points(q)) {
    const Eigen::Quaterniond turn(pose.rotation());
    const Eigen::Vector3d& p = pose.translation();
    const std::array<double, 7> numbers_of_pose = {p.x(),    p.y(),    p.z(),   turn.x(),
                                                   turn.y(), turn.z(), turn.w()};
    put(at.point_poses + 7 * point, numbers_of_pose);
    put(at.point_goals + 7 * point, numbers_of_pose);
    numbers[static_cast<std::size_t>(at.nearest + point)] = std::numeric_limits<double>::infinity();
    ++point;
  }
  return numbers;
}

/// The message without what a table does not say.
std::string print_row(const drive::Session& session, std::int64_t seq) {
  Json state = Json::parse(drive::print_state(session, seq, 0, drive::Detail::plain));
  state["mode"] = "replay";
  state["control"] = "";
  state["qd"] = Json::array();
  state["tau"] = Json::array();
  return json_line(state);
}

}  // namespace

std::optional<Record> record_of_table(const std::string& path, const RobotAndScene& inputs,
                                      const std::string& checksum, Diagnostics& diagnostics) {
  constexpr double kRate = 1000;      // Hz, of the loops that write tables
  constexpr double kInterval = 0.01;  // s, shorter than the page can show
  if (has_ball_joint(inputs.robot, path, diagnostics)) return std::nullopt;
  const LinkPlacer placer(inputs.robot, inputs.scene);
  const auto motion = read_motion(path, placer.joints(), placer.home(), diagnostics);
  if (!motion) return std::nullopt;
  drive::Session session(describe(inputs, checksum), kRate, false,
                         [](const servo::Message&) { return false; });
  Record record;
  record.hello = drive::print_hello(session, kRate, false, {});
  for (std::size_t row = 0; row < motion->times.size(); ++row) {
    const double time = motion->times[row];
    if (!record.times.empty() && time < record.times.back() + kInterval - 1e-9) continue;
    drive::ReportHead head;
    head.time = time;
    session.take_report(head, report_of(motion->q[row], placer, session.layout()).data());
    record.times.push_back(time);
    record.states.push_back(print_row(session, static_cast<std::int64_t>(row)));
  }
  return record;
}

}  // namespace treeline
