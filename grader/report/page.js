"use strict";
// Draws the pictures: decodes radiance, exposes it, and shows render, reference, difference and z-map.
// The view that was touched last is in the address: #at=ENTRY&mode=MODE&ev=STOPS&split=0..1
const data = JSON.parse(document.getElementById("data").textContent);
const decoded = new Map();

// Promise of a Float32Array of R, G, B from a picture of mantissas and exponents, side by side.
function radiance(id) {
    if (!decoded.has(id)) decoded.set(id, new Promise((done, failed) => {
        const png = new Image();
        png.onerror = failed;
        png.onload = () => {
            const canvas = document.createElement("canvas");
            const width = png.width / 2, height = png.height;
            canvas.width = png.width;
            canvas.height = height;
            const context = canvas.getContext("2d", { willReadFrequently: true });
            context.drawImage(png, 0, 0);
            const bytes = context.getImageData(0, 0, png.width, height).data;
            const values = new Float32Array(3 * width * height);
            for (let y = 0; y < height; y++)
                for (let x = 0; x < width; x++) {
                    const from = 4 * (y * png.width + x), to = 3 * (y * width + x);
                    const exponent = bytes[from + 4 * width];
                    const scale = exponent === 255 ? NaN : 2 ** (exponent - 136);
                    // + 0.5: the middle of the values that this mantissa stands for.
                    for (let c = 0; c < 3; c++)
                        values[to + c] = exponent <= 1 ? 0 : (bytes[from + c] + 0.5) * scale;
                }
            done(values);
        };
        png.src = data.pictures[id];
    }));
    return decoded.get(id);
}

const srgb = v => 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
const exposed = (values, i, gain) => isNaN(values[3 * i]) ? [255, 0, 255]
    : [0, 1, 2].map(c => srgb(Math.min(1, values[3 * i + c] * gain)));
const luminance = (values, i) =>
    0.2126 * values[3 * i] + 0.7152 * values[3 * i + 1] + 0.0722 * values[3 * i + 2];

// -1 blue, 0 near white, +1 red.
function diverging(t) {
    if (isNaN(t)) return [255, 0, 255];
    const s = Math.min(1, Math.abs(t)), end = t > 0 ? [178, 24, 43] : [33, 102, 172];
    return end.map(c => 247 + s * (c - 247));
}

class Viewer {
    constructor(article, view) {
        this.name = article.id;
        this.view = view;
        this.article = article;
        this.stage = article.querySelector(".stage");
        this.slider = article.querySelector(".exposure input");
        this.mode = view.reference ? "slider" : "rendered";
        this.ev = 0;
        this.split = 0.5;
        this.buttons = [...article.querySelectorAll("button[data-mode]")];
        for (const button of this.buttons)
            button.addEventListener("click", () => this.change({ mode: button.dataset.mode }));
        this.slider.addEventListener("input", () => this.change({ ev: Number(this.slider.value) }));
        this.stage.addEventListener("pointermove", event => this.point(event));
        this.stage.addEventListener("pointerdown", event => {
            this.stage.setPointerCapture(event.pointerId);
            this.point(event, true);
        });
        this.stage.addEventListener("keydown", event => {
            const step = { ArrowLeft: -0.02, ArrowRight: 0.02 }[event.key];
            if (!step || this.mode !== "slider") return;
            event.preventDefault();
            this.change({ split: Math.min(1, Math.max(0, this.split + step)) });
        });
    }

    async load() {
        if (this.loaded) return this.loaded;
        return this.loaded = (async () => {
            this.image = await radiance(this.view.image);
            this.reference = this.view.reference ? await radiance(this.view.reference) : null;
            let sum = 0;
            const n = this.view.width * this.view.height;
            if (this.reference) for (let i = 0; i < n; i++) sum += luminance(this.reference, i);
            this.mean = sum / n;
            this.draw();
            this.article.dataset.ready = "true";
        })();
    }

    change(changes) {
        Object.assign(this, changes);
        this.draw();
        const state = new URLSearchParams({ at: this.name, mode: this.mode, ev: this.ev, split: this.split.toFixed(2) });
        history.replaceState(null, "", "#" + state);
    }

    // Colour of pixel i in a mode, 0 to 255.
    colour(mode, i, gain) {
        const x = i % this.view.width, y = Math.floor(i / this.view.width);
        switch (mode) {
        case "reference": return exposed(this.reference, i, gain);
        case "difference":
            return diverging((luminance(this.image, i) - luminance(this.reference, i)) / (this.view.range * this.mean));
        case "z": return diverging(this.z(x, y) / 6);
        case "slider":
            return exposed(x < this.split * this.view.width ? this.image : this.reference, i, gain);
        default: return exposed(this.image, i, gain);
        }
    }

    z(x, y) {
        const { z, z_columns, z_tile } = this.view;
        const value = z[Math.floor(y / z_tile) * z_columns + Math.floor(x / z_tile)];
        return value === null ? NaN : value;
    }

    paint(canvas, mode) {
        const { width, height } = this.view;
        canvas.width = width;
        canvas.height = height;
        const context = canvas.getContext("2d"), picture = context.createImageData(width, height);
        for (let i = 0; i < width * height; i++) {
            const colour = this.colour(mode, i, 2 ** this.ev);
            picture.data.set(colour, 4 * i);
            picture.data[4 * i + 3] = 255;
        }
        context.putImageData(picture, 0, 0);
        if (mode !== "slider") return;
        context.fillStyle = "#fff";
        context.fillRect(Math.round(this.split * width), 0, 1, height);
    }

    draw() {
        if (!this.image) return;
        this.paint(this.stage, this.mode);
        this.stage.classList.toggle("split", this.mode === "slider");
        for (const button of this.buttons) {
            button.setAttribute("aria-pressed", button.dataset.mode === this.mode);
            this.paint(button.firstElementChild, button.dataset.mode);
        }
        this.slider.value = this.ev;
        this.article.querySelector(".exposure output").textContent =
            (this.ev > 0 ? "+" : "") + this.ev + " stops";
        this.article.querySelector(".viewer figcaption").textContent = this.view.captions[this.mode];
    }

    // The pixel under the pointer: its radiance on both sides; a press moves the slider.
    point(event, pressed = event.buttons === 1) {
        if (!this.image) return;
        const box = this.stage.getBoundingClientRect();
        const u = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
        const v = Math.min(1, Math.max(0, (event.clientY - box.top) / box.height));
        if (pressed && this.mode === "slider") this.change({ split: u });
        const { width, height } = this.view;
        const x = Math.min(width - 1, Math.floor(u * width)), y = Math.min(height - 1, Math.floor(v * height));
        const show = values => [0, 1, 2].map(c => values[3 * (y * width + x) + c].toPrecision(3).padStart(9)).join("");
        let text = `(${x}, ${y})`.padEnd(12) + "rendered " + show(this.image);
        if (this.reference)
            text += "\n" + "".padEnd(12) + "reference" + show(this.reference) + `   tile z ${this.z(x, y).toFixed(1)}`;
        this.article.querySelector(".readout").textContent = text;
    }
}

const viewers = new Map();
for (const article of document.querySelectorAll("article"))
    if (article.querySelector(".viewer")) viewers.set(article.id, new Viewer(article, data.views[article.id]));

// A picture is decoded when it comes near the window.
const watch = new IntersectionObserver(seen => {
    for (const entry of seen) if (entry.isIntersecting) viewers.get(entry.target.id).load();
}, { rootMargin: "600px" });
for (const viewer of viewers.values()) watch.observe(viewer.article);

async function follow() {
    const state = new URLSearchParams(location.hash.slice(1)), name = state.get("at");
    const article = name && document.getElementById(name);
    if (!article) return;
    article.scrollIntoView();
    const viewer = viewers.get(name);
    if (!viewer) return;
    await viewer.load();
    const number = (key, low, high, otherwise) => {
        const value = Number(state.get(key));
        return state.has(key) && value >= low && value <= high ? value : otherwise;
    };
    if (state.get("mode") in viewer.view.captions) viewer.mode = state.get("mode");
    viewer.ev = number("ev", -8, 8, viewer.ev);
    viewer.split = number("split", 0, 1, viewer.split);
    viewer.draw();
    article.scrollIntoView();
}
addEventListener("hashchange", follow);
follow();
