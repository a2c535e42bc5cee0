// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h, section } from "./dom";
import { inspector, tooltip } from "./inspector";
import type { Model } from "./model";
import { NetControls } from "./net_controls";
import type { Selection } from "./selection";
import { NetView } from "./view";

function describe(canvas: HTMLCanvasElement): void {
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label",
    "The net in three dimensions. Arrow keys rotate, plus and minus zoom, Home shows all of it, Escape clears the selection. All values are in the tables below.");
}

/** Prints a picture of the view, on white. */
function print(container: HTMLElement, view: NetView): void {
  const picture = h("img", { class: "print-only", alt: "The net as shown" });
  container.append(picture);
  addEventListener("beforeprint", () => (picture.src = view.picture()));
}

/**
 * The view with its controls. It draws once `start` is called, which may take a while: without a
 * graphics card the browser first gets ready to draw in software.
 * @param first key of the quantity that is shown in colour at first
 */
export function netSection(model: Model, selection: Selection, first: string): { element: HTMLElement; start: () => void } {
  const container = h("div", { class: "canvas" });
  const controls = new NetControls(model, first);
  const panel = h("div", { class: "panel" }, controls.element, inspector(model, selection));
  const start = (): void => {
    let view: NetView;
    try {
      view = new NetView(container, model, selection);
    } catch {
      document.body.classList.add("without-view");
      container.append(h("p", {}, "This browser cannot draw in three dimensions (no WebGL). The rest of this page works without it."));
      return;
    }
    describe(view.canvas);
    controls.connect(view);
    selection.onShow((item) => view.lookAt(item));
    print(container, view);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) => view.setTheme(event.matches));
    document.body.append(tooltip(model, selection, () => controls.quantity));
    // For users of the browser's console, and for the tests.
    Object.assign(container, { netView: view });
  };
  const element = section("net", "The net", h("div", { class: "view" }, container, panel));
  selection.onShow(() => element.scrollIntoView({ block: "start" }));
  return { element, start };
}
