// Drives a robot for a long time with one front end that works and many that come, misbehave and go.
//   TREELINE_PAGE=FOLDER TREELINE_DRIVE=PROGRAM [LD_COUNT_HEAP=libcount_heap.so] node soak_drive.mjs [SECONDS [OTHERS]]
// Exit status 1: a command of the good front end was not obeyed, the robot ended in a fault, the
// memory of the program grew by more than a tenth after the first minute, or its servo thread took
// memory from the heap. Prints how late replies were while others asked for a mesh of 200 MB, and
// how late without them.
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';

import {DriveServer} from '../page/drive_server.mjs';
import {kSource, load_package} from '../page/packages.mjs';
import {dice} from './dice.mjs';

const {WebSocket} = load_package('ws');

const kSeconds = Number(process.argv[2] ?? 600);
const kOthers = Number(process.argv[3] ?? 6);

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
let end = Infinity;  // of the soak, ms
const runs = () => performance.now() < end;

/** A front end that obeys the protocol. */
class FrontEnd {
  sequence = 0;
  asked = 0;
  replies = {obeyed: 0, refused: 0};
  state = null;
  last_refusal = '';
  /** ms from each command to its reply. */
  delays = [];
  #sent = new Map();

  constructor(address) {
    this.socket = new WebSocket(address);
    this.socket.addEventListener('message', ({data}) => this.#receive(JSON.parse(data)));
    this.ready = new Promise((resolve) => { this.greeted = resolve; });
  }

  send(text) {
    ++this.asked;
    this.#sent.set(this.sequence + 1, performance.now());
    this.socket.send(JSON.stringify({type: 'command', version: 1, robot: this.robot,
      seq: ++this.sequence, seen: this.state?.seq ?? 0, text}));
  }

  #receive(message) {
    if (message.type === 'hello') this.robot = message.robot;
    if (message.type === 'state') {
      this.state = message;
      this.greeted();
    }
    if (message.type !== 'reply') return;
    this.delays.push(performance.now() - this.#sent.get(message.seq));
    this.#sent.delete(message.seq);
    ++this.replies[message.ok ? 'obeyed' : 'refused'];
    if (!message.ok) this.last_refusal = message.text;
  }
}

/** What front ends do that do not obey it. Each uses an open socket and its robot's checksum. */
const kMischief = [
  (socket) => socket.send('{"type":'),
  (socket) => socket.send('\u0000\uffff'.repeat(500)),
  (socket) => socket.send('['.repeat(4000)),
  (socket) => socket.send('x'.repeat(100000)),
  (socket) => socket.send(new Uint8Array(3000)),
  (socket, robot) => {
    for (let i = 0; i < 2000; ++i) {
      socket.send(JSON.stringify({type: 'command', version: 1, robot, seq: i, text: 'joint'}));
    }
  },
  (socket) => {
    for (let i = 0; i < 50; ++i) {
      socket.send(JSON.stringify({type: 'command', version: 1, robot: 'other', seq: i,
        text: 'stop'}));
    }
  },
  (socket, robot) => {
    for (const seq of [5, 5, 4, 3]) {
      socket.send(JSON.stringify({type: 'command', version: 1, robot, seq, text: 'take'}));
    }
  },
];

let connected = 0;

/** Connects without the token, does something wrong, and goes away without a word. */
async function misbehave(address, random) {
  while (runs()) {
    const socket = new WebSocket(address);
    const robot = await new Promise((resolve) => {
      socket.addEventListener('message', ({data}) => {
        const message = JSON.parse(data);
        if (message.type === 'hello') resolve(message.robot);
      });
      socket.addEventListener('error', () => resolve(''));
      setTimeout(() => resolve(''), 3000);
    });
    if (socket.readyState === WebSocket.OPEN) {
      ++connected;
      kMischief[Math.floor(random() * kMischief.length)](socket, robot);
      await pause(300 * random());
    }
    socket.close();
    await pause(100 * random());
  }
}

/** Half a request, or none, over a bare connection that is then forgotten. */
async function stall(port, random) {
  while (runs()) {
    const socket = net.connect(port, '127.0.0.1', () => {
      socket.write(random() < 0.5 ? 'GET /socket HTTP/1.1\r\nHost: 127' : '\x16\x03\x01garbage');
    });
    socket.on('error', () => {});
    await pause(500 * random());
    socket.destroy();
  }
}

/** planar3r with a mesh of 200 MB, which takes no place on the disk. */
function write_robot(folder) {
  fs.writeFileSync(path.join(folder, 'large.stl'), '');
  fs.truncateSync(path.join(folder, 'large.stl'), 200e6);
  const urdf = fs.readFileSync(path.join(kSource, 'robots/planar3r/planar3r.urdf'), 'utf8');
  const visual = '<visual><geometry><mesh filename="large.stl"/></geometry></visual>';
  const file = path.join(folder, 'planar3r.urdf');
  fs.writeFileSync(file, urdf.replace(/(<link name="link1"[^>]*>)/, `$1${visual}`));
  return path.relative(kSource, file);
}

/** Median, 99 % and largest of delays, ms. */
function describe(delays) {
  const sorted = [...delays].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return `${at(0.5).toFixed(2)} ms at the median, ${at(0.99).toFixed(2)} at 99 %, ` +
    `${at(1).toFixed(2)} the largest`;
}

function memory_of(pid) {
  const text = fs.readFileSync(`/proc/${pid}/status`, 'utf8');
  return Number(text.match(/VmRSS:\s+(\d+)/)[1]) / 1024;  // MiB
}

const counts_heap = process.env.LD_COUNT_HEAP;
if (counts_heap) process.env.LD_PRELOAD = counts_heap;
const server = new DriveServer();
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'treeline_soak'));
await server.start([write_robot(folder)]);
delete process.env.LD_PRELOAD;
const url = new URL(server.address);
const socket = `ws://${url.host}/socket`;
const good = new FrontEnd(`${socket}${url.search}`);
await good.ready;
good.send('start');
await pause(500);
for (let i = 0; i < 300; ++i) {
  good.send('hold');
  await pause(33);
}
const quiet = good.delays;
good.delays = [];
end = performance.now() + 1000 * kSeconds;
const others = [];
for (let i = 0; i < kOthers; ++i) others.push(misbehave(socket, dice(i + 1)));
others.push(stall(Number(url.port), dice(99)));
// In a process of its own, since reading so much would delay the good front end itself.
const asking = spawn(process.execPath, [path.join(import.meta.dirname, 'ask_for_mesh.mjs'),
  server.address, String(kSeconds)], {stdio: ['ignore', 'pipe', 'inherit']});
let asked_for_mesh = '';
asking.stdout.on('data', (data) => { asked_for_mesh += data; });
others.push(new Promise((resolve) => asking.on('exit', resolve)));
const begun = performance.now();
let steady_memory = 0;
for (let i = 0; runs(); ++i) {
  good.send(`drag joint joint1 to ${(0.5 * Math.sin(i / 60)).toFixed(4)}`);
  if (steady_memory === 0 && performance.now() - begun > Math.min(60000, 250 * kSeconds)) {
    steady_memory = memory_of(server.program.pid);
  }
  await pause(33);
}
await Promise.all(others);
await pause(1000);
const memory = memory_of(server.program.pid);
const {mode, fault, cycles, overruns, period_us: period, jitter_us: jitter, counts} = good.state;
console.log(`${kSeconds} s, ${connected} connections of others, load average ` +
  `${os.loadavg()[0].toFixed(1)} on ${os.cpus().length} processors`);
console.log(`good front end: ${good.asked} commands, ${good.replies.obeyed} obeyed, ` +
  `${good.replies.refused} refused ${good.last_refusal}`);
console.log(`replies: ${describe(good.delays)}; before the others came: ${describe(quiet)}; ` +
  asked_for_mesh.trim());
console.log(`loop: ${mode} ${fault}, ${cycles} cycles, ${overruns} late; last second: period ` +
  `${period.mean.toFixed(1)} us, jitter ${jitter.p99.toFixed(1)} us at 99 %`);
console.log(`refused: ${JSON.stringify(counts)}`);
console.log(`memory: ${steady_memory.toFixed(1)} MiB after the first minute, ${memory.toFixed(1)} at the end`);
const status = await server.close();
fs.rmSync(folder, {recursive: true});
const heap = server.said.match(/servo threads: (\d+) waits, (\d+) allocations/);
if (heap) console.log(heap[0]);
const failed = good.replies.obeyed < good.asked - good.replies.refused || mode !== 'running' ||
  status !== 0 || memory > 1.1 * steady_memory || (counts_heap && (!heap || Number(heap[2]) > 0));
process.exit(failed ? 1 : 0);
