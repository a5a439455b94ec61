// Puts a model into the state q of the server's coordinates.
import * as three from 'three';

const kZ = new three.Vector3(0, 0, 1);

/** Coordinates of `hello`, grouped by joint: [{joint, first, kinds}]. */
export function group_coordinates(coordinates) {
  const groups = [];
  coordinates.forEach((coordinate, index) => {
    if (groups.at(-1)?.joint !== coordinate.joint) {
      groups.push({joint: coordinate.joint, first: index, kinds: []});
    }
    groups.at(-1).kinds.push(coordinate.kind);
  });
  return groups;
}

/**
 * Places in qd and tau: `of_coordinates` by index in q, -1 for those of floating joints, and
 * `of_floating`, by joint, the first of its six.
 */
export function velocity_indices(coordinates) {
  const of_coordinates = [];
  const of_floating = {};
  let next = 0;
  for (const {joint, kinds} of group_coordinates(coordinates)) {
    if (kinds.length === 7) {
      of_floating[joint] = next;
      of_coordinates.push(...kinds.map(() => -1));
      next += 6;
    } else {
      for (const _ of kinds) of_coordinates.push(next++);
    }
  }
  return {of_coordinates, of_floating};
}

/** Sets `body` to `origin` followed by position and quaternion. */
function place(body, position, quaternion, numbers) {
  const turn = new three.Quaternion(...numbers.slice(3, 7)).normalize();
  body.position.set(...numbers.slice(0, 3)).applyQuaternion(quaternion).add(position);
  body.quaternion.copy(quaternion).multiply(turn);
}

/** A planar joint moves along x and y of its plane and turns about the axis. */
function place_planar(joint, [x, y, angle]) {
  const to_axis = new three.Quaternion().setFromUnitVectors(kZ, joint.axis);
  joint.position.set(x, y, 0).applyQuaternion(to_axis).applyQuaternion(joint.origQuaternion)
    .add(joint.origPosition);
  joint.quaternion.setFromAxisAngle(joint.axis, angle).premultiply(joint.origQuaternion);
}

/** Poses `model` as `q` says; `hello` names the coordinates and the locked joints. */
export function pose_robot(model, hello, q) {
  for (const [name, value] of Object.entries(hello.locked ?? {})) {
    model.joints[name]?.setJointValue(value);
  }
  for (const {joint: name, first, kinds} of group_coordinates(hello.coordinates)) {
    const values = q.slice(first, first + kinds.length);
    const joint = model.joints[name];
    if (kinds.length === 7 && joint) {
      place(joint, joint.origPosition, joint.origQuaternion, values);
    } else if (kinds.length === 7) {
      place(model, new three.Vector3(), new three.Quaternion(), values);
    } else if (kinds.length === 3 && joint) {
      place_planar(joint, values);
    } else {
      joint?.setJointValue(values[0]);
    }
  }
  model.updateMatrixWorld(true);
}
