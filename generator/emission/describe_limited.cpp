#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "emission/comment.hpp"
#include "emission/costs.hpp"
#include "emission/descriptions.hpp"
#include "passes/count_operations.hpp"

namespace treeline {
namespace {

const Program& find_program(std::span<const Program> programs, const std::string& name) {
  const auto found = std::find_if(programs.begin(), programs.end(),
                                  [&](const Program& each) { return each.name == name; });
  if (found == programs.end()) throw std::logic_error("limited lacks " + name);
  return *found;
}

template <class Number, class Print>
std::string print_numbers(const std::vector<Number>& numbers, const Print& print) {
  std::string list;
  for (const Number& number : numbers) list.append(list.empty() ? "" : ", ").append(print(number));
  return fmt::format("{{{}}}", list.empty() ? print(Number{}) : list);
}

std::string describe_stack(const EmissionContext& context, int values) {
  return fmt::format("Stack, an estimate: {} values, {} bytes, and what calls take.", values,
                     values * number_bytes(context));
}

/// Statements that declare `layout`, the constant one with the shares that the arguments give.
std::string print_shares(const EmissionContext& context, const Program& supported,
                         const ShareWords& words) {
  std::string text = fmt::format("{} layout;\n{}take_whole(&{}, &layout);\n", words.type,
                                 words.scope, words.whole);
  const std::pair<const char*, const char*> kinds[] = {{"active", "share_supports"},
                                                       {"active_tasks", "share_tasks"}};
  const auto address = [&](const std::string& array, const char* first) {
    return words.by_address ? fmt::format("&{}{}", array, first) : array;
  };
  for (const auto& [symbol, function] : kinds) {
    for (const Argument& argument : supported.arguments) {
      if (argument.name != symbol) continue;
      std::string name = argument.name;
      if (words.of_batch) {
        name += "_k";
        text += fmt::format("{0} {1}[{2}];\n{3}take_state({4}, {2}, k, {5});\n",
                            number_type(context), name, argument.rows, words.scope,
                            address(argument.name, "[0][0]"), address(name, "[0]"));
      }
      text += fmt::format("{}{}({}, &layout);\n", words.scope, function, address(name, "[0]"));
    }
  }
  return text;
}

}  // namespace

const Program& find_supported(std::span<const Program> programs) {
  return find_program(programs, "supported_control_torque");
}

std::vector<LimitedCall> list_limited_calls(const EmissionContext& context,
                                            std::span<const Program> programs) {
  std::vector<LimitedCall> calls = {{&find_program(programs, "mass_matrix"), "M"}};
  if (holds_rows(context)) {
    calls.push_back({&find_program(programs, "constraint_jacobian"), "J_s"});
  }
  if (context.task_rows > 0) calls.push_back({&find_program(programs, "jacobian"), "J_t"});
  return calls;
}

bool holds_rows(const EmissionContext& context) {
  return !context.limits->force_weights.empty();
}

int count_freedoms(const LimitFacts& facts) {
  return std::max(facts.freedoms, 1);
}

std::string describe_limited_cost(const EmissionContext& context,
                                  std::span<const Program> programs) {
  const LimitFacts& facts = *context.limits;
  const LimitCost cost = cost_of_limits(facts, context.velocities);
  const int flops = count_operations(find_supported(programs)).flops();
  const std::string work = wrap_text(
      fmt::format("Cost: {} flops where no limit is reached. Else a quadratic program of {} "
                  "unknowns and {} rows: at most {} steps of at most {} flops.",
                  flops, cost.unknowns, cost.rows, cost.iterations, cost.flops_of_iteration),
      95);
  return work + "\n" + describe_stack(context, cost.values);
}

std::string describe_batch_limited_cost(const EmissionContext& context,
                                        std::span<const Program> batch) {
  int entries = 0;
  for (const LimitedCall& call : list_limited_calls(context, batch)) {
    const Argument& matrix = call.program->results.front().argument;
    entries += matrix.rows * matrix.cols;
  }
  const LimitCost cost = cost_of_limits(*context.limits, context.velocities);
  return wrap_text(
             fmt::format("Cost: {} flops for each of {} states. Where a limit is reached in one, "
                         "the matrices of all are computed together, and the programs of those "
                         "that need it are solved one after the other.",
                         count_operations(find_supported(batch)).flops(), context.batch),
             95) +
         "\n" + describe_stack(context, cost.values + context.batch * entries);
}

std::string describe_cones(const LimitFacts& facts) {
  std::string text;
  for (const std::string& note : facts.notes) {
    if (!text.empty()) text += "\n";
    text += wrap_text(note + ".", 95);
  }
  return text.empty() ? "No forces are limited." : text;
}

void add_share_holes(const EmissionContext& context, const Program& supported,
                     const ShareWords& words, std::map<std::string, std::string>& holes) {
  const bool shares = context.limits->has_shares();
  holes["shares"] = shares ? print_shares(context, supported, words) : "";
  holes["own_layout"] = shares ? "layout" : words.whole;
  holes["of_layout"] = shares ? "&layout, " : "";
}

std::string print_torque_limits(const LimitFacts& facts, const Syntax& syntax,
                                const std::string& no_limit, const std::string& no_cones) {
  const auto literal = [&](double x) { return std::isfinite(x) ? syntax.literal(x) : no_limit; };
  std::string cones;
  for (const LimitFacts::Row& row : facts.cones) {
    std::vector<double> coefficients = row.coefficients;
    coefficients.resize(6);
    cones += fmt::format("{}{{{}, {}, {}, {}}}", cones.empty() ? "" : ", ", row.first,
                         row.coefficients.size(), print_numbers(coefficients, literal),
                         literal(row.bound));
  }
  return fmt::format("{}, {{{}}}, {}", print_numbers(facts.torque, literal),
                     cones.empty() ? no_cones : cones, print_numbers(facts.task_weights, literal));
}

std::string print_support_layout(const LimitFacts& facts, const Syntax& syntax) {
  const auto integer = [](int each) { return std::to_string(each); };
  const auto literal = [&](double x) { return syntax.literal(x); };
  const std::string fixed =
      print_numbers(facts.passive, integer) + ", " + print_numbers(facts.force_weights, literal);
  if (!facts.has_shares()) return fixed;
  const auto ones = [](const std::vector<int>& rows) {
    return std::vector<double>(std::max<std::size_t>(rows.size(), 1), 1.0);
  };
  const auto shares = [&](const std::vector<int>& rows) {
    return print_numbers(rows.empty() ? std::vector<int>{-1} : rows, integer);
  };
  return fmt::format("{}, {}, {}, {}, {}", fixed, shares(facts.held_shares),
                     shares(facts.task_shares), print_numbers(ones(facts.held_shares), literal),
                     print_numbers(ones(facts.task_shares), literal));
}

}  // namespace treeline
