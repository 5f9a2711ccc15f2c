// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// One key for what is done often. Their list is the help that `?` shows.

import { byId, el } from './dom.js';
import { LAYERS } from './state.js';
import { frameSelection } from './toolbar.js';

export function listenToKeys(state, stage, toggleTheme) {
  const help = byId('help');
  const tools = [
    ['f', 'Fit the selection, or all', () => frameSelection(state, stage)],
    ['1', 'From the front', () => stage?.frame('front')],
    ['2', 'From the side', () => stage?.frame('side')],
    ['3', 'From the top', () => stage?.frame('top')],
    ['4', 'In perspective', () => stage?.frame('perspective')],
    ...LAYERS.map(({ name, label, what, key }) => [
      key,
      `Show or hide: ${(what ?? label).toLowerCase()}`,
      () => {
        if (state.data.bodies.some((body) => body.layer === name)) state.toggleLayer(name);
      },
    ]),
    ['0', 'All joints to zero', () => state.resetJoints()],
    ['s', 'Show or hide the source', () => byId('source-toggle').click()],
    ['l', 'Light or dark', toggleTheme],
    [
      '/',
      'Search links and joints',
      () => {
        document.body.dataset.tab = 'tree';
        byId('search').focus();
        byId('search').select();
      },
    ],
    ['?', 'This list', () => help.showModal()],
  ];
  const byKey = new Map(tools.map(([key, , run]) => [key, run]));
  byId('keys').replaceChildren(
    ...[...tools, ['Esc', 'Select nothing; leave a field']].flatMap(([key, what]) => [
      el('dt', {}, el('kbd', {}, key)),
      el('dd', {}, what),
    ]),
  );
  byId('help-open').addEventListener('click', () => help.showModal());

  document.addEventListener('keydown', (event) => {
    if (help.open || event.ctrlKey || event.metaKey || event.altKey) return;
    const isTyped = event.target.matches('input:not([type=range]), select, textarea');
    if (event.key === 'Escape') {
      if (isTyped) event.target.blur();
      else state.clear();
      return;
    }
    const run = isTyped ? null : byKey.get(event.key);
    if (!run) return;
    event.preventDefault();
    run();
  });
}
