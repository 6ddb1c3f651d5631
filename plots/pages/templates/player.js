"use strict";
// What scrolls by itself is reached by keys.
const reach = new ResizeObserver((entries) => {
  for (const { target } of entries) {
    const { overflowX, overflowY } = getComputedStyle(target), scrolls = (overflow) => ["auto", "scroll"].includes(overflow);
    if (scrolls(overflowX) && target.scrollWidth > target.clientWidth || scrolls(overflowY) && target.scrollHeight > target.clientHeight) target.tabIndex = 0;
    else target.removeAttribute("tabindex");
  }
});
for (const one of document.querySelectorAll("figure, pre, nav ul, math, table, .slide")) reach.observe(one);

// Plays the motions of one scene: reads the data that stands beside the canvas, draws blocks to scale, and keeps
// controls, picture and words at the same time.
const startPlayer = (() => {
const { Stack, Part, Track, arrow, contactsOf, drawIcon, iconOf, lastBefore, unpack } = stacks;
const touching = 2e-4; // rad: engines have no patterns; a smaller relative angle counts as closed
const clear = 5e-4; // of the stack's height: blocks that are further from each other do not touch
const steepest = 1.45; // rad: angles are not exaggerated beyond
const captionFont = "12px 'DejaVu Sans', sans-serif";
const longest = 3; // weights: arrows of reactions are drawn no longer
const bandHeight = 32; // of the patterns over the rows of impacts, pixels
const tints = ["#DCE9F5", "#FBE3C4", "#D5EFE3", "#F4D9E6", "#EFEBC0", "#E3DDF3", "#E2E2E2", "#F7D3C5", "#CDE6EC"];

// Kinds of events in words, and what they mean.
const kinds = { opening: ["Opening", ", which starts to rock"], impact: ["Impact", ""],
  closure: ["Closure", ", which stays closed after ever smaller impacts"], rest: ["Rest", ", the last that was open"],
  "lift-off": ["Lift-off", ", where blocks part"],
  slip: ["Slip", ", which starts to slide"], stick: ["Stick", ", which stops sliding that way"],
  corner: ["Corner", ", where the contact passes to another corner"], fall: ["Fall", ", where a block is beside the face below"],
  strike: ["Strike", ", where a block meets the ground or one further down"],
  touch: ["Touch", ", where a corner starts to push"], part: ["Part", ", where a corner stops pushing"],
  impulse: ["Impulse", ", of a push or a step of the ground's velocity"],
  slack: ["Slack", ", where a tendon no longer pulls"], taut: ["Taut", ", where a tendon pulls again"],
  yield: ["Yield", ", where a tendon yields"], unload: ["Unloading", ", where a tendon no longer yields"] };

const subscript = (number) => String(number).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);
const signed = (value, digits) => (Number(value.toFixed(digits)) < 0 ? "−" : "") + Math.abs(value).toFixed(digits);

class Player {
  constructor(root, data) {
    this.find = (name) => root.querySelector("." + name);
    this.time = 0;
    this.playing = false;
    this.frames = 0;
    this.tint = new Map();
    this.tracks = [];
    this.views = new Map(); // of tracks, as they were drawn
    this.load(data);
    this.makeControls();
    if (data.start) this.start(data.start);
    const narrowest = 150; // pixels, in which a motion and its name can be read
    const wide = this.find("stage").clientWidth;
    if (wide && wide < narrowest * this.shown().length) this.find("view").value = "over";
    new ResizeObserver(() => this.resize()).observe(this.find("stage"));
    reach.observe(this.find("scroll-x"));
    this.find("hint").hidden = this.find("hint") !== document.querySelector(".player:not(.compact) .hint"); // once a page
    this.resize();
    this.say();
    root.player = this;
  }

  load(data) {
    const hidden = this.tracks.filter((track) => !track.shown).map((track) => track.label);
    this.stack = new Stack(data.blocks);
    this.tracks = data.tracks.map((track) => new Track(track, data.blocks.length));
    for (const track of this.tracks) if (hidden.includes(track.label)) track.shown = false;
    this.events = data.events;
    this.ground = data.ground ? { times: unpack(data.ground.times), along: unpack(data.ground.values), up: unpack(data.ground.up) } : null;
    this.weight = data.weight;
    this.friction = data.friction;
    this.wall = data.wall;
    this.restraints = data.restraints ?? [];
    this.pushes = (data.pushes ?? []).map((push) => ({ ...push, times: unpack(push.times), forces: unpack(push.forces) }));
    this.horizon = data.horizon;
    this.title = data.title;
    this.end = Math.max(...this.tracks.map((track) => track.end));
    this.most = this.far = this.ways = this.pictured = undefined;
    for (const span of this.events.spans)
      if (!this.tint.has(span[1])) this.tint.set(span[1], tints[this.tint.size % tints.length]);
    this.starts = this.events.spans.map((span) => span[0]);
    this.fitControls();
    this.makeTable();
    this.makeList();
  }

  // Another motion in the place of this one; time and settings stay.
  show(data) {
    const rows = this.shown().length;
    this.held = null;
    this.load(data);
    this.time = Math.min(this.time, this.end);
    if (rows === this.shown().length) this.repaint();
    else this.resize();
    if (!this.playing) this.say();
  }

  makeControls() {
    const speeds = [0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 4];
    const usual = this.end > 8 ? 1 : this.end > 2 ? 0.5 : 0.1;
    for (const speed of speeds)
      this.find("speed").add(new Option(speed + " ×", speed, speed === usual, speed === usual));
    this.find("play").addEventListener("click", () => this.toggle());
    this.find("next").addEventListener("click", () => this.step(1));
    this.find("previous").addEventListener("click", () => this.step(-1));
    this.find("scrub").addEventListener("input", (event) => this.goTo(event.target.value / 1000));
    for (const [name, kind] of [["chatter", "input"], ["events", "toggle"]]) this.find(name).addEventListener(kind, () => this.makeList());
    for (const name of ["view", "forces", "frame", "trace"]) this.find(name).addEventListener("input", () => this.draw());
    this.find("gain").addEventListener("input", () => this.draw());
    this.find("film").hidden = !window.MediaRecorder;
    this.find("film").addEventListener("click", () => this.filming ? this.toggle() : film(this));
    this.find("stage").addEventListener("keydown", (event) => this.key(event));
    const drag = (event) => {
      if (event.type === "pointerdown") event.target.setPointerCapture(event.pointerId);
      if (event.buttons) this.goTo((event.offsetX / event.target.clientWidth) * this.end);
    };
    for (const kind of ["pointerdown", "pointermove"]) this.find("strip").addEventListener(kind, drag);
  }

  // What controls offer of this motion; they are made anew where that has changed.
  fitControls() {
    const forces = this.tracks.some((track) => track.forces), slips = this.tracks.some((track) => track.slipped);
    const offered = JSON.stringify([forces, slips, Boolean(this.friction), Boolean(this.ground), this.end,
      this.tracks.map((track) => track.label)]);
    const swatches = this.find("tracks").querySelectorAll(".swatch");
    if (offered === this.offered)
      return swatches.forEach((swatch, i) => { swatch.style.borderTopColor = this.tracks[i].colour; });
    this.offered = offered;
    for (const [name, there] of [["frame-option", this.ground], ["force-option", forces], ["force-hint", forces], ["cone-hint", forces && this.friction],
      ["slip-hint", slips]]) this.find(name).hidden = !there;
    this.find("view").parentElement.hidden = this.tracks.length === 1;
    this.find("scrub").max = this.end * 1000;
    for (const label of this.find("tracks").querySelectorAll("label")) label.remove();
    this.tracks.forEach((track, place) => this.find("tracks").append(this.checkbox(track, place)));
  }

  // Stands where a page wants it, with its settings made.
  start({ time, speed, gain, overlaid, chatter }) {
    if (speed) this.find("speed").value = speed;
    this.find("gain").value = Math.round(50 * Math.log10(gain));
    this.find("view").value = overlaid ? "over" : "side";
    this.find("chatter").checked = chatter;
    this.time = Math.min(this.end, Math.max(0, time));
  }

  checkbox(track, place) {
    const label = document.createElement("label"), box = document.createElement("input");
    const swatch = document.createElement("span");
    box.type = "checkbox";
    box.checked = track.shown;
    box.addEventListener("input", () => { this.tracks[place].shown = box.checked; this.makeTable(); this.resize(); });
    swatch.className = "swatch";
    swatch.style.borderTopColor = track.colour;
    swatch.style.borderTopStyle = track.dash.length ? "dashed" : "solid";
    label.append(box, swatch, track.label);
    return label;
  }

  makeTable() {
    const blocks = this.stack.half.length;
    const heads = ["", ...Array.from({ length: blocks }, (_, k) => `θ${subscript(k + 1)} (rad)`),
      "contacts, from the ground up",
      ...this.slipHeads(blocks)];
    const row = (cells, kind) => {
      const tr = document.createElement("tr");
      cells.forEach((text, i) => {
        const cell = document.createElement(kind === "th" || i === 0 ? "th" : "td");
        if (cell.tagName === "TH") cell.scope = kind === "th" ? "col" : "row";
        cell.textContent = text;
        tr.append(cell);
      });
      return tr;
    };
    this.find("values").tHead.replaceChildren(row(heads, "th"));
    this.find("values").tBodies[0].replaceChildren(
      ...this.shown().map((track) => row([track.label, ...Array(heads.length - 1).fill("")], "td")));
  }

  slipHeads(blocks) {
    const told = this.tracks.some((track) => track.slipped);
    return Array.from({ length: told ? blocks : 0 }, (_, k) => `slip${subscript(k + 1)} (m)`);
  }

  // The events that N and P stop at, each a button that goes there.
  makeList() {
    const stops = this.stops();
    this.find("events").hidden = !stops.length;
    if (!this.find("events").open) return; // until somebody reads them
    const items = stops.map((stop) => {
      const item = document.createElement("li"), button = document.createElement("button");
      button.type = "button";
      button.textContent = stop[0].toFixed(4) + " s";
      button.addEventListener("click", () => this.goTo(stop[0]));
      item.append(button, iconOf(null, ...this.sidesAt(stop[0]).slice(2)), " " + this.told(stop));
      return item;
    });
    this.find("event-list").replaceChildren(...items);
  }

  shown() { return this.tracks.filter((track) => track.shown); }
  rows() { return this.shown().filter((track) => track.exact || track.impacts.length); }
  gain() { return Math.round(10 ** (this.find("gain").value / 50) * 10) / 10; }
  pattern() { return this.sides()?.[1] ?? ""; }

  key(event) {
    const actions = { " ": () => this.toggle(), n: () => this.step(1), p: () => this.step(-1),
      ArrowRight: () => this.goTo(this.time + this.end / 500), ArrowLeft: () => this.goTo(this.time - this.end / 500) };
    const action = actions[event.key.length > 1 ? event.key : event.key.toLowerCase()];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }

  toggle() {
    this.playing = !this.playing;
    this.find("play").textContent = this.playing ? "⏸ Pause" : "▶ Play";
    if (!this.playing) {
      this.filming?.stop();
      return this.say();
    }
    if (this.time >= this.end) this.time = 0;
    this.clock = undefined;
    this.find("now").setAttribute("aria-live", "off");
    this.nextFrame();
  }

  // The next frame; a film brings its own.
  nextFrame() {
    if (!this.filming) requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    if (!this.playing) return;
    const from = this.time;
    if (this.clock !== undefined) this.time += Math.max(0, now - this.clock) / 1000 * this.find("speed").value * this.slowness();
    this.clock = now;
    ++this.frames;
    const halt = this.find("halt").checked ? this.stops().find(([time]) => time > from && time <= this.time) : null;
    if (halt) {
      this.toggle();
      this.stopAt(halt[0]);
    } else if (this.time >= this.end) {
      this.time = this.end;
      this.toggle();
    } else {
      this.nextFrame();
    }
    this.draw();
    this.filming?.take();
  }

  // A tenth of the speed at an event, all of it some way from there.
  slowness() {
    if (!this.find("slow").checked) return 1;
    const near = this.end / 50, off = Math.min(near, ...this.stops().map(([time]) => Math.abs(time - this.time)));
    return 0.1 + 0.9 * off / near;
  }

  goTo(time) {
    this.time = Math.min(this.end, Math.max(0, time));
    this.clock = undefined;
    this.draw();
    this.say();
  }

  // Events of the exact motion, with those of chatter where they are asked for.
  stops() { return this.events.stops.filter((stop) => this.find("chatter").checked || !stop[4]); }

  told([, number, from, to, , kind]) {
    if (kind === "topple") return `Block ${number} topples: it passes its toppling angle.`;
    const turned = kind === "stick" && contactsOf(to)?.[1][number - 1]; // it slides back at once
    const [word, meaning] = turned ? ["Reversal", ", which slides back"] : kinds[kind];
    return `${word} at interface ${number}${meaning}: ${from === to ? `pattern ${from} stays` : `pattern ${from} becomes ${to}`}.`;
  }

  // To the next or last event of the exact motion; the one that is on now does not count.
  step(direction) {
    if (this.playing) this.toggle();
    const list = this.stops();
    const still = 1e-7;
    const next = direction > 0 ? list.find((stop) => stop[0] > this.time + still)
      : list.findLast((stop) => stop[0] < this.time - still);
    if (!next) return this.say(`No event ${direction > 0 ? "after" : "before"} this time.`);
    this.stopAt(next[0]);
  }

  stopAt(time) {
    this.time = time;
    this.draw();
    this.say(this.stops().filter((stop) => stop[0] === time).map((stop) => this.told(stop)).join(" "));
  }

  // Words for all, spoken only while nothing moves.
  say(extra = "") {
    this.find("now").setAttribute("aria-live", "polite");
    this.find("now").textContent = this.words() + (extra ? " " + extra : "");
    this.find("stage").setAttribute("aria-label", `${this.title}: ${this.words()}`);
  }

  words() {
    const pattern = this.pattern();
    return `${this.time.toFixed(4)} s of ${this.end.toFixed(2)} s` + (pattern ? `, exact pattern ${pattern}.` : ".") + (this.origin ?? "");
  }

  resize() {
    const sharp = window.devicePixelRatio || 1;
    // Where type is large, so is all that the picture is drawn with.
    const strip = this.find("strip"), stage = this.find("stage");
    this.type = parseFloat(getComputedStyle(stage).fontSize) / 16;
    if (stage.clientWidth === 0 && this.band) return; // hidden: what was drawn may still be printed
    strip.style.height = (bandHeight + 4 + 11 * this.rows().length) * this.type + "px";
    for (const canvas of [stage, strip]) {
      canvas.width = 2 * Math.round(canvas.clientWidth * sharp / 2); // even, as H.264 has it
      canvas.height = 2 * Math.round(canvas.clientHeight * sharp / 2);
    }
    this.repaint();
  }

  repaint() {
    const { width, height } = this.find("strip");
    this.band = this.paintBand(width, height, (window.devicePixelRatio || 1) * this.type);
    this.draw();
  }

  draw() {
    this.find("gain-text").textContent = this.gain();
    this.find("scrub").value = this.time * 1000;
    this.find("scrub").setAttribute("aria-valuetext", this.words());
    if (this.playing) this.find("now").textContent = this.words();
    const sides = this.sides();
    if (sides && sides !== this.pictured) iconOf(this.find("icon"), ...(this.pictured = sides).slice(2));
    const rows = this.find("values").tBodies[0].rows;
    this.shown().forEach((track, i) => this.fillRow(rows[i], track));
    this.drawStage();
    this.drawStrip();
  }

  // Sides and ways of sliding: of the exact motion from its pattern, of others as far as they show it.
  contacts(track, parts, angles) {
    const known = track.exact ? this.sides() : null;
    return parts.map((part, k) => {
      if (known) return { side: known[2][k], slide: known[3][k] };
      const relative = angles[k] - (k > 0 ? angles[k - 1] : 0);
      const apart = track.placed && part.gap() > clear * this.stack.height;
      return { side: apart ? 2 : Math.abs(relative) < touching ? 0 : Math.sign(relative), slide: 0 };
    });
  }

  // The span of the exact pattern.
  sides() { return this.sidesAt(this.time); }
  sidesAt(time) { return this.events.spans[Math.max(0, lastBefore(this.starts, time))] ?? null; }

  fillRow(row, track) {
    const angles = track.angles(this.time);
    const contacts = this.contacts(track, this.stack.place(track, this.time, angles), angles);
    const words = { "-1": "left", 0: "closed", 1: "right", 2: "apart" };
    angles.forEach((angle, k) => { row.cells[k + 1].textContent = signed(angle, 5); });
    const ended = this.time > track.end + 1e-9, cell = row.cells[angles.length + 1];
    const told = ended ? "ended" : contacts.map(({ side, slide }) => words[side] + (slide ? slide < 0 ? " ←" : " →" : "")).join(", ");
    if (cell.textContent !== told)
      cell.replaceChildren(...ended ? [] : [iconOf(null, contacts.map(({ side }) => side), contacts.map(({ slide }) => slide))], told);
    if (track.slipped) track.slips(this.time).forEach((slip, k) => {
      row.cells[angles.length + 2 + k].textContent = signed(slip, 4);
    });
  }

  drawStage() {
    const canvas = this.find("stage"), pen = canvas.getContext("2d");
    const sharp = (window.devicePixelRatio || 1) * this.type;
    const width = canvas.width / sharp, height = canvas.height / sharp;
    pen.setTransform(sharp, 0, 0, sharp, 0, 0);
    pen.fillStyle = "#fff"; // which a film needs
    pen.fillRect(0, 0, width, height);
    const shown = this.shown(), over = this.find("view").value === "over";
    const columns = over ? 1 : Math.max(1, shown.length);
    const [across, up] = this.reach();
    const side = Math.max(across, this.stack.width / 2 + Math.max(this.stack.height * this.lean(), 0.35 * this.stack.width));
    const captions = shown.map((track) => this.captionOf(pen, track, width / columns)), ends = [0];
    for (const lines of captions) ends.push((over ? ends.at(-1) : 0) + 3 + 14 * Math.max(1, lines.length));
    const above = 11 + Math.max(17, ...ends);
    const scale = Math.min((width / columns - 12) / (2 * side), (height - 34 - above) / (Math.max(up, this.tallest() * 1.03) + this.rise()));
    this.views.clear();
    shown.forEach((track, i) => {
      const column = over ? 0 : i;
      const middle = (column + 0.5) * width / columns;
      const [right, lift] = this.displacement(this.time);
      const view = { pen, x: (m) => middle + (right + m) * scale, y: (m) => height - 34 - (lift + m) * scale, scale, over, left: middle - width / columns / 2 };
      this.views.set(track, view);
      if (!over || i === 0) this.drawGround(view, middle, width / columns, height);
      this.drawTrack(view, track, i);
      if (this.find("trace").checked) this.drawTrace(view, track);
      this.drawCaption(pen, track, captions[i], over ? 12 : column * width / columns + 8, over ? 18 + ends[i] : 18, width / columns);
    });
  }

  // How far a stack leans to the side at most, as a part of its height; even while angles are exaggerated.
  lean() {
    this.most ??= Math.max(...this.tracks.map((track) =>
      track.values.reduce((most, angle) => Math.max(most, Math.abs(angle)), 0)));
    return Math.max(0.25, Math.sin(Math.min(steepest, this.most * this.gain())));
  }

  // How high the stack's uppermost corner comes at most where every block leans as far as any does.
  tallest() {
    const lean = Math.min(steepest, this.most * this.gain());
    return this.stack.half.reduce((sum, [b, h]) => {
      const angle = Math.min(lean, Math.atan2(b, h));
      return sum + 2 * (h * Math.cos(angle) + b * Math.sin(angle));
    }, 0);
  }

  // How far to the side and up blocks of the first motion with places come, but not beyond four heights.
  reach() {
    this.far ??= (() => {
      const values = this.tracks.find((track) => track.placed)?.placed ?? [], most = [0, 0];
      values.forEach((value, i) => {
        const half = this.stack.half[(i >> 1) % this.stack.half.length];
        most[i % 2] = Math.max(most[i % 2], Math.abs(value) + Math.hypot(...half));
      });
      return most.map((value) => Math.min(value, 4 * (this.stack.height + this.stack.width)));
    })();
    return this.far;
  }

  // The lines of a motion's name.
  captionOf(pen, track, room) {
    if (!track.label) return [];
    pen.font = captionFont;
    const lines = [""];
    for (const word of (track.label + (this.time > track.end + 1e-9 ? " (ended)" : "")).split(" ")) {
      const longer = lines.at(-1) ? `${lines.at(-1)} ${word}` : word;
      if (lines.at(-1) && pen.measureText(longer).width > room - 30) lines.push(word);
      else lines[lines.length - 1] = longer;
    }
    return lines;
  }

  drawCaption(pen, track, lines, x, y, room) {
    if (lines.length === 0) return;
    pen.strokeStyle = track.colour;
    pen.lineWidth = 4;
    pen.setLineDash(track.dash);
    pen.beginPath();
    pen.moveTo(x, y - 4);
    pen.lineTo(x + 18, y - 4);
    pen.stroke();
    pen.setLineDash([]);
    pen.fillStyle = "#1a1a1a";
    pen.font = captionFont;
    pen.textAlign = "left";
    lines.forEach((line, i) => pen.fillText(line, x + 24, y + 14 * i, room - 30));
  }

  // Each end is a block, from 1, 0 the ground, with a point from the middle of its lower face.
  drawRestraint({ pen, x, y }, parts, ends) {
    const [from, to] = ends.map(([block, a, c]) => block ? parts[block - 1].at(a, c) : [a, c]);
    pen.strokeStyle = "#555";
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(x(from[0]), y(from[1]));
    pen.lineTo(x(to[0]), y(to[1]));
    pen.stroke();
  }

  // An arrow up to its point, as long as the force is a share of all weight; an impulse is shown for a tenth of a second.
  drawPush({ pen, x, y }, parts, { point: [block, a, c], direction: [right, up], times, forces, impulses }) {
    const blow = impulses.find(([time]) => time <= this.time && this.time < time + 0.1);
    const force = forces[Math.max(0, lastBefore(times, this.time))] / this.weight, most = 120;
    const length = blow ? 50 * Math.sign(blow[1]) : Math.max(-most, Math.min(most, 160 * force));
    if (!length) return;
    const [right0, up0] = parts[block - 1].at(a, c);
    arrow(pen, x(right0) - length * right, y(up0) + length * up, x(right0), y(up0), "#6b4e00", 2);
  }

  // As far as there is room, and twice as high as the block that stands against it.
  drawWall({ pen, x, y }, middle, room) {
    const [half, high] = this.stack.half[0], face = x(this.wall * half), end = middle + this.wall * (room / 2 - 4);
    if ((end - face) * this.wall <= 0) return;
    pen.fillRect(Math.min(face, end), y(4 * high), Math.abs(end - face), y(0) - y(4 * high));
  }

  drawGround({ pen, y, scale, x }, middle, room, height) {
    pen.fillStyle = "#e4e0d8";
    if (this.wall) this.drawWall({ pen, x, y }, middle, room);
    pen.fillRect(middle - room / 2 + 4, y(0), room - 8, 10);
    pen.strokeStyle = "#555";
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(middle - room / 2 + 4, y(0));
    pen.lineTo(middle + room / 2 - 4, y(0));
    pen.stroke();
    if (!this.ground) return;
    pen.beginPath();
    for (let mark = -20; mark <= 20; ++mark) {
      const place = x(mark * this.stack.width / 2);
      if (Math.abs(place - middle) > room / 2 - 4) continue;
      pen.moveTo(place, y(0));
      pen.lineTo(place - 5, y(0) + 9);
    }
    pen.stroke();
    const at = Math.max(0, lastBefore(this.ground.times, this.time)), side = middle - room / 2 + 8;
    const push = this.ground.along[at] / 9.81, lift = this.ground.up[at] / 9.81, moves = (values) => values.some((value) => value !== 0);
    arrow(pen, x(0), y(0) + 15, x(0) + push * room * 0.4, y(0) + 15, "#6b4e00", 2);
    arrow(pen, side + 8, height / 2, side + 8, height / 2 - lift * height * 0.15, "#6b4e00", 2);
    pen.fillStyle = "#6b4e00";
    pen.font = "11px 'DejaVu Sans', sans-serif";
    pen.textAlign = "left";
    const told = [...moves(this.ground.along) ? [`${signed(push, 2)} g`] : [], ...moves(this.ground.up) ? [`${signed(lift, 2)} g up`] : []];
    pen.fillText(`ground ${told.join(", ") || "0.00 g"}`, side, height - 3);
  }

  // Those that a hand holds, before the motion from there is known.
  anglesNow(track) { return track.exact && this.held || track.angles(this.time); }

  drawnAngles(track) {
    const gain = this.gain(), angles = this.anglesNow(track);
    return gain === 1 ? angles : angles.map((angle) => Math.max(-steepest, Math.min(steepest, angle * gain)));
  }

  drawTrack({ pen, x, y, scale, over, left }, track, order) {
    const real = this.anglesNow(track), angles = this.drawnAngles(track);
    const parts = this.stack.place(track, this.time, angles);
    const contacts = this.contacts(track, parts, real);
    pen.lineJoin = "round";
    for (const part of parts) {
      pen.beginPath();
      part.corners.forEach(([a, c], i) => i ? pen.lineTo(x(a), y(c)) : pen.moveTo(x(a), y(c)));
      pen.closePath();
      pen.globalAlpha = over && order ? 0.08 : 0.14;
      pen.fillStyle = track.colour;
      pen.fill();
      pen.globalAlpha = 1;
      pen.strokeStyle = track.colour;
      pen.lineWidth = !over ? 2 : order ? 1.5 : 4;
      pen.setLineDash(track.dash);
      pen.stroke();
      pen.setLineDash([]);
    }
    parts.forEach((part, k) => this.drawContact({ pen, x, y }, part, contacts[k].side, track.colour));
    for (const ends of this.restraints) this.drawRestraint({ pen, x, y }, parts, ends);
    for (const push of this.pushes) this.drawPush({ pen, x, y }, parts, push);
    parts.forEach((part, k) => this.drawMass({ pen, x, y }, this.stack.centre(part, k), track.colour));
    if (track.forces && this.find("forces").checked) this.drawForces({ pen, x, y, scale, left }, track, parts, contacts);
  }

  // How far the ground has come in the room, to the right and up, m: straight lines between its accelerations, integrated twice.
  displacement(time) {
    const ways = this.groundWays(), at = ways && Math.max(0, lastBefore(this.ground.times, time));
    return ways ? ways.map((way) => way[at]) : [0, 0];
  }

  // How high the ground comes in the picture, m.
  rise() { return this.groundWays()?.[1].reduce((most, way) => Math.max(most, way), 0) ?? 0; }

  groundWays() {
    if (!this.ground || this.find("frame").value === "ground") return null;
    const { times, along, up } = this.ground;
    return this.ways ??= [along, up].map((values) => {
      let velocity = 0, way = 0;
      return Array.from(times, (time, i) => {
        if (i === 0) return 0;
        const dt = time - times[i - 1], [a, b] = [values[i - 1], values[i]];
        way += velocity * dt + (2 * a + b) / 6 * dt * dt;
        velocity += (a + b) / 2 * dt;
        return way;
      });
    });
  }

  // The way of the top block's upper left corner up to now.
  drawTrace({ pen, x, y }, track) {
    const steps = 400, from = Math.max(0, this.time - this.end / 4), now = this.time, [right, lift] = this.displacement(now);
    pen.strokeStyle = track.colour;
    pen.lineWidth = 1;
    pen.beginPath();
    for (let i = 0; i <= steps; ++i) {
      this.time = from + (now - from) * i / steps;
      const [a, c] = this.stack.place(track, this.time, this.drawnAngles(track)).at(-1).corners[3];
      const [to, high] = this.displacement(this.time);
      pen.lineTo(x(a + to - right), y(c + high - lift));
    }
    this.time = now;
    pen.stroke();
  }

  drawContact({ pen, x, y }, part, side, colour) {
    pen.strokeStyle = pen.fillStyle = colour;
    if (side === 2) return;
    if (side === 0) {
      const [left, right] = [part.under(part.end(-1)), part.under(part.end(1))];
      pen.lineWidth = 5;
      pen.lineCap = "butt";
      pen.beginPath();
      pen.moveTo(x(left[0]), y(left[1]));
      pen.lineTo(x(right[0]), y(right[1]));
      pen.stroke();
      return;
    }
    const [a, c] = part.under(part.end(side));
    pen.beginPath();
    pen.arc(x(a), y(c), 5, 0, 2 * Math.PI);
    pen.fill();
    pen.strokeStyle = "#fff";
    pen.lineWidth = 1.5;
    pen.stroke();
  }

  drawForces({ pen, x, y, scale, left }, track, parts, contacts) {
    const full = 0.3 * Math.max(this.stack.height, this.stack.width) * scale; // pixels for the weight of all blocks
    const blocks = parts.length, forces = track.reactions(this.time);
    parts.forEach((part, k) => {
      const centre = forces[2 * blocks + k], borne = Number.isFinite(centre), side = !track.exact && contacts[k].side === 2 ? 0 : contacts[k].side;
      if (side === 2 || !track.exact && !borne) return;
      const size = Math.hypot(forces[k], forces[blocks + k]) / this.weight, shown = Math.min(1, longest / size) / this.weight;
      const normal = forces[k] * shown, along = forces[blocks + k] * shown;
      const [a, c] = part.under(borne ? centre : side === 0 ? 0 : part.end(side));
      const face = part.face(side);
      const to = (n, s) => [x(a) + (n * Math.sin(face) + s * Math.cos(face)) * full,
        y(c) - (n * Math.cos(face) - s * Math.sin(face)) * full];
      if (this.friction) this.drawCone(pen, [x(a), y(c)], to, this.friction[k], 1.2 * Math.hypot(normal, along));
      arrow(pen, x(a), y(c), ...to(normal, along), ...track.exact ? ["#5b2a86", 4] : [track.colour, 2]);
      if (track.exact && side === 0 && Number.isFinite(centre)) this.drawCentre(pen, [x(a), y(c)], part.wayToEnd(centre));
    });
    const aside = 0.15 * Math.max(this.stack.width, this.stack.height), reach = Math.min(-this.stack.width / 2, ...parts.flatMap((part) => part.corners.map(([a]) => a)));
    const bar = Math.max(x(reach - aside), left + 48);
    pen.strokeStyle = pen.fillStyle = "#5b2a86";
    pen.lineWidth = 3;
    pen.beginPath();
    pen.moveTo(bar, y(0));
    pen.lineTo(bar, y(0) - full);
    pen.stroke();
    pen.font = "11px 'DejaVu Sans', sans-serif";
    pen.textAlign = "right";
    pen.fillText("weight", bar + 4, y(0) - full - 5);
  }

  // A centre of mass: a circle in quarters, two of them filled.
  drawMass({ pen, x, y }, [a, c], colour) {
    const radius = 5, quarter = Math.PI / 2;
    pen.beginPath();
    pen.arc(x(a), y(c), radius, 0, 4 * quarter);
    pen.fillStyle = "#fff";
    pen.fill();
    pen.beginPath();
    for (const from of [0, 2]) {
      pen.moveTo(x(a), y(c));
      pen.arc(x(a), y(c), radius, from * quarter, (from + 1) * quarter);
    }
    pen.fillStyle = pen.strokeStyle = colour;
    pen.fill();
    pen.lineWidth = 1;
    pen.beginPath();
    pen.arc(x(a), y(c), radius, 0, 4 * quarter);
    pen.stroke();
  }

  // The centre of pressure of a closed face: a ring, and how far it has come from the face's middle to its end.
  drawCentre(pen, [x, y], way) {
    pen.beginPath();
    pen.arc(x, y, 6, 0, 2 * Math.PI);
    pen.fillStyle = "#fff";
    pen.fill();
    pen.strokeStyle = "#5b2a86";
    pen.lineWidth = 2.5;
    pen.stroke();
    const seen = 0.05; // nearer to the middle it is there
    if (way < seen) return;
    pen.font = "bold 12px 'DejaVu Sans', sans-serif";
    pen.textAlign = "center";
    pen.strokeStyle = "#fff"; // so that it can be read on an outline
    pen.strokeText(`${(100 * way).toFixed(1)} %`, x, y + 22);
    pen.fillStyle = "#5b2a86";
    pen.fillText(`${(100 * way).toFixed(1)} %`, x, y + 22);
  }

  // What friction can hold: forces within the angle of friction from the face's normal.
  drawCone(pen, apex, to, friction, length) {
    const angle = Math.atan(friction), size = Math.max(0.3, length);
    const edge = (way) => to(size * Math.cos(angle), way * size * Math.sin(angle));
    pen.beginPath();
    pen.moveTo(...edge(-1));
    pen.lineTo(...apex);
    pen.lineTo(...edge(1));
    pen.fillStyle = "rgba(91, 42, 134, 0.13)";
    pen.fill();
    pen.strokeStyle = "#5b2a86";
    pen.lineWidth = 1;
    pen.stroke();
  }

  // The pattern band and the rows of impacts, painted once for a size.
  paintBand(width, height, sharp) {
    const sheet = document.createElement("canvas");
    [sheet.width, sheet.height] = [Math.max(1, width), Math.max(1, height)];
    const pen = sheet.getContext("2d");
    pen.scale(sharp, sharp);
    const wide = width / sharp, x = (time) => time / this.end * wide;
    pen.font = "12px 'DejaVu Sans', sans-serif";
    pen.textAlign = "center";
    this.events.spans.forEach(([from, name, sides, slides], i) => {
      const to = i + 1 < this.events.spans.length ? this.starts[i + 1] : this.tracks[0].end;
      pen.fillStyle = this.tint.get(name);
      pen.fillRect(x(from), 0, x(to) - x(from) + 0.5, bandHeight);
      const room = x(to) - x(from) - 4, least = 6, icon = 26, middle = (x(from) + x(to)) / 2; // of a letter, of a picture
      const wide = room > least ? pen.measureText(name).width : Infinity, both = room > wide + icon;
      if (both || room > icon) drawIcon(pen, middle - (both ? wide / 2 : 0), bandHeight - 2, bandHeight - 4, sides, slides);
      pen.fillStyle = "#1a1a1a";
      if (both || room > wide && room <= icon) pen.fillText(name, middle + (both ? icon / 2 : 0), bandHeight / 2 + 4);
    });
    this.rows().forEach((track, row) => {
      pen.strokeStyle = track.colour;
      pen.lineWidth = 1.5;
      pen.beginPath();
      for (const time of track.impacts) { pen.moveTo(x(time), bandHeight + 3 + 11 * row); pen.lineTo(x(time), bandHeight + 12 + 11 * row); }
      pen.stroke();
    });
    if (this.horizon !== undefined) {
      pen.fillStyle = "#1a1a1a";
      pen.fillRect(x(this.horizon) - 1, 0, 2, height);
    }
    return sheet;
  }

  drawStrip() {
    const strip = this.find("strip"), pen = strip.getContext("2d");
    pen.clearRect(0, 0, strip.width, strip.height);
    pen.drawImage(this.band, 0, 0);
    pen.fillStyle = "#b00020";
    pen.fillRect(this.time / this.end * strip.width - 1, 0, 2, strip.height);
  }
}

return (root, data) => new Player(root, data);
})();

// The first, as it was before it was started.
const blankPlayer = document.querySelector(".player")?.cloneNode(true);
blankPlayer?.querySelector(".player-data").remove();

// A player without data waits for its page to start it.
for (const root of document.querySelectorAll(".player")) {
  const data = JSON.parse(root.querySelector(".player-data").textContent);
  if (data) startPlayer(root, data);
  else root.start = (first) => startPlayer(root, first);
}

// A word that names a thing gets its colour in the pictures: a motion's, by what its name begins with, or that of a block's curve.
const colourWord = (word, name = word.dataset.colour) => {
  const block = name.match(/^block-(\d+)$/)?.[1], list = stacks.blockColours;
  const track = document.querySelector(".player")?.player?.tracks.find(({ label }) => label.startsWith(name));
  word.dataset.colour = name;
  word.style.setProperty("--colour", (block ? list[(block - 1) % list.length] : track?.colour) ?? "transparent");
  return word;
};
for (const word of document.querySelectorAll("[data-colour]")) colourWord(word);
