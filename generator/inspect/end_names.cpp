#include "inspect/end_names.hpp"

#include <algorithm>
#include <array>
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

struct KnownWord {
  std::string_view word;
  EndKind kind;
};

/// Known words, the best first. Words of three letters or more may also end a longer word, as in
/// `lefthand`.
constexpr std::array<KnownWord, 38> kKnown = {{
    {"tcp", EndKind::tool},
    {"tool0", EndKind::tool},
    {"tool", EndKind::tool},
    {"toolframe", EndKind::tool},
    {"ee", EndKind::tool},
    {"eef", EndKind::tool},
    {"effector", EndKind::tool},
    {"endeffector", EndKind::tool},
    {"grasp", EndKind::tool},
    {"grasping", EndKind::tool},
    {"pinch", EndKind::tool},
    {"hand", EndKind::hand},
    {"palm", EndKind::hand},
    {"gripper", EndKind::hand},
    {"flange", EndKind::hand},
    {"sole", EndKind::foot},
    {"foot", EndKind::foot},
    {"tip", EndKind::tip},
    {"fingertip", EndKind::tip},
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

}  // namespace

EndName end_name(const std::string& link) {
  std::vector<std::string> words = words_of(link);
  while (!words.empty() && means_nothing(words.back())) words.pop_back();
  if (words.empty()) return {};
  const std::string_view last = words.back();
  const std::string_view plain = without_digits(last);
  for (std::size_t i = 0; i < kKnown.size(); ++i) {
    const std::string_view known = kKnown[i].word;
    const bool ends = known.size() > 2 && plain.ends_with(known);
    if (last == known || plain == known || ends) {
      return {kKnown[i].kind, static_cast<int>(i)};
    }
  }
  return {};
}

bool is_ground(const std::string& link) {
  constexpr std::array<std::string_view, 5> kWords = {"world", "ground", "map", "odom", "floor"};
  const std::vector<std::string> words = words_of(link);
  return words.size() == 1 && std::find(kWords.begin(), kWords.end(), words[0]) != kWords.end();
}

}  // namespace treeline
