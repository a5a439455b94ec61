#include <fmt/format.h>

#include <utility>

#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/controller_faults.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// What stands for a place in the arguments of the robot's functions.
void add_arrays(const EmissionContext& context, Adaptation& own) {
  const bool references = backend_of(context.language).has_references;
  const auto add = [&](const std::string& word, const std::string& type) {
    const std::string passed = references ? type + "&" : own.words["real"] + "*";
    own.words["Tl" + word + "In"] = "const " + passed;
    own.words["Tl" + word + "Out"] = passed;
  };
  add("Joints", "JointArray");
  add("Rows", "RowArray");
  add("Forces", "ForceArray");
}

/// Enumerators of NAME_controller.h as numbers of the types that the step has.
void add_enumerators(const EmissionContext& context, Adaptation& own) {
  const Backend& backend = backend_of(context.language);
  const bool scoped = backend.has_namespaces;  // then enumerators are numbers of their own type
  const std::string name = name_in_capitals(context);
  const std::string_view header = templates::kControllerHeader;
  constexpr std::string_view kPrefix = "{{NAME}}_";
  for (std::size_t at = header.find(kPrefix); at != header.npos; at = header.find(kPrefix, at)) {
    at += kPrefix.size();
    const std::size_t end = header.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_", at);
    const std::string word(header.substr(at, end - at));
    if (word == "JOINTS" || word == "POINTS") continue;
    own.words["TL_" + word] = fmt::format("{}{}_{}", scoped ? "" : "(int32_t)", name, word);
  }
  const std::string cast =
      fmt::format(fmt::runtime(backend.cast), "uint32_t") + (scoped ? "({})" : "{}");
  std::string untrusted;
  for (const ControllerFault& fault : kControllerFaults) {
    const std::string bit =
        fmt::format(fmt::runtime(cast), fmt::format("{}_FAULT_{}", name, fault.name));
    own.words[fmt::format("TL_FAULT_{}", fault.name)] = bit;
    if (!fault.asks_brakes_at_once()) continue;
    untrusted += (untrusted.empty() ? "" : " |\n      ") + bit;
  }
  own.words["TL_FAULTS_UNTRUSTED"] = untrusted;
}

}  // namespace

Adaptation adapt_controller(const EmissionContext& context, const ControllerUnit& unit,
                            bool for_reference) {
  const auto cast = [&](const std::string& type) {
    return fmt::format(fmt::runtime(backend_of(context.language).cast), type);
  };
  Adaptation own = make_adaptation(context, context.name + "_controller.h");
  own.constants_of_c = true;
  if (for_reference) {
    for (const char* word : {"real", "TL_REAL"}) own.words[word] = "Real";
    for (const auto& [word, digits] : {std::pair("ZERO", 0), {"ONE", 1}, {"TEN", 10}}) {
      own.words[fmt::format("TL_{}", word)] = fmt::format("Real({})", digits);
    }
  }
  for (const char* type : {"Config", "Command", "Input", "Output", "State", "Mailbox"}) {
    own.words[fmt::format("Tl{}", type)] = fmt::format("{}_{}", context.name, in_snake_case(type));
  }
  own.words["TL_INLINE"] = "static inline";  // compilers inline what is called once
  own.words["TL_AS_INDEX"] = cast("int32_t");
  own.words["TL_AS_REAL"] = cast(own.words["real"]);
  own.words["TL_ARCTANGENT_TERMS"] = context.single_precision ? "4" : "11";
  own.words["TL_SERIES_TERMS"] = context.single_precision ? "9" : "15";
  own.words["TL_TASK"] = unit.task_torque ? "1" : "0";
  own.words["TL_CURRENT"] = unit.tells_currents() ? "1" : "0";
  own.words["TL_BEHAVES"] = unit.behaves() ? "1" : "0";
  own.words["TL_FORCE"] = unit.settings.force ? "1" : "0";
  if (context.misra) own.words["tl_square_root"] = adapt_words("tl_root", own);
  add_arrays(context, own);
  add_enumerators(context, own);
  return own;
}

}  // namespace treeline
