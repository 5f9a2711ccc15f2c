// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Dark or light: as the system has it, until the reader chooses.

import { byId } from './dom.js';

const system = matchMedia('(prefers-color-scheme: dark)');

export function isDark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === 'dark' : system.matches;
}

/** `onChange` is called when the colours are others now. */
export function switchTheme(onChange) {
  const toggle = () => {
    document.documentElement.dataset.theme = isDark() ? 'light' : 'dark';
    onChange();
  };
  byId('theme').addEventListener('click', toggle);
  system.addEventListener('change', onChange);
  return toggle;
}
