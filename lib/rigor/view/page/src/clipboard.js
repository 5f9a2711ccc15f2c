// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Copies text, also where a page from a file may not use the clipboard's interface.

import { el } from './dom.js';

function copyByHand(text) {
  const area = el('textarea', { class: 'sr', readonly: true });
  area.value = text;
  document.body.append(area);
  area.select();
  const copied = document.execCommand('copy');
  area.remove();
  return copied;
}

/** Whether it is there now. */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyByHand(text);
  }
}
