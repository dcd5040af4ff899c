// Draws the plots of a bench, with plot_parts.js before it.

// Rows that have figures, with their place in the table (and so their colour).
const rows = scene => scene.rows.map((row, i) => ({ ...row, i })).filter(row => !row.failure);

function plotError(figure, scene) {
    const drawn = rows(scene).filter(row => row.agrees && row.points.every(p => p.seconds > 0 && p.rel_mse > 0));
    if (!drawn.length) return figure.remove();
    const target = bench.target_rel_mse;
    const ends = drawn.map(row => row.seconds_to_target.median).filter(t => t > 0);
    const times = [...drawn.flatMap(row => row.points.map(p => p.seconds)), ...ends];
    const errors = [...drawn.flatMap(row => row.points.map(p => p.rel_mse)), target];
    const width = 540, height = 400, box = { left: 52, right: 424, top: 30, bottom: 352 };
    const svg = canvas(figure, width, height, "relMSE against seconds, both logarithmic");
    const x = logScale(Math.min(...times) / 1.5, Math.max(...times) * 1.5, box.left, box.right);
    const y = logScale(Math.min(...errors) / 1.6, Math.max(...errors) * 1.6, box.bottom, box.top);
    for (const t of x.ticks) {
        add(svg, "line", { class: "grid", x1: x.scale(t), x2: x.scale(t), y1: box.top, y2: box.bottom });
        add(svg, "text", { x: x.scale(t), y: box.bottom + 18, "text-anchor": "middle" }, short(t));
    }
    for (const e of y.ticks) {
        add(svg, "line", { class: "grid", x1: box.left, x2: box.right, y1: y.scale(e), y2: y.scale(e) });
        add(svg, "text", { x: box.left - 8, y: y.scale(e) + 4, "text-anchor": "end" }, short(e));
    }
    add(svg, "text", { class: "title", x: box.left, y: 14 }, "relMSE");
    add(svg, "text", { x: box.right, y: box.bottom + 38, "text-anchor": "end" }, "seconds, start-up taken out");

    // 1 / N through every second decade of the upper edge and the left one.
    const id = "clip" + figure.dataset.scene, clip = add(add(svg, "defs"), "clipPath", { id });
    add(clip, "rect", { x: box.left, y: box.top, width: box.right - box.left, height: box.bottom - box.top });
    const guides = add(svg, "g", { "clip-path": `url(#${id})` });
    const products = [Math.log10(x.low * y.low), Math.log10(x.high * y.high)];
    for (let c = Math.ceil(products[0]); c <= products[1]; c++)
        add(guides, "line", { class: "guide", x1: x.scale(x.low), y1: y.scale(10 ** c / x.low),
                              x2: x.scale(x.high), y2: y.scale(10 ** c / x.high) });
    add(svg, "line", { class: "target", x1: box.left, x2: box.right, y1: y.scale(target), y2: y.scale(target) });
    add(svg, "text", { x: box.left + 6, y: y.scale(target) - 6 }, "target " + short(target));

    const labels = [];
    for (const row of drawn) {
        const c = colour(row.i), last = row.points[row.points.length - 1];
        const points = row.points.map(p => `${x.scale(p.seconds)},${y.scale(p.rel_mse)}`).join(" ");
        const end = row.seconds_to_target.median;
        let tip = { x: x.scale(last.seconds), y: y.scale(last.rel_mse) };
        if (end > 0) {
            add(svg, "line", { class: `beyond stroke ${c}`, x1: tip.x, y1: tip.y, x2: x.scale(end), y2: y.scale(target) });
            const ring = add(svg, "circle", { class: `hollow stroke ${c}`, cx: x.scale(end), cy: y.scale(target), r: 4.5 });
            add(ring, "title", {}, `${row.name}: ${short(end)} s to relMSE ${target}`);
        }
        add(svg, "polyline", { class: `line stroke ${c}`, points });
        for (const p of row.points)
            add(add(svg, "circle", { class: `fill ${c}`, cx: x.scale(p.seconds), cy: y.scale(p.rel_mse), r: 4 }),
                "title", {}, `${row.name}, ${p.spp} spp: ${short(p.seconds)} s, relMSE ${short(p.rel_mse)}`);
        labels.push({ x: tip.x, y: tip.y, from: tip, c, text: row.name });
    }
    for (const label of spread(labels, 16, box.top + 8, box.bottom)) {
        add(svg, "line", { class: `stroke ${label.c}`, opacity: 0.35, x1: label.from.x + 6, y1: label.from.y,
                           x2: box.right + 6, y2: label.y });
        add(svg, "text", { class: `name ${label.c}`, x: box.right + 10, y: label.y + 4 }, label.text);
    }
}

function plotEfficiency(figure, scene) {
    const drawn = rows(scene).filter(row => row.efficiency.median > 0)
        .sort((a, b) => b.agrees - a.agrees || b.efficiency.median - a.efficiency.median);
    if (!drawn.length) return figure.remove();
    const width = 540, step = Math.min(58, 330 / drawn.length), left = 112, right = 400, top = 34;
    const svg = canvas(figure, width, Math.max(400, top + step * drawn.length + 20), "efficiency of each contestant");
    add(svg, "text", { class: "title", x: left, y: 14 }, "efficiency, 1 / (MSE s)");
    const high = Math.max(...drawn.filter(row => row.agrees).map(row => row.efficiency.high ?? 1.3 * row.efficiency.median), 1e-30);
    const x = v => left + Math.min(1, v / high) * (right - left);
    drawn.forEach((row, k) => {
        const y = top + k * step, bar = Math.min(26, step * 0.55), middle = y + bar / 2, c = colour(row.i);
        add(svg, "text", { class: `name ${c}`, x: left - 10, y: middle + 4, "text-anchor": "end" }, row.name);
        if (!row.agrees) {
            add(svg, "rect", { class: `differs-bar ${c}`, x: left, y, width: 90, height: bar, rx: 2 });
            add(svg, "text", { x: left + 100, y: middle + 4 }, "images differ: no ratio");
            return;
        }
        const { median } = row.efficiency, low = row.efficiency.low ?? 0, top_of = row.efficiency.high ?? high;
        const ends = [row.efficiency.low, row.efficiency.high].map(v => v === null ? "open" : short(v));
        add(add(svg, "rect", { class: `fill ${c}`, x: left, y, width: Math.max(1, x(median) - left), height: bar, rx: 2 }),
            "title", {}, `${row.title}: ${short(median)} (${ends[0]} to ${ends[1]})`);
        add(svg, "line", { class: "whisker", x1: x(low), x2: x(top_of), y1: middle, y2: middle });
        for (const v of [row.efficiency.low, row.efficiency.high].filter(v => v !== null)) // an open end has no bar
            add(svg, "line", { class: "whisker", x1: x(v), x2: x(v), y1: middle - 5, y2: middle + 5 });
        const ratio = row.efficiency_ratio && !row.baseline ? `  ×${short(row.efficiency_ratio.median)}` : "";
        add(svg, "text", { class: "value", x: x(top_of) + 10, y: middle + 4 },
            short(median) + (row.baseline ? "  baseline" : ratio));
    });
    add(svg, "line", { class: "axis", x1: left, x2: left, y1: top - 8, y2: top + step * drawn.length });
}

function plotBounces(figure, scene) {
    const drawn = rows(scene).filter(row => row.bounces.length);
    if (!drawn.length) return figure.remove();
    const longest = Math.min(64, Math.max(...drawn.map(row => row.bounces.length)));
    const width = 1120, height = 250, box = { left: 58, right: 1030, top: 30, bottom: 205 };
    const svg = canvas(figure, width, height, "paths and lanes alive at each bounce");
    const column = (box.right - box.left) / longest, y = v => box.bottom - v * (box.bottom - box.top);
    add(svg, "text", { class: "title", x: box.left, y: 14 }, "alive");
    for (const share of [0, 0.25, 0.5, 0.75, 1]) {
        add(svg, "line", { class: "grid", x1: box.left, x2: box.right, y1: y(share), y2: y(share) });
        add(svg, "text", { x: box.left - 8, y: y(share) + 4, "text-anchor": "end" }, 100 * share + " %");
    }
    const every = Math.ceil(longest / 24);
    for (let b = 0; b < longest; b += every)
        add(svg, "text", { x: box.left + (b + 0.5) * column, y: box.bottom + 18, "text-anchor": "middle" }, b);
    add(svg, "text", { x: box.right, y: box.bottom + 36, "text-anchor": "end" }, "bounce (0: from the camera)");
    const with_lanes = drawn.filter(row => row.bounces.some(b => b.lanes_share !== null));
    const bar = Math.min(44, 0.66 * column / Math.max(1, with_lanes.length));
    with_lanes.forEach((row, k) => row.bounces.slice(0, longest).forEach((bounce, b) => {
        if (bounce.lanes_share === null) return;
        const x = box.left + (b + 0.5) * column + (k - with_lanes.length / 2) * bar;
        add(add(svg, "rect", { class: `lane ${colour(row.i)}`, x: x + 1, y: y(bounce.lanes_share), width: Math.max(1, bar - 2),
                               height: box.bottom - y(bounce.lanes_share) }),
            "title", {}, `${row.name}, bounce ${b}: ${(100 * bounce.lanes_share).toFixed(1)} % of lanes at work`);
        if (bar > 30 && bounce.lanes_share > 0.15) add(svg, "text", { x: x + bar / 2, y: box.bottom - 7, "text-anchor": "middle" }, Math.round(100 * bounce.lanes_share));
    }));
    const labels = drawn.map(row => {
        const points = row.bounces.slice(0, longest).map((p, b) => [box.left + (b + 0.5) * column, y(p.paths_share)]);
        add(svg, "polyline", { class: `line stroke ${colour(row.i)}`, points: points.join(" ") });
        points.forEach(([px, py], b) => add(add(svg, "circle", { class: `fill ${colour(row.i)}`, cx: px, cy: py, r: 3.5 }),
            "title", {}, `${row.name}, bounce ${b}: ${(100 * row.bounces[b].paths_share).toFixed(1)} % of paths alive`));
        return { y: points[points.length - 1][1], c: colour(row.i), text: row.name };
    });
    for (const label of spread(labels, 16, box.top + 8, box.bottom))
        add(svg, "text", { class: `name ${label.c}`, x: box.right + 8, y: label.y + 4 }, label.text);
}

// Two bars a case: without compaction and with it, over the megakernel's time or the blocks without.
function plotRareCases(figure) {
    const quantity = figure.dataset.quantity, timed = quantity === "seconds", all = bench.rare_cases;
    const of_megakernel = timed && all.every(row => row.megakernel);
    const base = row => of_megakernel ? row.megakernel.seconds : row.without[quantity];
    const left = 122, right = 470, top = 46, step = 40, bar = 13, bottom = top + step * all.length;
    const svg = canvas(figure, 540, bottom + 22, `${quantity} of each rare case, without compaction and with it`);
    const high = Math.max(1, ...all.flatMap(row => [row.without, row.with].map(c => c[quantity] / base(row))));
    const x = v => left + v / high * (right - left);
    add(svg, "text", { class: "title", x: left, y: 14 }, timed ? "time of a sample" : "blocks a sample");
    add(svg, "text", { class: "name c0", x: right - 60, y: 14, "text-anchor": "end" }, "without compaction");
    add(svg, "text", { class: "name c1", x: right, y: 14, "text-anchor": "end" }, "with it");
    add(svg, "line", { class: "target", x1: x(1), x2: x(1), y1: top - 8, y2: bottom });
    all.forEach((row, k) => {
        const y = top + k * step;
        add(svg, "text", { class: "value", x: left - 10, y: y + bar + 4, "text-anchor": "end" }, row.case);
        [row.without, row.with].forEach((costs, j) => {
            const ratio = costs[quantity] / base(row), end = x(ratio);
            const figures = timed ? `${short(1e3 * costs.seconds)} ms` : `${short(costs.blocks)} blocks`;
            add(add(svg, "rect", { class: `fill c${j}`, x: left, y: y + j * (bar + 1), width: Math.max(1, end - left), height: bar, rx: 2 }),
                "title", {}, `${row.case}, ${j ? "with" : "without"} compaction: ${figures}`);
            add(svg, "text", { class: "over", x: end + 6, y: y + j * (bar + 1) + 11 }, ratio.toFixed(2));
        });
    });
    add(svg, "line", { class: "axis", x1: left, x2: left, y1: top - 8, y2: bottom });
    add(svg, "text", { x: x(1), y: bottom + 16, "text-anchor": "middle" }, of_megakernel ? "1 = megakernel" : "1 = without compaction");
}

const plots = { error: plotError, efficiency: plotEfficiency, bounces: plotBounces, rare_cases: plotRareCases };
for (const figure of document.querySelectorAll("figure.plot"))
    plots[figure.dataset.plot](figure, bench.scenes[Number(figure.dataset.scene)]);
document.body.dataset.ready = "true";
