// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Forward kinematics, as lib/rigor/model/kinematics.cc: from joint positions to the
// displacement of every link from where it is with all joints at zero.

import { IDENTITY, compose, slideAlong, turnAbout } from './pose.js';

export class Kinematics {
  constructor(data) {
    this.links = data.links;
    this.joints = data.joints;
    this.values = data.joints.map((joint) => joint.axes.map(() => 0));
  }

  /** What the axis is set to. That of a mimic axis follows from its leader's. */
  set(joint, axis, value) {
    if (axis in this.values[joint] && Number.isFinite(value)) this.values[joint][axis] = value;
  }

  reset() {
    for (const values of this.values) values.fill(0);
  }

  /** rad or m */
  position(joint, axis, followed = 0) {
    const mimic = this.joints[joint].axes[axis].mimic;
    if (!mimic) return this.values[joint][axis];
    const leader = this.joints[mimic.joint];
    // Leaders that follow one another in a circle lead nowhere.
    if (!leader || !leader.axes[mimic.axis] || followed > this.joints.length) return 0;
    const led = this.position(mimic.joint, mimic.axis, followed + 1);
    return mimic.multiplier * (led - mimic.reference) + mimic.offset;
  }

  /** Of every link, in the file's frame. */
  displacements() {
    const known = this.links.map(() => null);
    this.links.forEach((_, link) => this.#resolve(link, known));
    return known.map((D) => D ?? IDENTITY);
  }

  #resolve(link, known) {
    const chain = []; // from the link up to one that is known, or that nothing moves
    let at = link;
    while (at >= 0 && !known[at] && chain.length <= this.links.length) {
      chain.push(at);
      at = this.joints[this.links[at].movedBy]?.parent ?? -1;
    }
    if (chain.length > this.links.length) return; // a loop of joints has no tree to move along
    for (const current of chain.reverse()) {
      const joint = this.links[current].movedBy;
      const parent = this.joints[joint]?.parent ?? -1;
      const D = known[parent] ?? IDENTITY;
      known[current] = joint >= 0 ? compose(D, this.#motion(joint)) : D;
    }
  }

  #motion(index) {
    const { pose, axes } = this.joints[index];
    if (!pose) return IDENTITY;
    return axes.reduce((D, axis, k) => {
      if (!axis.direction) return D; // the file does not tell
      const q = this.position(index, k);
      const step = axis.slides
        ? slideAlong(axis.direction, q)
        : turnAbout(pose.slice(0, 3), axis.direction, q);
      return compose(D, step);
    }, IDENTITY);
  }
}
