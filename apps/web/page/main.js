// The page: makes its parts and joins them.
// SPDX-License-Identifier: Apache-2.0

import { byId } from "./dom.js";
import { Engine } from "./engine.js";
import { data, handParts, startWorker } from "./embedded.js";
import { Notice } from "./notice.js";
import { Work } from "./work.js";
import { Comparison } from "./comparison.js";
import { Inside } from "./inside/inside.js";
import { showFigures } from "./figures/figures.js";

function showLicences() {
  const button = byId("licences");
  const text = byId("licence-text");
  text.textContent = (data("licences") ?? []).join("\n\n");
  button.addEventListener("click", () => {
    text.hidden = !text.hidden;
    button.setAttribute("aria-expanded", String(!text.hidden));
  });
}

async function start() {
  const notice = new Notice();
  const work = new Work(notice);
  showLicences();
  showFigures(work);
  let worker;
  try {
    worker = startWorker();
  } catch (error) {
    notice.say(error.message);
    byId("verdict-text").textContent = "No core runs in this browser";
    return;
  }
  const engine = new Engine(worker);
  engine.on("error", ({ text }) => notice.say(text));
  engine.on("failed", (why) => notice.say(`The simulated core has stopped: ${why}. Load the page again.`));
  work.connect(engine);
  new Comparison(engine);
  new Inside(engine, work);
  await handParts(worker);
}

start();
