// Gestures on a PUMA 560 that `treeline drive` serves.
import assert from 'node:assert/strict';

import {drag, open_page, read_tip, state_of, straight, type_line, wait_for_state} from
  './browser.mjs';
import {Observer} from './observer.mjs';

const kSettled = 0.02;  // rad and m: a robot has arrived

function distance(a, b) {
  return Math.hypot(...a.map((x, i) => x - b[i]));
}

/** Waits until the robot rests, and all motions have ended unless the pointer is `held`. */
async function rest(observer, {held = false} = {}) {
  let since = Infinity;
  await observer.wait_until((state) => {
    const rests = (held || !state.moving) && state.qd.every((speed) => Math.abs(speed) < 0.005);
    since = rests ? Math.min(since, state.time) : Infinity;
    return state.time - since > 0.3;
  });
}

/** A page in command of a robot that runs and rests, and an observer that only watches. */
async function begin(browser, server, t) {
  const page = await open_page(browser, server.address);
  const observer = new Observer();
  t.after(async () => {
    observer.close();
    await page.close();
  });
  await observer.connect(server.watching_address);
  await type_line(page, 'take');
  if (observer.state.mode === 'faulted') await type_line(page, 'reset');
  if (observer.state.mode !== 'running') await type_line(page, 'start');
  await observer.wait_until((state) => state.mode === 'running');
  const pose = [10, -40, 60, 0, 45, 0];  // degrees
  for (const [i, angle] of pose.entries()) {
    await type_line(page, `joint joint${i + 1} to ${angle} deg in 0.5 s`);
  }
  await observer.wait_until((state) =>
    distance(state.q, pose.map((angle) => angle * Math.PI / 180)) < kSettled);
  await rest(observer);
  return {page, observer};
}

async function drags_a_disk(browser, server, t) {
  const {page, observer} = await begin(browser, server, t);
  const before = [...observer.state.q];
  await drag(page, 'disk:joint1', straight([90, 9], 20), {hold: true});
  const led = Number((await read_tip(page)).match(/to (-?[\d.]+)°/)[1]) * Math.PI / 180;
  await rest(observer, {held: true});
  await page.mouse.up();
  await rest(observer);
  const after = observer.state.q;
  assert.ok(Math.abs(led - before[0]) > 0.2, `joint1 led from ${before[0]} to ${led}`);
  assert.ok(Math.abs(after[0] - led) < kSettled, `joint1 at ${after[0]}, led to ${led}`);
  assert.ok(distance(before.slice(1), after.slice(1)) < kSettled, 'other joints stay');
  const shown = await page.inputValue('[aria-label="joint1, value"]');
  assert.ok(Math.abs(Number(shown) * Math.PI / 180 - after[0]) < 0.01, `the page shows ${shown}°`);
  assert.deepEqual(page.faults, []);
}

async function drags_a_plane(browser, server, t) {
  const {page, observer} = await begin(browser, server, t);
  const before = observer.state.points[0];
  await drag(page, 'plane:tool:yz', straight([-30, 24], 20), {hold: true});
  const led = (await read_tip(page)).match(/-?\d+\.\d+/g).map(Number);
  await rest(observer, {held: true});
  await page.mouse.up();
  await rest(observer);
  const after = observer.state.points[0];
  assert.ok(distance(led, before.at) > 0.05, 'the pointer led the tool away');
  assert.ok(Math.abs(led[0] - before.at[0]) < kSettled, 'x is not in the plane yz');
  assert.ok(distance(after.at, led) < kSettled, `the tool at ${after.at}, led to ${led}`);
  assert.deepEqual(page.faults, []);
}

async function drags_a_belt(browser, server, t) {
  const {page, observer} = await begin(browser, server, t);
  const before = observer.state.points[0];
  await drag(page, 'belt:tool:z', straight([30, 6], 20), {hold: true});
  const angle = Number((await read_tip(page)).match(/by (-?[\d.]+)°/)[1]) * Math.PI / 180;
  await rest(observer, {held: true});
  await page.mouse.up();
  await rest(observer);
  const after = observer.state.points[0];
  const dot = Math.abs(before.turn.reduce((sum, x, i) => sum + x * after.turn[i], 0));
  const turned = 2 * Math.acos(Math.min(dot, 1));
  assert.ok(Math.abs(angle) > 0.1, `led by ${angle}`);
  assert.ok(Math.abs(turned - Math.abs(angle)) < 0.03, `turned by ${turned}, led by ${angle}`);
  assert.ok(distance(after.at, before.at) < kSettled, 'the place stays');
  assert.deepEqual(page.faults, []);
}

/** The longest time between `begin` and `end` without one of `times`. */
function longest_gap(times, begin, end) {
  const marks = [begin, ...times.filter((time) => time > begin && time <= end), end];
  return Math.max(...marks.slice(1).map((time, i) => time - marks[i]));
}

/** A page that draws slowly sends late: its own timer says how late it may be. */
async function falls_silent_after_a_drag(browser, server, t) {
  const {page, observer} = await begin(browser, server, t);
  await page.evaluate(() => {
    window.sent = [];
    window.ticks = [];
    setInterval(() => window.ticks.push(performance.now()), 8);
    const send = WebSocket.prototype.send;
    WebSocket.prototype.send = function keep(text) {
      window.sent.push([performance.now(), JSON.parse(text).text]);
      send.call(this, text);
    };
  });
  await drag(page, 'disk:joint1', straight([40, 4], 10), {hold: true});
  await page.waitForTimeout(700);
  const held = await page.evaluate(() => performance.now());
  await page.mouse.up();
  const released = await page.evaluate(() => performance.now());
  await page.waitForTimeout(400);
  const {sent, ticks} = await page.evaluate(() => ({sent: window.sent, ticks: window.ticks}));
  const last = sent.filter(([time]) => time > held - 500 && time <= held);
  assert.ok(last.length >= 2 && last.length <= 18, `${last.length} lines in half a second`);
  const times = sent.map(([time]) => time);
  const slow = longest_gap(ticks, held - 500, held);
  assert.ok(longest_gap(times, held - 500, held) <= 34 + 2 * slow,
    `lines at ${times.map(Math.round)} up to ${held}, the page's own ticks within ${slow} ms`);
  assert.ok(last.every(([, text]) => text.startsWith('drag joint joint1 to ')));
  assert.deepEqual(sent.filter(([time]) => time > released), [], 'nothing after the release');
  await observer.wait_until((state) => Math.abs(state.qd[0]) < 0.01);
  assert.deepEqual(page.faults, []);
}

async function obeys_numbers(browser, server, t) {
  const {page, observer} = await begin(browser, server, t);
  const value = page.locator('[aria-label="joint1, value"]');
  await page.fill('#duration', '0.5');
  await value.fill('20');
  await value.press('Enter');
  await observer.wait_until((state) => Math.abs(state.q[0] - 20 * Math.PI / 180) < 0.02);
  await rest(observer);
  const before = observer.state.points[0].at;
  await page.click('#tab-Points');
  await page.fill('#duration', '3');
  await page.fill('[aria-label="move tool z"]', '-0.08');
  await page.click('form[aria-label="move tool"] button[type="submit"]');
  await observer.wait_until((state) => state.moving);
  const goal = [before[0], before[1], before[2] - 0.08];
  await rest(observer);
  assert.ok(distance(observer.state.points[0].at, goal) < kSettled,
    `at ${observer.state.points[0].at}, goal ${goal}`);
  const text = await page.textContent('#panel-Points .readout .number');
  assert.ok(distance(text.trim().split(/\s+/).map(Number), observer.state.points[0].at) < 0.005);
  assert.deepEqual(page.faults, []);
}

async function obeys_typed_lines(browser, server, t) {
  const {page, observer} = await begin(browser, server, t);
  const before = observer.state.points[0].at;
  await type_line(page, 'move tool by 0 0 -0.1 in 3 s');
  await observer.wait_until((state) => state.moving);
  await rest(observer);
  assert.ok(distance(observer.state.points[0].at, [before[0], before[1], before[2] - 0.1]) <
    kSettled);
  assert.match(await type_line(page, 'joint nobody to 3'), /nobody/);
  assert.equal(await page.locator('.log .bad').count(), 1);
  assert.deepEqual(page.faults, []);
}

/** `press(page)` stops the robot while it moves. */
async function stops(browser, server, t, press) {
  const {page, observer} = await begin(browser, server, t);
  await type_line(page, 'joint joint1 to -100 deg in 6 s');
  await wait_for_state(page, (state) => Math.abs(state.qd[0]) > 0.05);
  await press(page);
  await observer.wait_until((state) => state.mode === 'faulted' || state.mode === 'stopping');
  await observer.wait_until((state) => Math.abs(state.qd[0]) < 0.01);
  const stopped = observer.state.q[0];
  await page.waitForTimeout(500);
  assert.ok(Math.abs(observer.state.q[0] - stopped) < kSettled, 'it stays at rest');
  assert.ok(stopped > -95 * Math.PI / 180, 'it stopped on the way');
  assert.notEqual((await page.textContent('#fault')).trim(), '', 'the page says why');
  assert.match(await page.textContent('[aria-label="mode"]'), /Fault|Stopping/);
  await page.click('button:text-is("Reset")');
  await observer.wait_until((state) => state.mode === 'idle');
  assert.deepEqual(page.faults, []);
}

async function watches(browser, server, t) {
  const {page, observer} = await begin(browser, server, t);
  const watcher = await open_page(browser, server.watching_address);
  assert.match(await watcher.textContent('[aria-label="command"].chip'), /Watching, may stop/);
  const before = [...observer.state.q];
  for (const control of ['#command', '[aria-label="joint1, slider"]', '#duration',
    '[aria-label="joint1, value"]', 'button:text-is("Start")', 'button:text-is("Home")']) {
    assert.ok(await watcher.isDisabled(control), control);
  }
  await drag(watcher, 'disk:joint1', straight([60, 6], 10));
  await watcher.waitForTimeout(700);
  assert.ok(distance(observer.state.q, before) < kSettled, 'a watcher moves nothing');
  await type_line(page, 'joint joint1 by 20 deg in 3 s');
  await observer.wait_until((state) => state.moving);
  await rest(observer);
  await watcher.waitForTimeout(300);
  assert.ok(distance((await state_of(watcher)).q, observer.state.q) < kSettled,
    'a watcher sees the robot move');
  await type_line(page, 'joint joint1 by -20 deg in 6 s');
  await observer.wait_until((state) => state.moving);
  await watcher.click('.stop');
  await observer.wait_until((state) => state.mode === 'faulted');
  await page.waitForFunction(() =>
    /which may only watch, stops the robot/.test(document.querySelector('.log').textContent));
  assert.deepEqual(watcher.faults, []);
  await watcher.close();
  assert.deepEqual(page.faults, []);
}

async function hands_over(browser, server, t) {
  const {page} = await begin(browser, server, t);
  const other = await open_page(browser, server.address);
  await type_line(other, 'joint joint1 by 1 deg');
  assert.equal(await other.locator('.log .bad').count(), 1, 'only one commands');
  await page.click('button:text-is("Give command")');
  await wait_for_state(other, (state) => !state.commander);
  await other.click('button:text-is("Take command")');
  await wait_for_state(other, (state) => state.commanding);
  assert.match(await type_line(other, 'joint joint1 by 1 deg'), /joint1/);
  assert.deepEqual(other.faults, []);
  await other.close();
  assert.deepEqual(page.faults, []);
}

/**
 * Tests by name: each takes a browser, a server with `address` and `watching_address`, and the
 * test's context.
 */
export const kGestures = {
  'a disk turns its joint to where the pointer leads': drags_a_disk,
  'a plane moves its point, and only in the plane': drags_a_plane,
  'a belt turns its point about its axis': drags_a_belt,
  'a drag is about 30 lines a second, and none after': falls_silent_after_a_drag,
  'numbers do what gestures do': obeys_numbers,
  'typed lines move the robot, or say what is wrong': obeys_typed_lines,
  'the button stops': (browser, server, t) =>
    stops(browser, server, t, (page) => page.click('.stop')),
  'the space bar stops': (browser, server, t) => stops(browser, server, t, async (page) => {
    await page.focus('[aria-label="joint2, value"]');
    await page.keyboard.press('Space');
  }),
  'the space bar stops from an empty command line': (browser, server, t) =>
    stops(browser, server, t, async (page) => {
      await page.focus('#command');
      await page.keyboard.press('Space');
    }),
  'a watcher sees all and moves nothing': watches,
  'the command is handed over': hands_over,
};
