// The page of `prelight bench report`: one or several files of figures, side by side.

const counted = (count, word) => `${whole.format(count)} ${word}${count === 1 ? "" : "s"}`;
const spreadText = (spread) => `${figure(spread.min)} … ${figure(spread.max)}`;
const moved = (run) => run.passes.reduce((total, pass) => total + (pass.bytes_read ?? 0) + (pass.bytes_written ?? 0), 0);
const excess = ({ evaluated, contributing }) => (contributing > 0 ? evaluated / contributing : null);
const variantOf = (run) => run.variant ?? run.renderer + (run.preset ? `@preset=${run.preset}` : "");

/** Every run of every file, with its file, its figures of the limit, and a name of its own. */
function gather(files) {
  const names = {};
  return files.flatMap(({ file, bench }) => {
    names[file] = (names[file] ?? 0) + 1;
    const label = names[file] > 1 ? `${file} (${names[file]})` : file;
    return bench.runs.map((run) => {
      const limit = bench.limit?.figures.find((one) => one.variant === run.variant && one.lights === run.lights) ?? null;
      const variant = variantOf(run);
      return { ...run, variant, file: label, limit, line: files.length > 1 ? `${label}: ${plainName(variant)}` : plainName(variant) };
    });
  });
}

/** The name for a cell: the file stands below when there are several. */
function nameIn(run, several) {
  return element("span", {}, nameOf(run.variant), several ? element("span", { class: "detail" }, run.file) : null);
}

function showHeading(files, runs) {
  const ways = new Set(runs.map((run) => run.variant)).size, scenes = [...new Set(runs.map((run) => run.scene))];
  const headline = `${counted(ways, "way")} to light ${scenes.join(", ")}` + (files.length > 1 ? `, ${files.length} files side by side` : "");
  document.title = `${headline} · Prelight bench`;
  document.getElementById("headline").textContent = headline;
  const sizes = [...new Set(runs.map((run) => run.size.join("×")))], devices = [...new Set(runs.map((run) => run.device))];
  document.getElementById("facts").textContent =
    `${sizes.join(" and ")} pixels, on ${devices.join(" and ")}. ` +
    (devices.length > 1 ? "Times of different devices say nothing about each other; figures in F and counts do. " : "") +
    "All ways of a file were rendered in turn, so that what else the machine did met all alike.";
  document.getElementById("made").textContent = files.map(({ file, bench }) =>
    `${file}: ${counted(bench.runs.length, "run")}, ${bench.frames ?? bench.runs[0].frames} frames each, prelight ${bench.version ?? "?"}, ${bench.runs[0].driver ?? ""}`).join(". ") + ".";
}

function showHighlights(runs, metric) {
  const list = document.getElementById("highlights");
  const add = (what, number, who) => list.append(element("li", {}, element("div", { class: "what" }, what),
    element("div", { class: "figure" }, number), element("div", { class: "who" }, who)));
  const best = (of, value) => of.filter((run) => value(run) !== null && Number.isFinite(value(run))).sort((a, b) => value(a) - value(b))[0];
  const most = Math.max(...runs.map((run) => run.lights)), many = runs.filter((run) => run.lights === most);
  const fast = best(many, metric.value);
  if (fast) add(`Fastest frame with ${counted(most, "light")}`, metric.text(metric.value(fast)), fast.line);
  const near = best(many, (run) => run.limit?.light_over_limit ?? null);
  if (near) add("Light pass nearest to its limit", times(near.limit.light_over_limit), near.line);
  const spare = best(many, (run) => excess(run.light_pixel_pairs));
  if (spare) add("Fewest pairs for each that contributes", figure(excess(spare.light_pixel_pairs)), spare.line);
  const small = best(runs, (run) => run.attachment_bytes / (run.size[0] * run.size[1]));
  if (small) add("Smallest images", `${figure(small.attachment_bytes / (small.size[0] * small.size[1]))} bytes a pixel`, small.line);
}

/** What a frame's time can be shown as. */
function metricsOf(runs) {
  const spread = (key, unit) => ({ key, unit, value: (run) => run[key].median, low: (run) => run[key].min, high: (run) => run[key].max, text: milliseconds });
  const metrics = [{ label: "CPU time, ms", ...spread("cpu_ms") }, { label: "device time, ms", ...spread("gpu_ms") },
    { label: "wall time, ms", ...spread("wall_ms") }];
  if (runs.some((run) => run.limit)) {
    const scaled = (key) => (run) => (run.limit ? run[run.limit.frames_by][key] / run.limit.unit_ms : null);
    metrics.unshift({ label: "in F", value: (run) => run.limit?.frame_in_f ?? null, low: scaled("min"), high: scaled("max"), text: (value) => `${figure(value)} F` });
  }
  return metrics;
}

/** One line for each way and file: one colour for a way, one dash pattern for a file. */
function linesOf(runs) {
  const ways = [...new Set(runs.map((run) => run.variant))], files = [...new Set(runs.map((run) => run.file))];
  const lines = new Map();
  for (const run of runs) {
    const key = run.line;
    if (!lines.has(key))
      lines.set(key, { name: key, colour: colour(ways.indexOf(run.variant)), dash: dashes[files.indexOf(run.file) % dashes.length], runs: [] });
    lines.get(key).runs.push(run);
  }
  return [...lines.values()];
}

function showLines(lines, metrics) {
  if (new Set(lines.flatMap((line) => line.runs.map((run) => run.lights))).size < 2) { // a point, not a line
    for (const part of [document.getElementById("lines"), document.querySelector("#lights .charts")]) part.hidden = true;
    document.getElementById("lights-caption").textContent = "One number of lights was timed: there is no line to draw. The tables below have the figures.";
    return;
  }
  const select = document.getElementById("metric"), field = document.getElementById("lines");
  select.append(...metrics.map((metric, index) => element("option", { value: index }, metric.label)));
  const boxes = lines.map((line) => {
    const box = element("input", { type: "checkbox", checked: true });
    box.addEventListener("change", draw);
    field.append(element("label", {}, box, element("svg", { width: 30, height: 10, style: "width:30px", "aria-hidden": "true" },
      element("path", { class: "plot", d: "M1 5H29", stroke: line.colour, "stroke-dasharray": line.dash })), line.name));
    return box;
  });
  const pointsOf = (value, low, high) => lines.filter((_, index) => boxes[index].checked).map((line) => ({ ...line,
    points: line.runs.map((run) => [run.lights, value(run), low(run), high(run)]).filter((point) => point[1] !== null && point[1] > 0).sort((a, b) => a[0] - b[0]) }))
    .filter((line) => line.points.length);
  const place = (id, shown, text, label, nothing) => {
    const at = document.getElementById(id);
    if (!shown.length) return at.replaceChildren(element("p", { class: "facts" }, nothing));
    const values = shown.flatMap((line) => line.points.flatMap((point) => point.slice(1).filter((value) => value > 0)));
    const [low, high] = [Math.min(...values) / 1.15, Math.max(...values) * 1.15];
    drawChart(at, shown, { low, high, log: true, ticks: logTicks(low, high), text: (tick) => (tick < 1 ? String(Number(tick.toPrecision(2))) : whole.format(tick)), value: text, label });
  };
  function draw() {
    const metric = metrics[select.value];
    place("chart-time", pointsOf(metric.value, metric.low, metric.high), metric.text,
      `Time of a frame, ${metric.label}, against the number of lights; the table of all runs has the figures`, "No line is shown.");
    const ratio = (run) => excess(run.light_pixel_pairs);
    place("chart-pairs", pointsOf(ratio, ratio, ratio), figure, "Pairs evaluated for each that contributes, against the number of lights", "No pairs were counted.");
  }
  select.addEventListener("change", draw);
  new ResizeObserver(draw).observe(document.querySelector(".charts"));
}

/** Parts of a bar: each pass, and those that build lists, which are many and short, as one. */
function partsOf(run, of) {
  const parts = new Map();
  for (const pass of run.passes) {
    const name = pass.kind === "lists" ? "building lists" : pass.name;
    parts.set(name, (parts.get(name) ?? 0) + of(pass));
  }
  return [...parts].map(([name, ms]) => ({ name, ms }));
}

function showBars(runs, several) {
  const cpu = runs.every((run) => run.passes.every((pass) => pass.cpu_ms));
  const partsIn = (run) => partsOf(run, (pass) => (cpu ? pass.cpu_ms : pass.gpu_ms).median);
  const names = [...new Set(runs.flatMap((run) => partsIn(run).map((part) => part.name)))];
  const select = document.getElementById("count");
  const counts = [...new Set(runs.map((run) => run.lights))].sort((a, b) => a - b);
  select.append(...counts.map((count) => element("option", { value: count, selected: count === counts[counts.length - 1] }, whole.format(count))));
  document.getElementById("time-caption").textContent =
    `${cpu ? "CPU time of each pass, submitted alone" : "Device time of each pass"}; medians. Hover over a part for its figure, or see the tables below.`;
  const draw = () => {
    const bars = runs.filter((run) => String(run.lights) === select.value).map((run) => {
      const parts = partsIn(run);
      return { name: nameIn(run, several), parts, total: parts.reduce((total, part) => total + part.ms, 0) };
    });
    drawLegend(names.filter((name) => bars.some((bar) => bar.parts.some((part) => part.name === name))), names);
    drawBars(document.getElementById("bars"), bars, names);
  };
  select.addEventListener("change", draw);
  for (const id of ["shares", "cut"]) document.getElementById(id).addEventListener("change", draw);
  draw();
}

/** Rows of one table: `columns` are [label, value of a row as text or element]. */
function fillTable(table, first, rows, columns, nameOfRow) {
  const head = element("tr", {}, ...[first, ...columns.map((column) => column[0])].map((label) => element("th", { scope: "col" }, label)));
  table.replaceChildren(element("thead", {}, head), element("tbody", {}, ...rows.map((row) =>
    element("tr", {}, element("th", { scope: "row" }, nameOfRow(row)),
      ...columns.map(([label, value]) => element("td", { "data-label": label }, element("span", {}, value(row))))))));
}

const withDetail = (text, detail) => element("span", {}, text, detail ? element("span", { class: "detail" }, ` ${detail}`) : null);

function showLimits(files, runs, several) {
  const with_limit = runs.filter((run) => run.limit);
  if (!with_limit.length) {
    document.getElementById("limit").hidden = true;
    return;
  }
  const inF = (value) => (value === null || value === undefined ? "–" : `${figure(value)} F`);
  fillTable(document.getElementById("limits"), "Way to light", with_limit, [
    ["Lights", (run) => whole.format(run.lights)],
    ["F, ms", (run) => figure(run.limit.unit_ms)],
    ["Frame", (run) => inF(run.limit.frame_in_f)],
    ["Frame without lights", (run) => inF(run.limit.no_lights_in_f)],
    ["Geometry and material passes", (run) => inF(run.limit.geometry_in_f)],
    ["Light pass, ms", (run) => figure(run.limit.light_ms)],
    ["Perfect lists, ms", (run) => withDetail(figure(run.limit.perfect_ms), run.limit.perfect_tile ? `tiles of ${run.limit.perfect_tile}` : null)],
    ["Light pass ÷ limit", (run) => figure(run.limit.light_over_limit)],
    ["Lists ÷ light pass", (run) => (Number.isFinite(run.limit.lists_over_light) ? percent(run.limit.lists_over_light) : "–")],
  ], (run) => nameIn(run, several));
  const lines = new Set(files.flatMap(({ bench }) => bench.limit?.missing ?? []));
  document.getElementById("missing").append(...[...lines].map((line) => element("p", { class: "facts" }, `Not measured: ${line}`)));
}

function showChanges(files) {
  const made = files.filter(({ bench }) => bench.baseline?.runs?.some((run) => run.changes?.length));
  if (!made.length) {
    document.getElementById("changes").hidden = true;
    return;
  }
  document.getElementById("changes-caption").textContent =
    "A time has changed beyond noise when the medians are further apart than both runs' ways from fastest frame to median together. " +
    "Between two runs the machine may have changed too: figures in F feel that least.";
  for (const { file, bench } of made)
    for (const run of bench.baseline.runs) {
      const table = element("table", {});
      fillTable(table, "Figure", run.changes, [
        ["Before", (change) => figure(change.before)], ["After", (change) => figure(change.after)],
        ["Change", (change) => (change.before > 0 ? `${change.after >= change.before ? "+" : "−"}${figure(Math.abs(100 * (change.after / change.before - 1)))} %` : "–")],
        ["", (change) => change.verdict]], (change) => change.figure);
      document.getElementById("change-tables").append(element("details", {},
        element("summary", {}, `${plainName(run.variant)}, ${counted(run.lights, "light")}: ${file} against ${bench.baseline.file}`),
        element("div", {}, ...(run.settings_changed ?? []).map((line) => element("p", { class: "settings" }, line)), element("div", { class: "scroll" }, table))));
    }
}

function showSummary(runs, several) {
  const time = (key) => (run) => withDetail(figure(run[key].median), spreadText(run[key]));
  const columns = [["Lights", (run) => whole.format(run.lights)], ["CPU, ms", time("cpu_ms")], ["Wall, ms", time("wall_ms")], ["Device, ms", time("gpu_ms")],
    ["Pairs, millions", (run) => figure(run.light_pixel_pairs.evaluated / 1e6)], ["For each needed", (run) => figure(excess(run.light_pixel_pairs))],
    ["Draws", (run) => whole.format(run.draws ?? 0)], ["Attachments, bytes a pixel", (run) => figure(run.attachment_bytes / (run.size[0] * run.size[1]))],
    ["Moved, MB", (run) => figure(moved(run) / 1e6)], ["Device memory, MB", (run) => figure(run.device_bytes / 1e6)]];
  if (runs.some((run) => run.limit)) columns.splice(1, 0, ["F", (run) => figure(run.limit?.frame_in_f ?? null)]);
  fillTable(document.getElementById("summary"), "Way to light", runs, columns, (run) => nameIn(run, several));
}

function showPasses(runs) {
  document.getElementById("passes").append(...runs.map((run) => {
    const table = element("table", {});
    const time = (spread) => (spread ? withDetail(figure(spread.median), spreadText(spread)) : "–");
    fillTable(table, "Pass", run.passes, [["CPU, ms", (pass) => time(pass.cpu_ms)], ["Device, ms", (pass) => time(pass.gpu_ms)],
      ["Reads, MB", (pass) => figure((pass.bytes_read ?? 0) / 1e6)], ["Writes, MB", (pass) => figure((pass.bytes_written ?? 0) / 1e6)]], (pass) => pass.name);
    const settings = Object.entries(run.settings).map(([key, value]) => `${key}=${value}`).join(" ");
    return element("details", {}, element("summary", {}, `${run.line}, ${counted(run.lights, "light")}`),
      element("div", {}, element("div", { class: "scroll" }, table), element("p", { class: "settings" }, `Settings in force: ${settings}.`),
        ...(run.notes ?? []).map((note) => element("p", { class: "settings" }, `Note: ${note}`))));
  }));
}

{
  const files = JSON.parse(document.getElementById("data").textContent), runs = gather(files), several = files.length > 1;
  const metrics = metricsOf(runs);
  showHeading(files, runs);
  showHighlights(runs, metrics[0]);
  showLines(linesOf(runs), metrics);
  showBars(runs, several);
  showLimits(files, runs, several);
  showChanges(files);
  showSummary(runs, several);
  showPasses(runs);
}
