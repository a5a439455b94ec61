// Would catch: a replay that looks like the robot as it is, shows another moment than it says, lets
// a gesture reach the robot, does not come back, or hides a fault; plots that lack what was chosen,
// read other values than were received, or go on while they are paused.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {drag, launch_browser, open_page, state_of, straight, type_line, wait_for_state} from
  './browser.mjs';
import {MockServer} from './mock_server.mjs';

const server = new MockServer();
let browser;
let page;
before(async () => {
  await server.listen();
  browser = await launch_browser();
  page = await open_page(browser, server.address);
  await type_line(page, 'start');
  await type_line(page, 'joint joint1 to 1 rad in 1 s');
  await wait_for_state(page, (state) => Math.abs(state.q[0] - 1) < 1e-3);
});
after(async () => {
  await browser.close();
  await server.close();
});

function shown() {
  return page.evaluate(() => window.treeline.shown);
}

/** Values of a plot's legend by name, once they no longer change. */
async function read_legend(title) {
  await page.waitForTimeout(400);
  return page.evaluate((begin) => {
    const figure = [...document.querySelectorAll('.plots figure')].find((one) =>
      one.querySelector('figcaption').textContent.startsWith(begin));
    return figure && Object.fromEntries([...figure.querySelectorAll('.u-series')].map((one) =>
      [one.querySelector('.u-label').textContent, one.querySelector('.u-value').textContent]));
  }, title);
}

test('a replay shows the past and says so, and leaves the robot alone', async () => {
  const slider = page.locator('[aria-label="moment shown"]');
  await slider.focus();
  await page.keyboard.press('Home');
  const oldest = await shown();
  assert.ok(Math.abs(oldest.q[0] - 0.3) < 1e-3, `where it began, not ${oldest.q[0]}`);
  assert.match(await page.textContent('#past'), /past/);
  await page.waitForTimeout(300);
  assert.equal((await shown()).time, oldest.time, 'it stays');
  assert.ok((await state_of(page)).time > oldest.time, 'the robot goes on');
  server.received = [];
  await drag(page, 'disk:joint1', straight([60, 6], 6));
  assert.deepEqual(server.received, [], 'nothing can be grabbed');
  assert.ok(await page.isDisabled('button:text-is("Pull links")'));
  await page.selectOption('[aria-label="speed of the replay"]', '4');
  await page.click('button:text-is("Play")');
  await page.waitForFunction((time) => window.treeline.shown.time > time + 1, oldest.time);
  await page.click('.stop');
  await page.waitForFunction(() => /Fault/.test(document.querySelector('.chip.mode').textContent));
  assert.match(await page.textContent('#fault'), /emergency stop/, 'faults are those of now');
  await page.waitForFunction(() => document.querySelector('.play').textContent === 'Play');
  assert.match(await page.textContent('#past'), /past/, 'its end is the past too');
  await page.click('button:text-is("Back to now")');
  await wait_for_state(page, () => true);
  await page.waitForFunction(() => window.treeline.shown === window.treeline.state);
  assert.equal(await page.textContent('#past'), '');
  assert.deepEqual(page.faults, []);
});

test('plots show what was chosen, and its values at a moment', async () => {
  await page.click('#tab-Plots');
  assert.deepEqual(Object.keys(await read_legend('Position')),
    ['at', 'joint1', 'joint2', 'joint3', 'joint4', 'joint5', 'joint6']);
  await page.click('summary');
  await page.click('[aria-label^="joints of"] >> button:text-is("None")');
  await page.click('[aria-label^="joints of"] >> button:text-is("joint2")');
  await page.click('[aria-label="quantities"] >> button:text-is("Speed")');
  await page.focus('[aria-label="moment shown"]');
  await page.keyboard.press('Home');
  const {q, tau, time} = await shown();
  const position = await read_legend('Position');
  assert.deepEqual(Object.keys(position), ['at', 'joint2']);
  assert.ok(Math.abs(position.joint2 - q[1] * 180 / Math.PI) < 0.1, `${position.joint2} degrees`);
  assert.ok(Math.abs(parseFloat(position.at) - time) < 0.01, position.at);
  assert.ok(Math.abs((await read_legend('Torque')).joint2 - tau[1]) < 0.1);
  assert.deepEqual(Object.keys(await read_legend('Speed')), ['at', 'joint2']);
  await page.click('[aria-label="quantities"] >> button:text-is("Speed")');
  assert.equal(await read_legend('Speed'), undefined);
  await page.click('button:text-is("Back to now")');
  assert.deepEqual(page.faults, []);
});

test('a pause keeps the plots, a click shows the moment', async () => {
  const pause = page.locator('#panel-Plots button:text-is("Pause")');
  await pause.click();
  const before = await read_legend('Position');
  assert.deepEqual(await read_legend('Position'), before);
  await pause.click();
  const plot = await page.locator('.u-over').first().boundingBox();
  await page.mouse.move(plot.x + plot.width / 4, plot.y + plot.height / 2);
  const {at} = await read_legend('Position');
  await page.mouse.down();
  await page.mouse.up();
  assert.ok(Math.abs((await shown()).time - parseFloat(at)) < 0.3, at);
  await page.click('button:text-is("Back to now")');
  assert.deepEqual(page.faults, []);
});

test('plots go on where fewer states are in sight than before', async () => {
  await page.mouse.move(0, 0);
  await read_legend('Position');
  await page.selectOption('[aria-label="seconds shown"]', '5');
  const {at} = await read_legend('Position');
  await wait_for_state(page, (state) => state.time > parseFloat(at) + 1);
  assert.ok(parseFloat((await read_legend('Position')).at) > parseFloat(at), at);
  await page.selectOption('[aria-label="seconds shown"]', '20');
  assert.deepEqual(page.faults, []);
});
