// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

/** A cell, as src/files/csv_field.hpp writes it: text that a spreadsheet would run as a formula gets a leading apostrophe. */
function cell(value: number | string): string {
  if (typeof value === "number") return Number.isFinite(value) ? String(value) : "";
  const safe = /^'*[=+\-@\t\r]/.test(value) && !Number.isFinite(Number(value)) ? `'${value}` : value;
  return /[",;\s]|^#|^$/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

/** Comma separated values (RFC 4180). */
export function csvOf(head: string[], rows: (number | string)[][]): string {
  return [head, ...rows].map((row) => row.map(cell).join(",")).join("\r\n") + "\r\n";
}

/** Offers a text as a file for download. */
export function download(name: string, text: string, type = "text/csv"): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: `${type};charset=utf-8` }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
