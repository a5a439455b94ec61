#include "board/run_board.hpp"

#include <fmt/format.h>

#include <cstring>
#include <fstream>

#include "board/print_harness.hpp"
#include "board/templates.hpp"
#include "compilation/print_step_entry.hpp"
#include "compilation/write_work_file.hpp"
#include "oracle/graph_run.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStatesFile = "states.bin";
constexpr const char* kResultsFile = "results.bin";
constexpr const char* kTapeFile = "steps.bin";

/// Seconds that a program may take. It ends by itself much earlier.
constexpr const char* kPatience = "900";

template <class T>
void append_number(double value, std::string& bytes) {
  const T number = static_cast<T>(value);
  char raw[sizeof(T)];
  std::memcpy(raw, &number, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// All arguments of all functions at all states, as the target has them in memory: both are
/// little-endian.
std::string pack_states(const std::vector<GeneratedFunction>& functions,
                        const std::vector<State>& states, Real real) {
  const std::vector<StatePlace> places = place_arguments(functions);
  std::string bytes;
  for (const State& state : states) {
    for (const StatePlace& place : places) {
      for (const double value : values_of(state, *find_quantity(place.name))) {
        real == Real::float32 ? append_number<float>(value, bytes)
                              : append_number<double>(value, bytes);
      }
    }
  }
  return bytes;
}

/// Reads numbers from the bytes that the program has written.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <class T>
  T take() {
    T value{};
    if (at_ + sizeof(T) > bytes_.size()) {
      complete_ = false;
      return value;
    }
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  [[nodiscard]] bool read_all() const { return complete_ && at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
  bool complete_ = true;
};

BoardCalls read_calls(int outputs, std::size_t states, Real real, Reader& reader) {
  BoardCalls calls;
  calls.stack_seen = reader.take<std::uint64_t>();
  for (std::size_t s = 0; s < states; ++s) {
    calls.instructions.push_back(reader.take<std::uint64_t>());
    std::vector<double>& results = calls.results.emplace_back();
    for (int i = 0; i < outputs; ++i) {
      results.push_back(real == Real::float32 ? static_cast<double>(reader.take<float>())
                                              : reader.take<double>());
    }
  }
  return calls;
}

StepCalls read_steps(const StepTape& tape, Reader& reader) {
  StepCalls calls;
  for (std::size_t step = 0; step < tape.results.size(); ++step) {
    calls.instructions.push_back(reader.take<std::uint64_t>());
    std::vector<double>& results = calls.results.emplace_back();
    for (std::size_t i = 0; i < tape.output_size + tape.state_size; ++i) {
      results.push_back(reader.take<double>());
    }
  }
  calls.stack_seen = reader.take<std::uint64_t>();
  return calls;
}

std::nullopt_t fail_run(const Command& command, std::string fault, Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, "", 0, command.front(), std::move(fault),
                   "Look at the flags; try --functions with one at a time to find which it is."});
  return std::nullopt;
}

}  // namespace

bool write_harness(const std::vector<GeneratedFunction>& functions,
                   const std::vector<State>& states, const Scene& scene, const Target& target,
                   const StepTape* tape, const std::string& step_entry, const fs::path& work,
                   Diagnostics& diagnostics) {
  const std::string& name = scene.name;
  const bool c = scene.language == Language::c;
  HarnessFiles files{work / kStatesFile, work / kResultsFile, static_cast<int>(states.size())};
  if (tape != nullptr) {
    files.step_head = print_step_head(name, work / kTapeFile);
    files.step_part = print_step_part(name, *tape);
  }
  const auto write = [&](const std::string& file, const std::string& text) {
    return write_work_file(work / file, text, diagnostics);
  };
  const auto source = [](const char* stem) { return std::string(stem) + ".cpp"; };
  bool written = write(kStatesFile, pack_states(functions, states, scene.real)) &&
                 write("board.hpp", std::string(board_templates::kBoard)) &&
                 write(kLinkerScript, std::string(board_templates::kLinkerScript)) &&
                 write("functions.hpp", c ? print_c_functions_header(name, functions, scene.real)
                                          : print_functions_header(name, functions)) &&
                 write(source(kMainStem), print_main(name, functions, files)) &&
                 write(source(kEmptyStem), print_empty_functions(functions)) &&
                 write(source(kStartStem), print_start(target.board));
  if (tape != nullptr) {
    written = written && write(kTapeFile, tape->bytes) && write(source(kStepStem), step_entry);
  }
  for (const GeneratedFunction& generated : functions) {
    if (c || !is_composed(generated)) continue;
    written =
        written && write(source_stem(generated) + ".cpp", print_composed_function(name, generated));
  }
  return written;
}

std::optional<BoardRun> run_board(const fs::path& program,
                                  const std::vector<GeneratedFunction>& functions,
                                  std::size_t states, Real real, const StepTape* tape,
                                  const Tools& tools, const fs::path& work,
                                  Diagnostics& diagnostics) {
  Command command{"timeout", kPatience};
  command.insert(command.end(), tools.simulator.begin(), tools.simulator.end());
  command.insert(command.end(), {"-kernel", program});
  const CommandOutcome outcome = run_commands({command}, 1, work).front();
  constexpr int kTimedOut = 124;
  if (outcome.exit_code == kTimedOut) {
    return fail_run(tools.simulator, "the program does not end", diagnostics);
  }
  if (outcome.exit_code != 0) {
    return fail_run(tools.simulator, "the program stops with a fault: " + outcome.output,
                    diagnostics);
  }
  const std::string bytes = read_file(work / kResultsFile);
  Reader reader(bytes);
  constexpr std::uint64_t kSpent = 2000;
  const auto spent = reader.take<std::uint64_t>();
  if (spent != kSpent) {
    return fail_run(tools.simulator,
                    fmt::format("{} instructions were counted where {} were spent", spent, kSpent),
                    diagnostics);
  }
  BoardRun calls;
  for (const GeneratedFunction& generated : functions) {
    calls.functions.push_back(read_calls(count_outputs(generated), states, real, reader));
  }
  if (tape != nullptr) calls.steps = read_steps(*tape, reader);
  if (!reader.read_all()) {
    return fail_run(tools.simulator, "the program has written less than it should", diagnostics);
  }
  return calls;
}

}  // namespace treeline
