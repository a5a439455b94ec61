// The 3-D stage: renderer, camera, light and floor. Draws only when something has changed.
import * as three from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';

import {Floor} from './floor.js';
import {make_axes} from './handle_shapes.js';

const kSlow = 40;  // ms: pictures that take longer leave as much time again to everything else

/** From where the camera looks, in the world; the sides as a robot that faces x has them. */
export const kDirections = {iso: [1, -1.1, 0.55], front: [1, 0, 0], side: [0, -1, 0],
  top: [0, -1e-3, 1]};

/** Value of a CSS variable of the page, for instance `--view-ground`. */
export function css_color(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** A scene with z up, shown in `canvas`, which may change its size at any time. */
export class Stage {
  scene = new three.Scene();
  camera = new three.PerspectiveCamera(40, 1, 0.01, 200);
  floor_plane = new Floor();
  #wanted = false;
  #asked = 0;
  #rest_until = 0;
  #before_draw = [];

  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new three.WebGLRenderer({canvas, antialias: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.addEventListener('change', () => {
      this.floor_plane.follow(this.orbit.target);
      this.redraw();
    });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = three.BasicShadowMap;  // soft ones take twice as long in software
    this.axes = make_axes(1);
    this.scene.add(new three.HemisphereLight(0xffffff, 0x8d8d99, 1.7), this.floor_plane.group,
      this.axes);
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#paint());
    this.#paint();
  }

  /** Calls `prepare` before every picture. */
  before_draw(prepare) {
    this.#before_draw.push(prepare);
  }

  /** Asks for a picture at the screen's next opportunity. */
  redraw() {
    if (this.#wanted) return;
    this.#wanted = true;
    const rest = this.#rest_until - performance.now();
    if (rest > 0) setTimeout(() => this.#ask(), rest);
    else this.#ask();
  }

  #ask() {
    this.#asked = performance.now();
    requestAnimationFrame(() => {
      this.draw();
      const now = performance.now();
      const took = now - this.#asked;
      this.#rest_until = took > kSlow ? now + took : 0;
    });
  }

  draw() {
    this.#wanted = false;
    for (const prepare of this.#before_draw) prepare();
    this.renderer.render(this.scene, this.camera);
  }

  /**
   * Places the camera so that a ball at `center` of `radius` fills the picture: seen from a
   * direction of `kDirections`, or from where the camera is.
   */
  look_at(center, radius, from) {
    const half = three.MathUtils.degToRad(this.camera.fov / 2);
    const narrow = Math.atan(Math.tan(half) * Math.min(this.camera.aspect, 1));
    const distance = 1.05 * radius / Math.sin(narrow);
    const direction = (kDirections[from] ? new three.Vector3(...kDirections[from])
      : this.camera.position.clone().sub(this.orbit.target)).normalize();
    this.camera.position.copy(center).addScaledVector(direction, distance);
    this.camera.near = distance / 200;
    this.camera.far = distance * 60;
    this.camera.updateProjectionMatrix();
    this.orbit.target.copy(center);
    this.orbit.update();
    this.floor_plane.fit(radius);
    this.floor_plane.follow(center);
    this.axes.scale.setScalar(this.floor_plane.cell);
    this.redraw();
  }

  /** Height of the floor in the world, m. */
  get floor() {
    return this.floor_plane.height;
  }

  set floor(height) {
    this.floor_plane.height = height;
    this.redraw();
  }

  /** Moves the camera, and what it looks at, by a vector. */
  move(by) {
    this.camera.position.add(by);
    this.orbit.target.add(by);
    this.orbit.update();
  }

  /** Ray through a pointer's position on the screen. */
  ray_through({clientX, clientY}) {
    const box = this.canvas.getBoundingClientRect();
    const caster = new three.Raycaster();
    caster.setFromCamera(new three.Vector2(
      2 * (clientX - box.left) / box.width - 1, 1 - 2 * (clientY - box.top) / box.height),
    this.camera);
    return caster;
  }

  /** Place of a point of the world on the screen. */
  on_screen(place) {
    this.camera.updateMatrixWorld();
    const box = this.canvas.getBoundingClientRect();
    const seen = place.clone().project(this.camera);
    return {clientX: box.left + (seen.x + 1) / 2 * box.width,
      clientY: box.top + (1 - seen.y) / 2 * box.height};
  }

  /** Length in the world that a pixel shows at `place`. */
  pixel_at(place) {
    const distance = this.camera.position.distanceTo(place);
    const height = this.canvas.clientHeight || 1;
    return 2 * distance * Math.tan(three.MathUtils.degToRad(this.camera.fov / 2)) / height;
  }

  #paint() {
    this.scene.background = new three.Color(css_color('--view'));
    this.floor_plane.paint(css_color('--view-ground'));
    this.redraw();
  }

  #resize() {
    const {clientWidth, clientHeight} = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }
}
