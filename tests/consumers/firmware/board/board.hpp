#pragma once

/// What the program does; the board calls it once.
void run();

/// A clock; differences of it are turned into instructions by `instructions_since`.
unsigned ticks();
unsigned instructions_since(unsigned start);

/// Words to whoever runs the program.
void print(const char* text);
