#pragma once
// What arguments say of a robot that is a table of links: payloads, inertial parameters of links,
// rotors, friction, tools. C++17, freestanding.

#include <stdint.h>

#include "core/link_inertia.hpp"

namespace treeline::core::loops {

/// What the table says of links that arguments change.
template <class Real>
void copy_bodies(const Link<Real>* links, const int16_t* loaded_links, int count,
                 LinkBody<Real>* bodies) noexcept {
  for (int i = 0; i < count; ++i) {
    const LinkBody<Real>& from = links[loaded_links[i]].body;
    LinkBody<Real>& to = bodies[i];
    to.mass = from.mass;
    for (int k = 0; k < 3; ++k) {
      to.h[k] = from.h[k];
    }
    for (int k = 0; k < 6; ++k) {
      to.J[k] = from.J[k];
    }
  }
}

/// Adds the upper triangle of R M R^T of a symmetric matrix, which is lost.
template <class Real>
void add_turned(const InputFrame<Real>& frame, Real (&M)[9], Real (&sum)[6]) noexcept {
  turn_matrix_by(frame.R, M);
  int at = 0;
  for (int r = 0; r < 3; ++r) {
    for (int c = r; c < 3; ++c) {
      sum[at] = sum[at] + M[(3 * r) + c];
      ++at;
    }
  }
}

/// Adds what a body's distance from the link's origin adds to its rotational inertia: h is its
/// first moment about the frame's origin, in the link's axes (parallel axes).
template <class Real>
void add_distance(const InputFrame<Real>& frame, const Real& mass, const Real (&h)[3],
                  Real (&sum)[6]) noexcept {
  const Real(&p)[3] = frame.p;
  Real middle[3];
  for (int k = 0; k < 3; ++k) {
    middle[k] = h[k] + ((Real(0.5) * mass) * p[k]);
  }
  int at = 0;
  for (int r = 0; r < 3; ++r) {
    const int s = (r + 1) % 3;
    const int t = (r + 2) % 3;
    sum[at] = sum[at] + (Real(2.0) * ((p[s] * middle[s]) + (p[t] * middle[t])));
    ++at;
    for (int c = r + 1; c < 3; ++c) {
      sum[at] = sum[at] - ((p[r] * middle[c]) + (p[c] * middle[r]));
      ++at;
    }
  }
}

/// Adds a body: m, m c, Ixx, Ixy, Iyy, Ixz, Iyz, Izz in its frame.
template <class Real>
void add_body(const InputFrame<Real>& frame, const Real* given, LinkBody<Real>& body) noexcept {
  const Real mass = given[0];
  Real h[3];
  for (int k = 0; k < 3; ++k) {
    h[k] = given[k + 1];
  }
  Real J[9] = {given[4], given[5], given[7], given[5], given[6],
               given[8], given[7], given[8], given[9]};
  turn_by(frame.R, h);
  add_turned(frame, J, body.J);
  add_distance(frame, mass, h, body.J);
  for (int k = 0; k < 3; ++k) {
    body.h[k] = body.h[k] + h[k] + (mass * frame.p[k]);
  }
  body.mass = body.mass + mass;
}

/// Adds bodies that an argument gives.
template <class Real>
void add_bodies(const InputFrame<Real>* frames, int count, const Real* argument,
                LinkBody<Real>* bodies) noexcept {
  for (int i = 0; i < count; ++i) {
    add_body(frames[i], &argument[frames[i].at], bodies[frames[i].of]);
  }
}

/// Adds bodies of which an argument of `size` numbers gives some of the ten, as `entries` say, each
/// from that of its frame to the next body's. The others are 0.
template <class Real>
void add_parts_of_bodies(const InputFrame<Real>* frames, int count, const int16_t* entries,
                         int size, const Real* argument, LinkBody<Real>* bodies) noexcept {
  int end = size;
  for (int i = count - 1; i >= 0; --i) {
    Real given[10];
    for (int k = 0; k < 10; ++k) {
      given[k] = Real(0.0);
    }
    for (int k = frames[i].at; k < end; ++k) {
      given[entries[k]] = argument[k];
    }
    add_body(frames[i], &given[0], bodies[frames[i].of]);
    end = frames[i].at;
  }
}

template <class Real>
void copy_points(const LinkPoint<Real>* from, int count, LinkPoint<Real>* to) noexcept {
  for (int i = 0; i < count; ++i) {
    to[i].link = from[i].link;
    to[i].world = from[i].world;
    for (int k = 0; k < 9; ++k) {
      to[i].axes[k] = from[i].axes[k];
    }
    for (int k = 0; k < 3; ++k) {
      to[i].p[k] = from[i].p[k];
    }
  }
}

/// Puts the origins of points where an argument has them.
template <class Real>
void move_points(const InputFrame<Real>* frames, int count, const Real* argument,
                 LinkPoint<Real>* points) noexcept {
  for (int i = 0; i < count; ++i) {
    const InputFrame<Real>& frame = frames[i];
    Real p[3];
    for (int k = 0; k < 3; ++k) {
      p[k] = argument[frame.at + k];
    }
    turn_by(frame.R, p);
    for (int k = 0; k < 3; ++k) {
      points[frame.of].p[k] = p[k] + frame.p[k];
    }
  }
}

/// Gives points the axes of quaternions x y z w of any length.
template <class Real>
void turn_points(const InputFrame<Real>* frames, int count, const Real* argument,
                 LinkPoint<Real>* points) noexcept {
  for (int i = 0; i < count; ++i) {
    const InputFrame<Real>& frame = frames[i];
    const Real* const v = &argument[frame.at];
    const Real twice = turn_factor(v);
    for (int j = 0; j < 3; ++j) {
      Real axis[3];
      turn_axis(v, twice, j, axis);
      turn_by(frame.R, axis);
      for (int k = 0; k < 3; ++k) {
        points[frame.of].axes[(3 * j) + k] = axis[k];
      }
    }
  }
}

template <class Real>
void copy_rotors(const Link<Real>* from, int count, Real* to) noexcept {
  for (int i = 0; i < count; ++i) {
    to[i] = from[i].rotor;
  }
}

template <class Real>
void copy_drives(const LinkDrive<Real>* from, int count, LinkDrive<Real>* to) noexcept {
  for (int i = 0; i < count; ++i) {
    to[i].damping = from[i].damping;
    to[i].stiffness = from[i].stiffness;
    to[i].rest = from[i].rest;
  }
}

template <class Real>
void copy_frictions(const LinkFriction<Real>* from, int count, LinkFriction<Real>* to) noexcept {
  for (int i = 0; i < count; ++i) {
    to[i].force = from[i].force;
    to[i].sharpness = from[i].sharpness;
  }
}

/// What an argument says of a joint.
template <class Real>
Real number_of(const InputNumber& number, const Real* argument) noexcept {
  return (number.at < 0) ? Real(0.0) : argument[number.at];
}

template <class Real>
void give_rotors(const InputNumber* numbers, int count, const Real* argument,
                 Real* rotors) noexcept {
  for (int i = 0; i < count; ++i) {
    rotors[numbers[i].of] = number_of(numbers[i], argument);
  }
}

template <class Real>
void give_dampings(const InputNumber* numbers, int count, const Real* argument,
                   LinkDrive<Real>* drives) noexcept {
  for (int i = 0; i < count; ++i) {
    drives[numbers[i].of].damping = number_of(numbers[i], argument);
  }
}

template <class Real>
void give_frictions(const InputNumber* numbers, int count, const Real* argument,
                    LinkFriction<Real>* frictions) noexcept {
  for (int i = 0; i < count; ++i) {
    frictions[numbers[i].of].force = number_of(numbers[i], argument);
  }
}

}  // namespace treeline::core::loops
