// The lines that the mock server obeys: those that gestures and forms of the page send.

export const kCommands = [
  ['start', 'begin to control'], ['stop', 'emergency stop'], ['brake', 'brake to rest'],
  ['reset', 'leave the emergency stop'], ['hold', 'stop all motions'],
  ['mode joint|task|gravity', 'choose the control'],
  ['joint NAME to X [deg|rad|m] [in T s]', 'a joint to a position'],
  ['joint NAME by X [deg|rad|m] [in T s]', 'a joint by a way'],
  ['move POINT to X Y Z [in T s]', 'a point to a place'],
  ['move POINT by X Y Z [in T s]', 'a point by a way'],
  ['drag POINT to X Y Z [QX QY QZ QW]', 'lead a point'],
  ['drag joint NAME to X [deg|rad|m]', 'lead a joint'],
  ['pull LINK at X Y Z to X Y Z', 'a spring'],
  ['take', 'ask for the command'], ['give', 'give it up'],
].map(([usage, does]) => ({usage, does}));

const kNumber = '(-?[\\d.e-]+)';

function refused(text) {
  return {ok: false, text};
}

function done(text) {
  return {ok: true, text};
}

function joint_index(robot, name) {
  return robot.moving.findIndex((joint) => joint.name === name);
}

function in_radians(value, unit) {
  return unit === 'deg' ? Number(value) * Math.PI / 180 : Number(value);
}

function move_joint(robot, [, name, how, value, unit, seconds]) {
  const index = joint_index(robot, name);
  if (index < 0) return refused(`expected the name of a joint, found \`${name}\``);
  const from = robot.goal[index];
  const to = in_radians(value, unit) + (how === 'by' ? from : 0);
  robot.control = 'joint';
  robot.motions.delete('tip');
  robot.move(index, Number(seconds ?? 1), (share) => {
    robot.goal[index] = from + share * (to - from);
  });
  return done(`${name} moves`);
}

function drag_joint(robot, [, name, value, unit]) {
  const index = joint_index(robot, name);
  if (index < 0) return refused(`expected the name of a joint, found \`${name}\``);
  robot.control = 'joint';
  robot.motions.delete(index);
  robot.goal[index] = in_radians(value, unit);
  return done('');
}

function move_point(robot, [, name, how, x, y, z, seconds]) {
  if (name !== robot.tip) return refused(`expected the name of a point, found \`${name}\``);
  const from = robot.goal_at;
  const to = [x, y, z].map((value, i) => Number(value) + (how === 'by' ? from[i] : 0));
  robot.control = 'task';
  robot.motions.clear();
  robot.move('tip', Number(seconds ?? 1), (share) => {
    robot.goal_at = from.map((value, i) => value + share * (to[i] - value));
  });
  return done(`${name} moves`);
}

function drag_point(robot, [, name, x, y, z, turn]) {
  if (name !== robot.tip) return refused(`expected the name of a point, found \`${name}\``);
  robot.control = 'task';
  robot.motions.clear();
  robot.goal_at = [x, y, z].map(Number);
  if (turn) robot.goal_turn = turn.trim().split(/\s+/).map(Number);
  return done('');
}

function change_mode(robot, word) {
  if (word === 'reset') {
    robot.mode = 'idle';
    robot.fault = '';
  } else if (word === 'stop') {
    robot.mode = 'faulted';
    robot.fault = 'emergency stop: say `reset`, then `start`';
  } else if (robot.mode === 'faulted') {
    return refused('the robot is stopped: say `reset` first');
  } else {
    robot.mode = {start: 'running', brake: 'idle'}[word];
  }
  robot.take_as_goal();
  return done(word);
}

const kMotions = [
  [new RegExp(`^joint (\\S+) (to|by) ${kNumber}(?: (deg|rad|m))?(?: in ${kNumber} s)?$`),
    move_joint],
  [new RegExp(`^drag joint (\\S+) to ${kNumber}(?: (deg|rad|m))?$`), drag_joint],
  [new RegExp(`^move (\\S+) (to|by) ${kNumber} ${kNumber} ${kNumber}(?: in ${kNumber} s)?$`),
    move_point],
  [new RegExp(`^drag (\\S+) to ${kNumber} ${kNumber} ${kNumber}((?: ${kNumber}){4})?$`),
    drag_point],
];

/** Obeys `line`; returns {ok, text}. */
export function obey(robot, line) {
  if (/^(start|stop|brake|reset)$/.test(line)) return change_mode(robot, line);
  if (line === 'hold') {
    robot.take_as_goal();
    return done('holds');
  }
  const control = line.match(/^mode (joint|task|gravity)$/)?.[1];
  if (control) {
    robot.control = control;
    robot.take_as_goal();
    return done(`${control} control`);
  }
  if (line.startsWith('pull ')) return done('');
  for (const [pattern, act] of kMotions) {
    const words = line.match(pattern);
    if (!words) continue;
    return robot.mode === 'running' ? act(robot, words) : refused(`the robot is ${robot.mode}: \`start\` first`);
  }
  return refused(`expected a command, found \`${line.split(' ')[0]}\``);
}
