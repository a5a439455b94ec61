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

/** Values of a plot's legend by name, as it stands; undefined if there is no such plot. */
function read_legend(title) {
  return page.evaluate((begin) => {
    const figure = [...document.querySelectorAll('.plots figure')].find((one) =>
      one.querySelector('figcaption').textContent.startsWith(begin));
    return figure && Object.fromEntries([...figure.querySelectorAll('.u-series')].map((one) =>
      [one.querySelector('.u-label').textContent, one.querySelector('.u-value').textContent]));
  }, title);
}

/** The legend of a plot once `holds` is true of it; machines that do much else draw late. */
async function legend_when(title, holds) {
  const end = performance.now() + 90000;
  for (;;) {
    const legend = await read_legend(title);
    if (legend && holds(legend)) return legend;
    if (performance.now() > end) {
      throw new Error(`did not come true: ${holds}\n${JSON.stringify(legend)}`);
    }
    await page.waitForTimeout(30);
  }
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
  const joints = ['joint1', 'joint2', 'joint3', 'joint4', 'joint5', 'joint6'];
  await legend_when('Position', (legend) => `${Object.keys(legend)}` === `at,${joints}`);
  await page.click('summary');
  await page.click('[aria-label^="joints of"] >> button:text-is("None")');
  await page.click('[aria-label^="joints of"] >> button:text-is("joint2")');
  await page.click('[aria-label="quantities"] >> button:text-is("Speed")');
  await page.focus('[aria-label="moment shown"]');
  await page.keyboard.press('Home');
  const {q, tau, time} = await shown();
  const is_then = (legend) => Math.abs(parseFloat(legend.at) - time) < 0.01;
  const position = await legend_when('Position', is_then);
  assert.deepEqual(Object.keys(position), ['at', 'joint2']);
  assert.ok(Math.abs(position.joint2 - q[1] * 180 / Math.PI) < 0.1, `${position.joint2} degrees`);
  assert.ok(Math.abs((await legend_when('Torque', is_then)).joint2 - tau[1]) < 0.1);
  assert.deepEqual(Object.keys(await legend_when('Speed', is_then)), ['at', 'joint2']);
  await page.click('[aria-label="quantities"] >> button:text-is("Speed")');
  assert.equal(await read_legend('Speed'), undefined);
  await page.click('button:text-is("Back to now")');
  assert.deepEqual(page.faults, []);
});

/** The legend of a plot that has stayed the same while two seconds of states arrived. */
async function kept_legend(title) {
  let legend = {};
  for (let kept = 0, tries = 0; kept < 4; ++kept, ++tries) {
    assert.ok(tries < 20, `it goes on: ${JSON.stringify(legend)}`);
    const {time} = await state_of(page);
    await wait_for_state(page, (state) => state.time > time + 0.5);
    const now = await read_legend(title);
    if (JSON.stringify(now) !== JSON.stringify(legend)) kept = -1;
    legend = now;
  }
  return legend;
}

test('a pause keeps the plots, a click shows the moment', async () => {
  const pause = page.locator('#panel-Plots button:text-is("Pause")');
  await pause.click();
  const before = await kept_legend('Position');
  const plot = await page.locator('.u-over').first().boundingBox();
  await page.mouse.move(plot.x + plot.width / 4, plot.y + plot.height / 2);
  const {at} = await legend_when('Position', (legend) => legend.at !== before.at);
  await page.mouse.down();
  await page.mouse.up();
  await page.waitForFunction((moment) => Math.abs(window.treeline.shown.time - moment) < 0.01,
    parseFloat(at));
  await pause.click();
  await page.click('button:text-is("Back to now")');
  assert.deepEqual(page.faults, []);
});

test('plots go on where fewer states are in sight than before', async () => {
  await page.mouse.move(0, 0);
  await page.selectOption('[aria-label="seconds shown"]', '5');
  const {time} = await state_of(page);
  await legend_when('Position', (legend) => parseFloat(legend.at) > time + 1);
  await page.selectOption('[aria-label="seconds shown"]', '20');
  assert.deepEqual(page.faults, []);
});
