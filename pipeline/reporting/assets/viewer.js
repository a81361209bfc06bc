// The time-series viewer: panels over one shared time axis; mouse, touch and keyboard; sharp at every zoom.
"use strict";
const MARGIN = { left: 66, right: 10, top: 18, bottom: 36, between: 16 }, PANEL = 150, EVENT_WINDOW = 1.5;

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

function ticks(low, high, about) {
  const raw = (high - low) / about, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((m) => m * power >= raw * (1 - 1e-9)) * power;
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), list = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) {
    list.push([k * step, (k * step + 0).toFixed(decimals).replace("-", "−")]);
  }
  return list;
}

class Viewer {
  constructor(element, figure, axis) {
    Object.assign(this, { element, figure, axis, hidden: new Set(), cursor: null, drag: null, touches: new Map(), due: false });
    this.canvas = element.querySelector("canvas");
    this.output = element.querySelector("output");
    const n = figure.panels.length;
    this.height = MARGIN.top + n * PANEL + (n - 1) * MARGIN.between + MARGIN.bottom;
    this.canvas.style.height = `${this.height}px`;
    this.events = figure.marks.flatMap((mark) => mark.at).sort((a, b) => a - b);
    axis.viewers.add(this);
    this.listen();
    new ResizeObserver(() => this.request()).observe(this.canvas);
  }

  listen() {
    for (const button of this.element.querySelectorAll("button[data-do]")) {
      button.addEventListener("click", () => this.act(button.dataset.do));
    }
    for (const button of this.element.querySelectorAll("button[data-series]")) {
      if (button.getAttribute("aria-pressed") === "false") this.hidden.add(button.dataset.series);
      button.addEventListener("click", () => {
        const shown = button.getAttribute("aria-pressed") !== "true", label = button.dataset.series;
        button.setAttribute("aria-pressed", String(shown));
        if (shown) this.hidden.delete(label); else this.hidden.add(label);
        this.request();
      });
    }
    const keys = { ArrowLeft: "left", ArrowRight: "right", "+": "in", "=": "in", "-": "out", 0: "whole", Home: "whole", Escape: "whole", PageDown: "next", PageUp: "previous" };
    this.canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !(event.key in keys)) return;
      event.preventDefault();
      this.act(keys[event.key]);
    });
    // The wheel scrolls the page unless the figure has the focus or Ctrl is held.
    this.canvas.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.metaKey && document.activeElement !== this.canvas) return;
      event.preventDefault();
      if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) this.axis.pan(event.deltaX / 800);
      else this.axis.zoom(Math.exp(event.deltaY / 400), this.time(event.offsetX));
    }, { passive: false });
    this.canvas.addEventListener("dblclick", () => this.axis.reset());
    this.canvas.addEventListener("pointerdown", (event) => this.down(event));
    this.canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const kind of ["pointerup", "pointercancel"]) this.canvas.addEventListener(kind, (event) => this.up(event));
    this.canvas.addEventListener("pointerleave", () => { this.cursor = null; this.request(); });
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
    const found = direction > 0 ? this.events.find((t) => t > here + slack) : this.events.findLast((t) => t < here - slack);
    if (found !== undefined) axis.show(found - 0.25 * span, found + 0.75 * span);
  }

  time(px) {
    const width = this.canvas.clientWidth - MARGIN.left - MARGIN.right;
    return this.axis.from + (px - MARGIN.left) / width * (this.axis.to - this.axis.from);
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
    if (event.pointerType === "touch") this.touches.set(event.pointerId, event.offsetX);
    else if (event.button === 0) this.drag = { from: event.offsetX, to: event.offsetX, pan: event.shiftKey };
  }

  move(event) {
    this.cursor = event.offsetX;
    if (this.touches.has(event.pointerId)) {
      const before = [...this.touches.values()], middle = this.time((before[0] + before.at(-1)) / 2);
      this.touches.set(event.pointerId, event.offsetX);
      const now = [...this.touches.values()];
      if (now.length > 1) {
        this.axis.zoom(Math.max(1, Math.abs(before[0] - before[1])) / Math.max(1, Math.abs(now[0] - now[1])), middle);
      } else this.axis.pan((before[0] - now[0]) / this.canvas.clientWidth);
    } else if (this.drag?.pan) {
      this.axis.pan((this.drag.to - event.offsetX) / this.canvas.clientWidth);
      this.drag.to = event.offsetX;
    } else if (this.drag) this.drag.to = event.offsetX;
    this.request();
  }

  up(event) {
    this.touches.delete(event.pointerId);
    const { drag } = this;
    this.drag = null;
    if (drag && !drag.pan && event.type === "pointerup" && Math.abs(drag.to - drag.from) > 6) {
      const ends = [this.time(drag.from), this.time(drag.to)].sort((a, b) => a - b);
      this.axis.show(...ends);
    }
    this.request();
  }

  request() {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => { this.due = false; this.draw(); });
  }

  draw() {
    const { canvas, axis, figure } = this, ratio = window.devicePixelRatio || 1, width = canvas.clientWidth;
    if (width === 0) return;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(this.height * ratio);
    const context = canvas.getContext("2d"), style = getComputedStyle(document.documentElement);
    const css = (name) => style.getPropertyValue(`--${name}`).trim();
    context.scale(ratio, ratio);
    context.font = "12px system-ui, sans-serif";
    const left = MARGIN.left, right = width - MARGIN.right, plot = { left, right, css, context };
    plot.toX = (t) => left + (t - axis.from) / (axis.to - axis.from) * (right - left);
    plot.times = ticks(axis.from * figure.factor, axis.to * figure.factor, Math.max(4, Math.floor((right - left) / 90)));
    figure.panels.forEach((panel, k) => this.panel(panel, MARGIN.top + k * (PANEL + MARGIN.between), plot));
    const bottom = this.height - MARGIN.bottom;
    context.fillStyle = css("ink");
    context.textAlign = "center";
    for (const [value, text] of plot.times) context.fillText(text, plot.toX(value / figure.factor), bottom + 16);
    context.fillText(figure.axis, (left + right) / 2, bottom + 31);
    this.window(plot);
    this.pointer(plot, bottom);
    this.element.dataset.view = `${axis.from} ${axis.to}`;
    const digits = Math.max(1, Math.min(5, 2 - Math.floor(Math.log10(axis.to - axis.from))));
    this.output.textContent = `${axis.from.toFixed(digits)} … ${axis.to.toFixed(digits)} ${figure.unit}`;
  }

  // Where the window lies in the whole record.
  window({ context, css, left, right }) {
    const { start, stop, from, to } = this.axis, share = (t) => left + (t - start) / (stop - start) * (right - left);
    context.fillStyle = css("grid");
    context.fillRect(left, 2, right - left, 4);
    context.fillStyle = css("accent");
    context.fillRect(share(from), 2, Math.max(3, share(to) - share(from)), 4);
  }

  panel(panel, top, plot) {
    const { context, css, left, right, toX } = plot, { from, to } = this.axis, bottom = top + PANEL;
    const shown = panel.series.filter((series) => !this.hidden.has(series.label));
    let low = Infinity, high = -Infinity;
    for (const series of shown) {
      const [a, b] = series.extent(from, to);
      low = Math.min(low, a);
      high = Math.max(high, b);
    }
    if (!(high >= low)) [low, high] = [-1, 1];
    const pad = 0.06 * (high - low) || Math.abs(low) * 0.05 || 1;
    [low, high] = [low - pad, high + pad];
    const toY = (value) => bottom - (value - low) / (high - low) * PANEL;
    context.save();
    context.beginPath();
    context.rect(left, top, right - left, PANEL);
    context.clip();
    context.fillStyle = css("gap");
    for (const [a, b] of this.figure.gaps) context.fillRect(toX(a), top, Math.max(1, toX(b) - toX(a)), PANEL);
    const upright = (positions, colour, dash) => {
      context.strokeStyle = colour;
      context.lineWidth = 1;
      context.setLineDash(dash);
      context.beginPath();
      for (const x of positions) { context.moveTo(Math.round(toX(x)) + 0.5, top); context.lineTo(Math.round(toX(x)) + 0.5, bottom); }
      context.stroke();
      context.setLineDash([]);
    };
    upright(plot.times.map(([value]) => value / this.figure.factor), css("grid"), []);
    for (const mark of this.figure.marks) upright(mark.at, css(mark.colour), mark.dash);
    const levels = ticks(low, high, 5);
    context.strokeStyle = css("grid");
    context.beginPath();
    for (const [value] of levels) { context.moveTo(left, toY(value)); context.lineTo(right, toY(value)); }
    context.stroke();
    for (const series of shown) {
      context.strokeStyle = css(series.slot);
      context.lineWidth = series.wide ? 3 : 1.4;
      context.lineJoin = "round";
      context.beginPath();
      const line = series.trace(context, from, to, toX, toY, right - left);
      context.setLineDash(line ? series.dash : []);
      context.stroke();
    }
    context.setLineDash([]);
    context.restore();
    context.strokeStyle = css("rule");
    context.strokeRect(left + 0.5, top + 0.5, right - left - 1, PANEL - 1);
    context.fillStyle = css("ink");
    context.textAlign = "right";
    for (const [value, text] of levels) context.fillText(text, left - 6, toY(value) + 4);
    context.save();
    context.translate(13, (top + bottom) / 2);
    context.rotate(-Math.PI / 2);
    context.textAlign = "center";
    context.fillText(panel.label, 0, 0);
    context.restore();
    this.values(shown, top, plot);
  }

  // The samples under the pointer, in rows from the panel's upper left corner.
  values(shown, top, { context, css, left, right }) {
    if (this.cursor === null || this.cursor < left || this.cursor > right) return;
    const at = this.time(this.cursor);
    let x = left + 8, y = top + 3;
    context.textAlign = "left";
    const place = (series) => /^m\d$/.test(series.slot) ? Number(series.slot[1]) : -1;  // as in the legend
    for (const series of [...shown].sort((a, b) => place(a) - place(b))) {
      const value = series.value(at), text = `${series.label} ${Number.isNaN(value) ? "–" : value.toPrecision(4).replace("-", "−")}`;
      const width = context.measureText(text).width;
      if (x > left + 8 && x + width > right) [x, y] = [left + 8, y + 17];
      context.fillStyle = css("page");
      context.globalAlpha = 0.85;
      context.fillRect(x - 3, y, width + 6, 16);
      context.globalAlpha = 1;
      context.fillStyle = css(series.slot);
      context.fillText(text, x, y + 12);
      x += width + 14;
    }
  }

  pointer({ context, css, left, right }, bottom) {
    if (this.drag && !this.drag.pan) {
      context.fillStyle = css("accent");
      context.globalAlpha = 0.15;
      context.fillRect(this.drag.from, MARGIN.top, this.drag.to - this.drag.from, bottom - MARGIN.top);
      context.globalAlpha = 1;
    }
    if (this.cursor === null || this.cursor < left || this.cursor > right) return;
    context.strokeStyle = css("soft");
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(Math.round(this.cursor) + 0.5, MARGIN.top);
    context.lineTo(Math.round(this.cursor) + 0.5, bottom);
    context.stroke();
    const text = `t = ${(this.time(this.cursor) * this.figure.factor).toPrecision(6)} ${this.figure.unit}`;
    context.fillStyle = css("soft");
    context.textAlign = this.cursor > right - 90 ? "right" : "left";
    context.fillText(text, this.cursor + (this.cursor > right - 90 ? -5 : 5), bottom - 5);
  }
}

async function start() {
  const { figures, packed } = JSON.parse(document.getElementById("debist-data").textContent);
  const axes = new Map(), viewers = [], known = new Map();
  const load = (meta) => {
    const key = [meta.data, meta.minus, meta.factor].join();
    if (!known.has(key)) known.set(key, Series.load(meta, packed));
    return known.get(key).then((series) => Object.assign(Object.create(Series.prototype), series, meta));
  };
  for (const element of document.querySelectorAll(".viewer")) {
    const figure = figures[element.dataset.figure];
    for (const panel of figure.panels) panel.series = await Promise.all(panel.series.map(load));
    const key = element.dataset.axis;
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
    element.textContent = "This browser is too old for the interactive figures (it lacks DecompressionStream); `debist plot` draws them as SVG, PDF or PNG.";
  }
} else start();
