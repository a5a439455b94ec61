#include "inspect/end_names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace treeline {
namespace {

bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Splits a name into words in lower case. Characters that are not letters separate words, and so
/// does a change of case, as in `leftHand` and `LFoot`.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  bool inside = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool letter = is_upper(c) || is_lower(c);
    const bool digit = is_digit(c) && inside;  // `tool0` is one word
    const bool hump = inside && is_upper(c) &&
                      (is_lower(name[i - 1]) || (i + 1 < name.size() && is_lower(name[i + 1])));
    if (letter && (!inside || hump)) words.emplace_back();
    inside = letter || digit;
    if (inside) words.back() += is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return words;
}

std::string_view without_digits(std::string_view word) {
  while (!word.empty() && is_digit(word.back())) word.remove_suffix(1);
  return word;
}

/// Whether a word only says where a link is or what it is in the file, not what it is for.
bool means_nothing(const std::string& word) {
  constexpr std::array<std::string_view, 21> kWords = {
      "link",  "frame", "body", "base", "center", "centre", "point", "joint", "l",  "r",    "left",
      "right", "fl",    "fr",   "rl",   "rr",     "lf",     "rf",    "lh",    "rh", "fixed"};
  return std::find(kWords.begin(), kWords.end(), without_digits(word)) != kWords.end();
}

/// The word without one that means nothing and is glued to its end: `graspframe`.
std::string without_glued(const std::string& word) {
  constexpr std::array<std::string_view, 5> kGlued = {"frame", "target", "site", "point", "link"};
  for (const std::string_view glued : kGlued) {
    if (word.ends_with(glued)) return word.substr(0, word.size() - glued.size());
  }
  return word;
}

struct KnownWord {
  std::string_view word;
  EndKind kind;
};

/// Known words, the best first. Words of three letters or more may also end a longer word, as in
/// `lefthand`.
constexpr std::array<KnownWord, 38> kKnown = {{
    {"tcp", EndKind::tool},
    {"tool0", EndKind::tool},
    {"grasp", EndKind::tool},
    {"grasping", EndKind::tool},
    {"pinch", EndKind::tool},
    {"ee", EndKind::tool},
    {"eef", EndKind::tool},
    {"effector", EndKind::tool},
    {"endeffector", EndKind::tool},
    {"tool", EndKind::tool},
    {"hand", EndKind::hand},
    {"palm", EndKind::hand},
    {"gripper", EndKind::hand},
    {"flange", EndKind::hand},
    {"sole", EndKind::foot},
    {"foot", EndKind::foot},
    {"tip", EndKind::tip},
    {"fingertip", EndKind::tip},
    {"pad", EndKind::tip},
    {"wheel", EndKind::wheel},
    {"roller", EndKind::wheel},
    {"caster", EndKind::wheel},
    {"castor", EndKind::wheel},
    {"prop", EndKind::propeller},
    {"propeller", EndKind::propeller},
    {"rotor", EndKind::propeller},
    {"head", EndKind::watching},
    {"neck", EndKind::watching},
    {"camera", EndKind::watching},
    {"cam", EndKind::watching},
    {"laser", EndKind::watching},
    {"lidar", EndKind::watching},
    {"hokuyo", EndKind::watching},
    {"sensor", EndKind::watching},
    {"eye", EndKind::watching},
    {"imu", EndKind::watching},
    {"realsense", EndKind::watching},
    {"kinect", EndKind::watching},
}};

struct RoleWords {
  LimbRole role;
  std::array<std::string_view, 16> words;
};

/// Words of links and joints of limbs in the habits of several exporters. They may also begin or
/// end a longer word, as in `kneepitch`; those of three letters one longer by a letter, as in
/// `legl`.
constexpr std::array<RoleWords, 8> kRoleWords = {{
    {LimbRole::finger, {"finger", "fngr", "thumb", "index", "pinky", "knuckle", "phalanx", "jaw"}},
    {LimbRole::watching,
     {"head", "neck", "eye", "camera", "laser", "lidar", "imu", "kinect", "realsense", "display",
      "sonar", "hokuyo", "velodyne", "gps", "dvl", "battery"}},
    {LimbRole::leg,
     {"leg", "hip", "thigh", "knee", "kne", "calf", "shank", "shin", "ankle", "ankel", "ank",
      "foot", "toe", "sole", "tibia", "femur"}},
    {LimbRole::arm,
     {"arm", "shoulder", "sho", "elbow", "elb", "wrist", "wri", "hand", "palm", "gripper",
      "forearm", "tool", "tcp", "flange", "effector", "eef"}},
    {LimbRole::wheel, {"wheel", "caster", "castor", "roller"}},
    {LimbRole::propeller, {"prop", "propeller", "rotor"}},
    {LimbRole::surface,
     {"fin", "wing", "rudder", "flap", "aileron", "elevator", "elevon", "thruster"}},
    {LimbRole::trunk, {"torso", "waist", "trunk", "chest", "spine", "abdomen", "tail"}},
}};

/// Whether a known word is a word of a name, or begins or ends it.
bool tells(std::string_view word, std::string_view known) {
  if (known.empty()) return false;
  const std::string_view plain = without_digits(word);
  return plain == known || ((known.size() > 3 || plain.size() == known.size() + 1) &&
                            (plain.starts_with(known) || plain.ends_with(known)));
}

/// Words of tools' points and of nothing else.
constexpr std::array<std::string_view, 3> kToolPoints = {"tcp", "ee", "eef"};

constexpr std::array<std::string_view, 13> kFlight = {
    "flying", "drone",      "quadrotor", "quadcopter", "hexarotor", "hexacopter", "uav",
    "aerial", "multirotor", "thruster",  "rov",        "auv",       "fish"};

constexpr std::array<std::string_view, 16> kSensors = {
    "camera", "sensor",    "imu",   "ft",  "force", "torque",   "optical", "laser",
    "lidar",  "realsense", "sonar", "dvl", "gps",   "pressure", "hokuyo",  "touch"};

constexpr std::array<std::string_view, 10> kFurniture = {
    "drawer", "door", "cabinet", "fridge", "oven", "dishwasher", "cupboard", "lid", "hatch", "tap"};

/// The shortest beginning of a name that ends with a word of hands or feet, and goes on.
std::string prefix_of_whole(const std::string& name) {
  constexpr std::string_view kSeparators = "_-/: ";
  for (std::size_t i = name.find_first_of(kSeparators); i < name.size();
       i = name.find_first_of(kSeparators, i + 1)) {
    const EndKind kind = end_name(name.substr(0, i)).kind;
    if (kind == EndKind::hand || kind == EndKind::foot) return name.substr(0, i + 1);
  }
  return "";
}

}  // namespace

LimbRole limb_word(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  for (const auto& [role, known] : kRoleWords) {
    for (const std::string& word : words) {
      if (word == "handle" || word == "swing") continue;  // no hand, no wing
      const auto fits = [&](std::string_view one) { return tells(word, one); };
      if (std::any_of(known.begin(), known.end(), fits)) return role;
    }
  }
  return LimbRole::unknown;
}

std::optional<std::string> word_of_flight(const std::string& name) {
  for (const std::string& word : words_of(name)) {
    if (std::find(kFlight.begin(), kFlight.end(), without_digits(word)) != kFlight.end()) {
      return word;
    }
  }
  return std::nullopt;
}

bool is_furniture(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return std::find(kFurniture.begin(), kFurniture.end(), without_digits(word)) !=
           kFurniture.end();
  });
}

std::string prefix_of_all(const Robot& robot, const BodyTree& tree) {
  std::map<std::string, std::size_t> numbers;
  std::size_t links = 0;
  for (std::size_t b = 1; b < tree.bodies.size(); ++b) {
    for (const int l : tree.bodies[b].links) {
      ++links;
      const std::string prefix = prefix_of_whole(robot.links[static_cast<std::size_t>(l)].name);
      if (!prefix.empty()) ++numbers[prefix];
    }
  }
  const auto most = std::max_element(numbers.begin(), numbers.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  const bool nearly_all = most != numbers.end() && links > 3 && 10 * most->second >= 9 * links;
  return nearly_all ? most->first : "";
}

bool is_sensor(const std::string& link) {
  const std::vector<std::string> words = words_of(link);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return std::find(kSensors.begin(), kSensors.end(), without_digits(word)) != kSensors.end();
  });
}

EndName end_name(const std::string& link) {
  std::vector<std::string> words = words_of(link);
  while (!words.empty()) {
    words.back() = without_glued(words.back());
    if (!words.back().empty() && !means_nothing(words.back())) break;
    words.pop_back();
  }
  if (words.empty()) return {};
  const std::string_view last = words.back();
  const std::string_view plain = without_digits(last);
  for (std::size_t i = 0; i < kKnown.size(); ++i) {
    const std::string_view known = kKnown[i].word;
    const bool ends = known.size() > 2 && plain.ends_with(known);
    if (last == known || plain == known || ends) {
      return {kKnown[i].kind, static_cast<int>(i)};
    }
    const auto said = std::find(words.begin(), words.end(), known);
    const bool is_point =
        std::find(kToolPoints.begin(), kToolPoints.end(), known) != kToolPoints.end();
    if (is_point && said != words.end()) return {kKnown[i].kind, static_cast<int>(i)};
  }
  return {};
}

bool is_hand(const std::string& link) {
  const EndName name = end_name(link);
  if (name.kind != EndKind::hand) return false;
  const std::string_view word = kKnown[static_cast<std::size_t>(name.rank)].word;
  return word == "hand" || word == "palm";
}

bool is_ground(const std::string& link) {
  constexpr std::array<std::string_view, 5> kWords = {"world", "ground", "map", "odom", "floor"};
  std::vector<std::string> words = words_of(link);
  while (words.size() > 1 && means_nothing(words.back())) words.pop_back();
  return words.size() == 1 && std::find(kWords.begin(), kWords.end(), words[0]) != kWords.end();
}

}  // namespace treeline
