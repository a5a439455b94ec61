#pragma once
// What arguments say of a robot that is a table of links: payloads, inertial
// parameters of links, rotors, friction, tools.

/// A frame of a link, in which an argument is given.
struct TlInputFrame {
  int16_t of;  ///< a body of `bodies`, or an operational point
  int16_t at;  ///< its first entry in the argument
  TlLinkRotation R;
  real p[3];  ///< the frame's origin, in the link's axes
};
typedef struct TlInputFrame TlInputFrame;

/// A number of an argument that a joint has.
struct TlInputNumber {
  int16_t of;  ///< the link of the joint
  int16_t at;  ///< its entry in the argument; -1: it is 0
  real factor;  ///< how many times the joint's coordinate feels it
};
typedef struct TlInputNumber TlInputNumber;

/// What the table says of links that arguments change.
TL_INLINE void tl_copy_bodies(const TlLink* links, const int16_t* loaded_links,
    int32_t count, TlLinkBody* bodies) {
  for (int32_t i = 0; i < count; ++i) {
    const TlLinkBody* const from = &links[loaded_links[i]].body;
    TlLinkBody* const to = &bodies[i];
    to->mass = from->mass;
    for (int32_t k = 0; k < 3; ++k) {
      to->h[k] = from->h[k];
    }
    for (int32_t k = 0; k < 6; ++k) {
      to->J[k] = from->J[k];
    }
  }
}

/// Adds the upper triangle of R M R^T of a symmetric matrix, which is lost.
TL_INLINE void tl_add_turned(const TlInputFrame* frame, real* M, real* sum) {
  tl_turn_matrix_by(&frame->R, M);
  int32_t at = 0;
  for (int32_t r = 0; r < 3; ++r) {
    for (int32_t c = r; c < 3; ++c) {
      sum[at] = sum[at] + M[(3 * r) + c];
      ++at;
    }
  }
}

/// Adds what a body's distance from the link's origin adds to its rotational inertia:
/// h is its first moment about the frame's origin, in the link's axes (parallel
/// axes).
TL_INLINE void tl_add_distance(
    const TlInputFrame* frame, real mass, const real* h, real* sum) {
  const real* const p = &frame->p[0];
  real middle[3];
  for (int32_t k = 0; k < 3; ++k) {
    middle[k] = h[k] + ((TL_REAL(0.5) * mass) * p[k]);
  }
  int32_t at = 0;
  for (int32_t r = 0; r < 3; ++r) {
    const int32_t s = (r + 1) % 3;
    const int32_t t = (r + 2) % 3;
    sum[at] = sum[at] + (TL_REAL(2.0) * ((p[s] * middle[s]) + (p[t] * middle[t])));
    ++at;
    for (int32_t c = r + 1; c < 3; ++c) {
      sum[at] = sum[at] - ((p[r] * middle[c]) + (p[c] * middle[r]));
      ++at;
    }
  }
}

/// Adds a body: m, m c, Ixx, Ixy, Iyy, Ixz, Iyz, Izz in its frame.
TL_INLINE void tl_add_body(
    const TlInputFrame* frame, const real* given, TlLinkBody* body) {
  const real mass = given[0];
  real h[3];
  for (int32_t k = 0; k < 3; ++k) {
    h[k] = given[k + 1];
  }
  real J[9] = {given[4], given[5], given[7], given[5], given[6], given[8], given[7],
      given[8], given[9]};
  tl_turn_by(&frame->R, &h[0]);
  tl_add_turned(frame, &J[0], &body->J[0]);
  tl_add_distance(frame, mass, &h[0], &body->J[0]);
  for (int32_t k = 0; k < 3; ++k) {
    body->h[k] = body->h[k] + h[k] + (mass * frame->p[k]);
  }
  body->mass = body->mass + mass;
}

/// Adds bodies that an argument gives.
TL_INLINE void tl_add_bodies(const TlInputFrame* frames, int32_t count,
    const real* argument, TlLinkBody* bodies) {
  for (int32_t i = 0; i < count; ++i) {
    tl_add_body(&frames[i], &argument[frames[i].at], &bodies[frames[i].of]);
  }
}

/// Adds bodies of which an argument of `size` numbers gives some of the ten, as
/// `entries` say, each from that of its frame to the next body's. The others are 0.
TL_INLINE void tl_add_parts_of_bodies(const TlInputFrame* frames, int32_t count,
    const int16_t* entries, int32_t size, const real* argument, TlLinkBody* bodies) {
  int32_t end = size;
  for (int32_t i = count - 1; i >= 0; --i) {
    real given[10];
    for (int32_t k = 0; k < 10; ++k) {
      given[k] = TL_ZERO;
    }
    for (int32_t k = frames[i].at; k < end; ++k) {
      given[entries[k]] = argument[k];
    }
    tl_add_body(&frames[i], &given[0], &bodies[frames[i].of]);
    end = frames[i].at;
  }
}

TL_INLINE void tl_copy_points(
    const TlLinkPoint* from, int32_t count, TlLinkPoint* to) {
  for (int32_t i = 0; i < count; ++i) {
    to[i].link = from[i].link;
    to[i].world = from[i].world;
    for (int32_t k = 0; k < 9; ++k) {
      to[i].axes[k] = from[i].axes[k];
    }
    for (int32_t k = 0; k < 3; ++k) {
      to[i].p[k] = from[i].p[k];
    }
  }
}

/// Puts the origins of points where an argument has them.
TL_INLINE void tl_move_points(const TlInputFrame* frames, int32_t count,
    const real* argument, TlLinkPoint* points) {
  for (int32_t i = 0; i < count; ++i) {
    const TlInputFrame* const frame = &frames[i];
    real p[3];
    for (int32_t k = 0; k < 3; ++k) {
      p[k] = argument[frame->at + k];
    }
    tl_turn_by(&frame->R, &p[0]);
    for (int32_t k = 0; k < 3; ++k) {
      points[frame->of].p[k] = p[k] + frame->p[k];
    }
  }
}

/// Gives points the axes of quaternions x y z w of any length.
TL_INLINE void tl_turn_points(const TlInputFrame* frames, int32_t count,
    const real* argument, TlLinkPoint* points) {
  for (int32_t i = 0; i < count; ++i) {
    const TlInputFrame* const frame = &frames[i];
    const real* const v = &argument[frame->at];
    const real twice = tl_turn_factor(v);
    for (int32_t j = 0; j < 3; ++j) {
      real axis[3];
      tl_turn_axis(v, twice, j, &axis[0]);
      tl_turn_by(&frame->R, &axis[0]);
      for (int32_t k = 0; k < 3; ++k) {
        points[frame->of].axes[(3 * j) + k] = axis[k];
      }
    }
  }
}

/// What an argument says of a joint.
TL_INLINE real tl_number_of(const TlInputNumber* number, const real* argument) {
  return (number->at < 0) ? TL_ZERO : (number->factor * argument[number->at]);
}

TL_INLINE void tl_copy_rotors(const TlLink* from, int32_t count, real* to) {
  for (int32_t i = 0; i < count; ++i) {
    to[i] = from[i].rotor;
  }
}

TL_INLINE void tl_give_rotors(
    const TlInputNumber* numbers, int32_t count, const real* argument, real* rotors) {
  for (int32_t i = 0; i < count; ++i) {
    rotors[numbers[i].of] = tl_number_of(&numbers[i], argument);
  }
}

TL_INLINE void tl_copy_drives(
    const TlLinkDrive* from, int32_t count, TlLinkDrive* to) {
  for (int32_t i = 0; i < count; ++i) {
    to[i].damping = from[i].damping;
    to[i].stiffness = from[i].stiffness;
    to[i].rest = from[i].rest;
  }
}

TL_INLINE void tl_give_dampings(const TlInputNumber* numbers, int32_t count,
    const real* argument, TlLinkDrive* drives) {
  for (int32_t i = 0; i < count; ++i) {
    drives[numbers[i].of].damping = tl_number_of(&numbers[i], argument);
  }
}

TL_INLINE void tl_copy_frictions(
    const TlLinkFriction* from, int32_t count, TlLinkFriction* to) {
  for (int32_t i = 0; i < count; ++i) {
    to[i].force = from[i].force;
    to[i].sharpness = from[i].sharpness;
  }
}

TL_INLINE void tl_give_frictions(const TlInputNumber* numbers, int32_t count,
    const real* argument, TlLinkFriction* frictions) {
  for (int32_t i = 0; i < count; ++i) {
    frictions[numbers[i].of].force = tl_number_of(&numbers[i], argument);
  }
}
