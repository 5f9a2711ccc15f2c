// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Pages that the program makes, judged by `rigor inspect` and by npm's urdf-loader.
//
// RIGOR_BINARY: the program. RIGOR_CORPUS: a folder of real models, of which some are tried too.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { roughBall, stlOf } from './ball.mjs';
import { browserOf, open, skip as noBrowser, temporaryFile } from './fixture.mjs';
import { urdfLoader } from './urdf_loader.mjs';

const testdata = resolve(dirname(fileURLToPath(import.meta.url)), '../../testdata');
const program = process.env.RIGOR_BINARY;
const corpus = process.env.RIGOR_CORPUS;
const skip = noBrowser || (program ? false : 'RIGOR_BINARY is not set');

const MODELS = [
  'models/my_robot',
  'frames/models/old14',
  'frames/models/old16',
  'sane/arm.sdf',
  'sane/crane',
  'sane/drone.sdf',
  'sane/gripper.sdf',
  'sane/hauler.urdf',
  'sane/quadruped.sdf',
  'sane/walker.urdf',
  'sane/welder.urdf',
];
const CORPUS_MODELS = [
  'SO-ARM100/Simulation/SO101/so101_new_calib.urdf',
  'urdf_tutorial/urdf/06-flexible.urdf',
  'urdf_tutorial/urdf/07-physics.urdf',
];
const CLOSE = 1e-5; // m

function rigor(...args) {
  return execFileSync(program, args, {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    stdio: ['ignore', 'pipe', 'ignore'],
  });
}

function inspect(model, ...args) {
  return JSON.parse(rigor('inspect', model, '--format', 'json', '--isolated', ...args)).models[0];
}

/** Three joints that lead, each somewhere within its limits, and with them those that follow: {name: position}. */
function chosenPositions(joints) {
  const leading = joints.filter(
    ({ type, axes }) => type !== 'fixed' && axes.length === 1 && !axes[0].mimic,
  );
  const chosen = [...new Set([leading[0], leading[leading.length >> 1], leading.at(-1)])].filter(
    Boolean,
  );
  const set = Object.fromEntries(
    chosen.map(({ name, type, axes: [{ lower, upper }] }, i) => {
      const isFree = type === 'continuous' || !(upper?.value - lower?.value < 100);
      return [
        name,
        isFree
          ? [0.7, -0.4, 1.1][i]
          : lower.value + [0.3, 0.6, 0.85][i] * (upper.value - lower.value),
      ];
    }),
  );
  const following = Object.fromEntries(
    joints
      .filter(({ axes }) => axes[0]?.mimic?.joint in set)
      .map(({ name, axes: [{ mimic }] }) => [
        name,
        mimic.multiplier * (set[mimic.joint] - (mimic.reference ?? 0)) + mimic.offset,
      ]),
  );
  return { set, following };
}

/** The columns of a rotation's matrix. */
function columns([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/** `p`, given in the frame of a pose {translation, quaternion_wxyz}, in the file's frame; and the other way. */
function fromFrame({ translation, quaternion_wxyz: q }, p) {
  const [a, b, c] = columns(q);
  return translation.map((v, i) => v + a[i] * p[0] + b[i] * p[1] + c[i] * p[2]);
}
function toFrame({ translation, quaternion_wxyz: q }, p) {
  return columns(q).map((axis) => axis.reduce((sum, v, i) => sum + v * (p[i] - translation[i]), 0));
}

function assertNear(actual, expected, what) {
  const far = Math.max(...actual.map((v, i) => Math.abs(v - expected[i])));
  assert.ok(far <= CLOSE, `${what}: ${actual}, not ${expected}`);
}

async function compare(model) {
  const html = temporaryFile(`${basename(model)}.html`);
  rigor('view', model, '-o', html);
  const still = inspect(model);
  const { set, following } = chosenPositions(still.joints);
  const said = Object.entries({ ...set, ...following }).map(([name, q]) => [
    '--joint',
    `${name}=${q}`,
  ]);
  const moved = inspect(model, ...said.flat());

  const page = await open(pathToFileURL(html).href, { offline: true });
  const scoped = (name) => still.joints.find((joint) => joint.name === name).scoped_name;
  await page.evaluate(
    (positions) => positions.forEach(([name, q]) => rigor.setJoint(name, q)),
    Object.entries(set).map(([name, q]) => [scoped(name), q]),
  );
  const poses = await page.evaluate(
    (names) => names.map((name) => rigor.linkPose(name)),
    moved.links.map(({ scoped_name: name }) => name),
  );

  let urdf;
  if (model.endsWith('.urdf')) {
    urdf = readFileSync(model, 'utf8');
  } else {
    const converted = temporaryFile(`${basename(model)}.urdf`);
    rigor('sdf2urdf', model, '--allow-loss', '--fail-on', 'never', '-o', converted);
    urdf = readFileSync(converted, 'utf8');
  }
  const place = await loader();
  const loaded = await place(urdf, set);
  const loadedStill = await place(urdf, {});
  // urdf-loader's poses are those in the root link, which SDF may place elsewhere; a `world` stands at zero.
  const rootOf = ({ links }) =>
    links.find(({ name }) => name === loaded.root)?.pose ?? {
      translation: [0, 0, 0],
      quaternion_wxyz: [1, 0, 0, 0],
    };

  let moving = 0;
  moved.links.forEach(({ name, pose }, i) => {
    const seen = { translation: poses[i].slice(0, 3), quaternion_wxyz: poses[i].slice(3) };
    assertNear(seen.translation, pose.translation, `${name} against inspect`);
    const turn = pose.quaternion_wxyz.reduce((sum, v, k) => sum + v * seen.quaternion_wxyz[k], 0);
    assert.ok(Math.abs(turn) > 1 - 1e-9, `${name} is turned otherwise than inspect says`);
    // A link of URDF has its origin in its joint, and one of SDF need not: the point of the link that is its origin in
    // the URDF, with all joints at zero, is followed.
    const before = still.links[i].pose;
    const origin = toFrame(before, fromFrame(rootOf(still), loadedStill.links[name]));
    if (model.endsWith('.urdf'))
      assertNear(origin, [0, 0, 0], `${name} at zero against urdf-loader`);
    assertNear(
      fromFrame(seen, origin),
      fromFrame(rootOf(moved), loaded.links[name]),
      `${name} against urdf-loader`,
    );
    const values = [...before.translation, ...before.quaternion_wxyz];
    moving += values.some((v, k) => Math.abs(v - poses[i][k]) > 1e-3) ? 1 : 0;
  });
  if (Object.keys(set).length > 0) assert.ok(moving > 0, 'the joints move something');
  assert.deepEqual(
    page.requests.filter((url) => !/^(file|data|blob):/.test(url)),
    [],
  );
  assert.deepEqual(page.errors, []);
  await page.context().close();
}

let loading = null;
const loader = () => (loading ??= browserOf(true).then(urdfLoader));

for (const model of MODELS) {
  test(`links of ${model}`, { skip }, () => compare(join(testdata, model)));
}
for (const model of CORPUS_MODELS) {
  test(`links of ${model}`, { skip: skip || (corpus ? false : 'RIGOR_CORPUS is not set') }, () =>
    compare(join(corpus, model)),
  );
}

test('100,000 triangles of meshes on 20 links', { skip }, async (t) => {
  const folder = temporaryFile('large');
  mkdirSync(folder);
  const names = Array.from({ length: 20 }, (_, i) => `l${i}`);
  names.forEach((name, i) =>
    writeFileSync(join(folder, `${name}.stl`), stlOf(roughBall(50, 50, i))),
  );
  writeFileSync(
    join(folder, 'large.urdf'),
    `<robot name="large">${names
      .map(
        (name, i) => `
    <link name="${name}"><visual><geometry><mesh filename="${name}.stl"/></geometry></visual></link>${
      i === 0
        ? ''
        : `
    <joint name="j${i}" type="continuous"><origin xyz="0.25 0 0"/><parent link="l${i - 1}"/><child link="${name}"/><axis xyz="0 0 1"/></joint>`
    }`,
      )
      .join('')}
  </robot>`,
  );
  const html = temporaryFile('large.html');
  rigor('view', join(folder, 'large.urdf'), '-o', html);
  const { size } = statSync(html);
  const page = await open(pathToFileURL(html).href);
  const ready = await page.evaluate(() => performance.getEntriesByName('rigor-ready')[0].startTime);
  t.diagnostic(`${(size / 1e6).toFixed(2)} MB, ready after ${(ready / 1000).toFixed(2)} s`);
  assert.ok(size <= 3_000_000, `${size} bytes`);
});
