"use strict";
// The controls of a page: what its state holds, as sliders, numbers and choices. `page` has the state, what there is to choose from
// (`setup`), what to do when the state has changed (`changed`), and where to say all that is wrong in fields (`tell`).
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
    const shaped = (label, name, least, most) => slider({ label, limits: between(least, most), log: true, get: () => block[name],
      set: (value) => reshape(block, () => { block[name] = value; }) });
    const start = (label, name, limits, hint) => slider({ label, hint, limits, ...key(table("initial"), name, 0, k) });
    const centre = (label, axis, size) => slider({ label, hint: "centre of mass from the middle of the block; for the exact solver",
      limits: () => [-0.49 * block[size], 0.49 * block[size]], get: () => block.center_of_mass?.[axis] ?? 0, set: (value) => moveCentre(block, axis, value) });
    return group(`Block ${k + 1}${k === 0 ? " (lowest)" : ""}`, k < 3, shaped("width, m", "width", 0.1, 10), shaped("height, m", "height", 0.1, 10),
      block.mass !== undefined ? shaped("mass, kg", "mass", 1, 1e6) : shaped("density, kg/m³", "density", 100, 20000),
      start("angle, rad", "angles", () => [-0.98 * slenderness(block), 0.98 * slenderness(block)], "clockwise positive"),
      start("velocity, rad/s", "velocities", between(-2, 2), "clockwise positive"),
      centre("centre right, m", 0, "width"), centre("centre up, m", 1, "height"));
  };

  // Lists with an entry for each block, besides those of the start.
  const lengthen = (by) => {
    const lists = Object.values(scene().initial ?? {});
    lists.push(scene().restitution, ...["friction", "stiffness", "damping"].map((one) => scene().contact?.[one]));
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

  const motions = { none: null, sine: { pulse: "sine", amplitude: 3, period: 0.5, cycles: 1 }, cosine: { pulse: "cosine", amplitude: 3, period: 0.5, cycles: 1 },
    "half-sine": { pulse: "half-sine", amplitude: 3, period: 0.5 }, rectangle: { pulse: "rectangle", amplitude: 3, period: 0.5 },
    ricker: { pulse: "ricker", amplitude: 3, period: 0.5 },
    "mavroeidis-papageorgiou": { pulse: "mavroeidis-papageorgiou", amplitude: 3, period: 0.5, cycles: 2, phase: 0 },
    "made-up earthquake": { synthetic: 1, peak: 4 } };
  for (const record of page.setup.records) motions[record] = { record, scale: 1, ...page.setup.limits };

  // Half of what the squattest block leaves of a right angle, which is what a scene may have, and no more than topples slender ones.
  const steepest = () => Math.min(0.4, ...scene().blocks.map((block) => (Math.PI / 2 - slenderness(block)) / 2));

  const slopeOf = () => slider({ label: "slope, rad", hint: "of the ground, down to the right; the picture is along it",
    limits: () => [-steepest(), steepest()], ...key(table("ground"), "inclination", 0) });

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
    const offered = !motion ? [] : motion.pulse ? [["amplitude", "amplitude, m/s²", -10, 10], ["period", "period, s", 0.05, 5, true], ["start", "start, s", 0, 10]]
      : motion.synthetic !== undefined ? [["peak", "peak, m/s²", 0.1, 15, true], ["synthetic", "seed", 0, 100, false, true], ["frequency", "frequency, Hz", 0.5, 10, true]]
      : motion.peak !== undefined ? [["peak", "peak, m/s²", 0.1, 15, true]] : [["scale", "scale", -3, 3]];
    if (motion?.cycles !== undefined || ["sine", "cosine"].includes(motion?.pulse)) offered.push(["cycles", "cycles", 0.5, 10]);
    if (motion?.phase !== undefined) offered.push(["phase", "phase, rad", -3.15, 3.15]);
    const standard = { start: 0, cycles: 1, scale: 1, frequency: 2.5 };
    const parts = offered.map(([name, label, least, most, log, whole]) => slider({ label, limits: between(least, most), log, whole,
      ...key(() => scene().ground[axis], name, standard[name] ?? 0) }));
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
    if (law !== "unilateral") for (const name of ["restitution", "restitution_law"]) delete scene().contact?.[name];
    if (leavesPivots(law)) for (const name of ["restitution", "equations"]) delete scene()[name];
  };

  const shapeRatio = ({ width, height }) => digits(Math.max(0, 1 - 1.5 * width ** 2 / (width ** 2 + height ** 2)));

  const ofPivots = () => {
    const ratios = scene().restitution;
    return [choice({ label: "impacts leave", hint: "of the angular velocity, where all above an interface rocks as one body; engines are not told",
      options: [["", "what the law says"], ["given", "a ratio that is given"]], get: () => ratios ? "given" : "",
      set: (given) => { if (given) scene().restitution = scene().blocks.map(shapeRatio); else delete scene().restitution; } }),
    ...(ratios ?? []).map((_, k) => slider({ label: `ratio under ${k + 1}`, hint: "velocity after an impact over that before; for the exact solver",
      limits: between(0, 1), ...key(scene, "restitution", 1, k) })),
    choice({ label: "equations", options: [["nonlinear", "nonlinear"], ["linear", "linear, as the paper has them"], ["small-angle", "small angles"]],
      ...key(scene, "equations", "nonlinear") })];
  };

  const lawGroup = () => {
    const contact = table("contact"), { law } = scene();
    const everywhere = (name, otherwise) => ({ get: key(contact, name, otherwise).get, set: (value) => { contact(true)[name] = value; } });
    const { get, set } = everywhere("friction", scene().engine?.friction ?? 1000);
    // A scene states its friction once.
    const setFriction = (value) => { delete scene().engine?.friction; set(value); };
    const friction = slider({ label: "friction", hint: "of law unilateral and compliant, and of engines", limits: between(0.01, 1000), log: true,
      get, set: setFriction });
    const soft = law !== "compliant" ? [] : [
      slider({ label: "stiffness, N/m", hint: "of each corner; inf: rigid", limits: between(1e5, 1e11), log: true, ...everywhere("stiffness", "inf") }),
      slider({ label: "damping, N·s/m", limits: between(0, 1e6), ...everywhere("damping", 0) })];
    const bouncing = law !== "unilateral" ? [] : [
      slider({ label: "restitution of points", hint: "what a point that meets a face keeps of its speed; of engines too", limits: between(0, 1),
        ...everywhere("restitution", 0) }),
      choice({ label: "law of restitution", hint: "what that is a share of; engines have their own", options: [["newton", "Newton's: speeds"], ["poisson", "Poisson's: impulses"]],
        get: key(contact, "restitution_law", "newton").get, set: (law) => Object.assign(contact(true), { restitution: contact(true).restitution ?? 0, restitution_law: law }) })];
    return group("Contact", true,
      choice({ label: "law", options: [["paper", "paper: pivots"], ["consistent", "consistent: pivots"], ["unilateral", "unilateral: slip, lift-off"], ["compliant", "compliant: springs"]],
        get: key(scene, "law", "consistent").get, set: setLaw }), friction, ...bouncing, ...soft, ...(leavesPivots(law) ? [] : ofPivots()));
  };

  const wholeGroup = () => group("Scene", false,
    slider({ label: "duration, s", limits: between(0.5, 60), log: true, ...key(scene, "duration", 5) }),
    slider({ label: "gravity, m/s²", limits: between(1, 25), ...key(scene, "gravity", 9.81) }));

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
