"use strict";
// What readers may change of a scene: blocks of a player, dragged and let go, and sliders in the text. Each change is solved again.
(() => {
const samples = 1000; // of a motion, after the first
const { blockColours: colours, Track } = stacks;
const copy = (value) => JSON.parse(JSON.stringify(value));

const made = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

// Value of a key such as "blocks.2.height"; undefined where the scene does not have it.
const entryOf = (table, part) => Array.isArray(table) ? part - 1 : part;
const valueAt = (scene, key) => key.split(".").reduce((table, part) => table?.[entryOf(table, part)], scene);

// Tables that are missing are made. A block keeps its material when its size changes.
const setValue = (scene, key, value) => {
  const parts = key.split("."), last = parts.pop();
  const home = parts.reduce((table, part) => table[entryOf(table, part)] ??= part === "angles" ? scene.blocks.map(() => 0) : {}, scene);
  const entry = entryOf(home, last);
  if (["width", "height"].includes(entry) && home.mass !== undefined) home.mass *= value / home[entry];
  home[entry] = value;
};

// Where nothing can answer sliders, their place says so.
for (const home of document.querySelectorAll(".try")) {
  const missing = !pageSolver ? "the exact solver" : home.dataset.engine !== undefined && !pageEngine ? "Planck, an engine from npm," : null;
  if (missing) home.before(made("p", { className: "hint", textContent: `This page was made without ${missing} in it: the sliders that belong here are left out.` }));
}
if (!pageSolver) return;

const slenderness = ({ width, height }) => Math.atan2(width, height);

// How an engine starts: its tuned settings, by the roles that some of them have.
const engineAsked = async () => {
  const { settings } = await pageEngine.about();
  return { dt: 1e-3, answers: 0, settings, parameters: Object.fromEntries(settings.map(({ name, tuned }) => [name, tuned])) };
};

// Its parameters, with the coefficient of restitution of a scene that gives one.
const parametersFor = ({ settings, parameters }, { contact }) => !contact?.restitution ? parameters
  : { ...parameters, ...Object.fromEntries(settings.filter(({ role }) => role)
    .map(({ name, role, least }) => [name, role === "restitution" ? contact.restitution : least])) };

// A scene that changes, and the player that shows what comes of it.
class Trial {
  constructor(player, data) {
    Object.assign(this, { player, data, scene: copy(data.scene), shows: [], answers: 0, taken: 0 });
  }

  change(edit) {
    edit(this.scene);
    this.player.origin = "";
    return this.solve();
  }

  async solve() {
    const asked = performance.now(), { duration } = this.scene;
    const answer = await pageSolver.ask(this, { scene: this.scene, interval: duration / samples, branches: this.branches });
    if (!answer) return;
    if (!answer.track) return this.player.say(answer.error ?? answer.failure);
    this.showWith(answer, this.engine ? this.beside : null);
    this.taken = performance.now() - asked; // ms
    ++this.answers;
    if (this.engine) await this.simulate(answer);
  }

  // The engine's motion comes once it is there; until then the last one stands.
  async simulate(answer) {
    const { dt } = this.engine, parameters = parametersFor(this.engine, this.scene);
    const question = await pageSolver.ask(this.engine, { scene: this.scene, dt, parameters });
    const run = question?.run && await pageEngine.run(question);
    if (!run) return question?.error && this.player.say(question.error);
    if (run.error) return this.player.say(run.error);
    this.beside = await pageEngine.trackOf(run);
    this.showWith(answer, this.beside);
    ++this.engine.answers;
  }

  showWith(answer, beside) {
    const others = (answer.others ?? []).map((track) => ({ ...track, impacts: [] }));
    this.others = others.length;
    const before = this.data.tracks.filter((track) => track.exact)
      .map((track) => ({ ...track, label: "as on the page", colour: "#8a8a8a", shown: false, exact: false }));
    this.show({ ...answer.stage, tracks: [answer.track, ...others, ...beside ? [beside] : [], ...before] }, answer);
  }

  show(data, answer) {
    this.player.show(data);
    for (const show of this.shows) show(answer);
  }

  // The page's own motions.
  reset() {
    this.scene = copy(this.data.scene);
    this.player.origin = "";
    if (this.engine || this.branches) return this.solve();
    this.show(this.data, null);
  }
}

// A slider with its value beside it, in a label. With a power, as data-power="10", it gives the exponent. Returns what reads it anew.
const wire = (input, get, set) => {
  const output = input.parentElement.appendChild(made("output")), base = Number(input.dataset.power);
  const tell = (value) => {
    output.textContent = Number(Number(value).toPrecision(3)).toLocaleString("en", { maximumSignificantDigits: 3 }).replace("-", "−");
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.addEventListener("input", () => {
    const value = base ? Number((base ** input.value).toPrecision(3)) : Number(input.value);
    set(value);
    tell(value);
  });
  const fit = () => {
    const value = get() ?? input.defaultValue;
    input.value = base ? Math.log(value) / Math.log(base) : value;
    tell(value);
  };
  fit();
  return fit;
};

// A number in a sentence, which is dragged or changed by keys, as the slider of its keys is.
const wireNumber = (number, sliders) => {
  const input = Array.from(sliders.querySelectorAll("input")).find((one) => one.dataset.keys === number.dataset.number);
  const change = (steps) => {
    input.value = Number(input.value) + steps * input.step;
    input.dispatchEvent(new Event("input"));
  };
  const tell = () => {
    number.textContent = input.nextElementSibling.textContent;
    number.setAttribute("aria-valuenow", input.value);
  };
  const far = 10, keys = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: far, PageDown: -far, Home: -Infinity, End: Infinity };
  Object.assign(number, { tabIndex: 0, role: "slider", title: "Drag to the side, or use arrow keys" });
  for (const [name, value] of [["label", input.labels[0].firstChild.textContent.trim()], ["valuemin", input.min], ["valuemax", input.max]]) number.setAttribute(`aria-${name}`, value);
  number.addEventListener("keydown", (event) => {
    const steps = keys[event.key];
    if (steps === undefined) return;
    event.preventDefault();
    event.stopPropagation(); // slides turn by keys
    if (Number.isFinite(steps)) return change(steps);
    input.value = steps < 0 ? input.min : input.max;
    change(0);
  });
  let from = 0;
  const wide = 4; // pixels a step
  number.addEventListener("pointerdown", (event) => {
    number.setPointerCapture(event.pointerId);
    from = event.clientX;
  });
  number.addEventListener("pointermove", (event) => {
    const steps = event.buttons ? Math.trunc((event.clientX - from) / wide) : 0;
    if (!steps) return;
    from += wide * steps;
    change(steps);
  });
  input.addEventListener("input", tell);
  tell();
  return tell;
};

// Tells in a sentence when something happens for the first time.
const tellEvent = (output, player) => {
  const stop = player.events.stops.find(([, number, , , , kind]) => kind === output.dataset.event && (!output.dataset.interface || number === Number(output.dataset.interface)));
  output.textContent = stop ? `after ${stop[0].toFixed(3)} s` : "at no time";
};

// What a player offers beside its blocks --------------------------------------------------------------------------

// The ground's push, drawn by hand: acceleration over time, m/s².
const groundControls = (trial) => {
  const canvas = made("canvas", { className: "push" }), most = 6, count = 100;
  let pushed = null, read = null, last = null;
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `Acceleration of the ground over time, up to ${most} m/s²; the slider beside it gives a pulse.`);
  const paint = () => {
    const x = pushed ? pushed.map((_, i) => i * trial.scene.duration / count) : [0, trial.scene.duration];
    looks.delete(canvas);
    read = drawChart(canvas, { lines: [{ x, y: pushed ?? [0, 0], colour: "#6b4e00", width: 2 }, { x: [0, 0], y: [-most, most], colour: "#0000" }], end: trial.scene.duration });
  };
  const draw = (event) => {
    if (!event.buttons) return;
    if (event.type === "pointerdown") {
      canvas.setPointerCapture(event.pointerId);
      last = null;
    }
    pushed ??= Array(count + 1).fill(0);
    const [time, value] = read(event.offsetX, event.offsetY), at = [time / trial.scene.duration * count, Math.max(-most, Math.min(most, value))];
    const [from, to] = [last ?? at, at].sort((a, b) => a[0] - b[0]);
    for (let i = Math.max(0, Math.round(from[0])); i <= Math.min(count, Math.round(to[0])); ++i)
      pushed[i] = to[0] > from[0] ? from[1] + (to[1] - from[1]) * (i - from[0]) / (to[0] - from[0]) : at[1];
    last = at;
    paint();
    trial.change((scene) => {
      scene.ground ??= {};
      scene.ground.horizontal = { samples: [...pushed], interval: scene.duration / count };
    });
  };
  for (const kind of ["pointerdown", "pointermove"]) canvas.addEventListener(kind, draw);
  new ResizeObserver(() => { if (canvas.clientWidth) paint(); }).observe(canvas);
  trial.shows.push(() => {
    if (trial.scene.ground?.horizontal?.samples?.length !== count + 1) pushed = null;
    paint();
  });
  const pulse = made("input", { type: "range", min: -8, max: 8, step: 0.1 }), key = "ground.horizontal.amplitude";
  const fit = wire(made("label", {}, "ground's pulse, m/s² ", pulse).lastChild, () => trial.scene.ground?.horizontal?.amplitude ?? 0,
    (value) => trial.change((scene) => {
      const { horizontal } = scene.ground ??= {};
      if (horizontal?.pulse) setValue(scene, key, value);
      else scene.ground.horizontal = { pulse: "sine", amplitude: value, period: 0.5 };
    }));
  trial.shows.push(fit);
  return made("details", {}, made("summary", { textContent: "Push the ground: draw, or slide" }), pulse.parentElement, canvas);
};

// What an engine's sliders change; lengthUnit scales Planck's slop, which is 0.005 of it.
const knobs = [["dt", "step, s", -4, -1.7, 0.02, 10], ["velocityIterations", "velocity iterations", 1, 60, 1],
  ["positionIterations", "position iterations", 0, 20, 1], ["lengthUnit", "length unit, m", -3, 0.5, 0.05, 10]];

const wireKnob = (input, trial) => {
  const name = input.dataset.setting, home = () => name === "dt" ? trial.engine : trial.engine.parameters;
  wire(input, () => home()[name], (value) => { home()[name] = value; trial.solve(); });
};

const engineControls = (trial) => {
  const box = made("details", {}, made("summary", { textContent: "An engine in this page, beside the exact motion" }));
  const tick = made("input", { type: "checkbox" }), sliders = made("div", { className: "knobs", hidden: true });
  box.append(made("label", {}, tick, " Planck, Box2D's port to JavaScript"), sliders);
  tick.addEventListener("input", async () => {
    trial.engine = tick.checked ? trial.engineKept ??= await engineAsked() : null;
    if (!sliders.children.length) for (const [name, label, min, max, step, power] of knobs) {
      const input = made("input", { type: "range", min, max, step });
      input.dataset.setting = name;
      if (power) input.dataset.power = power;
      sliders.append(made("label", {}, label + " ", input));
      wireKnob(input, trial);
    }
    sliders.hidden = !tick.checked;
    trial.solve();
  });
  return box;
};

// Does it by keys: a slider for each block's angle.
const releaseControls = (player, trial) => {
  const box = made("fieldset", { className: "release" }, made("legend", { textContent: "Release: drag a block and let go, or slide" }));
  const fits = trial.scene.blocks.map((block, k) => {
    const most = Math.round(98 * slenderness(block)) / 100, key = `initial.angles.${k + 1}`;
    const input = made("input", { type: "range", min: -most, max: most, step: most / 200 });
    box.append(made("label", {}, `block ${k + 1} starts at, rad `, input));
    return wire(input, () => valueAt(trial.scene, key), (value) => trial.change((scene) => {
      setValue(scene, key, value);
      player.time = 0;
    }));
  });
  const back = made("button", { type: "button", textContent: "Back to the page's scene", disabled: true });
  back.addEventListener("click", () => trial.reset());
  box.append(back, ...share.buttons(trial), groundControls(trial), ...pageEngine ? [engineControls(trial)] : []);
  trial.shows.push((answer) => {
    back.disabled = !answer;
    for (const fit of fits) fit();
  });
  player.find("tracks").before(box);
};

// Sliders in the text --------------------------------------------------------------------------------------------

// A curve for each block: its angle, or how far its centre has risen over the ground.
const unpacked = ({ times, values, placed, blocks }, rises) => Array.from({ length: blocks }, (_, k) =>
  Array.from(times, (_, i) => rises ? placed ? placed[2 * (i * blocks + k) + 1] - placed[2 * k + 1] : 0 : values[i * blocks + k]));

// Colours in words, for as many blocks as a caption can name.
const colourWords = ["blue", "orange", "green", "pink", "yellow", "light blue"];

// These curves of the motion, those of the page in grey, dashed above the lowest block.
const drawCurves = (canvas, trial, first) => {
  const [track, ...others] = trial.player.tracks, lines = [];
  unpacked(first, trial.rises).forEach((y, k) => lines.push({ x: first.times, y, colour: "#808080", width: 3, dash: k ? [10, 4] : [] }));
  const beside = trial.engine && trial.player.tracks.find((one) => one.label === trial.beside?.label);
  if (beside) for (const y of unpacked(beside, trial.rises)) lines.push({ x: beside.times, y, colour: "#1a1a1a", width: 1.5, dash: [6, 3] });
  if (track !== first) unpacked(track, trial.rises).forEach((y, k) => lines.push({ x: track.times, y, colour: colours[k % colours.length], width: 1.5 }));
  for (const other of others.slice(0, trial.others))
    for (const y of unpacked(other, trial.rises)) lines.push({ x: other.times, y, colour: other.colour, width: 1.5, dash: [2, 3] });
  looks.delete(canvas);
  drawChart(canvas, { lines, end: Math.max(first.end, track.end) });
};

const firstEvents = (player) => {
  const seen = new Set(), told = player.events.stops.filter((stop) => !stop[4] && !seen.has(stop[5]) && seen.add(stop[5])).slice(0, 3);
  return told.map((stop) => `${stop[0].toFixed(4)} s: ${player.told(stop)}`).join(" ");
};

// The exact solver's words as sentences. What makes its motion doubtful comes first in them, or nothing does.
const sentences = (verdict) => {
  const [, doubt, outcome] = verdict.match(/^((?:from|stopped|not) .*?); (.*)$/) ?? [null, null, verdict];
  return (doubt ? `It is ${doubt}. ` : "") + (outcome.startsWith("block") ? "B" + outcome.slice(1) : "It " + outcome) + ".";
};

// Sliders that begin with a scene of their own are held against its motion, the others against that of the text.
const makeTrial = async (home, page) => {
  const withEngine = home.dataset.engine !== undefined, rises = home.dataset.rises !== undefined, what = rises ? "Rise of the centre" : "Angles";
  if (withEngine && !pageEngine) return;
  home.hidden = false;
  const scene = { ...page.scene, ...JSON.parse(home.dataset.scene ?? "{}") };
  const own = home.dataset.scene ? await pageSolver.ask(home, { scene, interval: scene.duration / samples }) : null;
  const data = { ...page, ...own?.stage, tracks: own ? [own.track] : page.tracks.filter((track) => track.exact).slice(0, 1), scene };
  const begun = own ? "as the sliders began" : "as in the text";
  const root = blankPlayer.cloneNode(true), id = `try-${document.querySelectorAll(".try .player").length + 1}`;
  root.id = id;
  root.classList.add("compact");
  root.querySelector(".stage").id = id + "-stage";
  const sliders = made("div", { className: "sliders" }, ...home.children), canvas = made("canvas", { className: "curves" });
  // On a slide long words scroll, and what scrolls is reached by keys.
  const told = made("p", { className: "told", ...home.closest(".slide") ? { tabIndex: 0 } : {} });
  canvas.setAttribute("role", "img");
  told.setAttribute("role", "status");
  const blocks = data.blocks.map((_, k) => colourWord(made("span", { textContent: `block ${k + 1} ${colourWords[k % colours.length]}` }), `block-${k + 1}`));
  const caption = made("figcaption", {}, `${what} over time, ${rises ? "m" : "rad"}: `, ...blocks.flatMap((word, k) => k ? [", ", word] : [word]), `. Grey: ${begun}${blocks.length > 1 ? ", dashed above block 1" : ""}.`,
    withEngine ? " Dashed: the engine." : "", home.dataset.branches !== undefined ? " Dotted: other motions that satisfy the laws." : "");
  home.append(made("div", {}, sliders, made("figure", {}, canvas, caption), told), root);
  const player = startPlayer(root, data), trial = new Trial(player, data), first = player.tracks[0];
  trial.branches = home.dataset.branches !== undefined;
  trial.rises = rises;
  if (trial.branches) player.find("view").value = "over";
  const asInText = `Grey is the motion ${begun}. ${firstEvents(player)}`;
  const tell = (words) => {
    told.textContent = words;
    canvas.setAttribute("aria-label", `${what} over time. ${words}`);
  };
  tell(asInText);
  reach.observe(told);
  const draw = () => { if (canvas.clientWidth) drawCurves(canvas, trial, first); };
  letDrag(player, (edit) => trial.change(edit));
  if (withEngine) {
    trial.engine = await engineAsked();
    for (const input of sliders.querySelectorAll("[data-setting]")) wireKnob(input, trial);
  }
  const fits = Array.from(sliders.querySelectorAll("[data-keys]"), (input) => {
    const keys = input.dataset.keys.split(" ");
    return wire(input, () => valueAt(trial.scene, keys[0]), (value) => trial.change((scene) => { for (const key of keys) setValue(scene, key, value); }));
  });
  for (const number of sliders.querySelectorAll("[data-number]")) fits.push(wireNumber(number, sliders));
  const tellEvents = () => { for (const output of sliders.querySelectorAll("[data-event]")) tellEvent(output, player); };
  tellEvents();
  const back = made("button", { type: "button", textContent: begun.replace("a", "A") });
  back.addEventListener("click", () => trial.reset());
  sliders.append(back, ...share.buttons(trial));
  trial.shows.push((answer) => {
    for (const fit of fits) fit();
    tellEvents();
    tell(answer ? `${sentences(answer.verdict)}${trial.others ? ` Other motions that satisfy the laws: ${trial.others}.` : ""} ${firstEvents(player)}` : asInText);
    draw();
  });
  new ResizeObserver(draw).observe(canvas);
  home.trial = trial;
  if (withEngine || trial.branches) trial.solve();
};

for (const root of document.querySelectorAll(".player")) {
  const data = JSON.parse(root.querySelector(".player-data").textContent);
  if (!data?.scene || !data.tracks.some((track) => track.exact)) continue;
  root.trial = new Trial(root.player, data);
  letDrag(root.player, (edit) => root.trial.change(edit));
  releaseControls(root.player, root.trial);
}
// Pictures that move -------------------------------------------------------------------------------------------

const sceneOfPage = () => Array.from(document.querySelectorAll(".player")).find((root) => root.trial).trial.data.scene;

// When the first of these motions is further from the first one than a tolerance, s; its end where none ever is.
const partingOf = ([first, ...others], blocks, tolerance) => {
  const exact = new Track(first, blocks), motions = others.map((track) => new Track(track, blocks));
  return exact.times.find((time) => motions.some((motion) => motion.angles(time).some((angle, k) => Math.abs(angle - exact.angles(time)[k]) > tolerance))) ?? exact.end;
};

// Trial of a word: the exact motion of its own scene, some whose sizes hardly differ, and the engine's at a step.
const makeMoving = async (home, place) => {
  const { scene: text, speed = 0.5, gain = 1, members = 0, spread = 0, step, moves, horizon } = home.dataset, scene = text ? JSON.parse(text) : sceneOfPage(), interval = scene.duration / samples;
  const answer = await pageSolver.ask(home, { scene, interval }), tracks = [answer.track], most = 6; // that are named
  for (let member = 1; member <= members; ++member) {
    const { track } = await pageSolver.ask(home, { scene, interval, member, spread: Number(spread) });
    tracks.push({ ...track, label: members > most ? "" : `replicate ${member}`, colour: colours[member % colours.length], dash: "solid", shown: true, exact: false, impacts: [] });
  }
  if (step) tracks.push(await pageEngine.trackOf(await pageEngine.run(await pageSolver.ask(home, { ...await engineAsked(), scene, dt: Number(step) }))));
  const root = blankPlayer.cloneNode(true);
  Object.assign(root, { id: `moving-${place}`, hidden: false });
  root.classList.add("compact");
  root.querySelector(".stage").id = root.id + "-stage";
  root.querySelector(".forces").checked = !tracks[1]; // others would lie over them
  const parted = horizon && partingOf(tracks, scene.blocks.length, Number(horizon));
  const told = parted && ` All ${tracks.length} are within ${horizon} rad of the first ${parted < scene.duration ? `until ${parted.toFixed(2)} s, the black line under the picture` : "to the end"}.`;
  home.append(root, made("figcaption", { textContent: `${scene.title}.${told || ""}` }));
  const player = startPlayer(root, { ...answer.stage, tracks, ...parted ? { horizon: parted } : {}, start: { time: 0, speed, gain, overlaid: true, chatter: false } });
  if (moves !== undefined && !matchMedia("(prefers-reduced-motion: reduce)").matches) player.toggle();
};

document.querySelectorAll(pageEngine ? ".moving" : ".moving:not([data-step])").forEach((home, place) => {
  const watch = new IntersectionObserver(([{ isIntersecting }]) => {
    if (!isIntersecting) return;
    watch.disconnect();
    makeMoving(home, place);
  });
  watch.observe(home);
});

const shown = Array.from(document.querySelectorAll(".player")).find((root) => root.trial);
if (shown) for (const home of document.querySelectorAll(".try")) makeTrial(home, shown.trial.data);
})();
