// A library that can be loaded and is no peer.
extern "C" [[gnu::visibility("default")]] int answer() {
  return 42;
}
