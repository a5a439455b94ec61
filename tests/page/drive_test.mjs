// Would catch: a page and a program that do not understand each other. All gestures with generated
// code in the loop, a floating base, meshes that are missing, and a program that goes away.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {after, before, test} from 'node:test';

import {drag, launch_browser, open_page, read_tip, state_of, straight, type_line, wait_for_state}
  from './browser.mjs';
import {DriveServer} from './drive_server.mjs';
import {kGestures} from './gestures.mjs';
import {kSource} from './packages.mjs';

let browser;
before(async () => { browser = await launch_browser(); });
after(() => browser.close());

async function start(t, files, options) {
  const server = new DriveServer();
  t.after(() => server.close());
  await server.start(files, options);
  return server;
}

async function keep(page, name) {
  const folder = process.env.TREELINE_PICTURES;
  if (folder) await page.screenshot({path: path.join(folder, `${name}.png`)});
}

test('a PUMA 560', async (t) => {
  const server = await start(t, ['robots/puma560/puma560.urdf', 'robots/puma560/scene.yaml']);
  for (const [name, run] of Object.entries(kGestures)) {
    await t.test(name, (inner) => run(browser, server, inner));
  }
});

test('a link is pulled by hand while the robot carries its weight', async (t) => {
  const server = await start(t, ['robots/puma560/puma560.urdf', 'robots/puma560/scene.yaml'],
    ['--q', '0,-0.8,0.8,0,0.6,0']);
  const page = await open_page(browser, server.address);
  t.after(() => page.close());
  await type_line(page, 'start');
  await type_line(page, 'mode gravity');
  await wait_for_state(page, (state) => state.control === 'gravity');
  await page.click('#tab-View');
  await page.click('button:text-is("Disks and rails of joints")');
  await page.click('button:text-is("Planes and belts of points")');
  await page.click('button:text-is("Pull links")');
  const before = await state_of(page);
  await drag(page, 'link:link3', straight([70, 0], 20), {hold: true});
  await wait_for_state(page, (state) => state.forces.length > 0);
  await wait_for_state(page, (state) => Math.abs(state.q[0] - before.q[0]) > 0.1);
  await keep(page, 'puma560_pulled');
  await page.mouse.up();
  await wait_for_state(page, (state) => state.forces.length === 0);
  await wait_for_state(page, (state) => state.qd.every((speed) => Math.abs(speed) < 0.01));
  const after = await state_of(page);
  assert.equal(after.fault, '');
  assert.ok(Math.abs(after.q[0] - before.q[0]) > 0.1, 'it stays where it was led');
  assert.deepEqual(page.faults, []);
});

test('a humanoid with a floating base: two hands and the base', async (t) => {
  const server = await start(t,
    ['robots/humanoid24/humanoid24.urdf', 'robots/humanoid24/scene_floating.yaml']);
  const page = await open_page(browser, server.address);
  t.after(() => page.close());
  const handles = await page.evaluate(() => window.treeline.handles());
  assert.equal(handles.filter((name) => name.startsWith('disk:')).length, 24);
  for (const point of ['left_hand', 'right_hand', 'base']) {
    assert.equal(handles.filter((name) => name.includes(`:${point}:`)).length, 6, point);
  }
  await type_line(page, 'start');
  await wait_for_state(page, (state) => state.mode === 'running');
  // Straight arms could not follow the base, which moves below.
  for (const joint of ['left_elbow', 'right_elbow']) {
    await type_line(page, `joint ${joint} to -80 deg in 1 s`);
  }
  await wait_for_state(page, (state) => !state.moving);
  await keep(page, 'humanoid_start');
  const before = await state_of(page);
  await page.click('#tab-View');
  await page.click('button:text-is("Disks and rails of joints")');
  await drag(page, 'plane:left_hand:yz', straight([14, -14], 10), {hold: true});
  const led = (await read_tip(page)).match(/-?\d+\.\d+/g).map(Number);
  await page.waitForTimeout(1000);
  await keep(page, 'humanoid_drag');
  await page.mouse.up();
  await wait_for_state(page, (state) =>
    Math.hypot(...state.points[0].at.map((x, i) => x - led[i])) < 0.02);
  const after = await state_of(page);
  const right = after.points[1].at.map((x, i) => x - before.points[1].at[i]);
  assert.ok(Math.hypot(...right) < 0.02, 'the right hand stays');
  assert.match(await type_line(page, 'move base by 0 0 0.05 in 1 s'), /base/);
  await wait_for_state(page, (state) => Math.abs(state.q[2] - before.q[2] - 0.05) < 0.01);
  assert.deepEqual(page.faults, []);
});

test('a published robot whose meshes are missing is a stick figure', async (t) => {
  const server = await start(t, ['tests/data/published/ur5.urdf']);
  const page = await open_page(browser, server.address);
  t.after(() => page.close());
  assert.match(await page.textContent('.log .note'), /and 6 other meshes are missing/);
  assert.equal((await page.evaluate(() => window.treeline.handles())).length, 6);
  await type_line(page, 'start');
  const joint = await page.locator('.joint-name').first().textContent();
  assert.match(await type_line(page, `joint ${joint} to 40 deg in 1 s`), new RegExp(joint));
  await wait_for_state(page, (state) => Math.abs(state.q[0] - 40 * Math.PI / 180) < 0.01);
  await keep(page, 'ur5_without_meshes');
  assert.deepEqual(page.faults, []);
});

test('meshes are for those who command and for those who watch, as far as they may', async (t) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'treeline_meshes'));
  t.after(() => fs.rmSync(folder, {recursive: true}));
  const stl = 'solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n' +
    'endloop\nendfacet\nendsolid t\n';
  const link = (name, mesh) => `<link name="${name}"><inertial><mass value="1"/><inertia ixx="1"
    iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial><visual><geometry>
    <mesh filename="${mesh}"/></geometry></visual></link>`;
  fs.mkdirSync(path.join(folder, 'arm'));
  fs.writeFileSync(path.join(folder, 'arm/near.stl'), stl);
  fs.writeFileSync(path.join(folder, 'far.stl'), stl);
  fs.writeFileSync(path.join(folder, 'arm/arm.urdf'), `<robot name="arm"><link name="base"/>
    ${link('one', 'near.stl')}${link('two', '../far.stl')}${['one', 'two'].map((name, i) =>
    `<joint name="j${i}" type="revolute"><parent link="${i ? 'one' : 'base'}"/><child link="${name}"/>
    <origin xyz="0 0 1"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="99" velocity="1"/>
    </joint>`).join('')}</robot>`);
  const urdf = path.relative(kSource, path.join(folder, 'arm/arm.urdf'));
  const server = await start(t, [urdf]);
  for (const [address, told] of [[server.address, true], [server.watching_address, false]]) {
    const page = await open_page(browser, address);
    t.after(() => page.close());
    const note = await page.textContent('.log .note');
    assert.match(note, /^\.\.\/far\.stl is missing/);
    assert.equal(note.includes(`--mesh-folder ${folder}`), told, note);
    assert.equal(await page.locator('.log .note').count(), 1, 'the other one is drawn');
    assert.deepEqual(page.faults, []);
  }
  assert.match(server.said, /far\.stl.*lies outside of/);
  const free = await start(t, [urdf], ['--mesh-folder', folder]);
  const page = await open_page(browser, free.address);
  t.after(() => page.close());
  assert.equal(await page.locator('.log .note').count(), 0);
});

test('the page says that the program has gone', async (t) => {
  const server = await start(t, ['robots/planar3r/planar3r.urdf']);
  const page = await open_page(browser, server.address);
  t.after(() => page.close());
  assert.equal(await server.close(), 0);
  await page.waitForSelector('#lost:not([hidden])');
  assert.equal(await page.textContent('[aria-label="connection"]'), 'Connection lost');
});
