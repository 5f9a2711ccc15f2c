// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Poses [x, y, z, qw, qx, qy, qz]: how they compose, and how they are written.
// A quaternion is [w, x, y, z], a vector [x, y, z].

export const IDENTITY = [0, 0, 0, 1, 0, 0, 0];

export function multiply([aw, ax, ay, az], [bw, bx, by, bz]) {
  return [
    aw * bw - ax * bx - ay * by - az * bz,
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
  ];
}

const conjugate = ([w, x, y, z]) => [w, -x, -y, -z];

export function rotate(q, v) {
  return multiply(multiply(q, [0, ...v]), conjugate(q)).slice(1);
}

const translation = (pose) => pose.slice(0, 3);
const rotation = (pose) => pose.slice(3);

/** `b`, which is given in the frame `a`, in the frame of `a`. */
export function compose(a, b) {
  const moved = rotate(rotation(a), translation(b));
  return [a[0] + moved[0], a[1] + moved[1], a[2] + moved[2], ...multiply(rotation(a), rotation(b))];
}

export function inverse(pose) {
  const back = conjugate(rotation(pose));
  return [...rotate(back, translation(pose)).map((v) => -v), ...back];
}

/** Turns by `angle` (rad) about the line through `origin` along the unit vector `direction`. */
export function turnAbout(origin, direction, angle) {
  const s = Math.sin(angle / 2);
  const q = [Math.cos(angle / 2), ...direction.map((v) => s * v)];
  const moved = rotate(q, origin);
  return [origin[0] - moved[0], origin[1] - moved[1], origin[2] - moved[2], ...q];
}

export function slideAlong(direction, distance) {
  return [...direction.map((v) => distance * v), 1, 0, 0, 0];
}

/** Roll, pitch and yaw about the fixed axes x, y and z, as SDF and URDF write them. */
export function toRollPitchYaw([w, x, y, z]) {
  const sine = Math.max(-1, Math.min(1, 2 * (w * y - x * z)));
  if (Math.abs(sine) > 1 - 1e-12) {
    // Straight up or down roll and yaw turn about one axis: yaw takes all of it.
    return [0, (Math.sign(sine) * Math.PI) / 2, -2 * Math.sign(sine) * Math.atan2(x, w)];
  }
  return [
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    Math.asin(sine),
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ];
}

/** Nine digits, which is less than a micrometre in a kilometre; what is rounding noise is 0. */
export function numberText(value) {
  if (!Number.isFinite(value)) return String(value);
  return String(Math.abs(value) < 1e-12 ? 0 : Number(value.toPrecision(9)));
}

export function sixNumbers(pose) {
  return [...translation(pose), ...toRollPitchYaw(rotation(pose))];
}

/** "<pose>x y z r p y</pose>" */
export function poseText(pose) {
  return `<pose>${sixNumbers(pose).map(numberText).join(' ')}</pose>`;
}
