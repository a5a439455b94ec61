#pragma once

#include <string>

#include "mutate_text.hpp"

namespace treeline::fuzz {

/// Reads a text as a line of the command language, as a message of a front end and as a packet of a
/// robot. Returns a description of the fault; empty if everything is right. Required: nothing is
/// thrown; an accepted command has finite numbers, names what the robot has, and keeps goals of
/// joints within limits; a refused one says why; the answer to a message is JSON of one line, and
/// nothing is sent to the loop for a message that is refused.
std::string try_drive(const std::string& text);

/// Returns the text with one word changed, copied, removed or exchanged, or one byte changed.
std::string mutate_drive(std::string text, Random& random);

}  // namespace treeline::fuzz
