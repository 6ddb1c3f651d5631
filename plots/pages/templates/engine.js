"use strict";
// An engine in the page, in a worker of its own: the library and the adapter that its worker program has. Of what one asks, the newest
// question alone is answered.
const pageEngine = (() => {
const samples = 1000; // of a motion that is shown, after the first

// Runs in the worker, behind the library and its adapter.
const serve = () => {
  let engine;
  const ready = adapter((one) => { engine = one; });
  onmessage = async ({ data }) => {
    await ready;
    if (!data) return postMessage({ name: engine.name, settings: engine.solvers[0].settings });
    const { run } = data;
    try {
      const { angles, bodies } = record(engine.start(planck, run), run), blocks = run.blocks.length;
      postMessage({ blocks, dt: run.dt, angles, x: bodies.x, y: bodies.y });
    } catch (error) {
      postMessage({ error: error.message });
    }
  };
};

class Engine {
  constructor(text) {
    this.begun = unpackedText(text).then((bytes) => {
      this.worker = new Worker(URL.createObjectURL(new Blob([bytes, `;(${serve})()`], { type: "text/javascript" })));
      return this.send(null);
    });
  }

  send(question) {
    return new Promise((resolve) => {
      this.worker.onmessage = ({ data }) => resolve(data);
      this.worker.postMessage(question);
    });
  }

  // Its name, and settings [{ name, default, tuned, least, most, unit }].
  about() { return this.begun; }

  // The run of a question as a worker program gets it; null where another one has been asked since.
  async run(question) {
    this.newest = question;
    await this.about();
    while (this.running) await this.running;
    if (this.newest !== question) return null;
    this.running = this.send(question);
    const answer = await this.running;
    this.running = null;
    return this.newest === question ? answer : null;
  }

  // An engine's run as the player reads it.
  async trackOf({ blocks, dt, angles, x, y }) {
    const { name } = await this.begun, count = angles.length / blocks, stride = Math.ceil(count / samples), kept = [];
    for (let i = 0; i < count; i += stride) kept.push(i);
    if (kept.at(-1) !== count - 1) kept.push(count - 1);
    const rows = (...lists) => Float32Array.from(kept.flatMap((i) => Array.from({ length: blocks }, (_, k) => lists.map((list) => list[i * blocks + k])).flat()));
    return { label: `${name}, ${Number((1000 * dt).toPrecision(3))} ms`, colour: "#0072b2", dash: "(8,3)", shown: true, exact: false, impacts: [],
      times: Float32Array.from(kept, (i) => i * dt), angles: rows(angles), places: rows(x, y) };
  }
}

const text = document.getElementById("engine")?.textContent;
return text ? new Engine(text) : null;
})();
