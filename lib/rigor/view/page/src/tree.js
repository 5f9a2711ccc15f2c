// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Models, links and joints as a tree: a joint stands above the link that it moves.

import { byId, counted, el } from './dom.js';
import { LISTS } from './state.js';

const DEEPEST = 10; // steps of indentation; a chain of thirty links would leave the panel

/** Rows {kind, index, depth} in the order of the tree. */
export function rowsOf({ models, links, joints }) {
  const rows = [];
  const done = new Set();
  const placed = new Set();

  const addJoint = (index, depth) => {
    rows.push({ kind: 'joint', index, depth });
    placed.add(index);
  };
  const addLink = (index, depth) => {
    if (done.has(index)) return;
    done.add(index);
    rows.push({ kind: 'link', index, depth });
    joints.forEach((joint, i) => {
      if (joint.parent !== index || placed.has(i)) return;
      addJoint(i, depth + 1);
      const moves =
        links[joint.child]?.movedBy === i && links[joint.child].model === links[index].model;
      if (moves) addLink(joint.child, depth + 1);
    });
  };
  const addModel = (index, depth) => {
    rows.push({ kind: 'model', index, depth });
    const own = links.flatMap((link, i) => (link.model === index ? [i] : []));
    for (const link of own) {
      const { movedBy } = links[link];
      const parent = joints[movedBy]?.parent ?? -1;
      if (links[parent]?.model === index) continue; // comes with its parent
      if (movedBy >= 0 && parent < 0 && !placed.has(movedBy)) addJoint(movedBy, depth + 1);
      addLink(link, depth + 1);
    }
    for (const link of own) addLink(link, depth + 1); // of a loop
    joints.forEach((joint, i) => {
      if (joint.model === index && !placed.has(i)) addJoint(i, depth + 1);
    });
    models.forEach((model, i) => model.parent === index && addModel(i, depth + 1));
  };
  models.forEach((model, i) => model.parent < 0 && addModel(i, 0));
  links.forEach((_, i) => addLink(i, 0)); // that are in no model
  return rows;
}

export function showTree(state) {
  const list = byId('tree');
  const search = byId('search');
  const none = byId('search-none');
  let rows = [];

  const mark = () => {
    for (const { kind, index, button } of rows) {
      const selected = state.isSelected(kind, index);
      button.setAttribute('aria-current', selected);
      if (selected) button.scrollIntoView({ block: 'nearest' });
    }
  };

  const filter = () => {
    const wanted = search.value.trim().toLowerCase();
    let found = 0;
    for (const { item, text } of rows) {
      item.hidden = !text.includes(wanted);
      found += item.hidden ? 0 : 1;
    }
    none.hidden = found > 0 || rows.length === 0;
    list.classList.toggle('flat', wanted !== '');
  };

  const build = () => {
    rows = rowsOf(state.data).map(({ kind, index, depth }) => {
      const { name, scoped, type } = state.data[LISTS[kind]][index];
      const button = el(
        'button',
        { type: 'button', title: `${kind} ${scoped}`, click: () => state.select(kind, index) },
        el('span', { class: `kind ${kind}`, 'aria-hidden': true }),
        el('span', { class: 'sr' }, `${kind} `),
        el('span', { class: 'name' }, name || scoped),
        type ? el('span', { class: 'type' }, type) : null,
      );
      const item = el('li', {}, button);
      item.style.setProperty('--depth', Math.min(depth, DEEPEST));
      return { kind, index, button, item, text: scoped.toLowerCase() };
    });
    list.replaceChildren(...rows.map(({ item }) => item));
    const { links, joints } = state.data;
    byId('tree-count').replaceChildren(
      `${counted(links.length, 'link')}, ${counted(joints.length, 'joint')}`,
    );
    filter();
    mark();
  };

  list.addEventListener('keydown', (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    const shown = rows.filter(({ item }) => !item.hidden).map(({ button }) => button);
    shown[shown.indexOf(document.activeElement) + step]?.focus();
    event.preventDefault();
  });
  search.addEventListener('input', filter);
  search.addEventListener('keydown', (event) => {
    const first = rows.find(
      ({ item, kind }) => !item.hidden && (kind !== 'model' || search.value === ''),
    );
    if (event.key === 'Enter' && first) state.select(first.kind, first.index);
  });
  state.on('model', build);
  state.on('selection', mark);
}
