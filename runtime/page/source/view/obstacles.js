// The obstacles of the scene: spheres and boxes that stand in the world.
import * as three from 'three';

const kAvoided = 0xe88c40;
const kTouched = 0x9e9ea8;

function shape_of({kind, radius, size}) {
  return kind === 'sphere' ? new three.SphereGeometry(radius, 32, 20)
    : new three.BoxGeometry(...size);
}

/** A group of the obstacles of `hello`. Those that the robot avoids are orange, the others grey. */
export function make_obstacles(hello) {
  const group = new three.Group();
  for (const obstacle of hello.obstacles ?? []) {
    const color = obstacle.avoided ? kAvoided : kTouched;
    const body = new three.Mesh(shape_of(obstacle), new three.MeshStandardMaterial({color,
      roughness: 0.8, transparent: true, opacity: 0.75}));
    body.position.set(...obstacle.at);
    body.quaternion.set(...obstacle.turn);
    body.name = obstacle.name;
    body.castShadow = true;
    const edges = new three.LineSegments(new three.EdgesGeometry(body.geometry, 30),
      new three.LineBasicMaterial({color: 0x5c3a1c, transparent: true, opacity: 0.6}));
    body.add(edges);
    group.add(body);
  }
  return group;
}
