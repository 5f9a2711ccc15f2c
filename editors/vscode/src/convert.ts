// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// A model in another format, with what is lost on the way.

import * as vscode from 'vscode';

import { modelAsked, saved } from './documents';
import type { Program } from './program';

/** By the format that the model is in: the format it becomes, and the command. */
const CONVERSIONS: Record<string, { extension: string; command: string }> = {
  sdf: { extension: 'urdf', command: 'sdf2urdf' },
  world: { extension: 'urdf', command: 'sdf2urdf' },
  urdf: { extension: 'sdf', command: 'urdf2sdf' },
};

/** "sdf" of "robot.sdf" and "robot.sdf.xacro"; a plain template is a URDF. */
function formatOf(path: string): string {
  const extension = path.replace(/\.xacro$/, '').match(/\.(\w+)$/)?.[1] ?? '';
  return path.endsWith('.xacro') && !(extension in CONVERSIONS) ? 'urdf' : extension;
}

export function convertModels(
  program: Program,
  channel: vscode.OutputChannel,
): vscode.Disposable {
  const convert = async (asked?: unknown) => {
    const model = modelAsked(asked);
    if (!model) return;
    const conversion = CONVERSIONS[formatOf(model.path)];
    if (!conversion) {
      void vscode.window.showInformationMessage('SDF and URDF can be converted to each other.');
      return;
    }
    const { extension, command } = conversion;
    const base = model.path.replace(/(\.\w+)?(\.xacro)?$/, '');
    const target = await vscode.window.showSaveDialog({
      title: `Convert to ${extension.toUpperCase()}`,
      defaultUri: model.with({ path: `${base}.${extension}` }),
      filters: { [extension.toUpperCase()]: [extension] },
    });
    if (!target) return;
    await saved(model);
    const run = (options: string[]) =>
      program.run([command, model.fsPath, '-o', target.fsPath, '--color', 'never', ...options], model);
    let result = await run([]);
    channel.append(result.err + result.out);
    if (result.code === 1) {
      channel.show(true);
      const answer = await vscode.window.showWarningMessage(
        `${extension.toUpperCase()} cannot hold all of this model. What is lost is listed in the output.`,
        'Convert with Loss',
      );
      if (!answer) return;
      result = await run(['--allow-loss', '--fail-on', 'never']);
    }
    if (result.code > 1) throw new Error(result.err);
    await vscode.window.showTextDocument(target, { viewColumn: vscode.ViewColumn.Beside });
  };
  return vscode.commands.registerCommand('rigor.convert', convert);
}
