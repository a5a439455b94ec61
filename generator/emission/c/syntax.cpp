#include "emission/c/syntax.hpp"

#include <fmt/format.h>

#include <cctype>

#include "emission/c_family_syntax.hpp"

namespace treeline::c {
namespace {

std::string name_lanes(const Syntax& own, std::size_t count) {
  return fmt::format("{}_lanes_{}", own.prefix, count);
}

std::string make_vector(const Syntax& own, std::size_t count, const std::string& list) {
  return fmt::format("({}){{{}}}", name_lanes(own, count), list);
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
  syntax.make_lanes = make_vector;
  syntax.take_sines = call_sin_cos;
  syntax.sin_cos = context.name + "_sin_cos";
  return syntax;
}

Syntax make_states_syntax(const EmissionContext& context) {
  Syntax syntax = make_syntax(context);
  syntax.number = context.name + "_states";
  syntax.store = store_states;
  syntax.sin_cos = context.name + "_sin_cos_states";
  return syntax;
}

}  // namespace treeline::c
