// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Compiles MJCF files, with the assets beside them, in the newest MuJoCo that npm has: a line each.
//
//   node load.mjs FOLDER/scene.xml...

import fs from 'node:fs';
import path from 'node:path';
import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco({ print: () => {}, printErr: () => {} });
let failed = 0;

function copy(folder, to) {
  mujoco.FS.mkdir(to);
  for (const entry of fs.readdirSync(folder, { withFileTypes: true })) {
    const from = path.join(folder, entry.name);
    if (entry.isDirectory()) copy(from, `${to}/${entry.name}`);
    else if (/\.(xml|stl|obj|png)$/.test(entry.name)) mujoco.FS.writeFile(`${to}/${entry.name}`, fs.readFileSync(from));
  }
}

function remove(folder) {
  for (const name of mujoco.FS.readdir(folder)) {
    if (name === '.' || name === '..') continue;
    const inside = `${folder}/${name}`;
    if (mujoco.FS.isDir(mujoco.FS.stat(inside).mode)) remove(inside);
    else mujoco.FS.unlink(inside);
  }
  mujoco.FS.rmdir(folder);
}

process.argv.slice(2).forEach((file, i) => {
  const folder = `/robot${i}`;
  copy(path.dirname(file), folder);
  try {
    const model = mujoco.MjModel.from_xml_path(`${folder}/${path.basename(file)}`);
    if (!model) throw new Error('rejected');
    console.log(`ok\t${file}\t${model.nbody} bodies, ${model.nv} degrees, ${model.nu} actuators`);
    model.delete();
  } catch (error) {
    const text = typeof error === 'number' && mujoco.getExceptionMessage ? mujoco.getExceptionMessage(error) : error;
    console.log(`rejected\t${file}\t${String(text?.message ?? text).replace(/\s+/g, ' ')}`);
    ++failed;
  }
  remove(folder);
});
process.exit(failed ? 1 : 0);
