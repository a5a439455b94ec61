// The limbs of a robot: chains of joints between the places where its tree branches.

/**
 * Groups joints by limb. `tree` has all joints of the URDF as {joint, parent, child}, links by
 * name; `moving` names those that move. A limb is named after its last link. A branch of one joint,
 * such as a wheel, belongs to the limb that it branches from. Returns [{title, joints}], limbs and
 * joints in the order of `moving`.
 */
export function group_by_limb(tree, moving) {
  const place = (joint) => moving.indexOf(joint);
  const moves = ({joint, child}) => moving.includes(joint) ||
    tree.some((one) => one.parent === child && moves(one));
  const limbs = [];
  const lengthen = (limb, {joint, child}) => {
    if (!moving.includes(joint)) return limb;
    limb.joints.push(joint);
    limb.title = child;
    return limb;
  };
  const follow = (limb, link) => {
    const next = tree.filter((one) => one.parent === link && moves(one));
    if (next.length === 1) follow(lengthen(limb, next[0]), next[0].child);
    if (next.length < 2) return;
    for (const one of next) {
      const branch = lengthen({title: one.child, joints: []}, one);
      const count = limbs.length;
      follow(branch, one.child);
      const is_limb = branch.joints.length > 1 || limbs.length > count;
      if (is_limb && branch.joints.length > 0) limbs.push(branch);
      else limb.joints.push(...branch.joints);
    }
  };
  const roots = new Set(tree.map((one) => one.parent));
  for (const one of tree) roots.delete(one.child);
  for (const root of roots) {
    const trunk = {title: root, joints: []};
    follow(trunk, root);
    if (trunk.joints.length > 0) limbs.push(trunk);
  }
  const elsewhere = moving.filter((joint) => !limbs.some((limb) => limb.joints.includes(joint)));
  if (elsewhere.length > 0) limbs.push({title: elsewhere[0], joints: elsewhere});
  for (const limb of limbs) limb.joints.sort((a, b) => place(a) - place(b));
  return limbs.sort((a, b) => place(a.joints[0]) - place(b.joints[0]));
}
