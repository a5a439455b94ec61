#include <nlohmann/json.hpp>

#include "certify/certify.hpp"
#include "emission/generated_file.hpp"
#include "text/json_text.hpp"

namespace treeline {

std::string print_json(const Certificate& certificate) {
  using nlohmann::ordered_json;
  ordered_json functions = ordered_json::array();
  for (const CertifiedFunction& function : certificate.functions) {
    ordered_json one{{"name", function.name}};
    if (!function.skipped.empty()) {
      one["skipped"] = function.skipped;
      functions.push_back(one);
      continue;
    }
    for (const CertifiedResult& result : function.results) {
      one["results"].push_back({{"name", result.name},
                                {"proven", result.proven},
                                {"stated", result.stated},
                                {"ratio", result.ratio()}});
    }
    one["steps"] = function.steps;
    one["seconds"] = function.seconds;
    if (!certificate.coq.empty()) {
      one["checked_by_coq"] = function.checked_by_coq;
      one["coq_seconds"] = function.coq_seconds;
    }
    if (!function.failed.empty()) one["failed"] = function.failed;
    one["passed"] = function.passed(certificate.within);
    functions.push_back(one);
  }
  ordered_json json{
      {"name", certificate.name},       {"generator", generator_version()},
      {"digest", certificate.digest},   {"real", certificate.single_precision ? "float" : "double"},
      {"gappa", certificate.gappa},     {"coq", certificate.coq},
      {"domain", certificate.domain},   {"within", certificate.within},
      {"passed", certificate.passed()}, {"functions", functions}};
  return json_text(json);
}

}  // namespace treeline
