#pragma once

/// The program; the board calls it once.
void run();

/// A clock. `instructions_since` converts its differences to instructions.
unsigned ticks();
unsigned instructions_since(unsigned start);

/// Prints text on the host.
void print(const char* text);
