// Figures of MuJoCo for robots at random states, in MuJoCo's conventions:
//   node write_figures.mjs FOLDER NAME.urdf...
// writes FOLDER/NAME_fixed.json and FOLDER/NAME_floating.json. mujoco_figures.cpp says what the
// conventions are and converts them. Exit status 1: a file cannot be read or written.
import load_mujoco from '@mujoco/mujoco';
import fs from 'node:fs';
import path from 'node:path';

import {prepare_urdf} from './prepare_urdf.mjs';
import {set_inertias} from './set_inertias.mjs';

const kStates = 5;
const kSeed = 20260;

/** Uniform in [-1, 1): mulberry32. */
function make_random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2147483648 - 1;
  };
}

function draw_position(mujoco, model, joint, random) {
  if (model.jnt_type[joint] === mujoco.mjtJoint.mjJNT_FREE.value) {
    const turn = [random(), random(), random(), random()];
    const length = Math.hypot(...turn);
    return [random(), random(), random(), ...turn.map((x) => x / length)];
  }
  let [lower, upper] = model.jnt_range.subarray(2 * joint, 2 * joint + 2);
  if (!(upper > lower)) [lower, upper] = [-Math.PI, Math.PI];
  return [(lower + upper) / 2 + (upper - lower) / 2 * random()];
}

function compute_state(mujoco, model, data, random) {
  for (let joint = 0; joint < model.njnt; ++joint) {
    data.qpos.set(draw_position(mujoco, model, joint, random), model.jnt_qposadr[joint]);
  }
  for (let i = 0; i < model.nv; ++i) {
    data.qvel[i] = 3 * random();
    data.qacc[i] = 10 * random();
  }
  const state = {q: [...data.qpos], v: [...data.qvel], a: [...data.qacc]};
  // Only what follows from the state: mj_forward would overwrite qacc.
  mujoco.mj_fwdPosition(model, data);
  mujoco.mj_fwdVelocity(model, data);
  data.qacc.set(state.a);
  const M = new mujoco.DoubleBuffer(model.nv * model.nv);
  const tau = new mujoco.DoubleBuffer(model.nv);
  mujoco.mj_fullM(model, data, M);
  mujoco.mj_rne(model, data, 1, tau);
  Object.assign(state, {
    M: [...M.GetView()],
    bias: [...data.qfrc_bias],
    tau: [...tau.GetView()],
    positions: [...data.xpos],
    rotations: [...data.xmat],
  });
  M.delete();
  tau.delete();
  return state;
}

function describe(model) {
  const joints = [];
  for (let i = 0; i < model.njnt; ++i) {
    joints.push({
      name: model.jnt(i).name,
      type: model.jnt_type[i],
      at_q: model.jnt_qposadr[i],
      at_v: model.jnt_dofadr[i],
    });
  }
  const links = [];
  for (let i = 0; i < model.nbody; ++i) links.push(model.body(i).name);
  return {nq: model.nq, nv: model.nv, joints, links};
}

function compute_figures(mujoco, urdf, floating) {
  const prepared = prepare_urdf(urdf, floating);
  let model;
  try {
    model = mujoco.MjModel.from_xml_string(prepared.text);
  } catch (error) {
    return {refused: String(error.message ?? error).trim()};
  }
  set_inertias(model, prepared.replaced);
  const data = new mujoco.MjData(model);
  const random = make_random(kSeed);
  const states = [];
  for (let i = 0; i < kStates; ++i) states.push(compute_state(mujoco, model, data, random));
  const figures = {seed: kSeed, replaced: [...prepared.replaced.keys()], ...describe(model), states};
  data.delete();
  model.delete();
  return figures;
}

const [folder, ...files] = process.argv.slice(2);
const silent = {print: () => {}, printErr: () => {}};
const mujoco = await load_mujoco(silent);
fs.mkdirSync(folder, {recursive: true});
for (const file of files) {
  const urdf = fs.readFileSync(file, 'utf8');
  for (const base of ['fixed', 'floating']) {
    const figures = compute_figures(mujoco, urdf, base === 'floating');
    const name = `${path.basename(file, '.urdf')}_${base}.json`;
    fs.writeFileSync(path.join(folder, name), JSON.stringify(figures));
  }
}
