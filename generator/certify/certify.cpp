#include "certify/certify.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "certify/ask_gappa.hpp"
#include "certify/bound_in_steps.hpp"
#include "certify/proof_step.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/print_files.hpp"

namespace treeline {
namespace {

using Clock = StepBounds::Clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Why the function has no proof of this kind. Empty: it may have one.
std::string reason_to_skip(const GeneratedFunction& function) {
  if (!function.rounding.is_proven()) return "the header states no proven bound";
  const std::vector<Node>& nodes = function.program.graph.nodes();
  const bool divides =
      std::any_of(nodes.begin(), nodes.end(), [](const Node& n) { return n.op == Op::div; });
  return divides ? "it divides, by the length of a quaternion" : "";
}

/// The largest error of each result, proven and stated.
std::vector<CertifiedResult> compare(const GeneratedFunction& function, const StepBounds& bounds) {
  std::vector<CertifiedResult> results;
  std::size_t entry = 0;
  for (const Result& result : function.program.results) {
    CertifiedResult& worst = results.emplace_back();
    worst.name = result.argument.name;
    for (const Expression& value : result.values) {
      worst.proven = std::max(worst.proven, bounds.of(value.node()).error.value);
      worst.stated = std::max(worst.stated, function.rounding.error.at(entry++));
    }
  }
  return results;
}

class Certifier {
 public:
  Certifier(const Scene& scene, const Generation& generation, const CertifyOptions& options,
            const std::filesystem::path& work, Diagnostics& diagnostics)
      : generation_(generation),
        options_(options),
        work_(work),
        gappa_(work, scene.real == Real::float32 ? Precision::binary32 : Precision::binary64),
        diagnostics_(diagnostics) {}

  /// Returns false if proofs cannot be written.
  bool certify(const GeneratedFunction& function, CertifiedFunction& to) {
    to.name = function.program.name;
    to.skipped = reason_to_skip(function);
    if (!to.skipped.empty()) return true;
    if (options_.tell) options_.tell(to.name);
    const auto start = Clock::now();
    const auto limit = std::chrono::duration<double>(options_.seconds);
    StepBounds bounds(function.program, generation_.domain, gappa_,
                      start + std::chrono::duration_cast<Clock::duration>(limit));
    try {
      bounds.prove();
      to.results = compare(function, bounds);
    } catch (const ProofEnded& ended) {
      to.failed = ended.what();
    }
    to.steps = bounds.steps().size();
    to.seconds = seconds_since(start);
    if (!options_.folder.empty() &&
        !write_proofs(options_.folder, to.name, bounds.steps(), gappa_.precision(), diagnostics_)) {
      return false;
    }
    return !options_.coq || !to.failed.empty() || check_with_coq(bounds.steps(), to);
  }

 private:
  /// False, with an error, if the proof cannot be written.
  bool check_with_coq(const std::vector<ProofStep>& steps, CertifiedFunction& to) {
    const auto start = Clock::now();
    const auto proof = print_coq(gappa_, steps);
    const std::filesystem::path file = work_ / (to.name + ".v");
    if (proof) {
      const auto kept = options_.folder / (to.name + ".v");
      if (!write_work_file(file, *proof, diagnostics_)) return false;
      if (!options_.folder.empty() && !write_work_file(kept, *proof, diagnostics_)) return false;
    }
    to.checked_by_coq = proof && accepts(file, work_);
    if (!to.checked_by_coq) to.failed = "Coq does not accept the proof";
    to.coq_seconds = seconds_since(start);
    return true;
  }

  const Generation& generation_;
  const CertifyOptions& options_;
  std::filesystem::path work_;
  Gappa gappa_;
  Diagnostics& diagnostics_;
};

}  // namespace

bool CertifiedFunction::passed(double within) const {
  return failed.empty() && std::all_of(results.begin(), results.end(), [&](const auto& result) {
           return result.ratio() <= within;
         });
}

bool Certificate::passed() const {
  bool tried = false;
  for (const CertifiedFunction& function : functions) {
    tried = tried || function.skipped.empty();
    if (!function.passed(within)) return false;
  }
  return tried;
}

std::optional<Certificate> certify(const Scene& scene, const Generation& generation,
                                   const CertifyOptions& options, Diagnostics& diagnostics) {
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  Certificate certificate;
  const auto gappa = find_gappa(work->path(), diagnostics);
  const auto coq = options.coq ? find_coq(work->path(), diagnostics) : std::string();
  if (!gappa || !coq) return std::nullopt;
  certificate.name = scene.name;
  certificate.digest = digest_of_files(generation.files);
  certificate.gappa = *gappa;
  certificate.coq = *coq;
  certificate.domain = describe_domain(generation);
  certificate.single_precision = scene.real == Real::float32;
  certificate.within = options.within;
  Certifier certifier(scene, generation, options, work->path(), diagnostics);
  for (const GeneratedFunction& function : generation.functions) {
    if (!certifier.certify(function, certificate.functions.emplace_back())) return std::nullopt;
  }
  return certificate;
}

}  // namespace treeline
