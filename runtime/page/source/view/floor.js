// The floor under the robot: a grid that goes along with the camera, and shadows on it.
import * as three from 'three';

const kCells = 24;    // of the grid, along a side
const kReach = 1.8;   // of the robot's radius: so far around it shadows are drawn
const kShadowSize = 1024;  // pixels of the map of shadows
const kSun = new three.Vector3(0.25, -0.4, 1);  // direction to the light

export class Floor {
  group = new three.Group();
  cell = 1;   // m
  reach = 1;  // m

  constructor() {
    this.grid = new three.GridHelper(kCells, kCells);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.material.vertexColors = false;
    this.shade = new three.Mesh(new three.PlaneGeometry(2, 2),
      new three.ShadowMaterial({opacity: 0.22, depthWrite: false}));
    this.shade.receiveShadow = true;
    this.sun = new three.DirectionalLight(0xffffff, 1.7);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.setScalar(kShadowSize);
    this.sun.shadow.bias = -5e-4;
    this.group.add(this.grid, this.shade, this.sun, this.sun.target);
  }

  /** Height in the world, m. */
  get height() {
    return this.grid.position.z;
  }

  set height(z) {
    this.grid.position.z = this.shade.position.z = z;
  }

  /** Cells of 0.01, 0.02, 0.05, 0.1, ... m, of which a robot of this radius has about four. */
  fit(radius) {
    const power = 10 ** Math.floor(Math.log10(radius / 4));
    this.cell = [1, 2, 5, 10].find((one) => one * power >= radius / 4) * power;
    this.grid.scale.setScalar(this.cell);
    this.reach = kReach * radius;
    this.shade.scale.setScalar(this.reach);
    const {camera} = this.sun.shadow;
    camera.left = camera.bottom = -this.reach;
    camera.right = camera.top = this.reach;
    camera.far = 8 * this.reach;
    camera.updateProjectionMatrix();
  }

  /** Keeps the floor and its shadows under `place`, the lines where they would be anyway. */
  follow({x, y, z}) {
    const step = kCells / 4 * this.cell;
    const {grid, shade, sun} = this;
    grid.position.set(Math.round(x / step) * step, Math.round(y / step) * step, this.height);
    shade.position.set(x, y, this.height);
    sun.target.position.set(x, y, z);
    sun.position.copy(sun.target.position).addScaledVector(kSun, 3 * this.reach);
  }

  paint(color) {
    this.grid.material.color.set(color);
    this.grid.material.needsUpdate = true;
  }
}
