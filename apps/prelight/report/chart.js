// A chart of lines over the number of lights.

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
 * `lines`: [{name, colour, dash, points: [[lights, value, low, high], …]}], low and high as the ends of a bar or
 * absent; `axis`: {low, high, log, ticks, text}.
 */
function drawChart(place, lines, axis) {
  const width = place.clientWidth, height = Math.min(360, Math.max(220, width * 0.6));
  const [left, right, top, bottom] = [46, 10, 10, 34];
  const counts = [...new Set(lines.flatMap((line) => line.points.map((point) => point[0])))].sort((a, b) => a - b);
  const first = Math.log(Math.max(counts[0], 1)), last = Math.log(Math.max(counts[counts.length - 1], 1));
  const x = (lights) => left + (last > first ? (Math.log(Math.max(lights, 1)) - first) / (last - first) : 0.5) * (width - left - right);
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
    for (const [lights, value, low, high] of line.points) {
      if (high > low) group.append(element("line", { x1: x(lights), x2: x(lights), y1: y(low), y2: y(high), stroke: "currentColor", opacity: 0.55 }));
      group.append(element("circle", { cx: x(lights), cy: y(value), r: 3.5, fill: "currentColor" },
        element("title", {}, `${line.name}, ${whole.format(lights)} lights: ${axis.value(value)}`)));
    }
    svg.append(group);
  }
  place.replaceChildren(svg);
}

/** Patterns of lines. */
const dashes = [null, "6 3", "2 3", "9 3 2 3", "1 2", "12 4"];
