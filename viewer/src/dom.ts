// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

type Value = string | number | boolean | EventListener | undefined | null;
type Child = Node | string | number | null | undefined;

/** An element with attributes, listeners ("on..." keys) and children. Text is only ever text. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, Value> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value != null) element.setAttribute(name, String(value));
  }
  element.append(...children.filter((c) => c != null).map((c) => (typeof c === "number" ? String(c) : c!)));
  return element;
}

/** An SVG element with attributes. */
export function svg(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

/** An element that the page must have. */
export function byId(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no #${id}`);
  return element;
}

/** A heading with what follows, in a section of the page. */
export function section(id: string, heading: string, ...children: Child[]): HTMLElement {
  const label = `${id}-heading`;
  return h("section", { id, "aria-labelledby": label }, h("h2", { id: label }, heading), ...children);
}
