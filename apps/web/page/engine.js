// The page's end of the messages that apps/web/README.md lists: what is sent, what is waited for, and what of a
// drag is left out because a newer place of the point is known already.
// SPDX-License-Identifier: Apache-2.0

// The message that ends the answer to each, and what does where there is no mesh yet.
const WITHOUT_MESH = { open: "opened", dims: null };
const LAST = {
  open: "deformed", mesh: "deformed", dims: "deformed", points: "deformed", shape: "deformed",
  fault: "deformed", inside: "state", watch: "state", vcd: "vcd",
};

const LATTICES = ["mesh", "dims", "points", "shape"];  // what says where control points are
const RUNS = 2;  // of the mesh, that may be asked for at once

/** Sends messages to the worker and raises an event of each that comes, by its type, with it as `detail`. */
export class Engine extends EventTarget {
  constructor(worker) {
    super();
    this.worker = worker;
    this.expected = [];  // {asked, last} of the answers that are still to come, in order
    this.waiting = new Map();  // kind -> the newest message that waits for the answer to the one before
    this.hasMesh = false;
    worker.onmessage = (event) => this.receive(event.data);
    worker.onerror = (event) => this.raise("failed", event.message || "its script does not load");
  }

  /** Sends a message; its answer comes as events. */
  send(message, transfer = []) {
    if (message.type === "mesh") this.hasMesh = true;
    const last = this.hasMesh ? LAST[message.type] : WITHOUT_MESH[message.type];
    if (last !== null) this.expected.push({ asked: message.type, last });
    this.worker.postMessage(message, transfer);
    this.raise("busy");
  }

  /** Sends what is soon out of date, such as the points of a drag: of those that wait only the last goes. */
  sendNewest(message) {
    this.waiting.clear();  // each says where all control points are
    if (this.hasRoom()) this.send(message);
    else this.waiting.set(message.type, message);
  }

  /** What was sent last, or waits to be, of what says where control points are; null if all of it has been answered. */
  get newestLattice() {
    if (this.waiting.size > 0) return [...this.waiting.keys()].at(-1);
    return this.expected.findLast(({ asked }) => LATTICES.includes(asked))?.asked ?? null;
  }

  /** Whether points have been sent, or wait to be, behind the message that is being answered. */
  hasNewerPoints() {
    return this.waiting.has("points") || this.expected.slice(1).some(({ asked }) => asked === "points");
  }

  /** Whether the worker would be idle before long: one run of the mesh may wait behind the one that goes on. */
  hasRoom() {
    return this.expected.filter(({ last }) => last === "deformed").length < RUNS;
  }

  isBusyWith(last) {
    return this.expected.some((answer) => answer.last === last);
  }

  /** What waits is out of date when the mesh or the lattice is another one. */
  forgetWaiting() {
    this.waiting.clear();
  }

  receive(message) {
    const answer = this.ended(message);
    this.raise(message.type, message.type === "error" ? { ...message, asked: answer?.asked } : message);
    if (this.waiting.size > 0 && this.hasRoom()) {
      const [kind, newest] = this.waiting.entries().next().value;
      this.waiting.delete(kind);
      this.send(newest);
    }
    this.raise("busy");
  }

  /** Takes what this message ends off the list of answers to come; undefined if it ends none. */
  ended(message) {
    const ends = message.type === "error" || message.type === this.expected[0]?.last;
    if (ends) return this.expected.shift();
    if (message.type !== "superseded") return undefined;
    const dropped = this.expected.findIndex(({ asked }) => asked === "points");
    return this.expected.splice(dropped, 1)[0];
  }

  raise(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  on(type, does) {
    this.addEventListener(type, (event) => does(event.detail));
  }
}
