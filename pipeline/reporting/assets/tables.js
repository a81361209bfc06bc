// Sortable tables: every <table class="sortable"> gets a button in each heading; the order survives equal values.
"use strict";
for (const table of document.querySelectorAll("table.sortable")) {
  const body = table.tBodies[0];
  const collator = new Intl.Collator(undefined, { numeric: true });
  [...table.tHead.rows[0].cells].forEach((heading, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => {
      const descending = heading.getAttribute("aria-sort") === "ascending";
      for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
      heading.setAttribute("aria-sort", descending ? "descending" : "ascending");
      // data-value carries the number behind a text; rows without one stay at the end either way.
      const key = (row) => row.cells[column].dataset.value ?? row.cells[column].textContent.trim();
      const rows = [...body.rows].map((row) => [key(row), row]);
      rows.sort(([a], [b]) => {
        if (a === "" || b === "") return (a === "") - (b === "");
        const x = Number(a), y = Number(b);
        const order = Number.isNaN(x) || Number.isNaN(y) ? collator.compare(a, b) : x - y;
        return descending ? -order : order;
      });
      body.append(...rows.map(([, row]) => row));
    });
  });
}
// A page does not hold its own folder, so that equal runs have equal pages: where it was opened from is filled in here.
const run = document.getElementById("run");
if (run && location.protocol === "file:") {
  const folder = decodeURIComponent(location.pathname).replace(/\/[^/]*$/, "").replace(/^\/(?=[A-Za-z]:)/, "");
  const windows = /^[A-Za-z]:/.test(folder);
  // In single quotes a shell expands nothing; cmd knows none, and within double quotes PowerShell expands these signs.
  const quoted = windows ? `"${folder}"` : `'${folder.replaceAll("'", `'\\''`)}'`;
  const commands = document.getElementById("commands");
  if (!windows || !/[$`%"]/.test(folder)) {
    commands.textContent = commands.textContent.replaceAll("RUN", () => (/^[\w.\/:-]+$/.test(folder) ? folder : quoted));
    run.remove();
  }
}
