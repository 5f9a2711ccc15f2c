// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Where the links are, against closed forms of the arm in arm.mjs.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { armFile, open, skip } from './fixture.mjs';

function near(actual, expected, what) {
  actual.forEach((value, i) =>
    assert.ok(Math.abs(value - expected[i]) < 1e-9, `${what}: ${actual}, not ${expected}`),
  );
}

const aboutZ = (angle) => [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)];
const linkPose = (page, name) => page.evaluate((link) => rigor.linkPose(link), `arm::${name}`);
const move = (page, name, value) =>
  page.evaluate(([joint, q]) => rigor.setJoint(joint, q), [`arm::${name}`, value]);

for (const webgl of [true, false]) {
  test(
    `links are where the closed forms say, ${webgl ? 'in the scene' : 'without WebGL'}`,
    { skip },
    async () => {
      const page = await open(armFile(), { webgl });
      for (const [a, b, s] of [
        [0, 0, 0],
        [0.7, -1.1, 0.3],
        [-2, 2, 0.5],
        [1.5707963, 0.2, 0.01],
      ]) {
        await move(page, 'shoulder', a);
        await move(page, 'elbow', b);
        await move(page, 'slider', s);
        near(await linkPose(page, 'base'), [0, 0, 0, 1, 0, 0, 0], 'base');
        near(await linkPose(page, 'upper'), [0, 0, 0, ...aboutZ(a)], 'upper');
        near(await linkPose(page, 'fore'), [Math.cos(a), Math.sin(a), 0, ...aboutZ(a + b)], 'fore');
        const reach = 1 + s;
        near(
          await linkPose(page, 'tip'),
          [
            Math.cos(a) + reach * Math.cos(a + b),
            Math.sin(a) + reach * Math.sin(a + b),
            0,
            ...aboutZ(a + b),
          ],
          'tip',
        );
        near(await linkPose(page, 'tray'), [0, 0, 2 * (a - 0.1) + 0.3, 1, 0, 0, 0], 'tray');
      }
    },
  );
}

test('a loop of joints and a circle of mimics end', { skip }, async () => {
  const page = await open(
    armFile({
      change: ({ links, joints }) => {
        joints[0].parent = 3; // shoulder hangs on the tip, which it moves
        joints[0].axes[0].mimic = { joint: 3, axis: 0, multiplier: 1, offset: 0, reference: 0 };
        links[0].movedBy = -1;
      },
    }),
  );
  await move(page, 'elbow', 0.5);
  near(await linkPose(page, 'tip'), [2, 0, 0, 1, 0, 0, 0], 'tip'); // no tree to move along
  assert.equal(Number.isFinite((await linkPose(page, 'tray'))[2]), true);
});

test('two axes turn one after the other', { skip }, async () => {
  const page = await open(
    armFile({
      change: ({ joints }) => {
        joints[0].type = 'universal';
        joints[0].axes.push({ ...joints[0].axes[0], direction: [0, 1, 0] });
      },
    }),
  );
  await page.evaluate(() => rigor.setJoint('arm::shoulder', Math.PI / 2, 0));
  await page.evaluate(() => rigor.setJoint('arm::shoulder', Math.PI / 2, 1));
  // About y x goes to -z, which the turn about z leaves.
  near((await linkPose(page, 'fore')).slice(0, 3), [0, 0, -1], 'fore');
});

test('sliders hold the limits, and mimics follow', { skip }, async () => {
  const page = await open(armFile());
  const number = (name) =>
    page.getByLabel(`arm::${name}, ${name === 'shoulder' ? 'rad' : 'm'}, as a number`);
  await number('shoulder').fill('0.6');
  near((await linkPose(page, 'fore')).slice(0, 2), [Math.cos(0.6), Math.sin(0.6)], 'fore');
  assert.equal(await number('lift').inputValue(), '1.3');
  assert.equal(await number('lift').isDisabled(), true);
  await number('slider').fill('7');
  assert.equal(await page.evaluate(() => rigor.jointPosition('arm::slider')), 0.5);
  await page.getByLabel('arm::elbow, rad', { exact: true }).fill('-1.5');
  assert.equal(await page.evaluate(() => rigor.jointPosition('arm::elbow')), -1.5);
  await page.getByRole('button', { name: 'Reset' }).click();
  near(await linkPose(page, 'tip'), [2, 0, 0, 1, 0, 0, 0], 'tip');
});
