// Would catch: handles that cannot be grabbed or lead elsewhere, drags that do not end, a stop that
// does not stop, panels that show something else than the server says. With the mock server: what
// the page does by itself.
import {after, before, test} from 'node:test';

import {launch_browser} from './browser.mjs';
import {kGestures} from './gestures.mjs';
import {MockServer} from './mock_server.mjs';

const server = new MockServer();
let browser;
before(async () => {
  await server.listen();
  browser = await launch_browser();
});
after(async () => {
  await browser.close();
  await server.close();
});

for (const [name, run] of Object.entries(kGestures)) {
  test(name, (t) => run(browser, server, t));
}
