// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

/** An edge or a node of the net. */
export interface Item {
  of: "edge" | "node";
  index: number;
}

export const same = (a: Item | null, b: Item | null): boolean => a?.of === b?.of && a?.index === b?.index;

/** The selected and the hovered item, shared by the view, the charts and the tables. */
export class Selection {
  selected: Item | null = null;
  hovered: Item | null = null;
  private readonly listeners: (() => void)[] = [];

  /** Calls back after each change. */
  subscribe(listener: () => void): void {
    this.listeners.push(listener);
  }

  select(item: Item | null): void {
    if (same(item, this.selected)) return;
    this.selected = item;
    this.notify();
  }

  hover(item: Item | null): void {
    if (same(item, this.hovered)) return;
    this.hovered = item;
    this.notify();
  }

  private notify(): void {
    for (const listener of this.listeners) listener();
  }
}
