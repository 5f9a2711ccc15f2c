// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The program: the one of the setting `rigor.path`, else the one in the extension, else the one of PATH.

import { type ChildProcessWithoutNullStreams, spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

import * as vscode from 'vscode';

import { chosenProgram, environment } from './settings';

export class Program {
  constructor(private readonly extensionPath: string) {}

  /** A path, or a name that PATH leads to. */
  get path(): string {
    const chosen = chosenProgram();
    if (chosen) return chosen;
    const own = join(this.extensionPath, 'program', 'bin', 'rigor');
    return existsSync(own) ? own : 'rigor';
  }

  /** In the folder of the workspace that holds `file`, if there is one. */
  start(options: string[], file?: vscode.Uri): ChildProcessWithoutNullStreams {
    const folder = file && vscode.workspace.getWorkspaceFolder(file);
    const first = vscode.workspace.workspaceFolders?.[0];
    return spawn(this.path, options, { cwd: (folder ?? first)?.uri.fsPath, env: environment() });
  }

  /** As `start`, once it runs. Rejects when it cannot be started. */
  started(options: string[]): Promise<ChildProcessWithoutNullStreams> {
    return new Promise((resolve, reject) => {
      const child = this.start(options);
      child.once('error', reject).once('spawn', () => resolve(child));
    });
  }

  /** Until it ends. Rejects when it cannot be started. */
  run(options: string[], file?: vscode.Uri): Promise<{ code: number; out: string; err: string }> {
    return new Promise((resolve, reject) => {
      const child = this.start(options, file);
      let out = '';
      let err = '';
      child.stdout.setEncoding('utf8').on('data', (text) => (out += text));
      child.stderr.setEncoding('utf8').on('data', (text) => (err += text));
      child.on('error', reject);
      child.on('close', (code) => resolve({ code: code ?? 3, out, err }));
    });
  }
}
