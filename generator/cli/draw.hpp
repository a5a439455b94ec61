#pragma once

namespace CLI {
class App;
}

namespace treeline {

/// Adds `treeline draw`.
void add_draw(CLI::App& app, int& exit_code);

}  // namespace treeline
