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
  private readonly showListeners: ((item: Item) => void)[] = [];

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

  /** Selects an item where it may be out of sight. */
  show(item: Item): void {
    this.select(item);
    for (const listener of this.showListeners) listener(item);
  }

  /** Calls back when an item is to be brought into sight. */
  onShow(listener: (item: Item) => void): void {
    this.showListeners.push(listener);
  }

  private notify(): void {
    for (const listener of this.listeners) listener();
  }
}
