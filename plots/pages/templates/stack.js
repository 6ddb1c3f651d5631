"use strict";
// Stacks of blocks as they stand and move, and pictures of patterns.
const stacks = (() => {
const turned = (a, c, angle) =>
  [a * Math.cos(angle) + c * Math.sin(angle), c * Math.cos(angle) - a * Math.sin(angle)];

const plus = ([a, b], [c, d]) => [a + c, b + d];
const minus = ([a, b], [c, d]) => [a - c, b - d];

// How far a point lies along a face from a point of it, and how far above.
const seenFrom = (middle, angle, point) => {
  const [x, y] = minus(point, middle);
  return [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
};

class Stack {
  constructor(blocks) {
    this.half = blocks.map((block) => [block.width / 2, block.height / 2]);
    this.offset = blocks.map((block) => block.offset);
    this.height = blocks.reduce((sum, block) => sum + block.height, 0);
    this.width = Math.max(...blocks.map((block) => block.width));
  }

  // Middles of the bases of blocks that touch at these angles and slips, in metres from the middle of the ground's
  // interface.
  stand(angles, slips) {
    let top = [0, 0], face = 0, reach = Infinity;
    return angles.map((angle, k) => {
      const [b, h] = this.half[k], side = Math.sign(angle - face);
      const foot = side > 0 ? Math.min(b, reach - slips[k]) : side < 0 ? Math.max(-b, -reach - slips[k]) : 0;
      const base = minus(plus(top, turned(foot + slips[k], 0, face)), turned(foot, 0, angle));
      [top, face, reach] = [plus(base, turned(0, 2 * h, angle)), angle, b];
      return base;
    });
  }

  // Where the centre of mass of a block in its place is.
  centre(part, k) {
    const [x, y] = this.offset[k];
    return plus(part.base, turned(x, y + this.half[k][1], part.angle));
  }

  // The blocks of a track with their angles enlarged to `angles`; flights and falls keep their size.
  place(track, time, angles) {
    const slips = track.slips(time), places = track.places(time), real = track.angles(time);
    let bases = this.stand(angles, slips);
    if (places) {
      const touching = this.stand(real, slips);
      bases = bases.map((base, k) => {
        const [x, y] = this.offset[k], h = this.half[k][1];
        return plus(base, minus(minus(places[k], turned(x, y + h, real[k])), touching[k]));
      });
    }
    const parts = [];
    bases.forEach((base, k) => parts.push(new Part(base, angles[k], this.half[k], k > 0 ? parts[k - 1] : null)));
    return parts;
  }
}

// A block in its place, and how it touches the one below, or the ground.
class Part {
  constructor(base, angle, [b, h], below) {
    Object.assign(this, { base, angle, b, below });
    this.top = plus(base, turned(0, 2 * h, angle));
    this.corners = [[-b, 0], [b, 0], [b, 2 * h], [-b, 2 * h]].map(([a, c]) => plus(base, turned(a, c, angle)));
  }

  under(x) { return this.at(x, 0); }

  // A point from the middle of the base, along it and up.
  at(x, y) { return plus(this.base, turned(x, y, this.angle)); }

  // A point as seen from the middle of the base: along it, and up.
  local(point) { return seenFrom(this.base, this.angle, point); }

  // Where the faces that meet end on a side, along the base from its middle: at its own corner or at that below.
  end(side) {
    if (!this.below) return side * this.b;
    const [along] = seenFrom(this.base, this.angle, plus(this.below.top, turned(side * this.below.b, 0, this.below.angle)));
    return side * Math.min(this.b, side * along);
  }

  // How far a point of the base is on the way from the middle of the faces that meet to their end, 1 at the end.
  wayToEnd(along) {
    const [left, right] = [this.end(-1), this.end(1)];
    return Math.abs(2 * along - left - right) / (right - left);
  }

  // The angle of the face that a corner touches.
  face(side) {
    const rounding = 1e-5 * this.b;
    const own = side !== 0 && Math.abs(this.end(side)) < this.b - rounding;
    return own ? this.angle : this.below ? this.below.angle : 0;
  }

  // The least distance between the faces, Infinity where neither is over the other.
  gap() {
    if (!this.below) return Math.min(this.corners[0][1], this.corners[1][1]);
    const { top, angle, b } = this.below;
    const over = (point, middle, turn, reach, sign) => {
      const [along, up] = seenFrom(middle, turn, point);
      return Math.abs(along) <= reach ? sign * up : Infinity;
    };
    return Math.min(...[-1, 1].flatMap((side) => [over(this.under(side * this.b), top, angle, b, 1),
      over(plus(top, turned(side * b, 0, angle)), this.base, this.angle, this.b, -1)]));
  }
}

const unpack = (text) => {
  if (text instanceof Float32Array) return text;
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return new Float32Array(bytes.buffer);
};

// Index of the last entry that is not after `time`, −1 before the first.
const lastBefore = (times, time) => {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1; else high = middle;
  }
  return low - 1;
};

// A motion by its samples.
class Track {
  constructor(data, blocks) {
    const { label, colour, shown, impacts, exact } = data;
    Object.assign(this, { label, colour, shown, impacts, exact, blocks });
    this.dash = data.dash === "solid" ? [] : data.dash.replace(/[()]/g, "").split(",").map(Number);
    this.times = unpack(data.times);
    this.values = unpack(data.angles);
    this.slipped = data.slips ? unpack(data.slips) : null;
    this.placed = data.places ? unpack(data.places) : null;
    this.forces = data.reactions ? unpack(data.reactions) : null;
    this.forceTimes = data.reactions ? unpack(data.reaction_times) : null;
    this.end = this.times[this.times.length - 1];
  }

  // Values between samples on straight lines; held after the end.
  read(values, width, time) {
    const at = Math.max(0, Math.min(lastBefore(this.times, time), this.times.length - 2));
    const span = this.times[at + 1] - this.times[at];
    const part = span > 0 ? Math.min(1, Math.max(0, (time - this.times[at]) / span)) : 0;
    const from = at * width;
    return Array.from({ length: width }, (_, i) =>
      values[from + i] * (1 - part) + values[from + width + i] * part);
  }

  angles(time) { return this.read(this.values, this.blocks, time); }

  // How far each block has slipped to the right along what is below it; nought where the results do not say.
  slips(time) { return this.slipped ? this.read(this.slipped, this.blocks, time) : Array(this.blocks).fill(0); }

  // The centre of mass of each block, null where angles and slips say where blocks are.
  places(time) {
    if (!this.placed) return null;
    const values = this.read(this.placed, 2 * this.blocks, time);
    return Array.from({ length: this.blocks }, (_, k) => [values[2 * k], values[2 * k + 1]]);
  }

  // One sample, not a mean of two: forces jump at impacts.
  reactions(time) {
    const width = 3 * this.blocks;
    const at = Math.max(0, lastBefore(this.forceTimes, time)) * width;
    return this.forces.subarray(at, at + width);
  }
}

// Colours of blocks' curves, from the ground up.
const blockColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

const arrow = (pen, fromX, fromY, toX, toY, colour, width) => {
  const length = Math.hypot(toX - fromX, toY - fromY);
  if (length < 2) return;
  const head = Math.min(10, length), [u, v] = [(toX - fromX) / length, (toY - fromY) / length];
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = width;
  pen.beginPath();
  pen.moveTo(fromX, fromY);
  pen.lineTo(toX - u * head * 0.8, toY - v * head * 0.8);
  pen.stroke();
  pen.beginPath();
  pen.moveTo(toX, toY);
  pen.lineTo(toX - u * head - v * head * 0.45, toY - v * head + u * head * 0.45);
  pen.lineTo(toX - u * head + v * head * 0.45, toY - v * head - u * head * 0.45);
  pen.fill();
};

// A pattern as a small stack: which way each block leans on the one below, with its pivots; apart: above it; an arrow: the way it slides.
const shapeOf = (sides, slides) => {
  const lean = 0.2, apart = 0.25, stack = new Stack(sides.map(() => ({ width: 1, height: 1, offset: [0, 0] }))), parts = [], angles = [];
  sides.forEach((side) => angles.push((angles.at(-1) ?? 0) + (Math.abs(side) === 1 ? side * lean : 0)));
  let lift = 0;
  stack.stand(angles, sides.map(() => 0)).forEach(([x, y], k) => {
    if (sides[k] === 2) lift += apart;
    parts.push(new Part([x, y + lift], angles[k], [0.5, 0.5], parts.at(-1) ?? null));
  });
  const pivots = parts.flatMap((part, k) => Math.abs(sides[k]) === 1 ? [part.under(sides[k] * 0.5)] : []);
  const arrows = parts.flatMap(({ base: [x, y] }, k) => slides[k] ? [[[-0.3, 0], [0.3, 0], [0.08, 0.16], [0.3, 0], [0.08, -0.16]].map(([a, c]) => [x + slides[k] * a, y + 0.25 + c])] : []);
  return { half: 0.55 + 0.25 * sides.length, top: sides.length + 0.35, low: 0.15, outlines: parts.map((part) => part.corners), pivots, arrows };
};

const iconOf = (svg, sides, slides) => {
  const { half, top, low, outlines, pivots, arrows } = shapeOf(sides, slides);
  const line = (tag, list) => `<${tag} points="${list.map(([x, y]) => `${x.toFixed(3)},${(-y).toFixed(3)}`).join(" ")}"/>`;
  if (!svg) {
    const home = document.createElement("template");
    home.innerHTML = '<svg class="icon" aria-hidden="true"></svg>';
    svg = home.content.firstChild;
  }
  svg.setAttribute("viewBox", `${-half} ${-top} ${2 * half} ${top + low}`);
  svg.innerHTML = line("polyline", [[-half, 0], [half, 0]]) + outlines.map((one) => line("polygon", one)).join("") + arrows.map((one) => line("polyline", one)).join("")
    + pivots.map(([x, y]) => `<circle cx="${x}" cy="${-y}" r="0.09"/>`).join("");
  return svg;
};

// Draws the stack on a canvas, with the middle of its lower edge at (x, y), 24 pixels wide at most.
const drawIcon = (pen, x, y, height, sides, slides) => {
  const { half, top, low, outlines, pivots, arrows } = shapeOf(sides, slides), scale = Math.min(height / (top + low), 12 / half), at = ([a, c]) => [x + a * scale, y - (c + low) * scale];
  const line = (points) => {
    pen.beginPath();
    for (const point of points) pen.lineTo(...at(point));
  };
  [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = ["#f0f0f0", "#1a1a1a", 1];
  line([[-half, 0], [half, 0]]);
  pen.stroke();
  for (const one of outlines) {
    line(one);
    pen.closePath();
    pen.fill();
    pen.stroke();
  }
  for (const one of arrows) {
    line(one);
    pen.stroke();
  }
  pen.fillStyle = "#b00020";
  for (const pivot of pivots) {
    pen.beginPath();
    pen.arc(...at(pivot), 1.8, 0, 2 * Math.PI);
    pen.fill();
  }
};

// The contacts of a pattern by its name, from the ground up; null where it is none. Those of two blocks have the paper's.
const contactsOf = (name) => {
  const paper = { rest: [0, 0], "1a": [1, 1], "1b": [-1, -1], "2a": [1, -1], "2b": [-1, 1], "3a": [1, 0], "3b": [-1, 0], "4a": [0, 1], "4b": [0, -1] };
  if (Object.hasOwn(paper, name)) return [paper[name], [0, 0]];
  if (!/^([LCR–-][←→<>]?)+$/.test(name)) return null;
  const parts = name.match(/[LCR–-][←→<>]?/g), sides = { L: -1, C: 0, R: 1, "–": 2, "-": 2 }, ways = { "←": -1, "<": -1, "→": 1, ">": 1 };
  return [parts.map(([letter]) => sides[letter]), parts.map(([, way]) => ways[way] ?? 0)];
};

return { Stack, Part, Track, arrow, blockColours, contactsOf, drawIcon, iconOf, lastBefore, unpack };
})();

// Names of patterns in the text and in tables, each with its picture.
for (const one of document.querySelectorAll("[data-pattern]")) one.prepend(stacks.iconOf(null, ...stacks.contactsOf(one.dataset.pattern)));
for (const cell of document.querySelectorAll("td[data-label*=pattern]"))
  cell.replaceChildren(...cell.textContent.split(/( )/).flatMap((word) => stacks.contactsOf(word) ? [stacks.iconOf(null, ...stacks.contactsOf(word)), word] : [word]));
