// A real browser without a screen, and hands for it.
import fs from 'node:fs';
import path from 'node:path';

import {kPage, load_package} from './packages.mjs';

const kCandidates = [process.env.TREELINE_CHROMIUM, '/usr/bin/chromium',
  '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];

const kPatience = 90000;  // ms: machines that do much else are slow at drawing in software

// Drawing in software takes most of the time of a test. Pixels drawn for one of the page: few are
// enough where nobody looks.
const kScale = process.env.TREELINE_PICTURES ? 1 : 0.25;

/** For `open_page`: all pixels, for tests that look at them. */
export const kSharp = {deviceScaleFactor: 1};

// Whether the bundle of TREELINE_PAGE stands in for the one that a program carries.
const kNewest = Boolean(process.env.TREELINE_NEWEST_PAGE);

/** The browser's program, or undefined. */
export function find_chromium() {
  return kCandidates.find((file) => file && fs.existsSync(file));
}

/** A browser that draws WebGL in software, on every machine the same way. */
export function launch_browser() {
  return load_package('playwright-core').chromium.launch({executablePath: find_chromium(),
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader', '--disable-gpu-compositing', '--disable-gpu-rasterization',
      ...(kNewest ? ['--disable-features=LocalNetworkAccessChecks'] : [])]});
}

/** Draws at most 15 times a second, as a slow machine does. */
function draw_seldom() {
  window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 66);
}

/** Puts the newest bundle in the place of the one that a program carries: while one works on it. */
async function put_newest(page) {
  const files = {'/': 'index.html', '/page.js': 'page.js', '/page.css': 'page.css'};
  for (const [address, file] of Object.entries(files)) {
    await page.route((url) => url.pathname === address,
      (route) => route.fulfill({path: path.join(kPage, file)}));
  }
}

/**
 * Opens the page at `address` and waits for the first state. Errors of scripts are kept in
 * `page.faults`; tests compare them with []. With TREELINE_NEWEST_PAGE set, the bundle is that of
 * TREELINE_PAGE.
 */
export async function open_page(browser, address, options = {}) {
  const page = await browser.newPage({viewport: {width: 1366, height: 768},
    deviceScaleFactor: kScale, ...options});
  page.setDefaultTimeout(kPatience);
  page.faults = [];
  await page.addInitScript(draw_seldom);
  page.on('pageerror', (error) => page.faults.push(error.message));
  page.on('console', (message) => {
    const away = /WebSocket connection|ERR_CONNECTION|GPU stall/;
    if (message.type() === 'error' && !away.test(message.text())) page.faults.push(message.text());
  });
  if (kNewest) await put_newest(page);
  await page.goto(address);
  await page.waitForFunction(() => window.treeline?.state);
  return page;
}

export function state_of(page) {
  return page.evaluate(() => window.treeline.state);
}

/** Types a line into the command line and waits for the reply, which is returned. */
export async function type_line(page, line) {
  const log = page.locator('.log p');
  const before = await page.locator('.log .good, .log .bad').count();
  await page.fill('#command', line);
  await page.press('#command', 'Enter');
  await page.waitForFunction((count) =>
    document.querySelectorAll('.log .good, .log .bad').length > count, before);
  return log.last().textContent();
}

/** What the page says of the handle under the pointer, once that no longer changes. */
export async function read_tip(page) {
  let text = '';
  for (;;) {
    await page.waitForTimeout(200);
    const now = await page.textContent('#tip');
    if (now !== '' && now === text) return now;
    text = now;
  }
}

/** Place on the screen where `handle` can be grabbed. */
export async function where(page, handle) {
  const {clientX, clientY} = await page.evaluate((name) => window.treeline.where(name), handle);
  return {x: clientX, y: clientY};
}

/** Drags `handle` along `path`, pixels from where it is grabbed. Lets go unless told to hold. */
export async function drag(page, handle, path, {hold = false} = {}) {
  const {x, y} = await where(page, handle);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const [dx, dy] of path) {
    await page.mouse.move(x + dx, y + dy);
    await page.waitForTimeout(30);
  }
  if (!hold) await page.mouse.up();
}

/** `count` steps from the origin to `end`. */
export function straight([dx, dy], count) {
  return Array.from({length: count}, (_, i) => [dx * (i + 1) / count, dy * (i + 1) / count]);
}

/** Waits until `holds(state)` of the newest state that the page has got. */
export async function wait_for_state(page, holds, timeout = kPatience) {
  const end = performance.now() + timeout;
  for (;;) {
    const state = await state_of(page);
    if (holds(state)) return;
    if (performance.now() > end) {
      throw new Error(`did not come true: ${holds}\n${JSON.stringify(state)}`);
    }
    await page.waitForTimeout(30);
  }
}
