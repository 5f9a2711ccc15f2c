// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Normals and poses, against closed forms; without a browser.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { creasedCorners } from '../../lib/rigor/view/page/src/creases.js';
import {
  compose,
  inverse,
  multiply,
  poseText,
  toRollPitchYaw,
} from '../../lib/rigor/view/page/src/pose.js';
import { unitBox } from './arm.mjs';

const normalsOf = ({ positions, triangles }) => {
  const packed = Uint16Array.from(positions.flat(), (v) => Math.round(20000 * (v + 1.5)));
  const indices = Uint16Array.from(triangles.flat());
  const normals = creasedCorners(Float32Array.from(positions.flat()), packed, indices);
  return [...indices].map((vertex, corner) => ({
    at: positions[vertex],
    normal: [...normals.slice(3 * corner, 3 * corner + 3)],
  }));
};

test('a box has edges', () => {
  for (const { normal } of normalsOf(unitBox())) {
    assert.deepEqual(normal.map(Math.abs).toSorted(), [0, 0, 1]);
  }
});

test('the side of a cylinder is smooth, that of a prism is not', () => {
  for (const [sides, isSmooth] of [
    [16, true],
    [6, false],
  ]) {
    const positions = [];
    const triangles = [];
    for (let i = 0; i < sides; ++i) {
      // Four vertices of its own for each side, as STL has them.
      const at = (k, z) => [
        Math.cos((2 * Math.PI * k) / sides),
        Math.sin((2 * Math.PI * k) / sides),
        z,
      ];
      const next = (i + 1) % sides;
      const first = positions.push(at(i, 0), at(next, 0), at(next, 1), at(i, 1)) - 4;
      triangles.push([first, first + 1, first + 2], [first, first + 2, first + 3]);
    }
    // Where the diagonals of two sides end there are three triangles, two of one side: the normal leans to that one by
    // less than half of the angle between them.
    const most = isSmooth ? Math.cos(Math.PI / sides) : Math.cos(Math.PI / sides) + 1e-6;
    for (const { at, normal } of normalsOf({ positions, triangles })) {
      const radial = at[0] * normal[0] + at[1] * normal[1];
      assert.ok(isSmooth ? radial > most : radial < most, `${sides} sides: ${radial}`);
    }
  }
});

test('poses are written as roll, pitch and yaw', () => {
  const turn = (angle, axis) => [
    Math.cos(angle / 2),
    ...[0, 1, 2].map((k) => (k === axis ? Math.sin(angle / 2) : 0)),
  ];
  const ofAngles = ([r, p, y]) => multiply(multiply(turn(y, 2), turn(p, 1)), turn(r, 0));
  for (const angles of [
    [0, 0, 0],
    [0.3, -0.7, 2.9],
    [-3, 1.2, -0.4],
    [0.5, Math.PI / 2, 0.9],
    [0.5, -Math.PI / 2, 0.9],
  ]) {
    const q = ofAngles(angles);
    const again = ofAngles(toRollPitchYaw(q));
    assert.ok(Math.abs(q.reduce((sum, v, i) => sum + v * again[i], 0)) > 1 - 1e-12, String(angles));
  }
  assert.equal(poseText([1, -2.5, 1e-17, ...turn(0.25, 2)]), '<pose>1 -2.5 0 0 0 0.25</pose>');
  const pose = [1, 2, 3, ...ofAngles([0.3, -0.7, 2.9])];
  compose(pose, inverse(pose)).forEach((v, i) =>
    assert.ok(Math.abs(v - (i === 3 ? 1 : 0)) < 1e-12),
  );
});
