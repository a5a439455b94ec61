#include "facts.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "case.hpp"

namespace treeline::bench {
namespace {

using Json = nlohmann::json;

Json read_json(const std::string& path) {
  std::ifstream file(path);
  Json json = Json::parse(file, nullptr, false);
  return json.is_object() ? json : Json::object();
}

}  // namespace

Facts read_facts(const Subject& subject, const std::string& function) {
  Facts facts;
  for (const Json& entry :
       read_json(subject.facts + "/manifest.json").value("functions", Json::array())) {
    if (entry.value("name", "") == function) {
      facts.method = entry.value("method", "");
      facts.flops = entry.value("flops", 0L);
      facts.divisions = entry.value("div", 0L);
      facts.sin_cos = entry.value("sin_cos", 0L);
    }
  }
  const Json compiled = read_json(subject.facts + "/" + subject.source_prefix + function + ".json");
  facts.code_bytes = compiled.value("code_bytes", 0L);
  facts.stack_bytes = compiled.value("stack_bytes", 0L);
  facts.compile_seconds = compiled.value("seconds", 0.0);
  facts.compile_mib = compiled.value("peak_mib", 0.0);
  return facts;
}

Compilation read_compilation(const Subject& subject) {
  Compilation all;
  for (const auto& [function, routine] : subject.routines) {
    const Facts facts = read_facts(subject, name_of(function));
    all.functions += 1;
    all.code_bytes += facts.code_bytes;
    all.seconds += facts.compile_seconds;
    all.peak_mib = std::max(all.peak_mib, facts.compile_mib);
  }
  const Json generated = read_json(subject.facts + ".generation.json");
  all.generation_seconds = generated.value("seconds", 0.0);
  all.generation_mib = generated.value("peak_mib", 0.0);
  return all;
}

}  // namespace treeline::bench
