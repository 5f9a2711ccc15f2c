// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// `rigor view --serve` of one model. It is asked from here, not from the panel: the server admits no page but its own,
// and the editor may be on another machine than the model.

import type { ChildProcess } from 'node:child_process';
import { type ClientRequest, get } from 'node:http';

import type * as vscode from 'vscode';

import type { Program } from './program';

/** Of the page: the model (a JSON text) after a change, and what changed. */
export interface Change {
  page: string;
  changes: string;
}

function body(address: string): Promise<string> {
  return new Promise((resolve, reject) => {
    get(address, (response) => {
      let text = '';
      response.setEncoding('utf8').on('data', (part) => (text += part));
      response.on('end', () => resolve(text));
      response.on('error', reject);
    }).on('error', reject);
  });
}

export class PageServer {
  private constructor(
    private readonly child: ChildProcess,
    private readonly address: string,
  ) {}

  /** Rejects with what the program says when there is nothing to show. */
  static start(program: Program, model: vscode.Uri): Promise<PageServer> {
    return new Promise((resolve, reject) => {
      const child = program.start(['view', '--serve', model.fsPath, '--color', 'never'], model);
      let out = '';
      let err = '';
      child.stdout.setEncoding('utf8').on('data', (text) => {
        if (out.includes(' ; ')) return;
        out += text;
        const address = out.match(/ is at (http:\S+) ;/)?.[1];
        if (address) resolve(new PageServer(child, address));
      });
      child.stderr.setEncoding('utf8').on('data', (text) => (err += text));
      child.on('error', reject);
      child.on('close', () => reject(new Error(err.trim() || 'rigor view has ended')));
    });
  }

  page(): Promise<string> {
    return body(this.address);
  }

  /** Tells `listener` of each change, until the server is stopped. */
  listen(listener: (change: Change) => void): void {
    let unread = '';
    // One after the other, so that an answer does not overtake another.
    let last = Promise.resolve();
    const take = (event: string) => {
      const changes = event.match(/^event: changed\ndata: (.*)$/m)?.[1];
      if (!changes) return;
      last = last
        .then(async () => listener({ page: await body(new URL('data', this.address).href), changes }))
        .catch(() => undefined); // of a server that was stopped meanwhile
    };
    const request: ClientRequest = get(new URL('events', this.address), (response) => {
      response.setEncoding('utf8').on('data', (text) => {
        const events = (unread + text).split('\n\n');
        unread = events.pop() ?? '';
        events.forEach(take);
      });
    });
    request.on('error', () => undefined);
    this.child.on('close', () => request.destroy());
  }

  onEnd(listener: () => void): void {
    this.child.on('close', listener);
  }

  stop(): void {
    this.child.kill('SIGINT');
  }
}
