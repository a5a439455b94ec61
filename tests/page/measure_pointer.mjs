// Measures how long a movement of the pointer takes to the torque of `treeline drive`, in a browser
// without a screen: from the time stamp of the browser's event to the time at which the line was in
// the control loop's mailbox, which the reply states. Both are of this machine's clock. The torque
// changes in the next cycle of the loop: add at most one period, 1 ms.
//   TREELINE_PAGE=FOLDER TREELINE_DRIVE=PROGRAM node measure_pointer.mjs [MOVEMENTS]
import os from 'node:os';

import {launch_browser, open_page, type_line, where} from './browser.mjs';
import {DriveServer} from './drive_server.mjs';

const kMovements = Number(process.argv[2] ?? 200);
const kPause = 150;  // ms between movements, longer than the page waits between lines

/** Keeps times of pointer events, lines and replies, in ms. */
function watch_lines() {
  window.moved = [];
  window.times = [];
  const name = 'onpointerrawupdate' in window ? 'pointerrawupdate' : 'pointermove';
  addEventListener(name, (event) => window.moved.push(event.timeStamp), {capture: true});
  const sent = new Map();
  const send = WebSocket.prototype.send;
  let last = '';
  WebSocket.prototype.send = function keep(text) {
    const {seq, text: line} = JSON.parse(text);
    if (line.startsWith('drag') && line !== last && window.moved.length > 0) {
      sent.set(seq, [window.moved.at(-1), performance.now()]);
    }
    last = line;
    if (!this.is_watched) {
      this.is_watched = true;
      this.addEventListener('message', ({data}) => {
        const {type, seq: answered, clock} = JSON.parse(data);
        if (type !== 'reply' || !sent.has(answered)) return;
        window.times.push([...sent.get(answered), clock - performance.timeOrigin,
          performance.now()]);
      });
    }
    send.call(this, text);
  };
}

function describe(name, values) {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1))].toFixed(1);
  console.log(`${name}: median ${at(0.5)} ms, 90 % ${at(0.9)} ms, largest ${at(1)} ms`);
}

const server = new DriveServer();
await server.start(['robots/puma560/puma560.urdf', 'robots/puma560/scene.yaml']);
const browser = await launch_browser();
const page = await open_page(browser, server.address);
await type_line(page, 'start');
await type_line(page, 'joint joint2 to -40 deg in 1 s');
await page.waitForTimeout(1500);
await page.evaluate(watch_lines);
const {x, y} = await where(page, 'disk:joint1');
await page.mouse.move(x, y);
await page.mouse.down();
for (let i = 1; i <= kMovements; ++i) {
  await page.mouse.move(x + 20 * Math.sin(i), y + 2 * Math.sin(i));
  await page.waitForTimeout(kPause + (i * 7) % 33);
}
await page.mouse.up();
const times = await page.evaluate(() => window.times);
console.log(`${times.length} movements`);
describe('event to line', times.map(([moved, sent]) => sent - moved));
describe('line to mailbox', times.map(([, sent, taken]) => taken - sent));
describe('mailbox to reply', times.map(([, , taken, replied]) => replied - taken));
describe('event to mailbox', times.map(([moved, , taken]) => taken - moved));
console.log(`load average ${os.loadavg().map((load) => load.toFixed(1)).join(' ')}, ` +
  `${os.cpus().length} processors`);
await browser.close();
process.exit(await server.close());
