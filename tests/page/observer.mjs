// A front end without a page: what the server itself says, to compare with what a page shows.
import {load_package} from './packages.mjs';

export class Observer {
  hello = null;
  state = null;
  #sequence = 0;
  #replies = new Map();

  /** Connects with the token of the page's `address`, if it has one. */
  async connect(address) {
    const WebSocket = load_package('ws');
    const {host, search} = new URL(address);
    this.socket = new WebSocket(`ws://${host}/socket${search}`);
    this.socket.on('message', (data) => this.#receive(JSON.parse(data)));
    await this.wait_until(() => this.hello && this.state);
  }

  /** Sends a line; resolves with the reply. */
  send(text) {
    const seq = ++this.#sequence;
    this.socket.send(JSON.stringify({type: 'command', version: 1, robot: this.hello.robot, seq,
      seen: this.state?.seq ?? 0, text}));
    return new Promise((resolve) => this.#replies.set(seq, resolve));
  }

  /** Waits until `holds(state)`; fails after `timeout` ms with what the state was. */
  async wait_until(holds, timeout = 60000) {
    const end = performance.now() + timeout;
    while (!holds(this.state)) {
      if (performance.now() > end) {
        throw new Error(`did not come true: ${holds}\n${JSON.stringify(this.state)}`);
      }
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  close() {
    this.socket.close();
  }

  #receive(message) {
    if (message.type === 'hello') this.hello = message;
    if (message.type === 'state') this.state = message;
    if (message.type === 'reply') this.#replies.get(message.seq)?.(message);
  }
}
