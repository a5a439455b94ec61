#include <fmt/format.h>

#include <cctype>

#include "emission/c/print_files.hpp"
#include "emission/c_family_syntax.hpp"

namespace treeline::c {
namespace {

std::string name_lanes(const Syntax& own, std::size_t count) {
  return fmt::format("{}_lanes_{}", own.prefix, count);
}

std::string make_lanes(const Syntax& own, std::size_t count, const std::string& list) {
  return fmt::format("{}_make_{}({})", own.prefix, count, list);
}

std::string spread_lanes(const Syntax& own, std::size_t count, const std::string& number) {
  return fmt::format("{}_spread_{}({})", own.prefix, count, number);
}

std::string name_lane(const Syntax& own, std::size_t count, const std::string& value,
                      std::size_t index) {
  return fmt::format("{}_lane_{}({}, {})", own.prefix, count, value, index);
}

std::string call_operation(const Syntax& own, std::size_t count, Op op, const std::string& a,
                           const std::string& b) {
  return fmt::format("{}_{}_{}({}{}{})", own.prefix, operation(op).name, count, a,
                     b.empty() ? "" : ", ", b);
}

std::vector<std::string> call_sin_cos(const Syntax& own, const std::string& suffix,
                                      std::size_t count, const std::string& list) {
  return {fmt::format("const {} angles{}[{}] = {{{}}};", own.number, suffix, count, list),
          fmt::format("{} sines{}[{}];", own.number, suffix, count),
          fmt::format("{} cosines{}[{}];", own.number, suffix, count),
          fmt::format("{2}({1}, angles{0}, sines{0}, cosines{0});", suffix, count, own.sin_cos)};
}

/// One number for all states is a vector from which nothing is subtracted.
std::string store_states(const Syntax& own, const std::string& target, const std::string& value) {
  const std::size_t first = value.find_first_not_of("-");
  const bool is_number = std::isdigit(static_cast<unsigned char>(value.at(first))) != 0;
  return is_number ? fmt::format("{} = {} - ({}){{{}}};", target, value, own.number, own.literal(0))
                   : fmt::format("{} = {};", target, value);
}

}  // namespace

Syntax make_syntax(const EmissionContext& context) {
  Syntax syntax = make_c_family_syntax(context.single_precision);
  syntax.parentheses = Parentheses::products;
  if (context.misra) follow_misra(context.single_precision, syntax);
  syntax.number = number_type(context);
  syntax.prefix = context.name;
  syntax.lanes = name_lanes;
  syntax.make_lanes = make_lanes;
  syntax.spread = spread_lanes;
  syntax.lane = name_lane;
  syntax.combine_lanes = call_operation;
  syntax.take_sines = call_sin_cos;
  syntax.sin_cos = context.name + "_sin_cos";
  return syntax;
}

Syntax make_states_syntax(const EmissionContext& context) {
  Syntax syntax = make_syntax(context);
  syntax.number = context.name + "_states";
  syntax.names_constants = false;
  syntax.store = store_states;
  syntax.sin_cos = context.name + "_sin_cos_states";
  return syntax;
}

}  // namespace treeline::c
