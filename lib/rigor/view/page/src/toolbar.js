// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What is over the scene: layers, views, and what could not be drawn.

import { byId, counted, el } from './dom.js';
import { LAYERS } from './state.js';

const VIEW_LABELS = { perspective: 'Perspective', front: 'Front', side: 'Side', top: 'Top' };

export function showToolbar(state, stage) {
  const chips = LAYERS.map(({ name, label, what, key }) => {
    const button = el(
      'button',
      {
        type: 'button',
        class: 'chip',
        title: `${what ?? label} (${key})`,
        click: () => state.toggleLayer(name),
      },
      el('span', { class: `swatch ${name}`, 'aria-hidden': true }),
      label,
    );
    return { name, button };
  });
  byId('layers').replaceChildren(...chips.map(({ button }) => button));
  const views = byId('views');
  views.replaceChildren(
    ...Object.entries(VIEW_LABELS).map(([view, label]) =>
      el('button', { type: 'button', class: 'chip', click: () => stage?.frame(view) }, label),
    ),
    el(
      'button',
      {
        type: 'button',
        class: 'chip',
        title: 'Fit the selection, or all (f)',
        click: () => frameSelection(state, stage),
      },
      'Fit',
    ),
  );
  views.hidden = !stage;
  byId('layers').hidden = !stage;

  const update = () => {
    for (const { name, button } of chips) {
      button.disabled = !state.data.bodies.some((body) => body.layer === name);
      button.setAttribute('aria-pressed', state.layers.has(name) && !button.disabled);
    }
  };
  state.on('layers', update);
  state.on('model', () => {
    update();
    const { notDrawn } = state.data;
    byId('not-drawn').hidden = notDrawn.length === 0;
    byId('not-drawn').replaceChildren(
      el('summary', {}, `${counted(notDrawn.length, 'shape')} not drawn`),
      el(
        'ul',
        {},
        ...notDrawn.map(({ name, reason }) => el('li', {}, el('b', {}, name), ` ${reason}`)),
      ),
    );
  });
}

export function frameSelection(state, stage) {
  const { kind, index } = state.selection ?? {};
  const links = { link: index, joint: state.data.joints[index]?.child };
  stage?.frame(null, links[kind] ?? -1);
}
