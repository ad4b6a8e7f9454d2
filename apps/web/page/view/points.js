// Control points under the hand: picked and dragged with mouse or finger, chosen and moved by keys.
// SPDX-License-Identifier: Apache-2.0

import * as THREE from "three";
import { axesOf } from "./scene.js";

const REACH = { mouse: 12, pen: 16, touch: 28 };  // pixels around a point
const STEP = 0.05;  // of the lattice's extent, for each key

export class PointControls {
  /**
   * @param scene  of which the points are
   * @param lattice  () => {dims, points}, what is shown
   * @param does  {choose(index or null), move(index, place), end()}
   */
  constructor(scene, lattice, does) {
    Object.assign(this, { scene, lattice, does, chosen: null, dragging: null });
    const canvas = scene.canvas;
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => this.up(event));
    canvas.addEventListener("keydown", (event) => this.key(event));
    // The wheel scrolls the page until the picture is in use.
    scene.controls.enableZoom = false;
    canvas.addEventListener("focus", () => { scene.controls.enableZoom = true; });
    canvas.addEventListener("blur", () => { scene.controls.enableZoom = false; });
  }

  place(index) {
    return new THREE.Vector3().fromArray(this.lattice().points, 3 * index);
  }

  /** The nearest control point under the pointer, null if there is none. */
  pick(event) {
    const bounds = this.scene.canvas.getBoundingClientRect();
    const reach = REACH[event.pointerType] ?? REACH.mouse;
    const spot = new THREE.Vector3();
    let best = { index: null, depth: Infinity };
    for (let index = 0; index < this.lattice().points.length / 3; ++index) {
      spot.copy(this.place(index)).project(this.scene.camera);
      const x = bounds.left + (spot.x + 1) / 2 * bounds.width;
      const y = bounds.top + (1 - spot.y) / 2 * bounds.height;
      const near = Math.hypot(x - event.clientX, y - event.clientY) < reach;
      if (near && spot.z < best.depth) best = { index, depth: spot.z };
    }
    return best.index;
  }

  /** Where the pointer is in the plane through a place that faces the camera. */
  underPointer(event, place) {
    const bounds = this.scene.canvas.getBoundingClientRect();
    const pointer = new THREE.Vector2((event.clientX - bounds.left) / bounds.width * 2 - 1,
      1 - (event.clientY - bounds.top) / bounds.height * 2);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(pointer, this.scene.camera);
    const facing = this.scene.camera.getWorldDirection(new THREE.Vector3());
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(facing, place);
    return ray.ray.intersectPlane(plane, new THREE.Vector3());
  }

  down(event) {
    if (event.button !== 0 || this.dragging !== null) return;
    const index = this.pick(event);
    if (index === null) return;
    this.scene.controls.enabled = false;
    this.scene.canvas.setPointerCapture(event.pointerId);
    this.scene.canvas.focus({ preventScroll: true });
    this.choose(index);
    const place = this.place(index);
    const under = this.underPointer(event, place);
    this.dragging = { pointer: event.pointerId, place, offset: place.clone().sub(under ?? place) };
  }

  move(event) {
    if (this.dragging === null) {
      if (event.buttons === 0) this.scene.canvas.style.cursor = this.pick(event) === null ? "grab" : "pointer";
      return;
    }
    if (event.pointerId !== this.dragging.pointer) return;  // another finger
    const under = this.underPointer(event, this.dragging.place);
    if (under) this.does.move(this.chosen, under.add(this.dragging.offset).toArray());
  }

  up(event) {
    if (event.pointerId === this.dragging?.pointer) this.drop();
  }

  /** Ends a drag. */
  drop() {
    if (this.dragging === null) return;
    this.dragging = null;
    this.scene.controls.enabled = true;
    this.does.end();
  }

  /** Of another point, or of none, a drag is over. */
  choose(index) {
    if (index !== this.chosen) this.drop();
    this.chosen = index;
    this.does.choose(index);
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const used = this.chooseByKey(event.key) || this.zoomByKey(event.key) ||
      (this.chosen === null ? this.orbitByKey(event.key) : this.moveByKey(event));
    if (used) event.preventDefault();
  }

  chooseByKey(key) {
    const count = this.lattice().points.length / 3;
    const step = { n: 1, p: -1 }[key.toLowerCase()];
    if (step) this.choose(((this.chosen ?? (step > 0 ? -1 : 0)) + step + count) % count);
    else if (key === "Escape" && this.chosen !== null) this.choose(null);
    else return false;
    return true;
  }

  zoomByKey(key) {
    const factor = { "+": 0.9, "=": 0.9, "-": 1 / 0.9 }[key];
    if (factor) this.scene.orbit(0, 0, factor);
    return Boolean(factor);
  }

  orbitByKey(key) {
    const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    if (turns[key]) this.scene.orbit(...turns[key]);
    return Boolean(turns[key]);
  }

  /** Arrows move in the plane of the picture; with Shift up and down are away from and towards the eye. */
  moveByKey(event) {
    const [right, up, back] = axesOf(this.scene.camera);
    const vertical = event.shiftKey ? back.negate() : up;
    const ways = { ArrowLeft: [right, -1], ArrowRight: [right, 1], ArrowUp: [vertical, 1],
      ArrowDown: [vertical, -1] };
    if (!ways[event.key]) return false;
    const [direction, sign] = ways[event.key];
    const extent = new THREE.Box3().setFromArray(this.lattice().points).getSize(new THREE.Vector3()).length();
    const place = this.place(this.chosen).addScaledVector(direction, sign * STEP * extent);
    this.does.move(this.chosen, place.toArray());
    this.does.end();
    return true;
  }
}
