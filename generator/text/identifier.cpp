#include "text/identifier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "text/printable.hpp"

namespace treeline {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Targets that CMake makes or keeps for itself.
constexpr std::array<std::string_view, 17> kTargets = {
    "ALL_BUILD", "INSTALL",    "PACKAGE",        "RUN_TESTS",  "ZERO_CHECK",   "all",
    "clean",     "codegen",    "depend",         "edit_cache", "help",         "install",
    "package",   "preinstall", "package_source", "test",       "rebuild_cache"};

/// Headers of the runtime that are emitted, in C++ or in C, without their ending.
constexpr std::array<std::string_view, 55> kHeaders = {"common_frame",
                                                       "controller_braking",
                                                       "controller_commands",
                                                       "controller_compliance",
                                                       "controller_config",
                                                       "controller_drift",
                                                       "controller_faults",
                                                       "controller_following",
                                                       "controller_functions",
                                                       "controller_laws",
                                                       "controller_measurement",
                                                       "controller_numbers",
                                                       "controller_pace",
                                                       "controller_points",
                                                       "controller_references",
                                                       "controller_robot",
                                                       "controller_safety",
                                                       "controller_step",
                                                       "controller_waiting",
                                                       "damped_sizes",
                                                       "damped_solve",
                                                       "eights",
                                                       "ending_sizes",
                                                       "enter_rows",
                                                       "force_basis",
                                                       "lanes",
                                                       "ldlt",
                                                       "limit_program",
                                                       "limit_sizes",
                                                       "limited_states",
                                                       "limited_torque",
                                                       "link_functions",
                                                       "load_lanes",
                                                       "orientation",
                                                       "quadratic_program",
                                                       "quintic",
                                                       "registers",
                                                       "sin_cos",
                                                       "solve_columns",
                                                       "square_root",
                                                       "states",
                                                       "symmetric_eigen",
                                                       "torque_limits",
                                                       "turn_motion"};

/// Namespaces within that of a robot: code there that names the robot's would find them instead.
constexpr std::array<std::string_view, 3> kNamespaces = {"calls", "detail", "eigen"};

template <class Names>
bool holds(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void append_underscore(std::string& identifier) {
  if (!identifier.empty() && identifier.back() != '_') identifier += '_';
}

}  // namespace

bool is_identifier(std::string_view name) {
  if (name.empty() || !is_letter(name.front())) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i]) && !is_digit(name[i]) && name[i] != '_') return false;
    if (name[i] == '_' && i + 1 < name.size() && name[i + 1] == '_') return false;
  }
  return !is_taken_name(name);
}

std::string identifier_from(std::string_view name) {
  std::string identifier;
  while (!name.empty()) {
    const CodePoint point = decode_utf8(name);
    const char first = name.front();
    if (point.length > 1) {
      identifier += fmt::format("u{:x}", point.value);
    } else if (is_letter(first) || is_digit(first)) {
      if (identifier.empty() && is_digit(first)) identifier += 'n';
      identifier += first;
    } else {
      append_underscore(identifier);
    }
    name.remove_prefix(std::max<std::size_t>(point.length, 1));
  }
  const bool trailing = !identifier.empty() && identifier.back() == '_';
  if (identifier.empty()) return "unnamed";
  if (is_taken_name(identifier) && !trailing) identifier += '_';
  return identifier;
}

std::string in_capitals(std::string name) {
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

bool is_package_name(std::string_view name) {
  return is_identifier(name) && !holds(kTargets, name) && !holds(kHeaders, name) &&
         !holds(kNamespaces, name);
}

std::string package_name_from(std::string_view name) {
  std::string identifier = identifier_from(name);
  if (!is_package_name(identifier) && is_identifier(identifier)) identifier += '_';
  return identifier;
}

}  // namespace treeline
