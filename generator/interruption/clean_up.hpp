#pragma once

#include <sys/types.h>

#include <filesystem>
#include <mutex>

namespace treeline {

/// From here on SIGINT, SIGTERM and SIGHUP end the program only after the processes that it started
/// have ended and the folders that it made for a while are gone; then by that very signal, as a
/// shell expects. Signals that are ignored stay ignored. To be called once, before any thread
/// starts: a thread of its own waits for the signals.
void clean_up_on_signals();

/// While one lives no signal ends the program: for what must be done wholly or not at all, and
/// shortly. Where a signal has come already, the constructor never returns.
class Uninterrupted {
 public:
  Uninterrupted();

 private:
  std::unique_lock<std::mutex> lock_;
};

/// A folder to remove on a signal, with all that it holds; one made for results only if it is still
/// empty. To be called while `Uninterrupted`, so that no signal falls between making and telling.
enum class Removal { with_content, if_empty };
void remove_on_signal(const std::filesystem::path& folder, Removal removal);
void keep_on_signal(const std::filesystem::path& folder);

/// A process that leads a group of its own, to be ended on a signal with all that it started.
void end_on_signal(pid_t group);
void forget_process(pid_t group);

}  // namespace treeline
