"use strict";
// A film of a player's picture as it plays, from now on to where it stops; saved as a file. It goes on where nobody looks: a worker's clock is not
// slowed down there, and pictures are taken, not waited for.
const film = (() => {
const types = ["video/mp4;codecs=avc1.640028", "video/mp4;codecs=avc1", "video/webm"];

const clock = () => new Worker(URL.createObjectURL(new Blob(["setInterval(() => postMessage(0), 1000 / 60)"], { type: "text/javascript" })));

// A stream of a canvas, and what takes its next picture. Where pictures cannot be taken, the browser does it, in view.
const streamOf = (canvas) => {
  if (!window.MediaStreamTrackGenerator) return { stream: canvas.captureStream(), take: () => {} };
  const track = new MediaStreamTrackGenerator({ kind: "video" }), writer = track.writable.getWriter();
  return { stream: new MediaStream([track]), take: () => writer.write(new VideoFrame(canvas, { timestamp: 1000 * performance.now() })).catch(() => {}) };
};

const nameOf = ({ title }, type) => `${title.match(/[\p{L}\p{N}]+/gu)?.join("-") ?? "film"}.${type.match(/\/(\w+)/)[1]}`;

const save = (player, name) => {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(player.filmed), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
};

return (player) => {
  const type = types.find((one) => MediaRecorder.isTypeSupported(one)), { stream, take } = streamOf(player.find("stage")), ticks = clock(), parts = [];
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 8e6 });
  recorder.ondataavailable = ({ data }) => {
    parts.push(data);
    player.filmed = new Blob(parts, { type });
  };
  recorder.onstop = () => {
    player.filming = null;
    player.find("film").textContent = "● Film";
    save(player, nameOf(player, type));
  };
  player.filming = { take, stop: () => { ticks.terminate(); recorder.stop(); } };
  player.find("film").textContent = "■ Save film";
  recorder.start(100);
  ticks.onmessage = () => player.frame(performance.now());
  if (!player.playing) player.toggle();
};
})();
