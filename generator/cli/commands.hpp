#pragma once

#include <CLI/CLI.hpp>

// Each adds a subcommand of `treeline` to `app`. It sets `exit_code` when it ran.

namespace treeline {

/// `treeline generate URDF [SCENE]`: URDF and scene to a folder of C++, C or OpenCL C.
void add_generate(CLI::App& app, int& exit_code);

/// `treeline check`: generated code, compiled and run, against the interpreter in 50 digits.
void add_check(CLI::App& app, int& exit_code);

/// `treeline certify`: proofs of rounding bounds by Gappa and Coq.
void add_certify(CLI::App& app, int& exit_code);

/// `treeline bench`: time and error of every way to a function's numbers.
void add_bench(CLI::App& app, int& exit_code);

/// `treeline inspect URDF`: what the generator sees in a URDF.
void add_inspect(CLI::App& app, int& exit_code);

/// `treeline keys [KEY...]`: what a scene may say.
void add_keys(CLI::App& app, int& exit_code);

/// `treeline init-scene URDF`: a commented scene to start from.
void add_init_scene(CLI::App& app, int& exit_code);

/// `treeline convert FILE`: the URDF as which the program reads SDF or MJCF.
void add_convert(CLI::App& app, int& exit_code);

/// `treeline diff FIRST SECOND`: by how much two robots differ.
void add_diff(CLI::App& app, int& exit_code);

/// `treeline simulate URDF [SCENE]`: lets a robot go and says what became of its energy.
void add_simulate(CLI::App& app, int& exit_code);

/// `treeline draw URDF [SCENE]`: a robot or its motion as SVG.
void add_draw(CLI::App& app, int& exit_code);

/// `treeline drive URDF [SCENE]`: compiles a robot's code with a control loop, simulates it, and
/// lets people drive it.
void add_drive(CLI::App& app, int& exit_code);

/// `treeline interpret`: answers calls of a robot's functions by the interpreter, for programs.
void add_interpret(CLI::App& app, int& exit_code);

/// `treeline doctor`: what of this machine's programs is there, and for what.
void add_doctor(CLI::App& app, int& exit_code);

}  // namespace treeline
