#pragma once

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace treeline::test {

/// Returns what the program shows on a terminal, standard output and error together. `environment`
/// precedes the command, as in `NO_COLOR=1`; the terminal has so many columns.
inline std::string run_on_terminal(const std::string& environment, const std::string& arguments,
                                   unsigned short columns = 80) {
  const std::string command =
      "env TERM=xterm " + environment + " '" TREELINE_PROGRAM "' " + arguments;
  int terminal = -1;
  const winsize window{24, columns, 0, 0};
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &window);
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  std::string shown;
  std::array<char, 4096> block{};
  // Reading from a terminal whose program has ended gives an error, not an end of file.
  for (ssize_t size = 0; (size = read(terminal, block.data(), block.size())) > 0;) {
    shown.append(block.data(), static_cast<std::size_t>(size));
  }
  close(terminal);
  waitpid(child, nullptr, 0);
  return shown;
}

}  // namespace treeline::test
