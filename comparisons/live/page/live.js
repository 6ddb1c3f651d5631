"use strict";
// The page's state is a scene with an engine; each change of it is asked anew, and the newest answer is shown.
(() => {
const setup = JSON.parse(document.getElementById("setup").textContent);
const token = new URLSearchParams(location.search).get("token");
const page = crypto.getRandomValues(new Uint32Array(4)).join("-");
const find = (id) => document.getElementById(id);
const copy = (value) => JSON.parse(JSON.stringify(value));
const parting = 0.01; // rad: histories further apart have parted

let state = copy(setup.start), cloud = { runs: 0, kind: "exact" }, sequence = 0;
const shown = { exact: null, engine: null, cloud: [] };
const latest = { exact: null, engine: null, members: 0 }; // ms from input to picture, and of which question
window.live = { latest, shown, state: () => state };

// The link's state, where there is one that can be read.
const readLink = () => {
  try {
    const linked = JSON.parse(decodeURIComponent(location.hash.slice(1)));
    if (!linked.state?.scene?.blocks) return;
    state = linked.state;
    cloud = { ...cloud, ...linked.cloud };
  } catch { /* a link to a part of the page, or none */ }
};

const link = () => "#" + encodeURIComponent(JSON.stringify({ state, cloud }));

const post = async (path, body, signal) => {
  const reply = await fetch(path, { method: "POST", signal, body: JSON.stringify(body),
    headers: { "Content-Type": "application/json", "X-Rockstack-Token": token } });
  const text = await reply.text();
  if (!reply.ok) throw new Error(text.trim());
  return JSON.parse(text);
};

// One kind of question: the newest waits while an older one is about to be answered, and ends one that takes long.
class Line {
  constructor(kind, patience, show) { Object.assign(this, { kind, patience, show, next: null, stop: null }); }

  ask(question) {
    this.next = question;
    if (!this.stop) return this.send();
    if (performance.now() - this.sent > this.patience) this.stop.abort();
    else setTimeout(() => { if (this.next === question && this.stop) this.stop.abort(); }, this.patience);
  }

  drop() {
    this.next = null;
    this.stop?.abort();
  }

  async send() {
    const question = this.next, stop = new AbortController();
    [this.next, this.stop, this.sent] = [null, stop, performance.now()];
    try {
      const answer = await post("answer", { page, kind: this.kind, sequence: question.sequence, member: question.member ?? 0,
        state: question.state }, stop.signal);
      if (!answer.dropped) this.show(answer, question);
    } catch (error) {
      if (error.name !== "AbortError") complain(error, question);
    } finally {
      this.stop = null;
      if (this.next) this.send();
    }
  }
}

const complain = (error, question) => {
  if (question.sequence !== sequence) return;
  find("error").textContent = error instanceof TypeError ? "The program that serves this page has ended." : error.message;
};

const unpack = (text) => {
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return new Float32Array(bytes.buffer);
};

// A track with its numbers at hand.
const opened = (answer, question) => ({ ...answer, question, blocks: question.state.scene.blocks.length,
  times: answer.track && unpack(answer.track.times), angles: answer.track && unpack(answer.track.angles),
  energyTimes: answer.energy && unpack(answer.energy_times), energies: answer.energy && unpack(answer.energy) });

const note = (kind, answer, question) => {
  latest[kind] = { sequence: question.sequence, server: answer.milliseconds, total: performance.now() - question.asked };
};

const lines = {
  exact: new Line("exact", 150, (answer, question) => {
    shown.exact = opened(answer, question);
    if (shown.engine && shown.engine.blocks !== shown.exact.blocks) shown.engine = null;
    find("error").textContent = answer.failure ? "Exact solution: " + answer.failure : "";
    draw();
    note("exact", answer, question);
    say();
  }),
  engine: new Line("engine", 300, (answer, question) => {
    shown.engine = opened(answer, question);
    if (answer.failure) find("error").textContent = question.state.engine + ": " + answer.failure;
    draw();
    note("engine", answer, question);
    say();
  }),
  cloud: new Line("cloud", 0, (answer, question) => {
    if (question.sequence !== sequence) return;
    if (answer.track) shown.cloud.push(opened(answer, question));
    latest.members = question.member;
    drawFigures();
    if (question.member < cloud.runs) lines.cloud.ask({ ...question, member: question.member + 1 });
    else say();
  }),
};

let writing, clouding;
const changed = () => {
  const question = { state: copy(state), sequence: ++sequence, asked: performance.now() };
  find("error").textContent = "";
  lines.exact.ask(question);
  if (state.engine) lines.engine.ask(question);
  else { lines.engine.drop(); shown.engine = null; }
  lines.cloud.drop();
  shown.cloud = [];
  clearTimeout(clouding);
  if (cloud.runs > 0) clouding = setTimeout(() => {
    const asked = copy(state);
    if (cloud.kind === "exact") asked.engine = "";
    lines.cloud.ask({ state: asked, sequence, member: 1 });
  }, 400);
  clearTimeout(writing);
  writing = setTimeout(() => history.replaceState(null, "", link()), 300);
};

// Pictures ----------------------------------------------------------------------------------------------------

const isStale = () => shown.engine && shown.exact && shown.engine.question.sequence !== shown.exact.question.sequence;

const draw = () => {
  const { exact, engine } = shown;
  if (!exact?.stage) return;
  const tracks = [exact.track];
  if (engine?.track) tracks.push(isStale() ? { ...engine.track, colour: "#999999" } : engine.track);
  const root = document.querySelector(".player"), data = { ...exact.stage, tracks };
  if (root.player) root.player.show(data); else root.start(data);
  find("heading").textContent = exact.stage.title;
  drawFigures();
  fillImpacts();
};

const column = (run, block) => Array.from(run.times, (_, i) => run.angles[i * run.blocks + block]);

// The value of each block at a time, on straight lines.
const at = (run, time, from) => {
  let i = from;
  while (i + 2 < run.times.length && run.times[i + 1] < time) ++i;
  const span = run.times[i + 1] - run.times[i], part = span > 0 ? Math.min(1, Math.max(0, (time - run.times[i]) / span)) : 0;
  return [i, Array.from({ length: run.blocks }, (_, k) =>
    run.angles[i * run.blocks + k] * (1 - part) + run.angles[(i + 1) * run.blocks + k] * part)];
};

// The largest difference of any angle at the times of `run`, as long as both go on.
const difference = (run, from) => {
  const x = [], y = [], end = from.times.at(-1);
  for (let i = 0, place = 0; i < run.times.length && run.times[i] <= end * (1 + 1e-6); ++i) {
    let angles;
    [place, angles] = at(from, run.times[i], place);
    x.push(run.times[i]);
    y.push(Math.max(...angles.map((angle, k) => Math.abs(angle - run.angles[i * run.blocks + k]))));
  }
  return { x, y };
};

// Between the largest and the least angle of any run of the cloud.
const cloudWidth = () => {
  const least = Math.min(...shown.cloud.map((run) => run.times.length)), { times, blocks } = shown.cloud[0], x = [], y = [];
  for (let i = 0; i < least; ++i) {
    x.push(times[i]);
    y.push(Math.max(...Array.from({ length: blocks }, (_, k) => {
      const values = shown.cloud.map((run) => run.angles[i * blocks + k]);
      return Math.max(...values) - Math.min(...values);
    })));
  }
  return { x, y };
};

const logs = ({ x, y }, style) => ({ x, y: y.map((value) => value > 0 ? Math.log10(value) : NaN), ...style });
const partsAt = ({ x, y }) => x[y.findIndex((value) => value > parting)];

const warned = ({ warnings }) => warnings ? ` Its solver has warned ${warnings} times.` : "";

const drawFigures = () => {
  const { exact, engine } = shown;
  if (!exact?.track) return;
  const block = Math.min(find("block").value || exact.blocks - 1, exact.blocks - 1), end = exact.question.state.scene.duration;
  const stale = isStale(), current = engine?.track && !stale ? engine : null, grey = { colour: "#c3a4d8", width: 1 };
  const clouds = shown.cloud.map((run) => ({ x: run.times, y: column(run, block), ...grey }));
  const line = { x: exact.times, y: column(exact, block), colour: "#1a1a1a", width: 2 };
  const blue = { colour: stale ? "#999999" : "#0072b2", dash: [8, 3] };
  const angles = [...clouds, line, ...(engine?.track ? [{ x: engine.times, y: column(engine, block), ...blue }] : [])];
  drawChart(find("angles"), { lines: angles, end });
  const off = current && difference(current, exact), wide = shown.cloud.length > 1 ? cloudWidth() : null;
  drawChart(find("differences"), { lines: [...(wide ? [logs(wide, { colour: "#8e5bb0" })] : []), ...(off ? [logs(off, blue)] : [])],
    end, log: true, mark: Math.log10(parting) });
  drawChart(find("energies"), { lines: [{ x: exact.energyTimes, y: exact.energies, colour: "#1a1a1a", width: 2 },
    ...(current?.energies ? [{ x: current.energyTimes, y: current.energies, ...blue }] : [])], end });
  const parted = off && partsAt(off), spread = wide && partsAt(wide);
  const told = off ? `The engine is at most ${Math.max(...off.y).toPrecision(3)} rad off` +
    (parted === undefined ? " and never parts." : `; it parts from the exact motion at ${parted.toFixed(2)} s.`) : "";
  const among = wide ? ` ${shown.cloud.length} runs of the cloud ` + (spread === undefined ? "stay together." : `part at ${spread.toFixed(2)} s.`) : "";
  shown.words = [`Exact: ${exact.verdict}.`, current ? `${state.engine}: ${engine.verdict}. ${told}${warned(engine)}` : "", among.trim()].filter(Boolean).join("\n");
  find("verdicts").textContent = shown.words;
  find("angles").setAttribute("aria-label", `Angle of block ${block + 1} over time. ${shown.words}`);
  find("differences").setAttribute("aria-label", "Difference of angles over time. " + told + among);
  find("energies").setAttribute("aria-label", `Energy over time: exactly from ${exact.energies[0].toPrecision(3)} to ${exact.energies.at(-1).toPrecision(3)}.`);
};

const fillImpacts = () => {
  const { exact, engine } = shown, current = engine?.impacts && !isStale() ? engine : null, sides = { "-1": "left", 0: "rests", 1: "right" };
  const rows = (exact.impacts ?? []).slice(0, 30).map(([time, interface_, side]) => {
    const near = (current?.impacts ?? []).filter((one) => one[1] === interface_)
      .sort((a, b) => Math.abs(a[0] - time) - Math.abs(b[0] - time))[0];
    const cells = [time.toFixed(4), interface_, sides[side], near ? near[0].toFixed(4) : "", near ? (1000 * (near[0] - time)).toFixed(2).replace("-", "−") : ""];
    const row = document.createElement("tr");
    row.append(...cells.map((text) => { const cell = document.createElement("td"); cell.textContent = text; return cell; }));
    return row;
  });
  find("impacts").tBodies[0].replaceChildren(...rows);
};

let saying;
const say = () => {
  clearTimeout(saying);
  saying = setTimeout(() => {
    const time = (kind) => latest[kind]?.sequence === sequence ? `${latest[kind].total.toFixed(0)} ms` : "computing";
    find("status").textContent = `Exact answer: ${time("exact")}.` + (state.engine ? ` ${state.engine}: ${time("engine")}.` : "") +
      (cloud.runs ? ` Cloud: ${shown.cloud.length} of ${cloud.runs} runs.` : "");
  }, 250);
};

// Controls ----------------------------------------------------------------------------------------------------

const made = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

let controls = 0;
const row = (label, hint, kind, ...inputs) => {
  const id = `control-${++controls}`;
  inputs.at(-1).id = id;
  return made("div", { className: "control " + kind, title: hint }, made("label", { htmlFor: id, textContent: label }), ...inputs);
};

const digits = (value) => Number(Number(value).toPrecision(4));

// A slider with a number beside it. `log`: equal ways are equal factors. Numbers beyond the slider's range may be typed.
const slider = ({ label, hint = "", least, most, log = false, whole = false, get, set }) => {
  const to = (value) => log ? Math.log(value) : value, back = (value) => log ? Math.exp(value) : value;
  const span = to(most) - to(least);
  const range = made("input", { type: "range", min: to(least), max: to(most), step: whole && !log ? 1 : span / 400 });
  const number = made("input", { type: "text", inputMode: "decimal" });
  range.setAttribute("aria-label", `${label}, slider`);
  range.dataset.key = label;
  const place = (value) => { range.value = to(Math.min(most, Math.max(least, value))); range.setAttribute("aria-valuetext", digits(value)); };
  const put = (value) => { set(value); changed(); };
  range.addEventListener("input", () => {
    const value = whole ? Math.round(back(Number(range.value))) : digits(back(Number(range.value)));
    number.value = value;
    range.setAttribute("aria-valuetext", value);
    put(value);
  });
  number.addEventListener("change", () => {
    const text = number.value.trim().replace("−", "-"), value = text === "inf" ? "inf" : Number(text);
    if (text === "" || Number.isNaN(value)) { find("error").textContent = `${label} = ${text}: must be a number`; return; }
    if (value !== "inf") place(value);
    put(value);
  });
  const begin = get();
  number.value = begin === "inf" ? begin : Number(Number(begin).toPrecision(6));
  place(Number(get() === "inf" ? most : get()));
  return row(label, hint, "", range, number);
};

const choice = ({ label, hint = "", options, get, set }) => {
  const select = made("select");
  for (const [value, text] of options) select.add(new Option(text, value, false, String(value) === String(get())));
  select.addEventListener("input", () => { set(select.value); rebuild(); changed(); });
  return row(label, hint, "choice", select);
};

const group = (title, open, ...parts) => {
  const box = made("details", { open: unfolded.get(title) ?? open }, made("summary", { textContent: title }), ...parts);
  box.setAttribute("role", "group");
  box.setAttribute("aria-label", title);
  box.addEventListener("toggle", () => unfolded.set(title, box.open));
  return box;
};
const unfolded = new Map();

// A value in a table of the scene, made where it is missing.
const key = (table, name, otherwise, entry) => ({
  get: () => { const value = table()?.[name]; return (Array.isArray(value) ? value[entry ?? 0] : value) ?? otherwise; },
  set: (value) => {
    const home = table(true);
    if (entry === undefined) { home[name] = value; return; }
    home[name] ??= state.scene.blocks.map(() => otherwise);
    home[name][entry] = value;
  },
});
const inTable = (name) => (make) => make ? state.scene[name] ??= {} : state.scene[name];

const blockGroup = (block, k) => {
  const one = (name, otherwise) => key(() => state.scene.blocks[k], name, otherwise);
  const size = (name, label) => slider({ label, least: 0.1, most: 10, log: true, ...one(name, 1) });
  const mass = block.mass !== undefined ? slider({ label: "mass, kg", least: 1, most: 1e6, log: true, ...one("mass", 1) })
    : slider({ label: "density, kg/m³", least: 100, most: 20000, log: true, ...one("density", 2500) });
  return group(`Block ${k + 1}${k === 0 ? " (lowest)" : ""}`, k < 3, size("width", "width, m"), size("height", "height, m"), mass,
    slider({ label: "angle, rad", hint: "clockwise positive", least: -0.5, most: 0.5, ...key(inTable("initial"), "angles", 0, k) }),
    slider({ label: "velocity, rad/s", least: -2, most: 2, ...key(inTable("initial"), "velocities", 0, k) }));
};

const addBlock = () => {
  const { blocks, initial } = state.scene, top = copy(blocks.at(-1));
  blocks.push(top);
  for (const values of Object.values(initial ?? {})) if (Array.isArray(values)) values.push(values.at(-1));
  lengthenLists(1);
};
const removeBlock = () => {
  state.scene.blocks.pop();
  for (const values of Object.values(state.scene.initial ?? {})) if (Array.isArray(values)) values.pop();
  lengthenLists(-1);
};
// Lists with an entry for each block, besides those of the start.
const lengthenLists = (by) => {
  for (const [table, name] of [[state.scene, "restitution"], ...["friction", "stiffness", "damping"].map((one) => [state.scene.contact, one])])
    if (Array.isArray(table?.[name])) by > 0 ? table[name].push(table[name].at(-1)) : table[name].pop();
};

const stackGroup = () => {
  const bar = made("div", { className: "bar" });
  const button = (text, act, there) => {
    const one = made("button", { type: "button", textContent: text, disabled: !there });
    one.addEventListener("click", () => { act(); rebuild(); changed(); });
    bar.append(one);
  };
  button("Add a block on top", addBlock, state.scene.blocks.length < setup.blocks);
  button("Take the top one off", removeBlock, state.scene.blocks.length > 1);
  return bar;
};

const motions = { none: null, sine: { pulse: "sine", amplitude: 3, period: 0.5, cycles: 1 }, cosine: { pulse: "cosine", amplitude: 3, period: 0.5, cycles: 1 },
  "half-sine": { pulse: "half-sine", amplitude: 3, period: 0.5 }, rectangle: { pulse: "rectangle", amplitude: 3, period: 0.5 },
  ricker: { pulse: "ricker", amplitude: 3, period: 0.5 },
  "mavroeidis-papageorgiou": { pulse: "mavroeidis-papageorgiou", amplitude: 3, period: 0.5, cycles: 2, phase: 0 },
  "made-up earthquake": { synthetic: 1, peak: 4 } };
for (const record of setup.records) motions[record] = { record, scale: 1 };

const groundGroup = (axis) => {
  const motion = state.scene.ground?.[axis];
  const now = !motion ? "none" : motion.pulse ?? motion.record ?? (motion.synthetic !== undefined ? "made-up earthquake" : "as the scene has it");
  const names = Object.keys(motions);
  if (!names.includes(now)) names.push(now);
  const pick = choice({ label: "motion", options: names.map((name) => [name, name.split("/").at(-1)]), get: () => now, set: (name) => {
    if (name === now) return;
    state.scene.ground ??= {};
    if (name === "none") delete state.scene.ground[axis]; else state.scene.ground[axis] = copy(motions[name]);
  } });
  const value = (name, otherwise) => key(() => state.scene.ground[axis], name, otherwise);
  const offered = !motion ? [] : motion.pulse ? [["amplitude", "amplitude, m/s²", -10, 10], ["period", "period, s", 0.05, 5, true], ["start", "start, s", 0, 10]]
    : motion.synthetic !== undefined ? [["peak", "peak, m/s²", 0.1, 15, true], ["synthetic", "seed", 0, 100, false, true], ["frequency", "frequency, Hz", 0.5, 10, true]]
    : motion.peak !== undefined ? [["peak", "peak, m/s²", 0.1, 15, true]] : [["scale", "scale", -3, 3]];
  if (motion?.cycles !== undefined || ["sine", "cosine"].includes(motion?.pulse)) offered.push(["cycles", "cycles", 0.5, 10]);
  if (motion?.phase !== undefined) offered.push(["phase", "phase, rad", -3.15, 3.15]);
  const standard = { start: 0, cycles: 1, scale: 1, frequency: 2.5 };
  return group(axis === "horizontal" ? "Ground" : "Ground, vertical", axis === "horizontal", pick,
    ...offered.map(([name, label, least, most, log, whole]) => slider({ label, least, most, log, whole, ...value(name, standard[name] ?? 0) })));
};

const lawGroup = () => {
  const scene = () => state.scene, contact = inTable("contact");
  const everywhere = (name, otherwise) => ({ get: key(contact, name, otherwise).get, set: (value) => { contact(true)[name] = value; } });
  const soft = state.scene.law === "compliant" ? [slider({ label: "stiffness, N/m", hint: "of each corner; inf: rigid", least: 1e5, most: 1e11, log: true, ...everywhere("stiffness", "inf") }),
    slider({ label: "damping, N·s/m", least: 0, most: 1e6, ...everywhere("damping", 0) })] : [];
  return group("Contact", true,
    choice({ label: "law", options: [["paper", "paper: pivots"], ["consistent", "consistent: pivots"], ["unilateral", "unilateral: slip, lift-off"], ["compliant", "compliant: springs"]],
      get: key(scene, "law", "consistent").get, set: (law) => {
        state.scene.law = law;
        if (law !== "compliant" && state.scene.contact) for (const name of ["stiffness", "damping", "tangential"]) delete state.scene.contact[name];
      } }),
    slider({ label: "friction", hint: "of law unilateral and compliant, and of engines", least: 0.01, most: 1000, log: true,
      ...everywhere("friction", state.scene.engine?.friction ?? 1000) }), ...soft,
    choice({ label: "equations", options: [["nonlinear", "nonlinear"], ["linear", "linear, as the paper has them"], ["small-angle", "small angles"]], ...key(scene, "equations", "nonlinear") }));
};

const wholeGroup = () => {
  const scene = () => state.scene;
  return group("Scene", false, slider({ label: "duration, s", least: 0.5, most: 60, log: true, ...key(scene, "duration", 5) }),
    slider({ label: "gravity, m/s²", least: 1, most: 25, ...key(scene, "gravity", 9.81) }));
};

const parameter = (setting) => {
  const base = setting[state.settings];
  const get = () => state.parameters[setting.name] ?? base;
  const set = (value) => { if (Number(value) === base) delete state.parameters[setting.name]; else state.parameters[setting.name] = Number(value); };
  const label = setting.name + (setting.unit ? ", " + setting.unit : "");
  if (setting.choices.length) return choice({ label, options: setting.choices.map((name, i) => [i, name]), get, set });
  const finite = (value, otherwise) => typeof value === "number" && Math.abs(value) < 1e12 ? value : otherwise;
  const most = finite(setting.most, Math.max(1, 100 * Math.abs(base))), least = finite(setting.least, -most);
  const log = least >= 0 && most > 100 * Math.max(base, 1e-30) && base > 0;
  return slider({ label, least: log ? Math.max(least, base / 1e4) : least, most: log ? Math.min(most, base * 1e4) : most, log, whole: setting.whole, get, set });
};

const engineGroup = () => {
  const engine = setup.engines.find((one) => one.name === state.engine);
  const pick = choice({ label: "engine", options: [["", "none"], ...setup.engines.map((one) => [one.name, one.name])], get: () => state.engine,
    set: (name) => { state.engine = name; state.parameters = {}; } });
  if (!engine) return group("Engine", true, pick);
  return group("Engine", true, pick,
    choice({ label: "settings", options: [["tuned", "tuned"], ["default", "default"]], get: () => state.settings, set: (name) => { state.settings = name; state.parameters = {}; } }),
    slider({ label: "step, s", least: 1e-4, most: 2e-2, log: true, get: () => state.dt, set: (value) => { state.dt = value; } }),
    ...engine.settings.map(parameter));
};

const cloudGroup = () => group("Cloud", true,
  slider({ label: "runs", hint: "scenes that hardly differ", least: 0, most: 50, whole: true, get: () => cloud.runs, set: (value) => { cloud.runs = Math.min(100, Math.max(0, Math.round(value))); } }),
  slider({ label: "spread", hint: "largest relative change of sizes, start and ground motion", least: 1e-9, most: 0.1, log: true, get: () => state.spread || 1e-3, set: (value) => { state.spread = value; } }),
  choice({ label: "of", options: [["exact", "the exact solver"], ["engine", "the engine"]], get: () => cloud.kind, set: (kind) => { cloud.kind = kind; } }));

const rebuild = () => {
  const held = document.activeElement?.id, scroll = find("controls").scrollTop;
  controls = 0;
  find("controls").replaceChildren(...state.scene.blocks.map(blockGroup), stackGroup(), groundGroup("horizontal"), groundGroup("vertical"),
    lawGroup(), engineGroup(), cloudGroup(), wholeGroup());
  find("controls").scrollTop = scroll;
  if (held?.startsWith("control-")) find(held)?.focus();
  const block = find("block"), last = state.scene.blocks.length - 1;
  if (block.options.length !== last + 1) {
    block.replaceChildren();
    for (let k = 0; k <= last; ++k) block.add(new Option(`block ${k + 1}`, k, false, k === last));
  }
};

// Saving ------------------------------------------------------------------------------------------------------

const download = (name, text) => {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  made("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
};

const save = async (kind) => {
  const name = find("name").value, saved = copy(state), text = JSON.stringify(state.scene), mark = ", changed";
  const known = [setup.start, ...setup.scenes].some(({ scene }) => JSON.stringify(scene) === text);
  if (!known && !String(saved.scene.title).endsWith(mark)) saved.scene.title += mark;
  try {
    const files = await post("files", { state: saved, name, runs: cloud.runs });
    download(name + ".toml", files.scene);
    if (kind === "suite") download(name + "-suite.toml", files.suite);
    find("text").textContent = files[kind];
    find("text").hidden = false;
    find("saved").textContent = kind === "suite"
      ? `Saved as ${name}-suite.toml, with its scene ${name}.toml. Where both lie: rockstack compare ${name}-suite.toml --out ${name}-results`
      : `Saved as ${name}.toml. Where it lies: rockstack compare ${name}.toml --quick --out ${name}-results`;
  } catch (error) {
    find("saved").textContent = error.message;
  }
};

const load = (scene) => {
  state = { ...copy(setup.start), scene: copy(scene), engine: state.engine, settings: state.settings, parameters: state.parameters, dt: state.dt };
  find("lesson").hidden = true;
  rebuild();
  changed();
};

const begin = () => {
  const own = setup.scenes.findIndex((one) => JSON.stringify(one.scene) === JSON.stringify(setup.start.scene));
  const list = own < 0 ? [{ name: "as started", scene: setup.start.scene }, ...setup.scenes] : setup.scenes;
  list.forEach(({ name }, i) => find("scenes").add(new Option(name, i, false, i === Math.max(0, own))));
  find("scenes").addEventListener("input", (event) => load(list[event.target.value].scene));
  find("again").addEventListener("click", () => {
    state = copy(setup.start);
    find("scenes").value = Math.max(0, own);
    rebuild();
    changed();
  });
  find("large").addEventListener("click", (event) => {
    event.target.setAttribute("aria-pressed", document.body.classList.toggle("large"));
    looks.clear();
    draw();
  });
  find("link").addEventListener("click", async () => {
    history.replaceState(null, "", link());
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    find("status").textContent = "The link in the address bar holds this state. Once this program has ended, rockstack live 'LINK' opens it again.";
  });
  find("block").addEventListener("input", drawFigures);
  find("save-scene").addEventListener("click", () => save("scene"));
  find("save-suite").addEventListener("click", () => save("suite"));
  find("controls").addEventListener("submit", (event) => event.preventDefault());
  new ResizeObserver(() => { looks.clear(); drawFigures(); }).observe(find("angles"));
  addEventListener("hashchange", () => { readLink(); rebuild(); changed(); });
  if (setup.lesson) {
    find("lesson").textContent = `Lesson “${setup.lesson.title}”: rockstack teach ${setup.lesson.name} --out DIR writes its text.`;
    find("lesson").hidden = false;
  }
  readLink();
  rebuild();
  changed();
};
begin();
})();
