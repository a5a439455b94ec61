// Would catch: a control loop of somebody's own that the page does not show, lead or stop; numbers of
// its own that cannot be plotted; controls of the page that do nothing for it; a drive that ends
// because the loop is started again.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import path from 'node:path';
import {after, before, test} from 'node:test';

import {launch_browser, open_page, state_of, type_line, wait_for_state} from './browser.mjs';
import {DriveServer} from './drive_server.mjs';
import {kSource} from './packages.mjs';

const kPort = 20000 + process.pid % 20000;
const kPatience = 60000;  // ms: machines may do much else

let browser;
before(async () => { browser = await launch_browser(); });
after(() => browser.close());

/** The loop in a process of its own. */
class OwnLoop {
  said = '';

  constructor(t) {
    this.program = spawn('python3', [path.join(kSource, 'tests/page/own_loop.py'),
      path.join(kSource, 'runtime/python/treeline'), String(kPort)], {stdio: ['ignore', 'pipe', 'inherit']});
    this.program.stdout.on('data', (data) => { this.said += data; });
    this.ended = new Promise((resolve) => this.program.on('exit', resolve));
    t.after(() => this.end());
  }

  async says(word) {
    const end = performance.now() + kPatience;
    while (!this.said.trimEnd().endsWith(word)) {
      assert.ok(performance.now() < end, `not said: ${word}\n${this.said}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  end() {
    this.program.kill('SIGKILL');
    return this.ended;
  }
}

test('a control loop of one\'s own', async (t) => {
  let loop = new OwnLoop(t);
  await loop.says('listens');
  const server = new DriveServer();
  t.after(() => server.close());
  await server.start(['robots/planar3r/planar3r.urdf', 'robots/planar3r/scene.yaml'],
    ['--robot', `controller:127.0.0.1:${kPort}`]);
  const page = await open_page(browser, server.address);
  t.after(() => page.close());
  assert.deepEqual((await state_of(page)).q, [0.2, 0.4, 0.6]);
  assert.deepEqual((await state_of(page)).tau, [1, 2, 3]);

  await t.test('is led', async () => {
    await page.click('button:text-is("Start")');
    await loop.says('enabled');
    await type_line(page, 'joint joint1 to 0.5 in 1 s');
    await wait_for_state(page, (state) => !state.moving && Math.abs(state.q[0] - 0.5) < 1e-3);
  });

  await t.test('shows its numbers', async () => {
    await page.click('#tab-Plots');
    await page.waitForSelector('figcaption:text-matches("Shown by your controller")');
    assert.ok(Number.isFinite((await state_of(page)).shown.error));
  });

  await t.test('has gains of its own, and no twin', async () => {
    await page.click('#tab-Control');
    assert.equal(await page.isVisible('button:text-is("Rehearse")'), false);
    assert.equal(await page.isVisible('form[aria-label="gains of the joint control"]'), false);
    assert.match(await type_line(page, 'gains stiffness 1 damping 1'), /own controller/);
    assert.match(await type_line(page, 'rehearse'), /no rehearsals/);
  });

  await t.test('is stopped', async () => {
    await page.click('.stop');
    await loop.says('stopped');
    await wait_for_state(page, (state) => state.mode === 'faulted');
  });

  await t.test('may be started again', async () => {
    await type_line(page, 'reset');
    await type_line(page, 'start');
    await loop.says('enabled');
    await loop.end();
    await wait_for_state(page, (state) => state.fault.includes('no longer connected'));
    loop = new OwnLoop(t);
    await loop.says('listens');
    await wait_for_state(page, (state) => state.q[0] === 0.2);
    await type_line(page, 'reset');
    await type_line(page, 'start');
    await loop.says('enabled');
  });
  assert.deepEqual(page.faults, []);
});
