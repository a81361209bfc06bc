// The time-series viewer: a uPlot for each panel, one time axis for all figures of a log; mouse, touch and keyboard.
"use strict";
const PANEL = 150, AXIS = 38, EVENT_WINDOW = 1.5;

class TimeAxis {
  constructor(start, stop) {
    Object.assign(this, { start, stop, from: start, to: stop, viewers: new Set() });
  }
  show(from, to) {
    const span = Math.min(this.stop - this.start, Math.max(to - from, (this.stop - this.start) * 1e-5));
    this.from = Math.max(this.start, Math.min(this.stop - span, (from + to - span) / 2));
    this.to = this.from + span;
    for (const viewer of this.viewers) viewer.request();
  }
  zoom(factor, at = (this.from + this.to) / 2) {
    this.show(at + (this.from - at) * factor, at + (this.to - at) * factor);
  }
  pan(share) {
    const by = share * (this.to - this.from);
    this.show(this.from + by, this.to + by);
  }
  reset() { this.show(this.start, this.stop); }
}

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const minus = (text) => text.replace("-", "−");

class Viewer {
  constructor(element, figure, axis) {
    Object.assign(this, { element, figure, axis, touches: new Map(), due: false, events_shown: new Set() });
    this.plots = element.querySelector(".plots");
    this.output = element.querySelector("output");
    this.events = figure.marks.flatMap((mark) => mark.at).sort((a, b) => a - b);
    this.panels = figure.panels.map((panel, k) => this.panel(panel, k === figure.panels.length - 1));
    axis.viewers.add(this);
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.plots);
  }

  width() { return Math.max(200, this.plots.clientWidth); }

  panel(panel, last) {
    const { figure, axis } = this, box = this.plots.appendChild(document.createElement("div"));
    box.className = "panel";
    const ink = () => css("ink"), grid = { stroke: () => css("grid"), width: 1 }, font = "12px system-ui, sans-serif";
    const lines = panel.series.map((line) => ({
      label: line.label, stroke: () => css(line.slot), width: line.wide ? 3 : 1.4, dash: line.dash.map((x) => 1.4 * x), points: { show: false },
      show: !this.hidden(line.label),
    }));
    const ends = panel.bands.flatMap((band) => [band.high, band.low].map(() => ({ stroke: "transparent", points: { show: false }, show: !this.hidden(band.label) })));
    const bands = panel.bands.map((band, i) => ({ series: [1 + lines.length + 2 * i, 2 + lines.length + 2 * i], fill: () => `${css(band.slot)}40` }));
    const plot = new uPlot({
      width: this.width(), height: (panel.low ? 0.55 : 1) * PANEL + (last ? AXIS : 6), ms: 1, legend: { show: false },
      padding: [6, 10, 0, 0],
      scales: { x: { time: false, range: () => [axis.from, axis.to] }, y: { range: panel.limits ? () => panel.limits : Viewer.range } },
      axes: [
        { stroke: ink, grid, ticks: { show: false }, font, size: last ? 22 : 0, label: last ? figure.axis : undefined,
          labelFont: font, labelSize: 16, values: (_, values) => values.map((v) => last ? minus(String(+v.toFixed(9))) : "") },
        { stroke: ink, grid, ticks: { show: false }, font, size: 52, label: panel.label, labelFont: font, labelSize: 16,
          space: panel.low ? 16 : 26, values: (_, values) => values.map((v) => minus(String(+v.toPrecision(9)))) },
      ],
      cursor: {
        y: false, points: { show: false }, sync: { key: this.element.dataset.figure }, drag: { setScale: false },
        bind: {
          mousedown: (_, __, handler) => (event) => event.shiftKey ? null : handler(event),
          dblclick: () => () => axis.reset(),
        },
      },
      series: [{}, ...lines, ...ends], bands,
      hooks: {
        drawClear: [(u) => this.behind(u)], setCursor: [(u) => this.values(u, box)],
        setSelect: [(u) => { if (u.select.width > 6) axis.show(u.posToVal(u.select.left, "x"), u.posToVal(u.select.left + u.select.width, "x")); u.setSelect({ width: 0, height: 0 }, false); }],
      },
    }, [panel.x, ...panel.series.map((line) => line.values), ...panel.bands.flatMap((band) => band.values)], box);
    const values = plot.over.appendChild(document.createElement("div"));
    values.className = "values";
    return { plot, panel, values };
  }

  // A margin of 6 % above and below; a constant gets an axis too.
  static range(_, low, high) {
    if (low === null) return [-1, 1];
    const pad = 0.06 * (high - low) || Math.abs(low) * 0.05 || 1;
    return [low - pad, high + pad];
  }

  // Gaps and upright lines, under the curves.
  behind(u) {
    const { ctx, bbox: { left, top, width, height } } = u, x = (t) => Math.round(u.valToPos(t, "x", true)) + 0.5;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.fillStyle = css("gap");
    for (const [from, to] of this.figure.gaps) ctx.fillRect(x(from), top, Math.max(1, x(to) - x(from)), height);
    for (const { name, at, colour, dash } of this.figure.marks) {
      if (!this.events_shown.has(name)) continue;
      ctx.strokeStyle = css(colour);
      ctx.setLineDash(dash);
      ctx.beginPath();
      for (const t of at) { ctx.moveTo(x(t), top); ctx.lineTo(x(t), top + height); }
      ctx.stroke();
    }
    ctx.restore();
  }

  // The samples under the pointer, in the panel's upper left corner.
  values(u) {
    const own = this.panels?.find(({ plot }) => plot === u);
    if (own === undefined) return;
    const { idx, left } = u.cursor, shown = own.panel.series.filter((line) => !this.hidden(line.label));
    own.values.replaceChildren(...(left < 0 || idx == null ? [] : shown.map((line) => {
      const text = document.createElement("span"), value = line.values[idx];
      text.style.color = css(line.slot);
      text.textContent = `${line.label} ${value == null ? "–" : minus(value.toPrecision(4))}`;
      return text;
    })));
    if (left >= 0 && idx != null) this.output.textContent = `t = ${+u.posToVal(left, "x").toPrecision(6)} ${this.figure.unit}`;
    else this.state();
  }

  hidden(label) {
    const button = [...this.element.querySelectorAll("button[data-series]")].find((each) => each.dataset.series === label);
    return button?.getAttribute("aria-pressed") === "false";
  }

  listen() {
    const keys = { ArrowLeft: "left", ArrowRight: "right", "+": "in", "=": "in", "-": "out", 0: "whole", Home: "whole", Escape: "whole", PageDown: "next", PageUp: "previous" };
    for (const button of this.element.querySelectorAll("button[data-do]")) {
      button.addEventListener("click", () => this.act(button.dataset.do));
    }
    for (const button of this.element.querySelectorAll("button[data-series]")) {
      button.addEventListener("click", () => {
        const show = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", String(show));
        for (const { plot, panel } of this.panels) {
          const labels = [...panel.series, ...panel.bands.flatMap((band) => [band, band])].map((each) => each.label);
          labels.forEach((label, i) => { if (label === button.dataset.series) plot.setSeries(i + 1, { show }); });
        }
      });
    }
    for (const button of this.element.querySelectorAll("button[data-mark]")) {
      button.addEventListener("click", () => {
        const show = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", String(show));
        this.events_shown[show ? "add" : "delete"](button.dataset.mark);
        this.request();
      });
    }
    this.plots.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !(event.key in keys)) return;
      event.preventDefault();
      this.act(keys[event.key]);
    });
    // The wheel scrolls the page unless the figure has the focus or Ctrl is held.
    this.plots.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.metaKey && document.activeElement !== this.plots) return;
      event.preventDefault();
      if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) this.axis.pan(event.deltaX / 800);
      else this.axis.zoom(Math.exp(event.deltaY / 400), this.time(event.clientX));
    }, { passive: false });
    this.plots.addEventListener("pointerdown", (event) => {
      this.plots.focus({ preventScroll: true });
      if (event.pointerType === "touch" || event.shiftKey) {
        this.plots.setPointerCapture(event.pointerId);
        this.touches.set(event.pointerId, event.clientX);
      }
    });
    this.plots.addEventListener("pointermove", (event) => this.move(event));
    for (const kind of ["pointerup", "pointercancel"]) {
      this.plots.addEventListener(kind, (event) => this.touches.delete(event.pointerId));
    }
  }

  // One finger (or Shift and the mouse) moves the window, two fingers zoom it.
  move(event) {
    if (!this.touches.has(event.pointerId)) return;
    const before = [...this.touches.values()], middle = this.time((before[0] + before.at(-1)) / 2);
    this.touches.set(event.pointerId, event.clientX);
    const now = [...this.touches.values()], apart = (x) => Math.max(1, Math.abs(x[0] - x[1]));
    if (now.length > 1) this.axis.zoom(apart(before) / apart(now), middle);
    else this.axis.pan((before[0] - now[0]) / this.plots.clientWidth);
  }

  time(clientX) {
    const { plot } = this.panels[0];
    return plot.posToVal(clientX - plot.over.getBoundingClientRect().left, "x");
  }

  act(what) {
    const { axis } = this;
    ({
      in: () => axis.zoom(0.5), out: () => axis.zoom(2), whole: () => axis.reset(),
      left: () => axis.pan(-0.15), right: () => axis.pan(0.15),
      next: () => this.jump(1), previous: () => this.jump(-1),
    })[what]();
  }

  jump(direction) {
    const { axis } = this, whole = axis.stop - axis.start;
    const span = Math.min(axis.to - axis.from, Math.max(EVENT_WINDOW, whole / 100));
    // The event in focus stands a quarter into the window.
    const here = axis.to - axis.from < 0.99 * whole ? axis.from + 0.25 * (axis.to - axis.from) : direction > 0 ? -Infinity : Infinity;
    const slack = 1e-3 * span;
    const at = direction > 0 ? this.events.find((t) => t > here + slack) : this.events.findLast((t) => t < here - slack);
    if (at !== undefined) axis.show(at - 0.25 * span, at + 0.75 * span);
  }

  request() {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => { this.due = false; this.draw(); });
  }

  resize() {
    for (const { plot } of this.panels) if (plot.width !== this.width()) plot.setSize({ width: this.width(), height: plot.height });
    if (this.late) this.request();
  }

  draw() {
    this.late = this.plots.clientWidth === 0;  // folded away: drawn when it is opened
    this.state();
    if (this.late) return;
    for (const { plot } of this.panels) plot.redraw();  // its time scale is the shared one, by `range`
  }

  state() {
    const { from, to } = this.axis, digits = Math.max(1, Math.min(5, 2 - Math.floor(Math.log10(to - from))));
    this.element.dataset.view = `${from} ${to}`;
    this.output.textContent = `${from.toFixed(digits)} … ${to.toFixed(digits)} ${this.figure.unit}`;
  }
}

async function start() {
  const { figures, packed } = JSON.parse(document.getElementById("debist-data").textContent);
  const axes = new Map(), viewers = [], series = {};
  for (const [name, each] of Object.entries(packed)) series[name] = await samples(each);
  // uPlot wants null for a gap, which typed arrays cannot hold; they are three times as fast.
  const values = ({ data, minus, factor }) => {
    const shown = series[data].map((value, i) => (value - (minus === undefined ? 0 : series[minus][i])) * factor);
    return shown.some(Number.isNaN) ? Array.from(shown, (value) => Number.isNaN(value) ? null : value) : shown;
  };
  for (const element of document.querySelectorAll(".viewer")) {
    const figure = figures[element.dataset.figure], key = element.dataset.axis;
    for (const panel of figure.panels) {
      const n = series[panel.series[0].data].length, step = (panel.stop - panel.start) / Math.max(1, n - 1);
      panel.x = Float64Array.from({ length: n }, (_, i) => panel.start + i * step);
      for (const line of panel.series) line.values = values(line);
      for (const band of panel.bands) band.values = [band.high, band.low].map((data) => values({ ...band, data }));
    }
    if (!axes.has(key)) axes.set(key, new TimeAxis(figure.start, figure.stop));
    viewers.push(new Viewer(element, figure, axes.get(key)));
  }
  const redraw = () => viewers.forEach((viewer) => viewer.draw());
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  // On paper the light colours are drawn, whatever the screen shows.
  for (const [kind, paper] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(kind, () => { document.documentElement.classList.toggle("paper", paper); redraw(); });
  }
  redraw();
  document.documentElement.dataset.ready = String(viewers.length);
}

if (typeof DecompressionStream === "undefined") {
  for (const element of document.querySelectorAll(".viewer")) {
    element.textContent = "This browser is too old for the interactive figures (it lacks DecompressionStream); `debist report --figures sans` writes them as SVG and PDF.";
  }
} else start();
