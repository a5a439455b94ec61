// Runs a compiler and writes its cost and the size of its output:
//   compile_meter FACTS.json OBJECT COMMAND...
// OBJECT is - for a command that makes none. Writes {"seconds", "peak_mib": processor time and
// memory of the command, "code_bytes": of OBJECT's functions, "stack_bytes": sum of their frames,
// from the .su file of -fstack-usage}. Returns the command's exit status.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace {

struct Cost {
  int status = 1;
  double seconds = 0, peak_mib = 0;
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Cost run(char** command) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("CCACHE_DISABLE", "1", 1);  // where g++ is ccache, a hit would be what is measured
    execvp(command[0], command);
    std::perror(command[0]);
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return {};
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 1,
          seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

/// Adds up the sizes of all functions in an object file; 0 if nm does not work.
long code_bytes(const std::string& object) {
  if (object == "-") return 0;
  const std::unique_ptr<FILE, int (*)(FILE*)> nm(popen(("nm -S '" + object + "'").c_str(), "r"),
                                                 pclose);
  long bytes = 0;
  char line[4096];
  while (nm && std::fgets(line, sizeof line, nm.get()) != nullptr) {
    std::istringstream fields(line);
    std::string address, size, type;
    fields >> address >> size >> type;
    if (type.size() == 1 && std::string("tTwW").find(type) != std::string::npos) {
      bytes += std::stol(size, nullptr, 16);
    }
  }
  return bytes;
}

/// Adds up the second column of `place  bytes  kind`.
long stack_bytes(const std::string& object) {
  std::ifstream file(object.substr(0, object.rfind('.')) + ".su");
  long bytes = 0;
  for (std::string line; std::getline(file, line);) {
    const auto tab = line.find('\t');
    if (tab != std::string::npos) bytes += std::atol(line.c_str() + tab);
  }
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) {
    std::cerr << "usage: compile_meter FACTS.json OBJECT COMMAND...\n";
    return 2;
  }
  const Cost cost = run(arguments + 3);
  if (cost.status != 0) return cost.status;
  std::ofstream(arguments[1]) << "{\"seconds\": " << cost.seconds
                              << ", \"peak_mib\": " << cost.peak_mib
                              << ", \"code_bytes\": " << code_bytes(arguments[2])
                              << ", \"stack_bytes\": " << stack_bytes(arguments[2]) << "}\n";
  return 0;
}
