// A library that can be loaded but is not a peer.
extern "C" [[gnu::visibility("default")]] int answer() {
  return 42;
}
