// A stream of lines that is obeyed only while it lasts: a drag.

const kPeriod = 33;  // ms between lines: about 30 a second

/** Sends the newest line about 30 times a second from `begin` to `end`, and nothing after. */
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
    this.#timer = setInterval(() => this.#send_if_due(), kPeriod / 3);
  }

  /** The line from now on. It goes out at once if the last one is long enough ago. */
  update(line) {
    this.#line = line;
    this.#send_if_due();
  }

  end() {
    clearInterval(this.#timer);
    this.#timer = 0;
    this.#line = null;
  }

  #send_if_due() {
    const now = performance.now();
    if (this.#line === null || now - this.#sent < kPeriod - 1) return;
    this.#sent = now;
    this.send(this.#line);
  }
}
