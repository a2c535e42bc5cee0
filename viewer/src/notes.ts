// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import type { Result } from "./result";

/** What is written on a report by hand. */
export interface Notes {
  project?: string;
  engineer?: string;
  /** Change of length as made of each turn of the plan [m]; null where it was not made. */
  strokes?: (number | null)[];
}

const mostStrokes = 100_000;

/** Whether this is what a notebook may hold. */
export function isNotes(value: unknown): value is Notes {
  if (typeof value !== "object" || value === null) return false;
  const { project, engineer, strokes } = value as Record<string, unknown>;
  const isText = (text: unknown): boolean => text === undefined || (typeof text === "string" && text.length <= 200);
  return isText(project) && isText(engineer) &&
    (strokes === undefined || (Array.isArray(strokes) && strokes.length <= mostStrokes && strokes.every((stroke) => stroke === null || Number.isFinite(stroke))));
}

/** Names a result in the browser's memory: results that differ have other notes. */
export function keyOf(result: Result): string {
  let hash = 0;
  for (const letter of JSON.stringify("turns" in result ? result.turns : null)) hash = (Math.imul(hash, 31) + letter.codePointAt(0)!) >>> 0;
  return `taut-notes/${result.format}/${result.net.fingerprint ?? ""}/${result.date ?? ""}/${hash}`;
}

/** The page of a report with these notes in it. */
export function withNotes(page: string, notes: Notes): string {
  const place = '<script type="application/json" id="result">';
  return page.replace(place, () => `<script type="application/json" id="notes">${JSON.stringify(notes).replaceAll("<", "\\u003c")}</script>\n${place}`);
}

/** Notes of one result: kept by the browser under `key`, and by the page that shows the report in a frame. */
export class Notebook {
  notes: Notes = {};
  /** Whether the page around this one has asked for notes: any page may show a report. */
  private isHeard = false;
  private readonly listeners: (() => void)[] = [];

  constructor(private readonly key: string) {
    try {
      this.take(JSON.parse(document.getElementById("notes")?.textContent ?? "null"));
      this.take(JSON.parse(localStorage.getItem(key) ?? "null"));
    } catch {
      // A browser may keep nothing for this page.
    }
    if (parent === window) return;
    addEventListener("message", ({ source, data }: MessageEvent<{ taut?: unknown; notes?: unknown } | null>) => {
      if (source !== parent || data?.taut !== "notes") return;
      this.isHeard = true;
      this.take(data.notes);
    });
    parent.postMessage({ taut: "ready" }, "*");
  }

  /** Calls back now and after each change. */
  subscribe(listener: () => void): void {
    this.listeners.push(listener);
    listener();
  }

  change(change: Notes): void {
    this.notes = { ...this.notes, ...change };
    if (this.isHeard) parent.postMessage({ taut: "notes", notes: this.notes }, "*");
    try {
      localStorage.setItem(this.key, JSON.stringify(this.notes));
    } catch {
      // Then they last as long as the page.
    }
    this.notify();
  }

  /** Fields for project and engineer. */
  fields(): HTMLElement {
    return h("div", { class: "record" }, ...(["project", "engineer"] as const).map((key) => {
      const input = h("input", { type: "text", maxlength: 200, autocomplete: "off", onchange: () => this.change({ [key]: input.value.trim() }) });
      this.subscribe(() => { if (document.activeElement !== input) input.value = this.notes[key] ?? ""; });
      return h("label", {}, key === "project" ? "Project" : "Engineer", " ", input);
    }));
  }

  private take(notes: unknown): void {
    if (!isNotes(notes)) return;
    this.notes = notes;
    this.notify();
  }

  private notify(): void {
    for (const listener of this.listeners) listener();
  }
}
