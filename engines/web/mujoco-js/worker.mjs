#!/usr/bin/env node
// MuJoCo 3 beside the exact model, set up as ../../mujoco sets up version 2.2.2: the same settings by the same names, but for one
// more integrator and friction's own spring. ../../mujoco/README.md says what its contacts are, ../README.md what is set in both sets and why.

import { massFactor, middle, NotFinite, onOff, placeAlong, serve, setting, whole } from '../serve.mjs';

const stiffest = 1e18;  // of solref, where a negative number is a stiffness or a damping
const metres = { unit: 'm' };
const rungeKutta = 1;  // of integrator
const choices = (...names) => ({ whole: true, choices: names });

const settings = (solver) => [
  setting('integrator', 0, 0, 0, 3, choices('Euler', 'RK4', 'implicit', 'implicitfast')),
  setting('cone', 1, 1, 0, 1, choices('pyramidal', 'elliptic')),
  setting('solref_timeconst', 0.02, 1e-3, -stiffest, stiffest, { unit: 's' }),
  setting('solref_dampratio', 1, solver === 'pgs' ? 6 : 3, -stiffest, stiffest),
  setting('solreffriction_timeconst', 0, 0, -stiffest, stiffest, { unit: 's' }),  // both 0: solref is friction's too
  setting('solreffriction_dampratio', 0, 0, -stiffest, stiffest),
  setting('solimp_d0', 0.9, 0.995, 0, 1),
  setting('solimp_dwidth', 0.95, 0.995, 0, 1),
  setting('solimp_width', 1e-3, 1e-3, 0, 1e9, metres),
  setting('solimp_midpoint', 0.5, 0.5, 0, 1),
  setting('solimp_power', 2, 2, 1, 1e9),
  setting('margin', 0, 0, 0, 1e9, metres),
  setting('gap', 0, 0, 0, 1e9, metres),
  setting('impratio', 1, 1, 1e-6, 1e6),
  setting('iterations', 100, solver === 'pgs' ? 300 : 100, 1, 1e6, whole),
  setting('tolerance', 1e-8, 1e-12, 0, 1),
  setting('noslip_iterations', 0, 0, 0, 1e6, whole),
  setting('noslip_tolerance', 1e-6, 1e-6, 0, 1),
  onOff('refsafe', 1, 1),
  onOff('warmstart', 1, 1),
  setting('depth_ratio', 1, 0.9, 0.1, 10),
  setting('unitMass', 0, 1, 0, 1e12, { unit: 'kg' }),
];

const lost = ['mjWARN_BADQPOS', 'mjWARN_BADQVEL', 'mjWARN_BADQACC'];

/** An element with these attributes; what is given as a list is joined by blanks. */
function element(name, attributes, ...children) {
  const text = Object.entries(attributes).map(([key, value]) => ` ${key}="${[value].flat().join(' ')}"`).join('');
  return `<${name}${text}>${children.join('')}</${name}>`;
}

/** A geom meets others by pairs alone. */
function geom(number, attributes) {
  return element('geom', { name: number, contype: 0, conaffinity: 0, ...attributes });
}

/** Two slides and a hinge through the centre of mass, so that moments of inertia about x and y have no effect. */
function body(block, number, masses, depth) {
  const joint = (type, axis) => element('joint', { type, axis });
  return element('body', {},
    joint('slide', [1, 0, 0]), joint('slide', [0, 1, 0]), joint('hinge', [0, 0, 1]),
    element('inertial', {
      pos: [0, 0, 0], mass: masses * block.mass, diaginertia: Array(3).fill(masses * block.inertia),
    }),
    geom(number, { type: 'box', size: [block.width / 2, block.height / 2, depth / 2], pos: [...middle(block), 0] }));
}

/** Every two bodies may touch, with the friction of the interface under the upper one. */
function pairs(question) {
  const given = question.parameters;
  const values = (start, ...names) => names.map((name) => given[`${start}_${name}`]);
  const surface = {
    solref: values('solref', 'timeconst', 'dampratio'),
    solreffriction: values('solreffriction', 'timeconst', 'dampratio'),
    solimp: values('solimp', 'd0', 'dwidth', 'width', 'midpoint', 'power'),
    margin: given.margin,
    gap: given.gap,
  };
  return question.friction.map((friction, k) => Array.from({ length: k + 1 }, (_, lower) => element('pair', {
    geom1: lower, geom2: k + 1, condim: friction > 0 ? 3 : 1, friction: [friction, friction, 0, 0, 0], ...surface,
  })).join('')).join('');
}

function modelOf(question) {
  const given = question.parameters;
  const flags = {
    refsafe: given.refsafe === 0 ? 'disable' : 'enable',
    warmstart: given.warmstart === 0 ? 'disable' : 'enable',
  };
  const options = Object.fromEntries(['impratio', 'iterations', 'tolerance', 'noslip_iterations', 'noslip_tolerance']
    .map((name) => [name, given[name]]));
  const name = (key) => settings(question.solver).find((one) => one.name === key).choices[given[key]];
  const solver = { newton: 'Newton', cg: 'CG', pgs: 'PGS' }[question.solver];
  const masses = massFactor(question);
  const ground = geom(0, { type: 'plane', zaxis: [0, 1, 0], size: [0, 0, 1] });
  const blocks = question.blocks.map((block, k) => body(block, k + 1, masses, given.depth_ratio ** k * block.depth));
  return element('mujoco', {},
    element('option', { timestep: question.dt, solver, integrator: name('integrator'), cone: name('cone'), ...options },
      element('flag', flags)),
    element('worldbody', {}, ground, ...blocks),
    element('contact', {}, pairs(question)));
}

class Simulation {
  constructor(mujoco, question) {
    this.mujoco = mujoco;
    mujoco.FS.writeFile('stack.xml', modelOf(question));
    this.model = mujoco.MjModel.loadFromXML('stack.xml');
    this.data = new mujoco.MjData(this.model);
    this.force = new mujoco.DoubleBuffer(6);
    this.masses = massFactor(question);
    this.dt = question.dt;
    if (question.parameters.integrator === rungeKutta) this.contacts = undefined;  // contacts are those of the last stage alone
    question.blocks.forEach((block, k) => {
      this.data.qpos.set([block.x, block.y, -block.angle], 3 * k);
      this.data.qvel.set([block.velocity_x, block.velocity_y, -block.angular_velocity], 3 * k);
    });
  }

  /** Coordinates are those of the centre of mass. */
  load(k, { x, y, moment }) {
    this.data.qfrc_applied.set([x, y, -moment].map((value) => this.masses * value), 3 * k);
  }

  step(pull) {
    this.model.opt.gravity.set([pull.x, pull.y, 0]);
    this.mujoco.mj_step(this.model, this.data);
  }

  /** Warnings so far. The library begins anew where a coordinate is not finite: that is no motion of this stack. */
  warnings() {
    const count = (kind) => this.data.warning.get(this.mujoco.mjtWarning[kind].value).number;
    if (lost.some((kind) => count(kind) > 0)) throw new NotFinite('MuJoCo has begun anew');
    return Object.keys(this.mujoco.mjtWarning).filter((kind) => kind.startsWith('mjWARN')).reduce((sum, kind) => sum + count(kind), 0);
  }

  state(k) {
    const [x, y, angle] = this.data.qpos.subarray(3 * k, 3 * k + 3);
    const [vx, vy, spin] = this.data.qvel.subarray(3 * k, 3 * k + 3);
    return [x, y, -angle, vx, vy, -spin];
  }

  /** Forces that act all the step. */
  contacts(states) {
    const list = this.data.contact;
    const points = Array.from({ length: this.data.ncon }, (_, i) => this.pointOf(i, list.get(i), states));
    list.delete();
    return points;
  }

  /** Geoms are numbered from 0, the ground; a contact's normal, the first row of its frame, points from the first to the second. */
  pointOf(i, contact, states) {
    this.mujoco.mj_contactForce(this.model, this.data, i, this.force);
    const force = this.force.GetView();
    const [upper, side] = contact.geom2 > contact.geom1 ? [contact.geom2, 1] : [contact.geom1, -1];
    const impulse = this.dt / this.masses;
    const onUpper = (axis) => side * impulse * [0, 1, 2].reduce((sum, row) => sum + force[row] * contact.frame[3 * row + axis], 0);
    const [x, y] = contact.pos;
    const point = { interface: upper - 1, along: placeAlong(states[upper - 1], { x, y }), push: impulse * force[0], x: onUpper(0), y: onUpper(1) };
    contact.delete();
    return point;
  }

  end() {
    this.force.delete();
    this.data.delete();
    this.model.delete();
  }
}

await serve({
  name: 'mujoco-js',
  module: 'mujoco-js',
  note: ' of npm, MuJoCo 3.3.8, WebAssembly, double precision',
  licence: 'Apache-2.0',
  capabilities: { planar: true, center_of_mass: true },
  solvers: ['newton', 'cg', 'pgs'].map((solver) => ({ solver, settings: settings(solver) })),
  load: async () => (await import('mujoco-js')).default(),
  start: (mujoco, question) => new Simulation(mujoco, question),
});
