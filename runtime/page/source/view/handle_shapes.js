// Shapes of the handles: disks and rails of joints, planes and belts of points. Unit size.
import * as three from 'three';

export const kAxisColors = [0xe5484d, 0x30a46c, 0x3e7bfa];
export const kAxisNames = ['x', 'y', 'z'];
const kDiskColor = 0xf5a524;
const kZ = new three.Vector3(0, 0, 1);

/** Axes x, y, z in red, green, blue. */
export function make_axes(length) {
  const axes = new three.AxesHelper(length);
  axes.setColors(...kAxisColors.map((color) => new three.Color(color)));
  axes.material.toneMapped = false;
  return axes;
}

function handle_material(color, opacity) {
  return new three.MeshBasicMaterial(
    {color, opacity, transparent: true, depthTest: false, depthWrite: false,
      side: three.DoubleSide});
}

function shown(geometry, color, opacity) {
  const mesh = new three.Mesh(geometry, handle_material(color, opacity));
  mesh.renderOrder = 10;
  mesh.userData.opacity = opacity;
  return mesh;
}

/** A part that pointers meet and nobody sees: wider than what is drawn. */
function felt(geometry) {
  const mesh = new three.Mesh(geometry, new three.MeshBasicMaterial());
  mesh.visible = false;
  mesh.userData.is_felt = true;
  return mesh;
}

/** Surface of a ring with a rectangular section about z. */
function ring(inner, outer, half_height) {
  const section = [[inner, -half_height], [outer, -half_height], [outer, half_height],
    [inner, half_height], [inner, -half_height]];
  return new three.LatheGeometry(section.map(([x, y]) => new three.Vector2(x, y)), 48)
    .rotateX(Math.PI / 2);
}

/** A disk about z whose mark shows the joint's angle. */
export function make_disk() {
  const disk = new three.Group();
  disk.add(shown(ring(0.8, 1, 0.05), kDiskColor, 0.6));
  disk.add(shown(new three.CircleGeometry(0.8, 48), kDiskColor, 0.12));
  disk.add(shown(new three.PlaneGeometry(0.8, 0.06).translate(0.4, 0, 0), kDiskColor, 0.6));
  disk.add(felt(ring(0.7, 1.12, 0.16)));
  disk.userData.grab = new three.Vector3(0.9, 0, 0);
  return disk;
}

/** A double arrow along z. */
export function make_rail() {
  const rail = new three.Group();
  rail.add(shown(new three.CylinderGeometry(0.05, 0.05, 1.6, 12).rotateX(Math.PI / 2), kDiskColor,
    0.6));
  for (const end of [1, -1]) {
    rail.add(shown(new three.ConeGeometry(0.16, 0.4, 16).rotateX(end * Math.PI / 2)
      .translate(0, 0, end), kDiskColor, 0.6));
  }
  rail.add(felt(new three.CylinderGeometry(0.2, 0.2, 2.4, 8).rotateX(Math.PI / 2)));
  rail.userData.grab = new three.Vector3(0, 0, 1);
  return rail;
}

/** Square in the plane with normal `axis` (0, 1, 2: x, y, z), beside the origin. */
export function make_plane(axis) {
  const plane = new three.Group();
  const corner = [0, 1, 2].map((i) => (i === axis ? 0 : 0.95));
  const turn = new three.Quaternion().setFromUnitVectors(
    kZ, new three.Vector3().setComponent(axis, 1));
  const put = (shape) => shape.applyQuaternion(turn).translate(...corner);
  plane.add(shown(put(new three.PlaneGeometry(0.9, 0.9)), kAxisColors[axis], 0.45));
  const edge = new three.LineSegments(
    new three.EdgesGeometry(put(new three.PlaneGeometry(0.9, 0.9))),
    new three.LineBasicMaterial({color: kAxisColors[axis], depthTest: false, transparent: true}));
  edge.renderOrder = 11;
  plane.add(edge, felt(put(new three.PlaneGeometry(1, 1))));
  plane.userData.grab = new three.Vector3(...corner);
  return plane;
}

/** Circular belt about `axis`. */
export function make_belt(axis) {
  const belt = new three.Group();
  const turn = new three.Quaternion().setFromUnitVectors(
    kZ, new three.Vector3().setComponent(axis, 1));
  const put = (shape) => shape.applyQuaternion(turn);
  belt.add(shown(put(new three.CylinderGeometry(2, 2, 0.22, 64, 1, true).rotateX(Math.PI / 2)),
    kAxisColors[axis], 0.5));
  belt.add(felt(put(ring(1.88, 2.12, 0.16))));
  const side = new three.Vector3().setComponent((axis + 1) % 3, 1)
    .setComponent((axis + 2) % 3, -1).normalize().multiplyScalar(2);
  belt.userData.grab = side;
  return belt;
}

/** Shows that the pointer is on the handle, or not. */
export function highlight(handle, on) {
  handle.traverse((part) => {
    if (part.isMesh && part.userData.opacity) {
      part.material.opacity = on ? Math.min(1, part.userData.opacity + 0.35)
        : part.userData.opacity;
    }
  });
}
