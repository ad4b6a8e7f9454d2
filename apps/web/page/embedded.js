// What the build puts into the page beside its scripts: data as JSON, the worker's script, and WebAssembly as gzip
// in base64. All of it is inside the one file, so that the page opens without a server too.
// SPDX-License-Identifier: Apache-2.0

import { byId } from "./dom.js";

/** Data by name, null if the page was built without. */
export function data(name) {
  const found = byId(`data-${name}`);
  return found ? JSON.parse(found.textContent) : null;
}

async function unpacked(base64) {
  const packed = atob(base64.trim());
  const bytes = new Uint8Array(packed.length);
  for (let at = 0; at < packed.length; ++at) bytes[at] = packed.charCodeAt(at);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** Data that is packed, since it is long and not wanted at once. */
export async function packedData(name) {
  return JSON.parse(new TextDecoder().decode(await unpacked(byId(`packed-${name}`).textContent)));
}

export const hasPacked = (name) => byId(`packed-${name}`) !== null;

/**
 * The worker, started from the script inside the page.
 * @throws Error, a sentence, where the browser lacks what it takes
 */
export function startWorker() {
  if (typeof WebAssembly === "undefined") {
    throw new Error("This browser has no WebAssembly, so the simulated core cannot run here: take a newer one; " +
                    "tables and pictures below work without.");
  }
  if (typeof DecompressionStream === "undefined") {
    throw new Error("This browser cannot unpack the simulated core (it has no DecompressionStream): take one of " +
                    "2023 or later; tables and pictures below work without.");
  }
  const script = byId("worker-script").textContent;
  return new Worker(URL.createObjectURL(new Blob([script], { type: "text/javascript" })));
}

/** Hands the worker the simulated core, when it is unpacked; a worker of scripts alone has none. */
export async function handModule(worker) {
  if (!hasPacked("engine")) return;
  const wasm = await unpacked(byId("packed-engine").textContent);
  worker.postMessage({ type: "module", wasm }, [wasm]);
}
