"use strict";
// What plots in SVG are made of. Colours are classes (c0 to c7), so that the style chooses them for light and for dark pages.
const bench = JSON.parse(document.getElementById("data").textContent);

function add(parent, tag, attributes = {}, text) {
    const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
    if (text !== undefined) node.textContent = text;
    parent.append(node);
    return node;
}

function canvas(figure, width, height, label) {
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-label", label);
    figure.prepend(svg);
    return svg;
}

const colour = i => "c" + i % 8;
const short = v => v === 0 ? "0" : Math.abs(v) >= 1e5 || Math.abs(v) < 1e-3 ? v.toExponential(0)
    : String(Number(v.toPrecision(3)));

// A logarithmic scale from [low, high] to [from, to], and its ticks: decades, and 2 and 5 where there is room.
function logScale(low, high, from, to) {
    const a = Math.log10(low), b = Math.log10(high);
    const scale = v => from + (Math.log10(v) - a) / (b - a) * (to - from);
    const steps = b - a > 3 ? [1] : [1, 2, 5], ticks = [];
    for (let e = Math.floor(a); e <= Math.ceil(b); e++)
        for (const s of steps) {
            const v = s * 10 ** e;
            if (v >= low * 0.999 && v <= high * 1.001) ticks.push(v);
        }
    return { scale, ticks, low, high };
}

// Moves labels apart so that they stand at least `gap` from each other.
function spread(labels, gap, low, high) {
    labels.sort((a, b) => a.y - b.y);
    for (let i = 1; i < labels.length; i++) labels[i].y = Math.max(labels[i].y, labels[i - 1].y + gap);
    const over = labels.length ? labels[labels.length - 1].y - high : 0;
    if (over > 0) for (const label of labels) label.y = Math.max(low, label.y - over);
    return labels;
}
