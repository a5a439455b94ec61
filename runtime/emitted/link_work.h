#pragma once
// Work space of the loops over a table of links, whose sizes are those of the robot.

/// Poses of all links.
struct TlLinkPoses {
  TlLinkPose joints[TL_LINKS];
  TlLinkRotation rotations[TL_TURNED];  ///< that of a floating base is the first
#if TL_GIVEN_SINES
  const real* sin_q;  ///< of all coordinates; the caller fills these in
  const real* cos_q;
#endif
};
typedef struct TlLinkPoses TlLinkPoses;

/// What inverse dynamics keeps of each link, and of the links on the way out.
struct TlMotionWork {
  TlLinkPoses poses;
  TlSpatial wrenches[TL_LINKS];
  TlLinkMotion motions[TL_SLOTS];
};
typedef struct TlMotionWork TlMotionWork;

/// What M needs of each link, in the axes of the root. A body is that of a link with
/// those that it carries, about the link's origin. A wrench is what the joint needs
/// to move them at unit acceleration: the force f, and the moment n about where the
/// limb starts.
struct TlMatrixWork {
  TlLinkFrame frames[TL_LINKS];
  TlLinkBody bodies[TL_LINKS];
  real f_x[TL_LINKS];
  real f_y[TL_LINKS];
  real f_z[TL_LINKS];
  real n_x[TL_LINKS];
  real n_y[TL_LINKS];
  real n_z[TL_LINKS];
};
typedef struct TlMatrixWork TlMatrixWork;

/// What articulated bodies need of links and joints, or, where joints share
/// coordinates, what factors of M do.
struct TlFactorWork {
#if TL_ARTICULATED
  TlLinkInertia inertias[TL_SLOTS];
  TlLinkProjection projections[TL_LINKS];
#endif
#if TL_COUPLED
  TlMatrixWork matrix;
#endif
  /// Factors of the articulated inertia of a floating base, or of M, and behind these
  /// joint forces of the rows of the task; else one entry.
  real base[TL_BASE_ENTRIES];
};
typedef struct TlFactorWork TlFactorWork;

/// What functions of operational points keep of points and rows.
struct TlRowWork {
  TlLinkAxes link_axes[TL_POINTS];  ///< of the points' links
  TlLinkMotion point_motions[TL_POINTS];
  TlSpatial forces[TL_ROWS];  ///< unit forces on their way to the base
  int16_t links[TL_ROWS];  ///< where they have got to
  real errors[TL_ROWS];
  real Lambda_inv[TL_ROWS * TL_ROWS];
  /// By which rows in the order of priority yield; else one entry.
  real inverse_borders[TL_RANKED];
};
typedef struct TlRowWork TlRowWork;
