// Draws the plots of a bench of rays, with plot_parts.js before it.

// Rows that have figures.
const rows = race => race.rows.filter(row => !row.failure);

// Each structure has a colour. Its walks share the colour and have lines and bars of their own.
const hue = row => "c" + bench.styles[row.name].colour;
const style = row => `${hue(row)} walk${bench.styles[row.name].walk}`;

// Bars side by side, a group for each kind of ray.
function plotRays(figure) {
    const race = bench.races[Number(figure.dataset.race)], drawn = rows(race);
    if (!drawn.length) return figure.remove();
    const kinds = drawn[0].cells.map(cell => cell.rays);
    const width = 1120, box = { left: 58, right: 1100 };
    let x = box.left + 110, legend = 14; // long rows of names are wrapped
    const names = drawn.map(row => {
        const wide = 26 + 7.6 * row.name.length;
        if (x + wide > box.right) x = box.left + 110, legend += 18;
        x += wide;
        return { row, x: x - wide, y: legend };
    });
    box.top = legend + 26, box.bottom = box.top + 228;
    const height = box.bottom + 38;
    const svg = canvas(figure, width, height, "million rays a second of each structure");
    const top = Math.max(...drawn.flatMap(row => row.cells.map(c => c.mrays_per_second.high ?? c.mrays_per_second.median ?? 0)), 1e-9);
    const y = v => box.bottom - Math.min(1, v / top) * (box.bottom - box.top);
    add(svg, "text", { class: "title", x: box.left, y: 14 }, "Mrays / s");
    const step = 10 ** Math.floor(Math.log10(top)), ticks = top / step < 2 ? step / 4 : top / step < 5 ? step / 2 : step;
    for (let v = 0; v <= top * 1.001; v += ticks) {
        add(svg, "line", { class: "grid", x1: box.left, x2: box.right, y1: y(v), y2: y(v) });
        add(svg, "text", { x: box.left - 8, y: y(v) + 4, "text-anchor": "end" }, short(v));
    }
    const group = (box.right - box.left) / kinds.length, bar = Math.min(46, 0.82 * group / drawn.length);
    kinds.forEach((kind, k) => {
        const middle = box.left + (k + 0.5) * group;
        add(svg, "text", { x: middle, y: box.bottom + 20, "text-anchor": "middle" }, kind);
        drawn.forEach((row, j) => {
            const cell = row.cells[k], m = cell.mrays_per_second, x = middle + (j - drawn.length / 2) * bar;
            if (m.median === null) return;
            const shape = { class: `${cell.agrees ? "fill" : "differs-bar"} ${style(row)}`, x: x + 1.5, y: y(m.median),
                            width: Math.max(1, bar - 3), height: box.bottom - y(m.median), rx: 2 };
            add(add(svg, "rect", shape), "title", {}, `${row.title}, ${kind}: ${short(m.median)} Mrays/s` +
                (cell.agrees ? "" : ", answers differ"));
            if (m.low !== null && m.high !== null)
                add(svg, "line", { class: "whisker", x1: x + bar / 2, x2: x + bar / 2, y1: y(m.low), y2: y(m.high) });
            if (cell.ratio && row.name !== bench.baseline && bar > 24)
                add(svg, "text", { x: x + bar / 2, y: y(m.high ?? m.median) - 6, "text-anchor": "middle" },
                    short(Number(cell.ratio.median.toPrecision(2))));
        });
    });
    for (const { row, x, y } of names) add(svg, "text", { class: `name ${hue(row)}`, x, y }, row.name);
}

// A line for each structure over the meshes' sizes. It shows `value(row, triangles)`, where there is a value.
function plotGrowth(figure, title, name_of, value) {
    const lines = new Map();
    for (const race of bench.races)
        for (const row of rows(race)) {
            const v = value(row, race.triangles), name = name_of(row);
            if (!(v > 0)) continue;
            if (!lines.has(name)) lines.set(name, { c: hue(row), line: style(row), points: [] });
            lines.get(name).points.push({ n: race.triangles, v });
        }
    const points = [...lines.values()].flatMap(line => line.points);
    if (!points.length) return figure.remove();
    const width = 540, height = 400, box = { left: 58, right: 424, top: 30, bottom: 352 };
    const svg = canvas(figure, width, height, title + " against triangles, both logarithmic");
    const range = values => [Math.min(...values) / 1.5, Math.max(...values) * 1.5];
    const x = logScale(...range(points.map(p => p.n)), box.left, box.right);
    const y = logScale(...range(points.map(p => p.v)), box.bottom, box.top);
    for (const t of x.ticks) {
        add(svg, "line", { class: "grid", x1: x.scale(t), x2: x.scale(t), y1: box.top, y2: box.bottom });
        add(svg, "text", { x: x.scale(t), y: box.bottom + 18, "text-anchor": "middle" }, short(t));
    }
    for (const t of y.ticks) {
        add(svg, "line", { class: "grid", x1: box.left, x2: box.right, y1: y.scale(t), y2: y.scale(t) });
        add(svg, "text", { x: box.left - 8, y: y.scale(t) + 4, "text-anchor": "end" }, short(t));
    }
    add(svg, "text", { class: "title", x: box.left, y: 14 }, title);
    add(svg, "text", { x: box.right, y: box.bottom + 38, "text-anchor": "end" }, "triangles");
    const labels = [];
    for (const [name, { c, line, points }] of lines) {
        add(svg, "polyline", { class: `line stroke ${line}`, points: points.map(p => `${x.scale(p.n)},${y.scale(p.v)}`).join(" ") });
        for (const p of points)
            add(add(svg, "circle", { class: `fill ${c}`, cx: x.scale(p.n), cy: y.scale(p.v), r: 3.5 }), "title", {},
                `${name}, ${p.n} triangles: ${short(p.v)}`);
        const last = points[points.length - 1];
        labels.push({ y: y.scale(last.v), from: { x: x.scale(last.n), y: y.scale(last.v) }, c, text: name });
    }
    for (const label of spread(labels, 16, box.top + 8, box.bottom)) {
        add(svg, "line", { class: `stroke ${label.c}`, opacity: 0.35, x1: label.from.x + 6, y1: label.from.y, x2: box.right + 6, y2: label.y });
        add(svg, "text", { class: `name ${label.c}`, x: box.right + 10, y: label.y + 4 }, label.text);
    }
}

const nanoseconds = row => {
    const times = row.cells.map(cell => cell.mrays_per_second.median).filter(v => v > 0).map(v => 1e3 / v);
    return times.reduce((a, b) => a + b, 0) / times.length;
};
const buildTime = (row, triangles) =>
    bench.styles[row.name].walk === 0 ? 1e6 * row.build_seconds.median / triangles : null;

const plots = {
    rays: plotRays,
    build: figure => plotGrowth(figure, "microseconds to build a triangle", row => bench.styles[row.name].built, buildTime),
    trace: figure => plotGrowth(figure, "nanoseconds a ray", row => row.name, nanoseconds),
};
for (const figure of document.querySelectorAll("figure.plot")) plots[figure.dataset.plot](figure);
document.body.dataset.ready = "true";
