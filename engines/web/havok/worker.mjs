#!/usr/bin/env node
// Havok beside the exact model. ../README.md says what is set and why.

import { readFileSync } from 'node:fs';
import { angles, groundReach, kineticFriction, middle, restitution, serve, setting, turn } from '../serve.mjs';

const settings = [
  setting('idealStepTime', 1 / 60, 0, 0, 10, { unit: 's' }),  // 0: as it comes
  restitution('restitution'),
];

/** What the library answers with. @throws where a call fails. */
function got([result, value], havok) {
  require(result, havok);
  return value;
}

function require(result, havok) {
  if (result !== havok.Result.RESULT_OK) throw new Error('havok: a call of the library fails');
}

/**
 * A coefficient for each body, from the ground up, so that the product of neighbours is that of their interface; the library
 * takes none below 0. @throws where the third interface or a higher one rubs and the one below it does not.
 */
function factors(friction) {
  const own = [friction[0], 1];
  for (const wanted of friction.slice(1)) {
    if (wanted > 0 && own.at(-1) === 0) throw new Error('havok: friction above an interface without any cannot be given');
    own.push(wanted === 0 ? 0 : wanted / own.at(-1));
  }
  return own;
}

class Simulation {
  constructor(havok, question) {
    this.havok = havok;
    this.dt = question.dt;
    this.given = question.parameters;
    this.blocks = question.blocks;
    this.owned = [];
    this.world = got(havok.HP_World_Create(), havok);
    require(havok.HP_World_SetIdealStepTime(this.world, this.given.idealStepTime), havok);
    const sliding = factors(kineticFriction(question));
    const [ground, ...friction] = factors(question.friction).map((sticking, k) => [sticking, sliding[k]]);
    const reach = groundReach(question.blocks);
    this.add({ width: 2 * reach, height: 2 * reach, depth: 2 * reach, x: 0, y: -reach, angle: 0 }, ground,
      havok.MotionType.STATIC);
    this.bodies = question.blocks.map((block, k) => this.addBlock(block, friction[k]));
  }

  add(block, friction, type, [right, up] = [0, 0]) {
    const { havok } = this;
    const shape = got(havok.HP_Shape_CreateBox([right, up, 0], [0, 0, 0, 1], [block.width, block.height, block.depth]), havok);
    const body = got(havok.HP_Body_Create(), havok);
    this.owned.push([shape, body]);
    const { ARITHMETIC_MEAN, MULTIPLY } = havok.MaterialCombine;
    const material = [...friction, this.given.restitution, MULTIPLY, ARITHMETIC_MEAN];
    require(havok.HP_Shape_SetMaterial(shape, material), havok);
    require(havok.HP_Body_SetShape(body, shape), havok);
    require(havok.HP_Body_SetMotionType(body, type), havok);
    require(havok.HP_Body_SetQTransform(body, [[block.x, block.y, 0], turn(block.angle)]), havok);
    require(havok.HP_World_AddBody(this.world, body, false), havok);
    return body;
  }

  /** The library's moments of inertia are those of one kilogram. */
  addBlock(block, friction) {
    const { havok } = this;
    const body = this.add(block, friction, havok.MotionType.DYNAMIC, middle(block));
    const inertia = [block.inertia_about_x, block.inertia_about_y, block.inertia].map((value) => value / block.mass);
    require(havok.HP_Body_SetMassProperties(body, [[0, 0, 0], block.mass, inertia, [0, 0, 0, 1]]), havok);
    require(havok.HP_Body_SetLinearDamping(body, 0), havok);
    require(havok.HP_Body_SetAngularDamping(body, 0), havok);
    require(havok.HP_Body_SetActivationControl(body, havok.ActivationControl.ALWAYS_ACTIVE), havok);
    require(havok.HP_Body_SetLinearVelocity(body, [block.velocity_x, block.velocity_y, 0]), havok);
    require(havok.HP_Body_SetAngularVelocity(body, [0, 0, -block.angular_velocity]), havok);
    return body;
  }

  /** Changes velocities before the step: the library's impulses act by a mass of some ten bits. */
  load(k, { x, y, moment }) {
    const { havok, dt } = this;
    const [body, { mass, inertia }] = [this.bodies[k], this.blocks[k]];
    const [vx, vy, vz] = got(havok.HP_Body_GetLinearVelocity(body), havok);
    const [wx, wy, wz] = got(havok.HP_Body_GetAngularVelocity(body), havok);
    require(havok.HP_Body_SetLinearVelocity(body, [vx + dt * x / mass, vy + dt * y / mass, vz]), havok);
    require(havok.HP_Body_SetAngularVelocity(body, [wx, wy, wz - dt * moment / inertia]), havok);
  }

  step(pull) {
    require(this.havok.HP_World_SetGravity(this.world, [pull.x, pull.y, 0]), this.havok);
    require(this.havok.HP_World_Step(this.world, this.dt), this.havok);
  }

  state(k) {
    const { havok } = this;
    const body = this.bodies[k];
    const [place, rotation] = got(havok.HP_Body_GetQTransform(body), havok);
    const { angle, tilt } = angles(...rotation);
    const [vx, vy] = got(havok.HP_Body_GetLinearVelocity(body), havok);
    const [, , spin] = got(havok.HP_Body_GetAngularVelocity(body), havok);
    return [place[0], place[1], angle, vx, vy, -spin, place[2], tilt];
  }

  end() {
    for (const [shape, body] of this.owned) {
      require(this.havok.HP_World_RemoveBody(this.world, body), this.havok);
      require(this.havok.HP_Body_Release(body), this.havok);
      require(this.havok.HP_Shape_Release(shape), this.havok);
    }
    require(this.havok.HP_World_Release(this.world), this.havok);
  }
}

await serve({
  name: 'havok',
  module: '@babylonjs/havok',
  note: ' of npm, WebAssembly, single precision',
  licence: 'MIT',
  capabilities: { single_precision: true, kinetic_friction: true, center_of_mass: true, lead: 0.125 },
  solvers: [{ solver: 'own', settings }],
  load: async () => {
    const wasmBinary = readFileSync(new URL('../node_modules/@babylonjs/havok/lib/esm/HavokPhysics.wasm', import.meta.url));
    return (await import('@babylonjs/havok')).default({ wasmBinary });
  },
  start: (havok, question) => new Simulation(havok, question),
});
