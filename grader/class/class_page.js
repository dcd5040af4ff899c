// Filter and order of the table; all text is in the page itself. The address keeps the filter, so that
// a view can be sent to somebody.
"use strict";
const table = document.getElementById("class"), body = table.tBodies[0];
const find = document.getElementById("find"), verdict = document.getElementById("verdict");
const rows = [...body.rows];
const texts = new Map(rows.map(row => [row, row.textContent.toLowerCase()]));

function filter() {
    const words = find.value.toLowerCase().split(/\s+/).filter(word => word);
    let shown = 0;
    for (const row of rows) {
        const fits = (!verdict.value || row.dataset.verdict === verdict.value)
            && words.every(word => texts.get(row).includes(word));
        row.hidden = !fits;
        shown += fits;
    }
    document.getElementById("shown").textContent = `${shown} of ${rows.length}`;
    const view = new URLSearchParams();
    if (find.value) view.set("find", find.value);
    if (verdict.value) view.set("verdict", verdict.value);
    history.replaceState(null, "", view.size ? "#" + view : location.pathname + location.search);
}

function sortBy(head) {
    const column = head.cellIndex, down = head.ariaSort === "ascending";
    for (const other of table.tHead.rows[0].cells) if (other.hasAttribute("aria-sort")) other.ariaSort = "none";
    head.ariaSort = down ? "descending" : "ascending";
    const key = row => row.cells[column].dataset.sort ?? row.cells[column].textContent;
    const order = new Intl.Collator(undefined, { numeric: true });
    // Equal ones keep their order: sort by a task, then by verdict.
    const sorted = [...body.rows].sort((a, b) => (down ? -1 : 1) * compare(key(a), key(b), order));
    body.append(...sorted);
}
// Points may be -1: no marks.
function compare(a, b, order) {
    const x = Number(a), y = Number(b);
    return Number.isNaN(x) || Number.isNaN(y) ? order.compare(a, b) : x - y;
}

for (const head of table.tHead.rows[0].cells)
    head.querySelector("button")?.addEventListener("click", () => sortBy(head));
find.addEventListener("input", filter);
verdict.addEventListener("change", filter);
document.querySelector(".filter").addEventListener("submit", event => event.preventDefault());
addEventListener("keydown", event => { // as in many programs, '/' leads to the search
    if (event.key !== "/" || /^(INPUT|SELECT)$/.test(document.activeElement.tagName)) return;
    event.preventDefault();
    find.focus();
});
const view = new URLSearchParams(location.hash.slice(1));
find.value = view.get("find") ?? "";
verdict.value = view.get("verdict") ?? "";
filter();
document.body.dataset.ready = "true";
