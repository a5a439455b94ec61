#include "drive/command.hpp"

#include <fmt/format.h>

#include <numbers>

namespace treeline::drive {

double angle_unit(const Command& command) {
  return command.degrees ? std::numbers::pi / 180.0 : 1.0;
}

const char* angle_unit_name(const Command& command) {
  return command.degrees ? "deg" : "rad";
}

namespace {

std::string name_of_point(int point, const RobotDescription& robot) {
  return point == kBasePoint ? "base" : robot.points[static_cast<std::size_t>(point)].name;
}

std::string print_vector(const Command& command, int first = 0, int count = 3) {
  const auto begin = command.numbers.begin() + first;
  const double unit = angle_unit(command);
  std::string text;
  for (auto number = begin; number != begin + count; ++number) {
    text += fmt::format("{}{:.4g}", text.empty() ? "(" : ", ", *number / unit);
  }
  return text + ")";
}

std::string print_duration(const Command& command) {
  return command.duration > 0.0 ? fmt::format(" in {:.4g} s", command.duration) : std::string();
}

std::string describe_joint(const Command& command, const RobotDescription& robot,
                           const char* what) {
  const DrivenCoordinate& joint = robot.coordinates[static_cast<std::size_t>(command.target)];
  return fmt::format("{}{} {} {:.4g} {}{}", joint.name, what, command.relative ? "by" : "to",
                     command.numbers[0] / (is_angle(joint) ? angle_unit(command) : 1.0),
                     is_angle(joint) ? angle_unit_name(command) : "m", print_duration(command));
}

const char* control_name(Control control) {
  switch (control) {
    case Control::joint:
      return "joint";
    case Control::task:
      return "task";
    case Control::gravity:
      return "gravity";
  }
  return "";
}

std::string describe_motion(const Command& command, const RobotDescription& robot) {
  const char* const how = command.relative ? "by" : "to";
  switch (command.verb) {
    case Verb::joint:
      return describe_joint(command, robot, " moves");
    case Verb::posture:
      return describe_joint(command, robot, " is drawn");
    case Verb::drag_joint:
      return describe_joint(command, robot, " follows");
    case Verb::move:
      return fmt::format("{} moves {} {} m{}", name_of_point(command.target, robot), how,
                         print_vector(command), print_duration(command));
    case Verb::turn:
      return fmt::format("{} turns {} {}{}{}", name_of_point(command.target, robot), how,
                         print_vector(command, 0, command.relative ? 3 : 4),
                         command.relative ? fmt::format(" {}", angle_unit_name(command)) : "",
                         print_duration(command));
    case Verb::drag_point:
      return fmt::format("{} follows to {} m", name_of_point(command.target, robot),
                         print_vector(command));
    default:
      return fmt::format("{} is pulled to {} m",
                         robot.links[static_cast<std::size_t>(command.target)],
                         print_vector(command, 3));
  }
}

}  // namespace

const std::vector<CommandUsage>& command_usages() {
  static const std::vector<CommandUsage> kUsages = {
      {"start", "begin to control from the present state"},
      {"stop", "emergency stop: brake now; latched until reset"},
      {"brake", "brake to rest, then idle"},
      {"reset", "leave the fault or the emergency stop"},
      {"mode joint|task|gravity", "choose the control"},
      {"joint NAME to|by X [deg|rad|m] [in T s]", "move a joint"},
      {"move POINT to|by X Y Z [in T s]", "move a point in the world"},
      {"turn POINT to QX QY QZ QW [in T s]", "turn a point to an orientation in the world"},
      {"turn POINT by RX RY RZ [deg|rad] [in T s]", "turn a point by a rotation vector"},
      {"posture NAME to|by X [deg|rad|m] [in T s]", "the goal of a joint beside the task"},
      {"posture home [in T s]", "all joints to where the robot began"},
      {"hold [POINT]", "stop the motions where their goals are"},
      {"release POINT", "damp the point and let it go"},
      {"drag POINT to X Y Z [QX QY QZ QW]", "lead a point, for 125 ms"},
      {"drag joint NAME to X [deg|rad|m]", "lead a joint, for 125 ms"},
      {"pull LINK at X Y Z to X Y Z", "a spring from a place on a link, for 125 ms"},
      {"gains [joint|task] stiffness K damping D", "1/s^2 and 1/s"},
      {"follow [in T s]", "the motion of --reference; first to where it begins"},
      {"rehearse", "motions are for a twin, which is shown as a ghost"},
      {"go", "the robot does what its twin has done"},
      {"discard", "forget the rehearsal"},
      {"take", "ask for the command over the robot"},
      {"give", "give it up"},
      {"wait [T s]", "scripts: until all motions have ended, or T seconds"},
      {"help", "standard input: this list"},
      {"quit", "standard input: brake to rest and end"}};
  return kUsages;
}

std::string describe(const Command& command, const RobotDescription& robot) {
  switch (command.verb) {
    case Verb::start:
      return "control begins";
    case Verb::stop:
      return "emergency stop";
    case Verb::brake:
      return "braking to rest";
    case Verb::reset:
      return "reset";
    case Verb::mode:
      return fmt::format("control: {}", control_name(command.control));
    case Verb::home:
      return "all joints move to where the robot began" + print_duration(command);
    case Verb::hold:
      return command.has_target ? name_of_point(command.target, robot) + " is held"
                                : std::string("all motions stop");
    case Verb::release:
      return name_of_point(command.target, robot) + " is released";
    case Verb::gains:
      return fmt::format("stiffness {:.4g} 1/s^2, damping {:.4g} 1/s", command.numbers[0],
                         command.numbers[1]);
    case Verb::follow:
      return "the joints follow the recorded motion" + print_duration(command);
    case Verb::rehearse:
    case Verb::go:
    case Verb::discard:
      return {};
    case Verb::take:
      return "this front end commands";
    case Verb::give:
      return "the command is free";
    case Verb::wait:
    case Verb::help:
    case Verb::quit:
      return {};
    default:
      return describe_motion(command, robot);
  }
}

bool needs_authority(Verb verb) {
  return verb != Verb::stop && verb != Verb::take && verb != Verb::give && !is_local(verb);
}

bool needs_running(Verb verb) {
  switch (verb) {
    case Verb::joint:
    case Verb::move:
    case Verb::turn:
    case Verb::posture:
    case Verb::home:
    case Verb::hold:
    case Verb::release:
    case Verb::drag_point:
    case Verb::drag_joint:
    case Verb::pull:
    case Verb::follow:
    case Verb::rehearse:
    case Verb::go:
      return true;
    default:
      return false;
  }
}

bool is_of_rehearsal(Verb verb) {
  return verb == Verb::rehearse || verb == Verb::go || verb == Verb::discard;
}

bool is_rehearsed(Verb verb) {
  return (needs_running(verb) && !is_of_rehearsal(verb)) || verb == Verb::mode ||
         verb == Verb::gains;
}

bool is_lease(Verb verb) {
  return verb == Verb::drag_point || verb == Verb::drag_joint || verb == Verb::pull;
}

bool is_local(Verb verb) {
  return verb == Verb::wait || verb == Verb::help || verb == Verb::quit;
}

namespace {

servo::Message plain_message(servo::MessageKind kind) {
  servo::Message message;
  message.kind = kind;
  return message;
}

/// [target, flag, numbers...]
servo::Message flagged_message(Instruction instruction, const Command& command, bool flag) {
  servo::Message message = make_message(instruction);
  message.duration = command.duration;
  message.values[0] = command.target;
  message.values[1] = flag ? 1.0 : 0.0;
  for (std::size_t i = 0; i < command.numbers.size(); ++i) {
    message.values[2 + i] = command.numbers[i];
  }
  return message;
}

/// [target, numbers...]
servo::Message numbered_message(Instruction instruction, const Command& command) {
  servo::Message message = make_message(instruction);
  message.duration = command.duration;
  message.values[0] = command.target;
  for (std::size_t i = 0; i < command.numbers.size(); ++i) {
    message.values[1 + i] = command.numbers[i];
  }
  return message;
}

}  // namespace

servo::Message message_for(const Command& command) {
  switch (command.verb) {
    case Verb::start:
      return plain_message(servo::MessageKind::start);
    case Verb::brake:
      return plain_message(servo::MessageKind::stop);
    case Verb::reset:
      return plain_message(servo::MessageKind::reset);
    case Verb::mode: {
      servo::Message message = make_message(Instruction::set_control);
      message.values[0] = static_cast<double>(command.control);
      return message;
    }
    case Verb::joint:
      return flagged_message(Instruction::move_joint, command, command.relative);
    case Verb::posture:
      return flagged_message(Instruction::move_posture, command, command.relative);
    case Verb::home:
      return numbered_message(Instruction::go_home, command);
    case Verb::move:
      return flagged_message(Instruction::move_point, command, command.relative);
    case Verb::turn:
      return flagged_message(Instruction::turn_point, command, command.relative);
    case Verb::drag_point:
      return flagged_message(Instruction::drag_point, command, command.number_count == 7);
    case Verb::drag_joint:
      return numbered_message(Instruction::drag_joint, command);
    case Verb::pull:
      return numbered_message(Instruction::pull_link, command);
    case Verb::hold:
      return numbered_message(command.has_target ? Instruction::hold_point : Instruction::hold_all,
                              command);
    case Verb::release:
      return numbered_message(Instruction::release_point, command);
    case Verb::gains:
      return numbered_message(Instruction::set_gains, command);
    case Verb::follow:
      return numbered_message(Instruction::follow, command);
    default:  // and everything that is not meant for the loop stops it
      return plain_message(servo::MessageKind::emergency_stop);
  }
}

}  // namespace treeline::drive
