// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the newest MuJoCo compiles of MJCF files, one JSON object a line, for mjcf_mujoco_judge.cc: bodies, joints,
// geoms and where they are at twenty positions.
//
//   npm install @mujoco/mujoco
//   find FOLDER -name '*.xml' | split -l 40 - part_
//   for part in part_*; do node mujoco_dump.mjs FOLDER < $part; done > dump.jsonl
//
// In parts, since its memory is not given back.

import fs from 'node:fs';
import path from 'node:path';

const mj = await (await import('@mujoco/mujoco')).default({print: () => {}, printErr: () => {}});

function mirror(folder) {
  mj.FS.mkdirTree(folder);
  for (const entry of fs.readdirSync(folder, {withFileTypes: true})) {
    const inside = path.join(folder, entry.name);
    if (entry.isDirectory()) mirror(inside);
    else if (entry.isFile()) mj.FS.writeFile(inside, fs.readFileSync(inside));
  }
}

function names(model, addresses) {
  return Array.from(addresses, (address) => {
    let name = '';
    for (let i = address; model.names[i]; ++i) {
      const c = model.names[i];
      name += typeof c === 'string' ? c : String.fromCharCode(c);
    }
    return name;
  });
}

// The same positions for everyone.
let seed = 12345;
function random() {
  seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
  return (seed >>> 8) / 16777216 * 2 - 1;
}

function dump(file) {
  const list = (values) => Array.from(values);
  const m = mj.MjModel.from_xml_path(file);
  if (!m) return {file, error: 'out of memory'};
  const d = new mj.MjData(m);
  const out = {
    file,
    body: {name: names(m, m.name_bodyadr), mass: list(m.body_mass), ipos: list(m.body_ipos),
           iquat: list(m.body_iquat), inertia: list(m.body_inertia)},
    joint: {name: names(m, m.name_jntadr), type: list(m.jnt_type), range: list(m.jnt_range),
            stiffness: list(m.jnt_stiffness).slice(0, m.njnt), dof: list(m.jnt_dofadr),
            qadr: list(m.jnt_qposadr)},
    dof: {damping: list(m.dof_damping).slice(0, m.nv), frictionloss: list(m.dof_frictionloss)},
    geom: {type: list(m.geom_type), body: list(m.geom_bodyid), size: list(m.geom_size)},
    qpos: [], xpos: [], xquat: [], gpos: [], gmat: [],
  };
  const start = list(m.qpos0);
  seed = 12345;
  for (let k = 0; k < 20; ++k) {
    start.forEach((value, i) => { d.qpos[i] = value; });
    for (let j = 0; k > 0 && j < m.njnt; ++j) {
      if (m.jnt_type[j] >= 2) d.qpos[m.jnt_qposadr[j]] = random();
    }
    mj.mj_kinematics(m, d);
    out.qpos.push(list(d.qpos));
    out.xpos.push(list(d.xpos));
    out.xquat.push(list(d.xquat));
    out.gpos.push(list(d.geom_xpos));
    out.gmat.push(list(d.geom_xmat));
  }
  d.delete();
  m.delete();
  return out;
}

const files = fs.readFileSync(0, 'utf8').split('\n').filter(Boolean);
mirror(process.argv[2]);
for (const file of files) {
  let line;
  try {
    line = dump(file);
  } catch (error) {
    line = {file, error: String(error?.message ?? error)};
  }
  console.log(JSON.stringify(line));
}
