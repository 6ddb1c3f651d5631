"use strict";
// The page's state is a scene with an engine; each change of it is asked anew, and the newest answer is shown.
(() => {
const setup = JSON.parse(document.getElementById("setup").textContent);
const query = new URLSearchParams(location.search), token = query.get("token");
const name = crypto.getRandomValues(new Uint32Array(4)).join("-");
const find = (id) => document.getElementById(id);
const copy = (value) => JSON.parse(JSON.stringify(value));
const parting = 0.01; // rad: histories further apart have parted

// A lesson that the address names has its own scene; a page within a lesson's has no heading of its own.
const lesson = setup.lessons.find((one) => one.name === (query.get("lesson") ?? setup.lesson));
const start = query.has("lesson") && lesson ? { ...setup.start, scene: lesson.scene } : setup.start;
const within = query.has("within");

let state = copy(start), cloud = { runs: 0, kind: "exact" }, sequence = 0;
const shown = { exact: null, engine: null, cloud: [] };
const latest = { exact: null, engine: null, members: 0 }; // ms from input to picture, and of which question
window.live = { latest, shown, state: () => state };

// What a link holds. Throws what is wrong with it, in words; null where it leads to a part of the page, or
// nowhere.
const linked = () => {
  const text = location.hash.slice(1);
  if (text === '' || find(text)) return null;
  const parse = () => {
    try {
      return JSON.parse(decodeURIComponent(text));
    } catch {
      throw Error('it is cut short, or none that this page has made');
    }
  };
  const {state, cloud} = parse() ?? {}, blocks = state?.scene?.blocks;
  if (!Array.isArray(blocks) || !(blocks.length > 0) || blocks.length > setup.blocks)
    throw Error(`state.scene.blocks: must be a list of 1 to ${setup.blocks} blocks`);
  return {state, cloud};
};

// Shows the state of the link, or what is there already and why.
const readLink = () => {
  const before = {state, cloud};
  find('linked').textContent = '';
  try {
    const {state: held = state, cloud: runs} = linked() ?? {};
    [state, cloud] = [{...start, ...held}, {...cloud, ...runs}];
    rebuild();
  } catch (error) {
    ({state, cloud} = before);
    const reason = error instanceof TypeError ? 'something in it is of another kind' : error.message;
    find('linked').textContent =
        `The link does not hold a state that can be shown: ${reason}. This is shown instead.`;
    rebuild();
  }
};

const link = () => "#" + encodeURIComponent(JSON.stringify({ state, cloud }));

const post = async (path, body, signal) => {
  const reply = await fetch(
      path + '?' + new URLSearchParams({token}),
      {method: 'POST', signal, body: JSON.stringify(body), headers: {'Content-Type': 'application/json'}});
  const text = await reply.text();
  if (!reply.ok)
    throw Object.assign(new Error(text.trim()), {again: Number(reply.headers.get('Retry-After'))});
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
      const answer = await post("answer", { page: name, kind: this.kind, sequence: question.sequence, member: question.member ?? 0,
        state: question.state }, stop.signal);
      if (!answer.dropped) this.show(answer, question);
    } catch (error) {
      if (error.again) await new Promise((done) => setTimeout(done, 1000 * error.again));
      if (!error.again && error.name !== 'AbortError')
        complain(this.kind, error, question);
      else if (!stop.signal.aborted)
        this.next ??= question;
    } finally {
      this.stop = null;
      if (this.next) this.send();
    }
  }
}

// All that is wrong, a line each, by what it is wrong with. What is shown is of before as long as it is not the engine alone.
const faults = { fields: "", exact: "", engine: "" };
const tell = (part, words) => {
  faults[part] = words;
  find("error").textContent = [...new Set(Object.values(faults))].filter(Boolean).join("\n");
  find("pictures").classList.toggle("old", Boolean(faults.fields || faults.exact));
};

const complain = (kind, error, question) => {
  if (question.sequence !== sequence) return;
  tell(kind === "exact" ? kind : "engine", error instanceof TypeError ? "The program that serves this page has ended." : error.message);
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

const waiting = []; // for the next exact motion

const lines = {
  exact: new Line("exact", 150, (answer, question) => {
    shown.exact = opened(answer, question);
    if (shown.engine && shown.engine.blocks !== shown.exact.blocks) shown.engine = null;
    tell("exact", answer.failure ? "Exact solution: " + answer.failure : "");
    draw();
    note("exact", answer, question);
    say();
    for (const told of waiting.splice(0)) told();
  }),
  engine: new Line("engine", 300, (answer, question) => {
    shown.engine = opened(answer, question);
    tell("engine", answer.failure ? question.state.engine + ": " + answer.failure : "");
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

const page = { setup, changed: () => changed(), tell: (words) => tell("fields", words.join("\n")),
  get state() { return state; }, get cloud() { return cloud; } };
const rebuild = controlsOf(page);

const offerBlocks = () => {
  const block = find("block"), last = state.scene.blocks.length - 1;
  if (block.options.length === last + 1) return;
  block.replaceChildren();
  for (let k = 0; k <= last; ++k) block.add(new Option(`block ${k + 1}`, k, false, k === last));
};

let writing, clouding;
const changed = () => {
  offerBlocks();
  const question = { state: copy(state), sequence: ++sequence, asked: performance.now() };
  tell("exact", "");
  tell("engine", "");
  const { player } = document.querySelector(".player");
  if (player) player.origin = "";
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
  if (root.player) root.player.show(data);
  else letDrag(root.start(data), (edit) => new Promise((told) => { edit(state.scene); rebuild(); waiting.push(told); changed(); }));
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
  shown.words = [`Exact: ${exact.verdict}.`, exact.ground ? `Ground: ${exact.ground}.` : "", current ? `${state.engine}: ${engine.verdict}. ${told}${warned(engine)}` : "", among.trim()].filter(Boolean).join("\n");
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

// Saving ------------------------------------------------------------------------------------------------------

const download = (name, text) => {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  made("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
};

const save = async (kind) => {
  const name = find("name").value, saved = copy(state), text = JSON.stringify(state.scene), mark = ", changed";
  const known = [start, ...setup.scenes].some(({ scene }) => JSON.stringify(scene) === text);
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
  state = { ...copy(start), scene: copy(scene), engine: state.engine, settings: state.settings, parameters: state.parameters, dt: state.dt };
  find("lesson").hidden = true;
  rebuild();
  changed();
};

// Where its text is: beside this page, or a command that writes it.
const tellLesson = () => {
  const path = setup.pages[lesson.name], title = `“${lesson.title}”`;
  find("lesson").replaceChildren(...path ? ["Lesson ", made("a", { href: `/course/${token}/${path}`, textContent: title })]
    : [`Lesson ${title}: rockstack teach ${lesson.name} --out DIR writes its text, and rockstack live DIR has it with these sliders.`]);
  find("lesson").hidden = false;
};

const begin = () => {
  const own = setup.scenes.findIndex((one) => JSON.stringify(one.scene) === JSON.stringify(start.scene));
  const list = own < 0 ? [{ name: "as started", scene: start.scene }, ...setup.scenes] : setup.scenes;
  list.forEach(({ name }, i) => find("scenes").add(new Option(name, i, false, i === Math.max(0, own))));
  find("scenes").addEventListener("input", (event) => load(list[event.target.value].scene));
  find("again").addEventListener("click", () => {
    state = copy(start);
    find("scenes").value = Math.max(0, own);
    rebuild();
    changed();
  });
  find("large").addEventListener("click", (event) => {
    event.target.setAttribute("aria-pressed", document.body.classList.toggle("large"));
    looks.clear();
    draw();
  });
  find("own").addEventListener("click", (event) => { event.currentTarget.href = "/?" + new URLSearchParams({ token }) + link(); });
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
  addEventListener('hashchange', () => {
    readLink();
    changed();
  });
  document.body.classList.toggle("within", within);
  if (lesson && !within) tellLesson();
  readLink();
  changed();
};
begin();
})();
