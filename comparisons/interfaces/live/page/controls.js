"use strict";
// The controls of a page: what its state holds, as sliders, numbers and choices. `page` has the state, what there is to choose from
// (`setup`, whose `keys` are what `rockstack keys scene` says), what to do when the state has changed (`changed`), and where to say all
// that is wrong in fields (`tell`).
const made = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

// The number that a text is; null where it is none. A comma is a point where it cannot set thousands apart: "1,5", and not "1,500".
const numberIn = (text) => {
  const plain = text.trim().replace("−", "-"), decimal = /^[+-]?(0,\d+|\d+,(\d{1,2}|\d{4,}))$/;
  if (plain === "inf") return plain;
  const value = plain === "" ? NaN : Number(decimal.test(plain) ? plain.replace(",", ".") : plain);
  return Number.isNaN(value) ? null : value;
};

// Returns what builds them anew.
function controlsOf(page) {
  const home = document.getElementById("controls"), unfolded = new Map();
  const copy = (value) => JSON.parse(JSON.stringify(value));
  const wrong = new Map(); // words on each field whose text is no number
  let count = 0, refits = [];

  const judge = (field, words) => {
    if (words) wrong.set(field, words); else wrong.delete(field);
    if (words) field.setAttribute("aria-invalid", "true"); else field.removeAttribute("aria-invalid");
    page.tell([...wrong.values()]);
  };

  const row = (label, hint, kind, ...inputs) => {
    const id = `control-${++count}`;
    inputs.at(-1).id = id;
    const parts = [made("label", { htmlFor: id, textContent: label }), ...inputs];
    if (hint) {
      for (const input of inputs) input.setAttribute("aria-describedby", id + "-hint");
      parts.push(made("span", { className: "unseen", id: id + "-hint", textContent: hint }));
    }
    return made("div", { className: "control " + kind, title: hint }, ...parts);
  };

  const digits = (value) => Number(Number(value).toPrecision(4));

  // A slider with a number beside it. `log`: equal ways are equal factors. Numbers beyond the slider's range may be typed.
  // `limits` tells the range, which is asked for again where sizes have changed.
  const slider = ({ label, hint = "", limits, log = false, whole = false, get, set }) => {
    const to = (value) => log ? Math.log(value) : value, back = (value) => log ? Math.exp(value) : value;
    const range = made("input", { type: "range" }), number = made("input", { type: "text", inputMode: "decimal" });
    range.setAttribute("aria-label", `${label}, slider`);
    range.dataset.key = label;
    const place = (value) => {
      const [least, most] = limits();
      Object.assign(range, { min: to(least), max: to(most), step: whole && !log ? 1 : (to(most) - to(least)) / 400 });
      range.value = to(value === "inf" ? most : Math.min(most, Math.max(least, value)));
      range.setAttribute("aria-valuetext", value === "inf" ? value : digits(value));
    };
    const put = (value) => {
      judge(number, "");
      set(value);
      page.changed();
    };
    range.addEventListener("input", () => {
      const value = whole ? Math.round(back(Number(range.value))) : digits(back(Number(range.value)));
      number.value = value;
      range.setAttribute("aria-valuetext", value);
      put(value);
    });
    number.addEventListener("change", () => {
      const value = numberIn(number.value);
      if (value === null) return judge(number, `${label} = ${number.value}: must be a number${number.value.includes(",") ? ", with a point" : ""}`);
      put(value);
      place(value);
    });
    const begin = get();
    number.value = begin === "inf" ? begin : Number(Number(begin).toPrecision(6));
    place(begin);
    refits.push(() => place(get()));
    return row(label, hint, "", range, number);
  };

  const choice = ({ label, hint = "", options, get, set }) => {
    const select = made("select");
    for (const [value, text] of options) select.add(new Option(text, value, false, String(value) === String(get())));
    select.addEventListener("input", () => { set(select.value); rebuild(); page.changed(); });
    return row(label, hint, "choice", select);
  };

  const group = (title, open, ...parts) => {
    const box = made("details", { open: unfolded.get(title) ?? open }, made("summary", { textContent: title }), ...parts);
    box.setAttribute("role", "group");
    box.setAttribute("aria-label", title);
    box.addEventListener("toggle", () => unfolded.set(title, box.open));
    return box;
  };

  const between = (least, most) => () => [least, most];
  const scene = () => page.state.scene;
  const table = (name) => (make) => make ? scene()[name] ??= {} : scene()[name];

  // A value in a table of the scene, made where it is missing.
  const key = (home, name, otherwise, entry) => ({
    get: () => { const value = home()?.[name]; return (Array.isArray(value) ? value[entry ?? 0] : value) ?? otherwise; },
    set: (value) => {
      const owner = home(true);
      if (entry === undefined) { owner[name] = value; return; }
      owner[name] ??= scene().blocks.map(() => otherwise);
      owner[name][entry] = value;
    },
  });

  // The tables of keys that have a header; those of a ground motion are several, one for each kind of motion.
  const tables = (header) => page.setup.keys.filter((one) => one.table === header).map((one) => one.keys);
  const defaultOf = ({ default: words }) => words.startsWith('"') ? JSON.parse(words) : words === "inf" ? words : Number(words) || 0;

  // The slider or choice of a key, in a table of the scene. `told` has what this page says or does otherwise.
  const control = (said, home, told = {}) => {
    const name = told.name ?? said.key.replace("_", " "), [least, most] = said.usual ?? [];
    const common = { label: said.unit ? `${name}, ${said.unit}` : name, hint: said.meaning, ...key(home, said.key, defaultOf(said), told.entry) };
    if (said.choices) return choice({ ...common, options: said.choices.map(({ name, words }) => [name, words ? `${name}: ${words}` : name]), ...told });
    return slider({ ...common, limits: between(least, most), log: said.by_factors, whole: said.range.startsWith("a whole number"), ...told });
  };
  const controlOf = (header, name, home, told) => control(tables(header)[0].find((one) => one.key === name), home, told);

  // Blocks --------------------------------------------------------------------------------------------------------

  const slenderness = ({ width, height }) => Math.atan2(width, height);
  const uniformInertia = ({ width, height, mass, density }) => (mass ?? density * width * height) * (width ** 2 + height ** 2) / 12;

  // A block with its centre of mass aside has an inertia of its own, which goes with sizes and mass for as long as it is that of a
  // uniform block.
  const reshape = (block, change) => {
    const uniform = block.inertia === uniformInertia(block);
    change();
    if (uniform) block.inertia = uniformInertia(block);
    for (const refit of refits) refit();
  };
  const moveCentre = (block, axis, value) => {
    block.center_of_mass ??= [0, 0];
    block.inertia ??= uniformInertia(block);
    block.center_of_mass[axis] = value;
    if (block.center_of_mass.some((one) => one !== 0)) return;
    delete block.center_of_mass;
    if (block.inertia === uniformInertia(block)) delete block.inertia;
  };

  const blockGroup = (block, k) => {
    const shaped = (name) => controlOf("[[blocks]]", name, () => block, { set: (value) => reshape(block, () => { block[name] = value; }) });
    const start = (key, name, told) => controlOf("[initial]", key, table("initial"), { name, entry: k, ...told });
    const centre = (name, axis, size) => controlOf("[[blocks]]", "center_of_mass", () => block, { name, limits: () => [-0.49 * block[size], 0.49 * block[size]],
      get: () => block.center_of_mass?.[axis] ?? 0, set: (value) => moveCentre(block, axis, value) });
    return group(`Block ${k + 1}${k === 0 ? " (lowest)" : ""}`, k < 3, shaped("width"), shaped("height"), shaped(block.mass !== undefined ? "mass" : "density"),
      start("angles", "angle", { limits: () => [-0.98 * slenderness(block), 0.98 * slenderness(block)] }), start("velocities", "velocity"),
      centre("centre right", 0, "width"), centre("centre up", 1, "height"));
  };

  // Lists with an entry for each block, besides those of the start.
  const lengthen = (by) => {
    const { initial = {}, contact = {}, restitution } = scene(), lists = [...Object.values(initial), ...Object.values(contact), restitution];
    for (const list of lists.filter(Array.isArray)) by > 0 ? list.push(list.at(-1)) : list.pop();
  };

  const stackGroup = () => {
    const bar = made("div", { className: "bar" }), { blocks } = scene();
    const button = (text, act, there) => {
      const one = made("button", { type: "button", textContent: text, disabled: !there });
      one.addEventListener("click", () => { act(); rebuild(); page.changed(); });
      bar.append(one);
    };
    button("Add a block on top", () => { blocks.push(copy(blocks.at(-1))); lengthen(1); }, blocks.length < page.setup.blocks);
    button("Take the top one off", () => { blocks.pop(); lengthen(-1); }, blocks.length > 1);
    return bar;
  };

  // Ground --------------------------------------------------------------------------------------------------------

  // Each motion that a scene may say in itself, with what it needs, and files.
  const required = (keys) => keys.filter((one) => one.default === "required");
  const withExamples = (keys) => Object.fromEntries(required(keys).map((one) => [one.key, JSON.parse(one.example)]));
  const motions = { none: null };
  for (const keys of tables("[ground.horizontal]"))
    for (const { name } of keys[0].choices ?? []) motions[name] = { ...withExamples(keys), pulse: name };
  motions["made-up earthquake"] = withExamples(tables("[ground.horizontal]").find(([first]) => first.key === "synthetic"));
  for (const record of page.setup.records) motions[record] = { record, scale: 1, ...page.setup.limits };

  // The keys of a motion that have sliders; one that stands instead of another leaves that out.
  const offered = (motion) => {
    const isOf = ({ key, choices }) => key in motion && (!choices || choices.some(({ name }) => name === motion[key]));
    const keys = tables("[ground.horizontal]").find(([first]) => isOf(first));
    const instead = (one) => keys.some((other) => other.key in motion && other.default === "instead of " + one.key);
    return keys.filter((one) => one.usual && (one.key in motion || !one.default.startsWith("instead of ") && !instead(one)));
  };

  // Half of what the squattest block leaves of a right angle, which is what a scene may have, and no more than topples slender ones.
  const steepest = () => Math.min(0.4, ...scene().blocks.map((block) => (Math.PI / 2 - slenderness(block)) / 2));

  const slopeOf = () => controlOf("[ground]", "inclination", table("ground"), { name: "slope", limits: () => [-steepest(), steepest()] });

  const groundGroup = (axis) => {
    const motion = scene().ground?.[axis];
    const now = !motion ? "none" : motion.pulse ?? motion.record ?? (motion.synthetic !== undefined ? "made-up earthquake" : "as the scene has it");
    const names = Object.keys(motions);
    if (!names.includes(now)) names.push(now);
    const pick = choice({ label: "motion", options: names.map((name) => [name, name.split("/").at(-1)]), get: () => now, set: (name) => {
      if (name === now) return;
      const ground = table("ground")(true);
      if (name === "none") delete ground[axis]; else ground[axis] = copy(motions[name]);
    } });
    const parts = (motion ? offered(motion) : []).map((one) => control(one, () => scene().ground[axis], one.key === "synthetic" ? { name: "seed" } : {}));
    return axis === "horizontal" ? group("Ground", true, pick, ...parts, slopeOf()) : group("Ground, vertical", false, pick, ...parts);
  };

  // Contact -------------------------------------------------------------------------------------------------------

  const leavesPivots = (law) => law === "unilateral" || law === "compliant";

  // Without what the law does not have, and with what it needs.
  const setLaw = (law) => {
    scene().law = law;
    if (law === "compliant" && !scene().contact?.bed_stiffness) table("contact")(true).stiffness ??= 1e8;
    if (law !== "compliant" && scene().contact)
      for (const name of ["stiffness", "damping", "tangential", "bed_stiffness", "bed_damping"]) delete scene().contact[name];
    if (law !== "unilateral") for (const name of ["restitution", "restitution_law", "kinetic_friction"]) delete scene().contact?.[name];
    if (leavesPivots(law)) for (const name of ["restitution", "equations"]) delete scene()[name];
  };

  const shapeRatio = ({ width, height }) => digits(Math.max(0, 1 - 1.5 * width ** 2 / (width ** 2 + height ** 2)));

  const ofPivots = () => {
    const ratios = scene().restitution;
    return [choice({ label: "impacts leave", hint: "of the angular velocity, where all above an interface rocks as one body; engines are not told",
      options: [["", "what the law says"], ["given", "a ratio that is given"]], get: () => ratios ? "given" : "",
      set: (given) => { if (given) scene().restitution = scene().blocks.map(shapeRatio); else delete scene().restitution; } }),
    ...(ratios ?? []).map((_, k) => controlOf("", "restitution", scene, { name: `ratio under ${k + 1}`, entry: k })),
    controlOf("", "equations", scene)];
  };

  const lawGroup = () => {
    const contact = table("contact"), { law } = scene(), of = (name, told) => controlOf("[contact]", name, contact, told);
    // A scene states its friction once, which engines may have under an older name.
    const given = key(contact, "friction", scene().engine?.friction ?? 1000);
    const friction = of("friction", { get: given.get, set: (value) => {
      delete scene().engine?.friction;
      given.set(value);
      delete contact().kinetic_friction;
    } });
    const soft = law !== "compliant" ? [] : [of("stiffness"), of("damping")];
    const bouncing = law !== "unilateral" ? [] : [
      of("kinetic_friction", { limits: () => [0.01, given.get()], get: () => key(contact, "kinetic_friction", given.get()).get() }),
      of("restitution", { name: "restitution of points" }),
      of("restitution_law", { set: (law) => Object.assign(contact(true), { restitution: contact(true).restitution ?? 0, restitution_law: law }) })];
    return group("Contact", true, controlOf("", "law", scene, { set: setLaw }), friction, ...bouncing, ...soft, ...(leavesPivots(law) ? [] : ofPivots()));
  };

  const wholeGroup = () => group("Scene", false, controlOf("", "duration", scene), controlOf("", "gravity", scene));

  // Engine and cloud ----------------------------------------------------------------------------------------------

  const parameter = (setting) => {
    const { parameters, settings } = page.state, base = setting[settings];
    const get = () => parameters[setting.name] ?? base;
    const set = (value) => { if (Number(value) === base) delete parameters[setting.name]; else parameters[setting.name] = Number(value); };
    const label = setting.name + (setting.unit ? ", " + setting.unit : "");
    if (setting.choices.length) return choice({ label, options: setting.choices.map((name, i) => [i, name]), get, set });
    const finite = (value, otherwise) => typeof value === "number" && Math.abs(value) < 1e12 ? value : otherwise;
    const most = finite(setting.most, Math.max(1, 100 * Math.abs(base))), least = finite(setting.least, -most);
    const log = least >= 0 && most > 100 * Math.max(base, 1e-30) && base > 0;
    return slider({ label, limits: log ? between(Math.max(least, base / 1e4), Math.min(most, base * 1e4)) : between(least, most), log, whole: setting.whole, get, set });
  };

  const engineGroup = () => {
    const { state } = page, engine = page.setup.engines.find((one) => one.name === state.engine);
    const pick = choice({ label: "engine", options: [["", "none"], ...page.setup.engines.map((one) => [one.name, one.name])], get: () => state.engine,
      set: (name) => { state.engine = name; state.parameters = {}; } });
    if (!engine) return group("Engine", true, pick);
    return group("Engine", true, pick,
      choice({ label: "settings", options: [["tuned", "tuned"], ["default", "default"]], get: () => state.settings, set: (name) => { state.settings = name; state.parameters = {}; } }),
      slider({ label: "step, s", limits: between(1e-4, 2e-2), log: true, get: () => state.dt, set: (value) => { state.dt = value; } }),
      group("More: parameters of the engine", false, ...engine.settings.map(parameter)));
  };

  const cloudGroup = () => {
    const { state, cloud } = page;
    return group("Cloud", true,
      slider({ label: "runs", hint: "scenes that hardly differ", limits: between(0, 50), whole: true, get: () => cloud.runs,
        set: (value) => { cloud.runs = Math.min(100, Math.max(0, Math.round(value))); } }),
      slider({ label: "spread", hint: "largest relative change of sizes, start and ground motion", limits: between(1e-9, 0.1), log: true,
        get: () => state.spread || 1e-3, set: (value) => { state.spread = value; } }),
      choice({ label: "of", options: [["exact", "the exact solver"], ["engine", "the engine"]], get: () => cloud.kind, set: (kind) => { cloud.kind = kind; } }));
  };

  const rebuild = () => {
    const held = document.activeElement?.id, scroll = home.scrollTop;
    [count, refits] = [0, []];
    wrong.clear();
    page.tell([]);
    home.replaceChildren(...scene().blocks.map(blockGroup), stackGroup(), groundGroup("horizontal"), groundGroup("vertical"),
      lawGroup(), engineGroup(), cloudGroup(), wholeGroup());
    home.scrollTop = scroll;
    if (held?.startsWith("control-")) document.getElementById(held)?.focus();
  };
  return rebuild;
}
