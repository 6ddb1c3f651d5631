"use strict";
// Blocks of a player that are dragged and let go, or thrown. `change` takes what changes a scene, and returns when its motion is shown.
const letDrag = (() => {
const fastest = 4; // rad/s that a throw gives
const recent = 80; // ms of the pointer's motion that a throw is fitted to

// Where a pointer is in the picture of a track, m.
const pointed = (player, view, event) => {
  const box = player.find("stage").getBoundingClientRect();
  const x = (event.clientX - box.left) / player.type, y = (event.clientY - box.top) / player.type;
  return [(x - view.x(0)) / view.scale, (view.y(0) - y) / view.scale];
};

// The block under a pointer, and where in it that is; nothing where there is none.
const grabbed = (player, event) => {
  const track = player.shown().find((one) => one.exact), view = track && player.views.get(track);
  if (!view) return null;
  const angles = player.drawnAngles(track), point = pointed(player, view, event);
  const parts = player.stack.place(track, player.time, angles), near = (event.pointerType === "touch" ? 12 : 3) / view.scale;
  for (let block = parts.length - 1; block >= 0; --block) {
    const [along, up] = parts[block].local(point), [b, h] = player.stack.half[block];
    if (Math.abs(along) <= b + near && up >= -near && up <= 2 * h + near)
      return { view, block, along, up, from: player.time, angles: track.angles(player.time), slips: track.slips(player.time), slides: Boolean(track.slipped) };
  }
  return null;
};

// The angles at which the grabbed point is nearest to the pointer: the block turns, and all above it with it.
const pulled = (player, { view, block, along, up, angles, slips }, event) => {
  const point = pointed(player, view, event), gain = player.gain(), most = 1.2;
  const turned = (turn) => angles.map((angle, k) => k < block ? angle : angle + turn);
  const off = (turn) => {
    const drawn = turned(turn).map((angle) => angle * gain), base = player.stack.stand(drawn, slips)[block];
    const [cos, sin] = [Math.cos(drawn[block]), Math.sin(drawn[block])];
    return Math.hypot(base[0] + along * cos + up * sin - point[0], base[1] + up * cos - along * sin - point[1]);
  };
  let best = 0, step = most / 20 / gain;
  for (let turn = -most / gain; turn <= most / gain; turn += step) if (off(turn) < off(best)) best = turn;
  for (; step > 1e-5; step /= 2) for (const turn of [best - step, best + step]) if (off(turn) < off(best)) best = turn;
  return turned(best);
};

// The scene that starts with these angles, and otherwise as the motion stands now. Interfaces that are nearly closed are closed.
const startFrom = (scene, angles, velocities, { slips, slides }) => {
  const closed = 2e-4, tidy = [];
  angles.forEach((angle, k) => tidy.push(Math.abs(angle - (tidy[k - 1] ?? 0)) < closed ? tidy[k - 1] ?? 0 : angle));
  const { springs, offsets } = scene.initial ?? {};
  scene.initial = { angles: tidy, velocities };
  if (springs) scene.initial.springs = springs;
  if (slides) scene.initial.offsets = slips.map((slip, k) => slip + (offsets?.[k] ?? 0));
};

// The slope of the line that is nearest to [time in ms, angle], rad/s; none where the pointer rested before it let go at `end`.
const speedOf = (path, end) => {
  const resting = 60, points = path.filter(([time]) => end - time <= recent), count = points.length;
  if (count < 2 || end - points.at(-1)[0] > resting) return 0;
  const mean = [0, 1].map((i) => points.reduce((sum, point) => sum + point[i], 0) / count);
  const sum = (i) => points.reduce((total, point) => total + (point[0] - mean[0]) * (point[i] - mean[i]), 0);
  return sum(0) > 0 ? 1000 * sum(1) / sum(0) : 0;
};

return (player, change) => {
  const stage = player.find("stage");
  let grip = null, path = [];
  // Says where the motion begins that comes of it.
  const begin = (held, edit) => {
    const done = change(edit);
    player.origin = held.from > 0 ? ` It begins as blocks stood at ${held.from.toFixed(4)} s.` : "";
    return done;
  };
  const pull = (event) => {
    const held = grip, angles = pulled(player, held, event);
    path = [...path.filter(([time]) => event.timeStamp - time <= recent), [event.timeStamp, angles[grip.block]]];
    player.held = angles;
    player.draw();
    begin(held, (scene) => startFrom(scene, angles, angles.map(() => 0), held));
  };
  // A finger on a block does not move the page.
  stage.addEventListener("touchstart", (event) => {
    const [{ clientX, clientY }] = event.touches;
    if (grabbed(player, { clientX, clientY, pointerType: "touch" })) event.preventDefault();
  }, { passive: false });
  stage.addEventListener("pointerdown", (event) => {
    grip = grabbed(player, event);
    if (!grip) return;
    if (player.playing) player.toggle();
    path = [];
    stage.setPointerCapture(event.pointerId);
    stage.classList.add("dragging");
    pull(event);
    player.time = 0;
  });
  stage.addEventListener("pointermove", (event) => {
    if (grip) return pull(event);
    stage.classList.toggle("draggable", Boolean(grabbed(player, event)));
  });
  const drop = async (event) => {
    if (!grip) return;
    const held = grip, { block } = held, angles = player.held ?? player.tracks.find((one) => one.exact).angles(0);
    grip = null;
    stage.classList.remove("dragging");
    const speed = speedOf(path, event.timeStamp), thrown = Math.abs(speed) > 0.1 ? Math.max(-fastest, Math.min(fastest, speed)) : 0;
    await begin(held, (scene) => startFrom(scene, angles, scene.blocks.map((_, k) => k < block ? 0 : thrown), held));
    player.goTo(0);
    player.toggle();
  };
  for (const kind of ["pointerup", "pointercancel"]) stage.addEventListener(kind, drop);
};
})();
