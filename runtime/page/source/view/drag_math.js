// What a pointer's ray means for a handle. Free of the page: tests run these in Node.
import * as three from 'three';

const kEdgeOn = 0.2;     // sine between ray and plane below which a disk is seen edge-on
const kGrazing = 0.08;   // the same, below which a plane gives no place

/** Meeting of `ray` with the plane through `place`; null if the ray grazes it or points away. */
export function meet_plane(ray, place, normal) {
  if (Math.abs(ray.direction.dot(normal)) < kGrazing) return null;
  return ray.intersectPlane(
    new three.Plane().setFromNormalAndCoplanarPoint(normal, place), new three.Vector3());
}

/** Place of `ray` in the plane through `place` that faces the ray's origin. */
function meet_facing(ray, place, facing) {
  return meet_plane(ray, place, facing) ?? place.clone();
}

/**
 * Turns about `axis` (unit) through `center`, grabbed at `grab`: `angle(ray)` is how far the
 * pointer has turned since, rad, counted through whole turns. A disk that is seen edge-on is
 * turned along its rim.
 */
export class TurnDrag {
  #total = 0;
  #last = 0;

  constructor(center, axis, grab, ray) {
    this.center = center.clone();
    this.axis = axis.clone();
    this.arm = grab.clone().sub(center).projectOnPlane(axis);
    this.tangent = axis.clone().cross(this.arm);
    this.grab = grab.clone();
    this.facing = ray.direction.clone().negate();
    this.edge_on = Math.abs(ray.direction.dot(axis)) < kEdgeOn;
    this.start = this.#angle_of(ray) ?? 0;
    this.#last = this.start;
  }

  angle(ray) {
    const now = this.#angle_of(ray);
    if (now === null) return this.#total;
    const step = this.edge_on ? now - this.#last
      : Math.atan2(Math.sin(now - this.#last), Math.cos(now - this.#last));
    this.#total += step;
    this.#last = now;
    return this.#total;
  }

  #angle_of(ray) {
    if (this.edge_on) {
      const moved = meet_facing(ray, this.grab, this.facing).sub(this.grab);
      return moved.dot(this.tangent) / this.tangent.lengthSq();
    }
    const met = meet_plane(ray, this.center, this.axis);
    if (met === null) return null;
    const arm = met.sub(this.center);
    return Math.atan2(arm.dot(this.tangent) / this.tangent.length(),
      arm.dot(this.arm) / this.arm.length());
  }
}

/** Moves in the plane through `grab`: `offset(ray)` from there, at most `reach` long. */
export class PlaneDrag {
  #last = new three.Vector3();

  constructor(grab, normal, reach) {
    this.grab = grab.clone();
    this.normal = normal.clone();
    this.reach = reach;
  }

  offset(ray) {
    const met = meet_plane(ray, this.grab, this.normal);
    if (met !== null) this.#last = met.sub(this.grab).clampLength(0, this.reach);
    return this.#last.clone();
  }
}

/** Moves along `axis` (unit) through `grab`: `distance(ray)` from there, m. */
export class SlideDrag {
  #last = 0;

  constructor(grab, axis) {
    this.grab = grab.clone();
    this.axis = axis.clone();
  }

  distance(ray) {
    const along = this.axis.dot(ray.direction);
    const steepness = 1 - along * along;
    if (steepness < kGrazing * kGrazing) return this.#last;
    const gap = this.grab.clone().sub(ray.origin);
    this.#last = (along * gap.dot(ray.direction) - gap.dot(this.axis)) / steepness;
    return this.#last;
  }
}
