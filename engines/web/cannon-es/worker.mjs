#!/usr/bin/env node
// cannon-es beside the exact model. ../README.md says what is set in both sets and why.

import { angles, massFactor, middle, restitution, serve, setting, turn, whole } from '../serve.mjs';

const settings = [
  setting('iterations', 10, 500, 1, 1e6, whole),
  setting('tolerance', 1e-7, 0, 0, 1),
  setting('contactEquationStiffness', 1e7, 1e9, 1e-6, 1e18),
  setting('contactEquationRelaxation', 3, 10, 1e-6, 1e6),
  setting('frictionEquationStiffness', 1e7, 1e9, 1e-6, 1e18),
  setting('frictionEquationRelaxation', 3, 3, 1e-6, 1e6),
  setting('unitMass', 0, 1, 0, 1e12, { unit: 'kg' }),
  restitution('restitution'),
];

class Simulation {
  constructor(cannon, question) {
    this.cannon = cannon;
    this.dt = question.dt;
    this.given = question.parameters;
    this.world = new cannon.World({ allowSleep: false });
    this.world.solver.iterations = this.given.iterations;
    this.world.solver.tolerance = this.given.tolerance;
    this.masses = massFactor(question);
    this.addGround();
    for (const block of question.blocks) this.addBlock(block);
    question.friction.forEach((friction, k) => this.rub(k, friction));
  }

  rub(lower, friction) {
    const { iterations, tolerance, unitMass, ...surface } = this.given;
    const [one, other] = [lower, lower + 1].map((k) => this.world.bodies[k].material);
    this.world.addContactMaterial(new this.cannon.ContactMaterial(one, other, { ...surface, friction }));
  }

  add(shape, given, [right, up] = [0, 0]) {
    const body = new this.cannon.Body({ material: new this.cannon.Material(), linearDamping: 0, angularDamping: 0, ...given });
    body.addShape(shape, new this.cannon.Vec3(right, up, 0));
    this.world.addBody(body);
    return body;
  }

  /** The library's plane has its normal along z. */
  addGround() {
    this.add(new this.cannon.Plane(), { mass: 0, quaternion: new this.cannon.Quaternion(-Math.SQRT1_2, 0, 0, Math.SQRT1_2) });
  }

  addBlock(block) {
    const { masses } = this;
    const { Box, Quaternion, Vec3 } = this.cannon;
    const body = this.add(new Box(new Vec3(block.width / 2, block.height / 2, block.depth / 2)), {
      mass: masses * block.mass,
      position: new Vec3(block.x, block.y, 0),
      quaternion: new Quaternion(...turn(block.angle)),
      velocity: new Vec3(block.velocity_x, block.velocity_y, 0),
      angularVelocity: new Vec3(0, 0, -block.angular_velocity),
      linearFactor: new Vec3(1, 1, 0),
      angularFactor: new Vec3(0, 0, 1),
    }, middle(block));
    const inertia = [block.inertia_about_x, block.inertia_about_y, block.inertia].map((value) => masses * value);
    body.inertia.set(...inertia);
    body.invInertia.set(...inertia.map((value) => 1 / value));
    body.updateInertiaWorld(true);
  }

  /** Until the step is over: the library clears forces then. */
  load(k, { x, y, moment }) {
    const body = this.world.bodies[k + 1];
    body.force.set(this.masses * x, this.masses * y, 0);
    body.torque.set(0, 0, -this.masses * moment);
  }

  step(pull) {
    this.world.gravity.set(pull.x, pull.y, 0);
    this.world.step(this.dt);
  }

  state(k) {
    const { position, quaternion, velocity, angularVelocity } = this.world.bodies[k + 1];
    const { angle, tilt } = angles(quaternion.x, quaternion.y, quaternion.z, quaternion.w);
    return [position.x, position.y, angle, velocity.x, velocity.y, -angularVelocity.z, position.z, tilt];
  }
}

await serve({
  name: 'cannon-es',
  module: 'cannon-es',
  note: ' of npm, JavaScript, double precision',
  licence: 'MIT',
  capabilities: { center_of_mass: true },
  solvers: [{ solver: 'gauss-seidel', settings }],
  load: () => import('cannon-es'),
  start: (cannon, question) => new Simulation(cannon, question),
});
