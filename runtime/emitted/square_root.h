#pragma once
// Gives `real tl_root(real x)`, the square root of x, and 0 for what rounding has
// made negative.
