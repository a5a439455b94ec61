#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drive/session.hpp"

namespace treeline::drive {

/// Version of the messages; those of another are malformed.
inline constexpr int kWireVersion = 1;
/// Largest message that a front end may send, bytes.
inline constexpr std::size_t kLargestMessage = 4096;
/// Oldest state that a front end may have seen when it drags or pulls, s.
inline constexpr double kOldestSeen = 0.5;

/// A mesh that a URDF names: its file, or why there is none to serve.
struct ServedMesh {
  std::string uri;              ///< as the URDF has it
  std::string path;             ///< of the file on this machine; empty: not found, or not permitted
  std::string problem, remedy;  ///< why, and what to do; empty with a path
};

/// Messages of one connection: they must have ascending numbers.
class Inbox {
 public:
  /// Whether the connection's front end has the token.
  Inbox(int front_end, bool may_command) : front_end_(front_end), may_command_(may_command) {}

  /// Obeys one message, or counts why it does not, and returns the reply as text. `now` is the time
  /// (s); `states` tells when the state of a number was sent.
  std::string receive(std::string_view text, double now, const std::map<std::int64_t, double>& sent,
                      Session& session);

  int front_end() const { return front_end_; }
  bool may_command() const { return may_command_; }

 private:
  int front_end_;
  bool may_command_;
  std::int64_t last_ = -1;
};

/// Where meshes are served, and why others are not, which is for those who may command: an object
/// with `meshes` and `missing_meshes`. `query` stands behind the addresses.
std::string print_meshes(const std::vector<ServedMesh>& meshes, const std::string& query,
                         bool may_command);
/// `mesh_query` stands behind the addresses of the meshes.
std::string print_hello(const Session& session, double rate, bool may_command,
                        const std::vector<ServedMesh>& meshes, const std::string& mesh_query = {});

/// A state without what differs between front ends; `finish_state` adds that. `twin`: of the robot
/// in a rehearsal.
enum class Detail { plain, histograms };
std::string print_state(const Session& session, std::int64_t seq, int watchers,
                        Detail detail = Detail::histograms, const Session* twin = nullptr);
std::string finish_state(std::string state, bool commanding);

/// Adds the machine's time (ms since 1970) to a reply: in a cycle after it the command takes
/// effect.
std::string stamp_reply(std::string reply, double milliseconds);
std::string print_reply(std::optional<std::int64_t> seq, const Answer& answer);
/// A command as a record keeps it.
std::string print_command(const std::string& line, double time, const Answer& answer);
std::string print_note(const std::string& text);

}  // namespace treeline::drive
