// A run of an engine, whoever asks for it: a worker, or a page that holds the engine. serve.mjs says what an engine and its simulation are.

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

/** The coefficients of each interface where it slides, of libraries that have a second one. */
export const kineticFriction = (question) => question.kinetic_friction ?? question.friction;

/** Where the middle of a block's box is in its body, whose origin is the centre of mass: [right, up]. */
export const middle = (block) => [-block.offset_x, -block.offset_y];

/** Whether a block's centre of mass is off the middle of its box. */
export const isEccentric = (block) => block.offset_x !== 0 || block.offset_y !== 0;

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

/** How far a point of the plane is to the right of a block's middle, along its faces, m; `state` as a simulation tells it. */
export function placeAlong([x, y, angle], point) {
  return Math.cos(angle) * (point.x - x) - Math.sin(angle) * (point.y - y);
}

/** Of a motion whose numbers are none any more. */
export class NotFinite extends Error {}

const largestNumber = 1e20;

function requireFinite(state, block, time) {
  if (state.every((value) => Math.abs(value) <= largestNumber)) return;
  throw new NotFinite(`a place or a velocity of block ${block + 1} is not finite at t = ${time} s`);
}

const columns = ['x', 'y', 'angles', 'velocity_x', 'velocity_y', 'velocities', 'z', 'tilt'];

/**
 * What each interface bears in one step, means over it: [normal, tangential, centre] of the force on the upper block, in the axes of
 * the face below or, where the upper block is wider, of its own; `turned` are the angles where the step starts.
 */
function reactionsOf(question, points, turned) {
  const { blocks, dt } = question;
  const sums = blocks.map(() => ({ normal: 0, tangential: 0, pushed: 0, moment: 0 }));
  for (const { interface: k, along, push, x, y } of points) {
    const wider = k > 0 && blocks[k].width > blocks[k - 1].width;
    const face = wider ? turned[k] : k > 0 ? turned[k - 1] : 0;
    const [cosine, sine] = [Math.cos(face), Math.sin(face)];
    sums[k].normal += (x * sine + y * cosine) / dt;
    sums[k].tangential += (x * cosine - y * sine) / dt;
    sums[k].pushed += push;
    sums[k].moment += push * along;
  }
  return sums.map(({ normal, tangential, pushed, moment }, k) =>
    [normal, tangential, pushed > 0 ? moment / pushed + blocks[k].offset_x : 'nan']);
}

const forces = ['normal', 'tangential', 'centre'];

/** A number as messages have it. */
const numberOf = (value) => (value === 'inf' ? Infinity : value);

/** A vector of a block, where the block has turned clockwise. */
function turned({ x, y }, angle) {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return { x: x * cosine + y * sine, y: y * cosine - x * sine };
}

/**
 * Pushes and restraints of a question, step by step: forces at points of blocks, as one load on each block (../applied_loads.cpp
 * has the same). Tendons remember how far they have yielded.
 */
export class AppliedLoads {
  constructor({ pushes = [], restraints = [], lookahead = 0 }) {
    this.pushes = pushes;
    this.restraints = restraints.map((given) => ({ ...given, yield: numberOf(given.yield), drawn: 0 }));
    this.lookahead = lookahead;
    this.any = pushes.length + restraints.length > 0;
  }

  /** Force through each block's centre of mass, N, and clockwise moment, N m, over a step that begins with blocks in these states. */
  overStep(step, states) {
    const loads = states.map(() => ({ x: 0, y: 0, moment: 0 }));
    const add = (block, arm, x, y) => {
      if (block === 0) return;
      const load = loads[block - 1];
      load.x += x;
      load.y += y;
      load.moment += arm.y * x - arm.x * y;
    };
    for (const { point, direction_x: x, direction_y: y, forces } of this.pushes) {
      const size = forces[step] ?? 0;
      add(point.block, this.motion(point, states).arm, size * x, size * y);
    }
    for (const restraint of this.restraints) this.pull(restraint, states, add);
    return loads;
  }

  /** A tendon is slack where it would push, and yields where it would pull more than it can. */
  pull(restraint, states, add) {
    const [from, to] = [restraint.from, restraint.to].map((point) => this.motion(point, states));
    const apart = { x: to.x - from.x, y: to.y - from.y };
    const length = Math.hypot(apart.x, apart.y);
    const unit = { x: apart.x / length, y: apart.y / length };
    const stretch = length - restraint.length;
    const elastic = () => restraint.prestress + restraint.stiffness * (stretch - restraint.drawn);
    if (restraint.stiffness > 0 && elastic() > restraint.yield)
      restraint.drawn = stretch - (restraint.yield - restraint.prestress) / restraint.stiffness;
    const rate = unit.x * (to.rateX - from.rateX) + unit.y * (to.rateY - from.rateY);
    const force = Math.max(0, elastic()) + restraint.damping * rate;
    add(restraint.from.block, from.arm, force * unit.x, force * unit.y);
    add(restraint.to.block, to.arm, -force * unit.x, -force * unit.y);
  }

  /** A point, moved on by the velocities of its block; the ground does not move. */
  motion(point, states) {
    if (point.block === 0) return { x: point.x, y: point.y, rateX: 0, rateY: 0, arm: point };
    const [x, y, angle, velocityX, velocityY, spin] = states[point.block - 1];
    const time = this.lookahead;
    const arm = turned(point, angle + time * spin);
    return {
      x: x + time * velocityX + arm.x, y: y + time * velocityY + arm.y, rateX: velocityX + spin * arm.y, rateY: velocityY - spin * arm.x, arm,
    };
  }
}

/** Has the loads of a step act on blocks in these states. */
export function applyLoads(simulation, loads, step, states) {
  if (loads.any) loads.overStep(step, states).forEach((load, k) => simulation.load(k, load));
}

/** All samples, the first at the start. Ends with the first in which a block has toppled. */
export function record(simulation, question) {
  const lists = columns.map(() => []);
  const borne = forces.map(() => []);
  const tells = question.reactions && simulation.contacts !== undefined;
  const loads = new AppliedLoads(question);
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
    applyLoads(simulation, loads, step, states);
    simulation.step(pullOf(question, step));
    if (simulation.warnings?.() > before) ++warnings;
    if (!tells) continue;
    for (const one of reactionsOf(question, simulation.contacts(states), states.map((state) => state[2])))
      one.forEach((value, i) => borne[i].push(value));
  }
  const filled = Object.fromEntries(columns.map((name, i) => [name, lists[i]]).filter(([, list]) => list.length > 0));
  const { angles: turned, velocities, ...bodies } = filled;
  const reactions = tells && borne[0].length > 0 ? { reactions: Object.fromEntries(forces.map((name, i) => [name, borne[i]])) } : {};
  return { angles: turned, velocities, warnings, bodies, ...reactions };
}

export function pullOf(question, step) {
  const pulls = question.accelerations;
  return pulls ? { x: pulls.x[step], y: pulls.y[step] } : question.gravity;
}
