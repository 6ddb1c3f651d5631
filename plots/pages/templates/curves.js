"use strict";
// A figure's curves as charts of uPlot in the place of its picture, once they are asked for: hovering tells their values, a drag
// zooms all panels of the figure, a double click shows all again, and the legend switches curves.
{
  const numbers = (text) => Array.from(new Float32Array(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer));

  // Curves have times of their own: what is told is the point that is nearest.
  const nearest = (chart, series, at) => {
    const values = chart.data[series];
    for (let away = 0; away < values.length; ++away) {
      if (values[at - away] != null) return at - away;
      if (values[at + away] != null) return at + away;
    }
    return at;
  };

  const told = (digits) => (chart, value) => (value == null ? "–" : String(Number(value.toPrecision(digits))));

  const optionsOf = (panel, group, width) => ({
    width, height: 280,
    cursor: { sync: { key: group }, dataIdx: nearest, focus: { prox: 24 } },
    focus: { alpha: 0.3 },
    scales: { x: { time: false }, y: { distr: panel.logarithmic ? 3 : 1 } },
    axes: [{ label: panel.across }, { label: panel.up, size: 72 }],
    series: [{ label: panel.across, value: told(5) }, ...panel.curves.map(({ label, colour }) => (
      { label, stroke: colour, width: label === "exact" ? 3 : 1.5, spanGaps: true, points: { show: false }, value: told(4) }))],
  });

  const draw = (panels, group, place) => {
    const charts = panels.map((panel) => {
      const curves = panel.curves.map(({ x, y }) => [numbers(x), numbers(y)]);
      return new uPlot(optionsOf(panel, group, place.clientWidth), uPlot.join(curves), place);
    });
    new ResizeObserver(() => {
      for (const chart of charts) if (place.clientWidth > 0) chart.setSize({ width: place.clientWidth, height: chart.height });
    }).observe(place);
    return charts;
  };

  document.querySelectorAll("script.curves").forEach((data, number) => {
    const figure = data.parentElement;
    const button = Object.assign(document.createElement("button"), { type: "button", className: "explore" });
    const place = Object.assign(document.createElement("div"), { className: "charts" });
    const show = (charts) => {
      figure.classList.toggle("explored", charts);
      button.textContent = charts ? "Show the picture" : "Hover, zoom, switch curves";
      if (charts) place.charts ??= draw(JSON.parse(data.textContent), `curves-${number}`, place);
    };
    button.addEventListener("click", () => show(!figure.classList.contains("explored")));
    data.before(button, place);
    show(false);
  });
}
