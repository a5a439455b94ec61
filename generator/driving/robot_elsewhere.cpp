#include "driving/robot_elsewhere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "driving/find_start.hpp"
#include "driving/loop_handle.hpp"
#include "driving/robot_shapes.hpp"
#include "interruption/clean_up.hpp"
#include "terminal/write_output.hpp"
#include "text/printable.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

std::atomic<bool> asked_to_rest{false};

/// Closes the loops near `start`; empty, with an error, where that is not possible.
std::vector<double> closed(const LaunchedRobot& robot, std::vector<double> start,
                           Diagnostics& diagnostics) {
  constexpr double kClosed = 1e-6;  // m or rad
  const double error = robot.library.functions().close_loops(start.data());
  if (error <= kClosed) return start;
  diagnostics.add(
      {Severity::error, "", 0, "--q",
       fmt::format("the loops cannot be closed near this place: {:.2g} m or rad are left", error),
       "Give --q with coordinates at which they nearly are."});
  return {};
}

/// Puts a robot whose base floats upon the ground: z = 0 of the world.
void stand_on_ground(const LaunchedRobot& robot, const RobotShapes& shapes,
                     std::vector<double>& start) {
  const auto& coordinates = robot.description.coordinates;
  const auto z = std::find_if(coordinates.begin(), coordinates.end(), [](const auto& each) {
    return each.joint == "base" && each.measure == drive::Measure::z;
  });
  if (z == coordinates.end()) return;
  start[static_cast<std::size_t>(z - coordinates.begin())] -= shapes.lowest(start);
}

/// A start whose lowest point is not in the ground; else empty, with an error.
std::vector<double> above_ground(const LaunchedRobot& robot, std::vector<double> start,
                                 Diagnostics& diagnostics) {
  constexpr double kTyped = 1e-3;  // m: coordinates are typed to so many digits
  const double lowest = start.empty() ? 0 : RobotShapes(robot).lowest(start);
  if (lowest >= -kTyped) return start;
  diagnostics.add({Severity::error, "", 0, "--q",
                   fmt::format("the robot would start {:.4g} m deep in the ground", -lowest),
                   "Give --q with a place above it."});
  return {};
}

/// Where joints are near 0 and the robot can hold its weight and move its points.
std::vector<double> choose_place(const LaunchedRobot& robot, std::vector<double> start,
                                 const AdmitsStart& is_clear) {
  const drive::RobotLibrary& library = robot.library.functions();
  if (const auto better = find_holdable_start(library, robot.description, start, is_clear)) {
    print_message(
        "with all joints at 0 the robot cannot hold its weight: it starts elsewhere; --q "
        "chooses the place\n");
    start = *better;
  }
  if (const auto better = find_bent_start(library, robot.description, start, is_clear)) {
    print_message(
        "with its joints near 0 the robot cannot move its points in every direction: it "
        "starts bent; --q chooses the place\n");
    start = *better;
  }
  return start;
}

/// Where all joints are at 0, or as near as the robot can hold its weight and move its points or
/// stand on its feet, and no link is in another.
std::vector<double> choose_start(const LaunchedRobot& robot) {
  std::vector<double> start = default_start(robot.description);
  const RobotShapes shapes(robot);
  const AdmitsStart is_clear = [&shapes, first = start](const std::vector<double>& q) {
    return shapes.is_clear(q, first);
  };
  if (!robot.description.on_ground || !robot.description.held) {
    start = choose_place(robot, start, is_clear);
  } else if (const auto standing = find_standing_start(robot, start, is_clear)) {
    start = *standing;
  } else {
    print_message(
        "no place was found at which the robot stands with its centre of mass above its feet: "
        "--q chooses one\n");
  }
  stand_on_ground(robot, shapes, start);
  return start;
}

}  // namespace

bool has_as_many(const drive::RobotDescription& robot, const std::vector<double>& given,
                 Diagnostics& diagnostics) {
  const std::size_t size = robot.coordinates.size();
  if (given.empty() || given.size() == size) return true;
  diagnostics.add({Severity::error, "", 0, "--q",
                   fmt::format("{} numbers are given, the robot has {}", given.size(), size),
                   "`treeline inspect` lists the joints in their order."});
  return false;
}

std::vector<double> start_of(const LaunchedRobot& robot, const std::vector<double>& given,
                             Diagnostics& diagnostics) {
  if (!has_as_many(robot.description, given, diagnostics)) return {};
  std::vector<double> start =
      closed(robot, given.empty() ? choose_start(robot) : given, diagnostics);
  return robot.description.on_ground ? above_ground(robot, std::move(start), diagnostics) : start;
}

std::optional<std::string> read_robot_secret(const std::string& file, Diagnostics& diagnostics) {
  constexpr std::size_t kShortest = 16;
  const char* const variable = std::getenv("TREELINE_ROBOT_SECRET");
  std::string secret = file.empty() && variable != nullptr ? variable : "";
  if (!file.empty()) {
    const auto text = read_text_file(file, diagnostics);
    if (!text) return std::nullopt;
    secret = text->substr(0, text->find_last_not_of(" \t\r\n") + 1);
  }
  if (secret.size() >= kShortest) return secret;
  if (file.empty() && secret.empty()) {
    diagnostics.add({Severity::warning, "", 0, "--robot-secret",
                     "neither side proves who it is: everybody who reaches the other can command "
                     "the robot, or pretend to be it",
                     "Give both the same secret, in a file or in TREELINE_ROBOT_SECRET."});
    return secret;
  }
  diagnostics.add({Severity::error, file, 0, "--robot-secret",
                   fmt::format("a secret of {} characters can be guessed", secret.size()),
                   fmt::format("Give at least {}, as `openssl rand -hex 16` prints.", kShortest)});
  return std::nullopt;
}

namespace {

/// What to do where nothing answers.
Diagnostic silence_at(const Elsewhere& elsewhere, const drive::PacketCounts& counts) {
  std::string text = fmt::format(
      "no {} answers at {}", elsewhere.has_controller ? "controller" : "robot", elsewhere.address);
  if (counts.foreign > 0) text += ", or it is another one, or has another secret";
  if (counts.malformed > 0) text += ", or it has not as many joints as this robot";
  const char* const remedy =
      elsewhere.has_controller
          ? "Start your loop, which calls `treeline_show_open` for this address, with the same "
            "secret."
          : "`treeline drive --act-as-robot HOST:PORT`, with the same URDF, scene and secret, is a "
            "simulated one.";
  return {Severity::error, "", 0, "--robot", text, remedy};
}

/// Waits for the first state. A control loop may have to be compiled, or be started by hand.
bool wait_for(drive::UdpRobot& robot, const Elsewhere& elsewhere) {
  constexpr double kPatience = 5;   // s
  constexpr double kLongest = 120;  // s
  if (robot.wait_for_state(kPatience)) return true;
  const drive::PacketCounts& counts = robot.counts();
  if (!elsewhere.has_controller || counts.foreign > 0 || counts.malformed > 0) return false;
  print_message("waits for a control loop at " + printable(elsewhere.address) + "\n");
  return robot.wait_for_state(kLongest);
}

}  // namespace

std::unique_ptr<drive::UdpRobot> find_robot(const LaunchedRobot& robot, const Elsewhere& elsewhere,
                                            Diagnostics& diagnostics) {
  const drive::RobotDescription& description = robot.description;
  std::string error;
  auto found = drive::UdpRobot::open(
      {elsewhere.address, description.checksum, elsewhere.secret, elsewhere.has_controller},
      static_cast<int>(description.coordinates.size()), description.velocities,
      static_cast<int>(description.points.size()), error);
  if (found && wait_for(*found, elsewhere)) return found;
  diagnostics.add(found ? silence_at(elsewhere, found->counts())
                        : Diagnostic{Severity::error, "", 0, "--robot",
                                     fmt::format("\"{}\": {}", elsewhere.address, error),
                                     "Name an address of the robot as a number, and its port."});
  return nullptr;
}

namespace {

/// The simulated robot of another process's loop. Whatever it is commanded, its state stays finite:
/// one that is not is left out, and the robot stands again where it last was.
class LoneRobot {
 public:
  LoneRobot(const LaunchedRobot& robot, const drive::LoopOptions& options)
      : library_(robot.library.functions()),
        options_(options),
        start_(options.start, options.start + library_.coordinates),
        state_(static_cast<std::size_t>(library_.coordinates + library_.velocities)) {
    stand();
  }

  void advance(const double* tau, double seconds) {
    library_.advance_robot(robot_.get(), tau, seconds);
    library_.read_robot(robot_.get(), state_.data());
    if (std::all_of(state_.begin(), state_.end(), [](double x) { return std::isfinite(x); })) {
      std::copy_n(state_.begin(), start_.size(), start_.begin());
      return;
    }
    if (!std::exchange(told_, true)) {
      print_message("the robot's numbers were not finite any more: it stands where it last was\n");
    }
    stand();
  }
  void read(double* state) const { std::copy(state_.begin(), state_.end(), state); }

 private:
  void stand() {
    options_.start = start_.data();
    robot_ = {library_.create_robot(&options_), library_.destroy_robot};
    library_.read_robot(robot_.get(), state_.data());
  }

  const drive::RobotLibrary& library_;
  drive::LoopOptions options_;
  std::vector<double> start_;
  std::vector<double> state_;
  std::unique_ptr<void, void (*)(void*)> robot_{nullptr, nullptr};
  bool told_ = false;
};

}  // namespace

bool act_as_robot(const LaunchedRobot& robot, const std::vector<double>& given, double rate,
                  const SimulationNumbers& simulation, const Elsewhere& elsewhere,
                  Diagnostics& diagnostics) {
  const std::vector<double> start = start_of(robot, given, diagnostics);
  if (start.empty()) return false;
  const LoopNumbers numbers(robot.description);
  drive::LoopOptions options = options_for(robot.description, numbers, start);
  options.rate = rate;
  options.simulation = simulation.options();
  LoneRobot simulated(robot, options);
  drive::RobotSide side;
  side.address = {elsewhere.address, robot.description.checksum, elsewhere.secret};
  side.rate = rate;
  side.nq = robot.library.functions().coordinates;
  side.torque = numbers.torque;
  side.advance = [&](const double* tau, double seconds) { simulated.advance(tau, seconds); };
  side.read = [&](double* state) { simulated.read(state); };
  asked_to_rest = false;
  answer_signals([] { asked_to_rest = true; });
  print_message("the simulated robot listens at " + printable(elsewhere.address) + "\n");
  const std::string error = drive::run_robot_side(side, asked_to_rest);
  answer_signals(nullptr);
  if (error.empty()) return true;
  diagnostics.add({Severity::error, "", 0, "--act-as-robot",
                   fmt::format("{} cannot be listened on: {}", elsewhere.address, error),
                   "Name an address of this machine as a number, and a free port."});
  return false;
}

}  // namespace treeline
