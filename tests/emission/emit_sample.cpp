// Writes the sample folder: emit_sample DIRECTORY NAME double|float c++|c|opencl [misra].
#include <cstdio>
#include <string>

#include "description/scene_words.hpp"
#include "emission/emit.hpp"
#include "emission/print_files.hpp"
#include "emission/sample.hpp"
#include "emission/write_files.hpp"

int main(int argc, char** argv) {
  const bool misra = argc == 6 && std::string(argv[5]) == "misra";
  if (argc != 5 && !misra) {
    return 2;
  }
  treeline::Diagnostics diagnostics;
  const bool single_precision = std::string(argv[3]) == "float";
  const auto language = treeline::value_of_word<treeline::Language>(argv[4]).value();
  const bool is_c = language == treeline::Language::c;
  const bool is_plain = misra || language == treeline::Language::opencl;
  treeline::EmissionContext context =
      treeline::test::sample_context(argv[2], single_precision, language);
  context.misra = misra;
  context.batch = is_plain ? 0 : treeline::test::kSampleBatch;
  if (is_c && !misra) context.lanes = 8;
  // Batches in vectors, those in float in loops.
  context.asks_for_lanes = is_c && !single_precision;
  auto programs = misra ? treeline::test::safe_programs() : treeline::test::sample_programs();
  if (is_plain) {
    for (treeline::Program& program : programs) program.packs.clear();
  }
  std::vector<treeline::Program> batch;
  if (context.batch > 0) batch = programs;
  for (treeline::Program& program : batch) program.packs.clear();
  auto files = treeline::emit(context, programs, diagnostics, batch);
  if (is_c || misra) {  // the loops of damped control, which these functions do without
    for (auto& file : treeline::print_damped_headers(context)) files.push_back(file);
    files.push_back(treeline::print_square_root(context));
  }
  const bool written = !files.empty() && treeline::write_files(argv[1], files, diagnostics);
  for (const treeline::Diagnostic& diagnostic : diagnostics.list()) {
    std::fprintf(stderr, "%s: %s\n", diagnostic.element.c_str(), diagnostic.fault.c_str());
  }
  return written ? 0 : 1;
}
