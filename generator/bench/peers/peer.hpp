#pragma once

/// What a peer is: another library of robot dynamics, adapted to this project's conventions and
/// built as a module that is loaded where it is found, so that nothing else here needs the library.
/// Plain structures and pointers only: module and program may be compiled differently. Everything
/// that is passed in lives as long as the call.
namespace treeline::peer {

/// Changes with anything below.
inline constexpr int kVersion = 1;

/// A frame fixed to a link: an operational point.
struct Point {
  const char* link;
  double R[9];      ///< the frame's axes in the link's, row-major
  double p[3];      ///< its origin in the link's frame, m
  bool rows[6];     ///< x y z rx ry rz: which are controlled
  bool world_axes;  ///< else the frame's own
};

/// A robot and what there is to know of its scene.
struct Robot {
  /// Path of a file without shapes and mimic tags, with revolute, prismatic and fixed joints; what
  /// else is found there may be refused.
  const char* urdf;
  bool floating;      ///< the root link moves freely, its six coordinates come first
  double gravity[3];  ///< m/s^2, world axes
  int velocities;
  const char* const* links;  ///< for each entry of qd the link that it moves
  int point_count;
  const Point* points;
};

/// One call: a function's inputs in the order of the generated contract (q alone for matrices and
/// gravity, q qd, q qd qdd, q qd tau, q qd qdd_0 xdd_cmd), its results one after the other, in the
/// project's order of joints and axes; matrices row-major.
using Call = void (*)(void* solver, const double* const* inputs, double* output);

/// Brings an output into that order where a library's own is another, as good to its user
/// (column-major, one triangle of a symmetric matrix, its own order of joints). Not timed.
using Finish = void (*)(void* solver, double* output);

/// One way of the library to a function.
struct Routine {
  const char*
      function;       ///< `mass_matrix`: as in scenes and emitted code, and `mass_matrix_inverse`
  const char* route;  ///< "chain", "in world axes"; empty where there is but one
  void* solver;       ///< the calls' first argument
  Call call;
  Finish finish;  ///< may be null
};

/// Takes a sentence about what the library cannot do with a robot, and why.
using Say = void (*)(void* listener, const char* sentence);

/// A module's answer to `treeline_peer`.
struct Peer {
  int version;          ///< `kVersion` of the module; nothing else may be read if it is another
  const char* name;     ///< "KDL"
  const char* release;  ///< of the library: "1.5.1"
  /// The robot, read by the library; null where it has no routine for it, after saying why.
  void* (*open)(const Robot* robot, Say say, void* listener);
  /// How many routines there are for an opened robot, and where: valid until it is closed.
  int (*list)(void* opened, const Routine** routines);
  void (*close)(void* opened);
};

}  // namespace treeline::peer

/// The one symbol of a module.
extern "C" [[gnu::visibility("default")]] const treeline::peer::Peer* treeline_peer();
