// The picture of the robot: model, handles, overlays and gestures on one stage.
import * as three from 'three';

import {point_states_of, points_of} from '../points.js';
import {Gestures} from './gestures.js';
import {Handles} from './handles.js';
import {load_robot} from './load_robot.js';
import {make_obstacles} from './obstacles.js';
import {Overlays} from './overlays.js';
import {pose_robot} from './pose_robot.js';
import {Stage} from './stage.js';

const kSlack = 0.4;  // of its radius: so far the robot goes before the camera follows

export class RobotView {
  model = null;
  handles = null;
  state = null;
  points = [];
  point_states = [];
  radius = 1;
  may_drag = false;
  follows = true;
  #stands = false;  // the floor is where the robot began, with all meshes that have come

  /**
   * Shows robots in `canvas`. `send(line)` sends a line of the language, `tell(text)` says what is
   * under the pointer, `report(text)` what cannot be drawn, `say(coordinate, value)` writes a value
   * with its unit.
   */
  constructor(canvas, {send, tell, report, say}) {
    Object.assign(this, {report, say});
    this.stage = new Stage(canvas);
    this.gestures = new Gestures(this, send, tell);
    this.stage.before_draw(() => this.#prepare());
  }

  /** All joints of the model, for `group_by_limb`. */
  get tree() {
    return Object.values(this.model.joints).map((joint) => ({joint: joint.urdfName,
      parent: joint.parent.urdfName,
      child: joint.children.find((one) => one.isURDFLink)?.urdfName}));
  }

  /** Shows the robot of `hello`. */
  load(urdf, hello) {
    this.#clear();
    this.hello = hello;
    this.points = points_of(hello);
    this.model = load_robot(urdf, hello, this.report, () => {
      this.overlays?.renew_ghost();
      this.#stands = false;
      this.stage.redraw();
    });
    this.stage.scene.add(this.model);
    this.obstacles = make_obstacles(hello);
    this.stage.scene.add(this.obstacles);
    this.model.updateMatrixWorld(true);
    this.handles = new Handles(this.stage, this.model, hello, this.points);
    this.overlays = new Overlays(this.stage, this.model, hello, this.points, this.handles.size);
  }

  /** Shows a state of the server. The first one also places the camera. */
  show(state) {
    if (!this.model) return;
    const is_first = this.state === null;
    this.state = state;
    this.start ??= this.hello.start ?? state.q;
    this.point_states = point_states_of(this.hello, state);
    if (is_first) this.#stand();
    else pose_robot(this.model, this.hello, state.q);
    if (is_first) this.look_at_all('iso');
    else if (this.follows && !this.gestures.target) this.#follow();
    this.stage.redraw();
  }

  /** Lengthens the traces of points by a state. */
  trace(state) {
    this.overlays?.trace(point_states_of(this.hello, state));
  }

  clear_traces() {
    this.overlays?.clear_traces();
    this.stage.redraw();
  }

  can_pull(link) {
    return this.hello.links.includes(link);
  }

  /** Places the camera so that the whole robot is seen, `from` as `Stage.look_at` has it. */
  look_at_all(from) {
    const box = new three.Box3();
    this.model.traverse((part) => {
      if (part.isURDFJoint || part.isURDFLink) {
        box.expandByPoint(part.getWorldPosition(new three.Vector3()));
      }
      if (part.isMesh) box.expandByObject(part);
    });
    for (const {at} of this.point_states) {
      box.expandByPoint(new three.Vector3(...at).addScalar(2 * this.handles.size));
      box.expandByPoint(new three.Vector3(...at).addScalar(-2 * this.handles.size));
    }
    for (const body of this.obstacles.children) box.expandByObject(body);
    const ball = box.getBoundingSphere(new three.Sphere());
    this.radius = Math.max(ball.radius, 0.05);
    this.followed = this.#middle();
    this.stage.look_at(ball.center, this.radius, from);
  }

  /** Where a handle can be grabbed on the screen, or the middle of `link:NAME` is; for tests. */
  where(name) {
    const link = this.model.links[name.replace(/^link:/, '')];
    const place = link ? new three.Box3().setFromObject(link.children.find((one) =>
      one.isURDFVisual)).getCenter(new three.Vector3()) : this.handles.grab_of(name);
    return this.stage.on_screen(place);
  }

  /** The picture as a PNG, in the form of a data address. */
  write_png() {
    this.stage.draw();
    return this.stage.canvas.toDataURL('image/png');
  }

  /**
   * Puts the floor under the robot as it began: at the height 0 of the world, or where its lowest
   * point was, if that is lower.
   */
  #stand() {
    this.#stands = true;
    pose_robot(this.model, this.hello, this.start);
    const box = new three.Box3();
    this.model.traverse((part) => {
      if (!part.isMesh) return;
      part.castShadow = true;
      box.expandByObject(part, true);
    });
    this.stage.floor = Math.min(box.min.z, 0);
    pose_robot(this.model, this.hello, this.state.q);
  }

  /** Mean place of the links. */
  #middle() {
    const middle = new three.Vector3();
    const links = Object.values(this.model.links);
    for (const link of links) middle.add(link.getWorldPosition(new three.Vector3()));
    return middle.divideScalar(links.length);
  }

  /** Moves the camera along with a robot that goes away. */
  #follow() {
    const away = this.#middle().sub(this.followed);
    const distance = away.length();
    const slack = kSlack * this.radius;
    if (!(distance > slack)) return;
    away.multiplyScalar(1 - slack / distance);
    this.followed.add(away);
    this.stage.move(away);
  }

  #prepare() {
    if (!this.state || !this.model) return;
    if (!this.#stands) this.#stand();
    this.handles.group.visible = this.may_drag;
    this.handles.update(this.point_states);
    this.overlays.update(this.state, this.point_states, this.gestures.target);
  }

  #clear() {
    this.gestures.end();
    this.model?.removeFromParent();
    this.obstacles?.removeFromParent();
    this.handles?.remove();
    this.overlays?.remove();
    this.state = null;
    this.start = null;
  }
}
