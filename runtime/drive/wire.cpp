#include "drive/wire.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "servo/state_machine.hpp"

namespace treeline::drive {
namespace {

using Json = nlohmann::ordered_json;

std::string print(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A member that is a whole number within what a double holds exactly.
std::optional<std::int64_t> whole(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_number_integer()) return std::nullopt;
  constexpr std::int64_t kLargest = std::int64_t{1} << 53;
  if (found->is_number_unsigned() &&
      found->get<std::uint64_t>() > static_cast<std::uint64_t>(kLargest)) {
    return std::nullopt;
  }
  const auto value = found->get<std::int64_t>();
  if (value < 0 || value > kLargest) return std::nullopt;
  return value;
}

std::optional<std::string> text(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

/// Depth and size are bounded before: the text is short, and deeper nesting than a message has is
/// refused here.
Json parse_shallow(std::string_view message) {
  bool deep = false;
  const auto watch = [&deep](int depth, Json::parse_event_t, Json&) {
    deep = deep || depth > 2;
    return !deep;
  };
  Json json = Json::parse(message.begin(), message.end(), watch, false);
  return deep ? Json(Json::value_t::discarded) : json;
}

Json limit(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json slice(const std::vector<double>& numbers, int first, int count) {
  return Json(std::vector<double>(numbers.begin() + first, numbers.begin() + first + count));
}

const char* measure_name(Measure measure) {
  constexpr const char* kNames[] = {"angle", "length",   "x",        "y",
                                    "z",     "qx",       "qy",       "qz",
                                    "qw",    "planar_x", "planar_y", "planar_theta"};
  return kNames[static_cast<std::size_t>(measure)];
}

Json describe_coordinates(const RobotDescription& robot) {
  Json list = Json::array();
  for (const DrivenCoordinate& coordinate : robot.coordinates) {
    const bool quaternion = coordinate.measure >= Measure::qx && coordinate.measure <= Measure::qw;
    list.push_back({{"name", coordinate.name},
                    {"joint", coordinate.joint},
                    {"kind", measure_name(coordinate.measure)},
                    {"unit", quaternion             ? ""
                             : is_angle(coordinate) ? "rad"
                                                    : "m"},
                    {"lower", limit(coordinate.lower)},
                    {"upper", limit(coordinate.upper)},
                    {"velocity", limit(coordinate.velocity)},
                    {"effort", limit(coordinate.effort)},
                    {"passive", coordinate.passive}});
  }
  return list;
}

Json describe_points(const RobotDescription& robot) {
  Json list = Json::array();
  for (const DrivenPoint& point : robot.points) {
    Json origin = Json::array();
    for (const double x : point.position) origin.push_back(x);
    for (const double x : point.rotation) origin.push_back(x);
    list.push_back({{"name", point.name},
                    {"link", point.link},
                    {"origin", origin},
                    {"rows", point.rows},
                    {"axes", point.local_axes ? "local" : "world"}});
  }
  return list;
}

Json describe_obstacles(const RobotDescription& robot) {
  Json list = Json::array();
  for (const DrivenObstacle& obstacle : robot.obstacles) {
    const Obstacle& shape = obstacle.shape;
    const bool is_sphere = shape.radius > 0.0;
    list.push_back({{"name", obstacle.name},
                    {"kind", is_sphere ? "sphere" : "box"},
                    {"at", Json(shape.center)},
                    {"turn", Json(obstacle.rotation)},
                    {"radius", is_sphere ? Json(shape.radius) : Json(nullptr)},
                    {"size", is_sphere ? Json(nullptr)
                                       : Json({2.0 * shape.half[0], 2.0 * shape.half[1],
                                               2.0 * shape.half[2]})},
                    {"avoided", shape.avoided}});
  }
  return list;
}

Json describe_durations(const Durations& durations) {
  return {{"mean", durations.mean}, {"p99", durations.p99}, {"max", durations.max}};
}

Json describe_histograms(const LoopTiming& timing) {
  return {{"width_us", kHistogramWidth},
          {"period_from_us", timing.first_period()},
          {"period", timing.period_histogram()},
          {"jitter", timing.jitter_histogram()},
          {"control", timing.control_histogram()}};
}

Json point_states(const Session& session) {
  const ReportLayout& layout = session.layout();
  const std::vector<double>& numbers = session.report().numbers;
  Json list = Json::array();
  for (int k = 0; k < static_cast<int>(session.robot().points.size()); ++k) {
    list.push_back({{"at", slice(numbers, layout.point_poses + 7 * k, 3)},
                    {"turn", slice(numbers, layout.point_poses + 7 * k + 3, 4)},
                    {"goal", slice(numbers, layout.point_goals + 7 * k, 3)},
                    {"goal_turn", slice(numbers, layout.point_goals + 7 * k + 3, 4)},
                    {"free", numbers[static_cast<std::size_t>(layout.free + k)] != 0.0},
                    {"force", slice(numbers, layout.contact_forces + 3 * k, 3)},
                    {"nearest", limit(numbers[static_cast<std::size_t>(layout.nearest + k)])}});
  }
  return list;
}

/// Forces on the robot: of obstacles on its points, of the ground, and of a hand that pulls.
Json forces(const Session& session) {
  const ReportHead& head = session.report().head;
  const ReportLayout& layout = session.layout();
  const std::vector<double>& numbers = session.report().numbers;
  Json list = Json::array();
  for (int k = 0; k < static_cast<int>(session.robot().points.size()); ++k) {
    const auto first = numbers.begin() + layout.contact_forces + 3 * k;
    if (std::all_of(first, first + 3, [](double f) { return f == 0.0; })) continue;
    list.push_back({{"of", "obstacle"},
                    {"link", session.robot().points[static_cast<std::size_t>(k)].link},
                    {"at", slice(numbers, layout.point_poses + 7 * k, 3)},
                    {"force", slice(numbers, layout.contact_forces + 3 * k, 3)}});
  }
  for (const Touch& touch :
       std::span(head.touches.list).first(static_cast<std::size_t>(head.touches.count))) {
    list.push_back({{"of", "ground"}, {"at", Json(touch.at)}, {"force", Json(touch.force)}});
  }
  if (!head.pulled) return list;
  list.push_back({{"of", "hand"},
                  {"link", session.robot().links[static_cast<std::size_t>(head.pulled_link)]},
                  {"at", slice(numbers, layout.pull_at, 3)},
                  {"force", slice(numbers, layout.pull_force, 3)}});
  return list;
}

Json shown_numbers(const Shown& shown) {
  Json numbers = Json::object();
  for (const NamedNumber& number :
       std::span(shown.numbers).first(static_cast<std::size_t>(shown.count))) {
    const auto end = std::find(std::begin(number.name), std::end(number.name), '\0');
    numbers[std::string(std::begin(number.name), end)] = limit(number.value);
  }
  return numbers;
}

Json describe_twin(const Session* twin) {
  if (twin == nullptr) return nullptr;
  const int nq = static_cast<int>(twin->robot().coordinates.size());
  return {{"q", slice(twin->report().numbers, twin->layout().q, nq)},
          {"moving", twin->report().head.moving},
          {"fault", twin->fault()}};
}

Json describe_meshes(const std::vector<ServedMesh>& meshes, const std::string& query,
                     bool may_command) {
  Json served = Json::object();
  Json missing = Json::object();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const ServedMesh& mesh = meshes[i];
    if (mesh.path.empty()) {
      missing[mesh.uri] = may_command ? mesh.problem + ". " + mesh.remedy : "";
    } else {
      served[mesh.uri] = "/mesh/" + std::to_string(i) + query;
    }
  }
  return {{"meshes", served}, {"missing_meshes", missing}};
}

constexpr const char* kControlNames[] = {"joint", "task", "gravity"};

}  // namespace

std::string Inbox::receive(std::string_view message, double now,
                           const std::map<std::int64_t, double>& sent, Session& session) {
  RefusedCounts& counts = session.refused();
  const auto malformed = [&counts](const char* why, std::optional<std::int64_t> seq) {
    ++counts.malformed;
    return print_reply(seq, {false, why, -1});
  };
  if (message.size() > kLargestMessage) return malformed("the message is too long", {});
  const Json json = parse_shallow(message);
  if (!json.is_object()) return malformed("expected an object of JSON", {});
  const auto seq = whole(json, "seq");
  if (!seq) return malformed("expected `seq`, a whole number", {});
  if (text(json, "type") != "command") return malformed("expected the type `command`", seq);
  if (whole(json, "version") != kWireVersion) return malformed("expected version 1", seq);
  const auto line = text(json, "text");
  if (!line) return malformed("expected `text`, a line of the command language", seq);
  if (text(json, "robot") != session.robot().checksum) {
    ++counts.foreign;
    return print_reply(seq, {false, "the message is for another robot: load the page again", -1});
  }
  if (*seq <= last_) {
    ++counts.repeated;
    return print_reply(seq, {false, "`seq` has to grow: doubled or reordered message", -1});
  }
  last_ = *seq;
  const auto parsed = parse_command(*line, session.robot());
  const auto* command = std::get_if<Command>(&parsed);
  if (command == nullptr) {
    return print_reply(seq, session.obey(front_end_, may_command_, *line, now));
  }
  if (is_lease(command->verb)) {
    const auto seen = whole(json, "seen");
    const auto state = seen ? sent.find(*seen) : sent.end();
    if (state == sent.end() || now - state->second > kOldestSeen) {
      ++counts.late;
      return print_reply(seq, {false, "late: `seen` is no state of the last 0.5 s", -1});
    }
  }
  return print_reply(seq, session.obey(front_end_, may_command_, *command, now));
}

std::string print_meshes(const std::vector<ServedMesh>& meshes, const std::string& query,
                         bool may_command) {
  return print(describe_meshes(meshes, query, may_command));
}

std::string print_hello(const Session& session, double rate, bool may_command,
                        const std::vector<ServedMesh>& meshes, const std::string& mesh_query) {
  const RobotDescription& robot = session.robot();
  Json locked = Json::object();
  for (const auto& [joint, value] : robot.locked) locked[joint] = value;
  Json commands = Json::array();
  for (const CommandUsage& usage : command_usages()) {
    commands.push_back({{"usage", usage.usage}, {"does", usage.does}});
  }
  Json controls = {"joint", "gravity"};
  if (!robot.points.empty()) controls.insert(controls.begin() + 1, "task");
  Json hello = {{"type", "hello"},
                {"version", kWireVersion},
                {"robot", robot.checksum},
                {"name", robot.name},
                {"base", robot.floating ? "floating"
                         : robot.held   ? "held"
                                        : "fixed"},
                {"rate", rate},
                {"may_command", may_command},
                {"lease", kLease},
                {"start", session.start().empty() ? Json(nullptr) : Json(session.start())},
                {"coordinates", describe_coordinates(robot)},
                {"points", describe_points(robot)},
                {"links", robot.links},
                {"locked", locked},
                {"controls", controls},
                {"obstacles", describe_obstacles(robot)},
                {"commands", commands}};
  if (robot.has_controller) hello["controller"] = "own";
  if (robot.on_ground) hello["ground"] = true;
  hello.update(describe_meshes(meshes, mesh_query, may_command));
  return print(hello);
}

std::string print_state(const Session& session, std::int64_t seq, int watchers, Detail detail,
                        const Session* twin) {
  const RobotDescription& robot = session.robot();
  const ReportHead& head = session.report().head;
  const ReportLayout& layout = session.layout();
  const std::vector<double>& numbers = session.report().numbers;
  const LoopTiming& timing = session.timing();
  const RefusedCounts& counts = session.refused();
  const int nq = static_cast<int>(robot.coordinates.size());
  return print(
      {{"type", "state"},
       {"seq", seq},
       {"time", head.time},
       {"mode", servo::mode_name(static_cast<servo::Mode>(head.mode))},
       {"control", kControlNames[head.control]},
       {"fault", session.fault()},
       {"moving", head.moving},
       {"q", slice(numbers, layout.q, nq)},
       {"qd", slice(numbers, layout.qd, robot.velocities)},
       {"tau", slice(numbers, layout.tau, robot.velocities)},
       {"goal_q", slice(numbers, layout.goal, nq)},
       {"points", point_states(session)},
       {"center_of_mass",
        session.has_center_of_mass() ? slice(numbers, layout.center_of_mass, 3) : Json(nullptr)},
       {"forces", forces(session)},
       {"shown", shown_numbers(head.shown)},
       {"twin", describe_twin(twin)},
       {"control_us", describe_durations(timing.control())},
       {"period_us", describe_durations(timing.period())},
       {"jitter_us", describe_durations(timing.jitter())},
       {"histogram", detail == Detail::histograms ? describe_histograms(timing) : Json(nullptr)},
       {"cycles", head.cycle + 1},
       {"overruns", timing.overruns()},
       {"saturated", timing.saturated()},
       {"counts",
        {{"malformed", counts.malformed},
         {"foreign", counts.foreign},
         {"repeated", counts.repeated},
         {"late", counts.late},
         {"excess", counts.excess},
         {"refused", counts.refused},
         {"lost_messages", head.dropped_messages},
         {"lost_reports", head.dropped_reports}}},
       {"commander", session.authority().holder().has_value()},
       {"watchers", watchers}});
}

std::string finish_state(std::string state, bool commanding) {
  state.pop_back();
  return state + (commanding ? ",\"commanding\":true}" : ",\"commanding\":false}");
}

std::string stamp_reply(std::string reply, double milliseconds) {
  reply.pop_back();
  return reply + ",\"clock\":" + Json(milliseconds).dump() + "}";
}

std::string print_reply(std::optional<std::int64_t> seq, const Answer& answer) {
  Json json = {{"type", "reply"},
               {"seq", seq ? Json(*seq) : Json(nullptr)},
               {"ok", answer.ok},
               {"text", answer.text}};
  if (answer.at >= 0) json["at"] = answer.at;
  return print(json);
}

std::string print_command(const std::string& line, double time, const Answer& answer) {
  return print({{"type", "command"},
                {"time", time},
                {"text", line},
                {"ok", answer.ok},
                {"reply", answer.text}});
}

std::string print_note(const std::string& text) {
  return print({{"type", "note"}, {"text", text}});
}

}  // namespace treeline::drive
