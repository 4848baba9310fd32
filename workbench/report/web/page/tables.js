// Tables that sort: by a click on a column's heading, or Enter or the space bar on it. The first
// click sorts up, the second down, the third restores the order that the report was written in.

// The number that a cell shows, or none: "1,830", "<0.001", "2.59 %", "–".
function numberOf(text) {
  const number = Number.parseFloat(text.replace(/[<,×]/g, ""));
  return Number.isNaN(number) ? null : number;
}

// Compares cells: numbers by value, words by the alphabet; what is missing comes last.
function compare(a, b) {
  const [x, y] = [numberOf(a), numberOf(b)];
  if (x !== null && y !== null) return x - y;
  if (x === null && y === null) return a.localeCompare(b);
  return x === null ? 1 : -1;
}

const cellText = (row, column) => row.cells[column].textContent.trim();

function sortRows(body, original, column, direction) {
  const sign = direction === "descending" ? -1 : 1;
  const isMissing = (row) => cellText(row, column) === "–";
  const rows = [...original];
  if (direction !== "none") {
    rows.sort((a, b) => {
      if (isMissing(a) !== isMissing(b)) return isMissing(a) ? 1 : -1;
      return sign * compare(cellText(a, column), cellText(b, column));
    });
  }
  body.append(...rows);
}

// The headings of single columns, each with the index of its cells in a row of the body.
function columnHeadings(table) {
  const taken = []; // rows of the head that a heading above reaches into, by column
  const headings = [];
  [...table.tHead.rows].forEach((row, level) => {
    let column = 0;
    for (const heading of row.cells) {
      while ((taken[column] ?? 0) > level) ++column;
      if (heading.colSpan === 1) headings.push({ heading, column });
      for (let i = 0; i < heading.colSpan; ++i) taken[column + i] = level + heading.rowSpan;
      column += heading.colSpan;
    }
  });
  return headings.sort((a, b) => a.column - b.column);
}

const next = { none: "ascending", ascending: "descending", descending: "none" };

export function makeSortable(table) {
  const body = table.tBodies[0];
  const original = [...body.rows];
  const headings = columnHeadings(table);
  for (const { heading, column } of headings) {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...heading.childNodes);
    heading.append(button);
    heading.setAttribute("aria-sort", "none");
    button.addEventListener("click", () => {
      const direction = next[heading.getAttribute("aria-sort")];
      for (const each of headings) each.heading.setAttribute("aria-sort", "none");
      heading.setAttribute("aria-sort", direction);
      sortRows(body, original, column, direction);
    });
  }
}
