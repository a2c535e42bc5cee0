// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Reports in frames of their own, which can reach neither the page nor anything else, and what is written on them.

import { h } from "../src/dom";
import { isNotes, type Notes } from "../src/notes";
import { text } from "./job";
import { Cancelled, run } from "./program";

interface Report {
  frame: HTMLIFrameElement;
  /** Which of the notes are its own. */
  keys: (keyof Notes)[];
}

export class Frames {
  private reports: Report[] = [];

  /** @param changed called with what was written on a report */
  constructor(private readonly notes: () => Notes, private readonly changed: (change: Notes) => void) {
    addEventListener("message", (event) => this.hear(event));
  }

  /**
   * Shows the report of a result.
   * @return its page
   * @throws Error with the program's message, Cancelled after signal.abort()
   */
  async show(into: HTMLElement, name: string, result: Uint8Array, keys: (keyof Notes)[], signal: AbortSignal): Promise<Uint8Array> {
    const { code, err, files } = await run(["report", name, "-o", "report.html"], { [name]: result }, { signal });
    if (signal.aborted) throw new Cancelled();
    const page = files["report.html"];
    if (code !== 0 || !page) throw new Error(err);
    const frame = h("iframe", { srcdoc: text(page), sandbox: "allow-scripts allow-downloads allow-modals", title: `Report of ${name}` });
    this.reports = this.reports.filter((report) => report.frame.isConnected);
    this.reports.push({ frame, keys });
    into.replaceChildren(frame);
    return page;
  }

  /** Prints the lists of a report for the crews. */
  print(into: HTMLElement): void {
    this.reports.find(({ frame }) => into.contains(frame))?.frame.contentWindow?.postMessage({ taut: "print" }, "*");
  }

  private hear({ source, data }: MessageEvent<{ taut?: unknown; notes?: unknown } | null>): void {
    const report = this.reports.find(({ frame }) => frame.contentWindow === source);
    if (!report) return;
    if (data?.taut === "notes" && isNotes(data.notes)) {
      this.changed(this.own(data.notes, report));
      for (const other of this.reports) if (other !== report) this.send(other);
    } else if (data?.taut === "ready") {
      this.send(report);
    }
  }

  private send(report: Report): void {
    report.frame.contentWindow?.postMessage({ taut: "notes", notes: this.own(this.notes(), report) }, "*");
  }

  private own(notes: Notes, { keys }: Report): Notes {
    return Object.fromEntries(keys.flatMap((key) => (notes[key] === undefined ? [] : [[key, notes[key]]]))) as Notes;
  }
}
