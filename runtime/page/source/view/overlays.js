// What is drawn beside the robot: goals, traces, frames, centre of mass, forces and torques.
import * as three from 'three';

import {make_axes} from './handle_shapes.js';
import {group_coordinates, pose_robot, velocity_indices} from './pose_robot.js';

const kTraceLength = 900;   // states: half a minute
const kGhostFrom = 0.005;   // rad or m from which on the goal is worth a ghost
const kTraceStep = 0.001;   // m between places of a trace
const kForceColor = 0xe5484d;
const kTorqueColor = 0x8e4ec6;
const kArrowForce = 50;     // N that an arrow shows which is as long as a handle
const kGroundArrows = 16;   // length of all arrows of the ground together, in handles

function overlay(color, opacity = 1) {
  return {color, opacity, transparent: true, depthTest: false};
}

/** Trace of a point: the places where it has been. */
class Trace {
  #places = [];

  constructor(color) {
    this.line = new three.Line(new three.BufferGeometry(),
      new three.LineBasicMaterial({color, transparent: true, opacity: 0.85}));
    this.line.frustumCulled = false;
    this.line.geometry.setAttribute('position',
      new three.BufferAttribute(new Float32Array(3 * kTraceLength), 3));
    this.line.geometry.setDrawRange(0, 0);
  }

  add(place) {
    const last = this.#places.at(-1);
    if (last && Math.hypot(...place.map((x, i) => x - last[i])) < kTraceStep) return;
    this.#places.push(place);
    if (this.#places.length > kTraceLength) this.#places.shift();
    const {position} = this.line.geometry.attributes;
    this.#places.forEach((one, i) => position.setXYZ(i, ...one));
    position.needsUpdate = true;
    this.line.geometry.setDrawRange(0, this.#places.length);
  }

  clear() {
    this.#places = [];
    this.line.geometry.setDrawRange(0, 0);
  }
}

function make_ghost(model) {
  const material = new three.MeshBasicMaterial(
    {color: 0x3e7bfa, transparent: true, opacity: 0.22, depthWrite: false,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 4});
  const ghost = model.clone(true);
  const frames = [];
  ghost.traverse((part) => {
    part.castShadow = false;
    if (part.isMesh) part.material = material;
    if (part.userData.is_frame) frames.push(part);
  });
  for (const frame of frames) frame.removeFromParent();
  for (const [name, joint] of Object.entries(ghost.joints)) {
    joint.origPosition = model.joints[name].origPosition;
    joint.origQuaternion = model.joints[name].origQuaternion;
    joint.ignoreLimits = true;
  }
  return ghost;
}

/** Everything that is shown or hidden by name: see `kParts` in panel/view_panel.js. */
export class Overlays {
  group = new three.Group();
  shown = {ghost: true, trace: true, points: true, frames: false, mass: true, forces: true,
    torques: false};
  #ghost = null;

  constructor(stage, model, hello, points, size) {
    Object.assign(this, {model, hello, size, floor: () => stage.floor});
    this.traces = points.map((_, i) => new Trace([0xd6409f, 0x12a594, 0xf76b15][i % 3]));
    this.axes = points.map(() => make_axes(0.7 * size));
    this.goals = points.map(() => this.#make_goal());
    this.leads = points.map(() => this.#make_lead());
    this.mass = this.#make_mass();
    this.spring = this.#make_lead();
    this.arrows = new three.Group();
    this.frames = this.#make_frames();
    this.group.add(this.mass, this.spring, this.arrows, ...this.axes, ...this.goals,
      ...this.leads, ...this.traces.map((trace) => trace.line));
    stage.scene.add(this.group);
    this.scene = stage.scene;
  }

  remove() {
    this.group.removeFromParent();
    this.#ghost?.removeFromParent();
  }

  /** Makes the ghost again, for instance after meshes have arrived. */
  renew_ghost() {
    this.#ghost?.removeFromParent();
    this.#ghost = null;
  }

  /** Lengthens the traces by a state; `update` then shows them. */
  trace(points) {
    points.forEach((point, i) => this.traces[i].add(point.at));
  }

  clear_traces() {
    for (const trace of this.traces) trace.clear();
  }

  /** `points`: states of the points; `target`: what a gesture leads where, or null. */
  update(state, points, target) {
    points.forEach((point, i) => this.#update_point(point, i, target));
    this.#update_ghost(state, target);
    const {mass, spring} = this;
    mass.visible = this.shown.mass && Boolean(state.center_of_mass);
    if (mass.visible) this.#place_mass(state.center_of_mass);
    spring.visible = Boolean(target?.from);
    if (spring.visible) this.#span(spring, target.from.toArray(), target.to.toArray());
    for (const frame of this.frames) frame.visible = this.shown.frames;
    this.#update_arrows(state);
  }

  #update_point(point, i, target) {
    const led = target?.point === i ? target : null;
    const goal = led?.at ?? (point.free ? null : point.goal);
    this.traces[i].line.visible = this.shown.trace;
    this.axes[i].visible = this.shown.points;
    this.axes[i].position.set(...point.at);
    this.axes[i].quaternion.set(...point.turn);
    const away = goal && Math.hypot(...goal.map((x, k) => x - point.at[k])) > kGhostFrom;
    this.goals[i].visible = this.shown.ghost && Boolean(led || away);
    this.leads[i].visible = this.goals[i].visible;
    if (!this.goals[i].visible) return;
    this.goals[i].position.set(...goal);
    this.goals[i].quaternion.set(...(led?.turn ?? point.goal_turn ?? point.turn));
    this.#span(this.leads[i], point.at, goal);
  }

  #update_ghost(state, target) {
    const goal = state.control === 'joint' && state.goal_q ? state.goal_q : state.q;
    const q = [...(state.twin?.q ?? goal)];
    if (target?.index !== undefined) q[target.index] = target.value;
    const away = q.some((value, i) => Math.abs(value - state.q[i]) > kGhostFrom);
    const visible = this.shown.ghost && state.mode === 'running' && away;
    if (visible && !this.#ghost) {
      this.#ghost = make_ghost(this.model);
      this.scene.add(this.#ghost);
    }
    if (!this.#ghost) return;
    this.#ghost.visible = visible;
    if (visible) pose_robot(this.#ghost, this.hello, q);
  }

  #update_arrows(state) {
    this.arrows.clear();
    if (this.shown.forces) {
      // Those of the ground are shares of all that it bears, which may be a ton.
      const borne = state.forces.reduce((sum, {of, force}) =>
        sum + (of === 'ground' ? Math.hypot(...force) : 0), 0);
      for (const {of, at, force} of state.forces) {
        this.#add_arrow(at, force, of === 'ground' ? kGroundArrows / borne : 1 / kArrowForce,
          kForceColor);
      }
    }
    if (this.shown.torques) this.#add_torques(state);
  }

  /** Torques and forces of one-freedom joints along their axes, as shares of the limit. */
  #add_torques(state) {
    const {coordinates} = this.hello;
    const {of_coordinates} = velocity_indices(coordinates);
    group_coordinates(coordinates).forEach(({joint: name, first: index, kinds}) => {
      const joint = this.model.joints[name];
      const effort = coordinates[index].effort ?? 100;
      if (kinds.length !== 1 || !joint) return;
      const axis = joint.axis.clone().transformDirection(joint.matrixWorld);
      const share = axis.multiplyScalar((state.tau[of_coordinates[index]] ?? 0) / effort);
      this.#add_arrow(joint.getWorldPosition(new three.Vector3()).toArray(), share.toArray(), 3,
        kTorqueColor);
    });
  }

  #add_arrow(at, vector, scale, color) {
    const direction = new three.Vector3(...vector);
    const length = Math.min(direction.length() * scale, 8) * this.size;
    if (length < 0.02 * this.size) return;
    const head = Math.min(0.35 * length, 0.5 * this.size);
    const arrow = new three.ArrowHelper(direction.normalize(), new three.Vector3(...at), length,
      color, head, 0.6 * head);
    for (const part of [arrow.line, arrow.cone]) {
      part.material.depthTest = false;
      part.renderOrder = 12;
    }
    this.arrows.add(arrow);
  }

  #make_goal() {
    const goal = new three.Group();
    const ball = new three.Mesh(new three.SphereGeometry(0.12 * this.size, 20, 14),
      new three.MeshBasicMaterial(overlay(0x3e7bfa, 0.7)));
    ball.renderOrder = 9;
    goal.add(ball, make_axes(0.5 * this.size));
    return goal;
  }

  #make_lead() {
    const line = new three.Line(new three.BufferGeometry().setFromPoints(
      [new three.Vector3(), new three.Vector3()]),
    new three.LineBasicMaterial(overlay(0x3e7bfa, 0.8)));
    line.frustumCulled = false;
    return line;
  }

  #span(line, from, to) {
    const {position} = line.geometry.attributes;
    position.setXYZ(0, ...from);
    position.setXYZ(1, ...to);
    position.needsUpdate = true;
  }

  #make_mass() {
    const mass = new three.Group();
    const ball = new three.Mesh(new three.SphereGeometry(0.13 * this.size, 20, 14),
      new three.MeshBasicMaterial(overlay(0x8e4ec6, 0.9)));
    const plumb = this.#make_lead();
    plumb.material = new three.LineDashedMaterial({...overlay(0x8e4ec6, 0.7),
      dashSize: 0.02, gapSize: 0.015});
    mass.add(ball, plumb);
    return mass;
  }

  #place_mass(place) {
    const [ball, plumb] = this.mass.children;
    ball.position.set(...place);
    this.#span(plumb, place, [place[0], place[1], this.floor()]);
    plumb.computeLineDistances();
  }

  #make_frames() {
    return Object.values(this.model.links).map((link) => {
      const frame = make_axes(0.6 * this.size);
      frame.userData.is_frame = true;
      frame.material.depthTest = false;
      link.add(frame);
      return frame;
    });
  }
}
