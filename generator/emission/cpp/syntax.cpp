#include <fmt/format.h>

#include "emission/c_family_syntax.hpp"
#include "emission/cpp/print_files.hpp"

namespace treeline::cpp {
namespace {

std::string name_lanes(const Syntax& /*own*/, std::size_t count) {
  return fmt::format("Lanes<{}>", count);
}

std::string make_pack(const Syntax& /*own*/, std::size_t /*count*/, const std::string& list) {
  return fmt::format("detail::make_pack<Real>({})", list);
}

std::string name_lane(const Syntax& /*own*/, std::size_t /*count*/, const std::string& value,
                      std::size_t index) {
  return fmt::format("{}[{}]", value, index);
}

/// States are copied by a function that makes no call of memcpy.
std::string copy_states(const std::string& element) {
  return fmt::format("detail::copy_of({})", element);
}

std::vector<std::string> call_sin_cos(const Syntax& own, const std::string& suffix,
                                      std::size_t count, const std::string& list) {
  return {fmt::format("const {} angles{}[{}] = {{{}}};", own.number, suffix, count, list),
          fmt::format("{} sines{}[{}];", own.number, suffix, count),
          fmt::format("{} cosines{}[{}];", own.number, suffix, count),
          fmt::format("{1}(angles{0}, sines{0}, cosines{0});", suffix, own.sin_cos)};
}

}  // namespace

Syntax make_syntax(bool single_precision) {
  Syntax syntax = make_c_family_syntax(single_precision);
  syntax.number = "Real";
  syntax.lanes = name_lanes;
  syntax.make_lanes = make_pack;
  syntax.lane = name_lane;
  syntax.take_sines = call_sin_cos;
  syntax.sin_cos = "detail::sin_cos";
  return syntax;
}

Syntax make_syntax(const EmissionContext& context) {
  Syntax syntax = make_syntax(context.single_precision);
  if (context.misra) follow_misra(context.single_precision, syntax);
  return syntax;
}

Syntax make_states_syntax(const EmissionContext& context) {
  Syntax syntax = make_syntax(context);
  syntax.number = "States";
  syntax.names_constants = false;
  syntax.read = copy_states;
  syntax.sin_cos = "detail::sin_cos_states<Real, kStates>";
  return syntax;
}

}  // namespace treeline::cpp
