"""Compares `treeline simulate` on a ground with MuJoCo's simulation of the same file.

  ground.py --treeline PROGRAM --work FOLDER ROBOT.urdf

The robot is dropped from 5 cm onto springs in its joints; MuJoCo's contacts are springs, too, made as hard as its
steps of 10 us bear. Both must agree about where the base is, how the joints stand, and what the ground has given
until then. Exit status 1: they do not.
"""

import argparse
import csv
import io
import os
import re
import subprocess
import sys

import mujoco
import numpy as np

SECONDS, STEP, FINE = 0.5, 5e-5, 1e-5
STIFFNESS, DAMPING, FRICTION, HEIGHT = 60.0, 0.5, 0.8, 0.05
# MuJoCo's springs yield for a few time constants (4 FINE) at each touch, in which the speed of the fall, 1 m/s, leads
# some 0.1 mm into the ground and later out of it, at slightly other moments for each foot. Angles see ten times that
# over shanks of 0.1 m to 0.3 m.
PLACE, ANGLE, SHARE = 1e-3, 1e-2, 5e-3


def simulate(program, urdf, work):
    scene = os.path.join(work, "scene.yaml")
    with open(scene, "w", encoding="utf-8") as file:
        file.write(f"base: floating\narmature: none\nground: {{friction: {FRICTION}}}\n")
    command = [program, "simulate", urdf, scene, "--height", str(HEIGHT), "--seconds", str(SECONDS), "--step", str(STEP),
               "--stiffness", str(STIFFNESS), "--damping", str(DAMPING), "--csv", "-"]
    run = subprocess.run(command, check=True, capture_output=True, text=True)
    if "weaker springs" in run.stderr:
        sys.exit("the step is too long for the springs that MuJoCo has: " + run.stderr)
    rows = list(csv.DictReader(io.StringIO(run.stdout)))
    names = list(rows[0])
    numbers = np.array([[float(row[name]) for name in names] for row in rows])
    return names, numbers


def as_mujoco(urdf):
    """MuJoCo's model of the file: its collisions touch a plane, and nothing else."""
    text = open(urdf, encoding="utf-8").read()
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"<(visual|dynamics|gazebo|transmission|limit)\b(?:[^>]*?/>|[^>]*>.*?</\1\s*>)", "", text, flags=re.S)
    head = '<mujoco><compiler fusestatic="true" inertiafromgeom="false"/></mujoco><link name="world"/>'
    links, children = (set(re.findall(pattern, text)) for pattern in
                       (r'<link\b[^>]*?name="([^"]*)"', r'<child\b[^>]*?link="([^"]*)"'))
    (root,) = links - children
    head += f'<joint name="base" type="floating"><parent link="world"/><child link="{root}"/></joint>'
    spec = mujoco.MjSpec.from_string(re.sub(r"<robot\b[^>]*>", lambda tag: tag[0] + head, text, count=1))
    for geom in spec.geoms:
        geom.contype, geom.conaffinity = 1, 0
    plane = spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 1])
    plane.contype, plane.conaffinity = 0, 1
    for geom in spec.geoms:
        geom.friction, geom.condim = [FRICTION, 0, 0], 3
        geom.solref, geom.solimp = [4 * FINE, 1], [0.999, 0.9999, 1e-4, 0.5, 2]
    option = spec.option
    option.timestep, option.cone, option.impratio = FINE, mujoco.mjtCone.mjCONE_ELLIPTIC, 100
    return spec.compile()


def run_mujoco(model, start, rows):
    """q in Treeline's order and the ground's impulse, at each of Treeline's rows."""
    data = mujoco.MjData(model)
    data.qpos[:3], data.qpos[3:7] = start[:3], [start[6], *start[3:6]]
    data.qpos[7:] = start[7:]
    rest, places, impulses = start[7:].copy(), [], []
    impulse = np.zeros(3)
    every = round(STEP / FINE)
    for row in range(rows):
        quaternion = data.qpos[3:7]
        places.append(np.concatenate([data.qpos[:3], quaternion[1:], quaternion[:1], data.qpos[7:]]))
        impulses.append(impulse.copy())
        for _ in range(every if row + 1 < rows else 0):
            data.qfrc_applied[6:] = STIFFNESS * (rest - data.qpos[7:]) - DAMPING * data.qvel[6:]
            mujoco.mj_step(model, data)
            for i in range(data.ncon):
                force = np.zeros(6)
                mujoco.mj_contactForce(model, data, i, force)
                impulse += FINE * data.contact[i].frame.reshape(3, 3).T @ force[:3]
    return np.array(places), np.array(impulses)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--treeline", required=True)
    arguments.add_argument("--work", required=True)
    arguments.add_argument("urdf")
    given = arguments.parse_args()
    os.makedirs(given.work, exist_ok=True)
    names, ours = simulate(given.treeline, given.urdf, given.work)
    q = ours[:, [i for i, name in enumerate(names) if re.fullmatch(r"q\d+", name)]]
    force = ours[:, [names.index(f"ground_{axis}_N") for axis in "xyz"]]
    model = as_mujoco(given.urdf)
    joints = [model.joint(i).name for i in range(1, model.njnt)]
    theirs, impulses = run_mujoco(model, q[0], len(q))
    place = np.abs(q[:, :3] - theirs[:, :3]).max()
    turn = np.abs(q[:, 3:7] - theirs[:, 3:7]).max()
    angle = np.abs(q[:, 7:] - theirs[:, 7:]).max()
    impulse = STEP * force.sum(axis=0)
    share = np.linalg.norm(impulse - impulses[-1]) / np.linalg.norm(impulse)
    moved = np.abs(q[-1, 7:] - q[0, 7:]).max()
    print(f"{given.urdf}: {len(joints)} joints, moved by {moved:.2g}; base within {place:.1e} m and {turn:.1e}, joints "
          f"within {angle:.1e} rad, impulse of the ground {impulse[2]:.4g} N s, within {share:.1e} of it")
    good = place < PLACE and turn < ANGLE and angle < ANGLE and share < SHARE
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
