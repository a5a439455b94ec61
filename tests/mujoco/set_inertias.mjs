// Writes inertias that MuJoCo's compiler refuses (massless, negative, or against the triangle
// inequality) into a compiled model, whose algorithms take any.
import {principal_axes} from './prepare_urdf.mjs';

function multiply(a, b) {
  return a.map((row) => [0, 1, 2].map((j) => row.reduce((sum, x, k) => sum + x * b[k][j], 0)));
}

/** Rz(yaw) Ry(pitch) Rx(roll). */
function rotation_from_rpy([roll, pitch, yaw]) {
  const turn = (i, j, angle) => {
    const m = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    m[i][i] = m[j][j] = Math.cos(angle);
    m[j][i] = Math.sin(angle);
    m[i][j] = -m[j][i];
    return m;
  };
  return multiply(turn(0, 1, yaw), multiply(turn(2, 0, pitch), turn(1, 2, roll)));
}

/** w, x, y, z. */
function quaternion(m) {
  const four_squared = [
    1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
    1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]
  ];
  const products = [
    [0, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]],
    [m[2][1] - m[1][2], 0, m[1][0] + m[0][1], m[0][2] + m[2][0]],
    [m[0][2] - m[2][0], m[1][0] + m[0][1], 0, m[2][1] + m[1][2]],
    [m[1][0] - m[0][1], m[0][2] + m[2][0], m[2][1] + m[1][2], 0]
  ];
  const largest = four_squared.indexOf(Math.max(...four_squared));
  const twice = Math.sqrt(four_squared[largest]);
  return products[largest].map((x, i) => (i === largest ? twice / 2 : x / (2 * twice)));
}

/** Masses of subtrees, which the compiler adds up, from those of bodies. Parents come first. */
function add_up_masses(model) {
  model.body_subtreemass.set(model.body_mass);
  for (let i = model.nbody - 1; i > 0; --i) {
    model.body_subtreemass[model.body_parentid[i]] += model.body_subtreemass[i];
  }
}

export function set_inertias(model, replaced) {
  for (const [link, {mass, com, rpy, tensor}] of replaced) {
    const body = model.body(link).id;
    const {moments, axes} = principal_axes(tensor);
    const to_link = multiply(rotation_from_rpy(rpy), axes);
    model.body_mass[body] = mass;
    model.body_ipos.set(com, 3 * body);
    model.body_inertia.set(moments, 3 * body);
    model.body_iquat.set(quaternion(to_link), 4 * body);
  }
  if (replaced.size > 0) add_up_masses(model);
}
