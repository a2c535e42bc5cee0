// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "../src/dom";
import { Cancelled, type RunOptions } from "./program";

const changedSince = "Settings have changed since.";

/** A piece of work: its button, its progress, how it is cancelled, and what the program said. */
export class Work implements RunOptions {
  readonly element: HTMLElement;
  signal: AbortSignal = new AbortController().signal;

  private readonly button: HTMLButtonElement;
  private readonly cancel: HTMLButtonElement;
  private readonly status = h("p", { class: "status", role: "status" });
  private readonly commands = h("pre", { class: "commands" });
  private readonly output = h("pre", { class: "output" });
  private readonly details = h("details", { hidden: true }, h("summary", {}, "What the program said"), this.commands, this.output);
  private controller = new AbortController();

  /** @param work gives its outcome in words */
  constructor(name: string, private readonly work: (work: Work) => Promise<string>) {
    this.button = h("button", { type: "button", class: "do", id: `do-${name.toLowerCase().replace(/ .*/, "")}`, onclick: () => void this.start() }, name);
    this.cancel = h("button", { type: "button", hidden: true, onclick: () => this.controller.abort() }, "Cancel");
    this.element = h("div", { class: "work" }, h("div", { class: "buttons" }, this.button, this.cancel), this.status, this.details);
  }

  /** Shows at once what the program said. */
  expand(): void {
    this.details.open = true;
  }

  /** Does the work; a run of it that has not ended is cancelled. */
  async start(): Promise<void> {
    this.clear();
    const controller = this.controller;
    this.signal = controller.signal;
    this.show("running", "Working …");
    const begin = performance.now();
    try {
      const outcome = await this.work(this);
      if (controller === this.controller) this.show("done", `Done in ${((performance.now() - begin) / 1e3).toFixed(1)} s. ${outcome}`);
    } catch (error) {
      if (controller !== this.controller) return;
      this.show("failed", error instanceof Cancelled ? "Cancelled." : error instanceof Error ? error.message : String(error));
    }
  }

  /** What is known of work that was done before. */
  showOutcome(outcome: string): void {
    this.show("done", outcome);
  }

  /** Whether what was done was done with other settings than those of now. */
  markStale(isStale: boolean): void {
    if (this.element.dataset.state === "running") return;
    const line = (this.status.textContent ?? "").replace(` ${changedSince}`, "");
    this.status.textContent = isStale ? `${line} ${changedSince}` : line;
  }

  /** Forgets what was done. */
  clear(): void {
    this.controller.abort();
    this.controller = new AbortController();
    this.commands.textContent = this.output.textContent = "";
    this.details.hidden = true;
    this.show("", "");
  }

  readonly onProgress = (line: string): void => {
    this.status.textContent = line;
  };

  showCommand(line: string): void {
    this.details.hidden = false;
    this.commands.textContent += `${line}\n`;
  }

  /** Warnings and notes come first: what taut assumed is among them. */
  showOutput(out: string, err: string): void {
    this.output.textContent += [err, out].filter(Boolean).join("\n");
  }

  private show(state: string, line: string): void {
    this.element.dataset.state = state;
    this.status.textContent = line;
    this.button.disabled = state === "running";
    this.cancel.hidden = state !== "running";
  }
}
