#!/usr/bin/env node
// Box2D 3 beside the exact model. ../README.md says what is set in both sets and why.

import { groundReach, middle, onOff, placeAlong, restitution, serve, setting, threshold, whole } from '../serve.mjs';

const settings = [
  setting('subStepCount', 4, 50, 1, 1e4, whole),
  setting('contactHertz', 30, 480, 0, 1e9, { unit: '1/s' }),
  setting('contactDampingRatio', 10, 10, 0, 1e9),
  setting('contactSpeed', 3, 3, 0, 1e9, { unit: 'm/s' }),
  onOff('enableWarmStarting', 1, 1),
  onOff('enableSpeculative', 1, 1),
  onOff('enableContinuous', 1, 1),
  restitution('restitution'),
  setting('restitutionThreshold', 1, 1, 0, 1e9, { unit: 'm/s', ...threshold }),
  setting('maximumLinearSpeed', 400, 400, 0, 1e9, { unit: 'm/s' }),
];

const mostContacts = 16;  // of one body

class Simulation {
  constructor(box2d, question) {
    this.box2d = box2d;
    this.dt = question.dt;
    this.given = question.parameters;
    this.world = this.addWorld(question.friction);
    this.pull = new box2d.b2Vec2(0, 0);
    this.bodies = [];
    if (question.wall) this.addWall(question.wall);
    const reach = groundReach(question.blocks);
    this.add({ width: 2 * reach, height: 2 * reach, x: 0, y: -reach, angle: 0 }, box2d.b2BodyType.b2_staticBody);
    for (const block of question.blocks) this.addBlock(block);
  }

  /** The library would take the root of a product of coefficients. */
  addWorld(friction) {
    const { box2d, given } = this;
    const chosen = box2d.b2DefaultWorldDef();
    chosen.enableSleep = false;
    chosen.enableContinuous = given.enableContinuous !== 0;
    chosen.restitutionThreshold = given.restitutionThreshold;
    chosen.maximumLinearSpeed = given.maximumLinearSpeed;
    const world = box2d.b2CreateWorld(chosen);
    chosen.delete();
    box2d.b2World_SetContactTuning(world, given.contactHertz, given.contactDampingRatio, given.contactSpeed);
    box2d.b2World_EnableWarmStarting(world, given.enableWarmStarting !== 0);
    box2d.b2World_EnableSpeculative(world, given.enableSpeculative !== 0);
    box2d.b2World_SetFrictionCallback(world, (_1, one, _2, other) => friction[Math.max(Number(one), Number(other)) - 1]);
    return world;
  }

  /** Bodies are numbered from 0, the ground. A rotation is given by cosine and sine: the library's own are off by up to 1 %. */
  add(block, type, [right, up] = [0, 0]) {
    const { box2d } = this;
    const chosen = box2d.b2DefaultBodyDef();
    chosen.type = type;
    chosen.position.Set(block.x, block.y);
    chosen.rotation.c = Math.cos(block.angle);
    chosen.rotation.s = -Math.sin(block.angle);
    const body = box2d.b2CreateBody(this.world, chosen);
    const shape = box2d.b2DefaultShapeDef();
    shape.material.userMaterialId = BigInt(this.bodies.length);
    shape.material.restitution = this.given.restitution;
    const [place, level] = [new box2d.b2Vec2(right, up), box2d.b2MakeRot(0)];
    const box = box2d.b2MakeOffsetBox(block.width / 2, block.height / 2, place, level);
    box2d.b2CreatePolygonShape(body, shape, box);
    for (const used of [chosen, shape, place, level, box]) used.delete();
    this.bodies.push(body);
    return body;
  }

  /** Numbered as the ground, which comes after it. */
  addWall(wall) {
    this.add({ ...wall, angle: 0 }, this.box2d.b2BodyType.b2_staticBody);
    this.bodies.pop();
  }

  addBlock(block) {
    const { box2d } = this;
    const body = this.add(block, box2d.b2BodyType.b2_dynamicBody, middle(block));
    const mass = new box2d.b2MassData();
    mass.mass = block.mass;
    mass.rotationalInertia = block.inertia;
    const velocity = new box2d.b2Vec2(block.velocity_x, block.velocity_y);
    box2d.b2Body_SetMassData(body, mass);
    box2d.b2Body_SetLinearVelocity(body, velocity);
    box2d.b2Body_SetAngularVelocity(body, -block.angular_velocity);
    mass.delete();
    velocity.delete();
  }

  /** Until the step is over: the library clears forces then. */
  load(k, { x, y, moment }) {
    const { box2d } = this;
    const body = this.bodies[k + 1];
    this.pull.Set(x, y);
    box2d.b2Body_ApplyForceToCenter(body, this.pull, true);
    box2d.b2Body_ApplyTorque(body, -moment, true);
  }

  step(pull) {
    this.pull.Set(pull.x, pull.y);
    this.box2d.b2World_SetGravity(this.world, this.pull);
    this.box2d.b2World_Step(this.world, this.dt, this.given.subStepCount);
  }

  state(k) {
    const { box2d } = this;
    const body = this.bodies[k + 1];
    const [place, rotation, velocity] = [box2d.b2Body_GetPosition(body), box2d.b2Body_GetRotation(body), box2d.b2Body_GetLinearVelocity(body)];
    const state = [place.x, place.y, -Math.atan2(rotation.s, rotation.c), velocity.x, velocity.y,
      -box2d.b2Body_GetAngularVelocity(body)];
    for (const used of [place, rotation, velocity]) used.delete();
    return state;
  }

  /** Impulses of the last substep, which the whole step is taken for. The total that the library keeps counts both passes of a substep. */
  contacts(states) {
    return states.flatMap((state, k) => this.box2d.b2Body_GetContactData(this.bodies[k + 1], mostContacts)
      .flatMap((found) => this.pointsOf(found, state, k)));
  }

  /** A contact's points on the upper body, none where block k is the lower. A normal points from body A to body B. */
  pointsOf(found, state, k) {
    const { manifold, shapeIdA, shapeIdB } = found;
    const [one, other] = [shapeIdA, shapeIdB].map((shape) => this.numberOf(shape));
    const side = other > one ? 1 : -1;
    const points = Math.max(one, other) === k + 1 ? Array.from({ length: manifold.pointCount }, (_, i) => {
      const { point, normalImpulse, tangentImpulse } = manifold.GetPoint(i);
      const { x, y } = manifold.normal;
      const [push, rub] = [normalImpulse, tangentImpulse].map((impulse) => this.given.subStepCount * impulse);
      return { interface: k, along: placeAlong(state, point), push, x: side * (push * x + rub * y), y: side * (push * y - rub * x) };
    }) : [];
    found.delete();
    return points;
  }

  numberOf(shape) {
    const material = this.box2d.b2Shape_GetSurfaceMaterial(shape);
    const number = Number(material.userMaterialId);
    material.delete();
    return number;
  }

  end() {
    this.box2d.b2DestroyWorld(this.world);
    this.pull.delete();
  }
}

await serve({
  name: 'box2d3',
  module: 'box2d3-wasm',
  note: ' of npm, Box2D 3.2.0, WebAssembly, single precision',
  licence: 'MIT',
  capabilities: { wall: true, single_precision: true, planar: true, center_of_mass: true, lead: 0.5 / 4, tuned_lead: 0.5 / 50 },
  solvers: [{ solver: 'soft-step', settings }],
  load: async () => (await import('box2d3-wasm')).default({ pthreadCount: 0 }),
  start: (box2d, question) => new Simulation(box2d, question),
});
