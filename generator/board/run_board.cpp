#include "board/run_board.hpp"

#include <fmt/format.h>

#include <cstring>

#include "board/templates.hpp"
#include "compilation/print_step_entry.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/backend.hpp"
#include "emission/generated_file.hpp"
#include "oracle/graph_run.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStatesFile = "states.bin";
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

/// Reads numbers from the bytes that the program has printed.
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
    calls.cycles.push_back(reader.take<std::uint64_t>());
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
    calls.cycles.push_back(reader.take<std::uint64_t>());
    std::vector<double>& results = calls.results.emplace_back();
    for (std::size_t i = 0; i < tape.output_size + tape.state_size; ++i) {
      results.push_back(reader.take<double>());
    }
  }
  calls.stack_seen = reader.take<std::uint64_t>();
  return calls;
}

SelftestCall read_selftest(Reader& reader) {
  SelftestCall call;
  for (auto* number : {&call.stack_seen, &call.instructions, &call.cycles, &call.result}) {
    *number = reader.take<std::uint64_t>();
  }
  return call;
}

std::nullopt_t fail_run(const Tools& tools, const fs::path& program, std::string fault,
                        Diagnostics& diagnostics) {
  diagnostics.add(
      {Severity::error, "", 0, tools.runner.front(), std::move(fault),
       fmt::format("Try --functions with one at a time, or fewer --states. The command was: {} {}",
                   fmt::join(tools.runner, " "), program.string())});
  return std::nullopt;
}

/// Why there are not all results, from what is known of the command and of what it printed.
std::string describe_run(const CommandOutcome& outcome, const std::string& fault) {
  constexpr int kTimedOut = 124, kNoProgram = 127;
  const std::string lines = first_lines(outcome.output);
  if (outcome.exit_code == kNoProgram) return "there is no such program" + lines;
  if (outcome.exit_code == kTimedOut) {
    return fmt::format("it does not end in time; {}{}", fault, lines);
  }
  if (outcome.exit_code != 0) {
    return fmt::format("the program stops with a fault (exit status {}); {}{}", outcome.exit_code,
                       fault, lines);
  }
  return fault + lines;
}

/// The files of the program, by their names.
std::vector<GeneratedFile> print_files(const BoardCase& board_case, const std::string& states,
                                       const std::string& id, const Target& target,
                                       const fs::path& work) {
  const std::string& name = board_case.name;
  const auto& functions = board_case.functions;
  const Backend& backend = backend_of(board_case.language);
  HarnessFiles files{work / kStatesFile, id, static_cast<int>(board_case.states.size()),
                     board_case.selftest};
  const auto source = [](const char* stem) { return std::string(stem) + ".cpp"; };
  std::vector<GeneratedFile> all = {
      {kStatesFile, states},
      {"board.hpp", std::string(board_templates::kBoard)},
      {kLinkerScript, std::string(board_templates::kLinkerScript)},
      {"functions.hpp", backend.has_namespaces
                            ? print_functions_header(name, functions)
                            : print_c_functions_header(name, functions, board_case.real)},
      {source(kEmptyStem), print_empty_functions(functions)},
      {source(kStartStem), print_start(target.board)}};
  if (board_case.tape != nullptr) {
    files.step_head = print_step_head(name, work / kTapeFile);
    files.step_part = print_step_part(name, *board_case.tape);
    all.push_back({kTapeFile, board_case.tape->bytes});
    all.push_back({source(kStepStem), board_case.step_entry});
  }
  all.push_back({source(kMainStem), print_main(name, functions, files)});
  for (const GeneratedFunction& generated : functions) {
    if (!backend.composes_in_headers || !is_composed(generated)) continue;
    all.push_back({source_stem(generated) + ".cpp", print_composed_function(name, generated)});
  }
  return all;
}

}  // namespace

std::optional<std::string> write_harness(const BoardCase& board_case, const Target& target,
                                         const fs::path& work, Diagnostics& diagnostics) {
  const std::string states = pack_states(board_case.functions, board_case.states, board_case.real);
  std::string all = board_case.name + target.name + states;
  for (const GeneratedFunction& generated : board_case.functions) all += source_stem(generated);
  if (board_case.tape != nullptr) all += board_case.tape->bytes;
  const std::string id = digest(all).substr(0, 16);
  for (const GeneratedFile& file : print_files(board_case, states, id, target, work)) {
    if (!write_work_file(work / file.name, file.text, diagnostics)) return std::nullopt;
  }
  return id;
}

std::optional<BoardRun> run_board(const fs::path& program, const std::string& id,
                                  const BoardCase& board_case, const Tools& tools, bool simulated,
                                  const fs::path& work, Diagnostics& diagnostics) {
  Command command{"timeout", kPatience};
  command.insert(command.end(), tools.runner.begin(), tools.runner.end());
  command.push_back(program);
  const CommandOutcome outcome = run_commands({command}, 1, work).front();
  const PrintedBytes printed = read_printed(outcome.output, id);
  if (!printed.fault.empty()) {
    return fail_run(tools, program, describe_run(outcome, printed.fault), diagnostics);
  }
  Reader reader(printed.bytes);
  constexpr std::uint64_t kSpent = 2000;
  const auto spent = reader.take<std::uint64_t>();
  BoardRun run;
  run.counts_instructions = spent == kSpent;
  if (simulated && !run.counts_instructions) {
    return fail_run(tools, program,
                    fmt::format("{} instructions were counted where {} were spent", spent, kSpent),
                    diagnostics);
  }
  for (const GeneratedFunction& generated : board_case.functions) {
    run.functions.push_back(
        read_calls(count_outputs(generated), board_case.states.size(), board_case.real, reader));
  }
  if (board_case.tape != nullptr) run.steps = read_steps(*board_case.tape, reader);
  if (board_case.selftest) run.selftest = read_selftest(reader);
  if (!reader.read_all()) {
    return fail_run(tools, program, "the program prints another number of results than it should",
                    diagnostics);
  }
  return run;
}

}  // namespace treeline
