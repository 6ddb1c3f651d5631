// What all workers of this folder share: a question of rockstack comes in, the engine runs, its answer goes out
// (../worker/README.md has the form of messages).
//
// An engine is an object. `name`, `module` (the package) and `licence` say what it is; `note` follows the package's version;
// `capabilities` and `solvers` are those of the description: each solver has its list of settings. `load()` gives the library,
// which all runs of a process share. `start(library, question)` gives a simulation: `step(pull)` takes one step under the body
// force `pull`, m/s²; `load(k, { x, y, moment })` has a force through the centre of mass of block k, N, and a clockwise moment, N m, act
// over the next step; `state(k)` is block k's [x, y, angle, velocity_x, velocity_y, angular_velocity], angles clockwise, in space
// also z and the sine of the tilt. Optional are `warnings()`, how many there were so far, `end()`, which gives back what it
// holds, and `contacts(states)`, the points that bore in the last step, from these states of the blocks on: `interface`, from 0; `along`, on the
// upper block's lower face from below its centre of mass to the right, m; `push`, the impulse across the faces, and `x`, `y`, all of it on the
// upper block, N s.

import { readFileSync, readSync, writeFileSync, writeSync } from 'node:fs';
import { setFlagsFromString } from 'node:v8';

import { AppliedLoads, applyLoads, NotFinite, pullOf, record } from './simulation.mjs';

export * from './simulation.mjs';

const replyDescriptor = 3;
const newline = 10;

/** After so many steps no engine here becomes faster: what is compiled while it runs is compiled. */
const warmUp = 10000;
/** Of one process: what libraries keep of a run is not given back. */
const mostRuns = 20;

/** Wall time of the steps alone, s. */
function timeOf(simulation, question, steps) {
  const pulls = Array.from({ length: steps }, (_, step) => pullOf(question, step));
  const loads = new AppliedLoads(question);
  const states = () => question.blocks.map((_, k) => simulation.state(k));
  const start = performance.now();
  pulls.forEach((pull, step) => {
    if (loads.any) applyLoads(simulation, loads, step, states());
    simulation.step(pull);
  });
  return (performance.now() - start) / 1000;
}

/** The largest resident size since forgetPeak(), bytes. */
function peakMemory() {
  return 1024 * Number(/VmHWM:\s*(\d+)/.exec(readFileSync('/proc/self/status', 'utf8'))[1]);
}

function forgetPeak() {
  writeFileSync('/proc/self/clear_refs', '5');
}

/**
 * A run this short is over before WebAssembly that is compiled anew, for speed, gives back what that takes. Either code computes
 * the same numbers.
 */
const shortRun = 20000;

const isShort = (question) => question.repeats === 0 && question.steps <= shortRun;

/** What the runs of this process share: the library, and whether it is compiled for short runs. */
let shared;

/** A run that is not short does not go on with a library that is compiled for such: a new process is asked for it. */
async function libraryFor(engine, question) {
  const short = isShort(question);
  if (shared === undefined) {
    if (short) setFlagsFromString('--liftoff-only');
    shared = { library: await engine.load(), short };
  } else if (shared.short && !short) {
    process.exit();
  } else {
    forgetPeak();
  }
  return shared.library;
}

async function answer(engine, question) {
  const library = await libraryFor(engine, question);
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
    applied_forces: true, ...engine.capabilities, warm_up: warmUp, runs_per_process: mostRuns, settings,
  }));
}

function writeAll(bytes) {
  for (let done = 0; done < bytes.length;) done += writeSync(replyDescriptor, bytes, done);
}

/** The lines of standard input; the last may lack its end. */
function* lines() {
  const chunk = Buffer.alloc(1 << 16);
  let parts = [];
  for (let size; (size = readSync(0, chunk)) > 0;) {
    parts.push(Buffer.from(chunk.subarray(0, size)));
    if (chunk[size - 1] !== newline) continue;
    yield Buffer.concat(parts).toString();
    parts = [];
  }
  if (parts.length > 0) yield Buffer.concat(parts).toString();
}

/** Answers one question after the other, each in a line, until standard input ends. */
export async function serve(engine) {
  for (const line of lines()) {
    const message = JSON.parse(line);
    const reply = message.run ? { run: { question: message.run.question, ...await answer(engine, message.run) } } : { engines: describe(engine) };
    writeAll(Buffer.from(`${JSON.stringify({ rockstack: 1, ...reply })}\n`));
  }
}
