// The engine as WebAssembly behind its worker, under Node: worker_test.js FOLDER. Prints how many vertices
// go through the core in a second, each word compared.
// SPDX-License-Identifier: Apache-2.0
"use strict";

const assert = require("assert");
const { host } = require("./hosted_worker.js");

const VERTICES = 7000;
const PASSES = 12; // the first ones compile

/** Vertices in no order, from -1 to 1. */
function cloud(count) {
  let state = 1;
  return Float32Array.from({ length: 3 * count }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 31 - 1;
  });
}

async function error(worker, message, words) {
  const answer = await worker.ask(message, "error");
  assert.strictEqual(answer.type, "error", JSON.stringify(message));
  assert.ok(answer.text.includes(words), answer.text);
  assert.ok(!answer.text.includes("\n"));
}

async function testBadInput(worker) {
  await error(worker, { type: "open", core: "basic-fx99" }, "basic-fx99");
  await error(worker, { type: "mesh", positions: "none" }, "not a list of points");
  await error(worker, { type: "mesh", positions: new Float32Array(4) }, "not a list of points");
  await error(worker, { type: "mesh", positions: new Float32Array(3 * 5000000) }, "5000000 points");
  await error(worker, { type: "mesh", positions: new Float32Array([0, 0, NaN]) }, "not finite");
  await error(worker, { type: "dims", dims: [3, 4, 4] }, "take 4 to 16");
  await error(worker, { type: "dims", dims: [4, 4] }, "not three whole numbers");
  await error(worker, { type: "dims" }, "not three whole numbers");
  await error(worker, { type: "shape", deformation: "twist:x" }, "twist:x");
  await error(worker, { type: "inside", clocks: -1 }, "clocks");
  await error(worker, { type: "watch", ports: ["nothing"] }, "nothing");
  await error(worker, { type: "watch" }, "not a list");
  await error(worker, { type: "nonsense" }, "nonsense");
}

async function testCore(worker, core) {
  const opened = await worker.ask({ type: "open", core: core.name }, "opened");
  assert.strictEqual(opened.core, core.name);
  for (const { id } of opened.blocks) assert.ok(opened.drawing.includes(`id="block-${id}"`), id);
  const rest = await worker.ask({ type: "shape", deformation: "" }, "deformed");
  assert.strictEqual(rest.mismatches, 0);
  assert.strictEqual(rest.words, 4 * rest.vertices);
  await worker.ask({ type: "watch", ports: opened.ports.map((port) => port.name) }, "state");
  const state = await worker.ask({ type: "inside", clocks: 1500 }, "state");
  assert.strictEqual(state.busy.length, opened.blocks.length);
  assert.strictEqual(state.mismatches, 0);
  assert.strictEqual(state.timeline.clocks, 200);
  const next = await worker.ask({ type: "inside", vertex: true }, "state");
  assert.strictEqual(next.vertices, state.vertices + 1);
  const { text } = await worker.ask({ type: "vcd" }, "vcd");
  assert.ok(text.startsWith("$timescale"));
  const wrong = await worker.ask({ type: "fault", on: true }, "deformed");
  assert.ok(wrong.mismatches > 0);
  assert.strictEqual(wrong.first.rtl, (wrong.first.model | (1 << 24)) >>> 0);
  const right = await worker.ask({ type: "fault", on: false }, "deformed");
  assert.strictEqual(right.mismatches, 0);
}

/** Newer points replace those that wait. */
async function testDrags(worker) {
  const { points } = await worker.ask({ type: "dims", dims: [4, 4, 4] }, "lattice");
  await worker.next("deformed");
  for (let i = 0; i < 50; ++i) worker.send({ type: "points", points: points.map((x) => x + i) });
  const answer = await worker.ask({ type: "vcd" }, "vcd");
  assert.strictEqual(answer.type, "vcd");
  assert.ok(worker.passed("deformed") <= 2, `${worker.passed("deformed")} answers to 50 drags`);
}

async function measure(worker, core) {
  await worker.ask({ type: "open", core }, "deformed");
  await worker.ask({ type: "mesh", positions: cloud(VERTICES) }, "deformed");
  let best = 0;
  for (let i = 0; i < PASSES; ++i) {
    const done = await worker.ask({ type: "shape", deformation: `twist:${i}` }, "deformed");
    assert.strictEqual(done.mismatches, 0);
    best = Math.max(best, done.vertices / done.seconds);
  }
  return Math.round(best);
}

async function main(folder) {
  const worker = host(folder);
  const { cores } = await worker.next("ready");
  await worker.ask({ type: "open", core: cores[0].name }, "opened");
  await worker.ask({ type: "mesh", positions: cloud(1000) }, "deformed");
  await testBadInput(worker);
  for (const core of cores) await testCore(worker, core);
  await testDrags(worker);
  const rate = await measure(worker, "factored-fx18-overlapped");
  console.log(`${cores.length} cores agree with their models; factored: ${rate} vertices/s`);
  process.exit(0);
}

main(process.argv[2]).catch((error) => {
  console.error(error);
  process.exit(1);
});
