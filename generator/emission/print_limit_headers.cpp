#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "core/emitted_limits.hpp"
#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/body_steps.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/costs.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// Arrays of passive joints, held rows, task rows and cones have at least one entry.
struct Entries {
  explicit Entries(const EmissionContext& context)
      : passive(core::one_or(static_cast<int>(context.limits->passive.size()))),
        held(core::one_or(static_cast<int>(context.limits->force_weights.size()))),
        tasks(core::one_or(context.task_rows)),
        cones(core::one_or(static_cast<int>(context.limits->cones.size()))) {}
  int passive, held, tasks, cones;
};

/// Sizes that the header of the contract names.
std::vector<Constant> list_sizes(const EmissionContext& context) {
  const LimitFacts& facts = *context.limits;
  const LimitCost cost = cost_of_limits(facts, context.velocities);
  const auto passive = static_cast<int>(facts.passive.size());
  return {{"PASSIVE", passive, "velocities without a motor"},
          {"MOTORS", context.velocities - passive, ""},
          {"HELD_ROWS", static_cast<int>(facts.force_weights.size()), "of constraints"},
          {"CONES", static_cast<int>(facts.cones.size()), "rows of them"},
          {"FREEDOMS", count_freedoms(facts), ""},
          {"UNKNOWNS", cost.unknowns, "of the program"},
          {"LIMIT_ROWS", cost.rows, "motors, cones"}};
}

using core::QuadraticStatus, core::RowSide;

constexpr Constant kOutcomes[] = {{"SOLVED", static_cast<int>(QuadraticStatus::solved), ""},
                                  {"CONFLICTING", static_cast<int>(QuadraticStatus::conflicting),
                                   "rows that conflict with others were set aside"},
                                  {"LIMIT", static_cast<int>(QuadraticStatus::limit),
                                   "iterations were used up: the rest is clipped"},
                                  {"NOT_CONVEX", static_cast<int>(QuadraticStatus::not_convex),
                                   "numbers do not fit: torques are only clipped, f is not"}};

constexpr Constant kSides[] = {{"LOWER", static_cast<int>(RowSide::lower), ""},
                               {"FREE", static_cast<int>(RowSide::none), ""},
                               {"UPPER", static_cast<int>(RowSide::upper), ""},
                               {"SET_ASIDE", static_cast<int>(RowSide::set_aside), ""}};

/// Sizes of the arrays in which the method computes.
std::vector<Constant> list_array_sizes(const EmissionContext& context) {
  const Entries entries(context);
  const LimitCost cost = cost_of_limits(*context.limits, context.velocities);
  const int mass_at = entries.passive + entries.held + entries.tasks;
  const int mass_end = core::in_eights(mass_at + context.velocities);
  // Of shares forces that carry nothing have columns and rows.
  const bool shares = context.limits->has_shares();
  const int cols = mass_end + (shares ? core::in_eights(entries.held) : 0);
  const int table_rows = context.velocities + (shares ? entries.held : 0);
  const int task_at = entries.passive + entries.held;
  return {{"ALL_ROWS", cost.unknowns + cost.rows, "bounds of unknowns, motors, cones"},
          {"PASSIVE_ENTRIES", entries.passive, "of arrays, which have at least one"},
          {"HELD_ENTRIES", entries.held, ""},
          {"TASK_ENTRIES", entries.tasks, ""},
          {"BASIS_COLS", core::in_eights(entries.passive + entries.held), "in eights"},
          {"TASK_AT", task_at, "column of the first task row"},
          {"MASS_AT", mass_at, "first column of M"},
          {"MASS_END", mass_end, "in eights"},
          {"FORCES_AT", mass_end, "first column of forces that carry nothing"},
          {"COLS", cols, "in eights"},
          {"TABLE_ENTRIES", table_rows * cols, ""},
          {"TASK_COLS", shares ? cols - task_at : entries.tasks + context.velocities,
           "of task rows and what is behind them"},
          {"FORCE_ENTRIES", entries.held * cost.unknowns, "held rows by unknowns"},
          {"CARRIED_ENTRIES", entries.passive * cost.unknowns, "passive joints by unknowns"},
          {"MOST_ROWS", std::max(table_rows, entries.held), "of a table that is reflected"},
          {"MOST_ITERATIONS", core::most_iterations(cost.unknowns, cost.rows), ""}};
}

/// Tolerances and weights of the method as words of the headers.
template <class Real>
void add_numbers(const EmissionContext& context, Adaptation& own) {
  Syntax syntax = make_c_family_syntax(context.single_precision);
  follow_misra(context.single_precision, syntax);  // capital suffixes, as those of number_literal
  using Numbers = core::LimitNumbers<Real>;
  const auto add = [&](const char* word, Real number) {
    own.words[word] = syntax.literal(static_cast<double>(number));
  };
  add("TL_DEPENDENT", Numbers::kDependent);
  add("TL_ROW_TOLERANCE", Numbers::kRowTolerance);
  add("TL_CENTER_SHARE", Numbers::kCenterShare);
  add("TL_LEAST_CONE", Numbers::kLeastCone);
  add("TL_LOOSEST_TOLERANCE", Numbers::kLoosestTolerance);
  add("TL_CONTRADICTION", Numbers::kContradiction);
  add("TL_RANK_TOLERANCE", Numbers::kRankTolerance);
  add("TL_HIERARCHY", Numbers::kHierarchy);
  add("TL_NO_LIMIT", Numbers::kNoLimit);
  add("TL_SLACK_PENALTY", Numbers::kSlackPenalty);
}

Adaptation make_limit_adaptation(const EmissionContext& context) {
  Adaptation own = make_adaptation(context, header_name(context, context.name + "_limited"));
  const Backend& backend = backend_of(context.language);
  if (!backend.composes_in_headers) own.words["torque_limits"] = context.name + "_limited";
  // square_root.hpp of C++ has the root of any number, and NaN where there is none.
  if (backend.has_references && !context.misra) own.words["tl_root"] = "square_root";
  own.words["TL_SHARES"] = context.limits->has_shares() ? "1" : "0";
  if (context.batch > 0) own.words["TL_STATES"] = std::to_string(context.batch);
  if (context.single_precision) {
    add_numbers<float>(context, own);
  } else {
    add_numbers<double>(context, own);
  }
  return own;
}

std::string print_limit_sizes(const EmissionContext& context, const Adaptation& own) {
  return print_sizes(context.name, own,
                     "#pragma once\n// Sizes of arrays that limited_torque.h computes in.\n\n"
                     "#include \"torque_limits.h\"\n\nTL_CONSTANTS",
                     list_array_sizes(context));
}

}  // namespace

std::string print_limit_types(const EmissionContext& context) {
  Adaptation own = make_limit_adaptation(context);
  const Entries entries(context);
  own.words["TL_TASK_ENTRIES"] = std::to_string(entries.tasks);
  own.words["TL_CONE_ENTRIES"] = std::to_string(entries.cones);
  return fmt::format(
      "{}\n/// What became of the limits. Torques are within theirs whatever it is, but for NaN, "
      "which stays.\n{}\n/// Which side of a row of the program is active.\n{}\n{}",
      print_constants(own, list_sizes(context)), print_constants(own, kOutcomes),
      print_constants(own, kSides), adapt_declarations(templates::kTorqueLimits, own));
}

std::vector<GeneratedFile> print_limit_headers(const EmissionContext& context) {
  const Adaptation own = make_limit_adaptation(context);
  const std::pair<const char*, std::string_view> headers[] = {
      {"limited_torque", templates::kLimitedTorque},
      {"limit_program", templates::kLimitProgram},
      {"force_basis", templates::kForceBasis},
      {"enter_rows", templates::kEnterRows},
      {"quadratic_program", templates::kQuadraticProgram},
      {"eights", context.misra ? templates::kEightsWrittenOut : templates::kEights}};
  std::vector<GeneratedFile> files;
  for (const auto& [name, text] : headers) {
    files.push_back({header_name(context, name), adapt(text, own)});
  }
  files.push_back({header_name(context, "limit_sizes"), print_limit_sizes(context, own)});
  if (context.batch > 0) {
    files.push_back(
        {header_name(context, "limited_states"), adapt(templates::kLimitedStates, own)});
  }
  if (backend_of(context.language).composes_in_headers) {
    files.push_back({"torque_limits.hpp", fill_template(templates::kTorqueLimitsInCpp,
                                                        {{"name", context.name},
                                                         {"types", print_limit_types(context)}})});
  }
  return files;
}

}  // namespace treeline
