// The page: makes its parts and joins them.
// SPDX-License-Identifier: Apache-2.0

import { byId } from "./dom.js";
import { Engine } from "./engine.js";
import { data, handModule, startWorker } from "./embedded.js";
import { Notice } from "./notice.js";
import { Work } from "./work.js";
import { Comparison } from "./comparison.js";
import { Inside } from "./inside/inside.js";
import { showFigures } from "./figures/figures.js";

function showLicences() {
  const button = byId("licences");
  const text = byId("licence-text");
  button.addEventListener("click", () => {
    text.textContent = data("licences").join("\n\n");
    text.hidden = !text.hidden;
    button.setAttribute("aria-expanded", String(!text.hidden));
  });
}

/** Starts the worker and hands it the core, which is compiled while the page is made; null where it cannot be. */
function startEngine(notice) {
  try {
    const worker = startWorker();
    handModule(worker).catch((error) => notice.say(`The simulated core cannot be unpacked: ${error.message}.`));
    return new Engine(worker);
  } catch (error) {
    notice.say(error.message);
    byId("verdict-text").textContent = "No core runs in this browser";
    return null;
  }
}

function start() {
  const notice = new Notice();
  const engine = startEngine(notice);
  const work = new Work(notice);
  if (engine) {
    engine.on("error", ({ text }) => notice.say(text));
    engine.on("failed", (why) => notice.say(`The simulated core has stopped: ${why}. Load the page again.`));
    work.connect(engine);
    new Comparison(engine);
    new Inside(engine, work);
  }
  showLicences();
  requestIdleCallback(() => showFigures(work));
}

start();
