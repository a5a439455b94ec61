// Would catch: a CSV whose columns and values do not belong together, or that lacks states; a
// picture or plots that are saved empty.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {after, before, test} from 'node:test';

import {kSharp, launch_browser, open_page, type_line, wait_for_state} from './browser.mjs';
import {MockServer} from './mock_server.mjs';

const server = new MockServer();
let browser;
let page;
before(async () => {
  await server.listen();
  browser = await launch_browser();
  page = await open_page(browser, server.address, kSharp);
});
after(async () => {
  await browser.close();
  await server.close();
});

async function save(selector) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
  return {name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path())};
}

/** Number of colours in a PNG, and its size. */
async function look_at(bytes) {
  return page.evaluate(async (address) => {
    const image = await createImageBitmap(await (await fetch(address)).blob());
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const {data} = context.getImageData(0, 0, image.width, image.height);
    return {width: image.width, height: image.height,
      colors: new Set(new Uint32Array(data.buffer)).size};
  }, `data:image/png;base64,${bytes.toString('base64')}`);
}

test('the CSV has every state, in columns with names', async () => {
  await type_line(page, 'start');
  await type_line(page, 'joint joint1 to 0.5 in 0.5 s');
  await wait_for_state(page, (state) => Math.abs(state.q[0] - 0.5) < 1e-3);
  await page.click('#tab-Plots');
  const {name, bytes} = await save('button:text-is("Save CSV")');
  assert.equal(name, 'puma560.csv');
  const [head, ...rows] = bytes.toString().trimEnd().split('\n').map((row) => row.split(','));
  const column = (title) => rows.map((row) => Number(row[head.indexOf(title)]));
  assert.ok(rows.every((row) => row.length === head.length));
  const times = column('time [s]');
  assert.ok(times.every((time, i) => i === 0 || time > times[i - 1]), 'times grow');
  assert.ok(times.at(-1) - times[0] < rows.length * 0.2, 'no state is left out');
  assert.ok(Math.abs(column('q_joint1 [rad]').at(-1) - 0.5) < 1e-3);
  assert.ok(Math.abs(column('q_joint2 [rad]').at(-1) - server.robot.q[1]) < 1e-3);
  assert.ok(Math.abs(column('at_tool.z [m]').at(-1) - server.robot.tip_at(server.robot.q).at[2]) < 1e-3);
  assert.ok(column('control_mean [us]').every((time) => time >= 10 && time <= 12));
});

test('picture and plots are saved as they are shown', async () => {
  const plots = await save('#panel-Plots button:text-is("Save PNG")');
  assert.equal(plots.name, 'puma560.plots.png');
  const drawn = await look_at(plots.bytes);
  assert.ok(drawn.colors > 20 && drawn.height > 400, JSON.stringify(drawn));
  await page.click('#tab-View');
  const picture = await save('#panel-View button:text-is("Save PNG")');
  assert.equal(picture.name, 'puma560.png');
  const seen = await look_at(picture.bytes);
  assert.ok(seen.colors > 200 && seen.width > 800, JSON.stringify(seen));
});
