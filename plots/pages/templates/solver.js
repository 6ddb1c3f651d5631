"use strict";
// Bytes of a page, compressed and in base 64.
const unpackedText = (text) => {
  const packed = new Blob([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))]);
  return new Response(packed.stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
};

// Solves scenes in a worker, so that the page never waits. Of what one asks, the newest question alone is answered.
const pageSolver = (() => {
const patience = 150; // ms, after which a newer question of the same asker ends the work on an older one

// All that the worker does: texts in, texts out. It calls no system but for what its library asks at the start.
const serve = () => {
  const none = new Proxy({}, { get: () => () => 0 });
  let module, ready;
  const begin = async () => {
    const { exports } = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: none, env: none });
    exports._initialize();
    return exports;
  };
  const answer = (exports, question) => {
    const bytes = new TextEncoder().encode(question + "\0"), place = exports.malloc(bytes.length);
    new Uint8Array(exports.memory.buffer).set(bytes, place);
    const from = exports.answer(place), memory = new Uint8Array(exports.memory.buffer);
    exports.free(place);
    return new TextDecoder().decode(memory.subarray(from, memory.indexOf(0, from)));
  };
  onmessage = async ({ data }) => {
    if (data instanceof WebAssembly.Module) {
      module = data;
      ready = begin();
      return;
    }
    try {
      postMessage(answer(await ready, data));
    } catch (error) { // out of memory, after which nothing of it is of use
      ready = begin();
      postMessage(JSON.stringify({ error: String(error) }));
    }
  };
};

class Solver {
  constructor(text) {
    this.module = unpackedText(text).then((bytes) => WebAssembly.compile(bytes));
    this.address = URL.createObjectURL(new Blob([`(${serve})()`], { type: "text/javascript" }));
    [this.waiting, this.running, this.sent] = [new Map(), null, 0];
  }

  // The answer to a question of exact_answers.hpp; null where `asker` has asked another one since.
  ask(asker, question) {
    return new Promise((resolve) => {
      this.waiting.get(asker)?.resolve(null);
      this.waiting.set(asker, { asker, question, resolve });
      if (!this.running) this.next();
      else if (this.running.asker === asker) setTimeout(() => this.supersede(asker), Math.max(0, patience + this.sent - performance.now()));
    });
  }

  supersede(asker) {
    if (this.running?.asker !== asker || !this.waiting.has(asker) || performance.now() - this.sent < patience) return;
    this.worker.terminate();
    this.worker = null;
    this.done(null);
  }

  done(answer) {
    const { resolve } = this.running;
    this.running = null;
    resolve(answer);
    this.next();
  }

  async next() {
    const [first] = this.waiting.values();
    if (!first || this.running) return;
    this.waiting.delete(first.asker);
    this.running = first;
    this.sent = performance.now();
    if (!this.worker) {
      const module = await this.module;
      this.worker = new Worker(this.address);
      this.worker.onmessage = ({ data }) => this.done(JSON.parse(data));
      this.worker.postMessage(module);
      this.sent = performance.now();
    }
    this.worker.postMessage(JSON.stringify(first.question));
  }
}

const text = document.getElementById("solver")?.textContent;
return text && typeof WebAssembly !== "undefined" ? new Solver(text) : null;
})();
