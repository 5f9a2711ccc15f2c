// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What is selected, in numbers to read and to copy.

import { copy } from './clipboard.js';
import { byId, el } from './dom.js';
import { compose, inverse, numberText, poseText, sixNumbers } from './pose.js';
import { toast } from './toast.js';

const short = (value) =>
  Number.isFinite(value) ? String(Number(value.toPrecision(6))) : 'not known';
const vector = (values) =>
  values ? values.map((v) => numberText(Number(v.toPrecision(6)))).join('  ') : 'not known';

function row(label, ...value) {
  return [el('dt', {}, label), el('dd', {}, ...value)];
}

/** `text()` at the time of the click: joints move. */
function copyButton(label, text, onCopy) {
  return el(
    'button',
    {
      type: 'button',
      class: 'copy',
      click: async () => {
        const copied = text();
        onCopy(copied);
        toast(
          (await copy(copied))
            ? `Copied ${copied.length < 80 ? copied : label}`
            : 'The browser did not let the page copy',
        );
      },
    },
    label,
  );
}

function inertiaTable([ixx, ixy, ixz, iyy, iyz, izz]) {
  const line = (...values) => el('tr', {}, ...values.map((v) => el('td', {}, short(v))));
  return el(
    'table',
    { class: 'matrix' },
    el('tbody', {}, line(ixx, ixy, ixz), line(ixy, iyy, iyz), line(ixz, iyz, izz)),
  );
}

export function showSelection(state, scenePose) {
  const panel = byId('selection');
  let poses = []; // [{shown: element, now: () => pose}], which change as joints move
  const onCopy = (text) => {
    state.copied = text;
  };

  const poseRows = (label, now) => {
    if (!now()) return row(label, 'not known');
    const shown = el('span', { class: 'numbers' });
    poses.push({ shown, now });
    return row(
      label,
      shown,
      copyButton('Copy <pose>', () => poseText(now()), onCopy),
    );
  };

  const source = ({ file, line }) => {
    const from = state.data.files[file];
    if (!from || !(line > 0)) return [];
    return row(
      'Source',
      el(
        'button',
        {
          type: 'button',
          class: 'link',
          click: () => state.showSource({ file, line }),
        },
        `${from.path}:${line}`,
      ),
    );
  };

  const linkButton = (index) => {
    const link = state.data.links[index];
    if (!link) return 'world';
    return el(
      'button',
      { type: 'button', class: 'link', click: () => state.select('link', index) },
      link.name,
    );
  };

  const jointButton = (index) =>
    el(
      'button',
      { type: 'button', class: 'link', click: () => state.select('joint', index) },
      state.data.joints[index].name,
    );

  const aboutLink = (link, index) => {
    const parent = state.data.joints[link.movedBy]?.parent ?? -1;
    const relative = () => {
      const [above, own] = [scenePose(parent), scenePose(index)];
      return above && own && compose(inverse(above), own);
    };
    return [
      ...poseRows('Pose in the world', () => scenePose(index)),
      ...(parent >= 0 ? poseRows(`Pose in ${state.data.links[parent].name}`, relative) : []),
      ...(link.movedBy >= 0 ? row('Moved by', jointButton(link.movedBy)) : []),
      ...row('Mass', link.mass === null ? 'not known' : `${short(link.mass)} kg`),
      ...row(
        'Centre of mass',
        el('span', { class: 'numbers' }, `${vector(link.com)}${link.com ? ' m' : ''}`),
      ),
      ...row(
        'Inertia, kg m²',
        link.inertia ? inertiaTable(link.inertia) : 'not known',
        link.inertialText ? copyButton('Copy <inertial>', () => link.inertialText, onCopy) : '',
      ),
      ...source(link),
    ];
  };

  const axisText = ({ direction, slides, lower, upper, mimic }) => {
    const unit = slides ? 'm' : 'rad';
    const limits =
      lower === null && upper === null
        ? 'without limits'
        : `from ${lower === null ? '−∞' : short(lower)} to ${upper === null ? '∞' : short(upper)} ${unit}`;
    const leader = state.data.joints[mimic?.joint];
    return (
      `${slides ? 'slides along' : 'turns about'} ${vector(direction)}, ${limits}` +
      (leader
        ? `; follows ${leader.name} × ${short(mimic.multiplier)} + ${short(mimic.offset)}`
        : '')
    );
  };

  const aboutJoint = (joint) => [
    ...row('Type', joint.type),
    ...row('Parent', linkButton(joint.parent)),
    ...row('Child', linkButton(joint.child)),
    ...joint.axes.flatMap((axis, k) =>
      row(joint.axes.length > 1 ? `Axis ${k + 1}` : 'Axis', axisText(axis)),
    ),
    ...source(joint),
  ];

  const aboutModel = (model, index) => [
    ...row('Links', String(state.data.links.filter((link) => link.model === index).length)),
    ...row('Joints', String(state.data.joints.filter((joint) => joint.model === index).length)),
    ...source(model),
  ];

  const aboutAll = () => {
    const { totals, rigor, path } = state.data;
    const triangles = totals.triangles;
    return [
      ...row('File', path),
      ...row('Links', short(totals.links)),
      ...row('Joints', short(totals.joints)),
      ...row(
        'Visuals',
        `${short(totals.visuals)}, ${triangles.visual.toLocaleString('en')} triangles`,
      ),
      ...row(
        'Collisions',
        `${short(totals.collisions)}, ${triangles.collision.toLocaleString('en')} triangles`,
      ),
      ...row('Mass', totals.mass === null ? 'not known' : `${short(totals.mass)} kg`),
      ...row(
        'Centre of mass',
        el('span', { class: 'numbers' }, `${vector(totals.com)}${totals.com ? ' m' : ''}`),
      ),
      ...row('Made by', `rigor ${rigor}`),
    ];
  };

  const refresh = () => {
    for (const { shown, now } of poses) {
      const [x, y, z, ...turn] = sixNumbers(now()).map((v) => numberText(Number(v.toFixed(6))));
      shown.replaceChildren(
        el('span', {}, [x, y, z].join('  ')),
        ' ',
        el('span', {}, turn.join('  ')),
      );
    }
  };

  const build = () => {
    poses = [];
    const chosen = state.selected();
    const { kind, index } = state.selection ?? { kind: 'all' };
    const rows = { link: aboutLink, joint: aboutJoint, model: aboutModel, all: aboutAll }[kind](
      chosen,
      index,
    );
    const title = chosen ? chosen.scoped || chosen.name : state.data.name;
    panel.replaceChildren(
      el(
        'h3',
        {},
        el('span', { class: `kind ${kind}`, 'aria-hidden': true }),
        el('span', {}, title),
      ),
      el(
        'p',
        { class: 'muted' },
        kind === 'all' ? 'Whole file. Click a part of it to read its numbers.' : kind,
      ),
      el('dl', {}, ...rows),
    );
    refresh();
  };

  state.on('model selection', build);
  state.on('positions', refresh);
}
