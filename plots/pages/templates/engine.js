"use strict";
// An engine in the page, in a worker of its own: the library and the adapter that its worker program has. Of what one asks, the newest
// question alone is answered.
const pageEngine = (() => {
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
}

const text = document.getElementById("engine")?.textContent;
return text ? new Engine(text) : null;
})();
