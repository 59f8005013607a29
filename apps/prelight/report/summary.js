// Headline, highlights and the table of all variants.

const sum = (passes, key) => passes.reduce((total, pass) => total + pass[key], 0);
const pairs = (run) => run.light_pixel_pairs.evaluated;

const timeNames = { gpu_ms: "device time", cpu_ms: "CPU time" };
const slopeKeys = { gpu_ms: "us_per_light", cpu_ms: "cpu_us_per_light" };
/** The time of a run by which this report compares. */
const steadyTime = (report) => (run) => run[report.steady_time].median;

/** Where the lowest (or highest) value is, among runs that have one. */
function bestOf(runs, value, highest = false) {
  let best = null;
  for (const run of runs) {
    const here = value(run);
    if (here === null || !Number.isFinite(here)) continue;
    if (best === null || (highest ? here > value(best) : here < value(best))) best = run;
  }
  return best;
}

function showHeading(report, runs) {
  const lights = `${whole.format(report.lights)} ${report.lights === 1 ? "light" : "lights"}`;
  const headline = `${runs.length} ${runs.length === 1 ? "way" : "ways"} to light ${report.scene} with ${lights}`;
  document.title = `${headline} · Prelight compare`;
  document.getElementById("headline").textContent = headline;
  document.getElementById("facts").textContent =
    `The same scene and camera “${report.camera}” in every row, lighting model ${report.shading} unless a preset has its own: ` +
    (report.time === null ? "" : `at ${figure(report.time)} s, `) + `${report.size.join("×")} pixels, ${whole.format(report.triangles)} triangles` +
    (report.lights_added ? `, ${whole.format(report.lights_added)} of the lights scattered at random` : "") +
    `. Rendered on ${report.device}, checked against a ray-cast reference.`;
  document.getElementById("made").textContent =
    `Made by prelight ${report.version} in ${Math.round(report.seconds)} s on ${report.device}, driver ${report.driver}; ` +
    `up to ${report.frames} frames of each variant, seed ${report.seed}. The same figures, and more, are in report.json beside this page.`;
}

function showHighlights(report, runs) {
  const list = document.getElementById("highlights");
  const add = (what, number, who) =>
    list.append(element("li", {}, element("div", { class: "what" }, what), element("div", { class: "figure" }, number),
      element("div", { class: "who" }, who)));
  const time = steadyTime(report);
  const fastest = bestOf(runs, time), slowest = bestOf(runs, time, true);
  add(`Fastest frame (${timeNames[report.steady_time]})`, milliseconds(time(fastest)),
    runs.length > 1 ? `${plainName(fastest.variant)}; the slowest takes ${times(time(slowest) / time(fastest))} as long` : plainName(fastest.variant));
  const slope = (series) => series[slopeKeys[report.steady_time]];
  const error = (series) => series[`${slopeKeys[report.steady_time]}_error`] ?? 0;
  const known = report.light_counts.filter((series) => slope(series) !== null);
  const slopes = known.filter((series) => isMeasured(slope(series), error(series)));
  // One whose slope is lost in noise may be the cheapest: then nobody is.
  if (slopes.length && slopes.length === known.length) {
    const cheap = bestOf(slopes, slope), dear = bestOf(slopes, slope, true);
    const rivals = slopes.filter((series) => series !== cheap && slope(series) - 2 * error(series) <= slope(cheap) + 2 * error(cheap));
    add("Cheapest extra light", `${slopeText(slope(cheap), error(cheap))} µs`, rivals.length
      ? `${plainName(cheap.variant)}; ${rivals.map((series) => plainName(series.variant)).join(", ")} may be as cheap`
      : slopes.length > 1 ? `${plainName(cheap.variant)}; the dearest costs ${times(slope(dear) / slope(cheap))} as much` : plainName(cheap.variant));
  } else if (known.length)
    add("Cheapest extra light", "not measurable", `${known.length - slopes.length} of ${known.length} slopes are lost in noise`);
  const bytes = (run) => run.attachment_bytes_per_pixel.shared, least = bytes(bestOf(runs, bytes));
  const small = [...new Set(runs.filter((run) => bytes(run) === least).map((run) => titleOf(run.variant).name))];
  add("Smallest images", `${figure(least)} bytes a pixel`, small.join(", "));
  const near = bestOf(runs, (run) => run.difference.flip);
  add("Nearest to its reference", `FLIP ${near.difference.flip.toFixed(4)}`, plainName(near.variant));
}

/** Label, text, the value that decides which row is best, and whether the highest is. */
function summaryColumns(steady, fastest) {
  const first = steady, second = steady === "gpu_ms" ? "cpu_ms" : "gpu_ms";
  const label = { gpu_ms: "Device time, ms", cpu_ms: "CPU time, ms" };
  return [
    { label: label[first], value: (run) => run[first].median, text: figure, bar: true },
    { label: "Against the fastest", text: (value) => times(value), value: (run) => run[steady].median / fastest, plain: true },
    { label: label[second], value: (run) => run[second].median, text: figure },
    { label: "Draws", value: (run) => run.draws, text: whole.format },
    { label: "Attachments, bytes a pixel", value: (run) => run.attachment_bytes_per_pixel.shared, text: figure,
      detail: (run) => `${figure(run.attachment_bytes_per_pixel.unshared)} one by one` },
    { label: "Read + written, MB", value: (run) => (sum(run.passes, "bytes_read") + sum(run.passes, "bytes_written")) / 1e6, text: figure },
    { label: "Pairs, millions", value: (run) => pairs(run) / 1e6, text: figure,
      detail: (run) => (pairs(run) ? `${percent(run.light_pixel_pairs.contributing / pairs(run))} contribute` : null) },
    { label: "PSNR, dB", value: (run) => run.difference.psnr ?? Infinity, text: (value) => (value === Infinity ? "∞" : value.toFixed(1)), highest: true },
    { label: "FLIP", value: (run) => run.difference.flip, text: (value) => value.toFixed(4) },
  ];
}

function showSummary(report, runs) {
  const all = runs.map(steadyTime(report)), slowest = Math.max(...all);
  const columns = summaryColumns(report.steady_time, Math.min(...all));
  const head = element("tr", {}, element("th", { scope: "col" }, "Way to light"),
    ...columns.map((column) => element("th", { scope: "col" }, column.label)));
  const body = element("tbody");
  for (const run of report.runs) {
    const row = element("tr", {}, element("th", { scope: "row", title: run.description }, nameOf(run.variant)));
    if (run.error !== null) {
      row.append(element("td", { class: "failed", colspan: columns.length }, `Not rendered: ${run.error}`));
      body.append(row);
      continue;
    }
    for (const column of columns) {
      const value = column.value(run);
      const best = !column.plain && runs.length > 1 && value === (column.highest ? Math.max : Math.min)(...runs.map(column.value));
      const detail = column.detail ? column.detail(run) : null;
      const cell = element("td", { "data-label": column.label, class: best ? "best" : null }, element("span", {}, column.text(value),
        detail ? element("span", { class: "detail" }, ` ${detail}`) : null));
      if (column.bar) cell.append(element("span", { class: "minibar", style: `width:${Math.max(1, (value / slowest) * 100)}%` }));
      row.append(cell);
    }
    body.append(row);
  }
  document.getElementById("summary").append(
    element("caption", { hidden: true }, "Figures of every variant"), element("thead", {}, head), body);
}

/** Every pass of every variant with its time and bytes. */
function showPasses(runs) {
  const place = document.getElementById("passes");
  runs.forEach((run, index) => {
    const total = sum(run.passes.map((pass) => ({ ms: pass.gpu_ms.median })), "ms");
    const rows = run.passes.map((pass) => element("tr", {}, element("th", { scope: "row" }, pass.name),
      element("td", {}, figure(pass.gpu_ms.median)), element("td", {}, total > 0 ? percent(pass.gpu_ms.median / total) : "–"),
      element("td", {}, figure(pass.bytes_read / 1e6)), element("td", {}, figure(pass.bytes_written / 1e6))));
    rows.push(element("tr", {}, element("th", { scope: "row" }, "all"), element("td", {}, figure(total)), element("td", {}, ""),
      element("td", {}, figure(sum(run.passes, "bytes_read") / 1e6)), element("td", {}, figure(sum(run.passes, "bytes_written") / 1e6))));
    const settings = Object.entries(run.settings).map(([key, value]) => `${key}=${value}`).join(" ");
    place.append(element("details", { open: index === 0 },
      element("summary", {}, plainName(run.variant)),
      element("div", {}, element("p", {}, `${run.description[0].toUpperCase()}${run.description.slice(1)}.`),
        element("div", { class: "scroll" }, element("table", {},
          element("thead", {}, element("tr", {}, ...["Pass", "Device time, ms", "Share", "Reads, MB", "Writes, MB"].map(
            (label) => element("th", { scope: "col" }, label)))), element("tbody", {}, ...rows))),
        element("p", { class: "settings" }, `Settings in force: ${settings}. Reference form: ${run.reference_form}. ` +
          `${(run.difference.off_share * 100).toFixed(3)} % of the pixels are off by more than 2/255, the worst 16×16 block by ` +
          `${run.difference.block.toFixed(2)}/255; ${percent(run.difference.left_out_share)} lie beside edges and are left out of these two and of PSNR.`),
        ...run.notes.map((note) => element("p", { class: "settings" }, `Note: ${note}`)))));
  });
}
