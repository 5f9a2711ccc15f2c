// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Where there is no WebGL: the pictures that rigor has drawn, and a sentence that says so.

import { byId, el } from './dom.js';

export function showPictures({ pictures }) {
  const box = byId('fallback');
  box.hidden = false;
  box.replaceChildren(
    el(
      'p',
      {},
      pictures.length > 0
        ? 'This browser has no WebGL, so the model is shown in pictures, with all joints at zero. All else on this page works.'
        : 'This browser has no WebGL, and the page holds no pictures. All else on it works.',
    ),
    ...pictures.map(({ view, src }) =>
      el('figure', {}, el('img', { src, alt: `The model, ${view}` }), el('figcaption', {}, view)),
    ),
  );
}
