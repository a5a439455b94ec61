#include <fmt/format.h>

#include <algorithm>

#include "certify/certify.hpp"
#include "text/round_outward.hpp"

namespace treeline {
namespace {

std::string print_function(const CertifiedFunction& function, double within) {
  if (!function.skipped.empty()) {
    return fmt::format("{:<30} not tried: {}\n", function.name, function.skipped);
  }
  std::string text;
  for (const CertifiedResult& result : function.results) {
    const std::string name = text.empty() ? function.name : "";
    text += fmt::format("{:<30} {:<16} {:>9} {:>9} {:>6.2f}", name, result.name,
                        rounded_up(result.proven, 3), rounded_up(result.stated, 3), result.ratio());
    if (name.empty()) {
      text += "\n";
      continue;
    }
    text += fmt::format(" {:>6} {:>8.1f}", function.steps, function.seconds);
    if (function.checked_by_coq) text += fmt::format(" {:>8.1f}", function.coq_seconds);
    text += "\n";
  }
  if (!function.failed.empty()) {
    text += fmt::format("{:<30} FAILED after {} steps: {}\n", function.name, function.steps,
                        function.failed);
  } else if (!function.passed(within)) {
    text += fmt::format("{:<30} FAILED: proven only to more than {:g} times what is stated\n",
                        function.name, within);
  }
  return text;
}

}  // namespace

std::string print_text(const Certificate& certificate) {
  std::string text = fmt::format(
      "{}, {}: absolute rounding errors, proven by {}{}{}\n"
      "for {}\n\n{:<30} {:<16} {:>9} {:>9} {:>6} {:>6} {:>8}{}\n",
      certificate.name, certificate.single_precision ? "float" : "double", certificate.gappa,
      certificate.coq.empty() ? "" : ", each step checked by ", certificate.coq, certificate.domain,
      "function", "result", "proven", "stated", "ratio", "steps", "s",
      certificate.coq.empty() ? "" : fmt::format(" {:>8}", "Coq s"));
  for (const CertifiedFunction& function : certificate.functions) {
    text += print_function(function, certificate.within);
  }
  const auto tried = std::count_if(certificate.functions.begin(), certificate.functions.end(),
                                   [](const auto& each) { return each.skipped.empty(); });
  return text + (certificate.passed()
                     ? fmt::format("\nproven: {} of {} functions, within {:g} times the bounds "
                                   "that the header states\n",
                                   tried, certificate.functions.size(), certificate.within)
                     : std::string(tried == 0 ? "\nno function has a proof to try\n"
                                              : "\nnot proven as stated\n"));
}

}  // namespace treeline
