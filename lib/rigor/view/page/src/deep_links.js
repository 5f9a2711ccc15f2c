// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The part of the address after #: what to show at once, and how to show it to somebody else.
//
//   #link=arm::hand   #joint=elbow&q.elbow=0.4   #finding=3   #show=visual,com

import { indexOfName } from './state.js';
import { rangeOf } from './sliders.js';

function apply(state, hash) {
  const { data } = state;
  const said = new URLSearchParams(hash.replace(/^#/, ''));
  for (const [key, value] of said) {
    if (!key.startsWith('q.')) continue;
    const joint = indexOfName(data.joints, key.slice(2));
    data.joints[joint]?.axes.forEach((axis, k) => {
      const q = Number.parseFloat(value.split(',')[k]);
      const [low, high] = rangeOf(axis);
      if (Number.isFinite(q)) state.setJoint(joint, k, Math.max(low, Math.min(high, q)));
    });
  }
  if (said.has('show')) state.setLayers(said.get('show').split(','));
  if (said.has('link')) state.select('link', indexOfName(data.links, said.get('link')));
  else if (said.has('joint')) state.select('joint', indexOfName(data.joints, said.get('joint')));
  if (said.has('finding')) state.selectFinding(Number.parseInt(said.get('finding'), 10));
}

/** "#link=hand&q.elbow=0.4" */
export function hashOf(state) {
  const { data, selection, finding, layers, kinematics } = state;
  const said = new URLSearchParams();
  if (finding >= 0) said.set('finding', finding);
  else if (selection && selection.kind !== 'model')
    said.set(selection.kind, state.selected().scoped);
  data.joints.forEach(({ scoped, axes }, joint) => {
    const values = axes.map((axis, k) => (axis.mimic ? 0 : kinematics.values[joint][k]));
    if (values.some((q) => q !== 0))
      said.set(`q.${scoped}`, values.map((q) => Number(q.toFixed(6))).join(','));
  });
  const shown = [...layers].sort().join(',');
  if (shown !== 'ground,visual') said.set('show', shown);
  // Both are plain in a fragment, and a link is read by people.
  return said.size > 0 ? `#${said}`.replaceAll('%3A', ':').replaceAll('%2C', ',') : '';
}

export function linkDeeply(state) {
  let timer = null;
  const write = () => {
    // Not for every step of a slider: browsers refuse a page that writes its address too often.
    clearTimeout(timer);
    timer = setTimeout(() => {
      const hash = hashOf(state);
      if (hash !== location.hash)
        history.replaceState(null, '', hash || location.pathname + location.search);
    }, 250);
  };
  const read = () => apply(state, location.hash);
  addEventListener('hashchange', read);
  read();
  state.on('selection finding layers positions', write);
}
