// Would catch: controls that the Tab key does not reach or whose focus is not seen, a space bar
// that stops in the middle of a command or does not stop elsewhere, history and completion that
// lose what was typed.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {launch_browser, open_page, type_line} from './browser.mjs';
import {MockServer} from './mock_server.mjs';

const server = new MockServer();
let browser;
let page;
before(async () => {
  await server.listen();
  browser = await launch_browser();
  page = await open_page(browser, server.address);
});
after(async () => {
  await browser.close();
  await server.close();
});

function focused() {
  return page.evaluate(() => {
    const {outlineStyle, outlineWidth} = getComputedStyle(document.activeElement);
    return {name: document.activeElement.getAttribute('aria-label') ??
        document.activeElement.textContent, tag: document.activeElement.tagName,
      seen: outlineStyle !== 'none' && outlineWidth !== '0px'};
  });
}

test('Tab reaches every control, and the focus is seen', async () => {
  await page.evaluate(() => document.activeElement.blur());
  const names = [];
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press('Tab');
    const {name, tag, seen} = await focused();
    if (tag === 'BODY') break;
    assert.ok(seen, `${name} shows its focus`);
    names.push(name);
  }
  const expected = ['Take command', 'Start', 'Hold', 'Brake', 'Reset', 'STOPspace', 'Pull links',
    'Fit', 'Top', 'Replay', 'moment shown', 'command', 'Joints', 'Degrees', 'joint1, slider', 'joint1, value', 'joint6, value'];
  let last = -1;
  for (const name of expected) {
    const place = names.indexOf(name);
    assert.ok(place > last, `${name} comes in its turn among ${names}`);
    last = place;
  }
});

test('every control has a name', async () => {
  for (const tab of ['Joints', 'Points', 'Control', 'Plots', 'View']) {
    await page.click(`#tab-${tab}`);
    const nameless = await page.evaluate(() => [...document.querySelectorAll(
      'button, input, select, [role]')].filter((one) => one.checkVisibility() &&
      !one.getAttribute('aria-label') && !one.getAttribute('aria-labelledby') &&
      !one.textContent.trim() && !one.labels?.length && one.getAttribute('role') !== 'alert')
      .map((one) => one.outerHTML));
    assert.deepEqual(nameless, []);
  }
  await page.click('#tab-Joints');
});

test('arrow keys change tabs', async () => {
  await page.focus('#tab-Joints');
  await page.keyboard.press('ArrowRight');
  assert.equal((await focused()).name, 'Points');
  assert.ok(await page.isVisible('#panel-Points'));
  assert.ok(await page.isHidden('#panel-Joints'));
  await page.keyboard.press('ArrowLeft');
});

test('the space bar is a blank in a command, and a stop everywhere else', async () => {
  await type_line(page, 'start');
  server.received = [];
  await page.focus('#command');
  await page.keyboard.type('joint joint1 to 3 deg');
  assert.equal(await page.inputValue('#command'), 'joint joint1 to 3 deg');
  assert.deepEqual(server.received, []);
  for (const place of ['#tab-Joints', '[aria-label="joint1, slider"]',
    '[aria-label="joint2, value"]', 'button:text-is("Hold")', '#duration']) {
    server.received = [];
    await page.focus(place);
    await page.keyboard.press('Space');
    await page.waitForTimeout(150);
    assert.deepEqual(server.received.map(({text}) => text), ['stop'], `in ${place}`);
  }
  await type_line(page, 'reset');
});

test('history goes back and forth', async () => {
  await type_line(page, 'hold');
  await type_line(page, 'mode joint');
  await page.press('#command', 'ArrowUp');
  assert.equal(await page.inputValue('#command'), 'mode joint');
  await page.press('#command', 'ArrowUp');
  assert.equal(await page.inputValue('#command'), 'hold');
  await page.press('#command', 'ArrowDown');
  await page.press('#command', 'ArrowDown');
  assert.equal(await page.inputValue('#command'), '');
});

test('Tab completes a word, and does not leave a line that has been begun', async () => {
  await page.focus('#command');
  await page.keyboard.type('mov');
  await page.keyboard.press('Tab');
  assert.equal(await page.inputValue('#command'), 'move ');
  await page.keyboard.press('Tab');
  assert.equal(await page.inputValue('#command'), 'move tool ');
  await page.keyboard.type('b');
  await page.keyboard.press('Tab');
  await page.keyboard.type('0 0 0.01');
  assert.equal(await page.inputValue('#command'), 'move tool by 0 0 0.01');
  server.received = [];
  for (let i = 0; i < 3; ++i) {
    await page.keyboard.press('Tab');
    assert.equal((await focused()).name, 'command');
  }
  await page.keyboard.type(' ');
  assert.match(await page.inputValue('#command'), /^move tool by 0 0 0\.01 .* $/);
  await page.fill('#command', 'move tool');
  await page.keyboard.press('Tab');
  assert.equal(await page.inputValue('#command'), 'move tool ', 'a complete word gets its blank');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  assert.notEqual((await focused()).name, 'command', 'Escape lets go');
  assert.deepEqual(server.received, [], 'nothing was stopped');
  await page.fill('#command', '');
  await page.keyboard.press('Tab');
  assert.notEqual((await focused()).name, 'command', 'an empty line lets go');
});

test('arrow keys on a slider move the joint', async () => {
  await type_line(page, 'start');
  server.received = [];
  const before = server.robot.q[1];
  await page.focus('[aria-label="joint2, slider"]');
  // One after the other at once: a slider that rests shows where the joint is.
  await Promise.all(Array.from({length: 5}, () => page.keyboard.press('ArrowRight')));
  await page.waitForTimeout(1200);
  assert.ok(server.received.every(({text}) => /^joint joint2 to -?[\d.]+ deg in/.test(text)));
  const step = (0.79 + 3.93) / 400;
  assert.ok(Math.abs(server.robot.q[1] - before - 5 * step) < 1.1 * step,
    `${server.robot.q[1]} after ${before}`);
});
