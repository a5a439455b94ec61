#pragma once

#include <vector>

#include "inspect/recognise_robot.hpp"

namespace treeline {

/// Marks the second of two limbs that are halves of one leg as its side branch: of eight legs or
/// more, each turns about the line of its nearest neighbour, which is far nearer than the others,
/// as the two motors of each leg of a Minitaur. Files leave out where such halves meet.
void mark_half_legs(std::vector<Limb>& limbs);

}  // namespace treeline
