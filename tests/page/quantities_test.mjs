// Would catch: a table or a plot whose numbers stand under another joint's name or unit, an error of
// joints where the task moves them, a limb that lacks a joint or has that of another.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {load_source} from './packages.mjs';

const {list_columns} = await load_source('quantities.js');
const {write_csv} = await load_source('recorder.js');
const {group_by_limb} = await load_source('limbs.js');

const kBase = ['x', 'y', 'z', 'qx', 'qy', 'qz', 'qw'].map((kind) => ({name: `base.${kind}`,
  joint: 'base', kind, unit: kind.startsWith('q') ? '' : 'm', lower: null, upper: null,
  velocity: null, effort: null, passive: false}));
const kHello = {base: 'floating', ground: true, links: ['arm'], points: [{name: 'tool'}],
  obstacles: [{name: 'ball'}],
  coordinates: [...kBase,
  {name: 'hip', joint: 'hip', kind: 'angle', unit: 'rad', lower: -1, upper: 2, velocity: 3,
    effort: 40, passive: false},
  {name: 'rail', joint: 'rail', kind: 'length', unit: 'm', lower: null, upper: 0.5, velocity: null,
    effort: null, passive: true}]};
const kTimes = {mean: 9, max: 30};
const kState = {time: 1.5, mode: 'running', control: 'joint', q: [0, 0, 1, 0, 0, 0, 1, 0.5, 0.25],
  qd: [1, 2, 3, 4, 5, 6, 7, 8], tau: [10, 20, 30, 40, 50, 60, 70, 80],
  goal_q: [0, 0, 2, 0, 0, 0, 1, 0.75, 0.25], control_us: kTimes, period_us: kTimes,
  points: [{at: [1, 2, 3], turn: [0, 0, 0, 1], goal: [1, 2, 3.5],
    goal_turn: [0, 0, Math.SQRT1_2, Math.SQRT1_2], force: [0, 0, -4]}],
  shown: {power: 2.5},
  forces: [{of: 'obstacle', link: 'arm', at: [1, 2, 3], force: [0, 0, -4]},
    {of: 'ground', at: [0, 0, 0], force: [0, 1, 20]},
    {of: 'ground', at: [1, 0, 0], force: [0, 0, 30]},
    {of: 'hand', link: 'arm', at: [0, 0, 0], force: [7, 0, 0]}]};

function table(states) {
  const [head, ...rows] = write_csv(list_columns(kHello, kState), states).trimEnd().split('\n')
    .map((row) => row.split(','));
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i]])));
}

test('every number stands under its name and unit', () => {
  const [row] = table([kState]);
  const expected = {'time [s]': 1.5, mode: 'running', 'q2 base.z [m]': 1, 'q_hip [rad]': 0.5,
    'qd_base.vz [m/s]': 3, 'qd_base.wz [rad/s]': 6, 'qd_hip [rad/s]': 7, 'qd_rail [m/s]': 8,
    'tau_base.vx [N]': 10, 'tau_base.wx [N m]': 40, 'tau_hip [N m]': 70, 'tau_rail [N]': 80,
    'goal_hip [rad]': 0.75, 'error_hip [rad]': 0.25, 'at_tool.z [m]': 3, 'miss_tool [m]': 0.5,
    'at_base.z [m]': 1, 'miss_base [m]': 1, 'force_tool.z [N]': -4, 'force_pull.x [N]': 7,
    'force_ground.y [N]': 1, 'force_ground.z [N]': 50,
    'shown_power [1]': 2.5, 'control_mean [us]': 9};
  for (const [name, value] of Object.entries(expected)) {
    assert.equal(row[name], String(value), name);
  }
  assert.ok(Math.abs(row['miss_tool turn [rad]'] - Math.PI / 2) < 1e-12, 'a quarter turn');
  assert.equal(row['error_rail [rad]'], undefined, 'a joint without a motor has no goal');
});

test('joints that the task moves have no error', () => {
  const [row] = table([{...kState, control: 'task'}]);
  assert.equal(row['error_hip [rad]'], '');
});

test('limits are those of the joint, to both sides', () => {
  const columns = list_columns(kHello, kState);
  const limits = (quantity, name) =>
    columns.find((one) => one.quantity === quantity && one.name === name).limits;
  assert.deepEqual(limits('q', 'hip'), [-1, 2]);
  assert.deepEqual(limits('qd', 'hip'), [-3, 3]);
  assert.deepEqual(limits('tau', 'hip'), [-40, 40]);
  assert.deepEqual(limits('q', 'rail'), [0.5]);
  assert.deepEqual(limits('tau', 'rail'), []);
});

test('what there is not is no column', () => {
  const free = list_columns({...kHello, obstacles: [], ground: undefined}, kState);
  assert.deepEqual(free.filter(({quantity}) => quantity === 'force').map(({name}) => name),
    ['pull.x', 'pull.y', 'pull.z'], 'nothing to touch');
  const columns = list_columns(kHello, {...kState, qd: [], tau: []});
  assert.deepEqual(columns.filter(({quantity}) => ['qd', 'tau'].includes(quantity)), []);
  assert.ok(columns.some(({quantity}) => quantity === 'q'));
});

/** Joints as `PARENT JOINT CHILD`. */
function tree(...lines) {
  return lines.map((line) => line.split(' ')).map(([parent, joint, child]) =>
    ({parent, joint, child}));
}

test('limbs end where the tree branches', () => {
  const torso = tree('pelvis waist chest', 'pelvis fixed imu', 'chest neck head',
    'chest l_shoulder l_upper', 'l_upper l_elbow l_hand', 'l_hand l_frame l_tip',
    'chest r_shoulder r_upper', 'r_upper r_elbow r_hand');
  assert.deepEqual(group_by_limb(torso, ['base', 'waist', 'neck', 'l_shoulder', 'l_elbow',
    'r_shoulder', 'r_elbow']), [{title: 'base', joints: ['base']},
    {title: 'chest', joints: ['waist', 'neck']},
    {title: 'l_hand', joints: ['l_shoulder', 'l_elbow']},
    {title: 'r_hand', joints: ['r_shoulder', 'r_elbow']}]);
});

test('an arm, its gripper and the wheels of a cart are one limb each', () => {
  const arm = tree('base j1 one', 'one j2 two', 'two left finger', 'two right thumb');
  assert.deepEqual(group_by_limb(arm, ['j1', 'j2', 'left', 'right']),
    [{title: 'two', joints: ['j1', 'j2', 'left', 'right']}]);
  const cart = tree('cart w1 a', 'cart w2 b', 'cart arm1 c', 'c arm2 d');
  assert.deepEqual(group_by_limb(cart, ['w1', 'w2', 'arm1', 'arm2']),
    [{title: 'cart', joints: ['w1', 'w2']}, {title: 'd', joints: ['arm1', 'arm2']}]);
});
