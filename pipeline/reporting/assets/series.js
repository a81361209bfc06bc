// Samples as `pipeline/reporting/page.py` packed them, and pyramids of their extremes for drawing at any zoom.
"use strict";
const MISSING = 65535, BRANCHES = 4;

async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Two byte planes of differences modulo 2^16 back to samples; NaN where there is none.
async function samples(packed, key) {
  const planes = await inflate(packed[key]), n = packed.n, values = new Float64Array(n);
  for (let i = 0, code = 0; i < n; i++) {
    code = (code + planes[i] + 256 * planes[n + i]) & 65535;
    values[i] = code === MISSING ? NaN : packed.low + packed.step * code;
  }
  return values;
}

// Levels of least and largest values: level 0 are the samples, each next one joins four buckets.
function pyramid(low, high) {
  const levels = [{ low, high, size: 1 }];
  while (levels.at(-1).low.length > 64) {
    const last = levels.at(-1), n = Math.ceil(last.low.length / BRANCHES);
    const next = { low: new Float64Array(n).fill(NaN), high: new Float64Array(n).fill(NaN), size: last.size * BRANCHES };
    for (let i = 0; i < last.low.length; i++) {
      const j = Math.floor(i / BRANCHES);
      if (!(next.low[j] <= last.low[i])) next.low[j] = Number.isNaN(last.low[i]) ? next.low[j] : last.low[i];
      if (!(next.high[j] >= last.high[i])) next.high[j] = Number.isNaN(last.high[i]) ? next.high[j] : last.high[i];
    }
    levels.push(next);
  }
  return levels;
}

class Series {
  constructor(meta, levels, count) {
    Object.assign(this, meta);
    this.levels = levels;
    this.exact = count === 1;
    this.step = (meta.stop - meta.start) / Math.max(1, meta.samples - 1) * count;
  }

  // A series in the unit of its axis; with `minus`, the difference of two.
  static async load(meta, packed) {
    const part = packed[meta.data], shown = (values) => values.map((value) => value * meta.factor);
    let low = shown(await samples(part, "data"));
    if (meta.minus !== undefined) {
      const other = shown(await samples(packed[meta.minus], "data"));
      low = low.map((value, i) => value - other[i]);
    }
    const high = part.high_data === undefined ? low : shown(await samples(part, "high_data"));
    return new Series(meta, pyramid(low, high), part.count);
  }

  // Rows of level 0 that reach into [from, to].
  rows(from, to) {
    const n = this.levels[0].low.length;
    const first = Math.max(0, Math.floor((from - this.start) / this.step) - 1);
    return [first, Math.min(n, Math.ceil((to - this.start) / this.step) + 2)];
  }

  value(x) {
    const i = Math.round((x - this.start) / this.step);
    return i >= 0 && i < this.levels[0].low.length ? this.levels[0].low[i] : NaN;
  }

  // Least and largest value in sight.
  extent(from, to) {
    const level = this.coarsest(from, to, 400), [first, last] = this.rows(from, to);
    let low = Infinity, high = -Infinity;
    for (let i = Math.floor(first / level.size); i < Math.min(level.low.length, Math.ceil(last / level.size)); i++) {
      if (level.low[i] < low) low = level.low[i];
      if (level.high[i] > high) high = level.high[i];
    }
    return [low, high];
  }

  // The coarsest level that still has `buckets` buckets in sight.
  coarsest(from, to, buckets) {
    const [first, last] = this.rows(from, to);
    return this.levels.findLast((level) => (last - first) / level.size >= buckets) ?? this.levels[0];
  }

  // Add to the path: a polyline while samples are apart, else through the least and the largest of each pixel.
  trace(context, from, to, toX, toY, pixels) {
    const [first, last] = this.rows(from, to);
    if (this.exact && last - first <= 4 * pixels) {
      const y = this.levels[0].low;
      for (let i = first, down = false; i < last; i++) {
        if (Number.isNaN(y[i])) { down = false; continue; }
        const px = toX(this.start + i * this.step), py = toY(y[i]);
        if (down) context.lineTo(px, py); else context.moveTo(px, py);
        down = true;
      }
      return true;
    }
    const level = this.coarsest(from, to, 2 * pixels);
    let column = null, low = 0, high = 0, last_y = null, last_column = null;
    // From the end of the column before to the nearer extreme, then to the other one: flanks stay smooth and closed.
    const stroke = () => {
      if (column === null) return;
      const near = toY(low), far = toY(high), gap = last_column === null || column > last_column + 3;
      const turned = !gap && Math.abs(last_y - near) > Math.abs(last_y - far), x = column + 0.5;
      const [first_y, second_y] = turned ? [far, near] : [near, far];
      if (gap) context.moveTo(x, first_y); else context.lineTo(x, first_y);
      context.lineTo(x, second_y);
      [last_y, last_column] = [second_y, column];
    };
    for (let j = Math.floor(first / level.size); j < Math.min(level.low.length, Math.ceil(last / level.size)); j++) {
      if (Number.isNaN(level.low[j])) continue;
      const px = Math.floor(toX(this.start + (j + 0.5) * level.size * this.step));
      if (px !== column) { stroke(); column = px; low = level.low[j]; high = level.high[j]; }
      low = Math.min(low, level.low[j]);
      high = Math.max(high, level.high[j]);
    }
    stroke();
    return false;
  }
}
