// Code that CasADi records of Pinocchio's algorithms, compiled here and loaded.
#include <dlfcn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bench/peers/pinocchio/record.hpp"
// The scalar comes first.
#include "bench/peers/make_peer.hpp"
#include "bench/peers/pinocchio/adapt.hpp"
#include "bench/peers/pinocchio/read_solver.hpp"

namespace treeline::peer::pin {
namespace {

namespace fs = std::filesystem;

/// The longest that a compiler may take for a function.
#define TREELINE_SECONDS "60"
constexpr int kTimedOut = 124;  // what `timeout` answers

struct Recording {
  const char* function;
  const char* route;
  std::string (*record)(const Solver<double>& solver);
  Finish finish;
  bool takes_points;
};
constexpr const char* kCholesky = "Cholesky of M";
constexpr Recording kRecordings[] = {
    {"inverse_dynamics", "", record_rnea, nullptr, false},
    {"gravity", "", record_gravity, nullptr, false},
    {"forward_dynamics", "", record_aba, nullptr, false},
    {"mass_matrix", "", record_crba, finish_symmetric, false},
    {"inverse_dynamics_derivatives", "", record_rnea_derivatives, finish_derivatives, false},
    {"forward_dynamics_derivatives", "", record_aba_derivatives, finish_derivatives, false},
    {"lambda_inverse", kCholesky, record_lambda_inverse, finish_lambda, true},
    {"lambda", kCholesky, record_lambda, finish_lambda, true},
    {"control_torque", kCholesky, record_control_torque, nullptr, true}};

/// A folder that is removed with what is in it.
struct Folder {
  std::string path = (fs::temp_directory_path() / "treeline_recorded_XXXXXX").string();

  Folder() {
    if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("cannot write " + path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

/// Removes statements of results that are zero in every state: they need not be written.
std::string without_zeros(const std::string& code) {
  std::string kept;
  for (std::size_t at = 0; at < code.size();) {
    const std::size_t next = std::min(code.find('\n', at), code.size() - 1) + 1;
    const std::string_view line(code.data() + at, next - at);
    if (!line.starts_with("   y[") || !line.ends_with("] = 0;\n")) kept += line;
    at = next;
  }
  return kept;
}

/// Returns null where it takes too long.
Call compile(const std::string& code, const std::string& what) {
  const Folder folder;
  const std::string source = folder.path + "/recorded.c";
  const std::string library = folder.path + "/recorded.so";
  std::ofstream(source) << code;
  const char* const compiler = std::getenv("CC");
  const std::string command =
      std::string("timeout " TREELINE_SECONDS " ") + (compiler == nullptr ? "cc" : compiler) +
      " -O3 -march=native -shared -fPIC -w -o " + library + " " + source + " -lm";
  const int answer = std::system(command.c_str());
  if (WIFEXITED(answer) && WEXITSTATUS(answer) == kTimedOut) return nullptr;
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (loaded == nullptr) throw std::runtime_error("code of " + what + " does not compile");
  return reinterpret_cast<Call>(dlsym(loaded, "recorded"));
}

bool is_asked(const Robot& robot, const Recording& recording) {
  const auto end = robot.functions + robot.function_count;
  return std::find(robot.functions, end, std::string_view(recording.function)) != end;
}

Opened open(const Robot& robot, const Tell& tell) {
  auto read = read_solver(describe(robot, tell));
  if (!read) {
    tell("does not read the robot as it is described");
    return {};
  }
  Opened opened;
  auto& s = opened.keep<Solver<double>>(*std::move(read));
  for (const Recording& each : kRecordings) {
    if (!is_asked(robot, each) || (each.takes_points && s.points.empty())) continue;
    const Call call = compile(without_zeros(each.record(s)), each.function);
    if (call == nullptr) {
      tell("takes more than " TREELINE_SECONDS " s to compile " + std::string(each.function));
    } else {
      opened.routines.push_back({each.function, each.route, &s, call, each.finish});
    }
  }
  return opened;
}

}  // namespace
}  // namespace treeline::peer::pin

const treeline::peer::Peer* treeline_peer() {
  using namespace treeline::peer;
  static const pin::Tool tool = pin::recording_tool();
  static const Peer peer = make_peer<pin::open>(tool.name, tool.release, true);
  return &peer;
}
