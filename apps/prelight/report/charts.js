// Bars of passes, and lines against the number of lights.

/** One stacked bar for each variant. A pass has one colour in all of them. */
function showBars(runs) {
  const names = [...new Set(runs.flatMap((run) => run.passes.map((pass) => pass.name)))];
  const place = document.getElementById("bars"), shares = document.getElementById("shares");
  document.getElementById("legend").append(...names.map((name, index) =>
    element("li", {}, element("span", { class: "swatch", style: `background:${colour(index)}` }), name)));
  document.getElementById("time-caption").textContent =
    "Device time of each pass, medians. Every architecture finds what is visible, lights it and maps the result to the display; they differ in " +
    "which pass does how much of it. Hover over a part for its figure, or see the tables below.";
  const draw = () => {
    place.replaceChildren();
    const totals = runs.map((run) => run.passes.reduce((total, pass) => total + pass.gpu_ms.median, 0));
    runs.forEach((run, index) => {
      const whole = (shares.checked ? totals[index] : Math.max(...totals)) || 1;
      const track = element("div", { class: "track", role: "img", "aria-label":
        run.passes.map((pass) => `${pass.name} ${milliseconds(pass.gpu_ms.median)}`).join(", ") });
      for (const pass of run.passes)
        track.append(element("div", { title: `${pass.name}: ${milliseconds(pass.gpu_ms.median)}, ${percent(pass.gpu_ms.median / (totals[index] || 1))}`,
          style: `width:${(pass.gpu_ms.median / whole) * 100}%;background:${colour(names.indexOf(pass.name))}` }));
      place.append(element("div", { class: "bar" }, element("div", { class: "name" }, nameOf(run.variant)), track,
        element("div", { class: "total" }, milliseconds(run.gpu_ms.median))));
    });
  };
  shares.addEventListener("change", draw);
  draw();
}

/** Powers of ten, with more between them the smaller the range is. */
function logTicks(low, high) {
  const decades = Math.log10(high / low), ticks = [];
  const steps = decades > 2.2 ? [1] : decades > 0.8 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power)
    for (const step of steps) {
      const tick = step * 10 ** power;
      if (tick >= low * 0.999 && tick <= high * 1.001) ticks.push(tick);
    }
  return ticks;
}

/**
 * Lines over a logarithmic axis of lights.
 * `lines`: [{name, colour, dash, points: [[lights, value], …]}]; `axis`: {low, high, log, ticks, text}.
 */
function drawChart(place, lines, axis) {
  const width = place.clientWidth, height = Math.min(360, Math.max(220, width * 0.6));
  const [left, right, top, bottom] = [46, 10, 10, 34];
  const counts = [...new Set(lines.flatMap((line) => line.points.map((point) => point[0])))].sort((a, b) => a - b);
  const low = Math.log(counts[0]), high = Math.log(counts[counts.length - 1]);
  const x = (lights) => left + (high > low ? (Math.log(lights) - low) / (high - low) : 0.5) * (width - left - right);
  const of = axis.log ? Math.log : (value) => value;
  const y = (value) => height - bottom - ((of(value) - of(axis.low)) / (of(axis.high) - of(axis.low) || 1)) * (height - top - bottom);
  const svg = element("svg", { viewBox: `0 0 ${width} ${height}`, height, role: "img", "aria-label": axis.label });
  for (const tick of axis.ticks)
    svg.append(element("line", { class: "grid", x1: left, x2: width - right, y1: y(tick), y2: y(tick) }),
      element("text", { x: left - 6, y: y(tick) + 4, "text-anchor": "end" }, axis.text(tick)));
  let free = -Infinity; // labels of neighbouring counts must not overlap
  for (const count of counts) {
    svg.append(element("line", { class: "grid", x1: x(count), x2: x(count), y1: height - bottom, y2: height - bottom + 4 }));
    const room = whole.format(count).length * 7 + 6;
    if (x(count) - room / 2 < free) continue;
    free = x(count) + room / 2;
    svg.append(element("text", { x: x(count), y: height - bottom + 17, "text-anchor": "middle" }, whole.format(count)));
  }
  svg.append(element("text", { x: (left + width - right) / 2, y: height - 2, "text-anchor": "middle" }, "lights"));
  for (const line of lines) {
    const path = line.points.map(([lights, value], index) => `${index ? "L" : "M"}${x(lights).toFixed(1)} ${y(value).toFixed(1)}`).join("");
    const group = element("g", { style: `color:${line.colour}` });
    group.append(element("path", { class: "plot", d: path, stroke: "currentColor", "stroke-dasharray": line.dash }));
    for (const [lights, value] of line.points)
      group.append(element("circle", { cx: x(lights), cy: y(value), r: 3.5, fill: "currentColor" },
        element("title", {}, `${line.name}, ${whole.format(lights)} lights: ${axis.value(value)}`)));
    svg.append(group);
  }
  place.replaceChildren(svg);
}

const dashes = [null, "6 3", "2 3", "9 3 2 3", "1 2", "12 4"];

/** One colour for each architecture, one dash pattern for each of its variants. */
function styleLines(series) {
  const architectures = [...new Set(series.map((line) => titleOf(line.variant).name))], used = {};
  return series.map((line) => {
    const { name } = titleOf(line.variant);
    used[name] = (used[name] ?? -1) + 1;
    return { ...line, colour: colour(architectures.indexOf(name)), dash: dashes[used[name] % dashes.length] };
  });
}

function showCharts(report) {
  const all = styleLines(report.light_counts.filter((line) => line.points.length > 0));
  if (!all.length) {
    document.getElementById("lights").hidden = true;
    return;
  }
  document.getElementById("lights-caption").textContent =
    "Both axes of the first chart are logarithmic: a line at 45° doubles with the lights, a flat one does not feel them. " +
    "Multi-pass grows with lights × geometry, a light buffer with the pixels that lights reach. " +
    `A variant is not timed further once a frame takes more than ${report.frame_limit} s.` +
    (report.steady_time === "cpu_ms" ? " On this software device CPU time is the steadier figure: other work on the machine lengthens device time." : "");
  const metric = document.getElementById("metric");
  metric.value = report.steady_time;
  metric.addEventListener("change", () => { draw(); showCosts(all, metric.value); });
  const field = document.getElementById("lines"), few = all.length <= 8;
  const boxes = all.map((line) => {
    const box = element("input", { type: "checkbox", checked: few || !line.variant.includes("@") });
    box.addEventListener("change", draw);
    field.append(element("label", {}, box, element("svg", { width: 30, height: 10, style: "width:30px", "aria-hidden": "true" },
      element("path", { class: "plot", d: "M1 5H29", stroke: line.colour, "stroke-dasharray": line.dash })), plainName(line.variant)));
    return box;
  });
  function draw() {
    const shown = all.filter((line, index) => boxes[index].checked);
    const lines = (value) => shown.map((line) => ({ ...line, name: plainName(line.variant),
      points: line.points.map((point) => [point.lights, value(point)]).filter((point) => point[1] !== null) })).filter((line) => line.points.length);
    drawOrSay("chart-time", lines((point) => Math.max(point[metric.value].median, 1e-6)), (values) => {
      const [low, high] = [Math.min(...values) / 1.15, Math.max(...values) * 1.15];
      return { low, high, log: true, ticks: logTicks(low, high), text: (tick) => (tick < 1 ? String(Number(tick.toPrecision(2))) : whole.format(tick)),
        value: milliseconds, label: "Time of a frame against the number of lights; the table below has the figures" };
    });
    drawOrSay("chart-share", lines((point) => point.light_pass_share), () => ({ low: 0, high: 1, ticks: [0, 0.25, 0.5, 0.75, 1],
      text: (tick) => `${tick * 100} %`, value: percent, label: "Share of the light passes against the number of lights" }));
  }
  function drawOrSay(id, lines, axisOf) {
    const place = document.getElementById(id);
    if (lines.length) drawChart(place, lines, axisOf(lines.flatMap((line) => line.points.map((point) => point[1]))));
    else place.replaceChildren(element("p", { class: "facts" }, "None of the lines has a pass for lights alone."));
  }
  new ResizeObserver(draw).observe(document.querySelector(".charts"));
  showCosts(all, metric.value);
}

/** The chart's figures, with what one light more costs. */
function showCosts(all, metric) {
  const counts = [...new Set(all.flatMap((line) => line.points.map((point) => point.lights)))].sort((a, b) => a - b);
  const head = element("tr", {}, element("th", { scope: "col" }, metric === "cpu_ms" ? "CPU time, ms" : "Device time, ms"),
    ...counts.map((count) => element("th", { scope: "col" }, `${whole.format(count)} ${count === 1 ? "light" : "lights"}`)),
    element("th", { scope: "col" }, "Each light, µs"), element("th", { scope: "col" }, "Share of light passes"));
  const body = element("tbody");
  for (const line of all) {
    const last = line.points[line.points.length - 1];
    body.append(element("tr", {}, element("th", { scope: "row" }, nameOf(line.variant),
      line.stopped ? element("span", { class: "detail" }, line.stopped) : null),
      ...counts.map((count) => {
        const point = line.points.find((known) => known.lights === count);
        return element("td", {}, point ? figure(point[metric].median) : "–");
      }), element("td", {}, figure(line[slopeKeys[metric]])), element("td", {}, percent(last.light_pass_share),
        last.light_pass_share === null ? null : element("span", { class: "detail" }, `at ${whole.format(last.lights)}`))));
  }
  document.getElementById("costs").replaceChildren(element("thead", {}, head), body);
}
