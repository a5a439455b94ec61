// Writes the sample folder: emit_sample DIRECTORY NAME double|float
#include <cstdio>
#include <string>

#include "emission/sample.hpp"
#include "emission/write_files.hpp"

int main(int argc, char** argv) {
  if (argc != 4) {
    return 2;
  }
  treeline::Diagnostics diagnostics;
  const bool single_precision = std::string(argv[3]) == "float";
  const auto files = treeline::emit(treeline::test::sample_context(argv[2], single_precision),
                                    treeline::test::sample_programs(), diagnostics);
  const bool written = !files.empty() && treeline::write_files(argv[1], files, diagnostics);
  for (const treeline::Diagnostic& diagnostic : diagnostics.list()) {
    std::fprintf(stderr, "%s: %s\n", diagnostic.element.c_str(), diagnostic.fault.c_str());
  }
  return written ? 0 : 1;
}
