// Stacked bars: one for each way to light, a pass in the same colour in all of them.

/**
 * `bars`: [{name, parts: [{name, ms}], total}], `names` of all parts in the order of their colours. Two boxes choose
 * the scale: #shares stretches each bar to full width; #cut lets the longest run out of the page, so that the
 * short ones can be read beside them.
 */
function drawBars(place, bars, names) {
  const shares = document.getElementById("shares"), cut = document.getElementById("cut");
  const totals = bars.map((bar) => bar.parts.reduce((total, part) => total + part.ms, 0));
  const longest = Math.max(...totals), shortest = Math.min(...totals);
  const near = Math.max(...totals.filter((total) => total <= 4 * shortest));
  const slivers = bars.length > 1 && longest > 1.5 * near;
  cut.closest("label").hidden = !slivers;
  document.getElementById("cut-at").textContent = milliseconds(near);
  const end = slivers && cut.checked && !shares.checked ? near : longest;
  place.replaceChildren(...bars.map((bar, index) => {
    const full = (shares.checked ? totals[index] : end) || 1, over = !shares.checked && totals[index] > end * 1.0001;
    const track = element("div", { class: over ? "track over" : "track", role: "img",
      "aria-label": bar.parts.map((part) => `${part.name} ${milliseconds(part.ms)}`).join(", ") + (over ? `; cut off at ${milliseconds(end)}` : "") },
      ...bar.parts.map((part) => element("div", { title: `${part.name}: ${milliseconds(part.ms)}, ${percent(part.ms / (totals[index] || 1))}`,
        style: `width:${(part.ms / full) * 100}%;${fill(names.indexOf(part.name))}` })));
    return element("div", { class: "bar" }, element("div", { class: "name" }, bar.name), track,
      element("div", { class: "total" }, milliseconds(bar.total)));
  }));
}

function drawLegend(names, all) {
  document.getElementById("legend").replaceChildren(...names.map((name) =>
    element("li", {}, element("span", { class: "swatch", style: fill(all.indexOf(name)) }), name)));
}
