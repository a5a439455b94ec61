// Speaks the protocol of `treeline drive` for a robot without dynamics (mock_robot.mjs), so that
// the page is tested by itself: with a server that can fall silent or go away when a test asks.
//   TREELINE_PAGE=FOLDER node mock_server.mjs [PORT]
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

import {kCommands, obey} from './mock_commands.mjs';
import {MockRobot} from './mock_robot.mjs';
import {kPage, kSource, load_package} from './packages.mjs';

const kToken = 'mock';
const kLease = 0.125;  // s
const kMissing = {'broken.stl': 'it is cut short: 3 triangles take 234 bytes, it has 100. Copy it again.'};
const kTypes = {html: 'text/html', js: 'text/javascript', css: 'text/css'};

function write_hello({robot, checksum, meshes}, may_command) {
  return {type: 'hello', version: 1, robot: checksum, name: 'puma560', base: 'fixed', rate: 1000,
    may_command, lease: kLease,
    coordinates: robot.moving.map(({name, lower, upper, velocity, effort}) => ({name, joint: name,
      kind: 'angle', unit: 'rad', lower, upper, velocity, effort})),
    points: [{name: 'tool', link: 'tool', origin: [0, 0, 0, 0, 0, 0, 1],
      rows: ['x', 'y', 'z', 'rx', 'ry', 'rz'], axes: 'world'}],
    links: robot.moving.map((joint) => joint.child), locked: {},
    controls: ['joint', 'task', 'gravity'], missing_meshes: kMissing,
    meshes: Object.fromEntries(Object.keys(meshes).map((name, i) => [name, `/mesh/${i}`])),
    commands: kCommands};
}

function write_state(robot, client, clients) {
  const {at, turn} = robot.tip_at(robot.q);
  const spread = (center) => Array.from({length: 60}, (_, i) =>
    Math.round(robot.time * 1000 * Math.exp(-((i - center) ** 2) / 4)));
  const times = {mean: 11 + Math.sin(robot.time), p99: 17, max: 24};
  return {type: 'state', seq: ++client.states, time: robot.time, mode: robot.mode,
    control: robot.control, fault: robot.fault, moving: robot.motions.size > 0, q: robot.q,
    qd: robot.qd, tau: robot.q.map((q, i) => 30 * Math.sin(q) / (i + 1)), goal_q: robot.goal,
    points: [{at, turn, goal: robot.goal_at, goal_turn: robot.goal_turn, free: false,
      force: [0, 0, 40]}],
    center_of_mass: [0.1, 0.05, 0.7],
    forces: [{of: 'hand', link: 'tool', at, force: [0, 0, 40]}], control_us: times, period_us: times,
    jitter_us: times, histogram: {width_us: 10, period_from_us: 800, period: spread(20),
      jitter: spread(2), control: spread(1)}, cycles: Math.round(1000 * robot.time), overruns: 0,
    saturated: false, counts: {malformed: 0, foreign: 0, repeated: 0, late: 0, excess: 0,
      refused: 0},
    commanding: clients.commander === client, commander: clients.commander !== null,
    watchers: clients.all.size};
}

/** Who may, and who has the command; then what the line says. */
function answer(robot, client, clients, text) {
  if (!client.may_command && text !== 'stop') {
    return {ok: false, text: 'this page may only watch and `stop`'};
  }
  if (text === 'take' || (clients.commander === null && text !== 'stop')) {
    if (clients.commander !== null && clients.commander !== client) {
      return {ok: false, text: 'another front end has the command'};
    }
    clients.commander = client;
    if (text === 'take') return {ok: true, text: 'you have the command'};
  }
  if (text !== 'stop' && clients.commander !== client) {
    return {ok: false, text: 'another front end has the command: say `take`'};
  }
  if (text === 'give') {
    clients.commander = null;
    return {ok: true, text: 'the command is free'};
  }
  return obey(robot, text);
}

export class MockServer {
  /** Newest lines that were obeyed or refused: {text, ok, time}. */
  received = [];
  /** Names of meshes as they were asked for. */
  fetched = [];
  silent = false;
  checksum = 'c0ffee';
  #sockets = new Set();

  /**
   * Serves a PUMA 560, or `urdf`, whose joints stand behind their parents. `meshes` are bytes by the
   * name that the URDF gives them; what it names beside is missing.
   */
  constructor(urdf, meshes = {}) {
    const puma = path.join(kSource, 'robots/puma560/puma560.urdf');
    this.urdf = urdf ?? fs.readFileSync(puma, 'utf8');
    this.meshes = meshes;
    this.robot = new MockRobot(this.urdf, 'tool');
    this.clients = {all: new Set(), commander: null};
  }

  /** Begins to serve on `port` (0: any). Resolves when the address is known. */
  async listen(port = 0) {
    const {WebSocketServer} = load_package('ws');
    this.http = http.createServer((request, response) => this.#serve(request, response));
    this.http.on('connection', (socket) => {
      this.#sockets.add(socket);
      socket.on('close', () => this.#sockets.delete(socket));
    });
    const sockets = new WebSocketServer({server: this.http, maxPayload: 4096});
    sockets.on('connection', (socket, request) => this.#greet(socket, request));
    await new Promise((resolve) => this.http.listen(port, '127.0.0.1', resolve));
    this.port = this.http.address().port;
    this.address = `http://127.0.0.1:${this.port}/?token=${kToken}`;
    this.watching_address = `http://127.0.0.1:${this.port}/`;
    this.timers = [setInterval(() => this.robot.step(0.01), 10),
      setInterval(() => this.#report(), 33)];
  }

  /** Ends, and cuts all connections. */
  async close() {
    for (const timer of this.timers) clearInterval(timer);
    for (const socket of this.#sockets) socket.destroy();
    this.clients = {all: new Set(), commander: null};
    await new Promise((resolve) => this.http.close(resolve));
  }

  #serve(request, response) {
    const {pathname} = new URL(request.url, 'http://127.0.0.1');
    const name = pathname === '/' ? 'index.html' : pathname.slice(1);
    const type = kTypes[name.split('.').at(-1)];
    const mesh = Object.values(this.meshes)[Number(name.match(/^mesh\/(\d+)$/)?.[1])];
    if (mesh) this.fetched.push(name);
    if (name === 'robot.urdf' || mesh) {
      response.end(mesh ?? this.urdf);
    } else if (type && !name.includes('/') && fs.existsSync(path.join(kPage, name))) {
      response.setHeader('Content-Type', type);
      response.end(fs.readFileSync(path.join(kPage, name)));
    } else {
      response.statusCode = 404;
      response.end();
    }
  }

  #greet(socket, request) {
    const token = new URL(request.url, 'http://127.0.0.1').searchParams.get('token');
    const client = {socket, may_command: token === kToken, states: 0};
    this.clients.all.add(client);
    socket.send(JSON.stringify(write_hello(this, client.may_command)));
    socket.on('close', () => {
      this.clients.all.delete(client);
      if (this.clients.commander === client) this.clients.commander = null;
    });
    socket.on('message', (data) => this.#receive(client, JSON.parse(data)));
  }

  #receive(client, {seq, robot, text}) {
    if (robot !== this.checksum) return;
    const reply = answer(this.robot, client, this.clients, text);
    this.received.push({text, ok: reply.ok, time: performance.now()});
    client.socket.send(JSON.stringify({type: 'reply', seq, ...reply}));
  }

  #report() {
    if (this.silent) return;
    for (const client of this.clients.all) {
      client.socket.send(JSON.stringify(write_state(this.robot, client, this.clients)));
    }
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const server = new MockServer();
  await server.listen(Number(process.argv[2] ?? 0));
  console.log(server.address);
}
