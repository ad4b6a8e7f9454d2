// Stands for the worker that hosts the simulated core, so that the page's own tests need no build of it: the same
// messages, with equation (1) in doubles in place of hardware, and traffic that is made up.
// SPDX-License-Identifier: Apache-2.0

"use strict";

const CORES = [
  { name: "factored-fx18-overlapped", org: "factored", n: 64, format: "fx18", interval: 1 },
  { name: "factored3-fx18-overlapped", org: "factored/3", n: 64, format: "fx18", interval: 3 },
  { name: "basic-fp32-overlapped", org: "basic", n: 1, format: "fp32", interval: 64 },
].map((core) => ({ ...core, schedule: "overlapped", title: core.org, formula: "64 / N", formula_clocks: core.interval }));
const BLOCKS = ["decoder", "cache", "organization", "encoder"];
const PORTS = [["s_axis_tvalid", 1], ["s_axis_tready", 1], ["s_axis_tdata", 128], ["m_axis_tvalid", 1], ["m_axis_tdata", 128]];

const state = { core: CORES[0], positions: null, dims: [4, 4, 4], rest: null, points: null, fault: false, clock: 0, watched: [] };

function box() {
  const { dims, positions } = state;
  const [low, high] = [Math.min, Math.max].map((of) => [0, 1, 2].map((axis) => {
    let best = positions[axis];
    for (let at = axis; at < positions.length; at += 3) best = of(best, positions[at]);
    return best;
  }));
  const points = [];
  for (let i = 0; i < dims[0]; ++i) for (let j = 0; j < dims[1]; ++j) for (let k = 0; k < dims[2]; ++k) {
    [i, j, k].forEach((n, axis) => points.push(low[axis] + (n - 1) * (high[axis] - low[axis]) / (dims[axis] - 3)));
  }
  Object.assign(state, { low, high, rest: new Float32Array(points), points: new Float32Array(points) });
}

function weights(s) {
  return [(1 - s) ** 3 / 6, (3 * s ** 3 - 6 * s * s + 4) / 6, (-3 * s ** 3 + 3 * s * s + 3 * s + 1) / 6, s ** 3 / 6];
}

function evaluate() {
  const { dims, positions, points, low, high } = state;
  const moved = new Float32Array(positions.length);
  for (let v = 0; v < positions.length; v += 3) {
    const place = [0, 1, 2].map((axis) => {
      const cells = dims[axis] - 3;
      const at = (positions[v + axis] - low[axis]) / (high[axis] - low[axis]) * cells;
      const cell = Math.min(cells - 1, Math.max(0, Math.floor(at)));
      return [cell, weights(at - cell)];
    });
    const [[i, a], [j, b], [k, c]] = place;
    for (let l = 0; l < 4; ++l) for (let m = 0; m < 4; ++m) for (let n = 0; n < 4; ++n) {
      const weight = a[l] * b[m] * c[n];
      const at = 3 * (((i + l) * dims[1] + j + m) * dims[2] + k + n);
      for (let axis = 0; axis < 3; ++axis) moved[v + axis] += weight * points[at + axis];
    }
  }
  return moved;
}

function deformed() {
  const begin = performance.now();
  const positions = evaluate();
  const vertices = positions.length / 3;
  const wrong = state.fault ? Math.floor(vertices / 2) : 0;
  for (let v = 0; v < wrong; ++v) positions[6 * v] += 0.05;
  postMessage({ type: "deformed", positions, vertices, words: 3 * vertices, mismatches: wrong,
    first: wrong ? { vertex: 0, word: 0, rtl: 0xa5, model: 0xa4 } : null,
    clocks: vertices * state.core.interval + 60, clocks_per_vertex: state.core.interval + 60 / vertices,
    seconds: (performance.now() - begin) / 1000, saturated: 0 });
}

function lattice() {
  postMessage({ type: "lattice", dims: state.dims, points: state.points.slice() });
}

function shape(text) {
  const amount = Number(text.split(":")[1] ?? 0);
  const height = state.high[1] - state.low[1];
  for (let at = 0; at < state.rest.length; at += 3) {
    const up = (state.rest[at + 1] - state.low[1]) / height;
    const turn = text.startsWith("twist") ? amount * Math.PI / 180 * up : 0;
    const [x, z] = [state.rest[at], state.rest[at + 2]];
    const more = text && !text.startsWith("twist") ? 0.3 * up * amount / 90 : 0;
    state.points.set([x * Math.cos(turn) + z * Math.sin(turn) + more, state.rest[at + 1],
      z * Math.cos(turn) - x * Math.sin(turn)], at);
  }
}

function opened() {
  const boxes = BLOCKS.map((id, at) => `<g id="block-${id}"><rect x="${10 + 150 * at}" y="20" width="120" height="60" rx="4" ` +
    `fill="none" stroke="currentColor"/><text x="${70 + 150 * at}" y="55" text-anchor="middle">${id}</text></g>`);
  const drawing = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 610 100" width="610" height="100">${boxes.join("")}</svg>`;
  postMessage({ type: "opened", core: state.core.name, drawing,
    blocks: BLOCKS.map((id) => ({ id, title: id, module: `ffd_${id}` })),
    ports: PORTS.map(([name, width]) => ({ name, width, description: "" })) });
}

function insideState() {
  const { interval } = state.core;
  const clocks = Math.min(200, state.clock);
  const first = state.clock - clocks;
  const lanes = ["decoder", "weights s", "weights t", "weights u", "tree", "accumulator"].map((name, row) => {
    const spans = [];
    for (let v = Math.max(0, Math.floor((first - 9 * row) / interval)); interval * v + 9 * row < state.clock; ++v) {
      const begin = interval * v + 9 * row - first;
      spans.push([Math.max(0, begin), Math.min(clocks, begin + Math.min(interval, 7)), v]);
    }
    return { name, spans };
  });
  postMessage({ type: "state", clock: state.clock, busy: Uint8Array.from(BLOCKS, (_, at) => (state.clock >> at) & 1),
    vertices: Math.max(0, Math.floor((state.clock - 60) / interval)), mismatches: 0,
    timeline: { first_clock: first, clocks, lanes },
    ports: Object.fromEntries(PORTS.map(([name, width]) => [name, width === 1 ? String(state.clock & 1) : `0x${(state.clock * 77).toString(16)}`])) });
}

function vcd() {
  const codes = state.watched.map((name, at) => [name, PORTS.find(([one]) => one === name)[1], String.fromCharCode(33 + at)]);
  const lines = codes.map(([name, width, code]) => `$var wire ${width} ${code} ${name} $end`);
  for (let clock = 0; clock < state.clock; ++clock) {
    lines.push(`#${clock}`, ...codes.map(([, width, code]) => width === 1 ? `${(clock >> 1) & 1}${code}` : `b${(clock * 77).toString(2)} ${code}`));
  }
  postMessage({ type: "vcd", text: `$timescale 1ns $end\n$enddefinitions $end\n${lines.join("\n")}\n#${state.clock}\n` });
}

const ANSWERS = {
  open: ({ core }) => {
    state.core = CORES.find(({ name }) => name === core);
    state.clock = 0;
    opened();
    if (state.positions) { lattice(); deformed(); }
  },
  mesh: ({ positions }) => { state.positions = positions; box(); lattice(); deformed(); },
  dims: ({ dims }) => { state.dims = dims; if (state.positions) { box(); lattice(); deformed(); } },
  points: ({ points }) => { state.points = points; deformed(); },
  shape: ({ deformation }) => { shape(deformation); lattice(); deformed(); },
  fault: ({ on }) => { state.fault = on; deformed(); },
  inside: ({ clocks, vertex }) => { state.clock += vertex ? state.core.interval : clocks; insideState(); },
  watch: ({ ports }) => { state.watched = ports; insideState(); },
  vcd,
};

onmessage = ({ data }) => ANSWERS[data.type](data);
postMessage({ type: "ready", cores: CORES });
