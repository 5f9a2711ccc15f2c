// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The settings `rigor.*`, as programs take them.

import { homedir } from 'node:os';

import * as vscode from 'vscode';

function setting<T>(name: string, otherwise: T): T {
  return vscode.workspace.getConfiguration('rigor').get(name) ?? otherwise;
}

/** With `~` and `${workspaceFolder}` replaced. */
function expanded(path: string): string {
  const folder = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath ?? '';
  return path.replace(/^~(?=\/|$)/, homedir()).replaceAll('${workspaceFolder}', folder);
}

/** The program that the user chose; empty for none. */
export function chosenProgram(): string {
  return expanded(setting('path', '').trim());
}

export function serverArguments(): string[] {
  return setting<string[]>('serverArguments', []);
}

export function followsCursor(): boolean {
  return setting('view.followCursor', true);
}

/** The editor's environment, with the folders of the settings before those of its variables. */
export function environment(): NodeJS.ProcessEnv {
  const variables = { ...process.env };
  const prepend = (name: string, folders: string[]) => {
    const all = folders.map(expanded);
    if (variables[name]) all.push(variables[name]);
    if (all.length > 0) variables[name] = all.join(':');
  };
  prepend('ROS_PACKAGE_PATH', setting<string[]>('packagePath', []));
  prepend('GZ_SIM_RESOURCE_PATH', setting<string[]>('modelPath', []));
  return variables;
}

/** Whether a program that runs has to be started anew. */
export function restartsServer(change: vscode.ConfigurationChangeEvent): boolean {
  return ['path', 'serverArguments', 'packagePath', 'modelPath'].some((name) =>
    change.affectsConfiguration(`rigor.${name}`),
  );
}
