#pragma once

#include <sys/types.h>

#include <filesystem>
#include <mutex>

namespace treeline {

/// From this call on, SIGINT, SIGTERM and SIGHUP end the program only after the processes that it
/// started have ended and its temporary folders are removed. It then ends by the same signal, as a
/// shell expects. Signals that are ignored stay ignored. Call this once, before any thread starts:
/// a thread of its own waits for the signals.
void clean_up_on_signals();

/// From now on the first such signal calls `answer`, from the thread that waits for them, and does
/// not end the program; a second one does. Null: signals end the program again.
void answer_signals(void (*answer)());

/// Keeps signals from ending the program as long as it lives. For short actions that must be done
/// completely or not at all. If a signal has already come, the constructor does not return.
class Uninterrupted {
 public:
  Uninterrupted();

 private:
  std::unique_lock<std::mutex> lock_;
};

/// Ways to remove a folder on a signal: with its content, or only if it is still empty (for folders
/// of results). Register folders while an `Uninterrupted` lives, so that no signal arrives between
/// creation and registration.
enum class Removal { with_content, if_empty };
void remove_on_signal(const std::filesystem::path& folder, Removal removal);
void keep_on_signal(const std::filesystem::path& folder);

/// Registers a process that leads a process group. On a signal, the whole group is ended.
void end_on_signal(pid_t group);
void forget_process(pid_t group);

}  // namespace treeline
