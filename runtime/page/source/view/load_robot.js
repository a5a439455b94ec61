// From URDF text to a model with visuals. Links without visuals get a stick figure.
import * as three from 'three';
import {ColladaLoader} from 'three/examples/jsm/loaders/ColladaLoader.js';
import {GLTFLoader} from 'three/examples/jsm/loaders/GLTFLoader.js';
import {OBJLoader} from 'three/examples/jsm/loaders/OBJLoader.js';
import {STLLoader} from 'three/examples/jsm/loaders/STLLoader.js';
import URDFLoader from 'urdf-loader';

import {add_stick_figure} from './stick_figure.js';

// Textures are not served: each becomes one white pixel.
const kWhitePixel =
  'data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACwAAAAAAQABAAACAkQBADs=';

/** Blanks at the ends of numbers, which URDF allows and the loader does not. */
function trim_numbers(robot) {
  for (const node of robot.querySelectorAll('[xyz], [rpy], [rgba], [size]')) {
    for (const name of ['xyz', 'rpy', 'rgba', 'size']) {
      const text = node.getAttribute(name);
      if (text) node.setAttribute(name, text.trim().replace(/\s+/g, ' '));
    }
  }
}

/** Where a link's visuals are missing, the simple shapes by which it collides are drawn. */
function draw_collisions(link) {
  for (const collision of link.querySelectorAll(':scope > collision')) {
    const shape = collision.querySelector('geometry')?.children[0]?.nodeName;
    if (!['box', 'cylinder', 'sphere'].includes(shape)) continue;
    const visual = link.ownerDocument.createElement('visual');
    visual.append(...collision.childNodes);
    link.append(visual);
  }
}

/**
 * Drops what the loader cannot read, parts that no picture needs, and visuals with meshes that are
 * not served. Returns the names of those meshes.
 */
function drop_unreadable(robot, meshes) {
  for (const node of robot.querySelectorAll('inertial, texture, transmission')) node.remove();
  const missing = new Set();
  for (const visual of robot.querySelectorAll('visual')) {
    const shape = visual.querySelector('geometry')?.children[0];
    const file = shape?.getAttribute('filename');
    const is_missing = shape?.nodeName === 'mesh' && !meshes[file];
    if (is_missing) missing.add(file);
    if (shape && !is_missing) continue;
    const link = visual.parentElement;
    visual.remove();
    if (!link.querySelector(':scope > visual')) draw_collisions(link);
  }
  for (const node of robot.querySelectorAll('collision')) node.remove();
  return [...missing];
}

/** Says which meshes are missing, and why the first of them is, where the server says that. */
function report_missing(files, reasons, report) {
  if (files.length === 0) return;
  const others = files.length > 1 ? ` and ${files.length - 1} other meshes are` : ' is';
  const why = reasons[files[0]] ? ` ${files[0]}: ${reasons[files[0]]}` : '';
  report(`${files[0]}${others} missing; simple shapes or sticks stand in.${why}`);
}

/** Names of links that weigh nothing and show nothing: frames, such as that of a tool. */
function frames_of(robot) {
  return [...robot.querySelectorAll('link')].filter((link) => !link.querySelector('visual') &&
    !(Number(link.querySelector('mass')?.getAttribute('value')) > 0))
    .map((link) => link.getAttribute('name'));
}

/** Fetches each mesh once: to those who only watch, the server gives it once. */
function fetch_once(meshes) {
  const fetched = new Map();
  return (file) => {
    if (!fetched.has(file)) fetched.set(file, fetch_bytes(meshes[file]));
    return fetched.get(file);
  };
}

async function fetch_bytes(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
  return answer.arrayBuffer();
}

async function parse_mesh(file, bytes, manager, material) {
  const kind = file.split('.').at(-1).toLowerCase();
  const text = () => new TextDecoder().decode(bytes);
  if (kind === 'stl') {
    const shape = new STLLoader(manager).parse(bytes);
    shape.computeVertexNormals();  // many files have zeros for normals
    return new three.Mesh(shape, material);
  }
  if (kind === 'dae') {
    const collada = new ColladaLoader(manager).parse(text(), '');
    if (!collada) throw new Error('this is no whole COLLADA file');
    return collada.scene;
  }
  if (kind === 'glb' || kind === 'gltf') {
    return (await new GLTFLoader(manager).parseAsync(bytes, '')).scene;
  }
  if (kind === 'obj') {
    const shape = new OBJLoader(manager).parse(text());
    shape.traverse((part) => { if (part.isMesh) part.material = material; });
    return shape;
  }
  throw new Error(`meshes end with .stl, .dae, .obj or .glb, not .${kind}`);
}

/**
 * Builds the model of a URDF. Of the server's hello it takes `meshes`, from the name in the URDF to
 * the address, and `missing_meshes`, to the reason. `report(text)` hears of what cannot be drawn;
 * `changed()` is called as meshes arrive.
 */
export function load_robot(urdf, {meshes = {}, missing_meshes = {}}, report, changed) {
  const robot = new DOMParser().parseFromString(urdf, 'text/xml');
  trim_numbers(robot);
  const frames = frames_of(robot);
  report_missing(drop_unreadable(robot, meshes), missing_meshes, report);
  const manager = new three.LoadingManager();
  manager.setURLModifier((url) =>
    (url.startsWith('/mesh/') || /^(data|blob):/.test(url) ? url : kWhitePixel));
  const fetched = fetch_once(meshes);
  const loader = new URDFLoader(manager);
  // The name of a mesh is looked up as it stands in the URDF.
  loader.packages = (name) => `package://${name}`;
  loader.loadMeshCb = (file, _manager, material, done) => {
    fetched(file).then((bytes) => parse_mesh(file, bytes, manager, material)).then((mesh) => {
      done(mesh);
      changed();
    }, (error) => report(`the mesh ${file} cannot be drawn: ${
      error instanceof RangeError ? 'it is cut short' : error.message}`));
  };
  const model = loader.parse(robot);
  for (const joint of Object.values(model.joints)) {
    joint.origPosition = joint.position.clone();
    joint.origQuaternion = joint.quaternion.clone();
    joint.ignoreLimits = true;
  }
  add_stick_figure(model, frames);
  return model;
}
