#pragma once

#include "digits/digits50.hpp"

namespace treeline::interpreter {

using treeline::Digits50;

}  // namespace treeline::interpreter
