// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Starts the server, and registers what the protocol has no words for.

import * as vscode from 'vscode';

import { makeClient } from './client';
import { convertModels } from './convert';
import { showExpansions } from './expanded';
import { explainRules } from './explain';
import { Program } from './program';
import { restartsServer } from './settings';
import { offerTasks } from './tasks';
import { viewModels } from './view_panel';

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const program = new Program(context.extensionPath);
  const client = makeClient(program);
  const restart = () => client.restart();
  context.subscriptions.push(
    client,
    showExpansions(client),
    explainRules(client),
    viewModels(program, context.extensionUri),
    offerTasks(program),
    convertModels(program, client.outputChannel),
    vscode.commands.registerCommand('rigor.restart', restart),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (restartsServer(change)) void restart();
    }),
  );
  try {
    await client.start();
  } catch (error) {
    const answer = await vscode.window.showErrorMessage(
      `${program.path} could not be started as a language server: ${(error as Error).message}`,
      'Open Settings',
    );
    if (answer) await vscode.commands.executeCommand('workbench.action.openSettings', 'rigor.path');
  }
}
