// What all workers of this folder share: a question of rockstack comes in, the engine runs, its answer goes out
// (../README.md has the form of messages).
//
// An engine is an object. `name`, `module` (the package) and `licence` say what it is; `note` follows the package's version;
// `capabilities` and `solvers` are those of the description: each solver has its list of settings. `load()` gives the library.
// `start(library, question)` gives a simulation: `step(pull)` takes one step under the body force `pull`, m/s²; `state(k)` is
// block k's [x, y, angle, velocity_x, velocity_y, angular_velocity], angles clockwise, in space also z and the sine of the tilt.
// Optional are `warnings()`, how many there were so far, and `end()`, which gives back what it holds.

import { readFileSync, writeSync } from 'node:fs';

const replyDescriptor = 3;
const largestNumber = 1e20;

/** A setting of the description. */
export function setting(name, standard, tuned, least, most, more = {}) {
  return { name, default: standard, tuned, least, most, ...more };
}

/** The setting that a scene's coefficient of restitution goes into, and of one below which speed nothing bounces. */
export const restitution = (name) => setting(name, 0, 0, 0, 1, { role: 'restitution' });
export const threshold = { role: 'restitution threshold' };

export const whole = { whole: true };
export const onOff = (name, standard, tuned) => setting(name, standard, tuned, 0, 1, { whole: true });

/** How far a ground that has edges goes to each side, m: ten times as far as all blocks in a row. */
export function groundReach(blocks) {
  return 10 * blocks.reduce((sum, block) => sum + block.width + block.height, blocks[0].depth);
}

/**
 * A coefficient of friction for each body, from the ground up, for libraries that take the mean of two: that of neighbours is
 * then their interface's. Some are negative.
 */
export function neighbourMeans(friction) {
  const own = [0];
  for (const wanted of friction) own.push(2 * wanted - own.at(-1));
  return own;
}

/** What masses are multiplied by, so that the whole stack has `wanted` kg; 0 leaves them. No angle depends on it. */
export function massFactor(question) {
  const wanted = question.parameters.unitMass;
  return wanted === 0 ? 1 : wanted / question.blocks.reduce((sum, block) => sum + block.mass, 0);
}

/** The quaternion of a turn about the axis out of the plane: [x, y, z, w]. `angle` is clockwise. */
export function turn(angle) {
  return [0, 0, -Math.sin(angle / 2), Math.cos(angle / 2)];
}

/** The clockwise angle of a quaternion, within half a turn, and the sine of the tilt out of the plane. */
export function angles(x, y, z, w) {
  return { angle: -2 * Math.atan2(z, w) % (2 * Math.PI), tilt: 2 * Math.hypot(x, y) * Math.hypot(z, w) };
}

/** Of a motion whose numbers are none any more. */
export class NotFinite extends Error {}

function requireFinite(state, block, time) {
  if (state.every((value) => Math.abs(value) <= largestNumber)) return;
  throw new NotFinite(`a place or a velocity of block ${block + 1} is not finite at t = ${time} s`);
}

const columns = ['x', 'y', 'angles', 'velocity_x', 'velocity_y', 'velocities', 'z', 'tilt'];

/** All samples, the first at the start. Ends with the first in which a block has toppled. */
function record(simulation, question) {
  const lists = columns.map(() => []);
  let warnings = 0;
  for (let step = 0; ; ++step) {
    const states = question.blocks.map((_, k) => simulation.state(k));
    states.forEach((state, k) => {
      requireFinite(state, k, step * question.dt);
      state.forEach((value, i) => lists[i].push(value));
    });
    const toppled = states.some((state, k) => Math.abs(state[2]) > question.toppling_angles[k]);
    if (step === question.steps || toppled) break;
    const before = simulation.warnings?.();
    simulation.step(pullOf(question, step));
    if (simulation.warnings?.() > before) ++warnings;
  }
  const filled = Object.fromEntries(columns.map((name, i) => [name, lists[i]]).filter(([, list]) => list.length > 0));
  const { angles: turned, velocities, ...bodies } = filled;
  return { angles: turned, velocities, warnings, bodies };
}

function pullOf(question, step) {
  const pulls = question.accelerations;
  return pulls ? { x: pulls.x[step], y: pulls.y[step] } : question.gravity;
}

/** Wall time of the steps alone, s. */
function timeOf(simulation, question, steps) {
  const pulls = Array.from({ length: steps }, (_, step) => pullOf(question, step));
  const start = performance.now();
  for (const pull of pulls) simulation.step(pull);
  return (performance.now() - start) / 1000;
}

/** The largest resident size so far, bytes. */
function peakMemory() {
  return 1024 * Number(/VmHWM:\s*(\d+)/.exec(readFileSync('/proc/self/status', 'utf8'))[1]);
}

async function answer(engine, question) {
  const library = await engine.load();
  const simulate = (use) => {
    const simulation = engine.start(library, question);
    try {
      return use(simulation);
    } finally {
      simulation.end?.();
    }
  };
  try {
    const { bodies, ...history } = simulate((simulation) => record(simulation, question));
    const steps = history.angles.length / question.blocks.length - 1;
    const seconds = Array.from({ length: question.repeats },
      () => simulate((simulation) => timeOf(simulation, question, steps)));
    const told = question.bodies ? { bodies } : {};
    return { status: 'done', ...history, ...told, seconds, peak_memory: peakMemory() };
  } catch (failure) {
    if (!(failure instanceof NotFinite)) throw failure;
    return { status: 'not finite', reason: failure.message };
  }
}

function versionOf(engine) {
  return JSON.parse(readFileSync(new URL(`node_modules/${engine.module}/package.json`, import.meta.url), 'utf8')).version;
}

function describe(engine) {
  return engine.solvers.map(({ solver, settings }) => ({
    name: engine.name, solver, version: `${versionOf(engine)}${engine.note}`, licence: engine.licence,
    ...engine.capabilities, settings,
  }));
}

function writeAll(bytes) {
  for (let done = 0; done < bytes.length;) done += writeSync(replyDescriptor, bytes, done);
}

/** Answers the one question that waits on standard input. */
export async function serve(engine) {
  const message = JSON.parse(readFileSync(0, 'utf8'));
  const reply = message.run ? { run: await answer(engine, message.run) } : { engines: describe(engine) };
  writeAll(Buffer.from(JSON.stringify({ rockstack: 1, ...reply })));
}
