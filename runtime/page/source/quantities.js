// What of a state can be plotted and saved: a column for each number.
import {distance_from_goal, point_states_of, points_of, turn_from_goal} from './points.js';
import {velocity_indices} from './view/pose_robot.js';

/** Titles of the quantities that can be plotted, in their order. */
export const kTitles = {q: 'Position', qd: 'Speed', tau: 'Torque', error: 'Error of joints',
  miss: 'Error of points', at: 'Place of points', force: 'Forces',
  shown: 'Shown by your controller', control: 'Loop'};

const kMotions = ['vx', 'vy', 'vz', 'wx', 'wy', 'wz'];  // of a floating joint
const kAxes = ['x', 'y', 'z'];

function known(...limits) {
  return limits.filter((limit) => Number.isFinite(limit));
}

/** Goal less position; NaN where the goals of joints say nothing: the task may move any joint. */
function error_of(state, index) {
  const led = state.mode === 'running' && state.control === 'joint' && state.goal_q;
  return led ? state.goal_q[index] - state.q[index] : NaN;
}

/** Columns of one entry of q: position, and where it has one velocity of its own, speed and force. */
function of_coordinate({name, joint, unit, lower, upper, velocity, effort, passive}, index, v) {
  const of = (quantity, its_unit, read, limits = []) =>
    ({quantity, name, joint, unit: its_unit, read, limits});
  const q = of('q', unit || '1', (state) => state.q[index], known(lower, upper));
  // The name in tables: `q_JOINT` where that says which, else the place in q.
  const columns = [name === joint ? q : {...q, title: `q${index} ${name}`}];
  if (v < 0) return columns;
  columns.push(of('qd', `${unit}/s`, (state) => state.qd[v],
    known(velocity && -velocity, velocity)),
  of('tau', unit === 'm' ? 'N' : 'N m', (state) => state.tau[v], known(effort && -effort, effort)));
  if (passive) return columns;
  return [...columns, of('goal', unit, (state) => state.goal_q?.[index]),
    of('error', unit, (state) => error_of(state, index))];
}

/** The six velocities of a floating joint in the axes of its link, and the forces along them. */
function of_floating(joint, first) {
  return kMotions.flatMap((motion, i) => {
    const turns = i > 2;
    const column = {joint, name: `${joint}.${motion}`, limits: []};
    return [{...column, quantity: 'qd', unit: turns ? 'rad/s' : 'm/s',
      read: (state) => state.qd[first + i]},
    {...column, quantity: 'tau', unit: turns ? 'N m' : 'N', read: (state) => state.tau[first + i]}];
  });
}

function of_joints(hello) {
  const velocities = velocity_indices(hello.coordinates);
  return hello.coordinates.flatMap((coordinate, index) => {
    const is_first = coordinate.kind === 'x';
    return [...of_coordinate(coordinate, index, velocities.of_coordinates[index]),
      ...(is_first ? of_floating(coordinate.joint, velocities.of_floating[coordinate.joint]) : [])];
  });
}

function of_point(hello, name, index) {
  const states = (state) => point_states_of(hello, state)[index];
  const of = (quantity, its_name, unit, read, more = {}) =>
    ({quantity, name: its_name, unit, read: (state) => read(states(state)), limits: [], ...more});
  return [
    ...kAxes.map((axis, i) => of('at', `${name}.${axis}`, 'm', ({at}) => at[i])),
    of('miss', name, 'm', distance_from_goal, {shown: 'mm'}),
    of('miss', `${name} turn`, 'rad', turn_from_goal),
    ...(hello.obstacles?.length > 0 ? kAxes.map((axis, i) =>
      of('force', `${name}.${axis}`, 'N', ({force}) => force?.[i])) : [])];
}

/** The whole force of what pushes or pulls the robot: `hand` or `ground`. */
function of_forces(what, name) {
  const along = (i) => ({forces}) =>
    forces.reduce((sum, {of, force}) => sum + (of === what ? force[i] : 0), 0);
  return kAxes.map((axis, i) =>
    ({quantity: 'force', name: `${name}.${axis}`, unit: 'N', limits: [], read: along(i)}));
}

function of_loop(name, read) {
  return {quantity: 'control', name, unit: 'us', read, limits: []};
}

/**
 * Columns of the states of a robot: {quantity, name, unit, read(state), limits, joint}. Numbers
 * and limits are in the unit; `joint` is there for those of joints. What `state` does not have is
 * left out, as the forces of a table.
 */
export function list_columns(hello, state) {
  const can_be_pulled = hello.links.length > 0;
  return [...of_joints(hello),
    ...points_of(hello).flatMap(({name}, index) => of_point(hello, name, index)),
    ...(can_be_pulled ? of_forces('hand', 'pull') : []),
    ...(hello.ground ? of_forces('ground', 'ground') : []),
    ...Object.keys(state.shown ?? {}).map((name) =>
      ({quantity: 'shown', name, unit: '1', limits: [], read: ({shown}) => shown?.[name]})),
    of_loop('mean', ({control_us}) => control_us.mean),
    of_loop('largest', ({control_us}) => control_us.max),
    of_loop('period', ({period_us}) => period_us.mean),
    of_loop('largest period', ({period_us}) => period_us.max)]
    .filter(({read}) => read(state) !== undefined);
}
