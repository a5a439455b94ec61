#include "emission/c/syntax.hpp"

#include <fmt/format.h>

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

}  // namespace

Syntax make_syntax(const EmissionContext& context) {
  Syntax syntax = make_c_family_syntax(context.single_precision);
  syntax.parentheses = Parentheses::products;
  if (context.misra) follow_misra(context.single_precision, syntax);
  syntax.number = context.single_precision ? "float" : "double";
  syntax.prefix = context.name;
  syntax.lanes = name_lanes;
  syntax.make_lanes = make_vector;
  syntax.take_sines = call_sin_cos;
  syntax.sin_cos = context.name + "_sin_cos";
  return syntax;
}

}  // namespace treeline::c
