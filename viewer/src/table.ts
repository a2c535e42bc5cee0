// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { csvOf, download } from "./csv";
import { h } from "./dom";
import { fixed, number } from "./format";

export interface Column {
  label: string;
  unit?: string;
  /** A cell's content: a number, which is sorted as one, or text. */
  value(row: number): number | string;
  decimals?: number;
}

interface Options {
  columns: Column[];
  rowCount: number;
  caption: string;
  fileName: string;
  /** Sorted by it at first, the largest magnitude on top. */
  firstColumn?: number;
  onSelect?(row: number): void;
  onHover?(row: number | null): void;
}

const rowHeight = 27;
/** Rows drawn above and below the visible ones. */
const margin = 12;
const printedRows = 3000;

/** A table that can be sorted and filtered, of any length: only the rows that are seen exist. */
export class Table {
  readonly element: HTMLElement;
  private rows: number[];
  private sortColumn: number;
  private descending = true;
  private filter = "";
  private selected: number | null = null;
  private readonly body = h("tbody");
  private readonly heads: HTMLElement[] = [];
  private readonly scroller: HTMLElement;
  private readonly status = h("span", { class: "quiet", role: "status" });
  private printing = false;

  constructor(private readonly options: Options) {
    const { columns, rowCount, caption } = options;
    this.rows = Array.from({ length: rowCount }, (_, i) => i);
    this.sortColumn = options.firstColumn ?? -1;
    const head = h("tr");
    columns.forEach((column, i) => {
      const button = h("button", { type: "button", onclick: () => this.sortBy(i) }, column.label, column.unit ? h("small", {}, ` [${column.unit}]`) : null);
      this.heads.push(h("th", { scope: "col", class: rowCount > 0 && typeof column.value(0) === "string" ? "text" : "" }, button));
      head.append(this.heads[i]!);
    });
    const table = h("table", { "aria-rowcount": rowCount + 1 }, h("caption", { class: "hidden" }, caption), h("thead", {}, head), this.body);
    this.scroller = h("div", { class: "rows", tabindex: 0, role: "region", "aria-label": caption }, table);
    this.scroller.addEventListener("scroll", () => this.draw());
    this.scroller.addEventListener("keydown", (event) => this.key(event));
    this.body.addEventListener("click", (event) => this.options.onSelect?.(this.rowOf(event) ?? -1));
    this.body.addEventListener("pointerover", (event) => this.options.onHover?.(this.rowOf(event)));
    this.body.addEventListener("pointerleave", () => this.options.onHover?.(null));
    const search = h("input", { type: "search", placeholder: "filter, e.g. slack or >2", "aria-label": `Filter: ${caption}` });
    search.addEventListener("input", () => {
      this.filter = search.value.trim().toLowerCase();
      this.arrange();
    });
    const csv = h("button", { type: "button", class: "csv", onclick: () => download(options.fileName, this.csv()) }, "Download CSV");
    this.element = h("div", { class: "table" }, h("div", { class: "tools no-print" }, search, csv, this.status), this.scroller);
    addEventListener("beforeprint", () => this.print(true));
    addEventListener("afterprint", () => this.print(false));
    this.arrange();
  }

  /** Marks a row, and brings it into sight. */
  mark(row: number | null): void {
    this.selected = row;
    const place = row === null ? -1 : this.rows.indexOf(row);
    if (place >= 0) {
      const top = place * rowHeight;
      const { scrollTop, clientHeight } = this.scroller;
      if (top < scrollTop || top + 2 * rowHeight > scrollTop + clientHeight) this.scroller.scrollTop = Math.max(0, top - clientHeight / 2);
    }
    this.draw();
  }

  /** The rows shown, in their order, with all digits. */
  csv(): string {
    const { columns } = this.options;
    return csvOf(columns.map((c) => (c.unit ? `${c.label} [${c.unit}]` : c.label)), this.rows.map((row) => columns.map((c) => c.value(row))));
  }

  private sortBy(column: number): void {
    this.descending = column === this.sortColumn ? !this.descending : typeof this.options.columns[column]!.value(0) === "number";
    this.sortColumn = column;
    this.arrange();
  }

  /** Filters and sorts. */
  private arrange(): void {
    const { columns, rowCount } = this.options;
    const all = Array.from({ length: rowCount }, (_, i) => i);
    this.rows = this.filter ? all.filter((row) => this.matches(row)) : all;
    const column = columns[this.sortColumn];
    if (column) this.rows.sort(this.order(column));
    this.heads.forEach((head, i) => {
      if (i === this.sortColumn) head.setAttribute("aria-sort", this.descending ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
    this.status.textContent = this.rows.length === rowCount ? `${rowCount} rows` : `${this.rows.length} of ${rowCount} rows`;
    this.scroller.scrollTop = 0;
    this.draw();
  }

  /** Descending numbers by magnitude: the largest deviation on top. Rows without a number come last. */
  private order(column: Column): (a: number, b: number) => number {
    const sign = this.descending ? -1 : 1;
    return (a, b) => {
      const [x, y] = [column.value(a), column.value(b)];
      if (typeof x === "string" || typeof y === "string") return sign * String(x).localeCompare(String(y), "en", { numeric: true }) || a - b;
      if (Number.isNaN(x) || Number.isNaN(y)) return Number(Number.isNaN(x)) - Number(Number.isNaN(y)) || a - b;
      return sign * (this.descending ? Math.abs(x) - Math.abs(y) : x - y) || a - b;
    };
  }

  /** "slack": some text contains it; ">2", "<-1": compares the number in the sorted column, ">" its magnitude. */
  private matches(row: number): boolean {
    const { columns } = this.options;
    const bound = /^([<>])\s*([-−+]?[\d.]+)$/.exec(this.filter);
    if (bound) {
      const value = columns[this.sortColumn]?.value(row);
      const limit = Number(bound[2]!.replace("−", "-"));
      return typeof value === "number" && (bound[1] === ">" ? Math.abs(value) > limit : value < limit);
    }
    return columns.some((column) => {
      const value = column.value(row);
      return typeof value === "string" && value.toLowerCase().includes(this.filter);
    });
  }

  private draw(): void {
    const { scrollTop, clientHeight } = this.scroller;
    const first = this.printing ? 0 : Math.max(0, Math.floor(scrollTop / rowHeight) - margin);
    const last = this.printing ? Math.min(printedRows, this.rows.length) : Math.min(this.rows.length, Math.ceil((scrollTop + (clientHeight || 400)) / rowHeight) + margin);
    const space = (count: number): HTMLElement => {
      const row = h("tr", { "aria-hidden": "true" });
      row.style.height = `${count * rowHeight}px`;
      return row;
    };
    const drawn = [];
    for (let i = first; i < last; ++i) drawn.push(this.row(this.rows[i]!, i));
    const after = this.rows.length - last;
    this.body.replaceChildren(...(first > 0 ? [space(first)] : []), ...drawn, ...(after > 0 && !this.printing ? [space(after)] : []));
    if (this.printing && after > 0) {
      this.body.append(h("tr", {}, h("td", { colspan: this.options.columns.length }, `… and ${after} more rows, in this order; the CSV file has all of them.`)));
    }
  }

  private row(row: number, place: number): HTMLElement {
    const cells = this.options.columns.map((column) => {
      const value = column.value(row);
      if (typeof value === "string") return h("td", { class: "text" }, value);
      return h("td", {}, column.decimals === undefined ? number(value) : fixed(value, column.decimals));
    });
    const marked = row === this.selected;
    return h("tr", { "data-row": row, "aria-rowindex": place + 2, "aria-selected": marked ? "true" : undefined }, ...cells);
  }

  private rowOf(event: Event): number | null {
    const row = (event.target as Element).closest<HTMLElement>("tr[data-row]");
    return row ? Number(row.dataset.row) : null;
  }

  /** The arrows go from row to row. */
  private key(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step || this.rows.length === 0) return;
    const place = this.selected === null ? -1 : this.rows.indexOf(this.selected);
    const next = Math.min(Math.max(place + step, 0), this.rows.length - 1);
    this.options.onSelect?.(this.rows[next]!);
    event.preventDefault();
  }

  private print(printing: boolean): void {
    this.printing = printing;
    this.draw();
  }
}
