// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments, type Object3D } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

/** Lines between pairs of places: 6 coordinates and 6 colour components a line. */
export interface EdgeLines {
  readonly object: Object3D;
  setPositions(positions: Float32Array): void;
  setColours(colours: Float32Array): void;
  /** Draws only the first so many lines. */
  setCount(count: number): void;
}

/** Lines some pixels wide, each drawn as a small strip: for up to some thousands. */
export class WideLines implements EdgeLines {
  readonly object: LineSegments2;
  private readonly geometry = new LineSegmentsGeometry();
  readonly material: LineMaterial;

  constructor(width: number) {
    this.material = new LineMaterial({ linewidth: width, vertexColors: true, alphaToCoverage: false });
    this.object = new LineSegments2(this.geometry, this.material);
    this.object.frustumCulled = false;
  }

  setPositions(positions: Float32Array): void {
    this.geometry.setPositions(positions);
  }

  setColours(colours: Float32Array): void {
    this.geometry.setColors(colours);
  }

  setCount(count: number): void {
    this.geometry.instanceCount = count;
  }
}

/** Lines one pixel wide in one buffer: for nets of any size, software rendering included. */
export class ThinLines implements EdgeLines {
  readonly object: LineSegments;
  private readonly geometry = new BufferGeometry();

  constructor() {
    this.object = new LineSegments(this.geometry, new LineBasicMaterial({ vertexColors: true }));
    this.object.frustumCulled = false;
  }

  setPositions(positions: Float32Array): void {
    this.set("position", positions);
  }

  setColours(colours: Float32Array): void {
    this.set("color", colours);
  }

  setCount(count: number): void {
    this.geometry.setDrawRange(0, 2 * count);
  }

  private set(name: string, values: Float32Array): void {
    const attribute = this.geometry.getAttribute(name) as BufferAttribute | undefined;
    if (attribute?.array.length === values.length) {
      attribute.array.set(values);
      attribute.needsUpdate = true;
    } else {
      this.geometry.setAttribute(name, new BufferAttribute(values.slice(), 3));
    }
  }
}
