#pragma once

namespace CLI {
class App;
}

namespace treeline {

/// `interpret`: answers calls of a robot's functions by the interpreter, for programs.
void add_interpret(CLI::App& app, int& exit_code);

}  // namespace treeline
