// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

type Triple = [number, number, number];
export type Viewpoint = "perspective" | "top";

/** How much of the picture the net fills. */
const filled = 0.92;

/** From where the net is seen: two cameras, and how they are moved and fitted to it. */
export class NetCamera {
  viewpoint: Viewpoint = "perspective";
  private readonly perspective = new PerspectiveCamera(28, 1, 0.001, 1000);
  private readonly orthographic = new OrthographicCamera(-1, 1, 1, -1, 0.001, 1000);
  private readonly controls: OrbitControls;
  private readonly middle = new Vector3();
  private readonly size: number;

  /** @param points what the picture is fitted to, three coordinates each; @param moved called after every move */
  constructor(canvas: HTMLCanvasElement, private readonly points: Float32Array, moved: () => void) {
    this.size = this.measure();
    for (const camera of [this.perspective, this.orthographic]) camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.perspective, canvas);
    this.controls.addEventListener("change", moved);
  }

  get current(): PerspectiveCamera | OrthographicCamera {
    return this.viewpoint === "top" ? this.orthographic : this.perspective;
  }

  setViewpoint(viewpoint: Viewpoint): void {
    this.viewpoint = viewpoint;
    const camera = this.current;
    this.controls.object = camera;
    const direction = viewpoint === "top" ? new Vector3(0, -1e-4, 1) : new Vector3(0.42, -0.9, 0.75);
    this.controls.target.copy(this.middle);
    camera.position.copy(this.middle).addScaledVector(direction.normalize(), 3 * this.size);
    camera.zoom = 1;
    this.controls.update();
    this.fit();
  }

  setAspect(aspect: number): void {
    this.perspective.aspect = aspect;
    this.perspective.updateProjectionMatrix();
    this.fit();
  }

  /** Brings a place to the middle of the picture, nearer than the whole net. */
  lookAt(place: Vector3): void {
    const camera = this.current;
    const offset = camera.position.clone().sub(this.controls.target);
    this.controls.target.copy(place);
    if (camera instanceof OrthographicCamera) camera.zoom = Math.max(camera.zoom, 5);
    else offset.setLength(Math.min(offset.length(), 0.9 * this.size));
    camera.position.copy(place).add(offset);
    camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** In a picture that is so many pixels high; null in perspective. */
  metresPerPixel(height: number): number | null {
    const camera = this.current;
    return camera instanceof OrthographicCamera ? (2 * this.size) / camera.zoom / height : null;
  }

  /** Turns by angles, moves nearer by a factor. */
  turn(azimuth: number, polar: number, nearer = 1): void {
    const camera = this.current;
    const offset = camera.position.clone().sub(this.controls.target);
    const radius = offset.length();
    const angle = Math.atan2(offset.y, offset.x) + azimuth;
    const height = Math.min(Math.max(Math.acos(offset.z / radius) + polar, 1e-4), Math.PI - 1e-4);
    offset.set(Math.sin(height) * Math.cos(angle), Math.sin(height) * Math.sin(angle), Math.cos(height));
    if (camera instanceof OrthographicCamera) {
      camera.zoom *= nearer;
      camera.updateProjectionMatrix();
    }
    camera.position.copy(this.controls.target).addScaledVector(offset, camera instanceof OrthographicCamera ? radius : radius / nearer);
    this.controls.update();
  }

  /** Places of all nodes in a picture of that size; points behind the camera are not excluded. */
  project(positions: Float32Array, width: number, height: number): Float32Array {
    const camera = this.current;
    camera.updateMatrixWorld();
    const place = new Vector3();
    const screen = new Float32Array((2 * positions.length) / 3);
    for (let i = 0; 3 * i < positions.length; ++i) {
      place.fromArray(positions, 3 * i).project(camera);
      screen[2 * i] = 0.5 * (place.x + 1) * width;
      screen[2 * i + 1] = 0.5 * (1 - place.y) * height;
    }
    return screen;
  }

  /** How a place in a picture of that size moves with x, y and z: to the right and down [pixels per metre]; null of a point behind the camera. */
  rates(width: number, height: number): (place: ArrayLike<number>) => [Triple, Triple] | null {
    const camera = this.current;
    camera.updateMatrixWorld();
    const { elements: m } = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const row = (r: number, p: ArrayLike<number>): number => m[r]! * p[0]! + m[r + 4]! * p[1]! + m[r + 8]! * p[2]! + m[r + 12]!;
    return (place) => {
      const depth = row(3, place);
      if (!(depth > 0)) return null;
      // Of the quotient of two linear functions.
      const of = (r: number, half: number): Triple => {
        const quotient = row(r, place) / depth;
        return [0, 1, 2].map((k) => (half * (m[r + 4 * k]! - quotient * m[3 + 4 * k]!)) / depth) as Triple;
      };
      return [of(0, width / 2), of(1, -height / 2)];
    };
  }

  /** Moves the camera so that the net fills the picture. */
  private fit(): void {
    const camera = this.current;
    const aspect = this.perspective.aspect;
    if (camera instanceof OrthographicCamera) {
      Object.assign(camera, { left: -aspect * this.size, right: aspect * this.size, top: this.size, bottom: -this.size });
    }
    // What a change of distance does to the outermost node is not quite linear: some steps.
    for (let step = 0; step < 6; ++step) {
      Object.assign(camera, { near: 0.01 * this.size, far: 100 * this.size });
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
      const { x, y, reach } = this.extent(camera);
      // The middle of what is seen comes to the middle of the picture.
      const distance = camera.position.distanceTo(this.controls.target);
      const halfHeight = camera instanceof OrthographicCamera ? this.size / camera.zoom : distance * Math.tan((Math.PI * camera.fov) / 360);
      const shift = new Vector3(x * halfHeight * aspect, y * halfHeight, 0).applyQuaternion(camera.quaternion);
      this.controls.target.add(shift);
      camera.position.add(shift);
      if (camera instanceof OrthographicCamera) {
        camera.zoom *= filled / reach;
      } else {
        camera.position.sub(this.controls.target).multiplyScalar(reach / filled).add(this.controls.target);
      }
    }
    camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** Diagonal of the box around the net; sets its middle. */
  private measure(): number {
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = low.clone().negate();
    const place = new Vector3();
    for (let i = 0; i < this.points.length; i += 3) {
      place.fromArray(this.points, i);
      low.min(place);
      high.max(place);
    }
    this.middle.addVectors(low, high).multiplyScalar(0.5);
    return low.distanceTo(high) || 1;
  }

  /** Middle and half the larger extent of the net in a picture that goes from -1 to 1. */
  private extent(camera: PerspectiveCamera | OrthographicCamera): { x: number; y: number; reach: number } {
    const place = new Vector3();
    let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < this.points.length; i += 3) {
      place.fromArray(this.points, i).project(camera);
      [left, right] = [Math.min(left, place.x), Math.max(right, place.x)];
      [bottom, top] = [Math.min(bottom, place.y), Math.max(top, place.y)];
    }
    return { x: (left + right) / 2, y: (bottom + top) / 2, reach: Math.max(right - left, top - bottom, 1e-6) / 2 };
  }
}
