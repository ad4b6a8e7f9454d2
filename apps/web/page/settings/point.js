// The chosen control point in fields: its indices i, j, k and its place x, y, z.
// SPDX-License-Identifier: Apache-2.0

import { byId, paced } from "../dom.js";

const AXES = [0, 1, 2];

export class PointFields {
  /** @param does  {choose(index), move(index, place)} */
  constructor(lattice, does) {
    Object.assign(this, { lattice, does, index: 0 });
    this.showSoon = paced(() => this.show());
    for (const axis of AXES) {
      byId(`index-${axis}`).addEventListener("change", () => this.indexed());
      byId(`place-${axis}`).addEventListener("change", () => this.placed(axis));
    }
  }

  choose(index) {
    if (index !== null) this.index = index;
    this.show();
  }

  show() {
    const { dims, points } = this.lattice();
    this.index = Math.min(this.index, Math.max(0, points.length / 3 - 1));
    const indices = [Math.floor(this.index / (dims[1] * dims[2])), Math.floor(this.index / dims[2]) % dims[1],
      this.index % dims[2]];
    for (const axis of AXES) {
      byId(`index-${axis}`).max = dims[axis] - 1;
      byId(`index-${axis}`).value = indices[axis];
      const place = points[3 * this.index + axis];
      byId(`place-${axis}`).value = place === undefined ? "" : Number(place.toPrecision(6));
    }
  }

  indexed() {
    const { dims } = this.lattice();
    const [i, j, k] = AXES.map((axis) => {
      const value = Math.round(Number(byId(`index-${axis}`).value) || 0);
      return Math.min(dims[axis] - 1, Math.max(0, value));
    });
    this.does.choose((i * dims[1] + j) * dims[2] + k);
  }

  /** Along one axis. What is no number that the core takes, such as an empty field, moves nothing. */
  placed(axis) {
    const text = byId(`place-${axis}`).value;
    const place = this.lattice().points.slice(3 * this.index, 3 * this.index + 3);
    place[axis] = Number(text);
    if (text === "" || !place.every(Number.isFinite)) this.show();
    else this.does.move(this.index, place);
  }
}
