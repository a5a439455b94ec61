// The host in the place of the board.
#include <cstdio>

#include "board.hpp"

unsigned ticks() {
  return 0;
}

unsigned instructions_since(unsigned) {
  return 0;
}

void print(const char* text) {
  std::fputs(text, stdout);
}

int main() {
  run();
}
