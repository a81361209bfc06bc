// Samples as `pipeline/reporting/page.py` packed them.
"use strict";
const MISSING = 65535;

async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Two byte planes of differences modulo 2^16 back to samples; NaN where there is none.
async function samples({ n, low, step, data }) {
  const planes = await inflate(data), values = new Float64Array(n);
  for (let i = 0, code = 0; i < n; i++) {
    code = (code + planes[i] + 256 * planes[n + i]) & 65535;
    values[i] = code === MISSING ? NaN : low + step * code;
  }
  return values;
}
