// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// A dropped Excel file (xlsx) as the CSV of its sheet, which the program in this page reads: it has no
// reader of its own, as that of src/files/xlsx_reader.cpp, whose rules these are.

import { unzipSync } from "fflate";

const largest = 32 * 2 ** 20;
const mostColumns = 1000;
/** Years to seconds, in what is left of the code of a format. */
const isDateCode = (code: string): boolean =>
  /[ymdhs]/i.test((code.split(";")[0] ?? "").replace(/"[^"]*"?|\[[^\]]*\]?|[\\_*]./g, ""));
const isBuiltinDate = (id: number): boolean =>
  (id >= 14 && id <= 22) || (id >= 27 && id <= 36) || (id >= 45 && id <= 47) || (id >= 50 && id <= 58);

const children = (node: Element | null, name: string): Element[] => [...(node?.children ?? [])].filter(({ localName }) => localName === name);
const child = (node: Element | null, name: string): Element | null => children(node, name)[0] ?? null;
const valueOf = (cell: Element): string => child(cell, "v")?.textContent ?? "";
const isNumber = (text: string): boolean => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) && Number.isFinite(Number(text));

/** A text, which may stand in runs of different fonts; without how it is pronounced. */
const richText = (node: Element | null): string => [...(node?.children ?? [])]
  .map((part) => (part.localName === "t" ? part : part.localName === "r" ? child(part, "t") : null)?.textContent ?? "").join("");

function columnOf(reference: string): number {
  const letters = /^([A-Z]{1,3})\d+$/.exec(reference)?.[1] ?? "";
  return [...letters].reduce((column, letter) => 26 * column + letter.charCodeAt(0) - 64, 0);
}

function dateText(serial: number, starts1904: boolean): string {
  if (!(serial >= 0 && serial <= 2958465)) return `date ${String(serial)}`;
  const date = new Date(Date.UTC(starts1904 ? 1904 : 1899, starts1904 ? 0 : 11, starts1904 ? 1 : 30) + Math.floor(serial) * 864e5);
  const minutes = Math.floor(serial * 24 * 60);
  const two = (value: number): string => String(value).padStart(2, "0");
  return serial < 1 && !starts1904 ? `${two(Math.floor(minutes / 60))}:${two(minutes % 60)}` : date.toISOString().slice(0, 10);
}

interface Row {
  number: number;
  cells: Map<number, Element>;
  numbers: number;
}

class Workbook {
  private readonly files: Record<string, Uint8Array>;
  private texts: string[] = [];
  private isDate: boolean[] = [];
  private starts1904 = false;

  constructor(private readonly name: string, bytes: Uint8Array) {
    let size = 0;
    try {
      this.files = unzipSync(bytes, {
        filter: ({ name: part, originalSize }) => {
          const isRead = /\.rels$|workbook|sharedStrings|styles|worksheets\//i.test(part);
          size += isRead ? originalSize : 0;
          if (size > largest) throw new RangeError();
          return isRead;
        },
      });
    } catch (error) {
      this.fail(error instanceof RangeError ? `is larger than ${String(largest / 2 ** 20)} MiB when unpacked` : "is a ZIP archive, as xlsx files are, that is damaged or encrypted");
    }
  }

  csv(): string {
    const root = this.relations("");
    const path = root.kinds.get("officeDocument") ?? "";
    const workbook = this.xml(path);
    if (workbook?.localName !== "workbook") this.fail("is a ZIP archive, but no Excel file (xlsx): save the table as xlsx or CSV");
    this.starts1904 = ["1", "true"].includes(child(workbook, "workbookPr")?.getAttribute("date1904") ?? "");
    const { ids, kinds } = this.relations(path);
    this.texts = children(this.xml(kinds.get("sharedStrings") ?? ""), "si").map(richText);
    const styles = this.xml(kinds.get("styles") ?? "");
    const codes = new Map(children(child(styles, "numFmts"), "numFmt").map((format) => [Number(format.getAttribute("numFmtId")), isDateCode(format.getAttribute("formatCode") ?? "")]));
    this.isDate = children(child(styles, "cellXfs"), "xf").map((style) => Number(style.getAttribute("numFmtId"))).map((id) => codes.get(id) ?? isBuiltinDate(id));

    let sheets = children(child(workbook, "sheets"), "sheet").filter((sheet) => (sheet.getAttribute("state") ?? "visible") === "visible").map((sheet) => {
      const id = [...sheet.attributes].find((attribute) => attribute.name.endsWith(":id"))?.value ?? "";
      const name = sheet.getAttribute("name") ?? "";
      const page = this.xml(ids.get(id) ?? "") ?? this.fail(`lacks its sheet '${name}': is the file whole?`);
      return { name, page, rows: this.rows(page) };
    }).filter(({ rows }) => rows.length > 0);
    const withPoints = sheets.filter(({ rows }) => rows.some(({ numbers }) => numbers >= 3));
    if (withPoints.length > 0) sheets = withPoints;
    const [sheet, ...others] = sheets;
    if (!sheet) this.fail("is an Excel file whose sheets are empty or hidden, expected one with a table");
    if (others.length > 0) this.fail(`holds tables in the sheets ${sheets.map(({ name }) => `'${name}'`).join(", ")}, expected one: hide the others, or save one as CSV`);
    this.refuseMerged(sheet.page, sheet.rows);
    return this.text(sheet.rows);
  }

  private fail(what: string, row?: number): never {
    throw new Error(`${this.name}${row === undefined ? "" : `:${String(row)}`}: ${what}`);
  }

  /** The root of a part; null where it is not there. */
  private xml(part: string): Element | null {
    const bytes = this.files[part];
    if (!bytes) return null;
    const text = new TextDecoder(bytes[0] === 0xff || bytes[1] === 0 ? "utf-16le" : bytes[0] === 0xfe ? "utf-16be" : "utf-8").decode(bytes);
    // What entities stand for can be without end.
    const document = text.includes("<!DOCTYPE") ? null : new DOMParser().parseFromString(text, "application/xml");
    if (!document || document.querySelector("parsererror")) this.fail(`its part ${part} is no XML of Excel`);
    return document.documentElement;
  }

  private relations(of: string): { ids: Map<string, string>; kinds: Map<string, string> } {
    const cut = of.lastIndexOf("/") + 1;
    const folder = of.slice(0, cut);
    const pathOf = (target: string): string => {
      try {
        return new URL(target, `file:///${folder}`).pathname.slice(1);
      } catch {
        return this.fail(`its part '${target}' has no name of a part`);
      }
    };
    const found = children(this.xml(`${folder}_rels/${of.slice(cut)}.rels`), "Relationship").map((one) => ({
      id: one.getAttribute("Id") ?? "",
      kind: (one.getAttribute("Type") ?? "").split("/").pop() ?? "",
      path: pathOf(one.getAttribute("Target") ?? ""),
    }));
    return { ids: new Map(found.map(({ id, path }) => [id, path])), kinds: new Map(found.map(({ kind, path }) => [kind, path])) };
  }

  private rows(page: Element): Row[] {
    const rows: Row[] = [];
    let last = 0;
    for (const node of children(child(page, "sheetData"), "row")) {
      const number = Number(node.getAttribute("r") ?? last + 1);
      if (!(Number.isInteger(number) && number > last && number <= 1048576)) this.fail(`is followed by row '${node.getAttribute("r") ?? ""}', expected a later one, of 1048576 at most`, last);
      last = number;
      const cells = new Map<number, Element>();
      let column = 0;
      for (const cell of children(node, "c")) {
        const reference = cell.getAttribute("r");
        const next = reference === null ? column + 1 : columnOf(reference);
        if (next <= column || next > 16384) this.fail(`names the cell '${reference ?? ""}', expected one behind those before`, number);
        column = next;
        if (child(cell, "f") || valueOf(cell) !== "" || richText(child(cell, "is")) !== "") cells.set(column, cell);
      }
      if (cells.size > 0) rows.push({ number, cells, numbers: [...cells.values()].filter((cell) => this.holdsNumber(cell)).length });
    }
    return rows;
  }

  private isDateCell(cell: Element): boolean {
    return this.isDate[Number(cell.getAttribute("s") ?? 0)] ?? false;
  }

  private holdsNumber(cell: Element): boolean {
    const type = cell.getAttribute("t") ?? "n";
    if (type === "n") return !this.isDateCell(cell) && isNumber(valueOf(cell));
    const text = type === "s" ? this.texts[Number(valueOf(cell))] ?? "" : type === "inlineStr" ? richText(child(cell, "is")) : type === "str" ? valueOf(cell) : "";
    return isNumber(text.replaceAll(",", "."));
  }

  /** The value of a cell as text, a number with all its digits; or the rest of "cell B12 ...", thrown. */
  private value(cell: Element): string {
    const type = cell.getAttribute("t") ?? "n";
    const value = valueOf(cell);
    if (type === "e") throw new Error(`holds the error '${value}', expected a value or nothing`);
    if (child(cell, "f") && value === "" && type !== "str") throw new Error("holds a formula that was never computed: open the file in a spreadsheet program and save it");
    if (type === "s") {
      const text = /^\d+$/.test(value) ? this.texts[Number(value)] : undefined;
      if (text === undefined) throw new Error(`names the shared text '${value}', of which there are ${String(this.texts.length)}`);
      return text;
    }
    if (type === "inlineStr") return richText(child(cell, "is"));
    if (type === "str" || type === "d") return value;
    if (type === "b") return value === "1" ? "TRUE" : "FALSE";
    if (value === "") return "";
    if (type !== "n" || !isNumber(value)) throw new Error(`is '${value.slice(0, 40)}', expected a finite number`);
    return this.isDateCell(cell) ? dateText(Number(value), this.starts1904) : String(Number(value));
  }

  /** A value that stands for several rows would be missing in all but the first. */
  private refuseMerged(page: Element, rows: Row[]): void {
    const numbered = rows.filter(({ numbers }) => numbers >= 2).map(({ number }) => number);
    /** The first of these rows behind another. */
    const nextTo = (row: number): number => {
      let [low, high] = [0, numbered.length];
      while (low < high) {
        const middle = (low + high) >> 1;
        if ((numbered[middle] ?? 0) > row) high = middle;
        else low = middle + 1;
      }
      return numbered[low] ?? Infinity;
    };
    for (const merged of children(child(page, "mergeCells"), "mergeCell")) {
      const range = merged.getAttribute("ref") ?? "";
      const [first, last] = range.split(":").map((reference) => Number(/^[A-Z]+(\d+)$/.exec(reference)?.[1]));
      if (first !== undefined && last !== undefined && nextTo(first) <= last) {
        this.fail(`begins the merged cells ${range}, expected a cell of its own in each row of the table`, first);
      }
    }
  }

  /** Each row on the line of its number, with so many fields as all others; one that starts with # is a remark. */
  private text(rows: Row[]): string {
    const columns = [...new Set(rows.flatMap(({ cells }) => [...cells.keys()]))].sort((a, b) => a - b);
    if (columns.length > mostColumns) this.fail(`has more than ${String(mostColumns)} columns`);
    const [first, last] = [columns[0] ?? 1, columns.at(-1) ?? 1];
    let text = "";
    let line = 1;
    for (const { number, cells, numbers } of rows) {
      const values = new Map([...cells].map(([column, cell]) => {
        try {
          return [column, this.value(cell).replace(/[\n\r\t]/g, " ").trim()];
        } catch (error) {
          return this.fail(`cell ${cell.getAttribute("r") ?? ""} ${(error as Error).message}`, number);
        }
      }));
      const isRemark = numbers < 3 && ([...values.values()][0]?.startsWith("#") ?? false);
      const quoted = (value: string): string => (!/[,;" ]|^#/.test(value) ? value : `"${value.replaceAll('"', '""')}"`);
      const fields = Array.from({ length: last - first + 1 }, (_, k) => {
        const value = values.get(first + k);
        return value ? quoted(value) : "";
      });
      text += "\n".repeat(number - line) + (isRemark ? [...values.values()].join(" ") : fields.some((field) => field !== "") ? fields.join(",") : "") + "\n";
      line = number + 1;
      if (text.length > 2 * largest) this.fail(`is where the table becomes larger than ${String(2 * largest / 2 ** 20)} MiB`, number);
    }
    return text;
  }
}

/** The content of a file, of an Excel file that of its sheet as CSV. Throws for one without a table. */
export function withoutExcel(name: string, bytes: Uint8Array): Uint8Array {
  const starts = (...magic: number[]): boolean => magic.every((byte, k) => bytes[k] === byte);
  if (starts(0xd0, 0xcf, 0x11, 0xe0)) throw new Error(`${name} is an old Office file (xls), or encrypted: save it as xlsx without a password, or as CSV`);
  return starts(0x50, 0x4b, 3, 4) ? new TextEncoder().encode(new Workbook(name, bytes).csv()) : bytes;
}
