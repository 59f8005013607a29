// Bars of passes, and lines against the number of lights, of `compare`.

/** One stacked bar for each variant. A pass has one colour in all of them. */
function showBars(runs) {
  const names = [...new Set(runs.flatMap((run) => run.passes.map((pass) => pass.name)))];
  drawLegend(names, names);
  document.getElementById("time-caption").textContent =
    "Device time of each pass, medians. Every architecture finds what is visible, lights it and maps the result to the display; they differ in " +
    "which pass does how much of it. Hover over a part for its figure, or see the tables below.";
  const bars = runs.map((run) => ({ name: nameOf(run.variant), total: run.gpu_ms.median,
    parts: run.passes.map((pass) => ({ name: pass.name, ms: pass.gpu_ms.median })) }));
  const draw = () => drawBars(document.getElementById("bars"), bars, names);
  for (const id of ["shares", "cut"]) document.getElementById(id).addEventListener("change", draw);
  draw();
}

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
  const counts = new Set(all.flatMap((line) => line.points.map((point) => point.lights)));
  if (counts.size < 2) {
    showNoCharts();
    return showCosts(all, report.steady_time);
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

/** One number of lights is a point, not a line. */
function showNoCharts() {
  document.getElementById("lines").hidden = true;
  document.querySelector("#lights .charts").hidden = true;
  document.getElementById("lights-caption").textContent = "One number of lights was timed: there is no line to draw.";
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
      }), element("td", {}, slopeText(line[slopeKeys[metric]], line[`${slopeKeys[metric]}_error`])), element("td", {}, percent(last.light_pass_share),
        last.light_pass_share === null ? null : element("span", { class: "detail" }, `at ${whole.format(last.lights)}`))));
  }
  document.getElementById("costs").replaceChildren(element("thead", {}, head), body);
}
