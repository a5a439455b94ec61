#pragma once

/// A peer is another library of robot dynamics, adapted to this project's conventions and built as
/// a module that is loaded if it is found, so that nothing else here needs the library. The
/// interface has only plain structures and pointers, because module and program may be compiled
/// differently. Everything that is passed in lives at least until the call returns.
namespace treeline::peer {

/// Version of this interface. Changes with anything below.
inline constexpr int kVersion = 3;

/// A frame fixed to a link: an operational point.
struct Point {
  const char* link;
  double R[9];      ///< the frame's axes in the link's, row-major
  double p[3];      ///< origin of the point in the link's frame, m
  bool rows[6];     ///< which of x y z rx ry rz are controlled
  bool world_axes;  ///< false: the frame's own axes
};

/// Rows of a frame that are held, see `SceneLoop` and `Scene::constraints`.
struct Constraint {
  const char* name;
  Point frame;  ///< `rows`: which are held, along the axes of the frame or of the world
  /// The frame relative to which they are held, and along whose axes. Its link is null if it is the
  /// world, where the frame is held wherever it is.
  Point other;
};

/// A robot and the properties of its scene.
struct Robot {
  /// Path of a file without shapes and mimic tags, with revolute, prismatic and fixed joints only.
  /// A library may refuse anything else in it.
  const char* urdf;
  bool floating;      ///< the root link moves freely, its six coordinates come first
  double gravity[3];  ///< m/s^2, world axes
  int velocities;
  const char* const* links;  ///< the link that each entry of qd moves
  int point_count;
  const Point* points;
  int constraint_count;
  const Constraint* constraints;
  int function_count;
  const char* const* functions;  ///< names of those that are asked for; others may be left out
};

/// Calls a function once. The inputs are in the order of the generated contract (q for matrices and
/// gravity, q qd, q qd qdd, q qd tau, q qd qdd_0 xdd_cmd). The results follow each other, in the
/// project's order of joints and axes, matrices row-major. `constrained_forward_dynamics` is called
/// at states that keep the constraints, without stabilisation, and gives its first result alone.
using Call = void (*)(void* solver, const double* const* inputs, double* output);

/// Converts an output into that order if the library's own form is different but equally useful
/// (column-major, one triangle of a symmetric matrix, its own order of joints). This is not timed.
using Finish = void (*)(void* solver, double* output);

/// One route of the library to a function.
struct Routine {
  const char*
      function;       ///< name as in scenes, for instance `mass_matrix`; also `mass_matrix_inverse`
  const char* route;  ///< "chain", "in world axes"; empty if there is only one
  void* solver;       ///< first argument of the calls
  Call call;
  Finish finish;  ///< may be null
};

/// Receives a sentence about what the library cannot do with a robot, and why.
using Say = void (*)(void* listener, const char* sentence);

/// The answer of a module's function `treeline_peer`.
struct Peer {
  int version;          ///< the module's `kVersion`; if it differs, read nothing else
  const char* name;     ///< "KDL"
  const char* release;  ///< of the library: "1.5.1"
  /// Opens a robot. Returns null if the library has no routine for it, after saying why.
  void* (*open)(const Robot* robot, Say say, void* listener);
  /// Returns the number of routines for an opened robot; they are valid until it is closed.
  int (*list)(void* opened, const Routine** routines);
  void (*close)(void* opened);
  bool records;  ///< makes code for a robot and compiles it in `open`
};

}  // namespace treeline::peer

/// The only exported symbol of a module.
extern "C" [[gnu::visibility("default")]] const treeline::peer::Peer* treeline_peer();
