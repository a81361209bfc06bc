// The table of a large fleet: columns of numbers, of which the rows in sight are in the document.
"use strict";
const ROW = 29, BEYOND = 12, BADGES = ["", "good", "fair", "poor", "failed"];

class FleetTable {
  constructor(columns) {
    Object.assign(this, columns, { order: null, shown: null, sorted: null, descending: false, from: -1 });
    this.table = document.getElementById("fleet");
    this.window = this.table.parentElement;
    this.tools = document.getElementById("fleet-tools");
    this.output = this.tools.querySelector("output");
    this.order = Uint32Array.from({ length: this.count }, (_, i) => i);
    [...this.table.tHead.rows[0].cells].forEach((heading, column) => {
      const button = document.createElement("button");
      button.type = "button";
      button.append(...heading.childNodes);
      heading.append(button);
      button.addEventListener("click", () => this.sort(column, heading));
    });
    this.window.addEventListener("scroll", () => requestAnimationFrame(() => this.draw()));
    for (const input of this.tools.querySelectorAll("input")) input.addEventListener("input", () => this.filter());
    this.tools.hidden = false;
    this.filter();
  }

  static async load(stored) {
    const text = async (packed) => new TextDecoder().decode(await inflate(packed)).split("\n");
    const grades = await inflate(stored.grades), n = stored.count;
    const part = (k) => grades.subarray(k * n, (k + 1) * n);
    const quantities = await Promise.all(stored.quantities.map(async (q) => {
      const planes = await inflate(q.values), bytes = new Uint8Array(4 * n);
      for (let plane = 0; plane < 4; plane++) for (let i = 0; i < n; i++) bytes[4 * i + plane] = planes[plane * n + i];
      return { values: new Float32Array(bytes.buffer), outliers: await inflate(q.outliers), decimals: q.decimals, scored: q.scored };
    }));
    const [data, model, paged, diverged] = [0, 1, 2, 3].map(part);
    const reasons = new Map(), lines = await text(stored.reasons);
    for (let i = 0; i < n; i++) if (model[i] === 4) reasons.set(i, lines[reasons.size]);
    return new FleetTable({ count: n, names: await text(stored.names), whys: await text(stored.whys), suffix: stored.suffix, data, model, paged, diverged, reasons, quantities });
  }

  // Rows without a value stay at the end either way; equal ones keep the order of the names.
  sort(column, heading) {
    this.descending = heading.getAttribute("aria-sort") === "ascending";
    for (const other of this.table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", this.descending ? "descending" : "ascending");
    const sign = this.descending ? -1 : 1, order = Array.from({ length: this.count }, (_, i) => i);
    if (column === 0) {
      const rank = new Uint32Array(this.count), collator = new Intl.Collator(undefined, { numeric: true });
      [...order].sort((a, b) => collator.compare(this.names[a], this.names[b])).forEach((row, i) => { rank[row] = i; });
      order.sort((a, b) => sign * (rank[a] - rank[b]));
    } else {
      const values = column < 3 ? Array.from([this.data, this.model][column - 1], (v) => v || NaN) : this.quantities[column - 3].values;
      order.sort((a, b) => {
        const x = values[a], y = values[b], lost = Number.isNaN(x) - Number.isNaN(y);
        return lost || (Number.isNaN(x) ? 0 : sign * (x - y)) || a - b;
      });
    }
    this.order = Uint32Array.from(order);
    this.filter();
  }

  filter() {
    const [search, ...boxes] = this.tools.querySelectorAll("input"), text = search.value.trim().toLowerCase();
    const wanted = new Set(boxes.filter((box) => box.checked).map((box) => box.value));
    this.shown = this.order.filter((row) =>
      (!text || this.names[row].toLowerCase().includes(text)) &&
      (!wanted.has("failed") || this.model[row] === 4) &&
      (!wanted.has("outliers") || this.quantities.some((q) => q.outliers[row])));
    this.output.textContent = `${this.shown.length} of ${this.count}`;
    this.window.scrollTop = 0;
    this.from = -1;
    this.draw();
  }

  draw() {
    const from = Math.max(0, Math.floor(this.window.scrollTop / ROW) - BEYOND);
    const to = Math.min(this.shown.length, from + Math.ceil(this.window.clientHeight / ROW) + 2 * BEYOND);
    if (from === this.from) return;
    this.from = from;
    const rows = [];
    for (let i = from; i < to; i++) rows.push(this.row(this.shown[i]));
    this.table.tBodies[0].replaceChildren(this.space(from), ...rows, this.space(this.shown.length - to));
    document.documentElement.dataset.fleet = `${from} ${to}`;
  }

  space(rows) {
    const line = document.createElement("tr"), cell = line.insertCell();
    line.className = "space";
    cell.colSpan = this.quantities.length + 3;
    cell.style.height = `${rows * ROW}px`;
    line.hidden = rows === 0;
    return line;
  }

  row(i) {
    const line = document.createElement("tr"), name = line.insertCell();
    line.style.height = `${ROW}px`;
    name.className = "name";
    name.title = this.names[i];
    if (this.paged[i] && this.suffix) {
      const link = document.createElement("a");
      link.href = `./${encodeURIComponent(this.names[i])}${this.suffix}`;
      link.textContent = this.names[i];
      name.append(link);
    } else name.textContent = this.names[i];
    for (const grade of [this.data[i], this.model[i]]) {
      const cell = line.insertCell();
      if (grade === 4) {
        cell.textContent = "failed";
        cell.title = this.reasons.get(i) ?? "";
      } else if (grade) {
        const badge = document.createElement("span");
        badge.className = `badge ${BADGES[grade]}`;
        badge.textContent = BADGES[grade];
        badge.title = this.whys[i];
        cell.append(badge);
      }
    }
    this.quantities.forEach((q, k) => {
      const cell = line.insertCell(), value = q.values[i];
      cell.className = q.outliers[i] ? "number outlier" : "number";
      const unknown = k === 0 && this.diverged[i] & 1 ? "diverged" : "–";
      cell.textContent = Number.isNaN(value) ? unknown : (q.outliers[i] ? "▲ " : "") + this.digits(value, q.decimals) + (q.scored && this.diverged[i] & 2 ? " (training)" : "");
    });
    return line;
  }

  digits(value, decimals) {
    if (decimals !== null) return value.toFixed(decimals).replace("-", "−");
    const text = Number(value.toPrecision(3));
    return (Math.abs(text) >= 1e6 || (text !== 0 && Math.abs(text) < 1e-4) ? text.toExponential() : String(text)).replace("-", "−");
  }
}

FleetTable.load(JSON.parse(document.getElementById("fleet-columns").textContent));
