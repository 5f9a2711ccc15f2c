// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// A large model written by hand: the page's size, and its time until it is drawn (printed: it depends on
// the machine).

import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { armPage } from './arm.mjs';
import { roughBall } from './ball.mjs';
import { fileOf, open, skip } from './fixture.mjs';
import { Bytes, packMesh } from './format.mjs';

test('100,000 triangles on 20 links', { skip }, async (t) => {
  const bytes = new Bytes();
  const { data } = armPage();
  const [body] = data.bodies;
  data.links = Array.from({ length: 20 }, (_, i) => ({
    ...data.links[0],
    name: `link ${i}`,
    scoped: `arm::link ${i}`,
  }));
  data.joints = [];
  data.findings = [];
  data.meshes = data.links.map((_, i) => packMesh(bytes, roughBall(50, 50, i)));
  data.bodies = data.links.map((_, i) => ({
    ...body,
    link: i,
    mesh: i,
    pose: [0.25 * (i % 5), 0.25 * Math.floor(i / 5), 0.1, 1, 0, 0, 0],
    scale: [1, 1, 1],
  }));
  const address = fileOf({ data, bytes: bytes.base64() });
  assert.equal(
    data.meshes.reduce((sum, { triangles }) => sum + triangles, 0),
    100_000,
  );
  const size = statSync(fileURLToPath(address)).size;
  assert.ok(size <= 3_000_000, `${size} bytes`);
  const page = await open(address);
  const ready = await page.evaluate(() => performance.getEntriesByName('rigor-ready')[0].startTime);
  t.diagnostic(`${(size / 1e6).toFixed(2)} MB, ready after ${(ready / 1000).toFixed(2)} s`);
  assert.deepEqual(page.errors, []);
});
