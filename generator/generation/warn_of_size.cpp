#include <fmt/format.h>

#include <algorithm>

#include "description/scene_inputs.hpp"
#include "emission/descriptions.hpp"
#include "generation/warnings.hpp"
#include "passes/count_operations.hpp"
#include "program/ending.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

constexpr double kFelt = 60;  ///< s that are worth a warning

/// The function that takes a compiler the longest, and all together.
struct Burden {
  const GeneratedFunction* longest = nullptr;
  int flops = 0;       ///< of the longest
  double seconds = 0;  ///< of all
};

Burden weigh(const std::vector<GeneratedFunction>& functions) {
  Burden burden;
  for (const GeneratedFunction& generated : functions) {
    if (generated.program.loops) continue;
    const int flops = count_operations(printed_lines(generated.program)).flops();
    burden.seconds += estimate_compile_seconds(flops);
    if (flops <= burden.flops) continue;
    burden.flops = flops;
    burden.longest = &generated;
  }
  return burden;
}

double count_megabytes(const std::vector<GeneratedFile>& files) {
  double bytes = 0;
  for (const GeneratedFile& file : files) bytes += static_cast<double>(file.text.size());
  return bytes / 1e6;
}

std::string describe_remedy(const Scene& scene, const GeneratedFunction& longest) {
  const bool may_loop = scene.optimize != Optimize::size && longest.batch == 0 &&
                        has_loop_form(longest.function) &&
                        !takes_input(scene, longest.function, Quantity::active_tasks);
  const std::string loops =
      may_loop ? "`optimize: size` makes loops over links of it. " : std::string();
  return loops +
         "Leave functions out (key `functions`), hold joints that the task does not need (key "
         "`locked`), or have axes exact (key `snap_angles`): each makes it shorter.";
}

}  // namespace

// Of ergoCub on a floating base, on one core at 2.4 GHz, g++ 12 compiles by -O2 15,704 operations
// in 9 s, 23,006 in 5 s, 78,688 in 139 s (1.5 GB); 388,316 it had not after half an hour.
double estimate_compile_seconds(int flops) {
  constexpr double kOfOperation = 4e-4, kOfSquare = 2e-8;
  return flops * (kOfOperation + kOfSquare * flops);
}

void warn_of_size(const Scene& scene, const Generation& generation, Diagnostics& diagnostics) {
  const std::vector<GeneratedFunction> functions = all_functions(generation);
  const Burden burden = weigh(functions);
  if (burden.seconds < kFelt) return;
  const GeneratedFunction& longest = *burden.longest;
  const std::string level =
      is_huge(longest.program) ? ", though by no more than -O1, as CMakeLists.txt has it" : "";
  diagnostics.add(
      {Severity::warning, scene.file, 0, source_stem(longest),
       fmt::format(
           "{} operations; of the {:.1f} MB of source a compiler takes about {:.0f} minutes "
           "of processor time{}",
           burden.flops, count_megabytes(generation.files), std::max(1.0, burden.seconds / 60),
           level),
       describe_remedy(scene, longest)});
}

}  // namespace treeline
