// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// A page that is served asks for the model again when the server says that a file changed.

import { readServer } from './data.js';
import { sayChanges, toast } from './toast.js';

/** `swap(page)` puts the new model in place of the old. */
export function reloadLive(swap) {
  const events = new EventSource('/events');
  let lost = false;
  // One after the other: an answer that overtakes another would bring the older model back.
  let last = Promise.resolve();
  const reload = async (changes) => {
    try {
      await swap(await readServer());
      sayChanges(changes);
    } catch (error) {
      toast(`The changed model could not be shown: ${error.message}`);
    }
  };
  events.addEventListener('changed', ({ data }) => {
    last = last.then(() => reload(JSON.parse(data)));
  });
  events.addEventListener('error', () => {
    if (!lost) toast('The server is gone. What is shown is what it last sent.');
    lost = true;
  });
  events.addEventListener('open', () => {
    if (lost) last = last.then(() => reload({ changes: ['The server is back'], nothing: false }));
    lost = false;
  });
}
