#pragma once
// Types of the loops over a table of links.

/// Cosine and sine of a rotation about one coordinate axis.
struct TlTurn {
  real c;
  real s;
};
typedef struct TlTurn TlTurn;

/// A wrench [f; n], or a twist [v; w], at a link's origin, in its axes.
struct TlSpatial {
  real linear[3];
  real angular[3];
};
typedef struct TlSpatial TlSpatial;

/// Inertial parameters of a link, in its frame.
struct TlLinkBody {
  real mass;
  real h[3];  ///< first moment
  real J[6];  ///< rotational inertia about the frame's origin: xx xy xz yy yz zz
};
typedef struct TlLinkBody TlLinkBody;

/// A link, and the joint that moves it along or about the z axis of its frame, whose
/// pose in the parent is the translation by `p`, Rz(a) Rx(alpha) Rz(b), and the
/// joint's motion.
struct TlLink {
  int16_t parent;  ///< -1: the world
  int16_t slot;  ///< how many of the links that carry it carry several
  int16_t end;  ///< it carries the links from the next to before this one
  bool slides;  ///< a prismatic joint
  bool starts;  ///< a limb: the links behind it, up to the next of this kind, are
                ///< placed from it
  TlTurn a;
  TlTurn alpha;
  TlTurn b;
  real p[3];  ///< in the parent's axes
  real rotor;  ///< inertia that the joint alone feels
  TlLinkBody body;
};
typedef struct TlLink TlLink;

/// An operational point.
struct TlLinkPoint {
  int16_t link;
  bool world;  ///< axes of the world; else `axes`
  real axes[9];  ///< row-major; a row is an axis, in the link's axes
  real p[3];  ///< in the link's axes
};
typedef struct TlLinkPoint TlLinkPoint;

/// A row of the task: an operational point's motion along an axis, or its rotation
/// about it.
struct TlPointRow {
  int16_t point;
  int16_t axis;
  bool angular;
};
typedef struct TlPointRow TlPointRow;

/// Viscous friction and spring of a joint.
struct TlLinkDrive {
  real damping;
  real stiffness;
  real rest;  ///< coordinate at which the spring is slack
};
typedef struct TlLinkDrive TlLinkDrive;

/// Coulomb friction of a joint: `force` times the smooth sign of `sharpness` times
/// the velocity.
struct TlLinkFriction {
  real force;
  real sharpness;
};
typedef struct TlLinkFriction TlLinkFriction;

/// A joint that moves by `multiplier` times the coordinate of joint `joint`, which
/// may be its own.
struct TlLinkCoupling {
  int16_t joint;  ///< of those that have coordinates of their own, a floating base
                  ///< among them
  real multiplier;
  bool spins;  ///< a rotor, symmetric about its axis: how far it has turned does not
               ///< matter
  bool own_sine;  ///< its angle has a sine other than plus or minus that of the
                  ///< coordinate
};
typedef struct TlLinkCoupling TlLinkCoupling;

/// A joint of three axes about one point, whose links are three: the first turns by
/// the quaternion of the joint, the others only make its next axis the z axis. So do
/// the six of a joint that moves freely: three slide along its axes, three turn about
/// them, and the first is where the last is.
struct TlLinkBall {
  int16_t axis;  ///< which of them the link has: from 1 on; 0: another joint
  int16_t rotation;  ///< of the first: where its rotation is
  int16_t q;  ///< where the coordinates of a joint of any kind begin
};
typedef struct TlLinkBall TlLinkBall;

/// A rotation, row-major: of a floating base's axes to the world's, of a ball joint's
/// link's to its parent's, or of a frame's to its link's.
struct TlLinkRotation {
  real Q[9];
};
typedef struct TlLinkRotation TlLinkRotation;

/// The robot. Where the base floats the first link moves freely, and has seven
/// coordinates and six velocities; each other joint has one.
struct TlLinkTable {
  const TlLink* links;
  int32_t count;
  int32_t slots;  ///< the largest of the links, and one more
  real gravity[3];
  const TlLinkPoint* points;
  int32_t point_count;
  const TlPointRow* point_rows;
  int32_t rows;
  const TlLinkCoupling* couplings;  ///< of all links; none: each joint is its own
  int32_t joints;  ///< that have coordinates of their own, where there are couplings
  const int16_t* row_entries;  ///< of all rows; none: rows stand as in arguments
  const real* rotors;  ///< of all links; none: those in `links`
  const real* step;  ///< in s, at whose end springs are taken; none: at its beginning
#if TL_DRIVEN
  const TlLinkDrive* drives;  ///< of all links; none: no joint has any
#endif
#if TL_RUBBING
  const TlLinkFriction* frictions;  ///< of all links; none: no joint has any
#endif
#if TL_BALLS
  const TlLinkBall* ball_axes;  ///< of all links
#endif
#if TL_PUSHED
  const TlLinkPoint* pushed_points;
  int32_t pushed_count;
  const real* f_ext;  ///< force and moment at each of these; none: 0
#endif
#if TL_LOADED
  const TlLinkBody* bodies;  ///< of `loaded_links`, in place of those in `links`
  const int16_t* loaded_links;
  int32_t loaded_count;
#endif
};
typedef struct TlLinkTable TlLinkTable;

/// What a joint's coordinate makes of a link's pose.
struct TlLinkPose {
  TlTurn turn;  ///< Rz(b) and the joint's angle
  real slide;  ///< along the z axis of the placement, of prismatic joints
};
typedef struct TlLinkPose TlLinkPose;

/// The rotations of a link about axes of coordinates, from its own axes to its
/// parent's. Numbers that are turned may be those of the table for all that a
/// compiler knows: it reads these once.
struct TlLinkTurns {
  TlTurn joint;
  TlTurn alpha;
  TlTurn a;
};
typedef struct TlLinkTurns TlLinkTurns;

/// Motion of a link's frame, in its axes. `a` is the acceleration of its origin minus
/// gravity.
struct TlLinkMotion {
  real w[3];
  real wd[3];
  real a[3];
};
typedef struct TlLinkMotion TlLinkMotion;

/// Inertia of bodies at a link's frame, [A B; B^T C]: f = A a + B wd, n = B^T a + C
/// wd. A and C are symmetric, with entries xx xy xz yy yz zz, B is row-major 3x3.
/// What is done with all of these is written in straight lines, of which compilers
/// keep much in registers.
struct TlLinkInertia {
  real A[6];
  real B[9];
  real C[6];
};
typedef struct TlLinkInertia TlLinkInertia;

/// Where a link is in the axes of the root: rows of the rotation from the link's
/// axes; its origin from that of its parent, and from where its limb starts.
struct TlLinkFrame {
  real x[3];
  real y[3];
  real z[3];
  real step[3];
  real p[3];
};
typedef struct TlLinkFrame TlLinkFrame;

/// u = IA S / D without its own entry, and 1 / D of a joint; D includes its rotor.
struct TlLinkProjection {
  TlSpatial u;
  real inverse_D;
};
typedef struct TlLinkProjection TlLinkProjection;

/// The rotation of a link: row j is its axis j, in the axes of the world.
struct TlLinkAxes {
  real rows[9];
};
typedef struct TlLinkAxes TlLinkAxes;
