#!/usr/bin/env node
// A stack of blocks in Jolt by its own calls alone. What is not set stays as the library has it.

import { inPackage, printAngles, readQuestion } from './question.mjs';

const { default: load } = await import(inPackage('jolt-physics/dist/jolt-physics.wasm.js'));
const jolt = await load();
const question = readQuestion();
const { set, reach } = question;

const pairs = new jolt.ObjectLayerPairFilterTable(2);
pairs.EnableCollision(1, 1);
pairs.EnableCollision(1, 0);
const phases = new jolt.BroadPhaseLayerInterfaceTable(2, 2);
phases.MapObjectToBroadPhaseLayer(0, new jolt.BroadPhaseLayer(0));
phases.MapObjectToBroadPhaseLayer(1, new jolt.BroadPhaseLayer(1));
const chosen = new jolt.JoltSettings();
chosen.mObjectLayerPairFilter = pairs;
chosen.mBroadPhaseLayerInterface = phases;
chosen.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(phases, 2, pairs, 2);
const world = new jolt.JoltInterface(chosen);
const system = world.GetPhysicsSystem();
const physics = system.GetPhysicsSettings();
physics.mAllowSleeping = false;
const setters = {
  mNumVelocitySteps: (value) => { physics.mNumVelocitySteps = value; },
  mPenetrationSlop: (value) => { physics.mPenetrationSlop = value; },
  mSpeculativeContactDistance: (value) => { physics.mSpeculativeContactDistance = value; },
  mUseBodyPairContactCache: (value) => { physics.mUseBodyPairContactCache = value !== 0; },
  mConvexRadius: () => {},
  ground: () => {},
};
for (const [name, value] of Object.entries(set)) setters[name](value);
system.SetPhysicsSettings(physics);

// The friction of two bodies is the root of their product, so that both have the coefficient itself.
const body = (shape, x, y, angle, type, layer, more = () => {}) => {
  const made = new jolt.BodyCreationSettings(shape, new jolt.RVec3(x, y, 0),
    new jolt.Quat(0, 0, Math.sin(-angle / 2), Math.cos(angle / 2)), type, layer);
  made.mFriction = question.friction;
  made.mLinearDamping = 0;
  made.mAngularDamping = 0;
  more(made);
  const body = system.GetBodyInterface().CreateBody(made);
  system.GetBodyInterface().AddBody(body.GetID(), jolt.EActivation_Activate);
  return body;
};
const box = (width, height, depth) => new jolt.BoxShape(new jolt.Vec3(width / 2, height / 2, depth / 2), set.mConvexRadius ?? 0.05);
const thickness = set.ground === 1 ? 2 * reach : reach / 25;
body(box(2 * reach, thickness, 2 * reach), 0, -thickness / 2, 0, jolt.EMotionType_Static, 0);
const bodies = question.blocks.map(({ width, height, depth, x, y, angle, mass, aboutX, aboutY, aboutZ, right = 0, up = 0, spin = 0 }) =>
  body(box(width, height, depth), x, y, angle, jolt.EMotionType_Dynamic, 1, (made) => {
    made.mAllowedDOFs = jolt.EAllowedDOFs_Plane2D;
    made.mLinearVelocity.Set(right, up, 0);
    made.mAngularVelocity.Set(0, 0, -spin);
    made.mOverrideMassProperties = jolt.EOverrideMassProperties_MassAndInertiaProvided;
    made.mMassPropertiesOverride.mMass = mass;
    const { mInertia } = made.mMassPropertiesOverride;
    mInertia.SetColumn4(0, new jolt.Vec4(aboutX, 0, 0, 0));
    mInertia.SetColumn4(1, new jolt.Vec4(0, aboutY, 0, 0));
    mInertia.SetColumn4(2, new jolt.Vec4(0, 0, aboutZ, 0));
  }));
printAngles(question, (x, y) => {
  system.SetGravity(new jolt.Vec3(x, y, 0));
  world.Step(question.dt, 1);
}, (k) => {
  const rotation = bodies[k].GetRotation();
  const z = rotation.GetZ();
  return -2 * Math.atan2(z, rotation.GetW());
});
