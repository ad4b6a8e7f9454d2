// The worker of the live page: hosts the engine, and answers messages in their order (apps/web/README.md).
//
// In a page of one file engine.js and drawings.js stand in front of this text, and a first message
// {type: "module", wasm: ArrayBuffer} brings the WebAssembly; else all three are fetched from where this
// file lies.
// SPDX-License-Identifier: Apache-2.0
"use strict";

const POINTS_AT_MOST = 2000000; // vertices: engine.hpp, kMostVertices
const CLOCKS_AT_MOST = 1000000; // inside.hpp, kMostClocks

let engine = null;

/** Sends a message; its arrays go over without a copy. */
function post(message) {
  const arrays = Object.values(message).filter(ArrayBuffer.isView);
  self.postMessage(message, arrays.map((array) => array.buffer));
}

/** Whether a call of the engine went well; where not, throws what it said. */
function call(name, types = [], values = []) {
  if (!engine.ccall(`hwffd_${name}`, "number", types, values)) throw new Error(text());
}

function text() {
  return engine.ccall("hwffd_text", "string", [], []);
}

/** A copy of the floats that the last call gave. */
function floats() {
  const start = engine._hwffd_floats() / 4;
  return engine.HEAPF32.slice(start, start + engine._hwffd_float_count());
}

/** Gives the next call its floats. */
function give(values, what) {
  if (!(values instanceof Float32Array) || values.length === 0 || values.length % 3 !== 0) {
    throw new Error(`${what}: not a list of points; give a Float32Array of x, y, z`);
  }
  if (values.length > 3 * POINTS_AT_MOST) {
    throw new Error(`${what}: ${values.length / 3} points; give ${POINTS_AT_MOST} at most`);
  }
  const room = engine._hwffd_room(values.length) / 4;
  engine.HEAPF32.set(values, room);
}

function postLattice() {
  call("lattice");
  post({ type: "lattice", ...JSON.parse(text()), points: floats() });
}

function postDeformed() {
  const start = performance.now();
  call("deform");
  const seconds = (performance.now() - start) / 1000;
  post({ type: "deformed", ...JSON.parse(text()), seconds, positions: floats() });
}

function postState() {
  const state = JSON.parse(text());
  post({ type: "state", ...state, busy: Uint8Array.from(state.busy) });
}

const handlers = {
  open({ core }) {
    call("open", ["string"], [String(core)]);
    post({ type: "opened", drawing: self.HWFFD_DRAWINGS[core], ...JSON.parse(text()) });
    if (!engine._hwffd_has_mesh()) return;
    postLattice();
    postDeformed();
  },
  mesh({ positions }) {
    give(positions, "mesh");
    call("mesh");
    postLattice();
    postDeformed();
  },
  dims({ dims }) {
    if (!Array.isArray(dims) || dims.length !== 3 || !dims.every(Number.isInteger)) {
      throw new Error("dims: not three whole numbers; give points along s, t and u, 4 to 16");
    }
    call("dims", ["number", "number", "number"], dims);
    if (!engine._hwffd_has_mesh()) return;
    postLattice();
    postDeformed();
  },
  points({ points }) {
    give(points, "lattice");
    call("points");
    postDeformed();
  },
  shape({ deformation }) {
    call("shape", ["string"], [String(deformation ?? "")]);
    postLattice();
    postDeformed();
  },
  fault({ on }) {
    call("fault", ["number"], [on ? 1 : 0]);
    postDeformed();
  },
  inside({ clocks, vertex }) {
    if (!vertex && !(Number.isInteger(clocks) && clocks >= 1 && clocks <= CLOCKS_AT_MOST)) {
      throw new Error(`clocks: ${clocks}; give a whole number from 1 to ${CLOCKS_AT_MOST}`);
    }
    call("inside", ["number"], [vertex ? 0 : clocks]);
    postState();
  },
  watch({ ports }) {
    if (!Array.isArray(ports)) throw new Error("ports: not a list; give names of opened.ports");
    call("watch", ["string"], [ports.join(",")]);
    postState();
  },
  vcd() {
    call("vcd");
    post({ type: "vcd", text: text() });
  },
};

function handle(message) {
  try {
    const handler = Object.hasOwn(handlers, message.type) ? handlers[message.type] : null;
    if (handler === null) throw new Error(`message '${message.type}': unknown; see apps/web/README.md`);
    handler(message);
  } catch (error) {
    post({ type: "error", text: String(error.message ?? error) });
  }
}

// Messages wait here, so that a newer "points" replaces one that has not begun.
const waiting = [];
let scheduled = false;
const wake = new MessageChannel();
wake.port1.onmessage = () => {
  scheduled = false;
  const message = waiting.shift();
  if (message !== undefined) handle(message);
  schedule();
};

function schedule() {
  if (scheduled || engine === null || waiting.length === 0) return;
  scheduled = true;
  wake.port2.postMessage(null);
}

function take(message) {
  const last = waiting[waiting.length - 1];
  if (message.type === "points" && last !== undefined && last.type === "points") {
    waiting.pop();
    post({ type: "superseded" });
  }
  waiting.push(message);
  schedule();
}

async function start(wasm) {
  try {
    const module = await createHwffdEngine(wasm === undefined ? {} : { wasmBinary: wasm });
    module.ccall("hwffd_cores", "number", [], []);
    engine = module;
    post({ type: "ready", ...JSON.parse(text()) });
    schedule();
  } catch (error) {
    post({ type: "error", text: `WebAssembly: ${error.message ?? error}; take a browser that has it` });
  }
}

self.onmessage = ({ data }) => (data.type === "module" ? start(data.wasm) : take(data));

if (typeof createHwffdEngine === "undefined") {
  importScripts("engine.js", "drawings.js");
  start();
}
