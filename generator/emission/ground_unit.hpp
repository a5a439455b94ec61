#pragma once

#include <array>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Parts of NAME_ground.h and ground.cpp: the functions that a step on the ground calls, and what
/// of the robot may touch it.
struct GroundUnit {
  Program flight;    ///< accelerations without the ground: `ground_flight`
  Program heights;   ///< of each group: `ground_heights`
  Program dynamics;  ///< what impulses need: `ground_dynamics`
  Program energy;    ///< kinetic and potential: `ground_energy`
  double friction = 0;

  /// A ball.
  struct Ball {
    std::array<double, 3> middle{};
    double radius = 0;
  };
  /// Balls of one radius about some points, or rims of disks about them.
  struct Shape {
    std::vector<std::array<double, 3>> points;  ///< in the group's frame
    double radius = 0;
    std::array<double, 3> axis{};   ///< of the disks; zero: balls
    std::array<double, 3> level{};  ///< a unit vector across it
  };
  /// Links that move as one.
  struct Group {
    std::string links;  ///< names of those with shapes
    int tip = 0;        ///< the last velocity that moves it
    std::vector<Shape> shapes;
    Ball around;
  };
  std::vector<Group> groups;
  std::vector<std::vector<int>> before;  ///< of each velocity those that carry it, outward
  int coordinates = 0;

  /// A joint with a quaternion.
  struct Turn {
    int q = 0, v = 0;
    bool slides = false;  ///< it moves freely; else it is a ball
  };
  std::vector<Turn> turns;

  [[nodiscard]] std::vector<const Program*> programs() const {
    return {&flight, &heights, &dynamics, &energy};
  }
};

}  // namespace treeline
