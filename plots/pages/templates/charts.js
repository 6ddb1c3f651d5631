"use strict";
// Lines over time on a canvas.

// Round steps that divide a range in five or so.
const ticksOf = (low, high) => {
  const rough = (high - low) / 5, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= rough);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i <= high / step + 1e-9; ++i) ticks.push(i * step);
  return ticks;
};

const decades = (low, high) => {
  const ticks = [];
  for (let power = Math.ceil(low); power <= high; power += Math.max(1, Math.round((high - low) / 5))) ticks.push(power);
  return ticks;
};

const powerText = (exponent) => "10" + String(exponent).replace(/./g, (sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]);

const tickText = (value) => String(Number(value.toPrecision(3))).replace("-", "−");

const rangeOf = (lines, log) => {
  let low = Infinity, high = -Infinity;
  for (const { y } of lines) for (const value of y) if (Number.isFinite(value)) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (!(low <= high)) [low, high] = log ? [-6, 0] : [-1, 1];
  if (high - low < 1e-9) [low, high] = [low - (log ? 1 : 0.1), high + (log ? 1 : 0.1)];
  return log ? [Math.floor(low), Math.ceil(high)] : [low - 0.04 * (high - low), high + 0.04 * (high - low)];
};

// Size and type of a canvas, which take the browser long to tell; forgotten where they may have changed.
const looks = new Map();
const lookOf = (canvas) => {
  if (!looks.has(canvas)) looks.set(canvas, { width: canvas.clientWidth, height: canvas.clientHeight,
    type: parseFloat(getComputedStyle(canvas).fontSize) * 0.8 });
  return looks.get(canvas);
};

// lines: [{ x, y, colour, width, dash }], drawn in this order; `log`: y are powers of ten. `mark`: a dotted level. Returns what tells time and
// value at a place in the canvas.
function drawChart(canvas, { lines, end, log, mark }) {
  const sharp = window.devicePixelRatio || 1, pen = canvas.getContext("2d"), { width, height, type } = lookOf(canvas);
  const size = [Math.round(width * sharp), Math.round(height * sharp)];
  if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
  pen.setTransform(sharp, 0, 0, sharp, 0, 0);
  pen.setLineDash([]);
  pen.clearRect(0, 0, width, height);
  const [low, high] = rangeOf(lines, log), left = 4.5 * type, bottom = height - 1.8 * type, top = 0.6 * type;
  const x = (time) => left + time / end * (width - left - type), y = (value) => bottom - (value - low) / (high - low) * (bottom - top);
  pen.font = `${type}px 'DejaVu Sans', sans-serif`;
  const grid = (fromX, fromY, toX, toY, dash = []) => {
    pen.setLineDash(dash);
    pen.beginPath();
    pen.moveTo(fromX, fromY);
    pen.lineTo(toX, toY);
    pen.stroke();
    pen.setLineDash([]);
  };
  pen.lineWidth = 1;
  pen.strokeStyle = "#ddd";
  pen.fillStyle = "#333";
  pen.textAlign = "right";
  for (const tick of log ? decades(low, high) : ticksOf(low, high)) {
    grid(left, y(tick), width - type, y(tick));
    pen.fillText(log ? powerText(tick) : tickText(tick), left - 5, y(tick) + 0.35 * type);
  }
  pen.textAlign = "center";
  for (const tick of ticksOf(0, end)) {
    grid(x(tick), top, x(tick), bottom);
    pen.fillText(tickText(tick) + " s", Math.min(x(tick), width - 1.5 * type), height - 0.4 * type);
  }
  pen.strokeStyle = "#b00020";
  if (mark !== undefined && mark > low && mark < high) grid(left, y(mark), width - type, y(mark), [2, 4]);
  pen.save();
  pen.beginPath();
  pen.rect(left, 0, width, bottom);
  pen.clip();
  for (const line of lines) {
    pen.strokeStyle = line.colour;
    pen.lineWidth = line.width ?? 1.5;
    pen.setLineDash(line.dash ?? []);
    pen.beginPath();
    for (let i = 0, drawing = false; i < line.x.length; ++i) {
      if (!Number.isFinite(line.y[i])) { drawing = false; continue; }
      if (drawing) pen.lineTo(x(line.x[i]), y(line.y[i])); else pen.moveTo(x(line.x[i]), y(line.y[i]));
      drawing = true;
    }
    pen.stroke();
  }
  pen.restore();
  return (px, py) => [(px - left) / (width - left - type) * end, low + (bottom - py) / (bottom - top) * (high - low)];
}
