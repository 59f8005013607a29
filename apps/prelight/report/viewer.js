// Two pictures over each other: which, where the divider is, how far zoomed.

class Viewer {
  constructor(report, runs) {
    this.views = report.views;
    [this.width, this.height] = report.size;
    this.choices = [{ variant: "reference", pictures: report.reference.pictures, about: `Rays cast with Embree, ${milliseconds(report.reference.wall_ms)} for its picture.` },
      ...runs.map((run) => ({ variant: run.variant, pictures: run.pictures,
        about: `${milliseconds(steadyTime(report)(run))} ${timeNames[report.steady_time]} a frame · PSNR ${decibels(run.difference.psnr)} dB · FLIP ${run.difference.flip.toFixed(4)}` }))];
    this.sides = {
      left: { choice: this.choices[Math.min(1, this.choices.length - 1)], view: "final" },
      right: { choice: this.choices[0], view: "final" },
    };
    this.split = 50;
    this.scale = 0; // 0: fit
    this.centre = [this.width / 2, this.height / 2];
    this.stage = document.getElementById("stage");
    this.slider = document.getElementById("split");
    this.fillControls();
    this.listen();
    new ResizeObserver(() => this.place()).observe(this.stage);
    this.stage.style.aspectRatio = `${this.width} / ${this.height}`;
    this.show();
  }

  fillControls() {
    for (const side of ["left", "right"]) {
      const select = document.getElementById(side), view = document.getElementById(`${side}-view`);
      this.choices.forEach((choice, index) => select.append(element("option", { value: index }, plainName(choice.variant))));
      for (const known of this.views) view.append(element("option", { value: known.name }, known.label));
      select.addEventListener("change", () => { this.sides[side].choice = this.choices[Number(select.value)]; this.show(); });
      view.addEventListener("change", () => { this.sides[side].view = view.value; this.show(); });
    }
    const field = document.getElementById("views");
    for (const view of this.views) {
      const radio = element("input", { type: "radio", name: "view", value: view.name });
      radio.addEventListener("change", () => this.showView(view.name));
      field.append(element("label", {}, radio, element("span", {}, view.key ? element("kbd", {}, view.key) : null, view.label)));
    }
  }

  listen() {
    this.slider.addEventListener("input", () => { this.split = Number(this.slider.value); this.place(); });
    document.getElementById("zoom-in").addEventListener("click", () => this.zoomBy(1));
    document.getElementById("zoom-out").addEventListener("click", () => this.zoomBy(-1));
    document.getElementById("zoom-fit").addEventListener("click", () => this.zoomTo(0));
    document.addEventListener("keydown", (event) => this.onKey(event));
    this.stage.addEventListener("keydown", (event) => this.onArrow(event));
    this.stage.addEventListener("dblclick", (event) => this.zoomBy(1, this.pictureAt(event)));
    this.stage.addEventListener("pointerdown", (event) => this.onPress(event));
    this.stage.addEventListener("pointermove", (event) => this.onDrag(event));
    for (const end of ["pointerup", "pointercancel"])
      this.stage.addEventListener(end, () => { this.drag = null; this.stage.classList.remove("moving"); });
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("select, textarea")) return;
    const view = this.views.find((known) => known.key === event.key);
    if (view) this.showView(view.name);
    else if (event.key === "+" || event.key === "=") this.zoomBy(1);
    else if (event.key === "-") this.zoomBy(-1);
    else if (event.key === "f" || event.key === "F") this.zoomTo(0);
    else return;
    event.preventDefault();
  }

  onArrow(event) {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!way) return;
    if (this.scale === 0) {
      if (way[0] === 0) return; // the page scrolls
      this.moveSplit(this.split + way[0] * (event.shiftKey ? 10 : 1));
    } else {
      const step = (event.shiftKey ? 200 : 40) / this.pixelSize();
      this.centre = this.centre.map((value, axis) => value + way[axis] * step);
      this.place();
    }
    event.preventDefault();
  }

  onPress(event) {
    if (event.button !== 0) return;
    const panning = this.scale !== 0 && event.target.id !== "handle";
    this.drag = { panning, x: event.clientX, y: event.clientY };
    this.stage.setPointerCapture(event.pointerId);
    this.stage.classList.toggle("moving", panning);
    if (!panning) this.splitAt(event);
  }

  onDrag(event) {
    if (!this.drag) return;
    if (!this.drag.panning) return this.splitAt(event);
    const size = this.pixelSize();
    this.centre = [this.centre[0] - (event.clientX - this.drag.x) / size, this.centre[1] - (event.clientY - this.drag.y) / size];
    this.drag.x = event.clientX;
    this.drag.y = event.clientY;
    this.place();
  }

  splitAt(event) {
    const box = this.stage.getBoundingClientRect();
    this.moveSplit(((event.clientX - box.left) / box.width) * 100);
  }

  moveSplit(percentage) {
    this.split = Math.min(100, Math.max(0, percentage));
    this.slider.value = this.split;
    this.place();
  }

  showView(name) {
    this.sides.left.view = this.sides.right.view = name;
    this.show();
  }

  fitSize() { return this.stage.clientWidth / this.width; }
  /** CSS pixels that one pixel of the picture takes. */
  pixelSize() { return this.scale || this.fitSize(); }
  levels() { return [0, ...[1, 2, 4, 8, 16, 32].filter((level) => level > this.fitSize() * 1.05)]; }

  pictureAt(event) {
    const box = this.stage.getBoundingClientRect(), size = this.pixelSize();
    return [this.centre[0] + (event.clientX - box.left - box.width / 2) / size,
      this.centre[1] + (event.clientY - box.top - box.height / 2) / size];
  }

  zoomBy(steps, centre = this.centre) {
    const levels = this.levels();
    const index = Math.min(levels.length - 1, Math.max(0, levels.indexOf(this.scale) + steps));
    this.zoomTo(levels[index], centre);
  }

  zoomTo(scale, centre = this.centre) {
    this.scale = scale;
    this.centre = centre;
    this.place();
  }

  /** Puts both pictures and the divider where they belong. */
  place() {
    const size = this.pixelSize(), levels = this.levels();
    const visible = [this.stage.clientWidth / size, this.stage.clientHeight / size];
    this.centre = this.centre.map((value, axis) => {
      const whole = axis === 0 ? this.width : this.height;
      return visible[axis] >= whole ? whole / 2 : Math.min(whole - visible[axis] / 2, Math.max(visible[axis] / 2, value));
    });
    const left = this.stage.clientWidth / 2 - this.centre[0] * size, top = this.stage.clientHeight / 2 - this.centre[1] * size;
    for (const image of this.stage.querySelectorAll("img")) {
      image.style.transform = `translate(${left}px, ${top}px) scale(${size})`;
      image.classList.toggle("sharp", size >= 1.5);
    }
    this.stage.style.setProperty("--split", `${this.split}%`);
    this.stage.classList.toggle("zoomed", this.scale !== 0);
    this.slider.setAttribute("aria-valuetext", `left ${Math.round(this.split)} %`);
    document.getElementById("zoom").textContent = this.scale ? `${this.scale * 100} %` : "fit";
    document.getElementById("zoom-out").disabled = this.scale === 0;
    document.getElementById("zoom-in").disabled = this.scale === levels[levels.length - 1];
  }

  show() {
    const about = document.getElementById("about");
    about.replaceChildren();
    for (const [name, side] of Object.entries(this.sides)) {
      const { choice, view } = side, label = this.views.find((known) => known.name === view).label;
      const layer = document.getElementById(`layer-${name}`), image = layer.querySelector("img"), missing = layer.querySelector("p");
      const file = choice.pictures[view];
      image.hidden = !file;
      missing.hidden = Boolean(file);
      if (file) {
        image.width = this.width;
        image.height = this.height;
        if (image.getAttribute("src") !== file) image.src = file;
        image.alt = `${plainName(choice.variant)}: ${label}`;
      } else {
        image.removeAttribute("src");
        missing.textContent = view === "difference" ? "The reference is what the others differ from."
          : `${titleOf(choice.variant).name} has no such buffer: ${label.toLowerCase()}.`;
      }
      document.getElementById(`tag-${name}`).textContent = `${plainName(choice.variant)} · ${label}`;
      document.getElementById(name).value = this.choices.indexOf(choice);
      document.getElementById(`${name}-view`).value = view;
      about.append(element("dt", {}, plainName(choice.variant)), element("dd", {}, choice.about));
    }
    const { left, right } = this.sides;
    for (const radio of document.querySelectorAll("#views input"))
      radio.checked = left.view === right.view && radio.value === left.view;
    document.getElementById("scale").hidden = left.view !== "difference" && right.view !== "difference";
    this.place();
  }
}
