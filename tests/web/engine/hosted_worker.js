// The worker of the live page under Node: a function that starts it and asks it things.
// SPDX-License-Identifier: Apache-2.0
"use strict";

const fs = require("fs");
const path = require("path");
const vm = require("vm");

/** Starts the worker of a folder; ask(message, type) resolves with its first answer of that type. */
function host(folder) {
  const answers = [];
  const wanted = [];
  let gone = []; // the answers up to the last that was wanted
  const deliver = (message) => {
    answers.push(message);
    for (const want of wanted.splice(0)) if (!want()) wanted.push(want);
  };
  const self = { postMessage: (message) => deliver(message) };
  const context = vm.createContext({
    self, console, performance, MessageChannel, TextDecoder, WebAssembly, URL, setTimeout,
    ArrayBuffer, Float32Array, Uint8Array,
    // What Emscripten's script looks at to see that this is a worker.
    importScripts: () => {}, location: { href: `file://${folder}/worker.js` },
  });
  context.self.location = context.location;
  const next = (type) => new Promise((resolve) => {
    const look = () => {
      const place = answers.findIndex((answer) => answer.type === type || answer.type === "error");
      if (place < 0) return false;
      gone = answers.splice(0, place + 1);
      resolve(gone[place]);
      return true;
    };
    if (!look()) wanted.push(look);
  });
  for (const name of ["engine.js", "drawings.js", "worker.js"]) {
    vm.runInContext(fs.readFileSync(path.join(folder, name), "utf8"), context, { filename: name });
  }
  const wasm = fs.readFileSync(path.join(folder, "engine.wasm"));
  self.onmessage({ data: { type: "module", wasm } });
  return {
    next,
    /** How many of that type came before the last answer that was wanted. */
    passed: (type) => gone.filter((answer) => answer.type === type).length,
    send: (message) => self.onmessage({ data: message }),
    ask(message, type) {
      self.onmessage({ data: message });
      return next(type);
    },
  };
}

module.exports = { host };
