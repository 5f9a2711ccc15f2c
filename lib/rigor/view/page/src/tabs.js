// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// On a narrow window one panel is shown at a time.

import { byId } from './dom.js';

export function switchTabs(state) {
  const buttons = [...byId('tabs').querySelectorAll('button')];
  const show = (tab) => {
    document.body.dataset.tab = tab;
    for (const button of buttons) button.setAttribute('aria-pressed', button.value === tab);
    if (tab === 'source' && byId('source').hidden) byId('source-toggle').click();
  };
  for (const button of buttons) button.addEventListener('click', () => show(button.value));
  state.on('source', () => show(document.body.dataset.tab === 'findings' ? 'findings' : 'source'));
  show('tree');
}
