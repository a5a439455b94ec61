// A stream of lines that is obeyed only while it lasts: a drag.

const kPeriod = 33;    // ms between lines that only keep the lease
const kQuickest = 15;  // ms between lines that say something new

/**
 * Sends the newest line from `begin` to `end`, and nothing after: about 30 times a second while
 * the pointer rests, up to twice as often while it moves.
 */
export class Lease {
  #timer = 0;
  #line = null;
  #sent = -Infinity;

  /** `send(line)` sends; it returns a promise of the reply. */
  constructor(send) {
    this.send = send;
  }

  get is_held() {
    return this.#timer !== 0;
  }

  begin() {
    this.end();
    this.#timer = setInterval(() => this.#send_if_due(kPeriod), kPeriod / 3);
  }

  /** The line from now on. It goes out at once if the last one is long enough ago. */
  update(line) {
    const period = line === this.#line ? kPeriod : kQuickest;
    this.#line = line;
    this.#send_if_due(period);
  }

  end() {
    clearInterval(this.#timer);
    this.#timer = 0;
    this.#line = null;
  }

  #send_if_due(period) {
    const now = performance.now();
    if (this.#line === null || now - this.#sent < period - 1) return;
    this.#sent = now;
    this.send(this.#line);
  }
}
