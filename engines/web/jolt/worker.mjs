#!/usr/bin/env node
// Jolt Physics beside the exact model. ../README.md says what is set in both sets and why.

import { angles, groundReach, isEccentric, middle, onOff, restitution, serve, setting, threshold, turn, whole } from '../serve.mjs';

const metres = { unit: 'm' };

const settings = [
  setting('mNumVelocitySteps', 10, 10, 1, 255, whole),
  setting('mNumPositionSteps', 2, 2, 0, 255, whole),
  setting('mBaumgarte', 0.2, 0.2, 0, 1),
  setting('mPenetrationSlop', 0.02, 1e-5, 0, 1, metres),
  setting('mSpeculativeContactDistance', 0.02, 1e-5, 0, 1, metres),
  setting('mMaxPenetrationDistance', 0.2, 0.2, 0, 10, metres),
  setting('mManifoldTolerance', 1e-3, 1e-3, 0, 1, metres),
  setting('mConvexRadius', 0.05, 0, 0, 1, metres),
  setting('mContactPointPreserveLambdaMaxDistSq', 1e-4, 1e-4, 0, 1, { unit: 'm²' }),
  onOff('mConstraintWarmStart', 1, 1),
  onOff('mUseBodyPairContactCache', 1, 0),
  onOff('mUseManifoldReduction', 1, 1),
  setting('mMinVelocityForRestitution', 1, 1, 0, 1e3, { unit: 'm/s', ...threshold }),
  restitution('restitution'),
  setting('ground', 0, 0, 0, 1, { whole: true, choices: ['slab', 'cube'] }),
];

const moving = 1;
const resting = 0;

/** An object of the library for as long as `use` takes. */
function using(jolt, object, use) {
  const result = use(object);
  jolt.destroy(object);
  return result;
}

/** Blocks and ground meet each other, the ground's layer nothing of its own. */
function startLibrary(jolt) {
  const layers = new jolt.ObjectLayerPairFilterTable(2);
  layers.EnableCollision(moving, moving);
  layers.EnableCollision(moving, resting);
  const phases = new jolt.BroadPhaseLayerInterfaceTable(2, 2);
  for (const layer of [resting, moving]) phases.MapObjectToBroadPhaseLayer(layer, new jolt.BroadPhaseLayer(layer));
  return using(jolt, new jolt.JoltSettings(), (chosen) => {
    chosen.mObjectLayerPairFilter = layers;
    chosen.mBroadPhaseLayerInterface = phases;
    chosen.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(phases, 2, layers, 2);
    return new jolt.JoltInterface(chosen);
  });
}

class Simulation {
  constructor(jolt, question) {
    this.jolt = jolt;
    this.dt = question.dt;
    this.given = question.parameters;
    this.world = startLibrary(jolt);
    this.system = this.world.GetPhysicsSystem();
    this.gravity = new jolt.Vec3(0, 0, 0);
    this.set();
    const ground = this.addGround(2 * groundReach(question.blocks));
    this.bodies = question.blocks.map((block) => this.add(block, moving));
    this.listen([ground, ...this.bodies], question.friction);
  }

  set() {
    const chosen = this.system.GetPhysicsSettings();
    for (const [name, value] of Object.entries(this.given)) {
      if (chosen[`set_${name}`]) chosen[name] = typeof chosen[name] === 'boolean' ? value !== 0 : value;
    }
    chosen.mAllowSleeping = false;
    this.system.SetPhysicsSettings(chosen);
  }

  add(block, layer) {
    const { jolt } = this;
    const [, , z, w] = turn(block.angle);
    const type = layer === moving ? jolt.EMotionType_Dynamic : jolt.EMotionType_Static;
    const size = new jolt.Vec3(block.width / 2, block.height / 2, block.depth / 2);
    const place = new jolt.RVec3(block.x, block.y, 0);
    const rotation = new jolt.Quat(0, 0, z, w);
    const shape = this.shape(size, block);
    const chosen = new jolt.BodyCreationSettings(shape, place, rotation, type, layer);
    chosen.mRestitution = this.given.restitution;
    chosen.mLinearDamping = 0;
    chosen.mAngularDamping = 0;
    if (layer === moving) this.setMotion(chosen, block);
    const body = this.system.GetBodyInterface().CreateBody(chosen);
    this.system.GetBodyInterface().AddBody(body.GetID(), jolt.EActivation_Activate);
    for (const used of [chosen, rotation, place, size]) jolt.destroy(used);
    return body;
  }

  /** A body's place is that of its shape's origin, here of its centre of mass: the box goes to one side and its own centre back. */
  shape(size, block) {
    const { jolt } = this;
    const radius = this.given.mConvexRadius;
    if (!isEccentric(block)) return new jolt.BoxShape(size, radius);
    const [right, up] = middle(block);
    const box = new jolt.BoxShapeSettings(size, radius);
    const moved = using(jolt, new jolt.Vec3(right, up, 0), (to) => using(jolt, new jolt.Quat(0, 0, 0, 1),
      (level) => new jolt.RotatedTranslatedShapeSettings(to, level, box).Create().Get()));
    return using(jolt, new jolt.Vec3(-right, -up, 0), (back) => new jolt.OffsetCenterOfMassShape(moved, back));
  }

  /** A slab is a fiftieth as thick as it is wide: on a cube of that width normals are at times wrong (page.md). */
  addGround(width) {
    const height = this.given.ground === 0 ? width / 50 : width;
    return this.add({ width, height, depth: width, x: 0, y: -height / 2, angle: 0, offset_x: 0, offset_y: 0 }, resting);
  }

  setMotion(chosen, block) {
    const { jolt } = this;
    chosen.mAllowedDOFs = jolt.EAllowedDOFs_Plane2D;
    chosen.mLinearVelocity.Set(block.velocity_x, block.velocity_y, 0);
    chosen.mAngularVelocity.Set(0, 0, -block.angular_velocity);
    chosen.mOverrideMassProperties = jolt.EOverrideMassProperties_MassAndInertiaProvided;
    chosen.mMassPropertiesOverride.mMass = block.mass;
    const inertia = [block.inertia_about_x, block.inertia_about_y, block.inertia];
    inertia.forEach((value, axis) => using(jolt, new jolt.Vec4(...[0, 1, 2, 3].map((row) => (row === axis ? value : 0))),
      (column) => chosen.mMassPropertiesOverride.mInertia.SetColumn4(axis, column)));
  }

  /** Each interface has its own coefficient, where the library would take the root of a product. */
  listen(bodies, friction) {
    const { jolt } = this;
    const number = new Map(bodies.map((body, k) => [jolt.getPointer(body), k]));
    const rub = (one, other, manifold, pointer) => {
      const interfaceNumber = Math.max(number.get(one), number.get(other)) - 1;
      jolt.wrapPointer(pointer, jolt.ContactSettings).mCombinedFriction = friction[interfaceNumber];
    };
    this.listener = new jolt.ContactListenerJS();
    this.listener.OnContactValidate = () => jolt.ValidateResult_AcceptAllContactsForThisBodyPair;
    this.listener.OnContactAdded = rub;
    this.listener.OnContactPersisted = rub;
    this.listener.OnContactRemoved = () => {};
    this.system.SetContactListener(this.listener);
  }

  /** Until the step is over: the library clears forces then. */
  load(k, { x, y, moment }) {
    const { jolt } = this;
    using(jolt, new jolt.Vec3(x, y, 0), (force) => this.bodies[k].AddForce(force));
    using(jolt, new jolt.Vec3(0, 0, -moment), (torque) => this.bodies[k].AddTorque(torque));
  }

  step(pull) {
    this.gravity.Set(pull.x, pull.y, 0);
    this.system.SetGravity(this.gravity);
    this.world.Step(this.dt, 1);
  }

  state(k) {
    const body = this.bodies[k];
    const place = body.GetPosition();
    const [x, y, z] = [place.GetX(), place.GetY(), place.GetZ()];
    const rotation = body.GetRotation();
    const { angle, tilt } = angles(rotation.GetX(), rotation.GetY(), rotation.GetZ(), rotation.GetW());
    const velocity = body.GetLinearVelocity();
    const [vx, vy] = [velocity.GetX(), velocity.GetY()];
    return [x, y, angle, vx, vy, -body.GetAngularVelocity().GetZ(), z, tilt];
  }

  end() {
    this.jolt.destroy(this.world);
    this.jolt.destroy(this.listener);
    this.jolt.destroy(this.gravity);
  }
}

await serve({
  name: 'jolt',
  module: 'jolt-physics',
  note: ' of npm, WebAssembly, single precision',
  licence: 'MIT',
  capabilities: { single_precision: true, center_of_mass: true },
  solvers: [{ solver: 'sequential-impulse', settings }],
  load: async () => (await import('jolt-physics/wasm')).default(),
  start: (jolt, question) => new Simulation(jolt, question),
});
