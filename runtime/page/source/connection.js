// The connection to `treeline drive`: one WebSocket, opened again whenever it is lost.

const kVersion = 1;
const kFirstRetry = 250;   // ms; doubled after every failure
const kLongestRetry = 2000;  // ms
const kSilence = 1500;     // ms without a state after which the servo is called silent

/**
 * Sends lines of the command language and reports what comes back. Events, each with the message
 * as `detail`: `hello`, `state`, `note`, `reply`, and `link` with {open, silent, retry_in}.
 */
export class Connection extends EventTarget {
  #socket = null;
  #sequence = 0;
  #waiting = new Map();
  #retry = kFirstRetry;
  #robot = '';
  #seen = 0;
  #heard = 0;
  #silent = false;

  /** `address` is that of the socket, with the token that may command. */
  constructor(address) {
    super();
    this.address = address;
    setInterval(() => this.#watch_silence(), 250);
  }

  get is_open() {
    return this.#socket?.readyState === WebSocket.OPEN && this.#robot !== '';
  }

  open() {
    this.#robot = '';
    this.#socket = new WebSocket(this.address);
    this.#socket.addEventListener('message', (event) => this.#receive(event.data));
    this.#socket.addEventListener('close', () => this.#lose());
  }

  /**
   * Sends one line. Returns the server's reply {ok, text}; a connection that is closed, or lost
   * before the reply, is a reply that says so.
   */
  send(text) {
    if (!this.is_open) {
      return Promise.resolve({ok: false, text: `not sent, there is no connection: ${text}`});
    }
    const seq = ++this.#sequence;
    this.#socket.send(JSON.stringify(
      {type: 'command', version: kVersion, robot: this.#robot, seq, seen: this.#seen, text}));
    return new Promise((resolve) => this.#waiting.set(seq, resolve));
  }

  #receive(data) {
    let message;
    try {
      message = JSON.parse(data);
    } catch {
      this.#emit('note', {text: 'a message of the server cannot be read'});
      return;
    }
    if (message.type === 'hello') this.#greet(message);
    if (message.type === 'state') this.#note_state(message.seq);
    if (message.type === 'reply') {
      this.#waiting.get(message.seq)?.(message);
      this.#waiting.delete(message.seq);
    }
    this.#emit(message.type, message);
  }

  #greet(hello) {
    if (hello.version !== kVersion) {
      this.#emit('note', {text: `the server speaks version ${hello.version} of the protocol, ` +
        `this page version ${kVersion}: load the page again`});
    }
    this.#robot = hello.robot;
    this.#retry = kFirstRetry;
    this.#note_state(0);
    this.#emit('link', {open: true, silent: false});
  }

  #note_state(seq) {
    this.#seen = seq;
    this.#heard = performance.now();
    if (this.#silent) {
      this.#silent = false;
      this.#emit('link', {open: true, silent: false});
    }
  }

  #watch_silence() {
    if (this.is_open && !this.#silent && performance.now() - this.#heard > kSilence) {
      this.#silent = true;
      this.#emit('link', {open: true, silent: true});
    }
  }

  #lose() {
    this.#robot = '';
    this.#silent = false;
    for (const resolve of this.#waiting.values()) {
      resolve({ok: false, text: 'the connection was lost before the reply'});
    }
    this.#waiting.clear();
    this.#emit('link', {open: false, silent: false, retry_in: this.#retry});
    setTimeout(() => this.open(), this.#retry);
    this.#retry = Math.min(2 * this.#retry, kLongestRetry);
  }

  #emit(name, detail) {
    this.dispatchEvent(new CustomEvent(name, {detail}));
  }
}

/** Address of the socket for the page at `location`, with the page's own token. */
export function socket_address(location) {
  const token = new URLSearchParams(location.search).get('token');
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  const query = token ? `?token=${encodeURIComponent(token)}` : '';
  return `${scheme}://${location.host}/socket${query}`;
}
