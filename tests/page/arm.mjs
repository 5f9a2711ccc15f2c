// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model written by hand: an arm of three joints in a plane and a lift, whose poses have closed forms.
//
//   base ─shoulder (turns about z at the origin)→ upper ─elbow (about z at x = 1)→ fore
//        fore ─slider (slides along x)→ tip
//   base ─lift (slides along z; follows the shoulder: 2 (q - 0.1) + 0.3)→ tray

import { Bytes, packMesh } from './format.mjs';

/** A box of side one, four vertices to a face, without normals. */
export function unitBox() {
  const positions = [];
  const triangles = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (const side of [-0.5, 0.5]) {
      const first = positions.length;
      for (const [u, v] of [
        [-0.5, -0.5],
        [0.5, -0.5],
        [0.5, 0.5],
        [-0.5, 0.5],
      ]) {
        const p = [0, 0, 0];
        p[axis] = side;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        positions.push(p);
      }
      const faces = [
        [0, 1, 2],
        [0, 2, 3],
      ].map((t) => t.map((i) => first + i));
      triangles.push(...(side > 0 ? faces : faces.map(([a, b, c]) => [a, c, b])));
    }
  }
  return { positions, triangles };
}

const square = {
  positions: [
    [-3, -3, 0],
    [3, -3, 0],
    [3, 3, 0],
    [-3, 3, 0],
  ],
  normals: [
    [0, 0, 1],
    [0, 0, 1],
    [0, 0, 1],
    [0, 0, 1],
  ],
  triangles: [
    [0, 1, 2],
    [0, 2, 3],
  ],
};

export const sourceText = `<?xml version="1.0"?>
<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="upper">
      <inertial><mass>-2</mass></inertial>
    </link>
  </model>
</sdf>
`;

const pose = (x, y, z) => [x, y, z, 1, 0, 0, 0];

/** `rename` is applied to every text that a model's file can hold. */
export function armPage({ rename = (text) => text, live = false, change = () => {} } = {}) {
  const bytes = new Bytes();
  const meshes = [packMesh(bytes, unitBox()), packMesh(bytes, square)];
  const link = (name, x, movedBy) => ({
    name: rename(name),
    scoped: rename(`arm::${name}`),
    model: 0,
    pose: pose(x, 0, 0),
    mass: 1,
    com: [0.5, 0, 0],
    inertia: [0.1, 0, 0, 0.2, 0, 0.3],
    inertialText: rename(`<inertial><mass>1</mass></inertial>`),
    movedBy,
    line: 4,
    file: 0,
  });
  const joint = (name, parent, child, x, axis) => ({
    name: rename(name),
    scoped: rename(`arm::${name}`),
    model: 0,
    type: axis.slides ? 'prismatic' : 'revolute',
    parent,
    child,
    pose: pose(x, 0, 0),
    line: 5,
    file: 0,
    axes: [axis],
  });
  const turning = { direction: [0, 0, 1], slides: false, lower: -2, upper: 2, mimic: null };
  const box = (layer, link, at, scale, color) => ({
    layer,
    name: rename(`${layer} ${link}`),
    link,
    joint: -1,
    mesh: 0,
    pose: at,
    scale,
    surfaces: [{ color, texture: -1 }],
    line: 4,
    file: 0,
  });
  const bodies = [
    box('visual', 0, pose(0, 0, -0.2), [0.4, 0.4, 0.4], [0.5, 0.5, 0.55, 1]),
    box('visual', 1, pose(0.5, 0, 0), [1, 0.1, 0.1], [0.8, 0.3, 0.2, 1]),
    box('visual', 2, pose(1.5, 0, 0), [-1, 0.1, 0.1], [0.2, 0.5, 0.8, 1]),
    box('visual', 3, pose(2.1, 0, 0), [0.2, 0.2, 0.2], [0.2, 0.7, 0.3, 1]),
    box('visual', 4, pose(0, 0.6, 0), [0.3, 0.3, 0.05], [0.9, 0.8, 0.2, 1]),
    box('collision', 1, pose(0.5, 0, 0), [1.05, 0.2, 0.2], [1, 0.55, 0.1, 0.5]),
    box('inertia', 2, pose(1.5, 0, 0), [0.6, 0.3, 0.3], [0.65, 0.25, 0.85, 0.5]),
    box('com', 1, pose(0.5, 0, 0), [0.08, 0.08, 0.08], [0.05, 0.05, 0.05, 1]),
    box('frames', 1, pose(0, 0, 0.1), [0.05, 0.05, 0.3], [0.1, 0.2, 0.9, 1]),
    { ...box('axes', 2, pose(1, 0, 0.2), [0.04, 0.04, 0.5], [0.95, 0.75, 0, 1]), joint: 1 },
    box('contacts', 1, pose(1, 0, -0.1), [0.1, 0.1, 0.1], [0.9, 0.2, 0.5, 1]),
    { ...box('ground', -1, pose(0, 0, -0.4), [1, 1, 1], [0.9, 0.9, 0.9, 0.35]), mesh: 1 },
  ];
  const finding = (rule, severity, more) => ({
    rule: rename(rule),
    severity,
    message: rename(`${rule} is wrong here`),
    hint: rename('put it right'),
    file: 0,
    line: 6,
    column: 23,
    endLine: 6,
    endColumn: 25,
    link: -1,
    joint: -1,
    where: rename('arm'),
    ...more,
  });
  const data = {
    format: 1,
    rigor: '0.1.0',
    name: rename('arm'),
    path: rename('arm/model.sdf'),
    live,
    totals: {
      links: 5,
      joints: 4,
      visuals: 5,
      collisions: 1,
      triangles: { visual: 60, collision: 12 },
      mass: 5,
      com: [0.8, 0, 0],
    },
    models: [{ name: rename('arm'), scoped: rename('arm'), parent: -1, line: 3, file: 0 }],
    links: [
      link('base', 0, -1),
      link('upper', 0, 0),
      link('fore', 1, 1),
      link('tip', 2, 2),
      link('tray', 0, 3),
    ],
    joints: [
      joint('shoulder', 0, 1, 0, turning),
      joint('elbow', 1, 2, 1, turning),
      joint('slider', 2, 3, 2, {
        direction: [1, 0, 0],
        slides: true,
        lower: 0,
        upper: 0.5,
        mimic: null,
      }),
      joint('lift', 0, 4, 0, {
        direction: [0, 0, 1],
        slides: true,
        lower: null,
        upper: null,
        mimic: { joint: 0, axis: 0, multiplier: 2, offset: 0.3, reference: 0.1 },
      }),
    ],
    bodies,
    meshes,
    textures: [],
    pictures: [
      {
        view: 'perspective',
        src: 'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==',
      },
    ],
    notDrawn: [{ name: rename('visual 9'), reason: rename('meshes/hand.dae is not found') }],
    findings: [
      finding('mass-negative', 'error', { link: 1 }),
      finding('limit-wide', 'warning', { joint: 1, line: 4, column: 5, endLine: 5, endColumn: 25 }),
      finding('inertial-missing', 'warning', {
        link: 0,
        line: 4,
        column: 5,
        endLine: 4,
        endColumn: 25,
      }),
      finding('name-long', 'info', {}),
    ],
    files: [{ path: rename('arm/model.sdf'), text: rename(sourceText) }],
  };
  change(data);
  return { data, bytes: bytes.base64() };
}
