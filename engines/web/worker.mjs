// What all workers of this folder share: a question of rockstack comes in, the engine runs, its answer goes out
// (../README.md has the form of messages).
//
// An engine is an object. `name`, `module` (the package) and `licence` say what it is; `note` follows the package's version;
// `capabilities` and `solvers` are those of the description: each solver has its list of settings. `load()` gives the library.
// `start(library, question)` gives a simulation: `step(pull)` takes one step under the body force `pull`, m/s²; `state(k)` is
// block k's [x, y, angle, velocity_x, velocity_y, angular_velocity], angles clockwise, in space also z and the sine of the tilt.
// Optional are `warnings()`, how many there were so far, and `end()`, which gives back what it holds.

import { readFileSync, writeSync } from 'node:fs';
import { setFlagsFromString } from 'node:v8';

import { NotFinite, pullOf, record } from './simulation.mjs';

export * from './simulation.mjs';

const replyDescriptor = 3;

/** After so many steps no engine here becomes faster: what is compiled while it runs is compiled. */
const warmUp = 10000;
/** Of one process: what libraries keep of a run is not given back. */
const mostRuns = 20;

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

/**
 * A run this short is over before WebAssembly that is compiled anew, for speed, gives back what that takes. Either code computes
 * the same numbers.
 */
const shortRun = 20000;

async function answer(engine, question) {
  if (question.repeats === 0 && question.steps <= shortRun) setFlagsFromString('--liftoff-only');
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
    const timed = () => simulate((simulation) => timeOf(simulation, question, steps));
    let taken = steps;
    for (let runs = 0; taken < question.warm_up && runs < mostRuns; ++runs, taken += steps) timed();
    const seconds = Array.from({ length: question.repeats }, timed);
    const told = question.bodies ? { bodies } : {};
    return { status: 'done', ...history, ...told, seconds, warm_up: taken, peak_memory: peakMemory() };
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
    ...engine.capabilities, warm_up: warmUp, settings,
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
