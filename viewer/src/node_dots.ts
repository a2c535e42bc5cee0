// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { BufferAttribute, BufferGeometry, CanvasTexture, Points, PointsMaterial } from "three";

/** A round dot instead of a square. */
export function discTexture(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const context = canvas.getContext("2d")!;
  context.fillStyle = "#fff";
  context.beginPath();
  context.arc(16, 16, 15, 0, 2 * Math.PI);
  context.fill();
  return new CanvasTexture(canvas);
}

/** Dots at nodes, of one size on the screen. */
export class NodeDots {
  readonly object: Points<BufferGeometry, PointsMaterial>;

  constructor(size: number, texture: CanvasTexture | null) {
    const material = new PointsMaterial({ size, sizeAttenuation: false, vertexColors: true, map: texture, alphaTest: texture ? 0.5 : 0 });
    this.object = new Points(new BufferGeometry(), material);
    this.object.frustumCulled = false;
  }

  set(positions: Float32Array, colours: Float32Array): void {
    this.object.geometry.setAttribute("position", new BufferAttribute(positions, 3));
    this.object.geometry.setAttribute("color", new BufferAttribute(colours, 3));
  }
}
