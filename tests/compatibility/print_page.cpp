#include "compatibility/print_page.hpp"

#include <fmt/format.h>

namespace treeline::tests {
namespace {

/// Functions that have a column each.
constexpr const char* kColumns[] = {"inverse_dynamics", "forward_dynamics", "mass_matrix",
                                    "control_torque"};

constexpr const char* kHead =
    "# Published robots\n"
    "\n"
    "What Treeline makes of each robot of `published`, made by `cmake --build BUILD -t "
    "report_compatibility`.\n"
    "The scene: six rows of task on the last two end links, or as many as they can do; every "
    "function that such\n"
    "a scene has by default; `lanes: 1`.\n"
    "\n"
    "- freedoms: of the base and the joints, mimic joints not counted;\n"
    "- functions: generated, of those asked for;\n"
    "- operations (+ - * /, sines and cosines not counted) of inverse dynamics, forward dynamics, "
    "mass matrix\n"
    "  and control torque;\n"
    "- digits that the same four leave in double at the worst of 40 states of each class, against "
    "50 digits: `-`\n"
    "  where no state leaves any;\n"
    "- seconds: processor time of generating all functions, on the machine that made this page.\n"
    "\n"
    "A test compares all columns but digits (`tests/check/digits.csv` guards them) and seconds.\n"
    "\n"
    "| robot | base | freedoms | functions | inverse | forward | M | torque | digits | seconds |\n"
    "|---|---|---|---|---|---|---|---|---|---|\n";

std::string print_digits_of(const CompatibilityRow& row) {
  std::string text;
  for (const char* function : kColumns) {
    const auto found = row.digits.find(function);
    text += fmt::format("{}{}", text.empty() ? "" : " / ",
                        found == row.digits.end() ? "-" : found->second);
  }
  return text;
}

}  // namespace

std::string print_counts(const CompatibilityRow& row) {
  std::string text = fmt::format("| {} | {} |", row.of.robot_name(), row.of.base_name());
  if (!row.failure.empty()) return text + fmt::format(" refused: {} |", row.failure);
  text += fmt::format(" {} | {} of {} |", row.freedoms, row.operations.size(), row.asked);
  for (const char* function : kColumns) {
    const auto found = row.operations.find(function);
    text += found == row.operations.end() ? " - |" : fmt::format(" {} |", found->second);
  }
  return text;
}

std::string print_page(const std::vector<CompatibilityRow>& rows) {
  std::string text = kHead;
  for (const CompatibilityRow& row : rows) {
    text += print_counts(row);
    if (row.failure.empty()) {
      text += fmt::format(" {} | {:.1f} |", print_digits_of(row), row.seconds);
    }
    text += '\n';
  }
  return text;
}

}  // namespace treeline::tests
