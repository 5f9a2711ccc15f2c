// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Commands of rigor as tasks, whose findings become problems: `{"type": "rigor", "command": "validate"}`.

import * as vscode from 'vscode';

import { modelAsked, saved } from './documents';
import type { Program } from './program';
import { environment } from './settings';

interface RigorTask extends vscode.TaskDefinition {
  command: string;
  paths?: string[];
  options?: string[];
}

const TESTS = [
  ['settle', 'stands still on the ground'],
  ['drop', 'falls from a height'],
  ['drive', 'drives forward'],
  ['turn', 'turns on the spot'],
  ['brake', 'stops from full speed'],
  ['push', 'is pushed from the side'],
  ['joint-sweep', 'moves each joint through its range'],
  ['hold', 'holds its pose'],
  ['tilt-table', 'stands on a plane that tilts'],
];

/** The exit code of a command that did what it was asked to, and has findings. */
const FINDINGS = 1;

/** Of the task's process, once it ended. */
async function exitCode(task: vscode.Task): Promise<number | undefined> {
  const started = await vscode.tasks.executeTask(task);
  return new Promise((resolve) => {
    const listener = vscode.tasks.onDidEndTaskProcess(({ execution, exitCode: code }) => {
      if (execution !== started) return;
      listener.dispose();
      resolve(code);
    });
  });
}

export function offerTasks(program: Program): vscode.Disposable {
  const make = (definition: RigorTask, scope: vscode.WorkspaceFolder | vscode.TaskScope) => {
    const { command, paths = [], options = [] } = definition;
    // Findings on lines of their own are what the problem matcher reads.
    const format = command === 'validate' ? ['--format', 'concise'] : [];
    const process = new vscode.ProcessExecution(
      program.path,
      [command, ...paths, ...format, ...options],
      { env: environment() as Record<string, string> },
    );
    const name = [command, ...paths.map((path) => path.split('/').at(-1))].join(' ');
    const task = new vscode.Task(definition, scope, name, 'rigor', process, '$rigor');
    // What validate finds is in the list of problems, which a task that is only silent covers with its terminal once
    // it ends with findings; of the others the output is the result.
    const { Always, Never } = vscode.TaskRevealKind;
    task.presentationOptions = { reveal: command === 'validate' ? Never : Always, clear: true };
    return task;
  };
  const provider: vscode.TaskProvider = {
    provideTasks: () =>
      (vscode.workspace.workspaceFolders ?? []).map((folder) => {
        const task = make({ type: 'rigor', command: 'validate' }, folder);
        task.group = vscode.TaskGroup.Test;
        return task;
      }),
    // What is executed has to have the definition that was asked for.
    resolveTask: (task) =>
      make(task.definition as RigorTask, task.scope as vscode.TaskScope.Workspace),
  };
  const validate = async () => {
    const tasks = await vscode.tasks.fetchTasks({ type: 'rigor' });
    const codes = await Promise.all(tasks.map(exitCode));
    const failed = codes.some((code) => code === undefined || code > FINDINGS);
    const shown = failed ? 'workbench.action.terminal.focus' : 'workbench.panel.markers.view.focus';
    await vscode.commands.executeCommand(shown);
  };
  const simulate = async (asked?: unknown) => {
    const model = modelAsked(asked);
    if (!model) return;
    const chosen = await vscode.window.showQuickPick(
      TESTS.map(([label, description]) => ({ label, description, picked: label === 'settle' })),
      { canPickMany: true, title: 'Tests to simulate' },
    );
    if (!chosen?.length) return;
    await saved(model);
    const options = ['--test', chosen.map(({ label }) => label).join(',')];
    // A task runs in the folder of the workspace that it is of.
    const folder = vscode.workspace.getWorkspaceFolder(model);
    const path = folder ? vscode.workspace.asRelativePath(model, false) : model.fsPath;
    const definition = { type: 'rigor', command: 'simulate', paths: [path], options };
    await vscode.tasks.executeTask(make(definition, folder ?? vscode.TaskScope.Workspace));
  };
  return vscode.Disposable.from(
    vscode.tasks.registerTaskProvider('rigor', provider),
    vscode.commands.registerCommand('rigor.validateWorkspace', validate),
    vscode.commands.registerCommand('rigor.simulate', simulate),
  );
}
