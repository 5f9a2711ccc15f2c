// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What is drawn, and what the pointer finds in it.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Bytes, packMesh } from './format.mjs';
import { armFile, fileOf, onScreen, open, sceneShot, skip } from './fixture.mjs';
import { armPage } from './arm.mjs';

const LAYERS = ['visual', 'collision', 'inertia', 'com', 'frames', 'axes', 'contacts', 'ground'];

/** [red, green, blue] that the scene has at a place of the window. */
function colorAt(page, [x, y]) {
  return page.evaluate(
    ([left, top]) => {
      const canvas = document.querySelector('#scene canvas');
      const box = canvas.getBoundingClientRect();
      const copy = document.createElement('canvas').getContext('2d');
      rigor.render();
      copy.drawImage(canvas, box.left - left, box.top - top, box.width, box.height);
      return [...copy.getImageData(0, 0, 1, 1).data].slice(0, 3);
    },
    [x, y],
  );
}

test('every layer changes pixels, and its button brings it back', { skip }, async () => {
  const page = await open(armFile());
  await page.evaluate(() => rigor.show([]));
  const empty = await sceneShot(page);
  const seen = new Set([empty.toString('base64')]);
  for (const [i, layer] of LAYERS.entries()) {
    const button = page.locator('#layers button').nth(i);
    await button.click();
    assert.deepEqual(await page.evaluate(() => rigor.layers), [layer]);
    assert.equal(await button.getAttribute('aria-pressed'), 'true');
    const shown = (await sceneShot(page)).toString('base64');
    assert.ok(!seen.has(shown), `${layer} looks like another`);
    seen.add(shown);
    await button.click();
    assert.ok((await sceneShot(page)).equals(empty), `${layer} is still there`);
  }
});

test('joints move what is seen, and nothing is drawn when nothing changes', { skip }, async () => {
  const page = await open(armFile());
  const before = await sceneShot(page);
  await page.evaluate(() => rigor.setJoint('arm::elbow', 1));
  assert.ok(!(await sceneShot(page)).equals(before));
  const frames = await page.evaluate(async () => {
    const first = rigor.frames;
    for (let i = 0; i < 10; ++i) await new Promise(requestAnimationFrame);
    return rigor.frames - first;
  });
  assert.equal(frames, 0);
});

test(
  'a link is drawn, named and selected where the pinhole formula puts it',
  { skip },
  async () => {
    const page = await open(armFile());
    await page.evaluate(() => rigor.setJoint('arm::shoulder', 0.5));
    await page.evaluate(() => rigor.setJoint('arm::elbow', 0.8));
    const tip = [Math.cos(0.5) + 1.1 * Math.cos(1.3), Math.sin(0.5) + 1.1 * Math.sin(1.3), 0];
    const at = await onScreen(page, tip);
    const [red, green, blue] = await colorAt(page, at);
    assert.ok(
      green > 1.3 * red && green > 1.3 * blue,
      `the tip is green, not ${[red, green, blue]}`,
    );
    await page.mouse.move(...at);
    await page.locator('#hover').waitFor({ state: 'visible' });
    assert.match(await page.locator('#hover').textContent(), /arm::tip/);
    await page.mouse.down();
    await page.mouse.up();
    assert.deepEqual(await page.evaluate(() => rigor.selection), {
      kind: 'link',
      name: 'arm::tip',
    });
    const marked = await colorAt(
      page,
      await onScreen(
        page,
        tip.map((v, i) => v + [0.05, -0.05, 0.02][i]),
      ),
    );
    assert.ok(marked[2] > marked[1], `the selected tip is blue, not ${marked}`);
  },
);

test('turning the model selects nothing', { skip }, async () => {
  const page = await open(armFile());
  const before = await page.evaluate(() => rigor.camera);
  const [x, y] = await onScreen(page, [1, 0, 0]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 20, { steps: 4 });
  await page.mouse.up();
  assert.equal(await page.evaluate(() => rigor.selection), null);
  assert.notDeepEqual(await page.evaluate(() => rigor.camera), before);
});

test('keys turn to the views, and show layers', { skip }, async () => {
  const page = await open(armFile());
  const towards = async (key) => {
    await page.keyboard.press(key);
    const [ex, ey, ez, tx, ty, tz] = await page.evaluate(() => rigor.camera);
    const length = Math.hypot(ex - tx, ey - ty, ez - tz);
    return [ex - tx, ey - ty, ez - tz].map((v) => Math.round((1000 * v) / length) / 1000 + 0);
  };
  assert.deepEqual(await towards('1'), [1, 0, 0]);
  assert.deepEqual(await towards('2'), [0, 1, 0]);
  assert.deepEqual(await towards('3'), [0, 0, 1]);
  const length = Math.hypot(1, 0.62, 0.52);
  assert.deepEqual(
    await towards('4'),
    [1, 0.62, 0.52].map((v) => Math.round((1000 * v) / length) / 1000),
  );
  await page.keyboard.press('c');
  assert.ok((await page.evaluate(() => rigor.layers)).includes('collision'));
  await page.keyboard.press('/');
  await page.keyboard.type('c');
  assert.ok(
    (await page.evaluate(() => rigor.layers)).includes('collision'),
    'what is typed into a field is no key',
  );
  assert.equal(await page.locator('#search').inputValue(), 'c');
  await page.keyboard.press('Escape');
  await page.keyboard.press('?');
  assert.equal(await page.locator('#help').isVisible(), true);
});

test('a collision that lies on its visual is seen on all of it', { skip }, async () => {
  const page = await open(
    armFile({
      // Of another size in the plane that they share, so that their triangles are others.
      change: ({ bodies }) =>
        Object.assign(bodies[5], { link: 0, pose: bodies[0].pose, scale: [0.73, 0.4, 0.57] }),
    }),
  );
  await page.evaluate(() => rigor.show(['visual', 'collision']));
  const colors = new Set();
  for (let i = 0; i < 40; ++i) {
    const at = await onScreen(page, [-0.18 + 0.001 * i, 0.2, -0.35 + 0.007 * i]);
    const [red, green, blue] = await colorAt(page, at);
    assert.ok(red > 1.3 * green && green > 1.1 * blue, `orange, not ${[red, green, blue]}`);
    colors.add(String([red, green, blue].map((v) => Math.round(v / 16))));
  }
  assert.ok(colors.size <= 3, [...colors].join(' '));
});

test('surfaces: parts, textures, colors of vertices, normals', { skip }, async () => {
  const bytes = new Bytes();
  const square = (extra) =>
    packMesh(bytes, {
      positions: [
        [0, -1, -1],
        [0, 1, -1],
        [0, 1, 1],
        [0, -1, 1],
      ],
      triangles: [
        [0, 1, 2],
        [0, 2, 3],
      ],
      ...extra,
    });
  const plain = { normals: Array(4).fill([1, 0, 0]) };
  const meshes = [
    square({
      ...plain,
      parts: [
        { first: 0, count: 1 },
        { first: 1, count: 1 },
      ],
    }),
    square({
      ...plain,
      uvs: [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ],
    }),
    square({ ...plain, colors: Array(4).fill([0, 255, 0, 255]) }),
    square({}), // its normals are made by the page
  ];
  const white = { color: [1, 1, 1, 1], texture: -1 };
  const surfaces = [
    [
      { color: [1, 0, 0, 1], texture: -1 },
      { color: [0, 0, 1, 1], texture: -1 },
    ],
    [{ ...white, texture: 0 }],
    [white],
    [white],
  ];
  const { data } = armPage();
  // Two pixels: red above green; v is upward, so red is at the top.
  data.textures = [
    'data:image/svg+xml;base64,' +
      Buffer.from(
        '<svg xmlns="http://www.w3.org/2000/svg" width="2" height="2">' +
          '<rect width="2" height="1" fill="#f00"/><rect y="1" width="2" height="1" fill="#0f0"/></svg>',
      ).toString('base64'),
  ];
  data.meshes = meshes;
  data.bodies = meshes.map((_, i) => ({
    layer: 'visual',
    name: `square ${i}`,
    link: -1,
    joint: -1,
    mesh: i,
    pose: [0, 3 * i, 0, 1, 0, 0, 0],
    scale: i === 3 ? [1, -1, 1] : [1, 1, 1],
    surfaces: surfaces[i],
    line: 0,
    file: 0,
  }));
  const page = await open(fileOf({ data, bytes: bytes.base64() }));
  await page.keyboard.press('1');
  const at = async (y, z) => colorAt(page, await onScreen(page, [0, y, z]));
  const isMostly = ([r, g, b], channel) =>
    [r, g, b].every((v, i) => (i === channel ? v > 120 : v < 60));
  assert.ok(isMostly(await at(0.5, -0.5), 0), 'first part is red');
  assert.ok(isMostly(await at(-0.5, 0.5), 2), 'second part is blue');
  assert.ok(isMostly(await at(3, 0.5), 0), `the texture's top is red`);
  assert.ok(isMostly(await at(3, -0.5), 1), `the texture's bottom is green`);
  assert.ok(isMostly(await at(6, 0), 1), 'the vertices are green');
  const mirrored = await at(9, 0);
  assert.ok(
    mirrored.every((v) => v > 120 && v === mirrored[0]),
    `a mirrored square is lit like another, not ${mirrored}`,
  );
  assert.deepEqual(page.errors, []);
});
