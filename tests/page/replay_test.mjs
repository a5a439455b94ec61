// Would catch: a table that the page does not show, or shows elsewhere than where it says; an object
// that is not in the hand; a front end that can command what is only shown; a script that is over
// before anybody looks; a CSV of the page that is no table for the program.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {after, before, test} from 'node:test';

import {launch_browser, open_page, state_of, type_line, wait_for_state} from './browser.mjs';
import {DriveServer} from './drive_server.mjs';

let browser;
let folder;
before(async () => {
  browser = await launch_browser();
  folder = fs.mkdtempSync(path.join(os.tmpdir(), 'treeline_replay'));
});
after(async () => {
  await browser.close();
  fs.rmSync(folder, {recursive: true});
});

async function start(t, files, options) {
  const server = new DriveServer();
  t.after(() => server.close());
  await server.start(files, options);
  const page = await open_page(browser, server.address);
  t.after(() => page.close());
  return {server, page};
}

function write(name, text) {
  const file = path.join(folder, name);
  fs.writeFileSync(file, text);
  return file;
}

async function keep(page, name) {
  const kept = process.env.TREELINE_PICTURES;
  if (kept) await page.screenshot({path: path.join(kept, `${name}.png`)});
}

test('a table is shown', async (t) => {
  const table = write('turn.csv', `time,q_joint1\n${Array.from({length: 201},
    (_, i) => `${0.01 * i},${0.01 * i}`).join('\n')}\n`);
  const {page} = await start(t, ['robots/planar3r/planar3r.urdf', 'robots/planar3r/scene.yaml'],
    ['--replay', table]);
  await wait_for_state(page, (now) => now.q[0] > 1);
  const state = await state_of(page);
  // The stretched arm turns about z by joint1: its tip points where the angle says.
  const [x, y] = state.points[0].at;
  assert.ok(Math.abs(Math.atan2(y, x) - state.q[0]) < 1e-9, `${x} ${y} at ${state.q[0]}`);
  assert.equal(state.mode, 'replay');
  assert.equal(await page.textContent('.chip.mode'), 'Replay');
  for (const control of ['.stop', '#command', 'button:text-is("Start")']) {
    assert.ok(await page.isDisabled(control), control);
  }
  assert.match(await page.getAttribute('#command', 'placeholder'), /nothing can be commanded/);
  const offered = await page.locator('#panel-Plots [aria-label="quantities"] button').allTextContents();
  assert.ok(offered.includes('Position') && !offered.includes('Torque'), `${offered}`);
  // What is looked at stays, though the motion begins again.
  await page.focus('[aria-label="moment shown"]');
  await page.keyboard.press('Home');
  const {time} = await page.evaluate(() => window.treeline.shown);
  await wait_for_state(page, (now) => now.time < time + 1.5);
  assert.equal(await page.evaluate(() => window.treeline.shown.time), time);
  await page.click('button:text-is("Back to now")');
  await keep(page, 'replay_planar3r');
  assert.deepEqual(page.faults, []);
});

test('what the page has saved is shown again', async (t) => {
  const robot = 'robots/planar3r/planar3r.urdf';
  const {page} = await start(t, [robot], []);
  await type_line(page, 'start');
  await type_line(page, 'joint joint1 to 30 deg in 0.5 s');
  await wait_for_state(page, (now) => Math.abs(now.q[0] - Math.PI / 6) < 1e-3);
  const saved = (await state_of(page)).q[1];
  await page.click('#tab-Plots');
  const [download] = await Promise.all([page.waitForEvent('download'),
    page.click('button:text-is("Save CSV")')]);
  const table = path.join(folder, 'saved.csv');
  await download.saveAs(table);
  const again = await start(t, [robot], ['--replay', table]);
  await wait_for_state(again.page, (now) => Math.abs(now.q[0] - Math.PI / 6) < 1e-3);
  assert.ok(Math.abs((await state_of(again.page)).q[1] - saved) < 1e-3);
  assert.deepEqual(again.page.faults, []);
});

test('an object is in the hands', async (t) => {
  const table = write('still.csv', 'time,q_left_elbow\n0,-0.5\n1,-0.5\n');
  const {page} = await start(t,
    ['robots/humanoid24/humanoid24.urdf', 'robots/humanoid24/scene_box.yaml'], ['--replay', table]);
  await wait_for_state(page, (now) => now.mode === 'replay');
  const [box, hand] = await page.evaluate(() =>
    [window.treeline.where('link:box, held'), window.treeline.where('link:left_hand')]);
  const apart = Math.hypot(box.clientX - hand.clientX, box.clientY - hand.clientY);
  assert.ok(apart < 150, `${apart} pixels`);
  await keep(page, 'replay_box');
  assert.deepEqual(page.faults, []);
});

test('a robot that goes away stays in the picture', async (t) => {
  const table = write('walk.csv', `time,${Array.from({length: 31}, (_, i) => `q${i}`)}\n` +
    [0, 1, 2, 3, 4, 5, 6].map((x) => `${x / 2},${x},0,0,0,0,0,1${',0'.repeat(24)}\n`).join(''));
  const {page} = await start(t,
    ['robots/humanoid24/humanoid24.urdf', 'robots/humanoid24/scene_stand.yaml'],
    ['--replay', table]);
  await wait_for_state(page, (now) => now.q[0] > 5);
  const seen = await page.evaluate(() => window.treeline.where('link:head'));
  const {width, height} = page.viewportSize();
  assert.ok(seen.clientX > 0 && seen.clientX < width, `${seen.clientX}`);
  assert.ok(seen.clientY > 0 && seen.clientY < height, `${seen.clientY}`);
  assert.ok(await page.isDisabled('button:text-is("Start")'));
  await keep(page, 'replay_walk');
  assert.deepEqual(page.faults, []);
});

test('a script waits until somebody looks who may command', async (t) => {
  const script = write('script.txt', 'start\njoint joint1 to 0.5 in 10 s\nwait\n');
  const server = new DriveServer();
  t.after(() => server.close());
  await server.start(['robots/planar3r/planar3r.urdf'], ['--script', script]);
  const watcher = await open_page(browser, server.watching_address);
  t.after(() => watcher.close());
  await watcher.waitForTimeout(1000);
  assert.equal((await state_of(watcher)).mode, 'idle', 'whoever may only watch starts nothing');
  const page = await open_page(browser, server.address);
  t.after(() => page.close());
  assert.ok((await state_of(page)).q[0] < 0.4);
  await wait_for_state(page, (now) => Math.abs(now.q[0] - 0.5) < 1e-3);
  assert.match(server.said, /begins when the page is opened/);
});
