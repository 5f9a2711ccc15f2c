// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// A line that says what just happened, and goes away.

import { byId } from './dom.js';

const SHOWN = 6000; // ms

let timer = null;

export function toast(text) {
  const box = byId('toast');
  clearTimeout(timer);
  box.replaceChildren(text);
  box.classList.add('shown');
  timer = setTimeout(() => box.classList.remove('shown'), SHOWN);
}

/** Of a model that was saved: sentences, and whether there are none. */
export function sayChanges({ changes, nothing }) {
  const none = nothing || changes.length === 0;
  toast(none ? 'Saved: nothing about the model changed' : changes.join('; '));
}
