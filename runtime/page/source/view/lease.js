// A stream of lines that is obeyed only while it lasts: a drag.

const kPeriod = 33;    // ms between lines that only keep the lease
const kQuickest = 15;  // ms between lines that say something new
const kTick = 8;       // ms between looks at the clock

/**
 * Sends the newest line from `begin` to `end`, and nothing after: about 30 times a second while
 * the pointer rests, up to twice as often while it moves. A line that is new goes out at once,
 * unless another new one has just gone.
 */
export class Lease {
  #timer = 0;
  #line = null;
  #sent_line = null;
  #sent = -Infinity;
  #sent_new = -Infinity;

  /** `send(line)` sends. */
  constructor(send) {
    this.send = send;
  }

  get is_held() {
    return this.#timer !== 0;
  }

  begin() {
    this.end();
    this.#timer = setInterval(() => this.#send_if_due(), kTick);
  }

  /** The line from now on. */
  update(line) {
    this.#line = line;
    this.#send_if_due();
  }

  end() {
    clearInterval(this.#timer);
    this.#timer = 0;
    this.#line = null;
    this.#sent_line = null;
  }

  #send_if_due() {
    if (this.#line === null) return;
    const now = performance.now();
    const is_new = this.#line !== this.#sent_line;
    const due = is_new ? this.#sent_new + kQuickest : this.#sent + kPeriod;
    if (now < due) return;
    this.#sent = now;
    if (is_new) this.#sent_new = now;
    this.#sent_line = this.#line;
    this.send(this.#line);
  }
}
