// The handles of a robot: where they stand, and which one a pointer is on.
import * as three from 'three';

import {highlight, kAxisNames, make_belt, make_disk, make_plane, make_rail} from
  './handle_shapes.js';
import {typical_length} from './stick_figure.js';

const kZ = new three.Vector3(0, 0, 1);
const kSmallest = 12;  // pixels: a handle's radius on the screen is at least this

/** Axis of a coordinate in the frame of its joint, before the joint moves. */
function axis_of(coordinate, joint) {
  const to_axis = new three.Quaternion().setFromUnitVectors(kZ, joint.axis);
  if (coordinate.kind === 'planar_x') return new three.Vector3(1, 0, 0).applyQuaternion(to_axis);
  if (coordinate.kind === 'planar_y') return new three.Vector3(0, 1, 0).applyQuaternion(to_axis);
  return joint.axis.clone();
}

/** Whether a slider or a handle can move it: one freedom of a joint that has a motor. */
export function is_movable(coordinate) {
  return !coordinate.passive &&
    ['angle', 'length', 'planar_x', 'planar_y', 'planar_theta'].includes(coordinate.kind);
}

function is_angle(coordinate) {
  return coordinate.kind === 'angle' || coordinate.kind === 'planar_theta';
}

/**
 * Makes and places the handles. A handle is {kind: disk | rail | plane | belt, name, object, ...}:
 * those of joints have `coordinate` and `index` in q, those of points `point` (index) and `axis`.
 */
export class Handles {
  group = new three.Group();
  list = [];
  #shown = {joints: true, points: true};

  constructor(stage, model, hello, points) {
    this.stage = stage;
    this.model = model;
    this.size = 0.28 * typical_length(model);
    this.#add_joints(hello);
    this.#add_points(points);
    stage.scene.add(this.group);
  }

  remove() {
    this.group.removeFromParent();
  }

  /** Shows or hides the handles of `joints` or `points`. */
  show(kind, visible) {
    this.#shown[kind] = visible;
  }

  /** Puts every handle where its joint or point is. */
  update(points) {
    for (const handle of this.list) {
      const of_joint = handle.coordinate !== undefined;
      handle.object.visible = this.#shown[of_joint ? 'joints' : 'points'];
      if (of_joint) this.#place_at_joint(handle);
      else handle.object.position.set(...points[handle.point].at);
      const least = kSmallest * this.stage.pixel_at(handle.object.position);
      handle.object.scale.setScalar(Math.max(this.size * handle.share, least));
    }
    this.group.updateMatrixWorld(true);
  }

  /** The handle that a ray meets first, with the place where: {handle, place}, or null. */
  pick(caster) {
    const near = this.list.filter((handle) => handle.object.visible);
    const parts = near.flatMap((handle) => handle.object.children.filter(
      (part) => part.userData.is_felt));
    const hit = caster.intersectObjects(parts, false)[0];
    if (!hit) return null;
    return {handle: near.find((handle) => handle.object === hit.object.parent), place: hit.point};
  }

  highlight(chosen) {
    for (const handle of this.list) highlight(handle.object, handle === chosen);
  }

  /** Place in the world where a handle can be grabbed. */
  grab_of(name) {
    const handle = this.list.find((one) => one.name === name);
    return handle?.object.localToWorld(handle.object.userData.grab.clone());
  }

  #add(handle) {
    this.list.push(handle);
    this.group.add(handle.object);
  }

  #add_joints(hello) {
    this.model.updateMatrixWorld(true);
    hello.coordinates.forEach((coordinate, index) => {
      if (!is_movable(coordinate) || !this.model.joints[coordinate.joint]) return;
      const kind = is_angle(coordinate) ? 'disk' : 'rail';
      this.#add({kind, name: `${kind}:${coordinate.name}`, coordinate, index,
        share: this.#share_of(this.model.joints[coordinate.joint]),
        object: kind === 'disk' ? make_disk() : make_rail()});
    });
  }

  #add_points(points) {
    points.forEach((point, index) => {
      for (const axis of [0, 1, 2]) {
        const others = kAxisNames.filter((_, i) => i !== axis);
        if (others.some((name) => point.rows.includes(name))) {
          this.#add({kind: 'plane', name: `plane:${point.name}:${others.join('')}`, point: index,
            axis, share: 1, object: make_plane(axis)});
        }
        if (point.rows.includes(`r${kAxisNames[axis]}`)) {
          this.#add({kind: 'belt', name: `belt:${point.name}:${kAxisNames[axis]}`, point: index,
            axis, share: 1, object: make_belt(axis)});
        }
      }
    });
  }

  /** Joints whose frames coincide, as in a wrist, get disks of growing size. */
  #share_of(joint) {
    const place = joint.getWorldPosition(new three.Vector3());
    const before = this.list.filter((handle) =>
      this.model.joints[handle.coordinate.joint].getWorldPosition(new three.Vector3())
        .distanceTo(place) < 0.4 * this.size).length;
    return 0.85 + 0.35 * before;
  }

  #place_at_joint(handle) {
    const joint = this.model.joints[handle.coordinate.joint];
    const axis = axis_of(handle.coordinate, joint);
    const moved = joint.getWorldQuaternion(new three.Quaternion());
    handle.axis = axis.clone().applyQuaternion(moved);
    joint.getWorldPosition(handle.object.position);
    handle.object.quaternion.setFromUnitVectors(kZ, axis).premultiply(moved);
  }
}
