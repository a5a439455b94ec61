// Would catch: a page that does not say that the connection is lost, does not come back by itself,
// goes on leading the robot from before, or shows an old state as if it were new; a watcher's page
// whose stop is dead or whose other controls look alive; a drag of an idle robot that does nothing.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {drag, launch_browser, open_page, state_of, straight, type_line, wait_for_state} from
  './browser.mjs';
import {MockServer} from './mock_server.mjs';

let browser;
before(async () => { browser = await launch_browser(); });
after(() => browser.close());

async function begin(t) {
  const server = new MockServer();
  await server.listen();
  const page = await open_page(browser, server.address);
  t.after(async () => {
    await page.close();
    await server.close();
  });
  return {server, page};
}

function link_of(page) {
  return page.textContent('[aria-label="connection"]');
}

test('a lost connection is said, and comes back', async (t) => {
  const {server, page} = await begin(t);
  await type_line(page, 'start');
  const {port} = server;
  await server.close();
  await page.waitForSelector('#lost:not([hidden])');
  assert.equal(await link_of(page), 'Connection lost');
  assert.match(await type_line(page, 'joint joint1 to 1'), /not sent/);
  assert.ok(await page.isDisabled('button:text-is("Start")'));
  assert.ok(await page.isEnabled('.stop'), 'the stop stays enabled');
  await page.click('.stop');
  await page.waitForFunction(() =>
    document.querySelector('.log').lastChild.textContent.includes('not sent'));
  await server.listen(port);
  await page.waitForSelector('#lost', {state: 'hidden'});
  assert.equal(await link_of(page), 'Connected');
  const {time} = await state_of(page);
  await wait_for_state(page, (state) => state.time > time);
  assert.match(await type_line(page, 'start'), /start/);
  assert.deepEqual(page.faults, []);
});

test('a drag ends with the connection', async (t) => {
  const {server, page} = await begin(t);
  await type_line(page, 'start');
  await drag(page, 'disk:joint1', straight([40, 4], 8), {hold: true});
  const {port} = server;
  await server.close();
  await page.waitForSelector('#lost:not([hidden])');
  await server.listen(port);
  await page.waitForSelector('#lost', {state: 'hidden'});
  server.received = [];
  await page.mouse.move(600, 300);
  await page.waitForTimeout(500);
  await page.mouse.up();
  assert.deepEqual(server.received, [], 'nothing is sent until the pointer is pressed again');
});

test('a silent servo is said', async (t) => {
  const {server, page} = await begin(t);
  server.silent = true;
  await page.waitForSelector('#lost:not([hidden])');
  assert.equal(await link_of(page), 'Servo silent');
  server.silent = false;
  await page.waitForSelector('#lost', {state: 'hidden'});
  assert.equal(await link_of(page), 'Connected');
});

test('another robot behind the same address is shown', async (t) => {
  const {server, page} = await begin(t);
  const {port} = server;
  await server.close();
  server.urdf = server.urdf.replaceAll('joint1', 'waist');
  server.robot.moving[0].name = 'waist';
  server.checksum = 'decaf';
  await server.listen(port);
  await page.waitForSelector('[aria-label="waist, value"]');
  assert.equal(await page.locator('[aria-label="joint1, value"]').count(), 0);
  assert.ok((await page.evaluate(() => window.treeline.handles())).includes('disk:waist'));
  assert.deepEqual(page.faults, []);
});

test('a watcher can stop, and nothing else', async (t) => {
  const {server, page} = await begin(t);
  await type_line(page, 'start');
  const watcher = await open_page(browser, server.watching_address);
  t.after(() => watcher.close());
  for (const tab of ['Joints', 'Points', 'Control']) {
    await watcher.click(`#tab-${tab}`);
    const alive = await watcher.evaluate((name) => [...document.querySelectorAll(
      `#panel-${name} :is(button, input, select):enabled`)].map((one) => one.textContent), tab);
    assert.deepEqual(alive, tab === 'Joints' ? ['Degrees'] : [], tab);
  }
  for (const control of ['#command', '#duration', 'button:text-is("Start")',
    'button:text-is("Take command")', 'button:text-is("Pull links")']) {
    assert.ok(await watcher.isDisabled(control), control);
  }
  server.received = [];
  await watcher.click('.stop');
  await wait_for_state(page, (state) => state.mode === 'faulted');
  await type_line(page, 'reset');
  await watcher.keyboard.press('Space');
  await wait_for_state(page, (state) => state.mode === 'faulted');
  assert.deepEqual(watcher.faults, []);
});

test('a drag of an idle robot leads to Start', async (t) => {
  const {page} = await begin(t);
  await page.waitForTimeout(500);  // until it is drawn, it cannot be dragged
  await drag(page, 'disk:joint1', straight([40, 4], 4));
  await page.waitForSelector('button.offered:text-is("Start")');
  assert.match(await page.textContent('#fault'), /idle: press Start/);
  await page.click('#offer button:text-is("Start")');
  await wait_for_state(page, (state) => state.mode === 'running');
  await page.waitForFunction(() => !document.querySelector('.offered'));
  assert.ok(await page.isHidden('#offer button'));
  assert.equal(await page.textContent('#fault'), '');
});
