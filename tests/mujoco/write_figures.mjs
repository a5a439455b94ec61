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

/** What `fill` writes into a buffer of this size. */
function read_buffer(mujoco, size, fill) {
  const buffer = new mujoco.DoubleBuffer(size);
  fill(buffer);
  const entries = [...buffer.GetView()];
  buffer.delete();
  return entries;
}

/** Velocities and accelerations of the links' frames: angular over linear, world axes, of each. */
function compute_motion(mujoco, model, data) {
  mujoco.mj_rnePostConstraint(model, data);
  const xbody = mujoco.mjtObj.mjOBJ_XBODY.value;
  const velocities = [], accelerations = [];
  for (let i = 0; i < model.nbody; ++i) {
    velocities.push(...read_buffer(
        mujoco, 6, (six) => mujoco.mj_objectVelocity(model, data, xbody, i, six, 0)));
    const felt = read_buffer(
        mujoco, 6, (six) => mujoco.mj_objectAcceleration(model, data, xbody, i, six, 0));
    const moves = model.body_weldid[i] !== 0;  // else it feels nothing
    for (let k = 0; moves && k < 3; ++k) felt[3 + k] += model.opt.gravity[k];
    accelerations.push(...felt);
  }
  return {velocities, accelerations};
}

/** Centre of mass, momentum and potential energy of everything, the world's body included. */
function compute_whole(mujoco, model, data) {
  mujoco.mj_subtreeVel(model, data);
  mujoco.mj_energyPos(model, data);
  return {
    mass: model.body_subtreemass[0],
    com: [...data.subtree_com.subarray(0, 3)],
    com_velocity: [...data.subtree_linvel.subarray(0, 3)],
    angular_momentum: [...data.subtree_angmom.subarray(0, 3)],
    com_jacobian: read_buffer(
        mujoco, 3 * model.nv, (J) => mujoco.mj_jacSubtreeCom(model, data, J, 0)),
    angular_momentum_matrix: read_buffer(
        mujoco, 3 * model.nv, (A) => mujoco.mj_angmomMat(model, data, A, 0)),
    potential_energy: data.energy[0],
  };
}

/** M and the kinetic energy of motors with rotors. */
function compute_with_rotors(mujoco, model, data, armature) {
  model.dof_armature.set(armature);
  mujoco.mj_fwdPosition(model, data);
  mujoco.mj_energyVel(model, data);
  const figures = {
    M_with_rotors: read_buffer(
        mujoco, model.nv * model.nv, (M) => mujoco.mj_fullM(model, data, M)),
    kinetic_energy: data.energy[1],
  };
  model.dof_armature.fill(0);
  return figures;
}

/**
 * Inverse dynamics at the state's acceleration, and the acceleration by other forces, of joints with
 * rotors, viscous friction and springs. Dry friction (frictionloss) is a constraint in MuJoCo and
 * not compared; constraints, which limits of joints are too, are off.
 */
function compute_with_drives(mujoco, model, data, drives, state, random) {
  model.dof_armature.set(drives.armature);
  model.dof_damping.set(drives.damping);
  model.jnt_stiffness.set(drives.stiffness);
  const flags = model.opt.disableflags;
  model.opt.disableflags = flags | mujoco.mjtDisableBit.mjDSBL_CONSTRAINT.value;
  data.qacc.set(state.a);
  mujoco.mj_inverse(model, data);
  const tau_with_drives = [...data.qfrc_inverse];
  const applied = tau_with_drives.map((force) => force * (1 + 0.5 * random()));
  data.qfrc_applied.set(applied);
  mujoco.mj_forward(model, data);
  const figures = {tau_with_drives, applied, forward_acceleration: [...data.qacc]};
  data.qfrc_applied.fill(0);
  model.opt.disableflags = flags;
  model.dof_armature.fill(0);
  model.dof_damping.fill(0);
  model.jnt_stiffness.fill(0);
  return figures;
}

/**
 * Of joints with one velocity, different from joint to joint: kg m^2 or kg; N m s/rad or N s/m;
 * N m/rad or N/m, by joint.
 */
function choose_drives(mujoco, model) {
  const armature = new Array(model.nv).fill(0), damping = new Array(model.nv).fill(0);
  const stiffness = new Array(model.njnt).fill(0);
  for (let joint = 0; joint < model.njnt; ++joint) {
    if (model.jnt_type[joint] === mujoco.mjtJoint.mjJNT_FREE.value) continue;
    armature[model.jnt_dofadr[joint]] = 0.01 * (1 + joint % 7);
    damping[model.jnt_dofadr[joint]] = 0.3 * (1 + joint % 5);
    stiffness[joint] = 2 * (1 + joint % 3);
  }
  return {armature, damping, stiffness};
}

function compute_state(mujoco, model, data, drives, random) {
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
  Object.assign(state, {
    M: read_buffer(mujoco, model.nv * model.nv, (M) => mujoco.mj_fullM(model, data, M)),
    bias: [...data.qfrc_bias],
    tau: read_buffer(mujoco, model.nv, (tau) => mujoco.mj_rne(model, data, 1, tau)),
    positions: [...data.xpos],
    rotations: [...data.xmat],
    ...compute_motion(mujoco, model, data),
    ...compute_whole(mujoco, model, data),
  });
  Object.assign(state, compute_with_rotors(mujoco, model, data, drives.armature));
  return {...state, ...compute_with_drives(mujoco, model, data, drives, state, random)};
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
  const drives = choose_drives(mujoco, model);
  for (let i = 0; i < kStates; ++i) {
    states.push(compute_state(mujoco, model, data, drives, random));
  }
  const figures =
      {seed: kSeed, replaced: [...prepared.replaced.keys()], ...describe(model), ...drives, states};
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
