"use strict";
// The page that shows one stack as the exact solver and engines move it. What the page itself can solve comes after its first picture.
(() => {
const { Stack, Track, arrow } = stacks;
const colours = ["#0072b2", "#c04a00", "#00804c", "#6a1b9a"], impulse = "#8e24aa";
const samples = 1000; // of a motion, after the first
const speed = 0.5; // of time, as it plays
const pause = 1.6; // s, at an impact that is told
const pauses = 4; // as it plays, at the first impacts that are told
const least = 0.35; // of the largest impulse, for an impact to be told
const between = 0.15; // s, at least, from one that is told to the next
const degrees = 180 / Math.PI;
const still = matchMedia("(prefers-reduced-motion: reduce)").matches;

// Until when two motions agree, s: the first of the second one's times at which an angle is further off, or one of them has ended; null
// where they agree to the end.
const agreement = (exact, other, tolerance) => {
  const { times, values, blocks } = other, step = times[1] - times[0];
  for (let i = 0; i < times.length && times[i] <= exact.end; ++i)
    if (exact.angles(times[i]).some((angle, k) => Math.abs(values[i * blocks + k] - angle) > tolerance)) return times[i];
  return Math.abs(exact.end - other.end) > 2 * step ? Math.min(exact.end, other.end) : null;
};

// Impacts that are told: those that give most, and none right after another one.
const toldOf = (blows) => {
  const size = ([, number, , , impulses]) => Math.hypot(impulses[2 * number - 2], impulses[2 * number - 1]);
  const most = Math.max(0, ...blows.map(size));
  let last = -Infinity;
  return blows.filter((blow) => size(blow) >= least * most && blow[0] - last >= between && ((last = blow[0]), true));
};

const pairs = (list) => Array.from({ length: list.length / 2 }, (_, k) => [list[2 * k], list[2 * k + 1]]);
const longest = (list) => Math.max(1e-9, ...list.map((vector) => Math.hypot(...vector)));

class Front {
  constructor(root, data) {
    Object.assign(this, { root, data, time: 0, playing: false, held: null, views: new Map(), type: 1, own: false, answers: 0 });
    this.find = (name) => root.querySelector("." + name);
    this.stack = new Stack(data.blocks);
    this.step = Math.max(0, data.steps.findIndex((dt) => dt < 0.017));
    this.opened = { track: new Track(data.exact, data.blocks.length), blows: data.blows ?? [] };
    this.engines = data.engines.map(({ name, written, parameters, runs }, i) => ({ name, written, parameters, colour: colours[i % colours.length],
      runs: runs.map((run) => run.failure ? run : { track: new Track(run, data.blocks.length) }) }));
    this.makeCards();
    this.makeControls();
    this.release(this.opened);
    new ResizeObserver(() => { looks.clear(); this.draw(); }).observe(root);
    root.player = this;
  }

  // Everything that is shown is of this release: its exact motion, and engines' runs, one a step.
  release({ track, blows }) {
    this.own = track !== this.opened.track;
    if (!this.own) [this.scene, this.origin] = [JSON.parse(JSON.stringify(this.data.scene)), ""];
    [this.exact, this.told, this.held] = [track, toldOf(blows), null];
    for (const engine of this.engines) engine.shown = this.own ? [] : engine.runs;
    this.find("back").hidden = !this.own;
    this.tell();
  }

  makeCards() {
    const card = (colour, name) => {
      const [item, swatch, words, value] = ["li", "span", "span", "strong"].map((tag) => document.createElement(tag));
      swatch.className = "swatch";
      swatch.style.borderTopColor = colour;
      item.append(swatch, name + " ", words, " ", value);
      this.find("answers").append(item);
      return { item, words, value };
    };
    this.card = card("#1a1a1a", "Exact motion");
    this.card.item.setAttribute("aria-live", "off");
    for (const engine of this.engines) engine.card = card(engine.colour, engine.written);
  }

  makeControls() {
    const { steps, tolerance } = this.data, slider = this.find("steps");
    [slider.max, slider.value] = [steps.length - 1, this.step];
    slider.addEventListener("input", () => {
      this.step = Number(slider.value);
      this.tell();
      this.draw();
      this.simulate();
    });
    for (const place of this.root.querySelectorAll(".tolerance")) place.textContent = `${(tolerance * degrees).toFixed(1)}° (${tolerance} rad)`;
    this.find("play").addEventListener("click", () => this.toggle());
    this.find("next").addEventListener("click", () => this.next());
    this.find("back").addEventListener("click", () => this.reset());
    this.find("stage").addEventListener("keydown", (event) => this.key(event, { " ": () => this.toggle(), n: () => this.next() }));
    const chart = this.find("chart"), by = (change) => () => this.goTo(this.time + change);
    chart.addEventListener("keydown", (event) => this.key(event, { ArrowRight: by(0.02), ArrowUp: by(0.02), ArrowLeft: by(-0.02), ArrowDown: by(-0.02),
      Home: () => this.goTo(0), End: () => this.goTo(this.data.duration) }));
    const scrub = (event) => {
      if (event.type === "pointerdown") chart.setPointerCapture(event.pointerId);
      if (event.buttons) this.goTo(this.reading(event.offsetX, event.offsetY)[0]);
    };
    for (const kind of ["pointerdown", "pointermove"]) chart.addEventListener(kind, scrub);
    chart.setAttribute("aria-valuemin", 0);
    chart.setAttribute("aria-valuemax", this.data.duration);
  }

  key(event, actions) {
    const action = actions[event.key.length > 1 ? event.key : event.key.toLowerCase()];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }

  // What letDrag asks of a player.
  shown() { return [this.exact]; }
  get tracks() { return [this.exact]; }
  gain() { return 1; }
  drawnAngles(track) { return track === this.exact && this.held || track.angles(this.time); }

  // The run of each engine at the slider's step, where it is known.
  run(engine) { return engine.shown[this.step]; }

  // How long each engine agrees.
  tell() {
    const { steps, tolerance } = this.data, dt = steps[this.step], slider = this.find("steps"), output = this.root.querySelector(".step output");
    output.textContent = `${Number((1000 * dt).toPrecision(3))} ms, ${Math.round(1 / dt)} a second`;
    slider.setAttribute("aria-valuetext", output.textContent);
    for (const engine of this.engines) {
      const run = this.run(engine);
      if (run?.track && run.until === undefined) run.until = agreement(this.exact, run.track, tolerance);
      engine.card.item.classList.toggle("absent", !run?.track);
    }
    this.count();
  }

  // Counts while engines agree, as long as it plays; else tells until when they do.
  count() {
    const show = ({ words, value }, told) => {
      if (words.textContent !== told[0]) words.textContent = told[0];
      if (value.textContent !== told[1]) value.textContent = told[1];
    };
    show(this.card, ["is at", `${this.time.toFixed(2)} s`]);
    for (const engine of this.engines) {
      const run = this.run(engine), until = run?.until ?? Infinity, parted = until <= this.time;
      const told = run?.track ? this.playing && !parted ? ["agrees so far", `${this.time.toFixed(2)} s`] : ["agrees until", run.until === null ? "the end" : `${until.toFixed(2)} s`]
        : run ? ["gives up", run.failure] : this.lives(engine) ? ["is computing", "…"] : ["is of the first release", "–"];
      engine.card.item.classList.toggle("parted", parted);
      show(engine.card, told);
    }
  }

  reset() {
    this.release(this.opened);
    this.goTo(0);
    this.toggle();
  }

  goTo(time) {
    this.time = Math.min(this.data.duration, Math.max(0, time));
    this.blow = null;
    this.clock = undefined;
    this.draw();
  }

  // To the next impact that is told, or the first.
  next() {
    const after = this.told.find(([time]) => time > this.time + 1e-9) ?? this.told[0];
    if (!after) return;
    if (this.playing) this.toggle();
    this.goTo(after[0]);
    this.strike(after);
    if (!still) this.animate();
  }

  toggle() {
    this.playing = !this.playing;
    this.find("play").textContent = this.playing ? "Pause" : "Play";
    this.find("answers").setAttribute("aria-live", this.playing ? "off" : "polite");
    if (!this.playing) return this.draw();
    if (this.time >= this.data.duration) this.goTo(0);
    this.clock = undefined;
    this.animate();
  }

  strike(blow) { this.blow = { blow, since: performance.now(), part: still ? 1 : 0 }; }

  animate() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame((now) => {
      this.waiting = false;
      this.frame(now);
      if (this.playing || this.blow?.part < 1) this.animate();
    });
  }

  frame(now) {
    const passed = this.clock === undefined ? 0 : Math.max(0, now - this.clock) / 1000, from = this.time;
    this.clock = now;
    if (this.blow) {
      const gone = (now - this.blow.since) / 1000;
      this.blow.part = Math.min(1, Math.max(0, gone / (0.6 * pause)));
      if (this.playing && gone > pause) this.blow = null;
    } else if (this.playing) {
      this.time = from + passed * speed;
      const blow = this.told.slice(0, pauses).find(([time]) => time > from && time <= this.time);
      if (blow) {
        this.time = blow[0];
        this.strike(blow);
      }
      if (this.time >= this.data.duration) {
        this.time = this.data.duration;
        return this.toggle();
      }
    }
    this.draw();
  }

  draw() {
    this.drawStage();
    this.drawChart();
    this.count();
    const told = this.blow ? this.words(this.blow.blow) : this.origin ?? "";
    if (this.find("told").textContent !== told) this.find("told").textContent = told;
    const chart = this.find("chart");
    chart.setAttribute("aria-valuenow", this.time.toFixed(3));
    chart.setAttribute("aria-valuetext", `${this.time.toFixed(2)} s`);
  }

  words([time, number]) {
    return `${time.toFixed(3)} s: block ${number} lands on ${number > 1 ? `block ${number - 1}` : "the ground"}. Corners take impulses, purple, which turn its velocity at once.`;
  }

  drawStage() {
    const canvas = this.find("stage"), pen = canvas.getContext("2d"), sharp = window.devicePixelRatio || 1, { width, height } = lookOf(canvas);
    const size = [Math.round(width * sharp), Math.round(height * sharp)];
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    pen.setTransform(sharp, 0, 0, sharp, 0, 0);
    pen.clearRect(0, 0, width, height);
    const side = this.stack.width / 2 + 0.4 * this.stack.height, scale = Math.min((width - 12) / (2 * side), (height - 40) / (1.06 * this.stack.height));
    const view = { pen, scale, x: (m) => width / 2 + m * scale, y: (m) => height - 18 - m * scale };
    this.views.set(this.exact, view);
    [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = ["#d9d4c8", "#555", 1];
    pen.fillRect(0, view.y(0), width, 18);
    pen.fillStyle = "#1a1a1a";
    pen.font = "14px 'DejaVu Sans', sans-serif";
    pen.fillText(`${this.time.toFixed(2)} s${this.playing ? `, at ${speed === 0.5 ? "half" : speed} speed` : ""}`, 10, 22);
    const exact = this.drawBlocks(view, this.exact, "#1a1a1a", 7);
    // One in the other, so that all are seen where they agree.
    this.engines.forEach((engine, i) => {
      const run = this.run(engine);
      if (run?.track && !this.held) this.drawBlocks(view, run.track, engine.colour, Math.max(1.5, 4.5 - 1.5 * i));
    });
    if (this.blow) this.drawBlow(view, exact, width);
  }

  drawBlocks({ pen, x, y }, track, colour, width) {
    const parts = this.stack.place(track, this.time, this.drawnAngles(track));
    [pen.strokeStyle, pen.fillStyle, pen.lineWidth, pen.lineJoin] = [colour, "#e9e9e9", width, "round"];
    for (const part of parts) {
      pen.beginPath();
      for (const [a, c] of part.corners) pen.lineTo(x(a), y(c));
      pen.closePath();
      if (track.exact) pen.fill();
      pen.stroke();
    }
    return parts;
  }

  // Impulses at corners, and aside what they make of the velocity of the block that lands: before, after, and the way from one to the other,
  // as far as it has come.
  drawBlow({ pen, x, y, scale }, parts, width) {
    const { blow: [, number, before, after, impulses, sides], part } = this.blow, given = pairs(impulses), block = number - 1;
    const full = 0.26 * this.stack.height * scale, drawn = ([u, v], by) => [u * by, -v * by];
    parts.forEach((one, k) => {
      const foot = one.under(sides[k] ? one.end(sides[k]) : 0);
      const push = drawn(given[k], full * part / longest(given));
      arrow(pen, x(foot[0]), y(foot[1]), x(foot[0]) + push[0], y(foot[1]) + push[1], impulse, 6);
    });
    const velocities = [before, after].map((list) => pairs(list)[block]), [old, late] = velocities.map((one) => drawn(one, full / longest(velocities)));
    const now = old.map((value, i) => value + part * (late[i] - value)), ends = [0, 1].map((i) => [0, old[i], late[i]].sort((a, b) => a - b));
    const [across, high] = ends.map(([low, , most]) => (low + most) / 2), aside = Math.max(0.17 * width, 62);
    const from = [aside - across, y(0.5 * this.stack.height) - high], tip = from.map((value, i) => value + old[i]);
    arrow(pen, ...from, ...tip, "#8a8a8a", 4);
    arrow(pen, ...tip, from[0] + now[0], from[1] + now[1], impulse, 4);
    arrow(pen, ...from, from[0] + now[0], from[1] + now[1], "#1a1a1a", 4);
    pen.font = "13px 'DejaVu Sans', sans-serif";
    pen.textAlign = "center";
    let line = from[1] + ends[1][0] - 74;
    for (const [word, colour] of [[`block ${number}'s velocity`, "#1a1a1a"], ["before", "#666"], ["impulse", impulse], ["after", "#1a1a1a"]]) {
      pen.fillStyle = colour;
      pen.fillText(word, aside, line += 16);
    }
    pen.textAlign = "left";
  }

  // The tilt of the top block over time, and where each engine parts.
  drawChart() {
    const { duration, blocks } = this.data, top = blocks.length - 1, lines = [];
    const curve = (track, colour, width) => {
      track.tilts ??= Array.from(track.times, (_, i) => track.values[i * blocks.length + top] * degrees);
      lines.push({ x: track.times, y: track.tilts, colour, width });
    };
    curve(this.exact, "#1a1a1a", 4);
    const level = (part) => part * Math.max(1, ...lines[0].y.map(Math.abs));
    for (const { runs, shown, colour } of this.engines) {
      const run = shown[this.step], faded = this.own && !run ? runs[this.step] : null;
      if (run?.track) curve(run.track, colour, 1.8);
      if (faded?.track) curve(faded.track, colour + "40", 1.5);
      if (run?.until) lines.push({ x: [run.until, run.until], y: [level(-1), level(1)], colour, width: 1.5, dash: [2, 4] });
    }
    lines.push({ x: [this.time, this.time], y: [level(-1), level(1)], colour: "#b00020", width: 2 });
    this.reading = drawChart(this.find("chart"), { lines, end: duration });
  }

  // What the page itself solves -------------------------------------------------------------------------------

  lives(engine) { return engine.name === "planck" && this.holds?.engine; }

  // From now on blocks are dragged, and engines that the page holds are asked.
  wake(solver, engine, letDrag, share) {
    this.holds = { solver, engine };
    letDrag(this, (edit) => this.change(edit));
    this.find("stage").classList.add("draggable");
    for (const one of document.querySelectorAll(".drags")) one.hidden = false;
    this.makeRelease();
    this.find("release").append(...share.buttons(this));
    this.simulate();
  }

  // What a trial is to share.buttons(): a player that says what it did, and a scene that changes.
  get player() { return this; }
  say(words) {
    this.origin = words;
    this.draw();
  }

  async change(edit) {
    edit(this.scene);
    const answer = await this.holds.solver.ask(this, { scene: this.scene, interval: this.data.duration / samples });
    if (!answer) return;
    if (!answer.track) return this.say(answer.error ?? answer.failure);
    this.release({ track: new Track(answer.track, this.data.blocks.length), blows: answer.stage.blows ?? [] });
    ++this.answers;
    this.draw();
    this.simulate();
  }

  // Asks engines that the page holds for what is not known: the slider's step first, then the others.
  async simulate() {
    const { solver, engine } = this.holds ?? {}, { steps } = this.data;
    for (const one of this.engines.filter((each) => this.lives(each))) {
      const { shown } = one, missing = [this.step, ...steps.keys()].find((step) => !shown[step]);
      if (missing === undefined) continue;
      const question = await solver.ask(one, { scene: this.scene, dt: steps[missing], parameters: one.parameters });
      const run = question?.run ? await engine.run(question) : question;
      if (!run || one.shown !== shown) continue;
      shown[missing] = run.error ? { failure: run.error } : { track: new Track(await engine.trackOf(run), this.data.blocks.length) };
      if (missing === this.step) {
        this.tell();
        this.draw();
      }
      this.simulate();
    }
  }

  // Does by keys what dragging does: a slider for each block's angle.
  makeRelease() {
    this.data.blocks.forEach(({ width, height }, k) => {
      const most = Math.round(0.9 * Math.atan2(width, height) * degrees), input = document.createElement("input"), label = document.createElement("label");
      Object.assign(input, { type: "range", min: -most, max: most, step: 0.5, value: (this.data.scene.initial?.angles?.[k] ?? 0) * degrees });
      label.append(`block ${k + 1} starts at an angle from −${most}° to ${most}° `, input);
      input.addEventListener("input", async () => {
        await this.change((scene) => {
          const angles = scene.initial?.angles ?? scene.blocks.map(() => 0);
          scene.initial = { angles: angles.map((angle, i) => i === k ? input.value / degrees : angle), velocities: angles.map(() => 0) };
        });
        this.goTo(0);
      });
      this.find("release").append(label);
    });
  }
}

const root = document.querySelector(".front"), front = new Front(root, JSON.parse(root.querySelector(".front-data").textContent));
requestAnimationFrame(() => {
  root.first = performance.now(); // ms from opening to the first picture
  if (!still && !document.hidden) front.toggle();
});
addEventListener("DOMContentLoaded", () => {
  const solves = typeof pageSolver !== "undefined" && pageSolver;
  if (solves) front.wake(pageSolver, pageEngine, letDrag, share);
  document.querySelector(".fixed").hidden = Boolean(solves);
});
})();
