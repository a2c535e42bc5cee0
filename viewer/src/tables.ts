// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h, section } from "./dom";
import type { Model, Quantity } from "./model";
import type { Item, Selection } from "./selection";
import { type Column, Table } from "./table";

function columnOf(quantity: Quantity, indices: number[]): Column[] {
  const { unit, values, names, interval, decimals } = quantity;
  const label = quantity.head ?? quantity.label;
  if (names) return [{ label, value: (row) => names[values[indices[row]!]!]?.text ?? "" }];
  const column: Column = { label, unit, decimals, value: (row) => values[indices[row]!]! };
  if (!interval) return [column];
  const end = (name: string, ends: Float64Array): Column => ({ label: name, unit, decimals, value: (row) => ends[indices[row]!]! });
  return [column, end("95 % from", interval.lower), end("to", interval.upper)];
}

function tableOf(model: Model, selection: Selection, of: Item["of"], indices: number[], own: Column[], caption: string, first: string): HTMLElement {
  const quantities = model.quantities.filter((q) => q.of === of && q.key !== "kind");
  const columns = [...own, ...quantities.flatMap((q) => columnOf(q, indices))];
  const places = new Map(indices.map((index, row) => [index, row]));
  const sorted = quantities.find((q) => q.key === first);
  const table = new Table({
    columns, caption, rowCount: indices.length, fileName: `${of}s.csv`,
    firstColumn: columns.findIndex((c) => c.label === (sorted?.head ?? sorted?.label)),
    onSelect: (row) => selection.select(row < 0 ? null : { of, index: indices[row]! }),
    onHover: (row) => selection.hover(row === null ? null : { of, index: indices[row]! }),
  });
  let marked: number | null = null;
  selection.subscribe(() => {
    const item = selection.selected;
    const row = item?.of === of ? (places.get(item.index) ?? null) : null;
    if (row !== marked) table.mark((marked = row));
  });
  return table.element;
}

/** Every number of the edges and nodes, sortable and for download. */
export function tablesSection(model: Model, selection: Selection, first: { edge: string; node: string }): HTMLElement {
  const edges = Array.from({ length: model.edgeCount }, (_, e) => e);
  const nodes = Array.from({ length: model.nodeCount }, (_, i) => i);
  const edgeColumns: Column[] = [
    { label: "edge", value: (row) => model.edgeId(row) },
    { label: "nodes", value: (row) => `${model.nodeId(model.ends[2 * row]!)} – ${model.nodeId(model.ends[2 * row + 1]!)}` },
    { label: "design length", unit: "m", decimals: 4, value: (row) => model.unstressed[row]! },
  ];
  const nodeColumns: Column[] = [
    { label: "node", value: (row) => model.nodeId(row) },
    { label: "kind", value: (row) => (model.isSupport[row] ? "support" : "free") },
    ...["x", "y", "z"].map((label, k): Column => ({ label, unit: "m", decimals: 4, value: (row) => model.form[3 * row + k]! })),
  ];
  return section("tables", "All edges and nodes",
    h("h3", {}, "Edges"), tableOf(model, selection, "edge", edges, edgeColumns, "All edges with their lengths", first.edge),
    h("h3", {}, "Nodes"), tableOf(model, selection, "node", nodes, nodeColumns, "All nodes with their positions", first.node));
}
