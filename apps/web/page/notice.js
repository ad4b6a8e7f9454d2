// The one sentence that says what went wrong; it stays until it is closed or the next one comes.
// SPDX-License-Identifier: Apache-2.0

import { byId } from "./dom.js";

export class Notice {
  constructor() {
    this.box = byId("notice");
    this.box.querySelector("button").addEventListener("click", () => this.clear());
  }

  say(sentence) {
    this.box.querySelector("p").textContent = sentence;
    this.box.hidden = false;
  }

  clear() {
    this.box.hidden = true;
  }
}
