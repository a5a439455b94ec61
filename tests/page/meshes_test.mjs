// Would catch: meshes of a kind that are not loaded, without their colour, scale or origin; links
// that vanish where a mesh is missing or broken; a mesh that takes others with it, or that is asked
// for twice, which watchers may not; a reason that is kept back; frames drawn as balls; a robot that
// hangs through the floor.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {kSharp, launch_browser, open_page} from './browser.mjs';
import {MockServer} from './mock_server.mjs';

const kCorners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const kFaces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

/** A tetrahedron with legs of 1 m, in three formats; in COLLADA it is yellow and in mm. */
const kStl = `solid t\n${kFaces.map((face) => `facet normal 0 0 0\nouter loop\n${
  face.map((i) => `vertex ${kCorners[i].join(' ')}`).join('\n')}\nendloop\nendfacet`).join('\n')}
endsolid t\n`;
const kObj = `${kCorners.map((one) => `v ${one.join(' ')}`).join('\n')}\n${
  kFaces.map((face) => `f ${face.map((i) => i + 1).join(' ')}`).join('\n')}\n`;
const kDae = `<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.001"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="c"><lambert><diffuse>
<color>1 0.9 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="a" count="12">${kCorners.flat().map((x) => 1000 * x).join(' ')}</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4" material="s"><input semantic="VERTEX" source="#v" offset="0"/>
<p>${kFaces.flat().join(' ')}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node id="n"><instance_geometry url="#g">
<bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common>
</bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>`;

const kFiles = {'package://arm/red.stl': kStl, 'green.obj': kObj, 'meshes/yellow.DAE': kDae,
  'broken.stl': 'no mesh'};
const kColors = {'package://arm/red.stl': '1 0 0 1', 'green.obj': '0 0.8 0 1'};

/** Links that slide apart, each with a mesh half a metre long, and with `collision` each. */
function write_urdf(files, collision, frames = '') {
  const links = files.map((file, i) => `<link name="l${i}"><visual><geometry>
    <mesh filename="${file}" scale="0.5 0.5 0.5"/></geometry>
    <material name="m${i}"><color rgba="${kColors[file] ?? '1 1 1 1'}"/></material></visual>${collision}</link>
    <joint name="j${i}" type="revolute"><parent link="${i === 0 ? 'base' : `l${i - 1}`}"/>
    <child link="l${i}"/><origin xyz="0.7 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>`);
  return `<robot name="puma560"><link name="base"/>${links.join('')}<link name="tool"/>
    <joint name="end" type="fixed"><parent link="l${files.length - 1}"/><child link="tool"/>
    <origin xyz="0.7 0 0"/></joint>${frames}</robot>`;
}

/** Counts pixels by hue in the picture: {red, green, yellow, ball}; `ball` is the colour of massless frames' balls. */
function count_hues(page) {
  return page.evaluate(async () => {
    const picture = await (await fetch(window.treeline.picture())).blob();
    const image = await createImageBitmap(picture);
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const {data} = context.getImageData(0, 0, image.width, image.height);
    const counts = {red: 0, green: 0, yellow: 0, ball: 0};
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = data.slice(i, i + 3);
      if (r > 60 && g < 0.35 * r && b < 0.35 * r) ++counts.red;
      if (g > 60 && r < 0.35 * g && b < 0.35 * g) ++counts.green;
      if (r > 60 && g > 0.75 * r && b < 0.35 * r) ++counts.yellow;
      if (r < 90 && b > r + 15 && b < r + 80 && g > r && g < b) ++counts.ball;
    }
    return counts;
  });
}

let browser;
before(async () => { browser = await launch_browser(); });
after(() => browser.close());

/** The page of a robot with all meshes of kFiles, of which `served` are there. */
async function show(t, served, collision = '', files = Object.keys(kFiles), frames = '') {
  const server = new MockServer(write_urdf(files, collision, frames),
    Object.fromEntries(served.map((file) => [file, kFiles[file]])));
  server.robot.q = server.robot.q.map(() => 0);
  await server.listen();
  const page = await open_page(browser, server.address, kSharp);
  t.after(async () => {
    await page.close();
    await server.close();
  });
  await page.click('#tab-View');
  for (const name of ['Disks and rails of joints', 'Planes and belts of points',
    'Frames of points', 'Forces', 'Trace of points']) {
    await page.click(`#panel-View button:text-is("${name}")`);
  }
  await page.waitForTimeout(500);
  page.fetched = server.fetched;
  return page;
}

test('STL, OBJ and COLLADA are drawn, in their colours and sizes', async (t) => {
  const page = await show(t, Object.keys(kFiles).slice(0, 3));
  const counts = await count_hues(page);
  const {red, green, yellow} = counts;
  assert.ok(Math.min(red, green, yellow) > 800, JSON.stringify(counts));
  // The meshes have one size, though one is in mm; those that are nearer look a little larger.
  assert.ok(Math.max(red, green, yellow) < 4 * Math.min(red, green, yellow),
    JSON.stringify(counts));
  // The fourth is not served: nothing else is said to be missing.
  assert.equal(await page.locator('.log .note').count(), 1);
  assert.match(await page.textContent('.log .note'), /broken\.stl is missing/);
  assert.match(await page.textContent('.log .note'), /3 triangles take 234 bytes.*Copy it again/);
  assert.deepEqual(page.faults, []);
});

test('a missing mesh leaves the others', async (t) => {
  const counts = await count_hues(await show(t, ['green.obj']));
  assert.ok(counts.green > 800 && counts.red < 50 && counts.yellow < 50,
    JSON.stringify(counts));
});

test('shapes of collision stand in for missing meshes alone', async (t) => {
  const box = `<collision><geometry><box size="0.3 0.3 0.3"/></geometry>
    <material name="c"><color rgba="1 0.9 0 1"/></material></collision>`;
  const counts = await count_hues(await show(t, ['green.obj', 'package://arm/red.stl'], box));
  assert.ok(counts.yellow > 800 && counts.green > 800 && counts.red > 800, JSON.stringify(counts));
});

test('a broken mesh is said, and leaves the others', async (t) => {
  const page = await show(t, ['broken.stl', 'green.obj']);
  assert.ok((await count_hues(page)).green > 800);
  assert.match(await page.textContent('.log'), /broken\.stl cannot be drawn/);
});

test('a mesh of many links is fetched once', async (t) => {
  const page = await show(t, ['green.obj'], '', ['green.obj', 'green.obj', 'green.obj']);
  assert.ok((await count_hues(page)).green > 2000);
  assert.deepEqual(page.fetched, ['mesh/0']);
});

test('frames that weigh nothing are no balls beside meshes', async (t) => {
  const frame = (mass) => ['a', 'b'].map((name, i) => `<link name="${name}">${mass}</link>
    <joint name="to_${name}" type="fixed"><parent link="l2"/><child link="${name}"/>
    <origin xyz="0.4 ${i - 0.5} 0.4"/></joint>`).join('');
  const files = ['green.obj', 'green.obj', 'green.obj'];
  const heavy = '<inertial><mass value="1"/></inertial>';
  const without = (await count_hues(await show(t, ['green.obj'], '', files))).ball;
  const frames = (await count_hues(await show(t, ['green.obj'], '', files, frame('')))).ball;
  const masses = (await count_hues(await show(t, ['green.obj'], '', files, frame(heavy)))).ball;
  assert.ok(masses > without + 50, `${masses} dark pixels with balls, ${without} without`);
  assert.ok(frames < without + 10, `${frames} dark pixels with frames, ${without} without`);
});

test('the floor is under the lowest mesh, or at 0', async (t) => {
  for (const [height, lowest] of [[-2, -2.5], [2, 0]]) {
    const name = 'package://arm/red.stl';  // it hangs half a metre down from its link
    const urdf = write_urdf([name], '').replace('0.5 0.5 0.5', '0.5 0.5 -0.5')
      .replace('0.7 0 0', `0.7 0 ${height}`);
    const server = new MockServer(urdf, {[name]: kStl});
    await server.listen();
    const page = await open_page(browser, server.address);
    t.after(async () => {
      await page.close();
      await server.close();
    });
    await page.waitForFunction((expected) => document.querySelector('#panel-View .readout')
      .textContent.startsWith(`Floor at z = ${expected} m`), lowest);
    assert.deepEqual(page.faults, []);
  }
});
