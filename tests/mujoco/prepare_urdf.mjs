// What a URDF needs before MuJoCo takes it. The robot stays the same but for inertias that MuJoCo
// refuses: these are replaced here and set in the compiled model (set_inertias.mjs).

const kLeastMass = 1e-14;  // MuJoCo wants more than 1e-15 of bodies that move

/** Geometry, tools' elements and comments say nothing about the dynamics; shapes would even add
 * inertia to links without. */
function without_unneeded(text) {
  const tags = 'visual|collision|gazebo|transmission|mujoco';
  return text.replace(/<!--[\s\S]*?-->/g, '')
      .replace(new RegExp(`<(${tags})\\b(?:[^>]*?/>|[^>]*>[\\s\\S]*?</\\1\\s*>)`, 'g'), '');
}

function attribute(element, name) {
  const found = element && element.match(new RegExp(`\\b${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)')`));
  return found ? found[1] ?? found[2] : undefined;
}

function element(text, tag) {
  return (text.match(new RegExp(`<${tag}\\b[^>]*>`)) ?? [])[0];
}

function vector(text) {
  return text === undefined ? [0, 0, 0] : text.trim().split(/\s+/).map(Number);
}

/** The inertial of a link as the file has it; of a link without one, nothing. */
function read_inertial(block) {
  const inertial = (block.match(/<inertial\b[\s\S]*?<\/inertial\s*>/) ?? [])[0] ?? '';
  const entry = (name) => Number(attribute(element(inertial, 'inertia'), name) ?? 0);
  return {
    mass: Number(attribute(element(inertial, 'mass'), 'value') ?? 0),
    com: vector(attribute(element(inertial, 'origin'), 'xyz')),
    rpy: vector(attribute(element(inertial, 'origin'), 'rpy')),
    tensor: [
      [entry('ixx'), entry('ixy'), entry('ixz')], [entry('ixy'), entry('iyy'), entry('iyz')],
      [entry('ixz'), entry('iyz'), entry('izz')]
    ],
  };
}

/** Eigenvalues and eigenvectors (columns) of a symmetric 3 x 3 matrix, by Jacobi rotations. */
export function principal_axes(tensor) {
  const a = tensor.map((row) => [...row]);
  const v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 60; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (a[p][q] === 0) continue;
      const angle = 0.5 * Math.atan2(2 * a[p][q], a[p][p] - a[q][q]);
      const c = Math.cos(angle), s = Math.sin(angle);
      for (const m of [a, v]) {
        for (const row of m) [row[p], row[q]] = [c * row[p] + s * row[q], c * row[q] - s * row[p]];
      }
      const old_p = [...a[p]], old_q = [...a[q]];
      for (let i = 0; i < 3; ++i) {
        a[p][i] = c * old_p[i] + s * old_q[i];
        a[q][i] = c * old_q[i] - s * old_p[i];
      }
    }
  }
  return {moments: [a[0][0], a[1][1], a[2][2]], axes: v};
}

function mujoco_takes({mass, tensor}) {
  const [a, b, c] = principal_axes(tensor).moments.sort((x, y) => x - y);
  return mass > kLeastMass && a > kLeastMass && a + b > c * (1 + 1e-9);
}

// Lopsided, so that MuJoCo's compiler takes no short cut that only holds for simpler bodies.
const kPlaceholder = '<inertial><origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/><mass value="1"/>' +
    '<inertia ixx="1" ixy="0.1" ixz="0.2" iyy="1.2" iyz="0.3" izz="1.4"/></inertial>';

/** Returns the text and, by link, the inertials that have to be set in the compiled model. */
function replace_refused_inertias(text) {
  const replaced = new Map();
  const all = /<link\b[^>]*?\/>|<link\b[^>]*>[\s\S]*?<\/link\s*>/g;
  const changed = text.replace(all, (block) => {
    const name = attribute(element(block, 'link'), 'name');
    const inertial = read_inertial(block);
    if (name === 'world' || mujoco_takes(inertial)) return block;
    replaced.set(name, inertial);
    return `<link name="${name}">${kPlaceholder}</link>`;
  });
  return {text: changed, replaced};
}

function root_of(text) {
  const links = [...text.matchAll(/<link\b[^>]*>/g)].map(([tag]) => attribute(tag, 'name'));
  const children = new Set(
      [...text.matchAll(/<child\b[^>]*>/g)].map(([tag]) => attribute(tag, 'link')));
  return links.find((name) => !children.has(name));
}

/** MuJoCo takes a link named world for the world; under a floating base it is an ordinary link. */
export const kRenamedWorld = 'link_named_world';
export const kBaseJoint = 'floating_base';

function with_floating_base(text) {
  const renamed = text.replace(/(<(?:link|parent|child)\b[^>]*?")world"/g, `$1${kRenamedWorld}"`);
  return renamed.replace(/<robot\b[^>]*>/, (tag) => `${tag}<link name="world"/>` +
      `<joint name="${kBaseJoint}" type="floating"><parent link="world"/>` +
      `<child link="${root_of(renamed)}"/></joint>`);
}

export function prepare_urdf(urdf, floating) {
  const based = floating ? with_floating_base(without_unneeded(urdf)) : without_unneeded(urdf);
  const {text, replaced} = replace_refused_inertias(based);
  // Links behind fixed joints stay bodies, so that their poses can be compared.
  const compiler = '<mujoco><compiler fusestatic="false" inertiafromgeom="false"/></mujoco>';
  return {text: text.replace(/<robot\b[^>]*>/, (tag) => tag + compiler), replaced};
}
