// Meshes that come from no file: an amphora with flutes, a knot and a ball, some 7,000 vertices each.
// SPDX-License-Identifier: Apache-2.0

const TURN = 2 * Math.PI;

/** Collects a grid of vertices, which closes around its columns, and its triangles. */
class Builder {
  constructor() {
    this.positions = [];
    this.indices = [];
  }

  /** rows x columns places at(row, column); the last row joins the first if `ring`. */
  grid(rows, columns, at, ring = false) {
    const first = this.positions.length / 3;
    for (let r = 0; r < rows; ++r) {
      for (let c = 0; c < columns; ++c) this.positions.push(...at(r, c));
    }
    for (let r = 0; r < (ring ? rows : rows - 1); ++r) {
      for (let c = 0; c < columns; ++c) {
        const [near, far] = [first + r * columns, first + ((r + 1) % rows) * columns];
        const next = (c + 1) % columns;
        this.indices.push(near + c, far + c, near + next, near + next, far + c, far + next);
      }
    }
  }

  mesh(name) {
    return { name, positions: new Float32Array(this.positions), indices: new Uint32Array(this.indices) };
  }
}

// The outline of the amphora from the middle of its foot to the bottom of its inside: radius and height.
const OUTLINE = [
  [0.01, 0], [0.3, 0], [0.36, 0.03], [0.32, 0.1], [0.2, 0.17], [0.2, 0.22], [0.42, 0.45], [0.66, 0.8],
  [0.78, 1.15], [0.74, 1.5], [0.52, 1.78], [0.3, 1.95], [0.25, 2.15], [0.27, 2.35], [0.42, 2.48], [0.44, 2.55],
  [0.38, 2.56], [0.24, 2.4], [0.2, 2.15], [0.22, 1.95], [0.01, 1.9],
];

// The middle of a handle, from the neck to the belly, and half of its thickness.
const HANDLE = [[0.2, 2.28], [0.42, 2.37], [0.68, 2.3], [0.82, 2.05], [0.8, 1.78], [0.58, 1.58]];
const THICK = 0.055;

/** A place on a line through the points of the outline, smooth at each (Catmull and Rom). */
function along(points, fraction) {
  const place = fraction * (points.length - 1);
  const cell = Math.max(0, Math.min(Math.floor(place), points.length - 2));
  const s = place - cell;
  const at = (k) => points[Math.max(0, Math.min(points.length - 1, cell + k))];
  const weights = [
    (-s + 2 * s * s - s * s * s) / 2, (2 - 5 * s * s + 3 * s * s * s) / 2,
    (s + 4 * s * s - 3 * s * s * s) / 2, (-s * s + s * s * s) / 2,
  ];
  return [0, 1].map((axis) => weights.reduce((sum, weight, k) => sum + weight * at(k - 1)[axis], 0));
}

function amphora() {
  const builder = new Builder();
  builder.grid(66, 100, (r, c) => {
    const [radius, height] = along(OUTLINE, r / 65);
    const belly = Math.exp(-(((height - 1.1) / 0.5) ** 2)) * (r < 46 ? 1 : 0);
    const round = radius * (1 + 0.045 * belly * Math.cos(20 * TURN * c / 100));
    return [round * Math.cos(TURN * c / 100), height, -round * Math.sin(TURN * c / 100)];
  });
  for (const side of [1, -1]) {
    builder.grid(20, 10, (r, c) => {
      const [radius, height] = along(HANDLE, r / 19);
      const [ahead, above] = along(HANDLE, r / 19 + 0.001);
      const [outwards, , up] = unit([above - height, 0, radius - ahead]);
      const [across, turn] = [THICK * Math.cos(TURN * c / 10), -THICK * Math.sin(TURN * c / 10)];
      return [side * (radius + across * outwards), height + across * up, side * turn];
    });
  }
  return builder.mesh("amphora");
}

function knot() {
  const builder = new Builder();
  const path = (t) => {
    const radius = 1 + 0.42 * Math.cos(3 * t);
    return [radius * Math.cos(2 * t), 0.55 * Math.sin(3 * t) * 1.2, radius * Math.sin(2 * t)];
  };
  builder.grid(280, 25, (r, c) => {
    const t = TURN * r / 280;
    const [here, ahead] = [path(t), path(t + 0.001)];
    const tangent = unit(ahead.map((value, axis) => value - here[axis]));
    const side = unit(cross(tangent, [0, 1, 0]));
    const up = cross(side, tangent);
    const [x, y] = [0.2 * Math.cos(TURN * c / 25), 0.2 * Math.sin(TURN * c / 25)];
    return here.map((value, axis) => value + x * side[axis] + y * up[axis]);
  }, true);
  return builder.mesh("knot");
}

function ball() {
  const builder = new Builder();
  builder.grid(70, 100, (r, c) => {
    const polar = 0.004 + (Math.PI - 0.008) * r / 69;
    return [-Math.sin(polar) * Math.cos(TURN * c / 100), Math.cos(polar),
      -Math.sin(polar) * Math.sin(TURN * c / 100)].map((value) => -value);
  });
  return builder.mesh("ball");
}

function cross([ax, ay, az], [bx, by, bz]) {
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

function unit(vector) {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length);
}

/** Name -> the function that makes the mesh. */
export const BUILT_IN = { amphora, knot, ball };
