// What is drawn where a URDF has no visuals: a ball at each joint, a stick to each child.
import * as three from 'three';

const kUp = new three.Vector3(0, 1, 0);

/** Distance between neighbouring joints, the median of those that are apart; m. */
export function typical_length(model) {
  const lengths = Object.values(model.joints).map((joint) => joint.position.length())
    .filter((length) => length > 1e-4).sort((a, b) => a - b);
  return lengths.length > 0 ? lengths[Math.floor(lengths.length / 2)] : 0.3;
}

function make_stick(end, radius, material) {
  const stick = new three.Mesh(
    new three.CylinderGeometry(radius, radius, end.length(), 12), material);
  stick.position.copy(end).multiplyScalar(0.5);
  stick.quaternion.setFromUnitVectors(kUp, end.clone().normalize());
  return stick;
}

/**
 * Adds sticks and balls to the links of `model` that have no visual. Where others have one, `frames`
 * get nothing: they would hide what is there, as fingertips.
 */
export function add_stick_figure(model, frames) {
  const radius = Math.min(0.07 * typical_length(model), 0.03);
  const sticks = new three.MeshPhongMaterial({color: 0x7d8ba1});
  const balls = new three.MeshPhongMaterial({color: 0x44536a});
  const has_visual = (link) => link.children.some((child) => child.isURDFVisual);
  const is_drawn = Object.values(model.links).some(has_visual);
  for (const link of Object.values(model.links)) {
    if (has_visual(link) || (is_drawn && frames.includes(link.urdfName))) continue;
    const joints = link.children.filter((child) => child.isURDFJoint);
    const parts = joints.filter((joint) => joint.position.length() > 1e-6)
      .map((joint) => make_stick(joint.position, radius, sticks));
    parts.push(new three.Mesh(new three.SphereGeometry(1.6 * radius, 16, 12), balls));
    for (const part of parts) part.userData.is_stick = true;
    link.add(...parts);
  }
}
