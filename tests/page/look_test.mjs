// Would catch: a picture without a robot or without handles, parts that lie over each other or
// leave the window, text that cannot be read before its ground, in light and dark, wide and narrow.
// Screenshots are kept in $TREELINE_PICTURES, if that is set.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {after, before, test} from 'node:test';

import {kSharp, launch_browser, open_page, type_line} from './browser.mjs';
import {MockServer} from './mock_server.mjs';

const kReferences = path.join(import.meta.dirname, 'pictures');
const kTolerance = 0.02;  // share of pixels that may differ
const kTabs = ['Joints', 'Points', 'Control', 'Plots', 'View'];
const kSizes = {laptop: {width: 1366, height: 768}, low: {width: 1366, height: 600},
  tablet: {width: 1000, height: 700}, phone: {width: 420, height: 860}};

let server;
let browser;
before(async () => {
  server = new MockServer();
  await server.listen();
  browser = await launch_browser();
});
after(async () => {
  await browser.close();
  await server.close();
});

async function keep(page, name) {
  const folder = process.env.TREELINE_PICTURES;
  if (folder) await page.screenshot({path: path.join(folder, `${name}.png`)});
}

/** Pairs of visible controls that lie over each other, and what leaves the window sideways. */
function find_clashes() {
  const clashes = [];
  const shown = [...document.querySelectorAll(
    'button, input, select, h1, h2, .chip, .joint-name, .limit, .unit, .readout, .hint, dt, dd')]
    .filter((one) => one.checkVisibility() && !one.closest('.offers, #view-tools') &&
      !one.matches('[type="range"]'));
  const boxes = shown.map((one) => one.getBoundingClientRect());
  const name = (one) => `${one.tagName} ${one.textContent || one.getAttribute('aria-label')}`;
  for (let i = 0; i < shown.length; ++i) {
    if (boxes[i].right > innerWidth + 0.5) clashes.push(`${name(shown[i])} leaves the window`);
    for (let k = i + 1; k < shown.length; ++k) {
      const inside = shown[i].contains(shown[k]) || shown[k].contains(shown[i]);
      const sticky = Boolean(shown[i].closest('#status')) !== Boolean(shown[k].closest('#status'));
      const [a, b] = [boxes[i], boxes[k]];
      const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (!inside && !sticky && wide > 1 && high > 1) {
        clashes.push(`${name(shown[i])} over ${name(shown[k])}`);
      }
    }
  }
  for (const panel of document.querySelectorAll('.panel')) {
    if (panel.scrollWidth > panel.clientWidth) clashes.push(`${panel.id} scrolls sideways`);
  }
  if (document.documentElement.scrollWidth > innerWidth) clashes.push('the page scrolls sideways');
  return clashes;
}

/** Texts whose contrast with their ground is below 4.5 (WCAG AA). */
function find_faint_texts() {
  const channels = (color) => color.match(/[\d.]+/g).map(Number);
  const light = (color) => {
    const [r, g, b] = channels(color).slice(0, 3).map((value) => value / 255)
      .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ground = (one) => {
    for (let at = one; at; at = at.parentElement) {
      const color = getComputedStyle(at).backgroundColor;
      if (!/, 0\)$|transparent/.test(color)) return color;
    }
    return 'rgb(255, 255, 255)';
  };
  const has_text = (one) => [...one.childNodes].some((node) =>
    node.nodeType === 3 && node.textContent.trim());
  return [...document.querySelectorAll('body *')].filter((one) => one.checkVisibility() &&
    !one.disabled && !one.closest('#axes, .uplot') && has_text(one)).map((one) => {
    const [a, b] = [light(getComputedStyle(one).color), light(ground(one))];
    return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), one.textContent];
  }).filter(([contrast]) => contrast < 4.5);
}

for (const [size, viewport] of Object.entries(kSizes)) {
  test(`nothing clashes: ${size}`, async () => {
    const page = await open_page(browser, server.address, {...kSharp, viewport});
    for (const tab of kTabs) {
      await page.click(`#tab-${tab}`);
      assert.deepEqual(await page.evaluate(find_clashes), [], tab);
      await keep(page, `${size}_${tab}`);
    }
    const stop = await page.locator('.stop').boundingBox();
    assert.ok(stop.y >= 0 && stop.y + stop.height <= viewport.height, 'the stop is on screen');
    assert.deepEqual(page.faults, []);
    await page.close();
  });
}

for (const colorScheme of ['light', 'dark']) {
  test(`texts can be read: ${colorScheme}`, async () => {
    const page = await open_page(browser, server.address, {...kSharp, colorScheme});
    for (const tab of kTabs) {
      await page.click(`#tab-${tab}`);
      assert.deepEqual(await page.evaluate(find_faint_texts), [], tab);
    }
    await keep(page, `laptop_${colorScheme}`);
    await page.close();
  });
}

test('nothing shifts while the robot is driven', async () => {
  const page = await open_page(browser, server.address, kSharp);
  await page.waitForTimeout(500);
  await page.evaluate(() => {
    window.shifts = [];
    new PerformanceObserver((list) => window.shifts.push(...list.getEntries().map((one) =>
      [one.value, ...one.sources.map((source) => source.node?.outerHTML.slice(0, 80))])))
      .observe({type: 'layout-shift'});
  });
  for (const line of ['start', 'joint joint1 by 20 deg in 1 s', 'stop', 'start', 'reset', 'give']) {
    await type_line(page, line);
    await page.waitForTimeout(600);
  }
  server.silent = true;
  await page.waitForSelector('#lost:not([hidden])');
  server.silent = false;
  await page.waitForSelector('#lost', {state: 'hidden'});
  assert.deepEqual(await page.evaluate(() => window.shifts), []);
  await page.close();
});

/** Share of pixels in which two PNG differ by more than 24 of 255 in a channel. */
async function compare(page, one, other) {
  return page.evaluate(async (addresses) => {
    const [a, b] = await Promise.all(addresses.map(async (address) => {
      const image = await createImageBitmap(await (await fetch(address)).blob());
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    }));
    if (a.width !== b.width || a.height !== b.height) return 1;
    let different = 0;
    for (let i = 0; i < a.data.length; i += 4) {
      if ([0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 24)) ++different;
    }
    return different / (a.data.length / 4);
  }, [one, other]);
}

/** The picture of the mock's robot at rest, as a data address. */
async function take_picture(page) {
  await page.waitForTimeout(500);
  return page.evaluate(() => window.treeline.picture());
}

for (const colorScheme of ['light', 'dark']) {
  test(`the picture is as it was looked at: ${colorScheme}`, async (t) => {
    const still = new MockServer();
    await still.listen();
    t.after(() => still.close());
    const page = await open_page(browser, still.address, {...kSharp, colorScheme});
    const picture = await take_picture(page);
    const file = path.join(kReferences, `puma560_${colorScheme}.png`);
    if (process.env.TREELINE_WRITE_PICTURES) {
      fs.mkdirSync(kReferences, {recursive: true});
      fs.writeFileSync(file, Buffer.from(picture.split(',')[1], 'base64'));
    }
    const reference = `data:image/png;base64,${fs.readFileSync(file).toString('base64')}`;
    const share = await compare(page, picture, reference);
    assert.ok(share <= kTolerance, `${(100 * share).toFixed(2)} % of the pixels differ`);
    await page.click('#tab-View');
    await page.click('button:text-is("Disks and rails of joints")');
    const without = await compare(page, await take_picture(page), reference);
    assert.ok(without > 0.004, 'the comparison sees that the disks are gone');
    await page.close();
  });
}
